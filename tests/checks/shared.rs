//! One slip in what several equations stand on, and the edit of it that mends them all.

use onshell::check::{Document, Equation};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered};

/// A rocket, by Meshchersky's law.
fn rocket() -> Json {
    json!({
        "varies with time": { "m": "> 0", "v, F": "any" },
        "constants": { "u": "> 0" },
        "define": { "P": "m v" },
        "laws": { "the rocket": "1" },
    })
}

const LAW: &str = r"m \dot v = -\dot m u + F";
const MOMENTUM: &str = r"\frac{dP}{dt} = \dot m (v - u) + F";
const TSIOLKOVSKY: &str = r"\frac{d}{dt} (v + u \ln m) = \frac{F}{m}";

fn checked(claims: &Json, displays: &[&str]) -> Document {
    document(claims, &numbered(displays), &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"))
}

/// What the first suggestion for each wrong equation changes, and what it mends.
fn shared(document: &Document) -> Vec<Option<(&str, Vec<&str>)>> {
    let wrong = document.equations.iter().filter(|equation| !equation.ok);
    wrong
        .map(|equation| {
            let shared = equation.repairs.first()?.shared.as_ref()?;
            Some((shared.of.as_str(), shared.mends.iter().map(String::as_str).collect()))
        })
        .collect()
}

/// The notes with the first suggestion for the first equation that has one made.
fn mended(document: &Document) -> String {
    let repair = document.equations.iter().find_map(|equation: &Equation| equation.repairs.first());
    let repair = repair.expect("there is a suggestion");
    let mut text = document.source.text.clone();
    text.replace_range(repair.span.range(), &repair.replacement);
    text
}

#[test]
fn a_slip_in_a_law_is_mended_in_the_law() {
    for slip in [r"m \dot v = \dot m u + F", r"m \dot v = -\dot m u - F", r"m v = -\dot m u + F"] {
        let found = checked(&rocket(), &[slip, MOMENTUM, TSIOLKOVSKY]);
        assert_eq!(shared(&found), vec![Some(("1", vec!["2", "3"])); 2], "{slip}");
        let again = document(&rocket(), &mended(&found), &Registry::standard(), None);
        assert!(again.is_ok_and(|again| again.equations.iter().all(|equation| equation.ok)), "{slip}");
    }
    // The twin: of two slips that have nothing in common each is mended where it is.
    let momentum = r"\frac{dP}{dt} = \dot m (v + u) + F";
    let tsiolkovsky = r"\frac{d}{dt} (v + u \ln m) = \frac{m}{F}";
    let found = checked(&rocket(), &[LAW, momentum, tsiolkovsky]);
    assert_eq!(shared(&found), [None, None]);
    assert_eq!(mended(&found), numbered(&[LAW, MOMENTUM, tsiolkovsky]));
}

#[test]
fn what_holds_speaks_for_the_law() {
    // Two equations with the same wrong sign could be mended by one in the law, and a third would fail then.
    let momentum = r"\frac{dP}{dt} = \dot m (v + u) + F";
    let tsiolkovsky = r"\frac{d}{dt} (v - u \ln m) = \frac{F}{m}";
    let energy = r"m v \dot v = F v - \dot m u v";
    let found = checked(&rocket(), &[LAW, momentum, tsiolkovsky]);
    assert_eq!(shared(&found), vec![Some(("1", vec!["2", "3"])); 2]);
    let found = checked(&rocket(), &[LAW, momentum, tsiolkovsky, energy]);
    assert_eq!(shared(&found), [None, None]);
}

#[test]
fn a_slip_in_what_a_name_means_is_mended_there() {
    let claims = json!({ "constants": { "a, b": "> 0" } });
    let uses = [r"s + 2ab = (a + b)^2", r"s - 2ab = (a - b)^2"];
    let found = checked(&claims, &["s = a^2 - b^2", uses[0], uses[1]]);
    let wrong: Vec<_> = shared(&found).into_iter().flatten().collect();
    assert_eq!(wrong, vec![("1", vec!["2", "3"]); 2]);
    assert_eq!(mended(&found), numbered(&["s = a^2 + b^2", uses[0], uses[1]]));
}
