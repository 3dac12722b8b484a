//! `derive`: what follows from a Lagrangian, typeset.

use crate::support::Desk;

#[test]
fn what_is_derived_can_be_read_again() {
    let desk = Desk::new("derive");
    let run = desk.onshell(&["derive", "heavy_top", "--as", "hamiltonian", "--format", "latex"]);
    assert_eq!((run.code, run.err.as_str(), run.out.lines().count()), (0, "", 1), "{}", run.out);
    let read = desk.onshell(&["read", run.out.trim()]);
    let text = desk.onshell(&["derive", "heavy_top", "--as", "hamiltonian"]);
    assert_eq!(read.out.lines().next(), text.out.lines().next());
    // (6.77) of the notes is equal to it, and with a flipped sign is not
    let derived = run.out.trim().split_once(" = ").expect("an equation").1.to_owned();
    let notes = |sign: &str| {
        format!(
            r"\frac{{p_\theta^2}}{{2\lambda_1}} + \frac{{p_\psi^2}}{{2\lambda_3}} + \frac{{(p_\phi {sign} p_\psi \cos\theta)^2}}{{2\lambda_1 \sin^2\theta}} + MgR \cos(\theta)"
        )
    };
    assert_eq!(desk.onshell(&["equal", &derived, &notes("-")]).code, 0);
    assert_eq!(desk.onshell(&["equal", &derived, &notes("+")]).code, 1);
}

#[test]
fn without_a_quantity_it_is_the_lagrangian_the_momenta_and_the_equations_of_motion() {
    let desk = Desk::new("derive-json");
    let json = desk.onshell(&["derive", "kepler", "--format", "json"]).json();
    assert_eq!(json["system"], "kepler");
    assert_eq!(json["coordinates"], serde_json::json!(["r", "\\phi"]));
    assert_eq!(json["parameters"], serde_json::json!(["m", "M", "G"]));
    let names: Vec<&str> = json["equations"].as_array().unwrap().iter().filter_map(|e| e["name"].as_str()).collect();
    assert_eq!(
        names,
        ["Lagrangian", "momentum of r", "momentum of φ", "equation of motion of r", "equation of motion of φ"]
    );
    assert_eq!(json["equations"][1]["text"], "p_r = m·r\u{307}");
    assert_eq!(json["equations"][1]["latex"], r"p_r = m \, \dot{r}");
}

#[test]
fn what_cannot_be_derived_is_said_with_what_to_do() {
    let desk = Desk::new("derive-refused");
    for (arguments, words) in [
        (vec!["derive", "heavy_tpo"], ["heavy_tpo", "did you mean heavy_top?"]),
        (vec!["derive", "quark"], ["quark", "kepler"]),
        (vec!["derive", "relativistic_particle", "--as", "hamiltonian"], ["not quadratic", "energy"]),
        (vec!["derive", "kepler", "--as", "hamiltonain"], ["hamiltonain", "hamiltonian"]),
        (vec!["derive"], ["SYSTEM", "Usage"]),
    ] {
        let run = desk.onshell(&arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}: {}", run.err);
        assert!(words.iter().all(|word| run.err.contains(word)), "{arguments:?}: {}", run.err);
    }
}

#[test]
fn as_rust_it_is_the_source_of_the_accelerations_and_of_nothing_else() {
    let desk = Desk::new("derive-rust");
    let source = desk.onshell(&["derive", "heavy_top", "--format", "rust"]);
    assert_eq!(source.code, 0, "{}", source.err);
    // `tests/mechanics/source.rs` compiles this source and runs it
    let system = onshell::systems::Registry::standard();
    assert_eq!(source.out, system.get("heavy_top").unwrap().trace().unwrap().rust_source());
    let same = desk.onshell(&["derive", "heavy_top", "--as", "accelerations", "--format", "rust"]);
    assert_eq!(same.out, source.out);
    let refused = desk.onshell(&["derive", "heavy_top", "--as", "momenta", "--format", "rust"]);
    assert_eq!((refused.code, refused.out.as_str()), (2, ""));
    assert!(refused.err.contains("leave out --as"), "{}", refused.err);
}

#[test]
fn the_steps_are_notes_that_check_themselves() {
    let desk = Desk::new("derive-steps");
    let json = desk.onshell(&["derive", "simple_pendulum", "--steps", "--format", "json"]).json();
    let (notes, claims) = (json["notes"].as_str().unwrap(), json["claims"].as_str().unwrap());
    desk.write("lecture.md", notes);
    desk.write("lecture.json", claims);
    assert_eq!(desk.onshell(&["check", "lecture.md"]).code, 0);
    // must-fail case: the same notes with a slip
    desk.write("lecture.md", notes.replace("p_\\theta^{2}", "p_\\theta^{3}"));
    assert_eq!(desk.onshell(&["check", "lecture.md"]).code, 1);
    let text = desk.onshell(&["derive", "simple_pendulum", "--steps"]);
    let lines = [
        "x = l·sin(θ)",
        "T = (1/2)·m·(x\u{307}^2 + y\u{307}^2)",
        "d/dt(∂L/∂θ\u{307}) = m·l^2·θ\u{308}",
        "m·l^2·θ\u{308} = −m·l·g·sin(θ)",
    ];
    for line in lines {
        assert!(text.out.contains(line), "{line}");
    }
    let page = desk.onshell(&["derive", "simple_pendulum", "--steps", "--format", "html"]).out;
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("<math") && !page.contains("class=\"untypeset\""));
}

