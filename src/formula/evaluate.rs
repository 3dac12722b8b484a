//! The value of a formula at a state, over any number.
//!
//! Where things move, a number is a Taylor series in time ([`Series`](crate::scalar::Series)); an overdot or `d/dt`
//! shifts the series. [`Environment`] supplies the values of symbols.

use nalgebra::{DMatrix, Vector3};

use crate::scalar::{Number, Ratio, cross, dot};

pub use super::environment::{Body, Differentiable, Environment, Unavailable, differentiate};
use super::ids::{Index, IndexId, SymbolId};
use super::numbers::complex::Complex;
use super::numbers::matrices;
use super::symbols::Kind;
use super::tree::{Excluded, Expr, Function, Node, Sign, Term};
use super::units::Unit;
use super::units::printed::BASE_VALUES;
use super::value::Value;

/// Evaluates a formula whose free indices have the values `free`.
///
/// # Errors
/// [`Unavailable`] where the environment has no value or no derivative of a symbol, or where an operation is not
/// defined for the shapes at hand.
pub fn evaluate<D: Differentiable>(
    expr: &Expr,
    environment: &dyn Environment<D>,
    free: &[(IndexId, u8)],
) -> Result<Value<D>, Unavailable> {
    evaluate_to(ALL, expr, environment, free)
}

/// The number of terms that asks for all that are known.
pub const ALL: usize = usize::MAX;

/// As [`evaluate`], but computes only the first `terms` terms of the result: the value and `terms - 1` derivatives.
/// Fewer terms make products of series cheaper.
pub fn evaluate_to<D: Differentiable>(
    terms: usize,
    expr: &Expr,
    environment: &dyn Environment<D>,
    free: &[(IndexId, u8)],
) -> Result<Value<D>, Unavailable> {
    // Where there are indices, sums over more are likely.
    let mut indices = Vec::with_capacity(if free.is_empty() { 0 } else { free.len() + 2 });
    indices.extend_from_slice(free);
    Evaluator { environment, indices, letters: Vec::new(), terms }.value(expr)
}

/// The value of a unit, where each base unit has a number of its own.
fn size<D: Differentiable>(unit: Unit) -> Option<D> {
    let power = |base: D, exponent: i64| (0..exponent.unsigned_abs()).fold(D::one(), |all, _| all * base);
    let times = |size: D, base: &str, exponent: i64| {
        let base = power(D::decimal(base)?, exponent);
        Some(if exponent < 0 { size / base } else { size * base })
    };
    let (digits, ten) = unit.size();
    let mut size = times(D::decimal(digits)?, "10", ten.into())?;
    if unit.is_degree() {
        size = size * D::pi() / D::decimal("180")?;
    }
    BASE_VALUES
        .iter()
        .zip(unit.exponents())
        .filter(|(_, exponent)| *exponent != 0)
        .try_fold(size, |size, (base, exponent)| times(size, base, exponent))
}

/// The exact value of an exponent that holds numbers only, where it fits.
pub fn constant_exponent(expr: &Expr) -> Option<Ratio> {
    match &expr.node {
        Node::Number(digits) => Ratio::from_decimal(digits),
        Node::Sum(terms) => terms.iter().try_fold(Ratio::whole(0), |sum, term| {
            let value = constant_exponent(&term.expr)?;
            sum.plus(if term.sign == Sign::Plus { value } else { value.negated()? })
        }),
        Node::Quotient(a, b) => constant_exponent(a)?.over(constant_exponent(b)?),
        _ => None,
    }
}

pub(super) struct Evaluator<'a, D> {
    pub(super) environment: &'a dyn Environment<D>,
    pub(super) indices: Vec<(IndexId, u8)>,
    /// The letters of the integrals around a formula, with their values.
    pub(super) letters: Vec<(String, D)>,
    /// The number of terms of the result that are used.
    pub(super) terms: usize,
}

pub(super) type Evaluated<T> = Result<T, Unavailable>;

