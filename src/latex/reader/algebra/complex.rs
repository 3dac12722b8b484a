//! The imaginary unit, real and imaginary parts, and conjugates.
//!
//! i is √−1 where it is declared, or where the display leaves no doubt ([`super::evidence`]) and i is not declared as
//! something else; so is j. A star above a number, and a bar over it, are the conjugate where the number is complex.

use crate::formula::shape::Shape;
use crate::formula::symbols::{Kind, Name};
use crate::formula::tree::{ComplexPart, Expr, Node};
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents};
use super::super::state::{Read, Reader};
use super::matrices::{is_dagger, operator_word};

impl Reader<'_> {
    /// `\Re z`, `\operatorname{Im}(…)`.
    pub(super) fn complex_part(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let head = &items[*cursor];
        let part = match operator_word(head).as_deref() {
            Some("Re" | "real") => ComplexPart::Real,
            Some("Im" | "imag") => ComplexPart::Imaginary,
            _ => return Ok(None),
        };
        let mut at = *cursor + 1;
        let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
        while items.get(at).is_some_and(is_space) {
            at += 1;
        }
        // `Re/7` is the number of Reynolds.
        let is_divided = |item: &&Item| item.layout != Layout::Other('/');
        let Some(argument) = items.get(at).filter(is_divided) else { return Ok(None) };
        let is_enclosed = matches!(argument.layout, Layout::Fence(..));
        let rest = items[at + 1..].iter().filter(|item| !is_space(item)).count();
        if !is_enclosed && (rest > 0 || head.layout != Layout::Command(format!("\\{}", part.name()))) {
            return Err(Fault::ambiguous(
                head.span.to(argument.span),
                format!("{} may be a part of a complex number or a name", part.name()),
            )
            .help("for the part, put the number in parentheses; for a name, use a letter with a subscript"));
        }
        let inner = self.item(argument)?;
        // Without declarations, only a complex number is said to have parts.
        if let (true, Some(id)) = (self.symbols.open, inner.as_plain_symbol())
            && self.symbols.entry(id).kind == Kind::Scalar
        {
            self.symbols.entry_mut(id).kind = Kind::Complex;
        }
        *cursor = at + 1;
        Ok(Some(Expr::new(Node::Complex(part, Box::new(inner)), head.span.to(argument.span))))
    }

    /// Whether a name is √−1.
    pub(in super::super) fn is_imaginary_unit(&self, name: &Name) -> bool {
        let is_bare = name.subscript.is_empty() && name.primes == 0;
        let is_declared = self.symbols.imaginary.contains(name);
        let is_usual = ["i", "\\imath", "\\mathrm{i}", "\\mathrm{j}"].contains(&name.base.as_str());
        let is_factor =
            self.symbols.is_abstract() && self.symbols.inferred.imaginary_factor && !self.bound.contains(&name.base);
        if is_bare && is_usual && is_factor {
            return true;
        }
        let is_engineering = name.base == "j" && self.symbols.imaginary_j_here && !self.bound.contains(&name.base);
        if is_bare && is_engineering && self.symbols.find(name).is_none() {
            return true;
        }
        is_bare
            && (is_declared
                || is_usual
                    && (self.symbols.imaginary_here || self.symbols.inferred.has_states)
                    && self.symbols.find(name).is_none())
    }

    /// `z^*` of a complex number.
    pub(in super::super) fn conjugate(&self, base: &Expr, shape: Shape, sup: &Item, span: Span) -> Option<Expr> {
        let is_star = match contents(sup) {
            [Item { layout: Layout::Other('*'), .. }] => true,
            [Item { layout: Layout::Command(name), .. }] => ["\\ast", "\\star"].contains(&name.as_str()),
            _ => is_dagger(sup),
        };
        (is_star && shape == Shape::Complex)
            .then(|| Expr::new(Node::Complex(ComplexPart::Conjugate, Box::new(base.clone())), span))
    }

    /// `\bar z` where z is complex and \bar z has no meaning of its own.
    pub(in super::super) fn conjugate_by_a_bar(&self, name: &Name, dots: u8, span: Span) -> Option<Expr> {
        let inner = name.base.strip_prefix("\\bar{")?.strip_suffix('}')?;
        let (id, indices) = self.symbols.find(&Name { base: inner.to_owned(), ..name.clone() })?;
        let symbol = Expr::new(Node::Symbol { id, indices, dots }, span);
        (self.symbols.entry(id).kind == Kind::Complex)
            .then(|| Expr::new(Node::Complex(ComplexPart::Conjugate, Box::new(symbol)), span))
    }
}
