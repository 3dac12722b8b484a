//! `onshell mark` in four problems that a teacher gave: trial solutions and modes, deviations from a place of rest that only the prose
//! names, and numbers. Beside each line that must not be wrong stands one that must not be right.

use crate::support::{Desk, marks};

/// Two masses on a chain of springs, with the frequency that is sought declared.
const CHAIN: (&str, &str) = (
    "$$ L = \\frac12 m (\\dot x_1^2 + \\dot x_2^2) - \\frac12 k x_1^2 - \\frac12 k (x_2 - x_1)^2 \\tag{1} $$\n\n\
     $$ m \\ddot x_1 = -2 k x_1 + k x_2, \\qquad m \\ddot x_2 = k x_1 - k x_2 \\tag{2} $$\n\n\
     $$ (2k - m \\omega^2)(k - m\\omega^2) - k^2 = 0 \\tag{3} $$\n\n\
     $$ \\omega_1^2 = \\frac{3 - \\sqrt5}{2} \\frac{k}{m}, \\qquad \\omega_2^2 = \\frac{3 + \\sqrt5}{2} \\frac{k}{m} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "constants": { "k, m, \\omega": "> 0" }, "coordinates": { "x_1, x_2": "any" },
        "means": { "L": "Lagrangian", "\\omega_1, \\omega_2": "normal frequency" },
        "equations": { "3": { "secular equation for": "\\omega" } }, "rubric": { "results": { "3": 1, "4": 1 } } }"#,
);

/// A bead in a bowl that turns; that x_0 is a place of rest, only the prose says.
const BOWL: (&str, &str) = (
    "$$ L = \\frac12 m (1 + b^2 x^6) \\dot x^2 + \\frac12 m \\Omega^2 x^2 - \\frac14 m g b x^4 \\tag{1} $$\n\n\
     $$ (1 + b^2 x^6) \\ddot x + 3 b^2 x^5 \\dot x^2 = \\Omega^2 x - g b x^3 \\tag{2} $$\n\n\
     The bead rests where the right side vanishes, at $x = 0$ and at $x = x_0$ with\n\n\
     $$ x_0^2 = \\frac{\\Omega^2}{g b} \\tag{3} $$\n\nFor a small distance $\\xi$ from there the right side is $-2 \\Omega^2 \\xi$, and the frequency of small oscillations about $x_0$ is\n\n\
     $$ \\omega^2 = \\frac{2 \\Omega^2}{1 + b^2 x_0^6} = \\frac{2 \\Omega^2}{1 + \\frac{\\Omega^6}{b g^3}} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "constants": { "\\Omega, b, g, m": "> 0" }, "coordinates": { "x": "any" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "3": 1, "4": 3 } } }"#,
);

/// A block that is pulled up a slope, with numbers in the text of the problem.
const SLOPE: (&str, &str) = (
    "Give numbers for $m_1 = 2.0\\,\\text{kg}$, $m_2 = 3.0\\,\\text{kg}$ and $h = 1.5\\,\\text{m}$.\n\n\
     $$ m_1 a = S - m_1 g \\tag{1} $$\n\n$$ m_2 a = m_2 g - S \\tag{2} $$\n\n\
     $$ a = \\frac{m_2 - m_1}{m_1 + m_2} g \\tag{3} $$\n\n$$ v^2 = 2 a h \\tag{4} $$\n\n\
     $$ v = \\sqrt{\\frac{2 g h (m_2 - m_1)}{m_1 + m_2}} \\tag{5} $$\n",
    r#"{ "notes": "p.md", "constants": { "m_1, m_2, g, h, S, v": "> 0", "a": "any" },
        "laws": { "block": "1", "hanging mass": "2", "from rest": "4" }, "rubric": { "results": { "3": 1, "5": 1 } } }"#,
);

#[test]
fn a_trial_with_the_sought_frequency_is_given_and_its_equations_are_right() {
    let of = |name: &str, lines: &str| marks(name, CHAIN, lines);
    let tried = "With $x_1 = A \\cos\\omega t$ and $x_2 = B \\cos\\omega t$:\n\n";
    assert_eq!(of("trial", &format!("{tried}$$ (2k - m \\omega^2) A = k B $$\n")), ["given", "given", "right"]);
    assert_eq!(
        of("complex", "We try\n\n$$ x_1 = A e^{i\\omega t}, \\qquad x_2 = B e^{i\\omega t} $$\n"),
        ["given", "given"]
    );
    let mode = "In a mode $x_2 = \\rho x_1$ at all times, with $\\ddot x_1 = -\\omega^2 x_1$.\n";
    assert_eq!(of("mode", mode), ["given", "given"]);
    // The twins: a sign, another multiple of the square, and a display that claims it of every motion.
    assert_ne!(of("trial-sign", &format!("{tried}$$ (2k + m \\omega^2) A = k B $$\n"))[2], "right");
    assert_eq!(of("mode-twice", &mode.replace("-\\omega^2", "-2\\omega^2"))[1], "wrong");
    assert_eq!(of("mode-display", "$$ \\ddot x_1 = -\\omega^2 x_1 $$\n"), ["wrong"]);
}

