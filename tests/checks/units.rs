//! Units in documents: a term that does not fit makes its statement unreadable.

use onshell::check::Verdict::{Law, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, equation, numbered, outcome, pendulum, verdict, with};

#[test]
fn in_a_document_a_conflict_is_unreadable_at_its_term() {
    let claims = with(&pendulum(), "units", json!({ "l": "m", "g": "m/s^2", "m": "kg" }));
    let energy = r"E = \frac12 m l^2 \dot\theta^2 - m g l \cos\theta";
    assert_eq!(verdict(&claims, &[energy], json!({})), Verified);
    let lost = equation(&claims, &[r"E = \frac12 m l^2 \dot\theta^2 - m g \cos\theta"], json!({}));
    assert_eq!((lost.finding.verdict, lost.finding.points), (Unreadable, 0));
    assert!(lost.finding.message.contains("“m·g·cos(θ)” is in kg m s⁻²"), "{}", lost.finding.message);
    // What an earlier equation taught is said to come from there.
    let later = equation(&claims, &[energy, r"T = E \dot\theta", r"T = U"], json!({}));
    assert_eq!(later.finding.verdict, onshell::check::Verdict::Refuted);
    let later = equation(&claims, &[energy, r"E = m g"], json!({}));
    assert!(later.finding.message.ends_with("units inferred from (1)"), "{}", later.finding.message);
    // Without declared units nothing is checked.
    assert_ne!(verdict(&pendulum(), &[r"E = m g"], json!({})), Unreadable);
}

#[test]
fn an_equation_whose_units_are_off_neither_fails_nor_teaches() {
    let claims = with(&pendulum(), "units", json!({ "l": "m", "g": "m/s^2", "m": "kg" }));
    // In natural units: l = 1.
    let natural = r"\ddot\theta = - g \sin\theta";
    assert_eq!(verdict(&claims, &[natural], json!({})), Unreadable);
    assert_eq!(verdict(&claims, &[natural], json!({ "units": "off", "assume": "l = 1" })), Verified);
    let both = [r"E = m g", r"E = \frac12 m l^2 \dot\theta^2 - m g l \cos\theta"];
    let off = |claim: Json| {
        let claims = with(&claims, "equations", json!({ "1": claim }));
        outcome(&document(&claims, &numbered(&both), &Registry::standard(), Some("2")).unwrap().equations[0].finding)
    };
    assert_eq!(off(json!({ "units": "off" })), Verified);
    assert_eq!(off(json!({ "expect": "refuted", "because": "it is wrong" })), Verified);
    assert_eq!(off(json!({ "holds": "always" })), Unreadable);
}

