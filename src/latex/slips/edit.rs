//! An edit of a text, and its kind.

use crate::source::Span;

/// A change to a text: a range of bytes and its replacement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The bytes that are replaced.
    pub span: Span,
    /// The replacement.
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

/// The kinds of slip, the most likely first.
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
    /// A bar, hat or vector arrow lost or added.
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
    /// A factor lost or added.
    Factor,
    /// A term lost or added.
    Term,
}

impl Slip {
    /// The name of the kind in messages.
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

/// The formula with `\boldsymbol` for each bold Greek letter, since `\mathbf` has no Greek letters in TeX.
pub(super) fn bold(formula: String) -> String {
    const UPRIGHT: &str = "\\mathbf{\\";
    match formula.contains(UPRIGHT) {
        true => formula.replace(UPRIGHT, "\\boldsymbol{\\"),
        false => formula,
    }
}
