//! Quotients of polynomials in atoms, and the relations between the atoms: sin² = 1 − cos², √x² = x.
//!
//! An [`Algebra`] knows its atoms. An atom is an input, π, or a function of something that is in normal form itself. A
//! relation expresses a power of an atom by earlier atoms. [`Algebra::canonical`] applies the relations until nothing
//! changes, so that a formula that is always 0 becomes 0. A denominator is a product of powers of polynomials without
//! content. A single term is never a denominator, since exponents may be negative.

use std::collections::{BTreeMap, HashMap};

use num_traits::{One, Signed, Zero};

use super::polynomial::{Monomial, Polynomial};
use super::rational::Exact;
use crate::scalar::Function;
use crate::{Error, Result};

/// The upper limit of exponents.
const HIGHEST: u32 = 1 << 16;

/// An atom of a polynomial.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Atom {
    /// The n-th input.
    Input(u32),
    /// The circle constant.
    Pi,
    /// An elementary function.
    Call(Function, Fraction),
    /// The n-th root.
    Root(u32, Fraction),
}

/// A polynomial over powers of polynomials.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Fraction {
    /// The numerator.
    pub top: Polynomial,
    /// The denominator, factor by factor: each has more than one term and no content.
    pub under: BTreeMap<Polynomial, u32>,
}

impl Fraction {
    /// The number of terms in the numerator and the denominator.
    pub fn len(&self) -> usize {
        self.top.len() + self.under.keys().map(Polynomial::len).sum::<usize>()
    }
}

impl From<Polynomial> for Fraction {
    fn from(top: Polynomial) -> Self {
        Fraction { top, under: BTreeMap::new() }
    }
}

/// The sine and the cosine of one angle.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub angle: Polynomial,
    pub sine: u32,
    pub cosine: u32,
}

/// The atoms and their relations.
#[derive(Default)]
pub(super) struct Algebra {
    atoms: Vec<Atom>,
    places: HashMap<Atom, u32>,
    /// For each atom with a relation: the power, and the polynomial that it equals.
    relations: BTreeMap<u32, (u32, Polynomial)>,
    pairs: Vec<Pair>,
    /// The limit of work for one normal form, if there is one.
    pub work: Option<usize>,
}

impl Algebra {
    /// The algebra of so many inputs; the n-th input is the n-th atom.
    pub fn of_inputs(count: usize) -> Self {
        let mut algebra = Algebra::default();
        for n in 0..count as u32 {
            algebra.intern(Atom::Input(n));
        }
        algebra
    }

    /// The same with a limit of work for one normal form, which fails beyond it.
    pub fn bounded(self, work: usize) -> Self {
        Algebra { work: Some(work), ..self }
    }

    /// The number of atoms in a fraction as it is written out, with those within others.
    pub fn written(&self, fraction: &Fraction) -> usize {
        let mut sizes: Vec<usize> = Vec::with_capacity(self.atoms.len());
        let of = |fraction: &Fraction, sizes: &[usize]| {
            let all = std::iter::once(&fraction.top).chain(fraction.under.keys()).flat_map(Polynomial::terms);
            let factors = all.flat_map(|(monomial, _)| monomial.factors());
            let size = |(atom, _): &(u32, i32)| sizes.get(*atom as usize).copied().unwrap_or(1);
            factors.map(size).fold(1_usize, usize::saturating_add)
        };
        for atom in &self.atoms {
            sizes.push(match atom {
                Atom::Input(_) | Atom::Pi => 1,
                Atom::Call(_, inner) | Atom::Root(_, inner) => of(inner, &sizes),
            });
        }
        of(fraction, &sizes)
    }

    /// The atom of an input.
    pub fn input_place(&self, n: usize) -> u32 {
        self.places.get(&Atom::Input(n as u32)).copied().unwrap_or(u32::MAX)
    }

    pub fn intern(&mut self, atom: Atom) -> u32 {
        let next = self.atoms.len() as u32;
        let place = *self.places.entry(atom.clone()).or_insert(next);
        if place == next {
            self.atoms.push(atom);
        }
        place
    }

    pub fn input(&mut self, n: u32) -> Polynomial {
        Polynomial::atom(self.intern(Atom::Input(n)))
    }

    pub fn atom(&self, place: u32) -> &Atom {
        &self.atoms[place as usize]
    }

    /// The roots of sums: the atom, the power with a relation, and the sum that it equals.
    pub fn roots(&self) -> impl Iterator<Item = (u32, u32, &Polynomial)> {
        let is_root = |atom: u32| matches!(self.atom(atom), Atom::Root(..));
        let relations = self.relations.iter().filter(move |(atom, (_, value))| is_root(**atom) && value.len() > 1);
        relations.map(|(&atom, (degree, value))| (atom, *degree, value))
    }

    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// An elementary function as an atom of its own.
    pub fn call(&mut self, function: Function, of: Fraction) -> Polynomial {
        Polynomial::atom(self.intern(Atom::Call(function, of)))
    }

