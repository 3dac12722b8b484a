//! The difference of the two sides of a refuted claim, as a formula, with the derived equation of motion.
//!
//! Both sides are evaluated over [`Symbol`]s in a [`SampledState`] whose base numbers are symbols: q, q̇ and the
//! constants. [`mod@crate::derive`] brings their difference into normal form. On shell the accelerations are the
//! derived ones. If the claim prints momenta and not the velocities, the difference is written in these momenta.
//!
//! The formula explains and decides nothing: the verdict rests on numbers. It is shown only if it is short, and if it
//! has the value of the difference at the counterexample and at all other states. It is not shown where hypotheses
//! would have to be solved.

use crate::derive;
use crate::derive::{Class, Letter};
use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, IndexId, Node, SymbolId, Value, text};
use crate::latex::typeset;
use crate::mechanics::LinearSolver;
use crate::scalar::{Graph, Number, RunningError, Symbol};

use crate::check::certificate::decide;
use crate::check::judge::symbolic_base::{SymbolicBase, symbol, velocities_from_momenta};
use crate::check::model::Model;
use crate::check::model::claim::{Link, is_equality};
use crate::check::model::meaning::{Meaning, Quantity};
use crate::check::model::order::derivatives;
use crate::check::model::sampling::Mode;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::state::generic_body::Generality;
use crate::check::state::numbers::Layout;
use crate::check::state::residual;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Counterexample, Finding, Formula};

/// The largest number of characters in a formula that is shown.
const LONGEST: usize = 200;

/// The largest number of digits of a number in a formula that is shown.
const MOST_DIGITS: usize = 4;

/// The largest relative error of a shown formula at a sampled state.
const NEAR: f64 = 1e-9;

/// The finding, with the difference of the sides and the derived equation if the claim is refuted.
pub(crate) fn explained(link: &Link, context: &Context<'_>, finding: Finding) -> Finding {
    let Some(failed) = Failed::of(link, context, &finding) else { return finding };
    let difference = failed.difference().map(|formula| shown(&formula, context.model));
    Finding { difference, derived: failed.derived(), ..finding }
}

/// The left side minus the right side of a refuted link, if that is worth showing.
pub(crate) fn formula(link: &Link, context: &Context<'_>, finding: &Finding) -> Option<Expr> {
    Failed::of(link, context, finding)?.difference()
}

/// A function that gives two numbers of a symbolic state.
pub(crate) type Numbers<'n> = dyn Fn(&SampledState<'_, Symbol>) -> Option<(Symbol, Symbol)> + 'n;

/// A refuted claim with the states at which it fails.
struct Failed<'a> {
    link: &'a Link,
    ensemble: Ensemble<'a>,
    model: &'a Model,
    /// The place of the counterexample among the states.
    at: usize,
    /// The entry that fails there, counted over the free indices and the components.
    entry: usize,
}

impl<'a> Failed<'a> {
    /// Finds the states of a refuted equality, on shell or off shell.
    fn of(link: &'a Link, context: &Context<'a>, finding: &Finding) -> Option<Self> {
        let is_wrong = finding.verdict == Verdict::Refuted && is_equality(link.relation);
        let counterexample = finding.counterexample.as_ref().filter(|_| is_wrong)?;
        let modes: &[bool] = match (context.on_shell, context.model.has_motion()) {
            (_, false) => &[false],
            (Some(true), true) => &[true],
            (Some(false), true) => &[false],
            (None, true) => &[true, false],
        };
        modes.iter().find_map(|on_shell| Failed::find(link, context, *on_shell, counterexample))
    }

