//! The typeset structure of a formula: groups, fences, fractions, scripts, accents, rows. Nothing has a meaning yet.
//!
//! `item` has the layout tree, `parser` builds it from tokens, `text` from a text with macros; `lengths` reads spaces with a
//! length, `boxes` formulas in boxes of text, `marks` the marks of derivatives that are set in bold or as words, `spelled`
//! functions without a backslash; `delimiters` and `angles` pair what opens and closes, `fences` reads what stands between
//! `\left` and `\right`, and `print` writes items as LaTeX again. `units` finds the units after numbers, `values` the runs of
//! items that are declared to be one quantity, and `rest` the terms that are left out at the end of a sum.
//! [`layout`] cannot fail; what it does not understand becomes a [`Layout::Fault`] at its place.
//!
//! This folder may import the lexer, the macros and the normalizer of [`super`].
//!
//! Offers [`Item`] and [`typeset_items`], and `latex` and `typed`, items as text again.
//!
//! # Why reading has two steps
//!
//! Layout knows how things are typeset and nothing of what they mean: groups, fences, fractions, scripts. It never
//! fails: what it does not understand becomes a node with a fault in it. The reader then gives the items their
//! meaning, with the declared symbols. So an error in one statement leaves the others readable, and every fault has
//! its bytes. Both steps are bounded: groups nest 64 deep, and a formula has at most 2¹⁸ bytes.

mod angles;
#[cfg(feature = "notes")]
mod boxes;
mod delimiters;
mod fences;
mod item;
#[cfg(feature = "notes")]
mod lengths;
#[cfg(feature = "notes")]
mod marks;
mod parser;
#[cfg(feature = "notes")]
mod print;
#[cfg(feature = "notes")]
pub(crate) mod rest;
mod scripts;
#[cfg(feature = "notes")]
mod spelled;
#[cfg(test)]
mod tests;
#[cfg(feature = "notes")]
mod text;
mod units;
#[cfg(feature = "notes")]
pub(crate) mod values;

#[cfg(feature = "notes")]
pub use item::Units;
pub use item::{Delimiter, Item, Layout};
#[cfg(feature = "notes")]
pub(crate) use item::{contents, parts};
pub use parser::layout;
#[cfg(feature = "notes")]
pub(crate) use print::{latex, typed};
#[cfg(feature = "notes")]
pub(crate) use spelled::{is_name_of_letters, is_number_of_a_flow};
#[cfg(feature = "notes")]
pub(crate) use text::{prints_derivative, typeset_items};
