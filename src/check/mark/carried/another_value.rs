//! Follow-through of a value that a false line uses and does not print: `q = Q \cos(\sqrt{L/C} \, t)` in the place of
//! `q = Q \cos\omega t` takes √(L/C) for ω.

use crate::formula::{Expr, Node, Sign, SymbolId, Term};
use crate::latex::Reading;
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::mark::letters::head;
use crate::check::mark::status::{Status, status};
use crate::check::model::meaning::Meaning;

/// Whether a line holds where a quantity of the problem has the value that a false line has in its place. `first` is the
/// number of displays that are the problem's.
pub(super) fn follows(checker: &Checker<'_>, from: usize, (at, own): (usize, &Reading), first: usize) -> bool {
    let Some(Ok(line)) = checker.readings[from].statements.first() else { return false };
    let (Some(left), Some(printed)) = (line.members.first(), line.members.last()) else { return false };
    let of_problem = checker.readings[..first].iter().flat_map(|reading| reading.statements.iter().flatten());
    let alike = of_problem.filter(|known| known.members.first() == Some(left));
    let members: Vec<&Expr> = alike.flat_map(|known| known.members.iter().skip(1)).collect();
    members.into_iter().any(|known| {
        let names = known.symbols().into_iter().map(|(id, _)| id);
        let defined = names.filter(|id| matches!(checker.model.meaning(*id), Some(Meaning::Defined(_))));
        defined.into_iter().any(|id| {
            let Some(value) = value_of(id, known, printed) else { return false };
            let mut model = checker.model.clone();
            let mut members = own.statements.iter().flatten().flat_map(|statement| &statement.members);
            if model.depends_on(&value, &[id]) || !members.any(|member| model.depends_on(member, &[id])) {
                return false;
            }
            model.redefine(id, value);
            let edited = Checker { model: &model, units: None, ..*checker };
            matches!(status(&edited, at, own, &Claim::default()), Status::Holds(_))
        })
    })
}

/// Whether a line says of a quantity at an instant what a false line says of it at all times, where the problem says the same
/// with its own formula: `E_h = \frac{(Q_0/2)^2}{C}` after `E = \frac{q^2}{C}`.
pub(super) fn at_the_same_place(checker: &Checker<'_>, from: usize, own: &Reading, first: usize) -> bool {
    let statements = |reading: &Reading| reading.statements.iter().flatten().cloned().collect::<Vec<_>>();
    let of_problem: Vec<_> = checker.readings[..first].iter().flat_map(statements).collect();
    let known = |left: &Expr| -> Vec<Expr> {
        let alike = of_problem.iter().filter(|known| known.members.first() == Some(left));
        alike.flat_map(|known| known.members.iter().skip(1).cloned()).collect()
    };
    let (wrong, [Ok(line)]) = (&checker.readings[from], own.statements.as_slice()) else { return false };
    let [Ok(wrong)] = wrong.statements.as_slice() else { return false };
    let (Some(general), Some(special)) = (wrong.members.first(), line.members.first()) else { return false };
    let (Some(formula), true) = (wrong.members.last(), general != special) else { return false };
    // Each member of the line must be the first one's value; the others follow by algebra.
    let Some(printed) = line.members.get(1) else { return false };
    let moves =
        |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
    let moving: Vec<SymbolId> = formula.symbols().into_iter().map(|(id, _)| id).filter(moves).collect();
    moving.into_iter().any(|id| {
        let Some(value) = value_of(id, formula, printed) else { return false };
        known(general)
            .iter()
            .any(|formula| known(special).iter().any(|member| value_of(id, formula, member).as_ref() == Some(&value)))
    })
}

/// The formula that stands in `other` where `formula` has a symbol, if they are the same beside it.
fn value_of(id: SymbolId, formula: &Expr, other: &Expr) -> Option<Expr> {
    if formula.as_plain_symbol() == Some(id) {
        return Some(other.clone());
    }
    match (&formula.node, &other.node) {
        (Node::Product(_) | Node::Quotient(..), _) | (_, Node::Product(_) | Node::Quotient(..)) => {
            let ([mut a, mut under_a], [mut b, mut under_b]) = (factors(formula), factors(other));
            without_common(&mut a, &mut b);
            without_common(&mut under_a, &mut under_b);
            match (a.as_slice(), under_a.as_slice(), b.as_slice(), under_b.as_slice()) {
                ([only], [], above, below) if only.as_plain_symbol() == Some(id) => Some(quotient(above, below, other)),
                ([], [only], above, below) if only.as_plain_symbol() == Some(id) => Some(quotient(below, above, other)),
                ([only], [], [its], []) | ([], [only], [], [its]) => within(id, only, its),
                _ => None,
            }
        }
        _ => within(id, formula, other),
    }
}

/// The same for two formulas that are no products.
fn within(id: SymbolId, formula: &Expr, other: &Expr) -> Option<Expr> {
    if matches!(formula.node, Node::Product(_) | Node::Quotient(..)) {
        return value_of(id, formula, other);
    }
    if let (Node::Sum(a), Node::Sum(b)) = (&formula.node, &other.node) {
        let own: Vec<&Term> = a.iter().filter(|term| !b.contains(term)).collect();
        let its: Vec<&Term> = b.iter().filter(|term| !a.contains(term)).collect();
        let signs = |terms: &[&Term]| terms.iter().map(|term| term.sign).collect::<Vec<Sign>>();
        let pairs = own.iter().zip(&its);
        return one_value(pairs.map(|(own, its)| value_of(id, &own.expr, &its.expr)))
            .filter(|_| signs(&own) == signs(&its));
    }
    let (parts, others) = (formula.children(), other.children());
    if parts.len() != others.len() || head(formula) != head(other) {
        return None;
    }
    one_value(parts.iter().zip(&others).filter(|(a, b)| a != b).map(|(a, b)| value_of(id, a, b)))
}

/// The value that all places agree on.
fn one_value(found: impl Iterator<Item = Option<Expr>>) -> Option<Expr> {
    let all: Vec<Expr> = found.collect::<Option<_>>()?;
    let first = all.first()?.clone();
    all.iter().all(|value| *value == first).then_some(first)
}

/// The factors of a formula above and below the fraction line.
fn factors(formula: &Expr) -> [Vec<&Expr>; 2] {
    match &formula.node {
        Node::Product(all) => all.iter().fold([Vec::new(), Vec::new()], |[mut above, mut below], factor| {
            let [a, b] = factors(factor);
            above.extend(a);
            below.extend(b);
            [above, below]
        }),
        Node::Quotient(a, b) => {
            let ([mut above, mut below], [a, b]) = (factors(a), factors(b));
            above.extend(b);
            below.extend(a);
            [above, below]
        }
        Node::Number(value) if value == "1" => [Vec::new(), Vec::new()],
        _ => [vec![formula], Vec::new()],
    }
}

/// Removes what two lists have in common.
fn without_common(a: &mut Vec<&Expr>, b: &mut Vec<&Expr>) {
    a.retain(|factor| match b.iter().position(|other| other == factor) {
        Some(at) => {
            b.remove(at);
            false
        }
        None => true,
    });
}

fn quotient(above: &[&Expr], below: &[&Expr], like: &Expr) -> Expr {
    let product = |factors: &[&Expr]| match factors {
        [] => Expr::integer(1, like.span),
        [only] => (*only).clone(),
        all => Expr::new(Node::Product(all.iter().map(|factor| (*factor).clone()).collect()), like.span),
    };
    match below {
        [] => product(above),
        _ => Expr::new(Node::Quotient(Box::new(product(above)), Box::new(product(below))), like.span),
    }
}
