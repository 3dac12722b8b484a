//! One slip in what several equations stand on, and the edit of it that mends them all.

use onshell::Code;
use onshell::check::{Document, Equation, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, outcome};

/// A rocket, by Meshchersky's law.
fn rocket() -> Json {
    json!({
        "varies with time": { "m": "> 0", "v, F": "any" },
        "constants": { "u": "> 0" },
        "define": { "P": "m v" },
        "laws": { "the rocket": "1" },
    })
}

const LAW: &str = r"m \dot v = -\dot m u + F";
const MOMENTUM: &str = r"\frac{dP}{dt} = \dot m (v - u) + F";
const TSIOLKOVSKY: &str = r"\frac{d}{dt} (v + u \ln m) = \frac{F}{m}";

fn checked(claims: &Json, displays: &[&str]) -> Document {
    document(claims, &numbered(displays), &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"))
}

/// What the first suggestion for each wrong equation changes, and what it mends.
fn shared(document: &Document) -> Vec<Option<(&str, Vec<&str>)>> {
    let wrong = document.equations.iter().filter(|equation| !equation.ok);
    wrong
        .map(|equation| {
            let shared = equation.repairs.first()?.shared.as_ref()?;
            Some((shared.of.as_str(), shared.mends.iter().map(String::as_str).collect()))
        })
        .collect()
}

/// The notes with the first suggestion for the first equation that has one made.
fn mended(document: &Document) -> String {
    let repair = document.equations.iter().find_map(|equation: &Equation| equation.repairs.first());
    let repair = repair.expect("there is a suggestion");
    let mut text = document.source.text.clone();
    text.replace_range(repair.span.range(), &repair.replacement);
    text
}

#[test]
fn a_slip_in_a_law_is_mended_in_the_law() {
    for slip in [r"m \dot v = \dot m u + F", r"m \dot v = -\dot m u - F", r"m v = -\dot m u + F"] {
        let found = checked(&rocket(), &[slip, MOMENTUM, TSIOLKOVSKY]);
        assert_eq!(shared(&found), vec![Some(("1", vec!["2", "3"])); 2], "{slip}");
        let again = document(&rocket(), &mended(&found), &Registry::standard(), None);
        assert!(again.is_ok_and(|again| again.equations.iter().all(|equation| equation.ok)), "{slip}");
    }
    // The twin: of two slips that have nothing in common each is mended where it is.
    let momentum = r"\frac{dP}{dt} = \dot m (v + u) + F";
    let tsiolkovsky = r"\frac{d}{dt} (v + u \ln m) = \frac{m}{F}";
    let found = checked(&rocket(), &[LAW, momentum, tsiolkovsky]);
    assert_eq!(shared(&found), [None, None]);
    assert_eq!(mended(&found), numbered(&[LAW, MOMENTUM, tsiolkovsky]));
}

#[test]
fn what_holds_speaks_for_the_law() {
    // Two equations with the same wrong sign could be mended by one in the law, and a third would fail then.
    let momentum = r"\frac{dP}{dt} = \dot m (v + u) + F";
    let tsiolkovsky = r"\frac{d}{dt} (v - u \ln m) = \frac{F}{m}";
    let energy = r"m v \dot v = F v - \dot m u v";
    let found = checked(&rocket(), &[LAW, momentum, tsiolkovsky]);
    assert_eq!(shared(&found), vec![Some(("1", vec!["2", "3"])); 2]);
    let found = checked(&rocket(), &[LAW, momentum, tsiolkovsky, energy]);
    assert_eq!(shared(&found), [None, None]);
}

#[test]
fn a_slip_in_what_a_name_means_is_mended_there() {
    let claims = json!({ "constants": { "a, b": "> 0" } });
    let uses = [r"s + 2ab = (a + b)^2", r"s - 2ab = (a - b)^2"];
    let found = checked(&claims, &["s = a^2 - b^2", uses[0], uses[1]]);
    let wrong: Vec<_> = shared(&found).into_iter().flatten().collect();
    assert_eq!(wrong, vec![("1", vec!["2", "3"]); 3]);
    assert_eq!(found.equations[0].finding.verdict, Verdict::Refuted);
    assert_eq!(mended(&found), numbered(&["s = a^2 + b^2", uses[0], uses[1]]));
}

#[test]
fn a_display_that_is_wrong_itself_is_mended_with_what_stands_on_it() {
    let claims = json!({ "constants": { "a, b": "> 0" } });
    let (sum, square) = ("s = a^2 + b^2 = (a + b)^2 - 2ab", "(a - b)^2 = s - 2ab");
    let found = checked(&claims, &[&sum.replace("a^2 + b^2", "a^2 - b^2"), square]);
    assert_eq!(shared(&found), vec![Some(("1", vec!["1", "2"])); 2]);
    assert_eq!(mended(&found), numbered(&[sum, square]));
    // The twin: a slip behind the definition is nobody else's.
    let found = checked(&claims, &["s = a^2 + b^2 = (a + b)^2 - 3ab", square]);
    assert_eq!(shared(&found), [None]);
    assert_eq!(mended(&found), numbered(&[sum, square]));
}

#[test]
fn a_definition_that_cannot_be_read_is_mended_for_what_stands_on_it() {
    let claims = json!({ "constants": { "a, b": "> 0" }, "axes": { r"\hat x, \hat y, \hat z": "fixed" } });
    let uses = [r"|\vec r|^2 = a^2 + b^2", r"\vec r \cdot (\hat x + \hat y) = a - b"];
    let found = checked(&claims, &[r"\vec r = a \hat x b \hat y", uses[0], uses[1]]);
    assert_eq!(shared(&found), vec![Some(("1", vec!["1", "2", "3"])); 3]);
    assert_eq!(mended(&found), numbered(&[r"\vec r = a \hat x - b \hat y", uses[0], uses[1]]));
}

#[test]
fn that_a_momentum_does_not_change_is_not_made_that_there_is_none() {
    let claims = json!({ "varies with time": { "r": "> 0", r"\phi": "angle" }, "constants": { "m": "> 0" }, "laws": { "rotation": "1" } });
    let rates = [r"\dot p = 0", r"\frac{d}{dt} (r^2 \dot\phi) = 0", r"2 \dot r \dot\phi + r \ddot\phi = 0"];
    let displays = |momentum: &'static str| [rates[0], momentum, rates[1], rates[2]];
    let found = checked(&claims, &displays(r"p = m r \dot\phi"));
    assert_eq!(shared(&found).into_iter().flatten().collect::<Vec<_>>(), vec![("2", vec!["3", "4"]); 2]);
    let offered =
        found.equations.iter().flat_map(|equation| &equation.repairs).filter_map(|repair| repair.shared.as_ref());
    assert!(offered.into_iter().all(|shared| shared.of == "2"));
}

/// An oscillator whose energy is constant.
fn oscillator() -> Json {
    json!({
        "varies with time": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "laws": { "Hooke's law": "1" },
        "equations": { "2": { "conserved": true } },
    })
}

const HOOKE: &str = r"m \ddot x = -k x";
const ENERGY: &str = r"E = \frac12 m \dot x^2 + \frac12 k x^2";
const PERIOD: &str = r"\ddot x = -\frac{k}{m} x";

#[test]
fn what_one_equation_alone_notices_is_mended_where_it_stands() {
    let found = checked(&oscillator(), &[r"m \ddot x = -k x^2", ENERGY]);
    assert_eq!(shared(&found), [Some(("1", vec!["2"]))]);
    assert_eq!(mended(&found), numbered(&[HOOKE, ENERGY]));
}

#[test]
fn what_nothing_else_stands_on_may_be_wrong_instead() {
    let wrong = ENERGY.replace('+', "-");
    let doubts = |displays: &[&str]| {
        let found = checked(&oscillator(), displays);
        let energy = found.equations.into_iter().find(|equation| equation.id == "2");
        energy.map_or(Vec::new(), |energy| energy.elsewhere)
    };
    assert_eq!(doubts(&[HOOKE, &wrong]), ["1"]);
    assert!(doubts(&[HOOKE, &wrong, PERIOD]).is_empty(), "the third vouches for the first");
    // An identity needs no law, and so vouches for none.
    assert_eq!(doubts(&[HOOKE, &wrong, r"\frac{d}{dt} x^2 = 2 x \dot x"]), ["1"]);
    assert!(doubts(&[HOOKE, ENERGY]).is_empty());
}

#[test]
fn what_a_display_says_of_the_name_that_it_introduces_is_mended() {
    let mut claims = oscillator();
    claims["constants"] = json!({ "m, k, b": "> 0" });
    claims["equations"] = json!({});
    let damped = r"m \ddot x = -k x - b \dot x";
    let loss = |loss: &str| format!(r"{ENERGY}, \qquad \dot E = {loss}");
    for slip in [r"b \dot x^2", r"-b \dot x", r"-k \dot x^2"] {
        let found = checked(&claims, &[damped, &loss(slip)]);
        assert_eq!(mended(&found), numbered(&[damped, &loss(r"-b \dot x^2")]), "{slip}");
    }
}

#[test]
fn a_name_and_what_is_said_of_it_may_either_be_wrong() {
    let claims = json!({ "constants": { "a, b": "> 0" } });
    let display = |s: &str, square: &str| numbered(&[&format!(r"s = {s}, \qquad s^2 = {square}")]);
    let (sum, difference) = (display("a + b", "a^2 + 2ab + b^2"), display("a - b", "a^2 - 2ab + b^2"));
    let found = checked(&claims, &[r"s = a - b, \qquad s^2 = a^2 + 2ab + b^2"]);
    let offered: Vec<String> = found.equations[0]
        .repairs
        .iter()
        .map(|repair| {
            let mut text = found.source.text.clone();
            text.replace_range(repair.span.range(), &repair.replacement);
            text
        })
        .collect();
    assert!(offered.contains(&sum) && offered.contains(&difference), "{offered:?}");
    // What passes offers nothing.
    let holds = checked(&claims, &[r"s = a - b, \qquad s^2 = a^2 - 2ab + b^2"]);
    assert!(holds.equations[0].ok && holds.equations[0].repairs.is_empty());
}

/// A mass on a spring, its energy, and what is said of that.
fn spring(energy: &str) -> Document {
    let claims = json!({
        "varies with time": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "laws": { "Newton": "1" },
        "sentences": [{ "name": "E does not change", "quote": r"m \ddot x = -k x", "conserved": "E" }],
    });
    checked(&claims, &[r"m \ddot x = -k x", energy])
}

#[test]
fn a_sentence_tells_which_side_of_a_chain_is_wrong() {
    let right = r"E = \frac{1}{2} m \dot x^2 + \frac{1}{2} k x^2 = \frac{m \dot x^2 + k x^2}{2}";
    assert!(spring(right).equations.iter().all(|equation| equation.ok));
    let first = spring(&right.replacen(r"+ \frac{1}{2} k", r"- \frac{1}{2} k", 1));
    assert_eq!(mended(&first), numbered(&[r"m \ddot x = -k x", right]));
    assert_eq!(shared(&first), [Some(("2", vec!["2", "E does not change"]))]);
    // The twin: what the name is holds, and the slip is in what it comes to.
    let second = spring(&right.replacen("^2 + k", "^2 - k", 1));
    assert_eq!(mended(&second), numbered(&[r"m \ddot x = -k x", right]));
    assert_eq!(shared(&second), [None]);
}

#[test]
fn a_chain_that_nothing_uses_may_be_wrong_on_either_side() {
    let claims = json!({ "constants": { "m, v, p": "> 0" } });
    let chain = |last: &str| format!(r"T = \frac{{1}}{{2}} m v^2 = {last}");
    let elsewhere = |displays: &[&str]| checked(&claims, displays).equations[0].elsewhere.clone();
    assert_eq!(elsewhere(&[&chain(r"\frac{(m v)^2}{m}")]), ["1"]);
    // The twin: another equation holds by what the name is.
    let pinned = r"\frac{T}{m v} = \frac{v}{2}";
    assert_eq!(elsewhere(&[&chain(r"\frac{(m v)^2}{m}"), pinned]), [] as [&str; 0]);
}

#[test]
fn no_edit_defines_a_name_by_itself() {
    // What mends (3) and (4) is the cosine; y for l in (1) would be 2x.
    let claims = json!({ "constants": { "l": "> 0" }, "varies with time": { r"\theta": "angle" } });
    let displays = |x: &str| {
        let x = format!(r"x = l {x}\theta");
        [x, "y = 2 x".to_owned(), r"x^2 = l^2 \cos^2\theta".to_owned(), r"y^2 = 4 l^2 \cos^2\theta".to_owned()]
    };
    let found = |x: &str| {
        let displays = displays(x);
        checked(&claims, &displays.each_ref().map(String::as_str))
    };
    assert!(found(r"\cos").equations.iter().all(|equation| equation.ok));
    assert_eq!(mended(&found(r"\sin")), numbered(&displays(r"\cos").each_ref().map(String::as_str)));
}

#[test]
fn an_equation_and_its_solutions_are_mended_together() {
    let claims = json!({
        "constants": { "a, b": "> 0", "y": "> 0" },
        "equations": { "1": { "where": { "y": "y_{+}" } }, "2": { "solves": "1", "for": "y" } },
    });
    let of = |equation: &str| {
        let displays = [equation, r"y_{\pm} = a + b \pm b"];
        document(&claims, &numbered(&displays), &Registry::standard(), None).unwrap().equations
    };
    let found = of("(a - y)^2 - b^2 = 0");
    for equation in &found {
        let repair = &equation.repairs[0];
        let shared = repair.shared.as_ref().unwrap_or_else(|| panic!("{equation:?}"));
        assert_eq!((shared.of.as_str(), shared.mends.len(), repair.replacement.trim()), ("1", 2, "+ b"));
    }
    // The twin: as it was meant, both hold.
    assert!(of("(a - y + b)^2 - b^2 = 0").iter().all(|equation| equation.ok));
}

/// A particle in the potential ¼kx⁴, by the Lagrangian that the notes print.
fn quartic() -> Json {
    json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian" },
        "equations": { "4": { "conserved": true } },
    })
}

