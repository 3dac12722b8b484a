//! The commands for lectures and classes: derivations line by line, pages, pictures, marks.

pub(super) mod derive;
pub(super) mod mark;
pub(super) mod plot;
pub(super) mod report;
