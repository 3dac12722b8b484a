//! Claims that the words around a display make, where the claims file makes none: "the arms can stay at an angle $\theta_0$,
//! where", "the frequency of small oscillations is", "is a constant of the motion".
//!
//! Each is added as if the author had written it into the claims file. It is kept where its displays pass with it, or where an
//! edit makes them pass. Else the words mean something else, and the displays are judged without it. So no words make a right
//! display wrong, unless a likely slip lies between it and what they say.
//!
//! | file | what it has |
//! | --- | --- |
//! | `words` | the sentence around a display |
//! | `notes_names` | which names the displays have, and which of them are declared |
//! | `places` | values of coordinates at rest or on a steady motion |
//! | `frequencies` | frequencies and periods of small oscillations, secular equations |
//! | `quantities` | effective potentials, and what is said to be conserved |
//! | `constants` | names that only the prose introduces |
//! | `formulas` | names that formulas in sentences define, or tie to others |
//! | `initial_values` | where a motion begins that is released from rest |
//! | `conditions` | special cases, for displays that fail without them |
//! | `rigid` | coordinates that a rigid connection keeps equal |
//! | `special_cases` | which of these hold |
//! | `sought` | equations for something that is sought, which nothing refutes |
//!
//! Knows the whole check of a document, [`check_in`], and no notes without claims.
//!
//! Offers `checked`, the check of a document with these claims, and `with_guesses`, guessed claims with them.

mod conditions;
mod constants;
mod formulas;
mod frequencies;
mod initial_values;
mod notes_names;
mod places;
mod quantities;
mod rigid;
mod sought;
mod special_cases;
pub(crate) mod words;

use std::cell::OnceCell;

use crate::Result;
use crate::code::Code;
use crate::latex::name_search;
use crate::notes::Notes;
use crate::notes::address::Address;
use crate::notes::claims::{Claim, Claims, Declaration, Range, Role, Spanned};
use crate::source::Span;

use crate::check::document::setup::{Run, with_checker};
use crate::check::prose_claims::notes_names::NotesNames;
use crate::check::run::check_in;
use crate::check::sample::context::Options;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::{Document, Equation};

/// When words make a display wrong that fails with what they say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Refutes {
    /// Where an edit makes it pass.
    #[default]
    WithAnEdit,
    /// The same, for a frequency, where the place is stable. Else the words mean another place.
    WhereStable,
    /// Where the system is natural, L = T − V, so that what the words call the energy is conserved. The energy of a driven system is not.
    WhereNatural,
    /// Never: the name has another meaning as often. Authors leave constants out of an effective potential.
    Never,
}

/// What words make of some displays.
#[derive(Clone, Debug, Default)]
pub(crate) struct ProseClaim {
    /// When a display of it is wrong.
    refutes: Refutes,
    /// Constants, with their ranges.
    constants: Vec<(String, Range)>,
    /// Names that vary with the time, with their ranges.
    varying: Vec<(String, Range)>,
    /// Definitions, as under `define`.
    definitions: Vec<(String, String)>,
    /// What names mean, as under `means`.
    means: Vec<(String, String)>,
    /// Claims about displays, by their places.
    claims: Vec<(usize, Claim)>,
    /// The displays that must pass, by their places.
    displays: Vec<usize>,
    /// Whether one display that passes is enough, where none fails.
    is_enough: bool,
    /// Whether a sentence states it outright. A display may then be wrong with it, or about a special case, if others pass.
    is_said: bool,
    /// Whether it gives new coordinates by the old ones, so that one display that is refuted is compared with its edits.
    gives_coordinates: bool,
    /// Whether a display of it is refuted, so that edits decide.
    is_doubtful: bool,
    /// Whether no sampled state has the start of the motion that it is about.
    is_untested: bool,
    /// What is said in the report.
    why: String,
}

