//! Whole numbers modulo a Mersenne prime p = 2ᵏ − 1, where reducing is a shift and an addition.

use std::fmt::Debug;
use std::marker::PhantomData;
use std::sync::OnceLock;

use super::circle::Circle;

/// Which Mersenne prime: p = 2^BITS − 1 must be one.
pub trait Modulus: Copy + Debug + Send + Sync + 'static {
    /// How many bits it has.
    const BITS: u32;
    /// How often an angle that is drawn can be halved.
    const HALVINGS: u32;
    /// The prime.
    const PRIME: u128 = (1 << Self::BITS) - 1;

    /// The unit circle over the field, which is found once.
    fn circle() -> &'static Circle<Self>;
}

/// p = 2¹²⁷ − 1, in which identities are decided.
#[derive(Clone, Copy, Debug)]
pub struct Large;

impl Modulus for Large {
    const BITS: u32 = 127;
    const HALVINGS: u32 = 10;

    fn circle() -> &'static Circle<Self> {
        static CIRCLE: OnceLock<Circle<Large>> = OnceLock::new();
        CIRCLE.get_or_init(Circle::new)
    }
}

/// A residue modulo p, from 0 to p − 1.
#[derive(Debug)]
pub struct Residue<F> {
    value: u128,
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
        self.value == other.value
    }
}

impl<F> Eq for Residue<F> {}

impl<F: Modulus> Residue<F> {
    pub const ZERO: Self = Residue { value: 0, prime: PhantomData };
    pub const ONE: Self = Residue { value: 1, prime: PhantomData };

    /// The residue of any number.
    pub fn new(value: u128) -> Self {
        Residue { value: value % F::PRIME, prime: PhantomData }
    }

    /// The residue of a whole number of either sign.
    pub fn whole(value: i64) -> Self {
        let size = Residue::new(value.unsigned_abs().into());
        if value < 0 { size.negated() } else { size }
    }

    /// From 0 to p − 1.
    pub fn value(self) -> u128 {
        self.value
    }

    pub fn is_zero(self) -> bool {
        self.value == 0
    }

    /// Of a number below 2p.
    fn below_twice(value: u128) -> Self {
        Residue { value: if value >= F::PRIME { value - F::PRIME } else { value }, prime: PhantomData }
    }

    pub fn plus(self, other: Self) -> Self {
        Self::below_twice(self.value + other.value)
    }

    pub fn minus(self, other: Self) -> Self {
        Self::below_twice(self.value + (F::PRIME - other.value))
    }

    pub fn negated(self) -> Self {
        Self::below_twice(F::PRIME - self.value)
    }

    pub fn times(self, other: Self) -> Self {
        if F::BITS <= 63 {
            let product = self.value * other.value;
            return Self::below_twice((product & F::PRIME) + (product >> F::BITS));
        }
        // four products of halves, of which the inner two meet
        let split = |x: u128| (x & u128::from(u64::MAX), x >> 64);
        let ((a, b), (c, d)) = (split(self.value), split(other.value));
        let (low, inner, high) = (a * c, a * d + b * c, b * d);
        let (low, carry) = low.overflowing_add(inner << 64);
        let high = high + (inner >> 64) + u128::from(carry);
        // the product is high·2¹²⁸ + low, and 2^BITS counts as 1
        let above = (high << (128 - F::BITS)) | (low >> F::BITS);
        let sum = (low & F::PRIME) + above;
        Self::below_twice((sum & F::PRIME) + (sum >> F::BITS))
    }

    pub fn square(self) -> Self {
        self.times(self)
    }

    /// x^(2ⁿ).
    fn squared_often(self, n: u32) -> Self {
        (0..n).fold(self, |x, _| x.square())
    }

    /// x^(2ⁿ − 1).
    fn power_of_ones(self, n: u32) -> Self {
        if n <= 1 {
            return if n == 0 { Self::ONE } else { self };
        }
        let half = self.power_of_ones(n / 2);
        let both = half.squared_often(n / 2).times(half);
        if n.is_multiple_of(2) { both } else { both.square().times(self) }
    }

    /// The reciprocal; 0 for 0.
    pub fn inverse(self) -> Self {
        // Fermat: p − 2 = 4·(2^(BITS − 2) − 1) + 1
        self.power_of_ones(F::BITS - 2).squared_often(2).times(self)
    }

    /// A square root, if there is one: of the two the one that is a square itself.
    pub fn root(self) -> Option<Self> {
        // p is 3 modulo 4, and (p + 1)/4 = 2^(BITS − 2)
        let root = self.squared_often(F::BITS - 2);
        (root.square() == self).then_some(root)
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use proptest::prelude::*;

    /// p = 2¹³ − 1, small enough for accidents to be counted.
    #[derive(Clone, Copy, Debug)]
    pub struct Small;
    impl Modulus for Small {
        const BITS: u32 = 13;
        const HALVINGS: u32 = 3;

        fn circle() -> &'static Circle<Self> {
            static CIRCLE: OnceLock<Circle<Small>> = OnceLock::new();
            CIRCLE.get_or_init(Circle::new)
        }
    }

    /// p = 2⁶¹ − 1, whose products fit into a machine's word twice over.
    #[derive(Clone, Copy, Debug)]
    pub struct Middle;
    impl Modulus for Middle {
        const BITS: u32 = 61;
        const HALVINGS: u32 = 10;

        fn circle() -> &'static Circle<Self> {
            static CIRCLE: OnceLock<Circle<Middle>> = OnceLock::new();
            CIRCLE.get_or_init(Circle::new)
        }
    }

    fn obeys_the_laws<F: Modulus>(a: u128, b: u128, c: u128) {
        let [a, b, c] = [a, b, c].map(Residue::<F>::new);
        assert_eq!(a.plus(b).times(c), a.times(c).plus(b.times(c)));
        assert_eq!(a.times(b).times(c), a.times(b.times(c)));
        assert_eq!(a.minus(b).plus(b), a);
        assert_eq!(a.plus(a.negated()), Residue::ZERO);
        assert!(a.is_zero() || a.times(a.inverse()) == Residue::ONE);
        assert_eq!(a.square().root().map(Residue::square), Some(a.square()));
        // the twins
        assert!(b.is_zero() || a.plus(b) != a);
        assert!(a.is_zero() || a.square().negated().root().is_none());
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]
        #[test]
        fn residues_are_a_field(a: u128, b: u128, c: u128) {
            obeys_the_laws::<Small>(a, b, c);
            obeys_the_laws::<Middle>(a, b, c);
            obeys_the_laws::<Large>(a, b, c);
        }
    }

    #[test]
    fn products_are_those_of_slow_multiplication() {
        // doubling and adding, bit by bit
        fn slow<F: Modulus>(a: u128, b: u128) -> Residue<F> {
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
            let fast = Residue::<Large>::new(x).times(Residue::new(y));
            assert_eq!(fast, slow::<Large>(x % Large::PRIME, y % Large::PRIME));
            assert_ne!(fast, slow::<Large>(x % Large::PRIME, y % Large::PRIME + 1));
            x = y;
        }
        let last = Residue::<Large>::new(Large::PRIME - 1);
        assert_eq!(last.times(last), Residue::ONE);
    }
}
