//! The report as JSON; its form is a promise, with a number: `"schema": 1`.

use serde_json::{Map, Value, json};

use crate::Error;
use crate::check::kinds::compare::Comparison;
use crate::check::{Counterexample, Document, Equation, Finding, Formula, Inherited, Misfit, Repair, Report};
use crate::formula::text::plain;
use crate::source::{Source, Span};

use super::code;

/// The whole report.
pub fn report(report: &Report, errors: &[Error]) -> Value {
    let mut summary: Map<String, Value> =
        report.counts().into_iter().map(|(verdict, count)| (verdict.to_owned(), json!(count))).collect();
    summary.insert("unexpected".to_owned(), json!(report.unexpected()));
    json!({
        "schema": 1,
        "documents": report.documents.iter().map(document).collect::<Vec<_>>(),
        "errors": errors.iter().map(error).collect::<Vec<_>>(),
        "summary": summary,
    })
}

/// An error. Its place is left out where it is not about a place in a file.
pub fn error(error: &Error) -> Value {
    let mut fields = Map::new();
    fields.insert("code".to_owned(), json!(code::of_error(error)));
    fields.insert("message".to_owned(), json!(error.message()));
    fields.insert("help".to_owned(), json!(error.advice()));
    if let Some((source, span)) = error.place() {
        let (line, column) = source.line_column(span.start);
        fields.insert("path".to_owned(), json!(source.path_at(span.start)));
        fields.insert("file".to_owned(), json!(source.path_at(span.start)));
        fields.insert("line".to_owned(), json!(line));
        fields.insert("column".to_owned(), json!(column));
        fields.insert("span".to_owned(), self::span(source, span));
    }
    Value::Object(fields)
}

/// The whole output of a command that ended with an error.
pub fn failure(error: &Error) -> Value {
    json!({ "schema": 1, "error": self::error(error) })
}

/// A range of bytes of a file, with the place of its first byte.
fn span(source: &Source, span: Span) -> Value {
    let (bytes, (line, column)) = (source.place(span).bytes(), source.line_column(span.start));
    json!({ "start": bytes.start, "end": bytes.end, "line": line, "column": column })
}

fn document(document: &Document) -> Value {
    let of = |item: &Equation| equation(document, item);
    let mut fields = Map::new();
    fields.insert("path".to_owned(), json!(document.path));
    if let Some(claims) = &document.claims {
        fields.insert("claims".to_owned(), json!(claims));
    }
    fields.insert("inferred".to_owned(), json!(document.inferred));
    fields.insert("unnumbered".to_owned(), json!(document.unnumbered));
    fields.insert("equations".to_owned(), document.equations.iter().map(of).collect());
    fields.insert("sentences".to_owned(), document.sentences.iter().map(of).collect());
    Value::Object(fields)
}

/// The column at which an item begins on its line: that of its source, if this begins there too.
fn column(source: &Source, line: usize, latex: &str) -> usize {
    let text = source.text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
    let first = latex.lines().next().unwrap_or_default();
    let ahead = match text.find(first).filter(|_| !first.is_empty()) {
        Some(at) => &text[..at],
        None => &text[..text.len() - text.trim_start().len()],
    };
    ahead.chars().count() + 1
}

fn equation(document: &Document, equation: &Equation) -> Value {
    let source = &document.source;
    let file = source.place(equation.finding.span).file;
    let column = column(file, equation.line, &equation.latex);
    let placed = |mut fields: Map<String, Value>, finding: &Finding| {
        fields.insert("id".to_owned(), json!(equation.id));
        fields.insert("code".to_owned(), json!(code::of_finding(finding)));
        fields.insert("file".to_owned(), json!(file.path));
        fields.insert("line".to_owned(), json!(equation.line));
        fields.insert("column".to_owned(), json!(column));
        fields.insert("span".to_owned(), span(source, finding.span));
        fields
    };
    let fields = fields(source, &equation.latex, &equation.reading, &equation.finding, equation.ok);
    let mut fields = placed(fields, &equation.finding);
    if let Some(numbers) = document.automatic_numbers.get(&equation.id) {
        fields.insert("automatic_numbers".to_owned(), json!(numbers));
    }
    if let Some(because) = &equation.because {
        fields.insert("because".to_owned(), json!(because));
    }
    if !equation.ok {
        fields.insert(
            "repairs".to_owned(),
            equation.repairs.iter().filter_map(|repair| self::repair(source, repair)).collect(),
        );
        fields.insert("elsewhere".to_owned(), json!(equation.elsewhere));
    }
    if !equation.parts.is_empty() {
        let parts = equation.parts.iter().map(|part| {
            let fields = self::fields(source, &part.latex, &part.reading, &part.finding, part.ok);
            Value::Object(placed(fields, &part.finding))
        });
        fields.insert("parts".to_owned(), parts.collect());
    }
    Value::Object(fields)
}

