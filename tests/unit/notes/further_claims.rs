//! Claims that say for which index, up to which order, in which limit and exactly when an equation holds; and
//! sentences that cite one.

use onshell::notes::Claim;

use super::*;

fn equation(claim: &str) -> String {
    with(&format!("\"equations\": {{ \"6.1\": {{ {claim} }} }}"))
}

fn claim(text: &str) -> Claim {
    claims(&equation(text)).unwrap().equations.remove(0).1
}

fn values(texts: &[json::Spanned<String>]) -> Vec<&str> {
    texts.iter().map(|text| text.value.as_str()).collect()
}

#[test]
fn what_is_small() {
    let one = claim(r#""small": "\\omega_2, \\omega_3", "for each": "i", "units": "off""#);
    assert_eq!(values(&one.small), ["\\omega_2", "\\omega_3"]);
    assert_eq!(one.order.unwrap().value, 1);
    assert_eq!(one.for_each.unwrap().value, "i");
    assert!(one.units_off.is_some());
    let two = claim(r#""small": ["a", "b, c"], "order": 2"#);
    assert_eq!((values(&two.small), two.order.unwrap().value), (vec!["a", "b", "c"], 2));
    let none = claim("");
    assert!(none.small.is_empty() && none.order.is_none() && none.units_off.is_none() && none.for_each.is_none());
    for (text, word, at) in [
        (r#""order": 2"#, "needs \"small\"", "\"order\""),
        (r#""small": "x", "order": 1.5"#, "whole number", "1.5"),
        (r#""small": "x", "order": 100"#, "at most 9", "100"),
        (r#""small": "x", "order": "1""#, "must be a number", "\"1\""),
        (r#""small": "x,""#, "a name is missing", "\"x,\""),
        (r#""small": []"#, "empty list", "[]"),
        (r#""units": "on""#, "the only value is \"off\"", "\"on\""),
        (r#""for each": ["i"]"#, "must be a string", "[\"i\"]"),
    ] {
        let (error, place) = refused(&equation(text));
        assert!(error.contains(word), "{error}");
        assert_eq!(place, at);
    }
}

#[test]
fn true_exactly_when() {
    let alternatives = |text: &str| {
        let claim = claim(&format!("\"true exactly when\": {text}"));
        claim.exactly_when.iter().map(|all| values(all).join(" and ")).collect::<Vec<_>>().join(" or ")
    };
    assert_eq!(alternatives(r#""a = b""#), "a = b");
    assert_eq!(alternatives(r#"["a = b", "steady"]"#), "a = b and steady");
    assert_eq!(alternatives(r#"{ "any of": ["a", ["b", "c"]] }"#), "a or b and c");
    for (text, word, at) in [
        ("{}", "is empty", "{}"),
        ("[]", "empty list", "[]"),
        ("{ \"any of\": [] }", "a list of conditions", "[]"),
        ("{ \"any of\": \"a\" }", "a list of conditions", "\"a\""),
        ("{ \"any of\": [1] }", "a string or a list", "1"),
        ("{ \"all of\": [\"a\"] }", "did you mean \"any of\"?", "\"all of\""),
        ("true", "a string or a list", "true"),
    ] {
        let (error, place) = refused(&equation(&format!("\"true exactly when\": {text}")));
        assert!(error.contains(word), "{error}");
        assert_eq!(place, at, "{error}");
    }
}

#[test]
fn limits_of_sums_and_meanings() {
    let claim = claim(r#""continuum limit of": "3.45", "where": { "m_i": "m_i \\cup M_0" }"#);
    assert_eq!(claim.continuum_limit_of.unwrap().text, "3.45");
    assert_eq!(claim.meanings[0].1.value, "m_i \\cup M_0");
    let (error, at) = refused(&equation(r#""continuum limit of": "two words""#));
    assert!(error.contains("is not an address of an equation"), "{error}");
    assert_eq!(at, "two words");
}

#[test]
fn sentences_take_them_too() {
    let text = r#""sentences": [{ "quote": "q", "claim": "x", "small": "a", "order": 2, "true exactly when": "b", "units": "off" }]"#;
    let claim = claims(&with(text)).unwrap().sentences.remove(0).claim;
    assert_eq!((values(&claim.small), claim.order.unwrap().value), (vec!["a"], 2));
    assert!(claim.units_off.is_some() && claim.exactly_when.len() == 1);
}

#[test]
fn a_sentence_that_cites() {
    let sentence = |rest: &str| with(&format!("\"sentences\": [{{ \"quote\": \"q\", {rest} }}]"));
    let file = claims(&sentence(r#""refers to": "4.58", "containing": "\\vec F_i""#)).unwrap();
    let Test::RefersTo { number, containing } = &file.sentences[0].test else { panic!() };
    assert_eq!((number.value.as_str(), containing.value.as_str()), ("4.58", "\\vec F_i"));
    assert_eq!(file.source.slice(number.span), "\"4.58\"");
    for (rest, word, at) in [
        (r#""refers to": "4.58""#, "needs \"containing\" beside it", "\"refers to\""),
        (r#""containing": "x""#, "needs \"refers to\" beside it", "\"containing\""),
        (r#""refers to": "4.58", "containing": "x", "claim": "y""#, "one test", "\"refers to\""),
    ] {
        let (error, place) = refused(&sentence(rest));
        assert!(error.contains(word), "{error}");
        assert_eq!(place, at);
    }
}
