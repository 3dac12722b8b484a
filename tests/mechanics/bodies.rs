//! Centres of mass, inertia tensors and principal axes.

use approx::assert_relative_eq;
use nalgebra::{Matrix3, Rotation3, Vector3};
use num_dual::Dual64;
use onshell::mechanics::inertia::{centre_of_mass, inertia_tensor, kinetic_energy, principal_axes};
use onshell::mechanics::{Body, Nodes};
use proptest::prelude::*;

use crate::support::config;

fn particles() -> impl Strategy<Value = Nodes<f64>> {
    let particle = ([-2.0..2.0, -2.0..2.0, -2.0..2.0_f64], 0.3..3.0).prop_map(|(r, m)| (Vector3::from(r), m));
    prop::collection::vec(particle, 3..6).prop_map(|points| Nodes { points })
}

fn point() -> impl Strategy<Value = Vector3<f64>> {
    [0.3..2.0, -2.0..-0.3, 0.3..2.0_f64].prop_map(Vector3::from)
}

/// A uniform body of a mass.
fn of_mass(body: Body<f64>, mass: f64) -> Nodes<f64> {
    let nodes = body.nodes(5);
    let density = mass / nodes.total();
    nodes.with_density(|_| density)
}

/// d²δ_ab − d_a d_b.
fn across(d: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(d.norm_squared()) - d * d.transpose()
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn the_tensor_is_the_sum_over_the_particles(body in particles(), omega in point()) {
        // notes (3.48): I_ab = Σ m (r² δ_ab − r_a r_b)
        let tensor = inertia_tensor(&body);
        let sum: Matrix3<f64> = body.points.iter().map(|(r, m)| across(r) * *m).sum();
        prop_assert!((tensor - sum).norm() < 1e-13 * sum.norm());
        // (3.51): T = ½ ω·I ω, at any ω
        let energy = kinetic_energy(&body, &omega);
        prop_assert!((energy - 0.5 * omega.dot(&(tensor * omega))).abs() < 1e-12 * energy);
        // the twin: the products of inertia have a minus sign
        let wrong: Matrix3<f64> = body.points.iter().map(|(r, m)| across(r).abs() * *m).sum();
        prop_assume!(sum.iter().any(|entry| *entry < -0.1));
        prop_assert!((tensor - wrong).norm() > 0.1);
    }

    #[test]
    fn steiner_parallel_axes(body in particles(), d in point()) {
        let centre = centre_of_mass(&body).unwrap();
        let about_centre = body.clone().moved(&-centre);
        prop_assert!(centre_of_mass(&about_centre).unwrap().norm() < 1e-14);
        let mass = body.total();
        // about a point d away from the centre: I + M (d² δ − d d)
        let (away, middle) = (inertia_tensor(&about_centre.clone().moved(&d)), inertia_tensor(&about_centre));
        prop_assert!((away - middle - across(&d) * mass).norm() < 1e-12 * away.norm());
        prop_assert!((inertia_tensor(&body) - middle - across(&centre) * mass).norm() < 1e-12 * away.norm());
        // the twins: the other sign; and from a point that is not the centre
        prop_assert!((away - middle + across(&d) * mass).norm() > 0.1 * mass);
        let further = inertia_tensor(&about_centre.moved(&(d * 2.0)));
        prop_assert!((further - away - across(&d) * mass).norm() > 0.1 * mass);
    }

    #[test]
    fn principal_axes_make_the_tensor_diagonal(body in particles(), angles in [-3.0..3.0, -3.0..3.0, -3.0..3.0_f64]) {
        let tensor = inertia_tensor(&body);
        let principal = principal_axes(&tensor).unwrap();
        let (r, [one, two, three]) = (principal.axes, principal.moments);
        let diagonal = Matrix3::from_diagonal(&Vector3::from(principal.moments));
        prop_assert!((r * tensor * r.transpose() - diagonal).norm() < 1e-12 * tensor.norm());
        prop_assert!((r * r.transpose() - Matrix3::identity()).norm() < 2e-15 && r.determinant() > 0.0);
        prop_assert!(one <= two && two <= three && three <= (one + two) * (1.0 + 1e-12));
        for a in 0..2 {
            prop_assert!(r.row(a).max() >= r.row(a).amax() - 1e-9, "the largest component is positive: {r}");
        }
        // a body that is turned has a tensor that is turned, and the same moments
        let q = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let turned = inertia_tensor(&body.turned(q.matrix()));
        prop_assert!((turned - q.matrix() * tensor * q.matrix().transpose()).norm() < 1e-12 * tensor.norm());
        let again = principal_axes(&turned).unwrap();
        prop_assert!((Vector3::from(again.moments) - Vector3::from(principal.moments)).norm() < 1e-12 * tensor.norm());
        // the twin: the transposed axes do not
        prop_assume!((r - Matrix3::identity()).norm() > 0.5 && one < 0.8 * two && two < 0.8 * three);
        prop_assume!((r - r.transpose()).norm() > 0.5);
        prop_assert!((r.transpose() * tensor * r - diagonal).norm() > 1e-6 * tensor.norm());
    }
}

