//! The values of formulas at the instant of a state, without their derivatives.
//!
//! A state gives everything as a series in time, but most claims are about values only. So a formula is evaluated over
//! numbers with one coefficient ([`Primal`]). Series are evaluated only under a dot or d/dt.

use nalgebra::Vector3;
use num_traits::{One, Zero};

use crate::formula::evaluate::{Body, Environment, Unavailable, differentiate, evaluate_to};
use crate::formula::tree::Definite;
use crate::formula::{Expr, IndexId, SymbolId, Symbols, Value};
use crate::scalar::{Number, Primal, Series};

use crate::check::model::meaning::{FrameQuantity, Meaning};
use crate::check::state::sampled_state::SampledState;
use crate::check::state::values::{first, lifted};

/// A value, or why there is none.
type Valued<B> = Result<Value<Primal<B>>, Unavailable>;

/// A state as an environment that gives values only.
struct Now<'s, 'm, B: Number>(&'s SampledState<'m, B>);

impl<B: Number> SampledState<'_, B> {
    /// The value of a formula whose free indices have these values.
    ///
    /// # Errors
    /// If a symbol in it has no value.
    pub fn now(&self, formula: &Expr, indices: &[(IndexId, u8)]) -> Result<Value<B>, Unavailable> {
        Ok(self.instant(formula, indices)?.each(|x| x.0))
    }

    /// The value of a formula, as a number with one coefficient.
    pub(crate) fn instant(&self, formula: &Expr, indices: &[(IndexId, u8)]) -> Valued<B> {
        evaluate_to(1, formula, &Now(self), indices)
    }

    /// The value of a formula as a series to this number of terms.
    pub(crate) fn formula_to(
        &self,
        terms: usize,
        formula: &Expr,
        indices: &[(IndexId, u8)],
    ) -> Result<Value<Series<B>>, Unavailable> {
        match terms {
            1 => Ok(lifted(&self.instant(formula, indices)?)),
            terms => evaluate_to(terms, formula, self, indices),
        }
    }

    /// The value of a cached symbol, as a series with one term.
    pub(crate) fn kept_value(&self, id: SymbolId, indices: &[u8]) -> Result<Value<Series<B>>, Unavailable> {
        Ok(lifted(&Now(self).symbol_to(id, indices, 1)?))
    }

    /// The value of a symbol without indices.
    pub(crate) fn value(&self, id: SymbolId) -> Valued<B> {
        Now(self).symbol(id, &[])
    }

    /// The derivative of a symbol, of any order, by its meaning or by the particle that replaces it; `None` if series
    /// are needed.
    pub(crate) fn drawn(&self, id: SymbolId, indices: &[u8], order: u8) -> Option<Value<Primal<B>>> {
        let model = self.model();
        let order = usize::from(order);
        if let Some(member) = self.substitutes.member(id, indices, |value| (order == 0).then(|| first(value))) {
            return member;
        }
        let place = || self.place_of(id, indices);
        let numbers = |pick: &dyn Fn(usize) -> Option<B>| {
            let kind = model.symbols.entry(id).kind;
            let first = kind.numbers() * place();
            Value::of_numbers(kind, &mut |at| pick(first + at).map(Primal))
        };
        match model.meaning(id)? {
            Meaning::Coordinate(i) => Some(Value::Scalar(Primal(self.coordinates().get(*i)?.rate(order)?))),
            Meaning::Constant(i) if order == 0 => numbers(&|at| self.base.constant(*i).get(at).copied()),
            Meaning::Varying(i) if order < self.terms() => numbers(&|at| self.base.rate(*i, at, order)),
            Meaning::System(quantity) if order == 0 => self.system.value(*quantity, indices),
            Meaning::Defined(formula) if order == 0 && self.substitutes.is_empty() => {
                let letters = model.symbols.entry(id).slots.iter().map(|(_, letter)| *letter);
                let free: Vec<(IndexId, u8)> = letters.zip(indices.iter().copied()).collect();
                self.instant(formula, &free).ok()
            }
            Meaning::FixedAxis(k) if order == 0 => {
                Some(Value::Vector(Vector3::from_fn(|i, _| if i == *k { Primal::one() } else { Primal::zero() })))
            }
            Meaning::Frame(FrameQuantity::Axes) if order == 0 => {
                Some(Value::Vector(self.frame.axes(&self.base, 0)?.row(usize::from(*indices.first()?) - 1).transpose()))
            }
            Meaning::Frame(FrameQuantity::AngularVelocity) if order == 0 => {
                Some(Value::Vector(self.frame.angular_velocity_now(&self.base)?))
            }
            Meaning::Rigid(i) => {
                let Value::Vector(fixed) = numbers(&|at| self.base.rigid(*i).get(at).copied())? else { return None };
                let turned = self.frame.axes(&self.base, order)?.transpose() * fixed;
                let moved = match model.rigid[*i].about {
                    None => turned,
                    Some(about) => self.about(about, order)? + turned,
                };
                Some(Value::Vector(moved.map(|x| Primal(Series::rate_of(x.0, order)))))
            }
            Meaning::Density(at) if order == 0 => Some(Value::Scalar(Primal(self.density(*at)?.value()))),
            Meaning::Point if order == 0 => Some(Value::Vector(self.point()?.map(|x| Primal(x.value())))),
            _ => None,
        }
    }
}

