//! Sentences about the shape of a function: its sign, its minima, its limits, the number of solutions of an
//! equation.
//!
//! Each symbol of the formula is an independent number here (an *atom*): a momentum, for example, is not computed from a
//! state. Random atoms would miss what happens only where two momenta are equal and opposite, or only for a fast top. So
//! special places are tried too: symbols of the same letter equal and opposite, each at zero, angles at multiples of π/2,
//! each constant and each momentum far larger and far smaller than the others.
//!
//! # Why these sentences are tested on independent numbers
//!
//! "U_eff has one minimum if p_φ ≠ p_ψ" is about a function with free parameters. So momenta and constants are
//! independent numbers, not what a motion gives. Random numbers would never meet p_φ = −p_ψ, and most such
//! sentences are wrong exactly at such places. They are visited on purpose: each number zero, much larger and much
//! smaller than the rest; similar symbols equal, opposite and both zero; angles at multiples of π/2.

use num_dual::{Dual, Dual64};

use crate::code::Code;
use crate::formula::{Expr, Relation, SymbolId, text};
use crate::scalar::RunningError;

use crate::check::kinds::shapes::scan::{Observation, Probe};
use crate::check::kinds::shapes::shape::{Atoms, Shape, Target, difference};
use crate::check::kinds::solves::mentions;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::{Meaning, is_angle};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::{Context, NO_EQUALITY};
use crate::check::sample::sampler::{Sampler, contains};
use crate::check::state::residual;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Counterexample, Finding};

/// A function that moves a state to a special place.
type Place = Box<dyn Fn(&mut Atoms)>;

/// The symbols for which hypotheses were solved, each with its hypothesis.
type Solved = Vec<(SymbolId, Hypothesis)>;

/// The number of random states, besides the special ones.
const RANDOM: usize = 16;

/// The number of samples at each special place.
const SPECIAL: usize = 1;

/// Checks a sentence about `function`, as `variable` runs over its range, for all atoms that obey the hypotheses.
pub fn check(function: &Expr, variable: SymbolId, shape: &Shape, context: &Context<'_>) -> Finding {
    let model = context.model;
    let mut atoms: Vec<SymbolId> = Vec::new();
    let mut formulas = vec![function];
    formulas.extend(context.hypotheses.iter().flat_map(|c| [&c.lhs, &c.rhs]));
    if let Shape::TendsTo { target: Target::Finite(value), .. } = shape {
        formulas.push(value);
    }
    for (id, dots) in formulas.iter().flat_map(|formula| formula.symbols()) {
        if dots > 0 || matches!(model.meaning(id), Some(Meaning::System(quantity)) if !is_momentum(*quantity)) {
            let shown = crate::formula::text::with_dots(&model.name(id), dots);
            let message = format!(
                "this claim is not supported for {shown}, which the motion determines; use a formula of declared \
                 symbols without time derivatives"
            );
            return context.finding(Code::NotIndependent, Verdict::Unreadable, message);
        }
        if !atoms.contains(&id) {
            atoms.push(id);
        }
    }
    if !function.symbols().iter().any(|(id, _)| *id == variable) && !matches!(shape, Shape::Independent) {
        return context.finding(
            Code::VariableAbsent,
            Verdict::Undecided,
            format!("{} does not occur in the formula; correct the name", text::plain(&model.name(variable))),
        );
    }
    let speaks_of_it = |c: &&Hypothesis| [&c.lhs, &c.rhs].into_iter().any(|side| mentions(side, variable));
    let bounds: Vec<&Hypothesis> = context.hypotheses.iter().filter(speaks_of_it).collect();
    if bounds.iter().any(|hypothesis| is_equality(hypothesis.relation) || matches!(shape, Shape::Solutions(_))) {
        let name = text::plain(&model.name(variable));
        let message = match shape {
            Shape::Solutions(_) => {
                format!(
                    "solutions for {name} are counted in its declared range; remove the hypotheses about {name}, and \
                     declare that range instead"
                )
            }
            _ => {
                format!("a hypothesis fixes {name}, which must run through its range; use an inequality instead")
            }
        };
        return context.finding(Code::VariableFixed, Verdict::Unreadable, message);
    }
    let range = model.range(variable);
    let (states, tried) = states(&atoms, variable, context);
    let mut points = 0;
    for (atoms, solved) in &states {
        let probe = Probe { model, function, variable, atoms, bounds: &bounds, solved };
        match probe.observe(shape, &range) {
            Observation::Holds => points += 1,
            Observation::Useless => {}
            Observation::Open(code, message) => {
                return Finding { points, tried, ..context.finding(code, Verdict::Undecided, message) };
            }
            Observation::Fails { at, found, wanted, compared, what } => {
                let mut state: Vec<(String, f64)> =
                    atoms.iter().filter(|(id, _)| *id != variable).map(|(id, x)| (model.name(*id), *x)).collect();
                state.extend(at.map(|x| (model.name(variable), x)));
                return Finding {
                    points: points + 1,
                    tried,
                    counterexample: Some(Counterexample { state, lhs: found, rhs: wanted, entry: None, compared }),
                    ..context.finding(Code::FunctionShapeFails, Verdict::Refuted, what)
                };
            }
        }
    }
    if points < crate::check::sample::setting::FEWEST.min(context.options.points) {
        let message = format!(
            "only {points} of {tried} sampled states satisfy the hypotheses and gave a number; widen the ranges"
        );
        return Finding { points, tried, ..context.finding(Code::TooFewStates, Verdict::Undecided, message) };
    }
    let message = format!("holds at {points} sampled states, including special values");
    Finding { points, tried, ..context.verified(message, NO_EQUALITY) }
}

