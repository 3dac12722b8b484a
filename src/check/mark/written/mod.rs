//! The lines of a hand-in: the statements of its displays, the rows of its chains, and the equations in its text.
//!
//! Offers `written`, the lines ([`Written`]) in their order, and what `accelerations`, `energies`, `functions`,
//! `groups`, `instants`, `signs`, `single_letters`, `slashes`, `slopes` and `units` change in them before they are read. Knows `usage`,
//! and LaTeX and notes.

pub(super) mod accelerations;
pub(super) mod energies;
pub(super) mod functions;
pub(super) mod groups;
pub(super) mod instants;
mod lines;
pub(super) mod signs;
pub(super) mod single_letters;
pub(super) mod slashes;
pub(super) mod slopes;
pub(super) mod units;

pub(super) use lines::{Written, written};
