//! The command line, run as a user runs it: its JSON, its exit codes, what it says when something is wrong.
//!
//! Every test works in a folder of its own; `support` copies the documents there and may change one place in them.

#[path = "cli/support.rs"]
mod support;

#[path = "cli/bad_input.rs"]
mod bad_input;
#[path = "cli/chapters.rs"]
mod chapters;
#[path = "cli/contract.rs"]
mod contract;
#[path = "cli/damage.rs"]
mod damage;
#[path = "cli/derive.rs"]
mod derive;
#[path = "cli/explain.rs"]
mod explain;
#[path = "cli/followed_advice.rs"]
mod followed_advice;
#[path = "cli/formats.rs"]
mod formats;
#[path = "cli/formulas.rs"]
mod formulas;
#[path = "cli/init.rs"]
mod init;
#[path = "cli/mark.rs"]
mod mark;
#[path = "cli/mark_cases.rs"]
mod mark_cases;
#[path = "cli/mark_classes.rs"]
mod mark_classes;
#[path = "cli/mark_conditions.rs"]
mod mark_conditions;
#[path = "cli/mark_credit.rs"]
mod mark_credit;
#[path = "cli/mark_extrema.rs"]
mod mark_extrema;
#[path = "cli/mark_foreign_letters.rs"]
mod mark_foreign_letters;
#[path = "cli/mark_later_values.rs"]
mod mark_later_values;
#[path = "cli/mark_letters.rs"]
mod mark_letters;
#[path = "cli/mark_meanings.rs"]
mod mark_meanings;
#[path = "cli/mark_motion.rs"]
mod mark_motion;
#[path = "cli/mark_numbers.rs"]
mod mark_numbers;
#[path = "cli/mark_oscillations.rs"]
mod mark_oscillations;
#[path = "cli/mark_own_letters.rs"]
mod mark_own_letters;
#[path = "cli/mark_problems.rs"]
mod mark_problems;
#[path = "cli/mark_rounding.rs"]
mod mark_rounding;
#[path = "cli/mark_starts.rs"]
mod mark_starts;
#[path = "cli/mark_states.rs"]
mod mark_states;
#[path = "cli/mark_steps.rs"]
mod mark_steps;
#[path = "cli/mark_trials.rs"]
mod mark_trials;
#[path = "cli/messages.rs"]
mod messages;
#[path = "cli/mutate.rs"]
mod mutate;
#[path = "cli/printed/constraints.rs"]
mod printed_constraints;
#[path = "cli/printed/lagrangian.rs"]
mod printed_lagrangian;
#[path = "cli/printed/motions.rs"]
mod printed_motions;
#[path = "cli/printed/prose.rs"]
mod printed_prose;
#[path = "cli/printed/textbooks.rs"]
mod printed_textbooks;
#[path = "cli/reasons.rs"]
mod reasons;
#[path = "cli/report.rs"]
mod report;
#[path = "cli/reprint.rs"]
mod reprint;
#[path = "cli/requests.rs"]
mod requests;
#[path = "cli/schema.rs"]
mod schema;
#[path = "cli/steps.rs"]
mod steps;
#[path = "cli/strangers.rs"]
mod strangers;
#[path = "cli/true_messages.rs"]
mod true_messages;
#[path = "cli/typst.rs"]
mod typst;
#[path = "cli/unaided.rs"]
mod unaided;
#[path = "cli/unaided_cases.rs"]
mod unaided_cases;
#[path = "cli/unaided_causes.rs"]
mod unaided_causes;
#[path = "cli/unaided_chains.rs"]
mod unaided_chains;
#[path = "cli/unaided_chapters.rs"]
mod unaided_chapters;
#[path = "cli/unaided_conclusions.rs"]
mod unaided_conclusions;
#[path = "cli/unaided_contradictions.rs"]
mod unaided_contradictions;
#[path = "cli/unaided_differentials.rs"]
mod unaided_differentials;
#[path = "cli/unaided_doubts.rs"]
mod unaided_doubts;
#[path = "cli/unaided_energies.rs"]
mod unaided_energies;
#[path = "cli/unaided_formulas.rs"]
mod unaided_formulas;
#[path = "cli/unaided_lagrangians.rs"]
mod unaided_lagrangians;
#[path = "cli/unaided_letters.rs"]
mod unaided_letters;
#[path = "cli/unaided_meanings.rs"]
mod unaided_meanings;
#[path = "cli/unaided_ordered.rs"]
mod unaided_ordered;
#[path = "cli/unaided_periods.rs"]
mod unaided_periods;
#[path = "cli/unaided_places.rs"]
mod unaided_places;
#[path = "cli/unaided_premises.rs"]
mod unaided_premises;
#[path = "cli/unaided_readings.rs"]
mod unaided_readings;
#[path = "cli/unaided_rejected.rs"]
mod unaided_rejected;
#[path = "cli/unaided_restated.rs"]
mod unaided_restated;
#[path = "cli/unaided_rows.rs"]
mod unaided_rows;
#[path = "cli/unaided_sentences.rs"]
mod unaided_sentences;
#[path = "cli/unaided_series.rs"]
mod unaided_series;
#[path = "cli/unaided_solutions.rs"]
mod unaided_solutions;
#[path = "cli/unaided_special_cases.rs"]
mod unaided_special_cases;
#[path = "cli/unaided_states.rs"]
mod unaided_states;
#[path = "cli/unaided_told.rs"]
mod unaided_told;
#[path = "cli/watch.rs"]
mod watch;
#[path = "cli/widths.rs"]
mod widths;
#[path = "cli/wording.rs"]
mod wording;
#[path = "cli/writing.rs"]
mod writing;

