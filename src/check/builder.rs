//! The claims file's declarations made into a model: every name gets its meaning, and the world its symbols.
//!
//! What the prose defines (`"define"`) is not read here but together with the displays ([`super::reading`]), since the
//! two may stand on each other.

use std::sync::Arc;

use crate::formula::symbols::Name;
use crate::formula::{Expr, Index, Kind, Node, SymbolId, text};
use crate::latex::{names, read_formula};
use crate::mechanics::rotations::Axis;
use crate::notes::claims::{self, Axes, Claims, Count, Declaration, Range, Role, Spanned};
use crate::source::Span;
use crate::systems::Registry;
use crate::{Error, Result, suggest};

use super::model::{
    Continuum, Frame, FrameQuantity, MEANINGS, Meaning, Model, Piece, Quantity, Rigid, Variable, formula_error,
    is_angle, plain,
};
use super::particles;

/// The most things that a count counts: three or four, so that none of the two can hide a fault.
const MOST_THINGS: u8 = 4;

/// Builds the model of a claims file on an empty one.
pub(super) fn build(claims: &Claims, empty: Model, registry: &Registry) -> Result<Model> {
    let mut builder = Builder { claims, model: empty, early: Vec::new() };
    builder.indices()?;
    builder.declarations()?;
    builder.axes()?;
    builder.world(registry)?;
    builder.components()?;
    builder.means()?;
    builder.momenta();
    builder.rotations()?;
    builder.continua()?;
    Ok(builder.model)
}