#[test]
fn the_bubble_lowers_the_centre() {
    // notes (2.11): a bubble of half the radius, touching the north pole
    let radius = 1.7;
    let up = Vector3::z() * (radius / 2.0);
    let bubble = || Body::Ball { radius: radius / 2.0 }.nodes(5).moved(&up);
    let centre = centre_of_mass(&Body::Ball { radius }.nodes(5).without(bubble())).unwrap();
    assert_relative_eq!(centre, -Vector3::z() * (radius / 14.0), epsilon = 1e-14);
    // the twin: a lump of the same size raises it
    let lump = centre_of_mass(&Body::Ball { radius }.nodes(5).united(bubble())).unwrap();
    assert_relative_eq!(lump, Vector3::z() * (radius / 18.0), epsilon = 1e-14);
    // split up and put together again: the centre of the centres
    let whole = Nodes { points: vec![(Vector3::zeros(), 1.0), (up, -1.0 / 8.0)] };
    assert_relative_eq!(centre_of_mass(&whole).unwrap(), centre, epsilon = 1e-14);
    // nothing has no centre
    let nothing = bubble().without(bubble());
    assert!(centre_of_mass(&nothing).unwrap_err().message().contains("add up to"));
    assert!(centre_of_mass(&Nodes::<f64>::default()).is_err());
}

#[test]
fn the_moments_of_the_textbooks() {
    let (mass, size) = (1.9_f64, 1.3_f64);
    let (a, b, c) = (0.7, 1.2, 1.6);
    let disc = of_mass(Body::Disc { radius: size }, mass);
    let lamina = of_mass(Body::Lamina { edges: [a, b] }, mass);
    let table = [
        (of_mass(Body::Ball { radius: size }, mass), [0.4; 3].map(|k| k * size * size)),
        (of_mass(Body::Shell { radius: size }, mass), [2.0 / 3.0; 3].map(|k| k * size * size)),
        (of_mass(Body::Rod { length: size }, mass), [1.0, 1.0, 0.0].map(|k| k * size * size / 12.0)),
        (
            of_mass(Body::Box { edges: [a, b, c] }, mass),
            [b * b + c * c, c * c + a * a, a * a + b * b].map(|k| k / 12.0),
        ),
        (lamina.clone(), [b * b, a * a, a * a + b * b].map(|k| k / 12.0)),
        (disc.clone(), [0.25, 0.25, 0.5].map(|k| k * size * size)),
    ];
    for (body, moments) in &table {
        let expected = Matrix3::from_diagonal(&(Vector3::from(*moments) * mass));
        assert_relative_eq!(inertia_tensor(body), expected, epsilon = 1e-13);
        assert!(centre_of_mass(body).unwrap().norm() < 1e-14);
        // the twin: not so about a point aside
        assert!((inertia_tensor(&body.clone().moved(&Vector3::new(0.2, 0.0, 0.0))) - expected).norm() > 0.01);
    }
    // notes (3.46): a flat body's I₃ = I₁ + I₂, any other's is less
    for (body, _) in &table {
        let tensor = inertia_tensor(body);
        let planar = body.points.iter().all(|(r, _)| r.z == 0.0);
        assert_eq!(planar, (tensor[(0, 0)] + tensor[(1, 1)] - tensor[(2, 2)]).abs() < 1e-13);
    }
}

#[test]
fn a_ball_grows_by_its_shell() {
    // an inertia tensor over numbers that are differentiated: dI/dR of a ball is I of the shell
    let grown = inertia_tensor(&Body::Ball { radius: Dual64::from_re(1.3).derivative() }.nodes(5));
    let shell = inertia_tensor(&Body::Shell { radius: 1.3 }.nodes(5));
    assert_relative_eq!(grown.map(|entry| entry.eps), shell, epsilon = 1e-13);
    assert!((grown.map(|entry| entry.re) - shell).norm() > 0.1);
}

#[test]
fn four_particles() {
    // notes (3.52) to (3.56), in units of m
    let points = [Vector3::x(), Vector3::y(), Vector3::z(), -Vector3::new(1.0, 1.0, 1.0)];
    let tensor = inertia_tensor(&Nodes { points: points.map(|r| (r, 1.0)).into() });
    assert_eq!(tensor, Matrix3::new(4.0, -1.0, -1.0, -1.0, 4.0, -1.0, -1.0, -1.0, 4.0));
    let principal = principal_axes(&tensor).unwrap();
    assert_relative_eq!(Vector3::from(principal.moments), Vector3::new(2.0, 5.0, 5.0), epsilon = 1e-13);
    let first = principal.axes.row(0).transpose();
    assert_relative_eq!(first, Vector3::new(1.0, 1.0, 1.0).normalize(), epsilon = 1e-13);
    // the notes' other two axes are two of many; an axis between is no principal one
    for other in [Vector3::new(1.0, -1.0, 0.0), Vector3::new(1.0, 1.0, -2.0)] {
        assert_relative_eq!(tensor * other, other * 5.0, epsilon = 1e-13);
        let between = first + other.normalize();
        assert!((tensor * between).cross(&between).norm() > 1.0);
    }
    let skew = Matrix3::new(1.0, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    assert!(principal_axes(&skew).unwrap_err().message().contains("symmetric"));
    assert!(principal_axes(&(tensor * f64::NAN)).unwrap_err().message().contains("finite"));
}
