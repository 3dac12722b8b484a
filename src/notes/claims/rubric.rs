//! `rubric`: what a teacher wants to see in a hand-in, and what it is worth.

use crate::notes::address::Address;
use crate::notes::json::{Json, Value};
use crate::source::{Fault, Source};

use super::fields::{self, Fields, Text};
use super::{Spanned, fields::wrong};

/// What is wanted, and what it is worth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rubric {
    /// `results`: the wanted results in order.
    pub results: Vec<Wanted>,
    /// `half for`: the kinds of slip with which a result still earns half of its points.
    pub half_for: Vec<Lost>,
    /// `without steps`: the share of the points for results that stand there without any step.
    pub without_steps: Option<Share>,
    /// `letters`: a name of the notes, and names that hand-ins use for it.
    pub letters: Vec<(Text, Vec<Text>)>,
}

/// A wanted result.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// The equation of the notes.
    pub address: Address,
    /// What it is worth.
    pub points: f64,
    /// What it is called.
    pub name: Option<String>,
}

/// A kind of slip that a rubric names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lost {
    /// A sign.
    Sign,
    /// A factor or a number.
    Factor,
    /// A power.
    Power,
    /// A sine for a cosine.
    Function,
    /// One symbol or index for another.
    Symbol,
    /// A dot.
    Dot,
    /// A term.
    Term,
}

/// A share of the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// All of them.
    Full,
    /// Half of them.
    Half,
    /// None.
    None,
}

impl Lost {
    /// Every kind with its word.
    pub const WORDS: &'static [(&'static str, Lost)] = &[
        ("sign", Lost::Sign),
        ("factor", Lost::Factor),
        ("power", Lost::Power),
        ("function", Lost::Function),
        ("symbol", Lost::Symbol),
        ("dot", Lost::Dot),
        ("term", Lost::Term),
    ];
}

impl Share {
    /// As a number.
    pub fn value(self) -> f64 {
        match self {
            Share::Full => 1.0,
            Share::Half => 0.5,
            Share::None => 0.0,
        }
    }
}

/// Reads the key `rubric`.
pub(super) fn rubric(of: &Fields<'_>, source: &Source) -> Result<Option<Rubric>, Fault> {
    let Some(json) = of.get("rubric") else { return Ok(None) };
    let fields = Fields::new(json, "\"rubric\"", &[&["results", "half for", "without steps", "letters"]], &[])?;
    let mut results = Vec::new();
    if let Some(json) = fields.get("results") {
        for (key, value) in fields::object(json, "\"results\"")? {
            results.push(wanted(key, value, source)?);
        }
    }
    let half_for = fields.texts("half for")?;
    let half_for = half_for.iter().map(|text| Ok(fields::word(text, "half for", Lost::WORDS)?.value));
    let shares = &[("full", Share::Full), ("half", Share::Half), ("none", Share::None)];
    let without_steps = fields.text("without steps")?;
    let without_steps = without_steps.map(|text| fields::word(&text, "without steps", shares)).transpose()?;
    let mut letters = Vec::new();
    for (key, value) in fields.pairs("letters")? {
        letters.push((key, fields::names(&value, source)?));
    }
    Ok(Some(Rubric {
        results,
        half_for: half_for.collect::<Result<_, Fault>>()?,
        without_steps: without_steps.map(|share| share.value),
        letters,
    }))
}

fn wanted(key: &Text, value: &Json, source: &Source) -> Result<Wanted, Fault> {
    let address = Address::parse(key, source)?;
    let points = |json: &Json| match &json.value {
        Value::Number(raw) => match raw.parse::<f64>() {
            Ok(points) if points.is_finite() && points >= 0.0 => Ok(points),
            _ => Err(Fault::claims(json.span, "points are a number, 0 or more")),
        },
        _ => Err(wrong(json, &key.value, "a number of points, or an object with \"points\" and \"name\"")),
    };
    let Value::Object(_) = &value.value else { return Ok(Wanted { address, points: points(value)?, name: None }) };
    let fields = Fields::new(value, "a wanted result", &[&["points", "name"]], &[])?;
    let name = fields.text("name")?.map(|Spanned { value, .. }| value);
    let points = fields.get("points").map_or(Ok(1.0), points)?;
    Ok(Wanted { address, points, name })
}
