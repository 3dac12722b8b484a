//! Claims applied to another print of their notes: numbers behind the displays, rows apart, places damaged.

use serde_json::Value;

use crate::support::{Desk, Run, outcome};

const REFERENCE: &str = r"
$$ p = m v \tag{1.1} $$
$$ E = \frac{p^2}{2m} \tag{1.2} $$
$$ E = \frac{1}{2} m v^2 , \quad v E = \frac{1}{2} p v^2 \tag{1.3} $$
Misprinted: $$ (p + m)^2 = p^2 + m^2 \tag{1.4} $$
Wrong: $$ E = m v^2 \tag{1.5} $$
";

const CLAIMS: &str = r#"{
  "notes": "reference.md",
  "constants": { "m, v": "> 0" },
  "equations": {
    "1.4": { "erratum": { "for": "= p^2 +", "read": "= p^2 + 2pm +", "because": "the mixed term is lost" } },
    "1.5": { "expect": "refuted", "because": "the half is lost" }
  },
  "sentences": [{ "quote": "Misprinted", "claim": "p > 0" }]
}"#;

/// The same as a converter may leave it.
const PRINT: &str = r"
$$p = mv (1.1)$$

the energy

$$E = \frac{p^2}{2m}$$
 (1.2)

$$E = \frac{1}{2} m v^2$$

$$v E = \frac{1}{2} p v^2$$

$$(1.3)$$

$$(p+m)^{2} = p^2 + m^2$$ (1.4)

$$E = m v^2 \tag{1.5}$$
";

/// Checks a print by the claims of the reference.
fn check(name: &str, print: &str) -> (Run, Vec<Value>) {
    let desk = Desk::new(name);
    desk.write("reference.md", REFERENCE);
    desk.write("reference.json", CLAIMS);
    desk.write("print.txt", print);
    let run = desk.onshell(&["check", "print.txt", "--claims", "reference.json", "--format", "json"]);
    let equations = match run.json()["documents"].get(0) {
        Some(document) => {
            assert_eq!((&document["path"], &document["sentences"]), (&"print.txt".into(), &Value::Array(Vec::new())));
            document["equations"].as_array().expect("a list").clone()
        }
        None => Vec::new(),
    };
    (run, equations)
}

/// Number, verdict, and whether it is as expected.
fn verdicts(equations: &[Value]) -> Vec<(&str, &str, bool)> {
    let text = |equation: &'_ Value, key: &str| -> String { equation[key].as_str().expect("a string").to_owned() };
    let leak = |text: String| -> &'static str { text.leak() };
    equations.iter().map(|e| (leak(text(e, "id")), outcome(leak(text(e, "verdict"))), e["ok"] == true)).collect()
}

/// The verdict on one number after one change of the print, the exit code, and all that is said of it.
fn changed(name: &str, (from, to): (&str, &str), number: &str) -> (String, bool, i32, Value) {
    assert_eq!(PRINT.matches(from).count(), 1, "{from}");
    let (run, equations) = check(name, &PRINT.replace(from, to));
    let others = equations.iter().filter(|equation| equation["id"] != number && equation["ok"] == false);
    assert_eq!(others.count(), 0, "what is damaged here damages nothing else:\n{}", run.out);
    let mut found = equations.into_iter().filter(|equation| equation["id"] == number);
    let equation = found.next().unwrap_or_else(|| panic!("no ({number}) in {}{}", run.out, run.err));
    assert!(found.next().is_none(), "each number once");
    let verdict = outcome(equation["verdict"].as_str().expect("a string")).to_owned();
    (verdict, equation["ok"] == true, run.code, equation)
}

#[test]
fn another_print_is_judged_as_its_reference_is() {
    let (run, equations) = check("reprint", PRINT);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let wanted = [
        ("1.1", "definition", true),
        ("1.2", "definition", true),
        ("1.3", "verified", true),
        ("1.4", "refuted", true),
        ("1.5", "refuted", true),
    ];
    assert_eq!(verdicts(&equations), wanted);
    assert_eq!(equations[2]["parts"].as_array().map(Vec::len), Some(2), "the rows are read as rows");
}

