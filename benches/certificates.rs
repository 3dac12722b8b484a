//! The cost of certifying an equation of the heavy top over a prime field, as a Markdown table.
//!
//! The equations are (6.71) to (6.73) of the notes, typed in by hand: p_φ and p_ψ are constant, and the acceleration of
//! θ. Each is evaluated at as many points as a certificate takes, its probability of being false below 2⁻⁹⁰; the best
//! of many rounds is printed, beside that of the same evaluation over doubles at one state.

use std::hint::black_box;
use std::time::{Duration, Instant};

use onshell::mechanics::{LinearSolver, System};
use onshell::scalar::prime_field::{FirstPrime, Modular, evaluate_at_point, false_accept_log2};
use onshell::scalar::{Number, RunningError, Series};
use onshell::systems::HeavyTop;

/// A formula that vanishes on shell, of θ and the parameters λ₁, λ₃, M, g, R, of velocities and accelerations.
struct Equation {
    name: &'static str,
    sides: fn(&System, [Modular; 11]) -> Modular,
    in_numbers: fn(&System, [RunningError; 11]) -> RunningError,
}

/// The state, and its accelerations by the system.
fn split<D: Number>(system: &System, x: [D; 11]) -> ([D; 3], [D; 3], [D; 5], Vec<D>) {
    let [phi, theta, psi, u, v, w, a, b, c, d, e] = x;
    let (q, v, parameters) = ([phi, theta, psi], [u, v, w], [a, b, c, d, e]);
    let motion = system.motion_with(LinearSolver::CramersRule, D::from(0.0), &q, &v, &parameters, 2);
    let motion = motion.expect("the mass matrix is regular");
    let second = |series: &Series<D>| series.nth_derivative_value(2).expect("two derivatives were asked for");
    (q, v, parameters, motion.iter().map(second).collect())
}

/// d/dt λ₃ (ψ̇ + φ̇ cos θ) = 0.
fn spin<D: Number>(system: &System, x: [D; 11]) -> D {
    let (q, v, [_, lambda_3, ..], a) = split(system, x);
    lambda_3 * (a[2] + a[0] * q[1].cos() - v[0] * v[1] * q[1].sin())
}

/// λ₁ θ̈ = λ₁ φ̇² sin θ cos θ − λ₃ (ψ̇ + φ̇ cos θ) φ̇ sin θ + M g R sin θ.
fn nutation<D: Number>(system: &System, x: [D; 11]) -> D {
    let (q, v, [lambda_1, lambda_3, mass, g, distance], a) = split(system, x);
    let (sine, cosine) = (q[1].sin(), q[1].cos());
    let spin = lambda_3 * (v[2] + v[0] * cosine);
    lambda_1 * a[1] - lambda_1 * v[0] * v[0] * sine * cosine + spin * v[0] * sine - mass * g * distance * sine
}

/// d/dt (λ₁ φ̇ sin²θ + λ₃ (ψ̇ + φ̇ cos θ) cos θ) = 0.
fn precession<D: Number>(system: &System, x: [D; 11]) -> D {
    let (q, v, [lambda_1, lambda_3, ..], a) = split(system, x);
    let (sine, cosine) = (q[1].sin(), q[1].cos());
    let spin = v[2] + v[0] * cosine;
    let rate = a[2] + a[0] * cosine - v[0] * v[1] * sine;
    lambda_1 * (a[0] * sine * sine + v[0] * v[1] * sine * cosine * 2.0)
        + lambda_3 * (rate * cosine - spin * v[1] * sine)
}

const EQUATIONS: [Equation; 3] = [
    Equation { name: "p_ψ is constant", sides: spin, in_numbers: spin },
    Equation { name: "p_φ is constant", sides: precession, in_numbers: precession },
    Equation { name: "θ̈", sides: nutation, in_numbers: nutation },
];

/// A certificate: how many points it took, and its bound.
fn certify(system: &System, equation: &Equation, seed: u64) -> (u32, f64) {
    let (mut bound, mut points) = (0.0, 0);
    while bound > -90.0 || points < 2 {
        let point = seed + u64::from(points);
        let draw = || std::array::from_fn(|_| Modular::<FirstPrime>::random());
        // a second time, with the least common denominator of the angles that the first found
        let (_, record) = evaluate_at_point::<FirstPrime, _>(point, 0, 1, || (equation.sides)(system, draw()));
        let (value, record) =
            evaluate_at_point::<FirstPrime, _>(point, 0, record.finest, || (equation.sides)(system, draw()));
        assert!(value.vanishes() && record.unsupported.is_none(), "{}: {record:?}", equation.name);
        bound +=
            false_accept_log2(&[value], &record, 64, Modular::<FirstPrime>::most_bits()).expect("it is small enough");
        points += 1;
    }
    (points, bound)
}

/// The best of many rounds.
fn best(mut round: impl FnMut(u64)) -> Duration {
    let timed = (0..200).map(|seed| {
        let start = Instant::now();
        round(seed);
        start.elapsed()
    });
    timed.min().unwrap_or_default()
}

fn main() {
    let system = System::new(&HeavyTop).expect("it can be traced");
    println!(
        "| certified equation | points | probability of error below | certificate, µs | one state in doubles, µs |"
    );
    println!("| --- | ---: | ---: | ---: | ---: |");
    for equation in &EQUATIONS {
        let (points, bound) = certify(&system, equation, 1);
        let certificate = best(|seed| {
            black_box(certify(&system, equation, seed));
        });
        let state = best(|seed| {
            let numbers = std::array::from_fn(|k| RunningError::new(0.3 + (0.618 * (k as f64 + seed as f64)).fract()));
            black_box((equation.in_numbers)(&system, numbers));
        });
        let micros = |time: Duration| time.as_secs_f64() * 1e6;
        println!("| {} | {points} | 2^{bound:.0} | {:.1} | {:.2} |", equation.name, micros(certificate), micros(state));
    }
}
