//! The numbers of equations, which are no parts of them: `F = ma \qquad (7-47)`, `(1)\qquad F = ma`.

use super::super::layout::{Delimiter, Item, Layout};
use super::super::lexer::Space;
use super::super::rows::{is_operator, relation};

/// Whether nothing but a point or spaces follows.
pub(super) fn ends_the_row(items: &[&Item], at: usize) -> bool {
    items[at + 1..].iter().all(|next| matches!(next.layout, Layout::Space(_) | Layout::Other('.' | ',')))
}

/// Whether an item is the number of an equation in parentheses: `(7-47)`, `(2.3)`, `(A-1)`, `(1a)`, `[12]`, `\text{(Eq. 4)}`.
pub(super) fn is_equation_number(item: &Item) -> bool {
    // A text has lost its parentheses.
    if let Layout::Text(word) = &item.layout {
        let number = ["Equation", "Eqn.", "Eq.", "eq.", "Gl."].iter().find_map(|name| word.strip_prefix(name));
        let number = number.unwrap_or(word);
        let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '–' | 'a' | 'b' | 'c');
        let is_number = number.starts_with(|c: char| c.is_ascii_digit()) && number.chars().all(is_part);
        return is_number || !word.is_empty() && word.chars().all(|c| matches!(c, 'i' | 'v' | 'x'));
    }
    let Layout::Fence(Delimiter::Round | Delimiter::Square, inside) = &item.layout else { return false };
    // `(\text{Eq. 4.2})`
    if let [Item { layout: Layout::Text(word), .. }] = inside.as_slice() {
        return word.contains(|c: char| c.is_ascii_digit());
    }
    let has_number = inside.iter().any(|item| matches!(item.layout, Layout::Number(_)));
    let is_number = |at: usize| matches!(inside[at].layout, Layout::Number(_));
    // The letter of `(1a)` touches its number; `(1 - x)` is no number of an equation.
    let is_part = |(at, item): (usize, &Item)| match &item.layout {
        Layout::Number(_) => true,
        Layout::Other('-' | '–' | '.') => at > 0 && at + 1 < inside.len(),
        Layout::Letter(letter) if at == 0 => letter.is_ascii_uppercase(),
        Layout::Letter(_) => at + 1 == inside.len() && is_number(at - 1),
        _ => false,
    };
    has_number && inside.iter().enumerate().all(is_part)
}

/// Whether the item is a whole number in parentheses at the end of the row, after a space: `F = ma \quad (2)`.
pub(super) fn is_number_of_the_row(items: &[&Item], at: usize) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &items[at].layout else { return false };
    let is_number = matches!(inside.as_slice(), [Item { layout: Layout::Number(_), .. }]);
    let after_space = at > 0 && matches!(items[at - 1].layout, Layout::Space(_));
    is_number && after_space && ends_the_row(items, at)
}

/// Whether the item is a whole number in parentheses before a system, `(1) \begin{cases} …`, or apart before an equation,
/// `(1)\; a = b`: nobody begins a product in this way.
pub(super) fn is_number_before_a_row(items: &[&Item], at: usize) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &items[at].layout else { return false };
    let is_number = matches!(inside.as_slice(), [Item { layout: Layout::Number(_), .. }]);
    let Some(after) = items.get(at + 1).filter(|_| is_number && at == 0) else { return false };
    let next = items[at + 1..].iter().find(|next| !matches!(next.layout, Layout::Space(_)));
    let is_system = |next: &&&Item| matches!(&next.layout, Layout::Environment(name, _) if name.contains("cases"));
    let is_apart = items[at].span.end < after.span.start || matches!(after.layout, Layout::Space(_));
    let is_sign = |next: &Item| is_operator(next) || relation(next).is_some();
    let is_equation = items.iter().any(|item| relation(item).is_some());
    next.is_some_and(|next| is_system(&next) || is_apart && is_equation && !is_sign(next))
}

/// The length of the number or the letter of an equation with a wide space after it at the beginning of a row: `(1)\qquad E = mc^2`,
/// `(a)\quad x = y`, `[2.4]\quad …`, `1.\quad …`. It is no statement.
pub(super) fn length_before_a_row(items: &[&Item]) -> usize {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let Some(first) = items.iter().position(|item| !is_space(item)) else { return 0 };
    let is_letter = |inside: &[Item]| matches!(inside, [Item { layout: Layout::Letter('a'..='h' | 'i' | 'v'), .. }]);
    let length = match &items[first].layout {
        Layout::Fence(Delimiter::Round, inside) if is_letter(inside) => 1,
        Layout::Fence(..) if is_equation_number(items[first]) => 1,
        Layout::Number(digits) if digits.ends_with('.') => 1,
        Layout::Number(_) if items.get(first + 1).is_some_and(|next| next.layout == Layout::Other('.')) => 2,
        _ => return 0,
    };
    let end = first + length;
    let is_apart = items.get(end).is_some_and(|next| next.layout == Layout::Space(Space::Wide));
    let mut rest = items.get(end..).unwrap_or_default().iter().filter(|item| !is_space(item));
    let begins = rest.next().is_some_and(|next| relation(next).is_none() && !is_operator(next));
    match is_apart && begins && rest.any(|item| relation(item).is_some()) {
        true => end,
        false => 0,
    }
}
