//! Special cases that formulas in the words around a display state: "if the bob does not swing ($\theta = 0$)", "for $M = 3m$",
//! "when $c \to \infty$", "equal masses ($M = m$):".
//!
//! They are tried for displays alone that fail without them, first those of the own sentence, then those of the paragraph, then
//! all since the last heading. A coordinate or a rate that has a value has it at all times, unless the words say that the
//! motion begins there.

use crate::formula::symbols::Name;
use crate::latex::{name_search, names};
use crate::notes::Notes;
use crate::notes::claims::{Claim, Declaration, Range, Spanned};

use crate::check::document::inferred::prose::body_of;

use super::constants::KNOWN;
use super::notes_names::{NotesNames, without_differentials};
use super::places::{Place, is_value_of, says_that_it_lasts};
use super::words::{PASSING, Sentence};
use super::{ProseClaim, spanned};

/// Words for the begin of a motion beside those for a release, as they begin.
const FIRST: [&str; 5] = ["first", "initial", "anfang", "anfäng", "début"];

/// Words for a place from which something falls.
const HEIGHT: [&str; 3] = ["height", "höhe", "hauteur"];

/// What stands in formulas that say what a name is, and in no value.
const FORMULAS: [&str; 3] = ["\\dot", "\\sqrt", "("];

/// Words for the rate of an angle, as they begin.
const TURNS: [&str; 9] =
    ["angular", "goes", "turn", "rotat", "revol", "precess", "winkelgeschw", "umläuf", "angulaire"];

/// Phrases for what is not accelerated, each word as it begins.
const UNACCELERATED: [&str; 9] = [
    "not accelerated",
    "no acceleration",
    "acceleration vanish",
    "accelerations vanish",
    "acceleration is zero",
    "stay at rest",
    "stays at rest",
    "remain at rest",
    "remains at rest",
];

/// Words for the order of an expansion, each at its place.
const ORDERS: [&str; 4] = ["zeroth", "first", "second", "third"];

/// Where conditions are sought, from near to far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scope {
    /// In the display, and in so many sentences before it.
    Sentences(usize),
    /// In all words since the last heading.
    Section,
}

impl Scope {
    pub const ALL: [Scope; 4] =
        [Scope::Sentences(1), Scope::Sentences(2), Scope::Sentences(usize::MAX), Scope::Section];
}

/// What the words of some scope say of the case that a display is about.
#[derive(Clone, Debug, Default, PartialEq)]
struct Case {
    /// Values at all times, each with what has it.
    throughout: Vec<(String, String)>,
    /// The rates that the words before the display itself keep at their values: in "steady motion, $\\dot\\theta = 0$", or with the
    /// acceleration 0 beside them.
    lasting: Vec<String>,
    /// Other equations and inequalities.
    assume: Vec<String>,
    /// A limit.
    limit: Option<String>,
    /// A constant in powers of which formulas are expanded, with the order.
    small: Option<(String, u32)>,
    /// Constants that only these formulas name.
    constants: Vec<(String, Range)>,
}

