//! Who is told how far a run has come. Nothing here prints, and what is told changes no report.

/// Told, from any thread, of each item that is done.
pub trait Progress: Sync {
    /// An equation or a sentence of this document has its verdict.
    fn done(&self, document: &str);
}

/// Nobody.
impl Progress for () {
    fn done(&self, _document: &str) {}
}
