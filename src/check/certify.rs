//! Certificates: whether a claim that agrees in numbers is an identity, decided over a prime field.
//!
//! The claim, the world's equations of motion and the claim's hypotheses are evaluated at random points of the field
//! ([`crate::scalar::field`]); an identity vanishes at all of them, and what is none vanishes by accident with a
//! probability that its degree bounds. Points are added until that is at most 2⁻⁸⁰. Hypotheses are solved exactly, each
//! for a number in which it is linear. What has no meaning in a field is said, and nothing is concluded.
//!
//! A certificate never stands alone: it is asked for when numbers have agreed, so that ranges, branches of roots and the
//! twins are theirs to judge.

use crate::formula::evaluate::Unavailable;
use crate::formula::{Expr, IndexId, Node, Relation, SymbolId, Value, text};
use crate::mechanics::Elimination;
use crate::notes::claims::Range;
use crate::scalar::field::{Large, at_a_point, false_accept_log2};
use crate::scalar::{Modular, Series, rational};

use super::base;
use super::draw::{Draw, Reach};
use super::ensemble::Ensemble;
use super::identity::Context;
use super::judge::{self, Link};
use super::model::{Meaning, Model, ParticleQuantity};
use super::rules::Action;
use super::scene::Scene;
use super::solver::{Row, Solver};
use super::verdict::{Finding, Verdict};

/// The probability of a false certificate is at most two to this power.
pub const FALSE_ACCEPT_LOG2: f64 = -80.0;

/// So many independent points are used at least, and so many at most.
const POINTS: std::ops::RangeInclusive<usize> = 2..=6;

/// So many points are tried for one at which no denominator vanishes and every root exists.
const ATTEMPTS: u32 = 64;

/// So many numbers are tried to solve a hypothesis for.
const CANDIDATES: usize = 40;

/// With more square roots than this the choices of their signs are too many.
const MOST_ROOTS: u32 = 5;

/// What a field says of a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Certificate {
    /// It is an identity, up to a probability of two to this power.
    Identity(f64),
    /// Not decided, and why.
    Open(String),
    /// It is none, although numbers do not show it.
    Differs,
}

impl Certificate {
    /// The finding on a claim that agreed in numbers, with what the field says of it.
    pub fn stamp(self, finding: Finding) -> Finding {
        match self {
            Certificate::Identity(log2) => {
                Finding { verdict: Verdict::Certified, false_accept_log2: Some(log2), ..finding }
            }
            Certificate::Open(reason) => Finding { not_certified_because: Some(reason), ..finding },
            Certificate::Differs => {
                let message = "the two sides differ by less than numbers show: as an identity it is false".to_owned();
                Finding { verdict: Verdict::Refuted, message, ..finding }
            }
        }
    }
}

/// What is evaluated at a point: differences that must all vanish.
type Differences = Result<Vec<Modular>, String>;

/// Decides a claim between two formulas, under the hypotheses by which an ensemble was drawn.
pub fn certify(link: &Link, context: &Context<'_>, ensemble: &Ensemble<'_>) -> Certificate {
    decide(&[&link.lhs, &link.rhs], context, ensemble, |scene| differences(link, scene))
}

/// Decides whether formulas solve a target for an unknown, and are all of its solutions: as many as its degree.
pub fn certify_solutions(
    target: &Link,
    unknown: SymbolId,
    branches: &[Expr],
    all_of_them: bool,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
) -> Certificate {
    let formulas: Vec<&Expr> = [&target.lhs, &target.rhs].into_iter().chain(branches).collect();
    decide(&formulas, context, ensemble, |scene| {
        let mut all = Vec::new();
        for branch in branches {
            let Value::Scalar(root) = scene.now(branch, &[]).map_err(|reason| unavailable(&reason, context))? else {
                return Err("a solution that is no number".to_owned());
            };
            scene.set_only(&[(unknown, Series::constant(root))]);
            let found = differences(target, scene);
            scene.set_only(&[]);
            all.extend(found?);
        }
        if all_of_them {
            all.extend(degree_exceeds(target, unknown, branches.len(), scene)?);
        }
        Ok(all)
    })
}