/// The claim that a display is about the case that the words of a scope state; `None` where they state none. `places` are values of
/// coordinates at which the system stays, and `formula_of` gives the last formula that holds for a name.
pub(super) fn infer(
    names: &NotesNames<'_>,
    at: usize,
    scope: Scope,
    places: &[Place],
    formula_of: &dyn Fn(&str) -> Option<String>,
) -> Option<ProseClaim> {
    let mut case = Case::default();
    let first = match scope {
        Scope::Section => section_start(names.notes, at),
        Scope::Sentences(_) => at,
    };
    for display in first..=at {
        let sentences = Sentence::all_before(names.notes, display);
        let skipped = match scope {
            Scope::Sentences(count) => sentences.len().saturating_sub(count),
            Scope::Section => 0,
        };
        for words in &sentences[skipped..] {
            case.add(names, (words, &words.formulas));
            case.turns(names, display, words);
            case.stops(names, at, words);
            if display == at {
                case.keeps_rates(names, words);
                case.small = order_of(names, words).or(case.small);
                case.is_unaccelerated(names, at, words);
            }
        }
        if let Some(words) = sentences.last() {
            case.add(names, (words, &inside(&names.notes.equations[display].text)));
        }
    }
    case.stays_at(names, at, places);
    // Who says that a name has a value writes the value in its place. A condition on a name that is printed would hide slips.
    let text = &names.notes.equations[at].text;
    let printed = if inside(text).is_empty() {
        text.as_str()
    } else {
        text.split_once(':').map_or(text.as_str(), |(_, rest)| rest)
    };
    let differentiated = printed;
    let printed = &without_differentials(printed);
    let distances = distances(names, printed);
    let is_printed = |name: &str| {
        let name = without_dots(name.split('(').next().unwrap_or(name).trim());
        names.has_name(printed, name) || distances.iter().any(|formula| is_a_term(name, formula))
    };
    let prints_rate = |of: &str| {
        let dots = names.moving_names_in(printed);
        dots.iter().any(|name| name_search::same(&name.to_string(), without_dots(of)))
    };
    let lasting = &case.lasting;
    case.throughout.retain(|(of, _)| !is_printed(of) || lasting.contains(of) && !prints_rate(of));
    // A derivative by a coordinate is taken before this has its value.
    let is_by = |of: &str| !is_printed(of) && names.has_name(differentiated, of);
    let at_the_end = case.throughout.extract_if(.., |(of, _)| is_by(of));
    case.assume.extend(at_the_end.map(|(of, value)| format!("{of} = {value}")));
    // Of the two signs of a root the one of the rate is meant.
    let left = differentiated.split('=').next().unwrap_or_default().trim();
    if left.starts_with("\\dot")
        && names.names_in(left).len() == 1
        && is_root(differentiated)
        && !case.throughout.is_empty()
    {
        case.assume.push(format!("{left} > 0"));
    }
    // That something does not change says nothing of its value.
    let is_rate = |of: &str| of.starts_with("\\dot") && !printed.contains("\\dot");
    let is_a_start = |of: &str| of.contains("(0)") && distances.is_empty();
    let may_stay = |of: &str| is_a_start(of) || is_rate(of) || !is_printed(of.trim());
    // Of two constants that are equal the display prints one.
    let is_other = |value: &str| names.is_constant(value.trim()) && !is_printed(value);
    case.assume.retain(|said| said.split_once('=').is_none_or(|(of, value)| may_stay(of) || is_other(value)));
    // What vanishes does so in each of its formulas.
    let vanishing = case.assume.iter().filter_map(|said| said.split_once('=')).filter(|(_, value)| value.trim() == "0");
    let formulas: Vec<String> = vanishing.filter_map(|(of, _)| formula_of(of.trim())).collect();
    case.assume.extend(formulas.into_iter().map(|formula| format!("{formula} = 0")));
    // The same of a limit, but for a relation that says itself that it is near.
    let is_near = ["\\approx", "\\simeq", "\\sim"].iter().any(|sign| printed.contains(sign));
    case.limit =
        case.limit.filter(|limit| is_near || !is_printed(limit.split("\\to").next().unwrap_or_default().trim()));
    let mut claim = Claim {
        assume: case.assume.into_iter().map(spanned).collect(),
        limit: case.limit.map(spanned),
        ..Claim::default()
    };
    if let Some((name, order)) = case.small.filter(|(name, order)| *order == 0 || is_printed(name)) {
        claim.small = vec![spanned(name)];
        claim.order = Some(spanned(order));
    }
    claim.throughout = case.throughout.into_iter().map(|(of, value)| spanned(format!("{of} = {value}"))).collect();
    if claim == Claim::default() {
        return None;
    }
    let order = claim.order.as_ref().map(|order| order.value);
    let said = claim.throughout.iter().chain(&claim.assume).chain(&claim.limit).map(|text| text.value.clone());
    let small = claim.small.iter().zip(order).map(|(name, order)| format!("to order {order} in {}", name.value));
    let said: Vec<String> = said.chain(small).collect();
    let id = names.notes.equations[at].id()?;
    Some(ProseClaim {
        why: format!("({id}) is about the case {}, as the words around it say", said.join(", ")),
        constants: case.constants,
        claims: vec![(at, claim)],
        displays: vec![at],
        ..ProseClaim::default()
    })
}

/// The formulas by which sentences define names that a text prints: x − x_0 for ξ.
fn distances<'n>(names: &'n NotesNames<'_>, printed: &str) -> Vec<&'n str> {
    let inline =
        names.notes.inline.iter().filter_map(|span| Some(names.notes.source.slice(body_of(names.notes, *span)?)));
    let said = inline.filter_map(|text| text.split_once('='));
    let defined = names.claims.define.iter().map(|(name, formula)| (name.value.as_str(), formula.value.as_str()));
    let is_of_it = |(name, formula): &(&str, &str)| {
        let is_name = names::parse(name.trim()).is_some() && names.has_name(printed, name.trim());
        is_name && !formula.contains("\\dot") && names.coordinates().any(|(one, _)| is_a_term(&one.name.value, formula))
    };
    said.chain(defined).filter(is_of_it).map(|(_, formula)| formula).collect()
}

