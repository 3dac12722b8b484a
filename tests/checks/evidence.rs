//! The ways in which a wrong equation could pass, and what stops each.

use onshell::check::Equation;
use onshell::check::Verdict::{Domain, Refuted, Undecided, Unreadable, Verified};
use serde_json::json;

use crate::support::{document, equation, error, numbered, numbers, outcome, pendulum, top, verdict, with};

#[test]
fn hypotheses_that_contradict_each_other_leave_nothing_to_check() {
    let claim = |assume| equation(&numbers(), &["a + b = b + 2a"], json!({ "assume": assume }));
    let contradiction = claim(json!(["a > b", "b > a"]));
    assert_eq!(contradiction.finding.verdict, Undecided);
    assert!(contradiction.finding.message.contains("contradict"), "{}", contradiction.finding.message);
    assert_eq!(claim(json!(["a = -1"])).finding.verdict, Undecided);
    assert_eq!(claim(json!(["a > b"])).finding.verdict, Refuted);
}

#[test]
fn hypotheses_are_solved_together() {
    let claims = json!({ "constants": { "a, b, c, d, f, h": "> 0" } });
    let claim = |latex: &str, assume| verdict(&claims, &[latex], json!({ "assume": assume }));
    let squares = ["a c^2 = b f^2", "a d^2 = b h^2"];
    assert_eq!(claim("c h = d f", squares), Verified);
    assert_eq!(claim("c d = f h", squares), Refuted);
    let cubes = ["a c^3 = b f^3", "a d^3 = b h^3"];
    assert_eq!(claim("c h = d f", cubes), Verified);
    assert_eq!(claim("c h = 2 d f", cubes), Refuted);
}

#[test]
fn a_claim_that_is_its_own_hypothesis_is_not_checked() {
    let claim = |latex: &str| equation(&pendulum(), &[latex], json!({ "assume": r"\dot\theta = 0" })).finding;
    assert_eq!(claim(r"\dot\theta = 0").verdict, Undecided);
    assert_eq!(claim(r"0 = \dot\theta").verdict, Undecided);
    assert_eq!(outcome(&claim(r"T = 0")), Verified);
    assert_eq!(claim(r"U = 0").verdict, Refuted);
}

#[test]
fn a_hypothesis_in_other_words_is_no_result() {
    let claim = |latex: &str| equation(&pendulum(), &[latex], json!({ "assume": r"\dot\theta = 0" })).finding;
    for latex in [r"2\dot\theta = 0", r"\theta \dot\theta = 0", r"-\dot\theta = \dot\theta^2"] {
        let found = claim(latex);
        assert!(found.verdict == Undecided || found.message.contains("hypotheses alone"), "{latex}: {found:?}");
    }
    assert_eq!(outcome(&claim(r"E = U")), Verified);
    assert_eq!(claim(r"2\dot\theta = 1").verdict, Refuted);
}

#[test]
fn a_narrow_range_hides_no_fault() {
    let within = |range: &str| with(&pendulum(), "coordinates", json!({ r"\theta": range }));
    let (right, wrong) = (r"l \ddot\theta = -g \sin\theta", r"l \ddot\theta = -g \sin^2\theta");
    assert_eq!(verdict(&within("(0, \\pi)"), &[right], json!({})), Verified);
    assert_eq!(verdict(&within("(0, \\pi)"), &[wrong], json!({})), Refuted);
    let found = equation(&within("[1.5707, 1.5709]"), &[wrong], json!({}));
    assert!(matches!(found.finding.verdict, Undecided | Refuted), "{:?}", found.finding);
}

#[test]
fn a_range_too_narrow_to_tell_is_no_evidence() {
    let within = |range: &str| with(&pendulum(), "coordinates", json!({ r"\theta": range }));
    for narrow in ["[1.57079, 1.5708]", "[1.570796, 1.570797]", "[1.57079632, 1.57079633]"] {
        let right = equation(&within(narrow), &[r"l \ddot\theta = -g \sin\theta"], json!({})).finding;
        assert_ne!(right.verdict, Refuted, "{narrow}: {}", right.message);
        let wrong = equation(&within(narrow), &[r"l \ddot\theta = -g \sin^2\theta"], json!({})).finding;
        assert!(matches!(wrong.verdict, Undecided | Refuted), "{narrow}: {wrong:?}");
    }
}

