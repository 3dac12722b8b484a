//! `onshell mark`, where a line speaks of a special state: an instant, a case, a place of rest, small motion; and where a step
//! goes on from a false line there. Beside each true line stands one that must not be right.

use crate::support::marks;

/// A disc that unrolls from a thread: the laws leave the start open.
const DISC: (&str, &str) = (
    "$$ I = \\frac12 m R^2, \\qquad \\omega = \\frac{\\dot y}{R} \\tag{1} $$\n\n\
     $$ S = m g - m \\ddot y \\tag{2} $$\n\n$$ I \\dot\\omega = S R \\tag{3} $$\n\n\
     $$ \\ddot y = \\frac23 g \\tag{4} $$\n\n$$ t_1 = \\sqrt{\\frac{3h}{g}} \\tag{6} $$\n\n\
     $$ v_1 = \\frac23 g t_1 = \\sqrt{\\frac{4 g h}{3}} \\tag{7} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "y": "any" }, "constants": { "m, R, g, h": "> 0" },
        "laws": { "the torque": "3" }, "rubric": { "results": { "4": 1, "7": 1 } } }"#,
);

/// A block on a spring: the model solution prints the motion.
const SPRING: (&str, &str) = (
    "$$ m \\ddot x = m g \\sin\\alpha - k x \\tag{1} $$\n\n$$ x_0 = \\frac{m g \\sin\\alpha}{k} \\tag{2} $$\n\n\
     $$ y = x - x_0 \\tag{3} $$\n\n$$ \\omega = \\sqrt{\\frac{k}{m}} \\tag{5} $$\n\n\
     $$ x = x_0 (1 - \\cos\\omega t) \\tag{6} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "x": "any" },
        "constants": { "m, k, g": "> 0", "\\alpha": "(0, \\pi/2)" }, "laws": { "Newton": "1" } }"#,
);

/// A bead on a hoop that turns.
const HOOP: (&str, &str) = (
    "$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\Omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{1} $$\n\n\
     $$ \\ddot\\theta = \\left( \\Omega^2 \\cos\\theta - \\frac gR \\right) \\sin\\theta \\tag{2} $$\n\n\
     $$ \\cos\\theta_0 = \\frac{g}{R \\Omega^2} \\tag{3} $$\n\n$$ \\omega^2 = \\frac gR - \\Omega^2 \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" },
        "constants": { "m, R, g, \\Omega": "> 0", "\\theta_0": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian", "\\omega": "normal frequency" },
        "equations": { "3": { "equilibrium": true, "at": { "\\theta": "\\theta_0" } } } }"#,
);

#[test]
fn a_line_may_speak_of_the_instant_at_which_a_speed_is_reached() {
    let of = |name: &str, lines: &str| marks(name, DISC, lines);
    let energy = "$$ mgh = \\frac12 mv^2 + \\frac12 I\\omega^2 $$\n\n$$ v = \\sqrt{\\frac43 gh} $$\n";
    assert_eq!(of("speed", energy), ["right", "right"]);
    // The twins: the energy without its half, and another speed.
    let rolls = "$$ v = \\omega R $$\n\n";
    let wrong =
        of("speed-wrong", &format!("{rolls}$$ mgh = mv^2 + \\frac12 I\\omega^2 $$\n\n$$ v = \\sqrt{{gh}} $$\n"));
    assert_eq!(wrong[1..], ["wrong", "wrong"]);
}

#[test]
fn a_way_and_a_speed_may_be_functions_of_the_time_from_rest() {
    let of = |name: &str, lines: &str| marks(name, DISC, lines);
    let lines = "$$ y = \\frac13 gt^2 $$\n\n$$ h = \\frac13 gt^2 $$\n\n$$ \\dot y = \\frac23 gt $$\n";
    assert_eq!(of("from-rest", lines), ["right", "right", "right"]);
    // The twins: other accelerations.
    let lines = "$$ y = \\frac23 gt^2 $$\n\n$$ h = \\frac23 gt^2 $$\n\n$$ \\dot y = \\frac13 gt $$\n";
    let wrong = of("from-rest-wrong", lines);
    assert!(wrong.iter().all(|mark| mark == "wrong" || mark == "carried"), "{wrong:?}");
}

