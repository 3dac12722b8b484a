//! Sentences about a function of one variable: its sign, its extrema, its limits, the solutions of an equation.
//!
//! [`function_shape`] checks such a sentence at states whose symbols are independent numbers. [`shape`] names the shapes,
//! [`scan`] follows a function along its variable, [`root_isolation`] counts roots, and [`enclosed_function`] decides with many
//! digits what doubles cannot. Knows `limit` among the kinds of claim, and what is below these.
//!
//! Offers `function_shape::check`, the shapes themselves, and the count of roots on a grid.

pub(crate) mod enclosed_function;
pub(crate) mod function_shape;
pub(crate) mod root_isolation;
pub(crate) mod scan;
pub(crate) mod shape;
