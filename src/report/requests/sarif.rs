//! SARIF 2.1.0, the format of code scanning: each problem with its region, and the repairs as fixes.
//!
//! Columns count UTF-16 code units, as SARIF does by default. Byte ranges are those of the file.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use crate::Error;
use crate::check::Report;
use crate::code::Code;
use crate::source::Place;

use super::problem::{self, Problem};

/// The log of one run.
pub fn report(report: &Report, errors: &[Error]) -> Value {
    let problems = problem::all(report, errors);
    let codes: BTreeSet<Code> = problems.iter().map(|problem| problem.code).collect();
    let codes: Vec<Code> = codes.into_iter().collect();
    let rules: Vec<Value> = codes.iter().map(|code| rule(*code)).collect();
    let results: Vec<Value> = problems.iter().map(|problem| result(problem, &codes)).collect();
    json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": { "name": "onshell", "version": env!("CARGO_PKG_VERSION"), "rules": rules } },
            "columnKind": "utf16CodeUnits",
            "results": results,
        }],
    })
}

fn rule(code: Code) -> Value {
    let text = code.explanation().trim();
    let first = text.lines().next().unwrap_or_default().trim();
    json!({
        "id": code.word(),
        "shortDescription": { "text": first },
        "help": { "text": text, "markdown": text },
    })
}

fn result(problem: &Problem<'_>, codes: &[Code]) -> Value {
    let help = problem.help.map(|help| format!(". {help}")).unwrap_or_default();
    let mut result = json!({
        "ruleId": problem.code.word(),
        "ruleIndex": codes.iter().position(|code| *code == problem.code),
        "level": "error",
        "message": { "text": format!("{}{help}", problem.message) },
    });
    if let Some(place) = &problem.place {
        result["locations"] = json!([{
            "physicalLocation": { "artifactLocation": artifact(place), "region": region(place) },
        }]);
    }
    let fixes = problem.edits.iter().map(|(edit, verdict)| {
        json!({
            "description": { "text": format!("With this edit the verdict would be {verdict}") },
            "artifactChanges": [{
                "artifactLocation": artifact(&edit.place),
                "replacements": [{
                    "deletedRegion": region(&edit.place),
                    "insertedContent": { "text": edit.replacement },
                }],
            }],
        })
    });
    let fixes: Vec<Value> = fixes.collect();
    if !fixes.is_empty() {
        result["fixes"] = json!(fixes);
    }
    result
}

/// A path as a relative reference: what is no letter, digit or plain mark is written in hexadecimal digits.
fn artifact(place: &Place<'_>) -> Value {
    let path = place.file.path.replace('\\', "/");
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let uri: String = path
        .bytes()
        .map(|byte| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") })
        .collect();
    let uri = if path.starts_with('/') { format!("file://{uri}") } else { uri };
    json!({ "uri": uri })
}

/// Lines and columns from 1, and bytes from 0.
fn region(place: &Place<'_>) -> Value {
    let ((start_line, _), (end_line, _)) = (place.line_column(), place.end_line_column());
    let bytes = place.bytes();
    json!({
        "startLine": start_line,
        "startColumn": column(place, place.span.start),
        "endLine": end_line,
        "endColumn": column(place, place.span.end),
        "byteOffset": bytes.start,
        "byteLength": bytes.end - bytes.start,
    })
}

/// The column of a byte in UTF-16 code units.
fn column(place: &Place<'_>, at: usize) -> usize {
    let before = place.file.text.get(..at).unwrap_or_default();
    let line = before.rfind('\n').map_or(before, |end| &before[end + 1..]);
    line.encode_utf16().count() + 1
}
