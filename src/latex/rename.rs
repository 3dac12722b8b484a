//! Other letters: a LaTeX text in which names are replaced by other names.

use std::collections::HashMap;

use crate::formula::symbols::Name;
use crate::formula::tree::Function;
use crate::source::Span;

use super::layout::{Item, Layout, typeset_items};
use super::macros::Macros;
use super::{foreign, names, overdots};

/// A text with other names, and where its bytes come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Renamed {
    /// The text.
    pub text: String,
    /// The pieces of the text in order: where each begins in the text, and the bytes of the original that it stands for.
    places: Vec<(usize, Span)>,
}

impl Renamed {
    /// The same text, with no name replaced.
    pub fn unchanged(text: &str) -> Renamed {
        Renamed { text: text.to_owned(), places: vec![(0, Span::new(0, text.len()))] }
    }

    /// The bytes of the original for bytes of the text.
    #[cfg(feature = "cli")]
    pub fn original(&self, span: Span) -> Span {
        let at = |offset: usize, is_end: bool| {
            let mut pieces = self.places.iter().enumerate();
            let within =
                |(_, (start, _)): &(usize, &(usize, Span))| if is_end { *start < offset } else { *start <= offset };
            let Some((n, (start, from))) = pieces.rfind(within) else { return 0 };
            let length = self.places.get(n + 1).map_or(self.text.len(), |(next, _)| *next) - start;
            match (length == from.end - from.start, is_end) {
                (true, _) => (from.start + offset - start).min(from.end),
                (false, true) => from.end,
                (false, false) => from.start,
            }
        };
        let start = at(span.start, false);
        Span::new(start, if span.end > span.start { at(span.end, true).max(start) } else { start })
    }
}

/// A text in which each name of a table is replaced, and what is written by hand is made readable ([`foreign`]).
/// Overdots and powers stay.
pub fn renamed(text: &str, macros: &Macros, table: &HashMap<Name, Name>) -> Renamed {
    renamed_with(text, macros, table, &[])
}

/// The same, with further edits of the text, which come before all others.
pub fn renamed_with(text: &str, macros: &Macros, table: &HashMap<Name, Name>, others: &[(Span, String)]) -> Renamed {
    let Ok(items) = typeset_items(text, macros) else { return Renamed::unchanged(text) };
    let mut edits: Vec<(Span, String)> = Vec::new();
    for item in &items {
        collect(item, text, table, &mut edits);
    }
    edits.extend(foreign::edits(text));
    // Two edits of one place contradict each other.
    edits.retain(|(span, _)| {
        !others.iter().any(|(other, _)| other.start < span.end.max(span.start + 1) && span.start < other.end)
    });
    edits.extend_from_slice(others);
    edits.sort_by_key(|(span, _): &(Span, String)| (span.start, span.end));
    edits.dedup();
    let mut renamed = Renamed { text: String::new(), places: Vec::new() };
    let mut from = 0;
    for (span, replacement) in edits {
        if span.start < from {
            continue;
        }
        renamed.push_apart(&text[from..span.start], Span::new(from, span.start));
        let next = text[span.end..].chars().next();
        let is_command = replacement.starts_with('\\') && replacement.ends_with(|c: char| c.is_ascii_alphabetic());
        let space = if is_command && next.is_some_and(|c| c.is_ascii_alphabetic()) { " " } else { "" };
        let before = renamed.text.ends_with(|c: char| c.is_ascii_alphabetic())
            && ends_with_command(&renamed.text)
            && replacement.starts_with(|c: char| c.is_ascii_alphabetic());
        let replacement = format!("{}{replacement}{space}", if before { " " } else { "" });
        renamed.push(&replacement, span);
        from = span.end;
    }
    renamed.push_apart(&text[from..], Span::new(from, text.len()));
    renamed
}

