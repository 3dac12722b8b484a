//! A generic body that replaces particles where a claim about their principal axes is decided over a prime field.
//!
//! Principal moments are the roots of a cubic, which a prime field need not contain. But a claim that holds for
//! arbitrary axes holds for the principal ones. And a claim that contains the particles only through their inertia
//! tensor, and holds for any symmetric tensor Rᵀ diag(λ₁, λ₂, λ₃) R, holds for theirs. Both tests are stronger than the
//! claim: an identity of the generic body proves the claim, and a difference decides nothing.
//!
//! # Why any body stands for particles with principal axes
//!
//! The moments of particles are roots of a cubic, which a field does not have. But what holds for any orthonormal
//! axes holds for these; and a claim that knows the particles through their tensor alone is tested with Rᵀ diag(λ)
//! R for random R and λ, which is every symmetric tensor.

use nalgebra::{Matrix3, Vector3};

use crate::formula::{Expr, SymbolId};
use crate::scalar::prime_field::Modulus;
use crate::scalar::{Modular, Number, cross, dot};

use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::Model;
use crate::check::model::meaning::{Meaning, ParticleQuantity};

/// Why a claim about principal axes stays open.
pub(crate) const PRINCIPAL_AXES: &str = "principal axes: their moments are the roots of a cubic";

/// The generic body that may replace the particles of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Generality {
    /// None is needed: the claim does not contain their principal axes.
    GivenParticles,
    /// Any right-handed orthonormal axes in place of the principal axes.
    AnyAxes,
    /// Any axes, and any moments about them.
    AnyTensor,
}

/// The principal axes and moments of a generic body.
#[derive(Clone, Debug)]
pub(crate) struct GenericBody<B: Number> {
    /// The axes are the rows.
    axes: Matrix3<B>,
    /// The moments; `None` if the particles keep their own inertia tensor.
    moments: Option<Vector3<B>>,
}

impl Generality {
    /// The most general body that formulas allow, under rules; `None` if no generic body can replace the particles.
    pub fn of(formulas: &[&Expr], model: &Model, rules: &[Rule]) -> Option<Self> {
        let mut whole = Dependencies { model, rules, symbols: Vec::new(), bodies: Vec::new() };
        formulas.iter().for_each(|formula| whole.follow(formula));
        let is_principal = |of: &(ParticleQuantity, [&Expr; 2])| of.0 != ParticleQuantity::InertiaTensor;
        let Some((_, particles)) = whole.bodies.iter().find(|of| is_principal(of)) else {
            return Some(Generality::GivenParticles);
        };
        let joined = rules.iter().any(|rule| matches!(rule.action, Action::Union(_)));
        if joined || whole.bodies.iter().any(|of| is_principal(of) && of.1 != *particles) {
            return None;
        }
        let mut of_particles = Dependencies { model, rules, symbols: Vec::new(), bodies: Vec::new() };
        particles.iter().for_each(|formula| of_particles.follow(formula));
        let is_axis = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::FixedAxis(_)));
        let shared = whole.symbols.iter().any(|id| of_particles.symbols.contains(id) && !is_axis(id));
        if !shared && whole.bodies.iter().all(|of| of.1 == *particles) {
            return Some(Generality::AnyTensor);
        }
        let of_moments = whole.bodies.iter().any(|of| of.0 == ParticleQuantity::PrincipalMoments);
        (!of_moments).then_some(Generality::AnyAxes)
    }
}

