//! The context of one claim: its model, its hypotheses, and the name that seeds its states.

use crate::Result;
use crate::code::Code;
use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, text};
use crate::scalar::{RunningError, TERMS};
use crate::source::Span;

use crate::check::hypotheses::rule::Rule;
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::independent_values;
use crate::check::model::order::derivatives;
use crate::check::model::sampling::{Mode, Spread};
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::sampler::Sampler;
use crate::check::sample::setting::Setting;
use crate::check::sample::unmet_hypotheses;
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The most work for the states of a deduction. Most sets of premises that are tried are of no use.
const DEDUCTION: usize = 40_000;

/// The reason why a claim that is no equality is not certified.
pub(crate) const NO_EQUALITY: &str = "this kind of claim, because only an equality of two formulas can have a \
                                      certificate";

/// The options of a check.
///
/// Start from [`Options::default`] and change what you need: fields may be added.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Options {
    /// The seed of all sampled states; 1 by default.
    pub seed: u64,
    /// The number of usable sampled states that are asked for; 24 by default.
    pub points: usize,
    /// Whether refuted claims are explained: their difference, what may have been meant, and suggestions. True by
    /// default.
    pub explain: bool,
    /// Whether a claim that follows from its hypotheses alone passes: it was meant as a deduction. Then
    /// it need hold only where both sides are defined, since nobody declared ranges. False by default.
    pub(crate) deduction: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options { seed: 1, points: 24, explain: true, deduction: false }
    }
}

/// The context of one claim: what it assumes, and the name that seeds its states.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The model of the document.
    pub model: &'a Model,
    /// Seed and number of states.
    pub options: Options,
    /// The hypotheses.
    pub hypotheses: &'a [Hypothesis],
    /// Whether the claim must hold always (`false`) or on shell (`true`); `None` tries both.
    pub on_shell: Option<bool>,
    /// The name of the claim.
    pub topic: &'a str,
    /// The bytes of the notes that the claim is about.
    pub span: Span,
    /// How wide the ranges are from which its states are drawn.
    pub spread: Spread,
    /// The rules of symbols that are defined in this claim only.
    pub local: &'a [Rule],
}

