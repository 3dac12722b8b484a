//! Claims that hold on one branch of an inverse function or of a root, and fail on the others.
//!
//! With φ = arctan(y/x) the equation x = √(x² + y²) cos φ holds for x > 0. For x < 0 the angle that is meant is φ + π: the
//! definition is a way of speaking, and the equation is no slip. The same goes for a root that a definition takes with the
//! one sign, and for a root that solves a definition.
//!
//! So a claim that is refuted is tested once more at each state where it fails, with other branches there. If it holds on one
//! at each of them, and there is a condition under which it holds as printed at all states, nothing is called wrong. The
//! condition is not proved: arctan(tan x) = x holds for few of the x > 0. So the finding says where the claim fails, with the
//! values of the function, and at how many states it was seen to hold. Where the condition is about a name that the document defines, as the angular momentum in Ω = √(…),
//! the claim is judged once more under it: the author could declare no range of the name. A condition says that something is *positive*: x = −r cos φ holds for x < 0, and is a slip.

use crate::code::Code;
use crate::formula::tree::Function;
use crate::formula::{Expr, Node, Sign, SymbolId, text};
use crate::scalar::RunningError;

use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::free_symbols::drawn;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::ensemble::Ensemble;
use crate::check::state::residual::{self, Point};
use crate::check::state::sampled_state::SampledState;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The largest depth of definitions within definitions.
const DEEPEST: usize = 6;

/// The most symbols that are replaced by their definitions.
const MOST_REPLACED: usize = 200;

/// The most functions whose branches are combined.
const MOST_FUNCTIONS: usize = 3;

/// The most conditions that are tried, and of which pairs are tried.
const MOST_CONDITIONS: usize = 12;

/// The fewest states that must obey the condition under which a claim holds.
const FEWEST_THAT_HOLD: usize = 3;

type States<'s, 'm> = &'s [SampledState<'m, RunningError>];

/// States, and whether a claim holds at each.
type Sampled<'s, 'm> = (States<'s, 'm>, &'s [Option<bool>]);

/// A refuted finding, or in its place the finding that the claim holds on one branch; beside it the defined name that must be
/// positive there, if one does.
pub(crate) fn on_another_branch(
    link: &Link,
    context: &Context<'_>,
    ensemble: &Ensemble<'_>,
    finding: Finding,
) -> (Finding, Option<Expr>) {
    let Some(Branch { functions, condition, holding, name }) = branch(link, context.model, ensemble) else {
        return (finding, None);
    };
    let values =
        |function: &Expr| format!("{} {}", text::formula(function, &context.model.symbols), principal_values(function));
    let values: Vec<String> = functions.iter().map(values).collect();
    let message = format!(
        "holds only where {condition}, because {}; it holds at the {holding} sampled states with {condition}, and fails at \
         others",
        values.join(", and ")
    );
    (Finding { max_residual: None, ..finding.replaced(Code::OneBranch, Verdict::Domain, message) }, name)
}

/// Leaves those of the states at which the defined name is positive on which the branch of a claim depends.
pub(crate) fn on_its_branch(link: &Link, model: &Model, ensemble: &mut Ensemble<'_>) {
    if let Some(name) = branch(link, model, ensemble).and_then(|branch| branch.name) {
        let mut obeyed = positive(&name, &ensemble.states).into_iter();
        ensemble.states.retain(|_| obeyed.next() == Some(true));
    }
}

/// The branch on which a claim holds.
struct Branch {
    /// The functions that have another value elsewhere.
    functions: Vec<Expr>,
    /// The condition under which it holds at all states, in words.
    condition: String,
    /// The number of states at which it holds under this condition.
    holding: usize,
    /// The defined name that is positive there, if nothing else is.
    name: Option<Expr>,
}

/// The branch on which a claim holds that fails at some of the states.
fn branch(link: &Link, model: &Model, ensemble: &Ensemble<'_>) -> Option<Branch> {
    let definitions = Definitions { model, rules: &ensemble.rules };
    let mut functions = definitions.functions_of(link);
    if functions.is_empty() {
        return None;
    }
    let names = definitions.names_of(link);
    let link = Link { lhs: definitions.expanded(&link.lhs), rhs: definitions.expanded(&link.rhs), ..link.clone() };
    let outcome = |state| match residual::test(&link, state) {
        Ok(Point::Holds(_)) => Some(true),
        Ok(Point::Fails(_)) => Some(false),
        _ => None,
    };
    let outcomes: Vec<Option<bool>> = ensemble.states.iter().map(outcome).collect();
    let with = |wanted| outcomes.iter().filter(|outcome| **outcome == Some(wanted)).count();
    if with(true) < FEWEST_THAT_HOLD || with(false) == 0 {
        return None;
    }
    let all_hold = |functions: &[Expr]| {
        let variants = variants(&link, functions);
        let holds = |state| variants.iter().any(|other| matches!(residual::test(other, state), Ok(Point::Holds(_))));
        let mut failing = ensemble.states.iter().zip(&outcomes).filter(|(_, outcome)| **outcome == Some(false));
        failing.all(|(state, _)| holds(state))
    };
    if !all_hold(&functions) {
        return None;
    }
    // Only those that are needed are named.
    for at in (0..functions.len()).rev() {
        let others = [&functions[..at], &functions[at + 1..]].concat();
        if all_hold(&others) {
            functions = others;
        }
    }
    let sampled: Sampled<'_, '_> = (&ensemble.states, &outcomes);
    if let Some((condition, holding)) = condition(&link, &functions, model, sampled) {
        return Some(Branch { functions, condition, holding, name: None });
    }
    let suffices = |name: &Expr| holding(&[&positive(name, sampled.0)], sampled.1);
    let (name, holding) = names.into_iter().find_map(|name| suffices(&name).map(|count| (name, count)))?;
    Some(Branch { functions, condition: is_positive(&name, model), holding, name: Some(name) })
}

/// The definitions of the document and of a claim.
struct Definitions<'a> {
    model: &'a Model,
    rules: &'a [Rule],
}

