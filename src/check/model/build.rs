//! The model of a claims file, built part by part in the order in which the parts need one another.

use crate::Result;
use crate::check::model::Model;
use crate::check::model::builder::Builder;
use crate::formula::Symbols;
use crate::latex::Macros;
use crate::notes::claims::Claims;
use crate::systems::Registry;

/// Builds the model of a claims file into an empty model.
pub(crate) fn build(claims: &Claims, empty: Model, registry: &Registry) -> Result<Model> {
    let mut builder = Builder { claims, model: empty, early: Vec::new() };
    builder.indices()?;
    builder.declarations()?;
    builder.axes()?;
    builder.system(registry)?;
    builder.components()?;
    builder.means()?;
    builder.momenta();
    builder.rotations()?;
    builder.continua()?;
    Ok(builder.model)
}

impl Model {
    /// Builds the model of a claims file; `macros` are those defined in the notes.
    ///
    /// # Errors
    /// An error at its place in the claims file, for a name that cannot be read, an unknown system, a meaning that the
    /// system does not have, or a parameter or coordinate of the system without a declared symbol.
    pub fn new(claims: &Claims, macros: Macros, registry: &Registry) -> Result<Model> {
        let mut macros = macros;
        for (name, body) in &claims.macros {
            macros.define(&name.value, Macros::arguments_of(&body.value), &body.value);
        }
        let mut symbols = Symbols::new();
        symbols.guessed = claims.guesses.is_some();
        build(claims, Model::empty(symbols, macros), registry)
    }
}
