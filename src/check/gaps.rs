//! Links of a chain that a field decides by way of another member.
//!
//! Of a = b = c a field may decide b = c, and not a = b, because what a and b are made of cannot both be had in it. If it
//! decides a = c, then a = b is certified as well: where both agree with c they agree.

use crate::Result;
use crate::formula::{Relation, Statement};

use super::chain::Step;
use super::desk::Desk;
use super::identity::{self, Context, Options};
use super::verdict::Verdict;

/// Certifies what can be of the links of a statement.
///
/// # Errors
/// When the world's mass matrix is singular.
pub(super) fn close(desk: &Desk<'_>, statement: &Statement, steps: &mut [Step], context: &Context<'_>) -> Result<()> {
    let context = Context { options: Options { explain: false, ..context.options }, ..*context };
    for open in 0..steps.len() {
        let Step { at, finding, .. } = &steps[open];
        if finding.not_certified_because.is_none() || !steps[open].holds() || finding.verdict == Verdict::Certified {
            continue;
        }
        let (a, b) = (*at, at + 1);
        // The neighbours that are certified, and the two members that are then left to be compared.
        let ways = steps.iter().filter(|beside| beside.holds()).filter_map(|beside| {
            let known = beside.finding.false_accept_log2.filter(|_| beside.finding.verdict == Verdict::Certified)?;
            match beside.at {
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
            let finding = &mut steps[open].finding;
            finding.verdict = Verdict::Certified;
            (finding.false_accept_log2, finding.not_certified_because) = (Some(log2), None);
        }
    }
    Ok(())
}
