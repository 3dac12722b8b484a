//! Notes without a claims file: what a display is judged by. The other side of an arrow, formulas in sentences, single
//! statements of a display.

use serde_json::Value;

use crate::support::Desk;

/// The verdicts on the displays of a page.
fn verdicts(name: &str, notes: &str) -> Vec<String> {
    let desk = Desk::new(&format!("premises-{name}"));
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    equations.iter().map(|equation| equation["verdict"].as_str().unwrap_or_default().to_owned()).collect()
}

#[test]
fn what_stands_after_an_arrow_is_judged_by_what_stands_before_it() {
    let balance = |arrow: &str, speed: &str| {
        format!(
            "The forces balance,\n$$ m g = \\frac12 \\rho C A v^2 {arrow} v = \\sqrt{{\\frac{{{speed}}}{{\\rho C A}}}}. $$\n"
        )
    };
    for arrow in [
        r"\quad\Rightarrow\quad",
        r"\implies",
        r"\qquad\text{so}\qquad",
        r"\quad\text{ thus }\quad",
        r"\quad\mbox{hence}\quad",
        r"\\ \therefore\;",
        r"\iff",
    ] {
        let right = verdicts("arrow", &balance(arrow, "2 m g"));
        assert_eq!(right.len(), 2, "{arrow}");
        assert!(right.iter().all(|verdict| verdict != "refuted"), "{arrow}: {right:?}");
        assert_eq!(verdicts("arrow-slip", &balance(arrow, "m g"))[1], "refuted", "{arrow}");
    }
    // Beside the statement nothing says that the one follows from the other.
    assert_eq!(verdicts("beside", &balance(r",\qquad", "m g")).len(), 1);
}

#[test]
fn the_number_of_a_display_is_that_of_its_conclusion() {
    let desk = Desk::new("premises-number");
    desk.write("notes.md", "A gas:\n$$ p V = N k T \\implies p = \\frac{N k V}{T} \\tag{4} $$\n");
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).expect("a report");
    let found = &report["documents"][0]["equations"];
    assert_eq!((&found[0]["id"], &found[1]["id"]), (&Value::from("L2"), &Value::from("4")));
    assert_eq!(found[1]["verdict"], "refuted");
    assert_eq!(found[1]["repairs"][0]["replacement"], "T}{V");
}

#[test]
fn a_formula_in_a_sentence_is_a_premise_of_the_next_display() {
    let otto = |said: &str, result: &str| {
        format!(
            "$$ Q = C(T_3 - T_2) $$\n$$ P = C(T_4 - T_1) $$\n\n{said}\n\n\
             $$ \\eta = 1 - \\frac{{T_4 - T_1}}{{T_3 - T_2}} = {result}. $$\n"
        )
    };
    let said = "Both adiabats have the same ratio, $T_3 - T_2 = (T_4 - T_1) r^{\\gamma - 1}$. Then";
    assert_eq!(verdicts("otto", &otto(said, r"1 - r^{1 - \gamma}"))[2], "verified");
    assert_eq!(verdicts("otto-slip", &otto(said, r"1 - r^{\gamma - 1}"))[2], "refuted");
    // Without it nothing speaks against the result.
    assert_eq!(verdicts("otto-alone", &otto("Then", r"1 - r^{\gamma - 1}"))[2], "assumed");
}

#[test]
fn a_name_that_a_sentence_gives_another_formula_makes_no_slip() {
    let page = |said: &str| {
        format!(
            "$$ \\beta = \\frac{{v}}{{c}} $$\n$$ \\gamma = \\frac{{1}}{{\\sqrt{{1 - \\beta^2}}}} $$\n\n\
             $$ x = \\gamma(y - v t) + u $$\n\n{said}\n\n$$ \\gamma^2 m^2 c^4\\left(1 - \\frac{{u^2}}{{c^2}}\\right) = m^2 c^4 $$\n"
        )
    };
    let again = r"From here on $\gamma = (1 - u^2/c^2)^{-1/2}$ belongs to the particle. Squared, this gives";
    assert!(!verdicts("again", &page(again)).contains(&"refuted".to_owned()));
    assert_eq!(verdicts("same", &page("Squared, this gives"))[3], "refuted");
}

#[test]
fn a_condition_at_the_end_of_a_chain_is_no_claim() {
    // The curve has two statements. With the place of the peak for a letter, "= 0" would follow from them.
    let peak = |end: &str| {
        format!(
            "$$ A = \\frac{{F}}{{\\sqrt{{(q^2 - p^2)^2 + b^2 p^2}}}}, \\qquad \\tan\\delta = \\frac{{b p}}{{q^2 - p^2}} \\tag{{2}} $$\n\n\
             Where is the root in (2) smallest? Differentiate:\n\n\
             $$ \\frac{{d}}{{dp}}\\left[(q^2 - p^2)^2 + b^2 p^2\\right] = {end} , $$\n\n$$ p_r^2 = q^2 - \\frac{{b^2}}{{2}} . $$\n"
        )
    };
    let right = verdicts("peak", &peak(r"-4 p(q^2 - p^2) + 2 b^2 p = 0"));
    assert!(!right.contains(&"refuted".to_owned()), "{right:?}");
    assert_eq!(verdicts("peak-slip", &peak(r"4 p(q^2 - p^2) + 2 b^2 p"))[1], "refuted");
}
