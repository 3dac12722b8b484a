//! What is known of the dimensions of symbols, and what follows from it.
//!
//! Every demand ("the terms of this sum agree") is one linear equation between exponents, with the same rational
//! coefficients for each base unit. So the dimensions nobody declared are found by elimination, and a demand that
//! contradicts the earlier ones is found at once.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::formula::SymbolId;

use super::{Dimension, Ratio, raised};

/// A known dimension times powers of the unknown dimensions of symbols.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Affine {
    /// What is known.
    pub known: Dimension,
    /// The unknown factors; no exponent is 0.
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

    /// That of a product.
    pub fn times(mut self, other: &Affine) -> Affine {
        self.known = self.known.times(other.known);
        for (&symbol, &exponent) in &other.unknown {
            let own = self.unknown.entry(symbol).or_insert(Ratio::ZERO);
            *own = *own + exponent;
        }
        self.unknown.retain(|_, exponent| !exponent.is_zero());
        self
    }

    /// That of a power.
    pub fn power(mut self, exponent: Ratio) -> Affine {
        self.known = self.known.power(exponent);
        self.unknown.values_mut().for_each(|own| *own = *own * exponent);
        self.unknown.retain(|_, exponent| !exponent.is_zero());
        self
    }

    /// That of a quotient.
    pub fn over(self, other: &Affine) -> Affine {
        self.times(&other.clone().power(Ratio::whole(-1)))
    }

    /// The dimension, if all of it is known.
    pub fn as_known(&self) -> Option<Dimension> {
        self.unknown.is_empty().then_some(self.known)
    }

    /// The symbols whose dimensions are unknown, with their exponents.
    pub fn unknowns(&self) -> impl Iterator<Item = (SymbolId, Ratio)> {
        self.unknown.iter().map(|(symbol, exponent)| (*symbol, *exponent))
    }

    /// Whether an exponent of it left the numbers that are computed with.
    fn is_lost(&self) -> bool {
        self.known.0.iter().chain(self.unknown.values()).any(|exponent| exponent.is_lost())
    }

    /// In words: `kg m²`, `m [x]²` with the dimension of x unknown, `dimensionless`.
    pub fn show(&self, name: impl Fn(SymbolId) -> String) -> String {
        let unknown = self.unknown.iter().map(|(symbol, exponent)| format!("[{}]{}", name(*symbol), raised(*exponent)));
        let mut factors: Vec<String> = unknown.collect();
        if !self.known.is_none() {
            factors.insert(0, self.known.to_string());
        }
        if factors.is_empty() { "dimensionless".to_owned() } else { factors.join(" ") }
    }
}

/// Two dimensions that were demanded to be equal and are not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// The first, as far as it is known.
    pub first: Affine,
    /// The second.
    pub second: Affine,
    /// Where what is known of them was inferred: the [`Inference::origin`] of every demand used.
    pub origins: BTreeSet<usize>,
}

impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |symbol: SymbolId| format!("symbol {}", symbol.0);
        write!(f, "{} is not {}", self.first.show(name), self.second.show(name))
    }
}

/// A symbol's dimension in terms of those still unknown, and the demands that it follows from.
#[derive(Clone, Debug)]
struct Row {
    value: Affine,
    origins: BTreeSet<usize>,
}

/// All that is known, in reduced form: no solved symbol occurs in the value of another.
#[derive(Clone, Debug, Default)]
pub struct Inference {
    solved: BTreeMap<SymbolId, Row>,
    /// What the next demands are to be known by, in a [`Conflict`]; `None` for what was declared.
    pub origin: Option<usize>,
}

impl Inference {
    /// Demands that two dimensions are one.
    ///
    /// # Errors
    /// When what is known contradicts it; the inference then stays as it was.
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

    /// A dimension with all that is known put in, and the origins of what was.
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

    /// Whether two dimensions may be one, for all that is known.
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
