//! `onshell read`: how a formula is understood.

use crate::formula::{Symbols, text};
use crate::latex::{Macros, read_display};
use crate::report;

use super::{Outcome, colours};

/// Prints how a formula or an equation is understood
#[derive(clap::Args)]
pub struct Arguments {
    /// The formula, in LaTeX
    #[arg(allow_hyphen_values = true)]
    formula: String,
}

pub(super) fn run(arguments: &Arguments) -> Outcome {
    let mut symbols = Symbols::open();
    let reading = read_display(&arguments.formula, &mut symbols, &Macros::default());
    let mut outcome = Outcome::default();
    for statement in reading.statements {
        match statement {
            Ok(statement) => outcome.output.push_str(&format!("{}\n", text::statement(&statement, &symbols))),
            Err(fault) => {
                let colour = colours(&std::io::stderr());
                let shown = report::diagnostic::fault(&fault, &arguments.formula, colour);
                outcome.errors.push_str(&format!("{shown}\n"));
                outcome.code = 2;
            }
        }
    }
    if outcome.code == 0 && !symbols.is_empty() {
        let names: Vec<String> = symbols.iter().map(|(_, entry)| text::plain(&entry.name.to_string())).collect();
        outcome.output.push_str(&format!("  taken for real numbers: {}\n", names.join(", ")));
    }
    outcome
}
