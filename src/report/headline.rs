//! The first sentence on an equation that is not as expected: its name, what became of it, and the message.

use crate::check::{Equation, Finding, Part, Verdict};
use crate::code::Code;

/// The sentence on an equation with a finding: `(2) is refuted: the two sides differ`.
pub(super) fn headline(item: &Equation, finding: &Finding) -> String {
    format!("({}) {}", item.id, said(item, finding))
}

/// The verdict and the message as a predicate.
pub(super) fn said(item: &Equation, finding: &Finding) -> String {
    let (outcome, message) = (outcome(item, finding), &finding.message);
    match finding.verdict {
        Verdict::Unclaimed if finding.code == Code::Skipped => format!("{outcome}, because {message}"),
        Verdict::Undecided if finding.leaves_a_definition_open() => format!("{outcome}: it {message}"),
        Verdict::Domain if finding.code == Code::OneBranch => message.clone(),
        _ => format!("{outcome}: {message}"),
    }
}

/// The verdict as a predicate. What is `unreadable` was not read, or was read and cannot be evaluated.
pub(super) fn outcome(item: &Equation, finding: &Finding) -> String {
    match (finding.verdict, is_read(item, finding)) {
        // A second print that lacks something has nothing to read there.
        (Verdict::Unreadable, _) if finding.code == Code::LostInPrint => "is not printed in full".to_owned(),
        (Verdict::Unreadable, true) => "was read, but cannot be checked".to_owned(),
        (Verdict::Unreadable, false) => "could not be read".to_owned(),
        (Verdict::Undecided, _) => "was not decided".to_owned(),
        (Verdict::Unclaimed, _) => "was not checked".to_owned(),
        (Verdict::Domain, _) if finding.code == Code::OneBranch => "holds on one branch only".to_owned(),
        (Verdict::Domain, _) => "has a restricted domain".to_owned(),
        (verdict, _) => format!("is {verdict}"),
    }
}

/// Whether the text that a finding is about was read, so that its reading can be shown.
fn is_read(item: &Equation, finding: &Finding) -> bool {
    let part = item.parts.iter().find(|part: &&Part| std::ptr::eq(&part.finding, finding));
    // A formula whose shapes or indices do not fit has no reading, but each part of it was read.
    let fits = !matches!(finding.code, Code::ShapeMismatch | Code::IndexMismatch);
    !fits || !part.map_or(&item.reading, |part| &part.reading).is_empty()
}
