//! States at special places: zero, far larger or smaller than the rest, equal and opposite, at rest, parallel.

use crate::formula::SymbolId;

use crate::check::model::Model;
use crate::check::sample::sampler::contains;
use crate::check::state::numbers::Slot;

/// A special place: what is special about a state.
pub(crate) enum Place {
    /// A number multiplied by a factor.
    Times(usize, f64),
    /// A number at this value.
    At(usize, f64),
    /// A number equal to another one times this sign.
    Like(usize, usize, f64),
    /// Several numbers zero: a vector, or all members of a family.
    Zero(Vec<usize>),
    /// Several numbers equal to others times a factor: parallel vectors, or equal members.
    Follow(Vec<usize>, Vec<usize>, f64),
    /// Every rate zero.
    AtRest,
    /// Every rate zero, and every other number that may be zero.
    AllZero,
}

/// The special places of vectors and families: zero, with equal members, parallel to another one.
pub(crate) fn of_groups(model: &Model, slots: &[Slot]) -> Vec<Place> {
    let mut groups: Vec<(SymbolId, Vec<usize>)> = Vec::new();
    for (at, slot) in slots.iter().enumerate().filter(|(_, slot)| slot.one_of_many && slot.order == 0) {
        let Some(symbol) = slot.symbol else { continue };
        match groups.last_mut().filter(|(known, _)| *known == symbol) {
            Some((_, group)) => group.push(at),
            None => groups.push((symbol, vec![at])),
        }
    }
    let one = |symbol: SymbolId| model.symbols.entry(symbol).kind.numbers();
    let mut places = Vec::new();
    for (n, (symbol, group)) in groups.iter().enumerate() {
        let first = group[..one(*symbol)].to_vec();
        places.push(Place::Zero(group.clone()));
        places.push(Place::Follow(group.clone(), first.clone(), 1.0));
        // All vectors on one line, then all in one plane.
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
    /// Moves a base to the place.
    pub(crate) fn set(&self, base: &mut [f64], slots: &[Slot]) {
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
            Place::AtRest | Place::AllZero => {
                let all = matches!(self, Place::AllZero);
                for (slot, value) in slots.iter().zip(base) {
                    if slot.order > 0 || all && !slot.one_of_many && contains(&slot.range, 0.0) {
                        *value = 0.0;
                    }
                }
            }
        }
    }
}
