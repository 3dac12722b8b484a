//! The states at which a claim is tested: drawn, and moved onto the claim's hypotheses.
//!
//! A hypothesis `A = B` is solved for one number of the base: one in which it is linear before others, higher derivatives
//! before velocities before coordinates before constants. *Assuming* it, it holds at the instant; *throughout*, its time
//! derivatives vanish too, each solved for a further number or found to vanish by itself. Inequalities select.

use std::sync::Arc;

use crate::formula::{Expr, IndexId, Kind, Relation, SymbolId};
use crate::notes::claims::Range;
use crate::scalar::Measured;
use crate::{Error, Result};

use super::base::Slot;
use super::draw::{Draw, Reach, contains};
use super::drawn::{Found, Wanted};
use super::identity::FEWEST;
use super::judge::Link;
use super::model::Model;
use super::rules::Rule;
use super::scene::{Mode, Scene};
use super::solver::Solver;

/// More states than these are seldom asked for.
const USUAL: usize = 128;

/// Where a few states are enough, so many bases are tried before hypotheses are given up that none could be moved onto.
const IN_HASTE: usize = 4;

/// A hypothesis of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Its left side.
    pub lhs: Expr,
    /// The relation.
    pub relation: Relation,
    /// Its right side.
    pub rhs: Expr,
    /// The free indices, for all of whose values it holds.
    pub free: Vec<IndexId>,
    /// Whether it holds at all times and not only at the instant.
    pub throughout: bool,
}

impl Condition {
    /// A link, taken for granted.
    pub fn of(link: Link, throughout: bool) -> Self {
        let Link { lhs, relation, rhs, free } = link;
        Condition { lhs, relation, rhs, free, throughout }
    }
}

/// What a claim takes for granted, and how its states are made.
#[derive(Clone, Debug)]
pub struct Setting<'c> {
    /// The hypotheses; on shell, the laws are added to them.
    pub conditions: &'c [Condition],
    /// What symbols mean in this claim only.
    pub local: &'c [Rule],
    /// On shell or off, and how many derivatives.
    pub mode: Mode,
    /// How far from the declared ranges to draw.
    pub reach: Reach,
}

/// States that obey a setting.
pub struct Ensemble<'m> {
    /// The states.
    pub scenes: Vec<Scene<'m, Measured>>,
    /// The base of each.
    pub bases: Vec<Vec<f64>>,
    /// How many were tried to get them.
    pub tried: usize,
    /// The mode they were made in.
    pub mode: Mode,
    /// What the hypotheses make of some symbols.
    pub rules: Arc<[Rule]>,
    /// How they were moved onto the hypotheses.
    pub solver: Solver<'m>,
}

impl<'m> Ensemble<'m> {
    /// Draws `points` states; there may be fewer where the hypotheses leave no room.
    ///
    /// # Errors
    /// When no state could be made because the mass matrix is singular at all of them.
    pub fn draw(model: &'m Model, setting: &Setting<'_>, points: usize, draw: &mut Draw) -> Result<Self> {
        let mode = setting.mode;
        let mut solver = Solver::new(model, setting);
        let (mut scenes, mut bases, mut tried) = (Vec::with_capacity(points.min(USUAL)), Vec::new(), 0);
        let mut failure: Option<Error> = None;
        let is_in_vain = |solver: &Solver<'_>, tried: usize| {
            solver.progress.hopeless || points < FEWEST && tried == IN_HASTE && solver.progress.is_stuck()
        };
        while scenes.len() < points && tried < 4 * points + 32 && !is_in_vain(&solver, tried) {
            tried += 1;
            let base = draw.base(&solver.slots, setting.reach);
            match solver.state(base) {
                Ok(Some((base, scene))) => {
                    scenes.push(scene);
                    bases.push(base);
                }
                Ok(None) => {}
                Err(error) => failure = Some(error),
            }
        }
        match failure {
            Some(error) if scenes.is_empty() => Err(error),
            _ => Ok(Ensemble { scenes, bases, tried, mode, rules: solver.rules.clone(), solver }),
        }
    }
}

impl<'m> Ensemble<'m> {
    /// The states that [`Ensemble::draw`] gives for a stream of this name. Where they have to be moved onto hypotheses,
    /// those that were found before are taken again.
    ///
    /// # Errors
    /// As there.
    pub fn named(model: &'m Model, setting: &Setting<'_>, points: usize, seed: u64, name: &str) -> Result<Self> {
        let draw = |draw: &mut Draw| Self::draw(model, setting, points, draw);
        Self::kept(model, setting, points, (seed, name), draw)
    }

    /// The states of this name that are kept, or else those that are found now. Where nothing has to be moved they are not
    /// kept.
    fn kept(
        model: &'m Model,
        setting: &Setting<'_>,
        points: usize,
        (seed, name): (u64, &str),
        find: impl FnOnce(&mut Draw) -> Result<Self>,
    ) -> Result<Self> {
        let mut solver = Solver::new(model, setting);
        let mut draw = Draw::new(seed, name);
        // What symbols mean in one claim only is not compared.
        if solver.equalities().next().is_none() || !setting.local.is_empty() {
            return find(&mut draw);
        }
        let Setting { mode, reach, .. } = *setting;
        let stream = (seed, name.to_owned());
        let wanted = Wanted { stream, mode, reach, points, conditions: setting.conditions.to_vec() };
        let Some(found) = model.drawn.find(&wanted) else {
            let ensemble = find(&mut draw)?;
            let Ensemble { bases, tried, solver, .. } = &ensemble;
            let found = Found { bases: bases.clone(), tried: *tried, progress: solver.progress.clone() };
            model.drawn.keep(wanted, found);
            return Ok(ensemble);
        };
        solver.progress = found.progress.clone();
        let scenes = found.bases.iter().map(|base| solver.measured(base)).collect::<Result<_>>()?;
        let (bases, tried) = (found.bases.clone(), found.tried);
        Ok(Ensemble { scenes, bases, tried, mode, rules: solver.rules.clone(), solver })
    }

