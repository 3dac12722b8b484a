//! Exponentials and logarithms over the field: independent random numbers, related as their arguments are.
//!
//! A field has no eˣ, so a random number represents it. The same argument gives the same number, a simple multiple of
//! an argument gives a power, and a sum of two arguments gives a product. ln is the inverse. An identity that holds for
//! such numbers holds for exponentials. An equation that fails for them may hold by a relation that is not known here,
//! so nothing is concluded then.

use super::denominators::degree_as_f64;
use super::evaluation::{Evaluation, Exponential, with_evaluation};
use super::modulus::Modulus;
use super::number::Modular;
use crate::scalar::{Arithmetic, DualNum};

/// An exponential is drawn as so high a power, so that e to the simple parts of an argument exist.
const PARTS: i32 = 60;

/// Multiples of an argument by fractions of numbers up to this are recognised.
const SIMPLE: i32 = 6;

/// Among more arguments than these sums are not looked for.
const MOST: usize = 16;

/// The multiples that are recognised: numerators, of either sign, and denominators; the simplest first.
fn multiples() -> impl Iterator<Item = (i32, i32)> {
    let coprime = |n: i32, d: i32| (2..=n.min(d)).all(|k| n % k != 0 || d % k != 0);
    let all = (2..=2 * SIMPLE).flat_map(|sum| (1..sum).map(move |d| (sum - d, d)));
    let simple = all.filter(move |(n, d)| *n <= SIMPLE && *d <= SIMPLE && coprime(*n, *d));
    simple.flat_map(|(n, d)| [(n, d), (-n, d)])
}

impl<F: Modulus> Exponential<F> {
    /// The number to the power n/d, where that is whole.
    fn power_of(self, (n, d): (i32, i32)) -> Option<Modular<F>> {
        ((self.parts * n) % d == 0).then(|| Arithmetic::power(self.base, self.parts * n / d))
    }
}

/// Those that were met; what is made of them is opaque to the field.
fn known<F: Modulus>() -> Vec<Exponential<F>> {
    with_evaluation(|evaluation: &mut Evaluation<F>| {
        evaluation.comparisons.record.opaque = true;
        evaluation.exponentials.clone()
    })
}

fn remember<F: Modulus>(logarithm: Modular<F>, base: Modular<F>, parts: i32) {
    with_evaluation(|evaluation: &mut Evaluation<F>| {
        evaluation.exponentials.push(Exponential { logarithm, base, parts })
    });
}

/// Whether a number is 0 here; that it is 0 by accident is counted.
fn is_null<F: Modulus>(difference: Modular<F>) -> bool {
    with_evaluation(|evaluation: &mut Evaluation<F>| {
        evaluation.comparisons.record.coincidences += degree_as_f64(difference.size.degree);
        if difference.vanishes() {
            let bits = difference.size.norm.max(1.0).log2();
            evaluation.comparisons.record.compared_bits = evaluation.comparisons.record.compared_bits.max(bits);
        }
    });
    difference.vanishes()
}

impl<F: Modulus> Modular<F> {
    /// e to the power of it.
    pub(super) fn exponential(self) -> Self {
        if self.is_constant_zero() {
            return Self::ONE;
        }
        let (argument, known) = (self.used(), known::<F>());
        for one in &known {
            for (n, d) in multiples() {
                let is_multiple = || is_null(one.logarithm * f64::from(n) - argument * f64::from(d));
                if let Some(power) = one.power_of((n, d))
                    && is_multiple()
                {
                    return power;
                }
            }
        }
        let whole = |one: &Exponential<F>| (one.logarithm, Arithmetic::power(one.base, one.parts));
        let few: Vec<_> = known.iter().filter(|_| known.len() <= MOST).map(whole).collect();
        for (at, (a, of_a)) in few.iter().enumerate() {
            for (b, of_b) in &few[at + 1..] {
                let found = [
                    (*a + *b, *of_a * *of_b),
                    (*a - *b, *of_a / *of_b),
                    (*b - *a, *of_b / *of_a),
                    (-(*a + *b), (*of_a * *of_b).recip()),
                ];
                if let Some((_, value)) = found.into_iter().find(|(sum, _)| is_null(*sum - argument)) {
                    remember(argument, value, 1);
                    return value;
                }
            }
        }
        let base = Self::random_plain();
        remember(argument, base, PARTS);
        Arithmetic::power(base, PARTS)
    }

