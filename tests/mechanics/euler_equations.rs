//! Euler's equations two ways, from the Lagrangian's motion and from the torque dL/dt; and the motion near a principal
//! axis.

use nalgebra::{Matrix3, Vector3};
use num_dual::Dual64;
use onshell::mechanics::rotations::RotationalState;
use onshell::mechanics::{Frame, Lagrangian, State, motion};
use onshell::scalar::{Number, Series};
use onshell::systems::FreeRigidBody;
use proptest::prelude::*;

use crate::support::{config, state};

type Vector = Vector3<Series<f64>>;

fn rate(v: &Vector) -> Vector {
    v.map(|component| component.derivative())
}

/// L = Σ λₐ ωₐ êₐ in the fixed axes.
fn angular_momentum(frame: &Frame<f64>, moments: [f64; 3]) -> Vector {
    let rates = frame.body_rates();
    frame.vector(&Vector3::from_fn(|a, _| rates[a] * moments[a]))
}

/// λ₁ ω̇₁ ± (λ₃ − λ₂) ω₂ ω₃ and the two that follow by 1 → 2 → 3 → 1; the notes' (4.59) have the plus sign.
fn euler(frame: &Frame<f64>, moments: [f64; 3], sign: f64) -> Vector3<f64> {
    let omega = frame.body_rates();
    Vector3::from_fn(|a, _| {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        let gyroscopic = omega[b] * omega[c] * (moments[c] - moments[b]);
        (omega[a].derivative() * moments[a] + gyroscopic * sign).value()
    })
}

/// The motion of a free body through a state, as a frame: angles to the fourth derivative.
fn free_motion<D: Number>(at: &State<D, 3, 3>) -> Frame<D> {
    Frame::from_euler_angles(motion::motion(&FreeRigidBody, at, 4).unwrap())
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn a_free_body_obeys_eulers_equations(at in state::<3, 3>()) {
        let frame = free_motion(&at);
        let momentum = angular_momentum(&frame, at.parameters);
        let scale = 1.0 + momentum.map(|x| x.value()).norm_squared() + at.v.iter().map(|v| v * v).sum::<f64>();
        // in the fixed axes L stays, and its next derivatives are 0 too
        for component in momentum.iter() {
            prop_assert!(component.nth_derivative_value(1).unwrap().abs() < 1e-12 * scale);
            prop_assert!(component.nth_derivative_value(2).unwrap().abs() < 1e-11 * scale * scale);
        }
        prop_assert!(euler(&frame, at.parameters, 1.0).norm() < 1e-12 * scale);
        // the twins: the other sign; and in the body's own axes L does not stay
        let [one, two, three] = at.parameters;
        let omega = frame.body_rates().map(|x| x.value());
        prop_assume!((omega.x * omega.y * (two - one)).abs() > 0.1 && (three - two).abs() > 0.1);
        prop_assert!(euler(&frame, at.parameters, -1.0).norm() > 0.1);
        prop_assert!(rate(&frame.components(&momentum)).iter().any(|x| x.value().abs() > 0.05));
    }

    #[test]
    fn the_torque_has_the_components_that_euler_says(
        angles in prop::collection::vec([0.3..2.8, -2.0..2.0, -2.0..2.0, -2.0..2.0_f64], 3),
        moments in [0.5..2.0, 0.5..2.0, 0.5..2.0_f64],
    ) {
        // off shell: any torque
        let frame = Frame::from_euler_angles(std::array::from_fn(|i| Series::from_derivatives(&angles[i])));
        let torque = rate(&angular_momentum(&frame, moments));
        let along = frame.components(&torque).map(|x| x.value());
        let scale = 1.0 + along.norm();
        prop_assert!((along - euler(&frame, moments, 1.0)).norm() < 1e-12 * scale);
        // notes (4.58): in the frame, L̇ + ω × L = N
        let momentum = angular_momentum(&frame, moments);
        let within = frame.vector(&rate(&frame.components(&momentum)));
        let sum = within + frame.angular_velocity().cross(&momentum);
        prop_assert!((sum - torque).map(|x| x.value()).norm() < 1e-12 * scale);
        // the twins
        let omega = frame.body_rates().map(|x| x.value());
        prop_assume!((omega.x * omega.y * (moments[1] - moments[0])).abs() > 0.1);
        prop_assert!((along - euler(&frame, moments, -1.0)).norm() > 0.1);
        prop_assert!((within - torque).map(|x| x.value()).norm() > 0.05);
    }
}

// ------------------------------------------------------------------------------------- rotation about a principal axis

const ANGLES: [f64; 3] = [0.4, 1.1, 0.7];

