//! Statements of which one holds, and places at which a statement holds: neither is read as "and". Beside each stands what
//! differs little and is read otherwise.

use onshell::latex::read_display;

use super::*;

/// The statements in plain words, or the places of the refusals.
fn displayed(latex: &str, symbols: &mut Symbols) -> Result<Vec<String>, Vec<String>> {
    let reading = read_display(latex, symbols, &Macros::default());
    let faults: Vec<String> = reading
        .statements
        .iter()
        .filter_map(|read| read.as_ref().err())
        .map(|fault| latex[fault.span.range()].to_owned())
        .collect();
    match faults.is_empty() {
        true => Ok(reading.statements.iter().flatten().map(|found| text::statement(found, symbols)).collect()),
        false => Err(faults),
    }
}

fn read(latex: &str) -> Result<Vec<String>, Vec<String>> {
    displayed(latex, &mut Symbols::for_reading())
}

fn openly(latex: &str) -> Result<Vec<String>, Vec<String>> {
    displayed(latex, &mut Symbols::open())
}

fn are_read(cases: &[(&str, &str)]) {
    for (latex, words) in cases {
        assert_eq!(read(latex), Ok(words.split(" ¦ ").map(str::to_owned).collect()), "{latex}");
    }
}

#[test]
fn alternatives_are_one_statement() {
    are_read(&[
        (r"x = 4 \quad \text{or} \quad x = -1", "x = 4 or x = −1"),
        (r"x = 1 \text{ or } 2", "x = 1 or 2"),
        (r"x = 1, 2 \text{ or } 3", "x = 1, 2 or 3"),
        (r"x = 1, \quad x = 2 \quad\text{or}\quad x = 3", "x = 1, x = 2 or x = 3"),
        (r"x^2 = 4 \Rightarrow x = 2 \lor x = -2", "x^2 = 4 ¦ x = 2 ∨ x = −2"),
        (r"\text{either } x = 1 \text{ or } x = 2", "x = 1 or x = 2"),
        // Statements that all hold.
        (r"x = 4 \quad \text{and} \quad y = -1", "x = 4 ¦ y = −1"),
        (r"\sum_i P_i = 1 \text{ and } a = b", "Σ_{i}(P_i) = 1 ¦ a = b"),
    ]);
}

#[test]
fn alternatives_have_no_value() {
    for latex in [r"x = 4 \quad \text{or} \quad x = -1", r"x = 2 \lor x = -2"] {
        assert_eq!(openly(latex), Err(vec![latex.to_owned()]), "{latex}");
    }
    // The first of them stands in the row before.
    assert_eq!(read(r"x = 1 \\ \text{or } x = 2"), Err(vec!["x = 1".to_owned(), r"\text{or } x = 2".to_owned()]));
    assert_eq!(openly(r"x = 1 \\ x = 2"), Ok(vec!["x = 1".to_owned(), "x = 2".to_owned()]));
}

#[test]
fn one_sign_of_two_is_an_alternative_and_a_definition_of_nothing() {
    let pair = |latex: &str| {
        let mut symbols = Symbols::open();
        let reading = read_display(latex, &mut symbols, &Macros::default());
        let found: Vec<_> = reading.statements.into_iter().flatten().collect();
        assert_eq!(found.len(), 2, "{latex}");
        (found[0].is_alternative_to(&found[1]), reading.introduced.len())
    };
    assert_eq!(pair(r"x = 3 \pm 2"), (true, 0));
    assert_eq!(pair(r"x = \frac{4 \pm \sqrt{64}}{4} = \frac{4 \pm 8}{4}"), (true, 0));
    // Each sign has a side of its own.
    assert!(!pair(r"u_\pm = a \pm b").0);
    assert!(!pair(r"(a \pm b)^2 = a^2 \pm 2ab + b^2").0);
    assert!(!pair("x = 1, \\quad y = 2").0);
}

#[test]
fn a_place_is_a_condition() {
    are_read(&[
        (r"u = 1,\ v = 0 \quad \text{at} \quad y = 1", "u = 1 for y = 1 ¦ v = 0 for y = 1"),
        (r"\nabla \cdot \mathbf{u} = 0 \quad \text{ in } \Omega,", "∇·(u) = 0 in Ω"),
        (r"u = a \text{ on } \Gamma", "u = a on Γ"),
        (r"u = a \text{ on } \Gamma, v = b \text{ in } \Omega", "u = a on Γ ¦ v = b in Ω"),
        (r"u = a \text{ on } \Gamma \text{ and } v = b", "u = a on Γ ¦ v = b"),
        (r"T = 0 \text{ at } x = 0, x = L", "T = 0 at x=0,x=L"),
        (r"v = a \text{ for } t > 0, \quad w = b", "v = a for t > 0 ¦ w = b"),
        // A statement of its own.
        (r"u = 1, \quad y = 1", "u = 1 ¦ y = 1"),
    ]);
}

#[test]
fn a_comma_between_bounds_that_exclude_each_other_is_refused() {
    let cases = |condition: &str| {
        openly(&format!(r"V = \begin{{cases}} 1 & {condition} \\ 0 & \text{{otherwise}} \end{{cases}}"))
    };
    assert!(cases("x < 0, x > L").is_err());
    assert!(cases(r"x < 0 \text{ or } x > L").is_err());
    assert!(cases("x > 0, x < L").is_ok());
    assert!(cases("x < 0, y > L").is_ok());
}

#[test]
fn an_arrow_between_equations_is_no_chain() {
    assert_eq!(read(r"E = mc^2 \rightarrow m = a"), Err(vec![r"\rightarrow".to_owned()]));
    are_read(&[(r"E = mc^2 \Rightarrow m = a", "E = m·c^2 ¦ m = a"), (r"f : A \to B", "f : A → B")]);
}

#[test]
fn the_last_value_of_an_index_is_no_statement() {
    are_read(&[
        (r"x_i = a, \quad i = 1, 2, \ldots, n", "x_i = a"),
        (r"x_i = a, \quad i = 1, \ldots, N - 1", "x_i = a"),
        (r"x_i = a, \quad n = b", "x_i = a ¦ n = b"),
    ]);
}

#[test]
fn a_number_before_a_system_is_no_factor() {
    assert_eq!(read(r"(1) \begin{cases} x &= a\\ y &= b \end{cases}"), Err(vec!["(1)".to_owned()]));
    assert_eq!(read(r"\begin{cases} x &= a\\ y &= b \end{cases}"), Ok(vec!["x = a".to_owned(), "y = b".to_owned()]));
}
