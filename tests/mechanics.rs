//! The mechanics: properties that hold at any state, and beside each a twin that must fail.

#[path = "mechanics/support.rs"]
mod support;

#[path = "mechanics/bodies.rs"]
mod bodies;
#[path = "mechanics/chain.rs"]
mod chain;
#[path = "mechanics/conservation.rs"]
mod conservation;
#[path = "mechanics/cubature.rs"]
mod cubature;
#[path = "mechanics/equations_of_motion.rs"]
mod equations_of_motion;
#[path = "mechanics/euler_equations.rs"]
mod euler_equations;
#[path = "mechanics/frames.rs"]
mod frames;
#[path = "mechanics/legendre.rs"]
mod legendre;
#[path = "mechanics/motion.rs"]
mod motion;
#[path = "mechanics/refusals.rs"]
mod refusals;
#[path = "mechanics/rotations.rs"]
mod rotations;
#[path = "mechanics/source.rs"]
mod source;
