//! Addresses: the ways in which a claims file names an equation of the notes.
//!
//! A printed number (`6.72`), a label, a snippet in backticks, `` every `…` ``, a name (`#veff`); with `row 2`,
//! `part 1`, `step 3` after it; ranges `A .. B` and lists `A, B`.

use std::sync::Arc;

use super::display::Display;
use super::document::Notes;
use super::json::{LONGEST, Spanned, place_in_string};
use super::normalize::normalized;
use super::tex_scanner::is_number;
use crate::code::Code;
use crate::source::{Fault, Source, Span};
use crate::suggest;
use crate::{Error, Result};

/// An address as it is written, and the equations that it names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    /// As written.
    pub text: String,
    /// Its place in the claims file.
    pub span: Span,
    /// The members of the list; one, mostly.
    pub items: Vec<Item>,
}

/// One member of a list of addresses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Item {
    /// One equation (or `every`).
    One(Point),
    /// All displays from the first to the second.
    Range(Point, Point),
}

/// One equation, or a part of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// Which display.
    pub target: Target,
    /// `row 2`: which row, from 1.
    pub row: Option<usize>,
    /// `part 1`: which statement of it, from 1.
    pub part: Option<usize>,
    /// `step 3`: which relation of the chain, from 1.
    pub step: Option<usize>,
    /// Its place in the claims file.
    pub span: Span,
}

/// The place in the notes that a point names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The display, as its position in `notes.equations`.
    pub display: usize,
    /// Which row of it, from 1; all, if nothing is said.
    pub row: Option<usize>,
    /// Which statement, from 1; all, if nothing is said.
    pub part: Option<usize>,
    /// Which relation of the chain, from 1; all, if nothing is said.
    pub step: Option<usize>,
}

/// The ways to name a display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// By its printed number: `6.72`.
    Number(String),
    /// By its label: `eqn:tongMf1:880c`.
    Label(String),
    /// By LaTeX that only it contains.
    Snippet(String),
    /// By LaTeX, however many contain it.
    EverySnippet(String),
    /// By the name given in a comment; with its `#`.
    Name(String),
}

impl Address {
    /// Reads an address; `written` is a string of the claims file `source`.
    pub fn parse(written: &Spanned<String>, source: &Source) -> Result<Address, Fault> {
        let text = &written.value;
        if text.len() > LONGEST {
            return Err(invalid(written.span, format!("this address is too long: it has more than {LONGEST} bytes")));
        }
        let place = |part: Span| place_in_string(&source.text, written.span, part);
        let mut items = Vec::new();
        for member in split(text, ",") {
            let ends = split(&text[member.range()], "..");
            let mut points = Vec::new();
            for end in &ends {
                points.push(point(text, end.shifted(member.start), &place)?);
            }
            let mut points = points.into_iter();
            match (points.next(), points.next(), points.next()) {
                (Some(one), None, _) => items.push(Item::One(one)),
                (Some(from), Some(to), None) => items.push(Item::Range(from, to)),
                _ => {
                    return Err(invalid(place(member), "a range of equations needs two ends")
                        .help("write a range as `3.52 .. 3.56`"));
                }
            }
        }
        Ok(Address { text: text.clone(), span: written.span, items })
    }

    /// The address of the display with a number; `span` is the place in the claims file that is blamed for it.
    pub fn of_number(number: &str, span: Span) -> Address {
        let target = Target::Number(number.to_owned());
        let point = Point { target, row: None, part: None, step: None, span };
        Address { text: number.to_owned(), span, items: vec![Item::One(point)] }
    }

    /// The point, if the address is neither a list nor a range.
    pub fn single(&self) -> Option<&Point> {
        match self.items.as_slice() {
            [Item::One(point)] => Some(point),
            _ => None,
        }
    }

    /// The displays that the address names, as positions in `notes.equations`, in the order of the address.
    ///
    /// `source` is the claims file, for the place of an error.
    pub fn resolve(&self, notes: &Notes, source: &Arc<Source>) -> Result<Vec<usize>> {
        let mut found = Vec::new();
        for item in &self.items {
            found.extend(item.resolve(notes, source)?);
        }
        Ok(found)
    }

    /// The places that the address names, with row, part and step, in the order of the address.
    ///
    /// # Errors
    /// A range with a row, a part or a step, and a point that names no equation or several.
    pub fn lookup(&self, notes: &Notes, source: &Arc<Source>) -> Result<Vec<Place>> {
        let partial = |point: &&Point| point.row.or(point.part).or(point.step).is_some();
        let mut places = Vec::new();
        for item in &self.items {
            let (row, part, step) = match item {
                Item::One(point) => (point.row, point.part, point.step),
                Item::Range(from, to) => {
                    if let Some(point) = [from, to].into_iter().find(partial) {
                        return Err(not_found(source, point.span, "the ends of a range must be whole equations")
                            .help("leave out `row`, `part` and `step`, or list the parts one by one, with commas"));
                    }
                    (None, None, None)
                }
            };
            let displays = item.resolve(notes, source)?.into_iter();
            places.extend(displays.map(|display| Place { display, row, part, step }));
        }
        Ok(places)
    }
}

