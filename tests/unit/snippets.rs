//! Single formulas as people write them: each evaluates to the number that a person would compute, or is refused.
//!
//! The values in `snippets.json` were computed outside of this project, from a translation by hand.

use onshell::formula::{Assignment, Symbols, Value, evaluate};
use onshell::latex::{Macros, names, read_formula};
use serde_json::Value as Json;

/// Reads and evaluates; `Err` is a refusal.
fn value(latex: &str, set: &serde_json::Map<String, Json>) -> Result<f64, String> {
    let mut symbols = Symbols::open();
    let expr = read_formula(latex, &mut symbols, &Macros::default()).map_err(|fault| fault.message)?;
    let given: Vec<(onshell::formula::SymbolId, u8, f64)> = set
        .iter()
        .filter_map(|(name, value)| {
            let (name, dots) = names::parse(name).unwrap_or_else(|| panic!("{name} is no name"));
            let (id, _) = symbols.find(&name)?;
            Some((id, dots, value.as_f64().unwrap()))
        })
        .collect();
    let mut assignment = Assignment::new(&symbols);
    for (id, dots, value) in given {
        assignment.set(id, dots, value);
    }
    match evaluate(&expr, &assignment, &[]) {
        Ok(Value::Scalar(value)) if !value.value().is_finite() => Err("not a number".into()),
        Ok(Value::Scalar(value)) => Ok(value.value()),
        other => Err(format!("{other:?}")),
    }
}

#[test]
fn snippets_evaluate_to_the_right_number_or_are_refused() {
    let text = include_str!("snippets.json");
    let snippets: Vec<Json> = serde_json::from_str(text).unwrap();
    assert!(snippets.len() >= 50);
    let empty = serde_json::Map::new();
    let mut wrong = Vec::new();
    for snippet in &snippets {
        let latex = snippet["latex"].as_str().unwrap();
        let set = snippet.get("set").and_then(Json::as_object).unwrap_or(&empty);
        let found = value(latex, set);
        let near = |expected: &Json| {
            let expected = expected.as_f64().unwrap();
            found.as_ref().is_ok_and(|found| (found - expected).abs() <= 1e-12 * expected.abs().max(1.0))
        };
        let right = if let Some(expected) = snippet.get("value") {
            near(expected)
        } else if let Some(expected) = snippet.get("value_or_refused") {
            found.is_err() || near(expected)
        } else {
            found.is_err()
        };
        if !right {
            wrong.push(format!("{latex}: {found:?}, in place of {snippet}"));
        }
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), snippets.len(), wrong.join("\n"));
}
