//! What became of mutants, for a terminal and for machines.

use serde_json::{Value, json};

use crate::Error;
use crate::check::mutation::{Mutants, Mutated, Repairs, Survivor};
use crate::source::Source;

/// A line an equation, and every survivor at its place.
pub fn text(documents: &[Mutated]) -> String {
    let mut text = String::new();
    for document in documents {
        text.push_str(&format!("{}\n", document.path));
        let width = document.equations.iter().map(|equation| equation.id.chars().count()).max().unwrap_or(0).min(32);
        for equation in &document.equations {
            text.push_str(&format!("  {}\n", line(equation, width)));
        }
        for equation in &document.equations {
            for survivor in &equation.survivors {
                text.push_str(&format!("  {}\n", slip(&document.source, equation, "survived", survivor)));
            }
        }
        text.push('\n');
    }
    let total = Totals::of(documents);
    if let Some(Repairs { tried, first, offered, .. }) = total.repairs.filter(|repairs| repairs.tried > 0) {
        for document in documents {
            for equation in &document.equations {
                for missed in equation.repairs.iter().flat_map(|repairs| &repairs.missed) {
                    text.push_str(&format!("{}\n", slip(&document.source, equation, "not mended", missed)));
                }
            }
        }
        let share = |count: usize| 100.0 * count as f64 / tried as f64;
        text.push_str(&format!(
            "of {tried} slips that were noticed the first suggestion mends {first} ({:.1} %), one of three {offered} ({:.1} %)\n",
            share(first),
            share(offered)
        ));
    }
    text.push_str(&format!(
        "{} mutants: {} refuted, {} refused, {} equivalent, {} survived\n",
        total.mutants, total.refuted, total.refused, total.equivalent, total.survivors
    ));
    text
}

fn line(equation: &Mutants, width: usize) -> String {
    let id = &equation.id;
    match &equation.left_out {
        Some(why) => format!("· {id:<width$}  left out: {why}"),
        None => {
            let mark = if equation.survivors.is_empty() { "✓" } else { "✗" };
            let (all, survivors) = (equation.count(), equation.survivors.len());
            format!(
                "{mark} {id:<width$}  {all:>4} mutants: {} refuted, {} refused, {} equivalent, {survivors} survived",
                equation.refuted, equation.refused, equation.equivalent
            )
        }
    }
}

fn slip(source: &Source, equation: &Mutants, fate: &str, survivor: &Survivor) -> String {
    let (line, column) = source.line_column(survivor.span.start);
    let change = change(&survivor.original, &survivor.replacement);
    format!(
        "({}) {fate} at {}:{line}:{column}: {change} ({}); {}",
        equation.id,
        source.path,
        survivor.slip.word(),
        survivor.because
    )
}

fn change(old: &str, new: &str) -> String {
    match (old, new.trim()) {
        ("", new) => format!("“{new}” put in"),
        (old, "") => format!("“{old}” left out"),
        (old, new) => format!("“{new}” for “{old}”"),
    }
}

#[derive(Default)]
struct Totals {
    mutants: usize,
    refuted: usize,
    refused: usize,
    equivalent: usize,
    survivors: usize,
    /// If that was asked for.
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

/// How many noticed slips are mended.
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
            "left_out": equation.left_out,
            "repairs": equation.repairs.as_ref().map(repairs),
        })
    };
    json!({ "path": document.path, "equations": document.equations.iter().map(equation).collect::<Vec<_>>() })
}
