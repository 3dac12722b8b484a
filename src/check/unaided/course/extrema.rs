//! The place where a quantity is largest or smallest: "the amplitude is largest at `\omega_r^2 = …`", after `X = …`.
//!
//! Such a display gives a name a formula, which would be a definition otherwise. Where the quantity of which the words speak has no
//! slope at this place, the display follows. It is called wrong only if one likely slip in it lies between the two.
//!
//! The slope is seen in numbers: next to an extremum a quantity changes on both sides by the same amount, and elsewhere by
//! opposite ones.

use crate::Result;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::prose;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, Statement, SymbolId, Value, text};
use crate::latex::{Reading, read_display};

/// Words, or the beginnings of words, for an extremum.
const WORDS: [&str; 22] = [
    "maxim",
    "minim",
    "extrem",
    "largest",
    "smallest",
    "greatest",
    "highest",
    "lowest",
    "least",
    "peak",
    "optim",
    "stationary",
    "steepest",
    "most probable",
    "vanishing derivative",
    "derivative vanish",
    "derivative is zero",
    "größt",
    "grösst",
    "kleinst",
    "wahrscheinlichst",
    "le plus grand",
];

/// The number of states that are drawn, and the fewest of them that show a slope.
const STATES: usize = 24;
const FEWEST: usize = 4;

/// The relative distance on either side of the place.
const BESIDE: f64 = 1e-4;

/// The share of the change on both sides by which the two may differ at an extremum, and from which there is a slope.
const FLAT: f64 = 0.02;

/// The relative change below which a quantity is constant, or its change is rounding.
const CONSTANT: f64 = 1e-12;

/// The fewest symbols of a place in which an edit is sought.
const FEWEST_SYMBOLS: usize = 2;

/// The most quantities of which the words may speak.
const TRIED: usize = 3;

/// The deepest chain of definitions that is written out.
const DEEPEST: usize = 6;

/// A place that a statement gives a name: the symbol that has a value there, and the value.
struct Place {
    symbol: SymbolId,
    value: Expr,
}

impl Course<'_, '_> {
    /// The finding on a display that says where a quantity is largest or smallest, if it is, or one slip explains why it is not.
    pub(super) fn extremum(&self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        if matches!(found.finding.verdict, Verdict::Certified | Verdict::Verified) {
            return Ok(None);
        }
        if !self.speaks_of_an_extremum(at) {
            return Ok(None);
        }
        let finding = |verdict: Verdict, code: Code, message: String| gate::settled(found, (verdict, code), message);
        let places = self.places_of(&checker.readings[at], at);
        let Some(first) = places.first() else { return Ok(None) };
        let quantities = self.quantities(at, first.symbol);
        let shown = |place: &Place| text::plain(&checker.model.name(place.symbol));
        for place in &places {
            for (name, quantity) in quantities.iter().filter(|_| place.symbol == first.symbol) {
                if self.is_flat(quantity, place)? == Some(true) {
                    let message = format!("the derivative of {name} by {} is 0 at this value of {0}", shown(place));
                    return Ok(Some(finding(Verdict::Verified, Code::Holds, message)));
                }
            }
        }
        let Some((name, quantity)) = quantities.first() else { return Ok(None) };
        let symbols = |place: &Place| place.value.symbols().len();
        if self.is_flat(quantity, first)? != Some(false) || symbols(first) < FEWEST_SYMBOLS {
            return Ok(None);
        }
        for edit in self.edits_with_factors(at, None) {
            let text = edit.applied(&display.text);
            let reading = read_display(&text, &mut checker.model.symbols.clone(), &checker.model.macros);
            let edited = self.places_of(&reading, at).into_iter().next();
            let Some(edited) = edited.filter(|edited| edited.symbol == first.symbol && symbols(edited) > 0) else {
                continue;
            };
            if self.is_flat(quantity, &edited)? == Some(true) {
                let repair = Repair::of(edit, display.body.start, Verdict::Verified);
                let message = format!("the derivative of {name} by {} is not 0 at this value of {0}", shown(first));
                let wrong = finding(Verdict::Refuted, Code::SidesDiffer, message);
                return Ok(Some(Equation { repairs: vec![repair], ..wrong }));
            }
        }
        Ok(None)
    }

    /// The places that the only statement of a display gives: that of each formula in `\omega_r = A = B`.
    fn places_of(&self, reading: &Reading, at: usize) -> Vec<Place> {
        let [Ok(statement)] = reading.statements.as_slice() else { return Vec::new() };
        let Some((first, others)) = statement.members.split_first() else { return Vec::new() };
        let equates = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        // A correction may bring in a name that the notes do not have.
        let known = self.checker.model.symbols.len();
        let is_known = |formula: &Expr| formula.symbols().iter().all(|(id, _)| id.0 < known);
        if !statement.members.iter().all(is_known) {
            return Vec::new();
        }
        if !equates || statement.branch.is_some() || !statement.conditions.is_empty() {
            return Vec::new();
        }
        others.iter().filter_map(|formula| self.place(first, formula, at)).collect()
    }

    /// The place of an extremum that a display states.
    pub(super) fn place_of_extremum(&self, at: usize) -> Option<(SymbolId, Expr)> {
        let place = self.places_of(&self.checker.readings[at], at).pop()?;
        self.speaks_of_an_extremum(at).then_some((place.symbol, place.value))
    }

    fn speaks_of_an_extremum(&self, at: usize) -> bool {
        let words = prose::words_since_last(self.checker.notes, at);
        WORDS.iter().any(|word| words.contains(word))
    }

