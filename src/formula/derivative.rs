//! Derivatives of formulas as formulas: by one symbol ([`partial`]), and by the time ([`rate`]).
//!
//! A partial derivative takes the symbols, their rates and the time for independent variables: in L(θ, θ̇, t), θ and θ̇
//! are two of them. Names that a formula defines are replaced by it first, so that ∂T/∂θ̇ is found where T is printed
//! with ẋ and x = l sin θ. What depends on the variable in a way that no formula tells has no derivative here.

use super::calculus::any_function;
use super::ids::{Index, SymbolId, Variable};
use super::shape::{Shape, shape_of};
use super::symbols::Symbols;
use super::tree::{Definite, Expr, Function, MatrixFunction, Node, Sign, Term};
use crate::source::Span;

/// Why a formula has no derivative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoDerivative {
    /// The formula of this symbol is not known.
    Unknown(SymbolId),
    /// An operation whose derivative is not supported.
    Operation(&'static str),
}

type Derived = Result<Expr, NoDerivative>;

/// The symbols with their definitions, and the defined ones that are variables of their own here: momenta.
#[derive(Clone, Copy)]
pub struct Scope<'a> {
    /// The table of symbols.
    pub symbols: &'a Symbols,
    /// Symbols that no definition replaces.
    pub fixed: &'a [SymbolId],
}

/// Most definitions stand within a few others; more are taken for a circle.
const DEEPEST: usize = 40;

/// `∂expr/∂by`. Every node of the result has the place `span`.
///
/// # Errors
/// Where something in the formula has no known derivative.
pub fn partial(expr: &Expr, by: &Variable, scope: Scope<'_>, span: Span) -> Derived {
    // A family of separate names: ∂L/∂q_i is the sum of δ_ik ∂L/∂q_k.
    let members = &scope.symbols.entry(by.id).members;
    if let ([index], false) = (by.indices.as_slice(), members.is_empty()) {
        let mut terms = Vec::new();
        for (k, id) in (1..).zip(members) {
            let of_member = partial(expr, &Variable { id: *id, indices: Vec::new(), dots: by.dots }, scope, span)?;
            let delta = Expr::new(Node::Delta([*index, Index::Fixed(k)]), span);
            let expr = Expr::new(Node::Product(vec![delta, of_member]), span);
            terms.push(Term { sign: Sign::Plus, sign_span: None, expr });
        }
        return not_too_long(Expr::new(Node::Sum(terms), span));
    }
    not_too_long(Differentiator { scope, symbols: scope.symbols, span, how: How::Partial(by) }.of(expr, 0)?)
}

/// The largest number of parts of a derivative: each further derivative multiplies them.
const LONGEST: usize = 4000;

fn not_too_long(formula: Expr) -> Derived {
    let mut parts = 0;
    formula.walk(&mut |_| parts += 1);
    if parts > LONGEST { Err(NoDerivative::Operation("a formula as long as this")) } else { Ok(formula) }
}

/// `d expr/dt`, in which every definition is replaced by its formula.
///
/// # Errors
/// Where something in the formula has no known derivative.
pub fn rate(expr: &Expr, scope: Scope<'_>, span: Span) -> Derived {
    not_too_long(Differentiator { scope, symbols: scope.symbols, span, how: How::Rate }.of(expr, 0)?)
}

/// What of the independent variables a formula contains, through definitions too: each symbol with its indices and its
/// dots, once. Empty for a formula of constants.
///
/// # Errors
/// For a symbol whose formula is not known.
pub fn variables(expr: &Expr, scope: Scope<'_>) -> Result<Vec<Variable>, NoDerivative> {
    let mut found = Vec::new();
    collect(expr, scope, 0, &mut found)?;
    Ok(found)
}

