//! The mechanics: properties that hold at any state, and beside each a twin that must fail.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use nalgebra::{DMatrix, Matrix3, Rotation3, SMatrix, SVector, Vector3};
use num_dual::{Dual2SVec64, hessian};
use onshell::mechanics::legendre::{self, Phase};
use onshell::mechanics::rotations::{self, Axis, Turning};
use onshell::mechanics::{Lagrangian, State, World, euler_lagrange, momenta, motion};
use onshell::scalar::{DualNum, Measured, Number, Series};
use onshell::systems::{DampedOscillator, FreeRigidBody, HeavyTop, Kepler, Pendulum, RelativisticParticle};
use proptest::prelude::*;

// ---------------------------------------------------------------------------------------------------------- states

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// Coordinates away from 0 and π, velocities of both signs, positive parameters.
fn state<const N: usize, const P: usize>() -> impl Strategy<Value = State<f64, N, P>> {
    let (q, v) = (prop::collection::vec(0.3..2.8, N), prop::collection::vec(-2.0..2.0, N));
    let parameters = prop::collection::vec(0.5..2.0, P);
    (0.1..1.0, q, v, parameters).prop_map(|(time, q, v, parameters)| State {
        time,
        q: std::array::from_fn(|i| q[i]),
        v: std::array::from_fn(|i| v[i]),
        parameters: std::array::from_fn(|i| parameters[i]),
    })
}

/// One fixed state, for the twins.
fn some_state<const N: usize, const P: usize>() -> State<f64, N, P> {
    State {
        time: 0.4,
        q: std::array::from_fn(|i| 0.7 + 0.31 * i as f64),
        v: std::array::from_fn(|i| 0.9 - 0.67 * i as f64),
        parameters: std::array::from_fn(|i| 1.3 - 0.17 * i as f64),
    }
}

/// Slower than light: c is the second parameter.
fn slow(mut at: State<f64, 1, 3>) -> State<f64, 1, 3> {
    at.parameters[1] += 2.5;
    at
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, x| x.abs().max(m))
}

fn agree(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    let scale = largest(a).max(largest(b)).max(1e-3);
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance * scale)
}

// ---------------------------------------------------------------------------------------------------- conservation

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

// --------------------------------------------------------------------------------------------------- Euler–Lagrange

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
        let world = World::new(&gauge(true)).unwrap();
        let traced = world.euler_lagrange(at.time, &at.q, &at.v, &at.parameters, &a);
        prop_assert!(plain.iter().zip(&traced).all(|(a, b)| (a - b).abs() < 1e-13 * scale), "{plain:?} {traced:?}");
        // the twin: F itself does change them
        let wrong = euler_lagrange::residuals(&gauge(false), &at, &a);
        prop_assert!(!agree(&plain, &wrong, 1e-6));
    }

    #[test]
    fn the_tape_gives_what_the_plain_hessian_gives(top in state::<3, 5>(), body in state::<3, 3>(), chain in state::<2, 3>()) {
        fn check<L: Lagrangian<N, P>, const N: usize, const P: usize>(
            l: &L, at: &State<f64, N, P>, plain: &[f64],
        ) -> Result<(), TestCaseError> {
            let world = World::new(l).unwrap();
            let tape = world.accelerations(at.time, &at.q, &at.v, &at.parameters).unwrap();
            let pairs = euler_lagrange::accelerations(l, at).unwrap();
            let columns = [&[at.time][..], &at.q, &at.v, &at.parameters].concat();
            let columns: Vec<&[f64]> = columns.chunks(1).collect();
            let block: Vec<f64> = world.accelerations_of_many(&columns).unwrap().concat();
            for other in [&tape[..], &pairs, &block] {
                prop_assert!(agree(plain, other, 1e-12), "{}: {plain:?} {other:?}", l.name());
            }
            Ok(())
        }
        check(&HeavyTop, &top, &by_hessian::<_, 3, 5, 6>(&HeavyTop, &top))?;
        check(&FreeRigidBody, &body, &by_hessian::<_, 3, 3, 6>(&FreeRigidBody, &body))?;
        check(&Pendulum::<2>::new(), &chain, &by_hessian::<_, 2, 3, 4>(&Pendulum::<2>::new(), &chain))?;
        // the twin: other masses, other accelerations
        let mut other = top;
        other.parameters[2] *= 1.001;
        prop_assert!(!agree(&by_hessian::<_, 3, 5, 6>(&HeavyTop, &other), &by_hessian::<_, 3, 5, 6>(&HeavyTop, &top), 1e-12));
    }

    #[test]
    fn what_is_traced_is_what_the_lagrangian_says(top in state::<3, 5>(), chain in state::<4, 3>(), planet in state::<2, 3>()) {
        fn check<L: Lagrangian<N, P>, const N: usize, const P: usize>(
            l: &L, at: &State<f64, N, P>,
        ) -> Result<(), TestCaseError> {
            let traced = World::new(l).unwrap().quantities(at.time, &at.q, &at.v, &at.parameters);
            prop_assert!(agree(&[traced.lagrangian], &[l.lagrangian(at)], 1e-12));
            prop_assert!(agree(&traced.momenta, &momenta::momenta(l, at), 1e-12));
            prop_assert!(agree(&traced.forces, &euler_lagrange::forces(l, at), 1e-12));
            prop_assert!(agree(&[traced.energy], &[momenta::energy(l, at)], 1e-12));
            let (t, u) = (traced.kinetic.unwrap(), traced.potential.unwrap());
            prop_assert!(agree(&[t - u, t + u], &[traced.lagrangian, traced.energy], 1e-12));
            Ok(())
        }
        check(&HeavyTop, &top)?;
        check(&Pendulum::<4>::new(), &chain)?;
        check(&Kepler, &planet)?;
    }
}

