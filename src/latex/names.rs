//! Names in the layout: the base with its accents, the subscript, the primes, and the overdots.
//!
//! Each name has one spelling: `\vec{r_i}` is `\vec{r}_i`, `p_{\psi}` is `p_\psi`, `T_{\mathrm{rot}}` is `T_{rot}`,
//! `\dot{\hat{e}_a}` is `\dot{\hat e}_a`, `x^\prime` is `x'`. Overdots (`overdots`) and powers are not part of a name.

use crate::formula::symbols::Name;
use crate::formula::text::plain as plain_text;
use crate::formula::tree::Sign;

#[cfg(feature = "notes")]
use super::layout::values;
use super::layout::{Delimiter, Item, Layout, layout};
use super::lexer::tokens;
use super::normalize::normalized;
use super::overdots;

/// A name as it was printed.
#[derive(Clone, Debug, PartialEq)]
pub struct Printed<'a> {
    /// The name itself.
    pub name: Name,
    /// The number of overdots.
    pub dots: u8,
    /// The superscript, if it is no prime.
    pub sup: Option<&'a Item>,
}

/// The name that an item is, if it is one. `branch` is the sign of `\pm` in a subscript.
pub fn printed(item: &Item, branch: Option<Sign>) -> Option<Printed<'_>> {
    match &item.layout {
        Layout::Letter(c) => Some(plain(c.to_string())),
        Layout::Command(command) if is_letter(command) => Some(plain(command.clone())),
        #[cfg(feature = "notes")]
        Layout::Value(latex) => Some(plain(latex.clone())),
        Layout::Group(items) => match items.as_slice() {
            [single] => printed(single, branch),
            _ => None,
        },
        // What is struck out is no other name.
        Layout::Accent(command, _) if command == "\\cancel" => None,
        Layout::Accent(command, inner) => {
            let mut inner = printed(inner, branch).filter(|inner| inner.sup.is_none())?;
            match overdots::order(command) {
                Some(order) => inner.dots += order,
                None => inner.name.base = format!("{command}{{{}}}", inner.name.base),
            }
            Some(inner)
        }
        Layout::Style(style, inner) => match &inner.layout {
            Layout::Group(items) if items.len() > 1 && style == "\\mathrm" => {
                let end =
                    items.iter().rposition(|item| !matches!(item.layout, Layout::Other('.'))).map_or(0, |at| at + 1);
                let word: Option<String> = items[..end].iter().map(word_letter).collect();
                Some(plain(format!("\\mathrm{{{}}}", word?)))
            }
            // `\mathcal{GP}` is one name.
            Layout::Group(items)
                if items.len() > 1
                    && style == "\\mathcal"
                    && items.iter().all(|item| matches!(item.layout, Layout::Letter(_))) =>
            {
                let word: Option<String> = items.iter().map(word_letter).collect();
                Some(plain(format!("\\mathcal{{{}}}", word?)))
            }
            _ => {
                let mut inner = printed(inner, branch).filter(|inner| inner.sup.is_none())?;
                inner.name.base = format!("{style}{{{}}}", inner.name.base);
                Some(inner)
            }
        },
        Layout::Scripts { nucleus, sub, sup, primes } => {
            let mut printed = printed(nucleus, branch).filter(|nucleus| nucleus.sup.is_none())?;
            if let Some(sub) = sub {
                if !printed.name.subscript.is_empty() {
                    return None;
                }
                subscript(sub, branch, &mut printed.name.subscript)?;
            }
            printed.name.primes = printed.name.primes.saturating_add(*primes);
            if let Some(sup) = sup {
                match prime_marks(sup) {
                    Some(marks) => printed.name.primes = printed.name.primes.saturating_add(marks),
                    None => match label(sup).filter(|_| printed.dots == 0 && !is_euler(&printed.name.base)) {
                        Some(label) => printed.name.base = format!("{}^{{{label}}}", printed.name.base),
                        None => printed.sup = Some(sup),
                    },
                }
            }
            Some(printed)
        }
        _ => None,
    }
}

/// The items of a formula that may stand for one name, such as `\langle E \rangle`; `None` for a name and for anything else.
#[cfg(feature = "notes")]
pub(crate) fn value(text: &str) -> Option<Vec<Item>> {
    let items = layout(&normalized(tokens(text)), text.len());
    (parse_name(&items).is_none() && values::is_value(&items)).then_some(items)
}

/// The name that a whole text is, as in a claims file or on a command line, with the number of its overdots.
pub fn parse(text: &str) -> Option<(Name, u8)> {
    parse_name(&layout(&normalized(tokens(text)), text.len()))
}

