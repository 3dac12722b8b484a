//! Bad input of every kind: a clear error at its place, exit code 2; no panic, no overflow, no hang (`support` sees to
//! the last three).

use crate::support::{Desk, Run};

/// Claims that go with `notes.md`, which holds one equation that they make true.
const CLAIMS: &str = r#"{
  "notes": "notes.md",
  "constants": { "a": "> 0", "b": "[1, 2]" },
  "equations": {
    "1": { "holds": "always" }
  }
}
"#;
const NOTES: &str = "$$\n(a + b)^2 = a^2 + 2ab + b^2\n\\tag{1}\n$$\n";

/// Checks `notes.md` with these claims.
fn check(name: &str, claims: impl AsRef<[u8]>, notes: impl AsRef<[u8]>) -> Run {
    let desk = Desk::new(name);
    desk.write("claims.json", claims);
    desk.write("notes.md", notes);
    desk.onshell(&["check", "claims.json"])
}

/// The claims with one place changed.
fn claims_with(from: &str, to: &str) -> String {
    assert_eq!(CLAIMS.matches(from).count(), 1, "{from}");
    CLAIMS.replace(from, to)
}

fn refused(run: &Run, words: &[&str]) {
    assert_eq!(run.code, 2, "{}{}", run.out, run.err);
    let said = format!("{}{}", run.out, run.err);
    for word in words {
        assert!(said.contains(word), "no “{word}” in:\n{said}");
    }
}

#[test]
fn the_input_that_is_made_bad_here_is_good() {
    let run = check("good", CLAIMS, NOTES);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let wrong = check("wrong", CLAIMS, NOTES.replace("2ab", "ab"));
    assert_eq!(wrong.code, 1, "{}{}", wrong.out, wrong.err);
}

#[test]
fn files_that_cannot_be_read() {
    let desk = Desk::new("unreadable");
    refused(&desk.onshell(&["check", "absent.json"]), &["absent.json"]);
    refused(&desk.onshell(&["check", "absent"]), &["absent"]);
    desk.write("claims.json", CLAIMS);
    refused(&desk.onshell(&["check", "claims.json"]), &["notes.md"]);
    std::fs::create_dir(std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("cli/unreadable/notes.md"))
        .expect("a folder can be made");
    refused(&desk.onshell(&["check", "claims.json"]), &["notes.md"]);
}

#[test]
fn absent_notes_are_called_by_their_name() {
    let desk = Desk::new("absent-notes");
    refused(&desk.onshell(&["check", "absent.md"]), &["absent.md"]);
    refused(&desk.onshell(&["check", "absent.tex"]), &["absent.tex"]);
}

#[test]
fn text_that_is_not_utf_8() {
    refused(&check("utf8-notes", CLAIMS, b"$$ a = \xff $$".as_slice()), &["notes.md", "not UTF-8"]);
    refused(&check("utf8-claims", b"{ \"notes\": \"\xc3\x28\" }".as_slice(), NOTES), &["claims.json", "not UTF-8"]);
}

#[test]
fn empty_files() {
    refused(&check("empty-notes", CLAIMS, ""), &["notes.md", "empty"]);
    refused(&check("blank-notes", CLAIMS, " \n\n\t"), &["notes.md", "empty"]);
    refused(&check("empty-claims", "", NOTES), &["claims.json:1:1", "empty"]);
}

#[test]
fn json_cut_off_at_any_byte() {
    let desk = Desk::new("cut-off");
    desk.write("notes.md", NOTES);
    let end = CLAIMS.trim_end().len();
    for length in (0..end).step_by(7) {
        desk.write("claims.json", &CLAIMS[..length]);
        let run = desk.onshell(&["check", "claims.json"]);
        refused(&run, &["claims.json:"]);
    }
    desk.write("claims.json", &CLAIMS[..end]);
    assert_eq!(desk.onshell(&["check", "claims.json"]).code, 0);
}

