//! The type check of formulas: scalar, vector or matrix, and the free indices.
//!
//! [`bind`] makes every implied sum explicit: an index that a product repeats is summed over. It rejects a vector
//! added to a scalar, terms with different free indices, and two vectors side by side. It runs before any number is
//! computed.
//!
//! # How indices work
//!
//! A subscript of declared letters makes a name a family. `bind` finds the free indices of every product. A
//! component index that occurs twice in a product is summed over, and the sum is written into the tree. Two terms
//! with different free indices are rejected. A link with free indices is tested for all their values. Shapes are
//! settled before any number is computed, so a vector equated to a number is `unreadable` with its place. A letter
//! inside of a word of a subscript is not an index: `r_{cm}` has none, also if c is declared.
//!
//! Labels are never summed by repetition. Components are summed because a vector is meant; particles are not. p_i =
//! m_i v_i is one equation for each i, and notes that mean a sum over particles print Σ.

use crate::source::{Fault, Span};

pub use super::operator_shapes::of_sum;
use super::symbols::Symbols;
use super::tree::{Expr, Index, IndexId, Node};

/// The shape of a formula's value, for each value of its free indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A number.
    Scalar,
    /// A vector in three dimensions.
    Vector,
    /// A matrix: its number of rows and of columns; a square matrix of an unknown size has 0 of both.
    Matrix(usize, usize),
    /// A complex number.
    Complex,
    /// What has no value here: an operator, a tensor, a state. See [`Symbols::may_be_abstract`].
    Abstract,
}

impl Shape {
    /// Whether it is a real or a complex number.
    pub fn is_number(self) -> bool {
        matches!(self, Shape::Scalar | Shape::Complex)
    }

    pub(super) fn noun(self) -> String {
        match self {
            Shape::Complex => "a complex number".to_owned(),
            Shape::Abstract => "a quantity that cannot be evaluated".to_owned(),
            Shape::Matrix(0, 0) => "a matrix".to_owned(),
            Shape::Scalar => "a scalar".to_owned(),
            Shape::Vector => "a vector".to_owned(),
            Shape::Matrix(rows, columns) => format!("a {rows}×{columns} matrix"),
        }
    }
}

/// The type of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Type {
    /// Scalar, vector or matrix.
    pub shape: Shape,
    /// The free indices, in order.
    pub free: Vec<IndexId>,
}

/// Determines the type of a formula and makes its implied sums explicit.
///
/// # Errors
/// Shapes that cannot be combined ([`Code::ShapeMismatch`](crate::code::Code::ShapeMismatch)) and indices that do not
/// match ([`Code::IndexMismatch`](crate::code::Code::IndexMismatch)), each at its term.
pub fn bind(expr: Expr, symbols: &Symbols) -> Result<(Expr, Type), Fault> {
    let mut expr = expr;
    let found = Binder { symbols, summed: Vec::new() }.bind(&mut expr)?;
    Ok((expr, found))
}

/// The shape of a formula that may contain implied sums.
///
/// # Errors
/// As [`bind`], except for free indices that differ.
pub fn shape_of(expr: &Expr, symbols: &Symbols) -> Result<Shape, Fault> {
    let mut copy = expr.clone();
    Binder { symbols, summed: Vec::new() }.shape(&mut copy)
}

/// Checks that two members of an equation have the same type. The literal 0 is a zero of any shape, and the literal 1
/// is any unit matrix.
///
/// # Errors
/// Different shapes, or different free indices.
pub fn comparable(a: (&Expr, &Type), b: (&Expr, &Type), symbols: &Symbols) -> Result<(), Fault> {
    for ((literal, _), (_, found)) in [(a, b), (b, a)] {
        let unit = matches!(&literal.node, Node::Number(text) if text == "1");
        if literal.is_zero() || unit && matches!(found.shape, Shape::Matrix(n, m) if n == m) {
            return Ok(());
        }
    }
    let span = a.0.span.to(b.0.span);
    if of_sum(a.1.shape, b.1.shape).is_none() && !symbols.is_abstract() {
        let message = format!("the left side is {}, and the right side is {}", a.1.shape.noun(), b.1.shape.noun());
        let fault = Fault::shape(span, message);
        return Err(match as_the_other_side(a.1.shape, b.1.shape) {
            Some(help) => fault.help(help),
            None => fault,
        });
    }
    let lacks = |one: &Type, other: &Type| one.free.iter().any(|letter| !other.free.contains(letter));
    let strangers = lacks(a.1, b.1) && lacks(b.1, a.1);
    if strangers || components(&a.1.free, symbols) != components(&b.1.free, symbols) {
        let [left, right] = [a.1, b.1].map(|found| indices(&found.free, symbols));
        let message = format!("the left side has {left}, and the right side has {right}");
        return Err(Fault::index(span, message).help("write the same free indices on both sides"));
    }
    Ok(())
}

