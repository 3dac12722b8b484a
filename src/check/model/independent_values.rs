//! The values of functions without a formula that a claim contains, against those that can be chosen freely.
//!
//! A polynomial with n coefficients takes any n values that are given with all lower derivatives at their places: this is Hermite's
//! interpolation, and in several variables a product of planes through the other places does the same. So a claim with at most n
//! of them that holds for every polynomial holds for every smooth function. One with more may hold for polynomials only, such as
//! that the ninth difference vanishes. Counting each place that is written differently, and each order that a time
//! derivative can reach, is at least the number there is.

use std::collections::HashSet;

use crate::formula::calculus::any_function;
use crate::formula::symbols::AnyFunction;
use crate::formula::{Expr, IndexId, Node, SymbolId, text};

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::model::order::derivatives;

/// The values of one function: its places, each with the lowest and the highest order of a derivative, and how often it counts.
struct Values<'m> {
    function: &'m AnyFunction,
    places: Vec<(Vec<Expr>, [u32; 2], u32)>,
}

struct Count<'m> {
    model: &'m Model,
    functions: Vec<Values<'m>>,
    /// The definitions that were looked into, with the number of derivatives taken of them.
    seen: HashSet<(SymbolId, u32)>,
    /// The letters of the sums around.
    summed: Vec<IndexId>,
    /// A function of which a part occurs whose place is not known.
    unclear: Option<&'m AnyFunction>,
}

/// Why a claim with these formulas cannot be decided for all smooth functions; `None` if it can. `premises` are the formulas that
/// it rests on; with `motion`, it rests on the equations of motion too.
pub(crate) fn too_many(model: &Model, claimed: &[&Expr], premises: &[&Expr], motion: bool) -> Option<String> {
    if !model.symbols.iter().any(|(_, entry)| entry.coefficient.is_some()) {
        return None;
    }
    let mut count = Count { model, functions: Vec::new(), seen: HashSet::new(), summed: Vec::new(), unclear: None };
    let most = claimed.iter().map(|formula| derivatives(formula, model)).max().unwrap_or(0) as u32;
    claimed.iter().for_each(|formula| count.of(formula, 0));
    premises.iter().for_each(|formula| count.of(formula, most));
    if motion {
        // The force is a derivative of the Lagrangian, and gives the accelerations.
        if let Some(printed) = &model.printed_lagrangian {
            let names = [Some(&printed.lagrangian), printed.potential.as_ref()].into_iter().flatten();
            for (id, _) in names.filter_map(|name| model.symbols.find(name)) {
                count.symbol(id, 1 + most.saturating_sub(2));
            }
            let others = printed.forces.iter().map(|(_, force)| force).chain(&printed.dissipation);
            let others = others.chain(printed.constraints.iter().map(|(_, constraint)| constraint));
            others.for_each(|formula| count.of(formula, 1 + most));
        }
        let laws = model.laws.iter().flat_map(|law| &law.hypotheses).chain(&model.constraints);
        laws.flat_map(|law| [&law.lhs, &law.rhs]).for_each(|formula| count.of(formula, most));
    }
    if let Some(function) = count.unclear {
        return Some(format!(
            "it is not clear which arguments the function {} has here, so this was not decided",
            shown(function)
        ));
    }
    count.functions.iter().find_map(Values::too_many)
}

fn shown(function: &AnyFunction) -> String {
    text::plain(&function.name.to_string())
}

impl Values<'_> {
    fn too_many(&self) -> Option<String> {
        let least = self.places.iter().map(|(_, [least, _], _)| *least).min().unwrap_or(0);
        // A function of one variable that occurs differentiated only is its derivative, of a lower degree.
        let is_single = self.function.terms.first().is_some_and(|(_, powers)| powers.len() == 1);
        let least = if is_single { least.min(self.function.degree) } else { 0 };
        let free = self.function.degree + 1 - least;
        let needed: u32 = self.places.iter().map(|(_, [_, most], times)| (most + 1 - least) * times).sum();
        (needed > free).then(|| {
            format!(
                "the function {} has {needed} independent values and derivatives here, and at most {free} can be \
                 tested; use it at fewer places",
                shown(self.function)
            )
        })
    }
}

impl<'m> Count<'m> {
    /// Counts the values in a formula that is differentiated by the time up to `more` times.
    fn of(&mut self, expr: &Expr, more: u32) {
        if let Some(value) = any_function::value_of(expr, &self.model.symbols) {
            let order: u32 = value.orders.iter().sum();
            value.arguments.iter().for_each(|argument| self.of(argument, more));
            self.value(value.function, value.arguments, [order, order + more]);
            return;
        }
        match &expr.node {
            Node::Symbol { id, dots, .. } => self.symbol(*id, more + u32::from(*dots)),
            Node::TimeDerivative(order, inner) => self.of(inner, more + u32::from(*order)),
            Node::SumOver { index, body, .. } => {
                self.summed.push(*index);
                self.of(body, more);
                self.summed.pop();
            }
            _ => expr.children().into_iter().for_each(|child| self.of(child, more)),
        }
    }

    fn symbol(&mut self, id: SymbolId, more: u32) {
        if !self.seen.insert((id, more)) {
            return;
        }
        let model = self.model;
        let entry = model.symbols.entry(id);
        if let Some(function) = &entry.coefficient {
            self.unclear = Some(function);
        }
        match (model.meaning(id), &entry.definition) {
            (Some(Meaning::Defined(formula)), _) => self.of(formula, more),
            (Some(Meaning::Particles(_, _, masses, positions)), _) => {
                self.of(masses, more);
                self.of(positions, more);
            }
            (_, Some(formula)) => self.of(formula, more),
            _ => entry.members.iter().for_each(|member| self.symbol(*member, more)),
        }
    }

    fn value(&mut self, function: &'m AnyFunction, place: Vec<Expr>, [least, most]: [u32; 2]) {
        let letter = |letter: &&IndexId| place.iter().any(|argument| argument.has_letter(**letter));
        let sizes =
            self.summed.iter().filter(letter).map(|letter| u32::from(self.model.symbols.indices[letter.0].upper));
        let times = sizes.fold(1, u32::saturating_mul);
        let at = match self.functions.iter().position(|values| values.function == function) {
            Some(at) => at,
            None => {
                self.functions.push(Values { function, places: Vec::new() });
                self.functions.len() - 1
            }
        };
        let places = &mut self.functions[at].places;
        match places.iter_mut().find(|(known, ..)| *known == place) {
            Some((_, orders, known)) => {
                *orders = [orders[0].min(least), orders[1].max(most)];
                *known = times.max(*known);
            }
            None => places.push((place, [least, most], times)),
        }
    }
}
