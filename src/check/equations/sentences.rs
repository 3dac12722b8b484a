//! Findings on sentences of the notes.
//!
//! A claims file quotes a sentence word for word and states what it claims: a formula that holds (or does not always hold),
//! a constant of the motion, the shape of a function, the number of solutions of an equation, a reference.

use crate::code::Code;
use crate::formula::{Expr, Relation, Statement, SymbolId, text};
use crate::latex::Reading;
use crate::notes::claims::{Claims, Holds, Key, Property, Sentence, Sign, Spanned, Test};
use crate::phrases;
use crate::source::{Missing, Span};
use crate::suggest::in_json;
use crate::{Error, Result};

use crate::check::document::checker::Checker;
use crate::check::equations::merge::{expected, merged};
use crate::check::judge::identity;
use crate::check::kinds::limit::Towards;
use crate::check::kinds::shapes::function_shape;
use crate::check::kinds::shapes::shape::{Shape, Target};
use crate::check::kinds::{conserved, exactly_when, limit};
use crate::check::model::claim::{Link, is_equality};
use crate::check::model::order;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::{Context, NO_EQUALITY};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Equation;

/// Checks the `at`-th sentence of the claims file.
pub(crate) fn check(checker: &Checker<'_>, at: usize, sentence: &Sentence) -> Result<Equation> {
    let found = checker.notes.find_quote(&sentence.quote.value);
    let place = match found.as_slice() {
        [only] => *only,
        [] => {
            let message = "the notes do not contain this sentence";
            return Err(Error::at(&checker.claims.source, sentence.quote.span, message).help("quote it word for word"));
        }
        _ => {
            let message = format!("the notes contain this quote {} times", found.len());
            return Err(Error::at(&checker.claims.source, sentence.quote.span, message).help("quote more of it"));
        }
    };
    let name = name(at, sentence);
    let hypotheses = checker.hypotheses(&sentence.claim)?;
    let local = checker.local(&sentence.claim)?;
    let on_shell = sentence.claim.holds.as_ref().map(|holds| holds.value == Holds::OnShell);
    let context = Context {
        model: checker.model,
        options: checker.options,
        hypotheses: &hypotheses,
        on_shell,
        topic: &name,
        span: place,
        spread: Spread::Declared,
        local: &local,
    };
    let (finding, reading) = test(checker, sentence, &context)?;
    let ok = match &sentence.claim.expect {
        Some(expect) => finding.verdict == expected(expect),
        None => finding.verdict.passes(),
    };
    Ok(Equation {
        line: checker.notes.source.line_column(place.start).0,
        latex: checker.notes.source.slice(place).to_owned(),
        reading,
        finding,
        ok,
        because: sentence.claim.expect.as_ref().map(|expect| expect.because.value.clone()),
        parts: Vec::new(),
        repairs: Vec::new(),
        elsewhere: Vec::new(),
        errata: Vec::new(),
        rests_on: Vec::new(),
        id: name,
    })
}

/// The name of the `at`-th sentence in the report.
pub(crate) fn name(at: usize, sentence: &Sentence) -> String {
    sentence.name.as_ref().map_or_else(|| format!("sentence {}", at + 1), |name| name.value.clone())
}

/// Rejects keys that have no meaning for this sentence: a key that is ignored would look like a pass.
pub(crate) fn unsupported(claims: &Claims, sentence: &Sentence) -> Result<()> {
    let states_a_formula = matches!(sentence.test, Test::Quoted | Test::Claim(_) | Test::NotAlways(_));
    let runs_along =
        matches!(&sentence.test, Test::Of(_, Property::Sign(_) | Property::Minima(_) | Property::Maxima(_)));
    let against = sentence.against.as_ref().filter(|_| !runs_along).map(|against| against.span);
    let wrong = |(key, span): (Key, Span)| match states_a_formula {
        _ if !key.fits_a_sentence() => Some((span, format!("\"{}\" is not supported for a sentence", key.text()))),
        false if !key.fits_a_property() => {
            Some((span, format!("\"{}\" needs a sentence that states a formula", key.text())))
        }
        _ => None,
    };
    let named = [("in", sentence.scope.as_ref().map(|address| address.span)), ("against", against)];
    let named = named.into_iter().find_map(|(key, span)| Some((span?, format!("\"{key}\" is not supported here"))));
    match named.or_else(|| sentence.claim.keys().find_map(wrong)) {
        Some((span, message)) => {
            Err(Error::at(&claims.source, span, message).help("remove it, or write a claim for an equation"))
        }
        None => Ok(()),
    }
}

