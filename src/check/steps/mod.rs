//! Derivations: displays that the claims file declares to be steps, and false steps that follow from a false step before.
//!
//! Each step is first checked like any display. A false step is then compared with the false steps before it. If it follows
//! from one of them, its verdict stays `refuted`, and the finding names the step with the mistake.
//!
//! Offers methods of [`Checker`](crate::check::document::checker::Checker): `derivations` and `with_steps` in
//! [`derivation`]. [`entailment`] says whether a step follows, in the model that [`premise`] makes. Knows `repair` and below.

pub(crate) mod derivation;
pub(crate) mod entailment;
pub(crate) mod premise;
