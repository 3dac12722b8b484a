//! Polynomials with exact coefficients in numbered atoms. Exponents may be negative.
//!
//! Monomials are ordered lexicographically, which is compatible with multiplication. So the leading monomial of a product
//! is the product of the leading monomials, and division and square roots go term by term.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_traits::{One, Signed, Zero};

use super::rational::{self, Exact};
use crate::{Error, Result};

/// The largest number of products of terms that are multiplied out; a longer formula is not readable.
const BUDGET: usize = 200_000;

/// Atoms with their exponents, in the order of the atoms; no exponent is 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Monomial(Vec<(u32, i32)>);

impl Monomial {
    pub fn atom(atom: u32, exponent: i32) -> Self {
        Monomial(if exponent == 0 { Vec::new() } else { vec![(atom, exponent)] })
    }

    /// Its atoms with their exponents.
    pub fn factors(&self) -> &[(u32, i32)] {
        &self.0
    }

    pub fn exponent(&self, atom: u32) -> i32 {
        self.0.binary_search_by_key(&atom, |&(atom, _)| atom).map_or(0, |i| self.0[i].1)
    }

    pub fn raise(&mut self, atom: u32, exponent: i32) {
        match self.0.binary_search_by_key(&atom, |&(atom, _)| atom) {
            Ok(i) if self.0[i].1 + exponent == 0 => drop(self.0.remove(i)),
            Ok(i) => self.0[i].1 += exponent,
            Err(_) if exponent == 0 => {}
            Err(i) => self.0.insert(i, (atom, exponent)),
        }
    }

    pub fn raised(&self, atom: u32, exponent: i32) -> Self {
        let mut raised = self.clone();
        raised.raise(atom, exponent);
        raised
    }

    pub fn times(&self, other: &Self) -> Self {
        let mut product = self.clone();
        other.0.iter().for_each(|&(atom, exponent)| product.raise(atom, exponent));
        product
    }

    pub fn power(&self, n: i32) -> Self {
        if n == 0 { Monomial::default() } else { Monomial(self.0.iter().map(|&(atom, e)| (atom, e * n)).collect()) }
    }

    /// The monomial with the factors for which `wanted` holds.
    pub fn part(&self, wanted: impl Fn(u32, i32) -> bool) -> Self {
        Monomial(self.0.iter().copied().filter(|&(atom, exponent)| wanted(atom, exponent)).collect())
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        let (mut a, mut b) = (self.0.iter(), other.0.iter());
        let (mut x, mut y) = (a.next(), b.next());
        loop {
            match (x, y) {
                (None, None) => return Ordering::Equal,
                (Some(&(_, e)), None) => return e.cmp(&0),
                (None, Some(&(_, f))) => return 0.cmp(&f),
                (Some(&(i, e)), Some(&(j, f))) => match i.cmp(&j) {
                    Ordering::Less => return e.cmp(&0),
                    Ordering::Greater => return 0.cmp(&f),
                    Ordering::Equal if e != f => return e.cmp(&f),
                    Ordering::Equal => (x, y) = (a.next(), b.next()),
                },
            }
        }
    }
}

/// A sum of monomials with coefficients, none of them 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Polynomial(BTreeMap<Monomial, Exact>);

impl Polynomial {
    pub fn constant(value: Exact) -> Self {
        Polynomial::term(Monomial::default(), value)
    }

    pub fn one() -> Self {
        Polynomial::constant(Exact::one())
    }

    pub fn atom(atom: u32) -> Self {
        Polynomial::term(Monomial::atom(atom, 1), Exact::one())
    }

    pub fn term(monomial: Monomial, coefficient: Exact) -> Self {
        Polynomial(if coefficient.is_zero() { BTreeMap::new() } else { [(monomial, coefficient)].into() })
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// The terms.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, Exact)> {
        self.0.iter().map(|(monomial, &coefficient)| (monomial, coefficient))
    }

    /// The term that leads every product.
    pub fn leading(&self) -> Option<(Monomial, Exact)> {
        self.0.last_key_value().map(|(monomial, &coefficient)| (monomial.clone(), coefficient))
    }

    pub fn coefficient(&self, monomial: &Monomial) -> Exact {
        self.0.get(monomial).copied().unwrap_or_else(Exact::zero)
    }

    /// Its term, if it has exactly one.
    pub fn single(&self) -> Option<(&Monomial, Exact)> {
        self.terms().next().filter(|_| self.len() == 1)
    }

