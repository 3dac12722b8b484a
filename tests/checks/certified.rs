//! What the field confirms: identities that simplifiers stumble over, each beside a near miss that it does not confirm; what
//! is outside of it, and says so; and what numbers and the field know of each other's blind spots.

use onshell::check::Finding;
use onshell::check::Verdict::{Certified, Domain, Refuted, Undecided, Verified};
use serde_json::{Value as Json, json};

use crate::support::{assuming, equation, pendulum, planet};

/// Numbers and angles.
fn numbers() -> Json {
    json!({ "constants": {
        "a, b, c": "> 0",
        "x, y, z": "any",
        r"\theta, \alpha, \beta, \gamma": "angle",
    } })
}

fn vectors() -> Json {
    json!({ "constants": { r"\vec a, \vec b, \vec c, \vec d": "any" } })
}

/// Two equal masses on equal rods.
fn two_pendulums() -> Json {
    json!({
        "system": "double_pendulum",
        "coordinates": { r"\theta_1, \theta_2": "angle" },
        "constants": { "m, l, g": "> 0" },
        "means": { "E": "energy" },
    })
}

fn top() -> Json {
    json!({
        "system": "heavy_top",
        "coordinates": { r"\phi, \theta, \psi": "angle" },
        "constants": { r"\lambda_1, \lambda_3, M, g, R": "> 0" },
        "means": { "E": "energy" },
    })
}

fn finding(claims: &Json, latex: &str) -> Finding {
    equation(claims, &[latex], json!({})).finding
}

/// An identity has a certificate, and with the small term added to its right side it has none and is no pass.
fn only_the_first_is_certified(claims: &Json, latex: &str, near_misses: &[&str]) {
    let sound = finding(claims, latex);
    assert_eq!(sound.verdict, Certified, "{latex}: {} {:?}", sound.message, sound.not_certified_because);
    assert!(sound.false_accept_log2.is_some_and(|log2| log2 <= -80.0), "{latex}: {sound:?}");
    assert_eq!(sound.not_certified_because, None);
    assert!(!near_misses.is_empty());
    for near_miss in near_misses {
        let found = finding(claims, near_miss);
        assert_eq!(found.verdict, Refuted, "{near_miss}: {}", found.message);
        assert_eq!(found.false_accept_log2, None, "{near_miss}");
    }
}

#[test]
fn angles_are_halved_multiplied_and_added() {
    only_the_first_is_certified(
        &numbers(),
        r"\tan\frac{\theta}{2} = \frac{1 - \cos\theta}{\sin\theta}",
        &[
            r"\tan\frac{\theta}{2} = \frac{1 + \cos\theta}{\sin\theta}",
            r"\tan\frac{\theta}{2} = \frac{1 - 1.000000001 \cos\theta}{\sin\theta}",
        ],
    );
    let twelfth = |a: &str, b: &str| {
        let c = |n: u32| format!(r"\cos^{{{n}}}\theta");
        let (high, low) = (format!("2048 {} - 6144 {} + 6912 {}", c(12), c(10), c(8)), format!("3584 {}", c(6)));
        format!(r"\cos(12\theta) = {high} - {low} + {a} {} - {b} {} + 1", c(4), c(2))
    };
    // The change vanishes wherever the cosine is 0, 1 or −1.
    only_the_first_is_certified(&numbers(), &twelfth("840", "72"), &[&twelfth("841", "73"), &twelfth("840", "73")]);
    // At multiples of π/4 this misses nothing.
    only_the_first_is_certified(
        &numbers(),
        r"\sin(\alpha + \beta) \sin(\alpha - \beta) = \sin^2\alpha - \sin^2\beta",
        &[r"\sin(\alpha + \beta) \sin(\alpha - \beta) = \sin^2\alpha - \sin^2\beta + 10^{-9} \sin(4\alpha)"],
    );
    only_the_first_is_certified(
        &numbers(),
        r"\cos\theta + \cos(\theta + \frac{2\pi}{4}) + \cos(\theta + \pi) = -\sin\theta",
        &[r"\cos\theta + \cos(\theta + \frac{2\pi}{4}) + \cos(\theta + \pi) = \sin\theta"],
    );
}

