//! Numbers with units by the package siunitx: `\SI{9.8}{m/s^2}`, `\qty{1.5e3}{\kilo\metre\per\hour}`, `\unit{\joule}`.
//!
//! Each becomes a number and upright units, as authors write them without the package.

use crate::code::Code;
use crate::formula::units::Unit;
use crate::source::{Fault, Span};

use super::super::lexer::{Token, TokenKind, tokens};
use super::parameters::{argument, bracketed};

/// The macros of the package that print a unit.
pub(super) const NAMES: [&str; 3] = ["\\SI", "\\si", "\\unit"];

/// Those that print several quantities, which are no formula.
pub(super) const LISTS: [&str; 6] = ["\\qtyrange", "\\SIrange", "\\numlist", "\\SIlist", "\\qtylist", "\\numrange"];

fn lacks_argument(name: &str, span: Span) -> Fault {
    Fault::new(span, format!("an argument of {name} is missing"))
        .code(Code::UnknownCommand)
        .help("write each argument in braces, and close them")
}

fn with_place(text: &str, span: Span) -> impl Iterator<Item = Token> {
    tokens(text).into_iter().map(move |token| Token { kind: token.kind, span })
}

/// A number with its unit, or a unit alone, whose arguments are next in the reversed input.
///
/// # Errors
/// For an argument that is missing or is no number, and for a unit that is unknown.
pub(super) fn quantity(name: &str, span: Span, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
    bracketed(pending);
    let mut found = Vec::new();
    if !matches!(name, "\\si" | "\\unit") {
        let digits = argument(pending).ok_or_else(|| lacks_argument(name, span))?;
        bracketed(pending);
        found = number(&digits, span)?;
    }
    let inner = argument(pending).ok_or_else(|| lacks_argument(name, span))?;
    found.extend(units(inner, span)?);
    Ok(found)
}

/// A number as the package writes it: `1.5e3`, `-2,5`, `1.5 x 10^3`.
///
/// # Errors
/// For an uncertainty in parentheses and for letters.
pub(super) fn number(digits: &[Token], span: Span) -> Result<Vec<Token>, Fault> {
    let is_power = |token: &Token| matches!(token.kind, TokenKind::Letter('e' | 'E'));
    let (mantissa, power) = match digits.iter().position(is_power) {
        Some(at) => (&digits[..at], Some(&digits[at + 1..])),
        None => (digits, None),
    };
    let mut found = Vec::new();
    for token in mantissa {
        match &token.kind {
            TokenKind::Space(_) => {}
            TokenKind::Other(',') => found.push(Token { kind: TokenKind::Digit('.'), span: token.span }),
            TokenKind::Digit(_)
            | TokenKind::Other('-' | '+')
            | TokenKind::Open
            | TokenKind::Close
            | TokenKind::Super => {
                found.push(token.clone());
            }
            TokenKind::Command(name)
                if ["\\pm", "\\pi", "\\times", "\\cdot", "\\frac", "\\sqrt"].contains(&name.as_str()) =>
            {
                found.push(token.clone());
            }
            _ => {
                return Err(Fault::unsupported(token.span, "this number of siunitx is not supported")
                    .help("write it as 1.5e3; leave out an uncertainty in parentheses"));
            }
        }
    }
    if let Some(power) = power {
        found.extend(with_place(if mantissa.is_empty() { "10^{" } else { "\\cdot 10^{" }, span));
        found.extend(power.iter().filter(|token| !matches!(token.kind, TokenKind::Space(_))).cloned());
        found.extend(with_place("}", span));
    }
    Ok(found)
}

/// The unit as upright words.
fn units(inner: Vec<Token>, span: Span) -> Result<Vec<Token>, Fault> {
    let is_name = |token: &Token| match &token.kind {
        TokenKind::Command(name) => !["\\cdot", "\\mu", "\\Omega", "\\%", "\\degree"].contains(&name.as_str()),
        _ => false,
    };
    if inner.iter().any(is_name) || matches!(inner.as_slice(), [Token { kind: TokenKind::Command(_), .. }]) {
        return named(inner, span);
    }
    let mut found: Vec<Token> = with_place("\\,\\mathrm{", span).collect();
    found.extend(inner.into_iter().map(|token| match token.kind {
        // A point and a tilde stand between factors.
        TokenKind::Other('.') | TokenKind::Digit('.') => {
            Token { kind: TokenKind::Command("\\cdot".to_owned()), span: token.span }
        }
        _ => token,
    }));
    found.extend(with_place("}", span));
    Ok(found)
}

