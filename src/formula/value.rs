//! The value of a formula: a number, a vector in three dimensions, or a matrix, over any number type.

use nalgebra::{DMatrix, Matrix3, Vector3};

use crate::scalar::Number;

use super::numbers::complex::Complex;
use super::shape::Shape;
use super::symbols::Kind;
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
    /// A complex number.
    Complex(Complex<D>),
}

// Derived, it would copy a vector number after number.
impl<D: Number> Clone for Value<D> {
    fn clone(&self) -> Self {
        match self {
            Value::Scalar(value) => Value::Scalar(*value),
            Value::Vector(vector) => Value::Vector(*vector),
            Value::Matrix(matrix) => Value::Matrix(matrix.clone()),
            Value::Complex(z) => Value::Complex(*z),
        }
    }
}

impl<D: Number> Value<D> {
    /// A matrix as a value: one entry is a number, and three rows of one column are a vector.
    pub fn of_matrix(m: DMatrix<D>) -> Self {
        match m.shape() {
            (1, 1) => Value::Scalar(m[(0, 0)]),
            (3, 1) => Value::Vector(Vector3::new(m[(0, 0)], m[(1, 0)], m[(2, 0)])),
            _ => Value::Matrix(m),
        }
    }

    /// The value as a matrix; a vector is a column. `None` for a number.
    pub fn as_matrix(&self) -> Option<DMatrix<D>> {
        match self {
            Value::Scalar(_) | Value::Complex(_) => None,
            Value::Vector(v) => Some(DMatrix::from_column_slice(3, 1, &[v.x, v.y, v.z])),
            Value::Matrix(m) => Some(m.clone()),
        }
    }

    /// The numbers of the value: one, three, a matrix row by row, or the real and the imaginary part.
    pub fn entries(&self) -> Vec<D> {
        match self {
            Value::Scalar(value) => vec![*value],
            Value::Vector(vector) => vector.as_slice().to_vec(),
            Value::Matrix(matrix) => matrix.transpose().as_slice().to_vec(),
            Value::Complex(z) => vec![z.re, z.im],
        }
    }

    /// The value of a symbol of this kind, from its numbers in their order; `None` if one is missing.
    pub fn of_numbers(kind: Kind, pick: &mut dyn FnMut(usize) -> Option<D>) -> Option<Self> {
        Some(match kind {
            Kind::Scalar | Kind::Rotation => Value::Scalar(pick(0)?),
            Kind::Vector => Value::Vector(Vector3::new(pick(0)?, pick(1)?, pick(2)?)),
            Kind::Complex => Value::Complex(Complex { re: pick(0)?, im: pick(1)? }),
            Kind::Abstract => return None,
            Kind::Matrix(rows, columns) => {
                let mut entries = Vec::with_capacity(kind.numbers());
                for k in 0..kind.numbers() {
                    entries.push(pick(k)?);
                }
                Value::of_matrix(DMatrix::from_row_slice(rows.into(), columns.into(), &entries))
            }
        })
    }

    /// The shape of the value.
    pub fn shape(&self) -> Shape {
        match self {
            Value::Scalar(_) => Shape::Scalar,
            Value::Vector(_) => Shape::Vector,
            Value::Matrix(matrix) => Shape::Matrix(matrix.nrows(), matrix.ncols()),
            Value::Complex(_) => Shape::Complex,
        }
    }

    /// The name of the k-th entry in messages: `component 2`, `entry (1,3)`; `None` for a number.
    pub fn entry_name(shape: Shape, k: usize) -> Option<String> {
        match shape {
            Shape::Scalar | Shape::Abstract => None,
            Shape::Vector => Some(format!("component {}", k + 1)),
            Shape::Complex => Some(if k == 0 { "real part" } else { "imaginary part" }.to_owned()),
            Shape::Matrix(_, columns) => Some(format!("entry ({},{})", k / columns + 1, k % columns + 1)),
        }
    }

    // Every function here is compiled for each of some twenty numbers. So those that take a closure have a short part,
    // for a single number, that is compiled for each closure, and a part for all shapes that is compiled once.

    /// Applies `f` to every number in it.
    #[inline]
    pub fn map(mut self, f: impl Fn(D) -> D) -> Self {
        self.for_each(|x| *x = f(*x));
        self
    }

