//! What a message says is true: nothing true is called wrong, nothing false is right, and no advice spoils what is right. Beside each
//! case stands one in which the program must say the opposite.

use serde_json::{Value, json};

use crate::support::{Desk, Run, marks};

/// The report on notes and claims, or on notes alone.
fn check(name: &str, notes: &str, claims: Option<Value>) -> Run {
    let desk = Desk::new(&format!("true-messages-{name}"));
    desk.write("notes.md", notes);
    if let Some(claims) = claims {
        desk.write("notes.json", format!("{claims:#}"));
    }
    desk.onshell(&["check", "notes.md", "--verbose"])
}

fn says(run: &Run, words: &str) {
    assert!(run.out.contains(words) || run.err.contains(words), "no “{words}” in:\n{}{}", run.out, run.err);
}

fn is_silent(run: &Run, words: &str) {
    assert!(!run.out.contains(words) && !run.err.contains(words), "“{words}” in:\n{}{}", run.out, run.err);
}

/// A pendulum with a claim about display 1.
fn pendulum(claim: Value) -> Value {
    json!({
        "notes": "notes.md", "system": "simple_pendulum", "coordinates": { "\\theta": "angle" },
        "constants": { "m, l, g": "> 0" }, "means": { "E": "energy" }, "equations": { "1": claim },
    })
}

#[test]
fn an_equation_of_motion_is_no_position_of_rest() {
    let motion = "$$ \\ddot\\theta = -\\frac gl\\sin\\theta \\tag{1} $$\n";
    let run = check("rest", motion, Some(pendulum(json!({ "equilibrium": true }))));
    says(&run, "(1) was not decided: \"equilibrium\" needs a display without time derivatives");
    is_silent(&run, "did you mean");
    // `--fix` leaves the true equation as it is.
    let desk = Desk::new("true-messages-rest-fix");
    desk.write("notes.md", motion);
    desk.write("notes.json", pendulum(json!({ "equilibrium": true })).to_string());
    desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!(desk.read("notes.md"), motion);
    // A place is judged, and a wrong one is wrong.
    let place = |name: &str, at: &str| {
        check(name, &format!("$$ \\theta = {at} \\tag{{1}} $$\n"), Some(pendulum(json!({ "equilibrium": true }))))
    };
    says(&place("rest-place", "0"), "the system stays at rest here");
    says(&place("rest-wrong", "\\frac\\pi2"), "(1) is refuted: the system does not stay at rest here");
}

#[test]
fn the_values_of_also_equals_stand_on_the_sides_that_are_named() {
    let claims = |also: &str| json!({ "notes": "notes.md", "constants": { "a, b": "> 0" }, "equations": { "1": { "also equals": also } } });
    let notes = "$$ (a + b)^2 = a^2 + 2ab + b^2 \\tag{1} $$\n";
    let run = check("also", notes, Some(claims("0")));
    says(&run, "the formula of \"also equals\" (left side) differs from the printed formula (right side)");
    says(&run, "left side 0, right side ");
    is_silent(&check("also-true", notes, Some(claims("(b + a)^2"))), "differs");
}

#[test]
fn a_conversion_of_units_that_is_off_by_far_is_wrong() {
    let found = |name: &str, line: &str| check(name, &format!("$$ {line} $$\n"), None);
    for (name, wrong, said) in [
        ("hour", "1\\,\\text{h} = 360\\,\\text{s}", "the numbers give 3600 s, and 360 s is printed"),
        ("kilometre", "1\\,\\text{km} = 100\\,\\text{m}", "the numbers give 1000 m, and 100 m is printed"),
    ] {
        let run = found(name, wrong);
        says(&run, said);
        assert_eq!(run.code, 1, "{}", run.out);
    }
    // Tables round, and so do people.
    for (name, right) in [
        ("hour-right", "1\\,\\text{h} = 3600\\,\\text{s}"),
        ("year", "1\\,\\text{yr} = 3\\cdot 10^7\\,\\text{s}"),
        ("atmosphere", "1\\,\\text{atm} = 100\\,\\text{kPa}"),
        ("few", "5\\,\\text{J} = 3\\,\\text{N}\\cdot 1.2\\,\\text{m}"),
    ] {
        assert_eq!(found(name, right).code, 0, "{right}");
    }
    says(&found("few", "5\\,\\text{J} = 3\\,\\text{N}\\cdot 1.2\\,\\text{m}"), "too few digits to call this wrong");
}