/// The state with given ωₐ along the body's axes: ω is linear in the velocities.
fn with_rates<D: Number>(rates: Vector3<D>, parameters: [f64; 3]) -> State<D, 3, 3> {
    let mut at =
        State { time: D::zero(), q: ANGLES.map(D::from), v: [D::zero(); 3], parameters: parameters.map(D::from) };
    let column = |i: usize| {
        let mut unit = at;
        unit.v[i] = D::one();
        RotationalState::of(&FreeRigidBody, &unit).unwrap().body_rates
    };
    let columns: [Vector3<D>; 3] = std::array::from_fn(column);
    // Cramer's rule
    let determinant = columns[0].dot(&columns[1].cross(&columns[2]));
    at.v = std::array::from_fn(|i| columns[(i + 1) % 3].cross(&columns[(i + 2) % 3]).dot(&rates) / determinant);
    at
}

/// (λ₃ − λ₁)(λ₂ − λ₁) ω₁² / (λ₂ λ₃): the notes' (4.62).
fn frequency_squared([one, two, three]: [f64; 3], spin: f64) -> f64 {
    (three - one) * (two - one) * spin * spin / (two * three)
}

/// ω₁ of order one, ω₂ and ω₃ of order ε: what is left of the first of (4.60) and of (4.61) with a given Ω².
fn left_over(small: f64, moments: [f64; 3], omega_squared: f64) -> (f64, f64) {
    let frame = free_motion(&with_rates(Vector3::new(1.3, 0.7 * small, -0.9 * small), moments));
    let omega = frame.body_rates();
    let second = omega[1].derivative().derivative() + omega[1] * omega_squared;
    ((omega[0].derivative() * moments[0]).value().abs(), second.value().abs())
}

#[test]
fn what_the_linearised_equations_leave_out_is_of_higher_order() {
    for moments in [[0.6, 1.1, 1.9], [1.1, 0.6, 1.9], [1.9, 0.6, 1.1]] {
        let exponent = |omega_squared| {
            let (coarse, fine) = (left_over(0.01, moments, omega_squared), left_over(0.005, moments, omega_squared));
            ((coarse.0 / fine.0).log2(), (coarse.1 / fine.1).log2())
        };
        let omega_squared = frequency_squared(moments, 1.3);
        let (first, second) = exponent(omega_squared);
        assert!((first - 2.0).abs() < 1e-6, "λ₁ω̇₁ is of second order: {first}");
        // ω₁ varies by ε², so what multiplies ω₂ of order ε leaves a third order
        assert!((second - 3.0).abs() < 1e-3, "(4.61) holds to third order: {second}");
        // the twin: with another coefficient what is left is of first order
        let (_, wrong) = exponent(1.3 * omega_squared);
        assert!((wrong - 1.0).abs() < 0.01, "{wrong}");
    }
}

#[test]
fn the_frequency_near_a_principal_axis_is_an_eigenvalue_of_the_linearised_motion() {
    // ω̇ as a function of ω, by the Lagrangian alone, and its derivatives at steady rotation about ê₁
    let (spin, mut stable) = (1.3, Vec::new());
    for moments in [[0.6, 1.1, 1.9], [1.1, 0.6, 1.9], [1.9, 0.6, 1.1]] {
        let mut jacobian = Matrix3::zeros();
        for b in 0..3 {
            let mut rates = Vector3::new(spin, 0.0, 0.0).map(Dual64::from_re);
            rates[b].eps = 1.0;
            let change = free_motion(&with_rates(rates, moments)).body_rates();
            for a in 0..3 {
                let change: Dual64 = change[a].derivative().value();
                assert!(change.re.abs() < 1e-13, "the rotation about a principal axis is steady");
                jacobian[(a, b)] = change.eps;
            }
        }
        let omega_squared = frequency_squared(moments, spin);
        // one 0 for ω₁ itself, and two with square −Ω²: oscillation if Ω² > 0, growth if not
        let mut squares: Vec<f64> = jacobian.complex_eigenvalues().iter().map(|value| (value * value).re).collect();
        squares.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        assert!(squares[0].abs() < 1e-12, "{squares:?}");
        assert!(
            squares[1..].iter().all(|square| (square + omega_squared).abs() < 1e-12),
            "{squares:?} {omega_squared}"
        );
        // the twin: Ω² with the moments in other places
        let [one, two, three] = moments;
        assert!((squares[1] + frequency_squared([two, one, three], spin)).abs() > 0.1);
        stable.push(omega_squared > 0.0);
    }
    // stable about the smallest and the largest moment, not about the one between
    assert_eq!(stable, [true, false, true]);
}

#[test]
fn the_state_with_given_rates_has_them() {
    let rates = Vector3::new(0.3, -0.8, 1.7);
    let at = with_rates(rates, [0.6, 1.1, 1.9]);
    assert!((RotationalState::of(&FreeRigidBody, &at).unwrap().body_rates - rates).norm() < 1e-14);
    let energy = FreeRigidBody.lagrangian(&at);
    let expected: f64 = (0..3).map(|a| 0.5 * at.parameters[a] * rates[a] * rates[a]).sum();
    assert!((energy - expected).abs() < 1e-13);
}