impl Definitions<'_> {
    /// The formula of a symbol without indices.
    fn of(&self, id: SymbolId) -> Option<&Expr> {
        let by_rule = self.rules.iter().rev().find(|rule| rule.symbol == id && rule.letters.is_empty());
        match (by_rule.map(|rule| &rule.action), self.model.meaning(id)) {
            (Some(Action::Equals(formula)), _) => Some(formula),
            (None, Some(Meaning::Defined(formula))) => Some(formula),
            _ => None,
        }
    }

    /// The defined names in a claim, and in what defines them, the outer ones first.
    fn names_of(&self, link: &Link) -> Vec<Expr> {
        let mut found: Vec<Expr> = Vec::new();
        let mut next: Vec<Expr> = vec![link.lhs.clone(), link.rhs.clone()];
        for _ in 0..DEEPEST {
            let mut inner = Vec::new();
            for formula in &next {
                formula.walk(&mut |part| {
                    if let Some(id) = part.as_plain_symbol()
                        && let Some(definition) = self.of(id)
                        && !found.contains(part)
                        && found.len() < MOST_CONDITIONS
                    {
                        found.push(part.clone());
                        inner.push(definition.clone());
                    }
                });
            }
            next = inner;
        }
        found
    }

    /// A formula with definitions in place of all names.
    fn expanded(&self, formula: &Expr) -> Expr {
        let mut expanded = formula.clone();
        let mut left = MOST_REPLACED;
        self.expand(&mut expanded, DEEPEST, &mut left);
        expanded
    }

    fn expand(&self, formula: &mut Expr, depth: usize, left: &mut usize) {
        if let Node::Symbol { id, indices, dots } = &formula.node
            && indices.is_empty()
            && let Some(definition) = self.of(*id)
        {
            if depth == 0 || *left == 0 {
                return;
            }
            *left -= 1;
            let (dots, span) = (*dots, formula.span);
            let mut inner = definition.clone();
            self.expand(&mut inner, depth - 1, left);
            *formula = if dots == 0 { inner } else { Expr::new(Node::TimeDerivative(dots, Box::new(inner)), span) };
            return;
        }
        formula.children_mut().into_iter().for_each(|child| self.expand(child, depth, left));
    }

    /// The functions with several branches on which a claim rests, expanded: inverse functions, and the even roots that
    /// stand in a definition or contain a defined name.
    fn functions_of(&self, link: &Link) -> Vec<Expr> {
        let mut found = Vec::new();
        let mut known = Vec::new();
        for side in [&link.lhs, &link.rhs] {
            self.collect(side, false, &mut known, &mut found);
        }
        // The likeliest first: an angle that is given by two lengths, then other angles, then roots.
        found.sort_by_key(|function| match &function.node {
            Node::Call(Function::Arctan, inner) if matches!(inner.node, Node::Quotient(..)) => 0,
            Node::Call(..) => 1,
            _ => 2,
        });
        found.truncate(MOST_FUNCTIONS);
        found
    }

    fn collect(&self, formula: &Expr, is_defined: bool, known: &mut Vec<SymbolId>, into: &mut Vec<Expr>) {
        formula.walk(&mut |part| {
            let is_root = |inner: &Expr| is_defined || inner.symbols().iter().any(|(id, _)| self.of(*id).is_some());
            let is_one = match &part.node {
                Node::Call(Function::Arctan | Function::Arcsin | Function::Arccos, _) => true,
                Node::Root(degree, inner) => degree % 2 == 0 && is_root(inner),
                _ => false,
            };
            if is_one {
                let part = self.expanded(part);
                if !into.contains(&part) {
                    into.push(part);
                }
            }
            if let Node::Symbol { id, .. } = &part.node
                && let Some(definition) = self.of(*id).filter(|_| !known.contains(id))
            {
                known.push(*id);
                self.collect(definition, true, known, into);
            }
        });
    }
}

