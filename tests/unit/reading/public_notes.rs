//! Forms that public notes print, which were read as something else or not at all.

use super::{are_read, are_refused, statements_of};

fn read(latex: &str) -> String {
    statements_of(latex).unwrap_or_else(|| panic!("{latex} is refused"))
}

#[test]
fn a_space_before_a_second_left_side_is_no_product() {
    are_refused(&["\\sin x = \\frac{2u}{1+u^2} \\; \\csc x = \\frac{1+u^2}{2u}"]);
    are_read(&[
        ("\\sin x = 2u \\quad \\csc x = v", "sin(x) = 2·u ¦ csc(x) = v"),
        ("y = a \\; \\sin x = b", "y = a·sin(x) = b"),
        ("\\sin x = a + \\; \\cos x = b", "sin(x) = a + cos(x) = b"),
    ]);
}

#[test]
fn a_brace_before_equations_is_a_system() {
    are_read(&[
        ("\\left\\{ a = y, b = -x \\right.", "a = y ¦ b = −x"),
        ("\\begin{cases} x = 1 \\\\ y = 2 \\end{cases} \\quad z = 3", "x = 1 ¦ y = 2 ¦ z = 3"),
        ("\\eqalign{ a &= b + c \\cr d &= e }", "a = b + c ¦ d = e"),
        (
            "f(x) = \\left\\{\\begin{array}{ll} a & x>0 \\\\ b & x<0 \\end{array}\\right.",
            "f(x) = {a if x > 0; b if x < 0}",
        ),
    ]);
    are_refused(&["S = \\left\\{ x = 1 \\right."]);
}

#[test]
fn the_signs_around_a_formula_are_no_part_of_it() {
    let plain = read("E = m c^2");
    for formula in ["$E = m c^2$", "$$ E = m c^2 $$", "\\[ E = m c^2 \\]", "\\( E = m c^2 \\)"] {
        assert_eq!(read(formula), plain, "{formula}");
    }
    are_refused(&["$E = m$ c^2", "$a$ = $b$"]);
}

#[test]
fn two_bars_are_those_of_a_norm() {
    are_read(&[
        ("\\frac12 ||x - y||^2 = a", "(1/2)·|x − y|^2 = a"),
        ("|x||y||z| = 1", "|x|·|y|·|z| = 1"),
        ("f\\big\\vert_{x=L} = g", "(f)|_{x=L} = g"),
        ("\\hat x_{k|k-1} = a", "x̂_{k|k-1} = a"),
    ]);
}

#[test]
fn steps_stand_above_vectors_and_in_differences_by_a_step() {
    are_read(&[
        ("\\nabla\\cdot\\mathbf u^{n+1} = q^{n+1}", "∇·(u^{n+1}) = q^{n+1}"),
        ("\\frac{u^{n+1} - u^n}{h} = f", "(u^{n+1} − u^{n})/h = f"),
    ]);
    // a difference of powers
    are_read(&[("\\frac{x^{n+1} - x^n}{x} = f", "(x^(n + 1) − x^(n))/x = f")]);
}

#[test]
fn a_divergence_of_a_product_with_a_gradient_is_that_of_all_of_it() {
    are_read(&[
        ("\\nabla\\cdot k\\nabla T = 0", "∇·(k·∇(T)) = 0"),
        ("\\nabla\\cdot M(\\nabla \\mu) = 0", "∇·(M·∇(μ)) = 0"),
    ]);
    are_refused(&["\\nabla k\\nabla T = 0"]);
}

#[test]
fn an_operator_at_another_place_is_no_product() {
    are_refused(&["\\langle \\hat A(\\theta + \\epsilon) \\rangle = 0"]);
    are_read(&[("\\hat A(\\hat B + \\hat C) = 0", "A\u{302}·(B\u{302} + C\u{302}) = 0")]);
    are_read(&[("\\beta\\,\\mathrm{d}\\langle E\\rangle = f", "β·d⟨E⟩ = f")]);
}

#[test]
fn marks_and_labels_are_no_powers() {
    are_refused(&["j = \\psi\\gamma^\\mu\\gamma^5\\psi", "x = G^s"]);
    for formula in ["c^{s\\dagger} = a", "\\hat H^{\\dagger(1)} = a", "U^{\\mathrm{dis}(k)} = a"] {
        let found = statements_of(formula).unwrap_or_default();
        assert!(!found.contains("^("), "{formula}: {found}");
    }
    are_read(&[("x = g^s", "x = g^(s)"), ("\\bold{a} = b_\\bold{p}", "a = b_p")]);
    are_refused(&["E = c_\\unheard{p}"]);
}

#[test]
fn words_are_no_factors() {
    are_read(&[
        ("S = g^2 \\text{Tr}[A B]", "S = g^2·Tr[A·B]"),
        ("u = 1 {\\rm in}\\ \\Omega", "u = 1 in Ω"),
        ("a = b \\mathrm{ so } c = f", "a = b ¦ c = f"),
        ("a = b_i; \\text{ for } 1 \\leq i \\leq m", "a = b_i for 1 ≤ i ≤ m"),
        ("a = b, k \\in \\{n, p\\}", "a = b ¦ k ∈ {n, p}"),
        ("T^3 V = a = cte", "T^3·V = a is constant"),
        ("f \\sim \\mathcal{GP}(m, k)", "f ∼ GP(m, k)"),
    ]);
    // a constant that is a term is no remark about the side
    assert!(!read("y = \\text{const} + x^2").contains("constant"), "{}", read("y = \\text{const} + x^2"));
}

#[test]
fn a_sum_after_the_measure_of_a_space_may_be_integrated() {
    are_refused(&["S = \\int d^4x\\; a \\psi + j \\phi"]);
    are_read(&[("S = \\int d^4x\\; (a \\psi + j \\phi)", "S = ∫(d^{4}x·(a·ψ + j·φ))")]);
}

#[test]
fn letters_of_another_alphabet_are_printed_in_it() {
    are_read(&[("\\mathcal{A} = A + \\mathscr{L}", "𝒜 = A + ℒ"), ("\\overline{u' c'} = a", "overline(u'·c') = a")]);
}

#[test]
fn braces_around_an_argument_print_nothing() {
    are_read(&[("y = \\sin{\\left(x \\right)}", "y = sin(x)"), ("V = m 4\\pi r^2", "V = m·4·π·r^2")]);
    assert_eq!(read("m\\_1 = a"), read("m_1 = a"));
    are_refused(&["m4 = a"]);
}

#[test]
fn the_region_of_a_function_is_its_condition() {
    are_read(&[("f(x) = 0, \\quad x < a", "f(x) = 0 for x < a"), ("f(x) = 0, \\quad a < b", "f(x) = 0 ¦ a < b")]);
}

#[test]
fn long_chains_of_functions_are_refused() {
    let chain = |name: &str| format!("y = {}x", name.repeat(5000));
    for name in ["\\sin ", "\\ln ", "\\int ", "\\sum ", "\\lim ", "\\cos^2 ", "\\nabla "] {
        are_refused(&[chain(name).as_str()]);
    }
}
