//! The two sides of an equation that is wrong, against one of its variables.

use super::figure::{Curve, Figure};
use crate::Result;

/// The two sides as SVG. `variable` is the name of the axis; `left` and `right` are points, `at` is the counterexample.
///
/// # Errors
/// When there is nothing finite to draw.
pub fn two_sides(variable: &str, left: Vec<(f64, f64)>, right: Vec<(f64, f64)>, at: [(f64, f64); 2]) -> Result<String> {
    let curve = |name: &str, look: usize, points: Vec<(f64, f64)>| Curve { name: name.to_owned(), look, points };
    Figure {
        title: format!("Both sides against {variable}"),
        axes: [variable.to_owned(), "value of the side".to_owned()],
        curves: vec![curve("left side", 0, left), curve("right side", 1, right)],
        marks: at.to_vec(),
        is_square: false,
    }
    .svg()
}