/// How to write one side of an equation so that it has the shape of the other side.
fn as_the_other_side(left: Shape, right: Shape) -> Option<String> {
    let (side, wanted) = match (left, right) {
        (Shape::Scalar, _) | (Shape::Vector, Shape::Matrix(..)) => ("left", right),
        _ => ("right", left),
    };
    match (left, right, wanted) {
        (Shape::Matrix(..), Shape::Matrix(..), _) => Some("write matrices of one size on both sides".to_owned()),
        (_, _, Shape::Vector) => {
            Some(format!("if the {side} side is a vector too, mark its name with \\vec or \\mathbf"))
        }
        (_, _, Shape::Matrix(rows @ 1.., columns)) => Some(format!(
            "if the {side} side is a matrix too, declare its name in a claims file, as in \"M\": \
             \"{rows}x{columns} matrix\""
        )),
        _ => None,
    }
}

/// The entries of a matrix that is compared with a formula of two free component indices, as in `R_{ab} = (…)`. The
/// indices are in the order in which the other side prints them.
pub fn entries_of(matrix: (&Expr, &Type), other: (&Expr, &Type), symbols: &Symbols) -> Option<(Expr, Type)> {
    let free = components(&other.1.free, symbols);
    let (Shape::Matrix(3, 3), Shape::Scalar, [_, _]) = (matrix.1.shape, other.1.shape, free.as_slice()) else {
        return None;
    };
    if !components(&matrix.1.free, symbols).is_empty() {
        return None;
    }
    let mut printed: Vec<IndexId> = Vec::new();
    let mut note = |indices: &[Index]| {
        for index in indices {
            if let Index::Letter(letter) = index
                && free.contains(letter)
                && !printed.contains(letter)
            {
                printed.push(*letter);
            }
        }
    };
    other.0.walk(&mut |expr| match &expr.node {
        Node::Symbol { indices, .. } => note(indices),
        Node::Entry(_, a, b) => note(&[*a, *b]),
        Node::Component(_, a) => note(&[*a]),
        Node::Delta(indices) => note(indices),
        Node::Epsilon(indices) => note(indices),
        _ => {}
    });
    let [row, column] = printed.as_slice() else { return None };
    let span = matrix.0.span;
    let node = Node::Entry(Box::new(matrix.0.clone()), Index::Letter(*row), Index::Letter(*column));
    let free = union(&matrix.1.free, &free);
    Some((Expr::new(node, span), Type { shape: Shape::Scalar, free }))
}

pub(super) struct Binder<'a> {
    pub(super) symbols: &'a Symbols,
    /// The indices of the enclosing Σ.
    summed: Vec<IndexId>,
}

