//! Polynomial identity testing: whether a claim that passes by numbers is an identity, decided over a prime field.
//!
//! The claim, the equations of motion of the system and the claim's hypotheses are evaluated at random points of the
//! field ([`crate::scalar::prime_field`]). An identity vanishes at all of them. A difference vanishes by accident with a
//! probability that its degree bounds (Schwartz–Zippel). Points are added until that is at most 2⁻⁸⁰. Hypotheses are
//! solved exactly ([`super::solved`]). A claim with parts that have no meaning in a field stays open, with the reason.
//!
//! A certificate is only asked for after the claim has passed by numbers. Ranges, branches of roots and mutants are
//! tested there.
//!
//! # Why a prime field may decide
//!
//! Numbers agree to fourteen digits, and no number of them is a proof. A polynomial that is not zero vanishes at a
//! random point of a field of p elements with a probability of at most its degree divided by p (Schwartz and
//! Zippel). So a claim that holds in numbers is evaluated at random points of the field: the same formula,
//! Lagrangian and series. If the sides differ at one point, they differ; if at none, the claim is `certified`, and
//! the report has the bound, at most 2⁻⁸⁰.
//!
//! Numbers come first because they know ranges, domains and branches, of which a field has none: √x √y = √(xy) is
//! an identity there. The field sees what rounding hides: (1 + 10⁻¹⁶)x = x is refuted, without a state to show.
//! Such a refutation needs that nothing opaque was met: no free root, no sine of a product, no hypothesis that was
//! solved. A term that numbers do not see, such as 10⁻²⁰ in sin(x + 10⁻²⁰), makes the claim `undecided`. Inverse
//! functions, powers that are neither whole nor half, |x| of a number, orders, ≈, limits and integrals are outside;
//! each names itself in the report, and the claim stays `verified`.
//!
//! Hypotheses are solved exactly, each for a number in which it is linear: three values show that, two solve it.
//! The components of a vector that a rotation mixes are solved for together. On shell the accelerations are found
//! by Cramer's rule, so that the determinant is their one denominator. A whole number is taken at each of its
//! values, because it may be an exponent.

use crate::formula::{Expr, Node, SymbolId};
use crate::notes::claims::Range;
use crate::scalar::Modular;
use crate::scalar::prime_field::{FirstPrime, Modulus, SecondPrime, evaluate_at_point, false_accept_log2};

use crate::check::certificate::claim::{Certificate, Claim, Differences};
use crate::check::certificate::family_growth::GrowthAnalysis;
use crate::check::certificate::negligible_terms;
use crate::check::certificate::signs::is_never_zero;
use crate::check::certificate::solved::{OTHER_WAYS, Solved, SumHypotheses};
use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;
use crate::check::model::sizes;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::projection::Projection;
use crate::check::sample::sampler::{Sampler, last};
use crate::check::state::generic_body::{Generality, PRINCIPAL_AXES};

/// The base-2 logarithm of the largest probability of a false acceptance. An equation with a thousand parts stays below
/// 2⁻⁸⁰.
pub(crate) const FALSE_ACCEPT_LOG2: f64 = -90.0;

/// The least and the largest number of independent points.
const POINTS: std::ops::RangeInclusive<usize> = 2..=6;

/// The largest number of attempts to find a point at which no denominator vanishes and every root exists.
const ATTEMPTS: u32 = 64;

/// The reason for which a claim about families of any size stays open.
const HOW_IT_GROWS: &str = "sums over a family, because only some numbers of members were tried";

/// The largest number of integer values that are tried one after the other.
const WHOLES: usize = 32;

/// The largest number of square roots: all choices of their signs are tried.
const MOST_ROOTS: u32 = 5;

/// Decides a claim between two formulas, under the hypotheses by which an ensemble was drawn.
pub fn certify(link: &Link, context: &Context<'_>, ensemble: &Ensemble<'_>) -> Certificate {
    match decide(&[&link.lhs, &link.rhs], context, ensemble, link) {
        // The claim then rests on numbers only, so its small terms matter.
        open @ (Certificate::Open(_) | Certificate::LargeCoefficients) => {
            negligible_terms::inside(link, &ensemble.states).map_or(open, Certificate::NegligibleTerm)
        }
        decided => decided,
    }
}

