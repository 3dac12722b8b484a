//! Notes without a claims file: nothing true is called wrong, and slips are, with the edit that corrects them.

use serde_json::Value;

use crate::support::Desk;

/// The equations of the report on notes without a claims file, and the exit code.
fn report(name: &str, file: &str, notes: &str) -> (Vec<Value>, i32) {
    let desk = Desk::new(&format!("unaided-{name}"));
    desk.write(file, notes);
    let run = desk.onshell(&["check", file, "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    assert_eq!(report["documents"][0]["claims"], Value::Null);
    (report["documents"][0]["equations"].as_array().expect("a list").clone(), run.code)
}

pub fn page(displays: &[&str]) -> String {
    displays.iter().map(|latex| format!("$$ {latex} $$\n\n")).collect()
}

/// True of nature, of a system, or by definition, as physicists print it; none of it can be called wrong.
pub const TRUE: [&[&str]; 10] = [
    &[
        r"F = m a",
        r"E = \frac12 m v^2 + m g h",
        r"v^2 = v_0^2 + 2 a (x - x_0)",
        r"x = x_0 + v_0 t + \frac12 a t^2",
        r"p = m v",
        r"E_k = \frac{p^2}{2m}",
        r"m g h = \frac12 m v^2",
        r"v = \sqrt{2 g h}",
    ],
    &[
        r"P V = n R T",
        r"P V^\gamma = C",
        r"U = \frac32 n R T",
        r"C_p - C_V = n R",
        r"\frac{P_1 V_1}{T_1} = \frac{P_2 V_2}{T_2}",
    ],
    &[
        r"m \ddot x = -k x",
        r"\omega^2 = \frac{k}{m}",
        r"x = A \cos(\omega t + \phi)",
        r"\dot x = -A\omega \sin(\omega t + \phi)",
        r"\ddot x + 2\gamma\dot x + \omega_0^2 x = 0",
        r"x_1 + x_2 = x_3",
    ],
    &[
        r"m_1 v_1 + m_2 v_2 = m_1 u_1 + m_2 u_2",
        r"m_1 v_1 = v_2 m_1",
        r"m_1 v_1 = m_1 v_2",
        r"m_1 v_1 + m_2 v_2 = m_2 v_2 + m_1 v_3",
        r"\frac12 m v_1^2 + m g h_1 = \frac12 m v_2^2 + m g h_2",
    ],
    &[
        r"n_1 \sin\theta_1 = n_2 \sin\theta_2",
        r"\frac1f = \frac1a + \frac1b",
        r"\cos^2\theta + \sin^2\theta = 1",
        r"\sin(\alpha+\beta) = \sin\alpha\cos\beta + \cos\alpha\sin\beta",
        r"\tan\theta = \frac{v_y}{v_x}",
        r"\lambda f = c",
    ],
    &[
        r"\frac{v^2}{r} = \frac{G M}{r^2}",
        r"T^2 = \frac{4\pi^2 a^3}{G M}",
        r"r = \frac{p}{1 + \epsilon\cos\phi}",
        r"\epsilon^2 = 1 - \frac{b^2}{a^2}",
        r"l = m r^2 \dot\phi",
        r"E = \frac12 m \dot r^2 + \frac{l^2}{2 m r^2} - \frac{G M m}{r}",
    ],
    &[
        r"\vec F = q(\vec E + \vec v \times \vec B)",
        r"\vec a\times(\vec b\times\vec c) = \vec b(\vec a\cdot\vec c) - \vec c(\vec a\cdot\vec b)",
        r"\vec L = \vec r \times \vec p",
        r"\vec p = m \vec v",
        r"\frac{d\vec p}{dt} = \vec F",
        r"\frac{d\vec v}{dt} = \dot{\vec v} + \vec\omega \times \vec v",
        r"\vec v = \vec v_0 + \vec\omega \times \vec r",
        r"\vec a_1 + \vec b_1 = \vec b_1 + \vec a_2",
        r"m_1 \dot x_1 + m_2 \dot x_2 = m_1 u_1 + m_2 \dot x_2",
    ],
    &[
        r"E^2 = p^2 c^2 + m^2 c^4",
        r"\gamma = \frac{1}{\sqrt{1 - \beta^2}}",
        r"\beta = \frac{v}{c}",
        r"t' = \gamma (t_0 - \beta x)",
        r"E = \gamma m c^2",
    ],
    &[
        r"I = \frac{V}{R}",
        r"V = I R",
        r"\frac{1}{R} = \frac{1}{R_1} + \frac{1}{R_2}",
        r"R = \frac{R_1 R_2}{R_1 + R_2}",
        r"\tau = R C",
        r"L \ddot q + R \dot q + \frac{q}{C} = 0",
    ],
    &[
        r"x + y = 1",
        r"y = x^2",
        r"x^2 + y^2 = r^2",
        r"(x - x_0)^2 + (y - y_0)^2 = R^2",
        r"a = b",
        r"a^2 = b^2 + c^2 - 2 b c \cos\alpha",
        r"ds^2 = dx^2 + dy^2",
        r"A_{12} = A_{21}",
    ],
];

/// Laws, conditions and other motions beside a Lagrangian, and what follows from it.
pub const BESIDE_A_LAGRANGIAN: [(&str, &[&str]); 2] = [
    (
        "The Lagrangian of an oscillator is",
        &[
            r"L = \frac12 m \dot x^2 - \frac12 k x^2",
            r"\ddot x = -\omega^2 x",
            r"m \ddot x + k x = 0",
            r"\omega_0 = \sqrt{\frac{k}{m}}",
            r"\ddot x = -\omega_0^2 x",
            r"x = A \cos(\omega t + \phi)",
            r"\dot x = v",
            r"E = \frac12 m \dot x^2 + \frac12 k x^2",
            r"\dot E = 0",
            r"m \dot x = p_0",
            r"m \ddot x = F",
            r"m \ddot x + \gamma \dot x + k x = 0",
            r"m \ddot x + k x = F_0 \cos(\Omega t)",
            r"x^2 + \frac{\dot x^2}{\omega_0^2} = A^2",
        ],
    ),
    (
        "The Lagrangian of a planet:",
        &[
            r"L = \frac12 m (\dot r^2 + r^2 \dot\phi^2) + \frac{G M m}{r}",
            r"\ell = m r^2 \dot\phi",
            r"\dot\ell = 0",
            r"m \ddot r = m r \dot\phi^2 - \frac{G M m}{r^2}",
            r"m \ddot r = \frac{\ell^2}{m r^3} - \frac{G M m}{r^2}",
            r"r \dot\phi^2 = \frac{G M}{r^2}",
            r"\dot r = 0",
            r"\dot A = \frac12 r^2 \dot\phi",
            r"r = \frac{p}{1 + \epsilon \cos\phi}",
            r"m \ddot r = -\frac{dU}{dr}",
            r"\ddot r = r\dot\phi^2",
        ],
    ),
];

#[test]
fn what_does_not_follow_from_a_lagrangian_is_no_slip_and_what_follows_does() {
    for (at, (words, displays)) in BESIDE_A_LAGRANGIAN.iter().enumerate() {
        let notes = format!("{words}\n\n{}", page(displays));
        let (equations, code) = report(&format!("beside-{at}"), "notes.md", &notes);
        for (latex, equation) in displays.iter().zip(&equations) {
            assert_ne!(equation["verdict"], "refuted", "{latex}: {}", equation["message"]);
        }
        assert_eq!(code, 0);
        let certified = equations.iter().filter(|equation| equation["verdict"] == "certified").count();
        assert!(certified >= 3, "{certified} of {}", equations.len());
    }
}

#[test]
fn nothing_true_is_called_wrong() {
    for (at, displays) in TRUE.iter().enumerate() {
        let (equations, code) = report(&format!("true-{at}"), "notes.md", &page(displays));
        assert_eq!(equations.len(), displays.len());
        for (latex, equation) in displays.iter().zip(&equations) {
            assert_ne!(equation["verdict"], "refuted", "{latex}: {}", equation["message"]);
        }
        assert_eq!(code, 0);
    }
}

/// The premise is divided by its common factor, so the line after the wrong one follows from it.
#[test]
fn a_true_line_after_a_wrong_one_is_not_called_wrong() {
    let page = |force: &str| {
        format!(
            "The torques about the foot give\n\n$$ S l\\sin\\beta = \\frac12 G l\\cos\\beta $$\n\nso that\n\n$$ S = {force} $$\n\n\
             and\n\n$$ \\frac{{S}}{{G}} = \\frac{{1}}{{2\\tan\\beta}} $$\n"
        )
    };
    for (name, force, wrong) in [
        ("torque-true", r"\frac{G}{2\tan\beta}", [false, false, false]),
        ("torque-slip", r"\frac{G}{\tan\beta}", [false, true, false]),
    ] {
        let (equations, _) = report(name, "notes.md", &page(force));
        let refuted: Vec<bool> = equations.iter().map(|equation| equation["verdict"] == "refuted").collect();
        assert_eq!(refuted, wrong, "{name}: {equations:?}");
    }
}

/// Displays, which of them is looked at, and its verdict.
pub const SLIPS: [(&[&str], usize, &str); 11] = [
    (&[r"(a+b)^2 = a^2 + b^2"], 0, "refuted"),
    (&[r"v^2 - u^2 = (v - u)(v - u)"], 0, "refuted"),
    (&[r"\sin(a+b) = \sin a\cos b - \cos a\sin b"], 0, "refuted"),
    (&[r"x = l\sin\theta", r"\dot x = l\dot\theta\sin\theta"], 1, "refuted"),
    (&[r"x = l\sin\theta", r"y = -l\cos\theta", r"\dot x^2 + \dot y^2 = l\dot\theta^2"], 2, "refuted"),
    (&[r"y = (x + a)^2 = x^2 + a x + a^2"], 0, "refuted"),
    (&[r"\frac{1}{a} - \frac{1}{b} = \frac{a - b}{a b}"], 0, "refuted"),
    // The same without the slip.
    (&[r"(a+b)^2 = a^2 + 2 a b + b^2"], 0, "certified"),
    (&[r"x = l\sin\theta", r"\dot x = l\dot\theta\cos\theta"], 1, "certified"),
    (&[r"y = (x + a)^2 = x^2 + 2 a x + a^2"], 0, "certified"),
    (&[r"\frac{1}{a} - \frac{1}{b} = \frac{b - a}{a b}"], 0, "certified"),
];

#[test]
fn a_slip_in_what_follows_is_called_wrong_and_corrected() {
    for (at, (displays, wrong, verdict)) in SLIPS.into_iter().enumerate() {
        let (equations, code) = report(&format!("slip-{at}"), "notes.md", &page(displays));
        let found = &equations[wrong];
        assert_eq!(found["verdict"], verdict, "{displays:?}: {}", found["message"]);
        assert_eq!(code, i32::from(verdict == "refuted"), "{displays:?}");
        let repairs = found["repairs"].as_array().map_or(0, Vec::len);
        assert_eq!(repairs > 0, verdict == "refuted", "{displays:?}");
    }
}

pub const LECTURE: &str = r"
# The pendulum

\begin{align}
x &= l \sin\theta, \\
y &= -l\cos\theta .
\end{align}

$$ T = \frac12 m (\dot x^2 + \dot y^2) = \frac12 m l^2 \dot\theta^2 $$

$$ L = T - m g y = \frac12 m l^2\dot\theta^2 + m g l \cos\theta $$

The Euler-Lagrange equation of this Lagrangian is

$$ \frac{d}{dt}\frac{\partial L}{\partial\dot\theta} - \frac{\partial L}{\partial\theta} = m l^2\ddot\theta + m g l \sin\theta = 0 $$

$$ \ddot\theta = -\frac{g}{l}\sin\theta $$
";

#[test]
fn a_lecture_follows_from_the_lagrangian_that_it_prints() {
    for file in ["notes.md", "notes.tex"] {
        let (equations, code) = report("lecture", file, LECTURE);
        let verdicts: Vec<&str> = equations.iter().filter_map(|equation| equation["verdict"].as_str()).collect();
        let (defined, certified) = ("definition", "certified");
        // The two rows of the first display are two equations.
        assert_eq!(verdicts, [defined, defined, certified, certified, certified, certified], "{file}");
        assert_eq!(code, 0);
        let (equations, code) = report("lecture-slip", file, &LECTURE.replace("-\\frac{g}{l}", "\\frac{g}{l}"));
        assert_eq!((equations[5]["verdict"].as_str(), code), (Some("refuted"), 1));
        assert_eq!(equations[5]["id"], "L17");
    }
}

#[test]
fn with_strict_a_claims_file_is_asked_for() {
    let desk = Desk::new("unaided-strict");
    desk.write("notes.md", "$$ (a+b)^2 = a^2 + 2ab + b^2 $$\n");
    assert_eq!(desk.onshell(&["check", "notes.md"]).code, 0);
    assert_eq!(desk.onshell(&["check", "notes.md", "--strict"]).code, 2);
    desk.write("wrong.md", "$$ (a+b)^2 = a^2 + b^2 $$\n");
    assert_eq!(desk.onshell(&["check", "wrong.md", "--strict"]).code, 1);
}

#[test]
fn every_display_is_counted_and_what_is_not_read_is_said() {
    let notes = "$$ (a+b)^2 = a^2 + 2ab + b^2 $$\n\n$$ a \\otimes f = 0 $$\n\n$$ F = m a \\tag{7} $$\n\n$$ c = 2 b \\tag{7} $$\n";
    let desk = Desk::new("unaided-counted");
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md"]);
    let said = run.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("4 displays, without a claims file: 1 follows, 2 definitions, 1 not read"), "{}", run.out);
}

#[test]
fn a_function_of_a_defined_name_takes_no_other_guess_with_it() {
    let displays = [r"x = u + v", r"g(x) = h", r"F = -V(x) k", r"(a+b)^2 = a^2 + b^2"];
    let (equations, code) = report("function-of-defined", "notes.md", &page(&displays));
    assert_eq!(
        (equations[0]["verdict"].as_str(), equations[3]["verdict"].as_str()),
        (Some("definition"), Some("refuted"))
    );
    assert_eq!(code, 1);
}

#[test]
fn each_row_of_an_align_has_a_verdict_of_its_own() {
    let rows = r"\begin{align}
(a+b)^2 &= a^2 + 2 a b + b^2, \\
\nabla^\mu_\nu f &= 0, \\
(a-b)^2 &= a^2 - 2 a b \\
        &\quad + b^2, \\[2pt]
(a+b)(a-b) &= a^2 + b^2 .
\end{align}
";
    for file in ["notes.md", "notes.tex"] {
        let (equations, code) = report("rows", file, rows);
        let ids: Vec<&str> = equations.iter().filter_map(|equation| equation["id"].as_str()).collect();
        let verdicts: Vec<&str> = equations.iter().filter_map(|equation| equation["verdict"].as_str()).collect();
        assert_eq!(ids, ["L2", "L3", "L4", "L6"], "{file}");
        assert_eq!((verdicts[0], verdicts[2], verdicts[3]), ("certified", "certified", "refuted"), "{file}");
        assert_ne!(verdicts[1], "refuted");
        assert_eq!(code, 1);
    }
}

#[test]
fn rows_that_do_not_stand_alone_stay_one_display() {
    for together in [
        r"\begin{align} x &= 1 \quad\text{if } a > 0 \\ x &= 2 \quad\text{otherwise} \end{align}",
        r"$$ y = a + b \text{ with a word between } z = c $$",
    ] {
        let (equations, _) = report("together", "notes.md", together);
        assert_eq!(equations.len(), 1, "{together}");
    }
}

#[test]
fn the_letter_d_is_a_quantity_where_it_is_no_differential() {
    let (equations, _) = report("letter-d", "notes.md", &page(&[r"(c+d)^2 = c^2 + d^2", r"W = F d \cos\alpha"]));
    assert_eq!(equations[0]["verdict"], "refuted");
    assert_eq!(equations[1]["verdict"], "definition");
    let operator = [r"x = l\sin\theta", r"\frac{d}{dt} x = l\dot\theta\cos\theta", r"W = \int F \, d x"];
    let (equations, code) = report("operator-d", "notes.md", &page(&operator));
    assert_eq!((equations[1]["verdict"].as_str(), code), (Some("certified"), 0));
}

#[test]
fn settings_before_a_page_and_literal_blocks_are_no_displays() {
    let slip = "$$ (a+b)^2 = a^2 + b^2 $$\n";
    for settings in
        ["---\ntitle: \"a $$ b\"\n---\n", "\u{feff}---\r\ntitle: a $$ b\r\n---\r\n", "+++\ntitle = '$$'\n+++\n"]
    {
        let (equations, code) = report("settings", "notes.md", &format!("{settings}\n{slip}"));
        assert_eq!((equations.len(), code), (1, 1), "{settings}");
    }
    let (equations, _) = report("rule", "notes.md", &format!("---\n\n{slip}\n---\n"));
    assert_eq!(equations.len(), 1);
    let rest = ".. math:: (a+b)^2 = a^2 + b^2\n\nCode::\n\n   .. math:: 1 = 2\n\n.. code-block:: rst\n\n   .. math:: 1 = 3\n\nText\n";
    let (equations, code) = report("literal", "notes.rst", rest);
    assert_eq!((equations.len(), code), (1, 1));
}

#[test]
fn a_lagrangian_is_known_by_the_squares_of_its_rates() {
    let lagrangian = r"L = \frac12 \mu \dot r^2 + \frac12 \mu r^2 \dot\varphi^2 + \frac{k}{r}";
    let momentum = r"\ell = \mu r^2 \dot\varphi";
    let last = |name: &str, displays: &[&str]| {
        let (equations, _) = report(name, "notes.md", &page(displays));
        equations.last().expect("a display")["verdict"].clone()
    };
    let radial = r"\mu \ddot r = \frac{\ell^2}{\mu r^3} - \frac{k}{r^2}";
    assert_eq!(last("squares", &[lagrangian, momentum, radial]), "certified");
    let wrong = radial.replace("- \\frac", "+ \\frac");
    assert_eq!(last("squares-wrong", &[lagrangian, momentum, &wrong]), "refuted");
    // An angular momentum is no Lagrangian.
    assert_eq!(last("no-squares", &[r"L = \mu r^2 \dot\varphi", radial]), "assumed");
}

/// Laws, the words after them, and a display of another case, which is true. Each would be one edit from what the laws say.
const OTHER_CASES: [(&[&str], &str, &str); 8] = [
    (&[r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta"], "Linearizing, we get", r"\ddot\theta = -\frac{g}{l}\theta"),
    (
        &[r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta"],
        "For the inverted pendulum, with $\\theta$ measured from the upward vertical, one finds",
        r"\ddot\theta = \frac{g}{l}\sin\theta",
    ),
    (&[r"L = \frac12 m\dot y^2 - m g y"], "With $y$ pointing downward we obtain", r"m\ddot y = m g"),
    (&[r"L = \frac12 m\dot y^2 - m g y"], "Everything changes sign if\nthe axis points down:", r"m\ddot y = m g"),
    (
        &[r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta"],
        "Where the gravity is $g/7$ we get",
        r"\ddot\theta = -\frac{g}{7 l}\sin\theta",
    ),
    (&[r"L = \frac12 m\dot x^2 - \frac12 k x^2"], "For a repulsive spring this becomes", r"m\ddot x = k x"),
    (&[r"a = \frac{v^2}{r}", r"v = \omega r"], "Hence the acceleration, which points inward, is", r"a = -\omega^2 r"),
    (
        &[r"v = v_0 + a t", r"x = v_0 t + \frac12 a t^2"],
        "For a decelerating car this becomes\n\n$$ v = v_0 - a t $$\n\nso the distance follows:",
        r"x = v_0 t - \frac12 a t^2",
    ),
];

#[test]
fn another_case_is_not_called_wrong() {
    for (at, (laws, words, display)) in OTHER_CASES.iter().enumerate() {
        let text = format!("{}\n{words}\n\n$$ {display} $$\n", page(laws));
        let (equations, code) = report(&format!("case-{at}"), "notes.md", &text);
        let wrong: Vec<_> = equations.iter().filter(|equation| equation["verdict"] == "refuted").collect();
        assert!(wrong.is_empty() && code == 0, "{display}: {wrong:?}");
    }
}

/// The same words hide no identity that is wrong in every case.
#[test]
fn an_identity_is_wrong_in_every_case() {
    let text = "Two waves that run in opposite directions add up to\n\n\
        $$ A\\sin(kx - \\omega t) + A\\sin(kx + \\omega t) = 2A\\sin kx\\sin\\omega t $$\n";
    let (equations, code) = report("every-case", "notes.md", text);
    assert_eq!((equations[0]["verdict"].as_str(), code), (Some("refuted"), 1));
}
