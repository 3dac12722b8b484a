//! Terms and factors that are missing in a wrong equation and occur nowhere else in the document, computed from
//! what is true.
//!
//! A value is looked for as a product of powers ([`super::lost_products`]), in normal form, which may be a sum, and
//! among vectors ([`super::lost_vectors`]). All this only proposes: every proposed edit gets the full check.
//!
//! # How something is found that stands nowhere else
//!
//! An author who leaves out the only `MgR` of the notes leaves nothing to copy. So two numbers are put into every
//! place where a term or a factor may have stood. Where the equation is linear in it, each state gives the value
//! that it must have had. The values are fitted by a product of powers: its logarithm is linear, so one orthogonal
//! decomposition of the logarithms of the document's symbols serves all places. 48 states determine at most 24
//! exponents, which must be whole; 24 further states confirm them; then comes the full check. What is no product is
//! taken from the normal form. In a vector equation the same is asked for a multiple of each vector of the
//! document; all components must agree on it. Any wrong equation can be made true by adding the difference. So
//! nothing is inserted that removes a printed term or factor, neither in its own sum nor as all of the other side.

use std::cell::OnceCell;

use crate::Result;
use crate::formula::{Expr, Node, text};
use crate::latex::slips::{Edit, InsertionPoint, Slip};
use crate::latex::{Reading, read_formula, slips, typeset};
use crate::notes::claims::{Claim, Holds};
use crate::scalar::{DualNum, RunningError, Symbol, TERMS};
use crate::source::Span;

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::reread;
use crate::check::judge::difference;
use crate::check::judge::difference::{entries, normal};
use crate::check::judge::term_fit::{leaves, multiplied_out};
use crate::check::model::claim::{Link, is_equality};
use crate::check::model::sampling::Spread;
use crate::check::repair::lost_products::{Factors, NEAR, STATES, bases, constant};
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::state::sampled_state::SampledState;
use crate::check::trial::trial_text::tested;
use crate::check::trial::wrong::Wrong;
use crate::check::verdict::finding::Fraction;

/// So many states off shell tell what is so on shell alone.
const FEW: usize = 8;

/// So many edits are proposed at most, the shortest formulas first.
const PROPOSED: usize = 12;

/// What was left out of a sum has so many terms.
const MOST_TERMS: usize = 2;

/// What was left out of a product has so many factors, a power counted once.
const MOST_FACTORS: usize = 4;

/// Nobody leaves out a sum of more letters.
const LONGEST: usize = 64;

/// What a link is off by, entry after entry: left side minus right side, on the scale of the terms in both.
type Rows = Vec<RunningError>;

/// A wrong equation, at its states.
pub(crate) struct Lost<'w, 'a> {
    pub(crate) checker: &'w Checker<'a>,
    pub(crate) wrong: &'w Wrong<'w>,
    pub(crate) ensemble: Ensemble<'w>,
    /// States off shell, where those are on shell.
    anywhere: Option<Ensemble<'w>>,
    /// By how much it is off at each state, where it has a value.
    off: Vec<Option<Rows>>,
    factors: OnceCell<Factors<'w>>,
    /// The vectors that stand in the document.
    pub(crate) directions: OnceCell<Vec<String>>,
}

/// What should stand in a hole: its value at each state, and by how much the equation changes with it.
pub(crate) struct Needed {
    /// Which of the rows says so.
    pub(crate) row: usize,
    /// How many there are.
    rows: usize,
    values: Vec<f64>,
    slopes: Vec<f64>,
    /// Which states these are.
    states: Vec<usize>,
}

/// What should stand in a hole.
pub(crate) struct Found {
    pub(crate) sign: char,
    /// Without its sign.
    pub(crate) latex: String,
    /// How much it is to read.
    pub(crate) cost: usize,
    /// A sum of several terms, as it is typeset with the sign of its first term.
    pub(crate) sum: Option<String>,
}

/// A proposal, with what ranks it: how much was left out, and in how empty a place.
pub(crate) struct Proposal {
    cost: usize,
    edit: Edit,
}

