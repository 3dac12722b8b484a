//! Claims files: what is read from them, and what is refused where.

use super::*;

const TOP: &str = r##"{ "notes": "heavy-top.md", "system": { "name": "heavy_top", "read": { "l": "R" } },
  "independent variable": "t",
  "coordinates": { "\\theta": "(0, \\pi)", "\\phi, \\psi": "angle" },
  "varies with time": { "u": "any" },
  "constants": { "M, g, R, \\lambda_1": "> 0", "n": "integer 2..5", "q": "< 0" },
  "functions": { "V": "of r, t" }, "indices": { "i, j": "1..n", "a": "1..3" },
  "rotations": { "\\mathbf R_z(\\alpha)": "of the axes" }, "components": { "\\vec r": "x, y, z" },
  "means": { "L": "Lagrangian", "T, U": "kinetic energy" },
  "define": { "\\Omega": "\\dot\\phi" }, "macros": { "\\PD": "x" },
  "conditions": { "steady": "\\dot\\theta = 0", "two": ["a", "b"] }, "assume": ["x"],
  "equations": {
"6.74": { "throughout": "steady", "holds": "on shell", "continuum limit of": "6.73, 6.72 row 2 part 1 .. #veff" },
"6.75": { "solves": "6.74", "for": "\\Omega" },
"6.76": { "limit": "\\omega_3 \\to \\infty", "conserved": true },
"6.77": { "generates": "the motion", "solves": "equations of motion", "for": ["x", "y"] },
"6.78": { "also equals": "H", "assume": ["a", "b"], "dropping": "c", "where": { "m": "1" } },
"every `\\dot{z} = 2c`": { "erratum": { "for": "a", "read": "b", "times": 2 } },
"eqn:x": { "expect": "refuted", "because": "of it" },
"(6.79)": { "skip": "no claim", "conserved": "E" } },
  "sentences": [
{ "quote": "a" }, { "quote": "b", "claim": "x > 0", "in": "6.78", "name": "bee" }, { "quote": "c", "not always": "x" }, { "quote": "d", "conserved": "E" },
{ "quote": "e", "of": "U", "minima": 1, "against": "\\theta", "expect": "refuted", "because": "x" },
{ "quote": "f", "of": "U", "tends to": { "x \\to 0": "1" } }, { "quote": "g", "of": "6.74", "solutions": 2, "for": "x" },
{ "quote": "h", "of": "U", "independent of": ["x"] }, { "quote": "i", "of": "U", "sign": "changes" } ] }"##;

#[test]
fn everything() {
    let claims = claims(TOP).unwrap();
    let text = &claims.source.text;
    assert_eq!(claims.system.as_ref().unwrap().read[0].1.value, "R");
    let names: Vec<_> =
        claims.declarations.iter().map(|d| (d.role, d.name.value.as_str(), &text[d.name.span.range()])).collect();
    assert_eq!(
        names[..3],
        [
            (Role::Coordinate, "\\theta", "\\\\theta"),
            (Role::Coordinate, "\\phi", "\\\\phi"),
            (Role::Coordinate, "\\psi", "\\\\psi")
        ]
    );
    assert!(names.contains(&(Role::Constant, "g", "g")) && names.contains(&(Role::Function, "V", "V")));
    assert_eq!(claims.means.len(), 3);
    assert_eq!(claims.rotations[0].1.value, Turning::Axes);
    assert_eq!(claims.conditions[1].1.len(), 2);
    let claim = |i: usize| &claims.equations[i].1;
    assert_eq!(claim(0).holds.as_ref().unwrap().value, Holds::OnShell);
    assert_eq!(claim(0).continuum_limit_of.as_ref().unwrap().items.len(), 2);
    assert!(matches!(claim(1).solves.as_ref().unwrap().of, Solved::Equation(_)));
    assert!(matches!(claim(3).solves.as_ref().unwrap().of, Solved::EquationsOfMotion(_)));
    assert_eq!(claim(5).errata[0].times, 2);
    assert_eq!(claim(6).expect.as_ref().unwrap().verdict.value, Expected::Refuted);
    let tests: Vec<_> = claims.sentences.iter().map(|s| &s.test).collect();
    assert!(matches!(tests[0], Test::Quoted) && matches!(tests[1], Test::Claim(_)));
    assert!(matches!(tests[3], Test::Conserved(_)) && claims.sentences[3].claim.conserved.is_none());
    assert!(matches!(tests[4], Test::Of(_, Property::Minima(n)) if n.value == 1));
    assert!(matches!(tests[6], Test::Solutions { count, .. } if count.value == 2));
}

