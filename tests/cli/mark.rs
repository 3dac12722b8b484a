//! `onshell mark`: hand-ins in `tests/mark`, each with the marks that a fair teacher gives in comments beside its lines.

use std::path::Path;

use crate::support::{Desk, Run};

/// The words in the comments of a hand-in.
fn expected(text: &str) -> Vec<String> {
    let words = |comment: &str| comment.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let tex = text.lines().filter_map(|line| Some(line.split_once('%')?.1));
    let markdown = text.split("<!--").skip(1).filter_map(|rest| Some(rest.split_once("-->")?.0));
    let is_tex = !text.contains("<!--");
    if is_tex { tex.flat_map(words).collect() } else { markdown.flat_map(words).collect() }
}

/// The marks of a student in a table, the missing results, and the points.
fn found(run: &Run, student: &str) -> Vec<String> {
    let report = run.json();
    let rows = report["rows"].as_array().unwrap().iter().filter(|row| row["student"] == student);
    let mut found: Vec<String> = rows
        .map(|row| match row["mark"].as_str().unwrap() {
            "missing" => format!("missing:{}", row["result"].as_str().unwrap()),
            "not read" => "unread".to_owned(),
            mark => mark.to_owned(),
        })
        .collect();
    let student = report["students"].as_array().unwrap().iter().find(|one| one["student"] == student).unwrap();
    found.push(format!("points:{}", student["credit"].as_f64().unwrap()));
    found
}

fn class(name: &str) {
    let desk = Desk::new(&format!("mark-{name}"));
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mark");
    for file in [format!("{name}.md"), format!("{name}.json")] {
        desk.write(&file, std::fs::read_to_string(from.join(&file)).unwrap());
    }
    let (mut texts, mut files) = (Vec::new(), Vec::new());
    for entry in std::fs::read_dir(from.join(name)).unwrap() {
        let path = entry.unwrap().path();
        let file = path.file_name().unwrap().to_string_lossy().into_owned();
        let text = std::fs::read_to_string(&path).unwrap();
        desk.write(&format!("{name}/{file}"), &text);
        files.push(file);
        texts.push((path.file_stem().unwrap().to_string_lossy().into_owned(), text));
    }
    assert!(texts.len() >= 12, "{name}: {}", texts.len());
    texts.sort();
    for (student, text) in texts {
        let file = files.iter().find(|file| file.starts_with(&student)).unwrap();
        let claims = format!("{name}.json");
        let run = desk.onshell(&["mark", &format!("{name}/{file}"), "--claims", &claims, "--format", "json"]);
        let mut wanted = expected(&text);
        if text.trim().is_empty() {
            let report = run.json();
            let one = report["students"].as_array().unwrap().iter().find(|one| one["student"] == *student).unwrap();
            let results = one["results"].as_array().unwrap().iter();
            let missing = results.map(|result| format!("missing:{}", result["id"].as_str().unwrap()));
            wanted = std::iter::once("unread".to_owned()).chain(missing).collect();
            wanted.push("points:0".to_owned());
        }
        assert_eq!(found(&run, &student), wanted, "{name}/{student}\n{text}");
        let is_sound = !wanted.iter().any(|word| word == "wrong" || word.starts_with("missing"));
        let is_open = wanted.iter().any(|word| word == "undecided" || word == "unread");
        let code = if is_open && is_sound { 2 } else { i32::from(!is_sound) };
        assert_eq!(run.code, code, "{name}/{student}: {}", run.err);
    }
}

#[test]
fn hand_ins_about_a_pendulum_are_marked_as_a_fair_teacher_would() {
    class("pendulum");
}

#[test]
fn hand_ins_about_a_throw_are_marked_as_a_fair_teacher_would() {
    class("throw");
}

#[test]
fn hand_ins_with_quantities_of_their_own_are_marked_as_a_fair_teacher_would() {
    class("incline");
}

#[test]
fn hand_ins_about_two_masses_with_two_laws_are_marked_as_a_fair_teacher_would() {
    class("atwood");
}

#[test]
fn hand_ins_about_a_circuit_in_several_languages_are_marked_as_a_fair_teacher_would() {
    class("circuit");
}

