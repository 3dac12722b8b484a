//! Sampled states that obey the hypotheses of a claim.
//!
//! Offers [`sampler::Sampler`], which draws numbers; [`projection::Projection`], the equations of the hypotheses, which
//! [`newton`] solves; [`ensemble::Ensemble`], the states; [`context::Context`], a claim's hypotheses and the name that
//! seeds its states; [`inequalities`], numbers moved to where inequalities hold; [`prescribed_values`], states with given values of some quantities; [`outcome`], the result of a
//! claim at all states; [`unmet_hypotheses`], why there is no state; [`enclosed`], a claim at one state with as many
//! digits as it needs. Knows `state`, `hypotheses`, `model` and `verdict`.

pub(crate) mod context;
pub(crate) mod enclosed;
pub(crate) mod ensemble;
pub(crate) mod hypothesis_residual;
pub(crate) mod inequalities;
pub(crate) mod newton;
pub(crate) mod outcome;
pub(crate) mod prescribed_values;
pub(crate) mod projection;
pub(crate) mod sampler;
pub(crate) mod setting;
pub(crate) mod special;
pub(crate) mod unmet_hypotheses;
pub(crate) mod without_value;