#[test]
fn a_letter_of_the_problem_may_be_another_of_its_quantities() {
    let lines = |more: &str| {
        format!(
            "$$ \\ddot\\varphi = \\omega^2\\sin\\varphi\\cos\\varphi - \\frac{{g}}{{a}}\\sin\\varphi $$\n\n\
             $$ \\cos\\varphi_0 = \\frac{{g}}{{a\\omega^2}} $$\n\n$$ \\nu^2 = {more} $$\n"
        )
    };
    let right = marks("permuted", HOOP, &lines("\\frac{g}{a} - \\omega^2"));
    assert_eq!(right, ["right", "right", "right"]);
    // The twin: the sign.
    assert_ne!(marks("permuted-wrong", HOOP, &lines("\\frac{g}{a} + \\omega^2"))[2], "right");
}

#[test]
fn small_motion_and_the_other_places_of_rest_are_right() {
    let lines = "$$ \\sin\\theta_0 = 0 \\quad\\text{or}\\quad \\cos\\theta_0 = \\frac{g}{R\\Omega^2} $$\n\n\
                 $$ \\ddot\\theta = -\\left(\\frac gR - \\Omega^2\\right)\\theta $$\n";
    assert_eq!(marks("rest", HOOP, lines), ["right", "right", "right"]);
    // The twins: no place of rest, a factor, and a function that only begins as the true one does.
    let lines = "$$ \\sin\\theta_0 = 1 $$\n\n$$ \\ddot\\theta = -\\left(\\frac gR - 2\\Omega^2\\right)\\theta $$\n\n\
                 $$ \\ddot\\theta = -\\left(\\frac gR - \\Omega^2\\right)\\tan\\theta $$\n";
    let wrong = marks("rest-wrong", HOOP, lines);
    assert!(!wrong.contains(&"right".to_owned()), "{wrong:?}");
}

#[test]
fn a_value_at_an_instant_is_that_of_the_motion() {
    let right = "$$ y(0) = -x_0, \\qquad \\dot y(0) = 0 $$\n\n$$ x(t = 0) = 0 $$\n";
    assert_eq!(marks("start", SPRING, right), ["right", "right", "right"]);
    // The twin: the sign. What follows from it for the motion is carried.
    let wrong = "$$ y(0) = x_0 $$\n\n$$ x(t) = x_0 + x_0\\cos\\omega t $$\n";
    assert_eq!(marks("start-wrong", SPRING, wrong), ["wrong", "carried"]);
}

#[test]
fn a_solution_may_have_constants_that_are_said_later() {
    let with = |form: &str| format!("$$ y(t) = {form} $$\n\n$$ A = 2 x_0 $$\n\n$$ \\omega^2 = \\frac km $$\n");
    assert_eq!(marks("constants", SPRING, &with("A\\cos\\omega t"))[0], "right");
    // The twin solves nothing.
    assert_eq!(marks("constants-wrong", SPRING, &with("A\\cos 2\\omega t"))[0], "wrong");
}

#[test]
fn what_follows_from_a_condition_and_a_true_line_is_right() {
    let lines = |last: &str| {
        format!(
            "$$ \\frac12 m\\dot x^2 + \\frac12 kx^2 = mgx\\sin\\alpha $$\n\nTurning points: $\\dot x = 0$, i.e.\n\n\
             $$ \\frac12 kx^2 = mgx\\sin\\alpha $$\n\n$$ {last} $$\n"
        )
    };
    let cases = "x = 0 \\quad\\text{or}\\quad x = \\frac{2mg\\sin\\alpha}{k}";
    let right = marks("turning", SPRING, &lines(cases));
    assert!(!right.contains(&"wrong".to_owned()) && !right.contains(&"carried".to_owned()), "{right:?}");
    // The twin: another place.
    let wrong = marks("turning-wrong", SPRING, &lines("x = \\frac{mg\\sin\\alpha}{2k}"));
    assert_eq!(wrong[3], "wrong", "{wrong:?}");
}

