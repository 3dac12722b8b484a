//! The derivation of a system as a lecture: notes with claims that onshell writes and then checks itself.
//!
//! A lecture goes from the parts of a system to its equations of motion. Each line is derived by [`crate::derive`] and
//! typeset; then the notes are checked as any other notes are, with the places or the Lagrangian as the only things that
//! are taken for granted. So each line is certified against the lines before it, and the certificate has its bound.
//!
//! | file | purpose |
//! | --- | --- |
//! | `passage` | headings, sentences and lines |
//! | `writer` | notes and their claims, written side by side |
//! | `start` | from the parts of the system to L |
//! | `motion` | from L to the equations of motion, the energy and H |
//! | `precession` | the effective potential, and steady precession |
//! | `beside` | printed equations beside the derived ones: term by term, and as curves |
//! | `sample` | the sampled state and the value of a line in it |
//! | `json` | the lecture for programs |
//! | `text` | the lecture on a terminal |
//!
//! This folder may know `check`, `derive`, `notes`, and what these know.
//!
//! Offers [`Lecture`] and [`Beside`], a printed equation beside the derived one.

mod beside;
pub mod json;
mod motion;
mod passage;
mod precession;
mod sample;
mod start;
pub mod text;
mod writer;

use std::path::Path;
use std::sync::Arc;

use crate::check::{Document, Equation, Options, check_document};
use crate::derive::Derivation;
use crate::mechanics::System;
use crate::notes::{Claims, Kind, Notes};
use crate::source::Source;
use crate::systems::Registry;
use crate::{Error, Result};

pub use beside::{Beside, Sides};
use passage::NOTES;
pub use passage::{Line, Passage};
pub use sample::Sample;
use writer::Writer;

/// A checked lecture.
#[derive(Clone, Debug)]
pub struct Lecture {
    /// The name of the system.
    pub name: String,
    /// The passages in order.
    pub passages: Vec<Passage>,
    /// The notes, as Markdown.
    pub notes: String,
    /// The claims file of the notes.
    pub claims: String,
    /// The state at which the lines have their values.
    pub sample: Sample,
    /// The verdict on each line.
    pub document: Document,
}

impl Lecture {
    /// Writes the lecture on a system, and checks it. `derivation` is that of the system.
    ///
    /// # Errors
    /// When an equation cannot be typeset, or the system has names that notes cannot have.
    pub fn new(system: &System, derivation: &Derivation, seed: u64) -> Result<Lecture> {
        if let Some(&multiplier) = system.multipliers().first() {
            let name = crate::formula::text::plain(&system.coordinates()[multiplier]);
            let message = format!("{name} is a Lagrange multiplier, which a derivation in steps does not support");
            return Err(Error::new(message).help("leave out --steps, or write the Lagrangian without the constraint"));
        }
        let sample = Sample::draw(system, seed)?;
        let mut writer = Writer::new(system, derivation, &sample)?;
        start::write(&mut writer)?;
        motion::write(&mut writer)?;
        precession::write(&mut writer)?;
        let (passages, notes, claims) = writer.finished();
        let document = checked(&notes, &claims, seed)?;
        Ok(Lecture { name: system.name().to_owned(), passages, notes, claims, sample, document })
    }

    /// The lines in order.
    pub fn lines(&self) -> impl Iterator<Item = &Line> {
        self.passages.iter().filter_map(|passage| match passage {
            Passage::Line(line) => Some(line),
            _ => None,
        })
    }

    /// The equation of a line, with its verdict.
    pub fn equation(&self, line: &Line) -> Option<&Equation> {
        self.document.equations.iter().find(|equation| equation.id == line.number)
    }

    /// The exit code: 0 if every line is as expected.
    pub fn exit_code(&self) -> u8 {
        u8::from(self.document.equations.iter().any(|equation| !equation.ok))
    }
}

