//! Printed equations beside the derived ones.
//!
//! A printed equation is read with the names of the derivation, and valued at states on shell, as the lines of a lecture
//! are. Names that the notes define stand for their formulas. So its terms can be lined up with the derived ones
//! ([`Lineup`]), and its two sides drawn ([`Sides`]). What cannot be read so has neither. No verdict depends on it: it
//! only explains.
//!
//! Offers [`Beside`] and [`Sides`]. Knows `derive`, `latex`, `formula` and `mechanics`.

mod defined;
mod lineup;
mod sides;
mod terms;

pub use sides::Sides;

use std::sync::Arc;

use super::sample::Sample;
use crate::Result;
use crate::derive::Derivation;
use crate::formula::{Expr, Relation, Symbols};
use crate::latex::{Macros, read_display};
use crate::mechanics::System;
use defined::Defined;

/// A system with the states at which printed equations are valued.
pub struct Beside {
    system: Arc<System>,
    derivation: Derivation,
    samples: Vec<Sample>,
}

/// Two members of a chain of equations, read with these symbols.
struct Pair {
    left: Expr,
    right: Expr,
    symbols: Symbols,
    defined: Defined,
}

impl Beside {
    /// The states of a system.
    ///
    /// # Errors
    /// When its mass matrix is singular at a state.
    pub fn new(system: Arc<System>, derivation: Derivation) -> Result<Beside> {
        let samples = (1..=4).map(|seed| Sample::draw(&system, seed)).collect::<Result<_>>()?;
        Ok(Beside { system, derivation, samples })
    }

    /// The pairs of members of a display that say that they are equal.
    fn pairs(&self, latex: &str, macros: &Macros, definitions: &[String]) -> Vec<Pair> {
        let mut symbols = self.derivation.symbols().clone();
        let defined = Defined::read(definitions, &mut symbols, macros);
        let reading = read_display(latex, &mut symbols, macros);
        let mut pairs = Vec::new();
        for statement in reading.statements.into_iter().flatten() {
            let is_equality =
                |at: usize| statement.relations.get(at).is_some_and(|(relation, _)| *relation == Relation::Equal);
            for (at, members) in statement.members.windows(2).enumerate().filter(|(at, _)| is_equality(*at)) {
                // A row that goes on with a chain is about the first member of the chain.
                let left = if at == 0 { &members[0] } else { &statement.members[0] };
                let (symbols, defined) = (symbols.clone(), defined.clone());
                pairs.push(Pair { left: left.clone(), right: members[1].clone(), symbols, defined });
            }
        }
        pairs
    }

    /// The value of a formula at each state; `None` if it has none at one of them.
    fn values(&self, symbols: &Symbols, formula: &Expr) -> Option<Vec<f64>> {
        self.samples.iter().map(|sample| sample.value_in(&self.derivation, symbols, formula)).collect()
    }
}

