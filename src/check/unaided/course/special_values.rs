//! A name for the value of a quantity at a place that the words state: "the derivative vanishes at $u = v/2$, and
//! there `P_{max} = …`", after `P(u) = …`. The place may also be that of an extremum, which the display before gives, and the name
//! that of the quantity itself.
//!
//! Such a display gives the name a formula, which would be a definition otherwise. If the quantity has this value there, the display
//! follows. It is called wrong only if one likely slip in it lies between the two.

use crate::Result;
use crate::check::document::inferred::prose::body_of;
use crate::check::model::claim::is_equality;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::inline;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Node, Statement, SymbolId, text};
use crate::latex::read_display;
use crate::source::Span;

/// The fewest symbols, numbers and operations of a formula in which an edit is sought.
const FEWEST: usize = 6;

/// The relative difference of a ratio from 1 that is rounding.
pub(super) const ROUNDING: f64 = 1e-9;

/// What the words say that a name is: a quantity at a place, a sum.
pub(super) struct Special {
    /// Its formula; that of a quantity at a place has the value put in.
    pub value: Expr,
    /// The same in words.
    pub says: String,
}

/// Whether a formula agrees with what the words say.
pub(super) type Agrees<'a> = &'a dyn Fn(&Expr) -> Result<bool>;

impl Course<'_, '_> {
    /// The finding on a display that gives the value of a quantity at a place, if the words state one.
    pub(super) fn special_value(&self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return Ok(None) };
        let Some((name, formula)) = named(statement) else { return Ok(None) };
        if matches!(found.finding.verdict, Verdict::Certified | Verdict::Verified) {
            return Ok(None);
        }
        let is_equal = |a: &Expr, b: &Expr| -> Result<bool> {
            Ok(self.constant_ratio(a, b)?.is_some_and(|ratio| (ratio - 1.0).abs() < ROUNDING))
        };
        let mut specials = self.specials(at, name, formula);
        specials.extend(self.at_argument(at, name));
        for Special { value, says } in &specials {
            if is_equal(value, formula)? {
                return Ok(Some(gate::settled(found, (Verdict::Verified, Code::Holds), format!("this is {says}"))));
            }
        }
        let Some(Special { value, says }) = specials.first() else { return Ok(None) };
        self.one_edit_from(at, found, formula, (says, &|edited| is_equal(value, edited)))
    }

    /// The finding that a display is wrong, if one likely edit of the formula that it gives a name makes this what the words say.
    pub(super) fn one_edit_from(
        &self,
        at: usize,
        found: &Equation,
        formula: &Expr,
        (says, agrees): (&str, Agrees<'_>),
    ) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        if parts(formula) < FEWEST {
            return Ok(None);
        }
        for edit in self.edits_with_factors(at, Some(formula.span)) {
            let text = edit.applied(&display.text);
            let reading = read_display(&text, &mut checker.model.symbols.clone(), &checker.model.macros);
            let [Ok(edited)] = reading.statements.as_slice() else { continue };
            let Some((_, edited)) = named(edited) else { continue };
            if agrees(edited)? {
                let repair = Repair::of(edit, display.body.start, Verdict::Verified);
                let verdict = (Verdict::Refuted, Code::SidesDiffer);
                let wrong = gate::settled(found, verdict, format!("this is not {says}"));
                return Ok(Some(Equation { repairs: vec![repair], ..wrong }));
            }
        }
        Ok(None)
    }

    /// The values that the quantity of a name with a subscript has at the places which the words around a display state.
    fn specials(&self, at: usize, name: SymbolId, formula: &Expr) -> Vec<Special> {
        let checker = self.checker;
        let printed = &checker.model.symbols.entry(name).name;
        let mut places = self.places(at);
        places.extend(self.extremum_before(at));
        if places.is_empty() {
            return Vec::new();
        }
        let own: Vec<SymbolId> = formula.symbols().into_iter().map(|(id, _)| id).collect();
        let mut found = Vec::new();
        // The formulas of the quantity without the subscript, the last first, also those of earlier sections.
        let places_before = (0..at).rev();
        let statements = places_before
            .flat_map(|place| checker.readings[place].statements.iter().flatten().map(move |base| (place, base)));
        for (place, statement) in statements {
            let Some(first) = statement.members.first() else { continue };
            let is_general = match first.as_plain_symbol().map(|base| (base, &checker.model.symbols.entry(base).name)) {
                Some((base, known)) => base == name || known.base == printed.base && known.subscript.is_empty(),
                None => {
                    let text = &checker.notes.equations[place].text;
                    text.get(first.span.range()).is_some_and(|formula| is_special(&printed.base, formula))
                }
            };
            if !is_general {
                continue;
            }
            for general in statement.members[1..].iter().filter(|member| !moves(member)) {
                for (symbol, place) in &places {
                    let Some(general) = self.written_out(general, *symbol) else { continue };
                    let depends = general.symbols().iter().any(|(id, _)| id == symbol);
                    if depends && !own.contains(symbol) {
                        let mut value = general;
                        value.substitute(&|node| match node {
                            Node::Symbol { id, dots: 0, .. } if id == symbol => Some(place.clone()),
                            _ => None,
                        });
                        let symbols = &checker.model.symbols;
                        let [quantity, place] = [first, place].map(|formula| text::formula(formula, symbols));
                        let symbol = text::plain(&checker.model.name(*symbol));
                        let says = format!("{quantity} where {symbol} = {place}");
                        found.push(Special { value, says });
                    }
                }
            }
        }
        found
    }

    /// The place of an extremum that the display before states.
    fn extremum_before(&self, at: usize) -> Option<(SymbolId, Expr)> {
        let notes = self.checker.notes;
        let before = (0..at).rev().find(|place| !inline::is_inline(notes, &notes.equations[*place]))?;
        self.place_of_extremum(before)
    }

    /// The places that the sentences between a display and the one before it state, the last first: `u = v/2`.
    fn places(&self, at: usize) -> Vec<(SymbolId, Expr)> {
        let notes = self.checker.notes;
        let read = |text: &str| {
            let model = self.checker.model;
            let reading = read_display(text, &mut model.symbols.clone(), &model.macros);
            match reading.statements.as_slice() {
                [Ok(statement)] => named(statement).map(|(symbol, place)| (symbol, place.clone())),
                _ => None,
            }
        };
        let mut found: Vec<(SymbolId, Expr)> =
            self.in_sentences_before(at).filter_map(|span| read(notes.source.slice(body_of(notes, span)?))).collect();
        found.reverse();
        found
    }

    /// Where the formulas stand that the sentences between a display and the one before it contain.
    pub(super) fn in_sentences_before(&self, at: usize) -> impl Iterator<Item = Span> {
        let notes = self.checker.notes;
        let end = notes.equations[at].span.start;
        let printed = notes.equations[..at].iter().filter(|display| !inline::is_inline(notes, display));
        let start = printed.map(|display| display.span.end).filter(|before| *before <= end).max().unwrap_or(0);
        notes.inline.iter().copied().filter(move |span| span.start >= start && span.end <= end)
    }
}

