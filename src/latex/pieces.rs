//! The parts of a display that are statements, before they are read: chains of members with relations between them.
//!
//! Commas, `\quad`, arrows, words such as `\text{and}`, rows and columns separate statements. A row that starts with a
//! relation or a sign continues the row before. Where it is not clear what a row continues, or what a comma or a point
//! means, the part has a fault.

use crate::formula::tree::Relation;
use crate::source::{Fault, Span};

use super::layout::{Delimiter, Item, Layout, latex};
use super::lexer::Space;
use super::reader::items::contents;
use super::reader::structure::is_prose;
use super::rows::{Row, is_operator, is_sign, is_significant, relation, rows};
use super::{names, value_lists};

/// The statements of a display.
///
/// In a display that is read for its structure, words are parts of their own, and what stands alone beside a comma is a part
/// of a list.
pub(super) fn pieces(items: &[Item], is_abstract: bool) -> Vec<Piece<'_>> {
    let mut pieces: Vec<Piece<'_>> = Vec::new();
    for (at, row) in rows(items, is_abstract).into_iter().enumerate() {
        split(row, at + 1, &mut pieces, is_abstract);
    }
    match is_abstract {
        true => join_lists(&mut pieces),
        false => reject_lone_values(&mut pieces),
    }
    pieces
}

/// A statement as items: each member with the relation before it; the first has none.
pub(super) struct Piece<'a> {
    pub(super) links: Vec<Link<'a>>,
    pub(super) constant: Option<Span>,
    /// What stands after "for", "if" or "when", from that word on; and what stands in parentheses after a wide space.
    pub(super) conditions: Vec<Vec<&'a Item>>,
    pub(super) row: usize,
    /// Why it cannot be read, whatever its items say.
    pub(super) fault: Option<Fault>,
    /// The comma that separates it from the part before it.
    comma: Option<&'a Item>,
}

/// The relation before a member and its place; `None` before the first.
pub(super) type Printed = Option<(Relation, Span)>;

pub(super) struct Link<'a> {
    pub(super) relation: Printed,
    pub(super) items: Vec<&'a Item>,
}

impl Piece<'_> {
    fn new(row: usize) -> Self {
        Piece { links: Vec::new(), constant: None, conditions: Vec::new(), row, fault: None, comma: None }
    }

    fn ends_with_a_relation(&self) -> bool {
        self.links.last().is_some_and(|link| link.relation.is_some() && link.items.is_empty())
    }

    /// Where it stands.
    pub(super) fn span(&self) -> Span {
        let spans = self.links.iter().flat_map(|link| {
            link.relation.iter().map(|(_, span)| *span).chain(link.items.iter().map(|item| item.span))
        });
        spans.reduce(Span::to).unwrap_or_default()
    }
}

