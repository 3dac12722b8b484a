//! The states at which a claim is tested: drawn at random and projected onto the claim's hypotheses.
//!
//! A hypothesis `A = B` is solved for one number of the base. Numbers in which it is linear go first; then higher
//! derivatives go before velocities, coordinates and constants. A hypothesis under `assuming` holds at the instant.
//! Under `throughout` its time derivatives vanish too: each is solved for a further number, or vanishes by itself.
//! Inequalities reject states; where too few are left, [`super::inequalities`] moves numbers to where they hold.
//!
//! # Why inequalities get special states
//!
//! Inequalities are not compared with mutants: a weaker inequality holds too, and is no mistake. What hides a fault
//! is that random states are typical. So inequalities are also tested at special states: one number zero, of the
//! other sign, 10³ and 10⁻³ times as large, or at an end of its range; and on shell too, since the motions are
//! among all states and may be where it fails.

use std::sync::Arc;

use crate::code::Code;
use crate::notes::claims::Range;
use crate::scalar::RunningError;
use crate::{Error, Result};

use crate::check::hypotheses::rule::Rule;
use crate::check::model::Model;
use crate::check::model::sampling::Mode;
use crate::check::model::state_cache::{CacheKey, CachedStates};
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::{Sampler, contains};
use crate::check::sample::setting::{FEWEST, Setting};
use crate::check::sample::special::{Place, of_groups};
use crate::check::state::sampled_state::SampledState;

/// The number of states for which memory is reserved at most.
const USUAL: usize = 128;

/// The number of failed projections after which a request for a few states is given up.
const FEW_ATTEMPTS: usize = 4;

/// The number of states that inequalities may reject beside three for each that is wanted; after that bases are moved into them.
const FEW_REJECTED: usize = 24;

/// States that obey a setting.
pub struct Ensemble<'m> {
    /// The states.
    pub states: Vec<SampledState<'m, RunningError>>,
    /// The base of each.
    pub bases: Vec<Vec<f64>>,
    /// The number of states that were tried.
    pub tried: usize,
    /// Their mode.
    pub mode: Mode,
    /// The rules of the hypotheses.
    pub rules: Arc<[Rule]>,
    /// The projection onto the hypotheses.
    pub projection: Projection<'m>,
}

impl<'m> Ensemble<'m> {
    /// Draws `points` states; there may be fewer if the hypotheses are hard to satisfy.
    ///
    /// # Errors
    /// If there is no state because the mass matrix is singular at all of them.
    pub fn draw(model: &'m Model, setting: &Setting<'_>, points: usize, draw: &mut Sampler) -> Result<Self> {
        let mode = setting.mode;
        let mut projection = Projection::new(model, setting);
        let (mut states, mut bases, mut tried) = (Vec::with_capacity(points.min(USUAL)), Vec::new(), 0);
        let mut failure: Option<Error> = None;
        let is_given_up = |projection: &Projection<'_>, tried: usize| {
            projection.record.hopeless || points < FEWEST && tried == FEW_ATTEMPTS && projection.record.is_stuck()
        };
        while states.len() < points && tried < 4 * points + 32 && !is_given_up(&projection, tried) {
            tried += 1;
            let mut base = draw.draw_base(&projection.slots, setting.spread);
            if tried > 3 * points + FEW_REJECTED {
                projection.move_into_inequalities(&mut base);
            }
            match projection.project(base) {
                Ok(Some((base, state))) => {
                    states.push(state);
                    bases.push(base);
                }
                Ok(None) => {}
                // L has no value there.
                Err(error) if error.code() == Code::NoState => {}
                Err(error) => failure = Some(error),
            }
        }
        match failure {
            Some(error) if states.is_empty() => Err(error),
            _ => Ok(Ensemble { states, bases, tried, mode, rules: projection.rules.clone(), projection }),
        }
    }
}

