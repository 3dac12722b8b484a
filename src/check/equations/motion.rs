//! The finding on displays that print a motion: solutions, their rates, orbits, and equations that hold along them.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation, Sign, SymbolId, text};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::judge::identity;
use crate::check::kinds::initial_values;
use crate::check::kinds::mechanics::same_motion;
use crate::check::kinds::printed_solution::Solution;
use crate::check::kinds::series;
use crate::check::kinds::solution;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::sample::context::{Context, Options};
use crate::check::sample::outcome::run;
use crate::check::sample::setting::FEWEST;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Part;
use crate::phrases::listed;

impl Checker<'_> {
    /// The solution that the first link of a statement prints, if nothing else is claimed of it.
    pub(crate) fn solution(&self, link: &Link, at: usize, claim: &Claim) -> Option<Solution> {
        let is_claimed = claim.solves.is_some() || claim.dropping.is_some() || claim.continuum_limit_of.is_some();
        if at > 0 || is_claimed || claim.holds.is_some() {
            return None;
        }
        let found = Solution::of_link(link, self.model).or_else(|| self.constant_solution(link))?;
        let is_printed = || self.solutions().iter().any(|(_, known)| known.coordinate == found.coordinate);
        (found.dots < found.order || is_printed()).then_some(found)
    }

    /// The solution that a link with ≈ prints to some order in a small parameter.
    pub(crate) fn solution_near(&self, link: &Link, at: usize, claim: &Claim) -> Option<Solution> {
        let exact = Link { relation: Relation::Equal, ..link.clone() };
        self.solution(&exact, at, claim).filter(|found| !claim.small.is_empty() && found.dots == 0)
    }

    /// The finding on a solution to some order in a small parameter: where position and velocity are those of the solution, the acceleration
    /// on shell is its second derivative to this order.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    pub(crate) fn solution_to_an_order(
        &self,
        found: &Solution,
        claim: &Claim,
        context: &Context<'_>,
    ) -> Result<Finding> {
        let name = text::plain(&self.model.name(found.coordinate));
        if self.starts(claim) && !initial_values::holds_at_start(found, context)? {
            let message =
                format!("at the start, the formula for {name} does not give the stated position and velocity");
            return Ok(context.finding(Code::SidesDiffer, Verdict::Refuted, message));
        }
        let rest = claim.assume.iter().filter(|latex| !self.is_start(latex)).cloned().collect();
        let of_claim = self.hypotheses(&Claim { assume: rest, ..claim.clone() })?;
        let beside = self.solutions_beside(Some(found.coordinate), context);
        let others = beside.iter().flat_map(|(_, solution)| solution.hypotheses());
        let hypotheses: Vec<Hypothesis> = of_claim.into_iter().chain(found.hypotheses()).chain(others).collect();
        let claimed = found.claim();
        // A constant in the formula is no term of its derivative.
        let rhs = found.highest_rate(self.model).unwrap_or(claimed.rhs);
        let link = Link { relation: Relation::Approximately, rhs, lhs: claimed.lhs, free: claimed.free };
        let finding =
            self.small(&link, claim, &Context { hypotheses: &hypotheses, on_shell: Some(true), ..*context })?;
        let message = match finding.verdict {
            verdict if verdict.holds() => format!("solves the equations of motion for {name}: {}", finding.message),
            Verdict::Refuted => {
                format!("this does not satisfy the equations of motion for {name} to this order: {}", finding.message)
            }
            _ => return Ok(finding),
        };
        Ok(Finding { message, ..finding })
    }

    /// A link in which a coordinate is an expansion, with the formula of its printed solution in place of the coordinate:
    /// `x(t) = a - \\frac12 gt^2 + O(t^4)` after `x(t) = …`. `None` where no solution is printed that passes.
    pub(crate) fn expanded_solution(&self, link: &Link, context: &Context<'_>) -> Result<Option<Link>> {
        let coordinate = link.lhs.as_plain_symbol().filter(|id| self.model.is_coordinate(*id));
        let Some(coordinate) = coordinate.filter(|_| series::has_rest(&link.rhs)) else { return Ok(None) };
        let beside = self.solutions_beside(None, context);
        let Some((_, known)) = beside.into_iter().find(|(_, known)| known.coordinate == coordinate) else {
            return Ok(None);
        };
        let is_one = !series::has_rest(&known.formula) && self.is_solved_by(&known, context)?;
        Ok(is_one.then(|| Link { lhs: known.formula, ..link.clone() }))
    }

    /// The solution of a link by which a coordinate is constant, beside a solution for another one.
    fn constant_solution(&self, link: &Link) -> Option<Solution> {
        let found = Solution::of_link_or_constant(link, self.model).filter(|found| found.dots == 0)?;
        let is_it = |(_, known): &(usize, Solution)| {
            known.coordinate == found.coordinate
                && known.formula.span == found.formula.span
                && known.formula == found.formula
        };
        self.solutions().iter().any(is_it).then_some(found)
    }

    /// The solutions for coordinates that the notes print, each with its display.
    fn solutions(&self) -> Vec<(usize, Solution)> {
        let all =
            self.readings.iter().enumerate().filter(|(at, _)| self.assigned[*at].is_none_or(|c| c.expect.is_none()));
        let printed = |reading: &Reading| -> Vec<Solution> {
            let statements = reading.statements.iter().flatten().filter(|statement| !statement.relations.is_empty());
            // `x_1 = x_3 = f(t)` is a solution for each.
            let first = statements.flat_map(|statement| {
                let mut names = self.leading_coordinates(statement);
                if names.len() < 2 {
                    names = statement.members.first().map(|first| (first.clone(), Sign::Plus)).into_iter().collect();
                }
                let value = statement.members.get(names.len());
                names.into_iter().filter_map(move |(name, sign)| {
                    let value = match sign {
                        Sign::Plus => value?.clone(),
                        Sign::Minus => value?.clone().negated(),
                    };
                    let link = self.link(&name, statement.relations[0].0, &value).ok()?;
                    Solution::of_link_or_constant(&link, self.model).filter(|found| found.dots == 0)
                })
            });
            let found: Vec<Solution> = first.collect();
            match found.iter().any(|solution| self.model.contains_time(&solution.formula)) {
                true => found,
                false => Vec::new(),
            }
        };
        all.flat_map(|(at, reading)| printed(reading).into_iter().map(move |found| (at, found))).collect()
    }

    /// The solution for each coordinate but one, printed nearest to a place: in its display, else before it, else after it.
    fn solutions_beside(&self, but: Option<SymbolId>, context: &Context<'_>) -> Vec<(usize, Solution)> {
        let here = self.notes.equations.iter().position(|display| display.body.contains(context.span)).unwrap_or(0);
        let mut all = self.solutions();
        all.sort_by_key(|(at, _)| if *at <= here { here - at } else { self.readings.len() + at });
        let mut found: Vec<(usize, Solution)> = Vec::new();
        for (at, solution) in all.into_iter().filter(|(_, solution)| Some(solution.coordinate) != but) {
            if found.iter().all(|(_, known)| known.coordinate != solution.coordinate) {
                found.push((at, solution));
            }
        }
        found
    }

    /// The finding on a coordinate that is given by the time and by a name which moves by its formula: x(t) with the energy E
    /// in it. The author means a constant of integration, which the formula is not, so this is not called wrong.
    pub(crate) fn with_moving_constant(&self, link: &Link, finding: Finding, context: &Context<'_>) -> Finding {
        let Some(coordinate) = link.lhs.as_plain_symbol().filter(|_| self.model.has_motion()) else { return finding };
        let moves = |id: SymbolId| self.model.symbol_depends_on(id, &[coordinate]);
        let mut names = link.rhs.symbols().into_iter().map(|(id, _)| id).filter(|id| *id != coordinate && moves(*id));
        let is_meant = finding.verdict == Verdict::Refuted && self.model.contains_time(&link.rhs);
        match names.next() {
            Some(name) if is_meant && !link.rhs.symbols().iter().any(|(id, _)| *id == coordinate) => {
                let name = text::plain(&self.model.name(name));
                let message = format!(
                    "the formula of {name} varies with time, so it cannot be a constant of integration, and this was not \
                     decided; write the constant as another letter"
                );
                context.finding(Code::NotDecided, Verdict::Undecided, message)
            }
            _ => finding,
        }
    }

    /// The finding on a printed solution, or on a rate of one.
    pub(crate) fn of_the_motion(&self, found: &Solution, context: &Context<'_>) -> Result<Finding> {
        let of_itself = |(_, known): &(usize, Solution)| known.coordinate == found.coordinate;
        if let Some((at, printed)) = self.solutions_beside(None, context).into_iter().find(of_itself)
            && found.dots > 0
            && self.is_solved_by(&printed, context)?
        {
            let span = found.formula.span;
            let rate = Expr::new(Node::TimeDerivative(found.dots, Box::new(printed.formula.clone())), span);
            let link = Link { lhs: rate, relation: Relation::Equal, rhs: found.formula.clone(), free: Vec::new() };
            let number = shown(&self.notes.equations[at]);
            let refuted = format!("this is not the derivative of the solution in ({number})");
            // Most texts that are tried in the place of a rate fail at the first state.
            if !context.options.explain {
                let ensemble = context.ensemble(context.mode(false, &[&link.lhs, &link.rhs]), false, FEWEST)?;
                if run(&link, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_some()) {
                    return Ok(context.finding(Code::SidesDiffer, Verdict::Refuted, refuted));
                }
            }
            let finding = identity::check(&link, context)?;
            let message = match finding.verdict {
                verdict if verdict.holds() => format!("follows from the solution in ({number})"),
                Verdict::Refuted => refuted,
                _ => return Ok(finding),
            };
            return Ok(Finding { message, ..finding });
        }
        let beside = self.solutions_beside(Some(found.coordinate), context);
        let others: Vec<Solution> = beside.iter().map(|(_, solution)| solution.clone()).collect();
        let finding = solution::check(found, &others, context)?;
        // Without a claims file a false solution is found by itself, and with Lagrangians all coordinates move together.
        if !finding.verdict.holds() || context.options.deduction || self.model.system.is_some() {
            return Ok(finding);
        }
        // What solves the laws with a false solution for another coordinate may be false.
        let mut sound = Vec::new();
        let mut unsound = None;
        for (at, solution) in beside {
            match self.is_solved_by(&solution, context)? {
                true => sound.push(solution),
                false => unsound = unsound.or(Some(at)),
            }
        }
        let Some(at) = unsound else { return Ok(finding) };
        let alone = solution::check(found, &sound, context)?;
        Ok(if alone.verdict.holds() { alone } else { self.depends_on_refuted(at, context) })
    }

    /// Whether a display gives something the value 0 directly after solutions for all coordinates, on the motion that these print: "and then
    /// `S = 0`".
    fn is_of_the_last_solution(&self, link: &Link, beside: &[(usize, Solution)], context: &Context<'_>) -> bool {
        let here = self.notes.equations.iter().position(|display| display.body.contains(context.span));
        let Some(last) = here.and_then(|here| here.checked_sub(1)) else { return false };
        let printed: Vec<&Solution> = beside.iter().filter(|(at, _)| *at == last).map(|(_, known)| known).collect();
        self.is_zero_on(link, &printed)
    }

    /// Whether a link gives a name the value 0, beside solutions for all coordinates.
    fn is_zero_on(&self, link: &Link, printed: &[&Solution]) -> bool {
        let is_given = |q: &Variable| printed.iter().any(|known| known.coordinate == q.symbol);
        !printed.is_empty()
            && link.rhs.is_zero()
            && link.lhs.as_plain_symbol().is_some_and(|id| !self.model.is_coordinate(id))
            && self.model.coordinates.iter().all(is_given)
    }

    /// The finding on what rests on the solution of a display, which is refuted.
    fn depends_on_refuted(&self, at: usize, context: &Context<'_>) -> Finding {
        let number = shown(&self.notes.equations[at]);
        let message = format!("depends on the solution in ({number}), which is refuted; correct ({number}) first");
        context.finding(Code::NotDecided, Verdict::Undecided, message)
    }

    /// Whether a link may be an orbit, or may hold along a printed solution.
    pub(crate) fn is_along_the_motion(&self, link: &Link) -> bool {
        let printed = self.solutions();
        let shares = |(_, known): &(usize, Solution)| known.shares_a_constant_of_integration(link, self.model);
        solution::is_an_orbit(link, self.model)
            || solution::is_of_a_name(link, self.model)
            || printed.iter().any(shares)
            || self.is_zero_on(link, &printed.iter().map(|(_, known)| known).collect::<Vec<_>>())
    }

    /// Whether a printed solution passes.
    fn is_solved_by(&self, printed: &Solution, context: &Context<'_>) -> Result<bool> {
        let quick = Context { options: Options { explain: false, ..context.options }, ..*context };
        let others = self.solutions_beside(Some(printed.coordinate), context);
        let others: Vec<Solution> = others.into_iter().map(|(_, solution)| solution).collect();
        if solution::is_on_shell(printed, &others, context)? == Some(true) {
            return Ok(true);
        }
        Ok(solution::check(printed, &others, &quick)?.verdict.holds())
    }

    /// The verdict on a printed solution.
    fn verdict_on(&self, printed: &Solution, context: &Context<'_>) -> Result<Verdict> {
        let quick = Context { options: Options { explain: false, ..context.options }, ..*context };
        let others = self.solutions_beside(Some(printed.coordinate), context);
        let others: Vec<Solution> = others.into_iter().map(|(_, solution)| solution).collect();
        Ok(solution::check(printed, &others, &quick)?.verdict)
    }

    /// The finding that a formula printed for the Lagrangian gives the same motion as its definition, if it does.
    fn another_lagrangian(&self, link: &Link, context: &Context<'_>) -> Result<Option<Finding>> {
        let printed =
            self.model.printed_lagrangian.as_ref().and_then(|printed| self.model.symbols.find(&printed.lagrangian));
        let is_it = |side: &Expr| {
            side.as_plain_symbol().is_some() && side.as_plain_symbol() == printed.as_ref().map(|(id, _)| *id)
        };
        if !is_it(&link.lhs) || !context.hypotheses.is_empty() {
            return Ok(None);
        }
        let quick = Context { options: Options { explain: false, ..context.options }, ..*context };
        let found = same_motion::check(&link.rhs, &link.lhs, &quick)?;
        Ok(found.verdict.holds().then_some(found))
    }

    /// Whether a hypothesis, or a condition by its name, gives initial values, as x(0) = x_0 does.
    fn is_start(&self, latex: &Spanned<String>) -> bool {
        let named = self.claims.conditions.iter().find(|(name, _)| name.value == latex.value);
        let is_one = |latex: &Spanned<String>| self.without_start(&latex.value).is_some();
        named.map_or_else(|| is_one(latex), |(_, all)| all.iter().any(is_one))
    }

    /// The text of a hypothesis without the (0) after what moves and its rates, which is said of the time 0; `None`, if it has none.
    pub(crate) fn without_start(&self, latex: &str) -> Option<String> {
        let mut text = latex.to_owned();
        let moving = self.model.coordinates.iter().map(|q| q.symbol).chain(self.model.varying.iter().map(|q| q.symbol));
        for name in moving.map(|id| self.model.name(id)) {
            for applied in [format!("{name}(0)"), format!("{{{name}}}(0)")] {
                while let Some(at) = text.find(&applied) {
                    let before = text[..at].chars().next_back();
                    let is_part = before.is_some_and(|c| c == '_' || c.is_alphanumeric() && !name.starts_with('\\'));
                    if is_part && !text[..at].ends_with("\\dot") {
                        return None;
                    }
                    let end = at + applied.len();
                    text.replace_range(end - "(0)".len()..end, "");
                }
            }
        }
        (text != latex).then_some(text)
    }

    /// Whether a claim is about a motion that starts with given values.
    pub(crate) fn starts(&self, claim: &Claim) -> bool {
        claim.assume.iter().any(|latex| self.is_start(latex))
    }

    /// The finding on an equation of a motion that starts as the claim says: a solution must also solve the equations of motion.
    pub(crate) fn along_its_start(
        &self,
        link: &Link,
        solution: Option<&Solution>,
        claim: &Claim,
        context: &Context<'_>,
    ) -> Result<Finding> {
        let found = initial_values::check(link, context)?;
        let Some(solution) = solution.filter(|_| found.verdict.holds()) else { return Ok(found) };
        let rest = claim.assume.iter().filter(|latex| !self.is_start(latex)).cloned().collect();
        let hypotheses = self.hypotheses(&Claim { assume: rest, ..claim.clone() })?;
        let solves = self.of_the_motion(solution, &Context { hypotheses: &hypotheses, ..*context })?;
        // What is no solution of the only equation of motion agrees with one in the first powers of the time only.
        let is_only_one = self.model.system.is_some() && self.model.coordinates.len() == 1;
        if is_only_one && solution.dots == 0 && solves.verdict == Verdict::Refuted {
            return Ok(solves);
        }
        // Some formulas are solutions for these initial values only.
        Ok(match solves.verdict.holds() {
            true => Finding { message: format!("{}, and starts as it should", solves.message), ..solves },
            false => found,
        })
    }

    /// The same claim with the hypotheses at all times that put a coordinate in a place, θ = θ_0, and those beside them; `None`
    /// if there are none. A hypothesis is about one instant; a place or a cone on which the motion stays is often meant.
    ///
    /// # Errors
    /// For a hypothesis that cannot be read.
    pub(crate) fn lasting(&self, claim: &Claim) -> Result<Option<Claim>> {
        if self.options.deduction || claim.assume.is_empty() || !self.model.has_motion() {
            return Ok(None);
        }
        let is_coordinate = |side: &Expr| side.as_plain_symbol().is_some_and(|id| self.model.is_coordinate(id));
        let is_constant = |side: &Expr| {
            let is_one = |(id, _): &(SymbolId, u8)| matches!(self.model.meaning(*id), Some(Meaning::Constant(_)));
            side.symbols().iter().all(is_one)
        };
        let is_place = |hypothesis: &Hypothesis| {
            let (a, b) = (&hypothesis.lhs, &hypothesis.rhs);
            hypothesis.relation == Relation::Equal
                && (is_coordinate(a) && is_constant(b) || is_coordinate(b) && is_constant(a))
        };
        let of_all = self.hypotheses(&Claim::default())?.len();
        let (mut lasting, mut passing, mut has_letter) = (claim.throughout.clone(), Vec::new(), false);
        for latex in &claim.assume {
            if self.is_start(latex) {
                passing.push(latex.clone());
                continue;
            }
            let alone = Claim { assume: vec![latex.clone()], ..Claim::default() };
            let hypotheses = self.hypotheses(&alone)?;
            let places: Vec<&Hypothesis> = hypotheses.iter().skip(of_all).filter(|known| is_place(known)).collect();
            has_letter |= places.iter().any(|known| known.lhs.symbols().len() + known.rhs.symbols().len() > 1);
            match places.is_empty() {
                false => lasting.push(latex.clone()),
                true => passing.push(latex.clone()),
            }
        }
        // "At the lowest point, θ = 0" is an instant; a place with a letter of its own is one that was chosen so that the motion stays there.
        let is_changed = lasting.len() > claim.throughout.len() && has_letter;
        Ok(is_changed.then(|| Claim { assume: passing, throughout: lasting, ..claim.clone() }))
    }

    /// The parts of a display, of which those that fail at the instant of the hypotheses are replaced where they hold if a
    /// coordinate keeps the value that a hypothesis gives it.
    ///
    /// # Errors
    /// As for a check of the display.
    pub(crate) fn if_it_lasts(
        &self,
        mut parts: Vec<Part>,
        claim: &Claim,
        judge: impl FnOnce(&Claim) -> Result<Vec<Part>>,
    ) -> Result<Vec<Part>> {
        let fails = |part: &Part| part.finding.verdict == Verdict::Refuted;
        if claim.expect.is_some() || !parts.iter().any(fails) {
            return Ok(parts);
        }
        let Some(lasting) = self.lasting(claim)? else { return Ok(parts) };
        let lasts = |part: Part| {
            let message = format!(
                "{}; this holds only while the coordinate stays where the hypothesis puts it",
                part.finding.message
            );
            Part { finding: Finding { message, ..part.finding }, ..part }
        };
        let found = judge(&lasting)?;
        // A chain has a part for each mistake.
        if found.len() != parts.len() {
            let holds = found.iter().all(|part| part.finding.verdict.passes());
            return Ok(if holds { found.into_iter().map(lasts).collect() } else { parts });
        }
        for (part, other) in parts.iter_mut().zip(found) {
            if fails(part) && other.finding.verdict.holds() {
                *part = lasts(other);
            }
        }
        Ok(parts)
    }

    /// What a link is that was refuted: an orbit of the motion, or an equation that holds along a printed solution; else the same
    /// finding.
    pub(crate) fn along_the_motion(&self, link: &Link, found: Finding, context: &Context<'_>) -> Result<Finding> {
        if found.verdict != Verdict::Refuted {
            return Ok(found);
        }
        if let Some(same) = self.another_lagrangian(link, context)? {
            return Ok(same);
        }
        if let Some(orbit) = solution::orbit(link, context)? {
            return Ok(orbit);
        }
        if let Some(implicit) = solution::implicit(link, context)? {
            return Ok(implicit);
        }
        if let Some(named) = solution::by_name(link, context)? {
            return Ok(named);
        }
        let mut beside = self.solutions_beside(None, context);
        if self.model.system.is_none() {
            // Laws move each coordinate on its own, unless they contain several.
            let concerns = |known: &Solution| {
                self.model.depends_on(&link.lhs, &[known.coordinate])
                    || self.model.depends_on(&link.rhs, &[known.coordinate])
                    || known.shares_a_constant_of_integration(link, self.model)
            };
            beside.retain(|(_, known)| concerns(known));
        }
        let shares = |(_, solution): &(usize, Solution)| solution.shares_a_constant_of_integration(link, self.model);
        if !beside.iter().any(shares) && !self.is_of_the_last_solution(link, &beside, context) {
            return Ok(found);
        }
        // Only what solves the equations of motion can be a hypothesis.
        let all: Vec<Solution> = beside.iter().map(|(_, solution)| solution.clone()).collect();
        for (at, solution) in &beside {
            let others: Vec<Solution> =
                all.iter().filter(|other| other.coordinate != solution.coordinate).cloned().collect();
            let solves = match self.model.system {
                Some(_) => solution::is_on_shell(solution, &others, context)?,
                // What is not decided is not refuted.
                None => match self.verdict_on(solution, context)? {
                    verdict if verdict.holds() => Some(true),
                    Verdict::Refuted => Some(false),
                    _ => None,
                },
            };
            match solves {
                Some(true) => {}
                // Without a claims file the solution may be a trial that this equation completes.
                Some(false) if context.options.deduction => return Ok(found),
                // What holds along the right solution need not hold along a wrong one.
                Some(false) if solution::in_first_order(solution, &others, context)?.is_none() => {
                    return Ok(self.depends_on_refuted(*at, context));
                }
                _ => return Ok(found),
            }
        }
        let hypotheses: Vec<Hypothesis> =
            context.hypotheses.iter().cloned().chain(all.iter().flat_map(Solution::hypotheses)).collect();
        let on_it = Context { hypotheses: &hypotheses, on_shell: Some(true), ..*context };
        let few = Options { points: FEWEST, explain: false, ..context.options };
        if !context.options.explain && !identity::check(link, &Context { options: few, ..on_it })?.verdict.holds() {
            return Ok(found);
        }
        let along = identity::check(link, &on_it)?;
        beside.sort_by_key(|(at, _)| *at);
        beside.dedup_by_key(|(at, _)| *at);
        let number = |(at, _): &(usize, Solution)| format!("({})", shown(&self.notes.equations[*at]));
        let of = format!("the solution in {}", listed(&beside.iter().map(number).collect::<Vec<_>>(), "and"));
        match along.verdict {
            verdict if verdict.holds() => Ok(Finding { message: format!("holds along {of}"), ..along }),
            Verdict::Refuted => {
                Ok(Finding { message: format!("the two sides differ along {of}"), code: Code::SidesDiffer, ..along })
            }
            _ => Ok(found),
        }
    }
}