use support::{Desk, SIGN};

#[test]
fn the_derivations_as_they_stand_are_all_as_expected() {
    let desk = Desk::with_the_derivations("as-they-stand");
    let run = desk.onshell(&["check", "derivations"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!(run.out.contains("all as expected"), "{}", run.out);
    assert_eq!(run.err, "");
}

#[test]
fn one_sign_flipped_is_named_with_a_state_and_both_sides() {
    let desk = Desk::with_the_derivations("one-sign");
    desk.change("derivations/06-spinning-top.md", SIGN);
    let run = desk.onshell(&["check", "derivations"]);
    assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    for wanted in ["(6.73) is refuted", "06-spinning-top.md:", "at λ_1 = ", "θ = ", "left side", "right side"] {
        assert!(run.out.contains(wanted), "no “{wanted}” in:\n{}", run.out);
    }
    assert!(run.out.contains("left side − right side = 2·M·g·R·sin(θ)"), "{}", run.out);
    // The twin: what is sound is not named.
    assert!(!run.out.contains("(6.74) is refuted") && !run.out.contains("(5.68) is refuted"), "{}", run.out);
}

#[test]
fn only_checks_the_one_equation() {
    let desk = Desk::with_the_derivations("only");
    desk.change("derivations/06-spinning-top.md", SIGN);
    let ids = |run: &support::Run| -> Vec<String> {
        let report = run.json();
        let documents = report["documents"].as_array().unwrap().iter();
        let equations = documents.flat_map(|d| d["equations"].as_array().unwrap().clone());
        equations.map(|equation| equation["id"].as_str().unwrap().to_owned()).collect()
    };
    let sound = desk.onshell(&["check", "derivations", "--only", "6.74", "--format", "json"]);
    assert_eq!((sound.code, ids(&sound)), (0, vec!["6.74".to_owned()]));
    let wrong = desk.onshell(&["check", "derivations", "--only", "6.73", "--format", "json"]);
    assert_eq!((wrong.code, ids(&wrong)), (1, vec!["6.73".to_owned()]));
    let absent = desk.onshell(&["check", "derivations", "--only", "6.79"]);
    assert_eq!(absent.code, 2, "{}", absent.out);
    assert!(absent.err.contains("6.79"), "{}", absent.err);
}

#[test]
fn another_seed_is_another_sample_of_the_same_truth() {
    let desk = Desk::with_the_derivations("seed");
    let with_seed = |seed: &str| {
        let run = desk.onshell(&["check", "derivations", "--only", "6.73", "--seed", seed, "--format", "json"]);
        assert_eq!(run.code, 0, "{}{}", run.out, run.err);
        run.out
    };
    assert_eq!(with_seed("1"), with_seed("1"));
    assert_ne!(with_seed("1"), with_seed("2"));
}

#[test]
fn a_flipped_sign_is_refuted_whatever_the_seed() {
    let desk = Desk::with_the_derivations("seeds");
    desk.change("derivations/06-spinning-top.md", SIGN);
    for seed in ["0", "2", "17", "18446744073709551615"] {
        let run = desk.onshell(&["check", "derivations", "--only", "6.73", "--seed", seed]);
        assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    }
}

#[test]
fn points_are_as_many_as_asked_for() {
    let desk = Desk::with_the_derivations("points");
    let points = |asked: &str| {
        let run = desk.onshell(&["check", "derivations", "--only", "6.73", "--points", asked, "--format", "json"]);
        run.json()["documents"][0]["equations"][0]["points"].as_u64().unwrap()
    };
    assert_eq!((points("10"), points("40")), (10, 40));
    for no_number in ["0", "-1", "many"] {
        assert_eq!(desk.onshell(&["check", "derivations", "--points", no_number]).code, 2);
    }
}

#[test]
fn the_report_is_the_same_on_one_thread_and_on_two_and_when_run_again() {
    let desk = Desk::with_the_derivations("threads");
    desk.change("derivations/06-spinning-top.md", SIGN);
    for format in ["json", "text"] {
        let run = |threads| desk.onshell_on(threads, &["check", "derivations", "--format", format]);
        let (one, two, again) = (run(Some(1)), run(Some(2)), run(Some(2)));
        assert_eq!(one.code, 1);
        assert_eq!(one.out, two.out);
        assert_eq!(two.out, again.out);
        assert_eq!(one.err, two.err);
    }
}

#[test]
fn a_document_is_named_by_its_claims_its_notes_or_its_folder() {
    let desk = Desk::with_the_derivations("names");
    let report = |path: &str| {
        let run = desk.onshell(&["check", path, "--only", "5.70", "--format", "json"]);
        assert_eq!(run.code, 0, "{path}: {}{}", run.out, run.err);
        run.json()["documents"][0]["equations"].clone()
    };
    let by_claims = report("derivations/05-euler-angles.json");
    assert_eq!(by_claims, report("derivations/05-euler-angles.md"));
    assert_eq!(by_claims, report("derivations"));
    assert_ne!(by_claims, serde_json::json!([]));
}

#[test]
fn notes_without_claims_are_checked_and_no_pass_with_strict() {
    let desk = Desk::new("no-claims");
    desk.write("alone.md", "$$ a = b \\tag{1} $$\n");
    for path in ["alone.md", "."] {
        assert_eq!(desk.onshell(&["check", path]).code, 0, "{path}");
        assert_eq!(desk.onshell(&["check", path, "--strict"]).code, 2, "{path}");
    }
    let run = desk.onshell(&["check", ".", "--format", "json"]);
    assert_eq!(run.json()["documents"][0]["equations"][0]["verdict"], "definition");
}

#[test]
fn nothing_to_check_is_no_pass() {
    let desk = Desk::new("nothing");
    assert_eq!(desk.onshell(&["check", "."]).code, 2);
    desk.write("prose.md", "# Only words\n");
    desk.write("prose.json", r#"{ "notes": "prose.md" }"#);
    let run = desk.onshell(&["check", "prose.json"]);
    assert_eq!(run.code, 2, "{}", run.out);
}

#[test]
fn help_is_no_failure_and_a_wrong_flag_is() {
    let desk = Desk::new("flags");
    let help = desk.onshell(&["--help"]);
    assert_eq!(help.code, 0);
    for command in ["check", "derive", "equal", "eval", "explain", "mutate", "read", "report"] {
        assert!(help.out.contains(command), "{}", help.out);
        assert_eq!(desk.onshell(&[command, "--frobnicate"]).code, 2);
    }
    assert_eq!(desk.onshell(&[]).code, 2);
}
