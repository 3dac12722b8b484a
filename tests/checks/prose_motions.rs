//! What words before a display say of the motion that it is about: small, from a start, in other coordinates, to an order.

use onshell::check::Verdict;
use serde_json::{Value as Json, json};

use crate::prose_claims::{checked, claims, of, passes_and_finds};

/// A Lagrangian, words, and a display after them.
fn notes(lagrangian: &str, words: &str, formula: &str) -> String {
    format!("$$ L = {lagrangian} \\tag{{1}} $$\n\n{words}\n\n$$ {formula} \\tag{{2}} $$\n")
}

/// The verdict on the display after the words.
fn verdict(claims: &Json, notes: &str) -> Verdict {
    of(&checked(claims, notes), "2").finding.verdict
}

const PENDULUM: &str = r"\frac12 m l^2\dot\theta^2 + m g l\cos\theta";

fn pendulum() -> Json {
    claims(&json!({ r"\theta": "angle" }), "m, l, g")
}

const FALL: &str = r"\frac12 m\dot x^2 - m g x";

fn fall() -> Json {
    claims(&json!({ "x": "any" }), "m, g, h")
}

#[test]
fn small_motion_is_said_before_a_colon_or_in_an_earlier_sentence() {
    let words = [
        "For small angles the equation of motion becomes:",
        "For small angles we replace the sine by the angle. The equation becomes",
        r"We assume that $\theta$ is small. Then",
        "We linearize. The result is",
        r"Since $\theta \ll 1$, we may put the angle for its sine, and",
    ];
    for words in words {
        let right = notes(PENDULUM, words, r"\ddot\theta = -\frac gl\theta");
        assert_eq!(verdict(&pendulum(), &right), Verdict::Verified, "{words}");
        let wrong = notes(PENDULUM, words, r"\ddot\theta = -\frac lg\theta");
        assert_eq!(verdict(&pendulum(), &wrong), Verdict::Refuted, "{words}");
    }
    let others = [
        "The motion is exactly as follows:",
        "For small angles much is simple. The exact equation is",
        "A small mass hangs here. The equation of motion is",
        "For small angles it is simple.\n\nFor all of them",
    ];
    for words in others {
        let linear = notes(PENDULUM, words, r"\ddot\theta = -\frac gl\theta");
        assert_eq!(verdict(&pendulum(), &linear), Verdict::Refuted, "{words}");
    }
}

#[test]
fn a_distance_from_a_place_of_rest_is_small() {
    let lagrangian = r"\frac12 m\dot x^2 + \frac12 m\Omega^2 x^2 - \frac14\beta x^4";
    let claims = claims(&json!({ "x": "any" }), r"m, \Omega, \beta, x_0");
    for words in [
        r"There is an equilibrium at $x = x_0$. With $x = x_0 + \xi$, to first order in $\xi$,",
        r"We put $\xi = x - x_0$ and find to first order in $\xi$",
    ] {
        let right = notes(lagrangian, words, r"\ddot\xi + 2\Omega^2\xi = 0");
        assert_eq!(verdict(&claims, &right), Verdict::Verified, "{words}");
        passes_and_finds(&claims, &right, &[("2", r"2\Omega^2\xi", r"3\Omega^2\xi")]);
    }
    // Nothing says that the distance is small.
    let exact = notes(lagrangian, r"With $x = x_0 + \xi$ we have", r"\ddot\xi + 2\Omega^2\xi = 0");
    assert!(!verdict(&claims, &exact).passes());
}

#[test]
fn old_coordinates_as_formulas_of_new_ones() {
    let plane = claims(&json!({ "x, y": "any" }), "m, q, B, b, k");
    let field = r"\frac12 m(\dot x^2 + \dot y^2) + \frac12 q B(x\dot y - y\dot x)";
    let polar = notes(
        field,
        r"In polar coordinates, $x = r\cos\varphi$ and $y = r\sin\varphi$, the radial equation is",
        r"m\ddot r = m r\dot\varphi^2 + q B r\dot\varphi",
    );
    passes_and_finds(&plane, &polar, &[("2", r"+ q B r", r"- q B r")]);
    let saddle = notes(
        r"m\dot x\dot y - k x y",
        r"With $x = (u+w)/\sqrt2$ and $y = (u-w)/\sqrt2$ the Lagrangian takes the form",
        r"L = \frac m2(\dot u^2 - \dot w^2) - \frac k2(u^2 - w^2)",
    );
    passes_and_finds(&plane, &saddle, &[("2", r"\frac k2", r"\frac k3")]);
}

