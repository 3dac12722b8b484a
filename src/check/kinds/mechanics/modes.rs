//! Normal frequencies of several coordinates: the roots of det(K − ω²M) = 0.
//!
//! K and M are the second derivatives of −L and of L by the coordinates and by the velocities, where all of these are 0. Forces that
//! are linear in the velocities add iωG, with G = ∂²L/∂q̇∂r − ∂²L/∂ṙ∂q; of two coupled coordinates q and r they make the determinant
//! smaller by ω²G². Coordinates that nothing couples have determinants of their own. A name for one frequency is tested by its
//! formula, and no root can pass for another: two names with the same formula pass only if this root is a double one. A printed
//! secular equation is compared as a whole: its two sides must differ by a factor without ω from the determinant of all coordinates, or
//! of coordinates that nothing couples to the others. So it has all roots, and no others.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, SymbolId};
use crate::source::Span;

use super::expressions::{NO_LAGRANGIAN, NOT_ELEMENTARY, equal, lagrangian, partial, product, symbol};
use crate::check::certificate::formulas;
use crate::check::judge::identity;
use crate::check::model::PrintedLagrangian;
use crate::check::model::claim::Link;
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::sample::setting::FEWEST;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The most coordinates whose determinant is written out.
const MOST: usize = 4;

/// Why there is no frequency where the determinant of the masses is 0.
const MASSLESS: &str = "the determinant of M, the second derivatives of the Lagrangian by the velocities, is 0";

/// Checks that the square of a frequency, `square`, is that of a normal mode, and of another one than those in `others`, which are
/// the squares with their names.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn check(square: &Expr, others: &[(String, Expr)], context: &Context<'_>) -> Result<Finding> {
    let pencil = match Pencil::of(context)? {
        Ok(pencil) => pencil,
        Err(why) => return Ok(unsupported(why, context)),
    };
    if let Some(why) = obstacle(&pencil, context)? {
        return Ok(context.finding(Code::NotSupported, Verdict::Undecided, why));
    }
    let zero = Expr::integer(0, Span::default());
    let Some(determinant) = pencil.secular(square) else { return Ok(too_many_turn(context)) };
    let link = equal(&determinant, &zero);
    let context = &Context { on_shell: Some(false), ..*context };
    // Most texts that are tried in the place of a frequency fail at the first state.
    if !context.options.explain && fails(&link, context)? {
        return Ok(context.finding(Code::SidesDiffer, Verdict::Refuted, "this is not a normal frequency"));
    }
    let mut found = identity::check(&link, context)?;
    // A frequency exists where the place is stable, and is claimed there.
    if found.code == Code::DomainDiffers {
        let holds = context.verified("", "a root that is not real where the place is not stable");
        found = Finding { points: found.points, tried: found.tried, ..holds };
    }
    // In a case of two coordinates the determinant may vanish where the case holds, and nowhere else.
    if found.code == Code::RestatesHypothesis {
        let holds = context.verified("", "that a determinant is 0 in this case only");
        found = Finding { points: found.points, tried: found.tried, ..holds };
    }
    match found.verdict {
        // Without masses the determinant says nothing of a frequency.
        verdict if verdict.holds() && pencil.is_massless(context)? => return Ok(unsupported(MASSLESS, context)),
        verdict if verdict.holds() => {}
        Verdict::Refuted => {
            let message = "this is not a normal frequency: below, the left side is det(K − ω²M), which is not 0 there; K and M are the second \
                 derivatives of −L by the coordinates and of L by the velocities";
            return Ok(Finding { message: message.to_owned(), ..found });
        }
        _ => return Ok(found),
    }
    for (name, other) in others {
        let is_same = square == other || identity::check(&equal(square, other), &context.quick())?.verdict.holds();
        if is_same && !pencil.is_double(square, context)? {
            let message =
                format!("this is the same normal frequency as {name}, and det(K − ω²M) has no double root there");
            return Ok(context.finding(Code::SidesDiffer, Verdict::Refuted, message));
        }
    }
    Ok(Finding { message: "this is a normal frequency, because det(K − ω²M) = 0 for it".to_owned(), ..found })
}

