//! The lines of a display, as a reader sees them: each statement, and each row of a chain that runs over several rows.

#[cfg(feature = "cli")]
use std::collections::HashMap;

use crate::source::Span;

#[cfg(feature = "cli")]
use super::layout::Item;
use super::layout::typeset_items;
use super::macros::Macros;
use super::pieces::{Piece, pieces};
#[cfg(feature = "cli")]
use super::rows::rows;

#[cfg(feature = "cli")]
/// A line of a display. All places are bytes of its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// What is printed on this line.
    pub span: Span,
    /// The member on a line before it that this line continues.
    pub from: Option<Span>,
    /// Whether it has a relation, or says that something is constant.
    pub is_statement: bool,
}

#[cfg(feature = "cli")]
/// The lines of a display; none, if it cannot be typeset.
pub fn lines(text: &str, macros: &Macros) -> Vec<Line> {
    let Ok(items) = typeset_items(text, macros) else { return Vec::new() };
    let mut rows_of: HashMap<usize, usize> = HashMap::new();
    for (number, row) in rows(&items, false).iter().enumerate() {
        rows_of.extend(row.items.iter().map(|item| (item.span.start, number)));
    }
    let row = |at: usize| rows_of.get(&at).copied();
    let span = |items: &[&Item]| items.iter().map(|item| item.span).reduce(Span::to);
    let mut found = Vec::new();
    for piece in pieces(&items, false) {
        let is_statement = piece.links.len() > 1 || piece.constant.is_some();
        let mut current: Option<(Line, Option<usize>)> = None;
        let mut before: Option<Span> = None;
        for link in &piece.links {
            let member = span(&link.items);
            let place = link.relation.map(|(_, span)| span);
            let Some(own) = place.into_iter().chain(member).reduce(Span::to) else { continue };
            let here = row(own.start);
            match &mut current {
                Some((line, known)) if *known == here || here.is_none() || before.is_none() => {
                    line.span = line.span.to(own);
                }
                _ => {
                    found.extend(current.take().map(|(line, _)| line));
                    let from = before.filter(|_| place.is_some());
                    current = Some((Line { span: own, from, is_statement }, here));
                }
            }
            before = member.or(before);
        }
        if let (Some((line, _)), Some(constant)) = (&mut current, piece.constant) {
            line.span = line.span.to(constant);
        }
        found.extend(current.map(|(line, _)| line));
    }
    found
}

/// What may stand between two statements that are read one by one.
const BETWEEN: [&str; 22] = [
    "\\\\",
    "\\qquad",
    "\\quad",
    "\\nonumber",
    "\\notag",
    "\\hfill",
    "\\displaystyle",
    "\\text{and}",
    "\\text{ and }",
    "\\mbox{and}",
    "\\,",
    "\\;",
    "\\:",
    "\\!",
    "\\ ",
    "{}",
    "&",
    ",",
    ";",
    ".",
    "~",
    "*",
];

/// Arrows that say that the statement after them follows from the one before them.
const IMPLIES: [&str; 10] = [
    "\\Rightarrow",
    "\\implies",
    "\\Longrightarrow",
    "\\Leftrightarrow",
    "\\iff",
    "\\Longleftrightarrow",
    "\\therefore",
    "⇒",
    "⟹",
    "⇔",
];

/// Words that say the same.
const IMPLYING_WORDS: [&str; 4] = ["so", "hence", "thus", "therefore"];

/// The end of what says that a text follows from what stands before it, where the text begins with that.
pub fn implication(text: &str) -> Option<usize> {
    let rest = after_separators(text);
    let start = text.len() - rest.len();
    let words = ["\\text{", "\\mbox{", "\\textrm{"].iter().find_map(|command| rest.strip_prefix(command));
    if let Some((words, after)) = words.and_then(|words| words.split_once('}')) {
        let first = words.trim().trim_start_matches("and ").split([' ', ',', '~']).next().unwrap_or_default();
        return IMPLYING_WORDS.contains(&first).then_some(text.len() - after.len());
    }
    let mark = IMPLIES.iter().find(|mark| rest.starts_with(**mark))?;
    let end = start + mark.len();
    (!text[end..].starts_with(|c: char| c.is_ascii_alphabetic())).then_some(end)
}

/// The statements of a display, where each can be read without the others: the rows, and what stands on either side of an
/// arrow. In a display that has a number, the rows belong together.
pub fn apart(text: &str, macros: &Macros, has_number: bool) -> Option<Vec<Span>> {
    let items = typeset_items(text, macros).ok()?;
    let pieces = pieces(&items, false);
    let is_whole = |piece: &Piece<'_>| {
        let says = piece.links.len() > 1 && piece.links.iter().all(|link| !link.items.is_empty());
        piece.fault.is_none() && piece.conditions.is_empty() && piece.constant.is_none() && says
    };
    let divides = |gap: &str| {
        let implied = implication(gap).is_some_and(|end| after_separators(&gap[end..]).is_empty());
        implied || !has_number && gap.contains(r"\\") && after_separators(gap).is_empty()
    };
    let mut spans: Vec<Span> = Vec::new();
    for span in pieces.iter().map(Piece::span) {
        let gap = |last: &Span| text.get(last.end..span.start);
        match spans.last_mut() {
            // What stands beside a statement on its row often says what is meant by a letter in it.
            Some(last) if !gap(last).is_some_and(divides) => *last = last.to(span),
            _ => spans.push(span),
        }
    }
    (spans.len() > 1 && pieces.iter().all(is_whole)).then_some(spans)
}

/// A text without what separates statements and says nothing of its own, at its beginning.
fn after_separators(text: &str) -> &str {
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let length = rest.strip_prefix("[").and_then(|inner| inner.split_once(']')).filter(|(length, _)| {
            length.ends_with(|c: char| c.is_ascii_alphabetic())
                && length.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '.')
        });
        let Some(after) = BETWEEN.iter().find_map(|mark| rest.strip_prefix(mark)).or(length.map(|(_, after)| after))
        else {
            return rest;
        };
        rest = after.trim_start();
    }
    rest
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::*;

    fn texts(text: &str) -> Vec<String> {
        let of = |line: Line| {
            let whole = line.from.map_or(line.span, |from| from.to(line.span));
            text[whole.range()].to_owned()
        };
        lines(text, &Macros::default()).into_iter().map(of).collect()
    }

    #[test]
    fn each_statement_and_each_row_of_a_chain_is_a_line() {
        assert_eq!(texts("a = b = c"), ["a = b = c"]);
        assert_eq!(texts(r"a &= b \\ &= c \\ &= d = e"), ["a &= b", r"b \\ &= c", r"c \\ &= d = e"]);
        assert_eq!(texts(r"a = b, \quad c = d"), ["a = b", "c = d"]);
        assert_eq!(texts(r"a = b \implies c = d"), ["a = b", "c = d"]);
        assert_eq!(
            texts(r"\begin{aligned} a &= b + c \\ &\quad + d \\ e &= f \end{aligned}"),
            [r"a &= b + c \\ &\quad + d", "e &= f"]
        );
        assert_eq!(texts(r"a = b \text{ so } c = d"), ["a = b", "c = d"]);
    }
}
