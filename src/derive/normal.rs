//! From the recorded graph of a function to its normal form, atom by atom.
//!
//! Sines and cosines of sums, and of whole multiples of an angle, are expanded by the addition theorems. Exponentials of
//! sums become products, tangents quotients, inverse hyperbolic functions logarithms. What remains are atoms with the
//! relations of [`Algebra`].
//!
//! # Why the normal form explains and does not decide
//!
//! Two formulas with the same normal form are equal. Two with different forms may be equal as well, since not all
//! identities are used; and a mistake in the normal form would be a mistake in every verdict. So no verdict depends on
//! it. It shows the author the derived equation, and the difference of the two sides of a refuted one. The tests read
//! the typeset formulas back and compare them with numbers. The normal form that shortens tapes (`scalar::polynomial`) is another one:
//! there the aim is few operations, and rounding is allowed.

use num_rational::Ratio;
use num_traits::{One, Signed};

use super::algebra::{Algebra, Atom, Fraction, Pair, is_negative, number};
use super::polynomial::{Monomial, Polynomial};
use super::rational::{self, Exact};
use crate::scalar::{Function, Graph, Node, Symbol};
use crate::{Error, Result};

/// The largest multiple of an angle that is expanded; a larger one is an atom of its own.
const MULTIPLE: i128 = 6;

impl Algebra {
    /// The normal forms of some nodes of a graph.
    ///
    /// # Errors
    /// When one is too long, or contains a number without an exact value or a function that cannot be typeset.
    pub fn normal(&mut self, graph: &Graph, outputs: &[Symbol]) -> Result<Vec<Fraction>> {
        let nodes = graph.nodes();
        let mut needed = vec![false; nodes.len()];
        outputs.iter().for_each(|output| needed[output.place() as usize] = true);
        for place in (0..nodes.len()).rev() {
            if needed[place] {
                nodes[place].operands().for_each(|operand| needed[operand as usize] = true);
            }
        }
        let mut known: Vec<Fraction> = vec![Fraction::default(); nodes.len()];
        let mut done = 0;
        for (place, node) in nodes.iter().enumerate().filter(|(place, _)| needed[*place]) {
            known[place] = self.of(*node, &known)?;
            // the cost of the next product is the product of the lengths
            done += known[place].len().pow(2);
            self.within_work(done)?;
        }
        Ok(outputs.iter().map(|output| known[output.place() as usize].clone()).collect())
    }

    /// An error, if so much work is more than the limit.
    fn within_work(&self, done: usize) -> Result<()> {
        match self.work {
            Some(most) if done > most => Err(Error::new("the expression has too many terms to be typeset")
                .help("ask for a simpler quantity, such as the energy or the mass matrix")),
            _ => Ok(()),
        }
    }

    fn of(&mut self, node: Node, known: &[Fraction]) -> Result<Fraction> {
        let at = |place: u32| &known[place as usize];
        match node {
            Node::Constant(bits) => {
                let (value, is_multiple_of_pi) = rational::read(f64::from_bits(bits))?;
                let pi = self.intern(Atom::Pi);
                let factors = if is_multiple_of_pi { Monomial::atom(pi, 1) } else { Monomial::default() };
                Ok(Polynomial::term(factors, value).into())
            }
            Node::Input(n) => Ok(self.input(n).into()),
            Node::Add(a, b) => self.plus(at(a), at(b), Exact::one()),
            Node::Sub(a, b) => self.plus(at(a), at(b), -Exact::one()),
            Node::Neg(a) => self.plus(&Fraction::default(), at(a), -Exact::one()),
            Node::Mul(a, b) => self.times(at(a), at(b)),
            Node::Recip(a) => self.reciprocal(at(a)),
            Node::Powi(a, n) => self.power(at(a), n),
            Node::Powf(a, bits) => {
                let (exponent, of_pi) = rational::read(f64::from_bits(bits))?;
                let small = |n: i128| i32::try_from(n).ok().filter(|n| n.abs() < 1 << 16);
                match (small(*exponent.numer()), small(*exponent.denom()), of_pi) {
                    (Some(times), Some(root), false) => {
                        let root = self.root(root.unsigned_abs(), at(a).clone()).into();
                        self.power(&root, times)
                    }
                    _ => Err(Error::new(format!(
                        "the exponent {} cannot be typeset, because it is not a simple fraction",
                        f64::from_bits(bits)
                    ))
                    .help("use a rational exponent")),
                }
            }
            Node::Apply(function, a) => self.function(function, at(a).clone()),
            Node::Atan2(..) => Err(Error::new("atan2 cannot be typeset, because it has no usual symbol")
                .help("write the Lagrangian without atan2")),
        }
    }

