//! `onshell mark`, where hand-ins write rates with primes beside letters of their own, one letter for several numbered values, a letter
//! of the problem for something else, or nothing but results. Beside each such line stands one that is wrong.

use crate::support::{self, marks};

/// Two coupled pendulums.
const PENDULUMS: (&str, &str) = (
    "$$ L = \\frac12 m l^2 (\\dot\\varphi_1^2 + \\dot\\varphi_2^2) - \\frac12 m g l (\\varphi_1^2 + \\varphi_2^2) \
     - \\frac12 k l^2 (\\varphi_1 - \\varphi_2)^2 \\tag{1} $$\n\n\
     $$ m l^2 \\ddot\\varphi_1 = -m g l \\varphi_1 - k l^2 (\\varphi_1 - \\varphi_2), \\qquad \
     m l^2 \\ddot\\varphi_2 = -m g l \\varphi_2 + k l^2 (\\varphi_1 - \\varphi_2) \\tag{2} $$\n\n\
     $$ \\omega_1 = \\sqrt{\\frac gl}, \\qquad \\omega_2 = \\sqrt{\\frac gl + \\frac{2k}{m}} \\tag{3} $$\n\n\
     $$ T = \\frac{2\\pi}{\\omega_1} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\varphi_1, \\varphi_2": "any" }, "constants": { "m, l, k, g": "> 0" },
        "means": { "L": "Lagrangian", "\\omega_1, \\omega_2": "normal frequency" },
        "rubric": { "results": { "2": 1, "3": 2, "4": 1 }, "half for": ["sign", "factor"] } }"#,
);

/// Atwood's machine with a heavy pulley.
const PULLEY: (&str, &str) = (
    "$$ m_1 a = m_1 g - S_1 \\tag{1} $$\n\n$$ m_2 a = S_2 - m_2 g \\tag{2} $$\n\n\
     $$ \\frac12 M R^2 \\frac aR = (S_1 - S_2) R \\tag{3} $$\n\n\
     $$ a = \\frac{m_1 - m_2}{m_1 + m_2 + \\frac12 M} g \\tag{4} $$\n\n\
     $$ S_1 = \\frac{2 m_2 + \\frac12 M}{m_1 + m_2 + \\frac12 M} m_1 g \\tag{5} $$\n\n\
     $$ v = \\sqrt{2 a h} \\tag{6} $$\n",
    r#"{ "notes": "p.md", "constants": { "m_1, m_2, M, R, g, h": "> 0", "a": "any", "S_1, S_2": "> 0" },
        "laws": { "Newton 1": "1", "Newton 2": "2", "torque": "3" },
        "rubric": { "results": { "4": 2, "5": 1, "6": 1 }, "half for": ["sign", "factor"] } }"#,
);

fn points(name: &str, problem: (&str, &str), lines: &str) -> f64 {
    support::points(&format!("mark-own-letters-{name}"), problem, lines)
}

#[test]
fn primes_are_rates_of_letters_of_the_students_own() {
    let of = |name: &str, sum: &str| {
        let lines = format!(
            "$$ m b^2 \\alpha'' = -m g b \\alpha - D b^2 (\\alpha - \\beta) $$\n\n\
             $$ m b^2 \\beta'' = -m g b \\beta + D b^2 (\\alpha - \\beta) $$\n\n\
             $$ (\\alpha + \\beta)'' = -{sum} (\\alpha + \\beta) $$\n"
        );
        marks(name, PENDULUMS, &lines)
    };
    assert_eq!(of("primes", "\\frac gb"), ["right", "right", "right"]);
    // The twin: a factor.
    assert_eq!(of("primes-wrong", "\\frac{2g}b"), ["right", "right", "wrong"]);
}

#[test]
fn one_letter_may_have_several_numbered_values() {
    let of = |name: &str, second: &str| {
        marks(name, PENDULUMS, &format!("$$ \\omega^2 = \\frac gl \\quad\\text{{or}}\\quad \\omega^2 = {second} $$\n"))
    };
    assert_eq!(of("or", "\\frac gl + \\frac{2k}{m}"), ["right", "right"]);
    // The twin: a value that is none of them.
    assert_eq!(of("or-wrong", "\\frac gl + \\frac{k}{m}"), ["right", "wrong"]);
}

