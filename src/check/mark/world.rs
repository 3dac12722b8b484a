//! One document of a problem and a hand-in: the displays of the problem, and after them the lines of the hand-in.
//!
//! The text of the document is that of the lines, with the letters of the problem, one after the other, and then that of
//! the problem. Places in it lead back to the hand-in.

use std::collections::HashMap;
use std::sync::Arc;

use crate::Result;
use crate::formula::symbols::Name;
use crate::formula::{Expr, SymbolId};
use crate::latex::Reading;
use crate::latex::foreign::FUNCTION_WORDS;
use crate::latex::rename::{Renamed, renamed, renamed_with};
use crate::latex::{Macros, names};
use crate::notes::claims::{Claims, Declaration, Range, Role, Spanned};
use crate::notes::{Display, Form, MacroDefinition, Notes, Numbered};
use crate::source::{Missing, Source, Span};

use crate::check::document::checker::Checker;
use crate::check::document::setup::{Run, define_macros, with_checker};
use crate::check::document::unreadable::faults;
use crate::check::usage::{Usage, names_of};

use super::names::{Letters, Names};
use super::problem::Problem;
use super::written::Written;
use super::written::instants::{Instant, Kind};
use super::written::single_letters;

/// What an edit puts in, with the letters of the problem, if it is a name.
fn in_letters(new: &str, table: &HashMap<Name, Name>) -> String {
    let name = new.strip_prefix('{').and_then(|rest| rest.strip_suffix('}')).and_then(names::parse);
    let other = name.and_then(|(name, _)| table.get(&name));
    other.map_or_else(|| new.to_owned(), |other| format!("{{{other}}}"))
}

/// Commands for functions in other languages, with the ones that are read.
fn foreign_commands() -> impl Iterator<Item = (String, &'static str)> {
    let named = FUNCTION_WORDS.iter().map(|(word, own)| (format!("\\{word}"), *own));
    named.filter(|(name, own)| name != own)
}

/// The names that a line only compares with another name after they were used, `A_1 = -A_2`: it says how two amplitudes are
/// related, and does not define one.
fn related(lines: &[Display], usages: &[Usage]) -> Vec<Name> {
    let name = |text: &str| {
        let parsed = names::parse(text.trim().trim_start_matches('-').trim());
        parsed.filter(|(_, dots)| *dots == 0).map(|(name, _)| name)
    };
    let sides = |line: &Display| line.text.split_once('=').map(|(left, right)| (name(left), name(right)));
    let is_used = |at: usize, of: &Name| usages.iter().any(|usage| usage.name == *of && usage.first < at);
    let is_defined = |of: &Name| {
        lines.iter().filter_map(sides).any(|(left, right)| left.as_ref() == Some(of) && right.is_none())
            || usages.iter().any(|usage| usage.name == *of && usage.introduced.is_some())
    };
    let compared = |(at, line): (usize, &Display)| {
        let (Some(left), Some(right)) = sides(line)? else { return None };
        let used = [left, right].into_iter().filter(move |name| is_used(at, name) && !is_defined(name));
        Some(used.collect::<Vec<_>>())
    };
    lines.iter().enumerate().filter_map(compared).flatten().collect()
}

/// The names to which a hand-in gives two values with "or" between them, `\omega^2 = \frac km` or `\omega^2 = \frac{3k}m`, and which
/// the problem has with numbers: no line defines one of these.
fn of_several_values(lines: &[Display], written: &[Written], known: &Names) -> Vec<Name> {
    let left = |line: &Display| {
        let (left, _) = line.text.split_once('=')?;
        let base = ["^2", "^{2}"].iter().find_map(|power| left.trim().strip_suffix(power)).unwrap_or(left);
        names::parse(base.trim()).filter(|(_, dots)| *dots == 0).map(|(name, _)| name)
    };
    let pairs = lines.windows(2).zip(written.iter().skip(1)).filter(|(_, second)| second.is_alternative);
    let same = pairs.filter_map(|(pair, _)| left(&pair[0]).filter(|name| left(&pair[1]).as_ref() == Some(name)));
    same.filter(|name| known.symbols.find(name).is_none() && known.numbered(name).len() > 1).collect()
}

