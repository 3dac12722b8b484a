//! The mechanics: properties that hold for any state, each with a twin that must fail.

use approx::assert_relative_eq;
use onshell::mechanics::{Lagrangian, State, System, World, euler_lagrange, momenta, of};
use onshell::scalar::{Measured, Series};
use onshell::systems::{FreeRigidBody, HeavyTop};

#[test]
fn smoke() {
    let world = of(HeavyTop).world().unwrap();
    let (q, v, p) = ([0.3, 0.8, 1.1], [0.5, -0.4, 2.0], [1.2, 0.7, 0.9, 9.8, 0.4]);
    let at = State { time: 0.0, q, v, parameters: p };
    let a = world.accelerations(0.0, &q, &v, &p).unwrap();
    let b = euler_lagrange::accelerations(&HeavyTop, &at).unwrap();
    println!("{a:?} {b:?}");
    for (a, b) in a.iter().zip(b) {
        assert_relative_eq!(*a, b, max_relative = 1e-12);
    }
    assert_eq!([0, 1, 2].map(|i| world.is_cyclic(i)), [true, false, true]);
    println!("certain {:?}", [0, 1, 2].map(|i| world.is_certainly_cyclic(i)));
    let quantities = world.quantities(0.0, &q, &v, &p);
    println!("{quantities:#?}");
    assert_relative_eq!(quantities.energy, momenta::energy(&HeavyTop, &at), max_relative = 1e-12);
    let u = world.effective_potential(0.0, &q, &v, &p).unwrap();
    println!("{u}");
    let m = |x: &[f64]| x.iter().map(|&x| Measured::new(x)).collect::<Vec<_>>();
    let start = std::time::Instant::now();
    let motion = world.motion(Measured::new(0.0), &m(&q), &m(&v), &m(&p), 3).unwrap();
    println!("{:?}", start.elapsed());
    println!("{}", motion[1]);
    let s = |x: &[f64]| x.iter().map(|&x| Series::constant(Measured::new(x))).collect::<Vec<_>>();
    let start = std::time::Instant::now();
    let v: Vec<_> = motion.iter().map(Series::derivative).collect();
    let e = world.quantities(Series::time(Measured::new(0.0)), &motion, &v, &s(&p)).energy;
    println!("{:?} {e}", start.elapsed());
}
#[test]
fn ops() {
    for world in [of(HeavyTop).world().unwrap(), of(FreeRigidBody).world().unwrap()] {
        println!("{:?}", world.operations());
    }
}