/// Accelerations from num-dual's Hessian of all variables, the explicit time dependence left out.
fn by_hessian<L: Lagrangian<N, P>, const N: usize, const P: usize, const X: usize>(
    l: &L,
    at: &State<f64, N, P>,
) -> Vec<f64> {
    let x = SVector::<f64, X>::from_iterator(at.q.into_iter().chain(at.v));
    let (_, gradient, second) = hessian(
        |x: SVector<Dual2SVec64<X>, X>| {
            l.lagrangian(&State {
                time: at.time.into(),
                q: std::array::from_fn(|i| x[i]),
                v: std::array::from_fn(|i| x[N + i]),
                parameters: at.parameters.map(Into::into),
            })
        },
        &x,
    );
    let mass: SMatrix<f64, N, N> = second.fixed_view::<N, N>(N, N).into();
    let mixed: SMatrix<f64, N, N> = second.fixed_view::<N, N>(N, 0).into();
    let right: SVector<f64, N> = gradient.fixed_rows::<N>(0) - mixed * SVector::from(at.v);
    let mass = DMatrix::from_fn(N, N, |i, j| mass[(i, j)]);
    mass.lu().solve(&nalgebra::DVector::from_fn(N, |i, _| right[i])).unwrap().as_slice().to_vec()
}

#[test]
fn a_damped_oscillator_obeys_its_law() {
    let at = some_state::<1, 3>();
    let ([x], [v], [mass, k, gamma]) = (at.q, at.v, at.parameters);
    let a = World::new(&DampedOscillator).unwrap().accelerations(at.time, &[x], &[v], &at.parameters).unwrap()[0];
    assert_abs_diff_eq!(mass * a + mass * gamma * v + k * x, 0.0, epsilon = 1e-13);
    // the twin: without the explicit time dependence there is no damping
    assert!((mass * a + k * x).abs() > 0.1);
}

#[test]
fn many_states_at_once_are_each_as_alone() {
    let world = World::new(&HeavyTop).unwrap();
    for states in [1_usize, 31, 32, 33, 100] {
        let column = |k: f64| (0..states).map(|i| 0.4 + (k * i as f64).sin().abs()).collect::<Vec<_>>();
        let moving: Vec<Vec<f64>> = (1..=6).map(|k| column(k as f64)).collect();
        let parameters = [1.2, 0.7, 0.9, 9.8, 0.4];
        let columns = std::iter::once(&[0.0][..]).chain(moving.iter().map(Vec::as_slice)).chain(parameters.chunks(1));
        let all = world.accelerations_of_many(&columns.collect::<Vec<_>>()).unwrap();
        for i in 0..states {
            let (q, v): (Vec<f64>, Vec<f64>) =
                ((0..3).map(|k| moving[k][i]).collect(), (3..6).map(|k| moving[k][i]).collect());
            let one = world.accelerations(0.0, &q, &v, &parameters).unwrap();
            let many: Vec<f64> = all.iter().map(|column| column[i]).collect();
            assert!(agree(&one, &many, 1e-12), "{one:?} {many:?}");
        }
    }
    assert!(world.accelerations_of_many(&[&[0.0]]).is_err(), "columns are missing");
}

