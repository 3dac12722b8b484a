//! Stars above letters: complex conjugates where the notes have complex numbers, and marks of names elsewhere.

use crate::notes::Notes;

/// What notes with complex numbers contain: a wave function, i in an exponent, an operator.
const SIGNS: [&str; 14] = [
    "\\psi",
    "\\Psi",
    "\\dagger",
    "\\hbar",
    "e^{i",
    "e^{-i",
    "e^{j",
    "e^{-j",
    "\\mathrm{i}",
    "\\operatorname{Re}",
    "\\Re",
    "\\Im",
    "conjugate",
    "complex",
];

/// Whether notes have complex numbers, so that a star may mark the conjugate of one.
pub(super) fn are_spoken_of(notes: &Notes) -> bool {
    let text = &notes.source.text;
    SIGNS.iter().any(|sign| text.contains(sign))
}

/// A text of the same length in which a star above a letter that has no subscript is one below: `t^*` is a name, as `t_*` is.
pub(super) fn without_stars(text: &str) -> String {
    let mut new = text.to_owned();
    for star in ["^*", "^{*}", "^\\ast", "^{\\ast}", "^\\star", "^{\\star}"] {
        while let Some(at) = new.find(star).filter(|at| stands_alone(&new, *at, star.len())) {
            new.replace_range(at..=at, "_");
        }
    }
    new
}

/// Whether a star stands above a letter without other scripts.
fn stands_alone(text: &str, at: usize, length: usize) -> bool {
    let before = text[..at].trim_end();
    let letters = before.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let is_letter = letters.len() < before.len() && !letters.ends_with('_');
    is_letter && !text[at + length..].trim_start().starts_with(['_', '^'])
}
