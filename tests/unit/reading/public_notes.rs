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

#[test]
fn parentheses_after_parentheses_may_hold_an_argument() {
    are_refused(&[
        "(Tf)(x) = a",
        "(f + g)(t) = a",
        "(f * g)(t) = h",
        "(\\mathcal L_v f)(p) = a",
        "(\\hat A\\psi)(x) = a",
    ]);
    are_read(&[
        ("(a + b)(c + d) = e", "(a + b)·(c + d) = e"),
        ("(a + b)x = e", "(a + b)·x = e"),
        ("(2)(x) = e", "2·x = e"),
        ("(-r \\sin\\theta)(B') = e", "(−r·sin(θ))·B' = e"),
    ]);
    are_refused(&["y = h(t) * x(t)"]);
    are_read(&[("y = a * b", "y = a·b")]);
}

#[test]
fn an_operator_with_a_hat_may_have_an_argument() {
    are_refused(&["\\hat R_z(-\\omega t) = a", "\\pi(x) = a", "p = \\pi(a|s)"]);
    are_refused(&["z = f[u, v]", "z = F[n(r), T]"]);
    are_read(&[
        ("\\hat U(-t) = a", "U\u{302}(−t) = a"),
        ("\\hat r(a + b) = \\vec c", "r\u{302}·(a + b) = c\u{20d7}"),
        ("A = 2\\pi(r + h)", "A = 2·π·(r + h)"),
        ("[A, B] = C", "[A, B] = C"),
    ]);
}

#[test]
fn a_derivative_with_d_beside_partial_ones_is_total() {
    for formula in [
        "\\frac{df}{dx} = \\frac{\\partial f}{\\partial x} + \\frac{\\partial f}{\\partial y}\\frac{dy}{dx}",
        "\\frac{d}{dx}\\frac{\\partial F}{\\partial y'} = 0",
    ] {
        assert!(read(formula).starts_with("d/dx("), "{}", read(formula));
    }
    are_read(&[("\\frac{dy}{dx} = a y", "∂y/∂x = a·y")]);
    are_refused(&["\\frac{d}{dt} r \\wedge p = 0", "\\nabla\\cdot\\vec a\\times\\vec b = c"]);
    are_read(&[("{\\frac{d}{dt}}(mv) = F", "d/dt(m·v) = F")]);
}

#[test]
fn what_places_an_environment_or_a_row_is_no_factor() {
    for formula in [
        "\\begin{aligned}[t] a &= b \\end{aligned}",
        "\\begin{array}[t]{l} a = b \\end{array}",
        "\\begin{alignedat}[t]{2} a &= b \\end{alignedat}",
    ] {
        are_read(&[(formula, "a = b")]);
    }
    are_read(&[
        ("\\begin{aligned} a &= b \\\\ [1em] c &= f \\end{aligned}", "a = b ¦ c = f"),
        ("\\begin{aligned} a &= b \\\\ & \\ \\ \\ \\ + c = f \\end{aligned}", "a = b + c = f"),
        ("\\begin{aligned} a &= b \\\\ [x] &= f \\end{aligned}", "a = b ¦ [x] = f"),
    ]);
}

#[test]
fn words_conditions_and_numbers_of_equations_are_no_statements() {
    are_read(&[
        ("a = b \\quad\\text{ou}\\quad c = f", "a = b ou c = f"),
        ("a = b \\quad (x \\to 0)", "a = b for (x→0)"),
        ("a = b \\quad (t \\ll \\tau)", "a = b for (t≪τ)"),
        ("a = b \\text{ as } r \\to \\infty", "a = b as r→∞"),
        ("a = b \\quad\\to\\quad c = f", "a = b ¦ c = f"),
        ("a = b \\; (\\text{general})", "a = b"),
        ("L = 5\\text{ Dynes}", "L = 5·Dynes"),
    ]);
    for number in ["(7-47)", "(2.3-1)", "(A-1)", "[12]", "(1a)", "(15)"] {
        are_read(&[(&format!("a = b \\qquad {number}"), "a = b")]);
    }
    let found = statements_of("a = b \\qquad (1 - x)");
    assert!(found.is_none_or(|found| found.contains('x')));
    are_refused(&["a = b \\quad\\xrightarrow{c = f}\\quad a = f", "a = b \\; (15)", "A \\overset{k}{\\rightarrow} B"]);
}

#[test]
fn words_with_powers_and_short_forms_are_no_products() {
    are_refused(&[
        "K = {\\text{mv}}^2",
        "E = \\text{mc}^2",
        "a = b + VSWR c",
        "a = b ESS",
        "f = \\frac1T [Hz]",
        "E = 5 eV",
    ]);
    are_read(&[("p V = nRT", "p·V = n·R·T"), ("F = 2mg", "F = 2·m·g"), ("m m_1 = a", "m·m_1 = a")]);
    are_refused(&[
        "{\\mu\\pi}_K = a",
        "x{2} = a",
        "\\Delta{2} = a",
        "s = \\uparrow\\downarrow a",
        "F = dk",
        "T = -:\\phi X:",
    ]);
    are_read(&[("u = x^2, \\quad du = 2x dx", "u = x^2 ¦ du = 2·x·dx"), ("dE = T dS", "dE = T·dS")]);
    are_refused(&["[\\mu\\nu, \\kappa] = a", "Z = \\int\\mathcal{D}x\\,e^{iS}", "Z = \\int\\prod_i dx_i e^{-S}"]);
}