#[test]
fn a_result_that_the_values_of_the_text_do_not_give_is_told() {
    let with = |name: &str, result: &str| {
        let notes = format!(
            "For $v = 20\\,\\text{{m/s}}$ and $a = 4\\,\\text{{m/s}}^2$ the distance is\n\n\
             $$ d = \\frac{{v^2}}{{2a}} = {result}\\,\\text{{m}} $$\n"
        );
        check(name, &notes, None)
    };
    let run = with("example-twice", "100");
    says(&run, "the formula gives 50 m for v = 20 m s⁻¹, a = 4 m s⁻², and 100 m is printed");
    // A number of the formula that no author loses is no likely slip.
    let run = with("example-fifth", "20");
    says(&run, "the formula gives 50 m");
    is_silent(&run, "did you mean");
    says(&with("example-right", "50"), "verified");
    // A lost 2 is one.
    let run = with("example-half", "25");
    says(&run, "and 25 m is printed");
    assert_eq!(run.code, 1, "{}", run.out);
}

#[test]
fn an_inequality_that_fails_where_both_sides_are_equal_says_so() {
    let claims = |assume: &str| {
        let claim = json!({ "assume": assume });
        json!({ "notes": "notes.md", "constants": { "a, b": "any" }, "equations": { "1": claim, "2": claim } })
    };
    let notes = "$$ a > b \\tag{1} $$\n\n$$ a \\ne b \\tag{2} $$\n";
    let run = check("equal-sides", notes, Some(claims("a = b")));
    is_silent(&run, "difference");
    says(&run, "a > b is false under its hypotheses; the two sides are equal there: write ≥");
    says(&run, "a ≠ b is false under its hypotheses; the two sides are equal there");
    // Where they differ, the values are printed as they are.
    let run = check("other-sides", notes, Some(claims("a = b - 1")));
    is_silent(&run, "the two sides are equal there");
    says(&run, "(1) is refuted");
}

#[test]
fn a_unit_after_a_letter_is_called_a_unit_and_no_zero_is_proposed() {
    let claims = || Some(json!({ "notes": "notes.md", "constants": { "a, b": "> 0" } }));
    let run = check("letter-unit", "$$ F_1 = a\\,\\text{m} \\tag{1} $$\n", claims());
    says(&run, "a unit after a letter or a formula is not supported");
    is_silent(&run, "“0”");
    // Words are no unit.
    let run = check("letter-word", "$$ F_1 = a\\,\\text{foo} \\tag{1} $$\n", claims());
    says(&run, "“foo” is no unit");
    is_silent(&run, "a unit after a letter");
}

#[test]
fn a_law_or_a_definition_is_not_made_zero_so_that_a_claim_passes() {
    let notes = "$$ v = \\dot x \\tag{1} $$\n\n$$ a = \\dot v \\tag{2} $$\n\n$$ a = g - k v \\tag{3} $$\n\n";
    let claims = |claim: Value| {
        Some(json!({
            "notes": "notes.md", "varies with time": { "x": "any" }, "constants": { "g, k": "> 0" },
            "laws": { "the motion": "3" }, "equations": { "4": claim },
        }))
    };
    let run =
        check("law-zero", &format!("{notes}$$ v = \\frac gk \\tag{{4}} $$\n"), claims(json!({ "assume": "x(0) = 1" })));
    is_silent(&run, "“0”");
    says(&run, "(4) is refuted");
    // What follows from the law passes.
    let run = check("law-true", &format!("{notes}$$ \\ddot x = g - k \\dot x \\tag{{4}} $$\n"), claims(json!({})));
    is_silent(&run, "(4) is refuted");
}

