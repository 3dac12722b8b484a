//! Functions of matrices: determinant, trace, power, commutator; the products of columns and rows.
//!
//! Products are taken in the printed order, since matrices do not commute. A product of one row and one column is a
//! number, and three rows of one column are a vector, so that `q^T M q` is a number for columns of any length. The unit
//! matrix has no size of its own: its value is the number 1, which stands on the diagonal where it meets a matrix.

use nalgebra::{DMatrix, Vector3};

use crate::scalar::Number;

use super::operators::MatrixFunction;
use super::shape::Shape;
use super::value::Value;

/// The largest number of rows of which a determinant or an inverse is computed.
pub const LARGEST: usize = 6;

impl MatrixFunction {
    /// The value; `None` for a matrix that is not square or too large.
    pub fn of<D: Number>(self, m: &DMatrix<D>) -> Option<D> {
        match self {
            _ if m.nrows() != m.ncols() || m.nrows() > LARGEST => None,
            MatrixFunction::Determinant => Some(determinant(m)),
            MatrixFunction::Trace => Some((0..m.nrows()).map(|k| m[(k, k)]).sum()),
        }
    }
}

/// The determinant of a square matrix, expanded by the first row. It needs no division, so it is exact in every number.
pub fn determinant<D: Number>(m: &DMatrix<D>) -> D {
    match m.nrows() {
        0 => D::one(),
        1 => m[(0, 0)],
        2 => m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)],
        n => (0..n)
            .map(|j| {
                let part = m[(0, j)] * determinant(&m.clone().remove_row(0).remove_column(j));
                if j.is_multiple_of(2) { part } else { -part }
            })
            .sum(),
    }
}

/// The inverse of a square matrix by its cofactors; `None` for one that is not square or too large.
pub fn inverse<D: Number>(m: &DMatrix<D>) -> Option<DMatrix<D>> {
    let n = m.nrows();
    if n != m.ncols() || n > LARGEST {
        return None;
    }
    let determinant = determinant(m);
    let cofactor = |i: usize, j: usize| {
        let value = self::determinant(&m.clone().remove_row(i).remove_column(j));
        if (i + j).is_multiple_of(2) { value } else { -value }
    };
    Some(DMatrix::from_fn(n, n, |i, j| cofactor(j, i) / determinant))
}

/// A whole power of a square matrix, from 1 up.
pub fn power<D: Number>(m: &DMatrix<D>, exponent: u32) -> Option<DMatrix<D>> {
    (m.nrows() == m.ncols() && exponent > 0).then(|| (1..exponent).fold(m.clone(), |product, _| product * m))
}

/// A matrix as a value: one entry is a number, and three rows of one column are a vector.
pub fn reduced<D: Number>(m: DMatrix<D>) -> Value<D> {
    match m.shape() {
        (1, 1) => Value::Scalar(m[(0, 0)]),
        (3, 1) => Value::Vector(Vector3::new(m[(0, 0)], m[(1, 0)], m[(2, 0)])),
        _ => Value::Matrix(m),
    }
}

/// The shape of a matrix with these rows and columns.
pub fn shape_of_size(rows: usize, columns: usize) -> Shape {
    match (rows, columns) {
        (1, 1) => Shape::Scalar,
        (3, 1) => Shape::Vector,
        _ => Shape::Matrix(rows, columns),
    }
}

/// The rows and columns of a matrix, or of a vector as a column.
fn size(shape: Shape) -> Option<(usize, usize)> {
    match shape {
        Shape::Scalar | Shape::Complex => None,
        Shape::Vector => Some((3, 1)),
        Shape::Matrix(rows, columns) => Some((rows, columns)),
    }
}

/// The shape of the sum of two shapes, where it is defined.
pub fn sum(a: Shape, b: Shape) -> Option<Shape> {
    match (a, b) {
        _ if a == b => Some(a),
        (Shape::Scalar, Shape::Complex) | (Shape::Complex, Shape::Scalar) => Some(Shape::Complex),
        (Shape::Matrix(0, 0), Shape::Matrix(n, m)) | (Shape::Matrix(n, m), Shape::Matrix(0, 0)) if n == m => {
            Some(Shape::Matrix(n, n))
        }
        _ => None,
    }
}

/// The shape of a product of two factors in this order; `None` where it is not defined. Two vectors have none: they need
/// a sign between them.
pub fn product(a: Shape, b: Shape) -> Option<Shape> {
    match (a, b) {
        (Shape::Scalar, other) | (other, Shape::Scalar) => Some(other),
        (Shape::Complex, Shape::Complex) => Some(Shape::Complex),
        (Shape::Vector, Shape::Vector) => None,
        (Shape::Matrix(0, 0), other) => Some(other),
        (other, Shape::Matrix(0, 0)) => (other != Shape::Vector).then_some(other),
        _ => {
            let ((rows, inner), (other, columns)) = (size(a)?, size(b)?);
            (inner == other).then(|| shape_of_size(rows, columns))
        }
    }
}

/// The value as a matrix; a vector is a column. `None` for a number.
pub fn as_matrix<D: Number>(value: &Value<D>) -> Option<DMatrix<D>> {
    match value {
        Value::Scalar(_) | Value::Complex(_) => None,
        Value::Vector(v) => Some(DMatrix::from_column_slice(3, 1, &[v.x, v.y, v.z])),
        Value::Matrix(m) => Some(m.clone()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix with entries that repeat nothing.
    fn sample(n: usize) -> DMatrix<f64> {
        DMatrix::from_fn(n, n, |i, j| ((3 * i + 7 * j) as f64 * 1.3).sin() + if i == j { 2.0 } else { 0.0 })
    }

    #[test]
    fn the_determinant_is_that_of_another_method() {
        for n in 1..=LARGEST {
            let m = sample(n);
            approx::assert_relative_eq!(determinant(&m), m.clone().lu().determinant(), epsilon = 1e-10);
            approx::assert_relative_ne!(determinant(&m), -m.lu().determinant(), epsilon = 1e-3);
        }
    }

    #[test]
    fn a_matrix_times_its_inverse_is_the_unit_matrix() {
        for n in 1..=LARGEST {
            let m = sample(n);
            let inverse = inverse(&m).unwrap();
            approx::assert_relative_eq!(&m * inverse, DMatrix::identity(n, n), epsilon = 1e-10);
        }
        assert!(inverse(&DMatrix::<f64>::identity(2, 3)).is_none());
    }

    #[test]
    fn products_have_the_shape_of_their_values() {
        let (row, column, square) = (Shape::Matrix(1, 2), Shape::Matrix(2, 1), Shape::Matrix(2, 2));
        assert_eq!(product(row, column), Some(Shape::Scalar));
        assert_eq!(product(column, row), Some(square));
        assert_eq!(product(square, column), Some(column));
        assert_eq!(product(column, square), None);
        assert_eq!(product(Shape::Vector, Shape::Vector), None);
        assert_eq!(product(Shape::Matrix(1, 3), Shape::Vector), Some(Shape::Scalar));
        assert_eq!(product(Shape::Vector, Shape::Matrix(1, 3)), Some(Shape::Matrix(3, 3)));
    }
}
