//! `onshell mark`, where a step goes on from a false line: to an integral, an instant, a rate, a Lagrangian. Beside each step that is
//! carried stands one with a slip of its own.

use crate::support::marks;

/// A ball that is thrown upwards, with drag.
const BALL: (&str, &str) = (
    "$$ m \\dot v = -m g - b v, \\qquad \\dot y = v \\tag{1} $$\n\n$$ u = \\frac{m g}{b} \\tag{2} $$\n\n\
     $$ v = (w + u) e^{-b t/m} - u \\tag{3} $$\n\n\
     $$ y = \\frac mb (w + u) \\left( 1 - e^{-b t/m} \\right) - u t \\tag{4} $$\n\n\
     $$ t_1 = \\frac mb \\ln\\left( 1 + \\frac wu \\right) \\tag{5} $$\n\n\
     $$ H = \\frac{m w}{b} - \\frac{m u}{b} \\ln\\left( 1 + \\frac wu \\right) \\tag{6} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "y, v": "any" }, "constants": { "m, b, g, w": "> 0" },
        "laws": { "Newton": "1 part 1", "the velocity": "1 part 2" }, "rubric": { "results": { "3": 1, "6": 1 } } }"#,
);

/// A bead on a hoop that turns; its energy is not conserved.
const HOOP: (&str, &str) = (
    "$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{1} $$\n\n\
     $$ \\ddot\\theta = \\omega^2 \\sin\\theta \\cos\\theta - \\frac gR \\sin\\theta \\tag{2} $$\n\n\
     $$ E = \\frac12 m R^2 (\\dot\\theta^2 + \\omega^2 \\sin^2\\theta) - m g R \\cos\\theta \\tag{3} $$\n\n\
     $$ \\dot E = m R^2 \\omega^2 \\dot\\theta \\sin(2\\theta) \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" }, "constants": { "m, R, g, \\omega": "> 0" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "2": 1, "4": 1 } } }"#,
);

/// Two masses, each with a spring, and one between them.
const MASSES: (&str, &str) = (
    "$$ L = \\frac12 m (\\dot x^2 + \\dot y^2) - \\frac12 K (x^2 + y^2) - \\frac12 k (x - y)^2 \\tag{1} $$\n\n\
     $$ (K + k - m \\omega^2)^2 - k^2 = 0 \\tag{2} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "x, y": "any" }, "constants": { "m, k, K, \\omega": "> 0" },
        "means": { "L": "Lagrangian" }, "equations": { "2": { "secular equation for": "\\omega" } },
        "rubric": { "results": { "2": 1 } } }"#,
);

#[test]
fn a_false_function_of_the_time_is_carried_to_its_integral_and_to_the_instant_at_which_it_vanishes() {
    let lines = "$$ v = w e^{-b t/m} - u $$\n\n\
        $$ y = \\int_0^t v \\, dt = \\frac mb w \\left( 1 - e^{-b t/m} \\right) - u t $$\n\n\
        At the top $v = 0$:\n\n$$ w e^{-b t_1/m} = u $$\n\n$$ t_1 = \\frac mb \\ln\\frac wu $$\n\n\
        $$ H = \\frac mb (w - u) - \\frac mb u \\ln\\frac wu $$\n";
    let found = marks("integral", BALL, lines);
    assert_eq!(found, ["wrong", "carried", "given", "carried", "carried", "carried"]);
    // The twins: a slip in the integral, in the equation for the instant, and in the height.
    let slip =
        lines.replace("- u t $$", "+ u t $$").replace("t_1/m} = u", "t_1/m} = 2 u").replace("(w - u)", "(w + u)");
    let found = marks("integral-slip", BALL, &slip);
    assert_eq!([&found[1], &found[3], &found[5]], ["wrong", "wrong", "wrong"]);
}

