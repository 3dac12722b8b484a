//! Derivations: displays that the claims file declares to be steps, and false steps that follow from a false step before.
//!
//! Each step is first checked like any display. A false step is then compared with the false steps before it. If it follows
//! from one of them, its verdict stays `refuted`, and the finding names the step with the mistake.
//!
//! Offers methods of [`Checker`](crate::check::document::checker::Checker): `derivations` and `with_steps` in
//! [`derivation`]. [`entailment`] says whether a step follows, in the model that [`premise`] makes. Knows `repair` and below.
//!
//! # Why a derivation is declared by a list
//!
//! `"from"` on each equation could name any premises, and would have to be kept right for each line, in an order
//! that the notes have anyway. A list of addresses is what people say: (1) to (5). A line may follow from any one
//! before it. Nothing else depends on the list: without it a document has the same verdicts.

pub(crate) mod derivation;
pub(crate) mod entailment;
pub(crate) mod premise;
