//! Particles that obey a law: what follows from it, what does not, and what hypotheses about their forces add.

use onshell::check::Verdict::{self, Definition, Law, Refuted, Undecided, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{assuming, document, numbered, outcome, verdict, with};

/// Particles whose forces act in pairs.
fn particles() -> Json {
    json!({
        "indices": { "i, j": "1..n" },
        "varies with time": { r"\vec r_i": "any", r"\vec F_{ij}": "any" },
        "constants": { "m_i": "> 0" },
        "define": { r"\vec F_i": r"\sum_{j \neq i} \vec F_{ij}", r"\vec p_i": r"m_i \dot{\vec r}_i" },
        "laws": { "Newton's second law": "1" },
    })
}

const LAW: &str = r"\vec F_i = \dot{\vec p}_i";
const THIRD_LAW: &str = r"\vec F_{ij} = -\vec F_{ji}";
const CENTRAL: &str = r"\vec F_{ij} \propto \vec r_j - \vec r_i";

/// The verdict on the second display, the first being a law.
fn second(claims: &Json, law: &str, latex: &str, claim: Json) -> Verdict {
    let claims = with(claims, "equations", json!({ "2": claim }));
    let found = document(&claims, &numbered(&[law, latex]), &Registry::standard(), Some("2"));
    outcome(&found.unwrap_or_else(|error| panic!("{latex}: {error}")).equations[0].finding)
}

fn follows(latex: &str, assume: &[&str]) -> Verdict {
    second(&particles(), LAW, latex, assuming(assume))
}

#[test]
fn a_law_says_how_particles_are_accelerated() {
    assert_eq!(follows(r"m_i \ddot{\vec r}_i = \sum_{j \neq i} \vec F_{ij}", &[]), Verified);
    assert_eq!(follows(r"m_i \ddot{\vec r}_i = -\sum_{j \neq i} \vec F_{ij}", &[]), Refuted);
    assert_eq!(follows(r"m_i \ddot{\vec r}_i = 2 \sum_{j \neq i} \vec F_{ij}", &[]), Refuted);
    assert_eq!(follows(r"m_i \dot{\vec r}_i = \sum_{j \neq i} \vec F_{ij}", &[]), Refuted);
    assert_eq!(follows(r"m_i \ddot{\vec r}_i = \sum_{j \neq i} \vec F_{ji}", &[]), Refuted);
    // The next derivative follows too.
    assert_eq!(follows(r"m_i \dddot{\vec r}_i = \sum_{j \neq i} \dot{\vec F}_{ij}", &[]), Verified);
    assert_eq!(follows(r"m_i \dddot{\vec r}_i = \sum_{j \neq i} \vec F_{ij}", &[]), Refuted);
}

#[test]
fn without_its_law_the_same_claim_is_false() {
    let mut lawless = particles();
    lawless.as_object_mut().unwrap().remove("laws");
    let accelerated = r"m_i \ddot{\vec r}_i = \sum_{j \neq i} \vec F_{ij}";
    assert_eq!(second(&particles(), LAW, accelerated, json!({})), Verified);
    assert_eq!(second(&lawless, LAW, accelerated, json!({})), Refuted);
}

#[test]
fn a_law_is_taken_for_granted_and_nothing_that_can_be_tested_is_one() {
    let verdict = |claims: &Json, law: &str| {
        let found = document(claims, &numbered(&[law]), &Registry::standard(), Some("1"));
        found.map(|document| outcome(&document.equations[0].finding)).map_err(|error| error.to_string())
    };
    assert_eq!(verdict(&particles(), LAW), Ok(Law));
    // This holds for any particles.
    let identity = verdict(&particles(), r"\vec p_i = m_i \dot{\vec r}_i");
    assert!(identity.as_ref().map_or(true, |found| *found != Law), "{identity:?}");
}

#[test]
fn a_law_does_not_excuse_what_it_does_not_imply() {
    // Any displacement of all particles obeys the law as well.
    assert_eq!(follows(r"\sum_i m_i \vec r_i = \vec 0", &[]), Refuted);
    assert_eq!(follows(r"\dot{\vec p}_1 = \dot{\vec p}_2", &[]), Refuted);
}

#[test]
fn momentum_needs_the_third_law() {
    assert_eq!(follows(r"\sum_i \dot{\vec p}_i = 0", &[THIRD_LAW]), Verified);
    assert_eq!(follows(r"\sum_i \dot{\vec p}_i = 0", &[]), Refuted);
    // Equal forces are not opposite ones.
    assert_eq!(follows(r"\sum_i \dot{\vec p}_i = 0", &[r"\vec F_{ij} = \vec F_{ji}"]), Refuted);
    assert_eq!(follows(r"\sum_i \ddot{\vec r}_i = 0", &[THIRD_LAW]), Refuted);
}

#[test]
fn conserved_along_the_motion_that_the_law_gives() {
    let conserved = |what: &str, assume: &[&str]| {
        let claim = with(&assuming(assume), "conserved", json!(what));
        second(&particles(), LAW, r"\sum_i \vec p_i = \sum_i m_i \dot{\vec r}_i", claim)
    };
    assert_eq!(conserved(r"\sum_i \vec p_i", &[THIRD_LAW]), Verified);
    assert_eq!(conserved(r"\sum_i \vec p_i", &[]), Refuted);
    assert_eq!(conserved(r"\sum_i \vec r_i \times \vec p_i", &[THIRD_LAW, CENTRAL]), Verified);
    assert_eq!(conserved(r"\sum_i \vec r_i \times \vec p_i", &[THIRD_LAW]), Refuted);
    assert_eq!(conserved(r"\sum_i \vec r_i \times \vec p_i", &[CENTRAL]), Refuted);
    // What never varies is no constant of the motion.
    assert_ne!(conserved(r"\sum_i m_i", &[THIRD_LAW]), Verified);
}

#[test]
fn a_symmetry_holds_for_all_members_and_no_other_symmetry_does() {
    let holds = |latex: &str, assume: &[&str]| follows(latex, assume);
    let sum = |sign: &str| format!(r"\sum_i \sum_{{j \neq i}} (\vec F_{{ij}} {sign} \vec F_{{ji}}) = \vec 0");
    assert_eq!(holds(&sum("+"), &[THIRD_LAW]), Verified);
    // Σᵢⱼ Fᵢⱼ − Fⱼᵢ vanishes whatever the forces are.
    assert_eq!(holds(&sum("-"), &[]), Verified);
    assert_eq!(holds(r"\vec F_{12} - \vec F_{21} = \vec 0", &[THIRD_LAW]), Refuted);
    assert_eq!(holds(r"\vec F_{12} - \vec F_{21} = 2 \vec F_{12}", &[THIRD_LAW]), Verified);
    assert_eq!(holds(r"\vec F_{12} - \vec F_{21} = 2 \vec F_{12}", &[]), Refuted);
}

#[test]
fn proportional_is_a_direction_and_not_a_length() {
    let pair = |latex: &str| follows(latex, &[CENTRAL]);
    assert_eq!(pair(r"\vec F_{12} \times (\vec r_2 - \vec r_1) = \vec 0"), Verified);
    assert_eq!(pair(r"\vec F_{12} \times (\vec r_2 + \vec r_1) = \vec 0"), Refuted);
    assert_eq!(pair(r"\vec F_{12} = \vec r_2 - \vec r_1"), Refuted);
    assert_eq!(pair(r"\vec F_{12} \cdot (\vec r_2 - \vec r_1) > 0"), Refuted);
    assert_eq!(follows(r"\vec F_{12} \times (\vec r_2 - \vec r_1) = \vec 0", &[]), Refuted);
}

#[test]
fn a_value_is_that_value() {
    let spring = r"\vec F_{ij} = \vec r_j - \vec r_i";
    assert_eq!(follows(r"m_i \ddot{\vec r}_i = \sum_{j \neq i} (\vec r_j - \vec r_i)", &[spring]), Verified);
    assert_eq!(follows(r"m_i \ddot{\vec r}_i = \sum_{j \neq i} (\vec r_i - \vec r_j)", &[spring]), Refuted);
    // Springs obey the third law, and their momentum is kept.
    assert_eq!(follows(r"\sum_i \dot{\vec p}_i = 0", &[spring]), Verified);
    assert_eq!(follows(r"\sum_i \dot{\vec p}_i = 0", &[r"\vec F_{ij} = \vec r_j"]), Refuted);
}

#[test]
fn a_hypothesis_that_is_the_claim_is_no_evidence() {
    assert_eq!(follows(r"\vec F_{ij} = -\vec F_{ji}", &[THIRD_LAW]), Undecided);
}

#[test]
fn sums_leave_out_what_they_say() {
    let claims = json!({
        "indices": { "i, j": "1..n" },
        "constants": { r"\vec F_{ij}": "any", "m_i": "> 0" },
    });
    let verdict = |latex: &str| {
        let found = document(&claims, &numbered(&[latex]), &Registry::standard(), None);
        outcome(&found.unwrap_or_else(|error| panic!("{latex}: {error}")).equations[0].finding)
    };
    let without = r"\sum_i \sum_{j \neq i} \vec F_{ij} = \sum_j \sum_{i \neq j} \vec F_{ij}";
    assert_eq!(verdict(without), Verified);
    assert_eq!(verdict(r"\sum_i \sum_{j \neq i} \vec F_{ij} = \sum_i \sum_j \vec F_{ij}"), Refuted);
    assert_eq!(
        verdict(r"\sum_i \sum_{j \neq i} \vec F_{ij} = \sum_i \sum_j \vec F_{ij} - \sum_i \vec F_{ii}"),
        Verified
    );
    // Sums do not multiply term by term.
    assert_eq!(verdict(r"(\sum_i m_i)^2 = \sum_i m_i^2"), Refuted);
    assert_eq!(verdict(r"(\sum_i m_i)^2 = \sum_i \sum_j m_i m_j"), Verified);
    // Labels that do not meet are a fault of type; one that only one side has is for all.
    assert_eq!(verdict("m_i = m_j"), Verdict::Unreadable);
    assert_eq!(verdict(r"\sum_i m_i = m_i"), Refuted);
}

#[test]
fn for_each_puts_the_index_where_the_print_leaves_it_out() {
    let verdict = |latex: &str| {
        let claims = with(&particles(), "equations", json!({ "2": { "for each": "i" } }));
        let third = r"\sum_i \vec L_i = \sum_i m_i \vec r_i \times \dot{\vec r}_i";
        let found = document(&claims, &numbered(&[LAW, latex, third]), &Registry::standard(), None);
        let found = found.unwrap_or_else(|error| panic!("{latex}: {error}"));
        (outcome(&found.equations[1].finding), outcome(&found.equations[2].finding))
    };
    assert_eq!(verdict(r"\vec L = \vec r \times \vec p"), (Definition, Verified));
    assert_eq!(verdict(r"\vec L = \vec p \times \vec r").1, Refuted);
    assert_eq!(second(&particles(), LAW, r"\vec L = \vec r \times \vec p", json!({})), Unreadable);
}

#[test]
fn sums_over_pairs_and_over_some_of_the_values() {
    let claims = json!({
        "indices": { "i, j": "1..n" },
        "constants": { "m_i": "> 0" },
        "varies with time": { r"\vec r_i, \vec F_{ij}": "any" },
    });
    let verdict = |latex: &str| verdict(&claims, &[latex], json!({}));
    for (right, wrong) in [
        (
            r"\left(\sum_i m_i\right)^2 = \sum_i m_i^2 + 2 \sum_{i<j} m_i m_j",
            r"\left(\sum_i m_i\right)^2 = \sum_i m_i^2 + \sum_{i<j} m_i m_j",
        ),
        (
            r"\sum_i \sum_{j \neq i} \vec F_{ij} = \sum_{i<j} (\vec F_{ij} + \vec F_{ji})",
            r"\sum_i \sum_{j \neq i} \vec F_{ij} = \sum_{i<j} (\vec F_{ij} - \vec F_{ji})",
        ),
        // The first has nobody before it: an empty sum of vectors is the zero vector.
        (
            r"\sum_i \sum_{j<i} (\vec r_i + \vec r_j) = (n - 1) \sum_i \vec r_i",
            r"\sum_i \sum_{j<i} (\vec r_i + \vec r_j) = n \sum_i \vec r_i",
        ),
        (
            r"\sum_i \sum_{j>i} m_i \vec F_{ij} = \sum_{i<j} m_i \vec F_{ij}",
            r"\sum_i \sum_{j>i} m_i \vec F_{ij} = \sum_{j<i} m_i \vec F_{ij}",
        ),
        (r"\sum_{i=2}^n m_i = \sum_i m_i - m_1", r"\sum_{i=2}^n m_i = \sum_i m_i - m_2"),
        (
            r"\sum_{i=1}^{n-1} m_i + \sum_{i=2}^{n} m_i = \sum_i m_i + \sum_{i=2}^{n-1} m_i",
            r"\sum_{i=1}^{n-1} m_i = \sum_i m_i",
        ),
    ] {
        assert_eq!(verdict(right), Verified, "{right}");
        assert_eq!(verdict(wrong), Refuted, "{wrong}");
    }
}

/// Particles at rest, and two vectors beside them.
fn crowd(latex: &str) -> Verdict {
    let claims = json!({
        "indices": { "i, j": "1..n" },
        "constants": { "m_i": "> 0", "q_i": "any", r"\vec r_i, \vec u, \vec w": "any" },
    });
    verdict(&claims, &[latex], json!({}))
}

#[test]
fn an_inequality_of_vectors_is_tried_where_they_are_special() {
    for (only_in_general, always) in [
        // A vector that is zero, equal or opposite to another, or parallel to it.
        (r"|\vec u| > 0", r"|\vec u| \geq 0"),
        (r"|\vec u - \vec w| > 0", r"|\vec u - \vec w| \geq 0"),
        (r"|\vec u + \vec w| > 0", r"|\vec u + \vec w| \geq 0"),
        (r"|\vec u| + |\vec w| > |\vec u + \vec w|", r"|\vec u| + |\vec w| \geq |\vec u + \vec w|"),
        (r"|\vec u \times \vec w| > 0", r"|\vec u \times \vec w| \geq 0"),
    ] {
        assert_eq!((crowd(only_in_general), crowd(always)), (Refuted, Verified), "{only_in_general}");
    }
}

#[test]
fn vectors_differ_where_one_component_does() {
    let claims = json!({
        "varies with time": { r"\vec r, \vec v": "any" },
        "axes": { r"\hat x, \hat y, \hat z": "fixed" },
    });
    let verdict = |latex: &str, claim| verdict(&claims, &[latex], claim);
    assert_eq!(verdict(r"\hat x \neq \hat y", json!({})), Verified, "they share their third component");
    assert_eq!(verdict(r"\vec r \neq \vec v", json!({ "assume": r"\vec r = \vec v" })), Refuted);
    assert_eq!(verdict(r"\vec r \times \vec v \neq 0", json!({ "assume": r"\vec r = 2\vec v" })), Refuted);
}

#[test]
fn an_inequality_of_families_is_tried_where_members_are_special() {
    for (only_in_general, always) in [
        // All members zero, all alike, all on one line, all in one plane.
        (r"\sum_i q_i^2 > 0", r"\sum_i q_i^2 \geq 0"),
        (r"\sum_i (m_i - m_1)^2 > 0", r"\sum_i (m_i - m_1)^2 \geq 0"),
        (r"\sum_i |\vec r_i - \vec r_1|^2 > 0", r"\sum_i |\vec r_i - \vec r_1|^2 \geq 0"),
        (r"\sum_i |\vec r_1 \times \vec r_i|^2 > 0", r"\sum_i |\vec r_1 \times \vec r_i|^2 \geq 0"),
        (
            r"((\vec r_2 - \vec r_1) \cdot ((\vec r_3 - \vec r_1) \times \vec r_1))^2 > 0",
            r"((\vec r_2 - \vec r_1) \cdot ((\vec r_3 - \vec r_1) \times \vec r_1))^2 \geq 0",
        ),
    ] {
        assert_eq!((crowd(only_in_general), crowd(always)), (Refuted, Verified), "{only_in_general}");
    }
}

/// A factor that vanishes at the numbers of members that anybody would try. What passes says which were tried.
#[test]
fn a_family_is_tried_with_more_members_than_can_be_guessed() {
    let judge = |factor: &str, claim: Json| {
        let claims = json!({
            "indices": { "i": "1..n" }, "constants": { "a, x_i": "any" }, "equations": { "1": claim },
        });
        let latex = format!(r"\left|\sum_i x_i\right| = \left|\sum_i x_i\right| + a {factor}");
        let found = document(&claims, &numbered(&[&latex]), &Registry::standard(), None).unwrap();
        found.equations[0].finding.clone()
    };
    let up_to_nine: String = (1..=9).map(|n| format!("(n - {n})")).collect();
    let found = judge(&up_to_nine, json!({ "expect": "refuted", "because": "it fails for ten members" }));
    assert_eq!(found.verdict, Refuted, "{found:?}");
}
