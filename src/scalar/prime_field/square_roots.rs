//! Square roots over the field.
//!
//! A root is known by its radicand until its value is needed. Roots of multiples, products and quotients of earlier
//! radicands are the same multiples, products and quotients of the earlier roots, as those of positive numbers are.

use rustc_hash::FxHashMap;

use super::comparisons::{Comparisons, Fraction, SIMPLE_MULTIPLES};
use super::denominators::{Size, degree_as_f64};
use super::modulus::Modulus;
use super::number::Modular;
use super::residue::Residue;
use crate::scalar::rational::Ratio;

/// A square root, known by what it is the root of.
struct Root<F> {
    radicand: Residue<F>,
    degree: u32,
    fraction: Fraction,
    made: Made<F>,
}

/// How a square root comes by its value.
#[derive(Clone, Copy)]
enum Made<F> {
    /// By itself, with the value and the bit that it was given when it was first used; or by the number of which it is
    /// the magnitude.
    Itself(Option<(Residue<F>, u32)>, Option<Residue<F>>),
    /// A multiple of a product of earlier roots, or of the quotient of two.
    Of(Residue<F>, Option<usize>, Option<(usize, bool)>),
}

/// What a new square root turns out to be.
pub enum RootFound {
    /// A fraction: the radicand is its square.
    Ratio(Ratio),
    /// A root with a place.
    Root(u32),
    /// The very root with that place.
    Again(u32),
    /// The magnitude of a number that was drawn, as a root with a place.
    Magnitude(u32),
}

/// The square roots of an evaluation.
pub struct SquareRoots<F: Modulus> {
    roots: Vec<Root<F>>,
    /// Of each root: the root as a number, and its radicand.
    pub taken: FxHashMap<u32, (Modular<F>, Modular<F>)>,
    /// Numbers that were drawn, by their squares.
    pub drawn_by_square: FxHashMap<u128, Residue<F>>,
    /// The n-th bit is the sign of the n-th root.
    signs: u32,
}

impl<F: Modulus> SquareRoots<F> {
    pub fn new(signs: u32) -> Self {
        SquareRoots { roots: Vec::new(), taken: FxHashMap::default(), drawn_by_square: FxHashMap::default(), signs }
    }

    /// A square root. Those of simple fractions are fractions; those of multiples, products and quotients of earlier
    /// radicands by simple squares are made of the earlier roots, as those of positive numbers are.
    pub fn root(&mut self, number: Modular<F>, comparisons: &mut Comparisons<F>) -> RootFound {
        let (radicand, degree, fraction) = (number.value, number.size.degree, Fraction::of(number));
        let squares = SIMPLE_MULTIPLES.into_iter().filter(|(n, _)| *n > 0);
        let mut made = None;
        for (numerator, denominator) in squares {
            let (n, d) = (Residue::<F>::whole(numerator), Residue::<F>::new(denominator.into()));
            let (multiple, ratio) = (radicand.times(d.square()), n.times(comparisons.reciprocal(d)));
            if multiple == n.square() {
                comparisons.record.coincidences += degree_as_f64(degree);
                comparisons.found_equal(fraction, Fraction::ONE);
                return RootFound::Ratio(Ratio { numerator, denominator });
            }
            for at in 0..self.roots.len() {
                let (known, of_known) = (self.roots[at].radicand, self.roots[at].fraction);
                comparisons.record.coincidences += degree_as_f64(degree.max(self.roots[at].degree));
                if multiple == known.times(n.square()) {
                    comparisons.found_equal(fraction, of_known);
                    if (numerator, denominator) == (1, 1) {
                        return RootFound::Again(at as u32);
                    }
                    made = made.or(Some(Made::Of(ratio, Some(at), None)));
                }
            }
        }
        let made = made.or_else(|| self.made_of_two(radicand, fraction, comparisons));
        comparisons.record.coincidences += degree_as_f64(degree) * self.drawn_by_square.len() as f64;
        let magnitude = self.drawn_by_square.get(&radicand.key()).copied().filter(|_| made.is_none());
        if magnitude.is_some() {
            comparisons.found_equal(fraction, Fraction { size: Size { degree: 2, norm: 1.0 }, denominator: 0 });
        }
        let made = made.unwrap_or(Made::Itself(None, magnitude));
        self.roots.push(Root { radicand, degree, fraction, made });
        let place = self.roots.len() as u32 - 1;
        if magnitude.is_some() { RootFound::Magnitude(place) } else { RootFound::Root(place) }
    }

    /// The root of a radicand that is a product or a quotient of two earlier ones.
    fn made_of_two(
        &mut self,
        radicand: Residue<F>,
        fraction: Fraction,
        comparisons: &mut Comparisons<F>,
    ) -> Option<Made<F>> {
        let known: Vec<_> = self.roots.iter().map(|root| (root.radicand, root.degree, root.fraction)).collect();
        for (at, (first, first_degree, of_first)) in known.iter().enumerate() {
            for (other, (second, second_degree, of_second)) in known.iter().enumerate().filter(|(n, _)| *n != at) {
                comparisons.record.coincidences +=
                    degree_as_f64(fraction.size.degree.max(*first_degree).max(*second_degree));
                if first.times(*second) == radicand {
                    let product = comparisons.product_of(*of_first, *of_second);
                    comparisons.found_equal(fraction, product);
                    return Some(Made::Of(Residue::ONE, Some(at), Some((other, false))));
                }
                if second.times(radicand) == *first {
                    let product = comparisons.product_of(*of_second, fraction);
                    comparisons.found_equal(product, *of_first);
                    return Some(Made::Of(Residue::ONE, Some(at), Some((other, true))));
                }
            }
        }
        None
    }

    /// The value of a square root with its sign, and one bit for each irrational root that it is made of. Where the
    /// field has no such root, that is recorded.
    pub fn value_of_root(&mut self, place: usize, comparisons: &mut Comparisons<F>) -> (Residue<F>, u32) {
        match self.roots[place].made {
            Made::Of(ratio, first, second) => {
                let (first, bits) = first.map_or((Residue::ONE, 0), |first| self.value_of_root(first, comparisons));
                let (second, more) = second.map_or((Residue::ONE, 0), |(second, inverted)| {
                    let (value, bits) = self.value_of_root(second, comparisons);
                    (if inverted { comparisons.reciprocal(value) } else { value }, bits)
                });
                (ratio.times(first).times(second), bits | more)
            }
            Made::Itself(value, magnitude) => {
                if let Some(known) = value {
                    return known;
                }
                let Some(root) = magnitude.or_else(|| self.roots[place].radicand.root()) else {
                    comparisons.record.undefined_here =
                        Some("a square root that does not exist modulo the prime of the test");
                    return (Residue::ONE, 0);
                };
                let negative = self.signs.checked_shr(comparisons.record.roots).unwrap_or(0) & 1 == 1;
                let value = if negative { root.negated() } else { root };
                // a magnitude is rational; of more roots than bits nothing is concluded anyway
                let bit = if magnitude.is_some() { 0 } else { 1 << comparisons.record.roots.min(31) };
                comparisons.record.roots += 1;
                comparisons.record.opaque = true;
                self.roots[place].made = Made::Itself(Some((value, bit)), magnitude);
                (value, bit)
            }
        }
    }
}
