//! Where sections, examples and paragraphs about another system begin in a text.
//!
//! A heading begins a section. An example, an exercise or a problem begins with a heading, an environment, a block between colons, or
//! with its word at the beginning of a paragraph: "Second example. …". A paragraph that begins with "Consider now a …" may
//! begin another system, and begins no section.

use crate::notes::Notes;

/// The level of a heading that does not say its level.
pub(super) const LOWEST: usize = 9;

/// The level of bold words with which a paragraph begins: "**4. Dipole.** From the potential …".
pub(super) const RUN_IN: usize = 10;

/// The level of a paragraph that is the name of a thing, "Pendulum:", and of one that begins with the word for an example.
const LABEL: usize = 11;

/// The level of words about another system at the beginning of a paragraph.
const SPOKEN: usize = 12;

/// The most words of a paragraph that is the name of a thing.
const LABEL_WORDS: usize = 2;

/// Words with which such a name does not begin.
const NO_LABEL: [&str; 46] = [
    "then",
    "so",
    "thus",
    "hence",
    "with",
    "where",
    "and",
    "or",
    "here",
    "also",
    "finally",
    "now",
    "let",
    "if",
    "for",
    "at",
    "in",
    "from",
    "by",
    "on",
    "to",
    "as",
    "it",
    "this",
    "that",
    "which",
    "we",
    "solution",
    "result",
    "answer",
    "check",
    "proof",
    "note",
    "therefore",
    "consequently",
    "second",
    "first",
    "next",
    "using",
    "substituting",
    "solving",
    "again",
    "daraus",
    "damit",
    "donc",
    "ainsi",
];

/// Words with which such a name does not end: it states something about the system at hand, "Quantum condition:".
const STATES: [&str; 14] = [
    "condition",
    "conditions",
    "conservation",
    "balance",
    "continuity",
    "normalisation",
    "normalization",
    "quantisation",
    "quantization",
    "definition",
    "identity",
    // other languages
    "bedingung",
    "erhaltung",
    "normierung",
];

/// Words for an example. The others are names of other things too, as in "Problem statement": after them a number or a sign must stand.
const EXAMPLE: [&str; 7] = ["example", "beispiel", "exemple", "ejemplo", "esempio", "exemplo", "例"];
const NUMBERED: [&str; 8] =
    ["exercise", "problem", "question", "aufgabe", "exercice", "ejercicio", "problema", "esercizio"];

/// Words that may stand before the word for an example.
const BEFORE_EXAMPLE: [&str; 24] = [
    "a",
    "an",
    "as",
    "our",
    "the",
    "worked",
    "first",
    "second",
    "third",
    "fourth",
    "fifth",
    "another",
    "next",
    "last",
    "final",
    "further",
    "erstes",
    "zweites",
    "drittes",
    "weiteres",
    "premier",
    "deuxième",
    "primer",
    "segundo",
];

/// The beginnings of paragraphs about another system.
const ANOTHER_SYSTEM: [&str; 22] = [
    "consider ",
    "now consider ",
    "next consider ",
    "next, consider ",
    "now, consider ",
    "let us consider ",
    "let us now consider ",
    "let us next consider ",
    "we consider ",
    "we now consider ",
    "next we consider ",
    "now we consider ",
    "now take a",
    "next take a",
    "a second system",
    "a third system",
    "betrachte",
    "wir betrachten ",
    "nun betrachten wir ",
    "considérons ",
    "consideremos ",
    "consideriamo ",
];

/// Words and their beginnings in the heading of a step: it is about the system that was treated before.
const STEPS: [&str; 58] = [
    "equation",
    "motion",
    "small",
    "oscillation",
    "solution",
    "solving",
    "moment",
    "energ",
    "conserv",
    "hamilton",
    "euler",
    "lagrang",
    "equilib",
    "linear",
    "period",
    "frequen",
    "mode",
    "deriv",
    "discussion",
    "result",
    "stability",
    "limit",
    "approx",
    "check",
    "symmetr",
    "constraint",
    "force",
    "analysis",
    "numer",
    "coordinate",
    "kinetic",
    "potential",
    "summary",
    "conclusion",
    "remark",
    "note",
    "position",
    "velocit",
    "acceler",
    "tension",
    "orbit",
    "trajector",
    "special case",
    "bewegung",
    "lösung",
    "gleichung",
    "impuls",
    "erhaltung",
    "schwingung",
    "näherung",
    "mouvement",
    "équation",
    "movimiento",
    "ecuaci",
    "solución",
    "方程",
    "运动",
    "運動",
];

/// Where a section, an example or a paragraph about another system begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Mark {
    /// The place of its first display among the displays; in a text, its first byte.
    pub at: usize,
    /// The level of its heading: 1 for the highest one.
    pub level: usize,
    /// The level of the last heading before its first display.
    pub lowest: usize,
    /// The level of the heading of an example, if it begins one.
    pub example: Option<usize>,
    /// Whether its words are about a step in the treatment of a system: "Equations of motion".
    pub is_step: bool,
}

