//! The ways in which the letters of a hand-in may be those of the problem, the likeliest first, and the best of them.

use super::likeness::Likeness;
use super::matching::{self, is_any_mode, may_stand_for};
use super::{supported, with_slips};
use std::collections::HashMap;

use crate::Result;
use crate::formula::symbols::Name;
use crate::latex::rename::renamed_with;
use crate::latex::{Macros, names};
use crate::notes::Notes;

use crate::check::document::setup::{Run, define_macros};
use crate::check::sample::context::Options;
use crate::check::usage::{Usage, names_of};

use crate::check::mark::judge::{judge, judge_quickly};
use crate::check::mark::judged::{Judged, Rival, counted};
use crate::check::mark::marked::Mark;
use crate::check::mark::names::{Letters, Names, Role, StandsFor};
use crate::check::mark::problem::{self, Problem};
use crate::check::mark::world::World;
use crate::check::mark::written::{
    Written, accelerations, energies, functions, groups, instants, signs, single_letters, slashes, slopes, written,
};

/// The most ways that are tried.
const WAYS: usize = 60;

/// The number of states at which a way is tried.
const POINTS: usize = 8;

/// The hand-in, judged with the letters that fit best, and those letters with what they stand for.
///
/// # Errors
/// When the problem cannot be applied to the hand-in.
pub(in crate::check::mark) fn best(
    run: &Run<'_>,
    problem: &Problem,
    notes: &Notes,
) -> Result<(Judged, Vec<(String, String)>)> {
    let mut macros = Macros::default();
    define_macros(&notes.macros, &mut macros);
    let mut lines = written(notes, &macros);
    instants::without_ohms(&mut lines, &problem.names);
    signs::named(&mut lines, &problem.names);
    accelerations::named(&mut lines, &problem.names, &problem.notes);
    let mut instants = instants::named(&mut lines, &problem.names);
    functions::of_constants(&mut lines, &problem.names, &mut instants);
    single_letters::instants(&mut lines, &problem.names, &macros);
    single_letters::charges(&mut lines, &problem.names);
    slopes::by_constants(&mut lines, &problem.names);
    single_letters::lengths(&mut lines, &problem.names);
    groups::with_rates(&mut lines);
    energies::kinetic(&mut lines, &problem.names, &macros);
    slashes::with_products(&mut lines);
    let used = usages(notes, &lines, &macros);
    let known = &problem.names;
    let declared = declared(problem, &used);
    let world = |table: &Letters, run: &Run<'_>| {
        World::new(run, problem, (notes, &lines, &instants), &with_primes(&used, known, table))
    };
    let shown = |table: &Letters| {
        let mut pairs: Vec<(String, String)> =
            table.iter().map(|(a, b)| (single_letters::as_written(&a.to_string()), b.latex())).collect();
        pairs.sort();
        pairs
    };
    let quick = Run { options: Options { points: POINTS, explain: false, ..run.options }, ..*run };
    let mut best = declared.clone();
    let (by_form, ways) = all_ways(problem, (&lines, &macros), &used, &declared);
    let names: Vec<Vec<Usage>> =
        lines.iter().map(|line| all_usages(notes, std::slice::from_ref(line), &macros)).collect();
    if !ways.is_empty() {
        let results = problem.wanted.len();
        let first = Rival { score: i64::MIN, known: vec![None; lines.len()], reached: Vec::new(), results };
        let own = judge_quickly(&quick, &world(&declared, &quick)?, &first)?;
        let (mut score, mut is_whole) = (own.score(), self::is_whole(&own));
        let mut most_false = own.lines.iter().filter(|line| line.mark == Mark::Wrong).count();
        let mut tried = vec![(declared.clone(), own)];
        let mut place = 0;
        for way in ways {
            if is_whole {
                break;
            }
            // A line that is one of the problem outweighs a slip that a letter of the student's own would hide.
            let is_by_form = by_form.contains(&way);
            let bar = score - i64::from(is_by_form && !by_form.contains(&best));
            let rival = rival(&tried, (bar, results), |other| changed(known, &names, (other, &way)));
            if !rival.may_be_beaten(&[]) {
                continue;
            }
            let judged = world(&way, &quick).and_then(|world| judge_quickly(&quick, &world, &rival));
            let Ok(judged) = judged else { continue };
            // A guess that makes more lines false than the letters before is no better for other lines that it makes true.
            let is_false = |judged: &Judged| judged.lines.iter().filter(|line| line.mark == Mark::Wrong).count();
            // A hand-in with a slip has false lines with its own letters too: that it reaches more results says more.
            let reaches_more = judged.reached() > tried[place].1.reached() && 2 * is_false(&judged) <= lines.len();
            let is_sound = is_false(&judged) <= most_false || reaches_more || is_likely(&way, &declared) || is_by_form;
            let is_supported =
                supported::is_supported(problem, (&declared, &way, is_by_form), &names, (&tried[0].1, &judged));
            let is_honest = is_by_form || !by_form.contains(&best) || !only_hides(&tried[place].1, &judged);
            if judged.is_complete() && judged.score() > bar && is_sound && is_supported && is_honest {
                place = tried.len();
                most_false = most_false.max(is_false(&judged));
                is_whole = self::is_whole(&judged);
                (score, best) = (judged.score(), way.clone());
            }
            tried.push((way, judged));
        }
    }
    let mut judged = judge(run, &world(&best, run)?)?;
    if with_slips::says_nothing(known, &best, &names, &judged) {
        let plain = judged.lines.iter().map(counted).collect::<Vec<_>>();
        let mut most = None;
        for way in ways_with_slips(problem, (&lines, &macros), &used, &declared) {
            let Ok(other) = world(&way, run).and_then(|world| judge(run, &world)) else { continue };
            let sound = with_slips::sound(&plain, &other);
            if sound > most {
                (judged, best, most) = (other, way, sound);
            }
        }
    }
    Ok((judged, shown(&with_primes(&used, known, &best))))
}

