//! Hamilton's equations: whether a printed function of coordinates and momenta generates the motion.
//!
//! The formula is differentiated by its coordinates and momenta, each independent; then q̇ = ∂H/∂p and ṗ = −∂H/∂q
//! must be what the Lagrangian gives on shell, in numbers and over a field.
//!
//! That a printed H is the Hamiltonian can be tested by its value. But its use is that Hamilton's equations from it
//! give the motion; a value at p = ∂L/∂q̇ does not say whether H is written in the right variables. So the printed
//! formula is differentiated, with coordinates and momenta independent, and q̇ and ṗ are compared with the motion
//! on shell.

use num_dual::Dual;

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::{Unavailable, evaluate, evaluate_to};
use crate::formula::{Expr, Node, SymbolId, Value, text};
use crate::scalar::prime_field::Modulus;
use crate::scalar::{Modular, RunningError, Series};
use crate::suggest::in_json;

use crate::check::certificate::claim::{Claim, Differences};
use crate::check::certificate::decide;
use crate::check::model::Model;
use crate::check::model::meaning::{Meaning, Quantity};
use crate::check::sample::context::Context;
use crate::check::sample::setting::FEWEST;
use crate::check::sample::without_value;
use crate::check::state::sampled_state::SampledState;
use crate::check::state::{counterexample, residual};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Compared, Counterexample, Finding};

/// Checks that `hamiltonian`, a formula of coordinates and momenta, generates the motion of the system.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(hamiltonian: &Expr, context: &Context<'_>) -> Result<Finding> {
    // Hamilton's equations differentiate it once, as a time derivative does.
    let rate = Expr::new(Node::TimeDerivative(1, Box::new(hamiltonian.clone())), hamiltonian.span);
    Ok(context.for_every_function(judged(hamiltonian, context)?, &[&rate]))
}

fn judged(hamiltonian: &Expr, context: &Context<'_>) -> Result<Finding> {
    let model = context.model;
    if model.system.is_none() {
        return Ok(context.finding(
            Code::NoMotion,
            Verdict::Undecided,
            "there is no system whose motion the formula could generate; name a \"system\", or a Lagrangian under \
             \"means\"",
        ));
    }
    let varied = match independent_names(hamiltonian, context) {
        Ok(varied) => varied,
        Err(finding) => return Ok(*finding),
    };
    let mode = context.mode(true, &[hamiltonian]);
    let ensemble = context.ensemble(mode, false, context.options.points)?;
    if ensemble.states.is_empty() {
        return Ok(context.no_state(&ensemble));
    }
    let (mut points, mut worst) = (0, 0.0_f64);
    for (state, base) in ensemble.states.iter().zip(&ensemble.bases) {
        let base: Vec<Dual<RunningError>> = base.iter().map(|x| Dual::from_re(RunningError::new(*x))).collect();
        let mut free = SampledState::new(model, mode, &base, &ensemble.rules)?;
        let Some(known) = state.quantities() else { continue };
        let values: Vec<RunningError> = state.coordinates().iter().chain(&known.momenta).map(Series::value).collect();
        for place in 0..varied.len() {
            let slope = match slope(hamiltonian, &mut free, (&varied, place), &values, context) {
                Ok(slope) => slope,
                Err(finding) => return Ok(*finding),
            };
            // The first half of the names are the coordinates: there ∂H/∂q is −ṗ, and in the other half ∂H/∂p is q̇.
            let n = varied.len() / 2;
            let (printed, derived, of) = match place < n {
                true => (-slope, known.momenta[place].derivative().value(), n + place),
                false => (slope, state.coordinates()[place - n].derivative().value(), place - n),
            };
            let difference = printed - derived;
            if !printed.value.is_finite() || !derived.value.is_finite() {
                continue;
            }
            let residual = difference.value.abs() / difference.magnitude.max(f64::MIN_POSITIVE);
            if !residual::vanishes(difference) {
                let equation = format!("the rate of {}", text::plain(&model.name(varied[of][0])));
                let counterexample = Counterexample {
                    state: counterexample::values(&[hamiltonian], state),
                    lhs: printed.value,
                    rhs: derived.value,
                    entry: Some(equation.clone()),
                    compared: Compared::Sides,
                };
                let message = format!("Hamilton's equations from this formula do not give {equation}");
                return Ok(Finding {
                    points: points + 1,
                    tried: ensemble.tried,
                    max_residual: Some(residual),
                    counterexample: Some(counterexample),
                    ..context.finding(Code::NotTheHamiltonian, Verdict::Refuted, message)
                });
            }
            worst = worst.max(residual);
        }
        points += 1;
    }
    if points < FEWEST.min(context.options.points) {
        let part = without_value::part(&[hamiltonian], &ensemble.states);
        let message = without_value::message((points, ensemble.tried), part.as_ref(), context.model);
        return Ok(context.finding(Code::TooFewStates, Verdict::Undecided, message));
    }
    let finding = Finding {
        points,
        tried: ensemble.tried,
        max_residual: Some(worst),
        ..context.finding(Code::Holds, Verdict::Verified, "Hamilton's equations from this formula give the motion")
    };
    let claim = Generates { hamiltonian, varied: &varied };
    Ok(decide::decide(&[hamiltonian], context, &ensemble, &claim).stamp(finding))
}

