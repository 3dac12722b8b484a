//! The commands that write pages to read in a browser: once, and after each save.
//!
//! Offers `run` of each command. Knows `page`, `check` and `files`.

pub(super) mod report;
mod serve;
pub(super) mod watch;
