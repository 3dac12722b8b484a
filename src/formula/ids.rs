//! Identifiers of symbols and of indices, which the symbol table and the formula tree share.

/// The position of a symbol in the symbol table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SymbolId(pub usize);

/// The position of a declared index letter in [`Symbols::indices`](super::Symbols::indices).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct IndexId(pub usize);

/// An index of a symbol: a letter, or a fixed value counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Index {
    /// A declared index letter.
    Letter(IndexId),
    /// A fixed value.
    Fixed(u8),
}

/// A symbol, or one of its rates, that a formula depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The symbol.
    pub id: SymbolId,
    /// Its indices, which are numbers.
    pub indices: Vec<Index>,
    /// The number of its dots.
    pub dots: u8,
}
