//! The uses of a defined name: equations and sentences that contain it, and equations that hold by a law that contains it.

use crate::code::Code;
use crate::formula::symbols::Name;
use crate::formula::{Expr, Kind, Node, Relation, Statement, SymbolId, text};
use crate::latex::DefinedSymbol;
use crate::notes::claims::Claim;
use crate::source::Span;
use crate::{Error, Result};

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::printed_lagrangian;
use crate::check::equations::approximations::ApproximateUses;
use crate::check::equations::definition_tests::Use;
use crate::check::kinds::definitions;
use crate::check::kinds::definitions::{Approximations, User};
use crate::check::kinds::identified;
use crate::check::kinds::mechanics::{modes, steady};
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::vacuity::restatement;
use crate::check::vacuity::restatement::Restated;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

impl Use {
    /// This use as a test of the definition, in a context.
    fn by<'a>(&'a self, context: &Context<'a>) -> User<'a> {
        let Use { id, link, hypotheses, local, .. } = self;
        let context = Context { hypotheses, local, topic: id, on_shell: None, ..*context };
        User { id: id.clone(), link: link.clone(), context }
    }
}

impl Checker<'_> {
    /// The finding on a statement that introduces a symbol.
    pub(crate) fn definition(&self, introduced: &DefinedSymbol, context: &Context<'_>) -> Result<Finding> {
        let symbol = introduced.symbol;
        if printed_lagrangian::is_part(self.model, symbol) {
            return Ok(self.part_of_the_lagrangian(symbol, context));
        }
        if let Some(finding) = self.mode(introduced.symbol, &introduced.formula, context)? {
            return Ok(finding);
        }
        if let Some(finding) = self.declared_frequency(introduced.symbol, &introduced.formula, context)? {
            return Ok(finding);
        }
        let (uses, restated) = self.uses(introduced)?;
        let approximations = ApproximateUses::of(self, symbol)?;
        let linear = ApproximateUses::linear(self, symbol)?;
        let whole = self.whole_displays(introduced)?.without(&restated);
        let is_only_restated = approximations.is_empty() && linear.is_empty() && whole.is_empty();
        if uses.is_empty() && !restated.is_empty() && is_only_restated {
            let name = text::plain(&self.model.name(symbol));
            let mut by = restated.clone();
            by.dedup();
            let repeat = if by.len() == 1 { "only repeats" } else { "only repeat" };
            let message = format!(
                "defines {name}, but {} {repeat} the definition, so it was not tested; use {name} in an equation that can fail",
                by.join(", ")
            );
            return Ok(context.finding(Code::DefinitionNotTested, Verdict::Undecided, message).defining(&name));
        }
        let by_law = self.uses_by_law(introduced)?;
        let mut users: Vec<User<'_>> = uses.iter().map(|used| used.by(context)).collect();
        let by_law: Vec<User<'_>> = by_law.iter().map(|used| used.by(context)).collect();
        let mut test = |others: &[&dyn Approximations]| {
            definitions::check(symbol, &introduced.formula, (&mut users, &by_law, others), context)
        };
        let found = test(&[&approximations, &whole])?;
        if found.verdict != Verdict::Undecided {
            return Ok(found);
        }
        match self.inferred_frequency(introduced, context)? {
            Some(frequency) => Ok(frequency),
            None if linear.is_empty() => Ok(found),
            None => test(&[&approximations, &whole, &linear]),
        }
    }

    /// The finding on a name that the claims file says is the frequency of small oscillations about a place.
    pub(crate) fn declared_frequency(
        &self,
        symbol: SymbolId,
        formula: &Expr,
        context: &Context<'_>,
    ) -> Result<Option<Finding>> {
        let name = &self.model.symbols.entry(symbol).name;
        let Some(frequency) = self.model.frequencies.iter().find(|frequency| frequency.name == *name) else {
            return Ok(None);
        };
        let place = match &frequency.about {
            Some(about) => self.hypotheses(&Claim { throughout: vec![about.clone()], ..Claim::default() })?,
            None => Vec::new(),
        };
        let square = self.squared(symbol, formula);
        let square = if frequency.is_period { of_period(square) } else { square };
        let what = if frequency.is_period { "period" } else { "frequency" };
        let found = steady::check(&square, what, &place, context)?;
        Ok(Some(found.unwrap_or_else(|why| {
            let message = format!("the {what} of small oscillations was not derived, because {why}");
            context.finding(Code::NotSupported, Verdict::Undecided, message)
        })))
    }

    /// Whether a link says what the frequency of small oscillations about a place is.
    pub(crate) fn is_frequency(&self, link: &Link) -> bool {
        let name = link.lhs.as_plain_symbol().map(|id| &self.model.symbols.entry(id).name);
        name.is_some_and(|name| self.model.frequencies.iter().any(|frequency| frequency.name == *name))
    }

    /// The finding on a name that nothing else tests and that is the frequency of small oscillations, or their period, where the
    /// hypotheses put the coordinates, or where they are 0; `None` if it is neither.
    fn inferred_frequency(&self, introduced: &DefinedSymbol, context: &Context<'_>) -> Result<Option<Finding>> {
        let model = self.model;
        // A name that moves may have this value in the place, as an energy that is 0 there.
        let moving: Vec<SymbolId> = model.coordinates.iter().chain(&model.varying).map(|known| known.symbol).collect();
        let is_fixed = !model.depends_on(&introduced.formula, &moving) && !model.contains_time(&introduced.formula);
        if !is_fixed || self.options.deduction || model.symbols.entry(introduced.symbol).kind != Kind::Scalar {
            return Ok(None);
        }
        let about = |known: &&Hypothesis| {
            let symbols = known.lhs.symbols().into_iter().chain(known.rhs.symbols());
            symbols.into_iter().any(|(id, _)| model.is_coordinate(id))
        };
        let place: Vec<Hypothesis> = context.hypotheses.iter().filter(about).cloned().collect();
        let square = self.squared(introduced.symbol, &introduced.formula);
        let of_period = of_period(square.clone());
        for (square, what) in [(square, "frequency"), (of_period, "period")] {
            // What cannot be drawn here is none of these.
            let Ok(found) = steady::check(&square, what, &place, &context.quick()) else { continue };
            let mut found = found.ok();
            if found.is_none() && place.is_empty() {
                found = modes::check(&square, &[], &context.quick()).ok();
            }
            if let Some(found) = found.filter(|found| found.verdict.holds()) {
                let name = text::plain(&model.name(introduced.symbol));
                let message = format!("{name} is the {what} of small oscillations that follows from the Lagrangian");
                return Ok(Some(Finding { message, ..found }));
            }
        }
        Ok(None)
    }

    /// The square of a name with this formula.
    fn squared(&self, symbol: SymbolId, formula: &Expr) -> Expr {
        match self.model.symbols.entry(symbol).squared {
            true => formula.clone(),
            false => {
                let two = Expr::integer(2, formula.span);
                Expr::new(Node::Power(Box::new(formula.clone()), Box::new(two)), formula.span)
            }
        }
    }

    /// The finding on a name that the claims file says is one of several normal frequencies.
    pub(crate) fn mode(&self, symbol: SymbolId, formula: &Expr, context: &Context<'_>) -> Result<Option<Finding>> {
        let named = |name: &Name| self.model.symbols.find(name).map(|(id, _)| id);
        let Some(place) = self.model.modes.iter().position(|name| named(name) == Some(symbol)) else {
            return Ok(None);
        };
        // So is a frequency that is given by another one: ω_1 = ω_2 says no more than that they are the same.
        let has = |other: &Name| named(other).is_some_and(|id| id != symbol && formula.symbols().contains(&(id, 0)));
        let modes = self.model.modes.iter().enumerate();
        let others = modes.filter(|(at, other)| *at < place || has(other)).map(|(_, other)| other);
        let before = others.filter_map(|name| {
            let id = named(name)?;
            match self.model.meaning(id) {
                Some(Meaning::Defined(formula)) => Some((text::plain(&name.to_string()), self.squared(id, formula))),
                _ => None,
            }
        });
        let own = self.squared(symbol, formula);
        modes::check(&own, &before.collect::<Vec<_>>(), context).map(Some)
    }

    /// The finding on a definition from which the motion follows, since the Lagrangian is made of it.
    fn part_of_the_lagrangian(&self, symbol: SymbolId, context: &Context<'_>) -> Finding {
        let (name, model) = (text::plain(&self.model.name(symbol)), self.model);
        let lagrangian = model.printed_lagrangian.as_ref().map(|printed| text::plain(&printed.lagrangian.to_string()));
        let hamiltonian =
            model.printed_hamiltonian.as_ref().map(|printed| text::plain(&printed.hamiltonian.to_string()));
        let (kind, whole) = match (lagrangian, hamiltonian) {
            (Some(lagrangian), _) => ("Lagrangian", lagrangian),
            (None, hamiltonian) => ("Hamiltonian", hamiltonian.unwrap_or_default()),
        };
        let what = match name == whole {
            true => format!("the {kind}"),
            false if printed_lagrangian::is_force(model, symbol) => "which gives forces".to_owned(),
            false => format!("a part of the {kind} {whole}"),
        };
        let message =
            format!("defines {name}, {what}; it is not checked, because the equations of motion are derived from it");
        context.finding(Code::LagrangianDefined, Verdict::Definition, message)
    }

    /// Adds to the finding on "is constant" that a factor in a newly defined name is not tested, where nothing else uses it.
    pub(crate) fn only_constant(
        &self,
        introduced: &[&DefinedSymbol],
        statement: &Statement,
        found: &mut Finding,
    ) -> Result<()> {
        let [first] = introduced else { return Ok(()) };
        if !found.verdict.passes() || statement.relations.len() != 1 {
            return Ok(());
        }
        let is_own = |used: &Use| {
            let rate = |formula: &Expr| matches!(&formula.node, Node::TimeDerivative(1, inner) if statement.members.contains(inner));
            rate(&used.link.lhs)
        };
        if self.uses(first)?.0.iter().all(is_own) && self.uses_by_law(first)?.is_empty() {
            let name = text::plain(&self.model.name(first.symbol));
            found.message =
                format!("{}; no other equation tests {name}, so a wrong factor in it would pass", found.message);
        }
        Ok(())
    }

    /// The equations that may hold only by a law that contains a defined name, and so test its definition.
    fn uses_by_law(&self, introduced: &DefinedSymbol) -> Result<Vec<Use>> {
        let model = self.model;
        let depends = |expr: &Expr| model.depends_on(expr, &[introduced.symbol]);
        let is_of_it = |c: &Hypothesis| depends(&c.lhs) || depends(&c.rhs);
        let laws: Vec<_> = model.laws.iter().filter(|law| law.hypotheses.iter().any(is_of_it)).collect();
        let mut uses = Vec::new();
        if laws.is_empty() {
            return Ok(uses);
        }
        for (at, reading) in self.readings.iter().enumerate().filter(|(at, _)| !self.is_law(*at)) {
            let none = Claim::default();
            let claim = self.assigned[at].unwrap_or(&none);
            if !claim.is_plain() || claim.expect.is_some() || !claim.errata.is_empty() {
                continue;
            }
            for statement in reading.statements.iter().flatten().filter(|_| reading.introduced.is_empty()) {
                for (k, (relation, _)) in statement.relations.iter().enumerate().filter(|(_, r)| is_equality(r.0)) {
                    let link = self.link(&statement.members[k], *relation, &statement.members[k + 1])?;
                    let (hypotheses, local) = (self.hypotheses(claim)?, self.local(claim)?);
                    let id = format!("({})", shown(&self.notes.equations[at]));
                    uses.push(Use { id, link, hypotheses, local, is_plain: true, solution: None });
                }
            }
        }
        Ok(uses)
    }

    /// The equations and sentences that use a defined name, and the names of those that only repeat its definition and hold
    /// for any definition.
    pub(crate) fn uses(&self, introduced: &DefinedSymbol) -> Result<(Vec<Use>, Vec<String>)> {
        let symbol = introduced.symbol;
        let depends = |expr: &Expr| self.model.depends_on(expr, &[symbol]);
        let (mut uses, mut restated, mut constant) = (Vec::new(), Vec::new(), Vec::new());
        let mut add = |name: String, (statement, k): (&Statement, usize), claim: &Claim| {
            let relation = statement.relations[k].0;
            if !is_equality(relation) || !statement.members[k..k + 2].iter().any(depends) {
                return Ok(());
            }
            let (a, b) = (&statement.members[k], &statement.members[k + 1]);
            let mut link = self.link(a, relation, b)?;
            let says_it_again = |link: &Link| restatement::restates(link, symbol, &introduced.formula, self.model);
            let how = says_it_again(&link);
            let mut is_restated = how.is_some();
            if how == Some(Restated::Differentiated)
                && statement.relations.iter().all(|(relation, _)| is_equality(*relation))
            {
                // In a longer chain the name is also equal to the other members: Ė = … = 0 says Ė = 0.
                let member = if depends(a) { a } else { b };
                let others = (0..statement.members.len()).filter(|at| *at != k && *at != k + 1);
                for other in others.map(|at| &statement.members[at]).filter(|other| !depends(other)) {
                    let across = self.link(member, Relation::Equal, other)?;
                    if is_restated && says_it_again(&across).is_none() {
                        (link, is_restated) = (across, false);
                    }
                }
            }
            match is_restated {
                true => restated.push(name),
                false => {
                    let (hypotheses, local) = (self.hypotheses(claim)?, self.local(claim)?);
                    // No state shows that a solution fails, and what holds along one need not hold at each state.
                    let solution = self.solution(&link, k, claim);
                    let is_along = self.model.has_motion() && self.is_along_the_motion(&link);
                    let is_plain = claim.expect.is_none() && claim.is_plain() && !is_along;
                    uses.push(Use { id: name, link, hypotheses, local, is_plain, solution });
                }
            }
            Ok::<(), Error>(())
        };
        // A law is assumed, so it holds for any definition of the name.
        for (at, reading) in self.readings.iter().enumerate().filter(|(at, _)| !self.is_law(*at)) {
            let none = Claim::default();
            let claim = self.assigned[at].unwrap_or(&none);
            for (place, statement) in reading.statements.iter().enumerate() {
                let Ok(statement) = statement else { continue };
                for k in 0..statement.relations.len() {
                    let defines =
                        |i: &DefinedSymbol| i.statement == place && (i.member == k + 1 || k == 0 && i.member == 0);
                    if !reading.introduced.iter().any(defines) {
                        add(format!("({})", shown(&self.notes.equations[at])), (statement, k), claim)?;
                    }
                }
                let last = statement.members.last().filter(|member| statement.constant.is_some() && depends(member));
                if let Some(member) = last {
                    let rate = Expr::new(Node::TimeDerivative(1, Box::new(member.clone())), member.span);
                    let link = self.link(&rate, Relation::Equal, &Expr::integer(0, member.span))?;
                    let (hypotheses, local) = (self.hypotheses(claim)?, self.local(claim)?);
                    let id = format!("({})", shown(&self.notes.equations[at]));
                    constant.push(Use {
                        id,
                        link,
                        hypotheses,
                        local,
                        is_plain: claim.expect.is_none() && claim.is_plain(),
                        solution: None,
                    });
                }
            }
        }
        for sentence in self.claims.sentences.iter().filter(|sentence| sentence.claim.expect.is_none()) {
            for statement in self.claimed_by(sentence).iter().flatten() {
                for k in 0..statement.relations.len() {
                    let name = sentence.name.as_ref().map_or("a sentence", |name| name.value.as_str());
                    add(format!("“{name}”"), (statement, k), &sentence.claim)?;
                }
            }
        }
        uses.append(&mut constant);
        uses.append(&mut self.identities(symbol)?);
        Ok((uses, restated))
    }

    /// The defined names that contain a symbol and equal a quantity of the printed Lagrangian, such as its kinetic energy.
    fn identities(&self, symbol: SymbolId) -> Result<Vec<Use>> {
        let model = self.model;
        let hypotheses = self.hypotheses(&Claim::default())?;
        let mut found = Vec::new();
        let all = self.readings.iter().flat_map(|reading| &reading.introduced).map(|introduced| introduced.symbol);
        for name in all.filter(|name| model.symbol_depends_on(*name, &[symbol])) {
            if printed_lagrangian::is_part(model, name) || model.symbols.entry(name).kind != Kind::Scalar {
                continue;
            }
            let context = Context {
                model,
                options: self.options,
                hypotheses: &hypotheses,
                on_shell: None,
                topic: "a quantity of the Lagrangian",
                span: Span::default(),
                spread: Spread::Declared,
                local: &[],
            };
            if let Some((id, link)) = identified::of(name, &context)? {
                found.push(Use {
                    id,
                    link,
                    hypotheses: hypotheses.clone(),
                    local: Vec::new(),
                    is_plain: true,
                    solution: None,
                });
            }
        }
        Ok(found)
    }

    /// Whether a display is a law.
    pub(crate) fn is_law(&self, at: usize) -> bool {
        self.model.laws.iter().any(|law| law.printed.iter().any(|(display, _)| *display == at))
    }
}

/// The square of the frequency ω whose period T = 2π/ω has this square.
fn of_period(square: Expr) -> Expr {
    let node = |node: Node| Expr::new(node, Span::default());
    let number = |value: u32| Expr::integer(value, Span::default());
    let turn = node(Node::Product(vec![number(2), node(Node::Pi)]));
    let turn_squared = node(Node::Power(Box::new(turn), Box::new(number(2))));
    node(Node::Quotient(Box::new(turn_squared), Box::new(square)))
}
