//! Hypotheses over a field: solved exactly, each for a number in which it is linear, and in the only way there is.
//!
//! Of A·s + B = 0 the solution s = −B/A is all that there is, unless A and B have a factor in common: (x − y)(z − 1) = 0 is
//! met by x = y, and by z = 1 too, with x and y free. So it is asked where the *slope* A vanishes. If nowhere in the
//! declared ranges, the hypothesis is an equation for s. If it vanishes where B does not, the two have no common factor, and
//! what obeys the hypothesis is still of one piece; but a further hypothesis could cut it into several, so that no other may
//! come after it. What cannot be told is not certified.

use std::cell::RefCell;
use std::f64::consts::PI;
use std::marker::PhantomData;

use crate::formula::{Expr, Node, Relation, Sign};
use crate::mechanics::Elimination;
use crate::notes::claims::Range;
use crate::scalar::field::{Modulus, at_a_point};
use crate::scalar::{DualNum, Modular};

use super::any_body::{AnyBody, Generality};
use super::base::{self, Slot};
use super::draw::{Draw, Reach, contains};
use super::ensemble::Condition;
use super::model::{Meaning, Model};
use super::scene::Scene;
use super::solver::{Row, Solver};

/// So many numbers are tried to solve a hypothesis for.
const CANDIDATES: usize = 40;

/// Of so many of them it is asked whether the slope vanishes; of the first of these, where.
const ASKED: usize = 8;
const FOLLOWED: usize = 2;

/// So many points are tried for one at which the hypotheses can be solved.
const ATTEMPTS: u32 = 8;

/// The highest power of a number that is recognised in a slope.
const POWERS: i32 = 4;

const NOT_SOLVED: &str = "hypotheses that are not linear in a number of their own, so that they are not solved exactly";

/// Why a claim stays open of whose hypotheses one solution alone was looked at.
pub(super) const OTHER_WAYS: &str = "hypotheses that may be met in more than one way";

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
    /// Which row of the hypotheses is solved for which number.
    plan: Vec<(Row, usize)>,
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

/// Where the slope of a row vanishes.
#[derive(Clone, Copy, PartialEq)]
enum Zeros {
    Nowhere,
    /// Where the row does not.
    Apart,
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