#[test]
fn hand_ins_about_a_hoop_with_conditions_are_marked_as_a_fair_teacher_would() {
    class("hoop");
}

#[test]
fn hand_ins_about_a_planet_are_marked_as_a_fair_teacher_would() {
    class("planet");
}

#[test]
fn hand_ins_about_a_ladder_with_numbers_are_marked_as_a_fair_teacher_would() {
    class("ladder");
}

/// A hint below the third level contains nothing of the corrected line, in any form of the output.
#[test]
fn no_form_of_the_output_tells_more_than_its_level() {
    // The word `\kappa` stands only in the correction: the problem has it, and the hand-in has \lambda in its place.
    let desk = Desk::new("mark-secrets");
    desk.write(
        "p.md",
        "$$ F = \\kappa x + \\lambda y \\tag{1} $$\n\n$$ G = 2 \\kappa x + 2 \\lambda y = 2 F \\tag{2} $$\n",
    );
    let claims = r#"{ "notes": "p.md", "constants": { "\\kappa, \\lambda, x, y": "> 0" }, "rubric": { "results": { "2": 2 } } }"#;
    desk.write("p.json", claims);
    desk.write("class/a.md", "$$ F = \\lambda x + \\lambda y $$\n\n$$ G = 2 \\lambda x + 2 \\lambda y $$\n");
    for level in ["0", "1", "2", "3"] {
        let mut said = String::new();
        for form in ["text", "csv", "json"] {
            let run = ["mark", "class", "--claims", "p.json", "--format", form, "--hints", level, "--out", level];
            let run = desk.onshell(&run);
            assert_eq!(run.code, 1, "{}{}", run.out, run.err);
            said += &run.out;
        }
        said += &desk.read(&format!("{level}/a.html"));
        said += &desk.read(&format!("{level}/index.html"));
        // The twin: the third level tells it.
        assert_eq!(said.contains("kappa") || said.contains('κ'), level == "3", "{level}: {said}");
    }
}

#[test]
fn broken_files_and_odd_names_have_their_rows_and_stop_nobody() {
    let desk = small("mark-broken", SLIP);
    desk.write("class/=cmd|x, \"é\".md", SLIP);
    desk.write("other/a.md", "$$ v = v_0 - g t $$\n");
    desk.write("class/bytes.md", [0xff, 0xfe, 0, b'$', b'$', 0x80]);
    desk.write("class/huge.md", format!("$$ t_1 = {}x $$", "x + ".repeat(3000)));
    let run = desk.onshell(&["mark", "class", "other", "--claims", "p.json", "--format", "csv", "--out", "pages"]);
    assert_eq!(run.code, 1, "{}", run.err);
    for file in ["class/a.md", "other/a.md", "class/bytes.md", "class/huge.md", "\" =cmd|x, \"\"é\"\"\""] {
        assert!(run.out.lines().any(|row| row.contains(file)), "{file}: {}", run.out);
    }
    assert!(!run.out.lines().any(|row| row.starts_with('=') || row.contains(",=")), "{}", run.out);
    assert!(run.out.lines().all(|row| row.len() < 10_000), "a cell is too long");
    // Two students with one name have a page each.
    assert_ne!(desk.read("pages/a.html"), desk.read("pages/a-2.html"));
}

const SMALL: (&str, &str) = (
    r"$$ v = v_0 - g t $$

$$ t_1 = \frac{v_0}{g} $$

$$ H = v_0 t_1 - \frac12 g t_1^2 = \frac{v_0^2}{2g} \tag{1} $$
",
    r#"{ "notes": "p.md", "constants": { "v_0, g": "> 0" },
         "rubric": { "results": { "1": 2 }, "half for": ["factor"], "letters": { "v_0": "w" } } }"#,
);

fn small(name: &str, hand_in: &str) -> Desk {
    let desk = Desk::new(name);
    desk.write("p.md", SMALL.0);
    desk.write("p.json", SMALL.1);
    desk.write("class/a.md", hand_in);
    desk
}

const SLIP: &str = r"$$ t_1 = \frac{v_0}{g} $$

