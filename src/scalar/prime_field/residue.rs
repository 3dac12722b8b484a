//! Whole numbers modulo a prime p = c·2ᵏ − 1 with a small c.
//!
//! What is asked of p: that it is 3 modulo 4, so that roots are powers and −1 has none; that 2ᵏ divides p + 1, which is
//! how many points the unit circle has, so that angles can be halved; and that 2, 3, 5 and 7 are squares, so that √3 is
//! a number like any other. No Mersenne prime 2ᵏ − 1 gives all of that: in each of them 3 is no square.
//!
//! Residues modulo a large p are kept as x·2¹²⁸ (Montgomery): as p is −1 modulo 2⁶⁴, reducing a product takes one
//! multiplication by (p + 1)/2⁶⁴ for each of its two lower words, and no division.
//!
//! # Why 127 bits
//!
//! With 61 bits, which fit into a word, the coefficients of common formulas such as cos 12θ may exceed p, and
//! several points would be needed where one nearly suffices. A test proves that p = 861·2¹¹⁷ − 1 is a prime with a
//! point on the unit circle of order 2¹¹⁷.

use std::fmt::Debug;
use std::marker::PhantomData;

/// A prime p = ODD·2^BITS − 1.
pub trait Prime: Copy + Debug + Send + Sync + 'static {
    /// The odd factor of p + 1.
    const ODD: u128;
    /// The power of two in p + 1; more than half of the bits of p.
    const BITS: u32;
    /// How often an angle that is drawn can be halved.
    const HALVINGS: u32;
    /// The prime, below 2¹²⁷.
    const PRIME: u128 = (Self::ODD << Self::BITS) - 1;
}

/// A residue modulo p.
#[derive(Debug)]
pub struct Residue<F> {
    /// From 0 to p − 1: times 2¹²⁸, if p is large.
    form: u128,
    prime: PhantomData<F>,
}

impl<F> Clone for Residue<F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for Residue<F> {}

impl<F> PartialEq for Residue<F> {
    fn eq(&self, other: &Self) -> bool {
        self.form == other.form
    }
}

impl<F> Eq for Residue<F> {}

impl<F: Prime> Residue<F> {
    pub const ZERO: Self = Self::of(0);
    pub const ONE: Self = Self::of(if Self::IS_LARGE { Self::power_of_two(128) } else { 1 });

    /// Whether a product needs more than 128 bits.
    const IS_LARGE: bool = F::PRIME >> 63 != 0;
    /// The factor that brings a number into its form.
    const TO_FORM: Self = Self::of(if Self::IS_LARGE { Self::power_of_two(256) } else { 1 });

    const fn of(form: u128) -> Self {
        Residue { form, prime: PhantomData }
    }

    /// 2ⁿ modulo p.
    const fn power_of_two(n: u32) -> u128 {
        let (mut power, mut left) = (1, n);
        while left > 0 {
            power = if 2 * power >= F::PRIME { 2 * power - F::PRIME } else { 2 * power };
            left -= 1;
        }
        power
    }

    /// The residue of any number.
    pub fn new(value: u128) -> Self {
        Self::of(value % F::PRIME).times(Self::TO_FORM)
    }

    /// The residue of a whole number of either sign.
    pub fn whole(value: i64) -> Self {
        let size = Residue::new(value.unsigned_abs().into());
        if value < 0 { size.negated() } else { size }
    }

    /// From 0 to p − 1.
    pub fn value(self) -> u128 {
        if Self::IS_LARGE { self.times(Self::of(1)).form } else { self.form }
    }

    /// A number that is the same for equal residues alone.
    pub fn key(self) -> u128 {
        self.form
    }

    pub fn is_zero(self) -> bool {
        self.form == 0
    }

    /// Of a form below 2p.
    fn below_twice(form: u128) -> Self {
        Self::of(if form >= F::PRIME { form - F::PRIME } else { form })
    }

    pub fn plus(self, other: Self) -> Self {
        Self::below_twice(self.form + other.form)
    }

    pub fn minus(self, other: Self) -> Self {
        Self::below_twice(self.form + (F::PRIME - other.form))
    }

    pub fn negated(self) -> Self {
        Self::below_twice(F::PRIME - self.form)
    }

    pub fn times(self, other: Self) -> Self {
        if !Self::IS_LARGE {
            return Self::of(self.form * other.form % F::PRIME);
        }
        // four products of halves, of which the inner two meet
        let word = u128::from(u64::MAX);
        let split = |x: u128| (x & word, x >> 64);
        let ((a, b), (c, d)) = (split(self.form), split(other.form));
        let (low, inner, high) = (a * c, a * d + b * c, b * d);
        let (low, carry) = low.overflowing_add(inner << 64);
        let high = high + (inner >> 64) + u128::from(carry);
        // (x + m·p)/2⁶⁴ with the lowest word m of x is a whole number, as p + 1 = above·2⁶⁴; done twice
        let above = (F::PRIME >> 64) + 1;
        let second = (low >> 64) + (low & word) * above;
        Self::below_twice(high + (second >> 64) + (second & word) * above)
    }

