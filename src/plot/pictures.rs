//! What each kind of picture shows, as numbers.

use super::figure::{Curve, Figure};
use super::start::Start;
use super::tops::{axis, polhodes, rates};
use super::trajectory::{self, Moment, TOLERANCE};
use crate::formula::text::{number, plain};
use crate::mechanics::System;
use crate::{Error, Result};

/// A kind of picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The coordinates against the time.
    Motion,
    /// The relative change of the energy along the integrated motion.
    Drift,
    /// The effective potential, with the energy and the turning points.
    Potential,
    /// The axis of a top on the sphere: steady precession and the three kinds of nutation.
    Axis,
    /// The rates of steady precession against the spin.
    Rates,
    /// The angular velocity of a free body on its ellipsoid of energy.
    Polhodes,
}

/// A picture of a system.
///
/// # Errors
/// When the system has no such picture, or its motion cannot be integrated.
pub fn picture(kind: Kind, system: &System, start: &Start) -> Result<String> {
    match kind {
        Kind::Motion => motion(system, start),
        Kind::Drift => drift(system, start),
        Kind::Potential => potential(system, start),
        Kind::Axis => axis(system, start),
        Kind::Rates => rates(system, start),
        Kind::Polhodes => polhodes(system, start),
    }?
    .svg()
}

fn name(latex: &str) -> String {
    plain(latex)
}

/// The name of a system in words.
fn words(system: &System) -> String {
    format!("the {}", system.name().replace(['_', '-'], " "))
}

fn motion(system: &System, start: &Start) -> Result<Figure> {
    let moments = trajectory::motion(system, (&start.q, &start.v), &start.parameters, start.end, TOLERANCE)?;
    let reach = |i: usize| {
        let places = moments.iter().map(|moment| moment.q[i]);
        places.clone().fold(f64::MIN, f64::max) - places.fold(f64::MAX, f64::min)
    };
    // An angle that turns and turns would hide the others.
    let all = 0..system.coordinates().len();
    let widest = all.clone().filter(|&i| !system.is_cyclic(i)).map(reach).fold(0.0, f64::max);
    let is_shown = |i: &usize| !system.is_cyclic(*i) || widest == 0.0 || reach(*i) < 8.0 * widest;
    let shown: Vec<usize> = all.filter(is_shown).collect();
    let curve = |(look, &i): (usize, &usize)| Curve {
        name: name(&system.coordinates()[i]),
        look,
        points: moments.iter().map(|moment| (moment.time, moment.q[i])).collect(),
    };
    Ok(Figure {
        title: format!("The motion of {}", words(system)),
        axes: [
            "time t".to_owned(),
            shown.iter().map(|i| name(&system.coordinates()[*i])).collect::<Vec<_>>().join(", "),
        ],
        // One curve needs no legend: the axis has its name.
        curves: shown
            .iter()
            .enumerate()
            .map(curve)
            .map(|curve| Curve { name: if shown.len() > 1 { curve.name } else { String::new() }, ..curve })
            .collect(),
        marks: Vec::new(),
        is_square: false,
    })
}

/// (E(t) − E(0)) / |E(0)| along a motion.
///
/// # Errors
/// When the energy is not conserved, or the motion cannot be integrated.
pub(super) fn energy_drift(system: &System, start: &Start, tolerance: f64) -> Result<Vec<(f64, f64)>> {
    if system.depends_on_time() {
        let message = format!("the energy of {} is not conserved, so this picture is not drawn", system.name());
        return Err(Error::new(message).help("draw the motion instead: --as motion"));
    }
    let moments = trajectory::motion(system, (&start.q, &start.v), &start.parameters, start.end, tolerance)?;
    let energy = |moment: &Moment| system.quantities(moment.time, &moment.q, &moment.v, &start.parameters).energy;
    let first = moments.first().map_or(1.0, energy);
    let scale = if first == 0.0 { 1.0 } else { first.abs() };
    Ok(moments.iter().map(|moment| (moment.time, (energy(moment) - first) / scale)).collect())
}

