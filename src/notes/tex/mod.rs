//! Displays in a TeX file. The scan knows only comments, verbatim text and mathematics.
//!
//! Offers `scan`, the displays with their places, and `automatic`, the numbers that LaTeX prints beside rows.

mod environments;
mod numbering;
mod scan;

pub(super) use numbering::automatic;
pub(super) use scan::{scan, verbatim_end};
