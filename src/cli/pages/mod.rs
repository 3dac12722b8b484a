//! The commands that write pages to read in a browser: once, and after each save.

pub(super) mod report;
mod serve;
pub(super) mod watch;
