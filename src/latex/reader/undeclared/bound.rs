//! The letter of an integral or of `\max_x` that stands again behind it: `\int \sin\theta\,d\theta\,f(\theta)`, `\max_x a \cdot x`.
//!
//! The integral ends at its differential, and the author means that it does not. Such a display is refused.

use crate::formula::symbols::Name;
use crate::source::Fault;

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::names;
use super::super::items::{differential, is_integral};
use super::super::state::Read;
use super::super::structure::is_extremum;

/// Rejects factors after `factor` with a letter that it binds.
pub(in super::super) fn ends_with_its_factor(factor: &[Item], after: &[Item]) -> Read<()> {
    let Some(first) = factor.first() else { return Ok(()) };
    let bound = match () {
        () if is_integral(first) => of_an_integral(factor),
        () if is_extremum(first) => of_an_extremum(first),
        () => return Ok(()),
    };
    // An integral with the same letter has a letter of its own.
    let end = after.iter().position(is_integral).unwrap_or(after.len());
    let after = &after[..end];
    let Some(item) = after.iter().find(|item| bound.iter().any(|name| mentions(item, name))) else { return Ok(()) };
    let what = if is_integral(first) {
        "the integral ends at its differential"
    } else {
        "what stands behind \\min or \\max ends at the dot or space"
    };
    Err(Fault::ambiguous(item.span, format!("{what}, but its variable stands here again"))
        .help("write the differential last, or put all that belongs to the integral, \\min or \\max in parentheses"))
}

/// The letters behind the differentials of an integral.
fn of_an_integral(factor: &[Item]) -> Vec<Name> {
    let pairs = factor.windows(2).filter(|pair| differential(&pair[0]).is_some());
    pairs.filter_map(|pair| names::printed(&pair[1], None).map(|found| found.name)).collect()
}

/// The letter below `\max`.
fn of_an_extremum(item: &Item) -> Vec<Name> {
    let Layout::Scripts { sub: Some(sub), .. } = &item.layout else { return Vec::new() };
    contents(sub).first().and_then(|first| names::printed(first, None)).map(|found| found.name).into_iter().collect()
}

/// Whether a name stands anywhere in an item as a letter of its own.
fn mentions(item: &Item, name: &Name) -> bool {
    let is_it = |found: names::Printed<'_>| {
        found.name.base == name.base && found.name.subscript == name.subscript
            || name.subscript.is_empty() && found.name.subscript.contains(&name.base)
    };
    names::printed(item, None).is_some_and(is_it) || parts(item).into_iter().flatten().any(|part| mentions(part, name))
}
