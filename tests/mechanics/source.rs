//! The accelerations as Rust source: compiled by the compiler, run, and held against automatic differentiation.

use std::fmt::Write;
use std::path::PathBuf;
use std::process::Command;

use onshell::mechanics::{Lagrangian, State, System, euler_lagrange};
use onshell::systems::{DampedOscillator, FreeRigidBody, HeavyTop, Kepler, Pendulum, RelativisticParticle};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

use crate::support::{agree, slow, state};

/// Sources, a module each, with calls of them and what the calls must give.
#[derive(Default)]
struct Trial {
    modules: String,
    calls: String,
    expected: Vec<Vec<f64>>,
}

impl Trial {
    fn add<L: Lagrangian<N, P>, const N: usize, const P: usize>(&mut self, l: &L, states: &[State<f64, N, P>]) {
        self.add_source(&System::new(l).unwrap().rust_source(), l, states);
    }

    fn add_source<L: Lagrangian<N, P>, const N: usize, const P: usize>(
        &mut self,
        source: &str,
        l: &L,
        states: &[State<f64, N, P>],
    ) {
        let name = format!("system_{}", self.expected.len());
        writeln!(self.modules, "mod {name} {{\n{source}}}").unwrap();
        for at in states {
            let State { time, q, v, parameters } = at;
            writeln!(
                self.calls,
                "    println!(\"{{:?}}\", {name}::accelerations({time:?}, &{q:?}, &{v:?}, &{parameters:?}));"
            )
            .unwrap();
            self.expected.push(euler_lagrange::accelerations(l, at).unwrap().to_vec());
        }
    }

    /// Compiles without a warning, runs, and gives what was computed.
    fn run(&self, name: &str) -> Vec<Vec<f64>> {
        let place = std::env::temp_dir().join(format!("onshell-source-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&place).unwrap();
        let (source, program): (PathBuf, PathBuf) = (place.join("main.rs"), place.join("main"));
        std::fs::write(&source, format!("{}fn main() {{\n{}}}\n", self.modules, self.calls)).unwrap();
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let options = ["--edition", "2024", "-D", "warnings", "-o"];
        let compiled = Command::new(rustc).args(options).arg(&program).arg(&source).output().unwrap();
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        let printed = String::from_utf8(Command::new(&program).output().unwrap().stdout).unwrap();
        std::fs::remove_dir_all(&place).unwrap();
        let numbers = |line: &str| line.trim_matches(['[', ']']).split(", ").map(|x| x.parse().unwrap()).collect();
        printed.lines().map(numbers).collect()
    }

    /// How many of the answers agree.
    fn right(&self, name: &str) -> usize {
        let computed = self.run(name);
        assert_eq!(computed.len(), self.expected.len());
        computed.iter().zip(&self.expected).filter(|(computed, expected)| agree(computed, expected, 1e-12)).count()
    }
}

/// Some states, the same in every run.
fn states<const N: usize, const P: usize>() -> Vec<State<f64, N, P>> {
    let mut runner = TestRunner::deterministic();
    (0..8).map(|_| state().new_tree(&mut runner).unwrap().current()).collect()
}

#[test]
fn the_source_computes_what_automatic_differentiation_does() {
    let mut trial = Trial::default();
    trial.add(&HeavyTop, &states());
    trial.add(&FreeRigidBody, &states());
    trial.add(&Pendulum::<1>::new(), &states());
    trial.add(&Pendulum::<2>::new(), &states());
    trial.add(&Pendulum::<4>::new(), &states());
    trial.add(&Kepler, &states());
    trial.add(&DampedOscillator, &states());
    trial.add(&RelativisticParticle, &states().into_iter().map(slow).collect::<Vec<_>>());
    assert_eq!(trial.right("all"), trial.expected.len());
}

#[test]
fn a_changed_sign_in_the_source_is_seen() {
    let source = System::new(&HeavyTop).unwrap().rust_source();
    let mut trial = Trial::default();
    let signs: Vec<usize> = source
        .match_indices(" - ")
        .map(|(place, _)| place)
        .filter(|&place| place > source.find('{').unwrap())
        .collect();
    assert!(!signs.is_empty());
    for &place in &signs {
        let mut changed = source.clone();
        changed.replace_range(place..place + 3, " + ");
        trial.add_source(&changed, &HeavyTop, &states());
    }
    assert_eq!(trial.right("twin"), 0);
}

#[test]
fn what_is_used_more_often_is_computed_once() {
    let source = System::new(&HeavyTop).unwrap().rust_source();
    assert_eq!(source.matches("sin_cos()").count(), 1);
    assert!(source.contains("///   1: `\\theta`") && source.contains("///   3: `g`"), "{source}");
    assert!(source.contains("_time: f64"), "the top does not depend on the time: {source}");
}

#[test]
fn the_source_in_the_benchmark_is_this_one() {
    let source = System::new(&HeavyTop).unwrap().rust_source();
    assert!(
        include_str!("../../benches/emitted/heavy_top.rs") == source,
        "benches/emitted/heavy_top.rs must be\n{source}"
    );
}
