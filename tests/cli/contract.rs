//! The JSON report is a promise: which fields there are, of which type, and what they say of the notes.

use onshell::Code;
use serde_json::{Value, json};

use crate::support::{Desk, SIGN};

const VERDICTS: [&str; 9] =
    ["certified", "verified", "definition", "law", "refuted", "domain", "undecided", "unreadable", "unclaimed"];

/// Whether a report keeps the promise; `notes` gives the text of a document's file.
fn kept(report: &Value, notes: impl Fn(&str) -> String) -> Result<(), String> {
    expect(report["schema"] == 1, "schema is 1", report)?;
    let documents = report["documents"].as_array().ok_or("documents is a list")?;
    let (mut counts, mut unexpected) = (serde_json::Map::new(), 0);
    for document in documents {
        let path = document["path"].as_str().ok_or("path is a string")?;
        expect(document.get("claims").is_none_or(Value::is_string), "claims is a path or not there", document)?;
        let text = notes(path);
        let equations = document["equations"].as_array().ok_or("equations is a list")?;
        for equation in equations.iter().chain(document["sentences"].as_array().into_iter().flatten()) {
            fields(equation, &text)?;
            place(equation, path, &text)?;
            for part in equation.get("parts").and_then(Value::as_array).into_iter().flatten() {
                fields(part, &text)?;
                place(part, path, &text)?;
                expect(part["id"] == equation["id"], "a part has the number of its equation", part)?;
            }
            let count = counts.entry(equation["verdict"].as_str().unwrap_or_default()).or_insert(json!(0));
            *count = json!(count.as_u64().unwrap_or(0) + 1);
            unexpected += u64::from(equation["ok"] == false);
        }
    }
    counts.insert("unexpected".to_owned(), json!(unexpected));
    expect(report["summary"] == Value::Object(counts), "the summary counts what is listed", &report["summary"])
}

fn fields(item: &Value, notes: &str) -> Result<(), String> {
    expect(item["id"].as_str().is_some_and(|id| !id.is_empty()), "id is a string", item)?;
    let line = item["line"].as_u64().ok_or_else(|| format!("line is a number: {item:#}"))?;
    expect(line >= 1 && line as usize <= notes.lines().count(), "line is a line of the notes", item)?;
    let latex = item["latex"].as_str().ok_or_else(|| format!("latex is a string: {item:#}"))?;
    expect(!latex.is_empty() && notes.contains(latex), "latex stands in the notes exactly so", item)?;
    expect(item["reading"].is_string(), "reading is a string", item)?;
    expect(item["verdict"].as_str().is_some_and(|word| VERDICTS.contains(&word)), "verdict is one", item)?;
    expect(item["ok"].is_boolean(), "ok is true or false", item)?;
    let (points, tried) = (item["points"].as_u64(), item["tried"].as_u64());
    expect(points.zip(tried).is_some_and(|(points, tried)| points <= tried), "points of tried", item)?;
    let residual = &item["max_residual"];
    expect(residual.is_null() || residual.as_f64().is_some_and(|r| r >= 0.0), "max_residual is a number", item)?;
    expect(item["message"].as_str().is_some_and(|message| !message.is_empty()), "message is a string", item)?;
    certificate(item)?;
    let found = &item["counterexample"];
    // What a sentence refers to is looked up, and no state is needed to see that it is not there. A field has no states.
    let looked_up = item["reading"].as_str().is_some_and(|reading| reading.contains(") contains "));
    let by_the_field = item["message"].as_str().is_some_and(|message| message.contains("less than rounding error"));
    if item["verdict"] == "refuted" && !looked_up && !by_the_field || !found.is_null() {
        let state = found["state"].as_object().ok_or_else(|| format!("a state: {item:#}"))?;
        expect(!state.is_empty() && state.values().all(Value::is_number), "the state is numbers", item)?;
        // JSON has no infinities: they are words.
        let value = |side: &Value| side.is_number() || ["inf", "-inf", "NaN"].iter().any(|word| side == word);
        expect(value(&found["lhs"]) && value(&found["rhs"]), "both sides have values", item)?;
        // What a sentence says of a whole curve fails on the whole of it; an equation fails at the state.
        let is_equation = item["reading"].as_str().is_some_and(|reading| reading.contains(" = "));
        expect(found["lhs"] != found["rhs"] || !is_equation, "the sides differ", item)?;
    }
    for key in ["difference", "derived"] {
        let shown = item.get(key).ok_or_else(|| format!("{key} is there: {item:#}"))?;
        let formula = shown["latex"].is_string() && shown["text"].is_string();
        expect(shown.is_null() || formula && found.is_object(), "what it is off by", item)?;
    }
    Ok(())
}