#[test]
fn fix_edits_neither_of_two_displays_that_contradict_each_other() {
    let notes = "# Falling\n\n$$ v = g t $$\n\n$$ y = \\frac12 g t^2 $$\n\n$$ v^2 = 4 g y $$\n";
    let desk = Desk::new("true-messages-contradiction");
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!(desk.read("notes.md"), notes, "{}{}", run.out, run.err);
    says(&run, "only you know which is wrong");
    // One likely slip is edited.
    let slip = "# A wire\n\nThe Lagrangian of a bead on it is\n\n\
                $$ L = \\frac12 m (1 + 4 a^2 x^2) \\dot x^2 - m g a x^2 $$\n\n\
                $$ (1 + 4 a^2 x^2) \\ddot x + 4 a^2 x \\dot x^2 - 2 a g x = 0 $$\n";
    desk.write("notes.md", slip);
    desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert!(desk.read("notes.md").contains("+ 2 a g x"), "{}", desk.read("notes.md"));
}

/// A ball that is thrown upwards.
const BALL: (&str, &str) = (
    "A ball is thrown with the speed $v_0$.\n\n$$ v = v_0 - g t, \\qquad y = v_0 t - \\frac12 g t^2 $$\n\n\
     $$ t_1 = \\frac{v_0}{g} \\tag{1} $$\n\n$$ H = v_0 t_1 - \\frac12 g t_1^2 = \\frac{v_0^2}{2g} \\tag{2} $$\n",
    r#"{ "notes": "p.md", "constants": { "v_0, g": "> 0" }, "rubric": { "results": { "2": 2 } } }"#,
);

#[test]
fn a_number_with_the_unit_of_another_quantity_is_wrong() {
    let with = |name: &str, result: &str| {
        let data = "$$ v_0 = 10\\,\\text{m/s}, g = 9.81\\,\\text{m/s}^2 $$\n\n";
        marks(name, BALL, &format!("{data}$$ H = {result} $$\n")).pop().unwrap()
    };
    assert_eq!(with("seconds", "\\frac{v_0^2}{2g} = 5.1\\,\\text{s}"), "wrong");
    assert_eq!(with("kilograms", "\\frac{v_0^2}{2g} = 5.1\\,\\text{kg}"), "wrong");
    assert_eq!(with("alone", "5.1\\,\\text{kg}"), "wrong");
    assert_eq!(with("metres", "\\frac{v_0^2}{2g} = 5.1\\,\\text{m}"), "right");
    assert_eq!(with("centimetres", "\\frac{v_0^2}{2g} = 510\\,\\text{cm}"), "right");
    // J/N is a metre too.
    assert_eq!(with("joules", "\\frac{v_0^2}{2g} = 5.1\\,\\text{J/N}"), "right");
    // In letters of the student too; without data nobody knows the unit of what is on the left side.
    let alone = marks("no-data", BALL, "$$ H = 5.1\\,\\text{kg} $$\n");
    assert_ne!(alone[0], "wrong");
    let own = "$$ u = 10\\,\\text{m/s}, g = 9.81\\,\\text{m/s}^2 $$\n\n$$ h = \\frac{u^2}{2g} = 5.1\\,\\text{kg} $$\n";
    assert_eq!(marks("own-letters", BALL, own)[2], "wrong");
}

#[test]
fn a_line_of_zeros_proves_nothing() {
    let first = |name: &str, line: &str| {
        marks(name, BALL, &format!("$$ {line} $$\n\n$$ v_0 = 0 $$\n\n$$ H = \\frac{{v_0^2}}{{2g}} $$\n"))[0].clone()
    };
    assert_eq!(first("wrong-zero", "t_1 = v_0 \\cdot g"), "wrong");
    assert_ne!(first("wrong-near", "H \\approx \\frac{v_0^2}{20}"), "right");
    assert_eq!(first("right-zero", "t_1 = \\frac{v_0}{g}"), "right");
}
