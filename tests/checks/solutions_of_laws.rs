//! Solutions that a document prints for the motion that laws give: `m \ddot x = -k x` and `x = A \cos\omega t`.

use onshell::check::Verdict::{self, Certified, Definition, Law, Refuted, Undecided, Verified};
use onshell::check::{Document, Repair};
use onshell::systems::Registry;
use serde_json::json;

use crate::support::{document, numbered, outcome};

/// The check of displays, the first `laws` of which are laws for x, y and N.
fn check(laws: usize, displays: &[&str]) -> Document {
    let laws: serde_json::Map<_, _> = (1..=laws).map(|at| (format!("the law {at}"), json!(at.to_string()))).collect();
    let claims = json!({
        "constants": { "m, k, \\kappa, \\lambda, b, L, R, C": "> 0", "A, B, v, N_0, q_0": "any" },
        "varies with time": { "x, y, q": "any", "N": "> 0" },
        "laws": laws,
    });
    document(&claims, &numbered(displays), &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"))
}

fn last(laws: usize, displays: &[&str]) -> Verdict {
    check(laws, displays).equations.last().map(|equation| outcome(&equation.finding)).unwrap_or(Undecided)
}

const SPRING: &str = r"m \ddot x = -k x";

#[test]
fn solutions_pass_and_near_misses_are_refuted() {
    for (law, right, wrong) in [
        (r"\dot N = -\lambda N", r"N(t) = N_0 e^{-\lambda t}", r"N(t) = N_0 e^{\lambda t}"),
        (r"\dot N = -\lambda N", r"N(t) = N_0 e^{-\lambda t}", r"N(t) = N_0 e^{-2\lambda t}"),
        (SPRING, r"x = A \cos(\sqrt{k/m} \, t)", r"x = A \cos(\sqrt{m/k} \, t)"),
        (
            SPRING,
            r"x = A \sin(\sqrt{\frac{k}{m}} t) + B \cos(\sqrt{\frac{k}{m}} t)",
            r"x = A \sinh(\sqrt{\frac{k}{m}} t)",
        ),
        (r"\ddot x = -b", r"x = A + v t - \frac12 b t^2", r"x = A + v t - b t^2"),
        (r"\ddot x = 0", r"x = A + v t", r"x = A + v t^2"),
    ] {
        assert!(matches!(last(1, &[law, right]), Certified | Verified), "{law}: {right}");
        assert_eq!(last(1, &[law, wrong]), Refuted, "{law}: {wrong}");
    }
}

#[test]
fn solutions_of_coupled_laws_are_tested_together() {
    let laws = [r"m \ddot x = -k x + \kappa (y - x)", r"m \ddot y = -k y - \kappa (y - x)"];
    let of = |solution: &str| last(2, &[laws[0], laws[1], solution]);
    let even = r"x = A \cos(\sqrt{\frac{k}{m}} t), \quad y = A \cos(\sqrt{\frac{k}{m}} t)";
    let odd = r"x = A \cos(\sqrt{\frac{k + 2\kappa}{m}} t), \quad y = -A \cos(\sqrt{\frac{k + 2\kappa}{m}} t)";
    assert!(of(even).passes());
    assert!(of(odd).passes());
    assert_eq!(of(&odd.replace("-A", "A")), Refuted);
    assert_eq!(of(&odd.replace("2\\kappa", "\\kappa")), Refuted);
}

#[test]
fn equations_hold_along_a_printed_solution_if_it_solves_the_laws() {
    let solution = r"x = A \cos\omega t + B \sin\omega t, \quad \omega = \sqrt{\frac{k}{m}}";
    let energy = r"E = \frac12 m \dot x^2 + \frac12 k x^2 = \frac12 k (A^2 + B^2)";
    assert!(last(1, &[SPRING, solution, energy]).passes());
    assert_eq!(last(1, &[SPRING, solution, &energy.replace("(A^2 + B^2)", "(A^2 - B^2)")]), Refuted);
    // Along a wrong solution nothing is decided.
    assert_eq!(last(1, &[SPRING, &solution.replace("{k}{m}", "{m}{k}"), energy]), Undecided);
}

#[test]
fn constants_of_the_laws_are_no_constants_of_integration() {
    let found = check(1, &[SPRING, r"x = A \cos(\sqrt{\frac{k}{m}} t)"]);
    let message = &found.equations[1].finding.message;
    assert!(message.contains("constants of integration: A") && !message.contains(", k"), "{message}");
}

/// The first correction of the last display, as the text that it puts in.
fn first_correction(laws: usize, displays: &[&str]) -> Option<String> {
    let found = check(laws, displays);
    let repair: &Repair = found.equations.last()?.repairs.first()?;
    Some(repair.replacement.trim().to_owned())
}

#[test]
fn a_slip_in_a_definition_beside_the_solution_is_corrected_there() {
    let solution = r"x = A \cos\omega t, \quad \omega = \sqrt{\frac{m}{k}}";
    assert_eq!(first_correction(1, &[SPRING, solution]).as_deref(), Some(r"\frac{k}{m}"));
    // Another display that nothing uses is no reason to withhold it.
    let loop_law = r"L \ddot q + R \dot q + \frac{q}{C} = 0";
    let damped = r"q = q_0 e^{-\gamma t} \cos\omega t, \quad \gamma = \frac{R}{L}, \quad \omega = \sqrt{\frac{1}{LC} - \gamma^2}";
    let found = check(1, &[loop_law, r"T = \frac{\ln 2}{k}", damped]);
    let repairs = &found.equations[2].repairs;
    assert!(repairs.iter().any(|repair| repair.replacement.trim() == r"2 \,"), "{repairs:?}");
    let right = damped.replace(r"\frac{R}{L}", r"\frac{R}{2L}");
    assert!(last(1, &[loop_law, &right]).passes());
}

#[test]
fn a_slip_in_an_exponent_with_greek_letters_is_corrected_in_it() {
    let law = r"\dot N = -\lambda N";
    assert_eq!(first_correction(1, &[law, r"N(t) = N_0 e^{-2\lambda t}"]).as_deref(), Some(""));
    assert_eq!(first_correction(1, &[law, r"N(t) = N_0 e^{\lambda t}"]).as_deref(), Some("-"));
}

#[test]
fn the_law_stays_a_law_beside_a_solution() {
    let found = check(1, &[SPRING, r"x = A \cos\omega t, \quad \omega = \sqrt{\frac{k}{m}}"]);
    assert_eq!(found.equations[0].finding.verdict, Law);
    let parts: Vec<Verdict> = found.equations[1].parts.iter().map(|part| part.finding.verdict).collect();
    assert!(parts[0].holds() && parts[1] == Definition, "{parts:?}");
}
