//! The names in the displays of a document, and how they stand there: with dots, under a root, in a sine.
//!
//! Offers `names_of`, each name with how it is used. Knows LaTeX and notes, and no other folder of `check`.

mod chains;
mod differentials;
mod entry;
mod names;

pub(crate) use entry::Usage;
pub(crate) use names::names_of;
