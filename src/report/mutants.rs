//! What became of mutants, for people and for machines.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::Error;
use crate::check::mutation::{LeftOut, Mutants, Mutated, Repairs, Survivor};
use crate::source::Source;

use super::style::{Style, columns};
use super::wrap::wrap;

/// A list has so many columns for the numbers of equations.
const WIDEST_NUMBER: usize = 12;

/// The report for people: every survivor at its place, the rest counted; `verbose` lists every equation.
pub fn text(documents: &[Mutated], verbose: bool, style: Style) -> String {
    let mut text = String::new();
    let mut tell = |first: &str, line: &str, indent: usize| {
        text.push_str(&(wrap(first, line, indent, style.width) + "\n"));
    };
    for document in documents {
        match verbose {
            true => {
                tell(&document.path, "", 2);
                let ids = document.equations.iter().map(|equation| columns(&equation.id));
                let width = ids.max().unwrap_or(0).min(WIDEST_NUMBER);
                for equation in &document.equations {
                    let first = format!("  {} {:<width$}  ", mark(equation), equation.id);
                    tell(&first, &line(equation), 8);
                }
            }
            false => tell(&format!("{}: ", document.path), &counted(document), 2),
        }
        for equation in &document.equations {
            for survivor in &equation.survivors {
                tell("  ", &slip(&document.source, equation, "survived", survivor), 6);
            }
        }
        if verbose {
            tell("", "", 0);
        }
    }
    let total = Totals::of(documents);
    if let Some(Repairs { tried, first, offered, .. }) = total.repairs.filter(|repairs| repairs.tried > 0) {
        for document in documents {
            for equation in &document.equations {
                for missed in equation.repairs.iter().flat_map(|repairs| &repairs.missed) {
                    tell("", &slip(&document.source, equation, "was not corrected", missed), 4);
                }
            }
        }
        let share = |count: usize| 100.0 * count as f64 / tried as f64;
        let line = format!(
            "the first suggestion corrects {first} of {tried} detected mistakes ({:.1}\u{a0}%), one of the first \
             three suggestions corrects {offered} ({:.1}\u{a0}%)",
            share(first),
            share(offered)
        );
        tell("", &line, 2);
    }
    if !verbose {
        tell("", "", 0);
    }
    tell("", &figures([total.mutants, total.refuted, total.refused, total.equivalent, total.survivors]), 2);
    text
}

/// How many mutants there are, and what became of them.
fn figures([mutants, refuted, refused, equivalent, survived]: [usize; 5]) -> String {
    format!(
        "{mutants}\u{a0}mutants: {refuted}\u{a0}refuted, {refused}\u{a0}refused, {equivalent}\u{a0}equivalent, {survived}\u{a0}survived"
    )
}

/// A document in one line.
fn counted(document: &Mutated) -> String {
    let own = Totals::of(std::slice::from_ref(document));
    let figures = figures([own.mutants, own.refuted, own.refused, own.equivalent, own.survivors]);
    match left_out(document) {
        None => figures,
        Some(left_out) => format!("{figures}; {left_out}"),
    }
}

/// How many equations of a document were left out, and why.
fn left_out(document: &Mutated) -> Option<String> {
    let mut reasons: BTreeMap<LeftOut, usize> = BTreeMap::new();
    for reason in document.equations.iter().filter_map(|equation| equation.left_out) {
        *reasons.entry(reason).or_insert(0) += 1;
    }
    let reason = |(reason, count): (&LeftOut, &usize)| match reason {
        LeftOut::Skipped => format!("{count}\u{a0}skipped"),
        LeftOut::ExpectedNotToPass => format!("{count}\u{a0}expected\u{a0}not\u{a0}to\u{a0}pass"),
        LeftOut::DoesNotPass(verdict) => format!("{count}\u{a0}{verdict}"),
    };
    let listed = reasons.iter().map(reason).collect::<Vec<_>>().join(", ");
    match reasons.values().sum::<usize>() {
        0 => None,
        1 => Some(format!("1 equation was left out: {listed}")),
        n => Some(format!("{n} equations were left out: {listed}")),
    }
}

