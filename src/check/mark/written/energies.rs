//! A kinetic energy with a letter that is something else in the problem, as T is for a period.

use crate::check::mark::names::Names;
use crate::check::usage::names_of;
use crate::formula::symbols::Name;
use crate::latex::{Macros, names};

use super::Written;
use super::single_letters::{as_display, rename, single};

/// Letters for kinetic energies, and the names that stand for them.
const KINETIC: [(&str, &str); 2] = [("T", "T_{\\star}"), ("K", "K_{\\star}")];

/// Gives such a letter another name from the line on that says what the energy is, up to a line that gives the letter the meaning of
/// the problem again, `T = 2\pi/\omega`.
pub(in crate::check::mark) fn kinetic(lines: &mut [Written], known: &Names, macros: &Macros) {
    for (letter, name) in KINETIC {
        let Some((own, _)) = names::parse(letter) else { continue };
        if !known.fixed.contains(&own) {
            continue;
        }
        let mut is_energy = false;
        for line in &mut *lines {
            if let Some(value) = value_of(&line.text, letter) {
                let used = names_of(&[as_display(line)], macros);
                let mut others = used.iter().map(|usage| &usage.name).filter(|name| **name != own);
                let is_fixed = |name: &Name| known.fixed.contains(name) || name.base == "\\pi";
                is_energy = is_sum_of_squares(value) || is_energy && !others.all(is_fixed);
            }
            if is_energy {
                let places = single(&line.text, letter);
                rename(line, places, name);
            }
        }
    }
}

/// Whether a name stands for such an energy.
pub(in crate::check::mark) fn is_kinetic(name: &Name) -> bool {
    KINETIC.iter().any(|(_, energy)| names::parse(energy).is_some_and(|(energy, _)| energy == *name))
}

/// What a line gives a letter that is its whole left side.
fn value_of<'t>(text: &'t str, letter: &str) -> Option<&'t str> {
    let (left, value) = text.split_once('=')?;
    (left.trim() == letter).then_some(value)
}

/// Whether a formula has the square of a velocity and the factor ½.
fn is_sum_of_squares(value: &str) -> bool {
    let has = |parts: &[&str]| parts.iter().any(|part| value.contains(part));
    let is_square = has(&["^2", "^{2}"]) && has(&["\\dot", "'", "v"]);
    is_square && has(&["\\frac12", "\\frac 12", "frac{1}{2}", "\\frac{m}{2}", "\\frac m2", "1/2", "/2"])
}

#[cfg(test)]
mod tests {
    use super::{is_sum_of_squares, value_of};

    #[test]
    fn a_kinetic_energy_has_squares_of_velocities() {
        assert!(is_sum_of_squares(r"\frac12 m \dot x^2") && is_sum_of_squares(r"\frac{1}{2} m v^{2}"));
        // The twins: a period, a rate that is not squared.
        assert!(!is_sum_of_squares(r"2\pi\sqrt{l/g}") && !is_sum_of_squares(r"\frac12 m \dot x"));
        assert_eq!(value_of("T = 2", "T"), Some(" 2"));
        assert_eq!(value_of("T_1 = 2", "T"), None);
    }
}
