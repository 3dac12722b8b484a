//! `onshell mark`, where a line puts numbers in: with units, with g unsaid, in degrees and in electronvolts. Beside each right number
//! stands one that must not be right.

use crate::support::marks;

/// A bead on a hoop that turns, with the frequency about its place of rest beside the axis.
const HOOP: (&str, &str) = (
    "$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{1} $$\n\n\
     $$ \\cos\\theta_0 = \\frac{g}{R \\omega^2} \\tag{2} $$\n\n\
     $$ \\Omega = \\sqrt{\\omega^2 - \\frac{g^2}{R^2 \\omega^2}} \\tag{3} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" },
        "constants": { "m, R, g, \\omega": "> 0", "\\theta_0": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian", "\\Omega": "frequency of small oscillations about \\theta = \\theta_0" },
        "equations": { "2": { "equilibrium": true, "at": { "\\theta": "\\theta_0" } } },
        "rubric": { "results": { "2": 1, "3": 1 } } }"#,
);

/// A particle with a kinetic energy.
const PARTICLE: (&str, &str) = (
    "$$ E = K + m c^2 \\tag{1} $$\n\n$$ p = \\frac1c \\sqrt{E^2 - m^2 c^4} \\tag{2} $$\n",
    r#"{ "notes": "p.md", "constants": { "m, c, K": "> 0" }, "rubric": { "results": { "2": 1 } } }"#,
);

const DATA: &str = "With $R = 10\\,\\text{cm}$ and $\\omega = 12\\,\\text{s}^{-1}$:\n\n";

#[test]
fn standard_gravity_is_meant_where_only_g_has_no_value() {
    let of = |name: &str, line: &str| marks(name, HOOP, &format!("{DATA}$$ {line} $$\n"))[2..].join(" ");
    assert_eq!(of("g", "\\cos\\theta_0 = 0.68, \\qquad \\Omega = 8.8\\,\\text{s}^{-1}"), "right right");
    // With 10 m/s² it is 0.69.
    assert_eq!(of("ten", "\\cos\\theta_0 = 0{,}69"), "right");
    assert_eq!(of("squared", "\\Omega^2 = 77\\,\\text{s}^{-2}"), "right");
    assert_eq!(of("wrong", "\\cos\\theta_0 = 0.71, \\qquad \\Omega = 9.8\\,\\text{s}^{-1}"), "wrong wrong");
}

#[test]
fn a_number_for_which_a_value_is_missing_is_not_wrong() {
    let of = |name: &str, data: &str| {
        marks(name, HOOP, &format!("With {data}:\n\n$$ \\Omega = 9.8\\,\\text{{s}}^{{-1}} $$\n")).pop().unwrap()
    };
    assert_eq!(of("missing", "$R = 10\\,\\text{cm}$"), "undecided");
    // The twin: nothing is missing.
    assert_eq!(of("given", "$R = 10\\,\\text{cm}$ and $\\omega = 12\\,\\text{s}^{-1}$"), "wrong");
}

#[test]
fn electronvolts_have_prefixes_and_are_numbers_of_joules() {
    let of = |name: &str, value: &str| {
        let lines = format!(
            "With $c = 1$, $m = 938\\,\\text{{MeV}}$ and $K = 6{{,}}00\\,\\text{{GeV}}$:\n\n$$ p = {value} $$\n"
        );
        marks(name, PARTICLE, &lines).pop().unwrap()
    };
    assert_eq!(of("gev", "6{,}87\\,\\text{GeV}"), "right");
    assert_eq!(of("mev", "6874\\,\\text{MeV}"), "right");
    // The twins: another number, and another prefix.
    assert_eq!(of("gev-wrong", "6{,}78\\,\\text{GeV}"), "wrong");
    assert_eq!(of("mev-wrong", "6{,}87\\,\\text{MeV}"), "wrong");
}