#[test]
fn a_condition_hides_no_fault() {
    let wrong = r"l \ddot\theta = -g \sin^2\theta";
    let upright = json!({ "assume": r"\theta = \frac{\pi}{2}" });
    assert_ne!(verdict(&pendulum(), &[wrong], upright), Refuted);
    // It is true there; what it is true under is what the author says.
    assert_eq!(verdict(&pendulum(), &[wrong], json!({ "assume": r"\theta = \frac{\pi}{4}" })), Refuted);
}

#[test]
fn a_large_offset_makes_nothing_equal() {
    let offset = |latex: &str| verdict(&numbers(), &[latex], json!({}));
    assert_eq!(offset("a^2 + 10^3 = 10^3 + a^2"), Verified);
    assert_eq!(offset("a^2 + 10^3 = a^3 + 10^3"), Refuted);
    assert_ne!(offset("a^2 + 10^{12} = a^3 + 10^{12}"), Verified);
    assert_ne!(offset("a^2 + 10^{15} = a^3 + 10^{15}"), Verified);
}

#[test]
fn tiny_numbers_are_no_zeros() {
    assert_eq!(verdict(&numbers(), &["10^{-30} a = 2 \\cdot 10^{-30} a"], json!({})), Refuted);
    assert_eq!(verdict(&numbers(), &["10^{-30} a = a \\cdot 10^{-30}"], json!({})), Verified);
    assert_eq!(verdict(&numbers(), &["10^{-30} a = 0"], json!({})), Refuted);
}

#[test]
fn equal_letters_are_not_drawn_equal() {
    assert_eq!(verdict(&numbers(), &["a + b = 2a"], json!({})), Refuted);
    assert_eq!(verdict(&numbers(), &["ab = b^2"], json!({})), Refuted);
    assert_eq!(verdict(&numbers(), &["a = a + 0"], json!({})), Verified);
}

#[test]
fn defined_on_one_side_only_is_a_verdict_of_its_own() {
    let domain = |latex: &str| verdict(&numbers(), &[latex], json!({}));
    assert_eq!(domain(r"2\ln x = \ln(x^2)"), Domain);
    assert_eq!(domain(r"2\ln a = \ln(a^2)"), Verified);
    assert_eq!(domain(r"3\ln x = \ln(x^2)"), Refuted);
    // Two sides without any value agree on nothing.
    assert_eq!(domain(r"\ln(-1 - a) = \ln(-2 - a)"), Undecided);
}

#[test]
fn both_sides_one_formula_is_no_evidence() {
    let defined = with(&numbers(), "define", json!({ "f": "a + b" }));
    let copied = equation(&defined, &["f = a + b"], json!({}));
    assert!(copied.finding.message.contains("by definition"), "{:?}", copied.finding);
    assert!(!copied.finding.verdict.holds());
    assert_eq!(verdict(&defined, &["f^2 = a^2 + 2ab + b^2"], json!({})), Verified);
    assert_eq!(verdict(&defined, &["f = a - b"], json!({})), Refuted);
}

#[test]
fn a_definition_that_nothing_stands_on_is_no_pass() {
    assert_eq!(verdict(&numbers(), &["s = a + b"], json!({})), Undecided);
    // In its square the sign of s goes unnoticed, and the verdict says so; a factor in s² = s·s is not noticed at all.
    let notes = numbered(&["s = a + b", "s^2 = a^2 + 2ab + b^2"]);
    let found = document(&numbers(), &notes, &Default::default(), None).unwrap();
    assert!(found.equations[0].finding.message.contains("except a wrong sign"), "{:?}", found.equations[0]);
    let notes = numbered(&["s = a + b", "s s = s^2"]);
    let found = document(&numbers(), &notes, &Default::default(), None).unwrap();
    assert_eq!(found.equations[0].finding.verdict, Undecided);
    let notes = numbered(&["s = a + b", "s(a - b) = a^2 - b^2"]);
    let found = document(&numbers(), &notes, &Default::default(), None).unwrap();
    assert!(found.equations.iter().all(|equation| equation.ok), "{:?}", found.equations);
    let wrong = numbered(&["s = a - b", "s^2 = a^2 + 2ab + b^2"]);
    let found = document(&numbers(), &wrong, &Default::default(), None).unwrap();
    assert_eq!(found.equations[1].finding.verdict, Refuted);
}

#[test]
fn a_counterexample_is_one() {
    let found = equation(&numbers(), &["(a + b)^2 = a^2 + ab + b^2"], json!({})).finding.counterexample.unwrap();
    let value = |name: &str| found.state.iter().find(|(known, _)| known == name).unwrap().1;
    let (a, b) = (value("a"), value("b"));
    assert!((found.lhs - (a + b).powi(2)).abs() < 1e-12 * found.lhs);
    assert!((found.rhs - (a * a + a * b + b * b)).abs() < 1e-12 * found.rhs);
}

