//! The setting of a claim's states: what they obey, and how they are drawn.

use crate::check::hypotheses::rule::Rule;
use crate::check::model::claim::Hypothesis;
use crate::check::model::sampling::{Mode, Spread};

/// The setting of a claim's states: what they obey, and how they are drawn.
#[derive(Clone, Debug)]
pub struct Setting<'c> {
    /// The hypotheses; on shell, the laws are added to them.
    pub hypotheses: &'c [Hypothesis],
    /// The rules of symbols that are defined in this claim only.
    pub local: &'c [Rule],
    /// On shell or off shell, with the number of derivatives.
    pub mode: Mode,
    /// How wide the ranges are.
    pub spread: Spread,
    /// The most work that may go into solving the hypotheses, in values of rows.
    pub effort: usize,
}

/// The least number of states for a pass.
pub const FEWEST: usize = 8;
