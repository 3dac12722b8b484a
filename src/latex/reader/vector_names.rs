//! Names that follow from a declared vector: its norm, its unit vector and its components.
//!
//! If `\vec r_i` is declared, `r_i` is its norm, `\hat r_i` is the unit vector along it, and `r_{ia}` are its
//! components along the fixed axes or along the declared unit vectors. A component by number, `r_{i1}`, needs
//! declared components. A declared name always has priority. The meanings are recorded in
//! [`Symbols::derived`](crate::formula::Symbols::derived).
//!
//! # Why some names need no declaration
//!
//! Beside a declared `\vec r_i`, the names `r_i`, `\hat r_i` and `r_{ia}` have only one sensible meaning. They are
//! read, and what they were taken for is kept in the symbol table. A name that could be a norm and a component is
//! rejected. `\lambda_a` beside λ₁, λ₂, λ₃ is the family of the three. Every other name is declared, or defined by
//! the notes.

use crate::formula::SymbolId;
use crate::formula::symbols::{Components, Kind, Name};
use crate::formula::text;
use crate::formula::tree::{Expr, Index, Node};
use crate::source::{Fault, Span};
use crate::suggest::declaration;

use super::state::{Read, Reader};

/// Letters of energies, which letters of vectors are too.
const ENERGIES: [&str; 8] = ["U", "V", "T", "E", "K", "W", "L", "H"];

impl Reader<'_> {
    /// The meaning of a name that follows from a declared vector, and that vector.
    ///
    /// # Errors
    /// A name that may be a norm or a component: `v_1`, where `\vec v` with components and `\vec v_i` are declared.
    pub(super) fn derived(&mut self, name: &Name, span: Span) -> Read<Option<(Expr, SymbolId)>> {
        if self.symbols.open {
            return Ok(None);
        }
        let norm = self.norm_or_direction(name, span);
        let component = self.component(name, span);
        match (norm, component) {
            (Some((norm, _)), Some((component, _))) => {
                let (norm, component) = (text::formula(&norm, self.symbols), text::formula(&component, self.symbols));
                Err(Fault::ambiguous(span, format!("{name} may be {norm} or {component}"))
                    .help(declaration(&name.to_string(), 0)))
            }
            (norm, component) => Ok(norm.or(component)),
        }
    }

    fn norm_or_direction(&mut self, name: &Name, span: Span) -> Option<(Expr, SymbolId)> {
        let new = |node: Node| Expr::new(node, span);
        if let Some(inner) = name.base.strip_prefix("\\hat{").and_then(|base| base.strip_suffix('}')) {
            let (vector, id) = self.vector(&Name { base: inner.to_owned(), ..name.clone() }, span)?;
            let norm = new(Node::Norm(Box::new(vector.clone())));
            return Some((new(Node::Quotient(Box::new(vector), Box::new(norm))), id));
        }
        // Where only guesses say what letters are, the potential U is not the norm of a **U** elsewhere in the notes.
        let may_be_an_energy = self.symbols.guessed && ENERGIES.contains(&name.base.as_str());
        if is_vectorial(&name.base) || may_be_an_energy {
            return None;
        }
        let (vector, id) = self.vector(name, span)?;
        Some((new(Node::Norm(Box::new(vector))), id))
    }

    fn component(&mut self, name: &Name, span: Span) -> Option<(Expr, SymbolId)> {
        if is_vectorial(&name.base) {
            return None;
        }
        let new = |node: Node| Expr::new(node, span);
        let (last, rest) = name.subscript.split_last()?;
        let index = match self.symbols.index(last) {
            Some(letter) => {
                let entry = &self.symbols.indices[letter.0];
                (!entry.labels && entry.upper == 3).then_some(Index::Letter(letter))?
            }
            None => Index::Fixed(last.parse().ok().filter(|n| (1..=3).contains(n))?),
        };
        let (vector, id) = self.vector(&Name { subscript: rest.to_vec(), ..name.clone() }, span)?;
        let node = match (self.symbols.components_of(id), index) {
            (Some(Components::Along(axes)), _) => {
                let axis = new(Node::Symbol { id: axes, indices: vec![index], dots: 0 });
                Node::Dot(Box::new(vector), Box::new(axis))
            }
            (Some(Components::Fixed), _) | (None, Index::Letter(_)) => Node::Component(Box::new(vector), index),
            (None, Index::Fixed(_)) => return None,
        };
        Some((new(node), id))
    }

    /// Records the meaning of a name.
    pub(super) fn note_derived(&mut self, name: &Name, meaning: &Expr) {
        let words = text::formula(meaning, self.symbols);
        self.symbols.derived.insert(name.to_string(), words);
    }

    /// The declared vector of that letter, with an arrow or in bold.
    fn vector(&mut self, name: &Name, span: Span) -> Option<(Expr, SymbolId)> {
        let names = match is_vectorial(&name.base) {
            true => vec![name.base.clone()],
            false => ["\\vec", "\\mathbf"].map(|accent| format!("{accent}{{{}}}", name.base)).to_vec(),
        };
        names.into_iter().find_map(|base| {
            let (id, indices) = self.symbols.find_or_assemble(&Name { base, ..name.clone() })?;
            let node = Node::Symbol { id, indices, dots: 0 };
            (self.symbols.entry(id).kind == Kind::Vector).then_some((Expr::new(node, span), id))
        })
    }
}

pub(super) fn is_vectorial(base: &str) -> bool {
    ["\\vec{", "\\mathbf{", "\\hat{"].iter().any(|mark| base.contains(mark))
}
