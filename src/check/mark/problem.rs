//! The problem: the claims and the notes of the teacher, prepared once for all hand-ins.

use crate::formula::symbols::Name;
use crate::latex::names;
use crate::notes::address::{Address, Item, Point};
use crate::notes::claims::{Claim, Claims, Declaration, Role, Rubric, Share, Spanned};
use crate::notes::{Display, Notes, Numbered};
use crate::source::Span;
use crate::{Error, Result};

use crate::check::document::setup::{Run, assign, with_checker, without_open_energies};
use crate::check::prose_claims;
use crate::check::run::check_in;
use crate::check::sample::context::Options;
use crate::check::verdict::Verdict;

use super::names::Names;
use super::special::Special;

/// A wanted result.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    /// The display of the problem, by its place.
    pub display: usize,
    /// Its number.
    pub id: String,
    /// What it is called.
    pub name: Option<String>,
    /// What it is worth.
    pub points: f64,
}

/// A problem that hand-ins are marked by.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The claims, with an address by number for each claim, and nothing that is not about equations.
    pub(super) claims: Claims,
    /// The notes, in which every display has a number.
    pub(super) notes: Notes,
    /// The rubric.
    pub(super) rubric: Rubric,
    /// Whether the rubric names the wanted results.
    pub(super) names_results: bool,
    /// The wanted results in order.
    pub(super) wanted: Vec<Wanted>,
    /// The hypotheses under which the equations of the problem hold, each set once.
    pub(super) contexts: Vec<Claim>,
    /// The verdict on each display.
    pub(super) verdicts: Vec<Verdict>,
    /// The displays that print secular equations, each with its frequency.
    pub(super) secular: Vec<(usize, Name)>,
    /// The displays that print laws.
    pub(super) laws: Vec<usize>,
    /// Its names.
    pub(super) names: Names,
    /// Its special states.
    pub(super) special: Special,
}

