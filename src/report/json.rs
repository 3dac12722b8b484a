//! The report as JSON; its form is a promise, with a number: `"schema": 1`.

use serde_json::{Map, Value, json};

use crate::Error;
use crate::check::kinds::compare::Answer;
use crate::check::{Counterexample, Document, Equation, Finding, Formula, Inherited, Misfit, Repair, Report};
use crate::formula::text::plain;

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

/// What could not be checked at all.
pub(super) fn error(error: &Error) -> Value {
    let place = error.place().map(|(source, span)| (source.path.clone(), source.line_column(span.start)));
    json!({
        "message": error.message(),
        "help": error.advice(),
        "path": place.as_ref().map(|(path, _)| path),
        "line": place.as_ref().map(|(_, (line, _))| line),
        "column": place.as_ref().map(|(_, (_, column))| column),
    })
}

fn document(document: &Document) -> Value {
    json!({
        "path": document.path,
        "claims": document.claims,
        "inferred": document.inferred,
        "unnumbered": document.unnumbered,
        "equations": document.equations.iter().map(equation).collect::<Vec<_>>(),
        "sentences": document.sentences.iter().map(equation).collect::<Vec<_>>(),
    })
}

fn equation(equation: &Equation) -> Value {
    let mut fields = fields(&equation.latex, &equation.reading, &equation.finding, equation.ok);
    fields.insert("id".to_owned(), json!(equation.id));
    fields.insert("line".to_owned(), json!(equation.line));
    if let Some(because) = &equation.because {
        fields.insert("because".to_owned(), json!(because));
    }
    if !equation.ok {
        fields.insert("repairs".to_owned(), equation.repairs.iter().map(repair).collect());
        fields.insert("elsewhere".to_owned(), json!(equation.elsewhere));
    }
    if !equation.parts.is_empty() {
        let parts = equation.parts.iter().map(|part| {
            let mut fields = self::fields(&part.latex, &part.reading, &part.finding, part.ok);
            fields.insert("id".to_owned(), json!(equation.id));
            fields.insert("line".to_owned(), json!(equation.line));
            Value::Object(fields)
        });
        fields.insert("parts".to_owned(), parts.collect());
    }
    Value::Object(fields)
}

fn repair(repair: &Repair) -> Value {
    json!({
        "start": repair.span.start,
        "end": repair.span.end,
        "replacement": repair.replacement,
        "slip": repair.slip.word(),
        "verdict": repair.verdict.word(),
        "step": repair.step,
        "of": repair.shared.as_ref().map(|shared| &shared.of),
        "mends": repair.shared.as_ref().map(|shared| &shared.mends),
    })
}

fn fields(latex: &str, reading: &str, finding: &Finding, ok: bool) -> Map<String, Value> {
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
        "terms": finding.fit.iter().flat_map(|fit| &fit.terms).map(misfit).collect::<Vec<_>>(),
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

fn misfit(misfit: &Misfit) -> Value {
    json!({ "start": misfit.span.start, "end": misfit.span.end, "coefficient": misfit.coefficient.value() })
}

fn formula(formula: &Formula) -> Value {
    json!({ "latex": formula.latex, "text": formula.text })
}

/// JSON has no infinities and no NaN: those are words.
fn number(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { json!(value.to_string()) }
}

/// The answer of `onshell equal`.
pub fn answer(answer: &Answer) -> Value {
    json!({
        "schema": 1,
        "equal": match answer.finding.verdict {
            verdict if verdict.passes() => Some(true),
            crate::check::Verdict::Refuted => Some(false),
            _ => None,
        },
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
