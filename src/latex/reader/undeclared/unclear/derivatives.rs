//! Derivatives that look like something else: the Laplacian `\Delta u`, which prints as a difference, and the subscripts of
//! `u_t = u_{xx}`, which print as labels. Where the display shows that they may be derivatives, they are refused.

use crate::formula::symbols::Name;
use crate::source::{Fault, Span};

use super::super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::super::names;
use super::super::super::super::rows::relation;

/// Letters of fields, of which Δ is a Laplacian as often as a difference.
const FIELDS: [&str; 6] = ["u", "\\phi", "\\varphi", "\\Phi", "\\psi", "\\Psi"];

/// The letters by which a subscript may differentiate.
const VARIABLES: [&str; 5] = ["t", "x", "y", "z", "r"];

/// The fault of such a derivative in a display.
pub(super) fn unclear_derivative(items: &[Item]) -> Option<Fault> {
    let mut found = Found::default();
    found.list(items);
    if let Some((name, span)) = found.laplacian() {
        let what = format!("Δ before {name} may be the Laplacian or a difference");
        return Some(
            Fault::ambiguous(*span, what)
                .help(format!("write \\nabla^2 {name} for the Laplacian, and {name}_2 - {name}_1 for a difference")),
        );
    }
    let subscripted = found.derivative_below()?;
    let what = format!("the subscript {} of {} may be a derivative or a label", subscripted.below, subscripted.name);
    Some(Fault::ambiguous(subscripted.span, what).help(
        "write \\frac{\\partial u}{\\partial t} for the derivative; for a label, use a number or a word in \\text",
    ))
}

/// A name with variables below it.
struct Subscripted {
    /// The name without them.
    name: Name,
    below: String,
    span: Span,
}

#[derive(Default)]
struct Found {
    /// The names behind Δ.
    differences: Vec<(Name, Span)>,
    /// The names behind ∂.
    differentiated: Vec<Name>,
    /// The names by which ∂ differentiates.
    variables: Vec<Name>,
    /// The names without a subscript, where neither Δ nor ∂ stands before them.
    plain: Vec<Name>,
    /// The names to which Δ of the same name is added, `\phi + \Delta\phi`.
    shifted: Vec<Name>,
    /// The names of which Δ is a whole side with a minus, `-\Delta u = f`.
    sides: Vec<Name>,
    subscripted: Vec<Subscripted>,
    /// Whether a variable stands below parentheses, `(u h)_x`.
    has_group: bool,
    has_nabla: bool,
}

impl Found {
    fn laplacian(&self) -> Option<&(Name, Span)> {
        // `\Delta f = \frac{\partial f}{\partial x} \Delta x` has differences.
        let is_error = self.differences.iter().any(|(name, _)| self.variables.contains(name));
        let is_one = self.differences.iter().all(|(name, _)| *name == self.differences[0].0);
        let is_bold = |name: &Name| ["\\mathbf{", "\\vec{"].iter().any(|mark| name.base.contains(mark));
        self.differences.iter().filter(|_| !is_error).find(|(name, _)| {
            let is_field = is_one && FIELDS.contains(&name.base.as_str()) && self.plain.contains(name);
            self.differentiated.contains(name)
                || self.has_nabla && is_bold(name)
                || is_field && !self.shifted.contains(name)
                || self.sides.contains(name) && name.base == "u"
        })
    }

    fn derivative_below(&self) -> Option<&Subscripted> {
        self.subscripted.iter().find(|one| {
            let of_it = |is_it: &dyn Fn(&str) -> bool| {
                self.subscripted.iter().any(|other| other.name == one.name && is_it(&other.below))
            };
            let is_plain = self.plain.contains(&one.name);
            // `\sigma_x \sigma_t` are errors of two quantities.
            let is_field =
                |name: &Name| FIELDS.contains(&name.base.as_str()) || ["w", "h", "q"].contains(&name.base.as_str());
            let is_twice = one.below.len() > 1;
            let is_differenced = self.differences.iter().any(|(name, _)| *name == one.name);
            let is_letter = one.name.base.starts_with(|c: char| c.is_lowercase() || c == '\\');
            let is_tensor = ["\\sigma", "\\tau", "\\epsilon", "\\varepsilon"].contains(&one.name.base.as_str());
            match one.below.as_str() {
                "t" => {
                    of_it(&|below| below == "x" && is_field(&one.name) || below.len() > 1)
                        || self.has_group && is_plain
                        || is_plain && self.has_nabla
                        || is_differenced
                }
                // `u_{xx} + u_{yy} = 0`: a field with two variables below it.
                _ => is_twice && (is_plain && is_letter && !is_tensor || FIELDS.contains(&one.name.base.as_str())),
            }
        })
    }

