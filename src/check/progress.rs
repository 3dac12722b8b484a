//! Who is told how far a run has come. Nothing here prints, and what is told changes no report.

/// Told, from any thread, what there is to do and each item that is done.
pub trait Progress: Sync {
    /// So many equations and sentences of this document are to be checked.
    fn planned(&self, document: &str, items: usize);

    /// One of them is.
    fn done(&self, document: &str);
}

/// Nobody.
impl Progress for () {
    fn planned(&self, _document: &str, _items: usize) {}

    fn done(&self, _document: &str) {}
}
