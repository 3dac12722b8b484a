//! The stable code of a finding and of an error, as reports print it and `onshell explain` looks it up.

use crate::Error;
use crate::check::{Equation, Finding, Verdict};

/// The code of what was found of an equation.
pub fn of_finding(finding: &Finding) -> &'static str {
    finding.code.word()
}

/// The code that an equation which is not as expected is reported under: that of its first part that is not.
pub(super) fn of_item(item: &Equation) -> &'static str {
    of_finding(first_unexpected(item))
}

/// The finding that an equation which is not as expected is reported by: that of its first part that is refuted, or else of its first
/// part that is not as expected.
pub(super) fn first_unexpected(item: &Equation) -> &Finding {
    let own = || item.parts.iter().filter(|part| !part.ok && part.finding.follows_from.is_none());
    // What is refuted is said before what was not decided for that reason.
    let own = own().find(|part| part.finding.verdict == Verdict::Refuted).or_else(|| own().next());
    own.map_or(&item.finding, |part| &part.finding)
}

/// The code of an error.
pub fn of_error(error: &Error) -> &'static str {
    error.code().word()
}
