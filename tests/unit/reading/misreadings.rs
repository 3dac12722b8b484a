//! What looks like a product, a power or a statement, and is none: it is refused with its place. Beside each stands what
//! differs little and is read.

use onshell::latex::read_display;

use super::*;

/// The statements of a display in plain words, or the text that each refusal points at.
fn displayed(latex: &str, symbols: &mut Symbols) -> Result<Vec<String>, Vec<String>> {
    let reading = read_display(latex, symbols, &Macros::default());
    let faults: Vec<String> = reading
        .statements
        .iter()
        .filter_map(|read| read.as_ref().err())
        .inspect(|fault| assert!(!fault.message.is_empty() && fault.help.is_some(), "{latex}: {}", fault.message))
        .map(|fault| latex[fault.span.range()].to_owned())
        .collect();
    match faults.is_empty() {
        true => Ok(reading.statements.iter().flatten().map(|found| text::statement(found, symbols)).collect()),
        false => Err(faults),
    }
}

/// In a formula without declarations.
fn openly(latex: &str) -> Result<Vec<String>, Vec<String>> {
    displayed(latex, &mut Symbols::open())
}

/// A coordinate q, a function of time F, the constants k, m and T; the indices i and j.
fn declared(latex: &str) -> Result<Vec<String>, Vec<String>> {
    let mut symbols = Symbols::new();
    for name in ["q", "F", "t"] {
        let id = add(&mut symbols, name, Kind::Scalar);
        symbols.entry_mut(id).varies = true;
    }
    for name in ["k", "m", "T", "a", "s", "n"] {
        add(&mut symbols, name, Kind::Scalar);
    }
    for letter in ["i", "j"] {
        symbols.add_index(letter, 3);
    }
    displayed(latex, &mut symbols)
}

fn refused_openly(cases: &[(&str, &str)]) {
    for (latex, place) in cases {
        assert_eq!(openly(latex), Err(vec![(*place).to_owned()]), "{latex}");
    }
}

fn read_openly(cases: &[(&str, &str)]) {
    for (latex, words) in cases {
        assert_eq!(openly(latex), Ok(words.split(" | ").map(str::to_owned).collect()), "{latex}");
    }
}

#[test]
fn an_application_is_no_product() {
    refused_openly(&[
        (r"q_1(\pi/2)", r"q_1(\pi/2)"),
        ("q(-1)", "q(-1)"),
        ("q[3]", "q[3]"),
        ("q(2t)", "q(2t)"),
        ("q(t + T)", "q(t + T)"),
        (r"\delta(x - b)", r"\delta(x - b)"),
        ("u(x + b)", "u(x + b)"),
        (r"\mathcal{F}(x + b)", r"\mathcal{F}(x + b)"),
        (r"\frac{dq}{dt}(0)", r"\frac{dq}{dt}(0)"),
        (r"\Delta(m v)", r"\Delta(m v)"),
    ]);
    read_openly(&[
        ("m(a + b)", "m·(a + b)"),
        // A lone name, a 0 or a list in parentheses is an argument.
        ("q(0) = b", "q(0) = b"),
        (r"\dot q(0)", "q\u{307}(0)"),
        ("q(t)^2", "q(t)^2"),
        ("q'(b)^2", "q'(b)^2"),
        ("O(b^3)", "O(b^3)"),
        ("K(q_1^2, b)", "K(q_1^2, b)"),
        (r"\lambda(\dot q b)", "λ·(q\u{307}·b)"),
        ("m(l b)^2", "m·(l·b)^2"),
        ("2(0.5)", "2·0.5"),
        (r"q \, (0) b", "q·0·b"),
        (r"A(\cos\omega t + b)", "A·(cos(ω·t) + b)"),
        (r"\frac{dq}{dt}(a + b)", "d/dt(q)·(a + b)"),
    ]);
}

#[test]
fn with_declarations_a_constant_before_one_term_is_a_factor_and_an_argument_is_none() {
    for (latex, place) in [
        ("k(0)", "k(0)"),
        ("q(0)", "q(0)"),
        ("q(0)^2", "q(0)"),
        ("q(T)", "q(T)"),
        ("q(t + T)", "q(t + T)"),
        ("q(2t)", "q(2t)"),
        ("k(q, F)", "k(q, F)"),
    ] {
        assert_eq!(declared(latex), Err(vec![place.to_owned()]), "{latex}");
    }
    for (latex, words) in [
        ("q(t)", "q"),
        ("q(t)^2", "q^2"),
        ("k(q^2)", "k·q^2"),
        ("k(q + T)", "k·(q + T)"),
        ("k(t - T)", "k·(t − T)"),
        ("q(k + T)", "q·(k + T)"),
    ] {
        assert_eq!(declared(latex), Ok(vec![words.to_owned()]), "{latex}");
    }
}

