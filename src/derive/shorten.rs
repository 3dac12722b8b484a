//! The shortest way to write a polynomial in sines and cosines.
//!
//! Pairs of terms are contracted as long as possible: a − a cos² is a sin², a sin² + a cos² is a, and cos α cos β + sin α
//! sin β is cos(α − β). This starts from the form in cosines and from the forms in sines, angle by angle, and the
//! shortest result is used. All forms are equal, so no verdict depends on the choice.

use std::collections::BTreeSet;

use num_traits::{One, Zero};

use super::algebra::{Algebra, Fraction, Pair};
use super::polynomial::{Monomial, Polynomial};
use super::rational::Exact;
use crate::Result;

/// The largest number of angles for which the forms in sines are tried too.
const ANGLES: usize = 5;

impl Algebra {
    /// The same polynomial with the fewest terms that are found.
    pub fn shortened(&self, polynomial: &Polynomial) -> Result<Polynomial> {
        let (one, pairs) = (Exact::one(), self.used(polynomial));
        let canonical = self.canonical(polynomial)?;
        let mut starts = vec![polynomial.clone(), self.rooted(&canonical)?, canonical];
        for pair in pairs.iter().take(if pairs.len() > ANGLES { 0 } else { ANGLES }) {
            for start in starts.clone() {
                let square = Polynomial::one().plus(&Polynomial::term(Monomial::atom(pair.sine, 2), one), -one)?;
                starts.push(exchanged(&start, pair.cosine, &square)?);
            }
        }
        let mut best = polynomial.clone();
        for start in starts {
            let mut short = start;
            loop {
                let before = short.len();
                for pair in &pairs {
                    short = contracted(short, pair)?;
                }
                if short.len() == before {
                    break;
                }
            }
            if weight(&short) < weight(&best) {
                best = short;
            }
        }
        Ok(best)
    }

    /// A fraction with the shortest numerator that is found; sums of angles are restored.
    pub fn presented(&mut self, fraction: &Fraction) -> Result<Fraction> {
        let fraction = self.cancelled(fraction.clone())?;
        let short = self.shortened(&fraction.top)?;
        let top = self.joined(short)?;
        Ok(Fraction { top, ..fraction })
    }

    /// Replaces a multiple of a sum whose root is an atom by a power of the root.
    fn rooted(&self, polynomial: &Polynomial) -> Result<Polynomial> {
        let mut result = polynomial.clone();
        for (atom, degree, value) in self.roots() {
            let mut sum = Polynomial::default();
            for (mut exponent, mut coefficient) in result.powers(atom)? {
                while let Some(quotient) = coefficient.divided_by(value)?.filter(|_| exponent != 0) {
                    coefficient = quotient;
                    exponent += degree as i32;
                }
                sum = sum.plus(&coefficient.scaled(&Monomial::atom(atom, exponent), Exact::one())?, Exact::one())?;
            }
            result = sum;
        }
        Ok(result)
    }

    fn used(&self, polynomial: &Polynomial) -> Vec<Pair> {
        let occurs = |atom: u32| polynomial.terms().any(|(monomial, _)| monomial.exponent(atom) != 0);
        self.pairs().iter().filter(|pair| occurs(pair.sine) || occurs(pair.cosine)).cloned().collect()
    }

    /// The addition theorems backwards, where two terms become one.
    fn joined(&mut self, mut polynomial: Polynomial) -> Result<Polynomial> {
        let pairs = self.used(&polynomial);
        for (i, a) in pairs.iter().enumerate() {
            for b in &pairs[i + 1..] {
                polynomial = self.joined_pair(polynomial, a, b)?;
            }
        }
        Ok(polynomial)
    }

    fn joined_pair(&mut self, mut polynomial: Polynomial, a: &Pair, b: &Pair) -> Result<Polynomial> {
        let one = Exact::one();
        let monomials: Vec<Monomial> = polynomial.terms().map(|(monomial, _)| monomial.clone()).collect();
        for monomial in monomials {
            // (factors of the term, factors of its partner, whether the two make a sine)
            for (mine, theirs, is_sine) in
                [([a.cosine, b.cosine], [a.sine, b.sine], false), ([a.sine, b.cosine], [a.cosine, b.sine], true)]
            {
                if mine.iter().any(|&atom| monomial.exponent(atom) < 1) {
                    continue;
                }
                let rest = monomial.raised(mine[0], -1).raised(mine[1], -1);
                let partner = rest.raised(theirs[0], 1).raised(theirs[1], 1);
                let (own, other) = (polynomial.coefficient(&monomial), polynomial.coefficient(&partner));
                if own.is_zero() || other.is_zero() || own != other && own != -other {
                    continue;
                }
                // cos(α ∓ β) = cos cos ± sin sin, sin(α ± β) = sin cos ± cos sin
                let sign = if (own == other) == is_sine { one } else { -one };
                let (angle, turned) = self.angle(&a.angle, &b.angle, sign)?;
                let joined = self.pair(angle)?;
                polynomial.remove(&monomial);
                polynomial.remove(&partner);
                let atom = if is_sine { joined.sine } else { joined.cosine };
                polynomial.add(rest.raised(atom, 1), if is_sine && turned { -own } else { own })?;
            }
        }
        Ok(polynomial)
    }
}

/// The length of a polynomial in print: its terms, then their denominators, then their factors.
fn weight(polynomial: &Polynomial) -> (usize, usize, u32) {
    let factors = polynomial.terms().flat_map(|(monomial, _)| monomial.factors());
    let below: BTreeSet<Monomial> =
        polynomial.terms().map(|(monomial, _)| monomial.part(|_, exponent| exponent < 0)).collect();
    (polynomial.len(), below.len(), factors.map(|&(_, exponent)| exponent.unsigned_abs()).sum())
}

/// Replaces the square of an atom in every positive power of it.
fn exchanged(polynomial: &Polynomial, atom: u32, square: &Polynomial) -> Result<Polynomial> {
    let mut result = Polynomial::default();
    for (exponent, coefficient) in polynomial.powers(atom)? {
        let (times, rest) = if exponent < 0 { (0, exponent) } else { (exponent / 2, exponent % 2) };
        let factor = Monomial::atom(atom, rest);
        let coefficient = coefficient.times(&square.power(times.unsigned_abs())?)?;
        result = result.plus(&coefficient.scaled(&factor, Exact::one())?, Exact::one())?;
    }
    Ok(result)
}

/// a − a b² → a c² for either of the pair, and a sin² + a cos² → a, while there is any.
fn contracted(mut polynomial: Polynomial, pair: &Pair) -> Result<Polynomial> {
    'again: loop {
        let monomials: Vec<Monomial> = polynomial.terms().map(|(monomial, _)| monomial.clone()).collect();
        for monomial in &monomials {
            let coefficient = polynomial.coefficient(monomial);
            for (a, b) in [(pair.sine, pair.cosine), (pair.cosine, pair.sine)] {
                let squared = monomial.raised(b, 2);
                if polynomial.coefficient(&squared) == -coefficient {
                    polynomial.remove(monomial);
                    polynomial.remove(&squared);
                    polynomial.add(monomial.raised(a, 2), coefficient)?;
                    continue 'again;
                }
            }
            let partner = monomial.raised(pair.sine, -2).raised(pair.cosine, 2);
            if polynomial.coefficient(&partner) == coefficient {
                polynomial.remove(monomial);
                polynomial.remove(&partner);
                polynomial.add(monomial.raised(pair.sine, -2), coefficient)?;
                continue 'again;
            }
        }
        return Ok(polynomial);
    }
}
