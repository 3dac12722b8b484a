//! The value of a function at an argument that is printed with its name: `x(t_1) = …` after `x(t) = …`, where the sentence before it
//! says what t_1 is.

use crate::check::document::inferred::prose::body_of;
use crate::check::unaided::course::Course;
use crate::check::unaided::course::special_values::Special;
use crate::check::unaided::inline;
use crate::formula::{Expr, Node, SymbolId, text};
use crate::latex::read_display;

impl Course<'_, '_> {
    /// The value of a function at the argument in a name, by the only formula for the function of one letter.
    pub(super) fn at_argument(&self, at: usize, name: SymbolId) -> Option<Special> {
        let (checker, model) = (self.checker, self.checker.model);
        let (function, argument) = applied(&model.name(name))?;
        let place = self.place_of_argument(at, &argument)?;
        let mut found = None;
        for before in (0..at).rev() {
            let display = &checker.notes.equations[before];
            for statement in checker.readings[before].statements.iter().flatten() {
                let [first, formula, ..] = statement.members.as_slice() else { continue };
                let Some((same, letter)) = display.text.get(first.span.range()).and_then(applied) else { continue };
                let Some(letter) = self.read(&letter).and_then(|letter| letter.as_plain_symbol()) else { continue };
                if same != function {
                    continue;
                }
                // A function with several formulas has each in another range.
                let is_everywhere = statement.branch.is_none() && statement.conditions.is_empty();
                if found.is_some() || !is_everywhere || display.text.contains(['<', '>']) {
                    return None;
                }
                found = Some((first, formula, letter));
            }
        }
        let (first, formula, letter) = found?;
        let mut value = self.written_out(formula, letter)?;
        if value.symbols().iter().all(|(id, _)| *id != letter) {
            return None;
        }
        value.substitute(&|node| match node {
            Node::Symbol { id, dots: 0, .. } if *id == letter => Some(place.clone()),
            _ => None,
        });
        let [first, place] = [first, &place].map(|formula| text::formula(formula, &model.symbols));
        let letter = text::plain(&model.name(letter));
        Some(Special { value, says: format!("{first} where {letter} = {place}") })
    }

    /// What an argument is: the formula that a sentence before a display gives it, or itself.
    fn place_of_argument(&self, at: usize, argument: &str) -> Option<Expr> {
        let notes = self.checker.notes;
        let display = &notes.equations[at];
        let printed = notes.equations[..at].iter().filter(|display| !inline::is_inline(notes, display));
        let start = printed.map(|display| display.span.start).filter(|before| *before < display.span.start).max();
        let near =
            notes.inline.iter().filter(|span| span.start >= start.unwrap_or(0) && span.end <= display.span.start);
        let said = near.rev().filter_map(|span| Some(notes.source.slice(body_of(notes, *span)?)));
        for text in said {
            let Some((left, right)) = text.split_once('=') else { continue };
            if bare(left) == argument && !right.contains('=') {
                return self.read(right);
            }
        }
        self.read(argument)
    }

    /// A formula whose names the displays have.
    fn read(&self, latex: &str) -> Option<Expr> {
        let model = self.checker.model;
        let mut symbols = model.symbols.clone();
        let reading = read_display(&format!("0 = {}", inline::as_displayed(latex)), &mut symbols, &model.macros);
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let formula = statement.members.get(1)?;
        let is_known = formula.symbols().iter().all(|(id, dots)| id.0 < model.symbols.len() && *dots == 0);
        is_known.then(|| formula.clone())
    }
}

/// The name and the argument of a function: x and t_1 of `x(t_1)`.
fn applied(text: &str) -> Option<(String, String)> {
    let bare = bare(text);
    let (function, argument) = bare.strip_suffix(')')?.split_once('(')?;
    let is_one = !function.is_empty() && !argument.is_empty() && !argument.contains(['(', ',', '=']);
    is_one.then(|| (function.to_owned(), argument.to_owned()))
}

/// A name without spaces and with plain indices.
fn bare(text: &str) -> String {
    let text = text.replace("\\left", "").replace("\\right", "").replace('&', "");
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    // `t_{1}` is `t_1`.
    let mut plain = String::new();
    let mut rest = text.as_str();
    while let Some(at) = rest.find("_{") {
        let (before, after) = (&rest[..at], &rest[at + 2..]);
        match after.split_once('}') {
            Some((index, more)) if index.chars().count() == 1 => {
                plain += &format!("{before}_{index}");
                rest = more;
            }
            _ => {
                plain += &format!("{before}_{{");
                rest = after;
            }
        }
    }
    plain + rest
}