struct Builder<'a> {
    claims: &'a Claims,
    model: Model,
    /// Symbols that were needed, and so added, before their turn.
    early: Vec<SymbolId>,
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
        self.model.mean(id, meaning);
        Ok(id)
    }

    fn indices(&mut self) -> Result<()> {
        for index in self.claims.declarations.iter().filter(|d| d.role == Role::Index) {
            let letter = self.name(&index.name)?.to_string();
            let wrong = || {
                Error::at(&self.claims.source, index.range.span, "an index runs from 1 to at most 9")
                    .help("write \"1..3\", or \"1..n\" for the labels of n things")
            };
            let small = |high: &i64| u8::try_from(*high).ok().filter(|high| (1..=9).contains(high));
            match &index.range.value {
                Range::Integer { low: 1, high: Count::Number(high) } => {
                    let high = small(high).ok_or_else(wrong)?;
                    self.model.symbols.add_index(&letter, high);
                }
                Range::Labels { high: Count::Number(high) } => {
                    let high = small(high).ok_or_else(wrong)?;
                    self.model.symbols.add_label(&letter, high, None);
                }
                Range::Integer { low: 1, high: Count::Symbol(count) }
                | Range::Labels { high: Count::Symbol(count) } => {
                    let count = self.count(&Spanned::new(count.clone(), index.range.span))?;
                    self.model.symbols.add_label(&letter, MOST_THINGS, Some(count));
                }
                _ => return Err(wrong()),
            }
        }
        Ok(())
    }

    /// The symbol of a count: a whole number, three or four.
    fn count(&mut self, latex: &Spanned<String>) -> Result<SymbolId> {
        let name = self.name(latex)?;
        if let Some((known, _)) = self.model.symbols.find(&name) {
            return Ok(known);
        }
        let id = self.add(latex, Kind::Scalar, Meaning::Constant(self.model.constants.len()))?;
        let range = Range::Integer { low: 3, high: Count::Number(MOST_THINGS.into()) };
        self.model.constants.push(Variable::number(id, range));
        self.model.inferred.push(format!("{} is a count, 3 or {MOST_THINGS} at a time", self.shown(id)));
        Ok(id)
    }

    fn declarations(&mut self) -> Result<()> {
        if let Some(time) = &self.claims.independent_variable {
            self.model.symbols.time = Some(self.name(time)?);
        }
        for declaration in &self.claims.declarations {
            match declaration.role {
                Role::Index => {}
                Role::Function => {
                    return Err(self.error(&declaration.name, "functions are not supported yet"));
                }
                _ => self.variable(declaration)?,
            }
        }
        if let Some(time) = self.model.symbols.time.clone()
            && self.model.symbols.find(&time).is_none()
            && let Some(id) = self.model.symbols.add(time, Kind::Scalar)
        {
            self.model.symbols.entry_mut(id).varies = true;
            self.model.mean(id, Meaning::Time);
        }
        Ok(())
    }

    /// A number, a vector, or a family of either, that is drawn.
    fn variable(&mut self, declaration: &Declaration) -> Result<()> {
        let latex = &declaration.name;
        let known = self.model.symbols.find(&self.name(latex)?).map(|(id, _)| id);
        if let Some(at) = self.early.iter().position(|early| Some(*early) == known) {
            self.early.remove(at);
            return Ok(());
        }
        let range = declaration.range.value.clone();
        let vector = ["\\vec", "\\mathbf", "\\boldsymbol", "\\bm"].iter().any(|accent| latex.value.contains(accent));
        let kind = if vector { Kind::Vector } else { Kind::Scalar };
        if vector && declaration.role == Role::Coordinate {
            return Err(self
                .error(latex, "a coordinate is a number")
                .help("declare a vector under \"varies with time\" or \"constants\""));
        }
        if let Range::Rigid { .. } | Range::FixedDirection = range {
            return self.moving_with_a_frame(declaration, kind);
        }
        if !vector && latex.value.contains("\\hat") {
            let vector = latex.value.replacen("\\hat", "\\vec", 1);
            return Err(self
                .error(latex, format!("{} would be a number here, and a hat marks a direction", latex.value))
                .help(format!("declare {vector}: {} is then its direction; or name it under \"axes\"", latex.value)));
        }
        let (meaning, varies) = match declaration.role {
            Role::Coordinate => (Meaning::Coordinate(self.model.coordinates.len()), true),
            Role::Constant => (Meaning::Constant(self.model.constants.len()), false),
            _ => (Meaning::Varying(self.model.varying.len()), true),
        };
        if vector && range != Range::Any {
            return Err(Error::at(&self.claims.source, declaration.range.span, "the range of a vector is \"any\""));
        }
        let id = self.add(latex, kind, meaning)?;
        let entry = self.model.symbols.entry_mut(id);
        entry.angle = is_angle(&range);
        entry.varies = varies;
        if declaration.role == Role::Coordinate && !entry.slots.is_empty() {
            return Err(self.error(latex, "families of coordinates are not supported yet"));
        }
        let variable = Variable { symbol: id, range, numbers: self.members(id) * if vector { 3 } else { 1 } };
        match declaration.role {
            Role::Coordinate => self.model.coordinates.push(variable),
            Role::Constant => self.model.constants.push(variable),
            _ => self.model.varying.push(variable),
        }
        Ok(())
    }

    /// How many members a family has, at most; one for a plain symbol.
    fn members(&self, id: SymbolId) -> usize {
        self.model.symbols.extents(id).into_iter().map(usize::from).product()
    }

    /// What is fixed in a turning frame, and the angular velocity of a frame that turns about a fixed direction.
    fn moving_with_a_frame(&mut self, declaration: &Declaration, kind: Kind) -> Result<()> {
        let latex = &declaration.name;
        if kind != Kind::Vector {
            return Err(self.error(latex, format!("{} must be a vector to turn", latex.value)));
        }
        match &declaration.range.value {
            Range::Rigid { turning_with, about } => {
                self.turning_with(turning_with, &declaration.range)?;
                let about = about.as_ref().filter(|about| !matches!(plain(about).as_str(), "vec0" | "0"));
                let about = about.map(|about| self.declared(about, &declaration.range)).transpose()?;
                let id = self.add(latex, kind, Meaning::Rigid(self.model.rigid.len()))?;
                let members = self.members(id);
                self.model.rigid.push(Rigid { symbol: id, about, members });
                self.model.symbols.entry_mut(id).varies = true;
            }
            _ => {
                if self.model.frame.is_some() {
                    return Err(self.error(latex, "only one thing can turn").help("it is declared before this"));
                }
                let id = self.add(latex, kind, Meaning::Frame(FrameQuantity::AngularVelocity))?;
                self.model.symbols.entry_mut(id).varies = true;
                self.model.frame = Some(Frame::FixedDirection);
            }
        }
        Ok(())
    }

    /// A vector that is declared in the claims file, perhaps further down.
    fn declared<T>(&mut self, latex: &str, place: &Spanned<T>) -> Result<SymbolId> {
        let latex = Spanned::new(latex.to_owned(), place.span);
        let name = self.name(&latex)?;
        if let Some((id, _)) = self.model.symbols.find(&name) {
            return Ok(id);
        }
        let later = self.claims.declarations.iter().find(|d| plain(&d.name.value) == plain(&latex.value));
        match later {
            Some(declaration) if !matches!(declaration.range.value, Range::Rigid { .. }) => {
                self.variable(declaration)?;
                self.early.extend(self.model.symbols.find(&name).map(|(id, _)| id));
            }
            _ => return Err(self.error(&latex, format!("{name} is not declared"))),
        }
        match self.model.symbols.find(&name) {
            Some((id, _)) => Ok(id),
            None => Err(self.error(&latex, format!("{name} is not declared"))),
        }
    }

    /// Makes this the angular velocity of the document's frame; a free vector becomes that of a frame that turns anyhow.
    fn turning_with<T>(&mut self, latex: &str, place: &Spanned<T>) -> Result<()> {
        let id = self.declared(latex, place)?;
        match self.model.meaning(id) {
            Some(Meaning::Frame(FrameQuantity::AngularVelocity)) => Ok(()),
            Some(Meaning::Varying(at))
                if self.model.frame.is_none() && self.model.symbols.entry(id).kind == Kind::Vector =>
            {
                let at = *at;
                self.model.varying.remove(at);
                for later in at..self.model.varying.len() {
                    let symbol = self.model.varying[later].symbol;
                    self.model.mean(symbol, Meaning::Varying(later));
                }
                self.model.mean(id, Meaning::Frame(FrameQuantity::AngularVelocity));
                self.model.frame = Some(Frame::Free);
                Ok(())
            }
            _ => Err(Error::at(&self.claims.source, place.span, format!("nothing can turn with {latex}")).help(
                "declare it under \"varies with time\", as \"any\" or \"fixed direction\"; only one thing can turn",
            )),
        }
    }

    fn axes(&mut self) -> Result<()> {
        let mut fixed = 0;
        for (latex, axes) in &self.claims.axes {
            match &axes.value {
                Axes::Fixed => {
                    let name = self.name(latex)?;
                    if name.subscript.iter().any(|token| self.model.symbols.index(token).is_some()) {
                        let id = self.add(latex, Kind::Vector, Meaning::World(Quantity::SpaceAxes))?;
                        self.three(latex, id)?;
                    } else {
                        if fixed == 3 {
                            return Err(self.error(latex, "there are three fixed axes, and this is a fourth"));
                        }
                        self.add(latex, Kind::Vector, Meaning::FixedAxis(fixed))?;
                        fixed += 1;
                    }
                }
                Axes::TurningWith(vector) => {
                    self.turning_with(vector, axes)?;
                    let id = self.add(latex, Kind::Vector, Meaning::Frame(FrameQuantity::Axes))?;
                    self.three(latex, id)?;
                    self.model.symbols.entry_mut(id).varies = true;
                }
            }
        }
        Ok(())
    }

    /// Refuses a name of axes that is no family of three.
    fn three(&self, latex: &Spanned<String>, id: SymbolId) -> Result<()> {
        match self.model.symbols.extents(id).as_slice() {
            [3] => Ok(()),
            _ => Err(self
                .error(latex, format!("{} are three vectors", latex.value))
                .help("give the name an index that runs over \"1..3\": \\hat e_a")),
        }
    }

    /// What the components of vectors are taken along, and names for them.
    fn components(&mut self) -> Result<()> {
        for (latex, components) in &self.claims.components {
            let name = self.name(latex)?;
            match &components.value {
                claims::Components::Along(axes) => {
                    // Either may be introduced by the notes: they are tied to each other when both are known.
                    let axes = self.name(axes)?;
                    self.model.components.push((name, axes));
                    self.model.tie_components();
                }
                claims::Components::Names(three) => {
                    let (id, indices) = self.model.symbols.find(&name).ok_or_else(|| {
                        self.error(latex, format!("{name} is not declared")).help("declare the vector itself as well")
                    })?;
                    for (k, component) in three.iter().enumerate() {
                        let vector = Node::Symbol { id, indices: indices.clone(), dots: 0 };
                        let vector = Box::new(Expr::new(vector, Span::default()));
                        let formula = Expr::new(Node::Component(vector, Index::Fixed(k as u8 + 1)), Span::default());
                        let id = self.add(component, Kind::Scalar, Meaning::Defined(Box::new(formula)))?;
                        self.model.symbols.entry_mut(id).varies = true;
                    }
                }
            }
        }
        Ok(())
    }

    fn continua(&mut self) -> Result<()> {
        for declared in &self.claims.continua {
            let at = self.model.continua.len();
            let point_name = self.name(&declared.point)?;
            if self.model.symbols.find(&point_name).is_none() {
                self.add(&declared.point, Kind::Vector, Meaning::Point)?;
            }
            let region = self.add(&declared.name, Kind::Scalar, Meaning::Region(at))?;
            let density = self.add(&declared.density, Kind::Scalar, Meaning::Density(at))?;
            for id in [region, density] {
                self.model.symbols.entry_mut(id).argument = Some(point_name.clone());
            }
            let entry = self.model.symbols.entry_mut(region);
            (entry.measure, entry.density) = (Some(declared.dimension), Some(density));
            let family = |builder: &Self, latex: &Spanned<String>| {
                let name = builder.name(latex)?;
                let found = builder.model.symbols.find(&name).map(|(id, _)| id);
                found.ok_or_else(|| builder.error(latex, format!("{name} is not declared")))
            };
            let particles = match &declared.particles {
                Some((mass, position)) => Some((family(self, mass)?, family(self, position)?)),
                None => None,
            };
            let mut solids = Vec::new();
            for solid in &declared.made_of {
                let mut sizes = Vec::new();
                for size in solid.size.value.split(',') {
                    let size = Spanned::new(size.trim().to_owned(), solid.size.span);
                    sizes.push(self.formula(&size)?);
                }
                let at = solid.at.as_ref().map(|at| self.formula(at)).transpose()?;
                solids.push(Piece { kind: solid.kind.value, sizes, at, hollow: solid.hollow });
            }
            let (dimension, uniform) = (declared.dimension, declared.uniform);
            self.model.continua.push(Continuum { region, dimension, particles, uniform, solids });
        }
        Ok(())
    }

    fn formula(&mut self, latex: &Spanned<String>) -> Result<Expr> {
        let macros = self.model.macros.clone();
        read_formula(&latex.value, &mut self.model.symbols, &macros)
            .map_err(|fault| formula_error(self.claims, latex, fault))
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
            self.model.mean(variable.symbol, Meaning::Coordinate(place));
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
        self.model.world = Some(Arc::new(world));
        Ok(())
    }

    fn missing(&self, place: &Spanned<String>, what: &str, name: &str) -> Error {
        self.error(place, format!("no declared symbol stands for the {what} {name} of \"{}\"", place.value))
            .help(format!("declare {name}, or say which symbol it is with \"read\""))
    }

    fn means(&mut self) -> Result<()> {
        for (latex, meaning) in &self.claims.means {
            if self.of_frame_or_particles(latex, meaning)? {
                continue;
            }
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

    /// Meanings that need no system: `angle turned with \vec\omega`; and those of particles, which wait until these are
    /// known.
    fn of_frame_or_particles(&mut self, latex: &Spanned<String>, meaning: &Spanned<String>) -> Result<bool> {
        if let Some(vector) = meaning.value.strip_prefix("angle turned with ") {
            self.turning_with(vector, meaning)?;
            if self.model.frame != Some(Frame::FixedDirection) {
                return Err(self
                    .error(meaning, format!("the direction of {vector} is not fixed"))
                    .help("declare it under \"varies with time\" as \"fixed direction\""));
            }
            let id = self.add(latex, Kind::Scalar, Meaning::Frame(FrameQuantity::Angle))?;
            let entry = self.model.symbols.entry_mut(id);
            (entry.varies, entry.angle) = (true, true);
            return Ok(true);
        }
        Ok(particles::quantity(meaning).is_some())
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
                self.model.mean(id, Meaning::World(Quantity::Momentum(place)));
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
}
