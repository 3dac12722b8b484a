//! Rotation matrices and the angular velocity that follows from them.

use nalgebra::{Matrix3, Rotation3, Vector3};
use onshell::mechanics::rotations::{self, Axis, RotationalState};
use onshell::mechanics::{Lagrangian, System};
use onshell::systems::HeavyTop;
use proptest::prelude::*;

use crate::support::{config, state};

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn rotations_are_those_of_nalgebra(angle in -4.0..4.0_f64) {
        for (axis, unit) in [(Axis::X, Vector3::x_axis()), (Axis::Y, Vector3::y_axis()), (Axis::Z, Vector3::z_axis())] {
            let active = *Rotation3::from_axis_angle(&unit, angle).matrix();
            prop_assert!((rotations::active_rotation(axis, angle) - active).norm() < 1e-15);
            prop_assert!((rotations::passive_rotation(axis, angle) - active.transpose()).norm() < 1e-15);
            // the twin: the two senses differ
            prop_assume!(angle.sin().abs() > 0.1);
            prop_assert!((rotations::passive_rotation(axis, angle) - active).norm() > 0.1);
        }
    }

    #[test]
    fn an_orientation_is_orthogonal_and_turns_as_its_angular_velocity_says(at in state::<3, 5>()) {
        let turning = RotationalState::of(&HeavyTop, &at).unwrap();
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
        let traced = System::new(&HeavyTop).unwrap().quantities(at.time, &at.q, &at.v, &at.parameters);
        prop_assert!((traced.orientation.unwrap() - r).norm() < 1e-14);
        prop_assert!((traced.angular_velocity.unwrap() - turning.angular_velocity).norm() < 1e-13);
        prop_assert!((traced.body_rates.unwrap() - turning.body_rates).norm() < 1e-13);
    }
}
