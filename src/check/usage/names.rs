//! The names in displays, and how each stands there.

use crate::formula::symbols::Name;
use crate::latex::layout::{Delimiter, Item, Layout, typeset_items};
use crate::latex::{Macros, names};
use crate::notes::Display;

use super::chains::{Side, follow, name_at_the_end};
use super::differentials::{
    contents, difference, differential_of, is_by_time, is_differential, is_factor, is_letter_d, is_mark,
};
use super::entry::{Usage, entry};

/// Environments whose rows are statements.
const ROWS: [&str; 8] = ["equation", "align", "aligned", "alignedat", "gather", "gathered", "split", "eqnarray"];

/// Where an item stands.
#[derive(Clone, Copy, Default)]
struct Place {
    positive: bool,
    angle: bool,
    moves: bool,
    conserved: bool,
    raises: bool,
    /// Whether δ before a name is a factor in the display.
    has_coefficient: bool,
}

/// All names of some displays, in the order of their first occurrence.
pub(crate) fn names_of(displays: &[Display], macros: &Macros) -> Vec<Usage> {
    let (mut found, mut statements) = (Vec::new(), Vec::new());
    let mut valued: Vec<(Name, usize)> = Vec::new();
    for (at, display) in displays.iter().enumerate() {
        let Ok(items) = typeset_items(&display.text, macros).map(unwrapped) else { continue };
        let (items, values) = without_values(items);
        valued.extend(values.into_iter().map(|name| (name, at)));
        let mut left = true;
        for (row, item) in items.iter().enumerate() {
            // The left side of a statement: a name alone, perhaps with arguments or a square, before the relation.
            if left {
                note_left(&items[row..], at, &mut found);
            }
            left = matches!(&item.layout, Layout::Row | Layout::Align | Layout::Other(',' | ';'))
                // Words stand between statements: "with", "where".
                || matches!(&item.layout, Layout::Text(_))
                || matches!(&item.layout, Layout::Space(_)) && (left || row > 0 && starts(&items[row - 1]))
                || matches!(&item.layout, Layout::Command(name) if name == "\\quad" || name == "\\qquad");
        }
        let has_coefficient = crate::latex::has_coefficient(&display.text, macros);
        walk(&items, Place { has_coefficient, ..Place::default() }, at, &mut found);
        let mut before = Vec::new();
        for statement in items.split(ends_statement) {
            if let [left, right] = statement.split(is_relation).collect::<Vec<_>>().as_slice()
                && let Some(name) = lone_name(left)
            {
                if let Some(product) = product(right) {
                    entry(&mut found, &name, at).product.get_or_insert(product);
                }
                let mut solid = right.iter().filter(|item| !is_space(item));
                let is_negative = solid.next().is_some_and(|first| first.layout == Layout::Other('-'));
                if is_negative && lone_name(&solid.cloned().collect::<Vec<Item>>()).is_some() {
                    entry(&mut found, &name, at).opposite = true;
                }
            }
            let is_constant = statement.iter().any(|item| crate::latex::says_constant(item).is_some());
            if is_constant {
                walk(statement, Place { conserved: true, has_coefficient, ..Place::default() }, at, &mut found);
            }
            let sides = sides(statement);
            if let Some(name) = name_at_the_end(&sides, is_constant).filter(|name| !before.contains(name)) {
                note_introduced(entry(&mut found, &name, at), at);
            }
            before.extend(sides.iter().flat_map(|(_, inside)| inside.clone()));
            statements.push(sides);
        }
    }
    found.iter_mut().for_each(|usage| usage.angle &= !usage.scales);
    follow(&statements, &mut found);
    for (name, at) in valued {
        entry(&mut found, &name, at);
    }
    found
}

