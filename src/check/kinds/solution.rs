//! Solutions of the motion: a display that gives a coordinate as a function of the time and of constants, `x = A \cos \omega t`,
//! or as a function of another coordinate, the orbit `r = p/(1 + e \cos \phi)`.
//!
//! q = f is a solution if the acceleration on shell is f̈ wherever q = f and q̇ = ḟ. So these two are hypotheses at one instant,
//! and q̈ = f̈ is the claim. Nothing is integrated. It works for every system and for laws, in the numbers of a state and over the
//! prime field alike. The solutions that other displays print for other coordinates are hypotheses too.
//!
//! A solution of the linear equation for small oscillations is often printed with = in place of ≈. So a formula that does not solve
//! the equations of motion is put into their first order about the rest position, and passes if it solves that.

use num_dual::Dual;

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation, SymbolId, Value, text};
use crate::scalar::{RunningError, Series};

use crate::check::judge::identity;
use crate::check::kinds::printed_solution::{Solution, constants_of_integration};
use crate::check::kinds::solution_of_laws;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::{Meaning, Quantity, Variable};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::sample::setting::FEWEST;
use crate::check::state::residual;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// Checks that a formula of the time solves the equations of motion; `others` are the solutions printed for other coordinates.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn check(solution: &Solution, others: &[Solution], context: &Context<'_>) -> Result<Finding> {
    let name = text::plain(&context.model.name(solution.coordinate));
    let refuted = format!("this does not satisfy the equations of motion for {name}");
    if let Some(found) = solution_of_laws::by_substitution(solution, others, context)? {
        return Ok(match found.verdict {
            Verdict::Refuted => {
                Finding { message: format!("{refuted}: {}", found.message), code: Code::NotASolution, ..found }
            }
            verdict if verdict.holds() => Finding { message: solved(solution, &name, context.model), ..found },
            _ => found,
        });
    }
    let exact = is_on_shell(solution, others, context)?;
    if exact == Some(false) {
        if let Some(found) = in_first_order(solution, others, context)? {
            return Ok(found);
        }
        if !context.options.explain {
            return Ok(context.finding(Code::NotASolution, Verdict::Refuted, refuted));
        }
    }
    // Another display may be wrong: the equation of this coordinate alone decides, if it can.
    let alone = on_the_solution(solution, &[], context)?;
    let finding = match alone.verdict.holds() || others.is_empty() {
        true => alone,
        false => on_the_solution(solution, others, context)?,
    };
    if finding.verdict.holds() {
        return Ok(Finding { message: solved(solution, &name, context.model), ..finding });
    }
    // Without acceleration both sides of the claim are 0, which says nothing about factors in an identity.
    let is_uniform = exact == Some(true) || exact.is_none() && context.model.system.is_none() && solution.order > 1;
    if is_uniform && finding.code == Code::SideAlwaysZero {
        let message = format!("solves the equations of motion for {name}");
        let points = FEWEST.min(context.options.points);
        let found = context.verified(message, "that an acceleration is 0");
        return Ok(Finding { points, tried: points, ..found });
    }
    match finding.verdict {
        Verdict::Refuted => {
            let sides = finding.counterexample.as_ref().map_or("", |_| match solution.order {
                1 => "; below, the left side is the rate on shell, the right side that of the formula",
                _ => "; below, the left side is the acceleration on shell, the right side that of the formula",
            });
            Ok(Finding { message: format!("{refuted}{sides}"), code: Code::NotASolution, ..finding })
        }
        _ => Ok(finding),
    }
}

/// The message that a formula solves the equations of motion.
fn solved(solution: &Solution, name: &str, model: &Model) -> String {
    let constants = constants_of_integration(solution, model);
    let names: Vec<String> = constants.iter().map(|id| text::plain(&model.name(*id))).collect();
    let constants = match names.as_slice() {
        [] => String::new(),
        names => format!("; constants of integration: {}", names.join(", ")),
    };
    format!("solves the equations of motion for {name}{constants}")
}

