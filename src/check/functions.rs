//! Sentences about the shape of a function: its sign, its minima, its limits, how many solutions an equation has.
//!
//! Here every symbol of the formula is an independent number (an *atom*): a momentum is a momentum, not what some state
//! gives it. Random atoms would miss what happens only where two momenta are equal and opposite, or only for a fast top, so
//! the special places are visited on purpose: like symbols equal and opposite, each at zero, angles at multiples of π/2,
//! each constant and each momentum far larger and far smaller than the rest.

use num_dual::{Dual, Dual64};

use crate::formula::{Environment, Expr, Moving, Relation, SymbolId, Symbols, Unavailable, Value, evaluate};
use crate::latex::typeset;
use crate::notes::claims::Range;
use crate::scalar::Measured;

use super::draw::{Draw, Reach, contains, last};
use super::ensemble::Condition;
use super::identity::Context;
use super::judge::{self, Link};
use super::limit::Towards;
use super::model::{Meaning, Model, is_angle};
use super::solves::{lowest, roots_on_the_grid};
use super::verdict::{Counterexample, Finding, Verdict};

/// What is said of a function.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Positive everywhere along the variable.
    Positive,
    /// Negative everywhere.
    Negative,
    /// Of both signs.
    ChangesSign,
    /// So many minima inside the range.
    Minima(usize),
    /// So many maxima inside the range.
    Maxima(usize),
    /// Rises everywhere.
    Rises,
    /// Falls everywhere.
    Falls,
    /// Does not change at all.
    Independent,
    /// Tends to a value (or diverges) as the variable approaches an end.
    TendsTo(f64, Target),
    /// As an equation set to zero, has so many real solutions for the variable.
    Solutions(usize),
}

/// What a function tends to.
#[derive(Clone, Debug)]
pub enum Target {
    /// It diverges.
    Infinite(Towards),
    /// The value of a formula.
    Finite(Box<Expr>),
}

/// A state's atoms.
type Atoms = Vec<(SymbolId, f64)>;

/// Moves a state to a special place.
type Place = Box<dyn Fn(&mut Atoms)>;

/// Atoms as plain numbers: nothing here moves.
struct Still<'a, D> {
    symbols: &'a Symbols,
    values: Vec<(SymbolId, D)>,
}

impl<D: Moving> Environment<D> for Still<'_, D> {
    fn symbols(&self) -> &Symbols {
        self.symbols
    }

    fn symbol(&self, id: SymbolId, _indices: &[u8]) -> Result<Value<D>, Unavailable> {
        let found = self.values.iter().find(|(known, _)| *known == id);
        found.map(|(_, value)| Value::Scalar(*value)).ok_or(Unavailable::Symbol(id))
    }
}

/// How many random states a sentence gets, besides the special ones.
const RANDOM: usize = 16;
/// How many draws each special place gets.
const SPECIAL: usize = 1;

/// Checks a sentence about `function`, as `variable` runs over its range, for all atoms that obey the hypotheses.
pub fn check(function: &Expr, variable: SymbolId, shape: &Shape, context: &Context<'_>) -> Finding {
    let model = context.model;
    let mut atoms: Vec<SymbolId> = Vec::new();
    let mut formulas = vec![function];
    formulas.extend(context.conditions.iter().flat_map(|c| [&c.lhs, &c.rhs]));
    if let Shape::TendsTo(_, Target::Finite(value)) = shape {
        formulas.push(value);
    }
    for (id, dots) in formulas.iter().flat_map(|formula| formula.symbols()) {
        if dots > 0 || matches!(model.meaning(id), Some(Meaning::World(quantity)) if !is_momentum(*quantity)) {
            let shown = crate::formula::text::with_dots(&model.name(id), dots);
            let message = format!("{shown} is not an independent number here: write it out");
            return context.finding(Verdict::Unreadable, message);
        }
        if !atoms.contains(&id) {
            atoms.push(id);
        }
    }
    if !function.symbols().iter().any(|(id, _)| *id == variable) && !matches!(shape, Shape::Independent) {
        return context.finding(Verdict::Undecided, format!("{} does not occur in it", model.name(variable)));
    }
    let range = model.range(variable);
    let (states, tried) = states(&atoms, variable, context);
    let mut points = 0;
    for atoms in &states {
        let probe = Probe { model, function, variable, atoms };
        match probe.look(shape, &range) {
            Look::Holds => points += 1,
            Look::Useless => {}
            Look::Fails { at, found, wanted, what } => {
                let mut state: Vec<(String, f64)> =
                    atoms.iter().filter(|(id, _)| *id != variable).map(|(id, x)| (model.name(*id), *x)).collect();
                state.extend(at.map(|x| (model.name(variable), x)));
                return Finding {
                    points: points + 1,
                    tried,
                    counterexample: Some(Counterexample { state, lhs: found, rhs: wanted, entry: None }),
                    ..context.finding(Verdict::Refuted, what)
                };
            }
        }
    }
    if points < super::identity::FEWEST.min(context.options.points) {
        let message = format!("only {points} of {tried} states obey the hypotheses and can tell");
        return Finding { points, tried, ..context.finding(Verdict::Undecided, message) };
    }
    let message = format!("holds at {points} states, the special places among them");
    Finding { points, tried, ..context.verified(message, "all values of a function") }
}

