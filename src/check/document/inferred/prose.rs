//! The definitions that the prose makes: "with the Lagrangian $L = T - V$", "put $\\nu = \\sqrt{k/m}$", "with $\\omega^2 = k/m$".
//!
//! A formula in a sentence defines a name only if nothing else does: no declaration and no display, and a display cannot be
//! read for lack of it. It must be one equality of the bare name, its square or a multiple of it, and a formula of known names. A condition ("if $a = b$")
//! defines nothing, and neither does a name that the prose gives two formulas. The Lagrangian is the kinetic less the
//! potential energy, where the claims file says which these are and no formula defines it.

use crate::formula::{Expr, SymbolId, text};
use crate::latex::{Reading, name_search};
use crate::notes::Notes;
use crate::notes::claims::{Claims, Spanned};
use crate::source::{Fault, Missing, Span};

use crate::check::document::definition::define;
use crate::check::document::unreadable::faults;
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;

/// Words that announce a definition.
const ANNOUNCE: [&str; 14] = [
    "where",
    "with",
    "put",
    "let",
    "define",
    "defining",
    "write",
    "writing",
    "set",
    "setting",
    "introduce",
    "introducing",
    "denote",
    "abbreviate",
];

/// Words for what a letter may be.
const QUANTITIES: [&str; 56] = [
    "acceleration",
    "abbreviation",
    "amplitude",
    "angle",
    "area",
    "capacitance",
    "charge",
    "coefficient",
    "constant",
    "coordinate",
    "current",
    "definition",
    "density",
    "distance",
    "efficiency",
    "energy",
    "entropy",
    "factor",
    "field",
    "flux",
    "force",
    "frequency",
    "function",
    "heat",
    "height",
    "impedance",
    "index",
    "inertia",
    "intensity",
    "lagrangian",
    "length",
    "mass",
    "moment",
    "momentum",
    "notation",
    "number",
    "parameter",
    "period",
    "phase",
    "potential",
    "power",
    "pressure",
    "quantity",
    "radius",
    "ratio",
    "resistance",
    "speed",
    "temperature",
    "time",
    "torque",
    "variable",
    "velocity",
    "voltage",
    "volume",
    "wavelength",
    "work",
];

/// Words after which a formula is a condition or a case.
const CONDITION: [&str; 14] = [
    "if", "when", "whenever", "for", "at", "as", "until", "unless", "near", "limit", "case", "assuming", "suppose",
    "initial",
];

/// Words with which a sentence denies that a motion is small.
const DENIALS: [&str; 6] = ["no", "not", "never", "without", "beyond", "nonlinear"];

/// Words with which a sentence no longer speaks of the small motion of a sentence before it.
const OF_ANY_SIZE: [&str; 8] = ["exact", "exactly", "general", "generally", "large", "arbitrary", "full", "original"];

/// Words for what is small in a small motion, as they begin.
const MOTIONS: [&str; 14] = [
    "angle",
    "oscill",
    "vibrat",
    "motion",
    "displace",
    "deviat",
    "deflect",
    "amplitude",
    "swing",
    "excursion",
    "departure",
    "disturb",
    "perturb",
    "elongation",
];

/// Words for what is made of the equations before.
const DERIVES: [&str; 8] =
    ["adding", "subtracting", "combining", "eliminating", "dividing", "multiplying", "differentiating", "sum"];

/// The number of sentences before the last one of which the words count, and of displays between them.
const SENTENCES_BEFORE: usize = 4;
const DISPLAYS_BEFORE: usize = 2;

/// The most bytes before a formula that are taken for its words.
const LONGEST: usize = 300;

/// The most words between the one that announces a definition and the formula.
const MOST_WORDS: usize = 8;

/// A definition that the prose makes.
struct Said {
    name: String,
    /// The left side without a number before it: the name, or its square.
    left: String,
    formula: String,
    line: usize,
    /// Whether it names a quantity after "for": "for the distance $r = x_1 - x_2$". It may be a case, unless the formula moves.
    is_after_for: bool,
}

impl Said {
    /// What an equality of a name, its square, or a multiple of these says.
    fn of(left: &str, formula: &str, line: usize, is_after_for: bool) -> Self {
        let number: String = left.chars().take_while(char::is_ascii_digit).collect();
        let left = left[number.len()..].trim_start().to_owned();
        let formula = match number.as_str() {
            "" => formula.to_owned(),
            number => format!("\\frac{{{formula}}}{{{number}}}"),
        };
        Said { name: without_square(&left).to_owned(), left, formula, line, is_after_for }
    }
}

/// A name without the 2 above it.
fn without_square(left: &str) -> &str {
    let left = left.trim();
    left.strip_suffix("^2").or(left.strip_suffix("^{2}")).unwrap_or(left).trim_end()
}

