//! Whether i is a current in a display: it is differentiated there, as in `L\frac{di}{dt} + Ri = v`. Nobody differentiates √−1.

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::items::{Joint, differential, joint};

/// Whether a derivative of i stands anywhere in items.
pub(in super::super::super) fn is_differentiated(items: &[Item]) -> bool {
    // `di/dt` on one line.
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let on_one_line = solid
        .windows(4)
        .any(|four| is_change(&four[..2]) && joint(four[2]) == Some(Joint::Slash) && differential(four[3]).is_some());
    on_one_line
        || items.iter().any(|item| {
            let is_one = match &item.layout {
                Layout::Fraction(above, below) => {
                    is_change(&contents(above).iter().collect::<Vec<&Item>>()) && starts(contents(below))
                }
                _ => false,
            };
            is_one || parts(item).into_iter().any(is_differentiated)
        })
}

fn starts(items: &[Item]) -> bool {
    items.first().is_some_and(|first| differential(first).is_some())
}

/// `di`, `d^2 i`
fn is_change(items: &[&Item]) -> bool {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).copied().collect();
    matches!(solid.as_slice(), [mark, i] if differential(mark).is_some() && i.layout == Layout::Letter('i'))
}
