//! What is offered for a wrong display that is more than an equation: one that defines names, or teaches units.

use onshell::check::{Equation, Verdict};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, equation, numbered, numbers, pendulum, planet, top, with};

/// The first of some displays, all of which are claimed.
fn first(claims: &Json, displays: &[&str]) -> Equation {
    let equations: serde_json::Map<String, Json> = (1..=displays.len()).map(|n| (n.to_string(), json!({}))).collect();
    let claims = with(claims, "equations", json!(equations));
    let found = document(&claims, &numbered(displays), &Registry::standard(), None);
    found.unwrap_or_else(|error| panic!("{displays:?}: {error}")).equations.remove(0)
}

/// The first of some displays with each of the edits that are offered for it.
fn mended(claims: &Json, displays: &[&str]) -> Vec<String> {
    let wrong = first(claims, displays);
    assert!(!wrong.ok, "{displays:?}: {}", wrong.finding.message);
    let start = "$$\n".len();
    let text = |repair: &onshell::check::Repair| {
        let (before, after) = displays[0].split_at(repair.span.start - start);
        format!("{before}{}{}", repair.replacement, &after[repair.span.end - repair.span.start..])
    };
    wrong.repairs.iter().map(text).collect()
}

#[test]
fn a_wrong_definition_is_mended_where_it_stands() {
    let square = "s^2 = a^2 + 2 a b + b^2";
    assert_eq!(mended(&numbers(), &["s = a - b = b + a", square])[0], "s = a + b = b + a");
    // The twin: what stands on the name tells which of the two members is wrong.
    let square = "s^2 = a^2 - 2 a b + b^2";
    let all = mended(&numbers(), &["s = a - b = b + a", square]);
    assert!(!all.is_empty() && !all.contains(&"s = a + b = b + a".to_owned()), "{all:?}");
}

#[test]
fn a_name_may_be_used_before_the_display_says_what_it_is() {
    let displays = ["q = \\frac{a}{S} = \\frac{a}{a + b} \\, , \\quad S = a + 2 b", "q (a + b) = a", "S^2 - S a = S b"];
    let bare = |text: &str| text.replace(' ', "");
    assert_eq!(bare(&mended(&numbers(), &displays)[0]), bare(&displays[0].replace("a + 2 b", "a + b")));
}

#[test]
fn no_unit_is_learnt_from_what_is_wrong() {
    let claims = with(&pendulum(), "units", json!({ "m": "kg", "l": "m" }));
    let lost = r"m l^2 \ddot\theta = - m g \sin\theta";
    let all = mended(&claims, &[lost]);
    assert!(all.iter().any(|text| first(&claims, &[text]).finding.verdict == Verdict::Certified), "{all:?}");
    // The twin: a unit that is declared holds.
    let claims = with(&pendulum(), "units", json!({ "m": "kg", "l": "m", "g": "m^2/s^2" }));
    assert_eq!(mended(&claims, &[lost]), Vec::<String>::new());
}

#[test]
fn a_slip_in_an_old_form_is_mended_in_it() {
    for (wrong, right) in [
        (r"\boxed{(a + b)^2 = a^2 + a b + b^2}", r"\boxed{(a + b)^2 = a^2 + 2 \, a b + b^2}"),
        (r"{a - b \over 2 c} = {a \over 2 c} + {b \over 2 c}", r"{a - b \over 2 c} = {a \over 2 c} - {b \over 2 c}"),
        (r"(a + b) (a - b) \stackrel{!}{=} a^2 + b^2", r"(a + b) (a - b) \stackrel{!}{=} a^2 - b^2"),
    ] {
        assert_eq!(mended(&numbers(), &[wrong])[0], right);
        assert!(first(&numbers(), &[right]).ok, "{right}");
    }
}

/// Whether one of the edits makes of a display this text, spaces aside.
fn is_mended(claims: &Json, wrong: &str, claim: Json, right: &str) -> bool {
    let bare = |text: &str| text.replace([' ', ','], "").replace('\\', "").replace("left(", "(").replace("right)", ")");
    let found = equation(claims, &[wrong], claim);
    assert!(!found.ok, "{wrong}: {}", found.finding.message);
    let start = "$$\n".len();
    found.repairs.iter().any(|repair| {
        let (before, after) = wrong.split_at(repair.span.start - start);
        bare(&format!("{before}{}{}", repair.replacement, &after[repair.span.end - repair.span.start..])) == bare(right)
    })
}

