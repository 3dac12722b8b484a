//! The denominators of numbers, were each written as one fraction: products of powers of known factors.
//!
//! The bound on false acceptance needs the degree of the numerator. Were every denominator a polynomial of its own, a
//! sum of fractions would multiply them all; so a divisor is remembered as a *factor*, known by its value at the point,
//! and fractions over the same factors are added over their least common multiple.

use rustc_hash::FxHashMap;

use super::residue::{Prime, Residue};

/// How large a polynomial can be: its degree, and the sum of the magnitudes of its coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// The total degree.
    pub degree: u32,
    /// The sum of the coefficients' magnitudes.
    pub norm: f64,
}

/// A degree as a number of accidents: what has left its range is without bound.
pub fn degree_as_f64(degree: u32) -> f64 {
    if degree == u32::MAX { f64::INFINITY } else { f64::from(degree) }
}

impl Size {
    /// Of the number 1.
    pub const ONE: Size = Size { degree: 0, norm: 1.0 };
    /// Of a variable.
    pub const VARIABLE: Size = Size { degree: 1, norm: 1.0 };
    /// Of the number 0.
    pub const ZERO: Size = Size { degree: 0, norm: 0.0 };

    pub fn plus(self, other: Size) -> Size {
        Size { degree: self.degree.max(other.degree), norm: self.norm + other.norm }
    }

    pub fn times(self, other: Size) -> Size {
        // 0 times anything is 0, also where the other has become infinite
        if self.norm == 0.0 || other.norm == 0.0 {
            return Size::ZERO;
        }
        Size { degree: self.degree.saturating_add(other.degree), norm: self.norm * other.norm }
    }
}

/// One denominator among [`Denominators`]; 0 is the number 1.
pub type DenominatorId = u32;

struct Factor<F> {
    value: Residue<F>,
    size: Size,
}

#[derive(Clone)]
struct Entry<F> {
    /// Factors with their exponents, in the order of the factors.
    factors: Vec<(u32, u32)>,
    value: Residue<F>,
    size: Size,
}

/// A common denominator, and what each of the two numerators is multiplied with.
#[derive(Clone, Copy)]
pub struct Common {
    pub denominator: DenominatorId,
    pub first: Size,
    pub second: Size,
}

/// All denominators at one point.
pub struct Denominators<F> {
    factors: Vec<Factor<F>>,
    by_value: FxHashMap<u128, u32>,
    entries: Vec<Entry<F>>,
    places: FxHashMap<Vec<(u32, u32)>, DenominatorId>,
    wholes: FxHashMap<u64, DenominatorId>,
    products: FxHashMap<(DenominatorId, DenominatorId), DenominatorId>,
    common: FxHashMap<(DenominatorId, DenominatorId), Common>,
    /// The largest sum of coefficients of a factor that was met again.
    repeated: f64,
}

impl<F: Prime> Denominators<F> {
    pub fn new() -> Self {
        let one = Entry { factors: Vec::new(), value: Residue::ONE, size: Size::ONE };
        Denominators {
            factors: Vec::new(),
            by_value: FxHashMap::default(),
            entries: vec![one],
            places: [(Vec::new(), 0)].into_iter().collect(),
            wholes: FxHashMap::default(),
            products: FxHashMap::default(),
            common: FxHashMap::default(),
            repeated: 0.0,
        }
    }

    /// The degree of all that might have been taken for one factor by accident: each pair of them was compared.
    pub fn coincidences(&self) -> f64 {
        if self.factors.is_empty() {
            return 0.0;
        }
        let highest = self.factors.iter().map(|factor| factor.size.degree).max().unwrap_or(0);
        degree_as_f64(highest) * (self.factors.len() * self.factors.len()) as f64
    }

    /// How many bits the coefficients may have of the difference of two factors that were taken for one.
    pub fn compared_bits(&self) -> f64 {
        self.repeated.max(1.0).log2() + 1.0
    }

    /// The value of a denominator.
    pub fn value(&self, denominator: DenominatorId) -> Residue<F> {
        self.entries[denominator as usize].value
    }

    /// Its size as a polynomial.
    pub fn size(&self, denominator: DenominatorId) -> Size {
        self.entries[denominator as usize].size
    }

    fn entry(&mut self, factors: Vec<(u32, u32)>) -> DenominatorId {
        if let Some(known) = self.places.get(&factors) {
            return *known;
        }
        let (mut value, mut size) = (Residue::ONE, Size::ONE);
        for &(factor, exponent) in &factors {
            for _ in 0..exponent {
                value = value.times(self.factors[factor as usize].value);
                size = size.times(self.factors[factor as usize].size);
            }
        }
        let place = self.entries.len() as DenominatorId;
        self.entries.push(Entry { factors: factors.clone(), value, size });
        self.places.insert(factors, place);
        place
    }

