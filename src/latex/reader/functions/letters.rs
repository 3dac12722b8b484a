//! Which letters usually are angles, directions or whole numbers in the argument of a function without parentheses.

use crate::formula::symbols::Name;

use super::super::super::layout::{Item, Layout};

/// Whether a letter usually is an angle.
pub(super) fn is_letter_of_an_angle(name: &Name) -> bool {
    ["\\theta", "\\vartheta", "\\phi", "\\varphi", "\\alpha", "\\beta"].contains(&name.base.as_str())
}

/// Whether a letter is an angle in some notes.
pub(super) fn is_usual_angle(name: &Name) -> bool {
    is_letter_of_an_angle(name)
        || [
            "\\psi",
            "\\chi",
            "\\gamma",
            "\\delta",
            "\\epsilon",
            "\\varepsilon",
            "\\Theta",
            "\\Phi",
            "\\Psi",
            "i",
            "A",
            "B",
        ]
        .contains(&name.base.as_str())
}

/// Whether a name is a vector by its markup: bold, with an arrow, or a unit vector along a direction.
pub(super) fn is_direction(name: &Name) -> bool {
    const DIRECTIONS: [&str; 12] = ["i", "j", "k", "x", "y", "z", "r", "e", "n", "\\theta", "\\phi", "\\varphi"];
    let hat = name.base.strip_prefix("\\hat{").and_then(|base| base.strip_suffix('}'));
    let is_small = |letter: &str| letter.starts_with(|c: char| c.is_lowercase());
    let bold = name.base.strip_prefix("\\mathbf{").or_else(|| name.base.strip_prefix("\\vec{"));
    hat.is_some_and(|letter| DIRECTIONS.contains(&letter)) || bold.is_some_and(is_small)
}

/// Whether a letter counts something, n, m, k or ℓ: nobody takes the cosine of it alone. So `\cos n\theta` has both in its argument.
pub(super) fn is_whole_number(name: &Name) -> bool {
    ["n", "m", "k", "\\ell"].contains(&name.base.as_str()) && name.subscript.is_empty() && name.primes == 0
}

/// Whether a letter is a place or an angle, which a whole number before it multiplies.
pub(super) fn is_counted(name: &Name) -> bool {
    let is_place = ["x", "y", "z", "r"].contains(&name.base.as_str());
    (is_place || is_letter_of_an_angle(name)) && name.subscript.is_empty() && name.primes == 0
}

/// Whether a letter is an angle that nobody takes for a frequency as a rule: `v\cos\theta t` is a speed times the time.
pub(super) fn is_no_frequency(name: &Name) -> bool {
    is_letter_of_an_angle(name) && name.base != "\\beta" || name.base == "\\psi"
}

pub(super) fn is_pi(item: &Item) -> bool {
    item.layout == Layout::Command("\\pi".to_owned())
}
