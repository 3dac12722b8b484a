//! Frequencies and periods of small oscillations, and secular equations, as the prose names them.

use crate::latex::{name_search, names};
use crate::notes::claims::{Claim, Range, Spanned};

use super::notes_names::NotesNames;
use super::places::Place;
use super::words::Sentence;
use super::{ProseClaim, Refutes, spanned};

/// Words for a frequency, as they begin.
const FREQUENCY: [&str; 8] =
    ["frequen", "fréquen", "frecuen", "kreisfreq", "eigenfreq", "pulsation", "pulsac", "pulsaz"];

/// Words for a period, as they begin.
const PERIOD: [&str; 5] = ["period", "période", "período", "schwingungsdauer", "umlaufzeit"];

/// Words for small oscillations, as they begin.
const OSCILLATE: [&str; 12] = [
    "oscill", "vibrat", "librat", "rock", "swing", "schwing", "petit", "oszill", "pequeñ", "piccol", "small", "pushed",
];

/// Words for several frequencies at once, as they begin.
const MODES: [&str; 7] = ["normal", "secular", "root", "mode", "eigen", "characteristic", "proper"];

/// Words for the equation whose roots are the frequencies, as they begin.
const SECULAR: [&str; 5] = ["secular", "characteristic", "säkular", "charakteristisch", "séculaire"];

/// Words for what solves such an equation, as they begin.
const ROOTS: [&str; 5] = ["root", "solution", "wurzel", "lösung", "racine"];

/// The most words from "roots" to the equation that has them, as in "the roots of this secular equation".
const FARTHEST_ROOT: usize = 3;

/// The letters of frequencies, with which their names begin.
const LETTERS: [&str; 3] = ["\\omega", "\\Omega", "\\nu"];

/// The letters of periods.
const PERIODS: [&str; 3] = ["T", "\\tau", "\\mathcal{T}"];

/// The frequencies and periods that the prose names.
pub(super) fn infer(notes_names: &NotesNames<'_>, places: &[Place]) -> Vec<ProseClaim> {
    let mut found = Vec::new();
    for at in (0..notes_names.notes.equations.len()).filter(|at| notes_names.is_free(*at)) {
        let words = notes_names.before(at);
        if words.denies() {
            continue;
        }
        found.extend(secular_equation(notes_names, at, &words));
        found.extend(given_here(notes_names, at, &words, places));
    }
    found
}

/// What a display that gives names formulas says, if the words call these frequencies or a period.
fn given_here(notes_names: &NotesNames<'_>, at: usize, words: &Sentence, places: &[Place]) -> Option<ProseClaim> {
    let given: Vec<String> = notes_names
        .usages
        .iter()
        .filter(|usage| usage.introduced == Some(at) && usage.arguments.is_none() && !usage.moves)
        .map(|usage| usage.name.to_string())
        .chain(pair(notes_names, at))
        // What is declared as a constant, and no more, gets this meaning in its place.
        .filter(|name| !notes_names.is_declared(name) || notes_names.is_constant(name))
        .collect();
    let begins = |name: &str, letters: &[&str]| letters.iter().any(|letter| name_search::same(&base(name), letter));
    // The words may name any letter: "the frequency $n$".
    let is_said = |name: &str| words.formulas.iter().any(|formula| name_search::same(formula, name));
    let of = |letters: &[&str]| -> Vec<String> {
        given.iter().filter(|name| begins(name, letters) || is_said(name)).cloned().collect()
    };
    let (frequencies, periods) = (of(&LETTERS), of(&PERIODS));
    // After the equation of small oscillations the frequency needs no words.
    let goes_on = || at > 0 && words.is_empty() && notes_names.before(at - 1).says(&OSCILLATE);
    let is_frequency = !frequencies.is_empty() && (words.says(&FREQUENCY) || goes_on());
    let is_period = words.says(&PERIOD) && !periods.is_empty();
    let several = notes_names.coordinates().count() > 1;
    let mut under = Vec::new();
    let means: Vec<(String, String)> = if (is_frequency || words.says(&SECULAR)) && several && words.says(&MODES) {
        let both = |name: &String| match name.split_once("\\pm") {
            Some((before, after)) => ["+", "-"].map(|sign| format!("{before}{sign}{after}")).to_vec(),
            None => vec![name.clone()],
        };
        frequencies.iter().flat_map(both).map(|name| (name, "normal frequency".to_owned())).collect()
    } else if is_frequency && (words.says(&OSCILLATE) || goes_on()) && frequencies.len() == 1 {
        let about = about(notes_names, at, words, places);
        under = about.under;
        vec![(frequencies[0].clone(), format!("frequency of small oscillations{}", about.place))]
    } else if is_period && !is_frequency && periods.len() == 1 {
        let about = about(notes_names, at, words, places);
        under = about.under;
        vec![(periods[0].clone(), format!("period of small oscillations{}", about.place))]
    } else {
        return None;
    };
    let (name, what) = means.first()?;
    // Each display that gives the name a formula is tested, under the condition for the place.
    let others = (0..notes_names.notes.equations.len()).filter(|at| notes_names.is_free(*at));
    let displays: Vec<usize> =
        others.filter(|other| given.iter().any(|name| notes_names.is_given_in(*other, name))).collect();
    let displays = if displays.is_empty() { vec![at] } else { displays };
    let claim = Claim { implied: under, ..Claim::default() };
    let claims = displays.iter().filter(|_| !claim.implied.is_empty()).map(|at| (*at, claim.clone())).collect();
    let why = format!("{name} is the {what}, as the words before ({}) say", notes_names.notes.equations[at].id()?);
    let refutes = if what == "normal frequency" { Refutes::WithAnEdit } else { Refutes::WhereStable };
    Some(ProseClaim { means, claims, displays, refutes, why, ..ProseClaim::default() })
}

