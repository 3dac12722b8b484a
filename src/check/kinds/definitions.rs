//! The test of a definition: each mutant of it must make another equation fail.
//!
//! A definition cannot be false by itself. It passes if every mutant of it, put in its place, makes an equation fail that
//! uses the symbol.
//!
//! # How a definition can be checked
//!
//! It cannot be wrong, so being used proves nothing. Every mutant of it is put in its place, at the states where
//! the equations that use the name hold, and must break one of them. A mutant that breaks none, and is not the same
//! formula in other words, makes the verdict `undecided`. If a law names the definition, the equations that hold by law
//! are tried with each mutant, in a model made with it. So are statements with ≈, which no single state decides.

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::evaluate;
use crate::formula::{Expr, Node, Relation, SymbolId, Value, text};
use crate::scalar::RunningError;

use crate::check::judge::mutants::mutants_of;
use crate::check::judge::other_branches;
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::sample::setting::FEWEST;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::state::sampled_state::SampledState;
use crate::check::vacuity::zero;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// An equation that uses a defined symbol, with the name that it is reported by.
pub struct User<'a> {
    /// The number or label of the equation.
    pub id: String,
    /// What it claims.
    pub link: Link,
    /// Its hypotheses.
    pub context: Context<'a>,
}

/// The statements with ≈, or the displays judged as a whole, that use a defined symbol.
pub trait Approximations {
    /// The names of those that hold.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    fn holding(&self) -> Result<Vec<String>>;

    /// Whether one of those that hold fails if the symbol is defined by `mutant`.
    fn detect(&self, mutant: &Expr) -> bool;
}

/// The finding on `symbol = formula`. `users` contain the symbol; equations in `by_law` may hold by a law that contains it,
/// and `others` are the statements with ≈ and the displays judged as a whole.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(
    symbol: SymbolId,
    formula: &Expr,
    (users, by_law, others): (&mut [User<'_>], &[User<'_>], &[&dyn Approximations]),
    context: &Context<'_>,
) -> Result<Finding> {
    let name = text::plain(&context.model.name(symbol));
    let is_unused = users.is_empty() && by_law.is_empty();
    if is_unused && others.iter().map(|other| other.holding()).collect::<Result<Vec<_>>>()?.iter().all(Vec::is_empty) {
        return Ok(context.finding(
            Code::DefinitionUnused,
            Verdict::Undecided,
            format!("defines {name}; no other equation uses {name}, so this definition was not tested"),
        ));
    }
    if zero::is_always_zero(formula, context)? {
        return Ok(context.finding(
            Code::DefinitionZero,
            Verdict::Undecided,
            format!("defines {name}, which is always 0 as printed; correct the definition"),
        ));
    }
    let itself = Expr::new(Node::Symbol { id: symbol, indices: Vec::new(), dots: 0 }, formula.span);
    let definition = Link { lhs: itself, relation: Relation::Equal, rhs: formula.clone(), free: Vec::new() };
    let mut surviving: Vec<(Expr, String)> = mutants_of(&definition, context.model)
        .into_iter()
        .filter(|mutant| mutant.link.rhs != *formula)
        .map(|mutant| (mutant.link.rhs, mutant.change))
        .collect();
    let mut names: Vec<String> = Vec::new();
    let mut points = 0;
    for user in users.iter_mut() {
        // All mutants are detected.
        if surviving.is_empty() && !names.is_empty() {
            break;
        }
        // The mode in which the equation holds is used: always, or else on shell.
        for on_shell in [false, true] {
            let mode = user.context.mode(on_shell, &[&user.link.lhs, &user.link.rhs, formula]);
            let mut ensemble = user.context.ensemble(mode, false, context.options.points)?;
            let holds = |states: &[SampledState<'_, RunningError>]| {
                run(&user.link, states).is_ok_and(|o| o.failure.is_none() && o.points > 0)
            };
            if !holds(&ensemble.states) {
                other_branches::on_its_branch(&user.link, context.model, &mut ensemble);
                if !holds(&ensemble.states) {
                    continue;
                }
            }
            points = points.max(ensemble.states.len());
            surviving.retain(|(mutant, _)| {
                !ensemble.states.iter_mut().any(|state| {
                    let Ok(value) = evaluate(mutant, state, &[]) else { return true };
                    state.replace(symbol, value);
                    let found = residual::test(&user.link, state);
                    state.set_only(&[]);
                    !matches!(found, Ok(Point::Holds(_) | Point::Doubtful | Point::Useless))
                })
            });
            if !names.contains(&user.id) {
                names.push(user.id.clone());
            }
            break;
        }
    }
    for user in by_law {
        if surviving.is_empty() || !holds_by_law(user, context.model)? {
            continue;
        }
        let before = surviving.len();
        surviving.retain(|(mutant, _)| !breaks_by_law(user, symbol, mutant));
        if surviving.len() < before && !names.contains(&user.id) {
            names.push(user.id.clone());
        }
    }
    // These take many states, so they are asked only about what nothing else detects.
    for other in others {
        if !surviving.is_empty() {
            names.extend(other.holding()?.into_iter().filter(|id| !names.contains(id)).collect::<Vec<_>>());
            surviving.retain(|(mutant, _)| !other.detect(mutant));
        }
    }
    // An equivalent mutant makes nothing fail, and one without a value, such as √(2 − √4) beside its rates, cannot be tried.
    let mode = context.mode(false, &[formula]);
    let states = context.ensemble(mode, true, context.options.points)?;
    surviving.retain(|(mutant, _)| {
        let link = Link { lhs: mutant.clone(), relation: Relation::Equal, rhs: formula.clone(), free: Vec::new() };
        !run(&link, &states.states).is_ok_and(|o| o.failure.is_none() && o.doubtful == 0)
    });
    // The sign of the whole is often a convention, such as that of a root that is only used squared.
    let whole = formula.clone().negated();
    let signed = surviving.len();
    surviving.retain(|(mutant, _)| {
        let link = Link { lhs: mutant.clone(), relation: Relation::Equal, rhs: whole.clone(), free: Vec::new() };
        *mutant != whole
            && !run(&link, &states.states).is_ok_and(|o| o.failure.is_none() && o.doubtful == 0 && o.points > 0)
    });
    let mut except: Vec<&str> = if surviving.len() < signed { vec!["its sign"] } else { Vec::new() };
    // So is the size of a normal coordinate: linear equations of motion are the same for its double, and for its rate.
    if !names.is_empty() && combines_what_varies(formula, context.model) {
        let sized = surviving.len();
        surviving.retain(|(mutant, _)| !is_a_multiple(mutant, formula, &states.states));
        except.extend((surviving.len() < sized).then_some("its factor"));
        let moved = surviving.len();
        surviving.retain(|(mutant, _)| *mutant != with_rates(formula, context.model));
        except.extend((surviving.len() < moved).then_some("a dot more on its coordinates"));
    }
    let (code, except) = match except.is_empty() {
        true => (Code::Definition, String::new()),
        false => (Code::DefinitionUpToSign, format!(" except for {}", except.join(" and "))),
    };
    match surviving.first() {
        _ if names.is_empty() => {
            let message = format!("defines {name}; no passing equation uses {name}, so this definition was not tested");
            Ok(context.finding(Code::DefinitionUsersFail, Verdict::Undecided, message))
        }
        Some((_, change)) => {
            let message = format!(
                "defines {name}, but no other equation would fail with {change}; use {name} once more, or put it under `define`"
            );
            Ok(context.finding(Code::DefinitionNotTested, Verdict::Undecided, message))
        }
        None => {
            let message = format!("defines {name}; each change{except} makes {} fail", names.join(" or "));
            Ok(Finding { points, tried: points, ..context.finding(code, Verdict::Definition, message) })
        }
    }
}