#[test]
fn steps_of_another_seed_have_other_values_and_the_same_lines() {
    let desk = Desk::new("derive-seed");
    let json = |seed: &str| desk.onshell(&["derive", "kepler", "--steps", "--format", "json", "--seed", seed]).json();
    let (one, again, two) = (json("1"), json("1"), json("2"));
    assert_eq!(one, again);
    assert_eq!(one["notes"], two["notes"]);
    assert_ne!(one["steps"], two["steps"]);
}

/// A bead on a hoop that turns; the sign of the second term of (2) is `sign`.
fn bead(sign: &str) -> String {
    format!(
        "# A bead\n\nThe Lagrangian is\n\n$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\Omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{{1}} $$\n\n\
         $$ m R^2 \\ddot\\theta = m R^2 \\Omega^2 \\sin\\theta\\cos\\theta {sign} m g R \\sin\\theta \\tag{{2}} $$\n"
    )
}

#[test]
fn what_follows_from_the_lagrangian_of_notes_is_derived_and_drawn() {
    let desk = Desk::new("derive-notes");
    desk.write("bead.md", bead("-"));
    let run = desk.onshell(&["derive", "bead.md"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("R^2·m·θ\u{308} = R^2·Ω^2·m·sin(θ)·cos(θ) − R·g·m·sin(θ)"), "{}", run.out);
    let steps = desk.onshell(&["derive", "bead.md", "--steps"]);
    assert_eq!(steps.code, 0, "{}", steps.err);
    assert!(steps.out.contains("7 certified"), "{}", steps.out);
    // With gravity as strong as the hoop turns fast, θ swings as the energy allows: from 0.9 to −0.9.
    let drawn = desk.onshell(&["plot", "bead.md", "--as", "potential"]);
    assert!(drawn.out.contains("Turning points of the bead: θ = -0.9000, 0.9000"), "{}", drawn.err);
    // must-fail cases: no Lagrangian, a function without a formula, and no such notes
    desk.write("plain.md", "$$ (a+b)^2 = a^2 + 2ab + b^2 $$\n");
    let none = desk.onshell(&["derive", "plain.md"]);
    assert_eq!(none.code, 2);
    assert!(none.err.contains("defines no Lagrangian"), "{}", none.err);
    desk.write("orbit.md", "$$ L = \\frac12 m (\\dot r^2 + r^2 \\dot\\phi^2) - V(r) \\tag{1} $$\n");
    desk.write(
        "orbit.json",
        r#"{ "notes": "orbit.md", "coordinates": { "r": "> 0", "\\phi": "angle" }, "constants": { "m": "> 0" },
             "functions": { "V": "of r" }, "means": { "L": "Lagrangian" } }"#,
    );
    let free = desk.onshell(&["derive", "orbit.md"]);
    assert_eq!(free.code, 2);
    assert!(free.err.contains("a function without a formula"), "{}", free.err);
    assert!(desk.onshell(&["derive", "absent.md"]).err.contains("there is no file absent.md"));
}

#[test]
fn a_force_beside_the_lagrangian_has_its_place_in_the_steps() {
    let desk = Desk::new("derive-forces");
    desk.write("damped.md", "$$ L = \\frac12 m \\dot x^2 - \\frac12 k x^2 \\tag{1} $$\n");
    let claims = |forces: &str| {
        format!(
            r#"{{ "notes": "damped.md", "coordinates": {{ "x": "any" }}, "constants": {{ "m, k, b": "> 0" }},
                 "means": {{ "L": "Lagrangian" }}{forces} }}"#
        )
    };
    desk.write("damped.json", claims(r#", "forces": { "x": "-b \\dot x" }"#));
    let run = desk.onshell(&["derive", "damped.md", "--steps"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("m·x\u{308} = −b·x\u{307} − k·x"), "{}", run.out);
    assert!(run.out.contains("The force ") && !run.out.contains("is constant"), "{}", run.out);
    // the twin: without the force the energy is conserved
    desk.write("damped.json", claims(""));
    let run = desk.onshell(&["derive", "damped.md", "--steps"]);
    assert!(!run.out.contains("The force ") && run.out.contains("is constant"), "{}", run.out);
}