fn mark(equation: &Mutants) -> &'static str {
    match &equation.left_out {
        Some(_) => "·",
        None if equation.survivors.is_empty() => "✓",
        None => "✗",
    }
}

fn line(equation: &Mutants) -> String {
    match &equation.left_out {
        Some(why) => format!("left out: {why}"),
        None => {
            let survived = equation.survivors.len();
            figures([equation.count(), equation.refuted, equation.refused, equation.equivalent, survived])
        }
    }
}

fn slip(source: &Source, equation: &Mutants, fate: &str, survivor: &Survivor) -> String {
    let (line, column) = source.line_column(survivor.span.start);
    let change = change(&survivor.original, &survivor.replacement);
    format!(
        "mutant of ({}) {fate} at {}:{line}:{column}: {change} ({}); {}",
        equation.id,
        source.path_at(survivor.span.start),
        survivor.slip.word(),
        survivor.because
    )
}

/// The change of one text into another, as a phrase.
pub fn change(old: &str, new: &str) -> String {
    match (old, new.trim()) {
        ("", new) => format!("“{new}” added"),
        (old, "") => format!("“{old}” left out"),
        (old, new) => format!("“{new}” in place of “{old}”"),
    }
}

#[derive(Default)]
struct Totals {
    mutants: usize,
    refuted: usize,
    refused: usize,
    equivalent: usize,
    survivors: usize,
    /// What the suggestions correct, where that was asked for.
    repairs: Option<Repairs>,
}

impl Totals {
    fn of(documents: &[Mutated]) -> Totals {
        documents.iter().flat_map(|document| &document.equations).fold(Totals::default(), |total, equation| Totals {
            mutants: total.mutants + equation.count(),
            refuted: total.refuted + equation.refuted,
            refused: total.refused + equation.refused,
            equivalent: total.equivalent + equation.equivalent,
            survivors: total.survivors + equation.survivors.len(),
            repairs: match (total.repairs, &equation.repairs) {
                (Some(sum), Some(own)) => Some(Repairs {
                    tried: sum.tried + own.tried,
                    first: sum.first + own.first,
                    offered: sum.offered + own.offered,
                    missed: Vec::new(),
                }),
                (sum, own) => sum.or_else(|| own.clone()),
            },
        })
    }
}

/// The same as JSON.
pub fn json(documents: &[Mutated], errors: &[Error]) -> Value {
    let total = Totals::of(documents);
    json!({
        "schema": 1,
        "documents": documents.iter().map(document).collect::<Vec<_>>(),
        "errors": errors.iter().map(super::json::error).collect::<Vec<_>>(),
        "summary": {
            "mutants": total.mutants,
            "refuted": total.refuted,
            "refused": total.refused,
            "equivalent": total.equivalent,
            "survivors": total.survivors,
            "repairs": total.repairs.as_ref().map(counts),
        },
    })
}

/// How many detected mistakes the suggestions correct.
fn counts(repairs: &Repairs) -> Value {
    json!({ "noticed": repairs.tried, "first": repairs.first, "offered": repairs.offered })
}

fn document(document: &Mutated) -> Value {
    let survivor = |survivor: &Survivor| {
        let (line, column) = document.source.line_column(survivor.span.start);
        json!({
            "start": survivor.span.start,
            "end": survivor.span.end,
            "line": line,
            "column": column,
            "original": survivor.original,
            "replacement": survivor.replacement,
            "slip": survivor.slip.word(),
            "because": survivor.because,
        })
    };
    let repairs = |repairs: &Repairs| {
        let mut all = counts(repairs);
        all["missed"] = repairs.missed.iter().map(survivor).collect();
        all
    };
    let equation = |equation: &Mutants| {
        json!({
            "id": equation.id,
            "line": equation.line,
            "mutants": equation.count(),
            "refuted": equation.refuted,
            "refused": equation.refused,
            "equivalent": equation.equivalent,
            "survivors": equation.survivors.iter().map(survivor).collect::<Vec<_>>(),
            "left_out": equation.left_out.map(|why| why.to_string()),
            "repairs": equation.repairs.as_ref().map(repairs),
        })
    };
    json!({ "path": document.path, "equations": document.equations.iter().map(equation).collect::<Vec<_>>() })
}