/// Whether the message names a change with which the equation holds, or else an edit of the text is suggested.
fn is_told_once(found: &Equation) -> bool {
    found.finding.message.contains("it would hold with “") == found.repairs.is_empty()
}

#[test]
fn the_message_says_what_would_be_true() {
    let found = equation(&pendulum(), &[r"l \ddot\theta - g \sin\theta = 0"], json!({}));
    assert!(is_told_once(&found), "{}", found.finding.message);
    let hopeless = equation(&pendulum(), &[r"l \ddot\theta = g^3 \tan\theta + l^5"], json!({}));
    assert!(!hopeless.finding.message.contains("it would hold with"), "{}", hopeless.finding.message);
    assert!(!is_told_once(&hopeless), "{}", hopeless.finding.message);
}

#[test]
fn the_sign_before_all_of_a_side_is_a_sign_too() {
    let found = equation(&pendulum(), &[r"l \ddot\theta = g \sin\theta"], json!({}));
    assert!(is_told_once(&found), "{}", found.finding.message);
    let square = equation(&pendulum(), &[r"-2mT = m^2 l^2 \dot\theta^2"], json!({}));
    assert!(is_told_once(&square), "{}", square.finding.message);
}

#[test]
fn an_undeclared_symbol_is_refused_with_the_nearest_one() {
    let claims = with(&numbers(), "constants", json!({ r"\omega_0, \lambda_1": "> 0", "a": "any" }));
    let found = equation(&claims, &[r"a \omega_0 = \omega_1 a"], json!({}));
    assert_eq!(found.finding.verdict, Unreadable);
    assert!(found.finding.message.contains(r"did you mean \omega_0?"), "{}", found.finding.message);
    let dots = equation(&claims, &[r"a = \lambda_1 \Lambda_1"], json!({}));
    assert!(dots.finding.message.contains(r"did you mean \lambda_1?"), "{}", dots.finding.message);
    assert_eq!(verdict(&claims, &[r"a \omega_0 = \omega_0 a \cdot 1"], json!({})), Verified);
    let claimed = error(&claims, &[r"a \omega_0 = \omega_0 a \cdot 1"], json!({ "assume": r"\omgea_0 > 1" }));
    assert!(claimed.contains("claims.json:"), "{claimed}");
}

#[test]
fn what_is_not_understood_is_refused_and_never_passed_over() {
    for latex in [r"a/bc = \frac{a}{bc}", r"\sin a b = \sin(ab)", r"a = \foo", r"\int a = b", r"a = b + \text{small}"] {
        assert_eq!(verdict(&numbers(), &[latex], json!({})), Unreadable, "{latex}");
    }
    assert_eq!(verdict(&numbers(), &["a b"], json!({})), Unreadable);
    assert_eq!(verdict(&numbers(), &[r"\sin(ab) = \sin(b a)"], json!({})), Verified);
}

#[test]
fn without_a_claim_an_unnumbered_display_is_left_alone_and_a_numbered_one_is_not() {
    let notes = "$$ a = b $$\n\n$$ a = b \\tag{1} $$\n";
    let found = document(&numbers(), notes, &Default::default(), None).unwrap();
    assert_eq!(found.equations.len(), 1);
    assert_eq!(found.equations[0].finding.verdict, Refuted);
}

#[test]
fn what_is_always_zero_has_no_rate_to_speak_of() {
    let claims = json!({
        "constants": { "m, k": "> 0" },
        "varies with time": { r"\vec r": "any" },
        "laws": { "spring": "1" },
    });
    let spring = r"m \ddot{\vec r} = -k \vec r";
    let verdicts = |displays: &[&str]| {
        let found = document(&claims, &numbered(displays), &Default::default(), None).unwrap();
        found.equations.iter().map(|equation| outcome(&equation.finding)).collect::<Vec<_>>()
    };
    assert_eq!(verdicts(&[spring, r"\frac{d}{dt} (m \vec r \times \dot{\vec r}) = \vec 0"])[1], Verified);
    assert_eq!(verdicts(&[spring, r"\frac{d}{dt} (m \vec r \times \vec r) = \vec 0"])[1], Undecided);
    assert_eq!(verdicts(&[spring, r"\frac{d}{dt} (m \vec r \times \ddot{\vec r}) = \vec 0"])[1], Verified);
    // A definition of what is always zero is no definition.
    let defined = |formula: &str| verdicts(&[spring, &format!(r"Q = {formula}"), r"\dot Q = 0"])[1..].to_vec();
    assert_eq!(defined(r"\vec r \cdot \dot{\vec r} - \dot{\vec r} \cdot \vec r"), [Undecided; 2]);
    assert_eq!(defined(r"m \dot{\vec r} \cdot \dot{\vec r} + k \vec r \cdot \vec r")[1], Verified);
}

