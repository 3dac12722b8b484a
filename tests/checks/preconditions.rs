//! What must hold before a claim can be tested at all. Where it does not, nothing is decided: a true statement is not refuted,
//! and a false one does not pass.

use onshell::check::Verdict;
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, outcome, seeded, verdict};

/// Coordinates x and y, and a Lagrangian in the notes.
fn plane() -> Json {
    json!({
        "coordinates": { "x, y": "any" },
        "constants": { r"m, k, a, \Omega, \omega": "> 0" },
        "means": { "L": "Lagrangian" },
    })
}

#[test]
fn forces_that_are_linear_in_the_velocities_count_in_the_secular_equation() {
    let turning = r"L = \frac12 m(\dot x^2 + \dot y^2) + m\Omega(x\dot y - y\dot x) - \frac12 k(x^2 + y^2)";
    let claim = || json!({ "secular equation for": r"\omega" });
    let (right, without) = (r"(k - m\omega^2)^2 = 4 m^2\Omega^2\omega^2", r"(k - m\omega^2)^2 = 0");
    assert_eq!(verdict(&plane(), &[turning, right], claim()), Verdict::Verified);
    for wrong in [without, r"(k - m\omega^2)^2 = 2 m^2\Omega^2\omega^2", r"(k - m\omega^2)^2 = -4 m^2\Omega^2\omega^2"]
    {
        assert_eq!(verdict(&plane(), &[turning, wrong], claim()), Verdict::Refuted, "{wrong}");
    }
    // The same terms as a total derivative turn nothing.
    let still = r"L = \frac12 m(\dot x^2 + \dot y^2) + m\Omega(x\dot y + y\dot x) - \frac12 k(x^2 + y^2)";
    assert_eq!(verdict(&plane(), &[still, r"(k - m\omega^2)^2 = 0"], claim()), Verdict::Verified);
    assert_eq!(verdict(&plane(), &[still, r"(k - m\omega^2)^2 = m^2\Omega^4"], claim()), Verdict::Refuted);
}

#[test]
fn the_coordinates_of_normal_frequencies_are_measured_from_the_place_of_rest() {
    let claim = || json!({ "secular equation for": r"\omega" });
    let shifted = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac14 k(x - a)^4 - \frac12 k y^2";
    let printed = r"(3 k a^2 - m\omega^2)(k - m\omega^2) = 0";
    assert_eq!(verdict(&plane(), &[shifted, printed], claim()), Verdict::Undecided);
    let at_rest = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k x^2 - k x^4 - \frac12 k y^2";
    assert_eq!(verdict(&plane(), &[at_rest, r"(k - m\omega^2)^2 = 0"], claim()), Verdict::Verified);
}

#[test]
fn other_combinations_of_the_equations_of_motion_are_not_called_another_motion() {
    let spring = r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k(x^2 + y^2)";
    let claim = || json!({ "same motion as": "L" });
    assert_eq!(verdict(&plane(), &[spring, r"F = m\dot x\dot y - k x y"], claim()), Verdict::Undecided);
    assert_eq!(verdict(&plane(), &[spring, r"F = m\dot x\dot y + k x y"], claim()), Verdict::Refuted);
}

#[test]
fn a_formula_that_stands_for_a_name_has_no_known_derivative() {
    let claims = json!({
        "constants": { "a": "> 0" },
        "formulas as names": { r"\langle E(a) \rangle": "constant" },
    });
    for printed in [
        r"\frac{d}{da} \langle E(a) \rangle = 0",
        r"\frac{d}{da} \left(a \langle E(a) \rangle\right) = \langle E(a) \rangle",
        r"\frac{\partial}{\partial a} \left(a \langle E(a) \rangle\right) = \langle E(a) \rangle",
    ] {
        assert_eq!(verdict(&claims, &[printed], json!({})), Verdict::Unreadable, "{printed}");
    }
    let linear = r"2 \langle E(a) \rangle + a = a + \langle E(a) \rangle + \langle E(a) \rangle";
    assert_eq!(verdict(&claims, &[linear], json!({})), Verdict::Verified);
}

