//! From the normal form to a formula as physicists print it.
//!
//! A sum is collected by its parameters, since each of them has a physical meaning: λ₁(θ̇² + φ̇² sin²θ). Within a
//! collection the terms over one denominator are added, common factors are moved out, and a square is written as a
//! square. The order of terms: highest derivatives, velocities and momenta, terms of coordinates only. The order of
//! factors: number, parameters, coordinates, momenta, accelerations, velocities, functions.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use num_traits::{One, Signed};

use super::algebra::{Algebra, Atom, Fraction};
use super::polynomial::{Monomial, Polynomial};
use super::rational::{Exact, is_simple};
use super::{Class, Letter};
use crate::formula::{self, Expr, Node, Sign, Term};
use crate::scalar::Function;
use crate::source::Span;
use crate::{Error, Result};

/// The order of the terms of a sum: highest derivatives, then velocities and momenta; by parameters; few factors before
/// many.
type Place = (Reverse<i32>, Reverse<i32>, Factors, i32, Factors);

/// Factors in their order, with their exponents.
type Factors = Vec<(Rank, Reverse<i32>)>;

/// The order of the factors of a term.
type Rank = (u8, u32, u8);

/// A term of a sum with its sign.
struct Piece {
    place: Place,
    sign: Sign,
    expr: Expr,
}

/// Writes normal forms with the names of their inputs.
pub(super) struct Printer<'a> {
    pub algebra: &'a Algebra,
    pub letters: &'a [Letter],
}