impl Renamed {
    /// Adds a piece of the original, apart from a command that stands before it now: `\omega_0t` with ω for ω_0.
    fn push_apart(&mut self, text: &str, from: Span) {
        let is_letter = text.starts_with(|c: char| c.is_ascii_alphabetic());
        if is_letter
            && from.start > 0
            && ends_with_command(&self.text)
            && self.text.ends_with(|c: char| c.is_ascii_alphabetic())
        {
            self.push(" ", Span::new(from.start, from.start));
        }
        self.push(text, from);
    }

    fn push(&mut self, text: &str, from: Span) {
        if !text.is_empty() {
            self.places.push((self.text.len(), from));
            self.text.push_str(text);
        }
    }
}

fn ends_with_command(text: &str) -> bool {
    text.trim_end_matches(|c: char| c.is_ascii_alphabetic()).ends_with('\\')
}

/// Whether a text ends with a function, perhaps with its power: `\cos`, `\sin^2`.
fn stands_after_a_function(text: &str) -> bool {
    let before = text.trim_end();
    let is_power = |power: &str| power.trim_matches(['{', '}', ' ']).parse::<u8>().is_ok();
    let before = before.rsplit_once('^').filter(|(_, power)| is_power(power)).map_or(before, |(before, _)| before);
    let before = before.trim_end();
    let command = before.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    command.ends_with('\\') && Function::named(&before[command.len()..]).is_some()
}

fn collect(item: &Item, text: &str, table: &HashMap<Name, Name>, edits: &mut Vec<(Span, String)>) {
    if let Some(printed) = names::printed(item, None) {
        let spelled = |span: Span| text.get(span.range()).and_then(names::parse).is_some();
        if let Some(new) = table.get(&printed.name)
            && let Some((core, rest)) = parts(item, text)
            && spelled(core)
        {
            let new = new.to_string();
            // In braces it would be the whole argument of a function: `\cos{\omega_1} t`.
            let is_composed = new.contains(['_', '{']) && !stands_after_a_function(&text[..core.start]);
            edits.push((core, if is_composed { format!("{{{new}}}") } else { new }));
            edits.extend(rest.map(|rest| (rest, String::new())));
        }
        if let Some(sup) = printed.sup {
            collect(sup, text, table, edits);
        }
        return;
    }
    let mut inside = |items: &[Item]| items.iter().for_each(|item| collect(item, text, table, edits));
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => inside(items),
        Layout::Fraction(a, b) => {
            inside(std::slice::from_ref(a));
            inside(std::slice::from_ref(b));
        }
        Layout::Root(index, body) => {
            index.iter().for_each(|index| inside(std::slice::from_ref(index)));
            inside(std::slice::from_ref(body));
        }
        Layout::Accent(_, body) | Layout::Style(_, body) => inside(std::slice::from_ref(body)),
        Layout::Scripts { nucleus, sub, sup, .. } => {
            inside(std::slice::from_ref(nucleus));
            sub.iter().chain(sup).for_each(|script| inside(std::slice::from_ref(script)));
        }
        Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| inside(cell)),
        _ => {}
    }
}

