//! The formula tree, and the statements of a display.
//!
//! Two trees are equal if their nodes are equal in the same order; their places ([`Expr::span`]) are not compared. Sums
//! and products are flat lists, as authors write them, so that a single term or factor can be shown, removed or
//! changed.

use crate::source::Span;

#[cfg(feature = "notes")]
pub use super::ids::Variable;
pub use super::ids::{Index, IndexId};
pub use super::operators::{ComplexPart, Function, MatrixFunction, Relation};

use super::ids::SymbolId;
use super::units::Unit;

/// A formula with its place.
#[derive(Clone, Debug)]
pub struct Expr {
    /// The node.
    pub node: Node,
    /// The bytes of the display that it was read from.
    pub span: Span,
}

impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.node == other.node
    }
}

/// One node of a formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A literal, as written: `2`, `0.25`.
    Number(String),
    /// The circle constant π, unless π is a declared symbol.
    Pi,
    /// The base of the natural logarithm, as the base of a power.
    Euler,
    /// A unit after a number, `kg`.
    Unit(Unit),
    /// A symbol with its indices, differentiated `dots` times with respect to time.
    /// A family of one or two indices that is written without them is the whole vector or matrix.
    Symbol {
        /// The symbol.
        id: SymbolId,
        /// The indices, one for each slot of the family; empty for a plain symbol.
        indices: Vec<Index>,
        /// The number of overdots.
        dots: u8,
    },
    /// `a + b − c`; a lone negative term is a negation.
    Sum(Vec<Term>),
    /// A product of factors; at most one is a vector. Matrices are multiplied in order.
    Product(Vec<Expr>),
    /// `a / b`.
    Quotient(Box<Expr>, Box<Expr>),
    /// `a ^ b`.
    Power(Box<Expr>, Box<Expr>),
    /// The n-th root; 2 for a square root.
    Root(u32, Box<Expr>),
    /// A named elementary function.
    Call(Function, Box<Expr>),
    /// A declared rotation with its argument.
    Apply(SymbolId, Vec<Expr>),
    /// `dⁿ/dtⁿ` of a formula: the order n, and the formula.
    TimeDerivative(u8, Box<Expr>),
    /// Absolute value of a scalar, norm of a vector.
    Norm(Box<Expr>),
    /// `a × b` of vectors.
    Cross(Box<Expr>, Box<Expr>),
    /// `a · b` of vectors.
    Dot(Box<Expr>, Box<Expr>),
    /// Rows of scalars.
    Matrix(Vec<Vec<Expr>>),
    /// `Mᵀ`.
    Transpose(Box<Expr>),
    /// `M⁻¹` of a matrix.
    Inverse(Box<Expr>),
    /// The unit matrix, of the size that its place asks for.
    Identity,
    /// The determinant or the trace of a square matrix.
    OfMatrix(MatrixFunction, Box<Expr>),
    /// `[A, B]`, which is A B − B A.
    Commutator(Box<Expr>, Box<Expr>),
    /// √−1
    Imaginary,
    /// The conjugate, the real part or the imaginary part of a number.
    Complex(ComplexPart, Box<Expr>),
    /// `\begin{cases} … \end{cases}`: the value of the first row whose conditions hold.
    Cases(Vec<Branch>),
    /// One entry of a matrix that is no plain symbol, `(R^{-1})_{bc}`: the matrix, the row and the column.
    Entry(Box<Expr>, Index, Index),
    /// The Levi-Civita symbol ε.
    Epsilon([Index; 3]),
    /// The Kronecker symbol δ.
    Delta([Index; 2]),
    /// A sum over an index, written (Σ) or implied by repetition.
    SumOver {
        /// The summation index.
        index: IndexId,
        /// Whether it is implied by repetition.
        implied: bool,
        /// The excluded values of the index.
        except: Vec<Excluded>,
        /// The continuum that contains the particles of the sum: `\sum_{\vec r_i \in V(\vec r)}`.
        within: Option<SymbolId>,
        /// The summand.
        body: Box<Expr>,
    },
    /// `\int_V … d^3r` over a declared continuum.
    Integral(SymbolId, Box<Expr>),
    /// `\lim_{V(\vec r) \to 0}`: the limit as a part of a continuum shrinks to its point.
    Shrinking(SymbolId, Box<Expr>),
    /// One component of a vector along the fixed axes.
    Component(Box<Expr>, Index),
    /// A definite integral over one letter for which no antiderivative is known.
    Definite(Box<Definite>),
    /// The terms that are left out at the end of a sum: `\dots`, or `O(x^2 y)` with the powers of x and y.
    Rest(Vec<(SymbolId, i32)>),
    /// The letter of such an integral, inside it. It is no symbol, and means nothing outside.
    Letter(String),
}

