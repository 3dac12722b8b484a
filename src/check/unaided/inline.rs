//! The formulas in sentences that define a name or relate known ones: "where $\omega^2 = k/m$", "put $2\gamma = b/m$",
//! "the adiabats give $V_B/V_A = V_C/V_D$".
//!
//! Such a formula becomes a display of the notes while they are judged, and is left out of the report: it is no display of the
//! author's. A definition is taken only if the words announce it. A condition ("if $x = x_0$"), a value and a name for a name
//! are none, and neither is a formula of a name that displays further back use: it may be a special case. What relates names
//! that displays have is a premise of the next display, and so is a special case that the words state. It also shows that a name has another formula from there on.

use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::latex::foreign::products_in_lines;
use crate::notes::{Display, Notes};
use crate::source::Span;

use crate::check::document::inferred::prose::{
    body_of, follows_condition, is_announced, is_named, is_supposed, sentence_start, words_between,
};
use crate::check::unaided::special_cases;
use crate::check::usage::{Usage, names_of};

/// The fewest names of a formula that is a relation, and no value or special case.
const FEWEST_RELATED: usize = 3;

/// The words that may stand between a formula in a sentence and a display that follows from it.
const BETWEEN: [&str; 66] = [
    "and",
    "so",
    "is",
    "we",
    "get",
    "find",
    "have",
    "has",
    "hence",
    "thus",
    "therefore",
    "which",
    "that",
    "this",
    "it",
    "then",
    "gives",
    "yields",
    "comes",
    "out",
    "as",
    "be",
    "to",
    "becomes",
    "reads",
    "obtain",
    "see",
    "from",
    "follows",
    "now",
    "i.e",
    "simply",
    "or",
    "one",
    "finds",
    "gets",
    "obtains",
    "by",
    "differentiation",
    "explicitly",
    "the",
    "result",
    // other languages
    "also",
    "und",
    "damit",
    "folgt",
    "ergibt",
    "sich",
    "zu",
    "wird",
    "ist",
    "daraus",
    "donc",
    "d'où",
    "on",
    "obtient",
    "trouve",
    "vaut",
    "quindi",
    "si",
    "ottiene",
    "vale",
    "è",
    "e",
    "et",
    "soit",
];

/// Whether a display is a formula in a sentence.
pub(super) fn is_inline(notes: &Notes, display: &Display) -> bool {
    notes.inline.contains(&display.span)
}

/// The displays of notes with the formulas in sentences that define a name, in order. A formula may define a name that only another
/// formula in a sentence uses: "with $k = \sqrt{2mE}/\hbar$ and the abbreviation $\beta = m\alpha/\hbar^2 k$".
pub(super) fn with_definitions(notes: &Notes, displays: Vec<Display>, macros: &Macros) -> Vec<Display> {
    let found = with_definitions_of(notes, displays.clone(), &[], macros);
    let inline: Vec<Display> = found.iter().filter(|display| is_inline(notes, display)).cloned().collect();
    if inline.is_empty() {
        return found;
    }
    let used: Vec<Name> = names_of(&inline, macros)
        .into_iter()
        .filter(|usage| usage.introduced.is_none())
        .map(|usage| usage.name)
        .collect();
    with_definitions_of(notes, displays, &used, macros)
}

/// The same, where some names are known to be used in sentences.
fn with_definitions_of(notes: &Notes, displays: Vec<Display>, used: &[Name], macros: &Macros) -> Vec<Display> {
    let usages = names_of(&displays, macros);
    let mut found = displays.clone();
    let mut defined: Vec<String> = Vec::new();
    for span in &notes.inline {
        let Some(display) = formula(notes, *span) else { continue };
        let at = found.iter().position(|other| other.span.start > span.start).unwrap_or(found.len());
        let authors = found[..at].iter().filter(|display| !is_inline(notes, display)).count();
        let is_sum = || is_sum(&display, &usages, macros) && !follows_condition(notes, *span);
        let name = name(&display, macros).filter(|name| !defined.contains(name));
        // What leads to the next display says what its name is, and the display what that gives.
        let leads = !follows_condition(notes, *span)
            && displays.get(authors).is_some_and(|next| leads_to(notes, *span, next.span.start));
        let is_free = |usage: &Usage| {
            let is_new = usage.introduced.is_none() || usage.only_a_power || leads && usage.first == authors;
            is_new && usage.first + 1 >= authors
        };
        let is_told = leads || is_announced(notes, *span) || is_named(notes, *span);
        let is_used = |name: &String| used.iter().any(|other| other.to_string() == *name);
        let defines = |name: &String| {
            let usage = usages.iter().find(|usage| usage.name.to_string() == *name);
            if usage.is_some_and(|usage| usage.moves) && !moves_on_the_right(&display, &usages, macros) {
                return false;
            }
            (is_told || is_sum()) && usage.map_or_else(|| is_used(name), is_free)
        };
        if let Some(name) = name.filter(defines) {
            found.insert(at, with_known_names(display, &name, (&usages, used), macros));
            defined.push(name);
        } else if relates(&display, (&usages, authors, is_told), macros)
            && (!follows_condition(notes, *span)
                || !is_supposed(notes, *span) && is_directly_before(notes, *span, &found))
            || special_cases::is_one(notes, &display, (&usages, authors))
        {
            found.insert(at, display);
        }
    }
    found
}

