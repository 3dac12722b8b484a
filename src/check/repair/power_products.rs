//! Fits of values by a product of powers.
//!
//! The logarithm of a product of powers is linear in the logarithms of its factors. So the exponents come from one QR
//! decomposition (modified Gram–Schmidt) of the factors, and one back substitution for each list of values.

use crate::formula::symbols::Entry;
use crate::formula::tree::{Function, Sign, Term};
use crate::formula::{Expr, Kind, Node, SymbolId, Symbols};
use crate::latex::slips::Pool;
use crate::latex::{names, read_formula, typeset};
use crate::scalar::RunningError;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::judge::difference;
use crate::check::state::sampled_state::SampledState;
use crate::check::trial::failed_display::{FailedDisplay, MISSING};
use crate::check::verdict::finding::Fraction;

/// The number of states that are fitted; the fit must hold at the other states too.
const FITTED: usize = 2 * STATES / 3;

/// The largest number of factors, half the number of fitted states.
const MOST: usize = FITTED / 2;

/// The largest distance of an exponent from a whole number.
const WHOLE: f64 = 1e-6;

/// The highest power of a factor; authors do not omit higher ones.
const HIGHEST: i32 = 4;

/// The largest number of factors in a product, powers counted.
const LONGEST: usize = 8;

/// The factors that a missing term may contain, with their values. Their logarithms are linearly independent.
pub(crate) struct Factors<'d> {
    symbols: &'d Symbols,
    all: Vec<Factor>,
    /// The orthonormal vectors of the decomposition: the constant one, then one for each factor.
    directions: Vec<Vec<f64>>,
    /// The components of the logarithms of each factor along these vectors, a triangular matrix.
    triangle: Vec<Vec<f64>>,
}

struct Factor {
    /// The factor as the notes print it.
    latex: String,
    expr: Expr,
    values: Vec<f64>,
}

/// A product of powers that fits the values.
pub(crate) struct Product {
    /// The LaTeX of the product, without its sign.
    pub latex: String,
    /// The length of the product, as the number of its factors and numbers.
    pub cost: usize,
    /// The factors of the numerator.
    pub above: Vec<Expr>,
    /// The factors of the denominator.
    pub below: Vec<Expr>,
    number: Fraction,
    factors: usize,
}

impl Product {
    /// Whether the product has no factors.
    pub fn is_number(&self) -> bool {
        self.factors == 0
    }

    /// Whether the number in the product is negative.
    pub fn is_negative(&self) -> bool {
        self.number.numerator < 0
    }

    /// A formula of the product without its sign, with its sign.
    pub fn signed(&self, typeset: Expr) -> Expr {
        if self.is_negative() { typeset.negated() } else { typeset }
    }
}

