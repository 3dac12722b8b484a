//! What a display may mean in two ways as a whole, which is refused before it is read.
//!
//! | file | what is refused there |
//! | --- | --- |
//! | `derivatives` | Laplacians that look like differences, and derivatives that look like labels |
//! | `pairing` | differentials behind several integral signs that may belong to these in two orders |
//! | `unit_remarks` | the unit of a quantity in parentheses behind its name |
//! | `variations` | δ before an integral in a display where it is a quantity |

mod derivatives;
mod pairing;
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
}
