//! **onshell** checks the equations in physics notes against what automatic differentiation derives.
#![warn(missing_docs)]
#![forbid(unsafe_code)]

pub mod check;
pub mod cli;
pub mod error;
pub mod formula;
pub mod latex;
pub mod mechanics;
pub mod notes;
pub mod report;
pub mod scalar;
pub mod source;
pub mod suggest;
pub mod systems;

pub use error::{Error, Result};