fn is_momentum(quantity: super::model::Quantity) -> bool {
    matches!(quantity, super::model::Quantity::Momentum(_))
}

/// Atoms that obey the hypotheses: random ones, and those at special places.
fn states(atoms: &[SymbolId], variable: SymbolId, context: &Context<'_>) -> (Vec<Atoms>, usize) {
    let model = context.model;
    let mut draw = Draw::new(context.options.seed, context.topic);
    let mut places: Vec<Place> = Vec::new();
    let is_constant = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Constant(_)));
    let free: Vec<SymbolId> = atoms.iter().copied().filter(|id| *id != variable).collect();
    for (k, &a) in free.iter().enumerate() {
        if is_angle(&model.range(a)) {
            for quarter in -4..=4 {
                let angle = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
                places.push(Box::new(move |state| set(state, a, |_| angle)));
            }
            continue;
        }
        places.push(Box::new(move |state| set(state, a, |_| 0.0)));
        for factor in [1e3, 30.0, 1.0 / 30.0, 1e-3] {
            places.push(Box::new(move |state| set(state, a, |x| x * factor)));
        }
        for &b in &free[..k] {
            let alike = model.symbols.entry(a).name.base == model.symbols.entry(b).name.base;
            if alike && !is_constant(a) && !is_constant(b) {
                for sign in [1.0, -1.0] {
                    places.push(Box::new(move |state| {
                        let value = state.iter().find(|(id, _)| *id == b).map_or(0.0, |(_, x)| *x);
                        set(state, a, |_| sign * value);
                    }));
                }
                places.push(Box::new(move |state| {
                    set(state, a, |_| 0.0);
                    set(state, b, |_| 0.0);
                }));
            }
        }
    }
    let nowhere: Place = Box::new(|_| {});
    let plan = std::iter::repeat_n(&nowhere, RANDOM).chain(places.iter().flat_map(|p| std::iter::repeat_n(p, SPECIAL)));
    let plan = plan.map(|place| (place, context.conditions.to_vec()));
    // A hypothesis that allows equality is also taken at its edge.
    let edges = context.conditions.iter().enumerate().filter_map(|(at, condition)| {
        let mut tight = context.conditions.to_vec();
        tight[at].relation = Relation::Equal;
        matches!(condition.relation, Relation::LessEqual | Relation::GreaterEqual).then_some((&nowhere, tight))
    });
    let (mut found, mut tried) = (Vec::new(), 0);
    for (place, conditions) in plan.chain(edges.flat_map(|edge| std::iter::repeat_n(edge, 4))) {
        // Where a hypothesis is an inequality, several draws may be needed to meet it.
        for _ in 0..12 {
            tried += 1;
            let mut state: Atoms =
                atoms.iter().map(|id| (*id, draw.value(&model.range(*id), Reach::Declared))).collect();
            place(&mut state);
            let in_range = |state: &Atoms| state.iter().all(|(id, x)| contains(&model.range(*id), *x));
            if obey(&mut state, variable, model, &conditions) && in_range(&state) {
                found.push(state);
                break;
            }
        }
    }
    (found, tried)
}

fn set(state: &mut Atoms, id: SymbolId, f: impl Fn(f64) -> f64) {
    for (known, value) in state.iter_mut() {
        if *known == id {
            *value = f(*value);
        }
    }
}

