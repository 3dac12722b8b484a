//! `cases`: a value for each condition; and the conditions that stand after a statement.

use crate::formula::tree::{Branch, Condition, Expr, Node, Relation};
use crate::formula::units::Unit;
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::lexer::Space;
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// The rows of `cases`: a value, and behind `&` or a wide space its condition.
    pub(in super::super) fn cases(&mut self, rows: &[Vec<Vec<Item>>], span: Span) -> Read<Expr> {
        let mut branches = Vec::new();
        for row in rows {
            let cells: Vec<&[Item]> = row.iter().map(Vec::as_slice).filter(|cell| !trimmed(cell).is_empty()).collect();
            let (value, condition) = match cells.as_slice() {
                [] => continue,
                [only] => split_row(only).ok_or_else(|| no_condition(only, span))?,
                [value, condition] => (*value, *condition),
                _ => {
                    return Err(Fault::unsupported(span, "cases with more than two columns are not supported")
                        .help("write each row as a value, one & and its condition"));
                }
            };
            let place = value.first().map_or(span, |item| item.span);
            let value = self.sum(trimmed(value), place)?;
            let condition = trimmed(condition);
            let conditions = match self.condition(condition, place) {
                // `x < 1 \text{ high field}`: words are no factor of the bound.
                Ok(Stated::Holds(_)) if self.is_abstract() && ends_with_words(condition) => {
                    vec![self.unread_condition(condition, place)]
                }
                Ok(Stated::Otherwise) => Vec::new(),
                Ok(Stated::Holds(conditions)) => conditions,
                // A word such as “boson” is shown.
                Err(_) if self.is_abstract() => vec![self.unread_condition(condition, place)],
                Err(fault) => return Err(fault),
            };
            branches.push(Branch { value, conditions });
        }
        let last = branches.len().saturating_sub(1);
        if branches.iter().take(last).any(|branch| branch.conditions.is_empty()) {
            return Err(Fault::new(span, "“otherwise” must be the last of the cases").help("move this row to the end"));
        }
        match branches.len() {
            0 => Err(Fault::new(span, "this definition by cases has no rows")
                .help("write a value and a condition in each row")),
            _ => Ok(Expr::new(Node::Cases(branches), span)),
        }
    }

    /// Comparisons that must all hold: `x > 0`, `\text{if } 0 \le x < L`, `\text{otherwise}`.
    pub(in super::super::super) fn condition(&mut self, items: &[Item], place: Span) -> Read<Stated> {
        let mut items = trimmed(items);
        let mut said = false;
        while let [Item { layout: Layout::Text(word), .. }, rest @ ..] = items {
            match word.trim_matches(|c: char| c == ',' || c == '.').to_ascii_lowercase().as_str() {
                "otherwise" | "else" | "elsewhere" if rest.iter().all(is_blank) => return Ok(Stated::Otherwise),
                "forall" | "forevery" | "foreach" | "forany" | "all" | "any" | "every" => break,
                "if" | "for" | "when" | "where" | "with" | "in" | "provided" | "providedthat" | "whenever" | "as"
                | "validfor" | "validif" | "validwhen" | "holdsfor" | "holdsif" | "onlyfor" | "onlyif" | "" => {}
                // Of several places the condition is one, and no state is at all of them.
                "at" | "on" if rest.iter().any(|item| item.layout == Layout::Other(',')) => {
                    return Err(Fault::unsupported(
                        items[0].span,
                        "a condition with several places, as in “at x = 0, L”, is not supported",
                    )
                    .help("write the equation for each place"));
                }
                "at" | "on" => {}
                _ => {
                    return Err(Fault::unsupported(items[0].span, format!("the condition “{word}” is not supported"))
                        .help("write a comparison, such as x > 0"));
                }
            }
            said = true;
            items = trimmed(rest);
        }
        if let [first, rest @ ..] = items
            && says_all(first)
        {
            let rest = trimmed(rest);
            return match rest.iter().all(|item| names::printed(item, None).is_some() || is_blank(item)) {
                true => Ok(Stated::Holds(Vec::new())),
                false => {
                    Err(Fault::unsupported(first.span, "“for all” must be followed by names alone, as in “for all x”")
                        .help("write a further condition as a comparison, such as x > 0"))
                }
            };
        }
        if let [Item { layout: Layout::Fence(Delimiter::Round, inside), .. }] = items
            && inside.iter().any(|item| relation(item).is_some())
        {
            items = trimmed(inside);
        }
        let or = items.iter().find(|item| {
            matches!(&item.layout, Layout::Text(word) if ["or", "oder", "ou"].contains(&word.as_str()))
                || matches!(&item.layout, Layout::Command(name) if name == "\\lor" || name == "\\vee")
        });
        if let Some(or) = or {
            return Err(Fault::unsupported(or.span, "“or” in a condition is not supported")
                .help("write a row or a statement for each alternative"));
        }
        if let Some(comma) = outer_bounds(items) {
            return Err(Fault::ambiguous(comma.span, "the comma between these conditions may mean “and” or “or”")
                .help("write \\text{ and }, or a row for each condition"));
        }
        let mut conditions = Vec::new();
        for part in items.split(|item| {
            item.layout == Layout::Other(',')
                || matches!(&item.layout, Layout::Text(word) if word == "and")
                || matches!(&item.layout, Layout::Command(name) if name == "\\land" || name == "\\wedge")
        }) {
            let part = trimmed(part);
            let relations: Vec<_> = part.iter().filter_map(relation).collect();
            if relations.is_empty() {
                let span = part.iter().map(|item| item.span).reduce(Span::to).unwrap_or(place);
                let message = if said {
                    "this condition has no relation that is supported, such as = or <"
                } else {
                    "a condition should stand here, but this has no relation that is supported, such as = or <"
                };
                return Err(Fault::unsupported(span, message).help("write a comparison, such as x > 0"));
            }
            let mut members = Vec::new();
            for member in part.split(|item| relation(item).is_some()) {
                members.push(self.sum(trimmed(member), place)?);
            }
            conditions.push(Condition { members, relations });
        }
        Ok(Stated::Holds(conditions))
    }
}

