//! The plan that solves hypotheses over a prime field: which row for which number, one after the other.

use crate::check::certificate::solved::{NOT_SOLVED, OTHER_WAYS, Solved, Step};
use crate::check::certificate::zeros::Zeros;
use crate::check::model::claim::Hypothesis;
use crate::check::model::state_cache::Row;
use crate::check::sample::projection::Projection;
use crate::formula::{Kind, Relation, SymbolId};
use crate::scalar::Modular;
use crate::scalar::prime_field::{Modulus, evaluate_at_point};

/// The largest number of candidates for which a hypothesis is solved.
const CANDIDATES: usize = 40;

/// The number of candidates whose slope is tested for zeros, and the number of those whose zeros are located.
const ASKED: usize = 8;

const FOLLOWED: usize = 2;

/// The largest number of points that are tried to find one at which the hypotheses can be solved.
const ATTEMPTS: u32 = 8;

/// Whether two rows are components of one vector.
fn of_one_vector(a: Row, b: Row) -> bool {
    (a.0, a.1) == (b.0, b.1)
}

impl<'s, 'm, F: Modulus> Solved<'s, 'm, F> {
    /// Finds the plan for the hypotheses, at a point that is not used otherwise.
    ///
    /// # Errors
    /// The reason why they cannot be solved, or may have other solutions.
    pub fn new(projection: &'s Projection<'m>, whole: Vec<(usize, f64)>, seed: u64) -> Result<Self, String> {
        let mut solved = Self::without_hypotheses(projection, whole);
        solved.obeys = true;
        if projection.equalities().next().is_none() {
            return Ok(solved);
        }
        let mut nowhere = NOT_SOLVED;
        for attempt in 0..ATTEMPTS {
            let (found, record) = evaluate_at_point::<F, _>(seed.wrapping_add(attempt.into()), 0, 1, || {
                (solved.plan, solved.may_vanish) = (Vec::new(), false);
                solved.solve()
            });
            match record.undefined_here {
                None => return record.unsupported.map_or(found, |fault| Err(fault.to_owned())).map(|()| solved),
                Some(reason) => nowhere = reason,
            }
        }
        Err(nowhere.to_owned())
    }

    fn solve(&mut self) -> Result<(), String> {
        let left_open =
            |(hypothesis, is_rule): (&Hypothesis, &bool)| hypothesis.relation == Relation::Proportional && !is_rule;
        if self.projection.hypotheses.iter().zip(self.projection.explicit()).any(left_open) {
            return Err(NOT_SOLVED.to_owned());
        }
        let mut base = self.drawn();
        let (rows, mut values): (Vec<Row>, Vec<Modular<F>>) =
            self.projection.rows(&self.state(&base)?).into_iter().unzip();
        // The plan before the rows of the current vector.
        let (mut at, mut outset) = (0, (0, base.clone(), Vec::new(), false));
        while at < rows.len() {
            if at == 0 || !of_one_vector(rows[at - 1], rows[at]) {
                outset = (at, base.clone(), self.plan.clone(), self.may_vanish);
            }
            let mut next = at + 1;
            if !values[at].vanishes() {
                let found = self.extend(&mut base, &[rows[at]], &rows);
                if let Err(reason) = found {
                    let vector: Vec<Row> = rows.iter().copied().filter(|row| of_one_vector(*row, rows[at])).collect();
                    (base, self.plan, self.may_vanish) = (outset.1.clone(), outset.2.clone(), outset.3);
                    if vector.len() != 3 || self.extend(&mut base, &vector, &rows).is_err() {
                        return Err(reason);
                    }
                    next = outset.0 + vector.len();
                }
                values = self.values(&base, &rows)?;
            }
            at = next;
        }
        Ok(())
    }

    /// Finds the numbers for which rows are solved, such that the rows before them stay solved and the solution is
    /// unique.
    fn extend(&mut self, base: &mut Vec<Modular<F>>, wanted: &[Row], rows: &[Row]) -> Result<(), String> {
        let before: Vec<Row> = rows.iter().copied().take_while(|other| *other != wanted[0]).collect();
        let (mut chosen, mut reason, mut asked) = (None, NOT_SOLVED, 0);
        for slots in self.candidates(wanted) {
            let step = Step { rows: wanted.to_vec(), slots };
            let mut moved = base.clone();
            let Some(slope) = self.put_if_linear(&mut moved, &step)? else { continue };
            if !self.values(&moved, &before)?.iter().all(|value| value.vanishes()) {
                continue;
            }
            asked += 1;
            match self.zeros((base, slope), &step, chosen.is_some() || asked > FOLLOWED)? {
                Some(Zeros::Nowhere) => {
                    chosen = Some((step, moved, false));
                    break;
                }
                Some(Zeros::Apart) => chosen = Some((step, moved, true)),
                None => reason = OTHER_WAYS,
            }
            if asked == ASKED {
                break;
            }
        }
        let (step, moved, may_vanish) = chosen.ok_or(reason)?;
        if self.may_vanish {
            return Err(OTHER_WAYS.to_owned());
        }
        self.may_vanish = may_vanish;
        self.plan.push(step);
        *base = moved;
        Ok(())
    }

    /// The candidates for which rows may be solved: one number, or the components of a vector.
    fn candidates(&self, wanted: &[Row]) -> Vec<Vec<usize>> {
        let matters = |slot: &usize| wanted.iter().any(|row| !self.is_idle(*row, *slot));
        if let [row] = wanted {
            let known = self.projection.record.plan.iter().filter(|(planned, _)| planned == row).map(|(_, slot)| *slot);
            let open = known.chain((1..self.anywhere.len()).rev()).filter(|slot| self.is_open(*slot)).take(CANDIDATES);
            return open.collect::<Vec<_>>().into_iter().filter(matters).map(|slot| vec![slot]).collect();
        }
        let slots = &self.projection.slots;
        let kind = |at: usize| (slots[at].symbol, slots[at].order);
        let mut vectors: Vec<Vec<usize>> = Vec::new();
        for at in (1..slots.len()).filter(|at| slots[*at].symbol.is_some_and(|id| self.is_vector(id))) {
            match vectors.iter_mut().find(|vector| vector.len() < 3 && kind(vector[0]) == kind(at)) {
                Some(vector) => vector.push(at),
                None => vectors.push(vec![at]),
            }
        }
        let is_open = |vector: &Vec<usize>| vector.iter().all(|slot| self.is_open(*slot) && matters(slot));
        vectors.into_iter().rev().filter(|vector| vector.len() == 3).filter(is_open).collect()
    }

    /// Solves the rows of a step if they are linear; returns the determinant of the slopes.
    pub(crate) fn put_if_linear(&self, base: &mut [Modular<F>], step: &Step) -> Result<Option<Modular<F>>, String> {
        let zero = self.values(base, &step.rows)?;
        let slopes = self.slopes(base, step, &zero)?;
        let mut far = base.to_vec();
        let Some(slope) = self.put_by(base, step, (&zero, &slopes)) else { return Ok(None) };
        step.slots.iter().enumerate().for_each(|(at, slot)| far[*slot] += (at + 2) as f64);
        for (row, value) in self.values(&far, &step.rows)?.into_iter().enumerate() {
            let linear = slopes.iter().enumerate().map(|(at, slopes)| slopes[row] * (at + 2) as f64);
            if !linear.fold(value - zero[row], |rest, part| rest - part).vanishes() {
                return Ok(None);
            }
        }
        Ok(Some(slope))
    }

    fn is_vector(&self, id: SymbolId) -> bool {
        self.projection.model.symbols.entry(id).kind == Kind::Vector
    }
}
