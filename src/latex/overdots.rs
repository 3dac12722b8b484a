//! Overdots: `\dot x`, `\ddot x` and `\dddot x` are time derivatives of x; that of a name is read in [`super::names`], with [`order`].
//!
//! [`order`] reads them and [`accent`] writes them. `reader/atoms.rs` makes a time derivative of a dotted group. `\frac{d}{dt}` is read in [`super::reader`], file `derivatives.rs`.

/// The commands, by the number of their dots less one.
const ACCENTS: [&str; 3] = ["\\dot", "\\ddot", "\\dddot"];

/// The order of the time derivative that a command is; `None` for a command that is no overdot.
pub(super) fn order(command: &str) -> Option<u8> {
    ACCENTS.iter().zip(1..).find(|(accent, _)| **accent == command).map(|(_, order)| order)
}

/// The command for a time derivative of this order, from 1 to 3.
pub(super) fn accent(order: u8) -> Option<&'static str> {
    ACCENTS.get(usize::from(order).checked_sub(1)?).copied()
}