/// Whether the formula of a definition contains the time or a name that moves in the displays. Without one the name would be at
/// rest.
fn moves_on_the_right(display: &Display, usages: &[Usage], macros: &Macros) -> bool {
    let Some((_, right)) = display.text.split_once('=') else { return false };
    let names = names_of(&[Display { text: right.to_owned(), ..display.clone() }], macros);
    let is_known = |name: &Usage| usages.iter().any(|usage| usage.name == name.name && usage.moves);
    names.iter().any(|name| name.moves || is_known(name) || name.name == Name::plain("t"))
}

/// Whether a formula in a sentence holds under a condition, so that it says nothing but about the next display.
pub(super) fn is_conditional(notes: &Notes, display: &Display) -> bool {
    // `v = \sqrt{\dot x^2 + \dot y^2} = 1` is a value of an example. A motion "about the rest position" is at other places too.
    let members: Vec<&str> = display.text.split('=').collect();
    let ends_in_a_number = members.len() > 2 && members.last().is_some_and(|last| last.trim().parse::<f64>().is_ok());
    let start = sentence_start(notes, display.span.start);
    let words = words_between(notes, start, display.span.start);
    let is_about =
        ["about", "around", "centred", "centered"].iter().any(|word| words.iter().any(|other| other == word));
    ends_in_a_number || is_about || follows_condition(notes, display.span)
}

/// Whether a formula stands in the paragraph of the display after it.
fn is_directly_before(notes: &Notes, span: Span, displays: &[Display]) -> bool {
    let next = displays.iter().map(|display| display.span.start).filter(|start| *start >= span.end).min();
    let between = next.and_then(|next| notes.source.text.get(span.end..next));
    between.is_some_and(|text| !text.trim_end().contains("\n\n"))
}

/// Whether a formula relates several names that displays before it have, or that no display gives a formula. Two are enough where the
/// words announce it.
fn relates(display: &Display, (usages, authors, is_told): (&[Usage], usize, bool), macros: &Macros) -> bool {
    let names = names_of(std::slice::from_ref(display), macros);
    let is_known = |name: &Usage| {
        let used = usages.iter().find(|usage| usage.name == name.name);
        used.is_some_and(|usage| usage.first < authors || usage.introduced.is_none())
    };
    let first = names.iter().find(|name| name.introduced.is_some());
    let is_used = |name: &Usage| usages.iter().any(|usage| usage.name == name.name && usage.first < authors);
    // A value, and another name for a name, are a special case.
    let sides =
        display.text.split('=').map(|side| names_of(&[Display { text: side.to_owned(), ..display.clone() }], macros));
    let sides: Vec<usize> = sides.map(|names| names.len()).collect();
    let is_more = !sides.contains(&0) && display.text.contains(['^', '/', '+', '-', '(', '\\']);
    names.len() + usize::from(is_told && is_more) >= FEWEST_RELATED
        && names.iter().all(is_known)
        && first.is_none_or(is_used)
}

/// Whether nothing but words that one gives the other stands between a formula in a sentence and a place.
pub(super) fn leads_to(notes: &Notes, span: Span, place: usize) -> bool {
    let between = notes.source.text.get(span.end..place).unwrap_or_default();
    let words = between.split(|c: char| c.is_whitespace() || ",;:".contains(c)).filter(|word| !word.is_empty());
    let is_allowed = |word: &str| {
        let word = word.trim_end_matches('.').to_lowercase();
        let is_reference = ["\\eqref", "\\ref", "("].iter().any(|mark| word.starts_with(mark));
        word.is_empty() || is_reference || connects(&word)
    };
    !between.trim_end().contains("\n\n") && words.into_iter().all(is_allowed)
}

/// Whether a word may stand between a formula and another one that follows from it.
pub(super) fn connects(word: &str) -> bool {
    BETWEEN.contains(&word)
}

/// The formula in a sentence as a display, if it is one equality.
fn formula(notes: &Notes, span: Span) -> Option<Display> {
    let body = body_of(notes, span)?;
    let text = notes.source.slice(body);
    let is_plain = !["%", "\n>", "\\text", "\\pm", "\\mp", "<", ">", "\\approx", "\\to", ","]
        .iter()
        .any(|mark| text.contains(mark));
    let line = 1 + notes.source.text[..span.start].matches('\n').count();
    (is_plain && text.contains('=')).then(|| Display {
        span,
        body,
        parts: vec![body],
        text: as_displayed(text),
        number: None,
        labels: Vec::new(),
        automatic: Vec::new(),
        numbers_rows: false,
        line,
    })
}

