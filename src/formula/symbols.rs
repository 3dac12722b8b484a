//! The symbol table: the name, the kind and the indices of each symbol of a document.
//!
//! A name is a base (with its accents), the tokens of its subscript, and its primes. Overdots and powers are not part
//! of a name. A subscript with declared index letters makes the name a family: `\hat e_a` stands for three vectors, and
//! `\hat e_2` and `\hat e_b` are found as well. The meaning of a symbol (a coordinate, the Lagrangian, …) is not stored
//! here; `check` stores it by [`SymbolId`].

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use crate::suggest;

use super::ids::{Index, IndexId, Variable};
pub use super::name::{Inferred, Kind, Name};
pub use super::operators::Operator;
use super::tree::{Expr, Node};

pub use super::ids::SymbolId;

/// One symbol.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The name; of a family, with the index letters of its declaration.
    pub name: Name,
    /// The kind of value, for each value of the indices.
    pub kind: Kind,
    /// The index slots of the subscript: the position of each token, and the letter in the declaration.
    pub slots: Vec<(usize, IndexId)>,
    /// Whether it is declared as an angle. The argument of a function without parentheses ends after an angle.
    pub angle: bool,
    /// Whether it varies with time or is the time itself.
    pub varies: bool,
    /// The arguments of a function, by which its formula is written; empty for anything else.
    pub arguments: Vec<Variable>,
    /// The derivatives of a function by its arguments, where they are symbols of their own.
    pub derivatives: Vec<SymbolId>,
    /// The formula that defines it, or its square.
    pub definition: Option<Arc<Expr>>,
    /// Whether it stands for a formula that is not read, such as ⟨E⟩. What that depends on is not known.
    pub unread: bool,
    /// Whether it is defined by a formula in which nothing varies.
    pub steady: bool,
    /// Whether its value follows from the coordinates and velocities by no formula that is known here.
    pub derived: bool,
    /// Whether it is a coefficient of an arbitrary function, which no author writes.
    pub hidden: bool,
    /// The function without a formula of whose polynomial it is a coefficient.
    pub coefficient: Option<Arc<AnyFunction>>,
    /// Whether the display that defines it says that it is constant; a derivative by a symbol leaves it fixed.
    pub conserved: bool,
    /// Whether it was the letter of a sum or an integral, which occurs in no formula after that.
    pub bound: bool,
    /// Whether it is a momentum, which a derivative of a Hamiltonian takes for a variable of its own.
    pub momentum: bool,
    /// The argument that may follow in parentheses without a change of meaning: the `\vec{r}` of `\rho(\vec r)`.
    pub argument: Option<Name>,
    /// Whether it is defined by its square, `\omega_{eff}^2 = …`, and stands for the square.
    pub squared: bool,
    /// The members of an assembled family, such as λ₁, λ₂, λ₃ for λ_a.
    pub members: Vec<SymbolId>,
    /// The dimension of a continuum: 3 for a volume, 2 for an area, 1 for a length; `None` for anything else.
    pub measure: Option<u8>,
    /// The density of the continuum, used for a mass element `dm`.
    pub density: Option<SymbolId>,
    /// The axes of a vector's components, if they are declared.
    pub components: Option<Components>,
    /// What it makes of the arguments after it, where it is a function or an operator without a formula.
    pub operator: Option<Operator>,
}

impl Entry {
    /// Whether no author writes the symbol as one: a coefficient of an arbitrary function, or a derivative.
    pub fn is_composed(&self) -> bool {
        self.hidden || self.name.base.starts_with("\\frac")
    }

    /// Whether it is a momentum, by its meaning or by its letter.
    pub fn is_momentum(&self) -> bool {
        self.momentum || matches!(self.name.base.as_str(), "p" | "P")
    }
}