/// Divides a row into statements and appends them.
fn split<'a>(row: Row<'a>, number: usize, pieces: &mut Vec<Piece<'a>>, is_abstract: bool) {
    let mut current: Option<Piece<'a>> = None;
    let mut comma: Option<&'a Item> = None;
    let mut starts_row = true;
    let mut at = 0;
    let unclear = pieces.last().and_then(|before| unclear_continuation(&row, before, pieces, is_abstract));
    if continues(&row, pieces.last()) {
        current = pieces.pop();
    }
    let items = row.items;
    while at < items.len() {
        let item = items[at];
        let is_wide = matches!(item.layout, Layout::Space(Space::Wide));
        // Before a row it indents what goes on.
        if is_wide && starts_row {
            at += 1;
            continue;
        }
        let is_thin = |item: &Item| matches!(item.layout, Layout::Space(space) if space != Space::Wide);
        let before = items[..at].iter().rev().find(|item| !is_thin(item));
        let is_fenced = matches!(item.layout, Layout::Fence(..)) && at > 0 && is_thin(items[at - 1]);
        let begins = is_fenced || before.is_none_or(|item| separates(item));
        let is_beside = current.is_some() || !pieces.is_empty();
        if let Some(length) = (begins && is_beside).then(|| value_lists::length(&items[at..])).flatten() {
            pieces.extend(current.take());
            comma = None;
            at += length;
            continue;
        }
        let of_condition = current.as_mut().filter(|piece| !piece.conditions.is_empty() && !ends_condition(&items, at));
        if let Some(condition) = of_condition.and_then(|piece| piece.conditions.last_mut()) {
            condition.push(item);
            at += 1;
            continue;
        }
        let before = current.as_mut().filter(|piece| piece.links.len() > 1);
        if let (Some(piece), true) = (before, begins_condition(item)) {
            piece.conditions.push(vec![item]);
            at += 1;
            continue;
        }
        // A wide space may stand before the condition: `x = 1 \quad \text{if } …`, `x = 1 \qquad (t > 0)`.
        let is_stop = is_wide || item.layout == Layout::Other(',');
        let pauses = || items[at..].iter().take_while(|next| is_pause(next));
        let has_wide = pauses().any(|next| next.layout == Layout::Space(Space::Wide));
        let next = items.get(at + pauses().count());
        let goes_on = next.is_some_and(|next| begins_condition(next) || has_wide && is_comparison(next))
            && value_lists::length(&items[(at + pauses().count()).min(items.len())..]).is_none();
        if let (true, true, Some(piece)) = (is_stop, goes_on, current.as_mut().filter(|piece| piece.links.len() > 1)) {
            while items.get(at).is_some_and(|item| is_pause(item)) {
                at += 1;
            }
            piece.conditions.push(vec![items[at]]);
            at += 1;
            continue;
        }
        if is_abstract && is_remark(&items, at) {
            pieces.extend(current.take());
            // What stands in parentheses after all, or says where a result is from, is no statement.
            if !is_aside(&items, at) {
                let mut remark = Piece::new(number);
                remark.links.push(Link { relation: None, items: vec![item] });
                pieces.push(remark);
            }
            comma = None;
            starts_row = false;
            at += 1;
            continue;
        }
        if separates(item) && !joins(&items, at) {
            // A wide space inside a statement is only layout: `a \quad = b`, `= 0 \quad \Rightarrow`.
            let relation_follows = items[at + 1..]
                .iter()
                .find(|next| !matches!(next.layout, Layout::Space(_)))
                .is_some_and(|next| relation(next).is_some());
            if !(is_wide && relation_follows) {
                let ends = current.is_some();
                pieces.extend(current.take());
                comma = match item.layout {
                    Layout::Other(',') if ends => Some(item),
                    _ => None,
                };
            }
            at += 1;
            continue;
        }
        let is_term = current
            .as_ref()
            .and_then(|piece| piece.links.last()?.items.iter().rev().find(is_significant))
            .is_some_and(|item| is_operator(item));
        let spelled =
            spelled_constant(&items, at).filter(|_| current.as_ref().is_some_and(Piece::ends_with_a_relation));
        if let Some(span) = says_constant(item).or(spelled.map(|(span, _)| span)).filter(|_| !is_term) {
            if let Some(piece) = &mut current {
                piece.constant = Some(span);
                if piece.links.last().is_some_and(|link| link.items.is_empty()) {
                    piece.links.pop();
                }
            }
            at += spelled.map_or(1, |(_, length)| length);
            continue;
        }
        let found = match (&item.layout, items.get(at + 1).map(|next| &next.layout)) {
            (Layout::Other(':'), Some(Layout::Other('='))) => {
                at += 1;
                Some(Relation::Identical)
            }
            _ => relation(item),
        };
        at += 1;
        if let Some(found) = found {
            let link = Link { relation: Some((found, item.span)), items: Vec::new() };
            if current.is_none() && starts_row && !pieces.is_empty() {
                current = pieces.pop();
            }
            let piece = current.get_or_insert_with(|| Piece::new(number));
            if piece.links.is_empty() {
                piece.links.push(Link { relation: None, items: Vec::new() });
            }
            piece.links.push(link);
            starts_row = false;
            continue;
        }
        if matches!(item.layout, Layout::Space(_)) && current.is_none() {
            continue;
        }
        let piece = current.get_or_insert_with(|| Piece { comma: comma.take(), ..Piece::new(number) });
        if piece.links.is_empty() {
            piece.links.push(Link { relation: None, items: Vec::new() });
        }
        if let Some(link) = piece.links.last_mut() {
            link.items.push(item);
        }
        if is_number_of_the_row(&items, at - 1) {
            piece.fault = Some(
                Fault::ambiguous(item.span, "this may be the number of the equation or a factor")
                    .help("write \\tag{…} for the number, or \\cdot before a factor"),
            );
        }
        starts_row = false;
    }
    pieces.extend(current);
    if let (Some(fault), Some(last)) = (unclear, pieces.last_mut()) {
        last.fault = Some(fault);
    }
}

