//! What is noted of one name.

use crate::formula::symbols::Name;

/// How a name stands in the displays of a document.
#[derive(Clone, Debug)]
pub(crate) struct Usage {
    /// The name.
    pub name: Name,
    /// Whether it stands somewhere with a dot, or after d in d/dt.
    pub moves: bool,
    /// Whether it stands under a root, in a denominator or in a logarithm.
    pub positive: bool,
    /// Whether it is said to be the opposite of another name, as in `R_2 = -R_1`.
    pub opposite: bool,
    /// Whether it stands alone between bars, as E in |E|.
    pub modulus: bool,
    /// Whether it stands alone in a sine or a cosine.
    pub angle: bool,
    /// Whether it stands before the time, a place or a parenthesis in a sine: ω in sin ωt, k in sin k(x − a). Then it is no angle.
    pub scales: bool,
    /// Whether it stands alone on one side of a relation whose other side moves.
    pub follows: bool,
    /// Whether it stands in a formula that is said to be constant, and not in an exponent.
    pub conserved: bool,
    /// Whether it stands in an exponent of another name than e.
    pub raises: bool,
    /// The names of which it is the product, where a display says so.
    pub product: Option<Vec<Name>>,
    /// Whether it is all of a numerator or a denominator.
    pub divides: bool,
    /// Whether it stands directly before another name somewhere, as the d of dx does.
    pub precedes: bool,
    /// Whether something is differentiated by it, or by its rate.
    pub differentiates: bool,
    /// The names by which it is differentiated with d, other than the time: x for `\frac{dM}{dx}`.
    pub differentiated_by: Vec<Name>,
    /// Whether it has an exponent other than a whole number, as Euler's number does.
    pub exponential: bool,
    /// The first display with it.
    pub first: usize,
    /// The first display that gives it a formula: as its whole left side, or at the end of a chain.
    pub introduced: Option<usize>,
    /// Whether it is the left side of a relation somewhere, alone or with its arguments.
    pub given: bool,
    /// Whether each of these left sides is a power of it: `\omega^2 = …`.
    pub only_a_power: bool,
    /// The names in parentheses directly after it.
    pub arguments: Option<Vec<Name>>,
}

/// The entry of a name, which is first met in display `at` if it has none.
pub(super) fn entry<'f>(found: &'f mut Vec<Usage>, name: &Name, at: usize) -> &'f mut Usage {
    let place = found.iter().position(|usage| usage.name == *name).unwrap_or_else(|| {
        found.push(Usage {
            name: name.clone(),
            moves: false,
            positive: false,
            opposite: false,
            modulus: false,
            angle: false,
            scales: false,
            follows: false,
            conserved: false,
            raises: false,
            product: None,
            divides: false,
            precedes: false,
            differentiates: false,
            differentiated_by: Vec::new(),
            exponential: false,
            first: at,
            introduced: None,
            given: false,
            only_a_power: false,
            arguments: None,
        });
        found.len() - 1
    });
    &mut found[place]
}