impl<'m> Ensemble<'m> {
    /// The states that [`Ensemble::draw`] gives for a stream of this name. States with hypotheses to solve are cached.
    ///
    /// # Errors
    /// As there.
    pub fn named(model: &'m Model, setting: &Setting<'_>, points: usize, seed: u64, name: &str) -> Result<Self> {
        let draw = |draw: &mut Sampler| Self::draw(model, setting, points, draw);
        Self::kept(model, setting, points, (seed, name), draw)
    }

    /// The cached states of this name, or those that are found now. States without hypotheses to solve are not cached.
    fn kept(
        model: &'m Model,
        setting: &Setting<'_>,
        points: usize,
        (seed, name): (u64, &str),
        find: impl FnOnce(&mut Sampler) -> Result<Self>,
    ) -> Result<Self> {
        let mut projection = Projection::new(model, setting);
        let mut draw = Sampler::new(seed, name);
        // The key has no definitions of one claim, so states with them are not cached.
        if projection.equalities().next().is_none() || !setting.local.is_empty() {
            return find(&mut draw);
        }
        let Setting { mode, spread, .. } = *setting;
        let stream = (seed, name.to_owned());
        let wanted = CacheKey { stream, mode, spread, points, hypotheses: setting.hypotheses.to_vec() };
        let Some(found) = model.state_cache.find(&wanted) else {
            let ensemble = find(&mut draw)?;
            let Ensemble { bases, tried, projection, .. } = &ensemble;
            let found = CachedStates { bases: bases.clone(), tried: *tried, record: projection.record.clone() };
            model.state_cache.keep(wanted, found);
            return Ok(ensemble);
        };
        projection.record = found.record.clone();
        let states = found.bases.iter().map(|base| projection.measured(base)).collect::<Result<_>>()?;
        let (bases, tried) = (found.bases.clone(), found.tried);
        Ok(Ensemble { states, bases, tried, mode, rules: projection.rules.clone(), projection })
    }

    /// States at special places. Each number of the base in turn is far larger or smaller than the others, zero, of the
    /// other sign, at an end of its range, or equal or opposite to another. Further states are at rest.
    ///
    /// # Errors
    /// If the mass matrix is singular at all of them.
    pub fn special(model: &'m Model, setting: &Setting<'_>, seed: u64, name: &str) -> Result<Self> {
        Self::kept(model, setting, 0, (seed, name), |draw| Self::at_special_places(model, setting, draw))
    }

    fn at_special_places(model: &'m Model, setting: &Setting<'_>, draw: &mut Sampler) -> Result<Self> {
        let mode = setting.mode;
        let mut projection = Projection::new(model, setting);
        let (mut states, mut bases, mut tried) = (Vec::new(), Vec::new(), 0);
        let single: Vec<usize> = (1..projection.slots.len()).filter(|at| !projection.slots[*at].one_of_many).collect();
        let mut places: Vec<Place> = Vec::new();
        for &at in &single {
            places.extend([1e3, 1e-3, 0.0, -1.0].map(|factor| Place::Times(at, factor)));
            if let Range::Interval { low, high, .. } = projection.slots[at].range {
                places.extend([Place::At(at, low), Place::At(at, high)]);
            }
            let alike = |other: &&usize| projection.slots[**other].order == projection.slots[at].order && **other < at;
            for &other in single.iter().filter(alike) {
                places.extend([Place::Like(at, other, 1.0), Place::Like(at, other, -1.0)]);
            }
        }
        places.extend([Place::AtRest, Place::AllZero]);
        places.extend(of_groups(model, &projection.slots));
        for place in places {
            // Hypotheses may exclude one state at a place and allow another.
            for _ in 0..8 {
                if projection.record.hopeless {
                    break;
                }
                tried += 1;
                let mut base = draw.draw_base(&projection.slots, setting.spread);
                place.set(&mut base, &projection.slots);
                if projection.slots.iter().zip(&base).all(|(slot, value)| contains(&slot.range, *value))
                    && let Ok(Some((base, state))) = projection.project(base)
                {
                    states.push(state);
                    bases.push(base);
                    break;
                }
            }
        }
        Ok(Ensemble { states, bases, tried, mode, rules: projection.rules.clone(), projection })
    }
}
