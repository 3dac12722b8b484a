//! Notes without a claims file: slips in what other displays rest on.

use serde_json::Value;

use crate::support::{Desk, verdicts};

/// The ids of the displays that are called wrong, each with the text of its first repair.
fn wrong(name: &str, notes: &str) -> Vec<(String, String)> {
    let desk = Desk::new(&format!("causes-{name}"));
    desk.write("notes.md", notes);
    let report = desk.onshell(&["check", "notes.md", "--format", "json"]).json();
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let refuted = equations.iter().filter(|equation| equation["verdict"] == "refuted");
    refuted.map(|equation| (text(&equation["id"]), text(&equation["repairs"][0]["replacement"]))).collect()
}

/// A block on a spring on a slope, with its energy and the words before it.
fn block(words: &str, energy: &str) -> String {
    format!(
        "A block on a spring slides on a slope of the angle $\\alpha$.\n\n\
         $$ L = \\frac12 m \\dot x^2 - \\frac12 k x^2 + m g x \\sin\\alpha \\tag{{1}} $$\n\n\
         {words}\n\n$$ {energy} \\tag{{2}} $$\n"
    )
}

#[test]
fn the_energy_of_a_natural_system_needs_no_word_that_it_is_conserved() {
    let (right, slip) = (
        r"E = \frac12 m \dot x^2 + \frac12 k x^2 - m g x \sin\alpha",
        r"E = \frac12 m \dot x^2 + \frac12 k x^2 + m g x \sin\alpha",
    );
    for words in ["The total energy is", "Multiplying by $\\dot x$ and integrating, we get"] {
        assert_eq!(wrong("energy", &block(words, right)), [], "{words}");
        assert_eq!(wrong("energy-slip", &block(words, slip)), [("2".to_owned(), "-".to_owned())], "{words}");
    }
}

#[test]
fn the_energy_of_a_driven_system_is_no_slip() {
    // T + V of a bead on a turning hoop is not conserved, and one sign away from what is.
    let hoop = r"A bead slides on a hoop that turns.

$$ L = \frac12 m R^2 \dot\theta^2 + \frac12 m R^2 \Omega^2 \sin^2\theta + m g R \cos\theta \tag{1} $$

The total energy is

$$ E = \frac12 m R^2 \dot\theta^2 + \frac12 m R^2 \Omega^2 \sin^2\theta - m g R \cos\theta \tag{2} $$
";
    assert_eq!(wrong("hoop", hoop), []);
}

/// A mass on a spring, from its lowest law to the motion about the place of rest.
fn hanging(law: &str) -> String {
    format!(
        "A mass hangs on a spring; $y$ is the length by which the spring is stretched. Newton's law says\n\n\
         $$ {law} \\tag{{1}} $$\n\nThe mass stays at rest at\n\n$$ y_0 = \\frac{{m g}}{{k}} \\tag{{2}} $$\n\n\
         With $z = y - y_0$ this becomes, therefore,\n\n$$ m \\ddot z = -k z \\tag{{3}} $$\n"
    )
}

#[test]
fn a_law_is_wrong_if_with_one_edit_of_it_a_consequence_follows() {
    assert_eq!(wrong("law", &hanging(r"m \ddot y = m g - k y")), []);
    assert_eq!(wrong("law-slip", &hanging(r"m \ddot y = m g + k y")), [("1".to_owned(), "-".to_owned())]);
}

/// A circuit: its frequency, its impedance, and what is calculated with them.
fn circuit(frequency: &str, impedance: &str) -> String {
    format!(
        "Without resistance the circuit oscillates with the frequency\n\n$$ \\omega_0 = {frequency} \\tag{{1}} $$\n\n\
         The impedance is\n\n$$ Z = {impedance} \\tag{{2}} $$\n\nIts modulus and its phase are\n\n\
         $$ |Z| = \\sqrt{{R^2 + \\left(\\omega L - \\frac{{1}}{{\\omega C}}\\right)^2}}, \
         \\qquad \\tan\\phi = \\frac{{\\omega L - \\frac{{1}}{{\\omega C}}}}{{R}} \\tag{{3}} $$\n\n\
         and the quality factor is\n\n\
         $$ Q = \\frac{{\\omega_0 L}}{{R}} = \\frac{{1}}{{R}} \\sqrt{{\\frac{{L}}{{C}}}} \\tag{{4}} $$\n"
    )
}

#[test]
fn a_definition_is_wrong_if_with_one_edit_of_it_a_chain_follows() {
    let (frequency, impedance) = (r"\frac{1}{\sqrt{L C}}", r"R + i \left( \omega L - \frac{1}{\omega C} \right)");
    assert_eq!(wrong("circuit", &circuit(frequency, impedance)), []);
    let ids = |found: Vec<(String, String)>| found.into_iter().map(|(id, _)| id).collect::<Vec<_>>();
    assert_eq!(ids(wrong("frequency", &circuit(r"\frac{1}{L C}", impedance))), ["1"]);
    let sign = r"R + i \left( \omega L + \frac{1}{\omega C} \right)";
    assert_eq!(wrong("impedance", &circuit(frequency, sign)), [("2".to_owned(), "-".to_owned())]);
}

/// A pendulum from its place to its equation of motion.
fn pendulum(height: &str, potential: &str) -> String {
    format!(
        "The bob of a pendulum is at\n\n$$ x = \\ell \\sin\\theta, \\qquad y = {height} \\tag{{1}} $$\n\n\
         so its potential energy is\n\n$$ V = m g y = {potential} \\tag{{2}} $$\n\n\
         and with the kinetic energy we have\n\n\
         $$ L = \\frac12 m \\ell^2 \\dot\\theta^2 - V = \\frac12 m \\ell^2 \\dot\\theta^2 + m g \\ell \\cos\\theta \\tag{{3}} $$\n\n\
         The equation of motion is\n\n$$ \\ell \\ddot\\theta + g \\sin\\theta = 0 \\tag{{4}} $$\n"
    )
}

#[test]
fn what_makes_several_displays_wrong_is_wrong_itself() {
    let (height, potential) = (r"-\ell \cos\theta", r"- m g \ell \cos\theta");
    assert_eq!(wrong("pendulum", &pendulum(height, potential)), []);
    assert_eq!(wrong("height", &pendulum(r"\ell \cos\theta", potential)), [("1".to_owned(), "-".to_owned())]);
    // A slip in one display is one there.
    let ids = |found: Vec<(String, String)>| found.into_iter().map(|(id, _)| id).collect::<Vec<_>>();
    assert_eq!(ids(wrong("potential", &pendulum(height, r"m g \ell \cos\theta"))), ["2"]);
    assert_eq!(verdicts("causes-verdicts", &pendulum(height, potential))[3], "certified");
}