impl Printer<'_> {
    /// The sum of some fractions.
    ///
    /// # Errors
    /// When a function cannot be typeset.
    pub fn sum(&self, fractions: &[Fraction]) -> Result<Expr> {
        let mut plain = Polynomial::default();
        let mut pieces = Vec::new();
        for fraction in fractions.iter().filter(|fraction| !fraction.top.is_zero()) {
            if fraction.under.is_empty() {
                plain = plain.plus(&fraction.top, Exact::one())?;
            } else {
                pieces.push(self.quotient(fraction)?);
            }
        }
        let shared = self.algebra.shared_exponential(&plain);
        let inner = plain.scaled(&shared.power(-1), Exact::one())?;
        let bare = |monomial: &Monomial| !monomial.factors().iter().any(|&(atom, _)| self.algebra.is_exponential(atom));
        if !shared.factors().is_empty() && inner.len() > 1 && inner.terms().all(|(monomial, _)| bare(monomial)) {
            let sum = assemble(self.pieces(&inner)?);
            let expr = self.product(&shared, Exact::one(), vec![sum], Vec::new())?;
            pieces.push(Piece { place: self.place(&inner), sign: Sign::Plus, expr });
        } else {
            pieces.extend(self.pieces(&plain)?);
        }
        Ok(assemble(pieces))
    }

    fn quotient(&self, fraction: &Fraction) -> Result<Piece> {
        let (monomial, number) = fraction.top.content();
        let rest = fraction.top.primitive()?;
        let (mut number, mut below) = (number, Vec::new());
        for (factor, &power) in &fraction.under {
            let (own, factor) = self.turned(factor)?;
            if own == Sign::Minus && power % 2 == 1 {
                number = -number;
            }
            below.push(if power == 1 { factor } else { raised(factor, power) });
        }
        let (sign, above) = self.inside(&rest, number)?;
        let expr = self.product(&monomial, number.abs(), above, below)?;
        Ok(Piece { place: self.place(&fraction.top), sign, expr })
    }

    /// A polynomial without content as factors, with the sign of the whole; 1 is left out. A negative sign of the whole is
    /// moved into a factor, if one can take it: −(a b − 2c) becomes 2c − a b.
    fn inside(&self, rest: &Polynomial, number: Exact) -> Result<(Sign, Vec<Expr>)> {
        let mut sign = sign_of(number);
        if rest.as_constant().is_some_and(|value| value.is_one()) {
            return Ok((sign, Vec::new()));
        }
        if let Some(root) = rest.root()? {
            return Ok((sign, vec![raised(self.turned(&root)?.1, 2)]));
        }
        let (mut factors, mut turnable) = (Vec::new(), None);
        for factor in self.factors(rest)? {
            let (own, expr) = self.turned(&factor)?;
            sign = if own == Sign::Minus { sign.flipped() } else { sign };
            let opposite = Polynomial::default().minus(&factor)?;
            let pieces = self.flat(if own == Sign::Minus { &factor } else { &opposite })?;
            if pieces.iter().min_by(|a, b| a.place.cmp(&b.place)).is_some_and(|first| first.sign == Sign::Plus) {
                turnable.get_or_insert((factors.len(), pieces));
            }
            factors.push(expr);
        }
        if let (Sign::Minus, Some((at, pieces))) = (sign, turnable) {
            factors[at] = assemble(pieces);
            sign = Sign::Plus;
        }
        Ok((sign, factors))
    }

    /// Factors of a polynomial that is linear or quadratic in a velocity or a momentum; itself, if none is found.
    fn factors(&self, whole: &Polynomial) -> Result<Vec<Polynomial>> {
        let moving = [Class::Velocity, Class::Momentum, Class::Acceleration];
        let wanted = |atom: &u32| self.class(*atom).is_some_and(|class| moving.contains(&class));
        let mut atoms: Vec<u32> =
            whole.terms().flat_map(|(monomial, _)| monomial.factors()).map(|&(atom, _)| atom).filter(wanted).collect();
        atoms.sort_unstable();
        atoms.dedup();
        for atom in atoms {
            let powers = whole.powers(atom)?;
            let of = |exponent: i32| powers.get(&exponent).cloned().unwrap_or_default();
            let candidate = match whole.exponents(atom) {
                (0, 1) => of(1).primitive()?,
                (0, 2) => {
                    // a x² + b x + c, with b² − 4ac the square of d, is 0 where 2 a x + b = d
                    let (a, b, c) = (of(2), of(1), of(0));
                    let four = Exact::from_integer(4);
                    let Some(d) = b.times(&b)?.plus(&a.times(&c)?, -four)?.root()? else { continue };
                    let x = Monomial::atom(atom, 1);
                    a.scaled(&x, Exact::from_integer(2))?.plus(&b, Exact::one())?.minus(&d)?.primitive()?
                }
                _ => continue,
            };
            if candidate.len() > 1
                && let Some(other) = whole.divided_by(&candidate)?
                && other.len() > 1
            {
                return Ok([self.factors(&candidate)?, self.factors(&other)?].concat());
            }
        }
        Ok(vec![whole.clone()])
    }

    /// A sum that begins with a plus, and the sign that this took.
    fn turned(&self, polynomial: &Polynomial) -> Result<(Sign, Expr)> {
        let expr = assemble(self.flat(polynomial)?);
        match &expr.node {
            Node::Sum(terms) if terms[0].sign == Sign::Minus => {
                let opposite = Polynomial::default().minus(polynomial)?;
                Ok((Sign::Minus, assemble(self.flat(&opposite)?)))
            }
            _ => Ok((Sign::Plus, expr)),
        }
    }

    /// The terms one by one.
    fn flat(&self, polynomial: &Polynomial) -> Result<Vec<Piece>> {
        polynomial.terms().map(|(monomial, number)| self.piece(monomial, number)).collect()
    }

    fn piece(&self, monomial: &Monomial, number: Exact) -> Result<Piece> {
        let expr = self.product(monomial, number.abs(), Vec::new(), Vec::new())?;
        let place = self.place(&Polynomial::term(monomial.clone(), number));
        Ok(Piece { place, sign: sign_of(number), expr })
    }

    /// The terms, collected by their parameters.
    fn pieces(&self, polynomial: &Polynomial) -> Result<Vec<Piece>> {
        let mut groups: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
        for (monomial, number) in polynomial.terms() {
            let parameters = monomial.part(|atom, _| self.is_parameter(atom));
            groups.entry(parameters).or_default().add(monomial.clone(), number)?;
        }
        let mut pieces = Vec::new();
        for (parameters, group) in groups {
            let square = group.len() > 2 && group.primitive()?.root()?.is_some();
            if group.len() == 1 || square {
                pieces.push(self.collected(&group)?);
                continue;
            }
            let mut over: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
            for (monomial, number) in group.terms() {
                let below = monomial.part(|atom, exponent| exponent < 0 && !self.algebra.is_exponential(atom));
                over.entry(below).or_default().add(monomial.clone(), number)?;
            }
            for (_, part) in over {
                let (shared, _) = part.content();
                if parameters.factors().is_empty() && shared.factors().is_empty() && part.primitive()?.root()?.is_none()
                {
                    pieces.extend(self.flat(&part)?);
                } else {
                    pieces.push(self.collected(&part)?);
                }
            }
        }
        Ok(pieces)
    }

    /// One collection, with the common factors of its terms moved out.
    fn collected(&self, group: &Polynomial) -> Result<Piece> {
        if let Some((monomial, number)) = group.single() {
            return self.piece(monomial, number);
        }
        let (monomial, number) = group.content();
        let (sign, inside) = self.inside(&group.primitive()?, number)?;
        let expr = self.product(&monomial, number.abs(), inside, Vec::new())?;
        Ok(Piece { place: self.place(group), sign, expr })
    }

    /// Number times factors: a negative exponent goes to the denominator, after `below`.
    fn product(&self, monomial: &Monomial, number: Exact, inside: Vec<Expr>, below: Vec<Expr>) -> Result<Expr> {
        let mut factors: Vec<(Rank, u32, i32)> =
            monomial.factors().iter().map(|&(atom, exponent)| (self.rank(atom), atom, exponent)).collect();
        factors.sort();
        let (mut above, mut under) = (Vec::new(), Vec::new());
        for (_, atom, exponent) in factors {
            if exponent > 0 || self.algebra.is_exponential(atom) {
                above.push(self.power(atom, exponent)?);
            } else {
                under.push(self.power(atom, -exponent)?);
            }
        }
        above.extend(inside);
        under.extend(below);
        if !is_simple(number) {
            let value = *number.numer() as f64 / *number.denom() as f64;
            above.insert(0, literal(value.to_string()));
            return Ok(over(above, under));
        }
        let (numerator, denominator) = (integer(*number.numer()), integer(*number.denom()));
        match (number.is_integer(), under.is_empty()) {
            (false, true) => above.insert(0, over(vec![numerator], vec![denominator])),
            (false, false) => {
                under.insert(0, denominator);
                if !number.numer().is_one() {
                    above.insert(0, numerator);
                }
            }
            (true, _) if !number.is_one() => above.insert(0, numerator),
            _ => {}
        }
        Ok(over(above, under))
    }

    fn power(&self, atom: u32, exponent: i32) -> Result<Expr> {
        let plain = |base: Expr| match exponent {
            1 => base,
            _ => raised(base, exponent.unsigned_abs()),
        };
        Ok(match self.algebra.atom(atom) {
            Atom::Input(n) => plain(self.letter(*n)?.expr.clone()),
            Atom::Pi => plain(expr(Node::Pi)),
            Atom::Call(Function::Exp, of) => {
                let scaled = Fraction {
                    top: of.top.scaled(&Monomial::default(), Exact::from_integer(exponent.into()))?,
                    ..of.clone()
                };
                let exponent = self.sum(std::slice::from_ref(&scaled))?;
                match scaled.top.as_constant() {
                    Some(_) => expr(Node::Call(formula::Function::Exp, Box::new(exponent))),
                    None => expr(Node::Power(Box::new(expr(Node::Euler)), Box::new(exponent))),
                }
            }
            Atom::Call(function, of) => {
                let name = named(*function)?;
                plain(expr(Node::Call(name, Box::new(self.sum(std::slice::from_ref(of))?))))
            }
            Atom::Root(n, of) => {
                let base = self.sum(std::slice::from_ref(of))?;
                match (exponent, n) {
                    (1, 2 | 3) => expr(Node::Root(*n, Box::new(base))),
                    _ => {
                        let exponent = over(vec![integer(exponent.into())], vec![integer((*n).into())]);
                        expr(Node::Power(Box::new(base), Box::new(exponent)))
                    }
                }
            }
        })
    }

    fn letter(&self, n: u32) -> Result<&Letter> {
        self.letters.get(n as usize).ok_or_else(|| {
            Error::new(format!("input {n} of the recorded function has no letter"))
                .help("give one letter for each input")
        })
    }

    fn class(&self, atom: u32) -> Option<Class> {
        match self.algebra.atom(atom) {
            Atom::Input(n) => self.letters.get(*n as usize).map(|letter| letter.class),
            _ => None,
        }
    }

    fn is_parameter(&self, atom: u32) -> bool {
        self.class(atom) == Some(Class::Parameter) || *self.algebra.atom(atom) == Atom::Pi
    }

    fn rank(&self, atom: u32) -> Rank {
        match self.algebra.atom(atom) {
            Atom::Pi => (0, 0, 0),
            Atom::Input(n) => (self.class(atom).map_or(9, |class| class as u8), *n, 0),
            Atom::Root(..) => (10, atom, 0),
            Atom::Call(function, of) => {
                let angle = of.top.terms().flat_map(|(monomial, _)| monomial.factors()).map(|&(atom, _)| atom).min();
                let class = if *function == Function::Exp { 20 } else { 11 };
                (class, angle.unwrap_or(0), *function as u8)
            }
        }
    }

    fn place(&self, polynomial: &Polynomial) -> Place {
        let places = polynomial.terms().map(|(monomial, _)| {
            let degree = |wanted: &[Class]| -> i32 {
                let factors = monomial.factors().iter();
                let wanted =
                    factors.filter(|(atom, e)| *e > 0 && self.class(*atom).is_some_and(|c| wanted.contains(&c)));
                wanted.map(|&(_, exponent)| exponent).sum()
            };
            let ranked = |monomial: &Monomial| {
                let factors = monomial.factors().iter();
                let mut ranked: Factors = factors.map(|&(atom, e)| (self.rank(atom), Reverse(e))).collect();
                ranked.sort();
                ranked
            };
            let parameters = ranked(&monomial.part(|atom, _| self.is_parameter(atom)));
            let factors = ranked(monomial);
            let count = monomial.factors().iter().map(|(_, exponent)| exponent.abs()).sum();
            // a number alone comes first, as in 1 − v²/c²
            let first = if factors.is_empty() { i32::MAX } else { degree(&[Class::Acceleration]) };
            (Reverse(first), Reverse(degree(&[Class::Velocity, Class::Momentum])), parameters, count, factors)
        });
        places.min().unwrap_or((Reverse(0), Reverse(0), Vec::new(), 0, Vec::new()))
    }
}