impl Binder<'_> {
    fn shape(&mut self, expr: &mut Expr) -> Result<Shape, Fault> {
        self.bind(expr).map(|found| found.shape)
    }

    /// The free labels of a scalar, which may have no other free index.
    pub(super) fn scalar(&mut self, expr: &mut Expr, what: &str) -> Result<Vec<IndexId>, Fault> {
        let found = self.bind(expr)?;
        self.scalar_labels(found, expr.span, what)
    }

    /// The free labels of what must be a scalar without other free indices.
    pub(super) fn scalar_labels(&self, found: Type, span: Span, what: &str) -> Result<Vec<IndexId>, Fault> {
        if found.shape != Shape::Scalar && !self.symbols.is_abstract() {
            let fault = Fault::shape(span, format!("{what} must be a scalar, but this is {}", found.shape.noun()));
            return Err(match found.shape {
                Shape::Complex => {
                    Fault { message: format!("{what} must be a real number, but this is complex"), ..fault }
                        .help("write an equation for the real part and one for the imaginary part")
                }
                Shape::Vector => fault.help("write a component or the norm of the vector"),
                Shape::Matrix(..) => fault.help("write one entry of the matrix"),
                _ => fault,
            });
        }
        if found.free.iter().any(|letter| !self.is_label(*letter)) {
            return Err(Fault::index(span, format!("{what} cannot have a free index"))
                .help("sum over the index, or write one component"));
        }
        Ok(found.free)
    }

    fn letters(&self, indices: &[Index]) -> Vec<IndexId> {
        let letters = indices.iter().filter_map(|index| match index {
            Index::Letter(id) if !self.summed.contains(id) => Some(*id),
            _ => None,
        });
        letters.collect()
    }

    pub(super) fn bind(&mut self, expr: &mut Expr) -> Result<Type, Fault> {
        match self.bind_strictly(expr) {
            // Shapes that do not fit are those of things without a value.
            Err(_) if self.symbols.is_abstract() => Ok(Type { shape: Shape::Abstract, free: Vec::new() }),
            found => found,
        }
    }

    fn bind_strictly(&mut self, expr: &mut Expr) -> Result<Type, Fault> {
        let span = expr.span;
        let scalar = Type { shape: Shape::Scalar, free: Vec::new() };
        match &mut expr.node {
            Node::Number(_) | Node::Pi | Node::Euler | Node::Unit(_) => Ok(scalar),
            Node::Identity => Ok(Type { shape: Shape::Matrix(0, 0), ..scalar }),
            Node::Imaginary => Ok(Type { shape: Shape::Complex, ..scalar }),
            Node::Symbol { id, indices, .. } => {
                let shape = self.symbol_shape(*id, indices.len(), span)?;
                let letters = self.letters(indices);
                let free = self.contract(letters, expr)?;
                Ok(Type { shape, free })
            }
            Node::Epsilon(indices) => {
                let letters = self.letters(&indices[..]);
                let free = self.contract(letters, expr)?;
                Ok(Type { free, ..scalar })
            }
            Node::Delta(indices) => {
                let letters = self.letters(&indices[..]);
                let free = self.contract(letters, expr)?;
                Ok(Type { free, ..scalar })
            }
            Node::Sum(terms) => self.sum(terms),
            Node::Product(factors) => {
                let (shape, letters) = self.product(factors)?;
                let free = self.contract(letters, expr)?;
                Ok(Type { shape, free })
            }
            Node::Quotient(a, b) => self.quotient(a, b),
            Node::Power(..)
            | Node::Transpose(_)
            | Node::Inverse(_)
            | Node::OfMatrix(..)
            | Node::Commutator(..)
            | Node::Complex(..)
            | Node::Cases(_) => self.operator(expr),
            Node::Root(_, a) => self.scalar(a, "the formula under a root").map(|free| Type { free, ..scalar }),
            Node::Call(function, a) => self.call(*function, a, span),
            Node::Apply(id, arguments) if self.symbols.entry(*id).operator.is_some() => self.applied(*id, arguments),
            Node::Apply(_, arguments) => {
                let mut free = Vec::new();
                for argument in arguments {
                    free = union(&free, &self.scalar(argument, "the angle of a rotation")?);
                }
                Ok(Type { shape: Shape::Matrix(3, 3), free })
            }
            Node::TimeDerivative(_, a) => self.bind(a),
            Node::Norm(a) => {
                let found = self.bind(a)?;
                match found.shape {
                    Shape::Matrix(..) => Err(Fault::unsupported(span, "the norm of a matrix is not supported")
                        .help("write the norm as a formula of the entries")),
                    _ => Ok(Type { shape: Shape::Scalar, ..found }),
                }
            }
            Node::Cross(a, b) | Node::Dot(a, b) => {
                let letters = self.two_vectors(a, b)?;
                let is_cross = matches!(expr.node, Node::Cross(..));
                let free = self.contract(letters, expr)?;
                Ok(Type { shape: if is_cross { Shape::Vector } else { Shape::Scalar }, free })
            }
            Node::Matrix(rows) => self.matrix(rows, span),
            Node::Integral(_, a) | Node::Shrinking(_, a) => self.bind(a),
            Node::Letter(_) | Node::Rest(_) => Ok(scalar),
            Node::Definite(of) => self.definite(of),
            Node::Component(a, index) => {
                let indices = [*index];
                let found = self.bind(a)?;
                if found.shape != Shape::Vector {
                    return Err(Fault::shape(span, format!("{} has no components", found.shape.noun()))
                        .help("remove the index, or mark the vector with \\vec or \\mathbf"));
                }
                let letters = found.free.into_iter().chain(self.letters(&indices)).collect();
                let free = self.contract(letters, expr)?;
                Ok(Type { free, ..scalar })
            }
            Node::Entry(a, row, column) => {
                let indices = [*row, *column];
                let found = self.bind(a)?;
                if !matches!(found.shape, Shape::Matrix(..)) {
                    return Err(Fault::shape(span, "only a matrix can have two indices")
                        .help("declare the name as a matrix, as in \"M\": \"3x3 matrix\""));
                }
                let letters = self.letters(&indices);
                let free = self.contract(letters, expr)?;
                Ok(Type { free, ..scalar })
            }
            // Made here before: binding a bound formula again changes nothing.
            Node::SumOver { index, implied: true, body, .. } => self.summed_over(*index, body),
            Node::SumOver { index, body, except, .. } => {
                if self.summed.contains(index) {
                    let letter = &self.symbols.indices[index.0].letter;
                    return Err(Fault::index(span, format!("the index {letter} is already summed over"))
                        .help("use another index in the inner sum"));
                }
                // What bounds the sum is as free as what stands in it.
                let bounds: Vec<Index> = except.iter().filter_map(|left_out| left_out.index()).collect();
                let bounds = self.letters(&bounds);
                let found = self.summed_over(*index, body)?;
                Ok(Type { free: union(&found.free, &bounds), ..found })
            }
        }
    }

    /// The type of the body of a sum over an index.
    fn summed_over(&mut self, index: IndexId, body: &mut Expr) -> Result<Type, Fault> {
        self.summed.push(index);
        let found = self.bind(body);
        self.summed.pop();
        found
    }

    /// Whether a letter is a label of particles, which is never summed over by repetition.
    pub(super) fn is_label(&self, letter: IndexId) -> bool {
        self.symbols.indices[letter.0].labels
    }

    /// Wraps `expr` in a sum for every component index that occurs twice. Returns the free indices, in order.
    fn contract(&self, mut letters: Vec<IndexId>, expr: &mut Expr) -> Result<Vec<IndexId>, Fault> {
        letters.sort();
        let mut free = Vec::new();
        for group in letters.chunk_by(|a, b| a == b) {
            match group {
                [index] => free.push(*index),
                [index, ..] if self.is_label(*index) => free.push(*index),
                [index, _] => {
                    let span = expr.span;
                    let body = std::mem::replace(expr, Expr::new(Node::Pi, span));
                    let body = Box::new(body);
                    expr.node = Node::SumOver { index: *index, implied: true, except: Vec::new(), within: None, body };
                }
                _ => return Err(self.thrice(group[0], expr.span)),
            }
        }
        Ok(free)
    }

    fn thrice(&self, index: IndexId, span: Span) -> Fault {
        let letter = &self.symbols.indices[index.0].letter;
        Fault::index(span, format!("the index {letter} occurs more than twice in this term"))
            .help(format!("if this index is summed over, write \\sum_{letter}"))
    }
}

/// The component indices among these, without labels.
pub(super) fn components(free: &[IndexId], symbols: &Symbols) -> Vec<IndexId> {
    free.iter().copied().filter(|letter| !symbols.indices[letter.0].labels).collect()
}

/// Free indices in words.
fn indices(free: &[IndexId], symbols: &Symbols) -> String {
    let letters: Vec<&str> = free.iter().map(|index| symbols.indices[index.0].letter.as_str()).collect();
    match letters.as_slice() {
        [] => "no free index".to_owned(),
        [only] => format!("the free index {only}"),
        [first @ .., last] => format!("the free indices {} and {last}", first.join(", ")),
    }
}

/// The union of two lists of indices, in order.
pub fn union(a: &[IndexId], b: &[IndexId]) -> Vec<IndexId> {
    let mut all: Vec<IndexId> = a.iter().chain(b).copied().collect();
    all.sort();
    all.dedup();
    all
}
