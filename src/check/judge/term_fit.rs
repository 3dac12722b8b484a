//! The wrong terms of a refuted equation, where several are wrong at once.
//!
//! All terms are brought to one side, the printed sums expanded, and every term evaluated at sampled states. The values
//! make a matrix, with a row for each number that should vanish and a column for each term. Its null vector gives the
//! coefficients with which the terms add up to zero. If there is exactly one, the coefficients that are not 1 are the
//! result. If there is none, the difference of the sides ([`super::difference`]) is compared with the printed terms one
//! by one: a multiple of a printed term changes its coefficient, and all other terms are missing.
//!
//! The fit only proposes. It is reported if its coefficients are small fractions and the equation with them passes the
//! full check. Terms that depend on each other linearly have no unique fit, and nothing is reported.
//!
//! # What is reported where several terms are wrong
//!
//! No single edit corrects it, so the coefficients that the printed terms would need are computed. The terms at
//! several states are the columns of a matrix, and its null vector is found by a singular value decomposition. With
//! two null vectors nothing is said; with none, the difference in normal form is compared with the printed terms
//! one by one. All this only proposes: what is reported has passed the full check with the coefficients as small
//! fractions.

use nalgebra::DMatrix;

use crate::formula::tree::{Sign, Term};
use crate::formula::{Expr, IndexId, Node};
use crate::scalar::RunningError;
use crate::source::Span;

use crate::check::judge::{difference, identity};
use crate::check::model::Model;
use crate::check::model::claim::{Link, is_equality};
use crate::check::model::order::derivatives;
use crate::check::sample::context::{Context, Options};
use crate::check::state::residual;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Finding, Fit, Fraction, Misfit};

/// The numbers of terms for which a fit is tried.
const TERMS: std::ops::RangeInclusive<usize> = 2..=24;

/// The number of states beyond two for each term.
const SPARE: usize = 8;

/// The relative size of the smallest singular value up to which the terms add up to zero.
const NULL: f64 = 1e-11;

/// The relative size of the next singular value from which the coefficients are unique.
const CLEAR: f64 = 1e-5;

/// The largest distance of a coefficient from its fraction.
const NEAR: f64 = 1e-7;

/// The largest numerator and denominator of a coefficient.
const LARGEST: i32 = 12;

/// The largest number of missing terms.
const MOST_MISSING: usize = 2;

/// The finding, with the terms that must change if the equality is refuted. Spans in the link are those of the text
/// that the span of the context covers.
pub(crate) fn fitted(link: &Link, context: &Context<'_>, finding: Finding) -> Finding {
    let is_wrong = finding.verdict == Verdict::Refuted && is_equality(link.relation);
    let whole = link.lhs.span.to(link.rhs.span);
    let Some(offset) = context.span.start.checked_sub(whole.start).filter(|_| is_wrong && context.options.explain)
    else {
        return finding;
    };
    let printed = Printed { link, context, finding: &finding, leaves: leaves(link) };
    let fit = printed.coefficients().or_else(|| printed.difference());
    let fit = fit.map(|mut fit| {
        fit.terms.iter_mut().for_each(|misfit| misfit.span = misfit.span.shifted(offset));
        fit
    });
    Finding { fit, ..finding }
}

/// A term of an expanded equation.
#[derive(Clone)]
pub(crate) struct Leaf {
    sign: Sign,
    /// The term itself.
    pub expr: Expr,
    /// The printed terms of which it is a part, the outermost first.
    places: Vec<Span>,
    /// Whether it is on the left side.
    on_the_left: bool,
}

impl Leaf {
    /// The term with its sign.
    pub(crate) fn signed(&self) -> Expr {
        if self.sign == Sign::Plus { self.expr.clone() } else { self.expr.clone().negated() }
    }

    /// The sign of the term when all terms are brought to the left.
    pub(crate) fn brought_left(&self) -> f64 {
        if (self.sign == Sign::Plus) == self.on_the_left { 1.0 } else { -1.0 }
    }
}

/// The terms of both sides, without literal zeros.
pub(crate) fn leaves(link: &Link) -> Vec<Leaf> {
    let side = |side: &Expr, on_the_left: bool| {
        let terms = multiplied_out(side);
        let whole = (terms.len() > 1).then_some(side.span);
        let placed = move |leaf: Leaf| {
            let places = whole.into_iter().chain(leaf.places).collect();
            Leaf { places, on_the_left, ..leaf }
        };
        terms.into_iter().filter(|leaf| !leaf.expr.is_null()).map(placed)
    };
    side(&link.lhs, true).chain(side(&link.rhs, false)).collect()
}

