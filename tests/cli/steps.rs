//! Derivations and chains as the program tells of them: the place of the slip, and of nothing else.

use serde_json::{Value, json};

use crate::support::Desk;

/// A pendulum whose potential energy has the wrong sign, in a derivation that carries it on.
const NOTES: &str = "\
$$ U = m g l \\cos\\theta \\tag{1} $$

$$ m l^2 \\ddot\\theta = m g l \\sin\\theta \\tag{2} $$

$$ \\ddot\\theta = \\frac{g}{l} \\sin\\theta \\tag{3} $$

$$ T = \\frac12 m l^2 \\dot\\theta^2 \\tag{4} $$
";

/// A folder with these notes and claims about them, `steps` among them.
fn desk(name: &str, steps: &Value) -> Desk {
    let desk = Desk::new(name);
    desk.write("notes.md", NOTES);
    let claims = json!({
        "notes": "notes.md",
        "system": "simple_pendulum",
        "coordinates": { "\\theta": "angle" },
        "constants": { "m, l, g": "> 0" },
        "means": { "T": "kinetic energy", "U": "potential energy" },
        "steps": steps,
    });
    desk.write("notes.json", claims.to_string());
    desk
}

#[test]
fn one_slip_is_one_error_and_the_others_say_where_it_is() {
    let run = desk("steps-text", &json!("1..4")).onshell(&["check", "notes.md"]);
    assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    for wanted in [
        "error[sides-differ]: (1) is refuted",
        "✗ 2  refuted     this step is correct, but it builds on the mistake in (1); fix (1)",
        "✗ 3  refuted     this step is correct, but it builds on (2), which builds on the mistake in (1); fix (1)",
        "3 are not as expected, 2 because of a mistake in another",
    ] {
        assert!(run.out.contains(wanted), "no “{wanted}” in:\n{}", run.out);
    }
    assert_eq!(run.out.matches("error[sides-differ]: ").count(), 1, "{}", run.out);
    // The twin: without the key each has its own.
    let alone = desk("steps-none", &json!(["1, 4"])).onshell(&["check", "notes.md"]);
    assert_eq!((alone.code, alone.out.matches("error[sides-differ]: ").count()), (1, 3), "{}", alone.out);
}

#[test]
fn machines_are_told_from_which_equation() {
    let run = desk("steps-json", &json!(["1..4"])).onshell(&["check", "notes.md", "--format", "json"]);
    let equations = run.json()["documents"][0]["equations"].clone();
    assert_eq!(equations[2]["follows_from"], json!({ "equation": "2", "root": "1" }));
    for (key, value) in [("verdict", json!("refuted")), ("ok", json!(false)), ("repairs", json!([]))] {
        assert_eq!(equations[2][key], value, "{key}");
    }
    assert!(equations[2]["counterexample"].is_null() && equations[0]["counterexample"].is_object());
    assert_eq!((equations[0].get("follows_from"), equations[3].get("follows_from")), (None, None));
    assert_eq!(run.json()["summary"]["unexpected"], 3);
}

#[test]
fn a_derivation_that_is_none_is_refused_at_its_place() {
    for (steps, wanted) in [
        (json!("1"), "a derivation needs at least two displays"),
        (json!("1, 2, 1"), "(1) occurs twice in this derivation"),
        (json!("1, 2 part 1"), "a step of a derivation must be a whole display"),
        (json!("1..7"), "no equation (7)"),
        (json!([["1", "2"]]), "\"steps\" must be a string, not a list"),
        (json!([]), "\"steps\" is an empty list"),
    ] {
        let run = desk("steps-refused", &steps).onshell(&["check", "notes.md"]);
        assert_eq!(run.code, 2, "{steps}: {}", run.out);
        assert!(run.err.contains(wanted) && run.err.contains("notes.json:"), "{steps}: {}", run.err);
    }
}

