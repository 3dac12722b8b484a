//! What the symbols of a document mean: the claims file's declarations, tied to the world that they describe.
//!
//! The model is where the printed side and the derived side meet. It owns the table of names and knows for each what
//! gives it its value: a coordinate, a parameter, something that the Lagrangian determines, a formula that the prose or
//! an earlier equation defines.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Kind, SymbolId, Symbols, text};
use crate::latex::{Macros, names, read_formula};
use crate::mechanics::World;
use crate::mechanics::rotations::Axis;
use crate::notes::claims::{Claims, Count, Range, Role, Spanned, Turning};
use crate::systems::Registry;
use crate::{Error, Result, suggest};

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
    /// A formula of other symbols.
    Defined(Box<Expr>),
    /// An elementary rotation about a fixed axis.
    Rotation(Axis, Turning),
}

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
}

/// The symbols of a document and what they mean.
pub struct Model {
    /// The names.
    pub symbols: Symbols,
    /// What each means, by [`SymbolId`].
    pub meanings: Vec<Meaning>,
    /// What is true, if the claims name a system.
    pub world: Option<World>,
    /// The world's coordinates in its order; without a world, the declared ones.
    pub coordinates: Vec<Variable>,
    /// All constants; the world's parameters are among them.
    pub constants: Vec<Variable>,
    /// The world's parameters in its order, by their places among the constants.
    pub parameters: Vec<usize>,
    /// Free functions of time.
    pub varying: Vec<Variable>,
    /// The author's commands.
    pub macros: Macros,
    /// What was inferred, for the reader of the report.
    pub inferred: Vec<String>,
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
            macros,
            inferred: Vec::new(),
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
        let mut builder = Builder { claims, model: Model::empty(Symbols::new(), macros) };
        builder.declarations()?;
        builder.world(registry)?;
        builder.means()?;
        builder.momenta();
        builder.rotations()?;
        builder.definitions()?;
        Ok(builder.model)
    }

    /// The meaning of a symbol; a symbol that was introduced and not yet given one has none.
    pub fn meaning(&self, id: SymbolId) -> Option<&Meaning> {
        self.meanings.get(id.0)
    }

    /// Gives an introduced symbol its defining formula.
    pub fn define(&mut self, id: SymbolId, formula: Expr) {
        debug_assert_eq!(id.0, self.meanings.len(), "symbols are introduced in order");
        self.meanings.push(Meaning::Defined(Box::new(formula)));
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

struct Builder<'a> {
    claims: &'a Claims,
    model: Model,
}

