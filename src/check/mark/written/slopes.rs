//! Slopes by a constant of the problem: `\frac{dR}{d\alpha}` for the range R at the angle α is what `\frac{\partial R}{\partial\alpha}` is.

use crate::latex::{foreign, names};
use crate::source::Span;

use super::Written;
use crate::check::mark::names::{Names, Role};

/// Writes slopes by constants with `\partial`.
pub(in crate::check::mark) fn by_constants(lines: &mut [Written], known: &Names) {
    let is_constant = |name: &str| {
        let name = names::parse(name).map(|(name, _)| name);
        known.names.iter().any(|(own, role, _)| Some(own) == name.as_ref() && *role == Role::Constant)
    };
    for line in lines {
        let edits = slopes(&line.text).into_iter().filter(|(_, by)| is_constant(by)).flat_map(|(signs, _)| signs);
        let edits: Vec<_> = edits.map(|span| (span, "\\partial ".to_owned())).collect();
        line.edits.extend(edits);
    }
}

/// The slopes in a text: where the signs of the differentials stand, and by what they are.
fn slopes(text: &str) -> Vec<([Span; 2], &str)> {
    let signs = ["\\mathrm{d}", "\\mathrm d", "d"];
    let differential = |at: usize| {
        let sign = signs.iter().find(|sign| text[at..].starts_with(**sign))?;
        let gap = text[at + sign.len()..].len() - text[at + sign.len()..].trim_start().len();
        let start = at + sign.len() + gap;
        let end = foreign::quantity(text, start)?;
        text[end..].starts_with('}').then_some((Span::new(at, start), &text[start..end], end + 1))
    };
    let found = text.match_indices("frac{").filter_map(|(at, frac)| {
        let (above, _, end) = differential(at + frac.len())?;
        let below = end + usize::from(text[end..].starts_with('{'));
        let (below, by, _) = differential(below).filter(|_| below > end)?;
        Some(([above, below], by))
    });
    found.collect()
}

#[cfg(test)]
mod tests {
    use super::slopes;

    #[test]
    fn a_slope_has_two_differentials_of_single_names() {
        let by = |text: &'static str| slopes(text).into_iter().map(|(_, by)| by).collect::<Vec<_>>();
        assert_eq!(by(r"\frac{dR}{d\alpha} = \dfrac{\mathrm{d} H}{\mathrm{d} v_0}"), [r"\alpha", "v_0"]);
        // The twins: an operator, a second order, a quotient.
        for text in [r"\frac{d}{d\alpha}", r"\frac{d^2R}{d\alpha^2}", r"\frac{R}{d\alpha}", r"\frac{d_1}{d_2}"] {
            assert!(by(text).is_empty(), "{text}");
        }
    }
}