#[test]
fn the_letter_of_a_period_may_be_a_kinetic_energy() {
    let of = |name: &str, sign: &str| {
        let lines = format!(
            "$$ T = \\frac12 m l^2 (\\dot\\varphi_1^2 + \\dot\\varphi_2^2) $$\n\n\
             $$ L = T - \\frac12 m g l (\\varphi_1^2 + \\varphi_2^2) {sign} \\frac12 k l^2 (\\varphi_1 - \\varphi_2)^2 $$\n\n\
             $$ T = 2\\pi\\sqrt{{\\frac lg}} $$\n"
        );
        marks(name, PENDULUMS, &lines)
    };
    let right = of("energy", "-");
    assert!(!right.contains(&"wrong".to_owned()) && right[2] == "right", "{right:?}");
    // The twin: a sign.
    assert!(of("energy-wrong", "+").contains(&"wrong".to_owned()));
}

#[test]
fn what_some_motions_keep_and_equal_frequencies_are_not_right() {
    assert_eq!(marks("modes", PENDULUMS, "$$ \\varphi_1 = \\varphi_2 $$\n"), ["given"]);
    assert_eq!(marks("equal", PENDULUMS, "$$ \\omega_1 = \\omega_2 $$\n"), ["wrong"]);
    // The twin: a frequency.
    assert_eq!(marks("frequency", PENDULUMS, "$$ \\omega_1 = \\sqrt{\\frac gl} $$\n"), ["right"]);
}

#[test]
fn a_list_of_results_is_without_steps() {
    let results = "$$ a = \\frac{m_1 - m_2}{m_1 + m_2 + \\frac12 M} g $$\n\n$$ v = \\sqrt{2 a h} $$\n";
    assert_eq!(points("list", PULLEY, results), 1.5);
    // The twin: a law leads to them.
    assert_eq!(points("steps", PULLEY, &format!("$$ m_1 a = m_1 g - S_1 $$\n\n{results}")), 3.0);
}

#[test]
fn equations_of_motion_are_a_first_step() {
    let first = "$$ m l^2 \\ddot\\varphi_1 = -m g l \\varphi_1 - k l^2 (\\varphi_1 - \\varphi_2) $$\n\n\
                 $$ m l^2 \\ddot\\varphi_2 = -m g l \\varphi_2 + k l^2 (\\varphi_1 - \\varphi_2) $$\n";
    assert_eq!(points("first", PENDULUMS, &format!("{first}\n$$ T = 2\\pi\\sqrt{{\\frac lg}} $$\n")), 2.0);
    // The twin: nothing but these.
    assert_eq!(points("alone", PENDULUMS, first), 0.5);
}

#[test]
fn a_result_with_a_slip_does_not_hide_behind_a_letter() {
    let of = |name: &str, value: &str| {
        let lines = format!("$$ a = \\frac{{m_1 - m_2}}{{m_1 + m_2 + \\frac12 M}} g $$\n\n$$ Z = {value} $$\n");
        marks(name, PULLEY, &lines)[1].clone()
    };
    assert_eq!(of("slip", "\\frac{2 m_2 - \\frac12 M}{m_1 + m_2 + \\frac12 M} m_1 g"), "undecided");
    // The twin: a quantity of the student's own.
    assert_eq!(of("own", "m_1 + m_2 + \\frac12 M"), "given");
}

#[test]
fn what_holds_under_a_condition_that_nobody_states_is_left_open() {
    let of = |name: &str, before: &str| marks(name, PULLEY, &format!("{before}\n\n$$ S_1 = S_2 $$\n"))[1].clone();
    assert_eq!(of("bare", "$$ m_1 = m_2 $$"), "undecided");
    // The twin: a word makes it a condition.
    assert_eq!(of("if", "If $m_1 = m_2$ then"), "right");
}
