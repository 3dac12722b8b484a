//! A lecture for programs: the passages in order, and the notes with their claims file.

use serde_json::{Value, json};

use super::{Lecture, Passage};

/// The lecture as JSON.
pub fn value(lecture: &Lecture) -> Value {
    let passage = |passage: &Passage| match passage {
        Passage::Heading(text) => json!({ "heading": text }),
        Passage::Sentence(text) => json!({ "sentence": text }),
        Passage::Line(line) => {
            let equation = lecture.equation(line);
            json!({
                "line": line.number,
                "latex": equation.map(|item| item.latex.trim()),
                "text": equation.map(|item| item.reading.as_str()),
                "from": line.from,
                "verdict": equation.map(|item| item.finding.verdict.word()),
                "false_accept_log2": equation.and_then(|item| item.finding.false_accept_log2),
                "values": line.values,
            })
        }
    };
    let sample: serde_json::Map<String, Value> =
        lecture.sample.drawn.iter().map(|(name, value)| (name.clone(), json!(value))).collect();
    json!({
        "schema": 1,
        "system": lecture.name,
        "sample": sample,
        "steps": lecture.passages.iter().map(passage).collect::<Vec<_>>(),
        "notes": lecture.notes,
        "claims": lecture.claims,
    })
}