    /// Its value, if it is a number.
    pub fn as_constant(&self) -> Option<Exact> {
        match self.single() {
            None => self.is_zero().then(Exact::zero),
            Some((monomial, value)) => monomial.factors().is_empty().then_some(value),
        }
    }

    pub fn remove(&mut self, monomial: &Monomial) {
        self.0.remove(monomial);
    }

    pub fn add(&mut self, monomial: Monomial, coefficient: Exact) -> Result<()> {
        match self.0.entry(monomial) {
            Entry::Vacant(_) if coefficient.is_zero() => {}
            Entry::Vacant(place) => drop(place.insert(coefficient)),
            Entry::Occupied(mut place) => {
                let sum = rational::plus(*place.get(), coefficient)?;
                if sum.is_zero() {
                    place.remove();
                } else {
                    place.insert(sum);
                }
            }
        }
        Ok(())
    }

    /// self + factor · other.
    pub fn plus(&self, other: &Self, factor: Exact) -> Result<Self> {
        let mut sum = self.clone();
        for (monomial, coefficient) in other.terms() {
            sum.add(monomial.clone(), rational::times(coefficient, factor)?)?;
        }
        Ok(sum)
    }

    pub fn minus(&self, other: &Self) -> Result<Self> {
        self.plus(other, -Exact::one())
    }

    pub fn scaled(&self, monomial: &Monomial, factor: Exact) -> Result<Self> {
        let mut product = Polynomial::default();
        for (own, coefficient) in self.terms() {
            product.add(own.times(monomial), rational::times(coefficient, factor)?)?;
        }
        Ok(product)
    }

    pub fn times(&self, other: &Self) -> Result<Self> {
        if self.len() * other.len() > BUDGET {
            return Err(Error::new("the expression has too many terms to be typeset")
                .help("ask for a simpler quantity, such as the energy or the mass matrix"));
        }
        let mut product = Polynomial::default();
        for (monomial, coefficient) in other.terms() {
            for (own, factor) in self.terms() {
                product.add(own.times(monomial), rational::times(coefficient, factor)?)?;
            }
        }
        Ok(product)
    }

    pub fn power(&self, n: u32) -> Result<Self> {
        (0..n).try_fold(Polynomial::one(), |product, _| product.times(self))
    }

    /// The polynomial of the terms for which `wanted` holds.
    pub fn part(&self, wanted: impl Fn(&Monomial) -> bool) -> Self {
        let wanted = self.terms().filter(|(monomial, _)| wanted(monomial));
        Polynomial(wanted.map(|(monomial, coefficient)| (monomial.clone(), coefficient)).collect())
    }

    /// The lowest and the highest exponent of an atom; a term without it counts as 0.
    pub fn exponents(&self, atom: u32) -> (i32, i32) {
        let exponents = || self.0.keys().map(|monomial| monomial.exponent(atom));
        (exponents().min().unwrap_or(0), exponents().max().unwrap_or(0))
    }

    /// The coefficient of each power of an atom.
    pub fn powers(&self, atom: u32) -> Result<BTreeMap<i32, Polynomial>> {
        let mut powers: BTreeMap<i32, Polynomial> = BTreeMap::new();
        for (monomial, coefficient) in self.terms() {
            let exponent = monomial.exponent(atom);
            powers.entry(exponent).or_default().add(monomial.raised(atom, -exponent), coefficient)?;
        }
        Ok(powers)
    }

    /// The content: each atom with its lowest exponent in all terms, and the largest number that leaves whole
    /// coefficients, with the sign of the leading one.
    pub fn content(&self) -> (Monomial, Exact) {
        let mut terms = self.terms();
        let Some((first, coefficient)) = terms.next() else { return (Monomial::default(), Exact::one()) };
        let (mut monomial, mut number) = (first.clone(), coefficient.abs());
        for (other, coefficient) in terms {
            let atoms: Vec<u32> = monomial.factors().iter().chain(other.factors()).map(|&(atom, _)| atom).collect();
            for atom in atoms {
                let (own, theirs) = (monomial.exponent(atom), other.exponent(atom));
                monomial.raise(atom, own.min(theirs) - own);
            }
            number = rational::common(number, coefficient);
        }
        let negative = self.leading().is_some_and(|(_, leading)| leading.is_negative());
        (monomial, if negative { -number } else { number })
    }

    /// Without its content.
    pub fn primitive(&self) -> Result<Self> {
        let (monomial, number) = self.content();
        self.scaled(&monomial.power(-1), number.recip())
    }

