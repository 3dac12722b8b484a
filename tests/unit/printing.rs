//! What is printed reads back as the same formula, and reading is total: any text gives a formula or a fault.

#[path = "printing/formulas.rs"]
pub(super) mod formulas;

use onshell::formula::{Expr, Node, Symbols, shape};
use onshell::latex::{Macros, read_display, read_formula, typeset};
use proptest::prelude::*;

use formulas::{closed, open, table};

/// Printed and read again, with the same names.
fn read_back(expr: &Expr, symbols: &Symbols) -> Result<Expr, String> {
    let printed = typeset(expr, symbols);
    let mut symbols = symbols.clone();
    let known = symbols.len();
    let read = read_formula(&printed, &mut symbols, &Macros::default());
    assert_eq!(symbols.len(), known, "{printed} introduces a name");
    read.map_err(|fault| format!("{printed} is refused: {}", fault.message))
}

/// A tree with its implied sums made explicit, as reading makes them; `None` where it has no type.
fn bound(expr: Expr, symbols: &Symbols) -> Option<Expr> {
    shape::bind(expr, symbols).ok().filter(|(_, found)| found.free.is_empty()).map(|(expr, _)| expr)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn a_formula_of_numbers_reads_back_as_itself(expr in open()) {
        let symbols = table(true);
        let expr = bound(expr, &symbols).expect("scalars fit everywhere");
        let read = read_back(&expr, &symbols);
        // Without declarations a letter above a symbol may be an index, and a letter after a number a unit. Such a formula is
        // refused, not read as something else.
        let refusals = ["may be an index, a label or a power", "may be a unit or a quantity"];
        if !matches!(&read, Err(refusal) if refusals.iter().any(|known| refusal.contains(known))) {
            prop_assert_eq!(read, Ok(expr.clone()), "printed {}", typeset(&expr, &symbols));
        }
    }

    #[test]
    fn a_formula_of_vectors_and_matrices_reads_back_as_itself(expr in closed()) {
        let symbols = table(false);
        let Some(expr) = bound(expr, &symbols) else { return Err(TestCaseError::reject("it has no type")) };
        prop_assert_eq!(read_back(&expr, &symbols), Ok(expr.clone()), "printed {}", typeset(&expr, &symbols));
    }

    #[test]
    fn another_formula_is_printed_in_another_way(expr in closed(), other in closed(), at in any::<prop::sample::Index>()) {
        let symbols = table(false);
        let changed = slip(&expr, at);
        for other in [&changed, &other] {
            if *other != expr {
                prop_assert_ne!(typeset(&expr, &symbols), typeset(other, &symbols), "{:?} and {:?}", expr, other);
            }
        }
        prop_assert_ne!(&changed, &expr);
    }

    #[test]
    fn every_node_knows_its_bytes(expr in open()) {
        let symbols = table(true);
        let expr = bound(expr, &symbols).expect("scalars fit everywhere");
        let printed = typeset(&expr, &symbols);
        let Ok(read) = read_formula(&printed, &mut symbols.clone(), &Macros::default()) else { return Ok(()) };
        let mut inside = true;
        read.walk(&mut |node| {
            inside &= node.span.start <= node.span.end && printed.get(node.span.range()).is_some();
            inside &= node.children().iter().all(|child| read.span.contains(child.span));
        });
        prop_assert!(inside, "{}", printed);
    }

    #[test]
    fn no_text_is_too_much_for_the_reader(text in prop::collection::vec(piece(), 0..60)) {
        total(&text.concat());
    }

    #[test]
    fn no_characters_are_too_much_for_the_reader(text in any::<String>()) {
        total(&text);
    }
}

/// Small formulas that are easily printed wrong; each is read, printed, and read again.
#[test]
fn parentheses_and_numbers_survive_printing() {
    let symbols = table(false);
    for latex in [
        r"(2x) \cdot 3",
        r"(x m) \cdot (2 M)",
        r"2 \cdot \frac{1}{2}",
        r"3 \cdot \sqrt{2}",
        r"\frac{\pi}{2} \cdot 2",
        r"\mathbf{S}_z(\theta)^T \mathbf{R}",
        r"\left(\mathbf{S}_z(\theta)\right)^{-1}",
        r"(\omega_a \omega_a) \cdot (\omega_a \omega_a)",
        r"\sum_a (\omega_a - \dot\omega_a)",
        r"(\vec r \times \vec v) \cdot \hat e_1",
        r"-(x - m)",
        r"x - (m + M)",
        r"\left(\frac{x}{m}\right)^2",
        r"\left(x^2\right)^3",
        r"\cos^2(\theta) - \cos(\theta^2)",
        r"\frac{d}{dt}\left(m \dot x\right)",
    ] {
        let read = read_formula(latex, &mut table(false), &Macros::default());
        let read = read.unwrap_or_else(|fault| panic!("{latex} is refused: {}", fault.message));
        assert_eq!(read_back(&read, &symbols), Ok(read), "{latex}");
    }
}