/// A definition by the first member of its chain whose names the displays have: of `V = mgh = mg\ell(1 - \cos\theta)` the last one,
/// where no display has h.
fn with_known_names(
    display: Display,
    name: &str,
    (usages, in_sentences): (&[Usage], &[Name]),
    macros: &Macros,
) -> Display {
    let members: Vec<&str> = display.text.split('=').skip(1).collect();
    let is_used =
        |usage: &Usage| usages.iter().any(|used| used.name == usage.name) || in_sentences.contains(&usage.name);
    let is_known = |text: &&&str| {
        names_of(&[Display { text: (**text).to_owned(), ..display.clone() }], macros).iter().all(is_used)
    };
    match members.iter().find(is_known) {
        Some(member) if members.len() > 1 => Display { text: format!("{name} ={member}"), ..display },
        _ => display,
    }
}

/// A formula in a line of text with its derivatives as fractions: `dU/dT`, `\partial \ln Z/\partial\beta`.
fn with_derivatives(text: &str) -> String {
    const SIGNS: [&str; 2] = ["\\partial", "d"];
    let ends_a_name = |text: &str| text.ends_with(|c: char| c.is_ascii_alphabetic() || matches!(c, '\\' | '^' | '_'));
    let derivative = |sign: &str| {
        let slash =
            text.match_indices('/').map(|(at, _)| at).find(|at| text[at + 1..].trim_start().starts_with(sign))?;
        let (before, below) = (&text[..slash], &text[slash + 1..]);
        let is_sign = |at: &usize| sign != "d" || !ends_a_name(&before[..*at]);
        let start = before.match_indices(sign).map(|(at, _)| at).filter(is_sign).last()?;
        let length = below.trim_end().find(|c: char| "=+-,;)".contains(c)).unwrap_or(below.trim_end().len());
        let (below, after) = below.split_at(length);
        let above = &before[start..];
        let is_plain = !above.contains(['=', '+', '/', '(']) && above.trim() != sign;
        is_plain.then(|| format!("{}\\frac{{{above}}}{{{below}}}{after}", &before[..start]))
    };
    SIGNS.iter().find_map(|sign| derivative(sign)).unwrap_or_else(|| text.to_owned())
}

/// A formula in a line of text as it would be displayed.
pub(super) fn as_displayed(text: &str) -> String {
    with_whole_denominators(&with_derivatives(text))
}

/// A formula with parentheses around what stands directly after a slash: in a line of text `1/k_BT` has k_B T below it. After a
/// space or a number over a number, as in `1/2 mv^2`, it does not.
fn with_whole_denominators(text: &str) -> String {
    let mut edits = products_in_lines(text);
    edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    let mut text = text.to_owned();
    for (span, new) in edits {
        text.replace_range(span.range(), &new);
    }
    text
}

/// The name that a formula defines: the only one on its left side, where the right side has other names and is more than one.
fn name(display: &Display, macros: &Macros) -> Option<String> {
    let (left, right) = display.text.split_once('=')?;
    let side = |text: &str| names_of(&[Display { text: text.to_owned(), ..display.clone() }], macros);
    let (left, names) = (side(left), side(right));
    let [only] = left.as_slice() else { return None };
    let is_known = |usage: &Usage| ["\\pi", "t", "d"].contains(&usage.name.to_string().as_str());
    let is_more = names.len() > 1
        || right.contains(['^', '/', '+', '-'])
        || ["\\frac", "\\dot"].iter().any(|mark| right.contains(mark));
    let stands_alone = !only.moves && !is_known(only) && only.arguments.is_none();
    let is_other = !names.is_empty() && names.iter().all(|usage| usage.name != only.name);
    // Decimals are those of a measurement.
    let is_measured = right.split('.').collect::<Vec<_>>().windows(2).any(|pair| {
        pair[0].ends_with(|c: char| c.is_ascii_digit()) && pair[1].starts_with(|c: char| c.is_ascii_digit())
    });
    (stands_alone && is_other && is_more && !is_measured).then(|| only.name.to_string())
}

/// Whether a formula is a sum of names that displays give formulas, as L = T − V.
fn is_sum(display: &Display, usages: &[Usage], macros: &Macros) -> bool {
    let Some((_, right)) = display.text.split_once('=') else { return false };
    let parts: Vec<&str> = right.split(['+', '-']).collect();
    let is_defined = |part: &&str| {
        let names = names_of(&[Display { text: (*part).to_owned(), ..display.clone() }], macros);
        let [only] = names.as_slice() else { return false };
        let name = part.trim();
        let is_whole = only.name.to_string() == name || Name::plain(name) == only.name;
        is_whole && usages.iter().any(|usage| usage.name == only.name && usage.introduced.is_some())
    };
    parts.len() > 1 && parts.iter().all(is_defined)
}