/// The values that a function with several branches has, as a predicate.
fn principal_values(function: &Expr) -> &'static str {
    match &function.node {
        Node::Call(Function::Arctan | Function::Arcsin, _) => "lies between −π/2 and π/2",
        Node::Call(Function::Arccos, _) => "lies between 0 and π",
        _ => "is not negative",
    }
}

/// The other values of a function with several branches.
fn other_values(function: &Expr) -> Vec<Expr> {
    let pi = |times: u32| {
        let node = Node::Product(vec![Expr::integer(times, function.span), Expr::new(Node::Pi, function.span)]);
        Expr::new(node, function.span)
    };
    let own = || function.clone();
    match &function.node {
        Node::Call(Function::Arctan, _) => vec![own().minus(pi(1).negated()), own().minus(pi(1))],
        Node::Call(Function::Arcsin, _) => vec![pi(1).minus(own()), pi(1).negated().minus(own())],
        Node::Call(Function::Arccos, _) => vec![own().negated(), pi(2).minus(own())],
        _ => vec![own().negated()],
    }
}

/// The claim with every combination of other branches.
fn variants(link: &Link, functions: &[Expr]) -> Vec<Link> {
    let mut found = vec![link.clone()];
    for function in functions {
        let others = other_values(function);
        let replaced = |link: &Link, other: &Expr| {
            let mut link = link.clone();
            for side in [&mut link.lhs, &mut link.rhs] {
                side.substitute(&|node| (*node == function.node).then(|| other.clone()));
            }
            link
        };
        let more: Vec<Link> = found
            .iter()
            .flat_map(|link| others.iter().map(|other| replaced(link, other)).collect::<Vec<_>>())
            .collect();
        found.extend(more);
    }
    found.remove(0);
    found
}

/// A condition under which a claim holds at all states, in words, and the number of these states.
fn condition(
    link: &Link,
    functions: &[Expr],
    model: &Model,
    (states, outcomes): Sampled<'_, '_>,
) -> Option<(String, usize)> {
    let mut candidates: Vec<Expr> = Vec::new();
    let mut add = |formula: &Expr| {
        if !candidates.contains(formula) && !formula.symbols().is_empty() {
            candidates.push(formula.clone());
        }
    };
    for function in functions {
        if let Node::Call(Function::Arctan, inner) = &function.node
            && let Node::Quotient(_, below) = &inner.node
        {
            add(below);
        }
    }
    let sides = [&link.lhs, &link.rhs];
    for id in drawn(&sides, model) {
        add(&Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, link.lhs.span));
    }
    let begins_with_plus = |side: &&Expr| matches!(&side.node, Node::Sum(terms) if terms.first().is_some_and(|term| term.sign == Sign::Plus));
    sides.into_iter().filter(begins_with_plus).for_each(&mut add);
    for side in sides {
        side.walk(&mut |part| {
            if matches!(part.node, Node::Call(Function::Sin | Function::Cos | Function::Tan, _)) {
                add(part);
            }
        });
    }
    candidates.truncate(MOST_CONDITIONS);
    let obeyed: Vec<(&Expr, Vec<bool>)> =
        candidates.iter().map(|formula| (formula, positive(formula, states))).collect();
    let said = |formula: &Expr| is_positive(formula, model);
    let alone = |(formula, obeyed): &(&Expr, Vec<bool>)| Some((said(formula), holding(&[obeyed], outcomes)?));
    let with_another = |(at, (first, one)): (usize, &(&Expr, Vec<bool>))| {
        let mut others = obeyed[at + 1..].iter();
        others.find_map(|(second, other)| {
            Some((format!("{} and {}", said(first), said(second)), holding(&[one, other], outcomes)?))
        })
    };
    obeyed.iter().find_map(alone).or_else(|| obeyed.iter().enumerate().find_map(with_another))
}

/// That a formula is positive, in words.
fn is_positive(formula: &Expr, model: &Model) -> String {
    format!("{} > 0", text::formula(formula, &model.symbols))
}

/// Whether a formula is positive, at each state.
fn positive(formula: &Expr, states: States<'_, '_>) -> Vec<bool> {
    let is_positive = |state: &SampledState<'_, RunningError>| {
        state.now(formula, &[]).is_ok_and(|value| value.entries().first().is_some_and(|entry| entry.value > 0.0))
    };
    states.iter().map(is_positive).collect()
}

/// The number of states that obey all conditions and at which a claim holds, if they are enough and it fails at none.
fn holding(all: &[&Vec<bool>], outcomes: &[Option<bool>]) -> Option<usize> {
    let within = |at: &usize| all.iter().all(|obeyed| obeyed[*at]);
    let inside = (0..outcomes.len()).filter(within).map(|at| outcomes[at]);
    let (mut count, mut holds) = (0, true);
    inside.for_each(|outcome| {
        count += usize::from(outcome == Some(true));
        holds &= outcome != Some(false);
    });
    (holds && count >= FEWEST_THAT_HOLD).then_some(count)
}
