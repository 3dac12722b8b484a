//! The commands about one system, or notes that define a Lagrangian: what follows from it, and pictures of it.

pub(super) mod derive;
pub(super) mod plot;
pub(super) mod subject;
