//! What the messages say: what is wrong, where, why, and what to write. Where a message gives a line for the claims file,
//! the line is put there, and helps.

use serde_json::{Value, json};

use crate::support::{Desk, Run};

/// Claims about numbers, with further keys.
fn numbers(more: Value) -> Value {
    merged(json!({ "notes": "notes.md", "constants": { "a, b, c": "> 0", "x": "any" } }), more)
}

/// Claims about a pendulum, with further keys.
fn pendulum(more: Value) -> Value {
    let claims = json!({
        "notes": "notes.md",
        "system": "simple_pendulum",
        "coordinates": { "\\theta": "angle" },
        "constants": { "m, l, g": "> 0" },
        "means": { "E": "energy" },
    });
    merged(claims, more)
}

fn merged(mut claims: Value, more: Value) -> Value {
    for (key, value) in more.as_object().expect("an object") {
        claims[key] = value.clone();
    }
    claims
}

/// A folder with notes and claims.
fn desk(name: &str, notes: &str, claims: &Value) -> Desk {
    let desk = Desk::new(&format!("messages-{name}"));
    desk.write("notes.md", notes);
    desk.write("notes.json", format!("{claims:#}"));
    desk
}

/// The report on notes and claims.
fn check(name: &str, notes: &str, claims: &Value) -> Run {
    desk(name, notes, claims).onshell(&["check", "notes.md"])
}

/// The place of a text in a file, as messages give it.
fn place(desk: &Desk, file: &str, text: &str) -> String {
    let whole = desk.read(file);
    let at = whole.find(text).unwrap_or_else(|| panic!("“{text}” in {whole}"));
    let before = &whole[..at];
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
    format!("({file}:{line}:{column})")
}

fn says(run: &Run, words: &[&str]) {
    let said = format!("{}{}", run.out, run.err);
    for word in words {
        assert!(said.contains(word), "no “{word}” in:\n{said}");
    }
}

fn is_silent(run: &Run, words: &[&str]) {
    let said = format!("{}{}", run.out, run.err);
    for word in words {
        assert!(!said.contains(word), "“{word}” in:\n{said}");
    }
}

#[test]
fn where_no_state_is_found_the_hypothesis_is_named_with_its_place() {
    let notes = "$$ a + b = b + 2a \\tag{1} $$\n\n$$ x^2 = -a \\tag{2} $$\n";
    let assuming = |assume: Value| {
        let both = json!({ "1": { "assume": assume }, "2": { "expect": "refuted", "because": "a square" } });
        numbers(json!({ "equations": both }))
    };
    let found = |name: &str, assume: Value| {
        let desk = desk(name, notes, &assuming(assume));
        (desk.onshell(&["check", "notes.md", "--only", "1"]), desk)
    };
    let (both, desk) = found("contradiction", json!(["a > b", "b > a"]));
    let [first, second] = ["\"a > b\"", "\"b > a\""].map(|text| place(&desk, "notes.json", text));
    says(&both, &["error[no-state]", &format!("“a > b” {first}"), &format!("“b > a” {second}"), "contradict"]);
    let (negative, desk) = found("negative", json!(["c > 0", "a = -1"]));
    let at = place(&desk, "notes.json", "\"a = -1\"");
    says(&negative, &["error[no-state]", &format!("obeys “a = −1” {at}")]);
    // An equation that is assumed stands in the notes.
    let (of_notes, desk) = found("of-notes", json!(["2"]));
    says(&of_notes, &[&format!("obeys “x^2 = −a” {}", place(&desk, "notes.md", "x^2"))]);
    // The twin: hypotheses that can be met are not blamed.
    let (sound, _) = found("met", json!(["a > b"]));
    assert_eq!(sound.code, 1);
    is_silent(&sound, &["no-state", "notes.json:"]);
}