    /// The value with `f` applied to every number, which may change the number type.
    #[inline]
    pub fn each<E: Number>(&self, f: impl Fn(&D) -> E) -> Value<E> {
        match self {
            Value::Scalar(value) => Value::Scalar(f(value)),
            others => others.each_of_several(&f),
        }
    }

    fn each_of_several<E: Number>(&self, f: &dyn Fn(&D) -> E) -> Value<E> {
        match self {
            Value::Scalar(value) => Value::Scalar(f(value)),
            Value::Vector(vector) => Value::Vector(Vector3::new(f(&vector.x), f(&vector.y), f(&vector.z))),
            Value::Matrix(matrix) => {
                let mut entries = Vec::with_capacity(matrix.len());
                for entry in matrix.as_slice() {
                    entries.push(f(entry));
                }
                Value::Matrix(DMatrix::from_vec(matrix.nrows(), matrix.ncols(), entries))
            }
            Value::Complex(z) => Value::Complex(Complex { re: f(&z.re), im: f(&z.im) }),
        }
    }

    /// Applies `f` to every number in place.
    #[inline]
    pub fn for_each(&mut self, mut f: impl FnMut(&mut D)) {
        match self {
            Value::Scalar(value) => f(value),
            others => others.for_each_of_several(&mut f),
        }
    }

    fn for_each_of_several(&mut self, f: &mut dyn FnMut(&mut D)) {
        let several = match self {
            Value::Scalar(value) => return f(value),
            Value::Complex(z) => {
                f(&mut z.re);
                return f(&mut z.im);
            }
            Value::Vector(vector) => vector.as_mut_slice(),
            Value::Matrix(matrix) => matrix.as_mut_slice(),
        };
        for value in several {
            f(value);
        }
    }

    /// The sum; `None` if the shapes differ.
    pub fn plus(mut self, other: Self) -> Option<Self> {
        self.add(&other, Sign::Plus).then_some(self)
    }

    /// Adds or subtracts another value in place. Returns false and changes nothing if the shapes differ.
    pub fn add(&mut self, other: &Self, sign: Sign) -> bool {
        let put = |a: &mut D, b: D| match sign {
            Sign::Plus => *a += b,
            Sign::Minus => *a -= b,
        };
        let put_all = |a: &mut [D], b: &[D]| {
            for (a, b) in a.iter_mut().zip(b) {
                put(a, *b);
            }
        };
        match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => put(a, *b),
            (Value::Vector(a), Value::Vector(b)) => put_all(a.as_mut_slice(), b.as_slice()),
            (Value::Matrix(a), Value::Matrix(b)) if a.shape() == b.shape() => {
                put_all(a.as_mut_slice(), b.as_slice());
            }
            (Value::Complex(a), Value::Complex(b)) => {
                put(&mut a.re, b.re);
                put(&mut a.im, b.im);
            }
            (Value::Complex(a), Value::Scalar(b)) => put(&mut a.re, *b),
            (scalar @ Value::Scalar(_), Value::Complex(b)) => {
                let Value::Scalar(a) = scalar else { return false };
                let mut total = Complex::real(*a);
                put(&mut total.re, b.re);
                put(&mut total.im, b.im);
                *scalar = Value::Complex(total);
            }
            // Beside a matrix, a number is that multiple of the unit matrix.
            (Value::Matrix(a), Value::Scalar(b)) if a.nrows() == a.ncols() => {
                for k in 0..a.nrows() {
                    put(&mut a[(k, k)], *b);
                }
            }
            (scalar @ Value::Scalar(_), Value::Matrix(b)) if b.nrows() == b.ncols() => {
                let Value::Scalar(a) = scalar else { return false };
                let mut total = DMatrix::from_diagonal_element(b.nrows(), b.ncols(), *a);
                put_all(total.as_mut_slice(), b.as_slice());
                *scalar = Value::Matrix(total);
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
            (Value::Matrix(a), Value::Vector(b)) if a.shape() == (3, 3) => {
                *self = Value::Vector(Matrix3::from_column_slice(a.as_slice()) * b);
            }
            (Value::Complex(a), Value::Complex(b)) => *a = a.times(b),
            (Value::Vector(_), Value::Vector(_)) => return false,
            (a, b) => match (a.as_matrix(), b.as_matrix()) {
                (Some(a), Some(b)) if a.ncols() == b.nrows() => *self = Value::of_matrix(a * b),
                _ => return false,
            },
        }
        true
    }
}