$$ H = \frac12 g t_1^2 $$

$$ H = \frac{v_0^2}{g} $$
";

#[test]
fn hints_say_no_more_than_their_level() {
    let desk = small("mark-hints", SLIP);
    let said = |level: &str| {
        let run = desk.onshell(&["mark", "class/a.md", "--claims", "p.json", "--hints", level, "--format", "csv"]);
        assert_eq!(run.code, 1, "{}", run.err);
        run.out
    };
    let without = desk.onshell(&["mark", "class/a.md", "--claims", "p.json", "--format", "csv"]).out;
    assert_eq!(without, said("1"));
    assert!(
        said("0").contains("something in this hand-in is wrong") && !said("0").contains("look at"),
        "{}",
        said("0")
    );
    let text = |level: &str| desk.onshell(&["mark", "class/a.md", "--claims", "p.json", "--hints", level]).out;
    // The lowest level does not say where.
    let lowest = text("0");
    assert!(lowest.contains("something in this hand-in is wrong") && lowest.contains("1 of 2 points"), "{lowest}");
    assert!(!lowest.contains('✗') && !lowest.contains("line 5"), "{lowest}");
    assert!(text("1").contains("✗ line 5"), "{}", text("1"));
    assert!(said("1").contains("look at this line") && !said("1").contains("factor"), "{}", said("1"));
    assert!(said("2").contains("a factor or a number is wrong") && !said("2").contains("; "), "{}", said("2"));
    assert!(said("3").contains("; "), "{}", said("3"));
    assert_ne!(said("2"), said("3"));
}

