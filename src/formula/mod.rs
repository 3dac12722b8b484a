//! The content of an equation, apart from how it was typeset.
//!
//! | file | content |
//! | --- | --- |
//! | [`tree`] | the formula as a tree; each node keeps the bytes that it was read from |
//! | [`symbols`] | the symbol table: name, kind and indices of each symbol |
//! | [`shape`] | the type check: scalar, vector or matrix, and the free indices; makes implied sums explicit |
//! | [`environment`], [`mod@evaluate`] | the value of a formula over any [`crate::scalar::Number`] |
//! | [`assignment`] | an environment with values given by hand |
//! | [`text`] | the formula in readable Unicode |
//! | [`units`] | dimensional analysis: the term whose unit does not fit |
//!
//! This folder may import [`crate::scalar`], [`crate::source`] and [`crate::suggest`]. It knows nothing of LaTeX, of
//! mechanics, or of claims.

pub mod assignment;
pub mod environment;
pub mod evaluate;
mod ids;
pub mod shape;
pub mod symbols;
pub mod text;
pub mod tree;
pub mod units;
pub mod value;

pub use assignment::Assignment;
pub use environment::{Differentiable, Environment, Unavailable};
pub use evaluate::evaluate;
pub use ids::{Index, IndexId, SymbolId};
pub use symbols::{Kind, Symbols};
pub use tree::{Expr, Function, Node, Relation, Sign, Statement, Term};
pub use value::Value;
