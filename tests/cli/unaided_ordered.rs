//! Notes without a claims file in which plain letters are vectors or matrices, and energies that have no formula.

use crate::support;

/// The verdict on each display of a page.
fn verdicts(name: &str, page: &str) -> Vec<String> {
    support::verdicts(&format!("unaided-ordered-{name}"), page)
}

/// The verdict on the last display of a page.
fn last(name: &str, page: &str) -> String {
    verdicts(name, page).pop().expect("a display")
}

#[test]
fn a_cross_beside_a_dot_is_one_of_vectors() {
    let page = |formula: &str| format!("For any vectors $a, b, c$\n\n$$ {formula} $$\n");
    let right = [
        r"a \times (b \times c) = b (a \cdot c) - c (a \cdot b)",
        r"a \cdot (b \times c) = c \cdot (a \times b)",
        r"(a + b) \times c = a \times c + b \times c",
    ];
    for (at, formula) in right.into_iter().enumerate() {
        assert_eq!(last(&format!("right-{at}"), &page(formula)), "certified", "{formula}");
    }
    let wrong = [
        r"a \times (b \times c) = b (a \cdot c) + c (a \cdot b)",
        r"a \cdot (b \times c) = c \cdot (b \times a)",
        r"a \times b = b \times a",
    ];
    for (at, formula) in wrong.into_iter().enumerate() {
        assert_eq!(last(&format!("wrong-{at}"), &page(formula)), "refuted", "{formula}");
    }
}

#[test]
fn the_order_of_a_torque_counts() {
    let page =
        |formula: &str| format!("The torque of a force is\n\n$$ N = r \\times F $$\n\nso\n\n$$ N = {formula} $$\n");
    assert_eq!(last("torque", &page(r"- F \times r")), "certified");
    assert!(!["certified", "verified"].contains(&last("torque-turned", &page(r"F \times r")).as_str()));
}

#[test]
fn a_cross_between_numbers_stays_a_product() {
    let page = "$$ F = m \\times a $$\n\n$$ W = F \\times s $$\n\nso\n\n$$ W = m \\times a \\times s $$\n";
    assert_eq!(last("school", page), "certified");
    assert_ne!(last("school-wrong", &page.replace(r"W = m \times a", r"W = m^2 \times a")), "certified");
}

#[test]
fn matrices_in_plain_letters_do_not_commute() {
    let page = |gain: &str| {
        format!("The plant is\n\n$$ \\dot x = A x + B u $$\n\n$$ u = -K x $$\n\nso\n\n$$ \\dot x = (A - {gain}) x $$\n")
    };
    assert_eq!(last("plant", &page("BK")), "certified");
    assert!(!["certified", "verified", "refuted"].contains(&last("plant-turned", &page("KB")).as_str()));

    let arm = |rate: &str| format!("$$ \\dot x = J \\dot q $$\n\n$$ \\tau = J^T F $$\n\n$$ \\dot q = {rate} $$\n");
    assert_eq!(last("arm", &arm(r"J^{-1} \dot x")), "certified");
    assert!(!["certified", "verified", "refuted"].contains(&last("arm-turned", &arm(r"\dot x J^{-1}")).as_str()));
}

#[test]
fn an_energy_without_a_formula_has_no_derivative() {
    let page = |last: &str| {
        format!(
            "The Lagrangian is\n\n$$ L = T - V $$\n\nand\n\n$$ L = \\frac12 m \\dot x^2 - m g x $$\n\nso\n\n$$ {last} $$\n"
        )
    };
    assert_eq!(last("motion", &page(r"m \ddot x + m g = 0")), "certified");
    assert_eq!(last("motion-wrong", &page(r"m \ddot x - m g = 0")), "refuted");
    let passes = |name: &str, page: &str| ["certified", "verified"].contains(&last(name, page).as_str());
    assert!(!passes("no-force", &page(r"\frac{\partial L}{\partial x} = 0")));
    // Without any formula nothing is decided.
    let open = "$$ L = T - V $$\n\n$$ m \\ddot x = F $$\n\n$$ \\frac{\\partial L}{\\partial \\dot x} = 0 $$\n";
    assert!(!passes("open", open));
    // What a formula does not contain has the derivative 0.
    let cyclic = "The Lagrangian is\n\n$$ L = \\frac12 m (\\dot x^2 + \\dot y^2) - m g x $$\n\nHere\n\n$$ \\frac{d}{dt} \\frac{\\partial L}{\\partial \\dot y} = 0 $$\n";
    assert!(passes("cyclic", cyclic));
}
