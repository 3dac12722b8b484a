//! What a name is by its use in the whole display: a factor, a function, a matrix, a word. Beside each stands what stays as it is.

use super::{are_read, are_refused, statements_of};

#[test]
fn a_name_of_several_letters_before_a_parenthesis_is_no_product() {
    are_refused(&[
        "Var(X) = a",
        "Var(aX + b) = a^2 Var(X)",
        "HR_k(t) = \\frac{h_{k,1}(t)}{h_{k,0}(t)}",
        "G = SU(3) \\times SU(2) \\times U(1)",
        "CDF(x) = 1",
        "TF(s) = \\frac{1}{s+1}",
        "KL(p, q) = a",
        "cis(\\theta) = e^{i\\theta}",
        "y = e^{CDF(x)}",
        "pdf(x) = e^{-x}",
        "emf = -\\frac{d\\Phi}{dt}",
        "pH = -\\log c",
    ]);
    are_read(&[
        // a letter of the word stands elsewhere, a space parts the letters, the parenthesis holds a sum
        ("PV(T) = n R T, \\quad V = a", "P·V(T) = n·R·T ¦ V = a"),
        ("T\\,F(s) = a", "T·F(s) = a"),
        ("mgl(1 - \\cos\\theta) = E", "m·g·l·(1 − cos(θ)) = E"),
        ("x \\in SO(3)", "x ∈ SO(3)"),
    ]);
}

#[test]
fn the_sides_of_a_triangle_are_no_products() {
    are_refused(&["BC^2 = AB^2 + AC^2"]);
    are_read(&[("PV = NR", "P·V = N·R"), ("A = AB + AC + BC", "A = A·B + A·C + B·C")]);
}

#[test]
fn a_factor_elsewhere_is_no_function_before_a_sum() {
    are_read(&[
        (
            "\\ddot r = f\\,\\dot t^2 + r\\,f\\left(\\dot\\theta^2 + \\dot\\phi^2\\right)",
            "r\u{308} = f·t\u{307}^2 + r·f·(θ\u{307}^2 + φ\u{307}^2)",
        ),
        (
            "u = d_M \\frac{\\dot\\theta}{M} - d_M (\\dot p + l \\dot\\theta)",
            "u = d_M·(θ\u{307}/M) − d_M·(p\u{307} + l·θ\u{307})",
        ),
        ("\\frac{a}{T V_m (\\Delta\\alpha)^2} = 1", "a/(T·V_m·Δα^2) = 1"),
    ]);
    are_refused(&[
        "\\tau = r F \\sin\\phi = F (r \\sin\\phi)",
        "y = \\frac{a}{f} + f (a+b)",
        "h(1-x) + h",
        "E = \\psi(x + 1)\\psi",
        "W = F (x_2 - x_1)",
        "F = f (1 + \\mu)",
        "E = hf(1 + z)",
        "V(\\Delta x)^2 = 1",
    ]);
    are_read(&[
        ("y = f(x + h) - f(x)", "y = f(x + h) − f(x)"),
        ("y = \\psi(x + h)", "y = ψ(x + h)"),
        ("x = x(t)", "x = x(t)"),
        ("y = f + f(x)", "y = f + f(x)"),
        ("y = V(x_1 - x_2)", "y = V(x_1 − x_2)"),
        ("V = V(x_1 - x_2), \\quad L = T - V", "V = V(x_1 − x_2) ¦ L = T − V"),
    ]);
}

#[test]
fn a_value_with_a_zero_below_is_a_factor_of_a_sum_that_begins_with_a_number() {
    are_read(&[
        ("N(t) = N_0 (1 - \\lambda t)", "N(t) = N_0·(1 − λ·t)"),
        ("x(t) = x_0 (1 + t)", "x(t) = x_0·(1 + t)"),
        ("u(x,t) = u_0(x - ct)", "u(x, t) = u_0(x − c·t)"),
    ]);
    are_refused(&["u(y) = u_0 (y/h)", "N(t) = N_1 (1 - \\lambda t)"]);
}

#[test]
fn g_is_the_acceleration_of_a_fall_only_where_something_says_so() {
    are_refused(&["y = g(a+b)", "I = (b-a) g(a+(b-a)u)"]);
    are_read(&[
        ("a = g(\\sin\\theta - \\mu\\cos\\theta)", "a = g·(sin(θ) − μ·cos(θ))"),
        ("U = mg(h - y)", "U = m·g·(h − y)"),
        ("v^2 = 2g(x - y)", "v^2 = 2·g·(x − y)"),
        ("y = g(x) + g(a + b)", "y = g(x) + g(a + b)"),
    ]);
}

