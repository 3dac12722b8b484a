//! What is said of n things is said of any number of them, and not of three or four alone.

use onshell::check::Finding;
use onshell::check::Verdict::{Certified, Refuted, Verified};
use serde_json::{Value as Json, json};

use crate::support::{assuming, equation};

fn things() -> Json {
    json!({
        "indices": { "i, j, k": "1..n" },
        "constants": { "m_i, a": "> 0", "q_i": "any", r"\vec R": "any" },
        "varies with time": { r"\vec r_i, \vec F_{ij}": "any" },
        "define": { "M": r"\sum_i m_i", r"\vec r_{cm}": r"\frac{1}{M} \sum_i m_i \vec r_i" },
    })
}

fn assuming_of(latex: &str, hypotheses: &[&str]) -> Finding {
    equation(&things(), &[latex], assuming(hypotheses)).finding
}

fn of(latex: &str) -> Finding {
    assuming_of(latex, &[])
}

/// (n − 1)(n − 2)…, up to so many factors: 0 for as many numbers of things.
fn vanishing(factors: u32) -> String {
    (1..=factors).map(|k| format!("(n - {k})")).collect()
}

#[test]
fn a_number_of_things_is_any_number() {
    for (right, wrong) in [
        // n(n − 1) is 6n − 12 for three and for four, n² is 7n − 12.
        (r"\sum_i \sum_{j \neq i} a = n (n - 1) a", r"\sum_i \sum_{j \neq i} a = (6n - 12) a"),
        (r"\sum_i \sum_j m_i = n M", r"\sum_i \sum_j q_i = (7n - 12) \sum_i \frac{q_i}{n}"),
        (r"\sum_i \sum_{j < i} a = \frac{n (n - 1)}{2} a", r"\sum_i \sum_{j < i} a = (3n - 6) a"),
        (r"\sum_{i=1}^{n-1} \sum_{j=2}^n a = (n - 1)^2 a", r"\sum_{i=1}^{n-1} \sum_{j=2}^n a = (5n - 11) a"),
        (r"\sum_i 2 m_i = 2 M", r"\sum_i m_i = m_1 + m_2 + m_3 + (n - 3) m_4"),
        (r"\sum_i \sum_j \sum_k a = n^3 a", r"\sum_i \sum_j \sum_k a = (12 n^2 - 47 n + 60) a"),
    ] {
        assert_eq!(of(right).verdict, Certified, "{right}: {:?}", of(right));
        let found = of(wrong);
        assert_eq!(found.verdict, Refuted, "{wrong}: {found:?}");
        assert!(found.counterexample.is_some() && found.message.contains("is false for n ="), "{wrong}: {found:?}");
    }
}

#[test]
fn as_many_numbers_are_tried_as_the_sums_are_deep() {
    let sums = [r"\sum_i", r"\sum_i \sum_j", r"\sum_i \sum_{j \neq i} \sum_k"];
    for (depth, sum) in sums.into_iter().enumerate() {
        for factors in 1..=5 {
            let wrong = format!("{sum} a = {sum} a + {} a", vanishing(factors));
            assert_eq!(of(&wrong).verdict, Refuted, "{depth}: {wrong}: {:?}", of(&wrong));
        }
    }
    // More things than there are: the field does not decide, and numbers see no difference.
    let beyond = of(&format!("a = a + {} a", vanishing(9)));
    assert_ne!(beyond.verdict, Certified, "{beyond:?}");
}

#[test]
fn quotients_by_sums_are_certified_and_their_slips_are_not() {
    for (right, wrong) in [
        (
            r"\sum_i m_i (\vec r_i - \vec r_{cm}) = \vec 0",
            r"\sum_i m_i (\vec r_i - \vec r_{cm}) = (n^2 - 7n + 12) \vec R",
        ),
        (
            r"\sum_i \sum_j m_i m_j |\vec r_i - \vec r_j|^2 = 2 M \sum_i m_i |\vec r_i - \vec r_{cm}|^2",
            r"\sum_i \sum_j m_i m_j |\vec r_i - \vec r_j|^2 = (n^2 - 7n + 14) M \sum_i m_i |\vec r_i - \vec r_{cm}|^2",
        ),
        (
            r"\frac{1}{n - 1} \sum_i \sum_{j \neq i} q_j = \sum_i q_i",
            r"\frac{n - 2}{4n - 10} \sum_i \sum_{j \neq i} q_j = \sum_i q_i",
        ),
        (r"\sum_i \frac{m_i}{M} = 1", r"\sum_i \frac{m_i}{M} = (n - 3)(n - 4) + 1"),
    ] {
        assert_eq!(of(right).verdict, Certified, "{right}: {:?}", of(right));
        assert_eq!(of(wrong).verdict, Refuted, "{wrong}: {:?}", of(wrong));
    }
}

#[test]
fn a_hypothesis_about_a_sum_holds_for_any_number() {
    let about_the_origin = [r"\sum_i m_i \vec r_i = \vec 0"];
    let under = |latex: &str| assuming_of(latex, &about_the_origin);
    let right = r"\sum_i m_i |\vec r_i - \vec R|^2 = \sum_i m_i |\vec r_i|^2 + M |\vec R|^2";
    assert_eq!(under(right).verdict, Certified, "{:?}", under(right));
    for factors in 1..=4 {
        let wrong = format!("{right} + {} M", vanishing(factors));
        assert_eq!(under(&wrong).verdict, Refuted, "{wrong}: {:?}", under(&wrong));
    }
    let wrong = r"\sum_i m_i |\vec r_i - \vec R|^2 = \sum_i m_i |\vec r_i|^2 + (n^2 - 7n + 13) M |\vec R|^2";
    assert_eq!(under(wrong).verdict, Refuted, "{:?}", under(wrong));
}

#[test]
fn what_grows_in_no_known_way_is_tried_with_more() {
    let root = of(r"\sqrt{\sum_i \sum_j m_i m_j} = M");
    assert_eq!(root.verdict, Verified, "{root:?}");
    assert!(root.not_certified_because.as_ref().is_some_and(|why| why.contains("numbers of members")), "{root:?}");
    assert_eq!(of(r"\sqrt{\sum_i \sum_j m_i m_j} = (n^2 - 7n + 13) M").verdict, Refuted);
    assert_eq!(of("2^n = 8 (n - 2)").verdict, Refuted);
}

#[test]
fn an_inequality_is_tried_with_fewer_and_with_more() {
    for (right, wrong) in [
        (r"n \geq 1", r"n \leq 4"),
        (r"n^2 + 12 > 6n", r"n^2 + 12 \leq 7n"),
        (r"(\sum_i q_i)^2 \leq n \sum_i q_i^2", r"(\sum_i q_i)^2 \leq 4 \sum_i q_i^2"),
        (r"\sum_i q_i^2 \geq \frac{1}{n} (\sum_i q_i)^2", r"\sum_i q_i^2 \geq \frac14 (\sum_i q_i)^2"),
    ] {
        assert_eq!(of(right).verdict, Verified, "{right}: {:?}", of(right));
        assert_eq!(of(wrong).verdict, Refuted, "{wrong}: {:?}", of(wrong));
    }
}