#[test]
fn the_rate_of_a_false_energy_is_carried_with_a_false_equation_of_motion() {
    let lines = |rate: &str| {
        format!(
            "$$ L = \\frac12 m R^2 \\dot\\theta^2 + m R^2 \\omega^2 \\sin^2\\theta + m g R \\cos\\theta $$\n\n\
             $$ \\ddot\\theta = 2 \\omega^2 \\sin\\theta \\cos\\theta - \\frac gR \\sin\\theta $$\n\n\
             $$ E = \\frac12 m R^2 \\dot\\theta^2 + m R^2 \\omega^2 \\sin^2\\theta - m g R \\cos\\theta $$\n\n\
             $$ \\dot E = {rate} m R^2 \\omega^2 \\dot\\theta \\sin\\theta \\cos\\theta $$\n"
        )
    };
    assert_eq!(marks("rate", HOOP, &lines("4")).last().unwrap(), "carried");
    assert_eq!(marks("rate-slip", HOOP, &lines("5")).last().unwrap(), "wrong");
}

/// A pendulum.
const PENDULUM: (&str, &str) = (
    "$$ L = \\frac12 m l^2 \\dot\\theta^2 + m g l \\cos\\theta \\tag{1} $$\n\n$$ \\ddot\\theta = -\\frac gl \\sin\\theta \\tag{2} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" }, "constants": { "m, l, g": "> 0" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "2": 1 } } }"#,
);

#[test]
fn one_of_several_energies_makes_the_lagrangian_false() {
    let lines = |spring: &str, sign: &str| {
        format!(
            "$$ U_s = {spring} (x - y)^2 $$\n\n$$ U_g = \\frac12 K (x^2 + y^2) $$\n\n\
             $$ L = \\frac12 m (\\dot x^2 + \\dot y^2) {sign} \\frac12 K (x^2 + y^2) - {spring} (x - y)^2 $$\n"
        )
    };
    assert_eq!(marks("energies", MASSES, &lines("k", "-")), ["wrong", "given", "carried"]);
    // The energy of a pendulum alone, with the wrong sign.
    let alone = "$$ U = m g l \\cos\\theta $$\n\n$$ L = \\frac12 m l^2 \\dot\\theta^2 - m g l \\cos\\theta $$\n";
    assert_eq!(marks("energy-alone", PENDULUM, alone), ["wrong", "carried"]);
    // The twins: true energies, with a slip in the Lagrangian.
    assert_eq!(marks("energies-slip", MASSES, &lines("\\frac12 k", "+")), ["given", "given", "wrong"]);
    let slip = alone.replace("U = m", "U = -m");
    assert_eq!(marks("energy-alone-slip", PENDULUM, &slip), ["given", "wrong"]);
}

#[test]
fn the_secular_equation_of_a_false_lagrangian_is_carried() {
    let lines = |last: &str| {
        format!(
            "$$ L = \\frac12 m (\\dot x^2 + \\dot y^2) - \\frac12 K (x^2 + y^2) - k (x - y)^2 $$\n\n\
             $$ (K + 2 k - m \\omega^2)^2 - {last} k^2 = 0 $$\n"
        )
    };
    assert_eq!(marks("secular", MASSES, &lines("4")), ["wrong", "carried"]);
    assert_eq!(marks("secular-slip", MASSES, &lines("2")), ["wrong", "wrong"]);
}

/// A string through a hole in a table, with the frequency of small oscillations about the circle.
const HOLE: (&str, &str) = (
    "$$ L = \\frac12 (m + M) \\dot r^2 + \\frac12 m r^2 \\dot\\phi^2 - M g r \\tag{1} $$\n\n\
     $$ p_\\phi = m r^2 \\dot\\phi = \\text{const} \\tag{2} $$\n\n\
     $$ (m + M) \\ddot r = \\frac{p_\\phi^2}{m r^3} - M g \\tag{3} $$\n\n\
     $$ p_\\phi^2 = m M g r_0^3 \\tag{4} $$\n\n$$ \\omega = \\sqrt{\\frac{3 M g}{(m + M) r_0}} \\tag{5} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "r": "> 0", "\\phi": "angle" }, "constants": { "m, M, g, r_0": "> 0" },
        "means": { "L": "Lagrangian", "\\omega": "frequency of small oscillations about r = r_0" },
        "equations": { "4": { "throughout": "r = r_0" } }, "rubric": { "results": { "4": 1, "5": 1 } } }"#,
);

