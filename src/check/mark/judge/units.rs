//! The unit of a number that a student computed, compared with that of the quantity that it is a value of.
//!
//! The formulas of the problem relate the units of its quantities, and the data of the hand-in and of the problem are printed with
//! units. Where both together leave the quantity one unit, a value in another one is wrong, whatever its number is.
//!
//! A student may write units like letters, `4.22\,s`. The letters may be quantities of the problem, as m is a mass. So they count as units
//! only where the line does not hold without them, and is right to its printed digits with them.

use std::collections::HashMap;

use crate::formula::text::formula as formula_text;
use crate::formula::units::in_si::has_units;
use crate::formula::units::{Affine, Dimension, UnitCheck};
use crate::formula::{Expr, Node, Statement, Symbols};
use crate::latex::foreign;
use crate::latex::rename::renamed;
use crate::latex::{Macros, Reading, read_formula};
use crate::notes::claims::Claim;

use crate::check::mark::marked::Because;
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

    /// What is wrong with the unit of the number with which a line ends; `None` where it fits, or nobody can tell.
    pub(super) fn wrong_unit(&self, at: usize, reading: &Reading) -> Option<Because> {
        self.wrong_unit_in(at, &self.world.written[at].text, reading)
    }

    /// The same for a line in another form.
    pub(super) fn wrong_unit_in(&self, at: usize, line: &str, reading: &Reading) -> Option<Because> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let (value, formulas) = statement.members.split_last()?;
        if !value.symbols().is_empty() {
            return None;
        }
        let (printed, shown) = printed_unit(line)?;
        let mut check = UnitCheck::new(&self.quiet.model.symbols);
        for problem in &self.quiet.readings[..self.world.problem.notes.equations.len()] {
            for statement in problem.statements.iter().flatten() {
                check.statement(statement);
            }
        }
        let notes = &self.world.problem.notes;
        let stated = notes.inline.iter().filter_map(|span| notes.source.text.get(span.range()));
        let stated: Vec<_> = stated.map(|text| text.trim_matches('$')).collect();
        let own = self.world.written.iter().enumerate().filter(|(other, _)| *other != at);
        let own = own.map(|(other, line)| (line.text.as_str(), self.quiet.readings[self.world.first + other].clone()));
        let (claim, no_names) = (Claim::default(), HashMap::new());
        let of_problem = stated.into_iter().map(|text| {
            let without = renamed(text, &self.quiet.model.macros, &no_names).text;
            (text, self.quiet.as_printed(&without, &claim, &self.quiet.model.macros))
        });
        for (text, reading) in own.chain(of_problem) {
            let [Ok(Statement { members, .. })] = reading.statements.as_slice() else { continue };
            let [name, value] = members.as_slice() else { continue };
            let (Some(id), true) = (name.as_plain_symbol(), value.symbols().is_empty()) else { continue };
            if let Some((dimension, _)) = printed_unit(text) {
                // Data that contradict each other say nothing.
                check.inference.require_equal(&Affine::of(id), &Affine::known(dimension)).ok()?;
            }
        }
        let wanted = formulas.iter().filter(|formula| has_letters_only(formula)).find_map(|formula| {
            let found = check.dimension(formula).ok()??;
            check.inference.reduce(&found).0.as_known()
        })?;
        (wanted != printed && !differs_by_a_count(wanted, printed))
            .then(|| Because::Unit { wanted: wanted.to_string(), printed: shown })
    }
}

/// Whether a formula has letters, and no numbers in the place of some: in `v_0^2/20` the unit of what was put in is lost.
fn has_letters_only(formula: &Expr) -> bool {
    const SMALL: [&str; 9] = ["0", "1", "2", "3", "4", "5", "6", "8", "9"];
    let mut is_so = !formula.symbols().is_empty();
    formula.walk(&mut |part| {
        if let Node::Number(digits) = &part.node {
            is_so &= SMALL.contains(&digits.as_str());
        }
    });
    is_so
}

/// Whether two units differ by the mole only, which authors leave out.
fn differs_by_a_count(a: Dimension, b: Dimension) -> bool {
    let mut same = a;
    same.0[5] = b.0[5];
    same == b
}

/// The dimension of a number with its unit at the end of a text, and how it is printed; `None` without a unit, or with one that may stand
/// for another quantity.
fn printed_unit(text: &str) -> Option<(Dimension, String)> {
    let end = text.rfind(['=', '≈']).map(|at| at + text[at..].chars().next().map_or(0, char::len_utf8));
    let end = end.max(text.rfind("\\approx").map(|at| at + "\\approx".len()))?;
    let mut symbols = Symbols::open();
    let value = read_formula(&text[end..], &mut symbols, &Macros::default()).ok()?;
    let mut is_doubtful = false;
    // Where constants of nature are 1, a mass is printed in electronvolts.
    value.walk(&mut |part| {
        is_doubtful |= matches!(&part.node, Node::Unit(unit) if unit.is_doubtful() || unit.is_natural());
    });
    if !has_units(&value) || !value.symbols().is_empty() || is_doubtful {
        return None;
    }
    let dimension = UnitCheck::new(&symbols).dimension(&value).ok()??.as_known()?;
    let shown = formula_text(&value, &symbols);
    (!dimension.is_none()).then_some((dimension, shown))
}
