//! The value of a formula: a number, a vector in three dimensions, or a matrix, over any number type.

use nalgebra::{DMatrix, Vector3};

use crate::scalar::Number;

use super::shape::Shape;
use super::tree::Sign;

/// The value of a formula.
#[derive(Debug, PartialEq)]
pub enum Value<D: Number> {
    /// A number.
    Scalar(D),
    /// A vector, by its components along the fixed axes.
    Vector(Vector3<D>),
    /// A matrix.
    Matrix(DMatrix<D>),
}

// Derived, it would copy a vector number after number.
impl<D: Number> Clone for Value<D> {
    fn clone(&self) -> Self {
        match self {
            Value::Scalar(value) => Value::Scalar(*value),
            Value::Vector(vector) => Value::Vector(*vector),
            Value::Matrix(matrix) => Value::Matrix(matrix.clone()),
        }
    }
}

impl<D: Number> Value<D> {
    /// The numbers of the value: one, three, or a matrix row by row.
    pub fn entries(&self) -> Vec<D> {
        match self {
            Value::Scalar(value) => vec![*value],
            Value::Vector(vector) => vector.iter().copied().collect(),
            Value::Matrix(matrix) => matrix.transpose().iter().copied().collect(),
        }
    }

    /// The shape of the value.
    pub fn shape(&self) -> Shape {
        match self {
            Value::Scalar(_) => Shape::Scalar,
            Value::Vector(_) => Shape::Vector,
            Value::Matrix(matrix) => Shape::Matrix(matrix.nrows(), matrix.ncols()),
        }
    }

    /// The name of the k-th entry in messages: `component 2`, `entry (1,3)`; `None` for a number.
    pub fn entry_name(shape: Shape, k: usize) -> Option<String> {
        match shape {
            Shape::Scalar => None,
            Shape::Vector => Some(format!("component {}", k + 1)),
            Shape::Matrix(_, columns) => Some(format!("entry ({},{})", k / columns + 1, k % columns + 1)),
        }
    }

    /// Applies `f` to every number in it.
    pub fn map(self, f: impl Fn(D) -> D) -> Self {
        match self {
            Value::Scalar(value) => Value::Scalar(f(value)),
            Value::Vector(vector) => Value::Vector(vector.map(f)),
            Value::Matrix(matrix) => Value::Matrix(matrix.map(f)),
        }
    }

    /// The value with `f` applied to every number, which may change the number type.
    pub fn each<E: Number>(&self, f: impl Fn(&D) -> E) -> Value<E> {
        match self {
            Value::Scalar(value) => Value::Scalar(f(value)),
            Value::Vector(vector) => Value::Vector(Vector3::new(f(&vector.x), f(&vector.y), f(&vector.z))),
            Value::Matrix(matrix) => {
                Value::Matrix(DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| f(&matrix[(i, j)])))
            }
        }
    }

    /// Applies `f` to every number in place.
    pub fn for_each(&mut self, f: impl FnMut(&mut D)) {
        match self {
            Value::Scalar(value) => std::iter::once(value).for_each(f),
            Value::Vector(vector) => vector.iter_mut().for_each(f),
            Value::Matrix(matrix) => matrix.iter_mut().for_each(f),
        }
    }

    /// The sum; `None` if the shapes differ.
    pub fn plus(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => Some(Value::Scalar(a + b)),
            (Value::Vector(a), Value::Vector(b)) => Some(Value::Vector(a + b)),
            (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => Some(Value::Matrix(a + b)),
            _ => None,
        }
    }

    /// Adds or subtracts another value in place. Returns false and changes nothing if the shapes differ.
    pub fn add(&mut self, other: &Self, sign: Sign) -> bool {
        let put = |a: &mut D, b: D| match sign {
            Sign::Plus => *a += b,
            Sign::Minus => *a -= b,
        };
        match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => put(a, *b),
            (Value::Vector(a), Value::Vector(b)) => a.iter_mut().zip(b.iter()).for_each(|(a, b)| put(a, *b)),
            (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => {
                a.iter_mut().zip(b.iter()).for_each(|(a, b)| put(a, *b));
            }
            _ => return false,
        }
        true
    }

    /// Multiplies by the next factor in place. Returns false and changes nothing if the product is not defined.
    pub fn multiply(&mut self, other: Self) -> bool {
        match (&mut *self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => *a *= b,
            (Value::Scalar(a), mut other) => {
                other.for_each(|b| *b = *a * *b);
                *self = other;
            }
            (product, Value::Scalar(b)) => product.for_each(|a| *a *= b),
            (Value::Matrix(a), Value::Matrix(b)) if a.ncols() == b.nrows() => *a = &*a * b,
            (Value::Matrix(a), Value::Vector(b)) if a.shape() == (3, 3) => {
                *self = Value::Vector(a.fixed_view::<3, 3>(0, 0) * b);
            }
            _ => return false,
        }
        true
    }

    /// The inverse of a square matrix of up to three rows, by Cramer's rule; `None` for any other value.
    pub fn inverse(&self) -> Option<Self> {
        let Value::Matrix(m) = self else { return None };
        let n = m.nrows();
        if n != m.ncols() || n > 3 {
            return None;
        }
        let determinant = determinant(m);
        let cofactor = |i: usize, j: usize| {
            let minor = m.clone().remove_row(i).remove_column(j);
            let value = if n == 1 { D::one() } else { self::determinant(&minor) };
            if (i + j).is_multiple_of(2) { value } else { -value }
        };
        Some(Value::Matrix(DMatrix::from_fn(n, n, |i, j| cofactor(j, i) / determinant)))
    }
}

fn determinant<D: Number>(m: &DMatrix<D>) -> D {
    match m.nrows() {
        1 => m[(0, 0)],
        2 => m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)],
        _ => (0..3)
            .map(|j| {
                let (a, b) = ((j + 1) % 3, (j + 2) % 3);
                m[(0, j)] * (m[(1, a)] * m[(2, b)] - m[(1, b)] * m[(2, a)])
            })
            .sum(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_times_its_inverse_is_the_unit_matrix() {
        let m = DMatrix::from_row_slice(3, 3, &[2.0, 1.0, 0.5, -1.0, 3.0, 0.2, 0.7, 0.1, -1.5]);
        let product = |other: Value<f64>| {
            let mut product = Value::Matrix(m.clone());
            assert!(product.multiply(other));
            let Value::Matrix(product) = product else { panic!() };
            product
        };
        let inverse = Value::Matrix(m.clone()).inverse().unwrap();
        approx::assert_relative_eq!(product(inverse), DMatrix::identity(3, 3), epsilon = 1e-14);
        let transpose = Value::Matrix(m.transpose());
        approx::assert_relative_ne!(product(transpose), DMatrix::identity(3, 3), epsilon = 1e-3);
    }
}