impl<'d> Factors<'d> {
    /// The factors in the display and in the document, then the names of the document and their rates.
    pub fn of(checker: &'d Checker<'_>, wrong: &FailedDisplay<'_>, states: &[SampledState<'_, RunningError>]) -> Self {
        let (symbols, macros) = (&checker.model.symbols, &checker.model.macros);
        let texts = checker.notes.equations.iter().map(|display| display.text.as_str());
        let printed = [
            Pool::of(std::iter::once(wrong.text), symbols, macros, MISSING),
            Pool::of(texts, symbols, macros, MISSING),
        ];
        let mut candidates: Vec<(String, Expr)> = Vec::new();
        let mut add = |latex: Option<&str>, expr: &Expr| {
            if !candidates.iter().any(|(_, known)| known == expr) {
                let latex = latex.map_or_else(|| typeset(expr, symbols), str::to_owned);
                candidates.push((latex, expr.clone()));
            }
        };
        let read = |latex: &str| read_formula(latex, &mut symbols.clone(), macros).ok();
        for latex in printed.iter().flat_map(Pool::factors) {
            let Some(whole) = read(latex) else { continue };
            let mut parts = Vec::new();
            bases(&whole, &mut parts);
            parts.iter().for_each(|part| add((**part == whole).then_some(latex), part));
        }
        // Names come before rates, because a rate often equals other factors by the motion.
        named(symbols).iter().for_each(|expr| add(None, expr));
        // The printed names with other numbers of dots.
        for latex in printed.iter().flat_map(Pool::factors) {
            let Some((name, _)) = names::parse(latex) else { continue };
            for latex in (0..=2).filter_map(|dots| names::with_dots(&name, dots)).map(|name| name.to_string()) {
                let found = read(&latex);
                found
                    .iter()
                    .filter(|expr| expr.as_plain_symbol().is_none_or(|id| !symbols.entry(id).angle))
                    .for_each(|expr| add(Some(&latex), expr));
            }
        }
        rates(symbols).iter().for_each(|expr| add(None, expr));
        let mut factors = Factors { symbols, all: Vec::new(), directions: Vec::new(), triangle: Vec::new() };
        let constant = vec![(FITTED as f64).sqrt().recip(); FITTED];
        factors.directions.push(constant);
        if states.len() < STATES {
            return factors;
        }
        for (latex, expr) in candidates {
            if factors.all.len() == MOST {
                break;
            }
            let value = |state| difference::value(&expr, state).map(|value| value.value).filter(|value| *value != 0.0);
            let Some(values) = states.iter().map(value).collect::<Option<Vec<f64>>>() else { continue };
            factors.add(latex, expr, values);
        }
        factors
    }

    /// Adds a factor, unless it is a product of powers of the known factors.
    fn add(&mut self, latex: String, expr: Expr, values: Vec<f64>) {
        let logarithms: Vec<f64> = values.iter().take(FITTED).map(|value| value.abs().ln()).collect();
        let (along, mut rest) = self.projected(&logarithms);
        let size = norm(&rest);
        if size > 1e-6 * norm(&logarithms) {
            rest.iter_mut().for_each(|entry| *entry /= size);
            self.directions.push(rest);
            self.triangle.push(along.into_iter().chain([size]).collect());
            self.all.push(Factor { latex, expr, values });
        }
    }

    /// The components of a vector along the orthonormal vectors, and the rest.
    fn projected(&self, vector: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut rest = vector.to_vec();
        let mut along = vec![0.0; self.directions.len()];
        // The second pass removes the rounding errors of the first.
        for _ in 0..2 {
            for (direction, along) in self.directions.iter().zip(&mut along) {
                let share: f64 = direction.iter().zip(&rest).map(|(a, b)| a * b).sum();
                rest.iter_mut().zip(direction).for_each(|(entry, direction)| *entry -= share * direction);
                *along += share;
            }
        }
        (along, rest)
    }

    /// The product of powers that has these values at these states.
    pub fn fitted(&self, states: &[usize], values: &[f64]) -> Option<Product> {
        if states.len() < STATES || self.all.is_empty() {
            return None;
        }
        let logarithms: Vec<f64> = values.iter().take(FITTED).map(|value| value.abs().ln()).collect();
        let (mut along, rest) = self.projected(&logarithms);
        if norm(&rest) > WHOLE * (1.0 + norm(&logarithms)) {
            return None;
        }
        let mut powers = vec![0; self.all.len()];
        for at in (0..self.all.len()).rev() {
            let column = &self.triangle[at];
            let power = along[at + 1] / column[at + 1];
            if (power - power.round()).abs() > WHOLE || power.abs() > f64::from(HIGHEST) + 0.5 {
                return None;
            }
            along.iter_mut().zip(column).for_each(|(rest, entry)| *rest -= power.round() * entry);
            powers[at] = power.round() as i32;
        }
        if powers.iter().map(|power| power.unsigned_abs() as usize).sum::<usize>() > LONGEST {
            return None;
        }
        let product = |state: usize| -> f64 {
            self.all.iter().zip(&powers).map(|(factor, power)| factor.values[state].powi(*power)).product()
        };
        let number = Fraction::near(values[0] / product(0)).filter(|number| number.numerator != 0)?;
        let near =
            |(state, value): (usize, &f64)| (number.value() * product(state) - value).abs() <= NEAR * value.abs();
        values.iter().enumerate().all(near).then(|| self.typeset(number, &powers))
    }

    /// The order of factors in a product: constants, sums, varying quantities, functions; names as they are declared.
    fn place(&self, expr: &Expr) -> (u8, usize) {
        match &expr.node {
            Node::Symbol { id, .. } if self.symbols.entry(*id).varies => (2, id.0),
            Node::Symbol { id, .. } => (0, id.0),
            Node::Sum(_) => (1, 0),
            Node::Call(_, argument) => (3, argument.as_plain_symbol().map_or(usize::MAX, |id| id.0)),
            _ => (2, usize::MAX),
        }
    }

    fn typeset(&self, mut number: Fraction, powers: &[i32]) -> Product {
        let (mut above, mut below, mut cost) = (Vec::new(), Vec::new(), 0);
        let mut used: Vec<(&Factor, i32)> = self.all.iter().zip(powers.iter().copied()).collect();
        used.retain(|(_, power)| *power != 0);
        used.sort_by_key(|(factor, _)| self.place(&factor.expr));
        let (multiplies, divides): (Vec<_>, Vec<_>) =
            used.iter().map(|(factor, power)| (factor.expr.clone(), *power)).partition(|(_, power)| *power > 0);
        let [multiplies, divides] =
            [multiplies, divides].map(|part| part.into_iter().map(|(expr, _)| expr).collect::<Vec<Expr>>());
        for (factor, power) in used {
            let raised = |n: u32| {
                let [base, power] = [factor.expr.clone(), Expr::integer(n, Span::default())].map(Box::new);
                typeset(&Expr::new(Node::Power(base, power), Span::default()), self.symbols)
            };
            let latex = match (power.unsigned_abs(), turned(&factor.expr)) {
                // −(a − b) is b − a.
                (1, Some(other)) if number.numerator < 0 => {
                    number.numerator = -number.numerator;
                    format!("({})", typeset(&other, self.symbols))
                }
                (1, _) if matches!(factor.expr.node, Node::Sum(_)) => {
                    format!("({})", typeset(&factor.expr, self.symbols))
                }
                (1, _) => factor.latex.clone(),
                (n, _) => raised(n),
            };
            let part = if power > 0 { &mut above } else { &mut below };
            part.push(latex);
            cost += power.unsigned_abs() as usize + usize::from(power < 0);
        }
        let factors = above.len() + below.len();
        cost += usize::from(number.numerator.abs() != 1) + usize::from(number.denominator != 1);
        let latex = quotient(number, above, below);
        Product { latex, cost, above: multiplies, below: divides, number, factors }
    }
}