/// Checks that an equation is the secular equation for a frequency.
///
/// # Errors
/// When no state can be drawn.
pub(crate) fn secular_equation(link: &Link, omega: SymbolId, context: &Context<'_>) -> Result<Finding> {
    let pencil = match Pencil::of(context)? {
        Ok(pencil) => pencil,
        Err(why) => return Ok(unsupported(why, context)),
    };
    if let Some(why) = obstacle(&pencil, context)? {
        return Ok(context.finding(Code::NotSupported, Verdict::Undecided, why));
    }
    let name = symbol(omega, 0);
    let Some(determinants) = pencil.determinants(&product(vec![name.clone(), name])) else {
        return Ok(too_many_turn(context));
    };
    let printed = link.lhs.clone().minus(link.rhs.clone());
    let context = &Context { on_shell: Some(false), ..*context };
    if pencil.entries().any(|entry| context.model.depends_on(entry, &[omega])) {
        return Ok(unsupported("the Lagrangian itself contains the frequency", context));
    }
    let is_hidden =
        printed.symbols().iter().any(|(id, _)| *id != omega && context.model.depends_on(&symbol(*id, 0), &[omega]));
    let does_not_fit = |message: &str| Ok(context.finding(Code::ClaimDoesNotFit, Verdict::Undecided, message));
    if is_hidden {
        return does_not_fit(
            "the definition of a name in this equation contains the frequency; write the frequency itself",
        );
    }
    if !context.model.depends_on(&printed, &[omega]) {
        return does_not_fit("this equation does not contain the frequency, so it cannot be the secular equation");
    }
    // Two functions are proportional if f(ω) g(1) = f(1) g(ω).
    let at_one = |of: &Expr| {
        let mut of = of.clone();
        of.substitute(&|part| match part {
            Node::Symbol { id, .. } if *id == omega => Some(Expr::integer(1, Span::default())),
            _ => None,
        });
        of
    };
    let is_proportional = |ours: &Expr| {
        let (printed_at_one, ours_at_one) = (at_one(&printed), at_one(ours));
        let link = equal(&product(vec![printed.clone(), ours_at_one]), &product(vec![ours.clone(), printed_at_one]));
        if !context.options.explain && fails(&link, context)? {
            return Ok(context.finding(Code::SidesDiffer, Verdict::Refuted, "this is not the secular equation"));
        }
        identity::check(&link, context)
    };
    let mut found = is_proportional(&product(determinants.clone()))?;
    if found.verdict == Verdict::Refuted && determinants.len() > 1 {
        for own in &determinants {
            let of_these = is_proportional(own)?;
            if of_these.verdict.holds() {
                found = of_these;
                break;
            }
        }
    }
    if found.verdict.holds() && is_zero(&printed, context)? {
        return does_not_fit("both sides are equal for every frequency, so this cannot be the secular equation");
    }
    let message = match found.verdict {
        verdict if verdict.holds() && pencil.is_massless(context)? => return Ok(unsupported(MASSLESS, context)),
        verdict if verdict.holds() => "this is the secular equation det(K − ω²M) = 0, up to a factor",
        Verdict::Refuted => {
            "this is not the secular equation: its sides do not differ by a multiple of det(K − ω²M), where K and M are the second \
             derivatives of −L by the coordinates and of L by the velocities"
        }
        _ => return Ok(found),
    };
    Ok(Finding { message: message.to_owned(), counterexample: None, ..found })
}

/// Whether a formula is 0 whatever its symbols are. Most are not, which one state shows.
fn is_zero(of: &Expr, context: &Context<'_>) -> Result<bool> {
    let link = equal(of, &Expr::integer(0, Span::default()));
    if of.is_zero() || formulas::is_identity(of, &link.rhs, context.model) {
        return Ok(true);
    }
    if fails(&link, context)? {
        return Ok(false);
    }
    Ok(of.is_zero() || identity::check(&link, &Context { on_shell: Some(false), ..context.quick() })?.verdict.holds())
}

/// Whether a link fails at one of a few states. They tell 0 from what is not 0, and every suggestion that is tried asks again.
fn fails(link: &Link, context: &Context<'_>) -> Result<bool> {
    let context = Context { on_shell: Some(false), ..context.quick() };
    let ensemble = context.ensemble(context.mode(false, &[&link.lhs, &link.rhs]), false, FEWEST)?;
    Ok(run(link, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_some()))
}

fn unsupported(why: &str, context: &Context<'_>) -> Finding {
    let message = format!("the normal frequencies were not derived, because {why}");
    context.finding(Code::NotSupported, Verdict::Undecided, message)
}