#[test]
fn a_definition_in_other_words_is_tested_against_the_reference() {
    let (verdict, ok, code, _) = changed("reprint-words", ("p = mv", "p = 3 v m - 2 m v"), "1.1");
    assert_eq!((verdict.as_str(), ok, code), ("verified", true, 0));
    let (verdict, ok, code, equation) = changed("reprint-other", ("p = mv", "p = 2mv"), "1.1");
    assert_eq!((verdict.as_str(), ok, code), ("refuted", false, 1));
    assert_eq!((&equation["latex"], &equation["line"]), (&"p = 2mv (1.1)".into(), &2.into()));
}

#[test]
fn what_is_damaged_is_unreadable_at_its_place() {
    for (name, damage, word) in [
        ("accent", r"E = \frac{p^2}{2\bar{\bar{m}}}", "is not declared"),
        ("brace", r"E = \frac{p^2}{2m", "never closed"),
        ("empty", r" ", "display is empty"),
        ("name", r"K = \frac{p^2}{2m}", "K is unknown"),
        ("cell", r"E = \begin{pmatrix} p & & m \end{pmatrix}", "is empty in column 2"),
        ("no-relation", r"\frac{p^2}{2m}", "without a relation"),
    ] {
        let (verdict, ok, code, equation) = changed(&format!("reprint-{name}"), (r"E = \frac{p^2}{2m}", damage), "1.2");
        assert_eq!((verdict.as_str(), ok, code), ("unreadable", false, 2), "{name}: {equation}");
        assert_eq!(equation["line"], 6, "{name}: {equation}");
        assert!(equation["message"].as_str().is_some_and(|message| message.contains(word)), "{name}: {equation}");
    }
}

#[test]
fn a_lost_number_is_missed_and_a_strange_one_is_unclaimed() {
    let (verdict, ok, code, equation) = changed("reprint-lost", ("$$(1.3)$$", ""), "1.3");
    assert_eq!((verdict.as_str(), ok, code), ("unreadable", false, 2));
    assert!(equation["message"].as_str().is_some_and(|m| m.contains("after (1.2)")), "{equation}");
    let (run, equations) = check("reprint-strange", &format!("{PRINT}\n$$E = 0$$ (1.6)\n"));
    assert_eq!((run.code, verdicts(&equations).last()), (2, Some(&("1.6", "unclaimed", false))));
    let (run, _) = check("reprint-foreign", "$$ E = 0 \\tag{7.1} $$\n");
    assert_eq!(run.code, 2);
    assert!(run.err.contains("and reference.md have no equation number in common"), "{}", run.err);
}

#[test]
fn a_number_that_stands_twice_is_a_finding_of_its_own() {
    let (run, equations) = check("reprint-twice", &format!("{PRINT}\n$$E = 7m$$ (1.2)\n"));
    assert_eq!(run.code, 2, "{}{}", run.out, run.err);
    let wanted = [("1.1", true), ("1.2", true), ("1.3", true), ("1.4", true), ("1.5", true), ("1.2", false)];
    assert_eq!(verdicts(&equations).iter().map(|(id, _, ok)| (*id, *ok)).collect::<Vec<_>>(), wanted, "{}", run.out);
    let (second, line) = (&equations[5], PRINT.lines().count() + 2);
    assert_eq!(
        (&second["verdict"], &second["line"], &second["latex"]),
        (&"unreadable".into(), &line.into(), &"(1.2)".into())
    );
    assert!(second["message"].as_str().is_some_and(|message| message.contains("used twice: on line 6")), "{second}");
}