/// Whether the accelerations on shell are those of the formula at a few states, with the printed solutions of the other
/// coordinates or with any values of these. `None` without a system, and where no state gives a number.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn is_on_shell(solution: &Solution, others: &[Solution], context: &Context<'_>) -> Result<Option<bool>> {
    let model = context.model;
    let Some(system) = model.system.as_deref().filter(|_| solution.dots == 0) else { return Ok(None) };
    let mode = context.mode(false, &[&solution.link(2).rhs]);
    let ensemble = context.ensemble(mode, false, FEWEST)?;
    let Some(place) = model.coordinates.iter().position(|c| c.symbol == solution.coordinate) else { return Ok(None) };
    let agrees = |others: &[Solution], state: &SampledState<'_, RunningError>| {
        let jet = |order: u8| -> Option<Vec<RunningError>> {
            let known = |(coordinate, jet): (&Variable, &Series<RunningError>)| {
                let printed = std::iter::once(solution).chain(others);
                match printed.into_iter().find(|known| known.coordinate == coordinate.symbol && known.dots == 0) {
                    None => jet.nth_derivative_value(usize::from(order)),
                    Some(known) => match state.now(&known.sides(order).1, &[]) {
                        Ok(Value::Scalar(value)) => Some(value),
                        _ => None,
                    },
                }
            };
            model.coordinates.iter().zip(state.coordinates()).map(known).collect()
        };
        let parameters = model.parameters.iter().map(|at| state.base.constant(*at).first().copied());
        let parameters = parameters.collect::<Option<Vec<RunningError>>>()?;
        let on_shell = system.accelerations(state.base.time, &jet(0)?, &jet(1)?, &parameters).ok()?;
        let printed = jet(2)?[place];
        printed.value.is_finite().then(|| residual::vanishes(on_shell[place] - printed))
    };
    let all = |others: &[Solution]| {
        let found: Vec<bool> = ensemble.states.iter().filter_map(|state| agrees(others, state)).collect();
        (!found.is_empty()).then(|| found.into_iter().all(|agrees| agrees))
    };
    Ok(match (all(&[]), others.is_empty()) {
        (Some(true), _) => Some(true),
        (alone, true) => alone,
        (_, false) => all(others),
    })
}

fn on_the_solution(solution: &Solution, others: &[Solution], context: &Context<'_>) -> Result<Finding> {
    let hypotheses: Vec<Hypothesis> = context
        .hypotheses
        .iter()
        .cloned()
        .chain(solution.hypotheses())
        .chain(others.iter().flat_map(Solution::hypotheses))
        .collect();
    identity::check(&solution.claim(), &Context { hypotheses: &hypotheses, on_shell: Some(true), ..*context })
}

/// The finding that the solutions satisfy the equations of motion to first order about the rest position at 0, if they do.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn in_first_order(
    solution: &Solution,
    others: &[Solution],
    context: &Context<'_>,
) -> Result<Option<Finding>> {
    let model = context.model;
    let Some(system) = model.system.as_deref().filter(|_| solution.dots == 0) else { return Ok(None) };
    let all: Vec<Option<&Solution>> = model
        .coordinates
        .iter()
        .map(|coordinate| {
            let mut printed = std::iter::once(solution).chain(others);
            printed.find(|known| known.coordinate == coordinate.symbol && known.dots == 0)
        })
        .collect();
    let mode = context.mode(false, &[&solution.link(2).rhs]);
    let ensemble = context.ensemble(mode, false, context.options.points)?;
    let mut worst = 0.0_f64;
    let mut points = 0;
    for state in &ensemble.states {
        let rate = |known: &Option<&Solution>, order: u8| match known {
            None => Some(RunningError::new(0.0)),
            Some(known) => match state.now(&known.sides(order).1, &[]) {
                Ok(Value::Scalar(value)) => Some(value),
                _ => None,
            },
        };
        let jet = |order: u8| -> Option<Vec<Dual<RunningError>>> {
            let small = |value| Dual::new(RunningError::new(0.0), value);
            all.iter().map(|known| rate(known, order).map(small)).collect()
        };
        let (Some(q), Some(v), Some(a)) = (jet(0), jet(1), jet(2)) else { return Ok(None) };
        // Where the frequency of the formula is no real number, there is nothing to test.
        if [&q, &v, &a].into_iter().flatten().any(|value| !value.eps.value.is_finite()) {
            continue;
        }
        let parameter = |at: &usize| state.base.constant(*at).first().copied().map(Dual::from_re);
        let Some(parameters) = model.parameters.iter().map(parameter).collect::<Option<Vec<_>>>() else {
            return Ok(None);
        };
        let left = system.euler_lagrange(Dual::from_re(state.base.time), &q, &v, &parameters, &a);
        // Coordinates without a formula are at 0 here, which must be a place of rest.
        if left.iter().any(|row| !residual::vanishes(row.re)) {
            return Ok(None);
        }
        for (place, row) in left.iter().enumerate().filter(|(place, _)| all[*place].is_some()) {
            let inertia = system.mass_matrix(Dual::from_re(state.base.time), &q, &v, &parameters)[(place, place)].re;
            // Without inertia, as of an angle at r = 0, the equation says nothing of the motion.
            if inertia.value == 0.0 {
                return Ok(None);
            }
            let size = (inertia * a[place].eps).value.abs();
            if !residual::vanishes(row.eps) {
                return Ok(None);
            }
            if size > 0.0 {
                worst = worst.max((row.eps.value / size).abs());
            }
        }
        points += 1;
    }
    if points < FEWEST.min(context.options.points) {
        return Ok(None);
    }
    let name = text::plain(&model.name(solution.coordinate));
    let message = format!("solves the equations of motion for {name} to first order, as for small oscillations");
    let found = context.verified(message, "equations of motion that are replaced by their first order");
    Ok(Some(Finding { points, tried: ensemble.tried, max_residual: Some(worst), ..found }))
}