#[test]
fn laws_that_cannot_be_met_are_named_with_their_places() {
    let notes = "$$ m \\ddot x = -k x \\tag{1} $$\n\n$$ x^2 = -k \\tag{2} $$\n";
    let claims = |laws: Value| json!({ "notes": "notes.md", "constants": { "m, k": "> 0" }, "varies with time": { "x": "any" }, "laws": laws });
    let desk = desk("laws", notes, &claims(json!({ "spring": "1", "constraint": "2" })));
    let run = desk.onshell(&["check", "notes.md"]);
    let at = place(&desk, "notes.md", "x^2").replace(['(', ')'], "");
    says(&run, &["error[laws-too-strong]", &format!("“x^2 = −k” at all times (constraint, {at})")]);
    let run = check("laws-twin", notes, &claims(json!({ "spring": "1" })));
    is_silent(&run, &["laws-too-strong"]);
}

#[test]
fn a_term_beyond_the_order_is_told_with_the_order_to_write() {
    let of = |name: &str, latex: &str, order: u32| {
        let claims = numbers(json!({ "equations": { "1": { "small": "x", "order": order } } }));
        check(name, &format!("$$ {latex} \\tag{{1}} $$\n"), &claims)
    };
    for (latex, order, needed) in [
        ("\\sin x \\approx x + 5x^3", 2, 3),
        ("\\sin x \\approx x + 5x^5", 2, 5),
        ("\\sin x \\approx x (1 + x^2)", 1, 3),
    ] {
        let line = format!("write \"order\": {needed} in the claims file");
        says(&of("beyond", latex, order), &["error[term-beyond-order]", &line]);
        // With this order the wrong term is found.
        says(&of("within", latex, needed), &["error[order-differs]"]);
        is_silent(&of("within", latex, needed), &["\"order\":"]);
    }
}

#[test]
fn a_counterexample_lists_a_rate_however_it_is_printed() {
    let state = |name: &str, rate: &str| -> Vec<String> {
        let notes = format!("$$ E = \\frac12 m l^2 {rate}^2 + m g l \\cos\\theta \\tag{{1}} $$\n");
        let desk = desk(name, &notes, &pendulum(json!({})));
        let report = desk.onshell(&["check", "notes.md", "--format", "json"]).json();
        let found = report["documents"][0]["equations"][0]["counterexample"]["state"].clone();
        found.as_object().expect("a state").keys().cloned().collect()
    };
    let dotted = state("dotted", "\\dot\\theta");
    assert!(dotted.contains(&"\\dot{\\theta}".to_owned()), "{dotted:?}");
    for printed in ["\\left(\\frac{d\\theta}{dt}\\right)", "\\left(\\frac{d}{dt} \\theta\\right)"] {
        assert_eq!(state("fraction", printed), dotted);
    }
    // What is not in the formula is not in the state.
    assert!(!dotted.contains(&"\\ddot{\\theta}".to_owned()), "{dotted:?}");
}

#[test]
fn what_is_not_conserved_is_named_with_its_rate_and_the_state() {
    let notes = "$$ J = m l^2 \\frac{d\\theta}{dt} \\tag{1} $$\n\nIt is so.\n";
    let of = |name: &str, quantity: &str| {
        check(name, notes, &pendulum(json!({ "sentences": [{ "quote": "It is so.", "conserved": quantity }] })))
    };
    let run = of("conserved", "J");
    says(&run, &["J is not constant: dJ/dt = ", " m = ", " l = ", " g = ", "θ = ", "θ\u{307} = ", "J = "]);
    is_silent(&run, &["left side"]);
    says(&of("conserved-formula", "l \\dot\\theta"), &["“l·θ\u{307}” is not constant: d/dt(l·θ\u{307}) = "]);
    // The twin: the energy is.
    is_silent(&of("conserved-energy", "E"), &["not-conserved"]);
}

