//! The definition of a mechanical system: its Lagrangian L(q, q̇, t) as a Rust function over any number.

use nalgebra::Matrix3;
use num_dual::Dual;

use crate::scalar::Number;

/// Where a Lagrangian is evaluated: time, coordinates q, velocities v = q̇, parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<D, const N: usize, const P: usize> {
    /// The time t.
    pub time: D,
    /// The coordinates q.
    pub q: [D; N],
    /// Their velocities q̇.
    pub v: [D; N],
    /// The parameters, in the order of [`Lagrangian::parameters`].
    pub parameters: [D; P],
}

impl<D: Number, const N: usize, const P: usize> State<D, N, P> {
    /// The same state over another number.
    pub fn map<E: Number>(&self, lift: impl Fn(D) -> E) -> State<E, N, P> {
        State {
            time: lift(self.time),
            q: self.q.map(&lift),
            v: self.v.map(&lift),
            parameters: self.parameters.map(&lift),
        }
    }

    /// The state with its own motion as the ε-part: ṫ = 1, q̇ = v (and no acceleration). A function of position and
    /// time, evaluated here, has its total time derivative as the ε-part.
    pub fn moving(&self) -> State<Dual<D>, N, P> {
        let mut moving = self.map(Dual::from_re);
        moving.time.eps = D::one();
        for (q, v) in moving.q.iter_mut().zip(self.v) {
            q.eps = v;
        }
        moving
    }
}

/// A point mass of a system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<D> {
    /// Its mass.
    pub mass: D,
    /// Its Cartesian coordinates x, y, z along axes at rest.
    pub place: [D; 3],
}

/// A mechanical system, given by its Lagrangian.
///
/// ```
/// use onshell::mechanics::{Lagrangian, State};
/// use onshell::scalar::Number;
///
/// struct Bead; // on a wire z = x²
/// impl Lagrangian<1, 2> for Bead {
///     fn name(&self) -> &str { "bead" }
///     fn coordinates(&self) -> [&str; 1] { ["x"] }
///     fn parameters(&self) -> [&str; 2] { ["m", "g"] }
///     fn lagrangian<D: Number>(&self, at: &State<D, 1, 2>) -> D {
///         let ([x], [v], [m, g]) = (at.q, at.v, at.parameters);
///         m * (v * v + (x * v * 2.0).powi(2)) * 0.5 - m * g * x * x
///     }
/// }
/// ```
pub trait Lagrangian<const N: usize, const P: usize>: Send + Sync + 'static {
    /// The name that claims files use: `"heavy_top"`.
    fn name(&self) -> &str;
    /// The coordinates as LaTeX spells them: `"\\theta"`.
    fn coordinates(&self) -> [&str; N];
    /// The parameters as LaTeX spells them: `"\\lambda_1"`.
    fn parameters(&self) -> [&str; P];
    /// L(q, q̇, t). No branches on the values: it must also run over symbols.
    fn lagrangian<D: Number>(&self, at: &State<D, N, P>) -> D;
    /// U(q, t), where L = T − U; the kinetic energy is then T = L + U.
    fn potential_energy<D: Number>(&self, at: &State<D, N, P>) -> Option<D> {
        let _ = at;
        None
    }
    /// For a rigid body: R with êₐ = R_ab ê_b(0). The *rows* are the body's axes in space components.
    fn orientation<D: Number>(&self, at: &State<D, N, P>) -> Option<Matrix3<D>> {
        let _ = at;
        None
    }
    /// The point masses that the system consists of, for a system of particles whose kinetic energy is ½ Σ m v².
    fn particles<D: Number>(&self, at: &State<D, N, P>) -> Vec<Particle<D>> {
        let _ = at;
        Vec::new()
    }
    /// The principal moments of a rigid body with an [orientation](Lagrangian::orientation), whose kinetic energy is
    /// ½ Σ λₐ ωₐ².
    fn principal_moments<D: Number>(&self, at: &State<D, N, P>) -> Option<[D; 3]> {
        let _ = at;
        None
    }
}
