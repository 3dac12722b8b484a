//! `onshell mark`, where a line fails only since a letter means something else in the problem, or since nothing there decides:
//! it is not wrong. Beside each such line stands one that is.

use crate::support::marks;

/// A capacitor that is charged through a resistor.
const CHARGING: (&str, &str) = (
    "$$ R \\dot Q + \\frac QC = U_0 \\tag{1} $$\n\n$$ Q = C U_0 \\left( 1 - e^{-t/(RC)} \\right) \\tag{2} $$\n\n\
     $$ I = \\frac{U_0}{R} e^{-t/(RC)} \\tag{3} $$\n\n$$ t_h = R C \\ln 2 \\tag{4} $$\n\n\
     $$ W = \\int_0^\\infty R I^2 \\, dt = \\frac12 C U_0^2 \\tag{5} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "Q": "any" }, "constants": { "R, C, U_0": "> 0" },
        "laws": { "the voltages": "1" }, "rubric": { "results": { "2": 1, "4": 1, "5": 1 } } }"#,
);

/// Two blocks on a string. The text alone says that a is the acceleration.
const BLOCKS: (&str, &str) = (
    "The blocks have moved by $x$, and $a = \\ddot x$.\n\n$$ a = \\frac{m_2 - \\mu m_1}{m_1 + m_2} g \\tag{3} $$\n\n\
     $$ T = m_2 (g - a) \\tag{1} $$\n\n$$ m_1 a = T - \\mu m_1 g \\tag{2} $$\n\n\
     $$ v^2 = \\frac{2 g h}{m_1 + m_2} (m_2 - \\mu m_1) \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "x": "any" }, "constants": { "m_1, m_2, g, h, \\mu": "> 0" },
        "rubric": { "results": { "3": 1, "4": 1 } } }"#,
);

#[test]
fn a_constant_of_integration_has_the_value_that_the_start_gives_it() {
    let of = |name: &str, value: &str| {
        let lines = format!(
            "$$ CU_0 - Q = A e^{{\\lambda t}} $$\n\n$$ \\lambda = -\\frac{{1}}{{RC}} $$\n\n\
             $$ CU_0 - Q(0) = A = {value} $$\n"
        );
        marks(name, CHARGING, &lines)[2].clone()
    };
    assert_ne!(of("start", "CU_0"), "wrong");
    // The twin: another value.
    assert_eq!(of("start-wrong", "2CU_0"), "wrong");
}

#[test]
fn constants_that_are_defined_by_one_another_keep_their_meaning() {
    let of = |name: &str, value: &str| {
        let lines = format!(
            "$$ \\frac{{dQ}}{{dt}} = \\frac{{CU_0 - Q}}{{RC}} $$\n\n\
             $$ Q \\equiv CU_0 \\quad\\text{{or}}\\quad \\frac{{dQ}}{{CU_0 - Q}} = \\frac{{dt}}{{RC}} $$\n\n\
             $$ -\\ln|CU_0 - Q| = \\frac{{t}}{{RC}} + c_1 $$\n\n\
             $$ CU_0 - Q = c_2e^{{-t/(RC)}}, \\qquad c_2 = \\pm e^{{-c_1}} $$\n\n\
             $$ CU_0 - 0 = c_2\\cdot {value} $$\n"
        );
        marks(name, CHARGING, &lines)
    };
    let right = of("integrated", "1");
    assert!(!right.contains(&"wrong".to_owned()) && !right.contains(&"carried".to_owned()), "{right:?}");
    // The twin: twice the value.
    assert_eq!(of("integrated-wrong", "2").last().unwrap(), "wrong");
}

#[test]
fn a_value_at_an_instant_is_known_inside_of_definitions() {
    let of = |name: &str, value: &str| {
        marks(name, CHARGING, &format!("$$ I(t) = \\dot Q =: I_0 e^{{-t/(RC)}} $$\n\n$$ I_0 = I(0) = {value} $$\n"))
    };
    let right = of("instant", "\\frac{U_0}{R}");
    assert!(!right.contains(&"wrong".to_owned()), "{right:?}");
    assert_eq!(of("instant-wrong", "\\frac{2U_0}{R}")[1], "wrong");
}

#[test]
fn what_is_constant_in_the_problem_and_changes_in_a_line_is_another_quantity() {
    assert_eq!(marks("heat", CHARGING, "$$ dW = RI^2\\,dt $$\n"), ["undecided"]);
    // The twin: a rate of what changes there too.
    assert_eq!(marks("rate", CHARGING, "$$ dQ = 2I\\,dt $$\n"), ["wrong"]);
}