/// Whether a row continues the formula of the row before: that row ends with an operator, or this row starts with a
/// sign and has no relation, or with a + , or with a sign after the mark where the relations stand.
fn continues(row: &Row<'_>, before: Option<&Piece<'_>>) -> bool {
    let Some(before) = before else { return false };
    let last = before.links.last();
    let open = last.is_some_and(|link| match link.items.iter().rev().find(is_significant) {
        Some(item) => is_operator(item),
        None => link.relation.is_some(),
    });
    let first = row.items.iter().find(is_significant).copied();
    let has_relation = row.items.iter().any(|item| relation(item).is_some());
    let adds = first.is_some_and(|item| {
        item.layout != Layout::Other('-') && is_operator(item) || is_sign(item) && (!has_relation || row.is_indented)
    });
    before.constant.is_none() && (open || adds)
}

/// The fault of a row that may continue the row before in more than one way, or be an equation of its own.
fn unclear_continuation(row: &Row<'_>, before: &Piece<'_>, pieces: &[Piece<'_>], is_abstract: bool) -> Option<Fault> {
    let first = row.items.iter().find(is_significant).copied()?;
    let has_relation = row.items.iter().any(|item| relation(item).is_some());
    let starts_with_relation = relation(first).is_some();
    if first.layout == Layout::Other('-') && has_relation && !row.is_indented && !row.is_aligned {
        return Some(
            Fault::ambiguous(first.span, "this row may continue the row before or be an equation of its own")
                .help("put & before the relation of each row, or write each equation in a display of its own"),
        );
    }
    let several = pieces.iter().filter(|piece| piece.row == before.row).count() > 1;
    if several && !is_abstract && (starts_with_relation || continues(row, Some(before))) {
        return Some(
            Fault::ambiguous(first.span, "this row may continue any statement of the row before")
                .help("write the statements of that row on rows of their own"),
        );
    }
    (row.follows_stop && !starts_with_relation && is_sign(first) && continues(row, Some(before))).then(|| {
        Fault::ambiguous(first.span, "this row starts with a sign, but the row before ends with a comma or a point")
            .help("remove the comma, or write the row as an equation")
    })
}

/// Whether a comma or a point does not separate statements: `1,000`, `a.b`, `x + ... + y`.
fn joins(items: &[&Item], at: usize) -> bool {
    let before = at.checked_sub(1).map(|before| items[before]);
    let after = items.get(at + 1).copied();
    let is_number = |item: Option<&Item>| item.is_some_and(|item| matches!(item.layout, Layout::Number(_)));
    let is_point = |item: Option<&Item>| item.is_some_and(|item| item.layout == Layout::Other('.'));
    match items[at].layout {
        Layout::Other(',') => {
            let touches = after.is_some_and(|next| next.span.start == items[at].span.end);
            touches && is_number(before) && is_number(after)
        }
        Layout::Other('.') => {
            let rest = items[at + 1..].iter().find(|next| !matches!(next.layout, Layout::Space(Space::Thin)));
            is_point(before) || is_point(after) || rest.is_some_and(|next| !separates(next))
        }
        _ => false,
    }
}

/// Whether an item begins a condition: `\text{for}`, `\text{if}`, `\forall`.
fn begins_condition(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\forall",
        Layout::Text(word) => matches!(
            word.trim_matches(|c: char| c == ',' || c == '.').to_ascii_lowercase().as_str(),
            "for"
                | "if"
                | "when"
                | "whenever"
                | "provided"
                | "providedthat"
                | "forall"
                | "forevery"
                | "foreach"
                | "forany"
        ),
        _ => false,
    }
}

/// Whether a condition ends here: at a wide space, or at a comma or a word before something that compares nothing.
fn ends_condition(items: &[&Item], at: usize) -> bool {
    match &items[at].layout {
        Layout::Space(Space::Wide) => items[at + 1..].iter().any(|next| !is_pause(next)),
        Layout::Other(';' | '.') => separates(items[at]) && !joins(items, at),
        Layout::Command(_) => separates(items[at]),
        Layout::Text(word) => separates(items[at]) && word != "and",
        _ => false,
    }
}

fn is_pause(item: &Item) -> bool {
    matches!(item.layout, Layout::Space(_) | Layout::Other(','))
}