#[test]
fn where_no_motion_obeys_the_hypotheses_no_other_state_refutes() {
    let at_rest =
        |latex: &str| verdict(&top(), &[latex], json!({ "throughout": [r"\dot\theta = 0", r"\dot\phi = 0"] }));
    assert_eq!(at_rest(r"\lambda_1 \ddot\theta = 5 MgR \sin\theta"), Undecided);
    let steady = |latex: &str| verdict(&top(), &[latex], json!({ "throughout": r"\dot\theta = 0" }));
    assert_eq!(steady(r"\lambda_1 \dot\phi^2 \cos\theta - p_\psi \dot\phi + MgR = 0"), Verified);
    assert_eq!(steady(r"\lambda_1 \dot\phi^2 \cos\theta + p_\psi \dot\phi + MgR = 0"), Refuted);
}

#[test]
fn a_claim_that_has_no_value_anywhere_leaves_the_others_alone() {
    let claims = json!({
        "system": "relativistic_particle",
        "coordinates": { "x": "any" },
        "means": { "E": "energy" },
        "constants": { "m, c, k": "> 0" },
    });
    let displays = [r"|\dot x| < c", r"E = \frac{mc^2}{\sqrt{1 - \dot x^2/c^2}} + \frac12 k x^2"];
    let found = document(&claims, &numbered(&displays), &onshell::systems::Registry::standard(), None).unwrap();
    assert!(found.equations[1].finding.verdict.holds(), "{:?}", found.equations[1]);
    assert!(!found.equations[0].ok);
}

#[test]
fn a_row_that_goes_on_after_a_wide_space_goes_on() {
    let rows = |second: &str| format!(r"\begin{{split}} (a + b)^2 &= a^2 + 2ab \\ {second} \end{{split}}");
    for goes_on in [r"&\quad + b^2", r"&\qquad{} + b^2", r"& \quad + b^2", "& + b^2"] {
        assert_eq!(verdict(&numbers(), &[&rows(goes_on)], json!({})), Verified, "{goes_on}");
    }
    assert_eq!(verdict(&numbers(), &[&rows(r"&\quad - b^2")], json!({})), Refuted);
    let times = r"\begin{split} c a b &= a b \\ &\quad \times c \end{split}";
    assert_eq!(verdict(&numbers(), &[times], json!({})), Verified);
    assert_eq!(verdict(&numbers(), &[r"a + b = b + a \qquad a b = b a \qquad a = b"], json!({})), Refuted);
}

#[test]
fn zero_on_shell_tells_no_factor() {
    let claim = |latex: &str| verdict(&pendulum(), &[latex], json!({}));
    assert_eq!(claim(r"\dot E = m l^2 \dot\theta (\ddot\theta + \frac{g}{l} \sin\theta)"), Verified);
    assert_eq!(claim(r"\dot E = 5 m (l \ddot\theta + g \sin\theta)"), Undecided);
    assert_eq!(claim(r"\dot E = m l \dot\theta (\ddot\theta + \frac{g}{l} \sin\theta)"), Undecided);
    assert_eq!(claim(r"\dot E = 0"), Verified);
}

#[test]
fn what_where_says_in_another_order_is_no_evidence() {
    let claims = with(&pendulum(), "varies with time", json!({ "a": "any" }));
    let meant =
        |latex: &str, name: &str, formula: &str| verdict(&claims, &[latex], json!({ "where": { name: formula } }));
    assert_eq!(meant(r"E = mgl\cos\theta", "E", r"m l g \cos\theta"), Undecided);
    assert_eq!(meant("E = 2U", "U", r"\frac{E}{2}"), Undecided);
    assert_eq!(meant(r"E - mgl\cos\theta = 0", "E", r"\cos\theta m g l"), Undecided);
    assert_eq!(meant(r"\dot E = -mgl\dot\theta\sin\theta", "E", r"m l g \cos\theta"), Undecided);
    // The twins: what stands on the motion, and what is false.
    assert_eq!(meant("E = T + a", "a", "U"), Verified);
    assert_eq!(meant(r"E = 2mgl\cos\theta", "E", r"m l g \cos\theta"), Refuted);
}

