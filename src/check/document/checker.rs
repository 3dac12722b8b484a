//! The [`Checker`]: one document with its claims, notes, symbols and readings, and the lookup of what a claims file names
//! in them (an equation, a symbol, a formula, a hypothesis, a limit).
//!
//! # Which text of a wrong equation is used
//!
//! Its correction. (2.27) as printed says something false of p_i; corrected, it defines p̄_i, and (2.28) depends on
//! it. So everything but the equation itself uses the corrected text, and the printed text is tested with the names
//! of the correction. Otherwise one misprint would refute everything after it.

use std::sync::Arc;

use crate::code::Code;
use crate::formula::shape::Shape;
use crate::formula::{Assignment, Expr, Index, Node, Relation, Statement, SymbolId, Value, evaluate, shape, text};
use crate::latex::{Reading, names, read_display, read_formula};
use crate::notes::address::{Address, Target};
use crate::notes::claims::{Claim, Claims, Spanned};
use crate::notes::{Display, Notes};
use crate::source::{Fault, Missing, Source};
use crate::{Error, Result, suggest};

use crate::check::document::names::{shown, symbol};
use crate::check::document::normal_frequencies;
use crate::check::document::units::Units;
use crate::check::hypotheses::components;
use crate::check::hypotheses::rule::{Action, Rule, depends_through_rules};
use crate::check::kinds::limit::Towards;
use crate::check::kinds::{continuum, small};
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Law, Link, Unread, is_equality};
use crate::check::model::claims_error::formula_error;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::{Context, Options};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// Everything that checking one equation or sentence needs.
pub(crate) struct Checker<'a> {
    pub claims: &'a Claims,
    pub notes: &'a Notes,
    /// The file whose displays are checked: the notes, or another print of them.
    pub source: &'a Source,
    pub model: &'a Model,
    pub readings: &'a [Reading],
    pub assigned: &'a [Option<&'a Claim>],
    pub options: Options,
    /// The units of the document, where it declares any.
    pub units: Option<Arc<Units<'a>>>,
}

