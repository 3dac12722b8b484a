//! The layout parser: tokens to the layout tree.
//!
//! It cannot fail: a fence without its partner, a fraction without a denominator, a group nested too deeply becomes a
//! [`Layout::Fault`] at its place.

use crate::code::Code;
use crate::source::{Fault, Span};

use super::super::lexer::{Space, Token, TokenKind};
use super::angles::{bars_before_angle, bra_length, is_lone_bar};
use super::delimiters::{closing, glyph, is_plain_bar, misclosed, unclosed, unopened, without_argument};
use super::item::{Delimiter, Item, Layout, has_equals, is_derivative_mark, letters, letters_and_spaces, prints_alone};
use super::units;

/// The most levels of groups inside groups; equations in notes have far fewer.
const DEEPEST: usize = 64;

/// What ends the list that is being read.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Until {
    End,
    Brace,
    Bracket,
    Fence(Delimiter),
    Right,
    Cell,
}

/// Gathers tokens into what is typeset; `length` is the length of the text, where faults of missing ends are put.
pub fn layout(tokens: &[Token], length: usize) -> Vec<Item> {
    let mut parser = Parser { tokens, at: 0, depth: 0, length, angles: 0 };
    let mut items = parser.list(Until::End);
    while let Some(token) = parser.next() {
        items.push(of_fault(unopened(token)));
        items.extend(parser.list(Until::End));
    }
    units::settled(items)
}

pub(super) fn fault(span: Span, message: impl Into<String>) -> Item {
    of_fault(Fault::new(span, message))
}

pub(super) fn of_fault(fault: Fault) -> Item {
    let span = fault.span;
    Item { layout: Layout::Fault(fault), span }
}

/// The fault where `what` exceeds the limit of nesting.
fn too_deep(span: Span, what: &str) -> Item {
    let message = format!("{what} are nested more than {DEEPEST} levels deep");
    of_fault(Fault::new(span, message).code(Code::TooLarge).help("split the formula into several equations"))
}

pub(super) struct Parser<'a> {
    pub(super) tokens: &'a [Token],
    pub(super) at: usize,
    depth: usize,
    length: usize,
    /// Whether the list being read stands directly in angle brackets.
    pub(super) angles: usize,
}

