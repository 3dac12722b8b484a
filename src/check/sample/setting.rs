//! What a claim takes for granted, and how its states are made.

use crate::check::hypotheses::rule::Rule;
use crate::check::model::claim::Hypothesis;
use crate::check::model::sampling::{Mode, Spread};

/// What a claim takes for granted, and how its states are made.
#[derive(Clone, Debug)]
pub struct Setting<'c> {
    /// The hypotheses; on shell, the laws are added to them.
    pub hypotheses: &'c [Hypothesis],
    /// What symbols mean in this claim only.
    pub local: &'c [Rule],
    /// On shell or off, and how many derivatives.
    pub mode: Mode,
    /// How far from the declared ranges to draw.
    pub spread: Spread,
}

/// How many states a pass needs.
pub const FEWEST: usize = 8;
