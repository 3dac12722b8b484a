//! A system of your own, and notes about it that your `cargo test` checks.
//!
//! The Lagrangian is the only physics written in Rust. The notes and their claims are in `examples/bead.md` and
//! `examples/bead.json`.
//!
//! `cargo run --example own_system` prints the report; `cargo run --example own_system -- check examples` is the whole
//! command, with this system added.

use std::process::ExitCode;

use onshell::mechanics::{Lagrangian, State};
use onshell::scalar::Number;
use onshell::systems::Registry;
use onshell::testing::assert_file;

/// A bead on a wire bent to a parabola, z = x²/2ℓ, that turns about the vertical at the rate Ω.
struct Bead;

impl Lagrangian<1, 4> for Bead {
    fn name(&self) -> &str {
        "bead"
    }
    fn coordinates(&self) -> [&str; 1] {
        ["x"]
    }
    fn parameters(&self) -> [&str; 4] {
        ["m", "g", "\\ell", "\\Omega"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 4>) -> D {
        let ([x], [v], [mass, g, length, turning]) = (at.q, at.v, at.parameters);
        let height = x * x / (length * 2.0);
        let climb = x * v / length;
        mass * (v.powi(2) + climb.powi(2) + (turning * x).powi(2)) * 0.5 - mass * g * height
    }
}

fn registry() -> Registry {
    let mut registry = Registry::standard();
    registry.add(Bead);
    registry
}

#[test]
fn the_notes_hold() {
    assert_file("examples/bead.json", &registry());
}

fn main() -> ExitCode {
    if std::env::args().len() > 1 {
        return onshell::cli::run(&registry());
    }
    assert_file("examples/bead.json", &registry());
    println!("every equation of examples/bead.md is as expected");
    ExitCode::SUCCESS
}
