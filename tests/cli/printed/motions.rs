//! Printed motions: solutions x(t), their rates and energies, orbits, and motions under friction and other forces. What
//! follows from the Lagrangian in the notes passes, and the same line with a slip is refuted.

use serde_json::{Value, json};

use crate::printed_lagrangian::{are, verdicts};
use crate::support::Desk;

const OSCILLATOR: (&str, &str) = (r"L = \frac12 m\dot x^2 - \frac12 k x^2", "definition");

fn oscillator() -> Value {
    json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k, A": "> 0", "\\phi": "angle" },
        "means": { "L": "Lagrangian", "E": "energy" },
    })
}

#[test]
fn a_solution_its_rate_and_its_energy_follow() {
    are(
        "solution",
        &oscillator(),
        &[
            OSCILLATOR,
            (r"\omega = \sqrt{\frac{k}{m}}", "definition"),
            (r"x(t) = A\cos(\omega t + \phi)", "passes"),
            (r"\dot x(t) = -A\omega\sin(\omega t + \phi)", "passes"),
            (r"E = \frac12 k A^2", "passes"),
            (r"E = \frac12 m \omega^2 A^2", "passes"),
        ],
    );
}

#[test]
fn a_slip_in_a_solution_is_refuted() {
    let omega = (r"\omega = \sqrt{\frac{k}{m}}", "definition");
    let solution = (r"x(t) = A\cos(\omega t + \phi)", "passes");
    for (name, latex) in [
        ("lost-rate", r"x(t) = A\cos(t + \phi)"),
        ("squared", r"x(t) = A\cos(\omega^2 t + \phi)"),
        ("growing", r"x(t) = A t\cos(\omega t + \phi)"),
    ] {
        let found = verdicts(&format!("solution-{name}"), oscillator(), &[OSCILLATOR.0, omega.0, latex]);
        assert_eq!(found[2], "refuted", "{latex}");
    }
    for (name, latex) in [
        ("sign", r"\dot x(t) = A\omega\sin(\omega t + \phi)"),
        ("factor", r"\dot x(t) = -A\sin(\omega t + \phi)"),
        ("energy", r"E = k A^2"),
    ] {
        let displays = [OSCILLATOR.0, omega.0, solution.0, latex];
        assert_eq!(verdicts(&format!("solution-{name}"), oscillator(), &displays)[3], "refuted", "{latex}");
    }
}