#[test]
fn a_lagrangian_that_depends_on_the_time_has_no_normal_frequency() {
    let claims = |dimension: &str| {
        json!({
            "coordinates": { dimension: "any" },
            "constants": { r"m, k, \gamma": "> 0" },
            "means": { "L": "Lagrangian", r"\omega": "normal frequency" },
        })
    };
    let damped = r"L = e^{\gamma t}\left(\frac12 m\dot x^2 - \frac12 k x^2\right)";
    let found = document(&claims("x"), &numbered(&[damped, r"\omega^2 = \frac{k}{m}"]), &Registry::standard(), None);
    assert!(found.is_err_and(|error| error.to_string().contains("depends on the time")));
    let spring = r"L = \frac12 m\dot x^2 - \frac12 k x^2";
    assert_eq!(verdict(&claims("x"), &[spring, r"\omega^2 = \frac{k}{m}"], json!({})), Verdict::Verified);
}

/// m_2 > 0, but m_2 = 0 with any v_2 obeys both laws. That is no state of the notes.
#[test]
fn a_number_that_must_not_be_0_is_not_moved_to_0() {
    let claims = json!({
        "constants": { "m_1, m_2, u, v_2": "> 0", "v_1": "any" },
        "laws": { "momentum": "1", "energy": "2" },
    });
    let displays = [
        "m_1 u = m_1 v_1 + m_2 v_2",
        r"\frac12 m_1 u^2 = \frac12 m_1 v_1^2 + \frac12 m_2 v_2^2",
        "u + v_1 = v_2",
        r"v_2 = u + v_1 = \frac{2 m_1}{m_1 + m_2} u",
        "u - v_1 = v_2",
        r"v_2 = \frac{m_1}{m_1 + m_2} u",
    ];
    for seed in 1..=8 {
        let found = seeded(seed, &claims, &numbered(&displays), &Registry::standard(), None).expect("a report");
        let verdicts: Vec<Verdict> = found.equations[2..].iter().map(|item| outcome(&item.finding)).collect();
        let expected = [Verdict::Verified, Verdict::Verified, Verdict::Refuted, Verdict::Refuted];
        assert_eq!(
            verdicts,
            expected,
            "seed {seed}: {:?}",
            found.equations.iter().map(|e| &e.finding.message).collect::<Vec<_>>()
        );
    }
}

#[test]
fn numbers_with_units_at_the_edge_of_what_can_be_read() {
    let claims = json!({ "constants": { "t, x, g, M": "> 0" } });
    let nested = (0..11).fold(r"\text{m}".to_owned(), |unit, _| format!("{{{unit}}}^{{8}}"));
    for (printed, expected) in [
        // An exponent that no whole number of the machine holds.
        (format!(r"x = 2.0\,{nested} = 2.0\,\text{{m}}\cdot 1.0\,\text{{m}}^{{-1}}"), Verdict::Unreadable),
        (r"g = 9.81(2)\,\text{m/s}^2 = 9.81\,\text{m/s}^2".to_owned(), Verdict::Unreadable),
        (r"x = 1.0\times 10^{-200}\,\text{m} = 3.0\times 10^{200}\,\text{m}".to_owned(), Verdict::Refuted),
        (r"M = 500\,\text{kg}\times 3 \approx 10^3\,\text{kg}".to_owned(), Verdict::Verified),
        (r"M = 500\,\text{kg}\times 3 \approx 10^5\,\text{kg}".to_owned(), Verdict::Undecided),
        (r"M = 500\,\text{kg}\times 3 \approx 10^3\,\text{s}".to_owned(), Verdict::Refuted),
        // Where constants of nature are 1, these are equal.
        (r"t = 0.0\,\text{s}\times 3 = 0.0\,\text{m}".to_owned(), Verdict::Undecided),
        (r"t = 0.0\,\text{s}\times 3 = 0".to_owned(), Verdict::Verified),
    ] {
        assert_eq!(verdict(&claims, &[printed.as_str()], json!({})), expected, "{printed}");
    }
}