#[test]
fn a_fall_begins_at_rest() {
    let words = [
        "If the body is dropped from rest at $x = h$, then",
        "If the body falls from rest at $x = h$, then",
        "Suppose that at $t = 0$ the body is at rest at $x = h$. Then",
        "If it is at $x = h$ without initial velocity, then",
    ];
    for words in words {
        let right = notes(FALL, words, r"\dot x^2 = 2 g(h - x)");
        assert_eq!(verdict(&fall(), &right), Verdict::Verified, "{words}");
        let wrong = notes(FALL, words, r"\dot x^2 = g(h - x)");
        assert_eq!(verdict(&fall(), &wrong), Verdict::Refuted, "{words}");
    }
    // Who passes a place is not at rest there.
    let passing = notes(FALL, "If the body passes $x = h$, then", r"\dot x^2 = 2 g(h - x)");
    assert_eq!(verdict(&fall(), &passing), Verdict::Refuted);
}

#[test]
fn a_lost_term_of_a_high_power_is_seen_after_a_start_with_a_velocity() {
    let claims = claims(&json!({ "x": "any" }), r"m, \kappa, v");
    let lagrangian = r"\frac12 m\dot x^2 - \frac16 m\kappa x^6";
    let words = r"If $x(0) = 0$ and $\dot x(0) = v$, then";
    assert!(verdict(&claims, &notes(lagrangian, words, r"\dot x^2 = v^2 - \frac13\kappa x^6")).passes());
    assert!(!verdict(&claims, &notes(lagrangian, words, r"\dot x^2 = v^2")).passes());
}

#[test]
fn a_solution_to_first_order_in_a_constant() {
    let claims = claims(&json!({ "x, z": "any" }), r"m, g, h, \epsilon, \Omega");
    let lagrangian = r"\frac12 m(\dot x^2 + \dot z^2) + m\Omega(z\dot x - x\dot z) - m g z";
    let right = notes(
        lagrangian,
        r"If the body starts from rest at $x = 0$, $z = h$, then to first order in $\Omega$",
        r"x(t) = \frac13\Omega g t^3, \qquad z(t) = h - \frac12 g t^2",
    );
    passes_and_finds(&claims, &right, &[("2", r"\frac13", r"\frac12")]);
    // It is no solution to the second order, and does not start so elsewhere.
    for (from, to) in [("first order", "second order"), ("$z = h$", "$z = 2h$")] {
        let found = verdict(&claims, &right.replace(from, to));
        assert_eq!(found, Verdict::Refuted, "{to}");
    }
    let neglected = right.replace(r"to first order in $\Omega$", r"neglecting terms of order $\Omega^2$");
    assert!(verdict(&claims, &neglected).passes());
}

#[test]
fn a_rigid_joint_keeps_coordinates_equal() {
    let claims = claims(&json!({ "q_1, q_2": "angle" }), r"I, J, k, \mu");
    let joint = |words: &str, formula: &str| {
        notes(r"\frac12 I\dot q_1^2 + \frac12 J\dot q_2^2 - \frac12 k(q_1 - q_2)^2 + \mu q_2", words, formula)
    };
    let rigid = "For a rigid joint, $q_1 = q_2 = q$, this becomes";
    assert!(verdict(&claims, &joint(rigid, r"(I + J)\ddot q = \mu")).passes());
    assert!(!verdict(&claims, &joint(rigid, r"(I - J)\ddot q = \mu")).passes());
    assert!(verdict(&claims, &joint(r"As $k \to \infty$, $q_1 = q_2$, and", r"(I + J)\ddot q_1 = \mu")).passes());
    // Where the joint gives, q_1 = q_2 is an instant.
    assert!(!verdict(&claims, &joint("When $q_1 = q_2$, this becomes", r"(I + J)\ddot q_1 = \mu")).passes());
}

