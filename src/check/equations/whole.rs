//! Claims about an equation as a whole: `solves`, `also equals`, `conserved`, `symmetry`, `generates`, `equilibrium`.

use crate::check::document::checker::Checker;
use crate::check::hypotheses::rule::Rule;
use crate::check::judge::identity;
use crate::check::kinds::mechanics::{charge, equilibrium, generates, same_motion};
use crate::check::kinds::{conserved, solves};
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Part;
use crate::code::Code;
use crate::formula::tree::Sign;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId, text};
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::{Claim, Conserved, Equilibrium, Holds, Solved, Solves, Spanned};
use crate::suggest::in_json;
use crate::{Error, Result};

impl Checker<'_> {
    /// Adds the findings on `solves`, `also equals`, `conserved` and `generates` to the parts of an equation.
    ///
    /// # Errors
    /// For a claim that does not fit the equation, at its place in the claims file.
    pub(crate) fn whole(
        &self,
        reading: &Reading,
        claim: &Claim,
        (hypotheses, local): (&[Hypothesis], &[Rule]),
        offset: usize,
        topic: &str,
        parts: &mut Vec<Part>,
    ) -> Result<()> {
        let statements: Vec<&Statement> = reading.statements.iter().flatten().collect();
        let Some(last) = statements.last() else { return Ok(()) };
        let Some(printed) = last.members.last() else { return Ok(()) };
        let span = statements[0].span.to(last.span).shifted(offset);
        let topic = format!("{topic} whole");
        let on_shell = claim.holds.as_ref().map(|holds| holds.value == Holds::OnShell);
        let context = Context {
            model: self.model,
            options: self.options,
            hypotheses,
            on_shell,
            topic: &topic,
            span,
            spread: Spread::Declared,
            local,
        };
        if let Some(solves) = &claim.solves {
            self.claimed_solutions(solves, &statements, offset, &context, parts)?;
        }
        if let Some(also) = &claim.also_equals {
            parts.push(self.also_equal(also, printed, reading, claim, &context)?);
        }
        if let Some(conserved) = &claim.conserved {
            self.conserved(conserved, reading, &statements, &context, parts)?;
        }
        if let Some(other) = &claim.same_motion_as {
            let lagrangian = self.formula(other).map_err(|error| match error.missing() {
                Some(_) => error.help(format!(
                    "for the Lagrangian of the notes, add \"means\": {{ {}: \"Lagrangian\" }} to the claims file",
                    in_json(&other.value)
                )),
                _ => error,
            })?;
            let finding = same_motion::check(printed, &lagrangian, &context)?;
            parts.push(self.part(finding, format!("the same motion as {}", other.value)));
        }
        if !claim.symmetry.is_empty() {
            let change = claim.symmetry.iter().map(|(name, latex)| Ok((self.symbol(name)?, self.formula(latex)?)));
            let finding = charge::check(printed, &change.collect::<Result<Vec<_>>>()?, &context)?;
            let what = text::formula(printed, &self.model.symbols);
            parts.push(self.part(finding, format!("{what} is the charge of the symmetry")));
        }
        if claim.generates.is_some() {
            let finding = generates::check(printed, &context)?;
            parts.push(self.part(finding, "it generates the motion by Hamilton's equations".to_owned()));
        }
        Ok(())
    }

    /// The findings on statements that solve an equation: that they are all solutions, and that each of them is one.
    fn claimed_solutions(
        &self,
        solves: &Solves,
        statements: &[&Statement],
        offset: usize,
        context: &Context<'_>,
        parts: &mut Vec<Part>,
    ) -> Result<()> {
        let address = match &solves.of {
            Solved::Equation(address) => Spanned::new(address.text.clone(), address.span),
            Solved::EquationsOfMotion(span) => {
                let message = "\"solves\" does not support the equations of motion; remove it, and a formula such as \
                               x(t) = … is checked against the motion";
                return Err(Error::at(&self.claims.source, *span, message));
            }
        };
        let [unknown] = solves.unknowns.as_slice() else {
            return Err(Error::at(
                &self.claims.source,
                address.span,
                "\"solves\" supports only one unknown; name one symbol under \"for\"",
            ));
        };
        let targets = self.targets(&address)?;
        let symbol = self.symbol(unknown)?;
        let name = text::plain(&self.model.name(symbol));
        let branches: Vec<Expr> = statements.iter().filter_map(|s| s.members.last().cloned()).collect();
        let Some(target) = solves::equality_for(&targets, symbol, &branches, context)? else {
            let message = format!(
                "({}) holds for every {name}, so there is nothing to solve; name another equation under \"solves\"",
                address.value
            );
            parts.push(self.part(context.finding(Code::NotDecided, Verdict::Undecided, message), name));
            return Ok(());
        };
        if solves.complete {
            let finding = solves::check(target, symbol, &branches, context)?;
            parts.push(self.part(finding, format!("all solutions of ({}) for {name}", address.value)));
        }
        if branches.len() > 1 || !solves.complete {
            for (statement, branch) in statements.iter().zip(&branches) {
                let span = statement.span.shifted(offset);
                let of_branch = Context { span, ..*context };
                let finding = solves::check_branch(target, symbol, branch, &of_branch)?;
                let reading = text::statement(statement, &self.model.symbols);
                parts.push(self.part(finding, format!("{reading} solves ({}) for {name}", address.value)));
            }
        }
        Ok(())
    }

    /// The finding on an expression that the last member of the display equals too.
    fn also_equal(
        &self,
        also: &Spanned<String>,
        printed: &Expr,
        reading: &Reading,
        claim: &Claim,
        context: &Context<'_>,
    ) -> Result<Part> {
        let other = self.formula(also)?;
        let printed = match &claim.dropping {
            Some(dropped) => with_dropped(printed, &self.formula(dropped)?),
            None => printed.clone(),
        };
        let link = self.link(&other, Relation::Equal, &printed)?;
        let finding = match self.only_repeats(&link, &reading.introduced) {
            true => {
                let message =
                    "\"also equals\" only repeats the printed formula, so nothing is checked; give another form";
                context.finding(Code::Circular, Verdict::Undecided, message)
            }
            false => {
                let finding = identity::check(&link, context)?;
                match finding.verdict {
                    Verdict::Refuted => {
                        let would_hold = finding.mutant.clone().unwrap_or_default();
                        let message = format!(
                            "the formula of \"also equals\" (left side) differs from the printed formula (right \
                             side){would_hold}"
                        );
                        Finding { message, ..finding }
                    }
                    _ => finding,
                }
            }
        };
        let shown =
            text::formula(&link.lhs, &self.model.symbols) + " = " + &text::formula(&link.rhs, &self.model.symbols);
        Ok(self.part(finding, shown))
    }

    /// The findings on what the claim says to be constant.
    fn conserved(
        &self,
        conserved: &Spanned<Conserved>,
        reading: &Reading,
        statements: &[&Statement],
        context: &Context<'_>,
        parts: &mut Vec<Part>,
    ) -> Result<()> {
        // Of several statements each has something that is constant.
        let all = match &conserved.value {
            Conserved::Expression(latex) => {
                vec![(self.formula(&Spanned::new(latex.clone(), conserved.span))?, None)]
            }
            Conserved::This => {
                // What a statement itself says to be constant is judged with it.
                let open = statements.iter().enumerate().filter(|(_, s)| s.constant.is_none());
                open.filter_map(|(at, s)| Some((s.members.last()?.clone(), Some(at)))).collect()
            }
        };
        for (what, at) in all {
            let mut finding = conserved::check(&what, context)?;
            if let Some(at) = at {
                let introduced: Vec<&DefinedSymbol> = reading.introduced.iter().filter(|i| i.statement == at).collect();
                self.only_constant(&introduced, statements[at], &mut finding)?;
            }
            parts.push(self.part(finding, format!("{} is constant", text::formula(&what, &self.model.symbols))));
        }
        Ok(())
    }

    /// The findings on a display that prints equilibria, one for each statement. What other statements say of other
    /// coordinates holds too; what they say of the same coordinates is another equilibrium.
    ///
    /// # Errors
    /// For a claim that does not fit the equation.
    pub(crate) fn equilibria(
        &self,
        reading: &Reading,
        (claim, claimed): (&Claim, Equilibrium),
        hypotheses: &[Hypothesis],
        offset: usize,
        topic: &str,
    ) -> Result<Vec<Part>> {
        let coordinates = |statement: &Statement| -> Vec<SymbolId> {
            let all = self.model.coordinates.iter().map(|coordinate| coordinate.symbol);
            all.filter(|q| statement.members.iter().any(|member| self.model.depends_on(member, &[*q]))).collect()
        };
        let mut given = hypotheses.to_vec();
        for (name, latex) in &claim.at {
            let place = Expr::new(
                Node::Symbol { id: self.symbol(name)?, indices: Vec::new(), dots: 0 },
                crate::source::Span::default(),
            );
            given.push(Hypothesis::of(self.link(&place, Relation::Equal, &self.formula(latex)?)?, false));
        }
        let said = |at: usize, statement: &Statement| -> Result<Vec<Hypothesis>> {
            let is_definition = reading.introduced.iter().any(|introduced| introduced.statement == at);
            let links = statement.relations.iter().enumerate().filter(|_| !is_definition);
            let link = |(n, (relation, _)): (usize, &(Relation, _))| {
                let link = self.link(&statement.members[n], *relation, &statement.members[n + 1])?;
                Ok(Hypothesis::of(link, false))
            };
            links.map(link).collect()
        };
        let statements: Vec<(usize, &Statement)> =
            reading.statements.iter().enumerate().filter_map(|(at, s)| Some((at, s.as_ref().ok()?))).collect();
        let mut parts = Vec::new();
        // Statements that make one equilibrium are judged once.
        let mut judged: Vec<(Vec<usize>, Finding)> = Vec::new();
        for (at, statement) in &statements {
            let topic = format!("{topic} equilibrium {}", at + 1);
            let mut worst: Option<Finding> = None;
            for mut together in places_with(&statements, *at, &coordinates) {
                let mut all = given.clone();
                for (other, beside) in statements.iter().filter(|(other, _)| together.contains(other)) {
                    all.extend(said(*other, beside)?);
                }
                let context = Context {
                    model: self.model,
                    options: self.options,
                    hypotheses: &all,
                    on_shell: Some(true),
                    topic: &topic,
                    span: statement.span.shifted(offset),
                    spread: Spread::Declared,
                    local: &[],
                };
                together.sort_unstable();
                let known = judged.iter().find(|(known, _)| *known == together).map(|(_, finding)| finding.clone());
                let is_nowhere = coordinates(statement).is_empty() && claim.at.is_empty();
                let refused = if self.has_motion(statement, claimed) {
                    Some(
                        "\"equilibrium\" needs a display without time derivatives; remove it, or claim it for a \
                         display that gives each coordinate a value",
                    )
                } else {
                    is_nowhere.then_some(
                        "this display gives no coordinate a value; say under \"at\" where each coordinate is",
                    )
                };
                let finding = match (refused, known) {
                    (Some(message), _) => context.finding(Code::ClaimDoesNotFit, Verdict::Undecided, message),
                    (None, Some(finding)) => Finding { span: context.span, ..finding },
                    (None, None) => equilibrium::check(claimed, &context)?,
                };
                judged.push((together, finding.clone()));
                let is_worse = |known: &Finding| known.verdict.severity() < finding.verdict.severity();
                if worst.as_ref().is_none_or(is_worse) {
                    worst = Some(finding);
                }
            }
            parts.extend(worst.map(|finding| self.part(finding, text::statement(statement, &self.model.symbols))));
        }
        Ok(parts)
    }

    /// The finding on a link to which terms were added that are said to be dropped: that they are not, where the link holds as it is
    /// printed.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    pub(crate) fn with_needless_terms(
        &self,
        printed: &Link,
        finding: Finding,
        context: &Context<'_>,
    ) -> Result<Finding> {
        if finding.verdict != Verdict::Refuted || !identity::check(printed, &context.quick())?.verdict.holds() {
            return Ok(finding);
        }
        let message = "the two printed sides are equal without the terms of \"dropping\"; remove \"dropping\"";
        Ok(context.finding(Code::ClaimDoesNotFit, Verdict::Undecided, message))
    }

    /// Whether a statement contains derivatives of coordinates that a position of rest has not: an equation of motion is true along
    /// every motion, and says of no place that the system stays there. In a steady motion cyclic coordinates may have a velocity.
    fn has_motion(&self, statement: &Statement, claimed: Equilibrium) -> bool {
        let least = if claimed == Equilibrium::Steady { 2 } else { 1 };
        let is_moving = |id: SymbolId, dots: u8| {
            dots >= least && self.model.coordinates.iter().any(|coordinate| coordinate.symbol == id)
        };
        statement.members.iter().any(|member| member.symbols().into_iter().any(|(id, dots)| is_moving(id, dots)))
    }

    /// Whether a member is the unknown that a claim solves for; the member beside it is then the solution.
    pub(crate) fn is_unknown_of(&self, member: &Expr, claim: &Claim) -> Result<bool> {
        let Some(solves) = &claim.solves else { return Ok(false) };
        let unknowns: Result<Vec<SymbolId>> = solves.unknowns.iter().map(|unknown| self.symbol(unknown)).collect();
        let name = |id: SymbolId| &self.model.symbols.entry(id).name;
        // Where nobody declares the names, s_1 and s_± are values of s.
        let is_value = |id: SymbolId, other: SymbolId| {
            let (value, unknown) = (name(id), name(other));
            id == other
                || self.model.symbols.guessed
                    && value.base == unknown.base
                    && value.primes == unknown.primes
                    && value.subscript.starts_with(&unknown.subscript)
        };
        let is_one =
            |id: SymbolId| unknowns.is_ok_and(|unknowns| unknowns.iter().any(|unknown| is_value(id, *unknown)));
        Ok(member.as_plain_symbol().is_some_and(is_one))
    }
}

