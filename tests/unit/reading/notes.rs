//! What displays of public notes were once read wrongly or refused without need. Beside each stands what differs little and
//! is read in another way, or is refused.

use super::*;
use onshell::formula::symbols::Name;

#[test]
fn a_wide_space_separates_whatever_its_name() {
    for space in ["\\hspace{25pt}", "\\hspace*{1cm}", "\\hskip 1cm ", "\\kern 20pt ", "\\mskip18mu ", "~~~", "\\quad "]
    {
        are_read(&[(&format!("a = b{space}c = d"), "a = b ¦ c = d")]);
    }
    for space in ["\\hspace{2pt}", "\\kern.1em ", "\\hspace{-1cm}", "~", "\\,"] {
        are_read(&[(&format!("a = b{space}c"), "a = b·c")]);
    }
}

#[test]
fn letters_above_are_indices_where_the_display_shows_it() {
    are_read(&[
        ("\\partial_\\alpha F^{\\beta\\alpha} = \\mu_0 j^\\beta", "∂_{α}(F^{βα}) = μ_0·j^{β}"),
        ("A^\\alpha = (\\phi, \\mathbf A)", "A^{α} = (φ, A)"),
        ("A^\\beta B_\\beta = c", "A^{β}·B_β = c"),
        ("0 = A^{iill} - A^{iikk}", "0 = A^{iill} − A^{iikk}"),
        ("F^{ij} = -F^{ji}", "F^{ij} = −F^{ji}"),
        ("a_n x^n = c", "a_n·x^(n) = c"),
        ("e^{\\alpha\\beta} = x", "e^(α·β) = x"),
    ]);
    are_refused(&["r^\\alpha = a r", "x^{ab} = c", "x^{ij} = c", "x^{\\alpha\\beta} = (x^\\alpha)^\\beta"]);
}

#[test]
fn delta_is_a_factor_beside_other_coefficients() {
    are_read(&[
        ("\\dot v = -\\delta v - \\alpha x", "v̇ = −δ·v − α·x"),
        ("\\frac12 \\delta \\theta^2 + \\epsilon z \\theta = E", "(1/2)·δ·θ^2 + ϵ·z·θ = E"),
        ("\\delta S = \\alpha \\delta q", "δS = α·δq"),
        ("\\delta\\sqrt{-g} = a \\delta g", "δ(√(−g)) = a·δg"),
        ("f(q + \\delta q) = f(q) + \\alpha \\delta q + \\beta q", "f(q + δq) = f(q) + α·δq + β·q"),
    ]);
}

#[test]
fn a_letter_before_a_parenthesis() {
    are_read(&[
        ("P = P_0\\left(\\frac{T}{T_0}\\right)^{\\chi_T}", "P = P_0·(T/T_0)^(χ_T)"),
        ("P_l(\\cos\\theta) = P_l(x)", "P_l(cos(θ)) = P_l(x)"),
        ("a = V(\\nabla\\cdot\\vec E)", "a = V·∇·(E⃗)"),
        ("\\Gamma(n + 1) = n!", "Γ(n + 1) = n!"),
        ("a = \\hbar(b)", "a = ħ·b"),
        ("S(E) = S_1(E_1) + S_2(E - E_1)", "S(E) = S_1(E_1) + S_2(E − E_1)"),
        ("U(x) = U_0(1 - x)", "U(x) = U_0·(1 − x)"),
        ("V(x) = V_0(x - a)^2", "V(x) = V_0·(x − a)^2"),
        ("V_0(x) = a", "V_0(x) = a"),
        ("P(n) = \\Omega(q - n)", "P(n) = Ω(q − n)"),
        ("Z = Z_1^N", "Z = Z_1^(N)"),
    ]);
    are_refused(&["p = e^{i\\Gamma(x/c - t)}"]);
    // F is no real number beside 1/u.
    let mut symbols = Symbols::for_reading();
    read_display("a = F\\left(\\frac1u\\right)", &mut symbols, &Macros::default());
    let kind = symbols.find(&Name::plain("F")).map(|(id, _)| symbols.entry(id).kind);
    assert_eq!(kind, Some(Kind::Abstract));
}

