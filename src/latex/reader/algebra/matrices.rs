//! Determinants, traces, diagonal and unit matrices, entries, and what stands above a matrix.

use crate::formula::shape::Shape;
use crate::formula::symbols::{Kind, Name};
use crate::formula::tree::{Expr, Index, MatrixFunction, Node};
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names::{self, Printed};
use super::super::super::rows::relation;
use super::super::items::{function_head, is_minus_one, is_transpose, whole_number};
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// `\det A`, `\operatorname{tr}(AB)`, `\operatorname{diag}(a, b)`.
    pub(super) fn of_matrix(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let head = &items[*cursor];
        let Some(word) = operator_word(head) else { return Ok(None) };
        let function = match word.as_str() {
            "det" => MatrixFunction::Determinant,
            "tr" | "Tr" | "trace" => MatrixFunction::Trace,
            "diag" => return self.diagonal(items, cursor).map(Some),
            _ => return Ok(None),
        };
        let mut at = *cursor + 1;
        let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
        while items.get(at).is_some_and(is_space) {
            at += 1;
        }
        let Some(argument) = items.get(at) else {
            return Err(Fault::new(head.span, format!("the matrix after {} is missing", function.name()))
                .help("write the matrix, or a name that is declared as a matrix"));
        };
        // `\operatorname{Tr}\ln D`
        if matches!(function_head(argument), Ok(Some(_))) {
            let name = function.name();
            return Err(Fault::ambiguous(
                head.span.to(argument.span),
                format!("the argument of {name} may end with that of the function, or later"),
            )
            .help(format!("put the argument of {name} in parentheses")));
        }
        // `\det J(t)`
        if matches!(items.get(at + 1).map(|next| &next.layout), Some(Layout::Fence(Delimiter::Round, _)))
            && names::printed(argument, self.branch).is_some()
        {
            if !self.is_abstract() {
                let span = head.span.to(items[at + 1].span);
                return Err(Fault::ambiguous(
                    span,
                    format!("{0} A(…) may be {0} of A(…) or a product", function.name()),
                )
                .help("put the argument in parentheses"));
            }
            let mut end = at;
            let (inner, _) = self.factor(items, &mut end)?;
            *cursor = end;
            let span = head.span.to(inner.span);
            return Ok(Some(Expr::new(Node::OfMatrix(function, Box::new(inner)), span)));
        }
        let inner = self.item(argument)?;
        let span = head.span.to(argument.span);
        let shape = self.shape_of(&inner)?;
        if !matches!(shape, Shape::Matrix(..)) && !self.is_abstract() {
            let message = format!("{} needs a square matrix", function.name());
            return Err(Fault::shape(argument.span, message)
                .help("write the matrix out, or declare it in the claims file, as in \"A\": \"3x3 matrix\""));
        }
        let is_enclosed = matches!(argument.layout, Layout::Fence(..) | Layout::Environment(..));
        let next = items[at + 1..].iter().find(|item| !is_space(item));
        let touches = items.get(at + 1).is_some_and(|item| !is_space(item));
        if let (false, true, Some(next)) = (is_enclosed, touches, next)
            && (names::printed(next, self.branch).is_some() || matches!(next.layout, Layout::Environment(..)))
        {
            let name = function.name();
            return Err(Fault::ambiguous(span.to(next.span), format!("{name} A B may be {name}(A)·B or {name}(A·B)"))
                .help("put the argument in parentheses"));
        }
        *cursor = at + 1;
        Ok(Some(Expr::new(Node::OfMatrix(function, Box::new(inner)), span)))
    }

    fn diagonal(&mut self, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let head = items[*cursor].span;
        let Some(Item { layout: Layout::Fence(Delimiter::Round | Delimiter::Square, inside), span: fence }) =
            items.get(*cursor + 1)
        else {
            return Err(Fault::new(head, "diag needs its entries in parentheses")
                .help("write, for example, \\operatorname{diag}(a, b, c)"));
        };
        *cursor += 2;
        let span = head.to(*fence);
        let parts: Vec<&[Item]> = inside.split(|item| item.layout == Layout::Other(',')).collect();
        let mut entries = Vec::new();
        for part in &parts {
            entries.push(self.sum(part, *fence)?);
        }
        let zero = || Expr::integer(0, span);
        let row = |at: usize, entry: &Expr| {
            (0..entries.len()).map(|column| if column == at { entry.clone() } else { zero() }).collect()
        };
        Ok(Expr::new(Node::Matrix(entries.iter().enumerate().map(|(at, entry)| row(at, entry)).collect()), span))
    }

    /// What stands above a matrix or a column: a transpose, an inverse, a whole power.
    pub(in super::super) fn above_a_matrix(&self, base: &Expr, shape: Shape, sup: &Item, span: Span) -> Option<Expr> {
        let boxed = || Box::new(base.clone());
        let node = match shape {
            // Without declarations a matrix may be complex, and only its transpose is known.
            Shape::Matrix(..) if is_transpose(sup) || !self.symbols.open && is_dagger(sup) => Node::Transpose(boxed()),
            Shape::Vector if is_transpose(sup) => Node::Transpose(boxed()),
            Shape::Matrix(..) if is_minus_one(sup) => Node::Inverse(boxed()),
            Shape::Matrix(rows, columns) if rows == columns && whole_number(sup).is_some_and(|n| n > 0) => {
                Node::Power(boxed(), Box::new(Expr::integer(whole_number(sup)?, sup.span)))
            }
            _ => return None,
        };
        Some(Expr::new(node, span))
    }

    /// A name that is not declared, and stands for a unit matrix or for an entry of a declared one.
    pub(in super::super) fn of_declared_matrix(&self, name: &Name, span: Span) -> Option<Expr> {
        if name.primes > 0 {
            return None;
        }
        let is_matrix = |kind: Kind| matches!(kind, Kind::Matrix(..));
        if name.subscript.is_empty() {
            let is_unit =
                ["I", "\\mathbf{I}", "\\mathbb{I}", "\\mathrm{I}", "\\mathbb{E}"].contains(&name.base.as_str());
            let beside = self.symbols.iter().any(|(_, entry)| is_matrix(entry.kind));
            return (is_unit && beside).then(|| Expr::new(Node::Identity, span));
        }
        let index = |token: &String| match self.symbols.index(token) {
            Some(letter) => (!self.symbols.indices[letter.0].labels).then_some(Index::Letter(letter)),
            None => token.parse().ok().filter(|n| (1..=9).contains(n)).map(Index::Fixed),
        };
        let (id, _) = self.symbols.find(&Name::plain(name.base.clone()))?;
        let Kind::Matrix(rows, columns) = self.symbols.entry(id).kind else { return None };
        let tokens: Vec<&String> = name.subscript.iter().filter(|token| *token != ",").collect();
        let indices: Vec<Index> = tokens.into_iter().map(index).collect::<Option<_>>()?;
        let [row, column] = indices.as_slice() else { return None };
        let fits = |index: &Index, count: u8| match index {
            Index::Fixed(value) => count == 0 || *value <= count,
            Index::Letter(letter) => self.symbols.indices[letter.0].upper == count,
        };
        if !fits(row, rows) || !fits(column, columns) {
            return None;
        }
        let whole = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, span);
        Some(Expr::new(Node::Entry(Box::new(whole), *row, *column), span))
    }
}