/// Vanishes if a target is a polynomial of no more than some degree in an unknown: its differences of the next order.
fn degree_exceeds(target: &Link, unknown: SymbolId, degree: usize, scene: &mut Scene<'_, Modular>) -> Differences {
    let start = Modular::drawn();
    let mut columns = Vec::new();
    for step in 0..=degree + 1 {
        scene.set_only(&[(unknown, Series::constant(start + step as f64))]);
        let found = differences(target, scene);
        scene.set_only(&[]);
        columns.push(found?);
    }
    let (mut sum, mut binomial) = (vec![Modular::from(0.0); columns[0].len()], 1.0);
    for (k, column) in columns.iter().enumerate() {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        for (sum, value) in sum.iter_mut().zip(column) {
            *sum += *value * (sign * binomial);
        }
        binomial = binomial * (degree + 1 - k.min(degree + 1)) as f64 / (k + 1) as f64;
    }
    Ok(sum)
}

/// Left side minus right side, entry by entry, for all values of the free indices.
fn differences(link: &Link, scene: &Scene<'_, Modular>) -> Differences {
    let mut indices: Vec<(IndexId, u8)> = link.free.iter().map(|id| (*id, 1)).collect();
    let mut all = Vec::new();
    let reason = |reason: Unavailable| unavailable_in(&reason, scene.model());
    loop {
        let lhs = scene.now(&link.lhs, &indices).map_err(reason)?;
        let rhs = scene.now(&link.rhs, &indices).map_err(reason)?;
        let (a, b) = judge::pair(lhs, rhs);
        all.extend(a.into_iter().zip(b).map(|(a, b)| a - b));
        if !judge::advance(&mut indices, scene).map_err(reason)? {
            return Ok(all);
        }
    }
}

fn unavailable(reason: &Unavailable, context: &Context<'_>) -> String {
    unavailable_in(reason, context.model)
}

fn unavailable_in(reason: &Unavailable, model: &Model) -> String {
    match reason {
        Unavailable::Symbol(id) => format!("{} has no exact value", text::plain(&model.name(*id))),
        Unavailable::Derivative(_) => "a derivative that is not known".to_owned(),
        Unavailable::Operation(what) => (*what).to_owned(),
    }
}

