//! `onshell read`: how a formula is understood.

use std::sync::Arc;

use serde_json::json;

use crate::Error;
use crate::formula::{Symbols, text};
use crate::latex::{Macros, read_display};
use crate::report::{self, wrap};
use crate::source::Source;

use super::outcome::{Format, Outcome, Screen, shown};

/// Prints how a formula or an equation is understood
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell read '\\frac12 m v^2'")]
pub struct Arguments {
    /// The formula, in LaTeX
    #[arg(allow_hyphen_values = true)]
    formula: String,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments, screen: Screen) -> Outcome {
    let mut symbols = Symbols::open();
    let reading = read_display(&arguments.formula, &mut symbols, &Macros::default());
    let source = Arc::new(Source::new("formula", arguments.formula.as_str()));
    let (mut statements, mut errors) = (Vec::new(), Vec::new());
    for statement in reading.statements {
        match statement {
            Ok(statement) => statements.push(text::statement(&statement, &symbols)),
            Err(fault) => errors.push(Error::fault(&source, fault)),
        }
    }
    let assumed: Vec<String> = match errors.is_empty() {
        true => symbols.iter().map(|(_, entry)| text::plain(&entry.name.to_string())).collect(),
        false => Vec::new(),
    };
    let output = match arguments.format {
        Format::Text => {
            let mut lines: Vec<String> = statements.iter().map(|line| wrap("", line, 4, screen.out.width)).collect();
            if !assumed.is_empty() {
                lines.push(wrap("  assumed to be real numbers: ", &assumed.join(", "), 4, screen.out.width));
            }
            lines.iter().map(|line| format!("{line}\n")).collect()
        }
        Format::Json => {
            let output = json!({
                "schema": 1,
                "statements": statements,
                "assumed": assumed,
                "errors": errors.iter().map(report::json::error).collect::<Vec<_>>(),
            });
            format!("{output:#}\n")
        }
    };
    Outcome { output, messages: shown(&errors, screen), code: if errors.is_empty() { 0 } else { 2 } }
}
