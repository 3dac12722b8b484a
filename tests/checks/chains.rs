//! A slip in a chain is one slip: which member it is, what follows from it, and how it is mended.

use onshell::check::{Equation, Finding, Verdict};
use serde_json::json;

use crate::support::{equation, numbers, pendulum, verdict};

/// A chain of numbers that is false.
fn chain(latex: &str) -> Equation {
    let found = equation(&numbers(), &[latex], json!({}));
    assert_eq!((found.finding.verdict, found.ok), (Verdict::Refuted, false), "{latex}");
    found
}

/// The text that a finding is about.
fn about<'a>(latex: &'a str, finding: &Finding) -> &'a str {
    // the display stands in its file behind "$$\n"
    &latex[finding.span.start - 3..finding.span.end - 3]
}

/// What the display reads as with its first repair, and whether that mends no more than a step.
fn mended(latex: &str, found: &Equation) -> Option<(String, bool)> {
    let repair = found.repairs.first()?;
    let mut text = latex.to_owned();
    text.replace_range(repair.span.start - 3..repair.span.end - 3, &repair.replacement);
    Some((text, repair.step))
}

#[test]
fn a_wrong_member_between_two_that_agree_is_named_once() {
    let latex = "(a+b)^2 = a^2 + 2ab - b^2 = a(a + 2b) + b^2";
    let found = chain(latex);
    assert!(found.parts.is_empty(), "one slip, one finding: {:?}", found.parts);
    assert_eq!(about(latex, &found.finding), "a^2 + 2ab - b^2");
    assert!(found.finding.message.contains("only “a^2 + 2·a·b − b^2” is wrong here"), "{}", found.finding.message);
    let right = "(a+b)^2 = a^2 + 2ab + b^2 = a(a + 2b) + b^2".to_owned();
    assert_eq!(mended(latex, &found), Some((right, false)));
    // The twin: where the two beside it do not agree, there is a slip in each step.
    let latex = "(a+b)^2 = a^2 + 2ab - b^2 = a(a + 2b) + 3b^2";
    let found = chain(latex);
    let places: Vec<&str> = found.parts.iter().map(|part| about(latex, &part.finding)).collect();
    assert_eq!(places, ["(a+b)^2 = a^2 + 2ab - b^2", "a^2 + 2ab - b^2 = a(a + 2b) + 3b^2"]);
}

#[test]
fn a_slip_that_is_carried_on_is_one_slip() {
    let latex = "(a+b)^2 = a^2 + 2ab - b^2 = a^2 + b(2a - b) = a(a + 2b) - b^2";
    let found = chain(latex);
    assert!(found.parts.is_empty(), "one slip, one finding: {:?}", found.parts);
    assert_eq!((about(latex, &found.finding), found.finding.carried), ("(a+b)^2 = a^2 + 2ab - b^2", 2));
    assert!(
        found.finding.message.contains("the rest of the chain follows from this mistake"),
        "{}",
        found.finding.message
    );
    // The step is mended, and what follows is not: that is said, too.
    let step = "(a+b)^2 = a^2 + 2ab + b^2 = a^2 + b(2a - b) = a(a + 2b) - b^2".to_owned();
    assert_eq!(mended(latex, &found), Some((step, true)));
    // The twin: a second slip further on is a finding of its own.
    let found = chain("(a+b)^2 = a^2 + 2ab - b^2 = a^2 + b(2a - b) = a(a + 5b) - b^2");
    assert_eq!(found.parts.iter().map(|part| part.finding.carried).collect::<Vec<_>>(), [1, 0]);
}

#[test]
fn what_was_right_so_far_is_not_blamed() {
    for (latex, wrong, carried) in [
        ("(a+b)^2 = a^2 + 2ab + b^2 = a^2 + b(2a - b)", "a^2 + b(2a - b)", 0),
        ("(a+b)^2 = a^2 + 2ab + b^2 = a^2 + b(2a - b) = a(a + 2b) - b^2", "a^2 + b(2a - b)", 1),
    ] {
        let found = chain(latex);
        assert_eq!((about(latex, &found.finding), found.finding.carried), (wrong, carried));
    }
}

