//! Text in lines of a given width: words, and formulas at their operators.

use super::style::{Style, columns, columns_of};

/// Operators that begin a line rather than end one.
const OPERATORS: [&str; 13] = ["+", "−", "-", "±", "∓", "=", "≈", "≠", "<", ">", "≤", "≥", "∝"];

/// Characters of a formula or a path that a line may end after.
const BREAKS: [char; 9] = ['·', '×', ',', ';', '/', ')', ']', '}', '_'];

/// A text of which no line is wider than `width` columns.
///
/// The text begins after `first` in its first line; the lines after that have an indent of so many columns. Lines end
/// between words, and before an operator of a formula. A no-break space is shown as a space. Only a word that is wider
/// than a whole line is broken: after a sign of multiplication, a comma, a slash or a closing bracket where it has one.
pub(crate) fn wrap(first: &str, text: &str, indent: usize, width: usize) -> String {
    let room = width.saturating_sub(indent).max(1);
    let mut lines = vec![first.to_owned()];
    let mut used = columns(first);
    let mut is_empty = true;
    for word in words(text, room) {
        let wide = columns(&word);
        let gap = usize::from(!is_empty);
        if used + gap + wide > width && !(is_empty && used <= indent) {
            lines.push(" ".repeat(indent));
            (used, is_empty) = (indent, true);
        }
        if let Some(line) = lines.last_mut() {
            if !is_empty {
                line.push(' ');
                used += 1;
            }
            line.push_str(&word);
        }
        used += wide;
        is_empty = false;
    }
    let lines: Vec<String> = lines.iter().map(|line| line.trim_end().replace('\u{a0}', " ")).collect();
    lines.join("\n")
}

/// The text of a title in lines: after the word of its level and its code.
pub(super) fn titled(level: &str, code: &str, message: &str, style: Style) -> String {
    let label = if code.is_empty() { columns(level) + 2 } else { columns(level) + columns(code) + 4 };
    wrap("", message, 0, style.inside(label).width)
}

/// What must not be broken, in order: words, each operator with the operand after it, and pieces of what is too wide.
fn words(text: &str, room: usize) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut operator: Option<&str> = None;
    for word in quoted(text, room) {
        if operator.is_none()
            && let Some(found) = OPERATORS.into_iter().find(|operator| *operator == word)
        {
            operator = Some(found);
            continue;
        }
        let word = match operator.take() {
            Some(operator) => format!("{operator} {word}"),
            None => word,
        };
        if columns(&word) <= room { words.push(word) } else { words.extend(pieces(&word, room)) }
    }
    words.extend(operator.map(str::to_owned));
    words
}

/// The words of a text. What is in quotes is one word, if it fits into a line.
fn quoted(text: &str, room: usize) -> Vec<String> {
    let is_open =
        |text: &str| text.matches('“').count() > text.matches('”').count() || text.matches('"').count() % 2 == 1;
    let words: Vec<&str> = text.split([' ', '\n']).filter(|word| !word.is_empty()).collect();
    let mut joined: Vec<String> = Vec::new();
    let mut at = 0;
    while at < words.len() {
        let mut whole = words[at].to_owned();
        let mut end = at + 1;
        while is_open(&whole) && end < words.len() && columns(&whole) < room {
            whole = format!("{whole} {}", words[end]);
            end += 1;
        }
        if is_open(&whole) || columns(&whole) > room {
            (whole, end) = (words[at].to_owned(), at + 1);
        }
        joined.push(whole);
        at = end;
    }
    joined
}

/// A word in pieces that fit.
fn pieces(word: &str, room: usize) -> Vec<String> {
    let mut pieces = Vec::new();
    let mut rest = word;
    while columns(rest) > room {
        let mut used = 0;
        let mut fits = 0;
        let mut at_break = None;
        for (at, c) in rest.char_indices() {
            used += columns_of(c);
            if used > room && fits > 0 {
                break;
            }
            fits = at + c.len_utf8();
            if BREAKS.contains(&c) {
                at_break = Some(fits);
            }
        }
        let (piece, more) = rest.split_at(at_break.unwrap_or(fits));
        pieces.push(piece.to_owned());
        rest = more;
    }
    if !rest.is_empty() {
        pieces.push(rest.to_owned());
    }
    pieces
}

