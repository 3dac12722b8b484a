//! The value of every symbol in a sampled state, as a series in time: by its meaning, then by the rules of the
//! hypotheses.

use nalgebra::{Matrix3, Vector3};

use crate::Result;
use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::meaning::{FrameQuantity, Meaning};
use crate::check::state::particles::Particles;
use crate::check::state::sampled_state::SampledState;
use crate::check::state::values::{Valued, first};
use crate::formula::evaluate::{ALL, Body, Environment, Unavailable, evaluate};
use crate::formula::{Expr, IndexId, SymbolId, Symbols, Value};
use crate::mechanics::rotations;
use crate::notes::claims::Turning;
use crate::scalar::{Number, Primal, Series};

impl<'m, B: Number> SampledState<'m, B> {
    /// The k-th unit vector of the space axes.
    fn unit(&self, k: usize) -> Vector3<Series<B>> {
        Vector3::from_fn(|i, _| self.constant(if i == k { B::one() } else { B::zero() }))
    }

    /// A scalar or vector symbol, from its numbers in their order.
    fn numbers(&self, id: SymbolId, indices: &[u8], pick: &dyn Fn(usize) -> Option<Series<B>>) -> Valued<B> {
        let kind = self.model.symbols.entry(id).kind;
        let first = kind.numbers() * self.place_of(id, indices);
        Value::of_numbers(kind, &mut |at| pick(first + at)).ok_or(Unavailable::Symbol(id))
    }

    /// The value of a symbol by its meaning, before all rules, to this number of terms.
    pub(crate) fn raw(&self, id: SymbolId, indices: &[u8], terms: usize) -> Valued<B> {
        let none = || Unavailable::Symbol(id);
        let entry = self.model.symbols.entry(id);
        if let Some(member) = self.substitutes.member(id, indices, Value::clone) {
            return Ok(member);
        }
        let fixed = |numbers: &[B]| self.numbers(id, indices, &|at| numbers.get(at).map(|x| self.constant(*x)));
        match self.model.meaning(id).ok_or_else(none)? {
            Meaning::Coordinate(i) => Ok(Value::Scalar(self.coordinates()[*i])),
            Meaning::Constant(i) => fixed(self.base.constant(*i)),
            Meaning::Varying(i) => {
                let known = self.terms().min(terms);
                self.numbers(id, indices, &|at| self.base.varying(*i, at, known))
            }
            Meaning::Time => Ok(Value::Scalar(Series::time(self.base.time).truncated(self.terms()))),
            Meaning::System(quantity) => self.system.quantity(*quantity, indices).ok_or_else(none),
            Meaning::Defined(formula) => {
                let free: Vec<(IndexId, u8)> =
                    entry.slots.iter().map(|(_, letter)| *letter).zip(indices.iter().copied()).collect();
                self.substitutes.within(formula, self.model, || self.formula_to(terms, formula, &free))
            }
            Meaning::Rotation(..) => Err(none()),
            Meaning::FixedAxis(k) => Ok(Value::Vector(self.unit(*k))),
            Meaning::Frame(FrameQuantity::Angle) => self
                .base
                .frame_angles
                .first()
                .map(|angle| angle.truncated(self.terms()))
                .map(Value::Scalar)
                .ok_or_else(none),
            Meaning::Frame(FrameQuantity::AngularVelocity) => {
                Ok(Value::Vector(self.frame.angular_velocity(&self.base, terms).ok_or_else(none)?))
            }
            Meaning::Frame(FrameQuantity::Axes) => {
                let at = indices.first().map(|index| usize::from(*index) - 1).ok_or_else(none)?;
                Ok(Value::Vector(
                    self.frame.frame(&self.base, terms).ok_or_else(none)?.orientation().row(at).transpose(),
                ))
            }
            Meaning::Rigid(i) => {
                let Value::Vector(fixed) = fixed(self.base.rigid(*i))? else { return Err(none()) };
                let orientation = self
                    .frame
                    .frame(&self.base, terms)
                    .ok_or_else(none)?
                    .orientation()
                    .map(|entry| entry.truncated(terms));
                let turned = orientation.transpose() * fixed;
                match self.model.rigid[*i].about {
                    None => Ok(Value::Vector(turned)),
                    Some(about) => {
                        let sum = self.symbol_to(about, &[], terms)?.plus(Value::Vector(turned));
                        sum.ok_or(Unavailable::Operation(
                            "a sum of numbers and vectors, or of matrices of different sizes",
                        ))
                    }
                }
            }
            Meaning::Particles(quantity, label, masses, positions) => {
                self.of_particles(*quantity, (*label, masses, positions), (id, indices), terms)
            }
            Meaning::Region(at) => self.size_of_part(*at).map(Value::Scalar).ok_or_else(none),
            Meaning::Density(at) => self.density(*at).map(Value::Scalar).ok_or_else(none),
            Meaning::Point => self.point().map(Value::Vector).ok_or_else(none),
        }
    }