    /// Sine and cosine of an angle, as atoms with their relation.
    pub fn pair(&mut self, angle: Polynomial) -> Result<Pair> {
        if let Some(pair) = self.pairs.iter().find(|pair| pair.angle == angle) {
            return Ok(pair.clone());
        }
        let cosine = self.intern(Atom::Call(Function::Cos, angle.clone().into()));
        let sine = self.intern(Atom::Call(Function::Sin, angle.clone().into()));
        let square = Polynomial::one().minus(&Polynomial::term(Monomial::atom(cosine, 2), Exact::one()))?;
        self.relations.insert(sine, (2, square));
        let pair = Pair { angle, sine, cosine };
        self.pairs.push(pair.clone());
        Ok(pair)
    }

    /// sinh and cosh of something, as atoms with their relation.
    pub fn hyperbolic(&mut self, of: Fraction) -> Result<(Polynomial, Polynomial)> {
        let sine = self.intern(Atom::Call(Function::Sinh, of.clone()));
        let cosine = self.intern(Atom::Call(Function::Cosh, of));
        let square = Polynomial::one().plus(&Polynomial::term(Monomial::atom(sine, 2), Exact::one()), Exact::one())?;
        self.relations.insert(cosine, (2, square));
        Ok((Polynomial::atom(sine), Polynomial::atom(cosine)))
    }

    /// The n-th root of something, as an atom whose n-th power is known.
    pub fn root(&mut self, n: u32, of: Fraction) -> Polynomial {
        let atom = self.intern(Atom::Root(n, of.clone()));
        if of.under.is_empty() {
            self.relations.insert(atom, (n, of.top));
        }
        Polynomial::atom(atom)
    }

    /// Applies every relation to positive powers, and cancels negative powers where it can.
    pub fn canonical(&self, polynomial: &Polynomial) -> Result<Polynomial> {
        let mut normal = polynomial.clone();
        // a relation contains earlier atoms only
        for (&atom, (degree, value)) in self.relations.iter().rev() {
            let (lowest, highest) = normal.exponents(atom);
            if lowest >= 0 && highest < *degree as i32 {
                continue;
            }
            let mut owed = lowest.min(0);
            normal = lowered(&normal.scaled(&Monomial::atom(atom, -owed), Exact::one())?, atom, *degree, value)?;
            while owed < 0 && !normal.is_zero() {
                let Some(quotient) = divided(&normal, atom, value)? else { break };
                normal = quotient;
                owed += *degree as i32;
            }
            normal = normal.scaled(&Monomial::atom(atom, owed), Exact::one())?;
            if owed > 0 {
                normal = lowered(&normal, atom, *degree, value)?;
            }
        }
        Ok(normal)
    }

    /// The same fraction without common factors, as far as they are factors of the denominator.
    pub fn cancelled(&self, mut fraction: Fraction) -> Result<Fraction> {
        if fraction.under.is_empty() {
            return Ok(fraction);
        }
        for (&atom, (degree, value)) in &self.relations {
            if value.len() > 1
                && let Some(power) = fraction.under.remove(&value.primitive()?)
            {
                // this factor of the denominator is a known power of an atom
                let (monomial, number) = value.content();
                for _ in 0..power {
                    fraction.top = fraction.top.scaled(&monomial.raised(atom, -(*degree as i32)), number)?;
                }
            }
        }
        fraction.top = self.canonical(&fraction.top)?;
        let mut under = BTreeMap::new();
        for (factor, mut power) in std::mem::take(&mut fraction.under) {
            while power > 0 {
                let Some(quotient) = fraction.top.divided_by(&factor)? else { break };
                fraction.top = quotient;
                power -= 1;
            }
            if power > 0 && !fraction.top.is_zero() {
                under.insert(factor, power);
            }
        }
        Ok(Fraction { under, ..fraction })
    }

    pub fn plus(&self, a: &Fraction, b: &Fraction, factor: Exact) -> Result<Fraction> {
        let mut under = a.under.clone();
        for (polynomial, &power) in &b.under {
            let own = under.entry(polynomial.clone()).or_default();
            *own = power.max(*own);
        }
        let raised = |fraction: &Fraction| {
            under.iter().try_fold(fraction.top.clone(), |top, (polynomial, &power)| {
                top.times(&polynomial.power(power - fraction.under.get(polynomial).copied().unwrap_or(0))?)
            })
        };
        let top = raised(a)?.plus(&raised(b)?, factor)?;
        self.cancelled(Fraction { top, under })
    }

    pub fn times(&self, a: &Fraction, b: &Fraction) -> Result<Fraction> {
        let mut under = a.under.clone();
        for (polynomial, &power) in &b.under {
            *under.entry(polynomial.clone()).or_default() += power;
        }
        let top = self.canonical(&a.top.times(&b.top)?)?;
        self.cancelled(Fraction { top, under })
    }

