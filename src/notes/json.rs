//! JSON values with their places in the text.
//!
//! serde_json reads the text. Its raw values borrow from the text, so their places follow from their addresses.
//! Some valid JSON is rejected here: a key given twice, a `"\theta"`, which JSON reads as a tab and "heta", and
//! deep nesting.
//!
//! # Why there is a layer over `RawValue`
//!
//! serde_json keeps no places. Its raw values borrow from the text, so each value's address gives its place. The
//! layer also rejects what JSON would accept without notice: a key given twice, a `"\theta"` that became a tab and
//! "heta", endless nesting.

use std::collections::HashMap;
use std::fmt;

use serde::de::{MapAccess, Visitor};
use serde_json::value::RawValue;

use crate::code::Code;
use crate::source::{Fault, Span};

/// The most levels of nesting.
const DEEPEST: usize = 64;

/// The most bytes of a key and of an address.
pub(super) const LONGEST: usize = 4096;

/// A value and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Its place in the file; for a JSON string, with the quotes.
    pub span: Span,
}

impl<T> Spanned<T> {
    /// `value` at `span`.
    pub fn new(value: T, span: Span) -> Self {
        Spanned { value, span }
    }

    /// Another value at the same place.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Spanned<U> {
        Spanned { value: f(self.value), span: self.span }
    }
}

/// A JSON value and its place.
pub type Json = Spanned<Value>;

/// A JSON value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// `null`
    Null,
    /// `true` or `false`
    Bool(bool),
    /// A number, as it is written.
    Number(String),
    /// A string, unescaped.
    String(String),
    /// `[…]`
    Array(Vec<Json>),
    /// `{…}`, in the order of the file; no key comes twice.
    Object(Vec<(Spanned<String>, Json)>),
}

impl Value {
    /// The name of its kind in messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Value::Null => "null",
            Value::Bool(_) => "true or false",
            Value::Number(_) => "a number",
            Value::String(_) => "a string",
            Value::Array(_) => "a list",
            Value::Object(_) => "an object",
        }
    }
}

/// Reads one JSON value, which must be the whole of `text`. A byte-order mark before it is ignored.
///
/// # Errors
/// Faults of the class [`Code::Json`] at their places.
pub fn read(text: &str) -> Result<Json, Fault> {
    let start = text.len() - text.trim_start_matches('\u{feff}').len();
    if text[start..].trim().is_empty() {
        return Err(invalid(Span::at(text.len()), "the file is empty").help("a claims file is a JSON object: { … }"));
    }
    escapes(text)?;
    let raw = serde_json::from_str::<&RawValue>(&text[start..]).map_err(|error| syntax(text, start, &error))?;
    value(text, raw, 0)
}

/// The place in the file of the bytes `part` of a string whose token, or a part of it, is at `token`.
///
/// An escape such as `\\` is two bytes in the file and one in the string.
pub fn place_in_string(text: &str, token: Span, part: Span) -> Span {
    let Some(raw) = text.get(token.range()) else { return token };
    let quoted = raw.starts_with('"');
    let (mut at, mut read) = (usize::from(quoted), 0);
    let mut start = None;
    while read < part.end && at < raw.len() {
        if read >= part.start && start.is_none() {
            start = Some(at);
        }
        let (length, bytes) = escape_at(&raw[at..]);
        at += length;
        read += bytes;
    }
    let start = start.unwrap_or(at);
    Span::new(token.start + start, token.start + at)
}

/// The first character of the inside of a JSON string: its bytes in the file, and its bytes in the string.
fn escape_at(raw: &str) -> (usize, usize) {
    let mut chars = raw.chars();
    match (chars.next(), chars.next()) {
        (Some('\\'), Some('u')) => {
            let unit = |at: usize| raw.get(at..at + 4).and_then(|hex| u32::from_str_radix(hex, 16).ok());
            match unit(2) {
                Some(0xD800..0xDC00) => (12.min(raw.len()), 4),
                Some(code) => (6.min(raw.len()), char::from_u32(code).map_or(1, char::len_utf8)),
                None => (2, 1),
            }
        }
        (Some('\\'), Some(c)) => (1 + c.len_utf8(), 1),
        (Some(c), _) => (c.len_utf8(), c.len_utf8()),
        (None, _) => (1, 0),
    }
}

/// A fault of the class [`Code::Json`].
fn invalid(span: Span, message: impl Into<String>) -> Fault {
    Fault::new(span, message).code(Code::Json)
}

/// Rejects escapes that LaTeX in JSON is often misread by.
fn escapes(text: &str) -> Result<(), Fault> {
    let bytes = text.as_bytes();
    let (mut i, mut within) = (0, false);
    while i < bytes.len() {
        match bytes[i] {
            b'"' => within = !within,
            b'\\' if within => {
                escape(text, i)?;
                i += 1;
            }
            _ => {}
        }
        i += 1;
    }
    Ok(())
}

fn escape(text: &str, at: usize) -> Result<(), Fault> {
    let Some(letter) = text[at + 1..].chars().next() else { return Ok(()) };
    let word: String = text[at + 1..].chars().take_while(char::is_ascii_alphabetic).take(40).collect();
    let word = if word.is_empty() { letter.to_string() } else { word };
    let span = Span::new(at, at + 1 + word.len());
    let name = match letter {
        '"' | '\\' | '/' => return Ok(()),
        't' => "a tab",
        'n' => "a line break",
        'b' => "a backspace",
        'f' => "a form feed",
        'r' => "a carriage return",
        'u' => {
            let code = text.get(at + 2..at + 6).and_then(|hex| u32::from_str_radix(hex, 16).ok());
            return match code {
                Some(code) if code >= 0x20 => Ok(()),
                Some(_) => Err(invalid(Span::new(at, at + 6), "this string contains a control character")
                    .help("remove it; LaTeX does not need it")),
                None => Err(no_escape(span, &word)),
            };
        }
        _ => return Err(no_escape(span, &word)),
    };
    let message = format!("JSON reads the \"\\{letter}\" of \"\\{word}\" as {name}");
    Err(invalid(span, message).help(format!("write \"\\\\{word}\"")))
}

