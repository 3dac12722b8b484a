//! Hypotheses over a field: solved exactly, each for a number in which it is linear, and in the only way there is.
//!
//! Of A·s + B = 0 the solution s = −B/A is all that there is, unless A and B have a factor in common: (x − y)(z − 1) = 0 is
//! met by x = y, and by z = 1 too, with x and y free. So it is asked where the *slope* A vanishes. If nowhere in the
//! declared ranges, the hypothesis is an equation for s. If it vanishes where B does not, the two have no common factor, and
//! what obeys the hypothesis is still of one piece; but a further hypothesis could cut it into several, so that no other may
//! come after it. What cannot be told is not certified. Where a hypothesis is about a vector, its components are solved
//! for those of another together, if they cannot be one by one; then A is the determinant of their slopes.

mod signs;
mod zeros;

use std::cell::RefCell;
use std::marker::PhantomData;

use nalgebra::Vector3;

use crate::formula::{Kind, Relation, SymbolId};
use crate::mechanics::Elimination;
use crate::notes::claims::Range;
use crate::scalar::Modular;
use crate::scalar::field::{Modulus, at_a_point};

use super::any_body::{AnyBody, Generality};
use super::base::{self, Slot};
use super::draw::{Draw, Reach};
use super::ensemble::Condition;
use super::growth::Sums;
use super::scene::Scene;
use super::solver::{Row, Solver};

pub(super) use signs::is_never_zero;
use zeros::Zeros;

/// So many numbers are tried to solve a hypothesis for.
const CANDIDATES: usize = 40;

/// Of so many of them it is asked whether the slope vanishes; of the first of these, where.
const ASKED: usize = 8;
const FOLLOWED: usize = 2;

/// So many points are tried for one at which the hypotheses can be solved.
const ATTEMPTS: u32 = 8;

const NOT_SOLVED: &str = "hypotheses that are not linear in a number of their own, so that they are not solved exactly";

/// Why a claim stays open of whose hypotheses one solution alone was looked at.
pub(super) const OTHER_WAYS: &str = "hypotheses that may be met in more than one way";

/// Whether two rows are components of one vector.
fn of_one_vector(a: Row, b: Row) -> bool {
    (a.0, a.1) == (b.0, b.1)
}

/// The determinant of one number, or of three columns.
fn determinant<F: Modulus>(columns: &[Vec<Modular<F>>]) -> Modular<F> {
    let vector = |column: &Vec<Modular<F>>| Vector3::new(column[0], column[1], column[2]);
    match columns {
        [a, b, c] => vector(a).cross(&vector(b)).dot(&vector(c)),
        columns => columns[0][0],
    }
}

/// Makes three numbers the components of a unit vector, by the stereographic projection of the first two.
fn unit_vector<F: Modulus>(direction: &mut [Modular<F>]) {
    let [x, y, z] = direction else { return };
    let (a, b) = (*x, *y);
    let square = a * a + b * b;
    let length = square + 1.0;
    (*x, *y, *z) = (a * 2.0 / length, b * 2.0 / length, (-square + 1.0) / length);
}

/// States at points of the field at which the hypotheses hold exactly.
pub(super) struct Solved<'s, 'm, F> {
    solver: &'s Solver<'m>,
    /// The values of the whole numbers that matter, by their places in a base.
    whole: Vec<(usize, f64)>,
    /// What of the hypotheses is solved for which numbers.
    plan: Vec<Step>,
    /// Whether the slope of the last of them may vanish.
    may_vanish: bool,
    /// Whether the hypotheses hold.
    obeys: bool,
    /// What stands in for particles whose principal axes are spoken of; not by the hypotheses.
    generality: Generality,
    /// Numbers that obey no hypothesis: there nothing is at rest by accident.
    anywhere: Vec<f64>,
    /// Of each row that was asked about, the numbers that it does not depend on.
    idle: RefCell<Vec<(Row, Vec<bool>)>>,
    field: PhantomData<F>,
}

/// One row of the hypotheses and the number that it is solved for, or the three of a vector and as many numbers.
#[derive(Clone)]
struct Step {
    rows: Vec<Row>,
    slots: Vec<usize>,
}