#[test]
fn what_stands_above_need_not_be_a_power() {
    refused_openly(&[
        ("A^T b", "A^T"),
        (r"A^\top", r"A^\top"),
        (r"(a + b)^{\mathrm T}", r"(a + b)^{\mathrm T}"),
        (r"A^\dagger", r"\dagger"),
        ("z^*", "*"),
        ("z^{*}", "{*}"),
        ("v^{(n)}", "{(n)}"),
        ("g^{ij}", "g^{ij}"),
        (r"x^\mu", r"x^\mu"),
        ("q^1", "q^1"),
        (r"\Gamma^k_{ab}", r"\Gamma^k_{ab}"),
        ("v^{max}", "v^{max}"),
        ("v^M", "v^M"),
        ("90^o", "90^o"),
        ("5^{th}", "5^{th}"),
    ]);
    read_openly(&[
        ("q^2", "q^2"),
        ("q^{-1}", "q^(−1)"),
        ("q_1^n", "q_1^(n)"),
        ("b^{n+1}", "b^(n + 1)"),
        ("2^N", "2^(N)"),
        ("(1 + b)^N", "(1 + b)^(N)"),
        (r"e^{-k t}", "e^(−k·t)"),
        (r"b^{x^2}", "b^(x^2)"),
    ]);
    assert_eq!(declared("k^T"), Ok(vec!["k^(T)".to_owned()]), "T is a declared number");
    assert_eq!(declared(r"k^\top"), Err(vec![r"k^\top".to_owned()]));
    assert_eq!(declared("k^i"), Err(vec!["i".to_owned()]), "i is an index");
    assert_eq!(declared("k^{ij}"), Err(vec!["{ij}".to_owned()]));
}

#[test]
fn letters_that_spell_a_function_or_a_word_are_no_factors() {
    refused_openly(&[
        ("sin x", "sin"),
        ("sqrt{x}", "sqrt"),
        ("2sin x", "sin"),
        ("mgsin x", "mgsin"),
        ("sin^2 x", "sin"),
        ("log_{10} x", "log"),
        ("ln x", "ln"),
        ("det A", "det"),
        ("x_{1}max", "max"),
        ("a = 2 and b", "and"),
        ("speed", "speed"),
        ("Work = F s", "Work"),
        ("KE = b", "KE"),
        ("CRe", "CRe"),
        (r"x\,\mathrm{kg}", r"\mathrm{kg}"),
        (r"a \mathrm{and} b", r"\mathrm{and}"),
        ("G2 = b", "G2"),
        ("(a + b)2", "(a + b)2"),
        (r"\Sigma F = m a", r"\Sigma"),
    ]);
    read_openly(&[
        ("m g s", "m·g·s"),
        (r"l \, n x", "l·n·x"),
        ("MgR", "M·g·R"),
        ("mgh", "m·g·h"),
        (r"\mathrm{sin}\,x", "sin(x)"),
        ("T_{rot}", "T_{rot}"),
        (r"T_{\mathrm{max}}", "T_{max}"),
        (r"\Sigma = b", "Σ = b"),
        ("2b", "2·b"),
    ]);
    assert_eq!(declared(r"k s \, a n"), Ok(vec!["k·s·a·n".to_owned()]));
    assert_eq!(declared("k tan"), Err(vec!["tan".to_owned()]), "though t, a and n are declared");
}

#[test]
fn the_imaginary_unit_is_no_letter() {
    refused_openly(&[("V = i R", "i"), ("i b", "i"), ("e^{j x}", "{j x}")]);
    read_openly(&[("v_i + j", "v_i + j"), (r"e^{-k t} j", "e^(−k·t)·j")]);
}

#[test]
fn a_prime_may_be_a_derivative() {
    refused_openly(&[("y' + k y", "y"), ("k y + y'", "y'"), ("q'(a + b)", "q'(a + b)")]);
    read_openly(&[("a' + b'", "a' + b'")]);
}

