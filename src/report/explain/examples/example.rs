//! The form of an example.

/// Files for which a command reports a verdict or a code.
pub(crate) struct Example {
    /// The word of the verdict, of the outcome or of the code.
    pub word: &'static str,
    /// The command, in the folder of the files.
    pub command: &'static str,
    /// The name and the text of each file; there is none where the example is that a file is not there.
    pub files: &'static [(&'static str, &'static str)],
}
