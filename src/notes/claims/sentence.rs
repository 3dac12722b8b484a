//! The claim about a sentence of the prose.

use super::claim::{self, Claim};
use super::fields::{self, Fields, Text};
use crate::notes::address::Address;
use crate::notes::json::{Json, Spanned};
use crate::source::{Fault, Source};

/// A sentence of the notes with its claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Sentence {
    /// `name`: its name in a report.
    pub name: Option<Spanned<String>>,
    /// `quote`: the sentence, word for word.
    pub quote: Spanned<String>,
    /// `in`: the equation whose declarations and hypotheses it uses.
    pub scope: Option<Address>,
    /// The test.
    pub test: Test,
    /// `against`: the variable of a limit, a minimum or a slope.
    pub against: Option<Spanned<String>>,
    /// The keys that it shares with the claim about an equation.
    pub claim: Claim,
}

/// The test that a sentence states.
#[derive(Clone, Debug, PartialEq)]
pub enum Test {
    /// The quoted formula itself.
    Quoted,
    /// `claim`: this LaTeX.
    Claim(Spanned<String>),
    /// `not always`: this LaTeX has a counterexample.
    NotAlways(Spanned<String>),
    /// `conserved`: this LaTeX does not change with time.
    Conserved(Spanned<String>),
    /// `of`: a property of an expression.
    Of(Spanned<String>, Property),
    /// `solutions` n `of` an equation `for` an unknown.
    Solutions {
        /// Their number.
        count: Spanned<usize>,
        /// The equation.
        of: Address,
        /// The unknown.
        unknown: Spanned<String>,
    },
    /// `refers to`: the sentence cites an equation that must contain this formula.
    RefersTo {
        /// The number that it cites.
        number: Spanned<String>,
        /// `containing`: the LaTeX that the equation must contain.
        containing: Spanned<String>,
    },
}

/// A property of an expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Property {
    /// `independent of`: these symbols.
    IndependentOf(Vec<Spanned<String>>),
    /// `sign`
    Sign(Spanned<Sign>),
    /// `minima`: their number in the interior of the range.
    Minima(Spanned<usize>),
    /// `maxima`: their number in the interior of the range.
    Maxima(Spanned<usize>),
    /// `tends to`: limits and the values there.
    TendsTo(Vec<(Spanned<String>, Spanned<String>)>),
    /// `rises with`
    RisesWith(Spanned<String>),
    /// `falls with`
    FallsWith(Spanned<String>),
}

/// The sign of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Positive everywhere.
    Positive,
    /// Negative everywhere.
    Negative,
    /// Both signs occur.
    Changes,
}

pub(super) const KEYS: &[&str] =
    &["name", "quote", "in", "against", "claim", "not always", "of", "refers to", "containing"];
/// Keys that need `of`.
pub(super) const OF: &[&str] =
    &["independent of", "sign", "minima", "maxima", "tends to", "rises with", "falls with", "solutions"];

/// Reads a sentence.
pub(super) fn sentence(json: &Json, source: &Source) -> Result<Sentence, Fault> {
    let fields = Fields::new(json, "a sentence", &[KEYS, OF, claim::KEYS], claim::LATER)?;
    if let Some((key, _)) = fields.entry("solves") {
        return Err(Fault::claims(key.span, "\"solves\" is allowed for an equation only")
            .help("in a sentence, use \"solutions\", \"of\" and \"for\""));
    }
    let missing = || {
        Fault::claims(json.span, "a sentence needs \"quote\"")
            .help("write the sentence of the notes under \"quote\", word for word")
    };
    let quote = fields.text("quote")?.ok_or_else(missing)?;
    let test = test(&fields, source)?;
    // `conserved` is the test itself here, not a word on the quoted formula.
    let mut claim = claim::shared(&fields, source)?;
    if matches!(test, Test::Conserved(_)) {
        claim.conserved = None;
    }
    let scope = fields.text("in")?.map(|scope| Address::parse(&scope, source)).transpose()?;
    Ok(Sentence { name: fields.text("name")?, quote, scope, test, against: fields.text("against")?, claim })
}