#[test]
fn a_step_of_a_chain_is_offered_and_left_to_the_author() {
    let desk = Desk::new("chain-carried");
    let chain = "$$ (a+b)^2 = a^2 + 2ab - b^2 = a^2 + b(2a - b) \\tag{1} $$\n";
    desk.write("notes.md", chain);
    desk.write("notes.json", json!({ "notes": "notes.md", "constants": { "a, b": "> 0" } }).to_string());
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (1, chain.to_owned()));
    for wanted in [
        "the rest of the chain follows from this mistake",
        "Then this step passes, but a later step of the chain still fails",
    ] {
        assert!(run.out.contains(wanted), "no “{wanted}” in:\n{}", run.out);
    }
    let found = desk.onshell(&["check", "notes.md", "--format", "json"]).json();
    let equation = &found["documents"][0]["equations"][0];
    assert_eq!((&equation["carried"], &equation["repairs"][0]["step"]), (&json!(1), &json!(true)));
    // The twin: what is carried on no further is mended.
    desk.write("notes.md", "$$ (a+b)^2 = a^2 + 2ab - b^2 = a(a + 2b) + b^2 \\tag{1} $$\n");
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!(desk.read("notes.md").contains("a^2 + 2ab + b^2 ="), "{}", desk.read("notes.md"));
}

#[test]
fn what_two_wrong_equations_stand_on_is_mended_and_not_they() {
    let desk = Desk::new("fix-shared");
    let notes = |law: &str, slip: &str| {
        format!(
            "$$ m \\dot v = {law} F \\tag{{1}} $$\n\n$$ \\frac{{d}}{{dt}} (m v^2) = \\dot m (v^2 - 2 u v) + 2 F v \\tag{{2}} $$\n\n\
             $$ \\frac{{d}}{{dt}} (v + u \\ln m) = \\frac{{F}}{{m}} \\tag{{3}} $$\n\n$$ \\frac{{d}}{{dt}} (m v) = \\dot m (v {slip} u) + F \\tag{{4}} $$\n"
        )
    };
    let claims = json!({
        "notes": "notes.md",
        "varies with time": { "m": "> 0", "v, F": "any" },
        "constants": { "u": "> 0" },
        "laws": { "the rocket": "1" },
    });
    desk.write("notes.json", claims.to_string());
    desk.write("notes.md", notes(r"\dot m u +", "-"));
    let run = desk.onshell(&["check", "notes.md"]);
    assert!(run.out.contains("With this edit of (1), (2), (3) and (4) hold"), "{}", run.out);
    assert!(run.out.contains("the edit of (1) that is shown for (2) corrects this too"), "{}", run.out);
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert_eq!(desk.read("notes.md"), notes(r"-\dot m u +", "-"));
    // The twin: one that holds speaks for the law.
    desk.write("notes.md", notes(r"\dot m u +", "+"));
    let run = desk.onshell(&["check", "notes.md"]);
    assert!(run.code == 1 && !run.out.contains("With this edit of (1)"), "{}", run.out);
}

#[test]
fn what_nothing_vouches_for_is_left_to_the_author() {
    let desk = Desk::new("fix-vouched");
    let notes = |sign: &str, more: &str| {
        format!(
            "$$ m \\ddot x = -k x \\tag{{1}} $$\n\n$$ E = \\frac12 m \\dot x^2 {sign} \\frac12 k x^2 \\tag{{2}} $$\n\n{more}"
        )
    };
    let claims = json!({
        "notes": "notes.md",
        "varies with time": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "laws": { "Hooke's law": "1" },
        "equations": { "2": { "conserved": true } },
    });
    desk.write("notes.json", claims.to_string());
    desk.write("notes.md", notes("-", ""));
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (1, notes("-", "")), "the law may be wrong as well: {}", run.out);
    assert!(run.out.contains("no passing equation uses (1), so the mistake may be in (1)"), "{}", run.out);
    // The twin: where another equation holds by the law, it is vouched for.
    let period = "$$ \\ddot x = -\\frac{k}{m} x \\tag{3} $$\n";
    desk.write("notes.md", notes("-", period));
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (0, notes("+", period)), "{}", run.out);
}

#[test]
fn a_change_of_what_stands_there_is_made_though_its_text_is_new() {
    let desk = Desk::new("fix-new-text");
    desk.write("notes.json", json!({ "notes": "notes.md", "constants": { "a, b": "> 0" } }).to_string());
    let notes = |right: &str| format!("$$ \\frac{{1}}{{a}} - \\frac{{1}}{{b}} = {right} \\tag{{1}} $$\n");
    desk.write("notes.md", notes("\\frac{ab}{b - a}"));
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (0, notes("\\frac{b - a}{ab}")), "{}{}", run.out, run.err);
}

