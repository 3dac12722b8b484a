//! The difference of two formulas in normal form, and the two sides of an equation of motion.

use num_traits::One;

use super::algebra::{Algebra, Fraction};
use super::polynomial::{Monomial, Polynomial};
use super::print::Printer;
use super::rational::Exact;
use super::{Class, Letter};
use crate::formula::Expr;
use crate::scalar::{Graph, Node, Symbol};
use crate::{Error, Result};

/// The normal form of `printed` − `derived`: two nodes of one recording, whose n-th input is the n-th letter.
///
/// It is 0 for two formulas that are equal as polynomials in sines, cosines and roots.
///
/// # Errors
/// When the difference is too long, or contains a number without an exact value or a function that cannot be typeset.
pub fn difference(graph: &Graph, printed: Symbol, derived: Symbol, letters: &[Letter]) -> Result<Expr> {
    named(graph, &[printed, derived], letters)?;
    let mut algebra = Algebra::of_inputs(letters.len()).bounded(WORK);
    let sides = algebra.normal(graph, &[printed, derived])?;
    let rest = algebra.plus(&sides[0], &sides[1], -Exact::one())?;
    let rest = algebra.presented(&rest)?;
    if algebra.written(&rest) > LONGEST {
        return Err(Error::new("the difference is too long to be written").help("compare shorter formulas"));
    }
    Printer { algebra: &algebra, letters }.sum(&[rest])
}

/// The largest number of atoms in a difference that is written out.
const LONGEST: usize = 20_000;

/// The limit of work: the explanation of a refuted equation must not cost more than its refutation.
const WORK: usize = 20_000;

/// Whether every input that some nodes depend on has a name.
fn named(graph: &Graph, outputs: &[Symbol], letters: &[Letter]) -> Result<()> {
    let nodes = graph.nodes();
    let mut waiting: Vec<u32> = outputs.iter().map(|output| output.place()).collect();
    let mut seen = vec![false; nodes.len()];
    while let Some(place) = waiting.pop() {
        if std::mem::replace(&mut seen[place as usize], true) {
            continue;
        }
        match nodes[place as usize] {
            Node::Input(n) if n as usize >= letters.len() => {
                return Err(Error::new(format!("input {n} of the recorded function has no letter"))
                    .help("give one letter for each input"));
            }
            node => waiting.extend(node.operands()),
        }
    }
    Ok(())
}

/// The two sides of the equation `residual` = 0, with the accelerations on the left. `residual` is a node of a recording
/// whose n-th input is the n-th letter.
///
/// # Errors
/// As [`difference`].
pub fn equation_of_motion(graph: &Graph, residual: Symbol, letters: &[Letter]) -> Result<(Expr, Expr)> {
    named(graph, &[residual], letters)?;
    let mut algebra = Algebra::of_inputs(letters.len()).bounded(WORK);
    let residual = algebra.normal(graph, &[residual])?.remove(0);
    let residual = algebra.presented(&residual)?;
    let accelerations = letters.iter().enumerate().filter(|(_, letter)| letter.class == Class::Acceleration);
    let accelerations: Vec<u32> = accelerations.map(|(n, _)| algebra.input_place(n)).collect();
    let (left, right) = algebra.balanced(residual, &accelerations)?;
    let printer = Printer { algebra: &algebra, letters };
    Ok((printer.sum(&[left])?, printer.sum(&[right])?))
}

impl Algebra {
    /// The terms of a vanishing residual with accelerations, and the negative of the others. An exponential that all
    /// terms share is divided out, since it is never 0.
    pub(super) fn balanced(&mut self, mut residual: Fraction, accelerations: &[u32]) -> Result<(Fraction, Fraction)> {
        let shared = self.shared_exponential(&residual.top);
        residual.top = residual.top.scaled(&shared.power(-1), Exact::one())?;
        let moves = |monomial: &Monomial| accelerations.iter().any(|&a| monomial.exponent(a) != 0);
        let side = |top: Polynomial| Fraction { top, under: residual.under.clone() };
        let left = self.presented(&side(residual.top.part(moves)))?;
        let rest = Polynomial::default().minus(&residual.top.part(|monomial| !moves(monomial)))?;
        Ok((left, self.presented(&side(rest))?))
    }
}

#[cfg(test)]
mod tests {
    use crate::derive::{Class, Letter, difference};
    use crate::formula::{Symbols, text};
    use crate::latex::{Macros, read_formula};
    use crate::scalar::{DualNum, Graph, Symbol};

    #[test]
    fn a_flipped_sign_is_twice_the_term() {
        let mut symbols = Symbols::open();
        let mut letter = |latex: &str, class| {
            read_formula(latex, &mut symbols, &Macros::default()).map(|expr| Letter { expr, class })
        };
        let letters = [letter("M", Class::Parameter), letter("\\theta", Class::Coordinate)].map(Result::unwrap);
        let recorded = Graph::record(|| {
            let (mass, theta) = (Symbol::input(0), Symbol::input(1));
            (mass * theta.sin(), -mass * theta.sin())
        });
        let (graph, (printed, derived)) = recorded.expect("no branch");
        let left = difference(&graph, printed, derived, &letters).expect("a short difference");
        assert_eq!(text::formula(&left, &symbols), "2·M·sin(θ)");
        let none = difference(&graph, printed, printed, &letters).expect("a short difference");
        assert_eq!(text::formula(&none, &symbols), "0");
    }
}
