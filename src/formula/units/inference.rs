//! The inference of dimensions: those that are declared, and those that follow from the equations.
//!
//! Every requirement ("the terms of this sum have one dimension") is a linear equation between exponents, with the
//! same rational coefficients for each base unit. Undeclared dimensions are found by elimination. A requirement
//! that contradicts earlier ones is found at once.
//!
//! # How units are solved
//!
//! Each demand (the terms of a sum agree, the argument of a sine is dimensionless) is a linear equation between
//! exponents of units with rational coefficients. Elimination finds the dimensions that nobody declared, and each
//! result knows the equations from which it follows. A dimension is seven rational exponents at run time. Crates
//! that make units Rust types need them at compile time, and notes are read later.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::formula::SymbolId;

use super::{Dimension, Ratio, raised};

/// A known dimension times powers of unknown dimensions of symbols.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Affine {
    /// The known factor.
    pub known: Dimension,
    /// The exponents of the unknown dimensions; none is 0.
    unknown: BTreeMap<SymbolId, Ratio>,
}

impl Affine {
    /// A dimension that is known.
    pub fn known(known: Dimension) -> Affine {
        Affine { known, unknown: BTreeMap::new() }
    }

    /// The dimension of a symbol.
    pub fn of(symbol: SymbolId) -> Affine {
        Affine { known: Dimension::NONE, unknown: BTreeMap::from([(symbol, Ratio::ONE)]) }
    }

    /// The dimension of a product.
    pub fn times(mut self, other: &Affine) -> Affine {
        self.known = self.known.times(other.known);
        for (&symbol, &exponent) in &other.unknown {
            let own = self.unknown.entry(symbol).or_insert(Ratio::ZERO);
            *own = *own + exponent;
        }
        self.unknown.retain(|_, exponent| !exponent.is_zero());
        self
    }

    /// The dimension of a power.
    pub fn power(mut self, exponent: Ratio) -> Affine {
        self.known = self.known.power(exponent);
        self.unknown.values_mut().for_each(|own| *own = *own * exponent);
        self.unknown.retain(|_, exponent| !exponent.is_zero());
        self
    }

    /// The dimension of a quotient.
    pub fn over(self, other: &Affine) -> Affine {
        self.times(&other.clone().power(Ratio::whole(-1)))
    }

    /// The dimension, if it has no unknown factor.
    pub fn as_known(&self) -> Option<Dimension> {
        self.unknown.is_empty().then_some(self.known)
    }

    /// The symbols whose dimensions are unknown, with their exponents.
    pub fn unknowns(&self) -> impl Iterator<Item = (SymbolId, Ratio)> {
        self.unknown.iter().map(|(symbol, exponent)| (*symbol, *exponent))
    }

    /// Whether an exponent overflowed ([`Ratio::LOST`]).
    fn is_lost(&self) -> bool {
        self.known.0.iter().chain(self.unknown.values()).any(|exponent| exponent.is_lost())
    }

    /// The dimension as text: `kg m²`; `m [x]²` with the unknown dimension of x; `dimensionless`.
    pub fn show(&self, name: impl Fn(SymbolId) -> String) -> String {
        let unknown = self.unknown.iter().map(|(symbol, exponent)| format!("[{}]{}", name(*symbol), raised(*exponent)));
        let mut factors: Vec<String> = unknown.collect();
        if !self.known.is_none() {
            factors.insert(0, self.known.to_string());
        }
        if factors.is_empty() { "dimensionless".to_owned() } else { factors.join(" ") }
    }
}

/// Two dimensions that are required to be equal and differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// The first dimension, with all known dimensions inserted.
    pub first: Affine,
    /// The second dimension.
    pub second: Affine,
    /// The [`Inference::origin`] of every requirement that the two dimensions were inferred from.
    pub origins: BTreeSet<usize>,
}

impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |symbol: SymbolId| format!("symbol {}", symbol.0);
        write!(f, "{} is not {}", self.first.show(name), self.second.show(name))
    }
}

/// The dimension of a symbol in terms of unknown ones, and the origins of the requirements that it follows from.
#[derive(Clone, Debug)]
struct Row {
    value: Affine,
    origins: BTreeSet<usize>,
}

/// The solved dimensions in reduced form: no solved symbol occurs in the value of another.
#[derive(Clone, Debug, Default)]
pub struct Inference {
    solved: BTreeMap<SymbolId, Row>,
    /// The origin of the next requirements, which a [`Conflict`] reports; `None` for declarations.
    pub origin: Option<usize>,
}