    /// Finds the state of a counterexample, and the entry that fails.
    fn find(link: &'a Link, context: &Context<'a>, on_shell: bool, known: &Counterexample) -> Option<Self> {
        let mode = context.mode(on_shell, &[&link.lhs, &link.rhs]);
        let ensemble = context.ensemble(mode, false, context.options.points).ok()?;
        let sides = [&link.lhs, &link.rhs];
        if !is_nameable(&sides, context.model, &ensemble) {
            return None;
        }
        let (at, entry) = ensemble.states.iter().enumerate().find_map(|(at, state)| {
            let entries = entries(link, state).ok()?;
            let fails = |(a, b): &(RunningError, RunningError)| a.value == known.lhs && b.value == known.rhs;
            let mut failing = entries.iter().enumerate().filter(|(_, sides)| fails(sides));
            match (failing.next(), failing.next()) {
                (Some((entry, _)), None) => Some((at, entry)),
                _ => None,
            }
        })?;
        Some(Failed { link, ensemble, model: context.model, at, entry })
    }

    /// The left side minus the right side, in momenta if possible, if it is worth showing.
    fn difference(&self) -> Option<Expr> {
        let momenta = momenta(self.link, self.model);
        let in_momenta = (!momenta.is_empty()).then(|| self.in_terms_of(&momenta)).flatten();
        let found = in_momenta.or_else(|| self.in_terms_of(&[]))?;
        self.tells_more(&text::formula(&found, &self.model.symbols)).then_some(found)
    }

    /// Whether a formula says more than the claim itself: for a = b the difference a − b is no help.
    fn tells_more(&self, text: &str) -> bool {
        let Failed { link, model, .. } = self;
        let sides = [&link.lhs, &link.rhs];
        let is_derived =
            |side: &Expr| !model.is_plain(side) || self.ensemble.mode.on_shell && derivatives(side, model) > 1;
        let length = |text: &str| text.chars().count();
        let printed: usize = sides.iter().map(|side| length(&text::formula(side, &model.symbols))).sum();
        sides.into_iter().any(is_derived) || length(text) < printed
    }

    /// The difference with these momenta in place of their velocities: the coordinate and the name of each.
    fn in_terms_of(&self, momenta: &[(usize, SymbolId)]) -> Option<Expr> {
        let Failed { link, ensemble, model, .. } = self;
        let needed = derivatives(&link.lhs, model).max(derivatives(&link.rhs, model)) + 1;
        let sides = |state: &SampledState<'_, Symbol>| entries(link, state).ok()?.get(self.entry).copied();
        let found = recorded(model, ensemble, self.at, (momenta, needed), &sides)?;
        (is_short(&found, model) && self.is_the_difference(&found)).then_some(found)
    }

    /// Whether a formula has the value of left side minus right side at all states where both have one.
    fn is_the_difference(&self, formula: &Expr) -> bool {
        self.ensemble.states.iter().enumerate().all(|(at, state)| {
            let Some((a, b)) = entries(self.link, state).ok().and_then(|all| all.get(self.entry).copied()) else {
                return false;
            };
            let difference = a.value - b.value;
            let off = |value: RunningError| (value.value - difference).abs();
            match value(formula, state) {
                Some(value) if at == self.at => off(value) <= NEAR * difference.abs(),
                Some(value) if difference.is_finite() => {
                    off(value) <= NEAR * (a.magnitude + b.magnitude + value.magnitude)
                }
                _ => !difference.is_finite() && at != self.at,
            }
        })
    }

