//! The division of a row into statements, item by item.

use crate::formula::tree::Relation;
use crate::formula::units::Unit;
use crate::source::Fault;

use super::super::layout::{Item, Layout};
use super::super::lexer::Space;
use super::super::rows::{Row, is_operator, is_sign, is_significant, relation};
use super::alternatives::{alternatives, are_open};
use super::asides;
use super::conditions::{begins_condition, ends_condition, is_comparison, is_pause};
use super::continuation::{continues, unclear_continuation};
use super::numbers::{
    ends_the_row, is_equation_number, is_number_before_a_row, is_number_of_the_row, length_before_a_row,
};
use super::piece::{Link, Piece};
use super::premises;
use super::remarks::{self, is_aside, is_remark};
use super::separators::{ends_a_word, joins, says_constant, separates, spelled_constant};
use super::value_lists;

/// Divides a row into statements and appends them.
pub(super) fn split<'a>(row: Row<'a>, number: usize, pieces: &mut Vec<Piece<'a>>, is_abstract: bool) {
    let unclear = pieces.last().and_then(|before| unclear_continuation(&row, before, pieces, is_abstract));
    let current = if continues(&row, pieces.last()) { pieces.pop() } else { None };
    let items = asides::opened(row.items);
    let (premise, items) = if current.is_none() { premises::divided(&items) } else { (Vec::new(), items) };
    let first = pieces.len();
    let splitter = Splitter {
        at: length_before_a_row(&items).max(remarks::name_of_the_row(&items)),
        items: &items,
        number,
        is_abstract,
        pieces,
        current,
        comma: None,
        is_inserted: false,
        starts_row: true,
    };
    splitter.run();
    for piece in pieces.iter_mut().skip(first).filter(|piece| piece.links.len() > 1 && !premise.is_empty()) {
        piece.conditions.push(premise.clone());
    }
    if let (Some(fault), Some(last)) = (unclear, pieces.last_mut()) {
        last.fault = Some(fault);
    }
}

/// A row as far as it is divided.
struct Splitter<'a, 'p> {
    items: &'p [&'a Item],
    /// The place of the next item.
    at: usize,
    /// The number of the row.
    number: usize,
    is_abstract: bool,
    /// The statements that are complete.
    pieces: &'p mut Vec<Piece<'a>>,
    /// The statement to which the next item belongs.
    current: Option<Piece<'a>>,
    /// The comma before the next statement.
    comma: Option<&'a Item>,
    /// Whether a wide space alone stands before the next statement.
    is_inserted: bool,
    /// Whether nothing of the row was taken yet.
    starts_row: bool,
}

