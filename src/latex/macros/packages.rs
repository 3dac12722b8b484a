//! Macros of usual packages (amsmath, mathtools, physics, bm, siunitx), and those that most authors define alike.
//!
//! The author's own definition goes before. A name is in the table only where its meaning is nearly universal: `\dv` is
//! a derivative, `\R` the real numbers. What several packages define differently is decided by its arguments, or left
//! out.

use crate::code::Code;
use crate::source::{Fault, Span};

use super::super::lexer::{Token, TokenKind, tokens};
use super::parameters::{argument, bracketed, star};
use super::{forms, siunitx, substitute};

/// Macros with a fixed text: the name without its backslash, the number of arguments, the text. A star after the name
/// is ignored.
const TEXTS: &[(&str, usize, &str)] = &[
    // vectors: physics, and usual names
    ("vb", 1, "\\mathbf{#1}"),
    ("vectorbold", 1, "\\mathbf{#1}"),
    ("va", 1, "\\vec{#1}"),
    ("vectorarrow", 1, "\\vec{#1}"),
    ("vu", 1, "\\hat{#1}"),
    ("vectorunit", 1, "\\hat{#1}"),
    ("Vec", 1, "\\vec{#1}"),
    ("vect", 1, "\\vec{#1}"),
    ("vv", 1, "\\vec{#1}"),
    ("vct", 1, "\\vec{#1}"),
    ("bvec", 1, "\\mathbf{#1}"),
    ("uvec", 1, "\\hat{#1}"),
    ("unitvec", 1, "\\hat{#1}"),
    ("uvect", 1, "\\hat{#1}"),
    ("overrightharpoon", 1, "\\vec{#1}"),
    ("vdot", 0, "\\cdot"),
    ("dotproduct", 0, "\\cdot"),
    ("cross", 0, "\\times"),
    ("cp", 0, "\\times"),
    ("crossproduct", 0, "\\times"),
    ("grad", 0, "\\nabla"),
    ("gradient", 0, "\\nabla"),
    ("vnabla", 0, "\\nabla"),
    ("divergence", 0, "\\nabla\\cdot"),
    ("curl", 0, "\\nabla\\times"),
    ("rot", 0, "\\nabla\\times"),
    ("laplacian", 0, "\\nabla^2"),
    // pairs of delimiters: physics, mathtools
    ("abs", 1, "\\left\\lvert #1\\right\\rvert"),
    ("absolutevalue", 1, "\\left\\lvert #1\\right\\rvert"),
    ("norm", 1, "\\left\\lVert #1\\right\\rVert"),
    ("pqty", 1, "\\left(#1\\right)"),
    ("bqty", 1, "\\left[#1\\right]"),
    ("Bqty", 1, "\\left\\{#1\\right\\}"),
    ("vqty", 1, "\\left\\lvert #1\\right\\rvert"),
    ("paren", 1, "\\left(#1\\right)"),
    ("comm", 2, "\\left[#1,#2\\right]"),
    ("commutator", 2, "\\left[#1,#2\\right]"),
    ("acomm", 2, "\\left\\{#1,#2\\right\\}"),
    ("anticommutator", 2, "\\left\\{#1,#2\\right\\}"),
    ("pb", 2, "\\left\\{#1,#2\\right\\}"),
    ("poissonbracket", 2, "\\left\\{#1,#2\\right\\}"),
    // states: physics, braket
    ("ket", 1, "|#1\\rangle"),
    ("Ket", 1, "|#1\\rangle"),
    ("bra", 1, "\\langle #1|"),
    ("Bra", 1, "\\langle #1|"),
    ("ketbra", 2, "|#1\\rangle\\langle #2|"),
    ("dyad", 2, "|#1\\rangle\\langle #2|"),
    ("outerproduct", 2, "|#1\\rangle\\langle #2|"),
    ("innerproduct", 2, "\\langle #1|#2\\rangle"),
    ("mel", 3, "\\langle #1|#2|#3\\rangle"),
    ("matrixel", 3, "\\langle #1|#2|#3\\rangle"),
    ("matrixelement", 3, "\\langle #1|#2|#3\\rangle"),
    // functions: physics
    ("sine", 0, "\\sin"),
    ("cosine", 0, "\\cos"),
    ("tangent", 0, "\\tan"),
    ("asin", 0, "\\arcsin"),
    ("acos", 0, "\\arccos"),
    ("atan", 0, "\\arctan"),
    ("arcsine", 0, "\\arcsin"),
    ("arccosine", 0, "\\arccos"),
    ("arctangent", 0, "\\arctan"),
    ("exponential", 0, "\\exp"),
    ("naturallogarithm", 0, "\\ln"),
    // differentials
    ("d", 0, "\\mathrm{d}"),
    ("dbar", 0, "đ"),
    ("dj", 0, "đ"),
    ("dif", 0, "\\mathrm{d}"),
    ("Dif", 0, "\\mathrm{d}"),
    ("dt", 0, "\\mathrm{d}t"),
    ("dx", 0, "\\mathrm{d}x"),
    ("dy", 0, "\\mathrm{d}y"),
    ("dz", 0, "\\mathrm{d}z"),
    ("dr", 0, "\\mathrm{d}r"),
    ("ddt", 0, "\\frac{\\mathrm{d}}{\\mathrm{d}t}"),
    ("ddx", 0, "\\frac{\\mathrm{d}}{\\mathrm{d}x}"),
    ("var", 0, "\\delta"),
    ("variation", 0, "\\delta"),
    ("half", 0, "\\frac{1}{2}"),
    ("flatfrac", 2, "\\frac{#1}{#2}"),
    ("nicefrac", 2, "\\frac{#1}{#2}"),
    ("sfrac", 2, "\\frac{#1}{#2}"),
    // letters and words
    ("R", 0, "\\mathbb{R}"),
    ("N", 0, "\\mathbb{N}"),
    ("Z", 0, "\\mathbb{Z}"),
    ("C", 0, "\\mathbb{C}"),
    ("Bbb", 1, "\\mathbb{#1}"),
    ("RR", 0, "\\mathbb{R}"),
    ("eps", 0, "\\epsilon"),
    ("veps", 0, "\\varepsilon"),
    ("vareps", 0, "\\varepsilon"),
    ("Lag", 0, "\\mathcal{L}"),
    ("Lagr", 0, "\\mathcal{L}"),
    ("lagrangian", 0, "\\mathcal{L}"),
    ("Ham", 0, "\\mathcal{H}"),
    ("hamiltonian", 0, "\\mathcal{H}"),
    ("const", 0, "\\mathrm{const}"),
    ("qq", 1, "\\quad\\text{#1}\\quad"),
    ("qqtext", 1, "\\quad\\text{#1}\\quad"),
    ("qc", 0, ",\\quad"),
    ("qcomma", 0, ",\\quad"),
    ("qand", 0, "\\quad\\text{and}\\quad"),
    ("qor", 0, "\\quad\\text{or}\\quad"),
    ("qwith", 0, "\\quad\\text{with}\\quad"),
    ("qwhere", 0, "\\quad\\text{where}\\quad"),
    ("qthus", 0, "\\quad\\text{thus}\\quad"),
    ("qhence", 0, "\\quad\\text{hence}\\quad"),
    // mathtools and amsmath
    ("coloneqq", 0, ":="),
    ("coloneq", 0, ":="),
    ("defeq", 0, ":="),
    ("coloncolonequals", 0, ":="),
    ("triangleq", 0, "\\equiv"),
    ("lparen", 0, "("),
    ("rparen", 0, ")"),
    ("Aboxed", 1, "#1"),
    ("ensuremath", 1, "#1"),
    ("mathop", 1, "#1"),
    ("mathrel", 1, "#1"),
    ("mathbin", 1, "#1"),
    ("mathord", 1, "#1"),
    ("mathinner", 1, "#1"),
    ("mathclose", 1, "#1"),
    ("mathopen", 1, "#1"),
    ("mathclap", 1, "#1"),
    ("mathllap", 1, "#1"),
    ("mathrlap", 1, "#1"),
    ("smash", 1, "#1"),
    ("mathstrut", 0, ""),
    ("cancel", 1, "#1"),
    ("cancelto", 2, "#2"),
    ("phantom", 1, ""),
    ("hphantom", 1, ""),
    ("vphantom", 1, ""),
    ("vspace", 1, ""),
    ("hfill", 0, "\\quad"),
    ("hfil", 0, "\\quad"),
    ("footnote", 1, ""),
    ("footnotemark", 0, ""),
    ("cite", 1, ""),
    ("xspace", 0, ""),
    ("displaybreak", 0, ""),
    ("nonfrenchspacing", 0, ""),
    ("centering", 0, ""),
    ("tiny", 0, ""),
    ("scriptsize", 0, ""),
    ("footnotesize", 0, ""),
    ("small", 0, ""),
    ("normalsize", 0, ""),
    ("large", 0, ""),
    ("Large", 0, ""),
    ("LARGE", 0, ""),
    ("huge", 0, ""),
    ("Huge", 0, ""),
    ("protect", 0, ""),
    ("intertext", 1, "\\\\ \\text{#1} \\\\"),
    ("shortintertext", 1, "\\\\ \\text{#1} \\\\"),
    ("lt", 0, "<"),
    ("gt", 0, ">"),
    ("colon", 0, ":"),
    ("lbrack", 0, "["),
    ("rbrack", 0, "]"),
    ("dotsb", 0, "\\dots"),
    ("dotsc", 0, "\\dots"),
    ("dotsm", 0, "\\dots"),
    ("dotso", 0, "\\dots"),
    ("dotsi", 0, "\\dots"),
    ("ldots", 0, "\\dots"),
    ("cdots", 0, "\\dots"),
    ("hdots", 0, "\\dots"),
];

