//! Rewritten forms, and what is left as it is.

use super::super::layout::layout;
use super::super::lexer::tokens;
use super::*;

/// How a text is laid out, its places aside.
fn shape(text: &str) -> String {
    let kinds: Vec<TokenKind> = normalized(tokens(text)).into_iter().map(|token| token.kind).collect();
    let nowhere = |kind: &TokenKind| Token { kind: kind.clone(), span: Span::at(0) };
    format!("{:?}", layout(&kinds.iter().map(nowhere).collect::<Vec<_>>(), 0))
}

#[test]
fn old_forms_are_laid_out_like_new_ones() {
    for (old, new) in [
        ("{a \\over b}", "\\frac{a}{b}"),
        ("x = {{a \\over b} \\over c+d}", "x = \\frac{\\frac{a}{b}}{c+d}"),
        ("{\\bf v} \\cdot {\\bf v}", "\\mathbf{v} \\cdot \\mathbf{v}"),
        ("{\\rm const}", "\\mathrm{const}"),
        ("a = \\rm kg\\,m^{-3}", "a = \\mathrm{kg\\,m^{-3}}"),
        ("9\\,\\rm m\\,s^{-2} + b", "9\\,\\mathrm{m\\,s^{-2}} + b"),
        ("\\left({a b} \\over c\\right)", "\\left(\\frac{{a b}}{c}\\right)"),
        ("\\left(x \\left[a \\over b\\right]\\right)", "\\left(x \\left[\\frac{a}{b}\\right]\\right)"),
        ("\\displaylines{a = b \\\\ c = d}", "a = b \\\\ c = d"),
        ("{a + 2\\rm m s} b", "{a + 2\\mathrm{m\\,s}} b"),
        ("\\rm dx + \\rm d x", "\\mathrm d x + \\mathrm d x"),
        ("\\rm Tr A", "\\mathrm{Tr} A"),
        ("2\\rm d t", "2\\mathrm d t"),
        ("2\\rm i x", "2\\mathrm i x"),
        ("\\rm e^{x} y", "\\mathrm e^{x} y"),
        ("{\\cal L}", "\\mathcal{L}"),
        ("\\boxed{a = b}", "a = b"),
        ("a = \\boxed{b + c}", "a = {b + c}"),
        ("\\textcolor{red}{a} + \\color{blue} b", "{a} + b"),
        ("\\underbrace{a + b}_{\\text{the sum}} - c", "{a + b} - c"),
        ("\\overset{.}{x} + \\overset{..}{x} = \\stackrel{\\rightarrow}{v}", "\\dot{x} + \\ddot{x} = \\vec{v}"),
        ("a \\stackrel{!}{=} b \\overset{(3)}{\\leq} c", "a = b \\leq c"),
    ] {
        assert_eq!(shape(old), shape(new), "{old}");
    }
    // must-fail cases: a brace with mathematics under it keeps it, and an accent is no relation.
    assert_ne!(shape("\\underbrace{a}_{=0} + b"), shape("{a} + b"));
    assert_ne!(shape("\\overbrace{a}^{2} + b"), shape("{a} + b"));
    assert_ne!(shape("\\overbrace{a}^{2} + b"), shape("{a}^{2} + b"));
    assert_ne!(shape("\\overset{!}{a} = b"), shape("a = b"));
    assert_ne!(shape("\\overset{.}{x} = b"), shape("\\ddot{x} = b"));
    assert_ne!(shape("a \\stackrel{?}{=} b"), shape("a = b"));
    assert_ne!(shape("\\left(x {a \\over b}\\right)"), shape("\\left(\\frac{x a}{b}\\right)"));
    assert_ne!(shape("{a \\over b}"), shape("\\frac{b}{a}"));
    assert_ne!(shape("9\\rm m s"), shape("9\\mathrm m s"));
}

#[test]
fn nothing_is_lost_and_places_are_kept() {
    let text = "\\boxed{{\\bf q} = {w \\over z}}";
    let place = |letter: char| {
        let kind = TokenKind::Letter(letter);
        normalized(tokens(text)).iter().find(|token| token.kind == kind).map(|token| token.span.start)
    };
    for letter in ['q', 'w', 'z'] {
        assert_eq!(place(letter), text.find(letter), "{letter}");
    }
    for broken in
        ["{a \\over b", "\\boxed", "\\boxed{", "\\stackrel{!}", "\\underbrace{x}_", "\\textcolor{red}", "\\bf"]
    {
        assert!(normalized(tokens(broken)).len() <= tokens(broken).len() + 3, "{broken}");
    }
}
