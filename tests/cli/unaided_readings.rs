//! How displays are read in notes without a claims file: what is not decided there is refused, and nothing is read as a power
//! or a product that is none.

use crate::support::Desk;

/// What `onshell check -v` prints about notes.
fn readings(name: &str, displays: &[&str]) -> String {
    let desk = Desk::new(&format!("readings-{name}"));
    desk.write("a.md", crate::unaided::page(displays));
    desk.onshell(&["check", "-v", "a.md"]).out
}

#[test]
fn indices_above_are_no_powers() {
    for (at, display) in [
        r"\partial_\alpha F^{\beta\alpha} = \mu_0 j^\beta",
        r"\epsilon^{\alpha\beta\gamma\delta}\partial_\gamma F_{\alpha\beta} = 0",
        r"H = \dot{q}^{n} p_{n} - L",
        r"\mu^{n} = u^{m}\frac{\partial\phi_{m}}{\partial p_{n}}",
    ]
    .into_iter()
    .enumerate()
    {
        let out = readings(&format!("indices-{at}"), &[display]);
        assert!(out.contains("may be an index or a power"), "{out}");
    }
    // near misses: a power whose letter is no index, and the letter of a Σ
    for (at, display) in [r"y = a x^n + b", r"y = \sum_{n=0}^{3} a_n x^n"].into_iter().enumerate() {
        let out = readings(&format!("powers-{at}"), &[display]);
        assert!(!out.contains("may be an index or a power"), "{out}");
    }
}

#[test]
fn differences_and_variations_are_one_symbol() {
    let out = readings("difference", &[r"\Delta U = q \Delta V", r"\delta H = p \delta q"]);
    assert!(out.contains("ΔU = q·ΔV") && out.contains("δH = p·δq"), "{out}");
    // a discriminant and a coefficient are factors
    let out = readings("factor", &[r"\Delta = b^2 - 4 a c", r"y = 2 \Delta", r"\dot v = -\delta v - \alpha x"]);
    assert!(out.contains("2·Δ") && out.contains("−δ·v − α·x"), "{out}");
    let out = readings("beside", &[r"\Delta = a \Delta x"]);
    assert!(out.contains("Δ = a·Δx"), "{out}");
    let out = readings("unclear", &[r"\Delta = b^2 - 4 a c", r"y = \Delta + \Delta x"]);
    assert!(out.contains("may be a difference or the product"), "{out}");
}

#[test]
fn a_potential_is_no_norm() {
    let out = readings("norm", &[r"\mathbf{U} = \mathbf{v} + \mathbf{w}", "U = m g h", "L = T - U"]);
    assert!(out.contains("U = m·g·h") && !out.contains("|U|"), "{out}");
    let out = readings("length", &[r"\vec r = \vec a + \vec b", r"F = \frac{k}{r^2}"]);
    assert!(!out.contains("r⃗^2"), "{out}");
}

#[test]
fn one_term_in_parentheses_is_no_factor_of_a_function() {
    let out = readings("argument", &[r"a u = F\left(\frac{1}{u}\right)", r"y = x + O(x^3)", "KE = m v"]);
    assert!(!out.contains("F·(1/u)") && !out.contains("O·x") && !out.contains("K·E"), "{out}");
    let out = readings("product", &[r"y = m(a x + b)"]);
    assert!(out.contains("m·(a·x + b)"), "{out}");
}

#[test]
fn spaces_with_a_length_separate() {
    let out = readings("spaces", &[r"a = b\hspace{25pt}c = d + b"]);
    assert!(out.contains("c = d + b") && !out.contains("b·c"), "{out}");
}