/// The ways in which a line is an equation of the problem with a slip.
fn ways_with_slips(
    problem: &Problem,
    (lines, macros): (&[Written], &Macros),
    used: &[Usage],
    declared: &Letters,
) -> Vec<Letters> {
    let known = &problem.names;
    let is_own = |name: &Name| used.iter().any(|usage| usage.name == *name && is_own(usage, used, known, declared));
    let is_free = |name: &Name| used.iter().all(|usage| usage.name != *name);
    let tables = matching::tables((problem, Likeness::ButForSlips), (lines, macros), is_own, is_free);
    let with_declared = |table: Letters| declared.clone().into_iter().chain(table).collect::<Letters>();
    let tables = tables.into_iter().map(with_declared).take(TABLES);
    // The lines that have no form of the problem may have further letters.
    tables.flat_map(|table| ways(used, known, &table).into_iter().take(WAYS_BESIDE_A_SLIP).chain([table])).collect()
}

/// The most tables of letters by a line with a slip that are tried, and the ways that are tried beside each.
const TABLES: usize = 3;
const WAYS_BESIDE_A_SLIP: usize = 2;

/// Whether letters are no better than those with which a line is one of the problem: they make nothing more true, and take lines for
/// definitions, of which at least as many are true as false.
fn only_hides(by_form: &Judged, judged: &Judged) -> bool {
    let pairs = || by_form.lines.iter().map(counted).zip(judged.lines.iter().map(counted));
    let hidden = |of: Mark| pairs().filter(|pair| *pair == (of, Mark::Given)).count();
    let is_more = pairs().any(|(before, now)| now == Mark::Right && before != Mark::Right);
    hidden(Mark::Wrong) > 0 && hidden(Mark::Right) >= hidden(Mark::Wrong) && !is_more
}

