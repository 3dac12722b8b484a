//! A period beside its angular frequency, and a wavelength beside its wave number.
//!
//! By custom `T_0` is 2π over `\omega_0`, `f` is `\omega` over 2π, and `\lambda` is 2π over `k`. Where one display gives such a name a
//! formula with π in it, and the display beside it gives the other name a formula, the two are compared. Only where a likely slip
//! lies between them one of the two is wrong: the same letters may mean other things.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::unaided::contradictions::{contradicted, open, refuted};
use crate::check::unaided::dimensions;
use crate::check::unaided::motion::are_equal;
use crate::check::unaided::motion::given::{Given, corrected};
use crate::check::unaided::scope::Scope;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::formula::symbols::Kind;
use crate::formula::{Expr, Node, SymbolId, text};

/// Letters of two quantities, and what one is in terms of the other.
struct Custom {
    /// The letters of the one with π in its formula.
    letters: &'static [&'static str],
    /// What it is called.
    called: &'static str,
    /// The letters of the other.
    others: &'static [&'static str],
    /// Whether it is 2π over the other; else it is the other over 2π.
    is_inverse: bool,
}

const CUSTOMS: [Custom; 3] = [
    Custom {
        letters: &["T", "\\tau", "P", "\\mathcal{T}"],
        called: "period",
        others: &["\\omega", "\\Omega"],
        is_inverse: true,
    },
    Custom { letters: &["f", "\\nu"], called: "frequency", others: &["\\omega", "\\Omega"], is_inverse: false },
    Custom { letters: &["\\lambda"], called: "wavelength", others: &["k"], is_inverse: true },
];

impl Custom {
    /// What the one is, if the other is a formula.
    fn of(&self, other: Expr) -> Expr {
        let span = other.span;
        let turn = Expr::new(Node::Product(vec![Expr::integer(2, span), Expr::new(Node::Pi, span)]), span);
        let (above, below) = if self.is_inverse { (turn, other) } else { (other, turn) };
        Expr::new(Node::Quotient(Box::new(above), Box::new(below)), span)
    }
}

/// Compares periods and wavelengths with the frequencies and wave numbers beside them.
///
/// # Errors
/// As for a check of an equation.
pub(super) fn weighed(checker: &Checker<'_>, scope: &Scope, found: &mut [Equation]) -> Result<()> {
    let all = given(checker, scope, found);
    for one in &all {
        for custom in CUSTOMS.iter().filter(|custom| is_one_of(checker, one, custom.letters) && has_pi(&one.formula)) {
            let is_beside = |other: &&Given| {
                one.at.abs_diff(other.at) <= 1
                    && scope.section_of(one.at) == scope.section_of(other.at)
                    && is_one_of(checker, other, custom.others)
                    && of_the_same_thing(checker, one.id, other.id)
            };
            let mut others = all.iter().filter(is_beside);
            if let (Some(other), None) = (others.next(), others.next()) {
                compare(checker, scope.carried, custom, (one, other), found)?;
            }
        }
    }
    Ok(())
}

/// Says which of two formulas is wrong, where they do not belong together and an edit of one makes them.
fn compare(
    checker: &Checker<'_>,
    first: usize,
    custom: &Custom,
    (one, other): (&Given, &Given),
    found: &mut [Equation],
) -> Result<()> {
    let (at, of) = (one.at - first, other.at - first);
    let is_passed = |equation: &Equation| equation.finding.verdict.passes();
    if !is_passed(&found[at]) || !is_passed(&found[of]) {
        return Ok(());
    }
    let equal = |a: &Expr, b: Expr| are_equal(checker, a, &custom.of(b), false);
    if equal(&one.formula, other.formula.clone())? {
        return Ok(());
    }
    let is_plausible = |at: usize, repair: &Repair| !dimensions::are_spoilt(checker, at, repair);
    let of_one = corrected(checker, one, &|formula| equal(&formula, other.formula.clone()))?
        .filter(|repair| is_plausible(one.at, repair));
    let of_other = corrected(checker, other, &|formula| equal(&one.formula, formula))?
        .filter(|repair| is_plausible(other.at, repair));
    let name = |given: &Given| text::plain(&checker.model.name(given.id));
    let relation = match custom.is_inverse {
        true => format!("2π/{}", name(other)),
        false => format!("{}/2π", name(other)),
    };
    let says = |id: &str| {
        let (called, beside) = (custom.called, if at == of { String::new() } else { format!(" with ({id})") });
        format!("the {called} {} is not {relation}{beside}; a likely mistake explains it", name(one))
    };
    let (id, other_id) = (found[at].id.clone(), found[of].id.clone());
    let is_tested = |equation: &Equation| {
        equation.finding.verdict != Verdict::Assumed && !equation.finding.leaves_a_definition_open()
    };
    match (of_one, of_other) {
        (Some(repair), more) if at == of => {
            found[at] = refuted(&found[at], &repair, says(&id));
            found[at].repairs.extend(more);
        }
        (Some(repair), _) if is_tested(&found[of]) => found[at] = refuted(&found[at], &repair, says(&other_id)),
        (_, Some(repair)) if is_tested(&found[at]) || at == of => found[of] = refuted(&found[of], &repair, says(&id)),
        (Some(repair), None) => found[at] = refuted(&found[at], &repair, says(&other_id)),
        (None, Some(repair)) => found[of] = refuted(&found[of], &repair, says(&id)),
        (Some(_), Some(repair)) => {
            found[at] = open(&found[at], &other_id, repair);
            found[of] = contradicted(&found[of], &id);
        }
        (None, None) => {}
    }
    Ok(())
}

/// The names of numbers that are whole left sides, with their formulas.
fn given(checker: &Checker<'_>, scope: &Scope, found: &[Equation]) -> Vec<Given> {
    let places = scope.carried..scope.carried + found.len();
    let is_number = |id: SymbolId| {
        let entry = checker.model.symbols.entry(id);
        entry.kind == Kind::Scalar && !entry.squared && entry.arguments.is_empty()
    };
    let all = places.flat_map(|at| checker.readings[at].introduced.iter().map(move |new| (at, new)));
    all.filter(|(_, new)| new.member == 0 && is_number(new.symbol))
        .map(|(at, new)| Given { at, id: new.symbol, formula: new.formula.clone() })
        .collect()
}

fn is_one_of(checker: &Checker<'_>, given: &Given, letters: &[&str]) -> bool {
    letters.contains(&checker.model.symbols.entry(given.id).name.base.as_str())
}

/// Whether two names have the same subscript, so that one is of what the other is of.
fn of_the_same_thing(checker: &Checker<'_>, a: SymbolId, b: SymbolId) -> bool {
    let [a, b] = [a, b].map(|id| &checker.model.symbols.entry(id).name);
    a.subscript == b.subscript
}

fn has_pi(formula: &Expr) -> bool {
    let mut found = false;
    formula.walk(&mut |part| found |= part.node == Node::Pi);
    found
}
