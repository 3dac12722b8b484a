//! Jupyter notebooks: the Markdown cells, without their JSON.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use serde_json::value::RawValue;

use super::{Format, View, alone};
use crate::code::Code;
use crate::notes::kind::Kind;
use crate::source::{Builder, Fault, Source, Span};
use crate::{Error, Result};

pub(super) const FORMAT: Format = Format { extensions: &["ipynb"], kind: Kind::Markdown, is_code: false, view };

/// A JSON object whose values keep their places.
type Object<'a> = HashMap<String, &'a RawValue>;

fn view(file: &Arc<Source>, _: &Path) -> Result<View> {
    let text = file.text.trim_start_matches('\u{feff}');
    let failed = |error: &serde_json::Error| {
        let before: usize = file.text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
        let mut at = (before + error.column().saturating_sub(1)).min(file.text.len());
        while !file.text.is_char_boundary(at) {
            at -= 1;
        }
        let why = match error.is_eof() {
            true => "the file ends in the middle of a value".to_owned(),
            false => error.to_string().split(" at line ").next().unwrap_or_default().to_owned(),
        };
        let at = if error.is_eof() { file.text.trim_end().len() } else { at };
        let fault = Fault::notes(Span::at(at), format!("this is not a notebook: {why}")).code(Code::Json);
        Error::fault(file, fault.help("a notebook is JSON with a list of `cells`"))
    };
    let place = |raw: &RawValue| raw.get().as_ptr() as usize - file.text.as_ptr() as usize;
    let notebook: Object<'_> = serde_json::from_str(text).map_err(|error| failed(&error))?;
    let cells = notebook
        .get("cells")
        .ok_or_else(|| Error::fault(file, Fault::notes(Span::at(0), "this is not a notebook: it has no `cells`")))?;
    let cells: Vec<Object<'_>> = serde_json::from_str(cells.get()).map_err(|error| {
        Error::fault(file, Fault::notes(Span::at(place(cells)), format!("the cells cannot be read: {error}")))
    })?;
    let mut view = Builder::new(file.clone());
    for cell in cells.iter().filter(|cell| cell.get("cell_type").is_some_and(|kind| kind.get() == "\"markdown\"")) {
        let Some(source) = cell.get("source") else { continue };
        let raw = source.get();
        if raw.starts_with('"') {
            string(&mut view, raw, place(source));
        } else {
            let lines: Vec<&RawValue> = serde_json::from_str(raw).map_err(|error| failed(&error))?;
            lines
                .iter()
                .filter(|line| line.get().starts_with('"'))
                .for_each(|line| string(&mut view, line.get(), place(line)));
        }
        view.written(Span::at(place(source) + raw.len()), "\n\n");
    }
    alone(view.finish(|text| {
        let quoted = serde_json::to_string(text).ok()?;
        Some(quoted[1..quoted.len() - 1].to_owned())
    }))
}

/// The text of a JSON string that stands at `at`.
fn string(view: &mut Builder, raw: &str, at: usize) {
    let inside = raw.len() - 1;
    let (mut from, mut i) = (1, 1);
    while let Some(next) = raw[i..inside].find('\\') {
        i += next;
        view.copy(Span::new(at + from, at + i));
        let mut end = i + if raw[i..].starts_with("\\u") { 6 } else { 2 };
        // A character beyond the first 65536 is two escapes.
        let mut decoded = serde_json::from_str::<String>(&format!("\"{}\"", &raw[i..end]));
        if decoded.is_err() && raw.get(end + 6..).is_some() {
            end += 6;
            decoded = serde_json::from_str(&format!("\"{}\"", &raw[i..end]));
        }
        view.whole(Span::new(at + i, at + end), &decoded.unwrap_or_else(|_| "?".to_owned()));
        (from, i) = (end, end);
    }
    view.copy(Span::new(at + from, at + inside));
}
