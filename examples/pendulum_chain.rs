//! What the equations of motion of a chain of n pendulums cost, from its Lagrangian alone, in counted operations.
//!
//! Pairs of hyper-dual directions run the Lagrangian, which has some 30 operations a link, n(n + 1)/2 times for the
//! mass matrix and n times for the rest: n³. The traced tape has one operation or two for each entry of the mass
//! matrix: n². What both leave to be done, solving M a = −h, is n³/6 products and as many sums by elimination.

use std::time::Instant;

use num_dual::HyperDual;
use onshell::mechanics::{Lagrangian, State, System};
use onshell::scalar::{Graph, Symbol};
use onshell::systems::Pendulum;

/// The operations of L over hyper-dual numbers all of whose parts vary, each expression once.
fn one_pair<const N: usize>(l: &Pendulum<N>) -> usize {
    let number = |k: usize| {
        let [re, eps1, eps2, eps1eps2] = [0, 1, 2, 3].map(|part| Symbol::input(4 * k + part));
        HyperDual::new(re, eps1, eps2, eps1eps2)
    };
    let recorded = Graph::record(|| {
        l.lagrangian(&State {
            time: number(0),
            q: std::array::from_fn(|i| number(1 + i)),
            v: std::array::from_fn(|i| number(1 + N + i)),
            parameters: std::array::from_fn(|i| HyperDual::from_re(Symbol::input(4 * (1 + 2 * N) + i))),
        });
    });
    recorded.map_or(0, |(graph, ())| graph.nodes().len())
}

fn line<const N: usize>() -> onshell::Result<()> {
    let chain = Pendulum::<N>::new();
    let pairs = (N * (N + 1) / 2 + N) * one_pair(&chain);
    let start = Instant::now();
    let system = System::new(&chain)?;
    let (tape, seconds) = (system.operations_before_solving(), start.elapsed().as_secs_f64());
    let solved = system.operations();
    println!("{N:>4}{pairs:>12}{tape:>10}{:>10.2}{solved:>12}{seconds:>14.3}", tape as f64 / (N * N) as f64);
    Ok(())
}

fn main() -> onshell::Result<()> {
    println!("   n       pairs      tape   tape/n²  and solving  seconds to trace");
    line::<2>()?;
    line::<3>()?;
    line::<4>()?;
    line::<6>()?;
    line::<8>()?;
    line::<12>()?;
    line::<16>()?;
    line::<24>()?;
    line::<32>()
}