#[test]
fn sides_that_differ_are_not_printed_as_equal() {
    let claims = numbers(json!({ "equations": { "1": { "small": "x", "order": 5 } } }));
    let run = check("digits", "$$ \\cos x \\approx 1 - \\frac{x^2}{2} \\tag{1} $$\n", &claims);
    let line = run.out.lines().find_map(|line| line.split_once("left side ")).expect("both sides").1;
    let (left, right) = line.split_once(", right side ").expect("both sides");
    let right = right.split(',').next().unwrap_or_default();
    assert_ne!(left, right, "{}", run.out);
    says(&run, &["error[order-differs]", ", difference "]);
    // Sides that differ at once need no more digits.
    is_silent(&check("digits-twin", "$$ a = b \\tag{1} $$\n", &numbers(json!({}))), &[", difference "]);
}

#[test]
fn what_was_read_is_not_said_to_be_unreadable() {
    let units = json!({ "units": { "a": "m", "b": "s", "c": "m" } });
    let run = check("units", "$$ a = b \\tag{1} $$\n\n$$ a/bc = a \\tag{2} $$\n", &numbers(units));
    says(
        &run,
        &[
            "(1) was read, but cannot be checked: the units do not fit: ",
            "(2) could not be read: a/bc may be a/(bc) or (a/b)c",
        ],
    );
    is_silent(&run, &["is unreadable"]);
    let shapes = json!({ "varies with time": { "\\vec v": "any" } });
    let run = check("shapes", "$$ a = \\vec v \\tag{1} $$\n", &numbers(shapes));
    says(&run, &["(1) was read, but cannot be checked: "]);
}

