//! The commands about one system, or notes that define a Lagrangian: what follows from it, and pictures of it.
//!
//! Offers `run` of each command, and `subject`, the system that a command is about. Knows `derive`, `lecture`, `plot`, `check` and `files`.

pub(super) mod derive;
pub(super) mod plot;
pub(super) mod subject;
