//! Meanings from point masses: `inertia tensor of m_i at \vec r_i`.
//!
//! The notes may define the particles themselves, so such a name is read together with the displays.
//!
//! # Why a family has three or four members
//!
//! With two members, Σ_{j≠i} is one term and ½ Σ Σ has a single pair, and mistakes in either are hidden. Three show
//! them. Four beside three show a number where n is meant. Members are drawn independently, so no symmetry among
//! them helps a false claim. More members would cost time, since the number of pairs grows.

use crate::formula::shape::bind;
use crate::formula::{Expr, Kind, Node};
use crate::latex::{names, read_formula};
use crate::notes::claims::{Claims, Spanned};
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claims_error::formula_error;
use crate::check::model::meaning::{Meaning, ParticleQuantity};

const QUANTITIES: [(&str, ParticleQuantity); 3] = [
    ("inertia tensor of ", ParticleQuantity::InertiaTensor),
    ("principal moments of ", ParticleQuantity::PrincipalMoments),
    ("principal axes of ", ParticleQuantity::PrincipalAxes),
];

/// The quantity of particles that a meaning names, and the text that names the particles. `None` for another meaning.
pub(crate) fn quantity(meaning: &Spanned<String>) -> Option<(ParticleQuantity, &str)> {
    QUANTITIES.iter().find_map(|(word, quantity)| Some((*quantity, meaning.value.strip_prefix(word)?)))
}

/// Adds a name for a quantity of particles.
///
/// # Errors
/// If the particles are not known, or the indices of the name do not fit the quantity.
pub(crate) fn declare(
    claims: &Claims,
    latex: &Spanned<String>,
    meaning: &Spanned<String>,
    model: &mut Model,
) -> Result<()> {
    let Some((quantity, particles)) = quantity(meaning) else { return Ok(()) };
    let word = &meaning.value[..meaning.value.len() - particles.len()];
    let error = |place: &Spanned<String>, message: String| Error::at(&claims.source, place.span, message);
    let Some((mass, position)) = particles.split_once(" at ") else {
        return Err(error(meaning, "this meaning does not give the masses and positions of the particles".into())
            .help(format!("write \"{word}m_i at \\vec r_i\"")));
    };
    let mut symbols = model.symbols.clone();
    let mut formula = |text: &str| -> Result<(Expr, crate::formula::shape::Type)> {
        let latex = Spanned::new(text.trim().to_owned(), meaning.span);
        let fault = |fault| formula_error(claims, &latex, fault);
        let expr = read_formula(&latex.value, &mut symbols, &model.macros).map_err(fault)?;
        bind(expr, &symbols).map_err(fault)
    };
    let ((mass, of_mass), (position, of_position)) = (formula(mass)?, formula(position)?);
    let label = match (&position.node, of_position.free.as_slice()) {
        (Node::Symbol { .. }, [label]) if symbols.indices[label.0].labels => *label,
        _ => {
            return Err(error(meaning, "the positions are not a family of vectors".into())
                .help("give the vector a label: \"indices\": { \"i\": \"1..n\" }, \\vec r_i"));
        }
    };
    use crate::formula::shape::Shape;
    let others = of_mass.free.iter().any(|letter| *letter != label);
    if of_mass.shape != Shape::Scalar || of_position.shape != Shape::Vector || others {
        return Err(error(meaning, "these are not the masses and positions of particles".into())
            .help(format!("write \"{word}m_i at \\vec r_i\", with scalar masses and vector positions")));
    }
    let Some((name, 0)) = names::parse(&latex.value) else {
        return Err(error(latex, format!("{} is not the name of a symbol", latex.value)));
    };
    let slots = name.subscript.iter().filter(|token| symbols.index(token).is_some()).count();
    let kind = match (quantity, slots) {
        (ParticleQuantity::InertiaTensor, 0) => Kind::Matrix(3, 3),
        (ParticleQuantity::InertiaTensor, 2) | (ParticleQuantity::PrincipalMoments, 1) => Kind::Scalar,
        (ParticleQuantity::PrincipalAxes, 1) => Kind::Vector,
        _ => {
            return Err(error(latex, format!("{name} has {slots} indices, which does not fit its meaning")).help(
                "the inertia tensor has two indices or none; principal moments and axes have one, over \"1..3\"",
            ));
        }
    };
    let shown = name.to_string();
    let id = symbols
        .add(name, kind)
        .ok_or_else(|| error(latex, format!("{shown} is declared twice")).help("remove one of the two declarations"))?;
    model.symbols = symbols;
    model.mean(id, Meaning::Particles(quantity, label, Box::new(mass), Box::new(position)));
    model.tie_components();
    Ok(())
}
