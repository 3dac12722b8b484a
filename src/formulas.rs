//! Formulas without a document: read one, evaluate it, compare two.
//!
//! Every letter is a real number, a dotted letter too, and `t` is the time. What can be read in two ways is an error.

use std::fmt;
use std::sync::Arc;

use crate::check::Options;
use crate::check::kinds::compare::{self, Comparison};
use crate::code::Code;
use crate::formula::tree::Function;
use crate::formula::units::in_si::{has_units, in_si};
use crate::formula::units::{Affine, Dimension, UnitCheck};
use crate::formula::{Assignment, Expr, Kind, Node, Statement, Symbols, Unavailable, Value, evaluate, text};
#[cfg(feature = "cli")]
use crate::latex::read_formula;
use crate::latex::{Macros, names, read_display};
use crate::notes::claims::Range;
use crate::scalar::Number;
#[cfg(feature = "cli")]
use crate::scalar::RunningError;
use crate::source::{Fault, Source, Span};
use crate::{Error, Result};

/// The number of roundings that an error of one magnitude stands for.
#[cfg(feature = "cli")]
const ROUNDINGS: f64 = 4.0;

/// The name under which the text of a formula stands in errors.
const PATH: &str = "formula";

/// A formula or an equation, as it was read from LaTeX.
///
/// ```
/// use onshell::Formula;
///
/// let energy = Formula::read(r"\frac12 m \dot x^2 + \frac12 k x^2")?;
/// assert_eq!(energy.to_string(), "(1/2)·m·x\u{307}^2 + (1/2)·k·x^2");
/// let value = energy.value(&[("m", 2.0), ("k", 8.0), (r"\dot x", 3.0), ("x", 0.5)])?;
/// assert_eq!(value, 10.0);
///
/// // A formula that people read in two ways is rejected, with the place and a way out.
/// let error = Formula::read(r"\cos\theta p_\psi").unwrap_err();
/// assert_eq!(error.code(), onshell::Code::Ambiguous);
/// # Ok::<(), onshell::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Formula {
    statement: Statement,
    symbols: Arc<Symbols>,
}

impl Formula {
    /// Reads a formula, or one equation.
    ///
    /// # Errors
    /// For LaTeX that is malformed, not supported or ambiguous, at its place in the text; for several statements.
    pub fn read(latex: &str) -> Result<Formula> {
        let mut statements = Formula::read_all(latex)?.into_iter();
        match (statements.next(), statements.next()) {
            (Some(formula), None) => Ok(formula),
            _ => Err(Error::new("this text must be one formula or one equation").help("give one statement at a time")),
        }
    }

    /// Reads a formula that has a value, with the integrals in it computed.
    #[cfg(feature = "cli")]
    pub(crate) fn read_value(latex: &str) -> Result<Formula> {
        let mut symbols = Symbols::open();
        match read_formula(latex, &mut symbols, &Macros::default()) {
            Ok(formula) => {
                let statement = Statement {
                    span: formula.span,
                    members: vec![formula],
                    relations: Vec::new(),
                    conditions: Vec::new(),
                    constant: None,
                    branch: None,
                    row: 0,
                };
                Ok(Formula { statement, symbols: Arc::new(symbols) })
            }
            // What is wrong is said of the text as it is read elsewhere.
            Err(_) => Formula::read(latex),
        }
    }

    /// Reads all statements of a display: `a = b, \quad c = d` are two.
    ///
    /// # Errors
    /// As [`Formula::read`], for the first statement that cannot be read.
    pub fn read_all(latex: &str) -> Result<Vec<Formula>> {
        let source = Arc::new(Source::new(PATH, latex));
        if latex.trim().is_empty() {
            return Err(Error::at(&source, Span::at(0), "the formula is missing").with_code(Code::Syntax));
        }
        let mut symbols = Symbols::open();
        let reading = read_display(latex, &mut symbols, &Macros::default());
        let symbols = Arc::new(symbols);
        let formula = |statement| Formula { statement, symbols: symbols.clone() };
        let read = reading.statements.into_iter().map(|found| found.map(formula));
        read.map(|found| found.map_err(|fault| Error::fault(&source, fault))).collect()
    }

