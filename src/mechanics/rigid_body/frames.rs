//! Rotating frames: right-handed unit axes êₐ(t), and what follows from R(t) by differentiation.
//!
//! A frame is given by its orientation as a time series, R with the axes as *rows* (the passive matrix of
//! [`rotations`](super::rotations)), from three Euler angles or from an angle about a fixed direction. Ṙ is the
//! derivative of the series, and ω follows from R and Ṙ.

use nalgebra::{Matrix3, Vector3};

use super::rotations::{RotationalState, angular_velocity, body_components, euler_angles, rodrigues};
use crate::scalar::{Number, Series};
use crate::{Error, Result};

/// Three right-handed orthogonal unit axes that turn with time.
///
/// All components are series: a frame whose angles are known to k derivatives has an ω that is known to k − 1.
///
/// ```
/// use onshell::mechanics::Frame;
/// use onshell::scalar::Series;
/// // a turntable: half a radian per second about the vertical
/// let table = Frame::about([0.0, 0.0, 2.0], Series::from_derivatives(&[0.3, 0.5]))?;
/// let omega = table.angular_velocity().map(|component| component.value());
/// assert!((omega - nalgebra::Vector3::new(0.0, 0.0, 0.5)).norm() < 1e-15);
/// # Ok::<(), onshell::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Frame<B: Number> {
    orientation: Matrix3<Series<B>>,
}

/// The axes, as rows, that were turned by `angle` about a direction; `constant` makes what angles are of its
/// components.
///
/// # Errors
/// When the direction is 0 or not finite.
pub fn axes_about<B: Number, D: Number>(
    direction: [B; 3],
    angle: D,
    constant: impl FnMut(B) -> D,
) -> Result<Matrix3<D>> {
    let [x, y, z] = direction;
    let length = (x * x + y * y + z * z).sqrt();
    let unit = direction.map(|component| component / length);
    #[expect(clippy::eq_op, reason = "NaN alone differs from itself; numbers of a field have no size to ask for")]
    if length.is_zero() || unit.iter().any(|component| component != component) {
        return Err(Error::new("the axis of rotation has no direction: it is 0, infinite or undefined")
            .help("give three finite numbers that are not all 0"));
    }
    Ok(rodrigues(&Vector3::from(unit.map(constant)), angle).transpose())
}

impl<B: Number> Frame<B> {
    /// A frame with arbitrary rotation: R = R_z(ψ) R_y(θ) R_z(φ) with the z–y–z Euler angles φ, θ, ψ in radians.
    pub fn from_euler_angles([phi, theta, psi]: [Series<B>; 3]) -> Self {
        Frame { orientation: euler_angles(phi, theta, psi) }
    }

    /// A frame that turns by `angle` (radians, right-handed) about a direction that stays: at angle 0 its axes are the
    /// fixed ones. The direction need not be of length 1.
    ///
    /// # Errors
    /// When the direction is 0 or not finite.
    pub fn about(direction: [B; 3], angle: Series<B>) -> Result<Self> {
        Ok(Frame { orientation: axes_about(direction, angle, Series::constant)? })
    }

    /// R(t): row a has the components of êₐ in the fixed axes, so R takes fixed components to those along the frame.
    pub fn orientation(&self) -> &Matrix3<Series<B>> {
        &self.orientation
    }

    /// Ṙ(t).
    pub fn rate(&self) -> Matrix3<Series<B>> {
        self.orientation.map(|entry| entry.derivative())
    }

    /// The axes ê₁, ê₂, ê₃ as vectors in the fixed axes.
    pub fn axes(&self) -> [Vector3<Series<B>>; 3] {
        std::array::from_fn(|a| self.orientation.row(a).transpose())
    }

    /// ω in the fixed axes: the vector with dêₐ/dt = ω × êₐ.
    pub fn angular_velocity(&self) -> Vector3<Series<B>> {
        angular_velocity(&self.orientation, &self.rate())
    }

    /// ωₐ = ω·êₐ.
    pub fn body_rates(&self) -> Vector3<Series<B>> {
        self.components(&self.angular_velocity())
    }

    /// Orientation, ω and ωₐ together.
    pub fn turning(&self) -> RotationalState<Series<B>> {
        let angular_velocity = self.angular_velocity();
        RotationalState {
            orientation: self.orientation,
            angular_velocity,
            body_rates: self.components(&angular_velocity),
        }
    }

    /// The components vₐ = v·êₐ of a vector that is given in the fixed axes.
    pub fn components(&self, vector: &Vector3<Series<B>>) -> Vector3<Series<B>> {
        body_components(&self.orientation, vector)
    }

    /// The vector Σ vₐ êₐ in the fixed axes.
    pub fn vector(&self, components: &Vector3<Series<B>>) -> Vector3<Series<B>> {
        self.orientation.transpose() * components
    }

    /// A point of a rigid body that turns with the frame: x(t) = c(t) + Σ xₐ êₐ(t), where c is the body's point at the
    /// frame's origin and the components xₐ along the axes stay.
    pub fn point_of_a_body(&self, centre: &Vector3<Series<B>>, at: &Vector3<B>) -> Vector3<Series<B>> {
        centre + self.vector(&at.map(Series::constant))
    }
}