#[test]
fn what_is_not_given_is_no_number() {
    let world = World::new(&HeavyTop).unwrap();
    assert!(world.quantities(0.0_f64, &[1.0], &[], &[]).energy.is_nan());
    assert!(world.euler_lagrange(0.0, &[1.0; 3], &[1.0; 3], &[1.0; 5], &[]).iter().all(|r: &f64| r.is_nan()));
    assert!(world.motion(0.0, &[1.0; 3], &[1.0], &[1.0; 5], 2).is_err());
    assert!(world.hamilton(0.0, &[1.0], &[1.0; 2], &[1.0; 5]).is_err());
    assert!(world.routhian(0.0, &[1.0; 3], &[], &[], &[1.0; 5]).is_err());
    // the twin: the same with all of it is one
    assert!(world.quantities(0.0_f64, &[1.0; 3], &[1.0; 3], &[1.0; 5]).energy.is_finite());
}

// ----------------------------------------------------------------------------------------------- singular and worse

/// Two coordinates, of which L knows only the sum: ½ m (ẋ + ẏ)² + ½ ε ẏ² − ½ x².
struct Degenerate;
impl Lagrangian<2, 2> for Degenerate {
    fn name(&self) -> &str {
        "degenerate"
    }
    fn coordinates(&self) -> [&str; 2] {
        ["x", "y"]
    }
    fn parameters(&self) -> [&str; 2] {
        ["m", "\\epsilon"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 2, 2>) -> D {
        let ([x, _], [u, w], [mass, epsilon]) = (at.q, at.v, at.parameters);
        (mass * (u + w).powi(2) + epsilon * w * w - x * x) * 0.5
    }
}

#[test]
fn a_singular_mass_matrix_is_an_error_with_its_condition_number() {
    let world = World::new(&Degenerate).unwrap();
    let (q, v) = ([0.3, 0.4], [1.0, 2.0]);
    for epsilon in [0.0, 1e-13] {
        let parameters = [1.0, epsilon];
        let at = State { time: 0.0, q, v, parameters };
        let columns: Vec<f64> = [&[0.0][..], &q, &v, &parameters].concat();
        let errors = [
            world.accelerations(0.0, &q, &v, &parameters).unwrap_err(),
            world.motion(0.0, &q, &v, &parameters, 2).unwrap_err(),
            world
                .motion(
                    Measured::new(0.0),
                    &q.map(Measured::new),
                    &v.map(Measured::new),
                    &parameters.map(Measured::new),
                    2,
                )
                .unwrap_err(),
            world.hamiltonian(0.0, &q, &v, &parameters).unwrap_err(),
            world.accelerations_of_many(&columns.chunks(1).collect::<Vec<_>>()).unwrap_err(),
            euler_lagrange::accelerations(&Degenerate, &at).unwrap_err(),
            legendre::hamiltonian(&Degenerate, &Phase { time: 0.0, q, p: v, parameters }).unwrap_err(),
        ];
        for error in errors {
            assert!(error.message().contains("condition number"), "{error}");
        }
    }
    // the twin: with a mass of its own each velocity is determined
    assert!(world.motion(0.0, &q, &v, &[1.0, 0.5], 2).is_ok());
    // the first derivative is given, not solved for
    assert!(world.motion(0.0, &q, &v, &[1.0, 0.0], 1).is_ok());
    assert!(world.motion(0.0, &q, &v, &[1.0, 0.5], 6).is_err(), "beyond the series");
    assert!(world.motion(0.0, &q, &v, &[f64::NAN, 0.5], 2).unwrap_err().message().contains("not finite"));
}

#[test]
fn elimination_without_exchange_is_not_trusted_blindly() {
    /// L = ẋ ẏ − x²: M = ((0, 1), (1, 0)) is regular, yet its first pivot is 0.
    struct Crossed;
    impl Lagrangian<2, 0> for Crossed {
        fn name(&self) -> &str {
            "crossed"
        }
        fn coordinates(&self) -> [&str; 2] {
            ["x", "y"]
        }
        fn parameters(&self) -> [&str; 0] {
            []
        }
        fn lagrangian<D: Number>(&self, at: &State<D, 2, 0>) -> D {
            at.v[0] * at.v[1] - at.q[0] * at.q[0]
        }
    }
    let columns: [&[f64]; 5] = [&[0.0], &[0.5, 0.7], &[0.1], &[0.2], &[0.3]];
    let a = World::new(&Crossed).unwrap().accelerations_of_many(&columns).unwrap();
    assert_eq!(a, [vec![0.0, 0.0], vec![-1.0, -1.4]]);
}

#[test]
fn a_branch_on_a_value_is_an_error_that_names_the_system() {
    struct Branching;
    impl Lagrangian<1, 0> for Branching {
        fn name(&self) -> &str {
            "branching"
        }
        fn coordinates(&self) -> [&str; 1] {
            ["x"]
        }
        fn parameters(&self) -> [&str; 0] {
            []
        }
        fn lagrangian<D: Number>(&self, at: &State<D, 1, 0>) -> D {
            at.v[0] * at.v[0] - at.q[0].abs()
        }
    }
    let error = World::new(&Branching).err().unwrap();
    assert!(error.message().contains("branching") && error.message().contains("cannot be traced"), "{error}");
}

// --------------------------------------------------------------------------------------------------------- Legendre

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn the_legendre_transform_is_an_involution(chain in state::<2, 3>(), particle in state::<1, 3>().prop_map(slow)) {
        let again = legendre::lagrangian_again(&Pendulum::<2>::new(), &chain).unwrap();
        prop_assert!(agree(&[again], &[Pendulum::<2>::new().lagrangian(&chain)], 1e-10));
        let again = legendre::lagrangian_again(&RelativisticParticle, &particle).unwrap();
        prop_assert!(agree(&[again], &[RelativisticParticle.lagrangian(&particle)], 1e-10));
        // the twin: transformed once it is something else
        prop_assert!(!agree(&[momenta::energy(&RelativisticParticle, &particle)], &[again], 1e-3));
    }

