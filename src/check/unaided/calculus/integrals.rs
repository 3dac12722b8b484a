//! Integrals in which nothing says how the integrand depends on the letter: `\int_0^t \ln\frac{m_0}{m}\,dt'`, where m is m(t').
//!
//! Such an integrand is read as a constant. What is concluded from that is no slip of the author.

use crate::formula::symbols::Name;
use crate::latex::layout::values::{ends_term, is_d, is_integral, parts_of};
use crate::latex::layout::{Item, Layout, typeset_items};
use crate::latex::{Macros, names};

/// Whether a display has an integral whose integrand contains names, of which none depends on the letter.
pub(in crate::check::unaided) fn hides_its_letter(
    text: &str,
    macros: &Macros,
    depends: &dyn Fn(&Name, &Name) -> bool,
) -> bool {
    text.contains("\\int") && typeset_items(text, macros).is_ok_and(|items| hides(&items, depends))
}

fn hides(items: &[Item], depends: &dyn Fn(&Name, &Name) -> bool) -> bool {
    let mut found = Vec::new();
    collect(items, &mut found);
    let tells = |integral: &Integral| {
        integral.names.iter().any(|name| *name == integral.letter || depends(name, &integral.letter))
    };
    found.iter().any(|integral| !integral.names.is_empty() && !tells(integral))
}

/// An integral in print: its letter, and the names in its integrand.
pub(in crate::check::unaided) struct Integral {
    pub letter: Name,
    pub names: Vec<Name>,
}

/// The integrals in items.
pub(in crate::check::unaided) fn collect(items: &[Item], found: &mut Vec<Integral>) {
    let places = (0..items.len()).filter(|at| is_integral(&items[*at]));
    found.extend(places.filter_map(|at| integral(&items[at + 1..])));
    items.iter().flat_map(parts_of).for_each(|part| collect(part, found));
}

/// The integral of which these items stand behind the sign.
fn integral(rest: &[Item]) -> Option<Integral> {
    let end = rest.iter().position(ends_relation).unwrap_or(rest.len());
    let d = rest[..end].iter().position(is_d)?;
    let after = |from: usize| rest[from..].iter().position(|item| !matches!(item.layout, Layout::Space(_)));
    let letter = after(d + 1).map(|more| d + 1 + more)?;
    let name = names::printed(&rest[letter], None)?.name;
    // `\int dx\, f` reaches to the end of the term.
    let is_first = rest[..d].iter().all(|item| matches!(item.layout, Layout::Space(_)));
    let integrand = match is_first {
        true => &rest[letter + 1..],
        false => &rest[..d],
    };
    let integrand = match integrand.iter().position(ends_term).filter(|_| is_first) {
        Some(end) => &integrand[..end],
        None => integrand,
    };
    let mut names = Vec::new();
    collect_names(integrand, &mut names);
    Some(Integral { letter: name, names })
}

fn ends_relation(item: &Item) -> bool {
    ends_term(item) && !matches!(item.layout, Layout::Other('+' | '-'))
}

/// The names in items, but for e.
fn collect_names(items: &[Item], found: &mut Vec<Name>) {
    for item in items {
        match names::printed(item, None) {
            Some(printed) if ["e", "\\pi", "d"].contains(&printed.name.base.as_str()) => {}
            Some(printed) => found.push(printed.name),
            None => {}
        }
        parts_of(item).into_iter().for_each(|part| collect_names(part, found));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_integrand_without_its_letter_may_depend_on_it() {
        let hides = |text: &str| hides_its_letter(text, &Macros::default(), &|name, _| name.base == "I");
        for text in [
            r"\int_0^t\ln\frac{m_0}{m}\,dt' = \frac{m}{b}",
            r"K = \int_0^L F \, dx",
            r"\frac{1}{T}\left(\int dt\, P\right)",
        ] {
            assert!(hides(text), "{text}");
        }
        // must-fail cases
        for text in [
            r"\int_m^{m_0}\ln\frac{m_0}{m'}\,dm'",
            r"\int_0^\infty e^{-a v^2} dv",
            r"\int_0^a dx = a",
            r"\int_0^1 2\pi\,ds + F",
            r"\int_0^a k x\,dx",
            r"\int_0^T I^2\,dt",
        ] {
            assert!(!hides(text), "{text}");
        }
    }
}