#[test]
fn products_of_letters_with_a_cross_or_indices_may_be_more() {
    refused_openly(&[
        (r"r \times p", r"r \times p"),
        (r"\omega \times (\omega \times r)", r"\omega \times r"),
        ("P_{ij} q_j", "P_{ij}"),
        (r"\epsilon_{abc} q_c", r"\epsilon_{abc}"),
        (r"\underline v \cdot \underline v", r"\underline v"),
    ]);
    read_openly(&[
        (r"3 \times 10^{8}", "3·10^8"),
        (r"2 \times b", "2·b"),
        ("m_i v_i", "m_i·v_i"),
        ("P_{ij} q", "P_{ij}·q"),
    ]);
}

#[test]
fn the_argument_of_a_function_may_go_on_after_a_dot() {
    for latex in [r"\sin 2\cdot\theta", r"\sin 2 \times b", r"\cos\omega\cdot t", r"\ln 2 b", r"\cos b 2"] {
        assert!(openly(latex).is_err(), "{latex}");
    }
    read_openly(&[
        (r"\sin 2b", "sin(2·b)"),
        (r"\ln b", "ln(b)"),
        (r"\ln 2", "ln(2)"),
        (r"\sin b \cdot v", "sin(b)·v"),
        (r"\sin\frac{\pi}{4}\cdot v", "sin(π/4)·v"),
        (r"\sin(n\pi)", "sin(n·π)"),
        (r"\sin n\pi", "sin(n·π)"),
    ]);
}

#[test]
fn a_row_continues_what_it_is_aligned_with() {
    read_openly(&[
        (r"a &= b \\ &= c", "a = b = c"),
        (r"a &= b \\ &- c = v", "a = b − c = v"),
        (r"a &= b \\ -c &= v", "a = b | −c = v"),
        (r"a = b \\ - c", "a = b − c"),
        (r"a &= b, & c &= v", "a = b | c = v"),
        (r"a &= b & c &= v", "a = b | c = v"),
        (r"a &=& b \\ c &=& v", "a = b | c = v"),
        (r"a &= b &+ c \\ v &= k &- q", "a = b + c | v = k − q"),
        (r"& a = b \\ & c = v", "a = b | c = v"),
    ]);
    refused_openly(&[
        (r"a = b \\ - c = v", "-"),
        (r"a = b, \quad c = v \\ = k", "="),
        (r"a &= b & c &= v \\ &= k & &= q", "="),
        (r"a = b, \\ - c", "-"),
    ]);
}

#[test]
fn values_and_names_in_a_list_are_no_statements() {
    refused_openly(&[
        ("n = 1, 2", "2"),
        (r"v_n, \quad n = 2", "v_n"),
        ("a, b > 0", "a"),
        ("b = 1,000", ","),
        ("b = 1{,}000", ","),
        ("a.b", "."),
        ("a + .. + b", "."),
        (r"a = b \quad (2)", "(2)"),
        (r"a = b \;(2)", "(2)"),
        (r"a = 1 \text{ or } a = 2", r"a = 1 \text{ or } a = 2"),
    ]);
    read_openly(&[
        ("a + ... + b", "a + … + b"),
        ("a = 1, b = 2", "a = 1 | b = 2"),
        ("a, b", "a | b"),
        ("a = b. ", "a = b"),
        (r"a = b. \quad c = v", "a = b | c = v"),
        (r"a = 1 \text{ and } b = 2", "a = 1 | b = 2"),
        (r"a = b \Rightarrow c = v", "a = b | c = v"),
        ("a = 2(3)", "a = 2·3"),
    ]);
}

#[test]
fn the_label_of_a_brace_is_no_script() {
    refused_openly(&[
        (r"\overbrace{a}^{2}", r"\overbrace"),
        (r"\underbrace{a}_{b}", r"\underbrace"),
        (r"\underbrace{a}_b", r"\underbrace"),
    ]);
    read_openly(&[
        (r"\underbrace{a + b}_{\text{the sum}} = c", "a + b = c"),
        (r"\overbrace{a b}^{\mathrm{all}}", "a·b"),
        (r"\underbrace{a}", "a"),
    ]);
}

#[test]
fn e_with_a_figure_above_may_be_a_symbol() {
    refused_openly(&[("e^{0.5}", "e^{0.5}"), ("e^{-1}", "e^{-1}"), (r"e^{\frac12}", r"e^{\frac12}")]);
    read_openly(&[("e^{-b}", "e^(−b)"), (r"e^{2\pi}", "e^(2·π)")]);
}
