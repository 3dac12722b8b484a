//! Shorter expressions for the same function (to be written).
use super::Symbol;
/// one
pub fn simplify(s: Symbol) -> Symbol {
    s
}
/// all
pub fn simplify_all(s: &[Symbol]) -> Vec<Symbol> {
    s.to_vec()
}
