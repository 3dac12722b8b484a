//! Numbers of small size, by their values: a large expression that has the value of one of them is taken to be it.

use rustc_hash::FxHashMap;

use super::comparisons::Comparisons;
use super::denominators::degree_as_f64;
use super::modulus::Modulus;
use super::number::Modular;
use super::residue::Residue;

/// Numbers with smaller coefficients than this are simple enough to be remembered.
pub const SIMPLE_NORM: f64 = 64.0;

/// The simple numbers of an evaluation.
pub struct SimpleNumbers<F: Modulus> {
    by_value: FxHashMap<u128, Modular<F>>,
    highest_degree: u32,
}

impl<F: Modulus> SimpleNumbers<F> {
    pub fn new() -> Self {
        SimpleNumbers { by_value: [(Residue::<F>::ONE.key(), Modular::ONE)].into_iter().collect(), highest_degree: 0 }
    }

    /// Remembers a simple number by its value.
    pub fn keep(&mut self, number: Modular<F>, comparisons: &mut Comparisons<F>) {
        let below = comparisons.denominators.size(number.denominator);
        if number.roots == 0 && below.norm < SIMPLE_NORM {
            let known = self.by_value.entry(number.value.key()).or_insert(number);
            if number.size.norm < known.size.norm {
                *known = number;
            }
            self.highest_degree = self.highest_degree.max(number.size.degree.saturating_add(below.degree));
        }
    }

    /// The simple number that a large one turns out to be.
    pub fn settle(&mut self, number: Modular<F>, comparisons: &mut Comparisons<F>) -> Modular<F> {
        let below = comparisons.denominators.size(number.denominator);
        let degree =
            degree_as_f64(number.size.degree) + degree_as_f64(below.degree) + degree_as_f64(self.highest_degree);
        comparisons.record.coincidences += degree * (self.by_value.len() + 1) as f64;
        if number.vanishes() {
            return Modular::ZERO;
        }
        // they are compared over a common denominator, whose coefficients count as well
        let fits = number.size.norm * SIMPLE_NORM + below.norm * SIMPLE_NORM < F::PRIME as f64;
        self.by_value.get(&number.value.key()).copied().filter(|_| fits).unwrap_or(number)
    }
}
