//! Matrices, complex numbers, cases and conditions without declarations. Beside each stands what differs little and is
//! refused.

use onshell::latex::read_display;

use super::*;

/// Statements in plain words, and letters with their kinds.
type Read = (Vec<String>, Vec<(String, Kind)>);

/// The statements of a display in plain words, and the kinds of its letters other than real numbers; `None` if
/// something is refused.
fn read(latex: &str) -> Option<Read> {
    let mut symbols = Symbols::open();
    let reading = read_display(latex, &mut symbols, &Macros::default());
    let statements: Option<Vec<_>> = reading.statements.into_iter().map(Result::ok).collect();
    let words = statements?.iter().map(|found| text::statement(found, &symbols)).collect();
    let kinds = symbols.iter().filter(|(_, entry)| entry.kind != Kind::Scalar);
    Some((words, kinds.map(|(_, entry)| (text::plain(&entry.name.to_string()), entry.kind)).collect()))
}

fn is_read(latex: &str, words: &str, kinds: &[(&str, Kind)]) {
    let kinds: Vec<(String, Kind)> = kinds.iter().map(|(name, kind)| ((*name).to_owned(), *kind)).collect();
    let words = words.split(" | ").map(str::to_owned).collect();
    assert_eq!(read(latex), Some((words, kinds)), "{latex}");
}

fn is_refused(all: &[&str]) {
    for latex in all {
        assert_eq!(read(latex), None, "{latex}");
    }
}

const SQUARE: Kind = Kind::Matrix(0, 0);

#[test]
fn a_letter_is_a_matrix_if_the_display_says_so() {
    is_read(
        r"K = \begin{pmatrix} 2k & -k \\ -k & k \end{pmatrix}",
        "K = [2·k, −k; −k, k]",
        &[("K", Kind::Matrix(2, 2))],
    );
    is_read(r"\det(K - \omega^2 M) = 0", "det(K − ω^2·M) = 0", &[("K", SQUARE), ("M", SQUARE)]);
    is_read(r"\frac12 \dot q^T M \dot q", "(1/2)·q̇ᵀ·M·q̇", &[("q", Kind::Vector), ("M", SQUARE)]);
    is_read(r"R^T R = I", "Rᵀ·R = 𝟙", &[("R", SQUARE)]);
    is_read(r"\begin{vmatrix} a & b \\ c & d \end{vmatrix}", "det([a, b; c, d])", &[]);
    is_read(
        r"\mathbf{K}\mathbf{a} = \omega^2 \mathbf{M}\mathbf{a}",
        "K·a = ω^2·M·a",
        &[("K", SQUARE), ("M", SQUARE), ("a", Kind::Vector)],
    );
    is_refused(&[r"A^T b", r"A^\dagger A", r"\det x", r"\operatorname{tr} A B", "[A, B] = 0", r"\mathbf a \mathbf b"]);
}

#[test]
fn i_is_the_imaginary_unit_where_nothing_else_is_meant() {
    is_read(r"e^{i\theta} = \cos\theta + i\sin\theta", "e^(i·θ) = cos(θ) + i·sin(θ)", &[]);
    is_read(r"z = x + iy", "z = x + i·y", &[("z", Kind::Complex)]);
    is_read(r"\operatorname{Re}(A e^{i\omega t})", "Re(A·e^(i·ω·t))", &[]);
    // The index of a sum is no √−1.
    is_read(r"\sum_{i=1}^{3} e^{i x}", "Σ_{i=1}^{3}(e^(i·x))", &[]);
    is_read(r"\psi^* \psi = |\psi|^2", "conj(ψ)·ψ = |ψ|^2", &[("ψ", Kind::Complex)]);
    is_refused(&["V = i R", "i = 3 x", "m_i e^{i k}", "z^*", "e^{j x}", r"v_j = j \omega x_j"]);
    // Before a frequency j is nothing else, unless it is an index.
    is_read(r"Z = R + j \omega L", "Z = R + i·ω·L", &[("Z", Kind::Complex)]);
}

#[test]
fn cases_and_conditions() {
    is_read(
        r"y = \begin{cases} 0 & x < 0 \\ x^2, & \text{if } x \ge 0 \end{cases}",
        "y = {0 if x < 0; x^2 if x ≥ 0}",
        &[],
    );
    is_read(
        r"y = \begin{cases} 1 & 0 < x < a \\ 0 & \text{otherwise} \end{cases}",
        "y = {1 if 0 < x < a; 0 otherwise}",
        &[],
    );
    is_read(r"y = x^2 \quad \text{for } x > 0", "y = x^2 for x > 0", &[]);
    is_read(r"y = x^2, \qquad (x > 0)", "y = x^2 for x > 0", &[]);
    is_read(r"\begin{cases} x + y = 1 \\ x - y = 3 \end{cases}", "x + y = 1 | x − y = 3", &[]);
    is_refused(&[
        r"y = \begin{cases} 0 & \text{otherwise} \\ 1 & x > 0 \end{cases}",
        r"y = \begin{cases} 0 & x \\ 1 & x > 0 \end{cases}",
        r"y = x^2 \text{ if the body is at rest}",
    ]);
}

#[test]
fn marks_above_a_name_that_are_a_part_of_it() {
    is_read(r"v^+ = - k v^-", "v^{+} = −k·v^{-}", &[]);
    is_read(r"F^{\text{ext}} = m a", r"F^{ext} = m·a", &[]);
    is_read(r"x^{(0)} = A", "x^{(0)} = A", &[]);
    is_refused(&["x^-1", "e^-x", "x^{(n)} = A", r"n^{\text{th}} = A"]);
}

#[test]
fn arguments_that_can_end_in_one_place_only() {
    is_read(r"\tan^{-1} x", "arctan(x)", &[]);
    is_read(r"y = A\cos\gamma t", "y = A·cos(γ·t)", &[]);
    is_read(r"y = A\sin kx", "y = A·sin(k·x)", &[]);
    is_refused(&[r"\cos ab", r"\cot^{-1} x", r"\sin kx^2"]);
}