    /// The letters that need a value, as LaTeX, in the order in which they occur: `x` and `\dot x` are two.
    pub fn letters(&self) -> Vec<String> {
        let mut letters = Vec::new();
        for member in &self.statement.members {
            member.walk(&mut |expr| {
                if let Node::Symbol { .. } = &expr.node {
                    let letter = crate::latex::typeset(expr, &self.symbols);
                    if !letters.contains(&letter) {
                        letters.push(letter);
                    }
                }
            });
        }
        letters
    }

    /// The members of a chain `a = b = c`, one by one; of a formula without a relation, the formula itself.
    pub fn members(&self) -> Vec<Formula> {
        let alone = |member: &Expr| Formula {
            statement: Statement { members: vec![member.clone()], relations: Vec::new(), ..self.statement.clone() },
            symbols: self.symbols.clone(),
        };
        self.statement.members.iter().map(alone).collect()
    }

    /// The value of a formula, in units of the SI where units stand in it; each letter needs a value, and each dotted letter one of its own: `(r"\dot x", 0.83)`.
    ///
    /// # Errors
    /// For a letter without a value, a name that does not occur, an equation, a vector, a point outside the domain.
    pub fn value(&self, values: &[(&str, f64)]) -> Result<f64> {
        match self.entries(values)?.as_slice() {
            [value] => Ok(*value),
            _ => Err(Error::new("the formula is a vector or a matrix, not a number").help("evaluate one component")),
        }
    }

    /// The unit of the SI of a formula with units in it, such as `kg m² s⁻²`; `None` where it has none, or depends on letters.
    ///
    /// # Errors
    /// For terms that do not fit.
    pub fn unit(&self) -> Result<Option<String>> {
        let [formula] = self.statement.members.as_slice() else { return Ok(None) };
        if !has_units(formula) {
            return Ok(None);
        }
        let mut check = UnitCheck::new(&self.symbols);
        let found = check.dimension(formula).map_err(|mismatch| {
            Error::new(format!("the units do not fit: {}", mismatch.message)).with_code(Code::UnitMismatch)
        })?;
        let known = found.filter(|found| formula.symbols().is_empty() && *found != Affine::known(Dimension::NONE));
        Ok(known.map(|found| check.words(&found)))
    }

    /// The entries of the formula's value: one of a number, three of a vector, those of a matrix row by row.
    ///
    /// # Errors
    /// As [`Formula::value`].
    pub(crate) fn entries(&self, values: &[(&str, f64)]) -> Result<Vec<f64>> {
        let (entries, what) = self.evaluated::<f64>(values)?;
        match entries.iter().find(|entry| !entry.is_finite()) {
            None => Ok(entries),
            Some(_) if self.has_singular_matrix() => Err(Error::new("a matrix in the formula has the determinant 0")
                .help("such a matrix has no inverse, so the formula has no value")),
            Some(_) if self.letters().is_empty() && self.is_too_large() => {
                Err(Error::new(format!("{what} is too large to compute with, or a part of it is"))
                    .help("the largest number is about 10^{308}; choose other units, or compute with logarithms"))
            }
            Some(_) if self.letters().is_empty() => Err(Error::new(format!("{what} has no real value"))
                .help("check that no denominator is 0, and that no root or logarithm is of a negative number")),
            Some(entry) if entry.is_nan() => {
                Err(Error::new(format!("{what} has no real value at this point, like the root of a negative number"))
                    .help("choose values at which every root, logarithm and quotient in it is a real number"))
            }
            Some(_) => Err(Error::new(format!(
                "{what} has no real value at this point: it is infinite, or too large to compute with"
            ))
            .help("choose other values: no denominator may be 0")),
        }
    }

