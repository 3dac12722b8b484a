//! The numbering of displays: tags, labels, numbers printed beside a display, and neighbouring displays with one
//! number.
//!
//! There are two copies of the file: the text as it is, and `clean`, in which spaces replace everything that is no
//! formula. The text of a display comes from `clean`, so that a place in it is also a place in the file.

use super::display::{Display, Numbered};

use super::inner_numbers::{self, Body};
use super::rows;
use super::tex_scanner::{self, Delimiter, Name, RawDisplay};
use crate::source::{Fault, Source, Span};

/// Overwrites `spans` by spaces, line ends kept.
pub(super) fn blank<'a>(clean: &mut [u8], spans: impl IntoIterator<Item = &'a Span>) {
    for span in spans {
        for byte in &mut clean[span.range()] {
            if *byte != b'\n' {
                *byte = b' ';
            }
        }
    }
}

/// A display with its number and labels, before neighbours are joined.
struct Piece {
    raw: RawDisplay,
    /// With an inline tail, as in `$$x = 1$$ , $y = 2$ (2.7)`.
    body: Span,
    number: Option<Numbered>,
    /// Whether the number stands after the display, or alone in it, and so may close several displays.
    closes: bool,
    labels: Vec<Numbered>,
    /// Whether it starts with a relation.
    continues: bool,
    /// Whether it holds nothing but its number.
    bare: bool,
    /// The byte after which the next display may begin as a neighbour.
    end: usize,
}

/// Joins and numbers the displays, and extracts their texts.
///
/// # Errors
/// A display with two numbers, and a name without a display.
pub(super) fn assemble(
    file: &Source,
    clean: Vec<u8>,
    raws: Vec<RawDisplay>,
    names: Vec<Name>,
) -> Result<Vec<Display>, Fault> {
    let source = file.text.as_str();
    let mut work = Work { source, file, clean };
    let mut pieces = Vec::new();
    let mut names = names.into_iter().peekable();
    for (i, raw) in raws.iter().enumerate() {
        let next = raws.get(i + 1).map_or(source.len(), |next| next.span.start);
        let first = pieces.len();
        work.pieces(*raw, next, &mut pieces)?;
        while let Some(name) = names.next_if(|name| name.span.start < raw.span.end) {
            if let Some(piece) = pieces.get_mut(first) {
                piece.labels.push(Numbered { id: name.id, span: name.span });
            }
        }
    }
    if let Some(name) = names.next() {
        return Err(Fault::notes(name.span, format!("no display follows the name {}", name.id))
            .help("put the comment with the name before its display"));
    }
    work.numbers_inside(&mut pieces);
    Ok(work.join(pieces))
}

struct Work<'a> {
    source: &'a str,
    file: &'a Source,
    clean: Vec<u8>,
}

