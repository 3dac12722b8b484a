//! What the symbols of a document mean: the claims file's declarations, tied to the system that they describe.
//!
//! The model is where the printed side and the derived side meet. It owns the table of names and knows for each what
//! gives it its value: a coordinate, a parameter, something that the Lagrangian determines, a formula that the prose or
//! an earlier equation defines.

use std::sync::Arc;

use crate::formula::symbols::{Components, Name};
use crate::formula::{Expr, SymbolId, Symbols};
use crate::latex::Macros;
use crate::mechanics::System;
use crate::notes::claims::Range;

use crate::check::model::claim::{Law, Lost};
use crate::check::model::meaning::{Continuum, Frame, Meaning, Rigid, Variable};
use crate::check::model::states::StateCache;

pub(crate) mod build;
pub(crate) mod builder;
pub(crate) mod claim;
pub(crate) mod claims_error;
pub(crate) mod declarations;
pub(crate) mod free_symbols;
pub(crate) mod meaning;
pub(crate) mod order;
pub(crate) mod particles;
pub(crate) mod sizes;
pub(crate) mod states;
pub(crate) mod system;

/// The symbols of a document and what they mean.
#[derive(Clone)]
pub struct Model {
    /// The names.
    pub symbols: Symbols,
    /// What each means, by [`SymbolId`]; a symbol that was read and not yet explained has none.
    pub meanings: Vec<Option<Meaning>>,
    /// What is true, if the claims name a system.
    pub system: Option<Arc<System>>,
    /// The world's coordinates in its order; without a system, the declared ones.
    pub coordinates: Vec<Variable>,
    /// All constants; the system's parameters are among them.
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
    pub drawn: StateCache,
}

impl Model {
    /// The model of these names, none of which means anything yet.
    pub fn empty(symbols: Symbols, macros: Macros) -> Model {
        Model {
            symbols,
            meanings: Vec::new(),
            system: None,
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
            drawn: StateCache::default(),
        }
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
        self.system.is_some() || !self.laws.is_empty()
    }

    /// Whether a formula depends on one of these symbols, through definitions too.
    pub fn depends_on(&self, expr: &Expr, symbols: &[SymbolId]) -> bool {
        expr.symbols().iter().any(|(id, _)| self.stands_on(*id, symbols))
    }

    /// Whether a formula is made of drawn symbols and definitions alone, of nothing that a system or a frame determines.
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