/// The edits that put something into a wrong equation with which it may hold, the simplest first.
///
/// # Errors
/// For a claim that does not fit the notes.
pub(crate) fn edits(checker: &Checker<'_>, wrong: &Wrong<'_>) -> Result<Vec<Edit>> {
    let (hypotheses, local) = (checker.hypotheses(wrong.claim)?, checker.local(wrong.claim)?);
    let topic = format!("{} lost", crate::check::document::names::shown(&checker.notes.equations[wrong.at]));
    let context = Context {
        model: checker.model,
        options: checker.options,
        hypotheses: &hypotheses,
        on_shell: None,
        topic: &topic,
        span: crate::source::Span::default(),
        spread: Spread::Declared,
        local: &local,
    };
    let always = wrong.claim.holds.as_ref().is_some_and(|holds| holds.value == Holds::Always);
    let members: Vec<&Expr> = wrong.reading.statements.iter().flatten().flat_map(|s| &s.members).collect();
    let mut mode = context.mode(!always && checker.model.has_motion(), &members);
    mode.order = (mode.order + 1).clamp(3, TERMS - 1);
    let Ok(ensemble) = context.ensemble(mode, false, STATES) else { return Ok(Vec::new()) };
    let off_shell = mode.on_shell.then(|| context.ensemble(context.mode(false, &members), false, FEW));
    let anywhere = off_shell.and_then(Result::ok);
    let off = ensemble.states.iter().map(|state| residuals(checker, wrong.claim, wrong.reading, state)).collect();
    let lost = Lost { checker, wrong, ensemble, anywhere, off, factors: OnceCell::new(), directions: OnceCell::new() };
    let mut proposals = lost.proposals();
    proposals.sort_by_key(|proposal| proposal.cost);
    proposals.truncate(PROPOSED);
    Ok(proposals.into_iter().map(|proposal| proposal.edit).collect())
}

/// By how much all that is claimed in a reading is off at a state; none, where it has no value or claims something else
/// than equality.
fn residuals(
    checker: &Checker<'_>,
    claim: &Claim,
    reading: &Reading,
    state: &SampledState<'_, RunningError>,
) -> Option<Rows> {
    let mut rows = Vec::new();
    for n in 0..reading.statements.len() {
        if reading.statements[n].is_err() {
            return None;
        }
        for link in tested(checker, (reading, n), claim) {
            if !is_equality(link.relation) {
                return None;
            }
            let sides = entries(&link, state).ok()?;
            rows.extend(sides.into_iter().map(|(a, b)| a - b));
        }
    }
    Some(rows).filter(|rows| rows.iter().all(|row| row.value.is_finite()))
}

pub(crate) fn is_small(value: f64, row: &RunningError) -> bool {
    value.abs() <= NEAR * row.magnitude
}

impl<'w, 'a> Lost<'w, 'a> {
    fn proposals(&self) -> Vec<Proposal> {
        let model = self.checker.model;
        let mut proposals = Vec::new();
        for hole in slips::insertion_points(self.wrong.text, &model.symbols, &model.macros) {
            let [one, two] = self.fillings(hole).map(|filling| self.reading(&hole.filled('+', filling)));
            if one.statements.iter().any(std::result::Result::is_err) {
                if hole.slip == Slip::Term {
                    let named = self.vectors(hole);
                    proposals.extend(if named.is_empty() { self.multiples(hole) } else { named });
                }
                continue;
            }
            let Some(needed) = self.needed(hole, &one, &two) else { continue };
            let Some((link, row)) = self.link(self.wrong.reading, needed.row) else { continue };
            proposals.extend(self.number(hole, &needed));
            let found = self.formula(hole, &needed, (&link, row), &one);
            proposals.extend(found.map(|found| self.proposal(hole, found.sign, &found.latex, found.cost)));
        }
        proposals
    }

    /// What is put into a hole to see what the equation makes of it; a factor that is not there is 1.
    fn fillings(&self, hole: InsertionPoint) -> [&'static str; 2] {
        if hole.slip == Slip::Term { ["1", "2"] } else { ["(2)", "(3)"] }
    }

