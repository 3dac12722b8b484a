//! Integrals over bodies, against the closed forms of ∫ xᵃ yᵇ zᶜ.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use nalgebra::{Rotation3, Vector3};
use num_dual::Dual64;
use onshell::mechanics::{Body, Nodes};
use onshell::scalar::Number;

const BODIES: [Body<f64>; 6] = [
    Body::Box { edges: [0.7, 1.9, 1.2] },
    Body::Ball { radius: 1.3 },
    Body::Shell { radius: 0.8 },
    Body::Rod { length: 1.7 },
    Body::Lamina { edges: [1.1, 0.6] },
    Body::Disc { radius: 1.4 },
];

/// (n − 1)!! = 1·3·5 ⋯ (n − 1) for an even n; odd powers have no integral over anything symmetric.
fn odds(n: i32) -> f64 {
    if n % 2 == 0 { (1..n).step_by(2).map(f64::from).product() } else { 0.0 }
}

/// n!! for any n.
fn double_factorial(n: i32) -> f64 {
    (1..=n).rev().step_by(2).map(f64::from).product()
}

/// ∫ xⁿ dx over −l/2 … l/2.
fn segment(l: f64, n: i32) -> f64 {
    if n % 2 == 0 { 2.0 * (l / 2.0).powi(n + 1) / f64::from(n + 1) } else { 0.0 }
}

/// 1 for the zeroth power, 0 for any other: what a body without extent along an axis has.
fn flat(n: i32) -> f64 {
    if n == 0 { 1.0 } else { 0.0 }
}

/// ∫ xᵃ yᵇ zᶜ over the body, from textbooks.
fn exact(body: &Body<f64>, [a, b, c]: [i32; 3]) -> f64 {
    let n = a + b + c;
    let sphere = 4.0 * PI * odds(a) * odds(b) * odds(c) / double_factorial(n + 1);
    match *body {
        Body::Box { edges: [x, y, z] } => segment(x, a) * segment(y, b) * segment(z, c),
        Body::Ball { radius } => sphere * radius.powi(n + 3) / f64::from(n + 3),
        Body::Shell { radius } => sphere * radius.powi(n + 2),
        Body::Rod { length } => flat(a) * flat(b) * segment(length, c),
        Body::Lamina { edges: [x, y] } => segment(x, a) * segment(y, b) * flat(c),
        Body::Disc { radius } => {
            let circle = 2.0 * PI * odds(a) * odds(b) / double_factorial(a + b);
            circle * radius.powi(n + 2) / f64::from(n + 2) * flat(c)
        }
    }
}

fn monomials(degree: i32) -> Vec<[i32; 3]> {
    (0..=degree).flat_map(|a| (0..=degree - a).map(move |b| [a, b, degree - a - b])).collect()
}

fn sum<D: Number + Copy + Send + Sync>(nodes: &Nodes<D>, powers: [i32; 3]) -> D {
    nodes.integral(|r| r.x.powi(powers[0]) * r.y.powi(powers[1]) * r.z.powi(powers[2]))
}

#[test]
fn nodes_are_exact_to_their_degree_and_no_further() {
    for body in &BODIES {
        for degree in 0..=9 {
            let nodes = body.nodes(degree as usize);
            let miss = |powers| (sum(&nodes, powers) - exact(body, powers)).abs();
            for powers in (0..=degree).flat_map(monomials) {
                assert!(miss(powers) < 1e-13, "{body:?} to degree {degree}: {powers:?} misses by {}", miss(powers));
            }
            // the twin: two degrees more are too many
            let beyond = monomials(degree + 1).into_iter().chain(monomials(degree + 2));
            assert!(beyond.map(miss).fold(0.0, f64::max) > 1e-6, "{body:?}: more than degree {degree}");
        }
    }
}

#[test]
fn a_size_can_be_differentiated() {
    // a ball grows by its shell: d/dR ∫ f d³r = ∫ f d²r
    let radius = Dual64::from_re(1.3).derivative();
    let (ball, shell) = (Body::Ball { radius }.nodes(6), Body::Shell { radius: 1.3 }.nodes(6));
    for powers in [[0, 0, 0], [2, 0, 0], [2, 0, 4], [2, 2, 2]] {
        assert_relative_eq!(sum(&ball, powers).eps, sum(&shell, powers), max_relative = 1e-13);
        // the twin: not so the ball itself
        assert!((sum(&ball, powers).re - sum(&shell, powers)).abs() > 1e-3);
    }
}