    #[test]
    fn hamiltons_equations_are_those_of_euler_and_lagrange(
        top in state::<3, 5>(), chain in state::<2, 3>(), particle in state::<1, 3>().prop_map(slow), damped in state::<1, 3>(),
    ) {
        fn check<L: Lagrangian<N, P>, const N: usize, const P: usize>(
            l: &L, at: &State<f64, N, P>,
        ) -> Result<(), TestCaseError> {
            let world = World::new(l).unwrap();
            let p = world.quantities(at.time, &at.q, &at.v, &at.parameters).momenta;
            let (q_rate, p_rate) = world.hamilton(at.time, &at.q, &p, &at.parameters).unwrap();
            prop_assert!(agree(&q_rate, &at.v, 1e-10), "{}: {q_rate:?} {:?}", l.name(), at.v);
            // ṗ along the motion that obeys the Euler–Lagrange equations
            let q = world.motion(at.time, &at.q, &at.v, &at.parameters, 2).unwrap();
            let v: Vec<_> = q.iter().map(Series::derivative).collect();
            let parameters = at.parameters.map(Series::constant);
            let p = world.quantities(Series::time(at.time), &q, &v, &parameters).momenta;
            let on_shell: Vec<f64> = p.iter().map(|p| p.nth_derivative_value(1).unwrap()).collect();
            prop_assert!(agree(&p_rate, &on_shell, 1e-10), "{}: {p_rate:?} {on_shell:?}", l.name());
            // the untraced functions say the same
            let phase = Phase { time: at.time, q: at.q, p: std::array::from_fn(|i| p[i].value()), parameters: at.parameters };
            let (q_again, p_again) = legendre::hamilton(l, &phase).unwrap();
            prop_assert!(agree(&q_again, &q_rate, 1e-10) && agree(&p_again, &p_rate, 1e-10));
            // the twin: ṗ = +∂H/∂q
            let wrong: Vec<f64> = p_rate.iter().map(|p| -p).collect();
            prop_assert!(!agree(&wrong, &on_shell, 1e-6));
            Ok(())
        }
        check(&HeavyTop, &top)?;
        check(&Pendulum::<2>::new(), &chain)?;
        check(&RelativisticParticle, &particle)?;
        check(&DampedOscillator, &damped)?;
    }
}