    pub(crate) fn reading(&self, edit: &Edit) -> Reading {
        let text = edit.applied(self.wrong.text);
        reread::read(self.checker, &self.checker.model.macros, self.wrong.at, &text, self.wrong.claim)
    }

    pub(crate) fn residuals(&self, reading: &Reading, scene: &SampledState<'_, RunningError>) -> Option<Rows> {
        residuals(self.checker, self.wrong.claim, reading, scene)
    }

    /// The value that a hole must have at each state, where it enters linearly and all rows agree on it.
    pub(crate) fn needed(&self, hole: InsertionPoint, one: &Reading, two: &Reading) -> Option<Needed> {
        let mut needed =
            Needed { row: usize::MAX, rows: 0, values: Vec::new(), slopes: Vec::new(), states: Vec::new() };
        for (at, scene) in self.ensemble.states.iter().enumerate() {
            let Some(off) = &self.off[at] else { continue };
            let (Some(first), Some(second)) = (self.residuals(one, scene), self.residuals(two, scene)) else {
                continue;
            };
            if first.len() != off.len() || second.len() != off.len() {
                return None;
            }
            let slope = |row: usize| first[row].value - off[row].value;
            if needed.row == usize::MAX {
                let share = |row: &usize| (slope(*row) / first[*row].magnitude).abs();
                let changed = (0..off.len()).filter(|row| !is_small(slope(*row), &first[*row]));
                needed.row = changed.max_by(|a, b| share(a).total_cmp(&share(b)))?;
                needed.rows = off.len();
            }
            // With as many rows as there are particles at a state, a row is not the same at each.
            if off.len() != needed.rows {
                return None;
            }
            let before = -off[needed.row].value / slope(needed.row);
            for row in 0..off.len() {
                let is_linear = is_small(second[row].value - first[row].value - slope(row), &second[row]);
                let rest = off[row].value + before * slope(row);
                let scale = off[row].magnitude + (before * slope(row)).abs();
                if !is_linear || rest.abs() > NEAR * scale {
                    return None;
                }
            }
            needed.values.push(if hole.slip == Slip::Term { before } else { before + 1.0 });
            needed.slopes.push(slope(needed.row));
            needed.states.push(at);
        }
        let is_known = needed.values.iter().all(|value| value.is_finite() && *value != 0.0);
        (is_known && 4 * needed.states.len() >= 3 * STATES).then_some(needed)
    }

    /// The link of a reading that a row belongs to, and which of its rows that is.
    pub(crate) fn link(&self, reading: &Reading, row: usize) -> Option<(Link, usize)> {
        let scene = self.ensemble.states.first()?;
        let mut start = 0;
        for link in (0..reading.statements.len()).flat_map(|n| tested(self.checker, (reading, n), self.wrong.claim)) {
            let count = entries(&link, scene).ok()?.len();
            if row < start + count {
                return Some((link, row - start));
            }
            start += count;
        }
        None
    }

    /// Whether a term of what is put into a hole only takes away what is printed, or is a multiple of it: then that is wrong,
    /// and nothing was lost.
    fn undoes(&self, term: &Expr, hole: InsertionPoint, link: &Link, needed: &Needed) -> bool {
        let Some(values) = self.values(term, &needed.states) else { return true };
        leaves(link).iter().any(|leaf| {
            let Some(printed) = self.values(&leaf.expr, &needed.states) else { return false };
            let printed = printed.iter().map(|value| value * leaf.brought_left());
            let changes = values.iter().zip(&needed.slopes).map(|(value, slope)| value * slope);
            let ratios: Vec<f64> = changes.zip(printed).map(|(change, printed)| change / printed).collect();
            let ratio = ratios[0];
            if ratios.iter().any(|other| (other - ratio).abs() > NEAR * ratio.abs()) {
                return false;
            }
            let is_term = hole.slip == Slip::Term;
            (ratio + 1.0).abs() < NEAR && self.is_so_anywhere(term, &leaf.expr)
                || is_term && self.is_multiple(term, &leaf.expr, &needed.states)
        })
    }