/// Whether one side of an equality is a root, and nothing but it.
fn is_root(printed: &str) -> bool {
    printed.split('=').nth(1).is_some_and(|right| right.trim().starts_with("\\sqrt"))
        && printed.matches('=').count() == 1
}

/// Whether a name by itself is one of several terms of a formula.
fn is_a_term(name: &str, formula: &str) -> bool {
    let terms: Vec<&str> = formula.split(['+', '-']).map(|term| term.trim().trim_end_matches([',', '.'])).collect();
    terms.len() > 1 && terms.iter().any(|term| name_search::same(term, name))
}

/// A name without the dots above it.
fn without_dots(name: &str) -> &str {
    name.strip_prefix("\\dot").map_or(name, |rest| rest.trim_matches(['{', '}', ' ']))
}

/// The first display after the last heading before a display.
fn section_start(notes: &Notes, at: usize) -> usize {
    let text = &notes.source.text;
    let begins = |display: usize| {
        let end = notes.equations[display].span.start;
        let from = display.checked_sub(1).map_or(0, |before| notes.equations[before].span.end).min(end);
        text[from..end].lines().any(is_heading)
    };
    (0..=at).rev().find(|display| begins(*display)).unwrap_or(0)
}

/// Whether a line is a heading, or begins with words that are set off as one.
fn is_heading(line: &str) -> bool {
    let line = line.trim_start();
    let marks = ["#", "**", "*", "\\section", "\\subsection", "\\subsubsection", "\\paragraph", "\\textbf{", "\\emph{"];
    marks.iter().any(|mark| line.starts_with(mark)) && !line.starts_with("* ")
}

/// The formulas in brackets in words inside a display: `\text{equal masses } (M = m): \quad`.
fn inside(display: &str) -> Vec<String> {
    let trimmed = display.trim_start();
    if !["\\text", "\\mbox", "\\mathrm"].iter().any(|mark| trimmed.starts_with(mark)) {
        return Vec::new();
    }
    let (Some(open), Some(end)) = (trimmed.find('('), trimmed.find(':')) else { return Vec::new() };
    let bracket = trimmed.get(open + 1..end).and_then(|inner| inner.trim_end().strip_suffix(')'));
    bracket.map(|inner| inner.trim_matches(['$', ' ']).to_owned()).into_iter().collect()
}

impl Case {
    /// Adds what formulas among words say.
    fn add(&mut self, names: &NotesNames<'_>, (words, formulas): (&Sentence, &[String])) {
        // "To first order" says nothing of a begin.
        let is_of_an_order = words.says_phrase(&["first order"]);
        let begins = words.says_that_it_starts() || words.says(&FIRST) && !is_of_an_order;
        let rests = words.says_that_it_rests();
        let mut is_start = false;
        for formula in formulas {
            if let Some(limit) = limit(formula) {
                self.limit = Some(limit);
                continue;
            }
            let members: Vec<&str> = formula.split('=').map(str::trim).collect();
            let Some((value, others)) = members.split_last().filter(|(_, others)| !others.is_empty()) else {
                if ['<', '>'].iter().any(|sign| formula.contains(*sign)) {
                    self.assume.push(formula.clone());
                }
                continue;
            };
            for member in others {
                if member.contains("\\ddot") || FORMULAS.iter().any(|sign| value.contains(sign)) {
                    continue;
                }
                is_start |= begins && self.starts(names, member, value);
                if !begins {
                    self.has_value(names, member, value);
                }
            }
        }
        // "Falls from the height $h$": the only coordinate begins there.
        let mut all = names.coordinates();
        if let (true, false, Some((only, _)), None) = (begins && rests, is_start, all.next(), all.next())
            && words.says(&HEIGHT)
            && let [place] = formulas
            && names.is_constant(place)
        {
            is_start |= self.starts(names, &only.name.value, place);
        }
        if is_start && rests {
            for (declared, _) in names.coordinates() {
                let at_rest = starts_slowly(&declared.name.value);
                if !self.assume.contains(&at_rest) {
                    self.assume.push(at_rest);
                }
            }
        }
    }

    /// Adds that a motion begins where a coordinate has a value. Of constants it says what any condition does.
    fn starts(&mut self, names: &NotesNames<'_>, member: &str, value: &str) -> bool {
        let Some(declared) = coordinate(names, member) else {
            self.has_value(names, member, value);
            return false;
        };
        for condition in start_at(&declared.name.value, value) {
            if !self.assume.contains(&condition) {
                self.assume.push(condition);
            }
        }
        true
    }

