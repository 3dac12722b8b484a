//! Definite integrals of what expands.
//!
//! What [`super::expansion`] expands is continuous everywhere, so the difference of an antiderivative at the two ends is
//! the integral, whatever the ends are. At infinity only what decays is integrated: its rate is compared with 0, in the
//! result if it is no number. Integrals with e^{−ax²} are known over the whole line, and some over half of it.

use crate::source::Span;

use super::super::ids::SymbolId;
use super::super::tree::{Expr, Node, Sign};
use super::build::{Build, Guard, is_zero};
use super::expansion::{In, Monomial, Wave};
use super::places::End;
use super::{NoFormula, algebraic};

/// `\int_{lower}^{upper} integrand d(letter)`. Every node of the result has the place `span`. Definitions in which the letter
/// occurs must have been written out before.
///
/// # Errors
/// Where no rule fits, or the integral certainly diverges.
pub fn integral(
    integrand: &Expr,
    letter: SymbolId,
    (lower, upper): (&End, &End),
    span: Span,
) -> Result<Expr, NoFormula> {
    let ring = In { letter, build: Build { span } };
    let mut integrand = integrand.clone();
    integrand.move_to(span);
    let Some(terms) = ring.expand(&integrand) else {
        // A sum is integrated term by term, where all of its terms converge.
        let Node::Sum(terms) = &integrand.node else {
            return algebraic::integral(ring, &integrand, (lower, upper));
        };
        let mut parts = Vec::new();
        for term in terms {
            let part = integral(&term.expr, letter, (lower, upper), span).map_err(|_| NoFormula::Unknown)?;
            parts.push(if term.sign == Sign::Minus { ring.build.negative(part) } else { part });
        }
        return Ok(ring.build.sum(parts));
    };
    let (mut parts, mut guards) = (Vec::new(), Vec::new());
    let (wide, plain): (Vec<Monomial>, Vec<Monomial>) = terms.into_iter().partition(|term| !is_zero(&term.square));
    for term in wide {
        parts.push(gaussian(ring, &term, (lower, upper), &mut guards).ok_or(NoFormula::Unknown)?);
    }
    let mut antiderivative = Vec::new();
    for term in plain {
        antiderivative.extend(of_term(ring, &term).ok_or(NoFormula::Unknown)?);
    }
    parts.push(value_at(ring, &antiderivative, upper, &mut guards)?);
    let below = value_at(ring, &antiderivative, lower, &mut guards)?;
    parts.push(ring.build.negative(below));
    ring.build.guarded(ring.build.sum(parts), guards).ok_or(NoFormula::Diverges)
}

/// An antiderivative of a term without x² in its exponent.
fn of_term(ring: In, term: &Monomial) -> Option<Vec<Monomial>> {
    let build = ring.build;
    if !is_zero(&term.square) {
        return None;
    }
    if is_zero(&term.rate) && term.wave.is_none() {
        let power = term.power + 1;
        let factor = build.quotient(term.factor.clone(), build.whole(power));
        return Some(vec![Monomial { factor, power, ..term.clone() }]);
    }
    let mut all = Vec::new();
    for part in without_power(ring, term) {
        all.push(Monomial { power: term.power, ..part.clone() });
        if term.power > 0 {
            let factor = build.negative(build.product(vec![build.whole(term.power), part.factor.clone()]));
            all.extend(of_term(ring, &Monomial { factor, power: term.power - 1, ..part })?);
        }
    }
    Some(all)
}

