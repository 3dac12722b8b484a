//! What is conserved on shell, what is cyclic, and what is neither.

use onshell::mechanics::{Lagrangian, State, System};
use onshell::scalar::{Number, RunningError, Series};
use onshell::systems::{DampedOscillator, FreeRigidBody, HeavyTop, Kepler, Pendulum, RelativisticParticle};
use proptest::prelude::*;

use crate::support::{config, slow, some_state, state};

/// d/dt of a quantity on shell, with the scale of its rounding: the ratio of the two, in epsilons.
fn drift<const N: usize, const P: usize>(
    system: &System,
    at: &State<f64, N, P>,
    quantity: impl Fn(onshell::mechanics::Quantities<Series<RunningError>>) -> Series<RunningError>,
) -> f64 {
    let m = |x: &[f64]| x.iter().map(|&x| RunningError::new(x)).collect::<Vec<_>>();
    let q = system.motion(RunningError::new(at.time), &m(&at.q), &m(&at.v), &m(&at.parameters), 2).unwrap();
    let v: Vec<_> = q.iter().map(Series::derivative).collect();
    let parameters: Vec<_> = m(&at.parameters).into_iter().map(Series::constant).collect();
    let value = quantity(system.quantities(Series::time(RunningError::new(at.time)), &q, &v, &parameters));
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
        prop_assert!(drift(&System::new(&HeavyTop).unwrap(), &top, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&System::new(&FreeRigidBody).unwrap(), &body, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&System::new(&Pendulum::<2>::new()).unwrap(), &chain, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&System::new(&Kepler).unwrap(), &planet, |x| x.energy) < ROUNDING);
        prop_assert!(drift(&System::new(&RelativisticParticle).unwrap(), &particle, |x| x.energy) < ROUNDING);
    }

    #[test]
    fn the_momenta_of_cyclic_coordinates_are_conserved_on_shell(top in state::<3, 5>(), planet in state::<2, 3>()) {
        let (heavy_top, kepler) = (System::new(&HeavyTop).unwrap(), System::new(&Kepler).unwrap());
        prop_assert!(drift(&heavy_top, &top, |x| x.momenta[0]) < ROUNDING);
        prop_assert!(drift(&heavy_top, &top, |x| x.momenta[2]) < ROUNDING);
        prop_assert!(drift(&kepler, &planet, |x| x.momenta[1]) < ROUNDING);
    }

    #[test]
    fn the_free_body_keeps_its_angular_momentum_in_space(at in state::<3, 3>()) {
        let system = System::new(&FreeRigidBody).unwrap();
        for component in 0..3 {
            let spin = drift(&system, &at, |x| {
                // S = Σ λₐ ωₐ êₐ
                let (r, rates) = (x.orientation.unwrap(), x.body_rates.unwrap());
                (0..3).map(|a| r[(a, component)] * rates[a] * Series::constant(RunningError::new(at.parameters[a]))).sum()
            });
            prop_assert!(spin < ROUNDING, "{spin}");
        }
    }
}

#[test]
fn what_is_not_conserved_is_seen_to_change() {
    let top = System::new(&HeavyTop).unwrap();
    assert!(drift(&top, &some_state::<3, 5>(), |x| x.lagrangian) > 1e6, "T − U is not conserved");
    assert!(drift(&top, &some_state::<3, 5>(), |x| x.momenta[1]) > 1e6, "θ is not cyclic");
    let body = System::new(&FreeRigidBody).unwrap();
    assert!(drift(&body, &some_state::<3, 3>(), |x| x.body_rates.unwrap()[0]) > 1e6, "body rates change");
    let damped = System::new(&DampedOscillator).unwrap();
    assert!(drift(&damped, &some_state::<1, 3>(), |x| x.energy) > 1e6, "L depends on the time");
}

#[test]
fn what_is_cyclic_is_known_for_certain() {
    let certain = |system: System| {
        let all = 0..system.coordinates().len();
        all.map(|i| (system.is_cyclic(i), system.is_certainly_cyclic(i))).collect::<Vec<_>>()
    };
    let (yes, no) = ((true, true), (false, false));
    assert_eq!(certain(System::new(&HeavyTop).unwrap()), [yes, no, yes]);
    assert_eq!(certain(System::new(&FreeRigidBody).unwrap()), [yes, no, no]);
    assert_eq!(certain(System::new(&Kepler).unwrap()), [no, yes]);
    assert_eq!(certain(System::new(&Pendulum::<2>::new()).unwrap()), [no, no]);
    assert!(System::new(&DampedOscillator).unwrap().depends_on_time());
    assert!(!System::new(&HeavyTop).unwrap().depends_on_time());
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
    let system = System::new(&Hidden).unwrap();
    assert!(system.is_cyclic(0) && !system.is_certainly_cyclic(0));
}

/// ½ẋ² + ½A²(…): a bead on a rod that turns, or a mass on a spring, by the sign of the second term; with `linear`, a term linear in ẋ.
struct OneBead {
    sign: f64,
    linear: f64,
}
impl Lagrangian<1, 2> for OneBead {
    fn name(&self) -> &str {
        "bead"
    }
    fn coordinates(&self) -> [&str; 1] {
        ["x"]
    }
    fn parameters(&self) -> [&str; 2] {
        ["m", "w"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 2>) -> D {
        let (x, v, [m, w]) = (at.q[0], at.v[0], at.parameters);
        m * v * v * 0.5 + m * w * w * x * x * (0.5 * self.sign) + x * v * self.linear
    }
}

#[test]
fn natural_systems_are_those_with_one_meaning_of_the_energy() {
    let natural = |system: Result<System, onshell::Error>| system.unwrap().is_natural();
    assert!(natural(System::new(&Pendulum::<2>::new())) && natural(System::new(&Kepler)));
    assert!(natural(System::new(&OneBead { sign: -1.0, linear: 0.0 })), "a mass on a spring");
    assert!(!natural(System::new(&OneBead { sign: 1.0, linear: 0.0 })), "a bead on a rod that turns");
    assert!(!natural(System::new(&OneBead { sign: -1.0, linear: 1.0 })), "a term linear in the velocity");
    assert!(!natural(System::new(&DampedOscillator)), "L depends on the time");
}
