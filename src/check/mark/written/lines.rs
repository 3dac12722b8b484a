//! The lines of a hand-in in their order, with what the words before each say of it.

use crate::latex::Macros;
use crate::latex::foreign;
use crate::latex::lines::{self, lines};
use crate::notes::{Display, Notes};
use crate::source::Span;

use super::units::with_single_units;

/// A line as it was written.
#[derive(Clone, Debug)]
pub(in crate::check::mark) struct Written {
    /// Its line in the file, from 1.
    pub line: usize,
    /// Its name.
    pub name: String,
    /// The number or label of its display.
    pub id: Option<String>,
    /// Its bytes in the file.
    pub span: Span,
    /// The bytes that are read: with the member that it continues.
    pub body: Span,
    /// What is read.
    pub text: String,
    /// The line, by its place, of which it continues the chain.
    pub continues: Option<usize>,
    /// Whether it stands inside the text.
    pub inline: bool,
    /// Whether a word before it says that it is a condition.
    pub is_supposed: bool,
    /// Whether a word before it says that it is tried as a solution.
    pub is_tried: bool,
    /// Whether a word such as "if", close before it, makes it a special case.
    pub is_if: bool,
    /// Whether the words before it say that values for an example come.
    pub is_example: bool,
    /// Whether "or" stands between it and the line before it.
    pub is_alternative: bool,
    /// Whether the words before it say that it is about the start of the motion.
    pub is_at_start: bool,
    /// Whether the words before it say that something is largest or smallest there.
    pub is_extremum: bool,
    /// Whether the text before it speaks of such a place.
    pub is_after_extremum: bool,
    /// Whether the text before it speaks of rest or of an equilibrium.
    pub is_at_rest: bool,
    /// Whether the text before it says that something is small.
    pub is_near: bool,
    /// The limit that its sentence names, `M \to \infty`.
    pub limit: Option<String>,
    /// Edits of what is read that make it readable.
    pub edits: Vec<(Span, String)>,
}

/// Words before a display that make it a condition.
const SUPPOSED: [&str; 14] = [
    "assum",
    "suppose",
    "let ",
    "given",
    "initial",
    "where ",
    "at rest",
    "condition",
    "choose",
    "set ",
    "when ",
    "if ",
    "for small",
    "limit",
];

/// Words that say that quantities are small, in some languages.
const SMALL: [&str; 17] = [
    "small",
    "klein",
    "petit",
    "peque",
    "piccol",
    "mały",
    "małe",
    "ma\\l",
    "linear",
    "linéar",
    "first order",
    "erster ordnung",
    "ersten ordnung",
    "premier ordre",
    "primer orden",
    "primo ordine",
    "\\ll",
];

