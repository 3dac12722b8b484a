//! Several slips at once: which printed terms do not fit, by how much, and which are missing.

use onshell::check::{Equation, Fit, Report};
use onshell::report;
use serde_json::{Value as Json, json};

use crate::support::{equation, numbers, pendulum, planet, top};

/// What is said of the terms of a false equation, that is not mended by one edit.
fn fit(claims: &Json, latex: &str, claim: Json) -> Option<Fit> {
    let found = equation(claims, &[latex], claim);
    assert!(!found.ok && found.repairs.is_empty(), "{latex}: {:?}", found.repairs);
    found.finding.fit
}

/// The terms of a fit, each as printed with what it should be multiplied by, and the missing ones in plain text.
fn terms(latex: &str, fit: &Fit) -> (Vec<(String, String)>, Vec<String>) {
    let start = "$$\n".len();
    let printed = |span: onshell::Span| latex[span.start - start..span.end - start].to_owned();
    let terms = fit.terms.iter().map(|misfit| (printed(misfit.span), misfit.coefficient.to_string()));
    (terms.collect(), fit.missing.iter().map(|formula| formula.text.clone()).collect())
}

/// These terms of a false equation are told, with these coefficients, and these as missing.
fn is_fitted(claims: &Json, latex: &str, claim: Json, expected: &[(&str, &str)], missing: &[&str]) {
    let fit = fit(claims, latex, claim).unwrap_or_else(|| panic!("no fit for {latex}"));
    let expected: Vec<(String, String)> = expected.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect();
    assert_eq!(terms(latex, &fit), (expected, missing.iter().map(|term| (*term).to_owned()).collect()), "{latex}");
}

/// (6.73) with these signs of its three terms.
fn motion(signs: [&str; 3]) -> String {
    let [a, b, c] = signs;
    format!(
        r"\lambda_1 \ddot\theta = {a} \lambda_1 \dot\phi^2 \sin\theta\cos\theta {b} \dot\phi \sin\theta \, p_\psi {c} MgR \sin\theta"
    )
}

#[test]
fn two_wrong_signs_are_found_at_their_places() {
    let first = (r"- \lambda_1 \dot\phi^2 \sin\theta\cos\theta", "-1");
    let second = (r"+ \dot\phi \sin\theta \, p_\psi", "-1");
    let third = ("- MgR \\sin\\theta", "-1");
    is_fitted(&top(), &motion(["-", "-", "-"]), json!({}), &[first, third], &[]);
    is_fitted(&top(), &motion(["", "+", "-"]), json!({}), &[second, third], &[]);
}

#[test]
fn a_wrong_number_beside_a_wrong_sign() {
    is_fitted(
        &pendulum(),
        r"E = m l^2 \dot\theta^2 + m g l \cos\theta",
        json!({}),
        &[(r"m l^2 \dot\theta^2", "1/2"), (r"+ m g l \cos\theta", "-1")],
        &[],
    );
}

#[test]
fn a_term_that_does_not_belong_is_told_beside_a_wrong_one() {
    is_fitted(
        &planet(),
        r"\ddot r = r \dot\phi^2 + \frac{GM}{r^2} + \frac{\dot r^2}{r}",
        json!({}),
        &[(r"+ \frac{GM}{r^2}", "-1"), (r"+ \frac{\dot r^2}{r}", "0")],
        &[],
    );
}

#[test]
fn terms_within_brackets_have_places_of_their_own() {
    is_fitted(
        &numbers(),
        "(a + b)^2 = a (a + 3 b) + 2 b (b + x)",
        json!({}),
        &[("+ 3 b", "2/3"), ("b", "1/2"), ("+ x", "0")],
        &[],
    );
    // all of a bracket is told at once
    is_fitted(
        &numbers(),
        "(a + b)^2 = a^2 + 3 (4 a b + 2 b^2) + c",
        json!({}),
        &[("+ 3 (4 a b + 2 b^2)", "1/6"), ("+ c", "0")],
        &[],
    );
}

#[test]
fn what_is_missing_is_told_beside_what_stands_in_its_place() {
    is_fitted(
        &pendulum(),
        r"m l^2 \ddot\theta = m g l \cos\theta",
        json!({}),
        &[(r"m g l \cos\theta", "0")],
        &["−m·l·g·sin(θ)"],
    );
}

#[test]
fn terms_that_depend_on_one_another_have_no_single_fit() {
    let twice = r"\frac13 m l^2 \dot\theta^2 + \frac15 m l^2 \dot\theta^2";
    assert_eq!(fit(&pendulum(), &format!(r"E = {twice} + m g l \cos\theta"), json!({})), None);
    // and with one of the two it has
    is_fitted(
        &pendulum(),
        r"E = \frac13 m l^2 \dot\theta^2 + m g l \cos\theta",
        json!({}),
        &[(r"\frac13 m l^2 \dot\theta^2", "3/2"), (r"+ m g l \cos\theta", "-1")],
        &[],
    );
}

#[test]
fn an_irrational_factor_is_no_finding() {
    assert_eq!(fit(&numbers(), r"(a + b)^2 = \sqrt 3 a^2 + \sqrt 2 a b + b^2", json!({})), None);
}

#[test]
fn what_one_edit_mends_needs_no_fit() {
    let mended: Equation = equation(&top(), &[&motion(["", "-", "-"])], json!({}));
    assert!(!mended.repairs.is_empty());
    assert_eq!(mended.finding.fit, None);
    let sound = equation(&top(), &[&motion(["", "-", "+"])], json!({}));
    assert!(sound.ok && sound.finding.fit.is_none());
}

#[test]
fn the_report_shows_the_terms_on_their_line() {
    let claims = crate::support::with(&top(), "equations", json!({ "1": {} }));
    let notes = crate::support::numbered(&[&motion(["-", "-", "-"])]);
    let found = crate::support::document(&claims, &notes, &onshell::systems::Registry::standard(), None).unwrap();
    let report = Report::new(vec![found]);
    let text = report::text::report(&report, false, report::Style::PLAIN);
    assert_eq!(text.matches("should have the other sign").count(), 2, "{text}");
    let json = report::json::report(&report, &[]);
    let terms = json["documents"][0]["equations"][0]["terms"].as_array().unwrap().clone();
    let place = |term: &Json| {
        notes[term["start"].as_u64().unwrap() as usize..term["end"].as_u64().unwrap() as usize].to_owned()
    };
    let told: Vec<(String, f64)> =
        terms.iter().map(|term| (place(term), term["coefficient"].as_f64().unwrap())).collect();
    let expected = [(r"- \lambda_1 \dot\phi^2 \sin\theta\cos\theta", -1.0), (r"- MgR \sin\theta", -1.0)];
    assert_eq!(told, expected.map(|(place, coefficient)| (place.to_owned(), coefficient)));
}
