//! A claim at sampled states, with cached values of its sides, since each mutant shares one of them.

use std::cell::{Cell, OnceCell};

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::Unavailable;
use crate::scalar::RunningError;

use crate::check::judge::mutants::{Mutant, mutants_of};
use crate::check::model::claim::Link;
use crate::check::model::sampling::Mode;
use crate::check::sample::context::Context;
use crate::check::sample::enclosed;
use crate::check::sample::outcome::{Outcome, gathered};
use crate::check::sample::projection::Projection;
use crate::check::state::residual;
use crate::check::state::residual::{Point, Sides};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// A link at sampled states, with the values of its sides as far as they were needed.
pub(crate) struct AtStates<'a, 'm> {
    pub(crate) link: &'a Link,
    pub(crate) states: &'a [SampledState<'m, RunningError>],
    sides: Vec<OnceCell<Option<Sides>>>,
}

impl<'a, 'm> AtStates<'a, 'm> {
    pub(crate) fn new(link: &'a Link, states: &'a [SampledState<'m, RunningError>]) -> Self {
        AtStates { link, states, sides: states.iter().map(|_| OnceCell::new()).collect() }
    }

    fn sides(&self, at: usize) -> Option<&Sides> {
        self.sides[at].get_or_init(|| Sides::of(self.link, &self.states[at]).ok()).as_ref()
    }

    /// Tests the link itself at all states. Where doubles may err, it is decided with more digits; one certain failure
    /// is enough.
    pub(crate) fn run(&self, projection: &Projection<'_>) -> Result<Outcome, Unavailable> {
        let is_refuted = Cell::new(false);
        gathered(self.states.len(), |at| {
            let state = &self.states[at];
            let point = match self.sides(at) {
                Some(sides) => residual::test_sides(self.link, sides, state),
                None => residual::test(self.link, state),
            }?;
            if is_refuted.get() {
                return Ok(point);
            }
            let point = enclosed::settled(point, self.link, state, projection);
            is_refuted.set(matches!(point, Point::Fails(_)));
            Ok(point)
        })
    }

    /// Tests a mutant at one of the states.
    pub(crate) fn test(&self, mutant: &Link, at: usize) -> Result<Point, Unavailable> {
        residual::test_mutant(mutant, self.link, self.sides(at), &self.states[at])
    }

    /// Whether a mutant fails at one of the states. It also fails where it has no value.
    fn fails(&self, mutant: &Link) -> bool {
        (0..self.states.len()).any(|at| !matches!(self.test(mutant, at), Ok(Point::Holds(_) | Point::Useless)))
    }
}

/// The finding on a claim that passed: undecided if a mutant that is not equivalent to the claim passes as well.
pub(crate) fn tested_against_mutants(
    states: &AtStates<'_, '_>,
    context: &Context<'_>,
    mode: Mode,
    finding: Finding,
) -> Result<Finding> {
    let link = states.link;
    let survivors: Vec<Mutant> =
        mutants_of(link, context.model).into_iter().filter(|mutant| !states.fails(&mutant.link)).collect();
    if survivors.is_empty() {
        return Ok(finding);
    }
    // A mutant that holds and fails exactly where the claim does, also far beyond the ranges, is equivalent to it.
    let wide = context.ensemble(mode, true, 3 * context.options.points)?;
    let holds = |found: Result<Point, Unavailable>| match found {
        Ok(Point::Holds(_)) => Some(true),
        Ok(Point::Useless) => None,
        _ => Some(false),
    };
    let states = AtStates::new(link, &wide.states);
    let itself: Vec<Option<bool>> = (0..wide.states.len()).map(|at| holds(states.test(link, at))).collect();
    for mutant in survivors {
        let told_apart = |(at, itself): (usize, &Option<bool>)| match (itself, holds(states.test(&mutant.link, at))) {
            (Some(a), Some(b)) => *a != b,
            _ => false,
        };
        if itself.iter().enumerate().any(told_apart) {
            let message = format!(
                "the sampled states do not distinguish this from the same claim with {}; widen the ranges, or remove a \
                 hypothesis",
                mutant.change
            );
            return Ok(finding.replaced(Code::MutantPasses, Verdict::Undecided, message));
        }
    }
    Ok(finding)
}