/// An antiderivative of a term without its xⁿ.
fn without_power(ring: In, term: &Monomial) -> Vec<Monomial> {
    let build = ring.build;
    let with = |factor: Expr, wave: Option<Wave>| Monomial { factor, power: 0, wave, ..term.clone() };
    let Some(wave) = &term.wave else {
        return vec![with(build.quotient(term.factor.clone(), term.rate.clone()), None)];
    };
    let (sine, cosine) = (Wave { is_sine: true, ..wave.clone() }, Wave { is_sine: false, ..wave.clone() });
    let square = |of: &Expr| build.whole_power(of, 2);
    let below = build.sum(vec![square(&term.rate), square(&wave.rate)]);
    let of = |rate: &Expr| build.quotient(build.product(vec![term.factor.clone(), rate.clone()]), below.clone());
    let (by_rate, by_wave) = match is_zero(&term.rate) {
        true => (build.whole(0), build.quotient(term.factor.clone(), wave.rate.clone())),
        false => (of(&term.rate), of(&wave.rate)),
    };
    // ∫e^{αx} sin ωx = e^{αx}(α sin ωx − ω cos ωx)/(α² + ω²), and ∫e^{αx} cos ωx = e^{αx}(α cos ωx + ω sin ωx)/(α² + ω²)
    let parts = match wave.is_sine {
        true => [with(by_rate, Some(sine)), with(build.negative(by_wave), Some(cosine))],
        false => [with(by_rate, Some(cosine)), with(by_wave, Some(sine))],
    };
    parts.into_iter().filter(|part| !is_zero(&part.factor)).collect()
}

/// The value of an antiderivative at an end. What decays is 0 at infinity.
fn value_at(ring: In, terms: &[Monomial], end: &End, guards: &mut Vec<Guard>) -> Result<Expr, NoFormula> {
    let build = ring.build;
    let End::At(x) = end else {
        for term in terms.iter().filter(|term| !is_zero(&term.factor)) {
            if is_zero(&term.rate) {
                return Err(NoFormula::Diverges);
            }
            let zero = build.whole(0);
            guards.push(match end {
                End::MinusInfinity => Guard { above: term.rate.clone(), below: zero },
                _ => Guard { above: zero, below: term.rate.clone() },
            });
        }
        return Ok(build.whole(0));
    };
    Ok(build.sum(terms.iter().map(|term| ring.at(term, x)).collect()))
}

/// The integral of c·xⁿ·e^{−ax²+bx+d}·cos(ωx) over the whole line or, for b = ω = 0, over a half of it.
fn gaussian(ring: In, term: &Monomial, ends: (&End, &End), guards: &mut Vec<Guard>) -> Option<Expr> {
    let build = ring.build;
    let width = build.negative(term.square.clone());
    let is_centred = is_zero(&term.rate) && term.wave.is_none();
    let is_half = match ends {
        (End::MinusInfinity, End::Infinity) => false,
        (End::At(from), End::Infinity) if is_zero(from) && is_centred => true,
        _ => return None,
    };
    let pi = build.node(Node::Pi);
    guards.push(Guard { above: width.clone(), below: build.whole(0) });
    let whole_line = build.root(build.quotient(pi, width.clone()));
    let mut exponent = vec![term.shift.clone()];
    let half = |line: Expr| if is_half { build.quotient(line, build.whole(2)) } else { line };
    let four_widths = build.product(vec![build.whole(4), width.clone()]);
    let size = match (term.power, &term.wave) {
        (0, None) => {
            exponent.push(build.quotient(build.whole_power(&term.rate, 2), four_widths));
            half(whole_line)
        }
        (0, Some(wave)) if is_zero(&term.rate) && is_zero(&wave.phase) => {
            if wave.is_sine {
                return Some(build.whole(0));
            }
            let lost = build.quotient(build.whole_power(&wave.rate, 2), four_widths);
            exponent.push(build.negative(lost));
            whole_line
        }
        (power, None) if is_centred && power % 2 == 0 => {
            // (n − 1)!!/(2a)^{n/2}·√(π/a)
            let odd = (1..power).step_by(2).try_fold(1_u32, u32::checked_mul)?;
            let below = build.whole_power(&build.product(vec![build.whole(2), width.clone()]), power / 2);
            half(build.product(vec![build.quotient(build.whole(odd), below), whole_line]))
        }
        (_, None) if is_centred && !is_half => build.whole(0),
        (power, None) if is_centred => {
            // k!/(2a^{k+1}) for n = 2k + 1
            let k = power / 2;
            let factorial = (1..=k).try_fold(1_u32, u32::checked_mul)?;
            let below = build.product(vec![build.whole(2), build.whole_power(&width, k + 1)]);
            build.quotient(build.whole(factorial), below)
        }
        _ => return None,
    };
    let exponent = build.sum(exponent);
    Some(build.product(vec![term.factor.clone(), size, build.exp(exponent)]))
}