#[test]
fn a_micro_before_a_unit_is_its_prefix() {
    let problem = (
        "$$ R \\dot q = -\\frac{q}{C} \\tag{1} $$\n\n$$ t_h = R C \\ln 2 \\tag{2} $$\n",
        r#"{ "notes": "p.md", "varies with time": { "q": "> 0" }, "constants": { "R, C": "> 0" }, "laws": { "Kirchhoff": "1" } }"#,
    );
    let of = |name: &str, time: &str| {
        let data = "With $R = 2{,}0\\,\\text{k}\\Omega$ and $C = 100\\,\\mu\\mathrm{F}$:\n\n";
        marks(name, problem, &format!("{data}$$ t_h = {time}\\,\\text{{s}} $$\n"))
    };
    assert_eq!(of("micro", "0{,}14"), ["given", "given", "right"]);
    assert_eq!(of("micro-wrong", "0{,}17").last().unwrap(), "wrong");
}

/// A mass on a spring that is stretched, with the frequency in the claims file alone.
const STRETCHED: (&str, &str) = (
    "Find $C$ for $l = 1.00\\,\\text{m}$, $a = 2.0\\,\\text{cm}$, $\\Omega = 2.0\\,\\text{s}^{-1}$, $g = 9.81\\,\\text{m/s}^2$.\n\n\
     $$ B = \\frac{a \\Omega^2}{l (\\omega_0^2 - \\Omega^2)} \\tag{1} $$\n\n$$ C = a + l B \\tag{2} $$\n\n\
     $$ s = 1000 C \\tag{3} $$\n",
    r#"{ "notes": "p.md", "constants": { "l, a, g, \\Omega": "> 0", "\\omega_0": "\\sqrt{g/l}" },
        "rubric": { "results": { "2": 1 } } }"#,
);

#[test]
fn numbers_of_the_text_go_through_formulas_of_the_claims_file() {
    let of = |name: &str, line: &str| marks(name, STRETCHED, &format!("$$ {line} $$\n"));
    assert_eq!(of("through", "C = 3.38\\,\\text{cm}"), ["right"]);
    assert_eq!(of("through-chain", "B = \\frac{a \\Omega^2}{g - l \\Omega^2} = 0.0138 = 0.79^\\circ"), ["right"]);
    assert_eq!(of("through-name", "\\omega_0 = 3.13\\,\\text{s}^{-1}"), ["right"]);
    // The twins: other numbers.
    assert_eq!(of("through-false", "C = 3.28\\,\\text{cm}"), ["wrong"]);
    assert_eq!(of("through-chain-false", "B = \\frac{a \\Omega^2}{g - l \\Omega^2} = 0.0183"), ["wrong"]);
}

#[test]
fn zeros_at_the_end_and_terms_of_a_sum_may_be_rounded() {
    // s is 33.77 m.
    let of = |name: &str, line: &str| marks(name, STRETCHED, &format!("$$ {line} $$\n"));
    assert_eq!(of("zeros", "s = 33770\\,\\text{mm}"), ["right"]);
    assert_eq!(of("zeros-sum", "s = 20\\,\\text{m} + 14\\,\\text{m} = 34\\,\\text{m}"), ["right"]);
    // The twins: another digit before the zeros, and another term.
    assert_eq!(of("zeros-false", "s = 33870\\,\\text{mm}"), ["wrong"]);
    assert_eq!(of("zeros-sum-false", "s = 20\\,\\text{m} + 17\\,\\text{m} = 37\\,\\text{m}"), ["wrong"]);
}

#[test]
fn letters_that_are_guessed_are_no_number() {
    // The data of the problem would make it true by chance, with other letters: 2.0 is 1.00 times 2.0.
    assert_ne!(marks("no-number", STRETCHED, "$$ E = M c^2 $$\n"), ["right"]);
    assert_eq!(marks("a-number", STRETCHED, "$$ \\Omega = 2.0\\,\\text{s}^{-1} $$\n"), ["right"]);
}
