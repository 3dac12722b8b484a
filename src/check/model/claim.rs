//! Claims and hypotheses between two formulas: a [`Link`] is tested, a [`Hypothesis`] is taken for granted.

use crate::formula::{Expr, IndexId, Relation};

/// A hypothesis of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Hypothesis {
    /// Its left side.
    pub lhs: Expr,
    /// The relation.
    pub relation: Relation,
    /// Its right side.
    pub rhs: Expr,
    /// The free indices, for all of whose values it holds.
    pub free: Vec<IndexId>,
    /// Whether it holds at all times and not only at the instant.
    pub throughout: bool,
}

impl Hypothesis {
    /// A link, taken for granted.
    pub fn of(link: Link, throughout: bool) -> Self {
        let Link { lhs, relation, rhs, free } = link;
        Hypothesis { lhs, relation, rhs, free, throughout }
    }
}

/// A hypothesis about all motions that the notes make: a law.
#[derive(Clone, Debug)]
pub struct Law {
    /// Its name.
    pub name: String,
    /// The statements that print it: the place of the display, and of the statement in it.
    pub printed: Vec<(usize, usize)>,
    /// What it says.
    pub hypotheses: Vec<Hypothesis>,
    /// Whether its claim switches the units off, so that its terms may be of any dimension.
    pub units_off: bool,
}

impl Law {
    /// Its name, with what the reader of a report must know beside it.
    pub fn title(&self) -> String {
        if self.units_off { format!("{}, whose units are not checked", self.name) } else { self.name.clone() }
    }
}

/// A name or a law that is lost with a display that cannot be read, and that display in words.
pub type Lost = (String, String);

/// Whether a relation says that two things are the same.
pub fn is_equality(relation: Relation) -> bool {
    matches!(relation, Relation::Equal | Relation::Identical)
}

/// A claim between two formulas.
#[derive(Clone, Debug)]
pub struct Link {
    /// The left side.
    pub lhs: Expr,
    /// The relation.
    pub relation: Relation,
    /// The right side.
    pub rhs: Expr,
    /// The free indices, for all of whose values it is claimed.
    pub free: Vec<IndexId>,
}
