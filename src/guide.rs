//! The pages of the manual: the claims file, notation, words, how onshell works, and its figures.
//!
//! They are the files of `docs/`. A link between pages is a reference there, and leads to the module here.

/// The claims file: every key, and the report as JSON.
///
/// [notation]: notation
/// [notation-indices]: notation#indices
/// [glossary]: glossary
/// [glossary-verdicts]: glossary#verdicts
/// [teaching]: teaching
/// [teaching-rubric]: teaching#the-rubric
#[cfg_attr(doc, doc = include_str!("../docs/claims.md"))]
pub mod claims {}

/// Notation: the LaTeX that is read, and what is rejected as ambiguous.
///
/// [claims-document]: claims#the-document
/// [claims-continua]: claims#continua
/// [claims-functions]: claims#functions
/// [claims-families]: claims#families
/// [claims-equation]: claims#an-equation
#[cfg_attr(doc, doc = include_str!("../docs/notation.md"))]
pub mod notation {}

/// One term for one thing, and the verdicts.
///
/// [claims]: claims
#[cfg_attr(doc, doc = include_str!("../docs/glossary.md"))]
pub mod glossary {}

/// For teachers: marking a class.
///
/// [claims]: claims
/// [claims-addresses]: claims#addresses
/// [claims-systems]: claims#systems
/// [glossary-verdicts]: glossary#verdicts
#[cfg_attr(doc, doc = include_str!("../docs/teaching.md"))]
pub mod teaching {}

/// How onshell works: the way of one equation, and the map of folders.
///
/// [glossary]: glossary
#[cfg_attr(doc, doc = include_str!("../docs/architecture.md"))]
pub mod architecture {}

/// Figures: verdicts, mutants, repairs and times.
#[cfg_attr(doc, doc = include_str!("../docs/benchmarks.md"))]
pub mod benchmarks {}