/// The items without the statements that give a name a value with a unit, `m = 2.0\,\text{kg}`, and these names. A value in an
/// example is no formula for the name.
fn without_values(items: Vec<Item>) -> (Vec<Item>, Vec<Name>) {
    let is_value = |statement: &[Item]| {
        let mut sides = statement.split(is_equality);
        let name = sides.next().and_then(lone_name)?;
        let has_names = |side: &[Item]| {
            let mut inside = Vec::new();
            walk(side, Place::default(), 0, &mut inside);
            inside.iter().any(|usage| !["\\pi", "e"].contains(&usage.name.base.as_str()))
        };
        let mut rest = sides.peekable();
        rest.peek()?;
        (rest.all(|side| !has_names(side)) && statement.iter().any(has_unit)).then_some(name)
    };
    let (mut kept, mut names) = (Vec::with_capacity(items.len()), Vec::new());
    for statement in items.split_inclusive(ends_statement) {
        let (body, end) = match statement.split_last() {
            Some((last, body)) if ends_statement(last) => (body, Some(last)),
            _ => (statement, None),
        };
        match is_value(body) {
            Some(name) => names.push(name),
            None => kept.extend_from_slice(body),
        }
        kept.extend(end.cloned());
    }
    (kept, names)
}

fn is_equality(item: &Item) -> bool {
    is_relation(item) || matches!(&item.layout, Layout::Command(name) if name == "\\approx")
}

fn has_unit(item: &Item) -> bool {
    match &item.layout {
        Layout::Unit(_) => true,
        Layout::Group(items) | Layout::Fence(_, items) => items.iter().any(has_unit),
        Layout::Fraction(a, b) => has_unit(a) || has_unit(b),
        Layout::Root(_, a) => has_unit(a),
        Layout::Scripts { nucleus, .. } => has_unit(nucleus),
        _ => false,
    }
}

/// The items of a display, where an environment that is all of it or one of its rows, as in `$$\\begin{equation}…$$`, gives its
/// own rows.
fn unwrapped(items: Vec<Item>) -> Vec<Item> {
    let is_rows = |item: &Item| match &item.layout {
        Layout::Environment(name, _) => ROWS.contains(&name.trim_end_matches('*')),
        _ => false,
    };
    let mut found = Vec::with_capacity(items.len());
    for item in items {
        if !is_rows(&item) {
            found.push(item);
            continue;
        }
        let Item { layout: Layout::Environment(_, rows), span } = item else { continue };
        for (row, cells) in rows.into_iter().enumerate() {
            if row > 0 {
                found.push(Item { layout: Layout::Row, span });
            }
            for (column, cell) in cells.into_iter().enumerate() {
                if column > 0 {
                    found.push(Item { layout: Layout::Align, span });
                }
                found.extend(unwrapped(cell));
            }
        }
    }
    found
}

/// The sides of a statement.
fn sides(statement: &[Item]) -> Vec<Side> {
    let side = |items: &[Item]| {
        let mut inside = Vec::new();
        walk(&without_instants(items), Place::default(), 0, &mut inside);
        (lone_name(items), inside.into_iter().map(|usage| usage.name).collect())
    };
    statement.split(is_relation).map(side).collect()
}

/// The items without the values at an instant, `\dot x(0)`: these do not vary.
fn without_instants(items: &[Item]) -> Vec<Item> {
    let is_number = |inside: &[Item]| matches!(inside, [Item { layout: Layout::Number(_), .. }]);
    let is_instant = |item: &Item| matches!(&item.layout, Layout::Fence(Delimiter::Round, inside) if is_number(inside));
    let mut kept: Vec<Item> = Vec::with_capacity(items.len());
    for item in items {
        match kept.last() {
            Some(name) if is_instant(item) && names::printed(name, None).is_some() => drop(kept.pop()),
            _ => kept.push(item.clone()),
        }
    }
    kept
}

/// The name that is all of some items.
fn lone_name(items: &[Item]) -> Option<Name> {
    match product(items)?.as_slice() {
        [only] => Some(only.clone()),
        _ => None,
    }
}

/// The names of which some items are the product, if they are nothing else.
fn product(items: &[Item]) -> Option<Vec<Name>> {
    let significant = items.iter().filter(|item| !is_space(item) && !matches!(item.layout, Layout::Other('.' | ',')));
    significant
        .map(|item| match names::printed(item, None) {
            Some(printed) if printed.dots == 0 && printed.sup.is_none() => Some(printed.name),
            _ => None,
        })
        .collect()
}

/// Letters of angles: `\sin\theta(a + b)` is a product.
const ANGLES: [&str; 9] =
    ["\\theta", "\\vartheta", "\\phi", "\\varphi", "\\psi", "\\alpha", "\\beta", "\\gamma", "\\chi"];

fn is_parenthesis(item: &Item) -> bool {
    matches!(item.layout, Layout::Fence(Delimiter::Round, _))
}