#[test]
fn for_approximately_there_is_a_line_to_write() {
    let notes = "$$ \\sin x \\approx x \\tag{1} $$\n\n$$ (a + b)^2 = a^2 + 2ab + b^2 \\tag{2} $$\n";
    let whole = check("approximately", notes, &numbers(json!({})));
    let line = r#""equations": { "1": { "small": "x" } }"#;
    says(&whole, &["(1) was read, but cannot be checked: ≈ does not say when", line, r#""limit": "x\\to\\infty""#]);
    let added = merged(numbers(json!({})), serde_json::from_str(&format!("{{ {line} }}")).expect("it is JSON"));
    assert_eq!(check("approximately-added", notes, &added).code, 0);
    let limit = json!({ "equations": { "1": { "limit": "x\\to\\infty" } } });
    says(&check("approximately-limit", notes, &numbers(limit)), &["error[limit-not-reached]"]);
    // With other entries, the line goes beside them.
    let other = numbers(json!({ "equations": { "2": { "holds": "always" } } }));
    says(&check("approximately-beside", notes, &other), &[r#""1": { "small": "x" } under "equations""#]);
}

#[test]
fn mutate_says_why_equations_were_left_out() {
    let notes = "$$ a + b = c d \\tag{1} $$\n\n$$ a + b = c \\tag{2} $$\n";
    let run = desk("left-out", notes, &numbers(json!({}))).onshell(&["mutate", "notes.md"]);
    assert_eq!(run.code, 2);
    says(&run, &["2 equations were left out: ", "1 unreadable", "1 refuted", "no equation can be mutated"]);
    let sound = desk("left-in", "$$ a + b = b + a \\tag{1} $$\n", &numbers(json!({}))).onshell(&["mutate", "notes.md"]);
    is_silent(&sound, &["left out"]);
}

#[test]
fn mutate_has_one_error_for_claims_that_are_wrong() {
    let desk = desk("mutate-claims", "$$ a = a \\tag{1} $$\n", &numbers(json!({ "constnats": {} })));
    for arguments in [&["mutate", "notes.md"][..], &["mutate", "."], &["mutate", "notes.json", "--only", "1"]] {
        let run = desk.onshell(arguments);
        assert_eq!((run.code, run.err.matches("error[").count()), (2, 1), "{}", run.err);
        assert_eq!(run.out, "");
    }
}

#[test]
fn what_mutate_does_not_correct_is_told_with_what_was_suggested() {
    // A lost factor that stands nowhere else is not found.
    let notes = "$$ \\frac{a}{b + c} + \\frac{b}{a} = \\frac{a^2 + b^2 + bc}{a(b + c)} \\tag{1} $$\n";
    let run = desk("repair", notes, &numbers(json!({}))).onshell(&["mutate", "notes.md", "--repair"]);
    let missed: Vec<&str> = run.out.lines().filter(|line| line.contains(" not corrected at ")).collect();
    assert!(!missed.is_empty(), "{}", run.out);
    for line in missed {
        let (_, suggested) = line.rsplit_once("; ").expect("what was suggested");
        let offered = suggested.strip_prefix("suggested: “").is_some_and(|offered| offered.ends_with('”'));
        assert!(offered || suggested == "nothing was suggested", "{line}");
    }
    says(&run, &["; nothing was suggested"]);
}

#[test]
fn equal_gives_two_arguments_for_an_equation() {
    let desk = Desk::new("messages-equal-two");
    for (arguments, command) in [
        (["a + b = b + a", "c"], "onshell equal 'a + b' 'b + a'"),
        (["c", "\\sin x \\approx x"], "onshell equal '\\sin x' 'x'"),
    ] {
        let run = desk.onshell(&["equal", arguments[0], arguments[1]]);
        assert_eq!(run.code, 2);
        says(&run, &["makes this an equation", command]);
        is_silent(&run, &["\\approx is unknown"]);
    }
    assert_eq!(desk.onshell(&["equal", "a + b", "b + a"]).code, 0);
}

#[test]
fn equal_says_where_i_may_be_the_imaginary_unit() {
    let desk = Desk::new("messages-imaginary");
    for (left, right) in [("i^2", "-1"), ("2 i", "i + i")] {
        let run = desk.onshell(&["equal", left, right]);
        assert_eq!(run.code, 2);
        says(&run, &["i may be √−1 or a symbol", "\\mathrm{i}"]);
    }
    // In the exponent of e it is no symbol.
    assert_eq!(desk.onshell(&["equal", "e^{ix}", "\\cos x + i\\sin x"]).code, 0);
    assert_eq!(desk.onshell(&["equal", "e^{ix}", "\\cos x - i\\sin x"]).code, 1);
    assert_eq!(desk.onshell(&["equal", "\\mathrm{i}^2", "-1"]).code, 0);
    // A letter i with a range is a symbol.
    let same = desk.onshell(&["equal", "2 i", "i + i", "--where", "i=0..3"]);
    assert_eq!(same.code, 0, "{}{}", same.out, same.err);
    let other = desk.onshell(&["equal", "i^2", "i", "--where", "i=0..3"]);
    assert_eq!(other.code, 1, "{}{}", other.out, other.err);
    is_silent(&other, &["complex"]);
    let run = check("imaginary", "$$ a = i b \\tag{1} $$\n", &numbers(json!({})));
    says(&run, &["i is not declared", "imaginary unit", r#""i": "any""#]);
}

#[test]
fn equal_says_what_is_assumed_and_what_has_no_value() {
    let desk = Desk::new("messages-values");
    let same = desk.onshell(&["equal", "a", "a", "--where", "a=0..1"]);
    says(&same, &["both formulas are the same", "assumed: a is between 0 and 1"]);
    is_silent(&same, &["0 of 0"]);
    let open = desk.onshell(&["equal", "a + b", "b + a", "--where", "a=0..1"]);
    says(&open, &["assumed: a is between 0 and 1, b is a real number", "64 of 64"]);
    let root = desk.onshell(&["equal", "\\sqrt{x}", "|x|^{1/2}"]);
    says(&root, &["the left side is not a real number, right side "]);
    let none = desk.onshell(&["equal", "\\ln(-x^2-1)", "\\ln(-x^2-2)"]);
    says(&none, &["only 0 of 64 sampled states gave a real number", "--where"]);
    assert_eq!(none.out.matches("0 of 64").count(), 1, "{}", none.out);
    for (formula, x) in [("\\ln x", "x=-1"), ("1/x", "x=0")] {
        let run = desk.onshell(&["eval", formula, "--set", x]);
        says(&run, &["has no real value at this point"]);
        is_silent(&run, &["NaN", "inf\n"]);
    }
    is_silent(&root, &["NaN"]);
}

#[test]
fn what_would_hold_is_told_once() {
    let run = check("would-hold", "$$ (a - b)(a + b) = a^2 + b^2 \\tag{1} $$\n", &numbers(json!({})));
    // Where an edit is suggested, it alone is told.
    says(&run, &["did you mean “-” in place of “+”"]);
    is_silent(&run, &["it would hold with"]);
    let run = check("would-hold-2", "$$ (a + b)^2 = a^2 + ab + b^2 \\tag{1} $$\n", &numbers(json!({})));
    // No single change of a term of this formula makes it true.
    is_silent(&run, &["it would hold with"]);
    let cosine = check("would-hold-3", "$$ \\sin^2 x + \\sin^2 x = 1 \\tag{1} $$\n", &numbers(json!({})));
    says(&cosine, &["did you mean “\\cos” in place of “\\sin”"]);
}

#[test]
fn an_undeclared_name_comes_with_the_line_that_declares_it() {
    let of = |name: &str, claims: &Value| check(name, "$$ \\omega_0 a = a \\omega_0 + 0 \\tag{1} $$\n", claims);
    let run = of("undeclared", &numbers(json!({})));
    says(&run, &[r#"add "\\omega_0": "any" under "constants" in the claims file"#]);
    let line: Value = serde_json::from_str(r#"{ "\\omega_0": "any", "a": "> 0" }"#).expect("it is JSON");
    assert_eq!(of("undeclared-added", &numbers(json!({ "constants": line }))).code, 0);
    let run = check("undeclared-rate", "$$ \\dot q a = a \\dot q + 0 \\tag{1} $$\n", &numbers(json!({})));
    says(&run, &[r#"add "q": "any" under "varies with time""#]);
    // A parameter of a system, and its other name.
    let notes = "$$ \\ddot\\theta = -\\frac{g}{l} \\sin\\theta \\tag{1} $$\n";
    let run = check("parameter", notes, &pendulum(json!({ "constants": { "m, l": "> 0" } })));
    let read = r#""system": { "name": "simple_pendulum", "read": { "g": "…" } }"#;
    says(&run, &[r#"add "g": "any" under "constants""#, read]);
    let renamed = json!({
        "constants": { "m, l, k": "> 0" },
        "system": { "name": "simple_pendulum", "read": { "g": "k" } },
    });
    assert_eq!(check("parameter-read", &notes.replace("{g}", "{k}"), &pendulum(renamed)).code, 0);
}

#[test]
fn fix_says_what_it_did_or_why_it_did_nothing() {
    let wrong = "$$ (a-b)(a+b) = a^2+b^2 \\tag{1} $$\n";
    let fixed = |name: &str, notes: &str, arguments: &[&str]| {
        let desk = desk(name, notes, &numbers(json!({})));
        let run = desk.onshell(&[&["check", "notes.md", "--fix"], arguments].concat());
        (run, desk.read("notes.md"))
    };
    let (run, text) = fixed("fix", wrong, &["--yes"]);
    says(&run, &["(1) was edited at notes.md:1:20: “-” in place of “+”"]);
    assert!(text.contains("a^2-b^2"), "{text}");
    // Without a terminal it cannot ask.
    let (run, text) = fixed("fix-ask", wrong, &[]);
    says(&run, &["--fix asks before it changes a file", "add --yes"]);
    assert_eq!((run.code, text.as_str()), (2, wrong));
    let unclear = "$$ (a+b)^2 = a^2 - 2ab + b^2 \\tag{1} $$\n";
    let (run, text) = fixed("fix-unclear", unclear, &["--yes"]);
    says(&run, &["(1) was not edited: no suggested edit of this equation is safe to make automatically"]);
    assert_eq!(text, unclear);
    let (run, _) = fixed("fix-nothing", "$$ a = a b c + 7 \\tag{1} $$\n", &[]);
    says(&run, &["nothing was edited: there is no suggestion"]);
    let (run, _) = fixed("fix-sound", "$$ a + b = b + a \\tag{1} $$\n", &[]);
    says(&run, &["nothing was edited: everything is as expected"]);
    is_silent(&check("no-fix", wrong, &numbers(json!({}))), &["edited"]);
}

#[test]
fn the_last_lines_count_the_codes_and_explain_the_worst() {
    let notes = "$$ F = a \\tag{1} $$\n\n$$ F + b = c \\tag{2} $$\n\n$$ a = b \\tag{3} $$\n";
    let run = check("codes", notes, &numbers(json!({})));
    let last: Vec<&str> = run.out.lines().rev().take(2).collect();
    let hint = "For more information about a code, try: onshell explain sides-differ";
    assert_eq!(last, [hint, "Codes: 2 sides-differ, 1 definition-users-fail"], "{}", run.out);
    is_silent(&check("code", "$$ a = b \\tag{1} $$\n", &numbers(json!({}))), &["Codes: "]);
}

#[test]
fn a_file_that_is_missing_is_said_to_be_missing() {
    let desk = Desk::new("messages-missing");
    for path in ["absent.md", "absent.json", "absent.tex"] {
        let run = desk.onshell(&["check", path]);
        assert_eq!(run.code, 2);
        says(&run, &[&format!("cannot read {path}: there is no such file")]);
        is_silent(&run, &["os error"]);
    }
}

#[test]
fn a_number_that_is_not_in_the_notes_has_no_near_one() {
    let entry = |id: &str| numbers(json!({ "equations": { id: { "holds": "always" } } }));
    let notes = "$$ a + b = b + a \\tag{1} $$\n\n$$ a = a + 0 \\label{eq:start} $$\n";
    let run = check("number", notes, &entry("9"));
    says(&run, &["notes.md has no equation (9)", "the notes have (1), (eq:start)"]);
    is_silent(&run, &["did you mean"]);
    says(&check("label", notes, &entry("eq:strat")), &["did you mean eq:start?"]);
}

#[test]
fn a_definite_integral_without_a_known_antiderivative_has_a_value_where_its_quadrature_converges() {
    let run = check("integral", "$$ \\int_0^1 \\sin(x^2) dx = \\frac13 \\tag{1} $$\n", &numbers(json!({})));
    says(&run, &["(1) is refuted", "left side 0.310268"]);
    is_silent(&run, &["continu"]);
    let run = check("oscillates", "$$ \\int_0^\\infty \\sin(x^2) dx = \\frac13 \\tag{1} $$\n", &numbers(json!({})));
    says(&run, &["(1) was not decided", "an integral could not be computed"]);
    let run = check("integral-region", "$$ \\int x^2 dx = \\frac13 \\tag{1} $$\n", &numbers(json!({})));
    says(&run, &["an integral without limits has no value", "give both limits"]);
}

#[test]
fn an_ambiguous_formula_is_told_once_with_both_readings() {
    for (latex, readings) in [
        ("a/bc = a", ["a/(bc)", "(a/b)c"]),
        ("\\cos a b = c", ["cos(a)·b", "cos(a·b)"]),
        ("\\sin 2 a b = c", ["sin(2·a)·b", "sin(2·a·b)"]),
        ("\\cot^{-1} x = a", ["inverse function", "1/\\cot x"]),
        ("2 3 a = c", ["2·3", "23"]),
        ("\\frac{d}{dt} y z = c", ["\\frac{d}{dt}(x) y", "\\frac{d}{dt}(x y)"]),
    ] {
        let claims = numbers(json!({ "varies with time": { "y, z": "any" } }));
        let run = check("ambiguous", &format!("$$ {latex} \\tag{{1}} $$\n"), &claims);
        says(&run, &["error[ambiguous]: (1) could not be read: ", readings[0], readings[1]]);
        is_silent(&run, &["ambiguous:", "is unreadable"]);
    }
}

#[test]
fn the_long_list_has_no_empty_line_and_breaks_no_quote() {
    let notes = "$$ a/bc = a \\tag{1} $$\n\n$$ (a-b)(a+b) = a^2+b^2 \\tag{2} $$\n";
    let desk = desk("verbose", notes, &numbers(json!({})));
    for columns in ["60", "66", "72", "80", "100", "120"] {
        let run = desk.onshell_in_columns(Some(columns), &["check", "notes.md", "-v"]);
        let listed: Vec<&str> = run.out.lines().take_while(|line| !line.starts_with("error[")).collect();
        let (last, listed) = listed.split_last().expect("a list");
        assert!(last.is_empty() && listed.iter().all(|line| !line.trim().is_empty()), "{}", run.out);
        for line in run.out.lines() {
            assert_eq!(line.matches('“').count(), line.matches('”').count(), "{line}");
        }
    }
}

#[test]
fn a_subscript_of_a_subscript_is_printed_without_braces() {
    let run = Desk::new("messages-subscripts").onshell(&["derive", "double_pendulum"]);
    says(&run, &["p_θ₁ = ", "p_θ₂ = "]);
    is_silent(&run, &["_{θ_{1}}"]);
    // LaTeX keeps its braces.
    let latex = Desk::new("messages-subscripts-latex").onshell(&["derive", "double_pendulum", "--format", "latex"]);
    says(&latex, &["p_{\\theta_"]);
}

#[test]
fn a_formula_in_a_display_without_a_number_is_pointed_at() {
    let notes = "$$ q_1 = a b $$\n\n$$ c = q_1^2 - 2 q_1 \\tag{1} $$\n";
    let claims = |name: &str| json!({ "notes": "notes.md", "constants": { "a, b, c": "> 0", name: "any" } });
    let run = check("no-number", notes, &claims("x"));
    says(&run, &["q_1 is not declared; line 1 has a formula for it, but no number", "number it with \\tag"]);
    let declared = check("no-number-2", notes, &claims("q_1"));
    is_silent(&declared, &["has a formula for it"]);
}

#[test]
fn a_declared_name_that_nothing_determines_is_named() {
    let force = json!({ "notes": "notes.md", "constants": { "m": "> 0" }, "varies with time": { "F, x": "any" } });
    let notes = "$$ F = m \\ddot x \\tag{1} $$\n";
    let run = check("undetermined", notes, &force);
    says(&run, &["F is declared, so this equation does not define it", "under \"laws\""]);
    // Where a law or the other side has the name, the two sides differ and no more.
    let law = "$$ F = m \\ddot x \\tag{1} $$\n\n$$ F = 2 m \\ddot x \\tag{2} $$\n";
    is_silent(&check("determined", law, &merged(force, json!({ "laws": { "Newton": "1" } }))), &["does not define it"]);
    is_silent(&check("determined-2", "$$ a = a + b \\tag{1} $$\n", &numbers(json!({}))), &["does not define it"]);
}

#[test]
fn what_is_assumed_has_no_tick() {
    let desk = Desk::new("messages-assumed");
    desk.write("alone.md", "$$ E = m v^2 $$\n\n$$ a = v^2/r $$\n\n$$ F = m a $$\n\n$$ E = F R $$\n");
    let run = desk.onshell(&["check", "alone.md", "--verbose"]);
    says(&run, &["· L7  assumed", "✓ L1  definition"]);
    is_silent(&run, &["✓ L7"]);
}

#[test]
fn derive_names_the_function_without_a_formula_and_the_help_lists_the_systems() {
    let desk = Desk::new("messages-derive");
    desk.write("orbit.md", "$$ L = \\frac12 m \\dot r^2 - V(r) \\tag{1} $$\n\n$$ m\\ddot r = -V'(r) \\tag{2} $$\n");
    says(&desk.onshell(&["derive", "orbit.md"]), &["contains V, a function without a formula"]);
    for command in ["derive", "plot"] {
        says(&desk.onshell(&[command, "--help"]), &["Examples:", "Systems: heavy_top, ", "relativistic_particle"]);
    }
}
