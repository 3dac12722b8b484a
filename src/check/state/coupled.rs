//! Coupled laws, solved at a state as a system of linear equations for the highest derivatives.

use nalgebra::DMatrix;

use crate::formula::evaluate::{ALL, Unavailable, evaluate_to};
use crate::formula::{Expr, SymbolId, Value};
use crate::mechanics::solve_with;
use crate::scalar::{Number, Series};

use crate::check::hypotheses::rule::CoupledLaws;
use crate::check::state::sampled_state::SampledState;
use crate::check::state::values::Valued;

impl<B: Number> SampledState<'_, B> {
    /// The value of a symbol that coupled laws give, as a series in time.
    pub(crate) fn together(&self, laws: &CoupledLaws, id: SymbolId) -> Valued<B> {
        let none = || Unavailable::Symbol(id);
        let known = |known: &[(SymbolId, Vec<Value<Series<B>>>)]| {
            known.iter().find(|(symbol, _)| *symbol == id).and_then(|(_, members)| members.first().cloned())
        };
        if let Some(partial) = known(&self.memo.following.borrow()) {
            return Ok(partial);
        }
        if let Some(found) = self.memo.followed.borrow().get(&id).and_then(|members| members.first().cloned()) {
            return Ok(found);
        }
        let (mut jets, mut terms) = (Vec::new(), usize::MAX);
        for (symbol, order) in &laws.unknowns {
            let own = self.rules.iter().position(|rule| rule.symbol == *symbol).ok_or_else(none)?;
            let Value::Scalar(free) = self.ruled(*symbol, &[], own, ALL)? else { return Err(none()) };
            terms = terms.min(free.known().saturating_sub(usize::from(*order)));
            let lower = (0..usize::from(*order)).map(|n| free.nth_derivative_value(n).ok_or_else(none));
            jets.push(lower.collect::<Result<Vec<B>, _>>()?);
        }
        let mut matrix = None;
        for level in 0..terms {
            let with = |unknown: Option<usize>| {
                let next = |at| if unknown == Some(at) { B::one() } else { B::zero() };
                let jets: Vec<Vec<B>> =
                    jets.iter().enumerate().map(|(at, jet)| [jet.as_slice(), &[next(at)]].concat()).collect();
                self.off_by(laws, &jets, level)
            };
            let rest = with(None)?;
            if matrix.is_none() {
                let columns = (0..rest.len()).map(|at| with(Some(at))).collect::<Result<Vec<_>, _>>()?;
                matrix = Some(DMatrix::from_fn(rest.len(), rest.len(), |i, j| columns[j][i] - rest[i]));
            }
            let right = rest.iter().map(|value| -*value).collect();
            let next = matrix.clone().and_then(|matrix| solve_with(self.system.solver(), "laws", matrix, right).ok());
            jets.iter_mut().zip(next.ok_or_else(none)?).for_each(|(jet, next)| jet.push(next));
        }
        let series = |jet: &Vec<B>| Value::Scalar(Series::from_derivatives(jet));
        let at = laws.unknowns.iter().position(|(symbol, _)| *symbol == id).ok_or_else(none)?;
        if self.memo.following.borrow().is_empty() {
            let found = laws.unknowns.iter().zip(&jets).map(|((symbol, _), jet)| (*symbol, vec![series(jet)]));
            self.memo.followed.borrow_mut().extend(found);
        }
        Ok(series(&jets[at]))
    }

    /// The residuals of the time derivatives, of some order, of the laws, with these derivatives of the unknowns.
    fn off_by(&self, laws: &CoupledLaws, jets: &[Vec<B>], order: usize) -> Result<Vec<B>, Unavailable> {
        let wrong = || Unavailable::Operation("a law that is not an equation between scalars");
        let others = self.memo.following.borrow().len();
        let known = laws.unknowns.iter().zip(jets);
        let known = known.map(|((symbol, _), jet)| (*symbol, vec![Value::Scalar(Series::from_derivatives(jet))]));
        self.memo.following.borrow_mut().extend(known);
        self.memo.forget_values();
        let side = |side: &Expr| match evaluate_to(order + 1, side, self, &[])? {
            Value::Scalar(value) => value.nth_derivative_value(order).ok_or_else(wrong),
            _ => Err(wrong()),
        };
        let found = laws.sides.iter().map(|[lhs, rhs]| Ok(side(lhs)? - side(rhs)?)).collect();
        self.memo.following.borrow_mut().truncate(others);
        self.memo.forget_values();
        found
    }
}