#[test]
fn steps_and_marks_in_parentheses() {
    are_refused(&["x^{n+1} = f(x^n)", "k_2 = f(t^{n+1/2}, y^n)", "p^{n+1} - p^n = q", "a = x^{(1/2)}", "a = x^{(-1)}"]);
    are_read(&[
        ("a = 2^{(n-1)}", "a = 2^(n − 1)"),
        ("a = (b + c)^{(n-1)}", "a = (b + c)^(n − 1)"),
        ("a = \\frac{x^{n+1} - x^n}{n}", "a = (x^(n + 1) − x^(n))/n"),
    ]);
    let found = statements_of("\\phi_{j+\\frac12}^{n+\\frac12} = \\phi_j^n + a").unwrap_or_default();
    assert!(!found.contains("^("), "{found}");
}

#[test]
fn digits_in_threes_and_delimiters_in_braces() {
    are_read(&[
        ("a = \\sqrt{10\\,472}", "a = √(10472)"),
        ("a = 2,510.8", "a = 2510.8"),
        ("a = b {\\bigl (} n + 1 {\\bigr )}", "a = b·(n + 1)"),
        ("u = \\arg\\max_x f", "u = argmax_{x}(f)"),
        ("\\require{physics} a = b", "a = b"),
        ("a = b\\space c", "a = b·c"),
        ("ds = r\\sin\\theta\\,\\mathrm d\\phi", "ds = r·sin(θ)·dφ"),
    ]);
    are_refused(&["a = 3 0", "a = 1,000", "a = 10\\,47"]);
}

#[test]
fn names_of_energies_and_numbers_are_one_name() {
    are_read(&[
        ("Re = \\frac{\\rho v D}{\\mu}", "Re = (ρ·v·D)/μ"),
        ("ESS = a", "ESS = a"),
        ("LCV = HCV - a", "LCV = HCV − a"),
        ("KE = \\frac12 m v^2", "KE = (1/2)·m·v^2"),
        ("KE_i + PE_i = E", "KE_i + PE_i = E"),
        ("a{\\times}b{=}c", "a × b = c"),
    ]);
    are_refused(&["E = Re v", "a = 2KE x"]);
    // products of letters that are no such names
    are_read(&[
        ("F = Ma", "F = M·a"),
        ("BIL = mg", "B·I·L = m·g"),
        ("PVT = a", "P·V·T = a"),
        ("x = \\sin{\\frac{x}{2}} y", "x = sin(x/2)·y"),
        ("y = 2{\\frac12} x", "y = 2·(1/2)·x"),
    ]);
}

#[test]
fn symbols_with_two_indices_are_no_functions() {
    are_read(&[
        ("\\Gamma^\\mu_{00}\\left(a^0\\right)^2 = a", "Γ_{00}^{μ}·a^{0}^2 = a"),
        ("y = \\Gamma(x + 1)", "y = Γ(x + 1)"),
        ("a = b \\quad \\text{(Eq. 3.1.3)}", "a = b"),
        ("a = b \\quad \\text{(iv)}", "a = b"),
    ]);
    are_refused(&["y = (f \\circ g)(x)", "K = B^{-T}"]);
}

#[test]
fn errors_of_measurement_and_variations_are_no_factors() {
    are_refused(&[
        "x = (1.0 \\pm 0.4) \\times 10^4",
        "M = 1.2^{+0.8}_{-0.4}",
        "T = 3.0\\text{–}5.2",
        "D_\\mu\\phi = a",
        "\\delta^2 J[\\eta] = a",
        "\\cos\\theta_t = i\\sqrt{\\sin\\theta_i - 1}",
        "r_c^\\gamma = a",
    ]);
    are_read(&[
        ("x = 3 \\pm \\sqrt 2", "x = 3 + √(2) ¦ x = 3 − √(2)"),
        ("\\partial_t u = ru(1-u)", "∂u/∂t = r·u·(1 − u)"),
        ("\\begin{aligned}\\text{Mode 0} &: P = a \\\\ \\text{Mode 1} &: P = b\\end{aligned}", "P = a ¦ P = b"),
    ]);
}

#[test]
fn values_and_letters_beside_their_own_name_are_no_functions() {
    are_read(&[
        ("H(z) = H_0 \\sqrt{\\Omega_m (1+z)^3 + a}", "H(z) = H_0·√(Ω_m·(1 + z)^3 + a)"),
        ("T_\\nu(z) = T_{\\nu,0}(1+z)", "T_ν(z) = T_{ν,0}·(1 + z)"),
        ("u_t = ru(1-u), u(x,0) = a", "u_t = r·u·(1 − u) ¦ u(x, 0) = a"),
        ("S_1(E_1) = S_2(E - E_1)", "S_1(E_1) = S_2(E − E_1)"),
        ("\\theta'' = \\mathrm{Pr}\\,f\\,\\theta'", "θ'' = Pr·f·θ'"),
    ]);
    are_refused(&["H = t[j][k]", "a = Z[J,K]"]);
}

#[test]
fn a_thin_space_ends_the_angle_and_turns_stay_below_the_slash() {
    are_read(&[
        ("x = v_0\\cos\\theta\\,t", "x = v_0·cos(θ)·t"),
        ("f = \\omega/2\\pi", "f = ω/(2·π)"),
        ("p = P_0(V - V_0)", "p = P_0·(V − V_0)"),
        ("e(t) = a - b", "e(t) = a − b"),
    ]);
    are_refused(&["x = \\cos\\omega\\,t", "f = 1/2\\pi", "f = \\omega/2\\pi x"]);
}
