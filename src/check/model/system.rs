//! The symbols of a system: its coordinates and parameters mapped to declared names, and the meanings under `"means"`.

use crate::check::model::builder::{Builder, plain};
use crate::check::model::meaning::{Frame, FrameQuantity, MEANINGS, Meaning, Quantity, Variable};
use crate::check::model::{Frequency, PrintedHamiltonian, PrintedLagrangian, particles};
use crate::formula::symbols::Entry;
use crate::formula::{Kind, SymbolId, text};
use crate::latex::{derivative_name, names};
use crate::mechanics::rotations::Axis;
use crate::notes::claims::{Range, Spanned};
use crate::suggest::in_json;
use crate::systems::Registry;
use crate::{Error, Result, suggest};
use std::sync::Arc;

/// The meaning that is completed by a place, as in `frequency of small oscillations about \theta = \theta_0`.
const SMALL_OSCILLATIONS: [&str; 2] = ["frequency of small oscillations", "period of small oscillations"];

impl Builder<'_> {
    /// Maps the declared coordinates and constants to those of the system, by name or by `"read"`.
    pub(crate) fn system(&mut self, registry: &Registry) -> Result<()> {
        let Some(reference) = &self.claims.system else { return Ok(()) };
        let lagrangian = registry.get(&reference.name.value).ok_or_else(|| {
            let error = self.error(&reference.name, format!("there is no system \"{}\"", reference.name.value));
            match suggest::nearest(&reference.name.value, registry.names()) {
                Some(near) => error.help(format!("did you mean \"{near}\"?")),
                None => error.help(suggest::systems(registry.names())),
            }
        })?;
        let system = lagrangian.trace()?;
        for (target, symbol) in &reference.read {
            let known = system.coordinates().iter().chain(system.parameters());
            if !known.clone().any(|name| plain(name) == plain(&target.value)) {
                let names: Vec<&str> = known.map(String::as_str).collect();
                return Err(self
                    .error(target, format!("the system \"{}\" has no \"{}\"", system.name(), target.value))
                    .help(format!("it has {}", names.join(", "))));
            }
            let name = self.name(symbol)?;
            if self.model.symbols.find(&name).is_none() {
                return Err(self.undeclared(symbol));
            }
        }
        let reads = |printed: &str, wanted: &str| {
            let renamed = reference.read.iter().find(|(_, symbol)| plain(&symbol.value) == plain(printed));
            plain(renamed.map_or(printed, |(target, _)| target.value.as_str())) == plain(wanted)
        };
        let mut map = Vec::new();
        let mut coordinates = Vec::new();
        for wanted in system.coordinates() {
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
                let message = format!("{name} is not a coordinate of \"{}\"", system.name());
                return Err(Error::at(&self.claims.source, span, message).help(format!(
                    "the system already has all its coordinates; declare {name} under \"constants\" or \"varies with \
                     time\""
                )));
            }
        }
        for (place, variable) in coordinates.iter().enumerate() {
            self.model.mean(variable.symbol, Meaning::Coordinate(place));
        }
        self.model.coordinates = coordinates;
        for wanted in system.parameters() {
            let found = self.model.constants.iter().position(|v| reads(&self.model.name(v.symbol), wanted));
            let place = found.ok_or_else(|| self.missing(&reference.name, "parameter", wanted))?;
            let symbol = self.model.constants[place].symbol;
            map.push(format!("{} is the parameter {}", self.shown(symbol), text::plain(wanted)));
            self.model.parameters.push(place);
        }
        self.model.inferred.push(format!("the system is {}: {}", system.name(), map.join(", ")));
        self.model.system = Some(Arc::new(system));
        Ok(())
    }

    fn missing(&self, place: &Spanned<String>, what: &str, name: &str) -> Error {
        let add = in_json(name);
        let role = if what == "parameter" { "constants" } else { "coordinates" };
        self.error(place, format!("no declared symbol is the {what} {name} of \"{}\"", place.value)).help(format!(
            "add {add}: \"any\" under \"{role}\"; or, if the notes have another name for it, say which: \"system\": {{ \
                 \"name\": \"{}\", \"read\": {{ {add}: \"…\" }} }}",
            place.value
        ))
    }

    pub(crate) fn means(&mut self) -> Result<()> {
        for (latex, meaning) in &self.claims.means {
            if self.of_frame_or_particles(latex, meaning)? {
                continue;
            }
            if self.is_printed() && self.printed(latex, meaning)? {
                continue;
            }
            if self.is_printed_hamiltonian() && self.of_the_hamiltonian(latex, meaning)? {
                continue;
            }
            let quantity = self.quantity(meaning)?;
            let name = self.name(latex)?;
            let slots = name.subscript.iter().filter(|token| self.model.symbols.index(token).is_some()).count();
            let kind = match (quantity, slots) {
                (Quantity::RotationMatrix, 0) => Kind::Matrix(3, 3),
                (Quantity::RotationMatrix, 2) | (Quantity::AngularVelocity, 1) => Kind::Scalar,
                (Quantity::AngularVelocity, 0) => Kind::Vector,
                (Quantity::BodyAxes | Quantity::SpaceAxes, 1) => Kind::Vector,
                (Quantity::RotationMatrix | Quantity::AngularVelocity, _)
                | (Quantity::BodyAxes | Quantity::SpaceAxes, _) => {
                    return Err(self
                        .error(latex, format!("{name} has {slots} indices, which does not fit the {}", meaning.value))
                        .help("declare the letters of its subscript under \"indices\""));
                }
                (_, 0) => Kind::Scalar,
                _ => return Err(self.error(latex, format!("{name} has an index, but the {} has none", meaning.value))),
            };
            let id = self.add(latex, kind, Meaning::System(quantity))?;
            let entry = self.model.symbols.entry_mut(id);
            (entry.varies, entry.derived) = (true, true);
            entry.momentum = matches!(quantity, Quantity::Momentum(_));
            if quantity == Quantity::Lagrangian {
                self.derivatives_of_the_lagrangian(latex)?;
            }
        }
        Ok(())
    }

    /// Whether the notes themselves define the Lagrangian.
    fn is_printed(&self) -> bool {
        self.claims.system.is_none() && self.claims.means.iter().any(|(_, meaning)| meaning.value == "Lagrangian")
    }

    /// Whether the notes themselves define the Hamiltonian, and no Lagrangian.
    fn is_printed_hamiltonian(&self) -> bool {
        let has = |what: &str| self.claims.means.iter().any(|(_, meaning)| meaning.value == what);
        self.claims.system.is_none() && has("Hamiltonian") && !has("Lagrangian")
    }

    /// Notes the name of a Hamiltonian that the notes define, and its momenta; returns true for these.
    fn of_the_hamiltonian(&mut self, latex: &Spanned<String>, meaning: &Spanned<String>) -> Result<bool> {
        let name = self.name(latex)?;
        if meaning.value == "Hamiltonian" {
            self.model.printed_hamiltonian = Some(PrintedHamiltonian { hamiltonian: name, place: latex.span });
            return Ok(true);
        }
        let Some(coordinate) = meaning.value.strip_prefix("momentum of ") else { return Ok(false) };
        let known = self.model.coordinates.iter().map(|known| known.symbol);
        let mut known = known.filter(|id| plain(&self.model.name(*id)) == plain(coordinate));
        let q = known.next().ok_or_else(|| self.no_coordinate(meaning, coordinate))?;
        let id = self.add(latex, Kind::Scalar, Meaning::Varying(self.model.varying.len()))?;
        let entry = self.model.symbols.entry_mut(id);
        (entry.varies, entry.momentum) = (true, true);
        self.model.varying.push(Variable::number(id, Range::Any));
        self.model.symbols.canonical.push((q, vec![id]));
        Ok(true)
    }

    /// Notes the names of a Lagrangian that the notes define, and of its parts; returns true for these, which displays
    /// introduce.
    fn printed(&mut self, latex: &Spanned<String>, meaning: &Spanned<String>) -> Result<bool> {
        let name = self.name(latex)?;
        match meaning.value.as_str() {
            "Lagrangian" => {
                let potential = self.claims.means.iter().find(|(_, meaning)| meaning.value == "potential energy");
                let potential = potential.map(|(latex, _)| self.name(latex)).transpose()?;
                let place = latex.span;
                let (dissipation, forces, constraints) = (None, Vec::new(), Vec::new());
                let stem = self.claims.notes_path().file_stem().map(|stem| stem.to_string_lossy().into_owned());
                let system = stem.unwrap_or_else(|| "the notes".to_owned());
                self.model.printed_lagrangian = Some(PrintedLagrangian {
                    lagrangian: name,
                    system,
                    potential,
                    dissipation,
                    forces,
                    constraints,
                    place,
                });
                self.derivatives_of_the_lagrangian(latex)?;
                Ok(true)
            }
            "kinetic energy" | "potential energy" => Ok(true),
            "normal frequency" => {
                if self.model.symbols.find(&name).is_some() {
                    let twice = self.error(latex, format!("{} is declared twice", latex.value));
                    return Err(twice.help("remove one of the two declarations"));
                }
                match self.model.coordinates.len() {
                    0 | 1 => self.model.normal_frequencies.push(name),
                    _ => self.model.modes.push(name),
                }
                Ok(true)
            }
            meant if SMALL_OSCILLATIONS.iter().any(|words| meant.starts_with(words)) => {
                let is_period = meant.starts_with(SMALL_OSCILLATIONS[1]);
                let rest = &meant[SMALL_OSCILLATIONS[usize::from(is_period)].len()..];
                // Oscillations in another potential are not those of the Lagrangian: the name is one that a display defines.
                if !rest.contains(" in ") {
                    let about = rest.split_once(" about ").map(|(_, about)| about);
                    let about = about.map(|about| about.split(" at fixed ").next().unwrap_or(about).trim().to_owned());
                    let about = about.map(|about| Spanned::new(about, meaning.span));
                    self.model.frequencies.push(Frequency { name, about, is_period });
                }
                Ok(true)
            }
            "rotation matrix" | "angular velocity" | "body axes" | "space axes" => Err(self
                .error(meaning, format!("a Lagrangian that the notes define has no {}", meaning.value))
                .help("name a system of a rigid body under \"system\"")),
            _ => Ok(false),
        }
    }

    /// Adds ∂L/∂q and ∂L/∂q̇ of each coordinate, as names that the reader gives to them.
    fn derivatives_of_the_lagrangian(&mut self, latex: &Spanned<String>) -> Result<()> {
        let above = self.name(latex)?.to_string();
        for place in 0..self.model.coordinates.len() {
            let coordinate = self.model.symbols.entry(self.model.coordinates[place].symbol).name.clone();
            for (dots, quantity) in [(0, Quantity::Force(place)), (1, Quantity::Momentum(place))] {
                let Some(below) = names::with_dots(&coordinate, dots) else { continue };
                let name = derivative_name(&above, &below.to_string());
                if let Some(id) = self.model.symbols.add(name, Kind::Scalar) {
                    let entry = self.model.symbols.entry_mut(id);
                    (entry.varies, entry.derived) = (true, true);
                    self.model.mean(id, Meaning::System(quantity));
                }
            }
        }
        Ok(())
    }

    /// Adds a meaning that needs no system, such as `angle turned with \vec\omega`. Returns true for these, and for
    /// quantities of particles, which are read later.
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

    /// The error of a name that is no coordinate, with those that are.
    fn no_coordinate(&self, place: &Spanned<String>, name: &str) -> Error {
        let known: Vec<String> = self.model.coordinates.iter().map(|known| self.shown(known.symbol)).collect();
        let error = self.error(place, format!("{name} is not a coordinate"));
        match known.is_empty() {
            true => error.help("declare it under \"coordinates\""),
            false => error.help(format!("the coordinates are {}", known.join(", "))),
        }
    }

    fn quantity(&self, meaning: &Spanned<String>) -> Result<Quantity> {
        let nearest = suggest::nearest(&meaning.value, MEANINGS.iter().map(|(word, _)| *word));
        let is_misspelt = nearest.is_some_and(|near| near != meaning.value);
        if self.model.system.is_none() && !self.is_printed() && !is_misspelt {
            return Err(self.error(meaning, format!("\"{}\" needs a system, and there is none", meaning.value)).help(
                "name one under \"system\", or say which name in the notes is the Lagrangian or the Hamiltonian: \"means\": \
                 { \"L\": \"Lagrangian\" }",
            ));
        }
        if let Some(coordinate) = meaning.value.strip_prefix("momentum of ") {
            let place =
                self.model.coordinates.iter().position(|v| plain(&self.model.name(v.symbol)) == plain(coordinate));
            return place.map(Quantity::Momentum).ok_or_else(|| self.no_coordinate(meaning, coordinate));
        }
        let found = MEANINGS.iter().find(|(word, _)| *word == meaning.value).map(|(_, quantity)| *quantity);
        let quantity = found.ok_or_else(|| {
            let of_place = SMALL_OSCILLATIONS.map(|word| format!("{word} about x = 0"));
            let mut words: Vec<&str> = MEANINGS.iter().map(|(word, _)| *word).collect();
            words.extend(of_place.iter().map(String::as_str));
            words.extend(["normal frequency", "dissipation function", "inertia tensor of m_i at \\vec r_i"]);
            let begins = words.iter().find(|word| !meaning.value.is_empty() && word.starts_with(meaning.value.trim()));
            if let Some(word) = begins {
                let error = self.error(meaning, format!("\"{}\" is not a known meaning", meaning.value));
                return error.help(format!("did you mean {}?", in_json(word)));
            }
            let error = self.error(meaning, format!("\"{}\" is not a known meaning", meaning.value));
            match suggest::nearest(&meaning.value, words.iter().copied()) {
                Some(near) => error.help(format!("did you mean \"{near}\"?")),
                None => error.help(format!("the meanings are {}, momentum of q", words.join(", "))),
            }
        })?;
        let Some(system) = &self.model.system else { return Ok(quantity) };
        let lacks = match quantity {
            Quantity::KineticEnergy | Quantity::PotentialEnergy if !system.has_potential() => Some("potential energy"),
            Quantity::RotationMatrix | Quantity::AngularVelocity | Quantity::BodyAxes | Quantity::SpaceAxes
                if !system.has_orientation() =>
            {
                Some("orientation")
            }
            _ => None,
        };
        match lacks {
            Some(what) => Err(self.error(meaning, format!("the system \"{}\" has no {what}", system.name()))),
            None => Ok(quantity),
        }
    }

    /// Adds `p_q` as the momentum of each coordinate q, unless it is declared.
    pub(crate) fn momenta(&mut self) {
        if self.model.system.is_none() && !self.is_printed() {
            return;
        }
        for place in 0..self.model.coordinates.len() {
            let declared = |(id, _): &(SymbolId, &Entry)| {
                matches!(self.model.meaning(*id), Some(Meaning::System(Quantity::Momentum(at))) if *at == place)
                    && !self.model.name(*id).starts_with("\\frac")
            };
            let mut known: Vec<SymbolId> = self.model.symbols.iter().filter(declared).map(|(id, _)| id).collect();
            let symbol = self.model.coordinates[place].symbol;
            let coordinate = self.model.name(symbol);
            let Some((name, 0)) = names::parse(&format!("p_{{{coordinate}}}")) else { continue };
            let shown = name.to_string();
            if let Some(id) = self.model.symbols.add(name, Kind::Scalar) {
                let entry = self.model.symbols.entry_mut(id);
                (entry.varies, entry.derived, entry.momentum) = (true, true, true);
                self.model.mean(id, Meaning::System(Quantity::Momentum(place)));
                let (shown, coordinate) = (text::plain(&shown), text::plain(&coordinate));
                self.model.inferred.push(format!("{shown} is the momentum of {coordinate}"));
                known.push(id);
            }
            self.model.symbols.canonical.push((symbol, known));
        }
    }

    pub(crate) fn rotations(&mut self) -> Result<()> {
        for (latex, sense) in &self.claims.rotations {
            let name = self.name(latex)?;
            let axis = match name.subscript.as_slice() {
                [axis] if axis == "x" || axis == "1" => Axis::X,
                [axis] if axis == "y" || axis == "2" => Axis::Y,
                [axis] if axis == "z" || axis == "3" => Axis::Z,
                _ => return Err(self.error(latex, "a rotation must name its axis as a subscript: \\mathbf{R}_z")),
            };
            self.add(latex, Kind::Rotation, Meaning::Rotation(axis, sense.value))?;
        }
        Ok(())
    }
}
