//! Displays whose dimensions contradict those of all other displays.
//!
//! Nobody declares units in notes, but each equation says that its terms have one dimension. A display that makes a name a
//! pure number, which it is not by all other displays together, is in conflict with them. It is called wrong only if one
//! other exponent, a fraction turned over, or a dot more or less, makes its dimensions follow from the other displays, and if
//! the conflict stays whichever other display is left out: of two statements that contradict each other nobody knows which one
//! is right.
//!
//! Notes in natural units, where c = 1, are not called wrong: no exponent of a name that is printed makes up for one that is
//! not.

use std::collections::BTreeSet;

use crate::check::document::checker::Checker;
use crate::check::unaided::{gate, inline};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::units::{Affine, UnitCheck};
use crate::formula::{Expr, Node, Statement, SymbolId, Symbols, text};
use crate::latex::layout::values::parts_of;
use crate::latex::layout::{Item, Layout, typeset_items};
use crate::latex::slips::{Edit, Slip, slips};
use crate::latex::{Macros, Reading, read_display};
use crate::source::Span;

/// The most displays that are compared with each other.
const MOST: usize = 60;

/// The fewest displays beside the one in question.
const FEWEST: usize = 3;

/// The highest power that is tried.
const HIGHEST: u32 = 6;

/// The powers that authors lose.
const LOST: [u32; 3] = [2, 3, 4];

/// The fewest names in a display that is called wrong.
const FEWEST_NAMES: usize = 4;

/// A display in conflict with the others.
struct Conflict {
    at: usize,
    /// The names that it makes pure numbers.
    names: BTreeSet<SymbolId>,
    edit: Edit,
}

/// Calls displays wrong whose dimensions contradict those of the others; `first` is the place of the first finding.
pub(super) fn blame(checker: &Checker<'_>, first: usize, found: &mut [Equation]) {
    let all: Vec<(usize, Vec<&Statement>)> = (0..checker.readings.len())
        .filter_map(|at| Some((at, statements(checker, at)?)))
        .filter(|(at, _)| {
            let equation = at.checked_sub(first).and_then(|place| found.get(place));
            equation.is_none_or(|equation| equation.finding.verdict != Verdict::Refuted)
        })
        .collect();
    if all.len() > MOST || all.len() <= FEWEST {
        return;
    }
    let conflicts: Vec<Conflict> = all
        .iter()
        .filter(|(at, _)| {
            let verdict = at.checked_sub(first).and_then(|place| found.get(place)).map(|found| found.finding.verdict);
            matches!(verdict, Some(Verdict::Assumed | Verdict::Definition | Verdict::Undecided))
        })
        .filter_map(|(at, _)| conflict(checker, *at, &all))
        .collect();
    for one in &conflicts {
        let is_shared = |other: &Conflict| other.at != one.at && !other.names.is_disjoint(&one.names);
        if !conflicts.iter().any(is_shared) {
            found[one.at - first] = refuted(checker, one, &found[one.at - first]);
        }
    }
}

/// The statements of a display that say something about dimensions. A plain number with digits after the point may have a
/// unit that is not printed, and so may a number that is a whole side. Authors write `pV^\gamma = \text{const}` and mean V in some
/// unit, so a power with another exponent than a number says nothing. Neither does a matrix, whose rows may belong to a length and
/// an angle.
fn statements<'c>(checker: &'c Checker<'_>, at: usize) -> Option<Vec<&'c Statement>> {
    // A case that a sentence states says nothing of other displays.
    let display = &checker.notes.equations[at];
    if inline::is_inline(checker.notes, display) && inline::is_conditional(checker.notes, display) {
        return None;
    }
    if names_a_constraint(checker, at) {
        return None;
    }
    let read: Option<Vec<&Statement>> = checker.readings[at].statements.iter().map(|read| read.as_ref().ok()).collect();
    let is_value = |member: &Expr| matches!(&member.node, Node::Number(_)) && !member.is_zero();
    let has_decimals = |member: &Expr| {
        let mut found = false;
        member.walk(&mut |part| found |= matches!(&part.node, Node::Number(digits) if digits.contains('.')));
        found
    };
    let has_open_power = |member: &Expr| {
        let mut found = false;
        member.walk(&mut |part| {
            if let Node::Power(base, exponent) = &part.node {
                found |= !base.symbols().is_empty() && !exponent.symbols().is_empty();
            }
        });
        found
    };
    let has_matrix = |member: &Expr| {
        let mut found = false;
        member.walk(&mut |part| found |= gate::is_matrix(part));
        found
    };
    let says_nothing =
        |member: &Expr| is_value(member) || has_decimals(member) || has_open_power(member) || has_matrix(member);
    read.filter(|read| {
        let mut members = read.iter().flat_map(|statement| &statement.members);
        !read.is_empty() && !members.any(says_nothing)
    })
}