fn checked(notes: &str, claims: &str, seed: u64) -> Result<Document> {
    let claims = Claims::parse(Arc::new(Source::new("lecture.json", claims)), Path::new("lecture.json"))?;
    let notes = Notes::parse(Arc::new(Source::new(NOTES, notes)), Kind::Markdown)?;
    let options = Options { seed, points: 24, explain: false, ..Options::default() };
    check_document(&claims, &notes, &Registry::empty(), options, None)
        .map_err(|error| Error::new(format!("the derivation in steps cannot be checked: {}", error.message())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::Verdict;
    use crate::mechanics::AnyLagrangian;

    fn lecture(lagrangian: &dyn AnyLagrangian, seed: u64) -> Lecture {
        Lecture::new(&lagrangian.trace().unwrap(), &Derivation::of(lagrangian).unwrap(), seed).unwrap()
    }

    #[test]
    fn every_line_of_every_system_is_certified_or_taken_for_granted() {
        let registry = Registry::standard();
        for name in registry.names() {
            let lecture = lecture(registry.get(name).unwrap(), 1);
            assert_eq!(lecture.exit_code(), 0, "{name}");
            for equation in &lecture.document.equations {
                let finding = &equation.finding;
                // an approximation is tried in its limit, which no field has
                let is_limit = finding.not_certified_because.as_deref() == Some("a limit");
                let is_sound = matches!(finding.verdict, Verdict::Certified | Verdict::Definition) || is_limit;
                assert!(is_sound, "{name} ({}): {} {}", equation.id, finding.verdict, equation.reading);
            }
            let granted = |line: &Line| line.from.is_empty();
            let lines: Vec<&Line> = lecture.lines().collect();
            for line in lines.iter().filter(|line| !granted(line)) {
                let place = |number: &str| lines.iter().position(|line| line.number == number);
                assert!(line.from.iter().all(|from| place(from) < place(&line.number)), "{name} ({})", line.number);
            }
            let definitions = lecture.document.equations.iter().filter(|e| e.finding.verdict == Verdict::Definition);
            let mut granted: Vec<&str> =
                lines.iter().filter(|line| granted(line)).map(|line| line.number.as_str()).collect();
            let mut defined: Vec<&str> = definitions.map(|equation| equation.id.as_str()).collect();
            granted.sort_unstable();
            defined.sort_unstable();
            assert_eq!(granted, defined, "{name}");
        }
    }

    #[test]
    fn a_slip_in_a_line_is_refuted() {
        let registry = Registry::standard();
        let lecture = lecture(registry.get("heavy_top").unwrap(), 1);
        for (from, to) in [
            ("- \\dot{\\theta} \\, \\sin\\phi", "- \\dot{\\theta} \\, \\cos\\phi"),
            ("\\frac{1}{2} \\, \\lambda_3", "\\lambda_3"),
            ("- p_\\psi \\, \\Omega", "+ p_\\psi \\, \\Omega"),
        ] {
            let wrong = lecture.notes.replace(from, to);
            if wrong == lecture.notes {
                panic!("{from} is not in {}", lecture.notes);
            }
            let document = checked(&wrong, &lecture.claims, 1).unwrap();
            assert!(document.equations.iter().any(|equation| equation.finding.verdict == Verdict::Refuted), "{to}");
        }
    }

    #[test]
    fn the_values_are_those_of_the_tapes() {
        let registry = Registry::standard();
        for name in registry.names() {
            let system = registry.get(name).unwrap().trace().unwrap();
            let lecture = lecture(registry.get(name).unwrap(), 7);
            let (q, v, p) = lecture.sample.numbers();
            let time = lecture.sample.time;
            let at = system.quantities(time, &q, &v, &p);
            let line = |begins: &str| {
                let starts = |equation: &&crate::check::Equation| equation.latex.trim().starts_with(begins);
                let id = &lecture.document.equations.iter().rfind(starts).unwrap_or_else(|| panic!("{begins}")).id;
                lecture.lines().find(|line| line.number == *id).unwrap().values.clone()
            };
            let mut expected = vec![("L =".to_owned(), at.lagrangian), ("E = ".to_owned() + "\\dot", at.energy)];
            let slope = |i: &usize| system.coordinates()[*i].replace("_1", "_{1}").replace("_2", "_{2}");
            let plain = |i: &usize| match slope(i) {
                name if name.contains('{') => format!("p_{{{name}}} = \\frac"),
                name => format!("p_{name} = \\frac"),
            };
            expected.extend((0..q.len()).map(|i| (plain(&i), at.momenta[i])));
            if system.has_potential() {
                expected.push(("H =".to_owned(), at.energy));
            }
            for (begins, value) in expected {
                let found = line(&begins);
                assert!(
                    found.iter().all(|found| (found - value).abs() < 1e-12 * (1.0 + value.abs())),
                    "{name} {begins}"
                );
                // must-fail case
                assert!(found.iter().any(|found| (found + 0.1 - value).abs() > 1e-3), "{name}");
            }
        }
    }
}
