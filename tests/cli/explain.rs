//! `onshell explain`: every verdict, every outcome of a mutant, and every code.

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
        assert!(run.out.contains("For example, "), "{}", run.out);
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
