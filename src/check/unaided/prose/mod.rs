//! The words before a display: which displays they name, and whether they announce a consequence or an assumption.
//!
//! Offers `before`, the words before a display, and what they announce. Knows the words of `prose_claims`, and notes.

pub(super) mod contrasts;
pub(super) mod rejected;
mod words;

use std::ops::Range;

use crate::latex::lines::implication;
use crate::notes::Notes;
use crate::source::Span;

use crate::check::prose_claims::words::{PASSING, ROOTS_OF};
use crate::check::unaided::inline::is_inline;
use crate::check::unaided::prose::words::{
    ANEW, ANOTHER_THING, ASSUMPTION, CONDITION, CONSEQUENCE, NEARNESS, OR, OTHER_CASE, SEVERAL, SOLUTION, WEAK,
    WHAT_IS_DONE,
};

/// The most bytes before a display that are taken for its words.
const LONGEST: usize = 400;

/// The number of displays over which the words of an earlier one hold.
const FAR_BACK: usize = 8;

/// The most words of a label.
const LONGEST_LABEL: usize = 3;

/// The most letters of words that say nothing of their own.
const GOES_ON: usize = 3;

/// Words that suppose nothing, though they contain others that do, and what they say.
const SUPPOSES_NOTHING: [(&str, &str); 14] = [
    ("in other words", "that is"),
    // The order of an equation is no approximation.
    ("equation of first order", "equation"),
    ("equation of the first order", "equation"),
    ("equations of first order", "equations"),
    ("first order equation", "equation"),
    ("first order differential", "differential"),
    // In Italian it is no "if" before a verb.
    (" si ottien", " ottien"),
    (" si trova", " trova"),
    (" si ha ", " ha "),
    ("smaller ", "lesser "),
    ("each other", "both"),
    ("one by the other", "both"),
    ("one from the other", "both"),
    ("one with the other", "both"),
];

/// What the words before a display announce.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Announced {
    /// A consequence.
    Consequence,
    /// An assumption, a choice, a special case.
    Assumption,
    /// A condition or an approximation, "if" or "small". What it is about may hold in general.
    Condition,
    /// Neither.
    Nothing,
}

impl Announced {
    /// Whether the words suppose something.
    pub fn is_supposed(self) -> bool {
        matches!(self, Announced::Assumption | Announced::Condition)
    }
}

/// The words before a display.
#[derive(Clone, Debug)]
pub(super) struct Words {
    /// What they announce.
    pub announced: Announced,
    /// Whether they speak of another case, as a charge of the opposite sign.
    pub other_case: bool,
    /// Whether they assume no more than that something is small or large, which says when A ≈ B holds.
    pub only_nearness: bool,
    /// The displays that they name, by their places, the first first.
    pub named: Vec<usize>,
    /// Whether the display is connected with what comes before it: a consequence, its solutions, or no words at all. After other
    /// words it may be another case, such as a motion in the opposite direction, which differs by a sign.
    pub connected: bool,
}

/// The words before the `at`-th display.
pub(super) fn before(notes: &Notes, at: usize) -> Words {
    looking_back(notes, at, FAR_BACK)
}

fn looking_back(notes: &Notes, at: usize, further: usize) -> Words {
    let text = &notes.source.text;
    let all = without_comments(&text[range(notes, at)]);
    let all = all.as_str();
    // `A \Rightarrow B`: what is supposed for A is no word about B.
    if [all, &notes.equations[at].text].into_iter().any(|text| implication(text).is_some()) {
        let other_case = at > 0 && further > 0 && looking_back(notes, at - 1, further - 1).other_case;
        let announced = Announced::Consequence;
        return Words { announced, other_case, only_nearness: false, named: Vec::new(), connected: true };
    }
    // Authors break lines anywhere.
    let words: Vec<String> = last_sentence(all).split_whitespace().map(str::to_lowercase).collect();
    let sentence =
        SUPPOSES_NOTHING.iter().fold(words.join(" ") + " ", |text, (words, meant)| text.replace(words, meant));
    let says = |words: &[&str]| words.iter().any(|word| has_word(&sentence, word));
    // "and" goes on as before.
    if at > 0 && further > 0 && sentence.chars().filter(|c| c.is_alphabetic()).count() <= GOES_ON {
        let before = looking_back(notes, at - 1, further - 1);
        let named = cited(notes, at, all).into_iter().chain(before.named).collect();
        return Words {
            announced: before.announced,
            named,
            only_nearness: before.only_nearness,
            connected: !before.announced.is_supposed(),
            other_case: before.other_case,
        };
    }
    // In English it is no word for what follows.
    let is_german_also = sentence.trim().trim_end_matches([',', ':']) == "also";
    let announced = match (says(ASSUMPTION), says(CONSEQUENCE) || is_german_also) {
        _ if asks_for_roots(&sentence) || says(&PASSING) => Announced::Assumption,
        (true, _) if says_only(WEAK, &sentence) => Announced::Condition,
        (true, _) => Announced::Assumption,
        (false, true) => Announced::Consequence,
        (false, false) => Announced::Nothing,
    };
    let connected = announced == Announced::Consequence
        || announced == Announced::Nothing && (says(SOLUTION) || is_another_form(&sentence));
    let compares = ["\\ll", "\\gg", "\\to"].iter().any(|sign| sentence.contains(sign));
    let is_nearness = |word: &&str| NEARNESS.contains(word) || compares && CONDITION.contains(word);
    let only_nearness =
        announced.is_supposed() && ASSUMPTION.iter().filter(|word| has_word(&sentence, word)).all(is_nearness);
    let other_case = says(OTHER_CASE) || supposes_anew(all);
    Words { announced, only_nearness, other_case, named: cited(notes, at, all), connected }
}