#[test]
fn fractions_and_powers() {
    let nested = r"\frac{1}{1 + \frac{1}{1 + \frac{1}{1 + \frac{1}{a}}}}";
    only_the_first_is_certified(
        &numbers(),
        &format!(r"{nested} = \frac{{2a + 1}}{{3a + 2}}"),
        // The first addition vanishes at 1, 2 and 3.
        &[
            &format!(r"{nested} = \frac{{2a + 1}}{{3a + 2}} + 10^{{-9}} (a - 1)(a - 2)(a - 3)"),
            &format!(r"{nested} = \frac{{2a + 1}}{{3a + 2.00000001}}"),
        ],
    );
    only_the_first_is_certified(
        &numbers(),
        "x^3 + y^3 + z^3 - 3xyz = (x + y + z)(x^2 + y^2 + z^2 - xy - yz - zx)",
        &["x^3 + y^3 + z^3 - 3xyz = (x + y + z)(x^2 + y^2 + z^2 - xy - yz - zx) + 10^{-9} x (x - 1)(x + 1)(x - 2)"],
    );
}

#[test]
fn roots_whose_signs_do_not_matter() {
    only_the_first_is_certified(
        &numbers(),
        r"\frac{1}{\sqrt{a + b} + \sqrt{a}} = \frac{\sqrt{a + b} - \sqrt{a}}{b}",
        &[
            r"\frac{1}{\sqrt{a + b} + \sqrt{a}} = \frac{\sqrt{a + b} + \sqrt{a}}{b}",
            r"\frac{1}{\sqrt{a + b} + \sqrt{a}} = \frac{\sqrt{a + b} - \sqrt{a}}{1.000000001 b}",
        ],
    );
    // Heron's formula, of the area of a triangle with two of its sides and the angle between them.
    let half = r"\frac{a + b + \sqrt{a^2 + b^2 - 2ab \cos\gamma}}{2}";
    let side = r"\sqrt{a^2 + b^2 - 2ab \cos\gamma}";
    let heron = |area: &str| format!("{half} ({half} - a) ({half} - b) ({half} - {side}) = {area}");
    only_the_first_is_certified(
        &numbers(),
        &heron(r"\frac14 a^2 b^2 \sin^2\gamma"),
        &[&heron(r"\frac14 a^2 b^2 \sin^2\gamma + 10^{-9} a^4 \sin\gamma"), &heron(r"\frac12 a^2 b^2 \sin^2\gamma")],
    );
}

#[test]
fn exponentials_and_logarithms() {
    for (sound, near_misses) in [
        (r"e^{x + y} = e^x e^y", [r"e^{x + y} = e^x + e^y", r"e^{x + y} = e^x e^{2y}"]),
        (r"\cosh^2 x - \sinh^2 x = 1", [r"\cosh^2 x + \sinh^2 x = 1", r"\cosh^2 x - \sinh^2 x = 2"]),
        (r"\sinh(2x) = 2 \sinh x \cosh x", [r"\sinh(2x) = \sinh x \cosh x", r"\sinh(2x) = 2 \sinh x \cosh y"]),
        (r"\ln(ab) = \ln a + \ln b", [r"\ln(ab) = \ln a - \ln b", r"\ln(ab) = \ln a \ln b"]),
        (r"\ln\sqrt{a} = \frac12 \ln a", [r"\ln\sqrt{a} = 2 \ln a", r"\ln\sqrt{a} = \frac12 \ln b"]),
        (r"\ln(e^{xy} a) = xy + \ln a", [r"\ln(e^{xy} a) = x + \ln a", r"\ln(e^{xy} a) = a xy"]),
    ] {
        only_the_first_is_certified(&numbers(), sound, &near_misses);
    }
}