fn collect(expr: &Expr, scope: Scope<'_>, depth: usize, found: &mut Vec<Variable>) -> Result<(), NoDerivative> {
    match &expr.node {
        Node::Symbol { id, indices, dots } => {
            let (entry, symbols) = (scope.symbols.entry(*id), scope.symbols);
            let definition = entry.definition.as_ref().filter(|_| !scope.fixed.contains(id));
            match definition {
                _ if depth > DEEPEST => return Err(NoDerivative::Unknown(*id)),
                Some(formula) if *dots == 0 => return collect(formula, scope, depth + 1, found),
                Some(_) => {
                    let (mut expanded, span) = (expr.clone(), expr.span);
                    if let Node::Symbol { dots, .. } = &mut expanded.node {
                        *dots -= 1;
                    }
                    return collect(&rate(&expanded, scope, span)?, scope, depth + 1, found);
                }
                None if entry.derived && !scope.fixed.contains(id) => return Err(NoDerivative::Unknown(*id)),
                None if entry.varies || symbols.open => {
                    let variable = Variable { id: *id, indices: indices.clone(), dots: *dots };
                    if !found.contains(&variable) {
                        found.push(variable);
                    }
                }
                None => {}
            }
        }
        Node::TimeDerivative(order, inner) => {
            let mut inner = inner.as_ref().clone();
            for _ in 0..*order {
                inner = rate(&inner, scope, expr.span)?;
            }
            return collect(&inner, scope, depth + 1, found);
        }
        _ => {
            for child in expr.children() {
                collect(child, scope, depth, found)?;
            }
        }
    }
    Ok(())
}

/// By what is differentiated.
#[derive(Clone, Copy)]
enum How<'a> {
    Partial(&'a Variable),
    Rate,
}

struct Differentiator<'a> {
    scope: Scope<'a>,
    symbols: &'a Symbols,
    span: Span,
    how: How<'a>,
}

