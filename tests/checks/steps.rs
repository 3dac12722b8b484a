//! Derivations: a slip that later steps carry on is found once, where it was made; and nothing false is ever excused.

use onshell::check::{Document, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, numbers, outcome, pendulum, planet, top, with};

/// These displays as the steps of one derivation.
fn derivation(claims: &Json, displays: &[&str]) -> Document {
    let claims = with(claims, "steps", json!([format!("1..{}", displays.len())]));
    let found = document(&claims, &numbered(displays), &Registry::standard(), None);
    found.unwrap_or_else(|error| panic!("{displays:?}: {error}"))
}

/// What is said of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
    /// It passes.
    Right,
    /// It is false, and has a finding of its own.
    Wrong,
    /// It is false, and follows from this one, where the slip is.
    From(&'static str),
    /// It is neither.
    Open,
}
use Step::{From, Open, Right, Wrong};

/// What is said of each step of a derivation.
fn steps(claims: &Json, displays: &[&str]) -> Vec<Step> {
    let said = derivation(claims, displays).equations.into_iter().map(|equation| {
        let own = equation.finding.counterexample.is_some();
        match (&equation.finding.follows_from, outcome(&equation.finding)) {
            (None, Verdict::Verified | Verdict::Definition) => Right,
            (None, Verdict::Refuted) if own => Wrong,
            (Some(inherited), Verdict::Refuted) => {
                // One slip, one finding: here there is nothing to correct, and it is not as expected all the same.
                assert!(!own && equation.repairs.is_empty() && !equation.ok, "{equation:?}");
                assert_eq!((&equation.finding.difference, &equation.finding.derived), (&None, &None));
                From(["1", "2", "3", "4", "5", "6", "7"][inherited.root.parse::<usize>().expect("a number") - 1])
            }
            _ => Open,
        }
    });
    said.collect()
}

