//! The statements of a display: rows, commas, `\Rightarrow`, chains of relations, branches of ±, "is constant".
//!
//! Rows, `\quad`, commas and arrows separate statements. A row that starts with a relation continues the row before. A
//! statement with `±` is read twice: once with all upper signs, once with all lower signs. An unknown name that is a
//! whole member is defined by the statement ([`super::definitions`]).

use crate::formula::shape::{self, Shape, Type};
use crate::formula::symbols::{Kind, Name, SymbolId, Symbols};
use crate::formula::tree::{Condition, Expr, IndexId, Relation, Sign, Statement};
use crate::formula::units::in_si::has_units;
use crate::source::{Fault, Span};

use super::definitions::{DefinedSymbol, New, Place, Unknown};
use super::inference::infer;
use super::layout::rest::has_rest;
use super::layout::{Delimiter, Item, Layout, contents, parts, typeset_items};
use super::macros::Macros;
use super::names;
use super::pieces::{Piece, Printed, pieces, without_ranges};
use super::reader::Reader;
use super::reader::algebra::evidence;
use super::reader::structure::{fault_in, note_levels, note_possible_indices};
use super::reader::undeclared::{note_marks, unclear, unclear_name, uses, vectors};

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

/// Reads a display: the text between its delimiters. A display that cannot be read is read again for its structure only, if
/// the table allows it.
pub fn read_display(text: &str, symbols: &mut Symbols, macros: &Macros) -> Reading {
    let first = symbols.may_be_abstract.then(|| symbols.clone());
    let reading = read_once(text, symbols, macros);
    let Some(mut again) = first.filter(|_| reading.statements.iter().any(Result::is_err)) else { return reading };
    again.inferred.abstractly = true;
    let found = read_once(text, &mut again, macros);
    *symbols = again;
    found
}

fn read_once(text: &str, symbols: &mut Symbols, macros: &Macros) -> Reading {
    let mut reading = Reading::default();
    let items = match typeset_items(text, macros) {
        Ok(items) => items,
        Err(fault) => {
            reading.statements.push(Err(fault));
            return reading;
        }
    };
    evidence::note(&items, symbols);
    note_marks(&items, &mut symbols.inferred);
    if symbols.open || symbols.guessed {
        note_levels(&items, &mut symbols.inferred);
    }
    if symbols.guessed {
        note_possible_indices(&items, &mut symbols.inferred);
    }
    if symbols.open {
        symbols.inferred.active = true;
        infer(&items, symbols);
        let fault = unclear_name(&items).or_else(|| uses::of(&items).unclear());
        let fault = fault.or_else(|| vectors::unclear_product(&items)).or_else(|| unclear(&items));
        if let Some(fault) = fault {
            reading.statements.push(Err(fault));
            return reading;
        }
    }
    if symbols.guessed
        && let Some((span, name)) = evidence::taken_for_a_number(&items, symbols)
    {
        let what =
            format!("{name} may be a matrix, because the same letter follows {name} and stands on the other side");
        let help = format!("declare it in the claims file, \"{name}\": \"3x3 matrix\", or as a number");
        reading.statements.push(Err(Fault::ambiguous(span, what).help(help)));
        return reading;
    }
    let mut pieces = pieces(&items, symbols.is_abstract());
    without_ranges(&mut pieces);
    if pieces.is_empty() {
        let fault =
            Fault::new(Span::new(0, text.len()), "this display is empty").help("write a formula in it, or remove it");
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
        pending.retain(|(at, (piece, branch))| {
            // What cannot be read leaves no names behind, which would be known when it is read again.
            let before = symbols.open.then(|| symbols.clone());
            match piece.read(symbols, *branch) {
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
                    if let Some(before) = before {
                        *symbols = before;
                    }
                    results[*at] = Some(Err(fault));
                    true
                }
            }
        });
        if pending.is_empty() || symbols.len() == known {
            break;
        }
    }
    reading.statements.extend(results.into_iter().flatten());
    reading
}