#[test]
fn solutions_of_several_coordinates_are_put_in_together() {
    let claims = json!({
        "coordinates": { "x_1, x_2": "any" },
        "constants": { "m, k, \\kappa, A, B": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = \frac12 m(\dot x_1^2+\dot x_2^2) - \frac12 k(x_1^2+x_2^2) - \frac12\kappa(x_1-x_2)^2";
    let both = |fast: &str| {
        let (slow, beat) =
            (r"A\cos\left(\sqrt{\frac{k}{m}}\, t\right)", r"B\cos\left(\sqrt{\frac{k+2\kappa}{m}}\, t\right)");
        format!(r"x_1 = {slow} + {beat}, \quad x_2 = {slow} {fast} {beat}")
    };
    let right = verdicts("modes", claims.clone(), &[lagrangian, &both("-")]);
    assert_eq!(right[1], "verified", "{right:?}");
    assert_eq!(verdicts("modes-sign", claims, &[lagrangian, &both("+")])[1], "refuted");
}

#[test]
fn a_solution_for_small_angles_solves_the_first_order() {
    let claims = json!({
        "coordinates": { "\\theta": "angle" },
        "constants": { "m, g, l": "> 0", "\\theta_0": "(0, 0.5)" },
        "means": { "L": "Lagrangian" },
    });
    let pendulum = (r"L = \frac12 m l^2 \dot\theta^2 + m g l\cos\theta", "definition");
    are(
        "small-solution",
        &claims,
        &[
            pendulum,
            (r"\omega = \sqrt{\frac{g}{l}}", "definition"),
            (r"\ddot\theta \approx -\omega^2\theta", "passes"),
            (r"\theta(t) = \theta_0\cos\omega t", "passes"),
        ],
    );
    let wrong = verdicts("small-wrong", claims, &[pendulum.0, r"\theta(t) = \theta_0\cos\left(\frac{g}{l} t\right)"]);
    assert_eq!(wrong[1], "refuted");
}

#[test]
fn an_orbit_and_an_effective_potential_hold_the_conserved_momentum_fixed() {
    let claims = json!({
        "coordinates": { "r": "> 0", "\\phi": "angle" },
        "constants": { "m, k": "> 0", "e": "(0, 1)" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = (r"L = \frac12 m(\dot r^2 + r^2\dot\phi^2) + \frac{k}{r}", "definition");
    let momentum = (r"\ell = m r^2\dot\phi = \text{const}", "passes");
    are(
        "orbit",
        &claims,
        &[
            lagrangian,
            momentum,
            (r"r = \frac{\ell^2}{m k(1+e\cos\phi)}", "passes"),
            (r"p = \frac{\ell^2}{m k}", "definition"),
            (r"r(\phi) = \frac{p}{1+e\cos\phi}", "passes"),
            (r"V_{\mathrm{eff}} = \frac{\ell^2}{2 m r^2} - \frac{k}{r}", "passes"),
            (r"m\ddot r = -\frac{dV_{\mathrm{eff}}}{dr}", "passes"),
        ],
    );
    let slips = [
        lagrangian.0,
        momentum.0,
        r"r = \frac{\ell^2}{m k(2+e\cos\phi)}",
        r"V_{\mathrm{eff}} = \frac{\ell^2}{2 m r^2} - \frac{k}{r}",
        r"m\ddot r = \frac{dV_{\mathrm{eff}}}{dr}",
    ];
    let found = verdicts("orbit-slips", claims, &slips);
    assert_eq!((found[2].as_str(), found[4].as_str()), ("refuted", "refuted"));
}

#[test]
fn a_printed_h_with_momenta_is_the_hamiltonian() {
    let claims = json!({
        "coordinates": { "\\theta": "angle" }, "constants": { "m, g, l": "> 0" }, "means": { "L": "Lagrangian" }
    });
    let lagrangian = (r"L = \frac12 m l^2 \dot\theta^2 + m g l\cos\theta", "definition");
    are(
        "hamiltonian",
        &claims,
        &[
            lagrangian,
            (r"H = \frac{p_\theta^2}{2 m l^2} - m g l\cos\theta", "passes"),
            (r"\dot p_\theta = -\frac{\partial H}{\partial\theta}", "passes"),
        ],
    );
    are("hamiltonian-slip", &claims, &[lagrangian, (r"H = \frac{p_\theta^2}{2 m l^2} + m g l\cos\theta", "refuted")]);
}

#[test]
fn friction_and_forces_act_beside_the_lagrangian() {
    let mut claims = oscillator();
    claims["constants"] = json!({ "m, k, b, f_0, \\Omega": "> 0" });
    claims["dissipation"] = json!("\\mathcal F");
    claims["forces"] = json!({ "x": "f_0\\cos\\Omega t" });
    are(
        "friction",
        &claims,
        &[
            OSCILLATOR,
            (r"\mathcal F = \frac12 b\dot x^2", "definition"),
            (
                r"\frac{d}{dt}\frac{\partial L}{\partial\dot x} - \frac{\partial L}{\partial x} + \frac{\partial\mathcal F}{\partial\dot x} = f_0\cos\Omega t",
                "passes",
            ),
            (r"m\ddot x + b\dot x + k x = f_0\cos\Omega t", "passes"),
            (r"\frac{dE}{dt} = -2\mathcal F + f_0\dot x\cos\Omega t", "passes"),
            (r"m\ddot x - b\dot x + k x = f_0\cos\Omega t", "refuted"),
            (r"m\ddot x + 2 b\dot x + k x = f_0\cos\Omega t", "refuted"),
            (r"\frac{dE}{dt} = -\mathcal F + f_0\dot x\cos\Omega t", "refuted"),
            (r"\frac{d}{dt}\frac{\partial L}{\partial\dot x} = \frac{\partial L}{\partial x}", "refuted"),
        ],
    );
}

#[test]
fn a_force_has_the_name_of_a_coordinate() {
    for (name, key, value, words) in [
        ("unknown", "forces", json!({ "y": "1" }), "y is not a coordinate"),
        ("accelerated", "forces", json!({ "x": "\\ddot x" }), "a force contains accelerations"),
        ("none", "dissipation", json!("\\mathcal F"), "is not declared"),
    ] {
        let desk = Desk::new(&format!("force-{name}"));
        let mut claims = oscillator();
        (claims["notes"], claims[key]) = (json!("notes.md"), value);
        desk.write("notes.md", format!("$$ {} \\tag{{1}} $$\n", OSCILLATOR.0));
        desk.write("notes.json", format!("{claims:#}"));
        let run = desk.onshell(&["check", "notes.md"]);
        let said = run.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(run.code == 2 && said.contains(words), "{name}: {said}");
    }
}

#[test]
fn a_projectile_has_solutions_and_a_path() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "constants": { "m, g, v_0": "> 0", "\\alpha": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian" },
    });
    let with = |name: &str, height: &str, path: &str| {
        let lagrangian = r"L = \frac12 m(\dot x^2 + \dot y^2) - m g y";
        verdicts(name, claims.clone(), &[lagrangian, r"x(t) = v_0 t\cos\alpha", height, path])
    };
    let height = r"y(t) = v_0 t\sin\alpha - \frac12 g t^2";
    let path = r"y = x\tan\alpha - \frac{g x^2}{2 v_0^2\cos^2\alpha}";
    let passes = |verdict: &String| verdict == "certified" || verdict == "verified";
    let right = with("projectile", height, path);
    assert!(right[1..].iter().all(passes), "{right:?}");
    let wrong = with("projectile-factor", r"y(t) = v_0 t\sin\alpha - g t^2", path);
    // The path is right, so the mistake in a solution must not be blamed on it.
    assert_eq!((wrong[2].as_str(), wrong[3].as_str()), ("refuted", "undecided"));
    assert_eq!(with("projectile-path", height, r"y = x\tan\alpha - \frac{g x^2}{v_0^2\cos^2\alpha}")[3], "refuted");
}
