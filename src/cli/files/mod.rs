//! Files that commands read and write.
//!
//! Offers [`documents`], from paths to documents, and [`replace_file`], which replaces a text as a whole or not at all.
//!
//! Knows notes and claims files, and no command.

pub(super) mod documents;
pub(super) mod replace_file;
