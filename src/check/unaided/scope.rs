//! A part of the notes in which each letter keeps its meaning.

/// The displays in which letters have one meaning.
pub(super) struct Scope {
    /// The number of displays before it that are carried over.
    pub carried: usize,
    /// The displays with which a section begins, in order; those that are carried over count.
    pub sections: Vec<usize>,
}

impl Scope {
    /// All displays of notes as one scope.
    pub fn whole() -> Scope {
        Scope { carried: 0, sections: Vec::new() }
    }

    /// The first display of the section in which the `at`-th display is.
    pub fn section_of(&self, at: usize) -> usize {
        self.sections.iter().copied().rfind(|start| *start <= at).unwrap_or(self.carried).max(self.carried)
    }
}