#[test]
fn a_false_equation_of_motion_is_carried_to_the_circle_and_to_small_motion_about_it() {
    let lines = "$$ m \\ddot r = \\frac{p_\\phi^2}{m r^3} - 2 M g $$\n\n$$ p_\\phi^2 = 2 m M g r_0^3 $$\n\n\
        $$ \\omega^2 = \\frac{6 M g}{m r_0} $$\n";
    assert_eq!(marks("circle", HOLE, lines), ["wrong", "carried", "carried"]);
    // No state has such an angular momentum.
    let none = "$$ (m + M) \\ddot r = -\\frac{p_\\phi^2}{m r^3} - M g $$\n\n$$ p_\\phi^2 = -m M g r_0^3 $$\n";
    assert_eq!(marks("circle-none", HOLE, none), ["wrong", "carried"]);
    assert_eq!(marks("circle-none-slip", HOLE, &none.replace("-m M", "-2 m M")), ["wrong", "wrong"]);
    let slips = lines.replace("= 2 m M", "= 3 m M").replace("\\frac{6 M", "\\frac{5 M");
    assert_eq!(marks("circle-slips", HOLE, &slips), ["wrong", "wrong", "wrong"]);
}

#[test]
fn on_a_circle_the_angular_momentum_is_a_root_for_one_sense_of_the_motion() {
    assert_eq!(marks("sense", HOLE, "$$ m r_0^2 \\dot\\phi = \\sqrt{m M g r_0^3} $$\n"), ["right"]);
    assert_eq!(marks("sense-wrong", HOLE, "$$ m r_0^2 \\dot\\phi = \\sqrt{2 m M g r_0^3} $$\n"), ["wrong"]);
}

/// A capacitor that is charged.
const CAPACITOR: (&str, &str) = (
    "$$ I = \\dot q \\tag{1} $$\n\n$$ R I + \\frac{q}{C} = U \\tag{2} $$\n\n\
     $$ q = C U \\left( 1 - e^{-t/(RC)} \\right) \\tag{3} $$\n\n$$ I = \\frac UR e^{-t/(RC)} \\tag{4} $$\n\n\
     $$ t_h = R C \\ln 2 \\tag{5} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "q": "any" }, "constants": { "U, R, C": "> 0" },
        "define": { "t_h": "R C \\ln 2" }, "laws": { "Kirchhoff": "2" }, "rubric": { "results": { "3": 1, "5": 1 } } }"#,
);

#[test]
fn a_false_charge_is_carried_to_the_instant_of_its_half() {
    let grows = "$$ q = C U \\left( e^{t/(RC)} - 1 \\right) $$\n\n$$ t_h = R C \\ln\\frac32 $$\n";
    assert_eq!(marks("half-time", CAPACITOR, grows), ["wrong", "carried"]);
    // The twin: another instant.
    assert_eq!(marks("half-time-slip", CAPACITOR, &grows.replace("\\frac32", "3"))[1], "wrong");
}

/// A fast particle.
const PARTICLE: (&str, &str) = (
    "$$ \\gamma = \\frac{1}{\\sqrt{1 - v^2/c^2}} \\tag{1} $$\n\n$$ E = \\gamma m c^2, \\qquad p = \\gamma m v \\tag{2} $$\n\n\
     $$ v = \\frac{p c^2}{E} \\tag{3} $$\n\n$$ K = E - m c^2 \\tag{4} $$\n\n\
     $$ p c = \\sqrt{K^2 + 2 K m c^2} \\tag{5} $$\n",
    r#"{ "notes": "p.md", "constants": { "m, c": "> 0", "v": "(0, c)" }, "rubric": { "results": { "5": 1 } } }"#,
);

#[test]
fn a_step_may_use_a_relation_of_the_problem_that_is_not_written() {
    let lines = |below: &str| {
        format!(
            "$$ v = \\frac{{p c^2}}{{E}} $$\n\n$$ p c = \\sqrt{{K^2 + 4 K m c^2}} $$\n\n\
             $$ v = \\frac{{c \\sqrt{{K^2 + 4 K m c^2}}}}{{{below}}} $$\n"
        )
    };
    assert_eq!(marks("relation", PARTICLE, &lines("K + m c^2")), ["right", "wrong", "carried"]);
    assert_eq!(marks("relation-slip", PARTICLE, &lines("K + 3 m c^2"))[2], "wrong");
}
