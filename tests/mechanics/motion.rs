//! The motion as a Taylor series.

use approx::assert_relative_eq;
use onshell::mechanics::{State, System, euler_lagrange, motion};
use onshell::scalar::Number;
use onshell::systems::{DampedOscillator, HeavyTop};

use crate::support::some_state;

/// The classical Runge–Kutta method on the accelerations alone.
fn integrated(system: &System, q: [f64; 3], v: [f64; 3], parameters: &[f64], duration: f64) -> Vec<f64> {
    const STEPS: usize = 400;
    let h = duration / STEPS as f64;
    let slope = |x: &[f64]| {
        let (q, v) = x.split_at(3);
        [v, &system.accelerations(0.0, q, v, parameters).unwrap()].concat()
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
    let system = System::new(&HeavyTop).unwrap();
    let (q, v, parameters) = ([0.3, 0.8, 1.1], [0.5, -0.4, 2.0], [1.2, 0.7, 0.9, 3.8, 0.4]);
    let error = |parameters: &[f64; 5], duration: f64| {
        let series = system.motion(0.0, &q, &v, parameters, 5).unwrap();
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
        let x = integrated(&system, q, v, &[1.2, 0.7, 0.9, 3.8, 0.4], duration);
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
    let traced = System::new(&HeavyTop).unwrap().motion(at.time, &at.q, &at.v, &at.parameters, 4).unwrap();
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
    let off_shell = motion::time_derivative(&Speed, &at, &[5.0]);
    assert_relative_eq!(off_shell, 2.0 * at.v[0] * 5.0 + at.v[0] * at.time + at.q[0], max_relative = 1e-15);
    let a = euler_lagrange::accelerations(&DampedOscillator, &at).unwrap();
    let on_shell = motion::time_derivative_on_shell(&DampedOscillator, &Speed, &at).unwrap();
    assert_eq!(on_shell, motion::time_derivative(&Speed, &at, &a));
    assert!((on_shell - off_shell).abs() > 0.1);
}