#[test]
fn a_slip_in_the_lagrangian_is_mended_beside_an_equation_that_is_wrong_by_itself() {
    let lagrangian = r"L = \frac12 m \dot x^2 - \frac14 k x^3";
    let right = [r"m \ddot x = -k x^3", r"\dot p_x = -k x^3", r"E = \frac12 m \dot x^2 + \frac14 k x^4"];
    let own = r"x \ddot x = \frac{k x^4}{m}";
    let found = checked(&quartic(), &[lagrangian, right[0], right[1], right[2], own]);
    let of_the_lagrangian = Some(("1", vec!["2", "3", "4"]));
    assert_eq!(shared(&found), [of_the_lagrangian.clone(), of_the_lagrangian.clone(), of_the_lagrangian, None]);
    assert!(mended(&found).contains(r"- \frac14 k x^4"), "{}", mended(&found));
    // The twin: where half of what fails is wrong by itself, the Lagrangian is not blamed.
    let (force, energy) = (r"\dot p_x = k x^3", r"E = \frac12 m \dot x^2 + \frac12 k x^4");
    let found = checked(&quartic(), &[r"L = \frac12 m \dot x^2 - \frac14 k x^4", right[0], force, energy, own]);
    assert_eq!(shared(&found), [None, None, None]);
}