/// What the letters that were tried say of others, for which `changed` tells the lines that are not the same with them.
fn rival(
    tried: &[(Letters, Judged)],
    (score, results): (i64, usize),
    changed: impl Fn(&Letters) -> Vec<bool>,
) -> Rival {
    let all: Vec<(&Judged, Vec<bool>)> = tried.iter().map(|(other, judged)| (judged, changed(other))).collect();
    let lines = all.first().map_or(0, |(_, is_changed)| is_changed.len());
    let known = |at: usize| {
        let mut same = all.iter().filter(|(_, is_changed)| !is_changed[at]);
        same.find_map(|(judged, _)| judged.lines.get(at).map(counted))
    };
    let known = (0..lines).map(known).collect();
    let complete = all.into_iter().filter(|(judged, _)| judged.is_complete());
    let reached = complete.map(|(judged, is_changed)| (judged.reached(), is_changed)).collect();
    Rival { score, known, reached, results }
}

/// The letters, and the names with primes: rates of what varies, where the problem itself has no such names.
fn with_primes(used: &[Usage], known: &Names, table: &Letters) -> Letters {
    let mut all = table.clone();
    let has_primed_rates = has_primed_rates(used, known, table);
    for usage in used.iter().filter(|usage| usage.name.primes > 0 && known.symbols.find(&usage.name).is_none()) {
        let plain = Name { primes: 0, ..usage.name.clone() };
        let own = StandsFor { name: plain.clone(), dots: 0 };
        let of = table.get(&plain).unwrap_or(&own);
        let dots = of.dots.saturating_add(usage.name.primes);
        // After a change of the motion a' is another acceleration, where no prime of a coordinate says otherwise.
        let varies = |(name, role, _): &(Name, Role, bool)| {
            *name == of.name && (*role == Role::Moving || *role == Role::Determined && has_primed_rates)
        };
        // So are those of what only the hand-in has, and writes without primes too: `r = r_0 + x`, and then x''.
        let is_own = || {
            let is_known = known.symbols.find(&of.name).is_some() || table.contains_key(&plain);
            has_primed_rates && !is_known && used.iter().any(|usage| usage.name == plain)
        };
        if dots <= 2 && (known.names.iter().any(varies) || is_own()) {
            all.insert(usage.name.clone(), StandsFor { name: of.name.clone(), dots });
        }
    }
    all
}

/// Whether primes stand for rates of a coordinate somewhere.
fn has_primed_rates(used: &[Usage], known: &Names, table: &Letters) -> bool {
    used.iter().filter(|usage| usage.name.primes > 0).any(|usage| {
        let plain = Name { primes: 0, ..usage.name.clone() };
        let of = table.get(&plain).map_or(&plain, |other| &other.name);
        known.names.iter().any(|(name, role, _)| name == of && *role == Role::Moving)
    })
}

/// Whether every line holds, and every result is reached.
fn is_whole(judged: &Judged) -> bool {
    judged.lines.iter().all(|line| matches!(line.mark, Mark::Right | Mark::Given))
        && judged.found.iter().all(|found| found.as_ref().is_some_and(|found| found.is_right))
}

/// The lines of which the mark may differ between two ways: those with a name that stands for something else, and with what such
/// a line says of names that only the hand-in has. `names` are those in each line.
fn changed(known: &Names, names: &[Vec<Usage>], (other, way): (&Letters, &Letters)) -> Vec<bool> {
    let plain = |name: &Name| Name { primes: 0, ..name.clone() };
    let all = other.keys().chain(way.keys());
    let mut new: Vec<Name> = all.filter(|name| other.get(name) != way.get(name)).map(plain).collect();
    let mut is_changed = vec![false; names.len()];
    loop {
        // What stands for a value at an instant has the name of the letter in it.
        let has_new = |usage: &Usage| {
            new.contains(&plain(&usage.name))
                || instants::is_instant(&usage.name)
                || usage.name.base == "p" && !usage.name.subscript.is_empty()
        };
        let found = (0..names.len()).find(|at| !is_changed[*at] && names[*at].iter().any(has_new));
        let Some(at) = found else { return is_changed };
        is_changed[at] = true;
        let own = names[at].iter().map(|usage| plain(&usage.name)).filter(|name| known.symbols.find(name).is_none());
        new.extend(own);
    }
}