#[test]
fn the_text_of_a_problem_may_name_the_acceleration() {
    let of = |name: &str, factor: &str| {
        marks(name, BLOCKS, &format!("$$ m_1\\ddot x = T - {factor} \\mu m_1 g $$\n\n$$ T = m_2g - m_2\\ddot x $$\n"))
    };
    assert_eq!(of("named", "")[0], "right");
    assert_eq!(of("named-wrong", "2")[0], "wrong");
    // Without it nothing says how x moves, and no line about it is wrong.
    let silent = (BLOCKS.0.replace("and $a = \\ddot x$", "to the right"), BLOCKS.1);
    let lines = "$$ m_1\\ddot x = T - 2 \\mu m_1 g $$\n\n$$ T = \\frac{m_1 m_2 g}{m_1 + m_2} $$\n";
    let found = marks("silent", (&silent.0, silent.1), lines);
    assert_ne!(found[0], "wrong");
    assert_eq!(found[1], "wrong");
}

#[test]
fn the_time_is_an_instant_in_a_line_about_constants() {
    let found = marks("time", BLOCKS, "$$ h = \\frac12at^2, \\qquad v = at $$\n\n$$ v = \\sqrt{ah} $$\n");
    assert!(found[..2].iter().all(|mark| mark != "wrong"), "{found:?}");
    // The twin needs no time.
    assert_eq!(found[2], "wrong");
}

#[test]
fn after_a_condition_that_the_problem_does_not_meet_nothing_about_the_motion_is_wrong() {
    let of = |name: &str, before: &str| {
        marks(
            name,
            BLOCKS,
            &format!("{before}\n\n$$ m_1\\ddot x = -\\mu m_1g $$\n\n$$ \\frac{{m_2}}{{m_1 + m_2}} = m_1 $$\n"),
        )
    };
    let found = of("slack", "After the landing ($T = 0$):");
    assert_eq!(found[1..], ["undecided", "wrong"]);
    // The twin: no such condition.
    assert_eq!(of("taut", "Then:")[0], "wrong");
}

#[test]
fn a_condition_between_constants_is_given_where_a_word_says_so() {
    assert_eq!(marks("if", BLOCKS, "If $m_1 = m_2$ then\n\n$$ a = \\frac{1 - \\mu}{2} g $$\n"), ["given", "right"]);
    assert_eq!(marks("if-product", BLOCKS, "when $m_2 g = 2 m_1 g$:\n\n$$ a = \\frac{2 - \\mu}{3} g $$\n")[1], "right");
    // The twins: nobody says that it is one; and what does not follow.
    assert_eq!(marks("bare", BLOCKS, "$$ m_1 = m_2 $$\n\n$$ h = v $$\n")[0], "undecided");
    assert_eq!(marks("if-wrong", BLOCKS, "If $m_1 = m_2$ then\n\n$$ a = \\frac{1 - \\mu}{3} g $$\n")[1], "wrong");
}

#[test]
fn a_rounded_factor_is_right_to_its_digits() {
    assert_eq!(marks("digits", CHARGING, "$$ t_h = RC\\ln2 \\approx 0{,}69\\,RC $$\n"), ["right"]);
    assert_ne!(marks("digits-wrong", CHARGING, "$$ t_h = RC\\ln2 \\approx 0{,}96\\,RC $$\n"), ["right"]);
    let numbers = "With $R = 2\\,\\text{k}\\Omega$ and $C = 3\\,\\text{mF}$\n\n$$ t_h = 4{,}16\\,\\text{s} $$\n";
    assert_eq!(marks("numbers", CHARGING, numbers).last().unwrap(), "right");
    assert_eq!(marks("numbers-wrong", CHARGING, &numbers.replace("16", "61")).last().unwrap(), "wrong");
}

#[test]
fn an_inequality_that_the_problem_leaves_open_is_not_wrong() {
    assert_eq!(marks("less", BLOCKS, "$$ m_1 g - T < 0 $$\n"), ["undecided"]);
    // The twin never holds.
    assert_eq!(marks("never", BLOCKS, "$$ m_1 + m_2 < 0 $$\n"), ["wrong"]);
}

#[test]
fn e_is_a_charge_where_no_power_of_it_stands() {
    let problem = (
        "$$ F = q E \\tag{1} $$\n\n$$ W = q E d \\tag{2} $$\n",
        r#"{ "notes": "p.md", "constants": { "q, E, d": "> 0" }, "rubric": { "results": { "1": 1, "2": 1 } } }"#,
    );
    assert_eq!(marks("charge", problem, "$$ F = e E $$\n\n$$ W = e E d $$\n"), ["right", "right"]);
    assert_eq!(marks("charge-wrong", problem, "$$ F = e E $$\n\n$$ W = 2 e E d $$\n"), ["right", "wrong"]);
}

/// An orbit: everything is constant.
const ORBIT: (&str, &str) = (
    "$$ v = \\sqrt{\\frac{G M}{r}} \\tag{1} $$\n\n$$ E = \\frac12 m v^2 - \\frac{G M m}{r} = -\\frac{G M m}{2r} \\tag{2} $$\n\n\
     $$ W = \\frac12 E - E = \\frac{G M m}{4 r} \\tag{3} $$\n",
    r#"{ "notes": "p.md", "constants": { "G, M, m, r": "> 0" } }"#,
);