    /// self / other, if that is a polynomial.
    pub fn divided_by(&self, other: &Self) -> Result<Option<Self>> {
        let ((mine, my_number), (theirs, their_number)) = (self.content(), other.content());
        if other.is_zero() {
            return Ok(None);
        }
        let (mut rest, divisor) = (self.primitive()?, other.primitive()?);
        let Some((leading, number)) = divisor.leading() else { return Ok(None) };
        let inverse = leading.power(-1);
        let mut quotient = Polynomial::default();
        while let Some((monomial, coefficient)) = rest.leading() {
            let factor = monomial.times(&inverse);
            if factor.factors().iter().any(|&(_, exponent)| exponent < 0) || quotient.len() > BUDGET {
                return Ok(None);
            }
            let coefficient = rational::times(coefficient, number.recip())?;
            rest = rest.minus(&divisor.scaled(&factor, coefficient)?)?;
            quotient.add(factor, coefficient)?;
        }
        let number = rational::times(my_number, their_number.recip())?;
        quotient.scaled(&mine.times(&theirs.power(-1)), number).map(Some)
    }

    /// The polynomial whose square it is, if there is one.
    pub fn root(&self) -> Result<Option<Self>> {
        let Some((leading, number)) = self.leading() else { return Ok(None) };
        let even = leading.factors().iter().all(|&(_, exponent)| exponent % 2 == 0);
        let (Some(first), true) = (rational::root(number), even) else { return Ok(None) };
        let half = Monomial(leading.factors().iter().map(|&(atom, exponent)| (atom, exponent / 2)).collect());
        let (inverse, twice) = (half.power(-1), rational::plus(first, first)?);
        let mut root = Polynomial::term(half, first);
        let mut rest = self.minus(&root.times(&root)?)?;
        while let Some((monomial, coefficient)) = rest.leading() {
            let next = Polynomial::term(monomial.times(&inverse), rational::times(coefficient, twice.recip())?);
            let negative = |(monomial, _): (&Monomial, _)| monomial.factors().iter().any(|&(_, e)| e < 0);
            if root.len() > self.len() || next.terms().any(negative) {
                return Ok(None);
            }
            rest = rest.minus(&root.times(&next)?)?.minus(&root.times(&next)?)?.minus(&next.times(&next)?)?;
            root = root.plus(&next, Exact::one())?;
        }
        Ok(Some(root))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn x() -> Polynomial {
        Polynomial::atom(0)
    }
    fn y() -> Polynomial {
        Polynomial::atom(1)
    }
    fn plus(a: &Polynomial, b: &Polynomial) -> Polynomial {
        a.plus(b, Exact::one()).unwrap()
    }

    #[test]
    fn products_are_divided_again() {
        let (sum, difference) = (plus(&x(), &y()), x().minus(&y()).unwrap());
        let product = sum.times(&difference).unwrap();
        assert_eq!(product, x().times(&x()).unwrap().minus(&y().times(&y()).unwrap()).unwrap());
        assert_eq!(product.divided_by(&sum).unwrap(), Some(difference.clone()));
        let over = product.scaled(&Monomial::atom(0, -3), Exact::new(2, 3)).unwrap();
        assert_eq!(over.divided_by(&difference).unwrap().unwrap().times(&difference).unwrap(), over);
        // must-fail case: what is no factor does not divide
        assert_eq!(product.divided_by(&plus(&sum, &Polynomial::one())).unwrap(), None);
        assert_eq!(product.divided_by(&Polynomial::default()).unwrap(), None);
    }

    #[test]
    fn squares_have_roots() {
        let root = plus(&x(), &y().scaled(&Monomial::atom(2, 1), Exact::from_integer(-2)).unwrap());
        let square = root.times(&root).unwrap();
        let found = square.root().unwrap().unwrap();
        assert_eq!(found.times(&found).unwrap(), square);
        assert_eq!(plus(&square, &Polynomial::one()).root().unwrap(), None);
        assert_eq!(x().root().unwrap(), None);
    }

    #[test]
    fn the_content_is_what_all_terms_share() {
        let sum = plus(
            &Polynomial::term(Monomial::atom(0, 2), Exact::new(1, 2)),
            &Polynomial::term(Monomial::atom(0, 1).times(&Monomial::atom(1, -1)), Exact::new(-3, 4)),
        );
        let (monomial, number) = sum.content();
        assert_eq!((monomial.exponent(0), monomial.exponent(1)), (1, -1));
        assert_eq!(number, Exact::new(1, 4));
        assert_eq!(sum.primitive().unwrap().scaled(&monomial, number).unwrap(), sum);
    }
}
