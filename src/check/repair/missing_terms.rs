//! Missing terms and factors of a wrong equation, found from the values that they must have.
//!
//! Each place where a term or a factor may be missing ([`slips::holes`]) is filled with two numbers. If the equation is
//! linear in the filling, each state then gives the value that the missing part must have. The values are fitted by a
//! product of powers of quantities in the document ([`super::power_products`]) or, with symbolic states, by a normal form
//! ([`difference`]), which may be a sum. In sums of vectors, the vectors of the document, their rates and their products are
//! tried ([`super::missing_vectors`]).
//!
//! This only proposes edits: values are fitted at some states and confirmed at others, and each edit gets the full check.
//! A term that only cancels a printed term is not proposed, since then the printed term is wrong and none is missing.
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
use crate::formula::{Expr, Node, SymbolId, text};
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
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::repair::power_products::{Factors, NEAR, STATES, bases, constant};
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::state::sampled_state::SampledState;
use crate::check::trial::failed_display::FailedDisplay;
use crate::check::trial::text_trial::tested_links;
use crate::check::verdict::finding::Fraction;

/// The number of states off shell, which show what holds on shell only.
const FEW: usize = 8;

/// The largest number of proposed edits, the shortest formulas first.
const PROPOSED: usize = 12;

/// The largest number of missing terms.
const MOST_TERMS: usize = 2;

/// The largest number of missing factors, a power counted once.
const MOST_FACTORS: usize = 4;

/// The largest number of characters in a missing sum.
const LONGEST: usize = 64;

/// The residuals of links: left side minus right side, entry by entry, with the magnitude of the terms.
type Rows = Vec<RunningError>;

/// A wrong equation with its sampled states.
pub(crate) struct MissingPart<'w, 'a> {
    pub(crate) checker: &'w Checker<'a>,
    pub(crate) wrong: &'w FailedDisplay<'w>,
    pub(crate) ensemble: Ensemble<'w>,
    /// States off shell, where the others are on shell.
    off_shell: Option<Ensemble<'w>>,
    /// The residuals at each state, where they are defined.
    off: Vec<Option<Rows>>,
    factors: OnceCell<Factors<'w>>,
    /// The vectors in the document.
    pub(crate) directions: OnceCell<Vec<String>>,
}

/// The values that the part in a hole must have at each state, and the slope of the residual in it.
pub(crate) struct Needed {
    /// The row that determines the values.
    pub(crate) row: usize,
    /// The number of rows.
    rows: usize,
    values: Vec<f64>,
    slopes: Vec<f64>,
    /// The indices of the states.
    states: Vec<usize>,
}

/// A formula that fits a hole.
pub(crate) struct Found {
    pub(crate) sign: char,
    /// The formula without its sign.
    pub(crate) latex: String,
    /// The length of the formula.
    pub(crate) cost: usize,
    /// The formula with its sign, if it is a sum of several terms.
    pub(crate) sum: Option<String>,
}

/// A proposed edit with its cost: the length of the missing part, and how unlikely its place is.
pub(crate) struct Proposal {
    cost: usize,
    edit: Edit,
}

/// The edits that insert a term or a factor with which a wrong equation may hold, the simplest first.
///
/// # Errors
/// For a claim that does not fit the notes.
pub(crate) fn edits(checker: &Checker<'_>, wrong: &FailedDisplay<'_>) -> Result<Vec<Edit>> {
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
    let off_shell = off_shell.and_then(Result::ok);
    let off = ensemble.states.iter().map(|state| residuals(checker, wrong.claim, wrong.reading, state)).collect();
    let lost =
        MissingPart { checker, wrong, ensemble, off_shell, off, factors: OnceCell::new(), directions: OnceCell::new() };
    let mut proposals = lost.proposals();
    proposals.sort_by_key(|proposal| proposal.cost);
    proposals.truncate(PROPOSED);
    Ok(proposals.into_iter().map(|proposal| proposal.edit).collect())
}