/// `\int_{lower}^{upper} integrand d(letter)`: its value is found by quadrature.
#[derive(Clone, Debug, PartialEq)]
pub struct Definite {
    /// The letter, which is [`Node::Letter`] in the integrand.
    pub letter: String,
    /// The lower end; `None` for −∞.
    pub lower: Option<Expr>,
    /// The upper end; `None` for +∞.
    pub upper: Option<Expr>,
    /// What is integrated.
    pub integrand: Expr,
}

impl Node {
    /// `\sum_{index}` of `body`, over all values.
    pub fn over(index: IndexId, body: Expr) -> Node {
        Node::SumOver { index, implied: false, except: Vec::new(), within: None, body: Box::new(body) }
    }
}

/// A term of a sum with its sign.
#[derive(Clone, Debug)]
pub struct Term {
    /// Added or subtracted.
    pub sign: Sign,
    /// The place of the sign, if it is printed.
    pub sign_span: Option<Span>,
    /// The term without its sign.
    pub expr: Expr,
}

impl PartialEq for Term {
    fn eq(&self, other: &Self) -> bool {
        self.sign == other.sign && self.expr == other.expr
    }
}

/// The sign of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Added.
    Plus,
    /// Subtracted.
    Minus,
}

impl Sign {
    /// The other sign.
    pub fn flipped(self) -> Sign {
        match self {
            Sign::Plus => Sign::Minus,
            Sign::Minus => Sign::Plus,
        }
    }
}

/// Values of the summation index that a Σ excludes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Excluded {
    /// This value: the i of `\sum_{j \neq i}`.
    Value(Index),
    /// This value and all above: the i of `\sum_{j < i}`.
    From(Index),
    /// This value and all below: the i of `\sum_{j > i}`, the 1 of `\sum_{j=2}^{n}`.
    UpTo(Index),
    /// This number of last values: 1 in `\sum_{j=1}^{n-1}`.
    Last(u8),
}

impl Excluded {
    /// The index that bounds the sum, if there is one.
    pub fn index(self) -> Option<Index> {
        match self {
            Excluded::Value(index) | Excluded::From(index) | Excluded::UpTo(index) => Some(index),
            Excluded::Last(_) => None,
        }
    }
}

/// A chain of comparisons, `0 \le x < 1`: one relation fewer than members.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// What is compared.
    pub members: Vec<Expr>,
    /// The relations between neighbours.
    pub relations: Vec<Relation>,
}

/// One row of `cases`.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The value in this case.
    pub value: Expr,
    /// The comparisons that must all hold; empty for "otherwise".
    pub conditions: Vec<Condition>,
}

impl Branch {
    /// The value, and what its conditions compare.
    pub fn parts(&self) -> Vec<&Expr> {
        let compared = self.conditions.iter().flat_map(|condition| &condition.members);
        std::iter::once(&self.value).chain(compared).collect()
    }

    /// As [`Branch::parts`], mutable.
    pub fn parts_mut(&mut self) -> Vec<&mut Expr> {
        let compared = self.conditions.iter_mut().flat_map(|condition| &mut condition.members);
        std::iter::once(&mut self.value).chain(compared).collect()
    }
}

/// One statement of a display: a chain of formulas with a relation between neighbours.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// The formulas, one or more.
    pub members: Vec<Expr>,
    /// The relations between the members, with their places; one fewer than the members.
    pub relations: Vec<(Relation, Span)>,
    /// The place of "is constant" after the last member, if the display says so.
    pub constant: Option<Span>,
    /// The conditions under which it is said: `\text{for } x > 0`.
    pub conditions: Vec<Condition>,
    /// The sign that `±` stands for in this reading.
    pub branch: Option<Sign>,
    /// The row of the display, from 1.
    pub row: usize,
    /// The whole statement.
    pub span: Span,
}

