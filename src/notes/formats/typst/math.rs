//! A formula of Typst as LaTeX, piece by piece, each with its place.

use super::symbols;
use crate::source::Span;

/// A piece of LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Piece {
    /// The same text as in the file.
    Copy(Span),
    /// LaTeX for a range of the file.
    Written(Span, String),
    /// LaTeX that stands for nothing in the file.
    Mark(usize, &'static str),
}

/// What a fraction line or a script takes.
#[derive(Default)]
struct Item {
    pieces: Vec<Piece>,
    /// The pieces without the parentheses, where it is a parenthesis.
    inside: Option<Vec<Piece>>,
    /// Whether it is ∂ alone.
    is_partial: bool,
    /// Whether it is one letter, to which parentheses behind it belong.
    is_letter: bool,
}

/// The deepest nesting.
const DEEPEST: usize = 60;

/// The formula in a range of `text`. What cannot be understood becomes an unknown command.
pub(super) fn latex(text: &str, place: Span) -> Vec<Piece> {
    let mut parser = Parser { text, at: place.start, end: place.end, depth: 0 };
    let mut pieces = match parser.row(&[]) {
        Some(pieces) if parser.at >= place.end => pieces,
        _ if is_unclosed(&text[place.range()]) => vec![unknown(place, "Unclosed")],
        _ => vec![unknown(place, "NotUnderstood")],
    };
    // What stands for nothing in the file stands behind the piece before it.
    let mut last = place.start;
    for piece in &mut pieces {
        match piece {
            Piece::Mark(at, _) => *at = last,
            Piece::Copy(place) | Piece::Written(place, _) => last = place.end,
        }
    }
    pieces
}

/// Whether a parenthesis or a quotation mark of a formula is not closed.
fn is_unclosed(text: &str) -> bool {
    let count = |c: char| text.matches(c).count();
    [('(', ')'), ('[', ']'), ('{', '}')].iter().any(|(open, close)| count(*open) > count(*close)) || count('"') % 2 == 1
}

fn unknown(place: Span, name: &str) -> Piece {
    let letters: String = name.chars().filter(char::is_ascii_alphabetic).collect();
    Piece::Written(place, format!("\\Typst{letters} "))
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    end: usize,
    depth: usize,
}

