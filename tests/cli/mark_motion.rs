//! `onshell mark`, where the laws leave initial values open and the model solution has put them in: what is true of its motion
//! is right, what is true for another motion is not, and a step from a false function of the time is carried.

use serde_json::{Value, json};

use crate::support::{self, Desk};

/// A body that is braked in proportion to its speed: `force` is what moves it, and the last two are its speed and its way.
fn braked(force: &str, speed: &str, way: &str) -> (String, Value) {
    let notes = format!(
        "$$ m \\dot v = {force} - c v \\tag{{1}} $$\n\n$$ \\dot x = v \\tag{{2}} $$\n\n$$ v(t) = {speed} \\tag{{3}} $$\n\n$$ x(t) = {way} \\tag{{4}} $$\n"
    );
    let claims = json!({
        "notes": "problem.md",
        "varies with time": { "v, x": "any" },
        "constants": { "m, c, g, u": "> 0" },
        "laws": { "Newton": "1", "velocity": "2" },
        "rubric": { "results": { "3": 1, "4": 1 } },
    });
    (notes, claims)
}

/// It starts with the speed u, and nothing else moves it.
fn sled() -> (String, Value) {
    braked("0", "u e^{-c t/m}", "\\frac{m u}{c} \\left(1 - e^{-c t/m}\\right)")
}

/// It sinks from rest.
fn stone() -> (String, Value) {
    let way = "\\frac{m g}{c} t - \\frac{m^2 g}{c^2} \\left(1 - e^{-c t/m}\\right)";
    braked("m g", "\\frac{m g}{c} \\left(1 - e^{-c t/m}\\right)", way)
}

/// The marks of the lines of a hand-in.
fn marks(name: &str, (notes, claims): (String, Value), lines: &[&str]) -> Vec<String> {
    let desk = Desk::new(&format!("mark-motion-{name}"));
    desk.write("problem.md", notes);
    desk.write("problem.json", claims.to_string());
    desk.write("one.md", lines.iter().map(|line| format!("$$ {line} $$\n\n")).collect::<String>());
    let run = desk.onshell(&["mark", "one.md", "--claims", "problem.json", "--format", "json"]);
    let report = run.json();
    let rows = report["rows"].as_array().unwrap().iter().map(|row| row["mark"].as_str().unwrap().to_owned());
    rows.filter(|mark| mark != "missing").collect()
}

#[test]
fn a_first_integral_of_a_motion_from_rest_is_right_and_with_another_sign_it_is_wrong() {
    assert_eq!(marks("integral", stone(), &["m v = m g t - c x"]), ["right"]);
    assert_eq!(marks("integral-false", stone(), &["m v = m g t + c x"]), ["wrong"]);
}

#[test]
fn a_quantity_of_the_students_own_moves_as_the_model_solution_does() {
    let own = "w = v - \\frac{m g}{c}";
    assert_eq!(marks("own", stone(), &[own, "w(t) = -\\frac{m g}{c} e^{-c t/m}"]), ["given", "right"]);
    // It solves the equation of motion, for another initial value.
    assert_eq!(marks("own-false", stone(), &[own, "w(t) = \\frac{m g}{c} e^{-c t/m}"]), ["given", "wrong"]);
}

#[test]
fn a_way_that_follows_from_a_false_speed_is_carried_and_never_right() {
    let false_speed = "v = u e^{c t/m}";
    let carried = "x = \\frac{m u}{c} \\left(e^{c t/m} - 1\\right)";
    assert_eq!(marks("way", sled(), &[false_speed, carried]), ["wrong", "carried"]);
    // With a slip of its own it is not carried.
    let slip = "x = \\frac{m u}{c} \\left(e^{c t/m} + 1\\right)";
    assert_eq!(marks("way-slip", sled(), &[false_speed, slip]), ["wrong", "wrong"]);
    assert_eq!(marks("way-alone", sled(), &[carried]), ["wrong"]);
}

#[test]
fn the_form_of_a_steady_motion_that_the_problem_gives_is_given() {
    let problem = || {
        let notes = "$$ m \\ddot x + b \\dot x + k x = F \\cos\\Omega t \\tag{1} $$\n\n$$ x = A \\cos(\\Omega t - \\delta) \\tag{2} $$\n\n\
            $$ A^2 \\left((k - m \\Omega^2)^2 + b^2 \\Omega^2\\right) = F^2 \\tag{3} $$\n";
        let claims = json!({
            "notes": "problem.md",
            "varies with time": { "x": "any" },
            "constants": { "m, b, k, F, \\Omega, A": "> 0", "\\delta": "any" },
            "laws": { "motion": "1", "steady": "2" },
        });
        (notes.to_owned(), claims)
    };
    let amplitude = "A^2 \\left((k - m \\Omega^2)^2 + b^2 \\Omega^2\\right) = F^2";
    assert_eq!(marks("steady", problem(), &["x = A \\cos(\\Omega t - \\delta)", amplitude]), ["given", "right"]);
    assert_eq!(marks("steady-false", problem(), &["x = A \\sin(\\Omega t - \\delta)"]), ["wrong"]);
}