impl<'a> Splitter<'a, '_> {
    /// Takes the items in their order. Each step takes what it knows, and leaves the rest to the next ones.
    fn run(mut self) {
        let alternatives = alternatives(self.items);
        while self.at < self.items.len() {
            if let Some(place) = alternatives.iter().find(|place| place.start == self.at) {
                self.take_alternatives(place.clone());
                continue;
            }
            // Before a row spaces indent what goes on.
            if matches!(self.item().layout, Layout::Space(_)) && self.starts_row {
                self.at += 1;
                continue;
            }
            if self.takes_number() || self.takes_arrow() || self.takes_values() || self.takes_condition() {
                continue;
            }
            self.note_unclear_arrow();
            if self.takes_remark() {
                continue;
            }
            // `= \mathrm{const}. = b`: the point ends a word.
            if ends_a_word(self.items, self.at) {
                self.at += 1;
                continue;
            }
            if !self.takes_separator() && !self.takes_constant() {
                self.take_relation_or_item();
            }
        }
        self.end();
    }

    fn item(&self) -> &'a Item {
        self.items[self.at]
    }

    fn is_wide(&self) -> bool {
        matches!(self.item().layout, Layout::Space(Space::Wide))
    }

    /// Ends the current statement.
    fn end(&mut self) {
        let Some(mut piece) = self.current.take() else { return };
        // `F = -kx \quad \text{(spring)} - bv`
        let is_beside = self.pieces.last().is_some_and(|before| before.row == piece.row);
        if let [Link { relation: None, items, .. }] = piece.links.as_slice()
            && is_beside
            && piece.comma.is_none()
            && !piece.has_sign()
            && let Some(first) = begins_with_a_sign(items)
        {
            let what = "a wide space or words stand between this term and its equation";
            let fault = Fault::unsupported(first.span, what).help("leave out the space or the words before this term");
            piece.fault.get_or_insert(fault);
        }
        if let Some(space) = piece.unclear_space() {
            let what = "this space may stand between two factors or between two statements";
            let fault = Fault::ambiguous(space, what).help("write \\cdot for a product, or \\quad between statements");
            piece.fault.get_or_insert(fault);
        }
        self.pieces.push(piece);
    }

    /// The current statement, if it has a relation.
    fn equation(&mut self) -> Option<&mut Piece<'a>> {
        self.current.as_mut().filter(|piece| piece.links.len() > 1)
    }

    fn take_alternatives(&mut self, place: std::ops::Range<usize>) {
        self.end();
        let items = &self.items[place.clone()];
        let several = one_of_several(items, self.number, self.is_abstract, self.pieces.last_mut());
        self.pieces.push(several);
        (self.comma, self.starts_row, self.at) = (None, false, place.end);
    }

    /// Takes the number of the equation at the end of a row, behind a wide space: `F = ma \qquad (7-47)`.
    fn takes_number(&mut self) -> bool {
        let (items, at) = (self.items, self.at);
        let is_apart = at > 0 && items[at - 1].layout == Layout::Space(Space::Wide);
        let is_number = self.is_abstract && is_apart && ends_the_row(items, at) && is_equation_number(items[at]);
        // `W = mg \quad \text{(N)} \quad (1-2)`: a remark may stand before the number.
        let before = self.pieces.iter().rev().find(|piece| !piece.is_a_remark());
        let states = self.current.as_ref().or(before).is_some_and(|piece| piece.links.len() > 1);
        if !is_number || !states {
            return false;
        }
        self.end();
        self.at = items.len();
        true
    }

    /// Takes an arrow that stands alone between two equations: `a = b \quad\to\quad c = d`.
    fn takes_arrow(&mut self) -> bool {
        let item = self.item();
        let follows = self.current.is_none() && self.pieces.last().is_some_and(|piece| piece.links.len() > 1);
        let rest = &self.items[self.at + 1..];
        let spaces = rest.iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
        if !self.is_abstract || !follows || !states_something(&rest[spaces..]) {
            return false;
        }
        match &item.layout {
            Layout::Scripts { nucleus, .. } if is_arrow(nucleus) => {
                let what = "a condition above or below an arrow is not supported";
                let fault = Fault::unsupported(item.span, what).help("write the condition beside its equation");
                let mut piece = Piece { fault: Some(fault), ..Piece::new(self.number) };
                piece.links.push(Link { relation: None, sign: None, items: vec![item] });
                self.pieces.push(piece);
            }
            _ if is_arrow(item) => {}
            _ => return false,
        }
        (self.starts_row, self.at) = (false, self.at + 1);
        true
    }

    /// Takes a list of values, which says for what the statement beside it holds: `n = 1, 2, 3`.
    fn takes_values(&mut self) -> bool {
        let is_thin = |item: &Item| matches!(item.layout, Layout::Space(space) if space != Space::Wide);
        let before = self.items[..self.at].iter().rev().find(|item| !is_thin(item));
        let is_fenced =
            matches!(self.item().layout, Layout::Fence(..)) && self.at > 0 && is_thin(self.items[self.at - 1]);
        let begins = is_fenced || before.is_none_or(|item| separates(item));
        let is_beside = self.current.is_some() || !self.pieces.is_empty();
        let length = (begins && is_beside).then(|| value_lists::length(&self.items[self.at..])).flatten();
        let Some(length) = length else { return false };
        self.end();
        self.comma = None;
        self.at += length;
        true
    }

    /// Takes an item of a condition, or the first one of a condition.
    fn takes_condition(&mut self) -> bool {
        let (items, at, item) = (self.items, self.at, self.item());
        let of_condition =
            self.current.as_mut().filter(|piece| !piece.conditions.is_empty() && !ends_condition(items, at));
        if let Some(condition) = of_condition.and_then(|piece| piece.conditions.last_mut()) {
            condition.push(item);
            self.at += 1;
            return true;
        }
        let is_abstract = self.is_abstract;
        let before =
            self.current.as_mut().filter(|piece| piece.links.len() > 1 || is_abstract && !piece.links.is_empty());
        if let (Some(piece), true) = (before, begins_condition(item)) {
            piece.conditions.push(vec![item]);
            self.at += 1;
            return true;
        }
        // A wide space may stand before the condition: `x = 1 \quad \text{if } …`, `x = 1 \qquad (t > 0)`.
        let is_stop = self.is_wide() || matches!(item.layout, Layout::Other(',' | ';'));
        let pauses = || items[at + 1..].iter().take_while(|next| is_pause(next));
        let has_wide = self.is_wide() || pauses().any(|next| next.layout == Layout::Space(Space::Wide));
        let after = at + 1 + pauses().count();
        let next = items.get(after);
        let goes_on = next.is_some_and(|next| begins_condition(next) || has_wide && is_comparison(next))
            && value_lists::length(&items[after.min(items.len())..]).is_none();
        match (is_stop && goes_on, next) {
            (true, Some(next)) => {
                let Some(piece) = self.equation() else { return false };
                piece.conditions.push(vec![*next]);
                self.at = after + 1;
                true
            }
            _ => false,
        }
    }

    fn note_unclear_arrow(&mut self) {
        let item = self.item();
        if !is_arrow(item) || !states_something(&self.items[self.at + 1..]) {
            return;
        }
        if let Some(piece) = self.equation() {
            let what = "this arrow may mean “implies” or “tends to”";
            let fault =
                Fault::ambiguous(item.span, what).help("write \\Rightarrow for “implies”, or write two displays");
            piece.fault.get_or_insert(fault);
        }
    }

    /// Takes words that are a part of their own, where only the structure is read.
    fn takes_remark(&mut self) -> bool {
        let (items, at, item) = (self.items, self.at, self.item());
        if !self.is_abstract || !is_remark(items, at) {
            return false;
        }
        // `\Gamma \text{ is unique}`
        if let Some(name) = self.current.as_mut().filter(|piece| piece.links.len() == 1 && !piece.has_sign())
            && !is_aside(items, at)
        {
            name.fault.get_or_insert_with(|| match &item.layout {
                Layout::Text(word) if Unit::named(word).is_some() => {
                    Fault::unsupported(item.span, "a unit after a letter or a formula is not supported")
                        .help("remove the unit, or write it after a number")
                }
                _ => Fault::unsupported(
                    item.span,
                    "a statement in words about a formula, such as “is unique”, is not supported",
                )
                .help("write an equation; if the words only explain, put a comma before them"),
            });
        }
        if remarks::may_be_a_unit(items, at)
            && let Some(piece) = self.current.as_mut().filter(|piece| piece.links.len() > 1)
        {
            let what = "words directly behind a number may be its unit or a remark";
            let help = "write a unit as \\mathrm{…}, and \\quad before a remark";
            piece.fault.get_or_insert_with(|| Fault::ambiguous(item.span, what).help(help));
        }
        self.end();
        // What stands in parentheses after all, or says where a result is from, is no statement.
        if !is_aside(items, at) {
            let mut remark = Piece::new(self.number);
            remark.links.push(Link { relation: None, sign: None, items: vec![item] });
            self.pieces.push(remark);
        }
        (self.comma, self.starts_row) = (None, false);
        self.at += 1;
        true
    }

    /// Takes what separates two statements.
    fn takes_separator(&mut self) -> bool {
        let (items, at, item) = (self.items, self.at, self.item());
        if !separates(item) || joins(items, at) {
            return false;
        }
        // A wide space inside a statement is only layout: `a \quad = b`, `= 0 \quad \Rightarrow`.
        let relation_follows = items[at + 1..]
            .iter()
            .find(|next| !matches!(next.layout, Layout::Space(_)))
            .is_some_and(|next| relation(next).is_some());
        // `\min_x \quad f(x)`, `a = \quad b`: what follows belongs to it.
        let goes_on = self.current.as_ref().is_some_and(|piece| {
            piece.is_an_extremum()
                || piece.ends_with_a_relation()
                || piece.links.len() > 1 && is_a_further_term(items, at)
        });
        if !(self.is_wide() && (relation_follows || goes_on)) {
            let ends = self.current.is_some();
            self.is_inserted = self.is_wide() && (ends || self.is_inserted);
            self.end();
            self.comma = match item.layout {
                Layout::Other(',') if ends => Some(item),
                _ => None,
            };
        }
        self.at += 1;
        true
    }

    /// Takes the words that say of the statement that it is constant.
    fn takes_constant(&mut self) -> bool {
        let is_term = self
            .current
            .as_ref()
            .and_then(|piece| piece.links.last()?.items.iter().rev().find(is_significant))
            .is_some_and(|item| is_operator(item));
        let spelled = spelled_constant(self.items, self.at)
            .filter(|_| self.current.as_ref().is_some_and(Piece::ends_with_a_relation));
        // `\text{const} + x` too is a sum.
        let after = self.at + spelled.map_or(1, |(_, length)| length);
        let goes_on = self.items[after..].iter().find(is_significant).is_some_and(|item| is_operator(item));
        let said = says_constant(self.item()).or(spelled.map(|(span, _)| span)).filter(|_| !is_term && !goes_on);
        let Some(span) = said else { return false };
        if let Some(piece) = &mut self.current {
            piece.constant = Some(span);
            if piece.links.last().is_some_and(|link| link.items.is_empty()) {
                piece.links.pop();
            }
        }
        self.at += spelled.map_or(1, |(_, length)| length);
        true
    }

    fn take_relation_or_item(&mut self) {
        let item = self.item();
        let found = match (&item.layout, self.items.get(self.at + 1).map(|next| &next.layout)) {
            (Layout::Other(':'), Some(Layout::Other('='))) | (Layout::Other('='), Some(Layout::Other(':'))) => {
                self.at += 1;
                Some(Relation::Identical)
            }
            _ => relation(item),
        };
        let at = self.at;
        self.at += 1;
        match found {
            Some(found) => self.add_relation(found, item),
            None if matches!(item.layout, Layout::Space(_)) && self.current.is_none() => {}
            None => self.add_item(item, at),
        }
    }

    fn add_relation(&mut self, found: Relation, item: &'a Item) {
        if self.current.is_none() && self.starts_row && !self.pieces.is_empty() {
            self.current = self.pieces.pop();
        }
        let (number, starts_row) = (self.number, self.starts_row);
        let piece = self.current.get_or_insert_with(|| Piece::new(number));
        if piece.links.is_empty() {
            piece.links.push(Link { relation: None, sign: None, items: Vec::new() });
        }
        // `a = \\ = b` repeats the sign at the beginning of the row.
        let is_again = starts_row
            && piece.links.last().is_some_and(|last| {
                last.relation.is_some_and(|(before, _)| before == found)
                    && !last.items.iter().any(|item| is_significant(&item))
            });
        if !is_again {
            piece.links.push(Link { relation: Some((found, item.span)), sign: Some(item), items: Vec::new() });
        }
        self.starts_row = false;
    }

    /// Adds an item to the last member of the statement.
    fn add_item(&mut self, item: &'a Item, at: usize) {
        let (comma, number, is_inserted) = (&mut self.comma, self.number, self.is_inserted);
        let piece =
            self.current.get_or_insert_with(|| Piece { comma: comma.take(), is_inserted, ..Piece::new(number) });
        if piece.links.is_empty() {
            piece.links.push(Link { relation: None, sign: None, items: Vec::new() });
        }
        if let Some(link) = piece.links.last_mut() {
            link.items.push(item);
        }
        if is_number_of_the_row(self.items, at) || is_number_before_a_row(self.items, at) {
            piece.fault = Some(
                Fault::ambiguous(item.span, "this number may be that of the equation, or a factor")
                    .help("write \\tag{…} for the number, or \\cdot before a factor"),
            );
        }
        self.starts_row = false;
    }
}

