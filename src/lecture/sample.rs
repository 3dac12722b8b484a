//! The sampled state of a lecture: drawn from a seed with two decimals, on shell.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::Result;
use crate::derive::Derivation;
use crate::formula::{Assignment, Expr, Node, SymbolId, Symbols, Value, evaluate, text};
use crate::latex::names;
use crate::mechanics::System;
use crate::scalar::Series;

/// A state on shell: coordinates, velocities and parameters that were drawn, and what follows from them.
#[derive(Clone, Debug)]
pub struct Sample {
    /// What was drawn, as names in plain text with values.
    pub drawn: Vec<(String, f64)>,
    pub(super) time: f64,
    coordinates: Vec<(String, [f64; 3], [f64; 2])>,
    parameters: Vec<(String, f64)>,
    /// L, E and H.
    functions: [f64; 3],
}

impl Sample {
    /// Draws a state.
    ///
    /// # Errors
    /// When the mass matrix is singular there.
    pub fn draw(system: &System, seed: u64) -> Result<Sample> {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut draw = |low: f64, high: f64| {
            let share = (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
            ((low + (high - low) * share) * 100.0).round() / 100.0
        };
        let q: Vec<f64> = system.coordinates().iter().map(|_| draw(0.3, 1.3)).collect();
        let v: Vec<f64> = system.coordinates().iter().map(|_| draw(0.1, 0.7)).collect();
        let parameters: Vec<f64> = system.parameters().iter().map(|_| draw(0.8, 2.0)).collect();
        let time = if system.depends_on_time() { draw(0.1, 0.9) } else { 0.0 };
        Sample::at(system, time, [q, v, parameters])
    }

    /// The state with these coordinates, velocities and parameters.
    ///
    /// # Errors
    /// When the mass matrix is singular there.
    pub(super) fn at(system: &System, time: f64, [q, v, parameters]: [Vec<f64>; 3]) -> Result<Sample> {
        let a = system.accelerations(time, &q, &v, &parameters)?;
        let there = system.quantities(time, &q, &v, &parameters);
        let name = |latex: &String, dots: u8| text::plain(&text::with_dots(latex, dots));
        let mut drawn: Vec<(String, f64)> = Vec::new();
        for (i, latex) in system.coordinates().iter().enumerate() {
            drawn.push((name(latex, 0), q[i]));
            drawn.push((name(latex, 1), v[i]));
        }
        drawn.extend(system.parameters().iter().zip(&parameters).map(|(latex, &value)| (name(latex, 0), value)));
        if system.depends_on_time() {
            drawn.push(("t".to_owned(), time));
        }
        let coordinate =
            |(i, latex): (usize, &String)| (latex.clone(), [q[i], v[i], a[i]], [there.momenta[i], there.forces[i]]);
        let coordinates = system.coordinates().iter().enumerate().map(coordinate).collect();
        let parameters = system.parameters().iter().cloned().zip(parameters).collect();
        let functions = [there.lagrangian, there.energy, there.energy];
        Ok(Sample { drawn, time, coordinates, parameters, functions })
    }

    /// The value of a derived formula at the state; `None` where it has none.
    pub fn value(&self, derivation: &Derivation, formula: &Expr) -> Option<f64> {
        self.value_in(derivation, derivation.symbols(), formula)
    }

    /// The value of a formula that was read with these symbols, which begin with those of the derivation.
    pub(super) fn value_in(&self, derivation: &Derivation, symbols: &Symbols, formula: &Expr) -> Option<f64> {
        let id = |latex: &str| -> Option<SymbolId> {
            let (name, _) = names::parse(latex)?;
            symbols.find(&name).map(|(id, _)| id)
        };
        let mut known: Assignment<'_, f64> = Assignment::new(symbols);
        known.set(id("t")?, 0, self.time);
        for (latex, motion, momentum) in &self.coordinates {
            let (coordinate, conjugate) = (id(latex)?, id(&format!("p_{{{latex}}}"))?);
            motion.iter().zip(0..).for_each(|(value, order)| known.set(coordinate, order, *value));
            momentum.iter().zip(0..).for_each(|(value, order)| known.set(conjugate, order, *value));
        }
        for (latex, value) in &self.parameters {
            known.set(id(latex)?, 0, *value);
        }
        for (function, value) in derivation.functions().iter().zip(self.functions) {
            if let Node::Symbol { id, .. } = &function.node {
                known.set(*id, 0, value);
            }
        }
        let value: Value<Series<f64>> = evaluate(formula, &known, &[]).ok()?;
        match value {
            Value::Scalar(value) => Some(value.value()).filter(|value| value.is_finite()),
            _ => None,
        }
    }

    /// Coordinates, velocities and parameters.
    pub(super) fn numbers(&self) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let of = |order: usize| self.coordinates.iter().map(|(_, motion, _)| motion[order]).collect();
        (of(0), of(1), self.parameters.iter().map(|(_, value)| *value).collect())
    }
}
