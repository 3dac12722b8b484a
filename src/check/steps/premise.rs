//! Premises: models in which a step of a derivation holds as printed.
//!
//! A step follows from a false one if it holds in a model in which the false one holds. If the false step prints the
//! Lagrangian or one of the energies, that model has the system of the printed Lagrangian. Otherwise the false step is a law
//! in a model without a system, where all quantities that the system determines are arbitrary functions of time. A law that
//! constrains more than the derivatives in it may leave no states or a single one, and then anything would follow. Nothing
//! is concluded from such a law.
//!
//! # When a wrong line follows from another
//!
//! If it is true where that one is. So a model is made in which the premise is true: the system of the Lagrangian
//! that was printed, traced like any other, or no system and the line as a law. The later line is checked there
//! with everything that it failed. Since a contradiction implies everything, a law must leave the state as free as
//! before: the numbers that are changed are highest derivatives, or quantities that the system had determined, and
//! none has one value at two states. True lines are added to a false one only under the same condition. What is
//! found there is never a verdict: at worst a wrong line is explained by another wrong line.

use std::sync::Arc;

use crate::Result;
use crate::formula::{Expr, Kind, Relation, SymbolId, Value};
use crate::mechanics::System;
use crate::notes::claims::Range;
use crate::scalar::Symbol;

use crate::check::document::checker::Checker;
use crate::check::document::printed_lagrangian::symbolic_state;
use crate::check::hypotheses::explicit::rules;
use crate::check::model::claim::{Hypothesis, Law, is_equality};
use crate::check::model::meaning::{Meaning, Quantity, Variable};
use crate::check::model::order::{derivatives, order};
use crate::check::model::{Model, free_symbols};
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::setting::FEWEST;

/// The relative distance below which two values count as equal.
const ONE_VALUE: f64 = 1e-9;

/// A model in which a step holds as printed.
pub(crate) struct Premise {
    /// The model.
    pub model: Model,
    /// The symbols that the system determined, and that are free here.
    freed: Vec<SymbolId>,
}

impl Checker<'_> {
    /// The premise with the Lagrangian that a step prints, or with the energy that it prints; the other energy is that of the
    /// steps before, or else the true one. `None`, if it prints none of them in coordinates and velocities.
    pub(crate) fn printed_world(&self, earlier: &[usize], step: usize) -> Option<Premise> {
        let system = self.model.system.as_ref()?;
        let own = self.energies(step);
        let known = |wanted: Quantity| {
            let all = earlier.iter().filter(|at| **at != step).flat_map(|at| self.energies(*at)).chain(own.clone());
            all.filter(|(quantity, _)| *quantity == wanted).map(|(_, formula)| formula).next_back()
        };
        let is_own = |wanted: Quantity| own.iter().any(|(quantity, _)| *quantity == wanted);
        let energies = match is_own(Quantity::Lagrangian) {
            true => Energies::Lagrangian(known(Quantity::Lagrangian)?),
            false if !own.is_empty() && system.has_potential() => {
                Energies::Parts(known(Quantity::KineticEnergy), known(Quantity::PotentialEnergy))
            }
            false => return None,
        };
        let more: Vec<usize> = self
            .model
            .constants
            .iter()
            .enumerate()
            .filter(|(at, c)| c.numbers == 1 && !self.model.parameters.contains(at))
            .map(|(at, _)| at)
            .collect();
        let names = more.iter().map(|at| self.model.name(self.model.constants[*at].symbol)).collect();
        let places: Vec<usize> = self.model.parameters.iter().copied().chain(more).collect();
        let mut readable = true;
        let printed = system.with_lagrangian("as printed", names, |time, q, v, parameters| {
            let values = self.symbolic(time, (q, v), (&places, parameters), &energies);
            readable = values.is_some();
            values.unwrap_or((Symbol::from(f64::NAN), None))
        });
        let printed: Arc<System> = Arc::new(printed.ok().filter(|_| readable)?);
        let mut model = self.model.clone();
        (model.system, model.parameters) = (Some(printed), places);
        Some(Premise { model, freed: Vec::new() })
    }

    /// The energies that a display prints in coordinates and velocities, each by its last member.
    fn energies(&self, at: usize) -> Vec<(Quantity, Expr)> {
        let mut found = Vec::new();
        for statement in self.readings[at].statements.iter().flatten() {
            if !statement.relations.iter().all(|(relation, _)| is_equality(*relation)) {
                continue;
            }
            let energy = |member: &Expr| match self.model.meaning(member.as_plain_symbol()?)? {
                Meaning::System(
                    quantity @ (Quantity::Lagrangian | Quantity::KineticEnergy | Quantity::PotentialEnergy),
                ) => Some(*quantity),
                _ => None,
            };
            let printed = |member: &&Expr| self.model.is_plain(member) && derivatives(member, self.model) <= 1;
            let formula = statement.members.iter().rev().find(printed);
            found.extend(statement.members.iter().find_map(energy).zip(formula.cloned()));
        }
        found
    }

    /// L, and U if L = T − U, as symbolic values; `None`, if one of them is not a number made of coordinates and velocities.
    fn symbolic(
        &self,
        time: Symbol,
        (q, v): (&[Symbol], &[Symbol]),
        (places, parameters): (&[usize], &[Symbol]),
        energies: &Energies,
    ) -> Option<(Symbol, Option<Symbol>)> {
        let state = symbolic_state(self.model, time, (q, v), (places, parameters))?;
        let value = |formula: &Expr| match state.now(formula, &[]) {
            Ok(Value::Scalar(value)) => Some(value),
            _ => None,
        };
        match energies {
            Energies::Lagrangian(formula) => Some((value(formula)?, None)),
            Energies::Parts(kinetic, potential) => {
                let own = state.quantities()?;
                let printed = |formula: &Option<Expr>, own: Option<Symbol>| match formula {
                    Some(formula) => value(formula),
                    None => own,
                };
                let potential = printed(potential, own.potential.map(|u| u.value()))?;
                let kinetic = printed(kinetic, own.kinetic.map(|t| t.value()))?;
                Some((kinetic - potential, Some(potential)))
            }
        }
    }

    /// The model without the system and without laws. What these determined is an arbitrary function of time; with `names`, so
    /// are the numbers that a formula defines.
    pub(crate) fn without_system(&self, names: bool) -> Premise {
        let mut model = self.model.clone();
        (model.system, model.laws) = (None, Vec::new());
        model.parameters.clear();
        for coordinate in std::mem::take(&mut model.coordinates) {
            model.mean(coordinate.symbol, Meaning::Varying(model.varying.len()));
            model.varying.push(coordinate);
        }
        let mut freed = Vec::new();
        let determined = |(at, meaning): (usize, &Option<Meaning>)| {
            let is_determined =
                matches!(meaning, Some(Meaning::System(_))) || names && matches!(meaning, Some(Meaning::Defined(_)));
            let id = SymbolId(at);
            let entry = (is_determined && at < self.model.symbols.len()).then(|| self.model.symbols.entry(id))?;
            (entry.kind == Kind::Scalar && entry.slots.is_empty()).then_some(id)
        };
        for id in self.model.meanings.iter().enumerate().filter_map(determined) {
            model.mean(id, Meaning::Varying(model.varying.len()));
            model.varying.push(Variable::number(id, Range::Any));
            freed.push(id);
        }
        Premise { model, freed }
    }

    /// The model without a system in which the equalities that some steps print are laws; `names` as in
    /// [`Checker::without_system`]. `None`, if they print none, or if one is about vectors or families and is not an explicit
    /// formula of one of them.
    pub(crate) fn as_laws(&self, steps: &[usize], names: bool) -> Option<Premise> {
        let Premise { mut model, freed } = self.without_system(names);
        for step in steps {
            let mut hypotheses = Vec::new();
            for statement in self.readings[*step].statements.iter().flatten() {
                for (at, (relation, _)) in statement.relations.iter().enumerate() {
                    if !is_equality(*relation) {
                        return None;
                    }
                    let link = self.link(&statement.members[at], Relation::Equal, &statement.members[at + 1]).ok()?;
                    hypotheses.push(Hypothesis::of(link, true));
                }
            }
            let name = format!("({})", crate::check::document::names::shown(&self.notes.equations[*step]));
            model.laws.push(Law { name, printed: Vec::new(), hypotheses, units_off: false, derived: false });
        }
        if model.laws.iter().all(|law| law.hypotheses.is_empty()) {
            return None;
        }
        let all: Vec<Hypothesis> = model.laws.iter().flat_map(|law| law.hypotheses.iter().cloned()).collect();
        let (_, explicit) = rules(&model, &[], &all);
        let is_single = |symbol: SymbolId| {
            let entry = model.symbols.entry(symbol);
            entry.kind == Kind::Scalar && entry.slots.is_empty()
        };
        let is_solved = |hypothesis: &Hypothesis| {
            let sides = [&hypothesis.lhs, &hypothesis.rhs];
            sides.iter().all(|side| model.is_plain(side))
                && free_symbols::drawn(&sides, &model).into_iter().all(is_single)
        };
        let can_be_met = all.iter().zip(explicit).all(|(hypothesis, outright)| outright || is_solved(hypothesis));
        can_be_met.then_some(Premise { model, freed })
    }
}