/// The word of an upright operator or command: `det` of `\det`, `tr` of `\operatorname{tr}`.
pub(in super::super) fn operator_word(item: &Item) -> Option<String> {
    match &item.layout {
        Layout::Command(name) => name.strip_prefix('\\').map(str::to_owned),
        Layout::Style(style, inner) if style == "\\mathrm" => {
            let letter = |item: &Item| match item.layout {
                Layout::Letter(c) => Some(c),
                _ => None,
            };
            contents(inner).iter().map(letter).collect()
        }
        _ => None,
    }
}

/// `†`, as the mark of the adjoint.
pub(super) fn is_dagger(item: &Item) -> bool {
    match contents(item) {
        [Item { layout: Layout::Command(name), .. }] => name == "\\dagger",
        [Item { layout: Layout::Other('†'), .. }] => true,
        _ => false,
    }
}

/// The name that an item is, without a prime.
pub(super) fn name_of(item: &Item) -> Option<Printed<'_>> {
    names::printed(item, None).filter(|printed| printed.name.primes == 0)
}

/// Whether a name is in bold.
pub(super) fn is_bold(name: &Name) -> bool {
    name.base.starts_with("\\mathbf{")
}

/// Whether an item ends a statement or a side.
pub(super) fn is_break(item: &Item) -> bool {
    matches!(item.layout, Layout::Other(',' | ';' | '.') | Layout::Text(_) | Layout::Row | Layout::Align)
        || relation(item).is_some()
}

/// Whether an environment is a matrix.
pub fn is_matrix(name: &str) -> bool {
    matches!(name, "pmatrix" | "bmatrix" | "matrix" | "array" | "smallmatrix" | "Bmatrix")
}