#[test]
fn a_false_equation_of_motion_is_carried_into_the_secular_equation() {
    let lines = |secular: &str| {
        format!("$$ m \\ddot x_1 = -k x_1 + k x_2 $$\n\n$$ m \\ddot x_2 = k x_1 - k x_2 $$\n\n$$ {secular} = 0 $$\n")
    };
    let of = |name: &str, secular: &str| marks(name, CHAIN, &lines(secular));
    assert_eq!(of("modes", "(k - m \\omega^2)^2 - k^2"), ["wrong", "right", "carried"]);
    // The twin: another secular equation.
    assert_eq!(of("modes-other", "(k - m \\omega^2)^2 - 2 k^2"), ["wrong", "right", "wrong"]);
}

#[test]
fn letters_with_subscripts_follow_the_letter() {
    let lines = |factor: &str| {
        format!(
            "$$ M \\ddot y + 2 c y - c z = 0 $$\n\n$$ M \\ddot z - c y + c z = 0 $$\n\n\
             $$ (2 c - M p^2)(c - M p^2) = c^2 $$\n\n$$ p_1^2 = \\frac{{c}}{{{factor} M}} (3 - \\sqrt5) $$\n"
        )
    };
    assert_eq!(marks("subscripts", CHAIN, &lines("2")).pop().unwrap(), "right");
    assert_eq!(marks("subscripts-slip", CHAIN, &lines("3")).pop().unwrap(), "wrong");
}

#[test]
fn a_place_of_rest_that_the_prose_names_has_small_oscillations() {
    let of = |name: &str, lines: &str| marks(name, BOWL, lines);
    let linear = |factor: &str| format!("$$ (1 + b^2 x_0^6) \\ddot\\xi = -{factor} \\Omega^2 \\xi $$\n");
    let difference = "For a small deviation $\\xi = x - x_0$:\n\n";
    let sum = "Put $x = x_0 + \\xi$.\n\n";
    for (name, before) in [("sum", sum), ("difference", difference)] {
        assert_eq!(of(name, &format!("{before}{}", linear("2"))), ["given", "right"], "{name}");
        assert_eq!(of(&format!("{name}-slip"), &format!("{before}{}", linear("3"))), ["given", "wrong"], "{name}");
    }
    assert_eq!(
        of("rest", "At rest $\\dot x = \\ddot x = 0$.\n\n$$ x_0 = \\frac{\\Omega}{\\sqrt{g b}} $$\n"),
        ["given", "right"]
    );
    // The twin: a slip in a term of second order is a slip in the equation of motion.
    assert_eq!(of("second", "$$ (1 + b^2 x^6) \\ddot x + 6 b^2 x^5 \\dot x^2 = \\Omega^2 x - g b x^3 $$\n"), ["wrong"]);
}

#[test]
fn the_form_on_the_way_is_the_result_where_its_quantities_are_known() {
    let points = |name: &str, lines: &str| {
        let desk = Desk::new(&format!("marks-points-{name}"));
        desk.write("p.md", BOWL.0);
        desk.write("p.json", BOWL.1);
        desk.write("one.md", lines);
        let report = desk.onshell(&["mark", "one.md", "--claims", "p.json", "--format", "json"]).json();
        report["students"][0]["credit"].as_f64().unwrap()
    };
    let place = "$$ x_0 = \\frac{\\Omega}{\\sqrt{g b}} $$\n\n";
    let frequency = "$$ \\omega = \\sqrt{\\frac{2 \\Omega^2}{1 + b^2 x_0^6}} $$\n";
    assert_eq!(points("known", &format!("{place}{frequency}")), 4.0);
    // The twin: no line says what x_0 is.
    assert_eq!(points("unknown", frequency), 0.0);
}

#[test]
fn numbers_use_the_data_of_the_problem_and_of_the_whole_hand_in() {
    let of = |name: &str, lines: &str| marks(name, SLOPE, lines);
    assert_eq!(of("data", "$$ a = 1.96\\,\\text{m/s}^2 $$\n\n$$ v = 2.43\\,\\text{m/s} $$\n"), ["right", "right"]);
    assert_eq!(
        of("data-wrong", "$$ a = 2.96\\,\\text{m/s}^2 $$\n\n$$ v = 2.43\\,\\text{m/s} $$\n"),
        ["wrong", "right"]
    );
    let bare = (SLOPE.0.split_once("\n\n").unwrap().1, SLOPE.1);
    assert_eq!(marks("no-data", bare, "$$ a = 1.96\\,\\text{m/s}^2 $$\n"), ["undecided"]);
    let after = "where $m_1 = 2.0\\,\\text{kg}$ and $m_2 = 3.0\\,\\text{kg}$.\n";
    let later = |sum: &str| {
        format!(
            "$$ a = \\frac{{m_2 - m_1}}{{m_1 + m_2}} g = \\frac{{3.0 - {sum}}}{{5.0}} \\cdot 9.81\\,\\text{{m/s}}^2 = 1.96\\,\\text{{m/s}}^2 $$\n\n{after}"
        )
    };
    assert_eq!(marks("later", bare, &later("2.0"))[0], "right");
    assert_eq!(marks("later-wrong", bare, &later("2.4"))[0], "wrong");
    assert_eq!(of("near", "$$ a \\approx 2.0\\,\\text{m/s}^2 $$\n"), ["right"]);
}

#[test]
fn a_number_from_a_false_formula_is_carried() {
    let lines = |value: &str| format!("$$ v = \\sqrt{{a h}} $$\n\n$$ v = {value}\\,\\text{{m/s}} $$\n");
    assert_eq!(marks("number", SLOPE, &lines("1.72")), ["wrong", "carried"]);
    // The twin: a number that neither formula gives.
    assert_eq!(marks("number-slip", SLOPE, &lines("1.92")), ["wrong", "wrong"]);
}
