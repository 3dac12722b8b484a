//! Names: used before they are introduced, introduced by a correction, cited by number, and of one unit.

use onshell::check::Verdict::{Definition, Refuted, Undecided, Unreadable, Verified};
use onshell::check::{Document, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, numbers, outcome, with};

fn check(claims: &Json, displays: &[&str]) -> Document {
    let found = document(claims, &numbered(displays), &Registry::standard(), None);
    found.unwrap_or_else(|error| panic!("{displays:?}: {error}"))
}

fn verdicts(claims: &Json, displays: &[&str]) -> Vec<Verdict> {
    check(claims, displays).equations.iter().map(|equation| outcome(&equation.finding)).collect()
}

#[test]
fn a_name_is_known_before_the_display_that_introduces_it() {
    let displays = |product: &str| verdicts(&numbers(), &[product, "p = a + b"]);
    assert_eq!(displays("ap = a^2 + ab"), [Verified, Definition]);
    assert_eq!(displays("ap = a^2 - ab")[0], Refuted);
    assert_eq!(verdicts(&numbers(), &["ap = a^2 + ab"]), [Unreadable]);
}

#[test]
fn a_name_that_a_statement_introduces_may_stand_twice_in_it() {
    let holds = check(&numbers(), &["p = a + b = p", "ap = a^2 + ab"]);
    assert!(holds.equations.iter().all(|equation| equation.ok), "{:?}", holds.equations);
    assert_eq!(outcome(&holds.equations[1].finding), Verified);
    assert_eq!(verdicts(&numbers(), &["p = a + b = p", "ap = a^2 - ab"])[1], Refuted);
    assert_eq!(verdicts(&numbers(), &["p = a + b = p = a - b"])[0], Refuted);
    // The names after the second one are the symbols that they print.
    let more = |q: &str| verdicts(&numbers(), &["p = a + b = p = q", q]);
    assert_eq!(more("aq = a^2 + ab")[1], Verified);
    assert_eq!(more("aq = a^2 - ab")[1], Refuted);
    // As two terms, or as itself and its square, the name is not clear.
    for unclear in ["p = a + b \\equiv p + q", "p = a + b = a + b \\equiv q + p"] {
        assert_eq!(verdicts(&numbers(), &[unclear])[0], Unreadable, "{unclear}");
    }
}

#[test]
fn the_prose_may_define_a_name_through_one_that_a_display_introduces() {
    let claims = with(&numbers(), "define", json!({ "q": "p^2" }));
    assert_eq!(verdicts(&claims, &["q = a^2 + 2ab + b^2", "p = a + b"]), [Verified, Definition]);
    assert_eq!(verdicts(&claims, &["q = a^2 + 2ab + b^2", "p = a - b"])[0], Refuted);
}

#[test]
fn names_that_stand_on_each_other_are_refused() {
    let circular = check(&numbers(), &["p = q + a", "q = p + b", "p + q = a"]);
    assert!(circular.equations.iter().any(|equation| !equation.ok));
    assert!(circular.equations.iter().all(|equation| !equation.finding.verdict.holds()));
}

/// The first display has an erratum whose correction introduces p.
fn corrected(printed: &str, read: &str, second: &str) -> Document {
    let erratum = json!({ "1": { "erratum": { "for": "a =", "read": read } } });
    check(&with(&numbers(), "equations", erratum), &[printed, second])
}

#[test]
fn a_correction_may_introduce_a_name() {
    let found = corrected("a = b + c", "p =", "bp = b^2 + bc");
    assert!(found.equations.iter().all(|equation| equation.ok), "{:?}", found.equations);
    assert_eq!(outcome(&found.equations[1].finding), Verified);
    // A slip in what is corrected shows in what stands on it.
    let slipped = corrected("a = b - c", "p =", "bp = b^2 + bc");
    assert_eq!(slipped.equations[1].finding.verdict, Refuted);
    // What is not named by the correction is not known.
    let other = corrected("a = b + c", "q =", "bp = b^2 + bc");
    assert_eq!(other.equations[1].finding.verdict, Unreadable);
}

#[test]
fn an_erratum_is_wrong_as_printed() {
    // a = b c is false, and p = b c names it; b = b is not.
    assert!(corrected("a = b c", "p =", r"\frac{p}{b} + p = c + bc").equations[0].ok);
    let erratum = json!({ "2": { "erratum": { "for": "p", "read": "q" } } });
    let right = check(&with(&numbers(), "equations", erratum), &["p = a + b", "p = a + b"]);
    assert!(!right.equations[1].ok, "{:?}", right.equations[1]);
}