fn drift(system: &System, start: &Start) -> Result<Figure> {
    let drift = energy_drift(system, start, TOLERANCE)?;
    let largest = drift.iter().map(|(_, change)| change.abs()).fold(0.0, f64::max);
    let scale = 10_f64.powf(largest.max(1e-17).log10().floor());
    Ok(Figure {
        title: format!("The energy of {} changes by at most {}", words(system), number(largest, 2)),
        axes: ["time t".to_owned(), format!("relative change of the energy / {scale:.0e}")],
        curves: vec![Curve {
            name: String::new(),
            look: 0,
            points: drift.into_iter().map(|(time, change)| (time, change / scale)).collect(),
        }],
        marks: Vec::new(),
        is_square: false,
    })
}

/// The coordinate that is not cyclic.
fn single(system: &System) -> Result<usize> {
    let moving: Vec<usize> = (0..system.coordinates().len()).filter(|&i| !system.is_cyclic(i)).collect();
    match moving[..] {
        [i] if !system.depends_on_time() => Ok(i),
        _ => {
            Err(Error::new(format!("{} has no effective potential that depends on one coordinate only", system.name()))
                .help("name a system in which all coordinates but one are cyclic, such as heavy_top or kepler"))
        }
    }
}

/// U_eff at places of the coordinate that is not cyclic, from `low` to `high`, and the energy.
pub(super) struct Well {
    pub curve: Vec<(f64, f64)>,
    pub energy: f64,
    /// Where the energy is U_eff.
    pub turning: Vec<f64>,
}

pub(super) fn well(system: &System, start: &Start) -> Result<Well> {
    let i = single(system)?;
    let parameters = &start.parameters;
    let at = system.quantities(0.0, &start.q, &start.v, parameters);
    let effective = |x: f64| {
        let mut q = start.q.clone();
        q[i] = x;
        let still = vec![0.0; q.len()];
        // the Routhian with the coordinate at rest, its cyclic momenta those of the start
        system.routhian(0.0, &q, &still, &at.momenta, parameters).unwrap_or(f64::NAN)
    };
    // an angle goes once around, or half around if its ends are walls; a length starts at 0
    let moments = trajectory::motion(system, (&start.q, &start.v), parameters, start.end, TOLERANCE)?;
    let reached = |of: fn(f64, f64) -> f64, from: f64| moments.iter().map(|moment| moment.q[i]).fold(from, of);
    let (least, most) = (reached(f64::min, f64::MAX), reached(f64::max, f64::MIN));
    let width = (most - least).max(0.2);
    let (low, high) = (least - 0.6 * width, most + 0.6 * width);
    let points = 800;
    let place = |k: usize| low + (high - low) * k as f64 / f64::from(points);
    let over = |x: f64| effective(x) - at.energy;
    let mut turning = Vec::new();
    for k in 0..points as usize {
        let (mut a, mut b) = (place(k), place(k + 1));
        if over(a) * over(b) < 0.0 && over(a).abs().max(over(b).abs()) < 1e6 * at.energy.abs().max(1.0) {
            for _ in 0..80 {
                let middle = 0.5 * (a + b);
                if over(a) * over(middle) <= 0.0 { b = middle } else { a = middle }
            }
            turning.push(0.5 * (a + b));
        }
    }
    let curve = (0..=points as usize).map(|k| (place(k), effective(place(k)))).collect();
    Ok(Well { curve, energy: at.energy, turning })
}