fn no_escape(span: Span, word: &str) -> Fault {
    invalid(span, format!("\"\\{word}\" is not an escape of JSON")).help(format!("write \"\\\\{word}\""))
}

/// The fault for an error of serde_json, at its place.
fn syntax(text: &str, start: usize, error: &serde_json::Error) -> Fault {
    let offset = offset(&text[start..], error.line(), error.column()) + start;
    let full = error.to_string();
    let message = full.split(" at line ").next().unwrap_or(&full);
    if error.is_eof() {
        let end = text.trim_end().len();
        return invalid(Span::at(end), "the file ends in the middle of a value")
            .help("close each string with `\"`, each list with `]` and each object with `}`");
    }
    let mut end = (offset + 1).min(text.len());
    while !text.is_char_boundary(end) {
        end += 1;
    }
    let span = Span::new(offset, end);
    let after_comma = text[..offset].trim_end().ends_with(',') && text[offset..].starts_with(['}', ']']);
    match message {
        _ if after_comma => invalid(span, "a comma stands before the closing bracket").help("remove the comma"),
        "trailing characters" => invalid(span, "text follows the end of the JSON value")
            .help("a claims file is one object; look for a `}` that closes it too early"),
        "control character (\\u0000-\\u001F) found while parsing a string" => {
            invalid(span, "this string contains a line break or another control character")
                .help("write the string on one line; its closing `\"` may be missing")
        }
        _ if text[offset..].starts_with("//") || text[offset..].starts_with("/*") => {
            invalid(span, "this is not JSON: JSON has no comments")
                .help("write the reason under \"because\", or remove the comment")
        }
        _ if text[offset..].starts_with('\'') => {
            invalid(span, "this is not JSON: texts in JSON stand between double quotation marks")
                .help("write \" in place of '")
        }
        _ if !text.trim_start().starts_with('{') => {
            invalid(span, "this file is not JSON, so it is no claims file").help("a claims file begins with {")
        }
        _ => invalid(span, format!("this is not JSON: {message}"))
            .help("look for a missing comma, quotation mark or bracket before this place"),
    }
}

/// The byte that serde_json's line and column (in bytes, from 1) point at.
fn offset(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let mut offset = (before + column.saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

fn value(text: &str, raw: &RawValue, depth: usize) -> Result<Json, Fault> {
    let span = place(text, raw);
    let token = raw.get();
    let unreadable = |error: serde_json::Error| {
        let full = error.to_string();
        invalid(span, format!("this is not JSON: {}", full.split(" at line ").next().unwrap_or(&full)))
    };
    if depth >= DEEPEST && token.starts_with(['[', '{']) {
        return Err(invalid(
            Span::new(span.start, span.start + 1),
            format!("values are nested more than {DEEPEST} levels deep"),
        )
        .help("a claims file needs five levels"));
    }
    let value = match token.as_bytes().first() {
        Some(b'n') => Value::Null,
        Some(b't') => Value::Bool(true),
        Some(b'f') => Value::Bool(false),
        Some(b'"') => Value::String(serde_json::from_str(token).map_err(unreadable)?),
        Some(b'[') => {
            let items: Vec<&RawValue> = serde_json::from_str(token).map_err(unreadable)?;
            Value::Array(items.into_iter().map(|item| value(text, item, depth + 1)).collect::<Result<_, _>>()?)
        }
        Some(b'{') => {
            let Entries(entries) = serde_json::from_str(token).map_err(unreadable)?;
            Value::Object(object(text, entries, depth)?)
        }
        _ => Value::Number(token.to_owned()),
    };
    Ok(Json { value, span })
}

fn object(
    text: &str,
    entries: Vec<(&RawValue, &RawValue)>,
    depth: usize,
) -> Result<Vec<(Spanned<String>, Json)>, Fault> {
    let mut seen: HashMap<String, Span> = HashMap::new();
    let mut object = Vec::with_capacity(entries.len());
    for (key, item) in entries {
        let span = place(text, key);
        let name: String =
            serde_json::from_str(key.get()).map_err(|_| invalid(span, "this key is not a valid text"))?;
        if name.len() > LONGEST {
            let message = format!("this key has {} bytes; the limit is {LONGEST}", name.len());
            return Err(invalid(span, message));
        }
        if let Some(first) = seen.insert(name.clone(), span) {
            let line = text[..first.start].matches('\n').count() + 1;
            return Err(invalid(span, format!("the key \"{name}\" is given twice; first in line {line}"))
                .help("join the two entries; JSON would keep only the last one"));
        }
        object.push((Spanned::new(name, span), value(text, item, depth + 1)?));
    }
    Ok(object)
}

/// The place of a raw value, which borrows from `text`.
fn place(text: &str, raw: &RawValue) -> Span {
    let start = raw.get().as_ptr() as usize - text.as_ptr() as usize;
    Span::new(start, start + raw.get().len())
}

/// The entries of an object, in order, duplicates kept.
struct Entries<'a>(Vec<(&'a RawValue, &'a RawValue)>);

impl<'de> serde::Deserialize<'de> for Entries<'de> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(EntriesVisitor)
    }
}

struct EntriesVisitor;

impl<'de> Visitor<'de> for EntriesVisitor {
    type Value = Entries<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry::<&RawValue, &RawValue>()? {
            entries.push(entry);
        }
        Ok(Entries(entries))
    }
}
