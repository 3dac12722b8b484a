//! What is inferred from the use of letters where nothing declares them: functions, vectors, differentials, operators.
//! Beside each stands what differs little, and is read otherwise or refused.

use onshell::latex::read_display;

use super::*;

/// The statements in plain words, and what was inferred; `None` if a statement is refused.
fn read(latex: &str) -> Option<(Vec<String>, Vec<String>)> {
    let mut symbols = Symbols::open();
    let reading = read_display(latex, &mut symbols, &Macros::default());
    let statements: Result<Vec<_>, _> = reading.statements.iter().cloned().collect();
    let words = statements.ok()?.iter().map(|found| text::statement(found, &symbols)).collect();
    Some((words, symbols.inferred.said.clone()))
}

fn are_read(cases: &[(&str, &str)]) {
    for (latex, words) in cases {
        let expected: Vec<String> = words.split(" | ").map(str::to_owned).collect();
        assert_eq!(read(latex).map(|(found, _)| found), Some(expected), "{latex}");
    }
}

fn are_refused(cases: &[&str]) {
    for latex in cases {
        assert_eq!(read(latex), None, "{latex}");
    }
}

#[test]
fn a_prime_that_marks_another_quantity() {
    are_read(&[
        ("x' = \\gamma(x - vt)", "x' = γ·(x − v·t)"),
        ("x' = x - vt, \\quad t' = t", "x' = x − v·t | t' = t"),
        (
            "x' = x\\cos a + y\\sin a, \\quad y' = y\\cos a - x\\sin a",
            "x' = x·cos(a) + y·sin(a) | y' = y·cos(a) − x·sin(a)",
        ),
        ("m_1 v_1 + m_2 v_2 = m_1 v_1' + m_2 v_2'", "m_1·v_1 + m_2·v_2 = m_1·v'_1 + m_2·v'_2"),
        ("L' = L + \\frac{dF}{dt}", "L' = L + d/dt(F)"),
    ]);
    // a derivative as often
    are_refused(&["y' + y = 0", "x' = ax + by, \\quad y' = bx", "V' = V + a", "v_1' = v_1"]);
}

#[test]
fn a_power_before_a_parenthesis_is_a_factor() {
    are_read(&[
        ("E^2(a + b) = c", "E^2·(a + b) = c"),
        ("x = a (\\Delta t)^2", "x = a·Δt^2"),
        ("x = -\\omega_0(y + v \\Delta t)", "x = −ω_0·(y + v·Δt)"),
        ("V = gl\\left(\\frac{a + b}{2}\\right)", "V = g·l·((a + b)/2)"),
        ("2\\sqrt2 a = b", "2·√(2)·a = b"),
        ("\\cos\\theta(1 + \\cos\\theta) = a", "cos(θ)·(1 + cos(θ)) = a"),
    ]);
    are_refused(&["x = a(\\Delta t)", "2\\frac12 a = b", "x(t + T) = a"]);
}

#[test]
fn functions_are_shown_by_their_use() {
    are_read(&[
        ("f(x+h) = f(x) + hf'(x)", "f(x + h) = f(x) + h·f'(x)"),
        ("x_{n+1} = x_n - \\frac{f(x_n)}{f'(x_n)}", "x_{n+1} = x_n − f(x_n)/f'(x_n)"),
        ("\\frac{d}{dx}f(g(x)) = f'(g(x))g'(x)", "d/dx(f(g(x))) = f'(g(x))·g'(x)"),
        ("H(q, \\dots, t) = E", "H(q, …, t) = E"),
        ("S[q] = 0", "S(q) = 0"),
        ("y'' + k y = 0", "y'' + k·y = 0"),
        // A sum in parentheses is a factor, as long as nothing shows a function.
        ("f = k(x+h)", "f = k·(x + h)"),
    ]);
    are_refused(&["u(x+h)", "f(2x)", "q[3]", "y' + y", "\\delta(x - b)"]);
    let (_, said) = read("V(r) = k r").unwrap();
    assert_eq!(said, ["V is a function of r"]);
    assert!(read("V \\, (r + s) = k").unwrap().1.is_empty());
}

