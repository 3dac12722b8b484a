//! What a display that cannot be read leaves open in other places.
//!
//! A misprint in a display that introduces a name, or prints a law, makes the name or the law unknown wherever it is
//! used: in the claims file, too, which is not wrong for that. So an error for want of a name is laid at the door of an
//! unreadable display that has the letters of the name in it; if all its fault is that it lacks other names, to one that
//! has the name for a side. And what needed the name is unreadable, while the rest is judged.

use crate::Error;
use crate::latex::{Reading, names};
use crate::notes::Notes;
use crate::notes::claims::{Sentence, Test};
use crate::source::{Fault, Missing, Span};

use super::desk::Desk;
use super::document::{shown, unjudged};
use super::model::Model;
use super::reading::faults;
use super::sentences;
use super::verdict::{Equation, Finding, Part, Verdict};

/// The displays of a document that cannot be read, each with the faults of its statements.
pub(super) struct Damage<'a> {
    notes: &'a Notes,
    faults: Vec<(usize, Vec<&'a Fault>)>,
}

impl<'a> Damage<'a> {
    /// The damage of a document whose displays read like this, each with its place.
    pub fn of(notes: &'a Notes, readings: impl Iterator<Item = (usize, &'a Reading)>) -> Damage<'a> {
        let faults = readings.map(|(at, reading)| (at, faults(reading).collect::<Vec<_>>()));
        Damage { notes, faults: faults.filter(|(_, faults)| !faults.is_empty()).collect() }
    }

    /// Which unreadable display leaves this open, in words; none, if no display could be to blame.
    pub fn cause(&self, missing: Option<&Missing>, model: &Model) -> Option<String> {
        let name = match missing? {
            Missing::Equation(id) => return Some(format!("({id}) cannot be read")),
            Missing::Name(name) => name,
        };
        if let Some((_, cause)) = model.lost.iter().find(|(lost, _)| names::same(lost, name)) {
            return Some(cause.clone());
        }
        let lacks = |fault: &&Fault| matches!(&fault.missing, Some(Missing::Name(own)) if names::same(own, name));
        // What lacks only other names is misprinted in them: it has this one whole, if it introduces it.
        let is_own = |fault: &&Fault| !matches!(&fault.missing, Some(Missing::Name(_)));
        let (display, _) = self.faults.iter().find(|(at, faults)| {
            let text = &self.notes.equations[*at].text;
            let has_it = if faults.iter().any(is_own) { names::mentions } else { names::is_a_side };
            !faults.iter().any(lacks) && has_it(text, name, &model.macros)
        })?;
        Some(format!("({}), where it stands, cannot be read", shown(&self.notes.equations[*display])))
    }
}

impl Desk<'_> {
    /// Which unreadable display leaves this open, in words.
    pub fn cause(&self, missing: Option<&Missing>) -> Option<String> {
        missing?;
        let damage = Damage::of(self.notes, self.readings.iter().enumerate());
        damage.cause(missing, self.model)
    }

    /// The finding on a display whose claim needs what an unreadable display leaves open; else the error.
    pub fn excused(&self, at: usize, error: Error) -> Result<Equation, Error> {
        let display = &self.notes.equations[at];
        let finding = self.unjudgeable(error, display.body)?;
        Ok(unjudged(self.notes, &shown(display), display.line, finding))
    }

    /// The same for a sentence.
    pub fn excused_sentence(&self, at: usize, sentence: &Sentence, error: Error) -> Result<Equation, Error> {
        let quoted = self.notes.find_quote(&sentence.quote.value).first().copied().unwrap_or_default();
        let finding = self.unjudgeable(error, quoted)?;
        let line = self.notes.source.line_column(quoted.start).0;
        Ok(unjudged(self.notes, &sentences::name(at, sentence), line, finding))
    }

    fn unjudgeable(&self, error: Error, span: Span) -> Result<Finding, Error> {
        match self.cause(error.missing()) {
            Some(cause) => {
                let message = format!("it cannot be judged: {}; {cause}", error.message());
                Ok(Finding::new(Verdict::Unreadable, span, message))
            }
            // What is wrong at every state is wrong with this claim alone.
            None if error.place().is_none() => {
                Ok(Finding::new(Verdict::Undecided, span, format!("it cannot be judged: {}", error.message())))
            }
            None => Err(error),
        }
    }

    /// What is found without a law that is lost. A pass stays one, since a law only adds to what holds, but for a
    /// sentence that asks for a counterexample.
    pub fn without_lost_laws(&self, mut equation: Equation, sentence: Option<&Sentence>) -> Equation {
        let Some((law, cause)) = self.model.lost_laws.first() else { return equation };
        let wants_failure = sentence.is_some_and(|sentence| matches!(sentence.test, Test::NotAlways(_)));
        let withdraw = |finding: &mut Finding, ok: &mut bool| {
            let fails = matches!(finding.verdict, Verdict::Refuted | Verdict::Domain | Verdict::Undecided);
            if fails || wants_failure {
                let message = format!("it cannot be judged without {law}: {cause}");
                *finding = Finding::new(Verdict::Unreadable, finding.span, message);
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
