//! `onshell mark`, where a later line gives a name a value: a constant of integration, and a quantity of the student's own. Beside each false
//! value stands the true one.

use crate::support::marks;

/// A capacitor that is charged, empty at the start.
const CHARGING: (&str, &str) = (
    "$$ R \\dot q + \\frac{q}{C} = U_0 \\tag{1} $$\n\n$$ I = \\dot q $$\n\n\
     $$ q = C U_0 \\left(1 - e^{-t/(R C)}\\right) \\tag{2} $$\n\n$$ I = \\frac{U_0}{R} e^{-t/(R C)} \\tag{3} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "q": "any" }, "constants": { "C, U_0, R": "> 0" },
        "laws": { "Kirchhoff": "1" }, "rubric": { "results": { "2": 1, "3": 1 } } }"#,
);

/// Two masses on a string over a pulley, of which the tension has no name.
const PULLEY: (&str, &str) = (
    "$$ L = \\frac12 (m_1 + m_2) \\dot x^2 + (m_1 - m_2) g x \\tag{1} $$\n\n\
     $$ \\ddot x = \\frac{m_1 - m_2}{m_1 + m_2} g \\tag{2} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "x": "any" }, "constants": { "m_1, m_2, g": "> 0" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "2": 1 } } }"#,
);

#[test]
fn a_false_constant_of_integration_is_wrong_and_the_solution_with_it_is_carried() {
    let lines = |value: &str, sign: &str| {
        format!(
            "$$ q = C U_0 + K e^{{-t/\\tau}}, \\qquad \\tau = R C $$\n\nFrom $q(0) = 0$ follows $K = {value}$:\n\n\
             $$ q = C U_0 \\left(1 {sign} e^{{-t/\\tau}}\\right) $$\n\n$$ I = -\\frac{{{value}}}{{R C}} e^{{-t/\\tau}} $$\n"
        )
    };
    let found = marks("false", CHARGING, &lines("C U_0", "+"));
    assert_eq!(found, ["right", "given", "right", "wrong", "carried", "carried"]);
    // The twins: the true constant, and another solution after the false one.
    let found = marks("true", CHARGING, &lines("-C U_0", "-"));
    assert_eq!([&found[0], &found[4], &found[5]], ["right", "right", "right"]);
    assert!(found.iter().all(|mark| mark == "right" || mark == "given"), "{found:?}");
    let slip = lines("C U_0", "+").replace("1 + e^{-t", "1 + e^{t");
    assert_eq!(marks("slip", CHARGING, &slip)[4], "wrong");
}

#[test]
fn an_integral_is_right_whatever_a_later_line_gives_its_constant() {
    let lines = |rate: &str, value: &str| {
        format!(
            "$$ \\ln(C U_0 - q) = {rate}\\frac{{t}}{{R C}} + K $$\n\n$$ K = \\ln({value}) $$\n\n\
             $$ C U_0 - q = {value} \\cdot e^{{-t/(R C)}} $$\n"
        )
    };
    assert_eq!(marks("false", CHARGING, &lines("-", "2 C U_0")), ["right", "wrong", "carried"]);
    assert_eq!(marks("true", CHARGING, &lines("-", "C U_0"))[2], "right");
    // The twin: the integral itself has a slip.
    assert_eq!(marks("slip", CHARGING, &lines("-2", "C U_0"))[0], "wrong");
}

#[test]
fn two_lines_that_agree_on_a_quantity_count_for_more_than_a_later_value_of_it() {
    let lines = |sign: &str, value: &str| {
        format!(
            "$$ m_1 \\ddot x = m_1 g - S $$\n\n$$ m_2 \\ddot x = S {sign} m_2 g $$\n\n\
             $$ \\ddot x = \\frac{{m_1 - m_2}}{{m_1 + m_2}} g $$\n\n$$ S = m_1 {value} $$\n"
        )
    };
    let found = marks("false", PULLEY, &lines("-", "(g + \\ddot x)"));
    assert_eq!(found, ["given", "right", "right", "wrong"]);
    let found = marks("true", PULLEY, &lines("-", "(g - \\ddot x)"));
    assert!(!found.contains(&"wrong".to_owned()), "{found:?}");
    // The twin: the two lines do not agree.
    let found = marks("slip", PULLEY, &lines("+", "(g - \\ddot x)"));
    assert_eq!(found[1], "wrong");
}
