//! `onshell equal`: two formulas, no file.

use std::ops::RangeInclusive;

use crate::check::Options;
use crate::latex::names;
use crate::report;
use crate::{Comparison, Error, Result, compare};

use super::outcome::{Format, Outcome, Screen};
use super::values;

/// Tells whether two formulas are equal
///
/// Letters are real numbers, and so are dotted letters. Exits with 0 if the two are equal, 1 if a counterexample shows
/// that they are not, 2 if neither was found.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell equal '\\sin 2x' '2\\sin x\\cos x'")]
pub struct Arguments {
    /// The first formula, in LaTeX
    #[arg(allow_hyphen_values = true)]
    left: String,
    /// The second formula, in LaTeX
    #[arg(allow_hyphen_values = true)]
    right: String,
    /// The range of a letter, e.g. 'x=0.1..3'
    #[arg(long = "where", value_name = "NAME=LOW..HIGH")]
    ranges: Vec<String>,
    /// The seed of the sampled states
    #[arg(long, default_value_t = 1, allow_negative_numbers = true, value_parser = values::seed)]
    seed: u64,
    /// The number of sampled states
    #[arg(long, default_value_t = 64, allow_negative_numbers = true, value_parser = values::points)]
    points: u32,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments, screen: Screen) -> Outcome {
    match answered(arguments) {
        Ok(answer) => {
            let output = match arguments.format {
                Format::Json => format!("{:#}\n", report::json::answer(&answer)),
                Format::Text => report::answer::text(&answer, screen.out),
            };
            let code = match report::answer::equal(&answer) {
                Some(true) => 0,
                Some(false) => 1,
                None => 2,
            };
            Outcome { output, code, ..Outcome::default() }
        }
        Err(error) => Outcome::failed(&error, arguments.format, screen),
    }
}

fn answered(arguments: &Arguments) -> Result<Comparison> {
    let mut ranges = Vec::new();
    for given in &arguments.ranges {
        let wrong = || {
            Error::new(format!("“{given}” does not give the range of a letter"))
                .help("write the lower end first, as in --where 'x=0.1..3'")
        };
        ranges.push(range(given).ok_or_else(wrong)?);
    }
    let options = Options { seed: arguments.seed, points: arguments.points as usize, ..Options::default() };
    compare(&arguments.left, &arguments.right, &ranges, options)
}

/// A range such as `x=0.1..3`, with both of its ends.
fn range(given: &str) -> Option<(&str, RangeInclusive<f64>)> {
    let (name, ends) = given.split_once('=')?;
    let (low, high) = ends.split_once("..")?;
    let (low, high) = (low.trim().parse::<f64>().ok()?, high.trim().parse::<f64>().ok()?);
    let (_, dots) = names::parse(name.trim())?;
    let sound = low.is_finite() && high.is_finite() && low < high && dots == 0;
    sound.then_some((name.trim(), low..=high))
}
