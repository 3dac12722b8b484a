//! Euler–Lagrange: gauge freedom, the tape against a plain Hessian, many states at once.

use approx::assert_abs_diff_eq;
use onshell::mechanics::{Lagrangian, State, System, euler_lagrange, momenta};
use onshell::scalar::{DualNum, Number};
use onshell::systems::{DampedOscillator, FreeRigidBody, HeavyTop, Kepler, Pendulum, RelativisticParticle};
use proptest::prelude::*;

use crate::support::{agree, by_hessian, config, slow, some_state, state};

/// L + dF/dt, or L + F for the twin.
struct Gauged<L> {
    base: L,
    total_derivative: bool,
}
impl<L: Lagrangian<N, P>, const N: usize, const P: usize> Lagrangian<N, P> for Gauged<L> {
    fn name(&self) -> &str {
        self.base.name()
    }
    fn coordinates(&self) -> [&str; N] {
        self.base.coordinates()
    }
    fn parameters(&self) -> [&str; P] {
        self.base.parameters()
    }
    fn lagrangian<D: Number>(&self, at: &State<D, N, P>) -> D {
        let moving = at.moving();
        let sum = moving.q.iter().fold(moving.time, |sum, q| sum * q.cos() + q.exp() * moving.time);
        let f = sum * sum;
        self.base.lagrangian(at) + if self.total_derivative { f.eps } else { f.re }
    }
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn a_total_time_derivative_changes_no_equation_of_motion(at in state::<2, 3>(), a in [-3.0..3.0, -3.0..3.0]) {
        let plain = euler_lagrange::residuals(&Pendulum::<2>::new(), &at, &a);
        let gauge = |total_derivative| Gauged { base: Pendulum::<2>::new(), total_derivative };
        let gauged = euler_lagrange::residuals(&gauge(true), &at, &a);
        // F grows like e^{2q}: its terms cancel on that scale
        let scale = (at.q[0] + at.q[1]).exp().powi(2) * 100.0;
        prop_assert!(plain.iter().zip(gauged).all(|(a, b)| (a - b).abs() < 1e-13 * scale), "{plain:?} {gauged:?}");
        // traced, the equations are the same ones
        let system = System::new(&gauge(true)).unwrap();
        let traced = system.euler_lagrange(at.time, &at.q, &at.v, &at.parameters, &a);
        prop_assert!(plain.iter().zip(&traced).all(|(a, b)| (a - b).abs() < 1e-13 * scale), "{plain:?} {traced:?}");
        // the twin: F itself does change them
        let wrong = euler_lagrange::residuals(&gauge(false), &at, &a);
        prop_assert!(!agree(&plain, &wrong, 1e-6));
    }

    #[test]
    fn every_way_gives_what_the_plain_hessian_gives(
        top in state::<3, 5>(), body in state::<3, 3>(), pendulum in state::<1, 3>(), chain in state::<2, 3>(),
        planet in state::<2, 3>(), oscillator in state::<1, 3>(), particle in state::<1, 3>().prop_map(slow),
    ) {
        fn check<L: Lagrangian<N, P>, const N: usize, const P: usize, const X: usize>(
            l: &L, at: &State<f64, N, P>,
        ) -> Result<(), TestCaseError> {
            let plain = by_hessian::<L, N, P, X>(l, at);
            let system = System::new(l).unwrap();
            let tape = system.accelerations(at.time, &at.q, &at.v, &at.parameters).unwrap();
            let pairs = euler_lagrange::accelerations(l, at).unwrap();
            let columns = [&[at.time][..], &at.q, &at.v, &at.parameters].concat();
            let columns: Vec<&[f64]> = columns.chunks(1).collect();
            let block: Vec<f64> = system.accelerations_of_many(&columns).unwrap().concat();
            let mut accelerator = system.acceleration_evaluator(&at.parameters);
            let alone = accelerator.accelerations(at.time, &at.q, &at.v).unwrap();
            for other in [&tape[..], &pairs, &block, alone] {
                prop_assert!(agree(&plain, other, 1e-12), "{}: {plain:?} {other:?}", l.name());
            }
            Ok(())
        }
        check::<_, 3, 5, 7>(&HeavyTop, &top)?;
        check::<_, 3, 3, 7>(&FreeRigidBody, &body)?;
        check::<_, 1, 3, 3>(&Pendulum::<1>::new(), &pendulum)?;
        check::<_, 2, 3, 5>(&Pendulum::<2>::new(), &chain)?;
        check::<_, 2, 3, 5>(&Kepler, &planet)?;
        check::<_, 1, 3, 3>(&DampedOscillator, &oscillator)?;
        check::<_, 1, 3, 3>(&RelativisticParticle, &particle)?;
        // the twin: other masses, other accelerations
        let mut other = top;
        other.parameters[2] *= 1.001;
        prop_assert!(!agree(&by_hessian::<_, 3, 5, 7>(&HeavyTop, &other), &by_hessian::<_, 3, 5, 7>(&HeavyTop, &top), 1e-12));
    }

