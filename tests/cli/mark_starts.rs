//! `onshell mark`, where the problem gives initial values or a motion on a circle, and where letters are none of the problem's. Beside
//! each true line stands one that must not be right.

use crate::support::marks;

/// A rod that slides down a wall from rest: a claim gives the initial values.
const ROD: (&str, &str) = (
    "$$ L = \\frac16 m l^2 \\dot\\theta^2 - \\frac12 m g l \\cos\\theta \\tag{1} $$\n\n\
     $$ \\ddot\\theta = \\frac{3 g}{2 l} \\sin\\theta \\tag{2} $$\n\n\
     $$ \\dot\\theta^2 = \\frac{3 g}{l} (\\cos\\theta_0 - \\cos\\theta) \\tag{3} $$\n\n\
     $$ x = \\frac{l}{2} \\sin\\theta, \\qquad N = m \\ddot x \\tag{4} $$\n\n\
     $$ N = \\frac34 m g \\sin\\theta \\, (3 \\cos\\theta - 2 \\cos\\theta_0) \\tag{5} $$\n\n\
     $$ \\cos\\theta_1 = \\frac23 \\cos\\theta_0 \\tag{6} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "(0, \\pi/2)" },
        "constants": { "m, l, g": "> 0", "\\theta_0, \\theta_1": "(0, \\pi/2)" }, "means": { "L": "Lagrangian" },
        "equations": { "3": { "assume": "\\theta(0) = \\theta_0, \\dot\\theta(0) = 0" }, "5": { "assume": "3" },
                       "6": { "assume": ["3", "N = 0", "\\theta = \\theta_1"] } } }"#,
);

/// A particle in a cone: a circle, and small oscillations about it.
const CONE: (&str, &str) = (
    "$$ L = \\frac12 m \\left( \\frac{\\dot r^2}{\\sin^2\\alpha} + r^2 \\dot\\phi^2 \\right) - m g r \\cot\\alpha \\tag{1} $$\n\n\
     $$ \\ell = m r^2 \\dot\\phi = \\text{const} \\tag{2} $$\n\n$$ r_0 \\Omega^2 = g \\cot\\alpha \\tag{3} $$\n\n\
     $$ \\omega = \\sqrt{3} \\, \\Omega \\sin\\alpha = \\sqrt{\\frac{3 g \\sin\\alpha \\cos\\alpha}{r_0}} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "r": "> 0", "\\phi": "angle" },
        "constants": { "m, g, r_0, \\Omega": "> 0", "\\alpha": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian", "\\omega": "frequency of small oscillations about r = r_0" },
        "equations": { "2": { "conserved": true }, "3": { "throughout": ["r = r_0", "\\dot\\phi = \\Omega"] },
                       "4": { "throughout": ["r = r_0", "\\dot\\phi = \\Omega"] } } }"#,
);

/// A damped oscillator that starts at rest.
const DAMPED: (&str, &str) = (
    "$$ m \\ddot x = -k x - b \\dot x \\tag{1} $$\n\n\
     $$ \\gamma = \\frac{b}{2 m}, \\qquad \\omega = \\sqrt{\\frac km - \\gamma^2} \\tag{2} $$\n\n\
     $$ x(t) = x_0 e^{-\\gamma t} \\left( \\cos(\\omega t) + \\frac{\\gamma}{\\omega} \\sin(\\omega t) \\right) \\tag{3} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "x": "any" }, "constants": { "m, k, b, x_0": "> 0" },
        "laws": { "Newton": "1" }, "assume": ["\\frac km > \\frac{b^2}{4 m^2}"],
        "equations": { "3": { "assume": "x(0) = x_0, \\dot x(0) = 0" } } }"#,
);

/// Two bodies that collide.
const CARTS: (&str, &str) = (
    "$$ V = \\frac{m_1 v}{m_1 + m_2} \\tag{1} $$\n\n$$ v_1 = V + V \\cos\\chi, \\qquad v_2 = V \\sin\\chi \\tag{2} $$\n\n\
     $$ E = \\frac{4 m_1 m_2}{(m_1 + m_2)^2} \\tag{3} $$\n",
    r#"{ "notes": "p.md", "constants": { "m_1, m_2, v": "> 0", "\\chi": "(0, \\pi)" },
        "rubric": { "results": { "1": 1, "3": 1 } } }"#,
);

