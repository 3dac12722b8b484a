//! What a function, an integral, a derivative or a relation reaches, where public notes leave it to the reader.

use super::{are_read, are_refused};

#[test]
fn bars_below_a_letter_say_parallel() {
    are_read(&[
        ("\\partial_\\| \\phi = a", "∂_{∥}(φ) = a"),
        ("k_\\|^2 + k_\\perp^2 = k^2", "k_∥^2 + k_⊥^2 = k^2"),
        ("E_{\\|} = \\|a\\|", "E_∥ = |a|"),
    ]);
}

#[test]
fn a_number_above_a_delta_before_its_argument_is_that_of_the_dimensions() {
    are_read(&[
        ("T = \\delta^4(x - z)", "T = δ^{(4)}(x − z)"),
        ("\\delta^{(3)}(x - y) = a", "δ^{(3)}(x − y) = a"),
        ("E = \\delta^3 + 1", "E = δ^3 + 1"),
    ]);
}

#[test]
fn a_letter_in_parentheses_after_a_formula_may_be_its_place() {
    are_refused(&[
        "\\langle x^2\\rangle(t) = 2Dt",
        "\\frac{\\Delta T}{T}(\\theta,\\phi) = a",
        "|\\psi|^2(x) = a",
        "\\sqrt{f}(x) = a",
        "\\overline{uv}(x) = a",
        "[A]_{ij}(t) = b",
        "\\frac{\\partial V}{\\partial x}(2x) = 1",
        "\\frac{\\partial f}{\\partial x}(x_0+h) h = a",
        "\\nabla \\Phi(\\mathbf{q})_1 = 0",
    ]);
    are_read(&[
        ("\\frac12(m) = a", "(1/2)·m = a"),
        ("a = 2(b)(\\omega)", "a = 2·b·ω"),
        ("y = \\frac{dx}{dt}(a - b)", "y = d/dt(x)·(a − b)"),
        ("\\langle x\\rangle(a - b) = c", "⟨x⟩·(a − b) = c"),
    ]);
}

#[test]
fn a_letter_that_an_integral_or_a_maximum_binds_does_not_stand_behind_it() {
    are_refused(&[
        "\\int_0^\\pi \\sin\\theta\\,d\\theta\\,f(\\theta) = 1",
        "\\int_0^\\infty r^2\\,dr\\,R(r)^2 = 1",
        "b = 2\\max_x a\\cdot x",
    ]);
    are_read(&[
        ("\\max_x a\\cdot x = b", "max_{x}(a·x) = b"),
        ("\\int_0^1 x\\,dx + x = 2", "∫_{0}^{1}(x·dx) + x = 2"),
        ("\\int_0^1 x\\,dx\\,y = 1", "∫_{0}^{1}(x·dx)·y = 1"),
    ]);
}

#[test]
fn a_factorial_in_a_logarithm_is_its_argument() {
    are_read(&[("S = k\\ln N! - n", "S = k·ln(N!) − n"), ("a = \\ln n!\\,x", "a = ln(n!)·x")]);
    are_refused(&["n! \\sim \\left(\\frac{n}{e}\\right)^n"]);
}

#[test]
fn a_sign_after_a_list_is_about_all_names_of_the_list() {
    are_read(&[
        ("x, y \\sim N(0,1)", "(x, y) ∼ N(0, 1)"),
        ("a, b \\to 0", "(a, b) → 0"),
        ("\\Delta x, \\Delta y \\ll c", "(Δx, Δy) ≪ c"),
    ]);
}

#[test]
fn values_with_units_and_ranges() {
    are_read(&[
        ("h = 0.800 \\text{ ft}", "h = 0.800·ft"),
        ("E = 100\\cos(10t)\\,\\text{V/m}", "E = 100·cos(10·t)·V/m"),
        ("\\eta = 1 - 20\\%", "η = 1 − 20%"),
        ("t = 2.0\\,\\text{s} - 3.0\\,\\text{s}", "t = 2.0·s − 3.0·s"),
    ]);
    are_refused(&[
        "\\eta \\approx 15\\% - 25\\%",
        "v \\approx 5-10\\,\\text{m/s}",
        "T = 25°C",
        "T = 500°F",
        "x = 2y \\quad (T = 10^\\circ\\text{C})",
        "\\lambda = \\frac{12.4}{E[\\mathrm{keV}]}",
        "a = 0 (2.5)",
        "y = f(x) (3.1)",
    ]);
}

#[test]
fn words_in_parentheses_restrict_a_statement_or_explain_it() {
    are_read(&[
        ("x = 2y \\quad (\\text{valid for } x > 3)", "x = 2·y for x > 3"),
        ("x = 2y \\quad (\\text{at } T = 5\\,\\mathrm{K})", "x = 2·y for T = 5·K"),
        ("x = 2y \\quad (\\text{since } y = a/2)", "x = 2·y"),
        ("x = 2y \\quad (\\text{so that } z = 3)", "x = 2·y ¦ z = 3"),
    ]);
}

#[test]
fn upright_functions_and_names_of_several_letters() {
    are_read(&[
        ("y = \\mathrm{sin(x)}", "y = sin(x)"),
        ("y = {\\rm tanh[(r-a)/b]}", "y = tanh((r − a)/b)"),
        ("NA = n\\sin\\theta", "NA = n·sin(θ)"),
        ("f = \\frac{GBW}{a}", "f = GBW/a"),
        ("BIL = mg", "B·I·L = m·g"),
        ("BA = c", "B·A = c"),
    ]);
    are_refused(&[
        "\\bar u_i=G*u_i",
        "M = \\langle\\{A,B\\}_{\\pm}\\rangle",
        "H = \\Gamma(a^\\dagger b + b^\\dagger a)",
    ]);
}

#[test]
fn names_functions_and_units_that_a_physicist_reads_at_once() {
    are_read(&[
        ("f = \\frac{64}{Re}", "f = 64/Re"),
        ("f = \\log_{10}(Re/7)", "f = log_{10}(Re/7)"),
        ("Z_1 = V\\left(\\frac{mT}{h^2}\\right)^{3/2}", "Z_1 = V·((m·T)/h^2)^(3/2)"),
        ("\\dot\\rho = -i[H, \\rho]", "ρ̇ = −i·[H, ρ]"),
        ("f(a) = \\frac{1}{2\\pi i}\\oint_C \\frac{f(z)}{z - a} dz", "f(a) = (1/(2·π·i))·∮_{C}((f(z)/(z − a))·dz)"),
        ("a = \\sum_l j_l(kr) P_l(\\cos\\theta)", "a = Σ_{l}(j_l(k·r)·P_l(cos(θ)))"),
        ("u(t) = K e(t)", "u(t) = K·e(t)"),
        ("\\widehat{fg} = a", "hat(f·g) = a"),
    ]);
    are_refused(&["a = i x", "a = \\mathcal{D}[\\hat b][\\hat\\rho]"]);
}

#[test]
fn a_number_that_is_put_in_is_a_factor() {
    are_read(&[
        ("F = 2 \\times (2.5)", "F = 2·2.5"),
        ("K = \\frac12(2.5)", "K = (1/2)·2.5"),
        ("F = (2.0)(2.5)", "F = 2.0·2.5"),
    ]);
    are_refused(&["a = b (2.5)", "\\nabla\\cdot \\mathbf{E} = 0 (1.1)"]);
}
