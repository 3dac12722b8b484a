//! The Lagrangian in the notes, functions of one's own, and derivatives by a symbol: what follows is certified, and the
//! same line with a slip is refuted.

use serde_json::{Value, json};

use crate::support::Desk;

/// The verdict on each equation of these displays, with a number for each.
pub(crate) fn verdicts(name: &str, claims: Value, displays: &[&str]) -> Vec<String> {
    let desk = Desk::new(&format!("printed-{name}"));
    let numbered = displays.iter().enumerate().map(|(at, latex)| format!("$$ {latex} \\tag{{{}}} $$\n\n", at + 1));
    desk.write("notes.md", numbered.collect::<String>());
    let mut claims = claims;
    claims["notes"] = json!("notes.md");
    desk.write("notes.json", format!("{claims:#}"));
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list").clone();
    equations.iter().map(|equation| equation["verdict"].as_str().expect("a word").to_owned()).collect()
}

/// Checks the displays of `notes`, each followed by its verdict; `passes` is certified or verified.
pub(crate) fn are(name: &str, claims: &Value, notes: &[(&str, &str)]) {
    let displays: Vec<&str> = notes.iter().map(|(latex, _)| *latex).collect();
    let found = verdicts(name, claims.clone(), &displays);
    for ((latex, wanted), found) in notes.iter().zip(&found) {
        let passes = *wanted == "passes" && ["certified", "verified"].contains(&found.as_str());
        assert!(passes || found == wanted, "{name}: {latex} is {found}, not {wanted}");
    }
    assert_eq!(found.len(), notes.len());
}

fn pendulum() -> Value {
    json!({ "coordinates": { "\\theta": "angle" }, "constants": { "m, g, l": "> 0" }, "means": { "L": "Lagrangian" } })
}

const PENDULUM: (&str, &str) = (r"L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta", "definition");

#[test]
fn what_a_physicist_writes_of_a_pendulum_follows_from_its_lagrangian() {
    are(
        "pendulum",
        &pendulum(),
        &[
            PENDULUM,
            (r"\frac{d}{dt}\frac{\partial L}{\partial \dot\theta} = \frac{\partial L}{\partial\theta}", "certified"),
            (
                r"\frac{d}{dt}\left(\frac{\partial L}{\partial \dot\theta}\right) - \frac{\partial L}{\partial\theta} = 0",
                "certified",
            ),
            (r"p_\theta = \frac{\partial L}{\partial \dot\theta} = m l^2 \dot\theta", "certified"),
            (r"H = p_\theta \dot\theta - L = \frac{p_\theta^2}{2 m l^2} - m g l\cos\theta", "certified"),
            (
                r"\dot\theta = \frac{\partial H}{\partial p_\theta}, \qquad \dot p_\theta = -\frac{\partial H}{\partial \theta}",
                "certified",
            ),
            (r"\ddot\theta = -\frac{g}{l}\sin\theta", "certified"),
            (r"\ddot\theta \approx -\frac{g}{l}\theta", "verified"),
        ],
    );
}

#[test]
fn a_slip_beside_the_lagrangian_is_refuted() {
    are(
        "slips",
        &pendulum(),
        &[
            PENDULUM,
            (r"\frac{d}{dt}\frac{\partial L}{\partial \dot\theta} = -\frac{\partial L}{\partial\theta}", "refuted"),
            (r"\frac{d}{dt}\frac{\partial L}{\partial \theta} = \frac{\partial L}{\partial\theta}", "refuted"),
            (r"\frac{\partial L}{\partial \dot\theta} = m l \dot\theta", "refuted"),
            (r"\ddot\theta = \frac{g}{l}\sin\theta", "refuted"),
            (r"\ddot\theta = -\frac{g}{l}\theta", "refuted"),
        ],
    );
}

