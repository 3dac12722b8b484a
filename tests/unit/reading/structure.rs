//! What has no value and is read for its structure: operators, tensors, states, lists, words. Beside each stands what is
//! still refused, and nothing of it is read where a value is needed.

use onshell::latex::read_display;

use super::*;

/// The statements in plain words; `None` if a statement is refused.
fn read_with(latex: &str, mut symbols: Symbols) -> Option<Vec<String>> {
    let reading = read_display(latex, &mut symbols, &Macros::default());
    let statements: Result<Vec<_>, _> = reading.statements.iter().cloned().collect();
    Some(statements.ok()?.iter().map(|found| text::statement(found, &symbols)).collect())
}

fn read(latex: &str) -> Option<Vec<String>> {
    read_with(latex, Symbols::for_reading())
}

fn are_read(cases: &[(&str, &str)]) {
    for (latex, words) in cases {
        let expected: Vec<String> = words.split(" ¦ ").map(str::to_owned).collect();
        assert_eq!(read(latex), Some(expected), "{latex}");
        assert_eq!(read_with(latex, Symbols::open()), None, "{latex} has a value");
    }
}

fn are_refused(cases: &[&str]) {
    for latex in cases {
        assert_eq!(read(latex), None, "{latex}");
    }
}

#[test]
fn states_and_mean_values() {
    are_read(&[
        ("H|n\\rangle = E_n|n\\rangle", "H·|n⟩ = E_n·|n⟩"),
        ("\\langle a|b\\rangle = 0", "⟨a|b⟩ = 0"),
        ("\\langle a|H|b\\rangle", "⟨a|H|b⟩"),
        ("\\sum_n |n\\rangle\\langle n| = \\mathbb{1}", "Σ_{n}(|n⟩·⟨n|) = 𝟙"),
        ("P = |a\\rangle\\langle a| + |b\\rangle\\langle b|", "P = |a⟩·⟨a| + |b⟩·⟨b|"),
        ("\\langle x^2\\rangle - \\langle x\\rangle^2", "⟨x^2⟩ − ⟨x⟩^2"),
        ("\\langle |x| \\rangle", "⟨|x|⟩"),
        ("\\left\\langle a \\middle| b \\right\\rangle", "⟨a|b⟩"),
    ]);
    are_refused(&["|a\\rangle + |b", "\\langle a", "a\\rangle"]);
}

#[test]
fn brackets_of_several_formulas() {
    are_read(&[
        ("[\\hat x, \\hat p] = i\\hbar", "[x\u{302}, p\u{302}] = i·ħ"),
        ("\\{q, p\\} = 1", "{q, p} = 1"),
        ("\\vec r = (x, y, z)", "r\u{20d7} = (x, y, z)"),
        ("t \\in [0, T)", "t ∈ [0, T)"),
    ]);
    are_refused(&["(a, b", "[a + b)", "(a + b]"]);
}

#[test]
fn indices_above_a_letter() {
    are_read(&[
        ("F^{\\mu\\nu} = \\partial^\\mu A^\\nu - \\partial^\\nu A^\\mu", "F^{μν} = ∂^{μ}(A^{ν}) − ∂^{ν}(A^{μ})"),
        ("x^i y_i = 0", "x^{i}·y_i = 0"),
        ("R^\\lambda{}_{\\mu\\nu} = 0", "R^{λ}_{μν} = 0"),
        ("A^\\dagger = A", "A^{†} = A"),
        ("A^T P + P A = -Q", "A^{T}·P + P·A = −Q"),
        ("H^0 |n\\rangle = E^0_n |n\\rangle", "H^{0}·|n⟩ = E_n^{0}·|n⟩"),
        ("\\frac{i}{\\hbar} H_{fi} |f\\rangle", "(i/ħ)·H_{fi}·|f⟩"),
        ("f^{(n)}(x) = 0", "f^{(n)}(x) = 0"),
    ]);
    // A letter above that is an index nowhere else may be a power, and T a power too.
    are_refused(&["x^i", "x^{ab}", "A^T", "e^2", "e"]);
    // A power beside an index is a power.
    assert_eq!(read("f = \\sum_n a_n x^n"), Some(vec!["f = Σ_{n}(a_n·x^(n))".to_owned()]));
}