/// Whether an item is a parenthesis with a comparison in it.
fn is_comparison(item: &Item) -> bool {
    matches!(&item.layout, Layout::Fence(Delimiter::Round, inside) if inside.iter().any(|item| relation(item).is_some()))
}

/// Whether the item is a whole number in parentheses at the end of the row, after a space: `F = ma \quad (2)`.
fn is_number_of_the_row(items: &[&Item], at: usize) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &items[at].layout else { return false };
    let is_number = matches!(inside.as_slice(), [Item { layout: Layout::Number(_), .. }]);
    let after_space = at > 0 && matches!(items[at - 1].layout, Layout::Space(_));
    let is_last = items[at + 1..].iter().all(|next| matches!(next.layout, Layout::Space(_) | Layout::Other('.' | ',')));
    is_number && after_space && is_last
}

/// Whether an item is words that stand between formulas, and no name: no operator or relation is beside it.
fn is_remark(items: &[&Item], at: usize) -> bool {
    // `= 1.65\,\omega \ (\text{over the whole range})`
    if let Layout::Fence(Delimiter::Round, inside) = &items[at].layout {
        const LONG: usize = 10;
        let is_phrase = |item: &Item| matches!(&item.layout, Layout::Text(word) if !is_unit(word) && (word.len() >= LONG || is_prose(word)));
        let is_apart = at > 0 && matches!(items[at - 1].layout, Layout::Space(_));
        return is_apart && inside.iter().any(is_phrase);
    }
    let word = match &items[at].layout {
        Layout::Text(word) => word.clone(),
        Layout::Style(style, inner) if style == "\\mathrm" => {
            let word = latex(contents(inner));
            if !is_prose(&word) {
                return false;
            }
            word
        }
        _ => return false,
    };
    // `\text{Tr}(A)` is a function, `\mathrm{SO}(3)` a group.
    let is_function = matches!(items.get(at + 1).map(|next| &next.layout), Some(Layout::Fence(Delimiter::Round, _)));
    let is_capital = word.len() > 1 && word.chars().all(|c| c.is_ascii_uppercase());
    if is_function && (is_capital || !is_prose(&word)) {
        return false;
    }
    let number = items[..at].iter().rev().find(is_significant).is_some_and(|item| is_figure(item));
    if number && is_unit(&word) {
        return false;
    }
    let bound = |item: &&Item| is_operator(item) || relation(item).is_some();
    let beside = |mut near: std::iter::Skip<std::slice::Iter<'_, &Item>>| near.find(is_significant).is_some_and(bound);
    let before = items[..at].iter().rev().find(is_significant).is_some_and(bound);
    !word.is_empty()
        && says_constant(items[at]).is_none()
        && !begins_condition(items[at])
        && !before
        && !beside(items.iter().skip(at + 1))
}

/// Whether a remark only explains: words in parentheses, or words at the end of a row that restrict nothing.
fn is_aside(items: &[&Item], at: usize) -> bool {
    if at == 0 {
        return false;
    }
    let is_last = items[at + 1..].iter().all(|next| matches!(next.layout, Layout::Space(_) | Layout::Other('.' | ',')));
    match &items[at].layout {
        Layout::Fence(..) => is_last,
        // `\text{ by hypothesis}`, `\text{using the chain rule}`; spaces are left out of a text.
        Layout::Text(word) => {
            is_last
                && ["by", "using", "from", "since"]
                    .iter()
                    .any(|first| word.len() > first.len() + 3 && word.starts_with(first))
        }
        _ => false,
    }
}

/// A number, or a power of one.
fn is_figure(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(digits) => digits != "0",
        Layout::Scripts { nucleus, sub: None, sup: Some(_), .. } => matches!(nucleus.layout, Layout::Number(_)),
        _ => false,
    }
}

/// Whether a word after a number is a unit, and no remark: `m/s`, `eV`, `days`.
fn is_unit(word: &str) -> bool {
    const UNITS: [&str; 59] = [
        "m", "cm", "mm", "km", "nm", "fm", "pm", "s", "ms", "ns", "min", "h", "kg", "g", "mg", "N", "kN", "J", "kJ",
        "MJ", "W", "kW", "MW", "eV", "keV", "MeV", "GeV", "TeV", "K", "Pa", "kPa", "MPa", "bar", "atm", "Hz", "kHz",
        "MHz", "GHz", "V", "kV", "A", "mA", "T", "C", "mol", "rad", "sr", "deg", "days", "day", "years", "year", "yr",
        "hours", "seconds", "rpm", "RPM", "Nm", "Js",
    ];
    let word = word.trim_end_matches(['.', ',', ';']);
    let is_one = |part: &str| {
        let unit =
            part.trim_end_matches(|c: char| c.is_ascii_digit() || matches!(c, '^' | '-' | '−' | '²' | '³' | '{' | '}'));
        UNITS.contains(&unit)
    };
    !word.is_empty() && word.split(['/', '·', '*', '(', ')', '\u{a0}']).filter(|part| !part.is_empty()).all(is_one)
}

