//! Gaussian elimination of M a = −h for a symmetric mass matrix M, without exchange of rows, as it is traced. Only `tracing` uses
//! it, for the program of the fast accelerations.

use super::layout::Layout;
use crate::mechanics::tape::Tape;
use crate::scalar::{Node, Number, Symbol};

/// The place of M_ij in the upper triangle, stored row by row.
pub(super) fn upper(n: usize, i: usize, j: usize) -> usize {
    let (i, j) = (i.min(j), i.max(j));
    i * n - i * (i + 1) / 2 + j
}

/// The diagonal entries of the mass matrix in the order in which they become pivots: first those that no state changes,
/// which are inverted once and for all, as one would by hand.
pub(super) fn pivots(layout: Layout, mass: impl Fn(usize) -> Tape) -> Vec<usize> {
    let varies = |&k: &usize| {
        let entry = mass(k);
        (0..layout.v(layout.coordinates)).any(|input| entry.reads(input))
    };
    let (varying, uniform): (Vec<usize>, Vec<usize>) = (0..layout.coordinates).partition(varies);
    [uniform, varying].concat()
}

/// Whether a number is a product of inputs and functions of inputs: such a pivot has lost no digits, however small it
/// is.
pub(super) fn is_product(number: Symbol) -> bool {
    match number.node() {
        Node::Constant(_) | Node::Input(_) => true,
        Node::Mul(a, b) => is_product(Symbol::at(a)) && is_product(Symbol::at(b)),
        Node::Neg(a) | Node::Recip(a) | Node::Powi(a, _) | Node::Powf(a, _) => is_product(Symbol::at(a)),
        Node::Apply(_, a) => matches!(Symbol::at(a).node(), Node::Input(_)),
        Node::Add(..) | Node::Sub(..) | Node::Atan2(..) => false,
    }
}

/// Solves M a = −h for a symmetric M by elimination, with the diagonal entries as pivots in the given order.
///
/// `mass` is the upper triangle of M row by row, `bias` is h. Nearly all mass matrices can be solved in this way; the
/// caller checks the pivots. The entries that remain after each pivot are simplified together, as long as that makes
/// them shorter. Returns a, then for each pivot in order the pivot and its original diagonal entry.
pub(super) fn eliminate<D: Number>(
    order: &[usize],
    mass: &[D],
    bias: &[D],
    simplify: impl Fn(&[D], &[D]) -> Option<Vec<D>>,
) -> Vec<D> {
    let n = order.len();
    let (mut left, mut right) = (mass.to_vec(), bias.iter().map(|&h| -h).collect::<Vec<D>>());
    let mut rows = Vec::with_capacity(n);
    let mut is_worth_it = true;
    for (done, &k) in order.iter().enumerate() {
        let shorter = |values: Vec<D>, beside: &[&[D]]| {
            let simple = if is_worth_it { simplify(&values, &beside.concat()) } else { None };
            simple.unwrap_or(values)
        };
        let rest = &order[done + 1..];
        let pivot = left[upper(n, k, k)];
        let inverse = pivot.recip();
        let factors: Vec<D> = rest.iter().map(|&i| left[upper(n, i, k)] * inverse).collect();
        let factors = shorter(factors, &[&left, &right]);
        for (&i, &factor) in rest.iter().zip(&factors) {
            right[i] = right[i] - factor * right[k];
            for &j in rest.iter().filter(|&&j| j >= i) {
                left[upper(n, i, j)] = left[upper(n, i, j)] - factor * left[upper(n, j, k)];
            }
        }
        right[k] = shorter(vec![right[k] * inverse], &[&left, &right, &factors])[0];
        let places: Vec<usize> = rest
            .iter()
            .flat_map(|&i| rest.iter().map(move |&j| (i, j)))
            .filter(|(i, j)| i <= j)
            .map(|(i, j)| upper(n, i, j))
            .collect();
        let remaining: Vec<D> = places.iter().map(|&at| left[at]).chain(rest.iter().map(|&i| right[i])).collect();
        let simple = if is_worth_it { simplify(&remaining, &[&factors[..], &[right[k]]].concat()) } else { None };
        is_worth_it = simple.is_some();
        let (matrix, vector) = simple.as_ref().unwrap_or(&remaining).split_at(places.len());
        places.iter().zip(matrix).for_each(|(&at, &entry)| left[at] = entry);
        rest.iter().zip(vector).for_each(|(&i, &entry)| right[i] = entry);
        rows.push((pivot, factors));
    }
    let mut a = right;
    for (done, &k) in order.iter().enumerate().rev() {
        let others = order[done + 1..].iter().zip(&rows[done].1);
        a[k] = others.fold(a[k], |sum, (&i, &factor)| sum - factor * a[i]);
    }
    a.extend(rows.iter().zip(order).flat_map(|((pivot, _), &k)| [*pivot, mass[upper(n, k, k)]]));
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_upper_triangle_is_stored_row_by_row() {
        let places: Vec<usize> = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|(i, j)| upper(3, i, j)).into();
        assert_eq!(places, [0, 1, 2, 3, 4, 5]);
        assert_eq!(upper(3, 2, 1), upper(3, 1, 2));
    }

    #[test]
    fn elimination_solves_and_shows_its_pivots() {
        // M = ((4, 2), (2, 3)), h = (−8, −7): a = (1.25, 1.5)
        assert_eq!(eliminate(&[0, 1], &[4.0, 2.0, 3.0], &[-8.0, -7.0], |_, _| None), [1.25, 1.5, 4.0, 4.0, 2.0, 3.0]);
        // in whatever order: M = ((4, 2), (2, 2)), h = (−8, −6): a = (1, 2)
        for order in [[0, 1], [1, 0]] {
            assert_eq!(eliminate(&order, &[4.0, 2.0, 2.0], &[-8.0, -6.0], |_, _| None)[..2], [1.0, 2.0]);
            assert_ne!(eliminate(&order, &[4.0, 1.0, 2.0], &[-8.0, -6.0], |_, _| None)[..2], [1.0, 2.0]);
        }
        // a singular one is seen at its last pivot
        assert_eq!(eliminate(&[0, 1], &[1.0, 1.0, 1.0], &[1.0, 2.0], |_, _| None)[4], 0.0);
    }
}