fn test(fields: &Fields<'_>, source: &Source) -> Result<Test, Fault> {
    fields.together(
        "refers to",
        "containing",
        "write the number under \"refers to\", and a formula that this equation must contain under \"containing\"",
    )?;
    let tests = ["claim", "not always", "conserved", "of", "refers to"];
    let mut present = tests.iter().filter_map(|name| fields.entry(name));
    let first = present.next();
    if let (Some((first, _)), Some((second, _))) = (first, present.next()) {
        let message =
            format!("\"{}\" and \"{}\" cannot both be given: a sentence has one test", first.value, second.value);
        return Err(Fault::claims(second.span, message)
            .help("write the second test in an entry of its own, with the same quote"));
    }
    if first.is_none_or(|(key, _)| key.value != "of")
        && let Some((key, _)) = OF.iter().find_map(|name| fields.entry(name))
    {
        return Err(Fault::claims(key.span, format!("\"{}\" needs \"of\" beside it", key.value))
            .help("write the expression under \"of\""));
    }
    if fields.get("solutions").is_none()
        && let Some((key, _)) = fields.entry("for")
    {
        return Err(Fault::claims(key.span, "\"for\" needs \"solutions\" beside it")
            .help("write the number of solutions under \"solutions\""));
    }
    let Some((key, json)) = first else { return Ok(Test::Quoted) };
    match key.value.as_str() {
        "claim" => Ok(Test::Claim(fields::text(json, "claim")?)),
        "not always" => Ok(Test::NotAlways(fields::text(json, "not always")?)),
        "conserved" => Ok(Test::Conserved(fields::text(json, "conserved")?)),
        "refers to" => {
            let number = fields::text(json, "refers to")?;
            let Some(containing) = fields.text("containing")? else { return Ok(Test::Quoted) };
            Ok(Test::RefersTo { number, containing })
        }
        _ => of(fields, key, fields::text(json, "of")?, source),
    }
}

fn of(fields: &Fields<'_>, key: &Text, of: Text, source: &Source) -> Result<Test, Fault> {
    let mut present = OF.iter().filter_map(|name| fields.entry(name));
    let list = || OF.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ");
    let Some((property, json)) = present.next() else {
        return Err(Fault::claims(key.span, "this sentence says nothing about the expression under \"of\"")
            .help(format!("add one of {}", list())));
    };
    if let Some((second, _)) = present.next() {
        let message =
            format!("\"{}\" and \"{}\" cannot both be given: a sentence has one test", property.value, second.value);
        return Err(Fault::claims(second.span, message)
            .help("write the second test in an entry of its own, with the same quote"));
    }
    let name = property.value.as_str();
    let text = || fields::text(json, name);
    let property = match name {
        "independent of" => Property::IndependentOf(fields::texts(json, name)?),
        "sign" => {
            let signs = &[("positive", Sign::Positive), ("negative", Sign::Negative), ("changes", Sign::Changes)];
            Property::Sign(fields::word(&text()?, name, signs)?)
        }
        "minima" => Property::Minima(fields::count(json, name)?),
        "maxima" => Property::Maxima(fields::count(json, name)?),
        "rises with" => Property::RisesWith(text()?),
        "falls with" => Property::FallsWith(text()?),
        "tends to" => Property::TendsTo(tends_to(fields, json)?),
        _ => {
            let count = fields::count(json, name)?;
            let Some(unknown) = fields.text("for")? else {
                return Err(Fault::claims(property.span, "\"solutions\" needs \"for\" beside it")
                    .help("write the unknown under \"for\""));
            };
            return Ok(Test::Solutions { count, of: Address::parse(&of, source)?, unknown });
        }
    };
    Ok(Test::Of(of, property))
}

fn tends_to(fields: &Fields<'_>, json: &Json) -> Result<Vec<(Text, Text)>, Fault> {
    let limits = fields.pairs("tends to")?;
    if limits.is_empty() {
        return Err(Fault::claims(json.span, "\"tends to\" is empty")
            .help("write a limit and its value, as in { \"x \\\\to 0\": \"1\" }"));
    }
    match limits.iter().find(|(limit, _)| !claim::is_limit(&limit.value)) {
        Some((limit, _)) => Err(Fault::claims(limit.span, format!("\"{}\" is not a limit", limit.value))
            .help("write a limit as in \"x \\\\to 0\"")),
        None => Ok(limits),
    }
}