    /// The value of a symbol after all rules, at the instant.
    pub(crate) fn ruled_value(&self, id: SymbolId, indices: &[u8]) -> Result<Value<Primal<B>>, Unavailable> {
        let direct = if self.is_free(id) { self.drawn(id, indices, 0) } else { None };
        direct.map_or_else(|| Ok(first(&self.ruled(id, indices, self.rules.len(), 1)?)), Ok)
    }

    /// The matrix of an elementary rotation.
    pub(crate) fn turned<D: Number>(&self, id: SymbolId, angle: D) -> Result<Matrix3<D>, Unavailable> {
        match self.model.meaning(id) {
            Some(Meaning::Rotation(axis, Turning::Axes)) => Ok(rotations::passive_rotation(*axis, angle)),
            Some(Meaning::Rotation(axis, Turning::Vectors)) => Ok(rotations::active_rotation(*axis, angle)),
            _ => Err(Unavailable::Symbol(id)),
        }
    }

    /// Applies the rules that join families: their members replace those of the joined family.
    pub(crate) fn join(&self) -> Result<(), Unavailable> {
        let unions: Vec<&Rule> = self.rules.iter().filter(|rule| matches!(rule.action, Action::Union(_))).collect();
        if unions.is_empty() {
            return Ok(());
        }
        let mut members = Vec::new();
        let mut label = None;
        for rule in unions {
            let (Action::Union(parts), [letter]) = (&rule.action, rule.letters.as_slice()) else { continue };
            label = Some(*letter);
            let mut joined = Vec::new();
            for part in parts {
                for value in 1..=self.count(*letter)? {
                    joined.push(evaluate(part, self, &[(*letter, value)])?);
                }
            }
            members.push((rule.symbol, joined));
        }
        if let Some(label) = label {
            self.substitutes.join(Particles::joined(members, label));
            self.memo.forget();
        }
        Ok(())
    }
}

impl<B: Number> Environment<Series<B>> for SampledState<'_, B> {
    fn symbols(&self) -> &Symbols {
        &self.model.symbols
    }

    fn symbol(&self, id: SymbolId, indices: &[u8]) -> Valued<B> {
        self.symbol_to(id, indices, ALL)
    }

    fn symbol_to(&self, id: SymbolId, indices: &[u8], terms: usize) -> Valued<B> {
        let cut = |value: &mut Value<Series<B>>| value.for_each(|x| x.truncate(terms));
        let cut_clone = |value: &Value<Series<B>>| {
            let mut value = value.clone();
            cut(&mut value);
            Ok(value)
        };
        if let Some(value) = self.replaced(id) {
            return cut_clone(value);
        }
        let Some(key) = self.key(id, indices) else {
            let mut value = self.ruled(id, indices, self.rules.len(), terms);
            if let Ok(value) = &mut value {
                cut(value);
            }
            return value;
        };
        if terms == 1 {
            return self.kept_value(id, indices);
        }
        if let Some((_, value)) = self.memo.series.borrow().get(&key).filter(|(known, _)| *known >= terms) {
            return cut_clone(value);
        }
        let mut value = self.ruled(id, indices, self.rules.len(), terms);
        if let Ok(value) = &mut value {
            cut(value);
            self.memo.series.borrow_mut().insert(key, (terms, Box::new(value.clone())));
        }
        value
    }

    fn count(&self, index: IndexId) -> Result<u8, Unavailable> {
        let entry = &self.model.symbols.indices[index.0];
        if let Some(count) = self.substitutes.count(index, &self.model.symbols) {
            return Ok(count);
        }
        let Some(count) = entry.count else { return Ok(entry.upper) };
        match self.value(count)? {
            Value::Scalar(n) => Ok((n.0.re() as u8).clamp(1, entry.upper)),
            _ => Err(Unavailable::Symbol(count)),
        }
    }

    fn integral(&self, region: SymbolId, _integrand: Option<&Expr>, body: Body<'_, Series<B>>) -> Valued<B> {
        self.integrate(region, body, &|x| self.constant(x))
    }

    fn shrinking(&self, region: SymbolId, body: Body<'_, Series<B>>) -> Valued<B> {
        self.shrink(region, body)
    }

    fn count_within(&self, region: SymbolId) -> Result<u8, Unavailable> {
        let Some(Meaning::Region(at)) = self.model.meaning(region) else { return Err(Unavailable::Symbol(region)) };
        self.substitutes.count_within(*at).ok_or(Unavailable::Symbol(region))
    }

    fn rotation(&self, id: SymbolId, angle: Series<B>) -> Result<Matrix3<Series<B>>, Unavailable> {
        self.turned(id, angle)
    }
}