impl Item {
    fn resolve(&self, notes: &Notes, source: &Arc<Source>) -> Result<Vec<usize>> {
        match self {
            Item::One(point) => point.resolve(notes, source),
            Item::Range(from, to) => {
                let (first, last) = (from.one(notes, source)?, to.one(notes, source)?);
                if last < first {
                    return Err(not_found(
                        source,
                        from.span.to(to.span),
                        "in the notes, the second equation of this range stands before the first",
                    )
                    .help("exchange the two ends"));
                }
                Ok((first..=last).collect())
            }
        }
    }
}

impl Point {
    fn one(&self, notes: &Notes, source: &Arc<Source>) -> Result<usize> {
        match self.resolve(notes, source)?.as_slice() {
            [one] => Ok(*one),
            _ => Err(not_found(source, self.span, "each end of a range must be one equation, so leave out `every`")),
        }
    }

    /// The displays that the point names: one, or several for `every`.
    ///
    /// # Errors
    /// No such display, or several without `every`.
    pub fn resolve(&self, notes: &Notes, source: &Arc<Source>) -> Result<Vec<usize>> {
        let (found, every) = match &self.target {
            Target::Number(id) | Target::Label(id) | Target::Name(id) => (notes.find(id), false),
            Target::Snippet(snippet) => (containing(notes, snippet), false),
            Target::EverySnippet(snippet) => (containing(notes, snippet), true),
        };
        match found.len() {
            0 => Err(self.missing(notes, source)),
            1 => Ok(found),
            _ if every => Ok(found),
            count => {
                let shown: Vec<String> = found.iter().take(4).map(|&i| candidate(&notes.equations[i])).collect();
                let more = if count > 4 { ", …" } else { "" };
                Err(not_found(source, self.span, format!("{count} displays match {}", self.named())).help(format!(
                    "they are {}{more}; quote more of the LaTeX of one, or write `every` for all of them",
                    shown.join(", ")
                )))
            }
        }
    }

    fn named(&self) -> String {
        match &self.target {
            Target::Number(id) => format!("({id})"),
            Target::Label(id) => format!("the label {id}"),
            Target::Name(id) => id.clone(),
            Target::Snippet(snippet) | Target::EverySnippet(snippet) => format!("`{snippet}`"),
        }
    }

    fn missing(&self, notes: &Notes, source: &Arc<Source>) -> Error {
        let path = &notes.source.path;
        let message = match &self.target {
            Target::Number(id) => format!("{path} has no equation ({id})"),
            Target::Label(id) => format!("no equation in {path} has the label {id}"),
            Target::Name(id) => format!("no equation in {path} is named {id}"),
            Target::Snippet(snippet) | Target::EverySnippet(snippet) => {
                format!("no display in {path} contains `{snippet}`")
            }
        };
        let error = not_found(source, self.span, message);
        match &self.target {
            Target::Snippet(_) | Target::EverySnippet(_) => error.help("copy the LaTeX from the notes"),
            Target::Number(id) | Target::Label(id) | Target::Name(id) => match (closest(notes, id), known(notes)) {
                (_, None) => error.help(
                    "the notes have no numbers, labels or names; quote a piece of the equation's LaTeX in backticks",
                ),
                (Some(closest), _) => error.help(format!("did you mean {closest}?")),
                (None, Some(known)) => error.help(format!("the notes have {known}")),
            },
        }
    }
}

fn invalid(span: Span, message: impl Into<String>) -> Fault {
    Fault::new(span, message).code(Code::EquationAddress)
}

fn not_found(source: &Arc<Source>, span: Span, message: impl Into<String>) -> Error {
    Error::at(source, span, message).with_code(Code::EquationAddress)
}

/// All numbers, labels and names of the notes.
fn ids(notes: &Notes) -> impl Iterator<Item = &str> {
    notes.equations.iter().flat_map(|d| d.number.iter().chain(&d.labels)).map(|n| n.id.as_str())
}

/// The nearest number of the same chapter, as they count; or the label or name nearest to `id`.
fn closest<'a>(notes: &'a Notes, id: &str) -> Option<&'a str> {
    let apart = |other: &str| match (chapter(id), chapter(other)) {
        (Some((a, m)), Some((b, n))) if a == b => Some(m.abs_diff(n)),
        _ => None,
    };
    let of_chapter = ids(notes).filter(|other| apart(other).is_some()).min_by_key(|other| apart(other));
    of_chapter.or_else(|| suggest::nearest(id, ids(notes)))
}

