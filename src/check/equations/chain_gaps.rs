//! Links of a chain that a field decides through another member.
//!
//! Of a = b = c a field may decide b = c and not a = b, because it cannot have what a and b are made of together.
//! If it decides a = c, then a = b is certified too.
//!
//! In a chain a = b = c where a needs the particles and b the moments, a = c and c = b are certified one by one,
//! and so a = b is.

use crate::Result;
use crate::formula::{Relation, Statement};

use crate::check::document::checker::Checker;
use crate::check::equations::chain::Step;
use crate::check::judge::identity;
use crate::check::sample::context::{Context, Options};
use crate::check::verdict::Verdict;

/// Certifies what can be of the links of a statement.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn close(
    checker: &Checker<'_>,
    statement: &Statement,
    steps: &mut [Step],
    context: &Context<'_>,
) -> Result<()> {
    // What is certified so must hold as the link does: always.
    let options = Options { explain: false, ..context.options };
    let context = Context { options, on_shell: Some(false), ..*context };
    let certified = |a: usize, b: usize| -> Result<Option<f64>> {
        let link = checker.link(&statement.members[a], Relation::Equal, &statement.members[b])?;
        let found = identity::check(&link, &context)?;
        Ok(found.false_accept_log2.filter(|_| found.verdict == Verdict::Certified))
    };
    for open in 0..steps.len() {
        let Step { at, finding, .. } = &steps[open];
        if finding.not_certified_because.is_none() || !steps[open].holds() || finding.verdict == Verdict::Certified {
            continue;
        }
        let (a, b) = (*at, at + 1);
        let beside = |at: usize| steps.iter().any(|step| step.at == at && step.finding.verdict == Verdict::Certified);
        // A member next to the two that is known to agree with one of them, and may be shown to agree with the other.
        let after = Some(b + 1).filter(|_| beside(b));
        let before = a.checked_sub(1).filter(|before| beside(*before));
        let mut found = None;
        for c in after.into_iter().chain(before) {
            if let (None, Some(first), Some(second)) = (found, certified(a, c)?, certified(c, b)?) {
                found = Some((first.exp2() + second.exp2()).log2());
            }
        }
        if let Some(log2) = found {
            let finding = &mut steps[open].finding;
            finding.verdict = Verdict::Certified;
            (finding.false_accept_log2, finding.not_certified_because) = (Some(log2), None);
        }
    }
    Ok(())
}
