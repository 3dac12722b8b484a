//! What is typeset reads back to the numbers that automatic differentiation gives: for every system, and all that can be
//! asked of it.

#[path = "derive/support.rs"]
mod support;

#[path = "derive/checked.rs"]
mod checked;
#[path = "derive/differences.rs"]
mod differences;
#[path = "derive/printed.rs"]
mod printed;
#[path = "derive/values.rs"]
mod values;
