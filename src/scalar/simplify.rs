//! Simplification of traced expressions: polynomials in atoms, with sin² + cos² = 1.
//!
//! A Lagrangian that starts from rotation matrices computes ½ λ₁ (θ̇² + φ̇² sin² θ) in some hundred operations, with
//! cancellations between them. An expression is multiplied out over its *atoms*: inputs, sines, cosines and everything
//! else that is not a sum or a product. Every sin² becomes 1 − cos². The polynomial is then in normal form: two
//! polynomials that are equal on the circle are equal term by term. The normal form is written with common factors
//! taken out, and is used only if it costs less than the original.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::rc::Rc;

use num_traits::{One, Zero};

use super::arithmetic::power_by_squaring;
use super::symbol::{Node, Symbol};
use super::{Arithmetic, Function};

/// Atoms with their exponents, in the order of the atoms; no exponent is 0.
type Monomial = Vec<(u32, i32)>;

/// Beyond this many products of monomials, multiplying out does not shorten anything: the original is kept.
const BUDGET: usize = 400_000;

/// A sum of monomials with coefficients; none of them is 0.
#[derive(Clone, Default)]
struct Polynomial(BTreeMap<Monomial, f64>);

impl Polynomial {
    fn atom(place: u32) -> Self {
        Polynomial([(vec![(place, 1)], 1.0)].into())
    }

    /// A symbol that is no sum or product, up to its sign.
    fn opaque(symbol: Symbol) -> Self {
        match symbol.node() {
            Node::Constant(bits) => Polynomial::constant(f64::from_bits(bits)),
            Node::Neg(inner) => Polynomial::default().plus(&Polynomial::atom(inner), -1.0),
            _ => Polynomial::atom(symbol.place()),
        }
    }

    fn constant(value: f64) -> Self {
        let mut constant = Polynomial::default();
        constant.add(Vec::new(), value);
        constant
    }

    fn add(&mut self, monomial: Monomial, coefficient: f64) {
        match self.0.entry(monomial) {
            Entry::Vacant(_) if coefficient == 0.0 => {}
            Entry::Vacant(place) => drop(place.insert(coefficient)),
            Entry::Occupied(place) if *place.get() == -coefficient => drop(place.remove()),
            Entry::Occupied(mut place) => *place.get_mut() += coefficient,
        }
    }

    fn plus(&self, other: &Self, factor: f64) -> Self {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.0 {
            sum.add(monomial.clone(), coefficient * factor);
        }
        sum
    }

    /// Its only term, if it has but one.
    fn single(&self) -> Option<(&Monomial, f64)> {
        let mut terms = self.0.iter();
        let (monomial, &coefficient) = terms.next()?;
        terms.next().is_none().then_some((monomial, coefficient))
    }
}

fn merge(a: &Monomial, b: &Monomial) -> Monomial {
    let mut product = a.clone();
    for &(atom, exponent) in b {
        raise(&mut product, atom, exponent);
    }
    product
}

fn raise(monomial: &mut Monomial, atom: u32, exponent: i32) {
    match monomial.binary_search_by_key(&atom, |&(atom, _)| atom) {
        Ok(i) if monomial[i].1 + exponent == 0 => drop(monomial.remove(i)),
        Ok(i) => monomial[i].1 += exponent,
        Err(i) => monomial.insert(i, (atom, exponent)),
    }
}

fn exponent_of(monomial: &Monomial, atom: u32) -> i32 {
    monomial.binary_search_by_key(&atom, |&(atom, _)| atom).map_or(0, |i| monomial[i].1)
}

/// One simplification: what each node of the recording is as a polynomial.
#[derive(Default)]
struct Normal {
    known: HashMap<u32, Rc<Polynomial>>,
    /// For each sine the cosine of the same angle.
    pairs: BTreeMap<u32, u32>,
    work: usize,
}