#[test]
fn a_display_that_applies_a_function_of_the_lagrangian_is_read_again_with_each_edit() {
    let claims = json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k, a": "> 0" },
        "means": { "L": "Lagrangian", "U": "potential energy", "T": "kinetic energy" },
        "equations": { "4": { "conserved": true } },
    });
    let displays = |power: u8, height: &str| {
        [
            format!(r"U(x) = \frac12 k x^2 + a x^{power}"),
            r"T = \frac12 m \dot x^2, \qquad L = T - U".to_owned(),
            r"m \ddot x = -k x - 3 a x^2".to_owned(),
            r"E = \frac12 m \dot x^2 + \frac12 k x^2 + a x^3".to_owned(),
            r"x_s = -\frac{k}{3 a}".to_owned(),
            format!(r"U_s = U(x_s) = {height}"),
        ]
    };
    let printed = displays(2, r"\frac{k^3}{54 a^2}");
    let found = checked(&claims, &printed.each_ref().map(String::as_str));
    assert_eq!(shared(&found)[0], Some(("1", vec!["3", "4", "6"])));
    assert!(mended(&found).contains(r"k x^2 + a x^3"), "{}", mended(&found));
    // The twin: with a slip of its own the last display is not repaired with the others.
    let printed = displays(2, r"\frac{k^3}{45 a^2}");
    let found = checked(&claims, &printed.each_ref().map(String::as_str));
    assert_ne!(shared(&found)[0], Some(("1", vec!["3", "4", "6"])));
}