/// The definitions that the prose makes, in its order.
pub(crate) struct Prose(Vec<Said>);

impl Prose {
    /// Those of some notes.
    pub fn of(notes: &Notes) -> Self {
        let said = |span: &Span| {
            let text = notes.source.slice(body_of(notes, *span)?);
            let (name, formula) = text.split_once('=').filter(|(_, formula)| !formula.contains('='))?;
            let is_one = !["<", ">", "\\approx", "\\to", "\\ne", "\\le", "\\ge", ",", "\\pm", "\\mp"]
                .iter()
                .any(|mark| formula.contains(mark));
            let is_meant = is_announced(notes, *span) || !follows_condition(notes, *span);
            let is_after_for = !is_meant && is_for_a_quantity(notes, *span);
            let line = 1 + notes.source.text[..span.start].matches('\n').count();
            (is_one && (is_meant || is_after_for)).then(|| Said::of(name.trim(), formula.trim(), line, is_after_for))
        };
        Prose(notes.inline.iter().filter_map(said).collect())
    }

    /// Defines a name that one of the readings lacks, or else the Lagrangian; returns whether it has found one. A name with which a display
    /// begins counts `if_begins` only: where nothing else is left, that display may be a relation between names that need this one.
    pub fn define<'r>(
        &self,
        (claims, notes): (&Claims, &Notes),
        unread: impl Iterator<Item = (usize, &'r Reading)>,
        if_begins: bool,
        model: &mut Model,
    ) -> bool {
        let is_missing = |fault: &Fault| matches!(fault.missing, Some(Missing::Name(_)));
        let texts: Vec<&str> = unread
            .filter(|(_, reading)| faults(reading).any(is_missing))
            .map(|(at, _)| notes.equations[at].text.as_str())
            .collect();
        let is_used = |name: &str| texts.iter().any(|text| name_search::mentions(text, name, &model.macros));
        // What a display defines that cannot be read yet is not taken from the prose; the end of a chain defines nothing that the
        // prose does.
        let is_defined =
            |name: &str| texts.iter().any(|text| name_search::is_the_first_side(text, name, &model.macros));
        let names = self.0.iter().map(|said| said.name.as_str());
        let missing: Vec<&str> = names.filter(|name| is_used(name) && (if_begins || !is_defined(name))).collect();
        let lagrangian = model.printed_lagrangian.as_ref().map(|printed| printed.lagrangian.to_string());
        let lacks =
            |name: &str| name_search::parse_decorated(name).is_some_and(|name| model.symbols.find(&name).is_none());
        let wanted: Vec<String> =
            missing.into_iter().map(str::to_owned).chain(lagrangian.clone()).filter(|name| lacks(name)).collect();
        wanted.iter().any(|name| {
            self.define_one(claims, name, model)
                || lagrangian.as_ref() == Some(name) && define_by_energies((claims, notes), name, model)
        })
    }

    /// Defines a name by the formula that the prose has for it.
    fn define_one(&self, claims: &Claims, name: &str, model: &mut Model) -> bool {
        let plain = |text: &str| text.split_whitespace().collect::<String>();
        let said = |one: &Said| (plain(&one.left), plain(&one.formula));
        let mut own = self.0.iter().filter(|said| name_search::same(&said.name, name));
        let Some(first) = own.next().filter(|first| own.all(|other| said(other) == said(first))) else {
            return false;
        };
        let mut with = model.clone();
        if !defines(
            claims,
            (&first.left, &first.formula),
            &mut with,
            &format!("as line {} of the notes says", first.line),
        ) {
            return false;
        }
        // "For the frequency $\\omega = 2\\omega_0$" is a case; what moves and has a formula is a name for it.
        let found = name_search::parse_decorated(name).and_then(|name| with.symbols.find(&name)).map(|(id, _)| id);
        let moves = |id: SymbolId| {
            with.coordinates.iter().chain(&with.varying).any(|q| with.symbol_depends_on(id, &[q.symbol]))
        };
        let stands = !first.is_after_for || found.is_some_and(moves);
        if stands {
            *model = with;
        }
        stands
    }
}

/// Defines the Lagrangian by the energies that the claims file names.
fn define_by_energies((claims, notes): (&Claims, &Notes), name: &str, model: &mut Model) -> bool {
    // A display that begins with the name defines it, though it cannot be read.
    if notes.equations.iter().any(|display| name_search::is_a_side(&display.text, name, &model.macros)) {
        return false;
    }
    let energy = |wanted: &str| {
        let mut named = claims.means.iter().filter(|(_, meaning)| meaning.value == wanted).map(|(name, _)| &name.value);
        named.next().filter(|_| named.next().is_none())
    };
    let Some((kinetic, potential)) = energy("kinetic energy").zip(energy("potential energy")) else { return false };
    let formula = format!("{kinetic} - {potential}");
    defines(claims, (name, &formula), model, "as the claims file names the kinetic and the potential energy")
}

