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
use crate::phrases::listed;
use crate::scalar::RunningError;

use crate::check::judge::mutants::mutants_of;
use crate::check::judge::other_branches;
use crate::check::model::Model;
use crate::check::model::claim::{Law, Link};
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
        let message = format!(
            "defines {name}; no other equation uses {name}, so this definition was not tested; use {name} in an equation, or put it \
             under `define`"
        );
        return Ok(context.finding(Code::DefinitionUnused, Verdict::Undecided, message).defining(&name));
    }
    if zero::is_always_zero(formula, context)? {
        let message = format!("defines {name}, which is always 0 as printed; correct the definition");
        return Ok(context.finding(Code::DefinitionZero, Verdict::Undecided, message));
    }
    let mut tested = Tested::of(symbol, formula, context.model);
    tested.by_users(users, context)?;
    tested.by_laws(by_law, context.model)?;
    tested.by_others(others)?;
    let except = tested.leave_out_what_nothing_detects(context)?;
    let Tested { surviving, names, points, .. } = tested;
    let (code, except) = match except.is_empty() {
        true => (Code::Definition, String::new()),
        false => (Code::DefinitionUpToSign, format!(", except {}", listed(&except, "and"))),
    };
    match surviving.first() {
        _ if names.is_empty() => {
            let uses = |law: &&Law| {
                let sides = law.hypotheses.iter().flat_map(|known| [&known.lhs, &known.rhs]);
                sides.into_iter().any(|side| context.model.depends_on(side, &[symbol]))
            };
            let laws: Vec<Law> = context.model.laws.iter().filter(uses).cloned().collect();
            let message = match laws.is_empty() {
                true => format!("defines {name}; no passing equation uses {name}, so this definition was not tested"),
                false => format!(
                    "defines {name}; only {} uses {name}, and a law tests no definition; use {name} in an equation",
                    Law::phrases(&laws)
                ),
            };
            Ok(context.finding(Code::DefinitionUsersFail, Verdict::Undecided, message).defining(&name))
        }
        Some((_, change)) => {
            let message = format!(
                "defines {name}, but no other equation tests it: with {change} all of them still hold; use {name} once more, or put it under `define`"
            );
            Ok(context.finding(Code::DefinitionNotTested, Verdict::Undecided, message).defining(&name))
        }
        None => {
            // Without a claims file a formula that is no quantity of the Lagrangian is a definition too.
            let own = format!("{name} = ");
            let message = match names.iter().all(|other| other.starts_with(&own)) {
                true => {
                    let known: Vec<&str> =
                        names.iter().map(|other| other.strip_prefix(&own).unwrap_or(other)).collect();
                    format!("defines {name}, which is {}", known.join(" and "))
                }
                false => {
                    format!("defines {name}; any single mistake in it would contradict {}{except}", names.join(" or "))
                }
            };
            Ok(Finding { points, tried: points, ..context.finding(code, Verdict::Definition, message) })
        }
    }
}

/// A definition, and which of its mutants make another equation fail.
struct Tested<'f> {
    symbol: SymbolId,
    formula: &'f Expr,
    /// The mutants that nothing has detected, each with its change in words.
    surviving: Vec<(Expr, String)>,
    /// The names of the equations that hold, and so test the definition.
    names: Vec<String>,
    /// The largest number of states at which an equation was tried.
    points: usize,
}

impl<'f> Tested<'f> {
    fn of(symbol: SymbolId, formula: &'f Expr, model: &Model) -> Self {
        let itself = Expr::new(Node::Symbol { id: symbol, indices: Vec::new(), dots: 0 }, formula.span);
        let definition = Link { lhs: itself, relation: Relation::Equal, rhs: formula.clone(), free: Vec::new() };
        let mutants = mutants_of(&definition, model).into_iter().filter(|mutant| mutant.link.rhs != *formula);
        let surviving = mutants.map(|mutant| (mutant.link.rhs, mutant.change)).collect();
        Tested { symbol, formula, surviving, names: Vec::new(), points: 0 }
    }

