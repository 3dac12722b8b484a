//! The reason that a message gives is the true one: what contradicts, what has no value, at which order two sides differ. Beside each
//! case stands one in which the program must say something else.

use serde_json::{Value, json};

use crate::support::{Desk, Run};

/// The report on notes and claims, or on notes alone, with the white space of its lines as single spaces.
fn check(name: &str, notes: &str, claims: Option<Value>) -> (String, Run) {
    let desk = Desk::new(&format!("reasons-{name}"));
    desk.write("notes.md", notes);
    if let Some(mut claims) = claims {
        claims["notes"] = json!("notes.md");
        desk.write("notes.json", format!("{claims:#}"));
    }
    let run = desk.onshell(&["check", "notes.md", "--verbose"]);
    (format!("{} {}", run.out, run.err).split_whitespace().collect::<Vec<_>>().join(" "), run)
}

/// What is said of one display without a claims file.
fn alone(name: &str, notes: &str) -> String {
    check(name, notes, None).0
}

#[test]
fn hypotheses_that_contradict_each_other_are_named() {
    let notes = "$$ m\\ddot x = -kx \\tag{1} $$\n\n$$ E = \\frac12 m\\dot x^2 + \\frac12 k x^2 \\tag{2} $$\n";
    let found = |name: &str, conserved: Value, assume: &[&str]| {
        let mut claim = json!({ "conserved": conserved });
        if !assume.is_empty() {
            claim["assume"] = json!(assume);
        }
        let claims = json!({
            "constants": { "m, k": "> 0" }, "varies with time": { "x": "any" }, "laws": { "Newton": "1" },
            "equations": { "2": claim },
        });
        check(name, notes, Some(claims)).0
    };
    let said = found("contradiction", json!(true), &["x > 1", "x < 0"]);
    assert!(said.contains("no state was found that obeys “x > 1”") && said.contains("and “x < 0”"), "{said}");
    assert!(!said.contains("constant for any motion"), "{said}");
    // A range is contradicted, and not the law.
    let said = found("massless", json!(true), &["m = 0"]);
    assert!(said.contains("contradicts the declared range of m") || said.contains("only one value of x"), "{said}");
    // The twins: one of the hypotheses alone, and what is constant for any motion.
    assert!(found("one", json!(true), &["x > 1"]).contains("constant on shell"));
    assert!(found("trivial", json!("x - x"), &[]).contains("constant for any motion"));
}

#[test]
fn a_number_outside_of_its_range_is_named() {
    let notes = "$$ a = b \\tag{1} $$\n";
    let found = |name: &str, assume: &str| {
        let claims =
            json!({ "constants": { "a, b": "(2, 5)" }, "equations": { "1": { "assume": [assume, "a b = 6"] } } });
        check(name, notes, Some(claims)).0
    };
    let said = found("outside", "a = 1");
    assert!(said.contains("“a = 1”") && said.contains("contradicts the declared range of a"), "{said}");
    assert!(!found("inside", "a = 2.5").contains("contradicts the declared range"));
}

#[test]
fn numbers_agree_to_the_printed_digits_or_nearly() {
    let with = |name: &str, power: &str| {
        alone(
            name,
            &format!(
                "The energy is $E = 9\\,\\mathrm{{J}}$.\n\n$$ P = \\frac{{E}}{{4\\,\\mathrm{{s}}}} = {power}\\,\\mathrm{{W}} $$\n"
            ),
        )
    };
    let said = with("digits", "2.3");
    assert!(said.contains("the numbers agree with the formula to the printed digits, for E = 9 J"), "{said}");
    assert!(with("nearly", "2.260").contains("to one part in a hundred"));
    assert!(!with("far", "2.9").contains("the numbers agree"));
}

#[test]
fn a_letter_without_a_value_is_named_and_so_are_units_that_do_not_fit() {
    let with = |name: &str, display: &str| {
        let notes = format!(
            "The mass is $m = 2\\,\\mathrm{{kg}}$, and the speed $v = 3\\,\\mathrm{{m/s}}$.\n\n$$ {display} $$\n"
        );
        alone(name, &notes)
    };
    let said = with("units", "p = m v = 6\\,\\mathrm{N}");
    assert!(said.contains("the units do not fit: for m = 2 kg, v = 3 m s⁻¹, the formula is in kg m s⁻¹"), "{said}");
    assert!(!said.contains("give no value"), "{said}");
    let said = with("letter", "\\lambda = \\frac{h}{m v} = 1.1\\cdot 10^{-34}\\,\\mathrm{m}");
    assert!(said.contains("the notes before it give no value for h"), "{said}");
    let said = with("fits", "p = m v = 6\\,\\mathrm{kg\\,m/s}");
    assert!(said.contains("the numbers agree with the formula"), "{said}");
}

#[test]
fn the_order_at_which_an_approximation_fails_is_said() {
    let said = alone("cubic", "$$ \\sin x \\approx x + \\frac{x^3}{6} $$\n");
    assert!(said.contains("the two sides differ at order x^3 for small x"), "{said}");
    assert!(!said.contains("do not agree as x"), "{said}");
    let said = alone("quadratic", "$$ \\cos x \\approx 1 + \\frac{x^2}{2} $$\n");
    assert!(said.contains("the two sides differ at order x^2 for small x"), "{said}");
    assert!(!alone("right", "$$ \\sin x \\approx x - \\frac{x^3}{6} $$\n").contains("differ"));
}