#[test]
fn ranges() {
    let range = |text: &str| {
        claims(&with(&format!("\"constants\": {{ \"x\": \"{text}\" }}"))).map(|c| c.declarations[0].range.value.clone())
    };
    let pi = std::f64::consts::PI;
    let interval = |low, high, low_open, high_open| Range::Interval { low, high, low_open, high_open };
    for (text, expected) in [
        ("> 0", Range::Positive),
        (">0", Range::Positive),
        ("< 0", Range::Negative),
        ("any", Range::Any),
        ("angle", Range::Angle),
        ("(0, \\\\pi)", interval(0.0, pi, true, true)),
        ("[0.2, 2.9]", interval(0.2, 2.9, false, false)),
        ("(-\\\\pi/2, \\\\frac{3\\\\pi}{2}]", interval(-pi / 2.0, 3.0 * pi / 2.0, true, false)),
        ("[-1e-3, 2\\\\,\\\\pi)", interval(-1e-3, 2.0 * pi, false, true)),
        ("[0, \\\\frac\\\\pi2]", interval(0.0, pi / 2.0, false, false)),
        ("[0, \\\\frac{1}{10}\\\\pi]", interval(0.0, pi / 10.0, false, false)),
        ("integer 2..5", Range::Integer { low: 2, high: Count::Number(5) }),
    ] {
        assert_eq!(range(text).unwrap(), expected, "{text}");
    }
    for text in [
        "(1, 0)",
        "[1, 1]",
        "[0, 1e400]",
        "[NaN, 1]",
        "[0, inf]",
        "[0, nan]",
        "positive",
        "agnle",
        "(0, 1",
        "(0)",
        "(0, 1, 2)",
        "1..3",
        "integer 5..2",
        "integer 1..1",
        "integer 1..n",
        "integer 2..1e400",
        "[0, 1/0]",
        "[0, \\\\pi\\\\pi]",
        "(",
        "[]",
        "[,]",
        "[\\\\frac, 1]",
        "0",
    ] {
        let error = range(text).unwrap_err();
        assert!(error.advice().is_some(), "{text}");
        assert!(pointed(&error).contains(text), "{text}");
    }
    assert!(range("(1, 0)").unwrap_err().to_string().contains("ends before it begins"));
    assert!(range("agnle").unwrap_err().to_string().contains("did you mean \"angle\""));
    let indices = |text: &str| {
        claims(&with(&format!("\"indices\": {{ \"i\": \"{text}\" }}"))).map(|c| c.declarations[0].range.value.clone())
    };
    assert_eq!(indices("1..n").unwrap(), Range::Integer { low: 1, high: Count::Symbol("n".into()) });
    assert!(indices("3..1").is_err() && indices("any").is_err() && indices("1..").is_err());
}

#[test]
fn a_symbol_declared_twice() {
    for (rest, second, keys) in [
        ("\"constants\": { \"M\": \"> 0\", \"g, M\": \"> 0\" }", "M", ["twice under \"constants\"", "first at 1:"]),
        (
            "\"coordinates\": { \"p_{\\\\psi}\": \"any\" }, \"constants\": { \"p_ \\\\psi\": \"any\" }",
            "p_ \\\\psi",
            ["declared under \"coordinates\", at 1:", "and under \"constants\""],
        ),
        (
            "\"functions\": { \"V\": \"of r\" }, \"constants\": { \"V\": \"> 0\" }",
            "V",
            ["under \"functions\"", "under \"constants\""],
        ),
        (
            "\"constants\": { \"T\": \"> 0\" }, \"means\": { \"T\": \"kinetic energy\" }",
            "T",
            ["declared under \"constants\", at 1:", "and under \"means\""],
        ),
    ] {
        let (error, at) = refused(&with(rest));
        assert!(keys.iter().all(|key| error.contains(key)), "{error}");
        assert_eq!(at, second);
    }
    assert!(claims(&with("\"constants\": { \"M, m, F_{(a)}, F_{(b)}\": \"> 0\", \"\\\\bar M\": \"> 0\" }")).is_ok());
    assert!(refused(&with("\"constants\": { \"M,, m\": \"> 0\" }")).0.contains("missing"));
}