/// `\Delta x` and `\delta x`, each of which is one name.
pub(crate) fn difference<'i>(mark: &Item, rest: &'i Item, branch: Option<Sign>) -> Option<Printed<'i>> {
    let Layout::Command(command) = &mark.layout else { return None };
    if !matches!(command.as_str(), "\\Delta" | "\\delta") {
        return None;
    }
    let mut printed = printed(rest, branch)?;
    printed.name.base = format!("{command} {}", printed.name.base);
    Some(printed)
}

fn parse_name(items: &[Item]) -> Option<(Name, u8)> {
    let item = match items {
        [only] => only,
        [mark, rest] => {
            let printed = difference(mark, rest, None).filter(|printed| printed.sup.is_none())?;
            return Some((printed.name, printed.dots));
        }
        _ => return None,
    };
    let printed = printed(item, None).filter(|printed| printed.sup.is_none())?;
    Some((printed.name, printed.dots))
}

/// The name with up to three overdots in its base; `None` for more.
pub fn with_dots(name: &Name, dots: u8) -> Option<Name> {
    if dots == 0 {
        return Some(name.clone());
    }
    let accent = overdots::accent(dots)?;
    Some(Name { base: format!("{accent}{{{}}}", name.base), ..name.clone() })
}

/// A name without its accents: `r_1` for `\vec{r}_1`.
pub(super) fn unaccented(name: &Name) -> Name {
    let mut base = name.base.as_str();
    while let Some((_, inner)) = base.strip_suffix('}').and_then(|base| base.split_once('{')) {
        base = inner;
    }
    Name { base: base.to_owned(), ..name.clone() }
}

fn plain(base: String) -> Printed<'static> {
    Printed { name: Name::plain(base), dots: 0, sup: None }
}

fn word_letter(item: &Item) -> Option<char> {
    match item.layout {
        Layout::Letter(c) => Some(c),
        _ => None,
    }
}

/// A mark above a name that is no power: a word, `^{\text{ext}}`; a sign, `^+`; a number in parentheses, `^{(0)}`.
fn label(sup: &Item) -> Option<String> {
    let items: Vec<&Item> = match &sup.layout {
        Layout::Group(items) => items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect(),
        _ => vec![sup],
    };
    match items.as_slice() {
        [Item { layout: Layout::Other(c @ ('+' | '-')), .. }] => Some(c.to_string()),
        [Item { layout: Layout::Text(word), .. }] if is_label(word) => Some(format!("\\text{{{word}}}")),
        [Item { layout: Layout::Style(style, inner), .. }] if style == "\\mathrm" => match &inner.layout {
            Layout::Group(letters) => {
                let word: Option<String> = letters.iter().map(word_letter).collect();
                word.filter(|word| is_label(word)).map(|word| format!("\\text{{{word}}}"))
            }
            _ => None,
        },
        [Item { layout: Layout::Fence(Delimiter::Round, inside), .. }] => match inside.as_slice() {
            [Item { layout: Layout::Number(digits), .. }] if digits.len() == 1 => Some(format!("({digits})")),
            _ => None,
        },
        _ => None,
    }
}

/// Whether a base may be Euler's number, above which a sign is a forgotten exponent.
fn is_euler(base: &str) -> bool {
    base == "e" || base == "\\mathrm{e}"
}

/// Whether a word above a name is a label: no ending of an ordinal number.
fn is_label(word: &str) -> bool {
    word.len() > 1 && word.chars().all(|c| c.is_ascii_alphabetic()) && !["th", "st", "nd", "rd"].contains(&word)
}

/// `^\prime`, `^{\prime\prime}`.
fn prime_marks(sup: &Item) -> Option<u8> {
    match &sup.layout {
        Layout::Command(name) if name == "\\prime" => Some(1),
        Layout::Group(items) if !items.is_empty() => {
            let marks = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).map(prime_marks);
            marks.sum::<Option<u8>>().filter(|marks| *marks > 0)
        }
        _ => None,
    }
}

/// Whether a command may be an index: one that prints a letter or a sign.
pub(super) fn is_index_sign(name: &str) -> bool {
    !plain_text(name).starts_with('\\')
}

/// Whether a number or a letter stands above or below the line of a fraction in an index.
fn is_index_part(item: &Item) -> bool {
    let items = if let Layout::Group(items) = &item.layout { items.as_slice() } else { std::slice::from_ref(item) };
    matches!(items, [Item { layout: Layout::Number(_) | Layout::Letter(_), .. }])
}

