//! The faults of a slash that people read in two ways: `a/bc`, `a/b/c`, `\sin x/y`. Each quotes the author's own text.

use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout, contents, typed};
use super::super::names;
use super::items::{Joint, differential, joint};

/// The most characters of a text that is quoted. Of a longer one the letters a, b and c stand for the parts.
const LONGEST: usize = 40;

/// `a/bc`, where the factor at `next` follows the denominator without an operator.
pub(super) fn before_a_product(items: &[Item], span: Span, next: usize) -> Fault {
    let generic =
        || Fault::ambiguous(span, "a/bc may be a/(bc) or (a/b)c").help("write \\frac{a}{bc} or \\frac{a}{b}c");
    let Some(slash) = last_slash(items, next) else { return generic() };
    let (start, end) = (term_start(items, slash), term_end(items, next));
    let (above, below, rest) = (&items[start..slash], &items[slash + 1..next], &items[next..end]);
    if is_d(above) && is_d(below) {
        return derivative(items, span, (slash, next, end)).unwrap_or_else(generic);
    }
    let whole = quoted(&items[start..end]);
    let (above, below, product) = (quoted(above), quoted(below), quoted(&items[slash + 1..end]));
    let rest = format!("{}{}", gap(items, next), quoted(rest));
    if whole.chars().count() > LONGEST {
        return generic();
    }
    Fault::ambiguous(span, format!("{whole} may be {above}/({product}) or ({above}/{below}){rest}"))
        .help(format!("write \\frac{{{above}}}{{{product}}} or \\frac{{{above}}}{{{below}}}{rest}"))
}

/// Whether π at a place ends the denominator of a letter over a whole number of turns: `h/2\pi`. Of 1/2π both readings are usual.
pub(super) fn is_over_turns(items: &[Item], at: usize) -> bool {
    let is_space = |item: &&Item| matches!(item.layout, Layout::Space(_));
    let mut before = items[..at].iter().rev().filter(|item| !is_space(item));
    let is_even = |item: &Item| matches!(&item.layout, Layout::Number(digits) if digits == "2" || digits == "4");
    let is_slash = |item: &Item| joint(item) == Some(Joint::Slash);
    items[at].layout == Layout::Command("\\pi".to_owned())
        && before.next().is_some_and(is_even)
        && before.next().is_some_and(is_slash)
        && before.next().is_some_and(|item| names::printed(item, None).is_some())
        && items[at + 1..].iter().all(|item| is_space(&item))
}

/// Whether the sign at a place stands between a number and a power of ten, `2.8\times10^{-32}/1.05\times10^{-34}`, where that number has
/// decimals or the numerator has such a power too.
pub(super) fn is_before_a_power_of_ten(items: &[Item], at: usize) -> bool {
    let is_space = |item: &&Item| matches!(item.layout, Layout::Space(_));
    let is_power = |item: &Item| {
        matches!(&item.layout, Layout::Scripts { nucleus, sub: None, sup: Some(_), .. }
            if nucleus.layout == Layout::Number("10".to_owned()))
    };
    let before = items[..at].iter().rev().find(|item| !is_space(item));
    let after = items[at + 1..].iter().find(|item| !is_space(item));
    let has_decimals =
        before.is_some_and(|item| matches!(&item.layout, Layout::Number(digits) if digits.contains('.')));
    let is_number = before.is_some_and(|item| matches!(item.layout, Layout::Number(_)));
    after.is_some_and(is_power) && (has_decimals || is_number && items[..at].iter().any(is_power))
}

pub(super) fn by_a_power_of_ten(span: Span) -> Fault {
    Fault::ambiguous(span, "a slash before a number with a power of ten may divide by both or by the number alone")
        .help("write \\frac{a}{b \\times 10^n}, or put the number and its power in parentheses")
}