/// How often the lines are read again with the names that were missing.
const ROUNDS: usize = 4;

/// A text as a display, which is written at the end of a document.
fn appended(latex: &str, id: &str, line: usize, text: &mut String) -> Display {
    let body = Span::new(text.len(), text.len() + latex.len());
    text.push_str(latex);
    text.push('\n');
    Display {
        span: body,
        body,
        parts: vec![body],
        text: latex.to_owned(),
        number: Some(Numbered { id: id.to_owned(), span: body }),
        labels: Vec::new(),
        automatic: Vec::new(),
        numbers_rows: false,
        line,
    }
}

/// The definitions of the letters that stand for rates, as displays before the lines.
fn definitions_of_rates(letters: &Letters, text: &mut String) -> Vec<Display> {
    let rates = letters.iter().filter(|(_, other)| other.dots > 0);
    let mut rates: Vec<String> = rates.map(|(own, other)| format!("{own} = {}", other.latex())).collect();
    rates.sort();
    rates.into_iter().map(|latex| appended(&latex, &latex, 0, text)).collect()
}

/// A display of the problem, where its text begins at an offset.
fn moved(display: &Display, offset: usize) -> Display {
    let shifted = |numbered: &Numbered| Numbered { id: numbered.id.clone(), span: numbered.span.shifted(offset) };
    Display {
        span: display.span.shifted(offset),
        body: display.body.shifted(offset),
        parts: display.parts.iter().map(|part| part.shifted(offset)).collect(),
        number: display.number.as_ref().map(shifted),
        labels: display.labels.iter().map(shifted).collect(),
        ..display.clone()
    }
}

/// The value at an instant, with the letters of the problem.
fn in_letters_of_problem(instant: &Instant, macros: &Macros, table: &HashMap<Name, Name>) -> Instant {
    Instant {
        name: instant.name.clone(),
        of: renamed(&instant.of, macros, table).text,
        when: renamed(&instant.when, macros, table).text,
        kind: match &instant.kind {
            Kind::Of(letter) => Kind::Of(renamed(letter, macros, table).text),
            other => other.clone(),
        },
    }
}

/// A problem and a hand-in as one document.
pub(super) struct World<'p> {
    pub problem: &'p Problem,
    pub written: &'p [Written],
    pub claims: Claims,
    pub notes: Notes,
    /// The place of the first line among the displays.
    pub first: usize,
    /// The names that only the hand-in has, and that were declared for it.
    pub declared: Vec<Name>,
    /// The values at instants, with the letters of the problem.
    pub instants: Vec<Instant>,
    /// The limits that the sentences of the lines name, with the letters of the problem.
    pub limits: Vec<Option<String>>,
    /// The names to which the hand-in gives several values.
    several: Vec<Name>,
    lines: Vec<(usize, Renamed)>,
    /// The letters of the problem, and those of the student that stand for them.
    back: HashMap<Name, Name>,
    /// The names of which the hand-in writes rates with other names, as x''.
    rated: Vec<Name>,
    /// Those other names.
    rates: Vec<Name>,
}

