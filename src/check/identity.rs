//! Claims between two formulas: always, or on shell, under hypotheses.

use std::cell::OnceCell;

use crate::Result;
use crate::formula::evaluate::Unavailable;
use crate::formula::tree::Sign;
use crate::formula::{Expr, Index, IndexId, Node, Relation, SymbolId, text};
use crate::latex::typeset;
use crate::scalar::{Measured, TERMS};
use crate::source::Span;

use super::draw::{Draw, Reach};
use super::ensemble::{Condition, Ensemble, Setting};
use super::evidence::{self, Emptiness};
use super::judge::{self, Failure, Link, Point, Sides};
use super::model::{FrameQuantity, Law, Meaning, Model, Quantity};
use super::rules::{Action, Rule};
use super::scene::{Mode, Scene};
use super::twins::{Twin, twins};
use super::verdict::{Counterexample, Finding, Verdict};
use super::{adversary, branches, difference, edges, forced, formal, nothing, reached, sizes, tautology, wide};

/// How many states a pass needs.
pub const FEWEST: usize = 8;

/// What a check is run with.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The seed of all states.
    pub seed: u64,
    /// How many usable states are asked for.
    pub points: usize,
    /// Whether of what is refuted it is said by how much it is off, what may have been meant, and how the notes are mended.
    pub explain: bool,
}

/// A claim's hypotheses and its name, which seeds its states.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The symbols and the world.
    pub model: &'a Model,
    /// Seed and number of states.
    pub options: Options,
    /// The hypotheses.
    pub conditions: &'a [Condition],
    /// Whether the claim is pinned to hold always (`false`) or on shell (`true`).
    pub on_shell: Option<bool>,
    /// The name of the claim.
    pub topic: &'a str,
    /// The bytes of the notes that the claim is about.
    pub span: Span,
    /// How far from the declared ranges its states are drawn.
    pub reach: Reach,
    /// What symbols mean in this claim only.
    pub local: &'a [Rule],
}

impl<'a> Context<'a> {
    /// The mode of states on shell or off, with enough derivatives for these formulas and one more dot.
    pub fn mode(&self, on_shell: bool, formulas: &[&Expr]) -> Mode {
        let of_conditions = self.conditions.iter().flat_map(|c| [&c.lhs, &c.rhs]);
        let of_laws = self.model.laws.iter().flat_map(|law| &law.conditions).flat_map(|c| [&c.lhs, &c.rhs]);
        let of_laws = of_laws.filter(|_| on_shell);
        let of_rules = self.local.iter().flat_map(|rule| rule.action.formulas());
        // A symbol that a hypothesis or a law gives its value is differentiated as often as it is itself, and then as
        // often as the formula is.
        let beneath = of_conditions.chain(of_laws).chain(of_rules).map(|f| derivatives(f, self.model)).max();
        let needed = formulas.iter().map(|f| derivatives(f, self.model)).max();
        let stacked = on_shell && !self.model.laws.is_empty() || !self.local.is_empty();
        let needed = if stacked { needed.map(|n| n + beneath.unwrap_or(0)) } else { needed.max(beneath) };
        let usual = if self.model.world.is_some() { 2 } else { 1 };
        let least = if self.conditions.iter().any(|c| c.throughout) { 4 } else { usual };
        Mode { on_shell, order: (needed.unwrap_or(0) + 1).max(least).min(TERMS - 1) }
    }