/// The comma of `x < a, x > b`: what lies below one bound lies above the other only if they cross, so “or” may be meant.
fn outer_bounds(items: &[Item]) -> Option<&Item> {
    let at = items.iter().position(|item| item.layout == Layout::Other(','))?;
    let of = |part: &[Item]| match trimmed(part) {
        [name, sign, _, ..] => Some((names::printed(name, None)?.name, relation(sign)?)),
        _ => None,
    };
    let ((first, below), (second, above)) = (of(&items[..at])?, of(&items[at + 1..])?);
    let is_outer = matches!(below, Relation::Less | Relation::LessEqual)
        && matches!(above, Relation::Greater | Relation::GreaterEqual);
    (first == second && is_outer).then_some(&items[at])
}

/// What a condition says.
pub(in super::super::super) enum Stated {
    /// All that is left.
    Otherwise,
    /// All of these; nothing for "for all t".
    Holds(Vec<Condition>),
}

impl Stated {
    /// The conditions of a statement, which has no others before it.
    pub(in super::super::super) fn all(self, span: Span) -> Read<Vec<Condition>> {
        match self {
            Stated::Holds(conditions) => Ok(conditions),
            Stated::Otherwise => Err(Fault::unsupported(span, "“otherwise” is supported only in a list of cases")
                .help("write the condition as a comparison, such as x > 0")),
        }
    }
}

fn no_condition(items: &[Item], span: Span) -> Fault {
    let span = items.iter().map(|item| item.span).reduce(Span::to).unwrap_or(span);
    Fault::new(span, "this case has no condition").help("write the condition after &, as in x & x > 0")
}

/// A row without `&`: the condition begins at a wide space, a comma or a word.
fn split_row(items: &[Item]) -> Option<(&[Item], &[Item])> {
    let at = items
        .iter()
        .position(|item| matches!(&item.layout, Layout::Space(Space::Wide) | Layout::Other(',') | Layout::Text(_)))?;
    let (value, condition) = items.split_at(at);
    (!trimmed(value).is_empty() && !trimmed(condition).is_empty()).then_some((value, condition))
}

fn is_blank(item: &Item) -> bool {
    matches!(item.layout, Layout::Space(_) | Layout::Other(',' | ';' | '.'))
}

/// Whether words stand behind the comparison of a condition.
fn ends_with_words(items: &[Item]) -> bool {
    const SHORT: usize = 3;
    let is_words =
        |word: &str| word.len() > SHORT && word.chars().all(|c| c.is_lowercase()) && Unit::named(word).is_none();
    matches!(items.split_last(), Some((Item { layout: Layout::Text(word), .. }, [_, ..])) if is_words(word))
}

/// Without spaces and punctuation at both ends.
fn trimmed(items: &[Item]) -> &[Item] {
    let start = items.iter().position(|item| !is_blank(item)).unwrap_or(items.len());
    let end = items.iter().rposition(|item| !is_blank(item)).map_or(start, |at| at + 1);
    &items[start..end]
}

/// `\forall`, `\text{for all}`
fn says_all(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\forall",
        Layout::Text(word) => {
            let word = word.trim_matches(',').to_ascii_lowercase();
            ["forall", "forevery", "foreach", "forany", "all", "any", "every"].contains(&word.as_str())
        }
        _ => false,
    }
}