/// Appends the tokens of a subscript; `None` if it is not the subscript of a name.
fn subscript(item: &Item, branch: Option<Sign>, tokens: &mut Vec<String>) -> Option<()> {
    match &item.layout {
        Layout::Letter(c) | Layout::Other(c) => tokens.push(c.to_string()),
        Layout::Number(digits) => tokens.extend(digits.chars().map(String::from)),
        Layout::Command(name) => match (name.as_str(), branch) {
            ("\\pm", Some(sign)) => tokens.push(glyph(sign).to_owned()),
            ("\\mp", Some(sign)) => tokens.push(glyph(sign.flipped()).to_owned()),
            ("\\pm" | "\\mp", None) => return None,
            ("\\prime", _) => tokens.push("'".to_owned()),
            // An unknown command is no index: `E_\boldit{p}`.
            _ if !is_index_sign(name) => return None,
            _ => tokens.push(name.clone()),
        },
        Layout::Space(_) => {}
        // `\omega_{1,2} = … \pm …`: the first index has the upper sign.
        Layout::Group(items) => match (items.as_slice(), branch) {
            ([first, Item { layout: Layout::Other(','), .. }, second], Some(sign))
                if [first, second]
                    .iter()
                    .all(|index| matches!(index.layout, Layout::Number(_) | Layout::Other('+' | '-'))) =>
            {
                subscript(if sign == Sign::Plus { first } else { second }, branch, tokens)?;
            }
            _ => items.iter().try_for_each(|inner| subscript(inner, branch, tokens))?,
        },
        Layout::Fence(Delimiter::Round, items) => {
            tokens.push("(".to_owned());
            items.iter().try_for_each(|inner| subscript(inner, branch, tokens))?;
            tokens.push(")".to_owned());
        }
        // `\phi_{j+\frac12}`
        Layout::Fraction(above, below) if [above, below].iter().all(|part| is_index_part(part)) => {
            subscript(above, branch, tokens)?;
            tokens.push("/".to_owned());
            subscript(below, branch, tokens)?;
        }
        Layout::Style(style, inner) if style == "\\mathrm" => subscript(inner, branch, tokens)?,
        Layout::Text(word) => tokens.extend(word.chars().map(String::from)),
        Layout::Accent(..) | Layout::Style(..) => {
            let inner = printed(item, branch).filter(|inner| inner.sup.is_none())?;
            tokens.push(match inner.dots {
                0 => inner.name.to_string(),
                dots => format!("{}{{{}}}", overdots::accent(dots)?, inner.name),
            });
        }
        Layout::Scripts { nucleus, sub, sup: None, primes } => {
            subscript(nucleus, branch, tokens)?;
            tokens.extend((0..*primes).map(|_| "'".to_owned()));
            if let Some(sub) = sub {
                tokens.extend(["_".to_owned(), "{".to_owned()]);
                subscript(sub, branch, tokens)?;
                tokens.push("}".to_owned());
            }
        }
        _ => return None,
    }
    Some(())
}

fn glyph(sign: Sign) -> &'static str {
    match sign {
        Sign::Plus => "+",
        Sign::Minus => "-",
    }
}

/// Whether a command is a letter, such as `\theta`.
pub fn is_letter(command: &str) -> bool {
    const LETTERS: [&str; 47] = [
        "varpi",
        "alpha",
        "beta",
        "gamma",
        "delta",
        "epsilon",
        "varepsilon",
        "zeta",
        "eta",
        "theta",
        "vartheta",
        "iota",
        "kappa",
        "varkappa",
        "lambda",
        "mu",
        "nu",
        "xi",
        "omicron",
        "pi",
        "varpi",
        "rho",
        "varrho",
        "sigma",
        "varsigma",
        "tau",
        "upsilon",
        "phi",
        "varphi",
        "chi",
        "psi",
        "omega",
        "Gamma",
        "Delta",
        "Theta",
        "Lambda",
        "Xi",
        "Pi",
        "Sigma",
        "Upsilon",
        "Phi",
        "Psi",
        "Omega",
        "ell",
        "hbar",
        "imath",
        "jmath",
    ];
    command.strip_prefix('\\').is_some_and(|name| LETTERS.contains(&name))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(text: &str) -> (String, u8) {
        let items = layout(&tokens(text), text.len());
        let printed = printed(&items[0], Some(Sign::Minus)).unwrap();
        (printed.name.to_string(), printed.dots)
    }

    #[test]
    fn one_name_has_one_spelling() {
        for (a, b) in [
            ("\\vec{r_i}", "\\vec r_{i}"),
            ("p_{\\psi}", "p_\\psi"),
            ("T_{\\mathrm{rot}}", "T_{rot}"),
            ("\\dot{\\hat{e}_a}", "\\dot{\\hat e}_a"),
            ("x^\\prime", "x'"),
            ("\\Omega_\\pm", "\\Omega_{-}"),
        ] {
            assert_eq!(name(a), name(b));
        }
    }

    #[test]
    fn different_names_stay_different() {
        for (a, b) in
            [("\\phi", "\\varphi"), ("M", "m"), ("\\vec r", "r"), ("r_1", "r_2"), ("x'", "x"), ("\\dot x", "x")]
        {
            assert_ne!(name(a), name(b));
        }
    }
}