    /// What its states obey.
    pub(super) fn setting(&self, mode: Mode) -> Setting<'a> {
        Setting { conditions: self.conditions, local: self.local, mode, reach: self.reach }
    }

    /// States of the claim.
    ///
    /// # Errors
    /// When the mass matrix is singular at all of them.
    pub fn ensemble(&self, mode: Mode, relaxed: bool, points: usize) -> Result<Ensemble<'a>> {
        let reach = if relaxed { Reach::Beyond } else { self.reach };
        Context { reach, ..*self }.ensemble_of(self.model, mode, points, if relaxed { "beyond" } else { "" })
    }

    /// States of the claim as a model has it, from a stream of their own.
    ///
    /// # Errors
    /// When the mass matrix is singular at all of them.
    pub(super) fn ensemble_of<'m>(
        &self,
        model: &'m Model,
        mode: Mode,
        points: usize,
        what: &str,
    ) -> Result<Ensemble<'m>> {
        Ensemble::named(model, &self.setting(mode), points, self.options.seed, &self.stream(mode, what))
    }

    /// States of the claim at special places.
    ///
    /// # Errors
    /// When the mass matrix is singular at all of them.
    pub fn special(&self, mode: Mode) -> Result<Ensemble<'a>> {
        Ensemble::special(self.model, &self.setting(mode), self.options.seed, &self.stream(mode, "special"))
    }

    /// The random numbers of its states.
    pub(super) fn draw(&self, mode: Mode, what: &str) -> Draw {
        Draw::new(self.options.seed, &self.stream(mode, what))
    }

    /// The name of their stream.
    fn stream(&self, mode: Mode, what: &str) -> String {
        format!("{}/{}/{what}", self.topic, mode.on_shell)
    }

    /// A finding about this claim.
    pub fn finding(&self, verdict: Verdict, message: impl Into<String>) -> Finding {
        Finding::new(verdict, self.span, message)
    }

    /// The finding that this claim holds, by numbers alone: a field has no word for what it is about.
    pub fn verified(&self, message: impl Into<String>, about: &str) -> Finding {
        Finding { not_certified_because: Some(about.to_owned()), ..self.finding(Verdict::Verified, message) }
    }

    /// The finding that no state obeys the hypotheses.
    pub fn no_room(&self, ensemble: &Ensemble<'_>) -> Finding {
        let message = "no state obeys the hypotheses: they contradict each other or leave no room";
        Finding { tried: ensemble.tried, ..self.finding(Verdict::Undecided, message) }
    }

    /// Why a formula has no value, as a finding.
    pub fn unavailable(&self, reason: &Unavailable) -> Finding {
        let message = match reason {
            Unavailable::Symbol(id) => {
                format!("nothing here gives {} a value", text::plain(&self.model.name(*id)))
            }
            Unavailable::Derivative(_) => format!("it needs time derivatives beyond the {}th", TERMS - 1),
            Unavailable::Operation(what) => format!("{what} cannot be evaluated"),
        };
        self.finding(Verdict::Unreadable, message)
    }
}

/// The order of the highest time derivative of a coordinate in a formula.
pub fn derivatives(expr: &Expr, model: &Model) -> usize {
    let inner = expr.children().into_iter().map(|child| derivatives(child, model)).max().unwrap_or(0);
    match &expr.node {
        Node::TimeDerivative(order, _) => inner + usize::from(*order),
        Node::Symbol { id, dots, .. } => {
            let own = match model.meaning(*id) {
                Some(Meaning::World(Quantity::RotationMatrix | Quantity::BodyAxes | Quantity::SpaceAxes)) => 0,
                Some(Meaning::World(_) | Meaning::Frame(FrameQuantity::AngularVelocity)) => 1,
                Some(Meaning::Defined(formula)) => derivatives(formula, model),
                _ => 0,
            };
            own + usize::from(*dots)
        }
        _ => inner,
    }
}

/// What a set of states says of a link.
pub struct Outcome {
    /// The states at which it could be judged.
    pub points: usize,
    /// The largest relative residual where it holds.
    pub residual: f64,
    /// The clearest failure, and the state.
    pub failure: Option<(Failure, usize)>,
    /// A state at which one side alone is defined.
    pub one_sided: Option<(Failure, usize)>,
    /// The states at which the sides differ by too little to call it a difference.
    pub doubtful: usize,
}

/// Tests a link at all states.
pub fn run(link: &Link, scenes: &[Scene<'_, Measured>]) -> Result<Outcome, Unavailable> {
    gathered(scenes.len(), |at| judge::test(link, &scenes[at]))
}

/// What so many states say.
fn gathered(states: usize, test: impl Fn(usize) -> Result<Point, Unavailable>) -> Result<Outcome, Unavailable> {
    let mut outcome = Outcome { points: 0, residual: 0.0, failure: None, one_sided: None, doubtful: 0 };
    for at in 0..states {
        match test(at)? {
            Point::Holds(residual) => {
                outcome.points += 1;
                outcome.residual = outcome.residual.max(residual);
            }
            Point::Fails(failure) => {
                outcome.points += 1;
                let clearer = |(known, _): &(Failure, usize)| failure.residual > known.residual;
                if outcome.failure.as_ref().is_none_or(clearer) {
                    outcome.failure = Some((failure, at));
                }
            }
            Point::OneSided(failure) => outcome.one_sided = Some((failure, at)),
            Point::Doubtful => outcome.doubtful += 1,
            Point::Useless => {}
        }
    }
    Ok(outcome)
}

/// A link at states, with the values of its sides where they were needed: twins share one of the two.
struct AtStates<'a, 'm> {
    link: &'a Link,
    scenes: &'a [Scene<'m, Measured>],
    sides: Vec<OnceCell<Option<Sides>>>,
}

