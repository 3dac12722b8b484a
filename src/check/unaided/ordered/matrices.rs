//! Matrices in plain letters: `\dot x = A x + B u`.
//!
//! A capital is a matrix where it is transposed, where the words call it one, or in the equations of a linear system. The small letter
//! after it is a column. What else is a capital in a product or a sum with matrices is one too: whatever holds for all square
//! matrices holds for columns in their place.

use super::{Ordered, each_list, plain, solid};
use crate::check::document::inferred::prose::body_of;
use crate::formula::symbols::Name;
use crate::latex::layout::{Item, Layout, typeset_items};
use crate::latex::{Macros, names};
use crate::notes::Notes;

/// The rows of a matrix of which no display says how many it has.
const ROWS: usize = 3;

/// The most bytes between "matrices" and the letters that it is about.
const NEAR: usize = 24;

/// The matrices and columns in the displays of notes.
pub(super) fn letters(notes: &Notes, displays: &[Vec<Item>], macros: &Macros) -> Vec<Ordered> {
    let mut found: Vec<Name> = said(notes, macros);
    let is_quantity = uses_letter(displays, "T");
    for items in displays {
        each_list(items, &mut |list| {
            if !is_quantity {
                found.extend(list.iter().filter(|item| is_transposed(item)).filter_map(|item| capital(item)));
            }
            found.extend(linear_system(list));
        });
    }
    if found.is_empty() {
        return Vec::new();
    }
    // The other capitals of their products and sums.
    for items in displays {
        each_list(items, &mut |list| {
            for statement in list.split(|item| ends(item)) {
                if statement.iter().filter_map(|item| capital(item)).any(|name| found.contains(&name)) {
                    found.extend(statement.iter().filter_map(|item| capital(item)));
                }
            }
        });
    }
    let written: Vec<(Name, usize, usize)> = displays.iter().flat_map(|items| written(items)).collect();
    let size = |name: &Name| written.iter().find(|(known, ..)| known == name);
    let rows = written.iter().find(|(name, ..)| found.contains(name)).map_or(ROWS, |(_, rows, _)| *rows);
    let mut letters: Vec<Ordered> = Vec::new();
    let mut add = |name: &Name, range: Option<String>| {
        if letters.iter().all(|known| known.name != *name) {
            letters.push(Ordered { name: name.clone(), range, is_vector: false });
        }
    };
    for name in &found {
        add(name, size(name).is_none().then(|| format!("{rows}x{rows} matrix")));
    }
    for items in displays {
        each_list(items, &mut |list| {
            for pair in list.windows(2) {
                let (Some(matrix), Some(column)) = (capital(pair[0]), small(pair[1])) else { continue };
                if found.contains(&matrix) {
                    let entries = size(&matrix).map_or(rows, |(_, _, columns)| *columns);
                    // One entry is a number.
                    if entries > 1 {
                        add(&column, size(&column).is_none().then(|| format!("{entries}x1 matrix")));
                    }
                }
            }
        });
    }
    letters
}

/// The capital that an item is, with a power or a dot perhaps.
fn capital(item: &Item) -> Option<Name> {
    plain(item).filter(|name| matches!(name.base.as_bytes(), [b'A'..=b'Z']) && name.base != "I")
}

/// The small letter that an item is.
fn small(item: &Item) -> Option<Name> {
    let is_power = names::printed(item, None).is_some_and(|printed| printed.sup.is_some());
    plain(item).filter(|name| {
        !is_power && (matches!(name.base.as_bytes(), [b'a'..=b'z']) || name.base.starts_with('\\')) && name.base != "t"
    })
}

/// Whether a letter stands in displays other than as the mark of a transpose.
fn uses_letter(displays: &[Vec<Item>], letter: &str) -> bool {
    let mut found = false;
    for items in displays {
        each_list(items, &mut |list| {
            found |= list.iter().filter_map(|item| plain(item)).any(|name| name.base == letter)
        });
    }
    found
}

/// Whether an item carries the mark of a transpose.
fn is_transposed(item: &Item) -> bool {
    let is_mark = |sup: &Item| match &sup.layout {
        Layout::Letter(c) => *c == 'T',
        Layout::Command(name) => name == "\\top",
        Layout::Group(inner) => matches!(solid(inner).as_slice(), [only] if match &only.layout {
            Layout::Letter(c) => *c == 'T',
            Layout::Command(name) => name == "\\top",
            Layout::Style(_, inner) => inner.layout == Layout::Letter('T'),
            _ => false,
        }),
        Layout::Style(_, inner) => inner.layout == Layout::Letter('T'),
        _ => false,
    };
    names::printed(item, None).and_then(|printed| printed.sup).is_some_and(is_mark)
}

/// The capitals of `\dot x = A x + B u`: the rate of a small letter is a sum whose first term is a capital before that letter.
fn linear_system(list: &[&Item]) -> Vec<Name> {
    let [rate, equals, rest @ ..] = list else { return Vec::new() };
    let dots = names::printed(rate, None).map_or(0, |printed| printed.dots);
    let (Some(state), true, Layout::Other('=')) = (small(rate), dots == 1, &equals.layout) else { return Vec::new() };
    let end = rest.iter().position(|item| ends(item)).unwrap_or(rest.len());
    let terms = rest[..end].split(|item| matches!(item.layout, Layout::Other('+')));
    let factors: Option<Vec<(Name, Name)>> = terms
        .map(|term| match term {
            [matrix, column] => Some((capital(matrix)?, small(column)?)),
            _ => None,
        })
        .collect();
    match factors {
        Some(factors) if factors.len() > 1 && factors[0].1 == state => {
            factors.into_iter().map(|(matrix, _)| matrix).collect()
        }
        _ => Vec::new(),
    }
}

fn ends(item: &Item) -> bool {
    match &item.layout {
        Layout::Row | Layout::Other(',' | ';') | Layout::Text(_) => true,
        Layout::Command(name) => name == "\\quad" || name == "\\qquad",
        _ => false,
    }
}

/// The names to which a display gives a written matrix, with its rows and columns.
fn written(items: &[Item]) -> Vec<(Name, usize, usize)> {
    let mut found = Vec::new();
    for part in solid(items).windows(3) {
        let Layout::Other('=') = part[1].layout else { continue };
        let (Some(name), Layout::Environment(kind, rows)) = (plain(part[0]), &part[2].layout) else { continue };
        if kind.ends_with("matrix") {
            found.push((name, rows.len(), rows.first().map_or(0, Vec::len)));
        }
    }
    found
}

/// The capitals that the words call matrices: "the matrices $A$ and $B$".
fn said(notes: &Notes, macros: &Macros) -> Vec<Name> {
    let text = &notes.source.text;
    let mut found = Vec::new();
    let mut last: Option<usize> = None;
    for span in &notes.inline {
        let before = text.get(span.start.saturating_sub(NEAR)..span.start).unwrap_or_default().to_lowercase();
        let is_next = ["matrix ", "matrices ", "matrix\n", "matrices\n"].iter().any(|word| before.ends_with(word));
        let between = last.and_then(|end| text.get(end..span.start)).map(|between| between.trim().to_owned());
        let goes_on = between.is_some_and(|between| ["and", ",", ", and", "und", "et"].contains(&between.as_str()));
        if !is_next && !goes_on {
            last = None;
            continue;
        }
        last = Some(span.end);
        let formula = body_of(notes, *span).map(|body| notes.source.slice(body));
        let items = formula.and_then(|formula| typeset_items(formula, macros).ok()).unwrap_or_default();
        if let [only] = solid(&items).as_slice() {
            found.extend(capital(only));
        }
    }
    found
}