#[test]
fn a_result_under_several_hypotheses_is_found_true_on_any_line() {
    for blank in 0..8 {
        let line = |text: &str| format!("{}$$ {text} $$\n", "\n".repeat(blank));
        assert_eq!(
            marks("leaves", ROD, &line("3 \\cos\\theta_1 = 2 \\cos\\theta_0")),
            ["right"],
            "after {blank} lines"
        );
        assert_eq!(marks("leaves-wrong", ROD, &line("2 \\cos\\theta_1 = 3 \\cos\\theta_0")), ["wrong"]);
    }
    // What the problem supposes is a condition also in a display.
    let lines = |last: &str| format!("$$ N = 0: \\quad \\cos\\theta_1 = {last} \\cos\\theta_0 $$\n");
    assert_eq!(marks("supposed", ROD, &lines("\\frac23")), ["given", "right"]);
    assert_eq!(marks("supposed-wrong", ROD, &lines("\\frac34")), ["given", "wrong"]);
}

#[test]
fn a_velocity_may_be_the_root_of_the_square_that_the_problem_gives() {
    let line = |factor: &str| {
        format!("$$ \\dot\\theta = \\sqrt{{\\frac{{{factor} g}}{{l}} (\\cos\\theta_0 - \\cos\\theta)}} $$\n")
    };
    assert_eq!(marks("root", ROD, &line("3")), ["right"]);
    assert_eq!(marks("root-wrong", ROD, &line("6")), ["wrong"]);
}

#[test]
fn what_a_false_lagrangian_says_of_a_motion_from_rest_is_carried() {
    let lines = |energy: &str, force: &str| {
        format!(
            "$$ L = \\frac16 m l^2 \\dot\\theta^2 + \\frac12 m g l \\cos\\theta $$\n\n\
             $$ \\ddot\\theta = -\\frac{{3g}}{{2l}} \\sin\\theta $$\n\n\
             $$ \\frac16 m l^2 \\dot\\theta^2 - {energy} m g l \\cos\\theta = -{energy} m g l \\cos\\theta_0 $$\n\n\
             $$ \\dot\\theta^2 = \\frac{{3g}}{{l}} (\\cos\\theta - \\cos\\theta_0) $$\n\n\
             $$ N = -{force} m g \\sin\\theta (3 \\cos\\theta - 2 \\cos\\theta_0) $$\n"
        )
    };
    let carried = ["wrong", "carried", "carried", "carried", "carried"];
    assert_eq!(marks("from-rest", ROD, &lines("\\frac12", "\\frac34")), carried);
    // The twin: factors.
    let wrong = marks("from-rest-wrong", ROD, &lines("\\frac13", "\\frac12"));
    assert_eq!([&wrong[2], &wrong[4]], ["wrong", "wrong"]);
}

#[test]
fn a_false_line_takes_no_name_from_a_special_case_of_the_problem() {
    let lines = |factor: &str| {
        format!(
            "$$ \\omega = \\sqrt{{\\frac{{{factor} g \\sin\\alpha \\cos\\alpha}}{{r_0}}}} $$\n\n\
             $$ \\omega^2 = \\frac{{3 g \\sin\\alpha \\cos\\alpha}}{{r_0}} $$\n"
        )
    };
    assert_eq!(marks("case", CONE, &lines("3")), ["right", "right"]);
    assert_eq!(marks("case-wrong", CONE, &lines("2")), ["wrong", "right"]);
}

