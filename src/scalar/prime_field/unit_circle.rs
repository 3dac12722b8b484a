//! The unit circle c² + s² = 1 over the field: of its p + 1 points, a cyclic group, those 2^BITS of which angles are
//! whole numbers.
//!
//! An angle is a *label*, a whole number of the smallest parts of a turn. Points multiply as labels add, so that the
//! addition theorem, shifts by parts of a turn, multiples and halves of angles hold exactly.

use super::residue::{Prime, Residue};

/// Cosine and sine.
#[derive(Debug)]
pub struct Point<F> {
    pub cosine: Residue<F>,
    pub sine: Residue<F>,
}

impl<F> Clone for Point<F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for Point<F> {}

impl<F: Prime> Point<F> {
    const ONE: Self = Point { cosine: Residue::ONE, sine: Residue::ZERO };

    /// The point at the sum of the angles.
    fn times(self, other: Self) -> Self {
        Point {
            cosine: self.cosine.times(other.cosine).minus(self.sine.times(other.sine)),
            sine: self.sine.times(other.cosine).plus(self.cosine.times(other.sine)),
        }
    }
}

/// How many bits of a label make a turn: labels are counted modulo 2¹²⁸, and what is above a turn tells halves apart.
pub fn turn_bits<F: Prime>() -> u32 {
    F::BITS.min(128 - 1 - F::HALVINGS)
}

/// The number of random bits of a drawn angle: it is one of 2^bits points, and can be halved.
pub fn drawn_bits<F: Prime>() -> u32 {
    turn_bits::<F>() - F::HALVINGS
}

/// The points whose labels are powers of two.
pub struct UnitCircle<F> {
    powers: Vec<Point<F>>,
}

impl<F: Prime> UnitCircle<F> {
    /// Finds a generator and its powers.
    pub fn new() -> Self {
        // (a + i)/(a − i) lies on the circle; the ODD-th power of every second of them generates the group, and the
        // quarter of its turn must be (0, 1), as the sine of a right angle is 1
        let mut powers = Vec::with_capacity(F::BITS as usize);
        for a in 2.. {
            let (a, one) = (Residue::<F>::whole(a), Residue::ONE);
            let length = a.square().plus(one).inverse();
            let start = Point { cosine: a.square().minus(one).times(length), sine: a.plus(a).times(length) };
            powers.clear();
            let mut point = (0..F::ODD).fold(Point::ONE, |power, _| power.times(start));
            for _ in 0..F::BITS {
                powers.push(point);
                point = point.times(point);
            }
            let half = powers[F::BITS as usize - 1];
            let quarter = powers[F::BITS as usize - 2];
            if half.cosine == one.negated() && quarter.sine == one {
                break;
            }
        }
        UnitCircle { powers: powers.split_off((F::BITS - turn_bits::<F>()) as usize) }
    }

    /// The point at a label.
    pub fn at(&self, label: u128) -> Point<F> {
        let chosen = self.powers.iter().enumerate().filter(|(bit, _)| label >> bit & 1 == 1);
        chosen.fold(Point::ONE, |point, (_, power)| point.times(*power))
    }
}

#[cfg(test)]
mod tests {
    use super::super::modulus::tests::{Middle, Small};
    use super::super::modulus::{FirstPrime, SecondPrime};
    use super::*;

    fn is_a_circle<F: Prime>() {
        let circle = UnitCircle::<F>::new();
        let quarter = 1_u128 << (turn_bits::<F>() - 2);
        let (one, zero) = (Residue::ONE, Residue::ZERO);
        for (label, cosine, sine) in [
            (0, one, zero),
            (quarter, zero, one),
            (2 * quarter, one.negated(), zero),
            (3 * quarter, zero, one.negated()),
        ] {
            assert_eq!((circle.at(label).cosine, circle.at(label).sine), (cosine, sine));
        }
        let (a, b) = (0x1357_9bdf_u128, 0x0246_8ace_1122_u128);
        let (at_a, at_b, sum) = (circle.at(a), circle.at(b), circle.at(a + b));
        assert_eq!(at_a.cosine.square().plus(at_a.sine.square()), one);
        assert_eq!(sum.sine, at_a.sine.times(at_b.cosine).plus(at_a.cosine.times(at_b.sine)));
        // must-fail case: another angle is another point
        assert!(circle.at(a + b + 1).sine != sum.sine);
        // and labels beyond a turn begin again
        assert_eq!(circle.at(a + 4 * quarter).sine, at_a.sine);
    }

    /// Proves that p is a prime, of arithmetic modulo p alone: the point z at a turn's 2^BITS-th part has a reciprocal
    /// norm that was divided by, and z to the half of 2^BITS is −1. Let r be a prime factor of p. Modulo r as well z
    /// then has the order 2^BITS, in a group of r + 1 or r − 1 points. So r is at least 2^BITS − 1; and were p no
    /// prime, it would have a factor of no more than its root.
    fn is_a_field<F: Prime>() {
        let circle = UnitCircle::<F>::new();
        let first = circle.powers[0];
        assert_eq!(first.cosine.square().plus(first.sine.square()), Residue::ONE);
        let turn = circle.powers.len() as u32;
        let half = (1..turn).fold(first, |point, _| point.times(point));
        assert_eq!((half.cosine, half.sine), (Residue::ONE.negated(), Residue::ZERO));
        assert_ne!(F::PRIME % 2, 0);
        assert!(((1_u128 << turn) - 2) > F::PRIME.isqrt(), "2^{turn}");
        // p is 3 modulo 4, of which roots make use
        assert_eq!(F::PRIME % 4, 3);
    }

    #[test]
    fn the_moduli_are_primes() {
        is_a_field::<Small>();
        is_a_field::<Middle>();
        is_a_field::<FirstPrime>();
        is_a_field::<SecondPrime>();
    }

    /// 9·2⁹ − 1 = 17·271.
    #[derive(Clone, Copy, Debug)]
    struct Composite;
    impl Prime for Composite {
        const ODD: u128 = 9;
        const BITS: u32 = 9;
        const HALVINGS: u32 = 3;
    }

    #[test]
    fn no_point_proves_a_product_to_be_a_prime() {
        let (one, zero) = (Residue::<Composite>::ONE, Residue::ZERO);
        for cosine in 0..Composite::PRIME as i64 {
            for sine in 0..40 {
                let start = Point { cosine: Residue::<Composite>::whole(cosine), sine: Residue::whole(sine) };
                if start.cosine.square().plus(start.sine.square()) == one {
                    let half = (1..Composite::BITS).fold(start, |point, _| point.times(point));
                    assert!((half.cosine, half.sine) != (one.negated(), zero));
                }
            }
        }
    }

    #[test]
    fn labels_add_as_angles_do() {
        is_a_circle::<Small>();
        is_a_circle::<Middle>();
        is_a_circle::<FirstPrime>();
        is_a_circle::<SecondPrime>();
    }
}
