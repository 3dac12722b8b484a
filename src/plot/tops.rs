//! Pictures of tops and free bodies, as numbers: the axis on its sphere, the rates of precession, polhodes.

use nalgebra::Vector3;

use super::figure::{Curve, Figure};
use super::start::Start;
use super::trajectory::{self, Moment, TOLERANCE};
use crate::mechanics::System;
use crate::{Error, Result};

/// A top: the coordinate of its tilt, the one that precesses, and the one that spins.
const TOP: [usize; 3] = [1, 0, 2];

fn is_top(system: &System) -> Result<()> {
    let [tilt, turns, spins] = TOP;
    let cyclic = |i: usize| system.is_cyclic(i);
    let sound = system.coordinates().len() == 3 && system.has_orientation() && cyclic(turns) && cyclic(spins);
    match sound && !cyclic(tilt) {
        true => Ok(()),
        false => {
            Err(Error::new(format!("{} is not a symmetric top", system.name()))
                .help("this picture is drawn for heavy_top"))
        }
    }
}

/// The velocities with a precession of `rate`, the tilt at rest, and a momentum of the spin.
fn spinning(system: &System, start: &Start, rate: f64, momentum: f64) -> Vec<f64> {
    let [_, turns, spins] = TOP;
    let mut v = vec![0.0; 3];
    v[turns] = rate;
    let at = system.quantities(0.0, &start.q, &v, &start.parameters);
    let mass = system.mass_matrix(0.0, &start.q, &v, &start.parameters);
    v[spins] = (momentum - at.momenta[spins]) / mass[(spins, spins)];
    v
}

/// The rates of steady precession, the slow one first: the roots of the Euler–Lagrange residual of the tilt, which is
/// quadratic in the rate, from its values at three rates.
pub(super) fn steady_rates(system: &System, start: &Start, momentum: f64) -> Option<[f64; 2]> {
    let [tilt, ..] = TOP;
    let residual = |rate: f64| {
        let v = spinning(system, start, rate, momentum);
        system.euler_lagrange(0.0, &start.q, &v, &start.parameters, &[0.0; 3])[tilt]
    };
    let (below, at, above) = (residual(-1.0), residual(0.0), residual(1.0));
    let (a, b, c) = (0.5 * (above + below) - at, 0.5 * (above - below), at);
    let square = b * b - 4.0 * a * c;
    (square >= 0.0 && a.abs() > 1e-12 * b.abs()).then(|| {
        // without cancellation
        let q = -0.5 * (b + b.signum() * square.sqrt());
        let (one, two) = (q / a, c / q);
        if one.abs() < two.abs() { [one, two] } else { [two, one] }
    })
}

pub(super) fn rates(system: &System, start: &Start) -> Result<Figure> {
    is_top(system)?;
    let [.., spins] = TOP;
    let mass = system.mass_matrix(0.0, &start.q, &[0.0; 3], &start.parameters)[(spins, spins)];
    let gravity = system.quantities(0.0, &start.q, &[0.0; 3], &start.parameters);
    let scale = (gravity.forces[TOP[0]].abs() / mass).sqrt().max(1e-3);
    let mut found: [Vec<(f64, f64)>; 2] = [Vec::new(), Vec::new()];
    let mut far: [Vec<(f64, f64)>; 2] = [Vec::new(), Vec::new()];
    let tilt_force = gravity.forces[TOP[0]] / start.q[TOP[0]].sin();
    for k in 1..=600 {
        let spin = 8.0 * scale * f64::from(k) / 600.0;
        if let Some([slow, fast]) = steady_rates(system, start, mass * spin) {
            if fast.abs() < 8.0 * scale * mass.max(1.0) {
                found[0].push((spin, fast));
            }
            found[1].push((spin, slow));
        }
        // the limits of a fast spin, from the same quadratic without its last and without its first term
        let lambda = system.mass_matrix(0.0, &start.q, &[0.0; 3], &start.parameters)[(TOP[0], TOP[0])];
        let limits = [mass * spin / (lambda * start.q[TOP[0]].cos()), tilt_force / (mass * spin)];
        for (at, limit) in limits.into_iter().enumerate() {
            if limit.abs() < 8.0 * scale * mass.max(1.0) && (at == 0 || limit < 3.0 * scale) {
                far[at].push((spin, limit));
            }
        }
    }
    let [fast, slow] = found;
    let [far_fast, far_slow] = far;
    let curve = |name: &str, look: usize, points: Vec<(f64, f64)>| Curve { name: name.to_owned(), look, points };
    Ok(Figure {
        title: "Steady precession: two rates, and their limits for a fast spin".to_owned(),
        axes: ["ω₃".to_owned(), "Ω".to_owned()],
        curves: vec![
            curve("Ω₊", 0, fast),
            curve("Ω₊, fast spin", 1, far_fast),
            curve("Ω₋", 3, slow),
            curve("Ω₋, fast spin", 2, far_slow),
        ],
        marks: Vec::new(),
        is_square: false,
    })
}

/// A direction in space as it is seen from the side and from above by an angle: right and up, and whether it is in front.
fn seen(direction: [f64; 3], above: f64) -> ((f64, f64), bool) {
    let turn = 0.6_f64;
    let [x, y, z] = direction;
    let (right, depth) = (y * turn.cos() - x * turn.sin(), x * turn.cos() + y * turn.sin());
    ((right, z * above.cos() - depth * above.sin()), depth * above.cos() + z * above.sin() > 0.0)
}

