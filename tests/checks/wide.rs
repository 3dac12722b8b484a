//! Equalities that are true of numbers of order one, and that are claimed of all.

use onshell::check::Finding;
use onshell::check::Verdict::{Certified, Domain, Refuted, Verified};
use serde_json::{Value as Json, json};

use crate::support::{assuming, equation};

fn claims() -> Json {
    json!({ "constants": { "x, y": "any", "p, q": "> 0", r"\theta": "angle", r"\alpha": r"(0, \pi)" } })
}

fn under(latex: &str, hypotheses: &[&str]) -> Finding {
    equation(&claims(), &[latex], assuming(hypotheses)).finding
}

#[test]
fn another_branch_is_far_away() {
    for (latex, where_it_holds) in [
        (r"\sqrt{(p - 5)^2} = 5 - p", "p < 5"),
        ("|p - 5| = 5 - p", "p < 5"),
        (r"|\frac{p}{100} - 1| = 1 - \frac{p}{100}", "p < 100"),
        (r"\arccos(\cos p) = p", "p < 3"),
        (r"\sqrt{2 + 2\cos\theta} = 2\cos\frac\theta2", "-3 < \\theta < 3"),
        (r"\ln\sqrt{(p - 5)^2} = \ln(5 - p)", "p < 5"),
        (r"\sqrt{4\pi^2 - 4\pi\theta + \theta^2} = 2\pi - \theta", r"\theta < 6"),
        (r"|\theta - 4| = 4 - \theta", r"\theta < 4"),
    ] {
        let found = under(latex, &[]);
        assert!(!found.verdict.passes(), "{latex}: {found:?}");
        assert!(found.counterexample.is_some(), "{latex}: {found:?}");
        // The twin: on the branch on which it is true it passes.
        assert!(under(latex, &[where_it_holds]).verdict.holds(), "{latex}: {:?}", under(latex, &[where_it_holds]));
    }
    assert_eq!(under("|p - 5| = 5 - p", &[]).verdict, Refuted);
}

#[test]
fn one_side_ends_far_away() {
    for (latex, where_it_holds) in
        [(r"\ln((x + 4)^2) = 2\ln(x + 4)", "x > -4"), (r"\sqrt{1 - \frac{p}{10}}^2 = 1 - \frac{p}{10}", "p < 10")]
    {
        assert_eq!(under(latex, &[]).verdict, Domain, "{latex}: {:?}", under(latex, &[]));
        let found = under(latex, &[where_it_holds]);
        assert!(found.verdict.holds(), "{latex}: {found:?}");
    }
    assert_eq!(under(r"\ln((x + 4)(y + 4)) = \ln(x + 4) + \ln(y + 4)", &[]).verdict, Domain);
}

#[test]
fn what_is_true_everywhere_stays_so() {
    for (latex, verdict) in [
        (r"\sqrt{x^2} = |x|", Verified),
        ("|x| |y| = |x y|", Verified),
        (r"\sqrt{p} \sqrt{q} = \sqrt{p q}", Certified),
        (r"\ln(p q) = \ln p + \ln q", Certified),
        (r"\arctan(\tan x) = \arctan(\frac{\sin x}{\cos x})", Verified),
        (r"\sqrt{\sin^2\alpha} = \sin\alpha", Verified),
        // Overflow is no end of a formula, and rounding no difference.
        (r"\sqrt{e^{-2x^2}} e^{x^2} = 1", Verified),
        (r"\ln(e^{7x}) = 7\ln(e^{x})", Verified),
        (r"\sqrt{p^2 + 1} - p = \frac{1}{\sqrt{p^2 + 1} + p}", Certified),
    ] {
        let found = under(latex, &[]);
        assert!(found.verdict.holds(), "{latex}: {found:?}");
        if verdict == Certified {
            assert_eq!(found.verdict, verdict, "{latex}: {found:?}");
        }
    }
}
