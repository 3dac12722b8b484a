//! The advice of a message works: each case shows what is said of a text, and that the text which the message proposes is read. A text
//! that the author did not write is quoted nowhere.

use serde_json::{Value, json};

use crate::support::{Desk, Run};

fn said(run: &Run) -> String {
    format!("{}{}", run.out, run.err)
}

/// What is said with these arguments.
fn onshell(name: &str, arguments: &[&str]) -> (i32, String) {
    let run = Desk::new(&format!("advice-{name}")).onshell(arguments);
    (run.code, said(&run))
}

/// What is said of notes, with claims or without.
fn check(name: &str, notes: &str, claims: &Value) -> String {
    let desk = Desk::new(&format!("advice-{name}"));
    desk.write("notes.md", notes);
    if !claims.is_null() {
        desk.write("notes.json", format!("{claims:#}"));
    }
    said(&desk.onshell(&["check", "notes.md", "--verbose"]))
}

#[test]
fn what_a_formula_should_be_is_written_with_the_letters_of_the_author() {
    for (wrong, says, then) in [
        ("2,5 x", "write 2.5 for the number", "2.5 x"),
        ("asin(x)", "write \\arcsin", "\\arcsin(x)"),
        ("theta", "write \\theta for the letter", "\\theta"),
        ("\\left[ a + b \\right)", "write ] in place of )", "\\left[ a + b \\right]"),
        ("(a+b]c", "write ) in place of ]", "(a+b)c"),
        ("a \\over b", "write {a \\over b}", "{a \\over b}"),
        ("3 x 4", "write x_4, x^4 or 4x", "x_4"),
        ("x²", "write ^2", "x^2"),
        ("√x", "write \\sqrt{x}", "\\sqrt{x}"),
        ("\\sqrt[n]{x}", "write the root as a power, x^{1/n}", "x^{1/n}"),
        ("1e3", "write 1 \\cdot 10^{3}", "1 \\cdot 10^{3}"),
        ("\\vec{F = ma}", "outside of all braces", "\\vec{F} = m\\vec{a}"),
    ] {
        let (code, said) = onshell("read", &["read", wrong]);
        assert!(code != 0 && said.contains(says), "{wrong}: no “{says}” in:\n{said}");
        let (code, said) = onshell("read", &["read", then]);
        assert_eq!(code, 0, "{then}:\n{said}");
    }
}

#[test]
fn formulas_without_letters_are_not_given_ranges() {
    let (_, said) = onshell("equal", &["equal", "(-8)^{1/3}", "--", "-2"]);
    assert!(said.contains("\\sqrt[3]{x}") && !said.contains("--where"), "{said}");
    assert_eq!(onshell("equal", &["equal", "\\sqrt[3]{-8}", "--", "-2"]).0, 0);
    let (_, said) = onshell("equal", &["equal", "\\ln(-x^2 - 1)", "x"]);
    assert!(said.contains("--where"), "{said}");
    let (_, said) = onshell("equal", &["equal", "V = iR", "V"]);
    assert!(said.contains("“=” makes this an equation"), "{said}");
    let (_, said) = onshell("equal", &["equal", "\\int x dx", "x"]);
    assert!(said.contains("an integral without limits has no value") && !said.contains("continu"), "{said}");
    let (_, said) = onshell("equal", &["equal", "\\lim_{x\\to 0} \\frac{\\sin x}{x}", "1"]);
    assert!(said.contains("the limit of a function is not supported"), "{said}");
}

#[test]
fn a_value_is_computed_or_the_reason_is_given() {
    assert_eq!(onshell("eval", &["eval", "\\int_0^1 x\\, dx"]).1.trim(), "0.5");
    for (arguments, says) in [
        (vec!["\\vec v^2", "--set", "v=1"], "v⃗ is a vector"),
        (vec!["\\pi", "--set", "\\pi=3"], "the value of π is fixed"),
        (vec!["3\\,\\text{m}", "--set", "m=2"], "the formula has no letters"),
        (vec!["\\begin{pmatrix}1&2\\\\2&4\\end{pmatrix}^{-1}"], "the determinant 0"),
        (vec!["f(x)", "--set", "x=1"], "f has no formula"),
    ] {
        let all: Vec<&str> = std::iter::once("eval").chain(arguments).collect();
        let (code, said) = onshell("eval", &all);
        assert!(code != 0 && said.contains(says), "{all:?}: no “{says}” in:\n{said}");
    }
    assert_eq!(onshell("plot", &["plot", "heavy_top", "--as", "axis", "--set", "\\dot\\psi=5"]).0, 0);
    assert_eq!(onshell("plot", &["plot", "heavy_top", "--as", "axis", "--set", "\\dot{\\psi}=5"]).0, 0);
    assert_ne!(onshell("plot", &["plot", "heavy_top", "--set", "\\dot q=5"]).0, 0);
}

