//! A force beside the printed Lagrangian: an equation of motion that would follow from L if a letter in it were 0, which L does not
//! contain, such as the F of `m\ddot x + kx = F`.
//!
//! The motion is then not that of L alone. What follows on shell from L without the force is not decided.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::unaided::gate;
use crate::check::unaided::motion::are_equal;
use crate::check::unaided::scope::Scope;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Node, SymbolId};
use crate::source::Span;

/// Leaves open what follows from L alone after an equation of motion with a force.
pub(super) fn weighed(checker: &Checker<'_>, scope: &Scope, found: &mut [Equation]) -> Result<()> {
    let first = scope.carried;
    for place in 0..found.len() {
        let Some(forces) = forces(checker, first + place, &found[place])? else { continue };
        let name = found[place].id.clone();
        for (later, equation) in found.iter_mut().enumerate().skip(place + 1) {
            let has_one = symbols(checker, first + later).any(|(id, _)| forces.contains(&id));
            if !has_one && is_on_shell(equation) {
                let message = format!(
                    "this follows from the Lagrangian alone, but ({name}) has a force that is not in the Lagrangian, \
                     so this was not decided"
                );
                *equation = gate::settled(equation, (Verdict::Undecided, Code::NotDecided), message);
            }
        }
    }
    Ok(())
}

/// The letters of a display that are forces beside the Lagrangian; `None`, if there are none.
fn forces(checker: &Checker<'_>, at: usize, equation: &Equation) -> Result<Option<Vec<SymbolId>>> {
    let model = checker.model;
    if equation.finding.verdict != Verdict::Assumed || !symbols(checker, at).any(|(_, dots)| dots > 1) {
        return Ok(None);
    }
    let is_force = |id: &SymbolId| {
        matches!(model.meaning(*id), Some(Meaning::Constant(_) | Meaning::Varying(_))) && gate::is_foreign(*id, model)
    };
    let forces: Vec<SymbolId> = symbols(checker, at).map(|(id, _)| id).filter(is_force).collect();
    let [Ok(statement)] = checker.readings[at].statements.as_slice() else { return Ok(None) };
    if forces.is_empty() || !statement.relations.iter().all(|(relation, _)| is_equality(*relation)) {
        return Ok(None);
    }
    let without = |member: &Expr| {
        let mut member = member.clone();
        member.substitute(&|node| match node {
            Node::Symbol { id, .. } if forces.contains(id) => Some(Expr::integer(0, Span::default())),
            _ => None,
        });
        member
    };
    for pair in statement.members.windows(2) {
        if !are_equal(checker, &without(&pair[0]), &without(&pair[1]), true)? {
            return Ok(None);
        }
    }
    Ok(Some(forces))
}

/// The symbols of a display, with their dots.
fn symbols<'c>(checker: &'c Checker<'_>, at: usize) -> impl Iterator<Item = (SymbolId, u8)> + 'c {
    let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
    members.flat_map(Expr::symbols)
}

/// Whether a display follows from the motion, and is no equation of motion itself.
fn is_on_shell(equation: &Equation) -> bool {
    let follows = |message: &str| message.contains("on shell") && !message.contains("Euler–Lagrange equation");
    equation.finding.verdict.passes()
        && (follows(&equation.finding.message) || equation.parts.iter().any(|part| follows(&part.finding.message)))
}
