//! `onshell init`: the file that it writes changes no verdict, and a wrong guess in it does.

use std::path::Path;

use serde_json::Value;

use crate::support::{Desk, Run};
use crate::unaided::{BESIDE_A_LAGRANGIAN, LECTURE, SLIPS, TRUE, page};

/// The verdicts of a report, with the names of the displays and the suggested edits.
fn verdicts(run: &Run) -> Vec<(Value, Value, Value)> {
    let report = run.json();
    let equations = report["documents"][0]["equations"].as_array().expect("a list").clone();
    let edits = |equation: &Value| equation["repairs"].as_array().and_then(|all| all.first().cloned());
    equations.iter().map(|e| (e["id"].clone(), e["verdict"].clone(), edits(e).unwrap_or_default())).collect()
}

#[test]
fn the_verdicts_with_the_written_file_are_those_without_it() {
    let mut pages: Vec<String> = TRUE.iter().map(|displays| page(displays)).collect();
    pages.extend(SLIPS.iter().map(|(displays, ..)| page(displays)));
    pages.extend(BESIDE_A_LAGRANGIAN.iter().map(|(words, displays)| format!("{words}\n\n{}", page(displays))));
    pages.extend([LECTURE.to_owned(), LECTURE.replace("-\\frac{g}{l}", "\\frac{g}{l}")]);
    // Nothing to infer, a number that is there twice, and a display that cannot be read.
    pages.push("$$ 1 + 1 = 3 $$\n".to_owned());
    pages.push("$$ a = b \\tag{7} $$\n\n$$ (c + d)^2 = c^2 + d^2 \\tag{7} $$\n\n$$ a \\nabla $$\n".to_owned());
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for name in ["stranger.md", "torque.md", "bead.md", "systems/pendulum.md", "systems/kepler.md"] {
        pages.push(std::fs::read_to_string(examples.join(name)).expect("it is there"));
    }
    for (at, text) in pages.iter().enumerate() {
        let desk = Desk::new(&format!("init-{at}"));
        desk.write("notes.md", text);
        let before = desk.onshell(&["check", "notes.md", "--format", "json"]);
        let made = desk.onshell(&["init", "notes.md"]);
        assert_eq!(made.code, 0, "{}{}", made.out, made.err);
        assert!(made.out.starts_with("notes.json: written"), "{}", made.out);
        let after = desk.onshell(&["check", "notes.md", "--format", "json"]);
        assert_eq!(
            (verdicts(&before), before.code),
            (verdicts(&after), after.code),
            "{text}\n{}",
            desk.read("notes.json")
        );
        assert_eq!(after.json()["documents"][0]["claims"], "notes.json");
        // Guesses are no claims.
        assert_ne!(desk.onshell(&["check", "notes.md", "--strict"]).code, 0);
    }
}

#[test]
fn what_the_author_corrects_counts_and_without_guesses_all_must_follow() {
    let desk = Desk::new("init-corrected");
    desk.write(
        "notes.md",
        "$$ \\ddot x = -\\omega^2 x $$\n\n$$ v = \\dot x $$\n\n$$ (a + b)^2 = a^2 + 2 a b + b^2 $$\n",
    );
    assert_eq!(desk.onshell(&["init", "notes.md"]).code, 0);
    let verdict = |at: usize| {
        let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
        (verdicts(&run)[at].1.as_str().unwrap_or_default().to_owned(), run.code)
    };
    assert_eq!((verdict(0), verdict(2)), (("assumed".to_owned(), 0), ("certified".to_owned(), 0)));
    // A claim of the author's is judged like any other.
    desk.change("notes.json", ("\"guesses\"", "\"equations\": { \"L1\": {} },\n  \"guesses\""));
    assert_eq!(verdict(0), ("refuted".to_owned(), 1));
    desk.change("notes.json", ("\"L1\": {}", "\"L5\": {}"));
    assert_eq!(verdict(0), ("assumed".to_owned(), 0));
    // A declaration that is taken away is missed.
    let text = desk.read("notes.json");
    desk.write(
        "notes.json",
        text.replace("    \"\\\\omega\": \"any\",\n", "").replace("\"\\\\omega\": \"any\"\n", "\n"),
    );
    assert_eq!(verdict(0).0, "unreadable", "{}", desk.read("notes.json"));
    // Without guesses it is a claims file like any other, in which the display without a number is not checked.
    let mut claims: Value = serde_json::from_str(&text).expect("it is JSON");
    claims.as_object_mut().expect("an object").remove("guesses");
    claims["equations"] = serde_json::json!({ "#1": {} });
    desk.write("notes.md", "<!-- onshell: 1 -->\n$$ \\ddot x = -\\omega^2 x $$\n");
    desk.write("notes.json", claims.to_string());
    assert_eq!(verdict(0), ("refuted".to_owned(), 1));
}

#[test]
fn nothing_is_overwritten_unless_told() {
    let desk = Desk::new("init-overwrite");
    desk.write("notes.md", "$$ F = m a $$\n");
    desk.write("notes.json", "mine");
    let run = desk.onshell(&["init", "notes.md"]);
    assert!(run.code == 2 && run.err.contains("notes.json is there already"), "{}{}", run.out, run.err);
    assert_eq!(desk.read("notes.json"), "mine");
    assert_eq!(desk.onshell(&["init", "notes.md", "--overwrite"]).code, 0);
    let claims: Value = serde_json::from_str(&desk.read("notes.json")).expect("it is JSON");
    assert_eq!((&claims["notes"], &claims["constants"]["m"]), (&Value::from("notes.md"), &Value::from("any")));
    assert!(claims["guesses"]["m"].as_str().is_some_and(|reason| reason.contains("first in (L1)")), "{claims}");
}

#[test]
fn several_files_projects_and_notebooks_get_a_file_each() {
    let desk = Desk::new("init-several");
    desk.write("main.tex", "\\input{part}\n\\[ (a + b)^2 = a^2 + b^2 \\]\n");
    desk.write("part.tex", "\\[ x = l \\sin\\theta \\]\n");
    let cell = serde_json::json!({ "cell_type": "markdown", "metadata": {}, "source": ["$$ y = \\sqrt{k} $$\n"] });
    desk.write("book.ipynb", serde_json::json!({ "cells": [cell], "nbformat": 4, "nbformat_minor": 5 }).to_string());
    desk.write("old.md", "$$ a = b \\tag{1} $$\n");
    desk.write("old.json", "{ \"notes\": \"old.md\", \"constants\": { \"a, b\": \"any\" } }");
    let run = desk.onshell(&["init", "."]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!(run.out.contains("old.json: this claims file exists already"), "{}", run.out);
    assert!(desk.read("book.json").contains("\"k\": \"> 0\""), "{}", desk.read("book.json"));
    assert!(desk.read("main.json").contains("\\\\theta") && !desk.path("part.json").exists());
    let run = desk.onshell(&["check", "main.tex", "--format", "json"]);
    assert_eq!(run.code, 1, "{}", run.out);
    // Prose without a display, a file that is not there, and a claims file.
    desk.write("words.md", "Only words.\n");
    assert_eq!(desk.onshell(&["init", "words.md"]).code, 0);
    for wrong in ["absent.md", "old.json", "main.zip"] {
        assert_eq!(desk.onshell(&["init", wrong]).code, 2, "{wrong}");
    }
}