impl<'s, 'm, F: Modulus> Solved<'s, 'm, F> {
    /// Finds what the hypotheses are solved for, at a point of which nothing else is used.
    ///
    /// # Errors
    /// The reason why they are not solved, or not in the only way.
    pub fn new(solver: &'s Solver<'m>, whole: Vec<(usize, f64)>, seed: u64) -> Result<Self, String> {
        let mut solved = Solved { obeys: true, ..Self::without_hypotheses(solver, whole) };
        if solver.equalities().next().is_none() {
            return Ok(solved);
        }
        let mut nowhere = NOT_SOLVED;
        for attempt in 0..ATTEMPTS {
            let (found, account) = at_a_point::<F, _>(seed.wrapping_add(attempt.into()), 0, 1, || {
                (solved.plan, solved.may_vanish) = (Vec::new(), false);
                solved.solve()
            });
            match account.elsewhere {
                None => return account.fault.map_or(found, |fault| Err(fault.to_owned())).map(|()| solved),
                Some(reason) => nowhere = reason,
            }
        }
        Err(nowhere.to_owned())
    }

    /// States that obey no hypotheses.
    pub fn without_hypotheses(solver: &'s Solver<'m>, whole: Vec<(usize, f64)>) -> Self {
        let mut anywhere = Draw::new(1, "anywhere").base(&solver.slots, Reach::Declared);
        whole.iter().for_each(|(at, value)| anywhere[*at] = *value);
        let (plan, idle) = (Vec::new(), RefCell::default());
        Solved {
            solver,
            whole,
            plan,
            may_vanish: false,
            obeys: false,
            generality: Generality::Themselves,
            anywhere,
            idle,
            field: PhantomData,
        }
    }

    /// The same with particles that others stand in for.
    pub fn with(self, generality: Generality) -> Self {
        Solved { generality, ..self }
    }

    /// Whether there was anything to solve.
    pub fn is_free(&self) -> bool {
        self.plan.is_empty()
    }

    /// Whether hypotheses that are sums over members are solved for numbers of these families, and the others for none of
    /// other families.
    pub fn moves(&self, sums: &Sums) -> bool {
        let Solver { model, slots, .. } = self.solver;
        let is_known = |at: &usize| slots[*at].symbol.is_some_and(|id| sums.families.contains(&id));
        let is_single = |at: &usize| slots[*at].symbol.is_none_or(|id| model.symbols.entry(id).slots.is_empty());
        let is_sum = |step: &Step| sums.conditions.contains(&step.rows[0].0);
        let moves = |step: &Step| step.slots.iter().all(|at| is_known(at) || !is_sum(step) && is_single(at));
        sums.conditions.is_empty() || self.plan.iter().all(moves)
    }