/// All lines of a hand-in, in their order.
pub(in crate::check::mark) fn written(notes: &Notes, macros: &Macros) -> Vec<Written> {
    let text = &notes.source.text;
    let displays = notes.equations.iter().map(|display| (display.body, display.text.clone(), Some(display)));
    let inline = notes.inline.iter().filter_map(|span| {
        let whole = text.get(span.range())?;
        let marks = if whole.starts_with('$') { 1 } else { 2 };
        let body = Span::new(span.start + marks, span.end.checked_sub(marks)?);
        Some((body, text.get(body.range())?.to_owned(), None))
    });
    let mut all: Vec<(Span, String, Option<&Display>)> = displays.chain(inline).collect();
    all.sort_by_key(|(body, ..)| body.start);
    let mut found: Vec<Written> = Vec::new();
    for (body, read, display) in all {
        let read = foreign::separated(&with_single_units(&read));
        let statements: Vec<lines::Line> = match display {
            Some(_) => lines(&read, macros),
            None => lines(&read, macros).into_iter().filter(|line| line.is_statement).collect(),
        };
        let whole = || vec![lines::Line { span: Span::new(0, read.len()), from: None, is_statement: true }];
        let is_cut =
            |line: &lines::Line| balanced(&read[line.from.map_or(line.span, |from| from.to(line.span)).range()]);
        let statements = match display {
            Some(_) if statements.is_empty() || !statements.iter().all(is_cut) => whole(),
            _ => statements,
        };
        let mut start = found.len();
        for statement in statements {
            let span = statement.span.shifted(body.start);
            let of = statement.from.map_or(statement.span, |from| from.to(statement.span));
            if statement.from.is_none() {
                start = found.len();
            }
            let (line, _) = notes.source.line_column(span.start);
            let before = found.iter().filter(|other| other.line == line).count();
            let letter =
                (b'a'..=b'z').nth(before).map_or_else(|| format!(".{before}"), |letter| char::from(letter).to_string());
            found.push(Written {
                line,
                name: if before == 0 { format!("line {line}") } else { format!("line {line}{letter}") },
                id: display.and_then(Display::id).map(str::to_owned),
                span,
                body: of.shifted(body.start),
                text: read[of.range()].to_owned(),
                continues: (statement.from.is_some() && start < found.len()).then_some(start),
                inline: display.is_none(),
                is_supposed: says_any(text, display.map_or(body.start, |display| display.span.start), &SUPPOSED),
                is_tried: is_tried(text, display.map_or(body.start, |display| display.span.start)),
                is_if: is_if(text, display.map_or(body.start, |display| display.span.start)),
                is_example: is_example(text, display.map_or(body.start, |display| display.span.start)),
                is_alternative: found.last().is_some_and(|before: &Written| {
                    text.get(before.span.end..span.start).is_some_and(foreign::says_or)
                }),
                is_at_start: says_any(text, display.map_or(body.start, |display| display.span.start), &START),
                is_extremum: says_any(text, display.map_or(body.start, |display| display.span.start), &EXTREMUM),
                is_after_extremum: {
                    let before = text[..span.start].to_lowercase();
                    EXTREMUM.iter().any(|word| before.contains(word))
                },
                is_at_rest: {
                    let before = text[..span.start].to_lowercase();
                    REST.iter().any(|word| before.contains(word))
                },
                is_near: SMALL.iter().any(|word| text[..span.start].to_lowercase().contains(word)),
                limit: limit(text, display.map_or(span, |display| display.span), display.is_none()),
                edits: Vec::new(),
            });
        }
    }
    found
}

/// The limit that a formula in the text beside a line names: before it, or behind a line in the text, in the same sentence.
fn limit(text: &str, line: Span, is_inline: bool) -> Option<String> {
    let ends = |text: &str, at: usize| text[at..].starts_with(". ") || text[at..].starts_with("\n\n");
    let before = text.get(..line.start)?.trim_end();
    let start = before.char_indices().rev().map(|(at, _)| at).find(|at| ends(before, *at));
    let after = text.get(line.end..).filter(|_| is_inline).unwrap_or_default();
    let end = after.char_indices().map(|(at, _)| at).find(|at| ends(after, *at)).unwrap_or(after.len());
    let formulas = [&before[start.map_or(0, |at| at + 1)..], &after[..end]];
    let mut all = formulas.iter().flat_map(|text| text.split('$'));
    let is_limit = |formula: &&str| formula.contains("\\to") && !formula.contains(['=', '\n']);
    let limit = all.rfind(is_limit)?;
    Some(limit.trim().replace("\\to", " \\to "))
}

/// Words for "if", in some languages.
const IF: [&str; 29] = [
    "if", "when", "whenever", "case", "wenn", "falls", "fall", "gdy", "jeśli", "jeżeli", "si", "cuando", "caso",
    "lorsque", "quand", "cas", "se", "quando", "hvis", "om", "når", "als", "unless", "provided", "such", "tel",
    "telle", "tels", "telles",
];

/// Words for an example with numbers, in some languages.
const EXAMPLE: [&str; 12] = [
    "example",
    "numerical",
    "numerically",
    "beispiel",
    "zahlenbeispiel",
    "zahlenwerte",
    "exemple",
    "numérique",
    "ejemplo",
    "numérico",
    "esempio",
    "przykład",
];

