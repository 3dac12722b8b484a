//! The builder that turns the declarations of a claims file into a model: each name gets its meaning.
//!
//! Definitions in the prose (`"define"`) are read later, together with the displays, since the two may use each other.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Kind, SymbolId, text};
use crate::latex::{names, read_formula};
use crate::notes::claims::{Claims, Spanned};
use crate::suggest::{declaration, in_json};
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claims_error::formula_error;
use crate::check::model::meaning::Meaning;

/// A name without typesetting: `\lambda_{1}` and `lambda1` become the same.
pub fn plain(latex: &str) -> String {
    latex.chars().filter(|c| !matches!(c, '\\' | '_' | '{' | '}' | ' ')).collect()
}

/// A model that is being built.
pub(crate) struct Builder<'a> {
    pub(crate) claims: &'a Claims,
    pub(crate) model: Model,
    /// The symbols that were added before their turn, because an earlier declaration needs them.
    pub(crate) early: Vec<SymbolId>,
}

impl Builder<'_> {
    pub(crate) fn shown(&self, symbol: SymbolId) -> String {
        text::plain(&self.model.name(symbol))
    }

    pub(crate) fn error(&self, place: &Spanned<String>, message: impl Into<String>) -> Error {
        Error::at(&self.claims.source, place.span, message)
    }

    /// The error that a name is not declared, with the line that declares it.
    pub(crate) fn undeclared(&self, latex: &Spanned<String>) -> Error {
        self.error(latex, format!("{} is not declared", latex.value)).help(declaration(latex.value.trim(), 0))
    }

    pub(crate) fn name(&self, latex: &Spanned<String>) -> Result<Name> {
        match names::parse(&latex.value) {
            Some((name, 0)) => Ok(name),
            Some(_) => Err(self
                .error(latex, format!("{} has a dot, which is not part of a name", latex.value))
                .help("declare the symbol without the dot")),
            None => {
                let error = self.error(latex, format!("{} is not the name of a symbol", latex.value));
                let greek = format!("\\{}", latex.value.trim());
                Err(error.help(match names::is_letter(&greek) {
                    true => format!("did you mean {}?", in_json(&greek)),
                    false => "a name is a letter or a Greek letter, with accents, a subscript or primes, as in \"\\\\hat{e}_a\" and \
                              \"p_\\\\psi\"; write commas between names: \"m, k\""
                        .to_owned(),
                }))
            }
        }
    }

    pub(crate) fn add(&mut self, latex: &Spanned<String>, kind: Kind, meaning: Meaning) -> Result<SymbolId> {
        let name = self.name(latex)?;
        if ["e", "d"].contains(&name.base.as_str()) && name.subscript.is_empty() {
            self.model.inferred.push(format!("{name} is a symbol here, not Euler's number or a differential"));
        }
        let shown = name.to_string();
        let id = self.model.symbols.add(name, kind).ok_or_else(|| {
            self.error(latex, format!("{shown} is declared twice")).help("remove one of the two declarations")
        })?;
        self.model.mean(id, meaning);
        Ok(id)
    }

    pub(crate) fn formula(&mut self, latex: &Spanned<String>) -> Result<Expr> {
        let macros = self.model.macros.clone();
        read_formula(&latex.value, &mut self.model.symbols, &macros)
            .map_err(|fault| formula_error(self.claims, latex, fault))
    }
}
