//! Whether i is √−1 in a display without declarations: in the exponent of e, beside ħ, before a commutator, squared, or upright, unless it
//! is an index somewhere in the display. So is an upright j.

use super::super::super::arguments::has_dagger;
use super::super::super::layout::{Delimiter, Item, Layout, contents, parts};
use super::super::super::rows::relation;
use super::matrices::{is_bold, is_break, is_matrix, name_of};

fn is_i(item: &Item) -> bool {
    item.layout == Layout::Letter('i') || item.layout == Layout::Command("\\imath".to_owned()) || is_upright_i(item)
}

fn is_upright_i(item: &Item) -> bool {
    is_upright(item, 'i') || is_upright(item, 'j')
}

fn is_upright(item: &Item, letter: char) -> bool {
    matches!(&item.layout, Layout::Style(style, inner) if style == "\\mathrm"
        && matches!(contents(inner), [Item { layout: Layout::Letter(c), .. }] if *c == letter))
}

/// Whether an upright letter stands anywhere in items.
pub(super) fn has_upright(items: &[Item], letter: char) -> bool {
    items.iter().any(|item| is_upright(item, letter) || parts(item).into_iter().any(|part| has_upright(part, letter)))
}

/// Whether the letter i must be √−1 here.
pub fn has_imaginary_unit(items: &[Item]) -> bool {
    // Beside a dagger there are operators, and no currents.
    let is_quantum = || has_hbar(items) || has_states(items) || has_dagger(items);
    (is_evident(items) || is_quantum() && mentions(items)) && !is_index(items)
}

/// Whether a product of states stands anywhere, `\langle a|A|b\rangle`, and i is the name of none: it is no current beside it.
fn has_states(items: &[Item]) -> bool {
    fn states<'i>(items: &'i [Item], found: &mut Vec<&'i [Item]>) {
        let is_bar = |item: &&Item| item.layout == Layout::Other('|');
        for item in items {
            match &item.layout {
                Layout::Fence(Delimiter::Bra | Delimiter::Ket, inside) => found.push(inside),
                Layout::Fence(Delimiter::Angle, inside) if inside.iter().filter(is_bar).count() == 2 => {
                    found.push(inside)
                }
                _ => parts(item).into_iter().for_each(|part| states(part, found)),
            }
        }
    }
    let mut found = Vec::new();
    states(items, &mut found);
    !found.is_empty() && !found.into_iter().any(mentions)
}

/// Whether ħ stands anywhere: i is no current in such a display.
fn has_hbar(items: &[Item]) -> bool {
    let is_hbar = |item: &Item| {
        let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { item };
        matches!(&nucleus.layout, Layout::Command(name) if name == "\\hbar")
    };
    items.iter().any(|item| is_hbar(item) || parts(item).into_iter().any(has_hbar))
}

/// `\begin{pmatrix} 0 & -i \\ i & 0 \end{pmatrix}`: a matrix of numbers and i.
fn is_matrix_of_units(rows: &[Vec<Vec<Item>>]) -> bool {
    let is_part = |item: &Item| {
        is_i(item) || matches!(item.layout, Layout::Number(_) | Layout::Space(_) | Layout::Other('+' | '-'))
    };
    let mut cells = rows.iter().flatten();
    rows.len() > 1 && cells.clone().flatten().any(is_i) && cells.all(|cell| cell.iter().all(is_part))
}

pub(super) fn is_evident(items: &[Item]) -> bool {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_hbar = |item: Option<&&Item>| {
        item.is_some_and(|item| {
            let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { *item };
            nucleus.layout == Layout::Command("\\hbar".to_owned())
        })
    };
    // `\frac{L + iv}{L - iv}`: a number over its conjugate.
    let is_over_conjugate = |item: &Item| match &item.layout {
        Layout::Fraction(above, below) => is_conjugate(contents(above), contents(below)),
        _ => false,
    };
    if solid.iter().any(|item| is_over_conjugate(item)) {
        return true;
    }
    let here = solid.iter().enumerate().any(|(at, item)| match &item.layout {
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), .. } => {
            let is_e = nucleus.layout == Layout::Letter('e')
                || matches!(&nucleus.layout, Layout::Style(style, inner) if style == "\\mathrm"
                    && matches!(contents(inner), [Item { layout: Layout::Letter('e'), .. }]));
            is_e && mentions(contents(sup))
        }
        // `\frac{i}{\hbar}`
        Layout::Fraction(above, below)
            if contents(above).iter().any(is_i) && contents(below).iter().any(|item| is_hbar(Some(&item))) =>
        {
            true
        }
        // `\frac{i}{4}`
        Layout::Fraction(above, below) if matches!(contents(above), [only] if is_i(only)) => {
            contents(below).iter().all(|item| matches!(item.layout, Layout::Number(_) | Layout::Root(..)))
        }
        // `\frac{1}{2\pi i}`, `\frac{1}{2i}[A, B]`
        Layout::Fraction(above, below)
            if matches!(contents(above), [one] if is_one(one)) && is_twice_i(contents(below)) =>
        {
            let has_pi = contents(below).iter().any(|item| item.layout == Layout::Command("\\pi".to_owned()));
            has_pi || solid.get(at + 1).is_some_and(|next| is_commutator(next))
        }
        Layout::Environment(name, rows) if is_matrix(name) => is_matrix_of_units(rows),
        Layout::Command(name) if name == "\\exp" => {
            solid.get(at + 1).is_some_and(|next| matches!(&next.layout, Layout::Fence(_, inside) if mentions(inside)))
        }
        _ => {
            let next = solid.get(at + 1);
            is_upright_i(item)
                || is_i(item)
                    && (is_hbar(next)
                        || is_sine(next)
                        || is_greek(next)
                        || is_bold_name(next)
                        || is_pair(&solid, at)
                        || next.is_some_and(|next| is_commutator(next))
                        || next.is_some_and(|next| begins_with_a_frequency(next)))
        }
    });
    here || items.iter().any(|item| parts(item).into_iter().any(is_evident))
}