/// The same formula with one slip in it, at one of its nodes.
fn slip(expr: &Expr, at: prop::sample::Index) -> Expr {
    fn count(expr: &Expr) -> usize {
        1 + expr.children().into_iter().map(count).sum::<usize>()
    }
    fn change(expr: &mut Expr, left: &mut usize) {
        if *left == 0 {
            let span = expr.span;
            let inner = std::mem::replace(expr, Expr::new(Node::Pi, span));
            *expr = match inner.node {
                Node::Number(digits) => Expr::new(Node::Number(digits + "7"), span),
                _ => Expr::new(Node::Norm(Box::new(inner)), span),
            };
            *left = usize::MAX;
            return;
        }
        *left -= 1;
        for child in expr.children_mut() {
            if *left != usize::MAX {
                change(child, left);
            }
        }
    }
    let (mut changed, mut left) = (expr.clone(), at.index(count(expr)));
    change(&mut changed, &mut left);
    changed
}

/// Reads a text in every way; a fault lies within it.
fn total(text: &str) {
    for open in [true, false] {
        let mut symbols = table(open);
        if let Err(fault) = read_formula(text, &mut symbols, &Macros::default()) {
            assert!(fault.span.start <= fault.span.end && fault.span.end <= text.len(), "{text:?}: {fault:?}");
            assert!(!fault.message.is_empty());
        }
        let mut table = table(open);
        // Half of the texts are read for their structure too.
        table.may_be_abstract = open;
        let reading = read_display(text, &mut table, &Macros::default());
        assert!(!reading.statements.is_empty(), "{text:?} passes for no statement at all");
        for fault in reading.statements.iter().filter_map(|statement| statement.as_ref().err()) {
            assert!(fault.span.start <= fault.span.end && fault.span.end <= text.len(), "{text:?}: {fault:?}");
        }
    }
}

/// What LaTeX is made of, and what it is not.
fn piece() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "a",
        "x",
        "2",
        "0.5",
        "1e400",
        "{",
        "}",
        "(",
        ")",
        "[",
        "]",
        "|",
        "\\left",
        "\\right",
        "\\left(",
        "\\right)",
        "\\left.",
        "^",
        "_",
        "'",
        "&",
        "\\\\",
        "=",
        "<",
        "+",
        "-",
        "*",
        "/",
        ",",
        ";",
        ".",
        "!",
        "~",
        "$",
        "#1",
        "%",
        "\n",
        " ",
        "\\,",
        "\\quad",
        "\\",
        "\\frac",
        "\\frac{d}{dt}",
        "\\frac12",
        "\\sqrt",
        "\\sqrt[3]",
        "\\dot",
        "\\ddot",
        "\\hat",
        "\\vec",
        "\\mathbf",
        "\\mathrm",
        "\\text{ is constant}",
        "\\text{",
        "\\sin",
        "\\cos^2",
        "\\ln",
        "\\theta",
        "\\lambda_1",
        "\\pi",
        "\\epsilon_{abc}",
        "\\delta_{ab}",
        "R_{ab}",
        "\\omega_a",
        "\\sum_a",
        "\\sum",
        "\\times",
        "\\cdot",
        "\\pm",
        "\\mp",
        "\\begin{pmatrix}",
        "\\end{pmatrix}",
        "\\begin{aligned}",
        "\\end{aligned}",
        "\\begin",
        "\\end",
        "\\Rightarrow",
        "\\equiv",
        "\\approx",
        "\\propto",
        "\\tag{1}",
        "\\label{x}",
        "\\Delta",
        "\\partial",
        "\\nabla",
        "\\foo",
        "e",
        "d",
        "t",
        "θ",
        "²",
        "𝑥",
        "\u{0}",
        "\u{feff}",
        "−",
    ])
}

#[test]
fn long_texts_are_read_or_refused() {
    for piece in [
        "a+", "a ", "{", "}", "\\frac", "\\left(", "^a", "_a", "'", "\\\\", "\\dot", "((", "a=", "\\pm a", "|", "-",
        "&",
    ] {
        for length in [1_000, 100_000] {
            total(&piece.repeat(length));
        }
    }
}