#[test]
fn a_chain_that_comes_back_has_one_slip_and_what_was_made_of_it() {
    let latex = "(a+b)^2 = a^2 + 2ab - b^2 = a^2 + b(2a - b) = a^2 + b(2a + b)";
    let found = chain(latex);
    assert!(found.parts.is_empty(), "{:?}", found.parts);
    assert_eq!(about(latex, &found.finding), "a^2 + 2ab - b^2");
    assert!(found.finding.message.contains("and what follows from it are wrong here"), "{}", found.finding.message);
}

#[test]
fn a_first_member_that_is_wrong_can_be_mended_with_all_that_follows() {
    let found = chain("(a+c)^2 = a^2 + 2ab + b^2 = a^2 + b(2a + b)");
    let all = "(a+b)^2 = a^2 + 2ab + b^2 = a^2 + b(2a + b)".to_owned();
    assert_eq!(mended("(a+c)^2 = a^2 + 2ab + b^2 = a^2 + b(2a + b)", &found), Some((all, false)));
}

#[test]
fn rows_that_begin_with_a_relation_are_one_chain() {
    let rows = |second: &str| {
        format!(
            "\\begin{{aligned}}\n(a+b)^3 &= a^3 + 3a^2b + 3ab^2 + b^3 \\\\\n&= {second} \\\\\n&= a^3 + b^3 + 3ab(a+b)\n\\end{{aligned}}"
        )
    };
    let latex = rows("a^3 + 3ab(a-b) + b^3");
    let found = chain(&latex);
    assert_eq!(about(&latex, &found.finding), "a^3 + 3ab(a-b) + b^3");
    assert_eq!(mended(&latex, &found), Some((rows("a^3 + 3ab(a+b) + b^3"), false)));
}

#[test]
fn members_agree_on_shell_where_links_are_judged_so() {
    let latex = r"\ddot\theta = \frac{g}{l} \sin\theta = -\frac{mgl}{ml^2} \sin\theta";
    let found = equation(&pendulum(), &[latex], json!({}));
    assert_eq!(about(latex, &found.finding), r"\frac{g}{l} \sin\theta");
    assert!(
        found.finding.message.contains("is wrong here, because the members before and after agree"),
        "{}",
        found.finding.message
    );
}

#[test]
fn what_cannot_be_told_of_a_link_names_no_member() {
    // ≈ without a limit cannot be read, and nothing is said of what follows from what.
    let found = equation(&numbers(), &["(a+b)^2 = a^2 + 2ab - b^2 = a(a + 2b) - b^2 \\approx a^2"], json!({}));
    assert!(!found.finding.message.contains("follows from this mistake"), "{}", found.finding.message);
    assert_eq!(found.finding.carried, 0);
}

#[test]
fn a_chain_with_a_zero_says_of_each_member_that_it_is_zero() {
    let claims = json!({
        "coordinates": { "x, y, z": "any" },
        "constants": { "m, g": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let fall = r"L = \frac12 m(\dot x^2 + \dot y^2 + \dot z^2) - m g z";
    let found = |latex: &str| verdict(&claims, &[fall, latex], json!({}));
    for right in [r"\dot p_x = \dot p_y = 0", r"\dot p_x = 0 = \dot p_y", r"\ddot x = \ddot y = \dot p_y = 0"] {
        assert_eq!(found(right), Verdict::Verified, "{right}");
    }
    assert_eq!(found(r"\dot p_x = \dot p_z = 0"), Verdict::Refuted);
    // The twin: without the 0, a wrong factor would not be noticed.
    assert_eq!(found(r"\dot p_x = \dot p_y"), Verdict::Undecided);
}
