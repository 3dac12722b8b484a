//! What a document says without a declaration: names of momenta, a Hamiltonian, constants of integration, indices, and the
//! definitions that the prose makes.

pub(crate) mod hamiltonian;
pub(crate) mod indices;
pub(crate) mod integration_constants;
pub(crate) mod momenta;
pub(crate) mod prose;
