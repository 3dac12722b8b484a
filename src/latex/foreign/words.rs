//! Words and signs between statements, and decimal commas.

#[cfg(feature = "cli")]
use super::functions::WORDS;
#[cfg(feature = "cli")]
use super::units::{self, braced};

/// A text of the same length, in which decimal commas are points, and words between statements are spaces.
#[cfg(feature = "cli")]
pub fn separated(text: &str) -> String {
    let mut new = text.to_owned();
    while let Some(at) = new.match_indices("{,}").map(|(at, _)| at).find(|at| between_digits(&new, *at, 3)) {
        let end = at + 3 + new[at + 3..].bytes().take_while(u8::is_ascii_digit).count();
        let digits = new[at + 3..end].to_owned();
        new.replace_range(at..end, &format!(".{digits}  "));
    }
    // A zero before the comma begins no list.
    let commas: Vec<usize> = new.match_indices(',').map(|(at, _)| at).collect();
    for at in commas {
        if !between_digits(&new, at, 1) {
            continue;
        }
        let whole = new[..at].trim_end_matches(|c: char| c.is_ascii_digit()).len();
        let is_in_list = new[..whole].ends_with(['(', '[', '{', ',']);
        if !is_in_list {
            new.replace_range(at..=at, ".");
        }
    }
    for command in ["\\text{", "\\mbox{", "\\textrm{"] {
        let places: Vec<usize> = text.match_indices(command).map(|(at, _)| at).collect();
        for at in places {
            let Some((words, length)) = braced(&text[at + command.len()..]) else { continue };
            let end = at + command.len() + length;
            let words = &without_accents(words);
            if !words.contains(['$', '\\', '{']) && is_between_statements(text, (at, end), words) {
                new.replace_range(at..end, &format!("\\quad{}", " ".repeat(end - at - "\\quad".len())));
            }
        }
    }
    for mark in ["\\underline{", "\\uuline{", "\\uline{"] {
        while let Some(at) = new.find(mark) {
            // The line under a result says nothing: its braces become spaces.
            let inside = at + mark.len();
            let Some((_, length)) = braced(&new[inside..]) else { break };
            let end = inside + length;
            new.replace_range(end - 1..end, " ");
            new.replace_range(at..inside, &" ".repeat(mark.len()));
        }
    }
    for remark in ["\\checkmark", "\\square", "\\blacksquare", "\\qed"] {
        while let Some(at) = new.find(remark) {
            new.replace_range(at..at + remark.len(), &" ".repeat(remark.len()));
        }
    }
    let at = |text: &str, mark: &str| text.find(mark);
    while let Some(at) = at(&new, "=:") {
        new.replace_range(at..at + 2, "= ");
    }
    if let Some(end) = label(&new) {
        new.replace_range(..end, &" ".repeat(end));
    }
    let colons: Vec<usize> = new.match_indices(':').map(|(at, _)| at).collect();
    for at in colons {
        if ends_a_clause(&new, at) {
            new.replace_range(at..=at, ",");
        }
    }
    for arrow in ["\\longrightarrow", "\\rightarrow", "\\leadsto", "\\to"] {
        let places: Vec<usize> = new.match_indices(arrow).map(|(at, _)| at).collect();
        for at in places {
            if is_between_equalities(&new, at, arrow) {
                let mark = format!(",{}", " ".repeat(arrow.len() - 1));
                new.replace_range(at..at + arrow.len(), &mark);
            }
        }
    }
    debug_assert_eq!(new.len(), text.len());
    new
}

/// Words for "or" between statements.
#[cfg(feature = "cli")]
const OR: [&str; 9] = ["or", "oder", "ou", "o", "u", "oppure", "lub", "eller", "ou bien"];

/// Words for "and" between statements that stand apart from both.
#[cfg(feature = "cli")]
const AND: [&str; 8] = ["y", "e", "ed", "et", "i", "und", "og", "och"];

