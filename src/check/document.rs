//! A whole document: its displays read in order, its claims tied to them, each equation judged.

use std::collections::HashMap;

use rayon::prelude::*;

use crate::formula::{Expr, Relation, Statement, SymbolId, shape, text};
use crate::latex::{Macros, Reading, names, read_display, read_formula};
use crate::notes::address::Address;
use crate::notes::claims::{Claim, Claims, Conserved, Erratum, Expect, Expected, Holds, Solved, Spanned};
use crate::notes::{Display, Notes};
use crate::source::{Fault, Span};
use crate::systems::Registry;
use crate::{Error, Result, suggest};

use super::draw::Reach;
use super::ensemble::Condition;
use super::identity::{self, Context, Options};
use super::judge::Link;
use super::limit::{self, Towards};
use super::model::{Model, formula_error};
use super::verdict::{Document, Equation, Finding, Part, Verdict};
use super::{definitions, generates, sentences, solves};

/// Checks a document; `only` restricts the work to one equation, and there may be none of that number.
///
/// # Errors
/// For claims that do not fit the notes or the system, each at its place in the claims file.
pub fn check_document(
    claims: &Claims,
    notes: &Notes,
    registry: &Registry,
    options: Options,
    only: Option<&str>,
) -> Result<Document> {
    let mut macros = Macros::default();
    for definition in &notes.macros {
        macros.define(&definition.name, definition.arguments, &definition.body);
    }
    repeated_numbers(notes)?;
    for sentence in &claims.sentences {
        sentences::unsupported(claims, sentence)?;
    }
    if let Some((name, _)) = claims.components.first() {
        return Err(Error::at(&claims.source, name.span, "\"components\" are not supported yet"));
    }
    let mut model = Model::new(claims, macros, registry)?;
    let assigned = assign(claims, notes)?;
    let mut readings = Vec::new();
    for (display, claim) in notes.equations.iter().zip(&assigned) {
        let wanted = id(display).is_some() || claim.is_some();
        let reading = if wanted { read(&display.text, &mut model) } else { Reading::default() };
        readings.push(reading);
    }
    let desk = Desk { claims, notes, model: &model, readings: &readings, assigned: &assigned, options };
    let chosen = |display: &&Display| only.is_none_or(|only| id(display) == Some(only));
    let work: Vec<usize> = (0..notes.equations.len())
        .filter(|at| chosen(&&notes.equations[*at]) && (id(&notes.equations[*at]).is_some() || assigned[*at].is_some()))
        .collect();
    let equations: Result<Vec<Equation>> = work.par_iter().map(|at| desk.equation(*at, assigned[*at])).collect();
    let sentences: Result<Vec<Equation>> = match only {
        Some(_) => Ok(Vec::new()),
        None => claims.sentences.par_iter().enumerate().map(|(at, s)| sentences::check(&desk, at, s)).collect(),
    };
    Ok(Document {
        path: notes.source.path.clone(),
        claims: Some(claims.source.path.clone()),
        source: notes.source.clone(),
        equations: equations?,
        sentences: sentences?,
        unnumbered: assigned
            .iter()
            .zip(&notes.equations)
            .filter(|(claim, d)| claim.is_none() && id(d).is_none())
            .count(),
        inferred: model.inferred.clone(),
    })
}

/// Refuses two displays with one number: a claim about it would be about either.
fn repeated_numbers(notes: &Notes) -> Result<()> {
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for display in &notes.equations {
        let Some(number) = &display.number else { continue };
        if let Some(line) = seen.insert(&number.id, display.line) {
            let message = format!("the number ({}) is used a second time, after line {line}", number.id);
            return Err(Error::at(&notes.source, number.span, message).help("give each equation a number of its own"));
        }
    }
    Ok(())
}

