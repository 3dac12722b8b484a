//! One evaluation at one random point of the field: what is drawn there, and what was met on the way.
//!
//! A number of the field cannot say that it has no square root here, or that it was asked for its sign. Such events are
//! noted by the session that is open on the thread, and whoever opened it reads them in its [`Account`].

use rustc_hash::FxHashMap;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use super::circle::{Point, drawn_bits, turn_bits};
use super::denominators::{Bottom, Denominators, Size, accidents};
use super::exponentials::Exponential;
use super::prime::{Modulus, Residue};
use super::{Modular, SIMPLE_NORM};
use crate::scalar::rational::{Meant, Ratio, meant};

/// What happened in a session.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Account {
    /// Why nothing can be concluded: an operation that a field does not have.
    pub fault: Option<&'static str>,
    /// A denominator vanishes here, or a number has no square root: another point may do.
    pub elsewhere: Option<&'static str>,
    /// How many square roots were taken whose sign is free.
    pub roots: u32,
    /// Whether something was met of which relations are not known to the field: a root, a sine of a product, a constant
    /// that is no simple number. Two sides that differ may then be equal nevertheless.
    pub opaque: bool,
    /// The degree of all that might have been equal by accident.
    pub coincidences: f64,
    /// How many bits the coefficients may have of all that was compared.
    pub compared_bits: f64,
    /// The least common denominator of the multiples of angles.
    pub finest: u64,
}

/// A constant, once read.
#[derive(Clone, Copy)]
pub struct Known<F> {
    pub value: Residue<F>,
    pub size: Size,
    pub bottom: u32,
    /// The fraction, unless it has to do with π.
    pub ratio: Option<Ratio>,
    /// Its place among the angles, if it has to do with π.
    pub angle: Option<u32>,
}

/// A number as an angle: a sum of multiples of what was drawn, and a rest of which nothing is known.
#[derive(Clone, Copy)]
pub struct Angle<F> {
    /// The labels of the multiples, summed.
    pub label: u128,
    /// The value of the rest.
    pub rest: Residue<F>,
    /// The sum of the magnitudes of the multiples.
    pub spread: f64,
    /// Their common denominator.
    pub denominator: u64,
    /// Whether a part of π is in it.
    pub of_pi: bool,
    /// Whether it was divided so that the label is not known.
    pub lost: bool,
}

impl<F: Modulus> Angle<F> {
    /// No angle and no rest.
    pub const NONE: Self =
        Angle { label: 0, rest: Residue::ZERO, spread: 0.0, denominator: 1, of_pi: false, lost: false };

    /// The sum of two.
    pub fn plus(self, other: Self) -> Self {
        Angle {
            label: self.label.wrapping_add(other.label),
            rest: self.rest.plus(other.rest),
            spread: self.spread + other.spread,
            denominator: common_multiple(self.denominator, other.denominator),
            of_pi: self.of_pi || other.of_pi,
            lost: self.lost || other.lost,
        }
    }

    /// A fraction of it.
    pub fn scaled(self, ratio: Ratio, value: Residue<F>) -> Self {
        let halvings = ratio.denominator.trailing_zeros();
        let odd = ratio.denominator >> halvings;
        let multiple = self.label.wrapping_mul(ratio.numerator as i128 as u128);
        // a third of a half turn is no point of this circle
        let divides = multiple.trailing_zeros() >= halvings && !(self.of_pi && odd > 1);
        let halved = ((multiple as i128) >> halvings) as u128;
        Angle {
            label: halved.wrapping_mul(inverse_of_odd(odd.into())),
            rest: self.rest.times(value),
            spread: self.spread * ratio.value().abs(),
            denominator: self.denominator.saturating_mul(ratio.denominator),
            of_pi: self.of_pi,
            lost: self.lost || !divides,
        }
    }
}

fn common_multiple(a: u64, b: u64) -> u64 {
    let gcd = |mut a: u64, mut b: u64| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.max(1)
    };
    (a / gcd(a, b)).saturating_mul(b)
}

/// Whether a fraction is neither a decimal nor simple: what is left of √2 or 1/π, of whose relations nothing is known.
fn is_rough(ratio: Ratio) -> bool {
    let mut rest = ratio.denominator;
    for prime in [2, 5] {
        while rest.is_multiple_of(prime) {
            rest /= prime;
        }
    }
    rest > 100_000
}