    /// The place that a name and its formula state: ω at ω_r, or x itself.
    fn place(&self, name: &Expr, formula: &Expr, at: usize) -> Option<Place> {
        let symbols = &self.checker.model.symbols;
        let (id, is_squared) = match &name.node {
            Node::Power(base, exponent) if exponent.as_digits() == Some("2") => (base.as_plain_symbol()?, true),
            _ => (name.as_plain_symbol()?, false),
        };
        if formula.is_null() || formula.symbols().iter().any(|(other, dots)| *other == id || *dots > 0) {
            return None;
        }
        let entry = symbols.entry(id);
        let is_squared = is_squared || entry.squared;
        let letter = Name { subscript: Vec::new(), ..entry.name.clone() };
        let general = symbols.find(&letter).map(|(general, _)| general).filter(|general| *general != id);
        let general = general.filter(|general| !formula.symbols().iter().any(|(other, _)| other == general));
        let is_in_a_quantity = |id: &SymbolId| !self.quantities(at, *id).is_empty();
        let symbol = general.into_iter().chain([id]).find(is_in_a_quantity)?;
        let value = match (is_squared, symbols.entry(symbol).squared) {
            (true, false) => Expr::new(Node::Root(2, Box::new(formula.clone())), formula.span),
            (false, true) => {
                let two = Expr::integer(2, formula.span);
                Expr::new(Node::Power(Box::new(formula.clone()), Box::new(two)), formula.span)
            }
            _ => formula.clone(),
        };
        Some(Place { symbol, value })
    }

    /// The formulas with a symbol that displays before give to what does not print it, with that: those that the words cite first, and
    /// then the last ones.
    fn quantities(&self, at: usize, symbol: SymbolId) -> Vec<(String, Expr)> {
        let checker = self.checker;
        let cited = prose::before(checker.notes, at).named;
        let others = (0..at).rev().filter(|place| !cited.contains(place));
        let order = cited.iter().copied().filter(|place| *place < at).chain(others);
        let statements =
            order.flat_map(|place| checker.readings[place].statements.iter().flatten().collect::<Vec<&Statement>>());
        let formulas = statements.filter_map(|statement| {
            let name = statement.members.first()?;
            let (relation, _) = statement.relations.first()?;
            let formula = statement.members.get(1).filter(|_| is_equality(*relation) && statement.branch.is_none())?;
            let written = self.written_out(formula, symbol)?;
            let (own, names) = (name.symbols(), written.symbols());
            let is_still = own.iter().chain(&names).all(|(_, dots)| *dots == 0);
            let has_it = |names: &[(SymbolId, u8)]| names.iter().any(|(id, _)| *id == symbol);
            let is_given =
                !own.is_empty() && name.as_plain_symbol().is_none_or(|name| names.iter().all(|(id, _)| *id != name));
            let shown = || text::formula(name, &checker.model.symbols);
            (is_still && is_given && has_it(&names) && !has_it(&own)).then(|| (shown(), written))
        });
        formulas.take(TRIED).collect()
    }

    /// A formula in which each name whose formula contains a symbol is replaced by this.
    pub(super) fn written_out(&self, formula: &Expr, symbol: SymbolId) -> Option<Expr> {
        let model = self.checker.model;
        let mut formula = formula.clone();
        for _ in 0..DEEPEST {
            let defined = |id: SymbolId| match model.meaning(id) {
                Some(Meaning::Defined(inner)) if id != symbol => {
                    let inner = inner.as_ref();
                    model.depends_on(inner, &[symbol]).then(|| inner.clone())
                }
                _ => None,
            };
            if !formula.symbols().iter().any(|(id, _)| defined(*id).is_some()) {
                return Some(formula);
            }
            formula.substitute(&|node| match node {
                Node::Symbol { id, dots: 0, .. } => defined(*id),
                _ => None,
            });
        }
        None
    }

    /// Whether a quantity has no slope at a place; `None`, if that cannot be seen.
    fn is_flat(&self, quantity: &Expr, place: &Place) -> Result<Option<bool>> {
        let at = |factor: f64| {
            let span = place.value.span;
            let factor = Expr::new(Node::Number(format!("{factor}")), span);
            let value = Expr::new(Node::Product(vec![factor, place.value.clone()]), span);
            let mut there = quantity.clone();
            there.substitute(&|node| match node {
                Node::Symbol { id, dots: 0, .. } if *id == place.symbol => Some(value.clone()),
                _ => None,
            });
            there
        };
        let three = [at(1.0 - BESIDE), at(1.0), at(1.0 + BESIDE)];
        let context = self.context(&[]);
        let mode = context.mode(false, &[&three[0], &place.value]);
        let ensemble = context.ensemble(mode, false, STATES)?;
        let mut flat = Vec::new();
        for state in &ensemble.states {
            let value = |formula: &Expr| match state.now(formula, &[]) {
                Ok(Value::Scalar(value)) if value.value.is_finite() => Some(value.value),
                _ => None,
            };
            let [Some(before), Some(there), Some(after)] = [0, 1, 2].map(|at| value(&three[at])) else { continue };
            let (left, right) = (before - there, after - there);
            let change = left.abs() + right.abs();
            if change <= CONSTANT * there.abs() {
                continue;
            }
            flat.push((left - right).abs() < FLAT * change);
        }
        if flat.len() < FEWEST {
            return Ok(None);
        }
        Ok(match flat.iter().filter(|flat| **flat).count() {
            0 => Some(false),
            all if all == flat.len() => Some(true),
            _ => None,
        })
    }
}