/// Whether an item is the time or a place: before one, a name in a sine is a factor, as in sin ωt, and no angle.
fn is_variable(item: &Item) -> bool {
    names::printed(item, None)
        .is_some_and(|printed| ["t", "x", "y", "z"].iter().any(|name| printed.name == Name::plain(*name)))
}

/// Whether a statement ends here.
fn ends_statement(item: &Item) -> bool {
    match &item.layout {
        Layout::Row | Layout::Other(',' | ';') => true,
        Layout::Command(name) => name == "\\quad" || name == "\\qquad",
        _ => false,
    }
}

fn starts(item: &Item) -> bool {
    matches!(&item.layout, Layout::Row | Layout::Align | Layout::Other(',' | ';'))
}

fn is_space(item: &Item) -> bool {
    matches!(item.layout, Layout::Space(_) | Layout::Align)
}

fn is_relation(item: &Item) -> bool {
    match &item.layout {
        Layout::Other('=' | '≡') => true,
        Layout::Command(name) => matches!(name.as_str(), "\\equiv" | "\\coloneqq"),
        _ => false,
    }
}

/// Notes that a display gives a name a formula, if none uses it before.
fn note_introduced(usage: &mut Usage, at: usize) {
    usage.introduced = usage.introduced.or(Some(at)).filter(|_| usage.first == at || usage.introduced.is_some());
}

/// Notes a name that is the whole left side here.
fn note_left(items: &[Item], at: usize, found: &mut Vec<Usage>) {
    // `L := T - V`
    let is_colon = |pair: &[&Item]| pair[0].layout == Layout::Other(':') && pair[1].layout == Layout::Other('=');
    let mut solid: Vec<&Item> = items.iter().filter(|item| !is_space(item)).take(4).collect();
    if let Some(colon) = solid.windows(2).position(is_colon) {
        solid.remove(colon);
    }
    let [first, rest @ ..] = solid.as_slice() else { return };
    let (name, is_power, after) = match difference(first, rest.first().copied()) {
        Some(name) => (name, false, rest.get(1)),
        None => {
            let Some(printed) = names::printed(first, None).filter(|printed| printed.dots == 0) else { return };
            let has_arguments = matches!(rest, [Item { layout: Layout::Fence(Delimiter::Round, _), .. }, ..]);
            (printed.name, printed.sup.is_some(), rest.get(usize::from(has_arguments)))
        }
    };
    if after.is_some_and(|after| is_relation(after)) {
        let usage = entry(found, &name, at);
        note_introduced(usage, at);
        usage.only_a_power = is_power && (usage.only_a_power || !usage.given);
        usage.given = true;
    }
}

