//! What is conserved on shell, what is cyclic, and what is neither.

use onshell::mechanics::{Lagrangian, State, World};
use onshell::scalar::{Measured, Number, Series};
use onshell::systems::{DampedOscillator, FreeRigidBody, HeavyTop, Kepler, Pendulum, RelativisticParticle};
use proptest::prelude::*;

use crate::support::{config, slow, some_state, state};

/// d/dt of a quantity on shell, with the scale of its rounding: the ratio of the two, in epsilons.
fn drift<const N: usize, const P: usize>(
    world: &World,
    at: &State<f64, N, P>,
    quantity: impl Fn(onshell::mechanics::Quantities<Series<Measured>>) -> Series<Measured>,
) -> f64 {
    let m = |x: &[f64]| x.iter().map(|&x| Measured::new(x)).collect::<Vec<_>>();
    let q = world.motion(Measured::new(at.time), &m(&at.q), &m(&at.v), &m(&at.parameters), 2).unwrap();
    let v: Vec<_> = q.iter().map(Series::derivative).collect();
    let parameters: Vec<_> = m(&at.parameters).into_iter().map(Series::constant).collect();
    let value = quantity(world.quantities(Series::time(Measured::new(at.time)), &q, &v, &parameters));
    let rate = value.nth_derivative_value(1).unwrap();
    rate.value.abs() / (rate.magnitude * f64::EPSILON)
}

const ROUNDING: f64 = 64.0;

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn the_energy_is_conserved_on_shell(
        top in state::<3, 5>(), body in state::<3, 3>(), chain in state::<2, 3>(), planet in state::<2, 3>(),
        particle in state::<1, 3>().prop_map(slow),
    ) {
        prop_assert!(drift(&World::new(&HeavyTop).unwrap(), &top, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&World::new(&FreeRigidBody).unwrap(), &body, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&World::new(&Pendulum::<2>::new()).unwrap(), &chain, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&World::new(&Kepler).unwrap(), &planet, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&World::new(&RelativisticParticle).unwrap(), &particle, |x| x.energy) < ROUNDING);
    }

    #[test]
    fn the_momenta_of_cyclic_coordinates_are_conserved_on_shell(top in state::<3, 5>(), planet in state::<2, 3>()) {
        let (heavy_top, kepler) = (World::new(&HeavyTop).unwrap(), World::new(&Kepler).unwrap());
        prop_assert!(drift(&heavy_top, &top, |x| x.momenta[0]) < ROUNDING);
        prop_assert!(drift(&heavy_top, &top, |x| x.momenta[2]) < ROUNDING);
        prop_assert!(drift(&kepler, &planet, |x| x.momenta[1]) < ROUNDING);
    }

    #[test]
    fn the_free_body_keeps_its_angular_momentum_in_space(at in state::<3, 3>()) {
        let world = World::new(&FreeRigidBody).unwrap();
        for component in 0..3 {
            let spin = drift(&world, &at, |x| {
                // S = Σ λₐ ωₐ êₐ
                let (r, rates) = (x.orientation.unwrap(), x.body_rates.unwrap());
                (0..3).map(|a| r[(a, component)] * rates[a] * Series::constant(Measured::new(at.parameters[a]))).sum()
            });
            prop_assert!(spin < ROUNDING, "{spin}");
        }
    }
}

#[test]
fn what_is_not_conserved_is_seen_to_change() {
    let top = World::new(&HeavyTop).unwrap();
    assert!(drift(&top, &some_state::<3, 5>(), |x| x.lagrangian) > 1e6, "T − U is not conserved");
    assert!(drift(&top, &some_state::<3, 5>(), |x| x.momenta[1]) > 1e6, "θ is not cyclic");
    let body = World::new(&FreeRigidBody).unwrap();
    assert!(drift(&body, &some_state::<3, 3>(), |x| x.body_rates.unwrap()[0]) > 1e6, "body rates change");
    let damped = World::new(&DampedOscillator).unwrap();
    assert!(drift(&damped, &some_state::<1, 3>(), |x| x.energy) > 1e6, "L depends on the time");
}

#[test]
fn what_is_cyclic_is_known_for_certain() {
    let certain = |world: World| {
        let all = 0..world.coordinates().len();
        all.map(|i| (world.is_cyclic(i), world.is_certainly_cyclic(i))).collect::<Vec<_>>()
    };
    let (yes, no) = ((true, true), (false, false));
    assert_eq!(certain(World::new(&HeavyTop).unwrap()), [yes, no, yes]);
    assert_eq!(certain(World::new(&FreeRigidBody).unwrap()), [yes, no, no]);
    assert_eq!(certain(World::new(&Kepler).unwrap()), [no, yes]);
    assert_eq!(certain(World::new(&Pendulum::<2>::new()).unwrap()), [no, no]);
    assert!(World::new(&DampedOscillator).unwrap().depends_on_time());
    assert!(!World::new(&HeavyTop).unwrap().depends_on_time());
}

/// (eˣ·eˣ − e²ˣ + 1) ẋ²: cyclic, but no polynomial in eˣ and e²ˣ says so.
struct Hidden;
impl Lagrangian<1, 0> for Hidden {
    fn name(&self) -> &str {
        "hidden"
    }
    fn coordinates(&self) -> [&str; 1] {
        ["x"]
    }
    fn parameters(&self) -> [&str; 0] {
        []
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 0>) -> D {
        let x = at.q[0];
        (x.exp().powi(2) - (x * 2.0).exp() + 1.0) * at.v[0] * at.v[0]
    }
}

#[test]
fn what_only_numbers_show_to_be_cyclic_is_not_certain() {
    let world = World::new(&Hidden).unwrap();
    assert!(world.is_cyclic(0) && !world.is_certainly_cyclic(0));
}
