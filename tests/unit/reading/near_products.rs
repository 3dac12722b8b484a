//! What prints like a product and is none: bold differentials, numbers of flows, units, words, labels. Beside each stands what differs
//! little and is read, or is refused.

use super::{are_read, are_refused, statements_of};

#[test]
fn a_bold_d_is_the_differential_of_an_integral_and_is_refused_before_a_letter_elsewhere() {
    are_read(&[
        ("\\int P\\,\\mathbf{d}V = W", "∫(P·dV) = W"),
        ("F = \\int_a^b \\boldsymbol{d}x\\,f(x)", "F = ∫_{a}^{b}(dx·f(x))"),
        ("\\mathbf{p} = q\\mathbf{d}", "p = q·d"),
        ("\\mathbf{d}\\cdot\\mathbf{E} = a", "d • E = a"),
        ("W_1\\mathbf{d}_1 x = a", "W_1·d_1·x = a"),
    ]);
    are_refused(&["T\\mathbf{d}S = p\\mathbf{d}V", "\\int_0^1 \\mathbf{d}x\\,dx = a"]);
}

#[test]
fn a_number_of_a_flow_is_a_name_where_it_is_equal_to_a_quotient() {
    are_read(&[
        ("Ma = \\frac{V}{c}", "Ma = V/c"),
        ("Ma = v/c", "Ma = v/c"),
        ("Pr = \\frac{\\nu}{\\alpha}", "Pr = ν/α"),
        ("Fr = \\frac{v}{\\sqrt{gL}}", "Fr = v/√(g·L)"),
        ("Nu = 0.023 Re^{0.8} Pr^{0.4}", "Nu = 0.023·Re^0.8·Pr^0.4"),
        ("Re_m = Re_p", "Re_m = Re_p"),
        ("a = 1 + \\frac{\\gamma - 1}{2}\\mathrm{Ma}^2", "a = 1 + ((γ − 1)/2)·Ma^2"),
        ("\\Delta x = \\frac{0.61\\lambda}{NA}", "Δx = (0.61·λ)/NA"),
        // products
        ("F = Ma", "F = M·a"),
        ("Ma = F", "M·a = F"),
        ("Ma = \\frac{dp}{dt}", "M·a = d/dt(p)"),
        ("n = \\frac{V}{NA}", "n = V/(N·A)"),
    ]);
    are_refused(&[
        "Ma = \\frac{a}{b}",
        "p = p_0(1 + \\frac{\\gamma - 1}{2}Ma^2)",
        "St = fL/U",
        "Fr = \\frac{L}{t}",
        "F = Pr",
        "v = Re_r",
    ]);
}

#[test]
fn a_letter_behind_a_number_is_the_unit_of_the_left_side() {
    are_refused(&["t = 3 s", "x = 5 m", "v = 3 m/s", "E = 5\\,J", "V = 5 V"]);
    are_read(&[
        ("x = 2m, \\quad m = 3", "x = 2·m ¦ m = 3"),
        ("F = 2T", "F = 2·T"),
        ("t = 3\\,\\text{s}", "t = 3·s"),
        ("\\lambda = 5000\\,\\AA", "λ = 5000·Å"),
        ("d = 3 \\AA", "d = 3·Å"),
    ]);
}

#[test]
fn words_directly_behind_a_number_may_be_its_unit() {
    are_refused(&["a = 14.0 \\text{ billion years}", "a = 5 \\text{ apples}"]);
    are_read(&[
        ("a = 2.5 \\text{ days}", "a = 2.5·day"),
        ("a = 3 \\quad \\text{(exact)}", "a = 3 ¦ exact"),
        ("a = 1 \\text{ for } b = 2", "a = 1 for b = 2"),
    ]);
}

#[test]
fn a_lone_letter_between_equations_and_letters_under_an_arrow_are_refused() {
    are_refused(&["a = b \\quad e \\quad c = d", "\\vec{P_Mec} = c", "\\vec{ab} = c"]);
    are_read(&[("a = b, \\quad c = d", "a = b ¦ c = d"), ("\\vec{P}_{Mec} = m\\vec v", "P⃗_{Mec} = m·v⃗")]);
}

#[test]
fn a_letter_before_a_letter_for_which_the_display_is_solved_is_no_function() {
    are_refused(&["E(A) = \\frac{Q}{\\epsilon_0} \\\\ E = \\frac{Q}{\\epsilon_0 A}"]);
    are_read(&[("V(r) = \\frac{k}{r} \\\\ V = \\frac{k}{R}", "V(r) = k/r ¦ V = k/R")]);
}

