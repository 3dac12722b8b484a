//! Notes without a claims file: formulas in sentences that define a name, and displays in environments inside `$$`.

use serde_json::Value;

use crate::support::Desk;

/// The verdicts on the displays of a page, and the conclusions that the report lists.
fn verdicts(name: &str, notes: &str) -> (Vec<String>, String) {
    let desk = Desk::new(&format!("sentences-{name}"));
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let document = &report["documents"][0];
    let equations = document["equations"].as_array().expect("a list");
    let verdict = |equation: &Value| equation["verdict"].as_str().unwrap_or_default().to_owned();
    (equations.iter().map(verdict).collect(), document["inferred"].to_string())
}

const MOTOR: &str = r"A motor pulls at a mass on a spring:

$$ m\ddot x + b\dot x + k x = F_0\cos\omega t $$

Put $\omega_0^2 = k/m$ and $2\gamma = b/m$. In these letters

$$ \ddot x + 2\gamma\dot x + \omega_0^2 x = \frac{F_0}{m}\cos\omega t $$
";

#[test]
fn a_formula_that_a_sentence_announces_defines_a_name() {
    let (found, inferred) = verdicts("motor", MOTOR);
    assert_eq!(found, ["assumed", "certified"]);
    assert!(inferred.contains("line 5"), "{inferred}");
    let (found, _) = verdicts("motor-slip", &MOTOR.replace(r"\frac{F_0}{m}", r"\frac{F_0}{2m}"));
    assert_eq!(found, ["assumed", "refuted"]);
}

#[test]
fn a_condition_a_value_and_a_special_case_in_a_sentence_define_nothing() {
    for said in [
        r"If $\omega_0^2 = k/m$ and $2\gamma = b/m$, then",
        r"For $\omega_0 = 2$, and with $\gamma = 3$,",
        r"With $\omega_0 = k$ at first,",
        r"Many find $\omega_0^2 = k$, which is right.",
    ] {
        let notes = MOTOR.replace(r"Put $\omega_0^2 = k/m$ and $2\gamma = b/m$. In these letters", said);
        let (found, inferred) = verdicts("condition", &notes);
        assert_eq!(found, ["assumed", "assumed"], "{said}");
        assert!(!inferred.contains("sentence"), "{said}: {inferred}");
    }
}

#[test]
fn an_environment_between_dollars_defines_names_as_a_display_does() {
    for environment in ["equation", "align", "equation*", "gather"] {
        let display = |latex: &str| format!("$$\n\\begin{{{environment}}}\n{latex}\n\\end{{{environment}}}\n$$\n\n");
        let lagrangian = display(r"L = \frac12 m \ell^2\dot\phi^2 + m g \ell\cos\phi");
        let derivative = |latex: &str| format!("The Lagrangian:\n\n{lagrangian}{}", display(latex));
        let right = derivative(r"\frac{\partial L}{\partial\phi} = -m g \ell\sin\phi");
        assert_eq!(verdicts("nested", &right).0, ["definition", "certified"], "{environment}");
        let wrong = derivative(r"\frac{\partial L}{\partial\phi} = -m g \ell\cos\phi");
        assert_eq!(verdicts("nested-slip", &wrong).0, ["definition", "refuted"], "{environment}");
    }
}

#[test]
fn a_name_in_capitals_and_a_relation_that_is_not_printed_make_no_slip() {
    let square = |right: &str| format!("$$ x = v_C + V_C + a $$\n\nThus\n\n$$ (v_C + a)^2 = {right} $$\n");
    assert_eq!(verdicts("capitals", &square("V_C^2 + 2 a v_C + a^2")).0[1], "assumed");
    assert_eq!(verdicts("capitals-slip", &square("v_C^2 + a v_C + a^2")).0[1], "refuted");
    // Nothing says that b is 2 m γ, but without this the second formula does not follow.
    let power = |right: &str| {
        format!(
            "$$ m\\ddot x + b\\dot x = F $$\n\n$$ \\gamma > 0 $$\n\nThus\n\n$$ P = \\frac12 b (\\omega A + c)^2 = {right} $$\n"
        )
    };
    let last = |name: &str, right: &str| verdicts(name, &power(right)).0.pop();
    assert_ne!(last("quotient", r"\gamma m (\omega A + c)^2").as_deref(), Some("refuted"));
    assert_eq!(last("quotient-slip", r"\frac12 b \omega^2 A^2 + \frac12 b c^2").as_deref(), Some("refuted"));
}

const BARRIER: &str = r"With $k = \sqrt{2 m E}/\hbar$ on both sides and the abbreviation $\beta = m\alpha/(\hbar^2 k)$ the probability is

$$ T = \frac{1}{1 + \beta^2} = \frac{1}{1 + \frac{m \alpha^2}{2 \hbar^2 E}} $$
";

#[test]
fn a_name_that_only_another_sentence_uses_has_a_formula() {
    let (found, inferred) = verdicts("barrier", BARRIER);
    assert!(inferred.contains("k = "), "{inferred}");
    assert_eq!(found[0], "certified");
    // The slip may be in the sentence.
    let (found, _) = verdicts("barrier-slip", &BARRIER.replace(r"{2 \hbar^2 E}", r"{\hbar^2 E}"));
    assert_eq!(found[0], "undecided");
    // What only "for" announces may be a case.
    let (_, inferred) = verdicts("barrier-case", &BARRIER.replace("With $k", "For $k"));
    assert!(!inferred.contains("k = "), "{inferred}");
}

