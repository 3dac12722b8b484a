//! What values are made of beside real numbers: complex numbers, and functions of matrices, over any number.

pub mod complex;
pub mod matrices;
