//! Notes without a claims file: the rows of `align`, the words between rows, and displays after words for small motion.

use serde_json::Value;

use crate::support::Desk;

/// The name of each display of a LaTeX file, with its verdict.
fn found(name: &str, notes: &str) -> Vec<(String, String)> {
    let desk = Desk::new(&format!("unaided-rows-{name}"));
    desk.write("notes.tex", notes);
    let run = desk.onshell(&["check", "notes.tex", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    equations.iter().map(|equation| (text(&equation["id"]), text(&equation["verdict"]))).collect()
}

fn rows(name: &str, rows: &str) -> Vec<(String, String)> {
    found(name, &format!("\\begin{{align}}\n{rows}\n\\end{{align}}\n"))
}

fn named(expected: &[(&str, &str)]) -> Vec<(String, String)> {
    expected.iter().map(|(id, verdict)| ((*id).to_owned(), (*verdict).to_owned())).collect()
}

#[test]
fn a_label_is_that_of_its_row_and_each_row_is_judged() {
    let sum = r"F_l + F_r &= m a \nonumber \\";
    let right = rows("label", &format!("{sum}\n \\frac{{1}}{{m}}(F_l + F_r) &= a \\label{{eq:a}}"));
    assert_eq!(right, named(&[("L2", "assumed"), ("eq:a", "certified")]));
    let wrong = rows("label-slip", &format!("{sum}\n \\frac{{2}}{{m}}(F_l + F_r) &= a \\label{{eq:a}}"));
    assert_eq!(wrong, named(&[("L2", "assumed"), ("eq:a", "refuted")]));
    let first = rows("first-row", "F &= m a \\label{eq:F} \\\\\n \\frac{F}{m} &= 2a");
    assert_eq!(first, named(&[("eq:F", "definition"), ("L3", "refuted")]));
    let tagged = rows("tag", "F &= m a \\\\\n \\frac{F}{m} &= 2a \\tag{7}");
    assert_eq!(tagged, named(&[("L2", "definition"), ("7", "refuted")]));
}

#[test]
fn a_number_of_rows_that_belong_together_is_one_display() {
    let split = |row: &str| {
        let body = format!("F &= m a \\\\ {row} &= 2a");
        found(
            "split",
            &format!("\\begin{{equation}}\\label{{eq:F}}\n\\begin{{split}}{body}\\end{{split}}\n\\end{{equation}}"),
        )
    };
    assert_eq!(split(r"\frac{2F}{m}"), named(&[("eq:F", "definition")]));
    assert_eq!(split(r"\frac{F}{m}"), named(&[("eq:F", "refuted")]));
}

/// LaTeX ends a row before `\intertext`, with or without `\\`.
#[test]
fn a_text_between_rows_ends_the_row_before_it() {
    for end in ["", r"\\", r"\nonumber"] {
        for command in ["intertext", "shortintertext"] {
            let page = |row: &str| format!("F &= m a {end}\n\\{command}{{so the acceleration is}}\n a &= {row}");
            let right = rows("intertext", &page(r"\frac{F}{m}"));
            assert_eq!(right, named(&[("L2", "definition"), ("L4", "certified")]), "{end} {command}");
            let wrong = rows("intertext-slip", &page(r"\frac{F}{2m}"));
            assert_eq!(wrong, named(&[("L2", "definition"), ("L4", "refuted")]), "{end} {command}");
        }
    }
}

const PENDULUM: &str = r"\begin{align*}
L &= \frac12 m l^2\dot\theta^2 + m g l\cos\theta
\intertext{The equation of motion is}
\ddot\theta &= -\frac gl\sin\theta
\intertext{For small angles we have}
\ddot\theta &= -\frac gl\theta
\end{align*}
";

#[test]
fn after_words_for_small_motion_a_display_holds_to_first_order() {
    let verdicts = |name: &str, notes: &str| found(name, notes).pop().map(|(_, verdict)| verdict);
    let last = |name: &str, (from, to): (&str, &str)| verdicts(name, &PENDULUM.replace(from, to));
    assert_eq!(last("small", ("", "")).as_deref(), Some("verified"));
    assert_eq!(last("small-slip", (r"\frac gl\theta", r"\frac g{l^2}\theta")).as_deref(), Some("refuted"));
    assert_eq!(last("small-factor", (r"\frac gl\theta", r"2\frac gl\theta")).as_deref(), Some("refuted"));
    // Nothing says that it is small, and it does not follow.
    assert_eq!(last("any-angle", ("For small angles we have", "We find")).as_deref(), Some("assumed"));
    assert_eq!(last("not-small", ("For small angles", "For angles that are not small")).as_deref(), Some("assumed"));
    // The inverted pendulum moves away: a sign may be meant.
    assert_ne!(last("other-sign", (r"-\frac gl\theta", r"\frac gl\theta")).as_deref(), Some("verified"));
}
