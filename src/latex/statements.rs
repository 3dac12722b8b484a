//! The statements of a display: rows, commas, `\Rightarrow`, chains of relations, branches of ±, "is constant".
//!
//! Rows, `\quad`, commas and arrows separate statements. A row that starts with a relation continues the row before. A
//! statement with `±` is read twice: once with all upper signs, once with all lower signs. An unknown name that is a
//! whole member is defined by the statement ([`super::definitions`]).

use crate::formula::shape::{self, Shape, Type};
use crate::formula::symbols::Symbols;
use crate::formula::tree::{Expr, IndexId, Relation, Sign, Statement};
use crate::source::{Fault, Span};

use super::definitions::{DefinedSymbol, New, Place, Unknown};
use super::layout::{Item, Layout, typeset_items};
use super::lexer::Space;
use super::macros::Macros;
use super::names;
use super::reader::Reader;

/// The result of reading a display.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// The statements in order; a fault for one that cannot be read.
    pub statements: Vec<Result<Statement, Fault>>,
    /// The symbols that the statements define, in the order in which they were added to the symbol table.
    pub introduced: Vec<DefinedSymbol>,
}

/// The most times that a display is read again because its statements defined further names.
const ROUNDS: usize = 8;

/// Reads a display: the text between its delimiters.
pub fn read_display(text: &str, symbols: &mut Symbols, macros: &Macros) -> Reading {
    let mut reading = Reading::default();
    let items = match typeset_items(text, macros) {
        Ok(items) => items,
        Err(fault) => {
            reading.statements.push(Err(fault));
            return reading;
        }
    };
    if let Some(span) = grouped_number(&items) {
        let number = text.get(span.range()).unwrap_or_default();
        let fault = Fault::ambiguous(span, format!("{number} may be one number, or two parts of a list"))
            .help("for one number, leave the comma out; for a list, put a space after the comma");
        reading.statements.push(Err(fault));
        return reading;
    }
    let mut pieces: Vec<Piece> = Vec::new();
    for (row, items) in rows(&items).into_iter().enumerate() {
        split(items, row + 1, &mut pieces);
    }
    if pieces.is_empty() {
        let fault = Fault::new(Span::new(0, text.len()), "this display is empty");
        reading.statements.push(Err(fault));
    }
    let mut pending = Vec::new();
    for piece in &pieces {
        let branches: &[Option<Sign>] = match piece.links.iter().any(|link| link.items.iter().any(has_branch)) {
            true => &[Some(Sign::Plus), Some(Sign::Minus)],
            false => &[None],
        };
        pending.extend(branches.iter().map(|branch| (piece, *branch)));
    }
    let mut results = vec![None; pending.len()];
    let mut pending: Vec<(usize, (&Piece<'_>, Option<Sign>))> = pending.into_iter().enumerate().collect();
    // A name may be used before the display says what it is: `= \frac{1}{M} …, \quad M = …`.
    for _ in 0..ROUNDS {
        let known = symbols.len();
        pending.retain(|(at, (piece, branch))| match piece.read(symbols, *branch) {
            Ok((statement, news)) => {
                for (member, new) in news {
                    if let Some((symbol, formula)) = new.add(symbols) {
                        reading.introduced.push(DefinedSymbol { symbol, statement: *at, member, formula });
                    }
                }
                results[*at] = Some(Ok(statement));
                false
            }
            Err(fault) => {
                results[*at] = Some(Err(fault));
                true
            }
        });
        if pending.is_empty() || symbols.len() == known {
            break;
        }
    }
    reading.statements.extend(results.into_iter().flatten());
    reading
}

/// A statement as items: each member with the relation before it; the first has none.
struct Piece<'a> {
    links: Vec<Link<'a>>,
    constant: Option<Span>,
    row: usize,
}

/// The relation before a member and its place; `None` before the first.
type Printed = Option<(Relation, Span)>;

struct Link<'a> {
    relation: Printed,
    items: Vec<&'a Item>,
}

/// The rows of a display, or of the `aligned` or `split` environment that is the whole display.
fn rows(items: &[Item]) -> Vec<Vec<&Item>> {
    let significant: Vec<&Item> =
        items.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Other('.' | ','))).collect();
    if let [Item { layout: Layout::Environment(name, rows), .. }] = significant.as_slice()
        && matches!(
            name.trim_end_matches('*'),
            "aligned" | "split" | "gathered" | "align" | "gather" | "alignedat" | "equation" | "eqnarray"
        )
    {
        return rows.iter().map(|row| row.iter().flatten().collect()).collect();
    }
    items
        .split(|item| item.layout == Layout::Row)
        .map(|row| row.iter().filter(|item| item.layout != Layout::Align).collect())
        .collect()
}