#[test]
fn a_power_before_a_letter_in_parentheses_is_no_function_of_a_letter_that_varies_freely() {
    are_refused(&[
        "U(t,\\lambda) = f(\\lambda)e^{-\\lambda^{2}(t)}",
        "p = \\lambda^2 (t) + \\lambda",
        "u(x, k) = e^{-k^2 (t)}",
    ]);
    are_read(&[
        ("x^2(t) + y^2(t) = R^2(t)", "x(t)^2 + y(t)^2 = R(t)^2"),
        ("E = x^2(t) + \\dot x x", "E = x(t)^2 + x\u{307}·x"),
    ]);
}

#[test]
fn two_places_above_a_letter_are_a_label() {
    are_read(&[
        ("\\Delta V^{Px_1} = V(x_1)", "ΔV^{Px_{1}} = V(x_1)"),
        ("\\Delta V^{\\infty x_1} = V(x_1)", "ΔV^{∞ x_{1}} = V(x_1)"),
        ("2^{N_1 x} = a", "2^(N_1·x) = a"),
    ]);
}

#[test]
fn a_comparison_before_an_arrow_is_a_condition() {
    are_read(&[
        ("x > 0 \\Rightarrow |x| = x", "|x| = x for x > 0"),
        ("a = b \\Rightarrow t \\leq s \\quad \\forall n", "t ≤ s for a = b"),
        ("\\text{if } x = 0 \\text{ then } y = 0", "y = 0 for x = 0"),
        // a derivation
        ("F = m a \\Rightarrow a = F/m", "F = m·a ¦ a = F/m"),
        ("a = b \\Rightarrow c > d", "a = b ¦ c > d"),
        ("N \\le F \\Rightarrow c \\ge N/F", "N ≤ F ¦ c ≥ N/F"),
    ]);
}

#[test]
fn a_bold_letter_before_a_dot_is_a_matrix_beside_a_vector() {
    are_read(&[
        ("\\mathbf{t} = \\boldsymbol\\sigma\\cdot\\mathbf{n}", "t = σ · n"),
        ("m\\mathbf{a} = \\mathbf{R}\\cdot\\mathbf{F} + m\\mathbf{g}", "m·a = (R · F) + m·g"),
        ("T = \\boldsymbol\\omega\\cdot\\mathbf{I}\\cdot\\boldsymbol\\omega", "T = (ω · I) · ω"),
        ("W = \\mathbf{F}\\cdot\\mathbf{v}", "W = F • v"),
        ("W = \\mathbf{F}\\cdot\\mathbf{v}, \\quad \\mathbf{p} = m\\mathbf{v}", "W = F • v ¦ p = m·v"),
    ]);
    are_refused(&[
        "\\mathbf{d} = \\mathbf{a}\\cdot\\mathbf{b}\\,\\mathbf{c}",
        "\\mathbf{F} = \\mathbf{R}(\\mathbf{v} - \\mathbf{w})",
        "\\mathbf{b} = \\nabla\\times\\mathbf{v}\\times\\mathbf{B}",
    ]);
    are_read(&[
        ("\\mathbf{j} = \\nabla\\times\\nabla\\times\\mathbf{E}", "j = ∇×(∇×(E))"),
        ("\\mathbf{b} = \\nabla\\times(\\mathbf{v}\\times\\mathbf{B})", "b = ∇×(v × B)"),
    ]);
}

#[test]
fn letters_of_units_after_a_number_are_refused() {
    are_refused(&[
        "\\rho = 1000 kg/m^3",
        "\\lambda = 500 nm",
        "g = 9.8 m/s^2",
        "T = 300 K",
        "m = 2 kg",
        "\\tau = 1.5 \\times 10^3 N m",
    ]);
    are_read(&[
        ("E = 0.5 C V^2", "E = 0.5·C·V^2"),
        ("E = 0.5 m v^2", "E = 0.5·m·v^2"),
        ("b^2 = 4 km", "b^2 = 4·k·m"),
        ("F = 2 N", "F = 2·N"),
        ("F = 10 \\cdot N", "F = 10·N"),
        ("F = 9.8 m_1", "F = 9.8·m_1"),
    ]);
}

#[test]
fn an_indicator_is_no_factor() {
    are_read(&[
        ("r = a + b \\cdot \\mathbb{1}[\\text{upright}]", "r = a + (b · 𝟙[upright])"),
        ("\\mathbf{1}_A(x) = 1", "𝟙_{A}(x) = 1"),
    ]);
    assert_eq!(statements_of("A = a\\mathbb{1}").as_deref(), Some("A = a·𝟙"));
}

