//! The answer to whether two formulas are equal, for people.

use crate::check::Verdict;
use crate::check::kinds::compare::Comparison;
use crate::code::Code;

use super::diagnostic;
use super::style::Style;
use super::wrap::wrap;

/// Whether the two are equal: none, where neither can be told.
pub fn equal(answer: &Comparison) -> Option<bool> {
    match answer.finding.verdict {
        verdict if verdict.passes() => Some(true),
        Verdict::Refuted => Some(false),
        _ => None,
    }
}

/// The answer with its evidence.
pub fn text(answer: &Comparison, style: Style) -> String {
    let finding = &answer.finding;
    let word = match equal(answer) {
        Some(true) => "equal",
        Some(false) => "not equal",
        None => "cannot tell",
    };
    let mut lines = vec![wrap(&format!("{word}: "), &finding.message, 2, style.width)];
    let mut tell = |first: &str, text: &str| lines.push(wrap(&format!("  {first}"), text, 4, style.width));
    tell("left:  ", &answer.readings[0]);
    tell("right: ", &answer.readings[1]);
    if !answer.assumed.is_empty() {
        tell("assumed: ", &answer.assumed.join(", "));
    }
    match &finding.counterexample {
        Some(_) => diagnostic::evidence(finding).iter().for_each(|line| tell("", line)),
        // The same formula twice needs no state; that there were too few is said above.
        None if finding.tried == 0 || finding.code == Code::TooFewStates => {}
        None => tell("", &format!("{} of {} sampled states gave a number", finding.points, finding.tried)),
    }
    if let Some(power) = finding.false_accept_log2 {
        tell("", &format!("certified: false with probability below 2^{:.0}", power.ceil()));
    }
    if let Some(reason) = &finding.not_certified_because {
        tell("", &format!("not certified: exact arithmetic does not decide {reason}"));
    }
    lines.join("\n") + "\n"
}