#[test]
fn the_values_of_an_index_beside_a_statement_are_no_statement() {
    for (at, list) in
        [r"\quad n = 1, 2, 3, \dots", r"\quad n = 0, 1, 2,\ldots", r"\quad (n = 1, 2)", r"\quad n \in \mathbb{N}"]
            .into_iter()
            .enumerate()
    {
        let out =
            readings(&format!("values-{at}"), &[&format!(r"k_n = \frac{{n\pi}}{{L}}, \qquad \omega_n = c k_n {list}")]);
        assert!(out.contains("ω_n = c·k_n") && !out.contains("unreadable"), "{list}: {out}");
    }
    // near misses: a value, a list of what is no whole number, and a list that is all there is
    for (at, list) in
        [r"k_n = n a, \quad n = 3", r"k_n = n a, \quad n = a, 2, \dots", r"n = 1, 2, \dots"].into_iter().enumerate()
    {
        let out = readings(&format!("no-values-{at}"), &[list]);
        assert!(out.contains("n = 3") || out.contains("unreadable"), "{list}: {out}");
    }
}

#[test]
fn the_argument_of_a_sine_ends_where_authors_end_it() {
    for (at, (display, expected)) in [
        (r"x = A\cos v t", "cos(v·t)"),
        (r"\rho = R\sin\tfrac12(\pi - \chi)", "sin((1/2)·(π − χ))"),
        (r"y = A \cos 2(\alpha + \beta)", "cos(2·(α + β))"),
    ]
    .into_iter()
    .enumerate()
    {
        let out = readings(&format!("ends-{at}"), &[display]);
        assert!(out.contains(expected), "{display}: {out}");
    }
    // near miss: a factor after a parenthesis
    let out = readings("unclear-end", &[r"y = A \cos 2(\alpha + \beta) c"]);
    assert!(out.contains("unreadable"), "{out}");
}

#[test]
fn a_comma_in_braces_separates_decimals() {
    let out = readings("comma", &[r"a = 7{,}29 \times 10^{-5}", r"b = 0{,}629 \cdot c", "d = 2{,}5"]);
    assert!(out.contains("7.29·10^(−5)") && out.contains("0.629·c") && out.contains("2.5"), "{out}");
    // three digits may be thousands
    let out = readings("thousands", &[r"a = 1{,}458 b"]);
    assert!(out.contains("unreadable"), "{out}");
}

#[test]
fn e_with_a_decimal_exponent_is_an_exponential() {
    let out = readings("decimal", &[r"x = a e^{3.194}", "y = a e^{1.5 b}"]);
    assert!(out.contains("e^3.194") && !out.contains("unreadable"), "{out}");
    for (at, display) in ["F = e^2 a", "F = e^{0.5} a"].into_iter().enumerate() {
        let out = readings(&format!("figure-{at}"), &[display]);
        assert!(out.contains("e is a symbol here"), "{display}: {out}");
    }
}

#[test]
fn three_digits_after_a_near_equality_are_meant() {
    let period = |value: &str| format!(r"t = \frac{{\pi}}{{2.0\ \mathrm{{s^{{-1}}}}}} \approx {value}\ \mathrm{{s}}");
    let out = readings("near", &[&period("1.57")]);
    assert!(!out.contains("numbers-differ"), "{out}");
    let out = readings("near-slip", &[&period("1.75")]);
    assert!(out.contains("numbers-differ"), "{out}");
    // Two digits are as rough as they look.
    let out = readings("near-rough", &[&period("1.7")]);
    assert!(!out.contains("numbers-differ"), "{out}");
}

#[test]
fn a_star_is_a_mark_where_no_number_is_complex() {
    let out = readings("star", &[r"t^* = \frac{\pi}{a - b}", r"x = c t^*"]);
    assert!(!out.contains("unreadable"), "{out}");
    let out = readings("conjugate", &[r"\psi = A e^{i k x}", r"P = a^* a"]);
    assert!(out.contains("unreadable"), "{out}");
}

#[test]
fn a_macro_with_arguments_is_taken_whole_where_statements_are_taken_apart() {
    let desk = Desk::new("readings-macro");
    let notes = r"\newcommand{\rt}[1]{\sqrt{#1}}
The frequency follows:
\begin{equation}
  m \omega^2 = k \quad\Longrightarrow\quad \omega = \rt{\frac{k}{m}}
\end{equation}
";
    desk.write("a.tex", notes);
    let out = desk.onshell(&["check", "-v", "a.tex"]).out;
    assert!(!out.contains("unreadable") && out.contains("√(k/m)"), "{out}");
}
