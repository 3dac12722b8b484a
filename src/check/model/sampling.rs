//! How the states of a claim are sampled: on shell or off, and from how wide ranges.

/// Whether a state is on shell, and how many time derivatives it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mode {
    /// Whether the accelerations obey the Euler–Lagrange equations, and the laws hold.
    pub on_shell: bool,
    /// The order of the highest time derivative that is known.
    pub order: usize,
}

/// From how wide ranges numbers are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// The declared ranges; a number without a range of its own is of order one.
    Declared,
    /// The declared ranges, and within them numbers of order one wherever the range has some.
    OrderOne,
    /// Ranges wider than those that are declared.
    BeyondRanges,
    /// The declared ranges with their ends; a number without a range of its own is of any order of magnitude.
    WithEnds,
    /// The whole of the declared ranges: numbers of any order of magnitude, and angles of many turns.
    AllMagnitudes,
}
