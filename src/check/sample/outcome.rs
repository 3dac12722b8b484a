//! What a set of sampled states says of a claim.

use crate::Result;
use crate::formula::evaluate::Unavailable;
use crate::scalar::RunningError;

use crate::check::model::claim::Link;
use crate::check::state::residual;
use crate::check::state::residual::{Failure, Point};
use crate::check::state::sampled_state::SampledState;

/// What a set of states says of a link.
pub struct Outcome {
    /// The states at which it could be judged.
    pub points: usize,
    /// The largest relative residual where it holds.
    pub residual: f64,
    /// The clearest failure, and the state.
    pub failure: Option<(Failure, usize)>,
    /// A state at which one side alone is defined.
    pub one_sided: Option<(Failure, usize)>,
    /// The states at which the sides differ by too little to call it a difference.
    pub doubtful: usize,
}

/// Tests a link at all states.
pub fn run(link: &Link, states: &[SampledState<'_, RunningError>]) -> Result<Outcome, Unavailable> {
    gathered(states.len(), |at| residual::test(link, &states[at]))
}

/// What so many states say.
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