/// The expanded terms of a formula. A product of several sums is not expanded, since its terms would have no place of
/// their own.
pub(crate) fn multiplied_out(expr: &Expr) -> Vec<Leaf> {
    if let Node::Sum(terms) = &expr.node {
        let term = |term: &Term| {
            let place = term.sign_span.map_or(term.expr.span, |sign| sign.to(term.expr.span));
            let single = |leaves: &[Leaf]| leaves.len() == 1;
            let mut leaves = multiplied_out(&term.expr);
            if single(&leaves) {
                leaves[0].places.clear();
            }
            for leaf in &mut leaves {
                leaf.places.insert(0, place);
                leaf.sign = if term.sign == Sign::Minus { leaf.sign.flipped() } else { leaf.sign };
            }
            leaves
        };
        return terms.iter().flat_map(term).collect();
    }
    let linear = match &expr.node {
        Node::Product(factors) => factors.len(),
        Node::Dot(..) | Node::Cross(..) => 2,
        Node::Quotient(..)
        | Node::TimeDerivative(..)
        | Node::SumOver { .. }
        | Node::Integral(..)
        | Node::Shrinking(..)
        | Node::Transpose(_)
        | Node::Entry(..)
        | Node::Component(..) => 1,
        _ => 0,
    };
    let inside: Vec<(usize, Vec<Leaf>)> = expr
        .children()
        .into_iter()
        .take(linear)
        .map(multiplied_out)
        .enumerate()
        .filter(|(_, all)| all.len() > 1)
        .collect();
    match <[_; 1]>::try_from(inside) {
        Ok([(at, leaves)]) => {
            let within = |leaf: Leaf| {
                let mut whole = expr.clone();
                *whole.children_mut()[at] = leaf.expr;
                Leaf { expr: whole, ..leaf }
            };
            leaves.into_iter().map(within).collect()
        }
        Err(_) => {
            vec![Leaf { sign: Sign::Plus, expr: expr.clone(), places: vec![expr.span], on_the_left: true }]
        }
    }
}

/// A refuted equality as a list of terms.
struct Printed<'a> {
    link: &'a Link,
    context: &'a Context<'a>,
    finding: &'a Finding,
    leaves: Vec<Leaf>,
}