impl Checker<'_> {
    /// The link between two formulas, with their shapes bound.
    ///
    /// # Errors
    /// When the shapes of the two sides differ.
    pub fn link(&self, lhs: &Expr, relation: Relation, rhs: &Expr) -> Result<Link> {
        let typed = |expr: &Expr| shape::bind(expr.clone(), &self.model.symbols);
        let fault = |fault: Fault| Error::new(fault.message).with_code(fault.code);
        let ((lhs, a), (rhs, b)) = (typed(lhs).map_err(fault)?, typed(rhs).map_err(fault)?);
        let symbols = &self.model.symbols;
        let (lhs, a) = shape::entries_of((&lhs, &a), (&rhs, &b), symbols).unwrap_or((lhs, a));
        let (rhs, b) = shape::entries_of((&rhs, &b), (&lhs, &a), symbols).unwrap_or((rhs, b));
        shape::comparable((&lhs, &a), (&rhs, &b), symbols).map_err(fault)?;
        // Two vectors differ where one of their components differs.
        let (lhs, rhs) = match relation == Relation::NotEqual && [a.shape, b.shape].contains(&Shape::Vector) {
            true => {
                let span = lhs.span.to(rhs.span);
                (Expr::new(Node::Norm(Box::new(lhs.minus(rhs))), span), Expr::integer(0, span))
            }
            false => (lhs, rhs),
        };
        Ok(Link { lhs, relation, rhs, free: shape::union(&a.free, &b.free) })
    }

    /// Whether a link says what one of several normal frequencies is.
    pub(crate) fn is_mode(&self, link: &Link) -> bool {
        let name = link.lhs.as_plain_symbol().map(|id| &self.model.symbols.entry(id).name);
        name.is_some_and(|name| self.model.modes.contains(name))
    }

    /// The links of a statement that is a hypothesis; a = b = 0 gives a = 0 and b = 0.
    fn links(&self, statement: &Statement) -> Result<Vec<Link>> {
        if !statement.conditions.is_empty() {
            let message = "an equation with a condition beside it cannot be a hypothesis or a law; write it as LaTeX \
                           without the condition";
            return Err(Error::new(message).with_code(Code::NotSupported));
        }
        let (members, last) = (&statement.members, statement.members.len() - 1);
        let ends_in_zero =
            members[last].is_null() && statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        let next = |at: usize| if ends_in_zero { last } else { at + 1 };
        let links = statement.relations.iter().enumerate();
        links.map(|(at, (relation, _))| self.link(&members[at], *relation, &members[next(at)])).collect()
    }

    /// The conditions under which a statement is said, as hypotheses.
    pub(crate) fn conditions(&self, statement: &Statement) -> Result<Vec<Hypothesis>> {
        let mut hypotheses = Vec::new();
        for condition in &statement.conditions {
            for (pair, relation) in condition.members.windows(2).zip(&condition.relations) {
                let link = self.link(&pair[0], *relation, &pair[1])?;
                hypotheses.push(Hypothesis::of(link, false));
            }
        }
        hypotheses.extend(normal_frequencies::exist(statement.members.iter(), self.model));
        Ok(hypotheses)
    }

    /// The hypotheses of a claim: its own and those of the whole file.
    pub fn hypotheses(&self, claim: &Claim) -> Result<Vec<Hypothesis>> {
        let mut hypotheses = Vec::new();
        for latex in self.claims.assume.iter().chain(&claim.assume) {
            self.hypothesis(latex, false, &mut hypotheses)?;
        }
        for latex in &claim.throughout {
            self.hypothesis(latex, true, &mut hypotheses)?;
        }
        let stated = hypotheses.len();
        for latex in &claim.implied {
            self.hypothesis(latex, false, &mut hypotheses)?;
        }
        for latex in &claim.implied_throughout {
            self.hypothesis(latex, true, &mut hypotheses)?;
        }
        hypotheses[stated..].iter_mut().for_each(|hypothesis| hypothesis.implied = true);
        Ok(components::vectors(self.model, hypotheses))
    }

    /// The finding on a claim that holds while something is small.
    pub fn small(&self, link: &Link, claim: &Claim, context: &Context<'_>) -> Result<Finding> {
        let small: Vec<Expr> = claim.small.iter().map(|latex| self.formula(latex)).collect::<Result<_>>()?;
        small::check(link, &small, claim.order.as_ref().map_or(1, |order| order.value), context)
    }

    /// The finding on an integral as the limit of a sum over particles, which an equation of the notes prints.
    pub fn continuum(&self, link: &Link, claim: &Claim, context: &Context<'_>) -> Result<Finding> {
        let Some(of) = &claim.continuum_limit_of else { return continuum::check(link, context) };
        let mut known = false;
        for display in of.resolve(self.notes, &self.claims.source)? {
            let reading = &self.readings[display];
            known |= reading.introduced.iter().any(|new| link.lhs.as_plain_symbol() == Some(new.symbol))
                || reading.statements.iter().flatten().any(|statement| statement.members.contains(&link.lhs));
        }
        let found = continuum::check(link, context)?;
        if !known && found.verdict.passes() {
            let message = format!(
                "({}) does not define {} for particles; under \"continuum limit of\", name the equation that does",
                of.text,
                text::formula(&link.lhs, &self.model.symbols)
            );
            return Ok(context.finding(Code::WrongReference, Verdict::Undecided, message));
        }
        Ok(found)
    }

    /// The message for a claim that needs a relation that none of the statements has.
    pub fn lacks_a_relation<'s>(
        &self,
        claim: &Claim,
        statements: impl Iterator<Item = &'s Statement>,
    ) -> Option<&'static str> {
        let relations: Vec<Relation> =
            statements.flat_map(|s| s.relations.iter().map(|(relation, _)| *relation)).collect();
        let plain = |relation: &Relation| is_equality(*relation) || *relation == Relation::Approximately;
        if !claim.small.is_empty() && !relations.contains(&Relation::Approximately) {
            return Some("there is no ≈ here, and \"small\" needs one; write ≈, or remove \"small\"");
        }
        let inequality = claim.exactly_when.is_empty() || !relations.iter().all(plain);
        (!inequality).then_some("there is no inequality here, and \"true exactly when\" needs one; write one, or remove \"true exactly when\"")
    }

    /// The alternatives of a claim that holds exactly when one of them does.
    pub fn alternatives(&self, claim: &Claim) -> Result<Vec<Vec<Hypothesis>>> {
        let all = |latex: &Vec<Spanned<String>>| {
            let mut hypotheses = Vec::new();
            latex.iter().try_for_each(|latex| self.hypothesis(latex, false, &mut hypotheses))?;
            Ok(hypotheses)
        };
        claim.exactly_when.iter().map(all).collect()
    }

    /// The meanings that the claim gives to symbols in its equation only.
    pub fn local(&self, claim: &Claim) -> Result<Vec<Rule>> {
        let mut rules = Vec::new();
        for (name, meaning) in &claim.meanings {
            let at = |message: String| Error::at(&self.claims.source, meaning.span, message);
            let known = names::parse(&name.value).and_then(|(name, _)| self.model.symbols.find(&name));
            let (symbol, indices) = match known {
                Some(known) => known,
                None => (self.symbol(name)?, Vec::new()),
            };
            if let Some(Meaning::Defined(_)) = self.model.meaning(symbol) {
                return Err(at(format!(
                    "{} is defined already, so \"where\" cannot give it another meaning",
                    name.value
                ))
                .help("use another name, or give the meaning to a name in its definition"));
            }
            let letters = indices.iter().filter_map(|index| match index {
                Index::Letter(letter) => Some(*letter),
                Index::Fixed(_) => None,
            });
            let letters: Vec<_> = letters.collect();
            let parts: Vec<&str> = meaning.value.split("\\cup").map(str::trim).collect();
            let action = if parts.len() > 1 {
                if !matches!(letters.as_slice(), [letter] if self.model.symbols.indices[letter.0].labels) {
                    return Err(at(format!(
                        "{} is not a family of symbols, and \\cup joins families only",
                        name.value
                    ))
                    .help("give each family an index and write its members with it, as in \"indices\": { \"i\": \"1..n\" }, m_i"));
                }
                let part = |part: &&str| self.formula(&Spanned::new((*part).to_owned(), meaning.span));
                Action::Union(parts.iter().map(part).collect::<Result<_>>()?)
            } else {
                let formula = self.formula(meaning)?;
                if depends_through_rules(self.model, &rules, &formula, symbol) {
                    return Err(at(format!("the meaning of {0} contains {0} itself", name.value))
                        .help("write the meaning without this name"));
                }
                Action::Equals(formula)
            };
            rules.push(Rule { symbol, letters, action, throughout: true });
        }
        Ok(rules)
    }

    /// The laws of the claims file, as hypotheses; and those whose display cannot be read, each with the cause.
    pub fn laws(&self) -> Result<(Vec<Law>, Vec<Unread>)> {
        let (mut laws, mut lost) = (Vec::new(), Vec::new());
        for (name, what) in &self.claims.laws {
            match self.declared_law(name, what) {
                Ok(law) => laws.push(law),
                Err(error) => match self.cause(error.missing()) {
                    Some(cause) => lost.push((name.value.clone(), cause)),
                    None => return Err(error),
                },
            }
        }
        Ok((laws, lost))
    }

    fn declared_law(&self, name: &Spanned<String>, what: &Spanned<String>) -> Result<Law> {
        let printed = self.printed(what)?;
        let statements: Vec<(Statement, Option<usize>)> = match &printed {
            Some(places) => {
                let read = |(display, at): &(usize, usize)| {
                    let offset = self.notes.equations[*display].body.start;
                    Ok((self.read_statement(*display, *at, what)?, Some(offset)))
                };
                places.iter().map(read).collect::<Result<_>>()?
            }
            None => self.statements(what)?.into_iter().map(|statement| (statement, None)).collect(),
        };
        let mut hypotheses = Vec::new();
        for (statement, offset) in &statements {
            let (source, span) = match offset {
                Some(offset) => (&self.notes.source, statement.span.shifted(*offset)),
                None => (&self.claims.source, what.span),
            };
            let hypothesis = |link| Hypothesis::of(link, true).stated_at(source, span).of_law(&name.value);
            if statement.relations.is_empty() {
                let message = format!("“{}” is not an equation, so it cannot be a law", what.value);
                return Err(Error::at(&self.claims.source, what.span, message)
                    .help("give the number of an equation, or the equation as LaTeX; each law has its own name"));
            }
            hypotheses.extend(self.links(statement)?.into_iter().map(hypothesis));
        }
        let printed = printed.unwrap_or_default();
        let units_off = !self.claims.units.is_empty()
            && printed.iter().any(|(display, _)| self.assigned[*display].is_some_and(|c| c.units_off.is_some()));
        Ok(Law { name: name.value.clone(), printed, hypotheses, units_off, derived: false })
    }

    /// The statements that an address names, as the display and the index in it. `None`, if the text is not an address.
    fn printed(&self, what: &Spanned<String>) -> Result<Option<Vec<(usize, usize)>>> {
        let Ok(address) = Address::parse(what, &self.claims.source) else { return Ok(None) };
        let Some(point) = address.single() else { return Ok(None) };
        if !matches!(point.target, Target::Number(_) | Target::Label(_) | Target::Name(_)) {
            return Ok(None);
        }
        let displays = match address.resolve(self.notes, &self.claims.source) {
            Ok(displays) => displays,
            Err(error) if matches!(point.target, Target::Number(_)) => return Err(error),
            Err(_) => return Ok(None),
        };
        let mut places = Vec::new();
        for display in displays {
            let all = 0..self.readings[display].statements.len();
            places.extend(all.filter(|at| point.part.is_none_or(|part| part == at + 1)).map(|at| (display, at)));
        }
        Ok(Some(places))
    }

    /// Whether a text addresses a statement of the notes.
    pub fn is_printed(&self, what: &Spanned<String>) -> bool {
        matches!(self.printed(what), Ok(Some(_)))
    }

    fn read_statement(&self, display: usize, at: usize, what: &Spanned<String>) -> Result<Statement> {
        match self.readings[display].statements.get(at) {
            Some(Ok(statement)) => Ok(statement.clone()),
            Some(Err(fault)) => {
                let message = format!("({}) cannot be read: {}", what.value, fault.message);
                let missing = Missing::Equation(shown(&self.notes.equations[display]));
                Err(Error::at(&self.claims.source, what.span, message)
                    .with_code(Code::DependsOnUnreadable)
                    .lacking(Some(missing)))
            }
            None => Err(Error::at(
                &self.claims.source,
                what.span,
                format!("({}) names a part that its display does not have", what.value),
            )
            .help("correct `row`, `part` or `step`; each counts from 1")),
        }
    }

    fn hypothesis(&self, latex: &Spanned<String>, throughout: bool, into: &mut Vec<Hypothesis>) -> Result<()> {
        if let Some((_, named)) = self.claims.conditions.iter().find(|(name, _)| name.value == latex.value) {
            return named.iter().try_for_each(|latex| self.hypothesis(latex, throughout, into));
        }
        if let Some(at) = self.place(&latex.value) {
            let before = into.len();
            let offset = self.notes.equations[at].body.start;
            for statement in &self.readings[at].statements {
                let statement = statement.as_ref().map_err(|fault| self.unread(latex, fault))?;
                if statement.relations.is_empty() {
                    continue;
                }
                let span = statement.span.shifted(offset);
                let hypothesis = |link| Hypothesis::of(link, throughout).stated_at(&self.notes.source, span);
                into.extend(self.links(statement)?.into_iter().map(hypothesis));
            }
            return if into.len() > before { Ok(()) } else { Err(self.no_equation(latex)) };
        }
        if self.is_small(&latex.value) {
            return Ok(());
        }
        if let Some(text) = self.without_start(&latex.value) {
            let at_once = |text: &str| Spanned::new(text.to_owned(), latex.span);
            let time = self.model.symbols.time.as_ref().map_or_else(|| "t".to_owned(), ToString::to_string);
            self.hypothesis(&at_once(&format!("{time} = 0")), throughout, into)?;
            return self.hypothesis(&at_once(&text), throughout, into);
        }
        // An expression of mathematics has a sign, a digit or a command; words of prose have none.
        let are_words = latex.value.chars().all(|c| c.is_alphabetic() || c.is_whitespace() || "-,.'".contains(c));
        let statements = self.statements(latex).map_err(|error| {
            let names = self.claims.conditions.iter().map(|(name, _)| name.value.as_str());
            match suggest::nearest(&latex.value, names) {
                Some(near) => error.help(format!("did you mean \"{near}\", which is under \"conditions\"?")),
                None if are_words => self.no_hypothesis(latex),
                None => error,
            }
        })?;
        for statement in statements {
            if statement.relations.is_empty() {
                return Err(self.no_hypothesis(latex));
            }
            let hypothesis = |link| Hypothesis::of(link, throughout).stated_at(&self.claims.source, latex.span);
            into.extend(self.links(&statement)?.into_iter().map(hypothesis));
        }
        Ok(())
    }

    /// The statements of LaTeX in the claims file; they introduce nothing.
    pub fn statements(&self, latex: &Spanned<String>) -> Result<Vec<Statement>> {
        let mut symbols = self.model.symbols.clone();
        let known = symbols.len();
        let reading = read_display(&latex.value, &mut symbols, &self.model.macros);
        if let Some(new) = reading.introduced.iter().find(|introduced| introduced.symbol.0 >= known) {
            let fault = Fault::undeclared(latex.span, &symbols.entry(new.symbol).name);
            return Err(Error::fault(&self.claims.source, fault));
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
        symbol(self.claims, self.model, latex)
    }

    /// The reading of the display with this number or label.
    pub fn display(&self, address: &str) -> Option<&Reading> {
        self.place(address).map(|at| &self.readings[at])
    }

    /// Its place among the displays.
    pub fn place(&self, address: &str) -> Option<usize> {
        let named =
            |display: &Display| display.number.iter().chain(&display.labels).any(|numbered| numbered.id == address);
        self.notes.equations.iter().position(named)
    }

    /// The first statement of an equation, as a link between its first two members.
    pub fn target(&self, address: &Spanned<String>) -> Result<Link> {
        self.targets(address)?.into_iter().next().ok_or_else(|| self.no_equation(address))
    }

    /// The equalities of the first statement of an equation, each as a link between two members.
    pub fn targets(&self, address: &Spanned<String>) -> Result<Vec<Link>> {
        let nowhere = || {
            Error::at(&self.claims.source, address.span, format!("the notes have no equation ({})", address.value))
                .help("write the number or the label of an equation, or LaTeX of the notes in backticks")
        };
        match self.display(&address.value).ok_or_else(nowhere)?.statements.first() {
            Some(Ok(Statement { members, relations, .. })) if members.len() > 1 => {
                let links = members.windows(2).zip(relations);
                links.map(|(pair, (relation, _))| self.link(&pair[0], *relation, &pair[1])).collect()
            }
            Some(Err(fault)) => Err(self.unread(address, fault)),
            _ => Err(self.no_equation(address)),
        }
    }

    fn unread(&self, address: &Spanned<String>, fault: &Fault) -> Error {
        let message = format!("({}) cannot be read: {}", address.value, fault.message);
        let unread = Some(Missing::Equation(address.value.clone()));
        Error::at(&self.claims.source, address.span, message).with_code(Code::DependsOnUnreadable).lacking(unread)
    }

    /// The error of a text that is neither a relation nor the name of a condition.
    fn no_hypothesis(&self, latex: &Spanned<String>) -> Error {
        let message = format!("“{}” is not a hypothesis", latex.value);
        Error::at(&self.claims.source, latex.span, message)
            .help("write a relation such as \\dot\\theta = 0, or a name that is under \"conditions\"")
    }

    fn no_equation(&self, address: &Spanned<String>) -> Error {
        Error::at(
            &self.claims.source,
            address.span,
            format!("({}) has no relation such as =, and an equation is needed", address.value),
        )
        .help("name another equation, or write = in this one")
    }

    /// `x \to a`.
    pub fn limit(&self, latex: &Spanned<String>) -> Result<(SymbolId, Towards)> {
        let wrong = || self.no_limit(latex);
        let (variable, end) = at_arrow(latex).ok_or_else(wrong)?;
        let symbol = self.symbol(&Spanned { value: variable.trim().to_owned(), span: latex.span })?;
        let towards = match end.replace(' ', "").as_str() {
            "\\infty" | "+\\infty" => Towards::Infinity,
            "-\\infty" => Towards::MinusInfinity,
            _ => {
                let end = Spanned { value: end.to_owned(), span: latex.span };
                let formula = self.formula(&end)?;
                let nothing = Assignment::<f64>::new(&self.model.symbols);
                match evaluate(&formula, &nothing, &[]) {
                    Ok(Value::Scalar(value)) if value.value().is_finite() => Towards::Number(value.value()),
                    _ => return Err(wrong()),
                }
            }
        };
        Ok((symbol, towards))
    }

    /// The formula of a in `x \to a`.
    pub fn end_of_limit(&self, latex: &Spanned<String>) -> Result<Expr> {
        let (_, end) = at_arrow(latex).ok_or_else(|| self.no_limit(latex))?;
        self.formula(&Spanned { value: end.to_owned(), span: latex.span })
    }

    fn no_limit(&self, latex: &Spanned<String>) -> Error {
        Error::at(&self.claims.source, latex.span, format!("“{}” is not a limit", latex.value))
            .help("write a name, \\to, and a number or \\infty, such as \\omega_3 \\to \\infty")
    }
}

/// The texts before and after the arrow of a limit.
fn at_arrow(latex: &Spanned<String>) -> Option<(&str, &str)> {
    ["\\to", "\\rightarrow"].into_iter().find_map(|arrow| latex.value.split_once(arrow))
}