    /// Whether a part of a formula without letters is infinite, though it has a value: its operands are finite, and no denominator is 0.
    fn is_too_large(&self) -> bool {
        let value = |part: &Expr| {
            let statement = Statement { members: vec![part.clone()], relations: Vec::new(), ..self.statement.clone() };
            let (entries, _) = Formula { statement, symbols: self.symbols.clone() }.evaluated::<f64>(&[]).ok()?;
            entries.first().copied()
        };
        let is_finite = |part: &Expr| value(part).is_some_and(f64::is_finite);
        let is_not_zero = |part: &Expr| value(part).is_some_and(|value| value.is_finite() && value != 0.0);
        let mut found = false;
        for member in &self.statement.members {
            member.walk(&mut |part| {
                found |= match &part.node {
                    Node::Product(factors) => factors.iter().all(is_finite),
                    Node::Quotient(above, below) => is_finite(above) && is_not_zero(below),
                    Node::Power(base, exponent) => is_not_zero(base) && is_finite(exponent),
                    Node::Call(Function::Exp | Function::Sinh | Function::Cosh, argument) => is_finite(argument),
                    _ => false,
                } && value(part).is_some_and(f64::is_infinite);
            });
        }
        found
    }

    /// The entries of the formula's value, each with a bound of its rounding error.
    ///
    /// # Errors
    /// As [`Formula::value`].
    #[cfg(feature = "cli")]
    pub(crate) fn entries_with_errors(&self, values: &[(&str, f64)]) -> Result<Vec<(f64, f64)>> {
        let (sizes, _) = self.evaluated::<RunningError>(values)?;
        let error = |value: f64, size: &RunningError| {
            let magnitude = if size.magnitude.is_finite() { size.magnitude } else { value.abs() };
            (value, ROUNDINGS * f64::EPSILON * magnitude)
        };
        Ok(self.entries(values)?.into_iter().zip(&sizes).map(|(value, size)| error(value, size)).collect())
    }

    /// Whether the formula has no letters, and an inverse of a matrix that is written out.
    fn has_singular_matrix(&self) -> bool {
        let mut found = false;
        self.statement.members.iter().for_each(|member| {
            member.walk(&mut |expr| {
                found |= matches!(&expr.node, Node::Inverse(of) if matches!(of.node, Node::Matrix(_)))
            });
        });
        found
    }

    /// That all letters are numbers, and all functions have a formula.
    fn has_only_numbers(&self, formula: &Expr) -> Result<()> {
        let mut found = None;
        formula.walk(&mut |expr| {
            let error = match &expr.node {
                Node::Symbol { id, .. } if self.symbols.entry(*id).kind == Kind::Vector => {
                    let name = self.symbols.entry(*id).name.to_string();
                    Some(
                        Error::new(format!("{} is a vector, and --set gives numbers only", text::plain(&name)))
                            .help("write its components, as in v_x^2 + v_y^2 + v_z^2"),
                    )
                }
                Node::Apply(id, _) => {
                    let name = text::plain(&self.symbols.entry(*id).name.to_string()).replace('\u{2061}', "");
                    Some(
                        Error::new(format!("{name} has no formula, so {name}(…) has no value"))
                            .help(format!("write the formula of {name} in place of {name}(…)")),
                    )
                }
                _ => None,
            };
            if found.is_none() {
                found = error;
            }
        });
        found.map_or(Ok(()), Err)
    }