/// The names of each coordinate, then of each momentum, by which a Hamiltonian is differentiated.
///
/// # Errors
/// The finding where the formula has another name that the state determines, or where a momentum has no name.
fn independent_names(hamiltonian: &Expr, context: &Context<'_>) -> Independent<Vec<Vec<SymbolId>>> {
    let model = context.model;
    if let Some(name) = fixed_by_the_state(hamiltonian, model) {
        let name = text::plain(&name);
        let message = format!(
            "{name} is neither a coordinate nor a momentum; under \"define\", write {name} as a formula of \
             coordinates and momenta"
        );
        return Err(Box::new(context.finding(Code::NotIndependent, Verdict::Undecided, message)));
    }
    // A momentum may have several names.
    let named = |wanted: Quantity| -> Vec<SymbolId> {
        let is = |(_, meaning): &(usize, &Option<Meaning>)| matches!(meaning, Some(Meaning::System(q)) if *q == wanted);
        model.meanings.iter().enumerate().filter(is).map(|(at, _)| SymbolId(at)).collect()
    };
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|v| v.symbol).collect();
    let momenta: Vec<Vec<SymbolId>> = (0..coordinates.len()).map(|k| named(Quantity::Momentum(k))).collect();
    if let Some(k) = momenta.iter().position(Vec::is_empty) {
        let latex = model.name(coordinates[k]);
        let message = format!(
            "the momentum of {} has no name; write \"means\": {{ \"p\": {} }} with its name in the notes in place of p",
            text::plain(&latex),
            in_json(&format!("momentum of {latex}"))
        );
        return Err(Box::new(context.finding(Code::UndeclaredName, Verdict::Undecided, message)));
    }
    // The names of each coordinate and of each momentum.
    Ok(coordinates.iter().map(|id| vec![*id]).chain(momenta).collect())
}

/// What follows with the coordinates and the momenta as independent names, or the finding that nothing does.
type Independent<T> = std::result::Result<T, Box<Finding>>;

/// The derivative of a Hamiltonian by the names at a place, where the names have the given values.
fn slope(
    hamiltonian: &Expr,
    free: &mut SampledState<'_, Dual<RunningError>>,
    (varied, place): (&[Vec<SymbolId>], usize),
    values: &[RunningError],
    context: &Context<'_>,
) -> Independent<RunningError> {
    let seeded: Vec<(SymbolId, Series<Dual<RunningError>>)> = (0..varied.len())
        .flat_map(|other| varied[other].iter().map(move |id| (other, *id)))
        .map(|(other, id)| {
            let slope = RunningError::new(if other == place { 1.0 } else { 0.0 });
            (id, Series::from_derivatives(&[Dual::new(values[other], slope)]))
        })
        .collect();
    free.set_only(&seeded);
    let failed = |code, message: &str| Err(Box::new(context.finding(code, Verdict::Unreadable, message)));
    match evaluate(hamiltonian, free, &[]) {
        Ok(Value::Scalar(value)) => Ok(value.value().eps),
        Ok(_) => failed(Code::ShapeMismatch, "a Hamiltonian must be a number, and this is not one"),
        Err(Unavailable::Derivative(_)) => failed(
            Code::NotIndependent,
            "a Hamiltonian must be written in coordinates and momenta, and this contains velocities",
        ),
        Err(reason) => Err(Box::new(context.unavailable(&reason))),
    }
}

/// The name of a quantity in a formula that the state determines and that is not a coordinate or momentum. Its derivatives
/// by these are not known from its name.
fn fixed_by_the_state(formula: &Expr, model: &Model) -> Option<String> {
    formula.symbols().into_iter().find_map(|(id, _)| match model.meaning(id)? {
        Meaning::System(Quantity::Momentum(_)) => None,
        Meaning::System(_) | Meaning::Frame(_) => Some(model.name(id)),
        Meaning::Defined(formula) => fixed_by_the_state(formula, model),
        _ => None,
    })
}

/// The claim that a formula generates the motion, for polynomial identity testing.
struct Generates<'a> {
    hamiltonian: &'a Expr,
    /// The names of each coordinate, then of each momentum.
    varied: &'a [Vec<SymbolId>],
}

impl Claim for Generates<'_> {
    /// ∂H/∂p − q̇ and ∂H/∂q + ṗ. A series in time is a dual number as well: what the formula's rate changes by, when one
    /// symbol's rate becomes 1, is its derivative by the symbol.
    fn differences<F: Modulus>(&self, state: &mut SampledState<'_, Modular<F>>) -> Differences<F> {
        let none = "a formula without a motion";
        let momenta = state.quantities().ok_or(none)?.momenta.clone();
        let coordinates = state.coordinates().to_vec();
        let values: Vec<Series<Modular<F>>> = coordinates.iter().chain(&momenta).copied().collect();
        let mut rate = |varied: Option<usize>| {
            let slope = |at: usize| Modular::from(if varied == Some(at) { 1.0 } else { 0.0 });
            let series = |at: usize| Series::from_derivatives(&[values[at].value(), slope(at)]);
            let names = self.varied.iter().enumerate().flat_map(|(at, names)| names.iter().map(move |id| (at, *id)));
            let point: Vec<_> = names.map(|(at, id)| (id, series(at))).collect();
            state.set_only(&point);
            let found = evaluate_to(2, self.hamiltonian, state, &[]);
            state.set_only(&[]);
            match found {
                Ok(Value::Scalar(value)) => value.nth_derivative_value(1).ok_or(none.to_owned()),
                _ => Err(none.to_owned()),
            }
        };
        let still = rate(None)?;
        let n = coordinates.len();
        let moved = |at: usize| values[at].derivative().value();
        let mut all = Vec::new();
        for at in 0..n {
            all.push(rate(Some(n + at))? - still - moved(at));
            all.push(rate(Some(at))? - still + moved(n + at));
        }
        Ok(all)
    }
}
