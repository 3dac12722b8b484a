//! Claims that hold while some quantities are small: `A ≈ B` to an order in ε, when these are scaled by ε.
//!
//! Each state gives a family of states in which the small quantities are scaled by ε and the other free numbers stay. Along
//! the family the difference of the sides must fall as a power of ε above the claimed order; the power is measured. A term
//! that falls so fast off shell too is not tested, and makes the claim undecided.
//!
//! # When something holds for small quantities
//!
//! They are scaled together by 2⁻², …, 2⁻⁸, and the rest of the state stays; on shell the motion follows. The power
//! with which the difference falls is measured from the last three steps above rounding: order + ¾ or more is a
//! pass, order + ¼ or less a counterexample, and the range between is `undecided`. It is measured to 2⁻²⁰ as well,
//! as far as rounding allows: cos θ ≈ 1 − 10⁻⁵θ looks right for long. Where nothing is solved it is measured with many
//! digits at 2⁻²⁰⁰ and 2⁻⁴⁰⁰, which decides: x − x³/6.00001 is not sin x to order 3. If the power is reached off shell too, the
//! claim is small whatever the motion and says nothing. Mutants are tried as for an identity.

use std::sync::Arc;

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, Node, Value, text};
use crate::scalar::{Enclosure, RunningError};

use crate::check::judge::mutants::mutants_of;
use crate::check::kinds::rate;
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::sampling::{Mode, Spread};
use crate::check::sample::context::Context;
use crate::check::sample::prescribed_values::PrescribedValues;
use crate::check::sample::setting::FEWEST;
use crate::check::sample::without_value;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual::{Failure, pair};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The steps: ε = 2⁻ᵏ.
const STEPS: std::ops::RangeInclusive<i32> = 2..=8;

/// The steps after these, as long as the error exceeds rounding; a remaining error may be small.
const FURTHER: [i32; 4] = [11, 14, 17, 20];

/// The number of families that have the further steps.
const FOLLOWED: usize = 4;

/// The number of families that are followed with many digits.
const EXACT: usize = 2;

/// The steps with many digits.
const FAR: [i32; 2] = [200, 400];

/// The number of bits beyond those in which the error shows.
const SPARE: usize = 256;

/// The number of families that screen texts in a trial.
const SCREENED: usize = 3;

/// The relative size of rounding errors.
const ROUNDING: f64 = 1e-12;

/// The multiple of the rounding error above which an error is significant.
const CLEAR: f64 = 10.0;

/// The most by which a measured power may rise from one step to the next: beyond it the difference has no power yet.
const UNSETTLED: f64 = 0.3;

/// The largest distance of a measured power below a whole one.
const SLACK: f64 = 0.25;

/// A family of states along which some quantities become small.
pub(crate) struct ShrinkingFamily<'m> {
    states: Vec<SampledState<'m, RunningError>>,
    /// The further states, each with its step.
    further: Vec<(i32, SampledState<'m, RunningError>)>,
    /// What is needed to follow it with many digits.
    exact: Option<Followed<'m>>,
}

/// A family that is followed with many digits.
struct Followed<'m> {
    family: Arc<PrescribedValues<'m>>,
    base: Vec<f64>,
    values: Vec<f64>,
}

/// A state and the failure there.
type Shown<'s, 'm> = (&'s SampledState<'m, RunningError>, Failure);

/// A few families of states that screen other texts of a claim, for each of the ways in which quantities are small.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn screen<'m>(
    model: &'m Model,
    mode: Mode,
    ways: &[Vec<Expr>],
    context: &Context<'_>,
) -> Result<Vec<Vec<ShrinkingFamily<'m>>>> {
    ways.iter().map(|small| families(model, (mode, SCREENED, 0), small, context)).collect()
}