#[test]
fn parentheses_behind_parentheses_and_brackets_behind_a_quantity_are_refused() {
    are_refused(&["p = f\\left(\\frac{L}{D}\\right)\\left(\\frac{v^2}{2}\\right)", "S = \\mathcal{N}[a + b]"]);
    are_read(&[
        ("p = f\\,\\frac{L}{D}\\,\\frac{v^2}{2}", "p = f·(L/D)·(v^2/2)"),
        ("S = V\\left(\\frac{a}{b}\\right)", "S = V(a/b)"),
        ("c(\\infty) = 5", "c(∞) = 5"),
    ]);
}

#[test]
fn operators_in_a_text_act_and_are_no_words() {
    are_read(&[
        ("a = \\text{Tr}\\,A", "a = tr(A)"),
        ("a = \\text{det} A", "a = det(A)"),
        ("\\text{Re} \\approx 2300", "Re ≈ 2300"),
        ("f = \\frac{64}{\\text{Re}}", "f = 64/Re"),
    ]);
    are_refused(&["a = \\text{Re}\\,\\Sigma(k)", "\\text{Im} z = a", "a = \\text{Tr}\\ln D"]);
}

#[test]
fn an_image_and_another_place_have_primes_that_are_no_derivatives() {
    are_read(&[
        ("\\frac1s + \\frac1{s'} = \\frac1f", "1/s + 1/s' = 1/f"),
        ("\\frac{n'}{s'} - \\frac ns = \\frac{n' - n}{R}", "n'/s' − n/s = (n' − n)/R"),
        ("\\tan a = \\frac{h}{s - d} \\quad \\tan b = \\frac{h}{s' - d}", "tan(a) = h/(s − d) ¦ tan(b) = h/(s' − d)"),
        ("f(x', y') = f(x, y) + x'", "f(x', y') = f(x, y) + x'"),
        ("\\int f(x)\\,d^3x' = \\int g\\,d^3x", "∫(f(x)·d^{3}x') = ∫(g·d^{3}x)"),
    ]);
    are_refused(&["m = \\frac{y'}{y}", "\\frac{y}{y'} = x", "s' = -\\frac{B + As}{D + Cs}", "f(y', z') = a y"]);
}

#[test]
fn orders_indices_labels_and_transposes_above_a_letter() {
    are_read(&[
        ("\\frac{d^{n-1}y}{dt^{n-1}} = a", "(d^{n-1} y)/(dt^{n-1}) = a"),
        ("\\tau = J^{-T}F", "τ = J^{-T}·F"),
        ("I_{11}^{CM} = b", "I_{11}^{CM} = b"),
        ("\\varepsilon^p_{3,3} = a", "ε_{3,3}^{p} = a"),
        ("S = \\ln\\langle x \\rangle_0", "S = ln(⟨x⟩_{0})"),
        ("\\sum_i i(i + 1) = a", "Σ_{i}(i·(i + 1)) = a"),
        ("e^{-\\beta\\left(\\frac{p^2}{2m}\\right)} = a", "e^(−β·(p^2/(2·m))) = a"),
    ]);
    are_refused(&[
        "V = d^{n-1} x",
        "y = x^{-T}",
        "a = \\varepsilon(u) - \\varepsilon^p",
        "S = \\ln(x)_0",
        "\\sum_i a_i e^{i(k x_i - \\omega t)} = 0",
    ]);
}

#[test]
fn rows_without_brackets_and_numbers_behind_remarks_are_read() {
    are_read(&[
        ("\\begin{matrix} a = b \\\\ c = d \\end{matrix}", "a = b ¦ c = d"),
        ("\\begin{cases}\\begin{aligned} a &= b \\\\ c &= d \\end{aligned}\\end{cases}", "a = b ¦ c = d"),
        ("W = mg \\quad \\text{(N)} \\quad (1–2)", "W = m·g ¦ N"),
        (
            "\\hat x = \\cos\\phi\\,\\hat{\\boldsymbol{i}} + a\\hat{\\boldsymbol{j}}",
            "x\u{302} = cos(φ)·i\u{302} + a·j\u{302}",
        ),
    ]);
    assert_eq!(
        statements_of("\\begin{matrix} a & b \\\\ c & d \\end{matrix} = M").as_deref(),
        Some("[a, b; c, d] = M")
    );
}