#[test]
fn units_that_cannot_be_are_errors_at_their_place() {
    for (units, define, place, words) in [
        (json!({ "l": "metre" }), r"\dot\theta", "metre", "write m"),
        (json!({ "l": "kg m/s/s" }), r"\dot\theta", "/s/s", "may divide by the next unit only"),
        (json!({ "l, k": "m" }), r"\dot\theta", "k", "there is no symbol k"),
        (json!({ "l": "m", r"\Omega": "1/s" }), r"\ddot\theta", r#""\\ddot\\theta""#, "s⁻²"),
        (json!({ "l": "m" }), r"\dot\theta + l", r#""\\dot\\theta + l""#, "they cannot be added"),
    ] {
        let claims = with(&with(&pendulum(), "define", json!({ r"\Omega": define })), "units", units);
        let error = document(&claims, &numbered(&[r"T = T"]), &Registry::standard(), None).unwrap_err();
        let (source, span) = error.place().unwrap();
        assert_eq!(source.slice(span), place, "{error}");
        assert!(error.to_string().contains(words), "{error}");
    }
    let sound =
        with(&with(&pendulum(), "define", json!({ r"\Omega": r"\dot\theta" })), "units", json!({ r"\Omega": "Hz" }));
    assert!(document(&sound, &numbered(&[r"T = T"]), &Registry::standard(), None).is_ok());
}

/// A mass on a spring that obeys a law, with units.
fn spring(law: &str) -> Json {
    json!({
        "varies with time": { "x": "any" },
        "constants": { "m, k, b": "> 0" },
        "laws": { "the force": law },
        "units": { "x": "m", "m": "kg", "k": "kg/s^2", "b": "kg" },
    })
}

#[test]
fn a_law_whose_units_are_off_is_named_as_such_wherever_it_is_given() {
    let report = |claim: Json| {
        let claims = with(&spring("1"), "equations", json!({ "1": claim }));
        let notes = numbered(&[r"m \ddot x = -k x - b x", r"\ddot x = -\frac{k x + b x}{m}"]);
        let found = document(&claims, &notes, &Registry::standard(), None).unwrap();
        found
            .equations
            .into_iter()
            .map(|equation| (outcome(&equation.finding), equation.finding.message))
            .collect::<Vec<_>>()
    };
    let off = report(json!({ "units": "off" }));
    assert_eq!(
        off[0],
        (Law, "taken for granted, not checked: the law “the force” (its units are not checked)".to_owned())
    );
    let checked = report(json!({}));
    assert_eq!(checked[0].0, Unreadable, "{checked:?}");
    assert!(checked[0].1.contains("“b·x”"), "{checked:?}");
    // What stands on it, its own units off, says on what.
    let claims = with(&spring("1"), "equations", json!({ "1": { "units": "off" }, "2": { "units": "off" } }));
    let notes = numbered(&[r"m \ddot x = -k x - b x", r"\ddot x = -\frac{k x + b x}{m}"]);
    let found = document(&claims, &notes, &Registry::standard(), None).unwrap();
    let message = &found.equations[1].finding.message;
    assert!(message.contains("by the law “the force” (its units are not checked)"), "{message}");
}

#[test]
fn what_the_claims_file_takes_for_granted_has_units_too() {
    let check =
        |claims: &Json| document(claims, &numbered(&[r"\ddot x = -\frac{k}{m} x"]), &Registry::standard(), None);
    let refused = |claims: &Json, place: &str| {
        let error = check(claims).map(|_| ()).unwrap_err();
        let (source, span) = error.place().unwrap();
        assert_eq!(source.slice(span), place, "{error}");
        assert!(error.to_string().contains("“b·x”"), "{error}");
    };
    assert_eq!(outcome(&check(&spring(r"m \ddot x = -k x")).unwrap().equations[0].finding), Verified);
    refused(&spring(r"m \ddot x = -k x - b x"), r#""m \\ddot x = -k x - b x""#);
    let sound = spring(r"m \ddot x = -k x");
    refused(&with(&sound, "assume", json!(["k x = b x"])), r#""k x = b x""#);
    refused(&with(&sound, "conditions", json!({ "odd": "k x = b x" })), r#""k x = b x""#);
    refused(&with(&sound, "equations", json!({ "1": { "throughout": "k x = b x" } })), r#""k x = b x""#);
    let off = with(&sound, "equations", json!({ "1": { "assume": "x = 1", "units": "off" } }));
    assert!(check(&off).is_ok());
}

#[test]
fn a_sentence_has_units_too() {
    let claims = with(&pendulum(), "units", json!({ "l": "m", "g": "m/s^2", "m": "kg" }));
    let says = |latex: &str| {
        let claims = with(&claims, "sentences", json!([{ "quote": "So it is.", "not always": latex }]));
        let found = document(&claims, "So it is.\n\n$$ T = T $$\n", &Registry::standard(), None);
        outcome(&found.unwrap_or_else(|error| panic!("{error}")).sentences[0].finding)
    };
    assert_eq!(says(r"g l = g \cos\theta"), Unreadable);
    assert_eq!(says(r"g l = g l \cos\theta"), Verified);
}