/// Whether a display is another form of the formula before it: "or, for the viscosity," and "…, or".
fn is_another_form(sentence: &str) -> bool {
    let bare: String = sentence.chars().map(|c| if c.is_alphanumeric() { c } else { ' ' }).collect();
    let words: Vec<&str> = bare.split_whitespace().collect();
    [words.first(), words.last()].into_iter().flatten().any(|word| OR.contains(word))
}

/// Whether the words since the last display put something else in the place of what was supposed: "Suppose now the force is …".
fn supposes_anew(words: &str) -> bool {
    let words = words.split_whitespace().map(str::to_lowercase).collect::<Vec<_>>().join(" ");
    ANEW.iter().any(|phrase| has_word(&words, phrase))
}

/// Whether the display is an equation for something that is sought: "the turning points are the roots of".
fn asks_for_roots(sentence: &str) -> bool {
    let sentence =
        sentence.trim().trim_end_matches([',', ':']).trim_end_matches(" the equation").trim_end_matches(" the");
    ROOTS_OF.iter().any(|words| sentence.ends_with(words))
}

/// Whether all words for what is supposed in a sentence are among some.
fn says_only(words: &[&str], sentence: &str) -> bool {
    ASSUMPTION.iter().filter(|word| has_word(sentence, word)).all(|word| words.contains(word))
}

/// The sentence before the `at`-th display, as it is printed.
pub(super) fn sentence(notes: &Notes, at: usize) -> String {
    let all = without_comments(&notes.source.text[range(notes, at)]);
    last_sentence(&all).to_owned()
}

