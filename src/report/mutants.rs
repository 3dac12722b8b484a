//! What became of mutants, for a terminal and for machines.

use serde_json::{Value, json};

use crate::Error;
use crate::check::mutate::{Mutants, Mutated, Repairs, Survivor};
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
    if total.repairs.tried > 0 {
        for document in documents {
            for equation in &document.equations {
                for missed in &equation.repairs.missed {
                    text.push_str(&format!("{}\n", slip(&document.source, equation, "not mended", missed)));
                }
            }
        }
        let Repairs { tried, first, offered, .. } = total.repairs;
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
    repairs: Repairs,
}

impl Totals {
    fn of(documents: &[Mutated]) -> Totals {
        documents.iter().flat_map(|document| &document.equations).fold(Totals::default(), |total, equation| Totals {
            mutants: total.mutants + equation.count(),
            refuted: total.refuted + equation.refuted,
            refused: total.refused + equation.refused,
            equivalent: total.equivalent + equation.equivalent,
            survivors: total.survivors + equation.survivors.len(),
            repairs: Repairs {
                tried: total.repairs.tried + equation.repairs.tried,
                first: total.repairs.first + equation.repairs.first,
                offered: total.repairs.offered + equation.repairs.offered,
                missed: Vec::new(),
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
        },
    })
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
        })
    };
    json!({ "path": document.path, "equations": document.equations.iter().map(equation).collect::<Vec<_>>() })
}