/// Divides a row into statements and appends them.
fn split<'a>(items: Vec<&'a Item>, row: usize, pieces: &mut Vec<Piece<'a>>) {
    let mut current: Option<Piece<'a>> = None;
    let mut starts_row = true;
    let mut at = 0;
    if continues(&items, pieces.last()) {
        current = pieces.pop();
    }
    while at < items.len() {
        let item = items[at];
        let mut close = |current: &mut Option<Piece<'a>>| pieces.extend(current.take());
        let is_wide = matches!(item.layout, Layout::Space(Space::Wide));
        // Before a row it indents what goes on.
        if is_wide && starts_row {
            at += 1;
            continue;
        }
        if separates(item) {
            // A wide space inside a statement is only layout: `a \quad = b`, `= 0 \quad \Rightarrow`.
            let relation_follows = items[at + 1..]
                .iter()
                .find(|next| !matches!(next.layout, Layout::Space(_)))
                .is_some_and(|next| relation(next).is_some());
            if !(is_wide && relation_follows) {
                close(&mut current);
            }
            at += 1;
            continue;
        }
        if let Some(span) = says_constant(item) {
            if let Some(piece) = &mut current {
                piece.constant = Some(span);
                if piece.links.last().is_some_and(|link| link.items.is_empty()) {
                    piece.links.pop();
                }
            }
            at += 1;
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
            let piece = current.get_or_insert_with(|| Piece { links: Vec::new(), constant: None, row });
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
        let piece = current.get_or_insert_with(|| Piece { links: Vec::new(), constant: None, row });
        if piece.links.is_empty() {
            piece.links.push(Link { relation: None, items: Vec::new() });
        }
        if let Some(link) = piece.links.last_mut() {
            link.items.push(item);
        }
        starts_row = false;
    }
    pieces.extend(current);
}

/// Whether a row continues the formula of the row before: that row ends with an operator, or this row starts with a
/// sign and has no relation.
fn continues(items: &[&Item], before: Option<&Piece<'_>>) -> bool {
    let Some(before) = before else { return false };
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
    let is_operator = |item: &Item| {
        is_sign(item) || matches!(&item.layout, Layout::Command(name) if matches!(name.as_str(), "\\cdot" | "\\times"))
    };
    let is_empty = |item: &Item| matches!(&item.layout, Layout::Group(items) if items.is_empty());
    let significant = |item: &&&Item| !matches!(item.layout, Layout::Space(_)) && !is_empty(item);
    let last = before.links.last();
    let open = last.is_some_and(|link| match link.items.iter().rev().find(significant) {
        Some(item) => is_operator(item),
        None => link.relation.is_some(),
    });
    let first = items.iter().find(significant).copied();
    let adds = first.is_some_and(|item| {
        item.layout != Layout::Other('-') && is_operator(item)
            || is_sign(item) && !items.iter().any(|item| relation(item).is_some())
    });
    before.constant.is_none() && (open || adds)
}

