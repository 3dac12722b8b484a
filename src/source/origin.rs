//! Where the text of a view stands in files, piece by piece.
//!
//! A view is what a document says as Markdown or TeX: the cells of a notebook without their JSON, a project without its
//! `\input`. Every piece of a view is a copy of a piece of a file, or was written for one. So every finding has a place in a
//! file, and an edit of the view is an edit of a file, or is refused.

use std::sync::Arc;

use super::{Source, Span};

/// How a file writes a text that the view has as LaTeX; none, where it cannot.
pub(crate) type Writing = fn(&str) -> Option<String>;

/// Where a view stands in files.
#[derive(Debug)]
pub(crate) struct Origin {
    pub files: Vec<Arc<Source>>,
    /// In order; each reaches to the next.
    pieces: Vec<Piece>,
    writing: Writing,
}

#[derive(Clone, Copy, Debug)]
struct Piece {
    /// The first byte in the view.
    start: usize,
    /// One past the last.
    end: usize,
    file: usize,
    place: Span,
    /// Whether it is a copy, byte for byte; else it was written for the whole place.
    is_copy: bool,
    /// Whether its place may be overwritten by what is written in its stead.
    is_whole: bool,
}

impl Origin {
    fn at(&self, offset: usize) -> Option<usize> {
        let after = self.pieces.partition_point(|piece| piece.start <= offset);
        after.checked_sub(1)
    }

    /// The file and the range in it.
    pub(super) fn place(&self, span: Span) -> Option<(&Source, Span)> {
        let first = self.pieces.get(self.at(span.start)?)?;
        let start = match first.is_copy {
            true => first.place.start + (span.start - first.start).min(first.place.end - first.place.start),
            false if span.start >= first.end => first.place.end,
            false => first.place.start,
        };
        let mut end = start;
        if span.end > span.start {
            let last = self.pieces.get(self.at(span.end - 1)?)?;
            if last.file == first.file {
                end = match last.is_copy {
                    true => last.place.start + (span.end - last.start).min(last.place.end - last.place.start),
                    false => last.place.end,
                };
            }
        }
        Some((&self.files[first.file], Span::new(start, end.max(start))))
    }

    /// The file, the range in it, and the text to put there.
    pub(super) fn edit(&self, span: Span, replacement: &str) -> Result<(&Source, Span, String), &'static str> {
        const ELSEWHERE: &str = "the text to edit is not in one piece in the file";
        let written = (self.writing)(replacement).ok_or("the file does not write this edit as LaTeX does")?;
        let touched = |piece: &&Piece| match span.start == span.end {
            // What is added stands behind what is before it.
            true => piece.start < span.start && span.start <= piece.end,
            false => piece.start < span.end && span.start < piece.end,
        };
        let mut touched: Vec<&Piece> = self.pieces.iter().filter(touched).collect();
        if touched.is_empty() && span.start == span.end {
            touched.extend(self.pieces.iter().find(|piece| piece.start == span.start));
        }
        let (Some(first), Some(last)) = (touched.first(), touched.last()) else { return Err(ELSEWHERE) };
        let joined =
            touched.windows(2).all(|pair| pair[0].file == pair[1].file && pair[0].place.end == pair[1].place.start);
        let is_part = |piece: &&Piece| {
            !piece.is_copy
                && !(piece.is_whole && span.start <= piece.start && piece.end <= span.end)
                && !(piece.is_whole && span.start == span.end && (span.start == piece.end || span.start == piece.start))
        };
        if !joined || touched.iter().any(is_part) {
            return Err(ELSEWHERE);
        }
        let at = |piece: &Piece, offset: usize| match piece.is_copy {
            true => piece.place.start + (offset - piece.start),
            false if offset >= piece.end => piece.place.end,
            false => piece.place.start,
        };
        let place = Span::new(at(first, span.start.max(first.start)), at(last, span.end.min(last.end)));
        Ok((&self.files[first.file], place, written))
    }
}

/// Makes a view, piece by piece.
pub(crate) struct Builder {
    text: String,
    files: Vec<Arc<Source>>,
    pieces: Vec<Piece>,
}

