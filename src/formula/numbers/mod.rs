//! What values are made of beside real numbers: complex numbers, and functions of matrices, over any number.
//!
//! Offers `complex` and `matrices`. Knows `scalar`, and the names of functions in the tree.

pub mod complex;
pub mod matrices;
