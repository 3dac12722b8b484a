//! The formulas are as short as those in the books.

use onshell::derive::Quantity;
use onshell::formula::{Expr, Node};

use super::support::{Subject, agree, numbers, subject};

/// How many letters and numbers a formula has in it, a power counting once.
fn leaves(formula: &Expr) -> usize {
    let mut count = 0;
    formula.walk(&mut |part| {
        count += usize::from(matches!(part.node, Node::Symbol { .. } | Node::Number(_) | Node::Pi));
    });
    count
}

/// What is derived has the value of the formula from the book, and is not longer.
fn as_in_the_book(subject: &Subject, quantity: Quantity, n: usize, book: &str) {
    let derived = subject.right(quantity, n);
    let printed = subject.latex(quantity).expect("it is derived")[n].clone();
    for k in 0..5 {
        let at = numbers(&subject.system, k);
        let [left, right] =
            [subject.value(printed.split_once(" = ").expect("an equation").1, &at), subject.value(book, &at)];
        assert!(agree(left, right, left.abs() + right.abs()), "{printed} is not {book}");
    }
    assert!(leaves(&derived) <= leaves(&subject.read(book)), "{printed} is longer than {book}");
}

#[test]
fn the_heavy_top_is_printed_as_physicists_print_it() {
    let top = subject("heavy_top");
    as_in_the_book(
        &top,
        Quantity::Lagrangian,
        0,
        r"\frac{1}{2} \lambda_1 (\dot\theta^2 + \dot\phi^2 \sin^2\theta) + \frac{1}{2} \lambda_3 (\dot\psi + \dot\phi \cos\theta)^2 - M g R \cos\theta",
    );
    as_in_the_book(
        &top,
        Quantity::Momenta,
        0,
        r"\lambda_1 \dot\phi \sin^2\theta + \lambda_3 (\dot\psi + \dot\phi \cos\theta) \cos\theta",
    );
    as_in_the_book(&top, Quantity::Momenta, 2, r"\lambda_3 (\dot\psi + \dot\phi \cos\theta)");
    as_in_the_book(
        &top,
        Quantity::EulerLagrange,
        1,
        r"\lambda_1 \dot\phi^2 \sin\theta \cos\theta - \lambda_3 (\dot\psi + \dot\phi \cos\theta) \dot\phi \sin\theta + M g R \sin\theta",
    );
    as_in_the_book(
        &top,
        Quantity::Hamiltonian,
        0,
        r"\frac{p_\theta^2}{2 \lambda_1} + \frac{(p_\phi - p_\psi \cos\theta)^2}{2 \lambda_1 \sin^2\theta} + \frac{p_\psi^2}{2 \lambda_3} + M g R \cos\theta",
    );
    as_in_the_book(
        &top,
        Quantity::Hamilton,
        4,
        r"\frac{(p_\phi - p_\psi \cos\theta)(p_\phi \cos\theta - p_\psi)}{\lambda_1 \sin^3\theta} + M g R \sin\theta",
    );
}

#[test]
fn so_are_the_others() {
    as_in_the_book(&subject("simple_pendulum"), Quantity::Accelerations, 0, r"- \frac{g}{l} \sin\theta");
    as_in_the_book(
        &subject("kepler"),
        Quantity::Hamiltonian,
        0,
        r"\frac{p_r^2}{2 m} + \frac{p_\phi^2}{2 m r^2} - \frac{G M m}{r}",
    );
    as_in_the_book(&subject("damped_oscillator"), Quantity::EulerLagrange, 0, r"- \gamma m \dot x - k x");
    let particle = subject("relativistic_particle");
    as_in_the_book(&particle, Quantity::Momenta, 0, r"\frac{m \dot x}{\sqrt{1 - \frac{\dot x^2}{c^2}}}");
    as_in_the_book(
        &particle,
        Quantity::Energy,
        0,
        r"\frac{m c^2}{\sqrt{1 - \frac{\dot x^2}{c^2}}} + \frac{1}{2} k x^2",
    );
    as_in_the_book(
        &subject("double_pendulum"),
        Quantity::Lagrangian,
        0,
        r"\frac{1}{2} m l^2 (2 \dot\theta_1^2 + \dot\theta_2^2 + 2 \dot\theta_1 \dot\theta_2 \cos(\theta_1 - \theta_2)) + m g l (2 \cos\theta_1 + \cos\theta_2)",
    );
    as_in_the_book(
        &subject("free_rigid_body"),
        Quantity::Energy,
        0,
        r"\frac{1}{2} \lambda_1 (\dot\theta \sin\psi - \dot\phi \sin\theta \cos\psi)^2 + \frac{1}{2} \lambda_2 (\dot\theta \cos\psi + \dot\phi \sin\theta \sin\psi)^2 + \frac{1}{2} \lambda_3 (\dot\psi + \dot\phi \cos\theta)^2",
    );
}

#[test]
#[should_panic(expected = "is longer than")]
fn a_formula_longer_than_the_book_is_noticed() {
    as_in_the_book(&subject("heavy_top"), Quantity::Momenta, 0, r"p_\phi");
}

#[test]
#[should_panic(expected = "is not")]
fn a_formula_that_is_another_than_in_the_book_is_noticed() {
    as_in_the_book(&subject("heavy_top"), Quantity::EulerLagrange, 0, r"2 \lambda_3 \dot\phi \dot\theta \sin\theta");
}
