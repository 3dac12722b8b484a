//! Sampled states that are kept, so that constraint projection is not repeated.
//!
//! What is kept are the numbers of the states. A kept state is the one that would be drawn again, since the stream
//! of a claim depends only on its name and the seed.
//!
//! Constraint projection takes most of the time of a check. So the states of a model are kept, and every text is
//! judged at the same ones.

use std::sync::{Arc, Mutex, PoisonError};

use crate::check::model::claim::Hypothesis;

/// What a projection has learnt from the states that it has moved.
#[derive(Clone, Default)]
pub struct Progress {
    /// Which row is solved for which slot; found at the first state that works.
    pub(crate) plan: Vec<(Row, usize)>,
    /// How many states were accepted.
    pub(crate) accepted: usize,
    /// How many bases could not be moved onto the hypotheses, and how many could.
    pub(crate) moved: (usize, usize),
    /// Whether there is more to solve than is solved.
    pub(crate) hopeless: bool,
}

impl Progress {
    /// Whether no base could be moved onto the hypotheses so far.
    pub(crate) fn is_stuck(&self) -> bool {
        self.moved.1 == 0
    }
}

/// The `derivative`-th time derivative of the `hypothesis`-th hypothesis, one entry of it.
pub(crate) type Row = (usize, usize, usize);

/// How states are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mode {
    /// Whether the accelerations obey the Euler–Lagrange equations, and the laws hold.
    pub on_shell: bool,
    /// The highest time derivative that is known.
    pub order: usize,
}

/// How far from the declared ranges numbers are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Within them; numbers without a range of their own are of order one.
    Declared,
    /// Within them, and of order one where they reach so far in.
    Near,
    /// Beyond them too.
    Beyond,
    /// Within them; numbers without a range of their own are of any order, and ends of ranges are met.
    Vast,
    /// Within them, and all over them: numbers of any order, angles of many turns.
    Wide,
}

/// So many ensembles are kept.
const KEPT: usize = 256;

/// What the states of an ensemble depend on, beside the model.
#[derive(Clone, PartialEq)]
pub(crate) struct CacheKey {
    /// The name of the stream, with its seed.
    pub stream: (u64, String),
    /// How they are made.
    pub mode: Mode,
    /// How far out.
    pub reach: Reach,
    /// How many.
    pub points: usize,
    /// What they obey.
    pub hypotheses: Vec<Hypothesis>,
}

/// What was found.
pub(crate) struct CachedStates {
    /// The numbers of each state.
    pub bases: Vec<Vec<f64>>,
    /// How many were tried.
    pub tried: usize,
    /// How they were moved onto the hypotheses.
    pub progress: Progress,
}

/// The states of a model that are known; those of a model made of it are others.
#[derive(Default)]
pub struct StateCache(Mutex<Vec<(CacheKey, Arc<CachedStates>)>>);

impl Clone for StateCache {
    fn clone(&self) -> Self {
        StateCache::default()
    }
}

impl StateCache {
    pub(crate) fn find(&self, wanted: &CacheKey) -> Option<Arc<CachedStates>> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.iter().find(|(known, _)| known == wanted).map(|(_, found)| found.clone())
    }

    pub(crate) fn keep(&self, wanted: CacheKey, found: CachedStates) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if known.len() < KEPT {
            known.push((wanted, Arc::new(found)));
        }
    }
}
