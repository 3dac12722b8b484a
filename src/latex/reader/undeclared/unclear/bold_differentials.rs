//! A bold d before a letter, `T\mathbf{d}S = \mathbf{d}U`: a differential, or a vector before a factor.
//!
//! Under an integral that has no other differential it is one, which `layout/marks.rs` knows.

use crate::source::Fault;

use super::super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::super::names;

/// The fault of such a d in a display where no bold d stands alone.
pub(super) fn unclear_differential(items: &[Item]) -> Option<Fault> {
    let mut found = Vec::new();
    list(items, &mut found);
    let is_vector = found.iter().any(|(_, is_before_a_name)| !is_before_a_name);
    let (first, _) = found.first().filter(|_| !is_vector)?;
    Some(
        Fault::ambiguous(first.span, "a bold d before a letter may be a differential or a vector")
            .help("write \\mathrm{d} for a differential; write a vector behind its factor, or with \\cdot"),
    )
}

/// Each bold d, and whether a name follows it.
fn list<'a>(items: &'a [Item], found: &mut Vec<(&'a Item, bool)>) {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    for (at, item) in solid.iter().enumerate() {
        // `\mathbf{d}_1 \mathbf{W}`: a differential has no subscript.
        let has_scripts = matches!(item.layout, Layout::Scripts { .. });
        let is_before_a_name = || solid.get(at + 1).is_some_and(|next| names::printed(next, None).is_some());
        match is_bold_d(item) {
            true => found.push((item, !has_scripts && is_before_a_name())),
            false => parts(item).into_iter().for_each(|part| list(part, found)),
        }
    }
}

fn is_bold_d(item: &Item) -> bool {
    let is_d = |inner: &Item| matches!(contents(inner), [Item { layout: Layout::Letter('d'), .. }]);
    match &item.layout {
        Layout::Style(style, inner) => style == "\\mathbf" && is_d(inner),
        Layout::Scripts { nucleus, .. } => is_bold_d(nucleus),
        _ => false,
    }
}