impl<'a, 'm> AtStates<'a, 'm> {
    fn new(link: &'a Link, scenes: &'a [Scene<'m, Measured>]) -> Self {
        AtStates { link, scenes, sides: scenes.iter().map(|_| OnceCell::new()).collect() }
    }

    fn sides(&self, at: usize) -> Option<&Sides> {
        self.sides[at].get_or_init(|| Sides::of(self.link, &self.scenes[at]).ok()).as_ref()
    }

    /// Tests the link itself at all states.
    fn run(&self) -> Result<Outcome, Unavailable> {
        gathered(self.scenes.len(), |at| match self.sides(at) {
            Some(sides) => judge::test_sides(self.link, sides, &self.scenes[at]),
            None => judge::test(self.link, &self.scenes[at]),
        })
    }

    /// What a state says of a twin.
    fn test(&self, twin: &Link, at: usize) -> Result<Point, Unavailable> {
        judge::test_twin(twin, self.link, self.sides(at), &self.scenes[at])
    }

    /// Whether a twin fails at one of the states; it counts as failing where it has no value at all.
    fn fails(&self, twin: &Link) -> bool {
        (0..self.scenes.len()).any(|at| !matches!(self.test(twin, at), Ok(Point::Holds(_) | Point::Useless)))
    }
}

/// Checks a claim between two formulas; if it is refuted, the finding says what it is off by.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn check(link: &Link, context: &Context<'_>) -> Result<Finding> {
    let finding = judged(link, context)?;
    Ok(if context.options.explain { difference::explained(link, context, finding) } else { finding })
}

fn judged(link: &Link, context: &Context<'_>) -> Result<Finding> {
    if let Some(finding) = trivial(link, context) {
        return Ok(finding);
    }
    if nothing::is_its_rate(link, context)? {
        return Ok(context.finding(Verdict::Undecided, "what is differentiated is always 0, so nothing is checked"));
    }
    match (context.on_shell, context.model.has_motion()) {
        (Some(on_shell), true) => Ok(check_in(link, context, on_shell)?.0),
        (_, false) => Ok(check_in(link, context, false)?.0),
        (None, true) => {
            let (always, next) = check_in(link, context, false)?;
            if next == Next::Settled {
                return Ok(always);
            }
            let (on_shell, _) = check_in(link, context, true)?;
            Ok(match (always.verdict, on_shell.verdict) {
                (always_verdict, verdict) if always_verdict.holds() && verdict.holds() => always,
                (Verdict::Undecided, Verdict::Refuted | Verdict::Undecided) => always,
                _ => on_shell,
            })
        }
    }
}

/// Whether a claim tested off shell must be tested on shell as well.
#[derive(Clone, Copy, PartialEq)]
enum Next {
    Settled,
    OnShell,
}

/// Whether a relation says that two things are the same.
pub fn is_equality(relation: Relation) -> bool {
    matches!(relation, Relation::Equal | Relation::Identical)
}

