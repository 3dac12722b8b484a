//! What a claims file says of the world: axes and components, motions, labels, laws, units, continua.

use onshell::notes::claims::{Axes, Components, Continuum, SolidKind};

use super::*;

/// The text of each, and what the file has at its place.
fn placed<T>(claims: &Claims, named: &[(json::Spanned<String>, json::Spanned<T>)]) -> Vec<(String, String)> {
    let own = |(name, value): &(json::Spanned<String>, json::Spanned<T>)| {
        assert_eq!(claims.source.slice(name.span).trim_matches('"').replace("\\\\", "\\"), name.value);
        (name.value.clone(), claims.source.slice(value.span).to_owned())
    };
    named.iter().map(own).collect()
}

#[test]
fn axes() {
    let file =
        claims(&with(r#""axes": { "\\hat x, \\hat y, \\hat z": "fixed", "\\hat e_a": "turning with \\vec\\omega" }"#))
            .unwrap();
    let found = placed(&file, &file.axes);
    assert_eq!(
        found.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(),
        ["\\hat x", "\\hat y", "\\hat z", "\\hat e_a"]
    );
    assert_eq!(file.axes[2].1.value, Axes::Fixed);
    assert_eq!(file.axes[3].1.value, Axes::TurningWith("\\vec\\omega".into()));
    for (value, at) in [("turning", "\"turning\""), ("turning with", "\"turning with\""), ("Fixed", "\"Fixed\"")] {
        let (error, place) = refused(&with(&format!("\"axes\": {{ \"\\\\hat x\": \"{value}\" }}")));
        assert!(error.contains("turning with \\\\vec\\\\omega"), "{error}");
        assert_eq!(place, at);
    }
    let (error, at) = refused(&with(r#""axes": { "\\hat x": "fixed" }, "means": { "\\hat{x}": "body axes" }"#));
    assert!(error.contains("declared under \"axes\"") && error.contains("and under \"means\""), "{error}");
    assert_eq!(at, "\\\\hat{x}");
}

#[test]
fn components() {
    let file =
        claims(&with(r#""components": { "\\vec r_i": "x_i, y_i, z_i", "\\vec L, \\vec N": "along \\hat e_a" }"#))
            .unwrap();
    let Components::Names(names) = &file.components[0].1.value else { panic!() };
    assert_eq!(names.each_ref().map(|name| file.source.slice(name.span)), ["x_i", "y_i", "z_i"]);
    let Components::Along(axes) = &file.components[2].1.value else { panic!() };
    assert_eq!((file.components[2].0.value.as_str(), axes.value.as_str()), ("\\vec N", "\\hat e_a"));
    assert_eq!(file.source.slice(axes.span), "\\\\hat e_a");
    for (value, word, at) in [
        (r#""\\vec r": "x, y""#, "three components, not 2", "\"x, y\""),
        (r#""\\vec r": "along""#, "are missing", "\"along\""),
        (r#""\\vec r": "x, y,""#, "a name is missing", "\"x, y,\""),
        (r#""\\vec r, \\vec s": "x, y, z""#, "cannot share", "\\\\vec s"),
    ] {
        let (error, place) = refused(&with(&format!("\"components\": {{ {value} }}")));
        assert!(error.contains(word), "{error}");
        assert_eq!(place, at);
    }
}

#[test]
fn motions_of_vectors() {
    let range = |role: &str, text: &str| {
        claims(&with(&format!("\"{role}\": {{ \"\\\\vec v\": \"{text}\" }}")))
            .map(|c| c.declarations[0].range.value.clone())
    };
    let rigid =
        |about: Option<&str>| Range::Rigid { turning_with: "\\vec \\omega".into(), about: about.map(str::to_owned) };
    for (text, expected) in [
        ("rigid, turning with \\\\vec \\\\omega", rigid(None)),
        ("rigid, turning with \\\\vec \\\\omega about \\\\vec c", rigid(Some("\\vec c"))),
        ("fixed direction", Range::FixedDirection),
        ("> 0", Range::Positive),
    ] {
        assert_eq!(range("varies with time", text).unwrap(), expected);
        // Nothing that has an equation of motion, or stands still, moves so.
        for role in ["coordinates", "constants"].into_iter().filter(|_| expected != Range::Positive) {
            let error = range(role, text).unwrap_err();
            assert!(error.advice().unwrap().contains("varies with time"), "{error}");
            assert_eq!(pointed(&error), format!("\"{text}\""));
        }
    }
    for text in
        ["rigid", "rigid, turning", "rigid, turning with", "rigid turning with x", "rigid, turning with x about"]
    {
        let error = range("varies with time", text).unwrap_err();
        assert!(error.advice().unwrap().contains("write \"rigid, turning with"), "{error}");
        assert_eq!(pointed(&error), format!("\"{text}\""));
    }
}

#[test]
fn indices_and_labels() {
    let range = |text: &str| {
        claims(&with(&format!("\"indices\": {{ \"i\": \"{text}\" }}"))).map(|c| c.declarations[0].range.value.clone())
    };
    let to = |name: &str| Count::Symbol(name.into());
    for (text, expected) in [
        ("1..3", Range::Integer { low: 1, high: Count::Number(3) }),
        ("1..\\\\mathcal{N}_1", Range::Integer { low: 1, high: to("\\mathcal{N}_1") }),
        ("labels 1..4", Range::Labels { high: Count::Number(4) }),
        ("labels 1..n", Range::Labels { high: to("n") }),
    ] {
        assert_eq!(range(text).unwrap(), expected);
    }
    for text in ["labels", "labels 2..4", "labels 1..0", "labels n", "1..n-1", "1..2n"] {
        let error = range(text).unwrap_err();
        assert!(error.advice().unwrap().contains("\"labels 1..3\""), "{error}");
        assert_eq!(pointed(&error), format!("\"{text}\""));
    }
    assert!(claims(&with("\"constants\": { \"i\": \"labels 1..4\" }")).is_err());
}

#[test]
fn laws_and_units() {
    let file = claims(&with(
        r#""laws": { "Newton's second law": "2.16", "the third": "\\vec F_{ij} = -\\vec F_{ji}" },
           "units": { "\\lambda_1, \\lambda_2": "kg m^2", "g": "m/s^2" }"#,
    ))
    .unwrap();
    assert_eq!(placed(&file, &file.laws)[0], ("Newton's second law".into(), "\"2.16\"".into()));
    let units: Vec<_> = file.units.iter().map(|(name, unit)| (name.value.as_str(), unit.value.as_str())).collect();
    assert_eq!(units, [("\\lambda_1", "kg m^2"), ("\\lambda_2", "kg m^2"), ("g", "m/s^2")]);
    for (rest, word, at) in [
        (r#""laws": { "F": 2 }"#, "must be a string, not a number", "2"),
        (r#""laws": { "F": " " }"#, "is empty", "\" \""),
        (r#""units": { "g": "m", "M, g": "kg" }"#, "declared twice", "g"),
        (r#""units": { "g": [] }"#, "must be a string, not a list", "[]"),
    ] {
        let (error, place) = refused(&with(rest));
        assert!(error.contains(word), "{error}");
        assert_eq!(place, at);
    }
}

fn continuum(inside: &str) -> String {
    with(&format!("\"continua\": {{ \"V\": {{ {inside} }} }}"))
}

#[test]
fn continua() {
    let file = claims(&continuum(
        r#""mass per volume": "\\rho(\\vec r)", "particles": "m_i at \\vec r_i", "uniform": true,
           "made of": [ { "ball": "R" }, { "ball": "\\frac12 R", "at": "\\frac12 R \\hat z", "hollow": true }, { "box": "a, b, c" } ]"#,
    ))
    .unwrap();
    let [Continuum { name, dimension: 3, density, point, particles: Some((mass, at)), uniform: true, made_of }] =
        file.continua.as_slice()
    else {
        panic!("{:?}", file.continua)
    };
    for (text, expected) in
        [(name, "V"), (density, "\\\\rho"), (point, "\\\\vec r"), (mass, "m_i"), (at, "\\\\vec r_i")]
    {
        assert_eq!(file.source.slice(text.span), expected);
        assert_eq!(text.value, expected.replace("\\\\", "\\"));
    }
    let kinds: Vec<_> = made_of.iter().map(|solid| (solid.kind.value, solid.hollow, solid.at.is_some())).collect();
    assert_eq!(kinds, [(SolidKind::Ball, false, false), (SolidKind::Ball, true, true), (SolidKind::Box, false, false)]);
    assert_eq!(made_of[1].size.value, "\\frac12 R");
    for (per, size, dimension) in [
        ("area", r#""shell": "R""#, 2),
        ("area", r#""lamina": "a, b""#, 2),
        ("area", r#""disc": "R""#, 2),
        ("length", r#""rod": "l""#, 1),
    ] {
        let file = claims(&continuum(&format!("\"mass per {per}\": \"s(x)\", \"made of\": [{{ {size} }}]"))).unwrap();
        let continuum = &file.continua[0];
        assert_eq!((continuum.dimension, continuum.made_of[0].kind.value.dimension()), (dimension, dimension));
        assert!(!continuum.uniform && continuum.particles.is_none());
    }
}

#[test]
fn continua_that_are_none() {
    let per_volume = r#""mass per volume": "\\rho(\\vec r)""#;
    for (inside, word, at) in [
        ("\"uniform\": true", "the density of V is missing", "{ \"uniform\": true }"),
        (&format!("{per_volume}, \"mass per area\": \"s(x)\""), "cannot both be given", "\"mass per volume\""),
        (r#""mass per volume": "\\rho""#, "does not name the density and the point", r#""\\rho""#),
        (r#""mass per volume": "(\\vec r)""#, "does not name the density and the point", r#""(\\vec r)""#),
        (&format!("{per_volume}, \"particles\": \"m_i\""), "does not name a mass and its position", "\"m_i\""),
        (&format!("{per_volume}, \"uniform\": false"), "the only value of \"uniform\" is true", "false"),
        (&format!("{per_volume}, \"made of\": []"), "must be a list of bodies", "[]"),
        (
            &format!("{per_volume}, \"made of\": [{{ \"at\": \"x\" }}]"),
            "the shape of this body is missing",
            "{ \"at\": \"x\" }",
        ),
        (&format!("{per_volume}, \"made of\": [{{ \"ball\": \"R\", \"box\": \"a, a, a\" }}]"), "one shape", "\"box\""),
        (&format!("{per_volume}, \"made of\": [{{ \"box\": \"a\" }}]"), "three edges", "\"a\""),
        (&format!("{per_volume}, \"made of\": [{{ \"ball\": \"R, R\" }}]"), "one length", "\"R, R\""),
        (&format!("{per_volume}, \"made of\": [{{ \"shell\": \"R\" }}]"), "use \"ball\" or \"box\"", "\"shell\""),
        (&format!("{per_volume}, \"made of\": [{{ \"bal\": \"R\" }}]"), "did you mean \"ball\"?", "\"bal\""),
        (r#""mass per length": "s(x)", "made of": [{ "disc": "R" }]"#, "use \"rod\"", "\"disc\""),
    ] {
        let (error, place) = refused(&continuum(inside));
        assert!(error.contains(word), "{error}");
        assert_eq!(place, at, "{error}");
    }
    let twice = r#""constants": { "V": "> 0" }, "continua": { "V": { "mass per length": "s(x)" } }"#;
    let error = refused(&with(twice)).0;
    assert!(error.contains("declared under \"continua\"") || error.contains("and under \"continua\""), "{error}");
}