impl Normal {
    /// The normal form of a node, whose operands have theirs already. `None` when it would be too long.
    fn expand(&mut self, symbol: Symbol) -> Option<Polynomial> {
        let known = |place: u32| self.known.get(&place).cloned();
        let result = match symbol.node() {
            Node::Constant(bits) => Polynomial::constant(f64::from_bits(bits)),
            Node::Input(_) => Polynomial::atom(symbol.place()),
            Node::Add(a, b) => known(a)?.plus(&*known(b)?, 1.0),
            Node::Sub(a, b) => known(a)?.plus(&*known(b)?, -1.0),
            Node::Neg(a) => Polynomial::default().plus(&*known(a)?, -1.0),
            Node::Mul(a, b) => {
                let (a, b) = (known(a)?, known(b)?);
                self.multiply(&a, &b)?
            }
            Node::Recip(a) => {
                let inner = self.shorten(&*known(a)?);
                // a coefficient is inverted only if the machine has its reciprocal
                let exact = inner.single().and_then(|(monomial, c)| {
                    let inverse = monomial.iter().map(|&(atom, exponent)| (atom, -exponent)).collect();
                    Some(Polynomial([(inverse, (Symbol::one() / Symbol::from(c)).as_constant()?)].into()))
                });
                exact.unwrap_or_else(|| Polynomial::opaque(Symbol::one() / write(&inner)))
            }
            Node::Powi(a, n) => Polynomial::opaque(write(&*known(a)?).power(n)),
            Node::Powf(a, n) => Polynomial::opaque(write(&*known(a)?).real_power(f64::from_bits(n))),
            Node::Atan2(a, b) => Polynomial::opaque(write(&*known(a)?).angle_from(write(&*known(b)?))),
            Node::Apply(function, a) => {
                let argument = known(a)?;
                // one sign for an angle and its opposite, so that their cosines are one atom
                let turned = argument.0.values().next().is_some_and(|&c| c < 0.0)
                    && matches!(function, Function::Sin | Function::Cos);
                let sign = if turned { -1.0 } else { 1.0 };
                let angle = write(&Polynomial::default().plus(&argument, sign));
                if matches!(function, Function::Sin | Function::Cos) {
                    self.pairs.insert(angle.apply(Function::Sin).place(), angle.apply(Function::Cos).place());
                }
                let value = Polynomial::opaque(angle.apply(function));
                if turned && function == Function::Sin { Polynomial::default().plus(&value, -1.0) } else { value }
            }
        };
        self.work += result.0.len();
        (self.work <= BUDGET).then_some(result)
    }

    fn multiply(&mut self, a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
        self.work += a.0.len() * b.0.len();
        if self.work > BUDGET {
            return None;
        }
        let mut product = Polynomial::default();
        for (m, c) in &a.0 {
            for (n, d) in &b.0 {
                self.reduce(merge(m, n), c * d, &mut product);
            }
        }
        Some(product)
    }

    /// Adds a monomial to a polynomial in normal form: sin² = 1 − cos².
    fn reduce(&self, monomial: Monomial, coefficient: f64, to: &mut Polynomial) {
        let mut waiting = vec![(monomial, coefficient)];
        while let Some((mut monomial, coefficient)) = waiting.pop() {
            let square = monomial.iter().filter(|&&(_, exponent)| exponent >= 2);
            match square.filter_map(|&(atom, _)| Some((atom, *self.pairs.get(&atom)?))).next() {
                None => to.add(monomial, coefficient),
                Some((sine, cosine)) => {
                    raise(&mut monomial, sine, -2);
                    waiting.push((monomial.clone(), coefficient));
                    raise(&mut monomial, cosine, 2);
                    waiting.push((monomial, -coefficient));
                }
            }
        }
    }

    /// The shorter of the ways to write it: in cosines or in sines, angle by angle, with m − m·cos² as m·sin².
    fn shorten(&self, polynomial: &Polynomial) -> Polynomial {
        let mut best = polynomial.clone();
        for (&sine, &cosine) in &self.pairs {
            let in_cosines = contract(&best, sine, cosine);
            let in_sines = contract(&exchange(&best, sine, cosine), cosine, sine);
            for candidate in [in_cosines, in_sines] {
                if candidate.0.len() < best.0.len() {
                    best = candidate;
                }
            }
        }
        best
    }
}