#[test]
fn a_range_that_is_none_is_followed_by_one_that_works() {
    let with = |range: &str| {
        check("range", "$$ n + n = 2n \\tag{1} $$\n", &json!({ "notes": "notes.md", "constants": { "n": range } }))
    };
    for (wrong, right) in
        [("integer", "integer 1..5"), ("3x3", "3x3 matrix"), (">= 0", "[0, \\infty)"), ("complex number", "complex")]
    {
        let said = with(wrong);
        let quoted = right.replace('\\', "\\\\");
        assert!(said.contains("is not a range") && said.contains(&format!("\"{quoted}\"")), "{wrong}: {said}");
        assert!(with(right).contains("(1)") || with(right).contains("1 certified"), "{right}: {}", with(right));
    }
}

#[test]
fn a_key_of_a_claims_file_says_what_it_takes() {
    let claims = |claim: Value| {
        json!({
            "notes": "notes.md", "system": "simple_pendulum", "coordinates": { "\\theta": "angle" },
            "constants": { "m, l, g": "> 0" }, "means": { "E": "energy" }, "equations": { "1": claim },
        })
    };
    let notes = "$$ E = \\frac12 m l^2\\dot\\theta^2 - m g l\\cos\\theta \\tag{1} $$\n";
    for (name, claim, says) in [
        ("conserved", json!({ "conserved": "yes" }), "write true without quotation marks"),
        ("assume", json!({ "assume": "small angle" }), "“small angle” is not a hypothesis"),
        ("equilibrium", json!({ "equilibrium": "yes" }), "write true without quotation marks"),
        ("skip", json!({ "skip": true }), "write the reason"),
        ("dropping", json!({ "dropping": "m g l" }), "remove \"dropping\""),
        ("same", json!({ "same motion as": "L" }), "\"Lagrangian\""),
    ] {
        let said = check(name, notes, &claims(claim));
        assert!(said.replace('\n', " ").contains(says), "{name}: no “{says}” in:\n{said}");
    }
    let motion = "$$ \\ddot\\theta = -\\frac gl\\sin\\theta \\tag{1} $$\n";
    let said = check("throughout", motion, &claims(json!({ "throughout": "\\dot\\theta = 1" })));
    assert!(said.contains("put it under \"assume\" in place of \"throughout\""), "{said}");
    assert!(check("true", notes, &claims(json!({ "conserved": true }))).contains("1 certified"));
    assert!(check("plain", notes, &claims(json!({}))).contains("certified"));
}

