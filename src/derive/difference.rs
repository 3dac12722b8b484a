//! What remains of one formula without the other.

use num_traits::One;

use super::Letter;
use super::algebra::Algebra;
use super::print::Printer;
use super::rational::Exact;
use crate::Result;
use crate::formula::Expr;
use crate::scalar::{Graph, Symbol};

/// The normal form of `printed` − `derived`: two nodes of one recording, whose n-th input is the n-th letter.
///
/// The difference of two that are equal as polynomials in sines, cosines and roots is 0.
///
/// ```
/// use onshell::derive::{Class, Letter, difference};
/// use onshell::formula::{Symbols, text};
/// use onshell::latex::{Macros, read_formula};
/// use onshell::scalar::{DualNum, Graph, Symbol};
///
/// let mut symbols = Symbols::open();
/// let mut letter = |latex: &str, class| {
///     read_formula(latex, &mut symbols, &Macros::default()).map(|expr| Letter { expr, class })
/// };
/// let letters = [letter("M", Class::Parameter), letter("\\theta", Class::Coordinate)].map(Result::unwrap);
/// let (graph, (printed, derived)) = Graph::record(|| {
///     let (mass, theta) = (Symbol::input(0), Symbol::input(1));
///     (mass * theta.sin(), -mass * theta.sin())
/// })?;
/// let left = difference(&graph, printed, derived, &letters)?;
/// assert_eq!(text::formula(&left, &symbols), "2·M·sin(θ)");
/// # Ok::<(), onshell::Error>(())
/// ```
///
/// # Errors
/// When the difference is too long, has a number without an exact value, or a function without a name in print.
pub fn difference(graph: &Graph, printed: Symbol, derived: Symbol, letters: &[Letter]) -> Result<Expr> {
    let mut algebra = Algebra::of_inputs(letters.len());
    let sides = algebra.normal(graph, &[printed, derived])?;
    let rest = algebra.plus(&sides[0], &sides[1], -Exact::one())?;
    let rest = algebra.presented(&rest)?;
    Printer { algebra: &algebra, letters }.sum(&[rest])
}
