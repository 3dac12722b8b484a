//! Functions of a constant: `V(r) = …` on a circle, where r does not change, and `V(2r)`. In a hand-in V is then a quantity, and
//! V(2r) its value elsewhere.

use crate::latex::foreign;
use crate::latex::names;
use crate::source::Span;

use super::Written;
use super::instants::{Instant, Kind, name_of};
use crate::check::mark::names::{Names, Role};

/// Leaves out the arguments of functions of a constant, and names their values at other arguments.
pub(in crate::check::mark) fn of_constants(lines: &mut [Written], known: &Names, values: &mut Vec<Instant>) {
    let mut found: Vec<(String, String)> = Vec::new();
    for (name, argument) in lines.iter().filter_map(|line| given(&line.text)) {
        let is_new = found.iter().all(|(other, _)| other != name);
        // After `V = a/r` or `V(r) = a/r`, where r moves, V(r_0) is a value of it.
        if is_new && is_quantity(name, known) && is_constant(argument, known) && !is_of_what_moves(lines, name, known) {
            found.push((name.to_owned(), argument.to_owned()));
        }
    }
    for line in lines.iter_mut().filter(|_| !found.is_empty()) {
        for (start, open, close) in applications(&line.text) {
            let (name, inside) = (line.text[start..open].trim(), line.text[open + 1..close].trim());
            let Some((_, argument)) = found.iter().find(|(other, _)| other == name) else { continue };
            if inside == argument {
                line.edits.push((Span::new(open, close + 1), " ".to_owned()));
            } else if inside.contains(argument.as_str()) {
                let kind = Kind::Of(argument.clone());
                let name = name_of(
                    values,
                    Instant { name: String::new(), of: name.to_owned(), when: inside.to_owned(), kind },
                );
                line.edits.push((Span::new(start, close + 1), format!("{{{name}}}")));
            }
        }
    }
}

/// The name and the letter of a function that is the left side of a line.
fn given(text: &str) -> Option<(&str, &str)> {
    let start = text.len() - text.trim_start().len();
    let (_, open, close) = applications(text).into_iter().find(|(at, ..)| *at == start)?;
    let is_given = text[close + 1..].trim_start().trim_start_matches('&').trim_start().starts_with('=');
    is_given.then(|| (text[start..open].trim(), text[open + 1..close].trim()))
}

/// Whether a line before says what a quantity is as a function of something that moves: `V = a/r`, `V(r) = a/r`.
fn is_of_what_moves(lines: &[Written], name: &str, known: &Names) -> bool {
    let moves = |text: &str| {
        let parsed = names::parse(text.trim()).map(|(name, _)| name);
        parsed.is_some_and(|name| known.names.iter().any(|(own, role, _)| *own == name && *role == Role::Moving))
    };
    lines.iter().any(|line| {
        if let Some((other, argument)) = given(&line.text) {
            return other == name && moves(argument);
        }
        let Some((left, right)) = line.text.split_once('=') else { return false };
        let letters = right.char_indices().filter_map(|(at, _)| Some(&right[at..foreign::quantity(right, at)?]));
        left.trim() == name && letters.into_iter().any(moves)
    })
}

/// The quantities of a text with a parenthesis after them: where each starts, and where its parenthesis opens and closes.
fn applications(text: &str) -> Vec<(usize, usize, usize)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(step) = text[at..].chars().next().map(char::len_utf8) {
        let command = text[at..]
            .strip_prefix('\\')
            .map_or(0, |rest| 1 + rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len()));
        let Some(end) = foreign::quantity(text, at) else {
            at += command.max(step);
            continue;
        };
        let open = end + text[end..].len() - text[end..].trim_start().len();
        let close =
            text[open..].strip_prefix('(').and_then(|inside| inside.find([')', '('])).map(|length| open + 1 + length);
        if let Some(close) = close.filter(|close| text[*close..].starts_with(')')) {
            found.push((at, open, close));
        }
        at = end;
    }
    found
}

fn is_quantity(name: &str, known: &Names) -> bool {
    let Some((name, _)) = names::parse(name) else { return false };
    let is_plain = name.primes == 0 && !["d", "e", "\\pi"].contains(&name.base.as_str());
    let of_problem = known.symbols.find(&name).is_some();
    let is_result = known.names.iter().any(|(own, role, _)| *own == name && *role == Role::Determined);
    is_plain && (!of_problem || is_result && known.fixed.contains(&name))
}

/// Whether a text is a single letter that neither moves in the problem nor is a time.
fn is_constant(argument: &str, known: &Names) -> bool {
    let is_letter = foreign::quantity(argument, 0) == Some(argument.len());
    let name = names::parse(argument).map(|(name, _)| name).filter(|_| is_letter);
    name.is_some_and(|name| {
        let moves = known.names.iter().any(|(own, role, _)| *own == name && *role == Role::Moving);
        name.base != "t" && name.primes == 0 && !moves
    })
}

#[cfg(test)]
mod tests {
    use super::given;

    #[test]
    fn a_function_may_be_the_left_side_of_a_line() {
        assert_eq!(given(r"V(r) = \frac{a}{r}"), Some(("V", "r")));
        assert_eq!(given(r"V_1 (r_0) &= a"), Some(("V_1", "r_0")));
        // The twins: a product on the right side, a function of a language, a sum before it.
        for text in ["a = V(r)", r"\sin(x) = a", "a + V(r) = b", "V(f(r)) = a", "V(r) + a"] {
            assert_eq!(given(text), None, "{text}");
        }
    }
}