/// The energies that make a Lagrangian.
enum Energies {
    /// L itself.
    Lagrangian(Expr),
    /// T and U, each as it is where it is not printed.
    Parts(Option<Expr>, Option<Expr>),
}

impl Premise {
    /// Whether the laws only determine symbols that the system determined, or the highest derivatives in them, so that the
    /// rest of the state is free. A single law may relate two coordinates.
    ///
    /// # Errors
    /// When states cannot be made.
    pub(crate) fn leaves_the_state_free(&self, ensemble: &Ensemble<'_>) -> Result<bool> {
        let laws: usize = self.model.laws.iter().map(|law| law.hypotheses.len()).sum();
        let projection = &ensemble.projection;
        if laws == 0 {
            return Ok(true);
        }
        if ensemble.states.len() < FEWEST {
            return Ok(false);
        }
        let first = projection.hypotheses.len() - laws;
        let is_free = |((hypothesis, derivative, _), slot): &((usize, usize, usize), usize)| {
            let (hypothesis, slot) = (&projection.hypotheses[*hypothesis], &projection.slots[*slot]);
            let Some(symbol) = slot.symbol.filter(|_| !slot.constant) else { return false };
            let highest =
                [&hypothesis.lhs, &hypothesis.rhs].into_iter().filter_map(|side| order(&self.model, side, symbol));
            let leads = highest.max().is_some_and(|highest| slot.order >= usize::from(highest) + derivative);
            leads && (laws == 1 || slot.order > 0 || self.freed.contains(&symbol))
        };
        // An unknown with the same value at two states is fixed by the laws.
        let varies = |((_, derivative, _), slot): &((usize, usize, usize), usize)| {
            let apart = |a: f64, b: f64| (a - b).abs() > ONE_VALUE * (1.0 + a.abs());
            let values: Vec<f64> = ensemble.bases.iter().map(|base| base[*slot]).collect();
            *derivative > 0 || values.iter().enumerate().all(|(n, a)| values[..n].iter().all(|b| apart(*a, *b)))
        };
        Ok(projection.record.plan.iter().filter(|(row, _)| row.0 >= first).all(|row| is_free(row) && varies(row)))
    }
}