    /// Adds that something has a value.
    fn has_value(&mut self, names: &NotesNames<'_>, member: &str, value: &str) {
        let rate = |one: &Declaration| {
            let name = &one.name.value;
            [format!("\\dot{name}"), format!("\\dot {name}"), format!("\\dot{{{name}}}")]
                .iter()
                .any(|rate| rate == member)
        };
        let moving = coordinate(names, member).is_some() || names.coordinates().any(|(one, _)| rate(one));
        if moving {
            // A display that gives it a formula defines it.
            let is_new = !KNOWN.contains(&value) && !names.is_declared(value) && !names.is_defined(value);
            if is_new && names::parse(value).is_some() {
                self.constants.push((value.to_owned(), Range::Any));
            }
            self.throughout.retain(|(of, _)| of != member);
            self.throughout.push((member.to_owned(), value.to_owned()));
            return;
        }
        // A name that displays have not, as of a constraint f_1 = 0, says nothing of them.
        let is_known = |name: &Name| {
            let shown = name.to_string();
            KNOWN.contains(&shown.as_str()) || names.is_declared(&shown) || names.usages.iter().any(|u| u.name == *name)
        };
        if names.names_in(member).iter().all(is_known) {
            self.assume.push(format!("{member} = {value}"));
        }
    }

    /// Notes the rates that words keep at 0: where they say that a state lasts, or that the acceleration is 0 too.
    fn keeps_rates(&mut self, names: &NotesNames<'_>, words: &Sentence) {
        let plain =
            |text: &str| text.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect::<String>();
        let said: Vec<String> = words.formulas.iter().map(|formula| plain(formula)).collect();
        let lasts = says_that_it_lasts(words);
        for (declared, _) in names.coordinates() {
            let name = plain(&declared.name.value);
            if lasts || said.contains(&format!("\\ddot{name}=0")) {
                let rate = format!("\\dot{name}");
                let rates = self.throughout.iter().filter(|(of, value)| plain(of) == rate && value == "0");
                let rates: Vec<String> = rates.map(|(of, _)| of.clone()).collect();
                self.lasting.extend(rates);
            }
        }
    }

    /// Adds that a coordinate stays at the value that a display before this one gives, and that this one prints in its place: "the radius
    /// of the circle is $r_0 = …$, that is, with $\\dot\\theta = …$".
    fn stays_at(&mut self, names: &NotesNames<'_>, at: usize, places: &[Place]) {
        for place in places.iter().filter(|place| place.at < at && names.mentions(at, &place.value)) {
            if !self.throughout.iter().any(|(of, _)| name_search::same(of, &place.coordinate)) {
                self.throughout.push((place.coordinate.clone(), place.value.clone()));
            }
        }
    }

    /// Adds that the coordinates of a display do not change at the instant of which the words speak: "the turning points are the roots
    /// of".
    fn stops(&mut self, names: &NotesNames<'_>, at: usize, words: &Sentence) {
        if !words.says_phrase(&PASSING) {
            return;
        }
        let text = &names.notes.equations[at].text;
        for (declared, _) in names.coordinates().filter(|(one, _)| names.has_name(text, &one.name.value)) {
            let stops = format!("\\dot{{{}}} = 0", declared.name.value);
            if !self.assume.contains(&stops) {
                self.assume.push(stops);
            }
        }
    }

    /// Adds that coordinates have no acceleration, where the words say so of a relation between constants: "the first mass is not
    /// accelerated, $\\ddot x = 0$, if", "the masses stay at rest if".
    fn is_unaccelerated(&mut self, names: &NotesNames<'_>, at: usize, words: &Sentence) {
        if names.has_coordinates(at) || names.mentions(at, "t") || names.introduces(at) {
            return;
        }
        let acceleration = |one: &Declaration| format!("\\ddot{{{}}} = 0", one.name.value);
        let is_zero = |name: &str, formula: &String| {
            let formula: String = formula.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect();
            let name: String = name.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect();
            formula == format!("\\ddot{name}=0")
        };
        let said: Vec<&Declaration> = names
            .coordinates()
            .map(|(one, _)| one)
            .filter(|one| words.formulas.iter().any(|formula| is_zero(&one.name.value, formula)))
            .collect();
        let all = || names.coordinates().map(|(one, _)| one).collect();
        let said = if said.is_empty() && words.says_phrase(&UNACCELERATED) { all() } else { said };
        for condition in said.into_iter().map(acceleration) {
            if !self.assume.contains(&condition) {
                self.assume.push(condition);
            }
        }
    }