impl Work<'_> {
    /// The pieces of one display: one, or the row groups of an `align` with several numbers.
    fn pieces(&mut self, raw: RawDisplay, next: usize, pieces: &mut Vec<Piece>) -> Result<(), Fault> {
        // First, since the row ends before a text between rows.
        let (tags, labels) = self.tags(raw.body);
        let rows = self.rows(raw);
        let carries = |row: &Span| tags.iter().chain(&labels).any(|n| row.contains(n.span));
        if let Some(rows) = rows.filter(|_| tags.len() + labels.len() > 1)
            && rows.iter().filter(|row| carries(row)).take(2).count() == 2
        {
            let mut before: Option<Span> = None;
            for group in self.groups(rows, &tags, &labels) {
                let own = |all: &[Numbered]| all.iter().filter(|n| group.contains(n.span)).cloned().collect();
                // Its line is that of its first character.
                let start = tex_scanner::skip_space(&self.clean[..group.end], group.start).min(group.end);
                let group = Span::new(start, group.end);
                // A row that begins with a relation has its left side in the row before.
                let body = before.filter(|_| self.continues(group)).and_then(|row| self.last_member(row));
                let body = body.map_or(group, |member| member.to(group));
                let raw = RawDisplay { span: group, body, delimiter: Delimiter::Rows, is_numbered: false };
                before = Some(group);
                pieces.push(self.piece(raw, group.end, own(&tags), own(&labels))?);
            }
            return Ok(());
        }
        pieces.push(self.piece(raw, next, tags, labels)?);
        Ok(())
    }

    /// The rows of a display whose rows may be numbered one by one; also of an `align` that stands within `$$`.
    fn rows(&self, raw: RawDisplay) -> Option<Vec<Span>> {
        if raw.delimiter == Delimiter::Rows {
            return Some(rows::split(&self.clean, raw.body));
        }
        let inside = raw.body.start + self.source[raw.body.range()].find("\\begin{")?;
        if self.clean[raw.body.start..inside].iter().any(|b| !b.is_ascii_whitespace()) {
            return None;
        }
        let (name, start) = tex_scanner::begin(self.source, inside)?;
        let closing = format!("\\end{{{name}}}");
        let body = self.source[raw.body.range()].trim_end().strip_suffix(&closing)?;
        let end = raw.body.start + body.len();
        (tex_scanner::environment(name) == Some(Delimiter::Rows) && start <= end)
            .then(|| rows::split(&self.clean, Span::new(start, end)))
    }

    /// Rows, joined so that each group ends with the row that carries its number.
    fn groups(&self, rows: Vec<Span>, tags: &[Numbered], labels: &[Numbered]) -> Vec<Span> {
        let mut carriers: Vec<usize> = tags.iter().chain(labels).map(|n| n.span.start).collect();
        carriers.sort_unstable();
        let mut groups: Vec<Span> = Vec::new();
        let (mut closed, mut carrier) = (true, 0);
        for row in rows {
            let first = carrier;
            while carriers.get(carrier).is_some_and(|&at| at < row.end) {
                carrier += 1;
            }
            let numbered = carrier > first;
            match groups.last_mut() {
                Some(group) if !closed || (!numbered && self.continues(row)) => *group = group.to(row),
                _ => groups.push(row),
            }
            // A row that goes on after the number does not open its group again.
            closed = numbered || (closed && groups.last().is_some_and(|group| *group != row));
        }
        groups
    }

    fn continues(&self, span: Span) -> bool {
        // Whole characters only were overwritten, so the text is still UTF-8; where it is long, its start will do.
        let text = &self.clean[span.range()];
        let start = tex_scanner::skip_space(text, 0);
        rows::starts_with_relation(&String::from_utf8_lossy(&text[start..text.len().min(start + 80)]))
    }

    /// The last member of the chain in a row; a comma or a full stop after it is blanked, since the chain goes on.
    fn last_member(&mut self, row: Span) -> Option<Span> {
        let start = rows::last_relation_end(&self.clean, row)?;
        let end =
            (start..row.end).rev().find(|&at| !self.clean[at].is_ascii_whitespace() && self.clean[at] != b'\\')?;
        if matches!(self.clean[end], b',' | b'.' | b';') {
            self.clean[end] = b' ';
        }
        Some(Span::new(tex_scanner::skip_space(&self.clean[..row.end], start), row.end))
    }

    /// Takes tags and labels out of a body.
    fn tags(&mut self, body: Span) -> (Vec<Numbered>, Vec<Numbered>) {
        let (mut tags, mut labels) = (Vec::new(), Vec::new());
        let mut i = body.start;
        while i < body.end {
            if self.clean[i] != b'\\' {
                i += 1;
                continue;
            }
            let bytes = &self.clean[..body.end];
            let word = tex_scanner::word_end(bytes, i);
            let star = usize::from(bytes.get(word) == Some(&b'*'));
            let argument = tex_scanner::skip_space(bytes, word + star);
            let mut end = (word).max(i + 2);
            let command = &self.source[i + 1..word];
            match command {
                "tag" | "label" | "eqno" | "leqno" | "intertext" | "shortintertext" => {
                    let group = tex_scanner::short_group(bytes, argument);
                    let bare = || {
                        tex_scanner::number(self.source, argument)
                            .map(|(_, end)| end)
                            .filter(|_| command.ends_with("eqno"))
                    };
                    if let Some(close) = group.or_else(bare) {
                        let inside = self.source[argument + 1..close - 1].trim();
                        let id = inside.strip_prefix('(').and_then(|id| id.strip_suffix(')')).unwrap_or(inside);
                        let numbered = Numbered { id: id.trim().to_owned(), span: Span::new(i, close) };
                        match command {
                            "label" => labels.push(Numbered { id: inside.to_owned(), ..numbered }),
                            "tag" | "eqno" | "leqno" => tags.push(numbered),
                            _ => {}
                        }
                        blank(&mut self.clean, [&Span::new(i, close)]);
                        if command.ends_with("intertext") {
                            // LaTeX ends the row before the text, with or without a `\\` there.
                            self.clean[i..i + 2].copy_from_slice(b"\\\\");
                        }
                        end = close;
                    }
                }
                "nonumber" | "notag" => blank(&mut self.clean, [&Span::new(i, word)]),
                _ => {}
            }
            i = end;
        }
        (tags, labels)
    }

    fn piece(
        &mut self,
        raw: RawDisplay,
        next: usize,
        tags: Vec<Numbered>,
        labels: Vec<Numbered>,
    ) -> Result<Piece, Fault> {
        let mut tags = tags.into_iter();
        let mut piece = Piece {
            raw,
            body: raw.body,
            number: tags.next(),
            closes: false,
            labels,
            continues: self.continues(raw.body),
            bare: false,
            end: raw.span.end,
        };
        if let (Some(first), Some(second)) = (&piece.number, tags.next()) {
            return Err(Fault::notes(
                second.span,
                format!("the display ({}) has a second number, ({})", first.id, second.id),
            )
            .help("number rows one by one in an align environment, or give each equation its own display"));
        }
        if raw.delimiter == Delimiter::Pair {
            self.bare_number(&mut piece);
        }
        if piece.number.is_none() && raw.span != raw.body {
            self.number_after(&mut piece, next);
        }
        Ok(piece)
    }

    /// Records the number of a display that is only `(2.2)`.
    fn bare_number(&mut self, piece: &mut Piece) {
        let start = tex_scanner::skip_space(&self.clean[..piece.body.end], piece.body.start);
        let Some((id, end)) = tex_scanner::number(self.source, start).filter(|(_, end)| *end <= piece.body.end) else {
            return;
        };
        if piece.number.is_none() && self.clean[end..piece.body.end].iter().all(u8::is_ascii_whitespace) {
            let span = Span::new(start, end);
            piece.number = Some(Numbered { id: id.to_owned(), span });
            (piece.bare, piece.closes) = (true, true);
            blank(&mut self.clean, [&span]);
        }
    }

    /// A number printed after the display, with the inline tail that leads to it.
    fn number_after(&mut self, piece: &mut Piece, next: usize) {
        let after = piece.raw.span.end;
        let direct = tex_scanner::skip_space(&self.clean[..next], after);
        if let Some((label, end)) = self.label_at(direct) {
            blank(&mut self.clean, [&label.span]);
            piece.labels.push(label);
            piece.end = end;
            return;
        }
        if let Some(number) = self.number_ending_line(direct, next) {
            piece.end = number.span.end;
            piece.number = Some(number);
            piece.closes = true;
            return;
        }
        let Some((signs, number)) = self.tail(after, next) else { return };
        piece.end = number.span.end;
        piece.closes = true;
        if let Some(last) = signs.last() {
            blank(&mut self.clean, [&Span::new(piece.raw.body.end, after)]);
            for sign in &signs {
                self.clean[sign.at] = if sign.comma { b',' } else { b' ' };
            }
            piece.body.end = last.at;
        }
        piece.number = Some(number);
    }

    /// A label behind a display: `{#eq-energy}` of Quarto and pandoc, `(energy)` of MyST, at the end of its line.
    fn label_at(&self, at: usize) -> Option<(Numbered, usize)> {
        // A long line has displays behind this one, and no label at its end.
        const LONGEST: usize = 200;
        let bytes = self.source.as_bytes();
        let end = tex_scanner::line_end(&bytes[..bytes.len().min(at.saturating_add(LONGEST))], at);
        let line = self.source.get(at..end).filter(|_| bytes.get(end).is_none_or(|&b| b == b'\n'))?;
        let line = line.trim_end();
        let braced = line.strip_prefix("{#").and_then(|rest| rest.strip_suffix('}'));
        let braced = braced.map(|inside| inside.split_whitespace().next().unwrap_or_default());
        let bare =
            || line.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).filter(|id| !tex_scanner::is_number(id));
        let id = braced.or_else(bare)?;
        let is_word =
            !id.is_empty() && id.bytes().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'-' | b'_' | b':' | b'.'));
        let is_label = is_word && (braced.is_some() || id.bytes().any(|b| matches!(b, b'-' | b'_' | b':')));
        is_label.then(|| (Numbered { id: id.to_owned(), span: Span::new(at, at + line.len()) }, at + line.len()))
    }

    /// The number at `at`, when its line ends with it.
    fn number_ending_line(&self, at: usize, next: usize) -> Option<Numbered> {
        let (id, end) = tex_scanner::number(self.source, at)?;
        let alone = end <= next && tex_scanner::ends_line(&self.clean, end);
        alone.then(|| Numbered { id: id.to_owned(), span: Span::new(at, end) })
    }

    /// ` , $M = …$ (2.7)`: the dollar signs of a tail of inline formulas and punctuation, and the number it ends with.
    fn tail(&self, after: usize, next: usize) -> Option<(Vec<Sign>, Numbered)> {
        let bytes = &self.clean[..next];
        let mut signs = Vec::new();
        // Two formulas side by side are a product; a comma stands between statements.
        let (mut apart, mut lines) = (false, 0);
        let mut i = after;
        loop {
            match *bytes.get(i)? {
                b'\n' if lines == 0 => lines += 1,
                b' ' | b'\t' | b'\r' => {}
                b',' | b';' | b'.' => apart = true,
                b'$' => {
                    let close = tex_scanner::inline(bytes, i, false)?;
                    signs.push(Sign { at: i, comma: !apart });
                    signs.push(Sign { at: close, comma: false });
                    (apart, i) = (false, close);
                }
                b'(' => return Some((signs, self.number_ending_line(i, next)?)),
                _ => return None,
            }
            i += 1;
        }
    }

    /// Numbers that are printed inside of their displays.
    fn numbers_inside(&mut self, pieces: &mut [Piece]) {
        let number = |piece: &Piece| piece.number.as_ref().map(|number| number.id.clone());
        let displays: Vec<Body> = pieces.iter().map(|piece| Body { span: piece.body, number: number(piece) }).collect();
        for (i, numbered) in inner_numbers::find(self.source, &self.clean, &displays) {
            blank(&mut self.clean, [&numbered.span]);
            pieces[i].number = Some(numbered);
        }
    }

    /// Joins neighbouring displays, and extracts the texts.
    fn join(mut self, pieces: Vec<Piece>) -> Vec<Display> {
        let mut lines = Lines::default();
        let mut displays = Vec::new();
        let mut run: Vec<Piece> = Vec::new();
        for piece in pieces {
            if !run.last().is_some_and(|last| self.neighbours(last, &piece)) {
                self.close(&mut run, &mut lines, &mut displays);
            }
            run.push(piece);
        }
        self.close(&mut run, &mut lines, &mut displays);
        displays
    }

    /// Whether only white space is between two displays, and the second may belong to the first.
    fn neighbours(&self, a: &Piece, b: &Piece) -> bool {
        let gap = a.end..b.raw.span.start;
        a.number.is_none()
            && a.raw.delimiter == Delimiter::Pair
            && b.raw.delimiter == Delimiter::Pair
            && !b.labels.iter().any(|label| label.id.starts_with('#'))
            && self.clean[gap.clone()].iter().all(u8::is_ascii_whitespace)
            && self.source.as_bytes()[gap].iter().all(|b| b.is_ascii_whitespace() || *b == b'>')
    }

    /// Makes displays of a run of neighbours: one display, if a number is printed after the run.
    fn close(&mut self, run: &mut Vec<Piece>, lines: &mut Lines, displays: &mut Vec<Display>) {
        let all = run.last().is_some_and(|last| last.closes);
        let mut group: Vec<Piece> = Vec::new();
        for piece in run.drain(..) {
            if !group.is_empty() && !all && !piece.continues {
                displays.extend(self.display(std::mem::take(&mut group), lines));
            }
            group.push(piece);
        }
        displays.extend(self.display(group, lines));
    }

    fn display(&mut self, group: Vec<Piece>, lines: &mut Lines) -> Option<Display> {
        let (first, last) = (group.first()?, group.last()?);
        let span = Span::new(first.raw.span.start, last.raw.span.end.max(last.body.end));
        let mut body = first.body;
        let mut parts = vec![first.body];
        for piece in group.iter().skip(1).filter(|piece| !piece.bare) {
            // The closing delimiter before becomes the row break.
            self.clean[body.end..body.end + 2].copy_from_slice(b"\\\\");
            blank(&mut self.clean, [&Span::new(piece.raw.span.start, piece.raw.body.start)]);
            body = body.to(piece.body);
            parts.push(piece.body);
        }
        rows::mark_blank_lines(&mut self.clean, self.source, body);
        let text = String::from_utf8_lossy(&self.clean[body.range()]).into_owned();
        let number = group.iter().find_map(|piece| piece.number.clone());
        let numbers_rows = matches!(group.as_slice(), [only] if !only.closes && self.rows(only.raw).is_some());
        let labels: Vec<Numbered> = group.into_iter().flat_map(|piece| piece.labels).collect();
        // What held only definitions is no equation.
        if text.trim().is_empty() && number.is_none() && labels.is_empty() {
            return None;
        }
        let line = lines.line(self.file, span.start);
        Some(Display { span, body, parts, text, number, labels, automatic: Vec::new(), numbers_rows, line })
    }
}

/// A `$` in an inline tail, and whether it is to become a comma.
struct Sign {
    at: usize,
    comma: bool,
}

/// A counter of lines that goes on from the place before, so that all of them are found in linear time.
#[derive(Default)]
struct Lines {
    /// The file, as the address of its text.
    file: Option<*const u8>,
    at: usize,
    newlines: usize,
}

impl Lines {
    /// The line in its file of a byte of the view.
    fn line(&mut self, view: &Source, at: usize) -> usize {
        let place = view.place(Span::at(at));
        let (file, at) = (place.file.text.as_ptr(), place.span.start);
        if self.file != Some(file) || at < self.at {
            *self = Lines { file: Some(file), ..Lines::default() };
        }
        let between = place.file.text.as_bytes().get(self.at..at).unwrap_or_default();
        self.newlines += between.iter().filter(|&&b| b == b'\n').count();
        self.at = at;
        self.newlines + 1
    }
}
