//! What the symbols of a document mean: the claims file's declarations, tied to the world that they describe.
//!
//! The model is where the printed side and the derived side meet. It owns the table of names and knows for each what
//! gives it its value: a coordinate, a parameter, something that the Lagrangian determines, a formula that the prose or
//! an earlier equation defines.

use std::sync::Arc;

use crate::formula::symbols::{Components, Name};
use crate::formula::{Expr, IndexId, SymbolId, Symbols};
use crate::latex::Macros;
use crate::mechanics::World;
use crate::mechanics::rotations::Axis;
use crate::notes::claims::{Claims, Range, SolidKind, Spanned, Turning};
use crate::systems::Registry;
use crate::{Error, Result};

use super::builder;
use super::drawn::Drawn;
use super::ensemble::Condition;

/// What gives a symbol its value.
#[derive(Clone, Debug)]
pub enum Meaning {
    /// The i-th coordinate of the world.
    Coordinate(usize),
    /// A constant, by its place among [`Model::constants`].
    Constant(usize),
    /// Something free that varies with time, by its place among [`Model::varying`].
    Varying(usize),
    /// The time.
    Time,
    /// Something that the world determines.
    World(Quantity),
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

/// A hypothesis about all motions that the notes make: a law.
#[derive(Clone, Debug)]
pub struct Law {
    /// Its name.
    pub name: String,
    /// The statements that print it: the place of the display, and of the statement in it.
    pub printed: Vec<(usize, usize)>,
    /// What it says.
    pub conditions: Vec<Condition>,
    /// Whether its claim switches the units off, so that its terms may be of any dimension.
    pub units_off: bool,
}

impl Law {
    /// Its name, with what the reader of a report must know beside it.
    pub fn title(&self) -> String {
        if self.units_off { format!("{}, whose units are not checked", self.name) } else { self.name.clone() }
    }
}

/// A name or a law that is lost with a display that cannot be read, and that display in words.
pub type Lost = (String, String);

/// What a world determines at a state.
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

/// The symbols of a document and what they mean.
#[derive(Clone)]
pub struct Model {
    /// The names.
    pub symbols: Symbols,
    /// What each means, by [`SymbolId`]; a symbol that was read and not yet explained has none.
    pub meanings: Vec<Option<Meaning>>,
    /// What is true, if the claims name a system.
    pub world: Option<Arc<World>>,
    /// The world's coordinates in its order; without a world, the declared ones.
    pub coordinates: Vec<Variable>,
    /// All constants; the world's parameters are among them.
    pub constants: Vec<Variable>,
    /// The world's parameters in its order, by their places among the constants.
    pub parameters: Vec<usize>,
    /// Free functions of time.
    pub varying: Vec<Variable>,
    /// The frame that turns, if there is one.
    pub frame: Option<Frame>,
    /// Vectors fixed in it.
    pub rigid: Vec<Rigid>,
    /// Vectors whose components are taken along axes that are named.
    pub components: Vec<(Name, Name)>,
    /// Bodies that fill a region.
    pub continua: Vec<Continuum>,
    /// The laws that motions obey.
    pub laws: Vec<Law>,
    /// The author's commands.
    pub macros: Macros,
    /// Names of the claims file that could not be given a meaning.
    pub lost: Vec<Lost>,
    /// Laws that could not be taken over.
    pub lost_laws: Vec<Lost>,
    /// What was inferred, for the reader of the report.
    pub inferred: Vec<String>,
    /// States that were found before.
    pub drawn: Drawn,
}

impl Model {
    /// The model of these names, none of which means anything yet.
    pub fn empty(symbols: Symbols, macros: Macros) -> Model {
        Model {
            symbols,
            meanings: Vec::new(),
            world: None,
            coordinates: Vec::new(),
            constants: Vec::new(),
            parameters: Vec::new(),
            varying: Vec::new(),
            frame: None,
            rigid: Vec::new(),
            components: Vec::new(),
            continua: Vec::new(),
            laws: Vec::new(),
            macros,
            lost: Vec::new(),
            lost_laws: Vec::new(),
            inferred: Vec::new(),
            drawn: Drawn::default(),
        }
    }

    /// Builds the model of a claims file; `macros` are those defined in the notes.
    ///
    /// # Errors
    /// For a name that cannot be read, a system that is not there, a meaning that the system does not have, a parameter
    /// or coordinate of the system that no symbol stands for: each at its place in the claims file.
    pub fn new(claims: &Claims, macros: Macros, registry: &Registry) -> Result<Model> {
        let mut macros = macros;
        for (name, body) in &claims.macros {
            macros.define(&name.value, Macros::arguments_of(&body.value), &body.value);
        }
        builder::build(claims, Model::empty(Symbols::new(), macros), registry)
    }