/// The inverse of an odd number modulo 2¹²⁸, by Newton's iteration.
fn inverse_of_odd(odd: u128) -> u128 {
    (0..7).fold(1_u128, |x, _| x.wrapping_mul(2_u128.wrapping_sub(odd.wrapping_mul(x))))
}

/// Multiples that are recognised among square roots and among arguments of sines.
const SIMPLE: [(i64, u64); 14] = [
    (1, 1),
    (-1, 1),
    (2, 1),
    (-2, 1),
    (1, 2),
    (-1, 2),
    (3, 1),
    (-3, 1),
    (1, 3),
    (-1, 3),
    (4, 1),
    (-4, 1),
    (1, 4),
    (-1, 4),
];

/// The bits of the square of the largest of these multiples.
const MULTIPLE_BITS: f64 = 4.0;

/// How large a number is as a fraction.
#[derive(Clone, Copy)]
struct Fraction {
    size: Size,
    bottom: Bottom,
}

impl Fraction {
    const ONE: Fraction = Fraction { size: Size::ONE, bottom: 0 };

    fn of<F: Modulus>(number: Modular<F>) -> Self {
        Fraction { size: number.size, bottom: number.bottom }
    }
}

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
    /// By itself, with the value and the bit that it was given when it was first used; or by the number of which it is the
    /// magnitude.
    Itself(Option<(Residue<F>, u32)>, Option<Residue<F>>),
    /// A multiple of a product of earlier roots, or of the quotient of two.
    Of(Residue<F>, Option<usize>, Option<(usize, bool)>),
}

/// What a new square root turns out to be.
pub enum Found {
    /// A fraction: the radicand is its square.
    Ratio(Ratio),
    /// A root with a place.
    Root(u32),
    /// The very root with that place.
    Again(u32),
    /// The magnitude of a number that was drawn, as a root with a place.
    Magnitude(u32),
}

/// The state of a session.
pub struct Session<F: Modulus> {
    generator: Pcg64Mcg,
    points: FxHashMap<u128, Point<F>>,
    pub denominators: Denominators<F>,
    constants: FxHashMap<u64, Known<F>>,
    pub angles: Vec<Angle<F>>,
    pub ratios: Vec<Ratio>,
    roots: Vec<Root<F>>,
    /// Of each root: the root as a number, and what it is the root of.
    pub taken: FxHashMap<u32, (Modular<F>, Modular<F>)>,
    /// Numbers that were drawn, by their squares.
    squares: FxHashMap<u128, Residue<F>>,
    /// Simple numbers by their values, and the largest of their degrees.
    simple: FxHashMap<u128, Modular<F>>,
    simple_degree: u32,
    signs: u32,
    /// The labels of arguments of which only the value is known.
    atoms: Vec<(Residue<F>, u128, Fraction)>,
    /// Exponentials and logarithms that were met.
    pub exponentials: Vec<Exponential<F>>,
    pi: Residue<F>,
    /// The reciprocals that were needed: one takes as long as two hundred products.
    reciprocals: FxHashMap<u128, Residue<F>>,
    pub account: Account,
}

impl<F: Modulus> Session<F> {
    /// A point; the n-th bit of `signs` says which root the n-th square root is.
    pub fn new(seed: u64, signs: u32, finest: u64) -> Self {
        let mut session = Session {
            generator: Pcg64Mcg::seed_from_u64(seed),
            points: FxHashMap::default(),
            denominators: Denominators::new(),
            constants: FxHashMap::default(),
            angles: Vec::new(),
            ratios: Vec::new(),
            roots: Vec::new(),
            taken: FxHashMap::default(),
            squares: FxHashMap::default(),
            simple: [(Residue::<F>::ONE.key(), Modular::ONE)].into_iter().collect(),
            simple_degree: 0,
            signs,
            atoms: Vec::new(),
            exponentials: Vec::new(),
            pi: Residue::ONE,
            reciprocals: FxHashMap::default(),
            account: Account { finest, ..Account::default() },
        };
        session.pi = session.random();
        session
    }

    /// Notes the first reason why nothing can be concluded.
    pub fn fault(&mut self, why: &'static str) {
        self.account.fault.get_or_insert(why);
    }

    fn bits(&mut self) -> u128 {
        (u128::from(self.generator.next_u64()) << 64) | u128::from(self.generator.next_u64())
    }

