//! Products of vectors in three dimensions, over any number.
//!
//! nalgebra has them for all shapes, and each shape is compiled for each of some twenty numbers.

use nalgebra::Vector3;

use super::Number;

/// a × b
pub(crate) fn cross<D: Number>(a: &Vector3<D>, b: &Vector3<D>) -> Vector3<D> {
    Vector3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

/// a · b
pub(crate) fn dot<D: Number>(a: &Vector3<D>, b: &Vector3<D>) -> D {
    a.x * b.x + a.y * b.y + a.z * b.z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_nalgebras_products() {
        let (a, b) = (Vector3::new(0.3, -1.7, 2.9), Vector3::new(-0.11, 5.3, 0.7));
        assert_eq!(cross(&a, &b), a.cross(&b));
        assert_ne!(cross(&a, &b), b.cross(&a));
        assert_eq!(dot(&a, &b).to_bits(), a.dot(&b).to_bits());
        assert_ne!(dot(&a, &b), a.dot(&a));
    }
}
