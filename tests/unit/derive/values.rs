//! Printed, read and evaluated at random states: the numbers of the system.

use onshell::derive::Quantity;

use super::support::{Numbers, Subject, agree, numbers, subject, subjects};

const STATES: usize = 6;

/// Whether an equation as it is printed holds at a state. Accelerations are those on shell, unless it is the equation of
/// motion: that is compared with the residual of the system at any.
fn holds(subject: &Subject, quantity: Quantity, n: usize, latex: &str, at: &Numbers) -> bool {
    let system = &subject.system;
    if quantity != Quantity::EulerLagrange {
        let a = system.accelerations(at.time, &at.q, &at.v, &at.parameters).expect("a regular mass matrix");
        let at = Numbers { q: at.q.clone(), v: at.v.clone(), parameters: at.parameters.clone(), a, ..*at };
        let [left, right] = subject.sides(latex, &at);
        return agree(left, right, left.abs().max(right.abs()));
    }
    let residual = |a: &[f64]| system.euler_lagrange(at.time, &at.q, &at.v, &at.parameters, a)[n];
    let printed = |a: &[f64]| {
        let at = Numbers { q: at.q.clone(), v: at.v.clone(), parameters: at.parameters.clone(), a: a.to_vec(), ..*at };
        let [left, right] = subject.sides(latex, &at);
        (left - right, left.abs() + right.abs())
    };
    // what is divided out is an exponential of the time, the same at all accelerations
    let factor = match system.name() {
        "damped_oscillator" => (at.parameters[2] * at.time).exp(),
        _ => 1.0,
    };
    let other: Vec<f64> = at.a.iter().map(|a| 0.5 - 2.0 * a).collect();
    [&at.a, &other].iter().all(|a| {
        let (difference, scale) = printed(a);
        agree(factor * difference, residual(a), factor * scale)
    })
}

/// Every text with one sign changed on the right side: each printed sign, and the whole.
fn slips(latex: &str) -> Vec<String> {
    let (left, right) = latex.split_once(" = ").expect("an equation");
    let mut slips = Vec::new();
    for (sign, other) in [(" + ", " - "), (" - ", " + ")] {
        for (at, _) in right.match_indices(sign) {
            slips.push(format!("{left} = {}{other}{}", &right[..at], &right[at + sign.len()..]));
        }
    }
    match right.strip_prefix('-') {
        Some(rest) => slips.push(format!("{left} = {rest}")),
        None if right != "0" => slips.push(format!("{left} = -\\left({right}\\right)")),
        None => slips.push(format!("{left} = 1")),
    }
    slips
}

#[test]
fn what_is_printed_has_the_values_of_the_world_and_no_slip_in_it_has() {
    let mut equations = 0;
    for subject in subjects() {
        for quantity in Quantity::ALL {
            let Some(printed) = subject.latex(quantity) else { continue };
            for (n, latex) in printed.iter().enumerate() {
                let states: Vec<Numbers> = (0..STATES).map(|k| numbers(&subject.system, k)).collect();
                for (k, at) in states.iter().enumerate() {
                    let name = subject.system.name();
                    assert!(holds(&subject, quantity, n, latex, at), "{name}, {quantity:?}, state {k}: {latex}");
                }
                for slip in slips(latex) {
                    let unnoticed = states.iter().all(|at| holds(&subject, quantity, n, &slip, at));
                    assert!(!unnoticed, "{slip} for {latex}");
                }
                equations += 1;
            }
        }
    }
    assert!(equations > 100, "only {equations} equations");
}

#[test]
fn all_but_one_system_have_everything() {
    for subject in subjects() {
        for quantity in Quantity::ALL {
            let wants_momenta = matches!(quantity, Quantity::Hamiltonian | Quantity::Hamilton);
            let expected = !(wants_momenta && subject.system.name() == "relativistic_particle");
            let found = subject.derivation.equations(quantity);
            assert_eq!(found.is_ok(), expected, "{}, {quantity:?}: {:?}", subject.system.name(), found.err());
        }
    }
}

#[test]
fn what_is_not_quadratic_says_so() {
    let error = subject("relativistic_particle").derivation.equations(Quantity::Hamiltonian).err();
    let error = error.expect("no Hamiltonian is typeset");
    assert!(error.message().contains("not quadratic"), "{error}");
    assert!(error.advice().is_some_and(|help| help.contains("energy")), "{error}");
}
