//! The meanings that the declarations of a claims file give: indices, constants, functions of time, axes, continua.

use crate::check::model::builder::{Builder, plain};
use crate::check::model::meaning::{
    Continuum, Frame, FrameQuantity, Meaning, Piece, Quantity, Rigid, Variable, is_angle,
};
use crate::formula::symbols::Name;
use crate::formula::{Expr, Index, Kind, Node, SymbolId};
use crate::latex::layout::values;
use crate::latex::names;
use crate::notes::claims;
use crate::notes::claims::{Axes, Count, Declaration, Range, Role, Spanned};
use crate::source::Span;
use crate::{Error, Result};

/// The largest number of members at which states are drawn first. The smallest is one less, so that a claim that is
/// true for one number only fails for the other.
const MOST_THINGS: u8 = 4;

impl Builder<'_> {
    pub(crate) fn indices(&mut self) -> Result<()> {
        for index in self.claims.declarations.iter().filter(|d| d.role == Role::Index) {
            let letter = self.name(&index.name)?.to_string();
            let wrong = || {
                Error::at(&self.claims.source, index.range.span, "an index must run from 1 to at most 9")
                    .help("write \"1..3\", or \"1..n\" for a family of n members")
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

    /// The symbol of a number of members: an integer, 3 or 4.
    fn count(&mut self, latex: &Spanned<String>) -> Result<SymbolId> {
        let name = self.name(latex)?;
        if let Some((known, _)) = self.model.symbols.find(&name) {
            return Ok(known);
        }
        let id = self.add(latex, Kind::Scalar, Meaning::Constant(self.model.constants.len()))?;
        let range = Range::Integer { low: 3, high: Count::Number(MOST_THINGS.into()) };
        self.model.constants.push(Variable::number(id, range));
        self.model.inferred.push(format!(
            "{} is the number of members of a family; the sampled states have 3 or {MOST_THINGS} members",
            self.shown(id)
        ));
        Ok(id)
    }

    pub(crate) fn declarations(&mut self) -> Result<()> {
        if let Some(time) = &self.claims.independent_variable {
            self.model.symbols.time = Some(self.name(time)?);
        }
        for declaration in &self.claims.declarations {
            match declaration.role {
                Role::Index => {}
                Role::Function => {}
                _ if declaration.is_formula => self.formula_as_name(declaration)?,
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
        // Their arguments are declared by now, unless a display or a definition introduces them.
        for declaration in self.claims.declarations.iter().filter(|declaration| declaration.role == Role::Function) {
            if self.has_its_arguments(declaration)? {
                self.any_function(declaration)?;
            }
        }
        Ok(())
    }

    /// Adds a drawn number or vector, or a family of either.
    fn variable(&mut self, declaration: &Declaration) -> Result<()> {
        let latex = &declaration.name;
        let known = self.model.symbols.find(&self.name(latex)?).map(|(id, _)| id);
        if let Some(at) = self.early.iter().position(|early| Some(*early) == known) {
            self.early.remove(at);
            return Ok(());
        }
        let range = declaration.range.value.clone();
        let vector = ["\\vec", "\\mathbf", "\\boldsymbol", "\\bm"].iter().any(|accent| latex.value.contains(accent));
        if range == Range::ImaginaryUnit {
            let name = self.name(latex)?;
            self.model.symbols.imaginary.push(name);
            return Ok(());
        }
        let kind = match range {
            Range::Matrix(3, 1) => Kind::Vector,
            Range::Matrix(rows, columns) => Kind::Matrix(rows, columns),
            Range::Complex => Kind::Complex,
            _ if vector => Kind::Vector,
            _ => Kind::Scalar,
        };
        let range = match range {
            Range::Matrix(..) | Range::Complex => Range::Any,
            range => range,
        };
        if kind != Kind::Scalar && declaration.role == Role::Coordinate {
            return Err(self
                .error(latex, "a coordinate must be a real number")
                .help("declare a vector, a matrix or a complex number under \"varies with time\" or \"constants\""));
        }
        if let Range::Rigid { .. } | Range::FixedDirection = range {
            return self.moving_with_a_frame(declaration, kind);
        }
        if !vector && latex.value.contains("\\hat") {
            let vector = latex.value.replacen("\\hat", "\\vec", 1);
            return Err(self
                .error(
                    latex,
                    format!("{} has a hat, which marks a direction, and is declared as a number", latex.value),
                )
                .help(format!("declare {vector}, and {} is its direction; or put it under \"axes\"", latex.value)));
        }
        let (meaning, varies) = match declaration.role {
            Role::Coordinate => (Meaning::Coordinate(self.model.coordinates.len()), true),
            Role::Constant => (Meaning::Constant(self.model.constants.len()), false),
            _ => (Meaning::Varying(self.model.varying.len()), true),
        };
        if vector && range != Range::Any {
            return Err(Error::at(
                &self.claims.source,
                declaration.range.span,
                "the range of a vector must be \"any\"",
            ));
        }
        let id = self.add(latex, kind, meaning)?;
        let entry = self.model.symbols.entry_mut(id);
        entry.angle = is_angle(&range);
        entry.varies = varies;
        if declaration.role == Role::Coordinate && !entry.slots.is_empty() {
            return Err(self.error(
                latex,
                "families of coordinates are not supported; declare each coordinate by itself, such as x_1 and x_2",
            ));
        }
        let variable = Variable { symbol: id, range, numbers: self.members(id) * kind.numbers() };
        match declaration.role {
            Role::Coordinate => self.model.coordinates.push(variable),
            Role::Constant => self.model.constants.push(variable),
            _ => self.model.varying.push(variable),
        }
        Ok(())
    }

    /// Adds a formula that stands for one name: a number or a vector.
    fn formula_as_name(&mut self, declaration: &Declaration) -> Result<()> {
        let latex = &declaration.name;
        let items = names::value(&latex.value).ok_or_else(|| {
            self.error(latex, format!("{} cannot be declared as one name", latex.value)).help(
                "formulas that can: a mean value \\langle E \\rangle, a name with arguments V(\\vec r), a derivative, a sum or an integral",
            )
        })?;
        if declaration.range.value == Range::Rate {
            return match self.model.macros.values.add_rate(&items) {
                true => Ok(()),
                false => Err(self
                    .error(latex, format!("{} is not a differential, so it cannot be declared as a rate", latex.value))
                    .help("write a d before one name, such as dU")),
            };
        }
        if declaration.range.value == Range::Given {
            self.model.macros.values.add(&items);
            return Ok(());
        }
        let is_vector = matches!(declaration.range.value, Range::Matrix(3, 1));
        let kind = if is_vector { Kind::Vector } else { Kind::Scalar };
        let moves = declaration.role == Role::VariesWithTime;
        let name = Name::plain(values::text_of(&items));
        let id = self.model.symbols.add(name, kind).ok_or_else(|| {
            self.error(latex, format!("{} is declared twice", latex.value)).help("remove one of the two declarations")
        })?;
        let variables = if moves { &mut self.model.varying } else { &mut self.model.constants };
        let at = variables.len();
        variables.push(Variable { symbol: id, range: Range::Any, numbers: kind.numbers() });
        let entry = self.model.symbols.entry_mut(id);
        (entry.varies, entry.unread) = (moves, true);
        self.model.mean(id, if moves { Meaning::Varying(at) } else { Meaning::Constant(at) });
        self.model.macros.values.add(&items);
        Ok(())
    }

    /// The largest number of members of a family; one for a plain symbol.
    fn members(&self, id: SymbolId) -> usize {
        self.model.symbols.extents(id).into_iter().map(usize::from).product()
    }

    /// Adds a vector that is fixed in a turning frame, or the angular velocity of a frame that turns about a fixed
    /// direction.
    fn moving_with_a_frame(&mut self, declaration: &Declaration, kind: Kind) -> Result<()> {
        let latex = &declaration.name;
        if kind != Kind::Vector {
            return Err(self.error(latex, format!("{} turns with a frame, so it must be a vector", latex.value)));
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
                    return Err(self
                        .error(latex, "only one rotating frame is supported")
                        .help("remove this declaration, or the earlier one"));
                }
                let id = self.add(latex, kind, Meaning::Frame(FrameQuantity::AngularVelocity))?;
                self.model.symbols.entry_mut(id).varies = true;
                self.model.frame = Some(Frame::FixedDirection);
            }
        }
        Ok(())
    }

    /// A vector that is declared in the claims file, possibly further down.
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
            _ => return Err(self.undeclared(&latex)),
        }
        match self.model.symbols.find(&name) {
            Some((id, _)) => Ok(id),
            None => Err(self.undeclared(&latex)),
        }
    }

    /// Makes this the angular velocity of the document's frame. A free vector becomes that of a frame that turns
    /// freely.
    pub(crate) fn turning_with<T>(&mut self, latex: &str, place: &Spanned<T>) -> Result<()> {
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
            _ => Err(Error::at(
                &self.claims.source,
                place.span,
                format!("{latex} is not the angular velocity of a frame"),
            )
            .help("declare it under \"varies with time\", as \"any\" or \"fixed direction\"; only one is supported")),
        }
    }

    pub(crate) fn axes(&mut self) -> Result<()> {
        let mut fixed = 0;
        for (latex, axes) in &self.claims.axes {
            match &axes.value {
                Axes::Fixed => {
                    let name = self.name(latex)?;
                    if name.subscript.iter().any(|token| self.model.symbols.index(token).is_some()) {
                        let id = self.add(latex, Kind::Vector, Meaning::System(Quantity::SpaceAxes))?;
                        self.three(latex, id)?;
                    } else {
                        if fixed == 3 {
                            return Err(self.error(latex, "this is a fourth fixed axis, and there are only three"));
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

    /// Rejects a name of axes that is not a family of three vectors.
    fn three(&self, latex: &Spanned<String>, id: SymbolId) -> Result<()> {
        match self.model.symbols.extents(id).as_slice() {
            [3] => Ok(()),
            _ => Err(self
                .error(latex, format!("{} must be a family of three vectors", latex.value))
                .help("give the name an index that runs over \"1..3\": \\hat e_a")),
        }
    }

    /// Adds the axes of components, and names for components.
    pub(crate) fn components(&mut self) -> Result<()> {
        for (latex, components) in &self.claims.components {
            let name = self.name(latex)?;
            match &components.value {
                claims::Components::Along(axes) => {
                    // The notes may define either of them, so they are connected when both are known.
                    let axes = self.name(axes)?;
                    self.model.components.push((name, axes));
                    self.model.tie_components();
                }
                claims::Components::Names(three) => {
                    let known = self.model.symbols.find(&name);
                    let (id, indices) = known.ok_or_else(|| self.undeclared(latex))?;
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

    pub(crate) fn continua(&mut self) -> Result<()> {
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
                found.ok_or_else(|| builder.undeclared(latex))
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
}