/// The residuals of all links of a reading at a state; `None`, where one has no value or is not an equality.
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
        for link in tested_links(checker, (reading, n), claim) {
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

impl<'w, 'a> MissingPart<'w, 'a> {
    fn proposals(&self) -> Vec<Proposal> {
        let model = self.checker.model;
        let mut proposals = Vec::new();
        for hole in slips::insertion_points(self.wrong.text, &model.symbols, &model.macros) {
            let [one, two] = self.fillings(hole).map(|filling| self.reading(&hole.filled('+', filling)));
            if one.statements.iter().any(std::result::Result::is_err) {
                if hole.slip == Slip::Term {
                    let named = self.vectors(hole);
                    let is_short = self.checker.options.deduction || !named.is_empty();
                    proposals.extend(if is_short { named } else { self.multiples(hole) });
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

    /// The two numbers that fill a hole; an absent factor counts as 1.
    fn fillings(&self, hole: InsertionPoint) -> [&'static str; 2] {
        if hole.slip == Slip::Term { ["1", "2"] } else { ["(2)", "(3)"] }
    }

    pub(crate) fn reading(&self, edit: &Edit) -> Reading {
        let text = edit.applied(self.wrong.text);
        reread::read_in_place(self.checker, &self.checker.model.macros, self.wrong.at, &text, self.wrong.claim)
    }

    pub(crate) fn residuals(&self, reading: &Reading, state: &SampledState<'_, RunningError>) -> Option<Rows> {
        residuals(self.checker, self.wrong.claim, reading, state)
    }

    /// The value that a hole must have at each state, if the residual is linear in it and all rows agree.
    pub(crate) fn needed(&self, hole: InsertionPoint, one: &Reading, two: &Reading) -> Option<Needed> {
        let mut needed =
            Needed { row: usize::MAX, rows: 0, values: Vec::new(), slopes: Vec::new(), states: Vec::new() };
        for (at, state) in self.ensemble.states.iter().enumerate() {
            let Some(off) = &self.off[at] else { continue };
            let (Some(first), Some(second)) = (self.residuals(one, state), self.residuals(two, state)) else {
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
            // The number of particles, and so of rows, may differ between states.
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

    /// The link of a reading that a row belongs to, and the index of the row in it.
    pub(crate) fn link(&self, reading: &Reading, row: usize) -> Option<(Link, usize)> {
        let state = self.ensemble.states.first()?;
        let mut start = 0;
        for link in
            (0..reading.statements.len()).flat_map(|n| tested_links(self.checker, (reading, n), self.wrong.claim))
        {
            let count = entries(&link, state).ok()?.len();
            if row < start + count {
                return Some((link, row - start));
            }
            start += count;
        }
        None
    }

    /// Whether a term for a hole cancels a printed term or is a multiple of it. Then the printed term is wrong, and none is
    /// missing.
    fn cancels_printed_term(&self, term: &Expr, hole: InsertionPoint, link: &Link, needed: &Needed) -> bool {
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
            (ratio + 1.0).abs() < NEAR && self.is_so_off_shell(term, &leaf.expr)
                || is_term && self.is_multiple(term, &leaf.expr, &needed.states)
        })
    }

    /// Whether two formulas that are proportional on shell are proportional off shell too. If not, the term equals the printed
    /// one by the motion only, and may be missing, as in `\ddot\theta = 0`.
    fn is_so_off_shell(&self, a: &Expr, b: &Expr) -> bool {
        let Some(off_shell) = &self.off_shell else { return true };
        let is_constant = |ensemble: &Ensemble<'_>| {
            let value = |expr, state| difference::value(expr, state).map(|value| value.value);
            let ratios = ensemble.states.iter().map(|state| Some(value(a, state)? / value(b, state)?));
            let ratios: Option<Vec<f64>> = ratios.collect();
            let Some([first, others @ ..]) = ratios.as_deref() else { return true };
            others.iter().all(|other| (other - first).abs() <= NEAR * first.abs())
        };
        !is_constant(&self.ensemble) || is_constant(off_shell)
    }

    /// Whether one of these divisors is a printed factor beside a hole, and would cancel it.
    fn cancels_factor(&self, divisors: &[Expr], hole: InsertionPoint) -> bool {
        let (symbols, macros) = (&self.checker.model.symbols, &self.checker.model.macros);
        let read = read_formula(&self.wrong.text[hole.whole.range()], &mut symbols.clone(), macros);
        let Ok(printed) = read else { return !divisors.is_empty() };
        let mut factors = Vec::new();
        bases(&printed, &mut factors);
        divisors.iter().any(|divisor| factors.contains(&divisor))
    }

    /// Whether a term is a number times another for all values of their symbols.
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

    /// The proposal of a missing number, in a product without a number.
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

    /// The formula for a hole, which the reading `one` fills with 1: a product of powers, or a normal form.
    pub(crate) fn formula(
        &self,
        hole: InsertionPoint,
        needed: &Needed,
        link: (&Link, usize),
        one: &Reading,
    ) -> Option<Found> {
        // Without a claims file the search is kept short: a lost sum is rare.
        let is_short = self.checker.options.deduction;
        self.product(hole, needed, link.0).or_else(|| if is_short { None } else { self.sum(hole, needed, link, one) })
    }

    /// The formula for a hole as a product of powers.
    fn product(&self, hole: InsertionPoint, needed: &Needed, link: &Link) -> Option<Found> {
        let factors = self.factors.get_or_init(|| Factors::of(self.checker, self.wrong, &self.ensemble.states));
        let product = factors.fitted(&needed.states, &needed.values)?;
        if hole.slip == Slip::Factor && product.is_number() {
            return None;
        }
        let symbols = &self.checker.model.symbols;
        let read = read_formula(&product.latex, &mut symbols.clone(), &self.checker.model.macros);
        let adds = |term: Expr| !self.cancels_printed_term(&product.signed(term), hole, link, needed);
        if hole.slip == Slip::Term && !read.is_ok_and(adds) {
            return None;
        }
        let sign = if product.is_negative() { '-' } else { '+' };
        if hole.slip == Slip::Term && self.restates_a_definition(&[&product.above, &product.below], link) {
            return None;
        }
        let is_other_side = |side: &Expr| product.above.iter().any(|factor| factor == side);
        let restates = is_other_side(&link.lhs) || is_other_side(&link.rhs);
        // A quotient by a sum or a rate, or many factors, are unlikely to be missing.
        let is_rate = |factor: &Expr| matches!(factor.node, Node::Symbol { dots: 1.., .. });
        let divides = product.below.iter().any(|factor| matches!(factor.node, Node::Sum(_)) || is_rate(factor));
        let is_far = divides || product.above.len() + product.below.len() > MOST_FACTORS;
        let is_implausible = || sign == '-' || restates || is_far || self.cancels_factor(&product.below, hole);
        if hole.slip == Slip::Factor && is_implausible() {
            return None;
        }
        Some(Found { sign, latex: product.latex, cost: product.cost, sum: None })
    }

    /// Whether a product contains a name, or a rate of one, that the letters of the equation define: E = ½mẋ² + ½kx² in mẍ = −kx. Such a
    /// term repeats the definition, and says nothing of what is missing.
    fn restates_a_definition(&self, parts: &[&[Expr]], link: &Link) -> bool {
        let model = self.checker.model;
        let own: Vec<SymbolId> =
            [&link.lhs, &link.rhs].iter().flat_map(|side| side.symbols()).map(|(id, _)| id).collect();
        let is_made_of_them = |id: SymbolId| match model.meaning(id) {
            Some(Meaning::Defined(formula)) if !own.contains(&id) => {
                let letters = formula.symbols();
                !letters.is_empty() && letters.iter().all(|(letter, _)| own.contains(letter))
            }
            _ => false,
        };
        parts.iter().flat_map(|part| part.iter()).flat_map(Expr::symbols).any(|(id, _)| is_made_of_them(id))
    }

    pub(crate) fn proposal(&self, hole: InsertionPoint, sign: char, latex: &str, cost: usize) -> Proposal {
        // A term is more likely missing from a sum than beside a single term.
        let place = usize::from(hole.beside == 1) + usize::from(sign == '-');
        Proposal { cost: 2 * cost + place, edit: hole.filled(sign, latex) }
    }

    /// The formula for a hole as a normal form, from symbolic states.
    fn sum(&self, hole: InsertionPoint, needed: &Needed, (link, row): (&Link, usize), one: &Reading) -> Option<Found> {
        let (one, _) = self.link(one, needed.row)?;
        let off = |link: &Link, state: &SampledState<'_, Symbol>| {
            let sides = entries(link, state).ok()?.get(row).copied()?;
            Some(sides.0 - sides.1)
        };
        let missing = |state: &SampledState<'_, Symbol>| {
            let (before, after) = (off(link, state)?, off(&one, state)?);
            let slope = after - before;
            let above = if hole.slip == Slip::Term { -before } else { slope - before };
            Some((above * slope.recip(), Symbol::from(0.0)))
        };
        let model = self.checker.model;
        let found = normal(model, &self.ensemble, link, &missing)?;
        let length = text::formula(&found, &model.symbols).chars().count();
        let mut is_whole = true;
        found.walk(&mut |part| is_whole &= !matches!(part.node, Node::Quotient(..)));
        // A missing factor is not a sum of quotients; such a sum would replace the printed term. Three terms are unlikely
        // to be missing at once.
        let is_long = hole.slip == Slip::Term && matches!(&found.node, Node::Sum(terms) if terms.len() > MOST_TERMS);
        if length > LONGEST || is_long || hole.slip == Slip::Factor && !is_whole {
            return None;
        }
        let near = |(a, b): (f64, &f64)| (a - b).abs() <= NEAR * b.abs();
        if !self.values(&found, &needed.states)?.into_iter().zip(&needed.values).all(near) {
            return None;
        }
        if multiplied_out(&found).iter().any(|leaf| self.cancels_printed_term(&leaf.signed(), hole, link, needed)) {
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
