//! What the symbols of a document mean: the declarations of the claims file, mapped to the system that they describe.
//!
//! The model connects the printed side with the derived side. It owns the table of names. For each name it knows what
//! gives its value: a coordinate, a parameter, a quantity that the Lagrangian determines, or a formula that the prose
//! or an earlier equation defines.
//!
//! Offers [`Model`], built by [`build`]; [`claim`], the claims and hypotheses between two formulas; [`sampling`] and
//! [`state_cache`], which the samplers share. Knows `formula`, `latex`, `notes`, `mechanics` and `systems`, and no
//! other folder of `check`.

use std::sync::Arc;

use crate::formula::symbols::{Components, Name};
use crate::formula::{Expr, SymbolId, Symbols};
use crate::latex::{Macros, typeset};
use crate::mechanics::System;
use crate::notes::claims::{Range, Spanned};
use crate::source::Span;

use crate::check::model::claim::{Hypothesis, Law, Unread};
use crate::check::model::meaning::{Continuum, Frame, Meaning, Rigid, Variable};
use crate::check::model::state_cache::StateCache;

pub(crate) mod build;
pub(crate) mod builder;
pub(crate) mod claim;
pub(crate) mod claims_error;
pub(crate) mod declarations;
pub(crate) mod free_symbols;
pub(crate) mod functions;
pub(crate) mod independent_values;
pub(crate) mod meaning;
pub(crate) mod order;
pub(crate) mod particles;
pub(crate) mod sampling;
pub(crate) mod sizes;
pub(crate) mod state_cache;
pub(crate) mod system;

/// The Lagrangian that the notes define, from which the motion follows.
#[derive(Clone, Debug)]
pub struct PrintedLagrangian {
    /// Its name.
    pub lagrangian: Name,
    /// The name of the system: that of the notes.
    pub system: String,
    /// The name of the potential energy U, where L = T − U.
    pub potential: Option<Name>,
    /// Rayleigh's dissipation function.
    pub dissipation: Option<Expr>,
    /// The generalized forces beside what L gives: the place of the coordinate, and the force.
    pub forces: Vec<(usize, Expr)>,
    /// The constraints that L does not contain: the place of the multiplier, and the formula that vanishes.
    pub constraints: Vec<(usize, Expr)>,
    /// The place in the claims file.
    pub place: Span,
}

/// A name that the claims file says is the frequency or the period of small oscillations about a place, or about a steady motion.
#[derive(Clone, Debug)]
pub struct Frequency {
    /// Its name.
    pub name: Name,
    /// The equations that give the coordinates their place, in LaTeX; coordinates that are not named are 0.
    pub about: Option<Spanned<String>>,
    /// Whether it is the period 2π/ω.
    pub is_period: bool,
}

/// The Hamiltonian that the notes define, from which the motion follows.
#[derive(Clone, Debug)]
pub struct PrintedHamiltonian {
    /// Its name.
    pub hamiltonian: Name,
    /// The place in the claims file.
    pub place: Span,
}

/// The symbols of a document and what they mean.
#[derive(Clone)]
pub struct Model {
    /// The names.
    pub symbols: Symbols,
    /// The meaning of each, by [`SymbolId`]; none for a symbol that was read but not yet defined.
    pub meanings: Vec<Option<Meaning>>,
    /// The traced system, if the claims name one.
    pub system: Option<Arc<System>>,
    /// The names of the Lagrangian that the notes print, if the claims file says so.
    pub printed_lagrangian: Option<PrintedLagrangian>,
    /// The name of the Hamiltonian that the notes print, if the claims file says so.
    pub printed_hamiltonian: Option<PrintedHamiltonian>,
    /// The coordinates of the system in its order; without a system, the declared ones.
    pub coordinates: Vec<Variable>,
    /// All constants, with the parameters of the system among them.
    pub constants: Vec<Variable>,
    /// The parameters of the system in its order, as places among the constants.
    pub parameters: Vec<usize>,
    /// Free functions of time.
    pub varying: Vec<Variable>,
    /// The turning frame, if there is one.
    pub frame: Option<Frame>,
    /// The vectors that are fixed in the turning frame.
    pub rigid: Vec<Rigid>,
    /// The names of vectors whose components are taken along named axes, with the names of the axes.
    pub components: Vec<(Name, Name)>,
    /// The bodies that fill a region.
    pub continua: Vec<Continuum>,
    /// The laws that all motions obey.
    pub laws: Vec<Law>,
    /// The constraints that multipliers of the Lagrangian impose on all motions: f = 0 and ḟ = 0.
    pub constraints: Vec<Hypothesis>,
    /// The names of the normal frequencies of the Lagrangian in the notes.
    pub normal_frequencies: Vec<Name>,
    /// The names of the normal frequencies of several coordinates, each of which a display defines.
    pub modes: Vec<Name>,
    /// The names of the frequencies of small oscillations about a place, which displays define.
    pub frequencies: Vec<Frequency>,
    /// The macros of the author.
    pub macros: Macros,
    /// Names of the claims file whose definition stands in a display that cannot be read.
    pub unread_names: Vec<Unread>,
    /// Laws that stand in a display that cannot be read.
    pub unread_laws: Vec<Unread>,
    /// What was inferred, as shown in the report.
    pub inferred: Vec<String>,
    /// The sampled states that are known.
    pub state_cache: StateCache,
}