/// Whether a display gives a constraint a name, `g(\rho, z) = \rho^2 - a z = 0`, which stands for something else in other displays.
fn names_a_constraint(checker: &Checker<'_>, at: usize) -> bool {
    let displays = &checker.notes.equations;
    checker.readings[at].statements.iter().flatten().any(|statement| {
        let [first, .., last] = statement.members.as_slice() else { return false };
        let Some(id) = first.as_plain_symbol().filter(|_| last.is_null()) else { return false };
        let entry = checker.model.symbols.entry(id);
        let others = || checker.readings.iter().enumerate().filter(|(other, _)| *other != at);
        let is_applied = |place: usize| displays[place].text.contains(&format!("{}(", entry.name));
        let uses = |reading: &Reading| {
            let mut members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
            members.any(|member| member.symbols().iter().any(|(other, _)| *other == id))
        };
        is_applied(at) && others().any(|(place, reading)| uses(reading) && !is_applied(place))
    })
}

/// A check in which a value of a quantity, such as `x(t_1)`, has the dimension of the quantity, and so has the mean value
/// `\langle x^4 \rangle` that of the formula in it.
fn check_with_values<'s>(symbols: &'s Symbols, macros: &Macros) -> UnitCheck<'s> {
    let mut check = UnitCheck::new(symbols);
    for (id, entry) in symbols.iter() {
        let base = entry.name.base.trim();
        // What depends on a vector is a field, and its letter may be that of something else.
        let is_place = |place: &str| place.ends_with(')') && !place.contains('\\');
        let value = base.split_once('(').filter(|(_, place)| is_place(place)).map(|(quantity, _)| quantity);
        let mean = base.strip_prefix("\\langle").and_then(|rest| rest.strip_suffix("\\rangle"));
        let mean = mean.filter(|inner| inner.starts_with(|c: char| !c.is_ascii_alphabetic()));
        let Some(text) = value.or(mean).filter(|_| entry.name.subscript.is_empty()) else { continue };
        // What is inside must be read with the names that are known.
        let mut known = symbols.clone();
        let reading = read_display(text.trim(), &mut known, macros);
        if let ([Ok(Statement { members, .. })], true) = (reading.statements.as_slice(), known.len() == symbols.len())
            && let [only] = members.as_slice()
            && only.symbols().iter().all(|(other, _)| *other != id)
            && let Ok(Some(found)) = check.dimension(only)
        {
            drop(check.inference.require_equal(&Affine::of(id), &found));
        }
    }
    check
}

/// The edits that put a power after what has none.
fn lost_powers(items: &[Item], text: &str, found: &mut Vec<Edit>) {
    for item in items {
        let has_none = match &item.layout {
            Layout::Letter(_) | Layout::Command(_) | Layout::Fence(..) | Layout::Value(_) => true,
            Layout::Scripts { sup, .. } => sup.is_none(),
            _ => false,
        };
        let span = Span::at(item.span.end);
        if has_none && text.is_char_boundary(span.start) && !text[span.start..].trim_start().starts_with(['^', '_']) {
            let edit = |power: u32| Edit { span, replacement: format!("^{power}"), slip: Slip::Exponent };
            found.extend(LOST.map(edit));
        }
        if !matches!(item.layout, Layout::Scripts { .. }) {
            parts_of(item).into_iter().for_each(|part| lost_powers(part, text, found));
        }
    }
}

