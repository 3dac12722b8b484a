//! States and mean values, `|a\rangle`, `\langle a|H|b\rangle`, `\langle x^2\rangle`; pairs in brackets, `[A, B]`, `\{f, g\}`;
//! tuples, intervals and sets.

use crate::formula::tree::{Expr, Sign};
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::state::{Read, Reader};
use super::printed;

impl Reader<'_> {
    /// A pair of delimiters around what has no value; `None` for plain parentheses.
    pub(super) fn bracketed(&mut self, item: &Item) -> Read<Option<Expr>> {
        let Layout::Fence(delimiter, inside) = &item.layout else { return Ok(None) };
        let span = item.span;
        let commas = inside.iter().filter(|item| is_separator(item)).count();
        if *delimiter == Delimiter::Square && are_indices(inside) {
            return Err(Fault::ambiguous(
                span,
                "[\\kappa\\mu, \\nu] may be a Christoffel symbol, or a commutator with the product of \\kappa and \\mu",
            )
            .help("write \\Gamma_{\\kappa\\mu\\nu} for the symbol, and \\cdot in the product"));
        }
        Ok(Some(match delimiter {
            Delimiter::Ket => self.template(&format!("|{}\\rangle", self.by_sign(inside)), Vec::new(), span),
            Delimiter::Bra => self.template(&format!("\\langle {}|", self.by_sign(inside)), Vec::new(), span),
            Delimiter::Angle => self.angle(inside, item)?,
            Delimiter::RightOpen | Delimiter::LeftOpen if commas == 1 => {
                let template = if *delimiter == Delimiter::RightOpen { "[#, #)" } else { "(#, #]" };
                let parts = self.listed(inside, item)?;
                self.template(template, parts, span)
            }
            // `\{x \mid x > 0\}`
            Delimiter::Curly if inside.iter().any(|item| is_bar(item) || relation(item).is_some()) => {
                self.template(&format!("\\{{{}\\}}", printed(inside)), Vec::new(), span)
            }
            Delimiter::Round | Delimiter::Square | Delimiter::Curly if commas > 0 => {
                let (open, close) = match delimiter {
                    Delimiter::Round => ("(", ")"),
                    Delimiter::Square => ("[", "]"),
                    _ => ("\\{", "\\}"),
                };
                let parts = self.listed(inside, item)?;
                let holes = vec!["#"; parts.len()].join(", ");
                self.template(&format!("{open}{holes}{close}"), parts, span)
            }
            _ => return Ok(None),
        }))
    }

    /// A name in square brackets that is a whole side, `[\rho] = \mathrm{kg}`: its unit. `None` for anything else.
    pub(in super::super) fn unit_of(&mut self, items: &[Item]) -> Read<Option<Expr>> {
        let [Item { layout: Layout::Fence(Delimiter::Square, inside), span }] = items else { return Ok(None) };
        // `[\vec\sigma \cdot \vec n]`: a jump. A sum in brackets is a plain parenthesis, and a pair a commutator.
        let divides = |item: &Item| is_separator(item) || matches!(item.layout, Layout::Other('+' | '-'));
        let is_one = matches!(inside.as_slice(), [name] if names::printed(name, None).is_some());
        let is_product = inside.len() > 1 && !inside.iter().any(divides) && inside.iter().any(is_vector_product);
        if !is_one && !is_product {
            return Ok(None);
        }
        let inner = self.sum(inside, *span)?;
        Ok(Some(self.template("[#]", vec![inner], *span)))
    }

    /// A name or a state alone in square or curly brackets, which are shown: `[A]`, `\{x_i\}`.
    pub(in super::super) fn shown_in_brackets(&mut self, delimiter: Delimiter, only: &Item, span: Span) -> Read<Expr> {
        let template = if delimiter == Delimiter::Square { "[#]" } else { "\\{#\\}" };
        let inner = self.item(only)?;
        Ok(self.template(template, vec![inner], span))
    }

    /// A mean value, or a product of states with what stands between them.
    fn angle(&mut self, inside: &[Item], item: &Item) -> Read<Expr> {
        let parts: Vec<&[Item]> = inside.split(is_bar).collect();
        match parts.as_slice() {
            [only] => {
                if only.iter().any(is_separator) {
                    let parts = self.listed(only, item)?;
                    let holes = vec!["#"; parts.len()].join(", ");
                    return Ok(self.template(&format!("\\langle {holes}\\rangle"), parts, item.span));
                }
                let inner = self.sum(only, item.span)?;
                Ok(self.template("\\langle #\\rangle", vec![inner], item.span))
            }
            [bra, ket] => Ok(self.template(
                &format!("\\langle {}|{}\\rangle", self.by_sign(bra), self.by_sign(ket)),
                Vec::new(),
                item.span,
            )),
            [bra, operator, ket] => {
                let inner = self.sum(operator, item.span)?;
                let template = format!("\\langle {}|#|{}\\rangle", self.by_sign(bra), self.by_sign(ket));
                Ok(self.template(&template, vec![inner], item.span))
            }
            _ => Err(Fault::unsupported(item.span, "angle brackets with more than two bars are not supported")
                .help("write each product of states in brackets of its own")),
        }
    }

    /// The text of a label, where ± is the sign of the statement that is being read.
    pub(super) fn by_sign(&self, items: &[Item]) -> String {
        let text = printed(items);
        match self.branch {
            None => text,
            Some(Sign::Plus) => text.replace("\\pm", "+").replace("\\mp", "-"),
            Some(Sign::Minus) => text.replace("\\pm", "-").replace("\\mp", "+"),
        }
    }

    /// The formulas between commas.
    fn listed(&mut self, inside: &[Item], item: &Item) -> Read<Vec<Expr>> {
        inside.split(is_separator).map(|part| self.sum(part, item.span)).collect()
    }
}

/// Whether an item is a name without a power, or a state.
pub(in super::super) fn is_alone_in_brackets(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| found.sup.is_none())
        || matches!(item.layout, Layout::Fence(Delimiter::Ket, _))
}

/// A sign of a product of vectors.
fn is_vector_product(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name) if name == "\\cdot" || name == "\\times")
}

fn is_separator(item: &Item) -> bool {
    matches!(item.layout, Layout::Other(',' | ';'))
}

fn is_bar(item: &Item) -> bool {
    match &item.layout {
        Layout::Other('|') => true,
        Layout::Command(name) => name == "\\mid",
        _ => false,
    }
}

/// Whether two usual indices stand side by side before a comma and a third after it: `[\mu\nu, \kappa]`.
fn are_indices(inside: &[Item]) -> bool {
    const INDICES: [&str; 14] =
        ["i", "j", "k", "l", "m", "n", "\\mu", "\\nu", "\\kappa", "\\lambda", "\\rho", "\\sigma", "\\iota", "\\alpha"];
    let is_index = |item: &Item| {
        names::printed(item, None).is_some_and(|found| {
            found.sup.is_none() && found.name.subscript.is_empty() && INDICES.contains(&found.name.base.as_str())
        })
    };
    let solid: Vec<&Item> = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    matches!(solid.as_slice(), [a, b, comma, c] if is_separator(comma) && [a, b, c].iter().all(|item| is_index(item)))
}