/// The report of notes that no claims file is about: every numbered equation is unclaimed.
pub fn unclaimed(notes: &Notes) -> Document {
    let equation = |display: &Display| {
        let message = "nothing says what this should mean: it has no claims file";
        let finding = Finding::new(Verdict::Unclaimed, display.body, message);
        Some(Equation {
            id: id(display)?.to_owned(),
            line: display.line,
            latex: notes.source.slice(display.body).to_owned(),
            reading: String::new(),
            finding,
            ok: false,
            because: None,
            parts: Vec::new(),
        })
    };
    Document {
        path: notes.source.path.clone(),
        claims: None,
        source: notes.source.clone(),
        equations: notes.equations.iter().filter_map(equation).collect(),
        sentences: Vec::new(),
        unnumbered: notes.equations.iter().filter(|display| id(display).is_none()).count(),
        inferred: Vec::new(),
    }
}

/// The number or else the first label of a display.
pub fn id(display: &Display) -> Option<&str> {
    let number = display.number.as_ref().or(display.labels.first());
    number.map(|numbered| numbered.id.as_str())
}

/// The claim of each display, where the claims file makes one.
fn assign<'c>(claims: &'c Claims, notes: &Notes) -> Result<Vec<Option<&'c Claim>>> {
    let mut assigned: Vec<Option<&Claim>> = vec![None; notes.equations.len()];
    for (address, claim) in &claims.equations {
        unsupported(claims, address, claim)?;
        for at in address.resolve(notes, &claims.source)? {
            if assigned[at].replace(claim).is_some() {
                let message = "a second claim for the same equation";
                return Err(Error::at(&claims.source, address.span, message).help("put all keys under one address"));
            }
        }
    }
    Ok(assigned)
}

/// Refuses what the format has and this version does not check yet, rather than pass it over.
fn unsupported(claims: &Claims, address: &Address, claim: &Claim) -> Result<()> {
    let spans = [
        ("where", claim.meanings.first().map(|(name, _)| name.span)),
        ("up to a constant", claim.up_to_a_constant),
        ("times", claim.times.as_ref().map(|s| s.span)),
        ("divided by", claim.divided_by.as_ref().map(|s| s.span)),
        ("defines", claim.defines.first().map(|s| s.span)),
        ("equation of motion of", claim.equation_of_motion_of.as_ref().map(|s| s.span)),
        ("from", claim.from.first().map(|a| a.span)),
    ];
    if let Some((key, span)) = spans.into_iter().find_map(|(key, span)| Some((key, span?))) {
        return Err(Error::at(&claims.source, span, format!("\"{key}\" is not supported yet")));
    }
    let partial = address.single().is_some_and(|p| p.row.is_some() || p.part.is_some() || p.step.is_some());
    if partial {
        return Err(Error::at(
            &claims.source,
            address.span,
            "claims about a part of an equation are not supported yet",
        )
        .help("claim it of the whole equation"));
    }
    Ok(())
}

/// The verdict that a claims file expects.
pub(super) fn expected(expect: &Expect) -> Verdict {
    match expect.verdict.value {
        Expected::Refuted => Verdict::Refuted,
        Expected::Domain => Verdict::Domain,
        Expected::Undecided => Verdict::Undecided,
        Expected::Unreadable => Verdict::Unreadable,
        Expected::Unclaimed => Verdict::Unclaimed,
    }
}

/// Reads a display and gives the symbols that it introduces their meaning.
fn read(text: &str, model: &mut Model) -> Reading {
    let macros = model.macros.clone();
    let reading = read_display(text, &mut model.symbols, &macros);
    for (id, at) in &reading.introduced {
        if let Some(Ok(statement)) = reading.statements.get(*at) {
            model.define(*id, statement.members[1].clone());
        }
    }
    reading
}

/// Everything that checking one equation or sentence needs.
pub(super) struct Desk<'a> {
    pub claims: &'a Claims,
    pub notes: &'a Notes,
    pub model: &'a Model,
    pub readings: &'a [Reading],
    pub assigned: &'a [Option<&'a Claim>],
    pub options: Options,
}

