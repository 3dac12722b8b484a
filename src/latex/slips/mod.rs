//! The slips of authors, as edits of what they typed; and the edits that undo such slips.
//!
//! [`slips`] gives every single slip in the text of a display: a sign, a factor, a dot, an index, a parenthesis.
//! [`corrections`] gives what mends one: the same edits, since most slips are undone by one of their own kind, and what
//! undoes the others, a factor or a term put in. They are found in what is typeset ([`super::layout`]) and in the names
//! of the document; what a formula means is not looked at, so a display that cannot be read has them too.
//!
//! An [`Edit`] is one run of bytes and what stands there instead. Nothing else of the author's text is touched. What a
//! macro of the author's expands to has no bytes of its own, and is left alone but as a whole.

mod atoms;
mod brackets;
mod exchanges;
mod families;
mod fences;
mod holes;
mod insertions;
mod lists;
#[cfg(test)]
mod tests;

use std::collections::HashSet;

use crate::formula::Symbols;
use crate::source::Span;

use super::layout::{Item, Layout, typeset_items};
use super::macros::Macros;

pub use holes::{Hole, holes};
pub use insertions::Pool;

/// A change to a text: some bytes of it, and what stands there instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The bytes that go.
    pub span: Span,
    /// What comes in their place.
    pub replacement: String,
    /// The kind of slip.
    pub slip: Slip,
}

impl Edit {
    /// The text with the change made.
    pub fn applied(&self, text: &str) -> String {
        let mut changed = String::with_capacity(text.len() + self.replacement.len());
        changed.push_str(&text[..self.span.start]);
        changed.push_str(&self.replacement);
        changed.push_str(&text[self.span.end..]);
        changed
    }
}

/// The kinds of slip, the likeliest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Slip {
    /// A term or a factor typed twice.
    Doubled,
    /// A sign flipped, lost, or one of ±.
    Sign,
    /// One symbol for another like it.
    Symbol,
    /// Another index, or two swapped.
    Index,
    /// A dot more or less.
    Dot,
    /// Another number.
    Number,
    /// Another power, none, or one in another place.
    Exponent,
    /// One function for another, as sine for cosine.
    Function,
    /// A bar, hat or vector arrow lost or put on.
    Accent,
    /// Factors in another order.
    Order,
    /// Numerator and denominator exchanged.
    Fraction,
    /// A parenthesis lost, or closed too early or too late.
    Parenthesis,
    /// < for >.
    Relation,
    /// One symbol for another of its kind that is not like it.
    Name,
    /// A factor left out or put in.
    Factor,
    /// A term left out or put in.
    Term,
}

impl Slip {
    /// What it is about, in a word or two.
    pub fn word(self) -> &'static str {
        match self {
            Slip::Doubled => "doubled",
            Slip::Sign => "sign",
            Slip::Symbol | Slip::Name => "symbol",
            Slip::Index => "index",
            Slip::Dot => "dot",
            Slip::Number => "number",
            Slip::Exponent => "exponent",
            Slip::Function => "function",
            Slip::Accent => "accent",
            Slip::Order => "order",
            Slip::Fraction => "fraction",
            Slip::Parenthesis => "parenthesis",
            Slip::Relation => "relation",
            Slip::Factor => "factor",
            Slip::Term => "term",
        }
    }
}

/// Every single slip in the text of a display.
pub fn slips(text: &str, symbols: &Symbols, macros: &Macros) -> Vec<Edit> {
    found(text, symbols, macros, None)
}

/// The edits that undo a single slip; what may be put in is taken from `pool`.
pub fn corrections(text: &str, symbols: &Symbols, macros: &Macros, pool: &Pool) -> Vec<Edit> {
    found(text, symbols, macros, Some(pool))
}

fn found(text: &str, symbols: &Symbols, macros: &Macros, pool: Option<&Pool>) -> Vec<Edit> {
    // A display of which nothing is typeset at all has no terms, but its characters may be mended.
    let Ok(items) = typeset_items(text, macros) else { return Vec::new() };
    let mut finder = Finder { text, symbols, pool, edits: Vec::new() };
    if pool.is_some() {
        finder.edits = brackets::balanced(text);
    }
    finder.display(&items);
    let mut seen = HashSet::new();
    let fresh = |edit: &Edit| text[edit.span.range()] != edit.replacement && seen.insert(edit.applied(text));
    finder.edits.into_iter().filter(fresh).collect()
}

/// Walks what is typeset and gathers edits.
struct Finder<'a> {
    text: &'a str,
    symbols: &'a Symbols,
    /// What may be put in; none where slips are made and not undone.
    pool: Option<&'a Pool>,
    edits: Vec<Edit>,
}

impl Finder<'_> {
    /// What is typed there; nothing for what a macro's body and its arguments have put in another order.
    fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// Adds an edit, but for one after which TeX would see two scripts in one place; a command and a letter that would run
    /// together are set apart.
    fn edit(&mut self, slip: Slip, span: Span, replacement: impl Into<String>) {
        let mut replacement = bold(replacement.into());
        if self.text.get(span.range()).is_none() {
            return;
        }
        let (before, after) = (&self.text[..span.start], &self.text[span.end..]);
        if last_script(&replacement).is_some_and(|script| after.trim_start().starts_with(script)) {
            return;
        }
        let letter = |text: &str| text.starts_with(|c: char| c.is_ascii_alphabetic());
        if ends_in_command(&replacement) && letter(after) {
            replacement.push(' ');
        }
        match replacement.is_empty() {
            true if ends_in_command(before) && letter(after) => replacement.push(' '),
            false if ends_in_command(before) && letter(&replacement) => replacement.insert(0, ' '),
            _ => {}
        }
        self.edits.push(Edit { span, replacement, slip });
    }

    /// What is inside of an item, but for what comes from a macro.
    fn inside<'i>(&self, item: &Item, inner: &'i Item) -> Option<&'i Item> {
        (inner.span != item.span && item.span.contains(inner.span)).then_some(inner)
    }

    /// An argument of a command: the list in its braces, or the one thing that it is.
    fn argument(&mut self, item: &Item, argument: &Item) {
        let Some(argument) = self.inside(item, argument) else { return };
        match &argument.layout {
            Layout::Group(items) => self.list(items),
            _ => self.item(argument),
        }
    }
}

/// `\boldsymbol` where the bold letter is a Greek one: of those TeX has no `\mathbf`.
fn bold(formula: String) -> String {
    const UPRIGHT: &str = "\\mathbf{\\";
    match formula.contains(UPRIGHT) {
        true => formula.replace(UPRIGHT, "\\boldsymbol{\\"),
        false => formula,
    }
}

/// The `_` or `^` of the script that a formula ends with.
fn last_script(formula: &str) -> Option<char> {
    let formula = formula.trim_end();
    let script = match formula.ends_with('}') {
        true => {
            let mut depth = 0;
            let opens = |c: char| {
                depth += i32::from(c == '}') - i32::from(c == '{');
                depth == 0
            };
            &formula[..formula.rfind(opens)?]
        }
        false => formula.strip_suffix(|_: char| true)?,
    };
    script.chars().next_back().filter(|c| matches!(c, '_' | '^'))
}

/// Whether a text ends in the letters of a command.
fn ends_in_command(text: &str) -> bool {
    let word = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    word.len() < text.len() && word.ends_with('\\') && !word.ends_with("\\\\")
}
