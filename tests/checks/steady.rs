//! Steady motions and places of rest: a coordinate that stays where a hypothesis puts it, the frequency of small oscillations about it,
//! and motions that start with given values.

use onshell::check::Verdict::{Refuted, Undecided, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, equation, error, outcome, verdict, with};

const HOOP: &str = r"L = \frac12 m R^2 (\dot\theta^2 + \omega^2\sin^2\theta) + m g R\cos\theta";
const PENDULUM: &str = r"L = \frac12 m l^2(\dot\theta^2 + \dot\phi^2\sin^2\theta) + m g l\cos\theta";

fn hoop() -> Json {
    json!({
        "coordinates": { r"\theta": "angle" },
        "constants": { r"m, g, R, \omega": "> 0", r"\theta_0": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian" },
    })
}

fn spherical() -> Json {
    json!({
        "coordinates": { r"\theta": "(0, \\pi)", r"\phi": "angle" },
        "constants": { "m, g, l": "> 0", r"\theta_0": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian" },
    })
}

/// What is said of a frequency of these small oscillations.
fn frequency(claims: &Json, about: &str, displays: &[&str]) -> onshell::check::Verdict {
    let mut claims = claims.clone();
    claims["means"][r"\Omega"] = json!(format!("frequency of small oscillations{about}"));
    verdict(&claims, displays, json!({}))
}

#[test]
fn a_coordinate_that_stays_where_a_hypothesis_puts_it_is_meant() {
    let there = || json!({ "assume": r"\theta = \theta_0" });
    assert_eq!(verdict(&hoop(), &[HOOP, r"\cos\theta_0 = \frac{g}{R\omega^2}"], there()), Verified);
    assert_eq!(verdict(&spherical(), &[PENDULUM, r"\dot\phi^2 = \frac{g}{l\cos\theta_0}"], there()), Verified);
    let found = equation(&spherical(), &[PENDULUM, r"\dot\phi^2 = \frac{g}{l\cos\theta_0}"], there());
    assert!(found.finding.message.contains("while the coordinate stays"), "{}", found.finding.message);
    // The twins: a slip; what holds at any instant at which the coordinate is there; and a point that is passed with a velocity.
    let lowest = json!({ "assume": r"\theta = 0" });
    assert_eq!(verdict(&hoop(), &[HOOP, r"p_\theta\dot\theta - L = -m g R"], lowest), Refuted);
    assert_eq!(verdict(&hoop(), &[HOOP, r"\cos\theta_0 = \frac{g}{R\omega}"], there()), Refuted);
    let slip = equation(&spherical(), &[PENDULUM, r"\dot\phi^2 = \frac{g}{l\sin\theta_0}"], there());
    assert_eq!(slip.finding.verdict, Refuted);
    assert_eq!(slip.repairs.first().map(|repair| repair.replacement.as_str()), Some(r"\cos"));
    let momentum = equation(&hoop(), &[HOOP, r"m R^2\dot\theta = p_\theta"], there());
    assert!(!momentum.finding.message.contains("while the coordinate stays"), "{}", momentum.finding.message);
}

#[test]
fn a_frequency_about_a_place_follows_from_the_lagrangian() {
    let about = r" about \theta = \theta_0";
    let relative = r"\Omega^2 = \omega^2\sin^2\theta_0";
    assert_eq!(frequency(&hoop(), about, &[HOOP, relative]), Verified);
    assert_eq!(frequency(&hoop(), about, &[HOOP, r"\Omega^2 = \omega^2 - \frac{g^2}{R^2\omega^2}"]), Verified);
    assert_eq!(frequency(&hoop(), about, &[HOOP, r"\Omega^2 = \omega^2\cos^2\theta_0"]), Refuted);
    assert_eq!(frequency(&hoop(), r" about \theta = 0", &[HOOP, r"\Omega^2 = \frac gR - \omega^2"]), Verified);
    assert_eq!(frequency(&hoop(), "", &[HOOP, r"\Omega^2 = \frac gR + \omega^2"]), Refuted);
    // With the momentum of a cyclic coordinate fixed, not its velocity.
    let about = r" about \theta = \theta_0 at fixed p_\phi";
    let conical = r"\Omega^2 = \frac gl \frac{1 + 3\cos^2\theta_0}{\cos\theta_0}";
    assert_eq!(frequency(&spherical(), about, &[PENDULUM, conical]), Verified);
    let with_velocity = r"\Omega^2 = \frac gl \frac{\sin^2\theta_0}{\cos\theta_0}";
    assert_eq!(frequency(&spherical(), about, &[PENDULUM, with_velocity]), Refuted);
    let mut claims = spherical();
    claims["means"][r"\Omega"] = json!(format!("frequency of small oscillations{about}"));
    let slip = r"\Omega^2 = \frac gl \frac{1 + 3\sin^2\theta_0}{\cos\theta_0}";
    let found = equation(&claims, &[PENDULUM, slip], json!({}));
    assert_eq!(found.repairs.first().map(|repair| repair.replacement.as_str()), Some(r"\cos"));
    // A chain is tested at its first link too.
    let chain = r"\Omega^2 = \omega^2 - \omega^2\sin^2\theta_0 = \omega^2\cos^2\theta_0";
    assert_eq!(frequency(&hoop(), r" about \theta = \theta_0", &[HOOP, chain]), Refuted);
}

#[test]
fn a_frequency_with_forces_that_turn_and_one_beside_a_total_derivative_follow() {
    let charge = r"L = \frac12 m(\dot x^2 + \dot y^2) + q B x\dot y - \frac12 k(x^2 + y^2)";
    let claims = json!({
        "coordinates": { "x, y": "real" }, "constants": { "m, q, B, k": "> 0" }, "means": { "L": "Lagrangian" },
    });
    let right = r"\Omega = \frac{q B}{2m} + \sqrt{\frac{q^2B^2}{4m^2} + \frac km}";
    assert_eq!(frequency(&claims, "", &[charge, right]), Verified);
    let wrong = r"\Omega = \frac{q B}{2m} + \sqrt{\frac{q^2B^2}{4m^2} - \frac km}";
    assert_ne!(frequency(&claims, "", &[charge, wrong]), Verified);
    let carriage = r"L = \frac12 m l^2\dot\theta^2 + m a t l\dot\theta\cos\theta + m g l\cos\theta";
    let claims = json!({
        "coordinates": { r"\theta": "angle" }, "constants": { "m, l, a, g": "> 0" },
        "means": { "L": "Lagrangian", r"\theta_0": r"-\arctan(a/g)" },
    });
    let about = r" about \theta = \theta_0";
    assert_eq!(frequency(&claims, about, &[carriage, r"\Omega^2 = \frac{\sqrt{g^2 + a^2}}{l}"]), Verified);
    assert_eq!(frequency(&claims, about, &[carriage, r"\Omega^2 = \frac{\sqrt{g^2 - a^2}}{l}"]), Refuted);
}

#[test]
fn a_frequency_or_a_period_that_nothing_else_tests_is_tested_by_the_lagrangian() {
    let cart =
        r"L = \frac12(M + m)\dot x^2 + m l\dot x\dot\theta\cos\theta + \frac12 m l^2\dot\theta^2 + m g l\cos\theta";
    let claims = json!({
        "coordinates": { "x": "any", r"\theta": "angle" }, "constants": { "M, m, g, l": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let say = |latex: &str| verdict(&claims, &[cart, latex], json!({}));
    assert_eq!(say(r"\omega = \sqrt{\frac{(M + m)g}{M l}}"), Verified);
    assert_eq!(say(r"\tau = 2\pi\sqrt{\frac{M l}{(M + m)g}}"), Verified);
    // The twins: a slip, and a name that moves and has this value in the place of rest.
    assert_eq!(say(r"\omega = \sqrt{\frac{(M + m)g}{m l}}"), Undecided);
    assert_eq!(say(r"\tau = \pi\sqrt{\frac{M l}{(M + m)g}}"), Undecided);
    assert_eq!(say(r"\omega = \sqrt{\frac{(M + m)g}{M l}}\cos\theta"), Undecided);
}

#[test]
fn a_motion_starts_with_the_values_that_a_condition_gives() {
    let fall = r"L = \frac12 m\dot y^2 + \frac12 I\dot\phi^2 + m g y + \lambda(a\phi - y)";
    let claims = json!({
        "coordinates": { "y": "real", r"\phi": "angle", r"\lambda": "multiplier" },
        "constants": { "m, g, I, a": "> 0", "v_0": "real" },
        "means": { "L": "Lagrangian" },
    });
    let from_rest = || json!({ "assume": r"y(0) = 0, \dot y(0) = 0" });
    let spin = r"\dot\phi^2 = \frac{2 m g y}{m a^2 + I}";
    assert_eq!(verdict(&claims, &[fall, spin], from_rest()), Verified);
    assert_eq!(verdict(&claims, &[fall, r"\dot\phi^2 = \frac{m g y}{m a^2 + I}"], from_rest()), Refuted);
    let path = r"y = \frac{m a^2 g t^2}{2(m a^2 + I)}";
    assert_eq!(verdict(&claims, &[fall, path], from_rest()), Verified);
    assert_eq!(verdict(&claims, &[fall, r"y = \frac{m a^2 g t^2}{m a^2 + I}"], from_rest()), Refuted);
    // The twins: other initial values, and none.
    let moving = || json!({ "assume": r"y(0) = 0, \dot y(0) = v_0" });
    assert_eq!(verdict(&claims, &[fall, spin], moving()), Refuted);
    assert_eq!(verdict(&claims, &[fall, path], moving()), Refuted);
    assert_eq!(verdict(&claims, &[fall, spin], json!({})), Refuted);
}

#[test]
fn a_constant_may_be_set_to_an_end_of_its_range() {
    let claims = json!({ "constants": { "M, m, g": "> 0" } });
    let light = || json!({ "assume": "M = 0" });
    assert_eq!(verdict(&claims, &[r"a = \frac{m - M}{m + M} g", "(m + M) a = m g"], light()), Verified);
    assert_eq!(verdict(&claims, &[r"a = \frac{m - M}{m + M} g", "(m + M) a = M g"], light()), Refuted);
    // The twin: a range does not contain the other sign.
    let negative = json!({ "assume": "M = -m" });
    assert_eq!(verdict(&claims, &[r"a = (m - M) g", "a = 2 m g"], negative), Undecided);
}

#[test]
fn the_claims_file_takes_the_words_that_authors_use() {
    let claims = json!({
        "coordinates": { "x": "real" },
        "constants": { "k, m": "> 0", "b": "nonzero", "c": "> k" },
        "means": { "L": "Lagrangian", "r": r"x^2 + b^2", "q": "x" },
    });
    let lagrangian = r"L = \frac12 m\dot x^2 - \frac12 k x^2";
    let say = |latex: &str| verdict(&claims, &[lagrangian, latex], json!({}));
    assert_eq!(say(r"m \ddot q = -k q"), Verified);
    assert_eq!(say(r"\dot r = 2 x\dot x"), Verified);
    assert_eq!(say(r"\dot r = 2 b\dot x"), Refuted);
    assert_eq!(say(r"b^2 > 0"), Verified);
    assert_eq!(say(r"c > k"), Undecided);
    assert_eq!(say(r"c > 2 k"), Refuted);
    // The twins: words that mean nothing stay errors.
    let range = with(&claims, "constants", json!({ "k, m": "> 0", "b": "postive", "c": "> k" }));
    assert!(error(&range, &[lagrangian], json!({})).contains("postive"));
    let meaning = with(&claims, "means", json!({ "L": "Lagrangian", "t_1": "the time at which it stops" }));
    assert!(error(&meaning, &[lagrangian], json!({})).contains("at which it stops"));
}

#[test]
fn a_display_about_a_case_defines_a_name_only_where_no_other_does() {
    let energy =
        r"E = \frac12 m l^2(\dot\theta^2 + \dot\phi^2\sin^2\theta) - m g l\cos\theta = \frac12 m l^2\dot\theta^2 + U";
    let displays = [
        PENDULUM,
        energy,
        r"U = \frac{p_\phi^2}{2 m l^2\sin^2\theta} - m g l\cos\theta",
        r"E = \frac{m g l}{2}\frac{1 - 3\cos^2\theta_0}{\cos\theta_0}",
    ];
    let claim = || json!({ "assume": r"\theta = \theta_0" });
    assert_eq!(verdict(&spherical(), &displays, claim()), Verified);
    let slip = [displays[0], displays[1], displays[2], r"E = \frac{m g l}{2}\frac{1 + 3\cos^2\theta_0}{\cos\theta_0}"];
    assert_eq!(verdict(&spherical(), &slip, claim()), Refuted);
    // The twin: where no other display defines it, the case does.
    let alone = equation(&spherical(), &[PENDULUM, r"A = 2\theta_0"], claim());
    assert!(alone.finding.message.contains("defines A"), "{}", alone.finding.message);
}

#[test]
fn a_linearised_equation_may_be_printed_as_an_equality_where_the_words_say_so() {
    let claims = json!({
        "coordinates": { r"\theta": "angle" }, "constants": { "m, l, g": "> 0" }, "means": { "L": "Lagrangian" },
    });
    let said = |words: &str, law: &str, claim: Json| {
        let lagrangian = r"$$ L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta \tag{1} $$";
        let notes = format!("{lagrangian}\n\n{words}\n\n$$ {law} \\tag{{2}} $$\n");
        let claims = with(&claims, "equations", json!({ "2": claim }));
        let found = document(&claims, &notes, &Registry::standard(), Some("2"));
        outcome(&found.unwrap_or_else(|error| panic!("{error}")).equations.remove(0).finding)
    };
    let law = r"\ddot\theta = -\frac gl\theta";
    assert_eq!(said("For small oscillations", law, json!({})), Verified);
    assert_eq!(said("We find", law, json!({ "assume": r"small oscillations about \theta = 0" })), Verified);
    // The twins: without the words, with words of another sentence, and with a slip.
    assert_eq!(said("We find", law, json!({})), Refuted);
    assert_eq!(said("The angle is small. In general", law, json!({})), Refuted);
    assert_eq!(said("For oscillations that are not small", law, json!({})), Refuted);
    assert_eq!(said("For small oscillations", r"\ddot\theta = -\frac{g}{2l}\theta", json!({})), Refuted);
    assert_eq!(said("For small oscillations", r"\ddot\theta = \frac gl\theta", json!({})), Refuted);
}

/// A cylinder that rolls in a hollow one, with the multiplier of the condition of rolling.
fn rolling() -> Json {
    json!({
        "coordinates": { r"\theta, \phi": "angle", r"\lambda": "multiplier" },
        "constants": { "m, g, a": "> 0", "R": "> a" },
        "means": { "L": "Lagrangian" },
        "constraints": { r"\lambda": r"(R - a)\dot\theta - a\dot\phi" },
    })
}

const ROLLING: &str = r"L = \frac12 m(R - a)^2\dot\theta^2 + \frac14 m a^2\dot\phi^2 + m g(R - a)\cos\theta";

#[test]
fn a_small_motion_with_a_multiplier_is_that_of_the_free_coordinates() {
    let small = || json!({ "assume": r"small oscillations about \theta = 0" });
    let linear = |square: &str| format!(r"\ddot\theta + \omega^2\theta = 0, \qquad \omega = \sqrt{{{square}}}");
    let of = |square: &str| equation(&rolling(), &[ROLLING, &linear(square)], small());
    let found = of(r"\frac{2g}{3(R - a)}");
    assert_eq!(found.finding.verdict, Verified, "{:?}", found.parts);
    // The twins: as if nothing rolled, and without the words.
    let slip = of(r"\frac{g}{R - a}");
    assert_eq!(slip.finding.verdict, Refuted);
    let exact = equation(&rolling(), &[ROLLING, &linear(r"\frac{2g}{3(R - a)}")], json!({}));
    assert_eq!(exact.finding.verdict, Refuted);
    // The constraint in the Lagrangian itself: one of two coordinates is free.
    let claims = json!({
        "coordinates": { "x": "any", "y": "< 0", r"\lambda": "multiplier" },
        "constants": { "m, g, l": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let rod = r"L = \frac12 m(\dot x^2 + \dot y^2) - m g y + \lambda(x^2 + y^2 - l^2)";
    let about = || json!({ "assume": "small oscillations about x = 0" });
    assert_eq!(verdict(&claims, &[rod, r"\ddot x = -\frac gl x"], about()), Verified);
    assert_eq!(verdict(&claims, &[rod, r"\ddot x = -\frac{2g}{l} x"], about()), Refuted);
}

#[test]
fn a_linearised_equation_is_corrected_as_one() {
    let claims = json!({
        "coordinates": { r"\theta": "angle" }, "constants": { "m, l, g": "> 0" }, "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta";
    let small = json!({ "assume": r"small oscillations about \theta = 0" });
    let found = equation(&claims, &[lagrangian, r"l\dot\theta = -g\theta"], small.clone());
    let first = found.repairs.first().map(|repair| repair.replacement.as_str());
    assert_eq!((found.finding.verdict, first), (Refuted, Some(r"\ddot{\theta}")));
    let found = equation(&claims, &[lagrangian, r"l\ddot\theta = g\theta"], small);
    assert_eq!(found.repairs.first().map(|repair| repair.replacement.trim()), Some("-"));
}

/// A particle on a line.
fn on_a_line() -> Json {
    json!({
        "coordinates": { "x": "any" },
        "constants": { r"m, \omega_0, \beta": "> 0", r"\alpha": "any" },
        "means": { "L": "Lagrangian" },
    })
}

#[test]
fn both_roots_of_an_equation_are_places_of_rest() {
    let lagrangian = r"L = \frac12 m\dot x^2 - \frac12 m\omega_0^2 x^2 - \frac13 m\alpha x^3 - \frac14 m\beta x^4";
    let at = |root: &str| {
        let claim = json!({ "equilibrium": true, "assume": r"\alpha^2 > 4\beta\omega_0^2" });
        verdict(&on_a_line(), &[lagrangian, root], claim)
    };
    assert_eq!(at(r"x = \frac{-\alpha \pm \sqrt{\alpha^2 - 4\beta\omega_0^2}}{2\beta}"), Verified);
    assert_eq!(at(r"x = \frac{\alpha \pm \sqrt{\alpha^2 - 4\beta\omega_0^2}}{2\beta}"), Refuted);
}

#[test]
fn a_coordinate_beside_two_places_belongs_to_both() {
    let claims = json!({ "coordinates": { "x, y": "any" }, "means": { "L": "Lagrangian" } });
    let lagrangian = r"L = \frac12(\dot x^2 + \dot y^2) - \frac12(x^2 + y^2) - x^2 y + \frac13 y^3";
    let at = |places: &str| verdict(&claims, &[lagrangian, places], json!({ "equilibrium": "unstable" }));
    assert_eq!(at(r"x = \pm\frac{\sqrt 3}{2}, \qquad y = -\frac12"), Verified);
    assert_eq!(at(r"x = \pm\frac{\sqrt 3}{2}, \qquad y = \frac12"), Refuted);
    // The signs go together.
    let claims =
        json!({ "coordinates": { "x, y": "any" }, "constants": { "a": "> 0" }, "means": { "L": "Lagrangian" } });
    let valley = r"L = \frac12(\dot x^2 + \dot y^2) - (x^2 - a^2)^2 - (y - x)^2";
    let at = |places: &str| verdict(&claims, &[valley, places], json!({ "equilibrium": true }));
    assert_eq!(at(r"x = \pm a, \qquad y = \pm a"), Verified);
    assert_eq!(at(r"x = \pm a, \qquad y = \mp a"), Refuted);
}

#[test]
fn numbers_are_drawn_where_inequalities_hold() {
    let claims = json!({
        "coordinates": { "r": "> a", "s": "> b" },
        "constants": { "a, b": "> 0", "c": "> a", "d": "> b" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = \frac12(\dot r^2 + \dot s^2) - \sqrt{r^2 - a^2} - \sqrt{s^2 - b^2}";
    let law =
        |root: &str| verdict(&claims, &[lagrangian, &format!(r"\ddot r = -\frac{{r}}{{\sqrt{{{root}}}}}")], json!({}));
    assert_eq!(law("r^2 - a^2"), Verified);
    assert_eq!(law("r^2 + a^2"), Refuted);
    // The twin: no number is above itself.
    let none = with(&claims, "assume", json!(["c > d", "d > c"]));
    assert_eq!(verdict(&none, &[lagrangian, r"\ddot r = -\frac{r}{\sqrt{r^2 - a^2}}"], json!({})), Undecided);
}

#[test]
fn a_linearised_equation_may_be_about_another_place_than_0() {
    let claims = json!({
        "coordinates": { r"\theta": "angle" }, "constants": { r"m, l, g, \omega": "> 0", r"\theta_0": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian" },
        "define": { r"\varepsilon": r"\theta - \pi", r"\delta": r"\theta - \theta_0" },
    });
    let about = |lagrangian: &str, place: &str, law: &str| {
        let small = json!({ "assume": format!(r"small oscillations about \theta = {place}") });
        verdict(&claims, &[lagrangian, law], small)
    };
    let pendulum = r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta";
    assert_eq!(about(pendulum, r"\pi", r"\ddot\varepsilon = \frac gl\varepsilon"), Verified);
    // The twins: slips, another place, and a place that may be none of rest.
    assert_eq!(about(pendulum, r"\pi", r"\ddot\varepsilon = -\frac gl\varepsilon"), Refuted);
    assert_eq!(about(pendulum, r"\pi", r"\ddot\varepsilon = \frac{g}{2l}\varepsilon"), Refuted);
    assert_eq!(about(pendulum, "0", r"\ddot\varepsilon = \frac gl\varepsilon"), Refuted);
    assert_eq!(about(pendulum, r"\theta_0", r"\ddot\delta = -\frac gl\cos\theta_0\,\delta"), Undecided);
    // A slip there is corrected there.
    let small = json!({ "assume": r"small oscillations about \theta = \pi" });
    let found = equation(&claims, &[pendulum, r"\ddot\varepsilon = -\frac gl\varepsilon"], small);
    assert_eq!(found.repairs.first().map(|repair| repair.replacement.trim()), Some(""));
}

#[test]
fn a_frequency_is_tested_where_the_place_is_stable() {
    // About θ = 0 it is stable only where g > R ω².
    let found = |latex: &str| {
        let mut claims = hoop();
        claims["means"][r"\Omega"] = json!(r"frequency of small oscillations about \theta = 0");
        equation(&claims, &[HOOP, latex], json!({})).finding
    };
    let slip = found(r"\Omega = \sqrt{\frac gR + \omega^2}");
    assert_eq!(slip.verdict, Refuted);
    assert!(slip.counterexample.is_some_and(|shown| shown.rhs > 0.0));
    assert_eq!(outcome(&found(r"\Omega = \sqrt{\frac gR - \omega^2}")), Verified);
}

#[test]
fn a_small_motion_is_tested_only_where_its_coordinate_has_inertia() {
    let claims = json!({
        "coordinates": { "r": "> 0", r"\theta": "angle" },
        "constants": { "m, g, l, k": "> 0", r"\theta_0": "any" },
        "means": { "L": "Lagrangian" },
    });
    let swing = |lagrangian: &str, claims: &Json, swing: &str| {
        let notes =
            format!("$$ {lagrangian} \\tag{{1}} $$\n\nFor small $\\theta$ the swing is\n\n$$ {swing} \\tag{{2}} $$\n");
        let found = document(claims, &notes, &Registry::standard(), Some("2"));
        outcome(&found.unwrap_or_else(|error| panic!("{error}")).equations.remove(0).finding)
    };
    let spring = r"L = \frac m2(\dot r^2 + r^2\dot\theta^2) - \frac k2 (r - l)^2 + m g r\cos\theta";
    // At r = 0 the angle has no inertia, and any formula would pass.
    assert_ne!(swing(spring, &claims, r"\theta(t) = \theta_0\cosh 7 t"), Verified);
    let rigid = r"L = \frac m2 l^2\dot\theta^2 + m g l\cos\theta";
    let claims = json!({
        "coordinates": { r"\theta": "angle" }, "constants": { "m, g, l": "> 0", r"\theta_0": "any" },
        "means": { "L": "Lagrangian" },
    });
    assert_eq!(swing(rigid, &claims, r"\theta(t) = \theta_0\cos(\sqrt{g/l}\,t)"), Verified);
    assert_ne!(swing(rigid, &claims, r"\theta(t) = \theta_0\cos(\sqrt{2g/l}\,t)"), Verified);
}
