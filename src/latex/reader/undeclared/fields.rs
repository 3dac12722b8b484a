//! `\nabla` before a field: gradient, divergence, curl, Laplacian.

use crate::formula::symbols::Operator;
use crate::formula::tree::Expr;
use crate::source::Fault;

use super::super::super::layout::{Item, Layout, contents};
use super::super::super::names;
use super::super::items::{Joint, joint, whole_number};
use super::super::state::{Read, Reader};
use super::super::vector_names::is_vectorial;

impl Reader<'_> {
    /// ∇ with what it acts on, at the ∇; `None` if there is none here.
    pub(in super::super) fn nabla(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let is_nabla = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\nabla");
        let is_nabla = |item: &Item| match &item.layout {
            Layout::Style(_, inner) | Layout::Accent(_, inner) => {
                matches!(contents(inner), [only] if is_nabla(only))
            }
            _ => is_nabla(item),
        };
        let squared = match &item.layout {
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } if is_nabla(nucleus) => {
                if whole_number(sup) != Some(2) {
                    return Err(Fault::unsupported(item.span, "only the first and second power of ∇ are supported")
                        .help("write a higher power as a power of the Laplacian, as in \\nabla^2 \\nabla^2"));
                }
                true
            }
            _ if is_nabla(item) => false,
            _ => return Ok(None),
        };
        *cursor += 1;
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(_))) {
            *cursor += 1;
        }
        let (name, operator) = match items.get(*cursor).and_then(joint) {
            Some(Joint::CDot) if !squared => ("\\nabla\\cdot", Operator::ToNumber),
            Some(Joint::Times) if !squared => ("\\nabla\\times", Operator::Same),
            _ if squared => ("\\nabla^{2}", Operator::Same),
            _ => ("\\nabla", Operator::ToVector),
        };
        if matches!(name, "\\nabla\\cdot" | "\\nabla\\times") {
            *cursor += 1;
        }
        let inner = match self.length_of_a_flux(&items[*cursor..]).filter(|_| name != "\\nabla" && !squared) {
            Some(length) => {
                let flux = &items[*cursor..*cursor + length];
                *cursor += length;
                self.term(flux)?
            }
            None => self.acted_on(item.span, items, cursor)?,
        };
        let is_vector = self.shape_of(&inner)? == crate::formula::shape::Shape::Vector;
        let needs_vector = matches!(name, "\\nabla\\cdot" | "\\nabla\\times");
        if needs_vector != is_vector && name != "\\nabla^{2}" {
            let wanted = if needs_vector { "a vector" } else { "a number" };
            return Err(Fault::shape(
                item.span.to(inner.span),
                format!("this operator with ∇ needs {wanted} after it"),
            )
            .help("mark vectors with \\vec or \\mathbf"));
        }
        let span = item.span.to(inner.span);
        Ok(Some(self.operate(name, operator, vec![inner], span)))
    }

    /// The length of numbers before a vector at the end of a term, `\rho\mathbf u`: a number alone has no divergence.
    fn length_of_a_flux(&self, items: &[Item]) -> Option<usize> {
        let solid: Vec<&Item> = items.iter().take_while(|item| !matches!(item.layout, Layout::Space(_))).collect();
        let is_end = items[solid.len()..].iter().all(|item| matches!(item.layout, Layout::Space(_)));
        let (last, factors) = solid.split_last()?;
        let name = |item: &Item| {
            let found = names::printed(item, self.branch)?;
            (found.sup.is_none() && found.dots == 0).then_some(found.name)
        };
        let is_vector = |item: &Item| name(item).is_some_and(|name| is_vectorial(&name.base));
        let is_number = |item: &&Item| {
            name(item).is_some_and(|name| {
                !is_vectorial(&name.base)
                    && name.base != "\\nabla"
                    && !self.symbols.inferred.matrices.contains(&name.base)
            })
        };
        (is_end && !factors.is_empty() && is_vector(last) && factors.iter().all(is_number)).then_some(solid.len())
    }
}