    fn function(&mut self, function: Function, of: Fraction) -> Result<Fraction> {
        let one = Fraction::from(Polynomial::one());
        Ok(match function {
            Function::Sqrt => self.square_root(of)?.into(),
            Function::Cbrt => self.root(3, of).into(),
            Function::Exp => self.exponential(of)?.into(),
            Function::ExpM1 => {
                let power = self.exponential(of)?;
                self.plus(&power.into(), &one, -Exact::one())?
            }
            Function::Ln1p => {
                let more = self.plus(&of, &one, Exact::one())?;
                self.call(Function::Ln, more).into()
            }
            Function::Sin => self.circular(of)?.0.into(),
            Function::Cos => self.circular(of)?.1.into(),
            Function::Tan => {
                let (sine, cosine) = self.circular(of)?;
                let inverse = self.reciprocal(&cosine.into())?;
                self.times(&sine.into(), &inverse)?
            }
            Function::Sinh => self.hyperbolic(of)?.0.into(),
            Function::Cosh => self.hyperbolic(of)?.1.into(),
            Function::Tanh => {
                let (sine, cosine) = self.hyperbolic(of)?;
                let inverse = self.reciprocal(&cosine.into())?;
                self.times(&sine.into(), &inverse)?
            }
            Function::Asinh | Function::Acosh => {
                let sign = if function == Function::Asinh { Exact::one() } else { -Exact::one() };
                let square = self.times(&of, &of)?;
                let inside = self.plus(&square, &one, sign)?;
                let root = self.square_root(inside)?;
                let sum = self.plus(&of, &root.into(), Exact::one())?;
                self.call(Function::Ln, sum).into()
            }
            Function::Atanh => {
                let (above, below) = (self.plus(&one, &of, Exact::one())?, self.plus(&one, &of, -Exact::one())?);
                let inverse = self.reciprocal(&below)?;
                let quotient = self.times(&above, &inverse)?;
                self.call(Function::Ln, quotient).scaled(&Monomial::default(), Ratio::new(1, 2))?.into()
            }
            Function::Ln | Function::Asin | Function::Acos | Function::Atan => self.call(function, of).into(),
        })
    }

    /// A square root; square factors of numbers are moved out of it.
    fn square_root(&mut self, of: Fraction) -> Result<Polynomial> {
        let (_, content) = of.top.content();
        match rational::root(content.abs()).filter(|_| !of.top.is_zero()) {
            Some(outside) if of.under.is_empty() => {
                let inside = of.top.scaled(&Monomial::default(), content.abs().recip())?;
                match inside.as_constant() {
                    Some(value) if value.is_one() => Ok(Polynomial::constant(outside)),
                    _ => self.root(2, inside.into()).scaled(&Monomial::default(), outside),
                }
            }
            _ => Ok(self.root(2, of)),
        }
    }

    /// The exponential of a sum as a product. Whole multiples in the exponent become powers.
    fn exponential(&mut self, of: Fraction) -> Result<Polynomial> {
        if !of.under.is_empty() {
            return Ok(self.call(Function::Exp, of));
        }
        let mut product = Polynomial::one();
        for (monomial, coefficient) in of.top.terms() {
            let (times, base) = self.multiple(monomial, coefficient)?;
            let atom = self.intern(Atom::Call(Function::Exp, base.into()));
            product = product.scaled(&Monomial::atom(atom, times), Exact::one())?;
        }
        Ok(product)
    }

    /// A term as a whole multiple of one with numerator 1.
    fn multiple(&self, monomial: &Monomial, coefficient: Exact) -> Result<(i32, Polynomial)> {
        match i32::try_from(*coefficient.numer()) {
            Ok(times) if times.abs() < 1 << 16 => {
                Ok((times, Polynomial::term(monomial.clone(), Ratio::new(1, *coefficient.denom()))))
            }
            _ => Err(Error::new("a factor in the argument of an exponential is too large to be typeset")
                .help("use factors below 65536")),
        }
    }

    /// Sine and cosine, by the addition theorems.
    fn circular(&mut self, of: Fraction) -> Result<(Polynomial, Polynomial)> {
        if !of.under.is_empty() {
            let sine = self.call(Function::Sin, of.clone());
            return Ok((sine, self.call(Function::Cos, of)));
        }
        let (mut sine, mut cosine) = (Polynomial::default(), Polynomial::one());
        for (monomial, coefficient) in of.top.terms() {
            let (s, c) = self.of_one_angle(monomial, coefficient)?;
            let sum = sine.times(&c)?.plus(&cosine.times(&s)?, Exact::one())?;
            cosine = cosine.times(&c)?.minus(&sine.times(&s)?)?;
            sine = sum;
            // Each term of the argument doubles the length, and the relations between sines and cosines cost its square.
            self.within_work((sine.len() + cosine.len()).pow(2))?;
        }
        Ok((self.canonical(&sine)?, self.canonical(&cosine)?))
    }

    fn of_one_angle(&mut self, monomial: &Monomial, coefficient: Exact) -> Result<(Polynomial, Polynomial)> {
        let pi = self.intern(Atom::Pi);
        let twice = rational::plus(coefficient, coefficient)?;
        if *monomial == Monomial::atom(pi, 1) && twice.is_integer() {
            let quarter = usize::try_from(twice.to_integer().rem_euclid(4)).unwrap_or(0);
            let value = |values: [i128; 4]| Polynomial::constant(number(values[quarter]));
            return Ok((value([0, 1, 0, -1]), value([1, 0, -1, 0])));
        }
        let size = coefficient.abs();
        let (times, base) =
            if *size.numer() <= MULTIPLE { (*size.numer(), Ratio::new(1, *size.denom())) } else { (1, size) };
        let Pair { sine: s, cosine: c, .. } = self.pair(Polynomial::term(monomial.clone(), base))?;
        let (s, c) = (Polynomial::atom(s), Polynomial::atom(c));
        let (mut sine, mut cosine) = (s.clone(), c.clone());
        for _ in 1..times {
            let sum = sine.times(&c)?.plus(&cosine.times(&s)?, Exact::one())?;
            cosine = cosine.times(&c)?.minus(&sine.times(&s)?)?;
            sine = sum;
        }
        if coefficient.is_negative() {
            sine = Polynomial::default().minus(&sine)?;
        }
        Ok((sine, cosine))
    }

    /// The angle a + factor · b with a positive leading sign, and whether the sign was changed.
    pub fn angle(&self, a: &Polynomial, b: &Polynomial, factor: Exact) -> Result<(Polynomial, bool)> {
        let sum = a.plus(b, factor)?;
        if is_negative(&sum) { Ok((Polynomial::default().minus(&sum)?, true)) } else { Ok((sum, false)) }
    }
}
