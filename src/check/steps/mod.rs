//! Derivations: a wrong step that follows from a wrong step before it is no slip of its own.
//!
//! Each step is checked like any display. A step that is false, and comes after a false one, is compared with that
//! one ([`standing`]). If it follows, its verdict stays and is explained by the other. What cannot be decided
//! changes nothing.
//!
//! # Why a derivation is declared by a list
//!
//! `"from"` on each equation could name any premises, and would have to be kept right for each line, in an order
//! that the notes have anyway. A list of addresses is what people say: (1) to (5). A line may follow from any one
//! before it. Nothing else depends on the list: without it a document has the same verdicts.

use rayon::prelude::*;
use std::collections::BTreeMap;

use crate::code::Code;
use crate::latex::Reading;
use crate::notes::claims::Claim;
use crate::{Error, Result};

use crate::check::document::checker::Checker;
use crate::check::document::names::{is_plain, shown};
use crate::check::document::setup::Run;
use crate::check::steps::standing::{Against, Standing};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Finding, Inherited};
use crate::check::verdict::report::Equation;

pub(crate) mod premise;
pub(crate) mod standing;

/// A step is held against so many false ones before it, the nearest first.
const LOOKED_BACK: usize = 6;

/// What is found of a step.
struct Told {
    /// Of each place up to which it is wrong, the false step that it follows from, if it does.
    wrong: Vec<(usize, Option<usize>)>,
    /// A false step that it certainly does not follow from, where it follows from none.
    other: Option<usize>,
}