impl<D: Differentiable> Evaluator<'_, D> {
    pub(super) fn value(&mut self, expr: &Expr) -> Evaluated<Value<D>> {
        Ok(match &expr.node {
            Node::Number(digits) => Value::Scalar(D::decimal(digits).ok_or(Unavailable::Operation("a number"))?),
            Node::Pi => Value::Scalar(D::pi()),
            Node::Euler => Value::Scalar(D::one().exp()),
            Node::Unit(unit) => Value::Scalar(size(*unit).ok_or(Unavailable::Operation("a unit"))?),
            Node::Symbol { id, indices, dots } => return self.symbol(*id, indices, *dots),
            Node::Sum(terms) => return self.sum(terms),
            Node::Product(factors) => return self.product(factors),
            Node::Quotient(a, b) => return self.quotient(a, b),
            Node::Power(base, exponent) => return self.power(base, exponent),
            Node::Identity => Value::Scalar(D::one()),
            Node::Imaginary => Value::Complex(Complex::i()),
            Node::OfMatrix(..)
            | Node::Commutator(..)
            | Node::Complex(..)
            | Node::Cases(_)
            | Node::Definite(_)
            | Node::Rest(_)
            | Node::Letter(_) => return self.operator(expr),
            Node::Root(degree, radicand) => {
                let x = self.scalar(radicand)?;
                Value::Scalar(match degree {
                    2 => x.sqrt(),
                    3 => x.cbrt(),
                    n => x.rational_power(Ratio { numerator: 1, denominator: u64::from(*n) }),
                })
            }
            Node::Call(function, argument) => match self.value(argument)? {
                Value::Scalar(x) => Value::Scalar(call(*function, x)),
                Value::Complex(z) => Value::Complex(
                    z.call(*function).ok_or(Unavailable::Operation("this function of a complex number"))?,
                ),
                _ => return Err(Unavailable::Operation("a function of a vector or a matrix")),
            },
            Node::Apply(id, _) if self.environment.symbols().entry(*id).operator.is_some() => {
                return Err(Unavailable::Operation("a function or an operator without a formula"));
            }
            Node::Apply(id, arguments) => match arguments.as_slice() {
                [angle] => {
                    let angle = self.scalar(angle)?;
                    let matrix = self.environment.rotation(*id, angle)?;
                    Value::Matrix(DMatrix::from_fn(3, 3, |i, j| matrix[(i, j)]))
                }
                _ => return Err(Unavailable::Operation("a function of several arguments")),
            },
            Node::TimeDerivative(order, inner) => return self.time_derivative(*order, inner),
            Node::Norm(inner) => Value::Scalar(self.norm(inner, true)?),
            Node::Cross(a, b) => {
                let (a, b) = (self.vector(a)?, self.vector(b)?);
                Value::Vector(cross(&a, &b))
            }
            Node::Dot(a, b) => {
                let (a, b) = (self.vector(a)?, self.vector(b)?);
                Value::Scalar(dot(&a, &b))
            }
            Node::Matrix(_) | Node::Transpose(_) | Node::Inverse(_) | Node::Entry(..) => return self.of_matrices(expr),
            Node::Epsilon([a, b, c]) => {
                let [a, b, c] = [self.index(*a)?, self.index(*b)?, self.index(*c)?].map(i32::from);
                Value::Scalar(constant(f64::from((a - b) * (b - c) * (c - a)) / 2.0))
            }
            Node::Delta([a, b]) => {
                let equal = self.index(*a)? == self.index(*b)?;
                Value::Scalar(constant(if equal { 1.0 } else { 0.0 }))
            }
            Node::Integral(region, body) => {
                let environment = self.environment;
                let closed = self.indices.is_empty().then_some(&**body);
                environment.integral(*region, closed, &mut || self.value(body))?
            }
            Node::Shrinking(region, body) => {
                let environment = self.environment;
                environment.shrinking(*region, &mut || self.value(body))?
            }
            Node::Component(inner, index) => {
                let at = usize::from(self.index(*index)?).wrapping_sub(1);
                let vector = self.vector(inner)?;
                Value::Scalar(
                    *vector.get(at).ok_or(Unavailable::Operation("a component other than 1, 2 or 3 of a vector"))?,
                )
            }
            Node::SumOver { index, except, within, body, .. } => {
                return self.sum_over(*index, except, *within, body);
            }
        })
    }

    // What formulas are mostly made of has functions of its own, not inlined: so the frame of each is small.

    #[inline(never)]
    fn sum(&mut self, terms: &[Term]) -> Evaluated<Value<D>> {
        let mut total: Option<Value<D>> = None;
        for term in terms {
            if terms.len() > 1 && term.expr.is_zero() {
                continue;
            }
            let value = self.value(&term.expr)?;
            match &mut total {
                None if term.sign == Sign::Plus => total = Some(value),
                None => total = Some(value.map(|x| -x)),
                Some(total) => added(total, &value, term.sign)?,
            }
        }
        Ok(total.unwrap_or(Value::Scalar(constant(0.0))))
    }

    #[inline(never)]
    fn product(&mut self, factors: &[Expr]) -> Evaluated<Value<D>> {
        let Some((first, others)) = factors.split_first() else { return Ok(Value::Scalar(constant(1.0))) };
        let mut total = self.value(first);
        for factor in others {
            let Ok(product) = &mut total else { break };
            if !product.multiply(self.value(factor)?) {
                return Err(Unavailable::Operation("a product of vectors or matrices whose sizes do not fit"));
            }
        }
        total
    }

    #[inline(never)]
    fn sum_over(
        &mut self,
        index: IndexId,
        except: &[Excluded],
        within: Option<SymbolId>,
        body: &Expr,
    ) -> Evaluated<Value<D>> {
        let upper = match within {
            Some(region) => self.environment.count_within(region)?,
            None => self.environment.count(index)?,
        };
        let (first, last, out) = kept(&self.indices, except, upper)?;
        let mut total: Option<Value<D>> = None;
        for value in first..=last {
            if out.contains(&value) {
                continue;
            }
            self.indices.push((index, value));
            let term = self.value(body);
            self.indices.pop();
            match &mut total {
                None => total = Some(term?),
                Some(total) => added(total, &term?, Sign::Plus)?,
            }
        }
        match total {
            Some(total) => Ok(total),
            None if upper == 0 => Ok(Value::Scalar(constant(0.0))),
            // An empty sum is the zero of what it sums.
            None => {
                self.indices.push((index, 1));
                let term = self.value(body);
                self.indices.pop();
                Ok(term?.map(|_| constant(0.0)))
            }
        }
    }

    pub(super) fn scalar(&mut self, expr: &Expr) -> Evaluated<D> {
        match self.value(expr)? {
            Value::Scalar(value) => Ok(value),
            _ => Err(Unavailable::Operation("a vector, a matrix or a complex number where a real number is needed")),
        }
    }

    fn vector(&mut self, expr: &Expr) -> Evaluated<Vector3<D>> {
        match self.value(expr)? {
            Value::Vector(value) => Ok(value),
            _ => Err(Unavailable::Operation("a number or a matrix where a vector is needed")),
        }
    }

    pub(super) fn index(&self, index: Index) -> Evaluated<u8> {
        value_of(index, &self.indices)
    }

    #[inline(never)]
    fn symbol(&self, id: SymbolId, indices: &[Index], dots: u8) -> Evaluated<Value<D>> {
        let symbols = self.environment.symbols();
        let entry = symbols.entry(id);
        if indices.is_empty() && !entry.slots.is_empty() && entry.kind == Kind::Scalar {
            let member = |indices: &[u8]| match self.member(id, indices, dots)? {
                Value::Scalar(value) => Ok(value),
                _ => Err(Unavailable::Symbol(id)),
            };
            return match symbols.extents(id).as_slice() {
                [_] => Ok(Value::Vector(Vector3::new(member(&[1])?, member(&[2])?, member(&[3])?))),
                [rows, columns] => {
                    let mut entries = Vec::with_capacity(usize::from(*rows) * usize::from(*columns));
                    for i in 1..=*rows {
                        for j in 1..=*columns {
                            entries.push(member(&[i, j])?);
                        }
                    }
                    Ok(Value::Matrix(DMatrix::from_row_slice((*rows).into(), (*columns).into(), &entries)))
                }
                _ => Err(Unavailable::Symbol(id)),
            };
        }
        // Most symbols have few indices: those need no list.
        match indices {
            [] => self.member(id, &[], dots),
            [i] => self.member(id, &[self.index(*i)?], dots),
            [i, j] => self.member(id, &[self.index(*i)?, self.index(*j)?], dots),
            _ => {
                let values: Evaluated<Vec<u8>> = indices.iter().map(|index| self.index(*index)).collect();
                self.member(id, &values?, dots)
            }
        }
    }

    /// A symbol for these values of its indices. For an assembled family it is the member of that name.
    fn member(&self, id: SymbolId, indices: &[u8], dots: u8) -> Evaluated<Value<D>> {
        let symbols = self.environment.symbols();
        let entry = symbols.entry(id);
        if entry.members.is_empty() {
            return self.dotted(id, indices, dots);
        }
        let extents = symbols.extents(id);
        let place = indices
            .iter()
            .zip(&extents)
            .fold(0, |place, (index, extent)| place * usize::from(*extent) + usize::from(*index) - 1);
        let member = entry.members.get(place).ok_or(Unavailable::Symbol(id))?;
        self.dotted(*member, &[], dots)
    }

    fn dotted(&self, id: SymbolId, indices: &[u8], dots: u8) -> Evaluated<Value<D>> {
        match dots {
            0 => self.environment.symbol_to(id, indices, self.terms),
            dots => self.environment.rate_to(id, indices, dots, self.terms),
        }
    }

    /// The norm of a vector, or the absolute value of a number. Where the sign does not matter, it is the number
    /// itself.
    fn norm(&mut self, inner: &Expr, sign_matters: bool) -> Evaluated<D> {
        match self.value(inner)? {
            Value::Scalar(x) => Ok(if sign_matters { x.abs() } else { x }),
            Value::Vector(v) => Ok(dot(&v, &v).sqrt()),
            Value::Complex(z) => Ok(z.square().sqrt()),
            Value::Matrix(_) => Err(Unavailable::Operation("the norm of a matrix")),
        }
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Evaluated<Value<D>> {
        if base.node == Node::Euler {
            return match self.value(exponent)? {
                Value::Scalar(x) => Ok(Value::Scalar(x.exp())),
                Value::Complex(z) => Ok(Value::Complex(z.exp())),
                _ => Err(Unavailable::Operation("the exponential of a vector or a matrix")),
            };
        }
        let constant = constant_exponent(exponent);
        let x = match (&base.node, constant) {
            // An even power of an absolute value asks for no sign.
            (Node::Norm(inner), Some(n)) if n.is_whole() && n.numerator % 2 == 0 => {
                match (self.value(inner)?, n.numerator) {
                    // The square of the length of a complex number needs no root.
                    (Value::Complex(z), n @ -64..=64) => return Ok(Value::Scalar(z.square().powi((n / 2) as i32))),
                    _ => self.norm(inner, false)?,
                }
            }
            _ => match (self.value(base)?, constant) {
                (Value::Scalar(x), _) => x,
                (Value::Complex(z), Some(n)) if n.is_whole() && n.numerator.abs() <= 64 => {
                    return Ok(Value::Complex(z.power(n.numerator as i32)));
                }
                (Value::Matrix(m), Some(n)) if n.is_whole() && (1..=64).contains(&n.numerator) => {
                    let power = matrices::power(&m, n.numerator as u32);
                    return power
                        .map(Value::Matrix)
                        .ok_or(Unavailable::Operation("a power of a matrix that is not square"));
                }
                _ => {
                    return Err(Unavailable::Operation(
                        "a power of a vector, or a power of a matrix or a complex number with this exponent",
                    ));
                }
            },
        };
        Ok(Value::Scalar(match constant {
            Some(n) if n.is_whole() && n.numerator.abs() <= 64 => x.powi(n.numerator as i32),
            Some(Ratio { numerator: 1, denominator: 2 }) => x.sqrt(),
            Some(n) => x.rational_power(n),
            None => {
                let n = self.scalar(exponent)?;
                // A whole number that does not vary is a power of its own, for negative bases too.
                // A number of too many digits is near a whole number, and is none.
                let symbols = exponent.symbols();
                let varies = |id| self.environment.symbols().entry(id).varies;
                let varies = symbols.is_empty() || symbols.iter().any(|(id, _)| varies(*id));
                match n.known_value() {
                    Some(whole) if !varies && whole.fract() == 0.0 && whole.abs() <= 64.0 => x.powi(whole as i32),
                    _ => (x.ln() * n).exp(),
                }
            }
        }))
    }
}