#[test]
fn products_of_vectors() {
    only_the_first_is_certified(
        &vectors(),
        r"|\vec a \times \vec b|^2 = |\vec a|^2 |\vec b|^2 - (\vec a \cdot \vec b)^2",
        &[
            r"|\vec a \times \vec b|^2 = |\vec a|^2 |\vec b|^2 + (\vec a \cdot \vec b)^2",
            r"|\vec a \times \vec b|^2 = |\vec a|^2 |\vec b|^2 - 1.000000001 (\vec a \cdot \vec b)^2",
        ],
    );
    let jacobi = |last: &str| {
        format!(r"\vec a \times (\vec b \times \vec c) + \vec b \times (\vec c \times \vec a) + {last} = \vec 0")
    };
    only_the_first_is_certified(
        &vectors(),
        &jacobi(r"\vec c \times (\vec a \times \vec b)"),
        &[
            &jacobi(r"\vec c \times (\vec b \times \vec a)"),
            &jacobi(r"1.000000001 \vec c \times (\vec a \times \vec b)"),
        ],
    );
}

#[test]
fn the_energy_of_two_pendulums_in_two_forms() {
    let energy = |coupled: &str| {
        format!(
            r"E = m l^2 \dot\theta_1^2 + \frac12 m l^2 \dot\theta_2^2 + m l^2 \dot\theta_1 \dot\theta_2 ({coupled})
            - 2 m g l \cos\theta_1 - m g l \cos\theta_2"
        )
    };
    let difference = r"\cos(\theta_1 - \theta_2)";
    let products = r"\cos\theta_1 \cos\theta_2 + \sin\theta_1 \sin\theta_2";
    // The sum of the angles is as good where one of them is a multiple of π.
    let sum = r"\cos(\theta_1 + \theta_2)";
    let nearly = r"\cos\theta_1 \cos\theta_2 + 1.00000001 \sin\theta_1 \sin\theta_2";
    only_the_first_is_certified(&two_pendulums(), &energy(difference), &[&energy(sum)]);
    only_the_first_is_certified(&two_pendulums(), &energy(products), &[&energy(nearly)]);
}

#[test]
fn equations_of_motion() {
    only_the_first_is_certified(
        &pendulum(),
        r"l \ddot\theta = -g \sin\theta",
        &[r"l \ddot\theta = -g \theta", r"l \ddot\theta = -1.000000001 g \sin\theta"],
    );
    only_the_first_is_certified(
        &planet(),
        r"\ddot r = r \dot\phi^2 - \frac{G M}{r^2}",
        &[r"\ddot r = r \dot\phi^2 - \frac{G M}{r^2} + 10^{-9} (r - 1)(r - 2)(r - 3)"],
    );
    let second = |sign: &str| {
        format!(
            r"l \ddot\theta_2 + l \ddot\theta_1 \cos(\theta_1 - \theta_2)
            {sign} l \dot\theta_1^2 \sin(\theta_1 - \theta_2) + g \sin\theta_2 = 0"
        )
    };
    only_the_first_is_certified(&two_pendulums(), &second("-"), &[&second("+")]);
    let nutation = |last: &str| {
        format!(
            r"\lambda_1 \ddot\theta = \lambda_1 \dot\phi^2 \sin\theta \cos\theta
            - \lambda_3 (\dot\psi + \dot\phi \cos\theta) \dot\phi \sin\theta + M g R {last}"
        )
    };
    only_the_first_is_certified(&top(), &nutation(r"\sin\theta"), &[&nutation(r"\sin\theta \cos\theta")]);
}

#[test]
fn what_is_constant_on_shell() {
    let conserved = |what: &str| equation(&top(), &["E = E + 0"], json!({ "conserved": what })).parts;
    let whole = |what: &str| conserved(what).pop().unwrap_or_else(|| panic!("{what}")).finding;
    let spin = whole(r"\dot\psi + \dot\phi \cos\theta");
    assert_eq!(spin.verdict, Certified, "{spin:?}");
    assert!(spin.false_accept_log2.is_some_and(|log2| log2 <= -80.0), "{spin:?}");
    assert_eq!(whole(r"\dot\psi + \dot\phi").verdict, Refuted);
    assert_eq!(whole(r"\dot\psi + 1.000000001 \dot\phi \cos\theta").verdict, Refuted);
}

