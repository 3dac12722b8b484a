//! Linear equations with a mass matrix, over any number. A singular or ill-conditioned matrix is an error. The traced system, the
//! Euler–Lagrange equations and coupled laws solve for accelerations with it.
//!
//! Elements of a prime field have no magnitude to choose pivots by. For them there is Cramer's rule, which also keeps
//! the degrees of the solution low.

use nalgebra::{DMatrix, DVector, Dyn, Matrix3};
use num_dual::linalg::LU;

use crate::code::Code;
use crate::scalar::{Number, up_to};
use crate::{Error, Result};

/// The largest condition number, of the equilibrated matrix, with which linear equations are solved.
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

/// Whether a bound that takes no singular values is enough: the condition number of n rows is below
/// 2/|det| · (‖·‖/√n)ⁿ with Frobenius' norm (Guggenheimer, Edelman and Johnson, 1995).
fn is_surely_well_conditioned(matrix: &DMatrix<f64>) -> bool {
    let n = matrix.nrows();
    if n > 3 || matrix.diagonal().iter().any(|entry| *entry == 0.0) {
        return false;
    }
    let scale = |i: usize| 1.0 / matrix[(i, i)].abs().sqrt();
    let entry = |i: usize, j: usize| scale(i) * matrix[(i, j)] * scale(j);
    let equilibrated = Matrix3::from_fn(|i, j| match (i < n, j < n) {
        (true, true) => entry(i, j),
        _ => f64::from(i == j),
    });
    let square: f64 = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(|at| equilibrated[at].powi(2)).sum();
    let bound = 2.0 / equilibrated.determinant().abs() * (square / n as f64).powf(n as f64 / 2.0);
    // Far below what is refused, so that rounding does not matter.
    bound < 1e-4 * MAX_CONDITION
}

/// How linear equations are solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinearSolver {
    /// Gaussian elimination with partial pivoting, after a check of the condition number: for real numbers.
    PartialPivoting,
    /// Cramer's rule, which looks at no values: for elements of a prime field.
    CramersRule,
}

/// The most unknowns that Cramer's rule is used for.
const MOST_BY_CRAMER: usize = 4;

/// Solves M x = b by Cramer's rule.
///
/// # Errors
/// When there are more than [`MOST_BY_CRAMER`] unknowns.
fn cramer<D: Number>(what: &str, matrix: &DMatrix<D>, right: &[D]) -> Result<Vec<D>> {
    let n = right.len();
    if n > MOST_BY_CRAMER {
        return Err(Error::new(format!(
            "the {what} has {n} rows, and exact arithmetic solves at most {MOST_BY_CRAMER}"
        )));
    }
    let determinant = determinant(matrix);
    let with_column = |j: usize| DMatrix::from_fn(n, n, |i, k| if k == j { right[i] } else { matrix[(i, k)] });
    Ok(up_to(n, &mut |j| self::determinant(&with_column(j)) / determinant))
}

/// By Laplace's expansion along the first row.
fn determinant<D: Number>(matrix: &DMatrix<D>) -> D {
    if matrix.nrows() == 0 {
        return D::one();
    }
    let below = matrix.clone().remove_row(0);
    let cofactor =
        |j: usize| determinant(&below.clone().remove_column(j)) * if j.is_multiple_of(2) { 1.0 } else { -1.0 };
    let mut sum = D::zero();
    for j in 0..matrix.ncols() {
        sum += matrix[(0, j)] * cofactor(j);
    }
    sum
}

/// Solves M x = b in the given way.
///
/// # Errors
/// As [`solve`] or [`cramer`].
pub(crate) fn solve_with<D: Number>(
    solver: LinearSolver,
    what: &str,
    matrix: DMatrix<D>,
    right: Vec<D>,
) -> Result<Vec<D>> {
    match solver {
        LinearSolver::PartialPivoting => solve(what, matrix, right),
        LinearSolver::CramersRule => cramer(what, &matrix, &right),
    }
}

/// Solves M x = b. `row(i, j)` are the entries of M.
///
/// # Errors
/// When M is singular, ill-conditioned or not finite; the message has the condition number.
pub(crate) fn solve<D: Number>(what: &str, matrix: DMatrix<D>, right: Vec<D>) -> Result<Vec<D>> {
    let values = matrix.map(|entry| entry.re());
    if is_surely_well_conditioned(&values) {
        return eliminate(what, matrix, right);
    }
    let condition = condition_number(&values);
    if condition.is_nan() || condition > MAX_CONDITION {
        return Err(refused(what, condition));
    }
    eliminate(what, matrix, right).map_err(|_| refused(what, condition))
}

/// Solves M x = b, where it is known that M is no worse than [`solve`] allows.
///
/// # Errors
/// When M is singular.
pub(crate) fn eliminate<D: Number>(what: &str, matrix: DMatrix<D>, right: Vec<D>) -> Result<Vec<D>> {
    let solution =
        LU::<D, Dyn>::new(matrix).map_err(|_| refused(what, f64::INFINITY))?.solve(&DVector::from_vec(right));
    Ok(solution.as_slice().to_vec())
}

fn refused(what: &str, condition: f64) -> Error {
    let is_outside = condition.is_nan();
    let message = if is_outside {
        format!("the {what} is not finite at this state")
    } else if condition.is_finite() {
        format!(
            "the {what} is nearly singular at this state: its condition number is {condition:.1e}, and at most \
             {MAX_CONDITION:.0e} is allowed"
        )
    } else {
        format!("the {what} is singular (condition number ∞), so the accelerations have no value at this state")
    };
    let error = Error::new(message).help(
        "check that L depends on every velocity; if only the coordinates are singular here, as Euler angles are where \
         sin θ = 0, keep this place out of the ranges, or choose other values",
    );
    // L may have no value here, as that of a particle faster than light.
    if is_outside { error.with_code(Code::NoState) } else { error }
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
    fn the_bound_is_above_the_condition_number() {
        let matrix =
            |n: usize, off: f64| DMatrix::from_fn(n, n, |i, j| if i == j { 2.0 } else { off / (1 + i + j) as f64 });
        for n in 1..=3 {
            for off in [0.0, 1.0, 3.0, -2.5, 5.9] {
                let matrix = matrix(n, off);
                assert!(is_surely_well_conditioned(&matrix) && condition_number(&matrix) < 1e-4 * MAX_CONDITION);
            }
        }
        // must-fail cases: singular, or nearly, or of no size
        for off in [4.0, 4.0 + 1e-9, f64::NAN, f64::INFINITY] {
            assert!(!is_surely_well_conditioned(&matrix(2, off)));
        }
        assert!(!is_surely_well_conditioned(&dmatrix![1.0, 2.0; 2.0, 0.0]));
    }

    #[test]
    fn cramers_rule_agrees_with_elimination() {
        let matrix = |n: usize| DMatrix::from_fn(n, n, |i, j| if i == j { 3.0 } else { 1.0 / (1 + i + 2 * j) as f64 });
        for n in 1..=MOST_BY_CRAMER {
            let right: Vec<f64> = (0..n).map(|i| 1.0 - i as f64).collect();
            let [pivots, cramer] = [LinearSolver::PartialPivoting, LinearSolver::CramersRule]
                .map(|way| DVector::from_vec(solve_with(way, "matrix", matrix(n), right.clone()).unwrap()));
            assert_relative_eq!(pivots, cramer, epsilon = 1e-13);
            approx::assert_relative_ne!(pivots, -cramer, epsilon = 1e-3);
        }
        assert!(solve_with(LinearSolver::CramersRule, "matrix", matrix(5), vec![1.0; 5]).is_err());
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
