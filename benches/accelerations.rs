//! The accelerations of the heavy top: by differentiating its Lagrangian, against the closed form written by hand.
//!
//! All ways run over the same states on one thread. The best time of many rounds of each way, and its ratio to the
//! closed form in the same run, are printed as a Markdown table, then divan's table. Print the Markdown table alone
//! with `cargo bench --bench accelerations -- --markdown`.

use std::hint::black_box;
use std::time::Instant;

use divan::Bencher;
use divan::counter::ItemsCount;
use nalgebra::{SMatrix, SVector};
use num_dual::{Dual2SVec64, hessian};
use onshell::mechanics::{Lagrangian, State, System, euler_lagrange};
use onshell::systems::HeavyTop;

/// A batch.
const STATES: usize = 100_000;
/// Few enough for a round to end before another program gets the processor.
const FEW: usize = 2048;
const PARAMETERS: [f64; 5] = [1.2, 0.7, 0.9, 9.8, 0.4];

type Accelerations = [f64; 3];

/// φ, θ, ψ and their velocities, a column each.
struct States([Vec<f64>; 6]);

impl States {
    fn new(count: usize) -> Self {
        // golden-ratio steps: spread evenly, the same in every run
        let column = |k: usize, low: f64, high: f64| {
            let start = 0.137 * (k + 1) as f64;
            let share = move |i: usize| (start + i as f64 * 0.618_033_988_749_895 * (k + 1) as f64).fract();
            (0..count).map(move |i| low + (high - low) * share(i)).collect()
        };
        States([
            column(0, -3.0, 3.0),
            column(1, 0.3, 2.8),
            column(2, -3.0, 3.0),
            column(3, -2.0, 2.0),
            column(4, -2.0, 2.0),
            column(5, -9.0, 9.0),
        ])
    }

    fn len(&self) -> usize {
        self.0[0].len()
    }

    fn at(&self, i: usize) -> State<f64, 3, 5> {
        let [phi, theta, psi, phi_rate, theta_rate, psi_rate] = self.0.each_ref().map(|column| column[i]);
        State { time: 0.0, q: [phi, theta, psi], v: [phi_rate, theta_rate, psi_rate], parameters: PARAMETERS }
    }
}

/// From notes (6.72) and (6.73), as one would write it by hand.
#[inline]
fn by_hand(theta: f64, phi_rate: f64, theta_rate: f64, psi_rate: f64) -> Accelerations {
    let [lambda_1, lambda_3, mass, g, distance] = PARAMETERS;
    let (sine, cosine) = theta.sin_cos();
    let p_psi = lambda_3 * (psi_rate + phi_rate * cosine);
    let theta_acceleration = (lambda_1 * phi_rate * phi_rate * sine * cosine - phi_rate * sine * p_psi
        + mass * g * distance * sine)
        / lambda_1;
    let phi_acceleration = (p_psi * theta_rate - 2.0 * lambda_1 * phi_rate * theta_rate * cosine) / (lambda_1 * sine);
    let psi_acceleration = phi_rate * theta_rate * sine - phi_acceleration * cosine;
    [phi_acceleration, theta_acceleration, psi_acceleration]
}

fn closed_form(states: &States, out: &mut [Accelerations]) {
    let [_, theta, _, phi_rate, theta_rate, psi_rate] = &states.0;
    for i in 0..states.len() {
        out[i] = by_hand(theta[i], phi_rate[i], theta_rate[i], psi_rate[i]);
    }
}

/// What `System::rust_source` writes; the tests hold the file against it.
mod emitted {
    include!("emitted/heavy_top.rs");
}

fn emitted_source(states: &States, out: &mut [Accelerations]) {
    for (i, out) in out.iter_mut().enumerate() {
        let at = states.at(i);
        *out = emitted::accelerations(at.time, &at.q, &at.v, &at.parameters);
    }
}

fn plain_hessian(states: &States, out: &mut [Accelerations]) {
    for (i, out) in out.iter_mut().enumerate() {
        let at = states.at(i);
        let x = SVector::<f64, 6>::from_iterator(at.q.into_iter().chain(at.v));
        let l = |x: SVector<Dual2SVec64<6>, 6>| {
            HeavyTop.lagrangian(&State {
                time: 0.0.into(),
                q: [x[0], x[1], x[2]],
                v: [x[3], x[4], x[5]],
                parameters: PARAMETERS.map(|p| p.into()),
            })
        };
        let (_, gradient, second) = hessian(l, &x);
        let mass: SMatrix<f64, 3, 3> = second.fixed_view::<3, 3>(3, 3).into();
        let mixed: SMatrix<f64, 3, 3> = second.fixed_view::<3, 3>(3, 0).into();
        let right = gradient.fixed_rows::<3>(0) - mixed * SVector::from(at.v);
        let a = mass.lu().solve(&right).unwrap_or_else(|| SVector::repeat(f64::NAN));
        *out = a.into();
    }
}

fn pairs(states: &States, out: &mut [Accelerations]) {
    for (i, out) in out.iter_mut().enumerate() {
        *out = euler_lagrange::accelerations(&HeavyTop, &states.at(i)).unwrap();
    }
}

