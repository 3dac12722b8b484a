//! Notes as they are written: the Lagrangian in a sentence, names that only the prose defines, conditions on what is derived.

use serde_json::{Value, json};

use crate::support::Desk;

/// The report on notes with prose.
fn report(name: &str, claims: &Value, notes: &str) -> Value {
    let desk = Desk::new(&format!("prose-{name}"));
    desk.write("notes.md", notes);
    let mut claims = claims.clone();
    claims["notes"] = json!("notes.md");
    desk.write("notes.json", format!("{claims:#}"));
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err))
}

/// The verdicts on notes with prose, `passes` for certified and verified.
fn verdicts(name: &str, claims: &Value, notes: &str) -> Vec<String> {
    let report = report(name, claims, notes);
    let equations = report["documents"][0]["equations"].as_array().cloned().unwrap_or_default();
    let verdict = |equation: &Value| match equation["verdict"].as_str().expect("a word") {
        "certified" | "verified" => "passes".to_owned(),
        other => other.to_owned(),
    };
    equations.iter().map(verdict).collect()
}

/// The verdict on a line that is expected to be refuted, so that no corrections are sought.
fn refused(name: &str, claims: &Value, notes: &str, id: &str) -> String {
    let mut claims = claims.clone();
    claims["equations"][id] = json!({ "expect": "refuted", "because": "a slip" });
    verdicts(name, &claims, notes)[id.parse::<usize>().expect("a number") - 1].clone()
}

fn spring() -> Value {
    json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian", "T": "kinetic energy", "V": "potential energy" },
    })
}

const ENERGIES: &str = r"$$ T = \frac12 m \dot x^2 \tag{1} $$

$$ V = \frac12 k x^2 \tag{2} $$

";

#[test]
fn a_lagrangian_in_a_sentence_is_the_system() {
    let notes = |said: &str, motion: &str| format!("{ENERGIES}{said}\n\n$$ {motion} \\tag{{3}} $$\n");
    for said in ["The Lagrangian $L = T - V$ gives", "With \\(L = T - V\\) we find", "Hence"] {
        assert_eq!(verdicts("said", &spring(), &notes(said, r"m \ddot x = - k x"))[2], "passes", "{said}");
        assert_eq!(verdicts("slip", &spring(), &notes(said, r"m \ddot x = k x"))[2], "refuted", "{said}");
    }
    // What the sentence says is taken, not what it should say.
    assert_eq!(verdicts("wrong", &spring(), &notes("With $L = T + V$", r"m \ddot x = - k x"))[2], "refuted");
    // A display that defines L is not overruled by the prose.
    let both =
        format!("{ENERGIES}With $L = T + V$\n\n$$ L = T - V \\tag{{3}} $$\n\n$$ m \\ddot x = - k x \\tag{{4}} $$\n");
    assert_eq!(verdicts("both", &spring(), &both)[3], "passes");
}

#[test]
fn a_sentence_defines_a_name_that_nothing_else_defines() {
    let notes = |said: &str| format!("{ENERGIES}and $L = T - V$. {said}\n\n$$ x(t) = A \\cos\\nu t \\tag{{3}} $$\n");
    assert_eq!(verdicts("nu", &spring(), &notes(r"A solution is, with $\nu = \sqrt{k/m}$,"))[2], "passes");
    assert_eq!(verdicts("nu", &spring(), &notes(r"A solution is, with $\nu = \sqrt{m/k}$,"))[2], "refuted");
    // A condition defines nothing, two formulas for one name neither, and a number is a special case.
    for said in [r"If $\nu = \sqrt{k/m}$,", r"Put $\nu = \sqrt{k/m}$, then $\nu = k/m$,", r"With $\nu = 3$,"] {
        assert_eq!(verdicts("no", &spring(), &notes(said))[2], "unreadable", "{said}");
    }
}

