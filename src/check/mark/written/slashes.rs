//! Products below a slash, `b/2m` and `r^2/GM`, which people read in one way.

use crate::latex::foreign::products_in_lines;
use crate::source::Span;

use super::Written;
use super::units::is_upright;

/// Encloses the products below slashes.
pub(in crate::check::mark) fn with_products(lines: &mut [Written]) {
    for line in lines {
        let edits = products_in_lines(&line.text);
        let pairs = edits.chunks_exact(2).filter(|pair| !is_upright(&line.text, pair[0].0.start));
        let new: Vec<(Span, String)> = pairs.flatten().cloned().collect();
        line.edits.extend(new);
    }
}