/// The pieces in their order; among pieces of one kind a positive one comes first.
fn assemble(mut pieces: Vec<Piece>) -> Expr {
    pieces.sort_by(|a, b| a.place.cmp(&b.place));
    let kind = |piece: &Piece| (piece.place.0, piece.place.1);
    if let Some(first) = pieces.first().filter(|piece| piece.sign == Sign::Minus).map(kind)
        && let Some(positive) = pieces.iter().position(|piece| piece.sign == Sign::Plus && kind(piece) == first)
    {
        let piece = pieces.remove(positive);
        pieces.insert(0, piece);
    }
    let mut terms: Vec<Term> =
        pieces.into_iter().map(|piece| Term { sign: piece.sign, sign_span: None, expr: piece.expr }).collect();
    match terms.len() {
        0 => integer(0),
        1 if terms[0].sign == Sign::Plus => terms.remove(0).expr,
        _ => expr(Node::Sum(terms)),
    }
}

fn named(function: Function) -> Result<formula::Function> {
    Ok(match function {
        Function::Sin => formula::Function::Sin,
        Function::Cos => formula::Function::Cos,
        Function::Sinh => formula::Function::Sinh,
        Function::Cosh => formula::Function::Cosh,
        Function::Exp => formula::Function::Exp,
        Function::Ln => formula::Function::Ln,
        Function::Asin => formula::Function::Arcsin,
        Function::Acos => formula::Function::Arccos,
        Function::Atan => formula::Function::Arctan,
        other => {
            return Err(Error::new(format!(
                "the function {other:?} cannot be typeset, because it has no usual symbol"
            ))
            .help("write the Lagrangian with sin, cos, sinh, cosh, exp, ln or their inverses"));
        }
    })
}

fn sign_of(number: Exact) -> Sign {
    if number.is_negative() { Sign::Minus } else { Sign::Plus }
}

fn expr(node: Node) -> Expr {
    Expr::new(node, Span::default())
}

fn literal(text: String) -> Expr {
    expr(Node::Number(text))
}

fn integer(value: i128) -> Expr {
    literal(value.to_string())
}

fn raised(base: Expr, exponent: u32) -> Expr {
    expr(Node::Power(Box::new(base), Box::new(Expr::integer(exponent, Span::default()))))
}

fn beside(mut factors: Vec<Expr>) -> Expr {
    match factors.len() {
        0 => integer(1),
        1 => factors.remove(0),
        _ => expr(Node::Product(factors)),
    }
}

fn over(above: Vec<Expr>, under: Vec<Expr>) -> Expr {
    if under.is_empty() {
        beside(above)
    } else {
        expr(Node::Quotient(Box::new(beside(above)), Box::new(beside(under))))
    }
}
