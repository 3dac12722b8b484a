//! Small oscillations about a place of rest, or about a motion in which only cyclic coordinates move, steadily.
//!
//! With the momenta p of the cyclic coordinates c fixed, the others move by the Routhian R = L − Σ p ċ. Its second derivatives are
//! R_xy = L_xy − L_xc (L_cc)⁻¹ L_cy, where x and y are coordinates or velocities and c stands for the cyclic velocities. So K = −R_qq,
//! M = R_q̇q̇ and the forces that turn, R_q̇r − R_ṙq, are formulas of the state, and no cyclic velocity need be solved for. They are
//! taken where the coordinates stay in their place: one coordinate has ω² = K/M, two have det(K − ω²M) − ω² G² = 0.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::source::Span;

use super::expressions::{NO_LAGRANGIAN, equal, lagrangian, partial, product, rate, sum, symbol};
use crate::check::judge::identity;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::sample::sampler::contains;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The most coordinates that oscillate.
const MOST: usize = 2;

/// The most cyclic coordinates.
const MOST_CYCLIC: usize = 4;

/// A coordinate, or with a dot its velocity.
type Argument = (SymbolId, u8);

/// Checks that `square` is the square of the frequency of small oscillations about a place; `what` names in messages what is printed, a
/// frequency or a period. The place gives the coordinates that are not
/// cyclic their values; those that it does not name are 0. The reason, where no such frequency is defined, or it is not supported.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn check(
    square: &Expr,
    what: &str,
    place: &[Hypothesis],
    context: &Context<'_>,
) -> Result<std::result::Result<Finding, &'static str>> {
    let model = context.model;
    let (Some(system), Some(lagrangian), Some(printed)) =
        (&model.system, lagrangian(context), &model.printed_lagrangian)
    else {
        return Ok(Err(NO_LAGRANGIAN));
    };
    let is_pushed = !printed.forces.is_empty() || printed.dissipation.is_some() || !printed.constraints.is_empty();
    if is_pushed || !system.multipliers().is_empty() {
        return Ok(Err("there are forces or constraints beside the Lagrangian"));
    }
    let all = || model.coordinates.iter().enumerate();
    let cyclic: Vec<Argument> =
        all().filter(|(at, _)| system.is_certainly_cyclic(*at)).map(|(_, q)| (q.symbol, 1)).collect();
    let own: Vec<SymbolId> = all().filter(|(at, _)| !system.is_certainly_cyclic(*at)).map(|(_, q)| q.symbol).collect();
    if own.is_empty() {
        return Ok(Err("the Lagrangian depends on no coordinate, so nothing oscillates"));
    }
    if own.len() > MOST {
        return Ok(Err("this is supported for at most two coordinates that the Lagrangian contains"));
    }
    if cyclic.len() > MOST_CYCLIC {
        return Ok(Err("this is supported for at most four cyclic coordinates"));
    }
    let entry = |x: Argument, y: Argument| -> Option<Expr> {
        let second = |x: Argument, y: Argument| partial(&partial(&lagrangian, x.0, x.1, context)?, y.0, y.1, context);
        reduced(x, y, &cyclic, &second)
    };
    let Some(link) = condition(square, &own, &entry, &|of| model.contains_time(of)) else {
        return Ok(Err(
            "the second derivatives of the Lagrangian cannot be written as formulas, or depend on the time",
        ));
    };
    let zero = Expr::integer(0, Span::default());
    let names = |hypothesis: &Hypothesis, q: SymbolId| {
        [&hypothesis.lhs, &hypothesis.rhs].into_iter().any(|side| side.symbols().iter().any(|(id, _)| *id == q))
    };
    let is_zero_outside = |q: &SymbolId| {
        let is_out = |known: &Variable| known.symbol == *q && !contains(&known.range, 0.0);
        model.coordinates.iter().any(is_out) && !place.iter().any(|hypothesis| names(hypothesis, *q))
    };
    if own.iter().any(is_zero_outside) {
        return Ok(Err("the claim gives no place for a coordinate whose range does not contain 0; write it, as in \
                       “frequency of small oscillations about x = a”"));
    }
    let unnamed = own.iter().filter(|q| !place.iter().any(|hypothesis| names(hypothesis, **q)));
    let unnamed: Vec<Hypothesis> = unnamed.map(|q| Hypothesis::of(equal(&symbol(*q, 0), &zero), true)).collect();
    let places =
        place.iter().chain(&unnamed).map(|known| Hypothesis { throughout: true, implied: true, ..known.clone() });
    let is_place = |known: &Hypothesis| own.iter().any(|q| names(known, *q));
    let others: Vec<Hypothesis> = context.hypotheses.iter().filter(|known| !is_place(known)).cloned().collect();
    let lasting: Vec<Hypothesis> = others.iter().cloned().chain(places).collect();
    // A place without a constant of its own is one of rest for all constants, or the states would choose some for which it is.
    let is_given = place.iter().flat_map(|known| known.lhs.symbols().into_iter().chain(known.rhs.symbols()));
    let has_constant = is_given.into_iter().any(|(id, _)| matches!(model.meaning(id), Some(Meaning::Constant(_))));
    if !has_constant && !rests(&own, &lasting, context)? {
        return Ok(Err("the system was not found to stay at rest in this place; write another place, as in \
                       “frequency of small oscillations about x = a”"));
    }
    let context = &Context { hypotheses: &lasting, on_shell: Some(true), ..*context };
    let mut found = identity::check(&link, context)?;
    if found.verdict == Verdict::Refuted
        && own.len() == 1
        && found.counterexample.as_ref().is_some_and(|shown| shown.rhs <= 0.0)
    {
        found = where_stable(&link, found, context)?;
    }
    let known = format!("this is the {what} of small oscillations: at this place the Lagrangian gives ω² = K/M");
    // A frequency exists where the place is stable, and is claimed there.
    if found.code == Code::DomainDiffers {
        let holds = context.verified(known, "a root that is not real where the place is not stable");
        return Ok(Ok(Finding { points: found.points, tried: found.tried, ..holds }));
    }
    // The derived side contains parts that are 0 or 1 in this place; a mutant of these says nothing of what is printed.
    if found.code == Code::MutantPasses {
        let holds = context.verified(known, "derivatives of the Lagrangian in a place that equations give");
        return Ok(Ok(Finding { points: found.points, tried: found.tried, ..holds }));
    }
    Ok(Ok(match found.verdict {
        verdict if verdict.holds() => Finding { message: known, ..found },
        Verdict::Refuted => Finding {
            message: format!(
                "this is not the {what} of small oscillations; below, the sides are the squares of the printed and of the derived \
                 frequency"
            ),
            ..found
        },
        _ => found,
    }))
}