/// An edit of a file; none, where the file cannot be edited so.
fn repair(source: &Source, repair: &Repair) -> Option<Value> {
    let edit = source.edit(repair.span, &repair.replacement).ok()?;
    let bytes = edit.place.bytes();
    Some(json!({
        "start": bytes.start,
        "end": bytes.end,
        "replacement": edit.replacement,
        "slip": repair.slip.word(),
        "verdict": repair.verdict.word(),
        "step": repair.step,
        "of": repair.shared.as_ref().map(|shared| &shared.of),
        "mends": repair.shared.as_ref().map(|shared| &shared.mends),
    }))
}

fn fields(source: &Source, latex: &str, reading: &str, finding: &Finding, ok: bool) -> Map<String, Value> {
    let fields = json!({
        "latex": latex,
        "reading": reading,
        "verdict": finding.verdict.word(),
        "ok": ok,
        "points": finding.points,
        "tried": finding.tried,
        "max_residual": finding.max_residual.map(number),
        "false_accept_log2": finding.false_accept_log2,
        "not_certified_because": finding.not_certified_because,
        "message": finding.message,
        "counterexample": finding.counterexample.as_ref().map(counterexample),
        "difference": finding.difference.as_ref().map(formula),
        "derived": finding.derived.as_ref().map(formula),
        "carried": finding.carried,
        "terms": finding.fit.iter().flat_map(|fit| &fit.terms).map(|term| misfit(source, term)).collect::<Vec<_>>(),
        "missing": finding.fit.iter().flat_map(|fit| &fit.missing).map(formula).collect::<Vec<_>>(),
    });
    let Value::Object(mut fields) = fields else { return Map::new() };
    if let Some(Inherited { from, root }) = &finding.follows_from {
        fields.insert("follows_from".to_owned(), json!({ "equation": from, "root": root }));
    }
    fields
}

fn counterexample(counterexample: &Counterexample) -> Value {
    let state: Map<String, Value> =
        counterexample.state.iter().map(|(name, value)| (name.clone(), number(*value))).collect();
    json!({
        "state": state,
        "lhs": number(counterexample.lhs),
        "rhs": number(counterexample.rhs),
        "entry": counterexample.entry,
    })
}

fn misfit(source: &Source, misfit: &Misfit) -> Value {
    let bytes = source.place(misfit.span).bytes();
    json!({ "start": bytes.start, "end": bytes.end, "coefficient": misfit.coefficient.value() })
}

fn formula(formula: &Formula) -> Value {
    json!({ "latex": formula.latex, "text": formula.text })
}

/// JSON has no infinities and no NaN: those are words.
fn number(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { json!(value.to_string()) }
}

/// The answer of `onshell equal`.
pub fn answer(answer: &Comparison) -> Value {
    json!({
        "schema": 1,
        "equal": super::answer::equal(answer),
        "code": code::of_finding(&answer.finding),
        "verdict": answer.finding.verdict.word(),
        "message": answer.finding.message,
        "readings": answer.readings,
        "assumed": answer.assumed.iter().map(|line| plain(line)).collect::<Vec<_>>(),
        "points": answer.finding.points,
        "tried": answer.finding.tried,
        "max_residual": answer.finding.max_residual.map(number),
        "false_accept_log2": answer.finding.false_accept_log2,
        "not_certified_because": answer.finding.not_certified_because,
        "counterexample": answer.finding.counterexample.as_ref().map(counterexample),
        "difference": answer.finding.difference.as_ref().map(formula),
    })
}
