//! The comparison of two formulas without a document; each letter, with or without dots, is a real number.

use crate::Result;
use crate::code::Code;
use crate::formula::symbols::{Kind, Name};
use crate::formula::units::UnitCheck;
use crate::formula::units::in_si::{has_units, in_si};
use crate::formula::{Expr, Node, Relation, Statement, SymbolId, Symbols, text};
use crate::latex::{Macros, read_display, read_formula};
use crate::notes::claims::Range;
use crate::source::{Fault, Span};

use crate::check::judge::identity;
use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::{Context, Options};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// Whether two formulas are equal: the verdict with its evidence.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Comparison {
    /// The verdict, with its evidence.
    pub finding: Finding,
    /// The readings of both formulas.
    pub readings: [String; 2],
    /// What was assumed about the letters.
    pub assumed: Vec<String>,
}

/// A fault in the first (0) or second (1) formula, or in the ranges (2).
pub type Misread = (usize, Fault);

/// Whether two formulas are equal for all real values of their letters, or for those in `ranges`.
///
/// # Errors
/// When one of the two cannot be read, or a range is for a letter that is in neither.
pub fn equal(a: &str, b: &str, ranges: &[(Name, Range)], options: Options) -> Result<Comparison, Misread> {
    let mut symbols = Symbols::open();
    let macros = Macros::default();
    for (which, text) in [(0, a), (1, b)] {
        if let Some(fault) = two_sides(text, &macros) {
            return Err((which, fault));
        }
    }
    // A letter with a range is declared: `i` with one is no √−1.
    for (name, _) in ranges {
        symbols.add(name.clone(), Kind::Scalar);
    }
    let lhs = read_formula(a, &mut symbols, &macros).map_err(|fault| (0, fault))?;
    let rhs = read_formula(b, &mut symbols, &macros).map_err(|fault| (1, fault))?;
    let mut model = Model::empty(symbols, macros);
    for (name, _) in ranges {
        let occurs = model.symbols.find(name).is_some_and(|(id, _)| [&lhs, &rhs].iter().any(|side| has(side, id)));
        if !occurs {
            let fault = Fault::new(Span::default(), format!("{name} occurs in neither formula"));
            return Err((2, fault.code(Code::Input)));
        }
    }
    let mut assumed = Vec::new();
    let letters = model.symbols.iter().filter(|(_, entry)| !entry.bound);
    let letters: Vec<(SymbolId, Name)> = letters.map(|(id, entry)| (id, entry.name.clone())).collect();
    for (symbol, name) in letters {
        let given = ranges.iter().find(|(known, _)| *known == name).map(|(_, range)| range.clone());
        let shown = text::plain(&name.to_string());
        let kind = model.symbols.entry(symbol).kind;
        assumed.push(match &given {
            Some(Range::Interval { low, high, .. }) => format!("{shown} is between {low} and {high}"),
            _ => format!("{shown} is {}", kind.noun()),
        });
        if kind == Kind::Matrix(0, 0) {
            let message = format!("the number of rows of the matrix {shown} is not known");
            return Err((0, Fault::new(Span::default(), message).help("write the matrix out")));
        }
        model.mean(symbol, Meaning::Varying(model.varying.len()));
        model.varying.push(Variable { symbol, range: given.unwrap_or(Range::Any), numbers: kind.numbers() });
        model.symbols.entry_mut(symbol).varies = true;
    }
    let readings = [text::formula(&lhs, &model.symbols), text::formula(&rhs, &model.symbols)];
    let span = Span::default();
    if let Some(message) = units_differ(&lhs, &rhs, &model.symbols) {
        let finding = Finding::new(Code::UnitMismatch, Verdict::Refuted, span, message);
        return Ok(Comparison { finding, readings, assumed });
    }
    let (mut lhs, mut rhs) = (lhs, rhs);
    in_si(&mut lhs);
    in_si(&mut rhs);
    if lhs == rhs {
        let finding = Finding::new(Code::Definition, Verdict::Definition, span, "both formulas are the same");
        return Ok(Comparison { finding, readings, assumed });
    }
    let spread = Spread::WithEnds;
    let context = Context {
        model: &model,
        options,
        hypotheses: &[],
        on_shell: Some(false),
        topic: "equal",
        span,
        spread,
        local: &[],
    };
    let link = Link { lhs, relation: Relation::Equal, rhs, free: Vec::new() };
    let mut finding = identity::check(&link, &context).map_err(|error| (0, Fault::new(span, error.message())))?;
    if finding.code == Code::TooFewStates {
        let has_letters = [&link.lhs, &link.rhs].iter().any(|side| !side.symbols().is_empty());
        finding.message = match has_letters {
            false => "a formula has no real value; look for a division by 0, and for a root, power or logarithm of a \
                      negative number; write an odd root as \\sqrt[3]{x}"
                .to_owned(),
            true => format!(
                "only {} of {} sampled states gave a real number; give the letters ranges in which both formulas have \
                 a value, as --where 'x=0.1..3' does",
                finding.points, finding.tried
            ),
        };
    }
    Ok(Comparison { finding, readings, assumed })
}