#[test]
fn what_holds_on_one_branch_says_where_and_has_no_counterexample() {
    // The range of x is any, since x stands in a display where it may have each sign.
    let any =
        "$$ 1 - \\cos x = 2 \\sin^2 \\frac{x}{2} $$\n\n$$ \\tan\\frac{x}{2} = \\frac{\\sin x}{1 + \\cos x} $$\n\n";
    let of = |name: &str, value: &str| alone(name, &format!("{any}$$ \\arctan x + \\arctan\\frac1x = {value} $$\n"));
    let said = of("branch", "\\frac{\\pi}{2}");
    assert!(said.contains("verified holds only where x > 0, because"), "{said}");
    assert!(!said.contains("left side"), "{said}");
    // The twin: what fails everywhere is not said to hold.
    assert!(!of("no-branch", "\\pi").contains("holds only where"));
}

#[test]
fn no_letter_is_proposed_as_small_unless_it_is_the_only_one() {
    let claims = json!({ "constants": { "m, v, c, E": "> 0" } });
    let (said, _) = check("letters", "$$ E \\approx m c^2 + \\frac12 m v^2 \\tag{1} $$\n", Some(claims));
    assert!(said.contains(r#"{ "1": { "small": "…" } }"#) && !said.contains(r#""small": "m""#), "{said}");
    let claims = json!({ "constants": { "x": "any" } });
    let (said, _) = check("letter-alone", "$$ \\sin x \\approx x \\tag{1} $$\n", Some(claims));
    assert!(said.contains(r#"{ "1": { "small": "x" } }"#), "{said}");
}

#[test]
fn no_solution_is_named_where_none_is_printed() {
    let claims = json!({
        "formulas as names": { "\\nabla\\cdot\\vec{B}": "varies with time" }, "varies with time": { "\\vec B": "any" },
    });
    let (said, _) = check("no-solution", "$$ \\nabla \\cdot \\vec B = 0 \\tag{1} $$\n", Some(claims));
    assert!(!said.contains("solution in"), "{said}");
    assert!(said.contains("refuted"), "{said}");
}

#[test]
fn a_value_that_is_too_large_is_no_division_by_zero() {
    let desk = Desk::new("reasons-large");
    let said = |formula: &str| {
        let run = desk.onshell(&["eval", formula]);
        assert_ne!(run.code, 0, "{formula}: {}", run.out);
        format!("{} {}", run.out, run.err).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    for large in ["10^{400}", "10^{200}\\cdot 10^{200}", "\\cosh(1000)"] {
        let said = said(large);
        assert!(said.contains("too large to compute with") && !said.contains("denominator"), "{said}");
    }
    for without in ["\\frac{1}{2-2}", "\\sqrt{-1}", "\\ln 0"] {
        let said = said(without);
        assert!(said.contains("has no real value") && !said.contains("too large"), "{said}");
    }
}

#[test]
fn no_suggestion_repeats_a_definition() {
    let notes = "$$ E = \\frac12 m\\dot x^2 + \\frac12 k x^2 \\tag{1} $$\n\n$$ m\\ddot x = -kx \\tag{2} $$\n";
    let claims = json!({ "constants": { "m, k": "> 0" }, "varies with time": { "x": "any" } });
    let (said, run) = check("definition", notes, Some(claims.clone()));
    assert!(run.code == 1 && !said.contains("\\dot{E}"), "{said}");
    // The twin: a term that is missing is found.
    let notes =
        "$$ E = \\frac12 m\\dot x^2 + \\frac12 k x^2 \\tag{1} $$\n\n$$ 2E - m \\dot x^2 = 2 k x^2 \\tag{2} $$\n";
    let (said, _) = check("definition-term", notes, Some(claims));
    assert!(said.contains("did you mean"), "{said}");
}

#[test]
fn of_an_inequality_the_relation_may_be_reversed_and_no_number_is_added() {
    let claims = || json!({ "constants": { "a, b, v, c": "> 0", "x": "any" } });
    let (said, run) = check("no-number", "$$ e^x > 1 + x \\tag{1} $$\n\n$$ v < c \\tag{2} $$\n", Some(claims()));
    assert!(run.code == 1 && !said.contains("did you mean"), "{said}");
    let (said, _) = check("reversed", "$$ \\sqrt{a b} \\ge \\frac{a + b}{2} \\tag{1} $$\n", Some(claims()));
    assert!(said.contains("did you mean “\\le” in place of “\\ge”?"), "{said}");
}

#[test]
fn a_law_that_nothing_states_is_advised_under_laws() {
    let claims = || json!({ "constants": { "p, V, n, R, T, a, b": "> 0" } });
    let (said, _) = check("gas", "$$ p V = n R T \\tag{1} $$\n", Some(claims()));
    assert!(said.contains(r#"if it is a law, list it under "laws": { "…": "1" }"#), "{said}");
    // The twin: a false identity in the same letters is no law.
    let (said, run) = check("identity", "$$ (a + b)^2 = a^2 + b^2 \\tag{1} $$\n", Some(claims()));
    assert!(run.code == 1 && !said.contains("if it is a law"), "{said}");
}

#[test]
fn a_missing_pair_of_dollar_signs_is_shown_where_it_is_missing() {
    let said = alone("dollars", "Text\n\n$$ a = b\n\nMore\n\n$$ c = d $$\n\nAnd\n\n$$ e = f $$\n");
    assert!(said.contains("a `$$` is missing") && said.contains("notes.md:3:1"), "{said}");
    assert!(said.contains("begins in line 3, is the first with a blank line"), "{said}");
    let said = alone("dollars-last", "Text\n\n$$ a = b $$\n\nMore\n\n$$ c = d\n");
    assert!(said.contains("this `$$` is never closed") && said.contains("notes.md:7:1"), "{said}");
}

#[test]
fn what_is_not_read_is_shown_with_a_mark_under_the_place() {
    let desk = Desk::new("reasons-mark");
    desk.write("notes.md", "$$ F = m a) $$\n\n$$ p = m v $$\n");
    let run = desk.onshell(&["check", "notes.md", "--verbose"]);
    assert!(run.out.contains("      $$ F = m a) $$\n                ^\n"), "{}", run.out);
    assert_eq!(run.out.matches('^').count(), 1, "{}", run.out);
}

#[test]
fn two_relation_signs_an_open_environment_and_a_tilde_are_called_so() {
    let desk = Desk::new("reasons-syntax");
    let said = |formula: &str| {
        let run = desk.onshell(&["read", formula]);
        format!("{} {}", run.out, run.err).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert!(said("a = b == c").contains("two relation signs stand side by side"));
    assert!(!said("a = b = c").contains("side by side"));
    assert!(said("\\begin{aligned} a &= b").contains("add \\end{aligned} where it ends"));
    assert!(said("\\int x dx").ends_with("assumed to be real numbers: x"));
    assert!(alone("tilde", "$$ a \\sim b $$\n").contains("∼ is not supported; write = or \\approx"));
}

#[test]
fn a_hand_in_with_a_line_that_is_not_read_is_not_called_right() {
    let desk = Desk::new("reasons-hand-in");
    desk.write("problem.md", "$$ E = \\frac12 m v^2 \\tag{1} $$\n\n$$ v = \\sqrt{\\frac{2E}{m}} \\tag{2} $$\n");
    desk.write("problem.json", r#"{ "notes": "problem.md", "constants": { "m, v": "> 0" } }"#);
    desk.write("unread.md", "$$ v = \\sqrt{\\frac{2E}{m}} $$\n\n$$ v = \\sqrt{2E(m $$\n");
    desk.write("read.md", "$$ v = \\sqrt{\\frac{2E}{m}} $$\n");
    let said = |file: &str| {
        let run = desk.onshell(&["mark", file, "--claims", "problem.json", "--hints", "0"]);
        format!("{} {}", run.out, run.err).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let unread = said("unread.md");
    assert!(unread.contains("no mistake was found, but 1 line could not be read; check it by hand"), "{unread}");
    let read = said("read.md");
    assert!(read.contains("no mistake was found") && !read.contains("could not be read"), "{read}");
}

#[test]
fn a_step_that_builds_on_two_mistakes_names_both() {
    let desk = Desk::new("reasons-two-mistakes");
    desk.write("problem.md", PROBLEM);
    desk.write(
        "problem.json",
        r#"{ "notes": "problem.md", "constants": { "m, g, h, \\mu": "> 0", "\\alpha": "(0.5, 1.4)" } }"#,
    );
    let said = |name: &str, sign: &str| {
        let (first, last) =
            (format!("g (\\sin\\alpha {sign} \\mu \\cos\\alpha)"), format!("2 g h (\\tan\\alpha {sign} \\mu)"));
        let lines = [format!("a = {first}"), "s = h / \\cos\\alpha".to_owned(), format!("v^2 = 2 a s = {last}")];
        desk.write(name, lines.map(|line| format!("$$ {line} $$\n")).concat());
        let run = desk.onshell(&["mark", name, "--claims", "problem.json"]);
        format!("{} {}", run.out, run.err).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let both = said("both.md", "+");
    assert!(both.contains("builds on the mistakes in line 1 and line 2"), "{both}");
    let one = said("one.md", "-");
    assert!(one.contains("builds on the mistake in line 2"), "{one}");
}

/// A body that slides down with friction.
const PROBLEM: &str = r"# Problem: block on a wedge

A block of mass $m$ slides down a plane of angle $\alpha$ with friction coefficient $\mu$ from the height $h$.

$$ a = g (\sin\alpha - \mu \cos\alpha) \tag{1} $$

$$ s = \frac{h}{\sin\alpha} \tag{2} $$

$$ v = \sqrt{2 a s} \tag{3} $$

$$ v^2 = 2 g h (1 - \mu \cot\alpha) \tag{4} $$
";
