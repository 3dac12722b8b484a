//! Commands that stand for other text: the author's own, the `macros` of a claims file, and those of usual packages.
//!
//! Expansion works on tokens. The tokens of a macro's body carry the place of the call, so that a fault is shown where
//! the author wrote the call. A definition of the author goes before that of a package.
//!
//! | file | what it has |
//! | --- | --- |
//! | `parameters` | how a macro takes its arguments |
//! | `packages` | the macros of packages whose text is fixed, as a table |
//! | `forms` | the macros of packages whose text depends on what follows: `\dv`, `\qty`, `\mqty` |
//!
//! Offers [`Macros`]. Knows tokens, and no symbols.

mod forms;
mod packages;
mod parameters;
mod siunitx;

use std::collections::HashMap;

use crate::code::Code;
use crate::source::{Fault, Span};

use super::layout::values::Values;
use super::lexer::{Token, TokenKind, tokens};
use parameters::Parameter;

/// The most tokens of one expansion; more is taken to be endless.
const LARGEST_EXPANSION: usize = 100_000;

/// Stands before the name of a command that `\let` saved: its meaning at that time, whatever is defined later.
const SAVED: char = '\u{0}';

/// Commands with their bodies.
#[derive(Clone, Debug, Default)]
pub struct Macros {
    bodies: HashMap<String, Macro>,
    /// The formulas that stand for one name each.
    pub(crate) values: Values,
}

#[derive(Clone, Debug)]
struct Macro {
    parameters: Vec<Parameter>,
    body: Vec<Token>,
}

impl Macros {
    /// Defines the macro `name` (with its backslash), its number of arguments and its body.
    pub fn define(&mut self, name: &str, arguments: usize, body: &str) {
        let parameters = vec![Parameter::Mandatory; arguments];
        self.bodies.insert(name.to_owned(), Macro { parameters, body: tokens(body) });
    }

    /// Defines a macro whose first argument is optional, with its default.
    pub fn define_optional(&mut self, name: &str, arguments: usize, default: &str, body: &str) {
        let mut parameters = vec![Parameter::Mandatory; arguments];
        if let Some(first) = parameters.first_mut() {
            *first = Parameter::Optional(tokens(default));
        }
        self.bodies.insert(name.to_owned(), Macro { parameters, body: tokens(body) });
    }

    /// Defines a macro by the parameter text of `\def`, such as `(#1,#2)`.
    pub fn define_pattern(&mut self, name: &str, pattern: &str, body: &str) {
        let parameters = parameters::of_pattern(pattern);
        self.bodies.insert(name.to_owned(), Macro { parameters, body: tokens(body) });
    }

    /// Defines a macro by the argument types of `\NewDocumentCommand`: `m`, `o`, `O{…}`.
    ///
    /// Returns false for a type that is not supported; then nothing is defined.
    pub fn define_document_command(&mut self, name: &str, types: &str, body: &str) -> bool {
        let Some(parameters) = parameters::of_types(types) else { return false };
        self.bodies.insert(name.to_owned(), Macro { parameters, body: tokens(body) });
        true
    }

    /// Defines `\abs` by two delimiters; a star and a size before its argument change nothing.
    pub fn define_pair(&mut self, name: &str, left: &str, right: &str) {
        let parameters = vec![Parameter::Star, Parameter::Ignored, Parameter::Mandatory];
        let body = tokens(&format!("\\left{left} #1 \\right{right}"));
        self.bodies.insert(name.to_owned(), Macro { parameters, body });
    }

    /// Gives `name` the meaning that `other` has now, as `\let` does.
    pub fn alias(&mut self, name: &str, other: &str) {
        let meaning = self.bodies.get(other).cloned().unwrap_or_else(|| {
            let kind = match tokens(other).into_iter().next().map(|token| token.kind) {
                Some(TokenKind::Command(command)) => TokenKind::Command(format!("{SAVED}{command}")),
                Some(kind) => kind,
                None => TokenKind::Command(other.to_owned()),
            };
            Macro { parameters: Vec::new(), body: vec![Token { kind, span: Span::default() }] }
        });
        self.bodies.insert(name.to_owned(), meaning);
    }

    /// The number of arguments of a body: the largest `#n` in it.
    pub fn arguments_of(body: &str) -> usize {
        let parameters = tokens(body).into_iter().filter_map(|token| match token.kind {
            TokenKind::Parameter(n) => Some(usize::from(n)),
            _ => None,
        });
        parameters.max().unwrap_or(0)
    }