/// The most equilibria of which one statement is a part.
const MOST_PLACES: usize = 16;

/// The sets of statements that give one place together with the `at`-th: those about other coordinates, and of ± one sign. So y = b is
/// a part of two places beside x = ±a.
fn places_with(
    statements: &[(usize, &Statement)],
    at: usize,
    coordinates: &impl Fn(&Statement) -> Vec<SymbolId>,
) -> Vec<Vec<usize>> {
    let is_of_one_sign = |a: &Statement, b: &Statement| a.branch.zip(b.branch).is_none_or(|(a, b)| a == b);
    let is_beside = |a: &Statement, b: &Statement| {
        let own = coordinates(a);
        is_of_one_sign(a, b) && !coordinates(b).iter().any(|q| own.contains(q))
    };
    let of = |place: usize| statements.iter().find(|(known, _)| *known == place).map(|(_, statement)| *statement);
    let mut places = vec![vec![at]];
    for (other, beside) in statements.iter().filter(|(other, _)| *other != at) {
        if of(at).is_none_or(|own| !is_beside(own, beside)) {
            continue;
        }
        for k in 0..places.len() {
            let stands = |known: &&usize| of(**known).is_some_and(|known| is_of_one_sign(known, beside));
            let mut kept: Vec<usize> = places[k].iter().filter(stands).copied().collect();
            kept.push(*other);
            if kept.len() > places[k].len() {
                places[k] = kept;
            } else if places.len() < MOST_PLACES && !places.contains(&kept) {
                places.push(kept);
            }
        }
    }
    places
}

/// The sum `expr + dropped`: a side of a claim with the terms that its author dropped.
pub fn with_dropped(expr: &Expr, dropped: &Expr) -> Expr {
    let plus = |expr: &Expr| crate::formula::Term { sign: Sign::Plus, sign_span: None, expr: expr.clone() };
    Expr::new(Node::Sum(vec![plus(expr), plus(dropped)]), expr.span)
}

/// Whether a relation restricts states to a range instead of fixing a value.
pub(crate) fn is_inequality(relation: Relation) -> bool {
    use Relation::{Greater, GreaterEqual, Less, LessEqual, NotEqual};
    matches!(relation, Less | Greater | LessEqual | GreaterEqual | NotEqual)
}

/// Whether a formula contains another.
pub(crate) fn contains(whole: &Expr, part: &Expr) -> bool {
    let mut found = false;
    whole.walk(&mut |inner| found |= inner == part);
    found
}
