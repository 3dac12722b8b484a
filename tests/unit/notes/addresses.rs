//! How a claims file names an equation.

use onshell::notes::Address;

use super::*;

const NOTES: &str = "$$a = \\dot{z}\\,(2c) \\tag{6.72}$$\n\nx\n\n$$b = \\dot z \\tag{6.73}$$\n\nx\n\n$$c = 1 \\tag{6.78} \\label{eq:c}$$\n\n\
                     <!-- onshell: veff -->\n$$d = e$$\n\nx\n\n$$f \\tag{6.78b}$$\n\nx\n\n$$g$$\n\nx\n\n$$h \\label{dup}$$\n\nx\n\n$$i \\label{dup}$$\n";

fn resolve(address: &str) -> Result<Vec<usize>> {
    let notes = parse(NOTES, Kind::Markdown)?;
    let address = serde_json::to_string(address).unwrap();
    let claims = claims(&with(&format!("\"equations\": {{ {address}: {{}} }}")))?;
    claims.equations[0].0.resolve(&notes, &claims.source)
}

#[test]
fn found() {
    for (address, expected) in [
        ("6.72", vec![0]),
        ("(6.72)", vec![0]),
        ("eq:c", vec![2]),
        ("#veff", vec![3]),
        ("6.73 .. #veff", vec![1, 2, 3]),
        ("6.72..6.73", vec![0, 1]),
        ("6.78, 6.72", vec![2, 0]),
        ("`\\dot z (2 c)`", vec![0]),
        ("every `\\dot{z}`", vec![0, 1]),
        ("every `g`", vec![5]),
        ("6.72 row 2 part 1 step 3", vec![0]),
        ("`d = e` step 1", vec![3]),
        ("6.78b", vec![4]),
    ] {
        assert_eq!(resolve(address).unwrap(), expected, "{address}");
    }
}

#[test]
fn rows_parts_and_steps() {
    let claims = claims(&with("\"equations\": { \"6.72 row 2 step 3\": {}, \"6.1, 6.2\": {} }")).unwrap();
    let point = claims.equations[0].0.single().unwrap();
    assert_eq!((point.row, point.part, point.step), (Some(2), None, Some(3)));
    assert!(claims.equations[1].0.single().is_none());
}

#[test]
fn places() {
    let notes = parse(NOTES, Kind::Markdown).unwrap();
    let lookup = |address: &str| {
        let address = serde_json::to_string(address).unwrap();
        let claims = claims(&with(&format!("\"laws\": {{ \"a\": {address} }}"))).unwrap();
        let found = Address::parse(&claims.laws[0].1, &claims.source)
            .map_err(|fault| Error::fault(&claims.source, fault))?
            .lookup(&notes, &claims.source)?;
        Ok::<_, Error>(found.iter().map(|place| (place.display, place.row, place.part, place.step)).collect::<Vec<_>>())
    };
    let whole = |display| (display, None, None, None);
    for (address, expected) in [
        ("6.72", vec![whole(0)]),
        ("6.72 part 2", vec![(0, None, Some(2), None)]),
        ("6.72 row 2 part 1 step 3, 6.78", vec![(0, Some(2), Some(1), Some(3)), whole(2)]),
        ("every `\\dot z` row 1", vec![(0, Some(1), None, None), (1, Some(1), None, None)]),
        ("6.72 .. 6.78", vec![whole(0), whole(1), whole(2)]),
    ] {
        assert_eq!(lookup(address).unwrap(), expected, "{address}");
    }
    for (address, word, at) in [
        ("6.72 .. 6.73 part 2", "whole equations", "6.73 part 2"),
        ("6.72 step 1 .. 6.73", "whole equations", "6.72 step 1"),
        ("6.79 part 1", "no equation (6.79)", "6.79 part 1"),
        ("6.72 part 0", "needs one number", "6.72 part 0"),
    ] {
        let error = lookup(address).unwrap_err();
        assert!(error.to_string().contains(word), "{error}");
        assert!(error.advice().is_some());
        assert_eq!(pointed(&error), at);
    }
}

#[test]
fn not_found() {
    for (address, word) in [
        ("6.79", "notes has no equation (6.79) (did you mean 6.78?)"),
        ("eq:d", "did you mean eq:c?"),
        ("#vef", "did you mean #veff?"),
        ("`\\dot y`", "no display in notes contains"),
        ("`\\dot z`", "2 displays match"),
        ("dup", "2 displays match"),
        ("6.73 .. 6.72", "stands before the first"),
        ("every `\\dot z` .. 6.78", "one equation"),
    ] {
        let error = resolve(address).unwrap_err();
        assert!(error.to_string().contains(word), "{error}");
        assert!(error.place().is_some());
    }
}

#[test]
fn malformed() {
    for address in [
        "",
        " ",
        "6.72 row",
        "6.72 row x",
        "6.72 row 0",
        "6.72 step 1 row 2",
        "`a",
        "``",
        "every",
        "every 6.72",
        "#",
        "6.1,",
        "6.1 .. 6.2 .. 6.3",
        "two words",
    ] {
        assert!(resolve(address).is_err(), "{address:?}");
    }
}
