//! `onshell mark`, where a line is about the place of an extremum, an instant that a phase gives, the steady motion, or a letter that
//! means an energy. Beside each line that is not wrong stands one that must not pass.

use crate::support::marks;

/// A driven oscillator, with the frequency of the largest amplitude.
const DRIVEN: (&str, &str) = (
    "$$ m \\ddot x = -k x - 2 m \\gamma \\dot x + F_0 \\cos\\omega t \\tag{1} $$\n\n\
     $$ A = \\frac{F_0}{m \\sqrt{(\\omega_0^2 - \\omega^2)^2 + 4 \\gamma^2 \\omega^2}} \\tag{2} $$\n\n\
     $$ \\omega_r = \\sqrt{\\omega_0^2 - 2 \\gamma^2} \\tag{3} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "x": "any" }, "constants": { "m, k, F_0, \\omega, \\gamma, \\delta": "> 0",
            "\\omega_0": "\\sqrt{k/m}" },
        "laws": { "Newton": "1" }, "assume": ["\\omega_0 > 2\\gamma"], "define": { "\\omega_r": "\\sqrt{\\omega_0^2 - 2\\gamma^2}" },
        "rubric": { "results": { "3": 1 } } }"#,
);

/// A pendulum on a shaken rail: the steady motion solves the equation for small angles.
const RAIL: (&str, &str) = (
    "We find the steady motion $\\theta = B \\cos\\Omega t$ for small angles.\n\n\
     $$ x = a \\cos\\Omega t + l \\sin\\theta, \\qquad y = -l \\cos\\theta \\tag{1} $$\n\n\
     $$ L = \\frac12 m (\\dot x^2 + \\dot y^2) - m g y \\tag{2} $$\n\n\
     For small angles\n\n$$ \\ddot\\theta + \\omega_0^2 \\theta = \\frac{a \\Omega^2}{l} \\cos\\Omega t \\tag{3} $$\n\n\
     $$ B = \\frac{a \\Omega^2}{l (\\omega_0^2 - \\Omega^2)} \\tag{4} $$\n\n$$ C = a + l B \\tag{5} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" },
        "constants": { "m, l, g, a, \\Omega": "> 0", "\\omega_0": "\\sqrt{g/l}" }, "means": { "L": "Lagrangian" },
        "rubric": { "results": { "4": 1, "5": 1 } } }"#,
);

#[test]
fn the_place_of_an_extremum_is_no_identity() {
    let of = |name: &str, lines: &str| marks(name, DRIVEN, lines);
    assert_eq!(of("words", "The amplitude is largest for $\\omega^2 = \\omega_0^2 - 2\\gamma^2$.\n"), ["right"]);
    let at_first = "The amplitude is largest where\n\n";
    assert_eq!(
        of("zero", &format!("{at_first}$$ -4 \\omega (\\omega_0^2 - \\omega^2) + 8 \\gamma^2 \\omega = 0 $$\n")),
        ["right"]
    );
    let named = "With $s = \\omega^2$ the amplitude is largest for $s = \\omega_0^2 - 2\\gamma^2$.\n";
    assert_ne!(of("named", named)[1], "wrong");
    // The twins: other places, and no word of an extremum.
    assert_eq!(of("words-false", "The amplitude is largest for $\\omega^2 = \\omega_0^2 - 4\\gamma^2$.\n"), ["wrong"]);
    assert_eq!(
        of("zero-false", &format!("{at_first}$$ -4 \\omega (\\omega_0^2 - \\omega^2) + 4 \\gamma^2 \\omega = 0 $$\n")),
        ["wrong"]
    );
    assert_ne!(of("zero-unsaid", "$$ -4 \\omega (\\omega_0^2 - \\omega^2) + 8 \\gamma^2 \\omega = 0 $$\n"), ["right"]);
    assert_ne!(of("unsaid", "$$ \\omega^2 = \\omega_0^2 - 2\\gamma^2 $$\n"), ["right"]);
}

#[test]
fn a_phase_names_an_instant() {
    let of = |name: &str, lines: &str| marks(name, DRIVEN, lines);
    let two = "At $\\omega t = \\delta$ and at $\\omega t = \\delta + \\pi/2$ the body turns.\n";
    assert_eq!(of("phase", two), ["given", "given"]);
    // The twin: without the time it says something of constants.
    assert_eq!(of("phase-false", "It is $\\omega \\gamma = \\omega_0^2$.\n"), ["wrong"]);
}

#[test]
fn the_steady_motion_is_no_solution_of_the_exact_law_and_not_wrong() {
    let of = |name: &str, lines: &str| marks(name, RAIL, lines);
    assert_eq!(
        of("steady", "For small angles $\\theta = B \\cos\\Omega t$ and $x = C \\cos\\Omega t$.\n"),
        ["given", "given"]
    );
    let chain = "For small angles $x = a \\cos\\Omega t + l \\theta = (a + l B) \\cos\\Omega t$.\n";
    assert_eq!(of("steady-chain", chain), ["given"]);
    // The twins: other amplitudes.
    let wrong = "For small angles $\\theta = 2 B \\cos\\Omega t$ and $x = 2 C \\cos\\Omega t$.\n";
    assert_eq!(of("steady-false", wrong), ["wrong", "wrong"]);
    assert_eq!(of("steady-chain-false", &chain.replace("l B", "2 l B")), ["wrong"]);
}

#[test]
fn a_letter_of_a_period_may_be_a_kinetic_energy() {
    let problem = (
        "$$ L = \\frac12 m \\dot x^2 - \\frac12 k x^2 \\tag{1} $$\n\n$$ T = 2\\pi \\sqrt{\\frac{m}{k}} \\tag{2} $$\n",
        r#"{ "notes": "p.md", "coordinates": { "x": "any" }, "constants": { "m, k": "> 0" }, "means": { "L": "Lagrangian" },
            "rubric": { "results": { "2": 1 } } }"#,
    );
    assert_eq!(marks("energy", problem, "$$ T = \\frac12 m \\dot x^2 $$\n"), ["given"]);
    // The twin: another period.
    assert_eq!(marks("energy-false", problem, "$$ T = \\pi \\sqrt{\\frac{m}{k}} $$\n"), ["wrong"]);
}

#[test]
fn a_slope_by_a_constant_is_a_partial_derivative_and_may_be_set_to_0() {
    let range = (
        "$$ R = \\frac{v_0^2 \\sin 2\\alpha}{g} \\tag{1} $$\n",
        r#"{ "notes": "p.md", "constants": { "v_0, g": "> 0", "\\alpha": "(0, \\pi/2)" }, "rubric": { "results": { "1": 1 } } }"#,
    );
    let of = |name: &str, line: &str| {
        marks(name, range, &format!("$$ R = \\frac{{v_0^2 \\sin 2\\alpha}}{{g}} $$\n\n$$ {line} $$\n")).pop().unwrap()
    };
    let slope = "\\frac{dR}{d\\alpha} = \\frac{2 v_0^2 \\cos 2\\alpha}{g}";
    assert_eq!(of("slope", slope), "right");
    assert_eq!(of("chain", &format!("{slope} = 0")), "right");
    assert_eq!(of("condition", "\\frac{dR}{d\\alpha} = 0"), "given");
    // The twins: a lost factor, alone and with the condition.
    assert_eq!(of("slope-slip", &slope.replace("2 v_0", "v_0")), "wrong");
    assert_eq!(of("chain-slip", &format!("{} = 0", slope.replace("2 v_0", "v_0"))), "wrong");
}
