//! The Legendre transform, Hamilton's equations, the effective potential.

use approx::assert_relative_eq;
use onshell::mechanics::legendre::{self, PhasePoint};
use onshell::mechanics::{Lagrangian, State, System, momenta};
use onshell::scalar::Series;
use onshell::systems::{DampedOscillator, HeavyTop, Kepler, Pendulum, RelativisticParticle};
use proptest::prelude::*;

use crate::support::{agree, config, slow, some_state, state};

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn the_legendre_transform_is_an_involution(chain in state::<2, 3>(), particle in state::<1, 3>().prop_map(slow)) {
        let again = legendre::lagrangian_from_hamiltonian(&Pendulum::<2>::new(), &chain).unwrap();
        prop_assert!(agree(&[again], &[Pendulum::<2>::new().lagrangian(&chain)], 1e-10));
        let again = legendre::lagrangian_from_hamiltonian(&RelativisticParticle, &particle).unwrap();
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
            let system = System::new(l).unwrap();
            let p = system.quantities(at.time, &at.q, &at.v, &at.parameters).momenta;
            let (q_rate, p_rate) = system.hamilton_equations(at.time, &at.q, &p, &at.parameters).unwrap();
            prop_assert!(agree(&q_rate, &at.v, 1e-10), "{}: {q_rate:?} {:?}", l.name(), at.v);
            // ṗ along the motion that obeys the Euler–Lagrange equations
            let q = system.motion(at.time, &at.q, &at.v, &at.parameters, 2).unwrap();
            let v: Vec<_> = q.iter().map(Series::derivative).collect();
            let parameters = at.parameters.map(Series::constant);
            let p = system.quantities(Series::time(at.time), &q, &v, &parameters).momenta;
            let on_shell: Vec<f64> = p.iter().map(|p| p.nth_derivative_value(1).unwrap()).collect();
            prop_assert!(agree(&p_rate, &on_shell, 1e-10), "{}: {p_rate:?} {on_shell:?}", l.name());
            // the untraced functions say the same
            let phase = PhasePoint { time: at.time, q: at.q, p: std::array::from_fn(|i| p[i].value()), parameters: at.parameters };
            let (q_again, p_again) = legendre::hamilton_equations(l, &phase).unwrap();
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
        let system = System::new(&RelativisticParticle).unwrap();
        let h: f64 = system.hamiltonian(0.0, &[0.4], &[p], &[mass, c, k]).unwrap();
        let expected = (mass * mass * c.powi(4) + p * p * c * c).sqrt() + 0.5 * k * 0.16;
        assert_relative_eq!(h, expected, max_relative = 1e-12);
    }
}

#[test]
fn the_effective_potential_is_the_energy_without_the_motion_that_is_left() {
    let at = some_state::<3, 5>();
    let system = System::new(&HeavyTop).unwrap();
    let u = system.effective_potential(at.time, &at.q, &at.v, &at.parameters).unwrap();
    let energy = system.quantities(at.time, &at.q, &at.v, &at.parameters).energy;
    let mass = system.mass_matrix(at.time, &at.q, &at.v, &at.parameters)[(1, 1)];
    assert_relative_eq!(u, energy - 0.5 * mass * at.v[1] * at.v[1], max_relative = 1e-12);
    // the twin: the energy with cyclic velocities held instead of momenta, at another θ
    let mut moved = at;
    moved.q[1] += 0.3;
    let p = system.quantities(at.time, &at.q, &at.v, &at.parameters).momenta;
    let held: f64 = system.routhian(moved.time, &moved.q, &[0.0; 3], &p, &moved.parameters).unwrap();
    let free: f64 = system.effective_potential(moved.time, &moved.q, &moved.v, &moved.parameters).unwrap();
    assert!((held - free).abs() > 1e-3);
    // a planet: p²/2mr² − GMm/r
    let (planet, kepler) = (some_state::<2, 3>(), System::new(&Kepler).unwrap());
    let ([r, _], [_, rate], [m, sun, gravity]) = (planet.q, planet.v, planet.parameters);
    let angular = m * r * r * rate;
    let u = kepler.effective_potential(planet.time, &planet.q, &planet.v, &planet.parameters).unwrap();
    assert_relative_eq!(u, angular * angular / (2.0 * m * r * r) - gravity * sun * m / r, max_relative = 1e-12);
}
