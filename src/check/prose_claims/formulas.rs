//! Names that formulas in sentences tie to others: "for $u = x - vt$", "where $\tan\alpha = b/a$ is the slope", "in polar coordinates,
//! $x = r\cos\theta$ and $y = r\sin\theta$".
//!
//! A name that stands alone on the left is defined by its formula, and so is the ξ of `x = x_0 + \xi`. Where formulas give old coordinates as
//! formulas of as many new names, these are new coordinates. In any other equation the new names are constants, and the equation is a
//! hypothesis of the displays that have them.

use crate::formula::symbols::Name;
use crate::latex::names;
use crate::notes::claims::{Claim, Range};
use crate::source::Span;

use crate::check::document::inferred::prose::{body_of, follows_condition, is_announced};

use super::conditions::coordinate;
use super::constants::KNOWN;
use super::notes_names::NotesNames;
use super::{ProseClaim, spanned};

/// The letters of distances from a point or an axis, which are positive.
const RADII: [&str; 4] = ["r", "R", "\\rho", "\\varrho"];

/// An equation in a sentence.
struct Said {
    text: String,
    /// Whether a word such as "for" or "if" stands before it, so that it may be a case.
    may_be_a_case: bool,
    /// The name that is its left side.
    left: Option<Name>,
    /// Whether it gave a coordinate before it was solved for the new name.
    is_distance: bool,
    /// The names in it that nothing else says anything of.
    news: Vec<Name>,
}

impl Said {
    /// Whether it gives a coordinate, on its left side, as a formula of new names.
    fn gives_a_coordinate(&self, notes_names: &NotesNames<'_>) -> bool {
        let left = self.text.split('=').next().unwrap_or_default();
        coordinate(notes_names, left.trim()).is_some()
    }

    /// Where it gives a coordinate as a sum of a new name and other terms, the new name is the coordinate less these.
    fn solve_for_a_distance(&mut self, notes_names: &NotesNames<'_>) {
        let ([name], true) = (self.news.as_slice(), self.gives_a_coordinate(notes_names)) else { return };
        let Some((left, right)) = self.text.split_once('=') else { return };
        let is_it = |text: &str| names::parse(text.trim()).is_some_and(|(parsed, dots)| dots == 0 && parsed == *name);
        let ends = [right.rsplit_once('+'), right.split_once('+').map(|(first, rest)| (rest, first))];
        let place = ends.into_iter().flatten().find(|(_, one)| is_it(one)).map(|(place, _)| place.trim());
        // A sum of one level, in which nothing else has the name.
        let is_plain = |place: &&str| {
            let depth = |open: char, close: char| place.matches(open).count() == place.matches(close).count();
            depth('{', '}') && depth('(', ')') && !notes_names.has_name(place, &name.to_string())
        };
        let Some(place) = place.filter(|place| !place.is_empty()).filter(is_plain) else { return };
        let text = format!("{name} = {} - \\left({place}\\right)", left.trim());
        (self.left, self.text, self.is_distance) = (Some(name.clone()), text, true);
    }
}