/// Decides whether differences vanish, as often as the bound needs.
fn decide(
    formulas: &[&Expr],
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    evaluate: impl Fn(&mut Scene<'_, Modular>) -> Differences,
) -> Certificate {
    let solver = &ensemble.solver;
    if let Some(reason) = outside(formulas, solver, ensemble) {
        return Certificate::Open(reason);
    }
    let mut draw = Draw::new(context.options.seed, &format!("{}/{}/field", context.topic, ensemble.mode.on_shell));
    let mut exactly = Exactly { solver, plan: Vec::new(), finest: 1, anywhere: Vec::new(), idle: Vec::new() };
    if solver.equalities().next().is_some()
        && let Err(reason) = {
            exactly.anywhere = anywhere(context, ensemble);
            exactly.rehearse(draw.seed(), &ensemble.bases[0])
        }
    {
        return Certificate::Open(reason);
    }
    let mut log2 = 0.0;
    for points in 1..=*POINTS.end() {
        // how many particles there are, and other whole numbers, are those of a state
        let base = &ensemble.bases[points % ensemble.bases.len()];
        match exactly.at_one_point(draw.seed(), base, &evaluate) {
            Certificate::Identity(bound) => log2 += bound,
            other => return other,
        }
        if points >= *POINTS.start() && log2 <= FALSE_ACCEPT_LOG2 {
            return Certificate::Identity(log2);
        }
    }
    Certificate::Open("its degree is too high for this field".to_owned())
}

/// Why a claim cannot be decided over a field, as far as its formulas show.
pub(super) fn outside(formulas: &[&Expr], solver: &Solver<'_>, ensemble: &Ensemble<'_>) -> Option<String> {
    let model = solver.model;
    let of_conditions = solver.conditions.iter().flat_map(|c| [&c.lhs, &c.rhs]);
    let of_rules = ensemble.rules.iter().filter_map(|rule| match &rule.action {
        Action::Equals(formula) | Action::Parallel(formula) | Action::Follows { formula, .. } => Some(formula),
        Action::Symmetric { .. } | Action::Union(_) => None,
    });
    let mut waiting: Vec<&Expr> = formulas.iter().copied().chain(of_conditions).chain(of_rules).collect();
    let (mut seen, mut reason): (Vec<SymbolId>, Option<&str>) = (Vec::new(), None);
    while let Some(formula) = waiting.pop() {
        let mut symbols = Vec::new();
        formula.walk(&mut |expr| match &expr.node {
            Node::Number(digits) if digits.chars().filter(char::is_ascii_digit).count() > rational::DIGITS => {
                reason = reason.or(Some("a number of so many digits"));
            }
            Node::Integral(..) => reason = reason.or(Some("an integral")),
            Node::Shrinking(..) => reason = reason.or(Some("a limit")),
            Node::Symbol { id, .. } => symbols.push(*id),
            _ => {}
        });
        while let Some(id) = symbols.pop() {
            if seen.contains(&id) {
                continue;
            }
            seen.push(id);
            symbols.extend(&model.symbols.entry(id).members);
            match model.meaning(id) {
                Some(Meaning::Defined(formula)) => waiting.push(formula),
                Some(Meaning::Particles(quantity, _, masses, positions)) => {
                    if *quantity != ParticleQuantity::InertiaTensor {
                        reason = reason.or(Some("principal axes, which are found as numbers"));
                    }
                    waiting.extend([masses.as_ref(), positions.as_ref()]);
                }
                Some(Meaning::Region(_) | Meaning::Density(_) | Meaning::Point) => {
                    reason = reason.or(Some("a continuum"));
                }
                Some(Meaning::Rigid(at)) => symbols.extend(model.rigid[*at].about),
                _ => {}
            }
        }
    }
    reason.map(str::to_owned)
}

/// Numbers drawn for the slots of an ensemble and moved onto nothing; whole numbers are those of its first state.
fn anywhere(context: &Context<'_>, ensemble: &Ensemble<'_>) -> Vec<f64> {
    let slots = &ensemble.solver.slots;
    let mut base = Draw::new(context.options.seed, &format!("{}/anywhere", context.topic)).base(slots, Reach::Declared);
    for ((number, slot), known) in base.iter_mut().zip(slots).zip(&ensemble.bases[0]) {
        if matches!(slot.range, Range::Integer { .. }) {
            *number = *known;
        }
    }
    base
}

/// Makes three numbers the components of a unit vector, by the stereographic projection of the first two.
fn unit_vector(direction: &mut [Modular]) {
    let [x, y, z] = direction else { return };
    let (a, b) = (*x, *y);
    let square = a * a + b * b;
    let length = square + 1.0;
    (*x, *y, *z) = (a * 2.0 / length, b * 2.0 / length, (-square + 1.0) / length);
}

/// Evaluation at points where the hypotheses hold exactly.
struct Exactly<'s, 'm> {
    solver: &'s Solver<'m>,
    /// Which row of the hypotheses is solved for which number; found at the first point.
    plan: Vec<(Row, usize)>,
    /// The least common denominator of multiples of angles.
    finest: u64,
    /// Numbers that obey no hypothesis: there nothing is at rest by accident.
    anywhere: Vec<f64>,
    /// The numbers that a row was found not to depend on.
    idle: Vec<(Row, Vec<usize>)>,
}

const NOT_SOLVED: &str = "hypotheses that are not linear in a number of their own, so that they are not solved exactly";

impl<'m> Exactly<'_, 'm> {
    /// Whether differences vanish at a point, for all signs of square roots.
    fn at_one_point(
        &mut self,
        seed: u64,
        base: &[f64],
        evaluate: &impl Fn(&mut Scene<'_, Modular>) -> Differences,
    ) -> Certificate {
        let (mut attempt, mut signs, mut log2) = (0, 0, f64::NEG_INFINITY);
        let mut nowhere = None;
        while attempt < ATTEMPTS {
            let finest = self.finest;
            let point = seed.wrapping_add(u64::from(attempt));
            let ((result, vanish, bound), account) = at_a_point::<Large, _>(point, signs, finest, || {
                let result = self.scene(base).and_then(|mut scene| evaluate(&mut scene));
                let vanish = result.as_ref().is_ok_and(|all| all.iter().all(|difference| difference.vanishes()));
                let result: Differences = result;
                (result.as_ref().err().cloned(), vanish, result.unwrap_or_default())
            });
            if let Some(fault) = account.fault {
                return Certificate::Open(fault.to_owned());
            }
            if account.finest > finest || account.elsewhere.is_some() {
                attempt += u32::from(account.elsewhere.is_some());
                nowhere = account.elsewhere.or(nowhere);
                (self.finest, signs, log2) = (account.finest, 0, f64::NEG_INFINITY);
                continue;
            }
            if let Some(reason) = result {
                return Certificate::Open(reason);
            }
            if !vanish {
                return match (account.opaque, self.plan.is_empty()) {
                    (false, true) => Certificate::Differs,
                    (true, _) => {
                        Certificate::Open("a root, or a sine of something that is no sum of angles".to_owned())
                    }
                    (false, false) => Certificate::Open("hypotheses with more than one solution".to_owned()),
                };
            }
            let Some(bound) = false_accept_log2(&bound, &account, ATTEMPTS) else {
                return Certificate::Open("coefficients that could be as large as the field".to_owned());
            };
            log2 = log2.max(bound);
            signs += 1;
            if account.roots > MOST_ROOTS {
                return Certificate::Open(format!("{} square roots, each with two signs", account.roots));
            }
            if signs >> account.roots == 1 {
                return Certificate::Identity(log2);
            }
        }
        Certificate::Open(nowhere.unwrap_or("fractions of angles").to_owned())
    }

    /// Finds what the hypotheses are solved for, at a point of which nothing else is used.
    fn rehearse(&mut self, seed: u64, base: &[f64]) -> Result<(), String> {
        for attempt in 0..ATTEMPTS {
            let (found, account) = at_a_point::<Large, _>(seed.wrapping_add(attempt.into()), 0, 1, || {
                self.plan.clear();
                self.scene(base).map(|_| ())
            });
            if account.elsewhere.is_none() {
                return account.fault.map_or(found, |fault| Err(fault.to_owned()));
            }
        }
        Ok(())
    }

    /// The state at the point at hand, with whole numbers as in `base`.
    fn scene(&mut self, base: &[f64]) -> Result<Scene<'m, Modular>, String> {
        let drawn = self.solver.slots.iter().zip(base).map(|(slot, value)| match slot.range {
            Range::Integer { .. } => Modular::from(*value),
            // nobody takes the sine of a velocity
            _ if slot.order > 0 => Modular::drawn_plain(),
            _ => Modular::drawn(),
        });
        let mut base: Vec<Modular> = drawn.collect();
        if let Some(direction) = base::direction(self.solver.model) {
            unit_vector(&mut base[direction.clone()]);
            // ω comes from R and Ṙ, as long polynomials; it is no accident that it is this
            let rate = self.solver.slots.iter().rposition(|slot| slot.order == 1 && slot.symbol.is_none());
            for component in direction {
                base[component].kept();
                if let Some(rate) = rate {
                    (base[component] * base[rate]).kept();
                }
            }
        }
        if self
            .solver
            .conditions
            .iter()
            .zip(self.solver.explicit())
            .any(|(condition, is_rule)| condition.relation == Relation::Proportional && !is_rule)
        {
            return Err(NOT_SOLVED.to_owned());
        }
        let mut scene = self.state(&base)?;
        if !self.plan.is_empty() {
            // another number of particles has other rows
            let rows = self.solver.rows(&scene);
            for (row, slot) in self.plan.clone() {
                if rows.iter().any(|(known, _)| *known == row) {
                    let value = self.value(&base, row)?;
                    self.put(&mut base, (row, value), slot)?.ok_or(NOT_SOLVED)?;
                }
            }
            scene = self.state(&base)?;
        }
        let (rows, mut values): (Vec<Row>, Vec<Modular>) = self.solver.rows(&scene).into_iter().unzip();
        for (at, row) in rows.iter().enumerate() {
            if !values[at].vanishes() {
                self.extend(&mut base, (*row, values[at]), &rows)?;
                scene = self.state(&base)?;
                values = self.solver.values(&scene, &rows).ok_or(NOT_SOLVED)?;
            }
        }
        if values.iter().all(|value| value.vanishes()) { Ok(scene) } else { Err(NOT_SOLVED.to_owned()) }
    }

    fn state(&self, base: &[Modular]) -> Result<Scene<'m, Modular>, String> {
        let terms = self.solver.mode.order + 1;
        self.solver.scene_by(Elimination::Cramer, base, terms).map_err(|error| error.message().to_owned())
    }

    fn value(&self, base: &[Modular], row: Row) -> Result<Modular, String> {
        let values = self.solver.values(&self.state(base)?, &[row]).ok_or(NOT_SOLVED)?;
        Ok(values[0])
    }

    /// Moves a number of the base so that a row vanishes, whose value is known, if the row is linear in it.
    fn put(&self, base: &mut [Modular], (row, zero): (Row, Modular), slot: usize) -> Result<Option<()>, String> {
        let start = base[slot];
        let mut at = |step: f64| {
            base[slot] = start + step;
            self.value(base, row)
        };
        let one = at(1.0)?;
        let slope = one - zero;
        // most numbers have nothing to do with a row
        if slope.vanishes() || !(at(2.0)? - one - slope).vanishes() {
            base[slot] = start;
            return Ok(None);
        }
        base[slot] = start - zero / slope;
        Ok(Some(()))
    }

    /// Those of some numbers that a row does not depend on: most have nothing to do with it, and doubles tell it sooner.
    fn idle(&mut self, row: Row, slots: &[usize]) -> Vec<usize> {
        if let Some((_, idle)) = self.idle.iter().find(|(known, _)| *known == row) {
            return idle.clone();
        }
        let idle: Vec<usize> =
            slots.iter().copied().filter(|slot| !self.solver.depends(&self.anywhere, row, *slot)).collect();
        self.idle.push((row, idle.clone()));
        idle
    }

    /// Finds a number to solve a row for, whose value is known, such that the rows before it hold still.
    fn extend(&mut self, base: &mut Vec<Modular>, (row, value): (Row, Modular), rows: &[Row]) -> Result<(), String> {
        let known = self.solver.plan.iter().filter(|(planned, _)| *planned == row).map(|(_, slot)| *slot);
        let free = |slot: &usize| {
            !self.plan.iter().any(|(_, taken)| taken == slot)
                && !matches!(self.solver.slots[*slot].range, Range::Integer { .. })
        };
        let candidates: Vec<usize> = known.chain((1..base.len()).rev()).filter(free).take(CANDIDATES).collect();
        let before: Vec<Row> = rows.iter().copied().take_while(|other| *other != row).collect();
        let idle = self.idle(row, &candidates);
        for slot in candidates.into_iter().filter(|slot| !idle.contains(slot)) {
            let mut moved = base.clone();
            if self.put(&mut moved, (row, value), slot)?.is_none() {
                continue;
            }
            let values = self.solver.values(&self.state(&moved)?, &before).ok_or(NOT_SOLVED)?;
            if values.iter().all(|value| value.vanishes()) {
                self.plan.push((row, slot));
                *base = moved;
                return Ok(());
            }
        }
        Err(NOT_SOLVED.to_owned())
    }
}