#[test]
fn a_function_of_the_value_of_a_function_is_read() {
    are_read(&[
        ("y = \\ln p(x)", "y = ln(p(x))"),
        ("S = p(x)\\ln p(x) + a", "S = p(x)·ln(p(x)) + a"),
        ("y = \\sin f(x)", "y = sin(f(x))"),
    ]);
    are_refused(&["y = \\ln p(x) q(x)", "y = \\ln a p(x)"]);
}

#[test]
fn events_of_a_probability_are_read() {
    are_read(&[
        ("S(t) = P(T > t)", "S(t) = P(T > t)"),
        ("P(X = x) = p^x (1 - p)^{1 - x}", "P(X=x) = p^(x)·(1 − p)^(1 − x)"),
    ]);
    are_refused(&["S(t) = a(T > t)", "y = p^x"]);
}

#[test]
fn marks_that_print_no_other_letter_are_read() {
    are_read(&[
        ("\\textbf{u}(t) = \\mathbf{f}(t)", "u(t) = f(t)"),
        ("\\mathbf{r = \\frac{a}{b}}", "r = a/b"),
        ("a = \\frac{{d}^2 x}{{d}t^2}", "a = d^2/dt^2(x)"),
        ("\\mathbf{P}^{\\wedge}\\mathbf{v} = \\mathbf{a}", "P^{∧}·v = a"),
        ("v = L\\dot{i} + R i", "v = L·i\u{307} + R·i"),
        ("\\hat{A}(a|x\\rangle + b|y\\rangle) = c", "A\u{302}·(a·|x⟩ + b·|y⟩) = c"),
    ]);
    are_refused(&["v = L a + R i"]);
}

#[test]
fn a_quotient_of_sides_with_a_common_point_is_no_quotient_of_products() {
    are_refused(&["\\frac{AB}{AC} = \\frac{AD}{AE}", "\\sqrt n = \\frac{CP}{CH}"]);
    are_read(&[("\\frac{PV}{RT} = n", "(P·V)/(R·T) = n"), ("k = \\frac{A\\,B}{A\\,C}", "k = (A·B)/(A·C)")]);
}

#[test]
fn nothing_is_a_function_of_itself() {
    are_read(&[("E = B J(J+1)", "E = B·J·(J + 1)"), ("P = v(v)", "P = v·v"), ("f(f(x)) = x", "f(f(x)) = x")]);
    are_refused(&["E = B J(K+1)"]);
}

#[test]
fn a_power_may_show_that_the_parenthesis_is_a_factor() {
    are_read(&[
        ("f = \\sum_k f_k (t - t_0)^k", "f = Σ_{k}(f_k·(t − t_0)^(k))"),
        ("P = (I - KH) P (I - KH)^T", "P = (I − K·H)·P·(I − K·H)^{T}"),
        ("M = [a\\,b]^2", "M = (a·b)^2"),
    ]);
    are_refused(&["P = F(A - B)^T", "M = [a\\,b]"]);
}

#[test]
fn a_letter_above_a_number_is_a_power_above_a_name_too() {
    are_read(&[("y = 6^{-a} b_n^a", "y = 6^(−a)·b_n^(a)")]);
    are_refused(&["y = b_n^a", "y = 90^o"]);
}

#[test]
fn numbers_of_steps_in_brackets_are_arguments() {
    are_read(&[
        ("r_x[n_1,n_2] = \\delta[n_1-n_2]", "r_x(n_1, n_2) = δ(n_1 − n_2)"),
        ("[A, BC] = [A,B]C + B[A,C]", "[A, B·C] = [A, B]·C + B·[A, C]"),
        ("\\sigma_{A^+, B}(E) = 2", "σ_{A^{+},B}(E) = 2"),
        ("F : A \\to SO(3)", "F : A → SO(3)"),
    ]);
    are_refused(&["\\theta^{M[u,x]} = 1"]);
}

#[test]
fn a_symbol_before_a_sum_without_a_place_may_be_a_factor() {
    are_refused(&["a = 3 \\mathcal{H} (\\delta\\rho + \\delta P)", "a = \\dot\\psi (\\bar\\rho + \\bar P)"]);
    are_read(&[("a = \\psi(x + h)", "a = ψ(x + h)"), ("a = \\mathcal{L}(x + b)", "a = ℒ(x + b)")]);
}

#[test]
fn letters_that_equal_a_list_are_one_name() {
    are_refused(&["lsp = (n, F, G)"]);
    are_read(&[("x = (n, F, G)", "x = (n, F, G)"), ("mgh = a", "m·g·h = a")]);
}
