//! Continua: bodies with a mass per length, per area or per volume.

use super::fields::{self, Fields, Text};
use crate::notes::json::{Json, Spanned, Value};
use crate::source::{Fault, Source};

/// A body with a density. Its name is the region of the integrals over it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Continuum {
    /// The region: the `V` of `\int_V`.
    pub name: Spanned<String>,
    /// 1, 2 or 3, for `mass per length`, `mass per area`, `mass per volume`.
    pub dimension: u8,
    /// The symbol of the density: the `\rho` of `\rho(\vec r)`.
    pub density: Spanned<String>,
    /// The point of the density: the `\vec r` of `\rho(\vec r)`.
    pub point: Spanned<String>,
    /// `particles`: the mass and the position of the pieces, if the body is divided into particles.
    pub particles: Option<(Spanned<String>, Spanned<String>)>,
    /// `uniform`: the density is the same everywhere.
    pub uniform: bool,
    /// `made of`: the shape of the body; empty for any shape.
    pub made_of: Vec<Solid>,
}

/// A simple body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Solid {
    /// Which.
    pub kind: Spanned<SolidKind>,
    /// Its size, in LaTeX: a length, or lengths with commas between them.
    pub size: Spanned<String>,
    /// `at`: the position of the centre; the origin by default.
    pub at: Option<Spanned<String>>,
    /// `hollow`: the body is removed from the others.
    pub hollow: bool,
}

/// The simple bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolidKind {
    /// `ball`: a radius.
    Ball,
    /// `box`: three edges.
    Box,
    /// `shell`: the surface of a ball; a radius.
    Shell,
    /// `rod`: a length.
    Rod,
    /// `lamina`: a flat rectangle; two edges.
    Lamina,
    /// `disc`: a radius.
    Disc,
}

impl SolidKind {
    /// The dimension of the body: 1 for a line, 2 for an area, 3 for a volume.
    pub fn dimension(self) -> u8 {
        match self {
            SolidKind::Ball | SolidKind::Box => 3,
            SolidKind::Shell | SolidKind::Lamina | SolidKind::Disc => 2,
            SolidKind::Rod => 1,
        }
    }

    /// The number of lengths in the size.
    fn lengths(self) -> usize {
        match self {
            SolidKind::Box => 3,
            SolidKind::Lamina => 2,
            SolidKind::Ball | SolidKind::Shell | SolidKind::Rod | SolidKind::Disc => 1,
        }
    }
}

const DENSITIES: &[&str] = &["mass per length", "mass per area", "mass per volume"];
const SOLIDS: &[(&str, SolidKind)] = &[
    ("ball", SolidKind::Ball),
    ("box", SolidKind::Box),
    ("shell", SolidKind::Shell),
    ("rod", SolidKind::Rod),
    ("lamina", SolidKind::Lamina),
    ("disc", SolidKind::Disc),
];
const KINDS: &[&str] = &["ball", "box", "shell", "rod", "lamina", "disc"];

/// Reads `continua`.
pub(super) fn continua(fields: &Fields<'_>, source: &Source) -> Result<Vec<Continuum>, Fault> {
    let Some(json) = fields.get("continua") else { return Ok(Vec::new()) };
    fields::object(json, "\"continua\"")?.iter().map(|(name, json)| continuum(name, json, source)).collect()
}

fn continuum(name: &Text, json: &Json, source: &Source) -> Result<Continuum, Fault> {
    let fields = Fields::new(json, "a continuum", &[DENSITIES, &["particles", "uniform", "made of"]], &[])?;
    let [name] = <[Text; 1]>::try_from(fields::names(name, source)?).map_err(|_| {
        Fault::claims(name.span, "this key must be one name, that of one continuum")
            .help("write one line for each continuum")
    })?;
    let mut densities = (1..).zip(DENSITIES).filter_map(|(dimension, key)| Some((dimension, fields.entry(key)?)));
    let Some((dimension, (key, value))) = densities.next() else {
        return Err(Fault::claims(json.span, format!("the density of {} is missing", name.value))
            .help("add \"mass per length\", \"mass per area\" or \"mass per volume\""));
    };
    if let Some((_, (second, _))) = densities.next() {
        let message = format!("\"{}\" and \"{}\" cannot both be given for one continuum", key.value, second.value);
        return Err(Fault::claims(second.span, message).help("keep one of them"));
    }
    let (density, point) = density(&fields::text(value, &key.value)?, source)?;
    let particles = fields.text("particles")?.map(|written| particles(&written, source)).transpose()?;
    let uniform = fields.on("uniform")?.is_some();
    let made_of = match fields.get("made of") {
        None => Vec::new(),
        Some(Json { value: Value::Array(items), .. }) if !items.is_empty() => {
            items.iter().map(|item| solid(item, dimension, &key.value, source)).collect::<Result<_, _>>()?
        }
        Some(json) => return Err(fields::wrong(json, "made of", "a list of bodies")),
    };
    Ok(Continuum { name, dimension, density, point, particles, uniform, made_of })
}