#[test]
fn the_equation_of_a_small_deviation_is_that_of_the_frequency() {
    let lines = |factor: &str| {
        format!(
            "Small deviations $r = r_0 + \\delta$, on the circle $\\ell = m r_0^2 \\Omega$.\n\n\
             $$ \\ddot\\delta = -\\sin^2\\alpha \\, \\frac{{{factor} \\ell^2}}{{m^2 r_0^4}} \\delta $$\n\n\
             $$ \\omega = \\sqrt{{{factor}}} \\, \\Omega \\sin\\alpha $$\n"
        )
    };
    let [equation, frequency] = [2, 3].map(|at| (marks("deviation", CONE, &lines("3"))[at].clone(), at));
    assert_eq!([equation.0, frequency.0], ["right", "right"]);
    // The twin: on the circle itself both sides vanish, whatever the factor.
    let wrong = marks("deviation-wrong", CONE, &lines("2"));
    assert_eq!(wrong[2..], ["wrong", "carried"]);
    // A letter with primes of the student's own is such a deviation too.
    let primes = |factor: &str| {
        format!(
            "$$ r'' = r \\phi'^2 \\sin^2\\alpha - g \\sin\\alpha \\cos\\alpha $$\n\nSmall: $r = r_0 + x$\n\n\
             $$ x'' + {factor} \\Omega^2 \\sin^2\\alpha \\, x = 0 $$\n"
        )
    };
    assert_eq!(marks("primes", CONE, &primes("3"))[2], "right");
    assert_ne!(marks("primes-wrong", CONE, &primes("2"))[2], "right");
}

#[test]
fn what_a_false_equation_of_motion_says_on_the_circle_is_carried() {
    let lines = |place: &str| {
        format!(
            "$$ L = \\frac12 m (\\dot r^2 + r^2 \\dot\\phi^2) - m g r \\tan\\alpha $$\n\n\
             $$ \\ddot r = \\frac{{\\ell^2}}{{m^2 r^3}} - g \\tan\\alpha $$\n\n\
             $$ \\Omega = \\sqrt{{\\frac{{{place} \\tan\\alpha}}{{r_0}}}} $$\n"
        )
    };
    assert_eq!(marks("circle", CONE, &lines("g")), ["wrong", "carried", "carried"]);
    assert_eq!(marks("circle-wrong", CONE, &lines("2 g"))[2], "wrong");
}

#[test]
fn what_laws_say_may_have_initial_values_too() {
    let line = |sign: &str| {
        format!(
            "$$ x = x_0 e^{{-\\gamma t}} \\left( \\cos\\omega t {sign} \\frac\\gamma\\omega \\sin\\omega t \\right) $$\n"
        )
    };
    assert_eq!(marks("damped", DAMPED, &line("+")), ["right"]);
    // The twin solves the law, but does not start at rest.
    assert_eq!(marks("damped-wrong", DAMPED, &line("-")), ["wrong"]);
}

#[test]
fn no_letters_are_guessed_that_make_a_sound_hand_in_false() {
    let lines = "$$ m_1 v = m_1 w_1 + m_2 w_2 $$\n\n$$ m_1 v^2 = m_1 w_1^2 + m_2 w_2^2 $$\n\n\
                 $$ E = \\frac{m_2 w_2^2}{m_1 v^2} = \\frac{4 m_1 m_2}{(m_1 + m_2)^2} $$\n";
    let own = marks("collision", CARTS, lines);
    assert!(!own.contains(&"wrong".to_owned()) && !own.contains(&"carried".to_owned()), "{own:?}");
    // The twin: the last member is false without any letters.
    let wrong = marks("collision-wrong", CARTS, &lines.replace("{4 m_1 m_2}", "{2 m_1 m_2}"));
    assert_eq!(wrong[2], "wrong");
}

#[test]
fn labels_sines_in_other_languages_and_quotients_by_a_new_name_are_read() {
    let sine = |word: &str| format!("$$ v_2: \\quad v_2 = V \\,\\text{{{word}}}\\,\\chi $$\n");
    assert_eq!(marks("sine", CARTS, &sine("sen")), ["right"]);
    assert_ne!(marks("sine-wrong", CARTS, &sine("tg")), ["right"]);
    let quotient = |last: &str| format!("$$ \\frac{{m_1 v}}{{p}} = \\frac{{m_1 v}}{{(m_1 + m_2) V}} = {last} $$\n");
    assert_eq!(marks("quotient", CARTS, &quotient("1")), ["given"]);
    assert_ne!(marks("quotient-wrong", CARTS, &quotient("2")), ["given"]);
}