#[test]
fn markup_shows_vectors() {
    are_read(&[
        ("\\vec L = \\vec r \\times \\vec p", "L\u{20d7} = r\u{20d7} × p\u{20d7}"),
        ("\\vec a' = \\vec a", "a\u{20d7}' = a\u{20d7}"),
    ]);
    // A number beside a vector, letters without markup, two vectors side by side, an operator with a hat.
    are_refused(&[
        "\\vec a + b",
        "r \\times p",
        "\\vec F = m a",
        "\\mathbf{a}\\mathbf{x} = \\mathbf{b}",
        "\\hat H = E",
    ]);
}

#[test]
fn differentials_and_variations_need_evidence() {
    are_read(&[
        ("dE = T\\,dS - p\\,dV", "dE = T·dS − p·dV"),
        ("ds^2 = dx^2 + dy^2", "ds^2 = dx^2 + dy^2"),
        ("\\delta W = Q_i\\,\\delta q_i", "δW = Q_i·δq_i"),
        ("\\delta\\int L\\,dt = 0", "δ(∫(L·dt)) = 0"),
    ]);
    // One differential alone; d as a distance; δ as a rate of damping, as a phase.
    are_refused(&["y\\,dx", "W = F d x"]);
    assert_eq!(read("x = e^{-\\delta t}").map(|(_, said)| said), None);
    are_read(&[("x = \\cos(\\omega t + \\delta)", "x = cos(ω·t + δ)")]);
}

#[test]
fn sums_integrals_and_fields_are_operators_on_what_follows() {
    are_read(&[
        ("M = \\sum_{i=1}^{N} m_i", "M = Σ_{i=1}^{N}(m_i)"),
        ("\\sum_{k=1}^n k a_k = b", "Σ_{k=1}^{n}(k·a_k) = b"),
        ("S = \\int_0^T L\\,dt", "S = ∫_{0}^{T}(L·dt)"),
        ("\\int a + b\\,dx = c", "∫((a + b)·dx) = c"),
        ("\\int\\frac{dx}{x} = \\ln x + C", "∫(dx/x) = ln(x) + C"),
        ("\\int\\int f\\,dx\\,dy = c", "∫(∫(f·dx)·dy) = c"),
        ("\\oint\\vec F\\cdot d\\vec r = 0", "∮(F\u{20d7} • dr\u{20d7}) = 0"),
        ("\\nabla\\cdot\\vec E = \\rho", "∇·(E\u{20d7}) = ρ"),
        ("\\nabla^2\\phi = 0", "∇^{2}(φ) = 0"),
        ("\\left(\\frac{\\partial S}{\\partial V}\\right)_T = b", "(∂S/∂V)|_{T} = b"),
        ("\\frac{\\partial V}{\\partial x}\\bigg|_{x=a} = 0", "(∂V/∂x)|_{x=a} = 0"),
    ]);
    // An integral that ends in a fraction does not reach to a later differential.
    assert_ne!(
        read("\\int\\frac{dx}{x} + C\\,dt = 0").map(|(found, _)| found),
        Some(vec!["∫((dx/x + C)·dt) = 0".to_owned()])
    );
    are_refused(&["\\int x", "\\nabla\\cdot E = \\rho", "\\nabla \\vec E", "a b|_{x=0}", "\\sum_i"]);
}

#[test]
fn a_derivative_of_what_may_depend_on_its_variable_is_not_carried_out() {
    are_read(&[
        ("\\frac{\\partial}{\\partial r}\\left(r^2\\frac{\\partial f}{\\partial r}\\right) = 0", "∂/∂r(r^2·∂f/∂r) = 0"),
        ("\\frac{\\partial}{\\partial r}(r f) = 0", "∂/∂r(r·f) = 0"),
    ]);
    // Where nothing is inferred, such a derivative is refused.
    let alone = |latex: &str| read_formula(latex, &mut Symbols::open(), &Macros::default()).is_ok();
    assert!(!alone("\\frac{\\partial}{\\partial r}(r^2\\frac{\\partial f}{\\partial r})"));
    assert!(alone("\\frac{\\partial}{\\partial r}(r^2)"));
    assert!(!alone("\\int x\\,dx") && !alone("f(x)") && !alone("\\nabla f"));
}