#[test]
fn what_is_left_to_the_author_holds_nothing_else_back() {
    let desk = Desk::new("fix-beside");
    desk.write("notes.json", json!({ "notes": "notes.md", "constants": { "a, b": "> 0" } }).to_string());
    let notes = |right: &str| {
        format!(
            "$$ s = (a - b)(a + 2b) \\tag{{1}} $$\n\n$$ s^2 = a^4 - 2 a^2 b^2 + b^4 \\tag{{2}} $$\n\n\
             $$ \\frac{{1}}{{a}} - \\frac{{1}}{{b}} = {right} \\tag{{3}} $$\n"
        )
    };
    desk.write("notes.md", notes("\\frac{ab}{b - a}"));
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (1, notes("\\frac{b - a}{ab}")), "{}{}", run.out, run.err);
    assert!(
        run.err.contains("(2) was not edited: no passing equation uses (1), so the mistake may be in (1)"),
        "{}",
        run.err
    );
}

#[test]
fn an_equation_is_not_made_to_agree_with_a_definition_that_nothing_pins() {
    let desk = Desk::new("fix-loose");
    let claims = json!({
        "notes": "notes.md",
        "constants": { r"\Omega": "> 0", r"\lambda": r"(0, \pi)" },
        "varies with time": { "x, y": "any" },
        "laws": { "Foucault": "2" },
    });
    let notes = |definition: &str, period: &str, more: &str| {
        format!(
            "$$ W = \\Omega {definition}\\lambda \\tag{{1}} $$\n\n$$ \\ddot x = 2 W \\dot y , \\quad \\ddot y = -2 W \\dot x \\tag{{2}} $$\n\n\
             $$ \\frac{{d}}{{dt}} (\\dot x + \\dot y) = 2 W (\\dot y - \\dot x) \\tag{{3}} $$\n\n\
             $$ P = \\frac{{2\\pi}}{{W}} = \\frac{{2\\pi}}{{\\Omega{period}\\lambda}} \\tag{{4}} $$\n\n{more}"
        )
    };
    desk.write("notes.json", claims.to_string());
    // (3) holds by the law whatever W is: it does not speak for the sine.
    desk.write("notes.md", notes(r"\sin", r"\cos", ""));
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (1, notes(r"\sin", r"\cos", "")), "{}", run.out);
    assert!(
        run.err.contains("(4) was not edited: no passing equation uses (1), so the mistake may be in (1)"),
        "{}",
        run.err
    );
    // The twin: another equation does.
    let pinned = "$$ W^2 = \\Omega^2 (1 - \\cos^2\\lambda) \\tag{5} $$\n";
    desk.write("notes.md", notes(r"\sin", r"\cos", pinned));
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (0, notes(r"\sin", r"\sin", pinned)), "{}", run.out);
}

#[test]
fn nothing_is_chosen_between_two_displays_that_could_be_wrong_and_nothing_is_multiplied_by_zero() {
    let desk = Desk::new("fix-two-displays");
    let claims = json!({
        "notes": "notes.md",
        "indices": { "i": "1..n" },
        "constants": { "m_i": "> 0" },
        "varies with time": { r"\vec r_i": "any" },
    });
    let notes = |mean: &str| {
        format!(
            "$$ \\vec R = \\frac{{1}}{{M}} \\sum_i {mean}\\vec r_i , \\quad M = \\sum_i m_i \\tag{{1}} $$\n\n\
             $$ \\vec s_i = \\vec r_i - \\vec R \\tag{{2}} $$\n\n\
             $$ \\sum_i m_i \\vec r_i \\times \\dot{{\\vec r}}_i = M \\vec R \\times \\dot{{\\vec R}} + \\sum_i m_i \\vec s_i \\times \\dot{{\\vec s}}_i \\tag{{3}} $$\n\n\
             $$ \\frac12 \\sum_i m_i \\dot{{\\vec r}}_i^2 = \\frac12 M \\dot{{\\vec R}}^2 + \\frac12 \\sum_i m_i \\dot{{\\vec s}}_i^2 \\tag{{4}} $$\n"
        )
    };
    desk.write("notes.json", claims.to_string());
    desk.write("notes.md", notes(""));
    let run = desk.onshell(&["check", "notes.md"]);
    assert!(
        run.out.contains(r"did you mean to multiply by “m_i”? With this edit of (1), (3) and (4) hold"),
        "{}",
        run.out
    );
    assert!(!run.out.contains("“0” in place of “1”"), "{}", run.out);
    // The twin: as it should be it stays as it is.
    desk.write("notes.md", notes("m_i "));
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md")), (0, notes("m_i ")), "{}", run.out);
}