impl Checker<'_> {
    /// The derivations that the claims file declares: of each the displays, in their order.
    ///
    /// # Errors
    /// For one that has no steps to compare.
    pub(crate) fn derivations(&self) -> Result<Vec<Vec<usize>>> {
        let at = |span, message: String| Error::at(&self.claims.source, span, message);
        let mut all = Vec::new();
        for address in &self.claims.steps {
            let places = address.lookup(self.notes, &self.claims.source)?;
            if places.iter().any(|place| place.row.or(place.part).or(place.step).is_some()) {
                return Err(at(address.span, "a step of a derivation must be a whole display".to_owned())
                    .help("remove `row`, `part` and `step`; each link of a chain is checked anyway"));
            }
            let displays: Vec<usize> = places.into_iter().map(|place| place.display).collect();
            if displays.len() < 2 {
                let error = at(address.span, "a derivation needs at least two displays".to_owned());
                return Err(error.help("list its steps in order, as in \"6.71..6.73, 6.77\""));
            }
            let again = displays.iter().enumerate().find(|(n, display)| displays[..*n].contains(display));
            if let Some((_, display)) = again {
                let message = format!("({}) occurs twice in this derivation", shown(&self.notes.equations[*display]));
                return Err(at(address.span, message));
            }
            all.push(displays);
        }
        Ok(all)
    }

    /// The findings on some displays, those of steps with what they follow from; and the repairs of those that do not. A
    /// display that was not asked for is judged where another one may follow from it.
    ///
    /// # Errors
    /// As for a check of the displays.
    pub(crate) fn with_steps(
        &self,
        run: &Run<'_>,
        derivations: &[Vec<usize>],
        (work, equations): (&[usize], Vec<Equation>),
        judge: impl Fn(usize) -> Result<Equation> + Sync,
    ) -> Result<Vec<Equation>> {
        if derivations.is_empty() {
            return Ok(equations);
        }
        let mut found: BTreeMap<usize, Equation> = work.iter().copied().zip(equations).collect();
        let asked = |derivation: &&Vec<usize>| derivation.iter().any(|at| work.contains(at));
        let missing = derivations.iter().filter(asked).flatten().copied().filter(|at| !found.contains_key(at));
        let missing: Vec<usize> = missing.collect();
        found.extend(missing.into_iter().map(|at| Ok((at, judge(at)?))).collect::<Result<Vec<_>>>()?);
        let pairs = derivations.iter().filter(asked).flat_map(|d| (1..d.len()).map(move |n| (&d[..n], d[n])));
        let pairs: Vec<(&[usize], usize)> = pairs.collect();
        let told: Vec<Told> = pairs
            .par_iter()
            .with_max_len(1)
            .map(|(before, at)| self.told(&found, before, *at))
            .collect::<Result<_>>()?;
        let mut roots: BTreeMap<usize, usize> = BTreeMap::new();
        for ((_, at), told) in pairs.iter().zip(&told) {
            if let Some(from) = told.from() {
                let root = roots.get(&from).copied().unwrap_or(from);
                roots.entry(*at).or_insert(root);
            }
        }
        let name = |at: usize| shown(&self.notes.equations[at]);
        for ((_, at), told) in pairs.iter().zip(told) {
            let start = self.notes.equations[*at].body.start;
            let Some(equation) = found.get_mut(at).filter(|known| known.finding.follows_from.is_none()) else {
                continue;
            };
            let inherited = |from: usize| {
                let root = roots.get(&from).copied().unwrap_or(from);
                Inherited { from: name(from), root: name(root) }
            };
            if let Some(from) = told.from() {
                inherit(&mut equation.finding, inherited(from));
                let wrong = equation.parts.iter_mut().filter(|part| !part.ok);
                wrong.for_each(|part| inherit(&mut part.finding, inherited(from)));
                continue;
            }
            for part in equation.parts.iter_mut().filter(|part| !part.ok) {
                let mut here = told.wrong.iter().filter(|(end, _)| end + start == part.finding.span.end);
                if let (Some((_, Some(from))), None) = (here.next(), here.next()) {
                    inherit(&mut part.finding, inherited(*from));
                }
            }
            let own = equation.parts.iter_mut().find(|part| !part.ok && part.finding.follows_from.is_none());
            if let Some(other) = told.other {
                let not = match equation.finding.verdict.passes() {
                    true => format!("; it does not follow from ({}) as printed", name(other)),
                    false => format!("; it does not follow from ({}) either", name(other)),
                };
                match own {
                    Some(part) => part.finding.message.push_str(&not),
                    None => equation.finding.message.push_str(&not),
                }
            }
            if let Some(part) = equation.parts.iter().find(|part| !part.ok && part.finding.follows_from.is_none()) {
                equation.finding = part.finding.clone();
            }
        }
        let is_step = |at: &usize| derivations.iter().any(|derivation| derivation.contains(at));
        let mended = work.par_iter().with_max_len(1).map(|at| match found.get(at).cloned() {
            Some(equation) if is_step(at) && equation.finding.follows_from.is_none() => {
                self.with_repairs(run, *at, equation, true)
            }
            Some(equation) => Ok(equation),
            None => judge(*at),
        });
        mended.collect()
    }

    /// What is to be told of a step, from those before it.
    fn told(&self, found: &BTreeMap<usize, Equation>, before: &[usize], at: usize) -> Result<Told> {
        let mut told = Told { wrong: Vec::new(), other: None };
        let Some(equation) = found.get(&at) else { return Ok(told) };
        let verdict = |at: &usize| found.get(at).map(|equation| (equation.finding.verdict, equation.ok));
        let is_false = |at: &usize| verdict(at) == Some((Verdict::Refuted, false)) && self.is_bare(*at);
        let wrong = equation.finding.verdict == Verdict::Refuted
            && !equation.ok
            && equation.parts.iter().all(|part| part.ok || part.finding.verdict == Verdict::Refuted);
        let right = equation.ok && equation.finding.verdict.holds();
        if !(wrong || right) || !self.may_follow(at) {
            return Ok(told);
        }
        // Of what is true it is worth saying that the step before does not give it, and nothing else.
        let looked_back = if wrong { LOOKED_BACK } else { 1 };
        let passes = |at: &usize| verdict(at).is_some_and(|(verdict, ok)| ok && verdict.passes());
        let sound: Vec<usize> = before.iter().copied().filter(passes).collect();
        let mut open: Option<Vec<(Reading, Option<usize>)>> = None;
        for from in before.iter().rev().filter(|at| is_false(at)).take(looked_back) {
            let known = match &mut open {
                Some(known) => known,
                none => none.insert(self.wrong_pieces(at, wrong)?.into_iter().map(|piece| (piece, None)).collect()),
            };
            let pieces: Vec<&Reading> = known.iter().map(|(piece, _)| piece).collect();
            let against = Against { from: *from, before, sound: &sound };
            let standings = self.standings(&against, (at, &pieces), wrong)?;
            if standings.iter().all(|standing| *standing == Standing::Follows) {
                // One line before it is enough.
                known.iter_mut().for_each(|(_, known)| *known = Some(*from));
                break;
            }
            for ((_, known), standing) in known.iter_mut().zip(standings) {
                match standing {
                    Standing::Follows => *known = known.or(Some(*from)),
                    Standing::Differs if known.is_none() => told.other = told.other.or(Some(*from)),
                    _ => {}
                }
            }
        }
        if wrong {
            let end = |piece: &Reading| piece.statements.iter().flatten().next().map(|s| s.span.end);
            told.wrong = open.into_iter().flatten().filter_map(|(piece, from)| Some((end(&piece)?, from))).collect();
        }
        Ok(told)
    }

    /// The same of one that is held against others; it may be an approximation.
    fn may_follow(&self, at: usize) -> bool {
        let Some(claim) = self.assigned[at] else { return true };
        let exact = Claim { small: Vec::new(), ..claim.clone() };
        is_plain(&exact) && claim.errata.is_empty() && claim.expect.is_none() && claim.meanings.is_empty()
    }
}

impl Told {
    /// The one false step that all of it follows from.
    fn from(&self) -> Option<usize> {
        let (_, first) = self.wrong.first()?;
        first.filter(|_| self.wrong.iter().all(|(_, from)| from == first))
    }
}

/// Explains what is false by a step that it follows from.
fn inherit(finding: &mut Finding, inherited: Inherited) {
    let Inherited { from, root } = &inherited;
    let message = match from == root {
        true => format!("this step is correct, but it builds on the mistake in ({root}); fix ({root})"),
        false => {
            format!("this step is correct, but it builds on ({from}), and so on the mistake in ({root}); fix ({root})")
        }
    };
    let Finding { verdict, span, points, tried, .. } = *finding;
    let follows_from = Some(inherited);
    *finding =
        Finding { points, tried, follows_from, ..Finding::new(Code::FollowsFromMistake, verdict, span, message) };
}
