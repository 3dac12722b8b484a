//! A period beside its angular frequency, and a wavelength beside its wave number.
//!
//! By custom `T_0` is 2π over `\omega_0`, `f` is `\omega` over 2π, and `\lambda` is 2π over `k`. Where one display gives such a name a
//! formula with π in it, and a display near it gives the other name a formula, the two are compared. Only where an inverted fraction
//! or a wrong power lies between them one of the two is wrong: the same letters may mean another motion.

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
use crate::formula::{Expr, Node, Relation, Statement, SymbolId, text};
use crate::latex::slips::{Edit, Slip};

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

/// The most displays from one to the other: farther away the letters mean something else more often.
const FARTHEST: usize = 2;

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
                one.at.abs_diff(other.at) <= FARTHEST
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
    let is_plausible = |given: &Given, repair: &Repair| !dimensions::are_spoilt(checker, given.at, repair);
    let edit_of = |given: &Given, is_sought: &dyn Fn(Expr) -> Result<bool>| -> Result<Option<Repair>> {
        let text = &checker.notes.equations[given.at].text;
        let found = corrected(checker, given, &|edit| changes_dimensions(text, edit), is_sought)?;
        Ok(found.filter(|repair| is_plausible(given, repair)))
    };
    let of_one = edit_of(one, &|formula| equal(&formula, other.formula.clone()))?;
    let of_other = edit_of(other, &|formula| equal(&one.formula, formula))?;
    let name = |given: &Given| text::plain(&checker.model.name(given.id));
    let relation = match custom.is_inverse {
        true => format!("2π/{}", name(other)),
        false => format!("{}/2π", name(other)),
    };
    let says = |id: &str| {
        let (called, beside) = (custom.called, if at == of { String::new() } else { format!(" with ({id})") });
        format!("the {called} {} is not {relation}{beside}, but it is after the suggested edit", name(one))
    };
    let (id, other_id) = (found[at].id.clone(), found[of].id.clone());
    let (one_is_tested, other_is_tested) =
        (is_tested(checker, first, one, found), is_tested(checker, first, other, found));
    match (of_one, of_other) {
        (Some(repair), more) if at == of => {
            found[at] = refuted(&found[at], &repair, says(&id));
            found[at].repairs.extend(more);
        }
        (Some(repair), _) if other_is_tested => found[at] = refuted(&found[at], &repair, says(&other_id)),
        (_, Some(repair)) if one_is_tested || at == of => found[of] = refuted(&found[of], &repair, says(&id)),
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

/// Whether a formula of a name follows, or another display follows with it.
fn is_tested(checker: &Checker<'_>, first: usize, given: &Given, found: &[Equation]) -> bool {
    let uses = |place: usize| {
        let members = checker.readings[first + place].statements.iter().flatten().flat_map(|one| &one.members);
        members.flat_map(Expr::symbols).any(|(id, _)| id == given.id)
    };
    let follows = |equation: &Equation| matches!(equation.finding.verdict, Verdict::Certified | Verdict::Verified);
    found.iter().enumerate().any(|(place, equation)| follows(equation) && uses(place))
}

/// The names of numbers that are whole left sides, with their formulas.
fn given(checker: &Checker<'_>, scope: &Scope, found: &[Equation]) -> Vec<Given> {
    let places = scope.carried..scope.carried + found.len();
    let statements = places.flat_map(|at| checker.readings[at].statements.iter().flatten().map(move |one| (at, one)));
    let given = |(at, statement): (usize, &Statement)| {
        let [first, .., formula] = statement.members.as_slice() else { return None };
        let id = first.as_plain_symbol()?;
        let entry = checker.model.symbols.entry(id);
        let is_number = entry.kind == Kind::Scalar && !entry.squared && entry.arguments.is_empty();
        let is_formula = statement.relations.iter().all(|(relation, _)| *relation == Relation::Equal);
        (is_number && is_formula && statement.branch.is_none()).then(|| Given { at, id, formula: formula.clone() })
    };
    statements.filter_map(given).collect()
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

/// Whether an edit inverts a fraction of names or changes a power. By a number or by another name the motion of another system differs: two
/// springs in place of one, half a period.
fn changes_dimensions(text: &str, edit: &Edit) -> bool {
    match edit.slip {
        Slip::Exponent => true,
        Slip::Fraction => has_letters(&text[edit.span.range()]) || has_letters(&edit.replacement),
        _ => false,
    }
}

/// Whether a text has names, and not only numbers in fractions and roots.
fn has_letters(text: &str) -> bool {
    let marks = ["\\frac", "\\tfrac", "\\dfrac", "\\sqrt"];
    let bare = marks.iter().fold(text.to_owned(), |text, mark| text.replace(mark, ""));
    bare.contains(char::is_alphabetic)
}
