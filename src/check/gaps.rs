//! Links of a chain that a field decides by way of another member.
//!
//! Of a = b = c a field may decide b = c, and not a = b, because what a and b are made of cannot both be had in it. If it
//! decides a = c, then a = b is certified as well: where both agree with c they agree.

use crate::Result;
use crate::formula::{Relation, Statement};

use super::desk::Desk;
use super::identity::{self, Context, Options, is_equality};
use super::verdict::{Finding, Verdict};

/// Certifies what can be of the links of a statement, each of which stands with its place in the chain.
///
/// # Errors
/// When the world's mass matrix is singular.
pub(super) fn close(
    desk: &Desk<'_>,
    statement: &Statement,
    findings: &mut [(usize, Finding)],
    context: &Context<'_>,
) -> Result<()> {
    let context = Context { options: Options { explain: false, ..context.options }, ..*context };
    let is_equal = |at: usize| is_equality(statement.relations[at].0);
    for open in 0..findings.len() {
        let (at, finding) = &findings[open];
        if finding.verdict != Verdict::Verified || finding.not_certified_because.is_none() || !is_equal(*at) {
            continue;
        }
        let (a, b) = (*at, at + 1);
        // The neighbours that are certified, and the two members that are then left to be compared.
        let ways = findings.iter().filter_map(|(other, beside)| {
            let known =
                beside.false_accept_log2.filter(|_| beside.verdict == Verdict::Certified && is_equal(*other))?;
            match *other {
                other if other == b => Some((known, a, b + 1)),
                other if other + 1 == a => Some((known, a - 1, b)),
                _ => None,
            }
        });
        let mut certified = None;
        for (known, from, to) in ways.collect::<Vec<_>>() {
            let link = desk.link(&statement.members[from], Relation::Equal, &statement.members[to])?;
            let across = identity::check(&link, &context)?;
            certified = certified.or(across.false_accept_log2.map(|across| (known.exp2() + across.exp2()).log2()));
        }
        if let Some(log2) = certified {
            let finding = &mut findings[open].1;
            finding.verdict = Verdict::Certified;
            (finding.false_accept_log2, finding.not_certified_because) = (Some(log2), None);
        }
    }
    Ok(())
}
