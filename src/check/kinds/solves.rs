//! Claims that formulas solve an earlier equation for an unknown.
//!
//! Each printed branch, substituted for the unknown, must satisfy the equation; the branches must differ; and the equation
//! must have no other real root ([`super::root_isolation`]).

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, SymbolId, Value, text};
use crate::scalar::{RunningError, Series};

use crate::check::certificate::solutions::certify_solutions;
use crate::check::judge::identity;
use crate::check::judge::mutants::mutants_of;
use crate::check::kinds::shapes::root_isolation::count_roots_on_grid;
use crate::check::model::Model;
use crate::check::model::claim::{Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::sampler::contains;
use crate::check::sample::setting::FEWEST;
use crate::check::state::counterexample::counterexample;
use crate::check::state::residual;
use crate::check::state::residual::{Failure, Point};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Compared, Counterexample, Finding};

/// The longest equation that a message prints, in characters.
const LONGEST: usize = 60;

/// The equality of a chain that `branches` are to solve for `unknown`. One that holds for every value of it, as that of a name with its
/// formula, is solved by anything; of the others it is the first that the branches satisfy, or else the first that contains the unknown.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn equality_for<'l>(
    chain: &'l [Link],
    unknown: SymbolId,
    branches: &[Expr],
    context: &Context<'_>,
) -> Result<Option<&'l Link>> {
    let is_about = |link: &Link| mentions(&link.lhs, unknown) || mentions(&link.rhs, unknown);
    if let [only] = chain
        && !is_about(only)
    {
        return Ok(Some(only));
    }
    let mut first = None;
    for link in chain.iter().filter(|link| is_about(link)) {
        if !is_equality(link.relation) || identity::check(link, context)?.verdict.passes() {
            continue;
        }
        let mut satisfies = true;
        for branch in branches {
            satisfies &= check_branch(link, unknown, branch, context)?.verdict.holds();
        }
        if satisfies {
            return Ok(Some(link));
        }
        first = first.or(Some(link));
    }
    Ok(first)
}

/// Checks that `branch` is a solution of `target` for `unknown`; there may be others.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check_branch(target: &Link, unknown: SymbolId, branch: &Expr, context: &Context<'_>) -> Result<Finding> {
    check_solutions(target, unknown, std::slice::from_ref(branch), false, context)
}

/// Checks that `branches` are the solutions of `target` for `unknown`, and all of them.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(target: &Link, unknown: SymbolId, branches: &[Expr], context: &Context<'_>) -> Result<Finding> {
    check_solutions(target, unknown, branches, true, context)
}

fn check_solutions(
    target: &Link,
    unknown: SymbolId,
    branches: &[Expr],
    all_of_them: bool,
    context: &Context<'_>,
) -> Result<Finding> {
    let finding = judged(target, unknown, branches, all_of_them, context)?;
    let formulas: Vec<&Expr> = [&target.lhs, &target.rhs].into_iter().chain(branches).collect();
    Ok(context.for_every_function(finding, &formulas))
}