impl<'a> Parser<'a> {
    pub(super) fn peek(&self) -> Option<&'a Token> {
        self.tokens.get(self.at)
    }

    pub(super) fn next(&mut self) -> Option<&'a Token> {
        let token = self.peek();
        self.at += usize::from(token.is_some());
        token
    }

    fn end(&self) -> Span {
        self.peek().map_or(Span::at(self.length), |token| Span::at(token.span.start))
    }

    pub(super) fn previous_end(&self) -> usize {
        self.at.checked_sub(1).map_or(0, |at| self.tokens[at].span.end)
    }

    /// Items up to, and without, the token that ends the list (or one that can only end an outer list).
    pub(super) fn list(&mut self, until: Until) -> Vec<Item> {
        let mut items = Vec::new();
        if self.depth >= DEEPEST {
            let start = self.end().start;
            self.at = self.tokens.len();
            return vec![too_deep(Span::new(start, self.length.max(start)), "groups")];
        }
        self.depth += 1;
        while let Some(token) = self.peek() {
            if self.ends(token, until) {
                break;
            }
            // `\vec v\,'`: a prime after a thin space belongs to what stands before the space.
            let is_thin = matches!(token.kind, TokenKind::Space(Space::Thin));
            if is_thin
                && !items.is_empty()
                && self.tokens.get(self.at + 1).is_some_and(|next| next.kind == TokenKind::Prime)
            {
                self.next();
                self.attach_primes(&mut items);
                continue;
            }
            let item = self.scripted(false);
            match item.layout {
                Layout::Group(mut inside) if prints_alone(&inside) => items.append(&mut inside),
                layout => items.push(Item { layout, span: item.span }),
            }
        }
        self.depth -= 1;
        items
    }

    fn ends(&self, token: &Token, until: Until) -> bool {
        match &token.kind {
            TokenKind::Close => true,
            TokenKind::Align | TokenKind::Row => until == Until::Cell,
            TokenKind::Other('|') => until == Until::Fence(Delimiter::PlainBar),
            TokenKind::Other(']') if until == Until::Bracket => true,
            TokenKind::Other(')' | ']') => true,
            TokenKind::Command(name) => match name.as_str() {
                "\\right" | "\\end" | "\\}" | "\\rvert" | "\\rVert" | "\\rangle" => true,
                "\\|" | "\\Vert" => until == Until::Fence(Delimiter::DoubleBar),
                "\\vert" => until == Until::Fence(Delimiter::PlainBar),
                _ => false,
            },
            _ => false,
        }
    }

    /// The argument of a command or a script: a group, or one item.
    pub(super) fn argument(&mut self, command: Span) -> Item {
        if self.depth >= DEEPEST {
            self.at = self.tokens.len();
            return too_deep(command, "commands");
        }
        self.depth += 1;
        let item = self.bare_argument(command);
        self.depth -= 1;
        item
    }

    fn bare_argument(&mut self, command: Span) -> Item {
        let missing = || {
            let before = self.tokens[..self.at].iter().rev().find(|token| token.span == command);
            of_fault(without_argument(before, command))
        };
        match self.peek() {
            None => missing(),
            Some(token) => match &token.kind {
                TokenKind::Close | TokenKind::Align | TokenKind::Row | TokenKind::Sub | TokenKind::Super => missing(),
                TokenKind::Other(')' | ']' | '=' | '+') => missing(),
                TokenKind::Command(name) if name == "\\right" || name == "\\end" => missing(),
                TokenKind::Space(_) => {
                    self.next();
                    self.bare_argument(command)
                }
                _ => self.item(true),
            },
        }
    }

    pub(super) fn item(&mut self, single_digit: bool) -> Item {
        let Some(token) = self.next() else {
            return fault(self.end(), "a formula is missing here");
        };
        let span = token.span;
        let layout = match &token.kind {
            TokenKind::Letter(c) => Layout::Letter(*c),
            TokenKind::Digit(c) => return self.number(*c, span, single_digit),
            TokenKind::Space(space) => Layout::Space(*space),
            TokenKind::Align => Layout::Align,
            TokenKind::Row => Layout::Row,
            TokenKind::Open => return self.group(span),
            TokenKind::Command(name) => return self.command(name, span),
            TokenKind::Other('(') => return self.fence(Delimiter::Round, span),
            TokenKind::Other('[') => return self.fence(Delimiter::Square, span),
            // `f|_{x=a}`: no bar that opens has a subscript.
            TokenKind::Other('|') if self.peek().is_some_and(|next| next.kind == TokenKind::Sub) => Layout::Other('|'),
            // `\langle a | b \rangle`: a bar between brackets that is closed nowhere in them separates.
            TokenKind::Other('|') if self.angles > 0 && !self.is_closed_bar() => Layout::Other('|'),
            // `P(A|B)`: a bar that is closed nowhere in its parenthesis.
            TokenKind::Other('|') if is_lone_bar(&self.tokens[self.at..]) => Layout::Other('|'),
            TokenKind::Other('|') => return self.fence(Delimiter::PlainBar, span),
            TokenKind::Other(c) => Layout::Other(*c),
            TokenKind::Parameter(n) => return fault(span, format!("#{n} can stand only in the definition of a macro")),
            TokenKind::Close | TokenKind::Sub | TokenKind::Super | TokenKind::Prime => {
                return fault(span, "a closing brace, a subscript, a superscript or a prime cannot stand here");
            }
        };
        Item { layout, span }
    }

    fn number(&mut self, first: char, span: Span, single_digit: bool) -> Item {
        let mut digits = String::from(first);
        let mut end = span.end;
        while !single_digit && let Some(token) = self.peek() {
            match token.kind {
                // The digits that a macro writes have one place.
                TokenKind::Digit(c)
                    if (token.span.start == end || token.span == span) && !(c == '.' && digits.contains('.')) =>
                {
                    digits.push(c);
                    end = token.span.end;
                    self.next();
                }
                // `3{,}5`, as it is written where a comma separates the decimals.
                TokenKind::Open if !digits.contains('.') && is_decimal_comma(&self.tokens[self.at..], end, &digits) => {
                    digits.push('.');
                    end += "{,}".len();
                    self.at += 3;
                }
                _ => break,
            }
        }
        Item { layout: Layout::Number(digits), span: Span::new(span.start, end) }
    }

    /// Whether the bar that was just read opens the bars of an absolute value, `\langle |x|^2 \rangle`.
    fn is_closed_bar(&self) -> bool {
        let follows_open =
            self.at >= 2 && matches!(&self.tokens[self.at - 2].kind, TokenKind::Command(name) if name == "\\langle");
        follows_open && bars_before_angle(&self.tokens[self.at..]) % 2 == 1
    }

    fn group(&mut self, open: Span) -> Item {
        let outer = std::mem::take(&mut self.angles);
        let items = self.list(Until::Brace);
        self.angles = outer;
        match self.peek() {
            Some(token) if token.kind == TokenKind::Close => {
                self.next();
                // `{\nabla} h`, `{\partial} g`, `{\mathrm d}x`
                match items.as_slice() {
                    [only] if is_derivative_mark(only) => only.clone(),
                    _ => Item { layout: Layout::Group(items), span: open.to(token.span) },
                }
            }
            _ => self.unclosed(open, "{", items),
        }
    }

    /// A fence or group without its end: the deepest fault wins, since it was probably the cause.
    pub(super) fn unclosed(&self, open: Span, what: &str, items: Vec<Item>) -> Item {
        match items.into_iter().rev().find(|item| matches!(item.layout, Layout::Fault(_))) {
            Some(inner) => inner,
            None => of_fault(unclosed(open, what)),
        }
    }

    fn fence(&mut self, delimiter: Delimiter, open: Span) -> Item {
        let outer = std::mem::replace(&mut self.angles, usize::from(delimiter == Delimiter::Angle));
        if delimiter == Delimiter::Angle
            && let Some(bar) = bra_length(&self.tokens[self.at..])
        {
            let label = layout(&self.tokens[self.at..self.at + bar], self.length);
            self.angles = outer;
            self.at += bar + 1;
            return Item { layout: Layout::Fence(Delimiter::Bra, label), span: open.to(Span::at(self.previous_end())) };
        }
        let mut items = self.list(Until::Fence(delimiter));
        // `[a \\ & + b]`: a parenthesis goes on in the next row.
        if matches!(delimiter, Delimiter::Round | Delimiter::Square) {
            items.retain(|item| !matches!(item.layout, Layout::Row | Layout::Align));
        }
        self.angles = outer;
        let close = self.peek().map(|token| (token, closing(token)));
        let is_pair = items.iter().filter(|item| item.layout == Layout::Other(',')).count() == 1;
        let mixed = match (delimiter, close) {
            (Delimiter::PlainBar, Some((_, Some(Delimiter::Angle)))) => Some(Delimiter::Ket),
            (Delimiter::Round, Some((_, Some(Delimiter::Square)))) if is_pair => Some(Delimiter::LeftOpen),
            (Delimiter::Square, Some((_, Some(Delimiter::Round)))) if is_pair => Some(Delimiter::RightOpen),
            _ => None,
        };
        if let (Some(delimiter), Some((token, _))) = (mixed, close) {
            self.next();
            return Item { layout: Layout::Fence(delimiter, items), span: open.to(token.span) };
        }
        match self.peek() {
            Some(token) if closing(token) == Some(delimiter) || is_plain_bar(token, delimiter) => {
                self.next();
                Item { layout: Layout::Fence(delimiter, items), span: open.to(token.span) }
            }
            other => match other.and_then(|token| misclosed(open, delimiter, token)) {
                Some(fault) => of_fault(fault),
                None => self.unclosed(open, glyph(delimiter), items),
            },
        }
    }

    fn command(&mut self, name: &str, span: Span) -> Item {
        let boxed = |item| Box::new(item);
        let layout = match name {
            "\\frac" => {
                let numerator = self.argument(span);
                let denominator = self.argument(span);
                Layout::Fraction(boxed(trimmed(numerator)), boxed(trimmed(denominator)))
            }
            "\\sqrt" => {
                let index = match self.peek() {
                    Some(token) if token.kind == TokenKind::Other('[') => {
                        self.next();
                        let inside = self.list(Until::Bracket);
                        if self.next().is_none_or(|token| token.kind != TokenKind::Other(']')) {
                            return of_fault(unclosed(token.span, "["));
                        }
                        Some(Box::new(Item { layout: Layout::Group(inside), span: token.span }))
                    }
                    _ => None,
                };
                Layout::Root(index, Box::new(self.argument(span)))
            }
            "\\dot"
            | "\\ddot"
            | "\\dddot"
            | "\\vec"
            | "\\hat"
            | "\\bar"
            | "\\tilde"
            | "\\check"
            | "\\breve"
            | "\\acute"
            | "\\grave"
            | "\\underline"
            | "\\cancel"
            | "\\slashed"
            | "\\mathring"
            | "\\overleftrightarrow" => Layout::Accent(name.to_owned(), Box::new(self.argument(span))),
            "\\mathbf" | "\\mathrm" | "\\mathbb" | "\\mathcal" | "\\mathfrak" | "\\mathscr" | "\\mathtt" => {
                // `\operatorname*{min}`
                if let [star, open, ..] = &self.tokens[self.at..]
                    && star.kind == TokenKind::Other('*')
                    && star.span.start == self.previous_end()
                    && open.kind == TokenKind::Open
                {
                    self.next();
                }
                // `\mathrm{~d} x`: the space stands before the word.
                let mut inner = trimmed(self.argument(span));
                // `\operatorname{arg\,min}`
                if let Layout::Group(items) = &mut inner.layout
                    && ["arg min", "arg max"].contains(&letters_and_spaces(items).as_str())
                {
                    items.retain(|item| matches!(item.layout, Layout::Letter(_)));
                }
                // `\mathrm{.}`: a full stop in another font.
                let mark = match &inner.layout {
                    Layout::Group(items) => match items.as_slice() {
                        [Item { layout: mark @ Layout::Other('.' | ',' | ';'), .. }] => Some(mark.clone()),
                        _ => None,
                    },
                    _ => None,
                };
                match mark {
                    None if name == "\\mathrm" => {
                        let word = Layout::Style(name.to_owned(), boxed(inner.clone()));
                        return units::word(word, &inner, span.to(Span::at(self.previous_end())));
                    }
                    mark => mark.unwrap_or_else(|| Layout::Style(name.to_owned(), boxed(inner))),
                }
            }
            "\\text" => return self.text(span),
            "\\tag" | "\\label" => {
                self.argument(span);
                Layout::Space(Space::Thin)
            }
            "\\substack" | "\\ensuremath" | "\\mathclap" | "\\smash" => {
                return self.argument(span);
            }
            "\\hspace" | "\\mspace" | "\\phantom" | "\\hphantom" | "\\vphantom" | "\\vspace" => {
                self.argument(span);
                Layout::Space(Space::Thin)
            }
            "\\xrightarrow" | "\\xleftarrow" | "\\xleftrightarrow" => {
                if self.peek().is_some_and(|next| next.kind == TokenKind::Other('[')) {
                    self.next();
                    self.list(Until::Bracket);
                    self.next();
                }
                let above = self.argument(span);
                let arrow = Layout::Command(format!("\\{}", &name[2..]));
                // `\xrightarrow{m_1 = m_2}`: what follows holds under a condition.
                match has_equals(&above) {
                    true => Layout::Scripts {
                        nucleus: Box::new(Item { layout: arrow, span }),
                        sub: None,
                        sup: Some(Box::new(above)),
                        primes: 0,
                    },
                    false => arrow,
                }
            }
            "\\underset" if self.is_underset_operator() => return self.underset(span),
            "\\left" => return self.left(span),
            "\\begin" => return self.environment(span),
            "\\{" => return self.fence(Delimiter::Curly, span),
            "\\vert" | "\\mid" if self.angles > 0 => Layout::Other('|'),
            "\\vert" if is_lone_bar(&self.tokens[self.at..]) => Layout::Other('|'),
            "\\lvert" => return self.fence(Delimiter::Bar, span),
            "\\vert" => return self.fence(Delimiter::PlainBar, span),
            "\\|" | "\\lVert" | "\\Vert" => return self.fence(Delimiter::DoubleBar, span),
            "\\langle" => return self.fence(Delimiter::Angle, span),
            _ => Layout::Command(name.to_owned()),
        };
        Item { layout, span: span.to(Span::at(self.previous_end())) }
    }

    fn text(&mut self, span: Span) -> Item {
        let argument = self.argument(span);
        // `\textrm{d}x`: an upright d before a letter is that of a differential.
        let is_d = matches!(super::item::contents(&argument), [Item { layout: Layout::Letter('d'), .. }]);
        // `{\mbox{d}}^2 r` too.
        let is_before_letter = self.peek().is_some_and(|next| {
            matches!(next.kind, TokenKind::Letter(_) | TokenKind::Command(_) | TokenKind::Close | TokenKind::Super)
        });
        if is_d && is_before_letter {
            let layout = Layout::Style("\\mathrm".to_owned(), Box::new(argument));
            return Item { layout, span: span.to(Span::at(self.previous_end())) };
        }
        let word = Layout::Text(letters(&argument));
        units::word(word, &argument, span.to(Span::at(self.previous_end())))
    }

    /// Skips the place of an environment on its line, or of its columns: `\begin{aligned}[t]`, `\begin{bmatrix*}[r]`.
    fn skip_position(&mut self) {
        let mut next = self.tokens[self.at..].iter().map(|token| &token.kind);
        let is_position = next.next() == Some(&TokenKind::Other('['))
            && matches!(next.next(), Some(TokenKind::Letter('t' | 'c' | 'b' | 'l' | 'r')))
            && next.next() == Some(&TokenKind::Other(']'));
        self.at += if is_position { 3 } else { 0 };
    }

    fn environment(&mut self, span: Span) -> Item {
        let name = letters(&self.argument(span));
        self.skip_position();
        // Column specifications and numbers of columns set nothing that matters.
        if matches!(name.as_str(), "array" | "alignedat" | "alignat" | "alignat*") {
            self.argument(span);
        }
        let mut rows = vec![Vec::new()];
        loop {
            let cell = self.list(Until::Cell);
            if let Some(row) = rows.last_mut() {
                row.push(cell);
            }
            let Some(token) = self.next() else {
                let deepest = rows.into_iter().flatten().flatten().collect();
                return self.unclosed(span, &format!("\\begin{{{name}}}"), deepest);
            };
            match &token.kind {
                TokenKind::Align => {}
                TokenKind::Row => rows.push(Vec::new()),
                TokenKind::Command(command) if command == "\\end" => {
                    let closed = letters(&self.argument(token.span));
                    if closed != name {
                        return fault(token.span, format!("\\end{{{closed}}} does not match \\begin{{{name}}}"));
                    }
                    break;
                }
                _ => {
                    return fault(
                        token.span,
                        format!("this bracket or command closes nothing inside of \\begin{{{name}}}"),
                    );
                }
            }
        }
        if rows.len() > 1 && rows.last().is_some_and(|row| row.iter().all(Vec::is_empty)) {
            rows.pop();
        }
        Item { layout: Layout::Environment(name, rows), span: span.to(Span::at(self.previous_end())) }
    }
}

