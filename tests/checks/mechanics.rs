//! Mechanics as textbooks print it: each claim passes, and with a slip it does not.

use onshell::check::Verdict::{self, Definition, Refuted, Unreadable, Verified};
use serde_json::{Value as Json, json};

use crate::support::{verdict, with};

/// A mass on a spring, by a Lagrangian in the notes.
fn spring() -> Json {
    json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian" },
    })
}

const SPRING: &str = r"L = \frac12 m\dot x^2 - \frac12 k x^2";

/// The verdict on a display after others.
fn after(claims: &Json, before: &[&str], latex: &str) -> Verdict {
    verdict(claims, &[before, &[latex]].concat(), json!({}))
}

/// Every right display passes after the others, and every wrong one is refuted.
fn all(claims: &Json, before: &[&str], pairs: &[(&str, &str)]) {
    for (right, wrong) in pairs {
        assert_eq!(after(claims, before, right), Verified, "{right}");
        assert_eq!(after(claims, before, wrong), Refuted, "{wrong}");
    }
}

#[test]
fn poisson_brackets_of_a_lagrangian_in_the_notes() {
    let before = [SPRING, r"H = \frac{p^2}{2m} + \frac12 k x^2"];
    all(
        &spring(),
        &before,
        &[
            (r"\{x, p\} = 1", r"\{p, x\} = 1"),
            (r"\{x^2, p\} = 2x", r"\{x^2, p\} = x"),
            (r"\left\{ x, p \right\} = 1", r"\left\{ x, p \right\} = 0"),
            (r"\dot x = \{x, H\} = \frac{p}{m}", r"\dot x = \{H, x\} = \frac{p}{m}"),
            (r"\dot p = \{p, H\}", r"\dot p = \{H, p\}"),
            (r"\{H, x p\} = k x^2 - \frac{p^2}{m}", r"\{H, x p\} = k x^2 + \frac{p^2}{m}"),
            (r"[x, H]_{x, p} = \frac pm", r"[x, H]_{p, x} = \frac pm"),
            (r"\{x, H\}_{\mathrm{PB}} = \frac pm", r"\{x, H\}_{\mathrm{PB}} = \frac{2p}{m}"),
        ],
    );
}

#[test]
fn poisson_brackets_of_angular_momenta() {
    let claims = json!({
        "coordinates": { "x, y, z": "any" },
        "constants": { "m": "> 0" },
        "functions": { "V": "of r" },
        "means": { "L": "Lagrangian" },
    });
    let before = [
        r"L = \frac12 m(\dot x^2 + \dot y^2 + \dot z^2) - V(r)",
        r"r = \sqrt{x^2 + y^2 + z^2}",
        r"\ell_x = y p_z - z p_y, \quad \ell_y = z p_x - x p_z, \quad \ell_z = x p_y - y p_x",
        r"H = \frac{p_x^2 + p_y^2 + p_z^2}{2m} + V(r)",
    ];
    all(
        &claims,
        &before,
        &[
            (r"\{\ell_x, \ell_y\} = \ell_z", r"\{\ell_x, \ell_y\} = -\ell_z"),
            (r"\{\ell_z, p_x\} = p_y", r"\{\ell_z, p_x\} = p_x"),
            (r"\{\ell_z, H\} = 0", r"\{\ell_z + x, H\} = 0"),
            (r"\{\ell_x^2 + \ell_y^2 + \ell_z^2, \ell_x\} = 0", r"\{\ell_x^2 + \ell_y^2 - \ell_z^2, \ell_x\} = 0"),
        ],
    );
}

#[test]
fn a_canonical_transformation_needs_no_lagrangian() {
    let claims = json!({ "constants": { r"\omega, m": "> 0" }, "varies with time": { "q, p": "any" } });
    let before = [r"Q = \arctan\frac{m\omega q}{p}", r"P = \frac{1}{2\omega m}(p^2 + m^2\omega^2 q^2)"];
    all(
        &claims,
        &before,
        &[
            (r"\{Q, P\} = 1", r"\{P, Q\} = 1"),
            (r"\{Q, P\}_{q,p} = 1", r"\{Q, P\}_{q,p} = 2"),
            (r"[Q, P]_{q,p} = 1", r"[Q, P]_{q,p} = -1"),
            (r"\{Q, P^2\} = 2P", r"\{Q, P^2\} = P"),
        ],
    );
    let wrong = [r"Q = \arctan\frac{m\omega q}{p}", r"P = \frac{1}{2m}(p^2 + m^2\omega^2 q^2)"];
    assert_eq!(after(&claims, &wrong, r"\{Q, P\} = 1"), Refuted);
}

