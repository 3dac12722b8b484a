//! Sampled states that obey the hypotheses of a claim.
//!
//! Offers [`sampler::Sampler`], which draws numbers; [`projection::Projection`], which moves them onto the hypotheses by
//! Newton's method; [`ensemble::Ensemble`], the states; [`context::Context`], a claim's hypotheses and the name that seeds
//! its states; [`outcome`], what all states together say of a claim. Knows `state` and below.

pub(crate) mod context;
pub(crate) mod ensemble;
pub(crate) mod hypothesis_residual;
pub(crate) mod newton;
pub(crate) mod outcome;
pub(crate) mod prescribed_values;
pub(crate) mod projection;
pub(crate) mod sampler;
pub(crate) mod setting;
pub(crate) mod special;
