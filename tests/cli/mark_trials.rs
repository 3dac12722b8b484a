//! `onshell mark`, where a line tries a solution with names of its own, speaks of a state in which something may be, or prints the
//! secular equation in its own form. Beside each true line stands one that must not be right.

use crate::support::marks;

/// Two pendulums with a spring between them.
const PENDULUMS: (&str, &str) = (
    "$$ L = \\frac12 m (\\dot x^2 + \\dot y^2) - \\frac{m g}{2 l} (x^2 + y^2) - \\frac12 k (x - y)^2 \\tag{1} $$\n\n\
     $$ m \\ddot x = -\\frac{m g}{l} x - k (x - y), \\qquad m \\ddot y = -\\frac{m g}{l} y + k (x - y) \\tag{2} $$\n\n\
     $$ \\left( \\frac{m g}{l} + k - m \\omega^2 \\right)^2 - k^2 = 0 \\tag{3} $$\n\n\
     $$ \\omega_1 = \\sqrt{\\frac gl} \\tag{4} $$\n\n$$ \\omega_2 = \\sqrt{\\frac gl + \\frac{2k}{m}} \\tag{5} $$\n\n\
     $$ x = \\frac a2 (\\cos\\omega_1 t + \\cos\\omega_2 t), \\qquad y = \\frac a2 (\\cos\\omega_1 t - \\cos\\omega_2 t) \\tag{6} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "x, y": "any" }, "constants": { "m, k, g, l, a, \\omega": "> 0" },
        "means": { "L": "Lagrangian", "\\omega_1, \\omega_2": "normal frequency" },
        "equations": { "3": { "secular equation for": "\\omega" } }, "rubric": { "results": { "5": 1 } } }"#,
);

/// A ball that is thrown upwards, with drag: the laws are Newton's.
const BALL: (&str, &str) = (
    "$$ m \\dot v = -m g - b v \\tag{1} $$\n\n$$ u = \\frac{m g}{b} \\tag{2} $$\n\n\
     $$ v = (w + u) e^{-b t/m} - u \\tag{3} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "v": "any" }, "constants": { "m, b, g, w": "> 0" },
        "laws": { "Newton": "1" }, "rubric": { "results": { "2": 1, "3": 1 } } }"#,
);

#[test]
fn a_constant_value_in_the_text_is_a_state_and_in_a_display_a_claim() {
    let of = |name: &str, lines: &str| marks(name, BALL, lines);
    assert_eq!(of("state", "The right side vanishes for $v = -u$.\n"), ["given"]);
    assert_eq!(of("state-formula", "One solution is the constant $v = -\\frac{g m}{b}$.\n"), ["given"]);
    let both = "With $s = x + y$ and $d = x - y$: at the start $s = d = a$.\n";
    assert_eq!(marks("state-both", PENDULUMS, both), ["given", "given", "given"]);
    // The twins: a display, a function of the time, a constant that is wanted.
    assert_eq!(of("state-display", "$$ v = -u $$\n"), ["wrong"]);
    assert_eq!(of("state-time", "It is $v = -u t$.\n"), ["wrong"]);
    assert_eq!(of("state-wanted", "It is $u = \\frac{m g}{2 b}$.\n"), ["wrong"]);
}

#[test]
fn a_trial_solution_is_given_and_what_the_laws_say_of_it_is_right() {
    let of = |name: &str, lines: &str| marks(name, PENDULUMS, lines);
    let tried = "With $x = A \\cos\\omega t$ and $y = B \\cos\\omega t$:\n\n";
    let right = "$$ \\left( \\frac gl + \\frac km - \\omega^2 \\right) A = \\frac km B $$\n\n";
    let modes = "In the first mode $A = B$, in the second $A = -B$.\n";
    assert_eq!(of("trial", &format!("{tried}{right}{modes}")), ["given", "given", "right", "given", "given"]);
    // The twins: a sign, and a function of the time that has nothing of its own.
    let wrong = right.replace("- \\omega^2", "+ \\omega^2");
    assert_eq!(of("trial-wrong", &format!("{tried}{wrong}{modes}"))[2], "undecided");
    assert_eq!(of("trial-known", "With $x = a \\cos\\omega t$:\n"), ["wrong"]);
}

#[test]
fn a_secular_equation_may_have_another_form_and_another_root_is_wrong() {
    let of = |name: &str, lines: &str| marks(name, PENDULUMS, lines);
    for (n, form) in [
        "\\left( \\frac{m g}{l} + k - m \\omega^2 \\right)^2 = k^2",
        "\\left( \\frac gl + \\frac km - \\omega^2 \\right)^2 = \\frac{k^2}{m^2}",
        "\\begin{vmatrix} \\frac{m g}{l} + k - m \\omega^2 & -k \\\\ -k & \\frac{m g}{l} + k - m \\omega^2 \\end{vmatrix} = 0",
        "\\frac{m g}{l} + k - m \\omega^2 = \\pm k",
        "\\omega^2 = \\frac gl + \\frac{2k}{m}",
    ]
    .iter()
    .enumerate()
    {
        assert_eq!(of(&format!("secular-{n}"), &format!("$$ {form} $$\n")), ["right"], "{form}");
        let wrong = form.replace('m', "2 m").replace("\\co2 m", "\\com").replace("\\o2 mega", "\\omega");
        let wrong = wrong.replace("v2 matrix", "vmatrix").replace("\\p2 m", "\\pm");
        assert_eq!(of(&format!("secular-wrong-{n}"), &format!("$$ {wrong} $$\n")), ["wrong"], "{wrong}");
    }
    let own = "The eigenvalues $\\lambda = \\omega^2$ are the roots of\n\n\
        $$ \\lambda^2 - 2 \\left( \\frac gl + \\frac km \\right) \\lambda + \\frac gl \\left( \\frac gl + \\frac{2k}{m} \\right) = 0 $$\n";
    assert_eq!(of("secular-own", own), ["given", "right"]);
    assert_eq!(of("secular-own-wrong", &own.replace("\\frac{2k}", "\\frac{3k}")), ["given", "wrong"]);
}

#[test]
fn other_letters_stay_in_the_argument_of_a_function() {
    let lines = |phase: &str| {
        format!(
            "$$ \\Omega_1 = \\sqrt{{\\frac gl}} $$\n\n$$ \\Omega_2 = \\sqrt{{\\frac gl + \\frac{{2k}}{{m}}}} $$\n\n\
             $$ y_1 = \\frac b2 (\\cos\\Omega_1 t + \\cos\\Omega_2 {phase}), \\qquad y_2 = \\frac b2 (\\cos\\Omega_1 t - \\cos\\Omega_2 t) $$\n"
        )
    };
    assert_eq!(marks("letters-function", PENDULUMS, &lines("t")), ["right"; 4]);
    assert_ne!(marks("letters-function-wrong", PENDULUMS, &lines("\\frac t2"))[2], "right");
}
