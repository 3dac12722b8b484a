//! Systems as textbooks print them, with the Lagrangian or the Hamiltonian in the notes and a short claims file: each page passes, and a
//! slip beside it is still found.

use onshell::Code;
use onshell::check::{Document, Verdict};
use serde_json::{Value as Json, json};

use crate::prose_claims::{checked, claims, of, passes_and_finds};

/// Two coupled masses.
const PAIR: &str = r"$$ L = \frac12 m_1\dot x^2 + \frac12 m_2\dot y^2 - \frac12 k(x^2 + y^2) - \frac12 c(x - y)^2 \tag{1} $$
";

fn all_pass(found: &Document) -> bool {
    found.equations.iter().all(|equation| equation.ok)
}

/// Declares more constants, each with its range.
fn with_constants(mut claims: Json, more: &[(&str, &str)]) -> Json {
    for (names, range) in more {
        claims["constants"][*names] = json!(range);
    }
    claims
}

fn of_hamiltonian(coordinates: &Json, constants: &str) -> Json {
    json!({ "coordinates": coordinates, "constants": { constants: "> 0" }, "means": { "H": "Hamiltonian" } })
}

#[test]
fn energies_without_a_formula_are_left_out_of_the_lagrangian() {
    let claims = claims(&json!({ "x, y": "any" }), "m, g");
    let notes = r"$$ T = \frac12 m(\dot x^2 + \dot y^2) \tag{1} $$

$$ L = T - V = \frac12 m(\dot x^2 + \dot y^2) - m g y \tag{2} $$

$$ \ddot y = -g \tag{3} $$
";
    passes_and_finds(&claims, notes, &[("3", "-g", "-2g")]);
    // What a second statement of a display says is a formula too.
    let given = notes.replace(r"\dot y^2) \tag{1}", r"\dot y^2), \qquad V = m g y \tag{1}");
    assert!(all_pass(&checked(&claims, &given)));
    let found = checked(&claims, &given.replace(r"- m g y \tag{2}", r"- 2m g y \tag{2}"));
    assert_eq!(of(&found, "2").finding.verdict, Verdict::Refuted);
}

#[test]
fn the_first_display_of_the_lagrangian_is_the_system() {
    let claims = claims(&json!({ r"\theta": "angle" }), "m, g, a");
    let notes = r"With $V = m g y$, where

$$ y = a(1 - \cos\theta) \tag{1} $$

$$ T = \frac12 m a^2\dot\theta^2 \tag{2} $$

$$ L = T - V = \frac12 m a^2\dot\theta^2 - m g a(1 - \cos\theta) \tag{3} $$

$$ a\ddot\theta = -g\sin\theta \tag{4} $$

$$ s = a\theta \tag{5} $$

$$ L = \frac12 m\dot s^2 - m g a(1 - \cos\theta) \tag{6} $$
";
    assert!(all_pass(&checked(&claims, notes)));
    let found = checked(&claims, &notes.replace(r"\dot s^2 - m", r"\dot s^2 - 2m"));
    assert!(of(&found, "3").ok && of(&found, "4").ok);
    assert_eq!(of(&found, "6").finding.verdict, Verdict::Refuted);
}

#[test]
fn the_motion_of_a_name_with_a_formula() {
    let claims = claims(&json!({ "x": "any" }), "m, k, u_0");
    let notes = r"$$ L = \frac12 m\dot x^2 - \frac12 k x^2 \tag{1} $$

$$ u = x\sqrt m, \qquad p_x = \sqrt m\,\dot u \tag{2} $$

It is released from rest at $u = u_0$, and

$$ u(t) = u_0\cos\left(\sqrt{\frac km}\,t\right) \tag{3} $$
";
    passes_and_finds(&claims, notes, &[("3", r"\frac km", r"\frac mk")]);
}

#[test]
fn a_coordinate_by_the_time_and_a_conserved_momentum() {
    let claims = claims(&json!({ r"\phi": "angle", "z": "any" }), "m, R, g");
    let notes = r"$$ L = \frac12 m(R^2\dot\phi^2 + \dot z^2) - m g z \tag{1} $$

$$ \phi(t) = \phi_0 + \frac{p_\phi}{m R^2} t \tag{2} $$
";
    assert!(all_pass(&checked(&claims, notes)));
    let found = checked(&claims, &notes.replace(r"\frac{p_\phi}", r"\frac{2p_\phi}"));
    assert!(!of(&found, "2").ok);
    // The momentum of z is no constant.
    let found = checked(&claims, &format!("{notes}\n$$ z(t) = z_0 + \\frac{{p_z}}{{m}} t \\tag{{3}} $$\n"));
    assert!(!of(&found, "3").finding.verdict.passes());
}

#[test]
fn uniform_motion_by_the_equations_of_hamilton() {
    let claims = of_hamiltonian(&json!({ "x": "any" }), r"m, \alpha");
    let notes = r"$$ H = \frac{p^2}{2m} \tag{1} $$

$$ x(t) = x_0 + \frac{\alpha}{m} t \tag{2} $$
";
    assert!(all_pass(&checked(&claims, notes)));
    let found = checked(&claims, &notes.replace(r"\frac{\alpha}{m} t", r"\frac{\alpha}{m} t^2"));
    assert_eq!(of(&found, "2").finding.verdict, Verdict::Refuted);
}

