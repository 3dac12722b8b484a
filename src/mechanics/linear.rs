//! Linear equations with a mass matrix: solved over any number, refused with the condition number when singular.

use nalgebra::{DMatrix, DVector, Dyn};
use num_dual::linalg::LU;

use crate::scalar::Number;
use crate::{Error, Result};

/// Beyond this condition number (of the equilibrated matrix) no digit of a solution could be trusted far enough.
pub const MAX_CONDITION: f64 = 1e10;

/// The ratio of the largest singular value to the smallest, after rows and columns are divided by √|M_ii|: a change
/// of the coordinates' units does not change it. Infinite for a singular matrix, NaN for one that is not finite.
pub fn condition_number(matrix: &DMatrix<f64>) -> f64 {
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return f64::NAN;
    }
    let scale: Vec<f64> =
        matrix.diagonal().iter().map(|&m| if m == 0.0 { 1.0 } else { 1.0 / m.abs().sqrt() }).collect();
    let equilibrated = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| scale[i] * matrix[(i, j)] * scale[j]);
    let values = equilibrated.singular_values();
    match (values.iter().copied().reduce(f64::max), values.iter().copied().reduce(f64::min)) {
        (Some(largest), Some(smallest)) if smallest > 0.0 => largest / smallest,
        (Some(_), _) => f64::INFINITY,
        _ => 1.0,
    }
}

/// Solves M x = b. `row(i, j)` are the entries of M.
///
/// # Errors
/// When M is singular, ill-conditioned or not finite; the message has the condition number.
pub(crate) fn solve<D: Number>(what: &str, matrix: DMatrix<D>, right: Vec<D>) -> Result<Vec<D>> {
    let condition = condition_number(&matrix.map(|entry| entry.re()));
    let refused = || {
        let message = if condition.is_nan() {
            format!("the {what} is not finite here")
        } else if condition.is_finite() {
            format!("the {what} is too ill-conditioned to invert: condition number {condition:.1e}")
        } else {
            format!("the {what} is singular: condition number ∞")
        };
        Error::new(message).help("a velocity that L does not depend on, or a place where the coordinates degenerate")
    };
    if condition.is_nan() || condition > MAX_CONDITION {
        return Err(refused());
    }
    let solution = LU::<D, Dyn>::new(matrix).map_err(|_| refused())?.solve(&DVector::from_vec(right));
    Ok(solution.iter().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::dmatrix;

    #[test]
    fn units_do_not_make_a_matrix_ill_conditioned() {
        let (good, in_other_units) = (dmatrix![2.0, 1.0; 1.0, 2.0], dmatrix![2e12, 1e6; 1e6, 2.0]);
        assert_relative_eq!(condition_number(&good), 3.0, epsilon = 1e-12);
        assert_relative_eq!(condition_number(&in_other_units), 3.0, epsilon = 1e-12);
        assert!(solve("mass matrix", in_other_units, vec![1.0, 1.0]).is_ok());
    }

    #[test]
    fn a_singular_matrix_is_refused_with_its_condition_number() {
        let message = |m| solve("mass matrix", m, vec![1.0, 1.0]).unwrap_err().to_string();
        assert!(message(dmatrix![1.0, 1.0; 1.0, 1.0]).contains("condition number"));
        assert!(message(dmatrix![1.0, 0.0; 0.0, 0.0]).contains("condition number ∞"));
        assert!(message(dmatrix![1.0, 1.0; 1.0, 1.0 + 1e-13]).contains("condition number"));
        assert!(message(dmatrix![f64::NAN, 1.0; 1.0, 1.0]).contains("not finite"));
    }
}