/// A group without the spaces at its ends, which `\newcommand{\dd}{\,\mathrm{d}}` puts before a d.
fn trimmed(item: Item) -> Item {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    match item.layout {
        Layout::Group(items) if items.first().is_some_and(is_space) || items.last().is_some_and(is_space) => {
            let end = items.iter().rposition(|item| !is_space(item)).map_or(0, |last| last + 1);
            let start = items.iter().position(|item| !is_space(item)).unwrap_or(end);
            Item { layout: Layout::Group(items[start..end].to_vec()), span: item.span }
        }
        _ => item,
    }
}

/// Whether a decimal comma in braces, `3{,}5`, comes next after the digits `whole` that end at `end`. Three digits after it may
/// be a group of thousands, but for those after a 0.
fn is_decimal_comma(tokens: &[Token], end: usize, whole: &str) -> bool {
    let [open, comma, close, decimals @ ..] = tokens else { return false };
    let is_comma = comma.kind == TokenKind::Other(',') && close.kind == TokenKind::Close;
    let is_tight = open.span.start == end && close.span.end == end + "{,}".len();
    let is_digit = |token: &&Token| matches!(token.kind, TokenKind::Digit(c) if c != '.');
    let count = decimals.iter().take_while(is_digit).count();
    is_comma && is_tight && count > 0 && (count != 3 || whole == "0")
}