#[test]
fn keys() {
    let (error, at) = refused(&with("\"constnats\": {}"));
    assert!(error.contains("did you mean \"constants\"?"), "{error}");
    assert_eq!(at, "\"constnats\"");
    assert!(refused(&with("\"equations\": { \"6.1\": { \"asume\": \"x\" } }")).0.contains("did you mean \"assume\"?"));
    assert!(
        refused(&with("\"sentences\": [{ \"quote\": \"x\", \"signs\": \"y\" }]")).0.contains("did you mean \"sign\"?")
    );
    for rest in [
        "\"covers\": \"6\"",
        "\"unsure\": {}",
        "\"equations\": { \"6.1\": { \"starting at\": \"x\" } }",
        "\"sentences\": [{ \"quote\": \"x\", \"minimum of\": \"y\" }]",
    ] {
        assert!(refused(&with(rest)).0.contains("not supported yet"), "{rest}");
    }
    assert!(refused(&with("\"equations\": { \"6.1\": { \"units\": \"on\" } }")).0.contains("off"));
    assert!(refused("{ \"equations\": {} }").0.contains("needs \"notes\""));
    assert!(refused("[]").0.contains("must be an object, { … }, not a list"));
}

#[test]
fn types() {
    for (rest, word) in [
        ("\"assume\": 1", "a string or a list of strings, not a number"),
        ("\"system\": []", "a name or an object"),
        ("\"constants\": { \"M\": 1 }", "a string, not a number"),
        ("\"equations\": []", "an object, { … }, not a list"),
        ("\"equations\": { \"6.1\": true }", "an object, { … }, not true or false"),
        ("\"sentences\": {}", "a list, not an object"),
        ("\"equations\": { \"6.1\": { \"conserved\": 1 } }", "true or LaTeX"),
        ("\"equations\": { \"6.1\": { \"conserved\": false } }", "is true"),
        ("\"equations\": { \"6.1\": { \"times\": \"2\" } }", "\"times\" is not supported yet"),
        ("\"equations\": { \"6.1\": { \"assume\": [] } }", "empty list"),
        ("\"equations\": { \"6.1\": { \"skip\": \"\" } }", "empty"),
        ("\"sentences\": [{ \"quote\": \"x\", \"of\": \"U\", \"minima\": 1.5 }]", "whole number"),
        ("\"sentences\": [{ \"quote\": \"x\", \"of\": \"U\", \"minima\": 1e400 }]", "whole number"),
    ] {
        assert!(refused(&with(rest)).0.contains(word), "{}", refused(&with(rest)).0);
    }
}

#[test]
fn keys_that_need_each_other() {
    let equation = |claim: &str| refused(&with(&format!("\"equations\": {{ \"6.1\": {{ {claim} }} }}"))).0;
    assert!(equation("\"solves\": \"6.2\"").contains("needs \"for\""));
    assert!(equation("\"for\": \"x\"").contains("needs \"solves\""));
    assert!(equation("\"expect\": \"refuted\"").contains("needs \"because\""));
    assert!(equation("\"because\": \"x\"").contains("needs \"expect\""));
    assert!(equation("\"expect\": \"verified\", \"because\": \"x\"").contains("do not pass"));
    assert!(equation("\"expect\": \"refutd\", \"because\": \"x\"").contains("did you mean \"refuted\"?"));
    assert!(equation("\"holds\": \"on-shell\"").contains("did you mean \"on shell\"?"));
    assert!(equation("\"erratum\": { \"for\": \"x\" }").contains("needs \"read\""));
    assert!(equation("\"erratum\": { \"for\": \"x\", \"read\": \"y\", \"times\": 0 }").contains("at least 1"));
    assert!(equation("\"limit\": \"x = 0\"").contains("is not a limit"));
    let sentence = |rest: &str| refused(&with(&format!("\"sentences\": [{{ {rest} }}]"))).0;
    assert!(sentence("\"claim\": \"x\"").contains("needs \"quote\""));
    assert!(sentence("\"quote\": \"q\", \"claim\": \"x\", \"not always\": \"x\"").contains("one test"));
    assert!(sentence("\"quote\": \"q\", \"minima\": 1").contains("needs \"of\""));
    assert!(sentence("\"quote\": \"q\", \"of\": \"U\"").contains("says nothing about the expression under \"of\""));
    assert!(sentence("\"quote\": \"q\", \"of\": \"U\", \"minima\": 1, \"sign\": \"positive\"").contains("one test"));
    assert!(sentence("\"quote\": \"q\", \"of\": \"6.1\", \"solutions\": 1").contains("needs \"for\""));
    assert!(sentence("\"quote\": \"q\", \"of\": \"U\", \"sign\": \"up\"").contains("cannot be"));
}
