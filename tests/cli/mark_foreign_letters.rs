//! `onshell mark`, where a hand-in has none of the letters of the problem, and a slip: what a line of it may be taken for. Beside each line
//! that is wrong stands one that is not.

use crate::support::marks;

/// A sphere that rolls down a slope.
const SPHERE: (&str, &str) = (
    "$$ m a = m g \\sin\\alpha - f \\tag{1} $$\n\n$$ J \\beta = f R \\tag{2} $$\n\n$$ a = R \\beta \\tag{3} $$\n\n\
     $$ J = \\frac25 m R^2 \\tag{4} $$\n\n$$ a = \\frac57 g \\sin\\alpha \\tag{5} $$\n\n$$ f = \\frac27 m g \\sin\\alpha \\tag{6} $$\n",
    r#"{ "notes": "p.md", "constants": { "m, g, R, J": "> 0", "a, f, \\beta": "any", "\\alpha": "(0, \\pi/2)" },
        "laws": { "Newton": "1", "torque": "2", "rolling": "3", "inertia": "4" }, "rubric": { "results": { "5": 1, "6": 1 } } }"#,
);

/// A block on a wedge that slides.
const WEDGE: (&str, &str) = (
    "$$ L = \\frac12 (M + m) \\dot X^2 + \\frac12 m \\dot s^2 + m \\dot X \\dot s \\cos\\alpha + m g s \\sin\\alpha \\tag{1} $$\n\n\
     $$ (M + m) \\ddot X + m \\ddot s \\cos\\alpha = 0 \\tag{2} $$\n\n\
     $$ \\ddot s + \\ddot X \\cos\\alpha = g \\sin\\alpha \\tag{3} $$\n\n\
     $$ \\ddot s = \\frac{(M + m) g \\sin\\alpha}{M + m \\sin^2\\alpha} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "X, s": "any" }, "constants": { "m, M, g": "> 0", "\\alpha": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "1": 1, "2": 1, "4": 1 } } }"#,
);

#[test]
fn a_line_that_is_one_of_the_problem_but_for_a_slip_says_what_its_letters_are() {
    let lines = |function: &str| {
        format!(
            "$$ M b = M g \\{function}\\theta - F $$\n\n$$ F = \\frac25 M b $$\n\n$$ b = \\frac57 g \\{function}\\theta $$\n\n\
             $$ F = \\frac27 M g \\{function}\\theta $$\n"
        )
    };
    assert_eq!(marks("slip", SPHERE, &lines("cos")), ["wrong", "right", "carried", "carried"]);
    assert_eq!(marks("alone", SPHERE, "$$ M b = M g \\cos\\theta - F $$\n"), ["wrong"]);
    // The twins: no slip; and names of the student's own, of which no line is like one of the problem.
    assert_eq!(marks("right", SPHERE, &lines("sin"))[1..], ["right", "right", "right"]);
    assert_eq!(marks("own", SPHERE, "$$ W = K + P $$\n"), ["given"]);
}

#[test]
fn letters_with_which_a_result_is_reached_count_though_a_line_is_false_with_them() {
    let lines = |sign: &str| {
        format!(
            "$$ L = \\frac{{M+m}}{{2}} \\dot x_1^2 + \\frac m2 \\dot x_2^2 + m \\dot x_1 \\dot x_2 \\cos\\theta + m g x_2 \\sin\\theta $$\n\n\
             $$ (M+m) \\ddot x_1 = -m \\ddot x_2 \\cos\\theta $$\n\n$$ \\ddot x_2 = g \\sin\\theta {sign} \\ddot x_1 \\cos\\theta $$\n"
        )
    };
    assert_eq!(marks("false", WEDGE, &lines("+")), ["right", "right", "wrong"]);
    assert_eq!(marks("true", WEDGE, &lines("-")), ["right", "right", "right"]);
}

#[test]
fn a_false_law_takes_the_place_of_the_true_one() {
    let lines = |factor: &str| {
        format!("$$ J = \\frac12 m R^2 $$\n\n$$ f = \\frac{factor} m a $$\n\n$$ a = \\frac23 g \\sin\\alpha $$\n")
    };
    assert_eq!(marks("law", SPHERE, &lines("12")), ["wrong", "carried", "carried"]);
    assert_eq!(marks("law-slip", SPHERE, &lines("13"))[1], "wrong");
}

#[test]
fn an_equation_of_motion_with_a_slip_in_other_letters_is_wrong() {
    let pendulum = (
        "$$ \\ddot\\theta = -\\frac gl \\sin\\theta \\tag{1} $$\n",
        r#"{ "notes": "p.md", "system": "simple_pendulum", "coordinates": { "\\theta": "angle" },
            "constants": { "m, l, g": "> 0" }, "rubric": { "results": { "1": 1 } } }"#,
    );
    let of = |name: &str, line: &str| marks(name, pendulum, &format!("$$ {line} $$\n"));
    assert_eq!(of("sign", "\\ddot\\beta = \\frac ah \\sin\\beta"), ["wrong"]);
    assert_eq!(of("function", "\\ddot\\beta = -\\frac gh \\cos\\beta"), ["wrong"]);
    // The twins: no slip, and an equation of another form.
    assert_eq!(of("right", "\\ddot\\beta = -\\frac gh \\sin\\beta"), ["right"]);
    assert_ne!(of("other", "\\ddot u = a^2 u - w"), ["right"]);
}

#[test]
fn a_law_in_other_letters_gives_away_a_slip_in_another_line() {
    let impact = (
        "$$ m v = (m + M) V \\tag{1} $$\n\n$$ V = \\frac{m v}{m + M} \\tag{2} $$\n\n$$ \\frac12 (m + M) V^2 = (m + M) g h \\tag{3} $$\n\n\
         $$ h = \\frac{m^2 v^2}{2 g (m + M)^2} \\tag{4} $$\n",
        r#"{ "notes": "p.md", "constants": { "m, M, g, v, V, h": "> 0" }, "laws": { "momentum": "1", "energy": "3" },
            "rubric": { "results": { "2": 1, "4": 2 } } }"#,
    );
    let lines = |sum: &str| {
        format!(
            "$$ a u = ({sum}) w $$\n\n$$ w = \\frac{{a u}}{{{sum}}} $$\n\n$$ \\frac12 (a + b) w^2 = (a + b) g y $$\n\n\
             $$ y = \\frac{{a^2 u^2}}{{2 g ({sum})^2}} $$\n"
        )
    };
    assert_eq!(marks("slip", impact, &lines("a - b")), ["wrong", "carried", "given", "carried"]);
    assert_eq!(marks("right", impact, &lines("a + b")), ["given", "right", "given", "right"]);
}
