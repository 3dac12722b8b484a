//! Displays that the words call wrong: "It is tempting to write $$…$$", and after one "But this is false".
//!
//! The author rejects such a formula, so it is neither judged nor used.
//!
//! Offers `is_rejected`, `blank` for its text, which is judged no more, and `found` for what the report says of it. Knows `gate`, notes
//! and the words of prose.

use crate::check::document::inferred::prose::{sentence_start, words_between};
use crate::check::unaided::gate;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::notes::{Display, Notes};

/// Words of the sentence before a formula that reject it.
const BEFORE: [&str; 20] = [
    "tempting",
    "tempted",
    "naive",
    "naively",
    "wrongly",
    "mistakenly",
    "erroneously",
    "incorrectly",
    "falsely",
    "common mistake",
    "common error",
    "frequent mistake",
    "frequent error",
    "students often write",
    "one might think",
    "one might guess",
    "one might expect",
    "you might think",
    "fälschlich",
    "verleitet",
];

/// With these words a sentence after a formula goes on to speak of it.
const SUBJECTS: [&str; 6] = ["this", "that", "it", "which", "these", "das"];

/// Words before such a subject.
const OPENINGS: [&str; 9] = ["but", "however", "yet", "and", "of", "course", "obviously", "clearly", "now"];

/// What a sentence after a formula says of it.
const AFTER: [&str; 16] = [
    "is false",
    "is wrong",
    "is not true",
    "is not right",
    "is not correct",
    "is incorrect",
    "is nonsense",
    "is a mistake",
    "is an error",
    "is impossible",
    "would be wrong",
    "cannot be right",
    "cannot be true",
    "cannot be correct",
    "can not be right",
    "ist falsch",
];

/// The same, where the sentence ends with it.
const AT_THE_END: [&str; 2] = ["cannot be", "can not be"];

/// Words that restrict what a sentence says to a case.
const RESTRICTIONS: [&str; 9] = ["that", "for", "if", "when", "unless", "in", "only", "at", "near"];

/// The most words between the subject of a sentence and what it says.
const BETWEEN: usize = 3;

/// The number of sentences after a formula that may reject it.
const SENTENCES: usize = 2;

/// Whether the words around a display call it wrong.
pub(in crate::check::unaided) fn is_rejected(notes: &Notes, at: usize) -> bool {
    let display = &notes.equations[at];
    before(notes, display) || after(notes, at)
}

/// Blanks in the place of a text.
pub(in crate::check::unaided) fn blank(text: &str) -> String {
    " ".repeat(text.len())
}

/// The finding on a display of which the text was blanked: that its author calls it wrong.
pub(in crate::check::unaided) fn found(notes: &Notes, equation: &Equation) -> Option<Equation> {
    let display = notes.equations.iter().find(|display| display.id() == Some(equation.id.as_str()))?;
    let printed = notes.source.slice(display.body);
    if !display.text.trim().is_empty() || printed.trim().is_empty() {
        return None;
    }
    let message = "the words beside this formula call it wrong, so it was neither checked nor used".to_owned();
    let found = gate::settled(equation, (Verdict::Undecided, Code::NotDecided), message);
    Some(Equation { latex: printed.to_owned(), ..found })
}

fn before(notes: &Notes, display: &Display) -> bool {
    let text = notes.source.text.get(..display.span.start).unwrap_or_default();
    let end = text.trim_end().len();
    let last = notes.equations.iter().map(|other| other.span.end).filter(|stop| *stop <= end).max().unwrap_or(0);
    let start = sentence_start(notes, end).max(last);
    let words = words_between(notes, start, end).join(" ");
    BEFORE.iter().any(|phrase| says(&words, phrase))
}

fn after(notes: &Notes, at: usize) -> bool {
    let start = notes.equations[at].span.end;
    let next = notes.equations.iter().map(|other| other.span.start).filter(|next| *next >= start).min();
    let end = next.unwrap_or(notes.source.text.len());
    let text = notes.source.text.get(start..end).unwrap_or_default();
    let mut from = start;
    text.split_inclusive(['.', '!', ';']).take(SENTENCES + 1).any(|sentence| {
        let words = words_between(notes, from, from + sentence.len());
        from += sentence.len();
        rejects(&words)
    })
}

/// Whether a sentence says that the formula before it is wrong.
fn rejects(words: &[String]) -> bool {
    let Some(subject) = words.iter().position(|word| !OPENINGS.contains(&word.as_str())) else { return false };
    if !SUBJECTS.contains(&words[subject].as_str()) {
        return false;
    }
    let rest: Vec<&str> =
        words[subject + 1..].iter().map(String::as_str).filter(|word| !OPENINGS.contains(word)).collect();
    (0..=BETWEEN.min(rest.len())).any(|skipped| {
        let said = rest[skipped..].join(" ");
        let restricts = |after: &str| RESTRICTIONS.iter().any(|word| after.split(' ').next() == Some(word));
        let goes_on = |phrase: &&&str| {
            said.strip_prefix(**phrase)
                .is_some_and(|after| after.is_empty() || after.strip_prefix(' ').is_some_and(|after| !restricts(after)))
        };
        AFTER.iter().any(|phrase| goes_on(&phrase)) || AT_THE_END.contains(&said.as_str())
    })
}

/// Whether words contain a phrase as a whole.
fn says(words: &str, phrase: &str) -> bool {
    format!(" {words} ").contains(&format!(" {phrase} "))
}

#[cfg(test)]
mod tests {
    use super::rejects;

    fn is_rejection(sentence: &str) -> bool {
        rejects(&sentence.to_lowercase().split_whitespace().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn a_sentence_rejects_a_formula_or_restricts_it() {
        for sentence in [
            "But this is false since the collision is not elastic",
            "This cannot be",
            "which however is wrong",
            "That result is clearly wrong",
        ] {
            assert!(is_rejection(sentence), "{sentence}");
        }
        for sentence in [
            "This is wrong for large amplitudes",
            "This cannot be negative",
            "The old theory is wrong",
            "It is not true that the energy is conserved only here",
        ] {
            assert!(!is_rejection(sentence), "{sentence}");
        }
    }
}
