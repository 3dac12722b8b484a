//! What a document says without a declaration: names of momenta, a Hamiltonian, constants of integration, and the
//! definitions that the prose makes.

pub(crate) mod hamiltonian;
pub(crate) mod integration_constants;
pub(crate) mod momenta;
pub(crate) mod prose;