/// The bytes of a name that its replacement takes, and those of its subscript and its primes, where these stand apart.
fn parts(item: &Item, text: &str) -> Option<(Span, Option<Span>)> {
    match &item.layout {
        Layout::Accent(command, inner) if overdots::order(command).is_some() => parts(inner, text),
        Layout::Group(items) => match items.as_slice() {
            [single] => parts(single, text),
            _ => None,
        },
        Layout::Scripts { nucleus, sub, sup, primes: 0 } => {
            let (core, rest) = parts(nucleus, text)?;
            let Some(sub) = sub else { return Some((core, rest)) };
            if rest.is_some() {
                return None;
            }
            let from = match sup {
                Some(sup) if sup.span.end <= sub.span.start => sup.span.end,
                _ => nucleus.span.end,
            };
            Some((core, Some(Span::new(from, sub.span.end))))
        }
        Layout::Scripts { nucleus, sub, sup, .. } => {
            let (core, None) = parts(nucleus, text)? else { return None };
            let end = match sup {
                Some(sup) if sub.as_ref().is_none_or(|sub| sub.span.end <= sup.span.start) => {
                    text.get(..sup.span.start)?.rfind('^').filter(|at| *at >= nucleus.span.end)?
                }
                Some(_) => return None,
                None => item.span.end,
            };
            Some((core, Some(Span::new(nucleus.span.end, end))))
        }
        _ => Some((item.span, None)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(text: &str, pairs: &[(&str, &str)]) -> Renamed {
        let name = |text: &str| names::parse(text).unwrap().0;
        let table = pairs.iter().map(|(a, b)| (name(a), name(b))).collect();
        renamed(text, &Macros::default(), &table)
    }

    #[test]
    fn names_are_replaced_with_their_dots_and_powers() {
        let pairs = [("\\varphi", "\\theta"), ("R", "l"), ("m_1", "m")];
        assert_eq!(with(r"\ddot\varphi = -\frac gR\sin\varphi", &pairs).text, r"\ddot\theta = -\frac gl\sin\theta");
        assert_eq!(with(r"m_1R^2\dot\varphi^2", &pairs).text, r"ml^2\dot\theta^2");
        assert_eq!(with(r"\frac{d\varphi}{dt}", &pairs).text, r"\frac{d\theta}{dt}");
        assert_eq!(with("ab", &[("a", "\\theta")]).text, r"\theta b");
        assert_eq!(with("a^2", &[("a", "v_0")]).text, "{v_0}^2");
        assert_eq!(with("v_1' + v_1'^2 + v'_2", &[("v_1'", "u_1"), ("v_2'", "w")]).text, "{u_1} + {u_1}^2 + w");
        // After a function the rest of the product stays in its argument.
        assert_eq!(with(r"\cos\Omega t", &[("\\Omega", "\\omega_1")]).text, r"\cos\omega_1 t");
        assert_eq!(with(r"\sin^2 \Omega t", &[("\\Omega", "\\omega_1")]).text, r"\sin^2 \omega_1 t");
        assert_eq!(with(r"\frac b2 \sqrt b", &[("b", "a_1")]).text, r"\frac {a_1}2 \sqrt {a_1}");
        // The twin: a name that only begins alike stays.
        assert_eq!(with("v_1 + v_1''", &[("v_1'", "u_1")]).text, "v_1 + v_1''");
        assert_eq!(with("m_2 R_1", &pairs).text, "m_2 R_1");
    }

    #[test]
    fn functions_of_other_languages_are_read() {
        assert_eq!(with(r"\operatorname{sen}\alpha", &[]).text, r"\sin\alpha");
        assert_eq!(with(r"\mathrm{tg}x", &[]).text, r"\tan x");
        assert_eq!(with(r"g\cos^2\alpha/(M+m)", &[]).text, r"g\cos^2(\alpha)/(M+m)");
        assert_eq!(with(r"\sin x / \cos x", &[]).text, r"\sin (x) / \cos x");
        // The twins: half an angle may be meant.
        assert_eq!(with(r"\cos\alpha/2", &[]).text, r"\cos\alpha/2");
        assert_eq!(with(r"v_{\mathrm{sen}}", &[]).text, r"v_{\mathrm{sen}}");
    }

    #[test]
    fn two_letters_may_change_places() {
        assert_eq!(with("a b", &[("a", "b"), ("b", "a")]).text, "b a");
    }

    #[test]
    fn places_lead_back_to_the_original() {
        let text = r"\ddot\varphi = -\frac gR\sin\varphi";
        let new = with(text, &[("\\varphi", "\\theta"), ("R", "l")]);
        let at = new.text.find("- ").unwrap_or(new.text.find('-').unwrap());
        let back = new.original(Span::new(at, at + 1));
        assert_eq!(&text[back.range()], "-");
        let at = new.text.find("\\sin").unwrap();
        assert_eq!(&text[new.original(Span::new(at, new.text.len())).range()], r"\sin\varphi");
    }
}
