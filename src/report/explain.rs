//! What a verdict and a code mean: the text of `onshell explain`.
//!
//! The explanations of the codes are in [`crate::code`]; those of the verdicts are here, in one table.

use crate::check::Verdict;
use crate::check::mutation::MutantOutcome;
use crate::code::Code;

use super::style::{Style, columns};
use super::wrap::wrap;

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

    /// What it means, an example, and what to do: Markdown. The first sentence says what it means.
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

/// Markdown in lines that fit: paragraphs are wrapped; lines with an indent of four are kept as they are.
fn paragraphs(markdown: &str, style: Style) -> String {
    let mut blocks: Vec<String> = Vec::new();
    let mut open = false;
    for line in markdown.lines() {
        let line = line.strip_prefix(' ').filter(|line| !line.starts_with("   ")).unwrap_or(line);
        match (line.trim().is_empty(), line.starts_with("    "), blocks.last_mut()) {
            (true, ..) => open = false,
            (false, true, _) => {
                open = false;
                blocks.push(line.to_owned());
            }
            (false, false, Some(last)) if open => *last += &format!(" {line}"),
            (false, false, _) => {
                open = true;
                blocks.push(line.to_owned());
            }
        }
    }
    let mut text = String::new();
    let mut was_example = false;
    for block in blocks {
        let is_example = block.starts_with("    ");
        let continues = is_example && was_example;
        if !text.is_empty() && !continues {
            text.push('\n');
        }
        let line = if is_example { block } else { wrap("", &block, 0, style.width) };
        text.push_str(&line);
        text.push('\n');
        was_example = is_example;
    }
    text
}

/// What an outcome of a mutant means.
fn of_outcome(outcome: MutantOutcome) -> &'static str {
    match outcome {
        MutantOutcome::Refuted => of_verdict(Verdict::Refuted),
        MutantOutcome::Refused => {
            r"The mutant was detected, because it cannot be read or claims too little.

The equation with this mistake in it is ambiguous, has units or shapes that do not fit, or is the same on both sides.

For example, this mutant of a definition is refused, because a name cannot be defined by itself:

    p = m p

There is nothing to do."
        }
        MutantOutcome::Equivalent => {
            r"The mutant is as true as the original, so no check could detect it.

It reads the same, or exact arithmetic shows that both are equal.

For example, these two are equivalent:

    |a - b| = |b - a|
    |-a + b| = |b - a|

There is nothing to do."
        }
        MutantOutcome::Survived => {
            r"The mutant passes: a mistake like this in the equation would not be detected.

The report gives the place of the mistake, the change, and why it passes.

For example, with x declared as positive, the second survives as a mutant of the first:

    x^2 \geq 0
    x^3 \geq 0

Widen the ranges or remove hypotheses; for a definition, use the defined name in one more equation."
        }
    }
}

/// What a verdict means.
fn of_verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Certified => {
            r"The equation holds, and exact arithmetic confirms it.

The equation was `verified` first. Then it was decided over a prime field, where numbers are exact.
The report gives a bound on the probability that the decision is an accident: at most 2^-80.

For example, this identity is certified:

    \sin 2x = 2 \sin x \cos x

There is nothing to do."
        }
        Verdict::Verified => {
            r"The equation holds at every sampled state.

The states also tell it from its mutants: the same equation with one mistake in it fails at one of them.
A prime field cannot decide it; `onshell check --verbose` says why.

For example, this equation is verified and not certified, because of the logarithm:

    \ln(a^7) = 7 \ln a

There is nothing to do."
        }
        Verdict::Definition => {
            r"The equation defines a symbol that other equations use.

A definition cannot be wrong by itself. It passes if each mistake in it makes another checked equation fail,
or if the claims file lists the symbol under `define`.

For example, the first equation is a definition, because the second one tests it:

    p = m v
    p v = m v^2

There is nothing to do."
        }
        Verdict::Law => {
            r#"The equation is a law that the claims file declares.

A law is assumed and cannot be checked here. The equations that need it are checked with it, and say so.

For example, the claims file declares equation (1) as Newton's second law:

    { "laws": { "Newton's second law": "1" } }

Check by eye that a law is printed correctly."#
        }
        Verdict::Assumed => {
            r"The display does not follow from the others, and it is taken for granted.

This verdict is given in notes without a claims file. A law, a condition or a value cannot follow from anything.
The display would be called wrong if one likely slip lay between it and an equation that is certified.

For example, in `F = m a`, all three letters are known from other displays.

Check by eye that it is printed correctly, or write a claims file that says what must be checked."
        }
        Verdict::Unclaimed => {
            r#"The equation has a number, and the claims file leaves it out with `skip`.

For example, the claims file skips an integral that is not read:

    { "equations": { "10": { "skip": "an integral" } } }

Remove `skip` to have it checked."#
        }
        Verdict::Undecided => {
            r"The equation could not be decided.

Too few sampled states gave a number, or the states cannot tell the equation from a wrong one.
A definition that no other equation uses is undecided too.

For example, no sampled state has x > 5000, so this equation is undecided:

    \ln(x - 5000) = \ln(x - 5000) + 1

Narrow the ranges in the claims file, add a condition under `assume`, or use the defined symbol once more."
        }
        Verdict::Domain => {
            r"The two sides agree, but only one is defined everywhere.

For example, the right side has a value at x = 1, and the left side has none:

    \frac{x^2 - 1}{x - 1} = x + 1

State where the equation holds: narrow the range of a symbol, or add a condition under `assume`."
        }
        Verdict::Unreadable => {
            r"The equation could not be read.

The formula is ambiguous, is not well-formed, uses a name that is not declared, or has shapes that do not fit.
The message gives the place and the reason.

For example, the end of the cosine's argument is ambiguous here:

    \cos\theta p_\psi

Correct the formula, or declare the name in the claims file."
        }
        Verdict::Refuted => {
            r"The equation is wrong: it fails at a state that is shown.

The report gives the values of both sides there, their difference where it is short, and likely corrections.

For example, a pendulum whose angle starts at the downward vertical refutes this sign:

    \ddot\theta = \frac{g}{l} \sin\theta

Correct the equation. If the mistake is known and stays, write `expect` and `because` in the claims file."
        }
    }
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
    fn every_explanation_fits_and_each_verdict_has_an_example() {
        for width in [80, 120] {
            let style = Style::new(width, false);
            for topic in Topic::all() {
                let text = super::topic(topic, style);
                assert!(text.lines().all(|line| columns(line) <= width), "{text}");
                assert!(text.ends_with(".\n"), "{text}");
                assert!(matches!(topic, Topic::Code(_)) || text.contains("For example, "), "{text}");
            }
            assert!(all(style).lines().all(|line| columns(line) <= width), "{}", all(style));
        }
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
