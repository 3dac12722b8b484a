//! What an equation says, apart from how it was typeset.
//!
//! [`tree`] is the formula as a tree whose every node keeps the bytes it came from; [`symbols`] is the table of what
//! each name is; [`shape`] gives every formula one type (scalar, vector, matrix; free indices) or refuses it, and
//! makes implied sums explicit; [`mod@evaluate`] gives its value over any [`crate::scalar::Number`]; [`text`] echoes it in
//! plain words; [`units`] finds the term whose dimension does not fit. This room knows nothing of LaTeX, of mechanics, or of what a claim is.

pub mod assignment;
pub mod evaluate;
pub mod shape;
pub mod symbols;
pub mod text;
pub mod tree;
pub mod units;
pub mod value;

pub use assignment::Assignment;
pub use evaluate::{Environment, Moving, Unavailable, evaluate};
pub use symbols::{Entry, Kind, SymbolId, Symbols};
pub use tree::{Expr, Function, Index, IndexId, Node, Relation, Sign, Statement, Term};
pub use value::Value;
