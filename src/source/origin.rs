//! Where the text of a view stands in files, piece by piece.
//!
//! A view is what a document says as Markdown or TeX: the cells of a notebook without their JSON, a project without its
//! `\input`. Every piece of a view is a copy of a piece of a file, or was written for one. So every finding has a place in a
//! file, and an edit of the view is an edit of a file, or is refused.

use super::Span;

/// How a file writes a text that the view has as LaTeX; none, where it cannot.
pub(crate) type Writing = fn(&str) -> Option<String>;

/// Where a view stands in files.
#[derive(Debug)]
pub(super) struct Origin {
    /// In order; each reaches to the next.
    pub(super) pieces: Vec<Piece>,
    pub(super) writing: Writing,
}

/// A piece of a view, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// The first byte in the view.
    pub start: usize,
    /// One past the last.
    pub end: usize,
    /// The number of the file.
    pub file: usize,
    /// The range in it.
    pub place: Span,
    /// Whether it is a copy, byte for byte; else it was written for the whole place.
    pub is_copy: bool,
    /// Whether its place may be overwritten by what is written in its stead.
    pub is_whole: bool,
}

impl Origin {
    fn at(&self, offset: usize) -> Option<usize> {
        let after = self.pieces.partition_point(|piece| piece.start <= offset);
        after.checked_sub(1)
    }

    /// The number of the file, and the range in it.
    pub(super) fn place(&self, span: Span) -> Option<(usize, Span)> {
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
        Some((first.file, Span::new(start, end.max(start))))
    }

    /// The number of the file, the range in it, and the text to put there.
    pub(super) fn edit(&self, span: Span, replacement: &str) -> Result<(usize, Span, String), &'static str> {
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
            !(piece.is_copy || piece.is_whole && span.start <= piece.start && piece.end <= span.end)
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
        Ok((first.file, place, written))
    }
}
