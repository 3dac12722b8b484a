//! `equal`, `eval` and `read`: formulas without a file.

use crate::support::Desk;

#[test]
fn equal_tells_three_answers_apart() {
    let desk = Desk::new("equal");
    let code = |left: &str, right: &str| desk.onshell(&["equal", left, right]).code;
    for (left, right, expected) in [
        (r"\sin^2 x + \cos^2 x", "1", 0),
        (r"\sin^2 x - \cos^2 x", "1", 1),
        (r"\frac12 m v^2", r"\frac{m v^2}{2}", 0),
        (r"\frac12 m v^2", r"\frac{m v}{2}", 1),
        (r"(a+b)^2", r"a^2 + 2ab + b^2", 0),
        (r"(a+b)^2", r"a^2 + ab + b^2", 1),
        (r"\sqrt{y^2}", "|y|", 0),
        (r"\sqrt{y^2}", "y", 1),
        (r"\dot\theta^2", r"\dot\theta\dot\theta", 0),
        (r"\dot\theta^2", r"\ddot\theta", 1),
        (r"M m", r"m^2", 1),
        (r"x", r"y", 1),
        (r"x +", r"x", 2),
        (r"\ln(x - 5000)", r"\ln(x-5000) + 1", 2),
    ] {
        let run = desk.onshell(&["equal", left, right]);
        assert_eq!(run.code, expected, "{left} and {right}: {}{}", run.out, run.err);
    }
    assert_eq!(code("-x", "-x - 0"), 0);
}

#[test]
fn a_large_offset_hides_no_difference() {
    let desk = Desk::new("offset");
    for offset in ["10^{12}", "10^{15}", "1000000000000"] {
        let run = desk.onshell(&["equal", &format!("y^2 + {offset}"), &format!("y^3 + {offset}")]);
        assert_ne!(run.code, 0, "{}", run.out);
    }
    assert_eq!(desk.onshell(&["equal", "y^2 + 10^3", "10^3 + y^2"]).code, 0);
}

