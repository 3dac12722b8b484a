//! The state from which a picture of a system begins.

use crate::formula::text::{plain, with_dots};
use crate::mechanics::System;
use crate::{Error, Result};

/// A state, and for how long it moves.
#[derive(Clone, Debug)]
pub struct Start {
    /// The coordinates.
    pub q: Vec<f64>,
    /// The velocities.
    pub v: Vec<f64>,
    /// The parameters.
    pub parameters: Vec<f64>,
    /// The time at which the motion ends.
    pub end: f64,
}

impl Start {
    /// A start for a system: its parameters 1, a body with a fast spin, lengths 1, angles 1/2, and cyclic coordinates
    /// that turn. `given` are names with values, of parameters, coordinates and their rates.
    ///
    /// # Errors
    /// For a name that the system does not have.
    pub fn of(system: &System, given: &[(String, f64)], end: f64) -> Result<Start> {
        let n = system.coordinates().len();
        let body = system.has_orientation();
        let free = body && system.is_cyclic(0) && !system.is_cyclic(2);
        let parameters = (1..=system.parameters().len()).map(|k| if free { k as f64 } else { 1.0 }).collect();
        let q = (0..n).map(|i| if body || !system.is_cyclic(i) { 0.9 } else { 0.0 }).collect();
        let v = (0..n).map(|i| match (body, system.is_cyclic(i)) {
            (true, _) if i == 2 => 4.0,
            (false, true) => 1.2,
            _ => 0.0,
        });
        let mut start = Start { q, v: v.collect(), parameters, end };
        for (at, (latex, value)) in given.iter().enumerate() {
            if given[..at].iter().any(|(other, _)| plain(other) == plain(latex)) {
                return Err(Error::new(format!("{} is set twice", plain(latex))).help("give --set once for each name"));
            }
            let of =
                |names: &[String], dots: u8| names.iter().position(|own| plain(&with_dots(own, dots)) == plain(latex));
            if let Some(i) = of(system.parameters(), 0) {
                start.parameters[i] = *value;
            } else if let Some(i) = of(system.coordinates(), 0) {
                start.q[i] = *value;
            } else if let Some(i) = of(system.coordinates(), 1) {
                start.v[i] = *value;
            } else {
                let all: Vec<&str> =
                    system.coordinates().iter().chain(system.parameters()).map(String::as_str).collect();
                return Err(Error::new(format!(
                    "{} is not a coordinate, rate or parameter of {}",
                    plain(latex),
                    system.name()
                ))
                .help(format!(
                    "the names are {}; write a rate with a dot, as in --set '\\dot\\theta=0.5'",
                    all.join(", ")
                )));
            }
        }
        Ok(start)
    }
}
