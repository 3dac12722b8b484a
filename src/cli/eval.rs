//! `onshell eval`: the value of one formula.

use serde_json::json;

use crate::latex::names;
use crate::{Error, Formula, Result};

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
    match entries(arguments) {
        Ok((entries, unit)) => Outcome::done(match (arguments.format, &entries[..]) {
            (Format::Text, entries) => {
                let entries = entries.iter().map(|entry| format!("{entry:.16e}"));
                entries.chain(unit).collect::<Vec<_>>().join(" ") + "\n"
            }
            (Format::Json, entries) => {
                let value = match entries {
                    [value] => json!(value),
                    entries => json!(entries),
                };
                let mut found = json!({ "schema": 1, "value": value });
                if let Some(unit) = unit {
                    found["unit"] = json!(unit);
                }
                format!("{found:#}\n")
            }
        }),
        Err(error) => Outcome::failed(&error, arguments.format, screen),
    }
}

/// The value of the formula: one number, or the entries of a vector or a matrix; and its unit, if units stand in it.
fn entries(arguments: &Arguments) -> Result<(Vec<f64>, Option<String>)> {
    let formula = Formula::read(&arguments.formula)?;
    let values = arguments.values.iter().map(|pair| setting(pair)).collect::<Result<Vec<_>>>()?;
    Ok((formula.entries(&values)?, formula.unit()?))
}

/// A name and its value, from `NAME=VALUE`.
fn setting(pair: &str) -> Result<(&str, f64)> {
    let wrong = || Error::new(format!("“{pair}” sets nothing: it is not NAME=VALUE")).help("write --set '\\theta=0.7'");
    let (name, value) = pair.split_once('=').ok_or_else(wrong)?;
    let name = name.trim();
    names::parse(name).ok_or_else(wrong)?;
    let value: f64 = value.trim().parse().map_err(|_| wrong())?;
    if !value.is_finite() {
        return Err(Error::new(format!("the value of {name} is too large to compute with")));
    }
    Ok((name, value))
}
