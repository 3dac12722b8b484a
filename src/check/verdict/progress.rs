//! The progress of a run, for whoever wants to show it. Nothing here prints, and no report depends on it.

/// Told, from any thread, of each item that is done.
pub trait Progress: Sync {
    /// An equation or a sentence of this document has its verdict.
    fn done(&self, document: &str);
}

/// Nobody.
impl Progress for () {
    fn done(&self, _document: &str) {}
}