/// The sign at the beginning of some items, after a remark perhaps: `\text{(spring)} - bv`.
fn begins_with_a_sign<'a>(items: &[&'a Item]) -> Option<&'a Item> {
    let mut solid = items.iter().filter(is_significant);
    let first = *solid.next()?;
    let sign = if matches!(first.layout, Layout::Text(_)) { *solid.next()? } else { first };
    is_sign(sign).then_some(sign)
}

/// Whether a term with its sign follows a space, and no relation up to the next separator: `x = a \quad + b`.
fn is_a_further_term(items: &[&Item], at: usize) -> bool {
    let rest = &items[at + 1..];
    let Some(first) = rest.iter().position(|item| !matches!(item.layout, Layout::Space(_))) else { return false };
    let end = rest[first..].iter().position(|item| separates(item)).map_or(rest.len(), |end| first + end);
    let is_sign = matches!(rest[first].layout, Layout::Other('+' | '-'));
    is_sign && end > first + 1 && !rest[first..end].iter().any(|item| relation(item).is_some())
}

/// Alternatives as one part. Where the first of them is in the row before, that row is none of its own either.
fn one_of_several<'a>(items: &[&'a Item], row: usize, is_abstract: bool, before: Option<&mut Piece<'a>>) -> Piece<'a> {
    let mut piece = Piece { has_alternatives: true, ..Piece::new(row) };
    piece.links.push(Link { relation: None, sign: None, items: items.to_vec() });
    let is_open = are_open(items);
    if is_open || !is_abstract {
        let what = "“or” between equations is not supported";
        let fault =
            |span| Fault::unsupported(span, what).help("write only one of the equations, or a display for each");
        if let Some(before) = before.filter(|_| is_open) {
            before.fault = Some(fault(before.span()));
        }
        piece.fault = Some(fault(piece.span()));
    }
    piece
}

/// Whether an item is a simple arrow.
fn is_arrow(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name)
        if ["\\rightarrow", "\\longrightarrow", "\\to", "\\leadsto"].contains(&name.as_str()))
}

/// Whether an equation stands before the next separator.
fn states_something(items: &[&Item]) -> bool {
    items.iter().take_while(|item| !separates(item)).any(|item| is_equation(item))
}

/// Whether an item is a relation, or a box around an equation.
fn is_equation(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) if name == "\\boxed" => true,
        Layout::Group(items) => items.iter().any(|item| relation(item).is_some()),
        _ => relation(item).is_some() && !is_arrow(item),
    }
}