/// The finding on ω² = K/M, which was refuted where K/M is negative, at states where the place is stable: only there is there a
/// frequency, and only there is one claimed. The same finding, where no such state is found.
fn where_stable(link: &Link, found: Finding, context: &Context<'_>) -> Result<Finding> {
    let zero = Expr::integer(0, Span::default());
    let (lhs, rhs) = (link.rhs.clone(), zero);
    let stable = Link { lhs, relation: Relation::Greater, rhs, free: Vec::new() };
    let hypotheses: Vec<Hypothesis> =
        context.hypotheses.iter().cloned().chain([Hypothesis::of(stable, false)]).collect();
    let there = identity::check(link, &Context { hypotheses: &hypotheses, ..*context })?;
    Ok(if there.verdict.holds() || there.verdict == Verdict::Refuted { there } else { found })
}

/// Whether the coordinates stay in their place, with the cyclic ones at rest, whatever the constants are.
fn rests(own: &[SymbolId], places: &[Hypothesis], context: &Context<'_>) -> Result<bool> {
    let zero = Expr::integer(0, Span::default());
    let at_instant = places.iter().map(|known| Hypothesis { throughout: false, ..known.clone() });
    let velocities =
        context.model.coordinates.iter().map(|q| Hypothesis::of(equal(&symbol(q.symbol, 1), &zero), false));
    let hypotheses: Vec<Hypothesis> = at_instant.chain(velocities).collect();
    let context = &Context { hypotheses: &hypotheses, on_shell: Some(true), ..context.quick() };
    for q in own {
        let link = equal(&symbol(*q, 2), &zero);
        let ensemble = context.ensemble(context.mode(true, &[&link.lhs]), false, 4)?;
        let rests = run(&link, &ensemble.states).is_ok_and(|found| found.failure.is_none() && found.points > 0);
        if !rests {
            return Ok(false);
        }
    }
    Ok(true)
}

/// L_xy − L_xc (L_cc)⁻¹ L_cy, by the elimination of one cyclic velocity after the other.
fn reduced(
    x: Argument,
    y: Argument,
    cyclic: &[Argument],
    second: &impl Fn(Argument, Argument) -> Option<Expr>,
) -> Option<Expr> {
    let Some((c, rest)) = cyclic.split_last() else { return second(x, y) };
    let whole = reduced(x, y, rest, second)?;
    let (left, right) = (reduced(x, *c, rest, second)?, reduced(*c, y, rest, second)?);
    Some(match left.is_zero() || right.is_zero() {
        true => whole,
        false => whole.minus(quotient(product(vec![left, right]), reduced(*c, *c, rest, second)?)),
    })
}

/// The equation that the square of the frequency meets.
fn condition(
    square: &Expr,
    own: &[SymbolId],
    entry: &impl Fn(Argument, Argument) -> Option<Expr>,
    contains_time: &impl Fn(&Expr) -> bool,
) -> Option<Link> {
    let at_rest = |of: &Expr| !contains_time(of);
    let stiffness = |q: SymbolId, r: SymbolId| entry((q, 0), (r, 0)).map(Expr::negated);
    let mass = |q: SymbolId, r: SymbolId| entry((q, 1), (r, 1)).filter(at_rest);
    Some(match *own {
        [q] => {
            // A term of a total derivative may contain the time in both; then K = d/dt L_q̇q − L_qq.
            let mixed = entry((q, 1), (q, 0))?;
            let stiffness = match contains_time(&mixed) {
                true => sum(vec![stiffness(q, q)?, rate(mixed)]),
                false => stiffness(q, q).filter(at_rest)?,
            };
            Link {
                lhs: square.clone(),
                relation: Relation::Equal,
                rhs: quotient(stiffness, mass(q, q)?),
                free: Vec::new(),
            }
        }
        [q, r] => {
            let at = |q: SymbolId, r: SymbolId| {
                Some(stiffness(q, r).filter(at_rest)?.minus(product(vec![square.clone(), mass(q, r)?])))
            };
            let turning = Some(entry((q, 1), (r, 0))?.minus(entry((r, 1), (q, 0))?)).filter(at_rest)?;
            let mixed = at(q, r)?;
            let others =
                sum(vec![product(vec![mixed.clone(), mixed]), product(vec![square.clone(), turning.clone(), turning])]);
            equal(&product(vec![at(q, q)?, at(r, r)?]), &others)
        }
        _ => return None,
    })
}

fn quotient(above: Expr, below: Expr) -> Expr {
    Expr::new(Node::Quotient(Box::new(above), Box::new(below)), Span::default())
}
