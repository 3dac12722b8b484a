//! Notes without a claims file: a name with one formula in one case and another in the next, regions of functions, and premises
//! with several solutions. Nothing true is called wrong there, and slips still are.

use serde_json::Value;

use crate::support::Desk;

/// The verdicts on the displays of a page, and the report as text.
fn verdicts(name: &str, notes: &str) -> (Vec<String>, String) {
    let desk = Desk::new(&format!("cases-{name}"));
    desk.write("notes.md", notes);
    verdicts_at(&desk)
}

fn verdicts_at(desk: &Desk) -> (Vec<String>, String) {
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    let verdict = |equation: &Value| equation["verdict"].as_str().unwrap_or_default().to_owned();
    (equations.iter().map(verdict).collect(), run.out)
}

const SPRINGS: &str = r"Spring 1 stores
$$ U(x) = \frac12 k x^2 $$
and pulls with
$$ F = -\frac{dU}{dx} = - k x $$
Spring 2 stores
$$ U(x) = \frac14 k x^4 $$
and pulls with
$$ F = -\frac{dU}{dx} = - k x^3 $$
";

#[test]
fn a_function_with_another_formula_has_it_in_what_comes_later() {
    let (found, report) = verdicts("springs", SPRINGS);
    assert_eq!(found, ["definition", "certified", "definition", "certified"], "{report}");
    let (found, report) = verdicts("springs-slip", &SPRINGS.replace("- k x^3", "- k x^2"));
    assert_eq!(found, ["definition", "certified", "definition", "refuted"], "{report}");
}

const MOTIONS: &str = r"In the first experiment

$$ x(t) = A \cos(\omega t) $$

$$ \dot{x}(t) = -A \omega \sin(\omega t) $$

In the second one

$$ x(t) = A \sin(\omega t) $$

$$ \dot{x}(t) = A \omega \cos(\omega t) $$
";

#[test]
fn another_motion_is_no_wrong_solution_of_what_follows_from_the_first() {
    let (found, report) = verdicts("motions", MOTIONS);
    assert_eq!(found, ["definition", "certified", "definition", "certified"], "{report}");
    // an equation of motion makes the second formula a solution of it, which may be wrong
    let law = format!("The equation of motion is\n\n$$ \\ddot x = -\\omega^2 x $$\n\n{MOTIONS}");
    let (found, report) = verdicts("motions-law", &law);
    assert!(!found.contains(&"refuted".to_owned()), "{report}");
    let (found, report) = verdicts("motions-slip", &law.replace(r"A \sin(\omega t) $$", r"A \sin(2\omega t) $$"));
    assert!(found.contains(&"refuted".to_owned()), "{report}");
}

#[test]
fn a_derivative_by_a_coordinate_varies_as_the_coordinate_does() {
    let notes = r"The derivatives of the Lagrangian are

$$ \frac{ \partial L }{ \partial \theta } = -m g l \sin\theta, \qquad \frac{ \partial L }{ \partial \dot{\theta} } = m l^2 \dot\theta $$

so the equation of motion is

$$ m l^2 \ddot{\theta} = -m g l \sin\theta $$

$$ \ddot{\theta} = -\frac{g}{l} \sin\theta $$
";
    let (found, report) = verdicts("derivatives", notes);
    assert_eq!(found, ["assumed", "assumed", "verified"], "{report}");
    let (found, report) = verdicts("derivatives-slip", &notes.replace(r"\frac{g}{l}", r"\frac{l}{g}"));
    assert_eq!(found, ["assumed", "assumed", "refuted"], "{report}");
}

#[test]
fn a_premise_with_two_solutions_refutes_nothing_that_holds_for_one() {
    let modes = r"The amplitudes obey

$$ -\omega^2 a + (-\omega^2 + \frac{g}{l}) b = 0 $$

and the determinant gives

$$ 2 ( \frac{g}{l} - \omega^2 )^2 - \omega^4 = 0 $$

Put in one of the frequencies:

$$ \frac{g}{l} ( (2 + \sqrt{2}) a + (1 + \sqrt{2}) b ) = 0 $$
";
    let (found, report) = verdicts("roots", modes);
    assert!(!found.contains(&"refuted".to_owned()), "{report}");
    let work = "$$ |W| = Q_h - Q_l $$\n\n$$ \\eta = \\frac{W}{Q_h} = \\frac{Q_h - |Q_l|}{Q_h} $$\n";
    let (found, report) = verdicts("modulus", work);
    assert!(!found.contains(&"refuted".to_owned()), "{report}");
    // with one solution the slip is seen, as one of the two displays is wrong
    let work = "$$ W = Q_h - Q_l $$\n\nHence\n\n$$ \\eta = \\frac{W}{Q_h} = \\frac{Q_h + Q_l}{Q_h} $$\n";
    let (found, report) = verdicts("modulus-slip", work);
    assert!(["refuted", "undecided"].contains(&found[1].as_str()), "{report}");
}

