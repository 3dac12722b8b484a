//! `onshell mark`, where a claim of the problem holds in a case alone, and what earns a result. Beside each line that is right stands
//! one that must not be.

use crate::support::{self, marks};

/// A rocket: the acceleration is a result at the start alone.
const ROCKET: (&str, &str) = (
    "$$ m = m_0 - \\alpha t \\tag{1} $$\n\n$$ m \\dot v = \\alpha u - m g \\tag{2} $$\n\n\
     $$ a_0 = \\frac{\\alpha u}{m_0} - g \\tag{3} $$\n\n$$ v = u \\ln\\frac{m_0}{m_0 - \\alpha t} - g t \\tag{4} $$\n\n\
     $$ z = u t - \\frac12 g t^2 - \\frac{u}{\\alpha} (m_0 - \\alpha t) \\ln\\frac{m_0}{m_0 - \\alpha t} \\tag{5} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "v, z": "any" }, "constants": { "m_0, \\alpha, u, g": "> 0" },
        "define": { "m": "m_0 - \\alpha t" }, "laws": { "momentum": "2", "velocity": "\\dot z = v" },
        "equations": { "3": { "also equals": "\\dot v", "assume": "t = 0" }, "4": { "assume": "v(0) = 0" },
                       "5": { "assume": "v(0) = 0, z(0) = 0" } },
        "rubric": { "results": { "3": 1, "4": 2, "5": 2 }, "half for": ["sign"] } }"#,
);

/// Two bodies, with the energy on a circle.
const CIRCLE: (&str, &str) = (
    "$$ L = \\frac12 m (\\dot r^2 + r^2 \\dot\\varphi^2) + \\frac{k}{r} \\tag{1} $$\n\n\
     $$ E_0 = -\\frac{k}{2 r_0} \\tag{2} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "r": "> 0", "\\varphi": "angle" }, "constants": { "m, k, r_0": "> 0" },
        "means": { "L": "Lagrangian", "E": "energy" },
        "equations": { "2": { "also equals": "E", "throughout": "r = r_0" } }, "rubric": { "results": { "2": 1 } } }"#,
);

fn points(name: &str, problem: (&str, &str), lines: &str) -> f64 {
    support::points(&format!("points-{name}"), problem, lines)
}

#[test]
fn the_case_of_one_claim_is_granted_only_where_the_hand_in_says_so() {
    let of = |name: &str, lines: &str| marks(name, ROCKET, lines);
    let start = "\\dot v = \\frac{\\alpha u}{m_0} - g";
    assert_eq!(of("said", &format!("At $t = 0$ it is ${start}$.\n")), ["right", "right"]);
    assert_eq!(of("words", &format!("At the start ${start}$.\n")), ["right"]);
    assert_eq!(of("unsaid", &format!("$$ {start} $$\n")), ["undecided"]);
    // The twins: lines of which nothing is left at t = 0, and a false one there.
    let lines = "$$ v = u \\ln\\frac{m_0}{m_0 - \\alpha t} + 7 g t $$\n\n$$ z = 5 u t $$\n\n\
                 $$ m \\dot v = \\alpha u - m g - 3 \\alpha v $$\n";
    assert_eq!(of("unsaid-false", lines), ["wrong", "wrong", "wrong"]);
    let said = of("said-false", &format!("At $t = 0$:\n\n{lines}"));
    assert!(!said[1..].contains(&"right".to_owned()), "{said:?}");
    assert_eq!(of("words-false", "At the start $\\dot v = \\frac{2 \\alpha u}{m_0} - g$.\n"), ["wrong"]);
}

#[test]
fn a_line_with_the_name_of_a_place_is_about_the_place() {
    let of = |name: &str, lines: &str| marks(name, CIRCLE, lines);
    assert_eq!(of("place", "$$ E = -\\frac{k}{2 r_0} $$\n"), ["right"]);
    assert_eq!(of("place-said", "On the circle $r = r_0$ and $E = -\\frac{k}{2 r}$.\n"), ["right", "right"]);
    // The twins: another number, no place, and a deviation, which is 0 there.
    assert_eq!(of("place-false", "$$ E = -\\frac{k}{r_0} $$\n"), ["wrong"]);
    assert_ne!(of("place-unsaid", "$$ E = -\\frac{k}{2 r} $$\n"), ["right"]);
    let deviation = "$$ r = r_0 + \\eta $$\n\n$$ m \\ddot\\eta = -7 \\frac{k}{r_0^3} \\eta $$\n";
    assert_ne!(of("place-deviation", deviation)[1], "right");
}