impl<B: Number> SampledState<'_, B> {
    /// The series coefficients, of one order, of the point about which a body turns.
    fn about(&self, point: SymbolId, order: usize) -> Option<Vector3<Primal<B>>> {
        let Value::Vector(series) = self.symbol_to(point, &[], order + 1).ok()? else { return None };
        let of = |x: &Series<B>| x.coefficient(order).map(Primal);
        Some(Vector3::new(of(&series.x)?, of(&series.y)?, of(&series.z)?))
    }
}

impl<B: Number> Now<'_, '_, B> {
    /// A derivative from the series of the symbol.
    fn by_series(&self, id: SymbolId, indices: &[u8], order: u8) -> Valued<B> {
        let mut value = self.0.symbol_to(id, indices, 1 + usize::from(order))?;
        differentiate(&mut value, order)?;
        Ok(first(&value))
    }

    fn derived(&self, id: SymbolId, indices: &[u8], order: u8) -> Valued<B> {
        let direct = if self.0.is_free(id) { self.0.drawn(id, indices, order) } else { None };
        direct.map_or_else(|| self.by_series(id, indices, order), Ok)
    }
}

impl<B: Number> Environment<Primal<B>> for Now<'_, '_, B> {
    fn symbols(&self) -> &Symbols {
        self.0.symbols()
    }

    fn symbol(&self, id: SymbolId, indices: &[u8]) -> Valued<B> {
        match self.0.key(id, indices) {
            None => self.derived(id, indices, 0),
            Some(key) => self.0.memo.remember(key, || self.0.ruled_value(id, indices)),
        }
    }

    fn rate_to(&self, id: SymbolId, indices: &[u8], order: u8, _terms: usize) -> Valued<B> {
        self.derived(id, indices, order)
    }

    fn derivative(&self, order: u8, formula: &Expr, indices: &[(IndexId, u8)]) -> Option<Valued<B>> {
        let value = evaluate_to(1 + usize::from(order), formula, self.0, indices);
        Some(value.and_then(|mut value| {
            differentiate(&mut value, order)?;
            Ok(first(&value))
        }))
    }

    fn count(&self, index: IndexId) -> Result<u8, Unavailable> {
        self.0.count(index)
    }

    /// An integral that is not inside another one has one value at a state, which is cached.
    fn integral(&self, region: SymbolId, integrand: Option<&Expr>, body: Body<'_, Primal<B>>) -> Valued<B> {
        let state = self.0;
        let Some(integrand) = integrand.filter(|_| state.is_nowhere()) else {
            return state.integrate(region, body, &Primal);
        };
        let is_it = |(at, of, _): &&(SymbolId, Expr, Value<Primal<B>>)| *at == region && of == integrand;
        if let Some((.., value)) = state.memo.integrals.borrow().iter().find(is_it) {
            return Ok(value.clone());
        }
        let value = state.integrate(region, body, &Primal)?;
        state.memo.integrals.borrow_mut().push((region, integrand.clone(), value.clone()));
        Ok(value)
    }

    fn quadrature(&self, of: &Definite, is_closed: bool, body: Body<'_, Primal<B>>) -> Valued<B> {
        let state = self.0;
        if !is_closed || !state.is_nowhere() {
            return body();
        }
        if let Some((_, value)) = state.memo.quadratures.borrow().iter().find(|(known, _)| known == of) {
            return Ok(value.clone());
        }
        let value = body()?;
        state.memo.quadratures.borrow_mut().push((of.clone(), value.clone()));
        Ok(value)
    }

    fn shrinking(&self, region: SymbolId, body: Body<'_, Primal<B>>) -> Valued<B> {
        Ok(first(&self.0.shrinking(region, &mut || Ok(lifted(&body()?)))?))
    }

    fn count_within(&self, region: SymbolId) -> Result<u8, Unavailable> {
        self.0.count_within(region)
    }

    fn rotation(&self, id: SymbolId, angle: Primal<B>) -> Result<nalgebra::Matrix3<Primal<B>>, Unavailable> {
        self.0.turned(id, angle)
    }
}
