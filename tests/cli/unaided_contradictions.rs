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
    assert!(run.out.contains("With this edit of (1)"), "{}", run.out);
    assert_eq!(findings("one", &ball(TIME, &[SPEED]))[1].0, "certified");
}

/// A Carnot cycle with the relation between its volumes, and its work and efficiency.
fn cycle(ratio: &str, displays: &[&str]) -> String {
    let mut notes = String::from(
        "Heat is taken in and given off:\n\n$$ Q_h = nRT_h\\ln\\frac{V_2}{V_1}, \\quad Q_c = nRT_c\\ln\\frac{V_3}{V_4} $$\n\n",
    );
    notes.push_str(&format!("By division\n\n$$ {ratio} $$\n\n"));
    displays.iter().for_each(|display| notes.push_str(&format!("So\n\n$$ {display} $$\n\n")));
    notes
}

const RATIO: &str = r"\frac{V_2}{V_1} = \frac{V_3}{V_4}";
const WORK: &str = r"W = Q_h - Q_c = nR(T_h - T_c)\ln\frac{V_2}{V_1}";
const EFFICIENCY: &str = r"\eta_C = \frac{W}{Q_h} = 1 - \frac{T_c}{T_h}";

#[test]
fn a_premise_is_wrong_that_two_displays_contradict() {
    let verdicts = |name: &str, notes: &str| -> Vec<String> {
        findings(name, notes).into_iter().map(|(verdict, code, _)| format!("{verdict} {code}")).collect()
    };
    let right = verdicts("cycle", &cycle(RATIO, &[WORK, EFFICIENCY]));
    assert_eq!(right[1], "assumed assumed");
    assert!(right[2..].iter().all(|found| found.starts_with("certified")), "{right:?}");
    let wrong = r"\frac{V_2}{V_1} = \frac{V_4}{V_3}";
    let found = verdicts("cycle-two", &cycle(wrong, &[WORK, EFFICIENCY]));
    assert_eq!(found[1], "refuted definition-contradicted");
    assert!(found[2..].iter().all(|found| found.starts_with("undecided")), "{found:?}");
    // One display alone: nobody knows.
    let found = verdicts("cycle-one", &cycle(wrong, &[WORK]));
    assert_eq!(found[1..], ["undecided not-decided", "undecided contradiction"]);
    // Where something follows from the premise, the other display is wrong.
    let slip = WORK.replace("T_h - T_c", "T_h + T_c");
    let found =
        verdicts("cycle-work", &cycle(RATIO, &[EFFICIENCY.replace("W", "(Q_h - Q_c)").as_str(), slip.as_str()]));
    assert_eq!(found[1], "assumed assumed");
    assert!(found[2].starts_with("certified") && found[3].starts_with("refuted"), "{found:?}");
}

#[test]
fn a_special_value_contradicts_nothing() {
    let notes = r"The rod turns with

$$ \alpha = \frac{3g}{2\ell}\cos\theta $$

At the start its end accelerates with

$$ a = \ell\alpha = \frac32 g $$
";
    let found = findings("start", notes);
    assert!(found.iter().all(|(verdict, code, _)| verdict != "refuted" && code != "contradiction"), "{found:?}");
    // What has the angle, and another number, is wrong.
    let found = findings("end", &notes.replace(r"\frac32 g", r"\frac52 g\cos\theta"));
    assert!(found.iter().any(|(verdict, code, _)| verdict == "refuted" || code == "contradiction"), "{found:?}");
}

#[test]
fn an_inequality_is_wrong_in_its_direction_only() {
    let otto = |display: &str| {
        format!(
            "The efficiency is\n\n$$ \\eta = 1 - \\frac{{T_1}}{{T_2}} $$\n\nIt is less than Carnot's:\n\n$$ {display} $$\n"
        )
    };
    let found = findings("otto", &otto(r"\eta = 1 - \frac{T_1}{T_2} < 1 - \frac{T_1}{T_3}"));
    assert!(found.iter().all(|(verdict, ..)| verdict != "refuted"), "{found:?}");
    let square = |sign: &str| format!("For real numbers\n\n$$ a^2 + b^2 {sign} 2ab $$\n");
    assert_eq!(findings("square", &square(r"\ge"))[0].0, "verified");
    // An equality is wrong in any term.
    let found = findings("otto-slip", &otto(r"\eta = 1 + \frac{T_1}{T_2} = 1 - \frac{T_1}{T_2}"));
    assert!(found.iter().any(|(verdict, code, _)| verdict == "refuted" || code == "contradiction"), "{found:?}");
}

#[test]
fn a_solution_is_wrong_that_the_equations_before_it_contradict() {
    let notes = |solution: &str| {
        format!(
            "The velocity of a film obeys\n\n$$ \\eta \\frac{{d^2 u}}{{dy^2}} = - \\rho g \\tag{{1}} $$\n\nOne integration yields\n\n\
             $$ \\frac{{du}}{{dy}} = \\frac{{\\rho g}}{{\\eta}} (h - y) \\tag{{2}} $$\n\nand another one\n\n\
             $$ u(y) = \\frac{{\\rho g}}{{\\eta}} \\left( h y - {solution} \\right) \\tag{{3}} $$\n"
        )
    };
    let right = findings("solution-right", &notes(r"\frac12 y^2"));
    assert!(right.iter().all(|(verdict, ..)| verdict != "refuted"), "{right:?}");
    let wrong = findings("solution-wrong", &notes("y^2"));
    assert_eq!(wrong[2].0, "refuted", "{wrong:?}");
    assert!(wrong[..2].iter().all(|(verdict, ..)| verdict != "refuted"), "{wrong:?}");
    // One equation that is wrong leaves the solution as it is.
    let text = notes(r"\frac12 y^2").replace("(h - y)", "(h + y)");
    let one = findings("solution-beside", &text);
    assert_eq!((one[1].0.as_str(), one[2].0 == "refuted"), ("refuted", false), "{one:?}");
}

/// The deflection at the end gives no formula to that of the whole beam.
#[test]
fn a_relation_is_not_weighed_by_a_formula_that_comes_later() {
    let beam = r"$$ M(x) = F (\ell - x) $$

$$ E I w'' = M(x) $$

Integrate twice:

$$ E I w' = F\left(\ell x - \frac{x^2}{2}\right) $$

$$ E I w = F\left(\frac{\ell x^2}{2} - \frac{x^3}{6}\right) $$

The deflection at the end

$$ w(\ell) = \frac{F\ell^3}{3EI} $$
";
    let found = findings("unaided-later-formula", beam);
    assert!(found.iter().all(|(verdict, ..)| verdict != "refuted"), "{found:?}");
}

/// Of three relations between two quantities any one may be wrong; with two that agree the third one is.
#[test]
fn no_display_alone_is_blamed_where_three_contradict_each_other() {
    let notes = |first: &str| {
        format!(
            "$$ {first} $$\n\n$$ T = 2\\pi\\sqrt{{\\frac{{m}}{{k}}}} $$\n\n$$ \\omega = \\sqrt{{\\frac{{k}}{{m}}}} $$\n"
        )
    };
    let right = findings("three-right", &notes(r"T = \frac{2\pi}{\omega}"));
    assert!(right[2].0 == "certified" || right[2].0 == "verified", "{right:?}");
    let wrong = findings("three-wrong", &notes(r"T = \frac{\omega}{2\pi}"));
    assert!(wrong.iter().all(|(verdict, ..)| verdict != "refuted"), "{wrong:?}");
    assert_eq!((wrong[2].0.as_str(), wrong[2].1.as_str()), ("undecided", "contradiction"), "{wrong:?}");
}