    /// A random residue, each as probable as the others.
    fn random(&mut self) -> Residue<F> {
        loop {
            let bits = self.bits() >> F::PRIME.leading_zeros();
            if bits < F::PRIME {
                return Residue::new(bits);
            }
        }
    }

    /// A label with room for halvings.
    fn random_label(&mut self) -> u128 {
        (self.bits() & ((1 << drawn_bits::<F>()) - 1)) << F::HALVINGS
    }

    /// Notes that two fractions, or small multiples of them, were found to be equal.
    fn found_equal(&mut self, a: Fraction, b: Fraction) {
        let common = self.denominators.common(a.bottom, b.bottom);
        let difference = a.size.times(common.first).plus(b.size.times(common.second));
        let bits = difference.norm.max(1.0).log2() + MULTIPLE_BITS;
        self.account.compared_bits = self.account.compared_bits.max(bits);
    }

    /// The product of two fractions.
    fn product_of(&mut self, a: Fraction, b: Fraction) -> Fraction {
        Fraction { size: a.size.times(b.size), bottom: self.denominators.product(a.bottom, b.bottom) }
    }

    /// The reciprocal of a residue; 0 for 0.
    pub fn reciprocal(&mut self, residue: Residue<F>) -> Residue<F> {
        *self.reciprocals.entry(residue.key()).or_insert_with(|| residue.inverse())
    }

    /// A random number.
    pub fn drawn_plain(&mut self) -> Residue<F> {
        let value = self.random();
        self.squares.insert(value.square().key(), value);
        value
    }

    /// A random number that is an angle too.
    pub fn drawn(&mut self) -> (Residue<F>, u32) {
        let (value, label) = (self.drawn_plain(), self.random_label());
        (value, self.angle(Angle { label, spread: 1.0, ..Angle::NONE }))
    }

    /// Keeps an angle.
    pub fn angle(&mut self, angle: Angle<F>) -> u32 {
        self.angles.push(angle);
        self.angles.len() as u32 - 1
    }

    /// What a constant is.
    pub fn constant(&mut self, x: f64) -> Known<F> {
        if let Some(known) = self.constants.get(&x.to_bits()) {
            return *known;
        }
        let fraction = |session: &mut Self, ratio: Ratio| {
            let reciprocal = session.reciprocal(Residue::new(ratio.denominator.into()));
            let value = Residue::whole(ratio.numerator).times(reciprocal);
            let size = Size { degree: 0, norm: ratio.numerator.unsigned_abs() as f64 };
            (value, size, session.denominators.whole(ratio.denominator))
        };
        let known = match meant(x) {
            None => {
                // no number at all, or none that could be exact: infinitely large, so that nothing follows
                let size = Size { degree: 0, norm: f64::INFINITY };
                Known { value: Residue::ZERO, size, bottom: 0, ratio: None, angle: None }
            }
            Some(Meant::Ratio(ratio)) => {
                self.account.opaque |= is_rough(ratio);
                let (value, size, bottom) = fraction(self, ratio);
                Known { value, size, bottom, ratio: Some(ratio), angle: None }
            }
            Some(Meant::OfPi(ratio)) => {
                let (value, size, bottom) = fraction(self, ratio);
                let half_turn = Angle { label: 1 << (turn_bits::<F>() - 1), of_pi: true, ..Angle::NONE };
                let angle = self.angle(half_turn.scaled(ratio, value));
                let size = size.times(Size { degree: 1, norm: 1.0 });
                Known { value: value.times(self.pi), size, bottom, ratio: None, angle: Some(angle) }
            }
        };
        self.constants.insert(x.to_bits(), known);
        known
    }

    /// Cosine and sine of an angle, and their degree.
    pub fn point(&mut self, angle: Angle<F>, number: Modular<F>) -> (Point<F>, u32) {
        if angle.lost {
            self.fault("a sine or cosine of such a fraction of an angle");
        }
        let (mut label, mut spread) = (angle.label, angle.spread);
        let mut denominator = angle.denominator;
        if !angle.rest.is_zero() {
            self.account.opaque = true;
            let (of_rest, multiple) = self.atom(angle.rest, number);
            label = label.wrapping_add(of_rest);
            spread += multiple.value().abs();
            denominator = common_multiple(denominator, multiple.denominator);
        }
        self.account.finest = common_multiple(self.account.finest, denominator);
        let point = match self.points.get(&label) {
            Some(point) => *point,
            None => {
                let point = F::circle().at(label);
                self.points.insert(label, point);
                point
            }
        };
        (point, (2.0 * spread * self.account.finest as f64).ceil().min(f64::from(u32::MAX)) as u32)
    }

