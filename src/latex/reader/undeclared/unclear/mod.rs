//! What a display may mean in two ways as a whole, which is refused before it is read.
//!
//! | file | what is refused there |
//! | --- | --- |
//! | `bold_differentials` | a bold d before a letter, `T\mathbf{d}S` |
//! | `derivatives` | Laplacians that look like differences, and derivatives that look like labels |
//! | `functions` | a letter before a letter in parentheses, `E(A)`, for which the display is solved |
//! | `italic_units` | a letter behind a number that is the unit of the left side, `t = 3 s` |
//! | `letters` | names of numbers without a unit, words between equations, names under an arrow |
//! | `pairing` | differentials behind several integral signs that may belong to these in two orders |
//! | `sides` | nothing: it gives the statements of a display as lists of items |
//! | `unit_remarks` | the unit of a quantity in parentheses behind its name |
//! | `variations` | δ before an integral in a display where it is a quantity |

mod bold_differentials;
mod derivatives;
mod functions;
mod italic_units;
mod letters;
mod pairing;
mod sides;
mod unit_remarks;
mod variations;

use crate::source::Fault;

use super::super::super::layout::Item;

/// Why a display may mean two things.
pub(in super::super::super) fn unclear(items: &[Item]) -> Option<Fault> {
    derivatives::unclear_derivative(items)
        .or_else(|| pairing::unclear_pairing(items))
        .or_else(|| unit_remarks::unclear_unit(items))
        .or_else(|| variations::unclear_variation(items))
        .or_else(|| bold_differentials::unclear_differential(items))
        .or_else(|| functions::unclear_function(items))
        .or_else(|| italic_units::unclear_unit(items))
        .or_else(|| letters::unclear_letters(items))
}
