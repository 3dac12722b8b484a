//! The claim that formulas solve an equation for an unknown, over a prime field.

use crate::formula::{Expr, SymbolId, Value};
use crate::scalar::prime_field::Modulus;
use crate::scalar::{Modular, Series};

use crate::check::certificate::claim::{Certificate, Claim, Differences, unavailable};
use crate::check::certificate::decide::decide;
use crate::check::model::claim::Link;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::state::sampled_state::SampledState;

/// Decides whether formulas solve a target equation for an unknown and, if asked, are all its solutions: as many as its
/// degree.
pub fn certify_solutions(
    target: &Link,
    unknown: SymbolId,
    branches: &[Expr],
    all_of_them: bool,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
) -> Certificate {
    let formulas: Vec<&Expr> = [&target.lhs, &target.rhs].into_iter().chain(branches).collect();
    decide(&formulas, context, ensemble, &Solutions { target, unknown, branches, all_of_them })
}

/// The claim that formulas solve an equation.
struct Solutions<'a> {
    target: &'a Link,
    unknown: SymbolId,
    branches: &'a [Expr],
    all_of_them: bool,
}

impl Claim for Solutions<'_> {
    fn differences<F: Modulus>(&self, state: &mut SampledState<'_, Modular<F>>) -> Differences<F> {
        let mut all = Vec::new();
        for branch in self.branches {
            let found = state.now(branch, &[]).map_err(|reason| unavailable(&reason, state.model()))?;
            let Value::Scalar(root) = found else {
                return Err("a solution that is not a scalar".to_owned());
            };
            all.extend(self.with(root, state)?);
        }
        if self.all_of_them {
            let higher = self.degree_exceeds(self.branches.len(), state)?;
            if !higher.iter().all(|difference| difference.vanishes()) {
                return Err("solutions that are counted only among the real numbers of the declared range".to_owned());
            }
            all.extend(higher);
        }
        Ok(all)
    }
}

impl Solutions<'_> {
    /// The differences of the target with a value for the unknown.
    fn with<F: Modulus>(&self, value: Modular<F>, state: &mut SampledState<'_, Modular<F>>) -> Differences<F> {
        state.set_only(&[(self.unknown, Series::constant(value))]);
        let found = self.target.differences(state);
        state.set_only(&[]);
        found
    }

    /// The finite differences of order `degree + 1` of the target in the unknown. They vanish for a polynomial of at
    /// most this degree.
    fn degree_exceeds<F: Modulus>(&self, degree: usize, state: &mut SampledState<'_, Modular<F>>) -> Differences<F> {
        let start = Modular::random();
        let columns = (0..=degree + 1).map(|step| self.with(start + step as f64, state));
        let columns: Vec<Vec<Modular<F>>> = columns.collect::<Result<_, _>>()?;
        let (mut sum, mut binomial) = (vec![Modular::from(0.0); columns[0].len()], 1.0);
        for (k, column) in columns.iter().enumerate() {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            for (sum, value) in sum.iter_mut().zip(column) {
                *sum += *value * (sign * binomial);
            }
            binomial = binomial * (degree + 1 - k.min(degree + 1)) as f64 / (k + 1) as f64;
        }
        Ok(sum)
    }
}