/// Checks a claim at states on shell or off.
fn check_in(link: &Link, context: &Context<'_>, on_shell: bool) -> Result<(Finding, Next)> {
    let mode = context.mode(on_shell, &[&link.lhs, &link.rhs]);
    let mut ensemble = context.ensemble(mode, false, context.options.points)?;
    if ensemble.scenes.is_empty() {
        return Ok((context.no_room(&ensemble), Next::Settled));
    }
    let forced = forced::of_claim(link, context, &ensemble);
    if !is_equality(link.relation) {
        let special = context.special(mode)?;
        ensemble.tried += special.tried;
        // What nothing but drawn numbers is made of has its edges off shell, where it was tried.
        let plain = |expr: &Expr| context.model.is_plain(expr) && derivatives(expr, context.model) == 0;
        if !on_shell || !plain(&link.lhs) || !plain(&link.rhs) {
            let own: Vec<_> = edges::of_link(link).into_iter().collect();
            let of_claim = own.len();
            let all: Vec<_> =
                own.into_iter().chain(context.conditions.iter().filter_map(edges::of_hypothesis)).collect();
            let edges = edges::states((&all, of_claim), context, &ensemble, &special)?;
            ensemble.tried += edges.len();
            ensemble.scenes.extend(edges);
        }
        ensemble.scenes.extend(special.scenes);
        reached::reached(link, context, &mut ensemble);
    }
    reached::within_doubles(link, context, &mut ensemble)?;
    let fails = |scene: &Scene<'_, Measured>| matches!(judge::test(link, scene), Ok(Point::Fails(_)));
    ensemble.scenes.extend(branches::states(context, &ensemble)?.into_iter().filter(fails));
    let states = AtStates::new(link, &ensemble.scenes);
    let outcome = match states.run() {
        Ok(outcome) => outcome,
        Err(reason) => return Ok((context.unavailable(&reason), Next::Settled)),
    };
    let finding = conclude(&states, context, &ensemble, &outcome);
    // What is claimed of all states is claimed of the motions: an inequality may fail on them alone.
    let open = outcome.failure.is_some() || outcome.doubtful > 0 || !is_equality(link.relation);
    let next = if open { Next::OnShell } else { Next::Settled };
    if let (Verdict::Verified, Some(symbol)) = (finding.verdict, forced) {
        let message = forced::message(symbol, context);
        return Ok((Finding { verdict: Verdict::Undecided, message, ..finding }, next));
    }
    // Near misses of an inequality are inequalities too: only an equality is held against its twins.
    if finding.verdict != Verdict::Verified {
        return Ok((finding, next));
    }
    if !is_equality(link.relation) {
        let finding = Finding { not_certified_because: Some("an ordering".to_owned()), ..finding };
        let finding = sizes::looked_at(link, context, mode, finding)?;
        return Ok((adversary::looked_at(link, context, &ensemble, finding), next));
    }
    let withheld =
        |message: String| Ok((Finding { verdict: Verdict::Undecided, message, ..finding.clone() }, Next::Settled));
    if let Some(term) = evidence::unseen(link, &ensemble.scenes) {
        return withheld(format!("“{term}” is too small beside the other terms to be seen"));
    }
    let special = on_shell || !context.conditions.is_empty();
    if special && evidence::vanishes_throughout(link, &ensemble.scenes) {
        let place = if on_shell { "on shell" } else { "under its hypotheses" };
        return withheld(format!("both sides vanish {place}, so nothing tells one factor from another"));
    }
    let emptiness = evidence::emptiness(link, context, on_shell)?;
    if let Emptiness::Empty(reason) = emptiness {
        return withheld(reason.to_owned());
    }
    let mut finding = held_against_twins(&states, context, ensemble.mode, finding)?;
    if finding.verdict == Verdict::Verified {
        if on_shell && let Some(combination) = evidence::combination(link, context)? {
            finding.message.push_str(&format!(": it is {combination}"));
        }
        if let Emptiness::Follows = emptiness {
            finding.message.push_str("; it follows from its assumptions alone");
        }
        let unneeded = evidence::unneeded(link, context, on_shell)?;
        if !unneeded.is_empty() {
            finding.message.push_str(&format!("; it does not need {}", unneeded.join(", ")));
        }
        drop(states);
        finding = sizes::certified(link, context, &ensemble, finding)?;
        finding = sizes::looked_at(link, context, ensemble.mode, finding)?;
        finding = wide::looked_at(link, context, ensemble.mode, finding)?;
    }
    let next = if finding.verdict == Verdict::Refuted { Next::OnShell } else { Next::Settled };
    Ok((finding, next))
}

