//! The definition of a name by a formula that is no display: one of the claims file, or one of the prose.

use crate::formula::shape::{Shape, bind};
use crate::formula::{IndexId, Kind};
use crate::latex::{name_search, read_formula};
use crate::notes::claims::{Claims, Spanned};
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claims_error::formula_error;

/// Adds a name with its formula to the model.
///
/// # Errors
/// Where the formula cannot be read with the names of the model, or does not fit the name; at its place in the claims file.
pub(crate) fn define(
    claims: &Claims,
    latex: &Spanned<String>,
    body: &Spanned<String>,
    model: &mut Model,
) -> Result<()> {
    let error = |message: String| Error::at(&claims.source, latex.span, message);
    let square = latex.value.trim().strip_suffix("^2").or(latex.value.trim().strip_suffix("^{2}"));
    let name = name_search::parse_decorated(square.unwrap_or(&latex.value)).ok_or_else(|| {
        error(format!("{} cannot be defined, because it is not the name of a symbol", latex.value))
            .help("write a letter or a Greek command, with accents, a subscript or primes, as in \\hat{e}_a")
    })?;
    let mut symbols = model.symbols.clone();
    let formula =
        read_formula(&body.value, &mut symbols, &model.macros).map_err(|fault| formula_error(claims, body, fault))?;
    let (formula, found) = bind(formula, &symbols).map_err(|fault| formula_error(claims, body, fault))?;
    let shown = name.to_string();
    let kind = match found.shape {
        Shape::Scalar => Kind::Scalar,
        Shape::Vector => Kind::Vector,
        Shape::Matrix(rows, columns) if rows * columns > 0 && rows.max(columns) <= 255 => {
            Kind::Matrix(rows as u8, columns as u8)
        }
        Shape::Complex => Kind::Complex,
        Shape::Abstract => Kind::Abstract,
        Shape::Matrix(..) => {
            return Err(error(format!("the definition of {shown} is a matrix of an unknown size"))
                .help("write the matrix out, or declare the size of each matrix in it, as in \"A\": \"3x3 matrix\""));
        }
    };
    let id = symbols
        .add(name, kind)
        .ok_or_else(|| error(format!("{shown} is declared twice")).help("remove one of the two declarations"))?;
    let own: Vec<IndexId> = symbols.entry(id).slots.iter().map(|(_, letter)| *letter).collect();
    if let Some(stray) = found.free.iter().find(|letter| !own.contains(letter)) {
        let letter = &symbols.indices[stray.0].letter;
        return Err(error(format!(
            "this definition contains the index {letter} without a sum over it, and {shown} has no index {letter}"
        ))
        .help("give the name this index too, or write a Σ over the index"));
    }
    if let Some((_, [letter, _])) =
        formula.pair_sums().iter().find(|(_, pair)| own.iter().any(|own| pair.contains(own)))
    {
        let letter = &symbols.indices[letter.0].letter;
        return Err(error(format!(
            "in the definition of {shown}, one Σ sums over {letter} and another index, and one of them is an index of \
             {shown}"
        ))
        .help("sum over the other index only, as in \\sum_{j \\neq i}"));
    }
    symbols.mark_defined(id, &formula, square.is_some());
    model.symbols = symbols;
    model.define(id, formula);
    Ok(())
}
