//! Layout items as LaTeX again: what stands where no formula is expected, such as the label of a state or the limits of a
//! sum, is shown as it was printed.

use super::item::{Delimiter, Item, Layout};

/// The LaTeX of items. A space stands where two tokens would run into each other.
pub(crate) fn latex(items: &[Item]) -> String {
    let mut text = String::new();
    for item in items {
        let piece = one(item);
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

fn one(item: &Item) -> String {
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
                script.as_ref().map_or_else(String::new, |script| format!("{mark}{{{}}}", inside(script)))
            };
            format!("{}{}{}{}", one(nucleus), "'".repeat(usize::from(*primes)), script('_', sub), script('^', sup))
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
fn inside(item: &Item) -> String {
    match &item.layout {
        Layout::Group(items) => latex(items),
        _ => one(item),
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