/// The coefficients of the polynomial that stands for a function without a formula: Σ c x^a y^b / (a! b!).
#[derive(Debug, PartialEq, Eq)]
pub struct AnyFunction {
    /// Its name.
    pub name: Name,
    /// Each coefficient with the exponents of the arguments; the one without any comes first.
    pub terms: Vec<(SymbolId, Vec<u32>)>,
    /// The largest sum of exponents.
    pub degree: u32,
}

/// The axes of a vector's components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Components {
    /// Along three unit vectors, a family with one slot: `\omega_a` is **ω** · **ê**_a.
    Along(SymbolId),
    /// Along the fixed axes.
    Fixed,
}

/// A declared index letter.
#[derive(Clone, Debug)]
pub struct IndexEntry {
    /// The letter, as LaTeX.
    pub letter: String,
    /// The largest value; the smallest is 1. If `count` is given, the largest possible value.
    pub upper: u8,
    /// The symbol of the largest value, if it is not a fixed number.
    pub count: Option<SymbolId>,
    /// Whether it is a label of particles, which is never summed over by repetition.
    pub labels: bool,
}

/// The symbol table of a document.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    entries: Vec<Entry>,
    exact: HashMap<Name, SymbolId>,
    /// The index letters.
    pub indices: Vec<IndexEntry>,
    /// The name of the independent variable, `t` unless declared.
    pub time: Option<Name>,
    /// The names that are declared as √−1.
    pub imaginary: Vec<Name>,
    /// Whether the display that is being read shows that i is √−1.
    pub imaginary_here: bool,
    /// Whether the display that is read leaves no doubt that j is √−1, as engineers write it.
    pub imaginary_j_here: bool,
    /// Whether an unknown name is added as a real number (formulas without a file). If false, it is a fault
    /// (documents).
    pub open: bool,
    /// Whether the declarations are guesses, so that nothing may be read by them that people read in two ways.
    pub guessed: bool,
    /// Whether a display of which parts have no value, such as operators and tensors, may be read for its structure.
    pub may_be_abstract: bool,
    /// Whether a number with a unit defines the name beside it. First the names are sought that formulas define.
    pub quantities_define: bool,
    /// The index that is added to unknown names without one, as in an equation for each particle.
    pub for_each: Option<IndexId>,
    /// Names that were understood without a declaration, with their meaning: `r_i` for |r⃗_i|.
    pub derived: BTreeMap<String, String>,
    /// The coordinates of the document, each with the names that are known to be its momentum.
    pub canonical: Vec<(SymbolId, Vec<SymbolId>)>,
    /// What the use of letters shows, in formulas without declarations.
    pub inferred: Inferred,
}

impl Symbols {
    /// A name in a formula, or in the formulas of its names, that stands for a formula which is not read.
    pub fn unread_in(&self, formula: &Expr) -> Option<SymbolId> {
        // A text that is only tried may define a name by itself.
        let own = formula.symbols().into_iter().map(|(id, _)| id);
        let mut all = own.flat_map(|id| std::iter::once(id).chain(self.variables_of(id).into_iter().map(|(id, _)| id)));
        all.find(|id| self.entry(*id).unread)
    }

    /// The names in the formula that defines a symbol, with their dots, and those in the formulas of these names.
    pub fn variables_of(&self, id: SymbolId) -> Vec<(SymbolId, u8)> {
        let own = |id: SymbolId| self.entry(id).definition.iter().flat_map(|formula| formula.symbols()).collect();
        let (mut found, mut at): (Vec<(SymbolId, u8)>, usize) = (own(id), 0);
        while let Some((next, _)) = found.get(at).copied() {
            at += 1;
            let inner: Vec<(SymbolId, u8)> = own(next);
            let new = inner.into_iter().filter(|one| !found.contains(one)).collect::<Vec<_>>();
            found.extend(new);
        }
        found
    }

    /// An empty table that rejects unknown names. The independent variable is `t`.
    pub fn new() -> Self {
        Symbols { time: Some(Name::plain("t")), ..Symbols::default() }
    }

    /// An empty table that adds every unknown letter as a real number. The independent variable is `t`.
    pub fn open() -> Self {
        Symbols { open: true, ..Symbols::new() }
    }