impl Problem {
    /// Prepares a problem.
    ///
    /// # Errors
    /// For claims that do not fit the notes, a result that the notes do not have, and a problem that is itself wrong.
    pub fn prepare(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Problem> {
        let rubric = claims.rubric.clone().unwrap_or_default();
        let mut wanted = Vec::new();
        for result in &rubric.results {
            for display in result.address.resolve(notes, &claims.source)? {
                let id = notes.equations[display].id().map_or_else(|| result.address.text.clone(), str::to_owned);
                wanted.push(Wanted { display, id, name: result.name.clone(), points: result.points });
            }
        }
        let notes = &numbered(&without_open_energies(claims, notes));
        let mut claims = by_number(claims, notes)?;
        (claims.sentences, claims.steps) = (Vec::new(), Vec::new());
        claims = prose_claims::with_passing(run, &claims, notes);
        let (mut verdicts, mut open) = self::verdicts(run, &claims, notes)?;
        if let Some(with) = with_accelerations(&claims, notes)
            && let Ok((new, still)) = self::verdicts(run, &with, notes)
            && verdicts.iter().zip(&new).all(|(old, new)| new == old || new.holds())
        {
            (claims, verdicts, open) = (with, new, still);
        }
        let is_named = !wanted.is_empty();
        if wanted.is_empty() {
            wanted = unnamed(notes, &verdicts);
        }
        let failed = wanted.iter().find(|wanted| {
            matches!(verdicts[wanted.display], Verdict::Refuted | Verdict::Domain | Verdict::Unreadable)
        });
        if let Some(failed) = failed {
            let message = format!(
                "({}) is one of the wanted results, but in the model solution it is {}",
                failed.id, verdicts[failed.display]
            );
            return Err(Error::at(&notes.source, notes.equations[failed.display].body, message)
                .help("check the problem first with `onshell check`, and correct it"));
        }
        // No line of a hand-in can be held against a result that was not decided.
        if let Some((result, why)) =
            wanted.iter().filter(|_| is_named).find_map(|wanted| open[wanted.display].as_ref().map(|why| (wanted, why)))
        {
            let message = format!(
                "({}) is one of the wanted results, but in the model solution it is undecided: {why}",
                result.id
            );
            return Err(Error::at(&notes.source, notes.equations[result.display].body, message)
                .help("check the problem first with `onshell check`, and say what is missing in its claims file"));
        }
        if wanted.is_empty() {
            return Err(Error::new(format!(
                "{} has no equation, so there is no result to look for",
                notes.source.path
            ))
            .help("write the wanted results as displays, and name them under \"rubric\""));
        }
        let mut contexts: Vec<Claim> = Vec::new();
        // The place of an equilibrium is no identity: a line says the same if it follows from what the problem says of it.
        for (address, _) in claims.equations.iter().filter(|(_, claim)| claim.equilibrium.is_some()) {
            for display in address.resolve(notes, &claims.source)? {
                if let Some(id) = notes.equations[display].id().filter(|_| verdicts[display].holds()) {
                    let throughout = vec![Spanned::new(id.to_owned(), Span::default())];
                    contexts.push(Claim { throughout, ..Claim::default() });
                }
            }
        }
        for (_, claim) in &claims.equations {
            for context in std::iter::once(context(claim)).chain(in_one_sense(&claims, claim)) {
                if context != Claim::default() && !contexts.contains(&context) {
                    contexts.push(context);
                }
            }
        }
        let (names, special) = with_checker(run, &claims, notes, |checker| {
            Ok((Names::of(checker.model), Special::of(&checker, &claims)))
        })?;
        let laws = (0..verdicts.len()).filter(|at| verdicts[*at] == Verdict::Law).collect();
        let mut secular = Vec::new();
        for (address, claim) in &claims.equations {
            if let Some((omega, _)) = claim.secular_for.as_ref().and_then(|omega| names::parse(&omega.value)) {
                secular.extend(address.resolve(notes, &claims.source)?.into_iter().map(|at| (at, omega.clone())));
            }
        }
        let names_results = !rubric.results.is_empty();
        Ok(Problem {
            claims,
            notes: notes.clone(),
            rubric,
            names_results,
            wanted,
            contexts,
            verdicts,
            secular,
            laws,
            names,
            special,
        })
    }

    /// The share of the points for results without steps.
    pub(super) fn without_steps(&self) -> f64 {
        self.rubric.without_steps.unwrap_or(Share::Half).value()
    }
}

/// What a claim says that a line may say too, in its own form: under which hypotheses it holds, and of which kind it is. Where a
/// claim is about the display alone (a solution, a function that generates the motion), a line with other constants would pass.
fn context(claim: &Claim) -> Claim {
    Claim {
        assume: claim.assume.clone(),
        throughout: claim.throughout.clone(),
        small: claim.small.clone(),
        order: claim.order.clone(),
        limit: claim.limit.clone(),
        meanings: claim.meanings.clone(),
        for_each: claim.for_each.clone(),
        dropping: claim.dropping.clone(),
        exactly_when: claim.exactly_when.clone(),
        secular_for: claim.secular_for.clone(),
        ..Claim::default()
    }
}

/// A claim on what holds while a coordinate keeps its value, for each sense in which another one turns: on a circle the angular
/// momentum is `\sqrt{m M g r_0^3}` if the angle grows.
fn in_one_sense(claims: &Claims, claim: &Claim) -> Vec<Claim> {
    let is_kept = |name: &str| {
        claim.throughout.iter().any(|text| text.value.split('=').next().is_some_and(|first| first.trim() == name))
    };
    let turns = |declared: &&Declaration| declared.role == Role::Coordinate && !is_kept(&declared.name.value);
    let others = claims.declarations.iter().filter(|_| !claim.throughout.is_empty()).filter(turns);
    let grows = |declared: &Declaration| {
        let mut context = context(claim);
        let name = &declared.name;
        context.assume.push(Spanned::new(format!("\\dot{{{}}} > 0", name.value), name.span));
        context
    };
    others.map(grows).collect()
}

/// The notes, in which each display without a number has the name `display` and its place.
fn numbered(notes: &Notes) -> Notes {
    let mut notes = notes.clone();
    for (at, display) in notes.equations.iter_mut().enumerate() {
        if display.id().is_none() {
            display.number = Some(Numbered { id: format!("display {}", at + 1), span: display.body });
        }
    }
    notes
}

/// The claims, in which each equation has one address: its number. A snippet could stand in a hand-in too.
fn by_number(claims: &Claims, notes: &Notes) -> Result<Claims> {
    let assigned = assign(claims, notes)?;
    let mut equations = Vec::new();
    for (display, claim) in notes.equations.iter().zip(assigned) {
        let Some(claim) = claim else { continue };
        let span = claims.equations.first().map_or(claims.notes.span, |(address, _)| address.span);
        equations.push((Address::of_number(display.id().unwrap_or_default(), span), claim.clone()));
    }
    // A claim about a part of a display stays one.
    for (address, claim) in &claims.equations {
        let Some(point) = address.single().filter(|point| point.row.or(point.part).or(point.step).is_some()) else {
            continue;
        };
        for at in address.resolve(notes, &claims.source)? {
            let whole = Address::of_number(notes.equations[at].id().unwrap_or_default(), address.span);
            let target = whole.single().map_or_else(|| point.target.clone(), |of| of.target.clone());
            let items = vec![Item::One(Point { target, ..point.clone() })];
            equations.push((Address { items, ..whole }, claim.clone()));
        }
    }
    Ok(Claims { equations, ..claims.clone() })
}

/// The verdicts on the displays of the problem, and why those are undecided that are no untested definitions.
fn verdicts(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<(Vec<Verdict>, Vec<Option<String>>)> {
    let brief = Run { options: Options { explain: false, ..run.options }, only: None, ..*run };
    let document = check_in(&brief, claims, notes)?;
    let of = |display: &Display| {
        let found = document.equations.iter().find(|equation| Some(equation.id.as_str()) == display.id());
        found.map_or(Verdict::Unclaimed, |equation| {
            if equation.ok && !equation.finding.verdict.passes() {
                Verdict::Unclaimed
            } else {
                equation.finding.verdict
            }
        })
    };
    let open = |display: &Display| {
        let found = document.equations.iter().find(|equation| Some(equation.id.as_str()) == display.id())?;
        let finding = Some(&found.finding).filter(|finding| finding.verdict == Verdict::Undecided && !found.ok)?;
        (!finding.leaves_a_definition_open()).then(|| finding.message.clone())
    };
    Ok((notes.equations.iter().map(of).collect(), notes.equations.iter().map(open).collect()))
}

/// The claims with the accelerations that have a name in the text, `$a = \ddot x$`, as laws, where nothing else there says
/// how the coordinates move.
fn with_accelerations(claims: &Claims, notes: &Notes) -> Option<Claims> {
    let moves = |role: Role| matches!(role, Role::Coordinate | Role::VariesWithTime);
    let moving = claims.declarations.iter().filter(|declared| moves(declared.role));
    let rates: Vec<(&Spanned<String>, String)> = moving
        .map(|declared| &declared.name)
        .flat_map(|name| {
            let name_only = name.value.as_str();
            ["\\ddot{#}", "\\ddot #"].map(|rate| (name, rate.replace('#', name_only)))
        })
        .collect();
    if claims.system.is_some() || !claims.laws.is_empty() || !claims.means.is_empty() {
        return None;
    }
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    let named = notes.inline.iter().find_map(|span| {
        let text = notes.source.text.get(span.range())?.trim_matches('$');
        let (first, second) = text.split_once('=')?;
        let is_rate =
            |text: &str| rates.iter().find(|(_, rate)| squeezed(rate) == squeezed(text)).map(|(name, _)| *name);
        let (of, other) = is_rate(first).map(|of| (of, second)).or_else(|| Some((is_rate(second)?, first)))?;
        names::parse(other.trim())?;
        Some((of, format!("\\ddot{{{}}} = {}", of.value, other.trim())))
    });
    let (of, law) = named?;
    let mut claims = claims.clone();
    claims.laws.push((Spanned::new("the acceleration".to_owned(), of.span), Spanned::new(law, of.span)));
    Some(claims)
}

/// The wanted results of a problem without a list of them: what follows, and the last display.
fn unnamed(notes: &Notes, verdicts: &[Verdict]) -> Vec<Wanted> {
    let is_stated = |at: usize| {
        let display = &notes.equations[at];
        display.number.as_ref().is_some_and(|number| !number.id.starts_with("display ")) || !display.labels.is_empty()
    };
    let any_number = (0..verdicts.len()).any(is_stated);
    let may_be = |at: &usize| !any_number || is_stated(*at);
    let unusable = |at: &usize| matches!(verdicts[*at], Verdict::Law | Verdict::Unreadable | Verdict::Refuted);
    let candidates: Vec<usize> = (0..verdicts.len()).filter(may_be).filter(|at| !unusable(at)).collect();
    let last = candidates.last().copied();
    let is_wanted = |at: &usize| verdicts[*at].holds() || Some(*at) == last;
    let wanted = |display: usize| {
        let id = notes.equations[display].id().unwrap_or_default().to_owned();
        Wanted { display, id, name: None, points: 1.0 }
    };
    candidates.into_iter().filter(is_wanted).map(wanted).collect()
}

/// The names that a rubric declares for those of the problem.
pub(super) fn declared_letters(rubric: &Rubric) -> impl Iterator<Item = (&Spanned<String>, &Spanned<String>)> {
    rubric.letters.iter().flat_map(|(own, others)| others.iter().map(move |other| (own, other)))
}