fn walk(items: &[Item], place: Place, at: usize, found: &mut Vec<Usage>) {
    let (mut after_function, mut after_logarithm) = (false, false);
    for (index, item) in items.iter().enumerate() {
        // Of the parts of ln(a/b) none is negative, as a rule; a sum may have negative terms.
        let in_logarithm = after_logarithm && !has_terms(item);
        let here = Place { angle: after_function, positive: place.positive || in_logarithm, ..place };
        if !is_space(item) {
            (after_function, after_logarithm) = (false, false);
        }
        if matches!(&item.layout, Layout::Command(name) if name == "\\ln" || name == "\\log") {
            after_logarithm = true;
            continue;
        }
        if is_trigonometric(item) {
            after_function = true;
            continue;
        }
        // The mark of a difference or of a variation is no quantity.
        if is_mark(item, items.get(index + 1), place.has_coefficient) {
            if let Some(name) = difference(item, items.get(index + 1)) {
                entry(found, &name, at).positive |= here.positive;
            }
            continue;
        }
        if let Some(printed) = names::printed(item, None) {
            let follows = items.get(index + 1);
            let usage = entry(found, &printed.name, at);
            usage.moves |= printed.dots > 0 || place.moves;
            usage.positive |= here.positive;
            usage.conserved |= place.conserved;
            usage.raises |= place.raises;
            usage.precedes |= items[index + 1..].iter().find(|next| !is_space(next)).is_some_and(is_factor);
            let is_factor_of = |next: &Item| {
                is_variable(next) || is_parenthesis(next) && !ANGLES.contains(&printed.name.base.as_str())
            };
            let scales = here.angle && follows.is_some_and(is_factor_of);
            usage.scales |= scales;
            usage.angle |= here.angle && !scales;
            if let Some(arguments) = follows.and_then(names_in_parentheses) {
                usage.arguments.get_or_insert(arguments);
            }
            if let Some(sup) = printed.sup {
                usage.exponential |= !matches!(contents(sup), [Item { layout: Layout::Number(_), .. }]);
                let raises = printed.name.base != "e";
                walk(std::slice::from_ref(sup), Place { raises, ..Place::default() }, at, found);
            }
            continue;
        }
        match &item.layout {
            Layout::Group(inner) => walk(inner, here, at, found),
            Layout::Fence(delimiter, inner) => {
                if let (Delimiter::Bar | Delimiter::PlainBar, Some(name)) = (delimiter, lone_name(inner)) {
                    entry(found, &name, at).modulus = true;
                }
                let alone = inner.iter().filter(|item| !is_space(item)).count() == 1;
                walk(inner, Place { angle: here.angle && alone, ..here }, at, found);
            }
            Layout::Scripts { nucleus, sup, .. } => {
                walk(std::slice::from_ref(nucleus), here, at, found);
                if let Some(sup) = sup {
                    walk(std::slice::from_ref(sup), Place::default(), at, found);
                }
            }
            Layout::Fraction(above, below) => {
                let place = Place { positive: here.positive, ..place };
                let moves = is_by_time(below);
                let is_operator = is_differential(below) && is_letter_d(above);
                let differentiated = is_differential(above) || is_operator;
                let above_place = Place { moves: moves && differentiated, ..place };
                if let (false, Some(of), Some(by)) = (moves, differential_of(above), differential_of(below)) {
                    entry(found, &of, at).differentiated_by.push(by);
                }
                walk(&contents(above)[usize::from(differentiated)..], above_place, at, found);
                match is_differential(below) {
                    true => {
                        walk(&contents(below)[1..], Place::default(), at, found);
                        for printed in contents(below)[1..].iter().filter_map(|item| names::printed(item, None)) {
                            entry(found, &printed.name, at).differentiates = true;
                        }
                    }
                    false => walk(contents(below), Place { positive: true, ..place }, at, found),
                }
                for part in [above, below].map(|part| contents(part)) {
                    if let ([only], false) = (part, is_differential(below))
                        && let Some(printed) = names::printed(only, None)
                    {
                        entry(found, &printed.name, at).divides = true;
                    }
                }
            }
            Layout::Root(_, inner) => walk(contents(inner), Place { positive: true, ..place }, at, found),
            Layout::Accent(_, inner) | Layout::Style(_, inner) => {
                walk(std::slice::from_ref(inner), here, at, found);
            }
            Layout::Environment(_, rows) => {
                rows.iter().flatten().for_each(|cell| walk(cell, place, at, found));
            }
            _ => {}
        }
    }
}

/// Whether an item is a sum, or has one above a fraction line or in its parentheses.
fn has_terms(item: &Item) -> bool {
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
    match &item.layout {
        Layout::Fence(_, inner) | Layout::Group(inner) => inner.iter().any(|item| is_sign(item) || has_terms(item)),
        Layout::Fraction(above, below) => has_terms(above) || has_terms(below),
        _ => false,
    }
}

fn is_trigonometric(item: &Item) -> bool {
    let is_one = |item: &Item| matches!(&item.layout, Layout::Command(name) if ["\\sin", "\\cos", "\\tan", "\\cot", "\\sec", "\\csc"].contains(&name.as_str()));
    match &item.layout {
        Layout::Scripts { nucleus, .. } => is_one(nucleus),
        _ => is_one(item),
    }
}

/// The names in a parenthesis that holds a list of names and nothing else.
fn names_in_parentheses(item: &Item) -> Option<Vec<Name>> {
    let fence = match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    };
    let Layout::Fence(Delimiter::Round, inside) = &fence.layout else { return None };
    inside
        .split(|item| matches!(item.layout, Layout::Other(',')))
        .map(|argument| {
            let mut significant = argument.iter().filter(|item| !is_space(item));
            let (only, None) = (significant.next()?, significant.next()) else { return None };
            names::printed(only, None).filter(|printed| printed.sup.is_none()).map(|printed| printed.name)
        })
        .collect()
}
