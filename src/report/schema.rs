//! The JSON Schema of the report of `onshell check --format json`.
//!
//! [`super::json`] writes the report, and the tests hold every report against this schema.

use serde_json::{Value, json};

use crate::check::Verdict;

/// The JSON Schema, draft 2020-12. New fields may come at any time, so other fields are allowed.
#[must_use]
pub fn report() -> Value {
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "onshell report",
        "description": "What `onshell check --format json` prints.",
        "type": "object",
        "properties": {
            "schema": { "const": 1 },
            "documents": { "type": "array", "items": { "$ref": "#/$defs/document" } },
            "errors": { "type": "array", "items": { "$ref": "#/$defs/error" } },
            "summary": { "type": "object", "additionalProperties": count() },
            "error": { "$ref": "#/$defs/error" }
        },
        "required": ["schema"],
        "$defs": definitions()
    })
}

fn number() -> Value {
    json!({ "description": "Infinity and NaN are written as strings.", "type": ["number", "string"] })
}

fn count() -> Value {
    json!({ "type": "integer", "minimum": 0 })
}

fn nullable(schema: Value) -> Value {
    json!({ "anyOf": [schema, { "type": "null" }] })
}

fn verdicts() -> Value {
    json!(Verdict::ALL.iter().map(|verdict| verdict.word()).collect::<Vec<_>>())
}

/// The parts of a report, by their names.
fn definitions() -> Value {
    let place = json!({
        "type": "object",
        "properties": { "start": count(), "end": count(), "line": count(), "column": count() },
        "required": ["start", "end", "line", "column"]
    });
    json!({
        "span": place,
        "document": {
            "type": "object",
            "properties": {
                "path": { "type": "string" },
                "claims": { "type": "string" },
                "inferred": { "type": "array", "items": { "type": "string" } },
                "unnumbered": count(),
                "equations": { "type": "array", "items": { "$ref": "#/$defs/finding" } },
                "sentences": { "type": "array", "items": { "$ref": "#/$defs/finding" } }
            },
            "required": ["path", "inferred", "unnumbered", "equations", "sentences"]
        },
        "finding": {
            "type": "object",
            "properties": finding(),
            "required": ["id", "code", "file", "line", "column", "span", "latex", "reading", "verdict", "ok", "message"]
        },
        "counterexample": {
            "type": "object",
            "properties": {
                "state": { "type": "object", "additionalProperties": number() },
                "lhs": number(),
                "rhs": number(),
                "entry": nullable(json!({ "type": "string" }))
            },
            "required": ["state", "lhs", "rhs"]
        },
        "repair": {
            "description": "An edit of the file: the bytes from start to end become the replacement.",
            "type": "object",
            "properties": {
                "start": count(),
                "end": count(),
                "replacement": { "type": "string" },
                "slip": { "type": "string" },
                "verdict": { "enum": verdicts() },
                "step": { "type": "boolean" }
            },
            "required": ["start", "end", "replacement", "slip", "verdict"]
        },
        "error": {
            "type": "object",
            "properties": {
                "code": { "type": "string" },
                "message": { "type": "string" },
                "help": nullable(json!({ "type": "string" })),
                "file": { "type": "string" },
                "line": count(),
                "column": count(),
                "span": { "$ref": "#/$defs/span" }
            },
            "required": ["code", "message"]
        }
    })
}

/// The fields of a finding, which is that of an equation, of one of its parts, or of a sentence.
fn finding() -> Value {
    let formula = json!({
        "type": "object",
        "properties": { "latex": { "type": "string" }, "text": { "type": "string" } },
        "required": ["latex", "text"]
    });
    json!({
        "id": { "type": "string" },
        "code": { "type": "string" },
        "file": { "type": "string" },
        "line": count(),
        "column": count(),
        "span": { "$ref": "#/$defs/span" },
        "latex": { "type": "string" },
        "reading": { "type": "string" },
        "verdict": { "enum": verdicts() },
        "ok": { "type": "boolean" },
        "points": count(),
        "tried": count(),
        "max_residual": nullable(number()),
        "false_accept_log2": nullable(json!({ "type": "number" })),
        "not_certified_because": nullable(json!({ "type": "string" })),
        "message": { "type": "string" },
        "counterexample": nullable(json!({ "$ref": "#/$defs/counterexample" })),
        "difference": nullable(formula.clone()),
        "derived": nullable(formula.clone()),
        "missing": { "type": "array", "items": formula },
        "repairs": { "type": "array", "items": { "$ref": "#/$defs/repair" } },
        "elsewhere": { "type": "array", "items": { "type": "string" } },
        "parts": { "type": "array", "items": { "$ref": "#/$defs/finding" } }
    })
}
