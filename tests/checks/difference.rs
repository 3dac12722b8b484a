//! What a refuted equation is off by: the difference of its sides reads as a physicist would write it, and is right.

use onshell::check::{Document, Finding, Options, Report, Verdict};
use onshell::report;
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, equation, numbered, numbers, pendulum, planet, top, with};

/// The finding on an equation that is false.
fn refuted(claims: &Json, latex: &str, claim: Json) -> Finding {
    let finding = equation(claims, &[latex], claim).finding;
    assert_eq!(finding.verdict, Verdict::Refuted, "{latex}: {}", finding.message);
    finding
}

/// A formula is the one that a person wrote down, and no longer.
fn reads_as(shown: &str, written: &str) {
    let answer = onshell::compare(shown, written, &[], Options::default());
    let answer = answer.unwrap_or_else(|error| panic!("{shown} or {written}: {error}"));
    assert!(answer.finding.verdict.passes(), "{shown} is not {written}");
    let [shown, written] = answer.readings.map(|reading| reading.chars().count());
    assert!(shown <= written, "{shown} letters in place of {written}");
}

/// Left side minus right side of a false equation is what a person finds.
fn is_off_by(claims: &Json, latex: &str, written: &str) {
    let difference = refuted(claims, latex, json!({})).difference;
    reads_as(&difference.unwrap_or_else(|| panic!("no difference of {latex}")).latex, written);
}

/// (6.73), with something else for its last term.
fn motion(last: &str) -> String {
    format!(r"\lambda_1 \ddot\theta = \lambda_1 \dot\phi^2 \sin\theta\cos\theta - \dot\phi \sin\theta \, p_\psi {last}")
}

/// (6.77), with something else for its first term, the sign in the bracket, and the last term.
fn hamiltonian(first: &str, sign: &str, last: &str) -> String {
    format!(
        r"H = {first} + \frac{{p_\psi^2}}{{2\lambda_3}} + \frac{{(p_\phi {sign} p_\psi\cos\theta)^2}}{{2\lambda_1\sin^2\theta}} {last}"
    )
}

const KINETIC: &str = r"\frac{p_\theta^2}{2\lambda_1}";

#[test]
fn a_wrong_sign_leaves_twice_the_term() {
    is_off_by(&top(), &motion(r"- MgR \sin\theta"), r"2 M g R \sin\theta");
    is_off_by(&top(), &hamiltonian(KINETIC, "-", r"- MgR\cos\theta"), r"2 M g R \cos\theta");
    is_off_by(&top(), r"p_\psi = \lambda_3 (\dot\psi - \dot\phi\cos\theta)", r"2 \lambda_3 \dot\phi \cos\theta");
    is_off_by(&pendulum(), r"m l^2 \ddot\theta = m g l \sin\theta", r"-2 m g l \sin\theta");
    is_off_by(&planet(), r"r \ddot\phi = 2 \dot r \dot\phi", r"-4 \dot r \dot\phi");
}

#[test]
fn a_sine_for_a_cosine_and_a_lost_factor_are_seen() {
    is_off_by(&top(), &motion(r"+ MgR \cos\theta"), r"M g R (\sin\theta - \cos\theta)");
    is_off_by(&top(), &motion(r"+ 3 MgR \sin\theta"), r"-2 M g R \sin\theta");
    is_off_by(&top(), r"p_\theta = 2 \lambda_1 \dot\theta", r"-\lambda_1 \dot\theta");
    is_off_by(
        &top(),
        &hamiltonian(r"\frac{p_\theta^2}{\lambda_1}", "-", r"+ MgR\cos\theta"),
        r"-\frac{p_\theta^2}{2 \lambda_1}",
    );
    is_off_by(&numbers(), "(a + b)^2 = a^2 + b^2", "2 a b");
}

#[test]
fn what_is_printed_in_momenta_is_off_by_momenta() {
    is_off_by(
        &top(),
        &hamiltonian(KINETIC, "+", r"+ MgR\cos\theta"),
        r"-\frac{2 p_\phi p_\psi \cos\theta}{\lambda_1 \sin^2\theta}",
    );
    is_off_by(
        &top(),
        r"\dot\phi = \frac{p_\phi + p_\psi \cos\theta}{\lambda_1 \sin^2\theta}",
        r"-\frac{2 p_\psi \cos\theta}{\lambda_1 \sin^2\theta}",
    );
}