#[test]
fn the_relativistic_hamiltonian_is_the_one_of_the_textbooks() {
    let [mass, c, k] = [1.3, 2.0, 0.7];
    for p in [-40.0, -3.0, 0.0, 0.01, 1.0, 25.0_f64] {
        let world = World::new(&RelativisticParticle).unwrap();
        let h: f64 = world.hamiltonian(0.0, &[0.4], &[p], &[mass, c, k]).unwrap();
        let expected = (mass * mass * c.powi(4) + p * p * c * c).sqrt() + 0.5 * k * 0.16;
        assert_relative_eq!(h, expected, max_relative = 1e-12);
    }
}

#[test]
fn the_effective_potential_is_the_energy_without_the_motion_that_is_left() {
    let at = some_state::<3, 5>();
    let world = World::new(&HeavyTop).unwrap();
    let u = world.effective_potential(at.time, &at.q, &at.v, &at.parameters).unwrap();
    let energy = world.quantities(at.time, &at.q, &at.v, &at.parameters).energy;
    let mass = world.mass_matrix(at.time, &at.q, &at.v, &at.parameters)[(1, 1)];
    assert_relative_eq!(u, energy - 0.5 * mass * at.v[1] * at.v[1], max_relative = 1e-12);
    // the twin: the energy with cyclic velocities held instead of momenta, at another θ
    let mut moved = at;
    moved.q[1] += 0.3;
    let p = world.quantities(at.time, &at.q, &at.v, &at.parameters).momenta;
    let held: f64 = world.routhian(moved.time, &moved.q, &[0.0; 3], &p, &moved.parameters).unwrap();
    let free: f64 = world.effective_potential(moved.time, &moved.q, &moved.v, &moved.parameters).unwrap();
    assert!((held - free).abs() > 1e-3);
    // a planet: p²/2mr² − GMm/r
    let (planet, kepler) = (some_state::<2, 3>(), World::new(&Kepler).unwrap());
    let ([r, _], [_, rate], [m, sun, gravity]) = (planet.q, planet.v, planet.parameters);
    let angular = m * r * r * rate;
    let u = kepler.effective_potential(planet.time, &planet.q, &planet.v, &planet.parameters).unwrap();
    assert_relative_eq!(u, angular * angular / (2.0 * m * r * r) - gravity * sun * m / r, max_relative = 1e-12);
}

// --------------------------------------------------------------------------------------------------------- rotations

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn rotations_are_those_of_nalgebra(angle in -4.0..4.0_f64) {
        for (axis, unit) in [(Axis::X, Vector3::x_axis()), (Axis::Y, Vector3::y_axis()), (Axis::Z, Vector3::z_axis())] {
            let active = *Rotation3::from_axis_angle(&unit, angle).matrix();
            prop_assert!((rotations::of_the_vectors(axis, angle) - active).norm() < 1e-15);
            prop_assert!((rotations::of_the_axes(axis, angle) - active.transpose()).norm() < 1e-15);
            // the twin: the two senses differ
            prop_assume!(angle.sin().abs() > 0.1);
            prop_assert!((rotations::of_the_axes(axis, angle) - active).norm() > 0.1);
        }
    }

    #[test]
    fn an_orientation_is_orthogonal_and_turns_as_its_angular_velocity_says(at in state::<3, 5>()) {
        let turning = Turning::of(&HeavyTop, &at).unwrap();
        let r = turning.orientation;
        prop_assert!((r.transpose() * r - Matrix3::identity()).norm() < 1e-14);
        prop_assert!((r.determinant() - 1.0).abs() < 1e-14);
        let (_, rate) = rotations::value_and_rate(&HeavyTop.orientation(&at.moving()).unwrap());
        let (mut right, mut flipped) = (0.0, 0.0);
        for a in 0..3 {
            let (axis, change) = (r.row(a).transpose(), rate.row(a).transpose());
            right += (change - turning.angular_velocity.cross(&axis)).norm();
            flipped += (change + turning.angular_velocity.cross(&axis)).norm();
        }
        prop_assert!(right < 1e-13);
        // the twin: the other sign is noticed
        prop_assert!(flipped > 0.1 * turning.angular_velocity.norm());
        // notes (5.66): ω_a = ½ ε_abc Ṙ_bd R_cd
        let contraction = |b: usize, c: usize| (0..3).map(|d| rate[(b, d)] * r[(c, d)]).sum::<f64>();
        for (a, b, c) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            let notes = 0.5 * (contraction(b, c) - contraction(c, b));
            prop_assert!((notes - turning.body_rates[a]).abs() < 1e-13);
        }
        let traced = World::new(&HeavyTop).unwrap().quantities(at.time, &at.q, &at.v, &at.parameters);
        prop_assert!((traced.orientation.unwrap() - r).norm() < 1e-14);
        prop_assert!((traced.angular_velocity.unwrap() - turning.angular_velocity).norm() < 1e-13);
        prop_assert!((traced.body_rates.unwrap() - turning.body_rates).norm() < 1e-13);
    }
}

