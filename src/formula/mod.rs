//! The content of an equation, apart from how it was typeset.
//!
//! | file | content |
//! | --- | --- |
//! | [`tree`] | the formula as a tree; each node keeps the bytes that it was read from |
//! | [`symbols`] | the symbol table: name, kind and indices of each symbol |
//! | [`shape`] | the type check: scalar, vector or matrix, and the free indices; makes implied sums explicit |
//! | [`environment`], [`mod@evaluate`] | the value of a formula over any [`crate::scalar::Number`] |
//! | [`assignment`] | an environment with values given by hand |
//! | [`derivative`] | the derivative of a formula as a formula |
//! | [`calculus`] | integrals and sums as formulas |
//! | [`text`], `glyphs` | the formula in readable Unicode |
//! | `operators` | functions, relations, and operators that have no formula |
//! | [`units`] | dimensional analysis: the term whose unit does not fit |
//!
//! This folder may import [`crate::scalar`], [`crate::source`] and [`crate::suggest`]. It knows nothing of LaTeX, of
//! mechanics, or of claims.
//!
//! Offers [`Expr`] and [`Symbols`], and in each file what is done with them.

#[cfg(feature = "notes")]
pub mod assignment;
#[cfg(feature = "notes")]
pub mod calculus;
#[cfg(feature = "notes")]
pub mod derivative;
#[cfg(feature = "notes")]
pub mod environment;
#[cfg(feature = "notes")]
pub mod evaluate;
mod glyphs;
mod ids;
mod name;
#[cfg(feature = "notes")]
pub mod numbers;
#[cfg(feature = "notes")]
mod operations;
#[cfg(feature = "notes")]
mod operator_shapes;
pub mod operators;
#[cfg(feature = "notes")]
pub mod shape;
pub mod symbols;
pub mod text;
pub mod tree;
pub mod units;
#[cfg(feature = "notes")]
pub mod value;

#[cfg(feature = "notes")]
pub use assignment::Assignment;
#[cfg(feature = "notes")]
pub use environment::{Differentiable, Environment, Unavailable};
#[cfg(feature = "notes")]
pub use evaluate::evaluate;
pub use ids::SymbolId;
#[cfg(feature = "notes")]
pub use ids::{Index, IndexId};
#[cfg(feature = "notes")]
pub use symbols::Kind;
pub use symbols::Symbols;
pub use tree::{Expr, Function, Node, Relation, Sign, Statement, Term};
#[cfg(feature = "notes")]
pub use value::Value;
