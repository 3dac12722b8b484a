//! Numbers with units that a student writes like letters: `4.22\,s`, `3.27\,m/s^2`.
//!
//! The letters may be quantities of the problem, as m is a mass. So the units count only where the line does not hold without them,
//! and is right to its printed digits with them.

use std::collections::HashMap;

use crate::latex::foreign;
use crate::latex::rename::renamed;
use crate::notes::claims::Claim;

use crate::check::mark::status::Status;

use super::Judge;

impl Judge<'_, '_> {
    /// Whether a display is right to its printed digits if the letters after its numbers are units.
    pub(super) fn is_right_with_units(&self, display: usize) -> bool {
        let Some(upright) = foreign::with_upright_units(&self.quiet.notes.equations[display].text) else {
            return false;
        };
        let macros = &self.quiet.model.macros;
        let text = renamed(&upright, macros, &HashMap::new()).text;
        let reading = self.with_known(self.quiet.as_printed(&text, &Claim::default(), macros));
        let known = self.known_with_the_problem();
        let has_its_unit = self.wrong_unit_in(display - self.world.first, &upright, &reading).is_none();
        has_its_unit
            && known.fits(self.quiet, &text, &reading, |link| matches!(self.status(display, link).0, Status::Holds(_)))
    }
}
