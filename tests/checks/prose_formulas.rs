//! Names that formulas in sentences define or tie to others, and equations for something that is sought.

use onshell::check::Verdict;
use serde_json::json;

use crate::prose_claims::{checked, claims, of, passes_and_finds};

/// A bead on a straight wire that stands at an angle.
const WIRE: &str = r"With the mass $m$ on the wire

$$ L = \frac12 m (1 + q^2) \dot z^2 - m g z , \tag{1} $$

$$ \ddot z = -g \cos^2\alpha , \tag{2} $$

where $\tan\alpha = q$ is the slope. For $u = z + \frac12 g t^2$ we have

$$ \ddot u = g \sin^2\alpha . \tag{3} $$
";

fn wire() -> serde_json::Value {
    claims(&json!({ "z": "any" }), "m, g, q")
}

#[test]
fn sentences_define_names_and_tie_them() {
    passes_and_finds(&wire(), WIRE, &[("2", r"\cos^2", r"\cos")]);
    // After "for" it may be a case, so that nothing is refuted with it.
    let slip = checked(&wire(), &WIRE.replace(r"g \sin^2", r"-g \sin^2"));
    assert_eq!(of(&slip, "3").finding.verdict, Verdict::Unreadable);
}

#[test]
fn the_definition_of_a_sentence_counts_where_displays_pass_with_it() {
    // another definition makes a display wrong that has the name
    let notes = WIRE.replace(r"z + \frac12 g t^2", r"z + \frac12 g t");
    let found = checked(&wire(), &notes);
    assert!(!of(&found, "3").ok, "{:?}", of(&found, "3").finding);
}

/// A planet with its turning points.
const PLANET: &str = r"$$ L = \frac m2\left(\dot r^2 + r^2\dot\varphi^2\right) + \frac\alpha r . \tag{1} $$

The angular momentum and the energy are

$$ M = m r^2\dot\varphi , \qquad E = \frac m2\dot r^2 + \frac{M^2}{2mr^2} - \frac\alpha r . \tag{2} $$

The turning points are the roots of

$$ E r^2 + \alpha r - \frac{M^2}{2m} = 0 . \tag{3} $$
";

fn planet() -> serde_json::Value {
    claims(&json!({ "r": "> 0", r"\varphi": "angle" }), r"m, \alpha")
}

#[test]
fn at_turning_points_a_coordinate_does_not_change() {
    passes_and_finds(&planet(), PLANET, &[("3", r"\frac{M^2}{2m}", r"\frac{M^2}{m}")]);
    // without words it holds nowhere
    let silent = PLANET.replace("The turning points are the roots of", "Hence");
    assert_eq!(of(&checked(&planet(), &silent), "3").finding.verdict, Verdict::Refuted);
}

#[test]
fn an_equation_for_something_sought_is_not_refuted() {
    let notes = PLANET.replace("The turning points are the roots of", "The distances are the roots of");
    let found = checked(&planet(), &notes);
    let equation = of(&found, "3");
    assert_eq!(equation.finding.code, onshell::Code::EquationForUnknown);
    assert!(!equation.ok && equation.repairs.is_empty());
}

#[test]
fn two_indices_have_the_two_signs() {
    let notes = r"$$ L = \frac12 m (\dot x^2 + \dot y^2) - \frac12 k (x^2 + y^2) - c x y \tag{1} $$

The secular equation is

$$ (k - m\omega^2)^2 - c^2 = 0 \tag{2} $$

and its roots are

$$ \omega_{1,2}^2 = \frac{k \pm c}{m} \tag{3} $$

The slower one is

$$ \omega_2 = \sqrt{\frac{k - c}{m}} \tag{4} $$
";
    let of_plane = claims(&json!({ "x, y": "any" }), "m, k, c");
    let found = checked(&of_plane, notes);
    assert!(found.equations.iter().all(|equation| equation.ok), "{:?}", found.equations);
    let wrong = checked(&of_plane, &notes.replace(r"\sqrt{\frac{k - c}{m}}", r"\sqrt{\frac{k + c}{m}}"));
    assert!(!of(&wrong, "4").ok || !of(&wrong, "3").ok);
}

#[test]
fn a_state_outside_of_the_domain_of_l_is_no_failure_of_the_document() {
    let notes = r"$$ L = -mc^2\sqrt{1 - \frac{\dot x^2 + \dot y^2}{c^2}} - m g y \tag{1} $$

$$ v^2 = \dot x^2 + \dot y^2 , \qquad \gamma = \frac{1}{\sqrt{1 - v^2/c^2}} \tag{2} $$

$$ p_x = \gamma m \dot x \tag{3} $$
";
    let found = checked(&claims(&json!({ "x, y": "any" }), "m, c, g"), notes);
    assert!(found.equations.iter().all(|equation| equation.ok), "{:?}", found.equations);
    let wrong = checked(
        &claims(&json!({ "x, y": "any" }), "m, c, g"),
        &notes.replace(r"\gamma m \dot x", r"\gamma^2 m \dot x"),
    );
    assert_eq!(of(&wrong, "3").finding.verdict, Verdict::Refuted);
}

/// Two frequencies and their difference, which the prose has named before.
const SPLIT: &str = r"With $\kappa = b/m$ the motion is given by

$$ L = \frac12 m \dot x^2 - \frac12 m \kappa^2 x^2 , \tag{1} $$

$$ \ddot x = -\kappa^2 x . \tag{2} $$

With

$$ u = \Omega + \frac{\kappa}{2} , \qquad w = \Omega - \frac{\kappa}{2} \tag{3} $$

we have

$$ u - w = \kappa . \tag{4} $$
";

#[test]
fn the_end_of_a_chain_defines_nothing_that_the_prose_does() {
    let claims = claims(&json!({ "x": "any" }), r"m, b, \Omega");
    passes_and_finds(&claims, SPLIT, &[("4", "u - w", "u + w"), ("2", r"= -\kappa^2 x", r"= -\kappa x")]);
}

/// A force that a display contains before another one says what it is.
const DRIVEN: &str = r"$$ L = \frac12 m \dot x^2 - \frac14 k x^4 \tag{1} $$

The equation of motion is

$$ m \ddot x + k x^3 = f . \tag{2} $$

The force

$$ f = k x^3 - m \omega^2 x \tag{3} $$

makes an oscillator of it,

$$ \ddot x = -\omega^2 x . \tag{4} $$
";

#[test]
fn an_equation_of_motion_that_ends_in_a_force_does_not_define_it() {
    let mut claims = claims(&json!({ "x": "any" }), r"m, k, \omega");
    claims["forces"] = json!({ "x": "f" });
    passes_and_finds(&claims, DRIVEN, &[("2", "+ k x^3", "- k x^3"), ("4", r"= -\omega^2 x", r"= -2 \omega^2 x")]);
}