fn too_many_turn(context: &Context<'_>) -> Finding {
    let message = "forces that are linear in the velocities couple more than two coordinates; their frequencies are not supported";
    context.finding(Code::NotSupported, Verdict::Undecided, message)
}

/// Why det(K − ω²M) = 0 may not give the frequencies, if something speaks against it.
fn obstacle(pencil: &Pencil, context: &Context<'_>) -> Result<Option<&'static str>> {
    let model = context.model;
    let is_pushed = |printed: &PrintedLagrangian| !printed.forces.is_empty() || !printed.constraints.is_empty();
    if model.printed_lagrangian.as_ref().is_some_and(is_pushed) {
        return Ok(Some("there are forces or constraints beside the Lagrangian, which det(K − ω²M) does not contain"));
    }
    if pencil.entries().any(|entry| model.contains_time(entry)) {
        return Ok(Some("the Lagrangian depends on the time, so the motion has no normal frequencies"));
    }
    let Some(lagrangian) = lagrangian(context) else { return Ok(None) };
    let context = &Context { on_shell: Some(false), ..context.quick() };
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    for a in &coordinates {
        let Some(force) = partial(&lagrangian, *a, 0, context).map(|force| at_zero(force, &coordinates)) else {
            continue;
        };
        let is_driven = model.contains_time(&force);
        if !is_driven && !force.is_zero() && fails(&equal(&force, &Expr::integer(0, Span::default())), context)? {
            return Ok(Some(
                "the system does not stay at rest where all coordinates are 0; measure the coordinates from the place of rest",
            ));
        }
    }
    Ok(None)
}

/// A formula where all coordinates and velocities are 0.
fn at_zero(mut formula: Expr, coordinates: &[SymbolId]) -> Expr {
    formula.substitute(&|part| match part {
        Node::Symbol { id, .. } if coordinates.contains(id) => Some(Expr::integer(0, Span::default())),
        _ => None,
    });
    formula
}

/// A matrix of formulas, by rows.
type Rows = Vec<Vec<Expr>>;

/// K, M and G, and the coordinates that they couple.
struct Pencil {
    stiffness: Rows,
    masses: Rows,
    turning: Rows,
    /// The places of the coordinates that are coupled to each other.
    blocks: Vec<Vec<usize>>,
    /// Whether G is 0 in each of these.
    is_still: Vec<bool>,
}

impl Pencil {
    /// Those of the Lagrangian; else the reason why there are none.
    fn of(context: &Context<'_>) -> Result<std::result::Result<Pencil, &'static str>> {
        let coordinates: Vec<SymbolId> = context.model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
        let Some(lagrangian) = lagrangian(context) else { return Ok(Err(NO_LAGRANGIAN)) };
        if coordinates.len() > MOST {
            return Ok(Err("this is supported for at most four coordinates"));
        }
        let second = |a: (SymbolId, u8), b: (SymbolId, u8)| {
            let second = partial(&partial(&lagrangian, a.0, a.1, context)?, b.0, b.1, context)?;
            Some(at_zero(second, &coordinates))
        };
        let matrix = |entry: &dyn Fn(SymbolId, SymbolId) -> Option<Expr>| -> Option<Rows> {
            coordinates.iter().map(|a| coordinates.iter().map(|b| entry(*a, *b)).collect()).collect()
        };
        let turning = |a: SymbolId, b: SymbolId| {
            let (one, other) = (second((a, 1), (b, 0))?, second((b, 1), (a, 0))?);
            Some(if one == other { Expr::integer(0, Span::default()) } else { one.minus(other) })
        };
        let stiffness = matrix(&|a, b| second((a, 0), (b, 0)).map(Expr::negated));
        let all = (stiffness, matrix(&|a, b| second((a, 1), (b, 1))), matrix(&turning));
        let (Some(stiffness), Some(masses), Some(turning)) = all else { return Ok(Err(NOT_ELEMENTARY)) };
        let mut blocks: Vec<Vec<usize>> = Vec::new();
        for at in 0..coordinates.len() {
            let mut own = vec![at];
            for block in std::mem::take(&mut blocks) {
                let mut is_coupled = false;
                for other in &block {
                    let entries = [&stiffness[at][*other], &masses[at][*other], &turning[at][*other]];
                    for entry in entries {
                        is_coupled = is_coupled || !is_zero(entry, context)?;
                    }
                }
                match is_coupled {
                    true => own.splice(0..0, block).for_each(drop),
                    false => blocks.push(block),
                }
            }
            blocks.push(own);
        }
        let mut is_still = Vec::new();
        for block in &blocks {
            let mut still = true;
            for (a, b) in block.iter().flat_map(|a| block.iter().map(move |b| (*a, *b))).filter(|(a, b)| a < b) {
                still = still && is_zero(&turning[a][b], context)?;
            }
            is_still.push(still);
        }
        Ok(Ok(Pencil { stiffness, masses, turning, blocks, is_still }))
    }

    fn entries(&self) -> impl Iterator<Item = &Expr> {
        self.stiffness.iter().chain(&self.masses).chain(&self.turning).flatten()
    }

    /// det(K − λM + i√λ G) for each set of coupled coordinates; `None`, if G couples more than two.
    fn determinants(&self, lambda: &Expr) -> Option<Vec<Expr>> {
        let entry = |a: usize, b: usize| {
            let (k, m) = (&self.stiffness[a][b], &self.masses[a][b]);
            match m.is_zero() {
                true => k.clone(),
                false => k.clone().minus(product(vec![lambda.clone(), m.clone()])),
            }
        };
        let of = |(block, is_still): (&Vec<usize>, &bool)| match (block.as_slice(), is_still) {
            (block, true) => {
                let row = |a: &usize| block.iter().map(|b| entry(*a, *b)).collect();
                Some(determinant(&block.iter().map(row).collect::<Rows>()))
            }
            (&[a, b], false) => {
                let (mixed, turning) = (entry(a, b), &self.turning[a][b]);
                let squares = [
                    product(vec![mixed.clone(), mixed]),
                    product(vec![lambda.clone(), turning.clone(), turning.clone()]),
                ];
                Some(product(vec![entry(a, a), entry(b, b)]).minus(super::expressions::sum(squares.to_vec())))
            }
            _ => None,
        };
        self.blocks.iter().zip(&self.is_still).map(of).collect()
    }

    /// The determinant for all coordinates.
    fn secular(&self, lambda: &Expr) -> Option<Expr> {
        self.determinants(lambda).map(product)
    }

    /// Whether the masses give no frequency.
    fn is_massless(&self, context: &Context<'_>) -> Result<bool> {
        is_zero(&determinant(&self.masses), context)
    }

    /// Whether a root of the determinant is a double one: its derivative by λ is 0 too. That is the sum of the determinants with one
    /// row of −M in the place of that of K − λM. With forces that turn, no root is taken for a double one.
    fn is_double(&self, root: &Expr, context: &Context<'_>) -> Result<bool> {
        if self.is_still.contains(&false) {
            return Ok(false);
        }
        let (stiffness, masses) = (&self.stiffness, &self.masses);
        let entry = |k: &Expr, m: &Expr| k.clone().minus(product(vec![root.clone(), m.clone()]));
        let row = |at: usize| stiffness[at].iter().zip(&masses[at]).map(|(k, m)| entry(k, m)).collect::<Vec<_>>();
        let mut all = Vec::new();
        for replaced in 0..stiffness.len() {
            let rows = (0..stiffness.len()).map(|at| if at == replaced { masses[at].clone() } else { row(at) });
            all.push(determinant(&rows.collect::<Vec<_>>()));
        }
        is_zero(&super::expressions::sum(all), context)
    }
}

/// A determinant, written out by its first row.
fn determinant(matrix: &[Vec<Expr>]) -> Expr {
    let (Some(first), true) = (matrix.first(), matrix.len() > 1) else {
        return matrix.first().map_or(Expr::integer(1, Span::default()), |row| row[0].clone());
    };
    let mut whole: Option<Expr> = None;
    for (at, entry) in first.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
        let without = |row: &Vec<Expr>| {
            row.iter().enumerate().filter(|(column, _)| *column != at).map(|(_, entry)| entry.clone()).collect()
        };
        let rest: Vec<Vec<Expr>> = matrix[1..].iter().map(without).collect();
        let term = product(vec![entry.clone(), determinant(&rest)]);
        whole = Some(match (whole, at % 2 == 0) {
            (Some(whole), true) => whole.minus(term.negated()),
            (Some(whole), false) => whole.minus(term),
            (None, true) => term,
            (None, false) => term.negated(),
        });
    }
    whole.unwrap_or_else(|| Expr::integer(0, Span::default()))
}
