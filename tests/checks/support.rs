//! Documents in strings.

use std::path::Path;
use std::sync::Arc;

use onshell::Source;
use onshell::check::{Document, Equation, Finding, Options, Verdict, check_document};
use onshell::notes::Kind;
use onshell::notes::{Claims, Notes};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

/// The claims of a document about a plane pendulum, to be completed.
pub fn pendulum() -> Json {
    json!({
        "system": "simple_pendulum",
        "coordinates": { r"\theta": "angle" },
        "constants": { "m, l, g": "> 0" },
        "means": { "L": "Lagrangian", "T": "kinetic energy", "U": "potential energy", "E": "energy" },
    })
}

/// The claims of a document about a planet, to be completed.
pub fn planet() -> Json {
    json!({
        "system": "kepler",
        "coordinates": { "r": "> 0", r"\phi": "angle" },
        "constants": { "m, G, M": "> 0" },
    })
}

/// The claims of a document about the heavy symmetric top, to be completed.
pub fn top() -> Json {
    json!({
        "system": "heavy_top",
        "coordinates": { r"\theta": "(0, \\pi)", r"\phi, \psi": "angle" },
        "constants": { r"M, g, R, \lambda_1, \lambda_3": "> 0" },
        "means": { "L": "Lagrangian", "T": "kinetic energy", "U": "potential energy", "H": "Hamiltonian" },
        "define": { r"\Omega": r"\dot\phi", r"\omega_3": r"p_\psi/\lambda_3" },
    })
}

/// The claims of a document about numbers alone, to be completed.
pub fn numbers() -> Json {
    json!({ "constants": { "a, b, c": "> 0", "x": "any" } })
}

/// The same claims with a key more, or another value for it.
pub fn with(claims: &Json, key: &str, value: Json) -> Json {
    let mut claims = claims.clone();
    claims[key] = value;
    claims
}

/// A claim that holds under these hypotheses, of which there may be none.
pub fn assuming(hypotheses: &[&str]) -> Json {
    if hypotheses.is_empty() { json!({}) } else { json!({ "assume": hypotheses }) }
}

/// Notes in which each of these displays has its place in the list, from 1, as its number.
pub fn numbered(displays: &[&str]) -> String {
    let display = |(at, latex): (usize, &&str)| format!("$$\n{latex}\n\\tag{{{}}}\n$$\n\n", at + 1);
    displays.iter().enumerate().map(display).collect()
}

/// Checks notes against claims, with the systems of a registry.
pub fn document(claims: &Json, notes: &str, registry: &Registry, only: Option<&str>) -> onshell::Result<Document> {
    seeded(1, claims, notes, registry, only)
}

/// The same at states of this seed.
pub fn seeded(
    seed: u64,
    claims: &Json,
    notes: &str,
    registry: &Registry,
    only: Option<&str>,
) -> onshell::Result<Document> {
    let claims = with(claims, "notes", json!("notes.md"));
    let claims = Arc::new(Source::new("claims.json", format!("{claims:#}")));
    let claims = Claims::parse(claims, Path::new("claims.json"))?;
    let notes = Notes::parse(Arc::new(Source::new("notes.md", notes)), Kind::Markdown)?;
    let mut options = Options::default();
    options.seed = seed;
    check_document(&claims, &notes, registry, options, only)
}

/// The last of these displays, checked under a claim of its own.
pub fn equation(claims: &Json, displays: &[&str], claim: Json) -> Equation {
    let id = displays.len().to_string();
    let claims = with(claims, "equations", json!({ id.as_str(): claim }));
    let found = document(&claims, &numbered(displays), &Registry::standard(), Some(&id));
    found.unwrap_or_else(|error| panic!("{displays:?}: {error}")).equations.remove(0)
}

/// What is said of a claim, however it was decided: what the field confirms is `Verified` too.
pub fn outcome(finding: &Finding) -> Verdict {
    if finding.verdict.holds() { Verdict::Verified } else { finding.verdict }
}

/// What is said of the last of these displays, however it was decided.
pub fn verdict(claims: &Json, displays: &[&str], claim: Json) -> Verdict {
    outcome(&equation(claims, displays, claim).finding)
}

/// The error in checking it.
pub fn error(claims: &Json, displays: &[&str], claim: Json) -> String {
    let id = displays.len().to_string();
    let claims = with(claims, "equations", json!({ id.as_str(): claim }));
    match document(&claims, &numbered(displays), &Registry::standard(), None) {
        Ok(document) => panic!("no error: {:?}", document.equations),
        Err(error) => error.to_string(),
    }
}