/// The verdict on a sentence that cites a number.
fn cites(number: &str, formula: &str) -> Verdict {
    let notes = format!("The square is in it.\n\n{}", numbered(&["(a + b)^2 = a^2 + 2ab + b^2", "a + b = b + a"]));
    let sentence = json!([{ "quote": "The square is in it.", "refers to": number, "containing": formula }]);
    let claims = with(&numbers(), "sentences", sentence);
    let found = document(&claims, &notes, &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"));
    outcome(&found.sentences[0].finding)
}

#[test]
fn a_citation_is_of_an_equation_that_contains_what_is_meant() {
    assert_eq!(cites("1", "(a + b)^2"), Verified);
    assert_eq!(cites("2", "(a + b)^2"), Refuted);
    assert_eq!(cites("2", "a + b"), Verified);
    assert_eq!(cites("1", "c"), Refuted);
    // It may cite what these notes do not have.
    assert_ne!(cites("7", "(a + b)^2"), Verified);
}

#[test]
fn what_is_introduced_twice_is_tested() {
    assert_eq!(verdicts(&numbers(), &["p = a + b", "p = b + a"]).last(), Some(&Verified));
    assert_eq!(verdicts(&numbers(), &["p = a + b", "p = b - a"]).last(), Some(&Refuted));
}

#[test]
fn units_of_families_and_of_what_stands_on_them() {
    let claims = json!({
        "indices": { "i": "1..n" },
        "varies with time": { r"\vec r_i": "any" },
        "constants": { "m_i": "> 0" },
        "units": { "m_i": "kg", r"\vec r_i": "m" },
    });
    let mass = r"M = \sum_i m_i";
    let mean = |latex: &str| {
        let found = verdicts(&claims, &[mass, r"\vec r_{cm} = \frac{1}{M} \sum_i m_i \vec r_i", latex]);
        *found.last().unwrap()
    };
    assert_eq!(mean(r"M \vec r_{cm} = \sum_i m_i \vec r_i"), Verified);
    // These two do not even have the units for it.
    assert_eq!(mean(r"\vec r_{cm} = \sum_i m_i \vec r_i"), Unreadable);
    assert_eq!(mean(r"M \vec r_{cm} = \sum_i m_i \dot{\vec r}_i"), Unreadable);
    // This one has.
    assert_eq!(mean(r"M \vec r_{cm} = 2 \sum_i m_i \vec r_i"), Refuted);
}

#[test]
fn a_definition_that_nothing_uses_is_no_pass() {
    assert_eq!(verdicts(&numbers(), &["p = a + b"]), [Undecided]);
}

#[test]
fn a_definition_in_other_words_pins_nothing() {
    let claims = with(&numbers(), "constants", json!({ "a, b, c, d": "> 0", r"\vec u": "any" }));
    let first = |displays: &[&str]| verdicts(&claims, displays)[0];
    for (definition, again) in [
        (r"v = \frac{a}{b}", "a = v b"),
        (r"v = \frac{a - c}{b}", "a = c + v b"),
        (r"v = \sqrt{\frac{a}{b}}", "b v^2 = a"),
        (r"v = \frac12 a b^2", r"b = \sqrt{\frac{2v}{a}}"),
        ("v = a + b - c", "2a - 2v = 2c - 2b"),
        (r"v = \frac{a}{b + c}", "v b + v c = a"),
        (r"\vec v = a \vec u", r"\vec u = \frac{\vec v}{a}"),
    ] {
        let found = check(&claims, &[definition, again]);
        let finding = &found.equations[0].finding;
        assert_eq!(finding.verdict, Undecided, "{definition}, {again}: {}", finding.message);
        assert!(finding.message.contains("(2) only repeats the definition"), "{}", finding.message);
        assert_eq!(outcome(&found.equations[1].finding), Verified, "{again}");
    }
    // Beside an equation that takes a step it does no harm; and what takes a step pins.
    assert_eq!(first(&["v = a + b", "a = v - b", "v(a - b) = a^2 - b^2"]), Definition);
    assert_eq!(first(&["v = a + b", "c v = ca + cb"]), Definition);
    assert_eq!(first(&["v = a - b", "v(a - b) = a^2 - b^2"]), Undecided);
}

#[test]
fn a_sentence_that_says_a_definition_again_pins_nothing() {
    let pinned = |claim: &str| {
        let sentences = json!([{ "quote": "So it is.", "claim": claim }]);
        let notes = format!("{}So it is.\n", numbered(&[r"v = \frac{a}{b}"]));
        let claims = with(&numbers(), "sentences", sentences);
        let found = document(&claims, &notes, &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"));
        found.equations[0].finding.verdict
    };
    assert_eq!(pinned("a = v b"), Undecided);
    assert_eq!(pinned("v^2 + v = \\frac{a^2 + a b}{b^2}"), Definition);
}

#[test]
fn members_of_a_family_are_defined_again_by_other_letters() {
    let claims = json!({ "indices": { "i, j": "1..n" }, "constants": { "m_i": "> 0", r"\vec v_i": "any" } });
    let first = |again: &str| verdicts(&claims, &[r"\vec p_i = m_i \vec v_i", again])[0];
    assert_eq!(first(r"\vec v_j = \frac{\vec p_j}{m_j}"), Undecided);
    assert_eq!(first(r"\sum_i \vec p_i = \sum_i m_i \vec v_i"), Definition);
}

#[test]
fn what_does_not_hold_pins_no_definition() {
    let found = check(&numbers(), &["s = a + b", "s(a - b) = a^2 + b^2"]);
    assert_eq!(found.equations[0].finding.verdict, Undecided);
    assert!(found.equations[0].finding.message.contains("no passing equation uses"), "{:?}", found.equations[0]);
    assert_eq!(verdicts(&numbers(), &["s = a + b", "s(a - b) = a^2 - b^2"]), [Definition, Verified]);
}

#[test]
fn a_factor_that_nothing_would_notice_leaves_a_definition_loose() {
    let claims = json!({ "varies with time": { "x": "any" } });
    let first = |user: &str| check(&claims, &[r"q = x + \dot x", user]).equations.remove(0).finding;
    let ratio = first(r"\frac{\dot q}{q} = \frac{\dot x + \ddot x}{x + \dot x}");
    assert_eq!(ratio.verdict, Undecided, "{}", ratio.message);
    assert!(ratio.message.contains("with “2 (x + "), "{}", ratio.message);
    assert_eq!(first(r"q^2 = x^2 + 2x \dot x + \dot x^2").verdict, Definition);
}

#[test]
fn what_is_undecided_as_printed_is_no_misprint() {
    let erratum = |printed: &str, wrong: &str, read: &str| {
        let erratum = json!({ "1": { "erratum": { "for": wrong, "read": read } } });
        let equation = check(&with(&numbers(), "equations", erratum), &[printed]).equations.remove(0);
        (equation.finding.verdict, equation.ok)
    };
    // Both sides are one formula, which is not wrong.
    assert_eq!(erratum("ab = ab", "ab =", "ba ="), (Undecided, false));
    assert_eq!(erratum("2ab = ab", "2ab =", "ba ="), (Refuted, true));
}

#[test]
fn a_definition_differentiated_pins_nothing() {
    let claims = json!({ "constants": { "m, k": "> 0" }, "varies with time": { "x": "any" }, "laws": { "the spring": r"m \ddot x = -k x" } });
    for (definition, again) in [
        (r"p = 2m\dot x", r"\dot p = 2m\ddot x"),
        (r"p = 2m\dot x", r"\ddot x = \frac{\dot p}{2m}"),
        (r"p = 2m\dot x", r"\frac{d}{dt} p = 2m\ddot x"),
        (r"q = \frac12 m \dot x^2", r"\dot q = m \dot x \ddot x"),
    ] {
        let found = check(&claims, &[definition, again]);
        let finding = &found.equations[0].finding;
        assert_eq!(finding.verdict, Undecided, "{definition}, {again}: {}", finding.message);
        assert!(finding.message.contains("(2) only repeats the definition"), "{}", finding.message);
        assert_eq!(outcome(&found.equations[1].finding), Verified, "{again}");
    }
    // The twins: what says more of the rate pins, at the end of a chain too.
    assert_eq!(verdicts(&claims, &[r"p = m\dot x", r"\dot p = -k x"])[0], Definition);
    assert_eq!(verdicts(&claims, &[r"p = m\dot x", r"\dot p = m\ddot x = -k x"])[0], Definition);
    assert_eq!(verdicts(&claims, &[r"p = 2m\dot x", r"\dot p = -k x"]), [Undecided, Refuted]);
}

#[test]
fn definitions_in_a_circle_are_an_error() {
    let circular = |define: Json| {
        let claims = with(&with(&numbers(), "define", define), "notes", json!("notes.md"));
        document(&claims, &numbered(&["A = a", "B = A + 1"]), &Registry::standard(), None).map(|_| ())
    };
    for define in [json!({ "A": "B", "B": "A" }), json!({ "A": "A + 1" }), json!({ "A": "2B", "B": "C^2", "C": "a A" })]
    {
        let error = circular(define.clone()).unwrap_err().to_string();
        assert!(error.starts_with("claims.json:") && error.contains("is defined by itself"), "{define}: {error}");
    }
    // The twin: one after the other is no circle, in whatever order.
    assert!(circular(json!({ "A": "B", "B": "a" })).is_ok());
}

#[test]
fn a_function_of_the_time_is_introduced_with_it_and_d_and_e_with_an_index() {
    let moving = json!({ "constants": { "a, b, c": "> 0" } });
    let displays = |velocity: &str| verdicts(&moving, &["x(t) = a + b t", velocity]);
    assert_eq!(displays(r"\dot x^2 = b \dot x")[1], Verified);
    assert_eq!(displays(r"\dot x(t)^2 = b \dot x")[1], Verified);
    assert_eq!(displays(r"\dot x = a")[1], Refuted);
    assert_eq!(verdicts(&moving, &["d_{11} = a + b", "c d_{11} = a c + b c"]), [Definition, Verified]);
    assert_eq!(verdicts(&moving, &["d_{11} = a + b", "c d_{11} = a c - b c"])[1], Refuted);
    // The twins: a place that is no time, and names that mean something.
    assert_eq!(verdicts(&moving, &["x(a) = a + b", "x = b"])[0], Unreadable);
    assert_eq!(verdicts(&moving, &["a + b = d", "a + b = e"]), [Unreadable, Unreadable]);
    // A display that begins with d defines it, and a slip with it is found.
    assert_eq!(verdicts(&moving, &["d = a + b", "c d = a c + b c"]), [Definition, Verified]);
    assert_eq!(verdicts(&moving, &["d = a + b", "c d = a c - b c"])[1], Refuted);
    // Then an upright d is a derivative, and an italic one beside the time may be either.
    let rate = |d: &str| verdicts(&moving, &["d = a + b", "x(t) = d t", &format!(r"\frac{{{d} x}}{{{d} t}} = a + b")]);
    assert_eq!(rate(r"\mathrm{d}")[2], Verified);
    assert_eq!(rate("d")[2], Unreadable);
    let second = r"\frac{\mathrm{d}^2 x}{\mathrm{d} t^2} = 0";
    assert_eq!(verdicts(&moving, &["d = a + b", "x(t) = d t", second])[2], Verified);
    // A display that begins with e defines it; one that begins with its square says something of the number.
    assert_eq!(verdicts(&moving, &["e = a + b", "c e = a c + b c"]), [Definition, Verified]);
    assert_eq!(verdicts(&moving, &["e^2 = a + b"])[0], Unreadable);
}

#[test]
fn the_word_for_a_matrix_has_no_names_in_it() {
    let claims = json!({ "constants": { "a, b": "> 0" } });
    let blamed = check(&claims, &[r"\begin{pmatrix} a & q \end{pmatrix} = b", "a i = b"]);
    let message = &blamed.equations[1].finding.message;
    assert!(!message.contains("where it stands"), "{message}");
    // The twin: a name that stands in what cannot be read.
    let blamed = check(&claims, &[r"s = a \foo + b", "a s = 2b"]);
    let message = &blamed.equations[1].finding.message;
    assert!(message.contains("its definition may be in (1)"), "{message}");
}

#[test]
fn a_constant_has_no_dot() {
    let found = |role: &str| {
        let mut claims = json!({ "constants": { "g": "> 0" }, "varies with time": { r"\theta": "angle" } });
        claims[role]["l"] = json!("> 0");
        let display = r"\frac{d}{dt} (l \dot\theta) = \dot l \dot\theta + l \ddot\theta";
        document(&claims, &numbered(&[display]), &Registry::standard(), None).unwrap().equations[0].finding.clone()
    };
    let constant = found("constants");
    assert_eq!(constant.verdict, Verdict::Unreadable);
    assert!(constant.message.contains("a dot on l"), "{}", constant.message);
    assert_eq!(found("varies with time").verdict, Verdict::Certified);
}

#[test]
fn a_hat_marks_a_direction_and_no_number() {
    let display = r"\hat n \times (\hat n \times \vec r) = (\hat n \cdot \vec r) \hat n - \vec r";
    let check = |vector: &str| {
        let claims = json!({ "constants": { vector: "any", r"\vec r": "any" } });
        document(&claims, &numbered(&[display]), &Registry::standard(), None)
    };
    let error = check(r"\hat n").map(|_| ()).unwrap_err().to_string();
    assert!(error.contains(r"declare \vec n"), "{error}");
    assert_eq!(check(r"\vec n").unwrap().equations[0].finding.verdict, Verdict::Certified);
}

#[test]
fn a_formula_as_a_name_may_be_given_by_a_display() {
    let claims = with(&numbers(), "formulas as names", json!({ "\\langle a^2 \\rangle": "given by a display" }));
    let mean = r"\langle a^2 \rangle = a^2 + b^2";
    assert_eq!(verdicts(&claims, &[mean, r"\langle a^2 \rangle - 2ab = (a - b)^2"]), [Definition, Verified]);
    assert_eq!(verdicts(&claims, &[mean, r"\langle a^2 \rangle - ab = (a - b)^2"])[1], Refuted);
    // No display gives it.
    assert_eq!(verdicts(&claims, &[r"\langle a^2 \rangle - 2ab = (a - b)^2"]), [Unreadable]);
}

#[test]
fn a_formula_may_stand_for_one_name() {
    let named = |kind: &str| with(&numbers(), "formulas as names", json!({ "\\langle a^2 \\rangle": kind }));
    let displays = |claims: &Json, sign: &str| {
        verdicts(claims, &["p = b + \\langle a^2 \\rangle", &format!("ap = ab {sign} a\\langle\\, {{a^2}} \\rangle")])
    };
    assert_eq!(displays(&named("constant"), "+"), [Definition, Verified]);
    assert_eq!(displays(&named("constant"), "-")[1], Refuted);
    // Another formula is another quantity, and has no value.
    assert_eq!(verdicts(&named("constant"), &["2\\langle a^3 \\rangle = b"]), [Unreadable]);
    // A vector cannot be added to a number.
    assert_eq!(displays(&named("constant vector"), "+")[0], Unreadable);
    // A sum reaches to the end of its term.
    let sum = with(&numbers(), "formulas as names", json!({ "\\sum_i a_i": "constant" }));
    assert_eq!(verdicts(&sum, &["\\sum_i a_i + b = b + \\sum_i a_i"]), [Verified]);
    assert_eq!(verdicts(&sum, &["\\sum_i a_i b = b \\sum_i a_i"]), [Unreadable]);
}

#[test]
fn a_distance_for_which_the_notes_give_equations_is_defined_by_its_formula() {
    let claims = json!({
        "coordinates": { "x_1, x_2": "any" },
        "constants": { "m, k, l": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let notes = |words: &str, law: &str| {
        let lagrangian = r"L = \frac12 m(\dot x_1^2 + \dot x_2^2) - \frac12 k(x_1 - x_2 - l)^2";
        format!("$$ {lagrangian} \\tag{{1}} $$\n\n{words}\n\n$$ {law} \\tag{{2}} $$\n")
    };
    let found = |words: &str, law: &str| {
        let document = document(&claims, &notes(words, law), &Registry::standard(), Some("2")).expect("the claims fit");
        outcome(&document.equations[0].finding)
    };
    let (law, slip) = (r"m\ddot r = -2k(r - l)", r"m\ddot r = -k(r - l)");
    assert_eq!(found("For the distance $r = x_1 - x_2$ we get", law), Verified);
    assert_eq!(found("For the distance $r = x_1 - x_2$ we get", slip), Refuted);
    assert_eq!(found("For the distances $s = x_2$ and $r = x_1 - x_2$ we get", law), Verified);
    // What may be a case is taken where the display passes with it, and refutes nothing.
    assert_eq!(found("For $r = x_1 - x_2$ we get", law), Verified);
    assert_eq!(found("For $r = x_1 - x_2$ we get", slip), Unreadable);
    assert_eq!(found("At the distance $r = x_1 - x_2$ we get", law), Verified);
    assert_eq!(found("At the distance $r = x_1 - x_2$ we get", slip), Unreadable);
    assert_eq!(found("For the distance $r = 2l$ we get", "k r = 2 k l"), Verified);
    assert_eq!(found("For the distance $r = 2l$ we get", "k r = k l"), Unreadable);
}
