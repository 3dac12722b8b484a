//! Which letters usually are angles, directions or whole numbers in the argument of a function without parentheses.

use crate::formula::symbols::Name;

use super::super::super::layout::{Item, Layout, parts};
use super::super::super::names;
use super::super::items::{function_head, is_numeric_item};

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
    // `\hat{\boldsymbol{i}}`
    if name.base.starts_with("\\hat{\\mathbf{") || name.base.starts_with("\\mathbf{\\hat{") {
        return true;
    }
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

/// Whether a fraction in an argument has a variable of its own, so that a parenthesis behind it with a sine may be a factor:
/// `\sin\frac{\pi x}{L}(1 - \cos\theta)`. In `\sin\frac{2\pi}{\lambda}(x - ct)` it is a factor of the parenthesis.
pub(super) fn is_whole_argument(argument: &[Item], parenthesis: &Item) -> bool {
    const VARIABLES: [&str; 14] =
        ["x", "y", "z", "r", "t", "s", "u", "\\theta", "\\phi", "\\varphi", "\\eta", "\\xi", "\\tau", "\\zeta"];
    fn varies(items: &[Item]) -> bool {
        items.iter().any(|item| {
            let is_variable =
                names::printed(item, None).is_some_and(|found| VARIABLES.contains(&found.name.base.as_str()));
            is_variable || parts(item).into_iter().any(varies)
        })
    }
    fn has_function(item: &Item) -> bool {
        matches!(function_head(item), Ok(Some(_))) || parts(item).into_iter().flatten().any(has_function)
    }
    let fraction = argument.iter().find(|item| matches!(item.layout, Layout::Fraction(..)) && !is_numeric_item(item));
    fraction.is_some_and(|fraction| varies(std::slice::from_ref(fraction)) || has_function(parenthesis))
}
