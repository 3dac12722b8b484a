//! The style of all pages: light and dark, for screens of any width and for paper.

/// The style sheet.
pub(super) const STYLE: &str = include_str!("style.css");