/// cos² → 1 − sin².
fn exchange(polynomial: &Polynomial, sine: u32, cosine: u32) -> Polynomial {
    let mut exchanged = Polynomial::default();
    for (monomial, &coefficient) in &polynomial.0 {
        let mut waiting = vec![(monomial.clone(), coefficient)];
        while let Some((mut monomial, coefficient)) = waiting.pop() {
            if exponent_of(&monomial, cosine) < 2 {
                exchanged.add(monomial, coefficient);
                continue;
            }
            raise(&mut monomial, cosine, -2);
            waiting.push((monomial.clone(), coefficient));
            raise(&mut monomial, sine, 2);
            waiting.push((monomial, -coefficient));
        }
    }
    exchanged
}

/// m − m·b² → m·a², where a² + b² = 1.
fn contract(polynomial: &Polynomial, a: u32, b: u32) -> Polynomial {
    let mut result = polynomial.clone();
    for (monomial, &coefficient) in &polynomial.0 {
        let mut squared = monomial.clone();
        raise(&mut squared, b, 2);
        if result.0.get(monomial) == Some(&coefficient) && result.0.get(&squared) == Some(&-coefficient) {
            result.0.remove(monomial);
            result.0.remove(&squared);
            let mut contracted = monomial.clone();
            raise(&mut contracted, a, 2);
            result.add(contracted, coefficient);
        }
    }
    result
}

/// Writes a polynomial down, the most frequent atom out of the terms that have it, again and again.
fn write(polynomial: &Polynomial) -> Symbol {
    factored(polynomial.0.iter().map(|(monomial, &coefficient)| (monomial.clone(), coefficient)).collect())
}

fn factored(mut terms: Vec<(Monomial, f64)>) -> Symbol {
    let Some(&(_, first)) = terms.first() else { return Symbol::zero() };
    if terms.len() > 1 && first != 1.0 && terms.iter().all(|(_, c)| c.abs() == first.abs()) {
        terms.iter_mut().for_each(|(_, c)| *c /= first);
        return factored(terms) * first;
    }
    let mut sum = Symbol::zero();
    loop {
        let mut frequency: BTreeMap<(u32, bool), usize> = BTreeMap::new();
        for &(atom, exponent) in terms.iter().flat_map(|(monomial, _)| monomial) {
            *frequency.entry((atom, exponent > 0)).or_default() += 1;
        }
        // the first of the most frequent: the choice must not depend on anything but the polynomial
        let common = frequency.iter().rev().max_by_key(|&(_, &count)| count);
        let Some((&(atom, positive), _)) = common.filter(|&(_, &count)| count > 1) else { break };
        let has = |monomial: &Monomial| match exponent_of(monomial, atom) {
            0 => false,
            exponent => (exponent > 0) == positive,
        };
        let (mut with, without): (Vec<_>, Vec<_>) = terms.into_iter().partition(|(monomial, _)| has(monomial));
        let step = if positive { 1 } else { -1 };
        with.iter_mut().for_each(|(monomial, _)| raise(monomial, atom, -step));
        sum += power(atom, step) * factored(with);
        terms = without;
    }
    for (monomial, coefficient) in terms {
        let product = monomial.iter().fold(Symbol::one(), |product, &(atom, exponent)| product * power(atom, exponent));
        sum += product * coefficient;
    }
    sum
}

fn power(atom: u32, exponent: i32) -> Symbol {
    power_by_squaring(Symbol::at(atom), exponent)
}

/// What it costs to compute all of `outputs`, in products.
fn cost(outputs: &[Symbol]) -> usize {
    let mut seen: HashSet<u32> = HashSet::new();
    let mut waiting: Vec<u32> = outputs.iter().map(|output| output.place()).collect();
    let mut cost = 0;
    while let Some(place) = waiting.pop() {
        if seen.insert(place) {
            let node = Symbol::at(place).node();
            cost += match node {
                Node::Constant(_) | Node::Input(_) => 0,
                Node::Add(..) | Node::Sub(..) | Node::Mul(..) | Node::Neg(_) => 1,
                Node::Recip(_) => 5,
                Node::Powi(..) | Node::Powf(..) | Node::Apply(..) | Node::Atan2(..) => 20,
            };
            waiting.extend(node.operands());
        }
    }
    cost
}

