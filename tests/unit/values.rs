//! The values of sums and integrals: compared with sums and quadratures of this file, and in pairs of which one is false.

use onshell::check::Verdict;
use onshell::formula::{Assignment, Symbols, Value, evaluate};
use onshell::latex::{Macros, names, read_formula};
use onshell::{Options, compare};

/// The value of a formula of letters.
fn value(latex: &str, set: &[(&str, f64)]) -> Option<f64> {
    let mut symbols = Symbols::open();
    let formula = read_formula(latex, &mut symbols, &Macros::default()).ok()?;
    let mut state = Assignment::<f64>::new(&symbols);
    for (name, value) in set {
        let (name, dots) = names::parse(name)?;
        if let Some((id, _)) = symbols.find(&name) {
            state.set(id, dots, *value);
        }
    }
    match evaluate(&formula, &state, &[]) {
        Ok(Value::Scalar(value)) => Some(value.value()).filter(|value| value.is_finite()),
        _ => None,
    }
}

/// Simpson's rule on 40,000 parts.
fn quadrature(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let parts = 40_000;
    let width = (to - from) / f64::from(parts);
    let weight = |k: i32| if k == 0 || k == parts { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
    (0..=parts).map(|k| weight(k) * f(from + width * f64::from(k))).sum::<f64>() * width / 3.0
}

const A: f64 = 1.3;
const B: f64 = 0.7;

fn near(latex: &str, expected: f64) {
    let found = value(latex, &[("a", A), ("b", B), ("n", 7.0), ("x", 0.4)]);
    let found = found.unwrap_or_else(|| panic!("{latex} has no value"));
    assert!((found - expected).abs() <= 1e-9 * (1.0 + expected.abs()), "{latex} is {found}, not {expected}");
}

#[test]
fn integrals_are_those_of_a_quadrature() {
    let between = |integrand: &str, f: &dyn Fn(f64) -> f64| {
        near(&format!("\\int_{{0.2}}^{{1.1}} {integrand} \\, dy"), quadrature(f, 0.2, 1.1));
        near(&format!("\\int_{{1.1}}^{{0.2}} {integrand} \\, dy"), -quadrature(f, 0.2, 1.1));
    };
    between("3", &|_| 3.0);
    between("(a + b y + y^3)", &|y| A + B * y + y.powi(3));
    between("y^2 e^{-a y}", &|y| y * y * (-A * y).exp());
    between("y^3 \\cos(b y + a)", &|y| y.powi(3) * (B * y + A).cos());
    between("e^{a y} \\sin(b y)", &|y| (A * y).exp() * (B * y).sin());
    between("y e^{-y} \\cos(2 y)", &|y| y * (-y).exp() * (2.0 * y).cos());
    between("\\sin^3(a y) \\cos^2(b y)", &|y| (A * y).sin().powi(3) * (B * y).cos().powi(2));
    between("\\sin^2(a y)", &|y| (A * y).sin().powi(2));
    between("\\sinh(a y) \\cosh(y)", &|y| (A * y).sinh() * y.cosh());
    between("\\frac{y + 1}{e^{2 y}}", &|y| (y + 1.0) / (2.0 * y).exp());
    between("\\frac{1}{a y + b}", &|y| 1.0 / (A * y + B));
    between("\\frac{1}{(a y + b)^2}", &|y| (A * y + B).powi(-2));
    between("\\sqrt{a y + b}", &|y| (A * y + B).sqrt());
    between("\\frac{1}{\\sqrt[3]{a y + b}}", &|y| 1.0 / (A * y + B).cbrt());
    between("\\frac{1}{y^2 + a^2}", &|y| 1.0 / (y * y + A * A));
    between("\\frac{y}{y^2 + a^2}", &|y| y / (y * y + A * A));
    between("\\frac{y}{(y^2 + a^2)^{3/2}}", &|y| y * (y * y + A * A).powf(-1.5));
    between("\\frac{1}{(y^2 + a^2)^{3/2}}", &|y| (y * y + A * A).powf(-1.5));
    between("\\frac{1}{\\sqrt{y^2 + a^2}}", &|y| 1.0 / (y * y + A * A).sqrt());
    between("\\frac{1}{\\sqrt{a^2 - y^2}}", &|y| 1.0 / (A * A - y * y).sqrt());
    between("\\sqrt{a^2 - y^2}", &|y| (A * A - y * y).sqrt());
    between("y \\sqrt{a^2 - y^2}", &|y| y * (A * A - y * y).sqrt());
    between("(y^2 + \\frac{1}{y})", &|y| y * y + 1.0 / y);
}

#[test]
fn improper_integrals_are_those_of_a_long_quadrature() {
    near(r"\int_0^\infty y^2 e^{-a y} \, dy", quadrature(|y| y * y * (-A * y).exp(), 0.0, 60.0));
    near(r"\int_{-\infty}^0 e^{a y} \cos(b y) \, dy", quadrature(|y| (A * y).exp() * (B * y).cos(), -40.0, 0.0));
    near(r"\int_{-\infty}^{\infty} e^{-a y^2 + b y} \, dy", quadrature(|y| (-A * y * y + B * y).exp(), -12.0, 12.0));
    near(r"\int_{-\infty}^\infty y^4 e^{-a y^2} \, dy", quadrature(|y| y.powi(4) * (-A * y * y).exp(), -12.0, 12.0));
    near(r"\int_0^\infty y^5 e^{-a y^2} \, dy", quadrature(|y| y.powi(5) * (-A * y * y).exp(), 0.0, 12.0));
    near(
        r"\int_{-\infty}^\infty e^{-a y^2} \cos(b y) \, dy",
        quadrature(|y| (-A * y * y).exp() * (B * y).cos(), -12.0, 12.0),
    );
    // With y = tan u the line is an interval.
    near(
        r"\int_{-\infty}^\infty \frac{dy}{y^2 + a^2}",
        quadrature(
            |u| 1.0 / (u.sin().powi(2) + (A * u.cos()).powi(2)),
            -std::f64::consts::FRAC_PI_2,
            std::f64::consts::FRAC_PI_2,
        ),
    );
    near(
        r"\int_{-\infty}^\infty \frac{dy}{(y^2 + a^2)^{3/2}}",
        quadrature(
            |u| u.cos() / (u.sin().powi(2) + (A * u.cos()).powi(2)).powf(1.5),
            -std::f64::consts::FRAC_PI_2,
            std::f64::consts::FRAC_PI_2,
        ),
    );
    near(r"\int_b^\infty \frac{dy}{y^3}", quadrature(|u| u, 0.0, 1.0 / B));
    // No rule, and a value by quadrature.
    near(r"\int_0^a \sin(y^2) \, dy", quadrature(|y| (y * y).sin(), 0.0, A));
}

#[test]
fn sums_are_those_of_their_terms() {
    let total = |from: i32, f: &dyn Fn(f64) -> f64| (from..=7).map(|k| f(f64::from(k))).sum::<f64>();
    near(r"\sum_{k=3}^{7} k^2 a", total(3, &|k| k * k * A));
    near(r"\sum_{k=-2}^{7} k^3", total(-2, &|k| k.powi(3)));
    for p in 0..=8 {
        near(&format!("\\sum_{{k=2}}^{{n}} (k + a)^{p}"), total(2, &|k| (k + A).powi(p)));
    }
    near(r"\sum_{k=1}^{n} b x^{2k+1}", total(1, &|k| B * 0.4_f64.powf(2.0 * k + 1.0)));
    near(r"\sum_{k=0}^{n} e^{-a k}", total(0, &|k| (-A * k).exp()));
    near(r"\sum_{k=1}^{\infty} \frac{b}{3^k}", B / 2.0);
    near(r"\prod_{k=1}^{5} (a + k)", (1..=5).map(|k| A + f64::from(k)).product());
    near(r"\sum_{i=1}^{3} \sum_{j=1}^{2} (i + a) j", (1..=3).map(|i| 3.0 * (f64::from(i) + A)).sum());
}

#[test]
fn what_has_no_value_has_none_here() {
    let none = |latex: &str| assert_eq!(value(latex, &[("a", A), ("b", B), ("n", 7.0), ("x", 0.4)]), None, "{latex}");
    // A pole between the ends.
    none(r"\int_{-1}^{1} \frac{dy}{y^2}");
    none(r"\int_{-a}^{a} \frac{dy}{y}");
    none(r"\int_0^{a} \frac{dy}{(y - b)^2}");
    none(r"\int_{-3}^{3} \frac{y \, dy}{(y^2 - a)^2}");
    none(r"\int_0^{2a} \frac{dy}{y^2 - a^2}");
    none(r"\int_0^{2a} \sqrt{a^2 - y^2} \, dy");
    // No convergence.
    none(r"\int_0^\infty y \, dy");
    none(r"\int_0^\infty e^{a y} \, dy");
    none(r"\int_0^\infty \sin y \, dy");
    none(r"\int_1^\infty \frac{dy}{y}");
    none(r"\int_{-\infty}^\infty e^{a y^2} \, dy");
    none(r"\sum_{k=0}^{\infty} a^k");
    none(r"\sum_{k=1}^{\infty} 1");
    // No rule.
    none(r"\sum_{k=1}^{n} \frac{1}{k}");
    // The powers of powers that are no powers.
    none(r"\int_{-a}^{a} (\sqrt{y})^2 \, dy");
    none(r"\int_{-a}^{b} \sqrt{y^2} \, dy");
    // A rate under an integral by the time.
    none(r"\int_0^a \dot y \, dt");
}

#[test]
fn of_two_claims_that_differ_little_only_one_passes() {
    let pairs = [
        (r"\sum_{i=1}^{3} i^2", "14", "15"),
        (r"\sum_{k=0}^{n} k", r"\frac{n(n+1)}{2}", r"\frac{n(n-1)}{2}"),
        (r"\prod_{k=1}^{4} k", "24", "25"),
        (r"\int_0^{2\pi} \sin^2 x \, dx", r"\pi", "3.141592"),
        (r"\int_0^a x \, dx", r"\frac{a^2}{2}", r"\frac{a^2}{3}"),
        (r"\int_0^1 \frac{dx}{1 + x^2}", r"\frac{\pi}{4}", "0.785399"),
        (r"\int_{-\infty}^{\infty} e^{-a x^2} \, dx", r"\sqrt{\frac{\pi}{a}}", r"\frac{\pi}{\sqrt{a}}"),
        (r"\left. \frac{d}{dx}(x^3) \right|_{x=a}", "3a^2", "3a"),
        (r"\left[ \frac{x^3}{3} \right]_0^a", r"\frac{a^3}{3}", r"\frac{a^3}{2}"),
        (r"\int_0^\pi \int_0^{2\pi} \sin\theta \, d\phi \, d\theta", r"4\pi", r"2\pi"),
        (r"\int_0^R 4\pi r^2 \, dr", r"\frac{4\pi R^3}{3}", r"\frac{4\pi R^2}{3}"),
    ];
    for (left, right, wrong) in pairs {
        let verdict = |right: &str| compare(left, right, &[], Options::default()).unwrap().finding.verdict;
        assert!(verdict(right).passes(), "{left} = {right}: {:?}", verdict(right));
        assert_eq!(verdict(wrong), Verdict::Refuted, "{left} = {wrong}");
    }
    // Where a is not positive the integral diverges.
    let decay = |ranges: &[(&str, std::ops::RangeInclusive<f64>)]| {
        compare(r"\int_0^\infty e^{-a x} \, dx", r"\frac{1}{a}", ranges, Options::default()).unwrap().finding.verdict
    };
    assert_eq!(decay(&[]), Verdict::Domain);
    assert!(decay(&[("a", 0.1..=3.0)]).passes());
}