/// Decides whether differences vanish, for families with any number of members.
pub(crate) fn decide(
    formulas: &[&Expr],
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    claim: &impl Claim,
) -> Certificate {
    if sizes::counts(context.model).is_empty() {
        return decide_by((&ensemble.projection, Some(&SumHypotheses::default())), formulas, context, ensemble, claim);
    }
    let mut growing = GrowthAnalysis::new(context.model, &ensemble.rules);
    let sums = growing.obeys(&ensemble.projection);
    let grows = growing.of_difference(formulas).filter(|growth| claim.free().is_some() || *growth == 0);
    let distinguished = growing.distinguished_members(formulas, claim.free().unwrap_or_default());
    let mut open = Certificate::Open(HOW_IT_GROWS.to_owned());
    // One member, or two, may be too few for a formula to have a value. Hypotheses that cannot be solved for few
    // members cannot be solved for more.
    let attempts: &[u32] = if ensemble.projection.equalities().next().is_none() { &[1, 3] } else { &[1] };
    for least in attempts.iter().copied() {
        let (Some(growth), least) = (grows, distinguished.max(least)) else { break };
        let most = least + growth;
        if most > sizes::MOST {
            break;
        }
        let model = sizes::resized(context.model, least, most);
        let context = Context { model: &model, ..*context };
        let projection = Projection::new(&model, &context.setting(ensemble.mode));
        match decide_by((&projection, sums.as_ref()), formulas, &context, ensemble, claim) {
            found @ (Certificate::Open(_) | Certificate::LargeCoefficients) => open = found,
            decided => return decided,
        }
    }
    open
}

