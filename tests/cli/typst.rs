//! Typst: its displays are read, found at their places, and refused where they cannot be understood.

use serde_json::Value;

use crate::support::Desk;

/// The equations of a report on a Typst document.
fn report(name: &str, text: &str) -> (Vec<Value>, i32) {
    let desk = Desk::new(&format!("typst-{name}"));
    desk.write("notes.typ", text);
    let run = desk.onshell(&["check", "notes.typ", "--format", "json"]);
    (run.json()["documents"][0]["equations"].as_array().expect("a list").clone(), run.code)
}

/// A display as Typst writes it, and the same as LaTeX writes it.
const SAME: [(&str, &str); 24] = [
    ("(a + b)^2 = a^2 + 2 a b + b^2", r"(a + b)^2 = a^2 + 2 a b + b^2"),
    ("1/2 m v^2 = (m v^2)/2", r"\frac{1}{2} m v^2 = \frac{m v^2}{2}"),
    ("x_1/y_(1 2) = a/(b c)", r"\frac{x_1}{y_{1 2}} = \frac{a}{b c}"),
    ("dot(theta)^2 + dot.double(x) = k", r"\dot\theta^2 + \ddot x = k"),
    ("sin(2 theta) = 2 sin theta cos theta", r"\sin(2 \theta) = 2 \sin\theta\cos\theta"),
    ("sqrt(x^2) = abs(x)", r"\sqrt{x^2} = \lvert x\rvert"),
    ("root(3, x^3) = x", r"\sqrt[3]{x^3} = x"),
    ("frac(a + b, c) = a/c + b/c", r"\frac{a + b}{c} = \frac{a}{c} + \frac{b}{c}"),
    ("y &= (x + 1)^2 \\\n  &= x^2 + 2 x + 1", "y &= (x + 1)^2 \\\\\n  &= x^2 + 2 x + 1"),
    ("p = (partial L)/(partial dot(q))", r"p = \frac{\partial L}{\partial \dot q}"),
    ("p = partial L / partial dot(q)", r"p = \frac{\partial L}{\partial \dot q}"),
    ("arrow(F) = m arrow(a)", r"\vec F = m \vec a"),
    ("bold(v) = bold(omega) times bold(r)", r"\mathbf v = \mathbf{\omega} \times \mathbf r"),
    ("E_\"kin\" = p^2/(2 m)", r"E_{\text{kin}} = \frac{p^2}{2 m}"),
    ("sum_(n = 1)^3 n = 6", r"\sum_{n = 1}^{3} n = 6"),
    ("integral_0^1 x dif x = 1/2", r"\int_0^1 x \,\mathrm{d} x = \frac12"),
    (
        "mat(a, b; c, d) vec(1, 0) = vec(a, c)",
        r"\begin{pmatrix}a & b\\c & d\end{pmatrix}\begin{pmatrix}1\\0\end{pmatrix} = \begin{pmatrix}a\\c\end{pmatrix}",
    ),
    ("a dot.c b <= c => a b <= c", r"a \cdot b \le c \Rightarrow a b \le c"),
    ("e^(-x/2) != 0", r"e^{-\frac{x}{2}} \ne 0"),
    ("f(x)/g = 1", r"\frac{f(x)}{g} = 1"),
    ("x'' + omega_0^2 x = 0", r"x'' + \omega_0^2 x = 0"),
    ("gamma = 1/sqrt(1 - beta^2)", r"\gamma = \frac{1}{\sqrt{1 - \beta^2}}"),
    ("2.5 x = 5/2 x // a comment", r"2.5 x = \frac{5}{2} x"),
    ("hbar omega = h nu", r"\hbar \omega = h \nu"),
];

#[test]
fn a_display_is_read_as_its_latex_is() {
    let typst: String = SAME.iter().map(|(typst, _)| format!("Then we have\n$ {typst} $\nand so on.\n\n")).collect();
    let latex: String =
        SAME.iter().map(|(_, latex)| format!("Then we have\n\n$$ {latex} $$\n\nand so on.\n\n")).collect();
    let (found, code) = report("same", &typst);
    let desk = Desk::new("typst-latex");
    desk.write("notes.md", &latex);
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let wanted = run.json()["documents"][0]["equations"].as_array().expect("a list").clone();
    // What stands on either side of an arrow is judged apart.
    let arrows = SAME.iter().filter(|(_, latex)| latex.contains(r"\Rightarrow")).count();
    assert_eq!((found.len(), code), (SAME.len() + arrows, run.code));
    for (found, wanted) in found.iter().zip(&wanted) {
        assert_eq!((&found["reading"], &found["verdict"]), (&wanted["reading"], &wanted["verdict"]), "{found}");
    }
    let read = found.iter().filter(|equation| equation["verdict"] != "unreadable").count();
    assert!(read >= 20, "{read} of {}", SAME.len());
}

#[test]
fn a_slip_is_found_at_its_place_and_mended_and_labels_are_ids() {
    let text = "= Squares\n\nThe price is \\$5, `$ no $`, and $x$ is inline. /* $ no $ */\n\
                $ (alpha + b)^3 = alpha^3 + 3 alpha^2 b + 3 alpha b^2 - b^3 $ <eq:square>\nSee @eq:square.\n";
    let (equations, code) = report("slip", text);
    assert_eq!((equations.len(), code), (1, 1));
    assert_eq!((&equations[0]["id"], &equations[0]["line"]), (&Value::from("eq:square"), &Value::from(4)));
    let start = equations[0]["span"]["start"].as_u64().expect("a number") as usize;
    assert!(text[start..].starts_with("(alpha + b)"), "{}", equations[0]);
    let desk = Desk::new("typst-fix");
    desk.write("notes.typ", text);
    let run = desk.onshell(&["check", "notes.typ", "--fix", "--yes"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert_eq!(desk.read("notes.typ"), text.replace("- b^3", "+ b^3"));
}

#[test]
fn what_is_not_understood_is_said_and_never_read_otherwise() {
    let displays = [
        "#let y = 3",
        "x = qdot",
        "x2 = a",
        "mat(delim: \"|\", a, b; c, d) = a d - b c",
        "a = cancel(b) b",
        "(a = b",
        "x = stretch(=, size: #150%) y",
        "x_i(t) = a",
        "a ~ b",
        "a = #b",
    ];
    for (at, display) in displays.iter().enumerate() {
        let (equations, code) = report(&format!("refused-{at}"), &format!("$ {display} $\n\n$ a + a = 2 a $\n"));
        let verdicts: Vec<&str> = equations.iter().filter_map(|equation| equation["verdict"].as_str()).collect();
        assert_eq!((verdicts, code), (vec!["unreadable", "certified"], 0), "{display}");
    }
    let desk = Desk::new("typst-open");
    desk.write("notes.typ", "One $ a = b\n");
    let run = desk.onshell(&["check", "notes.typ"]);
    assert!(run.code == 2 && run.err.contains("notes.typ:1:5"), "{}", run.err);
}