    fn list(&mut self, items: &[Item]) {
        let solid: Vec<&Item> =
            items.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Align)).collect();
        for (at, item) in solid.iter().enumerate() {
            let before = at.checked_sub(1).map(|before| solid[before]);
            self.has_nabla |= is_mark(item, "\\nabla");
            if let Some(found) = names::printed(item, None) {
                let after_delta = before.is_some_and(|before| is_mark(before, "\\Delta"));
                if after_delta {
                    self.differences.push((found.name.clone(), item.span));
                    self.shift(&solid[..at - 1], &found.name);
                    let is_alone = matches!(&solid[..at - 1], [minus] if minus.layout == Layout::Other('-'));
                    let ends = solid.get(at + 1).is_none_or(|next| relation(next).is_some());
                    if is_alone && ends {
                        self.sides.push(found.name.clone());
                    }
                } else if before.is_some_and(|before| is_mark(before, "\\partial")) {
                    self.differentiated.push(found.name.clone());
                } else {
                    self.plain.push(found.name.clone());
                }
                let below = found.name.subscript.concat();
                let are_variables = found.name.subscript.iter().all(|token| VARIABLES.contains(&token.as_str()));
                if !below.is_empty() && are_variables && found.name.primes == 0 {
                    let name = Name { subscript: Vec::new(), ..found.name };
                    self.subscripted.push(Subscripted { name, below, span: item.span });
                }
            }
            self.inside(item);
        }
    }

    /// Notes `x + \Delta x`, at the Δ.
    fn shift(&mut self, before: &[&Item], name: &Name) {
        if let [.., same, sign] = before
            && matches!(sign.layout, Layout::Other('+' | '-'))
            && names::printed(same, None).is_some_and(|found| found.name == *name)
        {
            self.shifted.push(name.clone());
        }
    }

    fn inside(&mut self, item: &Item) {
        match &item.layout {
            Layout::Group(items) | Layout::Fence(_, items) => self.list(items),
            Layout::Fraction(above, below) => {
                let begins = |part: &Item| contents(part).first().is_some_and(|first| is_mark(first, "\\partial"));
                if begins(below) {
                    let names = contents(below).iter().filter_map(|item| names::printed(item, None));
                    self.variables.extend(names.map(|found| found.name));
                } else {
                    self.list(contents(below));
                }
                self.list(contents(above));
            }
            Layout::Scripts { nucleus, sub, sup, .. } => {
                let is_group = matches!(nucleus.layout, Layout::Fence(Delimiter::Round, _));
                let is_variable = sub.as_deref().is_some_and(|sub| {
                    matches!(contents(sub), [Item { layout: Layout::Letter(c), .. }] if VARIABLES.contains(&c.to_string().as_str()))
                });
                self.has_group |= is_group && is_variable;
                self.has_nabla |= is_mark(nucleus, "\\nabla");
                if names::printed(item, None).is_none() {
                    self.inside(nucleus);
                }
                if let Some(sup) = sup {
                    self.list(contents(sup));
                }
            }
            Layout::Root(_, inner) | Layout::Style(_, inner) => self.list(contents(inner)),
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell)),
            _ => {}
        }
    }
}

/// Whether an item is a command, with scripts perhaps: `\partial_t`.
fn is_mark(item: &Item, command: &str) -> bool {
    match &item.layout {
        Layout::Command(name) => name == command,
        Layout::Scripts { nucleus, .. } => matches!(&nucleus.layout, Layout::Command(name) if name == command),
        _ => false,
    }
}