/// What is wrong with the units in two formulas.
fn units_differ(lhs: &Expr, rhs: &Expr, symbols: &Symbols) -> Option<String> {
    if ![lhs, rhs].into_iter().any(has_units) {
        return None;
    }
    let statement = Statement {
        members: vec![lhs.clone(), rhs.clone()],
        relations: vec![(Relation::Equal, Span::default())],
        conditions: Vec::new(),
        constant: None,
        branch: None,
        row: 0,
        span: Span::default(),
    };
    let mismatch = UnitCheck::new(symbols).statement(&statement).into_iter().next()?;
    Some(format!("the units do not fit: {}", mismatch.message))
}

/// Whether a symbol occurs in a formula.
fn has(formula: &Expr, symbol: SymbolId) -> bool {
    let mut found = false;
    formula.walk(&mut |expr| found |= matches!(expr.node, Node::Symbol { id, .. } if id == symbol));
    found
}

/// What to type for the two sides of an equation, and for two equations.
fn two_arguments(left: &str, right: &str) -> String {
    format!(
        "give the two sides as two arguments: onshell equal '{left}' '{right}'; to compare two equations, solve both for one \
         letter, and compare the results"
    )
}

/// The fault of a text that is an equation and not a formula: its two sides should be compared with each other.
fn two_sides(text: &str, macros: &Macros) -> Option<Fault> {
    let reading = read_display(text, &mut Symbols::open(), macros);
    // What cannot be read has its relation all the same.
    if reading.statements.iter().any(Result::is_err)
        && let [Some(at), None] = [text.find('='), text.split_once('=').and_then(|(_, rest)| rest.find('='))]
        && text[..at].matches('{').count() == text[..at].matches('}').count()
        && !text[..at].trim().is_empty()
    {
        let fault = Fault::new(Span::new(at, at + 1), "“=” makes this an equation, and a formula is needed");
        let (left, right) = (text[..at].trim(), text[at + 1..].trim());
        let advice = two_arguments(left, right);
        return Some(fault.code(Code::NotSupported).help(advice));
    }
    let statement = reading.statements.into_iter().flatten().find(|statement| !statement.relations.is_empty())?;
    let (relation, place) = statement.relations[0];
    let fault = Fault::new(place, format!("“{}” makes this an equation, and a formula is needed", relation.glyph()));
    let side = |at: usize| text.get(statement.members.get(at)?.span.range());
    let (left, right) = (side(0)?, side(1)?);
    let advice = two_arguments(left, right);
    Some(fault.code(Code::NotSupported).help(match relation {
        Relation::Approximately => format!("{advice}; ≈ can be checked only with a claims file"),
        _ => advice,
    }))
}