fn judged(
    target: &Link,
    unknown: SymbolId,
    branches: &[Expr],
    all_of_them: bool,
    context: &Context<'_>,
) -> Result<Finding> {
    if !mentions(&target.lhs, unknown) && !mentions(&target.rhs, unknown) {
        let name = context.model.name(unknown);
        return Ok(context.finding(
            Code::VariableAbsent,
            Verdict::Undecided,
            format!("{name} does not occur in the equation to be solved; correct the name"),
        ));
    }
    let is_rated = [&target.lhs, &target.rhs].into_iter().any(|side| contains_rate(side, unknown, context.model));
    if is_rated {
        let name = context.model.name(unknown);
        let way_out = match context.model.has_motion() {
            true => format!("remove \"solves\", and a formula for {name} is checked against the motion"),
            false => "put the equation under \"laws\", and remove \"solves\"".to_owned(),
        };
        let message = format!(
            "the equation contains a time derivative of {name}, and \"solves\" is for equations without one; {way_out}"
        );
        return Ok(context.finding(Code::ClaimDoesNotFit, Verdict::Undecided, message));
    }
    let mut formulas = vec![&target.lhs, &target.rhs];
    formulas.extend(branches);
    let mode = context.mode(false, &formulas);
    // States without real roots are not usable, so more states are sampled than are needed.
    let mut ensemble = context.ensemble(mode, false, 3 * context.options.points)?;
    if ensemble.states.is_empty() {
        return Ok(context.no_state(&ensemble));
    }
    let (mut points, mut residual, mut counted) = (0, 0.0_f64, 0);
    let mut used: Vec<usize> = Vec::new();
    for at in 0..ensemble.states.len() {
        if points == context.options.points {
            break;
        }
        match at_state((target, unknown), (branches, all_of_them), &mut ensemble.states[at], (context, points))? {
            AtState::Useless => {}
            AtState::Decided(finding) => return Ok(*finding),
            AtState::Holds { worst, is_counted } => {
                residual = residual.max(worst);
                counted += usize::from(is_counted);
                points += 1;
                used.push(at);
            }
        }
    }
    if points < FEWEST.min(context.options.points) {
        let message =
            format!("only {points} of {} sampled states have real solutions; narrow the ranges", ensemble.tried);
        return Ok(context.finding(Code::TooFewStates, Verdict::Undecided, message));
    }
    if 2 * counted < points {
        let message = format!(
            "a search on a grid found exactly the given roots at only {counted} of {points} states; narrow the ranges"
        );
        return Ok(context.finding(Code::NotDecided, Verdict::Undecided, message));
    }
    // A mutant of one branch may be the other branch, so only all branches together are tested with mutants.
    if all_of_them
        && let Some(change) = surviving_change(target, unknown, branches, context, &mut ensemble.states, &used)
    {
        let message = format!(
            "the sampled states do not distinguish this from the same solution with {change}; widen the ranges"
        );
        return Ok(context.finding(Code::MutantPasses, Verdict::Undecided, message));
    }
    let number = branches.len();
    let message = match all_of_them {
        true => {
            let these = match number {
                1 => "this is the only real solution".to_owned(),
                _ => format!("these are all {number} real solutions"),
            };
            format!("{these}; at {counted} of {points} states a search on a grid found no other")
        }
        false => "this satisfies the equation".to_owned(),
    };
    let finding = Finding {
        points,
        tried: ensemble.tried,
        max_residual: Some(residual),
        ..context.finding(Code::Holds, Verdict::Verified, message)
    };
    Ok(certify_solutions(target, unknown, branches, all_of_them, context, &ensemble).stamp(finding))
}

/// What one state says of a claim that branches solve an equation.
enum AtState {
    /// Not each branch has a real value there.
    Useless,
    /// The finding on the claim.
    Decided(Box<Finding>),
    /// Each branch solves the equation.
    Holds {
        /// The largest residual.
        worst: f64,
        /// Whether as many roots were counted as there are branches.
        is_counted: bool,
    },
}