/// Whether the words directly before a place say that values for an example come.
fn is_example(text: &str, at: usize) -> bool {
    let before = text.get(..at).unwrap_or_default().trim_end().trim_end_matches([':', '$']);
    let clause = before.rsplit(['.', ';', ':', '=', '$']).next().unwrap_or_default().to_lowercase();
    clause.split(|c: char| !c.is_alphabetic()).any(|word| EXAMPLE.contains(&word))
}

/// The number of words before a formula among which "if" is sought.
const CLOSE: usize = 4;

/// Whether one of the last words before a place, in its sentence, is "if".
fn is_if(text: &str, at: usize) -> bool {
    let before = text.get(..at).unwrap_or_default();
    let sentence = before.rsplit(['.', ';', ':', '=']).next().unwrap_or_default().to_lowercase();
    let mut words = sentence.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty()).rev().take(CLOSE);
    words.any(|word| IF.contains(&word))
}

/// Words that say that a solution is tried, and beginnings of such words, in some languages.
const TRIED: [&str; 10] = ["with", "try", "tried", "trial", "let", "mit", "setze", "avec", "posons", "con"];
const TRIED_STEMS: [&str; 11] =
    ["ansatz", "ansätze", "guess", "seek", "look", "insert", "suppos", "assum", "cherch", "prob", "busca"];

/// Whether a word in the clause before a place says that what follows is tried as a solution.
fn is_tried(text: &str, at: usize) -> bool {
    let clause = clause_before(text, at);
    let mut words = clause.split(|c: char| !c.is_alphabetic());
    words.any(|word| TRIED.contains(&word) || TRIED_STEMS.iter().any(|stem| word.starts_with(stem)))
}

/// Words for the start of a motion, in some languages.
const START: [&str; 14] = [
    "at the start",
    "at the beginning",
    "at first",
    "initially",
    "initial acceleration",
    "am anfang",
    "zu beginn",
    "anfangs",
    "au début",
    "au départ",
    "al principio",
    "al inicio",
    "all'inizio",
    "na początku",
];

/// Words for an extremum, and beginnings of such words, in some languages.
const EXTREMUM: [&str; 18] = [
    "largest",
    "smallest",
    "greatest",
    "least",
    "maxim",
    "minim",
    "extrem",
    "resonan",
    "résonan",
    "größte",
    "kleinste",
    "am größten",
    "am kleinsten",
    "plus grand",
    "plus petit",
    "risonan",
    "największ",
    "najmniejsz",
];

/// Words for rest, and beginnings of such words, in some languages.
const REST: [&str; 12] = [
    "equilib",
    "équilib",
    "equilíb",
    "at rest",
    "can rest",
    "rests",
    "gleichgewicht",
    "ruhelage",
    "repos",
    "reposo",
    "równowa",
    "riposo",
];

/// Whether the clause before a place contains one of some words.
fn says_any(text: &str, at: usize, words: &[&str]) -> bool {
    let clause = clause_before(text, at);
    words.iter().any(|word| clause.contains(word))
}

/// The clause before a place, in small letters.
fn clause_before(text: &str, at: usize) -> String {
    let before = text.get(..at).unwrap_or_default();
    let start = before.rfind(['.', '\n', ';', ':']).map_or(0, |at| at + 1);
    let clause = match before[start..].trim() {
        // A line break before a display ends no clause.
        "" => before.trim_end().rsplit(['.', ';', '\n']).next().unwrap_or_default(),
        _ => &before[start..],
    };
    clause.to_lowercase()
}

/// Whether braces, and the environments of a text, are closed in it.
fn balanced(text: &str) -> bool {
    let mut depth = 0i32;
    let mut escaped = false;
    for c in text.chars() {
        match c {
            '\\' if !escaped => {
                escaped = true;
                continue;
            }
            '{' if !escaped => depth += 1,
            '}' if !escaped => depth -= 1,
            _ => {}
        }
        escaped = false;
        if depth < 0 {
            return false;
        }
    }
    depth == 0 && text.matches("\\begin{").count() == text.matches("\\end{").count()
}
