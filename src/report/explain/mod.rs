//! What a verdict and a code mean: the text of `onshell explain`.
//!
//! The explanations of the codes are in [`crate::code`], those of the verdicts in [`verdicts`]. Each has an example in
//! [`examples`]: files that get this verdict or code. A test runs them as they are printed.
//!
//! Offers [`topic`], the text on a verdict or a code. Knows the codes and verdicts, and nothing of a document.

mod examples;
mod verdicts;

use crate::check::Verdict;
use crate::check::mutation::MutantOutcome;
use crate::code::Code;

use super::style::{Style, columns};
use super::wrap::wrap;
use examples::Example;
use verdicts::{of_outcome, of_verdict};

/// Something that can be explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// A verdict on an equation or a sentence.
    Verdict(Verdict),
    /// What became of a mutant in mutation testing.
    Mutant(MutantOutcome),
    /// A class of messages.
    Code(Code),
}

/// What can become of a mutant, without `refuted`, which means what the verdict of this name means.
const OUTCOMES: [MutantOutcome; 3] = [MutantOutcome::Refused, MutantOutcome::Equivalent, MutantOutcome::Survived];

impl Topic {
    /// Everything that can be explained: the verdicts, from the best to the worst; the outcomes of mutants; and the
    /// codes by the alphabet.
    pub fn all() -> impl Iterator<Item = Topic> {
        let mut codes = Code::ALL.to_vec();
        codes.sort_by_key(|code| code.word());
        let outcomes = OUTCOMES.into_iter().map(Topic::Mutant);
        Verdict::ALL.into_iter().map(Topic::Verdict).chain(outcomes).chain(codes.into_iter().map(Topic::Code))
    }

    /// What a word names: a verdict, a code, both, or nothing.
    pub fn named(word: &str) -> Vec<Topic> {
        Topic::all().filter(|topic| topic.word() == word).collect()
    }

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Topic::Verdict(verdict) => verdict.word(),
            Topic::Mutant(outcome) => outcome.word(),
            Topic::Code(code) => code.word(),
        }
    }

    /// What it means, and what to do: Markdown. The first sentence says what it means.
    pub fn explanation(self) -> &'static str {
        match self {
            Topic::Verdict(verdict) => of_verdict(verdict),
            Topic::Mutant(outcome) => of_outcome(outcome),
            Topic::Code(code) => code.explanation(),
        }
    }
}

/// The explanation of a topic.
pub fn topic(topic: Topic, style: Style) -> String {
    let kind = match topic {
        Topic::Verdict(verdict) if verdict.passes() => "verdict, passes",
        Topic::Verdict(_) => "verdict, does not pass",
        Topic::Mutant(_) => "outcome of a mutant",
        Topic::Code(_) => "code of a message",
    };
    format!("{} ({kind})\n\n{}", topic.word(), paragraphs(topic.explanation(), style))
}

/// The example of a word that can be explained.
pub fn example(word: &str, style: Style) -> String {
    Example::of(word).map_or_else(String::new, |example| example.text(style))
}

/// All topics, a line each.
pub fn all(style: Style) -> String {
    let width = Topic::all().map(|topic| columns(topic.word())).max().unwrap_or(0);
    let line = |topic: Topic| {
        let text = topic.explanation().trim();
        let first = text.split_once(".\n").map_or(text, |(first, _)| first).trim_end_matches('.');
        wrap(&format!("  {:<width$}  ", topic.word()), &first.replace('\n', " "), width + 4, style.width) + "\n"
    };
    let of = |is_wanted: fn(&Topic) -> bool| Topic::all().filter(is_wanted).map(line).collect::<String>();
    format!(
        "Verdicts:\n{}\nOutcomes of mutants (onshell mutate):\n{}\nCodes of messages:\n{}",
        of(|topic| matches!(topic, Topic::Verdict(_))),
        of(|topic| matches!(topic, Topic::Mutant(_))),
        of(|topic| matches!(topic, Topic::Code(_)))
    )
}

/// Markdown in lines that fit: its paragraphs.
fn paragraphs(markdown: &str, style: Style) -> String {
    let mut blocks = vec![String::new()];
    for line in markdown.lines().map(str::trim) {
        match blocks.last_mut() {
            Some(last) if !line.is_empty() => *last += &format!("{}{line}", if last.is_empty() { "" } else { " " }),
            _ => blocks.push(String::new()),
        }
    }
    let blocks: Vec<String> = blocks.iter().map(|block| wrap("", block, 0, style.width) + "\n").collect();
    blocks.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_found() {
        for topic in Topic::all() {
            assert!(Topic::named(topic.word()).contains(&topic), "{topic:?}");
        }
        // A word may be a verdict and a code, and no more.
        let verdicts = Topic::named("definition");
        assert_eq!(verdicts, [Topic::Verdict(Verdict::Definition), Topic::Code(Code::Definition)]);
        assert_eq!(Topic::named("refutd"), []);
    }

    #[test]
    fn every_explanation_fits() {
        for width in [80, 120] {
            let style = Style::new(width, false);
            for topic in Topic::all() {
                let text = super::topic(topic, style);
                assert!(text.lines().all(|line| columns(line) <= width), "{text}");
                assert!(paragraphs(topic.explanation(), style).ends_with(".\n"), "{text}");
            }
            assert!(all(style).lines().all(|line| columns(line) <= width), "{}", all(style));
        }
    }

    #[test]
    fn every_topic_has_one_example_and_no_other_word_has() {
        let words: Vec<&str> = Topic::all().map(Topic::word).collect();
        for word in &words {
            assert_eq!(Example::all().filter(|example| example.word == *word).count(), 1, "{word}");
        }
        assert!(Example::all().all(|example| words.contains(&example.word)));
    }

    /// What a text quotes in backticks in its sentence that begins with “For example”.
    fn quoted(explanation: &str) -> Vec<String> {
        let text = explanation.replace("\n ", " ");
        let Some((_, after)) = text.split_once("For example, ") else { return Vec::new() };
        let mut parts = after.split('`');
        let mut quotes = Vec::new();
        while let (Some(words), Some(quote)) = (parts.next(), parts.next()) {
            // A point that a new sentence follows ends the example.
            if words.contains(". ") {
                break;
            }
            quotes.push(quote.split_whitespace().collect());
        }
        quotes
    }

    #[test]
    fn what_an_explanation_quotes_stands_in_its_example() {
        let stands = |quote: &str, example: &Example| {
            let files: String = example.files.iter().map(|(_, text)| *text).chain([example.command]).collect();
            files.split_whitespace().collect::<String>().contains(quote)
        };
        for topic in Topic::all() {
            let example = Example::of(topic.word()).unwrap();
            for quote in quoted(topic.explanation()) {
                assert!(stands(&quote, example), "{}: {quote}", topic.word());
            }
        }
        // What an example does not contain is noticed.
        let example = Example::of("sides-differ").unwrap();
        let sentence = "Two sides differ.\n\n For example, `(a + b)^2 = a^2 + c^2` does. Correct it, as in `x = y`.";
        assert!(quoted(sentence).iter().any(|quote| !stands(quote, example)));
        assert_eq!(quoted(sentence).len(), 1);
    }

    #[test]
    fn the_list_has_a_line_for_each() {
        let listed = all(Style::PLAIN);
        for topic in Topic::all() {
            let is_of_it =
                |line: &&str| line.strip_prefix("  ").and_then(|line| line.split(' ').next()) == Some(topic.word());
            assert_eq!(listed.lines().filter(is_of_it).count(), Topic::named(topic.word()).len(), "{listed}");
        }
    }
}