#[test]
fn the_lagrangian_is_called_wrong_where_many_displays_contradict_it() {
    let lagrangian = |sign: &str| format!(r"L = \frac12 m \dot x^2 {sign} \frac14 k x^4");
    let right = [
        r"\frac{\partial L}{\partial x} = -k x^3",
        r"m \ddot x = -k x^3",
        r"E = \frac12 m \dot x^2 + \frac14 k x^4 = \text{const}",
        r"m x \ddot x = -k x^4",
    ];
    let claims = json!({
        "coordinates": { "x": "any" }, "constants": { "m, k": "> 0" }, "means": { "L": "Lagrangian" },
    });
    let of = |sign: &str, others: &[&str]| {
        let lagrangian = lagrangian(sign);
        checked(&claims, &[&[lagrangian.as_str()], others].concat())
    };
    assert!(of("-", &right).equations.iter().all(|equation| equation.ok));
    let found = of("+", &right);
    let first = &found.equations[0];
    assert_eq!(first.finding.code, Code::DefinitionContradicted);
    assert_eq!((first.finding.verdict, first.repairs[0].replacement.as_str()), (Verdict::Refuted, "-"));
    for other in &found.equations[1..] {
        assert_eq!(other.finding.verdict, Verdict::Undecided, "{other:?}");
        assert_eq!(other.finding.follows_from.as_ref().map(|known| known.root.as_str()), Some("1"));
    }
    // The twin: a few displays may be wrong by themselves.
    let found = of("+", &right[..3]);
    assert_eq!(found.equations[1].finding.verdict, Verdict::Refuted);
    assert!(found.equations[0].ok);
}

