//! The value of a symbol at a state by the rules of hypotheses and laws.
//!
//! Rules apply one after the other, each to the value before it. An equation of motion is integrated as a series, order
//! by order, for all members of a family at once: the terms that are known give the next derivative.

use nalgebra::Vector3;

use crate::formula::evaluate::{ALL, Unavailable, evaluate};
use crate::formula::{Expr, IndexId, Kind, Sign, SymbolId, Value};
use crate::scalar::{Number, Series, dot};

use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::state::sampled_state::SampledState;
use crate::check::state::values::{MemberValues, Valued};

impl<B: Number> SampledState<'_, B> {
    /// The value of a symbol after the first `upto` rules, to this number of terms.
    pub(crate) fn ruled(&self, id: SymbolId, indices: &[u8], upto: usize, terms: usize) -> Valued<B> {
        let Some(at) = self.rules[..upto].iter().rposition(|rule| rule.symbol == id) else {
            return self.raw(id, indices, terms);
        };
        let rule = &self.rules[at];
        let before = || self.ruled(id, indices, at, terms);
        let letters: Vec<(IndexId, u8)> = rule.letters.iter().copied().zip(indices.iter().copied()).collect();
        let wrong = Unavailable::Operation("a sum of numbers and vectors, or of matrices of different sizes");
        let target = match &rule.action {
            Action::Equals(formula) => {
                let value = self.formula_to(terms, formula, &letters)?;
                match (self.model.symbols.entry(id).kind, value) {
                    (Kind::Vector, Value::Scalar(zero)) => Value::Vector(Vector3::from_element(zero)),
                    (_, value) => value,
                }
            }
            Action::Symmetric { permutation, sign } => {
                let permuted: Vec<u8> = permutation.iter().map(|at| indices[*at]).collect();
                let image = self.ruled(id, &permuted, at, terms)?;
                let image = if *sign == Sign::Minus { image.map(|x| -x) } else { image };
                before()?.plus(image).ok_or(wrong.clone())?.map(|x| x * 0.5)
            }
            Action::Parallel(along) => match (before()?, self.formula_to(terms, along, &letters)?) {
                (Value::Vector(v), Value::Vector(a)) => {
                    let square = dot(&a, &a);
                    match square.value().is_zero() {
                        true => Value::Vector(Vector3::zeros()),
                        false => Value::Vector(a * (dot(&v, &a) / square)),
                    }
                }
                _ => return Err(wrong),
            },
            Action::EquationOfMotion { order, formula } => {
                let place = self.place_of(id, indices);
                let member = self.follow(rule, usize::from(*order), formula, (at, place))?;
                return member.ok_or(Unavailable::Symbol(id));
            }
            Action::Coupled(laws) => return self.together(laws, id),
            // Joined families act through the particles that replace them.
            Action::Union(..) => return before(),
        };
        if rule.throughout || !self.model.symbols.entry(id).varies {
            return Ok(target);
        }
        // At the instant only: the value is the target's, the derivatives are those of the symbol.
        let own = before()?;
        let shift = target.plus(own.clone().map(|x| -x)).ok_or(wrong.clone())?;
        own.plus(shift.map(|x| Series::constant(x.value()))).ok_or(wrong)
    }

    /// A member, by its place, of a symbol with an equation of motion. All members are found together.
    fn follow(
        &self,
        rule: &Rule,
        order: usize,
        formula: &Expr,
        (at, place): (usize, usize),
    ) -> Result<Option<Value<Series<B>>>, Unavailable> {
        if let Some((_, partial)) = self.memo.following.borrow().iter().find(|(id, _)| *id == rule.symbol) {
            return Ok(partial.get(place).cloned());
        }
        if let Some(known) = self.memo.followed.borrow().get(&rule.symbol) {
            return Ok(known.get(place).cloned());
        }
        let members = self.every_member(rule.symbol)?;
        let mut known: MemberValues<B> = Vec::new();
        let mut terms = 0;
        for member in &members {
            let free = self.ruled(rule.symbol, member, at, ALL)?;
            terms = terms.max(free.entries().first().map_or(0, Series::known));
            known.push(free.map(|x| x.truncated(order)));
        }
        // Laws that contain each other are followed within one another. Terms that were found then are not sought again.
        if let Some(begun) = self.memo.begun.borrow().get(&rule.symbol) {
            known.clone_from(begun);
        }
        let wrong = || Unavailable::Operation("a sum of numbers and vectors, or of matrices of different sizes");
        let known_terms = |known: &MemberValues<B>| known_to(known).unwrap_or(order);
        let mut values: MemberValues<B> = Vec::new();
        for next in known_terms(&known)..terms {
            // Values that were found with fewer derivatives may have enough terms.
            let enough = |value: &Value<Series<B>>| value.entries().iter().all(|x| x.known() > next - order);
            if values.is_empty() || !values.iter().all(enough) {
                self.memo.following.borrow_mut().push((rule.symbol, known.clone()));
                self.memo.forget_values();
                let found: Result<MemberValues<B>, Unavailable> = members
                    .iter()
                    .map(|member| {
                        let letters: Vec<(IndexId, u8)> =
                            rule.letters.iter().copied().zip(member.iter().copied()).collect();
                        evaluate(formula, self, &letters)
                    })
                    .collect();
                self.memo.following.borrow_mut().pop();
                self.memo.forget_values();
                values = found?;
            }
            for (known, value) in known.iter_mut().zip(&values) {
                let (old, new) = (known.entries(), value.entries());
                let zero = Series::constant(B::zero());
                let mut entries = old.iter().enumerate().map(|(k, x)| {
                    let value = new.get(k).or(new.first()).unwrap_or(&zero);
                    let mut jet: Vec<B> = (0..next).filter_map(|n| x.nth_derivative_value(n)).collect();
                    jet.extend(value.nth_derivative_value(next - order));
                    Series::from_derivatives(&jet)
                });
                let mut take = || entries.next().ok_or_else(wrong);
                *known = match known {
                    Value::Scalar(_) => Value::Scalar(take()?),
                    Value::Vector(_) => Value::Vector(Vector3::new(take()?, take()?, take()?)),
                    Value::Matrix(_) | Value::Complex(_) => return Err(wrong()),
                };
            }
            // What the symbols that are followed around this one do not give yet, no further step gives.
            if known_to(&known).is_some_and(|terms| terms <= next) {
                break;
            }
        }
        let member = known.get(place).cloned();
        if self.memo.following.borrow().is_empty() {
            self.memo.followed.borrow_mut().insert(rule.symbol, known);
        } else if known_to(&known).is_some() {
            self.memo.begun.borrow_mut().insert(rule.symbol, known);
        }
        Ok(member)
    }

    /// The index values of every member of a family.
    fn every_member(&self, id: SymbolId) -> Result<Vec<Vec<u8>>, Unavailable> {
        let mut members = vec![Vec::new()];
        for (_, letter) in &self.model.symbols.entry(id).slots {
            // The largest number of members, so that the place of a member does not depend on the actual number.
            members = each_extended(&members, self.model.symbols.indices[letter.0].upper);
        }
        Ok(members)
    }
}

/// The number of terms to which all members are known; `None`, where it differs among them.
fn known_to<B: Number>(members: &MemberValues<B>) -> Option<usize> {
    let mut terms = members.iter().flat_map(Value::entries).map(|entry| entry.known());
    let first = terms.next()?;
    terms.all(|other| other == first).then_some(first)
}

/// Every list with every value up to `count` after it.
fn each_extended(members: &[Vec<u8>], count: u8) -> Vec<Vec<u8>> {
    members.iter().flat_map(|member| (1..=count).map(move |value| [member.as_slice(), &[value]].concat())).collect()
}
