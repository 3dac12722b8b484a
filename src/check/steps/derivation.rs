//! False steps of a derivation that follow from a false step before them.
//!
//! Each step is checked like any display. A false step is then compared with the false steps before it
//! ([`super::entailment`]). If it follows from one of them, its verdict stays and its message names that step. What cannot
//! be decided changes nothing, and no step passes because of a step before it.

use rayon::prelude::*;
use std::collections::BTreeMap;

use crate::code::Code;
use crate::latex::Reading;
use crate::notes::claims::Claim;
use crate::{Error, Result};

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::setup::Run;
use crate::check::steps::entailment::{EarlierSteps, Entailment};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Finding, Inherited};
use crate::check::verdict::report::Equation;

/// The number of false steps before it that a step is compared with, the nearest first.
const LOOKED_BACK: usize = 6;

/// The false steps that a step follows from, or does not follow from.
struct Origins {
    /// The false pieces of the step: where each ends, and the false step that it follows from, if any.
    wrong: Vec<(usize, Option<usize>)>,
    /// A false step that it does not follow from, where it follows from none.
    other: Option<usize>,
}

impl Checker<'_> {
    /// The derivations that the claims file declares, each as its displays in order.
    ///
    /// # Errors
    /// For a derivation with fewer than two displays, with a part of a display, or with a display twice.
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

    /// The equations, with findings of steps explained by the false step that they follow from, and with repairs of steps that
    /// follow from none. A display that was not requested is checked where another one may follow from it.
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
        let origins: Vec<Origins> = pairs
            .par_iter()
            .with_max_len(1)
            .map(|(before, at)| self.origins(&found, before, *at))
            .collect::<Result<_>>()?;
        let mut roots: BTreeMap<usize, usize> = BTreeMap::new();
        for ((_, at), origins) in pairs.iter().zip(&origins) {
            if let Some(from) = origins.from() {
                let root = roots.get(&from).copied().unwrap_or(from);
                roots.entry(*at).or_insert(root);
            }
        }
        let name = |at: usize| shown(&self.notes.equations[at]);
        for ((_, at), origins) in pairs.iter().zip(origins) {
            let start = self.notes.equations[*at].body.start;
            let Some(equation) = found.get_mut(at).filter(|known| known.finding.follows_from.is_none()) else {
                continue;
            };
            let inherited = |from: usize| {
                let root = roots.get(&from).copied().unwrap_or(from);
                Inherited { from: name(from), root: name(root) }
            };
            if let Some(from) = origins.from() {
                inherit(&mut equation.finding, inherited(from));
                let wrong = equation.parts.iter_mut().filter(|part| !part.ok);
                wrong.for_each(|part| inherit(&mut part.finding, inherited(from)));
                continue;
            }
            for part in equation.parts.iter_mut().filter(|part| !part.ok) {
                let mut here = origins.wrong.iter().filter(|(end, _)| end + start == part.finding.span.end);
                if let (Some((_, Some(from))), None) = (here.next(), here.next()) {
                    inherit(&mut part.finding, inherited(*from));
                }
            }
            let own = equation.parts.iter_mut().find(|part| !part.ok && part.finding.follows_from.is_none());
            if let Some(other) = origins.other {
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
        let repaired = work.par_iter().with_max_len(1).map(|at| match found.get(at).cloned() {
            Some(equation) if is_step(at) && equation.finding.follows_from.is_none() => {
                self.with_repairs(run, *at, equation, true)
            }
            Some(equation) => Ok(equation),
            None => judge(*at),
        });
        repaired.collect()
    }

    /// The false steps before a step that it follows from.
    fn origins(&self, found: &BTreeMap<usize, Equation>, before: &[usize], at: usize) -> Result<Origins> {
        let mut origins = Origins { wrong: Vec::new(), other: None };
        let Some(equation) = found.get(&at) else { return Ok(origins) };
        let verdict = |at: &usize| found.get(at).map(|equation| (equation.finding.verdict, equation.ok));
        let is_false =
            |at: &usize| verdict(at) == Some((Verdict::Refuted, false)) && self.claims_only_what_it_prints(*at);
        let wrong = equation.finding.verdict == Verdict::Refuted
            && !equation.ok
            && equation.parts.iter().all(|part| part.ok || part.finding.verdict == Verdict::Refuted);
        let right = equation.ok && equation.finding.verdict.holds();
        if !(wrong || right) || !self.may_follow(at) {
            return Ok(origins);
        }
        // A true step is compared only with the false step right before it.
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
            let earlier = EarlierSteps { from: *from, before, sound: &sound };
            let entailments = self.entailments(&earlier, (at, &pieces), wrong)?;
            if entailments.iter().all(|entailment| *entailment == Entailment::Follows) {
                // The nearest false step explains all of it.
                known.iter_mut().for_each(|(_, known)| *known = Some(*from));
                break;
            }
            for ((_, known), entailment) in known.iter_mut().zip(entailments) {
                match entailment {
                    Entailment::Follows => *known = known.or(Some(*from)),
                    Entailment::Differs if known.is_none() => origins.other = origins.other.or(Some(*from)),
                    _ => {}
                }
            }
        }
        if wrong {
            let end = |piece: &Reading| piece.statements.iter().flatten().next().map(|s| s.span.end);
            origins.wrong = open.into_iter().flatten().filter_map(|(piece, from)| Some((end(&piece)?, from))).collect();
        }
        Ok(origins)
    }

    /// Whether a step can follow from others: it claims what it prints, or an approximation, under hypotheses.
    fn may_follow(&self, at: usize) -> bool {
        let Some(claim) = self.assigned[at] else { return true };
        let exact = Claim { small: Vec::new(), ..claim.clone() };
        exact.is_plain() && claim.errata.is_empty() && claim.expect.is_none() && claim.meanings.is_empty()
    }
}

impl Origins {
    /// The false step that all pieces follow from, if there is one.
    fn from(&self) -> Option<usize> {
        let (_, first) = self.wrong.first()?;
        first.filter(|_| self.wrong.iter().all(|(_, from)| from == first))
    }
}

/// Replaces the message of a false finding by the step that it follows from.
fn inherit(finding: &mut Finding, inherited: Inherited) {
    let Inherited { from, root } = &inherited;
    let message = match from == root {
        true => format!("this step is correct, but it builds on the mistake in ({root}); fix ({root})"),
        false => {
            format!(
                "this step is correct, but it builds on ({from}), which builds on the mistake in ({root}); fix ({root})"
            )
        }
    };
    let Finding { verdict, span, points, tried, .. } = *finding;
    let follows_from = Some(inherited);
    *finding =
        Finding { points, tried, follows_from, ..Finding::new(Code::FollowsFromMistake, verdict, span, message) };
}
