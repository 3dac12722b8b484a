//! The residual of a hypothesis at a state, with its time derivatives.

use crate::Result;
use crate::formula::evaluate::{Unavailable, evaluate_to};
use crate::formula::{Expr, IndexId, Relation, Sign, Value};
use crate::scalar::{Number, Series, cross};

use crate::check::model::claim::Hypothesis;
use crate::check::state::residual;
use crate::check::state::sampled_state::SampledState;

/// The largest number of time derivatives of a hypothesis under `throughout` that are made to vanish.
pub(crate) const THROUGHOUT: usize = 3;

/// The residual lhs − rhs, entry by entry, for all values of the free indices, with the derivatives that must vanish.
pub(crate) fn difference<B: Number>(
    state: &SampledState<'_, B>,
    hypothesis: &Hypothesis,
) -> Result<Vec<Series<B>>, Unavailable> {
    difference_to((THROUGHOUT + 1, usize::MAX), state, hypothesis)
}

/// The residual to this number of terms, for at least this number of entries.
pub(crate) fn difference_to<B: Number>(
    (terms, entries): (usize, usize),
    state: &SampledState<'_, B>,
    hypothesis: &Hypothesis,
) -> Result<Vec<Series<B>>, Unavailable> {
    let mut indices: Vec<(IndexId, u8)> = hypothesis.free.iter().map(|id| (*id, 1)).collect();
    let terms = if hypothesis.throughout { terms } else { 1 };
    let mut all = Vec::new();
    let (lhs, rhs) = (&hypothesis.lhs, &hypothesis.rhs);
    loop {
        if terms == 1 {
            let sides = (state.instant(lhs, &indices)?, state.instant(rhs, &indices)?);
            all.extend(apart(sides, hypothesis)?.into_iter().map(|x| Series::of_value(x.0)));
        } else {
            let side = |side: &Expr| evaluate_to(terms, side, state, &indices);
            all.extend(apart((side(lhs)?, side(rhs)?), hypothesis)?);
        }
        if all.len() >= entries || !residual::advance(&mut indices, state)? {
            return Ok(all);
        }
    }
}

/// The numbers that vanish if a hypothesis holds: the difference, or the cross product for `∝`.
fn apart<D: Number>((lhs, rhs): (Value<D>, Value<D>), hypothesis: &Hypothesis) -> Result<Vec<D>, Unavailable> {
    Ok(match (lhs, rhs) {
        (Value::Vector(a), Value::Vector(b)) if hypothesis.relation == Relation::Proportional => {
            cross(&a, &b).as_slice().to_vec()
        }
        (Value::Scalar(a), Value::Scalar(b)) => vec![a - b],
        (mut a, b) if a.shape() == b.shape() => {
            a.add(&b, Sign::Minus);
            a.entries()
        }
        (a, _) if hypothesis.rhs.is_zero() => a.entries(),
        _ => return Err(Unavailable::Operation("a hypothesis whose sides have different shapes")),
    })
}