/// The names in lines, without those of values at instants.
fn usages(notes: &Notes, lines: &[Written], macros: &Macros) -> Vec<Usage> {
    let mut all = all_usages(notes, lines, macros);
    all.retain(|usage| !instants::is_instant(&usage.name));
    all
}

fn all_usages(notes: &Notes, lines: &[Written], macros: &Macros) -> Vec<Usage> {
    let displays: Vec<_> = lines
        .iter()
        .map(|line| crate::notes::Display {
            span: line.body,
            body: line.body,
            parts: vec![line.body],
            text: renamed_with(&line.text, macros, &HashMap::new(), &line.edits).text,
            number: None,
            labels: Vec::new(),
            automatic: Vec::new(),
            numbers_rows: false,
            line: notes.source.line_column(line.body.start).0,
        })
        .collect();
    names_of(&displays, macros)
}

/// The letters that the rubric declares, where the hand-in uses them and not the problem's own.
fn declared(problem: &Problem, used: &[Usage]) -> Letters {
    let parsed = |text: &str| names::parse(text).map(|(name, _)| name);
    let mut table = Letters::new();
    for (own, other) in problem::declared_letters(&problem.rubric) {
        let (Some(own), Some(other)) = (parsed(&own.value), parsed(&other.value)) else { continue };
        let is_used = |name: &Name| used.iter().any(|usage| usage.name == *name);
        if is_used(&other) && !is_used(&own) {
            table.insert(other, StandsFor { name: own, dots: 0 });
        }
    }
    table
}

/// Whether the primes of a name make it a rate: without them it is, or stands for, what varies. Otherwise they make it another
/// quantity, such as a velocity after a collision.
fn is_rate(name: &Name, used: &[Usage], known: &Names, declared: &Letters) -> bool {
    let varies =
        |role: &Role| *role == Role::Moving || *role == Role::Determined && has_primed_rates(used, known, declared);
    let plain = Name { primes: 0, ..name.clone() };
    let other = declared.get(&plain).map_or(&plain, |other| &other.name);
    known.names.iter().any(|(known, role, _)| known == other && varies(role))
        || known.symbols.find(&plain).is_none() && has_primed_accelerations(used) && is_used(used, &plain)
}

/// Whether a letter of the student's own stands with two primes and without any, as in `x'' = -\omega^2 x`: then primes are rates.
fn has_primed_accelerations(used: &[Usage]) -> bool {
    let plain = |usage: &Usage| Name { primes: 0, ..usage.name.clone() };
    used.iter().any(|usage| usage.name.primes == 2 && is_used(used, &plain(usage)))
}

fn is_used(used: &[Usage], name: &Name) -> bool {
    used.iter().any(|usage| usage.name == *name)
}

