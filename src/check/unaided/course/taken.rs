//! Displays that become premises of what comes later.

use crate::check::document::checker::Checker;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::inline;
use crate::check::unaided::premises::{self, Premise, Said};
use crate::formula::units::in_si::has_units;
use crate::formula::{Kind, Node, Statement, SymbolId};

impl Course<'_, '_> {
    /// Makes a display that is taken for granted a premise of what comes later.
    pub(super) fn take_for_granted(&mut self, at: usize) {
        if !self.is_of_another_system(at) {
            self.take_as_premise(at, &[]);
        }
    }

    /// Makes a display a premise of what comes later; it follows from the displays at some places, perhaps.
    pub(super) fn take_as_premise(&mut self, at: usize, from: &[usize]) {
        // What was judged before is a premise already.
        if self.known.iter().any(|premise| premise.at == at) {
            return;
        }
        let mut new = self.premises_in(at, from);
        self.known.append(&mut new);
    }

    /// The premises that a display gives if it is taken for granted, or follows from the displays at some places.
    pub(super) fn premises_in(&self, at: usize, from: &[usize]) -> Vec<Premise> {
        // Numbers of an example say nothing about other displays.
        let mut members =
            self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        if members.any(has_units) {
            return Vec::new();
        }
        // Of the modulus of a rate, as in dσ = 2πρ |dρ/dχ| dχ, authors leave the sign open; |W| = Q has two solutions for W.
        if has_open_modulus(self.checker, at) {
            return Vec::new();
        }
        // Beside a motion, what is taken for granted is a special case of it or contradicts it, unless it is about constants alone.
        let display = &self.checker.notes.equations[at];
        let is_free = self.checker.model.system.is_none() || is_static(self.checker, at);
        let Some(id) = display.id().filter(|_| is_free) else { return Vec::new() };
        let Ok(statements) =
            self.checker.readings[at].statements.iter().map(Result::as_ref).collect::<Result<Vec<&Statement>, _>>()
        else {
            return Vec::new();
        };
        // Of `x = 3 \pm 2` one sign holds, so neither is known.
        if statements.windows(2).any(|pair| pair[0].is_alternative_to(pair[1])) {
            return Vec::new();
        }
        let is_inline = inline::is_inline(self.checker.notes, display);
        // What is constant has a rate of 0.
        if let [statement] = statements.as_slice()
            && statement.constant.is_some()
        {
            return self.constant_in((at, id), statement, from).into_iter().collect();
        }
        let premise = |said: Said, statements: &[&Statement]| Premise {
            at,
            id: id.to_owned(),
            said,
            symbols: self.symbols_of(statements),
            equalities: statements.iter().map(|statement| statement.relations.len()).sum(),
            is_inline,
            from: from.to_vec(),
        };
        let mut new = vec![premise(Said::Whole, &statements)];
        if statements.len() > 1 {
            for statement in statements {
                let Some(part) = display.text.get(statement.span.start..statement.span.end) else { continue };
                new.push(premise(Said::Part(part.to_owned()), &[statement]));
            }
        }
        // What holds under a condition is no premise.
        new.retain(|premise| self.checker.hypotheses(&premises::claim(&[premise])).is_ok());
        new
    }

    /// The premise that a formula is constant, where a statement says so.
    fn constant_in(&self, (at, id): (usize, &str), statement: &Statement, from: &[usize]) -> Option<Premise> {
        let display = &self.checker.notes.equations[at];
        let last = statement.members.last()?;
        let text = display.text.get(last.span.range())?;
        let premise = Premise {
            at,
            id: id.to_owned(),
            said: Said::Constant(text.to_owned()),
            symbols: self.symbols_of(&[statement]),
            equalities: 1,
            is_inline: inline::is_inline(self.checker.notes, display),
            from: from.to_vec(),
        };
        self.checker.hypotheses(&premises::claim(&[&premise])).is_ok().then_some(premise)
    }
}

/// Whether a display is about constants alone, and about nothing that moves.
pub(in crate::check::unaided) fn is_static(checker: &Checker<'_>, at: usize) -> bool {
    let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
    let mut leaves = members.flat_map(|member| gate::leaves(member, checker.model));
    leaves.all(|id| matches!(checker.model.meaning(id), Some(Meaning::Constant(_))))
}

/// Whether the modulus of a number stands in a display whose sign it leaves open: of one with a rate, or of a single name.
fn has_open_modulus(checker: &Checker<'_>, at: usize) -> bool {
    let is_number = |id: SymbolId| checker.model.symbols.entry(id).kind == Kind::Scalar;
    let mut found = false;
    for member in checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members) {
        member.walk(&mut |part| {
            let Node::Norm(inner) = &part.node else { return };
            found |=
                inner.symbols().iter().any(|(_, dots)| *dots > 0) || inner.as_plain_symbol().is_some_and(is_number);
        });
    }
    found
}
