//! The walker that collects edits; each file of this folder adds the edits of one kind of part to it.

use crate::formula::Symbols;
use crate::source::Span;

use super::super::layout::{Item, Layout};
use super::edit::{Edit, Slip, bold};
use super::pool::Pool;

/// The walker over the layout that collects edits.
pub(super) struct Finder<'a> {
    pub text: &'a str,
    pub symbols: &'a Symbols,
    /// The factors and terms to insert; `None` where slips are made, not corrected.
    pub pool: Option<&'a Pool>,
    pub edits: Vec<Edit>,
}

impl<'a> Finder<'a> {
    /// A finder that has found nothing.
    pub fn new(text: &'a str, symbols: &'a Symbols, pool: Option<&'a Pool>) -> Self {
        Finder { text, symbols, pool, edits: Vec::new() }
    }
}

impl Finder<'_> {
    /// The text at a span; empty where a macro changed the order of its bytes.
    pub(super) fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// Adds an edit, unless it would give a base two equal scripts. A space separates a command from a letter after
    /// it, and a bar from a bar, which side by side are the bar of a norm.
    pub(super) fn edit(&mut self, slip: Slip, span: Span, replacement: impl Into<String>) {
        let mut replacement = bold(replacement.into());
        if self.text.get(span.range()).is_none() {
            return;
        }
        let (before, after) = (&self.text[..span.start], &self.text[span.end..]);
        if last_script(&replacement).is_some_and(|script| after.trim_start().starts_with(script)) {
            return;
        }
        let letter = |text: &str| text.starts_with(|c: char| c.is_ascii_alphabetic());
        if ends_in_command(&replacement) && letter(after) {
            replacement.push(' ');
        }
        let are_bars = |left: &str, right: &str| left.ends_with('|') && right.starts_with('|');
        if are_bars(&replacement, after) {
            replacement.push(' ');
        }
        match replacement.is_empty() {
            true if ends_in_command(before) && letter(after) || are_bars(before, after) => replacement.push(' '),
            false if ends_in_command(before) && letter(&replacement) || are_bars(before, &replacement) => {
                replacement.insert(0, ' ');
            }
            _ => {}
        }
        self.edits.push(Edit { span, replacement, slip });
    }

    /// The inner item, unless it comes from the same macro call as the outer one.
    pub(super) fn inside<'i>(&self, item: &Item, inner: &'i Item) -> Option<&'i Item> {
        (inner.span != item.span && item.span.contains(inner.span)).then_some(inner)
    }

    /// Collects the edits of a command's argument: a list in braces, or one item.
    pub(super) fn argument(&mut self, item: &Item, argument: &Item) {
        let Some(argument) = self.inside(item, argument) else { return };
        match &argument.layout {
            Layout::Group(items) => self.list(items),
            _ => self.item(argument),
        }
    }
}

/// The `_` or `^` of the script that a formula ends with.
pub(super) fn last_script(formula: &str) -> Option<char> {
    let formula = formula.trim_end();
    let script = match formula.ends_with('}') {
        true => {
            let mut depth = 0;
            let opens = |c: char| {
                depth += i32::from(c == '}') - i32::from(c == '{');
                depth == 0
            };
            &formula[..formula.rfind(opens)?]
        }
        false => formula.strip_suffix(|_: char| true)?,
    };
    script.chars().next_back().filter(|c| matches!(c, '_' | '^'))
}

/// Whether a text ends in the letters of a command.
pub(super) fn ends_in_command(text: &str) -> bool {
    let word = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    word.len() < text.len() && word.ends_with('\\') && !word.ends_with("\\\\")
}