/// The definitions and the hypotheses that formulas in sentences state.
pub(super) fn infer(notes_names: &NotesNames<'_>) -> Vec<ProseClaim> {
    let notes = notes_names.notes;
    let read = |span: &Span| {
        let text = notes.source.slice(body_of(notes, *span)?);
        let may_be_a_case = !is_announced(notes, *span) && follows_condition(notes, *span);
        equation(notes_names, text).map(|said| Said { may_be_a_case, ..said })
    };
    let mut said: Vec<Said> = notes.inline.iter().filter_map(read).collect();
    let mut found = Vec::new();
    // The first formula of a name defines it.
    let mut defined: Vec<Name> = Vec::new();
    for one in &mut said {
        one.solve_for_a_distance(notes_names);
        let Some(left) = one.left.clone().filter(|left| one.news == [left.clone()] && !defined.contains(left)) else {
            continue;
        };
        let displays = displays_with(notes_names, std::slice::from_ref(&left));
        let Some((_, formula)) = one.text.split_once('=').filter(|_| !displays.is_empty()) else { continue };
        found.push(ProseClaim {
            why: format!("{left} is {}, as a sentence says", formula.trim()),
            definitions: vec![(left.to_string(), with_fraction(formula.trim()))],
            displays,
            is_said: !one.may_be_a_case,
            is_enough: one.may_be_a_case,
            gives_coordinates: one.is_distance,
            ..ProseClaim::default()
        });
        defined.push(left);
    }
    said.retain(|one| one.left.is_none() && !one.news.iter().any(|name| defined.contains(name)));
    while let Some(first) = said.pop() {
        let mut news = first.news.clone();
        let mut group = vec![first];
        // Equations with a name in common belong together.
        while let Some(at) = said.iter().position(|one| one.news.iter().any(|name| news.contains(name))) {
            let next = said.remove(at);
            news.extend(next.news.iter().filter(|name| !news.contains(name)).cloned().collect::<Vec<_>>());
            group.push(next);
        }
        let displays = displays_with(notes_names, &news);
        if displays.is_empty() {
            continue;
        }
        let is_said = !group.iter().any(|one| one.may_be_a_case);
        let are_coordinates = news.len() == group.len() && group.iter().all(|one| one.gives_a_coordinate(notes_names));
        let texts: Vec<String> = group.into_iter().map(|one| one.text).collect();
        let hypotheses = texts.iter().cloned().map(spanned).collect();
        let claim = match are_coordinates {
            true => Claim { implied_throughout: hypotheses, ..Claim::default() },
            false => Claim { assume: hypotheses, ..Claim::default() },
        };
        let range = |name: &Name| match are_coordinates && RADII.contains(&name.base.as_str()) {
            true => Range::Positive,
            false => Range::Any,
        };
        let ranges: Vec<(String, Range)> = news.iter().map(|name| (name.to_string(), range(name))).collect();
        let (varying, constants) = if are_coordinates { (ranges, Vec::new()) } else { (Vec::new(), ranges) };
        found.push(ProseClaim {
            why: format!("{}, as a sentence says", texts.join(" and ")),
            constants,
            varying,
            claims: displays.iter().map(|at| (*at, claim.clone())).collect(),
            displays,
            is_said,
            is_enough: !is_said,
            gives_coordinates: are_coordinates,
            ..ProseClaim::default()
        });
    }
    found
}

/// The displays without a claim that have one of some names.
fn displays_with(notes_names: &NotesNames<'_>, of: &[Name]) -> Vec<usize> {
    let mut displays: Vec<usize> = of.iter().flat_map(|name| notes_names.displays_with(&name.to_string())).collect();
    displays.sort_unstable();
    displays.dedup();
    displays.retain(|at| notes_names.is_free(*at));
    displays
}

/// An equation with new names, if a formula is one. `x = x_0` says the value of a name, and no more.
fn equation(notes_names: &NotesNames<'_>, text: &str) -> Option<Said> {
    let text = text.trim().trim_end_matches([',', '.', ';']).trim();
    let (left, right) = text.split_once('=').filter(|_| text.matches('=').count() == 1)?;
    let is_chain = ["<", ">", "\\le", "\\ge", "\\approx", ",", "\\to", "\\neq"].iter().any(|sign| text.contains(sign));
    let left = names::parse(left.trim()).filter(|(_, dots)| *dots == 0).map(|(name, _)| name);
    let is_value = names::parse(right.trim()).is_some() || right.trim().parse::<f64>().is_ok();
    if is_chain || left.is_some() && is_value {
        return None;
    }
    let is_momentum = |name: &Name| {
        let is_of = |coordinate: &Name| name.subscript.concat() == coordinate.base && coordinate.subscript.is_empty();
        name.base == "p" && notes_names.coordinates().any(|(_, coordinate)| is_of(&coordinate))
    };
    let mut news: Vec<Name> = Vec::new();
    for name in notes_names.names_in(text) {
        let shown = name.to_string();
        let is_known = KNOWN.contains(&shown.as_str())
            || notes_names.is_declared(&shown)
            || notes_names.is_defined(&shown)
            || name.base == "e"
            || is_momentum(&name);
        if !is_known && !news.contains(&name) {
            news.push(name);
        }
    }
    (!news.is_empty()).then(|| Said {
        text: text.to_owned(),
        may_be_a_case: false,
        is_distance: false,
        left: left.filter(|left| news.contains(left)),
        news,
    })
}

/// `P/qB` as a fraction: on one line all after the slash stands below it, if there are no other terms. Displays decide whether it is so.
fn with_fraction(formula: &str) -> String {
    let (sign, rest) = formula.strip_prefix('-').map_or(("", formula), |rest| ("-", rest));
    match rest.split_once('/') {
        Some((above, below)) if !rest.contains(['+', '-', '(']) && !below.contains('/') => {
            format!("{sign}\\frac{{{}}}{{{}}}", above.trim(), below.trim())
        }
        _ => formula.to_owned(),
    }
}
