//! Printed solutions that solve their equation of motion, and do not start where the notes say: `v = \frac{mg}{k}(1 + e^{-kt/m})` after
//! `v(0) = 0`.
//!
//! A start is a formula in a sentence or in a display before the solution, in its section, and the last one counts. It is that of one
//! solution: after this another motion may be meant. A constant that no display before the solution has is one of integration, and may
//! have any value.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::document::inferred::prose::body_of;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::solutions;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Node, Statement, SymbolId, Value, text};
use crate::latex::read_display;
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

/// The number of states that are tried, and the fewest of them that decide.
const STATES: usize = 24;
const FEWEST: usize = 8;

/// The difference of two equal numbers, relative to the larger one.
const EQUAL: f64 = 1e-7;

/// What a coordinate or its rate is at the time 0.
struct Start {
    /// The number of dots: 0 for the coordinate, 1 for its rate.
    dots: u8,
    value: Expr,
    /// How it is printed.
    text: String,
}

impl Course<'_, '_> {
    /// The finding on a display, weighed against the start that the notes print.
    pub(in crate::check::unaided::course) fn judged_with_start(&mut self, at: usize) -> Result<Equation> {
        let found = self.judge(at)?;
        let holds = matches!(found.finding.verdict, Verdict::Certified | Verdict::Verified);
        if !holds || !solutions::is_printed(self.checker, at, &Claim::default()) {
            return Ok(found);
        }
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return Ok(found) };
        let Some((id, formula)) = solution(statement) else { return Ok(found) };
        let starts = self.starts(at, id);
        let mut broken = None;
        for start in &starts {
            if !self.has_new_constants(at, id, formula, Some(start)) && self.agrees_at_0(formula, start)? == Some(false)
            {
                broken = Some(start);
            }
        }
        let Some(broken) = broken else { return Ok(found) };
        let message = format!("this solves the equations of motion, but not with {}", broken.text);
        let display = &self.checker.notes.equations[at];
        for edit in self.edits_with_factors(at, Some(formula.span)) {
            let edited = edit.applied(&display.text);
            let reading = read_display(&edited, &mut self.checker.model.symbols.clone(), &self.checker.model.macros);
            let [Ok(statement)] = reading.statements.as_slice() else { continue };
            let Some(formula) = statement.members.last() else { continue };
            let mut fits = true;
            for start in &starts {
                fits = fits && self.agrees_at_0(formula, start)? == Some(true);
            }
            let solves = |checker: &Checker<'_>| {
                let judged = checker.equation(at, Some(&Claim::default()));
                judged.is_ok_and(|found| found.finding.verdict.passes() && found.finding.verdict != Verdict::Definition)
            };
            if fits && self.quick.with_edited_text(self.quick.options, at, &edited, solves) == Some(true) {
                let repair = Repair::of(edit, display.body.start, Verdict::Verified);
                let wrong = gate::settled(&found, (Verdict::Refuted, Code::SidesDiffer), message);
                return Ok(Equation { repairs: vec![repair], ..wrong });
            }
        }
        Ok(gate::settled(&found, (Verdict::Undecided, Code::NotDecided), message))
    }

    /// The starts of a coordinate that the notes print before a display, each the last of its kind.
    fn starts(&self, at: usize, id: SymbolId) -> Vec<Start> {
        let notes = self.checker.notes;
        let end = notes.equations[at].span.start;
        let section = self.scope.section_of(self.scope.origin_of(at, notes.equations.len()));
        let is_before = |place: &usize| notes.equations[*place].span.end <= end;
        let is_used = |place: &usize| *place < section || self.is_solved_in(*place, id);
        let used = (0..at).filter(is_before).filter(is_used).map(|place| notes.equations[place].span.end);
        let first = used.max().unwrap_or(0);
        let mut spans: Vec<Span> = notes.inline.iter().filter_map(|span| body_of(notes, *span)).collect();
        spans.extend(notes.equations[..at].iter().map(|display| display.body));
        spans.retain(|span| first <= span.start && span.end <= end);
        spans.sort_by_key(|span| span.start);
        let mut found: Vec<Start> = Vec::new();
        for text in spans.iter().rev().map(|span| notes.source.slice(*span)) {
            for part in
                text.split([',', ';']).flat_map(|part| part.split("\\quad")).flat_map(|part| part.split("\\qquad"))
            {
                let Some(start) = self.start_in(part, id) else { continue };
                if found.iter().all(|known| known.dots != start.dots) {
                    found.push(start);
                }
            }
        }
        found
    }

    /// Whether a display prints a solution for a coordinate in which no constant is left open.
    fn is_solved_in(&self, at: usize, id: SymbolId) -> bool {
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return false };
        solution(statement).is_some_and(|(solved, formula)| {
            solved == id
                && solutions::is_printed(self.checker, at, &Claim::default())
                && !self.has_new_constants(at, id, formula, None)
        })
    }

    /// The start that a formula prints: `x(0) = x_0`, `\dot x(t=0) = 0`.
    fn start_in(&self, part: &str, id: SymbolId) -> Option<Start> {
        let model = self.checker.model;
        let name = model.name(id);
        let bare = |text: &str| text.chars().filter(|c| !c.is_whitespace() && !"{}".contains(*c)).collect::<String>();
        let place = ["(0)", "(t=0)", "_t=0"].into_iter().find(|place| bare(part).contains(place))?;
        let (left, value) = part.rsplit_once('=').filter(|(left, _)| !left.trim().is_empty())?;
        let left = bare(left);
        let quantity = left.strip_suffix(place)?;
        let dots = match quantity.strip_prefix("\\dot") {
            Some(rest) if rest == bare(&name) => 1,
            None if quantity == bare(&name) => 0,
            _ => return None,
        };
        let value = value.trim().trim_end_matches('.');
        let mut symbols = model.symbols.clone();
        let reading = read_display(value, &mut symbols, &model.macros);
        let ([Ok(statement)], true) = (reading.statements.as_slice(), symbols.len() == model.symbols.len()) else {
            return None;
        };
        let [value] = statement.members.as_slice() else { return None };
        let quantity = Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, Span::default());
        let [quantity, shown] = [&quantity, value].map(|formula| text::formula(formula, &model.symbols));
        Some(Start { dots, value: value.clone(), text: format!("{quantity}(0) = {shown}") })
    }

    /// Whether a solution has a constant that stands neither in a display before it nor in the start.
    fn has_new_constants(&self, at: usize, coordinate: SymbolId, formula: &Expr, start: Option<&Start>) -> bool {
        let model = self.checker.model;
        let mut leaves = gate::leaves(formula, model).into_iter();
        leaves.any(|id| {
            let is_time = matches!(model.meaning(id), Some(Meaning::Time));
            let is_known = self.seen.get(&id).is_some_and(|first| *first < at)
                || start.is_some_and(|start| start.value.symbols().iter().any(|(other, _)| *other == id));
            id != coordinate && !is_time && !is_known
        })
    }

    /// Whether a formula has the value of a start at the time 0; `None`, if that is not known.
    fn agrees_at_0(&self, formula: &Expr, start: &Start) -> Result<Option<bool>> {
        let model = self.checker.model;
        let mut times =
            model.symbols.iter().map(|(id, _)| id).filter(|id| matches!(model.meaning(*id), Some(Meaning::Time)));
        let Some(time) = times.next() else { return Ok(None) };
        let assume = vec![Spanned::new(format!("{} = 0", model.name(time)), Span::default())];
        let Ok(hypotheses) = self.checker.hypotheses(&Claim { assume, ..Claim::default() }) else { return Ok(None) };
        let context = self.context(&hypotheses);
        let formula = match start.dots {
            0 => formula.clone(),
            dots => Expr::new(Node::TimeDerivative(dots, Box::new(formula.clone())), formula.span),
        };
        let mode = context.mode(false, &[&formula, &start.value]);
        let ensemble = context.ensemble(mode, false, STATES)?;
        let (mut alike, mut other) = (0, 0);
        for state in &ensemble.states {
            let sides = (state.now(&formula, &[]), state.now(&start.value, &[]));
            let (Ok(Value::Scalar(a)), Ok(Value::Scalar(b))) = sides else { continue };
            let (a, b) = (a.value, b.value);
            if !a.is_finite() || !b.is_finite() {
                continue;
            }
            match (a - b).abs() <= EQUAL * a.abs().max(b.abs()).max(1.0) {
                true => alike += 1,
                false => other += 1,
            }
        }
        Ok(match (alike, other) {
            (alike, 0) if alike >= FEWEST => Some(true),
            (0, other) if other >= FEWEST => Some(false),
            _ => None,
        })
    }
}

/// The coordinate on the left side of a statement, and the last formula for it.
fn solution(statement: &Statement) -> Option<(SymbolId, &Expr)> {
    let [first, .., formula] = statement.members.as_slice() else { return None };
    first.as_plain_symbol().map(|id| (id, formula))
}