#[test]
fn a_function_of_a_constant_is_a_quantity_with_values_elsewhere() {
    let of = |name: &str, lines: &str| marks(name, ORBIT, lines);
    let lines = |change: &str| {
        format!(
            "$$ V(r) = -\\frac{{G M m}}{{r}} $$\n\n$$ E(r) = \\frac12 V(r) = -\\frac{{G M m}}{{2r}} $$\n\n$$ W = {change} $$\n"
        )
    };
    assert_eq!(of("function", &lines("E(2r) - E(r)")), ["given", "right", "right"]);
    // The twin: another place.
    assert_eq!(of("function-wrong", &lines("E(3r) - E(r)"))[2], "wrong");
    let carried =
        |change: &str| format!("$$ E = \\frac{{G M m}}{{2 r^2}} - \\frac{{G M m}}{{r}} $$\n\n$$ W = {change} $$\n");
    let change = "\\frac{G M m}{2 r} - \\frac{3 G M m}{8 r^2}";
    assert_eq!(of("change", &carried(change)), ["wrong", "carried"]);
    assert_eq!(of("change-slip", &carried("\\frac{G M m}{2 r} - \\frac{G M m}{8 r^2}")), ["wrong", "wrong"]);
}

/// A charge that is accelerated, and slides a distance.
const CHARGE: (&str, &str) = (
    "$$ K = q U \\tag{1} $$\n\n$$ p = \\frac1c \\sqrt{q^2 U^2 + 2 q U m c^2} \\tag{2} $$\n\n$$ a = \\frac{q U}{m s} \\tag{3} $$\n\n\
     $$ v = \\sqrt{2 a s} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "constants": { "m, c, q, U, s": "> 0" } }"#,
);

#[test]
fn e_may_be_a_charge_with_a_square_and_d_a_length() {
    let of = |name: &str, lines: &str| marks(name, CHARGE, lines);
    let charge = |factor: &str| format!("$$ K = eV $$\n\n$$ p = \\frac1c \\sqrt{{e^2 V^2 + {factor} eV m c^2}} $$\n");
    assert_eq!(of("charge", &charge("2")), ["right", "right"]);
    assert_eq!(of("charge-wrong", &charge("3"))[1], "wrong");
    let length = |factor: &str| {
        format!("$$ a = \\frac{{q U}}{{m d}} $$\n\n$$ v^2 = {factor} a d = \\frac{{{factor} q U}}{{m}} $$\n")
    };
    assert_eq!(of("length", &length("2")), ["right", "right"]);
    assert_eq!(of("length-wrong", &length("3"))[1], "wrong");
    // Differentials are no lengths.
    let differentials = of("differentials", "$$ dK = U\\,dq $$\n\n$$ dp = m\\,dv $$\n");
    assert!(!differentials.contains(&"wrong".to_owned()), "{differentials:?}");
}

#[test]
fn letters_of_the_problem_do_not_change_places_among_themselves() {
    let problem = (
        "$$ m \\dot v = -k v \\tag{1} $$\n\n$$ v(t) = v_0 e^{-k t/m} \\tag{2} $$\n\n$$ t_h = \\frac{m}{k} \\ln 2 \\tag{3} $$\n\n$$ v(t_h) = \\frac12 v_0 \\tag{4} $$\n",
        r#"{ "notes": "p.md", "varies with time": { "v": "any" }, "constants": { "m, k, v_0": "> 0" }, "laws": { "Newton": "1" } }"#,
    );
    let lines = "$$ v(t) = v_0 e^{-m t/k} $$\n\n$$ t_h = \\frac{k}{m} \\ln 2 $$\n";
    assert_eq!(marks("exchange", problem, lines), ["wrong", "carried"]);
    // Letters of the student's own may stand for both.
    let lines = "$$ v(t) = v_0 e^{-\\beta t/M} $$\n\n$$ t_h = \\frac{M}{\\beta} \\ln 2 $$\n";
    assert_eq!(marks("own", problem, lines), ["right", "right"]);
}

#[test]
fn a_letter_with_a_hat_stands_for_no_number() {
    const PENDULUM: (&str, &str) = (
        "$$ L = \\frac12 m l^2 \\dot\\theta^2 + m g l \\cos\\theta \\tag{1} $$\n\n$$ l \\ddot\\theta = -g \\sin\\theta \\tag{2} $$\n",
        r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" }, "constants": { "m, l, g": "> 0" },
            "means": { "L": "Lagrangian" }, "rubric": { "results": { "2": 1 } } }"#,
    );
    let of = |name: &str, angle: &str| {
        let lines = format!("$$ l \\ddot{{{angle}}} = -g \\sin {angle} $$\n");
        marks(name, PENDULUM, &lines)[0].clone()
    };
    assert_eq!(of("other-letter", "\\phi"), "right");
    assert_ne!(of("hat", "\\hat H"), "right");
}