#[test]
fn a_determinant_is_a_secular_equation() {
    let claims = claims(&json!({ "x, y": "any" }), r"m, k, c, \omega");
    let pair = notes(
        r"\frac12 m(\dot x^2 + \dot y^2) - \frac12 k(x^2 + y^2) - \frac12 c(x - y)^2",
        "The secular equation is",
        r"\begin{vmatrix} k + c - m\omega^2 & -c \\ -c & k + c - m\omega^2 \end{vmatrix} = 0",
    );
    passes_and_finds(&claims, &pair, &[("2", r"\\ -c", r"\\ c")]);
}

#[test]
fn constants_without_an_acceleration() {
    let claims = claims(&json!({ "x": "any" }), "m, M, g");
    let lagrangian = r"\frac12(M + m)\dot x^2 + (M - m) g x";
    for words in ["The masses stay at rest if", r"If $\ddot x = 0$, then", "The acceleration vanishes if"] {
        assert!(verdict(&claims, &notes(lagrangian, words, "M = m")).passes(), "{words}");
        assert!(!verdict(&claims, &notes(lagrangian, words, "M = 2 m")).passes(), "{words}");
    }
    assert!(!verdict(&claims, &notes(lagrangian, "We see that", "M = m")).passes());
}

/// A spring of three balls in a ring.
const RING: &str =
    r"\frac12 m(\dot x^2 + \dot y^2 + \dot z^2) - \frac12 k\left((x - y)^2 + (y - z)^2 + (z - x)^2\right)";

#[test]
fn a_chain_of_coordinates_with_a_sign_is_a_solution_for_each() {
    let claims = claims(&json!({ "x, y, z": "any" }), "m, k");
    let words = r"With $\omega_0^2 = 3k/m$ the motion is";
    let right = [
        r"x(t) = y(t) = A\cos\omega_0 t, \qquad z(t) = -2 A\cos\omega_0 t",
        r"x(t) = -y(t) = A\cos\omega_0 t, \qquad z(t) = 0",
    ];
    for formula in right {
        assert!(verdict(&claims, &notes(RING, words, formula)).passes(), "{formula}");
    }
    let wrong = [
        r"x(t) = -y(t) = A\cos\omega_0 t, \qquad z(t) = -2 A\cos\omega_0 t",
        r"x(t) = y(t) = A\cos\omega_0 t, \qquad z(t) = 0",
    ];
    for formula in wrong {
        assert_eq!(verdict(&claims, &notes(RING, words, formula)), Verdict::Refuted, "{formula}");
    }
}

#[test]
fn a_solution_that_is_not_solved_for_its_coordinate() {
    let words = r"With $\omega_0 = \sqrt{g/l}$ a motion is";
    assert!(verdict(&pendulum(), &notes(PENDULUM, words, r"\sin\frac\theta2 = \tanh\omega_0 t")).passes());
    assert_eq!(
        verdict(&pendulum(), &notes(PENDULUM, words, r"\sin\frac\theta2 = \tanh 2\omega_0 t")),
        Verdict::Refuted
    );
}

/// A plane oscillator.
const PLANE: &str = r"$$ L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 m\omega^2(x^2 + y^2) \tag{1} $$

$$ S = p_x p_y + m^2\omega^2 x y \tag{2} $$

$$ \frac{dS}{dt} = 0 \tag{3} $$

The motion is

$$ x(t) = a\cos\omega t, \qquad y(t) = b\sin\omega t \tag{4} $$

and then

$$ S = 0 \tag{5} $$
";