    /// The state at the point at hand.
    pub fn scene(&self) -> Result<Scene<'m, Modular<F>>, String> {
        let mut base = self.drawn();
        self.follow(&mut base)?;
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
        for (at, row) in rows.iter().enumerate() {
            if !values[at].vanishes() {
                self.extend(&mut base, (*row, values[at]), &rows)?;
                values = self.solver.values(&self.state(&base)?, &rows).ok_or(NOT_SOLVED)?;
            }
        }
        Ok(())
    }

    fn state(&self, base: &[Modular<F>]) -> Result<Scene<'m, Modular<F>>, String> {
        let terms = self.solver.mode.order + 1;
        self.solver.scene_by(Elimination::Cramer, base, terms).map_err(|error| error.message().to_owned())
    }

    fn value(&self, base: &[Modular<F>], row: Row) -> Result<Modular<F>, String> {
        let values = self.solver.values(&self.state(base)?, &[row]).ok_or(NOT_SOLVED)?;
        Ok(values[0])
    }

    /// Moves a base so that all that is planned holds, one after the other.
    fn follow(&self, base: &mut [Modular<F>]) -> Result<(), String> {
        for (row, slot) in &self.plan {
            let value = self.value(base, *row)?;
            self.put(base, (*row, value), *slot)?.ok_or(NOT_SOLVED)?;
        }
        Ok(())
    }

    /// Moves a number of the base so that a row vanishes, whose value is known, if the row is linear in it.
    fn put(&self, base: &mut [Modular<F>], (row, zero): (Row, Modular<F>), slot: usize) -> Result<Option<()>, String> {
        let start = base[slot];
        let mut at = |step: f64| {
            base[slot] = start + step;
            self.value(base, row)
        };
        let one = at(1.0)?;
        let slope = one - zero;
        // most numbers have nothing to do with a row
        if slope.vanishes() || !(at(2.0)? - one - slope).vanishes() {
            base[slot] = start;
            return Ok(None);
        }
        base[slot] = start - zero / slope;
        Ok(Some(()))
    }

    /// Finds a number to solve a row for, whose value is known, such that the rows before it hold still, and such that
    /// this is the only way to obey it.
    fn extend(
        &mut self,
        base: &mut Vec<Modular<F>>,
        (row, value): (Row, Modular<F>),
        rows: &[Row],
    ) -> Result<(), String> {
        let known = self.solver.plan.iter().filter(|(planned, _)| *planned == row).map(|(_, slot)| *slot);
        let candidates: Vec<usize> =
            known.chain((1..base.len()).rev()).filter(|slot| self.is_open(*slot)).take(CANDIDATES).collect();
        let candidates: Vec<usize> = candidates.into_iter().filter(|slot| !self.is_idle(row, *slot)).collect();
        let before: Vec<Row> = rows.iter().copied().take_while(|other| *other != row).collect();
        let (mut chosen, mut reason, mut asked) = (None, NOT_SOLVED, 0);
        for slot in candidates {
            let mut moved = base.clone();
            if self.put(&mut moved, (row, value), slot)?.is_none() {
                continue;
            }
            let values = self.solver.values(&self.state(&moved)?, &before).ok_or(NOT_SOLVED)?;
            if !values.iter().all(|value| value.vanishes()) {
                continue;
            }
            asked += 1;
            match self.zeros(base, row, slot, chosen.is_some() || asked > FOLLOWED)? {
                Some(Zeros::Nowhere) => {
                    chosen = Some((slot, moved, false));
                    break;
                }
                Some(Zeros::Apart) => chosen = Some((slot, moved, true)),
                None => reason = OTHER_WAYS,
            }
            if asked == ASKED {
                break;
            }
        }
        let (slot, moved, may_vanish) = chosen.ok_or(reason)?;
        if self.may_vanish {
            return Err(OTHER_WAYS.to_owned());
        }
        self.may_vanish = may_vanish;
        self.plan.push((row, slot));
        *base = moved;
        Ok(())
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
        !self.plan.iter().any(|(_, taken)| *taken == slot)
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

    /// What a row, which is linear in a number, changes by as that changes by 1.
    fn slope(&self, base: &[Modular<F>], row: Row, slot: usize) -> Result<Modular<F>, String> {
        let mut next = base.to_vec();
        next[slot] += 1.0;
        Ok(self.value(&next, row)? - self.value(base, row)?)
    }

    /// Where the slope of a row vanishes; none where that is not known, or where the row vanishes with it. Of a slope that
    /// varies nothing more is asked if it must vanish nowhere.
    fn zeros(&self, base: &[Modular<F>], row: Row, slot: usize, only_nowhere: bool) -> Result<Option<Zeros>, String> {
        let slope = self.slope(base, row, slot)?;
        let mut others = self.drawn();
        self.follow(&mut others)?;
        if (self.slope(&others, row, slot)? - slope).vanishes() {
            return Ok(Some(Zeros::Nowhere));
        }
        if self.one_of_them_is_never_zero(base, &others, row, slot)? {
            return Ok(Some(Zeros::Nowhere));
        }
        if only_nowhere {
            return Ok(None);
        }
        if let Some(direction) = base::direction(self.solver.model) {
            let mut turned = base.to_vec();
            turned[direction.clone()].copy_from_slice(&others[direction]);
            self.follow(&mut turned)?;
            if !(self.slope(&turned, row, slot)? - slope).vanishes() {
                return Ok(None);
            }
        }
        let mut found = Zeros::Nowhere;
        // What is planned moves with a number, and may move the row.
        let is_idle = |at| self.plan.is_empty() && self.is_idle(row, at);
        for at in (0..base.len()).filter(|at| *at != slot && self.is_open(*at) && !is_idle(*at)) {
            let other = self.moved(base, at, self.drawn_at(at))?;
            let ratio = self.slope(&other, row, slot)? / slope;
            if (ratio - 1.0).vanishes() {
                continue;
            }
            let Some(zeros) = self.zeros_in(base, (row, slot), at, (other[at], ratio))? else { return Ok(None) };
            for zero in zeros {
                if self.value(&self.moved(base, at, zero)?, row)?.vanishes() {
                    return Ok(None);
                }
                found = Zeros::Apart;
            }
        }
        Ok(Some(found))
    }

    /// Whether a row is linear in a number and its like together, the components of a vector, and the squares of their slopes
    /// have a sum that does not vary. Then some of them can always be solved for.
    fn one_of_them_is_never_zero(
        &self,
        base: &[Modular<F>],
        others: &[Modular<F>],
        row: Row,
        slot: usize,
    ) -> Result<bool, String> {
        let slots = &self.solver.slots;
        if slots[slot].symbol.is_none() || !slots[slot].one_of_many {
            return Ok(false);
        }
        let alike = |at: &usize| (slots[*at].symbol, slots[*at].order) == (slots[slot].symbol, slots[slot].order);
        let all: Vec<usize> = (1..base.len()).filter(alike).filter(|at| self.is_open(*at)).collect();
        let mut moved = base.to_vec();
        all.iter().for_each(|at| moved[*at] = self.drawn_at(*at));
        let (mut sum, mut elsewhere) = (Modular::from(0.0), Modular::from(0.0));
        for at in all {
            let slope = self.slope(base, row, at)?;
            if !(self.slope(&moved, row, at)? - slope).vanishes() {
                return Ok(false);
            }
            let other = self.slope(others, row, at)?;
            (sum, elsewhere) = (sum + slope * slope, elsewhere + other * other);
        }
        Ok((sum - elsewhere).vanishes() && !sum.vanishes())
    }

    /// The values of one number at which a slope vanishes and that may lie in its range, given the ratio by which the slope
    /// changes with it: of powers of the number, of its sine and cosine, and of what is linear in it.
    fn zeros_in(
        &self,
        base: &[Modular<F>],
        (row, slot): (Row, usize),
        at: usize,
        (other, ratio): (Modular<F>, Modular<F>),
    ) -> Result<Option<Vec<Modular<F>>>, String> {
        let (start, range) = (base[at], &self.solver.slots[at].range);
        let is_one = |x: Modular<F>| (x - 1.0).vanishes();
        if let Some(n) = (-POWERS..=POWERS).find(|n| is_one(ratio * (start / other).powi(*n))) {
            return Ok(Some(if n > 0 && contains(range, 0.0) { vec![Modular::from(0.0)] } else { Vec::new() }));
        }
        if self.solver.slots[at].order == 0 {
            let (sine, cosine) = (start.sin() / other.sin(), start.cos() / other.cos());
            for (m, n) in (-POWERS..=POWERS).flat_map(|m| (-POWERS..=POWERS).map(move |n| (m, n))) {
                if is_one(ratio * sine.powi(m) * cosine.powi(n)) {
                    let of_sine = [0.0, PI].into_iter().filter(|_| m > 0);
                    let of_cosine = [PI / 2.0, -PI / 2.0].into_iter().filter(|_| n > 0);
                    let zeros = of_sine.chain(of_cosine).filter(|angle| contains_turned(range, *angle));
                    return Ok(Some(zeros.map(Modular::from).collect()));
                }
            }
        }
        let along = |step: f64| self.slope(&self.moved(base, at, start + step)?, row, slot);
        let (zero, one, two) = (along(0.0)?, along(1.0)?, along(2.0)?);
        let rate = one - zero;
        Ok((two - one - rate).vanishes().then(|| vec![start - zero / rate]))
    }
}