impl Parser<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..self.end).unwrap_or_default()
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Skips white space and comments; whether there was any.
    fn space(&mut self) -> bool {
        let before = self.at;
        loop {
            let rest = self.rest();
            let blank = rest.len() - rest.trim_start().len();
            self.at += blank;
            let rest = self.rest();
            if rest.starts_with("//") {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else if rest.starts_with("/*") {
                self.at += rest.find("*/").map_or(rest.len(), |end| end + 2);
            } else {
                return self.at > before;
            }
        }
    }

    /// All up to one of these characters, which is not taken.
    fn row(&mut self, until: &[char]) -> Option<Vec<Piece>> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let mut items: Vec<Item> = Vec::new();
        loop {
            if self.space() {
                items.push(Item { pieces: vec![Piece::Mark(self.at, " ")], ..Item::default() });
            }
            let Some(next) = self.peek() else { break };
            if until.contains(&next) {
                break;
            }
            if next == '/' {
                self.at += 1;
                self.fraction(&mut items)?;
                continue;
            }
            let item = self.scripted()?;
            items.push(item);
        }
        self.depth -= 1;
        Some(items.into_iter().flat_map(|item| item.pieces).collect())
    }

    /// A fraction of what stands before the line and what comes next.
    fn fraction(&mut self, items: &mut Vec<Item>) -> Option<()> {
        let is_blank = |item: &Item| matches!(item.pieces.as_slice(), [Piece::Mark(_, " ")]);
        let pop = |items: &mut Vec<Item>| {
            while items.last().is_some_and(is_blank) {
                items.pop();
            }
            items.pop()
        };
        let above = pop(items)?;
        // f(x)/g: the letter belongs to its parentheses.
        let head = above.inside.is_some() && items.last().is_some_and(|item| item.is_letter);
        let (mut above, head) =
            if head { (above.pieces, items.pop()) } else { (above.inside.unwrap_or(above.pieces), None) };
        if let Some(head) = head {
            above.splice(0..0, head.pieces);
        }
        self.space();
        let mut below = self.scripted()?;
        if below.is_letter && self.peek() == Some('(') {
            let argument = self.scripted()?;
            below.pieces.extend(argument.pieces);
        }
        let mut under = below.inside.unwrap_or(below.pieces);
        if below.is_partial {
            // `partial L / partial q`: a line over ∂ alone would mean nothing.
            while items.last().is_some_and(is_blank) {
                items.pop();
            }
            let partial = items.pop().filter(|item| item.is_partial)?;
            above.insert(0, Piece::Mark(self.at, " "));
            above.splice(0..0, partial.pieces);
            self.space();
            under.push(Piece::Mark(self.at, " "));
            under.extend(self.scripted()?.pieces);
        }
        let start = self.at;
        let mut pieces = vec![Piece::Mark(start, "\\frac{")];
        pieces.extend(above);
        pieces.push(Piece::Mark(start, "}{"));
        pieces.extend(under);
        pieces.push(Piece::Mark(start, "}"));
        items.push(Item { pieces, ..Item::default() });
        Some(())
    }

    /// An item with its scripts and primes.
    fn scripted(&mut self) -> Option<Item> {
        let mut item = self.item()?;
        while let Some(mark @ ('_' | '^' | '\'')) = self.peek() {
            let place = Span::new(self.at, self.at + 1);
            self.at += 1;
            item.pieces.push(Piece::Copy(place));
            (item.inside, item.is_partial) = (None, false);
            if mark == '\'' {
                continue;
            }
            self.space();
            let script = self.item()?;
            // What the parentheses belong to differs between versions of Typst.
            if script.is_letter && self.peek() == Some('(') {
                return None;
            }
            item.is_letter &= mark == '_';
            item.pieces.push(Piece::Mark(self.at, "{"));
            item.pieces.extend(script.inside.unwrap_or(script.pieces));
            item.pieces.push(Piece::Mark(self.at, "}"));
        }
        Some(item)
    }

    fn item(&mut self) -> Option<Item> {
        let start = self.at;
        let first = self.peek()?;
        let plain = |pieces: Vec<Piece>| Item { pieces, ..Item::default() };
        let take = |parser: &mut Self, length: usize| {
            parser.at += length;
            Span::new(start, start + length)
        };
        if first.is_ascii_digit() {
            let rest = self.rest();
            let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
            let mut length = digits(rest);
            if rest[length..].starts_with('.') && digits(&rest[length + 1..]) > 0 {
                length += 1 + digits(&rest[length + 1..]);
            }
            return Some(plain(vec![Piece::Copy(take(self, length))]));
        }
        if first.is_alphabetic() {
            return self.name();
        }
        if first == '"' {
            let length = self.rest()[1..].find('"')? + 2;
            let place = take(self, length);
            let inside = &self.text[place.start + 1..place.end - 1];
            if inside.contains(['\\', '{', '}', '$', '#', '%', '&', '_', '^']) {
                return Some(plain(vec![unknown(place, "Text")]));
            }
            return Some(plain(vec![Piece::Written(place, format!("\\text{{{inside}}}"))]));
        }
        if let Some((mark, latex)) = symbols::MARKS.iter().find(|(mark, _)| self.rest().starts_with(mark)) {
            return Some(plain(vec![Piece::Written(take(self, mark.len()), (*latex).to_owned())]));
        }
        Some(match first {
            '(' => {
                self.at += 1;
                let inside = self.row(&[')'])?;
                if self.peek() != Some(')') {
                    return None;
                }
                self.at += 1;
                let mut pieces = vec![Piece::Copy(Span::new(start, start + 1))];
                pieces.extend(inside.iter().cloned());
                pieces.push(Piece::Copy(Span::new(self.at - 1, self.at)));
                Item { pieces, inside: Some(inside), ..Item::default() }
            }
            '{' | '}' => plain(vec![Piece::Written(take(self, 1), format!("\\{first}"))]),
            '\\' => match self.rest()[1..].chars().next() {
                None => plain(vec![Piece::Written(take(self, 1), "\\\\".to_owned())]),
                Some(next) if next.is_whitespace() => plain(vec![Piece::Written(take(self, 1), "\\\\".to_owned())]),
                Some(next) => {
                    let place = take(self, 1 + next.len_utf8());
                    plain(vec![if "{}|,;/:!.*".contains(next) {
                        Piece::Written(place, if "{}|".contains(next) { format!("\\{next}") } else { next.to_string() })
                    } else {
                        unknown(place, "Escape")
                    }])
                }
            },
            '&' | '+' | '-' | '=' | '<' | '>' | '*' | ',' | ';' | ':' | '.' | '|' | '[' | ']' | '!' => {
                plain(vec![Piece::Copy(take(self, 1))])
            }
            '−' => plain(vec![Piece::Written(take(self, first.len_utf8()), "-".to_owned())]),
            '·' | '⋅' => plain(vec![Piece::Written(take(self, first.len_utf8()), "\\cdot ".to_owned())]),
            '×' => plain(vec![Piece::Written(take(self, first.len_utf8()), "\\times ".to_owned())]),
            '∂' => {
                let pieces = vec![Piece::Written(take(self, first.len_utf8()), "\\partial ".to_owned())];
                Item { pieces, is_partial: true, ..Item::default() }
            }
            ')' | '#' | '~' | '_' | '^' | '/' => return None,
            _ => plain(vec![unknown(take(self, first.len_utf8()), "Sign")]),
        })
    }

    /// A letter, a symbol by its name, or a function with its arguments.
    fn name(&mut self) -> Option<Item> {
        let start = self.at;
        let rest = self.rest();
        let word = |text: &str| text.chars().take_while(|c| c.is_alphanumeric()).map(char::len_utf8).sum::<usize>();
        let mut length = word(rest);
        let is_one = rest.chars().next().map(char::len_utf8) == Some(length);
        while !is_one
            && rest[length..].starts_with('.')
            && rest[length + 1..].starts_with(|c: char| c.is_ascii_alphabetic())
        {
            length += 1 + word(&rest[length + 1..]);
        }
        let place = Span::new(start, start + length);
        let name = &self.text[place.range()];
        self.at = place.end;
        if is_one {
            return Some(Item { pieces: vec![Piece::Copy(place)], is_letter: true, ..Item::default() });
        }
        let is_call = self.peek() == Some('(');
        if is_call && !symbols::keeps_parentheses(name) {
            let name = name.to_owned();
            return self.call(&name, place);
        }
        let latex = symbols::symbol(name);
        let is_partial = matches!(name, "partial" | "diff");
        let mut pieces = match latex {
            Some(latex) => vec![Piece::Written(place, format!("{latex} "))],
            None => vec![unknown(place, name)],
        };
        if is_call {
            pieces.extend(self.item()?.pieces);
        }
        Some(Item { pieces, is_partial: is_partial && !is_call, ..Item::default() })
    }

    /// A function with its arguments.
    fn call(&mut self, name: &str, place: Span) -> Option<Item> {
        self.at += 1;
        // Rows of arguments, which semicolons separate.
        let mut rows: Vec<Vec<Vec<Piece>>> = vec![Vec::new()];
        let mut is_refused = false;
        loop {
            self.space();
            let named = self.rest().split([',', ')', ';', '(']).next().is_some_and(|word| {
                word.split_once(':').is_some_and(|(key, _)| key.chars().all(|c| c.is_ascii_alphabetic() || c == '-'))
            });
            let start = self.at;
            let argument = self.row(&[',', ';', ')'])?;
            let delimiters = self.text[start..self.at].trim_end();
            // Bars would make it a determinant.
            is_refused |= named && !(delimiters.ends_with("\"[\"") || delimiters.ends_with("\"(\""));
            let is_end = argument.is_empty() && self.peek() == Some(')');
            if !named && !is_end {
                rows.last_mut()?.push(argument);
            }
            match self.peek()? {
                ';' => rows.push(Vec::new()),
                ')' => break,
                _ => {}
            }
            self.at += 1;
        }
        self.at += 1;
        let end = self.at;
        let whole = Span::new(place.start, end);
        let refused = || Some(Item { pieces: vec![unknown(whole, name)], ..Item::default() });
        rows.retain(|row| !row.is_empty());
        if is_refused {
            return refused();
        }
        let mut pieces = Vec::new();
        let mut put = |open: &'static str, argument: Vec<Piece>, close: &'static str| {
            pieces.push(Piece::Mark(end, open));
            pieces.extend(argument);
            pieces.push(Piece::Mark(end, close));
        };
        let count: usize = rows.iter().map(Vec::len).sum();
        let is_one_row = rows.len() == 1;
        let mut arguments = rows.into_iter();
        match (name, count) {
            ("frac" | "dv" | "pdv" | "binom", 2) if is_one_row => {
                let open = match name {
                    "frac" => "\\frac{",
                    "dv" => "\\dv{",
                    "pdv" => "\\pdv{",
                    _ => "\\binom{",
                };
                let [above, below]: [Vec<Piece>; 2] = arguments.next()?.try_into().ok()?;
                put(open, above, "}{");
                put("", below, "}");
            }
            ("root", 2) if is_one_row => {
                let [index, inside]: [Vec<Piece>; 2] = arguments.next()?.try_into().ok()?;
                put("\\sqrt[", index, "]{");
                put("", inside, "}");
            }
            ("lr", 1) => put("", arguments.next()?.pop()?, ""),
            ("vec", 1..) if is_one_row => {
                put("\\begin{pmatrix}", Vec::new(), "");
                arguments.next()?.into_iter().for_each(|entry| put("", entry, "\\\\ "));
                put("\\end{pmatrix}", Vec::new(), "");
            }
            ("cases", 1..) if is_one_row => {
                put("\\begin{cases}", Vec::new(), "");
                arguments.next()?.into_iter().for_each(|entry| put("", entry, "\\\\ "));
                put("\\end{cases}", Vec::new(), "");
            }
            ("mat", 1..) => {
                put("\\begin{pmatrix}", Vec::new(), "");
                for row in arguments {
                    for (at, entry) in row.into_iter().enumerate() {
                        put(if at == 0 { "" } else { "& " }, entry, " ");
                    }
                    put("\\\\ ", Vec::new(), "");
                }
                put("\\end{pmatrix}", Vec::new(), "");
            }
            (_, 1) => match symbols::command(name) {
                Some(command) => {
                    pieces.push(Piece::Written(place, format!("{command}{{")));
                    pieces.extend(arguments.next()?.pop()?);
                    pieces.push(Piece::Mark(end, "}"));
                }
                None => return refused(),
            },
            _ => return refused(),
        }
        Some(Item { pieces, ..Item::default() })
    }
}
