//! What a letter is by its place: an index, a matrix, an operator, √−1, a differential, a function. Beside each reading stands a
//! wrong one that differs little, and is read otherwise or refused.

use onshell::latex::read_display;

use super::*;

/// The statements in plain words, with the kinds of the names; `None` if a statement is refused.
fn read(latex: &str) -> Option<(String, Symbols)> {
    let mut symbols = Symbols::for_reading();
    let reading = read_display(latex, &mut symbols, &Macros::default());
    let statements: Result<Vec<_>, _> = reading.statements.iter().cloned().collect();
    let words: Vec<String> = statements.ok()?.iter().map(|found| text::statement(found, &symbols)).collect();
    Some((words.join(" ¦ "), symbols))
}

fn are_read(cases: &[(&str, &str)]) {
    for (latex, words) in cases {
        assert_eq!(read(latex).map(|found| found.0).as_deref(), Some(*words), "{latex}");
    }
}

fn are_refused(cases: &[&str]) {
    for latex in cases {
        assert_eq!(read(latex).map(|found| found.0), None, "{latex}");
    }
}

/// Whether a name is a plain number in a display.
fn is_number(latex: &str, name: &str) -> bool {
    let (_, symbols) = read(latex).unwrap_or_else(|| panic!("{latex} is refused"));
    let (name, _) = names::parse(name).unwrap();
    symbols.find(&name).is_some_and(|(id, _)| symbols.entry(id).kind == Kind::Scalar)
}

#[test]
fn an_upper_index_with_a_subscript_is_no_power() {
    are_read(&[
        (r"\Gamma^{r_t}_{\theta_t\theta_t} = a", "Γ_{θ_{t}θ_{t}}^{r_{t}} = a"),
        (r"\prod_i p_i^{n_i}", "Π_{i}(p_i^(n_i))"),
        ("(x_2)^{n_1}", "x_2^(n_1)"),
    ]);
    are_refused(&[r"\Gamma^{r_t}_{1}", "x_2^{n_1}"]);
}

#[test]
fn a_subscript_after_an_argument_belongs_to_the_value() {
    are_read(&[(r"f(x)_{\text{max}} = a", "f(x)_{max} = a"), ("f_{max}(x) = a", "f_{max}(x) = a")]);
}

#[test]
fn a_comma_in_braces_before_three_digits_is_refused() {
    are_refused(&[r"b = 2{,}897\,c \text{ as } d", "b = 2{,}897"]);
    are_read(&[("b = 2{,}5", "b = 2.5"), ("b = 2{,}8970", "b = 2.8970")]);
}

#[test]
fn bold_type_around_a_derivative_belongs_to_what_is_differentiated() {
    are_read(&[
        (r"\frac{\mathbf{\partial B}}{\partial t} = -\nabla\times\mathbf{E}", "∂B/∂t = −∇×(E)"),
        (r"\frac{\text{d}}{\text{d}t} x = a", "d/dt(x) = a"),
        (r"\oint \mathbf{B}\cdot\mathbf{dl} = 0", "∮(B • dl) = 0"),
        (r"\mathrm{\delta}Q = T\,dS", "δQ = T·dS"),
    ]);
}

#[test]
fn an_operator_reaches_to_what_goes_on() {
    are_read(&[
        (r"J = \iint e^{-u^2} \,du\,dv", "J = ∬(e^(−u^2)·(du·dv))"),
        (r"M = \iiint_V \rho \,dx\,dy\,dz", "M = ∭_{V}(ρ·(dx·dy·dz))"),
        (r"\int\int f \,dx\,dy", "∫(∫(f·dx)·dy)"),
        (r"\partial_\lambda R^\mu{}_{\nu\rho} = 0", "∂_{λ}(R^{μ}_{νρ}) = 0"),
        (r"dv = \delta \dot q\, dt = d\delta q", "dv = δq̇·dt = dδq"),
    ]);
    are_refused(&[r"\nabla\cdot\nu[\nabla\mathbf{u} + \nabla\mathbf{w}] = 0", r"\nabla k\nabla T = 0"]);
}

#[test]
fn d_is_a_factor_in_the_argument_of_a_function() {
    are_read(&[
        (r"u = a\sin(ay + dz) + \cos(ax + dy)", "u = a·sin(a·y + d·z) + cos(a·x + d·y)"),
        ("dE = T\\,dS - p\\,dV", "dE = T·dS − p·dV"),
        (r"\sin(d\theta) \approx d\theta", "sin(dθ) ≈ dθ"),
    ]);
    are_refused(&[r"\cos\left(\frac{2\pi dx}{\lambda z}\right) = a"]);
}