#[test]
fn a_secular_equation_that_is_factored() {
    let claims = with_constants(claims(&json!({ "x, y": "any" }), r"m, k, c"), &[(r"\omega", "> 0")]);
    let notes = r"$$ L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k(x^2 + y^2) - \frac12 c(x - y)^2 \tag{1} $$

The secular equation is

$$ (k + c - m\omega^2)^2 - c^2 = 0 \tag{2} $$

or

$$ (k - m\omega^2)(k + 2c - m\omega^2) = 0 \tag{3} $$
";
    passes_and_finds(&claims, notes, &[("3", "k + 2c", "k + 3c"), ("2", "- c^2 = 0", "- 2c^2 = 0")]);
}

#[test]
fn frequencies_in_a_case() {
    let with = |constants: &str| claims(&json!({ "x, y": "any" }), constants);
    let named = format!(
        "{PAIR}
For equal masses, $m_1 = m_2 = m$, the normal frequencies are

$$ \\omega_1 = \\sqrt{{\\frac km}}, \\qquad \\omega_2 = \\sqrt{{\\frac{{k + 2c}}{{m}}}} \\tag{{2}} $$
"
    );
    passes_and_finds(&with("m, m_1, m_2, k, c"), &named, &[("2", "k + 2c", "k + c")]);
    let equal =
        named.replace("m_1 = m_2 = m$", "m_1 = m_2$").replace(r"\frac km", r"\frac k{m_1}").replace("{m}", "{m_1}");
    passes_and_finds(&with("m_1, m_2, k, c"), &equal, &[("2", "k + 2c", "k + c")]);
    // Without the words they are none.
    let found = checked(&with("m, m_1, m_2, k, c"), &named.replace("For equal masses, $m_1 = m_2 = m$, the", "The"));
    assert!(!of(&found, "2").finding.verdict.passes());
}

#[test]
fn a_frequency_that_is_declared_as_a_constant() {
    let claims = with_constants(
        claims(&json!({ r"\theta": r"(0, \pi)" }), r"m, g, R, \Omega, \omega"),
        &[(r"\theta_0", r"(0, \pi/2)")],
    );
    let notes = r"$$ L = \frac12 m R^2(\dot\theta^2 + \Omega^2\sin^2\theta) + m g R\cos\theta \tag{1} $$

There is an equilibrium at $\theta_0$ with

$$ \cos\theta_0 = \frac{g}{R\Omega^2} \tag{2} $$

The frequency of small oscillations about $\theta_0$ is

$$ \omega = \Omega\sin\theta_0 \tag{3} $$
";
    passes_and_finds(&claims, notes, &[("3", r"\Omega\sin\theta_0", r"\Omega\cos\theta_0")]);
}

#[test]
fn a_steady_motion_keeps_a_rate_at_zero() {
    let claims = claims(&json!({ r"\theta": r"(0, \pi)", r"\phi": "angle" }), "m, g, l");
    let notes = r"$$ L = \frac12 m l^2(\dot\theta^2 + \sin^2\theta\,\dot\phi^2) + m g l\cos\theta \tag{1} $$

In steady motion, $\dot\theta = 0$, the angular velocity is given by

$$ l\dot\phi^2\cos\theta = g \tag{2} $$
";
    passes_and_finds(&claims, notes, &[("2", r"\dot\phi^2\cos\theta", r"\dot\phi^2\sin\theta")]);
    let beside = notes.replace(r"In steady motion, $\dot\theta = 0$,", r"With $\dot\theta = 0$ and $\ddot\theta = 0$");
    assert!(all_pass(&checked(&claims, &beside)));
    // At an instant the acceleration need not vanish.
    let found = checked(&claims, &notes.replace("In steady motion", "At the highest point"));
    assert_eq!(of(&found, "2").finding.verdict, Verdict::Refuted);
}

#[test]
fn the_rate_on_a_circle_of_the_display_before() {
    let claims = claims(&json!({ "r": "> 0", r"\theta": "angle" }), "m, k, r_0");
    let notes = r"$$ L = \frac12 m(\dot r^2 + r^2\dot\theta^2) + \frac kr \tag{1} $$

$$ \ell = m r^2\dot\theta \tag{2} $$

The particle can move on a circle of radius $r_0$ if

$$ r_0 = \frac{\ell^2}{m k} \tag{3} $$

that is, with the angular velocity

$$ \dot\theta = \sqrt{\frac{k}{m r_0^3}} \tag{4} $$
";
    passes_and_finds(&claims, notes, &[("4", "m r_0^3", "m r_0^2")]);
}