#[test]
fn a_term_that_stands_nowhere_else_is_found_by_its_value() {
    let motion = r"\lambda_1 \ddot\theta = \lambda_1 \dot\phi^2 \sin\theta \cos\theta - \dot\phi \sin\theta \, p_\psi";
    assert!(is_mended(&top(), motion, json!({}), &format!(r"{motion} + M \, g \, R \, \sin\theta")));
    // where the states are moved onto a hypothesis as well
    let steady = r"\lambda_1 \Omega^2 \cos\theta - \lambda_3 \Omega \omega_3 = 0";
    let claim = json!({ "throughout": r"\dot\theta = 0" });
    let right = r"\lambda_1 \Omega^2 \cos\theta - \lambda_3 \Omega \omega_3 + M \, g \, R = 0";
    assert!(is_mended(&top(), steady, claim, right));
    // The twin: where a printed term is wrong as well, nothing that is put in makes it true.
    let wrong = motion.replace(r"- \dot\phi", r"- 7 \dot\phi");
    assert_eq!(equation(&top(), &[&wrong], json!({})).repairs, Vec::new());
}

#[test]
fn a_quantity_by_its_name() {
    assert!(is_mended(&pendulum(), "L = - U", json!({}), "L = - U + T"));
    // The twin: what is wrong is not taken away by what is put in.
    assert!(!is_mended(&pendulum(), r"L = 3 T - U", json!({}), "L = 3 T - U - 2 T"));
}

#[test]
fn a_sum_that_is_a_factor_is_found_in_normal_form() {
    let claims = with(&planet(), "means", json!({ "T": "kinetic energy" }));
    let found = equation(&claims, &[r"T = \frac{1}{2} m"], json!({})).repairs;
    let is_square = |text: &str| text.contains(r"\dot{r}^{2} + ") && text.contains(r"\dot{\phi}^{2}");
    assert!(found.iter().any(|repair| is_square(&repair.replacement)), "{found:?}");
    // The twin: a quotient that takes away what stands there is no factor that was lost.
    let all = equation(&numbers(), &["a b = x^2 c + x + 1"], json!({})).repairs;
    assert_eq!(all, Vec::new());
}

#[test]
fn a_vector_is_found_among_the_products_of_those_that_are_known() {
    let claims = json!({
        "constants": { r"\vec a, \vec b, \vec c": "any" },
        "define": { r"\vec d": r"\vec a \times \vec b + 2 \vec c" },
    });
    assert!(is_mended(&claims, r"\vec d = 2 \vec c", json!({}), r"\vec d = 2 \vec c + \vec{a} \times \vec{b}"));
    // The twin: a vector along another one is not.
    assert!(equation(&claims, &[r"\vec d = 2 \vec c + 3 \vec b"], json!({})).repairs.is_empty());
}

#[test]
fn a_power_left_outside_of_the_parenthesis_that_was_lost_goes_back_onto_it() {
    let square = "c a^2 + 2 c a b + c b^2 = c a + b^2";
    assert!(is_mended(&numbers(), square, json!({}), "c a^2 + 2 c a b + c b^2 = c (a + b)^2"));
    // The twin: another power does not.
    let cube = square.replace("= c a + b^2", "= c a + b^3");
    assert!(!is_mended(&numbers(), &cube, json!({}), "c a^2 + 2 c a b + c b^2 = c (a + b)^3"));
}