/// Defines a name by a formula in which something stands that displays define, or that is declared; returns whether it can.
fn defines(claims: &Claims, (name, formula): (&str, &str), model: &mut Model, why: &str) -> bool {
    let spanned = |text: &str| Spanned { value: text.to_owned(), span: Span::default() };
    let mut with = model.clone();
    if define(claims, &spanned(name), &spanned(formula), &mut with).is_err() {
        return false;
    }
    let bare = without_square(name);
    let found = name_search::parse_decorated(bare).and_then(|name| with.symbols.find(&name)).map(|(id, _)| id);
    let Some(Meaning::Defined(new)) = found.and_then(|id| with.meaning(id)) else { return false };
    if Expr::symbols(new).is_empty() {
        return false;
    }
    with.inferred.push(format!("{} = {}, {why}", text::plain(name), text::plain(formula)));
    *model = with;
    true
}

/// The formula of a sentence without its marks.
pub(crate) fn body_of(notes: &Notes, span: Span) -> Option<Span> {
    let text = notes.source.text.get(span.range())?;
    let marks = [("$", "$"), ("\\(", "\\)")];
    marks.iter().find_map(|(open, close)| {
        let inner = text.strip_prefix(open)?.strip_suffix(close).filter(|inner| !inner.starts_with('$'))?;
        let start = span.start + open.len();
        Some(Span::new(start, start + inner.len()))
    })
}

/// Whether words before a formula in a sentence announce a definition.
pub(crate) fn is_announced(notes: &Notes, span: Span) -> bool {
    let words = words_before(notes, span);
    let Some(announced) = last(&words, &ANNOUNCE) else { return false };
    last(&words, &CONDITION).is_none_or(|condition| condition < announced) && words.len() - announced <= MOST_WORDS
}

/// Whether words name the quantity that stands on the left side of a formula in a sentence, directly before it, and no
/// condition: "the potential energy $V = …$", "(here $\\gamma = …$)", "notation: $\\beta = …$".
pub(crate) fn is_named(notes: &Notes, span: Span) -> bool {
    let words = words_before(notes, span);
    let is_alone = words.iter().all(|word| ["and", "here"].contains(&word.as_str()));
    let is_quantity =
        |word: &String| is_quantity(word) || ["is", "are", "by", "called", "denote"].contains(&word.as_str());
    let gives_names = last(&words, &["name", "naming", "call", "calling", "abbreviating", "denoting"]).is_some();
    let is_said = is_alone || gives_names || words.last().is_some_and(is_quantity);
    // "The speed at k_0 is half of the group velocity v_0 = …": the condition is over with the verb.
    let is_over = |condition: usize| {
        last(&words, &["is", "are", "has", "equals", "becomes"])
            .is_some_and(|verb| verb > condition && verb + 1 < words.len())
    };
    is_said && last(&words, &CONDITION).is_none_or(is_over)
}

/// Whether a word is one for what a letter may be.
fn is_quantity(word: &str) -> bool {
    let is_it = |name: &&str| word.strip_prefix(*name).is_some_and(|rest| ["", "s", "es"].contains(&rest));
    QUANTITIES.iter().any(is_it)
}

/// Whether a formula, or those beside it, stand directly after "for the" and a word for a quantity.
fn is_for_a_quantity(notes: &Notes, span: Span) -> bool {
    let mut words = words_before(notes, span);
    if words.last().is_some_and(|word| word == "and") {
        words.pop();
    }
    matches!(words.as_slice(), [.., before, article, word] if before == "for" && article == "the" && is_quantity(word))
}

/// Whether the sentence of a formula begins with a condition.
pub(crate) fn follows_condition(notes: &Notes, span: Span) -> bool {
    last(&words_before(notes, span), &CONDITION).is_some()
}

/// Whether the sentence of a formula only supposes something: it says neither that nor when it is so.
pub(crate) fn is_supposed(notes: &Notes, span: Span) -> bool {
    last(&words_before(notes, span), &["if", "unless", "until", "assuming", "suppose", "limit", "near"]).is_some()
}