impl Mark {
    /// Whether a section begins here, and not only a paragraph about another system.
    pub fn begins_a_section(&self) -> bool {
        self.level < SPOKEN
    }

    /// Whether the Lagrangian after it may be that of another system. A label may name a quantity: "Kinetic energy:".
    pub fn may_begin_a_system(&self) -> bool {
        self.level != LABEL || self.example.is_some()
    }
}

/// The displays of notes with which something begins, in order.
pub(super) fn marks(notes: &Notes) -> Vec<Mark> {
    let mut found: Vec<Mark> = Vec::new();
    let mut displays = notes.equations.iter().enumerate().peekable();
    for mark in headings(&notes.source.text) {
        let mut is_inside = false;
        while let Some((_, display)) = displays.next_if(|(_, display)| display.span.start < mark.at) {
            is_inside = display.span.end > mark.at;
        }
        // A row of a display may look like the line under a heading.
        if is_inside {
            continue;
        }
        match (displays.peek(), found.last_mut()) {
            (Some((at, _)), Some(last)) if last.at == *at => {
                last.level = mark.level.min(last.level);
                last.lowest = mark.level;
                last.example = mark.example.or(last.example);
                last.is_step &= mark.is_step;
            }
            (Some((at, _)), _) => found.push(Mark { at: *at, ..mark }),
            (None, _) => {}
        }
    }
    found
}

/// The places of headings in a text, with their levels: of Markdown, as which other formats are read, and of TeX.
fn headings(text: &str) -> Vec<Mark> {
    let (mut found, mut start, mut before) = (Vec::new(), 0, "");
    for line in text.split_inclusive('\n') {
        let content = line.trim();
        let is_underline = content.len() >= 3
            && content.starts_with(['=', '-'])
            && content.bytes().all(|byte| content.starts_with(char::from(byte)))
            && before.len() > 1
            && before.len() <= content.len();
        let marked = content.trim_start_matches('#');
        let is_marked = marked.len() < content.len() && content.len() - marked.len() <= 6 && marked.starts_with(' ');
        let commands = ["\\part{", "\\chapter{", "\\section{", "\\subsection{", "\\subsubsection{"];
        let plain = content.replace('*', "");
        let command = commands.iter().position(|command| plain.starts_with(command));
        let environments = ["\\begin{exercise", "\\begin{problem", "\\begin{example", "\\begin{solution"];
        let environment = environments.iter().position(|begin| content.starts_with(begin));
        let begins_paragraph = before.is_empty() || ends_display(before);
        let level = match command {
            Some(level) => Some(level + 1),
            None if is_marked => Some(content.len() - marked.len()),
            None if is_underline || environment.is_some() || is_block_of_an_example(content) => Some(LOWEST),
            None if before.is_empty() && is_run_in(content) => Some(RUN_IN),
            None if begins_paragraph && (names_an_example(content) || is_label(content)) => Some(LABEL),
            None => (begins_paragraph && is_about_another_system(content)).then_some(SPOKEN),
        };
        // The words of an underlined heading stand before it.
        let words = if is_underline { before } else { content };
        let is_example =
            environment.is_some_and(|at| at < 3) || is_block_of_an_example(content) || names_an_example(words);
        // "Second example. The potential …" begins a system.
        let is_step = !is_example && is_step(words);
        let example = level.filter(|_| is_example);
        found.extend(level.map(|level| Mark { at: start, level, lowest: level, example, is_step }));
        (start, before) = (start + line.len(), content);
    }
    found
}

/// Whether a line ends a display.
fn ends_display(line: &str) -> bool {
    line.ends_with("$$") || line.ends_with("\\]") || line.starts_with("\\end{") || line.starts_with("```")
}

/// Whether a paragraph that begins with this line begins with a heading of its own.
fn is_run_in(line: &str) -> bool {
    let line = line.trim_start_matches("\\noindent").trim_start();
    let is_bold = line.strip_prefix("**").is_some_and(|rest| rest.contains("**"));
    is_bold
        || ["\\textbf{", "\\paragraph{", "\\subparagraph{"]
            .iter()
            .any(|command| line.replace('*', "").starts_with(command))
}

/// Whether a line begins a block between colons with an example in it: `::::{admonition} Example 3`, `::: {#exm-bead}`.
fn is_block_of_an_example(line: &str) -> bool {
    let directive = line.strip_prefix(".. ");
    let Some(rest) = line.strip_prefix(":::").or(directive).map(str::to_lowercase) else { return false };
    ["example", "#exm-", ".exm", "exercise", "#exr-", "problem"].iter().any(|word| rest.contains(word))
}