    /// As [`Symbols::open`], for reading only: what has no value is read for its structure.
    pub fn for_reading() -> Self {
        Symbols { may_be_abstract: true, ..Symbols::open() }
    }

    /// Whether a display is being read for its structure, and nothing in it needs a value.
    pub fn is_abstract(&self) -> bool {
        self.inferred.abstractly
    }

    /// Whether the use of letters shows what they are, since nothing declares them.
    pub fn infers(&self) -> bool {
        self.open && self.inferred.active
    }

    /// Declares a component index from 1 to `upper`, which is summed over where a product repeats it.
    pub fn add_index(&mut self, letter: &str, upper: u8) -> IndexId {
        self.indices.push(IndexEntry { letter: letter.to_owned(), upper, count: None, labels: false });
        IndexId(self.indices.len() - 1)
    }

    /// Declares a label of particles, from 1 to the value of the symbol `count`, and to `upper` at most.
    pub fn add_label(&mut self, letter: &str, upper: u8, count: Option<SymbolId>) -> IndexId {
        self.indices.push(IndexEntry { letter: letter.to_owned(), upper, count, labels: true });
        IndexId(self.indices.len() - 1)
    }

    /// Whether two index letters have the same range and both are labels, or neither.
    pub fn same_range(&self, a: IndexId, b: IndexId) -> bool {
        let (a, b) = (&self.indices[a.0], &self.indices[b.0]);
        a.upper == b.upper && a.count == b.count && a.labels == b.labels
    }

    /// The largest value of each index slot of a symbol.
    pub fn extents(&self, id: SymbolId) -> Vec<u8> {
        self.entry(id).slots.iter().map(|(_, letter)| self.indices[letter.0].upper).collect()
    }

    /// The index letter that a subscript token names.
    pub fn index(&self, token: &str) -> Option<IndexId> {
        self.indices.iter().position(|index| index.letter == token).map(IndexId)
    }

    /// Adds a symbol; `None` if the name exists.
    pub fn add(&mut self, name: Name, kind: Kind) -> Option<SymbolId> {
        let slots = self.slots(&name.subscript);
        self.add_family(name, kind, slots)
    }

    /// Records that a formula defines a symbol, or its square. A defined symbol may have a dot, so it counts as varying.
    pub fn mark_defined(&mut self, id: SymbolId, formula: &Expr, squared: bool) {
        let mut steady = true;
        formula.walk(&mut |expr| {
            if let Node::Symbol { id, .. } = &expr.node {
                let entry = self.entry(*id);
                steady &= !entry.varies || entry.steady;
            }
        });
        let entry = self.entry_mut(id);
        (entry.varies, entry.steady, entry.squared) = (true, steady, squared);
        entry.definition = Some(Arc::new(formula.clone()));
    }

    /// Adds a symbol with these index slots; `None` if the name exists.
    pub fn add_family(&mut self, name: Name, kind: Kind, slots: Vec<(usize, IndexId)>) -> Option<SymbolId> {
        if self.exact.contains_key(&name) {
            return None;
        }
        let id = SymbolId(self.entries.len());
        self.exact.insert(name.clone(), id);
        self.entries.push(Entry {
            name,
            kind,
            slots,
            angle: false,
            varies: false,
            unread: false,
            argument: None,
            squared: false,
            arguments: Vec::new(),
            derivatives: Vec::new(),
            definition: None,
            steady: false,
            derived: false,
            conserved: false,
            bound: false,
            momentum: false,
            hidden: false,
            coefficient: None,
            members: Vec::new(),
            measure: None,
            density: None,
            components: None,
            operator: None,
        });
        Some(id)
    }

    /// Adds a function or an operator that has no formula, under a name that is not taken.
    pub fn add_operator(&mut self, name: Name, kind: Kind, operator: Operator) -> SymbolId {
        let id = SymbolId(self.entries.len());
        if let Some(added) = self.add_family(name.clone(), kind, Vec::new()) {
            self.entry_mut(added).operator = Some(operator);
            return added;
        }
        self.exact.get(&name).copied().unwrap_or(id)
    }