#[test]
fn nothing_is_mended_to_an_equation_that_says_nothing() {
    let moving = json!({ "varies with time": { "x": "any" }, "constants": { "a, b, c, g": "> 0" } });
    for wrong in [
        "a + b = a",
        "ab = a",
        "a b c = a b",
        "x = 2x",
        "g = 0",
        r"\dot x = 0",
        r"x = \cos(a) x",
        r"\cos(a + b) = \cos a",
        r"a = \sqrt{1}",
    ] {
        assert_eq!(mended(&moving, &[wrong]), Vec::<String>::new(), "{wrong}");
    }
    assert_eq!(mended(&pendulum(), &[r"\dot\theta = 0"]), Vec::<String>::new());
    // An energy is no slip for an angle; a term that was lost is one.
    let all = mended(&pendulum(), &[r"\ddot\theta = 0"]);
    assert!(!all.is_empty() && all.iter().all(|text| text.contains(r"\ddot\theta")), "{all:?}");
    // What is near to something is not near to 0, nor is 0 to itself.
    let near = |latex: &str| {
        let claims = with(&moving, "equations", json!({ "1": { "limit": r"x \to 0" } }));
        let found = document(&claims, &numbered(&[latex]), &Registry::standard(), None);
        let equation = found.unwrap_or_else(|error| panic!("{latex}: {error}")).equations.remove(0);
        (equation.ok, equation.repairs.into_iter().map(|repair| repair.replacement).collect::<Vec<_>>())
    };
    assert_eq!(near(r"\sqrt{\sin^2 x} \approx x"), (false, Vec::new()));
    let (ok, near) = near(r"\sin(a x) \approx b x");
    assert!(!ok && near.contains(&"a".to_owned()), "{near:?}");
    // The twins: where something is done in an identity, a slip in it is mended.
    for (wrong, right) in [
        ("(a + b)^2 = a^2 + ab + b^2", "(a + b)^2 = a^2 + 2ab + b^2"),
        (r"\sin^2 x = 1 + \cos^2 x", r"\sin^2 x = 1 - \cos^2 x"),
        ("a (b + c) = ab + bc", "a (b + c) = ab + ac"),
        ("a + a + b = 3a + b", "a + a + b = 2a + b"),
        ("a - b + c = c - b - a", "a - b + c = c - b + a"),
    ] {
        let bare = |text: &str| text.replace(r"\,", "").replace(' ', "");
        let all = mended(&moving, &[wrong]);
        assert!(all.iter().any(|text| bare(text) == bare(right)), "{wrong}: {all:?}");
    }
}

#[test]
fn an_identity_that_is_zero_is_offered_where_nothing_else_is_and_for_its_author_to_make() {
    let claims = json!({ "indices": { "i": "1..n" }, "constants": { "M, m_i": "> 0", r"\vec r_i": "any" } });
    let wrong = r"\frac{m_i \vec{r}_i - m_i (-\vec{r}_i)}{M} = 0";
    let found = equation(&claims, &[wrong], json!({}));
    assert!(is_mended(&claims, wrong, json!({}), r"\frac{m_i \vec{r}_i + m_i (-\vec{r}_i)}{M} = 0"), "{found:?}");
    assert!(found.repairs.iter().all(|repair| repair.idle), "{found:?}");
    // The twins: what would only be a name beside itself, and what is zero in no way.
    let vectors = json!({ "constants": { r"\vec a, \vec b": "any" } });
    for wrong in [r"\vec a \times \vec b = 0", r"\vec a \cdot \vec b = 0", r"\vec a = 0"] {
        assert_eq!(equation(&vectors, &[wrong], json!({})).repairs, Vec::new(), "{wrong}");
    }
}

#[test]
fn a_factor_that_stands_nowhere_else_is_found_in_an_equation_of_vectors() {
    let claims = json!({
        "indices": { "i": "1..n" },
        "constants": { "m_i": "> 0" },
        "varies with time": { r"\vec r_i": "any" },
        "define": { "M": r"\sum_i m_i", r"\vec s": r"\frac{\sum_i m_i \vec r_i}{\sum_i m_i}" },
    });
    let wrong = r"\vec s = \sum_i m_i \vec r_i";
    assert!(is_mended(&claims, wrong, json!({}), r"\vec s \, M = \sum_i m_i \vec r_i"), "{:?}", {
        equation(&claims, &[wrong], json!({})).repairs
    });
    // A member that was zero before the slip was made is no reason to doubt.
    let found = equation(&claims, &[r"\sum_i m_i (\vec r_i + \vec s) = M (\vec s - \vec s) = 0"], json!({}));
    assert!(found.repairs.iter().any(|repair| repair.replacement == "-" && !repair.idle), "{found:?}");
    // The twin: no number makes one vector of two.
    let two = r"\vec s = \sum_i m_i \dot{\vec r}_i";
    assert_eq!(equation(&claims, &[two], json!({})).repairs, Vec::new());
}

#[test]
fn what_holds_for_each_of_many_is_mended_however_many_there_are() {
    let claims = json!({
        "indices": { "i": "1..n" },
        "constants": { "m_i, k": "> 0" },
        "varies with time": { "x_i": "any" },
    });
    let rate = r"\frac{d}{dt} (m_i x_i^2 + k x_i)";
    let right = r"2 m_i x_i \dot x_i + k \dot x_i";
    let wrong = format!("{rate} + k x_i = {right}");
    let all = equation(&claims, &[&wrong], json!({})).repairs;
    assert!(is_mended(&claims, &wrong, json!({}), &format!("{rate} = {right}")), "{all:?}");
}

