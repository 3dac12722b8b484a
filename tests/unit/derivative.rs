//! Derivatives of formulas, compared with automatic differentiation: the same formula over dual numbers.

use num_dual::Dual64;
use onshell::formula::derivative::{NoDerivative, Scope, partial, rate};
use onshell::formula::tree::Variable;
use onshell::formula::{Assignment, Expr, SymbolId, Symbols, Value, evaluate};
use onshell::source::Span;
use proptest::prelude::*;

use super::printing::formulas::{SCALARS, open, table};

/// The values of the letters and of their rates, all different.
fn number(at: usize, dots: u8) -> f64 {
    0.31 + 0.17 * at as f64 + 0.23 * f64::from(dots)
}

/// The value of a formula where each letter has a value, and one of them a derivative of 1.
fn over_duals(expr: &Expr, symbols: &Symbols, by: &Variable) -> Option<Dual64> {
    let mut state = Assignment::<Dual64>::new(symbols);
    for at in 0..SCALARS.len() {
        for dots in 0..8 {
            let eps = if SymbolId(at) == by.id && dots == by.dots { 1.0 } else { 0.0 };
            state.set(SymbolId(at), dots, Dual64::new(number(at, dots), eps));
        }
    }
    match evaluate(expr, &state, &[]) {
        Ok(Value::Scalar(value)) => Some(value.value()),
        _ => None,
    }
}

/// Whether two numbers agree, where rounding leaves anything to compare.
fn agree(a: f64, b: f64) -> bool {
    !a.is_finite()
        || !b.is_finite()
        || a.abs().max(b.abs()) > 1e9
        || (a - b).abs() <= 1e-6 * (1.0 + a.abs().max(b.abs()))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

    #[test]
    fn a_partial_derivative_is_what_dual_numbers_give(expr in open(), at in 0..SCALARS.len(), dots in 0..2u8) {
        let symbols = table(true);
        let by = Variable { id: SymbolId(at), indices: Vec::new(), dots };
        let scope = Scope { symbols: &symbols, fixed: &[] };
        let found = match partial(&expr, &by, scope, Span::default()) {
            Err(NoDerivative::Operation("a formula as long as this")) => return Ok(()),
            found => found.expect("formulas of numbers have derivatives"),
        };
        let derivative = over_duals(&found, &symbols, &by).map(|value| value.re);
        if let (Some(dual), Some(derivative)) = (over_duals(&expr, &symbols, &by), derivative) {
            prop_assert!(agree(dual.eps, derivative), "{} and {}", dual.eps, derivative);
        }
    }

    #[test]
    fn a_rate_is_linear_in_the_rates_of_the_letters(expr in open()) {
        let symbols = table(true);
        let scope = Scope { symbols: &symbols, fixed: &[] };
        let found = match rate(&expr, scope, Span::default()) {
            // Powers within powers have rates of many thousand parts.
            Err(NoDerivative::Operation("a formula as long as this")) => return Ok(()),
            found => found.expect("formulas of numbers have rates"),
        };
        let by = |at: usize, dots: u8| Variable { id: SymbolId(at), indices: Vec::new(), dots };
        let mut sum = 0.0;
        for at in 0..SCALARS.len() {
            for dots in 0..7 {
                let Some(value) = over_duals(&expr, &symbols, &by(at, dots)) else { return Ok(()) };
                sum += value.eps * number(at, dots + 1);
            }
        }
        if let Some(value) = over_duals(&found, &symbols, &by(0, 7)) {
            prop_assert!(agree(value.re, sum), "{} and {}", value.re, sum);
        }
    }
}

#[test]
fn what_no_formula_gives_has_no_derivative() {
    let mut symbols = table(true);
    symbols.entry_mut(SymbolId(0)).derived = true;
    let expr =
        Expr::new(onshell::formula::Node::Symbol { id: SymbolId(0), indices: Vec::new(), dots: 0 }, Span::default());
    let by = Variable { id: SymbolId(1), indices: Vec::new(), dots: 0 };
    let scope = Scope { symbols: &symbols, fixed: &[] };
    assert_eq!(partial(&expr, &by, scope, Span::default()), Err(NoDerivative::Unknown(SymbolId(0))));
}
