//! `onshell mark` for oscillations: lines about an equilibrium and about modes, a trial solution, a limit, and steps from a false momentum.
//! Beside each line that is right or carried stands one that is not.

use crate::support::marks;

/// Two pendulums with a spring, for small angles.
const PENDULUMS: (&str, &str) = (
    "$$ L = \\frac12 m l^2 (\\dot\\varphi_1^2 + \\dot\\varphi_2^2) - \\frac12 m g l (\\varphi_1^2 + \\varphi_2^2) - \\frac12 k l^2 (\\varphi_1 - \\varphi_2)^2 \\tag{1} $$\n\n\
     $$ \\ddot\\varphi_1 = -\\frac gl \\varphi_1 - \\frac km (\\varphi_1 - \\varphi_2) \\tag{2} $$\n\n\
     $$ \\ddot\\varphi_2 = -\\frac gl \\varphi_2 + \\frac km (\\varphi_1 - \\varphi_2) \\tag{3} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\varphi_1, \\varphi_2": "any" }, "constants": { "m, g, l, k": "> 0" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "2": 1, "3": 1 } } }"#,
);

/// A mass on a spring with friction.
const DAMPED: (&str, &str) = (
    "$$ m \\ddot x = -k x - b \\dot x \\tag{1} $$\n\n$$ E = \\frac12 m \\dot x^2 + \\frac12 k x^2 $$\n\n$$ \\dot E = -b \\dot x^2 \\tag{2} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "x": "any" }, "constants": { "m, k, b": "> 0" },
        "laws": { "Newton": "1" }, "rubric": { "results": { "2": 1 } } }"#,
);

/// A block on a wedge that slides.
const WEDGE: (&str, &str) = (
    "$$ L = \\frac12 (M + m) \\dot X^2 + \\frac12 m \\dot s^2 + m \\dot X \\dot s \\cos\\alpha + m g s \\sin\\alpha \\tag{1} $$\n\n\
     $$ \\ddot s = \\frac{(M + m) g \\sin\\alpha}{M + m \\sin^2\\alpha} \\tag{2} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "X, s": "any" }, "constants": { "m, M, g": "> 0", "\\alpha": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "2": 1 } } }"#,
);

#[test]
fn an_equilibrium_makes_no_equation_of_motion_true() {
    let of = |name: &str, line: &str| {
        marks(name, PENDULUMS, &format!("In equilibrium $\\varphi_1 = \\varphi_2 = 0$.\n\n$$ {line} $$\n"))
            .pop()
            .unwrap()
    };
    assert_eq!(of("motion", "\\ddot\\varphi_1 = -\\frac gl \\varphi_1"), "wrong");
    assert_eq!(of("rates", "\\dot\\varphi_1 = \\dot\\varphi_2"), "wrong");
    // The twins: what holds of every motion, and what the equilibrium says of some terms.
    assert_eq!(of("every", "\\ddot\\varphi_1 + \\ddot\\varphi_2 = -\\frac gl (\\varphi_1 + \\varphi_2)"), "right");
    assert_eq!(of("some", "\\ddot\\varphi_1 = 0"), "right");
}

#[test]
fn in_a_mode_that_the_text_names_its_equation_of_motion_holds() {
    let of = |name: &str, mode: &str, line: &str| {
        let before = "In phase: $\\varphi_1 = \\varphi_2$.\n\n";
        marks(name, PENDULUMS, &format!("{before}Then $\\varphi_2 = {mode}$:\n\n$$ {line} $$\n")).pop().unwrap()
    };
    let line = "\\ddot\\varphi_1 = -\\left(\\frac gl + \\frac{2 k}m\\right) \\varphi_1";
    assert_eq!(of("mode", "-\\varphi_1", line), "right");
    // The twins: another factor, and no mode of this kind.
    assert_eq!(of("factor", "-\\varphi_1", &line.replace("2 k", "3 k")), "wrong");
    assert_eq!(marks("general", PENDULUMS, &format!("$$ {line} $$\n")), ["wrong"]);
}

#[test]
fn an_exponential_trial_has_its_characteristic_equation() {
    let of = |name: &str, line: &str| {
        marks(name, DAMPED, &format!("Ansatz $x = C e^{{\\lambda t}}$:\n\n$$ {line} $$\n")).pop().unwrap()
    };
    assert_eq!(of("characteristic", "m \\lambda^2 + b \\lambda + k = 0"), "right");
    assert_ne!(of("sign", "m \\lambda^2 + b \\lambda - k = 0"), "right");
    assert_ne!(of("power", "m \\lambda^2 + b + k = 0"), "right");
}

#[test]
fn a_line_holds_in_the_limit_that_its_sentence_names() {
    let of = |name: &str, limit: &str, line: &str| {
        marks(name, WEDGE, &format!("For ${limit}$ the wedge rests and ${line}$.\n")).pop().unwrap()
    };
    assert_eq!(of("limit", "M \\to \\infty", "\\ddot s = g \\sin\\alpha"), "right");
    // The twins: another factor, another limit, and another sentence.
    assert_eq!(of("factor", "M \\to \\infty", "\\ddot s = 2 g \\sin\\alpha"), "wrong");
    assert_eq!(of("other", "m \\to \\infty", "\\ddot s = g \\sin\\alpha"), "wrong");
    let apart = "The wedge rests for $M \\to \\infty$. In general $\\ddot s = g \\sin\\alpha$.\n";
    assert_eq!(marks("apart", WEDGE, apart), ["wrong"]);
}

#[test]
fn an_equation_of_motion_is_carried_from_a_false_momentum() {
    let lines = |factor: &str| {
        format!(
            "$$ \\frac{{\\partial L}}{{\\partial\\dot s}} = m \\dot s + m \\dot X \\sin\\alpha $$\n\n\
             $$ m \\ddot s + {factor} m \\ddot X \\sin\\alpha = m g \\sin\\alpha $$\n"
        )
    };
    assert_eq!(marks("momentum", WEDGE, &lines("")), ["wrong", "carried"]);
    assert_eq!(marks("momentum-slip", WEDGE, &lines("2")), ["wrong", "wrong"]);
}