/// A product over another one, with the size of a number before it.
fn quotient(number: Fraction, mut above: Vec<String>, mut below: Vec<String>) -> String {
    let (n, m) = (number.numerator.unsigned_abs(), number.denominator);
    match (below.is_empty(), m) {
        (true, 2..) => above.insert(0, format!("\\frac{{{n}}}{{{m}}}")),
        _ if n != 1 || above.is_empty() => above.insert(0, n.to_string()),
        _ => {}
    }
    if !below.is_empty() && m != 1 {
        below.insert(0, m.to_string());
    }
    let [above, below] = [above, below].map(|part| part.join(" \\, "));
    if below.is_empty() { above } else { format!("\\frac{{{above}}}{{{below}}}") }
}

/// The LaTeX of a number that is a fraction or the square root of one.
pub(crate) fn constant(value: f64) -> Option<String> {
    let fraction = |(above, below): (String, String)| match below.as_str() {
        "1" => above,
        _ => format!("\\frac{{{above}}}{{{below}}}"),
    };
    if let Some(Fraction { numerator, denominator }) = Fraction::near(value) {
        return Some(fraction((numerator.to_string(), denominator.to_string())));
    }
    let square = Fraction::near(value * value)?;
    let root = |n: u32| {
        let whole = f64::from(n).sqrt();
        if whole.fract() == 0.0 { whole.to_string() } else { format!("\\sqrt{{{n}}}") }
    };
    Some(fraction((root(square.numerator.unsigned_abs()), root(square.denominator.unsigned_abs()))))
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}

/// Collects the factors of a formula, without their powers.
pub(crate) fn bases<'e>(expr: &'e Expr, into: &mut Vec<&'e Expr>) {
    match &expr.node {
        Node::Product(factors) => factors.iter().for_each(|factor| bases(factor, into)),
        Node::Quotient(a, b) => [a, b].into_iter().for_each(|part| bases(part, into)),
        Node::Power(base, _) | Node::Root(_, base) => bases(base, into),
        Node::Number(_) => {}
        _ => into.push(expr),
    }
}

/// The difference b − a for a − b.
fn turned(expr: &Expr) -> Option<Expr> {
    match &expr.node {
        Node::Sum(terms) => match terms.as_slice() {
            [Term { sign: Sign::Plus, expr: a, .. }, Term { sign: Sign::Minus, expr: b, .. }] => {
                Some(b.clone().minus(a.clone()))
            }
            _ => None,
        },
        _ => None,
    }
}

/// The symbols that are numbers, each with its entry.
fn numbers(symbols: &Symbols) -> impl Iterator<Item = (SymbolId, &Entry)> {
    symbols.iter().filter(|(_, entry)| !entry.is_composed()).filter(|(_, entry)| {
        entry.kind == Kind::Scalar && entry.slots.is_empty() && !entry.squared && entry.measure.is_none()
    })
}

fn name(id: SymbolId, dots: u8) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, Span::default())
}

/// The names of a document, sines and cosines of its angles, and differences of constants with the same letter.
fn named(symbols: &Symbols) -> Vec<Expr> {
    let of_an_angle = |id: SymbolId| {
        let call = move |function| Expr::new(Node::Call(function, Box::new(name(id, 0))), Span::default());
        [Function::Sin, Function::Cos].map(call)
    };
    let mut all: Vec<Expr> = Vec::new();
    for (id, entry) in numbers(symbols) {
        if entry.angle { all.extend(of_an_angle(id)) } else { all.push(name(id, 0)) }
    }
    let like = |a: &Entry, b: &Entry| {
        a.name.base == b.name.base && !a.varies && !b.varies && !a.name.subscript.is_empty() && a.name < b.name
    };
    for (a, one) in numbers(symbols) {
        let others = numbers(symbols).filter(|(_, other)| like(other, one));
        all.extend(others.map(|(b, _)| name(a, 0).minus(name(b, 0))));
    }
    all
}

/// The first and second rates of all varying names.
fn rates(symbols: &Symbols) -> Vec<Expr> {
    let varying = numbers(symbols).filter(|(_, entry)| entry.varies);
    varying.flat_map(|(id, _)| [name(id, 1), name(id, 2)]).collect()
}

/// The number of states. Two thirds are fitted, the others confirm the fit.
pub(crate) const STATES: usize = 72;

/// The relative size below which a value counts as zero in a proposal.
pub(crate) const NEAR: f64 = 1e-9;
