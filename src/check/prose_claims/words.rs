//! The words and formulas of the sentence around a display.

use crate::check::document::inferred::prose::{body_of, sentence_start, words_between};
use crate::notes::Notes;

/// Words for the begin of a motion, as they begin.
const RELEASED: [&str; 7] = ["releas", "start", "begin", "losgelass", "lâch", "abandonn", "suelta"];

/// Phrases for the same, each word as it begins.
const LET_GO: [&str; 8] =
    ["let go", "set free", "is dropped", "are dropped", "falls from", "fall from", "falling from", "slides from"];

/// Phrases for a begin at rest, each word as it begins.
const AT_REST: [&str; 6] = [
    "without initial velocit",
    "without initial speed",
    "no initial velocit",
    "no initial speed",
    "zero initial velocit",
    "ohne anfangsgeschwindigkeit",
];

/// Words for rest.
pub(super) const REST: [&str; 5] = ["rest", "ruhe", "repos", "reposo", "riposo"];

/// Words before an equation for something that is sought, as they begin.
pub(crate) const ROOTS_OF: [&str; 15] = [
    "root of",
    "roots of",
    "zero of",
    "zeros of",
    "zeroes of",
    "solution of",
    "solutions of",
    "solution to",
    "solutions to",
    "nullstellen von",
    "lösung von",
    "lösungen von",
    "racines de",
    "solutions de",
    "raíces de",
];

/// Words for an instant of the motion at which more holds than before and after, and at which nothing stays.
pub(crate) const PASSING: [&str; 14] = [
    "turning point",
    "turns back",
    "turn back",
    "turns around",
    "turns round",
    "comes to rest",
    "come to rest",
    "came to rest",
    "momentarily",
    "instantaneously at rest",
    "for a moment",
    "umkehrpunkt",
    "kommt zur ruhe",
    "point de rebroussement",
];

/// The most bytes after a display that are taken for the end of its sentence.
const LONGEST_END: usize = 160;

/// The most bytes before a display that are taken for what leads to it.
const LONGEST_PARAGRAPH: usize = 500;

/// The part of a sentence before a display, or after it.
pub(super) struct Sentence {
    words: Vec<String>,
    /// The formulas in it, without their marks, in order.
    pub formulas: Vec<String>,
    /// Whether it begins as a part of the sentence before it does: with a small letter.
    pub goes_on: bool,
}