    #[test]
    fn what_is_traced_is_what_the_lagrangian_says(top in state::<3, 5>(), chain in state::<4, 3>(), planet in state::<2, 3>()) {
        fn check<L: Lagrangian<N, P>, const N: usize, const P: usize>(
            l: &L, at: &State<f64, N, P>,
        ) -> Result<(), TestCaseError> {
            let traced = System::new(l).unwrap().quantities(at.time, &at.q, &at.v, &at.parameters);
            let (t, u) = (traced.kinetic.unwrap(), traced.potential.unwrap());
            // T and U stand on both sides for the scale: what is left of them where they cancel is rounding
            let same = |a: &[f64], b: &[f64]| agree(&[&[t, u], a].concat(), &[&[t, u], b].concat(), 1e-12);
            let (lagrangian, energy) = (l.lagrangian(at), momenta::energy(l, at));
            prop_assert!(same(&[traced.lagrangian, traced.energy], &[lagrangian, energy]));
            prop_assert!(same(&traced.momenta, &momenta::momenta(l, at)));
            prop_assert!(same(&traced.forces, &euler_lagrange::forces(l, at)));
            prop_assert!(same(&[t - u, t + u], &[lagrangian, energy]));
            // the twin: T and U exchanged
            prop_assert!(!same(&[u - t], &[lagrangian]) || lagrangian.abs() < 1e-6);
            Ok(())
        }
        check(&HeavyTop, &top)?;
        check(&Pendulum::<4>::new(), &chain)?;
        check(&Kepler, &planet)?;
    }
}

#[test]
fn a_damped_oscillator_obeys_its_law() {
    let at = some_state::<1, 3>();
    let ([x], [v], [mass, k, gamma]) = (at.q, at.v, at.parameters);
    let a = System::new(&DampedOscillator).unwrap().accelerations(at.time, &[x], &[v], &at.parameters).unwrap()[0];
    assert_abs_diff_eq!(mass * a + mass * gamma * v + k * x, 0.0, epsilon = 1e-13);
    // the twin: without the explicit time dependence there is no damping
    assert!((mass * a + k * x).abs() > 0.1);
}

#[test]
fn many_states_at_once_are_each_as_alone() {
    let system = System::new(&HeavyTop).unwrap();
    for states in [1_usize, 31, 32, 33, 100] {
        let column = |k: f64| (0..states).map(|i| 0.4 + (k * i as f64).sin().abs()).collect::<Vec<_>>();
        let moving: Vec<Vec<f64>> = (1..=6).map(|k| column(k as f64)).collect();
        let parameters = [1.2, 0.7, 0.9, 9.8, 0.4];
        let columns = std::iter::once(&[0.0][..]).chain(moving.iter().map(Vec::as_slice)).chain(parameters.chunks(1));
        let all = system.accelerations_of_many(&columns.collect::<Vec<_>>()).unwrap();
        for i in 0..states {
            let (q, v): (Vec<f64>, Vec<f64>) =
                ((0..3).map(|k| moving[k][i]).collect(), (3..6).map(|k| moving[k][i]).collect());
            let one = system.accelerations(0.0, &q, &v, &parameters).unwrap();
            let many: Vec<f64> = all.iter().map(|column| column[i]).collect();
            assert!(agree(&one, &many, 1e-12), "{one:?} {many:?}");
        }
    }
    assert!(system.accelerations_of_many(&[&[0.0]]).is_err(), "columns are missing");
}

