//! Rigid bodies, axes that turn, components along axes, and the tensor of inertia.

use onshell::check::Finding;
use onshell::check::Verdict::{self, Certified, Refuted, Undecided, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{assuming, equation, numbered, outcome, seeded, verdict, with};

/// A rigid body whose axis passes through the point c and keeps its direction.
fn body() -> Json {
    json!({
        "indices": { "i": "1..n" },
        "varies with time": {
            r"\vec\omega": "fixed direction",
            r"\vec r_i": r"rigid, turning with \vec\omega about \vec c",
        },
        "constants": { "m_i": "> 0", r"\vec c": "any" },
        "define": { "I": r"\sum_i m_i |\hat\omega \times (\vec r_i - \vec c)|^2" },
    })
}

/// A body that turns about the origin in any way, with its tensor of inertia.
fn top() -> Json {
    json!({
        "indices": { "i": "1..n", "a, b": "1..3" },
        "varies with time": { r"\vec\omega": "any", r"\vec r_i": r"rigid, turning with \vec\omega about \vec 0" },
        "constants": { "m_i": "> 0" },
        "axes": { r"\hat x, \hat y, \hat z": "fixed" },
        "components": { r"\vec r_i": "x_i, y_i, z_i", r"\vec\omega": r"along \hat e_a" },
        "means": {
            r"\mathbb{I}, \mathbb{I}_{ab}": r"inertia tensor of m_i at \vec r_i",
            r"\lambda_a": r"principal moments of m_i at \vec r_i",
            r"\hat e_a": r"principal axes of m_i at \vec r_i",
        },
    })
}

fn of_the_body(latex: &str, assume: &[&str]) -> Verdict {
    verdict(&body(), &[latex], assuming(assume))
}

fn of_the_top(latex: &str) -> Verdict {
    verdict(&top(), &[latex], json!({}))
}

#[test]
fn the_particles_of_a_body_circle_about_its_axis() {
    assert_eq!(of_the_body(r"\dot{\vec r}_i = \vec\omega \times (\vec r_i - \vec c)", &[]), Verified);
    assert_eq!(of_the_body(r"\dot{\vec r}_i = (\vec r_i - \vec c) \times \vec\omega", &[]), Refuted);
    assert_eq!(of_the_body(r"\dot{\vec r}_i = \vec\omega \times (\vec r_i + \vec c)", &[]), Refuted);
    assert_eq!(of_the_body(r"|\vec r_i - \vec r_1|^2 = |\vec r_1 - \vec r_i|^2", &[]), Verified);
}

#[test]
fn an_axis_need_not_pass_through_the_origin() {
    let origin = &[r"\vec c = \vec 0"];
    assert_eq!(of_the_body(r"\dot{\vec r}_i = \vec\omega \times \vec r_i", origin), Verified);
    assert_eq!(of_the_body(r"\dot{\vec r}_i = \vec\omega \times \vec r_i", &[]), Refuted);
    let along = r"\hat\omega \cdot \sum_i m_i \vec r_i \times \dot{\vec r}_i = I \omega";
    assert_eq!(of_the_body(along, origin), Verified);
    assert_eq!(of_the_body(along, &[]), Refuted);
    // The energy does not mind.
    assert_eq!(of_the_body(r"\sum_i m_i |\dot{\vec r}_i|^2 = I \omega^2", &[]), Verified);
    assert_eq!(of_the_body(r"\sum_i m_i |\dot{\vec r}_i|^2 = \frac12 I \omega^2", &[]), Refuted);
}

#[test]
fn a_body_keeps_its_shape_and_its_moment_about_its_axis() {
    assert_eq!(of_the_body(r"\dot I = 0", &[]), Verified);
    assert_eq!(of_the_body(r"\frac{d}{dt} |\vec r_2 - \vec r_1|^2 = 0", &[]), Verified);
    assert_eq!(of_the_body(r"\frac{d}{dt} |\vec r_2 + \vec r_1|^2 = 0", &[]), Refuted);
    assert_eq!(of_the_body(r"\frac{d}{dt} \left( \sum_i m_i |\hat\omega \times \vec r_i|^2 \right) = 0", &[]), Refuted);
    assert_eq!(of_the_body(r"\dot\omega = 0", &[]), Refuted);
    assert_eq!(of_the_body(r"\frac{d}{dt} \hat\omega = \vec 0", &[]), Verified);
}

#[test]
fn an_axis_that_tumbles_is_no_fixed_axis() {
    let mut tumbling = body();
    tumbling["varies with time"][r"\vec\omega"] = json!("any");
    let torque = r"\hat\omega \cdot \sum_i m_i \vec r_i \times \ddot{\vec r}_i = I \dot\omega";
    let origin = json!({ "assume": r"\vec c = \vec 0" });
    assert_eq!(verdict(&body(), &[torque], origin.clone()), Verified);
    assert_eq!(verdict(&tumbling, &[torque], origin), Refuted);
    assert_eq!(verdict(&tumbling, &[r"\dot I = 0"], json!({})), Refuted);
}

/// Axes that turn with ω, and a vector with components along them.
fn turning() -> Json {
    json!({
        "indices": { "a": "1..3" },
        "varies with time": { r"\vec\omega, \vec v": "any" },
        "axes": { r"\hat e_a": r"turning with \vec\omega" },
        "components": { r"\vec v, \vec\omega": r"along \hat e_a" },
        "define": { r"\dot{\vec v}": r"\dot v_a \hat e_a" },
    })
}

#[test]
fn axes_turn_and_carry_their_components_with_them() {
    let turning = turning();
    let of = |latex: &str| verdict(&turning, &[latex], json!({}));
    assert_eq!(of(r"\frac{d}{dt} \hat e_a = \vec\omega \times \hat e_a"), Verified);
    assert_eq!(of(r"\frac{d}{dt} \hat e_a = \hat e_a \times \vec\omega"), Refuted);
    assert_eq!(of(r"\frac{d}{dt} \hat e_a = 0"), Refuted);
    assert_eq!(of(r"\vec v = v_a \hat e_a"), Verified);
    assert_eq!(of(r"v_a = \hat e_a \cdot \vec v"), Verified);
    assert_eq!(of(r"v_a = \hat e_a \cdot \vec\omega"), Refuted);
    assert_eq!(of(r"\hat e_1 \times \hat e_2 = \hat e_3"), Verified);
    assert_eq!(of(r"\hat e_2 \times \hat e_1 = \hat e_3"), Refuted);
    // The rate of change seen from the axes, and the one from outside.
    assert_eq!(of(r"\frac{d \vec v}{dt} = \dot{\vec v} + \vec\omega \times \vec v"), Verified);
    assert_eq!(of(r"\frac{d \vec v}{dt} = \dot{\vec v} - \vec\omega \times \vec v"), Refuted);
    assert_eq!(of(r"\frac{d \vec v}{dt} = \dot{\vec v}"), Refuted);
}

#[test]
fn fixed_axes_do_not_turn() {
    let fixed = json!({
        "indices": { "a": "1..3" },
        "varies with time": { r"\vec\omega, \vec v": "any" },
        "axes": { r"\hat e_a": "fixed" },
        "components": { r"\vec v": r"along \hat e_a" },
    });
    assert_eq!(verdict(&fixed, &[r"\frac{d}{dt} \hat e_a = 0"], json!({})), Verified);
    assert_eq!(verdict(&fixed, &[r"\frac{d}{dt} \hat e_a = \vec\omega \times \hat e_a"], json!({})), Refuted);
    assert_eq!(verdict(&fixed, &[r"\dot{\vec v} = \dot v_a \hat e_a"], json!({})), Verified);
    assert_eq!(verdict(&turning(), &[r"\frac{d}{dt} \vec v = \dot v_a \hat e_a"], json!({})), Refuted);
}

#[test]
fn the_tensor_of_inertia() {
    assert_eq!(of_the_top(r"\sum_i m_i \vec r_i \times \dot{\vec r}_i = \mathbb{I} \vec\omega"), Verified);
    assert_eq!(of_the_top(r"\sum_i m_i \dot{\vec r}_i \times \vec r_i = \mathbb{I} \vec\omega"), Refuted);
    assert_eq!(of_the_top(r"\sum_i m_i |\dot{\vec r}_i|^2 = \vec\omega \cdot \mathbb{I} \vec\omega"), Verified);
    assert_eq!(of_the_top(r"\frac12 \sum_i m_i |\dot{\vec r}_i|^2 = \vec\omega \cdot \mathbb{I} \vec\omega"), Refuted);
    assert_eq!(of_the_top(r"\mathbb{I}_{ab} = \mathbb{I}_{ba}"), Verified);
    assert_eq!(of_the_top(r"\mathbb{I}_{ab} = -\mathbb{I}_{ba}"), Refuted);
    assert_eq!(of_the_top(r"\hat z \cdot \mathbb{I} \hat z = \sum_i m_i (x_i^2 + y_i^2)"), Verified);
    assert_eq!(of_the_top(r"\hat z \cdot \mathbb{I} \hat z = \sum_i m_i (x_i^2 + z_i^2)"), Refuted);
    assert_eq!(of_the_top(r"\mathbb{I}_{12} = -\sum_i m_i x_i y_i"), Verified);
    assert_eq!(of_the_top(r"\mathbb{I}_{12} = \sum_i m_i x_i y_i"), Refuted);
}

#[test]
fn principal_axes_are_axes_of_the_body() {
    assert_eq!(of_the_top(r"\mathbb{I} \hat e_2 = \lambda_2 \hat e_2"), Verified);
    assert_eq!(of_the_top(r"\mathbb{I} \hat e_2 = \lambda_1 \hat e_2"), Refuted);
    assert_eq!(of_the_top(r"\mathbb{I} \hat x = \lambda_1 \hat x"), Refuted);
    assert_eq!(of_the_top(r"\hat e_a \cdot \hat e_b = \delta_{ab}"), Verified);
    assert_eq!(of_the_top(r"\hat e_a \cdot \hat e_b = 2 \delta_{ab}"), Refuted);
    let energy = |moment: &str| {
        of_the_top(&format!(r"\frac12 \sum_i m_i |\dot{{\vec r}}_i|^2 = \frac12 \sum_a {moment} \omega_a^2"))
    };
    assert_eq!(energy(r"\lambda_a"), Verified);
    assert_eq!(energy(r"\lambda_1"), Refuted);
    assert_eq!(of_the_top(r"\lambda_1 \leq \lambda_2 + \lambda_3"), Verified);
    assert_eq!(of_the_top(r"\lambda_1 \geq \lambda_2 + \lambda_3"), Refuted);
}

/// What is said of a claim about two bodies, each with its tensor, moments and axes.
fn of_two_tops(latex: &str, claim: Json) -> Finding {
    let mut claims = top();
    claims["varies with time"][r"\vec s_i"] = json!(r"rigid, turning with \vec\omega about \vec 0");
    for (name, meaning) in [
        (r"\mathbb{J}", r"inertia tensor of m_i at \vec s_i"),
        (r"\mu_a", r"principal moments of m_i at \vec s_i"),
        (r"\hat s_a", r"principal axes of m_i at \vec s_i"),
    ] {
        claims["means"][name] = json!(meaning);
    }
    equation(&with(&claims, "define", json!({ "T": r"\frac12 \sum_i m_i |\dot{\vec r}_i|^2" })), &[latex], claim)
        .finding
}

#[test]
fn what_any_axes_or_any_tensor_obey_the_principal_ones_are_certified_to_obey() {
    for (sound, near_miss) in [
        (r"\mathbb{I} \hat e_2 = \lambda_2 \hat e_2", r"\mathbb{I} \hat e_2 = \lambda_1 \hat e_2"),
        (
            r"\sum_a \lambda_a \omega_a^2 = \vec\omega \cdot \mathbb{I} \vec\omega",
            r"\sum_a \lambda_1 \omega_a^2 = \vec\omega \cdot \mathbb{I} \vec\omega",
        ),
        (r"\hat e_1 \times \hat e_2 = \hat e_3", r"\hat e_2 \times \hat e_1 = \hat e_3"),
        // Of a chain whose sides a field cannot both have, each has its own partner.
        (
            r"T = \frac12 \vec\omega \cdot \mathbb{I} \vec\omega = \frac12 \sum_a \lambda_a \omega_a^2",
            r"T = \frac12 \vec\omega \cdot \mathbb{I} \vec\omega = \sum_a \lambda_a \omega_a^2",
        ),
        (
            r"\vec\omega \cdot \mathbb{I} \vec\omega = \sum_a \lambda_a \omega_a^2 = 2T",
            r"\vec\omega \cdot \mathbb{I} \vec\omega = \sum_a \lambda_a \omega_a^2 = T",
        ),
    ] {
        let found = of_two_tops(sound, json!({}));
        assert_eq!(found.verdict, Certified, "{sound}: {found:?}");
        assert!(found.false_accept_log2.is_some_and(|log2| log2 <= -80.0), "{sound}");
        assert_eq!(of_two_tops(near_miss, json!({})).verdict, Refuted, "{near_miss}");
    }
    // More than a field can have in one link, or at all.
    for open in [
        r"T = \frac12 \sum_a \lambda_a \omega_a^2",
        r"\sum_a (\lambda_a + \mu_a) = \sum_i 2 m_i (|\vec r_i|^2 + |\vec s_i|^2)",
    ] {
        assert_eq!(of_two_tops(open, json!({})).verdict, Verified, "{open}");
    }
    // The axes of one body say nothing of the other's tensor.
    assert_eq!(of_two_tops(r"\mathbb{J} \hat e_2 = \mu_2 \hat e_2", json!({})).verdict, Refuted);
    assert_eq!(of_two_tops(r"\mathbb{J} \hat s_2 = \mu_2 \hat s_2", json!({})).verdict, Certified);
}

#[test]
fn a_hypothesis_about_a_vector_of_a_turned_body_is_solved_exactly() {
    let spin = |factor: &str| {
        format!(
            r"\sum_i m_i \vec r_i \times \dot{{\vec r}}_i
            = \sum_i m_i (\vec r_i - \vec a) \times (\dot{{\vec r}}_i - \vec\omega \times \vec a)
            + {factor} \vec a \times \sum_i m_i \, \vec\omega \times \vec a"
        )
    };
    let claims = with(&top(), "constants", json!({ "m_i": "> 0", r"\vec a": "any" }));
    let found = |latex: &str, claim: Json| equation(&claims, &[latex], claim).finding;
    let centered = json!({ "throughout": r"\sum_i m_i (\vec r_i - \vec a) = \vec 0" });
    let at_instant = json!({ "assume": r"\sum_i m_i (\vec r_i - \vec a) = \vec 0" });
    let sound = found(&spin(""), at_instant.clone());
    assert_eq!(sound.verdict, Certified, "{sound:?}");
    // The twins: another claim, and no hypothesis; and a center that rests and turns is at the origin.
    assert_eq!(found(&spin("2"), at_instant).verdict, Refuted);
    assert_eq!(found(&spin(""), json!({})).verdict, Refuted);
    assert_ne!(found(&spin(""), centered).verdict, Certified);
}

#[test]
fn no_order_of_the_principal_moments_is_taken_for_granted() {
    for (larger, smaller) in [(1, 2), (2, 1), (1, 3), (3, 1), (2, 3), (3, 2)] {
        let claim = format!(r"\lambda_{larger} \geq \lambda_{smaller}");
        assert_eq!(of_the_top(&claim), Refuted, "{claim}");
    }
    // What does not depend on the order.
    assert_eq!(
        of_the_top(r"\lambda_1 + \lambda_2 + \lambda_3 = \mathbb{I}_{11} + \mathbb{I}_{22} + \mathbb{I}_{33}"),
        Verified
    );
    assert_eq!(
        of_the_top(r"\lambda_1 + \lambda_2 - \lambda_3 = \mathbb{I}_{11} + \mathbb{I}_{22} - \mathbb{I}_{33}"),
        Refuted
    );
}

#[test]
fn a_body_that_turns_changes_its_tensor_along_fixed_axes() {
    assert_eq!(of_the_top(r"\frac{d}{dt} \mathbb{I}_{11} = 0"), Refuted);
    assert_eq!(of_the_top(r"\frac{d}{dt} (\mathbb{I}_{11} + \mathbb{I}_{22} + \mathbb{I}_{33}) = 0"), Verified);
}

#[test]
fn eulers_equations_follow_from_the_balance_of_torque() {
    let claims = json!({
        "indices": { "a": "1..3" },
        "varies with time": { r"\vec\omega, \vec N": "any" },
        "constants": { r"\lambda_1, \lambda_2, \lambda_3": "> 0" },
        "axes": { r"\hat e_a": r"turning with \vec\omega" },
        "components": { r"\vec\omega, \vec N": r"along \hat e_a" },
        "define": { r"\vec L": r"\sum_a \lambda_a \omega_a \hat e_a" },
        "laws": { "torque": "1" },
    });
    let law = r"\frac{d \vec L}{dt} = \vec N";
    let euler = |difference: &str| {
        let latex = format!(r"\lambda_1 \dot\omega_1 + ({difference}) \omega_2 \omega_3 = N_1");
        verdict(&claims, &[law, &latex], json!({}))
    };
    assert_eq!(euler(r"\lambda_3 - \lambda_2"), Verified);
    assert_eq!(euler(r"\lambda_2 - \lambda_3"), Refuted);
    assert_eq!(euler(r"\lambda_3 - \lambda_1"), Refuted);
    let mut lawless = claims.clone();
    lawless.as_object_mut().unwrap().remove("laws");
    let first = r"\lambda_1 \dot\omega_1 + (\lambda_3 - \lambda_2) \omega_2 \omega_3 = N_1";
    assert_eq!(verdict(&lawless, &[law, first], json!({})), Refuted);
}

#[test]
fn vectors_keep_to_vectors() {
    let vectors = json!({ "constants": { r"\vec a, \vec b, \vec c": "any", "k": "> 0" } });
    let of = |latex: &str| verdict(&vectors, &[latex], json!({}));
    let of_three = |middle: &str| of(&format!(r"\vec a \times (\vec b \times \vec c) = {middle}"));
    assert_eq!(of_three(r"(\vec a \cdot \vec c) \vec b - (\vec a \cdot \vec b) \vec c"), Verified);
    assert_eq!(of_three(r"(\vec a \cdot \vec b) \vec c - (\vec a \cdot \vec c) \vec b"), Refuted);
    assert_eq!(of_three(r"(\vec a \times \vec b) \times \vec c"), Refuted);
    assert_eq!(of(r"\vec a \cdot \vec b = \vec a \times \vec b"), Unreadable);
    assert_eq!(of(r"\vec a + k = \vec b"), Unreadable);
    assert_eq!(of(r"\vec a \times \vec a = \vec 0"), Verified);
    assert_eq!(of(r"\vec a = \vec a"), Undecided);
}

/// A body that no torque acts on, by Euler's law; "torque free" as people write it.
fn freely(throughout: &[&str], display: &str, seed: u64) -> Verdict {
    let claims = json!({
        "indices": { "a": "1..3" },
        "constants": { "I_1, I_2, I_3": "> 0" },
        "varies with time": { r"\vec\omega, \vec M": "any" },
        "axes": { r"\vec e_a": r"turning with \vec\omega" },
        "components": { r"\vec\omega, \vec M, \vec L": r"along \vec e_a" },
        "define": { r"\vec L": r"\sum_a I_a \omega_a \vec e_a" },
        "laws": { "torque": "1" },
        "equations": { "2": { "throughout": throughout } },
    });
    let notes = numbered(&[r"\frac{d\vec L}{dt} = \vec M", display]);
    let found = seeded(seed, &claims, &notes, &Registry::standard(), Some("2"));
    outcome(&found.unwrap_or_else(|error| panic!("{error}")).equations[0].finding)
}

#[test]
fn the_free_symmetric_body_precesses_at_every_seed() {
    let precession = |rate: &str| format!(r"\dot\omega_1 = -\frac{{{rate}}}{{I_1}} \omega_2 \omega_3");
    for seed in 1..=6 {
        assert_eq!(freely(&[r"\vec M = \vec 0", "I_1 = I_2"], &precession("I_3 - I_1"), seed), Verified, "seed {seed}");
    }
    for free in ["M_1 = M_2 = M_3 = 0", "M_a = 0"] {
        assert_eq!(freely(&[free, "I_1 = I_2"], &precession("I_3 - I_1"), 1), Verified, "{free}");
    }
    assert_eq!(freely(&["M_a = 0", "I_1 = I_2"], &precession("I_3 + I_1"), 1), Refuted);
}

#[test]
fn the_energy_of_a_free_body_is_constant() {
    let energy =
        |third: &str| format!(r"T = \frac12 (I_1 \omega_1^2 + I_2 \omega_2^2 + {third} \omega_3^2) = \text{{const}}");
    assert_eq!(freely(&["M_1 = M_2 = M_3 = 0"], &energy("I_3"), 1), Verified);
    assert_eq!(freely(&["M_1 = M_2 = M_3 = 0"], &energy("I_1"), 1), Refuted);
    // Two components that vanish are not the vector.
    assert_eq!(freely(&["M_1 = M_2 = 0"], &energy("I_3"), 1), Refuted);
}
