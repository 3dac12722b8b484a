//! Where the printed and the derived meet: each equation of a document against what is true.
//!
//! [`check_document`] reads every numbered display, builds the [`model`] of its symbols, and gives each claim a
//! [`Verdict`] with its evidence. A claim between two formulas is tested in [`identity`]; [`solves`], [`limit`] and
//! [`generates`] are the other kinds; [`functions`] tests what sentences say about the shape of a function. States are
//! made in [`ensemble`] (drawn, and moved onto the hypotheses), evaluated in [`scene`], judged in [`judge`]; and every
//! pass is held against its [`twins`]. Where units are declared, [`units`] comes before all of these.

mod adversary;
mod anew;
mod any_body;
mod base;
mod branches;
mod builder;
mod certify;
mod chain;
mod continuum;
mod crowd;
mod damage;
pub mod definitions;
mod desk;
mod difference;
pub mod document;
mod doubt;
pub mod draw;
pub mod drawn;
mod edges;
pub mod ensemble;
mod equation;
pub mod evidence;
mod exactly;
mod following;
mod forced;
mod formal;
pub mod functions;
mod gaps;
pub mod generates;
mod growth;
pub mod identity;
mod instant;
pub mod judge;
mod laws;
pub mod limit;
mod lost;
pub mod model;
mod motion;
pub mod mutate;
mod nothing;
mod particles;
mod pins;
pub mod plain;
mod premise;
mod probe;
mod progress;
mod reached;
mod reading;
mod redefinition;
mod repair;
pub mod reprint;
mod restated;
mod rules;
pub mod scene;
mod sentences;
mod shared;
mod sizes;
mod small;
mod solved;
mod solver;
pub mod solves;
mod standing;
mod steps;
mod tautology;
mod terms;
mod together;
mod trial;
pub mod twins;
mod unclear;
pub mod units;
mod uses;
pub mod verdict;
mod whole;
mod wide;

pub use document::{Run, check_document, check_in, unclaimed};
pub use identity::Options;
pub use progress::Progress;
pub use reprint::check_reprint;
pub use verdict::{
    Counterexample, Document, Equation, Finding, Fit, Formula, Fraction, Inherited, Misfit, Part, Repair, Report,
    Shared, Verdict,
};
