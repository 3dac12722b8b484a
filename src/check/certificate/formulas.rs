//! Whether two formulas are equal whatever their symbols mean. Each symbol, with its indices and derivatives, is a
//! random number, vector or matrix of a prime field.
//!
//! So x·y + y·x equals 2xy, |−r|² equals r², and Σ_ab I_ba ω_a ω_b equals Σ_ab I_ab ω_a ω_b. That I is symmetric is not
//! known here. An equality of this kind holds for every meaning, and needs no state of a system.

use nalgebra::{DMatrix, Vector3};
use std::cell::{Cell, RefCell};
use std::collections::HashMap;

use crate::formula::evaluate::{Environment, Unavailable, evaluate_to};
use crate::formula::numbers::complex::Complex;
use crate::formula::{Expr, IndexId, Kind, Node, SymbolId, Symbols, Value};
use crate::scalar::prime_field::{FirstPrime, Modulus};
use crate::scalar::{Modular, Series, TERMS};

use crate::check::certificate::claim::Certificate;
use crate::check::certificate::decide;
use crate::check::certificate::decide::at_one_point;
use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::state::residual;

/// The number of points.
const POINTS: u64 = 2;

/// The number of members of a family of any size.
const MEMBERS: u8 = 3;

/// Whether two formulas are equal, or have the same outer form with equal parts.
pub(crate) fn same(a: &Expr, b: &Expr, model: &Model) -> bool {
    a == b || is_identity(a, b, model) || {
        let (mut outer_a, mut outer_b) = (a.clone(), b.clone());
        let blank = |expr: &mut Expr| {
            expr.children_mut().into_iter().for_each(|child| *child = Expr::integer(0, child.span));
        };
        blank(&mut outer_a);
        blank(&mut outer_b);
        let (inner_a, inner_b) = (a.children(), b.children());
        let alike = || inner_a.iter().zip(&inner_b).all(|(a, b)| same(a, b, model));
        // Opposite vectors have the same norm.
        if let (Node::Norm(a), Node::Norm(b)) = (&a.node, &b.node) {
            return same(a, b, model) || same(a, &Expr::clone(b).negated(), model);
        }
        outer_a == outer_b && !inner_a.is_empty() && inner_a.len() == inner_b.len() && alike()
    }
}

/// Whether two formulas are equal for arbitrary symbols.
pub(crate) fn is_identity(a: &Expr, b: &Expr, model: &Model) -> bool {
    is_identity_where(a, b, &[], model)
}

/// Whether two formulas are equal for arbitrary symbols, some of which have the values of formulas.
pub(crate) fn is_identity_where(a: &Expr, b: &Expr, rules: &[Rule], model: &Model) -> bool {
    is_one_of_multiples(a, b, &[(1, 1)], rules, model)
}

/// Whether one formula is ±1, ±2 or ±1/2 times another.
pub(crate) fn is_multiple(a: &Expr, b: &Expr, model: &Model) -> bool {
    is_one_of_multiples(a, b, &[(1, 1), (1, -1), (1, 2), (1, -2), (2, 1), (2, -1)], &[], model)
}

/// Whether n times one formula is m times another, for one of these n and m.
fn is_one_of_multiples(a: &Expr, b: &Expr, multiples: &[(i64, i64)], rules: &[Rule], model: &Model) -> bool {
    let mut free: Vec<IndexId> = Vec::new();
    let mut shapes = Vec::new();
    for side in [a, b] {
        let Ok((_, found)) = crate::formula::shape::bind(side.clone(), &model.symbols) else { return false };
        free = crate::formula::shape::union(&free, &found.free);
        shapes.push(found.shape);
    }
    // A scalar zero may stand for a vector's.
    if shapes[0] != shapes[1] && !a.is_null() && !b.is_null() {
        return false;
    }
    // The multiple that holds at the first point is tested at the others. An accident has as many chances as multiples.
    let (mut log2, mut finest) = ((multiples.len() as f64).log2(), 1);
    let mut multiples = multiples.to_vec();
    for seed in 1..=POINTS {
        let holding = Cell::new(multiples[0]);
        let differences = || {
            let drawn =
                RandomValues::<FirstPrime> { model, rules, values: RefCell::default(), opened: RefCell::default() };
            let pairs = drawn.pairs(a, b, &free).map_err(|_| "a symbol without a value".to_owned())?;
            let times = |n: i64, x: &Modular<FirstPrime>| *x * n as f64;
            let vanish = |(n, m): &&(i64, i64)| pairs.iter().all(|(a, b)| (times(*n, a) - times(*m, b)).vanishes());
            let (n, m) = multiples.iter().find(vanish).copied().unwrap_or(multiples[0]);
            holding.set((n, m));
            Ok(pairs.iter().map(|(a, b)| times(n, a) - times(m, b)).collect())
        };
        let most_bits = Modular::<FirstPrime>::most_bits();
        match at_one_point(&differences, true, seed << 32, &mut finest, most_bits) {
            Certificate::Identity(bound) => log2 += bound,
            _ => return false,
        }
        multiples = vec![holding.get()];
    }
    log2 <= decide::FALSE_ACCEPT_LOG2
}

/// The entries of two formulas, in pairs.
type Pairs<F> = Vec<(Modular<F>, Modular<F>)>;

/// The values of symbols, by their indices.
type Drawings<F> = HashMap<(SymbolId, Vec<u8>), Value<Series<Modular<F>>>>;