/// Moves a state onto the hypotheses that are equalities, and asks whether it obeys the others.
fn obey(state: &mut Atoms, variable: SymbolId, model: &Model, conditions: &[Condition]) -> bool {
    let is_equality = |c: &&Condition| matches!(c.relation, Relation::Equal | Relation::Identical);
    let candidates = |condition: &Condition| -> Vec<SymbolId> {
        let ids = condition.lhs.symbols().into_iter().chain(condition.rhs.symbols()).map(|(id, _)| id);
        let mut ids: Vec<SymbolId> = ids.filter(|id| *id != variable).collect();
        ids.sort_by_key(|id| matches!(model.meaning(*id), Some(Meaning::Constant(_))));
        ids.dedup();
        ids
    };
    let mut equalities: Vec<&Condition> = conditions.iter().filter(is_equality).collect();
    equalities.sort_by_key(|condition| candidates(condition).len());
    let mut taken = Vec::new();
    for condition in &equalities {
        let solved = candidates(condition).into_iter().filter(|id| !taken.contains(id)).find(|id| {
            let mut moved = state.clone();
            let works = newton(&mut moved, *id, condition, model);
            if works {
                *state = moved;
            }
            works
        });
        match solved {
            Some(id) => taken.push(id),
            None => return false,
        }
    }
    conditions.iter().all(|condition| {
        difference::<Measured>(state, condition, model, Measured::new)
            .is_some_and(|difference| judge::holds(condition.relation, difference))
    })
}

fn newton(state: &mut Atoms, id: SymbolId, condition: &Condition, model: &Model) -> bool {
    for _ in 0..40 {
        let at = state.iter().position(|(known, _)| *known == id);
        let seeded = |place: usize, x: f64| Dual64::new(x, if Some(place) == at { 1.0 } else { 0.0 });
        let mut place = 0;
        let value = difference::<Dual64>(state, condition, model, |x| {
            place += 1;
            seeded(place - 1, x)
        });
        let Some(value) = value.filter(|v| v.re.is_finite() && v.eps.is_finite()) else { return false };
        if value.re == 0.0 {
            return true;
        }
        if value.eps == 0.0 {
            return false;
        }
        let step = value.re / value.eps;
        set(state, id, |x| x - step);
        if step.abs() < 1e-16 {
            return true;
        }
    }
    difference::<Measured>(state, condition, model, Measured::new).is_some_and(judge::vanishes)
}

fn difference<D: Moving>(
    state: &Atoms,
    condition: &Condition,
    model: &Model,
    mut number: impl FnMut(f64) -> D,
) -> Option<D> {
    let values = state.iter().map(|(id, x)| (*id, number(*x))).collect();
    let still = Still { symbols: &model.symbols, values };
    Some(value_of(&condition.lhs, &still)? - value_of(&condition.rhs, &still)?)
}

fn value_of<D: Moving>(expr: &Expr, environment: &impl Environment<D>) -> Option<D> {
    match evaluate(expr, environment, &[]) {
        Ok(Value::Scalar(value)) => Some(value),
        _ => None,
    }
}

/// What a look at one state shows.
enum Look {
    Holds,
    Useless,
    Fails { at: Option<f64>, found: f64, wanted: f64, what: String },
}

/// A function of one variable, its other atoms fixed.
struct Probe<'a> {
    model: &'a Model,
    function: &'a Expr,
    variable: SymbolId,
    atoms: &'a Atoms,
}