impl<'p> World<'p> {
    /// The document of a hand-in whose names are replaced by those of a table.
    ///
    /// # Errors
    /// When no declaration makes sense of the hand-in.
    pub fn new(
        run: &Run<'_>,
        problem: &'p Problem,
        (notes, written, instants): (&Notes, &'p [Written], &[Instant]),
        letters: &Letters,
    ) -> Result<World<'p>> {
        let table = &problem.names.renamed(letters);
        let mut macros = Macros::default();
        define_macros(&notes.macros, &mut macros);
        foreign_commands().for_each(|(name, body)| macros.define(&name, 0, body));
        let mut text = String::new();
        let (mut lines, mut displays) = (Vec::new(), Vec::new());
        for line in written {
            let edits: Vec<(Span, String)> =
                line.edits.iter().map(|(span, new)| (*span, in_letters(new, table))).collect();
            let new = renamed_with(&line.text, &macros, table, &edits);
            let display = appended(&new.text, &line.name, line.line, &mut text);
            lines.push((display.body.start, new));
            displays.push(display);
        }
        let usages = names_of(&displays, &macros);
        let rates = definitions_of_rates(letters, &mut text);
        let offset = text.len();
        text.push_str(&problem.notes.source.text);
        let mut together = problem.notes.clone();
        together.source = Arc::new(Source::new(notes.source.path.clone(), text));
        together.equations =
            problem.notes.equations.iter().map(|display| moved(display, offset)).chain(rates).chain(displays).collect();
        let foreign = foreign_commands().map(|(name, body)| MacroDefinition {
            name,
            arguments: 0,
            form: Form::Plain,
            body: body.to_owned(),
            span: Span::default(),
        });
        together.macros.extend(foreign);
        together.macros.extend(notes.macros.iter().cloned());
        (together.inline, together.references) = (Vec::new(), Vec::new());
        let first = together.equations.len() - written.len();
        together.added_from = Some(problem.notes.equations.len());
        let claims = problem.claims.clone();
        let back = table.iter().map(|(own, other)| (other.clone(), own.clone())).collect();
        let instants = instants.iter().map(|instant| in_letters_of_problem(instant, &macros, table));
        let limit = |line: &Written| line.limit.as_ref().map(|limit| renamed(limit, &macros, table).text);
        let mut world = World {
            limits: written.iter().map(limit).collect(),
            problem,
            written,
            claims,
            notes: together,
            first,
            declared: Vec::new(),
            instants: instants.collect(),
            several: Vec::new(),
            lines,
            back,
            rated: letters.values().filter(|other| other.dots > 0).map(|other| other.name.clone()).collect(),
            rates: letters.iter().filter(|(_, other)| other.dots > 0).map(|(own, _)| own.clone()).collect(),
        };
        for name in world.instants.clone().iter().filter_map(|instant| Some(names::parse(&instant.name)?.0)) {
            world.declare(&name, &usages);
        }
        for name in related(&world.notes.equations[first..], &usages) {
            world.declare(&name, &usages);
        }
        world.several = of_several_values(&world.notes.equations[first..], written, &problem.names);
        for name in world.several.clone() {
            world.declare(&name, &usages);
        }
        world.declare_missing_names(run, &usages)?;
        Ok(world)
    }

