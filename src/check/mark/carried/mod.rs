//! Follow-through: the false line before it from which a false line follows.
//!
//! Offers `origin`, the false line from which a line follows, with what stands before the line (`Before`). Knows `steps`, `document`
//! and below, and of `mark` the letters and the motion.

mod about_rest;
mod another_value;
mod before;
mod change;
mod derived;
pub(super) mod energies;
mod freed;
mod modes;
pub(super) mod numbers;
mod origin;
mod redefined;
mod step;

pub(super) use before::Before;
pub(super) use origin::origin;
