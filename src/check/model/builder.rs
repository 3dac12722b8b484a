//! The claims file's declarations made into a model: every name gets its meaning, and the system its symbols.
//!
//! What the claims file defines (`"define"`) is read together with the displays
//! ([`crate::check::document::reading`]), since each may use the other.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Kind, SymbolId, text};
use crate::latex::{names, read_formula};
use crate::notes::claims::{Claims, Spanned};
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claims_error::formula_error;
use crate::check::model::meaning::Meaning;

/// A name without what only typesets it: `\lambda_{1}` and `lambda1` are the same here.
pub fn plain(latex: &str) -> String {
    latex.chars().filter(|c| !matches!(c, '\\' | '_' | '{' | '}' | ' ')).collect()
}

pub(crate) struct Builder<'a> {
    pub(crate) claims: &'a Claims,
    pub(crate) model: Model,
    /// Symbols that were needed, and so added, before their turn.
    pub(crate) early: Vec<SymbolId>,
}

impl Builder<'_> {
    pub(crate) fn shown(&self, symbol: SymbolId) -> String {
        text::plain(&self.model.name(symbol))
    }

    pub(crate) fn error(&self, place: &Spanned<String>, message: impl Into<String>) -> Error {
        Error::at(&self.claims.source, place.span, message)
    }

    pub(crate) fn name(&self, latex: &Spanned<String>) -> Result<Name> {
        match names::parse(&latex.value) {
            Some((name, 0)) => Ok(name),
            Some(_) => Err(self
                .error(latex, format!("{} has a dot, and dots are not part of a name", latex.value))
                .help("declare the symbol itself")),
            None => Err(self
                .error(latex, format!("{} is not the name of a symbol", latex.value))
                .help("a name is a letter or a Greek command, with accents, a subscript, primes: \\hat{e}_a, p_\\psi")),
        }
    }

    pub(crate) fn add(&mut self, latex: &Spanned<String>, kind: Kind, meaning: Meaning) -> Result<SymbolId> {
        let name = self.name(latex)?;
        if ["e", "d"].contains(&name.base.as_str()) && name.subscript.is_empty() {
            self.model.inferred.push(format!("{name} is a symbol here, not a constant or a differential"));
        }
        let shown = name.to_string();
        let id = self
            .model
            .symbols
            .add(name, kind)
            .ok_or_else(|| self.error(latex, format!("{shown} is declared twice")).help("keep one of the two"))?;
        self.model.mean(id, meaning);
        Ok(id)
    }

    pub(crate) fn formula(&mut self, latex: &Spanned<String>) -> Result<Expr> {
        let macros = self.model.macros.clone();
        read_formula(&latex.value, &mut self.model.symbols, &macros)
            .map_err(|fault| formula_error(self.claims, latex, fault))
    }
}
