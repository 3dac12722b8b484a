//! The report for the programs of a pull request: [`github`], [`sarif`] and [`junit`], printed from one list of problems.
//!
//! Offers one function `report` for each. Knows the folder above it only for the code and the headline of a
//! finding.

pub mod github;
pub mod junit;
mod problem;
pub mod sarif;