#[test]
fn operators_and_derivatives_by_anything() {
    are_read(&[
        ("\\vec p = \\frac{\\partial L}{\\partial \\vec v}", "p\u{20d7} = ∂L/∂v\u{20d7}"),
        ("\\frac{D\\vec u}{Dt} = \\vec g", "D u\u{20d7}/Dt = g\u{20d7}"),
        ("\\frac{d}{dt} = \\frac{\\partial}{\\partial t} + (\\vec u \\cdot \\nabla)", "d/dt = ∂/∂t + (u\u{20d7} · ∇)"),
        ("\\frac{d}{dt} x y", "d/dt(x·y)"),
        ("\\frac{\\partial}{\\partial t} \\frac{\\partial \\psi^*}{\\partial x}", "∂/∂t(∂ψ^{*}/∂x)"),
        ("d(pV) = p\\,dV + V\\,dp", "d(p·V) = p·dV + V·dp"),
        ("\\det J(t) = 1", "det(J(t)) = 1"),
    ]);
    are_refused(&[
        "\\nabla f g",
        "\\frac{\\partial}{\\partial x",
        "\\partial_x f g",
        // The first derivative may act on the first factor, or on all.
        "\\frac{\\partial}{\\partial t}\\psi^* \\frac{\\partial}{\\partial t}\\psi",
        "\\frac{d}{dt}\\psi^* \\frac{d}{dt}\\psi",
        "\\frac{\\partial}{\\partial t}\\psi^* \\partial_\\mu \\psi",
        &format!("{} x y", "\\frac{\\partial}{\\partial x}".repeat(3000)),
        &format!("{} x", "\\partial_\\mu".repeat(3000)),
        &format!("{} x", "\\max".repeat(3000)),
    ]);
}

#[test]
fn a_letter_before_one_term_in_parentheses_is_a_function_if_it_is_usual_as_one() {
    are_read(&[
        ("V(1/u) |n\\rangle", "V(1/u)·|n⟩"),
        ("\\Gamma(2n) |n\\rangle", "Γ(2·n)·|n⟩"),
        ("x(2t) |n\\rangle", "x(2·t)·|n⟩"),
    ]);
    are_refused(&[
        "ie(\\partial_\\mu A_\\nu)",
        "e(\\partial_\\mu A_\\nu)",
        "g(\\partial_\\mu A_\\nu)",
        "\\lambda(\\partial_\\mu A_\\nu)",
        "m(2k) |n\\rangle",
    ]);
    // In a function elsewhere.
    assert!(read("A(x) = A(\\partial_\\mu x)").is_some());
}

#[test]
fn matrices_of_unknown_size_and_operators_keep_their_order() {
    are_read(&[
        ("\\hat H \\hat A = \\hat A \\hat H", "H\u{302}·A\u{302} = A\u{302}·H\u{302}"),
        ("A \\otimes B", "A ⊗ B"),
        ("B^{-1} = \\begin{pmatrix} a & b \\\\ 0 & c \\end{pmatrix}", "B^(−1) = [a, b; 0, c]"),
    ]);
}

#[test]
fn lists_words_and_sides_that_are_not_printed() {
    are_read(&[
        ("n = 1, 2, \\dots", "n = 1, 2, …"),
        ("x, y > 0", "x, y > 0"),
        ("x = 1 \\text{ or } x = 2", "x = 1 or x = 2"),
        ("= m a", "… = m·a"),
        ("n! = n (n-1)!", "n! = n·(n − 1)!"),
        ("\\underbrace{a + b}_{c} d", "⏟{a + b}_{c}·d"),
        ("x\\,\\mathrm{m}", "x·m"),
        ("[\\rho] = \\rm kg\\,m^{-3}", "[ρ] = kg m^{-3}"),
    ]);
    are_refused(&["x = 1,000", "+", "E = a + b +", "\\frac{a}{}", "a/bc", "KE x = 1"]);
}

#[test]
fn macros_of_states_are_read_as_what_they_print() {
    are_read(&[
        ("H\\ket{a} = E\\ket{a}", "H·|a⟩ = E·|a⟩"),
        ("\\braket{a|b} = \\braket{c}{d}", "⟨a|b⟩ = ⟨c|d⟩"),
        ("\\ev{H}{a} = \\mel{a}{H}{a}", "⟨a|H|a⟩ = ⟨a|H|a⟩"),
        ("P = \\ketbra{a}{b}", "P = |a⟩·⟨b|"),
    ]);
    // one state may be a mean value or a product with itself
    are_refused(&["\\braket{a} = 1"]);
}