#[test]
fn hypotheses_are_solved_exactly() {
    let under = |latex: &str, hypothesis: &str| equation(&numbers(), &[latex], assuming(&[hypothesis])).finding;
    let square = |hypothesis: &str| under("(x + y)^2 = 4z^2 - 4z + 1", hypothesis);
    let sound = square("x + y = 2z - 1");
    assert_eq!(sound.verdict, Certified, "{sound:?}");
    assert_eq!(square("x + y = 2z - 1.000000001").verdict, Refuted);
    // None of these numbers is linear in it.
    let cubes = under("(a^3 + b^3) x = c^3 x", "a^3 + b^3 = c^3");
    assert_eq!(cubes.verdict, Verified, "{cubes:?}");
    assert!(cubes.not_certified_because.is_some_and(|why| why.contains("linear in no symbol")));
}

/// What is said under a hypothesis of numbers of which z, w and θ may have any value.
fn under(latex: &str, hypotheses: &[&str]) -> Finding {
    let claims = json!({ "constants": {
        "a, b": "> 0",
        "x, y, z, w": "any",
        r"\theta": "angle",
        r"\beta": r"(0, \pi)",
        "n": "integer 1..4",
        r"\vec a, \vec b": "any",
    } });
    equation(&claims, &[latex], assuming(hypotheses)).finding
}

/// A claim that is true where x = y, and false elsewhere.
const OF_EQUALS: &str = "x^3 = x y^2";

#[test]
fn a_hypothesis_that_can_be_met_in_another_way_certifies_nothing() {
    // All of these let x and y differ: where z = 2, at a right angle, where a² = z².
    for product in [
        "x z^2 - 4x - y z^2 + 4y = 0",
        r"x \cos\theta = y \cos\theta",
        r"x \sin(2\theta) = y \sin(2\theta)",
        "x a^2 - x z^2 - y a^2 + y z^2 = 0",
    ] {
        let found = under(OF_EQUALS, &[product]);
        assert_ne!(found.verdict, Certified, "{product}");
        if let Some(reason) = found.not_certified_because {
            assert!(reason.contains("more than one solution"), "{product}: {reason}");
        }
    }
    // The factor that is printed as one, and the second of two solutions, numbers see for themselves.
    for product in ["(x - y)(z - 1) = 0", "x z - x - y z + y = 0", r"x \sin\theta = y \sin\theta"] {
        assert_eq!(under(OF_EQUALS, &[product]).verdict, Refuted, "{product}");
    }
}

#[test]
fn a_factor_that_the_ranges_exclude_is_no_other_way() {
    for equals in ["x a = y a", r"x \sin\beta = y \sin\beta", r"a^2 b x \sin^3\beta = y a^2 b \sin^3\beta", "x - y = 0"]
    {
        let found = under(OF_EQUALS, &[equals]);
        assert_eq!(found.verdict, Certified, "{equals}: {:?}", found.not_certified_because);
    }
    // The slope z vanishes where y does not, so that this has no factor.
    assert_eq!(under("x^2 z^2 = y^2", &["x z = y"]).verdict, Certified);
    assert_eq!(under(r"x^2 \cos^2\theta = y^2", &[r"x \cos\theta = y"]).verdict, Certified);
    // Two of them have: where y = z = 0 neither says anything of x and a.
    let two = under("x w = a y + x w - a x z", &["x z = y", "w z = a b y"]);
    assert_ne!(two.verdict, Certified, "{two:?}");
    // What holds without its hypothesis holds with it, however that is met.
    let identity = under("(x + w)(x - w) = x^2 - w^2", &[r"x \cos\theta = y \cos\theta"]);
    assert_eq!(identity.verdict, Certified, "{identity:?}");
}