const PENDULUM: &str = r"The kinetic energy is

$$ T = \frac12 m\ell^2\dot\theta^2 $$

Potential energy: $V = mgh = -mg\ell\cos\theta$. With the Lagrangian

$$ L = T - V $$

the equation of motion is

$$ \ell\ddot\theta + g\sin\theta = 0 $$
";

#[test]
fn a_formula_for_a_quantity_that_the_sentence_names_defines_it() {
    let (found, _) = verdicts("pendulum", PENDULUM);
    assert_eq!(found.last().map(String::as_str), Some("certified"), "{found:?}");
    let (found, _) = verdicts("pendulum-slip", &PENDULUM.replace(r"+ g\sin", r"+ 2g\sin"));
    assert_eq!(found.last().map(String::as_str), Some("refuted"), "{found:?}");
    // After other words it may be a special case.
    let (_, inferred) = verdicts("pendulum-case", &PENDULUM.replace("Potential energy:", "If the string is long,"));
    assert!(!inferred.contains("line 5"), "{inferred}");
}

const LEVELS: &str = r"Write $\beta = 1/k_BT$. The partition function is

$$ Z = 1 + e^{-\beta\varepsilon} $$

and with $N$ particles the energy

$$ U = -N\frac{\partial\ln Z}{\partial\beta} = \frac{N\varepsilon}{e^{\beta\varepsilon} + 1} $$

so the heat capacity is

$$ C = \frac{dU}{dT} = Nk_B\frac{(\beta\varepsilon)^2e^{\beta\varepsilon}}{(e^{\beta\varepsilon} + 1)^2} $$
";

#[test]
fn a_slash_in_a_line_of_text_has_the_product_below_it() {
    let (found, inferred) = verdicts("levels", LEVELS);
    assert_eq!(found, ["definition", "certified", "certified"], "{inferred}");
    let (found, _) = verdicts("levels-slip", &LEVELS.replace("(\\beta\\varepsilon)^2e", "(\\beta\\varepsilon)^3e"));
    assert_eq!(found[2], "refuted");
}

#[test]
fn a_formula_that_cannot_be_read_takes_no_other_formula_along() {
    // Nothing can be read of β, so it is a constant; Z and U keep their formulas.
    let (found, _) = verdicts("unread", &LEVELS.replace("1/k_BT", r"1/k_B\quad{}T"));
    assert_eq!(found[..2], ["definition", "certified"]);
}

#[test]
fn a_derivative_by_a_name_with_a_formula_is_by_that_name() {
    let notes = r"With $s = y/2$ we look for the maximum of

$$ f = \frac{s}{\cosh s} $$

Its derivative is

$$ \frac{df}{ds} = \frac{\cosh s - s\sinh s}{\cosh^2 s} $$
";
    assert_eq!(verdicts("derivative", notes).0.last().map(String::as_str), Some("certified"));
    let (found, _) = verdicts("derivative-slip", &notes.replace(r"- s\sinh", r"+ s\sinh"));
    assert_eq!(found.last().map(String::as_str), Some("refuted"));
    // y may stay fixed, or change with s.
    let (found, _) = verdicts("derivative-both", &notes.replace(r"\frac{s}{\cosh s}", r"\frac{y}{\cosh s}"));
    assert!(!["certified", "verified", "refuted"].contains(&found.last().map_or("", String::as_str)), "{found:?}");
}

const PLANET: &str = r"The Lagrangian is

$$ L = \frac m2\left(\dot r^2 + r^2\dot\varphi^2\right) + \frac\alpha r . $$

The momentum and the energy are

$$ M = m r^2\dot\varphi , \qquad E = \frac m2\dot r^2 + \frac{M^2}{2mr^2} - \frac\alpha r , $$

with the effective potential

$$ U = \frac{M^2}{2mr^2} - \frac\alpha r . $$

The turning points are the roots of

$$ E r^2 + \alpha r - \frac{M^2}{2m} = 0 . $$
";

#[test]
fn what_holds_at_an_instant_alone_is_not_called_wrong() {
    let (found, _) = verdicts("turning", PLANET);
    assert_ne!(found[3], "refuted");
    let wrong = PLANET
        .replace("The turning points are the roots of", "Hence")
        .replace(r"E r^2 + \alpha r", r"U r^2 - \alpha r");
    let (found, _) = verdicts("general", &wrong);
    assert_eq!(found[3], "refuted");
    // a pendulum that turns back rests nowhere
    let pendulum = r"A pendulum in a train moves by

$$ l \ddot\theta = -g \sin\theta - a \cos\theta $$

If it starts at $\theta = 0$, it comes to rest again at the angle $\theta_m$ with

$$ \tan\frac{\theta_m}{2} = -\frac ag $$
";
    let (found, _) = verdicts("train", pendulum);
    assert_ne!(found[1], "refuted");
}
