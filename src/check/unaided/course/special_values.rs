//! A name with a subscript for the value of a quantity at a place that the words state: "the derivative vanishes at $u = v/2$, and
//! there `P_{max} = …`", after `P(u) = …`.
//!
//! Such a display gives the name a formula, which would be a definition otherwise. If the quantity has this value there, the display
//! follows. It is called wrong only if one likely slip in it lies between the two.

use crate::Result;
use crate::check::document::inferred::prose::body_of;
use crate::check::model::claim::is_equality;
use crate::check::unaided::course::Course;
use crate::check::unaided::inline;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Node, Statement, SymbolId, text};
use crate::latex::read_display;

/// The fewest symbols of a formula in which an edit is sought.
const FEWEST: usize = 3;

/// The relative difference of a ratio from 1 that is rounding.
const ROUNDING: f64 = 1e-9;

/// A quantity at a place.
struct Special {
    /// The formula of the quantity with the value put in.
    value: Expr,
    /// The place in words.
    says: String,
}

impl Course<'_, '_> {
    /// The finding on a display that gives the value of a quantity at a place, if the words state one.
    pub(super) fn special_value(&self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        let [Ok(statement)] = checker.readings[at].statements.as_slice() else { return Ok(None) };
        let Some((name, formula)) = named(statement) else { return Ok(None) };
        if matches!(found.finding.verdict, Verdict::Certified | Verdict::Verified) {
            return Ok(None);
        }
        let finding = |verdict: Verdict, code: Code, message: String| Equation {
            finding: Finding::new(code, verdict, found.finding.span, message),
            parts: Vec::new(),
            repairs: Vec::new(),
            ok: verdict != Verdict::Refuted,
            ..found.clone()
        };
        let is_equal = |a: &Expr, b: &Expr| -> Result<bool> {
            Ok(self.constant_ratio(a, b)?.is_some_and(|ratio| (ratio - 1.0).abs() < ROUNDING))
        };
        let specials = self.specials(at, name, formula);
        for Special { value, says } in &specials {
            if is_equal(value, formula)? {
                return Ok(Some(finding(Verdict::Verified, Code::Holds, format!("this is {says}"))));
            }
        }
        let Some(Special { value, says }) = specials.first().filter(|_| formula.symbols().len() >= FEWEST) else {
            return Ok(None);
        };
        for edit in self.edits_of(at, Some(formula.span)) {
            let text = edit.applied(&display.text);
            let reading = read_display(&text, &mut checker.model.symbols.clone(), &checker.model.macros);
            let [Ok(edited)] = reading.statements.as_slice() else { continue };
            let Some((_, edited)) = named(edited) else { continue };
            if is_equal(value, edited)? {
                let repair = Repair::of(edit, display.body.start, Verdict::Verified);
                let message = format!("this is not {says}");
                let wrong = finding(Verdict::Refuted, Code::SidesDiffer, message);
                return Ok(Some(Equation { repairs: vec![repair], ..wrong }));
            }
        }
        Ok(None)
    }

    /// The values that the quantity of a name with a subscript has at the places which the words around a display state.
    fn specials(&self, at: usize, name: SymbolId, formula: &Expr) -> Vec<Special> {
        let checker = self.checker;
        let printed = &checker.model.symbols.entry(name).name;
        if printed.subscript.is_empty() {
            return Vec::new();
        }
        let places = self.places(at);
        if places.is_empty() {
            return Vec::new();
        }
        let own: Vec<SymbolId> = formula.symbols().into_iter().map(|(id, _)| id).collect();
        let mut found = Vec::new();
        // The formulas of the quantity without the subscript, the last first, also those of earlier sections.
        let bases = checker.readings[..at].iter().rev().flat_map(|reading| &reading.statements);
        for statement in bases.flatten() {
            let Some(base) = statement.members.first().and_then(Expr::as_plain_symbol) else { continue };
            let known = &checker.model.symbols.entry(base).name;
            if base == name || known.base != printed.base || !known.subscript.is_empty() {
                continue;
            }
            for general in statement.members[1..].iter().filter(|member| !moves(member)) {
                for (symbol, place) in &places {
                    let depends = general.symbols().iter().any(|(id, _)| id == symbol);
                    if depends && !own.contains(symbol) {
                        let mut value = general.clone();
                        value.substitute(&|node| match node {
                            Node::Symbol { id, dots: 0, .. } if id == symbol => Some(place.clone()),
                            _ => None,
                        });
                        let shown = |id| text::plain(&checker.model.name(id));
                        let place = text::formula(place, &checker.model.symbols);
                        let says = format!("{} where {} = {place}", shown(base), shown(*symbol));
                        found.push(Special { value, says });
                    }
                }
            }
        }
        found
    }

    /// The places that the sentences between a display and the one before it state, the last first: `u = v/2`.
    fn places(&self, at: usize) -> Vec<(SymbolId, Expr)> {
        let notes = self.checker.notes;
        let end = notes.equations[at].span.start;
        let printed = notes.equations[..at].iter().filter(|display| !inline::is_inline(notes, display));
        let start = printed.map(|display| display.span.end).filter(|before| *before <= end).max().unwrap_or(0);
        let between = notes.inline.iter().filter(|span| span.start >= start && span.end <= end).rev();
        let read = |text: &str| {
            let model = self.checker.model;
            let reading = read_display(text, &mut model.symbols.clone(), &model.macros);
            match reading.statements.as_slice() {
                [Ok(statement)] => named(statement).map(|(symbol, place)| (symbol, place.clone())),
                _ => None,
            }
        };
        between.filter_map(|span| read(notes.source.slice(body_of(notes, *span)?))).collect()
    }
}

/// A name and the formula beside it, if that is all that a statement says.
fn named(statement: &Statement) -> Option<(SymbolId, &Expr)> {
    let ([name, formula], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
        return None;
    };
    let is_one = is_equality(*relation) && statement.branch.is_none();
    name.as_plain_symbol().filter(|_| is_one && !formula.is_null()).map(|id| (id, formula))
}

/// Whether a rate stands in a formula.
fn moves(formula: &Expr) -> bool {
    let mut found = formula.symbols().iter().any(|(_, dots)| *dots > 0);
    formula.walk(&mut |part| found |= matches!(part.node, Node::TimeDerivative(..)));
    found
}
