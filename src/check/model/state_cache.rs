//! A cache of sampled states.
//!
//! Constraint projection takes most of the time of a claim with hypotheses or laws, and every text that is tried in the
//! place of an equation is tested at the same states. The cache keeps the numbers of the states. A hit gives what a new
//! search would give, since the random stream of a claim depends on its name and the seed alone.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use crate::check::model::claim::Hypothesis;
use crate::check::model::sampling::{Mode, Spread};

/// What a projection knows from the states that it has projected so far.
#[derive(Clone, Default)]
pub struct ProjectionRecord {
    /// Which row is solved for which slot, as found at the first state.
    pub(crate) plan: Vec<(Row, usize)>,
    /// The number of states that were accepted.
    pub(crate) accepted: usize,
    /// The numbers of bases that could not be projected onto the hypotheses, and that could.
    pub(crate) moved: (usize, usize),
    /// Whether the search has been given up: there are too many equations, or no base could be projected.
    pub(crate) hopeless: bool,
    /// How many bases failed at each hypothesis, by its place among the hypotheses.
    pub(crate) unmet: BTreeMap<usize, usize>,
}

impl ProjectionRecord {
    /// Whether no base could be projected onto the hypotheses so far.
    pub(crate) fn is_stuck(&self) -> bool {
        self.moved.1 == 0
    }

    /// Counts a base that failed at a hypothesis.
    pub(crate) fn fails_at(&mut self, hypothesis: usize) {
        *self.unmet.entry(hypothesis).or_insert(0) += 1;
    }
}

/// One scalar equation: the place of the hypothesis, the order of its time derivative, and the entry.
pub(crate) type Row = (usize, usize, usize);

/// The largest number of ensembles that are kept.
const KEPT: usize = 256;

/// Everything that the states of an ensemble depend on, beside the model.
#[derive(Clone, PartialEq)]
pub(crate) struct CacheKey {
    /// The seed and the name of the random stream.
    pub stream: (u64, String),
    /// On shell or off, with the number of derivatives.
    pub mode: Mode,
    /// How wide the ranges are.
    pub spread: Spread,
    /// The number of states that were asked for.
    pub points: usize,
    /// The hypotheses that the states obey.
    pub hypotheses: Vec<Hypothesis>,
}

/// The states of a key.
pub(crate) struct CachedStates {
    /// The numbers of each state.
    pub bases: Vec<Vec<f64>>,
    /// The number of states that were tried.
    pub tried: usize,
    /// What the projection onto the hypotheses had learnt.
    pub record: ProjectionRecord,
}

/// The states of one model that are known. A clone is empty, since a changed model has other states.
#[derive(Default)]
pub struct StateCache(Mutex<Vec<(CacheKey, Arc<CachedStates>)>>);

impl Clone for StateCache {
    fn clone(&self) -> Self {
        StateCache::default()
    }
}

impl StateCache {
    /// The states of a key, if they are known.
    pub(crate) fn find(&self, wanted: &CacheKey) -> Option<Arc<CachedStates>> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.iter().find(|(known, _)| known == wanted).map(|(_, found)| found.clone())
    }

    /// Keeps the states of a key while there is space.
    pub(crate) fn keep(&self, wanted: CacheKey, found: CachedStates) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if known.len() < KEPT {
            known.push((wanted, Arc::new(found)));
        }
    }
}