/// A body that turns, with its angular velocity along its own axes.
fn turning_body() -> Json {
    json!({
        "system": "free_rigid_body",
        "coordinates": { r"\theta": "(0, \\pi)", r"\phi, \psi": "angle" },
        "constants": { r"\lambda_1, \lambda_2, \lambda_3": "> 0" },
        "indices": { "a, b, c, d": "1..3" },
        "means": { "R_{ab}": "rotation matrix", r"\vec\omega, \omega_a": "angular velocity", r"\hat e_a": "body axes" },
    })
}

#[test]
fn a_whole_multiple_of_a_vector_that_is_lost_is_found() {
    let terms = [
        r"(\dot\theta \sin\psi - \dot\phi \sin\theta \cos\psi) \hat e_1",
        r"(\dot\theta \cos\psi + \dot\phi \sin\theta \sin\psi) \hat e_2",
        r"(\dot\psi + \dot\phi \cos\theta) \hat e_3",
    ];
    let whole = format!(r"\vec\omega = {}", terms.join(" + "));
    for (lost, along) in [r"\hat e_1", r"\hat e_2", r"\hat e_3"].into_iter().enumerate() {
        let left: Vec<&str> = (0..3).filter(|at| *at != lost).map(|at| terms[at]).collect();
        let wrong = format!(r"\vec\omega = {}", left.join(" + "));
        let offered = equation(&turning_body(), &[&wrong], json!({})).repairs;
        let first = offered.first().map(|repair| repair.replacement.as_str()).unwrap_or_default();
        assert!(first.starts_with(" + ") && first.ends_with(along), "{wrong}: {offered:?}");
    }
    // The twin: what is printed along a vector is wrong, and nothing is added beside it.
    let wrong = whole.replace(r"\dot\psi + \dot\phi \cos\theta", r"\dot\psi^2 + \dot\phi^2 \cos^3\theta");
    assert_eq!(equation(&turning_body(), &[&wrong], json!({})).repairs, Vec::new());
}

#[test]
fn a_factor_with_the_letters_that_stand_alone_is_found() {
    let right = r"\omega_a = \frac{1}{2} \epsilon_{abc} \dot R_{bd} R_{cd}";
    for (lost, name) in [(r"\epsilon_{abc} ", r"\epsilon_{abc}"), (r"\dot R_{bd} ", r"\dot{R}_{bd}")] {
        let found = equation(&turning_body(), &[&right.replace(lost, "")], json!({}));
        let offered: Vec<&str> = found.repairs.iter().map(|repair| repair.replacement.as_str()).collect();
        assert!(offered.iter().any(|offered| offered.contains(name)), "{lost}: {offered:?}");
    }
    // The twin: with another number besides, no factor mends it.
    let two = right.replace(r"\epsilon_{abc} ", "").replace(r"\frac{1}{2}", "7");
    assert_eq!(equation(&turning_body(), &[&two], json!({})).repairs, Vec::new());
}

#[test]
fn what_a_sentence_speaks_of_may_be_what_was_lost() {
    let claims = json!({
        "constants": { r"\vec a, \vec b": "any" },
        "define": { r"\vec c": r"\vec a \times \vec b" },
    });
    let mended = |prose: &str| {
        let notes = format!("{prose}\n\n{}", numbered(&[r"\vec c = \vec a"]));
        let found = document(&claims, &notes, &Registry::standard(), None).unwrap().equations.remove(0);
        found.repairs.into_iter().map(|repair| repair.replacement.replace(' ', "")).collect::<Vec<_>>()
    };
    assert!(mended(r"Let $\vec a$ be at a right angle to $\vec b$.").contains(&r"\times\vecb".to_owned()));
    // The twin: with nothing said of it.
    assert_eq!(mended(r"Let $\vec a$ be a vector."), Vec::<String>::new());
}