#[test]
fn an_index_runs_over_the_coordinates_of_its_name() {
    let claims = json!({
        "coordinates": { "q_1, q_2": "any" },
        "constants": { "m, R": "> 0", "M": "(0, m)" },
        "means": { "L": "Lagrangian", "F": "dissipation function" },
    });
    let notes = |sign: &str| {
        format!(
            r"$$ L = \frac12 m (\dot q_1^2 + \dot q_2^2) + M \dot q_1 \dot q_2 - q_1^2 \tag{{1}} $$

$$ F = \frac12 R (\dot q_1^2 + \dot q_2^2) \tag{{2}} $$

$$ \frac{{d}}{{dt}} \frac{{\partial L}}{{\partial\dot q_i}} - \frac{{\partial L}}{{\partial q_i}} = {sign} \frac{{\partial F}}{{\partial\dot q_i}} \tag{{3}} $$

$$ \sqrt{{(m - M)^2}} = m - M \tag{{4}} $$

$$ m \ddot q_2 + M \ddot q_1 + R \dot q_2 = 0 \tag{{5}} $$
"
        )
    };
    assert_eq!(verdicts("index", &claims, &notes("-")), ["definition", "definition", "passes", "passes", "passes"]);
    assert_eq!(verdicts("index", &claims, &notes("+"))[2], "refuted");
    // Without the end of the range the root may be M − m.
    let wide = json!({
        "coordinates": claims["coordinates"], "constants": { "m, M, R": "> 0" }, "means": claims["means"],
    });
    assert_eq!(verdicts("wide", &wide, &notes("-"))[3], "refuted");
}

