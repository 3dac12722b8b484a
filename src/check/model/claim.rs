//! Claims and hypotheses between two formulas: a [`Link`] is tested, a [`Hypothesis`] is assumed.

use std::sync::Arc;

use crate::formula::{Expr, IndexId, Relation};
use crate::source::{Source, Span};

/// A hypothesis of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Hypothesis {
    /// Its left side.
    pub lhs: Expr,
    /// The relation.
    pub relation: Relation,
    /// Its right side.
    pub rhs: Expr,
    /// The free indices; it holds for all their values.
    pub free: Vec<IndexId>,
    /// Whether it holds at all times, so that its time derivatives vanish too, and not only at the instant.
    pub throughout: bool,
    /// Where an author states it, for messages: a place in a file, after the name of the law if it is one.
    pub stated: Option<Arc<str>>,
    /// Whether it follows from the meaning of a name, and no author states it.
    pub implied: bool,
}

impl Hypothesis {
    /// A link as a hypothesis.
    pub fn of(link: Link, throughout: bool) -> Self {
        let Link { lhs, relation, rhs, free } = link;
        Hypothesis { lhs, relation, rhs, free, throughout, stated: None, implied: false }
    }

    /// The same hypothesis, stated at a place of a file.
    #[must_use]
    pub fn stated_at(self, source: &Source, span: Span) -> Self {
        let (line, column) = source.line_column(span.start);
        Hypothesis { stated: Some(format!("{}:{line}:{column}", source.path).into()), ..self }
    }

    /// The same hypothesis as a part of a law.
    #[must_use]
    pub fn of_law(self, name: &str) -> Self {
        let place = self.stated.as_ref().map_or_else(String::new, |place| format!(", {place}"));
        Hypothesis { stated: Some(format!("{name}{place}").into()), ..self }
    }
}

/// A law: hypotheses of the notes about all motions.
#[derive(Clone, Debug)]
pub struct Law {
    /// The name.
    pub name: String,
    /// The statements that print it: the place of the display, and the place of the statement in it.
    pub printed: Vec<(usize, usize)>,
    /// The hypotheses that it makes.
    pub hypotheses: Vec<Hypothesis>,
    /// Whether its claim switches the check of units off.
    pub units_off: bool,
    /// Whether it follows from a Lagrangian or a Hamiltonian that the notes print, and no author states it.
    pub derived: bool,
}

impl Law {
    /// The message on the display of the law.
    pub fn granted(&self) -> String {
        format!("taken for granted, not checked: {}", self.phrase())
    }

    /// The law within a sentence: `Newton's second law`, `Kirchhoff's law`, `the law “torque”`.
    fn phrase(&self) -> String {
        const KINDS: [&str; 8] = ["law", "laws", "equation", "equations", "principle", "theorem", "rule", "rules"];
        let lower = self.name.to_lowercase();
        let says_what_it_is = lower.split(|c: char| !c.is_alphabetic()).any(|word| KINDS.contains(&word));
        let is_person = self.name.starts_with(char::is_uppercase) && self.name.chars().all(char::is_alphabetic);
        let phrase = match (says_what_it_is, is_person) {
            (true, _) => self.name.clone(),
            (false, true) => format!("{}'s law", self.name),
            (false, false) => format!("the law “{}”", self.name),
        };
        if self.units_off { format!("{phrase} (its units are not checked)") } else { phrase }
    }

    /// Laws within a sentence, joined by commas and “and”.
    pub fn phrases(laws: &[Law]) -> String {
        let phrases: Vec<String> = laws.iter().map(Law::phrase).collect();
        match phrases.split_last() {
            Some((last, [])) => last.clone(),
            Some((last, others)) => format!("{} and {last}", others.join(", ")),
            None => String::new(),
        }
    }
}

/// A name or a law whose display cannot be read, and that display in words.
pub type Unread = (String, String);

/// Whether a relation is an equality.
pub fn is_equality(relation: Relation) -> bool {
    matches!(relation, Relation::Equal | Relation::Identical)
}

/// A claim between two formulas: the link of a chain.
#[derive(Clone, Debug)]
pub struct Link {
    /// The left side.
    pub lhs: Expr,
    /// The relation.
    pub relation: Relation,
    /// The right side.
    pub rhs: Expr,
    /// The free indices; it is claimed for all their values.
    pub free: Vec<IndexId>,
}
