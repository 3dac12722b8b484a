//! What functions and operators without a formula make of their arguments.

/// What an operator or a function that has no formula makes of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// A function: its value has the kind of the name.
    Function,
    /// The value has the shape of the argument: a sum, an integral, a curl.
    Same,
    /// The value is a vector: a gradient.
    ToVector,
    /// The value is a number: a divergence.
    ToNumber,
}