fn test(checker: &Checker<'_>, sentence: &Sentence, context: &Context<'_>) -> Result<(Finding, String)> {
    let symbols = &checker.model.symbols;
    match &sentence.test {
        Test::Quoted => {
            let formulas = quoted(sentence);
            if formulas.is_empty() {
                let message = "the quote contains no formula, and the sentence has no \"claim\"";
                return Err(Error::at(&checker.claims.source, sentence.quote.span, message)
                    .help("add \"claim\", or quote the formula with its dollar signs"));
            }
            let latex = Spanned::new(formulas, sentence.quote.span);
            let statements = checker.statements(&latex)?;
            let reading: Vec<String> = statements.iter().map(|s| text::statement(s, symbols)).collect();
            Ok((claim(checker, sentence, &statements, context)?, reading.join("; ")))
        }
        Test::Claim(latex) => {
            let statements = checker.statements(latex)?;
            let claims_nothing = |s: &Statement| s.relations.is_empty() && s.constant.is_none();
            if statements.iter().all(claims_nothing) {
                let message = format!("\"claim\" needs a relation, and “{}” is a formula alone", latex.value);
                return Err(Error::at(&checker.claims.source, latex.span, message).help(format!(
                    "write an equation or an inequality; to claim that the formula is constant, write \"conserved\": \
                     {}",
                    in_json(&latex.value)
                )));
            }
            let reading: Vec<String> = statements.iter().map(|s| text::statement(s, symbols)).collect();
            Ok((claim(checker, sentence, &statements, context)?, reading.join("; ")))
        }
        Test::NotAlways(latex) => {
            let statements = checker.statements(latex)?;
            let reading: Vec<String> = statements.iter().map(|s| text::statement(s, symbols)).collect();
            let finding = not_always(claim(checker, sentence, &statements, context)?);
            Ok((finding, format!("not always: {}", reading.join("; "))))
        }
        Test::RefersTo { number, containing } => refers_to(checker, &number.value, containing, context),
        Test::Conserved(latex) => {
            let formula = checker.formula(latex)?;
            let reading = format!("{} is constant", text::formula(&formula, symbols));
            Ok((conserved::check(&formula, context)?, reading))
        }
        Test::Of(of, property) => {
            let function = function(checker, of)?;
            let words = text::formula(&function, symbols);
            if let Some(finding) = context.unclear(&[&function]) {
                return Ok((finding, words));
            }
            let mut findings = Vec::new();
            findings.extend(of_one_sign(&function, property, context)?);
            for (variable, shape) in shapes(checker, sentence, property)? {
                findings.push(function_shape::check(&function, variable, &shape, context));
            }
            let finding =
                merged(findings).unwrap_or_else(|| context.finding(Code::NoClaim, Verdict::Unclaimed, NO_CLAIM));
            Ok((finding, format!("{} of {words}", property_words(property))))
        }
        Test::Solutions { count, of, unknown } => {
            let target = function_shape::as_function(&checker.target(&Spanned::new(of.text.clone(), of.span))?);
            let variable = checker.symbol(unknown)?;
            let shape = Shape::Solutions(count.value);
            let name = text::plain(&checker.model.name(variable));
            let solutions = if count.value == 1 { "solution" } else { "solutions" };
            let reading = format!("({}) has {} {solutions} for {name}", of.text, count.value);
            Ok((function_shape::check(&target, variable, &shape, context), reading))
        }
    }
}

/// The message of a sentence without a claim.
const NO_CLAIM: &str = "this sentence has no claim; add a key such as \"conserved\"";

/// The finding that a claim does not always hold, from the finding on the claim.
fn not_always(found: Finding) -> Finding {
    match found.verdict {
        Verdict::Refuted => {
            let message = "the claim does not always hold: there is a counterexample";
            Finding {
                not_certified_because: Some(NO_EQUALITY.into()),
                ..found.replaced(Code::NotAlways, Verdict::Verified, message)
            }
        }
        verdict if verdict.passes() => found.replaced(
            Code::HoldsAlways,
            Verdict::Refuted,
            "the claim holds at every sampled state, so no counterexample was found",
        ),
        _ => found,
    }
}

