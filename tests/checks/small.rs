//! What holds while something is small, what is true exactly when something else is, and bodies made of bodies.

use onshell::check::Verdict::{self, Law, Refuted, Undecided, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, error, numbered, numbers, pendulum, verdict, with};

fn numbers_with(x: &str) -> Json {
    with(&numbers(), "constants", json!({ "a, b, c": "> 0", "x": x, "y": "any" }))
}

#[test]
fn an_approximation_has_an_order() {
    let to_order =
        |latex: &str, order: u32| verdict(&numbers_with("any"), &[latex], json!({ "small": "x", "order": order }));
    assert_eq!(to_order(r"a \sin x \approx a x", 1), Verified);
    assert_eq!(to_order(r"a \sin x \approx a x", 2), Verified);
    assert_eq!(to_order(r"a \sin x \approx a x", 3), Refuted);
    assert_eq!(to_order(r"a \sin x \approx a x - \frac16 a x^3", 3), Verified);
    assert_eq!(to_order(r"a \sin x \approx a x + \frac16 a x^3", 3), Refuted);
    assert_eq!(to_order(r"a \cos x \approx a", 1), Verified);
    assert_eq!(to_order(r"a \cos x \approx a", 2), Refuted);
    assert_eq!(to_order(r"a \cos x \approx a - \frac12 a x^2", 2), Verified);
    assert_eq!(to_order(r"a \cos x \approx a - a x^2", 2), Refuted);
    assert_eq!(to_order(r"\frac{a}{1 + x} \approx a - a x", 1), Verified);
    assert_eq!(to_order(r"\frac{a}{1 + x} \approx a + a x", 1), Refuted);
}

#[test]
fn small_alone_is_first_order() {
    let small = |latex: &str| verdict(&numbers_with("> 0"), &[latex], json!({ "small": "x" }));
    assert_eq!(small(r"\sqrt{a^2 + x} \approx a + \frac{x}{2a}"), Verified);
    assert_eq!(small(r"\sqrt{a^2 + x} \approx a + \frac{x}{a}"), Refuted);
    assert_eq!(small(r"\sqrt{a^2 + x} \approx a"), Refuted);
}

#[test]
fn what_is_left_over_may_be_small_itself() {
    let to_order =
        |latex: &str, order: u32| verdict(&numbers_with("any"), &[latex], json!({ "small": "x", "order": order }));
    for (right, wrong, order) in [
        (r"\sin x \approx x", r"\sin x \approx 1.00001 x", 1),
        (r"\cos x \approx 1", r"\cos x \approx 1 - 10^{-5} x", 1),
        (r"\cos x \approx 1 - \frac{x^2}{2}", r"\cos x \approx 1 - \frac{x^2}{2.0001}", 2),
        (r"a (1 - \cos x) \approx \frac12 a x^2", r"a (1 - \cos x) \approx 0.5005 a x^2", 2),
    ] {
        assert_eq!(to_order(right, order), Verified, "{right}");
        assert!(!to_order(wrong, order).passes(), "{wrong}");
    }
}

#[test]
fn a_term_beyond_the_order_could_be_anything_inside_of_a_factor_too() {
    let small = |latex: &str| verdict(&numbers_with("any"), &[latex], json!({ "small": "x" }));
    for (right, wrong) in [
        (r"\sin x \approx x", r"\sin x \approx x (1 + x)"),
        (r"(1 + x)^2 \approx 1 + 2x", r"(1 + x)^2 \approx (1 + 2x)(1 + 3 x^2)"),
        (r"(1 + x)^2 \approx a \frac{1 + 2x}{a}", r"(1 + x)^2 \approx \frac{1 + 2x}{1 + 3 x^2}"),
        (r"\frac{1}{1 + x} \approx \sqrt{1 - 2x}", r"\frac{1}{1 + x} \approx \sqrt{1 - 2x + 7 x^2}"),
    ] {
        assert_eq!(small(right), Verified, "{right}");
        assert_eq!(small(wrong), Undecided, "{wrong}");
    }
    // On the left the exact formula may stand.
    assert_eq!(small(r"\sqrt{1 + a x + 7 x^2} \approx 1 + \frac12 a x"), Verified);
}

#[test]
fn several_things_are_small_together() {
    let small = |latex: &str, which: Json| verdict(&numbers_with("any"), &[latex], json!({ "small": which }));
    assert_eq!(small(r"(a + x)(b + y) \approx ab + ay + bx", json!(["x", "y"])), Verified);
    assert_eq!(small(r"(a + x)(b + y) \approx ab + ay", json!(["x", "y"])), Refuted);
    // With y as it is, x y is of first order.
    assert_eq!(small(r"(a + x)(b + y) \approx ab + ay + bx", json!(["x"])), Refuted);
}