#[test]
fn a_formula_that_stands_for_a_name_is_no_constant_in_a_sum_or_an_integral_over_what_it_contains() {
    let claims = json!({
        "constants": { "a, n, x, y": "> 0" },
        "indices": { "i": "1..3" },
        "formulas as names": { r"\psi(x)": "constant", r"\Phi(r_i)": "constant", "n!": "constant" },
    });
    for (printed, expected) in [
        (r"\int_0^a \psi(x) \, dx = a \psi(x)", Verdict::Unreadable),
        (r"\sum_{i=1}^{3} \Phi(r_i) = 3 \Phi(r_i)", Verdict::Unreadable),
        (r"\sum_{n=0}^{2} n! = 3 \, n!", Verdict::Unreadable),
        (r"\left. \psi(x) \right|_{x=a} = \psi(x)", Verdict::Unreadable),
        // What it does not contain says nothing of it.
        (r"\int_0^a \psi(x) \, dy = a \psi(x)", Verdict::Verified),
        (r"\int_0^a \psi(x) \, dy = \psi(x)", Verdict::Refuted),
        (r"\sum_{n=1}^{3} n \psi(x) = 6 \psi(x)", Verdict::Verified),
    ] {
        assert_eq!(verdict(&claims, &[printed], json!({})), expected, "{printed}");
    }
}

#[test]
fn what_rests_on_a_false_solution_is_not_certified() {
    let claims = json!({
        "varies with time": { "v, x": "any" },
        "constants": { "m, c, u": "> 0" },
        "laws": { "Newton": "1", "velocity": "2" },
    });
    let laws = [r"m \dot v = -c v", r"\dot x = v"];
    let last = |speed, way| verdict(&claims, &[laws[0], laws[1], speed, way], json!({}));
    let (grows, falls) = (r"v(t) = u e^{c t/m}", r"v(t) = u e^{-c t/m}");
    let way_of_growth = r"x(t) = \frac{m u}{c}\left(e^{c t/m} - 1\right)";
    assert_eq!(last(grows, way_of_growth), Verdict::Undecided);
    assert_eq!(last(falls, way_of_growth), Verdict::Refuted);
    assert_eq!(last(falls, r"x(t) = \frac{m u}{c}\left(1 - e^{-c t/m}\right)"), Verdict::Verified);
}

#[test]
fn a_macro_does_not_hide_that_a_claim_restates_its_hypothesis() {
    let claims = json!({
        "macros": { r"\ke": r"\frac12 m v^2" },
        "coordinates": { "r": "> 0" },
        "constants": { "m": "> 0", "v, T": "any" },
        "functions": { "V": "of r" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = \frac12 m\dot r^2 - V(r)";
    let assumed = |latex: &str| verdict(&claims, &[lagrangian, r"T = \ke"], json!({ "assume": latex }));
    assert_eq!(assumed(r"T = \frac{m v^2}{2}"), Verdict::Undecided);
    assert_eq!(assumed(r"T = m v^2"), Verdict::Refuted);
}

/// (m + M)(V²/2 − g h) = 0 is solved by M = −m, which the declared ranges exclude. That is no reason to find no state.
#[test]
fn a_common_factor_of_a_hypothesis_is_no_solution_where_it_cannot_vanish() {
    let claims = json!({ "constants": { "m, M, V, v, g, h": "> 0" } });
    let law = r"\frac12 (m + M) V^2 = (m + M) g h";
    let claim = || json!({ "assume": [law, "m v = (m + M) V"] });
    let speed = |under: &str| verdict(&claims, &[&format!(r"v = \frac{{m + M}}{{m}}\sqrt{{{under}}}")], claim());
    assert_eq!(speed("2 g h"), Verdict::Verified);
    assert_eq!(speed("g h"), Verdict::Refuted);
}

/// All numbers of the second hypothesis are those for which the first one was solved.
#[test]
fn hypotheses_are_met_in_any_order() {
    let claims = json!({ "constants": { "a, k, \\lambda": "> 0", "\\theta": "(0, \\pi/2)" } });
    let (law, value) = (r"a \sin\theta = k \lambda", "k = 1");
    for order in [[law, value], [value, law]] {
        let found = |right: &str| verdict(&claims, &[&format!(r"\sin\theta = {right}")], json!({ "assume": order }));
        assert_eq!(found(r"\frac{\lambda}{a}"), Verdict::Verified, "{order:?}");
        assert_eq!(found(r"\frac{2\lambda}{a}"), Verdict::Refuted, "{order:?}");
    }
}
