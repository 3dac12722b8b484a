//! What many particles and continua are written with, and what it is read as, in plain words. Beside each formula that
//! must be read stand near misses that must be refused, and where.

#[path = "reading/algebra.rs"]
mod algebra;
#[path = "reading/alternatives.rs"]
mod alternatives;
#[path = "reading/apart.rs"]
mod apart;
#[path = "reading/courses.rs"]
mod courses;
#[path = "reading/derivatives.rs"]
mod derivatives;
#[path = "reading/derived.rs"]
mod derived;
#[path = "reading/fields.rs"]
mod fields;
#[path = "reading/inferred.rs"]
mod inferred;
#[path = "reading/introductions.rs"]
mod introductions;
#[path = "reading/lecture.rs"]
mod lecture;
#[path = "reading/misreadings.rs"]
mod misreadings;
#[path = "reading/near_products.rs"]
mod near_products;
#[path = "reading/notes.rs"]
mod notes;
#[path = "reading/operators.rs"]
mod operators;
#[path = "reading/particles.rs"]
mod particles;
#[path = "reading/printed_forms.rs"]
mod printed_forms;
#[path = "reading/public_notes.rs"]
mod public_notes;
#[path = "reading/quantities.rs"]
mod quantities;
#[path = "reading/reaches.rs"]
mod reaches;
#[path = "reading/roles.rs"]
mod roles;
#[path = "reading/scopes.rs"]
mod scopes;
#[path = "reading/structure.rs"]
mod structure;
#[path = "reading/uses.rs"]
mod uses;

use onshell::formula::symbols::Components;
use onshell::formula::{Kind, SymbolId, Symbols, text};
use onshell::latex::{Macros, names, read_display, read_formula, typeset};

/// The statements of a display in plain words, as `onshell read` shows them; `None` if a statement is refused.
fn statements_of(latex: &str) -> Option<String> {
    let mut symbols = Symbols::for_reading();
    let reading = read_display(latex, &mut symbols, &Macros::default());
    let statements: Result<Vec<_>, _> = reading.statements.iter().cloned().collect();
    let words: Vec<String> = statements.ok()?.iter().map(|found| text::statement(found, &symbols)).collect();
    Some(words.join(" ¦ "))
}

fn are_read(cases: &[(&str, &str)]) {
    for (latex, words) in cases {
        assert_eq!(statements_of(latex).as_deref(), Some(*words), "{latex}");
    }
}

fn are_refused(cases: &[&str]) {
    for latex in cases {
        assert_eq!(statements_of(latex), None, "{latex}");
    }
}

/// Particles i, j of n; axes a, b, c, d; a body with its mass per volume, per area and per length.
fn particles() -> Symbols {
    let mut symbols = Symbols::new();
    let n = add(&mut symbols, "n", Kind::Scalar);
    for letter in ["i", "j"] {
        symbols.add_label(letter, 4, Some(n));
    }
    for letter in ["a", "b", "c", "d"] {
        symbols.add_index(letter, 3);
    }
    for name in
        ["m_i", "M", "R", r"\rho", r"\sigma", r"\lambda", "V", "A", "L", r"\lambda_1", r"\lambda_2", r"\lambda_3"]
    {
        add(&mut symbols, name, Kind::Scalar);
    }
    for name in [
        r"\vec r",
        r"\vec r_i",
        r"\vec v_i",
        r"\vec p_i",
        r"\vec{\bar r}_i",
        r"\vec F_{(ext)i}",
        r"\vec F_{ij}",
        r"\vec r_{ij}",
        r"\vec r_{cm}",
        r"\vec\omega",
        r"\vec v",
        r"\vec r_\perp",
        r"\hat e_a",
        r"\hat x",
    ] {
        let id = add(&mut symbols, name, Kind::Vector);
        symbols.entry_mut(id).varies = true;
    }
    let place = names::parse(r"\vec r").map(|(name, _)| name);
    for (density, region, dimension) in [(r"\rho", "V", 3), (r"\sigma", "A", 2), (r"\lambda", "L", 1)] {
        let (density, region) = (find(&symbols, density), find(&symbols, region));
        symbols.entry_mut(density).argument = place.clone();
        symbols.entry_mut(region).argument = place.clone();
        let entry = symbols.entry_mut(region);
        (entry.measure, entry.density) = (Some(dimension), Some(density));
    }
    symbols
}

fn add(symbols: &mut Symbols, latex: &str, kind: Kind) -> SymbolId {
    let (name, _) = names::parse(latex).unwrap();
    symbols.add(name, kind).unwrap()
}

fn find(symbols: &Symbols, latex: &str) -> SymbolId {
    let (name, _) = names::parse(latex).unwrap();
    symbols.find(&name).unwrap().0
}

/// The formula in plain words, with combining accents left out; it is typeset so that it reads back as itself.
fn read_with(latex: &str, symbols: &mut Symbols) -> String {
    let expr = read_formula(latex, symbols, &Macros::default());
    let expr = expr.unwrap_or_else(|fault| panic!("{latex} is refused: {} {:?}", fault.message, fault.span));
    let printed = typeset(&expr, symbols);
    let again = read_formula(&printed, symbols, &Macros::default());
    let again = again.unwrap_or_else(|fault| panic!("{latex}, printed {printed}, is refused: {}", fault.message));
    assert_eq!(again, expr, "{latex}, printed {printed}");
    text::formula(&expr, symbols)
}

fn read(latex: &str) -> String {
    read_with(latex, &mut particles())
}

/// The text that a refusal points at.
fn refused_with(latex: &str, symbols: &mut Symbols) -> String {
    match read_formula(latex, symbols, &Macros::default()) {
        Ok(expr) => panic!("{latex} is read as {}", text::formula(&expr, symbols)),
        Err(fault) => {
            assert!(!fault.message.is_empty());
            latex[fault.span.range()].to_owned()
        }
    }
}

fn refused(latex: &str) -> String {
    refused_with(latex, &mut particles())
}