    /// Removes the mutants with which an equation that contains the symbol fails.
    fn by_users(&mut self, users: &mut [User<'_>], context: &Context<'_>) -> Result<()> {
        for user in users.iter_mut() {
            // All mutants are detected.
            if self.surviving.is_empty() && !self.names.is_empty() {
                break;
            }
            // The mode in which the equation holds is used: always, or else on shell.
            for on_shell in [false, true] {
                let mode = user.context.mode(on_shell, &[&user.link.lhs, &user.link.rhs, self.formula]);
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
                self.points = self.points.max(ensemble.states.len());
                self.surviving.retain(|(mutant, _)| {
                    !ensemble.states.iter_mut().any(|state| {
                        let Ok(value) = evaluate(mutant, state, &[]) else { return true };
                        state.replace(self.symbol, value);
                        let found = residual::test(&user.link, state);
                        state.set_only(&[]);
                        !matches!(found, Ok(Point::Holds(_) | Point::Doubtful | Point::Useless))
                    })
                });
                if !self.names.contains(&user.id) {
                    self.names.push(user.id.clone());
                }
                break;
            }
        }
        Ok(())
    }

    /// Removes the mutants with which an equation that holds by a law fails.
    fn by_laws(&mut self, by_law: &[User<'_>], model: &Model) -> Result<()> {
        for user in by_law {
            if self.surviving.is_empty() || !holds_by_law(user, model)? {
                continue;
            }
            let before = self.surviving.len();
            self.surviving.retain(|(mutant, _)| !breaks_by_law(user, self.symbol, mutant));
            if self.surviving.len() < before && !self.names.contains(&user.id) {
                self.names.push(user.id.clone());
            }
        }
        Ok(())
    }

    /// Removes the mutants that statements with ≈, or displays judged as a whole, detect.
    fn by_others(&mut self, others: &[&dyn Approximations]) -> Result<()> {
        // These take many states, so they are asked only about what nothing else detects.
        for other in others {
            if !self.surviving.is_empty() {
                self.names
                    .extend(other.holding()?.into_iter().filter(|id| !self.names.contains(id)).collect::<Vec<_>>());
                self.surviving.retain(|(mutant, _)| !other.detect(mutant));
            }
        }
        Ok(())
    }

    /// Removes the mutants that no equation can be expected to detect: those as true as the definition, and those of a convention,
    /// such as a sign. Names the conventions.
    fn leave_out_what_nothing_detects(&mut self, context: &Context<'_>) -> Result<Vec<&'static str>> {
        let formula = self.formula;
        // An equivalent mutant makes nothing fail, and one without a value, such as √(2 − √4) beside its rates, cannot be tried.
        let mode = context.mode(false, &[formula]);
        let states = context.ensemble(mode, true, context.options.points)?;
        self.surviving.retain(|(mutant, _)| {
            let link = Link { lhs: mutant.clone(), relation: Relation::Equal, rhs: formula.clone(), free: Vec::new() };
            !run(&link, &states.states).is_ok_and(|o| o.failure.is_none() && o.doubtful == 0)
        });
        // The sign of the whole is often a convention, such as that of a root that is only used squared.
        let whole = formula.clone().negated();
        let signed = self.surviving.len();
        self.surviving.retain(|(mutant, _)| {
            let link = Link { lhs: mutant.clone(), relation: Relation::Equal, rhs: whole.clone(), free: Vec::new() };
            *mutant != whole
                && !run(&link, &states.states).is_ok_and(|o| o.failure.is_none() && o.doubtful == 0 && o.points > 0)
        });
        let mut except: Vec<&'static str> =
            if self.surviving.len() < signed { vec!["a wrong sign"] } else { Vec::new() };
        // So is the size of a normal coordinate: linear equations of motion are the same for its double, and for its rate.
        if !self.names.is_empty() && combines_what_varies(formula, context.model) {
            let sized = self.surviving.len();
            self.surviving.retain(|(mutant, _)| !is_a_multiple(mutant, formula, &states.states));
            except.extend((self.surviving.len() < sized).then_some("a wrong factor"));
            let moved = self.surviving.len();
            self.surviving.retain(|(mutant, _)| *mutant != with_rates(formula, context.model));
            except.extend((self.surviving.len() < moved).then_some("one dot more on its coordinates"));
        }
        Ok(except)
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