#[test]
fn equal_says_what_it_took_for_granted() {
    let desk = Desk::new("granted");
    let run = desk.onshell(&["equal", r"\gamma I", r"I \gamma"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!(run.out.contains("γ is a real number") && run.out.contains("I is a real number"), "{}", run.out);
    let given = desk.onshell(&["equal", "x y", "y x", "--where", "x=0.1..3"]);
    assert!(!given.out.contains("x is a real number") && given.out.contains("y is a real number"), "{}", given.out);
}

#[test]
fn a_range_decides_what_is_equal() {
    let desk = Desk::new("ranges");
    let code = |range: &str| desk.onshell(&["equal", r"\sqrt{x^2}", "x", "--where", range]).code;
    assert_eq!((code("x=0.1..3"), code("x=-3..3"), code("x=-3..-1")), (0, 1, 1));
    for wrong in ["x=3..0.1", "x=1", "x=0..1e400", "x=a..b", "z=1..2", "x=nan..1", "=1..2"] {
        let run = desk.onshell(&["equal", r"\sqrt{x^2}", "x", "--where", wrong]);
        assert!(run.code == 2 && !run.err.is_empty(), "{wrong}: {}{}", run.out, run.err);
    }
}

#[test]
fn the_counterexample_of_equal_is_one() {
    let desk = Desk::new("counterexample");
    let run = desk.onshell(&["equal", r"x^2 + y", r"x^2 - y", "--format", "json"]);
    assert_eq!(run.code, 1);
    let answer = run.json();
    assert_eq!((&answer["equal"], &answer["verdict"]), (&false.into(), &"refuted".into()));
    let found = &answer["counterexample"];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let (x, y) = (number(&found["state"]["x"]), number(&found["state"]["y"]));
    assert!((number(&found["lhs"]) - (x * x + y)).abs() < 1e-12, "{found}");
    assert!((number(&found["rhs"]) - (x * x - y)).abs() < 1e-12, "{found}");
    let sound = desk.onshell(&["equal", "x + y", "y + x", "--format", "json"]).json();
    assert_eq!((&sound["equal"], &sound["counterexample"]), (&true.into(), &serde_json::Value::Null));
}

#[test]
fn eval_prints_the_shortest_decimal_and_json_the_double() {
    let desk = Desk::new("eval");
    let run = |formula: &str, set: &[&str], format: &str| {
        let mut arguments = vec!["eval", formula, "--format", format];
        set.iter().for_each(|pair| arguments.extend(["--set", pair]));
        let run = desk.onshell(&arguments);
        assert_eq!(run.code, 0, "{formula}: {}{}", run.out, run.err);
        run
    };
    let value = |formula: &str, set: &[&str]| run(formula, set, "json").json()["value"].as_f64().unwrap();
    let printed = |formula: &str, set: &[&str]| run(formula, set, "text").out.trim().to_owned();
    assert_eq!(printed(r"\lambda_1\dot\theta^2", &[r"\lambda_1=2", r"\dot\theta=0.83"]), "1.3778");
    assert_eq!(printed(r"\lambda_1\ddot\theta", &[r"\lambda_1=0.1", r"\ddot\theta=3"]), "0.3");
    assert_eq!(printed(r"\sin\pi", &[]), "0");
    assert_eq!(printed(r"10^{-12} x", &["x=2.5"]), "2.5e-12");
    assert_eq!(printed(r"\coth x", &["x=800"]), "1");
    // What the arithmetic knows is not cut off.
    assert_eq!(printed("x", &["x=0.1234567890123"]), "0.1234567890123");
    assert_eq!(value(r"\dot\theta", &[r"\dot\theta=0.83"]), 0.83);
    assert_eq!(value(r"\dot\theta^2", &[r"\dot\theta=0.83"]), 0.83 * 0.83);
    assert_eq!(value(r"\lambda_1\ddot\theta", &[r"\lambda_1=0.1", r"\ddot\theta=3"]), 0.1 * 3.0);
    assert_eq!(value(r"\frac13", &[]), 1.0 / 3.0);
    assert_eq!(value("x", &["x=5e-324"]), 5e-324);
    assert_eq!(value("-x", &["x=-1.7976931348623157e308"]), f64::MAX);
    assert_eq!(value(r"\theta", &[r"\theta=0.7"]), 0.7);
}

#[test]
fn eval_refuses_rather_than_guess() {
    let desk = Desk::new("refused");
    for (formula, set, word) in [
        (r"\theta + x", vec![r"\theta=0.7"], "x"),
        (r"\theta", vec![r"\theta=0.7", "x=1"], "x"),
        (r"\theta", vec![r"\theta=0.7", r"\theta=0.8"], "twice"),
        (r"\dot\theta", vec![r"\theta=0.7"], r"\dot{\theta}"),
        (r"\frac{1}{x}", vec!["x=0"], "no real value"),
        (r"\sqrt{x}", vec!["x=-1"], "no real value"),
        (r"10^{400}", vec![], "too large to compute with"),
        (r"x", vec!["x=1e400"], "too large"),
        (r"x", vec!["x"], "--set x does not have the form NAME=VALUE"),
        (r"x", vec!["x=seven"], "“seven” is not a number in --set x=seven"),
        (r"x", vec!["x=NaN"], "“NaN” is not a number in --set x=NaN"),
        (r"x", vec!["+=1"], "“+” is not a name in --set +=1"),
        (r"a/bc", vec!["a=1", "b=1", "c=1"], "a/bc may be a/(bc) or (a/b)c"),
        (r"\foo x", vec!["x=1"], r"\foo"),
        (r"", vec![], "missing"),
    ] {
        let mut arguments = vec!["eval", formula];
        set.iter().for_each(|pair| arguments.extend(["--set", pair]));
        let run = desk.onshell(&arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{formula} {set:?}");
        assert!(run.err.contains(word), "no “{word}” for {formula} {set:?}: {}", run.err);
    }
}

#[test]
fn read_echoes_how_a_formula_is_understood() {
    let desk = Desk::new("read");
    let reading = |formula: &str| {
        let run = desk.onshell(&["read", formula]);
        assert_eq!(run.code, 0, "{formula}: {}", run.err);
        run.out
    };
    assert!(reading("MgR").contains("M·g·R"), "{}", reading("MgR"));
    assert!(reading(r"\lambda_1(a+b)").contains("λ_1·(a + b)"), "{}", reading(r"\lambda_1(a+b)"));
    assert!(reading("E = mc^2").contains("assumed to be real numbers: E, m, c"), "{}", reading("E = mc^2"));
    assert_ne!(reading(r"\cos\theta\,p"), reading(r"\cos(\theta p)"));
    assert_ne!(reading("Mm"), reading("mm"));
}

#[test]
fn read_points_at_what_it_does_not_understand() {
    let desk = Desk::new("not-read");
    for (formula, place, word) in [
        (r"a + \foo b", "1:5", r"\foo"),
        ("a + + b", "1:3", "two signs"),
        (r"a = b/cd", "1:7", "b/cd may be b/(cd) or (b/c)d"),
    ] {
        let run = desk.onshell(&["read", formula]);
        assert_eq!(run.code, 2, "{formula}: {}", run.out);
        assert!(run.err.contains(place) && run.err.contains(word), "{formula}: {}", run.err);
    }
}

#[test]
fn a_rate_is_no_angle_at_which_an_argument_ends() {
    let desk = Desk::new("rates");
    for latex in [r"\cos\dot\phi t", r"a\cos\dot\phi t", r"\cos\dot\phi x"] {
        let run = desk.onshell(&["read", latex]);
        assert!(
            run.code == 2 && run.err.contains("put the argument in parentheses, "),
            "{latex}: {}{}",
            run.out,
            run.err
        );
        assert!(!run.err.contains("thin space"), "{latex}: {}", run.err);
    }
    // The twins: enclosed, with nothing after it that could belong to it, or a root, which is a frequency before the time.
    for latex in [
        r"\cos(\dot\phi t)",
        r"\cos(\dot\phi) t",
        r"\sin\dot\phi",
        r"\sin\dot\phi\cos\theta",
        r"\sin(\sqrt{k} t)",
        r"\sin\sqrt{k}\,t",
    ] {
        let run = desk.onshell(&["read", latex]);
        assert_eq!(run.code, 0, "{latex}: {}{}", run.out, run.err);
    }
}