/// Whether a side is one name for several values, `s_{1,2}`, of which each sign gives one.
fn names_several(items: &[Item]) -> bool {
    let comma = |name: &Name| name.subscript.iter().any(|token| token == ",");
    matches!(items, [only] if names::printed(only, None).is_some_and(|found| comma(&found.name)))
}

fn has_branch(item: &&Item) -> bool {
    fn inside(item: &Item) -> bool {
        match &item.layout {
            Layout::Command(name) => name == "\\pm" || name == "\\mp",
            // `\{0, \pm 1\}` is one set.
            Layout::Fence(Delimiter::Curly, items) if items.iter().any(|item| item.layout == Layout::Other(',')) => {
                false
            }
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

/// The place of the sign of `[A, B]_\pm`.
fn sign_below_brackets(item: &Item) -> Option<Span> {
    let is_sign = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\pm" || name == "\\mp");
    match &item.layout {
        Layout::Scripts { nucleus, sub: Some(sub), .. }
            if matches!(nucleus.layout, Layout::Fence(..)) && contents(sub).iter().all(is_sign) =>
        {
            Some(sub.span)
        }
        _ => parts(item).into_iter().flatten().find_map(sign_below_brackets),
    }
}

impl Piece<'_> {
    /// The statement, and the symbols that it defines with the position of their members.
    fn read(&self, symbols: &mut Symbols, branch: Option<Sign>) -> Result<(Statement, Vec<(usize, New)>), Fault> {
        if branch.is_some()
            && let Some(sign) =
                self.links.iter().flat_map(|link| &link.items).find_map(|item| sign_below_brackets(item))
        {
            return Err(Fault::unsupported(sign, "± or ∓ below brackets is not supported")
                .help("write the commutator, [A, B], or the anticommutator, \\{A, B\\}"));
        }
        let span = self.span();
        if let Some(fault) = &self.fault {
            return Err(fault.clone());
        }
        if self.has_alternatives {
            return Ok((self.alternatives(symbols, branch)?, Vec::new()));
        }
        let links: Vec<(Printed, Vec<Item>)> = self
            .links
            .iter()
            .map(|link| (link.relation, link.items.iter().map(|item| (*item).clone()).collect()))
            .collect();
        let mut relations: Vec<(Relation, Span)> = links.iter().filter_map(|(relation, _)| *relation).collect();
        // A sum of which terms are left out equals nothing exactly, where a value is needed.
        for (at, relation) in relations.iter_mut().enumerate().filter(|_| !symbols.may_be_abstract) {
            if links[at..at + 2].iter().any(|(_, items)| has_rest(items)) && relation.0 == Relation::Equal {
                relation.0 = Relation::Approximately;
            }
        }
        // Whether a member stands behind a sign that may define one of its sides.
        let defines = |at: usize| {
            let before = at.checked_sub(1).and_then(|before| relations.get(before));
            matches!(before, Some((Relation::Equal | Relation::Identical, _)))
        };
        let conditions = self.read_conditions(symbols, branch)?;
        let mut unknown: Vec<Option<Unknown>> = Vec::with_capacity(links.len());
        let mut read: Vec<Option<(Expr, Type)>> = Vec::with_capacity(links.len());
        for (at, (relation, items)) in links.iter().enumerate() {
            let place = match (at, relation) {
                (0, _) if defines(1) => Some(Place::First),
                (1.., Some((Relation::Equal, _))) => Some(Place::AfterEqual),
                (1.., Some((Relation::Identical, _))) => Some(Place::AfterIdentical),
                _ => None,
            };
            // What holds under a condition defines nothing, and neither does one sign of two.
            let is_sure = conditions.is_empty()
                && (branch.is_none() || items.iter().any(|item| has_branch(&item)) || names_several(items));
            let found = place.filter(|_| is_sure).and_then(|place| Unknown::of(items, place, symbols, branch));
            read.push(match found {
                Some(_) => None,
                None => {
                    let place = relation.map_or(span, |(_, span)| span);
                    // `= x` and `x =` leave a side out; between two relations a formula is missing.
                    let is_end = at == 0 || at + 1 == links.len();
                    if items.is_empty() && !is_end {
                        return Err(Fault::new(place, "two relation signs stand side by side")
                            .help("remove one of them, or write what stands between them"));
                    }
                    let is_left_out = items.is_empty() && is_end && relation.is_none() == (at == 0);
                    Some(read_member(items, place, is_left_out, &mut Reader::new(symbols, branch))?)
                }
            });
            unknown.push(found);
        }
        let defining: Vec<bool> = (0..links.len()).map(defines).collect();
        let news = define_unknown_members(&unknown, &mut read, &defining, symbols)?;
        let (members, types): (Vec<Expr>, Vec<Type>) = read.into_iter().flatten().unzip();
        compare_members(&members, &types, &relations, symbols)?;
        reject_free_pair_sums(&members, &types, symbols)?;
        note_complex(&members, &types, symbols);
        // What cannot be read is not left out of what is shown as it is printed.
        let lost = || self.links.iter().flat_map(|link| &link.items).find_map(|item| fault_in(item));
        if let Some(fault) = symbols.is_abstract().then(lost).flatten() {
            return Err(fault);
        }
        let statement =
            Statement { members, relations, conditions, constant: self.constant, branch, row: self.row, span };
        Ok((statement, news))
    }

    /// Alternatives, of which one holds, as a statement with one member.
    fn alternatives(&self, symbols: &mut Symbols, branch: Option<Sign>) -> Result<Statement, Fault> {
        let span = self.span();
        let items: Vec<Item> = self.links.iter().flat_map(|link| &link.items).map(|item| (*item).clone()).collect();
        let expr = Reader::new(symbols, branch).alternatives(&items, span)?;
        let (relations, conditions) = (Vec::new(), Vec::new());
        let members = vec![shape::bind(expr, symbols)?.0];
        let constant = self.constant;
        Ok(Statement { members, relations, conditions, constant, branch, row: self.row, span })
    }

    /// The conditions under which the statement holds.
    fn read_conditions(&self, symbols: &mut Symbols, branch: Option<Sign>) -> Result<Vec<Condition>, Fault> {
        let span = self.span();
        let mut conditions = Vec::new();
        for condition in &self.conditions {
            let items: Vec<Item> = condition.iter().map(|item| (*item).clone()).collect();
            let read = Reader::new(symbols, branch).condition(&items, span).and_then(|stated| stated.all(span));
            match read {
                Ok(found) => conditions.extend(found),
                // What cannot be printed is not left out.
                Err(fault) if items.iter().any(|item| fault_in(item).is_some()) => return Err(fault),
                Err(_) if symbols.is_abstract() => {
                    conditions.push(Reader::new(symbols, branch).unread_condition(&items, span))
                }
                Err(fault) => return Err(fault),
            }
        }
        Ok(conditions)
    }
}

/// A member with its type; one that is left out where only the structure is read.
fn read_member(items: &[Item], place: Span, is_left_out: bool, reader: &mut Reader<'_>) -> Result<(Expr, Type), Fault> {
    let expr = match is_left_out && reader.symbols.is_abstract() {
        true => reader.not_printed(place),
        false => reader.sum(items, place)?,
    };
    shape::bind(expr, reader.symbols)
}

/// Gives the unknown names among the members their formula, and returns the symbols that must be added for that, each with the
/// position of its member. `defining` says which members stand behind a sign that may define.
fn define_unknown_members(
    unknown: &[Option<Unknown>],
    read: &mut [Option<(Expr, Type)>],
    defining: &[bool],
    symbols: &Symbols,
) -> Result<Vec<(usize, New)>, Fault> {
    let mut news: Vec<(usize, New)> = Vec::new();
    for at in 0..unknown.len() {
        let Some(found) = &unknown[at] else { continue };
        // The first member is defined by what follows, the others by what stands before them.
        let source = match at {
            0 => {
                let members: Vec<&(Expr, Type)> = (1..unknown.len())
                    .take_while(|next| defining[*next])
                    .filter_map(|next| read[next].as_ref())
                    .collect();
                // `L = T - V = \frac12 m\dot x^2 - …`: where nothing says what T and V are, the formula with the rates does.
                let moves =
                    members.iter().find(|(member, _)| has_rates(member, symbols) && !has_open_energy(member, symbols));
                moves.or(members.first()).map(|found| (*found).clone())
            }
            _ => read[at - 1].clone(),
        };
        let Some((source, of_source)) = source else { return Err(found.undeclared(symbols)) };
        if !symbols.quantities_define && is_quantity(&source) {
            return Err(found.undeclared(symbols));
        }
        let next = symbols.len() + news.len();
        let (mut expr, of_member, new) = found.introduce((&source, &of_source), next, symbols)?;
        // The name may stand twice, `E = T + U = E`: the second is the symbol that the first adds.
        let known: Vec<&New> = news.iter().map(|(_, new)| new).collect();
        if let [new] = new.as_slice()
            && let Some(first) = known.iter().position(|known| known.is_same_symbol(new))
        {
            let first = SymbolId(symbols.len() + first);
            expr.rename(&|id| if id.0 == next { first } else { id });
        } else if new.iter().any(|new| new.is_taken(&known, symbols)) {
            return Err(found.undeclared(symbols));
        } else {
            news.extend(new.into_iter().map(|new| (at, new)));
        }
        read[at] = Some((expr, of_member));
    }
    Ok(news)
}

/// Whether a rate stands in a formula, or in the formula of a name in it.
fn has_rates(formula: &Expr, symbols: &Symbols) -> bool {
    formula.symbols().iter().any(|(id, dots)| {
        *dots > 0 || symbols.entry(*id).definition.as_ref().is_some_and(|formula| has_rates(formula, symbols))
    })
}

/// Whether an energy stands in a formula of which nothing says how it varies.
fn has_open_energy(formula: &Expr, symbols: &Symbols) -> bool {
    formula.symbols().iter().any(|(id, _)| {
        let entry = symbols.entry(*id);
        let is_energy = ["T", "V", "U", "K"].contains(&entry.name.base.as_str()) && entry.name.subscript.is_empty();
        is_energy && entry.definition.is_none() && !entry.varies && entry.arguments.is_empty()
    })
}

/// Rejects neighbours whose shapes cannot be compared, and an order between what is no number.
fn compare_members(
    members: &[Expr],
    types: &[Type],
    relations: &[(Relation, Span)],
    symbols: &Symbols,
) -> Result<(), Fault> {
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
        if is_order
            && !differ
            && !symbols.is_abstract()
            && (types[pair - 1].shape != Shape::Scalar || types[pair].shape != Shape::Scalar)
        {
            let message = format!("“{}” needs a real number on both sides", relation.glyph());
            return Err(Fault::shape(place, message));
        }
    }
    Ok(())
}

/// Rejects a sum over pairs of a letter that is free in the statement.
fn reject_free_pair_sums(members: &[Expr], types: &[Type], symbols: &Symbols) -> Result<(), Fault> {
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
    Ok(())
}

/// Whether a formula is a number with a unit.
fn is_quantity(formula: &Expr) -> bool {
    has_units(formula) && formula.symbols().is_empty()
}

/// Without declarations: a name that equals a complex number is one.
fn note_complex(members: &[Expr], types: &[Type], symbols: &mut Symbols) {
    if !symbols.open || !types.iter().any(|found| found.shape == Shape::Complex) {
        return;
    }
    for id in members.iter().filter_map(Expr::as_plain_symbol) {
        let entry = symbols.entry_mut(id);
        if entry.kind == Kind::Scalar {
            entry.kind = Kind::Complex;
        }
    }
}
