//! The zeros of the slope of a hypothesis that is solved for a number: there it may have another solution.

use std::f64::consts::PI;

use crate::notes::claims::Range;
use crate::scalar::prime_field::Modulus;
use crate::scalar::{DualNum, Modular, Number};

use crate::check::certificate::solved::{Solved, Step, determinant};
use crate::check::model::state_cache::Row;
use crate::check::sample::sampler::contains;
use crate::check::state::numbers;

/// The largest power of a number that is recognised in a slope.
const POWERS: i32 = 4;

/// The zeros of the slope of a row.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Zeros {
    /// There are none.
    Nowhere,
    /// At its zeros the row does not vanish.
    Apart,
}

impl<F: Modulus> Solved<'_, '_, F> {
    /// The slope of a step: the determinant of the slopes of its rows.
    fn slope(&self, base: &[Modular<F>], step: &Step) -> Result<Modular<F>, String> {
        Ok(determinant(&self.slopes(base, step, &self.values(base, &step.rows)?)?))
    }

    /// The zeros of the slope of a step; `None` if they are not known, or if the row vanishes there too. With
    /// `only_nowhere` the zeros of a slope that varies are not located.
    pub(crate) fn zeros(
        &self,
        (base, slope): (&[Modular<F>], Modular<F>),
        step: &Step,
        only_nowhere: bool,
    ) -> Result<Option<Zeros>, String> {
        let mut others = self.drawn();
        self.follow(&mut others)?;
        if (self.slope(&others, step)? - slope).vanishes() {
            return Ok(Some(Zeros::Nowhere));
        }
        if let ([row], [slot]) = (step.rows.as_slice(), step.slots.as_slice())
            && self.one_of_them_is_never_zero(base, &others, *row, *slot)?
        {
            return Ok(Some(Zeros::Nowhere));
        }
        if only_nowhere {
            return Ok(None);
        }
        if let Some(direction) = numbers::direction(self.projection.model) {
            let mut turned = base.to_vec();
            turned[direction.clone()].copy_from_slice(&others[direction]);
            self.follow(&mut turned)?;
            if !(self.slope(&turned, step)? - slope).vanishes() {
                return Ok(None);
            }
        }
        let mut found = Zeros::Nowhere;
        // The planned numbers change with a number, and may change the row.
        let is_idle = |at| self.plan.is_empty() && step.rows.iter().all(|row| self.is_idle(*row, at));
        for at in (0..base.len()).filter(|at| !step.slots.contains(at) && self.is_open(*at) && !is_idle(*at)) {
            let other = self.moved(base, at, self.drawn_at(at))?;
            let ratio = self.slope(&other, step)? / slope;
            if (ratio - 1.0).vanishes() {
                continue;
            }
            let Some(zeros) = self.zeros_in(base, step, at, (other[at], ratio))? else { return Ok(None) };
            for zero in zeros {
                // For several rows it is not enough that one of them does not vanish with the slope.
                let [row] = step.rows.as_slice() else { return Ok(None) };
                if self.values(&self.moved(base, at, zero)?, &[*row])?[0].vanishes() {
                    return Ok(None);
                }
                found = Zeros::Apart;
            }
        }
        Ok(Some(found))
    }

    /// Whether a row is linear in the components of a vector together, and the sum of the squares of their slopes is
    /// constant. Then the row can always be solved for one of them.
    fn one_of_them_is_never_zero(
        &self,
        base: &[Modular<F>],
        others: &[Modular<F>],
        row: Row,
        slot: usize,
    ) -> Result<bool, String> {
        let slots = &self.projection.slots;
        if slots[slot].symbol.is_none() || !slots[slot].one_of_many {
            return Ok(false);
        }
        let alike = |at: &usize| (slots[*at].symbol, slots[*at].order) == (slots[slot].symbol, slots[slot].order);
        let all: Vec<usize> = (1..base.len()).filter(alike).filter(|at| self.is_open(*at)).collect();
        let mut moved = base.to_vec();
        all.iter().for_each(|at| moved[*at] = self.drawn_at(*at));
        let at_zero = |base: &[Modular<F>]| self.values(base, &[row]);
        let zeros = [at_zero(base)?, at_zero(&moved)?, at_zero(others)?];
        let slope = |base: &[Modular<F>], at: usize, zero: &[Modular<F>]| {
            Ok::<_, String>(determinant(&self.slopes(base, &Step { rows: vec![row], slots: vec![at] }, zero)?))
        };
        let (mut sum, mut elsewhere) = (Modular::from(0.0), Modular::from(0.0));
        for at in all {
            let here = slope(base, at, &zeros[0])?;
            if !(slope(&moved, at, &zeros[1])? - here).vanishes() {
                return Ok(false);
            }
            let other = slope(others, at, &zeros[2])?;
            (sum, elsewhere) = (sum + here * here, elsewhere + other * other);
        }
        Ok((sum - elsewhere).vanishes() && !sum.vanishes())
    }

    /// The zeros of a slope in one number that may lie in its range, given the ratio by which the slope changes with
    /// it. Recognised are powers of the number, of its sine and cosine, and linear functions. `None` for others.
    fn zeros_in(
        &self,
        base: &[Modular<F>],
        step: &Step,
        at: usize,
        (other, ratio): (Modular<F>, Modular<F>),
    ) -> Result<Option<Vec<Modular<F>>>, String> {
        let (start, range) = (base[at], &self.projection.slots[at].range);
        let is_one = |x: Modular<F>| (x - 1.0).vanishes();
        if let Some(n) = (-POWERS..=POWERS).find(|n| is_one(ratio * (start / other).powi(*n))) {
            return Ok(Some(if n > 0 && contains(range, 0.0) { vec![Modular::from(0.0)] } else { Vec::new() }));
        }
        if self.projection.slots[at].order == 0 {
            let (sine, cosine) = (start.sin() / other.sin(), start.cos() / other.cos());
            for (m, n) in (-POWERS..=POWERS).flat_map(|m| (-POWERS..=POWERS).map(move |n| (m, n))) {
                if is_one(ratio * sine.powi(m) * cosine.powi(n)) {
                    // In quarters of a turn.
                    let of_sine = [0, 2].into_iter().filter(|_| m > 0);
                    let of_cosine = [1, -1].into_iter().filter(|_| n > 0);
                    let zeros = of_sine.chain(of_cosine).map(f64::from);
                    let zeros = zeros.filter(|quarters| contains_turned(range, quarters * PI / 2.0));
                    return Ok(Some(zeros.map(|quarters| Modular::pi() / 2.0 * quarters).collect()));
                }
            }
        }
        let along = |by: f64| self.slope(&self.moved(base, at, start + by)?, step);
        let (zero, one, two) = (along(0.0)?, along(1.0)?, along(2.0)?);
        let rate = one - zero;
        Ok((two - one - rate).vanishes().then(|| vec![start - zero / rate]))
    }
}

/// Whether an angle lies in a range, up to whole turns.
fn contains_turned(range: &Range, angle: f64) -> bool {
    match range {
        Range::Interval { low, high, .. } => {
            let (first, last) = ((low - angle) / (2.0 * PI), (high - angle) / (2.0 * PI));
            // One more turn is tried at each end, because of rounding.
            let (first, last) = (first.floor() as i64, last.ceil() as i64);
            last - first > 3 || (first..=last).any(|turns| contains(range, angle + 2.0 * PI * turns as f64))
        }
        _ => true,
    }
}