#[test]
fn a_bracket_that_nothing_explains_is_not_read() {
    let claims = json!({ "varies with time": { "x, y": "any" } });
    assert_eq!(after(&claims, &[], r"\{x, y\} = 1"), Unreadable);
    // A rate is no function of coordinates and momenta.
    assert_eq!(after(&spring(), &[SPRING], r"\{x, \dot x\} = \frac1m"), Unreadable);
}

#[test]
fn a_momentum_that_a_display_defines_is_that_momentum() {
    let before = [SPRING, r"p = \frac{\partial L}{\partial \dot x} = m\dot x"];
    assert_eq!(after(&spring(), &before, r"\{x, p\} = 1"), Verified);
    assert_eq!(after(&spring(), &before, r"\dot p = -k x"), Verified);
}

#[test]
fn the_constants_of_a_solution_need_no_declaration() {
    let before = [SPRING, r"\omega = \sqrt{\frac km}"];
    all(
        &spring(),
        &before,
        &[
            (r"x(t) = A\cos\omega t + B\sin\omega t", r"x(t) = A\cos\omega t + B\sin 2\omega t"),
            (r"x(t) = x_0\cos(\omega t + \delta)", r"x(t) = x_0\cos(\omega t + \delta) + \delta"),
            (r"x(t) = A\cos(\omega(t - t_0))", r"x(t) = A\cosh(\omega(t - t_0))"),
        ],
    );
    // What stands beside the time decides whether it is a solution.
    assert_eq!(after(&spring(), &before, r"x(t) = A\cos\Omega t"), Unreadable);
    assert_eq!(after(&spring(), &before, r"x(t) = A e^{-t/\tau}"), Unreadable);
    // Any other name must still be declared.
    assert_eq!(after(&spring(), &before, r"\ddot x = -\omega_0^2 x"), Unreadable);
}

#[test]
fn a_function_of_a_name_that_a_display_defines() {
    let claims = with(&spring(), "functions", json!({ "V": "of r" }));
    let claims = with(&claims, "coordinates", json!({ "x, y": "any" }));
    let before = [r"L = \frac12 m(\dot x^2 + \dot y^2) - V(r)", r"r = \sqrt{x^2 + y^2}"];
    all(&claims, &before, &[(r"m\ddot x = -V'(r)\frac xr", r"m\ddot x = -V'(r)\frac yr")]);
    assert_eq!(verdict(&claims, &before, json!({})), Definition);
}

#[test]
fn a_hamiltonian_in_the_notes_is_the_system() {
    let claims = json!({
        "coordinates": { "r": "> 0", r"\phi": "angle" },
        "constants": { "m": "> 0" },
        "functions": { "V": "of r" },
        "means": { "H": "Hamiltonian" },
    });
    let before = [r"H = \frac{p_r^2}{2m} + \frac{p_\phi^2}{2m r^2} + V(r)"];
    assert_eq!(verdict(&claims, &before, json!({})), Definition);
    all(
        &claims,
        &before,
        &[
            (
                r"\dot r = \frac{\partial H}{\partial p_r} = \frac{p_r}{m}",
                r"\dot r = \frac{\partial H}{\partial p_r} = p_r",
            ),
            (r"\dot p_r = -\frac{\partial H}{\partial r}", r"\dot p_r = \frac{\partial H}{\partial r}"),
            (r"\dot p_r = \frac{p_\phi^2}{m r^3} - V'(r)", r"\dot p_r = \frac{p_\phi^2}{m r^2} - V'(r)"),
            (r"\dot p_\phi = 0", r"\dot p_r = 0"),
            (r"\frac{dH}{dt} = 0", r"\frac{dV}{dt} = 0"),
            (r"m\ddot r = m r\dot\phi^2 - V'(r)", r"m\ddot r = m r\dot\phi - V'(r)"),
            (r"\{r, H\} = \dot r", r"\{r, H\} = \dot\phi"),
        ],
    );
}

