//! Documents and claims files: what is found in them and where, and what is refused. Beside what must be read stands
//! its near twin that must not.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use onshell::Source;
use onshell::notes::claims::{Count, Expected, Holds, Property, Range, Role, Solved, Test, Turning};
use onshell::notes::json::{self, Value};
use onshell::notes::{Claims, Display, Kind, Notes, claims_beside};
use onshell::{Error, Result};

fn parse(text: &str, kind: Kind) -> Result<Notes> {
    let notes = Notes::parse(Arc::new(Source::new("notes", text)), kind)?;
    for display in &notes.equations {
        assert_eq!(display.text.len(), display.body.end - display.body.start, "text and body: {display:?}");
        assert!(display.span.contains(display.body), "body within span: {display:?}");
        assert!(display.parts.iter().all(|part| display.body.contains(*part)));
        let line = text[..display.span.start].matches('\n').count() + 1;
        assert_eq!(display.line, line);
        // Every byte that was not overwritten is the file's own.
        let own = text[display.body.range()].bytes();
        let kept = own.zip(display.text.bytes()).filter(|(a, b)| a != b).all(|(_, b)| b" \\,".contains(&b));
        assert!(kept, "{display:?}");
        if let Some(number) = &display.number {
            assert!(text[number.span.range()].contains(&number.id));
        }
    }
    Ok(notes)
}

fn md(text: &str) -> Vec<Display> {
    parse(text, Kind::Markdown).unwrap().equations
}

fn tex(text: &str) -> Vec<Display> {
    parse(text, Kind::Tex).unwrap().equations
}

fn number(display: &Display) -> &str {
    display.number.as_ref().map_or("", |number| &number.id)
}

fn numbers(displays: &[Display]) -> Vec<&str> {
    displays.iter().map(number).collect()
}

fn squeezed(display: &Display) -> String {
    display.text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn texts(displays: &[Display]) -> Vec<String> {
    displays.iter().map(squeezed).collect()
}

fn claims(text: &str) -> Result<Claims> {
    Claims::parse(Arc::new(Source::new("claims.json", text)), Path::new("dir/claims.json"))
}

/// The text that an error points at.
fn pointed(error: &Error) -> &str {
    let (source, span) = error.place().expect("a place");
    source.slice(span)
}

/// What is said of a claims file that is wrong, with the advice; and what it points at.
fn refused(text: &str) -> (String, String) {
    let error = claims(text).expect_err(text);
    assert!(error.place().is_some(), "{error}");
    (error.to_string(), pointed(&error).to_owned())
}

/// A claims file with `rest` in it.
fn with(rest: &str) -> String {
    format!("{{ \"notes\": \"top.md\", {rest} }}")
}

#[path = "notes/numbers.rs"]
mod numbers;

#[path = "notes/markdown.rs"]
mod markdown;

#[path = "notes/in_tex.rs"]
mod in_tex;

#[path = "notes/files.rs"]
mod files;

#[path = "notes/monsters.rs"]
mod monsters;

#[path = "notes/json_places.rs"]
mod json_places;

#[path = "notes/claims_files.rs"]
mod claims_files;

#[path = "notes/worlds.rs"]
mod worlds;

#[path = "notes/further_claims.rs"]
mod further_claims;

#[path = "notes/blank_lines.rs"]
mod blank_lines;

#[path = "notes/references.rs"]
mod references;

#[path = "notes/addresses.rs"]
mod addresses;
mod automatic;