    pub fn square(self) -> Self {
        self.times(self)
    }

    /// x^(2ⁿ).
    fn squared_often(self, n: u32) -> Self {
        (0..n).fold(self, |x, _| x.square())
    }

    /// xⁿ.
    fn power(self, n: u128) -> Self {
        (0..128 - n.leading_zeros()).rev().fold(Self::ONE, |power, bit| {
            let square = power.square();
            if n >> bit & 1 == 1 { square.times(self) } else { square }
        })
    }

    /// The reciprocal; 0 for 0.
    pub fn inverse(self) -> Self {
        // Fermat: p − 2 is ODD − 1, then BITS − 2 ones, then 01; the ones are appended by sixteen
        let sixteen = self.power(0xffff);
        let ones = F::BITS - 2;
        let mut power = self.power(F::ODD - 1);
        for _ in 0..ones / 16 {
            power = power.squared_often(16).times(sixteen);
        }
        power = power.squared_often(ones % 16).times(self.power((1 << (ones % 16)) - 1));
        power.squared_often(2).times(self)
    }

    /// A square root, if there is one: of the two the one that is a square itself.
    pub fn root(self) -> Option<Self> {
        // p is 3 modulo 4, and (p + 1)/4 = ODD·2^(BITS − 2)
        let root = self.power(F::ODD).squared_often(F::BITS - 2);
        (root.square() == self).then_some(root)
    }
}

#[cfg(test)]
mod tests {
    use super::super::modulus::tests::{Middle, Small};
    use super::super::modulus::{FirstPrime, SecondPrime};
    use super::*;
    use proptest::prelude::*;

    fn obeys_the_laws<F: Prime>(a: u128, b: u128, c: u128) {
        let [a, b, c] = [a, b, c].map(Residue::<F>::new);
        assert_eq!(a.plus(b).times(c), a.times(c).plus(b.times(c)));
        assert_eq!(a.times(b).times(c), a.times(b.times(c)));
        assert_eq!(a.minus(b).plus(b), a);
        assert_eq!(a.plus(a.negated()), Residue::ZERO);
        assert!(a.is_zero() || a.times(a.inverse()) == Residue::ONE);
        assert_eq!(a.square().root().map(Residue::square), Some(a.square()));
        // must-fail cases
        assert!(b.is_zero() || a.plus(b) != a);
        assert!(a.is_zero() || a.square().negated().root().is_none());
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]
        #[test]
        fn residues_are_a_field(a: u128, b: u128, c: u128) {
            obeys_the_laws::<Small>(a, b, c);
            obeys_the_laws::<Middle>(a, b, c);
            obeys_the_laws::<FirstPrime>(a, b, c);
            obeys_the_laws::<SecondPrime>(a, b, c);
        }
    }

    #[test]
    fn products_are_those_of_slow_multiplication() {
        // doubling and adding, bit by bit
        fn slow<F: Prime>(a: u128, b: u128) -> Residue<F> {
            let mut sum = Residue::ZERO;
            for bit in (0..128).rev() {
                sum = sum.plus(sum);
                if b >> bit & 1 == 1 {
                    sum = sum.plus(Residue::new(a));
                }
            }
            sum
        }
        let mut x = 0x1234_5678_9abc_def0_0fed_cba9_8765_4321_u128;
        for _ in 0..200 {
            let y = x.wrapping_mul(0x9e37_79b9_7f4a_7c15_f39c_c060_5ced_c835).rotate_left(17);
            let fast = Residue::<FirstPrime>::new(x).times(Residue::new(y));
            assert_eq!(fast, slow::<FirstPrime>(x % FirstPrime::PRIME, y % FirstPrime::PRIME));
            assert_ne!(fast, slow::<FirstPrime>(x % FirstPrime::PRIME, y % FirstPrime::PRIME + 1));
            x = y;
        }
        let last = Residue::<FirstPrime>::new(FirstPrime::PRIME - 1);
        assert_eq!(last.times(last), Residue::ONE);
        assert_eq!((last.value(), Residue::<FirstPrime>::ONE.value()), (FirstPrime::PRIME - 1, 1));
    }

    #[test]
    fn the_roots_of_small_primes_are_in_the_field() {
        let has_root =
            |n: i64| Residue::<FirstPrime>::whole(n).root().is_some_and(|root| root.square() == Residue::whole(n));
        for n in [2, 3, 5, 6, 7, 10, 14, 15, 21, 35, 210] {
            assert!(has_root(n), "√{n}");
            // must-fail case: of n and −n one alone has a root
            assert!(!has_root(-n), "√−{n}");
        }
        assert!([11, 17].iter().all(|n| !has_root(*n)));
        assert!(Residue::<Middle>::whole(3).root().is_some() && Residue::<Small>::whole(3).root().is_none());
    }
}