/// The verdict on one equation of a print whose reference has `original` in its place, and what is said of it.
fn instead(name: &str, original: &str, claim: &str, print: &str) -> (String, String) {
    let desk = Desk::new(name);
    desk.write("reference.md", format!("$$ {original} \\tag{{1.1}} $$\n"));
    let claims = r#"{ "notes": "reference.md", "constants": { "m": "> 0" }, "varies with time": { "v": "> 0" }, "#;
    desk.write("reference.json", format!(r#"{claims} "equations": {{ "1.1": {claim} }} }}"#));
    desk.write("print.txt", format!("$$ {print} $$ (1.1)\n"));
    let run = desk.onshell(&["check", "print.txt", "--claims", "reference.json", "--format", "json"]);
    let equation = run.json()["documents"][0]["equations"][0].clone();
    let word = |key: &str| equation[key].as_str().unwrap_or_else(|| panic!("{}{}", run.out, run.err)).to_owned();
    let verdict = outcome(&word("verdict")).to_owned();
    assert_eq!(equation["ok"] == true, verdict == "verified", "{}", run.out);
    (verdict, word("message"))
}

#[test]
fn what_a_print_leaves_out_is_missed() {
    let (rows, chain) = (r"m v = v m \\ v + v = 2v", "m v + m v = 2 m v = m (v + v)");
    for (name, original, print, word) in [
        ("row", rows, "m v = v m", "v + v"),
        ("link", chain, "m v + m v = 2 m v", "m·(v + v)"),
        ("first", chain, "2 m v = m (v + v)", "m·v + m·v"),
        ("weaker", "2 m v = m v + m v", r"2 m v \leq m v + m v", "1 “=”"),
    ] {
        let (verdict, message) = instead(&format!("lost-{name}"), original, "{}", print);
        assert_eq!((verdict.as_str(), message.contains(word)), ("unreadable", true), "{name}: {message}");
        assert_eq!(instead(&format!("kept-{name}"), original, "{}", original).0, "verified", "{name}");
    }
    // The same in other rows, and in other words, is not lost.
    assert_eq!(instead("kept-rows", rows, "{}", r"m v = v m , \quad 2v = v + v").0, "verified");
    assert_eq!(instead("kept-words", chain, "{}", r"2 m v = m v + m v, \quad m (v + v) = 2 m v").0, "verified");
    // A correction may say more than the misprint, which then is lost by nobody.
    let erratum = r#"{ "erratum": { "for": "= 3 m v", "read": "= 2 m v = m (v + v)" } }"#;
    let (verdict, message) = instead("lost-mended", "m v + m v = 3 m v", erratum, "m v + m v = 2 m v");
    assert_eq!(verdict, "verified", "{message}");
}

#[test]
fn a_known_erratum_excuses_itself_and_nothing_else() {
    // Spelled in another way it is the same misprint.
    let (verdict, ok, code, _) = changed("erratum-spelled", ("= p^2 + m^2$$", "= {p}^{2}+m^2$$"), "1.4");
    assert_eq!((verdict.as_str(), ok, code), ("refuted", true, 0));
    let (verdict, ok, code, _) = changed("erratum-mended", ("= p^2 + m^2$$", "= p^2 + 2pm + m^2$$"), "1.4");
    assert_eq!((verdict.as_str(), ok, code), ("verified", true, 0));
    let (verdict, ok, code, _) = changed("erratum-and-more", ("= p^2 + m^2$$", "= p^2 + 3m^2$$"), "1.4");
    assert_eq!((verdict.as_str(), ok, code), ("refuted", false, 1));
    let (verdict, ok, code, _) = changed("erratum-other", ("= p^2 + m^2$$", "= p^2 - m^2$$"), "1.4");
    assert_eq!((verdict.as_str(), ok, code), ("refuted", false, 1));
    let (verdict, ok, code, _) = changed("expected-other", (r"E = m v^2 \tag", r"E = 3 m v^2 \tag"), "1.5");
    assert_eq!((verdict.as_str(), ok, code), ("refuted", false, 1));
    let (verdict, ok, code, _) = changed("expected-mended", (r"E = m v^2 \tag", r"2E = m v^2 \tag"), "1.5");
    assert_eq!((verdict.as_str(), ok, code), ("verified", true, 0));
}

#[test]
fn a_law_is_granted_only_as_the_reference_has_it() {
    let desk = Desk::with_the_derivations("reprint-law");
    let verdict = |print: String| {
        desk.write("print.md", print);
        let claims = "derivations/04-eulers-equations.json";
        let run = desk.onshell(&["check", "print.md", "--claims", claims, "--only", "4.58", "--format", "json"]);
        let parts = run.json()["documents"][0]["equations"][0]["parts"].clone();
        (run.code, parts[0]["verdict"].as_str().expect("a string").to_owned())
    };
    let notes = desk.read("derivations/04-eulers-equations.md");
    let law = r"\frac{d\vec{L}}{dt} = \vec{N}";
    assert_eq!(notes.matches(law).count(), 1);
    assert_eq!(verdict(notes.clone()), (0, "law".to_owned()));
    assert_eq!(verdict(notes.replace(law, r"\frac{d\vec{L}}{dt} = 2 \vec{N}")), (1, "refuted".to_owned()));
}

#[test]
fn what_a_claim_needs_and_the_print_lost_is_no_error_of_the_claims() {
    let desk = Desk::with_the_derivations("reprint-limit");
    let verdict = |print: String| {
        desk.write("print.md", print);
        let claims = "derivations/06-spinning-top.json";
        let run = desk.onshell(&["check", "print.md", "--claims", claims, "--only", "6.76", "--format", "json"]);
        let equation = run.json()["documents"][0]["equations"][0].clone();
        (run.code, equation["verdict"].as_str().unwrap_or_else(|| panic!("{}{}", run.out, run.err)).to_owned())
    };
    let notes = desk.read("derivations/06-spinning-top.md");
    assert_eq!(verdict(notes.clone()), (0, "verified".to_owned()));
    assert_eq!(verdict(notes.replace("\\approx", "=")), (2, "unreadable".to_owned()));
}

#[test]
fn several_claims_files_share_a_print() {
    let desk = Desk::new("reprint-several");
    std::fs::create_dir_all(desk.path("claims")).expect("a folder can be made");
    let (first, second) = REFERENCE.split_at(REFERENCE.find("Misprinted").expect("it is there"));
    desk.write("claims/a.md", first);
    desk.write("claims/b.md", second);
    desk.write("claims/a.json", r#"{ "notes": "a.md", "constants": { "m, v": "> 0" } }"#);
    let both = CLAIMS.replace("reference.md", "b.md");
    desk.write("claims/b.json", both.replace(r#""> 0" },"#, r#""> 0" }, "define": { "p": "m v", "E": "p^2/(2m)" },"#));
    desk.write("print.txt", PRINT);
    let json = ["--format", "json"];
    let folder = desk.onshell(&[&["check", "print.txt", "--claims", "claims"], &json[..]].concat());
    assert_eq!(folder.code, 0, "{}{}", folder.out, folder.err);
    let equations = folder.json()["documents"][0]["equations"].as_array().expect("a list").clone();
    let numbers: Vec<&str> = verdicts(&equations).into_iter().map(|(number, ..)| number).collect();
    assert_eq!(numbers, ["1.1", "1.2", "1.3", "1.4", "1.5"]);
    // As a shell writes out claims/*.json, and one by one.
    let (a, b) = ("claims/a.json", "claims/b.json");
    for files in [vec!["--claims", a, b], vec!["--claims", a, "--claims", b]] {
        let run = desk.onshell(&[&["check", "print.txt"], &files[..], &json[..]].concat());
        assert_eq!(run.out, folder.out);
    }
    for format in ["text", "json"] {
        let run =
            |threads| desk.onshell_on(Some(threads), &["check", "print.txt", "--claims", "claims", "--format", format]);
        let (one, two, again) = (run(1), run(2), run(2));
        assert_eq!((&one.out, &one.err), (&two.out, &two.err));
        assert_eq!((&two.out, &two.err), (&again.out, &again.err));
    }
    // Without the second file its numbers are unclaimed.
    let half = desk.onshell(&["check", "print.txt", "--claims", a, "--format", "json"]);
    assert_eq!((half.code, &half.json()["summary"]["unclaimed"]), (2, &2.into()));
    let none = desk.onshell(&["check", "--claims", a, b]);
    assert_eq!(none.code, 2, "{}", none.out);
    assert!(none.err.contains("no notes"), "{}", none.err);
}

#[test]
fn claims_about_the_file_itself_are_checked_with_their_sentences() {
    let desk = Desk::new("reprint-own");
    desk.write("reference.md", REFERENCE);
    desk.write("elsewhere.json", CLAIMS);
    desk.write("absent.json", CLAIMS.replace("reference.md", "absent.md"));
    let sentences = |claims: &str| {
        let run = desk.onshell(&["check", "reference.md", "--claims", claims, "--format", "json"]);
        assert_eq!(run.code, 0, "{}{}", run.out, run.err);
        run.json()["documents"][0]["sentences"].as_array().map(Vec::len)
    };
    assert_eq!((sentences("elsewhere.json"), sentences("absent.json")), (Some(1), Some(1)));
    let both = desk.onshell(&["check", "reference.md", "--claims", "elsewhere.json", "absent.json"]);
    assert_eq!(both.code, 2, "{}", both.out);
    let heard = both.err.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        heard.contains("2 claims files are given, but elsewhere.json is the claims file of reference.md"),
        "{heard}"
    );
    assert!(heard.contains("give only elsewhere.json"), "{heard}");
}
