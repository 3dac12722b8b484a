//! What stands in a parenthesis after a name, as far as it says whether the name is a function.

use crate::formula::symbols::Name;
use crate::formula::units;

use super::layout::{Delimiter, Item, Layout, contents, latex};
use super::names;
use super::reader::items::{differential, whole_number};
use super::rows::relation;

/// Whether a number above δ is that of the dimensions, `\delta^3`, `\delta^{(3)}`.
pub(super) fn is_dimension(sup: &Item) -> bool {
    match contents(sup) {
        [Item { layout: Layout::Fence(Delimiter::Round, inside), .. }] => inside.len() == 1,
        _ => matches!(whole_number(sup), Some(3 | 4)),
    }
}

/// The name of the distribution `\delta^3(r - r')`, as `\delta^{(3)}` is written: the number is that of the dimensions.
pub(super) fn distribution(found: &names::Printed<'_>, next: Option<&Item>) -> Option<Name> {
    let is_delta = found.name == Name::plain("\\delta") && found.dots == 0;
    let is_called = matches!(next.and_then(fence), Some((Delimiter::Round, _)));
    let number = found.sup.filter(|sup| is_dimension(sup)).and_then(whole_number)?;
    (is_delta && is_called).then(|| Name::plain(format!("\\delta^{{({number})}}")))
}

/// Whether an upright unit stands in square brackets, `[\mathrm{keV}]`: it is that of the name before it.
pub(super) fn is_unit_in_brackets(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Square, inside) = &item.layout else { return false };
    let [only] = inside.as_slice() else { return false };
    match &only.layout {
        Layout::Unit(_) => true,
        Layout::Text(word) => units::parse(word).is_ok(),
        Layout::Style(style, inner) if style == "\\mathrm" => units::parse(&latex(contents(inner))).is_ok(),
        _ => false,
    }
}

/// Whether a dagger stands in a parenthesis: operators are factors, and no arguments.
pub(super) fn has_dagger<'i>(inside: impl IntoIterator<Item = &'i Item>) -> bool {
    inside.into_iter().any(|item| match &item.layout {
        Layout::Command(name) => name == "\\dagger",
        Layout::Scripts { nucleus, sup, .. } => has_dagger([&**nucleus]) || has_dagger(sup.as_deref()),
        Layout::Group(items) | Layout::Fence(_, items) => has_dagger(items),
        _ => false,
    })
}

/// Whether a fraction is a derivative: d or ∂ begins both of its parts.
pub(super) fn starts_derivative(above: &Item, below: &Item) -> bool {
    [above, below].iter().all(|part| contents(part).first().is_some_and(|first| differential(first).is_some()))
}

/// A parenthesis, with a script perhaps, and its contents.
pub(super) fn fence(item: &Item) -> Option<(Delimiter, &[Item])> {
    match &item.layout {
        Layout::Fence(delimiter, inside) => Some((*delimiter, inside)),
        Layout::Scripts { nucleus, .. } => match &nucleus.layout {
            Layout::Fence(delimiter, inside) => Some((*delimiter, inside)),
            _ => None,
        },
        _ => None,
    }
}

/// The bar of `P(A|B)`.
pub(super) fn is_given(item: &Item) -> bool {
    item.layout == Layout::Other('|') || matches!(&item.layout, Layout::Command(name) if name == "\\mid")
}

/// 0, and 0 from one side, `0^+`.
pub(super) fn is_zero(item: &Item) -> bool {
    match &item.layout {
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => {
            let side = contents(sup);
            whole_number(nucleus) == Some(0) && matches!(side, [Item { layout: Layout::Other('+' | '-'), .. }])
        }
        _ => whole_number(item) == Some(0),
    }
}

pub(super) fn is_comma(item: &Item) -> bool {
    matches!(item.layout, Layout::Other(',' | ';'))
}

/// The items without spaces at both ends.
pub(super) fn trimmed(items: &[Item]) -> &[Item] {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let start = items.iter().position(|item| !is_space(item)).unwrap_or(items.len());
    let end = items.iter().rposition(|item| !is_space(item)).map_or(start, |at| at + 1);
    &items[start..end]
}

/// Whether items are the number of a step: `n`, `n+1`, `0`.
pub(super) fn is_step(items: &[Item]) -> bool {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_counter = |item: &Item| {
        let letter = match &item.layout {
            Layout::Scripts { nucleus, sub: Some(sub), sup: None, primes: 0 } if whole_number(sub).is_some() => nucleus,
            _ => item,
        };
        matches!(letter.layout, Layout::Letter('n' | 'k' | 'm' | 'i' | 'j' | 't'))
    };
    let is_number = |item: &Item| whole_number(item).is_some();
    match solid.as_slice() {
        [only] => is_counter(only) || is_number(only),
        [first, Item { layout: Layout::Other('+' | '-'), .. }, last] => {
            is_counter(first) && (is_number(last) || is_counter(last))
        }
        _ => false,
    }
}

/// Whether a name stands in its own parenthesis as a letter without an argument, `J(J + 1)`, `v(v)^T`: nothing is a function of itself.
pub(super) fn names_itself(inside: &[Item], name: &Name) -> bool {
    let is_it = |at: usize| {
        let is_name = names::printed(&inside[at], None).is_some_and(|found| found.sup.is_none() && found.name == *name);
        is_name && inside.get(at + 1).and_then(fence).is_none()
    };
    let is_list = inside.iter().any(|item| is_comma(item) || is_given(item) || relation(item).is_some());
    name.primes == 0 && !is_list && (0..inside.len()).any(is_it)
}

/// Whether a letter stands above that is an index rather than a power.
pub(super) fn is_letter(sup: &Item) -> bool {
    names::printed(sup, None).is_some_and(|found| found.sup.is_none() && found.name.subscript.is_empty())
}

pub(super) fn item_has_comma(item: &Item) -> bool {
    matches!(&item.layout, Layout::Fence(_, inside) if inside.iter().any(is_comma))
}

/// Whether a fraction in parentheses stands first, and further parentheses behind it: `f\left(\frac{L}{D}\right)\left(\frac{v^2}{2g}\right)` has
/// factors in parentheses, so the first may be one too.
pub(super) fn goes_on_with_a_parenthesis(items: &[Item]) -> bool {
    let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let is_fraction = |item: &Item| matches!(&item.layout, Layout::Fence(Delimiter::Round, inside) if matches!(inside.as_slice(), [Item { layout: Layout::Fraction(..), .. }]));
    let is_parenthesis = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::Round, _));
    solid.next().is_some_and(is_fraction) && solid.next().is_some_and(is_parenthesis)
}