#[test]
fn whole_numbers_are_certified_at_each_of_their_values() {
    let all = "(n - 1)(n - 2)(n - 3)(n - 4) x = 0 y";
    assert_eq!(under(all, &[]).verdict, Certified);
    assert_eq!(under(r"\sin(n \pi + \theta) = \cos(n \pi) \sin\theta", &[]).verdict, Certified);
    // The twin: one value is left out.
    assert_eq!(under("(n - 1)(n - 2)(n - 3) x = 0 y", &[]).verdict, Refuted);
    // A hypothesis that hides this value from the states hides it from the field.
    let hidden = under("(n - 1)(n - 2)(n - 3) x = 0 y", &["n < 4"]);
    assert_ne!(hidden.verdict, Refuted, "{hidden:?}");
    assert_ne!(hidden.verdict, Certified, "{hidden:?}");
}

#[test]
fn roots_of_squares_and_products_of_either_sign_are_not_certified() {
    for (latex, hypotheses) in [
        (r"\sqrt{x^2} y = x y", vec!["x > 0"]),
        (r"\sqrt{x^2 y^2} = x y", vec!["x y > 0"]),
        (r"\sqrt{x^2 + 2 x y + y^2} z = (x + y) z", vec!["x > 0", "y > 0"]),
    ] {
        let found = under(latex, &hypotheses);
        assert_eq!(found.verdict, Verified, "{latex}: {found:?}");
        assert!(under(latex, &[]).verdict == Refuted, "{latex}");
    }
    for latex in [r"\sqrt{x y} = \sqrt{x} \sqrt{y}", r"\sqrt{\frac{x}{y}} z = \frac{\sqrt{x}}{\sqrt{y}} z"] {
        assert_eq!(under(latex, &["x y > 0"]).verdict, Domain, "{latex}");
    }
}

#[test]
fn where_numbers_alone_decide_a_term_that_they_do_not_see_is_not_passed() {
    for latex in [
        r"\sin(x + 10^{-20}) = \sin x",
        r"e^{x + 10^{-20}} = e^x",
        r"\sqrt{x^2 + 10^{-20}} = \sqrt{x^2}",
        r"\ln(a + 10^{-20} b) = \ln a",
    ] {
        let found = under(latex, &[]);
        assert_eq!(found.verdict, Undecided, "{latex}: {found:?}");
        assert!(found.message.contains("far smaller"), "{latex}: {}", found.message);
    }
    // The twins: what is seen is refuted, and what has no such term passes.
    assert_eq!(under(r"\sin(x + 10^{-2}) = \sin x", &[]).verdict, Refuted);
    assert_eq!(under("e^{x + y} = e^x e^y", &[]).verdict, Certified);
}

#[test]
fn a_number_that_is_the_prime_is_not_taken_for_zero() {
    // Modulo p = 861·2¹¹⁷ − 1 the added terms are nothing, and in numbers they are too small to be seen.
    let p = r"(861 \cdot 2^{117} - 1)";
    for latex in [
        format!(r"\frac{{1}}{{x + {p} \cdot 10^{{-60}} y}} = \frac{{1}}{{x}}"),
        format!(r"x (1 + {p} \cdot 10^{{-60}} y) = x"),
        format!(r"\sqrt{{a + {p} \cdot 10^{{-60}} b}} = \sqrt{{a}}"),
        format!(r"\sin(xy + {p} \cdot 10^{{-60}}) = \sin(xy)"),
    ] {
        let found = under(&latex, &[]);
        assert!(!found.verdict.passes(), "{latex}: {found:?}");
    }
    // The twin: what has such a number on both sides is one over two fields.
    let both = under(&format!("{p} (x + y)^2 = {p} (x^2 + 2 x y + y^2)"), &[]);
    assert_eq!(both.verdict, Certified, "{both:?}");
}

