//! Quantities of two units that are one where constants of nature are 1: a second and 3·10⁸ metres, a kelvin and 0.086 meV.

use crate::formula::units::{Dimension, Ratio};

use super::quantity::Quantity;

/// c, ħ, G and k in units of the SI.
const CONSTANTS: [f64; 4] = [299_792_458.0, 1.054_571_817e-34, 6.674e-11, 1.380_649e-23];

/// How far apart values may be.
const NEAR: f64 = 0.1;

/// Whether two quantities with different units are equal where c, ħ or G, and k are 1.
pub(super) fn are_equal(a: Quantity, b: Quantity) -> bool {
    let between = a.dimension.times(b.dimension.power(Ratio::whole(-1)));
    let Some([kg, m, s, ampere, kelvin, mol, cd]) = exponents(between) else { return false };
    if ampere != 0 || mol != 0 || cd != 0 {
        return false;
    }
    // A kelvin by a joule is 1/k.
    let (kg, m, s) = (kg + kelvin, m + 2 * kelvin, s - 2 * kelvin);
    let by_action = (kg, m - 2 * kg, -s - kg, 1);
    let by_gravity = (-kg, m + 3 * kg, -s + 2 * kg, 2);
    [by_action, by_gravity].into_iter().any(|(power, of_c, again, constant)| {
        let factor = CONSTANTS[0].powi(of_c) * CONSTANTS[constant].powi(power) * CONSTANTS[3].powi(-kelvin);
        let expected = b.value * factor;
        of_c == again && (a.value - expected).abs() <= NEAR * a.value.abs().max(expected.abs())
    })
}

fn exponents(dimension: Dimension) -> Option<[i32; 7]> {
    let mut found = [0; 7];
    for (place, exponent) in dimension.0.iter().enumerate() {
        found[place] = i32::try_from(exponent.as_whole()?).ok()?;
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use crate::formula::units::parse;
    use crate::scalar::interval::Interval;

    use super::*;

    fn quantity(value: f64, unit: &str) -> Quantity {
        Quantity { value, range: Interval::point(value), dimension: parse(unit).unwrap() }
    }

    #[test]
    fn constants_of_nature_relate_units() {
        for (a, b) in [
            (quantity(1.0, "s"), quantity(3.0e8, "m")),
            (quantity(1.67e-27, "kg"), quantity(1.503e-10, "J")),
            (quantity(300.0, "K"), quantity(4.14e-21, "J")),
            (quantity(1.99e30, "kg"), quantity(1477.0, "m")),
            (quantity(1.602e-10, "J"), quantity(5.07e15, "m^-1")),
        ] {
            assert!(are_equal(a, b) && are_equal(b, a), "{a:?} {b:?}");
        }
        // The twins: another number, and no constants of nature.
        assert!(!are_equal(quantity(2.0, "s"), quantity(3.0e8, "m")));
        assert!(!are_equal(quantity(5.0, "kg"), quantity(5.0, "m")));
        assert!(!are_equal(quantity(1.0, "A"), quantity(1.0, "kg")));
    }
}
