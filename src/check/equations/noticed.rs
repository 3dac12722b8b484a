//! The equations that would fail if a definition were another one.
//!
//! Another formula in the place of a definition makes another model. The states of the equations that use the name
//! are made again in that model; if one of them fails, the change is noticed.
//!
//! A slip in a definition cannot be wrong by itself. The model is made with the other formula, and what uses the
//! name is tested. What is not noticed there is put into the file and the whole document is checked; only what
//! passes that has survived.

use std::sync::Arc;

use crate::Result;
use crate::formula::{Expr, SymbolId};
use crate::latex::DefinedSymbol;
use crate::scalar::RunningError;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::hypotheses::rule::Rule;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::sampling::{Mode, Spread};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::state::sampled_state::SampledState;

/// Each equation is tested at so many states.
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
    /// Whether no more is claimed of it than that it holds: a limit of cells does not, at any state.
    pub is_plain: bool,
}

/// An equation with the states at which it holds.
struct Pin {
    link: Link,
    mode: Mode,
    bases: Vec<Vec<f64>>,
    rules: Arc<[Rule]>,
}

/// What holds a definition fast.
pub(crate) struct Pins<'d, 'a> {
    checker: &'d Checker<'a>,
    symbol: SymbolId,
    pins: Vec<Pin>,
}

impl<'d, 'a> Pins<'d, 'a> {
    /// Of a name that a display introduces: the equations that hold, and those that fail as well where it is the definition
    /// that may be wrong. What is assumed of the name itself is no help, since other states would obey it if the name meant
    /// something else.
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
        let mut pins = Vec::new();
        for Use { id, link, hypotheses, local, is_plain } in uses {
            if assumed(&hypotheses) || !local.is_empty() {
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
                let pin = Pin { link: link.clone(), mode, bases, rules };
                if found {
                    pins.push(pin);
                    holds = true;
                    break;
                }
                fails = Some(pin);
            }
            pins.extend(fails.filter(|_| failing && is_plain && !holds));
        }
        Ok(Pins { checker, symbol, pins })
    }

    /// Whether an equation fails where the name stands for another formula.
    pub fn notice(&self, formula: &Expr) -> bool {
        // What is defined by itself is not defined.
        if self.checker.model.depends_on(formula, &[self.symbol]) {
            return true;
        }
        let mut model = self.checker.model.clone();
        model.define(self.symbol, formula.clone());
        self.pins.iter().any(|pin| {
            pin.bases.iter().any(|base| {
                let base: Vec<RunningError> = base.iter().map(|value| RunningError::from(*value)).collect();
                let state = SampledState::new(&model, pin.mode, &base, &pin.rules);
                state.is_ok_and(|state| {
                    matches!(residual::test(&pin.link, &state), Ok(Point::Fails(_) | Point::OneSided(_)))
                })
            })
        })
    }
}