#[test]
fn a_relativistic_motion_has_its_solution_and_its_orbit() {
    let claims = json!({
        "coordinates": { "x, y": "any" },
        "constants": { "m, c, F, p_0": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let notes = |inverse: &str, function: &str| {
        format!(
            r"$$ L = - m c^2 \sqrt{{1 - \frac{{\dot x^2 + \dot y^2}}{{c^2}}}} + F x \tag{{1}} $$

Put $E_0 = \sqrt{{m^2 c^4 + p_0^2 c^2}}$. Then

$$ x = \frac1F \sqrt{{E_0^2 + c^2 F^2 t^2}} \tag{{2}} $$

$$ y = \frac{{p_0 c}}{{F}} \operatorname{{{inverse}}} \frac{{c F t}}{{E_0}} \tag{{3}} $$

$$ x = \frac{{E_0}}{{F}} \{function} \frac{{F y}}{{p_0 c}} \tag{{4}} $$
"
        )
    };
    assert_eq!(verdicts("relativistic", &claims, &notes("arsinh", "cosh"))[1..], ["passes", "passes", "passes"]);
    assert_eq!(refused("hyperbola", &claims, &notes("arsinh", "sinh"), "4"), "refuted");
}

#[test]
fn a_root_of_a_square_may_mean_a_positive_momentum() {
    let claims = json!({
        "coordinates": { "r": "> 0", "\\theta": "angle" },
        "constants": { "m, M, g": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let notes = |sign: &str| {
        format!(
            r"$$ L = \frac12 (m + M) \dot r^2 + \frac12 m r^2 \dot\theta^2 - M g r \tag{{1}} $$

$$ h = m r^2 \dot\theta = \text{{const}} \tag{{2}} $$

$$ r_0 = \left( \frac{{h^2}}{{m M g}} \right)^{{1/3}} \tag{{3}} $$

$$ \Omega = {sign} \frac{{h}}{{m r_0^2}} = \sqrt{{\frac{{M g}}{{m r_0}}}} \tag{{4}} $$
"
        )
    };
    assert_eq!(verdicts("positive", &claims, &notes(""))[3], "passes");
    assert_eq!(refused("negative", &claims, &notes("-"), "4"), "refuted");
    assert_eq!(refused("double", &claims, &notes("2"), "4"), "refuted");
}

#[test]
fn a_claim_says_nothing_where_a_quantity_that_it_names_does_not_exist() {
    let notes = |number: &str| {
        format!(
            r"{ENERGIES}and $L = T - V$. With the energy

$$ E = T + V = \text{{const}} \tag{{3}} $$

we define

$$ J = \sqrt{{k - E}} \tag{{4}} $$

so that

$$ E = k - {number} J^2 \tag{{5}} $$
"
        )
    };
    assert_eq!(verdicts("exists", &spring(), &notes(""))[4], "passes");
    assert_eq!(verdicts("exists", &spring(), &notes("2"))[4], "refuted");
}

#[test]
fn what_holds_while_a_coordinate_stays_is_not_called_wrong() {
    let claims = json!({
        "coordinates": { "\\theta": "(0, \\pi)", "\\phi": "angle" },
        "constants": { "m, l, g": "> 0", "\\theta_0": "(0, \\pi/2)" },
        "means": { "L": "Lagrangian" },
        "equations": { "2": { "assume": "\\theta = \\theta_0" } },
    });
    let notes = |power: &str| {
        format!(
            r"$$ L = \frac12 m l^2 (\dot\theta^2 + \sin^2\theta \, \dot\phi^2) + m g l \cos\theta \tag{{1}} $$

On the cone

$$ \dot\phi^2 = \frac{{g}}{{l \cos{power}\theta_0}} \tag{{2}} $$
"
        )
    };
    // It fails at an instant at which θ = θ_0, and holds while θ stays there.
    assert_eq!(verdicts("cone", &claims, &notes(""))[1], "passes");
    assert_eq!(verdicts("cone", &claims, &notes("^2"))[1], "refuted");
}

#[test]
fn the_energy_at_a_start_gives_the_rate() {
    let claims = json!({
        "coordinates": { "x": "any" },
        "constants": { "m, k, a": "> 0" },
        "means": { "L": "Lagrangian" },
        "equations": { "3": { "assume": "E = \\frac12 k a^2" }, "4": { "assume": "E = \\frac12 k a^2" } },
    });
    let notes = |last: &str| {
        format!(
            r"$$ L = \frac12 m \dot x^2 - \frac12 k x^2 \tag{{1}} $$

$$ E = \frac12 m \dot x^2 + \frac12 k x^2 = \text{{const}} \tag{{2}} $$

$$ \dot x^2 = \frac km (a^2 {last} x^2) \tag{{3}} $$

$$ \frac12 m \dot x^2 + \frac12 k x^2 = \frac12 k a^2 \tag{{4}} $$
"
        )
    };
    // The last one is the hypothesis itself.
    assert_eq!(verdicts("start", &claims, &notes("-"))[2..], ["passes", "undecided"]);
    assert_eq!(verdicts("start", &claims, &notes("+"))[2], "refuted");
}

#[test]
fn a_slip_in_a_part_of_the_lagrangian_is_corrected_there() {
    let notes = |inertia: &str| {
        format!(
            r"$$ T = \frac12 m \dot x^2 + \frac12 I \omega^2, \qquad I = {inertia} M R^2, \qquad \omega = \frac{{\dot x}}{{R}} \tag{{1}} $$

$$ V = \frac12 k x^2 \tag{{2}} $$

$$ L = T - V \tag{{3}} $$

$$ p = \frac{{\partial L}}{{\partial\dot x}} = \left( m + \frac M2 \right) \dot x \tag{{4}} $$

$$ \left( m + \frac12 M \right) \ddot x = - k x \tag{{5}} $$

$$ \dot V = k x \dot x \tag{{6}} $$

$$ \frac{{d}}{{dt}} \frac{{\partial L}}{{\partial\dot x}} = - k x \tag{{7}} $$
"
        )
    };
    let claims = json!({
        "coordinates": { "x": "any" },
        "constants": { "m, M, R, k": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    assert_eq!(verdicts("inertia", &claims, &notes("\\frac12"))[3..], ["passes"; 4]);
    let report = report("inertia", &claims, &notes(""));
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    for at in [3, 4] {
        assert_eq!(equations[at]["verdict"], "refuted");
        let first = &equations[at]["repairs"][0];
        assert_eq!((first["of"].as_str(), &first["mends"]), (Some("1"), &json!(["4", "5"])), "{first}");
        assert_eq!(first["replacement"], r"\frac12 \, ");
    }
    // Two slips of their own are corrected where they are.
    let two = notes("\\frac12")
        .replace("\\left( m + \\frac M2", "\\left( m - \\frac M2")
        .replace("= - k x \\tag{5}", "= k x \\tag{5}");
    let report = self::report("two", &claims, &two);
    for at in [3, 4] {
        let first = &report["documents"][0]["equations"][at]["repairs"][0];
        assert!(first["of"].is_null(), "{first}");
    }
}

#[test]
fn inverse_hyperbolic_functions_are_read_and_other_words_are_no_constants() {
    let claims = json!({ "coordinates": { "x": "any" }, "constants": { "a": "(0, 1)", "k": "> 0" }, "means": { "L": "Lagrangian" } });
    let notes = r"$$ L = \frac12 \dot x^2 - \frac12 k x^2 \tag{1} $$

$$ \sinh(\operatorname{arsinh} a) = a \tag{2} $$

$$ \tanh(\operatorname{artanh} a) = a \tag{3} $$

$$ \cosh(\operatorname{arcosh}(1 + a)) = 1 + a \tag{4} $$

$$ x(t) = \operatorname{argsh} \cos(\sqrt k t) \tag{5} $$
";
    assert_eq!(verdicts("inverse", &claims, notes)[1..], ["passes", "passes", "passes", "unreadable"]);
    let wrong = notes.replace("\\tanh(\\operatorname{artanh} a)", "\\tanh(\\operatorname{arsinh} a)");
    assert_eq!(refused("wrong", &claims, &wrong, "3"), "refuted");
}

#[test]
fn a_sentence_defines_a_name_by_its_square_or_a_multiple_of_it() {
    let notes = |said: &str, law: &str| format!("{ENERGIES}and $L = T - V$. Or, {said},\n\n$$ {law} \\tag{{3}} $$\n");
    let law = r"\ddot x = -\omega^2 x";
    assert_eq!(verdicts("square", &spring(), &notes(r"with $\omega^2 = k/m$", law))[2], "passes");
    assert_eq!(refused("square-slip", &spring(), &notes(r"with $\omega^2 = m/k$", law), "3"), "refuted");
    let law = r"\ddot x = -4\gamma x";
    assert_eq!(verdicts("multiple", &spring(), &notes(r"with $4\gamma = k/m$", law))[2], "passes");
    assert_eq!(refused("multiple-slip", &spring(), &notes(r"with $2\gamma = k/m$", law), "3"), "refuted");
    // The report says what was taken.
    let report = report("said", &spring(), &notes(r"with $\omega^2 = k/m$", r"\ddot x = -\omega^2 x"));
    assert!(report["documents"][0]["inferred"].to_string().contains("ω^2 = k/m, as line"), "{report}");
    // A declaration is never overruled, and a condition defines nothing.
    let mut declared = spring();
    declared["constants"] = json!({ "m, k, \\omega": "> 0" });
    let law = r"\ddot x = -\omega^2 x";
    assert_eq!(refused("declared", &declared, &notes(r"with $\omega^2 = k/m$", law), "3"), "refuted");
    // After "if" it may be a case: the display passes with it, and a slip is not refuted.
    assert_eq!(verdicts("condition", &spring(), &notes(r"if $\omega^2 = k/m$", law))[2], "passes");
    assert_eq!(verdicts("condition-slip", &spring(), &notes(r"if $\omega^2 = m/k$", law))[2], "unreadable");
}

#[test]
fn a_meaning_of_the_system_takes_the_coordinate_in_parentheses() {
    let claims = json!({
        "coordinates": { "r": "> 0", "\\phi": "angle" },
        "constants": { "m, k": "> 0" },
        "means": { "L": "Lagrangian", "V_{\\text{eff}}": "effective potential" },
    });
    let notes = |potential: &str| {
        format!(
            "$$ L = \\frac12 m (\\dot r^2 + r^2 \\dot\\phi^2) - \\frac12 k r^2 \\tag{{1}} $$\n\n$$ {potential} \\tag{{2}} $$\n"
        )
    };
    let potential = r"V_{\text{eff}}(r) = \frac{p_\phi^2}{2 m r^2} + \frac12 k r^2";
    assert_eq!(verdicts("effective", &claims, &notes(potential))[1], "passes");
    assert_eq!(refused("effective-slip", &claims, &notes(&potential.replace("+", "-")), "2"), "refuted");
    // A constant is a factor as before.
    assert_eq!(verdicts("factor", &claims, &notes(r"k(r) = k r"))[1], "unreadable");
}