impl Desk<'_> {
    /// The finding on an equation, with its parts.
    fn equation(&self, at: usize, claim: Option<&Claim>) -> Result<Equation> {
        let display = &self.notes.equations[at];
        let none = Claim::default();
        let claim = claim.unwrap_or(&none);
        let offset = display.body.start;
        let reading = &self.readings[at];
        let topic = id(display).map_or_else(|| format!("line {}", display.line), str::to_owned);
        let mut parts = self.parts(reading, claim, offset, &topic)?;
        let mut because = claim.expect.as_ref().map(|expect| expect.because.value.clone());
        let passes = |parts: &[Part]| parts.iter().all(|part| part.finding.verdict.passes());
        let mut as_expected = match &claim.expect {
            Some(expect) => {
                let verdict = expected(expect);
                let pinned = |part: &Part| part.finding.verdict == verdict;
                parts.iter().any(pinned) && parts.iter().all(|part| pinned(part) || part.finding.verdict.passes())
            }
            None => passes(&parts),
        };
        if !claim.errata.is_empty() {
            let corrected = self.corrected(display, &claim.errata)?;
            let mut symbols = self.model.symbols.clone();
            let reading = read_display(&corrected, &mut symbols, &self.model.macros);
            let mended = self.parts(&reading, claim, offset, &topic)?;
            let failed = !passes(&parts);
            as_expected = failed && passes(&mended);
            let edits: Vec<String> =
                claim.errata.iter().map(|e| format!("for “{}” read “{}”", e.printed.value, e.read.value)).collect();
            let verdict = match (failed, as_expected) {
                (true, true) => "as corrected it passes".to_owned(),
                (true, false) => format!("as corrected it does not pass: {}", worst(&mended).message),
                (false, _) => "but it passes as printed".to_owned(),
            };
            because = Some(format!("{}; {verdict}", edits.join(", ")));
        }
        if let Some(expect) = &claim.expect {
            // A pinned equation is as expected as a whole; its sound parts need no excuse.
            parts.iter_mut().for_each(|part| part.ok = part.ok || part.finding.verdict == expected(expect));
        }
        let finding = worst(&parts);
        let readings: Vec<&str> = parts.iter().map(|part| part.reading.as_str()).filter(|r| !r.is_empty()).collect();
        Ok(Equation {
            id: topic,
            line: display.line,
            latex: self.notes.source.slice(display.body).to_owned(),
            reading: readings.join("; "),
            finding,
            ok: as_expected,
            because,
            parts: if parts.len() > 1 { parts } else { Vec::new() },
        })
    }

    fn corrected(&self, display: &Display, errata: &[Erratum]) -> Result<String> {
        let mut text = display.text.clone();
        for erratum in errata {
            let found = text.matches(&erratum.printed.value).count();
            if found != erratum.times {
                let message = format!("“{}” stands {found} times in this equation", erratum.printed.value);
                return Err(Error::at(&self.claims.source, erratum.printed.span, message)
                    .help("quote more of it, or say how often with \"times\""));
            }
            text = text.replace(&erratum.printed.value, &erratum.read.value);
        }
        Ok(text)
    }

    /// Every statement of a display, and what else is claimed of it.
    fn parts(&self, reading: &Reading, claim: &Claim, offset: usize, topic: &str) -> Result<Vec<Part>> {
        if let Some(reason) = &claim.skip {
            let finding = Finding::new(Verdict::Unclaimed, Span::at(offset), format!("skipped: {}", reason.value));
            return Ok(vec![self.part(finding, String::new())]);
        }
        let conditions = self.conditions(claim)?;
        let on_shell = claim.holds.as_ref().map(|holds| holds.value == Holds::OnShell);
        let context = |topic: &'_ str, span: Span| -> (String, Span) { (topic.to_owned(), span.shifted(offset)) };
        let mut parts = Vec::new();
        for (at, statement) in reading.statements.iter().enumerate() {
            let (topic, span) = match statement {
                Ok(statement) => context(&format!("{topic} part {}", at + 1), statement.span),
                Err(fault) => {
                    parts.push(self.part(unreadable(fault, offset), String::new()));
                    continue;
                }
            };
            let Ok(statement) = statement else { continue };
            let context = Context {
                model: self.model,
                options: self.options,
                conditions: &conditions,
                on_shell,
                topic: &topic,
                span,
                reach: Reach::Declared,
            };
            let introduced = reading.introduced.iter().find(|(_, place)| *place == at).map(|(id, _)| *id);
            parts.extend(self.statement(statement, introduced, claim, &context)?);
        }
        self.whole(reading, claim, &conditions, offset, topic, &mut parts)?;
        if parts.is_empty() {
            let finding = Finding::new(Verdict::Unclaimed, Span::at(offset), "nothing says what this should mean");
            parts.push(self.part(finding, String::new()));
        }
        Ok(parts)
    }

    fn part(&self, finding: Finding, reading: String) -> Part {
        let latex = self.notes.source.slice(finding.span).to_owned();
        let ok = finding.verdict.passes();
        Part { latex, reading, finding, ok }
    }

    /// The links of one statement, as one part with the worst of them; "is constant" is a part of its own.
    fn statement(
        &self,
        statement: &Statement,
        introduced: Option<SymbolId>,
        claim: &Claim,
        context: &Context<'_>,
    ) -> Result<Vec<Part>> {
        let reading = text::statement(statement, &self.model.symbols);
        let mut findings = Vec::new();
        for (at, (relation, place)) in statement.relations.iter().enumerate() {
            let last = at + 1 == statement.relations.len();
            if at == 0 && self.is_unknown_of(&statement.members[0], claim)? {
                continue;
            }
            if let (0, Some(symbol)) = (at, introduced) {
                if claim.solves.is_none() {
                    findings.push(self.definition(symbol, statement, context)?);
                }
                continue;
            }
            let mut link = self.link(&statement.members[at], *relation, &statement.members[at + 1])?;
            if let (true, Some(dropped), None) = (last, &claim.dropping, &claim.also_equals) {
                let dropped = self.formula(dropped)?;
                link.rhs = identity::with_dropped(&link.rhs, &dropped);
            }
            let (from, to) = (statement.members[at].span, statement.members[at + 1].span);
            let context = Context { span: from.to(to).shifted(context.span.start - statement.span.start), ..*context };
            let finding = match (relation, &claim.limit) {
                (Relation::Approximately, Some(limit)) => {
                    let (variable, towards) = self.limit(limit)?;
                    limit::check(&link, variable, towards, &context)?
                }
                (Relation::Approximately, None) => {
                    let span = place.shifted(context.span.start - from.start);
                    Finding {
                        span,
                        ..context.finding(Verdict::Unreadable, "approximately, but when? Name the \"limit\"")
                    }
                }
                (Relation::Proportional, _) => context.finding(Verdict::Unreadable, "∝ is not checked yet"),
                _ => identity::check(&link, &context)?,
            };
            findings.push(finding);
        }
        let mut parts = Vec::new();
        if let Some(mut finding) = merged(findings) {
            if finding.verdict.passes() {
                finding.span = context.span;
            }
            parts.push(self.part(finding, reading.clone()));
        }
        if statement.relations.is_empty() && statement.constant.is_none() {
            let message = "a formula without a relation claims nothing";
            parts.push(self.part(context.finding(Verdict::Unreadable, message), reading.clone()));
        }
        if let (Some(_), Some(last)) = (statement.constant, statement.members.last()) {
            let what = format!("{} is constant", text::formula(last, &self.model.symbols));
            parts.push(self.part(identity::conserved(last, context)?, what));
        }
        Ok(parts)
    }

    /// Whether a member is the unknown that a claim solves for: then what stands beside it is the solution.
    fn is_unknown_of(&self, member: &Expr, claim: &Claim) -> Result<bool> {
        let Some(solves) = &claim.solves else { return Ok(false) };
        let unknowns: Result<Vec<SymbolId>> = solves.unknowns.iter().map(|unknown| self.symbol(unknown)).collect();
        Ok(member.as_plain_symbol().is_some_and(|id| unknowns.is_ok_and(|unknowns| unknowns.contains(&id))))
    }

    /// The verdict on a statement that introduces a symbol.
    fn definition(&self, symbol: SymbolId, statement: &Statement, context: &Context<'_>) -> Result<Finding> {
        let mut claims = Vec::new();
        for (at, reading) in self.readings.iter().enumerate() {
            let claim = self.assigned[at];
            for (place, other) in reading.statements.iter().enumerate() {
                let own = reading.introduced.iter().any(|(id, at)| *id == symbol && *at == place);
                let Ok(other) = other else { continue };
                let links = other.relations.iter().enumerate().skip(usize::from(own));
                for (k, (relation, _)) in links {
                    let uses = other.members[k..k + 2].iter().any(|member| solves::mentions(member, symbol));
                    if uses && matches!(relation, Relation::Equal | Relation::Identical) {
                        let link = self.link(&other.members[k], *relation, &other.members[k + 1])?;
                        let conditions = claim.map(|claim| self.conditions(claim)).transpose()?.unwrap_or_default();
                        let display = &self.notes.equations[at];
                        let id = id(display).map_or_else(|| format!("line {}", display.line), str::to_owned);
                        claims.push((id, link, conditions));
                    }
                }
            }
        }
        let mut users: Vec<definitions::User<'_>> = claims
            .iter()
            .map(|(id, link, conditions)| definitions::User {
                id: id.clone(),
                link: link.clone(),
                context: Context { conditions, topic: id, on_shell: None, ..*context },
            })
            .collect();
        definitions::check(symbol, &statement.members[1], &mut users, context)
    }

    /// What a claim adds to the statements: solutions, other expressions, conservation, the motion.
    fn whole(
        &self,
        reading: &Reading,
        claim: &Claim,
        conditions: &[Condition],
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
            conditions,
            on_shell,
            topic: &topic,
            span,
            reach: Reach::Declared,
        };
        if let Some(solves) = &claim.solves {
            let address = match &solves.of {
                Solved::Equation(address) => Spanned::new(address.text.clone(), address.span),
                Solved::EquationsOfMotion(span) => {
                    let message = "solutions of the equations of motion are not supported yet";
                    return Err(Error::at(&self.claims.source, *span, message));
                }
            };
            let [unknown] = solves.unknowns.as_slice() else {
                return Err(Error::at(&self.claims.source, address.span, "one unknown at a time is supported"));
            };
            let target = self.target(&address)?;
            let symbol = self.symbol(unknown)?;
            let branches: Vec<Expr> = statements.iter().filter_map(|s| s.members.last().cloned()).collect();
            let finding = solves::check(&target, symbol, &branches, &context)?;
            let reading = format!("solves ({}) for {}", address.value, text::plain(&self.model.name(symbol)));
            parts.push(self.part(finding, reading));
        }
        if let Some(also) = &claim.also_equals {
            let other = self.formula(also)?;
            let printed = match &claim.dropping {
                Some(dropped) => identity::with_dropped(printed, &self.formula(dropped)?),
                None => printed.clone(),
            };
            let link = self.link(&other, Relation::Equal, &printed)?;
            let finding = identity::check(&link, &context)?;
            let reading =
                text::formula(&link.lhs, &self.model.symbols) + " = " + &text::formula(&link.rhs, &self.model.symbols);
            parts.push(self.part(finding, reading));
        }
        if let Some(conserved) = &claim.conserved {
            let what = match &conserved.value {
                Conserved::Expression(latex) => self.formula(&Spanned::new(latex.clone(), conserved.span))?,
                Conserved::This => printed.clone(),
            };
            let finding = identity::conserved(&what, &context)?;
            parts.push(self.part(finding, format!("{} is constant", text::formula(&what, &self.model.symbols))));
        }
        if claim.generates.is_some() {
            let finding = generates::check(printed, &context)?;
            parts.push(self.part(finding, "it generates the motion by Hamilton's equations".to_owned()));
        }
        Ok(())
    }

    /// A link between two formulas, typed.
    pub fn link(&self, lhs: &Expr, relation: Relation, rhs: &Expr) -> Result<Link> {
        let typed = |expr: &Expr| shape::bind(expr.clone(), &self.model.symbols);
        let fault = |fault: Fault| Error::new(fault.message);
        let ((lhs, a), (rhs, b)) = (typed(lhs).map_err(fault)?, typed(rhs).map_err(fault)?);
        shape::comparable((&lhs, &a), (&rhs, &b)).map_err(fault)?;
        let free = if a.free.is_empty() { b.free } else { a.free };
        Ok(Link { lhs, relation, rhs, free })
    }

    /// The hypotheses of a claim: its own and those of the whole file.
    pub fn conditions(&self, claim: &Claim) -> Result<Vec<Condition>> {
        let mut conditions = Vec::new();
        for latex in self.claims.assume.iter().chain(&claim.assume) {
            self.condition(latex, false, &mut conditions)?;
        }
        for latex in &claim.throughout {
            self.condition(latex, true, &mut conditions)?;
        }
        Ok(conditions)
    }

    fn condition(&self, latex: &Spanned<String>, throughout: bool, into: &mut Vec<Condition>) -> Result<()> {
        if let Some((_, named)) = self.claims.conditions.iter().find(|(name, _)| name.value == latex.value) {
            return named.iter().try_for_each(|latex| self.condition(latex, throughout, into));
        }
        if self.display(&latex.value).is_some() {
            let link = self.target(latex)?;
            into.push(Condition { lhs: link.lhs, relation: link.relation, rhs: link.rhs, throughout });
            return Ok(());
        }
        let statements = self.statements(latex).map_err(|error| {
            let names = self.claims.conditions.iter().map(|(name, _)| name.value.as_str());
            match suggest::nearest(&latex.value, names) {
                Some(near) => error.help(format!("did you mean the condition \"{near}\"?")),
                None => error,
            }
        })?;
        for statement in statements {
            if statement.relations.is_empty() {
                let message = format!("“{}” is no condition", latex.value);
                return Err(Error::at(&self.claims.source, latex.span, message)
                    .help("write a relation, \\dot\\theta = 0, or the name of one of the \"conditions\""));
            }
            for (at, (relation, _)) in statement.relations.iter().enumerate() {
                let link = self.link(&statement.members[at], *relation, &statement.members[at + 1])?;
                into.push(Condition { lhs: link.lhs, relation: link.relation, rhs: link.rhs, throughout });
            }
        }
        Ok(())
    }

    /// The statements of LaTeX in the claims file; they introduce nothing.
    pub fn statements(&self, latex: &Spanned<String>) -> Result<Vec<Statement>> {
        let mut symbols = self.model.symbols.clone();
        let known = symbols.len();
        let reading = read_display(&latex.value, &mut symbols, &self.model.macros);
        if let Some((id, _)) = reading.introduced.iter().find(|(id, _)| id.0 >= known) {
            let message = format!("{} is not declared", symbols.entry(*id).name);
            return Err(Error::at(&self.claims.source, latex.span, message));
        }
        reading.statements.into_iter().map(|s| s.map_err(|fault| formula_error(self.claims, latex, fault))).collect()
    }

    /// A formula of the claims file.
    pub fn formula(&self, latex: &Spanned<String>) -> Result<Expr> {
        let mut symbols = self.model.symbols.clone();
        read_formula(&latex.value, &mut symbols, &self.model.macros)
            .map_err(|fault| formula_error(self.claims, latex, fault))
    }

    /// A symbol named in the claims file.
    pub fn symbol(&self, latex: &Spanned<String>) -> Result<SymbolId> {
        let name = names::parse(&latex.value).filter(|(_, dots)| *dots == 0).map(|(name, _)| name);
        let found = name.as_ref().and_then(|name| self.model.symbols.find(name));
        found.map(|(id, _)| id).ok_or_else(|| {
            let error = Error::at(&self.claims.source, latex.span, format!("there is no symbol {}", latex.value));
            match name.and_then(|name| self.model.symbols.nearest(&name)) {
                Some(near) => error.help(format!("did you mean {near}?")),
                None => error,
            }
        })
    }

    /// The reading of the display with this number or label.
    pub fn display(&self, address: &str) -> Option<&Reading> {
        let named =
            |display: &Display| display.number.iter().chain(&display.labels).any(|numbered| numbered.id == address);
        self.notes.equations.iter().position(named).map(|at| &self.readings[at])
    }

    /// The first statement of an equation, as a link between its first two members.
    pub fn target(&self, address: &Spanned<String>) -> Result<Link> {
        let missing = |message: String| Error::at(&self.claims.source, address.span, message);
        let reading =
            self.display(&address.value).ok_or_else(|| missing(format!("there is no ({})", address.value)))?;
        match reading.statements.first() {
            Some(Ok(Statement { members, relations, .. })) if members.len() > 1 => {
                self.link(&members[0], relations[0].0, &members[1])
            }
            Some(Err(fault)) => Err(missing(format!("({}) cannot be read: {}", address.value, fault.message))),
            _ => Err(missing(format!("({}) is not an equation", address.value))),
        }
    }

    /// `x \to a`.
    pub fn limit(&self, latex: &Spanned<String>) -> Result<(SymbolId, Towards)> {
        let wrong = || {
            Error::at(&self.claims.source, latex.span, format!("“{}” is no limit", latex.value))
                .help("write \\omega_3 \\to \\infty")
        };
        let arrow = ["\\to", "\\rightarrow"].into_iter().find_map(|arrow| latex.value.split_once(arrow));
        let (variable, end) = arrow.ok_or_else(wrong)?;
        let symbol = self.symbol(&Spanned { value: variable.trim().to_owned(), span: latex.span })?;
        let towards = match end.replace(' ', "").as_str() {
            "\\infty" | "+\\infty" => Towards::Infinity,
            "-\\infty" => Towards::MinusInfinity,
            _ => {
                let end = Spanned { value: end.to_owned(), span: latex.span };
                let formula = self.formula(&end)?;
                let nothing = crate::formula::Assignment::<f64>::new(&self.model.symbols);
                match crate::formula::evaluate(&formula, &nothing, &[]) {
                    Ok(crate::formula::Value::Scalar(value)) if value.value().is_finite() => {
                        Towards::Number(value.value())
                    }
                    _ => return Err(wrong()),
                }
            }
        };
        Ok((symbol, towards))
    }
}