/// The words between a display and the one before it, in small letters.
pub(super) fn words_since_last(notes: &Notes, at: usize) -> String {
    let words = without_comments(&notes.source.text[range(notes, at)]).to_lowercase();
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Whether a heading or a label of a few words stands before a display: "Pendulum:".
pub(super) fn is_labelled(notes: &Notes, at: usize) -> bool {
    let all = without_comments(&notes.source.text[range(notes, at)]);
    let sentence = last_sentence(&all).trim();
    let Some(label) = sentence.strip_suffix(':') else { return sentence.starts_with('#') };
    let has_verb = [CONSEQUENCE, ASSUMPTION].concat().iter().any(|word| has_word(&label.to_lowercase(), word));
    !label.is_empty() && label.split_whitespace().count() <= LONGEST_LABEL && !has_verb
}

/// What a display is about, if the sentence before it says so: the sphere of "for a sphere".
pub(super) fn object(notes: &Notes, at: usize) -> Option<String> {
    const BEFORE: [&str; 12] = [
        "for a ",
        "for an ",
        "for the ",
        "für ein ",
        "für eine ",
        "für einen ",
        "für die ",
        "pour un ",
        "pour une ",
        "pour la ",
        "para una ",
        "per una ",
    ];
    let words: Vec<String> = sentence(notes, at).split_whitespace().map(str::to_lowercase).collect();
    let sentence = words.join(" ");
    let after = BEFORE.iter().filter_map(|word| {
        let at = sentence.rfind(word).filter(|at| !sentence[..*at].ends_with(char::is_alphanumeric))?;
        Some(&sentence[at + word.len()..])
    });
    let noun = after.map(|rest| rest.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default()).next()?;
    (!noun.is_empty()).then(|| noun.to_owned())
}

/// The displays that the words before the `at`-th display cite.
fn cited(notes: &Notes, at: usize, words: &str) -> Vec<usize> {
    let mut named: Vec<usize> = Vec::new();
    for id in references(words) {
        for place in notes.find(id).into_iter().filter(|place| *place != at) {
            if !named.contains(&place) {
                named.push(place);
            }
        }
    }
    named
}

/// The bytes between a display and the one before it, or the last of these.
fn range(notes: &Notes, at: usize) -> Range<usize> {
    let text = &notes.source.text;
    let end = notes.equations[at].span.start;
    let displays = notes.equations[..at].iter().filter(|display| !is_inline(notes, display));
    let before = displays.map(|display| display.span.end).filter(|before| *before <= end).max();
    let mut start = before.unwrap_or(0).max(end.saturating_sub(LONGEST));
    while !text.is_char_boundary(start) {
        start += 1;
    }
    start..end
}

/// A text without the comments of TeX and Markdown.
fn without_comments(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("<!--") {
        kept.push_str(before);
        rest = after.split_once("-->").map_or("", |(_, after)| after);
    }
    kept.push_str(rest);
    let lines = kept
        .lines()
        .map(|line| line.find('%').filter(|at| !line[..*at].ends_with('\\')).map_or(line, |at| &line[..at]));
    lines.collect::<Vec<_>>().join("\n")
}

/// The sentence that ends with the display, or the last one before it.
fn last_sentence(text: &str) -> &str {
    let text = text.trim_end();
    let body = text.trim_end_matches(['.', ':', ',', ';']);
    let end = body.rmatch_indices(['.', '?', '!', '\n']).find(|(at, mark)| {
        let after = &body[at + mark.len()..];
        match *mark {
            "\n" => after.starts_with('\n') || after.starts_with('#') || text[..*at].ends_with('\n'),
            _ => after.starts_with(char::is_whitespace),
        }
    });
    end.map_or(text, |(at, mark)| &text[at + mark.len()..])
}

/// Whether a text has a word, or the beginning of one.
fn has_word(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(at, _)| !text[..at].ends_with(char::is_alphanumeric))
}

/// Whether the sentence before a display speaks of several things, or of a part of one: "three degrees of freedom give".
pub(super) fn speaks_of_several(notes: &Notes, at: usize) -> bool {
    let sentence = sentence(notes, at).to_lowercase();
    sentence.split(|c: char| !c.is_alphabetic()).any(|word| SEVERAL.contains(&word))
}

/// Whether a sentence since the last display begins with another thing, "A satellite on a circle is slower", and not with what is done,
/// "A short calculation gives". Other numbers may hold for it.
pub(super) fn brings_another_thing(notes: &Notes, at: usize) -> bool {
    let words = words_since_last(notes, at);
    words.split(['.', '?', '!']).any(|sentence| {
        let sentence = sentence.trim_start();
        let noun = ANOTHER_THING.iter().find_map(|article| sentence.strip_prefix(article));
        noun.is_some_and(|noun| !WHAT_IS_DONE.iter().any(|word| noun.starts_with(word)))
    })
}

/// Whether no sentence ends between a formula and a display.
pub(super) fn is_in_last_sentence(notes: &Notes, formula: Span, display: usize) -> bool {
    let between = &notes.source.text[formula.end..display];
    last_sentence(between).len() == between.trim_end().len()
}

/// The numbers and labels that a text cites.
fn references(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for command in ["\\eqref{", "\\ref{", "\\cref{", "\\Cref{", "\\autoref{"] {
        for (at, _) in text.match_indices(command) {
            if let Some((label, _)) = text[at + command.len()..].split_once('}') {
                found.push((at, label));
            }
        }
    }
    for (at, _) in text.match_indices('(') {
        if let Some((number, _)) = text[at + 1..].split_once(')')
            && number.len() <= 8
            && number.starts_with(|c: char| c.is_ascii_alphanumeric())
        {
            found.push((at, number));
        }
    }
    found.sort_unstable();
    found.into_iter().map(|(_, id)| id).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_sentence_decides() {
        assert_eq!(last_sentence("Let $x$ be small. Then we get"), " Then we get");
        assert_eq!(last_sentence("# Springs\n\nWe find"), "We find");
        assert!(has_word("hence we", "hence"));
        assert!(!has_word("whence we", "hence"));
    }

    #[test]
    fn labels_and_numbers_are_references() {
        assert_eq!(references(r"From \eqref{newton} and (3) of the text"), ["newton", "3"]);
    }
}
