//! JSON with the place of everything.

use super::*;

#[test]
fn values_and_their_places() {
    let text = "\u{feff}{ \"a\": [1e400, \"\\\\theta\", null, true], \"é\\\\\": {} }";
    let json = json::read(text).unwrap();
    let Value::Object(entries) = &json.value else { panic!() };
    assert_eq!(&text[entries[0].0.span.range()], "\"a\"");
    assert_eq!((entries[1].0.value.as_str(), &text[entries[1].0.span.range()]), ("é\\", "\"é\\\\\""));
    let Value::Array(items) = &entries[0].1.value else { panic!() };
    assert_eq!(items[0].value, Value::Number("1e400".into()));
    assert_eq!((&items[1].value, &text[items[1].span.range()]), (&Value::String("\\theta".into()), "\"\\\\theta\""));
}

#[test]
fn control_characters() {
    for (written, word) in [
        ("\\theta", "a tab"),
        ("\\nu", "a line break"),
        ("\\beta", "a backspace"),
        ("\\frac", "a form feed"),
        ("\\rho", "a carriage return"),
        ("\\phi", "is not an escape of JSON"),
        ("\\,", "is not an escape of JSON"),
        ("\\upsilon", "is not an escape of JSON"),
    ] {
        let (error, at) = refused(&with(&format!("\"assume\": \"1 + {written} = 0\"")));
        assert!(error.contains(word) && error.contains(&format!("write \"\\{written}\"")), "{error}");
        assert_eq!(at, written);
    }
    assert!(refused(&with("\"assume\": \"\\u0007\"")).0.contains("control character"));
    assert!(refused(&with("\"assume\": \"\\ud800\"")).0.contains("not JSON"));
    assert!(refused(&with("\"assume\": \"a\nb\"")).0.contains("contains a line break"));
    let assume = claims(&with("\"assume\": \"\\\\theta = \\u0061\"")).unwrap().assume;
    assert_eq!(assume[0].value, "\\theta = a");
}

#[test]
fn duplicate_keys_at_any_level() {
    for text in [
        "{ \"notes\": \"a\",\n\"notes\": \"b\" }".to_owned(),
        with("\"equations\": { \"6.1\": {},\n\"6.1\": {} }"),
        with("\"equations\": { \"6.1\": { \"where\": { \"a\": \"1\",\n\"\\u0061\": \"2\" } } }"),
    ] {
        let (error, _) = refused(&text);
        assert!(error.contains("given twice; first in line 1") && error.contains(":2:"), "{error}");
    }
}

#[test]
fn broken() {
    for (text, word) in [
        ("", "empty"),
        (" \n", "empty"),
        ("{\"notes\": \"a\"", "ends in the middle of a value"),
        ("{\"notes\": \"a", "ends in the middle of a value"),
        ("{", "ends in the middle of a value"),
        ("{} x", "follows the end"),
        ("{\"a\": 1,}", "comma"),
        ("{\"a\" 1}", "not JSON"),
        ("{'a': 1}", "not JSON"),
        ("nul", "ends in the middle of a value"),
        ("{\"a\": NaN}", "not JSON"),
    ] {
        assert!(refused(text).0.contains(word), "{text}: {}", refused(text).0);
    }
    assert!(
        refused("{\n  \"a\": 1,\n  \"b\" 2\n}").0.starts_with("claims.json:3:7"),
        "{}",
        refused("{\n  \"a\": 1,\n  \"b\" 2\n}").0
    );
}

#[test]
fn a_place_within_a_string() {
    let text = r#"x "a \\phi \u00e9 b""#;
    let token = onshell::source::Span::new(2, text.len());
    // In the string: `a \phi é b`.
    for (part, shown) in [(2..6, r"\\phi"), (7..9, r"\u00e9"), (10..11, "b"), (0..1, "a")] {
        assert_eq!(&text[json::place_in_string(text, token, part.into()).range()], shown);
    }
}