impl Builder {
    /// A view of one file, or of several of which this is the first.
    pub(crate) fn new(file: Arc<Source>) -> Self {
        Builder { text: String::new(), files: vec![file], pieces: Vec::new() }
    }

    /// One more file. Returns its number.
    pub(crate) fn add(&mut self, file: Arc<Source>) -> usize {
        self.files.push(file);
        self.files.len() - 1
    }

    /// The first file.
    pub(crate) fn file(&self) -> &Arc<Source> {
        &self.files[0]
    }

    /// A copy of a range of the first file.
    pub(crate) fn copy(&mut self, place: Span) {
        self.copy_of(0, place);
    }

    /// A copy of a range of a file.
    pub(crate) fn copy_of(&mut self, file: usize, place: Span) {
        let text = self.files[file].slice(place).to_owned();
        if let Some(last) = self.pieces.last_mut().filter(|p| p.is_copy && p.file == file && p.place.end == place.start)
        {
            last.place.end = place.end;
            last.end += text.len();
            self.text.push_str(&text);
        } else {
            self.piece(file, place, &text, true, true);
        }
    }

    /// A text that stands for a range of the first file, and may be replaced as a whole.
    pub(crate) fn whole(&mut self, place: Span, text: &str) {
        self.piece(0, place, text, false, true);
    }

    /// A text that stands at a range of the first file, and cannot be edited.
    pub(crate) fn written(&mut self, place: Span, text: &str) {
        self.piece(0, place, text, false, false);
    }

    /// A text that stands at a range of a file, and cannot be edited.
    pub(crate) fn written_for(&mut self, file: usize, place: Span, text: &str) {
        self.piece(file, place, text, false, false);
    }

    fn piece(&mut self, file: usize, place: Span, text: &str, is_copy: bool, is_whole: bool) {
        if text.is_empty() {
            return;
        }
        let start = self.text.len();
        self.text.push_str(text);
        self.pieces.push(Piece { start, end: self.text.len(), file, place, is_copy, is_whole });
    }

    /// A range of the first file in which what Markdown would take for markup is a space: prose of another format.
    pub(crate) fn prose(&mut self, place: Span) {
        let text = self.files[0].slice(place).to_owned();
        let mut from = 0;
        for (at, c) in text.char_indices().filter(|(_, c)| matches!(c, '$' | '\\' | '`' | '<' | '>')) {
            self.copy(Span::new(place.start + from, place.start + at));
            let end = at + c.len_utf8();
            self.written(Span::new(place.start + at, place.start + end), " ");
            from = end;
        }
        self.copy(Span::new(place.start + from, place.end));
    }

    /// The view. `writing` says how the files write an edit.
    pub(crate) fn finish(self, writing: Writing) -> Source {
        let path = self.files[0].path.clone();
        Source::view(path, self.text, Origin { files: self.files, pieces: self.pieces, writing })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_edits_of_a_view_are_those_of_its_file() {
        // `\\\\` in the file is `\\` in the view.
        let file = Arc::new(Source::new("n.ipynb", r#"["a\\b", "c"]"#));
        let mut view = Builder::new(file);
        view.copy(Span::new(2, 3));
        view.whole(Span::new(3, 5), "\\");
        view.whole(Span::new(5, 7), "\\");
        view.copy(Span::new(7, 8));
        view.written(Span::new(8, 12), "\n");
        view.copy(Span::new(12, 13));
        let view = view.finish(|text| Some(text.replace('\\', "\\\\")));
        assert_eq!(view.text, "a\\\\b\nc");
        assert_eq!(view.place(Span::new(1, 4)).span, Span::new(3, 8));
        assert_eq!(view.line_column(5), (1, 13));
        let edit = view.edit(Span::new(2, 4), "\\x").unwrap();
        assert_eq!((edit.place.span, edit.replacement.as_str()), (Span::new(5, 8), r"\\x"));
        assert_eq!(view.edit(Span::at(4), "z").unwrap().place.span, Span::at(8));
        // What reaches over the end of a JSON string cannot be edited.
        assert!(view.edit(Span::new(3, 6), "x").is_err());
    }
}
