//! Notation of algebra: matrices, complex numbers, cases, brackets.
//!
//! | file | what is read there |
//! | --- | --- |
//! | `matrices` | `\det`, `\operatorname{tr}`, `\operatorname{diag}`, unit matrices, entries `M_{12}`, what stands above a matrix |
//! | `complex` | i, `\Re`, `\Im`, conjugates |
//! | `cases` | `cases`, and the conditions of a statement |
//! | `brackets` | `[A, B]` of matrices |
//! | `poisson` | `\{f, g\}`, `[f, g]_{q,p}` |
//! | `engineering` | whether j is √−1 |
//! | `imaginary` | whether i is √−1 |
//! | `evidence` | without declarations: which letters are vectors, matrices or complex, from what the display says |
//!
//! Offers `algebra`, the factor that such a notation is, as a method of the reader. Knows the layout and the state of the reader.

mod brackets;
mod cases;
mod complex;
mod engineering;
pub mod evidence;
mod imaginary;
mod matrices;
mod poisson;

#[cfg(feature = "notes")]
pub use imaginary::has_imaginary_unit;
pub use poisson::pairs_by_name;

pub(super) use matrices::{is_matrix, operator_word};

use crate::formula::tree::Expr;

use super::super::layout::Item;
use super::state::{Read, Reader};

impl Reader<'_> {
    /// A factor in the notation of algebra, if one begins here.
    pub(super) fn algebra(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        if let Some(found) = self.of_matrix(items, cursor)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.complex_part(items, cursor)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.poisson(items, cursor)? {
            return Ok(Some(found));
        }
        self.bracket(items, cursor)
    }
}
