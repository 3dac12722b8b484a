//! True statements of textbooks with branches: inverse functions, roots, half angles, logarithms, phases.
//!
//! An author who writes φ = arctan(y/x) means the angle of the point (x, y). Where the print holds on one branch only, the
//! finding names the condition, and never calls the line wrong. Beside each kind stands a slip, which must be refuted.

use onshell::check::Finding;
use onshell::check::Verdict::{Domain, Refuted};
use serde_json::{Value as Json, json};

use crate::support::{assuming, equation};

/// The finding on an equation beside definitions.
fn beside(definitions: &[(&str, &str)], latex: &str) -> Finding {
    let defined: serde_json::Map<String, Json> =
        definitions.iter().map(|(name, formula)| ((*name).to_owned(), json!(formula))).collect();
    let claims = json!({
        "constants": { "x, y, z, a, b, q, Q, u": "any", "m, k, w, s, h": "> 0", "v": "(-1, 1)", "A, B": "angle", "C": "(-3, 3)" },
        "define": defined
    });
    equation(&claims, &[latex], assuming(&[])).finding
}

type Group = (&'static [(&'static str, &'static str)], &'static [&'static str], &'static [&'static str]);

/// Definitions, true statements about what they define, and slips in them.
const ON_ONE_BRANCH: [Group; 16] = [
    (
        &[("r", r"\sqrt{x^2 + y^2}"), (r"\varphi", r"\arctan\frac{y}{x}")],
        &[
            r"x = r\cos\varphi",
            r"y = r\sin\varphi",
            r"x - y = r(\cos\varphi - \sin\varphi)",
            r"r = x\cos\varphi + y\sin\varphi",
        ],
        &[r"x = -r\cos\varphi", r"x = r\sin\varphi", r"y = -r\sin\varphi", r"r = x\cos\varphi - y\sin\varphi"],
    ),
    (
        &[(r"\varphi", r"\arctan\frac{y}{x}")],
        &[r"x = \sqrt{x^2 + y^2}\cos\varphi", r"\sin\varphi = \frac{y}{\sqrt{x^2 + y^2}}"],
        &[r"x = -\sqrt{x^2 + y^2}\cos\varphi", r"\sin\varphi = \frac{x}{\sqrt{x^2 + y^2}}"],
    ),
    (
        &[("r", r"\sqrt{x^2 + y^2}"), (r"\varphi", r"\arcsin\frac{y}{r}")],
        &[r"x = r\cos\varphi"],
        &[r"x = -r\cos\varphi", r"x = 2 r\cos\varphi"],
    ),
    (
        &[("r", r"\sqrt{x^2 + y^2}"), (r"\varphi", r"\arccos\frac{x}{r}")],
        &[r"y = r\sin\varphi", r"\frac{y}{x} = \tan\varphi"],
        &[r"y = -r\sin\varphi", r"y = r\cos\varphi"],
    ),
    (
        &[(r"\alpha", r"\arctan\frac{b}{a}"), ("D", r"\sqrt{a^2 + b^2}")],
        &[r"a\cos u + b\sin u = D\cos(u - \alpha)", r"a\sin u - b\cos u = D\sin(u - \alpha)"],
        &[r"a\cos u + b\sin u = D\cos(u + \alpha)", r"a\cos u + b\sin u = D\sin(u - \alpha)"],
    ),
    (
        &[(r"\delta", r"\arctan\frac{2 y}{x - a}")],
        &[r"\cos\delta = \frac{x - a}{\sqrt{(x - a)^2 + 4 y^2}}"],
        &[r"\cos\delta = \frac{a - x}{\sqrt{(x - a)^2 + 4 y^2}}"],
    ),
    (
        &[("P", r"\frac{m w q^2}{2 \sin^2 Q}")],
        &[r"q = \sqrt{\frac{2 P}{m w}} \sin Q"],
        &[r"q = -\sqrt{\frac{2 P}{m w}} \sin Q", r"q = \sqrt{\frac{P}{m w}} \sin Q"],
    ),
    (&[("p", "m x"), ("E", r"\frac{p^2}{2 m}")], &[r"p = \sqrt{2 m E}"], &[r"p = -\sqrt{2 m E}", r"p = \sqrt{m E}"]),
    (&[("R", r"\sqrt{x^2 + y^2}")], &[r"x = \sqrt{R^2 - y^2}"], &[r"x = -\sqrt{R^2 - y^2}", r"x = \sqrt{R^2 + y^2}"]),
    (
        &[("n", r"\sqrt{\frac{1 - \cos A}{2}}")],
        &[r"n = \sin\frac{A}{2}"],
        &[r"n = -\sin\frac{A}{2}", r"n = \cos\frac{A}{2}"],
    ),
    (&[("c", r"\cos B"), ("n", r"\sqrt{1 - c^2}")], &[r"n = \sin B"], &[r"n = -\sin B"]),
    (
        &[(r"\chi", r"\arctan(x) + \arctan\frac{1}{x}")],
        &[r"\chi = \frac{\pi}{2}"],
        &[r"\chi = -\frac{\pi}{2}", r"\chi = \pi"],
    ),
    (&[], &[r"\arctan x + \arctan\frac{1}{x} = \frac{\pi}{2}"], &[r"\arctan x + \arctan\frac{1}{x} = -\frac{\pi}{2}"]),
    (
        &[],
        &[r"\arctan x + \arctan y = \arctan\frac{x + y}{1 - x y}"],
        &[r"\arctan x + \arctan y = \arctan\frac{x - y}{1 - x y}"],
    ),
    (&[], &[r"2\arctan x = \arctan\frac{2 x}{1 - x^2}"], &[r"2\arctan x = \arctan\frac{2 x}{1 + x^2}"]),
    (&[("g", r"\tan\frac{C}{2}")], &[r"C = 2\arctan g"], &[r"C = -2\arctan g"]),
];

#[test]
fn what_holds_on_one_branch_is_not_called_wrong_and_a_slip_is() {
    for (definitions, statements, slips) in ON_ONE_BRANCH {
        for latex in statements {
            let found = beside(definitions, latex);
            assert!(
                found.verdict == Domain && found.code.word() == "one-branch" || found.verdict.passes(),
                "{latex}: {found:?}"
            );
        }
        for latex in slips {
            assert_eq!(beside(definitions, latex).verdict, Refuted, "{latex}");
        }
    }
}

#[test]
fn the_condition_is_named_and_with_it_the_claim_passes() {
    let definitions = json!({ r"\varphi": r"\arctan\frac{y}{x}", "r": r"\sqrt{x^2 + y^2}" });
    let claims = json!({ "constants": { "x, y": "any" }, "define": definitions });
    let found = equation(&claims, &[r"x = r\cos\varphi"], assuming(&[])).finding;
    let said = "holds only where x > 0, because arctan(y/x) lies between −π/2 and π/2; it holds at the ";
    assert!(found.message.starts_with(said), "{found:?}");
    assert!(found.message.ends_with(" sampled states with x > 0, and fails at others"), "{found:?}");
    assert!(found.counterexample.is_some());
    assert!(equation(&claims, &[r"x = r\cos\varphi"], assuming(&["x > 0"])).finding.verdict.holds());
    assert_eq!(equation(&claims, &[r"x = r\cos\varphi"], assuming(&["x < 0"])).finding.verdict, Refuted);
}

#[test]
fn a_condition_that_is_not_proved_is_said_of_the_sampled_states_only() {
    // arctan(tan x) = x fails at x = π + 0.5, where x > 0 and tan x > 0.
    let claims = json!({ "constants": { "x": "any" } });
    let found = equation(&claims, &[r"\arctan(\tan x) = x"], assuming(&[])).finding;
    assert_eq!((found.verdict, found.code.word()), (Domain, "one-branch"), "{found:?}");
    assert!(found.message.contains("arctan(tan(x)) lies between −π/2 and π/2"), "{found:?}");
    assert!(!found.message.contains("holds where"), "{found:?}");
    assert!(found.counterexample.is_some());
    // must-fail case: a slip holds on no branch
    assert_eq!(equation(&claims, &[r"\arctan(\tan x) = 2 x"], assuming(&[])).finding.verdict, Refuted);
}

/// True statements without definitions, in the ranges of [`beside`].
const TRUE: [&str; 40] = [
    r"\sqrt{x^4} = x^2",
    r"\sqrt{1 - \sin^2 x} = |\cos x|",
    r"\sqrt{x^2 + 2 x y + y^2} = |x + y|",
    r"\arctan\frac{x}{k} = \arcsin\frac{x}{\sqrt{x^2 + k^2}}",
    r"\arccos\frac{k}{\sqrt{k^2 + m^2}} = \arctan\frac{m}{k}",
    r"\frac{1}{\sqrt{x^2 + k^2} - x} = \frac{\sqrt{x^2 + k^2} + x}{k^2}",
    r"\sqrt{x^2} = |x|",
    r"\sqrt{x^2 y^2} = |x y|",
    r"\sqrt{k^2} = k",
    r"\sqrt{\frac{k}{m}} = \frac{\sqrt{k}}{\sqrt{m}}",
    r"\sqrt{k m} = \sqrt{k}\sqrt{m}",
    r"\ln\frac{k}{m} = \ln k - \ln m",
    r"\ln\frac{k}{m} = -\ln\frac{m}{k}",
    r"\ln(x^2) = 2\ln|x|",
    r"\ln\sqrt{k} = \frac12\ln k",
    r"\frac12\ln\frac{1 + v}{1 - v} = \ln\sqrt{\frac{1 + v}{1 - v}}",
    r"\tanh\left(\frac12\ln\frac{1 + v}{1 - v}\right) = v",
    r"\sin^2\frac{x}{2} = \frac{1 - \cos x}{2}",
    r"\left|\sin\frac{x}{2}\right| = \sqrt{\frac{1 - \cos x}{2}}",
    r"\left|\cos\frac{x}{2}\right| = \sqrt{\frac{1 + \cos x}{2}}",
    r"\tan\frac{x}{2} = \frac{\sin x}{1 + \cos x}",
    r"\tan\frac{x}{2} = \frac{1 - \cos x}{\sin x}",
    r"\sin x = \frac{2\tan\frac{x}{2}}{1 + \tan^2\frac{x}{2}}",
    r"\cos(\arcsin v) = \sqrt{1 - v^2}",
    r"\sin(\arccos v) = \sqrt{1 - v^2}",
    r"\tan(\arcsin v) = \frac{v}{\sqrt{1 - v^2}}",
    r"\cos(\arctan x) = \frac{1}{\sqrt{1 + x^2}}",
    r"\arcsin v + \arccos v = \frac{\pi}{2}",
    r"\arcsin(-v) = -\arcsin v",
    r"\arccos(-v) = \pi - \arccos v",
    r"\arctan(-x) = -\arctan x",
    r"\arctan k + \arctan\frac{1}{k} = \frac{\pi}{2}",
    r"\arctan\frac{v}{\sqrt{1 - v^2}} = \arcsin v",
    r"2\arcsin\sqrt{\frac{1 + v}{2}} = \frac{\pi}{2} + \arcsin v",
    r"\left|e^{i x}\right| = 1",
    r"e^{i x} = \cos x + i\sin x",
    r"e^{i\pi/2} = i",
    r"\operatorname{Re}\left(e^{i(x - y)}\right) = \cos x\cos y + \sin x\sin y",
    r"\frac{x}{\sqrt{x^2}} = \frac{|x|}{x}",
    r"\frac{\sqrt{k^2 + x^2} - k}{x} = \frac{x}{\sqrt{k^2 + x^2} + k}",
];

#[test]
fn true_statements_with_branches_pass() {
    for latex in TRUE {
        let found = beside(&[], latex);
        assert!(found.verdict.passes(), "{latex}: {found:?}");
    }
}
