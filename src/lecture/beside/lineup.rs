//! A printed equation and the derived one, term by term.
//!
//! Terms correspond if they have the same value at every state. A term that has no partner is multiplied out, on either
//! side, until no more terms find theirs. Then two terms whose ratio is the same simple fraction at every state differ by
//! that factor.

use super::terms::{multiplied_out, terms};
use super::{Beside, Pair, agree};
use crate::derive::Quantity;
use crate::formula::{Expr, Symbols};
use crate::latex::{Macros, typeset};

/// A term of the printed equation with the derived term that corresponds to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The printed term as LaTeX; `None` for a derived term that is not printed.
    pub printed: Option<String>,
    /// The derived term; `None` for a printed term that is not derived.
    pub derived: Option<String>,
    /// The printed term divided by the derived one, if that is not 1.
    pub factor: Option<String>,
}

/// A printed equation and the derived one, term by term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lineup {
    /// The side that both equations have, as LaTeX.
    pub left: String,
    /// The terms of the other side.
    pub rows: Vec<Row>,
}

impl Lineup {
    /// Whether every term has its partner.
    pub fn is_the_same(&self) -> bool {
        self.rows.iter().all(|row| row.printed.is_some() && row.derived.is_some() && row.factor.is_none())
    }
}

/// A term with its values at the states.
struct Valued {
    expr: Expr,
    values: Vec<f64>,
}

/// The most terms of a side that is lined up.
const MOST: usize = 24;

impl Beside {
    /// A printed display beside the derived equation of the same quantity; `None` if there is none, or its names are others.
    /// `definitions` are equations that give names of the notes their formulas.
    pub fn lineup(&self, latex: &str, macros: &Macros, definitions: &[String]) -> Option<Lineup> {
        self.pairs(latex, macros, definitions).into_iter().find_map(|pair| self.lined_up(&pair))
    }

    fn lined_up(&self, pair: &Pair) -> Option<Lineup> {
        let plain = pair.defined.unfolded(&pair.left);
        let left = self.values(&pair.symbols, &plain)?;
        self.values(&pair.symbols, &pair.defined.unfolded(&pair.right))?;
        let derivation = &self.derivation;
        let quantities = [
            Quantity::EulerLagrange,
            Quantity::Accelerations,
            Quantity::Momenta,
            Quantity::Lagrangian,
            Quantity::Hamiltonian,
            Quantity::Energy,
        ];
        for quantity in quantities {
            for equation in derivation.equations(quantity).unwrap_or_default() {
                let symbols = derivation.symbols();
                let Some(other) = self.values(symbols, &equation.left) else { continue };
                let is_same = left.iter().zip(&other).all(|(a, b)| agree(*a, *b)) && left.iter().any(|x| *x != 0.0);
                // Two quantities may have one value; the letters tell them apart.
                let spelled = |expr: &Expr, symbols: &Symbols| {
                    let mut names: Vec<String> = Vec::new();
                    expr.symbols()
                        .into_iter()
                        .for_each(|(id, dots)| names.push(format!("{}{dots}", symbols.entry(id).name)));
                    names.sort();
                    names
                };
                if is_same && spelled(&plain, &pair.symbols) == spelled(&equation.left, symbols) {
                    let rows = self.rows(pair, (&equation.right, symbols))?;
                    return Some(Lineup { left: typeset(&pair.left, &pair.symbols), rows });
                }
            }
        }
        None
    }

    fn rows(&self, pair: &Pair, derived: (&Expr, &Symbols)) -> Option<Vec<Row>> {
        let printed = (&pair.right, &pair.symbols);
        // A printed term keeps its names; its values are those of what they stand for.
        let of_printed = |expr: &Expr| self.values(printed.1, &pair.defined.unfolded(expr));
        let valued = |formula: &Expr, values: &dyn Fn(&Expr) -> Option<Vec<f64>>| -> Option<Vec<Valued>> {
            terms(formula).into_iter().map(|expr| Some(Valued { values: values(&expr)?, expr })).collect()
        };
        let mut left = valued(printed.0, &of_printed)?;
        let mut right = valued(derived.0, &|expr| self.values(derived.1, expr))?;
        let spelled = |term: &Valued, symbols: &Symbols| typeset(&term.expr, symbols);
        let mut rows: Vec<Row> = Vec::new();
        loop {
            let partner = |term: &Valued| {
                right.iter().position(|other| term.values.iter().zip(&other.values).all(|(a, b)| agree(*a, *b)))
            };
            if let Some((at, other)) = left.iter().enumerate().find_map(|(at, term)| Some((at, partner(term)?))) {
                let (term, other) = (left.remove(at), right.remove(other));
                rows.push(Row {
                    printed: Some(spelled(&term, printed.1)),
                    derived: Some(spelled(&other, derived.1)),
                    factor: None,
                });
                continue;
            }
            if left.is_empty() || right.is_empty() || left.len() + right.len() > MOST {
                break;
            }
            // A term that differs by a factor only stays whole.
            let is_multiple =
                |term: &Valued, others: &[Valued]| others.iter().any(|other| factor(term, other).is_some());
            let opened = open(&mut left, |term| !is_multiple(term, &right), of_printed)
                || open(&mut right, |term| !is_multiple(term, &left), |expr| self.values(derived.1, expr));
            if !opened {
                break;
            }
        }
        for term in left {
            let found = right.iter().enumerate().find_map(|(at, other)| Some((at, factor(&term, other)?)));
            let (other, factor) = match found {
                Some((at, factor)) => (Some(right.remove(at)), Some(factor)),
                None => (None, None),
            };
            let derived = other.map(|other| spelled(&other, derived.1));
            rows.push(Row { printed: Some(spelled(&term, printed.1)), derived, factor });
        }
        let rest =
            right.iter().map(|term| Row { printed: None, derived: Some(spelled(term, derived.1)), factor: None });
        rows.extend(rest);
        Some(rows)
    }
}

/// Multiplies out the first term that allows it. Whether one did.
fn open(all: &mut Vec<Valued>, may: impl Fn(&Valued) -> bool, values: impl Fn(&Expr) -> Option<Vec<f64>>) -> bool {
    for at in 0..all.len() {
        if !may(&all[at]) {
            continue;
        }
        let Some(parts) = multiplied_out(&all[at].expr) else { continue };
        let parts: Option<Vec<Valued>> =
            parts.into_iter().map(|expr| Some(Valued { values: values(&expr)?, expr })).collect();
        if let Some(parts) = parts {
            all.splice(at..=at, parts);
            return true;
        }
    }
    false
}

/// The first term divided by the second, if that is one simple fraction at all states, and not 1.
fn factor(term: &Valued, other: &Valued) -> Option<String> {
    let ratio = term.values.first()? / other.values.first()?;
    let is_constant = term.values.iter().zip(&other.values).all(|(a, b)| agree(*a, ratio * b));
    if !is_constant || agree(ratio, 1.0) || !ratio.is_finite() || ratio == 0.0 {
        return None;
    }
    for below in 1..=12_u8 {
        let above = ratio * f64::from(below);
        if agree(above, above.round()) && above.abs() < 100.0 {
            let above = above.round();
            return Some(if below == 1 { format!("{above}") } else { format!("{above}/{below}") });
        }
    }
    None
}