/// The finding that the display with a number contains a formula, as a text says that refers to it.
fn refers_to(
    checker: &Checker<'_>,
    number: &str,
    containing: &Spanned<String>,
    context: &Context<'_>,
) -> Result<(Finding, String)> {
    let wanted = checker.formula(containing)?;
    let words = text::formula(&wanted, &checker.model.symbols);
    let contains = |reading: &Reading| {
        let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        members.into_iter().any(|member| {
            let mut found = false;
            member.walk(&mut |inner| found |= *inner == wanted);
            found
        })
    };
    let holders: Vec<&str> = checker
        .notes
        .equations
        .iter()
        .zip(checker.readings)
        .filter(|(_, reading)| contains(reading))
        .filter_map(|(display, _)| display.id())
        .collect();
    let finding = match checker.display(number) {
        Some(reading) if contains(reading) => {
            let message = format!("({}) contains {words}", number);
            Finding { points: 1, tried: 1, ..context.verified(message, NO_EQUALITY) }
        }
        found => {
            let others = match holders.as_slice() {
                [] => String::new(),
                [only] => format!("; ({only}) does"),
                all => format!("; {} do", phrases::displays(all, "and")),
            };
            let message = match found {
                Some(_) => format!("({}) does not contain {words}{others}", number),
                None => {
                    format!("the notes have no equation ({}) that could contain {words}{others}", number)
                }
            };
            context.finding(Code::WrongReference, Verdict::Refuted, message)
        }
    };
    Ok((finding, format!("({}) contains {words}", number)))
}

impl Checker<'_> {
    /// The statements that a sentence claims to hold, if it claims any.
    pub(crate) fn claimed_by(&self, sentence: &Sentence) -> Option<Vec<Statement>> {
        let latex = match &sentence.test {
            Test::Claim(latex) if sentence.claim.limit.is_none() => latex.clone(),
            Test::Quoted => Spanned::new(quoted(sentence), sentence.quote.span),
            _ => return None,
        };
        self.statements(&latex).ok()
    }
}

/// The counterexample to the sign of a function, found like that of an inequality; `None`, if there is none.
fn of_one_sign(function: &Expr, property: &Property, context: &Context<'_>) -> Result<Option<Finding>> {
    let relation = match property {
        Property::Sign(sign) if sign.value == Sign::Positive => Relation::Greater,
        Property::Sign(sign) if sign.value == Sign::Negative => Relation::Less,
        _ => return Ok(None),
    };
    if !context.model.is_plain(function) || order::derivatives(function, context.model) > 0 {
        return Ok(None);
    }
    let link = Link { lhs: function.clone(), relation, rhs: Expr::integer(0, function.span), free: Vec::new() };
    let mut found = identity::check(&link, &Context { on_shell: Some(false), ..*context })?;
    // Another formula that has this sign says nothing of the sentence.
    found.forget_mutant();
    Ok((found.verdict == Verdict::Refuted).then_some(found))
}

/// The formulas that a sentence quotes.
fn quoted(sentence: &Sentence) -> String {
    sentence.quote.value.split('$').skip(1).step_by(2).collect::<Vec<_>>().join(", ")
}

/// Every link of some statements.
fn claim(
    checker: &Checker<'_>,
    sentence: &Sentence,
    statements: &[Statement],
    context: &Context<'_>,
) -> Result<Finding> {
    if let Some(message) = checker.lacks_a_relation(&sentence.claim, statements.iter()) {
        return Ok(context.finding(Code::ClaimDoesNotFit, Verdict::Unreadable, message));
    }
    if sentence.claim.units_off.is_none()
        && let Some(message) = statements.iter().find_map(|statement| checker.unit_conflict_of_claim(statement))
    {
        return Ok(context.finding(Code::UnitMismatch, Verdict::Unreadable, message));
    }
    let members: Vec<&Expr> = statements.iter().flat_map(|statement| &statement.members).collect();
    if let Some(finding) = context.unclear(&members) {
        return Ok(finding);
    }
    let mut findings = Vec::new();
    for statement in statements {
        for (at, (relation, _)) in statement.relations.iter().enumerate() {
            let link = checker.link(&statement.members[at], *relation, &statement.members[at + 1])?;
            let finding = match (&sentence.claim.limit, relation) {
                (_, Relation::Approximately) if !sentence.claim.small.is_empty() => {
                    checker.small(&link, &sentence.claim, context)?
                }
                (_, relation) if !is_equality(*relation) && !sentence.claim.exactly_when.is_empty() => {
                    exactly_when::check(&link, &checker.alternatives(&sentence.claim)?, context)?
                }
                _ if sentence.claim.continuum_limit_of.is_some() => {
                    checker.continuum(&link, &sentence.claim, context)?
                }
                (Some(limit), Relation::Approximately) => {
                    let (variable, towards) = checker.limit(limit)?;
                    limit::check(&link, variable, towards, context)?
                }
                _ => identity::check(&link, context)?,
            };
            findings.push(context.for_every_function(finding, &[&link.lhs, &link.rhs]));
        }
        if let (Some(_), Some(last)) = (statement.constant, statement.members.last()) {
            findings.push(conserved::check(last, context)?);
        }
    }
    Ok(merged(findings).unwrap_or_else(|| context.finding(Code::NoClaim, Verdict::Unclaimed, NO_CLAIM)))
}

