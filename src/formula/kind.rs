//! The kinds of symbols: number, vector, matrix, and what has no value.

/// The kind of value that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Scalar,
    /// A vector in three dimensions.
    Vector,
    /// A matrix with these numbers of rows and columns.
    Matrix(u8, u8),
    /// A complex number.
    Complex,
    /// What has no value: an operator, a tensor, a state, a unit.
    Abstract,
    /// A rotation about one axis: a function of one angle whose value is a 3×3 matrix.
    Rotation,
}

impl Kind {
    /// What it is, with its article.
    pub fn noun(self) -> String {
        match self {
            Kind::Scalar => "a real number".to_owned(),
            Kind::Complex => "a complex number".to_owned(),
            Kind::Abstract => "something without a value".to_owned(),
            Kind::Vector => "a vector in space".to_owned(),
            Kind::Matrix(0, 0) => "a square matrix".to_owned(),
            Kind::Matrix(rows, columns) => format!("a {rows}×{columns} matrix"),
            Kind::Rotation => "a rotation".to_owned(),
        }
    }

    /// The number of numbers that one value of this kind has.
    pub fn numbers(self) -> usize {
        match self {
            Kind::Scalar | Kind::Rotation => 1,
            Kind::Complex => 2,
            Kind::Abstract => 0,
            Kind::Vector => 3,
            Kind::Matrix(rows, columns) => usize::from(rows) * usize::from(columns),
        }
    }
}