/// A text in one line of at most so many columns: its beginning and its end, with an ellipsis between them.
pub(super) fn shortened(text: &str, width: usize) -> String {
    if columns(text) <= width {
        return text.to_owned();
    }
    let room = width.saturating_sub(1);
    let (ahead, behind) = (room - room / 3, room / 3);
    let mut used = 0;
    let head: String = text
        .chars()
        .take_while(|c| {
            used += columns_of(*c);
            used <= ahead
        })
        .collect();
    let mut used = 0;
    let mut tail: Vec<char> = Vec::new();
    for c in text.chars().rev() {
        used += columns_of(c);
        if used > behind {
            break;
        }
        tail.push(c);
    }
    head + "…" + &tail.iter().rev().collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_between_words_and_hang() {
        let text = wrap("  ✓ 1  ", "the two sides differ, on shell", 4, 20);
        assert_eq!(text, "  ✓ 1  the two sides\n    differ, on shell");
        assert_eq!(wrap("", "", 4, 20), "");
        assert_eq!(wrap("error: ", "short", 2, 80), "error: short");
    }

    #[test]
    fn a_formula_breaks_before_an_operator_or_after_a_factor() {
        let text = wrap("", "aaaa + bbbb = cccc + dddd", 2, 12);
        assert_eq!(text, "aaaa + bbbb\n  = cccc\n  + dddd");
        let product = wrap("", "λ_1·φ\u{307}·sin(θ)·cos(θ)", 2, 12);
        assert_eq!(product, "λ_1·φ\u{307}·\n  sin(θ)·\n  cos(θ)");
    }

    #[test]
    fn no_line_is_wider_whatever_the_text() {
        let texts = ["x".repeat(300), "a b ".repeat(60), "θ\u{307}·".repeat(100), "力".repeat(90), "- ".repeat(70)];
        for text in texts {
            for width in [40, 80, 120] {
                let wrapped = wrap("  = note: ", &text, 10, width);
                assert!(wrapped.lines().all(|line| columns(line) <= width), "{wrapped}");
                let kept = |text: &str| text.replace([' ', '\n'], "");
                assert_eq!(kept(&wrapped), kept(&format!("=note:{text}")));
            }
        }
        // What can be broken nowhere is seen: without wrapping the same text is too wide.
        assert!(columns(&"a b ".repeat(60)) > 120);
    }

    #[test]
    fn what_is_in_quotes_stays_together_where_it_fits() {
        assert_eq!(wrap("", "it holds with “− a”", 2, 16), "it holds with\n  “− a”");
        assert_eq!(wrap("", r#"add it to "varies with time" now"#, 2, 22), "add it to\n  \"varies with time\"\n  now");
        // What does not fit is broken like any other text, and so is a quote that never ends.
        assert_eq!(wrap("", "“aaaa bbbb cccc dddd”", 2, 12), "“aaaa bbbb\n  cccc dddd”");
        assert_eq!(wrap("", "“aa bb cc dd", 2, 9), "“aa bb cc\n  dd");
    }

    #[test]
    fn what_must_stay_together_does() {
        assert_eq!(wrap("", "at a\u{a0}=\u{a0}1.5, b\u{a0}=\u{a0}2", 2, 12), "at a = 1.5,\n  b = 2");
    }

    #[test]
    fn a_long_text_keeps_both_its_ends() {
        assert_eq!(shortened("abc", 3), "abc");
        assert_eq!(shortened("abcdefghij", 7), "abcd…ij");
        assert_eq!(columns(&shortened(&"力".repeat(30), 20)), 19);
    }
}