#[test]
fn a_hamiltonian_that_is_not_quadratic_in_its_momentum() {
    let claims = json!({
        "coordinates": { "q": "any" },
        "constants": { "m, c, k": "> 0" },
        "means": { "H": "Hamiltonian" },
    });
    let before = [r"H = \sqrt{p^2 c^2 + m^2 c^4} + \frac12 k q^2"];
    all(
        &claims,
        &before,
        &[
            (r"\dot q = \frac{p c^2}{\sqrt{p^2 c^2 + m^2 c^4}}", r"\dot q = \frac{p c}{\sqrt{p^2 c^2 + m^2 c^4}}"),
            (r"\dot p = -k q", r"\dot p = k q"),
        ],
    );
    // One with velocities is none.
    let wrong =
        crate::support::error(&claims, &[r"H = \frac12 m\dot q^2 + \frac12 k q^2", r"\dot p = -k q"], json!({}));
    assert!(wrong.contains("contains velocities"), "{wrong}");
}

#[test]
fn solutions_of_hamiltons_equations() {
    let claims =
        json!({ "coordinates": { "q": "any" }, "constants": { "m, k": "> 0" }, "means": { "H": "Hamiltonian" } });
    let before = [r"H = \frac{p^2}{2m} + \frac12 k q^2"];
    all(
        &claims,
        &before,
        &[(
            r"q(t) = A\cos\left(\sqrt{\frac km}\,t + \delta\right)",
            r"q(t) = A\cos\left(\sqrt{\frac{k}{2m}}\,t + \delta\right)",
        )],
    );
}

#[test]
fn lagrangians_that_do_not_give_all_accelerations() {
    let claims = |coordinates: &str| {
        json!({
            "coordinates": { coordinates: "any" },
            "constants": { "a, b, m, k": "> 0" },
            "means": { "L": "Lagrangian" },
        })
    };
    // y has no velocity in it.
    all(
        &claims("x, y"),
        &[r"L = \frac12 m\dot x^2 + x y - \frac12 k y^2"],
        &[
            (r"x = k y", r"x = -k y"),
            (r"m\ddot x = \frac xk", r"m\ddot x = -\frac xk"),
            (
                r"\frac{d}{dt}\frac{\partial L}{\partial\dot x} = \frac{\partial L}{\partial x}",
                r"\frac{d}{dt}\frac{\partial L}{\partial\dot x} = \frac{\partial L}{\partial y} + k y",
            ),
        ],
    );
    // It is linear in the velocities.
    all(
        &claims("x, y"),
        &[r"L = \frac12 b(x\dot y - y\dot x) - \frac12 k(x^2 + y^2)"],
        &[
            (r"b\dot y = k x", r"b\dot y = -k x"),
            (r"b\dot x = -k y", r"b\dot x = -2 k y"),
            (r"\ddot x = -\frac{k^2}{b^2} x", r"\ddot x = -\frac{k}{b} x"),
            (r"p_x = -\frac12 b y", r"p_x = \frac12 b y"),
        ],
    );
    // It contains accelerations.
    all(
        &claims("x"),
        &[r"L = \frac12 a\ddot x^2 + \frac12 m\dot x^2 - \frac12 k x^2"],
        &[
            (
                r"\frac{\partial L}{\partial x} - \frac{d}{dt}\frac{\partial L}{\partial\dot x} + \frac{d^2}{dt^2}\frac{\partial L}{\partial\ddot x} = 0",
                r"\frac{\partial L}{\partial x} - \frac{d}{dt}\frac{\partial L}{\partial\dot x} - \frac{d^2}{dt^2}\frac{\partial L}{\partial\ddot x} = 0",
            ),
            (r"a\frac{d^4 x}{dt^4} = m\ddot x + k x", r"a\frac{d^4 x}{dt^4} = m\ddot x - k x"),
        ],
    );
}

