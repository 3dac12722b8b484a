//! What stands in a formula tree beside sums and products: functions of matrices, parts of complex numbers, relations, and the
//! conditions of `cases`.

use super::tree::Expr;

/// The functions of a square matrix whose value is a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixFunction {
    /// `\\det A`
    Determinant,
    /// `\\operatorname{tr} A`
    Trace,
}

impl MatrixFunction {
    /// The usual name.
    pub fn name(self) -> &'static str {
        match self {
            MatrixFunction::Determinant => "det",
            MatrixFunction::Trace => "tr",
        }
    }

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            MatrixFunction::Determinant => "determinant",
            MatrixFunction::Trace => "trace",
        }
    }

    /// The LaTeX that prints it.
    pub fn command(self) -> &'static str {
        match self {
            MatrixFunction::Determinant => "\\det",
            MatrixFunction::Trace => "\\operatorname{tr}",
        }
    }
}

/// The real number or the complex number that is taken of a complex one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ComplexPart {
    /// `z^*`, `\bar z` of a complex z
    Conjugate,
    /// `\operatorname{Re} z`
    Real,
    /// `\operatorname{Im} z`
    Imaginary,
}

impl ComplexPart {
    /// The usual name.
    pub fn name(self) -> &'static str {
        match self {
            ComplexPart::Conjugate => "conj",
            ComplexPart::Real => "Re",
            ComplexPart::Imaginary => "Im",
        }
    }
}

/// A chain of comparisons, `0 \le x < 1`: one relation fewer than members.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// What is compared.
    pub members: Vec<Expr>,
    /// The relations between neighbours.
    pub relations: Vec<Relation>,
}

/// One row of `cases`.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The value in this case.
    pub value: Expr,
    /// The comparisons that must all hold; empty for "otherwise".
    pub conditions: Vec<Condition>,
}

impl Branch {
    /// The value, and what its conditions compare.
    pub fn parts(&self) -> Vec<&Expr> {
        let compared = self.conditions.iter().flat_map(|condition| &condition.members);
        std::iter::once(&self.value).chain(compared).collect()
    }

    /// As [`Branch::parts`], mutable.
    pub fn parts_mut(&mut self) -> Vec<&mut Expr> {
        let compared = self.conditions.iter_mut().flat_map(|condition| &mut condition.members);
        std::iter::once(&mut self.value).chain(compared).collect()
    }
}

/// The relation between two members of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each is the relation of its name")]
pub enum Relation {
    Equal,
    /// `\equiv`, `:=`: a definition, unless the symbol is known.
    Identical,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    NotEqual,
    /// `\approx`, `\simeq`.
    Approximately,
    Proportional,
}

impl Relation {
    /// Every relation, as one character.
    const ALL: &[(Relation, &str)] = &[
        (Relation::Equal, "="),
        (Relation::Identical, "≡"),
        (Relation::Less, "<"),
        (Relation::LessEqual, "≤"),
        (Relation::Greater, ">"),
        (Relation::GreaterEqual, "≥"),
        (Relation::NotEqual, "≠"),
        (Relation::Approximately, "≈"),
        (Relation::Proportional, "∝"),
    ];

    /// The relation as LaTeX, with a space after it.
    pub fn command(self) -> &'static str {
        match self {
            Relation::Equal => " = ",
            Relation::Identical => " \\equiv ",
            Relation::Less => " < ",
            Relation::LessEqual => " \\le ",
            Relation::Greater => " > ",
            Relation::GreaterEqual => " \\ge ",
            Relation::NotEqual => " \\neq ",
            Relation::Approximately => " \\approx ",
            Relation::Proportional => " \\propto ",
        }
    }

    /// The relation as one character.
    pub fn glyph(self) -> &'static str {
        Self::ALL.iter().find(|(relation, _)| *relation == self).map_or("", |(_, glyph)| *glyph)
    }
}
