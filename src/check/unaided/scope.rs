//! A part of the notes in which each letter keeps its meaning.

/// The displays in which letters have one meaning.
pub(super) struct Scope {
    /// The number of displays before it that are carried over.
    pub carried: usize,
    /// The displays with which a section begins, in order; those that are carried over count.
    pub sections: Vec<usize>,
    /// The equalities of chains that are displays at the end of the notes, in their order.
    pub links: Vec<Link>,
    /// The places of the displays that print the rate or derivative of a formula which stands beside them.
    pub evaluated: Vec<usize>,
}

/// An equality of a chain that is a display of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Link {
    /// The place of the chain.
    pub chain: usize,
    /// Whether it comes after the first equality: then the author says that it follows.
    pub is_later: bool,
}

impl Scope {
    /// All displays of notes as one scope.
    pub fn whole() -> Scope {
        Scope { carried: 0, sections: Vec::new(), links: Vec::new(), evaluated: Vec::new() }
    }

    /// The place at which a display of notes with this many counts: that of its chain, if it is an equality of one.
    pub fn origin_of(&self, at: usize, displays: usize) -> usize {
        self.link(at, displays).map_or(at, |link| link.chain)
    }

    /// The equality of a chain that a display of notes with this many is, if it is one.
    pub fn link(&self, at: usize, displays: usize) -> Option<Link> {
        let first = displays - self.links.len();
        at.checked_sub(first).and_then(|place| self.links.get(place)).copied()
    }

    /// The first display of the section in which the `at`-th display is.
    pub fn section_of(&self, at: usize) -> usize {
        self.sections.iter().copied().rfind(|start| *start <= at).unwrap_or(self.carried).max(self.carried)
    }
}