/// The unit from the names of the package, `\kilo\metre\per\second\squared`.
fn named(inner: Vec<Token>, span: Span) -> Result<Vec<Token>, Fault> {
    let mut pending: Vec<Token> = inner.into_iter().rev().collect();
    let mut factors: Vec<(String, i32)> = Vec::new();
    let (mut prefix, mut sign, mut power) = (String::new(), 1, 1);
    while let Some(token) = pending.pop() {
        let unknown = || {
            Fault::unsupported(token.span, "this unit of siunitx is not supported")
                .help("write the unit in SI units, as in \\SI{9.8}{m/s^2}")
        };
        let name = match &token.kind {
            TokenKind::Command(name) => name.trim_start_matches('\\'),
            TokenKind::Space(_) | TokenKind::Other('.') => continue,
            _ => return Err(unknown()),
        };
        let raise = |factors: &mut Vec<(String, i32)>, by: i32| match factors.last_mut() {
            Some((_, exponent)) => {
                *exponent *= by;
                Ok(())
            }
            None => Err(unknown()),
        };
        match name {
            "per" => sign = -1,
            "square" => power = 2,
            "cubic" => power = 3,
            "squared" => raise(&mut factors, 2)?,
            "cubed" => raise(&mut factors, 3)?,
            "tothe" => raise(&mut factors, whole(&mut pending).ok_or_else(unknown)?)?,
            "raiseto" => power = whole(&mut pending).ok_or_else(unknown)?,
            "kilo" | "mega" | "giga" | "tera" | "peta" | "hecto" | "deci" | "centi" | "milli" | "micro" | "nano"
            | "pico" | "femto" => name.clone_into(&mut prefix),
            _ => {
                let unit = match name {
                    "percent" | "%" => Unit::named("%"),
                    "astronomicalunit" => Unit::named("au"),
                    _ => Unit::spelled(&format!("{prefix}{name}")).or_else(|| {
                        let short = name.strip_prefix('u').map(|rest| format!("µ{rest}"));
                        Unit::named(name).or_else(|| Unit::named(&short?)).filter(|_| prefix.is_empty())
                    }),
                };
                factors.push((unit.ok_or_else(unknown)?.spelling(), sign * power));
                (prefix, sign, power) = (String::new(), 1, 1);
            }
        }
    }
    let text: String = factors.iter().map(|(name, exponent)| format!("\\,\\text{{{name}}}^{{{exponent}}}")).collect();
    Ok(with_place(&text, span).collect())
}

/// The whole number in the next group.
fn whole(pending: &mut Vec<Token>) -> Option<i32> {
    let digits: String = argument(pending)?
        .into_iter()
        .map(|token| match token.kind {
            TokenKind::Digit(c) | TokenKind::Other(c) => c,
            _ => ' ',
        })
        .collect();
    digits.parse().ok().filter(|value: &i32| (1..=12).contains(&value.abs()))
}

#[cfg(test)]
mod tests {
    use super::super::Macros;
    use super::*;

    fn kinds(text: &str) -> Vec<TokenKind> {
        let found = Macros::default().expand(tokens(text)).unwrap();
        found.into_iter().map(|token| token.kind).collect()
    }

    #[test]
    fn quantities_are_numbers_and_upright_words() {
        for (short, long) in [
            ("\\SI{9.8}{m/s^2}", "9.8\\,\\mathrm{m/s^2}"),
            ("\\qty{1.5e-3}{kg.m^2}", "1.5\\cdot 10^{-3}\\,\\mathrm{kg\\cdot m^2}"),
            (
                "\\SI[per-mode=symbol]{2}{\\kilo\\metre\\per\\second\\squared}",
                "2\\,\\text{kilometre}^{1}\\,\\text{second}^{-2}",
            ),
            ("\\qty{2}{\\km\\per\\square\\s}", "2\\,\\text{kilometre}^{1}\\,\\text{second}^{-2}"),
            ("\\SI{2,5}{\\uF}", "2.5\\,\\text{microfarad}^{1}"),
            ("5 \\unit{\\joule}", "5 \\,\\text{joule}^{1}"),
            ("\\qty{5}{\\percent}", "5\\,\\text{\\%}^{1}"),
        ] {
            assert_eq!(kinds(short), kinds(long), "{short}");
        }
        // must-fail cases: another scale, an uncertainty, what is no unit, an argument that is missing
        for broken in
            ["\\SI{25}{\\celsius}", "\\SI{2.5(3)}{m}", "\\SI{2}{\\apples}", "\\SI{2}", "\\unit", "\\SI{2}{\\squared}"]
        {
            assert!(Macros::default().expand(tokens(broken)).is_err(), "{broken}");
        }
    }
}