    /// The derived Euler–Lagrange equation, if the claim is about one acceleration.
    fn derived(&self) -> Option<Formula> {
        let Failed { link, ensemble, model, at, .. } = self;
        let coordinate = acceleration(link, model).filter(|_| ensemble.mode.on_shell)?;
        let mode = Mode { on_shell: false, order: 2 };
        let fixed = &ensemble.bases[*at];
        let inputs = SymbolicBase::new(model, mode, fixed);
        let record = || {
            let state = SampledState::by(
                LinearSolver::CramersRule,
                3,
                model,
                mode,
                (&Layout::of(model, mode), &inputs.base()),
                &ensemble.rules,
            )
            .ok()?;
            state.euler_lagrange()?.get(coordinate).copied()
        };
        let (graph, residual) = Graph::record(record).ok()?;
        let (left, right) = derive::equation_of_motion(&graph, residual?, &inputs.letters).ok()?;
        let holds = |state: &SampledState<'_, RunningError>| match (value(&left, state), value(&right, state)) {
            (Some(a), Some(b)) => (a.value - b.value).abs() <= NEAR * (a.magnitude + b.magnitude),
            _ => false,
        };
        let readable = is_short(&left, model) && is_short(&right, model);
        (readable && ensemble.states.iter().all(holds)).then(|| {
            let [left, right] = [&left, &right].map(|side| shown(side, model));
            Formula {
                latex: format!("{} = {}", left.latex, right.latex),
                text: format!("{} = {}", left.text, right.text),
            }
        })
    }
}

/// The difference of two numbers of symbolic states, in normal form. The numbers are made from the link. `None` if the
/// states do not consist of named numbers.
pub(crate) fn normal(model: &Model, ensemble: &Ensemble<'_>, link: &Link, numbers: &Numbers<'_>) -> Option<Expr> {
    let sides = [&link.lhs, &link.rhs];
    if !is_nameable(&sides, model, ensemble) {
        return None;
    }
    let needed = derivatives(&link.lhs, model).max(derivatives(&link.rhs, model)) + 1;
    let momenta = momenta(link, model);
    let in_momenta = (!momenta.is_empty()).then(|| recorded(model, ensemble, 0, (&momenta, needed), numbers)).flatten();
    let found = in_momenta.or_else(|| recorded(model, ensemble, 0, (&[], needed), numbers))?;
    is_short(&found, model).then_some(found)
}

/// Whether states consist of named numbers, without hypotheses that must be solved.
fn is_nameable(sides: &[&Expr], model: &Model, ensemble: &Ensemble<'_>) -> bool {
    ensemble.projection.equalities().next().is_none()
        && decide::all_symbols(sides, &ensemble.projection).is_ok()
        && Generality::of(sides, model, &ensemble.rules) == Some(Generality::GivenParticles)
}

/// The difference of two numbers of a symbolic state, with momenta in place of their velocities: the coordinate and the
/// name of each. `needed` is the number of derivatives.
fn recorded(
    model: &Model,
    ensemble: &Ensemble<'_>,
    at: usize,
    (momenta, needed): (&[(usize, SymbolId)], usize),
    numbers: &Numbers<'_>,
) -> Option<Expr> {
    let mut inputs = SymbolicBase::new(model, ensemble.mode, ensemble.bases.get(at)?);
    let first = inputs.letters.len();
    let momentum = |(_, id): &(usize, SymbolId)| Letter { expr: symbol(*id, Vec::new(), 0), class: Class::Momentum };
    inputs.letters.extend(momenta.iter().map(momentum));
    let terms = if ensemble.rules.is_empty() { needed } else { ensemble.mode.order + 1 };
    let record = || {
        let mut base = inputs.base();
        let coordinates: Vec<usize> = momenta.iter().map(|(coordinate, _)| *coordinate).collect();
        let values: Vec<Symbol> = (0..momenta.len()).map(|n| Symbol::input(first + n)).collect();
        velocities_from_momenta(model, ensemble.mode, &mut base, &coordinates, &values)?;
        let state = ensemble.projection.state_by(LinearSolver::CramersRule, &base, terms).ok()?;
        numbers(&state)
    };
    let (graph, found) = Graph::record(record).ok()?;
    let (left, right) = found?;
    derive::difference(&graph, left, right, &inputs.letters).ok()
}