#[test]
fn a_derivative_at_a_place_is_no_product() {
    are_read(&[
        ("\\frac{df}{dx}(a, b) = c", "(d f/dx)(a, b) = c"),
        ("\\frac{\\partial f}{\\partial x}(0) = c", "(∂f/∂x)(0) = c"),
        ("\\frac{\\partial L}{\\partial \\dot u(t, x)} = c", "∂L/∂u̇(t,x) = c"),
        ("\\pdv{L}{\\dot u(t, x)} = c", "∂L/∂u̇(t,x) = c"),
    ]);
    assert_eq!(read("\\frac{df}{dx}(a + b) = c"), Some(vec!["∂f/∂x·(a + b) = c".into()]));
}

#[test]
fn indices_above_are_told_from_powers() {
    are_read(&[
        ("H = \\dot q^n p_n - L", "H = q̇^{n}·p_n − L"),
        ("\\partial_0 E^3 = B^2", "∂_{0}(E^{3}) = B^{2}"),
        ("F^{i0} = E_i", "F^{i0} = E_i"),
        ("v^{\\hat r} = a", "v^{r̂} = a"),
    ]);
    // powers stay powers: a series, a number above a letter without components
    assert_eq!(read("a_n x^n = b"), Some(vec!["a_n·x^(n) = b".into()]));
    assert_eq!(read("E^3 = B^2"), Some(vec!["E^3 = B^2".into()]));
    are_refused(&["x^i", "x^{ab}"]);
}

#[test]
fn a_transpose_stands_before_a_factor() {
    are_read(&[("f = J^T g", "f = J^{T}·g"), ("f = J^T (a + b)", "f = J^{T}·(a + b)")]);
    // alone, or where T stands elsewhere, it may be a power
    are_refused(&["A^T", "f = J^T g T"]);
}

#[test]
fn brackets_bars_and_sets_stay_as_they_are() {
    are_read(&[
        ("p = R(a|b)", "p = R(a | b)"),
        ("v = -k_1[E][S]", "v = −k_1·[E]·[S]"),
        ("x \\in SO(3)", "x ∈ SO(3)"),
        ("\\omega = dq \\wedge dp", "ω = dq ∧ dp"),
        ("\\mathcal{F}\\{f\\} = g", "ℱ{f} = g"),
        ("n = 0,1,2,\\dots", "n = 0, 1, 2, …"),
    ]);
    // a bar that closes another, a decimal comma, the adjoint
    are_refused(&["R(|a|b|c|)", "n = 1,5", "ad_V(F) = 1"]);
    assert_eq!(read("S[u, v, w] = 0"), Some(vec!["S(u, v, w) = 0".into()]));
    // the product of vectors has its own sign
    assert_eq!(read("\\vec a \\wedge \\vec b = 0"), read("\\vec a \\times \\vec b = 0"));
}

#[test]
fn what_is_read_for_its_structure_is_printed_and_read_back() {
    for latex in [
        "F^{\\mu\\nu} = \\partial^\\mu A^\\nu - \\partial^\\nu A^\\mu",
        "\\langle a|H|b\\rangle = E_n \\langle a|b\\rangle",
        "[\\hat x, \\hat p] = i\\hbar",
        "\\vec p = \\frac{\\partial L}{\\partial \\vec v}",
        "(a + b) \\otimes c = a \\otimes c + b \\otimes c",
        "\\binom{n}{k} = \\frac{n!}{k! (n-k)!}",
        "\\hat H |n\\rangle = \\hbar\\omega |n\\rangle",
    ] {
        let mut symbols = Symbols::for_reading();
        let reading = read_display(latex, &mut symbols, &Macros::default());
        for statement in &reading.statements {
            let statement = statement.as_ref().unwrap_or_else(|fault| panic!("{latex}: {fault:?}"));
            let mut again = String::new();
            for (at, member) in statement.members.iter().enumerate() {
                if at > 0 {
                    again.push_str(statement.relations[at - 1].0.command());
                }
                again.push_str(&typeset(member, &symbols));
            }
            let words = text::statement(statement, &symbols);
            assert_eq!(read(&again), Some(vec![words]), "{latex} is printed as {again}");
        }
    }
}
