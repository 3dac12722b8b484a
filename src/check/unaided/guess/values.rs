//! What stands for one name in notes, since no part of the reader knows its value: `\langle E \rangle`, `\oint \vec E \cdot d\vec A`.
//!
//! A display that cannot be read says where. The shortest formula around that place that may be one quantity is declared
//! as one. So what the display says about it is known, and what stands inside it is not.

use crate::check::document::unreadable::faults;
use crate::check::usage::Usage;
use crate::code::Code;
use crate::formula::symbols::Name;
use crate::latex::layout::values::{ends_term, is_d, is_nabla, is_operator, is_value, is_vector, parts_of, text_of};
use crate::latex::layout::{Delimiter, Item, Layout, typeset_items};
use crate::latex::{Macros, Reading, names};
use crate::notes::Notes;
use crate::source::{Missing, Span};

/// A formula that stands for one name.
pub(crate) struct Value {
    /// The name that it stands for.
    pub name: String,
    /// Whether it may vary with time.
    pub moves: bool,
    /// Whether it is a vector, as its markup says.
    pub is_vector: bool,
    /// The name of which it is the differential.
    pub differential_of: Option<Name>,
    /// Whether the first display with it says what it is.
    pub is_given: bool,
}

impl Value {
    fn of(run: &[Item], usages: &[Usage]) -> Value {
        let is_space = |item: &&Item| matches!(item.layout, Layout::Space(_));
        let significant: Vec<&Item> = run.iter().filter(|item| !is_space(item)).collect();
        let printed = match significant.as_slice() {
            [d, name] if is_d(d) => names::printed(name, None).filter(|printed| printed.dots == 0),
            _ => None,
        };
        // `dx^2` is the square of dx.
        let nucleus = match significant.get(1).map(|item| &item.layout) {
            Some(Layout::Scripts { nucleus, sub: None, sup: Some(_), .. }) if printed.is_some() => &**nucleus,
            _ => significant.get(1).copied().unwrap_or(&run[0]),
        };
        let name = if printed.is_some() { text_of(&[run[0].clone(), nucleus.clone()]) } else { text_of(run) };
        let differential_of = printed.map(|printed| printed.name);
        Value {
            name,
            moves: moves(run) || contains_what_moves(run, usages),
            is_vector: is_vector(run),
            differential_of,
            is_given: false,
        }
    }
}

/// The formulas that may stand for one name, one for each fault of the readings that is no missing name, and for each
/// derivative of what no display gives a formula.
pub(crate) fn values(readings: &[Reading], notes: &Notes, macros: &Macros, usages: &[Usage]) -> Vec<Value> {
    let mut found = Vec::new();
    for (reading, display) in readings.iter().zip(&notes.equations) {
        let Ok(items) = typeset_items(&display.text, macros) else { continue };
        for fault in faults(reading) {
            // A name can be declared by itself, except for the d of a differential.
            if matches!(&fault.missing, Some(Missing::Name(name)) if !["d", "\\mathrm{d}"].contains(&name.as_str())) {
                continue;
            }
            let value = around(&items, fault.span)
                .map(|run| Value { is_given: is_left(&run, &items), ..Value::of(&run, usages) });
            found.extend(value);
        }
        for member in reading.statements.iter().flatten().flat_map(|statement| &statement.members) {
            member.walk(&mut |part| {
                if part.is_null()
                    && let Some(run) = around(&items, part.span)
                    && is_derivative_of_unknown(&run, usages)
                {
                    found.push(Value::of(&run, usages));
                }
            });
        }
    }
    found
}

/// Whether a mean value is the whole left side of a display: `\langle x^2 \rangle = …`.
fn is_left(run: &[Item], items: &[Item]) -> bool {
    let is_mean = matches!(run, [Item { layout: Layout::Fence(Delimiter::Angle, _), .. }]);
    let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    is_mean
        && solid.next().is_some_and(|first| run.first() == Some(first))
        && solid.next().is_some_and(|next| next.layout == Layout::Other('='))
}

/// Whether a formula is a derivative of a name for which no display gives a formula.
fn is_derivative_of_unknown(run: &[Item], usages: &[Usage]) -> bool {
    let [Item { layout: Layout::Fraction(above, _), .. }] = run else { return false };
    let mut names = contents(above)[1..].iter().filter_map(|item| names::printed(item, None)).map(|found| found.name);
    let is_given = |name: &Name| usages.iter().any(|usage| usage.name == *name && usage.given);
    names.next().is_some_and(|first| !is_given(&first) && !names.any(|name| is_given(&name)))
}