#[test]
fn a_step_from_a_false_line_is_carried_to_an_instant_to_rest_and_to_small_motion() {
    let fall = "$$ I = mR^2 $$\n\n$$ \\ddot y = \\frac12 g $$\n\n$$ y = \\frac14 gt^2 $$\n\n\
                $$ t_1 = \\sqrt{\\frac{4h}{g}} $$\n\n$$ v_1 = \\frac12 gt_1 = \\sqrt{gh} $$\n";
    assert_eq!(marks("carried-instant", DISC, fall), ["wrong", "carried", "carried", "carried", "carried"]);
    let slope = "$$ \\frac{\\partial L}{\\partial\\theta} = \\frac{m}{2}R^2\\Omega^2\\sin\\theta\\cos\\theta - mgR\\sin\\theta $$\n\n\
                 $$ mR^2\\ddot\\theta = \\frac12 mR^2\\Omega^2\\sin\\theta\\cos\\theta - mgR\\sin\\theta $$\n\n\
                 $$ 0 = \\sin\\theta_0\\left(\\frac12\\Omega^2\\cos\\theta_0 - \\frac gR\\right) $$\n\n\
                 $$ \\ddot\\theta = -\\left(\\frac gR - \\frac12\\Omega^2\\right)\\theta $$\n\n\
                 $$ \\omega^2 = \\frac gR - \\frac12\\Omega^2 $$\n";
    assert_eq!(marks("carried-slope", HOOP, slope), ["wrong", "carried", "carried", "carried", "carried"]);
    // The twins: a second mistake on the way is wrong.
    let second = fall.replace("\\frac{4h}{g}", "\\frac{5h}{g}").replace("\\sqrt{gh}", "\\sqrt{3gh}");
    let found = marks("carried-instant-wrong", DISC, &second);
    assert_eq!((found[3].as_str(), found[4].as_str()), ("wrong", "wrong"));
    let second = slope.replace("\\omega^2 = \\frac gR - \\frac12", "\\omega^2 = \\frac gR - \\frac13");
    assert_eq!(marks("carried-slope-wrong", HOOP, &second)[4], "wrong");
}

#[test]
fn an_energy_that_makes_the_lagrangian_false_is_wrong_and_the_lagrangian_carried() {
    let lines = |kinetic: &str, potential: &str, sign: &str| {
        format!(
            "$$ T = \\frac12 mR^2\\left(\\dot\\theta^2 + {kinetic}\\right) $$\n\n$$ U = {potential} $$\n\n\
             $$ L = \\frac12 mR^2\\dot\\theta^2 + \\frac12 mR^2{kinetic} {sign} mgR\\cos\\theta $$\n"
        )
    };
    let true_one = "\\Omega^2\\sin^2\\theta";
    let sign = marks("energy-sign", HOOP, &lines(true_one, "mgR\\cos\\theta", "-"));
    assert_eq!(sign, ["given", "wrong", "carried"]);
    let function = marks("energy-function", HOOP, &lines("\\Omega^2\\cos^2\\theta", "-mgR\\cos\\theta", "+"));
    assert_eq!(function, ["wrong", "given", "carried"]);
    // Where nothing says what they are, the sign is wrong all the same.
    assert_eq!(marks("energy-sum", HOOP, "$$ L = T + U $$\n"), ["wrong"]);
    assert_eq!(marks("energy-difference", HOOP, "$$ L = T - U $$\n"), ["given"]);
    // The twins: true energies, and a Lagrangian that is not their difference.
    assert_eq!(marks("energy-right", HOOP, &lines(true_one, "-mgR\\cos\\theta", "+")), ["given", "given", "right"]);
    assert_eq!(marks("energy-other", HOOP, &lines(true_one, "-mgR\\cos\\theta", "-")), ["given", "given", "wrong"]);
}