#[test]
fn a_small_angle_is_inferred_only_where_the_equation_holds_for_it() {
    let found = verdicts("small", pendulum(), &[PENDULUM.0, r"\ddot\theta \approx -\frac{2g}{l}\theta"]);
    assert!(!["certified", "verified"].contains(&found[1].as_str()), "{found:?}");
}

#[test]
fn energies_and_positions_of_other_displays_are_inserted() {
    let claims = json!({
        "coordinates": { "\\theta_1, \\theta_2": "angle" },
        "constants": { "m, g, l": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let definition = "definition";
    are(
        "double",
        &claims,
        &[
            (r"x_1 = l\sin\theta_1,\quad y_1 = -l\cos\theta_1", definition),
            (r"x_2 = x_1 + l\sin\theta_2,\quad y_2 = y_1 - l\cos\theta_2", definition),
            (
                r"T = \frac12 m(\dot x_1^2 + \dot y_1^2 + \dot x_2^2 + \dot y_2^2),\qquad V = m g (y_1 + y_2)",
                definition,
            ),
            (r"L = T - V", definition),
            (
                r"\frac{\partial T}{\partial\dot\theta_1} = 2 m l^2\dot\theta_1 + m l^2 \dot\theta_2\cos(\theta_1-\theta_2)",
                "certified",
            ),
            (
                r"\frac{\partial T}{\partial\theta_1} = - m l^2 \dot\theta_1 \dot\theta_2\sin(\theta_1-\theta_2)",
                "certified",
            ),
            (
                r"\frac{\partial T}{\partial\theta_1} = m l^2 \dot\theta_1 \dot\theta_2\sin(\theta_1-\theta_2)",
                "refuted",
            ),
            (
                r"2\ddot\theta_1 + \ddot\theta_2\cos(\theta_1-\theta_2) + \dot\theta_2^2\sin(\theta_1-\theta_2) + \frac{2g}{l}\sin\theta_1 = 0",
                "certified",
            ),
            (
                r"\ddot\theta_2 + \ddot\theta_1\cos(\theta_1-\theta_2) - \dot\theta_1^2\sin(\theta_1-\theta_2) + \frac{g}{l}\sin\theta_2 = 0",
                "certified",
            ),
            (
                r"\ddot\theta_2 + \ddot\theta_1\cos(\theta_1-\theta_2) + \dot\theta_1^2\sin(\theta_1-\theta_2) + \frac{g}{l}\sin\theta_2 = 0",
                "refuted",
            ),
        ],
    );
}

#[test]
fn an_arbitrary_potential_has_derivatives() {
    let claims = json!({
        "coordinates": { "r": "> 0", "\\phi": "angle" },
        "constants": { "m": "> 0" },
        "functions": { "V": "of r" },
        "means": { "L": "Lagrangian", "E": "energy" },
    });
    are(
        "central",
        &claims,
        &[
            (r"L = \frac12 m (\dot r^2 + r^2\dot\phi^2) - V(r)", "definition"),
            (r"m \ddot r = m r\dot\phi^2 - V'(r)", "certified"),
            (r"m \ddot r = m r\dot\phi^2 - \frac{dV}{dr}", "certified"),
            (r"m \ddot r = m r\dot\phi^2 + V'(r)", "refuted"),
            (r"m \ddot r = m r\dot\phi^2 - V(r)", "refuted"),
            (r"m \ddot r = m r\dot\phi^2 - V''(r)", "refuted"),
            (r"p_\phi = m r^2 \dot\phi = \text{const}", "certified"),
            (r"E = \frac12 m \dot r^2 + \frac{p_\phi^2}{2 m r^2} + V(r)", "certified"),
            (r"\frac{d}{dt} V(r) = V'(r) \dot r", "certified"),
            (r"\frac{\partial L}{\partial\phi} = 0", "certified"),
            (r"\frac{\partial L}{\partial r} = 0", "refuted"),
            (r"V(2 r) = 2 V(r)", "refuted"),
            (r"V(r)^2 - V(2r)^2 = (V(r) - V(2r))(V(r) + V(2r))", "certified"),
            (r"m\dddot r = -\frac{3p_\phi^2 \dot r}{m r^4} - V''(r)\dot r", "certified"),
        ],
    );
}

#[test]
fn a_charge_in_any_potentials_feels_the_force_of_lorentz() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "constants": { "m, q": "> 0" },
        "functions": { "\\Phi, A_x, A_y": "of x, y" },
        "means": { "L": "Lagrangian" },
    });
    are(
        "charge",
        &claims,
        &[
            (r"L = \frac12 m (\dot x^2 + \dot y^2) - q \Phi(x, y) + q(\dot x A_x + \dot y A_y)", "definition"),
            (r"p_x = m \dot x + q A_x(x, y)", "certified"),
            (
                r"m\ddot x = -q\frac{\partial\Phi}{\partial x} + q \dot y\left(\frac{\partial A_y}{\partial x} - \frac{\partial A_x}{\partial y}\right)",
                "certified",
            ),
            (
                r"m\ddot x = -q\frac{\partial\Phi}{\partial x} + q \dot y\left(\frac{\partial A_y}{\partial x} + \frac{\partial A_x}{\partial y}\right)",
                "refuted",
            ),
        ],
    );
}