    /// Its logarithm.
    pub(super) fn logarithm(self) -> Self {
        let (number, known) = (self.used(), known::<F>());
        if is_null(number - 1.0) {
            return Self::ZERO;
        }
        for one in &known {
            for (n, d) in multiples() {
                // Of a number that is not a power itself: its d-th power is the n-th of the other.
                let whole = Arithmetic::power(one.base, one.parts);
                let (above, below) = (Arithmetic::power(whole, n.max(0)), Arithmetic::power(whole, (-n).max(0)));
                if is_null(Arithmetic::power(number, d) * below - above) {
                    return one.logarithm * f64::from(n) / f64::from(d);
                }
            }
        }
        let whole = |one: &Exponential<F>| (one.logarithm, Arithmetic::power(one.base, one.parts));
        let few: Vec<_> = known.iter().filter(|_| known.len() <= MOST).map(whole).collect();
        for (at, (a, of_a)) in few.iter().enumerate() {
            for (b, of_b) in &few[at + 1..] {
                let found = [
                    (*a + *b, number - *of_a * *of_b),
                    (*a - *b, number * *of_b - *of_a),
                    (*b - *a, number * *of_a - *of_b),
                    (-(*a + *b), number * *of_a * *of_b - 1.0),
                ];
                if let Some((sum, _)) = found.into_iter().find(|(_, difference)| is_null(*difference)) {
                    remember(sum, number, 1);
                    return sum;
                }
            }
        }
        let logarithm = Self::random_plain();
        remember(logarithm, number, 1);
        logarithm
    }
}

#[cfg(test)]
mod tests {
    use super::super::modulus::FirstPrime;
    use super::super::{EvaluationRecord, evaluate_at_point, false_accept_log2};
    use super::*;

    type Number = Modular<FirstPrime>;

    /// Whether a difference vanishes at a point, and what happened there.
    fn vanishes(difference: impl Fn(Number, Number) -> Number) -> (bool, bool, EvaluationRecord) {
        let ((value, bound), record) = evaluate_at_point::<FirstPrime, _>(7, 0, 1, || {
            let value = difference(Modular::random(), Modular::random());
            (value.vanishes(), value)
        });
        let small = false_accept_log2(&[bound], &record, 1, Number::most_bits()).is_some_and(|log2| log2 < -80.0);
        (value, small, record)
    }

    #[test]
    fn the_laws_of_exponentials_and_logarithms_hold_and_no_others() {
        let sound: [fn(Number, Number) -> Number; 13] = [
            |x, y| (x + y).exp() - x.exp() * y.exp(),
            |x, y| x.exp() * y.exp() - (x + y).exp(),
            |x, y| (x - y).exp() * y.exp() - x.exp(),
            |x, y| (x * y * 3.0).exp() - (x * y).exp().powi(3),
            |x, y| (x * y * 5.0).exp() - (x * y).exp().powi(5),
            |x, y| (x * y / 2.0).exp().powi(2) - (x * y).exp(),
            |x, _| x.cosh().powi(2) - x.sinh().powi(2) - 1.0,
            |x, _| (x * 2.0).tanh() * (x.cosh().powi(2) + x.sinh().powi(2)) - (x * 2.0).sinh(),
            |x, y| (x * y).ln() - x.ln() - y.ln(),
            |x, y| (x / y).ln() + y.ln() - x.ln(),
            |x, y| (x * x * y * y).ln() - (x * y).ln() * 2.0,
            |x, y| (x * y).exp().ln() - x * y,
            |x, y| (x.ln() * 2.0).exp() * y.ln().exp() - x * x * y,
        ];
        for (at, difference) in sound.into_iter().enumerate() {
            let (vanishes, is_small, record) = vanishes(difference);
            assert!(vanishes && is_small && record.unsupported.is_none(), "{at}: {record:?}");
        }
        let wrong: [fn(Number, Number) -> Number; 8] = [
            |x, y| (x + y).exp() - x.exp() - y.exp(),
            |x, y| (x * y).exp() - x.exp() * y.exp(),
            |x, y| (x * y * 3.0).exp() - (x * y).exp().powi(2),
            |x, y| (x * y * 1.000_000_1).exp() - (x * y).exp(),
            |x, _| x.cosh().powi(2) + x.sinh().powi(2) - 1.0,
            |x, y| (x + y).ln() - x.ln() - y.ln(),
            |x, y| (x * x * y).ln() - (x * y).ln() * 2.0,
            |x, y| (x * y).exp().ln() - x - y,
        ];
        for (at, difference) in wrong.into_iter().enumerate() {
            let (vanishes, _, record) = vanishes(difference);
            // Of what is not known to be equal it is not known that it differs.
            assert!(!vanishes && record.opaque, "{at}");
        }
    }
}
