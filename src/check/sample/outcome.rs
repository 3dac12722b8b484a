//! The outcome of testing a claim at a set of sampled states.

use crate::Result;
use crate::formula::evaluate::Unavailable;
use crate::scalar::RunningError;

use crate::check::model::claim::Link;
use crate::check::state::residual;
use crate::check::state::residual::{Failure, Point};
use crate::check::state::sampled_state::SampledState;

/// The outcome of testing a link at a set of states.
pub struct Outcome {
    /// The number of states at which both sides have a value and the result is clear.
    pub points: usize,
    /// The largest relative residual among the states at which it holds.
    pub residual: f64,
    /// The clearest failure, and the place of the state.
    pub failure: Option<(Failure, usize)>,
    /// A state at which only one side is defined, and its place.
    pub one_sided: Option<(Failure, usize)>,
    /// The number of states at which the sides differ by more than rounding error and by less than a clear difference.
    pub doubtful: usize,
}

/// Tests a link at all states.
pub fn run(link: &Link, states: &[SampledState<'_, RunningError>]) -> Result<Outcome, Unavailable> {
    gathered(states.len(), |at| residual::test(link, &states[at]))
}

/// The outcome of a test at this number of states.
pub(crate) fn gathered(
    states: usize,
    test: impl Fn(usize) -> Result<Point, Unavailable>,
) -> Result<Outcome, Unavailable> {
    let mut outcome = Outcome { points: 0, residual: 0.0, failure: None, one_sided: None, doubtful: 0 };
    for at in 0..states {
        match test(at)? {
            Point::Holds(residual) => {
                outcome.points += 1;
                outcome.residual = outcome.residual.max(residual);
            }
            Point::Fails(failure) => {
                outcome.points += 1;
                let clearer = |(known, _): &(Failure, usize)| failure.residual > known.residual;
                if outcome.failure.as_ref().is_none_or(clearer) {
                    outcome.failure = Some((failure, at));
                }
            }
            Point::OneSided(failure) => outcome.one_sided = Some((failure, at)),
            Point::Doubtful => outcome.doubtful += 1,
            Point::Useless => {}
        }
    }
    Ok(outcome)
}