fn is_one(item: &Item) -> bool {
    matches!(&item.layout, Layout::Number(digits) if digits == "1")
}

/// `2i`, `2\pi i`
fn is_twice_i(items: &[Item]) -> bool {
    let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let is_two = solid.next().is_some_and(|first| matches!(&first.layout, Layout::Number(digits) if digits == "2"));
    let rest: Vec<&Item> = solid.collect();
    is_two && rest.last().is_some_and(|last| is_i(last)) && rest.len() <= 2
}

/// `[A, B]`, in angle brackets or parentheses perhaps.
fn is_commutator(item: &Item) -> bool {
    match &item.layout {
        Layout::Fence(Delimiter::Square, inside) => inside.iter().any(|item| item.layout == Layout::Other(',')),
        Layout::Fence(Delimiter::Angle | Delimiter::Round, inside) => {
            matches!(inside.as_slice(), [only] if is_commutator(only))
        }
        _ => false,
    }
}

/// `(\omega L - \ldots)`: what is imaginary of an impedance.
fn begins_with_a_frequency(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round | Delimiter::Square, inside) = &item.layout else { return false };
    let first = inside.iter().find(|item| !matches!(item.layout, Layout::Space(_)));
    first.and_then(name_of).is_some_and(|found| ["\\omega", "\\Omega"].contains(&found.name.base.as_str()))
}

/// A sine after i, as in cos θ + i sin θ.
fn is_sine(item: Option<&&Item>) -> bool {
    item.is_some_and(|item| matches!(&item.layout, Layout::Command(name) if name == "\\sin" || name == "\\sinh"))
}

/// A vector after i, which is then no index.
fn is_bold_name(item: Option<&&Item>) -> bool {
    item.and_then(|item| name_of(item))
        .is_some_and(|printed| is_bold(&printed.name) || printed.name.base.starts_with("\\vec{"))
}

/// A Greek letter that stands after √−1 more often than after a current: a frequency, a rate, an angle.
fn is_greek(item: Option<&&Item>) -> bool {
    const LETTERS: [&str; 15] = [
        "\\omega",
        "\\Omega",
        "\\gamma",
        "\\Gamma",
        "\\beta",
        "\\kappa",
        "\\theta",
        "\\phi",
        "\\varphi",
        "\\pi",
        "\\mu",
        "\\sigma",
        "\\varepsilon",
        "\\epsilon",
        "\\eta",
    ];
    item.and_then(|item| name_of(item)).is_some_and(|printed| LETTERS.contains(&printed.name.base.as_str()))
}

/// `x + iy`, `a - ib`, `v_x + iv_y`: a sum of two neighbours in the alphabet.
fn is_pair(items: &[&Item], at: usize) -> bool {
    let [.., first, sign] = &items[..at] else { return false };
    let is_sign = match &sign.layout {
        Layout::Command(name) => name == "\\pm" || name == "\\mp",
        _ => matches!(sign.layout, Layout::Other('+' | '-')),
    };
    let (true, Some(first), Some(second)) = (is_sign, name_of(first), items.get(at + 1).and_then(|next| name_of(next)))
    else {
        return false;
    };
    let (a, b) = (&first.name, &second.name);
    let pairs = [("x", "y"), ("a", "b"), ("u", "v"), ("p", "q"), ("A", "B"), ("X", "Y")];
    let by_letter = a.subscript == b.subscript && pairs.contains(&(a.base.as_str(), b.base.as_str()));
    let by_axis = a.base == b.base && a.subscript == ["x"] && b.subscript == ["y"];
    first.dots == second.dots && (by_letter || by_axis)
}

/// Whether i stands among the factors of an exponent.
fn mentions(items: &[Item]) -> bool {
    items.iter().any(|item| is_i(item) || parts(item).into_iter().any(mentions))
}

/// Whether i is an index, in a subscript or beside a sum, or equals something.
pub(super) fn is_index(items: &[Item]) -> bool {
    let names = |item: &Item| contents(item).iter().any(is_i);
    let here = |item: &Item| match &item.layout {
        Layout::Scripts { nucleus, sub, .. } => sub.as_deref().is_some_and(names) || is_i(nucleus) && sub.is_some(),
        Layout::Accent(_, inner) => is_i(inner),
        _ => false,
    };
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_value = solid
        .windows(2)
        .enumerate()
        .any(|(at, pair)| is_i(pair[0]) && relation(pair[1]).is_some() && (at == 0 || is_break(solid[at - 1])));
    is_value || items.iter().any(|item| here(item) || parts(item).into_iter().any(is_index))
}

/// Whether two sums differ in the signs of their terms with i alone, and have such a term.
fn is_conjugate(left: &[Item], right: &[Item]) -> bool {
    let solid = |items: &[Item]| {
        items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).cloned().collect::<Vec<_>>()
    };
    let (left, right) = (solid(left), solid(right));
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
    let mut changes = 0;
    let is_same = left.len() == right.len()
        && left.iter().zip(&right).enumerate().all(|(at, (a, b))| {
            match a.layout == b.layout || is_sign(a) && is_sign(b) {
                true if a.layout != b.layout => {
                    changes += 1;
                    left.get(at + 1).is_some_and(is_i)
                }
                is_same => {
                    is_same
                        || super::super::super::layout::latex(std::slice::from_ref(a))
                            == super::super::super::layout::latex(std::slice::from_ref(b))
                }
            }
        });
    is_same && changes > 0
}