#[test]
fn a_root_that_is_lost_is_put_back_where_it_stood() {
    let claims = with(&numbers(), "define", json!({ "w": r"\sqrt{a/b}", "h": r"\sqrt{a^2 + b^2}" }));
    for (wrong, right) in [
        (r"w = \frac{a}{b}", r"w = \sqrt{\frac{a}{b}}"),
        (r"2 w = 2 \frac{a}{b}", r"2 w = 2 \sqrt{\frac{a}{b}}"),
        (r"\frac{1}{w} = \frac{b}{ab}", r"\frac{1}{w} = \frac{b}{\sqrt{ab}}"),
        ("h = a^2 + b^2", r"h = \sqrt{a^2 + b^2}"),
        (r"h^2 = (a + b)^2", r"h^2 = (a^2 + b^2)"),
    ] {
        assert!(is_mended(&claims, wrong, json!({}), right), "{wrong}: {:?}", {
            equation(&claims, &[wrong], json!({})).repairs
        });
    }
    // The twin: of something else it is no root.
    assert_eq!(equation(&claims, &[r"w = \frac{a + c}{b}"], json!({})).repairs, Vec::new());
}

#[test]
fn a_name_known_by_its_square_is_meant_where_a_square_stands() {
    let claims = json!({ "constants": { r"\omega_0, \gamma": "> 0" } });
    let displays = |second: &str| [r"\omega_d^2 = \omega_0^2 - \gamma^2".to_owned(), second.to_owned()];
    let [first, second] = displays(r"\omega_0^2 + \gamma^2 = \omega_0^2");
    let found = equation(&claims, &[&first, &second], json!({}));
    assert!(found.repairs.iter().any(|repair| repair.replacement == r"\omega_d"), "{:?}", found.repairs);
    // The twin: where none stands, it is not.
    let [first, second] = displays(r"\omega_0 + \gamma = \omega_0");
    let found = equation(&claims, &[&first, &second], json!({}));
    assert!(found.repairs.iter().all(|repair| repair.replacement != r"\omega_d"), "{:?}", found.repairs);
}

#[test]
fn a_definition_that_only_its_constancy_tests_is_mended() {
    let claims = json!({
        "varies with time": { r"s, \varphi, F": "any" },
        "constants": { "m, g, R, I": "> 0", r"\alpha": r"(0, \pi/2)" },
        "laws": { "Newton": "1", "torque": "2", "rolling": "3" },
    });
    let laws = [r"m \ddot s = mg \sin\alpha - F", r"I \ddot\varphi = F R", r"s = R \varphi"];
    let right = r"E = \frac12 m \dot s^2 + \frac12 I \dot\varphi^2 - m g s \sin\alpha";
    for (whole, lost) in [(r"\dot s^2", r"\dot s"), (r"\dot\varphi^2", r"\dot\varphi"), (r"\sin", r"\cos")] {
        let wrong = right.replace(whole, lost);
        let claims = with(&claims, "equations", json!({ "4": { "conserved": true } }));
        let notes = numbered(&[laws[0], laws[1], laws[2], &wrong]);
        let found = document(&claims, &notes, &Registry::standard(), None).unwrap().equations.remove(3);
        assert!(!found.ok, "{wrong}");
        let first = &found.repairs[0];
        let mended = format!("{}{}{}", &notes[..first.span.start], first.replacement, &notes[first.span.end..]);
        assert!(mended.contains(right), "{wrong}: {:?}", found.repairs);
    }
}

#[test]
fn the_other_end_of_a_chain_may_be_the_likelier_one() {
    let wrong = "S = a - b (c + x) = a + b c + b x";
    assert_eq!(mended(&numbers(), &[wrong])[0], wrong.replace('-', "+"));
    // The twin: where another equation says what S is, the sign in it is right.
    let all = mended(&numbers(), &[wrong, "S + b x = a - b c"]);
    assert!(!all.contains(&wrong.replace('-', "+")), "{all:?}");
}

#[test]
fn what_is_taken_back_at_once_is_not_put_in() {
    let all = mended(&numbers(), &["a (b - c) = a b"]);
    assert!(all.iter().all(|text| !text.contains("- c + c")), "{all:?}");
    // nor the other side: it is that which should not be there
    let all = mended(&pendulum(), &[r"\dot E = m g l"]);
    assert!(all.contains(&r"\dot E = 0".to_owned()) && all.iter().all(|text| !text.contains('+')), "{all:?}");
    // The twin: where a term stands twice, it is a sign that is wrong.
    let all = mended(&numbers(), &["c + a + a = c"]);
    assert_eq!(all, ["c - a + a = c"]);
}

#[test]
fn what_introduces_a_name_and_cannot_be_read_is_read_anew() {
    let wrong = r"s = (a + b) C = ac + bc";
    assert_eq!(mended(&numbers(), &[wrong])[0], wrong.replace('C', "c"));
    // The twin: a name that is like none.
    assert_eq!(mended(&numbers(), &[r"s = (a + b) \Xi"]), Vec::<String>::new());
}