/// Whether a claim to an order fails for certain along one of the families of each way.
pub(crate) fn misses_order(link: &Link, order: u32, ways: &[Vec<ShrinkingFamily<'_>>]) -> bool {
    let misses = |family: &ShrinkingFamily<'_>| family.power(link).is_ok_and(|(power, _)| power < missed(order));
    !ways.is_empty() && ways.iter().all(|families| families.iter().any(misses))
}

/// The small quantities with the rates of the coordinates among them; `None`, if these are there already.
pub(crate) fn with_rates(small: &[Expr], model: &Model) -> Option<Vec<Expr>> {
    let rates = rates_of(small, model);
    (!rates.is_empty()).then(|| small.iter().cloned().chain(rates).collect())
}

/// The rates of the coordinates among some quantities that are not there already.
fn rates_of(small: &[Expr], model: &Model) -> Vec<Expr> {
    let rate = |name: &Expr| match &name.node {
        Node::Symbol { id, indices, dots: 0 } if model.is_coordinate(*id) => {
            Some(Expr::new(Node::Symbol { id: *id, indices: indices.clone(), dots: 1 }, name.span))
        }
        _ => None,
    };
    small.iter().filter_map(rate).filter(|rate| !small.contains(rate)).collect()
}

/// The power below which an order is missed for certain, rounding included.
fn missed(order: u32) -> f64 {
    f64::from(order) + SLACK
}

/// Checks a claim to an order in some small quantities: always, else on shell. What fails for a small coordinate is tried with a
/// small rate of it too, as in a small oscillation.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(link: &Link, small: &[Expr], order: u32, context: &Context<'_>) -> Result<Finding> {
    let found = scaled(link, small, order, context)?;
    match rates_of(small, context.model) {
        rates if rates.is_empty() || found.verdict != Verdict::Refuted => Ok(found),
        rates => {
            let moving = with_small_rates(link, (small, &rates), order, context)?;
            Ok(if moving.verdict.passes() { moving } else { found })
        }
    }
}

/// Checks a claim to first order in coordinates, or else in these and their rates. Where it fails without the rates, and these cannot be
/// made small, the finding says so.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn of_motion(link: &Link, small: &[Expr], rates: &[Expr], context: &Context<'_>) -> Result<Finding> {
    let found = scaled(link, small, 1, context)?;
    if found.verdict != Verdict::Refuted || rates.is_empty() {
        return Ok(found);
    }
    let moving = with_small_rates(link, (small, rates), 1, context)?;
    Ok(if moving.verdict.passes() || moving.code == Code::TooFewStates { moving } else { found })
}

/// The finding on a claim to an order in coordinates and in rates.
fn with_small_rates(
    link: &Link,
    (small, rates): (&[Expr], &[Expr]),
    order: u32,
    context: &Context<'_>,
) -> Result<Finding> {
    let all: Vec<Expr> = small.iter().chain(rates).cloned().collect();
    let moving = scaled(link, &all, order, context)?;
    if !moving.verdict.passes() {
        return Ok(moving);
    }
    let rates: Vec<String> = rates.iter().map(|rate| text::formula(rate, &context.model.symbols)).collect();
    Ok(Finding {
        message: format!("{}; with the coordinates, {} are taken to be small", moving.message, rates.join(", ")),
        ..moving
    })
}

