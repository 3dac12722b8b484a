//! Operators with their arguments, numbers of steps, and marks that are no products.

use super::{are_read, are_refused, statements_of as read};

#[test]
fn a_power_after_the_parenthesis_of_an_operator_is_of_its_value() {
    are_read(&[
        ("y = \\det(A)^{-1/2}", "y = det(A)^(−1/2)"),
        ("\\operatorname{tr}(A)^2 - \\operatorname{tr}(A^2) = 2\\det(A)", "tr(A)^2 − tr(A^2) = 2·det(A)"),
        ("\\max(a, b)^2 = c", "max(a, b)^2 = c"),
        ("\\text{rank}(A)^2 = n", "rank(A)^2 = n"),
        ("\\arg(z)^2 = a", "arg(z)^2 = a"),
    ]);
    assert_ne!(read("y = \\det(A)^2"), read("y = \\det(A^2)"));
    // of these the argument may be meant, and letters may be a product
    are_refused(&["\\sin(x)^2 = y", "\\ln(x)^2 = y", "\\log(x)^2 = y", "tr(A)^2 = y"]);
}

#[test]
fn numbers_of_steps_are_no_powers() {
    are_read(&[
        ("u^{n+1} = u^n + \\Delta t f^n", "u^{n+1} = u^{n} + Δt·f^{n}"),
        ("a = u_{i,j+1}^n - u_{i,j}^n", "a = u_{i,j+1}^{n} − u_{i,j}^{n}"),
        ("v^{k+1/2} = v^{k-1/2} + a \\Delta t", "v^{k+1/2} = v^{k-1/2} + a·Δt"),
    ]);
    // powers stay powers
    are_read(&[("y = \\frac{x^{n+1}}{n+1}", "y = x^(n + 1)/(n + 1)"), ("x^{n+1} = x^n x", "x^(n + 1) = x^(n)·x")]);
    are_read(&[("x[n+1] = x[n]", "x(n + 1) = x(n)"), ("x[1] = A x[0]", "x(1) = A·x(0)")]);
    // steps or powers: the golden ratio has these powers
    are_refused(&["\\varphi^{n+1} = \\varphi^n + \\varphi^{n-1}", "x^{k+1} = x^k - \\alpha g"]);
}

#[test]
fn a_derivative_with_a_bar_acts_on_what_follows() {
    are_read(&[
        ("y = \\left.\\frac{d}{dt}\\right|_{t=0} g(\\alpha(t))", "y = (d/dt(g(α(t))))|_{t=0}"),
        ("y = \\frac{d - 2}{d - 1}", "y = (d − 2)/(d − 1)"),
    ]);
    are_refused(&["y = \\frac{d}{dt} \\Big|_{t=0} g(\\alpha(t))"]);
}

#[test]
fn operators_have_arguments() {
    are_read(&[
        ("y = \\mathbb{E}[x]", "y = E[x]"),
        ("y = \\mathbb{E}_{\\theta}[\\langle f, g\\rangle]", "y = E_{θ}[⟨f, g⟩]"),
        ("\\langle \\psi | A(t) | \\psi \\rangle = 1", "⟨ψ|A(t)|ψ⟩ = 1"),
        ("\\mathcal{L}(f(t))(s) = F(s)", "(ℒ(f(t)))(s) = F(s)"),
        ("Q^+(\\cdot) = \\sum_i w_i k(z_i, \\cdot)", "Q^{+}(·) = Σ_{i}(w_i·k(z_i, ·))"),
        ("S[q^i] = \\int L(q^i, \\dot q^i, t)\\, dt", "S(q^{i}) = ∫(L(q^{i}, q̇^{i}, t)·dt)"),
        ("\\alpha, \\beta \\in \\{x, y, z\\}", "(α, β) ∈ {x, y, z}"),
        ("p(x, x') = \\sum_n \\psi_n(x) \\psi_n^*(x')", "p(x, x') = Σ_{n}(ψ_n(x)·ψ^{*}_n(x'))"),
    ]);
    // the row of a matrix, a place put in for a letter, a length between two points
    are_refused(&["[J_1\\ J_2] = x", "y = e^{-sb} + e^{-s(0)}", "F = \\frac{\\overrightarrow{PM}}{PM^3}"]);
}