/// The name with both signs that a display gives a formula, as in `\omega_\pm^2 = …`.
fn pair(notes_names: &NotesNames<'_>, at: usize) -> Option<String> {
    let text = notes_names.notes.equations[at].text.trim_start();
    let letter = LETTERS.into_iter().find(|letter| text.starts_with(letter))?;
    let below = text[letter.len()..].trim_start();
    ["_\\pm", "_{\\pm}"].iter().any(|sign| below.starts_with(sign)).then(|| format!("{letter}_\\pm"))
}

/// The name without its subscript.
fn base(name: &str) -> String {
    names::parse(name).map_or_else(|| name.split('_').next().unwrap_or(name).to_owned(), |(name, _)| name.base)
}

/// The place about which a quantity oscillates.
struct About {
    /// The words that name it, as under `means`.
    place: String,
    /// The condition under which the coordinate stays there.
    under: Vec<Spanned<String>>,
}

/// The place that the words give, or the one that the display names.
fn about(notes_names: &NotesNames<'_>, at: usize, words: &Sentence, places: &[Place]) -> About {
    let is_coordinate = |text: &str| notes_names.coordinates().any(|(one, _)| name_search::same(&one.name.value, text));
    let is_place = |formula: &&String| {
        formula.split_once('=').is_some_and(|(left, right)| is_coordinate(left.trim()) && !right.contains('='))
    };
    let names_it = |place: &&Place| {
        let is_it = |formula: &String| {
            let value = formula.split('=').next_back().unwrap_or_default();
            name_search::same(value.trim(), &place.value)
        };
        words.formulas.iter().any(is_it) || notes_names.mentions(at, &place.value)
    };
    let is_referred_to = words.has_word(&["it", "this", "there", "dort"]);
    let said = words.formulas.iter().rev().find(is_place).cloned();
    // "The highest point, $\theta = \pi$, is stable. There the frequency is" is about the place of the sentence before.
    let before = || Sentence::all_before(notes_names.notes, at).into_iter().rev().nth(1);
    let told = || before()?.formulas.iter().rev().find(is_place).cloned();
    let told = if is_referred_to && said.is_none() { told() } else { None };
    // "About it", and about no other place where the coordinate cannot be 0.
    let is_last = |place: &&Place| place.at < at && (is_referred_to || !place.may_be_zero);
    let last = || places.iter().rev().filter(|_| told.is_none()).find(is_last);
    if let Some(place) = places.iter().find(names_it).or_else(last) {
        return About { place: format!(" about {} = {}", place.coordinate, place.value), under: place.under.clone() };
    }
    let place = told.or(said).map(|place| format!(" about {place}")).unwrap_or_default();
    About { place, under: Vec::new() }
}

/// Whether words say that what follows are the roots of a secular equation, and not that equation: "the roots of the secular equation
/// are", "the secular equation has the solutions". Solutions that are sought are none: "if we seek solutions …, the secular equation is".
fn gives_roots(words: &Sentence) -> bool {
    let (roots, equation) = (words.places(&ROOTS), words.places(&SECULAR));
    let is_of_it = |root: &usize| equation.iter().any(|at| at < root || at - root <= FARTHEST_ROOT);
    roots.iter().any(is_of_it)
}

/// Whether the words before a display call it a secular equation, or it only writes the one directly before it in another way: it has no
/// name that this one has not.
fn is_secular(notes_names: &NotesNames<'_>, at: usize, words: &Sentence) -> bool {
    if gives_roots(words) || notes_names.has_coordinates(at) || !notes_names.is_equality_of_determinants(at) {
        return false;
    }
    if words.says(&SECULAR) {
        return true;
    }
    let Some(before) = at.checked_sub(1) else { return false };
    let names = |at: usize| notes_names.names_in(&notes_names.notes.equations[at].text);
    let known = names(before);
    names(at).iter().all(|name| known.contains(name)) && is_secular(notes_names, before, &notes_names.before(before))
}

/// What a display says that is a secular equation by the words.
fn secular_equation(notes_names: &NotesNames<'_>, at: usize, words: &Sentence) -> Option<ProseClaim> {
    if !is_secular(notes_names, at, words) {
        return None;
    }
    let is_defined = |name: &&str| notes_names.is_defined(name);
    let is_meant = |name: &&str| {
        let means = notes_names.claims.means.iter().any(|(known, _)| name_search::same(&known.value, name));
        !means && notes_names.displays_with(name).contains(&at)
    };
    let name = LETTERS.into_iter().filter(is_meant).find(|name| !is_defined(name))?.to_owned();
    let mut claim = ProseClaim { displays: vec![at], ..ProseClaim::default() };
    if !notes_names.is_declared(&name) {
        claim.constants.push((name.clone(), Range::Positive));
    }
    claim.why = format!("({}) is the secular equation for {name}", notes_names.notes.equations[at].id()?);
    claim.claims.push((at, Claim { secular_for: Some(spanned(name)), ..Claim::default() }));
    Some(claim)
}