#[test]
fn a_hundred_thousand_braces() {
    const N: usize = 100_000;
    let objects = "{\"notes\":".repeat(N);
    refused(&check("braces-claims", &objects, NOTES), &["claims.json:1:"]);
    refused(&check("braces-claims-closed", objects + "1" + &"}".repeat(N), NOTES), &["claims.json:1:"]);
    refused(&check("brackets", "[".repeat(N) + &"]".repeat(N), NOTES), &["claims.json:1:"]);
    for (name, open, close) in [
        ("braces", "{", "}"),
        ("parentheses", "(", ")"),
        ("fractions", "\\frac{", "}{2}"),
        ("roots", "\\sqrt{", "}"),
        ("fences", "\\left(", "\\right)"),
        ("powers", "a^{", "}"),
        ("subscripts", "a_{", "}"),
        ("dots", "\\dot{", "}"),
        ("matrices", "\\begin{pmatrix}", "\\end{pmatrix}"),
        ("bars", "\\left|", "\\right|"),
    ] {
        let deep = |n: usize, m: usize| format!("$$\na = {}a{}\n\\tag{{1}}\n$$\n", open.repeat(n), close.repeat(m));
        refused(&check(&format!("deep-{name}"), CLAIMS, deep(N, N)), &["unreadable"]);
        refused(&check(&format!("open-{name}"), CLAIMS, deep(N, 0)), &["notes.md"]);
        // Short enough to be read in full: it is the depth alone that is refused.
        refused(&check(&format!("deepish-{name}"), CLAIMS, deep(9_000, 9_000)), &["unreadable"]);
    }
}

#[test]
fn a_fault_in_a_long_line_has_its_place() {
    let long = "a + ".repeat(200);
    let at = |line: &str| check("long-line", CLAIMS, format!("$$\n{line} = a\n\\tag{{1}}\n$$\n"));
    refused(&at("2c + c"), &["unreadable", "notes.md:2:2"]);
    refused(&at(&format!("{long}c")), &["unreadable", "notes.md:2:801"]);
    refused(&at(&format!("a{}", "}".repeat(500))), &["notes.md:2:2"]);
}

#[test]
fn a_formula_of_ten_megabytes() {
    for (name, piece) in [("sum", "a + "), ("product", "a \\, "), ("text", "\\text{a} "), ("rows", "a \\\\ ")] {
        let notes = format!("$$\na = {}a\n\\tag{{1}}\n$$\n", piece.repeat(10_000_000 / piece.len()));
        refused(&check(&format!("long-{name}"), CLAIMS, notes), &["unreadable"]);
    }
}

#[test]
fn a_long_formula_that_is_sound_is_no_error() {
    let notes = format!("$$\n500 a = {}a\n\\tag{{1}}\n$$\n", "a + ".repeat(499));
    let run = check("long-and-sound", CLAIMS, notes);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
}

#[test]
fn numbers_too_large_to_compute_with() {
    let digits = "9".repeat(400);
    refused(&check("digits", CLAIMS, NOTES.replace("2ab", &format!("{digits}ab"))), &["unreadable", "too large"]);
    refused(&check("range", claims_with("[1, 2]", "[1, 1e400]"), NOTES), &["claims.json:3"]);
    refused(&check("range-digits", claims_with("[1, 2]", &format!("[1, {digits}]")), NOTES), &["claims.json:3"]);
    refused(
        &check("number", claims_with("{ \"holds\": \"always\" }", "{ \"times\": 1e400 }"), NOTES),
        &["claims.json:5"],
    );
    let power = check("power", CLAIMS, NOTES.replace("2ab", "10^{400}ab"));
    assert_ne!(power.code, 0, "{}", power.out);
}

#[test]
fn ranges_upside_down_or_empty() {
    for range in ["[2, 1]", "(1, 1)", "[1, 1]", "[1, 2", "[1; 2]", "1..2", "[q, 2]", "(\\\\pi, 0)", "[nan, 2]"] {
        refused(&check("upside-down", claims_with("[1, 2]", range), NOTES), &["claims.json:3"]);
    }
}

