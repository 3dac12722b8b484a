//! Singular mass matrices and branching Lagrangians are errors that say so.

use onshell::mechanics::legendre::{self, PhasePoint};
use onshell::mechanics::{Lagrangian, State, System, euler_lagrange};
use onshell::scalar::{Number, RunningError};

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
    let system = System::new(&Degenerate).unwrap();
    let (q, v) = ([0.3, 0.4], [1.0, 2.0]);
    for epsilon in [0.0, 1e-13] {
        let parameters = [1.0, epsilon];
        let at = State { time: 0.0, q, v, parameters };
        let errors = [
            system.accelerations(0.0, &q, &v, &parameters).unwrap_err(),
            system.motion(0.0, &q, &v, &parameters, 2).unwrap_err(),
            system
                .motion(
                    RunningError::new(0.0),
                    &q.map(RunningError::new),
                    &v.map(RunningError::new),
                    &parameters.map(RunningError::new),
                    2,
                )
                .unwrap_err(),
            system.hamiltonian(0.0, &q, &v, &parameters).unwrap_err(),
            euler_lagrange::accelerations(&Degenerate, &at).unwrap_err(),
            legendre::hamiltonian(&Degenerate, &PhasePoint { time: 0.0, q, p: v, parameters }).unwrap_err(),
        ];
        for error in errors {
            assert!(error.message().contains("condition number"), "{error}");
        }
    }
    // Traced, the mass matrix is (m, m; m, m + ε), and what the second pivot is, ε, is known to all its digits.
    let of_many = |epsilon: f64| {
        let columns = [0.0, q[0], q[1], v[0], v[1], 1.0, epsilon];
        system.accelerations_of_many(&columns.chunks(1).collect::<Vec<_>>())
    };
    assert!(of_many(0.0).unwrap_err().message().contains("condition number"));
    let [x, y] = of_many(1e-13).unwrap().concat()[..] else { panic!("two accelerations") };
    assert!((1e-13 * y / q[0] - 1.0).abs() < 1e-15 && (x + y + q[0]).abs() < 1e-15 * y, "{x} {y}");
    // the twin: with a mass of its own each velocity is determined
    assert!(system.motion(0.0, &q, &v, &[1.0, 0.5], 2).is_ok());
    // the first derivative is given, not solved for
    assert!(system.motion(0.0, &q, &v, &[1.0, 0.0], 1).is_ok());
    assert!(system.motion(0.0, &q, &v, &[1.0, 0.5], 6).is_err(), "beyond the series");
    assert!(system.motion(0.0, &q, &v, &[f64::NAN, 0.5], 2).unwrap_err().message().contains("not finite"));
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
    let a = System::new(&Crossed).unwrap().accelerations_of_many(&columns).unwrap();
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
    let error = System::new(&Branching).err().unwrap();
    assert!(error.message().contains("branching") && error.message().contains("cannot be traced"), "{error}");
}
