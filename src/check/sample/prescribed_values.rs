//! States with prescribed values of some quantities, for limits and small quantities.

use crate::Result;
use crate::formula::{Expr, Node, Relation};
use crate::scalar::RunningError;

use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::sample::projection::Projection;
use crate::check::sample::setting::Setting;
use crate::check::state::sampled_state::SampledState;

/// A maker of states in which some quantities have prescribed values, and all other free numbers are unchanged.
pub struct PrescribedValues<'m> {
    projection: Projection<'m>,
    /// The place of each quantity that is a number of the base. The values of the others are hypotheses, after those of
    /// the claim.
    places: Vec<Option<usize>>,
}

impl<'m> PrescribedValues<'m> {
    /// The states of a setting with prescribed values of these quantities.
    pub fn new(model: &'m Model, setting: &Setting<'_>, quantities: &[Expr]) -> Self {
        let value = |quantity: &Expr| Hypothesis {
            lhs: quantity.clone(),
            relation: Relation::Equal,
            rhs: Expr::integer(0, quantity.span),
            free: Vec::new(),
            throughout: false,
            stated: None,
            implied: false,
        };
        let plain = Projection::new(model, setting);
        let nothing_is_solved = plain.equalities().next().is_none();
        let place = |quantity: &Expr| plain.place(quantity).filter(|_| nothing_is_solved);
        let places: Vec<Option<usize>> = quantities.iter().map(place).collect();
        let solved = quantities.iter().zip(&places).filter(|(_, place)| place.is_none());
        let values = solved.map(|(quantity, _)| value(quantity));
        let hypotheses: Vec<Hypothesis> = setting.hypotheses.iter().cloned().chain(values).collect();
        let projection = Projection::new(model, &Setting { hypotheses: &hypotheses, ..setting.clone() });
        PrescribedValues { projection, places }
    }

    /// The projection, if the quantities are numbers of a base and nothing is solved; and the places of the quantities.
    pub(crate) fn moves_alone(&self) -> Option<(&Projection<'m>, Vec<usize>)> {
        let places: Vec<usize> = self.places.iter().copied().collect::<Option<_>>()?;
        Some((&self.projection, places))
    }

    /// The state near a base at which the quantities have these values, if there is one.
    ///
    /// # Errors
    /// If the mass matrix is singular there.
    pub fn at(&mut self, base: &[f64], values: &[f64]) -> Result<Option<SampledState<'m, RunningError>>> {
        // On shell a projection has the laws and the constraints after the hypotheses of its setting.
        let model = self.projection.model;
        let of_the_motion: usize = match self.projection.mode.on_shell {
            true => model.laws.iter().map(|law| law.hypotheses.len()).sum::<usize>() + model.constraints.len(),
            false => 0,
        };
        let end = self.projection.hypotheses.len() - of_the_motion;
        let solved = self.places.iter().filter(|place| place.is_none()).count();
        let mut base = base.to_vec();
        for (at, value) in self.places.iter().zip(values).filter_map(|(place, value)| Some(((*place)?, *value))) {
            if !self.projection.allows(at, value) {
                return Ok(None);
            }
            base[at] = value;
        }
        let others = self.places.iter().zip(values).filter(|(place, _)| place.is_none()).map(|(_, value)| value);
        for (hypothesis, value) in self.projection.hypotheses[end - solved..end].iter_mut().zip(others) {
            let number = Expr::new(Node::Number(format!("{:e}", value.abs())), hypothesis.lhs.span);
            hypothesis.rhs = if *value < 0.0 { number.negated() } else { number };
        }
        Ok(self.projection.project(base)?.map(|(_, state)| state))
    }
}
