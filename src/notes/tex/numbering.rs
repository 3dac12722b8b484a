//! The numbers that LaTeX prints by itself beside displays of a TeX document.
//!
//! The counters `equation`, `chapter`, `section` and those below are followed through the text, with `\numberwithin`,
//! `\counterwithin`, `\setcounter`, `\addtocounter`, `\appendix`, `subequations` and a `\theequation` that is put together
//! from counters. Where a number depends on something else, no display has one.

use crate::notes::macros::MacroDefinition;
use crate::notes::tex_scanner::{self, Delimiter, RawDisplay};
use crate::notes::{rows, tex_scanner::begin};
use crate::source::Span;

/// A number, and the display or the row that it is printed beside.
pub(in crate::notes) struct Automatic {
    /// The number, without its parentheses.
    pub id: String,
    /// The row.
    pub row: Span,
}

/// The counters of headings, from the outermost on.
const HEADINGS: [&str; 5] = ["part", "chapter", "section", "subsection", "subsubsection"];

/// How the text of a number is put together.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Piece {
    Text(String),
    /// The printed form of a heading's number, with what it is within.
    Heading(usize),
    /// The counter of a heading alone.
    Counter(usize, Style),
    Equation(Style),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Arabic,
    Alph,
    UpperAlph,
    Roman,
    UpperRoman,
}

struct Counters {
    equation: usize,
    headings: [usize; 5],
    has_chapters: bool,
    is_appendix: bool,
    /// The heading that sets the counter of equations back.
    within: Option<usize>,
    form: Vec<Piece>,
    /// Within `subequations`: how many there were.
    sub: Option<usize>,
}

/// The automatic numbers of a document. `clean` is its text without comments and definitions.
pub(in crate::notes) fn automatic(clean: &[u8], raws: &[RawDisplay], macros: &[MacroDefinition]) -> Vec<Automatic> {
    let text = String::from_utf8_lossy(clean);
    if text.len() != clean.len() {
        return Vec::new();
    }
    let Some(mut counters) = Counters::of(&text, macros) else { return Vec::new() };
    let mut found = Vec::new();
    let mut raws = raws.iter().peekable();
    let mut at = 0;
    while let Some(next) = tex_scanner::find(&text, at, "\\") {
        while raws.next_if(|raw| raw.span.start < next).is_some() {}
        if let Some(raw) = raws.next_if(|raw| raw.span.start == next) {
            counters.display(&text, raw, &mut found);
            at = raw.span.end;
            continue;
        }
        let word = tex_scanner::word_end(clean, next);
        at = word.max(next + 2);
        while at < text.len() && !text.is_char_boundary(at) {
            at += 1;
        }
        if counters.command(&text, next, word).is_none() {
            return Vec::new();
        }
    }
    found
}

impl Counters {
    fn of(text: &str, macros: &[MacroDefinition]) -> Option<Counters> {
        let class = text.find("\\documentclass").map(|at| &text[at..text.len().min(at + 400)]);
        let class = class.and_then(|rest| rest.split_once('}')).map(|(rest, _)| rest).unwrap_or_default();
        let has_chapters = ["book", "report", "scrbook", "scrreprt", "memoir", "thesis"]
            .iter()
            .any(|name| class.rsplit('{').next().is_some_and(|class| class.contains(name)));
        // A part of a larger document has the numbers of that.
        let is_part = text.contains("{subfiles}");
        let within = has_chapters.then_some(1);
        let form = match within {
            Some(chapter) => heading_then_equation(chapter),
            None => vec![Piece::Equation(Style::Arabic)],
        };
        let mut counters =
            Counters { equation: 0, headings: [0; 5], has_chapters, is_appendix: false, within, form, sub: None };
        if let Some(own) = macros.iter().rfind(|own| own.name == "\\theequation") {
            counters.form = form_of(&own.body)?;
            // Without \numberwithin, as \@addtoreset or a chapter would set it.
            counters.within = counters.form.iter().find_map(|piece| match piece {
                Piece::Heading(level) | Piece::Counter(level, _) => Some(*level),
                _ => None,
            });
        }
        (!is_part).then_some(counters)
    }

    /// Follows a command of the text; `None`, where the numbers can no longer be known.
    fn command(&mut self, text: &str, at: usize, word: usize) -> Option<()> {
        let bytes = text.as_bytes();
        let star = bytes.get(word) == Some(&b'*');
        let argument = |at: usize| {
            let open = tex_scanner::skip_space(bytes, at);
            let end = tex_scanner::short_group(bytes, open)?;
            Some((text.get(open + 1..end - 1)?.trim(), end))
        };
        match &text[at + 1..word] {
            "begin" if begin(text, at).is_some_and(|(name, _)| name == "subequations") => {
                self.step();
                self.sub = Some(0);
            }
            "end" if text[at..].starts_with("\\end{subequations}") => self.sub = None,
            "appendix" => {
                self.is_appendix = true;
                self.headings = [0; 5];
            }
            "numberwithin" | "counterwithin" => {
                let (counter, end) = argument(word + usize::from(star))?;
                if counter == "equation" {
                    let (parent, _) = argument(end)?;
                    let level = HEADINGS.iter().position(|heading| *heading == parent)?;
                    self.within = Some(level);
                    if !star {
                        self.form = heading_then_equation(level);
                    }
                }
            }
            command @ ("setcounter" | "addtocounter" | "stepcounter" | "refstepcounter") => {
                let (counter, end) = argument(word)?;
                let heading = HEADINGS.iter().position(|heading| *heading == counter);
                let place = match (counter, heading) {
                    ("equation", _) => &mut self.equation,
                    (_, Some(level)) => &mut self.headings[level],
                    _ => return Some(()),
                };
                let value = match command {
                    "setcounter" => argument(end)?.0.parse().ok()?,
                    "addtocounter" => place.checked_add_signed(argument(end)?.0.parse().ok()?)?,
                    _ => *place + 1,
                };
                *place = value;
            }
            heading if !star => {
                if let Some(level) = HEADINGS.iter().position(|known| *known == heading) {
                    self.headings[level] += 1;
                    self.headings[level + 1..].iter_mut().for_each(|below| *below = 0);
                    // A new part does not begin the chapters anew.
                    if self.within.is_some_and(|within| level <= within && level > 0) {
                        self.equation = 0;
                    }
                }
            }
            _ => {}
        }
        Some(())
    }