    /// The state at the point at hand.
    pub fn scene(&self) -> Result<Scene<'m, Modular<F>>, String> {
        let mut base = self.drawn();
        // That the rows are linear, so that this is the only way, is seen at every point anew.
        for step in &self.plan {
            self.put_if_linear(&mut base, step)?.ok_or(NOT_SOLVED)?;
        }
        let mut scene = self.state(&base)?;
        scene.set_body(AnyBody::drawn(self.generality));
        if !self.obeys {
            return Ok(scene);
        }
        let rows = self.solver.rows(&scene);
        if rows.iter().all(|(_, value)| value.vanishes()) { Ok(scene) } else { Err(NOT_SOLVED.to_owned()) }
    }

    fn drawn_at(&self, at: usize) -> Modular<F> {
        if let Some((_, value)) = self.whole.iter().find(|(known, _)| *known == at) {
            return Modular::from(*value);
        }
        match &self.solver.slots[at] {
            Slot { range: Range::Integer { low, .. }, .. } => Modular::from(*low as f64),
            // nobody takes the sine of a velocity
            slot if slot.order > 0 => Modular::drawn_plain(),
            _ => Modular::drawn(),
        }
    }

    fn drawn(&self) -> Vec<Modular<F>> {
        let mut base: Vec<Modular<F>> = (0..self.solver.slots.len()).map(|at| self.drawn_at(at)).collect();
        if let Some(direction) = base::direction(self.solver.model) {
            unit_vector(&mut base[direction.clone()]);
            // ω comes from R and Ṙ, as long polynomials; it is no accident that it is this
            let rate = self.solver.slots.iter().rposition(|slot| slot.order == 1 && slot.symbol.is_none());
            for component in direction {
                base[component].kept();
                if let Some(rate) = rate {
                    (base[component] * base[rate]).kept();
                }
            }
        }
        base
    }

    fn solve(&mut self) -> Result<(), String> {
        let left_open =
            |(condition, is_rule): (&Condition, &bool)| condition.relation == Relation::Proportional && !is_rule;
        if self.solver.conditions.iter().zip(self.solver.explicit()).any(left_open) {
            return Err(NOT_SOLVED.to_owned());
        }
        let mut base = self.drawn();
        let (rows, mut values): (Vec<Row>, Vec<Modular<F>>) = self.solver.rows(&self.state(&base)?).into_iter().unzip();
        // What was known before the rows of the vector at hand.
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

    fn state(&self, base: &[Modular<F>]) -> Result<Scene<'m, Modular<F>>, String> {
        let terms = self.solver.mode.order + 1;
        self.solver.scene_by(Elimination::Cramer, base, terms).map_err(|error| error.message().to_owned())
    }

    fn values(&self, base: &[Modular<F>], rows: &[Row]) -> Result<Vec<Modular<F>>, String> {
        Ok(self.solver.values(&self.state(base)?, rows).ok_or(NOT_SOLVED)?)
    }

    /// Moves a base so that all that is planned holds, one after the other.
    fn follow(&self, base: &mut [Modular<F>]) -> Result<(), String> {
        for step in &self.plan {
            self.put(base, step)?.ok_or(NOT_SOLVED)?;
        }
        Ok(())
    }

    /// What rows change by as one number after the other changes by 1: for each number the changes of all rows.
    fn slopes(&self, base: &[Modular<F>], step: &Step, zero: &[Modular<F>]) -> Result<Vec<Vec<Modular<F>>>, String> {
        let along = |slot: &usize| {
            let mut next = base.to_vec();
            next[*slot] += 1.0;
            Ok(self.values(&next, &step.rows)?.iter().zip(zero).map(|(one, zero)| *one - *zero).collect())
        };
        step.slots.iter().map(along).collect()
    }

    /// Moves numbers of the base so that rows vanish that are linear in them, if they are independent; the determinant of
    /// their slopes.
    fn put(&self, base: &mut [Modular<F>], step: &Step) -> Result<Option<Modular<F>>, String> {
        let zero = self.values(base, &step.rows)?;
        let slopes = self.slopes(base, step, &zero)?;
        Ok(self.put_by(base, step, (&zero, &slopes)))
    }

    /// The same for rows of which these are the values and slopes.
    fn put_by(
        &self,
        base: &mut [Modular<F>],
        step: &Step,
        (zero, slopes): (&Vec<Modular<F>>, &[Vec<Modular<F>>]),
    ) -> Option<Modular<F>> {
        let slope = determinant(slopes);
        // most numbers have nothing to do with a row
        if slope.vanishes() {
            return None;
        }
        for (at, slot) in step.slots.iter().enumerate() {
            let mut instead = slopes.to_vec();
            instead[at].clone_from(zero);
            base[*slot] -= determinant(&instead) / slope;
        }
        Some(slope)
    }

    /// The same for rows that may not be linear; nothing then.
    fn put_if_linear(&self, base: &mut [Modular<F>], step: &Step) -> Result<Option<Modular<F>>, String> {
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

    /// Finds numbers to solve rows for, such that the rows before them hold still, and such that this is the only way to
    /// obey them.
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

    /// The numbers that rows may be solved for: one, or the components of a vector.
    fn candidates(&self, wanted: &[Row]) -> Vec<Vec<usize>> {
        let matters = |slot: &usize| wanted.iter().any(|row| !self.is_idle(*row, *slot));
        if let [row] = wanted {
            let known = self.solver.progress.plan.iter().filter(|(planned, _)| planned == row).map(|(_, slot)| *slot);
            let open = known.chain((1..self.anywhere.len()).rev()).filter(|slot| self.is_open(*slot)).take(CANDIDATES);
            return open.collect::<Vec<_>>().into_iter().filter(matters).map(|slot| vec![slot]).collect();
        }
        let slots = &self.solver.slots;
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

    fn is_vector(&self, id: SymbolId) -> bool {
        self.solver.model.symbols.entry(id).kind == Kind::Vector
    }

    /// Whether a row has nothing to do with a number; doubles tell that at once.
    fn is_idle(&self, row: Row, slot: usize) -> bool {
        let mut known = self.idle.borrow_mut();
        if !known.iter().any(|(other, _)| *other == row) {
            let slots = 0..self.anywhere.len();
            known.push((row, slots.map(|slot| !self.solver.depends(&self.anywhere, row, slot)).collect()));
        }
        known.iter().any(|(other, idle)| *other == row && idle[slot])
    }

    /// Whether a number can still be moved.
    fn is_open(&self, slot: usize) -> bool {
        !self.plan.iter().any(|step| step.slots.contains(&slot))
            && !base::direction(self.solver.model).is_some_and(|direction| direction.contains(&slot))
            && !matches!(self.solver.slots[slot].range, Range::Integer { .. })
    }

    /// The base with another value for one number, on what is planned.
    fn moved(&self, base: &[Modular<F>], at: usize, to: Modular<F>) -> Result<Vec<Modular<F>>, String> {
        let mut moved = base.to_vec();
        moved[at] = to;
        self.follow(&mut moved)?;
        Ok(moved)
    }
}