    /// The index letters of a subscript, with their positions. A declared letter inside a word is no index: `r_{cm}`,
    /// `L_{orb}`. A word is a run of letters of one case, at least one of which is no index.
    pub fn slots(&self, subscript: &[String]) -> Vec<(usize, IndexId)> {
        let letter_case = |token: &String| match token.as_bytes() {
            [byte] if byte.is_ascii_lowercase() => Some(false),
            [byte] if byte.is_ascii_uppercase() => Some(true),
            _ => None,
        };
        let mut slots = Vec::new();
        let mut at = 0;
        for run in subscript.chunk_by(|a, b| letter_case(a).is_some() && letter_case(a) == letter_case(b)) {
            let letters: Option<Vec<IndexId>> = run.iter().map(|token| self.index(token)).collect();
            slots.extend(letters.into_iter().flatten().enumerate().map(|(k, letter)| (at + k, letter)));
            at += run.len();
        }
        slots
    }

    /// Removes a name, so that another text may define it. The symbol keeps its position in the table.
    pub fn forget(&mut self, id: SymbolId) {
        self.exact.remove(&self.entries[id.0].name);
        self.entries[id.0].name = Name::plain("");
    }

    /// Gives a name to a new number for a while: the letter of a sum or an integral. Returns it with the symbol that had the
    /// name before, for [`Symbols::release`].
    pub fn bind(&mut self, name: &Name) -> (SymbolId, Option<SymbolId>) {
        let before = self.exact.remove(name);
        let slots = Vec::new();
        let id = self.add_family(name.clone(), Kind::Scalar, slots).unwrap_or(SymbolId(self.entries.len()));
        self.entry_mut(id).bound = true;
        (id, before)
    }

    /// Ends what [`Symbols::bind`] began.
    pub fn release(&mut self, name: &Name, before: Option<SymbolId>) {
        match before {
            Some(id) => self.exact.insert(name.clone(), id),
            None => self.exact.remove(name),
        };
    }

    /// The axes of a vector's components, if they are declared.
    pub fn components_of(&self, id: SymbolId) -> Option<Components> {
        self.entry(id).components
    }

    /// The symbol's entry.
    pub fn entry(&self, id: SymbolId) -> &Entry {
        &self.entries[id.0]
    }

    /// The symbol's entry, mutable.
    pub fn entry_mut(&mut self, id: SymbolId) -> &mut Entry {
        &mut self.entries[id.0]
    }

    /// Every symbol with its entry, in the order of declaration.
    pub fn iter(&self) -> impl Iterator<Item = (SymbolId, &Entry)> {
        self.entries.iter().enumerate().map(|(i, entry)| (SymbolId(i), entry))
    }

    /// The number of symbols.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether the table has no symbols.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The symbol that a printed name refers to, with the values or letters of its indices.
    pub fn find(&self, name: &Name) -> Option<(SymbolId, Vec<Index>)> {
        if let Some(&id) = self.exact.get(name) {
            let slots = &self.entries[id.0].slots;
            let letters = slots.iter().filter_map(|(at, _)| self.index(&name.subscript[*at]));
            return Some((id, letters.map(Index::Letter).collect()));
        }
        self.iter().find_map(|(id, entry)| self.member(entry, name).map(|indices| (id, indices)))
    }

    /// The family of component indices with this base, written without indices: `R` for `R_{ab}`, but not `M` for
    /// `M_i`, whose index is a label.
    pub fn find_whole(&self, base: &str) -> Option<SymbolId> {
        self.iter()
            .find(|(_, entry)| {
                entry.name.base == base
                    && !entry.slots.is_empty()
                    && entry.slots.len() == entry.name.subscript.len()
                    && entry.slots.iter().all(|(_, letter)| !self.indices[letter.0].labels)
            })
            .map(|(id, _)| id)
    }