/// Whether a formula contains several coordinates, or a coordinate and the time, and else constants only: as a normal coordinate does,
/// or one in turning axes.
fn combines_what_varies(formula: &Expr, model: &Model) -> bool {
    let symbols = formula.symbols();
    let is_coordinate = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(_)));
    let is_time = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Time));
    let fits = |&(id, dots): &(SymbolId, u8)| match model.meaning(id) {
        Some(Meaning::Coordinate(_)) => dots == 0,
        Some(Meaning::Constant(_) | Meaning::Time) => true,
        _ => false,
    };
    let moving = symbols.iter().filter(|(id, _)| is_coordinate(*id) || is_time(*id)).count();
    moving > 1 && symbols.iter().any(|(id, _)| is_coordinate(*id)) && symbols.iter().all(fits)
}

/// A formula with a dot more on each coordinate in it.
fn with_rates(formula: &Expr, model: &Model) -> Expr {
    let mut moved = formula.clone();
    let of_rate = |node: &Node| match node {
        Node::Symbol { id, indices, dots } if matches!(model.meaning(*id), Some(Meaning::Coordinate(_))) => {
            let rate = Node::Symbol { id: *id, indices: indices.clone(), dots: dots + 1 };
            Some(Expr::new(rate, formula.span))
        }
        _ => None,
    };
    moved.substitute(&of_rate);
    moved
}

/// Whether the ratio of a mutant to the formula is the same number at all states; 0 is one, which solves linear equations too.
fn is_a_multiple(mutant: &Expr, formula: &Expr, states: &[SampledState<'_, RunningError>]) -> bool {
    let number = |expr: &Expr, state: &SampledState<'_, RunningError>| match state.now(expr, &[]) {
        Ok(Value::Scalar(value)) => Some(value),
        _ => None,
    };
    let ratio = |state| Some(number(mutant, state)? / number(formula, state)?);
    let ratios: Vec<RunningError> = states.iter().filter_map(ratio).filter(|ratio| ratio.value.is_finite()).collect();
    ratios.len() >= FEWEST && ratios[1..].iter().all(|ratio| residual::vanishes(*ratio - ratios[0]))
}

/// Whether an equation holds on shell.
fn holds_by_law(user: &User<'_>, model: &Model) -> Result<bool> {
    let mode = user.context.mode(true, &[&user.link.lhs, &user.link.rhs]);
    let states = user.context.ensemble_of(model, mode, FEWEST, "")?;
    Ok(run(&user.link, &states.states).is_ok_and(|o| o.failure.is_none() && o.points > 0))
}

/// Whether an equation fails on shell if a name in its laws is defined by a mutant.
fn breaks_by_law(user: &User<'_>, symbol: SymbolId, mutant: &Expr) -> bool {
    // A name cannot be defined by itself.
    if user.context.model.depends_on(mutant, &[symbol]) {
        return true;
    }
    let mut model = user.context.model.clone();
    model.define(symbol, mutant.clone());
    !holds_by_law(user, &model).is_ok_and(|holds| holds)
}
