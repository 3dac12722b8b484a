//! One sampled state, in which every formula of a document has a value.
//!
//! Offers [`sampled_state::SampledState`], fixed by the numbers of [`numbers`] and evaluated by [`evaluate`] (series in
//! time) and [`instant`] (values only); and [`residual`], whether the two sides of a claim agree in it. Knows `model`
//! and `hypotheses`, and does not know how states are drawn.

pub(crate) mod counterexample;
pub(crate) mod coupled;
pub(crate) mod evaluate;
pub(crate) mod generic_body;
pub(crate) mod instant;
pub(crate) mod memo;
pub(crate) mod numbers;
pub(crate) mod particles;
pub(crate) mod quadrature;
pub(crate) mod residual;
pub(crate) mod rules;
pub(crate) mod sampled_state;
pub(crate) mod system_values;
pub(crate) mod turning_frame;
pub(crate) mod values;