#[test]
fn a_wrong_sign_is_likelier_than_a_minus_too_much() {
    let displays = ["s + a b = c", "s = c - u", "u = -a b", "s + s = 2 c - 2 a b"];
    let repairs = first(&numbers(), &displays).repairs;
    let of = |repair: &onshell::check::Repair| repair.shared.as_ref().map(|shared| shared.of.clone());
    let found: Vec<_> = repairs.iter().map(|repair| (of(repair), repair.replacement.as_str())).collect();
    assert_eq!(found[..2], [(Some("2".to_owned()), "+"), (Some("3".to_owned()), "")]);
}

#[test]
fn one_unit_vector_stands_for_another() {
    let claims = with(&numbers(), "axes", json!({ r"\hat x, \hat y, \hat z": "fixed" }));
    let all = mended(&claims, &[r"a \hat x \times \hat y = a \hat y"]);
    assert!(all.contains(&r"a \hat x \times \hat y = a \hat{z}".to_owned()), "{all:?}");
}

#[test]
fn a_claim_stands_on_what_it_means_by_a_name() {
    let claims = json!({
        "constants": { "a, b": "> 0", "y": "> 0" },
        "equations": { "1": { "where": { "y": "y_{+}" } }, "2": { "solves": "1", "for": "y" } },
    });
    let displays = [r"(y^2 - 2a)^2 = 2a^2", r"y_{\pm} = \sqrt{2a \pm 2a}"];
    let found = document(&claims, &numbered(&displays), &Registry::standard(), None).unwrap();
    let repair = &found.equations[0].repairs[0];
    assert_eq!(
        (repair.shared.as_ref().map(|shared| shared.of.as_str()), &*repair.replacement),
        (Some("2"), r"\sqrt{2}")
    );
    // The twin: what (1) says is not made to agree with the slip.
    assert!(found.equations[0].repairs.iter().all(|repair| !repair.replacement.contains("a^")), "{found:?}");
}

/// What the first display becomes with its first repair, beside the Lagrangian that the notes define.
fn mended_beside(lagrangian: &str, others: &[&str], wrong: &str) -> String {
    let mut coordinates = json!({ r"\theta": "angle" });
    if lagrangian.contains(r"\dot r") {
        coordinates["r"] = json!("> 0");
    }
    let claims = json!({
        "coordinates": coordinates,
        "constants": { "m, k, g, l": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let displays = [&[wrong, lagrangian], others].concat();
    mended(&claims, &displays).into_iter().next().unwrap_or_default()
}

#[test]
fn a_two_lost_under_a_fraction_line_is_likelier_than_lost_parentheses() {
    let spring = r"L = \frac12 m(\dot r^2 + r^2\dot\theta^2) - \frac12 k r^2";
    let momentum = r"\ell = m r^2\dot\theta = \text{const}";
    let energy = |term: &str| format!(r"E = \frac12 m\dot r^2 + {term} + \frac12 k r^2 = \text{{const}}");
    let found = mended_beside(spring, &[momentum], &energy(r"\frac{\ell^2}{m r^2}"));
    assert_eq!(found, energy(r"\frac{\ell^2}{2 \, m r^2}"));
}

#[test]
fn numbers_in_a_fraction_are_exchanged_or_replaced_together() {
    let rod = r"L = \frac16 m l^2\dot\theta^2 + \frac12 m g l\cos\theta";
    let motion = |fraction: &str| format!(r"\ddot\theta = -{fraction}\sin\theta");
    assert_eq!(mended_beside(rod, &[], &motion(r"\frac{2 g}{3 l}")), motion(r"\frac{3 g}{2 l}"));
    let shell = r"L = \frac13 m l^2\dot\theta^2 + m g l\cos\theta";
    let momentum = |fraction: &str| format!(r"p_\theta = {fraction} m l^2\dot\theta");
    assert_eq!(mended_beside(shell, &[], &momentum(r"\frac12")), momentum(r"\frac{2}{3}"));
}

#[test]
fn squares_lost_in_all_terms_of_a_sum_are_put_back() {
    let hypotenuse = |sum: &str| format!(r"b^4 - a^4 = (b^2 - a^2)({sum})");
    assert!(mended(&numbers(), &[&hypotenuse("a + b")]).contains(&hypotenuse("a^2 + b^2")));
}