impl Sentence {
    /// The part before the `at`-th display.
    pub fn before(notes: &Notes, at: usize) -> Self {
        // A mark directly before the display ends no other sentence.
        let text = &notes.source.text[..notes.equations[at].span.start];
        let end = text.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, ':' | '.')).len();
        Sentence::between(notes, sentence_start(notes, end), end)
    }

    /// All that stands between the `at`-th display and the one before it.
    pub fn paragraph(notes: &Notes, at: usize) -> Self {
        let (from, end) = since_last_display(notes, at);
        Sentence::between(notes, from, end)
    }

    /// The sentences between the `at`-th display and the one before it, in order.
    pub fn all_before(notes: &Notes, at: usize) -> Vec<Self> {
        let (from, end) = since_last_display(notes, at);
        let text = &notes.source.text;
        let is_inside = |at: usize| notes.inline.iter().any(|span| span.start <= at && at < span.end);
        let is_end = |at: usize, mark: char| {
            let rest = &text[at + mark.len_utf8()..end];
            matches!(mark, '.' | '?' | '!' | ';')
                && rest.starts_with(|c: char| c.is_whitespace() || matches!(c, '*' | ')' | '}'))
                && !rest.trim().is_empty()
                && !is_inside(at)
        };
        let marks = text[from..end].char_indices().map(|(place, mark)| (from + place, mark));
        let ends: Vec<usize> =
            marks.filter(|(at, mark)| is_end(*at, *mark)).map(|(at, mark)| at + mark.len_utf8()).chain([end]).collect();
        let starts = std::iter::once(from).chain(ends.iter().copied());
        starts.zip(&ends).map(|(start, end)| Sentence::between(notes, start, *end)).collect()
    }

    /// The part after the `at`-th display; empty where the display ends the sentence.
    pub fn after(notes: &Notes, at: usize) -> Self {
        let display = &notes.equations[at];
        let (text, from) = (&notes.source.text, display.span.end);
        let mut to = text.len().min(from + LONGEST_END);
        while !text.is_char_boundary(to) {
            to += 1;
        }
        let next = notes.equations.iter().map(|other| other.span.start).filter(|start| *start >= from).min();
        let to = to.min(next.unwrap_or(to));
        let rest = &text[from..to];
        let ends_before = display.text.trim_end().ends_with('.') || rest.trim_start().starts_with(char::is_uppercase);
        let end = if ends_before { 0 } else { rest.find(['.', ';']).unwrap_or(rest.len()) };
        Sentence::between(notes, from, from + end)
    }

    fn between(notes: &Notes, from: usize, to: usize) -> Self {
        let inside = notes.inline.iter().filter(|span| span.start >= from && span.end <= to);
        let formulas = inside.filter_map(|span| Some(notes.source.slice(body_of(notes, *span)?).trim().to_owned()));
        let goes_on = notes.source.text[from..to].trim_start().starts_with(char::is_lowercase);
        Sentence { words: words_between(notes, from, to), formulas: formulas.collect(), goes_on }
    }

    /// Whether there is neither a word nor a formula.
    pub fn is_empty(&self) -> bool {
        self.words.is_empty() && self.formulas.is_empty()
    }

    /// Whether a word begins with one of these letters.
    pub fn says(&self, stems: &[&str]) -> bool {
        self.words.iter().any(|word| stems.iter().any(|stem| word.starts_with(stem)))
    }

    /// Whether it says that a motion starts: "is released", "starts", "is let go", "is dropped", "falls from", "is at rest" at `t = 0`.
    pub fn says_that_it_starts(&self) -> bool {
        let is_first = |formula: &String| formula.split_whitespace().collect::<String>() == "t=0";
        self.says(&RELEASED)
            || self.says_phrase(&LET_GO)
            || self.says_phrase(&AT_REST)
            || self.has_word(&REST) && self.formulas.iter().any(is_first)
    }

    /// Whether it says that something is at rest, or that it has no velocity in the beginning.
    pub fn says_that_it_rests(&self) -> bool {
        self.has_word(&REST) || self.says_phrase(&AT_REST)
    }

    /// The places of the words that begin with one of these letters.
    pub fn places(&self, stems: &[&str]) -> Vec<usize> {
        let begins = |word: &String| stems.iter().any(|stem| word.starts_with(stem));
        (0..self.words.len()).filter(|at| begins(&self.words[*at])).collect()
    }

    /// Whether one of these is a word of it.
    pub fn has_word(&self, words: &[&str]) -> bool {
        self.words.iter().any(|word| words.contains(&word.as_str()))
    }

    /// Whether the words of one of these phrases follow each other; each is the beginning of a word.
    pub fn says_phrase(&self, phrases: &[&str]) -> bool {
        phrases.iter().any(|phrase| {
            let stems: Vec<&str> = phrase.split(' ').collect();
            self.words.windows(stems.len()).any(|words| words.iter().zip(&stems).all(|(w, stem)| w.starts_with(stem)))
        })
    }

    /// Whether it ends with the words of one of these phrases; each is the beginning of a word.
    pub fn ends_with(&self, phrases: &[&str]) -> bool {
        phrases.iter().any(|phrase| {
            let parts: Vec<&str> = phrase.split(' ').collect();
            let last = self.words.len().checked_sub(parts.len()).map(|from| &self.words[from..]);
            last.is_some_and(|last| last.iter().zip(&parts).all(|(word, part)| word.starts_with(part)))
        })
    }

    /// Whether it denies or doubts something.
    pub fn denies(&self) -> bool {
        self.has_word(&["not", "no", "never", "would", "cannot", "unless", "nicht", "kein", "pas", "non"])
    }
}

/// The bytes between the `at`-th display and the one before it, or the last of these.
fn since_last_display(notes: &Notes, at: usize) -> (usize, usize) {
    let end = notes.equations[at].span.start;
    let before = notes.equations.iter().map(|other| other.span.end).filter(|before| *before <= end).max();
    let mut from = before.unwrap_or(0).max(end.saturating_sub(LONGEST_PARAGRAPH));
    while !notes.source.text.is_char_boundary(from) {
        from += 1;
    }
    (from, end)
}