/// The same values with less work, if there is such a way: for symbols of the recording that is under way.
///
/// Constants may be folded and sums reordered, so the result agrees to rounding, and exactly as polynomials. A quotient
/// of equal monomials is cancelled.
pub fn simplify_all(outputs: &[Symbol]) -> Vec<Symbol> {
    try_simplify(outputs, &[]).unwrap_or_else(|| outputs.to_vec())
}

/// [`simplify_all`] where the values `beside` are computed too, whose parts cost nothing; `None` if there is no such
/// way.
pub fn try_simplify(outputs: &[Symbol], beside: &[Symbol]) -> Option<Vec<Symbol>> {
    let mut needed: Vec<u32> = Vec::new();
    let mut seen: HashSet<u32> = HashSet::new();
    let mut waiting: Vec<u32> = outputs.iter().map(|output| output.place()).collect();
    while let Some(place) = waiting.pop() {
        if seen.insert(place) {
            needed.push(place);
            waiting.extend(Symbol::at(place).node().operands());
        }
    }
    // operands precede their uses
    needed.sort_unstable();
    let mut normal = Normal::default();
    for place in needed {
        let polynomial = normal.expand(Symbol::at(place))?;
        normal.known.insert(place, Rc::new(polynomial));
    }
    let shorter: Vec<Symbol> = outputs
        .iter()
        .filter_map(|output| normal.known.get(&output.place()).cloned())
        .map(|polynomial| write(&normal.shorten(&polynomial)))
        .collect();
    let cost_of = |outputs: &[Symbol]| cost(&[outputs, beside].concat());
    (shorter.len() == outputs.len() && cost_of(&shorter) < cost_of(outputs)).then_some(shorter)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Graph;
    use num_dual::DualNum;

    fn simplified<R>(f: impl FnOnce(Symbol, Symbol) -> Symbol, look: impl FnOnce(Symbol) -> R) -> R {
        Graph::record(|| look(simplify_all(&[f(Symbol::input(0), Symbol::input(1))])[0])).unwrap().1
    }

    #[test]
    fn what_vanishes_is_the_constant_zero() {
        let zero = |f: fn(Symbol, Symbol) -> Symbol| simplified(f, Symbol::as_constant);
        assert_eq!(zero(|x, _| x.sin() * x.sin() + x.cos() * x.cos() - 1.0), Some(0.0));
        assert_eq!(zero(|x, y| (x + y).powi(3) - (x * x + x * y * 2.0 + y * y) * (x + y)), Some(0.0));
        assert_eq!(zero(|x, y| (x - y).cos() - (y - x).cos() + (x - y).sin() + (y - x).sin()), Some(0.0));
        assert_eq!(zero(|x, y| x * y / x - y), Some(0.0));
        // must-fail cases
        assert_eq!(zero(|x, _| x.sin() * x.sin() - x.cos() * x.cos() - 1.0), None);
        assert_eq!(zero(|x, y| x.sin().powi(2) + y.cos().powi(2) - 1.0), None);
        assert_eq!(zero(|x, y| (x - y).sin() - (y - x).sin()), None);
    }

    #[test]
    fn the_shorter_square_is_written() {
        let operations = |f: fn(Symbol, Symbol) -> Symbol| simplified(f, |symbol| cost(&[symbol]));
        assert_eq!(operations(|x, y| y - y * x.cos().powi(2)), operations(|x, y| y * x.sin().powi(2)));
        assert_eq!(operations(|x, y| y - y * x.sin().powi(2)), operations(|x, y| y * x.cos().powi(2)));
    }

    #[test]
    fn what_would_explode_is_left_alone() {
        let long = |x: Symbol, y: Symbol| {
            let mut product = Symbol::one();
            for k in 0..40 {
                product *= (x * k as f64).exp() + (y * k as f64).exp() + 1.0;
            }
            product
        };
        Graph::record(|| {
            let symbol = long(Symbol::input(0), Symbol::input(1));
            assert_eq!(simplify_all(&[symbol])[0].place(), symbol.place());
        })
        .unwrap();
    }
}
