//! Lines for the claims file that would make an equation checkable.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, SymbolId, text};
use crate::notes::claims::{Claim, Solved, Solves, Spanned};
use crate::source::Span;
use crate::suggest::in_json;

use crate::check::document::checker::Checker;
use crate::check::kinds::small;
use crate::check::model::claim::Link;
use crate::check::model::free_symbols;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::verdict::finding::Finding;

/// The only one of some names.
fn only<'s>(mut names: impl Iterator<Item = &'s SymbolId>) -> Option<&'s SymbolId> {
    let first = names.next();
    first.filter(|_| names.next().is_none())
}

impl Checker<'_> {
    /// The finding on ≈ where nothing says what is small, if it holds to first order when one coordinate is, or all are.
    pub(crate) fn inferred_small(&self, link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
        let model = self.model;
        let drawn = free_symbols::drawn(&[&link.lhs, &link.rhs], model);
        let coordinates: Vec<Expr> = model
            .coordinates
            .iter()
            .filter(|coordinate| drawn.contains(&coordinate.symbol))
            .map(|coordinate| {
                let node = Node::Symbol { id: coordinate.symbol, indices: Vec::new(), dots: 0 };
                Expr::new(node, link.lhs.span)
            })
            .collect();
        let mut tried: Vec<Vec<Expr>> = coordinates.chunks(1).map(<[Expr]>::to_vec).collect();
        tried.extend((coordinates.len() > 1).then(|| coordinates.clone()));
        // A small oscillation has a small velocity too.
        let with_rates: Vec<_> = tried.iter().filter_map(|names| small::with_rates(names, model)).collect();
        tried.extend(with_rates);
        // cos θ ≈ 1 − θ²/2 and a Lagrangian for small oscillations keep the second order.
        for (order, small) in (1..=3).flat_map(|order| tried.iter().map(move |small| (order, small))) {
            let found = small::check(link, small, order, context)?;
            if found.verdict.passes() {
                let names: Vec<String> = small.iter().map(|name| text::formula(name, &model.symbols)).collect();
                let message = format!("{}; taken to be small: {}", found.message, names.join(", "));
                return Ok(Some(Finding { message, ..found }));
            }
        }
        Ok(None)
    }

    /// The message that ≈ needs a limit or a small quantity, with the line that names one.
    pub(crate) fn needs_limit_or_small(&self, link: &Link, place: Span) -> String {
        let drawn = free_symbols::drawn(&[&link.lhs, &link.rhs], self.model);
        let plain = || drawn.iter().filter(|symbol| self.model.symbols.entry(**symbol).slots.is_empty());
        let varies = |symbol: &&_| !matches!(self.model.meaning(**symbol), Some(Meaning::Constant(_)));
        let symbol = only(plain().filter(varies)).or_else(|| only(plain()));
        // Which of several letters is small, only the author knows.
        let Some(symbol) = symbol else {
            let small = self.entry(place, "\"small\": \"…\"");
            let message = "≈ does not say when the two sides are nearly equal";
            let mut letters: Vec<String> = plain().map(|symbol| text::plain(&self.model.name(*symbol))).collect();
            letters.dedup();
            return match letters.is_empty() {
                true => format!("{message}; write {small} in the claims file, with what is small"),
                false => format!(
                    "{message}; write {small} in the claims file, with what is small: {}, or a quotient of these",
                    letters.join(", ")
                ),
            };
        };
        let name = self.model.name(*symbol);
        let small = self.entry(place, &format!("\"small\": {}", in_json(&name)));
        let message = format!("≈ does not say when the two sides are nearly equal; write {small} in the claims file");
        // An angle tends to infinity in no limit that anybody means.
        let may_grow = !self.model.symbols.entry(*symbol).angle;
        match may_grow {
            true => format!("{message}, or \"limit\": {} for a limit", in_json(&format!("{name}\\to\\infty"))),
            false => message,
        }
    }

    /// The finding on an equation that fails, with a remark where a side is a declared name that nothing determines: it is
    /// drawn at random then, and equals no formula.
    pub(crate) fn with_undetermined_name(&self, link: &Link, finding: Finding, context: &Context<'_>) -> Finding {
        if finding.code != Code::SidesDiffer || !context.options.explain || context.options.deduction {
            return finding;
        }
        if let Some(reason) = self.is_equation_for(link, context) {
            return Finding { message: format!("{}; {reason}", finding.message), ..finding };
        }
        let stands_in = |id, formula: &Expr| formula.symbols().iter().any(|(known, _)| *known == id);
        let laws = self.model.laws.iter().flat_map(|law| &law.hypotheses);
        let known: Vec<&Expr> =
            laws.chain(context.hypotheses).flat_map(|hypothesis| [&hypothesis.lhs, &hypothesis.rhs]).collect();
        let undetermined = |(side, other): (&Expr, &Expr)| match side.node {
            Node::Symbol { id, dots: 0, .. } => {
                let is_drawn = matches!(self.model.meaning(id), Some(Meaning::Constant(_) | Meaning::Varying(_)));
                let is_known = stands_in(id, other) || known.iter().any(|formula| stands_in(id, formula));
                (is_drawn && !is_known && context.local.is_empty()).then_some(id)
            }
            _ => None,
        };
        let Some(id) = [(&link.lhs, &link.rhs), (&link.rhs, &link.lhs)].into_iter().find_map(undetermined) else {
            return match self.lacks_a_motion(link, context).or_else(|| self.lacks_a_law(link, &known, context)) {
                Some(reason) => Finding { message: format!("{}; {reason}", finding.message), ..finding },
                None => finding,
            };
        };
        let name = text::plain(&self.model.name(id));
        let message = format!(
            "{}; {name} is declared, so this equation does not define it; remove the declaration of {name}, or list this \
             equation under \"laws\"",
            finding.message
        );
        Finding { message, ..finding }
    }

    /// That another display solves this one, which then is an equation for its unknown, and no identity.
    fn is_equation_for(&self, link: &Link, context: &Context<'_>) -> Option<String> {
        let display = self.notes.equations.iter().find(|display| display.body.contains(context.span))?;
        let id = display.id()?;
        let solves = |claim: &&&Claim| match &claim.solves {
            Some(Solves { of: Solved::Equation(address), unknowns, .. }) => {
                let own = |name: &Spanned<String>| self.symbol(name).ok();
                let has = |symbol| [&link.lhs, &link.rhs].iter().any(|side| self.model.depends_on(side, &[symbol]));
                address.text.trim_matches(['(', ')']) == id && unknowns.iter().filter_map(own).any(has)
            }
            _ => false,
        };
        let claims: Vec<&Claim> = self.claims.equations.iter().map(|(_, claim)| claim).collect();
        let solver = claims.iter().find(solves)?;
        let unknown = solver.solves.as_ref()?.unknowns.first()?;
        let entry =
            format!("\"expect\": \"refuted\", \"because\": {}", in_json(&format!("an equation for {}", unknown.value)));
        let (name, entry) = (text::plain(&unknown.value), self.entry(context.span, &entry));
        Some(format!(
            "another display solves this for {name}, so it is an equation for {name} and not an identity; write \
             {entry} in the claims file"
        ))
    }

    /// That nothing determines the accelerations in an equation.
    fn lacks_a_motion(&self, link: &Link, context: &Context<'_>) -> Option<String> {
        if self.model.has_motion() || context.has_hypotheses() || !context.local.is_empty() {
            return None;
        }
        let symbols = [&link.lhs, &link.rhs].map(|side| side.symbols()).concat();
        let is_free = |id| matches!(self.model.meaning(id), Some(Meaning::Varying(_) | Meaning::Coordinate(_)));
        let (id, dots) = symbols.into_iter().find(|(id, dots)| *dots > 1 && is_free(*id))?;
        Some(format!(
            "nothing determines {}; name a \"system\" or \"laws\", or say which name is the Lagrangian: \"means\": {{ \"L\": \
             \"Lagrangian\" }}",
            text::with_dots(&self.model.name(id), dots)
        ))
    }

    /// That nothing in the claims file relates a name on one side to those on the other.
    fn lacks_a_law(&self, link: &Link, known: &[&Expr], context: &Context<'_>) -> Option<String> {
        if self.model.has_motion() || !context.local.is_empty() {
            return None;
        }
        let [left, right] = [&link.lhs, &link.rhs].map(|side| free_symbols::drawn(&[side], self.model));
        let is_free = |id: &&SymbolId| {
            let is_drawn = matches!(self.model.meaning(**id), Some(Meaning::Constant(_) | Meaning::Varying(_)));
            is_drawn && !known.iter().any(|formula| formula.symbols().iter().any(|(other, _)| other == *id))
        };
        let on_one_side =
            |own: &[SymbolId], other: &[SymbolId]| own.iter().any(|id| !other.contains(id) && is_free(&id));
        if !on_one_side(&left, &right) && !on_one_side(&right, &left) {
            return None;
        }
        let display = self.notes.equations.iter().find(|display| display.body.contains(context.span));
        let id = display.and_then(|display| display.id()).unwrap_or("…");
        Some(format!(
            "nothing in the claims file makes this true; if it is a law, list it under \"laws\": {{ \"…\": {} }}",
            in_json(id)
        ))
    }

    /// A key with its value as a line to add to the claims file for the equation at a place.
    fn entry(&self, place: Span, line: &str) -> String {
        let display = self.notes.equations.iter().position(|display| display.body.contains(place));
        let id = display.and_then(|at| self.notes.equations[at].id().filter(|_| self.assigned[at].is_none()));
        match id {
            Some(id) if self.claims.equations.is_empty() => {
                format!("\"equations\": {{ {}: {{ {line} }} }}", in_json(id))
            }
            Some(id) => format!("{}: {{ {line} }} under \"equations\"", in_json(id)),
            None => format!("{line} in the entry of the equation"),
        }
    }
}