#[test]
fn small_oscillations_obey_the_motion() {
    let small = |latex: &str| verdict(&pendulum(), &[latex], json!({ "small": r"\theta" }));
    assert_eq!(small(r"l \ddot\theta + g \theta \approx 0"), Verified);
    assert_eq!(small(r"l \ddot\theta - g \theta \approx 0"), Refuted);
    assert_eq!(small(r"l \ddot\theta + 2g \theta \approx 0"), Refuted);
    assert_eq!(small(r"l \ddot\theta \approx 0"), Refuted);
    // Whatever the motion is, this is small.
    assert_ne!(small(r"\theta^2 \approx 0"), Verified);
}

#[test]
fn small_is_said_of_an_approximation_and_of_symbols() {
    assert_eq!(verdict(&numbers_with("any"), &[r"a \sin x \approx a x"], json!({})), Unreadable);
    assert!(error(&numbers_with("any"), &[r"a \sin x \approx ax"], json!({ "order": 1 })).contains("claims.json:"));
    assert!(error(&numbers_with("any"), &[r"a \sin x \approx ax"], json!({ "small": "z" })).contains("claims.json:"));
}

fn exactly(latex: &str, conditions: Json) -> Verdict {
    verdict(&numbers_with("any"), &[latex], json!({ "true exactly when": conditions }))
}

#[test]
fn true_where_it_is_said_and_nowhere_else() {
    assert_eq!(exactly("x^2 > a^2", json!({ "any of": [["x > a"], ["x < -a"]] })), Verified);
    // One alternative too few, and one too many.
    assert_eq!(exactly("x^2 > a^2", json!(["x > a"])), Refuted);
    assert_eq!(exactly("x^2 > a^2", json!({ "any of": [["x > a"], ["x < -a"], ["x > -a"]] })), Refuted);
    assert_eq!(exactly("x^2 > a^2", json!({ "any of": [["x > a"], ["x < a"]] })), Refuted);
}

#[test]
fn conditions_of_one_alternative_hold_together() {
    assert_eq!(exactly("x^2 < a^2", json!(["x < a", "x > -a"])), Verified);
    // One condition too few, and one too many.
    assert_eq!(exactly("x^2 < a^2", json!(["x < a"])), Refuted);
    assert_eq!(exactly("x^2 < a^2", json!(["x < a", "x > -a", "x > 0"])), Refuted);
}

#[test]
fn the_edge_counts() {
    assert_eq!(exactly(r"x^2 \geq a^2", json!({ "any of": [[r"x \geq a"], [r"x \leq -a"]] })), Verified);
    assert_eq!(exactly("x y > 0", json!({ "any of": [["x > 0", "y > 0"], ["x < 0", "y < 0"]] })), Verified);
    assert_eq!(exactly(r"x y \geq 0", json!({ "any of": [["x > 0", "y > 0"], ["x < 0", "y < 0"]] })), Refuted);
    assert_eq!(exactly("(a - b)(a - c) > 0", json!({ "any of": [["a > b", "a > c"], ["a < b", "a < c"]] })), Verified);
    assert_eq!(
        exactly("(a - b)(a - c) > 0", json!({ "any of": [[r"a \geq b", r"a \geq c"], ["a < b", "a < c"]] })),
        Refuted
    );
}

#[test]
fn true_exactly_when_needs_both_cases() {
    // It always holds, so there is no state where it must fail.
    assert_ne!(exactly("x^2 + a > 0", json!(["a > 0"])), Verified);
    assert_ne!(exactly("x^2 + a < 0", json!(["a < 0"])), Verified);
}

/// Two families of particles.
fn two_bodies() -> Json {
    json!({
        "indices": { "i": "1..n" },
        "constants": { "m_i, m_{1i}, m_{2i}": "> 0", r"\vec r_i, \vec r_{1i}, \vec r_{2i}": "any" },
        "define": { "M": r"\sum_i m_i", r"\vec S": r"\sum_i m_i \vec r_i" },
    })
}

fn together(latex: &str, meanings: Json) -> Verdict {
    verdict(&two_bodies(), &[latex], json!({ "where": meanings }))
}