/// Tests at one state that each branch solves the equation, that no two are the same, and that there is no other root. `points`
/// states said so before.
fn at_state(
    (target, unknown): (&Link, SymbolId),
    (branches, all_of_them): (&[Expr], bool),
    state: &mut SampledState<'_, RunningError>,
    (context, points): (&Context<'_>, usize),
) -> Result<AtState> {
    let decided = |finding: Finding| Ok(AtState::Decided(Box::new(finding)));
    let mut roots = Vec::new();
    for branch in branches {
        match state.now(branch, &[]) {
            Ok(Value::Scalar(root)) if root.value.is_finite() => roots.push(root),
            Ok(_) => {}
            Err(reason) => return decided(context.unavailable(&reason)),
        }
    }
    if roots.len() < branches.len() {
        return Ok(AtState::Useless);
    }
    let mut worst = 0.0_f64;
    for root in &roots {
        match substituted(target, unknown, *root, state) {
            Ok(Point::Holds(found)) => worst = worst.max(found),
            Ok(Point::Fails(failure)) => {
                state.set_only(&[(unknown, Series::constant(*root))]);
                return decided(refuted(target, context, state, &failure, points));
            }
            Ok(_) => {}
            Err(reason) => return decided(context.unavailable(&reason)),
        }
    }
    for (i, a) in roots.iter().enumerate() {
        if roots[..i].iter().any(|b| residual::vanishes(*a - *b)) {
            let message = "two of the given solutions are the same";
            return decided(context.finding(Code::RepeatedSolution, Verdict::Refuted, message));
        }
    }
    let all = if all_of_them { count_roots(target, unknown, state) } else { roots.len() };
    if all > roots.len() {
        let message = format!("the equation has {all} real solutions, but the notes give {}", roots.len());
        let failure = Failure { lhs: all as f64, rhs: roots.len() as f64, residual: 1.0, entry: None };
        let compared = Compared::Counts("real solutions");
        let counterexample = Some(Counterexample { compared, ..counterexample(target, state, &failure) });
        let finding = context.finding(Code::MissingSolutions, Verdict::Refuted, message);
        return decided(Finding { counterexample, ..finding });
    }
    Ok(AtState::Holds { worst, is_counted: all == roots.len() })
}

/// The change of a mutant of a branch that solves the equation as well.
fn surviving_change(
    target: &Link,
    unknown: SymbolId,
    branches: &[Expr],
    context: &Context<'_>,
    states: &mut [SampledState<'_, RunningError>],
    used: &[usize],
) -> Option<String> {
    for branch in branches {
        let zero = Expr::integer(0, branch.span);
        let link = Link { lhs: zero, relation: target.relation, rhs: branch.clone(), free: Vec::new() };
        for mutant in mutants_of(&link, context.model) {
            let survives = used.iter().all(|at| {
                let state = &mut states[*at];
                let Ok(Value::Scalar(value)) = state.now(&mutant.link.rhs, &[]) else { return false };
                if !contains(&context.model.range(unknown), value.value) {
                    return false;
                }
                // A mutant that equals another branch is a solution by itself.
                let other = branches.iter().any(
                    |other| matches!(state.now(other, &[]), Ok(Value::Scalar(r)) if residual::vanishes(r - value)),
                );
                !other && matches!(substituted(target, unknown, value, state), Ok(Point::Holds(_) | Point::Useless))
            });
            if survives {
                return Some(mutant.change);
            }
        }
    }
    None
}

fn substituted(
    target: &Link,
    unknown: SymbolId,
    value: RunningError,
    state: &mut SampledState<'_, RunningError>,
) -> Result<Point, crate::formula::Unavailable> {
    state.set_only(&[(unknown, Series::constant(value))]);
    let point = residual::test(target, state);
    state.set_only(&[]);
    point
}

fn refuted(
    target: &Link,
    context: &Context<'_>,
    state: &SampledState<'_, RunningError>,
    failure: &Failure,
    points: usize,
) -> Finding {
    let symbols = &context.model.symbols;
    let equation = format!("{} = {}", text::formula(&target.lhs, symbols), text::formula(&target.rhs, symbols));
    let message = match equation.chars().count() > LONGEST {
        true => "this does not satisfy the equation that it should solve".to_owned(),
        false => format!("this does not satisfy {equation}"),
    };
    Finding {
        points: points + 1,
        max_residual: Some(failure.residual),
        counterexample: Some(counterexample(target, state, failure)),
        ..context.finding(Code::NotASolution, Verdict::Refuted, message)
    }
}

/// The number of real roots of `target` in the unknown at a state.
fn count_roots(target: &Link, unknown: SymbolId, state: &mut SampledState<'_, RunningError>) -> usize {
    let range = state.model().range(unknown);
    let roots = count_roots_on_grid(
        &range,
        |x| {
            state.set_only(&[(unknown, Series::from_derivatives(&[RunningError::new(x)]))]);
            match (state.now(&target.lhs, &[]), state.now(&target.rhs, &[])) {
                (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) => (a - b).value,
                _ => f64::NAN,
            }
        },
        |_| None,
    );
    state.set_only(&[]);
    roots
}

/// Whether a formula contains a rate of a symbol, also in the formulas of its names.
pub(crate) fn contains_rate(formula: &Expr, id: SymbolId, model: &Model) -> bool {
    let mut found = false;
    formula.walk(&mut |part| {
        found = found
            || match &part.node {
                Node::TimeDerivative(_, of) => model.depends_on(of, &[id]),
                Node::Symbol { id: name, dots, .. } if *dots > 0 => {
                    *name == id || matches!(model.meaning(*name), Some(Meaning::Defined(inner)) if model.depends_on(inner, &[id]))
                }
                Node::Symbol { id: name, .. } if *name != id => {
                    matches!(model.meaning(*name), Some(Meaning::Defined(inner)) if contains_rate(inner, id, model))
                }
                _ => false,
            };
    });
    found
}

/// Whether a formula contains a symbol.
pub fn mentions(expr: &Expr, id: SymbolId) -> bool {
    expr.symbols().iter().any(|(known, _)| *known == id)
}
