//! The finding on one equation: its statements link by link, and what else is claimed of it.

use crate::code::Code;
use crate::formula::{Expr, Relation, Statement, SymbolId, text};
use crate::latex::{DefinedSymbol, Macros, Reading, read_display};
use crate::notes::Display;
use crate::notes::claims::{Claim, Holds};
use crate::source::{Fault, Span};
use crate::{Error, Result};

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::reading::{approximate, for_each};
use crate::check::equations::chain::JudgedLink;
use crate::check::equations::chain_certificates;
use crate::check::equations::merge::{expected, merged, worst};
use crate::check::equations::whole::{contains, is_inequality, with_dropped};
use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::judge::identity;
use crate::check::kinds::mechanics::modes;
use crate::check::kinds::{conserved, exactly_when};
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::vacuity::tautology;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::{Equation, Part};

impl Checker<'_> {
    /// The finding on an equation, with its parts.
    ///
    /// # Errors
    /// For a claim that does not fit the equation, at its place in the claims file.
    pub fn equation(&self, at: usize, claim: Option<&Claim>) -> Result<Equation> {
        let display = &self.notes.equations[at];
        let none = Claim::default();
        let claim = claim.unwrap_or(&none);
        let reading = &self.readings[at];
        let topic = shown(display);
        let as_printed;
        let printed = match claim.errata.is_empty() {
            true => reading,
            false => {
                as_printed = self.as_printed(&display.text, claim, &self.model.macros);
                &as_printed
            }
        };
        let place = (at, display.body.start);
        let mut parts = self.parts(place, printed, claim, &topic)?;
        let mut because = claim.expect.as_ref().map(|expect| expect.because.value.clone());
        let passes = |parts: &[Part]| parts.iter().all(|part| part.finding.verdict.passes());
        let mut as_expected = match &claim.expect {
            Some(expect) => {
                let verdict = expected(expect);
                let is_expected = |part: &Part| part.finding.verdict == verdict;
                parts.iter().any(is_expected)
                    && parts.iter().all(|part| is_expected(part) || part.finding.verdict.passes())
            }
            None => parts.iter().all(|part| part.ok),
        };
        if !claim.errata.is_empty() {
            let corrected = self.parts(place, reading, claim, &topic)?;
            let fails =
                |part: &Part| matches!(part.finding.verdict, Verdict::Refuted | Verdict::Domain | Verdict::Unreadable);
            let failed = parts.iter().any(fails);
            as_expected = failed && passes(&corrected);
            let edits: Vec<String> =
                claim.errata.iter().map(|e| format!("for “{}” read “{}”", e.printed.value, e.read.value)).collect();
            let verdict = match (failed, as_expected) {
                (true, true) => "the corrected equation passes".to_owned(),
                (true, false) => format!("the corrected equation does not pass: {}", worst(&corrected).message),
                (false, _) => "the printed equation is not wrong, so remove the erratum".to_owned(),
            };
            because = Some(format!("{}; {verdict}", edits.join(", ")));
        }
        if let Some(expect) = &claim.expect {
            // An equation with an expected verdict is as expected as a whole; its passing parts are as well.
            parts.iter_mut().for_each(|part| part.ok = part.ok || part.finding.verdict == expected(expect));
        }
        let errata = claim.errata.iter().map(|e| (e.printed.value.clone(), e.read.value.clone())).collect();
        let rests_on = self.rests_on(at, claim);
        Ok(Equation { errata, rests_on, ..self.assembled(display, reading, parts, as_expected, because) })
    }

    /// The equation of the report that the parts of a display make.
    pub(crate) fn assembled(
        &self,
        display: &Display,
        reading: &Reading,
        parts: Vec<Part>,
        ok: bool,
        because: Option<String>,
    ) -> Equation {
        let statements = reading.statements.iter().flatten();
        let readings: Vec<String> = statements.map(|s| text::statement(s, &self.model.symbols)).collect();
        Equation {
            id: shown(display),
            line: display.line,
            latex: self.source.slice(display.body).to_owned(),
            reading: readings.join("; "),
            finding: worst(&parts),
            ok,
            because,
            parts: if parts.len() > 1 { parts } else { Vec::new() },
            repairs: Vec::new(),
            elsewhere: Vec::new(),
            errata: Vec::new(),
            rests_on: Vec::new(),
        }
    }

    /// The reading of a text with the names of the notes only: a printed equation with errata, whose correction defines the
    /// names, or an equation of another print. A name that only this text introduces makes its statement unreadable.
    pub(crate) fn as_printed(&self, text: &str, claim: &Claim, macros: &Macros) -> Reading {
        let mut symbols = self.model.symbols.clone();
        symbols.for_each = for_each(Some(claim), self.model);
        let known = symbols.len();
        let mut reading = read_display(text, &mut symbols, macros);
        for new in reading.introduced.drain(..).filter(|introduced| introduced.symbol.0 >= known) {
            let statement = &mut reading.statements[new.statement];
            if let Ok(read) = statement {
                let name = text::plain(&symbols.entry(new.symbol).name.to_string());
                let span = read.members.get(new.member).map_or(read.span, |member| member.span);
                *statement = Err(Fault::new(
                    span,
                    format!("{name} is unknown, because neither the reference nor a corrected text defines it"),
                )
                .code(Code::UndeclaredName));
            }
        }
        reading
    }

    /// Every statement of a reading of the display, and what else is claimed of it or of its parts. The text that was read
    /// starts at `offset` of the file.
    pub(crate) fn parts(
        &self,
        place: (usize, usize),
        reading: &Reading,
        claim: &Claim,
        topic: &str,
    ) -> Result<Vec<Part>> {
        let pieces = self.pieces(place.0, reading)?;
        if let [(_, None)] = pieces.as_slice() {
            return self.parts_under(place, reading, claim, topic);
        }
        let mut all = Vec::new();
        for (at, (piece, own)) in pieces.iter().enumerate() {
            let topic = format!("{topic} piece {}", at + 1);
            let mut parts = self.parts_under(place, piece, own.unwrap_or(claim), &topic)?;
            if let Some(expect) = own.and_then(|own| own.expect.as_ref()) {
                parts.iter_mut().for_each(|part| part.ok |= part.finding.verdict == expected(expect));
                // A part that was to fail, and passes, is not as expected.
                if parts.iter().all(|part| part.finding.verdict.passes()) {
                    parts.iter_mut().for_each(|part| part.ok = false);
                }
            }
            all.extend(parts);
        }
        Ok(all)
    }

    /// Every statement of a reading, judged under one claim.
    fn parts_under(&self, place: (usize, usize), reading: &Reading, claim: &Claim, topic: &str) -> Result<Vec<Part>> {
        let parts = self.parts_at_an_instant(place, reading, claim, topic)?;
        self.if_it_lasts(parts, claim, |lasting| self.parts_at_an_instant(place, reading, lasting, topic))
    }

    /// Whether the words around a display say in which limit it holds, or to which order, and it has no ≈: "when $M \\to \\infty$,
    /// $\\Omega = …$".
    fn is_approached(&self, reading: &Reading, claim: &Claim) -> bool {
        let is_near = |statement: &Statement| {
            statement.relations.iter().any(|(relation, _)| *relation == Relation::Approximately)
        };
        claim.is_near_by_prose() && !reading.statements.iter().flatten().any(is_near)
    }

    /// The same, with each hypothesis as the claim has it.
    fn parts_at_an_instant(
        &self,
        (display, offset): (usize, usize),
        reading: &Reading,
        claim: &Claim,
        topic: &str,
    ) -> Result<Vec<Part>> {
        let meant = match self.is_approached(reading, claim) {
            true => Some(approximate(reading)),
            false => self.with_each_solution(reading),
        };
        let reading = meant.as_ref().unwrap_or(reading);
        if let Some(reason) = &claim.skip {
            let finding = Finding::new(
                Code::Skipped,
                Verdict::Unclaimed,
                Span::at(offset),
                format!("the claims file leaves it out: {}", reason.value),
            );
            return Ok(vec![self.part(finding, String::new())]);
        }
        let hypotheses = self.hypotheses(claim)?;
        let local = self.local(claim)?;
        let printed = self.hypotheses_as_printed(claim, &hypotheses)?;
        if let (Some(claimed), true) = (&claim.equilibrium, reading.statements.iter().all(Result::is_ok)) {
            return self.equilibria(reading, (claim, claimed.value), &hypotheses, offset, topic);
        }
        let on_shell = claim.holds.as_ref().map(|holds| holds.value == Holds::OnShell);
        let context = |topic: &'_ str, span: Span| -> (String, Span) { (topic.to_owned(), span.shifted(offset)) };
        let mut parts = Vec::new();
        self.needs_a_near_equality(reading, claim)?;
        if let Some(finding) = self.without_a_relation(display, reading, claim) {
            return Ok(vec![self.part(finding, String::new())]);
        }
        let mut units_agree = true;
        for (at, statement) in reading.statements.iter().enumerate() {
            let (topic, span) = match statement {
                Ok(statement) => context(&format!("{topic} part {}", at + 1), statement.span),
                Err(fault) => {
                    parts.push(self.part(self.unread_statement(fault, offset), String::new()));
                    continue;
                }
            };
            // Without explanations, the first failure decides.
            let is_wrong = |part: &Part| matches!(part.finding.verdict, Verdict::Refuted | Verdict::Domain);
            if !self.options.explain && claim.expect.is_none() && parts.iter().any(is_wrong) {
                return Ok(parts);
            }
            let Ok(statement) = statement else { continue };
            let units = self.unit_conflict((display, offset), statement, claim);
            if let Some(finding) = units.or_else(|| self.misfit(statement, offset)) {
                parts.push(self.part(finding, text::statement(statement, &self.model.symbols)));
                units_agree = false;
                continue;
            }
            let mut printed = printed.clone();
            printed.extend(self.conditions(statement)?);
            let context = Context {
                model: self.model,
                options: self.options,
                hypotheses: &printed,
                on_shell,
                topic: &topic,
                span,
                spread: Spread::Declared,
                local: &local,
            };
            if let Some(finding) = context.unclear(&statement.members.iter().collect::<Vec<_>>()) {
                parts.push(self.part(finding, text::statement(statement, &self.model.symbols)));
                continue;
            }
            if let Some(finding) = self.law(display, statement, &context)? {
                parts.push(self.part(finding, text::statement(statement, &self.model.symbols)));
                continue;
            }
            let introduced: Vec<&DefinedSymbol> = reading.introduced.iter().filter(|i| i.statement == at).collect();
            parts.extend(self.statement(statement, &introduced, claim, &context)?);
        }
        if units_agree {
            self.whole(reading, claim, (&hypotheses, &local), offset, topic, &mut parts)?;
        }
        if parts.is_empty() {
            let finding = Finding::new(
                Code::NoClaim,
                Verdict::Unclaimed,
                Span::at(offset),
                "nothing is claimed of this display; add a claim to the claims file",
            );
            parts.push(self.part(finding, String::new()));
        }
        Ok(parts)
    }

    /// The hypotheses of what is printed. With "also equals", the equalities that a claim assumes are hypotheses of the added
    /// expression only. Its inequalities restrict the states of the whole equation.
    fn hypotheses_as_printed(&self, claim: &Claim, hypotheses: &[Hypothesis]) -> Result<Vec<Hypothesis>> {
        if claim.also_equals.is_none() {
            return Ok(hypotheses.to_vec());
        }
        let of_all = self.hypotheses(&Claim::default())?.into_iter().filter(|c| !is_inequality(c.relation));
        Ok(of_all.chain(hypotheses.iter().filter(|c| is_inequality(c.relation)).cloned()).collect())
    }

    /// Rejects a limit for a display without ≈.
    fn needs_a_near_equality(&self, reading: &Reading, claim: &Claim) -> Result<()> {
        let approximates = |s: &Statement| s.relations.iter().any(|(relation, _)| *relation == Relation::Approximately);
        match &claim.limit {
            Some(limit) if !reading.statements.iter().flatten().any(approximates) => {
                let message = "there is no ≈ in this equation, and \"limit\" needs one";
                Err(Error::at(&self.claims.source, limit.span, message)
                    .help("write \\approx in the equation, or remove \"limit\""))
            }
            _ => Ok(()),
        }
    }

    /// The finding on a display that was read and has no relation that its claim needs.
    fn without_a_relation(&self, display: usize, reading: &Reading, claim: &Claim) -> Option<Finding> {
        let message = self.lacks_a_relation(claim, reading.statements.iter().flatten())?;
        let span = self.notes.equations[display].body;
        let is_read = reading.statements.iter().all(Result::is_ok);
        is_read.then(|| Finding::new(Code::ClaimDoesNotFit, Verdict::Unreadable, span, message))
    }

    /// The finding on a statement that cannot be read, with the display that is the cause of it.
    fn unread_statement(&self, fault: &Fault, offset: usize) -> Finding {
        let mut finding = unreadable(fault, offset);
        if let Some(cause) = self.cause(fault.missing.as_ref()) {
            finding.code = Code::DependsOnUnreadable;
            finding.message = format!("{}; {cause}", fault.message);
        } else if let Some(advice) = self.without_a_number(fault.missing.as_ref()) {
            finding.message = format!("{}; {advice}", fault.message);
        }
        finding
    }

    pub(crate) fn part(&self, finding: Finding, reading: String) -> Part {
        let latex = self.source.slice(finding.span).to_owned();
        let ok = finding.verdict.passes();
        Part { latex, reading, finding, ok }
    }

    /// The links of one statement, as one part with the worst of them; "is constant" is a part of its own.
    fn statement(
        &self,
        statement: &Statement,
        introduced: &[&DefinedSymbol],
        claim: &Claim,
        context: &Context<'_>,
    ) -> Result<Vec<Part>> {
        let reading = text::statement(statement, &self.model.symbols);
        let (mut findings, mut links) = (Vec::new(), Vec::new());
        for (at, (relation, sign)) in statement.relations.iter().enumerate() {
            let last = at + 1 == statement.relations.len();
            if at == 0 && self.is_unknown_of(&statement.members[0], claim)? {
                continue;
            }
            let ends = statement.members[at].span.to(statement.members[at + 1].span);
            let place = Context { span: ends.shifted(context.span.start - statement.span.start), ..*context };
            let is_introduced = introduced.iter().any(|new| new.member == at || new.member == at + 1);
            if let Some(finding) = self.measured(statement, (at, is_introduced), claim, &place) {
                findings.push(finding);
                continue;
            }
            // A definition is checked by its uses, unless the chain continues or the claim says more of the name.
            let says_more = claim.tests_a_definition() || statement.constant.is_some();
            if let (0, Some(first)) = (at, introduced.iter().find(|introduced| introduced.member == 0)) {
                if last && !says_more {
                    findings.push(self.definition(first, context)?);
                } else if let Some(finding) = self.declared_frequency(first.symbol, &first.formula, context)? {
                    findings.push(finding);
                }
                continue;
            }
            let here: Vec<&&DefinedSymbol> = introduced.iter().filter(|i| i.member == at + 1).collect();
            if !here.is_empty() {
                for introduced in here.into_iter().filter(|_| last && !says_more) {
                    findings.push(self.definition(introduced, context)?);
                }
                continue;
            }
            let mut link = self.link(&statement.members[at], *relation, &statement.members[at + 1])?;
            let printed = link.clone();
            if let (true, Some(dropped), None) = (last, &claim.dropping, &claim.also_equals) {
                let dropped = self.formula(dropped)?;
                if contains(&dropped, &link.lhs) {
                    let message = "\"dropping\" contains the left side, so nothing is checked; drop other terms";
                    findings.push(context.finding(Code::Circular, Verdict::Undecided, message));
                    continue;
                }
                link.rhs = with_dropped(&link.rhs, &dropped);
            }
            let finding = self.linked(statement, (at, *relation, *sign), &link, claim, &place)?;
            let finding = match claim.dropping.is_some() && link.rhs != printed.rhs {
                true => self.with_needless_terms(&printed, finding, &place)?,
                false => finding,
            };
            links.push(JudgedLink { at, finding, relation: *relation });
        }
        self.zeros(statement, &mut links, context)?;
        let mut parts = Vec::new();
        let mistakes = match claim.dropping.is_none() && claim.continuum_limit_of.is_none() {
            true => {
                chain_certificates::certify_links(self, statement, &mut links, context)?;
                self.mistakes(statement, &mut links, context)?
            }
            false => Vec::new(),
        };
        findings.extend(links.into_iter().map(|step| step.finding));
        let one =
            if mistakes.len() > 1 { mistakes } else { mistakes.into_iter().chain(merged(findings)).take(1).collect() };
        for mut finding in one {
            if finding.verdict.passes() {
                finding.span = context.span;
            }
            parts.push(self.part(finding, reading.clone()));
        }
        if statement.relations.is_empty() && statement.constant.is_none() {
            let message = match context.options.deduction {
                true => "a formula without a relation claims nothing; write an equation",
                false => {
                    "a formula without a relation claims nothing; write an equation, or leave it out with \"skip\" in the \
                     claims file"
                }
            };
            parts.push(self.part(context.finding(Code::NoRelation, Verdict::Unreadable, message), reading.clone()));
        }
        if let (Some(_), Some(last)) = (statement.constant, statement.members.last()) {
            let what = format!("{} is constant", text::formula(last, &self.model.symbols));
            let mut finding = conserved::check(last, context)?;
            self.only_constant(introduced, statement, &mut finding)?;
            parts.push(self.part(finding, what));
        }
        Ok(parts)
    }

    /// The finding on one link of a statement, by the kind of claim that is made of it.
    fn linked(
        &self,
        statement: &Statement,
        (at, relation, sign): (usize, Relation, Span),
        link: &Link,
        claim: &Claim,
        context: &Context<'_>,
    ) -> Result<Finding> {
        let from = statement.members[at].span;
        let solution = self.solution(link, at, claim);
        let finding = match relation {
            Relation::Equal if self.starts(claim) => self.along_its_start(link, solution.as_ref(), claim, context)?,
            _ if solution.is_some() => match &solution {
                Some(solution) => self.of_the_motion(solution, context)?,
                None => identity::check(link, context)?,
            },
            Relation::Approximately => match self.solution_near(link, at, claim) {
                Some(solution) => self.solution_to_an_order(&solution, claim, context)?,
                None => self.approximation(link, claim, sign, (from, context))?,
            },
            Relation::Proportional => context.finding(
                Code::NotSupported,
                Verdict::Unreadable,
                "∝ is not supported; write an equation with a constant",
            ),
            Relation::Equal if at == 0 && self.is_mode(link) => {
                let mode =
                    link.lhs.as_plain_symbol().map(|id| self.mode(id, &link.rhs, context)).transpose()?.flatten();
                mode.map_or_else(|| identity::check(link, context), Ok)?
            }
            Relation::Equal if at == 0 && self.is_frequency(link) => {
                let of = |id| self.declared_frequency(id, &link.rhs, context);
                let found = link.lhs.as_plain_symbol().map(of).transpose()?.flatten();
                found.map_or_else(|| identity::check(link, context), Ok)?
            }
            Relation::Equal if claim.secular_for.is_some() => match &claim.secular_for {
                Some(omega) => modes::secular_equation(link, self.symbol(omega)?, context)?,
                None => identity::check(link, context)?,
            },
            relation if !is_equality(relation) && !claim.exactly_when.is_empty() => {
                exactly_when::check(link, &self.alternatives(claim)?, context)?
            }
            _ if claim.continuum_limit_of.is_some() => self.continuum(link, claim, context)?,
            // A fit of single terms needs one equation: not two by ±, and none with dropped terms.
            _ if statement.branch.is_none() && claim.dropping.is_none() => {
                let found = self.along_the_motion(link, identity::check(link, context)?, context)?;
                self.in_first_order(link, found, claim, context)?
            }
            _ => identity::check(link, context)?,
        };
        let finding = self.with_moving_constant(link, finding, context);
        let finding = self.with_undetermined_name(link, finding, context);
        Ok(context.for_every_function(finding, &[&link.lhs, &link.rhs]))
    }

    /// Whether a link only repeats a definition of the display, or is the same formula in another order.
    pub(crate) fn only_repeats(&self, link: &Link, introduced: &[DefinedSymbol]) -> bool {
        let names: Vec<SymbolId> = introduced.iter().map(|new| new.symbol).collect();
        let is_made_of_them = |formula: &Expr| self.model.depends_on(formula, &names);
        if !is_made_of_them(&link.lhs) {
            return tautology::is_reordered(&link.lhs, &link.rhs);
        }
        let defined = self.model.symbols.iter().filter_map(|(symbol, entry)| match self.model.meaning(symbol) {
            Some(Meaning::Defined(formula)) if names.contains(&symbol) || is_made_of_them(formula) => {
                let letters = entry.slots.iter().map(|(_, letter)| *letter).collect();
                Some(Rule { symbol, letters, action: Action::Equals(formula.as_ref().clone()), throughout: true })
            }
            _ => None,
        });
        formulas::is_identity_where(&link.lhs, &link.rhs, &defined.collect::<Vec<_>>(), self.model)
    }
}

fn unreadable(fault: &Fault, offset: usize) -> Finding {
    let message = match &fault.help {
        Some(help) => format!("{}; {help}", fault.message),
        None => fault.message.clone(),
    };
    Finding::new(fault.code, Verdict::Unreadable, fault.span.shifted(offset), message)
}
