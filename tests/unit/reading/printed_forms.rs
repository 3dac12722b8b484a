//! Forms that authors print: boxes, labels, asides, rows, lists that go on, arrows, applications. Beside each stands a form that
//! differs little, and is read otherwise or refused.

use super::*;

#[test]
fn a_box_of_text_around_a_formula_changes_nothing() {
    are_read(&[
        (r"a = \left(\mbox{\colorbox{red}{$\displaystyle -\frac{b}{c}$}}\right) d_0", "a = (−b/c)·d_0"),
        (r"a\text{=-}b", "a = −b"),
        (r"\mathbf{a}\boldsymbol{\cdot}\mathbf{b} = c", "a • b = c"),
        (r"a = b \mathrm{,\ } c = f", "a = b ¦ c = f"),
        (r"\Sigma := \pmatrix{a & b \cr b & c}", "Σ ≡ [a, b; b, c]"),
        (r"B = \left[A D\right]^\#", "B = (A·D)^{♯}"),
    ]);
    // must-fail cases: a box of words, and a formula among words.
    are_refused(&[r"a = \colorbox{red}{b} c"]);
    assert_ne!(statements_of(r"a\text{-b}"), statements_of("a - b"));
}

#[test]
fn a_word_before_a_row_names_it() {
    are_read(&[
        (r"\text{Mass:}\quad a &= b \\ \text{Momentum-}x\text{:}\quad c &= f", "a = b ¦ c = f"),
        (
            r"\begin{alignat*}{2} &\text{Mass:} &\quad 0 &= a \\ &\text{Force:} &\quad 0 &= b \end{alignat*}",
            "0 = a ¦ 0 = b",
        ),
        (r"\text{\textbf{Energy}} \qquad E = mc^2", "E = m·c^2"),
        (r"k = a, \quad \text{where } a = b", "k = a ¦ a = b"),
    ]);
    // must-fail cases: what is supposed, and words that say something of a letter.
    for supposed in [
        r"\text{Suppose}\quad a = b",
        r"\text{Let us assume:}\quad a = b",
        r"\text{Not:}\quad a = b",
        r"\text{if}\quad a = b",
    ] {
        assert_ne!(statements_of(supposed).as_deref(), Some("a = b"), "{supposed}");
    }
    are_refused(&[r"a = 0 \Rightarrow \Gamma \text{ is unique}"]);
}

#[test]
fn a_parenthesis_may_hold_a_further_statement() {
    are_read(&[
        (r"a = b \qquad (\Rightarrow c = 0)", "a = b ¦ c = 0"),
        (r"a = b \qquad (\text{with } c \approx 0)", "a = b ¦ c ≈ 0"),
        (r"a = b \qquad (c > 0)", "a = b for c > 0"),
        (r"V(x) \to \infty \text{ whenever } x \to \infty", "V(x) → ∞ whenever x→∞"),
        (r"a = \mathrm{const}. = b", "a = b is constant"),
    ]);
    assert_ne!(statements_of("a = b. c = f").as_deref(), Some("a = b = f"));
}

#[test]
fn a_list_that_goes_on_is_no_product() {
    are_read(&[
        (r"k = \frac{n\pi}{L}, \qquad n=0,1,2,3...", "k = (n·π)/L"),
        (r"a = b \\ = c", "a = b = c"),
        (r"a = b = \\ = c", "a = b = c"),
        (r"a = b + c\,(c-1)\cdots(c-n)", "a = b + c·(c − 1)·…·(c − n)"),
    ]);
    are_refused(&[r"V = a_0 + a_1 x + a_2 x^2 ... = b"]);
}

#[test]
fn signs_of_order_and_arrows_with_a_condition() {
    are_read(&[
        (r"V(x) \succ 0, \quad P \preceq 0", "V(x) ≻ 0 ¦ P ⪯ 0"),
        (r"D \equiv a r \rightarrow^{a=1} r", "D ≡ (a·r) →^{a=1} r"),
        (r"J(\theta) \in \mathbb{R}^{6\times n}", "J(θ) ∈ R^{6× n}"),
    ]);
    are_refused(&[r"E = mc^2 \rightarrow m = a"]);
}

#[test]
fn a_row_may_begin_with_a_minus() {
    are_read(&[(r"a - b = 0 \\ -c = f \\ -g = h", "a − b = 0 ¦ −c = f ¦ −g = h")]);
    are_refused(&[r"a = b \\ -c = f", r"-a = b \\ -c = f"]);
}