/// The words of a line, without the marks of its heading, in small letters.
fn words_of(line: &str) -> String {
    let line = line.trim_start_matches("\\noindent").trim_start();
    let inner = match line.strip_prefix('\\') {
        Some(command) => command.split_once('{').map_or(line, |(_, inner)| inner),
        None => line,
    };
    inner.trim_start_matches(|c: char| !c.is_alphabetic()).to_lowercase()
}

/// Whether the words of a line begin with that for an example.
fn names_an_example(line: &str) -> bool {
    let line = words_of(line);
    let mut rest = line.as_str();
    for _ in 0..3 {
        let is_end = |rest: &str| rest.chars().next().is_none_or(|next| !next.is_alphabetic());
        let is_numbered = |rest: &str| {
            let next = rest.trim_start().chars().next();
            next.is_none_or(|next| next.is_ascii_digit() || ".:()}*".contains(next))
        };
        let after = |words: &[&str]| words.iter().find_map(|word| rest.strip_prefix(word));
        if after(&EXAMPLE).is_some_and(|rest| is_end(rest) || line.starts_with('例'))
            || after(&NUMBERED).is_some_and(is_numbered)
        {
            return true;
        }
        match rest.split_once(' ') {
            Some((word, more)) if BEFORE_EXAMPLE.contains(&word) => rest = more.trim_start(),
            _ => return false,
        }
    }
    false
}

/// Whether the words of a heading are about a step in the treatment of a system.
fn is_step(heading: &str) -> bool {
    let heading = heading.to_lowercase();
    STEPS.iter().any(|word| heading.contains(word))
}

/// Whether a line is the name of a thing, as a heading would be: "Pendulum:".
fn is_label(line: &str) -> bool {
    let Some(name) = line.strip_suffix(':') else { return false };
    let words: Vec<String> = name.split_whitespace().map(str::to_lowercase).collect();
    let is_word = |word: &String| word.chars().all(|c| c.is_alphabetic() || c == '-');
    name.starts_with(char::is_uppercase)
        && words.len() <= LABEL_WORDS
        && words.iter().all(is_word)
        && words.first().is_some_and(|first| !NO_LABEL.contains(&first.as_str()))
        && words.last().is_some_and(|last| !STATES.iter().any(|word| last.ends_with(word)))
}

/// Whether a paragraph that begins with this line may be about another system.
fn is_about_another_system(line: &str) -> bool {
    let line = words_of(line);
    ANOTHER_SYSTEM.iter().any(|words| line.starts_with(words))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(text: &str) -> Vec<(usize, usize)> {
        headings(text).iter().map(|mark| (mark.at, mark.level)).collect()
    }

    #[test]
    fn headings_of_each_format_are_found_and_rules_are_not() {
        assert_eq!(places("# A\n\ntext\n## B\n"), [(0, 1), (10, 2)]);
        assert_eq!(places("text\n\\section*{A}\n"), [(5, 3)]);
        assert_eq!(places("Name\n----\n"), [(5, LOWEST)]);
        assert_eq!(places("text\n\n**2. Dipole.** The field\n"), [(6, RUN_IN)]);
        assert_eq!(places("\\paragraph{Force}\n"), [(0, RUN_IN)]);
        assert!(headings("text\n\n---\n#tag\n= 3\n").is_empty());
        assert!(headings("a\n**b** c\n\nthe **d** e\n").is_empty());
        assert!(headings("a = b\n").is_empty());
    }

    #[test]
    fn examples_are_told_from_other_words() {
        for line in [
            "## Example 2: a bead",
            "**Worked example.** A bead",
            "Second example. The potential",
            "\\subsection{Exercise 3}",
            "\\begin{example}[Bead]",
            "::::{admonition} Example 6.8: A bead",
            "::: {#exm-bead}",
            "### 6.3 Beispiel",
            "Problem 4. A bead",
        ] {
            assert!(headings(line).first().is_some_and(|mark| mark.example.is_some() && !mark.is_step), "{line}");
        }
        for line in [
            "## Examples",
            "## Problem statement",
            "# The two-body problem",
            "\\begin{solution}",
            "::: {.callout-note}",
        ] {
            assert!(!headings(line).iter().any(|mark| mark.example.is_some()), "{line}");
        }
        assert!(headings("### Equations of motion").first().is_some_and(|mark| mark.is_step));
        assert_eq!(places("Consider now a bead on a wire.\n"), [(0, SPOKEN)]);
        assert!(places("text\nconsider a bead\n").is_empty());
        assert_eq!(places("Pendulum:\n"), [(0, LABEL)]);
        assert!(places("Then:\n\nthe pendulum:\n\nThe period of it:\n").is_empty());
        assert!(places("Quantum condition:\n\nEnergy balance:\n\nEnergieerhaltung:\n").is_empty());
    }
}
