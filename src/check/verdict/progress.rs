//! The progress of a run, for a caller that shows it. The report does not depend on it.

/// A listener that is called, from any thread, for each finished item.
pub trait Progress: Sync {
    /// Called when an equation or a sentence of this document has its verdict.
    fn done(&self, document: &str);
}

/// Ignores the progress.
impl Progress for () {
    fn done(&self, _document: &str) {}
}
