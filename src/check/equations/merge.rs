//! Several findings merged into one, and the verdict that a claims file expects.

use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Part;
use crate::code::Code;
use crate::notes::claims::{Expect, Expected};
use crate::source::Span;

/// The verdict that a claims file expects.
pub(crate) fn expected(expect: &Expect) -> Verdict {
    match expect.verdict.value {
        Expected::Refuted => Verdict::Refuted,
        Expected::Domain => Verdict::Domain,
        Expected::Undecided => Verdict::Undecided,
        Expected::Unreadable => Verdict::Unreadable,
        Expected::Unclaimed => Verdict::Unclaimed,
    }
}

/// The worst of several findings. If it is a pass, it gets the messages and the evidence of all: the fewest states, the
/// largest residual, the sum of the false-accept probabilities.
pub(crate) fn merged(findings: Vec<Finding>) -> Option<Finding> {
    let fewest = findings.iter().filter(|f| f.points > 0).map(|f| f.points).min();
    let largest = findings.iter().filter_map(|f| f.max_residual).reduce(f64::max);
    let tried = findings.iter().map(|f| f.tried).max();
    // The probability that any of them is false is at most the sum.
    let false_accept = findings.iter().filter_map(|f| f.false_accept_log2).map(f64::exp2).reduce(|a, b| a + b);
    let leaves_sign_open = findings.iter().any(|finding| finding.code == Code::DefinitionUpToSign);
    let mut messages: Vec<String> = Vec::new();
    for finding in findings.iter().filter(|finding| finding.verdict.passes()) {
        if !messages.contains(&finding.message) {
            messages.push(finding.message.clone());
        }
    }
    let mut worst = findings.into_iter().reduce(|a, b| if rank(b.verdict) > rank(a.verdict) { b } else { a })?;
    if worst.verdict.passes() {
        if messages.len() <= 2 {
            worst.message = messages.join("; ");
            if leaves_sign_open {
                worst.code = Code::DefinitionUpToSign;
            }
        }
        worst.points = fewest.unwrap_or(0);
        worst.max_residual = largest;
        worst.tried = tried.unwrap_or(0);
        worst.false_accept_log2 = false_accept.filter(|_| worst.verdict == Verdict::Certified).map(f64::log2);
    }
    Some(worst)
}

/// The rank of a verdict in a merge; the highest counts. A pass that was tested ranks above one that was not.
fn rank(verdict: Verdict) -> usize {
    match verdict {
        Verdict::Definition => 0,
        Verdict::Law => 1,
        Verdict::Certified => 2,
        Verdict::Verified => 3,
        verdict => verdict.severity(),
    }
}

/// The merged finding of the parts of an equation.
pub(crate) fn worst(parts: &[Part]) -> Finding {
    merged(parts.iter().map(|part| part.finding.clone()).collect()).unwrap_or_else(|| {
        Finding::new(Code::NoClaim, Verdict::Unclaimed, Span::default(), "no claim is made; add one in the claims file")
    })
}
