//! Displays about a special case that the words around them state: a place, constants with a relation, a limit, a steady motion.

use onshell::check::Verdict;
use serde_json::json;

use crate::prose_claims::{checked, claims, of, passes_and_finds};

/// A weight on a string, with a bob that swings at its other end.
const ATWOOD: &str = r"$$ L = \frac12(M + m)\dot r^2 + \frac12 m r^2\dot\theta^2 - M g r + m g r\cos\theta \tag{1} $$

If the bob does not swing ($\theta = 0$), it falls with

$$ \ddot r = \frac{m - M}{m + M} g \tag{2} $$

For $M = 3m$ there is a second constant of the motion,

$$ I = r^2\dot\theta\left(\dot r\cos\frac\theta2 - \frac{r\dot\theta}{2}\sin\frac\theta2\right) + g r^2\sin\frac\theta2\cos^2\frac\theta2 \tag{3} $$
";

/// A cylinder in a drum: a frequency, and its cases.
const DRUM: &str = r"$$ L = \frac12 M R^2\dot\psi^2 + \frac12 m b^2\dot\varphi^2 + \frac14 m(R\dot\psi - b\dot\varphi)^2 + m g b\cos\varphi \tag{1} $$

The frequency of small oscillations is

$$ \Omega = \sqrt{\frac{(2M + m)g}{(3M + m)b}} \tag{2} $$

Some cases are

\begin{align}
\text{a heavy drum } (M \to \infty): \quad & \Omega = \sqrt{\frac{2g}{3b}} \tag{3} \\
\text{equal masses } (M = m): \quad & \Omega = \sqrt{\frac{3g}{4b}} \tag{4}
\end{align}
";

/// A charge in the field of a dipole, on a circle.
const DIPOLE: &str = r"$$ L = \frac m2\left(\dot\rho^2 + \rho^2\dot\phi^2\right) + \frac{K\dot\phi}{\rho} \tag{1} $$

## Circles

There is a circular orbit $\rho = a$, on which the particle goes round with the angular velocity

$$ \Omega = \frac{K}{m a^3} \tag{2} $$

Its momentum is

$$ p_\phi = m a^2\Omega + \frac Ka = \frac{2K}{a} \tag{3} $$
";

fn swinging() -> serde_json::Value {
    claims(&json!({ "r": "> 0", r"\theta": "angle" }), "m, M, g")
}

#[test]
fn a_place_and_a_relation_between_constants() {
    let notes = ATWOOD;
    let slips = [
        ("2", r"\frac{m - M}{m + M}", r"\frac{m - M}{m - M}"),
        ("3", r"g r^2\sin\frac\theta2\cos^2", r"g r^2\sin\frac\theta2\cos"),
    ];
    passes_and_finds(&swinging(), notes, &slips[..1]);
    assert_eq!(
        of(&checked(&swinging(), &notes.replace(slips[1].1, slips[1].2)), "3").finding.verdict,
        Verdict::Refuted
    );
    // Without the words neither holds.
    let found = checked(&swinging(), &notes.replace(r"If the bob does not swing ($\theta = 0$), it", "It"));
    assert_eq!(of(&found, "2").finding.verdict, Verdict::Refuted);
    let found = checked(&swinging(), &notes.replace("For $M = 3m$ there", "There"));
    assert_ne!(of(&found, "3").finding.verdict, Verdict::Certified);
}

#[test]
fn a_condition_on_a_printed_name_hides_no_slip() {
    // At θ = 0 the two would agree, but whoever means this case does not print θ.
    let notes = ATWOOD.split("For").next().unwrap_or_default();
    let printed = r"(M + m)\ddot r = m r\dot\theta^2 - M g + m g\cos\theta";
    let general = notes.replace(r"\ddot r = \frac{m - M}{m + M} g", printed);
    assert!(of(&checked(&swinging(), &general), "2").finding.verdict.holds());
    let slip = general.replace(r"m g\cos\theta \tag{2}", r"m g\cos^2\theta \tag{2}");
    assert_eq!(of(&checked(&swinging(), &slip), "2").finding.verdict, Verdict::Refuted);
}

#[test]
fn words_and_a_case_before_a_statement_in_a_display() {
    let claims = claims(&json!({ r"\psi, \varphi": "angle" }), "M, m, R, b, g");
    passes_and_finds(&claims, DRUM, &[("4", r"\frac{3g}{4b}", r"\frac{3g}{5b}")]);
    // In a limit = stands for ≈.
    let slip = DRUM.replace(r"\frac{2g}{3b}", r"\frac{2g}{5b}");
    assert_eq!(of(&checked(&claims, &slip), "3").finding.verdict, Verdict::Refuted);
    // Whoever means the limit does not print M: a slip in a smaller term is one.
    let slip = DRUM.replace(r"\sqrt{\frac{2g}{3b}}", r"\sqrt{\frac{(2M - m)g}{(3M + m)b}}");
    assert_eq!(of(&checked(&claims, &slip), "3").finding.verdict, Verdict::Refuted);
}

#[test]
fn a_circle_and_the_rate_on_it() {
    let claims = claims(&json!({ r"\rho": "> 0", r"\phi": "angle" }), "m, K, a");
    passes_and_finds(&claims, DIPOLE, &[("3", r"\frac{2K}{a}", r"\frac{K}{a}")]);
}

#[test]
fn a_power_with_a_symbol_in_the_lagrangian() {
    let notes = r"$$ L = \frac12 m(\dot r^2 + r^2\dot\phi^2) - C r^n \tag{1} $$

Hence

$$ m\ddot r = m r\dot\phi^2 - n C r^{n-1} \tag{2} $$
";
    let claims = claims(&json!({ "r": "> 0", r"\phi": "angle" }), "m, C, n");
    assert!(of(&checked(&claims, notes), "2").finding.verdict.holds());
    for slip in ["n C r^{n+1}", "C r^{n-1}", "n C r^n"] {
        let found = checked(&claims, &notes.replace("n C r^{n-1}", slip));
        assert_eq!(of(&found, "2").finding.verdict, Verdict::Refuted, "{slip}");
    }
}

#[test]
fn one_formula_solves_for_two_coordinates() {
    let notes = r"$$ L = \frac m2(\dot x_1^2 + \dot x_2^2) - \frac k2(x_1^2 + x_2^2) - \frac c2(x_1 - x_2)^2 \tag{1} $$

In the first mode

$$ x_1(t) = x_2(t) = A\cos\left(\sqrt{\frac km}\,t\right) \tag{2} $$
";
    let mut claims = claims(&json!({ "x_1, x_2": "any" }), "m, k, c");
    claims["constants"]["A"] = json!("any");
    assert!(of(&checked(&claims, notes), "2").ok, "{:?}", of(&checked(&claims, notes), "2"));
    let found = checked(&claims, &notes.replace(r"\sqrt{\frac km}", r"\sqrt{\frac{k + c}m}"));
    assert!(!of(&found, "2").ok);
}