/// From how far above a top and an ellipsoid are seen.
const ABOVE: [f64; 2] = [1.25, 0.42];

pub(super) fn axis(system: &System, start: &Start) -> Result<Figure> {
    is_top(system)?;
    let [_, turns, spins] = TOP;
    let momentum = system.quantities(0.0, &start.q, &start.v, &start.parameters).momenta[spins];
    let Some([slow, _]) = steady_rates(system, start, momentum) else {
        return Err(Error::new("the top spins too slowly for steady precession")
            .help("give the last angle a larger rate, as in --set '\\dot\\psi=5'"));
    };
    let whole = std::f64::consts::TAU;
    // each kind of nutation over its own third of the way around, so that they do not cover each other
    let kinds = [
        ("steady", slow, 0.0, whole),
        ("cusps", 0.0, 0.0, 0.3),
        ("loops", -0.9 * slow, 1.0, 0.3),
        ("waves", 0.45 * slow, 2.0, 0.3),
    ];
    let mut curves = Vec::new();
    let circle = |of: &dyn Fn(f64) -> (f64, f64)| (0..=120).map(|k| of(f64::from(k) * whole / 120.0)).collect();
    // the equator, and the outline of the sphere
    let equator = circle(&|t| seen([t.cos(), t.sin(), 0.0], ABOVE[0]).0);
    for points in [equator, circle(&|t| t.sin_cos())] {
        curves.push(Curve { name: String::new(), look: 4, points });
    }
    for (look, (kind, rate, third, share)) in kinds.into_iter().enumerate() {
        let v = spinning(system, start, rate, momentum);
        let mut q = start.q.clone();
        q[turns] += third * whole / 3.0;
        // at the slow rate a turn takes so long; the kinds of nutation go on at about that rate
        let end = start.end.max(1.05 * whole / slow.abs().max(1e-3)).min(400.0);
        let moments = trajectory::motion(system, (&q, &v), &start.parameters, end, TOLERANCE)?;
        let first = q[turns];
        let shown = moments.iter().take_while(|moment| (moment.q[turns] - first).abs() < share * whole);
        let tip = |moment: &Moment| {
            let at = system.quantities(0.0, &moment.q, &moment.v, &start.parameters).orientation;
            at.map_or((f64::NAN, f64::NAN), |rows| seen([rows[(2, 0)], rows[(2, 1)], rows[(2, 2)]], ABOVE[0]).0)
        };
        curves.push(Curve { name: kind.to_owned(), look, points: shown.map(tip).collect() });
    }
    Ok(Figure {
        title: "The axis of the top on the sphere, from above".to_owned(),
        axes: ["to the right".to_owned(), "up".to_owned()],
        curves,
        marks: Vec::new(),
        is_square: true,
    })
}

pub(super) fn polhodes(system: &System, start: &Start) -> Result<Figure> {
    let free = system.coordinates().len() == 3 && system.parameters().len() == 3 && system.has_orientation();
    if !free {
        return Err(Error::new(format!("{} is not a free rigid body", system.name()))
            .help("this picture is drawn for free_rigid_body"));
    }
    let moments = Vector3::from_row_slice(&start.parameters);
    // on the ellipsoid of energy 1/2: λ₁ω₁² + λ₂ω₂² + λ₃ω₃² = 1
    let on = |direction: [f64; 3]| {
        let size: f64 = (0..3).map(|i| moments[i] * direction[i] * direction[i]).sum::<f64>().sqrt();
        direction.map(|x| x / size)
    };
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    let middle = order[1];
    let along = |axis: usize, off: f64, other: usize, sign: f64| {
        let mut direction = [0.0; 3];
        direction[axis] = sign;
        direction[other] = off;
        on(direction)
    };
    let mut curves = Vec::new();
    let mut draw = |name: String, look: usize, from: [f64; 3]| -> Result<()> {
        let path = trajectory::polhode(system, &start.parameters, from, 60.0)?;
        let points = path.iter().map(|omega| seen(*omega, ABOVE[1]).0).collect();
        curves.push(Curve { name, look, points });
        Ok(())
    };
    let label = |axis: usize, kind: &str| format!("about axis {}, {kind}", axis + 1);
    for (look, axis) in [(0, order[0]), (3, order[2])] {
        for (off, sign) in [(0.25, 1.0), (0.55, 1.0), (0.25, -1.0), (0.55, -1.0)] {
            let first = off == 0.25 && sign == 1.0;
            draw(if first { label(axis, "stable") } else { String::new() }, look, along(axis, off, middle, sign))?;
        }
    }
    for sign in [1.0, -1.0] {
        let name = if sign > 0.0 { label(middle, "unstable") } else { String::new() };
        draw(name, 1, along(middle, 0.02, order[0], sign))?;
    }
    Ok(Figure {
        title: "Angular velocity of a free body on its energy ellipsoid".to_owned(),
        axes: ["ω to the right".to_owned(), "ω up".to_owned()],
        curves,
        marks: [1.0, -1.0].map(|sign| seen(along(middle, 0.0, order[0], sign), ABOVE[1]).0).to_vec(),
        is_square: true,
    })
}