impl<'a> Context<'a> {
    /// The same without the search for an explanation: for what is asked on the way to a finding.
    pub fn quick(&self) -> Context<'a> {
        Context { options: Options { explain: false, ..self.options }, ..*self }
    }

    /// The mode on shell or off shell, with enough derivatives for these formulas and one more dot.
    pub fn mode(&self, on_shell: bool, formulas: &[&Expr]) -> Mode {
        let of_hypotheses = self.hypotheses.iter().flat_map(|c| [&c.lhs, &c.rhs]);
        let of_laws = self.model.laws.iter().flat_map(|law| &law.hypotheses).flat_map(|c| [&c.lhs, &c.rhs]);
        let of_constraints = self.model.constraints.iter().flat_map(|c| [&c.lhs, &c.rhs]);
        let of_laws = of_laws.chain(of_constraints).filter(|_| on_shell);
        let of_rules = self.local.iter().flat_map(|rule| rule.action.formulas());
        // The value that a hypothesis or a law gives a symbol has derivatives of its own, and is then differentiated as
        // often as the formula asks.
        let beneath = of_hypotheses.chain(of_laws).chain(of_rules).map(|f| derivatives(f, self.model)).max();
        let needed = formulas.iter().map(|f| derivatives(f, self.model)).max();
        let stacked = on_shell && !self.model.laws.is_empty() || !self.local.is_empty();
        let needed = if stacked { needed.map(|n| n + beneath.unwrap_or(0)) } else { needed.max(beneath) };
        let usual = if self.model.system.is_some() { 2 } else { 1 };
        let least = if self.hypotheses.iter().any(|c| c.throughout) { 4 } else { usual };
        Mode { on_shell, order: (needed.unwrap_or(0) + 1).max(least).min(TERMS - 1) }
    }

    /// The setting of its states.
    pub(crate) fn setting(&self, mode: Mode) -> Setting<'a> {
        Setting {
            hypotheses: self.hypotheses,
            local: self.local,
            mode,
            spread: self.spread,
            effort: if self.options.deduction { DEDUCTION } else { usize::MAX },
        }
    }

    /// States of the claim.
    ///
    /// # Errors
    /// If the mass matrix is singular at all of them.
    pub fn ensemble(&self, mode: Mode, relaxed: bool, points: usize) -> Result<Ensemble<'a>> {
        let spread = if relaxed { Spread::BeyondRanges } else { self.spread };
        Context { spread, ..*self }.ensemble_of(self.model, mode, points, if relaxed { "beyond" } else { "" })
    }

    /// States of the claim in another model, from a random stream of their own.
    ///
    /// # Errors
    /// If the mass matrix is singular at all of them.
    pub(crate) fn ensemble_of<'m>(
        &self,
        model: &'m Model,
        mode: Mode,
        points: usize,
        what: &str,
    ) -> Result<Ensemble<'m>> {
        Ensemble::named(model, &self.setting(mode), points, self.options.seed, &self.stream(mode, what))
    }

    /// States of the claim at special places.
    ///
    /// # Errors
    /// If the mass matrix is singular at all of them.
    pub fn special(&self, mode: Mode) -> Result<Ensemble<'a>> {
        Ensemble::special(self.model, &self.setting(mode), self.options.seed, &self.stream(mode, "special"))
    }

    /// The random stream of its states.
    pub(crate) fn draw(&self, mode: Mode, what: &str) -> Sampler {
        Sampler::new(self.options.seed, &self.stream(mode, what))
    }

    /// The name of the random stream.
    fn stream(&self, mode: Mode, what: &str) -> String {
        format!("{}/{}/{what}", self.topic, mode.on_shell)
    }

    /// Whether the claim holds under hypotheses of its own, or gives symbols a meaning of its own.
    pub(crate) fn has_hypotheses(&self) -> bool {
        !self.hypotheses.is_empty() || !self.local.is_empty()
    }

    /// A finding about this claim.
    pub fn finding(&self, code: Code, verdict: Verdict, message: impl Into<String>) -> Finding {
        Finding::new(code, verdict, self.span, message)
    }

    /// The finding that this claim holds by numbers only; `about` is the reason why it is not certified, a noun phrase.
    pub fn verified(&self, message: impl Into<String>, about: &str) -> Finding {
        Finding {
            not_certified_because: Some(about.to_owned()),
            ..self.finding(Code::Holds, Verdict::Verified, message)
        }
    }

    /// A finding about these formulas; one that passes is withheld where they contain more values of a function without a formula
    /// than can be chosen freely.
    #[must_use]
    pub(crate) fn for_every_function(&self, finding: Finding, formulas: &[&Expr]) -> Finding {
        if !finding.verdict.passes() || finding.verdict == Verdict::Definition {
            return finding;
        }
        let premises = self.hypotheses.iter().flat_map(|hypothesis| [&hypothesis.lhs, &hypothesis.rhs]);
        let rules = self.local.iter().flat_map(|rule| rule.action.formulas());
        let premises: Vec<&Expr> = premises.chain(rules).collect();
        let motion = self.on_shell != Some(false) && self.model.has_motion();
        match independent_values::too_many(self.model, formulas, &premises, motion) {
            Some(message) => finding.replaced(Code::NotDecided, Verdict::Undecided, message),
            None => finding,
        }
    }

    /// The finding that no state was found that obeys the hypotheses. That is no proof that there is none.
    pub fn no_state(&self, ensemble: &Ensemble<'_>) -> Finding {
        let message = format!("no state was found that obeys {}", unmet_hypotheses::explanation(&ensemble.projection));
        Finding { tried: ensemble.tried, ..self.finding(Code::NoState, Verdict::Undecided, message) }
    }

    /// The finding that a formula has no value at a state, with the smallest part of it that has none.
    pub fn unavailable_at(
        &self,
        formulas: &[&Expr],
        state: Option<&SampledState<'_, RunningError>>,
        reason: &Unavailable,
    ) -> Finding {
        let found = self.unavailable(reason);
        let (Some(state), Unavailable::Operation(what), true) = (state, reason, self.options.explain) else {
            return found;
        };
        let mut smallest: Option<&Expr> = None;
        for formula in formulas {
            formula.walk(&mut |part| {
                if state.now(part, &[]).is_err_and(|of_part| of_part == *reason) {
                    smallest = Some(part);
                }
            });
        }
        let is_inside = |part: &&Expr| {
            self.span.start <= part.span.start && part.span.end <= self.span.end && part.span.start < part.span.end
        };
        let Some(part) = smallest.filter(is_inside) else { return found };
        let shown = text::formula(part, &self.model.symbols);
        let message = format!(
            "“{shown}” contains {what}, which cannot be evaluated; write it without this, or leave the equation out \
             with \"skip\" in a claims file"
        );
        Finding { span: part.span, message, ..found }
    }

    /// The finding that a formula has no value.
    pub fn unavailable(&self, reason: &Unavailable) -> Finding {
        let (code, message) = match reason {
            Unavailable::Symbol(id) => {
                let name = text::plain(&self.model.name(*id));
                (
                    Code::NoValue,
                    format!("{name} has no value here; declare it, define it, or say under \"means\" what it is"),
                )
            }
            Unavailable::Derivative(_) => {
                let most = TERMS - 1;
                (
                    Code::NotSupported,
                    format!("this needs time derivatives of order above {most}, which is not supported"),
                )
            }
            Unavailable::Operation(what) => (
                Code::NotSupported,
                format!(
                    "the formula uses {what}, which cannot be evaluated; write it without this, or leave the equation \
                     out with \"skip\" in a claims file"
                ),
            ),
        };
        self.finding(code, Verdict::Unreadable, message)
    }
}
