//! What stands between `\left` and `\right`.

use crate::source::{Fault, Span};

use super::super::lexer::TokenKind;
use super::delimiters::{closing, opening};
use super::item::{Delimiter, Item, Layout};
use super::parser::{Parser, Until, fault, of_fault};

impl Parser<'_> {
    /// What stands between `\left` and `\right`.
    pub(super) fn left(&mut self, span: Span) -> Item {
        let Some(token) = self.next() else {
            return fault(span, "\\left needs a bracket or a point after it, as in \\left( or \\left.");
        };
        let opening = opening(token);
        let outer = std::mem::replace(&mut self.angles, usize::from(opening == Some(Delimiter::Angle)));
        let items = self.list(Until::Right);
        self.angles = outer;
        match self.peek() {
            Some(right) if right.kind == TokenKind::Command("\\right".into()) => self.next(),
            _ => return self.unclosed(span, "\\left", items),
        };
        let Some(close) = self.next() else {
            return fault(span, "\\right needs a bracket or a point after it, as in \\right) or \\right.");
        };
        let whole = span.to(close.span);
        // A brace before rows alone is `cases`.
        if let (Some(Delimiter::Curly), TokenKind::Other('.')) = (opening, &close.kind)
            && let [only] = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect::<Vec<_>>()[..]
            && let Layout::Environment(_, rows) = &only.layout
        {
            return Item {
                layout: Layout::Environment("cases".to_owned(), Item::inner_rows(rows).to_vec()),
                span: whole,
            };
        }
        let closing = match close.kind {
            TokenKind::Other('>') => Some(Delimiter::Angle),
            _ => closing(close),
        };
        match (opening, closing) {
            (Some(a), Some(b)) if a == b => Item { layout: Layout::Fence(a, items), span: whole },
            (Some(Delimiter::Bar), Some(Delimiter::Angle)) => {
                Item { layout: Layout::Fence(Delimiter::Ket, items), span: whole }
            }
            (Some(Delimiter::Angle), Some(Delimiter::Bar)) => {
                Item { layout: Layout::Fence(Delimiter::Bra, items), span: whole }
            }
            (Some(Delimiter::Round), Some(Delimiter::Square)) => {
                Item { layout: Layout::Fence(Delimiter::LeftOpen, items), span: whole }
            }
            (Some(Delimiter::Square), Some(Delimiter::Round)) => {
                Item { layout: Layout::Fence(Delimiter::RightOpen, items), span: whole }
            }
            (None, Some(Delimiter::Bar)) if token.kind == TokenKind::Other('.') => {
                Item { layout: Layout::Fence(Delimiter::Evaluation, items), span: whole }
            }
            // A brace before equations, which stand in it without rows: `\left\{ \dot x = y, \quad \dot y = -x \right.`
            (Some(Delimiter::Curly), None)
                if close.kind == TokenKind::Other('.')
                    && items.iter().any(|item| item.layout == Layout::Other('=')) =>
            {
                Item { layout: Layout::Group(items), span: whole }
            }
            _ => of_fault(
                Fault::unsupported(whole, "\\left and \\right with these two brackets are not supported")
                    .help("write brackets of one kind, as in \\left( and \\right)"),
            ),
        }
    }
}