/// Whether a link may print an orbit: q, or 1/q, as a function of other coordinates.
pub(crate) fn is_an_orbit(link: &Link, model: &Model) -> bool {
    let moves = |(id, _): &(SymbolId, u8)| model.is_coordinate(*id);
    let coordinates = |side: &Expr| side.symbols().into_iter().filter(|symbol| moves(symbol)).collect::<Vec<_>>();
    let (left, right) = (coordinates(&link.lhs), coordinates(&link.rhs));
    let is_still = |side: &[(SymbolId, u8)]| side.iter().all(|(_, dots)| *dots == 0);
    let alone = match &link.lhs.node {
        Node::Symbol { .. } => true,
        Node::Quotient(above, below) => above.symbols().is_empty() && below.as_plain_symbol().is_some(),
        _ => false,
    };
    alone
        && model.has_motion()
        && is_equality(link.relation)
        && left.len() == 1
        && !right.is_empty()
        && is_still(&left)
        && is_still(&right)
        && !right.contains(&left[0])
        && link.free.is_empty()
}

/// Whether a link may print a solution that is not solved for its coordinate: `\\sin\\frac\\theta2 = \\tanh\\omega_0t`, a formula of one coordinate
/// on the left, and on the right the time, and no coordinate but in names of constants of the motion.
fn is_implicit(link: &Link, model: &Model) -> bool {
    let moves = |(id, _): &(SymbolId, u8)| model.is_coordinate(*id);
    let left: Vec<(SymbolId, u8)> = link.lhs.symbols().into_iter().filter(moves).collect();
    let is_one = matches!(left.as_slice(), [(_, 0)]);
    // A law of first order leaves one constant, which such a formula may define.
    is_one
        && model.system.is_some()
        && model.coordinates.len() == 1
        && is_equality(link.relation)
        && link.free.is_empty()
        && link.lhs.as_plain_symbol().is_none()
        && !model.contains_time(&link.lhs)
        && model.contains_time(&link.rhs)
        && !link.rhs.symbols().iter().any(moves)
}

/// Whether a link may print the motion of a name with a formula: the length `s = 4a\\sin(\\theta/2)` of an arc as `s(t) = s_0\\cos\\omega t`.
pub(crate) fn is_of_a_name(link: &Link, model: &Model) -> bool {
    let moves = |of: &Expr| model.coordinates.iter().any(|q| model.depends_on(of, &[q.symbol]));
    let is_named = link.lhs.as_plain_symbol().is_some_and(|id| matches!(model.meaning(id), Some(Meaning::Defined(_))));
    is_named
        && model.has_motion()
        && is_equality(link.relation)
        && link.free.is_empty()
        && moves(&link.lhs)
        && !moves(&link.rhs)
        && model.contains_time(&link.rhs)
        && !model.contains_time(&link.lhs)
}

