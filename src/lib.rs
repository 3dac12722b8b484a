//! **onshell** checks the equations in physics notes against what automatic differentiation derives.
//!
//! An equation is read where its author typeset it, in Markdown or TeX. What is true is derived on its own: from a
//! Lagrangian that is a Rust function, or from laws that are taken for granted, for particles, turning bodies and
//! continua. The two are compared at sampled states, and identities are decided over a prime field as well. Where they
//! differ, the author gets the place, a state at which they differ, and the values of both sides there.
//!
//! # An example
//!
//! Notes, and a claims file that says what the symbols are. Here both are texts, and the Lagrangian is written for this
//! example: a mass that hangs on a spring. The equation of motion and the energy follow from the Lagrangian.
//!
//! ```
//! use onshell::check::Verdict;
//! use onshell::mechanics::{Lagrangian, State};
//! use onshell::scalar::Number;
//! use onshell::systems::Registry;
//! use onshell::testing::{assert_text, check_text};
//!
//! struct Spring; // z points upward, and the spring is at rest where z = 0
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
//! // The case that must fail: with one wrong sign, (1) is refuted.
//! let document = check_text(&notes.replace("- m g", "+ m g"), claims, &registry)?;
//! let equation = &document.equations[0];
//! assert_eq!((equation.id.as_str(), equation.finding.verdict), ("1", Verdict::Refuted));
//! let found = equation.finding.counterexample.as_ref().unwrap();
//! assert_ne!(found.lhs, found.rhs);
//! assert!(found.state.iter().any(|(symbol, _)| symbol == "z"));
//!
//! // The other equation does not depend on it.
//! // It is an identity on shell, decided over a prime field.
//! assert_eq!(document.equations[1].finding.verdict, Verdict::Certified);
//! # Ok::<(), onshell::Error>(())
//! ```
//!
//! Notes in files are checked with [`testing::assert_file`], or from the command line with `onshell check`.
//!
//! # The concepts
//!
//! *Notes* ([`notes::Notes`]) are a document as its author wrote it. onshell finds the displays in it, their numbers and
//! their labels, with the byte range of everything.
//!
//! *Claims* ([`notes::Claims`]) are a JSON file beside the notes. It declares the symbols, names the system or the laws,
//! and says what an equation claims where its text does not say it. [`guide::claims`] has every key. What onshell does
//! not know in a claims file is an error at its place.
//!
//! A *system* ([`mechanics::Lagrangian`], [`systems`]) is a Lagrangian as a Rust function, generic in the number. The
//! equations of motion, momenta, energy, Hamiltonian and effective potential follow from it ([`mechanics::System`]). No
//! system contains a closed form that is checked. Without a system, *laws* say how things move.
//!
//! A *formula* ([`formula::Expr`]) is what LaTeX says, apart from how it is typeset. [`latex`] reads it in two steps,
//! layout and then meaning, and rejects what can be read in more than one way ([`guide::notation`]).
//!
//! A *sampled state* gives every symbol a value and its time derivatives. *Off shell* the derivatives are free numbers;
//! *on shell* the highest ones follow from the equations of motion or the laws.
//!
//! A *verdict* ([`check::Verdict`]) comes with its evidence ([`check::Finding`]): the number of sampled states, the
//! largest residual, or the counterexample. An equality that passes is also compared with its *mutants*, the same claim
//! with one slip in it. If it is an identity over a prime field ([`scalar::prime_field`]), it is *certified*, with a bound
//! on the probability that it is false. A *definition* passes if each slip in it makes another equation fail. All words
//! are explained in [`guide::glossary`].
//!
//! # The modules
//!
//! Each module imports only from those below it. `formula` and `mechanics` do not know each other: what is printed and
//! what is true meet in `check`. [`guide::architecture`] follows one equation through all of them.
//!
//! | module | purpose |
//! | --- | --- |
//! | [`cli`], [`testing`] | the command; the same checks as assertions in a test |
//! | [`report`] | verdicts as text, as JSON, as diagnostics |
//! | [`check`] | the comparison of the printed with the derived |
//! | [`mod@derive`] | derived equations as formulas that people read |
//! | [`notes`], [`latex`], [`systems`] | documents and claims; LaTeX to formulas and back; named Lagrangians |
//! | [`formula`], [`mechanics`] | what an equation says; what is true |
//! | [`scalar`] | the numbers that formulas and Lagrangians are evaluated on |
//! | [`source`], [`error`], [`code`], [`suggest`] | texts and places in them; errors; message codes; "did you mean" |
#![warn(missing_docs)]
#![forbid(unsafe_code)]

pub mod check;
pub mod cli;
pub mod code;
pub mod derive;
pub mod error;
pub mod formula;
pub mod guide;
pub mod latex;
pub mod mechanics;
pub mod notes;
pub mod report;
pub mod scalar;
pub mod source;
pub mod suggest;
pub mod systems;
pub mod testing;

pub use error::{Error, Result};

/// The Rust code of the README, so that it is tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