/// The names of formulas that stand in a display which does not fit the shapes of what stands beside them.
pub(crate) fn misshapen(readings: &[Reading], notes: &Notes, macros: &Macros) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (at, (reading, display)) in readings.iter().zip(&notes.equations).enumerate() {
        if faults(reading).any(|fault| fault.code == Code::ShapeMismatch)
            && let Ok(items) = typeset_items(&display.text, macros)
        {
            values_in(&items, &mut |name| found.push((at, name.to_owned())));
        }
    }
    found
}

fn values_in(items: &[Item], note: &mut dyn FnMut(&str)) {
    for item in items {
        if let Layout::Value(name) = &item.layout {
            note(name);
        }
        parts_of(item).into_iter().for_each(|part| values_in(part, note));
    }
}

/// Whether a formula may vary with time: a rate or the time stands in it, or it is a mean value, which may stand under d/dt.
fn moves(run: &[Item]) -> bool {
    let text = text_of(run);
    let is_mean = matches!(run.first().map(|item| &item.layout), Some(Layout::Fence(Delimiter::Angle, _)));
    is_mean || text.contains("\\dot") || text.contains("\\ddot") || text.contains('t') && has_time(run)
}

/// Whether a name that moves elsewhere stands in items: ∂L/∂θ varies as θ does.
fn contains_what_moves(items: &[Item], usages: &[Usage]) -> bool {
    let moves = |item: &Item| {
        names::printed(item, None)
            .is_some_and(|printed| usages.iter().any(|usage| usage.moves && usage.name == printed.name))
    };
    items.iter().any(|item| moves(item) || parts_of(item).into_iter().any(|part| contains_what_moves(part, usages)))
}

/// Whether the letter t stands in items as a name.
fn has_time(items: &[Item]) -> bool {
    let is_time = |item: &Item| names::printed(item, None).is_some_and(|printed| printed.name == Name::plain("t"));
    items.iter().any(|item| is_time(item) || parts_of(item).into_iter().any(has_time))
}

/// The shortest run around a place that may stand for one name, in items that do not share its beginning.
fn around(items: &[Item], place: Span) -> Option<Vec<Item>> {
    let covers = |item: &Item| item.span.contains(place);
    let touches = |item: &Item| item.span.start < place.end && place.start < item.span.end || covers(item);
    let first = items.iter().position(touches)?;
    let last = items.iter().rposition(touches)?;
    if first == last
        && let Some(inner) = parts_of(&items[first]).into_iter().find_map(|part| around(part, place))
    {
        return Some(inner);
    }
    let run = |start: usize, end: usize| {
        let run = &items[start..end];
        is_value(run).then(|| run.to_vec())
    };
    let skip = |mut at: usize| {
        while matches!(items.get(at).map(|item| &item.layout), Some(Layout::Space(_))) {
            at += 1;
        }
        at
    };
    // What an operator before the place acts on is a part of what it stands for.
    let operator =
        (0..=first).rev().take_while(|at| *at == first || !ends_term(&items[*at])).find(|at| is_operator(&items[*at]));
    if let Some(start) = operator {
        let length = items[start + 1..].iter().take_while(|item| !ends_term(item)).count();
        return run(start, start + 1 + length);
    }
    if is_nabla(&items[first]) {
        let mut end = skip(first + 1);
        if matches!(items.get(end).map(|item| &item.layout), Some(Layout::Command(name)) if name == "\\cdot" || name == "\\times")
        {
            end = skip(end + 1);
        }
        let is_argument = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::Round, _));
        end += 1;
        if items.get(end).is_some_and(is_argument) && !is_argument(&items[end - 1]) {
            end += 1;
        }
        return (end <= items.len()).then(|| run(first, end)).flatten();
    }
    if is_d(&items[first]) {
        let end = skip(first + 1) + 1;
        let is_name = items.get(end - 1).is_some_and(|item| names::printed(item, None).is_some());
        return is_name.then(|| run(first, end)).flatten();
    }
    run(first, last + 1).or_else(|| run(first, (last + 2).min(items.len())))
}

fn contents(item: &Item) -> &[Item] {
    match &item.layout {
        Layout::Group(items) => items,
        _ => std::slice::from_ref(item),
    }
}
