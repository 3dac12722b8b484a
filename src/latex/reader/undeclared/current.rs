//! Whether i is a quantity in a display, and not √−1: a current that is differentiated, as in `L\frac{di}{dt} + Ri = v`, or stands behind
//! μ₀; an angle of which only the sine is taken, as in `\frac{\sin i}{\sin r}`.

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::names;
use super::super::items::{Joint, differential, joint};

/// Whether i can be nothing else anywhere in items.
pub(in super::super::super) fn is_a_quantity(items: &[Item]) -> bool {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let on_one_line = solid
        .windows(4)
        .any(|four| is_change(&four[..2]) && joint(four[2]) == Some(Joint::Slash) && differential(four[3]).is_some());
    let here = (0..solid.len()).any(|at| {
        let next = solid.get(at + 1).is_some_and(|next| is_i(next));
        let goes_on = solid.get(at + 2).is_some_and(|after| names::printed(after, None).is_some());
        next && (is_permeability(solid[at]) || is_sine(solid[at]) && !goes_on)
    });
    on_one_line
        || here
        || items.iter().any(|item| {
            let is_derivative = match &item.layout {
                Layout::Fraction(above, below) => {
                    is_change(&contents(above).iter().collect::<Vec<&Item>>()) && starts(contents(below))
                }
                _ => false,
            };
            is_derivative || parts(item).into_iter().any(is_a_quantity)
        })
}

fn is_i(item: &Item) -> bool {
    item.layout == Layout::Letter('i')
}

fn is_permeability(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| found.name.base == "\\mu" && found.name.subscript == ["0"])
}

fn is_sine(item: &Item) -> bool {
    let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { item };
    matches!(&nucleus.layout, Layout::Command(name) if ["\\sin", "\\cos", "\\tan"].contains(&name.as_str()))
}

fn starts(items: &[Item]) -> bool {
    items.first().is_some_and(|first| differential(first).is_some())
}

/// `di`, `d^2 i`
fn is_change(items: &[&Item]) -> bool {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).copied().collect();
    matches!(solid.as_slice(), [mark, i] if differential(mark).is_some() && is_i(i))
}
