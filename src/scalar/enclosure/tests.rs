use num_dual::DualNum;
use num_traits::{One, Signed};
use proptest::prelude::*;

use super::*;
use crate::scalar::Number;

const STEPS: usize = 10_000;

/// Whether a difference contains 0 and is smaller than 2⁻ⁿ.
fn vanishes(x: Enclosure, n: f64) -> bool {
    x.is_known() && !x.excludes_zero() && x.log2() < -n
}

/// Identities, each a number that is 0.
fn identities(x: Enclosure) -> Vec<Enclosure> {
    let (sine, cosine) = x.sin_cos();
    let root = x.sqrt();
    vec![
        sine * sine + cosine * cosine - 1.0,
        (x + x).sin() - sine * cosine * 2.0,
        x.exp().ln() - x,
        (x * 2.0).exp() - x.exp() * x.exp(),
        root * root - x,
        x.tan() - sine / cosine,
        x.atan() + x.recip().atan() - Enclosure::half_pi(),
        (x / 8.0).sin().asin() - x / 8.0,
        (x / 8.0).asin() + (x / 8.0).acos() - Enclosure::half_pi(),
        x.cosh() * x.cosh() - x.sinh() * x.sinh() - 1.0,
        x.sinh().asinh() - x,
        x.cosh().acosh() - x,
        (x / 8.0).atanh().tanh() - x / 8.0,
        x.cbrt().powi(3) - x,
        sine.atan2(cosine) - x,
        x.ln_1p().exp_m1() - x,
        (x + 1.0) * (x - 1.0) - x * x + 1.0,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn an_identity_contains_zero_and_a_neighbour_does_not(x in 0.1..3.0_f64, bits in 128..700_usize) {
        evaluate_to(bits, STEPS, || {
            let tiny = <Enclosure as Number>::decimal("1e-30").unwrap();
            for (which, zero) in identities(Enclosure::exact(x)).into_iter().enumerate() {
                prop_assert!(vanishes(zero, bits as f64 - 24.0), "identity {which} at {x}: {}", zero.log2());
                // must-fail case: 10⁻³⁰ more is not 0
                prop_assert!((zero + tiny).excludes_zero(), "identity {which} at {x}");
            }
            Ok(())
        })?;
    }

    #[test]
    fn bounds_of_low_precision_contain_the_value_of_high_precision(x in -3.0..3.0_f64, y in 0.1..3.0_f64) {
        let formula = |x: Enclosure, y: Enclosure| {
            ((x * 7.0).sin() / y + (x - y).exp() * y.sqrt() - y.ln() * x).atan() * x.cosh() + y.atan2(x) - x.abs()
        };
        let of = |bits| evaluate_to(bits, STEPS, || formula(Enclosure::exact(x), Enclosure::exact(y)).asked(Ball::clone));
        let (Some(coarse), Some(fine)) = (of(60), of(400)) else { return Err(TestCaseError::fail("no value")) };
        let contains = |by: f64| evaluate_to(400, STEPS, || {
            let [coarse, fine] = [&coarse, &fine].map(|ball| Enclosure::kept(|_| Some(ball.clone())));
            !(coarse - fine + by).excludes_zero()
        });
        prop_assert!(contains(0.0));
        // must-fail case: the bounds are narrow
        prop_assert!(!contains(1e-9));
    }
}

#[test]
fn a_double_is_a_decimal_or_a_rounded_number() {
    evaluate_to(256, STEPS, || {
        let tenth = Enclosure::from(0.1) * 10.0 - 1.0;
        assert!(vanishes(tenth, 200.0));
        // 1/3 as a double is not 1/3, and may be the rounding of it
        let third = Enclosure::from(1.0 / 3.0) * 3.0 - 1.0;
        assert!(!third.excludes_zero() && !vanishes(third, 60.0));
        assert!(vanishes(Enclosure::one() / 3.0 * 3.0 - 1.0, 200.0));
        // must-fail cases: a state is the double itself
        assert!((Enclosure::exact(0.1) * 10.0 - 1.0).excludes_zero());
        assert!((Enclosure::from(std::f64::consts::PI) - <Enclosure as Number>::pi()).log2() > -60.0);
    });
}

#[test]
fn a_decimal_is_what_is_printed() {
    evaluate_to(256, STEPS, || {
        let number = |digits| <Enclosure as Number>::decimal(digits).unwrap();
        assert!(vanishes(number("0.25") * 4.0 - 1.0, 200.0));
        assert!(vanishes(number("1e3") - 1000.0, 200.0));
        assert!((number("1.0000000000000000000000000000000000000001") - 1.0).excludes_zero());
        for none in ["", "x", "1e", "1e99999"] {
            assert!(<Enclosure as Number>::decimal(none).is_none(), "{none}");
        }
    });
}

#[test]
fn what_may_have_no_value_is_unknown() {
    evaluate_to(256, STEPS, || {
        let one = Enclosure::exact(1.0);
        let nothing = one.sin() * one.sin() + one.cos() * one.cos() - 1.0;
        for unknown in [one / nothing, nothing.sqrt(), nothing.ln(), (-one).sqrt(), (one * 2.0).asin(), -one.ln() / 0.0]
        {
            assert!(!unknown.is_known());
        }
        // must-fail cases
        assert!((one / 1e-200).is_known());
        assert!(Enclosure::exact(0.0).sqrt().is_known());
        // neither a huge exponential nor a huge angle is computed
        assert!(!one.scale(&1e300).exp().is_known());
        assert!((one * 700.0).exp().powi(1000).is_known());
    });
    assert!(!Enclosure::exact(1.0).is_known(), "outside of an evaluation");
}

#[test]
fn the_number_of_steps_is_limited() {
    let sum = |steps| {
        evaluate_to(256, steps, || {
            let one = Enclosure::exact(1.0);
            (0..100).fold(one, |sum, _| sum + one).is_known()
        })
    };
    assert!(sum(200));
    assert!(!sum(50));
}
