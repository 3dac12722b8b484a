//! The meanings of symbols: what gives each its value, and the ranges of drawn values.

use crate::formula::{Expr, IndexId, SymbolId};
use crate::mechanics::rotations::Axis;
use crate::notes::claims::{Range, SolidKind, Turning};

/// The meaning of a symbol: what gives it its value.
#[derive(Clone, Debug)]
pub enum Meaning {
    /// The i-th coordinate of the system.
    Coordinate(usize),
    /// A constant, by its place among [`super::Model::constants`].
    Constant(usize),
    /// A free function of time, by its place among [`super::Model::varying`].
    Varying(usize),
    /// The time.
    Time,
    /// A quantity that the system determines.
    System(Quantity),
    /// A formula of other symbols, and of its own indices.
    Defined(Box<Expr>),
    /// An elementary rotation about a fixed axis.
    Rotation(Axis, Turning),
    /// The k-th unit vector of the fixed axes.
    FixedAxis(usize),
    /// A quantity of the document's turning frame.
    Frame(FrameQuantity),
    /// A vector that is fixed in the turning frame, by its place among [`super::Model::rigid`].
    Rigid(usize),
    /// A quantity of point masses: the label that counts them, their masses, their positions.
    Particles(ParticleQuantity, IndexId, Box<Expr>, Box<Expr>),
    /// The part of a continuum under an integral or a limit; as a number its volume, area or length.
    Region(usize),
    /// The mass density of a continuum, at the point of the integral.
    Density(usize),
    /// The point that an integral over a continuum runs over.
    Point,
}

/// A quantity of a turning frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the quantity of its name")]
pub enum FrameQuantity {
    Axes,
    AngularVelocity,
    /// The angle turned about a fixed direction.
    Angle,
}

/// How a document's frame turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// Freely: three Euler angles that vary freely.
    Free,
    /// About a constant direction, by an angle that varies freely.
    FixedDirection,
}

/// A quantity of point masses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the quantity of its name")]
pub enum ParticleQuantity {
    /// The inertia tensor about the origin: the second derivative of the kinetic energy by the angular velocity.
    InertiaTensor,
    /// The eigenvalues of the inertia tensor, ascending.
    PrincipalMoments,
    /// The eigenvectors of the inertia tensor, in the same order, right-handed.
    PrincipalAxes,
}

/// A vector, or a family of vectors, that is fixed in the turning frame.
#[derive(Clone, Debug)]
pub struct Rigid {
    /// The vector or family of vectors.
    pub symbol: SymbolId,
    /// The fixed point about which they turn; the origin if there is none.
    pub about: Option<SymbolId>,
    /// The largest number of members.
    pub members: usize,
}

/// A body whose mass is spread over a volume, a surface or a line.
#[derive(Clone, Debug)]
pub struct Continuum {
    /// The symbol of the region.
    pub region: SymbolId,
    /// The dimension of the region: 3, 2 or 1.
    pub dimension: u8,
    /// The families of masses and positions of the particles into which it can be divided.
    pub particles: Option<(SymbolId, SymbolId)>,
    /// Whether its density is the same everywhere.
    pub uniform: bool,
    /// The solids of which it consists. If there are none, it is a random box, rectangle or segment.
    pub solids: Vec<Piece>,
}

/// A solid of a continuum, whose sizes are formulas.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The kind of solid.
    pub kind: SolidKind,
    /// The radius, length or edges.
    pub sizes: Vec<Expr>,
    /// The center, if that is not the origin.
    pub at: Option<Expr>,
    /// Whether the solid is subtracted from the others.
    pub hollow: bool,
}

/// A quantity that a system determines at a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the quantity of its name")]
pub enum Quantity {
    Lagrangian,
    KineticEnergy,
    PotentialEnergy,
    /// Σ p q̇ − L: the value of the Hamiltonian and, where L does not depend on time, the energy.
    Energy,
    Momentum(usize),
    /// The generalized force ∂L/∂q of a coordinate.
    Force(usize),
    /// The energy with the cyclic momenta fixed and the other coordinates at rest.
    EffectivePotential,
    /// The matrix whose rows are the body axes; its entries, for a name with two indices.
    RotationMatrix,
    /// As a vector; its components along the body axes, for a name with an index.
    AngularVelocity,
    BodyAxes,
    SpaceAxes,
}

/// The words of `"means"`.
pub const MEANINGS: [(&str, Quantity); 10] = [
    ("Lagrangian", Quantity::Lagrangian),
    ("kinetic energy", Quantity::KineticEnergy),
    ("potential energy", Quantity::PotentialEnergy),
    ("energy", Quantity::Energy),
    ("Hamiltonian", Quantity::Energy),
    ("effective potential", Quantity::EffectivePotential),
    ("rotation matrix", Quantity::RotationMatrix),
    ("angular velocity", Quantity::AngularVelocity),
    ("body axes", Quantity::BodyAxes),
    ("space axes", Quantity::SpaceAxes),
];

/// A constant or a free function of time, with the range of its values.
#[derive(Clone, Debug)]
pub struct Variable {
    /// The symbol.
    pub symbol: SymbolId,
    /// The range of its values.
    pub range: Range,
    /// The number of its numbers: three for a vector, times the members of a family.
    pub numbers: usize,
}

impl Variable {
    /// A single number.
    pub fn number(symbol: SymbolId, range: Range) -> Self {
        Variable { symbol, range, numbers: 1 }
    }
}

/// Whether values from a range are angles: `angle`, or an interval that ends at multiples of π/2.
pub fn is_angle(range: &Range) -> bool {
    let quarter = |x: f64| {
        let turns = x / std::f64::consts::FRAC_PI_2;
        (turns - turns.round()).abs() < 1e-9
    };
    match range {
        Range::Angle => true,
        Range::Interval { low, high, .. } => quarter(*low) && quarter(*high),
        _ => false,
    }
}