/// Joins what stands alone beside a comma with its neighbour: `i = 1, 2, 3` and `x, y > 0` have lists as members.
fn join_lists(pieces: &mut Vec<Piece<'_>>) {
    let is_whole = |piece: &Piece<'_>| piece.links.len() > 1 || piece.constant.is_some();
    let mut joined: Vec<Piece<'_>> = Vec::with_capacity(pieces.len());
    for mut here in std::mem::take(pieces) {
        let fits = |before: &Piece<'_>| {
            let is_plain = before.conditions.is_empty() && before.fault.is_none() && before.constant.is_none();
            let is_part = !is_whole(&here) && here.conditions.is_empty() || !is_whole(before);
            here.comma.is_some() && before.row == here.row && here.fault.is_none() && is_plain && is_part
        };
        let Some(before) = joined.last_mut().filter(|before| fits(before)) else {
            joined.push(here);
            continue;
        };
        if let (Some(last), false) = (before.links.last_mut(), here.links.is_empty()) {
            last.items.extend(here.comma);
            last.items.append(&mut here.links.remove(0).items);
        }
        before.links.append(&mut here.links);
        before.conditions.append(&mut here.conditions);
        before.constant = here.constant;
    }
    *pieces = joined;
}

/// Marks statements without a relation beside statements with one: the values of `i = 1, 2, 3`, the x of `x, y > 0`.
fn reject_lone_values(pieces: &mut [Piece<'_>]) {
    let is_whole = |piece: &Piece<'_>| piece.links.len() > 1 || piece.constant.is_some();
    if !pieces.iter().any(is_whole) {
        return;
    }
    for piece in pieces.iter_mut().filter(|piece| !is_whole(piece) && piece.fault.is_none()) {
        let what = "this part has no relation of its own: it may be one of several values, or share a relation";
        piece.fault = Some(
            Fault::ambiguous(piece.span(), what).help("write an equation for each value, and a relation for each name"),
        );
    }
}

fn separates(item: &Item) -> bool {
    match &item.layout {
        Layout::Other(',' | ';' | '.') | Layout::Space(Space::Wide) => true,
        Layout::Command(name) => matches!(name.as_str(), "\\Rightarrow" | "\\Leftrightarrow" | "\\therefore"),
        Layout::Text(word) => matches!(
            word.trim_matches(|c: char| c == ',' || c == '.'),
            "and" | "so" | "hence" | "thus" | "therefore" | "sothat" | "where" | "with" | ""
        ),
        _ => false,
    }
}

/// The letters of `constant` or `const` at the end of a side, with their number.
fn spelled_constant(items: &[&Item], at: usize) -> Option<(Span, usize)> {
    let letter = |item: &&Item| match item.layout {
        Layout::Letter(c) => Some(c),
        _ => None,
    };
    let word: String = items[at..].iter().map_while(letter).collect();
    let last = items.get(at + word.len().checked_sub(1)?)?;
    let ends = items.get(at + word.len()).is_none_or(|next| separates(next) || matches!(next.layout, Layout::Space(_)));
    (ends && ["constant", "const", "Constant"].contains(&word.as_str()))
        .then(|| (items[at].span.to(last.span), word.len()))
}

/// The place of the words that a side is constant: `\text{ is constant}`, `\mathrm{const}`.
pub fn says_constant(item: &Item) -> Option<Span> {
    let word = match &item.layout {
        Layout::Text(word) => word.clone(),
        Layout::Style(style, _) if style == "\\mathrm" => names::printed(item, None)?.name.base,
        Layout::Scripts { .. } => return None,
        _ => return None,
    };
    let word = word.trim_start_matches("\\mathrm{").trim_end_matches(['}', '.', ',', ';', ' ']);
    matches!(word, "isconstant" | "isconserved" | "const" | "constant" | "=const").then_some(item.span)
}
