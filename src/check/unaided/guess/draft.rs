//! The inferred claims as a claims file to be corrected: each guess with the reason for it, under `guesses`.

use serde_json::{Map, Value, json};

use crate::Result;
use crate::latex::Macros;
use crate::notes::Notes;

use super::inference;
use crate::check::document::setup::{Run, define_macros};
use crate::check::unaided::with_ids;
use crate::check::usage::{Usage, names_of};

/// A claims file that was inferred.
pub struct Draft {
    /// The text of the file.
    pub text: String,
    /// How many names it declares.
    pub declared: usize,
}

/// The inferred claims of notes as a claims file. A check with it gives the same verdicts as a check without.
///
/// # Errors
/// When no claims file makes sense of the notes.
pub fn draft(run: &Run<'_>, notes: &Notes) -> Result<Draft> {
    let notes = with_ids(notes);
    let claims = inference::claims(run, &notes)?;
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    let usages = names_of(&notes.equations, &macros);
    let keys: Map<String, Value> = serde_json::from_str(&claims.source.text).unwrap_or_default();
    let mut guesses = Map::new();
    let is_declared = |key: &str| !["notes", "guesses"].contains(&key);
    for (role, group) in keys.iter().filter(|(role, _)| is_declared(role)) {
        for (name, value) in group.as_object().into_iter().flatten() {
            let usage = usages.iter().find(|usage| usage.name.to_string() == *name);
            let reason = reason(role, value.as_str().unwrap_or_default(), usage);
            let place = usage.and_then(|usage| notes.equations.get(usage.first));
            let place = place.and_then(|display| display.id()).map(|id| format!("; first in ({id})"));
            guesses.insert(name.clone(), json!(format!("{reason}{}", place.unwrap_or_default())));
        }
    }
    let declared = guesses.len();
    // The keys that a reader looks for first come first.
    let mut lines: Vec<String> = Vec::new();
    let ends = [("notes", keys.get("notes").cloned()), ("guesses", Some(Value::Object(guesses)))];
    let middle =
        keys.iter().filter(|(key, _)| is_declared(key)).map(|(key, value)| (key.as_str(), Some(value.clone())));
    let [first, last] = ends;
    for (key, value) in std::iter::once(first).chain(middle).chain(std::iter::once(last)) {
        let Some(value) = value else { continue };
        lines.push(format!("  {}: {}", json!(key), indented(&value)));
    }
    Ok(Draft { text: format!("{{\n{}\n}}\n", lines.join(",\n")), declared })
}

/// A value of a key, in lines.
fn indented(value: &Value) -> String {
    format!("{value:#}").replace('\n', "\n  ")
}

/// Why a name was declared so: how it stands in the displays.
fn reason(role: &str, range: &str, usage: Option<&Usage>) -> String {
    let moves = "it has a dot or stands under d/dt";
    let role = match role {
        "means" => return format!("the {range}, because a display defines it, and its formula or the text says so"),
        "formulas as names" => return "one quantity, because its parts have no values of their own".to_owned(),
        "functions" => return "a function, because names stand in parentheses after it".to_owned(),
        "coordinates" => format!("a coordinate, because {moves} and the notes print a Lagrangian"),
        "varies with time" if usage.is_some_and(|usage| usage.moves) => format!("varies, because {moves}"),
        "varies with time" if usage.is_some_and(|usage| usage.conserved) => {
            "varies, because a formula with it is said to be constant".to_owned()
        }
        "varies with time" => "varies, because another quantity is written as a function of it or of t".to_owned(),
        "constants" if range == "imaginary unit" => {
            return "√−1, because a formula uses it so, as in e^{iωt}, and it is no quantity or index elsewhere"
                .to_owned();
        }
        "constants" => "a constant, because nothing says that it varies".to_owned(),
        other => format!("{other}, as the notes suggest"),
    };
    let range = match range {
        "angle" => ", and an angle, because it stands alone in a sine or cosine",
        "(1, 3)" => ", and more than 1, because it stands in an exponent as the ratio of two heat capacities does",
        "> 0" if !usage.is_some_and(|usage| usage.positive) => {
            ", and positive, because it has a power, or because another quantity with this letter is positive"
        }
        "> 0" => ", and positive, because it stands under a root, in a denominator or in a logarithm",
        _ => "",
    };
    format!("{role}{range}")
}
