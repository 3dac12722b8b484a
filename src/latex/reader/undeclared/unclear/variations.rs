//! A δ before an integral, `\theta = \delta\int_0^1 f\,d\eta`, in a display where δ stands alone too: there it is a thickness, and no variation.

use crate::source::{Fault, Span};

use super::super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::super::names;
use super::super::super::items::is_any_integral;

/// The fault of such a δ in a display.
pub(super) fn unclear_variation(items: &[Item]) -> Option<Fault> {
    let mut found = Found::default();
    found.list(items);
    let span = found.before_integral.filter(|_| found.is_alone)?;
    Some(
        Fault::ambiguous(span, "δ before an integral may be a factor or mean the variation of the integral")
            .help("for a product, write \\delta \\cdot; for the variation, put the integral in parentheses"),
    )
}

#[derive(Default)]
struct Found {
    before_integral: Option<Span>,
    is_alone: bool,
}

impl Found {
    fn list(&mut self, items: &[Item]) {
        let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        for (at, item) in solid.iter().enumerate() {
            let next = solid.get(at + 1);
            if is_delta(item) {
                match next.filter(|next| is_any_integral(next)) {
                    Some(next) => self.before_integral = Some(item.span.to(next.span)),
                    None => {
                        let varied = |next: &&&Item| {
                            names::printed(next, None).is_some() || matches!(next.layout, Layout::Fence(..))
                        };
                        self.is_alone |= next.filter(varied).is_none();
                    }
                }
            }
            if let Layout::Scripts { nucleus, sub, sup, .. } = &item.layout {
                self.is_alone |= is_delta(nucleus);
                for script in [sub, sup].into_iter().flatten() {
                    self.list(contents(script));
                }
            }
            parts(item).into_iter().for_each(|part| self.list(part));
        }
    }
}

fn is_delta(item: &Item) -> bool {
    item.layout == Layout::Command("\\delta".to_owned())
}
