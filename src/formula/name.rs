//! The name of a symbol, as it is printed, the kind of value that it stands for, and what its use shows.

use std::collections::{HashMap, HashSet};
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
            Kind::Abstract => "a quantity that cannot be evaluated".to_owned(),
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

/// What was inferred from the use of letters.
#[derive(Clone, Debug, Default)]
pub struct Inferred {
    /// The functions, without primes, with their arguments as LaTeX where those are names.
    pub functions: HashMap<Name, Option<String>>,
    /// The names that are factors somewhere, and nowhere stand before a lone name in parentheses.
    pub factors: HashSet<Name>,
    /// The letters that stand above as `1 - x`, and so are exponents.
    pub exponents: HashSet<String>,
    /// Whether i has a dot somewhere, so that it is no constant.
    pub i_varies: bool,
    /// Whether d before a letter is a differential.
    pub differentials: bool,
    /// Whether δ before a letter is a variation.
    pub variations: bool,
    /// Whether the display shows that δ before a letter is a variation.
    pub varies: bool,
    /// Whether δ before a letter is a factor in the display, as in −δ v − α x.
    pub has_coefficient: bool,
    /// Whether Δ stands in the display as a quantity of its own.
    pub has_difference_alone: bool,
    /// Letters that stand with a prime for another quantity, as r′ beside r.
    pub letters: HashSet<Name>,
    /// The letters that are matrices.
    pub matrices: HashSet<String>,
    /// Whether letters are inferred at all: where a display is read without declarations.
    pub active: bool,
    /// Whether the display is read for its structure only, since parts of it have no value.
    pub abstractly: bool,
    /// The letters that are indices somewhere in the display.
    pub index_letters: HashSet<String>,
    /// The letters above others that may be indices as well as powers, where the declarations are guesses.
    pub unclear_letters: HashSet<String>,
    /// Names and the letters above them that number steps, as in u^{n+1} = u^n + Δt f.
    pub levels: HashSet<(String, char)>,
    /// Names and the letters above them that may number steps or be powers.
    pub possible_levels: HashSet<(String, char)>,
    /// Two points between which a vector goes in the display, as in `\overrightarrow{PM}`.
    pub segments: HashSet<String>,
    /// The letters that have a 0 or a 1 above them somewhere, as components have and powers have not.
    pub component_letters: HashSet<String>,
    /// The letters that have two index letters above them somewhere, so that two digits above them are indices too.
    pub tensor_letters: HashSet<String>,
    /// Whether letters have two indices somewhere in the display, so that a letter above may be one too.
    pub has_tensors: bool,
    /// Whether letters with a hat are operators.
    pub has_operators: bool,
    /// Whether i is a factor that must be √−1, whatever it is elsewhere.
    pub imaginary_factor: bool,
    /// Whether i is an index somewhere in the display, and nothing shows that it is √−1.
    pub i_is_index: bool,
    /// Whether e is Euler's number, since a side of an equation has nothing but numbers and its powers.
    pub e_is_number: bool,
    /// Whether e is a charge: it stands beside ħ, ε₀ or c, and never has an exponent of letters.
    pub charge: bool,
    /// Whether states of quantum mechanics stand in the display, beside which i is √−1.
    pub has_states: bool,
    /// The letters that act on states or are multiplied in one order only.
    pub acting: HashSet<Name>,
    /// Whether d is a factor, since it stands beside other factors in the argument of a function.
    pub has_factor_d: bool,
    /// Whether a T above a letter is a transpose.
    pub has_transposes: bool,
    /// Whether ∂ stands in the display, so that d/dx beside it is a total derivative.
    pub has_partials: bool,
    /// Each inference in words.
    pub said: Vec<String>,
}
