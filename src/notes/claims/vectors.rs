//! Unit vectors and the components of vectors along them.

use super::fields::{self, Fields, Text};
use crate::notes::json::Spanned;
use crate::source::{Fault, Source};

/// The motion of three unit vectors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Axes {
    /// `fixed`: no motion.
    Fixed,
    /// `turning with \vec\omega`: the rate of each ê is ω × ê.
    TurningWith(String),
}

/// The names of the components of a vector.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Components {
    /// `x_i, y_i, z_i`: along the fixed axes, in their order.
    Names([Spanned<String>; 3]),
    /// `along \hat e_a`: the letter of the vector, with the index of these axes.
    Along(Spanned<String>),
}

/// Reads `axes`.
pub(super) fn axes(fields: &Fields<'_>, source: &Source) -> Result<Vec<(Text, Spanned<Axes>)>, Fault> {
    let read = |(name, value): (Text, Text)| {
        let text = value.value.trim();
        let axes = match text.strip_prefix("turning with").map(str::trim) {
            Some(rate) if !rate.is_empty() => Spanned::new(Axes::TurningWith(rate.to_owned()), value.span),
            _ if text == "fixed" => Spanned::new(Axes::Fixed, value.span),
            _ => {
                return Err(Fault::claims(value.span, format!("\"{text}\" does not say how these axes move"))
                    .help("use \"fixed\" or \"turning with \\\\vec\\\\omega\""));
            }
        };
        Ok((name, axes))
    };
    fields.declared("axes", source)?.into_iter().map(read).collect()
}

/// Reads `components`.
pub(super) fn components(fields: &Fields<'_>, source: &Source) -> Result<Vec<(Text, Spanned<Components>)>, Fault> {
    const HELP: &str = "write the components, as in \"x_i, y_i, z_i\", or the axes, as in \"along \\\\hat e_a\"";
    let mut components = Vec::new();
    for (key, value) in fields.pairs("components")? {
        let vectors = fields::names(&key, source)?;
        let start = value.value.len() - value.value.trim_start().len();
        let along = value.value[start..].strip_prefix("along").filter(|rest| !rest.starts_with(char::is_alphabetic));
        let read = if let Some(axes) = along {
            let axes = fields::piece(&value, value.value.len() - axes.len()..value.value.len(), source);
            if axes.value.is_empty() {
                return Err(Fault::claims(value.span, "the axes after \"along\" are missing").help(HELP));
            }
            Components::Along(axes)
        } else {
            let names = fields::names(&value, source)?;
            let count = names.len();
            let names = <[Text; 3]>::try_from(names).map_err(|_| {
                Fault::claims(value.span, format!("a vector has three components, not {count}")).help(HELP)
            })?;
            if let Some(second) = vectors.get(1) {
                return Err(Fault::claims(second.span, "two vectors cannot share the names of their components")
                    .help("write one line for each vector, with names of its own"));
            }
            Components::Names(names)
        };
        let read = Spanned::new(read, value.span);
        components.extend(vectors.into_iter().map(|vector| (vector, read.clone())));
    }
    Ok(components)
}
