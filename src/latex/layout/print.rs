//! Layout items as LaTeX again: what stands where no formula is expected, such as the label of a state or the limits of a
//! sum, is shown as it was printed. A message quotes what it is about as the author typed it.

use super::item::{Delimiter, Item, Layout};

/// How items are written.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    /// Each thing in one way only: scripts in braces, and no spaces that print nothing.
    Normal,
    /// As people type it: `v^2` without braces, and a space where the author has one.
    Typed,
}

/// The LaTeX of items. A space stands where two tokens would run into each other.
pub(crate) fn latex(items: &[Item]) -> String {
    written(items, Form::Normal)
}

/// The LaTeX of items nearly as the author typed it, for a message.
pub(crate) fn typed(items: &[Item]) -> String {
    written(items, Form::Typed)
}

fn written(items: &[Item], form: Form) -> String {
    let mut text = String::new();
    let mut end = None;
    for item in items {
        if form == Form::Typed && end.is_some_and(|end| end < item.span.start) {
            text.push(' ');
        }
        end = Some(item.span.end);
        let piece = one(item, form);
        let letter_follows = piece.starts_with(|c: char| c.is_ascii_alphabetic());
        let ends_with_command = text
            .rfind('\\')
            .is_some_and(|at| at + 1 < text.len() && text[at + 1..].bytes().all(|b| b.is_ascii_alphabetic()));
        if letter_follows && ends_with_command {
            text.push(' ');
        }
        text.push_str(&piece);
    }
    text
}

fn one(item: &Item, form: Form) -> String {
    let latex = |items: &[Item]| written(items, form);
    let inside = |item: &Item| inside(item, form);
    match &item.layout {
        Layout::Letter(c) | Layout::Other(c) => c.to_string(),
        Layout::Number(digits) => digits.clone(),
        Layout::Command(name) | Layout::Value(name) => name.clone(),
        Layout::Space(_) => "\\,".to_owned(),
        Layout::Group(items) => format!("{{{}}}", latex(items)),
        Layout::Fence(delimiter, items) => {
            let (open, close) = pair(*delimiter);
            format!("{open}{}{close}", latex(items))
        }
        Layout::Scripts { nucleus, sub, sup, primes } => {
            let script = |mark: char, script: &Option<Box<Item>>| {
                let Some(script) = script else { return String::new() };
                let script = inside(script);
                let is_short = script.chars().count() == 1
                    || script.strip_prefix('\\').is_some_and(|name| name.bytes().all(|b| b.is_ascii_alphabetic()));
                match form == Form::Typed && is_short {
                    true => format!("{mark}{script}"),
                    false => format!("{mark}{{{script}}}"),
                }
            };
            format!(
                "{}{}{}{}",
                one(nucleus, form),
                "'".repeat(usize::from(*primes)),
                script('_', sub),
                script('^', sup)
            )
        }
        Layout::Fraction(above, below) => format!("\\frac{{{}}}{{{}}}", inside(above), inside(below)),
        Layout::Root(None, radicand) => format!("\\sqrt{{{}}}", inside(radicand)),
        Layout::Root(Some(index), radicand) => format!("\\sqrt[{}]{{{}}}", inside(index), inside(radicand)),
        Layout::Accent(command, inner) | Layout::Style(command, inner) => format!("{command}{{{}}}", inside(inner)),
        Layout::Unit(units) => latex(&units.plain),
        Layout::Text(word) => format!("\\text{{{word}}}"),
        Layout::Environment(name, rows) => {
            let row = |cells: &Vec<Vec<Item>>| cells.iter().map(|cell| latex(cell)).collect::<Vec<_>>().join(" & ");
            let rows: Vec<String> = rows.iter().map(row).collect();
            format!("\\begin{{{name}}} {} \\end{{{name}}}", rows.join(" \\\\ "))
        }
        Layout::Row => "\\\\".to_owned(),
        Layout::Align => "&".to_owned(),
        Layout::Rest(None) => "\\dots".to_owned(),
        Layout::Rest(Some(order)) => format!("O({})", latex(order)),
        Layout::Fault(_) => String::new(),
    }
}

/// Without the braces around it.
fn inside(item: &Item, form: Form) -> String {
    match &item.layout {
        Layout::Group(items) => written(items, form),
        _ => one(item, form),
    }
}

fn pair(delimiter: Delimiter) -> (&'static str, &'static str) {
    match delimiter {
        Delimiter::Round => ("(", ")"),
        Delimiter::Square => ("[", "]"),
        Delimiter::Curly => ("\\{", "\\}"),
        Delimiter::Bar | Delimiter::PlainBar => ("|", "|"),
        Delimiter::DoubleBar => ("\\|", "\\|"),
        Delimiter::Angle => ("\\langle ", "\\rangle"),
        Delimiter::Evaluation => ("\\left.", "\\right|"),
        Delimiter::Ket => ("|", "\\rangle"),
        Delimiter::Bra => ("\\langle ", "|"),
        Delimiter::RightOpen => ("[", ")"),
        Delimiter::LeftOpen => ("(", "]"),
    }
}
