//! A part of the notes in which each letter keeps its meaning.

/// The displays in which letters have one meaning.
pub(super) struct Scope {
    /// The number of displays before it that are carried over.
    pub carried: usize,
    /// The displays with which a section begins, in order; those that are carried over count.
    pub sections: Vec<usize>,
    /// The chains of the displays at the end of the notes that are an equality of one each.
    pub origins: Vec<usize>,
}

impl Scope {
    /// All displays of notes as one scope.
    pub fn whole() -> Scope {
        Scope { carried: 0, sections: Vec::new(), origins: Vec::new() }
    }

    /// The place at which a display of notes with this many counts: that of its chain, if it is an equality of one.
    pub fn origin_of(&self, at: usize, displays: usize) -> usize {
        let first = displays - self.origins.len();
        at.checked_sub(first).and_then(|place| self.origins.get(place)).copied().unwrap_or(at)
    }

    /// The first display of the section in which the `at`-th display is.
    pub fn section_of(&self, at: usize) -> usize {
        self.sections.iter().copied().rfind(|start| *start <= at).unwrap_or(self.carried).max(self.carried)
    }
}