/// Whether a command is a macro of a package.
pub(super) fn knows(name: &str) -> bool {
    text(name).is_some() || forms::knows(name) || siunitx::NAMES.contains(&name) || siunitx::LISTS.contains(&name)
}

fn text(name: &str) -> Option<(usize, &'static str)> {
    let name = name.strip_prefix('\\')?;
    TEXTS.iter().find(|(known, ..)| *known == name).map(|(_, arguments, text)| (*arguments, *text))
}

/// The text of a macro of a package, with its arguments from the reversed input; `before` is the token before it. `None`
/// for a command that is none.
///
/// # Errors
/// For an argument that is missing, and for a quantity that is not supported.
pub(super) fn expansion(
    name: &str,
    span: Span,
    pending: &mut Vec<Token>,
    before: Option<&Token>,
) -> Result<Option<Vec<Token>>, Fault> {
    if siunitx::NAMES.contains(&name) {
        return siunitx::quantity(name, span, pending).map(Some);
    }
    if siunitx::LISTS.contains(&name) {
        return Err(Fault::unsupported(span, format!("{name} prints several quantities, and is not supported"))
            .help("write an equation for each value"));
    }
    let Some((arguments, body)) = text(name) else { return forms::expansion(name, span, pending, before) };
    if arguments > 0 {
        star(pending);
    }
    if name == "\\smash" {
        bracketed(pending);
    }
    let mut values = Vec::with_capacity(arguments);
    for n in 1..=arguments {
        let missing = || {
            let message = match arguments {
                1 => format!("{name} needs an argument"),
                count => format!("{name} needs {count} arguments, and argument {n} is missing"),
            };
            Fault::new(span, message).code(Code::UnknownCommand).help("write each argument in braces, and close them")
        };
        values.push(argument(pending).ok_or_else(missing)?);
    }
    let mut found = substitute(&tokens(body), &values, span);
    // A differential ends the argument of a function before it, as in `\int \sin x\dx`.
    let starts = before.is_none_or(|token| matches!(token.kind, TokenKind::Open | TokenKind::Super | TokenKind::Sub));
    if body.starts_with("\\mathrm{d}") && !starts {
        found.insert(0, forms::thin_space(span));
    }
    Ok(Some(found))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_is_there_twice() {
        for (at, (name, ..)) in TEXTS.iter().enumerate() {
            assert!(TEXTS[at + 1..].iter().all(|(other, ..)| other != name), "{name}");
            assert!(!forms::knows(&format!("\\{name}")), "{name}");
        }
    }

    #[test]
    fn every_text_has_its_arguments_and_no_others() {
        for (name, arguments, text) in TEXTS {
            assert!(super::super::Macros::arguments_of(text) <= *arguments, "{name}");
        }
    }
}
