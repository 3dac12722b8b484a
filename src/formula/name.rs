//! The name of a symbol, as it is printed.

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