#[test]
fn what_is_inserted_behind_a_space_is_not_continued() {
    let rows = "W &= \\int p\\,dx \\quad p = mv \\\\ &= m\\int v\\,dx";
    assert_eq!(read(rows), None);
    // what follows by an arrow is
    let followed = "a = b \\Rightarrow c &= d + e \\\\ &= f";
    assert_eq!(read(followed), Some("a = b ¦ c = d + e = f".into()));
    let objective = "\\min_{x} \\quad & f(x) \\\\ & x > 1";
    assert_eq!(read(objective), Some("min_{x}(f(x)) ¦ x > 1".into()));
    let result = "\\hat a|n\\rangle = \\sqrt n|n-1\\rangle \\quad (\\hat a|0\\rangle = 0)";
    assert_eq!(read(result).map(|found| found.split(" ¦ ").count()), Some(2));
    assert_eq!(read("dS \\propto q \\longrightarrow p = r"), None);
}

#[test]
fn sums_indices_and_sides() {
    are_read(&[
        ("y_j = \\sum_i A_{ij} + b_j", "y_j = Σ_{i}(A_{ij}) + b_j"),
        ("y = \\sum_i x_i + \\sum_i y_i", "y = Σ_{i}(x_i) + Σ_{i}(y_i)"),
        ("A^{11} = A^{22} = a, \\quad A^{ij} = A^{ji}", "A^{11} = A^{22} = a ¦ A^{ij} = A^{ji}"),
        ("ds^2 = \\delta^{ij}dx^i dx^j", "ds^2 = δ^{ij}·dx^{i}·dx^{j}"),
        ("r(t + \\Delta t) = r(t - \\Delta t) + f(t) \\Delta t", "r(t + Δt) = r(t − Δt) + f(t)·Δt"),
        ("T_{ij} = E_i E_j - \\delta_{ij}(E^2 + B^2)", "T_{ij} = E_i·E_j − δ_{ij}·(E^2 + B^2)"),
        ("y = \\underset{x}{\\min} f(x)", "y = min_{x}(f(x))"),
        ("\\omega_{1,2}^2 = a \\pm b", "ω_1^2 = a + b ¦ ω_2^2 = a − b"),
        ("b =: a", "b ≡ a"),
    ]);
    // a letter of Σ behind its sum, a function with an accent, letters that are no indices
    are_refused(&["y = \\sum_i x_i^2 + y_i^2", "y = \\bar V(p - q)", "y = x^{ab}"]);
}

#[test]
fn other_spellings_are_read_alike() {
    for (typed, usual) in [
        ("\\frac{{\\partial}g}{{\\partial}r} = 1", "\\frac{\\partial g}{\\partial r} = 1"),
        ("\\frac{{\\mbox{d}}^2 r}{{\\mbox{d}}t^2} = F", "\\frac{\\mathrm{d}^2 r}{\\mathrm{d}t^2} = F"),
        ("\\begin{dmath} a = b \\end{dmath}", "a = b"),
        ("\\hat a^\\dag = b", "\\hat a^\\dagger = b"),
        ("\\left< x^2 \\right> = 1", "\\langle x^2 \\rangle = 1"),
        ("a = \\cancelto{0}{b} + c", "a = b + c"),
        ("𝛤 = 𝜃 + 𝑥", "\\Gamma = \\theta + x"),
        ("a &=\\quad b \\\\ &= d", "a &= b \\\\ &= d"),
    ] {
        assert_eq!(read(typed), read(usual), "{typed}");
        assert!(read(typed).is_some(), "{typed}");
    }
    // a number over its conjugate has i = √−1; other quotients say nothing of i
    assert!(read("w = \\frac{L + iv}{L - iv}").is_some());
    are_refused(&["w = \\frac{L + iv}{L - w}"]);
    assert_eq!(read("\\frac{x}{y} \\text{ for } z > 1"), Some("x/y for z > 1".into()));
}

#[test]
fn a_root_before_the_time_is_a_frequency() {
    are_read(&[
        ("x = A\\cos\\sqrt{\\frac{k}{m}}\\, t", "x = A·cos(√(k/m)·t)"),
        ("x = A\\cos\\sqrt{k/m} t + B\\sin\\sqrt{k/m}t", "x = A·cos(√(k/m)·t) + B·sin(√(k/m)·t)"),
        ("x = \\cos\\sqrt{x}\\,y", "x = cos(√(x))·y"),
    ]);
    // What stands after the time may be a factor.
    are_refused(&["y = \\cos\\sqrt{k/m} tx"]);
}
