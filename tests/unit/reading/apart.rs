//! Statements, terms and remarks that stand apart, and what is no factor though it stands beside one.

use super::{are_read, are_refused};

#[test]
fn spaces_between_statements_and_before_terms() {
    are_read(&[
        ("a = b \\hspace{40px} c = d", "a = b ¦ c = d"),
        ("L = T\\quad - V", "L = T − V"),
        ("y = a \\quad + b \\quad + c", "y = a + b + c"),
        ("x = a \\quad -y = b", "x = a ¦ −y = b"),
        ("x = 5~~\\text{m}", "x = 5·m"),
        ("\\begin{array}{ll} a = b & c = d \\\\ e = f & g = h \\end{array}", "a = b ¦ c = d ¦ e = f ¦ g = h"),
    ]);
    are_refused(&[
        "a = b ~~ c = d",
        "F = -kx \\quad\\text{(spring)} - bv \\quad\\text{(drag)}",
        "E = \\frac12mv^2 \\text{ (kinetic)} + mgh",
        "\\begin{cases} x = 0 & t = 0 \\\\ x = a & t = b \\end{cases}",
    ]);
}

#[test]
fn remarks_reasons_and_lists_of_names() {
    are_read(&[
        ("y = ax\\ \\ (\\mathrm{linear})", "y = a·x"),
        ("a = b \\quad (\\because c = d)", "a = b"),
        (
            "f = \\begin{cases} 1 & \\text{inside} \\\\ 0 & \\text{outside} \\end{cases}",
            "f = {1 if inside; 0 if outside}",
        ),
    ]);
    are_refused(&[
        "\\begin{cases} x & \\text{position} \\\\ v & \\text{velocity} \\end{cases}",
        "B = \\{n : n \\text{ odd}\\}",
        "<x> = a",
    ]);
}

#[test]
fn marks_before_a_formula_may_say_that_it_changes() {
    are_read(&[("d\\sin\\theta = m\\lambda", "d·sin(θ) = m·λ"), ("d\\ln T = \\frac{dT}{T}", "d(ln(T)) = dT/T")]);
    are_refused(&["\\delta\\ln W = 0", "d\\ln T = a", "\\Delta\\frac1\\lambda = a"]);
}

#[test]
fn a_term_with_its_sign_in_braces_is_no_factor() {
    are_read(&[("a = {-b} + c", "a = (−b) + c"), ("x = a + \\underbrace{-b}_{c}", "x = a + ⏟{−b}_{c}")]);
    are_refused(&["a = b {+c} + d", "L = T \\underbrace{- V}_{p}"]);
}

#[test]
fn parentheses_that_hold_a_factor_or_a_place() {
    are_read(&[
        ("P = V\\left(\\frac{V}{R}\\right)", "P = V·(V/R)"),
        ("\\int \\psi^*(T + V)\\psi\\,dx = E", "∫((ψ^{*}·(T + V)·ψ)·dx) = E"),
    ]);
    are_refused(&[
        "P = \\dot p^2(t - r/c)",
        "u^\\mu = \\gamma(c, \\mathbf v)",
        "p^\\mu = E(1, 0, 0, 1)",
        "F = m(\\ddot x)",
    ]);
}

#[test]
fn an_i_beside_an_index_i_is_unclear() {
    are_read(&[("\\sum_i i x_i = a", "Σ_{i}(i·x_i) = a")]);
    are_refused(&["[x_i, p_j] = i\\delta_{ij}", "\\dot c_i = -i\\sum_j H_{ij} c_j"]);
}

#[test]
fn functions_of_other_languages_are_refused_by_name() {
    are_read(&[("x = a \\mathrm{sech}\\,\\varphi", "x = a·sech(ϕ)"), ("AR = b^2/S", "AR = b^2/S")]);
    are_refused(&["a = g\\operatorname{sen}\\theta", "y = \\operatorname{tg}\\alpha", "y = \\text{sinh}\\,x"]);
}

#[test]
fn signs_in_a_set_make_no_alternatives() {
    are_read(&[("m \\in \\{0, \\pm1\\}", "m ∈ {0,±1}")]);
}