#[test]
fn a_product_of_given_numbers_with_units_is_right() {
    let problem = (
        "$$ R \\dot q = -\\frac{q}{C} \\tag{1} $$\n\n$$ t_h = R C \\ln 2 \\tag{2} $$\n",
        r#"{ "notes": "p.md", "varies with time": { "q": "> 0" }, "constants": { "R, C": "> 0" }, "laws": { "Kirchhoff": "1" } }"#,
    );
    let lines = |product: &str| {
        format!(
            "with $R = 10\\,000\\,\\Omega$ and $C = 100\\cdot10^{{-6}}\\,\\text{{F}}$ it is\n\n$$ RC = {product}\\,\\text{{s}} $$\n\n$$ \\frac{{dq}}{{q}} = -\\frac{{dt}}{{RC}} $$\n"
        )
    };
    assert_eq!(marks("numbers", problem, &lines("1{,}0")), ["given", "given", "right", "right"]);
    // The twin: another number.
    assert_eq!(marks("numbers-wrong", problem, &lines("1{,}5"))[2], "wrong");
}

/// A bead on a hoop that turns, with the frequency about its place of rest beside the axis.
const BESIDE: (&str, &str) = (
    "$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{1} $$\n\n\
     $$ \\ddot\\theta = \\left( \\omega^2 \\cos\\theta - \\frac gR \\right) \\sin\\theta \\tag{2} $$\n\n\
     $$ \\cos\\theta_0 = \\frac{g}{R \\omega^2} \\tag{3} $$\n\n$$ \\Omega = \\omega \\sin\\theta_0 \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" },
        "constants": { "m, R, g, \\omega": "> 0", "\\theta_0": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian", "\\Omega": "frequency of small oscillations about \\theta = \\theta_0" },
        "equations": { "3": { "equilibrium": true, "at": { "\\theta": "\\theta_0" } } } }"#,
);

#[test]
fn a_small_deviation_from_a_place_of_rest_obeys_a_linear_equation() {
    let of = |name: &str, lines: &str| marks(name, BESIDE, lines);
    let line =
        |factor: &str| format!("$$ \\ddot\\varepsilon = -{factor}\\omega^2\\sin^2\\theta_0 \\, \\varepsilon $$\n");
    let sum = "$$ \\theta = \\theta_0 + \\varepsilon $$\n\n";
    let difference = "With $\\varepsilon = \\theta - \\theta_0$:\n\n";
    for (name, before) in
        [("sum", sum), ("difference", difference), ("words", "With the deviation $\\varepsilon$:\n\n")]
    {
        assert_eq!(of(name, &format!("{before}{}", line(""))).last().unwrap(), "right", "{name}");
    }
    // The twins: two factors, and what is no deviation.
    assert_eq!(of("factor", &format!("{sum}{}", line("2"))), ["given", "wrong"]);
    assert_eq!(of("half", &format!("{difference}{}", line("\\frac12"))), ["given", "wrong"]);
    let other = "$$ \\ddot\\varepsilon = -\\omega^2\\sin^2\\theta_0 \\, \\theta $$\n";
    assert_eq!(of("place", &format!("{sum}{other}")), ["given", "wrong"]);
}

