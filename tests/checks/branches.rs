//! Branches and domains that no random state meets: narrow, far away, or beyond a double root.

use onshell::check::Finding;
use onshell::check::Verdict::{Domain, Refuted};
use serde_json::{Value as Json, json};

use crate::support::{assuming, equation};

fn claims() -> Json {
    json!({ "constants": { "x, y": "any", "p": "> 0", "u": "(1, 2)", "v": "(0, 1.01)" } })
}

fn under(latex: &str, hypotheses: &[&str]) -> Finding {
    equation(&claims(), &[latex], assuming(hypotheses)).finding
}

#[test]
fn a_narrow_or_far_branch_is_found() {
    for (latex, where_it_holds) in [
        ("|x^2 - 9x + 20| = x^2 - 9x + 20", "x < 4"),
        ("|x^2 - 90x + 2024.9| = x^2 - 90x + 2024.9", "x < 40"),
        (r"\sqrt{(x - 2000)^2} = 2000 - x", "x < 2000"),
        (r"\sqrt{(p - 10^6)^2} = 10^6 - p", "p < 1000000"),
        (r"\sqrt{x^2 - 30000x + 225000000} = 15000 - x", "x < 15000"),
        ("|u - v| = u - v", "v < 1"),
        (r"|\sin x - 0.999999999| = 0.999999999 - \sin x", "\\sin x < 0.9"),
        (r"\sqrt{(100\sin x - 99.9999)^2} = 99.9999 - 100\sin x", "\\sin x < 0.9"),
        ("|(x - 3)(x - 3.0000000001)| = (x - 3)(x - 3.0000000001)", "x < 2"),
        (r"|\sin x + \sin y - 1.999999| = 1.999999 - \sin x - \sin y", "\\sin x < 0.9"),
    ] {
        let found = under(latex, &[]);
        assert_eq!(found.verdict, Refuted, "{latex}: {found:?}");
        assert!(found.counterexample.is_some(), "{latex}: {found:?}");
        let twin = under(latex, &[where_it_holds]);
        assert!(twin.verdict.holds(), "{latex} if {where_it_holds}: {twin:?}");
    }
}

#[test]
fn an_interval_without_a_value_is_found() {
    for (latex, where_it_holds) in [
        (r"\sqrt{(x - 5)^2 - 1} \sqrt{(x - 5)^2 - 1} = (x - 5)^2 - 1", "x < 4"),
        (r"\ln(x^2 - 9x + 20.2) = \ln|x^2 - 9x + 20.2|", "x < 4"),
        (r"\sqrt{(p - 3000)^2 - 4}^2 = (p - 3000)^2 - 4", "p < 2000"),
    ] {
        let found = under(latex, &[]);
        assert_eq!(found.verdict, Domain, "{latex}: {found:?}");
        let twin = under(latex, &[where_it_holds]);
        assert!(twin.verdict.holds(), "{latex} if {where_it_holds}: {twin:?}");
    }
}

#[test]
fn what_keeps_its_branch_stays_so() {
    for latex in [
        "|x^2 - 9x + 20.3| = x^2 - 9x + 20.3",
        r"\sqrt{(x - 2000)^2} = |x - 2000|",
        r"\sqrt{(x - 5)^2 + 1} \sqrt{(x - 5)^2 + 1} = (x - 5)^2 + 1",
        r"\ln(x^2 + y^2 + 1) = \frac12 \ln((x^2 + y^2 + 1)^2)",
        "|u - v + 0.02| = u - v + 0.02",
        r"|\sin x - 1.000000001| = 1.000000001 - \sin x",
        "|(x - 3)^2 (y - 2)^2| = (x - 3)^2 (y - 2)^2",
    ] {
        let found = under(latex, &[]);
        assert!(found.verdict.holds(), "{latex}: {found:?}");
    }
}

#[test]
fn isolated_points_are_excepted() {
    for (latex, place) in [
        (r"\frac{x^2}{x} = x", Some("except where x = 0")),
        (r"\frac{x^2 - 1}{x - 1} = x + 1", Some("except where x − 1 = 0")),
        (r"\frac{\sin x}{x} x = \sin x", Some("except where x = 0")),
        (r"\frac{x^2 y}{x^2} = y", Some("except where x^2 = 0")),
        // Where both sides have no value, where the divisor does not vanish, and where the range excludes it.
        (r"\frac{2}{x} y = \frac{y}{x} + \frac{y}{x}", None),
        (r"\frac{x^4 - 1}{x^2 + 1} = x^2 - 1", None),
        (r"\frac{p^2}{p} = p", None),
        (r"\frac{u^2 - 4}{u - 2} = u + 2", None),
    ] {
        let found = under(latex, &[]);
        assert!(found.verdict.holds(), "{latex}: {found:?}");
        match place {
            Some(place) => assert!(found.message.contains(place), "{latex}: {found:?}"),
            None => assert!(!found.message.contains("except"), "{latex}: {found:?}"),
        }
    }
}

/// Between the two roots of a radicand a side has no value, however close they are.
#[test]
fn a_narrow_gap_in_a_domain_is_found() {
    for (latex, verdict) in [
        (r"\sqrt{(x - 1)(x - 1.000001)}^2 = (x - 1)(x - 1.000001)", Domain),
        (r"\sqrt{(x - 3)(x - 3.000000001)} \sqrt{(x - 3)(x - 3.000000001)} = (x - 3)(x - 3.000000001)", Domain),
        (r"e^{\ln((x - 2)(x - 2.0000001))} = (x - 2)(x - 2.0000001)", Domain),
    ] {
        assert_eq!(under(latex, &[]).verdict, verdict, "{latex}");
    }
    // The same without a gap, or beyond it.
    for (latex, hypotheses) in [
        (r"\sqrt{(x - 1)^2}^2 = (x - 1)^2", &[][..]),
        (r"\sqrt{(x - 1)(x - 1.000001)}^2 = (x - 1)(x - 1.000001)", &["x > 2"]),
    ] {
        let found = under(latex, hypotheses);
        assert!(found.verdict.holds(), "{latex}: {found:?}");
    }
}