impl Model {
    /// The model of these names, none of which has a meaning yet.
    pub fn empty(symbols: Symbols, macros: Macros) -> Model {
        Model {
            symbols,
            meanings: Vec::new(),
            system: None,
            printed_lagrangian: None,
            printed_hamiltonian: None,
            coordinates: Vec::new(),
            constants: Vec::new(),
            parameters: Vec::new(),
            varying: Vec::new(),
            frame: None,
            rigid: Vec::new(),
            components: Vec::new(),
            continua: Vec::new(),
            laws: Vec::new(),
            constraints: Vec::new(),
            normal_frequencies: Vec::new(),
            modes: Vec::new(),
            frequencies: Vec::new(),
            macros,
            unread_names: Vec::new(),
            unread_laws: Vec::new(),
            inferred: Vec::new(),
            state_cache: StateCache::default(),
        }
    }

    /// The meaning of a symbol, if it has one yet.
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

    /// Whether a symbol is a coordinate, also one that laws move.
    pub fn is_coordinate(&self, id: SymbolId) -> bool {
        matches!(self.meaning(id), Some(Meaning::Coordinate(_))) || self.symbols.canonical.iter().any(|(q, _)| *q == id)
    }

    /// Makes the coordinates free functions of the time, which laws move.
    pub fn let_coordinates_vary(&mut self) {
        for coordinate in std::mem::take(&mut self.coordinates) {
            if !self.symbols.canonical.iter().any(|(q, _)| *q == coordinate.symbol) {
                self.symbols.canonical.push((coordinate.symbol, Vec::new()));
            }
            self.mean(coordinate.symbol, Meaning::Varying(self.varying.len()));
            self.varying.push(coordinate);
        }
    }

    /// Whether a system or laws determine the motion.
    pub fn has_motion(&self) -> bool {
        self.system.is_some() || !self.laws.is_empty()
    }

    /// Whether a formula depends on one of these symbols, through definitions too.
    pub fn depends_on(&self, expr: &Expr, symbols: &[SymbolId]) -> bool {
        expr.symbols().iter().any(|(id, _)| self.symbol_depends_on(*id, symbols))
    }

    /// Whether a name is defined by itself, directly or through other definitions. It ends for any definitions.
    pub(crate) fn is_defined_by_itself(&self, id: SymbolId) -> bool {
        let mut seen = Vec::new();
        let mut next = vec![id];
        while let Some(name) = next.pop() {
            let Some(Meaning::Defined(formula)) = self.meaning(name) else { continue };
            for (other, _) in formula.symbols() {
                if other == id {
                    return true;
                }
                if !seen.contains(&other) {
                    seen.push(other);
                    next.push(other);
                }
            }
        }
        false
    }

    /// Whether a formula contains the time, through definitions too.
    pub(crate) fn contains_time(&self, formula: &Expr) -> bool {
        formula.symbols().iter().any(|(id, _)| match self.meaning(*id) {
            Some(Meaning::Time) => true,
            Some(Meaning::Defined(inner)) => self.contains_time(inner),
            _ => false,
        })
    }

    /// Whether a formula consists of drawn symbols and definitions only, without quantities of a system or a frame.
    pub fn is_plain(&self, expr: &Expr) -> bool {
        expr.symbols().iter().all(|(id, _)| match self.meaning(*id) {
            Some(Meaning::Constant(_) | Meaning::Varying(_) | Meaning::Coordinate(_) | Meaning::FixedAxis(_)) => true,
            Some(Meaning::Defined(formula)) => self.is_plain(formula),
            _ => false,
        })
    }

    pub(crate) fn symbol_depends_on(&self, id: SymbolId, symbols: &[SymbolId]) -> bool {
        symbols.contains(&id)
            || match self.meaning(id) {
                Some(Meaning::Defined(formula)) => self.depends_on(formula, symbols),
                Some(Meaning::Particles(_, _, masses, positions)) => {
                    self.depends_on(masses, symbols) || self.depends_on(positions, symbols)
                }
                Some(Meaning::Rigid(at)) => self.rigid[*at].about.is_some_and(|about| symbols.contains(&about)),
                _ => self.symbols.entry(id).members.iter().any(|member| self.symbol_depends_on(*member, symbols)),
            }
    }

    /// The names that formulas define, each as an equation in LaTeX.
    pub fn definitions(&self) -> Vec<String> {
        let formula = |id| match self.meaning(id) {
            Some(Meaning::Defined(formula)) => Some(formula),
            _ => None,
        };
        let written = self.symbols.iter().filter(|(_, entry)| !entry.hidden && entry.slots.is_empty());
        let pairs = written.filter_map(|(id, entry)| Some((entry, formula(id)?)));
        pairs.map(|(entry, formula)| format!("{} = {}", entry.name, typeset(formula, &self.symbols))).collect()
    }

    /// Gives a symbol its defining formula.
    pub fn define(&mut self, id: SymbolId, formula: Expr) {
        self.mean(id, Meaning::Defined(Box::new(formula)));
        self.tie_components();
    }

    /// Gives a symbol that a formula defines another formula.
    pub fn redefine(&mut self, id: SymbolId, formula: Expr) {
        let squared = self.symbols.entry(id).squared;
        self.symbols.mark_defined(id, &formula, squared);
        self.define(id, formula);
    }

    /// Records in the table of names along which axes the components of vectors are taken. Returns false while axes are
    /// missing.
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

    /// The range from which the values of an independent symbol are drawn.
    pub fn range(&self, id: SymbolId) -> Range {
        match self.meaning(id) {
            Some(Meaning::Coordinate(i)) => self.coordinates[*i].range.clone(),
            Some(Meaning::Constant(i)) => self.constants[*i].range.clone(),
            Some(Meaning::Varying(i)) => self.varying[*i].range.clone(),
            _ => Range::Any,
        }
    }
}