#[cfg(feature = "notes")]
impl Statement {
    /// Whether this and another are the two signs of a ± that stands on some sides only, as in `x = 3 \pm 2`: one of the two holds,
    /// and perhaps not both.
    pub fn is_alternative_to(&self, other: &Statement) -> bool {
        let is_same = |(a, b): (&Expr, &Expr)| a == b;
        self.span == other.span
            && self.branch.zip(other.branch).is_some_and(|(a, b)| a != b)
            && self.members.len() > 1
            && self.members.iter().zip(&other.members).any(is_same)
    }
}

impl Expr {
    /// A formula read at `span`.
    pub fn new(node: Node, span: Span) -> Self {
        Expr { node, span }
    }

    /// A whole number.
    pub fn integer(value: u32, span: Span) -> Self {
        Expr::new(Node::Number(value.to_string()), span)
    }

    /// `−self`.
    pub fn negated(self) -> Self {
        let span = self.span;
        Expr::new(Node::Sum(vec![Term { sign: Sign::Minus, sign_span: None, expr: self }]), span)
    }

    /// `self − other`.
    pub fn minus(self, other: Expr) -> Self {
        let span = self.span.to(other.span);
        let plus = Term { sign: Sign::Plus, sign_span: None, expr: self };
        let minus = Term { sign: Sign::Minus, sign_span: None, expr: other };
        Expr::new(Node::Sum(vec![plus, minus]), span)
    }

    /// The symbol, if the formula is a symbol without indices and dots.
    pub fn as_plain_symbol(&self) -> Option<SymbolId> {
        match &self.node {
            Node::Symbol { id, indices, dots: 0 } if indices.is_empty() => Some(*id),
            _ => None,
        }
    }

    /// Whether it is the literal 0.
    pub fn is_zero(&self) -> bool {
        matches!(&self.node, Node::Number(text) if text.bytes().all(|b| b == b'0' || b == b'.'))
    }

    /// Whether it is the literal 0 or the zero vector.
    pub fn is_null(&self) -> bool {
        match &self.node {
            Node::Matrix(rows) => !rows.is_empty() && rows.iter().flatten().all(Expr::is_zero),
            _ => self.is_zero(),
        }
    }

    /// The digits of a whole number.
    pub fn as_digits(&self) -> Option<&str> {
        match &self.node {
            Node::Number(text) if text.bytes().all(|b| b.is_ascii_digit()) => Some(text),
            _ => None,
        }
    }

    /// The formulas directly inside this one, in reading order.
    pub fn children(&self) -> Vec<&Expr> {
        match &self.node {
            Node::Number(_)
            | Node::Pi
            | Node::Euler
            | Node::Unit(_)
            | Node::Identity
            | Node::Imaginary
            | Node::Symbol { .. }
            | Node::Epsilon(_)
            | Node::Letter(_)
            | Node::Rest(_)
            | Node::Delta(_) => {
                vec![]
            }
            Node::Sum(terms) => terms.iter().map(|term| &term.expr).collect(),
            Node::Product(factors) | Node::Apply(_, factors) => factors.iter().collect(),
            Node::Quotient(a, b) | Node::Power(a, b) | Node::Cross(a, b) | Node::Dot(a, b) | Node::Commutator(a, b) => {
                vec![a, b]
            }
            Node::Matrix(rows) => rows.iter().flatten().collect(),
            Node::Cases(branches) => branches.iter().flat_map(Branch::parts).collect(),
            Node::Definite(of) => of.lower.iter().chain(&of.upper).chain([&of.integrand]).collect(),
            Node::Root(_, a)
            | Node::Call(_, a)
            | Node::TimeDerivative(_, a)
            | Node::Norm(a)
            | Node::Transpose(a)
            | Node::Inverse(a)
            | Node::OfMatrix(_, a)
            | Node::Complex(_, a)
            | Node::Entry(a, _, _)
            | Node::Integral(_, a)
            | Node::Shrinking(_, a)
            | Node::Component(a, _)
            | Node::SumOver { body: a, .. } => vec![a],
        }
    }

