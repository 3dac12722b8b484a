//! Pictures of a system as SVG: its motion, the drift of its energy, its effective potential, the axis of a top, the rates of
//! precession, polhodes.
//!
//! All numbers come from the tapes of [`crate::mechanics::System`]. `trajectory` integrates with error control, `pictures`
//! and `tops` say what is drawn, `sides` draws the two sides of an equation that is wrong, `figure` draws, and `gallery` is what
//! suits a system. This folder may know `mechanics`, `formula`, `scalar` and level 0.
//!
//! Offers [`picture`] and [`gallery`](fn@gallery), each as text.

mod figure;
mod gallery;
mod pictures;
mod sides;
mod start;
mod tops;
pub mod trajectory;

pub use gallery::{Picture, gallery};
pub use pictures::{Kind, picture};
pub use sides::two_sides;
pub use start::Start;