/// `\rho(\vec r)`: the symbol and the point.
fn density(written: &Text, source: &Source) -> Result<(Text, Text), Fault> {
    let text = written.value.trim_end();
    let parts = text.strip_suffix(')').and_then(|inside| Some((text.find('(')?, inside.len())));
    let pieces = parts.map(|(open, close)| {
        (fields::piece(written, 0..open, source), fields::piece(written, open + 1..close, source))
    });
    match pieces {
        Some((density, point)) if !density.value.is_empty() && !point.value.is_empty() => Ok((density, point)),
        _ => Err(Fault::claims(
            written.span,
            format!("\"{text}\" does not name the density and the point where it is taken"),
        )
        .help("write, for example, \"\\\\rho(\\\\vec r)\"")),
    }
}

/// `m_i at \vec r_i`: the mass and the position of a piece.
fn particles(written: &Text, source: &Source) -> Result<(Text, Text), Fault> {
    let text = &written.value;
    let pieces = text.find(" at ").map(|at| {
        (fields::piece(written, 0..at, source), fields::piece(written, at + " at ".len()..text.len(), source))
    });
    match pieces {
        Some((mass, position)) if !mass.value.is_empty() && !position.value.is_empty() => Ok((mass, position)),
        _ => Err(Fault::claims(written.span, format!("\"{text}\" does not name a mass and its position"))
            .help("write, for example, \"m_i at \\\\vec r_i\"")),
    }
}

fn solid(json: &Json, dimension: u8, per: &str, source: &Source) -> Result<Solid, Fault> {
    let fields = Fields::new(json, "a body", &[KINDS, &["at", "hollow"]], &[])?;
    let mut kinds = SOLIDS.iter().filter_map(|(key, kind)| Some((*kind, fields.entry(key)?)));
    let Some((kind, (key, value))) = kinds.next() else {
        return Err(Fault::claims(json.span, "the shape of this body is missing")
            .help("add \"ball\", \"box\", \"shell\", \"rod\", \"lamina\" or \"disc\", with its size"));
    };
    if let Some((_, (second, _))) = kinds.next() {
        let message = format!("\"{}\" and \"{}\" cannot both be given: a body has one shape", key.value, second.value);
        return Err(Fault::claims(second.span, message).help("write one { … } for each body under \"made of\""));
    }
    if kind.dimension() != dimension {
        let fitting = SOLIDS.iter().filter(|(_, kind)| kind.dimension() == dimension);
        let fitting = fitting.map(|(key, _)| format!("\"{key}\"")).collect::<Vec<_>>().join(" or ");
        return Err(Fault::claims(key.span, format!("\"{}\" does not fit \"{per}\"", key.value))
            .help(format!("with \"{per}\", use {fitting}")));
    }
    let size = fields::text(value, &key.value)?;
    let (lengths, needed) = (fields::names(&size, source)?.len(), kind.lengths());
    if lengths != needed {
        let help = match needed {
            1 => "write one length, as in \"R\"",
            2 => "write two edges, as in \"a, b\"",
            _ => "write three edges, as in \"a, b, c\"",
        };
        return Err(
            Fault::claims(size.span, format!("the size of a {} cannot be {lengths} lengths", key.value)).help(help)
        );
    }
    let kind = Spanned::new(kind, key.span);
    Ok(Solid { kind, size, at: fields.text("at")?, hollow: fields.on("hollow")?.is_some() })
}
