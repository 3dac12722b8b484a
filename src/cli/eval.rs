//! `onshell eval`: the value of one formula.

use serde_json::json;

use crate::latex::names;
use crate::{Error, Formula, Result};

use super::outcome::{Format, Outcome, Screen};
use super::values;

/// Prints the value of a formula, without digits that rounding makes uncertain
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
                let shown = entries.iter().map(|(value, error)| decimal(*value, *error));
                shown.chain(unit).collect::<Vec<_>>().join(" ") + "\n"
            }
            (Format::Json, entries) => {
                let values: Vec<f64> = entries.iter().map(|(value, _)| *value).collect();
                let value = match values.as_slice() {
                    [value] => json!(value),
                    values => json!(values),
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

/// The shortest decimal within a rounding error of a value.
fn decimal(value: f64, error: f64) -> String {
    if value.abs() <= error {
        return "0".to_owned();
    }
    let with_digits = |count: usize| format!("{value:.count$e}").parse::<f64>().unwrap_or(value);
    let shortest = (0..17).map(with_digits).find(|short| (short - value).abs() <= error).unwrap_or(value);
    // Long rows of zeros are not counted.
    match shortest.abs() {
        1e-4..1e15 => format!("{shortest}"),
        _ => format!("{shortest:e}"),
    }
}

/// A value, and a bound of its rounding error.
type WithError = (f64, f64);

/// The value of the formula, one number or the entries of a vector or a matrix, each with a bound of its rounding error; and
/// its unit, if units stand in it.
fn entries(arguments: &Arguments) -> Result<(Vec<WithError>, Option<String>)> {
    let formula = Formula::read_value(&arguments.formula)?;
    let values = arguments.values.iter().map(|pair| setting(pair)).collect::<Result<Vec<_>>>()?;
    Ok((formula.entries_with_errors(&values)?, formula.unit()?))
}

/// A name and its value, from `NAME=VALUE`.
fn setting(pair: &str) -> Result<(&str, f64)> {
    let (name, value) = values::setting(pair)?;
    names::parse(name).ok_or_else(|| {
        Error::new(format!("“{name}” is not a name in --set {pair}")).help("write --set '\\theta=0.5'")
    })?;
    Ok((name, value))
}

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn a_value_is_printed_as_people_write_it() {
        for (value, error, printed) in [
            (0.1 + 0.2, 1e-15, "0.3"),
            (1.0 / 3.0, 1e-10, "0.3333333333"),
            (-2.0, 1e-15, "-2"),
            (1.22e-16, 1e-15, "0"),
            (6.02214076e23, 1e9, "6.02214076e23"),
            (2.5e-7, 1e-22, "2.5e-7"),
        ] {
            assert_eq!(decimal(value, error), printed);
        }
        // must-fail case: a digit beyond the error is not dropped
        assert_eq!(decimal(0.1 + 0.2, 0.0), "0.30000000000000004");
    }
}