#[test]
fn a_condition_earns_no_result() {
    let of = |name: &str, lines: &str| points(name, ROCKET, lines);
    for (name, line) in [("v", "At the start $v = 0$.\n"), ("z", "At the start $z = 0$.\n")] {
        assert!(of(&format!("condition-{name}"), line).abs() < 1e-9);
    }
    // The twin: the result does, also under the name that its claim gives it.
    assert!(
        of(
            "condition-result",
            &format!("$$ m\\dot v = \\alpha u - mg $$\n\n{}\n", &ROCKET.0[ROCKET.0.find("$$ v").unwrap()..])
        ) > 3.9
    );
    let start = "$$ m\\dot v = \\alpha u - mg $$\n\nAt $t = 0$: $\\dot v = \\frac{\\alpha u}{m_0} - g$\n";
    assert!(of("condition-start", start) > 0.9);
}

#[test]
fn a_false_line_earns_no_result_of_another_quantity() {
    let of = |name: &str, lines: &str| points(name, ROCKET, lines);
    assert!(of("other", "$$ v = 3 u $$\n").abs() < 1e-9);
    // The twin: a slip in the law, and what follows from it, which is the result with half of its points.
    let carried = "$$ m \\dot v = \\alpha u + m g $$\n\n$$ v = u \\ln\\frac{m_0}{m_0 - \\alpha t} + g t $$\n";
    assert_eq!(marks("other-carried", ROCKET, carried), ["wrong", "carried"]);
    assert!((of("other-carried", carried) - 1.0).abs() < 1e-9);
}

#[test]
fn a_line_that_uses_another_result_is_a_step() {
    let problem = (
        "$$ T = 2\\pi \\sqrt{\\frac{m}{k}} \\tag{1} $$\n\n$$ \\omega = \\sqrt{\\frac{k}{m}} \\tag{2} $$\n",
        r#"{ "notes": "p.md", "constants": { "m, k": "> 0" },
            "means": { "T": "2\\pi\\sqrt{\\frac{m}{k}}", "\\omega": "\\sqrt{\\frac{k}{m}}" },
            "rubric": { "results": { "1": 2, "2": 2 }, "half for": ["factor"] } }"#,
    );
    assert!(points("step", problem, "$$ \\omega = \\frac{2\\pi}{T} $$\n").abs() < 1e-9);
    assert!(points("step-false", problem, "$$ \\omega = 2 \\pi T $$\n").abs() < 1e-9);
    // The twin: with the period before it the line gives the frequency.
    let both = "$$ T = 2\\pi \\sqrt{\\frac{m}{k}} $$\n\n$$ \\omega = \\frac{2\\pi}{T} $$\n";
    assert!(points("step-known", problem, both) > 3.9);
}

#[test]
fn a_claim_about_a_part_of_a_display_serves_marks_too() {
    let problem = (
        "$$ L = \\frac12 m l^2 \\dot\\theta^2 + m g l \\cos\\theta \\tag{1} $$\n\n\
         $$ \\ddot\\theta + \\omega_0^2 \\theta = 0, \\qquad \\omega_0^2 = \\frac gl \\tag{2} $$\n",
        r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" }, "constants": { "m, l, g": "> 0" },
            "means": { "L": "Lagrangian" }, "equations": { "2 part 1": { "assume": "small oscillations about \\theta = 0" } },
            "rubric": { "results": { "2": 1 } } }"#,
    );
    assert_eq!(marks("part", problem, "$$ \\ddot\\theta = -\\frac gl \\theta $$\n"), ["right"]);
    // The twin: another factor.
    assert_eq!(marks("part-false", problem, "$$ \\ddot\\theta = -\\frac{2g}{l} \\theta $$\n"), ["wrong"]);
}