/// Whether two numbers agree up to rounding.
fn agree(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1e-6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::systems::Registry;

    fn beside(name: &str) -> Beside {
        let lagrangian = Registry::standard();
        let lagrangian = lagrangian.get(name).unwrap();
        Beside::new(Arc::new(lagrangian.trace().unwrap()), Derivation::of(lagrangian).unwrap()).unwrap()
    }

    #[test]
    fn each_term_of_a_correct_equation_has_its_derived_term() {
        let top = beside("heavy_top");
        for latex in [
            r"\lambda_1\ddot\theta = \lambda_1\dot\phi^2 \sin\theta\cos\theta - \dot\phi \sin\theta \, p_\psi + MgR\sin\theta",
            r"L = \frac12\left(\lambda_1(\dot\theta^2+(\dot\phi\sin\theta)^2)+\lambda_3(\dot\psi+\dot\phi\cos\theta)^2\right)-MgR\cos\theta",
            r"p_\phi = \lambda_1 \dot\phi \sin^2\theta + \cos\theta \, p_\psi",
        ] {
            let found = top.lineup(latex, &Macros::default(), &[]).unwrap_or_else(|| panic!("{latex}"));
            assert!(found.rows.len() > 1 && found.is_the_same(), "{latex}: {found:?}");
        }
    }

    #[test]
    fn a_term_that_differs_has_its_factor_and_one_that_lacks_is_named() {
        let top = beside("heavy_top");
        let rows = |latex: &str| top.lineup(latex, &Macros::default(), &[]).unwrap().rows;
        let found =
            rows(r"\lambda_1\ddot\theta = 2\lambda_1\dot\phi^2 \sin\theta\cos\theta + \dot\phi \sin\theta \, p_\psi");
        let factors: Vec<&str> = found.iter().filter_map(|row| row.factor.as_deref()).collect();
        assert_eq!(factors, ["2", "-1"], "{found:?}");
        let missing: Vec<&str> =
            found.iter().filter(|row| row.printed.is_none()).filter_map(|row| row.derived.as_deref()).collect();
        assert_eq!(missing.len(), 1, "{found:?}");
        assert!(missing[0].contains("M") && missing[0].contains(r"\sin"), "{missing:?}");
        let beside_it = rows(
            r"\lambda_1\ddot\theta = \lambda_1\dot\phi^2 \sin\theta\cos\theta - \dot\phi \sin\theta \, p_\psi + MgR^2\sin\theta",
        );
        assert!(beside_it.iter().any(|row| row.derived.is_none()), "{beside_it:?}");
        // what is about another quantity, or has other names, is not lined up
        for latex in [r"\theta = 1", r"Q = MgR", r"\lambda_1\ddot\theta = M + g"] {
            let found = top.lineup(latex, &Macros::default(), &[]);
            assert!(found.is_none_or(|found| !found.is_the_same()), "{latex}");
        }
    }

    #[test]
    fn names_that_the_notes_define_stand_for_their_formulas() {
        let top = beside("heavy_top");
        let definitions =
            [r"b = k R", r"k = M g", r"\Omega = \dot\phi", r"\omega_3 = \frac{p_\psi}{\lambda_3}"].map(str::to_owned);
        let right = r"\lambda_1\ddot\theta = \lambda_1\Omega^2 \sin\theta\cos\theta - \lambda_3 \omega_3 \Omega \sin\theta + b\sin\theta";
        let wrong = right.replace("+ b", "- b");
        let rows = |latex: &str| top.lineup(latex, &Macros::default(), &definitions);
        assert!(rows(right).unwrap().is_the_same());
        let found = rows(&wrong).unwrap();
        let different: Vec<_> = found.rows.iter().filter(|row| row.factor.is_some()).collect();
        assert_eq!(different.len(), 1, "{found:?}");
        assert_eq!(different[0].factor.as_deref(), Some("-1"));
        assert!(different[0].printed.as_deref().is_some_and(|term| term.contains('b')), "{found:?}");
        // The twin: without the definitions the names have no value.
        assert!(top.lineup(right, &Macros::default(), &[]).is_none());
        let sides = |definitions: &[String]| top.sides(&wrong, &Macros::default(), definitions);
        assert!(sides(&definitions).is_some() && sides(&[]).is_none());
        // What a name stands for moves the sides: b is no variable of its own.
        let numbers = [("M", 2.0), ("g", 3.0)].map(|(name, value)| (name.to_owned(), value));
        let mass = ["b = M g".to_owned()];
        let macros = Macros::default();
        let found = Sides::of_counterexample("b = M", (&macros, &mass), &numbers, (6.0, 2.0)).unwrap();
        assert!(["M", "g"].contains(&found.variable.as_str()), "{}", found.variable);
    }

    #[test]
    fn the_sides_are_drawn_against_what_separates_them_and_not_where_they_agree() {
        let pendulum = beside("simple_pendulum");
        // the two sides agree where θ does, as cos θ and 1 − θ²/2 do
        let found =
            pendulum.sides(r"L = \frac12 m l^2 \dot\theta^2 + 2 m g l \cos\theta", &Macros::default(), &[]).unwrap();
        let (at, right) = (found.at, &found.right);
        assert!((at[0].1 - at[1].1).abs() > 1e-3);
        for ((x, left), (y, right)) in found.left.iter().zip(right) {
            assert!(x == y && left.is_finite() && right.is_finite());
        }
        assert!(
            pendulum.sides(r"L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta", &Macros::default(), &[]).is_none()
        );
    }
}