#[test]
fn letters_that_are_multiplied_in_one_order_are_no_numbers() {
    for (latex, name) in [
        (r"A\mathbf{v} = \lambda\mathbf{v}", "A"),
        (r"A v = \lambda v", "A"),
        (r"H\psi = E\psi", "H"),
        (r"\Lambda^T\eta\Lambda = \eta", r"\eta"),
        (r"\det(\Lambda) = 1", r"\Lambda"),
        (r"\mathbf{a} = M^{-1}(J^T\mathbf{F} - \mathbf{V})", "J"),
        (r"e^{A+B} = e^A e^B e^{-\frac12[A,B]}", "A"),
        (r"|\psi\rangle = V|\phi\rangle", "V"),
        (r"\langle a|V|b\rangle = 0", "V"),
        (r"\rho = p|a\rangle\langle a|", r"\rho"),
        (r"\sigma = E \rho E^\dagger", r"\rho"),
        (r"\mathbf{a} = M^{-1}(J^T\mathbf{F} - \mathbf{V})", "M"),
    ] {
        assert!(!is_number(latex, name), "{latex}");
    }
    for (latex, name) in [
        ("M g = m g", "M"),
        (r"A\mathbf{v} = \lambda\mathbf{w}", "A"),
        (r"|\psi\rangle = c|\phi\rangle", "c"),
        ("[a + b]c = d", "a"),
        (r"\mathbf{a} = M^{-1}\mathbf{F}", "M"),
    ] {
        assert!(is_number(latex, name), "{latex}");
    }
}

#[test]
fn j_is_imaginary_beside_a_frequency() {
    are_read(&[
        (r"Z = R + j\omega L", "Z = R + i·ω·L"),
        (
            r"\frac{A}{2j}\left(\frac{1}{s - j\omega} - \frac{1}{s + j\omega}\right)",
            "(A/(2·i))·(1/(s − i·ω) − 1/(s + i·ω))",
        ),
        (r"[\hat\Phi, \hat Q] = j\hbar", "[Φ̂, Q̂] = i·ħ"),
        (r"e^{j\omega t} = \cos\omega t + j\sin\omega t", "e^(i·ω·t) = cos(ω·t) + i·sin(ω·t)"),
        // A current, and an index.
        ("j = ax", "j = a·x"),
        (r"\vec j = \rho\vec v", "j⃗ = ρ·v⃗"),
    ]);
    are_refused(&["e^{jx}", r"v_j = j\omega x_j"]);
}

#[test]
fn functions_without_a_backslash_before_a_parenthesis() {
    are_read(&[
        (r"y = \frac{l}{2}cos(\phi)sin(\theta)", "y = (l/2)·cos(φ)·sin(θ)"),
        (r"V = -mgl\,cos(\theta)", "V = −m·g·l·cos(θ)"),
        (r"V = -mglcos(\theta)", "V = −m·g·l·cos(θ)"),
        (r"log W_N = N log \frac{n}{N}", "log(W_N) = N·log(n/N)"),
        (r"\cos\Delta\theta_2 - a", "cos(Δθ_2) − a"),
    ]);
    are_refused(&["y = asin(x)", "y = sin x", "y = xlogx"]);
    // A word in a subscript is a part of the name.
    are_read(&[(r"T_{\text{log mean}} - T_{\text{mean}}", "T_{logmean} − T_{mean}")]);
}

#[test]
fn primes_of_products_and_of_vectors() {
    are_read(&[
        ("(uv)' = u'v + uv'", "(u·v)' = u'·v + u·v'"),
        (r"\left(X^\prime\right)^\mu = L^\mu_\nu X^\nu", "X'^{μ} = L_ν^{μ}·X^{ν}"),
    ]);
    are_refused(&["y' + y = 0", "u'v + uv = 0"]);
}

#[test]
fn what_stands_in_a_parenthesis_after_a_letter() {
    are_read(&[
        (r"x(-\cos x) = a", "x·(−cos(x)) = a"),
        (r"\sigma = E_z(0^+) - E_z(0^-)", "σ = E_z(0^{+}) − E_z(0^{-})"),
        ("dp = p_v dV = p_v(c\\,dt)dA", "dp = p_v·dV = p_v·(c·dt)·dA"),
        ("x(0) = a", "x(0) = a"),
        ("f(2x) = a", "f(2·x) = a"),
    ]);
    are_refused(&["y = k(0) + c", r"\rho_c(\xi_1^2 q)", "u(2(c^2+b))", "H(ab)"]);
}

#[test]
fn forms_that_authors_use() {
    are_read(&[
        (r"\bra{a}\ket{b} = 0", "⟨a|b⟩ = 0"),
        (r"A = \frac{\partial f}{\partial x}\biggr\rvert_{(a, b)}", "A = (∂f/∂x)|_{(a,b)}"),
        (r"c^2 + -\gamma^2 v^2", "c^2 − γ^2·v^2"),
        (r"a = b \qquad\blacksquare", "a = b"),
        (r"{\displaystyle {\begin{aligned}a&=b\\c&=f\end{aligned}}}", "a = b ¦ c = f"),
        (r"\phi[C] = \oint_C A_\mu dx^\mu", "φ(C) = ∮_{C}(A_μ·dx^{μ})"),
    ]);
    are_refused(&["c^2 +- v^2", "c^2 - -v^2"]);
}