/// A name and the formula beside it, if that is all that a statement says, and the formula is not 0.
pub(super) fn named(statement: &Statement) -> Option<(SymbolId, &Expr)> {
    value_of(statement).filter(|(_, formula)| !formula.is_null())
}

/// A name and the value that a statement gives it, if that is all that it says.
pub(super) fn value_of(statement: &Statement) -> Option<(SymbolId, &Expr)> {
    let ([name, value], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
        return None;
    };
    let is_one = is_equality(*relation) && statement.branch.is_none();
    name.as_plain_symbol().filter(|_| is_one).map(|id| (id, value))
}

/// The number of symbols, numbers and operations of a formula.
pub(super) fn parts(formula: &Expr) -> usize {
    let mut count = 0;
    formula.walk(&mut |_| count += 1);
    count
}

/// Whether a printed name is that of a special value of a formula: `\left( \frac{A}{U} \right)_{\max}`.
fn is_special(name: &str, formula: &str) -> bool {
    let bare = |text: &str| {
        let text = text.replace("\\left", "").replace("\\right", "");
        text.chars().filter(|c| !c.is_whitespace() && !"{}".contains(*c)).collect::<String>()
    };
    let subscript = bare(name).strip_prefix(&format!("({})_", bare(formula))).map(str::len);
    subscript.is_some_and(|length| length > 0)
}

/// Whether a rate stands in a formula.
fn moves(formula: &Expr) -> bool {
    let mut found = formula.symbols().iter().any(|(_, dots)| *dots > 0);
    formula.walk(&mut |part| found |= matches!(part.node, Node::TimeDerivative(..)));
    found
}