#[test]
fn a_false_equation_of_motion_is_carried_to_small_motion_about_its_place_of_rest() {
    let lines = |square: &str| {
        format!(
            "$$ \\ddot\\theta = 2\\omega^2\\sin\\theta\\cos\\theta - \\frac gR\\sin\\theta $$\n\n\
             $$ \\cos\\theta_0 = \\frac{{g}}{{2 R\\omega^2}} $$\n\n$$ \\Omega^2 = {square} $$\n"
        )
    };
    let of = |name: &str, square: &str| marks(name, BESIDE, &lines(square));
    assert_eq!(of("carried", "2\\omega^2\\sin^2\\theta_0"), ["wrong", "carried", "carried"]);
    // The twin: a slip of its own.
    assert_eq!(of("slip", "3\\omega^2\\sin^2\\theta_0"), ["wrong", "carried", "wrong"]);
    let slope = |factor: &str| {
        format!(
            "$$ \\frac{{\\partial L}}{{\\partial \\theta}} = \\frac12 m R^2 \\omega^2 \\sin\\theta \\cos\\theta - m g R \\sin\\theta $$\n\n\
             $$ \\ddot\\theta = {factor} \\omega^2 \\sin\\theta \\cos\\theta - \\frac gR \\sin\\theta $$\n"
        )
    };
    assert_eq!(marks("slope", BESIDE, &slope("\\frac12")), ["wrong", "carried"]);
    assert_eq!(marks("slope-slip", BESIDE, &slope("\\frac13")), ["wrong", "wrong"]);
}

/// A gas that is compressed without heat: the numbers are left open.
const GAS: (&str, &str) = (
    "$$ T_2 = T_1 \\left( \\frac{V_1}{V_2} \\right)^{\\gamma - 1} \\tag{1} $$\n\n\
     $$ p_2 = p_1 \\left( \\frac{V_1}{V_2} \\right)^\\gamma \\tag{2} $$\n",
    r#"{ "notes": "p.md", "constants": { "p_1, T_1, V_1, V_2": "> 0", "\\gamma": "(1, \\infty)" } }"#,
);

#[test]
fn a_ratio_of_data_is_a_condition_with_which_numbers_are_right() {
    let of = |name: &str, lines: &str| marks(name, GAS, lines);
    let formula = "$$ T_2 = T_1 \\left( \\frac{V_1}{V_2} \\right)^{\\gamma - 1} $$\n\n";
    let data = "Beispiel:\n\n$$ \\gamma = 1{,}4, \\quad \\frac{V_1}{V_2} = 10, \\quad T_1 = 293\\,\\text{K} $$\n\n";
    let with = |value: &str| format!("{formula}{data}$$ T_2 = {value}\\,\\text{{K}} $$\n");
    assert_eq!(of("ratio", &with("736")), ["right", "given", "given", "given", "right"]);
    // The twins: another number; a ratio of which no word says that it is a condition; a result that is no datum.
    assert_eq!(of("ratio-wrong", &with("763")).last().unwrap(), "wrong");
    assert_eq!(of("bare", "$$ \\frac{V_1}{V_2} = 10 $$\n\n$$ T_1 = T_2 $$\n")[0], "undecided");
    assert_eq!(of("result", "$$ \\frac{p_2}{p_1} = 10 $$\n\n$$ p_2 = p_1 $$\n")[0], "wrong");
}

/// A string through a hole in a table: the circle is a special state, of which the problem speaks in one equation.
const HOLE: (&str, &str) = (
    "$$ L = \\frac12 (m + M) \\dot r^2 + \\frac12 m r^2 \\dot\\phi^2 - M g r \\tag{1} $$\n\n\
     $$ p_\\phi = m r^2 \\dot\\phi \\tag{2} $$\n\n\
     $$ (m + M) \\ddot r = \\frac{p_\\phi^2}{m r^3} - M g \\tag{3} $$\n\n\
     $$ p_\\phi^2 = m M g r_0^3 \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "r": "> 0", "\\phi": "angle" }, "constants": { "m, M, g, r_0": "> 0" },
        "means": { "L": "Lagrangian" }, "equations": { "4": { "throughout": "r = r_0" } } }"#,
);

#[test]
fn what_holds_on_the_circle_only_is_no_equation_of_motion() {
    let of = |name: &str, line: &str| marks(name, HOLE, &format!("$$ {line} $$\n"))[0].clone();
    assert_eq!(of("motion", "(m + M) \\ddot r = m r \\dot\\phi^2 - M g"), "right");
    // Where r stays, a lost mass makes no difference.
    assert_eq!(of("lost", "m \\ddot r = m r \\dot\\phi^2 - M g"), "wrong");
    assert_eq!(of("circle", "m r_0 \\dot\\phi^2 = M g"), "right");
}

