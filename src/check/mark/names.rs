//! The names of a problem, and what a name of a hand-in may stand for.

use std::collections::HashMap;

use crate::formula::symbols::Name;
use crate::formula::{Kind, SymbolId, Symbols};
use crate::latex::names;

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;

/// The names of the problem.
#[derive(Clone, Debug)]
pub(super) struct Names {
    /// Its symbols.
    pub symbols: Symbols,
    /// Its numbers, with what a name of a hand-in may stand for, and whether it is an angle.
    pub names: Vec<(Name, Role, bool)>,
    /// Those of them that do not change with time.
    pub fixed: Vec<Name>,
}

/// What changes with time in a problem.
pub(super) fn moving(model: &Model) -> Vec<SymbolId> {
    let changes = |id: &SymbolId| {
        matches!(
            model.meaning(*id),
            Some(Meaning::Coordinate(_) | Meaning::Varying(_) | Meaning::Time | Meaning::System(_))
        )
    };
    model.symbols.iter().map(|(id, _)| id).filter(changes).collect()
}

/// A name of the problem, or its rate, for which a name of a hand-in stands.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct StandsFor {
    /// The name.
    pub name: Name,
    /// The order of the rate: 0 for the name itself, 2 for its acceleration.
    pub dots: u8,
}

impl StandsFor {
    /// As LaTeX.
    pub fn latex(&self) -> String {
        match self.dots {
            0 => self.name.to_string(),
            1 => format!("\\dot{{{}}}", self.name),
            _ => format!("\\ddot{{{}}}", self.name),
        }
    }
}

/// What the names of a hand-in stand for.
pub(super) type Letters = HashMap<Name, StandsFor>;

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
            if entry.kind != Kind::Scalar || !entry.slots.is_empty() || entry.momentum && entry.name.base == "p" {
                continue;
            }
            let role = match model.meaning(id) {
                Some(Meaning::Coordinate(_) | Meaning::Varying(_)) => Role::Moving,
                Some(Meaning::Constant(_)) => Role::Constant,
                Some(Meaning::Defined(_) | Meaning::System(_)) => Role::Determined,
                _ => continue,
            };
            names.push((entry.name.clone(), role, entry.angle));
        }
        let moving = moving(model);
        let is_fixed = |name: &Name| {
            let Some((id, _)) = model.symbols.find(name) else { return false };
            !moving.contains(&id)
                && match model.meaning(id) {
                    Some(Meaning::Defined(formula)) => !model.depends_on(formula, &moving),
                    _ => true,
                }
        };
        let fixed = names.iter().map(|(name, ..)| name).filter(|name| is_fixed(name)).cloned().collect();
        Names { symbols: model.symbols.clone(), names, fixed }
    }

    /// The fixed values that have a letter with a number: ω_1 and ω_2 for ω. None, if the letter already has a subscript.
    pub fn numbered(&self, letter: &Name) -> Vec<&Name> {
        let is_number = |name: &Name| matches!(name.subscript.as_slice(), [number] if ["1", "2", "3", "+", "-"].contains(&number.as_str()));
        let is_it = |name: &&Name| {
            is_number(name) && Name { subscript: Vec::new(), ..(*name).clone() } == *letter && self.is_determined(name)
        };
        self.fixed.iter().filter(is_it).collect()
    }

    /// Whether a formula or the system gives a name.
    fn is_determined(&self, name: &Name) -> bool {
        self.names.iter().any(|(known, role, _)| known == name && *role == Role::Determined)
    }

    /// The names that are written for others, with the momenta of renamed coordinates.
    pub fn renamed(&self, letters: &Letters) -> HashMap<Name, Name> {
        let mut whole: HashMap<Name, Name> = letters
            .iter()
            .filter(|(_, other)| other.dots == 0)
            .map(|(own, other)| (own.clone(), other.name.clone()))
            .collect();
        for (own, other) in whole.clone() {
            let momentum = |of: &Name| names::parse(&format!("p_{{{of}}}")).map(|(name, _)| name);
            if let (Some(own), Some(other)) = (momentum(&own), momentum(&other))
                && self.symbols.find(&other).is_some()
            {
                whole.entry(own).or_insert(other);
            }
        }
        whole
    }
}
