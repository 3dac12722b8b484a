//! Notes without a claims file that print an equation of motion and its solution.

use serde_json::Value;

use crate::support::{Desk, verdicts};
use crate::unaided::page;

/// The verdict on the last display of a page, and the text of its first correction.
fn last(name: &str, displays: &[&str]) -> (String, Option<String>) {
    let desk = Desk::new(&format!("unaided-solutions-{name}"));
    desk.write("notes.md", page(displays));
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list").clone();
    let last = equations.last().expect("a display");
    let correction = last["repairs"][0]["replacement"].as_str().map(|text| text.trim().to_owned());
    (last["verdict"].as_str().expect("a verdict").to_owned(), correction)
}

/// An equation of motion, a solution of it, and the solution with a slip and what takes the place of the slip.
const SOLVED: [(&str, &str, &str, &str); 5] = [
    (r"\frac{dN}{dt} = -\lambda N", r"N(t) = N_0 e^{-\lambda t}", r"N(t) = N_0 e^{\lambda t}", "-"),
    (r"R \dot Q + \frac{Q}{C} = 0", r"Q(t) = Q_0 e^{-\frac{t}{RC}}", r"Q(t) = Q_0 e^{-\frac{R t}{C}}", r"\frac{1}{R}"),
    (
        r"m \ddot x = -k x",
        r"x(t) = A\cos(\omega t), \quad \omega = \sqrt{\frac{k}{m}}",
        r"x(t) = A\cos(\omega t), \quad \omega = \sqrt{\frac{m}{k}}",
        r"\frac{k}{m}",
    ),
    (
        r"m \dot v = m g - b v",
        r"v(t) = \frac{m g}{b} \left(1 - e^{-\frac{b t}{m}}\right)",
        r"v(t) = \frac{b}{m} \left(1 - e^{\frac{t}{m}}\right)",
        "",
    ),
    (r"\ddot y = -g", r"y = h - \frac12 g t^2", r"y = h - \frac13 g t^2", "2"),
];

#[test]
fn a_solution_follows_from_the_equation_of_motion_before_it() {
    for (at, (law, solution, ..)) in SOLVED.iter().enumerate() {
        let (verdict, _) = last(&format!("right-{at}"), &[law, solution]);
        assert!(["certified", "verified"].contains(&verdict.as_str()), "{law}: {solution}: {verdict}");
    }
}

#[test]
fn a_slip_in_a_solution_is_called_wrong_if_one_edit_corrects_it() {
    for (at, (law, _, wrong, correction)) in SOLVED.iter().enumerate() {
        let (verdict, found) = last(&format!("wrong-{at}"), &[law, wrong]);
        match correction.is_empty() {
            // Several edits away from a solution, so nothing is said.
            true => assert_ne!(verdict, "refuted", "{law}: {wrong}"),
            false => assert_eq!((verdict.as_str(), found.as_deref()), ("refuted", Some(*correction)), "{law}: {wrong}"),
        }
    }
}

/// A value that is put in for a symbol does not say what its rates are.
#[test]
fn an_equation_with_rates_alone_is_not_solved_by_any_formula() {
    for (at, [law, printed]) in [
        [r"m \ddot x = -b \dot x", r"x = x_0 + v_0 t"],
        [r"m \ddot x = -b \dot x", r"x = \frac{m v_0}{b}\left(1 + e^{b t/m}\right)"],
        [r"\ddot y + k y\dot y = 0", r"y = B\cos\omega t"],
    ]
    .into_iter()
    .enumerate()
    {
        let (verdict, _) = last(&format!("rates-{at}"), &[law, printed]);
        assert!(verdict != "certified" && verdict != "verified", "{printed}: {verdict}");
    }
}

#[test]
fn what_solves_another_equation_is_not_called_wrong() {
    for (at, page) in [
        // For small angles only.
        [r"\ddot\theta = -\frac{g}{l} \sin\theta", r"\theta(t) = \theta_0 \cos\omega t"],
        // Another motion with the same letter.
        [r"m \ddot x = -k x", r"x(t) = v t"],
        [r"m \ddot x = -k x", r"x(t) = x_0 + v t + \frac12 a t^2"],
        [r"\dot N = r N", r"N(t) = \frac{K}{1 + C e^{-r t}}"],
    ]
    .iter()
    .enumerate()
    {
        let (verdict, _) = last(&format!("other-{at}"), page);
        assert_ne!(verdict, "refuted", "{page:?}");
    }
}

