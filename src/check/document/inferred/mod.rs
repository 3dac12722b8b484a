//! What a document says without a declaration: names of momenta, a Hamiltonian, constants of integration, indices, and the
//! definitions that the prose makes.
//!
//! Offers a function in each file that adds what it infers to the model. Knows `model`, and LaTeX and notes below it.

pub(crate) mod early_definitions;
pub(crate) mod hamiltonian;
pub(crate) mod indices;
pub(crate) mod integration_constants;
pub(crate) mod momenta;
pub(crate) mod open_energies;
pub(crate) mod prose;
