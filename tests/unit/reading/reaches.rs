//! How far a sign, an operator or a bracket reaches, and what must not be lost in it. Beside each stands what stays as it is, or
//! what is refused.

use super::{are_read, are_refused};

#[test]
fn a_sum_reaches_over_the_signs_that_bind_as_a_product() {
    are_read(&[
        ("S = \\sum_i a_i \\otimes b_i", "S = Σ_{i}(a_i ⊗ b_i)"),
        ("S = \\sum_i a_i \\odot b_i + c", "S = Σ_{i}(a_i ⊙ b_i) + c"),
        ("S = c \\otimes \\sum_i a_i \\otimes b_i", "S = c ⊗ Σ_{i}(a_i ⊗ b_i)"),
        ("S = \\int \\sigma : \\epsilon \\, dV", "S = ∫((σ : ϵ)·dV)"),
        ("E = \\lim_{n \\to \\infty} a_n \\otimes b_n", "E = lim_{n → ∞}(a_n ⊗ b_n)"),
        ("S = a \\otimes b", "S = a ⊗ b"),
    ]);
    are_refused(&["\\nabla \\cdot \\vec a \\otimes \\vec b = 0"]);
}

#[test]
fn a_mean_value_and_a_trace_with_an_index_act_on_the_rest_of_the_term() {
    are_read(&[
        ("g = \\mathbb{E}_x \\log p(x) - c", "g = E_{x}(log(p(x))) − c"),
        ("g = \\mathbb{E} X^2", "g = E(X^2)"),
        ("g = \\mathbb{E}[X^2] - \\mathbb{E}[X]^2", "g = E[X^2] − E[X]^2"),
        ("g = \\operatorname{E}[X^2]", "g = E[X^2]"),
        ("\\rho_A = \\operatorname{Tr}_B \\rho", "ρ_A = Tr_{B}(ρ)"),
        ("\\rho = \\mathrm{Tr}_B |a\\rangle\\langle a|", "ρ = Tr_{B}(|a⟩·⟨a|)"),
    ]);
    are_refused(&["g = \\operatorname{E}(a + b)"]);
}

#[test]
fn what_stands_behind_a_bar_in_braces_is_not_lost() {
    are_read(&[
        ("A = \\left\\{ x \\;\\middle|\\; y = c \\right\\}", "A = {x | y=c}"),
        ("A = \\left\\{ x \\;\\middle|\\; |x| = c y \\right\\}", "A = {x | |x|=cy}"),
        ("\\left\\langle a \\middle| b \\right\\rangle = 1", "⟨a|b⟩ = 1"),
        ("P(A\\vert B) = c", "P(A | B) = c"),
        ("\\vert a \\vert = b", "|a| = b"),
    ]);
    are_refused(&["A = \\{ x | y = c |", "A = \\{ x | |y| = c \\}"]);
}

#[test]
fn bars_of_states_are_those_of_any_command() {
    are_read(&[
        ("\\lvert a\\rangle = c\\lvert 0\\rangle", "|a⟩ = c·|0⟩"),
        ("\\langle a\\rvert H \\lvert a\\rangle = E", "⟨a|H|a⟩ = E"),
        ("\\lvert a \\rvert\\lvert b\\rvert = c", "|a|·|b| = c"),
    ]);
    are_refused(&["\\lvert a = c"]);
}

#[test]
fn between_two_relations_stands_a_formula() {
    are_refused(&["a \\approx = b", "\\propto = a"]);
    are_read(&[("= b", "… = b"), ("a =", "a = …")]);
}

#[test]
fn the_rows_behind_a_brace_are_equations_of_their_own() {
    are_read(&[("\\begin{cases} x = 1 \\\\ -y = 2 \\end{cases}", "x = 1 ¦ −y = 2")]);
    are_refused(&["\\begin{gathered} x = 1 \\\\ -y = 2 \\end{gathered}"]);
}

#[test]
fn a_minus_behind_a_sum_is_that_of_what_is_summed() {
    are_read(&[
        ("H = \\sum_{x \\in X} -p(x) \\log p(x)", "H = Σ_{x ∈ X}(−p(x)·log(p(x)))"),
        ("S = \\sum_i -a_i + b", "S = Σ_{i}(−a_i) + b"),
        ("S = \\sum_i a_i - b", "S = Σ_{i}(a_i) − b"),
    ]);
    are_refused(&["S = \\sum_i a_i - b_i"]);
}

#[test]
fn what_says_of_what_set_something_is_may_be_a_condition() {
    are_read(&[
        ("a \\in G \\quad\\Longrightarrow\\quad f(a) = 0", "f(a) = 0 for a∈ G"),
        ("a \\in G \\Rightarrow a \\in H", "a ∈ G ¦ a ∈ H"),
        ("u \\gets u + a", "u ← (u + a)"),
    ]);
    are_refused(&["X \\mid z = k, w = j \\sim N(a)"]);
}

#[test]
fn a_set_is_not_its_element() {
    are_read(&[
        ("A = \\{ x_i \\}", "A = {x_i}"),
        ("B = \\{ |n\\rangle \\}", "B = {|n⟩}"),
        ("a = \\{ b + c \\} d", "a = (b + c)·d"),
    ]);
    are_refused(&["A = \\{ x_i"]);
}
