//! Functions of matrices over any number: determinant, trace, inverse, power. None of them exchanges factors.

use nalgebra::DMatrix;

use crate::scalar::Number;

use super::super::operators::MatrixFunction;

/// The largest number of rows of which a determinant or an inverse is computed. Messages name it.
pub const LARGEST: usize = 6;

impl MatrixFunction {
    /// The value; `None` for a matrix that is not square or too large.
    pub fn of<D: Number>(self, m: &DMatrix<D>) -> Option<D> {
        match self {
            _ if m.nrows() != m.ncols() || m.nrows() > LARGEST => None,
            MatrixFunction::Determinant => Some(determinant(m)),
            MatrixFunction::Trace => Some(sum(m.nrows(), &mut |k| m[(k, k)])),
        }
    }
}

/// The determinant of a square matrix, expanded by the first row. It needs no division, so it is exact in every number.
pub fn determinant<D: Number>(m: &DMatrix<D>) -> D {
    match m.nrows() {
        0 => D::one(),
        1 => m[(0, 0)],
        2 => m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)],
        n => sum(n, &mut |j| {
            let part = m[(0, j)] * determinant(&m.clone().remove_row(0).remove_column(j));
            if j.is_multiple_of(2) { part } else { -part }
        }),
    }
}

fn sum<D: Number>(n: usize, term: &mut dyn FnMut(usize) -> D) -> D {
    let mut sum = D::zero();
    for k in 0..n {
        sum += term(k);
    }
    sum
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
}