fn is_momentum(quantity: crate::check::model::meaning::Quantity) -> bool {
    matches!(quantity, crate::check::model::meaning::Quantity::Momentum(_))
}

/// Atoms that satisfy the hypotheses, random and at special places, with the symbols for which hypotheses were solved; and
/// the number of attempts.
fn states(atoms: &[SymbolId], variable: SymbolId, context: &Context<'_>) -> (Vec<(Atoms, Solved)>, usize) {
    let model = context.model;
    let mut draw = Sampler::new(context.options.seed, context.topic);
    let mut places: Vec<Place> = Vec::new();
    let is_constant = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Constant(_)));
    let free: Vec<SymbolId> = atoms.iter().copied().filter(|id| *id != variable).collect();
    for (k, &a) in free.iter().enumerate() {
        if is_angle(&model.range(a)) {
            for quarter in -4..=4 {
                let angle = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
                places.push(Box::new(move |state| set(state, a, |_| angle)));
            }
            continue;
        }
        places.push(Box::new(move |state| set(state, a, |_| 0.0)));
        for factor in [1e3, 30.0, 1.0 / 30.0, 1e-3] {
            places.push(Box::new(move |state| set(state, a, |x| x * factor)));
        }
        for &b in &free[..k] {
            let alike = model.symbols.entry(a).name.base == model.symbols.entry(b).name.base;
            if alike && !is_constant(a) && !is_constant(b) {
                for sign in [1.0, -1.0] {
                    places.push(Box::new(move |state| {
                        let value = state.iter().find(|(id, _)| *id == b).map_or(0.0, |(_, x)| *x);
                        set(state, a, |_| sign * value);
                    }));
                }
                places.push(Box::new(move |state| {
                    set(state, a, |_| 0.0);
                    set(state, b, |_| 0.0);
                }));
            }
        }
    }
    let nowhere: Place = Box::new(|_| {});
    let plan = std::iter::repeat_n(&nowhere, RANDOM).chain(places.iter().flat_map(|p| std::iter::repeat_n(p, SPECIAL)));
    let plan = plan.map(|place| (place, context.hypotheses.to_vec()));
    // A hypothesis that allows equality is also taken at its edge.
    let edges = context.hypotheses.iter().enumerate().filter_map(|(at, hypothesis)| {
        let mut tight = context.hypotheses.to_vec();
        tight[at].relation = Relation::Equal;
        matches!(hypothesis.relation, Relation::LessEqual | Relation::GreaterEqual).then_some((&nowhere, tight))
    });
    let (mut found, mut tried) = (Vec::new(), 0);
    for (place, hypotheses) in plan.chain(edges.flat_map(|edge| std::iter::repeat_n(edge, 4))) {
        // Where a hypothesis is an inequality, several draws may be needed to meet it.
        for _ in 0..12 {
            tried += 1;
            let mut state: Atoms =
                atoms.iter().map(|id| (*id, draw.value(&model.range(*id), Spread::Declared))).collect();
            place(&mut state);
            let in_range = |state: &Atoms| state.iter().all(|(id, x)| contains(&model.range(*id), *x));
            if let Some(solved) = obey(&mut state, variable, model, &hypotheses).filter(|_| in_range(&state)) {
                found.push((state, solved));
                break;
            }
        }
    }
    (found, tried)
}

