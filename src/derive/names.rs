//! The names of derived quantities, and the input of the recording that each denotes.

use crate::formula::symbols::Kind;
use crate::formula::{Expr, Node, SymbolId, Symbols, text};
use crate::latex::names;
use crate::mechanics::System;
use crate::source::Span;
use crate::{Error, Result};

use super::{Class, Letter};

/// The names of a system and of the quantities derived from it.
pub(super) struct Names {
    pub symbols: Symbols,
    pub coordinates: Vec<SymbolId>,
    pub momenta: Vec<SymbolId>,
    pub letters: Vec<Letter>,
    pub lagrangian: SymbolId,
    pub energy: SymbolId,
    pub hamiltonian: SymbolId,
    /// The upper triangle, row by row.
    pub masses: Vec<SymbolId>,
}

/// The indices of the inputs: time, coordinates, velocities, parameters, accelerations, momenta.
pub(super) struct Inputs {
    pub n: usize,
    pub parameters: usize,
}

impl Inputs {
    fn block(&self, first: usize, count: usize) -> Vec<usize> {
        (first..first + count).collect()
    }
    pub fn coordinates(&self) -> Vec<usize> {
        self.block(1, self.n)
    }
    pub fn velocities(&self) -> Vec<usize> {
        self.block(1 + self.n, self.n)
    }
    pub fn parameters(&self) -> Vec<usize> {
        self.block(1 + 2 * self.n, self.parameters)
    }
    pub fn accelerations(&self) -> Vec<usize> {
        self.block(1 + 2 * self.n + self.parameters, self.n)
    }
    pub fn momenta(&self) -> Vec<usize> {
        self.block(1 + 3 * self.n + self.parameters, self.n)
    }
}

impl Names {
    pub fn new(system: &System) -> Result<Self> {
        let mut symbols = Symbols::new();
        let mut add = |latex: &str| {
            let name = names::parse(latex).filter(|(_, dots)| *dots == 0).map(|(name, _)| name);
            let name = name.ok_or_else(|| {
                Error::new(format!(
                    "the system \"{}\" uses {latex} as a name, which is not a LaTeX symbol",
                    system.name()
                ))
                .help("use a letter, with a subscript if needed: \\theta, \\lambda_1")
            })?;
            symbols.add(name, Kind::Scalar).ok_or_else(|| {
                Error::new(format!("the system \"{}\" uses the name {latex} twice", system.name())).help(
                    "rename a coordinate or a parameter; t is the time, and p_q is the momentum of a coordinate q",
                )
            })
        };
        let coordinates: Vec<SymbolId> = system.coordinates().iter().map(|name| add(name)).collect::<Result<_>>()?;
        let parameters: Vec<SymbolId> = system.parameters().iter().map(|name| add(name)).collect::<Result<_>>()?;
        let time = add("t")?;
        let momenta: Vec<SymbolId> =
            system.coordinates().iter().map(|name| add(&format!("p_{{{name}}}"))).collect::<Result<_>>()?;
        let mut either = |usual: &str, other: &str| add(usual).or_else(|_| add(other));
        let lagrangian = either("L", "\\mathcal{L}")?;
        let energy = either("E", "\\mathcal{E}")?;
        let hamiltonian = either("H", "\\mathcal{H}")?;
        let mut masses = Vec::new();
        for (i, first) in system.coordinates().iter().enumerate() {
            for second in &system.coordinates()[i..] {
                masses.push(add(&format!("M_{{{first} {second}}}"))?);
            }
        }
        for &id in coordinates.iter().chain(&momenta).chain([&time]) {
            symbols.entry_mut(id).varies = true;
        }
        let letter = |id: SymbolId, dots: u8, class: Class| Letter { expr: symbol(id, dots), class };
        let mut letters = vec![letter(time, 0, Class::Time)];
        letters.extend(coordinates.iter().map(|&id| letter(id, 0, Class::Coordinate)));
        letters.extend(coordinates.iter().map(|&id| letter(id, 1, Class::Velocity)));
        letters.extend(parameters.iter().map(|&id| letter(id, 0, Class::Parameter)));
        letters.extend(coordinates.iter().map(|&id| letter(id, 2, Class::Acceleration)));
        letters.extend(momenta.iter().map(|&id| letter(id, 0, Class::Momentum)));
        Ok(Names { symbols, coordinates, momenta, letters, lagrangian, energy, hamiltonian, masses })
    }

    pub fn each(&self) -> std::ops::Range<usize> {
        0..self.coordinates.len()
    }

    pub fn spelled(&self, i: usize) -> String {
        text::plain(&self.symbols.entry(self.coordinates[i]).name.to_string())
    }

    pub fn inputs(&self) -> Inputs {
        let n = self.coordinates.len();
        Inputs { n, parameters: self.letters.len() - 1 - 4 * n }
    }
}

/// A symbol with this number of dots.
pub(super) fn symbol(id: SymbolId, dots: u8) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, Span::default())
}