/// Whether the words before a display speak of small motion, as "for small oscillations" does, and do not deny it: "no longer small". What
/// a sentence before the last one says must be about the motion, or a coordinate: "we assume that $\\theta$ is small. Then".
pub(crate) fn speaks_of_small(notes: &Notes, span: Span, is_coordinate: impl Fn(&str) -> bool) -> bool {
    let start = notes.equations.iter().map(|display| display.span).find(|display| display.contains(span));
    // A display of an edited text may stand where the notes have ended.
    let before = notes.source.text.get(..start.map_or(span.start, |display| display.start)).unwrap_or_default();
    // A mark directly before the display ends no other sentence.
    let without_marks =
        |end: usize| before[..end].trim_end_matches(|c: char| c.is_whitespace() || matches!(c, ':' | '.' | ';')).len();
    let mut end = without_marks(before.len());
    let mut displays = 0;
    for sentence in 0..=SENTENCES_BEFORE {
        let from = sentence_start(notes, end);
        let words = words_between(notes, from, end);
        let has_one_of = |list: &[&str]| words.iter().any(|word| list.contains(&word.as_str()));
        if has_one_of(&DENIALS) || sentence > 0 && has_one_of(&OF_ANY_SIZE) {
            return false;
        }
        let formulas = notes.inline.iter().filter(|span| span.start >= from && span.end <= end);
        let formulas: Vec<&str> =
            formulas.filter_map(|span| Some(notes.source.slice(body_of(notes, *span)?).trim())).collect();
        let is_much_smaller =
            |formula: &&str| formula.split_once("\\ll").is_some_and(|(left, _)| is_coordinate(left.trim()));
        let is_of_motion = || {
            let is_motion = |word: &String| MOTIONS.iter().any(|stem| word.starts_with(stem));
            words.iter().any(is_motion) || formulas.iter().any(|formula| is_coordinate(formula))
        };
        let is_said = words.iter().any(|word| word.starts_with("lineari"))
            || formulas.iter().any(is_much_smaller)
            || has_one_of(&["small"]) && (sentence == 0 || is_of_motion())
            || sentence == 0 && words.windows(2).any(|two| two == ["first", "order"]);
        if is_said {
            return true;
        }
        let next = without_marks(from);
        let is_crossed = |display: &Span| display.end <= from && display.end >= next;
        let crossed = notes.equations.iter().map(|display| display.span).find(is_crossed);
        // What is derived from the equations of a small motion is about it too.
        let goes_on = before[from..end].trim_start().starts_with(char::is_lowercase) || has_one_of(&DERIVES);
        if has_one_of(&OF_ANY_SIZE) || next == 0 || crossed.is_none() && before[next..from].contains("\n\n") {
            return false;
        }
        end = match crossed {
            Some(display) if goes_on && displays < DISPLAYS_BEFORE => without_marks(display.start),
            Some(_) => return false,
            None => next,
        };
        displays += usize::from(crossed.is_some());
    }
    false
}

/// The last place of one of these words.
fn last(words: &[String], list: &[&str]) -> Option<usize> {
    words.iter().rposition(|word| list.contains(&word.as_str()))
}

/// The words of a sentence before a formula in it.
fn words_before(notes: &Notes, span: Span) -> Vec<String> {
    words_between(notes, sentence_start(notes, span.start), span.start)
}

/// Where the sentence begins that goes on at a place: after the display, the mark or the blank line before it.
pub(crate) fn sentence_start(notes: &Notes, end: usize) -> usize {
    let text = &notes.source.text;
    let start = notes.equations.iter().map(|display| display.span.end).filter(|before| *before <= end).max();
    let mut from = start.unwrap_or(0).max(end.saturating_sub(LONGEST));
    while !text.is_char_boundary(from) {
        from += 1;
    }
    let words = without_formulas(notes, from, end);
    let mark = words.rfind(['.', '?', '!', ';', ':']).map_or(0, |at| at + 1);
    let blank = words.rfind("\n\n").map_or(0, |at| at + 2);
    from + mark.max(blank)
}

/// The words between two places, in small letters. Formulas are no words.
pub(crate) fn words_between(notes: &Notes, from: usize, to: usize) -> Vec<String> {
    // Of two statements of one display the later may begin before the end of the first, with all of its environment.
    let words = without_formulas(notes, from, to.max(from)).to_lowercase();
    words.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

fn without_formulas(notes: &Notes, from: usize, to: usize) -> String {
    let mut words = notes.source.text[from..to].to_owned();
    for other in notes.inline.iter().filter(|other| other.start >= from && other.end <= to) {
        words.replace_range(other.start - from..other.end - from, &" ".repeat(other.end - other.start));
    }
    // The name of a command, as in `\intertext{For small angles}`, is no word of the author.
    for (at, _) in words.clone().match_indices('\\') {
        let name = words[at + 1..].bytes().take_while(u8::is_ascii_alphabetic).count();
        words.replace_range(at..at + 1 + name, &" ".repeat(1 + name));
    }
    words
}