fn set(state: &mut Atoms, id: SymbolId, f: impl Fn(f64) -> f64) {
    for (known, value) in state.iter_mut() {
        if *known == id {
            *value = f(*value);
        }
    }
}

/// Projects a state onto the hypotheses that are equalities; returns the symbols for which they were solved, if it then
/// satisfies all hypotheses.
fn obey(state: &mut Atoms, variable: SymbolId, model: &Model, hypotheses: &[Hypothesis]) -> Option<Solved> {
    let candidates = |hypothesis: &Hypothesis| -> Vec<SymbolId> {
        let ids = hypothesis.lhs.symbols().into_iter().chain(hypothesis.rhs.symbols()).map(|(id, _)| id);
        let mut ids: Vec<SymbolId> = ids.filter(|id| *id != variable).collect();
        ids.sort_by_key(|id| matches!(model.meaning(*id), Some(Meaning::Constant(_))));
        ids.dedup();
        ids
    };
    let mut equalities: Vec<&Hypothesis> = hypotheses.iter().filter(|c| is_equality(c.relation)).collect();
    equalities.sort_by_key(|hypothesis| candidates(hypothesis).len());
    let mut taken: Solved = Vec::new();
    for hypothesis in equalities {
        let is_free = |id: &SymbolId| taken.iter().all(|(known, _)| known != id);
        let solved = candidates(hypothesis).into_iter().filter(is_free).find(|id| {
            let mut moved = state.clone();
            let works = newton(&mut moved, *id, hypothesis, model);
            if works {
                *state = moved;
            }
            works
        });
        taken.push((solved?, hypothesis.clone()));
    }
    let holds = |hypothesis: &Hypothesis| {
        difference::<RunningError>(state, hypothesis, model, RunningError::new)
            .is_some_and(|difference| residual::holds(hypothesis.relation, difference))
    };
    hypotheses.iter().all(holds).then_some(taken)
}

fn newton(state: &mut Atoms, id: SymbolId, hypothesis: &Hypothesis, model: &Model) -> bool {
    for _ in 0..40 {
        let at = state.iter().position(|(known, _)| *known == id);
        let slope = |place: usize| RunningError::new(if Some(place) == at { 1.0 } else { 0.0 });
        let mut place = 0;
        let value = difference::<Dual<RunningError>>(state, hypothesis, model, |x| {
            place += 1;
            Dual::new(RunningError::new(x), slope(place - 1))
        });
        let value = value.map(|x| Dual64::new(x.re.value, x.eps.value));
        let Some(value) = value.filter(|v| v.re.is_finite() && v.eps.is_finite()) else { return false };
        if value.re == 0.0 {
            return true;
        }
        if value.eps == 0.0 {
            return false;
        }
        let step = value.re / value.eps;
        set(state, id, |x| x - step);
        if step.abs() < 1e-16 {
            return true;
        }
    }
    difference::<RunningError>(state, hypothesis, model, RunningError::new).is_some_and(residual::vanishes)
}

/// An equation as the function whose zeros solve it.
pub fn as_function(link: &Link) -> Expr {
    link.lhs.clone().minus(link.rhs.clone())
}
