//! `onshell mutate`: whether a document would notice the slips of its author.

use serde_json::{Value, json};

use crate::support::{Desk, Run};

/// An identity, with room for many slips, none of which is true.
const SQUARE: &str = "$$\n(x + a)^2 = x^2 + 2 a x + a^2\n\\tag{1}\n$$\n";

/// A square is not negative, nor is a cube of what is positive.
const NOT_NEGATIVE: &str = "# Squares\n\n$$\nx^2 \\geq 0\n\\tag{2}\n$$\n";

/// A folder with these notes, and claims about its equations, of which x and a may be any numbers.
fn desk(name: &str, notes: &str, equations: Value) -> Desk {
    with_range(name, notes, "any", equations)
}

/// The same, with a range for x.
fn with_range(name: &str, notes: &str, range: &str, equations: Value) -> Desk {
    let desk = Desk::new(name);
    desk.write("notes.md", notes);
    let constants = json!({ "x": range, "a": "any" });
    desk.write(
        "notes.json",
        json!({ "notes": "notes.md", "constants": constants, "equations": equations }).to_string(),
    );
    desk
}

fn mutate(desk: &Desk, arguments: &[&str]) -> Run {
    desk.onshell(&[&["mutate", "notes.json"], arguments].concat())
}

fn report(desk: &Desk) -> Value {
    mutate(desk, &["--format", "json"]).json()
}

/// The mutants of each equation.
fn equations(report: &Value) -> Vec<Value> {
    let documents = report["documents"].as_array().expect("documents is a list").iter();
    documents.flat_map(|document| document["equations"].as_array().expect("equations is a list").clone()).collect()
}

/// The slips that survived, each as the text that stands in the place of another.
fn survivors(report: &Value) -> Vec<(String, String)> {
    let word = |value: &Value| value.as_str().expect("a text").to_owned();
    let all =
        equations(report).into_iter().flat_map(|e| e["survivors"].as_array().expect("survivors is a list").clone());
    all.map(|slip| (word(&slip["original"]), word(&slip["replacement"]))).collect()
}

fn number(value: &Value) -> u64 {
    value.as_u64().unwrap_or_else(|| panic!("{value} is no whole number"))
}

/// Whether a report adds up: each equation in itself, and all of them to the summary.
fn adds_up(report: &Value) -> Result<(), String> {
    let mut sums = [0; 5];
    for equation in equations(report) {
        let survived = equation["survivors"].as_array().ok_or("survivors is a list")?.len() as u64;
        let [mutants, refuted, refused, equivalent] =
            ["mutants", "refuted", "refused", "equivalent"].map(|fate| number(&equation[fate]));
        if mutants != refuted + refused + equivalent + survived {
            return Err(format!("({}) does not add up: {equation:#}", equation["id"]));
        }
        if !equation["left_out"].is_null() && mutants > 0 {
            return Err(format!("({}) is left out and has mutants: {equation:#}", equation["id"]));
        }
        for (sum, count) in sums.iter_mut().zip([mutants, refuted, refused, equivalent, survived]) {
            *sum += count;
        }
    }
    for (key, sum) in ["mutants", "refuted", "refused", "equivalent", "survivors"].into_iter().zip(sums) {
        if number(&report["summary"][key]) != sum {
            return Err(format!("{key} is {sum} in the equations: {:#}", report["summary"]));
        }
    }
    Ok(())
}