    /// The meaning of a symbol; a symbol that was introduced and not yet given one has none.
    pub fn meaning(&self, id: SymbolId) -> Option<&Meaning> {
        self.meanings.get(id.0)?.as_ref()
    }

    /// Gives a symbol its meaning.
    pub fn mean(&mut self, id: SymbolId, meaning: Meaning) {
        if self.meanings.len() <= id.0 {
            self.meanings.resize(id.0 + 1, None);
        }
        self.meanings[id.0] = Some(meaning);
    }

    /// Whether anything says how things move: a system, or laws.
    pub fn has_motion(&self) -> bool {
        self.world.is_some() || !self.laws.is_empty()
    }

    /// Whether a formula depends on one of these symbols, through definitions too.
    pub fn depends_on(&self, expr: &Expr, symbols: &[SymbolId]) -> bool {
        expr.symbols().iter().any(|(id, _)| self.stands_on(*id, symbols))
    }

    /// Whether a formula is made of drawn symbols and definitions alone, of nothing that a world or a frame determines.
    pub fn is_plain(&self, expr: &Expr) -> bool {
        expr.symbols().iter().all(|(id, _)| match self.meaning(*id) {
            Some(Meaning::Constant(_) | Meaning::Varying(_) | Meaning::Coordinate(_) | Meaning::FixedAxis(_)) => true,
            Some(Meaning::Defined(formula)) => self.is_plain(formula),
            _ => false,
        })
    }

    fn stands_on(&self, id: SymbolId, symbols: &[SymbolId]) -> bool {
        symbols.contains(&id)
            || match self.meaning(id) {
                Some(Meaning::Defined(formula)) => self.depends_on(formula, symbols),
                Some(Meaning::Particles(_, _, masses, positions)) => {
                    self.depends_on(masses, symbols) || self.depends_on(positions, symbols)
                }
                Some(Meaning::Rigid(at)) => self.rigid[*at].about.is_some_and(|about| symbols.contains(&about)),
                _ => self.symbols.entry(id).members.iter().any(|member| self.stands_on(*member, symbols)),
            }
    }

    /// Gives an introduced symbol its defining formula.
    pub fn define(&mut self, id: SymbolId, formula: Expr) {
        self.mean(id, Meaning::Defined(Box::new(formula)));
        self.tie_components();
    }

    /// Tells the table of names along which axes the components of known vectors are taken; false while axes are missing.
    pub fn tie_components(&mut self) -> bool {
        let mut all = true;
        for (vector, axes) in &self.components {
            let Some((axes, _)) = self.symbols.find(axes) else {
                all = false;
                continue;
            };
            if let Some((id, _)) = self.symbols.find(vector) {
                self.symbols.entry_mut(id).components = Some(Components::Along(axes));
            }
        }
        all
    }

    /// The name of a symbol, as LaTeX.
    pub fn name(&self, id: SymbolId) -> String {
        self.symbols.entry(id).name.to_string()
    }

    /// The range that a symbol's values are drawn from when it is taken to be independent.
    pub fn range(&self, id: SymbolId) -> Range {
        match self.meaning(id) {
            Some(Meaning::Coordinate(i)) => self.coordinates[*i].range.clone(),
            Some(Meaning::Constant(i)) => self.constants[*i].range.clone(),
            Some(Meaning::Varying(i)) => self.varying[*i].range.clone(),
            _ => Range::Any,
        }
    }
}

/// A fault in LaTeX that stands in a claims file, at its place there.
pub fn formula_error(claims: &Claims, latex: &Spanned<String>, fault: crate::source::Fault) -> Error {
    let at = latex.value.get(fault.span.range()).filter(|part| !part.is_empty() && *part != latex.value);
    let message = match at {
        Some(part) => format!("at “{part}”: {}", fault.message),
        None => fault.message,
    };
    let error = Error::at(&claims.source, latex.span, message).lacking(fault.missing);
    match fault.help {
        Some(help) => error.help(help),
        None => error,
    }
}

/// A name without what only typesets it: `\lambda_{1}` and `lambda1` are the same here.
pub fn plain(latex: &str) -> String {
    latex.chars().filter(|c| !matches!(c, '\\' | '_' | '{' | '}' | ' ')).collect()
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