    /// Whether two numbers, if they are proportional on shell, are so off shell: what the motion makes of a printed term is what
    /// the author lost, as in `\ddot\theta = 0`.
    fn is_so_anywhere(&self, a: &Expr, b: &Expr) -> bool {
        let Some(anywhere) = &self.anywhere else { return true };
        let is_constant = |ensemble: &Ensemble<'_>| {
            let value = |expr, scene| difference::value(expr, scene).map(|value| value.value);
            let ratios = ensemble.states.iter().map(|scene| Some(value(a, scene)? / value(b, scene)?));
            let ratios: Option<Vec<f64>> = ratios.collect();
            let Some([first, others @ ..]) = ratios.as_deref() else { return true };
            others.iter().all(|other| (other - first).abs() <= NEAR * first.abs())
        };
        !is_constant(&self.ensemble) || is_constant(anywhere)
    }

    /// Whether one of these is a factor that stands beside a hole: to divide by it takes it away.
    fn cancels(&self, divisors: &[Expr], hole: InsertionPoint) -> bool {
        let (symbols, macros) = (&self.checker.model.symbols, &self.checker.model.macros);
        let read = read_formula(&self.wrong.text[hole.whole.range()], &mut symbols.clone(), macros);
        let Ok(printed) = read else { return !divisors.is_empty() };
        let mut factors = Vec::new();
        bases(&printed, &mut factors);
        divisors.iter().any(|divisor| factors.contains(&divisor))
    }

    /// Whether a term is a number times another, whatever their symbols mean.
    fn is_multiple(&self, term: &Expr, of: &Expr, states: &[usize]) -> bool {
        let (Some(a), Some(b)) = (self.values(term, states), self.values(of, states)) else { return false };
        let times = |n: i32, expr: &Expr| {
            let product =
                Expr::new(Node::Product(vec![Expr::integer(n.unsigned_abs(), expr.span), expr.clone()]), expr.span);
            if n < 0 { product.negated() } else { product }
        };
        Fraction::near(a[0] / b[0]).is_some_and(|ratio| {
            formulas::same(&times(ratio.denominator, term), &times(ratio.numerator, of), self.checker.model)
        })
    }

    /// The values of a number at some states.
    fn values(&self, expr: &Expr, states: &[usize]) -> Option<Vec<f64>> {
        let at = |state: &usize| difference::value(expr, &self.ensemble.states[*state]).map(|value| value.value);
        states.iter().map(at).collect()
    }

    /// The number that was left out of a product which has none.
    fn number(&self, hole: InsertionPoint, needed: &Needed) -> Option<Proposal> {
        let (whole, first) = (&self.wrong.text[hole.whole.range()], *needed.values.first()?);
        let is_one = needed.values.iter().all(|value| (value - first).abs() <= NEAR * first.abs());
        if hole.slip == Slip::Term || !is_one || first < 0.0 || whole.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let replacement = format!("{} \\, ", constant(first)?);
        let edit = Edit { span: Span::at(hole.whole.start), replacement, slip: Slip::Factor };
        Some(Proposal { cost: 2, edit })
    }

    /// What should stand in a hole, which a reading has filled with 1: a product of powers, or a normal form.
    pub(crate) fn formula(
        &self,
        hole: InsertionPoint,
        needed: &Needed,
        link: (&Link, usize),
        one: &Reading,
    ) -> Option<Found> {
        self.product(hole, needed, link.0).or_else(|| self.sum(hole, needed, link, one))
    }

    /// What should stand in a hole as a product of powers.
    fn product(&self, hole: InsertionPoint, needed: &Needed, link: &Link) -> Option<Found> {
        let factors = self.factors.get_or_init(|| Factors::of(self.checker, self.wrong, &self.ensemble.states));
        let product = factors.fitted(&needed.states, &needed.values)?;
        if hole.slip == Slip::Factor && product.is_number() {
            return None;
        }
        let symbols = &self.checker.model.symbols;
        let read = read_formula(&product.latex, &mut symbols.clone(), &self.checker.model.macros);
        let adds = |term: Expr| !self.undoes(&product.signed(term), hole, link, needed);
        if hole.slip == Slip::Term && !read.is_ok_and(adds) {
            return None;
        }
        let sign = if product.is_negative() { '-' } else { '+' };
        let is_other_side = |side: &Expr| product.above.iter().any(|factor| factor == side);
        let restates = is_other_side(&link.lhs) || is_other_side(&link.rhs);
        // Nobody leaves out a quotient by a sum or by a rate, or many factors at once.
        let is_rate = |factor: &Expr| matches!(factor.node, Node::Symbol { dots: 1.., .. });
        let divides = product.below.iter().any(|factor| matches!(factor.node, Node::Sum(_)) || is_rate(factor));
        let is_far = divides || product.above.len() + product.below.len() > MOST_FACTORS;
        let undoes = || sign == '-' || restates || is_far || self.cancels(&product.below, hole);
        if hole.slip == Slip::Factor && undoes() {
            return None;
        }
        Some(Found { sign, latex: product.latex, cost: product.cost, sum: None })
    }

    pub(crate) fn proposal(&self, hole: InsertionPoint, sign: char, latex: &str, cost: usize) -> Proposal {
        // Of a sum that is left something was lost sooner than beside what stands alone.
        let place = usize::from(hole.beside == 1) + usize::from(sign == '-');
        Proposal { cost: 2 * cost + place, edit: hole.filled(sign, latex) }
    }

    /// What should stand in a hole in normal form, where the states are made of symbols.
    fn sum(&self, hole: InsertionPoint, needed: &Needed, (link, row): (&Link, usize), one: &Reading) -> Option<Found> {
        let (one, _) = self.link(one, needed.row)?;
        let off = |link: &Link, scene: &SampledState<'_, Symbol>| {
            let sides = entries(link, scene).ok()?.get(row).copied()?;
            Some(sides.0 - sides.1)
        };
        let missing = |scene: &SampledState<'_, Symbol>| {
            let (before, after) = (off(link, scene)?, off(&one, scene)?);
            let slope = after - before;
            let above = if hole.slip == Slip::Term { -before } else { slope - before };
            Some((above * slope.recip(), Symbol::from(0.0)))
        };
        let model = self.checker.model;
        let found = normal(model, &self.ensemble, link, &missing)?;
        let length = text::formula(&found, &model.symbols).chars().count();
        let mut is_whole = true;
        found.walk(&mut |part| is_whole &= !matches!(part.node, Node::Quotient(..)));
        // A factor that is a sum is no sum of quotients: that would be another term over the one that is printed.
        // Nobody leaves out three terms at once.
        let is_long = hole.slip == Slip::Term && matches!(&found.node, Node::Sum(terms) if terms.len() > MOST_TERMS);
        if length > LONGEST || is_long || hole.slip == Slip::Factor && !is_whole {
            return None;
        }
        let near = |(a, b): (f64, &f64)| (a - b).abs() <= NEAR * b.abs();
        if !self.values(&found, &needed.states)?.into_iter().zip(&needed.values).all(near) {
            return None;
        }
        if multiplied_out(&found).iter().any(|leaf| self.undoes(&leaf.signed(), hole, link, needed)) {
            return None;
        }
        let typed = typeset(&found, &model.symbols);
        let (sign, latex) = match (&found.node, hole.slip) {
            (Node::Sum(terms), Slip::Factor) if terms.len() > 1 => ('+', format!("\\left({typed}\\right)")),
            (Node::Sum(_), Slip::Factor) => return None,
            _ => match typed.strip_prefix('-') {
                Some(rest) => ('-', rest.trim_start().to_owned()),
                None => ('+', typed.clone()),
            },
        };
        let sum = matches!(&found.node, Node::Sum(terms) if terms.len() > 1).then_some(typed);
        Some(Found { sign, latex, cost: length, sum })
    }
}