/// The symbols on which formulas depend, through definitions and rules, but not through the formulas of particles.
struct Dependencies<'a> {
    model: &'a Model,
    rules: &'a [Rule],
    symbols: Vec<SymbolId>,
    /// The quantities of particles, with the formulas of their masses and positions.
    bodies: Vec<(ParticleQuantity, [&'a Expr; 2])>,
}

impl<'a> Dependencies<'a> {
    fn follow(&mut self, formula: &'a Expr) {
        formula.symbols().into_iter().for_each(|(id, _)| self.visit(id));
    }

    fn visit(&mut self, id: SymbolId) {
        if self.symbols.contains(&id) {
            return;
        }
        self.symbols.push(id);
        self.model.symbols.entry(id).members.iter().for_each(|member| self.visit(*member));
        for rule in self.rules.iter().filter(|rule| rule.symbol == id) {
            rule.action.formulas().into_iter().for_each(|formula| self.follow(formula));
        }
        match self.model.meaning(id) {
            Some(Meaning::Defined(formula)) => self.follow(formula),
            Some(Meaning::Particles(quantity, _, masses, positions)) => {
                self.bodies.push((*quantity, [masses, positions]));
            }
            Some(Meaning::Rigid(at)) => {
                if let Some(about) = self.model.rigid[*at].about {
                    self.visit(about);
                }
            }
            _ => {}
        }
    }
}

impl<F: Modulus> GenericBody<Modular<F>> {
    /// A random body, whose axes come from a random quaternion.
    pub fn drawn(generality: Generality) -> Option<Self> {
        if generality == Generality::GivenParticles {
            return None;
        }
        let (w, v) = (Modular::<F>::random_plain(), Vector3::from_fn(|_, _| Modular::random_plain()));
        let turned = |x: Vector3<Modular<F>>| {
            (x * (w * w - dot(&v, &v)) + (v * dot(&v, &x) + cross(&v, &x) * w) * Modular::from(2.0))
                / (w * w + dot(&v, &v))
        };
        let axes = Matrix3::from_fn(|row, at| Modular::from(if row == at { 1.0 } else { 0.0 }));
        let axes = Matrix3::from_rows(&[0, 1, 2].map(|at| turned(axes.column(at).into()).transpose()));
        let moments = || Vector3::from_fn(|_, _| Modular::random_plain());
        Some(GenericBody { axes, moments: (generality == Generality::AnyTensor).then(moments) })
    }
}

impl<B: Number> GenericBody<B> {
    /// The a-th principal axis.
    pub fn axis(&self, a: usize) -> Vector3<B> {
        self.axes.row(a).transpose()
    }

    /// The a-th principal moment.
    pub fn moment(&self, a: usize) -> Option<B> {
        self.moments.map(|moments| moments[a])
    }

    /// The inertia tensor, unless the particles keep their own.
    pub fn tensor(&self) -> Option<Matrix3<B>> {
        self.moments.map(|moments| self.axes.transpose() * Matrix3::from_diagonal(&moments) * self.axes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::prime_field::{FirstPrime, evaluate_at_point};

    #[test]
    fn the_axes_are_right_handed_and_orthonormal_and_the_tensor_has_its_moments_along_them() {
        for seed in 1..=5 {
            let (all, record) = evaluate_at_point::<FirstPrime, _>(seed, 0, 1, || {
                let body =
                    GenericBody::<Modular<FirstPrime>>::drawn(Generality::AnyTensor).expect("one that stands in");
                let tensor = body.tensor().expect("a tensor");
                let axes: Vec<_> = (0..3).map(|a| body.axis(a)).collect();
                let mut vanishing = vec![axes[0].cross(&axes[1]) - axes[2]];
                for a in 0..3 {
                    vanishing.push(tensor * axes[a] - axes[a] * body.moment(a).expect("a moment"));
                    let norm = axes[a].dot(&axes[a]) - 1.0;
                    vanishing.push(Vector3::new(norm, axes[a].dot(&axes[(a + 1) % 3]), Modular::from(0.0)));
                }
                let zero = vanishing.iter().all(|vector| vector.iter().all(|x| x.vanishes()));
                // The mutants: they are no fixed axes, and no moment is another.
                let [x, y] = [0, 1].map(|a| body.moment(a).expect("a moment"));
                (zero, axes[0].x.vanishes() || (axes[0].x - 1.0).vanishes() || (x - y).vanishes())
            });
            assert!(record.unsupported.is_none() && record.undefined_here.is_none(), "seed {seed}");
            assert_eq!(all, (true, false), "seed {seed}");
        }
        assert!(GenericBody::<Modular<FirstPrime>>::drawn(Generality::GivenParticles).is_none());
    }
}