/// Whether an angle lies in a range, give or take whole turns.
fn contains_turned(range: &Range, angle: f64) -> bool {
    match range {
        Range::Interval { low, high, .. } => {
            let (first, last) = ((low - angle) / (2.0 * PI), (high - angle) / (2.0 * PI));
            // the ends are looked at one turn beyond, as they are rounded
            let (first, last) = (first.floor() as i64, last.ceil() as i64);
            last - first > 3 || (first..=last).any(|turns| contains(range, angle + 2.0 * PI * turns as f64))
        }
        _ => true,
    }
}

/// Whether a coefficient that does not vary is different from 0 in all declared ranges, as far as that can be read off it.
pub(super) fn is_never_zero(model: &Model, expr: &Expr) -> bool {
    match &expr.node {
        Node::Product(factors) => factors.iter().all(|factor| is_never_zero(model, factor)),
        Node::Quotient(above, below) => is_never_zero(model, above) && is_never_zero(model, below),
        Node::Power(base, _) => is_never_zero(model, base),
        Node::Symbol { id, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => is_never_zero(model, formula),
            Some(Meaning::Constant(_)) => !contains(&model.range(*id), 0.0),
            _ => false,
        },
        _ => is_positive(model, expr),
    }
}

fn is_positive(model: &Model, expr: &Expr) -> bool {
    match &expr.node {
        Node::Number(digits) => digits.parse::<f64>().is_ok_and(|value| value > 0.0),
        Node::Pi => true,
        Node::Sum(terms) => terms.iter().all(|term| term.sign == Sign::Plus && is_positive(model, &term.expr)),
        Node::SumOver { body, .. } | Node::Root(_, body) => is_positive(model, body),
        Node::Product(factors) => factors.iter().all(|factor| is_positive(model, factor)),
        Node::Quotient(above, below) => is_positive(model, above) && is_positive(model, below),
        Node::Power(base, _) => is_positive(model, base),
        Node::Symbol { id, .. } => match model.meaning(*id) {
            Some(Meaning::Defined(formula)) => is_positive(model, formula),
            Some(Meaning::Constant(_)) => match model.range(*id) {
                Range::Positive => true,
                Range::Interval { low, low_open, .. } => low > 0.0 || low == 0.0 && low_open,
                Range::Integer { low, .. } => low > 0,
                _ => false,
            },
            _ => false,
        },
        _ => false,
    }
}
