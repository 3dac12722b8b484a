//! `onshell mark`, where words or the form of a line say that it is a condition, a trial or a step on the way, and where a step follows from
//! a wrong line. Beside each stands one that is wrong.

use crate::mark_problems::{BEAD, CHAIN, CLIFF, CYLINDER, DAMPED};
use crate::support::{Desk, marks};

#[test]
fn words_of_rest_make_a_line_about_the_coordinate_one_about_its_place() {
    let of = |name: &str, words: &str, value: &str| {
        marks(name, BEAD, &format!("{words} $\\cos\\theta = \\frac{{{value}}}{{R\\omega^2}}$.\n"))
    };
    assert_eq!(of("rest", "Equilibrium at", "g"), ["right"]);
    assert_eq!(of("or", "Equilibrium needs $\\sin\\theta = 0$ or", "g").last().unwrap(), "right");
    assert_ne!(of("rest-wrong", "Equilibrium at", "2g"), ["right"]);
    // The twin: no word says it.
    assert_ne!(of("silent", "So", "g"), ["right"]);
}

#[test]
fn a_chain_may_end_with_a_condition() {
    let of = |name: &str, sign: &str| {
        marks(name, CLIFF, &format!("$$ y = h {sign} v_0 t\\sin\\alpha - \\frac12 g t^2 = 0 $$\n"))
    };
    assert_eq!(of("ground", "+"), ["right"]);
    assert_eq!(of("ground-wrong", "-"), ["wrong"]);
    // The twin: a rate that is not 0.
    let energy = "$$ \\dot E = m\\dot x\\ddot x + k x\\dot x = 0 $$\n";
    assert_eq!(marks("rate", DAMPED, energy), ["wrong"]);
}

#[test]
fn a_trial_may_have_constants_of_the_problem() {
    let of = |name: &str, words: &str| marks(name, CHAIN, &format!("{words} $x_1 = A_1\\cos\\omega t$.\n"));
    assert_eq!(of("try", "Try"), ["given"]);
    // The twin: a statement.
    assert_eq!(of("state", "So"), ["wrong"]);
}

#[test]
fn an_equation_for_amplitudes_is_no_secular_equation() {
    let points = |name: &str, line: &str| {
        let desk = Desk::new(&format!("mark-amplitudes-{name}"));
        desk.write("p.md", CHAIN.0);
        desk.write("p.json", CHAIN.1);
        desk.write("one.md", format!("$$ {line} $$\n"));
        let report = desk.onshell(&["mark", "one.md", "--claims", "p.json", "--format", "json"]).json();
        report["students"][0]["credit"].as_f64().unwrap()
    };
    assert_eq!(points("amplitudes", "(2k - m\\omega^2)A_1 = kA_2"), 0.0);
    // The twin: the secular equation in another form.
    assert_eq!(points("secular", "(2k - m\\omega^2)(k - m\\omega^2) = k^2"), 0.5);
}

#[test]
fn a_whole_solution_is_no_factor_that_was_lost() {
    let points = |name: &str, line: &str| {
        let desk = Desk::new(&format!("mark-factor-{name}"));
        desk.write("p.md", DAMPED.0);
        desk.write("p.json", DAMPED.1);
        desk.write("one.md", format!("$$ {line} $$\n"));
        let report = desk.onshell(&["mark", "one.md", "--claims", "p.json", "--format", "json"]).json();
        report["students"][0]["credit"].as_f64().unwrap()
    };
    assert_eq!(points("five", "x = 5"), 0.0);
    // The twin: a number was lost.
    let line = "x = 2x_0 e^{-\\gamma t}\\left(\\cos\\omega t + \\frac\\gamma\\omega\\sin\\omega t\\right)";
    assert_eq!(points("twice", line), 1.0);
}

#[test]
fn a_wrong_definition_is_carried_through_the_laws_and_to_numbers() {
    let of = |name: &str, lines: &[&str]| {
        let text: Vec<String> = lines.iter().map(|line| format!("$$ {line} $$\n")).collect();
        marks(name, CYLINDER, &text.join("\n"))
    };
    assert_eq!(of("laws", &["I = m R^2", "a = \\frac12 g\\sin\\alpha"]), ["wrong", "carried"]);
    assert_eq!(of("laws-wrong", &["I = m R^2", "a = \\frac13 g\\sin\\alpha"]), ["wrong", "wrong"]);
    let number = |value: &str| format!("a = \\frac23 g\\cos\\alpha = {value}\\,\\text{{m/s}}^2");
    let law = "\\frac32 m a = m g\\cos\\alpha";
    assert_eq!(of("number", &[law, &number("5.66")]), ["wrong", "carried"]);
    assert_eq!(of("number-wrong", &[law, &number("6.56")]), ["wrong", "wrong"]);
    let first = "a = \\frac12 g\\sin\\alpha = 2.45\\,\\text{m/s}^2";
    let force = |value: &str| format!("F = mg\\sin\\alpha - ma = {value}\\,\\text{{N}}");
    assert_eq!(of("force", &[first, &force("4.9")]), ["wrong", "carried"]);
    assert_eq!(of("force-wrong", &[first, &force("5.9")]), ["wrong", "wrong"]);
}

#[test]
fn the_roots_of_a_wrong_equation_are_carried() {
    let of = |name: &str, number: &str| {
        let lines = format!(
            "$$ m^2\\omega^4 - k m\\omega^2 - k^2 = 0 $$\n\n$$ \\omega^2 = \\frac{{1\\pm\\sqrt{number}}}{{2}}\\frac km $$\n"
        );
        marks(name, CHAIN, &lines)
    };
    assert_eq!(of("roots", "5"), ["wrong", "carried"]);
    assert_eq!(of("roots-wrong", "3"), ["wrong", "wrong"]);
}

#[test]
fn what_is_not_marked_is_named() {
    let desk = Desk::new("mark-passed-over");
    desk.write("p.md", CLIFF.0);
    desk.write("p.json", CLIFF.1);
    desk.write("class/anna.md", "$$ v_1 = \\sqrt{v_0^2 + 2 g h} $$\n");
    desk.write("class/ben.docx", "no text");
    desk.write("class/group/cleo.md", "$$ v_1 = \\sqrt{v_0^2 + 2 g h} $$\n");
    desk.write("class/dora.txt", "v1 = sqrt(v0^2 + 2*g*h)\n");
    let run = desk.onshell(&["mark", "class", "--claims", "p.json", "--format", "csv"]);
    assert!(run.err.contains("ben.docx is not .md, .tex or .txt; group is a folder"), "{}", run.err);
    let row = run.out.lines().find(|row| row.starts_with("dora,") && row.contains("not read"));
    assert!(row.is_some_and(|row| row.contains("no formula was found")), "{}", run.out);
    // The twins: a folder of hand-ins, and a file with formulas.
    let run = desk.onshell(&["mark", "class/anna.md", "--claims", "p.json", "--format", "csv"]);
    assert!(!run.err.contains("not marked") && !run.out.contains("not read"), "{}\n{}", run.err, run.out);
}