#[test]
fn what_is_constant_holds_what_it_is_made_of() {
    let claims = json!({
        "constants": { "m, k": "> 0" },
        "varies with time": { "x": "any" },
        "laws": { "Hooke": r"m \ddot x = - k x" },
    });
    let of = |energy: &str| {
        let notes = numbered(&[energy, r"\frac12 m \dot x^2 + U = \text{const}"]);
        document(&claims, &notes, &Default::default(), None).unwrap().equations
    };
    let found = of(r"U = \frac12 k x^2");
    assert!(found.iter().all(|equation| equation.ok), "{found:?}");
    assert!(found[0].finding.message.contains("would contradict (2)"), "{:?}", found[0]);
    // The twins: a slip; and a term that no rate notices.
    assert!(!of(r"U = k x^2")[1].ok);
    let free = of(r"U = \frac12 k x^2 - \frac12 k m^2");
    assert_eq!(free[0].finding.verdict, Undecided, "{:?}", free[0]);
}

#[test]
fn what_is_known_of_a_name_is_only_that_it_is_constant() {
    let of = |displays: &[&str]| {
        let found = document(&pendulum(), &numbered(displays), &Default::default(), None).unwrap();
        found.equations.into_iter().next().unwrap().finding
    };
    let open = "no other equation tests K, so a wrong factor in it would pass";
    let energy = r"K = \frac12 l^2 \dot\theta^2 - gl\cos\theta = \text{const}";
    let found = of(&[energy]);
    assert!(found.verdict.passes() && found.message.ends_with(open), "{found:?}");
    // The twins: what is used elsewhere is known, and what varies is not constant.
    let used = of(&[energy, r"mK = \frac12 m l^2 \dot\theta^2 - mgl\cos\theta"]);
    assert!(used.verdict.passes() && !used.message.contains(open), "{used:?}");
    let varying = of(&[r"K = l^2 \dot\theta^2 - gl\cos\theta = \text{const}"]);
    assert!(varying.verdict == Refuted && varying.message.contains(" is not constant: d/dt("), "{varying:?}");
}

#[test]
fn what_one_part_of_a_display_leaves_open_is_said_of_the_display() {
    let line = |display: &str| {
        let notes = numbered(&[display, "s^2 = a^2 + 2ab + b^2", "p (a + b) = a^2 b + a b^2"]);
        let found = document(&numbers(), &notes, &Default::default(), None).unwrap();
        let report = onshell::check::Report::new(vec![found]);
        onshell::report::text::report(&report, true, onshell::report::Style::new(300, false))
    };
    let says = "no other equation checks the sign of a definition in it";
    let open = line(r"(a - b)^2 = a^2 - 2ab + b^2 , \quad p = ab , \quad s = a + b");
    assert!(open.contains("(3 parts)") && open.contains(says), "{open}");
    // The twin: alone it says so itself.
    let alone = line(r"s = a + b , \quad p = ab");
    assert!(alone.contains("except a wrong sign") && !alone.contains(says), "{alone}");
}

#[test]
fn a_name_for_a_moving_combination_is_tested_by_a_linear_equation_except_for_its_factor() {
    let claims = json!({
        "coordinates": { "x": "any" }, "constants": { r"m, k, \gamma": "> 0" }, "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = e^{\gamma t}\left(\frac12 m\dot x^2 - \frac12 k x^2\right)";
    let of = |definition: &str| {
        let linear = r"\ddot q + \left(\frac km - \frac{\gamma^2}{4}\right) q = 0";
        document(&claims, &numbered(&[lagrangian, definition, linear]), &Default::default(), None).unwrap()
    };
    let found = of(r"q = x\, e^{\gamma t/2}");
    assert!(found.equations.iter().all(|equation| equation.ok), "{:?}", found.equations[1].finding);
    assert!(found.equations[1].finding.message.contains("a wrong factor"), "{:?}", found.equations[1].finding);
    // The twins: a slip in it, and a name of one thing that moves, of which the factor is all.
    assert_eq!(of(r"q = x\, e^{\gamma t}").equations[2].finding.verdict, Refuted);
    let harmonic = r"L = \frac12 m\dot x^2 - \frac12 k x^2";
    let notes = numbered(&[harmonic, r"q = \gamma x", r"m\ddot q + k q = 0"]);
    let found = document(&claims, &notes, &Default::default(), None).unwrap();
    assert_eq!(found.equations[1].finding.verdict, Undecided);
}
