//! The model of a claims file: its parts in the order in which they need one another.

use crate::Result;
use crate::check::model::Model;
use crate::check::model::builder::Builder;
use crate::formula::Symbols;
use crate::latex::Macros;
use crate::notes::claims::Claims;
use crate::systems::Registry;

/// Builds the model of a claims file on an empty one.
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
    /// For a name that cannot be read, a system that is not there, a meaning that the system does not have, a parameter
    /// or coordinate of the system that no symbol stands for: each at its place in the claims file.
    pub fn new(claims: &Claims, macros: Macros, registry: &Registry) -> Result<Model> {
        let mut macros = macros;
        for (name, body) in &claims.macros {
            macros.define(&name.value, Macros::arguments_of(&body.value), &body.value);
        }
        build(claims, Model::empty(Symbols::new(), macros), registry)
    }
}