fn tape_one_by_one(system: &System, states: &States, out: &mut [Accelerations]) {
    let mut accelerator = system.acceleration_evaluator(&PARAMETERS);
    let [phi, theta, psi, phi_rate, theta_rate, psi_rate] = &states.0;
    for (i, out) in out.iter_mut().enumerate() {
        let (q, v) = ([phi[i], theta[i], psi[i]], [phi_rate[i], theta_rate[i], psi_rate[i]]);
        out.copy_from_slice(accelerator.accelerations(0.0, &q, &v).unwrap());
    }
}

fn columns(states: &States) -> Vec<&[f64]> {
    let state = states.0.iter().map(Vec::as_slice);
    std::iter::once(&[0.0][..]).chain(state).chain(PARAMETERS.chunks(1)).collect()
}

fn tape_in_blocks(system: &System, states: &States, out: &mut [Vec<f64>]) {
    let mut out: Vec<&mut [f64]> = out.iter_mut().map(Vec::as_mut_slice).collect();
    system.write_accelerations_of_many(&columns(states), &mut out).unwrap();
}

/// The best time of a state in ns; the best, because everything else is other programs' noise.
fn best(states: usize, mut round: impl FnMut()) -> f64 {
    let time = |round: &mut dyn FnMut()| {
        let start = Instant::now();
        round();
        start.elapsed().as_secs_f64() * 1e9 / states as f64
    };
    let first = time(&mut round);
    let rounds = (1e9 / (first * states as f64)).clamp(20.0, 1000.0) as usize;
    (0..rounds).map(|_| time(&mut round)).fold(first, f64::min)
}

fn main() {
    let (states, system) = (States::new(STATES), System::new(&HeavyTop).unwrap());
    let mut out = vec![[0.0; 3]; STATES];
    closed_form(&states, &mut out);
    let mut in_columns = vec![vec![0.0; STATES]; 3];
    tape_in_blocks(&system, &states, &mut in_columns);
    for (column, derived) in in_columns.iter().enumerate() {
        for (by_hand, derived) in out.iter().zip(derived) {
            assert!((by_hand[column] - derived).abs() < 1e-10 * (1.0 + derived.abs()), "they compute different things");
        }
    }
    let closed = best(STATES, || closed_form(black_box(&states), &mut out));
    let (operations, steps) = (system.operations(), system.steps());
    println!("| accelerations of the heavy top ({operations} operations, {steps} steps) | ns per state | ratio |");
    println!("| --- | ---: | ---: |");
    let line = |name: &str, time: f64| println!("| {name} | {time:.1} | {:.2} |", time / closed);
    line("closed form by hand", closed);
    line("tape in blocks", best(STATES, || tape_in_blocks(&system, black_box(&states), &mut in_columns)));
    line("emitted as Rust", best(STATES, || emitted_source(black_box(&states), &mut out)));
    let few = States::new(FEW);
    line("tape, state by state", best(FEW, || tape_one_by_one(&system, black_box(&few), &mut out[..FEW])));
    line("pairs of hyper-duals", best(FEW, || pairs(black_box(&few), &mut out[..FEW])));
    line("plain Hessian", best(FEW, || plain_hessian(black_box(&few), &mut out[..FEW])));
    if !std::env::args().any(|argument| argument == "--markdown") {
        divan::main();
    }
}

fn bench(bencher: Bencher, count: usize, way: impl Fn(&States, &mut [Accelerations]) + Sync) {
    let states = States::new(count);
    bencher.counter(ItemsCount::new(count)).with_inputs(|| vec![[0.0; 3]; count]).bench_local_values(|mut out| {
        way(black_box(&states), &mut out);
        out
    });
}

#[divan::bench(name = "closed form by hand")]
fn divan_closed_form(bencher: Bencher) {
    bench(bencher, STATES, closed_form);
}

#[divan::bench(name = "tape in blocks")]
fn divan_tape_in_blocks(bencher: Bencher) {
    let (states, system) = (States::new(STATES), System::new(&HeavyTop).unwrap());
    let mut out = vec![vec![0.0; STATES]; 3];
    bencher.counter(ItemsCount::new(STATES)).bench_local(|| tape_in_blocks(&system, black_box(&states), &mut out));
}

#[divan::bench(name = "emitted as Rust")]
fn divan_emitted_source(bencher: Bencher) {
    bench(bencher, STATES, emitted_source);
}

#[divan::bench(name = "tape, state by state")]
fn divan_tape_one_by_one(bencher: Bencher) {
    let system = System::new(&HeavyTop).unwrap();
    bench(bencher, FEW, |states, out| tape_one_by_one(&system, states, out));
}

#[divan::bench(name = "pairs of hyper-duals")]
fn divan_pairs(bencher: Bencher) {
    bench(bencher, FEW, pairs);
}

#[divan::bench(name = "plain Hessian", sample_count = 10)]
fn divan_plain_hessian(bencher: Bencher) {
    bench(bencher, FEW, plain_hessian);
}

#[divan::bench(name = "tracing the top")]
fn divan_tracing() -> System {
    System::new(&HeavyTop).unwrap()
}
