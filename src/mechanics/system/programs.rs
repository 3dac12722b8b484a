//! The programs of a system's accelerations, compiled from their tape when they are first needed.

use std::sync::OnceLock;

use super::layout::Layout;
use crate::mechanics::tape::Tape;
use crate::mechanics::tape::program::Program;

/// The programs of a system's accelerations.
#[derive(Default)]
pub(super) struct Programs {
    /// The program for states that share their parameters.
    uniform: OnceLock<Program>,
    /// The program for states each with its own parameters.
    varying: OnceLock<Program>,
}

impl Programs {
    /// The program of a tape of accelerations with this layout of inputs.
    pub fn of(&self, tape: &Tape, layout: Layout, uniform_parameters: bool) -> &Program {
        let first_parameter = layout.v(layout.coordinates);
        if uniform_parameters {
            self.uniform.get_or_init(|| Program::new(tape, |input| input >= first_parameter))
        } else {
            self.varying.get_or_init(|| Program::new(tape, |_| false))
        }
    }
}