#[test]
fn a_rate_that_is_said_to_vanish_is_a_condition() {
    let throw = (
        "$$ x = v t \\cos\\alpha, \\qquad y = v t \\sin\\alpha - \\frac12 g t^2 \\tag{1} $$\n\n\
         $$ y = x \\tan\\alpha - \\frac{g x^2}{2 v^2 \\cos^2\\alpha} \\tag{2} $$\n\n\
         $$ t_1 = \\frac{v \\sin\\alpha}{g} \\tag{3} $$\n",
        r#"{ "notes": "p.md", "constants": { "v, g": "> 0", "\\alpha": "(0, \\pi/2)" }, "rubric": { "results": { "2": 1, "3": 1 } } }"#,
    );
    let of = |name: &str, text: &str| marks(name, throw, text)[0].clone();
    assert_eq!(of("top", "At the top $\\dot y = 0$, so\n\n$$ t_1 = \\frac{v \\sin\\alpha}{g} $$\n"), "given");
    // Not said, and no rate.
    assert_ne!(of("bare", "$$ \\dot y = 0 $$\n\n$$ t_1 = \\frac{v \\sin\\alpha}{g} $$\n"), "right");
    assert_eq!(of("other", "So we find\n\n$$ \\dot y = v \\sin\\alpha + g t $$\n"), "wrong");
}

#[test]
fn a_name_for_a_rate_has_its_solution() {
    let circuit = |current: &str| {
        format!(
            "$$ I = \\dot q \\tag{{1}} $$\n\n$$ R I + \\frac qC = U \\tag{{2}} $$\n\n\
             $$ q = C U \\left( 1 - e^{{-t/(RC)}} \\right) \\tag{{3}} $$\n\n$$ I = {current} e^{{-t/(RC)}} \\tag{{4}} $$\n"
        )
    };
    let claims = r#"{ "notes": "p.md", "varies with time": { "q": "any" }, "constants": { "U, R, C": "> 0" },
        "laws": { "Kirchhoff": "2" }, "rubric": { "results": { "4": 1 } } }"#;
    let of = |name: &str, problem: &str, line: &str| marks(name, (problem, claims), &format!("$$ {line} $$\n"));
    let right = circuit("\\frac UR");
    assert_eq!(of("current", &right, "I = \\frac UR e^{-t/(RC)}"), ["right"]);
    assert_eq!(of("current-slip", &right, "I = \\frac UC e^{-t/(RC)}"), ["wrong"]);
}

#[test]
fn an_energy_with_another_zero_is_right() {
    let problem = (
        "$$ L = \\frac12 m \\dot x^2 - m g x \\tag{1} $$\n\n$$ m \\ddot x = -m g \\tag{2} $$\n\n\
         $$ E = \\frac12 m \\dot x^2 + m g x \\tag{3} $$\n",
        r#"{ "notes": "p.md", "coordinates": { "x": "any" }, "constants": { "m, g, l": "> 0" },
            "means": { "L": "Lagrangian", "E": "energy" }, "rubric": { "results": { "2": 1, "3": 1 } } }"#,
    );
    let of = |name: &str, line: &str| marks(name, problem, &format!("$$ {line} $$\n"))[0].clone();
    assert_eq!(of("other", "E = \\frac12 m \\dot x^2 - m g (l - x)"), "right");
    assert_eq!(of("lagrangian", "L = \\frac12 m \\dot x^2 + m g (l - x)"), "right");
    // Twice the energy is as constant along the motion, and another sign of the potential is no other zero.
    assert_eq!(of("twice", "E = m \\dot x^2 + 2 m g x"), "wrong");
    assert_eq!(of("sign", "E = \\frac12 m \\dot x^2 + m g (l - x)"), "wrong");
}
