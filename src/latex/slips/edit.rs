//! An edit of a text, and its kind.

use crate::source::Span;

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

/// `\boldsymbol` where the bold letter is a Greek one: of those TeX has no `\mathbf`.
pub(super) fn bold(formula: String) -> String {
    const UPRIGHT: &str = "\\mathbf{\\";
    match formula.contains(UPRIGHT) {
        true => formula.replace(UPRIGHT, "\\boldsymbol{\\"),
        false => formula,
    }
}