/// Whether a text between two statements, or the prose there, says that they are alternatives.
#[cfg(feature = "cli")]
pub fn says_or(between: &str) -> bool {
    let is_or = |words: &str| OR.contains(&words.trim_matches([' ', ',', '~', ';', '.']));
    let mut prose = between.replace("\\quad", " ").replace("\\qquad", " ").replace(['$', '&'], " ");
    for command in ["\\text{", "\\mbox{", "\\textrm{", "\\mathrm{", "\\hbox{"] {
        prose = prose.replace(command, "{");
    }
    is_or(&prose.replace(['{', '}'], " ").replace("\\,", " ").replace("\\;", " ").replace("\\ ", " "))
        || prose.trim() == "\\lor"
        || prose.trim() == "\\vee"
}

/// Words without the commands for accents: `p\'eriode`.
#[cfg(feature = "cli")]
fn without_accents(words: &str) -> String {
    let mut plain = words.to_owned();
    for accent in ["\\'", "\\`", "\\^", "\\\"", "\\~", "\\=", "\\.", "\\c ", "\\k ", "\\v ", "\\l ", "\\o ", "\\ss "] {
        plain = plain.replace(accent, "");
    }
    plain.replace(['{', '}'], "")
}

/// The end of a name that says what an equation is about: `x:\quad m\ddot x = -k x`.
#[cfg(feature = "cli")]
fn label(text: &str) -> Option<usize> {
    let at = text.find(':')?;
    let (name, after) = (text[..at].trim(), text[at + 1..].trim_start());
    let is_name = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || "\\_{}".contains(c));
    let is_apart = ["\\quad", "\\qquad", "\\;", "\\ "].iter().any(|space| after.starts_with(space));
    (is_name && !name.starts_with(|c: char| c.is_ascii_digit()) && is_apart && after.contains('=')).then_some(at + 1)
}

/// Whether a colon ends what is said of the statement after it: `t = 0:\quad`.
#[cfg(feature = "cli")]
fn ends_a_clause(text: &str, at: usize) -> bool {
    let (before, after) = (text[..at].trim_end(), &text[at + 1..]);
    let is_apart = ["\\quad", "\\qquad", "\\;", "\\ ", "\\,"].iter().any(|space| after.trim_start().starts_with(space));
    let is_end = after.trim().is_empty() || is_apart;
    is_end && before.contains('=') && before.ends_with(|c: char| c.is_ascii_alphanumeric() || c == '}' || c == ')')
}

/// Whether an arrow outside of braces stands after an equality and before another one, or before the end of a text.
#[cfg(feature = "cli")]
fn is_between_equalities(text: &str, at: usize, arrow: &str) -> bool {
    let (before, after) = (&text[..at], &text[at + arrow.len()..]);
    let depth = |text: &str| {
        text.bytes()
            .fold(0i32, |depth, c| depth + i32::from(c == b'{' || c == b'(') - i32::from(c == b'}' || c == b')'))
    };
    let is_command = after.starts_with(|c: char| c.is_ascii_alphabetic());
    !is_command && depth(before) == 0 && before.contains('=') && !before.trim_end().ends_with('=')
}