/// Every finding has a code that can be explained, and its place: the line and the column of its display, and its own bytes.
fn place(item: &Value, path: &str, notes: &str) -> Result<(), String> {
    let codes: Vec<&str> = Code::ALL.iter().map(|code| code.word()).collect();
    expect(item["code"].as_str().is_some_and(|code| codes.contains(&code)), "code is one", item)?;
    expect(item["file"] == path, "file is that of the notes", item)?;
    let line = notes.lines().nth(item["line"].as_u64().unwrap_or(0) as usize - 1).unwrap_or_default();
    let column = item["column"].as_u64().ok_or_else(|| format!("column is a number: {item:#}"))? as usize;
    expect(1 <= column && column <= line.chars().count() + 1, "column is one of the line", item)?;
    let span = &item["span"];
    let [start, end] = ["start", "end"].map(|key| span[key].as_u64().unwrap_or(u64::MAX) as usize);
    expect(start <= end && notes.get(start..end).is_some(), "span is a range of the notes", item)?;
    let before = &notes[..start];
    let (line, column) =
        (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
    expect(span["line"] == line && span["column"] == column, "a span has the place of its first byte", item)
}

/// What is certified has the bound on its being false, and nothing else has one; an equality that is not says why.
fn certificate(item: &Value) -> Result<(), String> {
    let (bound, reason) = (&item["false_accept_log2"], &item["not_certified_because"]);
    let certified = item["verdict"] == "certified";
    expect(item.get("false_accept_log2").is_some(), "false_accept_log2 is there", item)?;
    expect(item.get("not_certified_because").is_some(), "not_certified_because is there", item)?;
    expect(certified != bound.is_null(), "what is certified has a bound, and nothing else", item)?;
    expect(bound.is_null() || bound.as_f64().is_some_and(|log2| log2 <= -80.0), "the bound is 2^-80 or less", item)?;
    expect(reason.is_null() || reason.as_str().is_some_and(|why| !why.is_empty()), "a reason is a string", item)?;
    expect(reason.is_null() || item["verdict"] == "verified", "only what is verified needs a reason", item)?;
    let says = |key: &str, what: &str| item[key].as_str().is_some_and(|text| text.contains(what));
    let other = ["≈", "<", ">", "≤", "≥", "≠", "∝"].iter().any(|relation| says("reading", relation));
    let is_equality = says("reading", " = ") && says("message", "holds ") && !other;
    // Of several parts each has its own reason.
    let whole = item.get("parts").is_some();
    expect(item["verdict"] != "verified" || !is_equality || whole || !reason.is_null(), "a reason is given", item)
}

fn expect(holds: bool, what: &str, found: &Value) -> Result<(), String> {
    if holds { Ok(()) } else { Err(format!("broken: {what}, in {found:#}")) }
}

#[test]
fn the_promise_is_kept_by_a_sound_and_by_an_unsound_report() {
    let desk = Desk::with_the_derivations("contract");
    let notes = |path: &str| desk.read(path);
    let sound = desk.onshell(&["check", "derivations", "--format", "json"]);
    assert_eq!(sound.code, 0);
    assert_eq!(kept(&sound.json(), notes), Ok(()));
    assert_eq!(sound.json()["summary"]["unexpected"], 0);

    desk.change("derivations/06-spinning-top.md", SIGN);
    let unsound = desk.onshell(&["check", "derivations", "--format", "json"]);
    assert_eq!(unsound.code, 1);
    assert_eq!(kept(&unsound.json(), notes), Ok(()));
    assert_ne!(unsound.json()["summary"]["unexpected"], 0);
}

#[test]
fn a_broken_promise_is_seen() {
    let desk = Desk::with_the_derivations("broken-contract");
    let notes = |path: &str| desk.read(path);
    let report = desk.onshell(&["check", "derivations", "--format", "json"]).json();
    for (pointer, wrong) in [
        ("/schema", json!(2)),
        ("/documents/0/path", json!(7)),
        ("/documents/0/equations/0/id", json!(5.63)),
        ("/documents/0/equations/0/line", json!(0)),
        ("/documents/0/equations/0/latex", json!("E = mc^2")),
        ("/documents/0/equations/0/verdict", json!("true")),
        ("/documents/0/equations/0/verdict", json!("refuted")),
        ("/documents/0/equations/0/points", json!(1e9 as u64)),
        ("/documents/0/equations/0/max_residual", json!("NaN")),
        ("/documents/0/equations/0/false_accept_log2", json!(-80.0)),
        ("/documents/0/equations/0/not_certified_because", json!("")),
        ("/documents/0/claims", json!(null)),
        ("/documents/0/equations/0/code", json!("no-code")),
        ("/documents/0/equations/0/code", json!(null)),
        ("/documents/0/equations/0/file", json!(null)),
        ("/documents/0/equations/0/file", json!("other.md")),
        ("/documents/0/equations/0/column", json!(0)),
        ("/documents/0/equations/0/span/start", json!(null)),
        ("/documents/0/equations/0/span/end", json!(1e9 as u64)),
        ("/documents/0/equations/0/span/line", json!(1)),
        ("/documents/0/equations/0/difference", json!({ "latex": "0", "text": "0" })),
        ("/summary/unexpected", json!(1)),
    ] {
        let mut changed = report.clone();
        *changed.pointer_mut(pointer).unwrap_or_else(|| panic!("no {pointer}")) = wrong.clone();
        let result = std::panic::catch_unwind(|| kept(&changed, notes));
        assert!(!matches!(result, Ok(Ok(()))), "{pointer} may be {wrong}");
    }
}

#[test]
fn a_certificate_is_bounded_and_its_lack_is_explained() {
    let desk = Desk::new("certificates");
    let checked = |latex: &str| {
        desk.write("claims.json", r#"{ "notes": "notes.md", "constants": { "a, b": "> 0", "x, y": "any" } }"#);
        desk.write("notes.md", format!("$$ {latex} \\tag{{1}} $$\n"));
        let report = desk.onshell(&["check", "claims.json", "--format", "json"]).json();
        assert_eq!(kept(&report, |path| desk.read(path)), Ok(()));
        report["documents"][0]["equations"][0].clone()
    };
    let certified = checked("(x + y)^2 = x^2 + 2xy + y^2");
    assert_eq!(certified["verdict"], "certified");
    for (key, wrong) in [
        ("verdict", json!("verified")),
        ("false_accept_log2", json!(null)),
        ("false_accept_log2", json!(-79.0)),
        ("false_accept_log2", json!("small")),
        ("not_certified_because", json!("it is")),
    ] {
        let mut changed = certified.clone();
        changed[key] = wrong.clone();
        assert!(certificate(&changed).is_err(), "{key} may be {wrong}");
    }
    let verified = checked(r"\ln(a^7) = 7 \ln a");
    assert_eq!(verified["verdict"], "verified");
    for (key, wrong) in [
        ("verdict", json!("certified")),
        ("false_accept_log2", json!(-200.0)),
        ("not_certified_because", json!(null)),
        ("not_certified_because", json!("")),
    ] {
        let mut changed = verified.clone();
        changed[key] = wrong.clone();
        assert!(certificate(&changed).is_err(), "{key} may be {wrong}");
    }
    // What only the field refutes has no state to show.
    let refuted = checked(r"\left(1 + \frac{1}{10^{16}}\right) x = x");
    assert_eq!((&refuted["verdict"], &refuted["counterexample"]), (&json!("refuted"), &json!(null)));
    assert_eq!(
        checked(r"a \geq a - b")["not_certified_because"],
        "an inequality, because only an equality can have a certificate"
    );
}

#[test]
fn paths_are_as_seen_from_where_the_command_was_started() {
    let desk = Desk::with_the_derivations("paths");
    for given in ["derivations", "derivations/06-spinning-top.md", "derivations/06-spinning-top.json"] {
        let report = desk.onshell(&["check", given, "--only", "6.73", "--format", "json"]).json();
        assert_eq!(report["documents"][0]["path"], "derivations/06-spinning-top.md");
        assert_eq!(report["documents"][0]["claims"], "derivations/06-spinning-top.json");
    }
}

#[test]
fn every_number_of_the_notes_is_in_the_report_once_and_has_a_verdict() {
    let desk = Desk::with_the_derivations("numbers");
    let report = desk.onshell(&["check", "derivations", "--format", "json"]).json();
    let equations = || report["documents"].as_array().unwrap().iter().flat_map(|d| d["equations"].as_array().unwrap());
    let mut ids: Vec<&str> = equations().map(|equation| equation["id"].as_str().unwrap()).collect();
    ids.sort_by_key(|id| id.split('.').map(|part| part.parse().unwrap()).collect::<Vec<u32>>());
    let sections = [(2, 1..=32), (3, 33..=56), (4, 57..=62), (5, 63..=70), (6, 71..=78)];
    let all: Vec<String> =
        sections.into_iter().flat_map(|(section, numbers)| numbers.map(move |n| format!("{section}.{n}"))).collect();
    assert_eq!(ids, all);
    for equation in equations() {
        let verdict = equation["verdict"].as_str().unwrap();
        assert!(["certified", "verified", "definition", "law", "refuted"].contains(&verdict), "{equation}");
        assert_eq!(equation["ok"], true, "{equation}");
    }
}

#[test]
fn several_statements_under_one_number_are_parts_and_the_worst_counts() {
    let desk = Desk::with_the_derivations("parts");
    desk.change(
        "derivations/06-spinning-top.md",
        ("\\Omega_{-} \\approx \\frac{MgR}", "\\Omega_{-} \\approx \\frac{2MgR}"),
    );
    let report = desk.onshell(&["check", "derivations", "--only", "6.76", "--format", "json"]).json();
    let equation = &report["documents"][0]["equations"][0];
    let verdicts: Vec<&Value> = equation["parts"].as_array().unwrap().iter().map(|part| &part["verdict"]).collect();
    assert_eq!(verdicts, ["verified", "refuted"]);
    assert_eq!(equation["verdict"], "refuted");
    let latex = |k: usize| equation["parts"][k]["latex"].as_str().unwrap();
    assert!(latex(0).contains("\\Omega_{+}") && !latex(0).contains("\\Omega_{-}"), "{}", latex(0));
    assert!(latex(1).contains("\\Omega_{-}") && !latex(1).contains("\\Omega_{+}"), "{}", latex(1));
}

/// Whether an error in a report has a code that can be explained, and a place wherever it is about a file.
fn error_kept(error: &Value, file: Option<&str>) -> Result<(), String> {
    let codes: Vec<&str> = Code::ALL.iter().map(|code| code.word()).collect();
    expect(error["code"].as_str().is_some_and(|code| codes.contains(&code)), "code is one", error)?;
    expect(error["message"].as_str().is_some_and(|text| !text.is_empty()), "message is a string", error)?;
    expect(error["help"].is_string() || error["help"].is_null(), "help is a string or null", error)?;
    expect(error.get("file").and_then(Value::as_str) == file, "file is the one", error)?;
    for key in ["path", "line", "column", "span"] {
        expect(error.get(key).is_some() == file.is_some(), "a place is there or left out", error)?;
        expect(error.get(key).is_none_or(|value| !value.is_null()), "a place is never null", error)?;
    }
    Ok(())
}

#[test]
fn an_error_is_json_too() {
    let desk = Desk::new("contract-errors");
    desk.write("notes.md", "$$ a = a \\tag{1} $$\n");
    desk.write("notes.json", "{ \"notes\": \"notes.md\", \"constnats\": {} }");
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let error = run.json()["errors"][0].clone();
    assert_eq!((run.code, error_kept(&error, Some("notes.json"))), (2, Ok(())));
    assert_eq!((&error["code"], &error["line"], &error["column"]), (&json!("claims-file"), &json!(1), &json!(24)));
    assert_eq!(error["span"], json!({ "start": 23, "end": 34, "line": 1, "column": 24 }));
    let absent = desk.onshell(&["check", "absent.md", "--format", "json"]);
    assert_eq!((absent.code, error_kept(&absent.json()["errors"][0], None)), (2, Ok(())));
    for (arguments, file) in [
        (&["equal", "a +", "b"][..], Some("left formula")),
        (&["equal", "a", "b +"], Some("right formula")),
        (&["equal", "a", "b", "--where", "a=7"], None),
        (&["eval", "a +"], Some("formula")),
        (&["eval", "a"], None),
        (&["derive", "quark"], None),
    ] {
        let run = desk.onshell(&[arguments, &["--format", "json"]].concat());
        let output = run.json();
        assert_eq!((run.code, error_kept(&output["error"], file)), (2, Ok(())), "{arguments:?}");
        assert_eq!(output["schema"], 1);
        // People are told as well.
        assert!(run.err.starts_with("error["), "{}", run.err);
    }
    let read = desk.onshell(&["read", "a +", "--format", "json"]);
    assert_eq!((read.code, error_kept(&read.json()["errors"][0], Some("formula"))), (2, Ok(())));
    // The check can fail.
    let mut wrong = error.clone();
    wrong["span"] = json!(null);
    assert!(error_kept(&wrong, Some("notes.json")).is_err() && error_kept(&error, None).is_err());
}

#[test]
fn notes_without_claims_have_no_claims_in_the_report() {
    let desk = Desk::new("contract-no-claims");
    desk.write("notes.md", "$$ a = a \\tag{1} $$\n");
    let report = desk.onshell(&["check", ".", "--format", "json"]).json();
    assert_eq!(kept(&report, |path| desk.read(path)), Ok(()));
    assert_eq!(report["documents"][0].get("claims"), None);
    assert_eq!(report["documents"][0]["equations"][0]["code"], "same-formula");
}

#[test]
fn a_formula_and_its_value_are_json_too() {
    let desk = Desk::new("contract-formulas");
    let value = desk.onshell(&["eval", "x^2", "--set", "x=1.5", "--format", "json"]).json();
    assert_eq!(value, json!({ "schema": 1, "value": 2.25 }));
    let read = desk.onshell(&["read", "E = m c^2", "--format", "json"]).json();
    assert_eq!(read, json!({ "schema": 1, "statements": ["E = m·c^2"], "assumed": ["E", "m", "c"], "errors": [] }));
}
