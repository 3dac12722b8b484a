//! Another text in the place of a display, as mutation and repair try it.
//!
//! Offers [`trial_text::Trial`], which refutes most texts at a few kept states, and [`document`], which checks a whole document
//! with an edit made. Knows `equations` and below.

pub(crate) mod document;
pub(crate) mod edited_display;
pub(crate) mod trial_text;
pub(crate) mod wrong;