/// Whether words stand between statements: there are several, and no sign that binds them is beside them.
#[cfg(feature = "cli")]
fn is_between_statements(text: &str, (start, end): (usize, usize), words: &str) -> bool {
    const KNOWN: [&str; 13] = [
        "const", "is ", "and", "if", "for", "when", "whenever", "provided", "with", "where", "const.", "so that", "all",
    ];
    let words = words.trim();
    if OR.contains(&words) {
        return true;
    }
    // A unit belongs to the number before it.
    let is_after_a_number = || {
        let before = ["\\,", "\\;", "\\ ", "~"]
            .iter()
            .fold(text[..start].trim_end(), |text, space| text.strip_suffix(*space).unwrap_or(text).trim_end());
        before.ends_with(|c: char| c.is_ascii_digit() || c == '}')
    };
    if units::words(words).is_some() && is_after_a_number() {
        return false;
    }
    // `u \, \text{sen} \, \chi` is a sine.
    let is_function = WORDS.iter().any(|(word, _)| words == *word);
    let known = |known: &&str| words == known.trim() || words.starts_with(*known) && (*known == "is ");
    let count = words.split_whitespace().filter(|word| word.chars().any(char::is_alphabetic)).count();
    let spaces = ["\\quad", "\\qquad", "\\,", "\\;", "\\ ", "~", "&"];
    let (mut before, mut after) = (text[..start].trim_end(), text[end..].trim_start());
    let mut is_apart = false;
    while let Some(space) = spaces.iter().find(|space| before.ends_with(**space)) {
        before = before[..before.len() - space.len()].trim_end();
        is_apart = true;
    }
    while let Some(space) = spaces.iter().find(|space| after.starts_with(**space)) {
        after = after[space.len()..].trim_start();
    }
    let binds = |c: char| "=+-*/^_<>({[|".contains(c);
    let is_bound = before.ends_with(binds) || after.starts_with(|c: char| "=+-*/^_<>)}]|(".contains(c));
    let is_first = before.is_empty() || before.ends_with([',', ';', '.', '&']) || before.ends_with("\\\\");
    if AND.contains(&words) {
        return is_apart && !is_bound && text[end..].trim_start().starts_with("\\q");
    }
    !words.is_empty()
        && !KNOWN.iter().any(known)
        && !is_bound
        && !is_function
        && (count > 1 || is_apart || is_first)
        && words.chars().filter(|c| c.is_alphabetic()).count() > 2
}

#[cfg(feature = "cli")]
fn between_digits(text: &str, at: usize, length: usize) -> bool {
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    digit(text[..at].chars().next_back()) && digit(text[at + length..].chars().next())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_commas_keep_their_length() {
        for (text, new) in [
            (r"x = 57{,}7\,m", r"x = 57.7  \,m"),
            (r"x = 0,5 t", "x = 0.5 t"),
            (r"a = b \quad \text{et la p\'eriode} \quad c = d", r"a = b \quad \quad                  \quad c = d"),
            (r"x = 0 \text{or} x = 1", r"x = 0 \quad     x = 1"),
            (r"a = b \;\checkmark", r"a = b \;          "),
            (r"a = b =: c", r"a = b =  c"),
            (r"\underline{\underline{a = b_{1}}}", r"                      a = b_{1}  "),
            (r"t = 0:\quad a = b", r"t = 0,\quad a = b"),
            (r"a = b \to c = d", r"a = b ,   c = d"),
            (r"a = b \quad \text{y también} \quad c = d", r"a = b \quad \quad             \quad c = d"),
            (r"a = b \quad \text{y} \quad c = d", r"a = b \quad \quad    \quad c = d"),
            // The twins: a list, a subscript, a word that is read.
            (r"a = b \text{y} c", r"a = b \text{y} c"),
            ("f(1,2)", "f(1,2)"),
            (r"\lim_{x \to 0} f = 1", r"\lim_{x \to 0} f = 1"),
            (r"x := 1", r"x := 1"),
            (r"E_\text{kin max} = 1", r"E_\text{kin max} = 1"),
            (r"E = \text{const}", r"E = \text{const}"),
            (r"m = 938\,\text{MeV}, n = 2\,\text{mol}", r"m = 938\,\text{MeV}, n = 2\,\text{mol}"),
            (r"a = b \text{ for } x > 0", r"a = b \text{ for } x > 0"),
        ] {
            assert_eq!(separated(text), new);
        }
    }

    #[test]
    fn words_and_prose_say_that_statements_are_alternatives() {
        for between in [r"\quad\text{or}\quad ", "$ or $", r" \text{ oder } ", r"\;\text{ou}\;"] {
            assert!(says_or(between), "{between}");
        }
        // The twins: another word, a longer text.
        for between in [r"\quad\text{and}\quad ", "$, so $", "$ or with the energy $", ""] {
            assert!(!says_or(between), "{between}");
        }
    }
}