/// The edits that put another whole power in the place of one.
fn other_powers(text: &str) -> Vec<Edit> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices('^') {
        let after = &text[at + 1..];
        let braces = usize::from(after.starts_with('{'));
        let digits = after[braces..].bytes().take_while(u8::is_ascii_digit).count();
        let is_whole = digits == 1 && (braces == 0 || after[braces + digits..].starts_with('}'));
        let span = Span::new(at + 1 + braces, at + 1 + braces + digits);
        let others =
            (1..=HIGHEST).map(|power| power.to_string()).filter(|power| is_whole && *power != text[span.range()]);
        found.extend(others.map(|replacement| Edit { span, replacement, slip: Slip::Exponent }));
    }
    found
}

/// Whether a correction of a display contradicts the dimensions of the other displays, and the display as it is printed does not.
pub(super) fn are_spoilt(checker: &Checker<'_>, at: usize, repair: &Repair) -> bool {
    let (symbols, display) = (&checker.model.symbols, &checker.notes.equations[at]);
    if checker.readings.len() > MOST || !display.body.contains(repair.span) {
        return false;
    }
    let mut others = check_with_values(symbols, &checker.model.macros);
    let mut known = BTreeSet::new();
    for statements in (0..checker.readings.len()).filter(|other| *other != at).filter_map(|at| statements(checker, at))
    {
        statements.iter().for_each(|statement| drop(others.statement(statement)));
        known.extend(symbols_of(&statements));
    }
    let faults = |text: &str| {
        let mut table = symbols.clone();
        let reading = read_display(text, &mut table, &checker.model.macros);
        let mut check = UnitCheck::new(&table);
        check.inference = others.inference.clone();
        let misfits =
            reading.statements.iter().flatten().map(|statement| check.statement(statement).len()).sum::<usize>();
        misfits + known.iter().filter(|id| check.inference.is_pure_number(**id)).count()
    };
    let span = Span::new(repair.span.start - display.body.start, repair.span.end - display.body.start);
    let mut corrected = display.text.clone();
    corrected.replace_range(span.range(), &repair.replacement);
    faults(&corrected) > faults(&display.text)
}

/// Whether a letter stands for what has a dimension in nearly all notes: m, t, v, C, λ. Of others, such as α, ε, n and x, nobody knows.
fn has_a_dimension(base: &str) -> bool {
    const GREEK: [&str; 10] =
        ["\\tau", "\\omega", "\\Omega", "\\lambda", "\\rho", "\\varrho", "\\mu", "\\hbar", "\\ell", "\\Phi"];
    const MAY_BE_NUMBERS: [&str; 10] = ["n", "N", "i", "j", "e", "x", "y", "z", "X", "Z"];
    match base.starts_with('\\') {
        true => GREEK.contains(&base),
        false => !MAY_BE_NUMBERS.contains(&base),
    }
}

/// The symbols that have a dot in some statements.
fn rates_of<'s>(statements: impl Iterator<Item = &'s Statement>) -> BTreeSet<SymbolId> {
    let members = statements.flat_map(|statement| &statement.members);
    members.flat_map(Expr::symbols).filter(|(_, dots)| *dots > 0).map(|(id, _)| id).collect()
}

fn symbols_of(statements: &[&Statement]) -> BTreeSet<SymbolId> {
    let members = statements.iter().flat_map(|statement| &statement.members);
    members.flat_map(Expr::symbols).map(|(id, _)| id).collect()
}