#[test]
fn a_law_whose_coefficient_may_vanish_says_nothing_there() {
    let fall = |mass: &str| {
        let claims = json!({
            "varies with time": { "x": "any" },
            "constants": { "m": mass, "g": "> 0" },
            "laws": { "the law of falling": "1" },
        });
        equation(&claims, &[r"m (\ddot x - g) = 0 g", r"\ddot x^2 = g \ddot x"], json!({})).finding
    };
    assert_eq!(fall("> 0").verdict, Certified, "{:?}", fall("> 0"));
    assert_ne!(fall("any").verdict, Certified);
}

#[test]
fn what_is_outside_of_a_field_is_said() {
    for (latex, why) in [
        (r"\ln(a^7) = 7 \ln a", "a logarithm"),
        (r"e^{7x} = (e^x)^7", "an exponential"),
        ("|x| |y| = |x y|", "an absolute value"),
        (r"\arctan(\tan x) = \arctan(\frac{\sin x}{\cos x})", "an inverse function"),
        (r"\sqrt{a + b + 2\sqrt{ab}} = \sqrt{a} + \sqrt{b}", "a root"),
        ("a^{1.5} a^{0.25} a^{0.25} = a^2", "an exponent"),
    ] {
        let found = finding(&numbers(), latex);
        assert_eq!((found.verdict, found.false_accept_log2), (Verified, None), "{latex}: {found:?}");
        let reason = found.not_certified_because.unwrap_or_else(|| panic!("{latex}"));
        assert!(reason.contains(why), "{latex}: {reason}");
    }
    // Its twin: what is inside gives no reason; and no order is an identity.
    assert_eq!(finding(&numbers(), "x^2 - y^2 = (x - y)(x + y)").not_certified_because, None);
    assert_eq!(finding(&numbers(), "|x|^2 = x^2").not_certified_because, None);
    let order = finding(&numbers(), r"a^2 + b^2 \geq 2ab");
    assert_eq!(
        (order.verdict, order.not_certified_because.as_deref()),
        (Verified, Some("an inequality, because only an equality can have a certificate"))
    );
}

#[test]
fn what_is_smaller_than_rounding_only_the_field_sees() {
    for latex in [
        r"\left(1 + \frac{1}{10^{16}}\right) x = x",
        r"x^2 - y^2 = \left(1 - \frac{1}{10^{17}}\right) (x - y)(x + y)",
        r"\sin(x + y) = \sin x \cos y + \left(1 + \frac{1}{10^{16}}\right) \cos x \sin y",
    ] {
        let found = finding(&numbers(), latex);
        assert_eq!(found.verdict, Refuted, "{latex}: {found:?}");
        assert!(found.message.contains("less than rounding error"), "{latex}: {}", found.message);
        assert!(found.max_residual.is_some_and(|residual| residual < 1e-14), "numbers agree on {latex}: {found:?}");
    }
    // The twin: what numbers show they show by a state.
    let seen = finding(&numbers(), r"\left(1 + \frac{1}{10^{9}}\right) x = x");
    assert!(seen.verdict == Refuted && seen.counterexample.is_some(), "{seen:?}");
}

#[test]
fn signs_branches_and_orders_only_numbers_see() {
    // In a field a root has two signs, and the product of two roots is a root of the product.
    let domain = finding(&numbers(), r"\sqrt{x} \sqrt{y} = \sqrt{xy}");
    assert_eq!(domain.verdict, Domain, "{domain:?}");
    assert_eq!(finding(&numbers(), r"\sqrt{a} \sqrt{b} = \sqrt{ab}").verdict, Certified);
    for wrong in [r"\sqrt{x^2} = x", "|x| = x", "a + b > a + c", r"\sqrt{x^2 + 2xy + y^2} = x + y"] {
        let found = finding(&numbers(), wrong);
        assert!(found.verdict == Refuted && found.counterexample.is_some(), "{wrong}: {found:?}");
    }
    // What is true and says nothing stays open, though it be an identity.
    let under = |latex: &str| equation(&numbers(), &[latex], assuming(&["x = y"])).finding.verdict;
    assert_eq!((under("2x = 2y"), under("x^2 + xz = y^2 + yz")), (Undecided, Certified));
}