/// Symbols with random values.
struct RandomValues<'s, F: Modulus> {
    model: &'s Model,
    /// The rules of some of them.
    rules: &'s [Rule],
    values: RefCell<Drawings<F>>,
    /// The symbols whose rules are being evaluated; within these they are random.
    opened: RefCell<Vec<SymbolId>>,
}

impl<F: Modulus> RandomValues<'_, F> {
    /// The entries of two formulas, in pairs.
    fn pairs(&self, a: &Expr, b: &Expr, free: &[IndexId]) -> Result<Pairs<F>, Unavailable> {
        let mut indices: Vec<(IndexId, u8)> = free.iter().map(|id| (*id, 1)).collect();
        let mut all = Vec::new();
        loop {
            let (a, b) = (evaluate_to(1, a, self, &indices)?, evaluate_to(1, b, self, &indices)?);
            let value = |value: Value<Series<Modular<F>>>| value.each(Series::value);
            let (a, b) = residual::pair(value(a), value(b));
            all.extend(a.into_iter().zip(b));
            let mut carried = true;
            for (id, value) in &mut indices {
                *value += 1;
                carried = *value > self.count(*id)?;
                if !carried {
                    break;
                }
                *value = 1;
            }
            if carried {
                return Ok(all);
            }
        }
    }

    /// A random series; a constant has no derivatives.
    fn number(varies: bool) -> Series<Modular<F>> {
        if !varies {
            return Series::constant(Modular::random());
        }
        let derivative = |k: usize| if k == 0 { Modular::random() } else { Modular::random_plain() };
        Series::from_derivatives(&(0..TERMS).map(derivative).collect::<Vec<_>>())
    }
}

impl<F: Modulus> Environment<Series<Modular<F>>> for RandomValues<'_, F> {
    fn symbols(&self) -> &Symbols {
        &self.model.symbols
    }

    fn symbol(&self, id: SymbolId, indices: &[u8]) -> Result<Value<Series<Modular<F>>>, Unavailable> {
        let entry = self.model.symbols.entry(id);
        if entry.slots.len() != indices.len() {
            return Err(Unavailable::Symbol(id));
        }
        if let ([at], Some(_)) = (indices, entry.members.first()) {
            let member = entry.members.get(usize::from(*at) - 1).ok_or(Unavailable::Symbol(id))?;
            return self.symbol(*member, &[]);
        }
        if let Some(known) = self.values.borrow().get(&(id, indices.to_vec())) {
            return Ok(known.clone());
        }
        let is_of_it = |rule: &&Rule| rule.symbol == id && !self.opened.borrow().contains(&id);
        if let Some(Rule { letters, action: Action::Equals(formula), .. }) = self.rules.iter().find(is_of_it) {
            let values: Vec<(IndexId, u8)> = letters.iter().copied().zip(indices.iter().copied()).collect();
            self.opened.borrow_mut().push(id);
            let value = evaluate_to(TERMS, formula, self, &values);
            self.opened.borrow_mut().pop();
            return value;
        }
        let varies = !matches!(self.model.meaning(id), Some(Meaning::Constant(_)));
        let value = match entry.kind {
            Kind::Scalar => Value::Scalar(Self::number(varies)),
            Kind::Vector => Value::Vector(Vector3::from_fn(|_, _| Self::number(varies))),
            Kind::Matrix(rows, columns) => {
                Value::of_matrix(DMatrix::from_fn(rows.into(), columns.into(), |_, _| Self::number(varies)))
            }
            Kind::Complex => Value::Complex(Complex { re: Self::number(varies), im: Self::number(varies) }),
            Kind::Rotation | Kind::Abstract => return Err(Unavailable::Symbol(id)),
        };
        self.values.borrow_mut().insert((id, indices.to_vec()), value.clone());
        Ok(value)
    }

    fn count(&self, index: IndexId) -> Result<u8, Unavailable> {
        let entry = &self.model.symbols.indices[index.0];
        Ok(if entry.count.is_some() { MEMBERS } else { entry.upper })
    }
}

#[cfg(feature = "cli")]
/// Whether one formula vanishes wherever another does, whatever their symbols mean: it is the other times a symbol, or
/// divided by one that `is_never_zero`, or its time derivative.
pub(crate) fn vanishes_with(it: &Expr, other: &Expr, model: &Model, is_never_zero: &impl Fn(&Expr) -> bool) -> bool {
    let times = |a: &Expr, b: &Expr| Expr::new(Node::Product(vec![a.clone(), b.clone()]), a.span);
    let one = Expr::integer(1, it.span);
    let mut factors = vec![one.clone(), one.clone().negated(), Expr::integer(2, it.span)];
    for formula in [it, other] {
        formula.walk(&mut |inner| {
            if matches!(inner.node, Node::Symbol { .. }) && !factors.contains(inner) {
                factors.push(inner.clone());
            }
        });
    }
    let rate = Expr::new(Node::TimeDerivative(1, Box::new(other.clone())), other.span);
    let divisors = std::iter::once(&one).chain(factors[3..].iter().filter(|factor| is_never_zero(factor)));
    let multiple = |divisor: &Expr| {
        let left = times(divisor, it);
        factors.iter().any(|factor| is_identity(&left, &times(factor, other), model))
    };
    is_identity(it, &rate, model) || divisors.into_iter().any(multiple)
}
