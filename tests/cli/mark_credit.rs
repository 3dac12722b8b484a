//! `onshell mark`: which lines reach a result in names of the student's own, as a law solved for a quantity, or with a slip. Beside each line
//! that does stands one that does not.

use crate::support::{self, Desk, marks};

/// A wall of two layers.
const WALL: (&str, &str) = (
    "For $d_1 = 0.20\\,\\text{m}$, $d_2 = 0.10\\,\\text{m}$, $k_1 = 0.50\\,\\text{W/(m K)}$, $k_2 = 0.040\\,\\text{W/(m\\,K)}$ and \
     $T_i - T_a = 20\\,\\text{K}$.\n\n\
     $$ q = \\frac{k_1}{d_1} (T_i - T_s) \\tag{1} $$\n\n$$ q = \\frac{k_2}{d_2} (T_s - T_a) \\tag{2} $$\n\n\
     $$ q = \\frac{T_i - T_a}{\\frac{d_1}{k_1} + \\frac{d_2}{k_2}} \\tag{3} $$\n\n\
     $$ T_s = \\frac{k_1 d_2 T_i + k_2 d_1 T_a}{k_1 d_2 + k_2 d_1} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "constants": { "d_1, d_2, k_1, k_2": "> 0", "T_i, T_a, T_s, q": "any" },
        "laws": { "layer 1": "1", "layer 2": "2" }, "rubric": { "results": { "3": 1, "4": 2 }, "half for": ["sign"] } }"#,
);

/// A satellite on a circle.
const SATELLITE: (&str, &str) = (
    "$$ \\frac{m v^2}{r} = \\frac{G M m}{r^2} \\tag{1} $$\n\n$$ v = \\sqrt{\\frac{G M}{r}} \\tag{2} $$\n\n\
     $$ E = \\frac12 m v^2 - \\frac{G M m}{r} = -\\frac{G M m}{2 r} \\tag{3} $$\n",
    r#"{ "notes": "p.md", "constants": { "m, M, r, v, G": "> 0" }, "laws": { "circle": "1" },
        "rubric": { "results": { "2": 1, "3": 2 }, "without steps": "full" } }"#,
);

fn points(name: &str, problem: (&str, &str), lines: &str) -> f64 {
    support::points(&format!("mark-credit-{name}"), problem, lines)
}

#[test]
fn a_result_may_be_given_in_names_of_which_other_lines_say_what_they_are() {
    let resistances = "$$ R_1 = \\frac{d_1}{k_1}, \\qquad R_2 = \\frac{d_2}{k_2} $$\n\n";
    let result = "$$ T_s = T_a + \\frac{R_2}{R_1 + R_2} (T_i - T_a) $$\n";
    assert_eq!(points("own", WALL, &format!("{resistances}{result}")), 2.0);
    let reciprocal = "$$ \\frac1U = \\frac{d_1}{k_1} + \\frac{d_2}{k_2} $$\n\n$$ q = U (T_i - T_a) $$\n";
    assert_eq!(points("reciprocal", WALL, reciprocal), 1.0);
    // The twin: no line says what they are.
    assert_eq!(points("unknown", WALL, result), 0.0);
}

#[test]
fn a_law_solved_for_a_quantity_is_a_result_and_the_law_is_none() {
    assert_eq!(points("solved", SATELLITE, "$$ v = \\sqrt{\\frac{G M}{r}} $$\n"), 1.0);
    assert_eq!(points("square", SATELLITE, "$$ v^2 = \\frac{G M}{r} $$\n"), 1.0);
    assert_eq!(points("law", SATELLITE, "$$ \\frac{m v^2}{r} = \\frac{G M m}{r^2} $$\n"), 0.0);
    let energy = "$$ E = -\\frac12 m v^2 $$\n";
    assert_eq!(points("speed", SATELLITE, &format!("$$ v = \\sqrt{{\\frac{{G M}}{{r}}}} $$\n\n{energy}")), 3.0);
    // The twin: no line says what v is.
    assert_eq!(points("no-speed", SATELLITE, energy), 0.0);
}

#[test]
fn a_result_with_a_slip_that_is_not_solved_for_its_quantity_is_not_missing() {
    let missing = |name: &str, line: &str| {
        let desk = Desk::new(&format!("mark-credit-{name}"));
        desk.write("p.md", WALL.0);
        desk.write("p.json", WALL.1);
        desk.write("one.md", line);
        let report = desk.onshell(&["mark", "one.md", "--claims", "p.json", "--format", "json"]).json();
        let rows = report["rows"].as_array().unwrap().iter().filter(|row| row["mark"] == "missing");
        rows.map(|row| row["result"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    let found = missing("slip", "$$ T_s (k_1 d_2 + k_2 d_1) = k_1 d_2 T_i - k_2 d_1 T_a $$\n");
    assert!(!found.iter().any(|result| result.contains('4')), "{found:?}");
    // The twin: a false line about something else.
    let found = missing("other", "$$ q d_1 = k_1 (T_i + T_s) $$\n");
    assert!(found.iter().any(|result| result.contains('4')), "{found:?}");
}

#[test]
fn units_in_parentheses_and_differences_are_data() {
    let of = |name: &str, line: &str| marks(name, WALL, line);
    assert_eq!(of("flux", "$$ q = 6.9\\,\\text{W/m}^2 $$\n"), ["right"]);
    assert_eq!(of("flux-false", "$$ q = 7.9\\,\\text{W/m}^2 $$\n"), ["wrong"]);
    assert_eq!(of("layer", "The first layer has $d_1/k_1 = 0.40\\,\\text{m}^2\\text{K/W}$.\n"), ["right"]);
    assert_eq!(of("layer-false", "The first layer has $d_1/k_1 = 0.50\\,\\text{m}^2\\text{K/W}$.\n"), ["wrong"]);
}

#[test]
fn a_product_below_a_slash_is_read_as_people_mean_it() {
    assert_eq!(marks("product", SATELLITE, "$$ v = \\sqrt{GM/r}, \\qquad v^2 m/GM = m/r $$\n"), ["right", "right"]);
    // The twin: with the last letter above the fraction line it is false.
    assert_eq!(marks("product-false", SATELLITE, "$$ v^2 m/GM = m/r^2 $$\n"), ["wrong"]);
}