/// The ways in which a line is one of the problem; and all ways that are tried: these, each by itself and with the likeliest other
/// letters, and then the others.
fn all_ways(
    problem: &Problem,
    (lines, macros): (&[Written], &Macros),
    used: &[Usage],
    declared: &Letters,
) -> (Vec<Letters>, Vec<Letters>) {
    let known = &problem.names;
    let is_own = |name: &Name| used.iter().any(|usage| usage.name == *name && is_own(usage, used, known, declared));
    let is_free = |name: &Name| used.iter().all(|usage| usage.name != *name);
    let (mut by_form, mut all): (Vec<Letters>, Vec<Letters>) = Default::default();
    for table in matching::tables((problem, Likeness::Same), (lines, macros), is_own, is_free) {
        let table: Letters = declared.clone().into_iter().chain(table).collect();
        let others = ways(used, known, &table);
        by_form.push(table.clone());
        all.push(table);
        all.extend(others.into_iter().take(WAYS_BESIDE));
    }
    let others = ways(used, known, declared);
    let new: Vec<Letters> = others.into_iter().filter(|way| !all.contains(way)).collect();
    all.extend(new);
    all.truncate(WAYS);
    // p_1 is no momentum where p is a frequency.
    let is_new = |name: &&Name| known.symbols.find(name).is_none();
    let own: Vec<&Name> = used.iter().map(|usage| &usage.name).filter(is_new).collect();
    let is_open = |name: &Name| is_free(name) && known.names.iter().any(|(known, ..)| known == name);
    by_form.iter_mut().chain(&mut all).for_each(|table| add_subscripts(table, &own, is_open));
    (by_form, all)
}

/// Adds the letters with subscripts of a letter that stands for another one: p_1 for ω_1, where p stands for ω. `is_open` tells the
/// names of the problem for which a letter may stand.
fn add_subscripts(table: &mut Letters, own: &[&Name], is_open: impl Fn(&Name) -> bool) {
    for name in own.iter().copied().filter(|name| !name.subscript.is_empty()) {
        let plain = Name { subscript: Vec::new(), ..name.clone() };
        let Some(other) = table.get(&plain).filter(|other| other.dots == 0 && other.name.subscript.is_empty()) else {
            continue;
        };
        let other = Name { subscript: name.subscript.clone(), ..other.name.clone() };
        if is_open(&other) && !table.contains_key(name) {
            table.insert(name.clone(), StandsFor { name: other, dots: 0 });
        }
    }
}

/// Whether each letter stands for the same letter in another form, as M for m.
fn is_likely(way: &Letters, declared: &Letters) -> bool {
    let mut new = way.iter().filter(|(own, _)| !declared.contains_key(own));
    new.all(|(own, other)| other.dots == 0 && alike(own, &other.name))
}

/// The most ways that are tried beside a line that is one of the problem.
const WAYS_BESIDE: usize = 8;

/// Whether a name is one that only the hand-in has.
fn is_own(usage: &Usage, used: &[Usage], known: &Names, declared: &Letters) -> bool {
    let name = &usage.name;
    // `d` is a name where it is the whole left side.
    let is_free = name.base == "d" && usage.introduced.is_some();
    // `i` is the imaginary unit only where e has a power of it; a student may write it for a current.
    let is_current = name.base == "i" && (usage.introduced.is_some() || usage.moves);
    let reserved = !is_free
        && !is_current
        && ["t", "e", "d", "i", "\\pi", "\\mathrm{d}"].contains(&name.base.as_str())
        && name.subscript.is_empty();
    let is_momentum = name.base == "p" && !name.subscript.is_empty();
    (known.symbols.find(name).is_none() || is_current && known.names.iter().all(|(other, ..)| other != name))
        && !reserved
        && !is_momentum
        && !declared.contains_key(name)
        && (name.primes == 0 || !is_rate(name, used, known, declared))
        && !name.base.starts_with(['(', '['])
        && !energies::is_kinetic(name)
}

/// The ways to take the names that only the hand-in has for names that only the problem has, the most likely first.
fn ways(used: &[Usage], known: &Names, declared: &Letters) -> Vec<Letters> {
    let mut found: Vec<(u32, Letters)> = vec![(0, Letters::new())];
    for usage in used.iter().filter(|usage| is_own(usage, used, known, declared)) {
        let options = options(usage, used, known, declared);
        let own = if usage.introduced.is_some() { OWN_WITH_A_LINE } else { OWN };
        let mut next: Vec<(u32, Letters)> = Vec::new();
        for (cost, way) in &found {
            for (more, other) in &options {
                if !way.values().any(|taken| taken == other) {
                    let mut way = way.clone();
                    way.insert(usage.name.clone(), other.clone());
                    next.push((cost + more, way));
                }
            }
            // Each name may also be one of the student's own; i is the current that the problem has, if it has one.
            if usage.name.base != "i" || options.is_empty() {
                next.push((cost + own, way.clone()));
            }
        }
        next.sort_by_key(|(cost, _)| *cost);
        next.truncate(WAYS * 4);
        found = next;
    }
    found.retain(|(_, way)| !way.is_empty());
    found.truncate(WAYS);
    found.into_iter().map(|(_, way)| declared.clone().into_iter().chain(way).collect()).collect()
}