#[test]
fn the_region_of_a_function_stays_with_its_formula() {
    let notes = r"Outside of the well

$$ \varphi(x) = 0, \quad x < 0 $$

and inside of it

$$ \varphi(x) = A \sin kx, \quad 0 < x < a $$

$$ \varphi'(x) = A k \cos kx, \quad 0 < x < a $$
";
    let (found, report) = verdicts("region", notes);
    assert!(!found.contains(&"refuted".to_owned()), "{report}");
    assert!(report.contains("for x < 0"), "{report}");
    // an inequality of another letter is a statement of its own
    let (_, report) = verdicts("no-region", "$$ \\varphi(x) = A \\sin kx, \\quad a < b $$\n");
    assert!(!report.contains("for a < b"), "{report}");
}

const HOOP: &str = r"A small deviation is $\phi = \theta - \theta_0$, and $\theta_0$ is a place of rest.

A mass slides on a line through a hole, and

$$ L = m\dot{r}^2 + \frac12 m r^2 \dot\phi^2 - m g r $$

Hence

$$ \frac{\partial L}{\partial r} = m r \dot\phi^2 - m g $$

$$ 2 \ddot{r} - r \dot\phi^2 + g = 0 $$
";

#[test]
fn a_coordinate_is_not_put_at_rest_by_a_formula_in_a_sentence() {
    let (found, report) = verdicts("hoop", HOOP);
    assert_eq!(found, ["definition", "certified", "certified"], "{report}");
    let (found, report) = verdicts("hoop-slip", &HOOP.replace(r"= m r \dot", r"= 3 m r \dot"));
    assert_eq!(found, ["definition", "refuted", "certified"], "{report}");
    // what moves on the right side gives the name a rate
    let notes = HOOP.replace(r"\theta_0$, and", r"\omega t$, and");
    let (found, report) = verdicts("hoop-turning", &notes);
    assert!(!found.contains(&"refuted".to_owned()), "{report}");
}

#[test]
fn what_init_writes_gives_the_same_verdicts() {
    for (name, notes) in [("springs", SPRINGS), ("motions", MOTIONS), ("hoop", HOOP)] {
        let desk = Desk::new(&format!("cases-init-{name}"));
        desk.write("notes.md", notes);
        let (before, _) = verdicts_at(&desk);
        assert_eq!(desk.onshell(&["init", "notes.md"]).code, 0);
        let (after, report) = verdicts_at(&desk);
        assert_eq!(before, after, "{report}");
    }
}

#[test]
fn what_the_author_changes_in_the_written_file_holds_in_every_part() {
    let desk = Desk::new("cases-init-changed");
    desk.write("notes.md", SPRINGS);
    desk.onshell(&["init", "notes.md"]);
    let file = desk.read("notes.json");
    assert!(file.contains("\"constants\""), "{file}");
    // If k depends on x, both forces have another term.
    desk.write(
        "notes.json",
        file.replace("\"k\": \"any\"", "\"l\": \"any\"")
            .replace("\"guesses\"", "\"functions\": { \"k\": \"of x\" },\n  \"guesses\""),
    );
    let (found, report) = verdicts_at(&desk);
    for place in [1, 3] {
        assert!(!["certified", "verified"].contains(&found[place].as_str()), "{place}: {report}");
    }
}

#[test]
fn rows_that_are_read_as_one_name_are_not_wrong() {
    let notes = "Outside\n\n$$ \\varphi(x) = 0, \\quad |x| > a $$\n\nTherefore\n\n\
        $$ \\varphi(x) = \\left\\{ \\begin{array}{ll} A \\sin k(x + a), & x < 0 \\\\ 0, & x > a \\end{array} \\right. $$\n";
    let desk = Desk::new("unaided-rows");
    desk.write("notes.md", notes);
    let (found, report) = verdicts_at(&desk);
    assert!(!found.contains(&"refuted".to_owned()), "{report}");
}
