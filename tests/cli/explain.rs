//! `onshell explain`: every verdict, every outcome of a mutant, and every code.

use std::collections::HashSet;

use onshell::Code;
use onshell::check::Verdict;

use crate::support::Desk;

/// Every word that can be explained.
fn words() -> Vec<&'static str> {
    let mut codes: Vec<&str> = Code::ALL.iter().map(|code| code.word()).collect();
    codes.sort_unstable();
    let outcomes = ["refused", "equivalent", "survived"];
    Verdict::ALL.iter().map(|verdict| verdict.word()).chain(outcomes).chain(codes).collect()
}

#[test]
fn every_verdict_and_every_code_is_explained() {
    let desk = Desk::new("explain");
    for word in words() {
        let run = desk.onshell_in_columns(None, &["explain", word]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{word}");
        assert!(run.out.starts_with(&format!("{word} (")) && run.out.lines().count() > 2, "{}", run.out);
    }
    for verdict in Verdict::ALL {
        let run = desk.onshell(&["explain", verdict.word()]);
        assert!(run.out.contains(if verdict.passes() { "verdict, passes" } else { "verdict, does not pass" }));
    }
}

#[test]
fn without_a_word_all_are_listed_a_line_each() {
    let run = Desk::new("explain-all").onshell(&["explain"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let first: Vec<&str> = run.out.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).collect();
    assert_eq!(first, words());
}

#[test]
fn an_unknown_word_is_refused_with_the_nearest_one() {
    let desk = Desk::new("explain-unknown");
    let near = desk.onshell(&["explain", "refutd"]);
    assert_eq!((near.code, near.out.as_str()), (2, ""));
    assert!(near.err.contains("did you mean refuted?"), "{}", near.err);
    let far = desk.onshell(&["explain", "quark"]);
    assert!(far.code == 2 && far.err.contains("lists all that it explains"), "{}", far.err);
}

/// An example as `onshell explain` prints it: the arguments of the command, and the files.
struct Printed {
    arguments: Vec<String>,
    files: Vec<(String, String)>,
}

impl Printed {
    /// The example below an explanation.
    fn of(explanation: &str) -> Printed {
        let (_, example) =
            explanation.split_once("\nExample: ").unwrap_or_else(|| panic!("no example:\n{explanation}"));
        let command = example.split('`').nth(1).unwrap();
        let arguments = command.strip_prefix("onshell ").unwrap().split_whitespace().map(str::to_owned).collect();
        let mut files: Vec<(String, String)> = Vec::new();
        for line in example.lines().skip(1) {
            match (line.strip_prefix("    "), files.last_mut()) {
                (Some(text), Some((_, content))) => *content += &format!("{text}\n"),
                (None, _) if line.ends_with(".md") || line.ends_with(".json") => {
                    files.push((line.to_owned(), String::new()));
                }
                (_, Some((_, content))) if !content.is_empty() => content.push('\n'),
                _ => {}
            }
        }
        Printed { arguments, files }
    }

    /// The verdicts, outcomes and codes that its command reports, in a folder with its files alone.
    fn reported(&self, name: &str) -> HashSet<String> {
        let desk = Desk::new(&format!("explain-{name}"));
        for (name, content) in &self.files {
            desk.write(name, content);
        }
        let mut arguments: Vec<&str> = self.arguments.iter().map(String::as_str).collect();
        arguments.extend(["--format", "json"]);
        let mut words = HashSet::new();
        collect(&desk.onshell(&arguments).json(), &mut words);
        words
    }
}

/// The verdicts and codes of a report, and the outcomes of mutants that it counts.
fn collect(value: &serde_json::Value, words: &mut HashSet<String>) {
    match value {
        serde_json::Value::Object(fields) => {
            for (name, field) in fields {
                let counted = field.as_u64().or_else(|| field.as_array().map(|list| list.len() as u64));
                match (name.as_str(), field.as_str()) {
                    ("code" | "verdict", Some(word)) => drop(words.insert(word.to_owned())),
                    ("refused" | "equivalent", _) if counted > Some(0) => drop(words.insert(name.clone())),
                    ("survivors", _) if counted > Some(0) => drop(words.insert("survived".to_owned())),
                    _ => collect(field, words),
                }
            }
        }
        serde_json::Value::Array(list) => list.iter().for_each(|value| collect(value, words)),
        _ => {}
    }
}

/// Whether the example of a word reports it.
fn comes_out(word: &str, example: &Printed) -> bool {
    example.reported(word).contains(word)
}

/// The examples of these words.
fn examples(words: &[&'static str]) -> Vec<(&'static str, Printed)> {
    let desk = Desk::new("examples");
    let printed = |word| Printed::of(&desk.onshell(&["explain", word]).out);
    words.iter().map(|word| (*word, printed(word))).collect()
}

#[test]
fn every_example_reports_what_it_explains() {
    let all = examples(&words());
    let missed: Vec<&str> = std::thread::scope(|scope| {
        let parts = all.chunks(all.len().div_ceil(4));
        let run = |part: &[(&'static str, Printed)]| -> Vec<&'static str> {
            part.iter().filter(|(word, example)| !comes_out(word, example)).map(|(word, _)| *word).collect()
        };
        let threads: Vec<_> = parts.map(|part| scope.spawn(move || run(part))).collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap()).collect()
    });
    assert_eq!(missed, Vec::<&str>::new());
}

#[test]
fn an_example_that_reports_something_else_is_noticed() {
    let [(_, example)] = examples(&["sides-differ"]).try_into().ok().unwrap();
    assert!(comes_out("sides-differ", &example) && !comes_out("inequality-fails", &example));
    let mut correct = example;
    correct.files[0].1 = correct.files[0].1.replace("a^2 + b^2", "a^2 + 2ab + b^2");
    assert!(!comes_out("sides-differ", &correct) && comes_out("certified", &correct));
}