/// Claims that say nothing: both sides the same formula, or the hypothesis itself.
fn trivial(link: &Link, context: &Context<'_>) -> Option<Finding> {
    if link.lhs == link.rhs {
        return Some(context.finding(Verdict::Undecided, "both sides are one formula, so nothing is checked"));
    }
    let opened = |expr: &Expr| match expr.as_plain_symbol().and_then(|id| context.model.meaning(id)) {
        Some(Meaning::Defined(formula)) => formula.as_ref().clone(),
        _ => expr.clone(),
    };
    if is_equality(link.relation) && opened(&link.lhs) == opened(&link.rhs) {
        return Some(context.finding(Verdict::Definition, "true by definition: the claims file defines it so"));
    }
    if let Some(finding) = context.unclear(&[&link.lhs, &link.rhs]) {
        return Some(finding);
    }
    for rule in context.local {
        let bare =
            [&link.lhs, &link.rhs].into_iter().any(|side| side.symbols().iter().any(|(id, _)| *id == rule.symbol));
        match &rule.action {
            Action::Equals(formula)
                if bare
                    && ([&link.lhs, &link.rhs].into_iter().any(|side| opened(side) == *formula)
                        || tautology::is_linear_in(link, rule.symbol)
                            && formal::is_identity_where(&link.lhs, &link.rhs, context.local, context.model)) =>
            {
                return Some(context.finding(Verdict::Undecided, "it only restates what \"where\" says"));
            }
            _ => {}
        }
    }
    let is_hypothesis = |c: &Condition| {
        c.relation == link.relation
            && (c.lhs == link.lhs && c.rhs == link.rhs || c.lhs == link.rhs && c.rhs == link.lhs)
    };
    if let Some(law) = context.model.laws.iter().find(|law| law.conditions.iter().any(is_hypothesis)) {
        return (context.on_shell != Some(false))
            .then(|| context.finding(Verdict::Law, format!("taken for granted: {}", law.title())));
    }
    context
        .conditions
        .iter()
        .any(is_hypothesis)
        .then(|| context.finding(Verdict::Undecided, "this is one of its own hypotheses, so nothing is checked"))
}

fn conclude(states: &AtStates<'_, '_>, context: &Context<'_>, ensemble: &Ensemble<'_>, outcome: &Outcome) -> Finding {
    let link = states.link;
    let evidence = |verdict, message: String| Finding {
        points: outcome.points,
        tried: ensemble.tried,
        max_residual: (outcome.points > 0).then_some(outcome.residual),
        ..context.finding(verdict, message)
    };
    let free = context.conditions.is_empty() && context.local.is_empty();
    let whence = match (ensemble.mode.on_shell, free) {
        (false, true) => "always",
        (false, false) => "under its hypotheses",
        (true, true) => "on shell",
        (true, false) => "on shell, under its hypotheses",
    };
    let whence = &match (ensemble.mode.on_shell, context.model.laws.as_slice()) {
        (false, _) | (_, []) => whence.to_owned(),
        (true, laws) => {
            let names: Vec<String> = laws.iter().map(Law::title).collect();
            format!("{}, given {}", whence.replace("on shell", "by law"), names.join(", "))
        }
    };
    if let Some((failure, at)) = &outcome.failure {
        let message = match (&failure.entry, link.relation) {
            (Some(entry), _) => format!("fails {whence}, at {entry}"),
            (None, Relation::Equal | Relation::Identical) => format!("the two sides differ, {whence}"),
            (None, relation) => format!("“{}” fails, {whence}", relation.glyph()),
        };
        let mut finding = evidence(Verdict::Refuted, message);
        finding.max_residual = Some(failure.residual);
        finding.counterexample = Some(counterexample(link, &ensemble.scenes[*at], failure));
        if let Some(twin) = context.options.explain.then(|| meant(states, context.model)).flatten() {
            finding.message.push_str(&format!("; it would hold with {}", twin.change));
        }
        return finding;
    }
    if let (Some((failure, at)), true) = (&outcome.one_sided, outcome.points > 0) {
        let which = if failure.lhs.is_finite() { "right" } else { "left" };
        let message = format!("agrees wherever both sides are defined, but the {which} side is not defined everywhere");
        let mut finding = evidence(Verdict::Domain, message);
        finding.counterexample = Some(counterexample(link, &ensemble.scenes[*at], failure));
        return finding;
    }
    if outcome.doubtful > 0 {
        let message = format!(
            "at {} of {} states the sides differ by more than rounding, and too little to call it a difference",
            outcome.doubtful, ensemble.tried
        );
        return evidence(Verdict::Undecided, message);
    }
    if outcome.points < FEWEST.min(context.options.points) {
        let message = format!("only {} of {} states can tell: too few", outcome.points, ensemble.tried);
        return evidence(Verdict::Undecided, message);
    }
    evidence(Verdict::Verified, format!("holds {whence}"))
}