    /// Adds that a name that a display gives a formula is the rate of the angle, where the words call it so and other coordinates
    /// stay in their places.
    fn turns(&mut self, names: &NotesNames<'_>, at: usize, words: &Sentence) {
        if self.throughout.is_empty() || !words.says(&TURNS) {
            return;
        }
        let is_fixed = |name: &str| self.throughout.iter().any(|(of, _)| of == name || of.contains(name));
        let mut angles = names
            .coordinates()
            .filter(|(one, _)| matches!(one.range.value, Range::Angle) && !is_fixed(&one.name.value));
        let is_place = |name: &Name| names.coordinates().any(|(_, coordinate)| is_value_of(name, &coordinate));
        let (Some((angle, _)), None) = (angles.next(), angles.next()) else { return };
        let given = names.usages.iter().find(|usage| usage.introduced == Some(at) && usage.arguments.is_none());
        if let Some(given) = given.filter(|given| !is_place(&given.name)) {
            self.throughout.push((format!("\\dot{{{}}}", angle.name.value), given.name.to_string()));
        }
    }
}

/// The conditions that a motion begins where a coordinate has a value. There it is at rest, or passes at a right angle.
pub(super) fn start_at(coordinate: &str, value: &str) -> [String; 2] {
    [format!("{coordinate}(0) = {value}"), starts_slowly(coordinate)]
}

fn starts_slowly(coordinate: &str) -> String {
    format!("\\dot{{{coordinate}}}(0) = 0")
}

/// The coordinate that a text is.
pub(super) fn coordinate<'n>(names: &NotesNames<'n>, text: &str) -> Option<&'n Declaration> {
    let found = names.coordinates().find(|(one, _): &(&Declaration, Name)| name_search::same(&one.name.value, text));
    found.map(|(one, _)| one)
}

/// The limit that a formula states.
fn limit(formula: &str) -> Option<String> {
    let (name, end) =
        ["\\to", "\\rightarrow", "\\longrightarrow"].iter().find_map(|arrow| formula.split_once(arrow))?;
    let (name, end) = (name.trim(), end.trim());
    let is_end = end == "0" || end.trim_start_matches(['+', '-', ' ']) == "\\infty";
    (is_end && names::parse(name).is_some()).then(|| format!("{name} \\to {end}"))
}

/// The constant in powers of which words say that something is expanded, with the order: "to first order in $\epsilon$", "neglecting terms
/// of order $\epsilon^2$".
fn order_of(names: &NotesNames<'_>, words: &Sentence) -> Option<(String, u32)> {
    let is_one = |name: &str| names.is_constant(name) && coordinate(names, name).is_none();
    let neglected = |formula: &String| {
        let inner = formula.trim().trim_start_matches(['O', '(', '{', ' ']).trim_end_matches([')', ' ']);
        let (name, power) = inner.split_once('^')?;
        let power: u32 = power.trim_matches(['{', '}', ' ']).parse().ok()?;
        (power > 0 && is_one(name.trim())).then(|| (name.trim().to_owned(), power - 1))
    };
    if words.says(&["neglect", "ignor", "omit", "dropping", "up to"]) && words.says(&["order", "term"]) {
        return words.formulas.iter().find_map(neglected);
    }
    let order = ORDERS.iter().position(|one| words.says_phrase(&[format!("{one} order in").as_str()]))?;
    let mut constants = words.formulas.iter().filter(|formula| is_one(formula));
    let (name, None) = (constants.next()?, constants.next()) else { return None };
    Some((name.clone(), u32::try_from(order).ok()?))
}

/// Adds the conditions of a claim to another one, which keeps its own.
pub(super) fn join(known: &mut Claim, new: &Claim) {
    let add = |known: &mut Vec<Spanned<String>>, new: &[Spanned<String>]| {
        let is_new = |one: &&Spanned<String>| !known.iter().any(|other| other.value == one.value);
        let fresh: Vec<Spanned<String>> = new.iter().filter(is_new).cloned().collect();
        known.extend(fresh);
    };
    add(&mut known.assume, &new.assume);
    add(&mut known.throughout, &new.throughout);
    known.limit = known.limit.take().or_else(|| new.limit.clone());
    if known.small.is_empty() {
        known.small.clone_from(&new.small);
        known.order.clone_from(&new.order);
    }
}