#[test]
fn a_body_made_of_two_has_the_particles_of_both() {
    let both = json!({ "m_i": r"m_{1i} \cup m_{2i}", r"\vec r_i": r"\vec r_{1i} \cup \vec r_{2i}" });
    let masses = |right: &str| together(&format!(r"M = {right}"), both.clone());
    assert_eq!(masses(r"\sum_i m_{1i} + \sum_i m_{2i}"), Verified);
    assert_eq!(masses(r"\sum_i m_{1i}"), Refuted);
    assert_eq!(masses(r"\sum_i m_{1i} - \sum_i m_{2i}"), Refuted);
    let moments = |right: &str| together(&format!(r"\vec S = {right}"), both.clone());
    assert_eq!(moments(r"\sum_i m_{1i} \vec r_{1i} + \sum_i m_{2i} \vec r_{2i}"), Verified);
    assert_eq!(moments(r"\sum_i m_{1i} \vec r_{2i} + \sum_i m_{2i} \vec r_{1i}"), Refuted);
    let crossed = json!({ "m_i": r"m_{2i} \cup m_{1i}", r"\vec r_i": r"\vec r_{1i} \cup \vec r_{2i}" });
    let sum = r"\vec S = \sum_i m_{1i} \vec r_{1i} + \sum_i m_{2i} \vec r_{2i}";
    assert_eq!(together(sum, crossed), Refuted);
    // Without the meaning it is false.
    assert_eq!(verdict(&two_bodies(), &[sum], json!({})), Refuted);
}

#[test]
fn a_mirror_image_is_a_second_body() {
    let mirrored = json!({ "m_i": r"m_i \cup m_i", r"\vec r_i": r"\vec r_i \cup -\vec r_i" });
    assert_eq!(together(r"\vec S = \vec 0", mirrored), Verified);
    let doubled = json!({ "m_i": r"m_i \cup m_i", r"\vec r_i": r"\vec r_i \cup \vec r_i" });
    assert_eq!(together(r"\vec S = \vec 0", doubled), Refuted);
    let unequal = json!({ "m_i": r"m_i \cup 2 m_i", r"\vec r_i": r"\vec r_i \cup -\vec r_i" });
    assert_eq!(together(r"\vec S = \vec 0", unequal), Refuted);
}

#[test]
fn where_gives_a_symbol_a_meaning_in_one_equation_only() {
    let double = |latex: &str| verdict(&numbers(), &[latex], json!({ "where": { "a": "2b" } }));
    assert_eq!(double("a^2 = 4b^2"), Verified);
    assert_eq!(double("a^2 = 2b^2"), Refuted);
    assert_eq!(verdict(&numbers(), &["a^2 = 4b^2"], json!({})), Refuted);
    assert_eq!(verdict(&numbers(), &["a^2 = 4b^2"], json!({ "where": { "a": "-2b" } })), Verified);
}

#[test]
fn exactly_when_says_something_and_all_of_it_is_met() {
    let when =
        |condition: Json| verdict(&numbers_with("any"), &["x^2 > a^2"], json!({ "true exactly when": condition }));
    assert_eq!(when(json!({ "any of": ["x > a", "x < -a"] })), Verified);
    assert_eq!(when(json!("x > a")), Refuted);
    // The claim itself, and an alternative that no state meets.
    assert_eq!(when(json!("x^2 > a^2")), Undecided);
    assert_eq!(when(json!({ "any of": ["x > a", "x < -a", "x^2 < -a"] })), Undecided);
}

#[test]
fn a_law_is_a_law_wherever_it_is_printed() {
    let spring = json!({
        "varies with time": { "x": "any" },
        "constants": { "m, k, b": "> 0" },
        "laws": { "the force": r"m \ddot x = -k x" },
    });
    let of = |latex: &str| verdict(&spring, &[latex], json!({}));
    assert_eq!(of(r"m \ddot x = -k x"), Law);
    assert_eq!(of(r"\ddot x = -\frac{k}{m} x"), Verified);
    assert_eq!(of(r"m \ddot x = -2 k x"), Refuted);
    assert_eq!(of(r"m \ddot x = -k x - b \dot x"), Refuted);
}

#[test]
fn what_is_meant_cannot_go_in_a_circle() {
    let claims = json!({ "varies with time": { "x, v, w": "any", r"\vec u, \vec s": "any" } });
    let circle = json!({ "where": { "v": "w + 1", "w": "v - 1" } });
    assert!(error(&claims, &[r"v = \dot x"], circle).contains("the meaning of w contains w itself"));
    assert_eq!(verdict(&claims, &["v = w + x"], json!({ "where": { "v": "w + 1", "w": "x" } })), Refuted);
    // Two hypotheses that each make one of two vectors parallel to the other.
    let both = json!({ "assume": [r"\vec u \propto \vec s", r"\vec s \propto \vec u"] });
    assert_eq!(verdict(&claims, &[r"\vec u = \vec s"], both.clone()), Refuted);
    assert_eq!(verdict(&claims, &[r"\vec u \times \vec s = 0"], both), Verified);
}