/// The derivation of a pendulum's motion, with a sign in U that is carried on, and these further steps.
fn swinging<'a>(sign: &'a [String; 4], more: &[&'a str]) -> Vec<&'a str> {
    let first = [r"T = \frac12 m l^2 \dot\theta^2"].into_iter();
    first.chain(sign.iter().map(String::as_str)).chain(more.iter().copied()).collect()
}

fn with_potential(sign: &str, other: &str) -> [String; 4] {
    [
        format!(r"U = {sign} m g l \cos\theta"),
        format!(r"L = T - U = \frac12 m l^2 \dot\theta^2 {other} m g l \cos\theta"),
        format!(r"m l^2 \ddot\theta = {sign} m g l \sin\theta"),
        format!(r"\ddot\theta = {sign} \frac{{g}}{{l}} \sin\theta"),
    ]
}

#[test]
fn a_sign_in_the_potential_energy_is_found_once() {
    let energy = r"E = T + U = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta";
    let rate = r"\frac{d}{dt}\left( \frac12 \dot\theta^2 + \frac{g}{l} \cos\theta \right) = 0";
    let wrong = with_potential("", "-");
    assert_eq!(
        steps(&pendulum(), &swinging(&wrong, &[energy, rate])),
        [Right, Wrong, From("2"), From("2"), From("2"), From("2"), From("2")]
    );
    // The twin: with the sign mended nothing follows from anything.
    let energy = r"E = T + U = \frac12 m l^2 \dot\theta^2 - m g l \cos\theta";
    assert_eq!(steps(&pendulum(), &swinging(&with_potential("-", "+"), &[energy])), [Right; 6]);
}

#[test]
fn a_second_slip_is_a_second_finding() {
    let [potential, lagrangian, ..] = with_potential("", "-");
    let motion = r"m l^2 \ddot\theta = 2 m g l \sin\theta";
    let said = steps(&pendulum(), &[&potential, &lagrangian, motion, r"\ddot\theta = 2\frac{g}{l} \sin\theta"]);
    assert_eq!(said, [Wrong, From("1"), Wrong, From("3")]);
    let found = derivation(&pendulum(), &[&potential, motion]);
    let message = &found.equations[1].finding.message;
    assert!(message.contains("it does not follow from (1) either"), "{message}");
    // No repair makes it follow from what is false.
    assert!(found.equations[1].repairs.iter().all(|repair| repair.verdict.passes()), "{:?}", found.equations[1]);
}

#[test]
fn of_a_chain_what_follows_is_explained_and_what_does_not_is_found() {
    let chain = r"L = \frac12 m l^2 \dot\theta^2 - U = \frac12 m l^2 \dot\theta^2 - m g l \cos\theta = \frac12 m l^2 \dot\theta^2 - 3 m g l \cos\theta";
    let found = derivation(&pendulum(), &[r"U = m g l \cos\theta", chain]);
    let [_, lagrangian] = found.equations.as_slice() else { panic!("{found:?}") };
    let from = lagrangian.parts.iter().map(|part| part.finding.follows_from.as_ref().map(|from| from.root.as_str()));
    assert_eq!(from.collect::<Vec<_>>(), [Some("1"), None]);
    assert_eq!(lagrangian.finding.follows_from, None);
    assert!(lagrangian.finding.counterexample.is_some() && lagrangian.repairs.is_empty(), "{lagrangian:?}");
}

#[test]
fn a_wrong_power_of_r_goes_through_the_planets_motion() {
    let claims = with(&planet(), "means", json!({ "E": "energy", "L": "Lagrangian", r"\ell": r"momentum of \phi" }));
    let said = steps(
        &claims,
        &[
            r"L = \frac12 m (\dot r^2 + r^2 \dot\phi^2) + \frac{GMm}{r^2}",
            r"\ell = m r^2 \dot\phi",
            r"\ell \text{ is constant}",
            r"m \ddot r = m r \dot\phi^2 - \frac{2 GMm}{r^3}",
            r"\ddot r = \frac{\ell^2}{m^2 r^3} - \frac{2 GM}{r^3}",
            r"E = \frac12 m \dot r^2 + \frac{\ell^2}{2 m r^2} - \frac{GMm}{r^2}",
            // and here one more
            r"m \dot r \ddot r = \frac{\ell^2}{m r^3} \dot r - \frac{3 GMm}{r^3} \dot r",
        ],
    );
    assert_eq!(said, [Wrong, Right, Right, From("1"), From("1"), From("1"), Wrong]);
}

#[test]
fn the_top_precesses_by_its_wrong_potential_energy() {
    let claims = with(&top(), "equations", json!({ "5": { "throughout": r"\dot\theta = 0" } }));
    let said = steps(
        &claims,
        &[
            r"T = \frac12 \lambda_1 (\dot\theta^2 + \dot\phi^2 \sin^2\theta) + \frac12 \lambda_3 (\dot\psi + \dot\phi\cos\theta)^2",
            r"U = -MgR \cos\theta",
            r"p_\psi = \lambda_3 (\dot\psi + \dot\phi\cos\theta)",
            r"\lambda_1 \ddot\theta = \lambda_1 \dot\phi^2 \sin\theta\cos\theta - \dot\phi \sin\theta \, p_\psi - MgR \sin\theta",
            r"\lambda_1 \dot\phi^2 \cos\theta - \dot\phi \, p_\psi = MgR",
            r"H = \frac{p_\theta^2}{2\lambda_1} + \frac{p_\psi^2}{2\lambda_3} + \frac{(p_\phi - p_\psi\cos\theta)^2}{2\lambda_1\sin^2\theta} - MgR\cos\theta",
        ],
    );
    assert_eq!(said, [Right, Wrong, Right, From("2"), From("2"), From("2")]);
}

#[test]
fn steps_follow_by_algebra_by_differentiation_and_for_small_angles() {
    let claims = with(&pendulum(), "equations", json!({ "5": { "small": r"\theta", "order": 2 } }));
    let slip = r"m l^2 \ddot\theta = 2 m g l \sin\theta";
    for step in [
        r"\dot\theta \ddot\theta = 2\frac{g}{l} \dot\theta \sin\theta",
        r"l \ddot\theta - 2 g \sin\theta = 0",
        r"\dddot\theta = 2\frac{g}{l} \dot\theta \cos\theta",
        r"\frac{d}{dt}\left( \frac12 \dot\theta^2 + 2\frac{g}{l} \cos\theta \right) = 0",
    ] {
        assert_eq!(steps(&pendulum(), &[slip, step]), [Wrong, From("1")], "{step}");
        // The twin: what is off by a factor more does not follow.
        let other = step.replacen('2', "7", 1).replacen(r"\dot\theta \cos", r"7 \dot\theta \cos", 1);
        assert_eq!(steps(&pendulum(), &[slip, &other])[1], Wrong, "{other}");
    }
    let linear = |factor: &str| format!(r"\ddot\theta \approx {factor}\frac{{g}}{{l}} \theta");
    let four =
        [slip, r"T = \frac12 m l^2 \dot\theta^2", r"l \ddot\theta = 2 g \sin\theta", r"p_\theta = m l^2 \dot\theta"];
    let with_last = |last: &str| steps(&claims, &[four.as_slice(), &[last]].concat()).pop();
    assert_eq!(with_last(&linear("2")), Some(From("1")));
    assert_eq!(with_last(&linear("5")), Some(Wrong));
}

#[test]
fn the_same_false_equation_in_other_words_is_the_same() {
    let slip = "(a+b)^2 = a^2 - 2ab + b^2";
    assert_eq!(steps(&numbers(), &[slip, "(a+b)^2 = (a-b)^2"]), [Wrong, From("1")]);
    assert_eq!(steps(&numbers(), &[slip, "(a+b)^2 = (a-c)^2"]), [Wrong, Wrong]);
}

#[test]
fn a_name_that_was_defined_is_a_name_in_what_follows() {
    let slip = ["s = a + b", "s^2 = a^2 + b^2"];
    let (square, other, right) = ("s^4 = (a^2 + b^2)^2", "s^4 = (a^2 + b^2)^2 + a^4", "s^2 - 2ab = a^2 + b^2");
    let said = steps(&numbers(), &[slip[0], slip[1], "s^2 - a^2 = b^2", square, other, right]);
    assert_eq!(said, [Right, Wrong, From("2"), From("2"), Wrong, Right]);
}

#[test]
fn what_is_said_of_particles_follows_by_its_rate() {
    let claims = json!({
        "indices": { "i, j": "labels 1..2" },
        "constants": { "m_i": "> 0" },
        "varies with time": { r"\vec r_i, \vec f_i, \vec F_{ij}": "any" },
        "define": { r"\vec P": r"\sum_i m_i \dot{\vec r}_i" },
        "laws": { "Newton's second law": "1" },
        "equations": { "2, 3, 4, 5": { "throughout": r"\vec F_{ij} = -\vec F_{ji}" } },
    });
    let said = steps(
        &claims,
        &[
            r"m_i \ddot{\vec r}_i = \vec f_i + \sum_{j \neq i} \vec F_{ij}",
            r"\dot{\vec P} = 2\sum_i \vec f_i",
            r"\ddot{\vec P} = 2\sum_i \dot{\vec f}_i",
            r"\sum_i m_i \ddot{\vec r}_i = 2\sum_i \vec f_i",
            r"\ddot{\vec P} = 3\sum_i \dot{\vec f}_i",
        ],
    );
    assert_eq!(said[1..], [Wrong, From("2"), From("2"), Wrong]);
}

#[test]
fn a_contradiction_implies_nothing() {
    let any = r"m l^2 \ddot\theta = 5 m g l \sin\theta";
    for (absurd, step) in [
        ("m = 2m", any),
        (r"m g l \sin\theta = -m g l \sin\theta", any),
        (r"m g l \sin\theta = -m g l \sin\theta", r"\cos^2\theta = 1"),
        (r"m l^2 \dot\theta \sin\theta = 0", r"U + 2 m l^2 \dot\theta^2 \cos\theta = U + m l^2 \dot\theta^2"),
        (r"m l^2 \dot\theta \sin\theta = 0", r"U \cos\dot\theta = U"),
        (r"\dot\theta = 0", r"\dot\theta^2 = 7 \dot\theta"),
        (r"L = m l^2 \dot\theta", any),
        (r"\theta = 0", r"l \ddot\theta = g \sin\theta"),
    ] {
        assert_eq!(steps(&pendulum(), &[absurd, step]), [Wrong, Wrong], "{absurd} and {step}");
    }
    for absurd in ["x = 2x", "a^3 b = 2 a^3 b"] {
        assert_eq!(steps(&numbers(), &[absurd, "x a = 5 x b"]), [Wrong, Wrong], "{absurd}");
    }
}

#[test]
fn a_true_step_and_a_false_one_are_not_put_together_to_anything() {
    // From both accelerations sin θ = 0 would follow, and with that whatever has it as a factor.
    let right = r"\ddot\theta = -\frac{g}{l} \sin\theta";
    let said =
        steps(&pendulum(), &[right, r"\ddot\theta = \frac{g}{l} \sin\theta", r"\ddot\theta = 7\frac{g}{l} \sin\theta"]);
    assert_eq!(said, [Right, Wrong, Wrong]);
    let potential = [r"T = \frac12 m l^2 \dot\theta^2", r"E = T - m g l \cos\theta", r"E = T + m g l \cos\theta"];
    // Both energies together leave cos θ = 0, where sin² θ is 1 and E is T.
    for step in [r"T \cos\theta = 3 U", r"E \sin^2\theta = T"] {
        let said = steps(&pendulum(), &[potential[0], potential[1], potential[2], step]);
        assert_eq!(said, [Right, Right, Wrong, Wrong], "{step}");
    }
    // And these leave it at rest, where any multiple of the velocity may be added.
    let right = r"E = T - m g l \cos\theta";
    let step = r"E + m l^2 \dot\theta^2 = T - m g l \cos\theta";
    let said = steps(&pendulum(), &[right, r"E = T - m g l \cos\theta + m l^2 \dot\theta \sin\theta", step]);
    assert_eq!(said, [Right, Wrong, Wrong]);
}

#[test]
fn what_is_right_after_a_slip_is_right_and_does_not_follow() {
    let slip = r"m l^2 \ddot\theta = m g l \sin\theta";
    let found =
        derivation(&pendulum(), &[slip, r"\ddot\theta = -\frac{g}{l} \sin\theta", r"p_\theta = m l^2 \dot\theta"]);
    let [_, motion, momentum] = found.equations.as_slice() else { panic!("{found:?}") };
    assert!(motion.ok && motion.finding.message.contains("it does not follow from (1) as printed"), "{motion:?}");
    // The twin: what the slip says nothing of is not held against it.
    assert!(momentum.ok && !momentum.finding.message.contains("(1)"), "{momentum:?}");
}

#[test]
fn a_step_under_fewer_hypotheses_does_not_follow() {
    let claims = with(&numbers(), "equations", json!({ "1": { "assume": "a = b" } }));
    assert_eq!(steps(&claims, &["a + c = 3b", "2a + 2c = 6b"]), [Wrong, Wrong]);
    let both = json!({ "1": { "assume": "a = b" }, "2": { "assume": "a = b" } });
    assert_eq!(steps(&with(&numbers(), "equations", both), &["a + c = 3b", "c + a = 3b"]), [Wrong, From("1")]);
}

#[test]
fn what_is_true_under_hypotheses_is_put_beside_a_slip_only_under_these() {
    let displays = ["E = U", "E = T - U", "T = 2U"];
    let rest = json!({ "throughout": r"\dot\theta = 0" });
    let with_last = |last: Json| {
        let claims = with(&pendulum(), "equations", json!({ "1": rest, "3": last }));
        steps(&claims, &displays).pop()
    };
    assert_eq!(with_last(json!({})), Some(Wrong));
    assert_eq!(with_last(rest.clone()), Some(From("2")));
    // What is assumed of an instant is no law: its rate says nothing.
    let now = json!({ "assume": r"\dot\theta^2 = \frac{g}{l}" });
    let rates = [r"\dot\theta = \frac{2 g}{l \dot\theta}", r"\ddot\theta = -\frac{2 g \ddot\theta}{l \dot\theta^2}"];
    let claims = with(&pendulum(), "equations", json!({ "1": now, "2": now }));
    assert_eq!(steps(&claims, &rates)[1], Wrong);
}

#[test]
fn a_slip_that_is_known_excuses_no_other() {
    let claims = with(&pendulum(), "equations", json!({ "1": { "expect": "refuted", "because": "the sign" } }));
    let slip = r"m l^2 \ddot\theta = m g l \sin\theta";
    assert_eq!(steps(&claims, &[slip, r"\ddot\theta = \frac{g}{l} \sin\theta"]), [Wrong, Wrong]);
}

#[test]
fn only_what_is_declared_is_a_derivation() {
    let displays = [r"m l^2 \ddot\theta = m g l \sin\theta", r"\ddot\theta = \frac{g}{l} \sin\theta"];
    let found = document(&pendulum(), &numbered(&displays), &Registry::standard(), None).expect("it can be checked");
    assert!(
        found.equations.iter().all(|equation| equation.finding.follows_from.is_none() && !equation.repairs.is_empty())
    );
}

#[test]
fn one_step_alone_is_judged_with_those_before_it() {
    let displays = [r"m l^2 \ddot\theta = m g l \sin\theta", r"\ddot\theta = \frac{g}{l} \sin\theta"];
    let claims = with(&pendulum(), "steps", json!("1, 2"));
    let found = document(&claims, &numbered(&displays), &Registry::standard(), Some("2")).expect("it can be checked");
    let [only] = found.equations.as_slice() else { panic!("{found:?}") };
    assert_eq!(only.finding.follows_from.as_ref().map(|inherited| inherited.from.as_str()), Some("1"));
}

#[test]
fn a_step_without_a_number_is_tested_too() {
    let notes =
        "$$ m l^2 \\ddot\\theta = m g l \\sin\\theta \\tag{1} $$\n\n$$ \\ddot\\theta = \\frac{g}{l} \\sin\\theta $$\n";
    let claims = with(&pendulum(), "steps", json!("1, `\\frac{g}{l}`"));
    let found = document(&claims, notes, &Registry::standard(), None).expect("it can be checked");
    assert_eq!((found.equations.len(), found.unnumbered), (2, 0));
    assert!(found.equations[1].finding.follows_from.is_some(), "{:?}", found.equations[1]);
}
