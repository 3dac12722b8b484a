//! Brackets of two: the commutator of matrices. Other pairs in brackets have no meaning yet.

use crate::formula::shape::Shape;
use crate::formula::tree::{Expr, Node};
use crate::source::Fault;

use super::super::super::layout::{Delimiter, Item, Layout, typed};
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// `[A, B]`
    pub(super) fn bracket(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let Layout::Fence(delimiter @ (Delimiter::Square | Delimiter::Curly), inside) = &item.layout else {
            return Ok(None);
        };
        let parts: Vec<&[Item]> = inside.split(|item| item.layout == Layout::Other(',')).collect();
        let [first, second] = parts.as_slice() else { return Ok(None) };
        if *delimiter == Delimiter::Curly || self.is_abstract() {
            return Ok(None);
        }
        let (a, b) = (self.sum(first, item.span)?, self.sum(second, item.span)?);
        let is_matrix = |shape: Shape| matches!(shape, Shape::Matrix(..));
        if !is_matrix(self.shape_of(&a)?) || !is_matrix(self.shape_of(&b)?) {
            return Err(Fault::unsupported(
                item.span,
                format!(
                    "[{}, {}] may be a commutator of operators, an interval or a list",
                    typed(first).trim(),
                    typed(second).trim()
                ),
            )
            .help("for a commutator, write both matrices out, or declare them in the claims file, as in \"A\": \"3x3 matrix\""));
        }
        *cursor += 1;
        Ok(Some(Expr::new(Node::Commutator(Box::new(a), Box::new(b)), item.span)))
    }
}
