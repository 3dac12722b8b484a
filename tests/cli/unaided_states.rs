//! Notes without a claims file: laws in each of several states, and what is constant along a process.

use serde_json::Value;

use crate::support::Desk;

/// The verdicts on the displays of a page, and the report as text.
fn verdicts(name: &str, notes: &str) -> (Vec<String>, String) {
    let desk = Desk::new(&format!("states-{name}"));
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    let verdict = |equation: &Value| equation["verdict"].as_str().unwrap_or_default().to_owned();
    (equations.iter().map(verdict).collect(), run.out)
}

const GAS: &str = r"For an ideal gas

$$ pV = nRT $$

and

$$ C_V = \frac{R}{\gamma - 1} $$

From the state 1 to the state 2 the gas does the work

$$ W = nC_V(T_1 - T_2) = \frac{p_1V_1 - p_2V_2}{\gamma - 1} $$
";

#[test]
fn a_law_holds_in_each_state_that_a_display_names() {
    let (found, report) = verdicts("gas", GAS);
    assert_eq!(found, ["assumed", "definition", "verified"]);
    assert!(report.contains("in each state"), "{report}");
    let (found, _) = verdicts("gas-slip", &GAS.replace("p_1V_1 - p_2V_2", "p_2V_2 - p_1V_1"));
    assert_eq!(found, ["assumed", "definition", "refuted"]);
}

#[test]
fn a_law_of_which_few_quantities_have_an_index_says_nothing_of_a_state() {
    // K is the energy of the body 1 here, and K_1 that of another display.
    let notes = r"In one frame

$$ pc = \sqrt{K(K + 2mc^2)} $$

The product has

$$ K_1 = \frac{(M - m_1)^2c^2}{2M} $$

A body with the energy K hits another one:

$$ s = (E_1 + m_2c^2)^2 - p_1^2c^2 = (m_1 + m_2)^2c^4 + 2m_2c^2K $$
";
    let (found, report) = verdicts("frames", notes);
    assert!(!found.contains(&"refuted".to_owned()), "{report}");
}

/// An adiabat in p and V, and what follows for T.
fn adiabat(then: &str) -> String {
    format!(
        "A gas:\n\n$$ pV = nRT $$\n\nOn an adiabat\n\n$$ pV^\\gamma = \\text{{const}} $$\n\nand hence\n\n$$ {then} $$\n"
    )
}

#[test]
fn what_is_constant_follows_from_something_else_that_is() {
    for then in [r"TV^{\gamma - 1} = \text{const}", r"T^\gamma p^{1 - \gamma} = \text{const}"] {
        assert_eq!(verdicts("adiabat", &adiabat(then)).0, ["assumed", "assumed", "verified"], "{then}");
    }
    for then in [r"TV^{1 - \gamma} = \text{const}", r"T^\gamma p^{\gamma - 1} = \text{const}"] {
        assert_eq!(verdicts("adiabat-slip", &adiabat(then)).0, ["assumed", "assumed", "refuted"], "{then}");
    }
}

#[test]
fn what_is_constant_on_another_process_is_no_slip() {
    // The entropy of an isotherm: nothing of it follows from the adiabat, and no common slip is near.
    let (found, report) = verdicts("isotherm", &adiabat(r"S - nR\ln V = \text{const}"));
    assert_eq!(found[2], "assumed", "{report}");
}

#[test]
fn of_two_constants_that_contradict_each_other_nobody_knows_which_is_wrong() {
    let page = |second: &str| {
        let third = r"T p^{(1 - \gamma)/\gamma} = \text{const}";
        format!(
            "On an adiabat\n\n$$ pV^\\gamma = \\text{{const}} $$\n\nso that\n\n$$ {second} $$\n\nand therefore\n\n$$ {third} $$\n"
        )
    };
    assert_eq!(verdicts("constants", &page(r"TV^{\gamma - 1} = \text{const}")).0[2], "verified");
    let (found, report) = verdicts("constants-slip", &page(r"TV^{1 - \gamma} = \text{const}"));
    assert_eq!(found[1..], ["undecided", "undecided"], "{report}");
    assert!(report.contains("contradiction"), "{report}");
}
