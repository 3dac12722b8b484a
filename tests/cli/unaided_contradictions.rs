//! Notes without a claims file: a display that contradicts a definition, and which of the two is wrong.

use serde_json::Value;

use crate::support::Desk;

/// A ball that slides and begins to roll at the time t₁: t₁ itself, its speed, and its way.
fn ball(time: &str, displays: &[&str]) -> String {
    let mut notes = format!("The ball rolls from the time\n\n$$ t_1 = {time} \\tag{{1}} $$\n\n");
    for (at, display) in displays.iter().enumerate() {
        notes.push_str(&format!("Then\n\n$$ {display} \\tag{{{}}} $$\n\n", at + 2));
    }
    notes
}

const TIME: &str = r"\frac{2 v}{7 a}";
const SPEED: &str = r"v_1 = v - a t_1 = \frac57 v";
const WAY: &str = r"s_1 = v t_1 - \frac12 a t_1^2 = \frac{12 v^2}{49 a}";

/// The verdict, the code and the place of the first repair of each display.
fn findings(name: &str, notes: &str) -> Vec<(String, String, Option<u64>)> {
    let desk = Desk::new(&format!("contradictions-{name}"));
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    let one = |found: &Value| (text(&found["verdict"]), text(&found["code"]), found["repairs"][0]["start"].as_u64());
    equations.iter().map(one).collect()
}

#[test]
fn a_definition_is_wrong_that_two_displays_contradict() {
    let right = findings("right", &ball(TIME, &[SPEED, WAY]));
    assert!(right.iter().all(|(verdict, ..)| ["definition", "certified"].contains(&verdict.as_str())), "{right:?}");
    for (name, wrong) in [("factor", r"\frac{v}{7 a}"), ("number", r"\frac{2 v}{5 a}"), ("power", r"\frac{2 v}{7 a^2}")]
    {
        let notes = ball(wrong, &[SPEED, WAY]);
        let found = findings(name, &notes);
        assert_eq!((found[0].0.as_str(), found[0].1.as_str()), ("refuted", "definition-contradicted"), "{name}");
        let place = usize::try_from(found[0].2.expect("a repair")).expect("a place");
        assert!(place < notes.find("tag{1}").expect("the first display"), "{name}");
        assert!(found[1..].iter().all(|(verdict, ..)| verdict == "undecided"), "{name}: {found:?}");
    }
}

#[test]
fn a_display_is_wrong_where_another_one_holds_with_the_definition() {
    let speed = findings("speed", &ball(TIME, &[r"v_1 = v - a t_1 = \frac37 v", WAY]));
    assert_eq!(speed[1].0, "refuted");
    assert_eq!((speed[0].0.as_str(), speed[2].0.as_str()), ("definition", "certified"));
    let way = findings("way", &ball(TIME, &[SPEED, r"s_1 = v t_1 - \frac12 a t_1 = \frac{12 v^2}{49 a}"]));
    assert_eq!((way[1].0.as_str(), way[2].0.as_str()), ("certified", "refuted"));
}

#[test]
fn neither_is_called_wrong_where_nothing_says_which() {
    let notes = ball(r"\frac{v}{7 a}", &[SPEED]);
    let found = findings("open", &notes);
    assert_eq!((found[0].0.as_str(), found[1].0.as_str()), ("undecided", "undecided"));
    assert_eq!(found[1].1, "contradiction");
    let desk = Desk::new("contradictions-shown");
    desk.write("notes.md", &notes);
    let run = desk.onshell(&["check", "notes.md"]);
    assert_eq!(run.code, 1);
    assert!(run.out.contains("this contradicts (1), and one of the two is wrong"), "{}", run.out);
    assert!(run.out.contains("with this edit of (1)"), "{}", run.out);
    assert_eq!(findings("one", &ball(TIME, &[SPEED]))[1].0, "certified");
}