/// What it costs that a name is one of the student's own, in place of one of the problem.
const OWN: u32 = 4;

/// The same for a name that has a line of its own, which may say what it is.
const OWN_WITH_A_LINE: u32 = 1;

/// What a name may stand for, each with its cost: the lower, the likelier.
fn options(usage: &Usage, used: &[Usage], known: &Names, declared: &Letters) -> Vec<(u32, StandsFor)> {
    let has_rate = |other: &Usage| other.name.primes > 0 && Name { primes: 0, ..other.name.clone() } == usage.name;
    let moves = usage.moves || has_primed_accelerations(used) && used.iter().any(has_rate);
    let is_used = |name: &Name| is_used(used, name);
    let is_taken = |name: &Name| declared.values().any(|other| other.dots == 0 && other.name == *name);
    let fits = |name: &Name, role: Role| match (moves, usage.introduced.is_some()) {
        (true, false) => role == Role::Moving || role == Role::Determined && alike(name, &usage.name),
        (true, true) => role != Role::Constant,
        (false, _) => true,
    };
    let mut found = Vec::new();
    // No letter stands for a slope such as \partial L/\partial\theta.
    for (name, role, angle) in known.names.iter().filter(|(name, ..)| !name.base.starts_with("\\frac")) {
        if *role == Role::Moving && may_stand_for(&usage.name, name) {
            let dots = rate(&usage.name, name, *angle);
            found.extend(dots.map(|dots| (1, StandsFor { name: name.clone(), dots })));
        }
        // A letter that stands for another quantity leaves its own meaning to others.
        if is_used(name) && !declared.contains_key(name) || is_taken(name) || !fits(name, *role) {
            continue;
        }
        // A letter with the subscript 0 is a value of something, which does not change.
        if usage.name.subscript == ["0"] && !known.fixed.contains(name) {
            continue;
        }
        if !may_stand_for(&usage.name, name) || is_any_mode(known, &usage.name, name) {
            continue;
        }
        let cost = match () {
            () if alike(name, &usage.name) => 0,
            // A name without a line of its own is more likely a constant than a result that the hand-in uses early.
            () if usage.introduced.is_none() && *role == Role::Determined => 3,
            () if usage.angle != *angle => 3,
            () => 2,
        };
        found.push((cost, StandsFor { name: name.clone(), dots: 0 }));
    }
    found
}

/// Whether two names have the same letter but for its case, its form or its subscript.
fn alike(a: &Name, b: &Name) -> bool {
    let letter = |name: &Name| name.base.replace("\\ell", "l").replace("\\var", "\\").to_lowercase();
    letter(a) == letter(b)
}

/// The order of the rate of `of` that a letter usually stands for: of an angle, of a charge, or of a length.
fn rate(name: &Name, of: &Name, angle: bool) -> Option<u8> {
    let is_charge = ["q", "Q"].contains(&of.base.as_str());
    match (name.base.as_str(), angle) {
        // u and w are voltages and works where charges flow.
        ("u" | "w" | "V" | "a" | "A", false) if is_charge => None,
        ("v" | "u" | "w" | "V", false) | ("\\omega" | "\\Omega" | "w", true) => Some(1),
        ("a" | "A", false) | ("\\alpha" | "\\beta" | "\\varepsilon" | "\\epsilon", true) => Some(2),
        _ => None,
    }
}