#[test]
fn families_are_joined_where_a_name_gets_its_meaning_and_nowhere_else() {
    let joined = r"m_{1i} \cup m_{2i}";
    assert_eq!(verdict(&two_bodies(), &[&format!("m_i = {joined}")], json!({})), Unreadable);
    for claim in [
        json!({ "assume": format!("m_i = {joined}") }),
        json!({ "throughout": format!("m_i = {joined}") }),
        json!({ "also equals": joined }),
        json!({ "dropping": joined }),
        json!({ "conserved": joined }),
        json!({ "true exactly when": format!("m_i > {joined}") }),
        json!({ "where": { "M": joined } }),
    ] {
        let message = error(&two_bodies(), &["M > 0"], claim.clone());
        assert!(message.starts_with("claims.json:"), "{claim}: {message}");
    }
    let defined = with(&two_bodies(), "define", json!({ "q_i": joined }));
    assert!(error(&defined, &["m_1 > 0"], json!({})).contains("joins families"));
    let law = with(&two_bodies(), "laws", json!({ "one": format!("m_i = {joined}") }));
    assert!(error(&law, &["m_1 > 0"], json!({})).contains("joins families"));
}

#[test]
fn a_joined_family_is_not_named_bare() {
    let both = json!({ "m_i": r"m_{1i} \cup m_{2i}" });
    let claim = |latex: &str, key: &str, value: &str| {
        verdict(&two_bodies(), &[latex], json!({ "where": both.clone(), key: value }))
    };
    assert_eq!(together("M > 0", both.clone()), Verified);
    for bare in ["m_1 > 0", r"\sum_i m_i = \sum_i m_{1i} + \sum_i m_{2i}", r"m_1 \approx m_1 + M"] {
        assert_eq!(together(bare, both.clone()), Unreadable, "{bare}");
    }
    // Nor by a hypothesis or a condition.
    assert_eq!(claim("M > 0", "assume", "m_1 > m_{21}"), Unreadable);
    assert_eq!(claim("M > 0", "assume", "m_{11} > m_{21}"), Verified);
    assert_eq!(claim("M > m_{11}", "true exactly when", "m_1 > m_{21}"), Unreadable);
}

#[test]
fn an_approximation_tests_the_definition_of_a_name_in_it() {
    let claims = with(&pendulum(), "equations", json!({ "2": { "small": r"\theta", "order": 2 } }));
    let made = |displays: &[&str]| {
        document(&claims, &numbered(displays), &Registry::standard(), None).expect("the claims fit")
    };
    let found = |definition: &str| {
        let document = made(&[definition, r"\ddot\theta \approx -\omega^2 \theta"]);
        document.equations.iter().map(|equation| equation.finding.verdict).collect::<Vec<_>>()
    };
    assert_eq!(found(r"\omega = \sqrt{\frac{g}{l}}"), [Verdict::Definition, Verified]);
    // The case that must fail: a slip in the definition makes the approximation fail.
    assert_eq!(found(r"\omega = \sqrt{\frac{l}{g}}")[1], Refuted);
    // A name that does not matter there is not tested.
    let found = made(&[r"\omega = \sqrt{\frac{g}{l}}", r"\sin\theta \approx \theta + 0 \omega"]);
    assert_eq!(found.equations[0].finding.verdict, Undecided);
}

#[test]
fn a_sum_with_dots_holds_to_the_order_of_its_last_term() {
    let judged = |latex: &str| verdict(&numbers_with("any"), &[latex], json!({}));
    for (right, wrong) in [
        (r"a \cos x = a - \frac12 a x^2 + \dots", r"a \cos x = a - \frac13 a x^2 + \dots"),
        (r"\sin x = x - \frac16 x^3 + O(x^5)", r"\sin x = x - \frac16 x^3 + O(x^6)"),
        (r"\sqrt{a^2 + x} = a + \frac{x}{2a} + \cdots", r"\sqrt{a^2 + x} = a + \frac{x}{a} + \cdots"),
        (r"\frac{1}{1 - x} = 1 + x + x^2 + \ldots", r"\frac{1}{1 - x} = 1 + x + x^3 + \ldots"),
        (
            r"b \sin x = b x\left(1 - \frac{x^2}{6} + \dots\right)",
            r"b \sin x = b x\left(1 - \frac{x^2}{3} + \dots\right)",
        ),
        (r"e^x = 1 + x + \mathcal{O}(x^2)", r"e^x = 1 - x + \mathcal{O}(x^2)"),
    ] {
        assert_eq!(judged(right), Verified, "{right}");
        assert_eq!(judged(wrong), Refuted, "{wrong}");
    }
    // must-fail cases: nothing says what is small, and dots in the middle
    assert_eq!(judged(r"\sin x + \cos y = 1 + x + y + \dots"), Undecided);
    assert_eq!(judged(r"e^x = 1 + x + \dots + x^2"), Unreadable);
    // What the claims file says goes before.
    let small = json!({ "small": "x", "order": 3 });
    assert_eq!(verdict(&numbers_with("any"), &[r"\sin x = x + \dots"], small), Refuted);
}