    /// A label for a value of which nothing else is known, and which multiple it is of one that was drawn.
    fn atom(&mut self, value: Residue<F>, number: Modular<F>) -> (u128, Ratio) {
        let (degree, fraction) = (number.size.degree, Fraction::of(number));
        for (known, label, known_fraction) in self.atoms.clone() {
            for (numerator, denominator) in SIMPLE {
                self.account.coincidences += accidents(degree.max(known_fraction.size.degree));
                // value = (n/d)·known
                let multiple = known.times(Residue::whole(numerator));
                if multiple == value.times(Residue::new(denominator.into())) {
                    self.found_equal(fraction, known_fraction);
                    let ratio = Ratio { numerator, denominator };
                    let angle = Angle::<F> { label, ..Angle::NONE };
                    return (angle.scaled(ratio, Residue::ONE).label, ratio);
                }
            }
        }
        let label = self.random_label();
        self.atoms.push((value, label, fraction));
        (label, Ratio::whole(1))
    }

    /// A square root. Those of simple fractions are fractions; those of multiples, products and quotients of earlier
    /// radicands by simple squares are made of the earlier roots, as those of positive numbers are.
    pub fn root(&mut self, number: Modular<F>) -> Found {
        let (radicand, degree, fraction) = (number.value, number.size.degree, Fraction::of(number));
        let squares = SIMPLE.into_iter().filter(|(n, _)| *n > 0);
        let mut made = None;
        for (numerator, denominator) in squares {
            let (n, d) = (Residue::<F>::whole(numerator), Residue::<F>::new(denominator.into()));
            let (multiple, ratio) = (radicand.times(d.square()), n.times(self.reciprocal(d)));
            if multiple == n.square() {
                self.account.coincidences += accidents(degree);
                self.found_equal(fraction, Fraction::ONE);
                return Found::Ratio(Ratio { numerator, denominator });
            }
            for at in 0..self.roots.len() {
                let (known, of_known) = (self.roots[at].radicand, self.roots[at].fraction);
                self.account.coincidences += accidents(degree.max(self.roots[at].degree));
                if multiple == known.times(n.square()) {
                    self.found_equal(fraction, of_known);
                    if (numerator, denominator) == (1, 1) {
                        return Found::Again(at as u32);
                    }
                    made = made.or(Some(Made::Of(ratio, Some(at), None)));
                }
            }
        }
        let made = made.or_else(|| self.made_of_two(radicand, fraction));
        self.account.coincidences += accidents(degree) * self.squares.len() as f64;
        let magnitude = self.squares.get(&radicand.key()).copied().filter(|_| made.is_none());
        if magnitude.is_some() {
            self.found_equal(fraction, Fraction { size: Size { degree: 2, norm: 1.0 }, bottom: 0 });
        }
        let made = made.unwrap_or(Made::Itself(None, magnitude));
        self.roots.push(Root { radicand, degree, fraction, made });
        let place = self.roots.len() as u32 - 1;
        if magnitude.is_some() { Found::Magnitude(place) } else { Found::Root(place) }
    }

    /// The root of a radicand that is a product or a quotient of two earlier ones.
    fn made_of_two(&mut self, radicand: Residue<F>, fraction: Fraction) -> Option<Made<F>> {
        let known: Vec<_> = self.roots.iter().map(|root| (root.radicand, root.degree, root.fraction)).collect();
        for (at, (first, first_degree, of_first)) in known.iter().enumerate() {
            for (other, (second, second_degree, of_second)) in known.iter().enumerate().filter(|(n, _)| *n != at) {
                self.account.coincidences += accidents(fraction.size.degree.max(*first_degree).max(*second_degree));
                if first.times(*second) == radicand {
                    let product = self.product_of(*of_first, *of_second);
                    self.found_equal(fraction, product);
                    return Some(Made::Of(Residue::ONE, Some(at), Some((other, false))));
                }
                if second.times(radicand) == *first {
                    let product = self.product_of(*of_second, fraction);
                    self.found_equal(product, *of_first);
                    return Some(Made::Of(Residue::ONE, Some(at), Some((other, true))));
                }
            }
        }
        None
    }