#[test]
fn what_is_not_given_is_no_number() {
    let system = System::new(&HeavyTop).unwrap();
    assert!(system.quantities(0.0_f64, &[1.0], &[], &[]).energy.is_nan());
    assert!(system.euler_lagrange(0.0, &[1.0; 3], &[1.0; 3], &[1.0; 5], &[]).iter().all(|r: &f64| r.is_nan()));
    assert!(system.motion(0.0, &[1.0; 3], &[1.0], &[1.0; 5], 2).is_err());
    assert!(system.hamilton_equations(0.0, &[1.0], &[1.0; 2], &[1.0; 5]).is_err());
    assert!(system.routhian(0.0, &[1.0; 3], &[], &[], &[1.0; 5]).is_err());
    // the twin: the same with all of it is one
    assert!(system.quantities(0.0_f64, &[1.0; 3], &[1.0; 3], &[1.0; 5]).energy.is_finite());
}

#[test]
fn another_lagrangian_of_the_same_coordinates_has_its_own_motion() {
    let pendulum = System::new(&Pendulum::<1>::new()).expect("it can be traced");
    // L = ½ m l² θ̇² − ½ k θ²: a torsion spring, and m l² θ̈ = −k θ
    let spring = pendulum.with_lagrangian("spring", vec!["k".to_owned()], |_, q, v, parameters| {
        let [m, l, _, k] = *parameters else { panic!("m, l, g and k: {parameters:?}") };
        let potential = k * q[0] * q[0] * 0.5;
        (m * l * l * v[0] * v[0] * 0.5 - potential, Some(potential))
    });
    let spring = spring.expect("it can be traced");
    let (q, v, parameters) = ([0.3], [0.7], [2.0, 1.5, 9.8, 4.0]);
    let acceleration = |system: &System| system.accelerations(0.0, &q, &v, &parameters).expect("it has a mass")[0];
    assert_abs_diff_eq!(acceleration(&spring), -4.0 * 0.3 / (2.0 * 1.5 * 1.5), epsilon = 1e-14);
    let found = spring.quantities(0.0, &q, &v, &parameters);
    let (kinetic, potential) = (0.5 * 2.0 * 1.5 * 1.5 * 0.7 * 0.7, 0.5 * 4.0 * 0.3 * 0.3);
    assert_abs_diff_eq!(found.energy, kinetic + potential, epsilon = 1e-14);
    assert_abs_diff_eq!(found.potential.expect("it has one"), potential, epsilon = 1e-14);
    // The twin: the pendulum's own motion is another.
    assert_abs_diff_eq!(acceleration(&pendulum), -9.8 * 0.3_f64.sin() / 1.5, epsilon = 1e-13);
}

#[test]
fn a_top_with_another_lagrangian_is_oriented_as_before() {
    let top = System::new(&HeavyTop).expect("it can be traced");
    let free = top.with_lagrangian("rotor", Vec::new(), |_, _, v, _| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2], None));
    let free = free.expect("it can be traced");
    let (q, v) = ([0.4, 1.1, 0.2], [0.3, -0.5, 0.9]);
    let parameters = vec![1.3; top.parameters().len()];
    let (before, after) = (top.quantities(0.0, &q, &v, &parameters), free.quantities(0.0, &q, &v, &parameters));
    assert_eq!(after.orientation.expect("it has one"), before.orientation.expect("it has one"));
    assert_eq!(after.angular_velocity, before.angular_velocity);
    assert_eq!(after.body_rates, before.body_rates);
    assert!(after.potential.is_none() && before.potential.is_some());
}