fn conflict(checker: &Checker<'_>, at: usize, all: &[(usize, Vec<&Statement>)]) -> Option<Conflict> {
    let (symbols, display) = (&checker.model.symbols, &checker.notes.equations[at]);
    let own = &all.iter().find(|(other, _)| *other == at)?.1;
    // A curve such as y = x² is printed for plain numbers too.
    if symbols_of(own).len() < FEWEST_NAMES {
        return None;
    }
    let mut others = check_with_values(symbols, &checker.model.macros);
    let mut known = BTreeSet::new();
    let mut uses: Vec<SymbolId> = Vec::new();
    for (_, statements) in all.iter().filter(|(other, _)| *other != at) {
        statements.iter().for_each(|statement| drop(others.statement(statement)));
        let found = symbols_of(statements);
        uses.extend(&found);
        known.extend(found);
    }
    let pure = |check: &UnitCheck<'_>| -> BTreeSet<SymbolId> {
        known.iter().copied().filter(|id| check.inference.is_pure_number(*id)).collect()
    };
    let before = pure(&others);
    let mut with = others.clone();
    let misfits = own.iter().any(|statement| !with.statement(statement).is_empty());
    let used_often = |id: &SymbolId| uses.iter().filter(|used| *used == id).count() > 1;
    let names: BTreeSet<SymbolId> = pure(&with).difference(&before).copied().filter(used_often).collect();
    // A sum such as `1 + \alpha` says that α is a plain number, which is no conflict where it may be one.
    if !misfits && !names.iter().any(|id| has_a_dimension(&symbols.entry(*id).name.base)) {
        return None;
    }
    // Two displays that contradict each other: either may be the wrong one.
    let rest: Vec<&Statement> =
        all.iter().filter(|(place, _)| *place != at).flat_map(|(_, statements)| statements).copied().collect();
    let goes_on_without = |other: usize| {
        let mut check = check_with_values(symbols, &checker.model.macros);
        let rest = rest.iter().enumerate().filter(|(place, _)| *place != other);
        rest.for_each(|(_, statement)| drop(check.statement(statement)));
        let earlier = pure(&check);
        let misfits = own.iter().any(|statement| !check.statement(statement).is_empty());
        misfits || pure(&check).difference(&earlier).any(|id| names.contains(id))
    };
    if !(0..rest.len()).all(goes_on_without) {
        return None;
    }
    // A dot is lost on what has one elsewhere: the time has no rate, and a constant has none.
    let rates = rates_of(all.iter().filter(|(other, _)| *other != at).flat_map(|(_, statements)| statements).copied());
    let fits = |edit: &Edit| {
        let mut table = symbols.clone();
        let reading = read_display(&edit.applied(&display.text), &mut table, &checker.model.macros);
        let read: Option<Vec<&Statement>> = reading.statements.iter().map(|read| read.as_ref().ok()).collect();
        let Some(read) = read.filter(|read| !read.is_empty()) else { return false };
        if edit.slip == Slip::Dot && !rates_of(read.iter().copied()).is_subset(&rates) {
            return false;
        }
        let mut check = UnitCheck::new(&table);
        check.inference = others.inference.clone();
        let before = check.inference.requirements();
        let new = symbols_of(&read).difference(&known).count();
        read.iter().all(|statement| check.statement(statement).is_empty())
            && check.inference.requirements() <= before + new
    };
    let edits = slips(&display.text, symbols, &checker.model.macros);
    let likely = edits.into_iter().filter(|edit| matches!(edit.slip, Slip::Exponent | Slip::Dot | Slip::Fraction));
    let mut lost = Vec::new();
    let items = typeset_items(&display.text, &checker.model.macros).unwrap_or_default();
    lost_powers(&items, &display.text, &mut lost);
    let edit = likely.chain(other_powers(&display.text)).chain(lost).find(fits)?;
    Some(Conflict { at, names, edit })
}

/// The finding that a display is wrong.
fn refuted(checker: &Checker<'_>, conflict: &Conflict, before: &Equation) -> Equation {
    let start = checker.notes.equations[conflict.at].body.start;
    let shown: Vec<String> = conflict.names.iter().map(|id| text::plain(&checker.model.name(*id))).collect();
    let consequence = match shown.as_slice() {
        [] => "the terms of this display have different dimensions, as the other displays show".to_owned(),
        [name] => format!("this display would make {name} dimensionless, but the other displays give it a dimension"),
        [names @ .., last] => format!(
            "this display would make {} and {last} dimensionless, but the other displays give them a dimension",
            names.join(", ")
        ),
    };
    let message = format!("the dimensions do not fit: {consequence}");
    let finding = Finding::new(Code::DimensionsConflict, Verdict::Refuted, before.finding.span, message);
    let repair = Repair::of(conflict.edit.clone(), start, Verdict::Assumed);
    Equation { finding, parts: Vec::new(), repairs: vec![repair], elsewhere: Vec::new(), ok: false, ..before.clone() }
}