fn unreadable(fault: &Fault, offset: usize) -> Finding {
    let message = match &fault.help {
        Some(help) => format!("{}; {help}", fault.message),
        None => fault.message.clone(),
    };
    Finding::new(Verdict::Unreadable, fault.span.shifted(offset), message)
}

/// Several findings as one: the worst speaks, the evidence is taken together.
pub(super) fn merged(findings: Vec<Finding>) -> Option<Finding> {
    let fewest = findings.iter().filter(|f| f.points > 0).map(|f| f.points).min();
    let largest = findings.iter().filter_map(|f| f.max_residual).reduce(f64::max);
    let tried = findings.iter().map(|f| f.tried).max();
    let mut worst =
        findings.into_iter().reduce(|a, b| if b.verdict.severity() > a.verdict.severity() { b } else { a })?;
    if worst.verdict.passes() {
        worst.points = fewest.unwrap_or(0);
        worst.max_residual = largest;
        worst.tried = tried.unwrap_or(0);
    }
    Some(worst)
}

/// The worst finding of some parts, which the whole carries.
fn worst(parts: &[Part]) -> Finding {
    merged(parts.iter().map(|part| part.finding.clone()).collect())
        .unwrap_or_else(|| Finding::new(Verdict::Unclaimed, Span::default(), "nothing is claimed"))
}