// ------------------------------------------------------------------------------------------------------------ motion

/// The classical Runge–Kutta method on the accelerations alone.
fn integrated(world: &World, q: [f64; 3], v: [f64; 3], parameters: &[f64], duration: f64) -> Vec<f64> {
    const STEPS: usize = 400;
    let h = duration / STEPS as f64;
    let slope = |x: &[f64]| {
        let (q, v) = x.split_at(3);
        [v, &world.accelerations(0.0, q, v, parameters).unwrap()].concat()
    };
    let moved = |x: &[f64], k: &[f64], h: f64| x.iter().zip(k).map(|(x, k)| x + h * k).collect::<Vec<_>>();
    let mut x = [q, v].concat();
    for _ in 0..STEPS {
        let k1 = slope(&x);
        let k2 = slope(&moved(&x, &k1, h / 2.0));
        let k3 = slope(&moved(&x, &k2, h / 2.0));
        let k4 = slope(&moved(&x, &k3, h));
        for i in 0..6 {
            x[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    x
}

#[test]
fn the_taylor_series_of_the_top_follows_the_integrated_motion() {
    let world = World::new(&HeavyTop).unwrap();
    let (q, v, parameters) = ([0.3, 0.8, 1.1], [0.5, -0.4, 2.0], [1.2, 0.7, 0.9, 3.8, 0.4]);
    let error = |parameters: &[f64; 5], duration: f64| {
        let series = world.motion(0.0, &q, &v, parameters, 5).unwrap();
        let taylor: Vec<f64> = series
            .iter()
            .map(|q| {
                let mut factorial = 1.0;
                (0..6)
                    .map(|k| {
                        factorial *= (k as f64).max(1.0);
                        q.nth_derivative_value(k).unwrap() / factorial * duration.powi(k as i32)
                    })
                    .sum()
            })
            .collect();
        let x = integrated(&world, q, v, &[1.2, 0.7, 0.9, 3.8, 0.4], duration);
        taylor.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    // what is left out is of sixth order: at half the time a 64th
    let (long, short) = (error(&parameters, 0.2), error(&parameters, 0.1));
    assert!(long < 1e-3 && short < long / 40.0, "{long} {short}");
    // the twin: gravity turned upside down is noticed at once
    assert!(error(&[1.2, 0.7, 0.9, -3.8, 0.4], 0.1) > 1e3 * short);
}

#[test]
fn the_generic_motion_is_the_traced_one() {
    let at = some_state::<3, 5>();
    let generic = motion::motion(&HeavyTop, &at, 4).unwrap();
    let traced = World::new(&HeavyTop).unwrap().motion(at.time, &at.q, &at.v, &at.parameters, 4).unwrap();
    for (a, b) in generic.iter().zip(&traced) {
        for k in 0..=4 {
            let (a, b) = (a.nth_derivative_value(k).unwrap(), b.nth_derivative_value(k).unwrap());
            assert_relative_eq!(a, b, max_relative = 1e-10, epsilon = 1e-10);
        }
        assert_eq!(a.nth_derivative_value(5), None);
    }
}

#[test]
fn a_rate_off_shell_takes_the_accelerations_it_is_given() {
    struct Speed;
    impl motion::Observable<1, 3> for Speed {
        fn value<D: Number>(&self, at: &State<D, 1, 3>) -> D {
            at.v[0] * at.v[0] + at.q[0] * at.time
        }
    }
    let at = some_state::<1, 3>();
    let off_shell = motion::rate(&Speed, &at, &[5.0]);
    assert_relative_eq!(off_shell, 2.0 * at.v[0] * 5.0 + at.v[0] * at.time + at.q[0], max_relative = 1e-15);
    let a = euler_lagrange::accelerations(&DampedOscillator, &at).unwrap();
    let on_shell = motion::rate_on_shell(&DampedOscillator, &Speed, &at).unwrap();
    assert_eq!(on_shell, motion::rate(&Speed, &at, &a));
    assert!((on_shell - off_shell).abs() > 0.1);
}