/// The entries of both sides, for all values of the free indices.
pub(crate) fn entries<B: Number>(link: &Link, state: &SampledState<'_, B>) -> Result<Vec<(B, B)>, Unavailable> {
    let mut indices: Vec<(IndexId, u8)> = link.free.iter().map(|id| (*id, 1)).collect();
    let mut all = Vec::new();
    loop {
        let lhs = state.now(&link.lhs, &indices)?;
        let rhs = state.now(&link.rhs, &indices)?;
        let (a, b) = residual::pair(lhs, rhs);
        all.extend(a.into_iter().zip(b));
        if !residual::advance(&mut indices, state)? {
            return Ok(all);
        }
    }
}

/// The value of a scalar formula at a state, if it is finite.
pub(crate) fn value(formula: &Expr, state: &SampledState<'_, RunningError>) -> Option<RunningError> {
    match state.now(formula, &[]) {
        Ok(Value::Scalar(value)) => Some(value).filter(|value| value.value.is_finite()),
        _ => None,
    }
}

/// A formula for display.
pub(crate) fn shown(formula: &Expr, model: &Model) -> Formula {
    Formula { latex: typeset(formula, &model.symbols), text: text::formula(formula, &model.symbols) }
}

/// Whether a formula is short enough to be shown, with simple numbers.
fn is_short(formula: &Expr, model: &Model) -> bool {
    let mut simple = true;
    formula.walk(&mut |part| {
        if let Node::Number(digits) = &part.node {
            simple &= digits.len() <= MOST_DIGITS && digits.bytes().all(|byte| byte.is_ascii_digit());
        }
        if let Node::Symbol { id, .. } = &part.node {
            simple &= !model.symbols.entry(*id).hidden;
        }
    });
    simple && text::formula(formula, &model.symbols).chars().count() <= LONGEST
}

/// The symbols of a claim with their dots, through definitions too.
fn symbols(link: &Link, model: &Model) -> Vec<(SymbolId, u8)> {
    let mut all = [link.lhs.symbols(), link.rhs.symbols()].concat();
    let mut at = 0;
    while let Some((id, _)) = all.get(at).copied() {
        let members = model.symbols.entry(id).members.iter().map(|member| (*member, 0));
        let beneath = match model.meaning(id) {
            Some(Meaning::Defined(formula)) => formula.symbols(),
            _ => Vec::new(),
        };
        for symbol in members.chain(beneath) {
            if !all.contains(&symbol) {
                all.push(symbol);
            }
        }
        at += 1;
    }
    all
}

/// The momenta in a claim that does not contain the velocity of their coordinate: the coordinate and the name of each.
fn momenta(link: &Link, model: &Model) -> Vec<(usize, SymbolId)> {
    let printed = symbols(link, model);
    let moves = |coordinate: usize| {
        let is_it = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(i)) if *i == coordinate);
        printed.iter().any(|(id, dots)| *dots > 0 && is_it(*id))
    };
    let mut momenta = Vec::new();
    for (id, _) in &printed {
        if let Some(Meaning::System(Quantity::Momentum(i))) = model.meaning(*id)
            && !moves(*i)
            && !momenta.contains(&(*i, *id))
        {
            momenta.push((*i, *id));
        }
    }
    momenta.sort_unstable_by_key(|(coordinate, _)| *coordinate);
    momenta.dedup_by_key(|(coordinate, _)| *coordinate);
    momenta
}

/// The coordinate whose acceleration a claim contains, if it is the only one and there are no derivatives of formulas.
fn acceleration(link: &Link, model: &Model) -> Option<usize> {
    let mut is_differentiated = false;
    for side in [&link.lhs, &link.rhs] {
        side.walk(&mut |part| is_differentiated |= matches!(part.node, Node::TimeDerivative(..)));
    }
    let mut found = None;
    for (id, dots) in symbols(link, model) {
        match (model.meaning(id), dots) {
            (Some(Meaning::Coordinate(i)), 2) if found.is_none_or(|known| known == *i) => found = Some(*i),
            (Some(Meaning::Coordinate(_)), 0 | 1) | (_, 0) => {}
            _ => return None,
        }
    }
    found.filter(|_| !is_differentiated)
}
