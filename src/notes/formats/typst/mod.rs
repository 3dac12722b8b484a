//! Typst: the displays `$ … $`, written as LaTeX, and their labels.
//!
//! What has no counterpart becomes a command that no reader knows, so that its display is reported as not read.
//!
//! Offers `FORMAT`. Knows texts and places in them, as every format does.

mod displays;
mod math;
mod symbols;

pub(super) use displays::FORMAT;