impl Printed<'_> {
    /// The coefficients with which the printed terms alone make an equation that holds.
    fn coefficients(&self) -> Option<Fit> {
        if !TERMS.contains(&self.leaves.len()) {
            return None;
        }
        let rows = self.values(&[], 2 * self.leaves.len() + SPARE)?;
        let vector = null_vector(rows)?;
        let signed: Vec<f64> = vector.iter().zip(&self.leaves).map(|(c, leaf)| c * leaf.brought_left()).collect();
        let coefficients = scaled(&signed)?;
        self.fit(&coefficients, &[])
    }

    /// The coefficients and the missing terms from the difference of the sides.
    fn difference(&self) -> Option<Fit> {
        let formula = difference::formula(self.link, self.context, self.finding)?;
        let off = multiplied_out(&formula);
        if !TERMS.contains(&(self.leaves.len() + off.len())) {
            return None;
        }
        let rows = self.values(&off, SPARE + off.len())?;
        let count = self.leaves.len();
        let mut coefficients = vec![Fraction::ONE; count];
        let mut missing = Vec::new();
        for (at, term) in off.iter().enumerate() {
            let sign = |leaf: &Leaf| if leaf.sign == Sign::Plus { 1.0 } else { -1.0 };
            let ratio = |k: usize| {
                let ratio = proportion(&rows, count + at, k)? * sign(term) * self.leaves[k].brought_left();
                Fraction::near(1.0 - ratio)
            };
            let partners: Vec<(usize, Fraction)> =
                (0..count).filter(|k| self.may_change(*k)).filter_map(|k| Some((k, ratio(k)?))).collect();
            match partners.as_slice() {
                [] => missing.push(term.clone()),
                [(k, coefficient)] if coefficients[*k] == Fraction::ONE => coefficients[*k] = *coefficient,
                _ => return None,
            }
        }
        let changed = coefficients.iter().filter(|coefficient| **coefficient != Fraction::ONE).count();
        let few = missing.len() <= 1 || missing.len() <= MOST_MISSING && changed + missing.len() < count;
        (few && changed + missing.len() <= count).then_some(())?;
        self.fit(&coefficients, &missing)
    }

    /// Whether a term may be wrong. The name of a derived quantity, and an acceleration on shell, whose value is that
    /// of other terms, may not.
    fn may_change(&self, at: usize) -> bool {
        let (model, expr) = (self.context.model, &self.leaves[at].expr);
        let is_name = expr.as_plain_symbol().is_some() && !model.is_plain(expr);
        !(is_name || self.on_shell() && derivatives(expr, model) > 1)
    }

    fn on_shell(&self) -> bool {
        self.context.on_shell.unwrap_or(true) && self.context.model.has_motion()
    }

    /// The values of the terms, and of others after them, at this number of states: a row for each number that their
    /// equation sets to zero.
    fn values(&self, others: &[Leaf], states: usize) -> Option<DMatrix<f64>> {
        let topic = format!("{} terms", self.context.topic);
        let context = Context { topic: &topic, ..*self.context };
        let all: Vec<&Expr> = self.leaves.iter().chain(others).map(|leaf| &leaf.expr).collect();
        let ensemble = context.ensemble(context.mode(self.on_shell(), &all), false, states).ok()?;
        let mut rows: Vec<f64> = Vec::new();
        for state in &ensemble.states {
            let mut indices: Vec<(IndexId, u8)> = self.link.free.iter().map(|id| (*id, 1)).collect();
            loop {
                rows.extend(row_by_row(&all, &indices, state)?);
                if !residual::advance(&mut indices, state).ok()? {
                    break;
                }
            }
        }
        let height = rows.len() / all.len();
        (height >= states).then(|| DMatrix::from_row_slice(height, all.len(), &rows))
    }

    /// The fit of these coefficients and missing terms, if the equation passes with them.
    fn fit(&self, coefficients: &[Fraction], missing: &[Leaf]) -> Option<Fit> {
        let terms = self.misfits(coefficients)?;
        if terms.is_empty() && missing.is_empty() {
            return None;
        }
        let side = |on_the_left: bool| {
            let own = self.leaves.iter().zip(coefficients).filter(|(leaf, _)| leaf.on_the_left == on_the_left);
            let own = own.filter_map(|(leaf, coefficient)| coefficient.times(leaf));
            let added = missing.iter().filter(|_| !on_the_left).map(|leaf| (leaf.sign, leaf.expr.clone()));
            let terms = own.chain(added).map(|(sign, expr)| Term { sign, sign_span: None, expr });
            let span = if on_the_left { self.link.lhs.span } else { self.link.rhs.span };
            match terms.collect::<Vec<_>>() {
                terms if terms.is_empty() => None,
                terms => Some(Expr::new(Node::Sum(terms), span)),
            }
        };
        // A side that was not 0 must not become 0.
        let corrected = |on_the_left: bool, printed: &Expr| match side(on_the_left) {
            None if printed.is_null() => Some(printed.clone()),
            found => found,
        };
        let link =
            Link { lhs: corrected(true, &self.link.lhs)?, rhs: corrected(false, &self.link.rhs)?, ..self.link.clone() };
        let options = Options { explain: false, ..self.context.options };
        let finding = identity::check(&link, &Context { options, ..*self.context }).ok()?;
        let model: &Model = self.context.model;
        let shown = |leaf: &Leaf| {
            let term = Term { sign: leaf.sign, sign_span: None, expr: leaf.expr.clone() };
            difference::shown(&Expr::new(Node::Sum(vec![term]), leaf.expr.span), model)
        };
        finding.verdict.holds().then(|| Fit { terms, missing: missing.iter().map(shown).collect() })
    }

    /// The widest printed terms with a single coefficient that is not 1; `None` if one has no place of its own.
    fn misfits(&self, coefficients: &[Fraction]) -> Option<Vec<Misfit>> {
        let mut misfits: Vec<Misfit> = Vec::new();
        for (leaf, coefficient) in self.leaves.iter().zip(coefficients).filter(|(_, c)| **c != Fraction::ONE) {
            let alike = |place: &&Span| {
                let mut within = self.leaves.iter().zip(coefficients).filter(|(leaf, _)| leaf.places.contains(place));
                within.all(|(_, other)| other == coefficient)
            };
            let misfit = Misfit { span: *leaf.places.iter().find(alike)?, coefficient: *coefficient };
            if !misfits.contains(&misfit) {
                misfits.push(misfit);
            }
        }
        Some(misfits)
    }
}

/// The values of some terms at a state, a row for each entry; `None` if one has no value or another shape.
fn row_by_row(terms: &[&Expr], indices: &[(IndexId, u8)], state: &SampledState<'_, RunningError>) -> Option<Vec<f64>> {
    let values: Vec<_> = terms.iter().map(|term| state.now(term, indices).ok()).collect::<Option<_>>()?;
    let shape = values.first()?.shape();
    if values.iter().any(|value| value.shape() != shape) {
        return None;
    }
    let entries: Vec<Vec<RunningError>> = values.iter().map(|value| value.entries()).collect();
    let mut rows = Vec::new();
    for entry in 0..entries[0].len() {
        let row: Vec<f64> = entries.iter().map(|term| term[entry].value).collect();
        let scale = row.iter().fold(0.0, |scale: f64, value| scale.max(value.abs()));
        if row.iter().all(|value| value.is_finite()) && scale > 0.0 {
            rows.extend(row.iter().map(|value| value / scale));
        }
    }
    Some(rows)
}

