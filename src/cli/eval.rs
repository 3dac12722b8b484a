//! `onshell eval`: the value of one formula.

use crate::formula::{Assignment, Expr, Node, Symbols, Unavailable, Value, evaluate, text};
use crate::latex::{Macros, names, read_formula};
use crate::report;
use crate::{Error, Result};

use super::{Outcome, colours};

/// Prints the value of a formula, to 17 digits
///
/// Every letter needs a value, and a dotted letter one of its own: --set '\dot\theta=0.83'.
#[derive(clap::Args)]
pub struct Arguments {
    /// The formula, in LaTeX
    #[arg(allow_hyphen_values = true)]
    formula: String,
    /// The value of a letter, e.g. '\theta=0.7'
    #[arg(long = "set", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    values: Vec<String>,
}

pub(super) fn run(arguments: &Arguments) -> Outcome {
    let colour = colours(&std::io::stderr());
    let mut symbols = Symbols::open();
    let formula = match read_formula(&arguments.formula, &mut symbols, &Macros::default()) {
        Ok(formula) => formula,
        Err(fault) => return Outcome::failed(report::diagnostic::fault(&fault, &arguments.formula, colour)),
    };
    match value(&formula, &symbols, &arguments.values) {
        Ok(lines) => Outcome { output: lines, ..Outcome::default() },
        Err(error) => Outcome::failed(report::diagnostic::error(&error, colour)),
    }
}

fn value(formula: &Expr, symbols: &Symbols, given: &[String]) -> Result<String> {
    let mut assignment = Assignment::new(symbols);
    let mut known = Vec::new();
    for pair in given {
        let (name, dots, value) = setting(pair)?;
        let Some((id, _)) = symbols.find(&name) else {
            let shown = text::with_dots(&name.to_string(), dots);
            return Err(Error::new(format!("{shown} does not occur in the formula")));
        };
        if known.contains(&(id, dots)) {
            return Err(Error::new(format!("{} is set twice", text::with_dots(&name.to_string(), dots))));
        }
        assignment.set(id, dots, value);
        known.push((id, dots));
    }
    let mut missing = Vec::new();
    formula.walk(&mut |expr| {
        if let Node::Symbol { id, dots, .. } = &expr.node {
            let spelled = crate::latex::typeset(expr, symbols);
            if !known.contains(&(*id, *dots)) && !missing.contains(&spelled) {
                missing.push(spelled);
            }
        }
    });
    if !missing.is_empty() {
        let settings: Vec<String> = missing.iter().map(|name| format!("--set '{name}=…'")).collect();
        return Err(Error::new(format!("no value for {}", missing.join(", "))).help(settings.join(" ")));
    }
    let outcome = evaluate(formula, &assignment, &[]).map_err(|reason| match reason {
        Unavailable::Derivative(_) => Error::new("the formula needs a time derivative that was not given")
            .help("set the dotted symbols too: --set '\\dot x=…'"),
        other => Error::new(format!("the formula has no value: {other:?}")),
    })?;
    match outcome {
        Value::Scalar(value) if value.value().is_finite() => Ok(format!("{:.16e}\n", value.value())),
        Value::Scalar(value) => Err(Error::new(format!("the formula has no real value here: {}", value.value()))),
        other => {
            let entries: Vec<String> = other.entries().iter().map(|x| format!("{:.16e}", x.value())).collect();
            Ok(entries.join(" ") + "\n")
        }
    }
}

fn setting(pair: &str) -> Result<(crate::formula::symbols::Name, u8, f64)> {
    let wrong = || Error::new(format!("“{pair}” sets nothing")).help("write --set '\\theta=0.7'");
    let (name, value) = pair.split_once('=').ok_or_else(wrong)?;
    let (name, dots) = names::parse(name.trim()).ok_or_else(wrong)?;
    let value: f64 = value.trim().parse().map_err(|_| wrong())?;
    if !value.is_finite() {
        return Err(Error::new(format!("the value of {name} is too large to compute with")));
    }
    Ok((name, dots, value))
}
