//! The name of a symbol, as it is printed, and the kind of value that it stands for.

use std::fmt;

/// A name as printed, which identifies a symbol.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name {
    /// The letter or command with its accents, in one spelling: `M`, `\lambda`, `\hat{e}`.
    pub base: String,
    /// The tokens of the subscript, digits and letters one by one: `["1"]`, `["a", "(", "0", ")"]`.
    pub subscript: Vec<String>,
    /// The number of primes.
    pub primes: u8,
}

impl Name {
    /// Whether the LaTeX of a name that stands for a formula, such as `V(x)`, contains a letter or a command.
    pub fn mentions(&self, letter: &str) -> bool {
        let mut rest = self.base.as_str();
        while let Some(first) = rest.chars().next() {
            let is_letter = |c: char| c.is_ascii_alphabetic();
            let length = match first {
                '\\' => 1 + rest[1..].find(|c| !is_letter(c)).unwrap_or(rest.len() - 1),
                _ => first.len_utf8(),
            };
            if &rest[..length] == letter {
                return true;
            }
            rest = &rest[length..];
        }
        false
    }

    /// A name without subscript or primes.
    pub fn plain(base: impl Into<String>) -> Self {
        Name { base: base.into(), subscript: Vec::new(), primes: 0 }
    }
}

impl fmt::Display for Name {
    /// The name as LaTeX, in one canonical spelling.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.base)?;
        f.write_str(&"'".repeat(self.primes.into()))?;
        match self.subscript.as_slice() {
            [] => Ok(()),
            [token] => write!(f, "_{token}"),
            tokens => {
                let mut joined = String::new();
                for token in tokens {
                    let after_command = joined.rsplit('\\').next().is_some_and(|last| {
                        joined.contains('\\') && !last.is_empty() && last.bytes().all(|b| b.is_ascii_alphabetic())
                    });
                    if after_command && token.starts_with(|c: char| c.is_ascii_alphabetic()) {
                        joined.push(' ');
                    }
                    joined.push_str(token);
                }
                write!(f, "_{{{joined}}}")
            }
        }
    }
}

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