#[test]
fn a_force_that_depends_on_the_time_and_a_function_that_the_notes_define() {
    let claims = json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k, a": "> 0", "\\lambda": "any" },
        "functions": { "F": "of t" },
        "means": { "L": "Lagrangian", "H": "Hamiltonian" },
    });
    are(
        "driven",
        &claims,
        &[
            (r"V(x) = \frac12 k x^2 + \frac14 \lambda x^4", "definition"),
            (r"L = \frac12 m \dot x^2 - V(x) + x F(t)", "definition"),
            (r"m\ddot x = -V'(x) + F(t) = -k x - \lambda x^3 + F(t)", "certified"),
            (r"V'(a) = k a + \lambda a^3", "certified"),
            (r"V'(a) = k a + \lambda a^2", "refuted"),
            (r"\frac{d^2 V}{dx^2} = k + 3\lambda x^2", "certified"),
            (r"\frac{dH}{dt} = -x \dot F", "certified"),
            (r"\frac{dH}{dt} = x \dot F", "refuted"),
            (r"\frac{\partial L}{\partial t} = x F'(t)", "certified"),
        ],
    );
}

#[test]
fn what_is_no_lagrangian_is_refused_with_its_place_and_advice() {
    for (name, latex, claims, words) in [
        ("none", "a = b", json!({}), &["no display that can be read defines L", "write a display L ="][..]),
        ("unread", r"L = \frac12 m \dot\theta^2 + \nabla", json!({}), &["the Lagrangian L could not be read"]),
        (
            "free",
            r"L = \frac12 m \dot\theta^2 + f",
            json!({ "varies with time": { "f": "any" } }),
            &["nothing says how f varies with time", "of t"],
        ),
        ("circle", r"L = \frac12 p_\theta^2", json!({}), &["L contains p_θ, which is itself derived from L"]),
    ] {
        let mut all = pendulum();
        all["constants"] = json!({ "m, g, l, a, b": "> 0" });
        all["notes"] = json!("notes.md");
        for (key, value) in claims.as_object().expect("an object") {
            all[key] = value.clone();
        }
        let desk = Desk::new(&format!("printed-refused-{name}"));
        desk.write("notes.md", format!("$$ {latex} \\tag{{1}} $$\n"));
        desk.write("notes.json", format!("{all:#}"));
        let run = desk.onshell(&["check", "notes.md"]);
        let said = run.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(run.code, 2, "{name}: {}{}", run.out, run.err);
        for word in words {
            assert!(said.contains(word), "{name}: no “{word}” in {said}");
        }
    }
}