impl Differentiator<'_> {
    fn of(&self, expr: &Expr, depth: usize) -> Derived {
        if depth > DEEPEST {
            return Err(NoDerivative::Operation("a name whose definition contains this name"));
        }
        let again = |inner: &Expr| self.of(inner, depth);
        Ok(match &expr.node {
            Node::Number(_)
            | Node::Pi
            | Node::Euler
            | Node::Unit(_)
            | Node::Identity
            | Node::Imaginary
            | Node::Epsilon(_)
            | Node::Letter(_)
            | Node::Delta(_) => self.zero_like(expr),
            Node::Symbol { id, indices, dots } => return self.of_symbol(*id, indices, *dots, depth),
            Node::Sum(_) if any_function::value_of(expr, self.symbols).is_some() => {
                return self.of_any_function(expr, depth);
            }
            Node::Sum(terms) => {
                let terms = terms.iter().map(|term| Ok((term.sign, again(&term.expr)?)));
                self.sum(terms.collect::<Result<_, _>>()?, expr)
            }
            Node::Product(factors) => {
                let mut terms = Vec::new();
                for at in 0..factors.len() {
                    let mut factors = factors.clone();
                    factors[at] = again(&factors[at])?;
                    terms.push((Sign::Plus, self.product(factors)));
                }
                self.sum(terms, expr)
            }
            Node::Quotient(a, b) => {
                let (da, db) = (again(a)?, again(b)?);
                let first = self.quotient(da, self.copy(b));
                match db.is_zero() {
                    true => first,
                    false => {
                        let square = self.power(self.copy(b), self.number(2));
                        let second = self.quotient(self.product(vec![self.copy(a), db]), square);
                        self.sum(vec![(Sign::Plus, first), (Sign::Minus, second)], expr)
                    }
                }
            }
            Node::Power(base, exponent) => return self.of_power(base, exponent, depth),
            Node::Root(degree, radicand) => {
                let inner = again(radicand)?;
                let root = self.node(Node::Root(*degree, Box::new(self.copy(radicand))));
                let below = match degree {
                    2 => root,
                    n => self.power(root, self.number(n - 1)),
                };
                self.quotient(inner, self.product(vec![self.number(*degree), below]))
            }
            Node::Call(function, argument) => {
                let inner = again(argument)?;
                self.product(vec![self.of_function(*function, argument), inner])
            }
            Node::TimeDerivative(order, inner) => {
                let mut inner = inner.as_ref().clone();
                for _ in 0..*order {
                    inner = rate(&inner, self.scope, self.span)?;
                }
                return self.of(&inner, depth + 1);
            }
            Node::Norm(inner) => {
                let change = again(inner)?;
                let above = match self.shape(inner)? {
                    Shape::Scalar => self.product(vec![self.copy(inner), change]),
                    _ => self.node(Node::Dot(Box::new(self.copy(inner)), Box::new(change))),
                };
                self.quotient(above, self.node(Node::Norm(Box::new(self.copy(inner)))))
            }
            Node::Cross(a, b) => self.bilinear(Node::Cross, (a, b), expr, depth)?,
            Node::Dot(a, b) => self.bilinear(Node::Dot, (a, b), expr, depth)?,
            Node::Matrix(rows) => {
                let rows = rows.iter().map(|row| row.iter().map(again).collect::<Result<_, _>>());
                self.node(Node::Matrix(rows.collect::<Result<_, _>>()?))
            }
            Node::Transpose(inner) => self.node(Node::Transpose(Box::new(again(inner)?))),
            Node::OfMatrix(MatrixFunction::Trace, inner) => {
                self.node(Node::OfMatrix(MatrixFunction::Trace, Box::new(again(inner)?)))
            }
            Node::Commutator(a, b) => self.bilinear(Node::Commutator, (a, b), expr, depth)?,
            Node::Complex(part, inner) => self.node(Node::Complex(*part, Box::new(again(inner)?))),
            Node::OfMatrix(..) => return Err(NoDerivative::Operation("a determinant")),
            Node::Cases(_) => return Err(NoDerivative::Operation("a function given by cases")),
            Node::Entry(inner, a, b) => self.node(Node::Entry(Box::new(again(inner)?), *a, *b)),
            Node::Component(inner, a) => self.node(Node::Component(Box::new(again(inner)?), *a)),
            Node::SumOver { index, implied, except, within: None, body } => {
                let body = again(body)?;
                match body.is_zero() {
                    true => body,
                    false => self.node(Node::SumOver {
                        index: *index,
                        implied: *implied,
                        except: except.clone(),
                        within: None,
                        body: Box::new(body),
                    }),
                }
            }
            Node::Apply(id, _) if self.symbols.entry(*id).operator.is_some() => {
                return Err(NoDerivative::Operation("a function or an operator without a formula"));
            }
            Node::Apply(..) => return Err(NoDerivative::Operation("a rotation")),
            Node::Inverse(_) => return Err(NoDerivative::Operation("the inverse of a matrix")),
            Node::Rest(_) => return Err(NoDerivative::Operation("a sum whose further terms are left out")),
            Node::Definite(of) => self.of_integral(of, expr, depth)?,
            Node::Integral(..) | Node::Shrinking(..) | Node::SumOver { .. } => {
                return Err(NoDerivative::Operation("an integral or a sum over particles"));
            }
        })
    }

    fn of_symbol(&self, id: SymbolId, indices: &[Index], dots: u8, depth: usize) -> Derived {
        let entry = self.symbols.entry(id);
        let symbol = |dots: u8| self.node(Node::Symbol { id, indices: indices.to_vec(), dots });
        if let How::Partial(by) = self.how
            && by.id == id
            && by.dots == dots
            && by.indices == indices
        {
            return Ok(self.number(1));
        }
        let is_fixed = self.scope.fixed.contains(&id);
        if !entry.derivatives.is_empty() && dots == 0 && !is_fixed {
            let inner = |(argument, id): (&Variable, &SymbolId)| {
                let Variable { id: argument, indices, dots } = argument;
                let change = self.of_symbol(*argument, indices, *dots, depth + 1)?;
                let derivative = self.node(Node::Symbol { id: *id, indices: Vec::new(), dots: 0 });
                Ok((Sign::Plus, self.product(vec![derivative, change])))
            };
            let terms = entry.arguments.iter().zip(&entry.derivatives).map(inner).collect::<Result<_, _>>()?;
            return Ok(self.sum(terms, &symbol(0)));
        }
        if let Some(formula) = entry.definition.as_ref().filter(|_| !is_fixed) {
            // The symbol of a name that is introduced by its square, ω² = k/m, stands for the square, as its formula does.
            if !entry.slots.is_empty() {
                return Err(NoDerivative::Unknown(id));
            }
            let mut formula = formula.as_ref().clone();
            for _ in 0..dots {
                formula = rate(&formula, self.scope, self.span)?;
            }
            return self.of(&formula, depth + 1);
        }
        let is_constant = !entry.varies && !self.symbols.open;
        let is_time = self.symbols.time.as_ref() == Some(&entry.name);
        match self.how {
            How::Rate if is_time => Ok(self.number(1)),
            How::Rate if is_constant => Ok(self.zero_like(&symbol(0))),
            How::Rate => Ok(symbol(dots.checked_add(1).ok_or(NoDerivative::Operation("a symbol with so many dots"))?)),
            How::Partial(_) if entry.derived && !is_fixed => Err(NoDerivative::Unknown(id)),
            // A family by one of its members, through an index letter.
            How::Partial(by) if by.id == id && indices.iter().any(|index| matches!(index, Index::Letter(_))) => {
                Err(NoDerivative::Operation("a sum over the members of a family"))
            }
            How::Partial(_) => Ok(self.zero_like(&symbol(dots))),
        }
    }

    /// The derivative of a value of a function without a formula, by the chain rule. It has the form of such a value again.
    fn of_any_function(&self, expr: &Expr, depth: usize) -> Derived {
        let Some(value) = any_function::value_of(expr, self.symbols) else { return Ok(self.zero_like(expr)) };
        // One order more would be the same at all places, or 0.
        if value.orders.iter().sum::<u32>() + 2 > value.function.degree {
            return Err(NoDerivative::Operation("a function without a formula to so high an order"));
        }
        let mut terms = Vec::new();
        for (at, argument) in value.arguments.iter().enumerate() {
            let change = self.of(argument, depth)?;
            let mut orders = value.orders.clone();
            orders[at] += 1;
            let slope = any_function::at(value.function, &orders, &value.arguments, self.span);
            terms.push((Sign::Plus, self.product(vec![self.copy(&slope), change])));
        }
        Ok(self.sum(terms, expr))
    }

    /// The derivative of an integral over a letter: that of the integrand, and what the ends add.
    fn of_integral(&self, of: &Definite, expr: &Expr, depth: usize) -> Derived {
        let slope = self.of(&of.integrand, depth)?;
        let within = Definite { integrand: slope.clone(), ..of.clone() };
        let mut terms = Vec::new();
        if !slope.is_null() {
            let mut inside = self.node(Node::Definite(Box::new(within)));
            inside.move_to(self.span);
            terms.push((Sign::Plus, inside));
        }
        for (sign, end) in [(Sign::Plus, &of.upper), (Sign::Minus, &of.lower)] {
            let Some(end) = end else { continue };
            let change = self.of(end, depth)?;
            let mut there = self.copy(&of.integrand);
            there.substitute(&|node| matches!(node, Node::Letter(name) if *name == of.letter).then(|| self.copy(end)));
            terms.push((sign, self.product(vec![there, change])));
        }
        Ok(self.sum(terms, expr))
    }

    fn of_power(&self, base: &Expr, exponent: &Expr, depth: usize) -> Derived {
        let up = self.of(exponent, depth)?;
        let own = self.node(Node::Power(Box::new(self.copy(base)), Box::new(self.copy(exponent))));
        if base.node == Node::Euler {
            return Ok(self.product(vec![own, up]));
        }
        let down = self.of(base, depth)?;
        if !self.shape(base)?.is_number() {
            // The square of a vector is the square of its norm.
            return match exponent.as_digits() {
                Some("2") if self.shape(base)? == Shape::Vector => {
                    let dot = self.node(Node::Dot(Box::new(self.copy(base)), Box::new(down)));
                    Ok(self.product(vec![self.number(2), dot]))
                }
                _ => Err(NoDerivative::Operation("a power of a vector or a matrix")),
            };
        }
        let first = match exponent.as_digits() {
            Some("1") => down,
            Some("2") => self.product(vec![self.number(2), self.copy(base), down]),
            Some(digits) if digits.parse::<u32>().is_ok_and(|power| power > 0) => {
                let power: u32 = digits.parse().unwrap_or_default();
                let less = self.power(self.copy(base), self.number(power - 1));
                self.product(vec![self.number(power), less, down])
            }
            _ => {
                let less = self.sum(vec![(Sign::Plus, self.copy(exponent)), (Sign::Minus, self.number(1))], exponent);
                self.product(vec![self.copy(exponent), self.power(self.copy(base), less), down])
            }
        };
        let logarithm = self.node(Node::Call(Function::Ln, Box::new(self.copy(base))));
        let second = self.product(vec![own, logarithm, up]);
        Ok(self.sum(vec![(Sign::Plus, first), (Sign::Plus, second)], base))
    }

    /// The derivative of an elementary function at its argument.
    fn of_function(&self, function: Function, argument: &Expr) -> Expr {
        let call = |function| self.node(Node::Call(function, Box::new(self.copy(argument))));
        let square = |inner| self.power(inner, self.number(2));
        let one_and =
            |sign| self.sum(vec![(Sign::Plus, self.number(1)), (sign, square(self.copy(argument)))], argument);
        let root = |inner| self.node(Node::Root(2, Box::new(inner)));
        let negative = |inner: Expr| inner.negated();
        let over = |below| self.quotient(self.number(1), below);
        match function {
            Function::Sin => call(Function::Cos),
            Function::Cos => negative(call(Function::Sin)),
            Function::Tan => over(square(call(Function::Cos))),
            Function::Cot => negative(over(square(call(Function::Sin)))),
            Function::Sec => self.product(vec![call(Function::Sec), call(Function::Tan)]),
            Function::Csc => negative(self.product(vec![call(Function::Csc), call(Function::Cot)])),
            Function::Arcsin => over(root(one_and(Sign::Minus))),
            Function::Arccos => negative(over(root(one_and(Sign::Minus)))),
            Function::Arctan => over(one_and(Sign::Plus)),
            Function::Sinh => call(Function::Cosh),
            Function::Cosh => call(Function::Sinh),
            Function::Tanh => over(square(call(Function::Cosh))),
            Function::Exp => call(Function::Exp),
            Function::Ln => over(self.copy(argument)),
        }
    }

    fn bilinear(
        &self,
        node: impl Fn(Box<Expr>, Box<Expr>) -> Node,
        (a, b): (&Expr, &Expr),
        whole: &Expr,
        depth: usize,
    ) -> Derived {
        let (da, db) = (self.of(a, depth)?, self.of(b, depth)?);
        let mut terms = Vec::new();
        if !da.is_null() {
            terms.push((Sign::Plus, self.node(node(Box::new(da), Box::new(self.copy(b))))));
        }
        if !db.is_null() {
            terms.push((Sign::Plus, self.node(node(Box::new(self.copy(a)), Box::new(db)))));
        }
        Ok(self.sum(terms, whole))
    }

    fn shape(&self, expr: &Expr) -> Result<Shape, NoDerivative> {
        shape_of(expr, self.symbols)
            .map_err(|_| NoDerivative::Operation("a formula that is not clearly a number, a vector or a matrix"))
    }

    fn node(&self, node: Node) -> Expr {
        Expr::new(node, self.span)
    }

    fn number(&self, value: u32) -> Expr {
        Expr::integer(value, self.span)
    }

    /// The zero of the shape of a formula.
    fn zero_like(&self, expr: &Expr) -> Expr {
        let zero = || self.number(0);
        match shape_of(expr, self.symbols) {
            Ok(Shape::Vector) => self.node(Node::Matrix((0..3).map(|_| vec![zero()]).collect())),
            Ok(Shape::Matrix(rows, columns)) if rows > 0 => {
                self.node(Node::Matrix((0..rows).map(|_| (0..columns).map(|_| zero()).collect()).collect()))
            }
            _ => zero(),
        }
    }

    /// The same formula, all of it at the place of the derivative.
    fn copy(&self, expr: &Expr) -> Expr {
        let mut copy = expr.clone();
        copy.move_to(self.span);
        copy
    }

    /// A sum without zeros.
    fn sum(&self, terms: Vec<(Sign, Expr)>, whole: &Expr) -> Expr {
        let mut kept: Vec<Term> = terms
            .into_iter()
            .filter(|(_, expr)| !expr.is_null())
            .map(|(sign, expr)| Term { sign, sign_span: None, expr })
            .collect();
        match kept.len() {
            0 => self.zero_like(whole),
            1 if kept[0].sign == Sign::Plus => kept.swap_remove(0).expr,
            _ => self.node(Node::Sum(kept)),
        }
    }

    /// A product without ones; 0 if a factor is 0.
    fn product(&self, factors: Vec<Expr>) -> Expr {
        if let Some(zero) = factors.iter().position(Expr::is_null) {
            let whole = self.node(Node::Product(factors.clone()));
            return match factors[zero].is_zero() {
                true => self.zero_like(&whole),
                false => factors.into_iter().nth(zero).unwrap_or(whole),
            };
        }
        let mut kept: Vec<Expr> = factors.into_iter().filter(|factor| factor.as_digits() != Some("1")).collect();
        match kept.len() {
            0 => self.number(1),
            1 => kept.swap_remove(0),
            _ => self.node(Node::Product(kept)),
        }
    }

    fn quotient(&self, above: Expr, below: Expr) -> Expr {
        match above.is_null() {
            true => above,
            false => self.node(Node::Quotient(Box::new(above), Box::new(below))),
        }
    }

    fn power(&self, base: Expr, exponent: Expr) -> Expr {
        match exponent.as_digits() {
            Some("1") => base,
            _ => self.node(Node::Power(Box::new(base), Box::new(exponent))),
        }
    }
}
