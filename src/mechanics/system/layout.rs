//! The order of a tape's inputs.

/// The indices of a tape's inputs: the time, the coordinates, the velocities, the parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub coordinates: usize,
    pub parameters: usize,
}

impl Layout {
    pub fn inputs(self) -> usize {
        1 + 2 * self.coordinates + self.parameters
    }
    pub fn q(self, i: usize) -> usize {
        1 + i
    }
    pub fn v(self, i: usize) -> usize {
        1 + self.coordinates + i
    }
}
