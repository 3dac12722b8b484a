//! Units after numbers, and what is none.

use onshell::latex::read_display;

use super::*;

/// A display in plain words; the message of a fault.
fn read(latex: &str) -> String {
    read_with(latex, &mut Symbols::open())
}

fn read_with(latex: &str, symbols: &mut Symbols) -> String {
    let reading = read_display(latex, symbols, &Macros::default());
    let found = reading.statements.iter().map(|read| match read {
        Ok(read) => text::statement(read, symbols),
        Err(fault) => format!("! {}", fault.message),
    });
    found.collect::<Vec<_>>().join(" | ")
}

#[test]
fn upright_words_after_numbers_are_units() {
    for (latex, words) in [
        (r"9.8\,\text{m/s}^2", "9.8·m/s^2"),
        (r"9.8\,\mathrm{m\,s^{-2}}", "9.8·m/s^2"),
        (r"9.8\ \frac{\text{m}}{\text{s}^2}", "9.8·m/s^2"),
        (r"9.8\,\rm m\,s^{-2}", "9.8·m/s^2"),
        (r"\SI{9.8}{\metre\per\second\squared}", "9.8·m/s^2"),
        (r"\qty{9.8}{m.s^{-2}}", "9.8·m/s^2"),
        (r"3.16\times10^7\,\mathrm s", "3.16·10^7·s"),
        (r"\frac{0.10\ \text{kg}}{0.050\ \text{kg/s}}", "(0.10·kg)/(0.050·kg/s)"),
        (r"(3 + 2)\ \text{m}", "(3 + 2)·m"),
        (r"10\ \text{m}/2.0\ \text{s}", "(10·m)/(2.0·s)"),
        (r"\frac{5}{\text{s}}", "5/s"),
        (r"5\ \text{J/(kg K)}", "5·J/(kg·K)"),
        (r"5\ \text{J}/(\text{kg}\cdot\text{K})", "5·J/(kg·K)"),
        (r"20\,\text{k}\Omega", "20·kΩ"),
        (r"5\,\mu\mathrm{F}", "5·µF"),
        (r"5\,\text{µF}", "5·µF"),
        (r"12\ \text{V} - 3\ \text{A} \cdot 2\ \Omega", "12·V − 3·A·2·Ω"),
        (r"300~\mathrm{K}", "300·K"),
        (r"\sin 30^\circ", "sin(30°)"),
        (r"25\%", "25%"),
        (r"7\text{ days}", "7·day"),
        (r"938\,\text{MeV}/c^2", "(938·MeV)/c^2"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
}

#[test]
fn what_is_no_unit_stays_what_it_is() {
    for (latex, words) in [
        (r"T_{\mathrm{m}}", "T_m"),
        (r"2\,\mathrm{d}x", "2·dx"),
        (r"3\mathrm{K}", "! "),
        (r"\omega = 2\Omega", "ω = 2·Ω"),
        (r"x = 3 \text{ for } y > 0", "x = 3 for y > 0"),
        (r"3\,\text{apples}", "3 | ! "),
        (r"x\,\text{m}", "! "),
    ] {
        let found = read(latex);
        assert!(found == words || words.ends_with("! ") && found.contains('!'), "{latex}: {found}");
    }
    // Must-fail cases: what people read in two ways.
    for (latex, word) in [
        (r"5\ \text{J/kg K}", "divide by the next unit only"),
        (r"9.8\,\text{ms}^{-2}", "a metre per second"),
        (r"t = 5\,\mathrm{min}\,30\,\mathrm{s}", "a sum or a product"),
        (r"1/2\ \text{m}", r"may be 1/(2\,\text{m}) or (1/2)\,\text{m}"),
        (r"\omega = 2\,\Omega", "the unit ohm or a quantity"),
        (r"25^\circ\mathrm{C}", "its zero is not that of the kelvin"),
        (r"\SI{25}{\celsius}", "not supported"),
    ] {
        let found = read(latex);
        assert!(found.contains(word), "{latex}: {found}");
    }
}

#[test]
fn a_declared_name_is_no_unit() {
    let mut symbols = Symbols::new();
    add(&mut symbols, r"\mathrm{m}", Kind::Scalar);
    assert_eq!(read_with(r"2\,\mathrm{m}", &mut symbols.clone()), "2·m");
    let reading = read_display(r"2\,\mathrm{m}", &mut symbols, &Macros::default());
    let read = reading.statements[0].as_ref().expect("it is read");
    assert_eq!(read.members[0].symbols().len(), 1, "m is the symbol");
    add(&mut symbols, r"\Omega", Kind::Scalar);
    assert_eq!(read_with(r"2\,\text{k}\Omega", &mut symbols), "2·kΩ");
    let reading = read_display(r"2\,\mathrm{s}", &mut symbols, &Macros::default());
    assert!(reading.statements[0].as_ref().expect("it is read").members[0].symbols().is_empty());
}

#[test]
fn a_macro_that_hides_the_spaces_of_a_unit_is_asked_for_them() {
    let mut macros = Macros::default();
    macros.define("\\rate", 0, "\\,\\text{m s}");
    macros.define("\\speed", 0, "\\,\\text{km/h}");
    macros.define("\\of", 1, "\\,\\mathrm{#1}");
    let read = |latex: &str| {
        let mut symbols = Symbols::open();
        let reading = read_display(latex, &mut symbols, &macros);
        match &reading.statements[0] {
            Ok(read) => text::statement(read, &symbols),
            Err(fault) => fault.message.clone(),
        }
    };
    assert!(read(r"3\rate").contains("ms comes from a macro"), "{}", read(r"3\rate"));
    assert_eq!(read(r"3\speed"), "3·km/h");
    assert_eq!(read(r"3\of{m s^{-1}}"), "3·m/s");
}

#[test]
fn one_upright_letter_that_touches_a_power_of_ten_is_a_unit() {
    assert_eq!(read(r"3\times10^{8}\mathrm{m}"), "3·10^8·m");
    assert_eq!(read(r"1.38\times10^{-23}\mathrm{J/K}"), "1.38·10^(−23)·J/K");
    assert!(read(r"2\mathrm{K}").starts_with("! "), "{}", read(r"2\mathrm{K}"));
}

#[test]
fn beside_numbers_e_is_eulers_number() {
    for (latex, words) in [
        (r"x = 1 - e^{-2} \approx 0.86", "x = 1 − e^(−2) ≈ 0.86"),
        (r"p = e^{-8/5} \approx 0.2019", "p = e^(−8/5) ≈ 0.2019"),
        (r"p = e^{-2.5} = 0.082", "p = e^(−2.5) = 0.082"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
    for latex in [r"x = e^2 + 1", r"x = e^{1/2}", r"h = \ln(2\pi e)", r"a = (-j)^n"] {
        assert!(read(latex).starts_with("! "), "{latex}: {}", read(latex));
    }
}

#[test]
fn decimals_that_go_on_are_no_factor() {
    assert_eq!(super::statements_of(r"x = 3.14\ldots").as_deref(), Some("x = 3.14…"));
    assert!(read(r"x = 3.14\ldots").starts_with("! "));
}