    /// Finds a name as [`Symbols::find`] does, with the index of [`Symbols::for_each`] added first. If it is not found,
    /// it is assembled as a family from the names of all its members.
    pub fn find_or_assemble(&mut self, name: &Name) -> Option<(SymbolId, Vec<Index>)> {
        // A name that has the letter, or is known with another index, needs none.
        let own = |letter: &IndexId| name.subscript.contains(&self.indices[letter.0].letter);
        if let Some(letter) = self.for_each.filter(|letter| !own(letter)) {
            let mut each = name.clone();
            each.subscript.push(self.indices[letter.0].letter.clone());
            if let Some(found) = self.find(&each).or_else(|| self.assemble(&each)) {
                return Some(found);
            }
        }
        self.find(name).or_else(|| self.assemble(name))
    }

    /// Adds `\lambda_a` where λ₁, λ₂ and λ₃ are declared: a family of separate names, all of one kind.
    fn assemble(&mut self, name: &Name) -> Option<(SymbolId, Vec<Index>)> {
        let slots = self.slots(&name.subscript);
        let [(at, letter)] = slots.as_slice() else { return None };
        let index = &self.indices[letter.0];
        if index.count.is_some() || index.upper == 0 {
            return None;
        }
        let member = |value: u8| {
            let mut member = name.clone();
            member.subscript[*at] = value.to_string();
            let (id, _) = self.find(&member)?;
            self.entry(id).slots.is_empty().then_some(id)
        };
        let members: Vec<SymbolId> = (1..=index.upper).map(member).collect::<Option<_>>()?;
        let kind = self.entry(members[0]).kind;
        let alike = |id: &SymbolId| self.entry(*id).kind == kind && !self.entry(*id).squared;
        if kind == Kind::Rotation || !members.iter().all(alike) {
            return None;
        }
        let angle = members.iter().all(|id| self.entry(*id).angle);
        let varies = members.iter().any(|id| self.entry(*id).varies);
        let indices = vec![Index::Letter(*letter)];
        let id = self.add_family(name.clone(), kind, slots)?;
        let entry = self.entry_mut(id);
        (entry.angle, entry.varies, entry.members) = (angle, varies, members);
        Some((id, indices))
    }

    fn member(&self, entry: &Entry, name: &Name) -> Option<Vec<Index>> {
        let same = entry.name.base == name.base
            && entry.name.primes == name.primes
            && entry.name.subscript.len() == name.subscript.len()
            && !entry.slots.is_empty();
        if !same {
            return None;
        }
        let mut indices = Vec::with_capacity(entry.slots.len());
        for (at, (declared, printed)) in entry.name.subscript.iter().zip(&name.subscript).enumerate() {
            let Some((_, declared_with)) = entry.slots.iter().find(|(slot, _)| *slot == at) else {
                if declared == printed {
                    continue;
                }
                return None;
            };
            let index = match self.index(printed) {
                Some(letter) if self.same_range(letter, *declared_with) => Index::Letter(letter),
                Some(_) => return None,
                None => match printed.parse::<u8>() {
                    Ok(value) if (1..=self.indices[declared_with.0].upper).contains(&value) => Index::Fixed(value),
                    _ => return None,
                },
            };
            indices.push(index);
        }
        Some(indices)
    }

    /// The declared name nearest to `name`, for "did you mean".
    pub fn nearest(&self, name: &Name) -> Option<String> {
        let names: Vec<String> =
            self.entries.iter().filter(|entry| !entry.is_composed()).map(|entry| entry.name.to_string()).collect();
        let wanted = name.to_string();
        // `\phi` and `\varphi` are two names, and easily taken for one.
        let plain = |text: &str| text.replace("\\var", "\\");
        let other_form = names.iter().find(|known| **known != wanted && plain(known) == plain(&wanted));
        let nearest = || suggest::nearest(&wanted, names.iter().map(String::as_str));
        other_form.map(String::as_str).or_else(nearest).map(str::to_owned)
    }
}