fn potential(system: &System, start: &Start) -> Result<Figure> {
    let coordinate = name(&system.coordinates()[single(system)?]);
    let well = well(system, start)?;
    let bottom = well.curve.iter().map(|p| p.1).filter(|u| u.is_finite()).fold(f64::MAX, f64::min);
    let top = well.energy + 2.0 * (well.energy - bottom).max(0.1 * well.energy.abs()).max(0.05);
    let ends = [well.curve.first(), well.curve.last()].map(|point| point.map_or(0.0, |point| point.0));
    let low = bottom.max(well.energy - 3.0 * (top - well.energy));
    let shown = well.curve.iter().copied().filter(|&(_, u)| u <= top && u >= low).collect();
    let places: Vec<String> = well.turning.iter().map(|x| number(*x, 4)).collect();
    Ok(Figure {
        title: format!("Turning points of {}: {coordinate} = {}", words(system), places.join(", ")),
        axes: [coordinate, "energy".to_owned()],
        curves: vec![
            Curve { name: "U_eff".to_owned(), look: 0, points: shown },
            Curve { name: "E".to_owned(), look: 1, points: ends.map(|x| (x, well.energy)).to_vec() },
        ],
        marks: well.turning.iter().map(|&x| (x, well.energy)).collect(),
        is_square: false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::tops::steady_rates;
    use crate::systems::{FreeRigidBody, HeavyTop, Kepler, Pendulum};

    fn start(system: &System, given: &[(&str, f64)]) -> Start {
        let given: Vec<(String, f64)> = given.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
        Start::of(system, &given, 30.0).unwrap()
    }

    #[test]
    fn the_motion_turns_at_the_turning_points() {
        let systems = [
            System::new(&HeavyTop).unwrap(),
            System::new(&Kepler).unwrap(),
            System::new(&Pendulum::<1>::new()).unwrap(),
        ];
        for system in &systems {
            let start = start(system, &[]);
            let (i, well) = (single(system).unwrap(), well(system, &start).unwrap());
            let moments = trajectory::motion(system, (&start.q, &start.v), &start.parameters, 30.0, TOLERANCE).unwrap();
            let reached = moments.iter().map(|moment| moment.q[i]);
            let (least, most) = (reached.clone().fold(f64::MAX, f64::min), reached.fold(f64::MIN, f64::max));
            let near = |x: f64| well.turning.iter().any(|turning| (turning - x).abs() < 2e-3);
            assert!(near(least) && near(most), "{}: {least} {most} {:?}", system.name(), well.turning);
            // must-fail case
            assert!(!near(0.5 * (least + most)), "{}", system.name());
        }
    }

    #[test]
    fn the_energy_drifts_less_with_a_tighter_tolerance() {
        let system = System::new(&Pendulum::<2>::new()).unwrap();
        let start = start(&system, &[("\\theta_1", 1.2), ("\\theta_2", -0.4)]);
        let largest = |tolerance: f64| {
            energy_drift(&system, &start, tolerance).unwrap().iter().map(|(_, change)| change.abs()).fold(0.0, f64::max)
        };
        assert!(largest(TOLERANCE) < 1e-8, "{}", largest(TOLERANCE));
        assert!(largest(1e-4) > 100.0 * largest(TOLERANCE));
    }

    #[test]
    fn the_rates_of_precession_are_those_of_the_lecture() {
        let top = System::new(&HeavyTop).unwrap();
        let start = start(
            &top,
            &[("\\lambda_1", 0.8), ("\\lambda_3", 1.3), ("M", 2.0), ("g", 0.7), ("R", 0.6), ("\\theta", 1.1)],
        );
        for spin in [2.0, 3.0, 10.0] {
            let (l, c, w) = (0.8, 1.1_f64.cos(), 2.0 * 0.7 * 0.6);
            let p = 1.3 * spin;
            let root = (p * p - 4.0 * w * l * c).sqrt();
            let expected = [(p - root) / (2.0 * l * c), (p + root) / (2.0 * l * c)];
            let found = steady_rates(&top, &start, p).unwrap();
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9 * expected.abs(), "{found} {expected}");
                assert!((found - 1.01 * expected).abs() > 1e-9 * expected.abs());
            }
        }
        assert!(steady_rates(&top, &start, 0.1).is_none());
    }

    #[test]
    fn a_polhode_keeps_the_energy_and_the_angular_momentum() {
        let body = System::new(&FreeRigidBody).unwrap();
        let moments = [1.0, 2.0, 3.0];
        let path = trajectory::polhode(&body, &moments, [0.02, 0.7, 0.01], 40.0).unwrap();
        let energy = |w: &[f64; 3]| (0..3).map(|i| moments[i] * w[i] * w[i]).sum::<f64>();
        let square = |w: &[f64; 3]| (0..3).map(|i| (moments[i] * w[i]).powi(2)).sum::<f64>();
        for of in [&energy as &dyn Fn(&[f64; 3]) -> f64, &square] {
            assert!(path.iter().all(|w| (of(w) - of(&path[0])).abs() < 1e-7), "not kept");
        }
        // about the middle axis it turns over: ω itself is not kept
        assert!(path.iter().any(|w| w[1] < -0.5));
    }
}