/// The first twin that holds at all states: what may have been meant.
fn meant(states: &AtStates<'_, '_>, model: &Model) -> Option<Twin> {
    let count = states.scenes.len();
    twins(states.link, model).into_iter().find(|twin| {
        let mut points = 0;
        let clean = (0..count).all(|at| match states.test(&twin.link, at) {
            Ok(Point::Holds(_)) => {
                points += 1;
                true
            }
            Ok(Point::Useless) => true,
            _ => false,
        });
        clean && points >= FEWEST.min(count)
    })
}

/// A pass stands only if the states refute every twin that is not as true as the claim itself.
fn held_against_twins(
    states: &AtStates<'_, '_>,
    context: &Context<'_>,
    mode: Mode,
    finding: Finding,
) -> Result<Finding> {
    let link = states.link;
    let survivors: Vec<Twin> =
        twins(link, context.model).into_iter().filter(|twin| !states.fails(&twin.link)).collect();
    if survivors.is_empty() {
        return Ok(finding);
    }
    // A twin that holds where the claim does and fails where it does, far beyond the ranges, says the same.
    let wide = context.ensemble(mode, true, 3 * context.options.points)?;
    let holds = |found: Result<Point, Unavailable>| match found {
        Ok(Point::Holds(_)) => Some(true),
        Ok(Point::Useless) => None,
        _ => Some(false),
    };
    let states = AtStates::new(link, &wide.scenes);
    let itself: Vec<Option<bool>> = (0..wide.scenes.len()).map(|at| holds(states.test(link, at))).collect();
    for twin in survivors {
        let told_apart = |(at, itself): (usize, &Option<bool>)| match (itself, holds(states.test(&twin.link, at))) {
            (Some(a), Some(b)) => *a != b,
            _ => false,
        };
        if itself.iter().enumerate().any(told_apart) {
            let message = format!("these states cannot tell it from the same claim with {}", twin.change);
            return Ok(Finding { message, verdict: Verdict::Undecided, ..finding });
        }
    }
    Ok(finding)
}

/// The state of a failure: the values of the claim's symbols.
pub fn counterexample(link: &Link, scene: &Scene<'_, Measured>, failure: &Failure) -> Counterexample {
    Counterexample {
        state: values(&[&link.lhs, &link.rhs], scene),
        lhs: failure.lhs,
        rhs: failure.rhs,
        entry: failure.entry.clone(),
    }
}

/// So many values of a counterexample are shown.
const MOST_SHOWN: usize = 40;

/// The values of the plain symbols of some formulas at a state, dotted ones as they occur.
pub fn values(formulas: &[&Expr], scene: &Scene<'_, Measured>) -> Vec<(String, f64)> {
    let model = scene.model();
    let mut found: Vec<(String, f64)> = Vec::new();
    for formula in formulas {
        formula.walk(&mut |expr| {
            let Node::Symbol { id, indices, dots } = &expr.node else { return };
            // Of a family, every member there is.
            let mut labels: Vec<(IndexId, u8)> = Vec::new();
            for index in indices {
                match index {
                    Index::Letter(letter) if !labels.iter().any(|(known, _)| known == letter) => {
                        labels.push((*letter, 1))
                    }
                    _ => {}
                }
            }
            loop {
                let at = |index: &Index| match index {
                    Index::Letter(letter) => {
                        Index::Fixed(labels.iter().find(|(known, _)| known == letter).map_or(1, |(_, value)| *value))
                    }
                    fixed => *fixed,
                };
                let member = Node::Symbol { id: *id, indices: indices.iter().map(at).collect(), dots: *dots };
                let member = Expr::new(member, expr.span);
                let name = typeset(&member, &model.symbols);
                let Ok(value) = scene.now(&member, &[]) else { return };
                let entries = value.entries();
                for (axis, entry) in ["x", "y", "z"].iter().zip(&entries) {
                    let name = if entries.len() == 1 { name.clone() } else { format!("{name} {axis}") };
                    if entries.len() <= 3 && found.len() < MOST_SHOWN && !found.iter().any(|(known, _)| *known == name)
                    {
                        found.push((name, entry.value));
                    }
                }
                if !matches!(judge::advance(&mut labels, scene), Ok(true)) {
                    return;
                }
            }
        });
    }
    if found.is_empty() {
        let coordinates = model.coordinates.iter().zip(scene.coordinates());
        found.extend(coordinates.map(|(variable, value)| (model.name(variable.symbol), value.value().value)));
    }
    found
}

