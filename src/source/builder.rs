//! The making of a view, piece by piece.

use std::sync::Arc;

use super::Span;
use super::origin::{Origin, Piece, Writing};
use super::text::Source;

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
        Source::view(path, self.text, self.files, Origin { pieces: self.pieces, writing })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_edits_of_a_view_are_those_of_its_file() {
        // `\\` in the file is `\` in the view.
        let file = Arc::new(Source::new("n.ipynb", r#"["a\\\\b", "c"]"#));
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
