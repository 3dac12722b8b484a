//! `onshell eval`: the value of one formula.

use std::sync::Arc;

use serde_json::json;

use crate::formula::{Assignment, Expr, Node, Symbols, Unavailable, Value, evaluate, text};
use crate::latex::{Macros, names, read_formula};
use crate::source::Source;
use crate::{Error, Result};

use super::outcome::{Format, Outcome, Screen};

/// Prints the value of a formula, to 17 digits
///
/// Every letter needs a value, and so does every dotted letter: --set '\dot\theta=0.83'.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell eval 'm v^2' --set m=2 --set v=0.5")]
pub struct Arguments {
    /// The formula, in LaTeX
    #[arg(allow_hyphen_values = true)]
    formula: String,
    /// The value of a letter, e.g. '\theta=0.7'
    #[arg(long = "set", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    values: Vec<String>,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments, screen: Screen) -> Outcome {
    let mut symbols = Symbols::open();
    let source = Arc::new(Source::new("formula", arguments.formula.as_str()));
    let formula = read_formula(&arguments.formula, &mut symbols, &Macros::default());
    let formula = formula.map_err(|fault| Error::fault(&source, fault));
    match formula.and_then(|formula| value(&formula, &symbols, &arguments.values)) {
        Ok(entries) => Outcome::done(match (arguments.format, &entries[..]) {
            (Format::Text, entries) => {
                entries.iter().map(|entry| format!("{entry:.16e}")).collect::<Vec<_>>().join(" ") + "\n"
            }
            (Format::Json, [value]) => format!("{:#}\n", json!({ "schema": 1, "value": value })),
            (Format::Json, entries) => format!("{:#}\n", json!({ "schema": 1, "value": entries })),
        }),
        Err(error) => Outcome::failed(&error, arguments.format, screen),
    }
}

/// The value of a formula: one number, or the entries of a vector or a matrix.
fn value(formula: &Expr, symbols: &Symbols, given: &[String]) -> Result<Vec<f64>> {
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
        return Err(Error::new(format!("there is no value for {}", missing.join(", "))).help(settings.join(" ")));
    }
    let outcome = evaluate(formula, &assignment, &[]).map_err(|reason| match reason {
        Unavailable::Derivative(_) => Error::new("the formula needs the value of a time derivative")
            .help("set the dotted symbols too: --set '\\dot x=…'"),
        Unavailable::Operation(what) => Error::new(format!("the formula has no value: {what}")),
        Unavailable::Symbol(_) => Error::new("a symbol of the formula has no value"),
    })?;
    match outcome {
        Value::Scalar(value) if value.value().is_finite() => Ok(vec![value.value()]),
        Value::Scalar(value) => Err(Error::new(format!("the formula has no real value here: {}", value.value()))),
        other => {
            let entries: Vec<f64> = other.entries().iter().map(|entry| entry.value()).collect();
            match entries.iter().find(|entry| !entry.is_finite()) {
                Some(entry) => Err(Error::new(format!("an entry of the formula has no real value here: {entry}"))),
                None => Ok(entries),
            }
        }
    }
}

fn setting(pair: &str) -> Result<(crate::formula::symbols::Name, u8, f64)> {
    let wrong = || Error::new(format!("“{pair}” sets nothing: it is not NAME=VALUE")).help("write --set '\\theta=0.7'");
    let (name, value) = pair.split_once('=').ok_or_else(wrong)?;
    let (name, dots) = names::parse(name.trim()).ok_or_else(wrong)?;
    let value: f64 = value.trim().parse().map_err(|_| wrong())?;
    if !value.is_finite() {
        return Err(Error::new(format!("the value of {name} is too large to compute with")));
    }
    Ok((name, dots, value))
}