#[test]
fn of_an_identity_no_slip_survives() {
    let desk = desk("mutate-identity", SQUARE, json!({}));
    let run = mutate(&desk, &["-v"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(run.out.contains("✓ 1 ") && !run.out.contains("survived at"), "{}", run.out);
    // Not for want of slips: nine terms and factors, each with a few.
    let summary = report(&desk)["summary"].clone();
    assert!(number(&summary["refuted"]) > 20, "{summary:#}");
    assert_eq!(summary["survivors"], 0);
}

#[test]
fn a_range_that_hides_a_slip_is_told_by_the_slip_at_its_place() {
    // Where x is positive, its cube is not negative either.
    let narrow = with_range("mutate-range", NOT_NEGATIVE, "> 0", json!({}));
    let run = mutate(&narrow, &["-v"]);
    assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    let cube = "(2) survived at notes.md:4:3: “3” in place of “2”".to_owned();
    assert!(run.out.contains("✗ 2 ") && run.out.contains(&cube), "{}", run.out);
    let report_of = |desk: &Desk| survivors(&report(desk));
    let slip = ("2".to_owned(), "3".to_owned());
    assert!(report_of(&narrow).contains(&slip));
    // The twin: of any number it is refuted.
    let any = with_range("mutate-any", NOT_NEGATIVE, "any", json!({}));
    assert!(!report_of(&any).contains(&slip) && !mutate(&any, &[]).out.contains(&cube));
}

#[test]
fn so_is_a_hypothesis() {
    let cube = ("2".to_owned(), "3".to_owned());
    for (hypotheses, hidden) in [(json!(["x > 0"]), true), (json!(["x > -1"]), false)] {
        let desk = desk("mutate-hypothesis", NOT_NEGATIVE, json!({ "2": { "assume": hypotheses } }));
        assert_eq!(survivors(&report(&desk)).contains(&cube), hidden, "{hypotheses}");
    }
}

#[test]
fn a_right_side_that_a_hypothesis_alone_makes_true_is_not_equivalent() {
    let size = "$$\n|a| = |a x^2|\n\\tag{1}\n$$\n";
    let desk_at_one = desk("mutate-right-side", size, json!({ "1": { "assume": ["x = 1"] } }));
    assert!(survivors(&report(&desk_at_one)).contains(&("2".to_owned(), "3".to_owned())));
    // The twin: where nothing is assumed, no slip is true but |-a|, which is the same.
    let product = "$$\n|a| x^2 = |a x^2|\n\\tag{1}\n$$\n";
    assert_eq!(survivors(&report(&desk("mutate-right-side-twin", product, json!({})))), Vec::new());
}

#[test]
fn every_survivor_of_the_report_is_named_in_the_text_at_its_line_and_column() {
    let desk = with_range("mutate-named", &format!("{SQUARE}\n{NOT_NEGATIVE}"), "> 0", json!({}));
    let (report, run) = (report(&desk), mutate(&desk, &[]));
    let mut named = 0;
    for equation in equations(&report) {
        for slip in equation["survivors"].as_array().unwrap() {
            let place = format!(
                "({}) survived at notes.md:{}:{}: ",
                equation["id"].as_str().unwrap(),
                slip["line"],
                slip["column"]
            );
            let new = slip["replacement"].as_str().unwrap().trim();
            let line = run
                .out
                .lines()
                .find(|line| line.contains(&place) && (line.contains(&format!("“{new}”")) || new.is_empty()));
            assert!(
                line.is_some_and(|line| line.contains(slip["slip"].as_str().unwrap())),
                "{slip:#} in:\n{}",
                run.out
            );
            // Its bytes are those of the notes.
            let (start, end) = (number(&slip["start"]) as usize, number(&slip["end"]) as usize);
            assert_eq!(desk.read("notes.md").get(start..end), slip["original"].as_str(), "{slip:#}");
            named += 1;
        }
    }
    assert!(named > 0);
    assert_eq!(run.out.matches("survived at").count(), named, "{}", run.out);
}

#[test]
fn the_integers_of_the_report_add_up() {
    let both = format!("{SQUARE}\n{NOT_NEGATIVE}");
    let desk = with_range("mutate-sums", &both, "> 0", json!({}));
    let sound = report(&desk);
    assert_eq!(sound["schema"], 1);
    assert_eq!(equations(&sound).len(), 2);
    assert_eq!(adds_up(&sound), Ok(()));
    // The twin: one mutant more, anywhere, is noticed.
    for key in ["mutants", "refuted", "refused", "equivalent", "survivors"] {
        let mut wrong = sound.clone();
        wrong["summary"][key] = json!(number(&wrong["summary"][key]) + 1);
        assert!(adds_up(&wrong).is_err(), "{key}");
    }
    let mut wrong = sound.clone();
    let refuted = &mut wrong["documents"][0]["equations"][0]["refuted"];
    *refuted = json!(number(refuted) + 1);
    assert!(adds_up(&wrong).is_err());
}

#[test]
fn only_mutates_the_one_equation() {
    let desk = with_range("mutate-only", &format!("{SQUARE}\n{NOT_NEGATIVE}"), "> 0", json!({}));
    let all = report(&desk);
    for (at, id, code) in [(0, "1", 0), (1, "2", 1)] {
        let run = mutate(&desk, &["--only", id, "--format", "json"]);
        assert_eq!(run.code, code, "{}", run.out);
        assert_eq!(equations(&run.json()), [equations(&all)[at].clone()]);
        assert_eq!(adds_up(&run.json()), Ok(()));
    }
    let absent = mutate(&desk, &["--only", "3"]);
    assert_eq!(absent.code, 2, "{}{}", absent.out, absent.err);
}

#[test]
fn where_there_is_nothing_to_mutate_the_exit_code_is_2() {
    let nothing = Desk::new("mutate-nothing");
    for (path, wanted) in [("absent.json", "absent.json"), ("absent.md", "absent.md"), (".", "nothing")] {
        let run = nothing.onshell(&["mutate", path]);
        assert_eq!(run.code, 2, "{path}: {}{}", run.out, run.err);
        assert!(run.err.contains(wanted), "{path}: {}", run.err);
    }
    nothing.write("alone.md", SQUARE);
    let run = nothing.onshell(&["mutate", "."]);
    assert_eq!(run.code, 2, "{}{}", run.out, run.err);
    assert!(run.err.contains("alone.md has no claims file, so nothing in it can be mutated"), "{}", run.err);
    nothing.write("alone.json", "{ \"notes\": \"alone.md\", \"constants\": {} }");
    // The names are not declared: the equation does not pass, so none of its slips is made.
    let run = nothing.onshell(&["mutate", "alone.json"]);
    assert_eq!(run.code, 2, "{}{}", run.out, run.err);
    assert_eq!(nothing.onshell(&["mutate"]).code, 2);
    // The twin.
    nothing.write("alone.json", "{ \"notes\": \"alone.md\", \"constants\": { \"x, a\": \"any\" } }");
    assert_eq!(nothing.onshell(&["mutate", "."]).code, 0);
}

#[test]
fn what_is_expected_not_to_pass_is_left_out_and_so_is_what_does_not() {
    let wrong = "$$\n(x + a)^2 = x^2 + a^2\n\\tag{3}\n$$\n";
    let notes = format!("{SQUARE}\n{wrong}");
    let expected = json!({ "3": { "expect": "refuted", "because": "the mixed term is lost" } });
    for (equations, why) in [
        (expected, "the claims file expects the equation not to pass"),
        (json!({}), "the equation does not pass: it is refuted"),
    ] {
        let desk = desk("mutate-left-out", &notes, equations);
        let run = mutate(&desk, &["-v"]);
        assert_eq!(run.code, 0, "{}{}", run.out, run.err);
        assert!(run.out.contains(&format!("· 3  left out: {why}")), "{}", run.out);
        let brief = mutate(&desk, &[]);
        assert!(brief.out.contains("; 1 equation was left out: 1 "), "{}", brief.out);
        let found = self::equations(&report(&desk));
        assert_eq!((&found[1]["left_out"], &found[1]["mutants"]), (&json!(why), &json!(0)));
        // The twin: the sound one is not.
        assert!(found[0]["left_out"].is_null() && number(&found[0]["mutants"]) > 0);
    }
}

#[test]
fn a_document_with_an_erratum_is_mutated_as_corrected() {
    let printed = "$$\n(x + a)^2 = x^2 - 2 a x + a^2\n\\tag{1}\n$$\n";
    let erratum = json!({ "1": { "erratum": { "for": "- 2", "read": "+ 2" } } });
    let mended = desk("mutate-erratum", printed, erratum);
    assert_eq!(mended.onshell(&["check", "notes.json"]).code, 0);
    let run = mutate(&mended, &["--format", "json"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    // As if it had been printed so.
    let sound = desk("mutate-corrected", SQUARE, json!({}));
    assert_eq!(equations(&run.json()), equations(&report(&sound)));
    // The twin: without the erratum there is nothing sound to mutate.
    let wrong = desk("mutate-no-erratum", printed, json!({}));
    assert_eq!(mutate(&wrong, &[]).code, 2);
    // An erratum that is not in the notes is an error at its place.
    let lost = desk("mutate-lost-erratum", SQUARE, json!({ "1": { "erratum": { "for": "- 2", "read": "+ 2" } } }));
    let run = mutate(&lost, &[]);
    assert_eq!(run.code, 2, "{}", run.out);
    assert!(run.err.contains("notes.json:"), "{}", run.err);
}

#[test]
fn the_report_is_the_same_on_one_thread_and_on_two() {
    let desk = with_range("mutate-threads", &format!("{SQUARE}\n{NOT_NEGATIVE}"), "> 0", json!({}));
    for format in ["text", "json"] {
        let run = |threads| desk.onshell_on(Some(threads), &["mutate", "notes.json", "--format", format]);
        let (one, two) = (run(1), run(2));
        assert_eq!((one.code, &one.out, &one.err), (two.code, &two.out, &two.err));
        assert_eq!(one.code, 1);
    }
}

#[test]
fn how_many_slips_are_mended_is_told_in_figures_that_add_up() {
    let desk = desk("mutate-repair", SQUARE, json!({}));
    let run = mutate(&desk, &["--repair", "--format", "json"]);
    let found = run.json();
    let noticed = number(&found["summary"]["refuted"]) + number(&found["summary"]["refused"]);
    let (all, own) = (&found["summary"]["repairs"], &equations(&found)[0]["repairs"]);
    let figures = |of: &Value| ["noticed", "first", "offered"].map(|key| number(&of[key]));
    let [tried, first, offered] = figures(all);
    assert_eq!((tried, figures(own)), (noticed, [tried, first, offered]), "{all:#}");
    assert!(0 < first && first <= offered && offered <= tried, "{all:#}");
    let missed = own["missed"].as_array().expect("missed is a list").len() as u64;
    assert_eq!(missed, tried - offered);
    // The twin: what was not asked for has no figures.
    let unasked = report(&desk);
    assert!(unasked["summary"]["repairs"].is_null() && equations(&unasked)[0]["repairs"].is_null());
}