/// Checks a claim to an order in the quantities that are scaled.
///
/// # Errors
/// When the system's mass matrix is singular.
fn scaled(link: &Link, small: &[Expr], order: u32, context: &Context<'_>) -> Result<Finding> {
    let on_shell = context.on_shell.unwrap_or(context.model.has_motion());
    let wanted = f64::from(order + 1) - SLACK;
    let missed = missed(order);
    let families = families_of(link, small, context, on_shell)?;
    if families.len() < FEWEST.min(context.options.points) {
        let message = format!(
            "the small quantities can be made smaller at only {} sampled states; remove conditions on them",
            families.len()
        );
        return Ok(context.finding(Code::TooFewStates, Verdict::Undecided, message));
    }
    let (mut slowest, mut usable) = (f64::INFINITY, 0);
    for family in &families {
        match family.power_further(link, order) {
            Err(reason) => return Ok(context.unavailable(&reason)),
            Ok((power, failure)) if power < missed => {
                return Ok(Finding {
                    points: families.len(),
                    tried: families.len(),
                    max_residual: failure.as_ref().map(|(_, failure)| failure.residual),
                    counterexample: failure.map(|(state, failure)| counterexample(link, state, &failure)),
                    ..context.finding(
                        Code::OrderDiffers,
                        Verdict::Refuted,
                        rate::differ_at(power.max(0.0), small, context.model),
                    )
                });
            }
            Ok((power, _)) => {
                slowest = slowest.min(power);
                usable += usize::from(!power.is_nan());
            }
        }
    }
    if usable < FEWEST.min(context.options.points) {
        let message = without_value::message((usable, families.len()), None, context.model);
        return Ok(context.finding(Code::TooFewStates, Verdict::Undecided, message));
    }
    if slowest < wanted {
        let (below, above) = (slowest.floor(), slowest.floor() + 1.0);
        let way_out = match below >= 1.0 {
            true => format!("write \"order\": {:.0}, or correct the term", below - 1.0),
            false => "correct the term".to_owned(),
        };
        let message = format!(
            "the two sides differ by a term of order {slowest:.1} in the small quantities, between the orders {below:.0} and \
             {above:.0}; {way_out}"
        );
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    // A term that is small off shell too is beyond the order, and is not tested.
    let free = families_of(link, small, context, false)?;
    let not_tested = |term: &Expr, alone: &Link| {
        let words = text::formula(term, &context.model.symbols);
        let powers = free.iter().filter_map(|family| family.power(alone).ok()).map(|(power, _)| power);
        let lowest = powers.filter(|power| power.is_finite()).fold(f64::INFINITY, f64::min).round();
        // The order of the term, as far as it can be measured.
        let needed = if lowest.is_finite() { f64::from(order + 1).max(lowest) } else { f64::from(order + 1) };
        format!(
            "“{words}” is beyond order {order}, so it is not tested; write \"order\": {needed:.0} in the claims file, or \
             remove the term"
        )
    };
    for term in terms(link) {
        let alone = Link { lhs: term.clone(), rhs: Expr::integer(0, term.span), ..link.clone() };
        if !free.is_empty() && all_reach(&alone, &free, wanted) {
            return Ok(context.finding(Code::TermBeyondOrder, Verdict::Undecided, not_tested(term, &alone)));
        }
    }
    for (term, without) in omissions(&link.rhs) {
        let without = Link { lhs: link.rhs.clone(), rhs: without, ..link.clone() };
        if !free.is_empty() && all_reach(&without, &free, wanted) {
            return Ok(context.finding(Code::TermBeyondOrder, Verdict::Undecided, not_tested(&term, &without)));
        }
    }
    if let Some(change) = surviving_change(link, small, (wanted, missed), (&families, on_shell), context)? {
        let message =
            format!("the sampled states do not distinguish this from the same claim with {change}; widen the ranges");
        return Ok(context.finding(Code::MutantPasses, Verdict::Undecided, message));
    }
    let message = match slowest.is_finite() {
        true => format!("holds to order {order} in the small quantities: the error is of order {slowest:.1}"),
        false => "holds to every order of the small quantities".to_owned(),
    };
    let points = families.len();
    Ok(Finding { points, tried: points, ..context.verified(message, "an approximation") })
}

/// Whether the error of a claim falls in all families with at least this power.
fn all_reach(link: &Link, families: &[ShrinkingFamily<'_>], least: f64) -> bool {
    families.iter().all(|family| family.power(link).is_ok_and(|(power, _)| power.is_nan() || power >= least))
}

/// The change of a mutant that holds to the same order. `wanted` is the power with which the error must fall, and a claim with one
/// below `missed` fails.
fn surviving_change(
    link: &Link,
    small: &[Expr],
    (wanted, missed): (f64, f64),
    (families, on_shell): (&[ShrinkingFamily<'_>], bool),
    context: &Context<'_>,
) -> Result<Option<String>> {
    let survivors: Vec<_> = mutants_of(link, context.model)
        .into_iter()
        .filter(|mutant| all_reach(&mutant.link, families, wanted))
        .collect();
    if survivors.is_empty() {
        return Ok(None);
    }
    let wide = Context { spread: Spread::BeyondRanges, ..*context };
    let mut wide = families_of(link, small, &wide, on_shell)?;
    // In wider ranges some families are unusable; only those count where the claim itself holds.
    wide.retain(|family| family.power(link).is_ok_and(|(power, _)| power >= wanted));
    // In wider ranges rounding may exceed the error at the last steps, so the first and last steps are compared.
    let falls = |link: &Link| wide.iter().all(|family| family.falls(link, missed));
    Ok(survivors.into_iter().find(|mutant| !falls(&mutant.link)).map(|mutant| mutant.change))
}

/// The terms of both sides, except a literal 0.
fn terms(link: &Link) -> Vec<&Expr> {
    let mut found = Vec::new();
    for side in [&link.lhs, &link.rhs] {
        match &side.node {
            Node::Sum(terms) => found.extend(terms.iter().map(|term| &term.expr)),
            _ => found.push(side),
        }
    }
    found.retain(|term| !term.is_null());
    found
}

/// The variants of a formula in which a sum inside it lacks one term, each with that term.
fn omissions(expr: &Expr) -> Vec<(Expr, Expr)> {
    let mut found = Vec::new();
    for (at, child) in expr.children().into_iter().enumerate() {
        let mut variants = omissions(child);
        if let Node::Sum(terms) = &child.node
            && terms.len() > 1
        {
            for (k, term) in terms.iter().enumerate() {
                let mut left = terms.clone();
                left.remove(k);
                variants.push((term.expr.clone(), Expr::new(Node::Sum(left), child.span)));
            }
        }
        for (term, variant) in variants {
            let mut whole = expr.clone();
            if let Some(place) = whole.children_mut().into_iter().nth(at) {
                *place = variant;
            }
            found.push((term, whole));
        }
    }
    found
}

/// Families of states for a claim.
fn families_of<'m>(
    link: &Link,
    small: &[Expr],
    context: &Context<'m>,
    on_shell: bool,
) -> Result<Vec<ShrinkingFamily<'m>>> {
    let mode = context.mode(on_shell, &[&link.lhs, &link.rhs]);
    families(context.model, (mode, context.options.points.min(2 * FEWEST), FOLLOWED), small, context)
}

/// Families from `points` states of the claim; the first `followed` of them have the further steps.
fn families<'m>(
    model: &'m Model,
    (mode, points, followed): (Mode, usize, usize),
    small: &[Expr],
    context: &Context<'_>,
) -> Result<Vec<ShrinkingFamily<'m>>> {
    let setting = context.setting(mode);
    let ensemble = context.ensemble_of(model, mode, points, "")?;
    let mut family = PrescribedValues::new(model, &setting, small);
    let (mut found, mut followed_bases) = (Vec::new(), Vec::new());
    for (state, base) in ensemble.states.iter().zip(&ensemble.bases) {
        let value = |expr: &Expr| match state.now(expr, &[]) {
            Ok(Value::Scalar(value)) => Some(value.value),
            _ => None,
        };
        let Some(values) = small.iter().map(value).collect::<Option<Vec<f64>>>() else { continue };
        let mut states = Vec::new();
        for k in STEPS {
            let scaled: Vec<f64> = values.iter().map(|value| value * 2f64.powi(-k)).collect();
            states.extend(family.at(base, &scaled)?);
        }
        if states.len() == STEPS.count() {
            let mut further = Vec::new();
            for k in FURTHER.iter().filter(|_| found.len() < followed) {
                let scaled: Vec<f64> = values.iter().map(|value| value * 2f64.powi(-k)).collect();
                further.extend(family.at(base, &scaled)?.map(|state| (*k, state)));
            }
            if further.len() == FURTHER.len() && followed_bases.len() < EXACT {
                followed_bases.push((found.len(), base.clone(), values));
            }
            found.push(ShrinkingFamily { states, further, exact: None });
        }
    }
    let family = Arc::new(family);
    for (at, base, values) in followed_bases {
        found[at].exact = Some(Followed { family: family.clone(), base, values });
    }
    Ok(found)
}

