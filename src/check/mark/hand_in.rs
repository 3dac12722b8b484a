//! The marks of one hand-in.

use std::path::Path;
use std::sync::Arc;

use crate::notes::Notes;
use crate::notes::document::Kind;
use crate::source::Source;

use crate::check::document::setup::Run;

use super::marked::Marked;
use super::problem::Problem;
use super::{credit, letters};

impl Problem {
    /// Marks a hand-in, known as `path`.
    pub fn mark(&self, run: &Run<'_>, path: &Path, text: &str) -> Marked {
        let shown_as = path.display().to_string();
        let student = path.file_stem().map_or_else(|| shown_as.clone(), |stem| stem.to_string_lossy().into_owned());
        let kind = Kind::of(path).unwrap_or(Kind::Markdown);
        let text = text.trim_start_matches('\u{feff}');
        let text = if kind == Kind::Tex { text.to_owned() } else { close_dollars(text) };
        let source = Arc::new(Source::new(shown_as, text));
        let mut marked = Marked {
            student,
            source: source.clone(),
            letters: Vec::new(),
            lines: Vec::new(),
            results: Vec::new(),
            fault: None,
        };
        let found = Notes::parse(source, kind).and_then(|notes| letters::best(run, self, &notes));
        match found {
            Ok((judged, letters)) => {
                marked.letters = letters;
                (marked.lines, marked.results) = credit::given(self, judged);
            }
            Err(error) => {
                marked.fault = Some(error.message().to_owned());
                marked.results = credit::nothing(self);
            }
        }
        marked
    }
}

/// A text in which `$ x = 1 $` is ` $x = 1$ `: Markdown reads no formula where a space stands behind the dollar sign, and
/// students write one. Only what has a relation counts, so that two prices are no formula.
fn close_dollars(text: &str) -> String {
    let close = |line: &str| {
        if line.contains("$$") || line.contains('`') || !line.contains("$ ") {
            return line.to_owned();
        }
        let pieces: Vec<&str> = line.split('$').collect();
        let is_paired = pieces.len() % 2 == 1;
        let moved = pieces.iter().enumerate().map(|(at, piece)| {
            let inside = piece.trim_matches(' ');
            let is_formula = at % 2 == 1 && inside.contains(['=', '<', '>', '\\']) && !inside.is_empty();
            match is_formula && is_paired {
                true => {
                    let before = piece.len() - piece.trim_start_matches(' ').len();
                    let after = piece.len() - before - inside.len();
                    format!("{}${inside}${}", " ".repeat(before), " ".repeat(after))
                }
                false if at % 2 == 1 => format!("${piece}$"),
                false => (*piece).to_owned(),
            }
        });
        if is_paired { moved.collect::<String>() } else { line.to_owned() }
    };
    text.split_inclusive('\n').map(close).collect()
}

#[cfg(test)]
mod tests {
    use super::close_dollars;

    #[test]
    fn a_space_behind_a_dollar_sign_is_put_before_it() {
        assert_eq!(close_dollars("so $ a = b $, and $c = d$\n"), "so  $a = b$ , and $c = d$\n");
        // The twins: prices, a display, code.
        for text in ["$ 5 and $ 6", "$$ a = b $$", "`$ a = b $`", "a $ b = c"] {
            assert_eq!(close_dollars(text), text);
        }
    }
}