impl Inference {
    /// Requires that two dimensions are equal.
    ///
    /// # Errors
    /// A conflict with earlier requirements; nothing is then changed.
    pub fn require_equal(&mut self, a: &Affine, b: &Affine) -> Result<(), Box<Conflict>> {
        let (first, mut origins) = self.reduce(a);
        let (second, others) = self.reduce(b);
        origins.extend(others);
        let difference = first.clone().over(&second);
        if difference.is_lost() {
            return Ok(());
        }
        let Some((pivot, exponent)) = difference.unknown.last_key_value().map(|(symbol, k)| (*symbol, *k)) else {
            return if difference.known.is_none() {
                Ok(())
            } else {
                Err(Box::new(Conflict { first, second, origins }))
            };
        };
        let mut rest = difference;
        rest.unknown.remove(&pivot);
        let value = rest.power(-exponent.inverse());
        if value.is_lost() {
            return Ok(());
        }
        origins.extend(self.origin);
        let row = Row { value, origins };
        for other in self.solved.values_mut() {
            if other.value.unknown.contains_key(&pivot) {
                *other = substituted(other, pivot, &row);
            }
        }
        self.solved.insert(pivot, row);
        Ok(())
    }

    /// A dimension with all known dimensions inserted, and the origins of those.
    pub fn reduce(&self, a: &Affine) -> (Affine, BTreeSet<usize>) {
        let mut value = Affine::known(a.known);
        let mut origins = BTreeSet::new();
        for (symbol, exponent) in a.unknowns() {
            match self.solved.get(&symbol) {
                Some(row) => {
                    value = value.times(&row.value.clone().power(exponent));
                    origins.extend(&row.origins);
                }
                None => value = value.times(&Affine::of(symbol).power(exponent)),
            }
        }
        (value, origins)
    }

    /// The number of independent requirements so far.
    pub fn requirements(&self) -> usize {
        self.solved.len()
    }

    /// Whether a symbol must be a pure number.
    pub fn is_pure_number(&self, symbol: SymbolId) -> bool {
        self.reduce(&Affine::of(symbol)).0.as_known().is_some_and(|known| known.is_none())
    }

    /// Whether two dimensions may be equal, given the known dimensions.
    pub fn may_be_equal(&self, a: &Affine, b: &Affine) -> bool {
        let difference = self.reduce(a).0.over(&self.reduce(b).0);
        difference.is_lost() || difference.as_known().is_none_or(|known| known.is_none())
    }
}

fn substituted(row: &Row, pivot: SymbolId, by: &Row) -> Row {
    let mut value = row.value.clone();
    let exponent = value.unknown.remove(&pivot).unwrap_or(Ratio::ZERO);
    let origins = row.origins.union(&by.origins).copied().collect();
    Row { value: value.times(&by.value.clone().power(exponent)), origins }
}

#[cfg(test)]
mod tests {
    use super::{Affine, Dimension, Inference, Ratio};
    use crate::formula::SymbolId;

    const METRE: Dimension = Dimension::LENGTH;

    fn x(n: usize) -> Affine {
        Affine::of(SymbolId(n))
    }

    #[test]
    fn two_equations_settle_two_unknowns() {
        let mut inference = Inference::default();
        inference.require_equal(&x(0).times(&x(1)), &Affine::known(METRE)).unwrap();
        inference.require_equal(&x(0).over(&x(1)), &Affine::known(METRE.power(Ratio::whole(2)))).unwrap();
        assert_eq!(inference.reduce(&x(0)).0.as_known(), Some(METRE.power(Ratio::new(3, 2))));
        assert_eq!(inference.reduce(&x(1)).0.as_known(), Some(METRE.power(Ratio::new(-1, 2))));
    }

    #[test]
    fn a_contradiction_names_the_demands_it_stands_on_and_changes_nothing() {
        let mut inference = Inference::default();
        for (origin, (a, b)) in [(x(0), Affine::known(METRE)), (x(1), x(0)), (x(2), x(3))].iter().enumerate() {
            inference.origin = Some(origin);
            inference.require_equal(a, b).unwrap();
        }
        let conflict = inference.require_equal(&x(1), &Affine::known(Dimension::TIME)).unwrap_err();
        assert_eq!(conflict.origins.into_iter().collect::<Vec<_>>(), [0, 1]);
        assert_eq!(conflict.first.as_known(), Some(METRE));
        assert!(
            inference.may_be_equal(&x(1), &x(0)) && !inference.may_be_equal(&x(1), &Affine::known(Dimension::TIME))
        );
        // What does not follow from the others stays free.
        assert!(inference.require_equal(&x(3), &Affine::known(Dimension::TIME)).is_ok());
        assert_eq!(inference.reduce(&x(2)).0.as_known(), Some(Dimension::TIME));
    }
}