#[test]
fn an_equation_of_motion_stands_beside_what_was_derived() {
    let derived = refuted(&top(), &motion(r"- MgR \sin\theta"), json!({})).derived.expect("it has one acceleration");
    let (left, right) = derived.latex.split_once(" = ").expect("it is an equation");
    reads_as(left, r"\lambda_1 \ddot\theta");
    reads_as(
        right,
        r"\lambda_1 \dot\phi^2 \sin\theta\cos\theta - \lambda_3 \dot\phi (\dot\psi + \dot\phi\cos\theta) \sin\theta + M g R \sin\theta",
    );
    // the twin: this one is about no acceleration
    assert_eq!(refuted(&top(), r"p_\theta = 2 \lambda_1 \dot\theta", json!({})).derived, None);
}

#[test]
fn what_holds_is_off_by_nothing() {
    for latex in [
        motion(r"+ MgR \sin\theta"),
        hamiltonian(KINETIC, "-", r"+ MgR\cos\theta"),
        r"p_\psi = \lambda_3 (\dot\psi + \dot\phi\cos\theta)".to_owned(),
    ] {
        let finding = equation(&top(), &[&latex], json!({})).finding;
        assert!(finding.verdict.holds(), "{latex}: {}", finding.message);
        assert_eq!((finding.difference, finding.derived), (None, None), "{latex}");
    }
}

#[test]
fn a_vector_is_off_at_the_component_that_fails() {
    let claims = json!({ "constants": { r"\vec a, \vec b": "any" } });
    let finding = refuted(&claims, r"\vec a + \vec b = \vec a - \vec b", json!({}));
    let difference = finding.difference.expect("its components are scalars").text;
    let entry = finding.counterexample.and_then(|counterexample| counterexample.entry).expect("one of them");
    let component = entry.strip_prefix("component ").expect("it is one of three");
    assert!(difference.starts_with("2·(") && difference.ends_with(&format!(")_{component}")), "{difference}");
}

#[test]
fn nothing_is_shown_where_hypotheses_would_be_solved() {
    let latex = motion(r"- MgR \sin\theta");
    let finding = refuted(&top(), &latex, json!({ "assume": r"\dot\phi = \dot\theta" }));
    assert_eq!((finding.difference, finding.derived), (None, None));
    // the twin: an inequality needs no solving
    assert!(refuted(&top(), &latex, json!({ "assume": r"\dot\phi > 0" })).difference.is_some());
}

#[test]
fn nothing_is_shown_that_says_no_more_than_the_equation() {
    assert_eq!(refuted(&numbers(), "a = b", json!({})).difference, None);
}

#[test]
fn a_difference_that_would_be_wrong_is_not_shown() {
    // p = m q̇ + b with m free of velocities gives wrong velocities here, so what comes of it is not shown
    let particle = json!({
        "system": "relativistic_particle",
        "coordinates": { "x": "any" },
        "constants": { "m, c, k": "> 0" },
        "means": { "H": "Hamiltonian" },
    });
    let shown = refuted(&particle, r"H = \frac{p_x^2}{2m}", json!({})).difference;
    assert!(shown.as_ref().is_none_or(|formula| !formula.text.contains("p_x")), "{shown:?}");
}

#[test]
fn a_report_shows_it_of_what_was_not_expected() {
    let claimed = |claim: Json| {
        let claims = with(&pendulum(), "equations", json!({ "1": claim }));
        let notes = numbered(&[r"m l^2 \ddot\theta = m g l \sin\theta"]);
        let found: Document = document(&claims, &notes, &Registry::standard(), None).expect("it is checked");
        Report::new(vec![found])
    };
    let [unexpected, expected] = [json!({}), json!({ "expect": "refuted", "because": "the sign" })].map(claimed);
    let wide = report::Style::new(200, false);
    let says = |text: String| text.contains("left side − right side = −2·m·l·g·sin(θ)") && text.contains("derived: ");
    assert!(says(report::text::report(&unexpected, false, wide)));
    assert!(says(report::text::report(&expected, true, wide)));
    assert!(!says(report::text::report(&expected, false, wide)));
    for found in [unexpected, expected] {
        let item = report::json::report(&found, &[])["documents"][0]["equations"][0].clone();
        reads_as(item["difference"]["latex"].as_str().expect("JSON always has it"), r"-2 m g l \sin\theta");
        assert!(item["derived"]["text"].is_string());
    }
}