#[test]
fn the_dimension_is_how_the_measure_scales() {
    let twice = |body: &Body<f64>| match *body {
        Body::Box { edges } => Body::Box { edges: edges.map(|l| 2.0 * l) },
        Body::Ball { radius } => Body::Ball { radius: 2.0 * radius },
        Body::Shell { radius } => Body::Shell { radius: 2.0 * radius },
        Body::Rod { length } => Body::Rod { length: 2.0 * length },
        Body::Lamina { edges } => Body::Lamina { edges: edges.map(|l| 2.0 * l) },
        Body::Disc { radius } => Body::Disc { radius: 2.0 * radius },
    };
    for body in &BODIES {
        let ratio = twice(body).nodes(2).total() / body.nodes(2).total();
        assert_relative_eq!(ratio, 2.0_f64.powi(body.dimension() as i32), max_relative = 1e-13);
    }
}

#[test]
fn cells_become_the_integral_as_they_get_smaller() {
    let cut: Vec<_> = BODIES.iter().filter(|body| body.cells(3).is_some()).collect();
    assert_eq!(cut.len(), 3, "a box, a lamina and a rod");
    for body in cut {
        let powers = if body.dimension() == 1 { [0, 0, 4] } else { [4, 2, 0] };
        let error = |k| (sum(&body.cells(k).unwrap(), powers) - exact(body, powers)).abs();
        assert_eq!(body.cells(5).unwrap().points.len(), 5_usize.pow(body.dimension() as u32));
        assert_relative_eq!(body.cells(5).unwrap().total(), exact(body, [0; 3]), max_relative = 1e-13);
        // the error is of second order in their size: 4 times smaller cells in each direction, a 16th of it
        assert!((error(8) / error(32) - 16.0).abs() < 1.0, "{body:?}: {} {}", error(8), error(32));
        // the twin: they do not get there at once, as nodes do
        assert!(error(8) > 1e-5 && (sum(&body.nodes(6), powers) - exact(body, powers)).abs() < 1e-14);
    }
}

#[test]
fn nodes_move_turn_and_unite() {
    let ball = Body::Ball { radius: 1.1 }.nodes(4);
    let (by, q) = (Vector3::new(0.3, -0.4, 0.9), Rotation3::from_euler_angles(0.3, 0.4, 0.5));
    let turned = ball.clone().turned(q.matrix());
    for powers in (0..=4).flat_map(monomials) {
        // a ball is the same in all directions, to the degree of its nodes
        assert_relative_eq!(sum(&ball, powers), sum(&turned, powers), epsilon = 1e-13);
    }
    let rod = Body::Rod { length: 2.0 }.nodes(4);
    assert_relative_eq!(sum(&rod, [0, 0, 2]), 2.0 / 3.0, epsilon = 1e-14);
    // the active rotation about x by a right angle takes z to −y
    let quarter = Rotation3::from_axis_angle(&Vector3::x_axis(), PI / 2.0);
    let lying = rod.clone().moved(&Vector3::z()).turned(quarter.matrix());
    assert_relative_eq!(sum(&lying, [0, 1, 0]), -2.0, epsilon = 1e-14);
    // the twin: the passive one would take it to y
    let wrong = rod.clone().moved(&Vector3::z()).turned(&quarter.matrix().transpose());
    assert_relative_eq!(sum(&wrong, [0, 1, 0]), 2.0, epsilon = 1e-14);
    // two halves are a whole, and a whole without one half is the other
    let half = |z: f64| Body::Rod { length: 1.0 }.nodes(4).moved(&Vector3::new(0.0, 0.0, z));
    let (whole, rest) = (half(-0.5).united(half(0.5)), rod.clone().without(half(-0.5)));
    for powers in (0..=4).flat_map(monomials) {
        assert_relative_eq!(sum(&whole, powers), sum(&rod, powers), epsilon = 1e-14);
        assert_relative_eq!(sum(&rest, powers), sum(&half(0.5), powers), epsilon = 1e-14);
    }
    assert!((sum(&rest, [0, 0, 1]) - sum(&half(-0.5), [0, 0, 1])).abs() > 0.5);
    // a density that varies: ∫ z·z is the weighted rod's first moment
    let heavier_above = rod.clone().with_density(|r| r.z);
    assert_relative_eq!(sum(&heavier_above, [0, 0, 1]), sum(&rod, [0, 0, 2]), epsilon = 1e-14);
    assert_relative_eq!(ball.clone().moved(&by).total(), ball.total(), epsilon = 1e-13);
}