/// Digits with a comma before the last three, `1,000`, without a space.
fn grouped_number(items: &[Item]) -> Option<Span> {
    let is_comma = |item: &Item| item.layout == Layout::Other(',');
    items.windows(3).find_map(|window| match window {
        [a @ Item { layout: Layout::Number(first), .. }, comma, b @ Item { layout: Layout::Number(second), .. }]
            if is_comma(comma)
                && (1..=3).contains(&first.len())
                && second.split('.').next().is_some_and(|whole| whole.len() == 3)
                && a.span.end == comma.span.start
                && comma.span.end == b.span.start =>
        {
            Some(a.span.to(b.span))
        }
        _ => None,
    })
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

/// `\text{ is constant}`, `\mathrm{const}`.
fn says_constant(item: &Item) -> Option<Span> {
    let word = match &item.layout {
        Layout::Text(word) => word.clone(),
        Layout::Style(style, _) if style == "\\mathrm" => names::printed(item, None)?.name.base,
        Layout::Scripts { .. } => return None,
        _ => return None,
    };
    let word = word.trim_start_matches("\\mathrm{").trim_end_matches(['}', '.', ',', ';', ' ']);
    matches!(word, "isconstant" | "isconserved" | "const" | "constant" | "=const").then_some(item.span)
}

fn relation(item: &Item) -> Option<Relation> {
    Some(match &item.layout {
        Layout::Other('=') => Relation::Equal,
        Layout::Other('<') => Relation::Less,
        Layout::Other('>') => Relation::Greater,
        Layout::Other('≈') => Relation::Approximately,
        Layout::Other('≡') => Relation::Identical,
        Layout::Other('≤') => Relation::LessEqual,
        Layout::Other('≥') => Relation::GreaterEqual,
        Layout::Other('≠') => Relation::NotEqual,
        Layout::Command(name) => match name.as_str() {
            "\\equiv" | "\\coloneqq" => Relation::Identical,
            "\\lt" => Relation::Less,
            "\\gt" => Relation::Greater,
            "\\leq" => Relation::LessEqual,
            "\\geq" => Relation::GreaterEqual,
            "\\neq" => Relation::NotEqual,
            "\\approx" => Relation::Approximately,
            "\\propto" => Relation::Proportional,
            _ => return None,
        },
        _ => return None,
    })
}

fn has_branch(item: &&Item) -> bool {
    fn inside(item: &Item) -> bool {
        match &item.layout {
            Layout::Command(name) => name == "\\pm" || name == "\\mp",
            Layout::Group(items) | Layout::Fence(_, items) => items.iter().any(inside),
            Layout::Fraction(a, b) => inside(a) || inside(b),
            Layout::Root(_, a) | Layout::Accent(_, a) | Layout::Style(_, a) => inside(a),
            Layout::Scripts { nucleus, sub, sup, .. } => {
                inside(nucleus) || sub.as_deref().is_some_and(inside) || sup.as_deref().is_some_and(inside)
            }
            Layout::Environment(_, rows) => rows.iter().flatten().flatten().any(inside),
            _ => false,
        }
    }
    inside(item)
}

impl Piece<'_> {
    fn span(&self) -> Span {
        let spans = self.links.iter().flat_map(|link| {
            link.relation.iter().map(|(_, span)| *span).chain(link.items.iter().map(|item| item.span))
        });
        spans.reduce(Span::to).unwrap_or_default()
    }

    /// The statement, and the symbols that it defines with the position of their members.
    fn read(&self, symbols: &mut Symbols, branch: Option<Sign>) -> Result<(Statement, Vec<(usize, New)>), Fault> {
        let span = self.span();
        let links: Vec<(Printed, Vec<Item>)> = self
            .links
            .iter()
            .map(|link| (link.relation, link.items.iter().map(|item| (*item).clone()).collect()))
            .collect();
        let relations: Vec<(Relation, Span)> = links.iter().filter_map(|(relation, _)| *relation).collect();
        let defines = |at: usize| {
            let before = at.checked_sub(1).and_then(|before| relations.get(before));
            matches!(before, Some((Relation::Equal | Relation::Identical, _)))
        };
        let mut unknown: Vec<Option<Unknown>> = Vec::with_capacity(links.len());
        let mut read: Vec<Option<(Expr, Type)>> = Vec::with_capacity(links.len());
        for (at, (relation, items)) in links.iter().enumerate() {
            let place = match (at, relation) {
                (0, _) if defines(1) => Some(Place::First),
                (1.., Some((Relation::Equal, _))) => Some(Place::AfterEqual),
                (1.., Some((Relation::Identical, _))) => Some(Place::AfterIdentical),
                _ => None,
            };
            let found = place.and_then(|place| Unknown::of(items, place, symbols, branch));
            read.push(match found {
                Some(_) => None,
                None => {
                    let place = relation.map_or(span, |(_, span)| span);
                    let expr = Reader::new(symbols, branch).sum(items, place)?;
                    Some(shape::bind(expr, symbols)?)
                }
            });
            unknown.push(found);
        }
        let mut news: Vec<(usize, New)> = Vec::new();
        for at in 0..links.len() {
            let Some(found) = &unknown[at] else { continue };
            // The first member is defined by what follows, the others by what stands before them.
            let source = match at {
                0 => (1..links.len()).take_while(|next| defines(*next)).find_map(|next| read[next].clone()),
                _ => read[at - 1].clone(),
            };
            let Some((source, of_source)) = source else { return Err(found.undeclared(symbols)) };
            let (expr, found, new) = found.introduce((&source, &of_source), symbols.len() + news.len(), symbols)?;
            news.extend(new.into_iter().map(|new| (at, new)));
            read[at] = Some((expr, found));
        }
        let (members, types): (Vec<Expr>, Vec<Type>) = read.into_iter().flatten().unzip();
        for pair in 1..members.len() {
            let (a, b) = (&members[pair - 1], &members[pair]);
            let (of_a, of_b) = ((a, &types[pair - 1]), (b, &types[pair]));
            let matrices = [shape::entries_of(of_a, of_b, symbols), shape::entries_of(of_b, of_a, symbols)];
            if matrices.iter().all(Option::is_none) {
                shape::comparable(of_a, of_b, symbols)?;
            }
            let (relation, place) = relations[pair - 1];
            let is_order = matches!(
                relation,
                Relation::Less | Relation::LessEqual | Relation::Greater | Relation::GreaterEqual | Relation::NotEqual
            );
            let differ = relation == Relation::NotEqual
                && [a, b]
                    .into_iter()
                    .zip([&types[pair - 1], &types[pair]])
                    .all(|(member, of)| of.shape == Shape::Vector || member.is_zero());
            if is_order && !differ && (types[pair - 1].shape != Shape::Scalar || types[pair].shape != Shape::Scalar) {
                let message = format!("“{}” needs a number on both sides", relation.glyph());
                return Err(Fault::shape(place, message));
            }
        }
        for (place, letters) in members.iter().flat_map(Expr::pair_sums) {
            let is_free = |letter: &IndexId| {
                symbols.for_each == Some(*letter) || types.iter().any(|found| found.free.contains(letter))
            };
            if let Some(letter) = letters.iter().find(|letter| is_free(letter)) {
                let letter = &symbols.indices[letter.0].letter;
                let message = format!("this is a sum over pairs, but {letter} is free in this equation");
                return Err(Fault::index(place, message).help("write a Σ for each letter that is summed over"));
            }
        }
        let statement = Statement { members, relations, constant: self.constant, branch, row: self.row, span };
        Ok((statement, news))
    }
}