#[test]
fn a_curvature_at_a_place() {
    let claims = claims(&json!({ r"\theta": "angle" }), "m, g, l");
    let notes = r"$$ L = \frac12 m l^2\dot\theta^2 - V \tag{1} $$

$$ V = -m g l\cos\theta \tag{2} $$

The upper position, $\theta = \pi$, is unstable, for

$$ \frac{d^2 V}{d\theta^2} = -m g l \tag{3} $$
";
    passes_and_finds(
        &claims,
        notes,
        &[("3", r"= -m g l \tag", r"= -2m g l \tag"), ("3", r"= -m g l \tag", r"= m g l \tag")],
    );
}

#[test]
fn where_a_force_vanishes() {
    let claims =
        with_constants(claims(&json!({ r"\theta": r"(0, \pi/2)" }), "m, g, R"), &[(r"\theta_0", r"(0, \pi/2)")]);
    let notes = r"$$ L = \frac12 m R^2\dot\theta^2 - m g R\cos\theta \tag{1} $$

A bead starts from rest at $\theta = \theta_0$. The force of the sphere is

$$ N = m g\cos\theta - m R\dot\theta^2 = m g(3\cos\theta - 2\cos\theta_0) \tag{2} $$

It leaves the sphere, $N = 0$, when

$$ \cos\theta = \frac23\cos\theta_0 \tag{3} $$
";
    passes_and_finds(&claims, notes, &[("3", r"\frac23", r"\frac13")]);
}

#[test]
fn a_start_at_the_end_of_a_range() {
    let claims = claims(&json!({ r"\theta": r"(0, \pi/2)" }), "m, g, R");
    let notes = r"$$ L = \frac12 m R^2\dot\theta^2 - m g R\cos\theta \tag{1} $$

A bead starts from rest at $\theta = 0$. Then

$$ R\dot\theta^2 = 2g(1 - \cos\theta) \tag{2} $$
";
    passes_and_finds(&claims, notes, &[("2", "= 2g", "= 3g")]);
}

#[test]
fn an_energy_of_constants_is_that_of_the_printed_motion() {
    let claims = claims(&json!({ "x, y": "any" }), "m, k");
    let notes = r"$$ L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k x^2 \tag{1} $$

$$ x(t) = A\cos\left(\sqrt{\frac km}\,t - \delta\right) \tag{2} $$

The energy is

$$ E = \frac{p_y^2}{2m} + \frac12 k A^2 \tag{3} $$
";
    passes_and_finds(&claims, notes, &[("3", r"\frac12 k A^2", "k A^2")]);
}

#[test]
fn a_lost_half_in_the_energy_of_a_solution() {
    let mut claims = claims(&json!({ "x": "any" }), "m, k");
    claims["means"]["E"] = json!("energy");
    let notes = r"$$ L = \frac12 m\dot x^2 - \frac12 k x^2 \tag{1} $$

$$ x(t) = A\cos\left(\sqrt{\frac km}\,t - \delta\right) \tag{2} $$

$$ E = k A^2 \tag{3} $$
";
    let found = checked(&claims, notes);
    assert_eq!(of(&found, "3").finding.verdict, Verdict::Refuted);
    assert!(of(&found, "3").repairs.iter().any(|repair| repair.replacement.trim() == r"\frac{1}{2} \,"));
}

#[test]
fn a_bracket_that_repeats_one_name_uses_the_others() {
    let claims = of_hamiltonian(&json!({ "x, y": "any" }), r"m, \omega");
    let notes = r"$$ H = \frac{p_x^2 + p_y^2}{2m} + \frac12 m\omega^2(x^2 + y^2) \tag{1} $$

$$ S_1 = \frac{1}{2m\omega}(p_x p_y + m^2\omega^2 x y) \tag{2} $$

$$ S_2 = \frac{1}{4m\omega}\left[p_y^2 - p_x^2 + m^2\omega^2(y^2 - x^2)\right] \tag{3} $$

$$ S_3 = \frac12(x p_y - y p_x) \tag{4} $$

$$ \{S_1, S_2\} = S_3, \qquad \{S_2, S_3\} = S_1, \qquad \{S_3, S_1\} = S_2 \tag{5} $$
";
    let found = checked(&claims, notes);
    assert!(found.equations.iter().all(|equation| equation.finding.verdict.passes()), "{:#?}", found.equations);
    assert!(!all_pass(&checked(&claims, &notes.replace(r"\frac{1}{4m\omega}", r"\frac{1}{2m\omega}"))));
}

#[test]
fn derivatives_with_a_root_use_a_name() {
    let claims = of_hamiltonian(&json!({ "x": "any" }), "m, g, E");
    let notes = r"$$ H = \frac{p^2}{2m} + m g x \tag{1} $$

$$ S = -E t - \frac{1}{3m^2 g}\left(2m E - 2m^2 g x\right)^{3/2} \tag{2} $$

$$ \frac{\partial S}{\partial E} = -t - \frac{1}{m g}\sqrt{2m E - 2m^2 g x} \tag{3} $$
";
    let found = checked(&claims, notes);
    assert!(all_pass(&found));
    assert_ne!(of(&found, "2").finding.code, Code::DefinitionUnused);
    let found = checked(&claims, &notes.replace(r"\frac{1}{m g}", r"\frac{2}{m g}"));
    assert_eq!(of(&found, "3").finding.verdict, Verdict::Refuted);
}
