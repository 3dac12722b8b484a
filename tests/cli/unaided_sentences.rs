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