/// Whether a link may print a coordinate by the time and by momenta that keep their values: `\\phi(t) = \\phi_0 + \\frac{p_\\phi}{mR^2}t`.
///
/// # Errors
/// When no state can be drawn.
fn is_by_momenta(link: &Link, context: &Context<'_>) -> Result<bool> {
    let model = context.model;
    let is_momentum = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::System(Quantity::Momentum(_))));
    let is_known = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Constant(_) | Meaning::Time));
    let names: Vec<SymbolId> = link.rhs.symbols().into_iter().map(|(id, _)| id).collect();
    let is_one = link.lhs.as_plain_symbol().is_some_and(|id| model.is_coordinate(id));
    let fits = is_one
        && is_equality(link.relation)
        && link.free.is_empty()
        && model.contains_time(&link.rhs)
        && names.iter().any(is_momentum)
        && names.iter().all(|id| is_momentum(id) || is_known(id));
    for id in names.iter().filter(|id| fits && is_momentum(id)) {
        let rate = Expr::new(Node::Symbol { id: *id, indices: Vec::new(), dots: 1 }, link.rhs.span);
        let zero = Expr::integer(0, link.rhs.span);
        let keeps = Link { lhs: rate, relation: Relation::Equal, rhs: zero, free: Vec::new() };
        let on_shell = Context { hypotheses: &[], on_shell: Some(true), ..context.quick() };
        let ensemble = on_shell.ensemble(on_shell.mode(true, &[&keeps.lhs]), false, FEWEST)?;
        if !run(&keeps, &ensemble.states).is_ok_and(|found| found.failure.is_none() && found.points > 0) {
            return Ok(false);
        }
    }
    Ok(fits)
}

/// The finding that a link gives the motion of a name with a formula, or of a coordinate by conserved momenta; `None`, if it prints no such
/// relation or the motion does not stay on it.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn by_name(link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
    let order = match is_of_a_name(link, context.model) {
        true => 1,
        // The momentum in the formula says what the velocity is.
        false if is_by_momenta(link, context)? => 0,
        false => return Ok(None),
    };
    let name = text::plain(&link.lhs.as_plain_symbol().map_or_else(String::new, |id| context.model.name(id)));
    let found = stays_on(link, order, context)?;
    Ok(found.map(|finding| Finding { message: format!("solves the equations of motion for {name}"), ..finding }))
}

/// The finding that a link gives the motion without being solved for the coordinate; `None`, if it prints no such relation or the motion does
/// not stay on it.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn implicit(link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
    let model = context.model;
    if !is_implicit(link, model) {
        return Ok(None);
    }
    // The energy of the motion in the formula leaves one instant free, and not two constants.
    let has_energy =
        link.rhs.symbols().iter().any(|(id, _)| {
            model.coordinates.iter().any(|coordinate| model.symbol_depends_on(*id, &[coordinate.symbol]))
        });
    let found = stays_on(link, if has_energy { 0 } else { 1 }, context)?;
    Ok(found.map(|finding| Finding { message: "solves the equations of motion".to_owned(), ..finding }))
}

/// The finding that a relation between coordinates is an orbit of the motion; `None`, if the link prints no such relation or it
/// is no orbit.
///
/// # Errors
/// When the system's mass matrix is singular.
pub(crate) fn orbit(link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
    if !is_an_orbit(link, context.model) {
        return Ok(None);
    }
    let found = stays_on(link, 1, context)?;
    Ok(found.map(|finding| Finding { message: "is an orbit of the motion".to_owned(), ..finding }))
}

/// The finding that a motion for which a relation and its rates up to an order hold at an instant stays on it, if it does: the next rate
/// holds too.
fn stays_on(link: &Link, order: u8, context: &Context<'_>) -> Result<Option<Finding>> {
    let rate = |side: &Expr, order: u8| match order {
        0 => side.clone(),
        order => Expr::new(Node::TimeDerivative(order, Box::new(side.clone())), side.span),
    };
    let derived = |order: u8| Link { lhs: rate(&link.lhs, order), rhs: rate(&link.rhs, order), ..link.clone() };
    let on_it = (0..=order).map(|order| Hypothesis::of(derived(order), false));
    let hypotheses: Vec<Hypothesis> = context.hypotheses.iter().cloned().chain(on_it).collect();
    let context = Context { hypotheses: &hypotheses, on_shell: Some(true), ..*context };
    // Most texts that are tried in the place of an orbit fail at the first state.
    let claim = derived(order + 1);
    let ensemble = context.ensemble(context.mode(true, &[&claim.lhs, &claim.rhs]), false, FEWEST)?;
    if run(&claim, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_some()) {
        return Ok(None);
    }
    let finding = identity::check(&claim, &context)?;
    Ok(finding.verdict.holds().then_some(finding))
}
