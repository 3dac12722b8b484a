//! Errors in formulas of a claims file, at their place there.

use crate::Error;
use crate::notes::claims::{Claims, Spanned};

/// An error in the LaTeX of a claims file, at its place there.
pub fn formula_error(claims: &Claims, latex: &Spanned<String>, fault: crate::source::Fault) -> Error {
    let at = latex.value.get(fault.span.range()).filter(|part| !part.is_empty() && *part != latex.value);
    let message = match at {
        // The message itself names what is not known.
        Some(part) if fault.missing.is_none() => format!("at “{part}”: {}", fault.message),
        Some(_) => format!("{} in “{}”", fault.message, latex.value),
        None => fault.message,
    };
    let error = Error::at(&claims.source, latex.span, message).lacking(fault.missing);
    match fault.help {
        Some(help) => error.help(help),
        None => error,
    }
}
