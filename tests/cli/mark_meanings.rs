//! `onshell mark`, where a letter of the problem could be taken for another one: a wrong line stays wrong. Beside each stands what is right.

use crate::mark_problems::{COLLISION, CYLINDER, DAMPED, ORBIT};
use crate::support::marks;

#[test]
fn one_line_does_not_give_a_letter_of_the_problem_another_meaning() {
    let of = |name: &str, line: &str| marks(name, COLLISION, &format!("$$ {line} $$\n"));
    assert_eq!(of("speed", "h = \\frac{u^2}{2 g}"), ["wrong"]);
    assert_eq!(of("stuck", "v_2 = \\frac{m_1}{m_1 + m_2} u"), ["wrong"]);
    // The twins: the right speed, and a letter that the problem does not have.
    assert_eq!(of("right", "h = \\frac{v_2^2}{2 g}"), ["right"]);
    assert_eq!(of("own", "h = \\frac{c^2}{2 g}"), ["right"]);
}

#[test]
fn a_letter_that_a_line_uses_as_the_problem_does_has_that_meaning_everywhere() {
    let lines = "$$ \\omega_0^2 = \\frac km $$\n\n\
         $$ x = x_0e^{-\\gamma t}\\left(\\cos\\omega_0t + \\frac\\gamma{\\omega_0}\\sin\\omega_0t\\right) $$\n";
    let found = marks("frequency", DAMPED, lines);
    assert_ne!(found[0], "wrong");
    assert_eq!(found[1], "wrong");
    let lines = |drag: &str| {
        format!("$$ \\ddot x + 2\\gamma\\dot x + \\omega_0^2 x = 0 $$\n\n$$ \\dot E = -{drag}\\dot x^2 $$\n")
    };
    assert_eq!(marks("drag", DAMPED, &lines("\\gamma")), ["right", "wrong"]);
    assert_eq!(marks("drag-right", DAMPED, &lines("b")), ["right", "right"]);
}

#[test]
fn several_lines_may_give_a_letter_of_the_problem_another_meaning() {
    let lines = "$$ v_2 = \\frac{m_1 u}{m_1 + m_2} $$\n\n\
         $$ Q = \\frac12 m_1 u^2 - \\frac12 (m_1 + m_2) v_2^2 = \\frac{m_1 m_2 u^2}{2 (m_1 + m_2)} $$\n";
    assert_eq!(marks("both", COLLISION, lines), ["right", "right"]);
    // The twin: in a third line the letter has the meaning of the problem.
    let third = format!("{lines}\n$$ \\eta = \\frac{{m_2 v_2^2}}{{m_1 u^2}} $$\n");
    assert_eq!(marks("third", COLLISION, &third)[0], "wrong");
}

#[test]
fn a_function_of_what_moves_has_values_at_places() {
    let lines = |value: &str| {
        format!(
            "$$ U_{{\\text{{eff}}}}(r) = \\frac{{\\ell^2}}{{2mr^2}} - \\frac kr $$\n\n\
             $$ U_{{\\text{{eff}}}}(r_0) = {value}\\frac{{mk^2}}{{2\\ell^2}} $$\n"
        )
    };
    assert_eq!(marks("value", ORBIT, &lines("-")), ["right", "right"]);
    // The twin: a wrong sign.
    assert_eq!(marks("value-wrong", ORBIT, &lines("")), ["right", "wrong"]);
}

#[test]
fn a_rate_may_be_the_acceleration_that_the_problem_names() {
    let of = |name: &str, line: &str| marks(name, CYLINDER, &format!("$$ {line} $$\n"));
    assert_eq!(of("length", "\\ddot x = \\frac23 g\\sin\\alpha"), ["right"]);
    assert_eq!(of("length-wrong", "\\ddot x = \\frac12 g\\sin\\alpha"), ["wrong"]);
    assert_eq!(of("speed", "\\dot v = \\frac23 g\\sin\\alpha = 3.27\\,\\text{m/s}^2"), ["right"]);
    // The twin: beside other rates nothing is replaced.
    assert_ne!(of("energy", "\\dot E = \\frac32 m\\dot x\\ddot x - m g\\dot x\\sin\\alpha = 0"), ["wrong"]);
}

#[test]
fn a_solution_for_other_initial_values_than_the_problem_says_is_wrong() {
    let of = |name: &str, rest: &str| {
        marks(name, DAMPED, &format!("$$ x = x_0 e^{{-\\gamma t}}\\left(\\cos\\omega t {rest}\\right) $$\n"))
    };
    assert_eq!(of("start-wrong", "- \\frac\\gamma\\omega\\sin\\omega t"), ["wrong"]);
    assert_eq!(of("start", "+ \\frac\\gamma\\omega\\sin\\omega t"), ["right"]);
    // The twin: the problem does not say them.
    let silent = (DAMPED.0.replace("with $x(0) = x_0$ and $\\dot x(0) = 0$ ", ""), DAMPED.1);
    let line = "$$ x = x_0 e^{-\\gamma t}\\cos\\omega t $$\n";
    assert_eq!(marks("silent", (&silent.0, silent.1), line), ["given"]);
}
