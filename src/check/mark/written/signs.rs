//! Names with two signs, `\omega_\pm` and `r_\pm`: the two values that the problem numbers, or both values of the letter.

use crate::latex::names;
use crate::source::Span;

use super::Written;
use crate::check::mark::names::Names;

/// How the two signs stand below a letter.
const BELOW: [&str; 3] = ["_\\pm", "_{\\pm}", "_{ \\pm }"];

/// Replaces the signs below a letter by the numbers of the problem's two values; where it has none, by nothing.
pub(in crate::check::mark) fn named(lines: &mut [Written], known: &Names) {
    let is_known =
        |text: &str| names::parse(text).is_some_and(|(name, _)| known.names.iter().any(|(own, ..)| *own == name));
    for line in lines {
        let mut edits = Vec::new();
        for below in BELOW {
            for (at, _) in line.text.match_indices(below) {
                let Some(letter) = letter_before(&line.text[..at]) else { continue };
                let is_numbered = [1, 2].iter().all(|number| is_known(&format!("{letter}_{number}")));
                let new = match () {
                    () if is_numbered => "_{1,2}",
                    () if is_known(letter) => "",
                    () => continue,
                };
                edits.push((Span::new(at, at + below.len()), new.to_owned()));
            }
        }
        line.edits.extend(edits);
    }
}

/// The letter or the command with which a text ends.
fn letter_before(text: &str) -> Option<&str> {
    let word = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    match word.strip_suffix('\\') {
        Some(before) if word.len() < text.len() => Some(&text[before.len()..]),
        _ => text.char_indices().next_back().filter(|(_, c)| c.is_ascii_alphabetic()).map(|(at, _)| &text[at..]),
    }
}

#[cfg(test)]
mod tests {
    use super::letter_before;

    #[test]
    fn the_letter_before_is_a_letter_or_a_command() {
        assert_eq!(letter_before(r"= \omega"), Some(r"\omega"));
        assert_eq!(letter_before("2r"), Some("r"));
        // The twins: no letter.
        assert_eq!(letter_before("r_1"), None);
        assert_eq!(letter_before(""), None);
    }
}
