//! Notes without a claims file that print T and U beside a Lagrangian, a force that it does not contain, or its energy.

use crate::support::verdicts;
use crate::unaided::page;

const KINETIC: &str = r"T = \frac12 m\ell^2\dot\phi^2";
const POTENTIAL: &str = r"U = -m g\ell\cos\phi";
const LAGRANGIAN: &str = r"L = \frac12 m\ell^2\dot\phi^2 + m g\ell\cos\phi";
const MOTION: &str = r"\ell\ddot\phi + g\sin\phi = 0";

fn found(name: &str, displays: &[&str]) -> Vec<String> {
    verdicts(&format!("unaided-energies-{name}"), &page(displays))
}

/// T and U are compared with L. What follows from L says which is wrong; without that, one of the two is.
#[test]
fn the_energies_are_compared_with_the_lagrangian() {
    assert_eq!(
        found("right", &[KINETIC, POTENTIAL, LAGRANGIAN, MOTION]),
        ["definition", "definition", "definition", "certified"]
    );
    for (wrong, place) in [
        (r"U = m g\ell\cos\phi", 1),
        (r"U = -2 m g\ell\cos\phi", 1),
        (r"U = -m g\ell\sin\phi", 1),
        (r"T = m\ell^2\dot\phi^2", 0),
    ] {
        let mut displays = [KINETIC, POTENTIAL, LAGRANGIAN, MOTION];
        displays[place] = wrong;
        let with_motion = found("slip", &displays);
        assert_eq!((with_motion[place].as_str(), with_motion[3].as_str()), ("refuted", "certified"), "{wrong}");
        let alone = found("slip-alone", &displays[..3]);
        assert_eq!((alone[place].as_str(), alone[2].as_str()), ("undecided", "undecided"), "{wrong}");
    }
    // Another zero of the potential energy, and a quantity with the letter of one, are no slips.
    for other in [r"U = m g\ell(1 - \cos\phi)", r"U = -m g\ell\cos\phi + U_0", r"U = R I"] {
        let found = found("other", &[KINETIC, other, LAGRANGIAN, MOTION]);
        assert!(
            found.iter().all(|verdict| !["refuted", "undecided"].contains(&verdict.as_str())),
            "{other}: {found:?}"
        );
    }
}

/// The slip is in L, and the equation of motion follows from T and U.
#[test]
fn a_slip_in_the_lagrangian_makes_no_equation_of_motion_wrong() {
    let slip = r"L = \frac12 m\ell^2\dot\phi^2 - m g\ell\cos\phi";
    assert_eq!(
        found("lagrangian-slip", &[KINETIC, POTENTIAL, slip, MOTION]),
        ["definition", "definition", "refuted", "undecided"]
    );
    // Without T and U nothing speaks against L.
    assert_eq!(found("no-energies", &[slip, MOTION]), ["definition", "refuted"]);
}

/// With a printed force the motion is not that of L alone.
#[test]
fn a_force_beside_the_lagrangian_is_not_dropped() {
    let cart =
        r"L = \tfrac12 (M+m)\dot x^2 + m l \dot x\dot\theta\cos\theta + \tfrac12 m l^2\dot\theta^2 - m g l\cos\theta";
    let motion =
        |force: &str| format!(r"(M+m)\ddot x + m l\ddot\theta\cos\theta - m l\dot\theta^2\sin\theta = {force}");
    let solved = r"\ddot x = \frac{m l\dot\theta^2\sin\theta - m g\sin\theta\cos\theta}{M + m\sin^2\theta}";
    assert_eq!(found("force", &[cart, &motion("F"), solved]), ["definition", "assumed", "undecided"]);
    assert_eq!(found("no-force", &[cart, &motion("0"), solved]), ["definition", "certified", "certified"]);
}

/// "The energy is conserved: E = … = const" is a claim about the formula.
#[test]
fn what_is_said_to_be_constant_is_compared_with_the_motion() {
    let energy = |sign: &str| {
        format!(
            "$$ L = \\frac{{m}}{{2}}\\dot x^2 - \\frac{{k}}{{2}} x^2 $$\n\nThe energy is conserved:\n\n\
             $$ E = \\frac{{m}}{{2}}\\dot x^2 {sign} \\frac{{k}}{{2}} x^2 = \\mathrm{{const}} $$\n"
        )
    };
    assert_eq!(verdicts("unaided-energies-const", &energy("+")), ["definition", "certified"]);
    assert_eq!(verdicts("unaided-energies-const-slip", &energy("-")), ["definition", "refuted"]);
}
