//! Tests of a definition: the equations that use a name, and whether they fail if the name is defined otherwise.
//!
//! A definition cannot be false by itself; it is tested by the equations that use the name. Another formula makes another
//! model. The sampled states of these equations are made again in that model; a change is detected where one fails.

use std::sync::Arc;

use crate::Result;
use crate::formula::{Expr, SymbolId};
use crate::latex::DefinedSymbol;
use crate::scalar::RunningError;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::hypotheses::rule::Rule;
use crate::check::kinds::printed_solution::Solution;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::{Mode, Spread};
use crate::check::model::{Model, free_symbols};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::state::sampled_state::SampledState;

/// The number of sampled states for each equation.
const STATES: usize = 6;

/// An equation that uses a defined symbol, with its hypotheses.
pub(crate) struct Use {
    /// The number or label of the equation, or the name of the sentence.
    pub id: String,
    /// What it claims.
    pub link: Link,
    /// What it assumes.
    pub hypotheses: Vec<Hypothesis>,
    /// What symbols mean in it only.
    pub local: Vec<Rule>,
    /// Whether the claim is only that it holds; a limit of cells holds at no state.
    pub is_plain: bool,
    /// The solution of the motion that it prints, if it does.
    pub solution: Option<Solution>,
}

/// An equation with the states at which it holds.
struct DefinitionTest {
    /// The name of the equation.
    of: String,
    /// Whether it holds with the definition as printed.
    held: bool,
    link: Link,
    /// The formula that stands for a coordinate here: that of a printed solution, in an equation of motion.
    along: Option<(SymbolId, Expr)>,
    mode: Mode,
    bases: Vec<Vec<f64>>,
    rules: Arc<[Rule]>,
}

/// What another formula for a name does to an equation that uses the name.
pub(crate) struct Outcome<'d> {
    /// The name of the equation.
    pub of: &'d str,
    /// Whether it holds with the definition as printed.
    pub held: bool,
    /// Whether it holds with the other formula.
    pub holds: bool,
}

/// The equations that test a definition.
pub(crate) struct DefinitionTests<'d, 'a> {
    checker: &'d Checker<'a>,
    symbol: SymbolId,
    tests: Vec<DefinitionTest>,
}

impl<'d, 'a> DefinitionTests<'d, 'a> {
    /// The tests of a name that a display introduces: the equations that hold; with `failing`, those that fail as well, since
    /// the definition may be the cause. Equations with a hypothesis about the name are left out: with another definition
    /// other states satisfy the hypothesis.
    ///
    /// # Errors
    /// When the system's mass matrix is singular, or for a claim that does not fit the notes.
    pub fn of(checker: &'d Checker<'a>, introduced: &DefinedSymbol, failing: bool) -> Result<Self> {
        let symbol = introduced.symbol;
        let (uses, _) = checker.uses(introduced)?;
        let assumed = |hypotheses: &[Hypothesis]| {
            hypotheses
                .iter()
                .any(|c| [&c.lhs, &c.rhs].into_iter().any(|side| checker.model.depends_on(side, &[symbol])))
        };
        let by_law = checker.model.laws.iter().any(|law| assumed(&law.hypotheses));
        let mut tests = Vec::new();
        for Use { id, link, hypotheses, local, is_plain, solution } in uses {
            if assumed(&hypotheses) || !local.is_empty() {
                continue;
            }
            if let Some(solution) = &solution {
                tests.extend(laws_along(checker, solution, failing)?);
                continue;
            }
            let context = Context {
                model: checker.model,
                options: checker.options,
                hypotheses: &hypotheses,
                on_shell: None,
                topic: &id,
                span: Span::default(),
                spread: Spread::Declared,
                local: &local,
            };
            let mut fails = None;
            let mut holds = false;
            for on_shell in [false, true] {
                if on_shell && (by_law || !checker.model.has_motion()) {
                    continue;
                }
                let mut mode = context.mode(on_shell, &[&link.lhs, &link.rhs, &introduced.formula]);
                mode.order = (mode.order + 1).min(crate::scalar::TERMS - 1);
                let ensemble = context.ensemble(mode, false, STATES)?;
                let found = run(&link, &ensemble.states).is_ok_and(|o| o.failure.is_none() && o.points > 0);
                let (bases, rules) = (ensemble.bases, ensemble.rules.clone());
                let (of, held) = (id.clone(), found);
                let test = DefinitionTest { of, held, link: link.clone(), along: None, mode, bases, rules };
                if found {
                    tests.push(test);
                    holds = true;
                    break;
                }
                fails = Some(test);
            }
            tests.extend(fails.filter(|_| failing && is_plain && !holds));
        }
        Ok(DefinitionTests { checker, symbol, tests })
    }

