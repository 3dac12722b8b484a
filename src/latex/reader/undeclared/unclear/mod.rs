//! What a display may mean in two ways as a whole, which is refused before it is read.
//!
//! | file | what is refused there |
//! | --- | --- |
//! | `derivatives` | Laplacians that look like differences, and derivatives that look like labels |
//! | `pairing` | differentials behind several integral signs that may belong to these in two orders |

mod derivatives;
mod pairing;

pub(in super::super::super) use derivatives::unclear_derivative;
pub(in super::super::super) use pairing::unclear_pairing;