#[test]
fn the_equations_of_a_routhian() {
    let claims = json!({
        "coordinates": { "r": "> 0", r"\phi": "angle" },
        "constants": { "m": "> 0" },
        "functions": { "V": "of r" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = \frac12 m(\dot r^2 + r^2\dot\phi^2) - V(r)";
    let routhian = r"R = L - p_\phi\dot\phi = \frac12 m\dot r^2 - \frac{p_\phi^2}{2m r^2} - V(r)";
    all(
        &claims,
        &[lagrangian, routhian],
        &[
            (
                r"\frac{d}{dt}\frac{\partial R}{\partial\dot r} - \frac{\partial R}{\partial r} = 0",
                r"\frac{d}{dt}\frac{\partial R}{\partial\dot r} + \frac{\partial R}{\partial r} = 0",
            ),
            (r"\dot\phi = -\frac{\partial R}{\partial p_\phi}", r"\dot\phi = \frac{\partial R}{\partial p_\phi}"),
        ],
    );
    let wrong = r"R = L - p_\phi\dot\phi = \frac12 m\dot r^2 + \frac{p_\phi^2}{2m r^2} - V(r)";
    assert_eq!(after(&claims, &[lagrangian], wrong), Refuted);
    // A momentum with a letter of its own stays fixed too.
    let named = [
        lagrangian,
        r"\ell = \frac{\partial L}{\partial\dot\phi} = m r^2\dot\phi",
        r"R = \frac12 m\dot r^2 - \frac{\ell^2}{2m r^2} - V(r)",
    ];
    all(
        &claims,
        &named,
        &[(
            r"\frac{d}{dt}\frac{\partial R}{\partial\dot r} = \frac{\partial R}{\partial r}",
            r"\frac{d}{dt}\frac{\partial R}{\partial\dot r} = -\frac{\partial R}{\partial r}",
        )],
    );
}

/// The finding's verdict and message on the last display, under a claim of its own.
fn said(claims: &Json, displays: &[&str], claim: Json) -> (Verdict, String) {
    let found = crate::support::equation(claims, displays, claim).finding;
    (crate::support::outcome(&found), found.message)
}

#[test]
fn lagrangians_with_the_same_motion() {
    let claims = with(&spring(), "constants", json!({ "m, k, a": "> 0" }));
    let same = || json!({ "same motion as": "L" });
    for (right, how) in [
        (r"F = L + 3 a x^2\dot x", "they differ by d/dt of a·x^3"),
        (r"F = \frac12 m\dot x^2 - \frac12 k x^2 + 2 a x\dot x t + a x^2", "they differ by d/dt of a·x^2·t"),
        (r"F = L + a\dot x\cos x", "they differ by a total time derivative"),
        (r"F = L - 2 a", "they differ by the constant −2·a"),
        (r"F = a m\dot x^2 - a k x^2", "it is 2·a times L"),
    ] {
        let (verdict, message) = said(&claims, &[SPRING, right], same());
        assert_eq!(verdict, Verified, "{right}: {message}");
        assert!(message.contains(how) || how.contains("x^2·t") && message.contains("d/dt of"), "{right}: {message}");
    }
    for wrong in [
        r"F = L + 3 a x^2",
        r"F = \frac12 m\dot x^2 - \frac12 k x^2 + 2 a x\dot x t - a x^2",
        r"F = a m\dot x^2 - k x^2",
        r"F = \dot x L",
    ] {
        assert_eq!(said(&claims, &[SPRING, wrong], same()).0, Refuted, "{wrong}");
    }
    // Nothing is said by the same formula.
    let (verdict, _) = said(&claims, &[SPRING, r"F = \frac12 m\dot x^2 - \frac12 k x^2"], same());
    assert_eq!(verdict, Verdict::Undecided);
}

#[test]
fn a_lagrangian_that_is_printed_again_may_lack_a_total_derivative() {
    let claims = json!({
        "coordinates": { r"\theta": "angle" },
        "constants": { "m, g, l": "> 0" },
        "functions": { "X": "of t" },
        "means": { "L": "Lagrangian" },
    });
    let first = r"L = \frac12 m(l^2\dot\theta^2 + 2 l\dot\theta\dot X\cos\theta + \dot X^2) + m g l\cos\theta";
    all(
        &claims,
        &[first],
        &[(
            r"L = \frac12 m l^2\dot\theta^2 - m l\ddot X\sin\theta + m g l\cos\theta + \frac12 m\dot X^2",
            r"L = \frac12 m l^2\dot\theta^2 + m l\ddot X\sin\theta + m g l\cos\theta + \frac12 m\dot X^2",
        )],
    );
}

#[test]
fn a_normal_frequency_of_one_coordinate_is_tested_and_of_several_is_rejected() {
    let two = json!({
        "coordinates": { "x_1, x_2": "any" },
        "constants": { r"m, k, \kappa": "> 0" },
        "means": { "L": "Lagrangian", r"\omega": "normal frequency" },
    });
    // True of one of the two roots.
    let notes = crate::support::numbered(&[
        r"L = \frac12 m(\dot x_1^2 + \dot x_2^2) - \frac12 k(x_1^2 + x_2^2) - \frac12\kappa(x_1 - x_2)^2",
        r"m\omega^2 = k + 2\kappa",
    ]);
    let found = crate::support::document(&two, &notes, &onshell::systems::Registry::standard(), None);
    let passes = found.as_ref().is_ok_and(|document| document.equations[1].finding.verdict.passes());
    assert!(!passes, "{found:?}");
    // A pendulum has one.
    let pendulum = json!({
        "coordinates": { r"\theta": "angle" },
        "constants": { "m, g, l": "> 0" },
        "means": { "L": "Lagrangian", r"\omega": "normal frequency" },
    });
    let before = [r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta"];
    all(&pendulum, &before, &[(r"\omega = \sqrt{\frac gl}", r"\omega = \sqrt{\frac lg}")]);
}

#[test]
fn claims_about_a_part_a_row_and_a_step() {
    let check = |displays: &[&str], equations: Json| {
        let claims = with(&spring(), "equations", equations);
        let notes = crate::support::numbered(displays);
        crate::support::document(&claims, &notes, &onshell::systems::Registry::standard(), None)
    };
    let ok = |displays: &[&str], equations: Json| {
        let document = check(displays, equations).expect("the claims fit the notes");
        document.equations.last().expect("there are displays").ok
    };
    let parts = [SPRING, r"m\ddot x = -k x, \quad x = 0"];
    let at_rest = json!({ "throughout": r"\dot x = 0" });
    assert!(ok(&parts, json!({ "2 part 2": at_rest })));
    assert!(!ok(&parts, json!({ "2 part 1": at_rest })));
    assert!(!ok(&parts, json!({})));
    let rows = [SPRING, r"\begin{aligned} m\ddot x &= -k x \\ x &= 0 \end{aligned}"];
    assert!(ok(&rows, json!({ "2 row 2": at_rest })));
    assert!(!ok(&rows, json!({ "2 row 1": at_rest })));
    let chain = [SPRING, r"-\frac{m}{k}\ddot x = x = 0"];
    assert!(ok(&chain, json!({ "2 step 2": at_rest })));
    assert!(!ok(&chain, json!({ "2 step 1": at_rest })));
    // What is expected of a part concerns that part.
    let wrong = json!({ "expect": "refuted", "because": "a misprint" });
    assert!(ok(&parts, json!({ "2 part 2": wrong })));
    assert!(!ok(&parts, json!({ "2 part 1": wrong })));
    assert!(check(&parts, json!({ "2 part 3": at_rest })).is_err());
    assert!(check(&parts, json!({ "2 part 1, 1": at_rest })).is_err());
}

#[test]
fn one_row_that_cannot_be_read_leaves_the_others() {
    let claims = spring();
    let display = r"\begin{aligned} m\ddot x &= -k x \\ y &= 3 x + \foo \\ \ddot x &= \frac km x \end{aligned}";
    let found = crate::support::equation(&claims, &[SPRING, display], json!({}));
    let verdicts: Vec<Verdict> = found.parts.iter().map(|part| crate::support::outcome(&part.finding)).collect();
    assert_eq!(verdicts, [Verified, Unreadable, Refuted]);
}

/// A bead on a turning hoop: at the bottom it is at rest for slow and for fast hoops, and swings only for slow ones.
fn hoop() -> Json {
    json!({
        "coordinates": { r"\theta": "angle" },
        "constants": { "m, g, R, h": "> 0", r"\Omega": "> 0", r"\theta_0": r"(0, \pi/2)" },
        "means": { "L": "Lagrangian", r"\omega": "normal frequency" },
    })
}

const HOOP: &str = r"L = \frac12 m R^2 (\dot\theta^2 + \Omega^2\sin^2\theta) + m g R\cos\theta";

#[test]
fn a_normal_frequency_is_a_formula_and_no_condition_of_what_does_not_contain_it() {
    // ω² = (K/M) at 0 = g/R − Ω², by hand.
    all(&hoop(), &[HOOP], &[(r"\omega^2 = \frac gR - \Omega^2", r"\omega^2 = \frac gR + \Omega^2")]);
    // Its derivative follows the formula: dω/dR = −g/(2R²ω).
    let slope = (r"\frac{d\omega}{dR} = -\frac{g}{2 R^2\omega}", r"\frac{d\omega}{dR} = 0");
    all(&hoop(), &[HOOP], &[slope]);
    // The bead rests at θ₀ only where the bottom is unstable, and ω does not exist.
    let rest = |latex: &str| verdict(&hoop(), &[HOOP, latex], json!({ "throughout": r"\theta = \theta_0" }));
    assert_eq!(rest(r"\cos\theta_0 = \frac{g}{R\Omega^2}"), Verified);
    assert_eq!(rest(r"\cos\theta_0 = \frac{R\Omega^2}{g}"), Refuted);
}

#[test]
fn a_small_coordinate_may_have_a_small_rate() {
    let claims = json!({
        "coordinates": { r"x": "any", r"\theta": "angle" },
        "constants": { "m, M, l, g": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let cart =
        r"L = \frac12 (M + m)\dot x^2 + m l\dot x\dot\theta\cos\theta + \frac12 m l^2\dot\theta^2 + m g l\cos\theta";
    let swing = |below: &str| {
        let latex = format!(r"\ddot\theta \approx -\frac{{(M + m) g}}{{{below}}}\theta");
        verdict(&claims, &[cart, &latex], json!({ "small": r"\theta" }))
    };
    assert_eq!(swing("M l"), Verified);
    assert_eq!(swing("m l"), Refuted);
}

/// Terms of the third and the fourth order nearly cancel in some families: ηθ̇² and gθ⁴/24. No power is seen there yet.
#[test]
fn terms_that_nearly_cancel_show_no_order() {
    let claims = json!({
        "coordinates": { r"\eta": "any", r"\theta": "angle" },
        "constants": { "m, g, k, a": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let before = [
        r"r = a + \frac{m g}{k} + \eta",
        r"L = \frac12 m(\dot r^2 + r^2\dot\theta^2) - \frac12 k(r - a)^2 + m g r\cos\theta",
    ];
    let stretch = |sign: &str| {
        let latex = format!(
            r"\ddot\eta \approx -\frac km\eta + \left(a + \frac{{m g}}{{k}}\right)\dot\theta^2 {sign} \frac12 g\theta^2"
        );
        verdict(&claims, &[before[0], before[1], &latex], json!({ "small": [r"\eta", r"\theta"], "order": 2 }))
    };
    assert_eq!(stretch("-"), Verified);
    assert_eq!(stretch("+"), Refuted);
}

#[test]
fn each_part_of_a_display_may_be_a_solution_with_constants_of_its_own() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "constants": { r"m, k": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let before = [r"L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 k(x^2 + y^2)"];
    let ellipse =
        |rate: &str| format!(r"x(t) = a\cos(\nu t), \quad y(t) = b\sin({rate}\nu t), \quad \nu = \sqrt{{\frac km}}");
    all(&claims, &before, &[(&ellipse(""), &ellipse("2"))]);
}
