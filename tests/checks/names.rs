//! Names: used before they are introduced, introduced by a correction, cited by number, and of one unit.

use onshell::check::Verdict::{Definition, Refuted, Undecided, Unreadable, Verified};
use onshell::check::{Document, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, numbers, with};

fn check(claims: &Json, displays: &[&str]) -> Document {
    let found = document(claims, &numbered(displays), &Registry::standard(), None);
    found.unwrap_or_else(|error| panic!("{displays:?}: {error}"))
}

fn verdicts(claims: &Json, displays: &[&str]) -> Vec<Verdict> {
    check(claims, displays).equations.iter().map(|equation| equation.finding.verdict).collect()
}

#[test]
fn a_name_is_known_before_the_display_that_introduces_it() {
    let displays = |product: &str| verdicts(&numbers(), &[product, "p = a + b"]);
    assert_eq!(displays("ap = a^2 + ab"), [Verified, Definition]);
    assert_eq!(displays("ap = a^2 - ab")[0], Refuted);
    assert_eq!(verdicts(&numbers(), &["ap = a^2 + ab"]), [Unreadable]);
}

#[test]
fn the_prose_may_define_a_name_through_one_that_a_display_introduces() {
    let claims = with(&numbers(), "define", json!({ "q": "p^2" }));
    assert_eq!(verdicts(&claims, &["q = a^2 + 2ab + b^2", "p = a + b"]), [Verified, Definition]);
    assert_eq!(verdicts(&claims, &["q = a^2 + 2ab + b^2", "p = a - b"])[0], Refuted);
}

#[test]
fn names_that_stand_on_each_other_are_refused() {
    let circular = check(&numbers(), &["p = q + a", "q = p + b", "p + q = a"]);
    assert!(circular.equations.iter().any(|equation| !equation.ok));
    assert!(circular.equations.iter().all(|equation| equation.finding.verdict != Verified));
}

/// The first display has an erratum whose correction introduces p.
fn corrected(printed: &str, read: &str, second: &str) -> Document {
    let erratum = json!({ "1": { "erratum": { "for": "a =", "read": read } } });
    check(&with(&numbers(), "equations", erratum), &[printed, second])
}

#[test]
fn a_correction_may_introduce_a_name() {
    let found = corrected("a = b + c", "p =", "bp = b^2 + bc");
    assert!(found.equations.iter().all(|equation| equation.ok), "{:?}", found.equations);
    assert_eq!(found.equations[1].finding.verdict, Verified);
    // A slip in what is corrected shows in what stands on it.
    let slipped = corrected("a = b - c", "p =", "bp = b^2 + bc");
    assert_eq!(slipped.equations[1].finding.verdict, Refuted);
    // What is not named by the correction is not known.
    let other = corrected("a = b + c", "q =", "bp = b^2 + bc");
    assert_eq!(other.equations[1].finding.verdict, Unreadable);
}

#[test]
fn an_erratum_is_wrong_as_printed() {
    // a = b c is false, and p = b c names it; b = b is not.
    assert!(corrected("a = b c", "p =", r"\frac{p}{b} = c").equations[0].ok);
    let erratum = json!({ "2": { "erratum": { "for": "p", "read": "q" } } });
    let right = check(&with(&numbers(), "equations", erratum), &["p = a + b", "p = a + b"]);
    assert!(!right.equations[1].ok, "{:?}", right.equations[1]);
}

/// The verdict on a sentence that cites a number.
fn cites(number: &str, formula: &str) -> Verdict {
    let notes = format!("The square is in it.\n\n{}", numbered(&["(a + b)^2 = a^2 + 2ab + b^2", "a + b = b + a"]));
    let sentence = json!([{ "quote": "The square is in it.", "refers to": number, "containing": formula }]);
    let claims = with(&numbers(), "sentences", sentence);
    let found = document(&claims, &notes, &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"));
    found.sentences[0].finding.verdict
}

#[test]
fn a_citation_is_of_an_equation_that_contains_what_is_meant() {
    assert_eq!(cites("1", "(a + b)^2"), Verified);
    assert_eq!(cites("2", "(a + b)^2"), Refuted);
    assert_eq!(cites("2", "a + b"), Verified);
    assert_eq!(cites("1", "c"), Refuted);
    // It may cite what these notes do not have.
    assert_ne!(cites("7", "(a + b)^2"), Verified);
}

#[test]
fn what_is_introduced_twice_is_tested() {
    assert_eq!(verdicts(&numbers(), &["p = a + b", "p = b + a"]).last(), Some(&Verified));
    assert_eq!(verdicts(&numbers(), &["p = a + b", "p = b - a"]).last(), Some(&Refuted));
}

#[test]
fn units_of_families_and_of_what_stands_on_them() {
    let claims = json!({
        "indices": { "i": "1..n" },
        "varies with time": { r"\vec r_i": "any" },
        "constants": { "m_i": "> 0" },
        "units": { "m_i": "kg", r"\vec r_i": "m" },
    });
    let mass = r"M = \sum_i m_i";
    let mean = |latex: &str| {
        let found = verdicts(&claims, &[mass, r"\vec r_{cm} = \frac{1}{M} \sum_i m_i \vec r_i", latex]);
        *found.last().unwrap()
    };
    assert_eq!(mean(r"M \vec r_{cm} = \sum_i m_i \vec r_i"), Verified);
    // These two do not even have the units for it.
    assert_eq!(mean(r"\vec r_{cm} = \sum_i m_i \vec r_i"), Unreadable);
    assert_eq!(mean(r"M \vec r_{cm} = \sum_i m_i \dot{\vec r}_i"), Unreadable);
    // This one has.
    assert_eq!(mean(r"M \vec r_{cm} = 2 \sum_i m_i \vec r_i"), Refuted);
}

#[test]
fn a_definition_that_nothing_uses_is_no_pass() {
    assert_eq!(verdicts(&numbers(), &["p = a + b"]), [Undecided]);
}
