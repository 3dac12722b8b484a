//! A system of your own: ten lines of Rust, and all that follows from them.
//!
//! `cargo run --example own_system`

use onshell::Result;
use onshell::mechanics::{Lagrangian, State};
use onshell::scalar::Number;
use onshell::systems::Registry;

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
        let [mass, g, length, turning] = at.parameters;
        let height = |x| x * x / (length * 2.0);
        let climb = at.q[0] * at.v[0] / length;
        let around = turning * at.q[0];
        mass * (at.v[0].powi(2) + climb.powi(2) + around.powi(2)) * 0.5 - mass * g * height(at.q[0])
    }
}

fn main() -> Result<()> {
    let mut registry = Registry::standard();
    registry.add(Bead);
    let Some(bead) = registry.get("bead") else { return Ok(()) };
    let world = bead.world()?;

    let (q, v, parameters) = ([0.5], [0.2], [1.0, 9.8, 0.3, 4.0]);
    let state = world.quantities(0.0, &q, &v, &parameters);
    println!("L = {:.6}, p_x = {:.6}, energy = {:.6}", state.lagrangian, state.momenta[0], state.energy);
    let motion = world.motion(0.0, &q, &v, &parameters, 3)?;
    println!("ẍ = {:.6}, and the next derivative {:.6}", derivative(&motion[0], 2), derivative(&motion[0], 3));
    println!("is x cyclic? {}", world.is_cyclic(0));
    Ok(())
}

fn derivative(series: &onshell::scalar::Series<f64>, order: usize) -> f64 {
    series.nth_derivative_value(order).unwrap_or(f64::NAN)
}