/// Checks a document by its claims and by those that its prose makes.
///
/// # Errors
/// As [`check_in`].
pub fn checked(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Document> {
    // Other displays decide what words mean too.
    let quiet = Run { only: None, progress: &(), ..*run };
    let all = weighed(&quiet, (claims, notes), infer(claims, notes));
    let is_conserved = |one: &ProseClaim| one.claims.iter().any(|(_, claim)| claim.conserved.is_some());
    let conserved: Vec<ProseClaim> = all.iter().filter(|one| is_conserved(one)).cloned().collect();
    let (mut said, brief) = standing(&quiet, (claims, notes), all, ProseClaim::may_stand);
    let dropped = conserved.into_iter().filter(|one| !said.iter().any(|kept| kept.displays == one.displays));
    let dropped: Vec<ProseClaim> = dropped.collect();
    let with = added(claims, notes, &said);
    let checked = if brief.is_some() { None } else { Some(check_in(run, &with, notes)?) };
    let (formulas, read) = match brief.as_ref().or(checked.as_ref()) {
        Some(found) => tied_names(&quiet, (&with, notes), found),
        None => (Vec::new(), None),
    };
    let with = added(&with, notes, &formulas);
    let checked = checked.filter(|_| formulas.is_empty());
    let special = match read.as_ref().or(brief.as_ref()).or(checked.as_ref()) {
        Some(found) => special_cases::special_cases(&quiet, (&with, notes), found, &dropped),
        None => Vec::new(),
    };
    said.extend(formulas);
    let mut found = match checked.filter(|_| special.is_empty()) {
        Some(found) => found,
        None => check_in(run, &added(&with, notes, &special), notes)?,
    };
    said.extend(special);
    rigid::judge(&quiet, (&with, notes), &mut found);
    if has_lagrangian(claims) {
        let is_claimed = |at: usize| said.iter().any(|claim| claim.displays.contains(&at));
        sought::leave_open(&NotesNames::of(claims, notes), is_claimed, &mut found);
    }
    found.inferred.extend(said.iter().map(|claim| claim.why.clone()).filter(|why| !why.is_empty()));
    Ok(found)
}

/// Claims with those that the prose makes, as far as all displays that they are about pass with them: what other texts are judged
/// by, which no slip in these notes may make wrong.
#[cfg(feature = "cli")]
pub(crate) fn with_passing(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Claims {
    if !has_lagrangian(claims) {
        return claims.clone();
    }
    let brief = Run { only: None, progress: &(), options: Options { explain: false, ..run.options }, ..*run };
    let (said, found) = kept(&brief, (claims, notes), infer(claims, notes), |claim, found, notes| {
        claim.findings(found, notes).into_iter().all(passes)
    });
    let with = added(claims, notes, &said);
    let Some(found) = found.or_else(|| check_in(&brief, &with, notes).ok()) else { return with };
    let (special, _) = special_cases::cases(&brief, (&with, notes), &found, &[]);
    added(&with, notes, &special)
}

/// The claims that stand together, and the document with them, without explanations; none where there is no claim. Their displays
/// pass, or edits make them pass, which are sought last, since they cost most.
fn standing(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    mut said: Vec<ProseClaim>,
    may_stand: fn(&mut ProseClaim, &Document, &Notes) -> bool,
) -> (Vec<ProseClaim>, Option<Document>) {
    let brief = Run { options: Options { explain: false, ..run.options }, ..*run };
    let mut is_first = true;
    loop {
        let (mut kept, mut document) = kept(&brief, (claims, notes), said, may_stand);
        // Words about a case come before edits, which cost more.
        if special_cases::complete(&brief, (claims, notes), document.as_ref(), &mut kept) {
            document = None;
        }
        let with = added(claims, notes, &kept);
        let stands_in = |with: &Claims, claim: &ProseClaim| {
            let mut displays = claim.displays.iter().filter_map(|at| notes.equations[*at].id());
            displays.all(|id| {
                check_in(&Run { only: Some(id), ..*run }, with, notes).is_ok_and(|it| claim.stands(&it, notes))
            })
        };
        // Edits of other displays are known where all are checked.
        let all = OnceCell::new();
        let stands_with_all = |claim: &ProseClaim| {
            let all: &Option<Document> = all.get_or_init(|| check_in(run, &with, notes).ok());
            all.as_ref().is_some_and(|all| claim.stands(all, notes))
        };
        let falls = |claim: &ProseClaim| claim.is_doubtful && !stands_in(&with, claim) && !stands_with_all(claim);
        // An edit may make the displays pass in a case that the words state.
        let in_a_case = |claim: &ProseClaim| {
            let found = document.as_ref().filter(|_| is_first)?;
            let mut cases = special_cases::in_cases((claims, notes), found, claim).into_iter();
            cases.find(|case| stands_in(&added(claims, notes, std::slice::from_ref(case)), case))
        };
        let before = kept.len();
        let standing = |claim: &ProseClaim| {
            if falls(claim) { in_a_case(claim).map(|case| (case, true)) } else { Some((claim.clone(), false)) }
        };
        let found: Vec<(ProseClaim, bool)> = kept.iter().filter_map(standing).collect();
        let is_settled = found.len() == before && !found.iter().any(|(_, is_new)| *is_new);
        said = found.into_iter().map(|(claim, _)| claim).collect();
        is_first = false;
        if is_settled {
            if said.is_empty() {
                // Without a claim the document is checked once, with explanations.
                return (said, None);
            }
            let document = document.or_else(|| check_in(&brief, &with, notes).ok());
            return (said, document);
        }
    }
}

/// What formulas in sentences say of names without which displays cannot be read, and the document with them.
fn tied_names(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    found: &Document,
) -> (Vec<ProseClaim>, Option<Document>) {
    let lacks_a_name = |equation: &Equation| equation.finding.code == Code::UndeclaredName;
    if !has_lagrangian(claims) || claims.guesses.is_some() || !found.equations.iter().any(lacks_a_name) {
        return (Vec::new(), None);
    }
    let mut said = formulas::infer(&NotesNames::of(claims, notes));
    said.retain(|claim| claim.findings(found, notes).into_iter().any(lacks_a_name));
    standing(run, (claims, notes), said, ProseClaim::may_tie)
}

/// The claims that stand together, and the document with them. Where the document cannot be checked with them, there are none.
fn kept(
    run: &Run<'_>,
    (claims, notes): (&Claims, &Notes),
    mut said: Vec<ProseClaim>,
    stands: fn(&mut ProseClaim, &Document, &Notes) -> bool,
) -> (Vec<ProseClaim>, Option<Document>) {
    let check = |said: &[ProseClaim]| check_in(run, &added(claims, notes, said), notes);
    while !said.is_empty() {
        let Ok(found) = check(&said) else {
            // One that cannot be read is no reason to drop the others.
            let before = said.len();
            said.retain(|claim| check(std::slice::from_ref(claim)).is_ok());
            if said.len() == before {
                return (Vec::new(), None);
            }
            continue;
        };
        let before = said.len();
        said.retain_mut(|claim| stands(claim, &found, notes));
        if said.len() == before {
            return (said, Some(found));
        }
    }
    (said, None)
}

/// Guessed claims with those that the prose makes, as far as their displays pass with them or are refuted.
pub(crate) fn with_guesses(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Claims {
    let mut said = weighed(run, (claims, notes), infer(claims, notes));
    while !said.is_empty() {
        let with = added(claims, notes, &said);
        let tested = with_checker(run, &with, notes, |checker| {
            let is_tested = |claim: &ProseClaim, at: usize| {
                let found = checker.equation(at, checker.assigned[at]);
                found.is_ok_and(|equation| {
                    // The ranges are guesses, so a counterexample says nothing of stability.
                    let is_refuted = equation.finding.verdict == Verdict::Refuted && claim.refutes != Refutes::Never;
                    let is_tested = !equation.finding.is_untested_definition();
                    is_tested && (equation.finding.verdict.passes() || is_refuted)
                })
            };
            let all = |claim: &ProseClaim| claim.displays.iter().all(|at| is_tested(claim, *at));
            Ok(said.iter().map(all).collect::<Vec<bool>>())
        });
        let Ok(tested) = tested else { break };
        if tested.iter().all(|tested| *tested) {
            return with;
        }
        let mut tested = tested.into_iter();
        said.retain(|_| tested.next() == Some(true));
    }
    claims.clone()
}

/// The claims that the prose makes. There are none without a Lagrangian in the notes, which says what follows.
pub(crate) fn infer(claims: &Claims, notes: &Notes) -> Vec<ProseClaim> {
    if !has_lagrangian(claims) {
        return Vec::new();
    }
    let names = NotesNames::of(claims, notes);
    let places = places::infer(&names);
    let mut said = frequencies::infer(&names, &places);
    said.extend(quantities::infer(&names));
    if claims.guesses.is_none() {
        said.extend(constants::infer(&names, &places));
    }
    said.extend(initial_values::infer(&names, &places));
    said.extend(places.into_iter().map(|place| place.claim));
    said
}

/// The claims, of which those about the energy make a display wrong where the system is natural.
fn weighed(run: &Run<'_>, (claims, notes): (&Claims, &Notes), mut said: Vec<ProseClaim>) -> Vec<ProseClaim> {
    let needs_it = |claim: &ProseClaim| claim.refutes == Refutes::WhereNatural;
    if said.iter().any(needs_it) {
        let is_natural = with_checker(run, claims, notes, |checker| {
            Ok(checker.model.system.as_ref().is_some_and(|system| system.is_natural()))
        });
        let refutes = if is_natural.unwrap_or(false) { Refutes::WithAnEdit } else { Refutes::Never };
        said.iter_mut().filter(|claim| needs_it(claim)).for_each(|claim| claim.refutes = refutes);
    }
    said
}

/// Whether the notes define the Lagrangian.
fn has_lagrangian(claims: &Claims) -> bool {
    claims.system.is_none() && claims.means.iter().any(|(_, what)| what.value == "Lagrangian")
}

/// Claims with those that the prose makes.
pub(crate) fn added(claims: &Claims, notes: &Notes, said: &[ProseClaim]) -> Claims {
    let mut with = claims.clone();
    for claim in said {
        let is_it =
            |one: &Declaration, name: &str| one.role == Role::Constant && name_search::same(&one.name.value, name);
        // What the words mean is no guess.
        with.declarations.retain(|one| !claim.means.iter().any(|(name, _)| is_it(one, name)));
        for (name, range) in &claim.constants {
            if with.declarations.iter().any(|one| is_it(one, name)) {
                continue;
            }
            let range = spanned(range.clone());
            with.declarations.push(Declaration {
                role: Role::Constant,
                name: spanned(name.clone()),
                range,
                is_formula: false,
            });
        }
        for (name, range) in &claim.varying {
            with.declarations.retain(|one| !is_it(one, name));
            let (name, range) = (spanned(name.clone()), spanned(range.clone()));
            with.declarations.push(Declaration { role: Role::VariesWithTime, name, range, is_formula: false });
        }
        let defined = claim.definitions.iter().map(|(name, formula)| (spanned(name.clone()), spanned(formula.clone())));
        with.define.extend(defined);
        with.means.extend(claim.means.iter().map(|(name, what)| (spanned(name.clone()), spanned(what.clone()))));
        for (at, new) in &claim.claims {
            let Some(id) = notes.equations[*at].id() else { continue };
            match with.equations.iter_mut().find(|(address, _)| address.text == id) {
                Some((_, known)) => join(known, new),
                None => with.equations.push((Address::of_number(id, Span::default()), new.clone())),
            }
        }
    }
    with
}

/// Adds what a claim says to another one.
fn join(known: &mut Claim, new: &Claim) {
    let fresh = new.implied.iter().filter(|one| !known.implied.iter().any(|other| other.value == one.value));
    let fresh: Vec<Spanned<String>> = fresh.cloned().collect();
    known.implied.extend(fresh);
    known.implied_throughout.extend(new.implied_throughout.iter().cloned());
    conditions::join(known, new);
    known.conserved = known.conserved.take().or_else(|| new.conserved.clone());
    known.equilibrium = known.equilibrium.take().or_else(|| new.equilibrium.clone());
    known.secular_for = known.secular_for.take().or_else(|| new.secular_for.clone());
    if known.at.is_empty() {
        known.at.clone_from(&new.at);
    }
}

impl ProseClaim {
    /// Whether it says where a motion begins.
    fn claims_a_start(&self) -> bool {
        self.claims.iter().any(|(_, claim)| claim.assume.iter().any(|said| said.value.contains("(0) =")))
    }

    /// The findings on its displays.
    fn findings<'d>(&self, found: &'d Document, notes: &Notes) -> Vec<&'d Equation> {
        let equation = |at: &usize| {
            let id = notes.equations[*at].id()?;
            found.equations.iter().find(|equation| equation.id == id)
        };
        self.displays.iter().filter_map(equation).collect()
    }

    /// Whether its displays pass with it or are refuted, so that edits may make them pass.
    fn may_stand(&mut self, found: &Document, notes: &Notes) -> bool {
        let findings = self.findings(found, notes);
        if self.is_said {
            let refuted = findings.iter().filter(|equation| is_refuted(equation)).count();
            let passing = findings.iter().filter(|equation| passes(equation)).count();
            // Where no display passes with new coordinates, edits decide.
            self.is_doubtful = passing == 0 && self.gives_coordinates && refuted == findings.len();
            return self.is_doubtful || passing > 0 && passing >= refuted;
        }
        self.is_doubtful = findings.iter().any(|equation| is_refuted(equation));
        // Counterexamples are found later.
        let may_refute = |equation: &Equation| self.refutes != Refutes::Never && is_refuted(equation);
        match self.is_enough {
            true => findings.iter().any(|equation| passes(equation)),
            false => findings.iter().all(|equation| passes(equation) || may_refute(equation)),
        }
    }

    /// The same, of formulas in sentences, of which edits decide for new coordinates only.
    fn may_tie(&mut self, found: &Document, notes: &Notes) -> bool {
        let may_stand = self.may_stand(found, notes);
        self.is_doubtful &= self.gives_coordinates;
        may_stand
    }

    /// Whether a display is refuted that may be wrong for what the words say.
    fn may_refute(&self, equation: &Equation) -> bool {
        let is_stable = || {
            let parts = equation.parts.iter().map(|part| &part.finding);
            let mut found = parts.chain([&equation.finding]).filter_map(|finding| finding.counterexample.as_ref());
            // ω² = K/M is negative where the place is not stable.
            found.next().is_some_and(|counterexample| counterexample.rhs > 0.0)
        };
        is_refuted(equation)
            && match self.refutes {
                Refutes::WithAnEdit => true,
                Refutes::WhereStable => is_stable(),
                Refutes::WhereNatural | Refutes::Never => false,
            }
    }

    /// Whether the displays of it that a document has pass with it, or an edit of each makes them pass.
    fn stands(&self, found: &Document, notes: &Notes) -> bool {
        let findings = self.findings(found, notes);
        let is_slip = |equation: &Equation| self.may_refute(equation) && !equation.repairs.is_empty();
        match self.is_enough {
            true => findings.iter().all(|equation| !is_refuted(equation) || is_slip(equation)),
            false => findings.iter().all(|equation| passes(equation) || is_slip(equation)),
        }
    }
}

fn is_refuted(equation: &Equation) -> bool {
    matches!(equation.finding.verdict, Verdict::Refuted | Verdict::Domain)
}

/// Whether a display passes, or would if another one were corrected.
fn passes(equation: &Equation) -> bool {
    equation.ok || equation.finding.is_untested_definition() || equation.finding.follows_from.is_some()
}

/// A value that stands nowhere in the claims file.
fn spanned<T>(value: T) -> Spanned<T> {
    Spanned::new(value, Span::default())
}