#[test]
fn a_symbol_declared_twice() {
    refused(&check("twice", claims_with("\"b\": \"[1, 2]\"", "\"a, b\": \"any\""), NOTES), &["claims.json:3", "twice"]);
    refused(&check("twice-key", claims_with("\"b\":", "\"a\":"), NOTES), &["claims.json:3", "twice"]);
    let both = claims_with("\"equations\"", "\"varies with time\": { \"a\": \"any\" },\n  \"equations\"");
    let keys = ["claims.json:", "under \"constants\"", "under \"varies with time\""];
    refused(&check("twice-roles", both, NOTES), &keys);
}

#[test]
fn a_claim_for_an_equation_that_is_not_there() {
    refused(&check("absent", claims_with("\"1\"", "\"2\""), NOTES), &["claims.json:5", "2"]);
    let solves = claims_with("{ \"holds\": \"always\" }", "{ \"solves\": \"7\", \"for\": \"a\" }");
    refused(&check("absent-solves", solves, NOTES), &["claims.json:5", "7"]);
    let quote = claims_with(
        "  \"equations\"",
        "  \"sentences\": [{ \"quote\": \"not a word of it\", \"claim\": \"a = a\" }],\n  \"equations\"",
    );
    refused(&check("absent-quote", quote, NOTES), &["claims.json:4"]);
}

#[test]
fn claims_that_are_misspelt() {
    for (name, from, to, words) in [
        ("key", "\"constants\"", "\"constnats\"", vec!["claims.json:3:3", "constants"]),
        ("claim-key", "\"holds\"", "\"hodls\"", vec!["claims.json:5", "holds"]),
        ("word", "\"always\"", "\"allways\"", vec!["claims.json:5", "always"]),
        ("type", "\"> 0\"", "3", vec!["claims.json:3"]),
        ("tab", "\"a\":", "\"\\theta\":", vec!["claims.json:3", "tab", "\\\\theta"]),
        ("system", "\"notes\"", "\"system\": \"heavy_tpo\", \"notes\"", vec!["claims.json:2", "heavy_top"]),
        ("comma", "\"> 0\",", "\"> 0\"", vec!["claims.json:3"]),
        ("later", "\"always\"", "\"always\", \"starting at\": \"x = 0\"", vec!["claims.json:5", "starting at"]),
        ("units", "\"always\"", "\"always\", \"units\": \"of\"", vec!["claims.json:5", "off"]),
    ] {
        refused(&check(&format!("misspelt-{name}"), claims_with(from, to), NOTES), &words);
    }
}

#[test]
fn symbols_that_nobody_declared() {
    let run = check("undeclared", CLAIMS, NOTES.replace("2ab", "2ac"));
    refused(&run, &["(1) could not be read", "notes.md:2:", "c is not declared"]);
    let in_claims = claims_with("\"always\"", "\"always\", \"assume\": \"c > 0\"");
    refused(&check("undeclared-claims", in_claims, NOTES), &["claims.json:5", "c is not declared"]);
}

#[test]
fn notes_that_do_not_close_what_they_open() {
    for notes in ["$$\na = b\n\\tag{1}\n", "$$\n\\left(a = b\n\\tag{1}\n$$\n", "$$\n\\frac{a}{b = 1\n\\tag{1}\n$$\n"] {
        refused(&check("unclosed", CLAIMS, notes), &["notes.md:"]);
    }
    refused(&check("two-numbers", CLAIMS, format!("{NOTES}\n{NOTES}")), &["1"]);
}

#[test]
fn a_mass_matrix_that_is_singular_everywhere_in_the_range() {
    let top = r#"{
  "notes": "notes.md",
  "system": "heavy_top",
  "coordinates": { "\\theta": "[1e-12, 2e-12]", "\\phi, \\psi": "angle" },
  "constants": { "M, g, R, \\lambda_1, \\lambda_3": "> 0" },
  "equations": { "1": { "holds": "on shell" } }
}
"#;
    let notes = "$$\n\\lambda_1 \\ddot\\theta = MgR \\sin\\theta\n\\tag{1}\n$$\n";
    refused(&check("singular", top, notes), &["mass matrix", "condition"]);
}
