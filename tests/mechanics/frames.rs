//! Frames that turn: ω comes from Ṙ, and turns the axes.

use nalgebra::Vector3;
use onshell::mechanics::rotations::RotationalState;
use onshell::mechanics::{Frame, State};
use onshell::scalar::Series;
use onshell::systems::FreeRigidBody;
use proptest::prelude::*;

use crate::support::config;

/// A quantity that varies freely: five derivatives of its own, the zeroth included.
fn varying() -> impl Strategy<Value = Series<f64>> {
    [-2.0..2.0, -2.0..2.0, -2.0..2.0, -2.0..2.0, -2.0..2.0].prop_map(|d| Series::from_derivatives(&d))
}

fn vector() -> impl Strategy<Value = Vector3<Series<f64>>> {
    [varying(), varying(), varying()].prop_map(Vector3::from)
}

/// The largest coefficient of a difference, to `orders` derivatives; infinite where one is not known.
fn apart(a: &Vector3<Series<f64>>, b: &Vector3<Series<f64>>, orders: usize) -> f64 {
    let entry = |x: &Series<f64>, k| x.nth_derivative_value(k).unwrap_or(f64::INFINITY);
    (a - b).iter().flat_map(|x| (0..orders).map(move |k| entry(x, k).abs())).fold(0.0, f64::max)
}

fn rate(v: &Vector3<Series<f64>>) -> Vector3<Series<f64>> {
    v.map(|component| component.derivative())
}

