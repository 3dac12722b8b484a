//! Org: LaTeX in text, without blocks of code and comments.

use std::path::Path;
use std::sync::Arc;

use super::blocks::{self, trimmed};
use super::{Format, View, alone};
use crate::Result;
use crate::notes::kind::Kind;
use crate::source::{Builder, Source, Span};

pub(super) const FORMAT: Format = Format { extensions: &["org"], kind: Kind::Markdown, is_code: false, view };

fn view(file: &Arc<Source>, _: &Path) -> Result<View> {
    let text = &file.text;
    let mut view = Builder::new(file.clone());
    // The word that ends the block which is not read.
    let mut until: Option<String> = None;
    for line in blocks::lines(text, Span::new(0, text.len())) {
        let own = trimmed(text, line);
        let words = &text[own.range()];
        let lower = words.to_ascii_lowercase();
        if let Some(end) = &until {
            if lower.starts_with(end) {
                until = None;
            }
        } else if let Some(block) =
            ["src", "example", "comment", "export html"].iter().find(|b| lower.starts_with(&format!("#+begin_{b}")))
        {
            until = Some(format!("#+end_{}", block.split(' ').next().unwrap_or(block)));
        } else if lower.starts_with("#+latex_header:") || lower.starts_with("#+latex:") {
            let colon = words.find(':').map_or(0, |at| at + 1);
            view.copy(trimmed(text, Span::new(own.start + colon, own.end)));
        } else if !(words.starts_with("# ") || words == "#" || words.starts_with(": ") || words.starts_with("#+")) {
            // A heading has a star for each level.
            let mut from = own.start;
            if let Some((level, length)) = blocks::marked_heading(words, '*').filter(|_| own.start == line.start) {
                from += length;
                blocks::heading(&mut view, Span::new(own.start, from), level);
            }
            // `=code=` and `~code~` hold no displays; a grave accent and `<` are plain characters here.
            let starts = words.char_indices().filter(|(at, c)| *c == '`' && own.start + at >= from);
            for (at, c) in starts.collect::<Vec<_>>() {
                view.copy(Span::new(from, own.start + at));
                view.written(Span::new(own.start + at, own.start + at + c.len_utf8()), " ");
                from = own.start + at + c.len_utf8();
            }
            view.copy(Span::new(from, own.end));
        }
        view.written(Span::at(line.end), "\n");
    }
    alone(view.finish(blocks::as_latex))
}
