//! Trials of another text in place of a display, for mutation testing and for repairs.
//!
//! Offers [`text_trial::Trial`], which refutes most texts at a few kept states; [`edited_display`], a document with another text
//! for one display; [`edited_document`], the check of a whole edited document; [`failed_display`], a display to be repaired.
//! For mutation testing, `equivalence` tells whether a text says the same as the display. Knows `equations` and below.

pub(crate) mod edited_display;
pub(crate) mod edited_document;
#[cfg(feature = "cli")]
mod equivalence;
pub(crate) mod failed_display;
pub(crate) mod text_trial;