/// Checks that a formula does not change along the motion, and that this says something. What is assumed of
/// anything but families is assumed at all times.
///
/// # Errors
/// When the world's mass matrix is singular.
pub fn conserved(expr: &Expr, context: &Context<'_>) -> Result<Finding> {
    if !context.model.has_motion() {
        return Ok(context.finding(Verdict::Undecided, "nothing says how it moves: name a \"system\" or \"laws\""));
    }
    if let Some(finding) = context.unclear(&[expr]) {
        return Ok(finding);
    }
    // Constant is said of all times; a hypothesis about an instant would make of any turning point a constant.
    // What is said of families, and of constants alone, stays as it is.
    let symbols = &context.model.symbols;
    let varies = |symbol: &SymbolId| !matches!(context.model.meaning(*symbol), Some(Meaning::Constant(_)));
    let at_all_times = |condition: &Condition| {
        let drawn = forced::drawn(&[&condition.lhs, &condition.rhs], context.model);
        let single = drawn.iter().all(|symbol| symbols.entry(*symbol).slots.is_empty());
        Condition { throughout: condition.throughout || single && drawn.iter().any(varies), ..condition.clone() }
    };
    let conditions: Vec<Condition> = context.conditions.iter().map(at_all_times).collect();
    let context = &Context { conditions: &conditions, ..*context };
    let rate = Expr::new(Node::TimeDerivative(1, Box::new(expr.clone())), expr.span);
    let zero = Expr::integer(0, expr.span);
    let free = crate::formula::shape::bind(expr.clone(), &context.model.symbols).map(|(_, found)| found.free);
    let link = Link { lhs: rate, relation: Relation::Equal, rhs: zero, free: free.unwrap_or_default() };
    let off_shell = context.ensemble(context.mode(false, &[&link.lhs]), false, context.options.points)?;
    match run(&link, &off_shell.scenes) {
        Err(reason) => return Ok(context.unavailable(&reason)),
        Ok(outcome) if outcome.failure.is_none() => {
            return Ok(context.finding(Verdict::Undecided, "it does not vary even off shell, so nothing is conserved"));
        }
        Ok(_) => {}
    }
    let on_shell = Context { on_shell: Some(true), ..*context };
    let mode = on_shell.mode(true, &[&link.lhs]);
    let ensemble = on_shell.ensemble(mode, false, context.options.points)?;
    if ensemble.scenes.is_empty() {
        return Ok(context.no_room(&ensemble));
    }
    let states = AtStates::new(&link, &ensemble.scenes);
    let outcome = match states.run() {
        Ok(outcome) => outcome,
        Err(reason) => return Ok(context.unavailable(&reason)),
    };
    let mut finding = conclude(&states, &on_shell, &ensemble, &outcome);
    if let (Verdict::Verified, Some(symbol)) = (finding.verdict, forced::of_formulas(&[expr], &on_shell, &ensemble)) {
        return Ok(context.finding(Verdict::Undecided, forced::message(symbol, context)));
    }
    finding.message = match finding.verdict {
        Verdict::Verified => {
            finding.message = "constant on shell".to_owned();
            return sizes::certified(&link, &on_shell, &ensemble, finding);
        }
        Verdict::Refuted => "it varies on shell; the left side is its rate".to_owned(),
        _ => finding.message,
    };
    Ok(finding)
}

/// `expr + dropped`: the side of a claim with what its author left out.
pub fn with_dropped(expr: &Expr, dropped: &Expr) -> Expr {
    let plus = |expr: &Expr| crate::formula::Term { sign: Sign::Plus, sign_span: None, expr: expr.clone() };
    Expr::new(Node::Sum(vec![plus(expr), plus(dropped)]), expr.span)
}