#[test]
fn a_display_that_is_false_itself_is_called_wrong_in_the_place_of_what_uses_it() {
    let claims = json!({ "constants": { "a, b": "> 0" } });
    let displays = |sign: &str| [format!("p = a {sign} b = b + a"), "p^2 = a^2 + 2ab + b^2".to_owned()];
    let of = |sign: &str| checked(&claims, &displays(sign).each_ref().map(String::as_str));
    assert!(of("+").equations.iter().all(|equation| equation.ok));
    let found = of("-");
    let verdicts: Vec<Verdict> = found.equations.iter().map(|equation| equation.finding.verdict).collect();
    assert_eq!(verdicts, [Verdict::Refuted, Verdict::Undecided]);
    assert_eq!(mended(&found), numbered(&displays("+").each_ref().map(String::as_str)));
    // The twin: what no edit of it mends is wrong by itself.
    let found = checked(&claims, &["p = a - b = b + a", "p^2 = a^2 + 3ab + b^2"]);
    assert_eq!(found.equations[1].finding.verdict, Verdict::Refuted);
}

fn lengths(displays: &[&str]) -> Vec<(Verdict, bool)> {
    let found = checked(&json!({ "constants": { "a, b": "> 0" } }), displays);
    found.equations.iter().map(|equation| (outcome(&equation.finding), equation.ok)).collect()
}

#[test]
fn a_definition_that_several_displays_contradict_is_wrong_where_one_of_them_cannot_be_corrected_itself() {
    let uses = [r"u^2 - b^2 = a^2", r"u^4 - b^4 = a^4 + 2a^2b^2"];
    let slip = r"u = \sqrt{a + b^2}";
    let right = lengths(&[r"u = \sqrt{a^2 + b^2}", uses[0], uses[1]]);
    assert_eq!(right, [(Verdict::Definition, true), (Verdict::Verified, true), (Verdict::Verified, true)]);
    let found = lengths(&[slip, uses[0], uses[1]]);
    assert_eq!(found, [(Verdict::Refuted, false), (Verdict::Undecided, false), (Verdict::Undecided, false)]);
    // The twin: each display can be corrected as well, so nobody knows which is wrong.
    let found = lengths(&[r"u = \sqrt{a^2 + b}", uses[0], r"(u - a)(u + a) = b^2"]);
    assert_eq!(found, [(Verdict::Undecided, false), (Verdict::Refuted, false), (Verdict::Refuted, false)]);
}

#[test]
fn a_definition_that_its_only_user_contradicts_is_left_open() {
    let found = lengths(&[r"u = \sqrt{a + b^2}", r"u^4 - b^4 = a^4 + 2a^2b^2"]);
    assert_eq!(found, [(Verdict::Undecided, false), (Verdict::Refuted, false)]);
}

#[test]
fn a_definition_that_only_a_wrong_display_uses_is_no_second_failure() {
    let definition = r"u = \sqrt{a^2 + b^2}";
    let found = lengths(&[definition, "u^2 = a^2 - b^2"]);
    assert_eq!(found, [(Verdict::Undecided, true), (Verdict::Refuted, false)]);
    // The twin: no edit of the display corrects it, so the definition may be wrong as well.
    let found = lengths(&[definition, "u^4 = a^4 + a b^2"]);
    assert_eq!(found, [(Verdict::Undecided, false), (Verdict::Refuted, false)]);
}
