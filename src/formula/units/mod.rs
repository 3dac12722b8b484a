//! Units and dimensional analysis: whether the terms of a formula can be added.
//!
//! A [`Dimension`] is the exponents of the seven base units. [`parse`](fn@parse) reads one from SI text, the
//! [`inference`] infers those that nobody declared, and [`check`] walks a formula and names the term that does not
//! fit.
//!
//! The dimensions here are values, known when the program runs. The established crates (uom, dimensioned) make them
//! types, known when it is compiled; those that have values (rink) are calculators under a licence that does not fit
//! this one. What is needed is seven rational exponents and elimination, hence a type of our own. To a dimension scale
//! does not matter: a kilometre and a millimetre have the same. The size of a [`Unit`] that stands after a number in a
//! formula is in [`printed`].
//!
//! Knows the tree and the symbols of `formula`.

#[cfg(feature = "notes")]
pub mod check;
#[cfg(feature = "notes")]
pub mod in_si;
#[cfg(feature = "notes")]
pub mod inference;
pub mod parse;
pub mod printed;
pub mod ratio;

use std::fmt;

#[cfg(feature = "notes")]
pub use check::{Mismatch, UnitCheck};
#[cfg(feature = "notes")]
pub use inference::{Affine, Inference};
pub use parse::parse;
pub use printed::Unit;
pub use ratio::Ratio;

/// The base units of the SI, in the order in which a product of them is printed.
pub const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// The exponents of the [`BASE`] units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension(pub [Ratio; 7]);

impl Dimension {
    /// That of a number.
    pub const NONE: Dimension = Dimension([Ratio::ZERO; 7]);
    /// That of a length.
    pub const LENGTH: Dimension = Dimension::of(0, 1, 0);
    /// That of a time.
    pub const TIME: Dimension = Dimension::of(0, 0, 1);

    /// kgᵃ mᵇ sᶜ.
    pub const fn of(mass: i64, length: i64, time: i64) -> Dimension {
        Dimension::with_current(mass, length, time, 0)
    }

    /// kgᵃ mᵇ sᶜ Aᵈ.
    pub const fn with_current(mass: i64, length: i64, time: i64, current: i64) -> Dimension {
        let mut exponents = [Ratio::ZERO; 7];
        exponents[0] = Ratio::whole(mass);
        exponents[1] = Ratio::whole(length);
        exponents[2] = Ratio::whole(time);
        exponents[3] = Ratio::whole(current);
        Dimension(exponents)
    }

    /// That of a base unit, by its place in [`BASE`].
    pub const fn base(place: usize) -> Dimension {
        let mut exponents = [Ratio::ZERO; 7];
        exponents[place] = Ratio::ONE;
        Dimension(exponents)
    }

    /// That of a product.
    pub fn times(self, other: Dimension) -> Dimension {
        Dimension(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }

    /// That of a power.
    pub fn power(self, exponent: Ratio) -> Dimension {
        Dimension(self.0.map(|own| own * exponent))
    }

    /// Whether it is that of a number.
    pub fn is_none(&self) -> bool {
        *self == Dimension::NONE
    }
}

impl fmt::Display for Dimension {
    /// As in `kg m² s⁻²`; 1 for that of a number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_none() {
            return f.write_str("1");
        }
        let factors = BASE.iter().zip(self.0).filter(|(_, exponent)| !exponent.is_zero());
        let shown: Vec<String> = factors.map(|(unit, exponent)| format!("{unit}{}", raised(exponent))).collect();
        f.write_str(&shown.join(" "))
    }
}

/// A unit with a whole power, as it stands in a [`Dimension`]: `s⁻²`.
#[cfg(feature = "notes")]
pub(crate) fn power_of_unit(unit: &str, power: i32) -> String {
    let power = if power == 1 { String::new() } else { power.to_string() };
    format!("{unit}{}", power.chars().map(superscript).collect::<String>())
}

/// An exponent as it stands behind a unit: `²`, `⁻¹`, `^(1/2)`, nothing for 1.
fn raised(exponent: Ratio) -> String {
    match exponent.as_whole() {
        Some(1) => String::new(),
        Some(whole) => whole.to_string().chars().map(superscript).collect(),
        None => format!("^({exponent})"),
    }
}

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

fn superscript(c: char) -> char {
    c.to_digit(10).map_or('⁻', |digit| SUPERSCRIPTS[digit as usize])
}
