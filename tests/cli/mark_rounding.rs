//! `onshell mark`, where numbers are rounded on the way, and where units are written in another way. Beside each right number stands one
//! that is wrong.

use crate::mark_problems::{CHAIN, CLIFF, CYLINDER};
use crate::support::marks;

#[test]
fn after_a_rounded_number_the_exact_result_is_right_too() {
    let of = |name: &str, distance: &str| {
        marks(name, CLIFF, &format!("$$ t_1 = 4.22\\,\\text{{s}} $$\n\n$$ D = {distance}\\,\\text{{m}} $$\n"))
    };
    assert_eq!(of("exact", "73.0"), ["right", "right"]);
    assert_eq!(of("rounded", "73.1"), ["right", "right"]);
    assert_eq!(of("product", "v_0\\cos\\alpha\\,t_1 = 73.0"), ["right", "right"]);
    // The twin: neither of them.
    assert_eq!(of("wrong", "73.4"), ["right", "wrong"]);
    assert_eq!(of("product-wrong", "v_0\\cos\\alpha\\,t_1 = 72.0"), ["right", "wrong"]);
}

#[test]
fn a_sum_of_rounded_values_is_right_to_the_digits_of_the_number() {
    let of = |name: &str, time: &str| {
        let lines = format!(
            "$$ t_u = \\frac{{v_0\\sin\\alpha}}{{g}} = 1.02\\,\\text{{s}} $$\n\n$$ t_d = 3.20\\,\\text{{s}} $$\n\n\
             $$ t_1 = t_u + t_d = {time}\\,\\text{{s}} $$\n"
        );
        marks(name, CLIFF, &lines)[2].clone()
    };
    assert_eq!(of("sum", "4.22"), "right");
    assert_ne!(of("sum-wrong", "4.32"), "right");
    let named = |name: &str, time: &str| {
        let lines = format!(
            "$$ t_u = \\frac{{v_0\\sin\\alpha}}{{g}}, \\quad t_d = \\sqrt{{2H/g}} $$\n\n\
             $$ t_1 = t_u + t_d = {time}\\,\\text{{s}} $$\n"
        );
        marks(name, CLIFF, &lines).pop().unwrap()
    };
    assert_eq!(named("named", "4.22"), "right");
    assert_ne!(named("named-wrong", "4.32"), "right");
}

#[test]
fn hours_and_units_without_braces_are_units() {
    let of = |name: &str, value: &str| marks(name, CLIFF, &format!("$$ v_1 = {value} $$\n"));
    assert_eq!(of("hours", "129\\,\\text{km/h}"), ["right"]);
    assert_eq!(of("both", "35.8\\,\\frac{\\text{m}}{\\text{s}} = 129\\,\\frac{\\text{km}}{\\text{h}}"), ["right"]);
    assert_eq!(
        of("short", "35.8\\,\\frac{\\mathrm m}{\\mathrm s} = 35.8\\,\\frac{\\mathrm{m}}{\\mathrm{s}}"),
        ["right"]
    );
    assert_eq!(of("hours-wrong", "192\\,\\text{km/h}"), ["wrong"]);
    assert_eq!(
        of("both-wrong", "35.8\\,\\frac{\\text{m}}{\\text{s}} = 139\\,\\frac{\\text{km}}{\\text{h}}"),
        ["wrong"]
    );
}

#[test]
fn letters_after_a_number_are_units_where_that_is_right() {
    assert_eq!(marks("time", CLIFF, "$$ t_1 = 4.22\\,s $$\n"), ["right"]);
    assert_eq!(marks("mass", CYLINDER, "$$ a = 3.27\\,m/s^2 $$\n"), ["right"]);
    // The twins: wrong as units and as quantities; quantities.
    assert_eq!(marks("mass-wrong", CYLINDER, "$$ a = 3.72\\,m/s^2 $$\n"), ["wrong"]);
    assert_eq!(marks("quantity", CYLINDER, "$$ a = 3.27\\,s $$\n"), ["wrong"]);
}

#[test]
fn a_decimal_before_letters_is_rounded() {
    let of = |name: &str, factor: &str| marks(name, CHAIN, &format!("$$ \\omega_1^2 = {factor}\\,\\frac km $$\n"));
    assert_eq!(of("factor", "0.382"), ["right"]);
    assert_eq!(of("factor-wrong", "0.328"), ["wrong"]);
    let chain = |factor: &str| {
        format!(
            "$$ \\omega_1 = \\sqrt{{\\frac{{3-\\sqrt5}}{{2}}}}\\sqrt{{\\frac km}} = {factor}\\sqrt{{\\frac km}} $$\n"
        )
    };
    assert_eq!(marks("chain", CHAIN, &chain("0.618")), ["right"]);
    assert_eq!(marks("chain-wrong", CHAIN, &chain("0.681")), ["wrong"]);
}
