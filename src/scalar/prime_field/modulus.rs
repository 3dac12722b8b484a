//! The prime fields in which identities are decided, each with its unit circle.

use std::sync::OnceLock;

use super::residue::Prime;
use super::unit_circle::UnitCircle;

/// A prime together with the unit circle over its field.
pub trait Modulus: Prime {
    /// The unit circle over the field, computed once.
    fn circle() -> &'static UnitCircle<Self>;
}

/// p = 861·2¹¹⁷ − 1, in which identities are decided. 2, 3, 5, 7, 13, 19 and 23 are squares.
#[derive(Clone, Copy, Debug)]
pub struct FirstPrime;

impl Prime for FirstPrime {
    const ODD: u128 = 861;
    const BITS: u32 = 117;
    const HALVINGS: u32 = 10;
}

impl Modulus for FirstPrime {
    fn circle() -> &'static UnitCircle<Self> {
        static CIRCLE: OnceLock<UnitCircle<FirstPrime>> = OnceLock::new();
        CIRCLE.get_or_init(UnitCircle::new)
    }
}

/// p = 1995·2¹¹⁶ − 1, a second field for what has large coefficients. 2, 3, 5, 7, 11, 13 and 19 are squares.
#[derive(Clone, Copy, Debug)]
pub struct SecondPrime;

impl Prime for SecondPrime {
    const ODD: u128 = 1995;
    const BITS: u32 = 116;
    const HALVINGS: u32 = 10;
}

impl Modulus for SecondPrime {
    fn circle() -> &'static UnitCircle<Self> {
        static CIRCLE: OnceLock<UnitCircle<SecondPrime>> = OnceLock::new();
        CIRCLE.get_or_init(UnitCircle::new)
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// p = 2¹³ − 1, small enough for accidents to be counted; nothing needs the root of 3 there.
    #[derive(Clone, Copy, Debug)]
    pub struct Small;
    impl Prime for Small {
        const ODD: u128 = 1;
        const BITS: u32 = 13;
        const HALVINGS: u32 = 3;
    }

    impl Modulus for Small {
        fn circle() -> &'static UnitCircle<Self> {
            static CIRCLE: OnceLock<UnitCircle<Small>> = OnceLock::new();
            CIRCLE.get_or_init(UnitCircle::new)
        }
    }

    /// p = 483·2⁵⁴ − 1, whose products fit into 128 bits.
    #[derive(Clone, Copy, Debug)]
    pub struct Middle;
    impl Prime for Middle {
        const ODD: u128 = 483;
        const BITS: u32 = 54;
        const HALVINGS: u32 = 10;
    }

    impl Modulus for Middle {
        fn circle() -> &'static UnitCircle<Self> {
            static CIRCLE: OnceLock<UnitCircle<Middle>> = OnceLock::new();
            CIRCLE.get_or_init(UnitCircle::new)
        }
    }
}