/// The coefficients with which the columns of a matrix add up to zero, if they are unique up to a common factor.
fn null_vector(mut matrix: DMatrix<f64>) -> Option<Vec<f64>> {
    let norms: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
    let width = norms.len();
    if matrix.nrows() < width + SPARE || norms.contains(&0.0) {
        return None;
    }
    matrix.column_iter_mut().zip(&norms).for_each(|(mut column, norm)| column /= *norm);
    let found = matrix.svd(false, true);
    let values = &found.singular_values;
    let is_unique = values[width - 1] <= NULL * values[0] && values[width - 2] >= CLEAR * values[0];
    let rows = found.v_t.filter(|_| is_unique)?;
    Some(rows.row(width - 1).iter().zip(&norms).map(|(c, norm)| c / norm).collect())
}

/// Coefficients as fractions, scaled such that most of them are 1; of several such scales the first.
fn scaled(coefficients: &[f64]) -> Option<Vec<Fraction>> {
    let on = |scale: f64| coefficients.iter().map(move |c| c / scale);
    let ones = |scale: f64| on(scale).filter(|c| (c - 1.0).abs() < NEAR).count();
    let largest = coefficients.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    let scales = coefficients.iter().copied().filter(|c| c.abs() > NEAR * largest);
    let best = scales.reduce(|a, b| if ones(b) > ones(a) { b } else { a })?;
    on(best).map(Fraction::near).collect()
}

/// The constant ratio of two columns, if there is one.
fn proportion(rows: &DMatrix<f64>, of: usize, to: usize) -> Option<f64> {
    let (a, b) = (rows.column(of), rows.column(to));
    let ratio = a.dot(&b) / b.norm_squared();
    let rest = (a - b * ratio).norm();
    (ratio.is_finite() && rest <= NEAR * a.norm()).then_some(ratio)
}

impl Fraction {
    /// The small fraction that is equal to a number, if there is one.
    pub(crate) fn near(value: f64) -> Option<Fraction> {
        (1..=LARGEST).find_map(|denominator| {
            let numerator = (value * f64::from(denominator)).round();
            let is_it =
                (value - numerator / f64::from(denominator)).abs() < NEAR && numerator.abs() <= f64::from(LARGEST);
            is_it.then_some(Fraction { numerator: numerator as i32, denominator })
        })
    }

    /// The product of the fraction and a term, with its sign; `None` if it is zero.
    fn times(self, leaf: &Leaf) -> Option<(Sign, Expr)> {
        let sign = if self.numerator < 0 { leaf.sign.flipped() } else { leaf.sign };
        let span = leaf.expr.span;
        let number = |value: i32| Expr::integer(value.unsigned_abs(), span);
        let factor = match self.denominator {
            1 => number(self.numerator),
            below => Expr::new(Node::Quotient(Box::new(number(self.numerator)), Box::new(number(below))), span),
        };
        let product = || Expr::new(Node::Product(vec![factor, leaf.expr.clone()]), span);
        match (self.numerator, self.denominator) {
            (0, _) => None,
            (1 | -1, 1) => Some((sign, leaf.expr.clone())),
            _ => Some((sign, product())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(rows: &[&[f64]]) -> DMatrix<f64> {
        DMatrix::from_row_slice(rows.len(), rows[0].len(), &rows.concat())
    }

    /// Sixteen states of terms that are functions of a number.
    fn states(terms: &[fn(f64) -> f64]) -> DMatrix<f64> {
        let rows: Vec<Vec<f64>> = (1..=16).map(|x| terms.iter().map(|f| f(f64::from(x) / 7.0)).collect()).collect();
        columns(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>())
    }

    #[test]
    fn what_adds_up_in_one_way_is_found() {
        let found = null_vector(states(&[|x| (2.0 * x).cos(), |x| x.cos().powi(2), |_| 3.0])).unwrap();
        let fractions = scaled(&found).unwrap();
        assert_eq!(fractions.iter().map(ToString::to_string).collect::<Vec<_>>(), ["1", "-2", "1/3"]);
    }

    #[test]
    fn what_adds_up_in_two_ways_or_in_none_is_not() {
        assert_eq!(null_vector(states(&[|x| x, |x| 2.0 * x, |x| x * x, |x| 3.0 * x * x])), None);
        assert_eq!(null_vector(states(&[|x| x, |x| x * x, f64::sin])), None);
        assert_eq!(null_vector(states(&[|x| x, |_| 0.0])), None);
    }

    #[test]
    fn numbers_that_are_no_small_fraction_stay_unnamed() {
        assert_eq!(Fraction::near(std::f64::consts::FRAC_1_SQRT_2), None);
        assert_eq!(Fraction::near(-1.5).map(|f| f.to_string()), Some("-3/2".to_owned()));
        assert_eq!(Fraction::near(1e-9).map(|f| f.to_string()), Some("0".to_owned()));
    }
}
