//! Sums, products, limits and ellipses without declared indices: `\sum_{n=0}^{\infty}`, `\prod_i`, `\lim_{x \to 0}`.

use crate::formula::symbols::Operator;
use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout};
use super::super::super::names;
use super::super::items::{contents, extent};
use super::super::state::{Read, Reader};
use super::super::structure::printed;
use super::simple_text;

impl Reader<'_> {
    /// A sum, a product or a limit of the rest of the term.
    pub(in super::super) fn unevaluated(&mut self, sign: &Item, rest: &[Item]) -> Read<Expr> {
        let (command, below, above) = match &sign.layout {
            Layout::Scripts { nucleus, sub, sup, primes: 0 } => match &nucleus.layout {
                Layout::Command(name) => (name.clone(), sub.as_deref(), sup.as_deref()),
                _ => return Err(refused(sign.span)),
            },
            Layout::Command(name) => (name.clone(), None, None),
            _ => return Err(refused(sign.span)),
        };
        if rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            if self.is_abstract() {
                return Ok(self.label(std::slice::from_ref(sign), sign.span));
            }
            return Err(Fault::new(sign.span, format!("no formula follows this {command}")));
        }
        let mut name = command;
        let mut bound = Vec::new();
        for (mark, part) in [("_", below), ("^", above)] {
            let Some(part) = part else { continue };
            let text = match simple_text(contents(part)) {
                Some(text) => text,
                None if self.is_abstract() => printed(contents(part)),
                None => return Err(refused(part.span)),
            };
            name.push_str(&format!("{mark}{{{text}}}"));
            if mark == "_" {
                let letters = contents(part).iter().filter_map(|item| names::printed(item, None));
                bound.extend(letters.map(|found| found.name.to_string()));
            }
        }
        let outer = self.bound.len();
        self.bound.extend(bound);
        let body = self.term(rest);
        self.bound.truncate(outer);
        let span = extent(rest).map_or(sign.span, |rest| sign.span.to(rest));
        Ok(self.operate(&name, Operator::Same, vec![body?], span))
    }

    /// `\dots` as a term or a factor of its own.
    pub(in super::super) fn ellipsis(&mut self, span: Span) -> Expr {
        self.operate("\\dots", Operator::Function, Vec::new(), span)
    }
}

fn refused(span: Span) -> Fault {
    Fault::unsupported(span, "these limits are not supported")
        .help("write \\sum_{i=1}^{n}, with names and numbers only")
}
