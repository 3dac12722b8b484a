//! The value of quotients, derivatives by the time, matrices and functions of them, of parts of complex numbers, of `cases`, of integrals over a letter, and of powers.

use nalgebra::DMatrix;

use super::calculus::quadrature;
use super::environment::{Differentiable, Unavailable, differentiate};
use super::evaluate::{Evaluated, Evaluator};
use super::numbers::complex::Complex;
use super::numbers::matrices;
use super::tree::{Branch, Definite, Expr, Node, Relation, Sign};
use super::value::Value;

impl<D: Differentiable> Evaluator<'_, D> {
    /// Functions of matrices, parts of complex numbers, cases, and integrals over a letter.
    #[inline(never)]
    pub(super) fn operator(&mut self, expr: &Expr) -> Evaluated<Value<D>> {
        match &expr.node {
            Node::OfMatrix(function, inner) => match self.value(inner)? {
                Value::Matrix(m) => {
                    let value = function.of(&m).ok_or(Unavailable::Operation(
                        "det or tr of a matrix that is not square or has more than 6 rows",
                    ))?;
                    Ok(Value::Scalar(value))
                }
                _ => Err(Unavailable::Operation("det or tr of something that is not a matrix")),
            },
            Node::Commutator(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                let (mut first, mut second) = (a.clone(), b.clone());
                let known = first.multiply(b) && second.multiply(a) && first.add(&second, Sign::Minus);
                known
                    .then_some(first)
                    .ok_or(Unavailable::Operation("a commutator of anything but two square matrices of the same size"))
            }
            Node::Complex(part, inner) => {
                let number = match self.value(inner)? {
                    Value::Scalar(x) => Complex::real(x),
                    Value::Complex(z) => z,
                    _ => {
                        return Err(Unavailable::Operation(
                            "a real part or an argument of something that is not a number",
                        ));
                    }
                };
                Ok(number.part(*part).map_or_else(Value::Complex, Value::Scalar))
            }
            Node::Cases(branches) => self.cases(branches),
            Node::Letter(name) => {
                let value = self.letters.iter().rev().find(|(letter, _)| letter == name).map(|(_, value)| *value);
                value
                    .map(Value::Scalar)
                    .ok_or(Unavailable::Operation("the variable of an integral outside of the integral"))
            }
            Node::Definite(of) => {
                let environment = self.environment;
                let is_closed = self.indices.is_empty() && self.letters.is_empty();
                environment.quadrature(of, is_closed, &mut || self.integral(of))
            }
            Node::Rest(_) => Err(Unavailable::Operation("a sum whose further terms are left out")),
            _ => Err(Unavailable::Operation("an operation that is not supported")),
        }
    }

    #[inline(never)]
    pub(super) fn quotient(&mut self, a: &Expr, b: &Expr) -> Evaluated<Value<D>> {
        let above = self.value(a)?;
        Ok(match (self.value(b)?, above) {
            (Value::Scalar(divisor), above) => above.map(|x| x / divisor),
            (Value::Complex(divisor), Value::Scalar(above)) => Value::Complex(Complex::real(above).over(divisor)),
            (Value::Complex(divisor), Value::Complex(above)) => Value::Complex(above.over(divisor)),
            _ => {
                return Err(Unavailable::Operation(
                    "a division by a vector or a matrix, or of a vector or matrix by a complex number",
                ));
            }
        })
    }

    #[inline(never)]
    pub(super) fn time_derivative(&mut self, order: u8, inner: &Expr) -> Evaluated<Value<D>> {
        if let Some(derivative) = self.environment.derivative(order, inner, &self.indices) {
            return derivative;
        }
        let terms = self.terms;
        self.terms = terms.saturating_add(usize::from(order));
        let value = self.value(inner);
        self.terms = terms;
        let mut value = value?;
        differentiate(&mut value, order)?;
        Ok(value)
    }

    /// A matrix, its transpose, its inverse, or one of its entries.
    #[inline(never)]
    pub(super) fn of_matrices(&mut self, expr: &Expr) -> Evaluated<Value<D>> {
        Ok(match &expr.node {
            Node::Matrix(rows) => {
                let mut entries = Vec::with_capacity(rows.iter().map(Vec::len).sum());
                for entry in rows.iter().flatten() {
                    entries.push(self.scalar(entry)?);
                }
                Value::of_matrix(DMatrix::from_row_slice(rows.len(), entries.len() / rows.len().max(1), &entries))
            }
            Node::Transpose(inner) => match self.value(inner)?.as_matrix() {
                Some(m) => Value::of_matrix(m.transpose()),
                _ => return Err(Unavailable::Operation("the transpose of something that is not a matrix")),
            },
            Node::Inverse(inner) => match self.value(inner)? {
                Value::Matrix(m) => Value::Matrix(matrices::inverse(&m).ok_or(Unavailable::Operation(
                    "the inverse of a matrix that is not square or has more than 6 rows",
                ))?),
                _ => return Err(Unavailable::Operation("the inverse of something that is not a matrix")),
            },
            Node::Entry(inner, row, column) => match (self.value(inner)?, self.index(*row)?, self.index(*column)?) {
                (Value::Matrix(m), i, j)
                    if usize::from(i.max(1)) <= m.nrows() && usize::from(j.max(1)) <= m.ncols() =>
                {
                    Value::Scalar(m[(usize::from(i) - 1, usize::from(j) - 1)])
                }
                _ => return Err(Unavailable::Operation("an entry of something that is not a matrix")),
            },
            _ => return Err(Unavailable::Operation("an operation that is not supported")),
        })
    }

    /// An integral over one letter, by quadrature.
    fn integral(&mut self, of: &Definite) -> Evaluated<Value<D>> {
        let mut end = |end: &Option<Expr>| end.as_ref().map(|end| self.scalar(end)).transpose();
        let ends = (end(&of.lower)?, end(&of.upper)?);
        let value = quadrature::integral(ends, &mut |x| {
            self.letters.push((of.letter.clone(), x));
            let value = self.scalar(&of.integrand);
            self.letters.pop();
            value
        });
        value.map(Value::Scalar)
    }

    /// The value of the first branch whose conditions hold.
    fn cases(&mut self, branches: &[Branch]) -> Evaluated<Value<D>> {
        for branch in branches {
            let mut holds = true;
            for condition in &branch.conditions {
                let mut members = Vec::with_capacity(condition.members.len());
                for member in &condition.members {
                    members.push(self.scalar(member)?);
                }
                for (pair, relation) in members.windows(2).zip(&condition.relations) {
                    holds &= compare(pair[0] - pair[1], *relation)?;
                }
            }
            if holds {
                return self.value(&branch.value);
            }
        }
        // Outside of all cases there is no value, as there is none of a root of a negative number.
        Ok(Value::Scalar(D::from(f64::NAN)))
    }
}

/// Whether a relation holds between two numbers with this difference. A number without an order, of a prime field,
/// notes that an order was asked for.
fn compare<D: Differentiable>(difference: D, relation: Relation) -> Evaluated<bool> {
    if difference.re().is_nan() {
        return Err(Unavailable::Operation("a comparison in which one side has no value"));
    }
    Ok(match relation {
        Relation::Less => difference.is_negative(),
        Relation::Greater => difference.is_positive(),
        Relation::LessEqual => !difference.is_positive(),
        Relation::GreaterEqual => !difference.is_negative(),
        Relation::Equal | Relation::Identical => !difference.is_positive() && !difference.is_negative(),
        Relation::NotEqual => difference.is_positive() || difference.is_negative(),
        Relation::Approximately | Relation::Proportional => {
            return Err(Unavailable::Operation("a comparison with ≈ or ∝"));
        }
    })
}