fn chapter(id: &str) -> Option<(&str, u64)> {
    let (chapter, number) = id.rsplit_once('.')?;
    Some((chapter, number.parse().ok()?))
}

/// The numbers, labels and names of the notes in words: a few, or the first and the last.
fn known(notes: &Notes) -> Option<String> {
    const FEW: usize = 8;
    let ids: Vec<String> = ids(notes).map(|id| format!("({id})")).collect();
    match ids.as_slice() {
        [] => None,
        few if few.len() <= FEW => Some(few.join(", ")),
        [first, .., last] => Some(format!("{} equations with a number or a label, from {first} to {last}", ids.len())),
        [one] => Some(one.clone()),
    }
}

fn containing(notes: &Notes, snippet: &str) -> Vec<usize> {
    let snippet = normalized(snippet);
    let contains = |display: &Display| normalized(&display.text).contains(&snippet);
    (0..notes.equations.len()).filter(|&i| contains(&notes.equations[i])).collect()
}

/// A display in a list of candidates.
fn candidate(display: &Display) -> String {
    let start: String = display.text.split_whitespace().collect::<Vec<_>>().join(" ").chars().take(40).collect();
    match &display.number {
        Some(number) => format!("({}) in line {}", number.id, display.line),
        None => format!("`{start}` in line {}", display.line),
    }
}

/// Pieces of `text` between `separator`s outside of backticks.
fn split(text: &str, separator: &str) -> Vec<Span> {
    let (mut pieces, mut start, mut quoted, mut i) = (Vec::new(), 0, false, 0);
    let bytes = text.as_bytes();
    while i < bytes.len() {
        if bytes[i] == b'`' {
            quoted = !quoted;
        } else if !quoted && bytes[i..].starts_with(separator.as_bytes()) {
            pieces.push(Span::new(start, i));
            i += separator.len();
            start = i;
            continue;
        }
        i += 1;
    }
    pieces.push(Span::new(start, text.len()));
    pieces
}

fn point(text: &str, span: Span, place: &dyn Fn(Span) -> Span) -> Result<Point, Fault> {
    let (mut rest, mut at) = (&text[span.range()], span.start);
    at += rest.len() - rest.trim_start().len();
    rest = rest.trim();
    let here = place(Span::new(at, at + rest.len()));
    let mut point = Point { target: Target::Number(String::new()), row: None, part: None, step: None, span: here };
    // From the end: `step`, `part`, `row`, as they stand.
    while !rest.ends_with('`')
        && let Some((before, count)) = rest.rsplit_once(char::is_whitespace)
        && let Some((front, word)) = before.trim_end().rsplit_once(char::is_whitespace)
    {
        let slot = match word {
            "step" if point.row.is_none() && point.part.is_none() => &mut point.step,
            "part" if point.row.is_none() => &mut point.part,
            "row" => &mut point.row,
            _ => break,
        };
        let count: Option<usize> = count.parse().ok().filter(|&n| n > 0);
        if count.is_none() || slot.is_some() {
            return Err(invalid(here, format!("`{word}` needs one number, counted from 1"))
                .help("write a number after it, as in `6.72 row 2 part 1`"));
        }
        *slot = count;
        rest = front.trim_end();
    }
    point.target = target(rest).ok_or_else(|| {
        invalid(here, format!("`{rest}` is not an address of an equation")).help(
            "write a number (6.72), a label, a name (#veff), or LaTeX in backticks; after it, `row`, `part` and \
             `step` may follow in this order",
        )
    })?;
    Ok(point)
}

fn target(rest: &str) -> Option<Target> {
    let (every, body) = match rest.strip_prefix("every").map(str::trim_start) {
        Some(body) if body.starts_with('`') => (true, body),
        _ => (false, rest),
    };
    if let Some(snippet) = body.strip_prefix('`') {
        let snippet = snippet.strip_suffix('`')?.trim();
        let usable = !normalized(snippet).is_empty() && !snippet.contains('`');
        let target = if every { Target::EverySnippet } else { Target::Snippet };
        return usable.then(|| target(snippet.to_owned()));
    }
    if body.is_empty() || body.contains(char::is_whitespace) || body.contains('`') {
        return None;
    }
    if body.starts_with('#') {
        return (body.len() > 1).then(|| Target::Name(body.to_owned()));
    }
    let inside = body.strip_prefix('(').and_then(|b| b.strip_suffix(')')).unwrap_or(body);
    Some(if is_number(inside) { Target::Number(inside.to_owned()) } else { Target::Label(inside.to_owned()) })
}
