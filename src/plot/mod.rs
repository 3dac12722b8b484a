//! Pictures of a system as SVG: its motion, the drift of its energy, its effective potential, the axis of a top, the rates of
//! precession, polhodes.
//!
//! All numbers come from the tapes of [`crate::mechanics::System`]. `trajectory` integrates with error control, `pictures`
//! says what is drawn, and `figure` draws it. This folder may know `mechanics`, `formula`, `scalar` and level 0.

mod figure;
mod pictures;
pub mod trajectory;

pub use pictures::{Kind, Start, picture};
