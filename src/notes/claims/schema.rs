//! The JSON Schema of the claims file, for editors and other programs.
//!
//! The keys are those that the reader knows, so a key cannot be in one and not in the other. The schema says of which JSON type
//! a value is; what a value means is left to the reader, which has better messages.

use serde_json::{Map, Value, json};

use super::{KEYS, claim, sentence};

/// The JSON Schema, draft 2020-12.
#[must_use]
pub fn schema() -> Value {
    let mut document = object(KEYS.iter().map(|key| (*key, of_document(key))), &["notes"]);
    document["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    document["title"] = json!("onshell claims file");
    document["description"] = json!("What the symbols of notes mean, and what their equations claim.");
    let claims = claim::KEYS.iter().map(|key| (*key, of_claim(key)));
    let sentences = sentence::KEYS.iter().chain(sentence::OF).map(|key| (*key, of_sentence(key)));
    document["$defs"] = json!({
        "texts": { "anyOf": [{ "type": "string" }, { "type": "array", "items": { "type": "string" } }] },
        "named": { "type": "object", "additionalProperties": { "type": "string" } },
        "claim": object(claims.clone(), &[]),
        "sentence": object(claims.chain(sentences), &["quote"]),
    });
    document
}

/// An object with these properties and no others.
fn object<'k>(properties: impl Iterator<Item = (&'k str, Value)>, required: &[&str]) -> Value {
    let properties: Map<String, Value> = properties.map(|(key, value)| (key.to_owned(), value)).collect();
    json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
}

fn described(mut schema: Value, description: &str) -> Value {
    schema["description"] = json!(description);
    schema
}

fn text() -> Value {
    json!({ "type": "string" })
}

fn texts() -> Value {
    json!({ "$ref": "#/$defs/texts" })
}

fn named() -> Value {
    json!({ "$ref": "#/$defs/named" })
}

fn of_document(key: &str) -> Value {
    match key {
        "notes" => described(text(), "The path of the notes, relative to this file."),
        "system" => json!({
            "description": "The name of the system whose Lagrangian is taken for true.",
            "anyOf": [text(), { "type": "object" }]
        }),
        "independent variable" => described(text(), "The name of the time, if it is not t."),
        "dissipation" => described(text(), "Rayleigh's dissipation function."),
        "assume" => described(texts(), "Hypotheses of every equation."),
        "coordinates" => described(named(), "The coordinates, each with its range."),
        "varies with time" => described(named(), "Symbols that vary freely with the time, each with its range."),
        "constants" => described(named(), "The constants, each with its range."),
        "functions" => described(named(), "Functions without a formula, each with its arguments: \"of r\"."),
        "formulas as names" => json!({
            "description": "Formulas that stand for one name each, such as a mean value.",
            "type": "object",
            "additionalProperties": { "enum": ["constant", "varies with time", "constant vector", "vector that varies with time", "rate", "given by a display"] }
        }),
        "laws" => described(named(), "Laws, which are taken for granted: the name of each, with an address or LaTeX."),
        "means" => described(named(), "What a name means for the system, as in \"L\": \"Lagrangian\"."),
        "define" => described(named(), "Names that no display defines, each with its formula."),
        "macros" => described(named(), "Macros that are defined elsewhere."),
        "forces" | "constraints" | "indices" | "units" | "guesses" => named(),
        "conditions" => json!({ "type": "object", "additionalProperties": texts() }),
        "steps" => described(texts(), "Derivations, each given by the address of its steps in their order."),
        "equations" => json!({
            "description": "Claims about equations, by their addresses.",
            "type": "object",
            "additionalProperties": { "$ref": "#/$defs/claim" }
        }),
        "sentences" => json!({
            "description": "Claims about sentences of the notes.",
            "type": "array",
            "items": { "$ref": "#/$defs/sentence" }
        }),
        _ => json!({}),
    }
}

fn of_claim(key: &str) -> Value {
    match key {
        "holds" => json!({ "enum": ["always", "on shell"] }),
        "assume" | "throughout" | "small" | "for" => texts(),
        "where" | "symmetry" | "at" => named(),
        "equilibrium" => json!({ "enum": [true, "stable", "unstable", "steady"] }),
        "expect"
        | "because"
        | "skip"
        | "solves"
        | "limit"
        | "dropping"
        | "generates"
        | "for each"
        | "continuum limit of"
        | "same motion as"
        | "secular equation for"
        | "also equals"
        | "units" => text(),
        "order" => json!({ "type": "integer", "minimum": 1 }),
        _ => json!({}),
    }
}

fn of_sentence(key: &str) -> Value {
    match key {
        "name" | "quote" | "in" | "against" | "claim" | "not always" | "of" | "refers to" | "containing" => text(),
        _ => json!({}),
    }
}