#[test]
fn values_with_an_index_are_roots_of_an_earlier_relation() {
    for (at, [law, roots, slipped]) in [
        [
            r"s^2 + 2\gamma s + \omega_0^2 = 0",
            r"s_{1,2} = -\gamma \pm \sqrt{\gamma^2 - \omega_0^2}",
            r"s_{1,2} = -\gamma \pm \sqrt{\gamma^2 + \omega_0^2}",
        ],
        [
            r"\omega L - \frac{1}{\omega C} = R",
            r"\omega_+ = \frac{R}{2L} + \sqrt{\frac{R^2}{4L^2} + \frac{1}{LC}}",
            r"\omega_+ = \frac{R}{2L} + \sqrt{\frac{R^2}{4L^2} - \frac{1}{LC}}",
        ],
    ]
    .into_iter()
    .enumerate()
    {
        let (verdict, _) = last(&format!("roots-{at}"), &[law, roots]);
        assert!(matches!(verdict.as_str(), "verified" | "certified"), "{roots}: {verdict}");
        let (verdict, _) = last(&format!("roots-slip-{at}"), &[law, slipped]);
        assert!(!matches!(verdict.as_str(), "verified" | "certified"), "{slipped}: {verdict}");
    }
    // another relation, and another letter
    let (verdict, _) = last("no-roots", &[r"s^2 + 2\gamma s + \omega_0^2 = 0", r"u_{1,2} = -\gamma \pm b"]);
    assert_ne!(verdict, "refuted");
}

/// Two oscillators, whose frequencies stand in the energy before a display says what they are.
fn oscillators(relations: &str, solution: &str) -> [String; 4] {
    [
        r"L = \frac12 m (\dot x^2 + \dot y^2) - \frac12 k x^2 - \frac12 q y^2".to_owned(),
        r"E = \frac12 m (\dot x^2 + \dot y^2 + \omega^2 x^2 + \nu^2 y^2)".to_owned(),
        relations.to_owned(),
        solution.to_owned(),
    ]
}

#[test]
fn a_solution_is_judged_with_the_relations_for_its_constants() {
    let judged =
        |name: &str, displays: &[String; 4]| last(name, &displays.iter().map(String::as_str).collect::<Vec<_>>());
    let relations = r"\omega^2 = \frac km, \qquad \nu^2 = \frac qm";
    let right = r"x(t) = A \cos(\omega t + \alpha), \qquad y(t) = B \cos(\nu t + \beta)";
    assert_eq!(judged("constants", &oscillators(relations, right)).0, "certified");
    let wrong = r"x(t) = A \cos(\omega t + \alpha), \qquad y(t) = B \cos(\omega t + \beta)";
    assert_eq!(
        judged("constants-wrong", &oscillators(relations, wrong)),
        ("refuted".to_owned(), Some(r"\nu".to_owned()))
    );
    // Where no relation is printed, x for y is no slip in a display that gives both.
    let free = oscillators(r"\omega \nu = 1", r"x(t) = A \cos(\omega t), \qquad y(t) = B e^{-\nu t}");
    assert_ne!(judged("constants-free", &free).0, "refuted");
}

/// Of a chain, the equality of a name with its formula, and an identity, are solved by anything.
#[test]
fn what_solves_a_chain_solves_an_equality_that_says_something() {
    for (at, (chain, right, wrong)) in [
        (r"F = k x = m g", r"x = \frac{m g}{k}", r"x = \frac{m g}{k^2}"),
        (r"P = V I = R I^2", r"I = \frac{V}{R}", r"I = \frac{R}{V}"),
        (r"E = \frac12 m v^2 = m g h", r"v = \sqrt{2 g h}", r"v = \sqrt{g h}"),
    ]
    .into_iter()
    .enumerate()
    {
        let passes = ["certified", "verified"];
        let (verdict, _) = last(&format!("chain-{at}"), &[chain, right]);
        assert!(passes.contains(&verdict.as_str()), "{chain}: {right}: {verdict}");
        let (verdict, _) = last(&format!("chain-wrong-{at}"), &[chain, wrong]);
        assert!(!passes.contains(&verdict.as_str()), "{chain}: {wrong}: {verdict}");
    }
    let potential = r"V = \frac12 k x^2 - m g x";
    let (verdict, _) = last("chain-identity", &[potential, r"\frac{dV}{dx} = k x - m g = 0", r"x = \frac{m g}{k^2}"]);
    assert_eq!(verdict, "refuted");
}

/// Of a relation that an equation solves, some names may drop out: the pressure at both ends, the density.
#[test]
fn a_relation_may_have_names_that_its_solution_has_not() {
    let outflow = |speed: &str| {
        format!(
            "Bernoulli:\n\n$$ p + \\rho g h = p + \\frac12 \\rho v^2 $$\n\nHence the speed is\n\n$$ v = \\sqrt{{{speed}}} $$\n"
        )
    };
    let found = |name: &str, speed: &str| verdicts(&format!("unaided-outflow-{name}"), &outflow(speed)).pop();
    assert_eq!(found("true", "2 g h").as_deref(), Some("certified"));
    assert_eq!(found("slip", r"\frac{2 g}{h}").as_deref(), Some("refuted"));
    // With a name more the correction is of another case: at another place the pressure is another one.
    assert_ne!(found("case", r"2 g h + \frac{2 q}{\rho}").as_deref(), Some("refuted"));
}