#[test]
fn a_colon_binds_as_a_product() {
    are_read(&[("\\sigma = \\mathbf D : \\mathbf e - \\beta T", "σ = (D : e) − β·T"), ("f : A \\to B", "f : A → B")]);
}

#[test]
fn marks_of_differentials() {
    are_read(&[
        ("I = \\int f \\textrm{d}x", "I = ∫(f·dx)"),
        ("dU = \\dbar Q + \\dbar W", "dU = đQ + đW"),
        ("dS = \\frac{\\bar d Q}{T}", "dS = đQ/T"),
        ("\\frac{\\tilde{\\mathrm d}}{\\mathrm d t} \\vec a = \\vec b", "d̃/dt(a⃗) = b⃗"),
        ("\\left(\\frac{d\\vec a}{dt}\\right)_S = \\vec b", "(d a⃗/dt)_{S} = b⃗"),
        ("\\left(\\frac{dx}{dt}\\right)_{t=0} = v", "(d/dt(x))|_{t=0} = v"),
        ("\\bar x Q = a", "x̄·Q = a"),
    ]);
}

#[test]
fn hats_with_a_power_are_operators() {
    are_read(&[
        ("\\langle \\hat x^2 \\rangle = a", "⟨x̂^2⟩ = a"),
        ("\\hat p^2 = 2 m E", "p̂^2 = 2·m·E"),
        ("\\hat x \\cdot \\vec v = a", "x̂ • v⃗ = a"),
    ]);
}

#[test]
fn remarks_are_no_statements() {
    are_read(&[
        ("\\ell = a \\quad (\\text{in }3+1\\text{ dimensions})", "ℓ = a"),
        ("a = 0 \\mbox{ by hypothesis}", "a = 0"),
        ("\\frac{\\partial L}{\\partial \\dot q} = constant", "∂L/∂q̇ is constant"),
        ("x = 1 \\text{ or } x = 2", "x = 1 or x = 2"),
    ]);
    are_refused(&["a = constant + b", "a \\stackrel{?}{=} b"]);
}

#[test]
fn primes_of_another_frame() {
    are_read(&[("x' = x - vt", "x' = x − v·t"), ("U' = \\Lambda U", "U' = Λ·U"), ("U' = U + m a x", "U' = U + m·a·x")]);
    are_refused(&["y' = y - x t", "x' = x + a", "y' = -k y"]);
}

#[test]
fn environments_inside_of_others() {
    are_read(&[
        ("\\begin{equation}\\begin{split} a &= b \\\\ &= c \\end{split}\\end{equation}", "a = b = c"),
        ("\\begin{equation*}\\begin{cases} a = b \\\\ c = d \\end{cases}\\end{equation*}", "a = b ¦ c = d"),
        ("\\begin{array}{rcl} a & = & b \\\\ c & = & d \\end{array}", "a = b ¦ c = d"),
        ("a|n\\rangle = b \\quad (a|0\\rangle = 0)", "a·|n⟩ = b ¦ a·|0⟩ = 0"),
        ("\\displaylines{a = b \\\\ c = d}", "a = b ¦ c = d"),
        ("A = \\begin{pmatrix} a, \\\\ b. \\end{pmatrix}", "A = [a; b]"),
        ("a = \\left({b \\over c}\\right)^2 + \\left(b \\over c\\right)", "a = (b/c)^2 + b/c"),
        ("1 = \\underbrace{a = b}_{\\text{one}}", "1 = ⏟{a = b}_{one}"),
    ]);
    are_refused(&["\\begin{equation}\\begin{cases} a \\\\ b \\end{cases}\\end{equation}", "(a \\over b)"]);
}

#[test]
fn points_beside_nabla_and_in_lists() {
    are_read(&[
        ("\\nabla.\\vec E = \\rho", "∇·(E⃗) = ρ"),
        ("f(x, y, ....., t) = 0", "f(x, y, …, t) = 0"),
        ("\\lim_{\\Delta t \\to 0} \\frac{\\Delta x}{\\Delta t} = v", "lim_{Δt → 0}(Δx/Δt) = v"),
        ("b = \\frac{a}{\\sqrt{e^2 - 1}}", "b = a/√(e^2 − 1)"),
        ("A = Pe^{-x}", "A = P·e^(−x)"),
    ]);
    are_refused(&["e^2 + 1 = x", "KE x = T"]);
}
