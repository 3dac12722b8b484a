//! Macro definitions in the notes: `\newcommand`, `\def`, `\let` and similar commands.

use super::tex_scanner;
use crate::source::Span;

/// A command that the notes define.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MacroDefinition {
    /// Its name, with the backslash.
    pub name: String,
    /// How many arguments it takes.
    pub arguments: usize,
    /// How it takes its arguments, and what its body is.
    pub form: Form,
    /// The body.
    pub body: String,
    /// The whole definition.
    pub span: Span,
}

/// How a command takes its arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Form {
    /// One token or one group for each.
    Plain,
    /// As [`Form::Plain`], but the first is optional and has this default.
    Optional(String),
    /// As the parameter text of `\def` says: `(#1,#2)`.
    Pattern(String),
    /// As the argument types of `\NewDocumentCommand` say: `O{x} m`.
    Types(String),
    /// A pair of delimiters around one argument.
    Pair(String, String),
    /// Another name for a command, which is the body.
    Alias,
}

/// All definitions in `text`, in order; `\providecommand` defines nothing that is defined before.
pub fn definitions(text: &str) -> Vec<MacroDefinition> {
    let bytes = text.as_bytes();
    let (mut found, mut i) = (Vec::<MacroDefinition>::new(), 0);
    while let Some(at) = tex_scanner::find(text, i, "\\") {
        let word = tex_scanner::word_end(bytes, at);
        if word == at + 1 {
            // An escaped character.
            i = at + 2;
            while !text.is_char_boundary(i) && i < text.len() {
                i += 1;
            }
            continue;
        }
        i = word;
        if let Some(definition) = definition(text, at) {
            i = definition.span.end;
            let provides = text[at + 1..].starts_with("provide") || text[at + 1..].starts_with("Provide");
            let is_known = |other: &MacroDefinition| other.name == definition.name;
            if !(provides && found.iter().any(is_known)) {
                found.push(definition);
            }
        }
    }
    found
}

/// The definition that starts with the backslash at `at`.
pub(super) fn definition(text: &str, at: usize) -> Option<MacroDefinition> {
    let bytes = text.as_bytes();
    let word = tex_scanner::word_end(bytes, at);
    match &text[at + 1..word] {
        "newcommand" | "renewcommand" | "providecommand" | "DeclareRobustCommand" => newcommand(text, at, word),
        "NewDocumentCommand" | "RenewDocumentCommand" | "ProvideDocumentCommand" | "DeclareDocumentCommand" => {
            document_command(text, at, word)
        }
        "def" | "gdef" | "edef" => def(text, at, word),
        "let" => alias(text, at, word),
        "DeclareMathOperator" => operator(text, at, word),
        "DeclarePairedDelimiter" => pair(text, at, word),
        _ => None,
    }
}

/// `\name` or `{\name}` at `at`: the name with its backslash, and the position after.
fn name(text: &str, at: usize) -> Option<(String, usize)> {
    let bytes = text.as_bytes();
    let at = tex_scanner::skip_space(bytes, at);
    let braced = bytes.get(at) == Some(&b'{');
    let start = if braced { tex_scanner::skip_space(bytes, at + 1) } else { at };
    if bytes.get(start) != Some(&b'\\') {
        return None;
    }
    let mut end = tex_scanner::word_end(bytes, start);
    if end == start + 1 {
        end += text[end..].chars().next()?.len_utf8();
    }
    let name = text[start..end].to_owned();
    if braced {
        end = tex_scanner::skip_space(bytes, end);
        if bytes.get(end) != Some(&b'}') {
            return None;
        }
        end += 1;
    }
    Some((name, end))
}

