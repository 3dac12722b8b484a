//! The meanings of symbols: what gives each its value, and where drawn values lie.

use crate::formula::{Expr, IndexId, SymbolId};
use crate::mechanics::rotations::Axis;
use crate::notes::claims::{Range, SolidKind, Turning};

/// What gives a symbol its value.
#[derive(Clone, Debug)]
pub enum Meaning {
    /// The i-th coordinate of the system.
    Coordinate(usize),
    /// A constant, by its place among [`Model::constants`].
    Constant(usize),
    /// Something free that varies with time, by its place among [`Model::varying`].
    Varying(usize),
    /// The time.
    Time,
    /// Something that the system determines.
    System(Quantity),
    /// A formula of other symbols, and of its own indices.
    Defined(Box<Expr>),
    /// An elementary rotation about a fixed axis.
    Rotation(Axis, Turning),
    /// The k-th unit vector of the fixed axes.
    FixedAxis(usize),
    /// Something that the document's turning frame determines.
    Frame(FrameQuantity),
    /// Fixed in the turning frame, by its place among [`Model::rigid`].
    Rigid(usize),
    /// Something that point masses determine: the label that counts them, their masses, their positions.
    Particles(ParticleQuantity, IndexId, Box<Expr>, Box<Expr>),
    /// The part of a continuum at hand; as a number its volume, area or length.
    Region(usize),
    /// The mass density of a continuum, at the point at hand.
    Density(usize),
    /// The point of a continuum at hand.
    Point,
}

/// What a turning frame determines.
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
    /// Anyhow: three Euler angles that vary freely.
    Free,
    /// About a direction that does not change, by an angle that varies freely.
    FixedDirection,
}

/// What point masses determine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the quantity of its name")]
pub enum ParticleQuantity {
    /// The second derivative of the kinetic energy by the angular velocity, about the origin.
    InertiaTensor,
    /// The eigenvalues of the inertia tensor, ascending.
    PrincipalMoments,
    /// Its eigenvectors, in the same order, right-handed.
    PrincipalAxes,
}

/// Vectors that are fixed in the turning frame.
#[derive(Clone, Debug)]
pub struct Rigid {
    /// The vector or family of vectors.
    pub symbol: SymbolId,
    /// The fixed point that they turn about; the origin, if there is none.
    pub about: Option<SymbolId>,
    /// How many there are, at most.
    pub members: usize,
}

/// A body whose mass is spread over a volume, a surface or a line.
#[derive(Clone, Debug)]
pub struct Continuum {
    /// The symbol of the region.
    pub region: SymbolId,
    /// 3, 2 or 1.
    pub dimension: u8,
    /// The masses and positions of the particles that it can be cut into.
    pub particles: Option<(SymbolId, SymbolId)>,
    /// Whether its density is the same everywhere.
    pub uniform: bool,
    /// What it is made of; a box, a rectangle or a segment anywhere, if nothing is said.
    pub solids: Vec<Piece>,
}

/// A solid of a continuum, of sizes that are formulas.
#[derive(Clone, Debug)]
pub struct Piece {
    /// What solid.
    pub kind: SolidKind,
    /// Its radius, length or edges.
    pub sizes: Vec<Expr>,
    /// Its center, if that is not the origin.
    pub at: Option<Expr>,
    /// Whether it is taken away.
    pub hollow: bool,
}

/// What a system determines at a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the quantity of its name")]
pub enum Quantity {
    Lagrangian,
    KineticEnergy,
    PotentialEnergy,
    /// Σ p q̇ − L: the value of the Hamiltonian and, where L does not depend on time, the energy.
    Energy,
    Momentum(usize),
    /// With the cyclic momenta held, at rest in the other coordinates.
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

/// A constant or a free function of time, with where its values are drawn from.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Its symbol.
    pub symbol: SymbolId,
    /// Where its values lie.
    pub range: Range,
    /// How many numbers it is: three for a vector, times the members of a family.
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
