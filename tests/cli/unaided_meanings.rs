//! Notes without a claims file: what a display says is certified of what its author means, or of nothing.

use crate::support::verdicts;
use crate::unaided::page;

fn last(name: &str, displays: &[&str]) -> String {
    verdicts(&format!("unaided-meanings-{name}"), &page(displays)).pop().unwrap_or_default()
}

fn passes(verdict: &str) -> bool {
    ["certified", "verified"].contains(&verdict)
}

/// Nothing says that q is constant, so q = s r/2 does not follow; the identity with a constant k does.
#[test]
fn a_name_under_a_derivative_may_vary_too() {
    for (law, false_conclusion) in [
        (r"\frac{1}{r^2}\frac{d}{dr}\left(r^2 q\right) = s", r"q = \frac{s r}{2}"),
        (r"\frac{1}{r}\frac{d}{dr}(r B) = \mu_0 J", r"B = \mu_0 J r"),
        (
            r"\frac{\partial}{\partial r}\left(r^2 E_r\right) = \frac{\rho r^2}{\epsilon_0}",
            r"E_r = \frac{\rho r}{2\epsilon_0}",
        ),
    ] {
        assert!(!passes(&last("derivative", &[law, false_conclusion])), "{law}: {false_conclusion}");
        assert_eq!(last("derivative-alone", &[law]), "undecided", "{law}");
    }
    let identity = r"\frac{d}{dx}\left(\frac12 k x^2\right) = k x";
    assert_eq!(last("derivative-identity", &[identity]), "certified");
    assert_eq!(last("derivative-slip", &[&identity.replace("= k x", "= 2 k x")]), "refuted");
}

/// c_j has another value in each term.
#[test]
fn a_coefficient_with_the_letter_of_a_sum_is_no_constant() {
    let series = r"v(\rho) = \sum_{j=0}^{\infty} c_j \rho^j";
    assert!(!passes(&last("series", &[series, r"v = \frac{c_j}{1 - \rho}"])));
    let geometric = r"v(\rho) = \sum_{j=0}^{\infty} c \rho^j";
    assert!(passes(&last("geometric", &[geometric, r"v = \frac{c}{1 - \rho}"])));
}

#[test]
fn a_polynomial_of_a_cosine_is_no_product() {
    for function in [r"P_l^m(\cos\theta)", r"P_2(\cos\theta)"] {
        let (name, _) = function.split_once('(').expect("a parenthesis");
        let quotient = format!(r"\frac{{Y}}{{\cos\theta}} = c {name}");
        assert!(!passes(&last("polynomial", &[&format!("Y = c {function}"), &quotient])), "{function}");
    }
    assert!(passes(&last("product", &[r"Y = c P_2 \cos\theta", r"\frac{Y}{\cos\theta} = c P_2"])));
}

#[test]
fn a_lagrangian_may_be_defined_with_a_colon() {
    let lagrangian = r"\mathcal{L} := \frac{m}{2} l^2 \dot\theta^2 + m g l \cos\theta";
    assert_eq!(last("colon", &[lagrangian, r"l \ddot\theta + g \sin\theta = 0"]), "certified");
    assert_eq!(last("colon-slip", &[lagrangian, r"l \ddot\theta - g \sin\theta = 0"]), "refuted");
}

/// Of two formulas for one name neither is called wrong alone.
#[test]
fn two_formulas_for_one_name_contradict_each_other() {
    let found = verdicts(
        "unaided-meanings-twice",
        &page(&[r"r_c = \frac{L^2}{GMm^2}", r"\frac{GMm}{r^2} - \frac{L^2}{mr^3} = 0", r"r_c = \frac{L^2}{GMm}"]),
    );
    assert!(!found.contains(&"refuted".to_owned()) && !passes(&found[2]), "{found:?}");
}