#[test]
fn a_name_that_is_not_declared_leads_to_what_it_is() {
    let turning = json!({
        "notes": "notes.md", "indices": { "a": "1..3" }, "varies with time": { "\\vec\\omega": "any" },
        "axes": { "\\hat e_a": "turning with \\vec\\omega" },
    });
    let notes = "$$ \\frac{d\\hat e_1}{dt} = \\omega_3 \\hat e_2 - \\omega_2 \\hat e_3 \\tag{1} $$\n";
    let said = check("component", notes, &turning);
    assert!(said.contains("for a component of \\vec{\\omega}") && said.contains("under \"components\""), "{said}");
    let mut with = turning;
    with["components"] = json!({ "\\vec{\\omega}": "along \\hat e_a" });
    assert!(check("component-then", notes, &with).contains("certified"));
    // A Lagrangian has coordinates.
    let notes = "$$ L = \\frac12 m\\dot y^2 - m g y \\tag{1} $$\n\n$$ \\ddot y = -g \\tag{2} $$\n";
    let mut claims = json!({ "notes": "notes.md", "constants": { "m, g": "> 0" }, "means": { "L": "Lagrangian" } });
    assert!(check("lagrangian", notes, &claims).contains("add \"y\": \"any\" under \"coordinates\""));
    claims["coordinates"] = json!({ "y": "any" });
    assert!(check("lagrangian-then", notes, &claims).contains("certified"));
    claims["coordinates"] = json!({ "y, z": "any" });
    assert!(check("idle", notes, &claims).contains("the coordinate z does not occur in L"));
    let free = json!({ "notes": "notes.md", "constants": { "m, g": "> 0" }, "coordinates": { "y": "any" } });
    assert!(check("free", notes, &free).contains("nothing determines y"));
    // An index of the right side is summed over.
    let indexed = json!({
        "notes": "notes.md", "indices": { "i": "labels 1..3" }, "constants": { "m_i": "> 0" },
        "varies with time": { "\\vec r_i": "any" },
    });
    let said = check("index", "$$ \\vec p = m_i \\dot{\\vec r}_i \\tag{1} $$\n", &indexed);
    assert!(said.contains("sum over the index, \\sum_{i}"), "{said}");
    let said = check("index-then", "$$ \\vec p = \\sum_i m_i \\dot{\\vec r}_i \\tag{1} $$\n", &indexed);
    assert!(!said.contains("the right side depends"), "{said}");
}

#[test]
fn what_another_format_is_not_read_for_is_said_in_its_own_words() {
    let desk = Desk::new("advice-formats");
    desk.write("a.adoc", "[stem]\n++++\nv = g t\n++++\n");
    desk.write("b.typ", "$ x = foo(y $\n\n$ x = foo $\n");
    for name in ["a.adoc", "b.typ"] {
        let said = said(&desk.onshell(&["check", name, "--verbose"]));
        assert!(!said.contains("\\AsciiMath") && !said.contains("\\Typst"), "{said}");
        assert!(said.contains("this is AsciiMath") || said.contains("is never closed"), "{said}");
    }
    desk.write("a.adoc", ":stem: latexmath\n\n[stem]\n++++\nv = g t\n++++\n");
    assert!(!said(&desk.onshell(&["check", "a.adoc", "--verbose"])).contains("not read"));
    for (name, text) in [("c.md", "\\[ y = 2\n\n\\[ z = 3 \\]\n"), ("d.md", "\\[ y = 2\n")] {
        desk.write(name, text);
        let said = said(&desk.onshell(&["check", name]));
        assert!(said.contains("this `\\[` is never closed") && said.contains(":1:1"), "{said}");
    }
    // A bracket of the prose opens nothing.
    desk.write("e.md", "See \\[1\\] and\n\\[note] this.\n\n\\[ z = 3 \\]\n");
    assert!(!said(&desk.onshell(&["check", "e.md"])).contains("never closed"));
    desk.write("f.md", "So $E = mc^2$ holds.\n");
    assert!(said(&desk.onshell(&["check", "f.md"])).contains("no displayed equation was found"));
}

#[test]
fn small_motion_and_limits_say_what_they_need() {
    let notes = "$$ \\ddot\\theta = -\\frac gl \\theta \\tag{1} $$\n";
    let mut claims = json!({
        "notes": "notes.md", "varies with time": { "\\theta": "angle" }, "constants": { "g, l": "> 0" },
        "laws": { "the motion": "\\ddot\\theta = -\\frac gl\\sin\\theta" },
        "equations": { "1": { "assume": "small oscillations about \\theta = 0" } },
    });
    let said = check("small", notes, &claims);
    assert!(said.contains("small oscillations need a Lagrangian") && !said.contains("refuted"), "{said}");
    claims["equations"] = json!({ "1": { "small": "\\theta" } });
    let said = check("small-then", &notes.replace('=', "\\approx"), &claims);
    assert!(said.contains("verified") || said.contains("certified"), "{said}");
    let root = "$$ \\sqrt{1+x} \\approx 1 + \\frac x3 \\tag{1} $$\n";
    let near = |claim: Value| json!({ "notes": "notes.md", "constants": { "x": "> 0" }, "equations": { "1": claim } });
    assert!(
        check("limit", root, &near(json!({ "limit": "x \\to 0" }))).contains("write \"small\" in place of \"limit\"")
    );
    assert!(check("limit-then", root, &near(json!({ "small": "x" }))).contains("refuted"));
}