    /// States at special places: each number of the base in turn far larger and far smaller than the rest, zero, of the
    /// other sign, at the ends of its range, equal and opposite to another; and at rest.
    ///
    /// # Errors
    /// When the mass matrix is singular at all of them.
    pub fn special(model: &'m Model, setting: &Setting<'_>, seed: u64, name: &str) -> Result<Self> {
        Self::kept(model, setting, 0, (seed, name), |draw| Self::at_special_places(model, setting, draw))
    }

    fn at_special_places(model: &'m Model, setting: &Setting<'_>, draw: &mut Draw) -> Result<Self> {
        let mode = setting.mode;
        let mut solver = Solver::new(model, setting);
        let (mut scenes, mut bases, mut tried) = (Vec::new(), Vec::new(), 0);
        let single: Vec<usize> = (1..solver.slots.len()).filter(|at| !solver.slots[*at].one_of_many).collect();
        let mut places: Vec<Place> = Vec::new();
        for &at in &single {
            places.extend([1e3, 1e-3, 0.0, -1.0].map(|factor| Place::Times(at, factor)));
            if let Range::Interval { low, high, .. } = solver.slots[at].range {
                places.extend([Place::At(at, low), Place::At(at, high)]);
            }
            let alike = |other: &&usize| solver.slots[**other].order == solver.slots[at].order && **other < at;
            for &other in single.iter().filter(alike) {
                places.extend([Place::Like(at, other, 1.0), Place::Like(at, other, -1.0)]);
            }
        }
        places.extend([Place::Rest, Place::Nothing]);
        places.extend(crowds(model, &solver.slots));
        for place in places {
            // Hypotheses may exclude a state that is drawn, and not the place.
            for _ in 0..8 {
                if solver.progress.hopeless {
                    break;
                }
                tried += 1;
                let mut base = draw.base(&solver.slots, setting.reach);
                place.set(&mut base, &solver.slots);
                if solver.slots.iter().zip(&base).all(|(slot, value)| contains(&slot.range, *value))
                    && let Ok(Some((base, scene))) = solver.state(base)
                {
                    scenes.push(scene);
                    bases.push(base);
                    break;
                }
            }
        }
        Ok(Ensemble { scenes, bases, tried, mode, rules: solver.rules.clone(), solver })
    }
}

/// What is special about a state.
enum Place {
    /// A number so many times what it was.
    Times(usize, f64),
    /// A number at this value.
    At(usize, f64),
    /// A number equal or opposite to another.
    Like(usize, usize, f64),
    /// Many numbers zero: a vector, or all members of a family.
    Zero(Vec<usize>),
    /// Many numbers so many times others, one after the other: vectors that are parallel, members that are alike.
    Follow(Vec<usize>, Vec<usize>, f64),
    /// Every rate zero.
    Rest,
    /// The same, and every other number that may be zero.
    Nothing,
}

/// Special places of vectors and families: each zero, its members alike, parallel to another.
fn crowds(model: &Model, slots: &[Slot]) -> Vec<Place> {
    let mut groups: Vec<(SymbolId, Vec<usize>)> = Vec::new();
    for (at, slot) in slots.iter().enumerate().filter(|(_, slot)| slot.one_of_many && slot.order == 0) {
        let Some(symbol) = slot.symbol else { continue };
        match groups.last_mut().filter(|(known, _)| *known == symbol) {
            Some((_, group)) => group.push(at),
            None => groups.push((symbol, vec![at])),
        }
    }
    let one = |symbol: SymbolId| if model.symbols.entry(symbol).kind == Kind::Vector { 3 } else { 1 };
    let mut places = Vec::new();
    for (n, (symbol, group)) in groups.iter().enumerate() {
        let first = group[..one(*symbol)].to_vec();
        places.push(Place::Zero(group.clone()));
        places.push(Place::Follow(group.clone(), first.clone(), 1.0));
        // All on one line, and all in one plane.
        if one(*symbol) == 3 {
            places.push(Place::Zero(
                group.iter().skip(1).step_by(3).chain(group.iter().skip(2).step_by(3)).copied().collect(),
            ));
            places.push(Place::Zero(group.iter().skip(2).step_by(3).copied().collect()));
        }
        for (other, source) in groups[..n].iter().filter(|(other, _)| one(*other) == one(*symbol)) {
            places
                .extend([2.0, -1.0].map(|factor| Place::Follow(group.clone(), source[..one(*other)].to_vec(), factor)));
            places.push(Place::Follow(group.clone(), source.clone(), 1.0));
        }
    }
    places
}

impl Place {
    fn set(&self, base: &mut [f64], slots: &[Slot]) {
        match self {
            Place::Times(at, factor) => base[*at] *= factor,
            Place::At(at, value) => base[*at] = *value,
            Place::Like(at, other, sign) => base[*at] = sign * base[*other],
            Place::Zero(all) => all.iter().for_each(|at| base[*at] = 0.0),
            Place::Follow(all, others, factor) => {
                for (at, other) in all.iter().zip(others.iter().cycle()) {
                    base[*at] = factor * base[*other];
                }
            }
            Place::Rest | Place::Nothing => {
                let all = matches!(self, Place::Nothing);
                for (slot, value) in slots.iter().zip(base) {
                    if slot.order > 0 || all && !slot.one_of_many && contains(&slot.range, 0.0) {
                        *value = 0.0;
                    }
                }
            }
        }
    }
}