impl Probe<'_> {
    /// Value and slope at a point; a number that rounding drowns is none.
    fn at(&self, x: f64) -> Option<(Measured, Measured)> {
        let atom = |(id, value): &(SymbolId, f64)| match *id == self.variable {
            true => (*id, Dual::new(Measured::new(x), Measured::new(1.0))),
            false => (*id, Dual::from_re(Measured::new(*value))),
        };
        let still = Still { symbols: &self.model.symbols, values: self.atoms.iter().map(atom).collect() };
        let value: Dual<Measured> = value_of(self.function, &still)?;
        (value.re.value.is_finite() && value.eps.value.is_finite()).then_some((value.re, value.eps))
    }

    /// The value alone; not a number where there is none.
    fn value(&self, x: f64) -> f64 {
        let atom = |(id, value): &(SymbolId, f64)| (*id, if *id == self.variable { x } else { *value });
        let still = Still { symbols: &self.model.symbols, values: self.atoms.iter().map(atom).collect() };
        value_of(self.function, &still).unwrap_or(f64::NAN)
    }

    fn look(&self, shape: &Shape, range: &Range) -> Look {
        let name = typeset_name(self.model, self.variable);
        match shape {
            Shape::Solutions(wanted) => {
                let found = roots_on_the_grid(range, |x| self.value(x));
                if found == *wanted {
                    return Look::Holds;
                }
                let what = format!("there are {found} real solutions for {name}, not {wanted}");
                Look::Fails { at: None, found: found as f64, wanted: *wanted as f64, what }
            }
            Shape::TendsTo(end, target) => self.tends(*end, target, range),
            _ => self.along(shape, range, &name),
        }
    }

    fn along(&self, shape: &Shape, range: &Range, name: &str) -> Look {
        let (mut minima, mut maxima, mut last_slope) = (0, 0, 0.0_f64);
        let (mut positive, mut negative, mut seen) = (false, false, 0);
        let mut signs: Vec<(f64, f64, f64, f64)> = Vec::new();
        let mut last_value = None;
        for x in grid(range) {
            let Some((value, slope)) = self.at(x) else { continue };
            seen += 1;
            let clear = |m: Measured| if judge::vanishes(m) { 0.0 } else { m.value.signum() };
            let (sign, slope_sign) = (clear(value), clear(slope));
            positive |= sign > 0.0;
            negative |= sign < 0.0;
            let fails = |found: f64, what: &str| Look::Fails { at: Some(x), found, wanted: 0.0, what: what.to_owned() };
            let step = last_value.map(|last: Measured| clear(value - last));
            last_value = Some(value);
            match shape {
                Shape::Rises if step.is_some_and(|step| step < 0.0) => return fails(value.value, "it falls to here"),
                Shape::Falls if step.is_some_and(|step| step > 0.0) => return fails(value.value, "it rises to here"),
                Shape::Positive if sign < 0.0 => return fails(value.value, "it is negative here"),
                Shape::Negative if sign > 0.0 => return fails(value.value, "it is positive here"),
                Shape::Rises if slope_sign < 0.0 => return fails(slope.value, "it falls here"),
                Shape::Falls if slope_sign > 0.0 => return fails(slope.value, "it rises here"),
                Shape::Independent if slope_sign != 0.0 => return fails(slope.value, "it changes here"),
                _ => {}
            }
            if sign != 0.0 {
                signs.push((x, sign * value.value, slope_sign * sign, sign));
            }
            if slope_sign != 0.0 {
                minima += usize::from(last_slope < 0.0 && slope_sign > 0.0);
                maxima += usize::from(last_slope > 0.0 && slope_sign < 0.0);
                last_slope = slope_sign;
            }
        }
        if seen == 0 {
            return Look::Useless;
        }
        if matches!(shape, Shape::Positive | Shape::Negative) {
            // Between two points where it falls towards zero and rises again it may reach zero.
            let dip = |pair: &&[(f64, f64, f64, f64)]| pair[0].3 == pair[1].3 && pair[0].2 < 0.0 && pair[1].2 > 0.0;
            for pair in signs.windows(2).filter(dip) {
                let (lowest, x) = lowest(pair[0].0, pair[1].0, |x| pair[0].3 * self.value(x));
                if lowest <= 1e-13 * pair[0].1.max(pair[1].1) {
                    let what = "it does not keep its sign here".to_owned();
                    return Look::Fails { at: Some(x), found: pair[0].3 * lowest, wanted: 0.0, what };
                }
            }
        }
        let count = |found: usize, wanted: usize, what: &str| {
            if found == wanted {
                return Look::Holds;
            }
            let what = format!("along {name} it has {found} {what}, not {wanted}");
            Look::Fails { at: None, found: found as f64, wanted: wanted as f64, what }
        };
        let fails = |what: String| Look::Fails { at: None, found: 0.0, wanted: 0.0, what };
        match shape {
            Shape::Minima(wanted) => count(minima, *wanted, "minima"),
            Shape::Maxima(wanted) => count(maxima, *wanted, "maxima"),
            Shape::ChangesSign if !positive => fails(format!("it is nowhere positive along {name}")),
            Shape::ChangesSign if !negative => fails(format!("it is nowhere negative along {name}")),
            Shape::Positive if !positive => fails(format!("it vanishes all along {name}")),
            Shape::Negative if !negative => fails(format!("it vanishes all along {name}")),
            Shape::Rises | Shape::Falls if last_slope == 0.0 => fails(format!("it does not change along {name}")),
            _ => Look::Holds,
        }
    }

    fn tends(&self, end: f64, target: &Target, range: &Range) -> Look {
        let sides: &[f64] = match range {
            Range::Interval { low, high, .. } if (end - low).abs() > 1e-9 && (end - high).abs() > 1e-9 => &[1.0, -1.0],
            Range::Interval { low, .. } if (end - low).abs() > 1e-9 => &[-1.0],
            Range::Interval { .. } | Range::Positive => &[1.0],
            Range::Negative => &[-1.0],
            _ => &[1.0, -1.0],
        };
        let mut look = Look::Useless;
        for inward in sides {
            look = self.tends_from(end, *inward, target);
            if !matches!(look, Look::Holds) {
                break;
            }
        }
        look
    }

    /// The same from one side.
    fn tends_from(&self, end: f64, inward: f64, target: &Target) -> Look {
        let wanted = match target {
            Target::Infinite(Towards::MinusInfinity) => f64::NEG_INFINITY,
            Target::Infinite(_) => f64::INFINITY,
            Target::Finite(formula) => {
                let still = Still { symbols: &self.model.symbols, values: self.atoms.clone() };
                match value_of(formula, &still) {
                    Some(value) => value,
                    None => return Look::Useless,
                }
            }
        };
        let steps: Vec<(f64, Measured)> = (2..=32)
            .filter_map(|k| {
                let x = end + inward * 0.5f64.powi(k);
                let (value, _) = self.at(x)?;
                (value.value.abs() > 1e-9 * value.magnitude || value.magnitude < 1e-7).then_some((x, value))
            })
            .collect();
        let [_, _, _, _, .., last] = steps.as_slice() else { return Look::Useless };
        let fails = |what: &str| Look::Fails { at: Some(last.0), found: last.1.value, wanted, what: what.to_owned() };
        if wanted.is_infinite() {
            // Each halving of the distance adds at least as much as the one before, if only a logarithm's share.
            let gains: Vec<f64> =
                steps.windows(2).map(|two| (two[1].1.value - two[0].1.value) * wanted.signum()).collect();
            let tail = &gains[gains.len().saturating_sub(4)..];
            let diverges = tail.iter().all(|gain| *gain > 0.0)
                && tail.windows(2).all(|two| two[1] > 0.95 * two[0])
                && last.1.value * wanted.signum() > 0.0;
            return if diverges { Look::Holds } else { fails("it does not diverge there") };
        }
        let errors: Vec<f64> = steps.iter().map(|(_, value)| (value.value - wanted).abs()).collect();
        let scale = wanted.abs().max(1e-3 * last.1.magnitude);
        let [.., a, b] = errors.as_slice() else { return Look::Useless };
        let approaches = *b <= 1e-9 * scale || b < &(0.95 * a) && *b < 0.05 * errors[0].max(scale);
        if approaches { Look::Holds } else { fails("it does not tend to this value") }
    }
}

