//! `onshell mark`: hand-ins in `tests/mark`, each with the marks that a fair teacher gives in comments beside its lines.

use std::path::Path;

use crate::support::{Desk, Run};

/// The words in the comments of a hand-in.
fn expected(text: &str) -> Vec<String> {
    let words = |comment: &str| comment.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let tex = text.lines().filter_map(|line| Some(line.split_once('%')?.1));
    let markdown = text.split("<!--").skip(1).filter_map(|rest| Some(rest.split_once("-->")?.0));
    let is_tex = !text.contains("<!--");
    if is_tex { tex.flat_map(words).collect() } else { markdown.flat_map(words).collect() }
}

/// The marks of a student in a table, the missing results, and the points.
fn found(run: &Run, student: &str) -> Vec<String> {
    let report = run.json();
    let rows = report["rows"].as_array().unwrap().iter().filter(|row| row["student"] == student);
    let mut found: Vec<String> = rows
        .map(|row| match row["mark"].as_str().unwrap() {
            "missing" => format!("missing:{}", row["result"].as_str().unwrap()),
            mark => mark.to_owned(),
        })
        .collect();
    let student = report["students"].as_array().unwrap().iter().find(|one| one["student"] == student).unwrap();
    found.push(format!("points:{}", student["credit"].as_f64().unwrap()));
    found
}

fn class(name: &str) {
    let desk = Desk::new(&format!("mark-{name}"));
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mark");
    for file in [format!("{name}.md"), format!("{name}.json")] {
        desk.write(&file, &std::fs::read_to_string(from.join(&file)).unwrap());
    }
    let mut texts = Vec::new();
    for entry in std::fs::read_dir(from.join(name)).unwrap() {
        let path = entry.unwrap().path();
        let file = path.file_name().unwrap().to_string_lossy().into_owned();
        let text = std::fs::read_to_string(&path).unwrap();
        desk.write(&format!("{name}/{file}"), &text);
        texts.push((path.file_stem().unwrap().to_string_lossy().into_owned(), text));
    }
    assert!(texts.len() >= 12, "{name}: {}", texts.len());
    texts.sort();
    let run = desk.onshell(&["mark", name, "--claims", &format!("{name}.json"), "--format", "json"]);
    assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    for (student, text) in texts {
        let mut wanted = expected(&text);
        if text.trim().is_empty() {
            let report = run.json();
            let one = report["students"].as_array().unwrap().iter().find(|one| one["student"] == *student).unwrap();
            let results = one["results"].as_array().unwrap().iter();
            wanted = results.map(|result| format!("missing:{}", result["id"].as_str().unwrap())).collect();
            wanted.push("points:0".to_owned());
        }
        assert_eq!(found(&run, &student), wanted, "{name}/{student}\n{text}");
    }
}

#[test]
fn hand_ins_about_a_pendulum_are_marked_as_a_fair_teacher_would() {
    class("pendulum");
}

#[test]
fn hand_ins_about_a_throw_are_marked_as_a_fair_teacher_would() {
    class("throw");
}
