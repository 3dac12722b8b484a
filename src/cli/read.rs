//! `onshell read`: how a formula is understood.

use std::sync::Arc;

use serde_json::json;

use crate::Error;
use crate::check::define_macros;
use crate::formula::symbols::Kind;
use crate::formula::{Statement, Symbols, text};
use crate::latex::{Macros, read_display};
use crate::notes::{MacroDefinition, definitions};
use crate::report::{self, wrap};
use crate::source::Source;

use super::outcome::{Format, Outcome, Screen, shown};

/// Prints how a formula or an equation is understood
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell read '\\frac12 m v^2'")]
pub struct Arguments {
    /// The formula, in LaTeX; definitions of macros may stand before it
    #[arg(allow_hyphen_values = true)]
    formula: String,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments, screen: Screen) -> Outcome {
    let mut symbols = Symbols::for_reading();
    let mut macros = Macros::default();
    let definitions = definitions(&arguments.formula);
    define_macros(&definitions, &mut macros);
    let formula = without_comments(&without(&definitions, &arguments.formula));
    let reading = read_display(&formula, &mut symbols, &macros);
    let source = Arc::new(Source::new("formula", arguments.formula.as_str()));
    let (mut statements, mut errors): (Vec<String>, _) = (Vec::new(), Vec::new());
    let mut before: Option<Statement> = None;
    for statement in reading.statements {
        match statement {
            Ok(statement) => {
                let text = text::statement(&statement, &symbols);
                match (&before, statements.last_mut()) {
                    (Some(before), Some(last)) if statement.is_alternative_to(before) => {
                        last.push_str(&format!(" or {text}"));
                    }
                    _ => statements.push(text),
                }
                before = Some(statement);
            }
            Err(fault) => errors.push(Error::fault(&source, fault)),
        }
    }
    let assumed: Vec<String> = match errors.is_empty() {
        true => named(&symbols, &|kind| kind == Kind::Scalar),
        false => Vec::new(),
    };
    let mut inferred = symbols.inferred.said.clone();
    let complex = named(&symbols, &|kind| kind == Kind::Complex);
    let matrices = named(&symbols, &|kind| matches!(kind, Kind::Matrix(..)));
    let vectors = named(&symbols, &|kind| kind == Kind::Vector);
    let abstract_names = named(&symbols, &|kind| kind == Kind::Abstract);
    for (what, names) in [
        ("vectors or matrices, because of their markup", vectors),
        ("matrices, because of their use", matrices),
        ("complex numbers", complex),
        ("names that have no value here", abstract_names),
    ] {
        if !names.is_empty() {
            inferred.push(format!("{what}: {}", names.join(", ")));
        }
    }
    if symbols.is_abstract() {
        inferred.push("some parts have no value here, so only the structure of the formula was read".to_owned());
    }
    if !errors.is_empty() {
        inferred.clear();
    }
    let output = match arguments.format {
        Format::Text => {
            let mut lines: Vec<String> = statements.iter().map(|line| wrap("", line, 4, screen.out.width)).collect();
            if !assumed.is_empty() {
                lines.push(wrap("  assumed to be real numbers: ", &assumed.join(", "), 4, screen.out.width));
            }
            lines.extend(inferred.iter().map(|line| wrap("  inferred: ", line, 4, screen.out.width)));
            lines.iter().map(|line| format!("{line}\n")).collect()
        }
        Format::Json => {
            let mut output = json!({
                "schema": 1,
                "statements": statements,
                "assumed": assumed,
                "errors": errors.iter().map(report::json::error).collect::<Vec<_>>(),
            });
            if !inferred.is_empty() {
                output["inferred"] = json!(inferred);
            }
            format!("{output:#}\n")
        }
    };
    Outcome { output, messages: shown(&errors, screen), code: if errors.is_empty() { 0 } else { 2 } }
}

/// The quantities of one kind, without those that are no quantities: operators, letters of sums.
fn named(symbols: &Symbols, of: &dyn Fn(Kind) -> bool) -> Vec<String> {
    let quantities = symbols.iter().filter(|(_, entry)| of(entry.kind) && entry.operator.is_none() && !entry.hidden);
    quantities.map(|(_, entry)| text::plain(&entry.name.to_string())).collect()
}

/// The text with spaces in the place of its definitions, so that every byte keeps its position.
fn without(definitions: &[MacroDefinition], text: &str) -> String {
    let mut text = text.to_owned();
    for definition in definitions {
        text.replace_range(definition.span.range(), &" ".repeat(definition.span.range().len()));
    }
    text
}

/// The text with spaces in the place of its comments, each from a % to the end of its line, so that every byte keeps its position.
fn without_comments(text: &str) -> String {
    let mut kept = String::with_capacity(text.len());
    let (mut in_comment, mut escaped) = (false, false);
    for c in text.chars() {
        in_comment = (in_comment || c == '%' && !escaped) && c != '\n';
        escaped = c == '\\' && !escaped;
        match in_comment {
            true => kept.extend(std::iter::repeat_n(' ', c.len_utf8())),
            false => kept.push(c),
        }
    }
    kept
}
