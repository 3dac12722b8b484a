//! The ranking of repairs: which correction is the likeliest.
//!
//! The order of the kinds of slip is that of the variants of [`Slip`]. Missing terms are ordered by their cost first, in
//! [`super::missing_terms`].

use crate::latex::names;
use crate::latex::slips::{Edit, Slip};
use crate::source::Span;

use crate::check::trial::failed_display::OFFERED;
use crate::check::verdict::repair::Repair;

/// The rank of a pair of parentheses among the factors, in bytes.
const PARENTHESES: usize = 6;

/// The rank of a ½ among the factors, in bytes: that of a 2 with its space.
const HALF: usize = 5;

/// The rank of an edit of a text; the smallest comes first. Compared in this order: the kind of slip, whether the edit
/// corrects one step of a chain only, how many bytes it changes, and where it is.
pub(crate) fn rank(text: &str, edit: &Edit, step: bool) -> (Slip, bool, usize, usize) {
    let Edit { span, replacement, slip } = edit;
    // A missing minus before a whole side is rarer than a wrong sign, and more frequent on the right than on the left.
    // Within an argument or a denominator it is rarest.
    let in_cell = ["&", r"\\", "matrix}"].iter().any(|edge| text[..span.start].trim_end().ends_with(edge));
    if *slip == Slip::Sign && span.start == span.end && !in_cell {
        let braces = |brace: char| text[..span.start].matches(brace).count();
        let depth = braces('{').saturating_sub(braces('}'));
        return (Slip::Fraction, step, depth, text.len() - span.start);
    }
    let old = &text[span.range()];
    // The sign of an exponent is rarely wrong.
    if *slip == Slip::Sign && old.parse::<u32>().is_ok() {
        return (Slip::Relation, step, 0, span.start);
    }
    // A misprinted number is usually half, double or a neighbour of the right one.
    let far = *slip == Slip::Number
        && matches!((old.parse::<u32>(), replacement.parse::<u32>()),
        (Ok(n), Ok(m)) if n.abs_diff(m) != 1 && n != 2 * m && m != 2 * n);
    // Parentheses around what is printed are lost more rarely than one factor.
    if *slip == Slip::Parenthesis && replacement.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) == Some(old)
    {
        return (Slip::Factor, step, PARENTHESES, span.start);
    }
    // A lost ½ is as likely as a lost 2.
    if *slip == Slip::Factor && old.is_empty() && replacement.trim() == r"\frac{1}{2} \," {
        return (Slip::Factor, step, HALF, span.start);
    }
    let same = old.bytes().zip(replacement.bytes()).take_while(|(a, b)| a == b).count();
    let longest = old.len().max(replacement.len());
    // A term is rarely missing beside a name that is alone on its side.
    let to_name = *slip == Slip::Term && old.is_empty() && names::parse(text[..span.start].trim()).is_some();
    // A factor is rarely missing there too.
    let of_name = *slip == Slip::Factor
        && text[..span.end].trim().is_empty()
        && text.split('=').next().is_some_and(|left| names::parse(left.trim()).is_some());
    let later = if of_name { HALF } else { usize::from(far || to_name) };
    (*slip, step, longest - same + later, span.start)
}

/// Whether an edit puts parentheses around what is printed, and changes nothing else.
pub(crate) fn adds_parentheses(text: &str, edit: &Edit) -> bool {
    let within = edit.replacement.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
    edit.slip == Slip::Parenthesis && within == Some(&text[edit.span.range()])
}

/// Whether an edit changes the ½ of a term that contains a square, as in ½mv² and ½kx². There the ½ is customary, so it is
/// hardly ever the mistake where another edit does as well.
pub(crate) fn changes_a_half(text: &str, edit: &Edit) -> bool {
    let halves = [r"\frac12", r"\frac{1}{2}", r"\tfrac12", r"\frac 12", r"\frac1 2"];
    let mut ends =
        halves.iter().flat_map(|half| text.match_indices(half).map(|(at, half)| Span::new(at, at + half.len())));
    ends.find(|half| half.contains(edit.span)).is_some_and(|half| {
        let rest = &text[half.end..];
        let term = rest.find(['+', '-', '=', '&', ',']).map_or(rest, |end| &rest[..end]);
        term.contains("^2") || term.contains("^{2}")
    })
}

/// Inserts repairs of another display into those of an equation's own, at most [`OFFERED`] in all.
///
/// The first of the others comes second. It comes first where the own repair adds or removes something and the other one
/// corrects a more frequent kind of slip.
pub(crate) fn insert_ranked(own: &mut Vec<Repair>, mut others: Vec<Repair>) {
    let is_known = |repair: &Repair| own.iter().any(|o| (o.span, &o.replacement) == (repair.span, &repair.replacement));
    others.retain(|repair| !is_known(repair));
    others.truncate(OFFERED - 1);
    // An edit that makes a fraction of a product does not exchange numerator and denominator.
    let kind = |repair: &Repair| if repair.replacement.starts_with(r"\frac{1}{") { Slip::Factor } else { repair.slip };
    let adds_or_removes = |kind: Slip| matches!(kind, Slip::Factor | Slip::Term);
    let kinds = own.first().map(kind).zip(others.first().map(kind));
    let likelier = kinds.is_some_and(|(own, other)| adds_or_removes(own) && other < own);
    let (at, next) = if likelier { (0, 1) } else { (1, usize::from(own.len() > 1)) };
    others.truncate(OFFERED - at - next);
    own.splice(at..at, others);
    own.truncate(OFFERED);
}