    /// As [`Expr::children`], mutable.
    pub fn children_mut(&mut self) -> Vec<&mut Expr> {
        match &mut self.node {
            Node::Number(_)
            | Node::Pi
            | Node::Euler
            | Node::Unit(_)
            | Node::Identity
            | Node::Imaginary
            | Node::Symbol { .. }
            | Node::Epsilon(_)
            | Node::Letter(_)
            | Node::Rest(_)
            | Node::Delta(_) => {
                vec![]
            }
            Node::Sum(terms) => terms.iter_mut().map(|term| &mut term.expr).collect(),
            Node::Product(factors) | Node::Apply(_, factors) => factors.iter_mut().collect(),
            Node::Quotient(a, b) | Node::Power(a, b) | Node::Cross(a, b) | Node::Dot(a, b) | Node::Commutator(a, b) => {
                vec![a, b]
            }
            Node::Matrix(rows) => rows.iter_mut().flatten().collect(),
            Node::Cases(branches) => branches.iter_mut().flat_map(Branch::parts_mut).collect(),
            Node::Definite(of) => of.lower.iter_mut().chain(&mut of.upper).chain([&mut of.integrand]).collect(),
            Node::Root(_, a)
            | Node::Call(_, a)
            | Node::TimeDerivative(_, a)
            | Node::Norm(a)
            | Node::Transpose(a)
            | Node::Inverse(a)
            | Node::OfMatrix(_, a)
            | Node::Complex(_, a)
            | Node::Entry(a, _, _)
            | Node::Integral(_, a)
            | Node::Shrinking(_, a)
            | Node::Component(a, _)
            | Node::SumOver { body: a, .. } => vec![a],
        }
    }

    /// The sums over pairs that are written under one Σ, as `\sum_{i<j}`: the place and the two index letters.
    pub fn pair_sums(&self) -> Vec<(Span, [IndexId; 2])> {
        let mut found = Vec::new();
        self.walk(&mut |expr| {
            if let Node::SumOver { index: outer, body, .. } = &expr.node
                && let Node::SumOver { index: inner, except, .. } = &body.node
                && body.span == expr.span
                && except.iter().any(|left_out| left_out.index() == Some(Index::Letter(*outer)))
            {
                found.push((expr.span, [*outer, *inner]));
            }
        });
        found
    }

    /// Whether an index letter occurs on a symbol, a component, an entry, ε or δ.
    pub fn has_letter(&self, letter: IndexId) -> bool {
        let letter = Index::Letter(letter);
        let mut found = false;
        self.walk(&mut |expr| {
            found |= match &expr.node {
                Node::Symbol { indices, .. } => indices.contains(&letter),
                Node::Component(_, a) => *a == letter,
                Node::Entry(_, a, b) => [*a, *b].contains(&letter),
                Node::Delta(indices) => indices.contains(&letter),
                Node::Epsilon(indices) => indices.contains(&letter),
                _ => false,
            };
        });
        found
    }

    /// Calls `visit` on this formula and on all formulas inside it, the outermost first.
    pub fn walk<'a>(&'a self, visit: &mut impl FnMut(&'a Expr)) {
        visit(self);
        for child in self.children() {
            child.walk(visit);
        }
    }

    /// Puts this formula, and all inside it, at one place.
    pub fn move_to(&mut self, span: Span) {
        self.span = span;
        if let Node::Sum(terms) = &mut self.node {
            terms.iter_mut().for_each(|term| term.sign_span = None);
        }
        self.children_mut().into_iter().for_each(|child| child.move_to(span));
    }

    /// Replaces each part of which `other` is some formula.
    pub fn substitute(&mut self, other: &impl Fn(&Node) -> Option<Expr>) {
        match other(&self.node) {
            Some(formula) => *self = formula,
            None => self.children_mut().into_iter().for_each(|child| child.substitute(other)),
        }
    }

    /// Replaces each symbol by `other` of it.
    pub fn rename(&mut self, other: &impl Fn(SymbolId) -> SymbolId) {
        match &mut self.node {
            Node::Symbol { id, .. } | Node::Apply(id, _) => *id = other(*id),
            Node::Rest(powers) => powers.iter_mut().for_each(|(id, _)| *id = other(*id)),
            _ => {}
        }
        self.children_mut().into_iter().for_each(|child| child.rename(other));
    }

    /// Every symbol of the formula, once, in order of first occurrence, with its largest number of dots.
    pub fn symbols(&self) -> Vec<(SymbolId, u8)> {
        let mut found: Vec<(SymbolId, u8)> = Vec::new();
        self.walk(&mut |expr| {
            let (id, dots) = match &expr.node {
                Node::Symbol { id, dots, .. } => (*id, *dots),
                Node::Apply(id, _) => (*id, 0),
                _ => return,
            };
            match found.iter_mut().find(|(known, _)| *known == id) {
                Some((_, most)) => *most = dots.max(*most),
                None => found.push((id, dots)),
            }
        });
        found
    }
}
