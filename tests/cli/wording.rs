//! Messages that quote the author's text, count what they are about, and claim no more than was found. Beside each stands a case
//! in which the same words must not be said.

use serde_json::json;

use crate::support::{Desk, Run};

/// The report on notes, with a claims file if there is one.
fn check(name: &str, notes: &str, claims: Option<serde_json::Value>, more: &[&str]) -> Run {
    let desk = Desk::new(&format!("wording-{name}"));
    desk.write("notes.md", notes);
    if let Some(claims) = claims {
        desk.write("notes.json", format!("{claims:#}"));
    }
    desk.onshell(&[&["check", "notes.md"], more].concat())
}

/// What is said, with single spaces in the place of line breaks.
fn said(run: &Run) -> String {
    format!("{} {}", run.out, run.err).split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn an_ambiguous_formula_is_quoted_as_it_was_typed() {
    let desk = Desk::new("wording-quoted");
    for (formula, message) in [
        (r"1/2 m v^2", r"1/2 m v^2 may be 1/(2 m v^2) or (1/2) m v^2; write \frac{1}{2 m v^2} or \frac{1}{2} m v^2"),
        (r"d/dt (m v)", r"d/dt (m v) may be a derivative or a quotient; write \frac{d}{dt} (m v) for the derivative"),
        (r"x/y/z", "x/y/z may be (x/y)/z or x/(y/z)"),
        (r"\cos x/2", r"\cos x/2 may be (\cos x)/2 or \cos(x/2)"),
        ("7 5", "7 5 may be the product 7·5 or the number 75"),
        ("1.2.3", "1.2.3 is not a number"),
        ("a)", "this ) has no matching (; remove it, or add ("),
        ("{a", "this { is never closed; add }"),
        ("a -", "a term is missing after this -"),
        ("x^", "a superscript is missing after this ^"),
        ("x^a^b", "two superscripts follow one symbol"),
        (r"\sqrt{}", "the root is empty"),
        (r"\frac{1}{}", "the denominator is empty"),
        (r"a \to b", "an arrow between two formulas is not supported"),
    ] {
        let run = desk.onshell(&["equal", formula, "q"]);
        let heard = said(&run);
        assert_eq!(run.code, 2, "{formula}: {heard}");
        // The lines of the formula stand between what is wrong and what to do.
        for wanted in message.split("; ") {
            assert!(heard.contains(wanted), "no “{wanted}” for {formula}:\n{heard}");
        }
    }
    // The twin: with braces nothing is refused.
    assert_eq!(desk.onshell(&["equal", r"\frac12 m v^2", r"\frac{m v^2}{2}"]).code, 0);
}

#[test]
fn what_is_not_read_has_no_tick_and_the_report_says_how_to_list_it() {
    let notes = "$$ x = {a $$\n\n$$ y = 1/2 m v^2 $$\n\n$$ E = \\frac12 m v^2 $$\n";
    let run = check("open", notes, None, &[]);
    assert!(said(&run).contains("2 displays were not read; list them with --verbose"), "{}", run.out);
    assert!(run.out.contains("? L1  unreadable  this { is never closed"), "{}", run.out);
    let all = check("open-all", notes, None, &["-v"]);
    assert!(all.out.contains("? L1  ") && all.out.contains("? L3  ") && all.out.contains("✓ L5  "), "{}", all.out);
    // The twin: where all is read, nothing is to be listed.
    let run = check("closed", "$$ E = \\frac12 m v^2 $$\n", None, &[]);
    assert!(!said(&run).contains("--verbose"), "{}", run.out);
}

#[test]
fn the_part_without_a_value_is_named() {
    let claims = json!({ "notes": "notes.md", "constants": { "x": "any" } });
    let of = |name: &str, formula: &str| {
        said(&check(name, &format!("$$ {formula} \\tag{{1}} $$\n"), Some(claims.clone()), &[]))
    };
    let found = of("logarithm", r"x = \ln(x - 5000)");
    assert!(found.contains("because ln(x − 5000) has no finite real value there; change the range of x"), "{found}");
    let found = of("root", r"x = \sqrt{-x^2}");
    assert!(found.contains("because √(−x^2) has no finite real value there"), "{found}");
    // The twin: a formula with values is decided.
    assert!(!of("has-values", r"x = \sqrt{x^2}").contains("sampled state gave a number"));
}

#[test]
fn a_matrix_is_shown_and_a_constant_does_not_move() {
    let claims = json!({ "notes": "notes.md", "constants": { "A": "2x2 matrix", "x": "any" } });
    let of = |name: &str, formula: &str| {
        said(&check(name, &format!("$$ {formula} \\tag{{1}} $$\n"), Some(claims.clone()), &[]))
    };
    let found = of("matrix", r"\operatorname{tr} A = 3");
    assert!(found.contains("A_{11} ="), "{found}");
    assert!(!found.contains("at every state"), "{found}");
    assert!(of("no-symbol", "2 + 2 = 5").contains("at every state"));
    let moving = "there is a dot on x, which is declared as a constant";
    assert!(of("dot", r"\dot x = 3").contains(moving));
    let found = of("dot-on-a-sum", r"\dot{(x + 1)} = 3");
    assert!(found.contains(moving), "{found}");
    assert!(!of("no-dot", "x + 1 = 3").contains(moving));
}

#[test]
fn what_the_claims_file_leaves_out_is_a_warning() {
    let claims = |entry| json!({ "notes": "notes.md", "constants": { "x": "any" }, "equations": { "1": entry } });
    let notes = "$$ x = \\ln x \\tag{1} $$\n";
    let run = check("skipped", notes, Some(claims(json!({ "skip": "linear" }))), &[]);
    assert_eq!(run.code, 2, "{}", run.out);
    let heard = said(&run);
    assert!(
        heard.contains("warning[skipped]: (1) was not checked, because the claims file leaves it out: linear"),
        "{heard}"
    );
    let expected = json!({ "skip": "linear", "expect": "unclaimed", "because": "it is linear" });
    let run = check("skipped-expected", notes, Some(claims(expected)), &[]);
    assert_eq!(run.code, 0, "{}", run.out);
    assert!(!said(&run).contains("warning"), "{}", run.out);
}

#[test]
fn a_claims_file_about_other_notes_is_a_warning() {
    let notes = "$$ x = 2 \\tag{1} $$\n";
    let run = check("other", notes, Some(json!({ "notes": "other.md", "constants": { "x": "any" } })), &[]);
    let heard = said(&run);
    assert!(
        heard.contains("warning: notes.json is about other.md, which is not there; it is used for notes.md."),
        "{heard}"
    );
    let run = check("own", notes, Some(json!({ "notes": "notes.md", "constants": { "x": "any" } })), &[]);
    assert!(!said(&run).contains("which is not there"), "{}", run.err);
}

#[test]
fn numbers_of_solutions_are_counted_and_not_called_sides() {
    let claims = |count: usize| {
        json!({ "notes": "notes.md", "constants": { "x": "(-3, 3)" }, "sentences": [
            { "quote": "There are solutions.", "of": "1", "solutions": count, "for": "x" }
        ] })
    };
    let notes = "$$ x^2 = 1 \\tag{1} $$\n\nThere are solutions.\n";
    let found = said(&check("count", notes, Some(claims(1)), &[]));
    assert!(found.contains("there are 2 real solutions for x, not 1"), "{found}");
    assert!(found.contains("real solutions: 2 found, 1 claimed"), "{found}");
    assert!(!found.contains("at every state"), "{found}");
    assert!(!said(&check("count-holds", notes, Some(claims(2)), &[])).contains(" claimed"));
}

#[test]
fn a_lagrangian_of_guessed_claims_is_derived() {
    let desk = Desk::new("wording-derive");
    desk.write(
        "notes.md",
        "A mass $m$ on a spring. $$ L = \\frac12 m\\dot x^2 - \\frac12 k x^2 $$\n$$ m\\ddot x = -k x $$\n",
    );
    assert_eq!(desk.onshell(&["init", "notes.md"]).code, 0);
    let run = desk.onshell(&["derive", "notes.md"]);
    assert!(run.out.lines().any(|line| line.ends_with("= −k·x")), "{}{}", run.out, run.err);
    // The twin: notes without a Lagrangian.
    desk.write("other.md", "$$ F = m a $$\n");
    assert_eq!(desk.onshell(&["derive", "other.md"]).code, 2);
}

#[test]
fn an_option_says_what_it_needs() {
    let desk = Desk::new("wording-options");
    desk.write("notes.md", "$$ x = 2 \\tag{1} $$\n");
    let run = desk.onshell(&["plot", "simple_pendulum", "--until", "-3"]);
    assert!(run.code == 2 && run.err.contains("--until must be a number above 0"), "{}", run.err);
    let run = desk.onshell(&["check", "notes.md", "--seed", "-1"]);
    assert!(run.code == 2 && run.err.contains("the seed must be a whole number"), "{}", run.err);
    let run = desk.onshell(&["check", "notes.md", "--only", "77"]);
    assert!(run.code == 2 && run.err.contains("the notes have (1)"), "{}", run.err);
    assert_eq!(desk.onshell(&["check", "notes.md", "--seed", "7", "--only", "1"]).code, 0);
}
