//! The commands for lectures and classes: derivations line by line, pages, pictures, marks, and pages that follow each save.

pub(super) mod derive;
pub(super) mod mark;
pub(super) mod plot;
pub(super) mod report;
mod serve;
mod subject;
pub(super) mod watch;
