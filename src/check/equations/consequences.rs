//! Findings on equations and sentences that need a display that cannot be read.

use crate::Error;
use crate::code::Code;
use crate::formula::{Expr, Node, text};
use crate::latex::name_search;
use crate::notes::claims::{Sentence, Test};
use crate::source::{Missing, Span};

use crate::check::document::checker::Checker;
use crate::check::document::names::{shown, unjudged};
use crate::check::document::unreadable::UnreadableDisplays;
use crate::check::equations::sentences;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::{Equation, Part};

impl Checker<'_> {
    /// The clause of a message that names the unreadable display which makes this unknown.
    pub fn cause(&self, missing: Option<&Missing>) -> Option<String> {
        missing?;
        let unreadable = UnreadableDisplays::of(self.notes, self.readings.iter().enumerate());
        unreadable.cause(missing, self.model)
    }

    /// What to do where the only display with a formula for a name has no number, so that it is not read.
    pub fn without_a_number(&self, missing: Option<&Missing>) -> Option<String> {
        let Some(Missing::Name(name)) = missing else { return None };
        let displays = self.notes.equations.iter().zip(self.assigned);
        let mut unread = displays.filter(|(display, claim)| display.id().is_none() && claim.is_none());
        let (display, _) =
            unread.find(|(display, _)| name_search::is_a_side(&display.text, name, &self.model.macros))?;
        Some(format!(
            "line {} has a formula for it, but no number, so this line was not read; number it with \\tag",
            display.line
        ))
    }

    /// The finding on a display whose claim needs an unreadable display.
    ///
    /// # Errors
    /// The error itself, if no unreadable display is its cause.
    pub fn equation_left_open(&self, at: usize, error: Error) -> Result<Equation, Error> {
        let display = &self.notes.equations[at];
        let finding = self.left_open(error, display.body)?;
        Ok(unjudged(self.notes, &shown(display), display.line, finding))
    }

    /// The same finding on a sentence.
    ///
    /// # Errors
    /// The error itself, if no unreadable display is its cause.
    pub fn sentence_left_open(&self, at: usize, sentence: &Sentence, error: Error) -> Result<Equation, Error> {
        let quoted = self.notes.find_quote(&sentence.quote.value).first().copied().unwrap_or_default();
        let finding = self.left_open(error, quoted)?;
        let line = self.notes.source.line_column(quoted.start).0;
        Ok(unjudged(self.notes, &sentences::name(at, sentence), line, finding))
    }

    fn left_open(&self, error: Error, span: Span) -> Result<Finding, Error> {
        match self.cause(error.missing()) {
            Some(cause) => {
                let message = format!("this cannot be checked: {}; {cause}", error.message());
                Ok(Finding::new(Code::DependsOnUnreadable, Verdict::Unreadable, span, message))
            }
            // An error without a place concerns the states of this claim only.
            None if error.place().is_none() => {
                let why = self.idle_coordinate().unwrap_or_else(|| error.message().to_owned());
                let message = format!("this cannot be checked: {why}");
                Ok(Finding::new(Code::NotDecided, Verdict::Undecided, span, message))
            }
            None => Err(error),
        }
    }

    /// That a declared coordinate does not occur in the Lagrangian of the notes, which then gives it no acceleration.
    fn idle_coordinate(&self) -> Option<String> {
        let printed = self.model.printed_lagrangian.as_ref()?;
        let (symbol, _) = self.model.symbols.find(&printed.lagrangian)?;
        let lagrangian = Expr::new(Node::Symbol { id: symbol, indices: Vec::new(), dots: 0 }, Span::default());
        let idle = self.model.coordinates.iter().enumerate().find(|(at, coordinate)| {
            let is_constrained = printed.constraints.iter().any(|(multiplier, _)| multiplier == at);
            !is_constrained && !self.model.depends_on(&lagrangian, &[coordinate.symbol])
        })?;
        let (name, of) = (text::plain(&self.model.name(idle.1.symbol)), text::plain(&printed.lagrangian.to_string()));
        Some(format!(
            "the coordinate {name} does not occur in {of}, so nothing determines its motion; remove it from \"coordinates\""
        ))
    }

    /// The equation, with failures withdrawn where a law cannot be read. A pass stays a pass, since a law can only make more
    /// equations hold, except for a sentence that asks for a counterexample.
    pub fn without_unreadable_laws(&self, mut equation: Equation, sentence: Option<&Sentence>) -> Equation {
        let Some((law, cause)) = self.model.unread_laws.first() else { return equation };
        let wants_failure = sentence.is_some_and(|sentence| matches!(sentence.test, Test::NotAlways(_)));
        let withdraw = |finding: &mut Finding, ok: &mut bool| {
            let fails = matches!(finding.verdict, Verdict::Refuted | Verdict::Domain | Verdict::Undecided);
            if fails || wants_failure {
                let message = format!("this cannot be checked without {law}: {cause}");
                *finding = Finding::new(Code::DependsOnUnreadable, Verdict::Unreadable, finding.span, message);
                *ok = false;
            }
        };
        withdraw(&mut equation.finding, &mut equation.ok);
        for Part { finding, ok, .. } in &mut equation.parts {
            withdraw(finding, ok);
        }
        equation
    }
}