fn constant(v: [f64; 3]) -> Vector3<Series<f64>> {
    Vector3::from(v.map(Series::constant))
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn the_axes_turn_with_the_angular_velocity(
        angles in [varying(), varying(), varying()], direction in [0.3..2.0, -2.0..2.0, -2.0..2.0_f64], alpha in varying(),
    ) {
        prop_assume!(angles[1].value().sin().abs() > 0.1 && alpha.nth_derivative_value(1).unwrap().abs() > 0.1);
        for frame in [Frame::from_euler_angles(angles), Frame::about(direction, alpha).unwrap()] {
            let (axes, omega) = (frame.axes(), frame.angular_velocity());
            let (mut right, mut flipped) = (0.0_f64, 0.0_f64);
            for (a, axis) in axes.iter().enumerate() {
                right = right.max(apart(&rate(axis), &omega.cross(axis), 1));
                flipped = flipped.max(apart(&rate(axis), &axis.cross(&omega), 1));
                // the next derivatives too: ω is a series
                prop_assert!(apart(&rate(axis), &omega.cross(axis), 4) < 1e-9);
                // right-handed, orthogonal, of length 1, at all times
                prop_assert!(apart(&axes[(a + 1) % 3].cross(&axes[(a + 2) % 3]), axis, 5) < 1e-9);
            }
            prop_assert!(right < 1e-12, "{right}");
            // the twin: the other sign
            prop_assert!(flipped > 0.01);
            let turning = frame.turning();
            prop_assert!(apart(&turning.angular_velocity, &omega, 4) == 0.0);
            prop_assert!(apart(&turning.body_rates, &frame.body_rates(), 4) == 0.0);
            // Ṙ = [ω×]-like, entry by entry: Ṙ_ab = (ω × êₐ)_b
            for (a, axis) in axes.iter().enumerate() {
                prop_assert!(apart(&frame.rate().row(a).transpose(), &omega.cross(axis), 1) < 1e-12);
            }
        }
    }

    #[test]
    fn about_a_fixed_direction_the_angular_velocity_is_the_rate_of_the_angle_along_it(
        direction in [0.3..2.0, -2.0..2.0, -2.0..2.0_f64], alpha in varying(),
    ) {
        let frame = Frame::about(direction, alpha).unwrap();
        let along = constant(Vector3::from(direction).normalize().into());
        let expected = along.map(|n| n * alpha.derivative());
        // α̇ n̂, and so in all further derivatives; also along the frame's own axes, since n̂ does not turn
        prop_assert!(apart(&frame.angular_velocity(), &expected, 1) < 1e-12);
        prop_assert!(apart(&frame.angular_velocity(), &expected, 4) < 1e-9);
        prop_assert!(apart(&frame.body_rates(), &expected, 4) < 1e-9);
        // the twins: the other way round, and half as fast
        prop_assume!(alpha.nth_derivative_value(1).unwrap().abs() > 0.1);
        prop_assert!(apart(&frame.angular_velocity(), &-expected, 1) > 0.05);
        prop_assert!(apart(&frame.angular_velocity(), &(expected * Series::constant(0.5)), 1) > 0.02);
    }

    #[test]
    fn a_free_frame_is_the_body_of_the_lagrangian(q in [0.3..2.8, 0.3..2.8, 0.3..2.8_f64], v in [-2.0..2.0, -2.0..2.0, -2.0..2.0_f64]) {
        let turning = RotationalState::of(&FreeRigidBody, &State { time: 0.0, q, v, parameters: [1.0; 3] }).unwrap();
        let frame = Frame::from_euler_angles(std::array::from_fn(|i| Series::from_derivatives(&[q[i], v[i]]))).turning();
        prop_assert!((frame.angular_velocity.map(|x| x.value()) - turning.angular_velocity).norm() < 1e-13);
        prop_assert!((frame.body_rates.map(|x| x.value()) - turning.body_rates).norm() < 1e-13);
        prop_assert!((frame.orientation.map(|x| x.value()) - turning.orientation).norm() < 1e-14);
    }

    #[test]
    fn a_vector_changes_by_its_components_and_by_its_axes(angles in [varying(), varying(), varying()], v in vector()) {
        // notes (4.57): dv/dt = v̇ₐ êₐ + ω × v
        let frame = Frame::from_euler_angles(angles);
        let within = frame.vector(&rate(&frame.components(&v)));
        let turning = frame.angular_velocity().cross(&v);
        prop_assert!(apart(&rate(&v), &(within + turning), 1) < 1e-11);
        prop_assert!(apart(&frame.vector(&frame.components(&v)), &v, 5) < 1e-8);
        // the twin: seen from the frame it would be the other sign
        prop_assume!(turning.iter().any(|x| x.value().abs() > 0.1));
        prop_assert!(apart(&rate(&v), &(within - turning), 1) > 0.05);
    }

    #[test]
    fn the_points_of_a_body_keep_their_distances(
        angles in [varying(), varying(), varying()], c in vector(), x in [0.3..2.0, -2.0..2.0, -2.0..2.0_f64],
    ) {
        let frame = Frame::from_euler_angles(angles);
        let point = frame.point_of_a_body(&c, &Vector3::from(x));
        let from_centre = point - c;
        let square = from_centre.dot(&from_centre);
        let expected = Series::constant(Vector3::from(x).norm_squared());
        for k in 0..5 {
            let difference: f64 = (square - expected).nth_derivative_value(k).unwrap();
            prop_assert!(difference.abs() < 1e-9, "order {k}: {difference}");
        }
        // ẋ = ċ + ω × (x − c)
        let omega = frame.angular_velocity();
        prop_assert!(apart(&rate(&point), &(rate(&c) + omega.cross(&from_centre)), 1) < 1e-11);
        // the twin: it does not keep its distance from the origin
        prop_assume!((0..3).any(|i| (c[i].value() * omega[(i + 1) % 3].value()).abs() > 0.5));
        prop_assert!(point.dot(&point).derivative().value().abs() > 1e-9);
        // at angles 0 the components are those in the fixed axes
        let still = Frame::from_euler_angles([Series::constant(0.0); 3]).point_of_a_body(&c, &Vector3::from(x));
        prop_assert!(apart(&still, &(c + constant(x)), 5) < 1e-13);
    }
}

#[test]
fn what_the_angles_do_not_tell_is_not_known() {
    let angle = Series::from_derivatives(&[0.4, 0.5, 0.6]);
    let omega = Frame::about([1.0, 2.0, 3.0], angle).unwrap().angular_velocity();
    assert!(omega.iter().all(|component| component.known() == 2));
    assert!(Frame::from_euler_angles([angle; 3]).body_rates().iter().all(|component| component.known() == 2));
    for nowhere in [[0.0; 3], [f64::NAN, 1.0, 0.0], [f64::INFINITY, 0.0, 0.0]] {
        assert!(Frame::about(nowhere, angle).unwrap_err().message().contains("no direction"));
    }
}