// What does not ask for the number stands outside of the evaluator, which is compiled for each number.

/// The value of an index where letters have these values; the last one counts.
fn value_of(index: Index, letters: &[(IndexId, u8)]) -> Evaluated<u8> {
    match index {
        Index::Fixed(value) => Ok(value),
        Index::Letter(id) => letters
            .iter()
            .rev()
            .find(|(known, _)| *known == id)
            .map(|(_, value)| *value)
            .ok_or(Unavailable::Operation("an index without a value")),
    }
}

/// The range of a Σ: its first value, its last value, and the values in between that are excluded.
fn kept(letters: &[(IndexId, u8)], except: &[Excluded], upper: u8) -> Evaluated<(u8, u8, Vec<u8>)> {
    let (mut first, mut last, mut out) = (1, upper, Vec::new());
    for left_out in except {
        match left_out {
            Excluded::Value(index) => out.push(value_of(*index, letters)?),
            Excluded::From(index) => last = last.min(value_of(*index, letters)?.saturating_sub(1)),
            Excluded::UpTo(index) => first = first.max(value_of(*index, letters)?.saturating_add(1)),
            Excluded::Last(count) => last = last.min(upper.saturating_sub(*count)),
        }
    }
    Ok((first, last, out))
}

fn added<D: Number>(total: &mut Value<D>, value: &Value<D>, sign: Sign) -> Evaluated<()> {
    total
        .add(value, sign)
        .then_some(())
        .ok_or(Unavailable::Operation("a sum of numbers and vectors, or of matrices of different sizes"))
}

fn constant<D: Number>(value: f64) -> D {
    D::from(value)
}

fn call<D: Number>(function: Function, x: D) -> D {
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Cot => x.cos() / x.sin(),
        Function::Sec => x.cos().recip(),
        Function::Csc => x.sin().recip(),
        Function::Arcsin => x.asin(),
        Function::Arccos => x.acos(),
        Function::Arctan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.hyperbolic_tangent(),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
    }
}