#[test]
fn what_a_parenthesis_after_a_name_or_a_parenthesis_is() {
    are_read(&[
        (r"D\{a\cos\delta + b\sin\delta\} = c", "D·(a·cos(δ) + b·sin(δ)) = c"),
        ("x(t=0) = A", "x(t=0) = A"),
        (r"(\nabla_v g)(V, W) = 0", "(∇_{v}(g))(V, W) = 0"),
        (r"\phi(x,t) = a f_0(x - ct) + b g_0(x + ct)", "φ(x, t) = a·f_0(x − c·t) + b·g_0(x + c·t)"),
        (r"\mathbf{R}^T(\theta) \mathbf{R}(\theta) = a", "(Rᵀ)(θ)·R(θ) = a"),
        (r"f = \mathcal{L}^{-1}\{(sI - A)^{-1}\}", "f = ℒ^{-1}{(s·I − A)^(−1)}"),
        ("e^{-a[(mx^2) + it]} = b", "e^(−a·(m·x^2 + i·t)) = b"),
        (r"s(u) = s(u - u_0)", "s(u) = s(u − u_0)"),
    ]);
    are_refused(&[r"s(u)\phi(u) = p + s(1 - P_1)", "f[(x - h) + a] = b", r"\phi(x,t) = g_0(x + ct)", "D(a + b) = c"]);
}

#[test]
fn a_vector_ends_the_argument_of_a_function() {
    are_read(&[
        (r"\mathbf{v} = R\cos\psi\mathbf{e}_x - R\sin\psi\mathbf{e}_y", "v = R·cos(ψ)·e_x − R·sin(ψ)·e_y"),
        (r"\hat i' = \cos\theta\hat i + \sin\theta\hat j", "i\u{302}' = cos(θ)·i\u{302} + sin(θ)·j\u{302}"),
    ]);
    are_refused(&[r"a = \cos k\mathbf{n}\cdot\mathbf{r}", r"a = \cos\psi e_x"]);
}

#[test]
fn an_operator_before_constants_acts_on_the_integral() {
    are_read(&[(r"\mathbf{E} = -\nabla\frac{1}{4\pi\epsilon}\int \rho\,dV", "E = −∇((1/(4·π·ϵ))·∫(ρ·dV))")]);
    are_refused(&[r"\mathbf{E} = -\nabla\frac{1}{r}\int \rho\,dV"]);
}

#[test]
fn letters_that_are_coefficients_units_or_indices() {
    are_read(&[
        (r"f(t) = a\,t^3 + b\,t^2 + d\,t + c", "f(t) = a·t^3 + b·t^2 + d·t + c"),
        (r"1\ kWh = 3.6\cdot 10^6\ J", "1·kWh = 3.6·10^6·J"),
        (r"W'^\alpha = J^\alpha{}_\beta V^\beta", "W'^{α} = J^{α}_{β}·V^{β}"),
        (r"\partial'_\mu V^\mu = 0", "∂'_{μ}(V^{μ}) = 0"),
        (r"\gamma = i\oint\langle a|\frac{\partial}{\partial a}|a\rangle da", "γ = i·∮(⟨a|∂/∂a|a⟩·da)"),
        (r"\det(\mathbf{F})F_{ji}^{-1} = a", "det(F)·F_{ji}^{-1} = a"),
        (r"F_{ji}^{-1} = a", "F_{ji}^(−1) = a"),
    ]);
    are_refused(&[r"a = \sqrt{d\alpha}\,b", r"W^\alpha = V^\alpha"]);
    // One letter after a number is a unit only beside a word that is one.
    assert_eq!(statements_of(r"a = 3\ J").as_deref(), Some("a = 3·J"));
    assert_eq!(statements_of(r"dE = T\,dS + d\,t").as_deref(), Some("dE = T·dS + dt"));
}

#[test]
fn the_sign_in_the_name_of_a_state_is_that_of_its_statement() {
    are_read(&[(
        r"|\psi^{(\pm)}\rangle = \frac{1}{E \pm i\epsilon} V |\phi\rangle",
        "|ψ^{(+)}⟩ = (1/(E + i·ϵ))·V·|φ⟩ ¦ |ψ^{(-)}⟩ = (1/(E − i·ϵ))·V·|φ⟩",
    )]);
    assert_ne!(
        statements_of(r"|\psi^{(\pm)}\rangle = |\phi\rangle"),
        statements_of(r"|\psi^{(\mp)}\rangle = |\phi\rangle")
    );
}

#[test]
fn a_series_that_goes_on_equals_what_it_is_printed_to_equal() {
    are_read(&[(r"a = b + b^2 + \dots", "a = b + b^2 + …"), (r"a \approx b + b^2 + \dots", "a ≈ b + b^2 + …")]);
    // Where values are compared it does not.
    let mut symbols = Symbols::open();
    let statement =
        read_display(r"a = b + b^2 + \dots", &mut symbols, &Macros::default()).statements.remove(0).unwrap();
    assert_eq!(text::statement(&statement, &symbols), "a ≈ b + b^2 + …");
}