impl<'m> ShrinkingFamily<'m> {
    /// Whether the difference of the sides falls at least as this power, in the last steps or from first to last.
    fn falls(&self, link: &Link, least: f64) -> bool {
        let at = |state: &SampledState<'_, RunningError>| -> Option<f64> {
            let sides = pair(state.now(&link.lhs, &[]).ok()?, state.now(&link.rhs, &[]).ok()?);
            Some(sides.0.iter().zip(&sides.1).map(|(a, b)| (a.value - b.value).abs()).fold(0.0, f64::max))
        };
        let ends = self.states.first().and_then(at).zip(self.states.last().and_then(at));
        let steps = (self.states.len() - 1) as f64;
        ends.is_some_and(|(first, last)| (first / last).log2() / steps >= least)
            || self.power(link).is_ok_and(|(power, _)| power.is_nan() || power >= least)
    }

    /// The power of ε with which the difference of the sides falls; infinite, if it is within rounding.
    fn power(&self, link: &Link) -> Result<(f64, Option<Failure>), Unavailable> {
        let mut errors: Vec<f64> = Vec::new();
        let mut last = None;
        for state in &self.states {
            // A state without a value makes the power NaN.
            let Some((error, noise, failure)) = error(link, state)? else { return Ok((f64::NAN, None)) };
            last = failure;
            if error <= noise {
                break;
            }
            errors.push(error);
        }
        if errors.len() < 3 {
            return Ok((f64::INFINITY, last));
        }
        let tail = &errors[errors.len() - 3..];
        let steps = [(tail[0] / tail[1]).log2(), (tail[1] / tail[2]).log2()];
        // Two terms of different powers that nearly cancel show neither power yet: ηθ̇² and gθ⁴ at steps that are too large.
        let is_settled = steps[1] - steps[0] <= UNSETTLED;
        let power = if is_settled { (steps[0] + steps[1]) / 2.0 } else { f64::NAN };
        Ok((power, last))
    }

    /// The power that many digits show, as far as it decides an order; else that of the first and of the further steps,
    /// whichever is smaller. And the last state that shows it.
    fn power_further(&self, link: &Link, order: u32) -> Result<(f64, Option<Shown<'_, 'm>>), Unavailable> {
        let (power, shown) = self.power_in_doubles(link)?;
        Ok(match self.exact_power(link, order) {
            Some(exact) if exact.is_finite() => (exact, shown),
            Some(_) if power < f64::from(order + 1) => (f64::INFINITY, shown),
            _ => (power, shown),
        })
    }

    /// The power with which the difference falls; infinite where it falls by much more than the order.
    fn exact_power(&self, link: &Link, order: u32) -> Option<f64> {
        let Followed { family, base, values } = self.exact.as_ref()?;
        let (projection, places) = family.moves_alone()?;
        let [near, nearer] = FAR.map(|k| {
            let mut scaled = base.clone();
            for (at, value) in places.iter().zip(values) {
                scaled[*at] = value * 2f64.powi(-k);
            }
            let numbers = || scaled.iter().map(|x| Enclosure::exact(*x)).collect();
            let bits = FAR[1] as usize * (order as usize + 2) + SPARE;
            rate::gaps(link, projection, &numbers, (bits, false))
        });
        Some(rate::slowest(&near?, &nearer?, f64::from(FAR[1] - FAR[0])).0)
    }

    /// The power in doubles, and the last state that shows it.
    fn power_in_doubles(&self, link: &Link) -> Result<(f64, Option<Shown<'_, 'm>>), Unavailable> {
        let (mut slowest, failure) = self.power(link)?;
        let Some(end) = self.states.last() else { return Ok((slowest, None)) };
        let mut shown = failure.map(|failure| (end, failure));
        let mut before = error(link, end)?.filter(|_| slowest.is_finite()).map(|(error, ..)| (*STEPS.end(), error));
        for (k, state) in &self.further {
            let (Some((step, larger)), Some((error, noise, failure))) = (before, error(link, state)?) else { break };
            if error <= CLEAR * noise {
                break;
            }
            let power = (larger / error).log2() / f64::from(k - step);
            if power < slowest {
                (slowest, shown) = (power, failure.map(|failure| (state, failure)));
            }
            before = Some((*k, error));
        }
        Ok((slowest, shown))
    }
}

/// The largest difference of the sides at a state, its rounding error, and the entry; `None`, where it is NaN.
fn error(
    link: &Link,
    state: &SampledState<'_, RunningError>,
) -> Result<Option<(f64, f64, Option<Failure>)>, Unavailable> {
    let (lhs, rhs) = pair(state.now(&link.lhs, &[])?, state.now(&link.rhs, &[])?);
    let (mut error, mut noise, mut failure) = (0.0_f64, 0.0_f64, None);
    for (a, b) in lhs.into_iter().zip(rhs) {
        let difference = (a.value - b.value).abs();
        if difference.is_nan() {
            return Ok(None);
        }
        if difference >= error {
            failure = Some(Failure { lhs: a.value, rhs: b.value, residual: difference, entry: None });
        }
        error = error.max(difference);
        noise = noise.max(ROUNDING * (a.magnitude + b.magnitude));
    }
    Ok(Some((error, noise, failure)))
}