    /// The entries of the formula's value over any number, and what each of them is called.
    fn evaluated<B: Number>(&self, values: &[(&str, f64)]) -> Result<(Vec<B>, &'static str)> {
        let [formula] = self.statement.members.as_slice() else {
            return Err(Error::new("an equation has no value").help("evaluate one of its sides"));
        };
        self.unit()?;
        let mut formula = formula.clone();
        in_si(&mut formula);
        self.has_only_numbers(&formula)?;
        let mut state = Assignment::<B>::new(&self.symbols);
        let mut known = Vec::new();
        for (name, value) in values {
            let parsed = names::parse(name);
            let found = parsed.and_then(|(name, dots)| self.symbols.find(&name).map(|(id, _)| (id, dots)));
            let Some((id, dots)) = found else {
                let letters = self.letters();
                let help = match letters.is_empty() {
                    true => "the formula has no letters, so leave --set out".to_owned(),
                    false => format!("its letters are {}", letters.join(", ")),
                };
                let message = match names::parse(name).is_some_and(|(name, _)| name.base == "\\pi") {
                    true => "the value of π is fixed and cannot be set".to_owned(),
                    false => format!("{} is not a letter of the formula", text::plain(name)),
                };
                return Err(Error::new(message).help(help));
            };
            if known.contains(&(id, dots)) {
                return Err(Error::new(format!("{} is set twice", text::plain(name))).help("set it once"));
            }
            state.set(id, dots, B::from(*value));
            known.push((id, dots));
        }
        let is_set = |letter: &String| {
            let named = names::parse(letter);
            named
                .is_some_and(|(name, dots)| self.symbols.find(&name).is_some_and(|(id, _)| known.contains(&(id, dots))))
        };
        let missing: Vec<String> = self.letters().into_iter().filter(|letter| !is_set(letter)).collect();
        if !missing.is_empty() {
            let settings: Vec<String> = missing.iter().map(|name| format!("--set '{name}=…'")).collect();
            return Err(Error::new(format!("there is no value for {}", missing.join(", ")))
                .help(format!("add {}", settings.join(" "))));
        }
        let value = evaluate(&formula, &state, &[]).map_err(|reason| match reason {
            Unavailable::Derivative(_) => Error::new("the formula needs the value of a time derivative")
                .help("set the dotted symbols too: --set '\\dot x=…'"),
            Unavailable::Operation(what) => Error::new(format!("the formula has no value, because it contains {what}"))
                .help("evaluate a part of the formula that does not contain this"),
            Unavailable::Symbol(id) => {
                Error::new(format!("{} has no value", text::plain(&self.symbols.entry(id).name.to_string())))
                    .help("evaluate a part of the formula that does not contain this")
            }
        })?;
        Ok(match value {
            Value::Scalar(value) => (vec![value.value()], "the formula"),
            other => (other.entries().iter().map(|x| x.value()).collect(), "an entry of the formula"),
        })
    }
}

impl fmt::Display for Formula {
    /// The reading in plain text, with every product written out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&text::statement(&self.statement, &self.symbols))
    }
}

/// Compares two formulas for all real values of their letters, or for those in `ranges`, whose ends belong to them.
///
/// ```
/// use onshell::check::Verdict;
/// use onshell::{Options, compare};
///
/// let found = compare(r"\sin 2x", r"2\sin x\cos x", &[], Options::default())?;
/// assert_eq!(found.finding.verdict, Verdict::Certified);
///
/// // √(y²) is |y|: at a negative y the two differ, and the finding says where.
/// let found = compare(r"\sqrt{y^2}", "y", &[], Options::default())?;
/// assert_eq!(found.finding.verdict, Verdict::Refuted);
/// assert!(found.finding.counterexample.unwrap().state[0].1 < 0.0);
///
/// // For positive y they are equal.
/// let found = compare(r"\sqrt{y^2}", "y", &[("y", 0.1..=3.0)], Options::default())?;
/// assert!(found.finding.verdict.passes());
/// # Ok::<(), onshell::Error>(())
/// ```
///
/// # Errors
/// When one of the two cannot be read, at its place; when a range is empty or for a letter that is in neither.
pub fn compare(
    left: &str,
    right: &str,
    ranges: &[(&str, std::ops::RangeInclusive<f64>)],
    options: Options,
) -> Result<Comparison> {
    let mut given = Vec::new();
    for (name, range) in ranges {
        let (low, high) = (*range.start(), *range.end());
        let letter = names::parse(name).filter(|(_, dots)| *dots == 0).map(|(letter, _)| letter);
        match letter {
            Some(letter) if low.is_finite() && high.is_finite() && low < high => {
                given.push((letter, Range::Interval { low, high, low_open: false, high_open: false }));
            }
            _ => {
                return Err(Error::new(format!("{low}..{high} is not a range for {name}"))
                    .help("a range has a letter without dots and two finite ends, the lower one first"));
            }
        }
    }
    let placed = |(which, fault): (usize, Fault)| match which {
        0 => Error::fault(&Arc::new(Source::new("left formula", left)), fault),
        1 => Error::fault(&Arc::new(Source::new("right formula", right)), fault),
        _ => Error::new(fault.message)
            .help(fault.help.unwrap_or("give a range only to a letter of the two formulas".to_owned())),
    };
    compare::equal(left, right, &given, options).map_err(placed)
}