    /// Numbers the rows of a display.
    fn display(&mut self, text: &str, raw: &RawDisplay, found: &mut Vec<Automatic>) {
        if !raw.is_numbered {
            return;
        }
        let rows = match raw.delimiter {
            Delimiter::Rows => rows::split(text.as_bytes(), raw.body),
            _ => vec![raw.body],
        };
        for row in rows {
            let inside = &text[row.range()];
            if ["\\nonumber", "\\notag", "\\tag"].iter().any(|mark| inside.contains(mark)) {
                continue;
            }
            let id = self.number();
            found.push(Automatic { id, row });
        }
    }

    fn step(&mut self) {
        self.equation += 1;
    }

    /// The next number.
    fn number(&mut self) -> String {
        let letter = match &mut self.sub {
            Some(count) => {
                *count += 1;
                written(*count, Style::Alph)
            }
            None => {
                self.step();
                String::new()
            }
        };
        let pieces = self.form.iter().map(|piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Heading(level) => self.heading(*level),
            Piece::Counter(level, style) => written(self.headings[*level], *style),
            Piece::Equation(style) => written(self.equation, *style),
        });
        pieces.collect::<String>() + &letter
    }

    /// The printed number of a heading: `2.1` of a section within a chapter.
    fn heading(&self, level: usize) -> String {
        let top = if self.has_chapters || level == 1 { 1 } else { 2 };
        let top = top.min(level);
        let numbers = (top..=level).map(|level| {
            let style = if level == top && self.is_appendix { Style::UpperAlph } else { Style::Arabic };
            written(self.headings[level], style)
        });
        numbers.collect::<Vec<_>>().join(".")
    }
}

fn heading_then_equation(level: usize) -> Vec<Piece> {
    vec![Piece::Heading(level), Piece::Text(".".to_owned()), Piece::Equation(Style::Arabic)]
}

/// The pieces of a `\theequation`; `None` for what is not put together from counters.
fn form_of(body: &str) -> Option<Vec<Piece>> {
    let mut pieces = Vec::new();
    let mut rest = body.trim();
    while let Some(first) = rest.chars().next() {
        if first != '\\' {
            if matches!(first, '{' | '}' | '#' | '$') {
                return None;
            }
            pieces.push(Piece::Text(first.to_string()));
            rest = &rest[first.len_utf8()..];
            continue;
        }
        let word = tex_scanner::word_end(rest.as_bytes(), 0);
        let (command, after) = (&rest[1..word], rest[word..].trim_start());
        if let Some(level) = command.strip_prefix("the").and_then(|name| HEADINGS.iter().position(|h| *h == name)) {
            pieces.push(Piece::Heading(level));
            rest = after;
            continue;
        }
        let style = match command {
            "arabic" => Style::Arabic,
            "alph" => Style::Alph,
            "Alph" => Style::UpperAlph,
            "roman" => Style::Roman,
            "Roman" => Style::UpperRoman,
            _ => return None,
        };
        let (counter, after) = after.strip_prefix('{')?.split_once('}')?;
        pieces.push(match HEADINGS.iter().position(|heading| *heading == counter) {
            Some(level) => Piece::Counter(level, style),
            None if counter == "equation" => Piece::Equation(style),
            None => return None,
        });
        rest = after;
    }
    pieces.iter().any(|piece| matches!(piece, Piece::Equation(_))).then_some(pieces)
}

fn written(count: usize, style: Style) -> String {
    let letter = |first: u8| match u8::try_from(count) {
        Ok(n @ 1..=26) => char::from(first + n - 1).to_string(),
        _ => count.to_string(),
    };
    match style {
        Style::Arabic => count.to_string(),
        Style::Alph => letter(b'a'),
        Style::UpperAlph => letter(b'A'),
        Style::Roman => roman(count),
        Style::UpperRoman => roman(count).to_uppercase(),
    }
}

fn roman(count: usize) -> String {
    const LETTERS: [(usize, &str); 13] = [
        (1000, "m"),
        (900, "cm"),
        (500, "d"),
        (400, "cd"),
        (100, "c"),
        (90, "xc"),
        (50, "l"),
        (40, "xl"),
        (10, "x"),
        (9, "ix"),
        (5, "v"),
        (4, "iv"),
        (1, "i"),
    ];
    let (mut rest, mut text) = (count, String::new());
    for (value, letters) in LETTERS {
        // Greater numbers are no numbers of equations.
        while rest >= value && text.len() < 40 {
            text.push_str(letters);
            rest -= value;
        }
    }
    text
}