impl Builder<'_> {
    fn shown(&self, symbol: SymbolId) -> String {
        text::plain(&self.model.name(symbol))
    }

    fn error(&self, place: &Spanned<String>, message: impl Into<String>) -> Error {
        Error::at(&self.claims.source, place.span, message)
    }

    fn name(&self, latex: &Spanned<String>) -> Result<Name> {
        match names::parse(&latex.value) {
            Some((name, 0)) => Ok(name),
            Some(_) => Err(self
                .error(latex, format!("{} has a dot, and dots are not part of a name", latex.value))
                .help("declare the symbol itself")),
            None => Err(self
                .error(latex, format!("{} is not the name of a symbol", latex.value))
                .help("a name is a letter or a Greek command, with accents, a subscript, primes: \\hat{e}_a, p_\\psi")),
        }
    }

    fn add(&mut self, latex: &Spanned<String>, kind: Kind, meaning: Meaning) -> Result<SymbolId> {
        let name = self.name(latex)?;
        if ["e", "d"].contains(&name.base.as_str()) && name.subscript.is_empty() {
            self.model.inferred.push(format!("{name} is a symbol here, not a constant or a differential"));
        }
        let shown = name.to_string();
        let id = self
            .model
            .symbols
            .add(name, kind)
            .ok_or_else(|| self.error(latex, format!("{shown} is declared twice")).help("keep one of the two"))?;
        self.model.meanings.push(meaning);
        Ok(id)
    }

    fn declarations(&mut self) -> Result<()> {
        let declarations = &self.claims.declarations;
        for index in declarations.iter().filter(|d| d.role == Role::Index) {
            match index.range.value {
                Range::Integer { low: 1, high: Count::Number(high) } if (1..=9).contains(&high) => {
                    let name = self.name(&index.name)?;
                    self.model.symbols.add_index(&name.to_string(), high as u8);
                }
                _ => {
                    return Err(Error::at(&self.claims.source, index.range.span, "an index runs from 1 to at most 9")
                        .help("write \"1..3\""));
                }
            }
        }
        if let Some(time) = &self.claims.independent_variable {
            self.model.symbols.time = Some(self.name(time)?);
        }
        for declaration in declarations {
            let latex = &declaration.name;
            let range = declaration.range.value.clone();
            let kind = if latex.value.contains("\\vec") { Kind::Vector } else { Kind::Scalar };
            let (meaning, varies) = match declaration.role {
                Role::Index => continue,
                Role::Coordinate => (Meaning::Coordinate(self.model.coordinates.len()), true),
                Role::Constant => (Meaning::Constant(self.model.constants.len()), false),
                Role::VariesWithTime => (Meaning::Varying(self.model.varying.len()), true),
                Role::Function => {
                    return Err(self.error(latex, "functions are not supported yet"));
                }
            };
            if kind == Kind::Vector {
                return Err(self
                    .error(latex, "free vectors are not supported yet")
                    .help("a vector of the world is declared under \"means\""));
            }
            let id = self.add(latex, kind, meaning)?;
            let entry = self.model.symbols.entry_mut(id);
            entry.angle = is_angle(&range);
            entry.varies = varies;
            if !entry.slots.is_empty() {
                return Err(self.error(latex, "families of numbers are not supported yet"));
            }
            let variable = Variable { symbol: id, range };
            match declaration.role {
                Role::Coordinate => self.model.coordinates.push(variable),
                Role::Constant => self.model.constants.push(variable),
                _ => self.model.varying.push(variable),
            }
        }
        if let Some(time) = self.model.symbols.time.clone()
            && self.model.symbols.find(&time).is_none()
            && let Some(id) = self.model.symbols.add(time, Kind::Scalar)
        {
            self.model.symbols.entry_mut(id).varies = true;
            self.model.meanings.push(Meaning::Time);
        }
        Ok(())
    }

    /// Ties the declared coordinates and constants to those of the system, by name or by `"read"`.
    fn world(&mut self, registry: &Registry) -> Result<()> {
        let Some(reference) = &self.claims.system else { return Ok(()) };
        let system = registry.get(&reference.name.value).ok_or_else(|| {
            let error = self.error(&reference.name, format!("there is no system \"{}\"", reference.name.value));
            match suggest::nearest(&reference.name.value, registry.names()) {
                Some(near) => error.help(format!("did you mean \"{near}\"?")),
                None => error.help(format!("there are {}", registry.names().collect::<Vec<_>>().join(", "))),
            }
        })?;
        let world = system.world()?;
        for (target, symbol) in &reference.read {
            let known = world.coordinates().iter().chain(world.parameters());
            if !known.clone().any(|name| plain(name) == plain(&target.value)) {
                let names: Vec<&str> = known.map(String::as_str).collect();
                return Err(self
                    .error(target, format!("\"{}\" has no \"{}\"", world.name(), target.value))
                    .help(format!("it has {}", names.join(", "))));
            }
            let name = self.name(symbol)?;
            if self.model.symbols.find(&name).is_none() {
                return Err(self.error(symbol, format!("{name} is not declared")));
            }
        }
        let reads = |printed: &str, wanted: &str| {
            let renamed = reference.read.iter().find(|(_, symbol)| plain(&symbol.value) == plain(printed));
            plain(renamed.map_or(printed, |(target, _)| target.value.as_str())) == plain(wanted)
        };
        let mut map = Vec::new();
        let mut coordinates = Vec::new();
        for wanted in world.coordinates() {
            let found = self.model.coordinates.iter().find(|v| reads(&self.model.name(v.symbol), wanted));
            let variable = found.ok_or_else(|| self.missing(&reference.name, "coordinate", wanted))?;
            map.push(format!("{} is the coordinate {}", self.shown(variable.symbol), text::plain(wanted)));
            coordinates.push(variable.clone());
        }
        for variable in &self.model.coordinates {
            if !coordinates.iter().any(|known| known.symbol == variable.symbol) {
                let name = self.model.name(variable.symbol);
                let place = self.claims.declarations.iter().find(|d| plain(&d.name.value) == plain(&name));
                let span = place.map_or(reference.name.span, |d| d.name.span);
                let message = format!("{name} is not a coordinate of \"{}\"", world.name());
                return Err(Error::at(&self.claims.source, span, message)
                    .help("declare it under \"constants\" or \"varies with time\", or map it with \"read\""));
            }
        }
        for (place, variable) in coordinates.iter().enumerate() {
            self.model.meanings[variable.symbol.0] = Meaning::Coordinate(place);
        }
        self.model.coordinates = coordinates;
        for wanted in world.parameters() {
            let found = self.model.constants.iter().position(|v| reads(&self.model.name(v.symbol), wanted));
            let place = found.ok_or_else(|| self.missing(&reference.name, "parameter", wanted))?;
            let symbol = self.model.constants[place].symbol;
            map.push(format!("{} is the parameter {}", self.shown(symbol), text::plain(wanted)));
            self.model.parameters.push(place);
        }
        self.model.inferred.push(format!("the system is {}: {}", world.name(), map.join(", ")));
        self.model.world = Some(world);
        Ok(())
    }

    fn missing(&self, place: &Spanned<String>, what: &str, name: &str) -> Error {
        self.error(place, format!("no declared symbol stands for the {what} {name} of \"{}\"", place.value))
            .help(format!("declare {name}, or say which symbol it is with \"read\""))
    }

    fn means(&mut self) -> Result<()> {
        for (latex, meaning) in &self.claims.means {
            let quantity = self.quantity(meaning)?;
            let name = self.name(latex)?;
            let slots = name.subscript.iter().filter(|token| self.model.symbols.index(token).is_some()).count();
            let kind = match (quantity, slots) {
                (Quantity::RotationMatrix, 0) => Kind::Matrix,
                (Quantity::RotationMatrix, 2) | (Quantity::AngularVelocity, 1) => Kind::Scalar,
                (Quantity::AngularVelocity, 0) => Kind::Vector,
                (Quantity::BodyAxes | Quantity::SpaceAxes, 1) => Kind::Vector,
                (Quantity::RotationMatrix | Quantity::AngularVelocity, _)
                | (Quantity::BodyAxes | Quantity::SpaceAxes, _) => {
                    return Err(self
                        .error(latex, format!("{name} has {slots} indices, and the {} has not", meaning.value))
                        .help("declare the letters of its subscript under \"indices\""));
                }
                (_, 0) => Kind::Scalar,
                _ => return Err(self.error(latex, format!("{name} has an index, and the {} has none", meaning.value))),
            };
            let id = self.add(latex, kind, Meaning::World(quantity))?;
            self.model.symbols.entry_mut(id).varies = true;
        }
        Ok(())
    }

    fn quantity(&self, meaning: &Spanned<String>) -> Result<Quantity> {
        let Some(world) = &self.model.world else {
            return Err(self.error(meaning, "nothing can be known here without a system").help("name a \"system\""));
        };
        if let Some(coordinate) = meaning.value.strip_prefix("momentum of ") {
            let place =
                self.model.coordinates.iter().position(|v| plain(&self.model.name(v.symbol)) == plain(coordinate));
            return place
                .map(Quantity::Momentum)
                .ok_or_else(|| self.error(meaning, format!("{coordinate} is not a coordinate")));
        }
        let found = MEANINGS.iter().find(|(word, _)| *word == meaning.value).map(|(_, quantity)| *quantity);
        let quantity = found.ok_or_else(|| {
            let words: Vec<&str> = MEANINGS.iter().map(|(word, _)| *word).collect();
            let error = self.error(meaning, format!("\"{}\" is not a meaning", meaning.value));
            match suggest::nearest(&meaning.value, words.iter().copied()) {
                Some(near) => error.help(format!("did you mean \"{near}\"?")),
                None => error.help(format!("the meanings are {}, momentum of q", words.join(", "))),
            }
        })?;
        let lacks = match quantity {
            Quantity::KineticEnergy | Quantity::PotentialEnergy if !world.has_potential() => Some("potential energy"),
            Quantity::RotationMatrix | Quantity::AngularVelocity | Quantity::BodyAxes | Quantity::SpaceAxes
                if !world.has_orientation() =>
            {
                Some("orientation")
            }
            _ => None,
        };
        match lacks {
            Some(what) => Err(self.error(meaning, format!("the system \"{}\" gives no {what}", world.name()))),
            None => Ok(quantity),
        }
    }

    /// `p_q` is the momentum of each coordinate q, unless it is declared otherwise.
    fn momenta(&mut self) {
        if self.model.world.is_none() {
            return;
        }
        for place in 0..self.model.coordinates.len() {
            let coordinate = self.model.name(self.model.coordinates[place].symbol);
            let Some((name, 0)) = names::parse(&format!("p_{{{coordinate}}}")) else { continue };
            let shown = name.to_string();
            if let Some(id) = self.model.symbols.add(name, Kind::Scalar) {
                self.model.symbols.entry_mut(id).varies = true;
                self.model.meanings.push(Meaning::World(Quantity::Momentum(place)));
                let (shown, coordinate) = (text::plain(&shown), text::plain(&coordinate));
                self.model.inferred.push(format!("{shown} is the momentum of {coordinate}"));
            }
        }
    }

    fn rotations(&mut self) -> Result<()> {
        for (latex, sense) in &self.claims.rotations {
            let name = self.name(latex)?;
            let axis = match name.subscript.as_slice() {
                [axis] if axis == "x" || axis == "1" => Axis::X,
                [axis] if axis == "y" || axis == "2" => Axis::Y,
                [axis] if axis == "z" || axis == "3" => Axis::Z,
                _ => return Err(self.error(latex, "a rotation names its axis below: \\mathbf{R}_z")),
            };
            self.add(latex, Kind::Rotation, Meaning::Rotation(axis, sense.value))?;
        }
        Ok(())
    }

    fn definitions(&mut self) -> Result<()> {
        for (latex, body) in &self.claims.define {
            let name = self.name(latex)?;
            let macros = self.model.macros.clone();
            let formula = read_formula(&body.value, &mut self.model.symbols, &macros)
                .map_err(|fault| formula_error(self.claims, body, fault))?;
            let kind = match crate::formula::shape::shape_of(&formula, &self.model.symbols) {
                Ok(crate::formula::shape::Shape::Scalar) => Kind::Scalar,
                Ok(crate::formula::shape::Shape::Vector) => Kind::Vector,
                _ => return Err(self.error(body, format!("{name} can only be defined as a number or a vector"))),
            };
            let id = self.add(latex, kind, Meaning::Defined(Box::new(formula)))?;
            self.model.symbols.entry_mut(id).varies = true;
        }
        Ok(())
    }
}

/// A fault in LaTeX that stands in a claims file, at its place there.
pub fn formula_error(claims: &Claims, latex: &Spanned<String>, fault: crate::source::Fault) -> Error {
    let at = latex.value.get(fault.span.range()).filter(|part| !part.is_empty() && *part != latex.value);
    let message = match at {
        Some(part) => format!("at “{part}”: {}", fault.message),
        None => fault.message,
    };
    let error = Error::at(&claims.source, latex.span, message);
    match fault.help {
        Some(help) => error.help(help),
        None => error,
    }
}

/// A name without what only typesets it: `\lambda_{1}` and `lambda1` are the same here.
fn plain(latex: &str) -> String {
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