/// A boat without its motor: the model solution prints the motion, and the value at an instant.
const BOAT: (&str, &str) = (
    "$$ m \\dot v = -k v \\tag{1} $$\n\n$$ x(t) = \\frac{m v_0}{k} \\left( 1 - e^{-k t/m} \\right) \\tag{2} $$\n\n\
     $$ v(t) = v_0 e^{-k t/m} \\tag{3} $$\n\n$$ t_h = \\frac{m}{k} \\ln 2 \\tag{4} $$\n\n$$ v(t_h) = \\frac12 v_0 \\tag{5} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "x": "any" }, "constants": { "m, k, v_0": "> 0" },
        "define": { "v": "\\dot x" }, "laws": { "Newton": "1" } }"#,
);

#[test]
fn an_integral_up_to_the_time_is_that_of_the_motion() {
    let of = |name: &str, integral: &str, factor: &str| {
        let lines =
            format!("$$ x(t) = {integral} = {factor} \\frac{{m v_0}}{{k}} \\left( 1 - e^{{-kt/m}} \\right) $$\n");
        support::marks(name, BOAT, &lines)
    };
    assert_eq!(of("prime", "\\int_0^t v(t') \\, dt'", ""), ["right"]);
    assert_eq!(of("tau", "\\int_0^t v(\\tau) \\, \\mathrm{d}\\tau", ""), ["right"]);
    assert_eq!(of("short", "\\int_0^t v \\, dt", ""), ["right"]);
    // The twins: a factor outside, and inside.
    assert_eq!(of("outside", "\\int_0^t v(t') \\, dt'", "2"), ["wrong"]);
    assert_ne!(of("inside", "\\int_0^t 2 v(t') \\, dt'", ""), ["right"]);
}

#[test]
fn a_step_from_a_false_motion_is_carried_by_integration_and_to_an_instant() {
    let of = |name: &str, lines: &[&str]| {
        support::marks(name, BOAT, &lines.iter().map(|line| format!("$$ {line} $$\n\n")).collect::<String>())
    };
    let first = "m \\dot v = -2 k v";
    assert_eq!(of("integral", &[first, "\\ln\\frac{v}{v_0} = -\\frac{2kt}{m}"]), ["wrong", "carried"]);
    let motion = "v(t) = v_0 \\left( 1 - \\frac{kt}{m} \\right)";
    assert_eq!(of("instant", &[motion, "1 - \\frac{k t_h}{m} = \\frac12"]), ["wrong", "carried"]);
    // The reciprocal of a constant in both.
    let other = "v(t) = v_0 e^{-t/(mk)}";
    assert_eq!(of("reciprocal", &[other, "e^{-t_h/(mk)} = \\frac12"]), ["wrong", "carried"]);
    // The twins: another factor, another start, another instant.
    assert_eq!(of("factor", &[first, "\\ln\\frac{v}{v_0} = -\\frac{3kt}{m}"]), ["wrong", "wrong"]);
    assert_eq!(of("start", &[first, "\\ln\\frac{v}{2 v_0} = -\\frac{2kt}{m}"]), ["wrong", "wrong"]);
    assert_eq!(of("third", &[motion, "1 - \\frac{k t_h}{m} = \\frac13"]), ["wrong", "wrong"]);
}

#[test]
fn a_period_in_parentheses_is_an_instant_and_e_alone_is_a_number() {
    let tau = "$$ \\tau = \\frac mk $$\n\n";
    let of = |name: &str, line: &str| {
        support::marks(name, BOAT, &format!("{tau}$$ v = v_0 e^{{-t/\\tau}} $$\n\n$$ {line} $$\n"))
    };
    assert_eq!(of("once", "v(\\tau) = \\frac{v_0}{e}")[2], "right");
    assert_eq!(of("twice", "v(2\\tau) = v_0 e^{-2}")[2], "right");
    // The twins.
    assert_eq!(of("once-wrong", "v(\\tau) = \\frac{v_0}{2e}")[2], "wrong");
    assert_eq!(of("twice-wrong", "v(2\\tau) = v_0 e^{-3}")[2], "wrong");
}