/// `d/dt (m v)`: a derivative on one line.
fn derivative(items: &[Item], span: Span, (slash, next, end): (usize, usize, usize)) -> Option<Fault> {
    let variable = items.get(next)?;
    let operator = format!("d/d{}", quoted(std::slice::from_ref(variable)));
    let of = quoted(&items[next + 1..end]);
    let of = if of.is_empty() || of.chars().count() > LONGEST { "(…)".to_owned() } else { of };
    let above = &items[slash.checked_sub(1)?];
    Some(
        Fault::ambiguous(above.span.to(span), format!("{operator} {of} may be a derivative or a quotient"))
            .help(format!("write \\frac{{d}}{{d{}}} {of} for the derivative", quoted(std::slice::from_ref(variable)))),
    )
}

/// `a/b/c`, with the second slash at `second`.
pub(super) fn two(items: &[Item], second: usize) -> Fault {
    let span = items[second].span;
    let generic = || Fault::ambiguous(span, "a/b/c may be (a/b)/c or a/(b/c)").help("use \\frac or parentheses");
    let Some(first) = last_slash(items, second) else { return generic() };
    let (start, end) = (term_start(items, first), term_end(items, second + 1));
    let (a, b, c) = (quoted(&items[start..first]), quoted(&items[first + 1..second]), quoted(&items[second + 1..end]));
    match c.is_empty() || quoted(&items[start..end]).chars().count() > LONGEST {
        true => generic(),
        false => Fault::ambiguous(span, format!("{a}/{b}/{c} may be ({a}/{b})/{c} or {a}/({b}/{c})"))
            .help("use \\frac or parentheses"),
    }
}

/// `\sin x/y`, where the function without parentheses is at `function`.
pub(super) fn after_a_function(items: &[Item], function: Span, slash: usize) -> Fault {
    let span = function.to(items[slash].span);
    let generic = || Fault::ambiguous(span, "\\sin x/y may be (\\sin x)/y or \\sin(x/y)");
    let advice = "put the argument in parentheses, or use \\frac";
    let found = items[..slash].iter().position(|item| item.span.start == function.start);
    let Some(head) = found.filter(|head| head + 1 < slash) else { return generic().help(advice) };
    let end = term_end(items, slash + 1);
    let (name, argument, below) =
        (quoted(&items[head..=head]), quoted(&items[head + 1..slash]), quoted(&items[slash + 1..end]));
    match below.is_empty() || quoted(&items[head..end]).chars().count() > LONGEST {
        true => generic().help(advice),
        false => Fault::ambiguous(
            span,
            format!("{name} {argument}/{below} may be ({name} {argument})/{below} or {name}({argument}/{below})"),
        )
        .help(advice),
    }
}

/// The text of items, without the spaces around it.
fn quoted(items: &[Item]) -> String {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let first = items.iter().position(|item| !is_space(item)).unwrap_or(items.len());
    let last = items.iter().rposition(|item| !is_space(item)).map_or(first, |last| last + 1);
    typed(&items[first..last])
}

/// The space that the author left before an item.
fn gap(items: &[Item], at: usize) -> &'static str {
    let before = at.checked_sub(1).map(|before| &items[before]);
    let is_apart = |before: &Item| matches!(before.layout, Layout::Space(_)) || before.span.end < items[at].span.start;
    if before.is_some_and(is_apart) { " " } else { "" }
}

/// The last slash before an item.
fn last_slash(items: &[Item], before: usize) -> Option<usize> {
    items[..before].iter().rposition(|item| joint(item) == Some(Joint::Slash))
}

/// Where the factors before a slash begin: after the last operator.
fn term_start(items: &[Item], slash: usize) -> usize {
    items[..slash].iter().rposition(|item| joint(item).is_some()).map_or(0, |operator| operator + 1)
}

/// Where the factors from one on end: at the next operator.
fn term_end(items: &[Item], from: usize) -> usize {
    items[from..].iter().position(|item| joint(item).is_some()).map_or(items.len(), |length| from + length)
}

/// Whether these are the d of a differential and nothing else.
fn is_d(items: &[Item]) -> bool {
    let mut inner = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    match (inner.next(), inner.next()) {
        (Some(only), None) => matches!(contents(only), [d] if differential(d).is_some()),
        _ => false,
    }
}
