//! A slash in the argument of a sine without parentheses: `\sin 2\pi x/L`, `\cos n\pi x/L`, `\sin 2\pi t/T`.
//!
//! A place is compared with a length, and a time with a period. So a slash after π and a place belongs to the argument where a
//! length alone stands below it, and nothing else can be meant. `\sin\omega t/2` and `\cos\theta/r` stay in two ways.

use super::super::super::layout::{Item, Layout};
use super::super::super::names;
use super::super::items::{Joint, joint};
use super::letters::is_pi;

/// One past the letter below such a slash, where the argument before it is `argument` and `rest` follows it.
pub(super) fn length(argument: &[Item], rest: &[Item]) -> Option<usize> {
    const LENGTHS: [&str; 9] = ["L", "l", "\\ell", "\\lambda", "a", "d", "W", "D", "\\Lambda"];
    let plain = |item: &Item| {
        let found = names::printed(item, None).filter(|found| found.sup.is_none() && found.dots == 0)?;
        (found.name.primes == 0).then_some(found.name)
    };
    let last = plain(argument.last()?)?;
    let [slash, below, after @ ..] = rest else { return None };
    let below = plain(below)?;
    let is_period = match last.base.as_str() {
        "x" | "y" | "z" => LENGTHS.contains(&below.base.as_str()),
        "t" => ["T", "\\tau", "P"].contains(&below.base.as_str()),
        _ => false,
    };
    let ends =
        after.first().is_none_or(|next| matches!(next.layout, Layout::Space(_) | Layout::Other('+' | '-' | ',' | '.')));
    (is_period && ends && joint(slash) == Some(Joint::Slash) && argument.iter().any(is_pi)).then_some(2)
}
