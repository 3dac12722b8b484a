//! The quick test of whether a display can follow from premises: a few states, and nothing else.
//!
//! Most sets of premises are of no use. The full check of a claim draws states of several kinds and tests its mutants, so
//! it costs ten times as much as three states at which the premises hold.

use crate::Result;
use crate::formula::{Expr, Relation};
use crate::notes::claims::Claim;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::model::claim::Link;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::{Context, Options};
use crate::check::state::residual::{self, Point};
use crate::check::trial::text_trial::tested_links;

/// The number of states.
const STATES: usize = 3;

/// The number of states where none of these is found.
const MORE: usize = 16;

/// Whether a display may follow from the hypotheses of a claim: there are states at which these hold, it fails at none, and its
/// sides are not 0 at all of them.
///
/// # Errors
/// For a claim that does not fit the notes.
pub(super) fn may_follow(checker: &Checker<'_>, at: usize, claim: &Claim) -> Result<bool> {
    let hypotheses = checker.hypotheses(claim)?;
    let topic = format!("{} screened", shown(&checker.notes.equations[at]));
    let context = Context {
        model: checker.model,
        options: Options { points: STATES, ..checker.options },
        hypotheses: &hypotheses,
        on_shell: None,
        topic: &topic,
        span: Span::default(),
        spread: Spread::Declared,
        local: &[],
    };
    let reading = &checker.readings[at];
    for statement in 0..reading.statements.len() {
        let links: Vec<_> = tested_links(checker, (reading, statement), claim).collect();
        let sides: Vec<_> = links.iter().flat_map(|link| [&link.lhs, &link.rhs]).collect();
        if links.is_empty() {
            continue;
        }
        let mode = context.mode(checker.model.has_motion(), &sides);
        // Premises with powers and roots hold at few of the numbers that are drawn.
        let drawn = |points| context.ensemble(mode, false, points).ok().filter(|ensemble| !ensemble.states.is_empty());
        let Some(ensemble) = drawn(STATES).or_else(|| drawn(MORE)) else { return Ok(false) };
        let fails =
            |link| ensemble.states.iter().any(|state| matches!(residual::test(link, state), Ok(Point::Fails(_))));
        if links.iter().any(fails) {
            return Ok(false);
        }
        // Premises such as r\dot r = h\dot r hold at rest too, where nothing moves and any display is 0 = 0.
        let is_zero = |link: &Link| {
            let zero = Expr::integer(0, link.lhs.span);
            let link = Link { rhs: zero, relation: Relation::Equal, ..link.clone() };
            !link.lhs.is_null()
                && ensemble.states.iter().all(|state| matches!(residual::test(&link, state), Ok(Point::Holds(_))))
        };
        let has_zero = |link: &&Link| link.rhs.is_null() || link.lhs.is_null();
        if links.iter().any(|link| !has_zero(&link) && is_zero(link)) {
            return Ok(false);
        }
    }
    Ok(true)
}