#[test]
fn a_table_has_its_columns_in_every_form() {
    let desk = small("mark-table", SLIP);
    let csv = desk.onshell(&["mark", "class", "--claims", "p.json", "--format", "csv"]).out;
    let head = "student,file,line,id,statement,mark,credit,verdict,follows_from,hint,result,points,because";
    assert_eq!(csv.lines().next(), Some(head));
    assert_eq!(csv.lines().count(), 4, "{csv}");
    assert!(csv.lines().nth(3).unwrap().contains(",wrong,1,refuted,"), "{csv}");
    let json = desk.onshell(&["mark", "class", "--claims", "p.json", "--format", "json"]).json();
    let rows = json["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 3);
    let keys: Vec<&String> = rows[0].as_object().unwrap().keys().collect();
    assert_eq!(keys.len(), head.split(',').count());
    assert_eq!(json["students"][0]["credit"], 1.0);
}

#[test]
fn a_declared_letter_stands_for_the_problems_own() {
    let other = SLIP.replace("v_0", "w").replace(r"\frac{w^2}{g}", r"\frac{w^2}{2g}");
    let desk = small("mark-letters", &other);
    let run = desk.onshell(&["mark", "class", "--claims", "p.json", "--format", "json"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert_eq!(run.json()["students"][0]["letters"]["w"], "v_0");
}

#[test]
fn pages_are_written_and_hide_what_a_hint_may_not_say() {
    let desk = small("mark-pages", SLIP);
    desk.onshell(&["mark", "class", "--claims", "p.json", "--out", "pages", "--hints", "0"]);
    let index = desk.read("pages/index.html");
    assert!(index.contains("a.html") && index.contains("1/2"), "{index}");
    let page = desk.read("pages/a.html");
    assert!(page.contains("<math") && page.contains("Something in this hand-in is wrong"), "{page}");
    assert!(!page.contains("✗"), "{page}");
    desk.onshell(&["mark", "class", "--claims", "p.json", "--out", "pages", "--hints", "3"]);
    let page = desk.read("pages/a.html");
    assert!(page.contains("✗ wrong") && page.contains("The corrected equation"), "{page}");
}

#[test]
fn a_problem_that_is_wrong_itself_marks_nobody() {
    let desk = small("mark-wrong-problem", SLIP);
    desk.change("p.md", (r"\frac{v_0^2}{2g}", r"\frac{v_0^2}{g}"));
    let run = desk.onshell(&["mark", "class", "--claims", "p.json"]);
    assert_eq!(run.code, 2, "{}", run.out);
    assert!(run.err.contains("is one of the wanted results, but in the model solution it is refuted"), "{}", run.err);
    let none = desk.onshell(&["mark", "nobody.md", "--claims", "p.json"]);
    assert_eq!(none.code, 2);
}

/// The marks of the lines of a hand-in about a problem, and the missing results.
fn marks(name: &str, problem: (&str, &str), hand_in: &str) -> Vec<String> {
    let desk = Desk::new(name);
    desk.write("p.md", problem.0);
    desk.write("p.json", problem.1);
    desk.write("a.md", hand_in);
    let run = desk.onshell(&["mark", "a.md", "--claims", "p.json", "--format", "json"]);
    let mut found = found(&run, "a");
    found.retain(|word| !word.starts_with("points"));
    found
}

#[test]
fn many_letters_are_found_at_once_by_the_form_of_a_line() {
    let problem = (
        "$$ A = \\frac{m_1 k - m_2 g}{m_1 + m_2} \\tag{1} $$\n\n$$ S = \\frac{a b c}{m_1} A + d \\tag{2} $$\n",
        r#"{ "notes": "p.md", "constants": { "m_1, m_2, k, g, a, b, c, d": "> 0" } }"#,
    );
    let right = "$$ P = \\frac{u w - x z}{x + u} $$\n\n$$ Q = \\delta + \\frac{P}{u} \\alpha \\beta \\gamma $$\n";
    assert_eq!(marks("mark-many-letters", problem, right), ["right", "right"]);
    // The twin: a sign is wrong, and no letters make it right.
    let wrong = right.replace("u w -", "u w +");
    assert_ne!(marks("mark-many-letters-wrong", problem, &wrong)[0], "right");
}

#[test]
fn the_square_of_what_is_positive_says_what_it_is() {
    let fall = ("$$ v = \\sqrt{2 g h} \\tag{1} $$\n", r#"{ "notes": "p.md", "constants": { "g, h": "> 0" } }"#);
    assert_eq!(marks("mark-square", fall, "$$ v^2 = 2 g h $$\n"), ["right"]);
    // The twin: of what has either sign the square says less.
    let change = ("$$ x = a - b \\tag{1} $$\n", r#"{ "notes": "p.md", "constants": { "a, b": "> 0" } }"#);
    assert_eq!(marks("mark-square-sign", change, "$$ x^2 = (a - b)^2 $$\n"), ["right", "missing:1"]);
}

#[test]
fn a_momentum_that_the_laws_keep_is_given_and_another_is_wrong() {
    let problem = (
        "$$ (M + m) \\ddot X = m \\ddot s \\cos\\alpha \\tag{1} $$\n\n$$ \\ddot s = g \\sin\\alpha + \\ddot X \\cos\\alpha \\tag{2} $$\n\n\
         $$ \\ddot X = \\frac{m g \\sin\\alpha \\cos\\alpha}{M + m \\sin^2\\alpha} \\tag{3} $$\n",
        r#"{ "notes": "p.md", "constants": { "M, m, g": "> 0", "\\alpha": "(0, \\pi/2)" },
             "varies with time": { "X, s": "any" }, "laws": { "momentum": "1", "Newton": "2" },
             "rubric": { "results": { "3": 1 } } }"#,
    );
    let result = "\n\n$$ \\ddot X = m g \\sin\\alpha \\cos\\alpha/(M + m \\sin^2\\alpha) $$\n";
    for (at, (line, mark)) in [
        ("M \\dot X = m (\\dot s \\cos\\alpha - \\dot X)", "given"),
        ("M X = m (s \\cos\\alpha - X)", "given"),
        ("M \\dot X = m (\\dot s \\cos\\alpha + \\dot X)", "wrong"),
        ("M X = m (s \\cos\\alpha + X)", "wrong"),
    ]
    .into_iter()
    .enumerate()
    {
        let found = marks(&format!("mark-momentum-{at}"), problem, &format!("$$ {line} $$ {result}"));
        assert_eq!(found, [mark, "right"], "{line}");
    }
}

#[test]
fn a_step_by_algebra_from_what_contradicts_the_problem_is_carried() {
    let problem = (
        "$$ u_1 = \\frac{m - M}{m + M} v $$\n\n$$ u_2 = \\frac{2 m}{m + M} v \\tag{1} $$\n",
        r#"{ "notes": "p.md", "constants": { "m, M, v": "> 0" } }"#,
    );
    let last = |name: &str, line: &str| {
        let before = "$$ m v = m u_1 + M u_2 $$\n\n$$ u_2 = v - u_1 $$\n\n$$ u_1 = v $$\n\n";
        marks(name, problem, &format!("{before}$$ {line} $$\n")).pop().unwrap()
    };
    assert_eq!(last("mark-algebra", "u_2 = 0"), "carried");
    // The twin: another value follows from nothing before it.
    assert_eq!(last("mark-algebra-wrong", "u_2 = \\frac{v}{7}"), "wrong");
}

#[test]
fn a_false_line_whose_formula_would_define_a_name_by_itself_ends_no_check() {
    let problem = (
        "$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\Omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{1} $$\n\n\
         $$ \\ddot\\theta = \\left( \\Omega^2 \\cos\\theta - \\frac gR \\right) \\sin\\theta \\tag{2} $$\n\n\
         $$ \\cos\\theta_0 = \\frac{g}{R \\Omega^2} \\tag{3} $$\n\n\
         $$ \\omega^2 = \\frac gR - \\Omega^2 \\tag{4} $$\n",
        r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" },
            "constants": { "m, R, g, \\Omega": "> 0", "\\theta_0": "(0, \\pi/2)" },
            "means": { "L": "Lagrangian", "\\omega": "normal frequency" },
            "equations": { "3": { "equilibrium": true, "at": { "\\theta": "\\theta_0" } } } }"#,
    );
    // The problem's ω is a frequency of its own, and here it is the rate of the hoop.
    let before = "$$ L = \\frac12 ma^2\\dot\\varphi^2 + \\frac12 ma^2\\omega^2\\sin^2\\varphi + mga\\cos\\varphi $$\n\n\
                  $$ \\ddot\\varphi = \\omega^2\\sin\\varphi\\cos\\varphi - \\frac{g}{a}\\sin\\varphi $$\n\n\
                  $$ \\cos\\varphi_0 = \\frac{g}{a\\omega^2} $$\n\n\
                  $$ \\ddot\\varphi + \\left(\\frac{g}{a} - \\omega^2\\right)\\varphi = 0 $$\n\n";
    let all = |name: &str, last: &str| marks(name, problem, &format!("{before}$$ {last} $$\n"));
    assert!(all("mark-circular", "\\nu^2 = \\frac{g}{a} - \\omega^2").len() >= 5);
    // The twin: the sum of the two is no frequency.
    let wrong = all("mark-circular-wrong", "\\nu^2 = \\frac{g}{a} + \\omega^2");
    assert!(wrong.len() >= 5 && wrong[4] != "right", "{wrong:?}");
}

#[test]
fn the_place_of_an_equilibrium_is_right_in_any_form() {
    let problem = (
        "$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\Omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{1} $$\n\n\
         $$ \\cos\\theta_0 = \\frac{g}{R \\Omega^2} \\tag{2} $$\n",
        r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" },
            "constants": { "m, R, g, \\Omega": "> 0", "\\theta_0": "(0, \\pi/2)" }, "means": { "L": "Lagrangian" },
            "equations": { "2": { "equilibrium": true, "at": { "\\theta": "\\theta_0" } } },
            "rubric": { "results": { "2": 2 } } }"#,
    );
    let of = |name: &str, line: &str| marks(name, problem, &format!("$$ {line} $$\n"));
    assert_eq!(of("mark-equilibrium", "\\cos\\theta_0 = \\frac{g}{R\\Omega^2}"), ["right"]);
    assert_eq!(of("mark-equilibrium-solved", "\\Omega^2 R\\cos\\theta_0 = g"), ["right"]);
    // The twin: another place is none of the problem's.
    assert_eq!(of("mark-equilibrium-wrong", "\\cos\\theta_0 = \\frac{2 g}{R\\Omega^2}")[0], "wrong");
}