    /// Whether an equation fails where the name stands for another formula.
    pub fn detects(&self, formula: &Expr) -> bool {
        self.redefined(formula).is_none_or(|model| self.tests.iter().any(|test| test.fails(&model)))
    }

    /// What becomes of each equation where the name stands for another formula; `None`, if the formula contains the name.
    pub fn outcomes(&self, formula: &Expr) -> Option<impl Iterator<Item = Outcome<'_>>> {
        let model = self.redefined(formula)?;
        Some(self.tests.iter().map(move |test| {
            let holds = !test.fails(&model) && test.has_a_value(&model);
            Outcome { of: &test.of, held: test.held, holds }
        }))
    }

    /// The model in which the name stands for another formula. A name cannot be defined by itself.
    fn redefined(&self, formula: &Expr) -> Option<Model> {
        let mut model = self.checker.model.clone();
        let is_possible = !model.depends_on(formula, &[self.symbol]);
        is_possible.then(|| model.define(self.symbol, formula.clone()));
        is_possible.then_some(model)
    }
}

impl DefinitionTest {
    /// Whether the equation holds at one of its states with the definitions of a model. A formula without a value fails at none.
    fn has_a_value(&self, model: &Model) -> bool {
        self.along.is_some()
            || self.bases.iter().any(|base| {
                let base: Vec<RunningError> = base.iter().map(|value| RunningError::from(*value)).collect();
                let state = SampledState::new(model, self.mode, &base, &self.rules).ok();
                state
                    .and_then(|state| residual::test(&self.link, &state).ok())
                    .is_some_and(|p| matches!(p, Point::Holds(_)))
            })
    }

    /// Whether the equation fails at one of its states with the definitions of a model.
    fn fails(&self, model: &Model) -> bool {
        // A solution that contains its own coordinate is none.
        if self.along.as_ref().is_some_and(|(coordinate, formula)| model.depends_on(formula, &[*coordinate])) {
            return true;
        }
        let along = self.along.as_ref().map(|(coordinate, formula)| {
            let mut model = model.clone();
            model.redefine(*coordinate, formula.clone());
            model
        });
        let model = along.as_ref().unwrap_or(model);
        let point = |base: &Vec<f64>| {
            let base: Vec<RunningError> = base.iter().map(|value| RunningError::from(*value)).collect();
            let state = SampledState::new(model, self.mode, &base, &self.rules).ok()?;
            residual::test(&self.link, &state).ok()
        };
        let mut points = self.bases.iter().map(point);
        match self.along {
            None => points.any(|point| matches!(point, Some(Point::Fails(_) | Point::OneSided(_)))),
            // Where the formula of a solution has no value, it prints none; but it must have one somewhere.
            Some(_) => {
                let mut holds = false;
                let fails = points.any(|point| {
                    holds |= matches!(point, Some(Point::Holds(_)));
                    matches!(point, Some(Point::Fails(_)))
                });
                fails || !holds
            }
        }
    }
}

/// The laws into which a printed solution can be put: those in which nothing else moves. With the formula in the place of
/// the coordinate such a law is an identity in the time and the constants. With `failing`, also those that are none.
fn laws_along(checker: &Checker<'_>, solution: &Solution, failing: bool) -> Result<Vec<DefinitionTest>> {
    let model = checker.model;
    if model.system.is_some() || solution.dots > 0 {
        return Ok(Vec::new());
    }
    let mut tests = Vec::new();
    for law in model.laws.iter().flat_map(|law| &law.hypotheses).filter(|law| is_equality(law.relation)) {
        let drawn = free_symbols::drawn(&[&law.lhs, &law.rhs], model);
        let moves = |id: &SymbolId| !matches!(model.meaning(*id), Some(Meaning::Constant(_)));
        if !drawn.into_iter().filter(moves).eq([solution.coordinate]) {
            continue;
        }
        let link = Link { lhs: law.lhs.clone(), relation: law.relation, rhs: law.rhs.clone(), free: law.free.clone() };
        let context = Context {
            model,
            options: checker.options,
            hypotheses: &[],
            on_shell: Some(false),
            topic: "a law along a solution",
            span: Span::default(),
            spread: Spread::Declared,
            local: &[],
        };
        let mut mode = context.mode(false, &[&link.lhs, &link.rhs, &solution.formula]);
        mode.order = (mode.order + 1).min(crate::scalar::TERMS - 1);
        let bases = context.ensemble(mode, false, STATES)?.bases;
        let along = Some((solution.coordinate, solution.formula.clone()));
        let of = "a law".to_owned();
        let mut test = DefinitionTest { of, held: false, link, along, mode, bases, rules: Arc::from([]) };
        test.held = !test.fails(model);
        if failing || test.held {
            tests.push(test);
        }
    }
    Ok(tests)
}