fn typeset_name(model: &Model, id: SymbolId) -> String {
    let expr =
        Expr::new(crate::formula::Node::Symbol { id, indices: Vec::new(), dots: 0 }, crate::source::Span::default());
    crate::formula::text::plain(&typeset(&expr, &model.symbols))
}

/// Points along a range: evenly inside, and ever closer to its ends.
fn grid(range: &Range) -> Vec<f64> {
    let pi = std::f64::consts::PI;
    let near = |end: f64, inward: f64, width: f64| -> Vec<f64> {
        (0..24).map(|k| end + inward * width * 10f64.powf(-1.2 - f64::from(k) / 6.0)).collect()
    };
    let interval = |low: f64, high: f64| {
        let width = high - low;
        let inside = (1..64).map(|k| low + width * f64::from(k) / 64.0);
        let mut points: Vec<f64> = inside.chain(near(low, 1.0, width)).chain(near(high, -1.0, width)).collect();
        points.sort_by(f64::total_cmp);
        points
    };
    match range {
        Range::Interval { low, high, .. } => interval(*low, *high),
        Range::Angle => interval(-pi, pi),
        Range::Positive => decades(),
        Range::Negative => decades().into_iter().rev().map(|x| -x).collect(),
        Range::Any | Range::Rigid { .. } | Range::FixedDirection | Range::Labels { .. } => {
            let positive = decades();
            positive.iter().rev().map(|x| -x).chain(positive.iter().copied()).collect()
        }
        Range::Integer { low, high } => (*low..=last(high, *low)).map(|n| n as f64).collect(),
    }
}

/// Positive numbers of any order of magnitude that parameters can bring about.
fn decades() -> Vec<f64> {
    (-72..=72).map(|k| 10f64.powf(f64::from(k) / 6.0)).collect()
}

/// An equation as the function whose zeros solve it.
pub fn as_function(link: &Link) -> Expr {
    link.lhs.clone().minus(link.rhs.clone())
}
