//! States that were found before: to move numbers onto hypotheses and laws takes most of the time of a claim that has
//! them, and every text that is tried in the place of an equation is judged at the same states.
//!
//! What is kept are the numbers of the states; a hit is what a search would find, as the stream of a claim depends on its
//! name and the seed alone.

use std::sync::{Arc, Mutex, PoisonError};

use super::draw::Reach;
use super::ensemble::Condition;
use super::scene::Mode;
use super::solver::Progress;

/// So many ensembles are kept.
const KEPT: usize = 256;

/// What the states of an ensemble depend on, beside the model.
#[derive(Clone, PartialEq)]
pub(super) struct Wanted {
    /// The name of the stream, with its seed.
    pub stream: (u64, String),
    /// How they are made.
    pub mode: Mode,
    /// How far out.
    pub reach: Reach,
    /// How many.
    pub points: usize,
    /// What they obey.
    pub conditions: Vec<Condition>,
}

/// What was found.
pub(super) struct Found {
    /// The numbers of each state.
    pub bases: Vec<Vec<f64>>,
    /// How many were tried.
    pub tried: usize,
    /// How they were moved onto the hypotheses.
    pub progress: Progress,
}

/// The states of a model that are known; those of a model made of it are others.
#[derive(Default)]
pub struct Drawn(Mutex<Vec<(Wanted, Arc<Found>)>>);

impl Clone for Drawn {
    fn clone(&self) -> Self {
        Drawn::default()
    }
}

impl Drawn {
    pub(super) fn find(&self, wanted: &Wanted) -> Option<Arc<Found>> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.iter().find(|(known, _)| known == wanted).map(|(_, found)| found.clone())
    }

    pub(super) fn keep(&self, wanted: Wanted, found: Found) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if known.len() < KEPT {
            known.push((wanted, Arc::new(found)));
        }
    }
}