    /// 1 / a.
    ///
    /// # Errors
    /// When a is 0.
    pub fn reciprocal(&mut self, a: &Fraction) -> Result<Fraction> {
        let below = self.shortened(&self.canonical(&a.top)?)?;
        if below.is_zero() {
            return Err(Error::new("a denominator is identically 0").help("check the Lagrangian for a division by 0"));
        }
        let (monomial, number) = below.content();
        let mut top = Polynomial::term(monomial.power(-1), number.recip());
        for (factor, &power) in &a.under {
            top = top.times(&factor.power(power)?)?;
        }
        let mut under = BTreeMap::new();
        if below.len() > 1 {
            under.insert(below.primitive()?, 1);
        }
        self.cancelled(Fraction { top: self.canonical(&top)?, under })
    }

    /// aⁿ.
    pub fn power(&mut self, a: &Fraction, n: i32) -> Result<Fraction> {
        if n < 0 {
            let inverse = self.reciprocal(a)?;
            return self.power(&inverse, n.checked_neg().ok_or_else(too_high)?);
        }
        if let (Some((monomial, number)), true) = (a.top.single(), a.under.is_empty())
            && number.is_one()
            && monomial
                .factors()
                .iter()
                .all(|&(_, exponent)| exponent.unsigned_abs().saturating_mul(n as u32) < HIGHEST)
        {
            return Ok(self.canonical(&Polynomial::term(monomial.power(n), number))?.into());
        }
        if n > 64 {
            return Err(too_high());
        }
        (0..n).try_fold(Fraction::from(Polynomial::one()), |product, _| self.times(&product, a))
    }

    /// A fraction with each of some atoms replaced.
    pub fn substitute(&mut self, a: &Fraction, values: &BTreeMap<u32, Fraction>) -> Result<Fraction> {
        let mut sum = self.inserted(&a.top, values)?;
        for (factor, &power) in &a.under {
            let factor = self.inserted(factor, values)?;
            let inverse = self.power(&factor, -(power as i32))?;
            sum = self.times(&sum, &inverse)?;
        }
        Ok(sum)
    }

    fn inserted(&mut self, polynomial: &Polynomial, values: &BTreeMap<u32, Fraction>) -> Result<Fraction> {
        let mut sum = Fraction::default();
        for (monomial, coefficient) in polynomial.terms() {
            let kept = monomial.part(|atom, _| !values.contains_key(&atom));
            let mut product = Fraction::from(Polynomial::term(kept, coefficient));
            for &(atom, exponent) in monomial.factors() {
                if let Some(value) = values.get(&atom) {
                    let factor = self.power(value, exponent)?;
                    product = self.times(&product, &factor)?;
                }
            }
            sum = self.plus(&sum, &product, Exact::one())?;
        }
        Ok(sum)
    }

    pub fn is_exponential(&self, atom: u32) -> bool {
        matches!(self.atom(atom), Atom::Call(Function::Exp, _))
    }

    /// The exponentials that all terms share.
    pub fn shared_exponential(&self, polynomial: &Polynomial) -> Monomial {
        polynomial.content().0.part(|atom, _| self.is_exponential(atom))
    }

    /// Whether a fraction contains any of these atoms, also within other atoms.
    pub fn reads(&self, a: &Fraction, atoms: &[u32]) -> bool {
        let factors = a.under.keys().chain([&a.top]).flat_map(Polynomial::terms);
        let mut inside = factors.flat_map(|(monomial, _)| monomial.factors()).map(|&(atom, _)| atom);
        inside.any(|atom| {
            atoms.contains(&atom)
                || match self.atom(atom) {
                    Atom::Call(_, of) | Atom::Root(_, of) => self.reads(of, atoms),
                    Atom::Input(_) | Atom::Pi => false,
                }
        })
    }
}

fn too_high() -> Error {
    Error::new("an exponent is too large to be typeset").help("use exponents of at most 64")
}

/// Replaces the power of an atom that has a relation, as often as it occurs. No exponent of the atom may be negative.
fn lowered(polynomial: &Polynomial, atom: u32, degree: u32, value: &Polynomial) -> Result<Polynomial> {
    let mut result = Polynomial::default();
    for (exponent, coefficient) in polynomial.powers(atom)? {
        let (times, rest) = (exponent as u32 / degree, exponent as u32 % degree);
        let lowered = coefficient.times(&value.power(times)?)?;
        result = result.plus(&lowered.scaled(&Monomial::atom(atom, rest as i32), Exact::one())?, Exact::one())?;
    }
    Ok(result)
}

/// Divides the coefficient of every power of an atom, if all are divisible.
fn divided(polynomial: &Polynomial, atom: u32, by: &Polynomial) -> Result<Option<Polynomial>> {
    let mut result = Polynomial::default();
    for (exponent, coefficient) in polynomial.powers(atom)? {
        let Some(quotient) = coefficient.divided_by(by)? else { return Ok(None) };
        result = result.plus(&quotient.scaled(&Monomial::atom(atom, exponent), Exact::one())?, Exact::one())?;
    }
    Ok(Some(result))
}

/// Whether the first of the terms, the leading one, is negative.
pub(super) fn is_negative(polynomial: &Polynomial) -> bool {
    polynomial.leading().is_some_and(|(_, leading)| leading.is_negative())
}

/// The number 0 has no terms.
pub(super) fn number(value: i128) -> Exact {
    if value == 0 { Exact::zero() } else { Exact::from_integer(value) }
}
