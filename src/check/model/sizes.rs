//! Models whose families have another number of members.

use crate::formula::{SymbolId, Symbols};
use crate::notes::claims::{Count, Range};

use crate::check::model::Model;

/// The largest number of members of a family.
pub(crate) const MOST: u32 = 9;

/// The symbols that are numbers of members.
pub(crate) fn counts(model: &Model) -> Vec<SymbolId> {
    let mut counts: Vec<SymbolId> = model.symbols.indices.iter().filter_map(|index| index.count).collect();
    counts.sort_unstable();
    counts.dedup();
    counts
}

/// The same model, with families of `least` to `most` members.
pub(crate) fn resized(model: &Model, least: u32, most: u32) -> Model {
    let mut model = model.clone();
    let counts = counts(&model);
    let before = model.symbols.clone();
    for index in model.symbols.indices.iter_mut().filter(|index| index.count.is_some()) {
        index.upper = index.upper.max(most as u8);
    }
    let Model { symbols, constants, varying, rigid, .. } = &mut model;
    let members = |symbols: &Symbols, id| symbols.extents(id).into_iter().map(usize::from).product::<usize>();
    let numbers = constants.iter_mut().chain(varying).map(|variable| (variable.symbol, &mut variable.numbers));
    for (id, numbers) in numbers.chain(rigid.iter_mut().map(|rigid| (rigid.symbol, &mut rigid.members))) {
        *numbers = *numbers / members(&before, id).max(1) * members(symbols, id);
    }
    for constant in constants.iter_mut().filter(|constant| counts.contains(&constant.symbol)) {
        constant.range = Range::Integer { low: least.into(), high: Count::Number(most.into()) };
    }
    model
}
