//! What is derived, put into notes as it is printed, passes the check of the notes.

use onshell::check::{Document, Verdict};
use onshell::derive::Quantity;
use onshell::testing::check_text;
use serde_json::json;

use super::support::{Subject, registry, subjects};

/// The displays of all quantities, and for the masses what says their use: p = M q̇.
fn displays(subject: &Subject) -> Vec<String> {
    let mut displays: Vec<String> =
        Quantity::ALL.iter().filter_map(|&quantity| subject.latex(quantity)).flatten().collect();
    let names = subject.system.coordinates();
    for (i, name) in names.iter().enumerate() {
        let term = |(j, other): (usize, &String)| {
            let (first, second) = (&names[i.min(j)], &names[i.max(j)]);
            format!("M_{{{first} {second}}} \\dot{{{other}}}")
        };
        let terms: Vec<String> = names.iter().enumerate().map(term).collect();
        displays.push(format!("p_{{{name}}} = {}", terms.join(" + ")));
    }
    displays
}

/// Notes with these displays, checked against the system; a range for each coordinate by what it is.
fn checked(subject: &Subject, displays: &[String]) -> Document {
    let display = |(n, latex): (usize, &String)| format!("$$\n{latex} \\tag{{{}}}\n$$\n\n", n + 1);
    let notes: String = displays.iter().enumerate().map(display).collect();
    let range = |name: &str| match name {
        "r" => "> 0",
        "x" | "y" => "any",
        _ => "angle",
    };
    let coordinates: serde_json::Map<String, serde_json::Value> =
        subject.system.coordinates().iter().map(|name| (name.clone(), range(name).into())).collect();
    let claims = json!({
        "notes": "notes.md",
        "system": subject.system.name(),
        "coordinates": coordinates,
        "constants": { subject.system.parameters().join(", "): "> 0" },
        "means": { "L": "Lagrangian", "E": "energy", "H": "Hamiltonian" },
    });
    let document = check_text(&notes, &claims.to_string(), &registry());
    document.unwrap_or_else(|error| panic!("{}: {error}", subject.system.name()))
}

/// L = T − U with T = ½ Σ M q̇ q̇, so that momenta are p = M q̇.
fn has_no_linear_term(subject: &Subject) -> bool {
    !["charge", "shaken", "relativistic_particle"].contains(&subject.system.name())
}

#[test]
fn notes_made_of_what_was_derived_pass() {
    for subject in subjects().iter().filter(|subject| has_no_linear_term(subject)) {
        let displays = displays(subject);
        let document = checked(subject, &displays);
        assert_eq!(document.equations.len(), displays.len());
        for (equation, latex) in document.equations.iter().zip(&displays) {
            let finding = &equation.finding;
            assert!(finding.verdict.passes(), "{}: {latex}: {}", subject.system.name(), finding.message);
        }
    }
}

#[test]
fn where_the_momenta_are_no_multiples_of_velocities_all_but_the_masses_pass() {
    for subject in subjects().iter().filter(|subject| !has_no_linear_term(subject)) {
        let quantities = Quantity::ALL.iter().filter(|&&quantity| quantity != Quantity::MassMatrix);
        let displays: Vec<String> = quantities.filter_map(|&quantity| subject.latex(quantity)).flatten().collect();
        for (equation, latex) in checked(subject, &displays).equations.iter().zip(&displays) {
            let finding = &equation.finding;
            assert!(finding.verdict.passes(), "{}: {latex}: {}", subject.system.name(), finding.message);
        }
    }
}

/// Masses are introduced by their equations, which makes them definitions; that p = M q̇ is certified says what they are.
/// Where the momenta are something else nothing prints their use, and they are left out.
fn is_mass(latex: &str) -> bool {
    latex.starts_with("M_")
}

#[test]
fn what_is_derived_is_certified() {
    let mut open = Vec::new();
    for subject in subjects() {
        let displays: Vec<String> = match has_no_linear_term(&subject) {
            true => displays(&subject),
            false => {
                let all = Quantity::ALL.iter().filter_map(|&quantity| subject.latex(quantity)).flatten();
                all.filter(|latex| !is_mass(latex)).collect()
            }
        };
        for (equation, latex) in checked(&subject, &displays).equations.iter().zip(&displays) {
            let finding = &equation.finding;
            let expected = if is_mass(latex) { Verdict::Definition } else { Verdict::Certified };
            if finding.verdict != expected {
                let reason = finding.not_certified_because.as_ref().unwrap_or(&finding.message);
                open.push(format!("{}: {latex}: {} {reason}", subject.system.name(), finding.verdict.word()));
            }
        }
    }
    assert!(open.is_empty(), "{}", open.join("\n"));
}

#[test]
fn a_flipped_sign_in_them_is_refuted() {
    for subject in subjects() {
        let latex = subject.latex(Quantity::EulerLagrange).expect("every system has equations of motion");
        let (left, right) = latex[0].split_once(" = ").expect("an equation");
        let wrong = match right {
            "0" => format!("{left} = 1"),
            _ => format!("{left} = -\\left({right}\\right)"),
        };
        let document = checked(&subject, &[wrong]);
        assert_eq!(document.equations[0].finding.verdict, Verdict::Refuted, "{}", subject.system.name());
    }
}