    /// A denominator that is one factor, with its size as a polynomial.
    pub fn factor(&mut self, value: Residue<F>, size: Size) -> DenominatorId {
        let next = self.factors.len() as u32;
        let place = *self.by_value.entry(value.key()).or_insert(next);
        if let Some(known) = self.factors.get(place as usize) {
            self.repeated = self.repeated.max(known.size.norm).max(size.norm);
        }
        match self.factors.get_mut(place as usize) {
            None => self.factors.push(Factor { value, size }),
            // one value, met with two sizes: the larger counts
            Some(known) if known.size.degree < size.degree || known.size.norm < size.norm => {
                known.size = Size { degree: known.size.degree.max(size.degree), norm: known.size.norm.max(size.norm) };
            }
            Some(_) => {}
        }
        self.entry(vec![(place, 1)])
    }

    /// A whole number as a denominator, prime by prime.
    pub fn whole(&mut self, whole: u64) -> DenominatorId {
        if let Some(known) = self.wholes.get(&whole) {
            return *known;
        }
        let (mut number, mut denominator) = (whole, 0);
        let mut divide = |prime: u64, all: &mut Self| {
            let size = Size { degree: 0, norm: prime as f64 };
            let factor = all.factor(Residue::new(prime.into()), size);
            denominator = all.product(denominator, factor);
        };
        let mut prime = 2;
        while prime * prime <= number && prime < 1000 {
            while number.is_multiple_of(prime) {
                divide(prime, self);
                number /= prime;
            }
            prime += 1;
        }
        if number > 1 {
            divide(number, self);
        }
        self.wholes.insert(whole, denominator);
        denominator
    }

    /// The product of two denominators.
    pub fn product(&mut self, a: DenominatorId, b: DenominatorId) -> DenominatorId {
        if a == 0 || b == 0 {
            return a + b;
        }
        let key = (a.min(b), a.max(b));
        if let Some(known) = self.products.get(&key) {
            return *known;
        }
        let factors = self.combined(a, b, |m, n| m + n);
        let product = self.entry(factors);
        self.products.insert(key, product);
        product
    }

    /// The least common multiple of two denominators.
    pub fn common(&mut self, a: DenominatorId, b: DenominatorId) -> Common {
        if let Some(known) = self.common.get(&(a, b)) {
            return *known;
        }
        let factors = self.combined(a, b, u32::max);
        let denominator = self.entry(factors);
        let common = Common { denominator, first: self.missing(a, denominator), second: self.missing(b, denominator) };
        self.common.insert((a, b), common);
        common
    }

    /// Both without what they share.
    pub fn reduced(&mut self, a: DenominatorId, b: DenominatorId) -> (DenominatorId, DenominatorId) {
        if a == 0 || b == 0 {
            return (a, b);
        }
        let (of_a, of_b) = (self.combined(a, b, u32::saturating_sub), self.combined(b, a, u32::saturating_sub));
        (self.entry(of_a), self.entry(of_b))
    }

    /// The factors of two denominators, with exponents that are made of theirs.
    fn combined(&self, a: DenominatorId, b: DenominatorId, exponent: impl Fn(u32, u32) -> u32) -> Vec<(u32, u32)> {
        let (a, b) = (&self.entries[a as usize].factors, &self.entries[b as usize].factors);
        let of = |all: &[(u32, u32)], factor: u32| {
            all.iter().find(|(known, _)| *known == factor).map_or(0, |(_, exponent)| *exponent)
        };
        let mut factors: Vec<u32> = a.iter().chain(b).map(|(factor, _)| *factor).collect();
        factors.sort_unstable();
        factors.dedup();
        let with_exponents = factors.into_iter().map(|factor| (factor, exponent(of(a, factor), of(b, factor))));
        with_exponents.filter(|(_, exponent)| *exponent > 0).collect()
    }

    /// The factor of a numerator over `from` when its denominator becomes `to`, a multiple of `from`.
    fn missing(&self, from: DenominatorId, to: DenominatorId) -> Size {
        let missing = self.combined(to, from, u32::saturating_sub);
        missing.iter().fold(Size::ONE, |size, &(factor, exponent)| {
            (0..exponent).fold(size, |size, _| size.times(self.factors[factor as usize].size))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::modulus::FirstPrime;
    use super::*;

    #[test]
    fn fractions_over_one_factor_do_not_multiply() {
        let mut all = Denominators::<FirstPrime>::new();
        let size = Size { degree: 3, norm: 5.0 };
        let factor = all.factor(Residue::new(1234), size);
        let square = all.product(factor, factor);
        let sum = all.common(factor, square);
        assert_eq!(sum.denominator, square);
        assert_eq!((sum.first, sum.second), (size, Size::ONE));
        assert_eq!(all.size(square), Size { degree: 6, norm: 25.0 });
        assert_eq!(all.reduced(square, factor), (factor, 0));
        // must-fail case: another factor does
        let other = all.factor(Residue::new(4321), size);
        assert_eq!(all.common(factor, other).first, size);
    }

    #[test]
    fn sixths_and_quarters_are_twelfths() {
        let mut all = Denominators::<FirstPrime>::new();
        let (six, four) = (all.whole(6), all.whole(4));
        let common = all.common(six, four);
        assert_eq!(all.value(common.denominator), Residue::new(12));
        assert_eq!((common.first.norm, common.second.norm), (2.0, 3.0));
    }
}
