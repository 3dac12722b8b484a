//! **onshell** checks the equations in physics notes against what automatic differentiation derives.
//!
//! An equation is read where its author typeset it, in Markdown or TeX. What is true is derived independently: from a
//! Lagrangian that is a Rust function, or from laws that the notes assume. The two are compared at sampled states, and
//! identities are decided over a prime field as well. Each equation gets a [`check::Verdict`] with its evidence.
//!
//! *On shell* is the field's term for "on the solutions of the equations of motion".
//!
//! # Check notes
//!
//! Notes, and a claims file that says what the symbols mean. Here both are texts, and the Lagrangian is your own: a mass on
//! a spring that hangs in gravity. The equation of motion and the energy follow from the Lagrangian.
//!
//! ```
//! use onshell::check::Verdict;
//! use onshell::mechanics::{Lagrangian, State};
//! use onshell::scalar::Number;
//! use onshell::systems::Registry;
//! use onshell::testing::{assert_text, check_text};
//!
//! struct Spring; // z points upward, and the spring is relaxed at z = 0
//!
//! impl Lagrangian<1, 3> for Spring {
//!     fn name(&self) -> &str { "spring" }
//!     fn coordinates(&self) -> [&str; 1] { ["z"] }
//!     fn parameters(&self) -> [&str; 3] { ["m", "k", "g"] }
//!     fn lagrangian<D: Number>(&self, at: &State<D, 1, 3>) -> D {
//!         let ([z], [v], [m, k, g]) = (at.q, at.v, at.parameters);
//!         m * v * v * 0.5 - k * z * z * 0.5 - m * g * z
//!     }
//! }
//!
//! let notes = r"
//! The mass moves as
//!
//! $$ m \ddot z = - k z - m g \tag{1} $$
//!
//! so its energy stays the same:
//!
//! $$ E = \frac12 m \dot z^2 + \frac12 k z^2 + m g z \tag{2} $$
//! ";
//! let claims = r#"{
//!     "notes": "spring.md",
//!     "system": "spring",
//!     "coordinates": { "z": "any" },
//!     "constants": { "m, k, g": "> 0" },
//!     "means": { "E": "energy" },
//!     "equations": { "2": { "conserved": true } }
//! }"#;
//!
//! let mut registry = Registry::standard();
//! registry.add(Spring);
//! assert_text(notes, claims, &registry);
//!
//! // A check that cannot fail is worth nothing: with one wrong sign, (1) is refuted at a state that is given.
//! let document = check_text(&notes.replace("- m g", "+ m g"), claims, &registry)?;
//! let equation = &document.equations[0];
//! assert_eq!((equation.id.as_str(), equation.finding.verdict), ("1", Verdict::Refuted));
//! let found = equation.finding.counterexample.as_ref().unwrap();
//! assert_ne!(found.lhs, found.rhs);
//! assert!(found.state.iter().any(|(symbol, _)| symbol == "z"));
//!
//! // (2) does not depend on (1): its energy is conserved on shell, decided over a prime field.
//! assert_eq!(document.equations[1].finding.verdict, Verdict::Certified);
//! # Ok::<(), onshell::Error>(())
//! ```
//!
//! Files are checked with [`testing::assert_file`], or from the command line with `onshell check`.
//!
//! # Compare two formulas
//!
//! ```
//! use onshell::check::Verdict;
//! use onshell::{Formula, Options, compare};
//!
//! let found = compare(r"\sin 2x", r"2\sin x\cos x", &[], Options::default())?;
//! assert_eq!(found.finding.verdict, Verdict::Certified);
//! let found = compare(r"\sin 2x", r"2\sin x", &[], Options::default())?;
//! assert_eq!(found.finding.verdict, Verdict::Refuted);
//!
//! assert_eq!(Formula::read(r"\frac12 m v^2")?.value(&[("m", 2.0), ("v", 3.0)])?, 9.0);
//! # Ok::<(), onshell::Error>(())
//! ```
//!
//! # Simulate a system from its Lagrangian
//!
//! [`mechanics::System`] gives accelerations, momenta and energies. The page of [`mechanics`] simulates a heavy top and
//! measures its energy drift; here one pendulum takes one step.
//!
//! ```
//! use onshell::mechanics::System;
//! use onshell::systems::Pendulum;
//!
//! let pendulum = System::new(&Pendulum::<1>::new())?;
//! let parameters = pendulum.parameter_values(&[("m", 1.0), ("l", 2.0), ("g", 9.81)])?;
//! let mut evaluator = pendulum.acceleration_evaluator(&parameters);
//! let acceleration = evaluator.accelerations(0.0, &[0.3], &[0.0])?[0];
//! // θ̈ = −(g/l) sin θ
//! assert!((acceleration + 9.81 / 2.0 * 0.3_f64.sin()).abs() < 1e-14);
//! # Ok::<(), onshell::Error>(())
//! ```
//!
//! # Map
//!
//! | module | what it offers |
//! | --- | --- |
//! | [`check`] | checks of documents, and the types of a report |
//! | [`testing`] | the same checks as assertions in a test |
//! | [`Formula`], [`compare`] | formulas without a document |
//! | [`mechanics`], [`systems`] | Lagrangians, and all that follows from them; named systems |
//! | [`mod@derive`] | what follows from a Lagrangian as formulas to read |
//! | [`notes`] | documents and claims files |
//! | [`report`] | reports as text and JSON |
//! | [`scalar`] | the numbers over which Lagrangians are evaluated |
//! | [`guide`] | the pages: claims file, notation, words, architecture |
//!
//! # Features
//!
//! `cli` (default) adds the command line. Without it no command-line crate is built. `notes` (implied by `cli`) adds
//! documents, formulas and checks. Without both the crate is mechanics alone.
#![warn(missing_docs)]
#![forbid(unsafe_code)]
// The headers of modules speak to readers of the source as well, and name what is private.
#![allow(rustdoc::private_intra_doc_links)]

#[cfg(feature = "notes")]
pub mod check;
#[cfg(feature = "cli")]
pub mod cli;
mod code;
pub mod derive;
mod error;
mod formula;
#[cfg(feature = "notes")]
mod formulas;
pub mod guide;
mod latex;
#[cfg(feature = "cli")]
mod lecture;
pub mod mechanics;
#[cfg(feature = "notes")]
pub mod notes;
#[cfg(feature = "cli")]
mod page;
#[cfg(feature = "notes")]
mod parallel;
#[cfg(feature = "notes")]
mod phrases;
#[cfg(feature = "cli")]
mod plot;
#[cfg(feature = "cli")]
pub mod report;
pub mod scalar;
mod source;
mod suggest;
pub mod systems;
#[cfg(feature = "notes")]
pub mod testing;

#[cfg(feature = "notes")]
pub use check::Options;
#[cfg(feature = "notes")]
pub use check::kinds::compare::Comparison;
pub use code::Code;
pub use error::{Error, Result};
#[cfg(feature = "notes")]
pub use formulas::{Formula, compare};
#[cfg(feature = "notes")]
pub use source::{FileEdit, Place};
pub use source::{Source, Span};

/// The Rust code of the README, so that it is tested.
#[cfg(all(doctest, feature = "notes"))]
#[doc = include_str!("../README.md")]
struct Readme;

// The tests in `tests/unit` name this crate as the others do.
#[cfg(test)]
extern crate self as onshell;

#[cfg(all(test, feature = "notes"))]
#[path = "../tests/unit/mod.rs"]
mod unit;