    /// Declares what the lines use and neither the problem nor the lines define.
    fn declare_missing_names(&mut self, run: &Run<'_>, usages: &[Usage]) -> Result<()> {
        for _ in 0..ROUNDS {
            let first = self.first;
            let missing: Vec<String> = with_checker(run, &self.claims, &self.notes, |checker: Checker<'_>| {
                let of = |fault: &crate::source::Fault| match &fault.missing {
                    Some(Missing::Name(name)) => Some(name.clone()),
                    _ => None,
                };
                let readings = checker.readings[first..].iter();
                let missing = readings.flat_map(|reading| faults(reading).filter_map(of).collect::<Vec<_>>());
                // A constant of integration needs no declaration to be read, and is the student's own all the same.
                let free = checker.model.constants.iter().map(|constant| checker.model.name(constant.symbol));
                Ok(missing.chain(free).collect())
            })?;
            let mut is_new = false;
            for name in missing.iter().filter_map(|name| Some(names::parse(name)?.0)) {
                is_new |= self.declare(&name, usages);
            }
            if !is_new {
                break;
            }
        }
        Ok(())
    }

    fn declare(&mut self, name: &Name, usages: &[Usage]) -> bool {
        let shown = name.to_string();
        let is_hat = shown.starts_with("\\hat") || shown.starts_with("\\mathrm");
        // The d of a differential is no name.
        let is_differential = shown == "d" && usages.iter().any(|usage| usage.name == *name && usage.precedes);
        let is_known = self.problem.names.symbols.find(name).is_some();
        if self.declared.contains(name) || self.rates.contains(name) || is_hat || is_known || is_differential {
            return false;
        }
        let is_vector = ["\\vec{", "\\mathbf{", "\\boldsymbol{", "\\bm{"].iter().any(|mark| shown.starts_with(mark));
        let usage = usages.iter().find(|usage| usage.name == *name);
        let moves = usage.is_some_and(|usage| usage.moves) || self.rated.contains(name);
        let range = match usage {
            Some(usage) if usage.positive && !usage.opposite && !is_vector && !moves => Range::Positive,
            Some(usage) if usage.angle && !is_vector => Range::Angle,
            _ => Range::Any,
        };
        let span = self.claims.notes.span;
        self.claims.declarations.push(Declaration {
            is_formula: false,
            role: if moves { Role::VariesWithTime } else { Role::Constant },
            name: Spanned::new(shown, span),
            range: Spanned::new(range, span),
        });
        self.declared.push(name.clone());
        true
    }

    /// Makes the checker of the document, and passes it to `work`.
    ///
    /// # Errors
    /// As [`with_checker`].
    pub fn checked<T>(&self, run: &Run<'_>, work: impl FnOnce(Checker<'_>) -> Result<T>) -> Result<T> {
        with_checker(run, &self.claims, &self.notes, work)
    }

    /// The bytes of the hand-in for bytes of the document, which lie in the `at`-th line.
    pub fn original(&self, at: usize, span: Span) -> Option<Span> {
        let (start, line) = &self.lines[at];
        let inside = Span::new(span.start.checked_sub(*start)?, span.end.checked_sub(*start)?);
        (inside.end <= line.text.len()).then(|| line.original(inside).shifted(self.written[at].body.start))
    }

    /// A formula with the letters of the student.
    pub fn in_own_letters(&self, latex: &str) -> String {
        single_letters::as_written(&renamed(latex, &Macros::default(), &self.back).text)
    }

    /// A message in which names with a subscript or a command, and names of functions, are those of the student: other letters could be
    /// words.
    pub fn with_own_names(&self, message: &str) -> String {
        let mut new = String::new();
        let mut at = 0;
        let mut pairs: Vec<(String, String)> =
            self.back.iter().map(|(other, own)| (other.to_string(), own.to_string())).collect();
        pairs.sort_by_key(|(other, _)| std::cmp::Reverse(other.len()));
        while let Some(next) = message[at..].chars().next() {
            let is_inside = message[..at].ends_with(|c: char| c.is_alphanumeric() || "_\\".contains(c));
            let found = pairs.iter().filter(|_| !is_inside).find(|(other, _)| {
                let Some(rest) = message[at..].strip_prefix(other.as_str()) else { return false };
                let is_name = other.contains(['_', '\\']) || rest.starts_with('(');
                is_name && !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_')
            });
            match found {
                Some((other, own)) => {
                    new += own;
                    at += other.len();
                }
                None => {
                    new.push(next);
                    at += next.len_utf8();
                }
            }
        }
        new
    }

    /// Whether letters of the hand-in were taken for others.
    pub fn has_other_letters(&self) -> bool {
        !self.back.is_empty()
    }

    /// Whether the hand-in gives a name several values, with "or" between them.
    pub fn has_several_values(&self, name: &Name) -> bool {
        self.several.contains(name)
    }

    /// The one letter of the student's own in a line that the problem has with numbers, and the values that it may have there.
    pub fn letter_with_values(&self, checker: &Checker<'_>, reading: &Reading) -> Option<(SymbolId, Vec<SymbolId>)> {
        let (symbols, known) = (&checker.model.symbols, &self.problem.names);
        let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let used: Vec<SymbolId> = members.flat_map(Expr::symbols).map(|(id, _)| id).collect();
        let numbered = |id: &SymbolId| {
            let name = &symbols.entry(*id).name;
            let values = known.numbered(name).into_iter().filter_map(|value| Some(symbols.find(value)?.0));
            let values: Vec<SymbolId> = values.collect();
            (values.len() > 1 && known.symbols.find(name).is_none()).then_some((*id, values))
        };
        let found = used.iter().find_map(numbered)?;
        (!used.iter().any(|id| found.1.contains(id))).then_some(found)
    }

    /// Whether a name of the hand-in was taken for a rate.
    pub fn stands_for_a_rate(&self, name: &Name) -> bool {
        self.rates.contains(name)
    }

    /// The display of the `at`-th line.
    pub fn display(&self, at: usize) -> &Display {
        &self.notes.equations[self.first + at]
    }
}
