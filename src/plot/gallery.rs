//! The pictures that suit a system, each with what it shows in a sentence.

use super::pictures::{Kind, picture};
use super::start::Start;
use crate::formula::text::{number, plain, with_dots};
use crate::mechanics::System;

/// A picture and its caption.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The SVG.
    pub svg: String,
    /// What it shows, and for which values.
    pub caption: String,
}

/// The time for which a system moves.
const END: f64 = 20.0;

/// The pictures of a system from its usual start. One that cannot be drawn is left out.
pub fn gallery(system: &System) -> Vec<Picture> {
    let Ok(start) = Start::of(system, &[], END) else { return Vec::new() };
    let all = [Kind::Polhodes, Kind::Potential, Kind::Axis, Kind::Rates, Kind::Motion, Kind::Drift];
    let is_free = system.has_orientation() && system.parameters().len() == 3;
    // The angles of a body that turns freely say less than its polhodes.
    let suits = |kind: &Kind| !is_free || !matches!(kind, Kind::Motion | Kind::Potential | Kind::Axis | Kind::Rates);
    let drawn = |kind: Kind| {
        let svg = picture(kind, system, &start).ok()?;
        Some(Picture { svg, caption: format!("{} {}", said(kind), values(kind, system, &start)) })
    };
    all.into_iter().filter(suits).filter_map(drawn).collect()
}

/// What a kind of picture shows.
fn said(kind: Kind) -> &'static str {
    match kind {
        Kind::Motion => {
            "The motion, integrated from the derived accelerations. The step is chosen by the estimated error."
        }
        Kind::Drift => {
            "The relative change of the energy along that motion. The energy is conserved, so this is the error of the \
             integration."
        }
        Kind::Potential => {
            "The effective potential and the energy. The motion turns where they are equal: at the rings."
        }
        Kind::Axis => {
            "The path of the tip of the axis: steady precession all around, and each of the three kinds of nutation over a third \
             of it. They differ in the rate of precession at the start: 0 gives cusps, a rate against the mean precession \
             gives loops, and one along it gives waves."
        }
        Kind::Rates => {
            "The two rates of steady precession against the spin, and their limits for a fast spin. They are the roots of the \
             Euler–Lagrange equation for the tilt. Below a least spin there is no steady precession."
        }
        Kind::Polhodes => {
            "The path of the tip of ω in the body. Around the axes of the smallest and of the largest moment of inertia it is \
             closed. Near the axis of the middle one, at the rings, it leads to the other side: rotation about it is unstable."
        }
    }
}

/// The values for which a picture is drawn.
fn values(kind: Kind, system: &System, start: &Start) -> String {
    let is = |latex: &String, dots: u8, value: f64| format!("{} = {}", plain(&with_dots(latex, dots)), short(value));
    let mut all: Vec<String> =
        system.parameters().iter().zip(&start.parameters).map(|(name, x)| is(name, 0, *x)).collect();
    if !matches!(kind, Kind::Polhodes | Kind::Rates) {
        for (i, name) in system.coordinates().iter().enumerate() {
            all.extend([is(name, 0, start.q[i]), is(name, 1, start.v[i])]);
        }
    }
    format!("For {}; in any consistent units, angles in radians.", all.join(", "))
}

/// A number without zeros at its end.
fn short(value: f64) -> String {
    let text = number(value, 3);
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::systems::Registry;

    #[test]
    fn every_system_has_pictures_that_suit_it() {
        let registry = Registry::standard();
        let titles = |name: &str| -> Vec<String> {
            let system = registry.get(name).unwrap().trace().unwrap();
            gallery(&system).into_iter().map(|picture| picture.svg).collect()
        };
        for (name, words) in [
            ("heavy_top", vec!["Turning points", "The axis of the top", "Steady precession", "changes by at most"]),
            ("free_rigid_body", vec!["energy ellipsoid"]),
            ("simple_pendulum", vec!["Turning points", "The motion", "changes by at most"]),
            ("double_pendulum", vec!["The motion", "changes by at most"]),
            ("kepler", vec!["Turning points", "The motion"]),
            ("damped_oscillator", vec!["The motion"]),
            ("relativistic_particle", vec!["The motion"]),
        ] {
            let drawn = titles(name);
            for words in words {
                assert!(drawn.iter().any(|svg| svg.contains(words)), "{name}: no {words}");
            }
            assert!(drawn.iter().all(|svg| svg.contains("<polyline") && !svg.contains("NaN")), "{name}");
        }
        // must-fail case: a pendulum is no top
        assert!(titles("simple_pendulum").iter().all(|svg| !svg.contains("Steady precession")));
    }
}