fn newcommand(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let bytes = text.as_bytes();
    let star = usize::from(bytes.get(word) == Some(&b'*'));
    let (name, mut end) = name(text, word + star)?;
    let mut arguments = 0;
    let mut form = Form::Plain;
    end = tex_scanner::skip_space(bytes, end);
    if let Some((count, after)) = bracketed(text, end) {
        arguments = count.trim().parse().ok().filter(|&n: &usize| n <= 9)?;
        end = tex_scanner::skip_space(bytes, after);
        if let Some((value, after)) = bracketed(text, end) {
            form = Form::Optional(value.to_owned());
            end = tex_scanner::skip_space(bytes, after);
        }
    }
    let close = tex_scanner::body(bytes, end)?;
    let body = text[end + 1..close - 1].to_owned();
    Some(MacroDefinition { name, arguments, form, body, span: Span::new(at, close) })
}

/// The inside of the group in braces at `at`, after spaces, and the position after.
fn braced(text: &str, at: usize) -> Option<(String, usize)> {
    let at = tex_scanner::skip_space(text.as_bytes(), at);
    let close = tex_scanner::body(text.as_bytes(), at)?;
    Some((text[at + 1..close - 1].to_owned(), close))
}

fn document_command(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let (name, end) = name(text, word)?;
    let (types, end) = braced(text, end)?;
    let (body, close) = braced(text, end)?;
    let arguments = types.matches(['m', 'o', 'O']).count();
    Some(MacroDefinition { name, arguments, form: Form::Types(types), body, span: Span::new(at, close) })
}

/// `\let\a\b`, `\let\a=\b`.
fn alias(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let (new, end) = name(text, word)?;
    let end = tex_scanner::skip_space(text.as_bytes(), end);
    let end = end + usize::from(text.as_bytes().get(end) == Some(&b'='));
    let (body, close) = name(text, end)?;
    Some(MacroDefinition { name: new, arguments: 0, form: Form::Alias, body, span: Span::new(at, close) })
}

/// `\DeclarePairedDelimiter\abs{\lvert}{\rvert}`.
fn pair(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let (name, end) = name(text, word)?;
    let (left, end) = braced(text, end)?;
    let (right, close) = braced(text, end)?;
    let (left, right) = (left.trim().to_owned(), right.trim().to_owned());
    let body = format!("\\left{left} #1 \\right{right}");
    Some(MacroDefinition { name, arguments: 1, form: Form::Pair(left, right), body, span: Span::new(at, close) })
}

/// `[…]` at `at`, short: its inside, and the position after.
fn bracketed(text: &str, at: usize) -> Option<(&str, usize)> {
    let rest = text.get(at..)?.strip_prefix('[')?;
    let length = rest.bytes().take(200).position(|b| b == b']')?;
    Some((&rest[..length], at + length + 2))
}

fn def(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let (name, end) = name(text, word)?;
    // A parameter text is short, and ends at the first brace.
    let length = text[end..].bytes().take(60).position(|b| b == b'{')?;
    let pattern = text[end..end + length].trim().to_owned();
    let (body, close) = braced(text, end + length)?;
    let numbers: Vec<usize> =
        pattern.split('#').skip(1).map_while(|part| part.get(..1).and_then(|digit| digit.parse().ok())).collect();
    let is_plain = pattern == numbers.iter().map(|n| format!("#{n}")).collect::<String>();
    let arguments = numbers.len();
    let form = if is_plain { Form::Plain } else { Form::Pattern(pattern) };
    Some(MacroDefinition { name, arguments, form, body, span: Span::new(at, close) })
}

fn operator(text: &str, at: usize, word: usize) -> Option<MacroDefinition> {
    let bytes = text.as_bytes();
    let star = usize::from(bytes.get(word) == Some(&b'*'));
    let (name, end) = name(text, word + star)?;
    let end = tex_scanner::skip_space(bytes, end);
    let close = tex_scanner::body(bytes, end)?;
    let operator = if star == 1 { "\\operatorname*" } else { "\\operatorname" };
    let body = format!("{operator}{}", &text[end..close]);
    Some(MacroDefinition { name, arguments: 0, form: Form::Plain, body, span: Span::new(at, close) })
}