    /// The value of a square root, which is needed now: it must exist, and takes a sign. And the irrational roots that it
    /// is made of, a bit each.
    pub fn value_of_root(&mut self, place: usize) -> (Residue<F>, u32) {
        match self.roots[place].made {
            Made::Of(ratio, first, second) => {
                let (first, bits) = first.map_or((Residue::ONE, 0), |first| self.value_of_root(first));
                let (second, more) = second.map_or((Residue::ONE, 0), |(second, inverted)| {
                    let (value, bits) = self.value_of_root(second);
                    (if inverted { self.reciprocal(value) } else { value }, bits)
                });
                (ratio.times(first).times(second), bits | more)
            }
            Made::Itself(value, magnitude) => {
                if let Some(known) = value {
                    return known;
                }
                let Some(root) = magnitude.or_else(|| self.roots[place].radicand.root()) else {
                    self.account.elsewhere = Some("a square root that this field does not have");
                    return (Residue::ONE, 0);
                };
                let negative = self.signs.checked_shr(self.account.roots).unwrap_or(0) & 1 == 1;
                let value = if negative { root.negated() } else { root };
                // a magnitude is rational; of more roots than bits nothing is concluded anyway
                let bit = if magnitude.is_some() { 0 } else { 1 << self.account.roots.min(31) };
                self.account.roots += 1;
                self.account.opaque = true;
                self.roots[place].made = Made::Itself(Some((value, bit)), magnitude);
                (value, bit)
            }
        }
    }

    /// Remembers a simple number by its value.
    pub fn keep(&mut self, number: Modular<F>) {
        let below = self.denominators.size(number.bottom);
        if number.roots == 0 && below.norm < SIMPLE_NORM {
            let known = self.simple.entry(number.value.key()).or_insert(number);
            if number.size.norm < known.size.norm {
                *known = number;
            }
            self.simple_degree = self.simple_degree.max(number.size.degree.saturating_add(below.degree));
        }
    }

    /// The simple number that a large one turns out to be.
    pub fn settle(&mut self, number: Modular<F>) -> Modular<F> {
        let below = self.denominators.size(number.bottom);
        let degree = accidents(number.size.degree) + accidents(below.degree) + accidents(self.simple_degree);
        self.account.coincidences += degree * (self.simple.len() + 1) as f64;
        if number.vanishes() {
            return Modular::ZERO;
        }
        // they are compared over a common denominator, whose coefficients count as well
        let fits = number.size.norm * SIMPLE_NORM + below.norm * SIMPLE_NORM < F::PRIME as f64;
        self.simple.get(&number.value.key()).copied().filter(|_| fits).unwrap_or(number)
    }
}

#[cfg(test)]
mod tests {
    use super::super::prime::Large;
    use super::*;

    #[test]
    fn odd_numbers_have_inverses_modulo_powers_of_two() {
        for odd in (1..100_u128).step_by(2).chain([u128::MAX]) {
            assert_eq!(odd.wrapping_mul(inverse_of_odd(odd)), 1);
        }
    }

    #[test]
    fn what_is_left_of_an_irrational_number_is_opaque() {
        let opaque = |x: f64| {
            let mut session = Session::<Large>::new(1, 0, 1);
            session.constant(x);
            session.account.opaque
        };
        let (root, pi) = (std::f64::consts::SQRT_2, std::f64::consts::PI);
        assert_eq!([root, 1.0 / root, 1.0 / pi, pi * pi].map(opaque), [true; 4]);
        // the twins: a part of π, a decimal, a fraction
        assert_eq!([4.0 * pi / 3.0, 6.674e-11, 1.0 / 720.0].map(opaque), [false; 3]);
    }

    #[test]
    fn a_third_of_three_halves_of_an_angle_is_its_half() {
        let mut session = Session::<Large>::new(1, 0, 1);
        let (_, place) = session.drawn();
        let angle = session.angles[place as usize];
        let by =
            |angle: Angle<Large>, numerator, denominator| angle.scaled(Ratio { numerator, denominator }, Residue::ONE);
        assert_eq!(by(by(angle, 3, 2), 1, 3).label, by(angle, 1, 2).label);
        assert_eq!(by(by(angle, -12, 1), 1, 8).label, by(angle, -3, 2).label);
        assert!(!by(angle, 1, 1 << 10).lost);
        // the twins
        assert_ne!(by(angle, 1, 4).label, by(angle, 1, 2).label);
        assert!(by(angle, 1, 1 << 40).lost);
    }
}
