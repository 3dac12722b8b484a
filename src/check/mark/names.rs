//! The names of a problem, and what a name of a hand-in may stand for.

use std::collections::HashMap;

use crate::formula::symbols::Name;
use crate::formula::{Kind, Symbols};
use crate::latex::names;

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;

/// The names of the problem.
#[derive(Clone, Debug)]
pub(super) struct Names {
    /// Its symbols.
    pub symbols: Symbols,
    /// Its numbers, with what a name of a hand-in may stand for.
    pub names: Vec<(Name, Role)>,
}

/// What a name may stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A coordinate, or what varies freely.
    Moving,
    /// A constant.
    Constant,
    /// What a formula or the system gives.
    Determined,
}

impl Names {
    /// The names of a model.
    pub fn of(model: &Model) -> Names {
        let mut names = Vec::new();
        for (id, entry) in model.symbols.iter() {
            if entry.kind != Kind::Scalar || !entry.slots.is_empty() || entry.momentum {
                continue;
            }
            let role = match model.meaning(id) {
                Some(Meaning::Coordinate(_) | Meaning::Varying(_)) => Role::Moving,
                Some(Meaning::Constant(_)) => Role::Constant,
                Some(Meaning::Defined(_) | Meaning::System(_)) => Role::Determined,
                _ => continue,
            };
            names.push((entry.name.clone(), role));
        }
        Names { symbols: model.symbols.clone(), names }
    }

    /// A table with the momenta of renamed coordinates.
    pub fn with_momenta(&self, table: &HashMap<Name, Name>) -> HashMap<Name, Name> {
        let mut whole = table.clone();
        for (own, other) in table {
            let momentum = |of: &Name| names::parse(&format!("p_{{{of}}}")).map(|(name, _)| name);
            if let (Some(own), Some(other)) = (momentum(own), momentum(other))
                && self.symbols.find(&other).is_some()
            {
                whole.entry(own).or_insert(other);
            }
        }
        whole
    }
}