/// Decides whether differences vanish. A second field is used if coefficients may be larger than the first prime: a
/// coefficient that vanishes modulo two primes is divisible by their product. `sums` are the hypotheses that are sums
/// over members; without it no hypothesis may be solved.
fn decide_by(
    (projection, sums): (&Projection<'_>, Option<&SumHypotheses>),
    formulas: &[&Expr],
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    claim: &impl Claim,
) -> Certificate {
    let sides = projection.hypotheses.iter().flat_map(|c| [&c.lhs, &c.rhs]).collect::<Vec<_>>();
    let generality = Generality::of(formulas, context.model, &projection.rules);
    let hypotheses = Generality::of(&sides, context.model, &projection.rules);
    let (Some(generality), Some(Generality::GivenParticles)) = (generality, hypotheses) else {
        return Certificate::Open(PRINCIPAL_AXES.to_owned());
    };
    let found = all_symbols(formulas, projection).and_then(|symbols| {
        integer_values(projection, &symbols)
            .ok_or_else(|| "integers that have too many values to try them all".to_owned())
    });
    let integer_values = match found {
        Ok(integer_values) => integer_values,
        Err(reason) => return Certificate::Open(reason),
    };
    let context = (context, generality, sums);
    let states = (projection, ensemble);
    let one = Modular::<FirstPrime>::most_bits();
    match decide_in::<FirstPrime>(&integer_values, context, states, claim, one) {
        Certificate::LargeCoefficients => {}
        decided => return decided,
    }
    let both = one + Modular::<SecondPrime>::most_bits();
    match decide_in::<FirstPrime>(&integer_values, context, states, claim, both) {
        Certificate::Identity(first) => match decide_in::<SecondPrime>(&integer_values, context, states, claim, both) {
            Certificate::Identity(second) => Certificate::Identity(first.max(second)),
            decided => decided,
        },
        decided => decided,
    }
}

/// Decides over one field; coefficients may have up to `most_bits` bits.
fn decide_in<F: Modulus>(
    integer_values: &[Vec<(usize, f64)>],
    (context, generality, sums): (&Context<'_>, Generality, Option<&SumHypotheses>),
    (projection, ensemble): (&Projection<'_>, &Ensemble<'_>),
    claim: &impl Claim,
    most_bits: f64,
) -> Certificate {
    let counts = sizes::counts(context.model);
    // The number of members, and whether sampled states have this number.
    let size = |whole: &[(usize, f64)]| {
        let counted = |(at, _): &&(usize, f64)| projection.slots[*at].symbol.is_some_and(|id| counts.contains(&id));
        whole.iter().find(counted).map(|(_, value)| *value as u32)
    };
    let was_drawn = |whole: &[(usize, f64)]| {
        let place =
            |at: usize| ensemble.projection.slots.iter().position(|slot| slot.symbol == projection.slots[at].symbol);
        ensemble.bases.iter().any(|base| whole.iter().all(|(at, x)| place(*at).is_some_and(|at| base[at] == *x)))
    };
    let mut draw = Sampler::new(context.options.seed, &format!("{}/{}/field", context.topic, ensemble.mode.on_shell));
    let (mut worst, least) = (f64::NEG_INFINITY, POINTS.start().div_ceil(integer_values.len()));
    for whole in integer_values {
        let found = match generality {
            // The hypotheses are about the particles and not about a generic body.
            Generality::AnyTensor => Err(PRINCIPAL_AXES.to_owned()),
            _ => match sums {
                None => Err(HOW_IT_GROWS.to_owned()),
                Some(sums) => Solved::<F>::new(projection, whole.clone(), draw.seed())
                    .and_then(|solved| if solved.moves(sums) { Ok(solved) } else { Err(HOW_IT_GROWS.to_owned()) }),
            },
        };
        let (solved, reason) = match found {
            Ok(solved) => (solved, (generality == Generality::AnyAxes).then(|| PRINCIPAL_AXES.to_owned())),
            // A claim that holds without its hypotheses holds with them.
            Err(reason) => (Solved::without_hypotheses(projection, whole.clone()), Some(reason)),
        };
        let solved = solved.with(generality);
        match (at_points(&solved, &mut draw, least, claim, most_bits), reason) {
            (Certificate::Identity(log2), _) => worst = worst.max(log2),
            (Certificate::LargeCoefficients, Some(_)) => return Certificate::LargeCoefficients,
            (_, Some(reason)) => return Certificate::Open(reason),
            (Certificate::Differs, None) if !was_drawn(whole) => {
                let open = || Certificate::Open("an integer value for which there is no sampled state".to_owned());
                let other = size(whole).filter(|_| whole.len() == counts.len());
                return other.map_or_else(open, Certificate::DiffersFor);
            }
            (other, None) => return other,
        }
    }
    Certificate::Identity(worst)
}

/// Decides at independent points: at least `least`, and as many as the bound needs.
fn at_points<F: Modulus>(
    solved: &Solved<'_, '_, F>,
    draw: &mut Sampler,
    least: usize,
    claim: &impl Claim,
    most_bits: f64,
) -> Certificate {
    let (mut log2, mut finest) = (0.0, 1);
    for points in 1..=*POINTS.end() {
        let differences = || solved.draw_state().and_then(|mut state| claim.differences(&mut state));
        match at_one_point(&differences, solved.is_free(), draw.seed(), &mut finest, most_bits) {
            Certificate::Identity(bound) => log2 += bound,
            other => return other,
        }
        if points >= least && log2 <= FALSE_ACCEPT_LOG2 {
            return Certificate::Identity(log2);
        }
    }
    Certificate::Open("polynomials of very high degree".to_owned())
}

/// All combinations of values of the integers in a base on which the claim depends; `None` if there are too many. Each
/// combination is decided separately.
fn integer_values(projection: &Projection<'_>, symbols: &[SymbolId]) -> Option<Vec<Vec<(usize, f64)>>> {
    let counts: Vec<SymbolId> = projection.model.symbols.indices.iter().filter_map(|index| index.count).collect();
    let mut all = vec![Vec::new()];
    for (at, slot) in projection.slots.iter().enumerate() {
        let Range::Integer { low, high } = &slot.range else { continue };
        if !slot.symbol.is_some_and(|symbol| counts.contains(&symbol) || symbols.contains(&symbol)) {
            continue;
        }
        let values = *low..=last(high, *low);
        if values.clone().count() * all.len() > WHOLES {
            return None;
        }
        let with = |known: &Vec<(usize, f64)>, value: i64| [known.as_slice(), &[(at, value as f64)]].concat();
        all = values.flat_map(|value| all.iter().map(move |known| with(known, value)).collect::<Vec<_>>()).collect();
    }
    Some(all).filter(|all| !all.is_empty())
}

/// The symbols on which a claim and its hypotheses depend, through all definitions.
///
/// # Errors
/// The reason why the claim cannot be decided over a field, as far as its formulas show it.
pub(crate) fn all_symbols(formulas: &[&Expr], projection: &Projection<'_>) -> Result<Vec<SymbolId>, String> {
    let model = projection.model;
    let of_hypotheses = projection.hypotheses.iter().flat_map(|c| [&c.lhs, &c.rhs]);
    let of_rules = projection.rules.iter().flat_map(|rule| rule.action.formulas());
    let divided_by_zero = |rule: &Rule| match &rule.action {
        Action::EquationOfMotion { formula: Expr { node: Node::Quotient(_, coefficient), .. }, .. } => {
            !is_never_zero(model, coefficient)
        }
        // The determinant of coupled laws may vanish.
        Action::Coupled(_) => true,
        _ => false,
    };
    if projection.rules.iter().any(divided_by_zero) {
        return Err("a law in which the coefficient of the highest derivative may be 0".to_owned());
    }
    let mut waiting: Vec<&Expr> = formulas.iter().copied().chain(of_hypotheses).chain(of_rules).collect();
    let (mut seen, mut reason): (Vec<SymbolId>, Option<&str>) = (Vec::new(), None);
    while let Some(formula) = waiting.pop() {
        let mut symbols = Vec::new();
        formula.walk(&mut |expr| match &expr.node {
            Node::Integral(..) | Node::Definite(_) => reason = reason.or(Some("an integral")),
            Node::Rest(_) => reason = reason.or(Some("a sum whose further terms are left out")),
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
                Some(Meaning::Particles(_, _, masses, positions)) => {
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
    reason.map_or(Ok(seen), |reason| Err(reason.to_owned()))
}

/// Decides whether differences vanish at one point, for all signs of square roots.
pub(crate) fn at_one_point<F: Modulus>(
    differences: &impl Fn() -> Differences<F>,
    is_free: bool,
    seed: u64,
    finest: &mut u64,
    most_bits: f64,
) -> Certificate {
    let (mut attempt, mut signs, mut log2) = (0, 0, f64::NEG_INFINITY);
    let mut nowhere = None;
    while attempt < ATTEMPTS {
        let point = seed.wrapping_add(u64::from(attempt));
        let ((result, vanish, bound), record) = evaluate_at_point::<F, _>(point, signs, *finest, || {
            let result = differences();
            let vanish = result.as_ref().is_ok_and(|all| all.iter().all(|difference| difference.vanishes()));
            let result: Differences<F> = result;
            (result.as_ref().err().cloned(), vanish, result.unwrap_or_default())
        });
        if let Some(fault) = record.unsupported {
            return Certificate::Open(fault.to_owned());
        }
        if record.finest > *finest || record.undefined_here.is_some() {
            attempt += u32::from(record.undefined_here.is_some());
            nowhere = record.undefined_here.or(nowhere);
            (*finest, signs, log2) = (record.finest, 0, f64::NEG_INFINITY);
            continue;
        }
        if let Some(reason) = result {
            return Certificate::Open(reason);
        }
        if !vanish {
            return match (record.opaque, is_free) {
                (false, true) => Certificate::Differs,
                (true, _) => Certificate::Open(
                    "a root, an exponential, a logarithm, or the sine of something other than a sum of angles"
                        .to_owned(),
                ),
                (false, false) => Certificate::Open(OTHER_WAYS.to_owned()),
            };
        }
        let Some(bound) = false_accept_log2(&bound, &record, ATTEMPTS, most_bits) else {
            return Certificate::LargeCoefficients;
        };
        log2 = log2.max(bound);
        signs += 1;
        if record.roots > MOST_ROOTS {
            return Certificate::Open(format!(
                "{} square roots, which have too many combinations of signs",
                record.roots
            ));
        }
        if signs >> record.roots == 1 {
            return Certificate::Identity(log2);
        }
    }
    Certificate::Open(nowhere.unwrap_or("fractions of angles").to_owned())
}