#[test]
fn a_value_zero_on_the_motion_that_was_just_printed() {
    let claims = claims(&json!({ "x, y": "any" }), r"m, \omega");
    assert!(of(&checked(&claims, PLANE), "5").finding.verdict.passes());
    // On another motion S has another value, and elsewhere none that is known.
    let other = PLANE.replace(r"b\sin\omega t", r"b\cos\omega t");
    assert_eq!(of(&checked(&claims, &other), "5").finding.verdict, Verdict::Refuted);
    let early = PLANE
        .replace(r"The motion is", "We have")
        .replace(r"x(t) = a\cos\omega t, \qquad y(t) = b\sin\omega t", "E = L");
    assert_eq!(of(&checked(&claims, &early), "5").finding.verdict, Verdict::Refuted);
}

/// A freely falling body with friction that grows, and the expansion of its motion.
const EXPANDED: &str = r"$$ L = \frac12 m\dot x^2 - \frac12 m\kappa^2 x^2 \tag{1} $$

A solution is

$$ x(t) = a\cos\kappa t \tag{2} $$

For short times

$$ x(t) = a - \frac12 a\kappa^2 t^2 + O(t^4) \tag{3} $$
";

#[test]
fn an_expansion_of_a_printed_solution() {
    let claims = claims(&json!({ "x": "any" }), r"m, \kappa");
    passes_and_finds(&claims, EXPANDED, &[("3", r"a - \frac12", r"a + \frac12")]);
}

/// An oscillator by its Hamiltonian.
const HAMILTON: &str = r"$$ L = \frac12 m\dot x^2 - \frac12 k x^2 \tag{1} $$

$$ H = \frac{p^2}{2m} + \frac12 m\omega^2 x^2, \qquad \dot p = -\frac{\partial H}{\partial x} = -k x \tag{2} $$

where

$$ \omega^2 = \frac km . \tag{3} $$

So

$$ \{p, H\} = -m\omega^2 x \tag{4} $$
";

#[test]
fn a_hamiltonian_beside_its_derivatives_and_the_square_of_a_frequency() {
    let claims = claims(&json!({ "x": "any" }), "m, k");
    passes_and_finds(&claims, HAMILTON, &[("2", "= -k x", "= k x"), ("4", r"= -m\omega^2", r"= m\omega^2")]);
}

#[test]
fn sums_over_numbered_coordinates_need_no_index() {
    let claims = claims(&json!({ "x_1, x_2, x_3": "any" }), "m, k");
    let chain = [
        r"\frac12 m\sum_{i=1}^3\dot x_i^2 - \frac12 k(x_2 - x_1)^2 - \frac12 k(x_3 - x_2)^2",
        r"\frac12 m\sum_i\dot x_i^2 - \frac12 k\sum_{i=1}^2(x_{i+1} - x_i)^2",
    ];
    for lagrangian in chain {
        let right = notes(lagrangian, "Hence", r"m\ddot x_2 = k(x_1 - 2 x_2 + x_3)");
        passes_and_finds(&claims, &right, &[("2", r"- 2 x_2", r"- x_2")]);
    }
    // Two of three are another sum.
    let fewer = notes(&chain[0].replace("^3", "^2"), "Hence", r"m\ddot x_3 = k(x_2 - x_3)");
    assert!(!verdict(&claims, &fewer).passes());
}

#[test]
fn a_constant_before_a_coordinate_belongs_to_the_argument() {
    let mut claims = claims(&json!({ "x": "any" }), r"m, \lambda, U_0");
    let well = notes(
        r"\frac12 m\dot x^2 - U_0\tan^2\lambda x",
        "Hence",
        r"m\ddot x = -2\lambda U_0\frac{\sin\lambda x}{\cos^3\lambda x}",
    );
    passes_and_finds(&claims, &well, &[("2", r"-2\lambda U_0", r"2\lambda U_0")]);
    // A letter of an angle may be the slope of a plane.
    claims["constants"] = json!({ r"m, \alpha, U_0": "> 0" });
    let unclear = well.replace(r"\lambda", r"\alpha");
    assert!(onshell_refuses(&claims, &unclear));
}

/// Whether a document is refused as a whole: its Lagrangian cannot be read.
fn onshell_refuses(claims: &Json, notes: &str) -> bool {
    crate::support::document(claims, notes, &onshell::systems::Registry::standard(), None).is_err()
}
