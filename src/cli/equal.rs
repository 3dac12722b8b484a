//! `onshell equal`: two formulas, no file.

use crate::check::kinds::compare::equal;
use crate::check::{Options, Verdict};
use crate::formula::symbols::Name;
use crate::latex::names;
use crate::notes::claims::Range;
use crate::report;

use super::{Format, Outcome, colours};

/// Tells whether two formulas are equal
///
/// Letters are real numbers, and so are dotted letters. Exits with 0 if the two are equal, 1 if a counterexample shows
/// that they are not, 2 if neither can be told.
#[derive(clap::Args)]
pub struct Arguments {
    /// The one formula, in LaTeX
    #[arg(allow_hyphen_values = true)]
    left: String,
    /// The other
    #[arg(allow_hyphen_values = true)]
    right: String,
    /// The range of a letter, e.g. 'x=0.1..3'
    #[arg(long = "where", value_name = "NAME=LOW..HIGH")]
    ranges: Vec<String>,
    /// The seed of the sampled states
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How many usable states are tried
    #[arg(long, default_value_t = 64, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    points: u32,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments) -> Outcome {
    let colour = colours(&std::io::stderr());
    let mut ranges = Vec::new();
    for given in &arguments.ranges {
        match range(given) {
            Some(range) => ranges.push(range),
            None => {
                let message = format!("“{given}” is no range of a letter");
                let error = crate::Error::new(message).help("write --where 'x=0.1..3', the lower end first");
                return Outcome::failed(report::diagnostic::error(&error, colour));
            }
        }
    }
    let options = Options { seed: arguments.seed, points: arguments.points as usize, explain: true };
    let answer = match equal(&arguments.left, &arguments.right, &ranges, options) {
        Ok(answer) => answer,
        Err((which, fault)) => {
            let formula = [arguments.left.as_str(), arguments.right.as_str(), ""][which.min(2)];
            return Outcome::failed(report::diagnostic::fault(&fault, formula, colour));
        }
    };
    let code = match answer.finding.verdict {
        verdict if verdict.passes() => 0,
        Verdict::Refuted => 1,
        _ => 2,
    };
    let output = match arguments.format {
        Format::Json => format!("{:#}\n", report::json::answer(&answer)),
        Format::Text => text(&answer, code),
    };
    Outcome { output, code, ..Outcome::default() }
}

fn text(answer: &crate::check::kinds::compare::Answer, code: u8) -> String {
    let word = match code {
        0 => "equal",
        1 => "not equal",
        _ => "cannot tell",
    };
    let finding = &answer.finding;
    let mut text = format!("{word}: {}\n", finding.message);
    text.push_str(&format!("  left:  {}\n  right: {}\n", answer.readings[0], answer.readings[1]));
    if !answer.assumed.is_empty() {
        text.push_str(&format!("  taken for granted: {}\n", answer.assumed.join(", ")));
    }
    match &finding.counterexample {
        Some(_) => report::diagnostic::evidence(finding).iter().for_each(|line| text.push_str(&format!("  {line}\n"))),
        None => text.push_str(&format!("  {} states used of {} tried\n", finding.points, finding.tried)),
    }
    if let Some(power) = finding.false_accept_log2 {
        text.push_str(&format!("  certified: false with probability below 2^{:.0}\n", power.ceil()));
    }
    if let Some(reason) = &finding.not_certified_because {
        text.push_str(&format!("  not certified because of {reason}\n"));
    }
    text
}

/// `x=0.1..3`; the ends are in the range.
fn range(given: &str) -> Option<(Name, Range)> {
    let (name, ends) = given.split_once('=')?;
    let (low, high) = ends.split_once("..")?;
    let (low, high) = (low.trim().parse::<f64>().ok()?, high.trim().parse::<f64>().ok()?);
    let (name, dots) = names::parse(name.trim())?;
    let sound = low.is_finite() && high.is_finite() && low < high && dots == 0;
    sound.then_some((name, Range::Interval { low, high, low_open: false, high_open: false }))
}