/// A function given by the number of an equation (its last member) or by LaTeX.
fn function(checker: &Checker<'_>, of: &Spanned<String>) -> Result<Expr> {
    match checker.display(&of.value).map(|reading| reading.statements.first()) {
        Some(Some(Ok(statement))) => {
            let last = statement.members.last().cloned();
            last.ok_or_else(|| Error::at(&checker.claims.source, of.span, format!("({}) is empty", of.value)))
        }
        Some(_) => Err(Error::at(&checker.claims.source, of.span, format!("({}) cannot be read", of.value))
            .help("correct this equation first")
            .lacking(Some(Missing::Equation(of.value.clone())))),
        None => checker.formula(of),
    }
}

fn property_words(property: &Property) -> String {
    match property {
        Property::IndependentOf(names) => {
            let names: Vec<&str> = names.iter().map(|name| name.value.as_str()).collect();
            format!("independence from {}", text::plain(&names.join(", ")))
        }
        Property::Sign(sign) => match sign.value {
            Sign::Positive => "positive sign".to_owned(),
            Sign::Negative => "negative sign".to_owned(),
            Sign::Changes => "change of sign".to_owned(),
        },
        Property::Minima(n) => format!("{} {}", n.value, if n.value == 1 { "minimum" } else { "minima" }),
        Property::Maxima(n) => format!("{} {}", n.value, if n.value == 1 { "maximum" } else { "maxima" }),
        Property::TendsTo(limits) => {
            let limits: Vec<String> = limits
                .iter()
                .map(|(at, value)| {
                    format!("{}: {}", text::plain(&at.value.replace("\\to", "→")), text::plain(&value.value))
                })
                .collect();
            format!("limits ({})", limits.join(", "))
        }
        Property::RisesWith(x) => format!("rise with {}", text::plain(&x.value)),
        Property::FallsWith(x) => format!("fall with {}", text::plain(&x.value)),
    }
}

/// The shapes that a sentence claims, each with its variable.
fn shapes(checker: &Checker<'_>, sentence: &Sentence, property: &Property) -> Result<Vec<(SymbolId, Shape)>> {
    let along = || {
        sentence.against.as_ref().map(|name| checker.symbol(name)).unwrap_or_else(|| {
            Err(Error::at(
                &checker.claims.source,
                sentence.quote.span,
                "this sentence does not say which variable its formula is a function of",
            )
            .help("name the variable with \"against\" beside \"of\", as in \"against\": \"x\""))
        })
    };
    Ok(match property {
        Property::IndependentOf(names) => {
            let each = names.iter().map(|name| Ok((checker.symbol(name)?, Shape::Independent)));
            each.collect::<Result<_>>()?
        }
        Property::Sign(sign) => {
            let shape = match sign.value {
                Sign::Positive => Shape::Positive,
                Sign::Negative => Shape::Negative,
                Sign::Changes => Shape::ChangesSign,
            };
            vec![(along()?, shape)]
        }
        Property::Minima(n) => vec![(along()?, Shape::Minima(n.value))],
        Property::Maxima(n) => vec![(along()?, Shape::Maxima(n.value))],
        Property::RisesWith(x) => vec![(checker.symbol(x)?, Shape::Rises)],
        Property::FallsWith(x) => vec![(checker.symbol(x)?, Shape::Falls)],
        Property::TendsTo(limits) => {
            let each = limits.iter().map(|(at, value)| {
                let (variable, towards) = checker.limit(at)?;
                let Towards::Number(end) = towards else {
                    return Err(Error::at(
                        &checker.claims.source,
                        at.span,
                        "limits at infinity are not supported for a sentence; claim a \"limit\" of an equation instead",
                    ));
                };
                let target = match value.value.replace(' ', "").as_str() {
                    "\\infty" | "+\\infty" => Target::Infinite(Towards::Infinity),
                    "-\\infty" => Target::Infinite(Towards::MinusInfinity),
                    _ => Target::Finite(Box::new(checker.formula(value)?)),
                };
                let formula = Box::new(checker.end_of_limit(at)?);
                Ok((variable, Shape::TendsTo { end, formula, target }))
            });
            each.collect::<Result<_>>()?
        }
    })
}