    /// Replaces every call in `input`.
    ///
    /// # Errors
    /// A call without all its arguments, an expansion without end, and a macro of a package whose meaning is not
    /// supported.
    pub fn expand(&self, input: Vec<Token>) -> Result<Vec<Token>, Fault> {
        let calls = |token: &Token| match &token.kind {
            TokenKind::Command(name) => self.bodies.contains_key(name) || packages::knows(name),
            _ => false,
        };
        if !input.iter().any(calls) {
            return Ok(input);
        }
        let mut pending: Vec<Token> = input.into_iter().rev().collect();
        let mut output: Vec<Token> = Vec::with_capacity(pending.len());
        let mut produced = 0;
        while let Some(token) = pending.pop() {
            let TokenKind::Command(name) = &token.kind else {
                output.push(token);
                continue;
            };
            if let Some(name) = name.strip_prefix(SAVED) {
                output.push(Token { kind: TokenKind::Command(name.to_owned()), span: token.span });
                continue;
            }
            let expansion = match self.bodies.get(name) {
                Some(definition) => Some(call(name, definition, token.span, &mut pending)?),
                None => packages::expansion(name, token.span, &mut pending, output.last())?,
            };
            let Some(expansion) = expansion else {
                output.push(token);
                continue;
            };
            produced += expansion.len() + 1;
            if produced > LARGEST_EXPANSION {
                return Err(Fault::new(
                    token.span,
                    format!("the macro {name} expands without end, or to too long a text"),
                )
                .code(Code::UnknownCommand)
                .help("correct its definition: a macro cannot use itself"));
            }
            pending.extend(expansion.into_iter().rev());
        }
        Ok(output)
    }
}

/// The text of a call whose arguments are next in the reversed input.
fn call(name: &str, definition: &Macro, span: Span, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
    let count = definition.parameters.iter().filter(|parameter| parameter.has_number()).count();
    let mut values = Vec::with_capacity(count);
    let places: Vec<Span> = if count > 0 { pending.iter().map(|token| token.span).collect() } else { Vec::new() };
    for parameter in &definition.parameters {
        let n = values.len() + 1;
        let missing = || {
            let message = match count {
                1 => format!("{name} needs an argument"),
                count => format!("{name} needs {count} arguments, and argument {n} is missing"),
            };
            Fault::new(span, message).code(Code::UnknownCommand).help("write each argument in braces, and close them")
        };
        values.extend(parameter.take(pending).ok_or_else(missing)?);
    }
    // What the macro writes stands for the call with its arguments.
    let taken = places.get(pending.len()..).unwrap_or_default();
    let end = taken.iter().map(|place| place.end).max().unwrap_or(span.end);
    Ok(substitute(&definition.body, &values, Span::new(span.start, end.max(span.end))))
}

fn substitute(body: &[Token], values: &[Vec<Token>], call: Span) -> Vec<Token> {
    let mut result = Vec::with_capacity(body.len());
    for token in body {
        match token.kind {
            TokenKind::Parameter(n) if n >= 1 => {
                result.extend(values.get(usize::from(n) - 1).into_iter().flatten().cloned())
            }
            _ => result.push(Token { kind: token.kind.clone(), span: call }),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tokens of a text after expansion, without their places.
    fn expanded(macros: &Macros, text: &str) -> Vec<TokenKind> {
        macros.expand(tokens(text)).unwrap().into_iter().map(|token| token.kind).collect()
    }

    fn kinds(text: &str) -> Vec<TokenKind> {
        tokens(text).into_iter().map(|token| token.kind).collect()
    }

    #[test]
    fn arguments_keep_their_own_bytes() {
        let mut macros = Macros::default();
        macros.define("\\half", 1, "\\frac{#1}{2}");
        let expanded = macros.expand(tokens("\\half{x}")).unwrap();
        let x = expanded.iter().find(|t| t.kind == TokenKind::Letter('x')).unwrap();
        assert_eq!(x.span, Span::new(6, 7));
    }

    #[test]
    fn a_macro_that_calls_itself_is_a_fault() {
        let mut macros = Macros::default();
        macros.define("\\x", 0, "\\x\\x");
        assert!(macros.expand(tokens("\\x")).is_err());
    }

    #[test]
    fn arguments_are_taken_as_tex_takes_them() {
        let mut macros = Macros::default();
        macros.define_optional("\\der", 2, "t", "\\frac{d #2}{d #1}");
        macros.define_pattern("\\pair", "(#1,#2)", "#1 + #2");
        assert!(macros.define_document_command("\\total", "O{x} m", "\\frac{d #2}{d #1}"));
        macros.define_pair("\\size", "\\lvert", "\\rvert");
        for (short, long) in [
            ("\\der{y}", "\\frac{d y}{d t}"),
            ("\\der[x]{y}", "\\frac{d y}{d x}"),
            ("\\total y", "\\frac{d y}{d x}"),
            ("\\pair(a,{b,c})z", "a + {b,c}z"),
            ("\\size*{x}", "\\left\\lvert x\\right\\rvert"),
            ("\\size[\\big]{x}", "\\left\\lvert x\\right\\rvert"),
        ] {
            assert_eq!(expanded(&macros, short), kinds(long), "{short}");
        }
        // must-fail cases: a delimiter or an argument that is missing
        for broken in ["\\pair(a", "\\pair a", "\\der", "\\der[x]", "\\size*"] {
            assert!(macros.expand(tokens(broken)).is_err(), "{broken}");
        }
        assert!(!macros.define_document_command("\\odd", "s m", "#2"));
    }

    #[test]
    fn let_keeps_the_old_meaning() {
        let mut macros = Macros::default();
        macros.alias("\\oldvec", "\\vec");
        macros.define("\\vec", 1, "\\mathbf{#1}");
        assert_eq!(expanded(&macros, "\\vec{a} + \\oldvec{a}"), kinds("\\mathbf{a} + \\vec{a}"));
    }
}
