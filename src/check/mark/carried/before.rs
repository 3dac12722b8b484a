//! What stands before a line: the lines by their displays, and what the problem knows of the motion.

use crate::notes::claims::Claim;

use crate::check::mark::motion::Motion;
use crate::check::mark::special::Special;

/// The lines before a line, by their displays.
pub(in crate::check::mark) struct Before<'b> {
    /// All.
    pub all: &'b [usize],
    /// Those that are false.
    pub wrong: &'b [usize],
    /// Those that hold.
    pub sound: &'b [usize],
    /// The laws of the problem.
    pub laws: &'b [usize],
    /// The motion of the problem.
    pub motion: &'b Motion,
    /// The special states of the problem.
    pub special: &'b Special,
    /// The hypotheses and kinds of claims of the problem.
    pub contexts: &'b [Claim],
}
