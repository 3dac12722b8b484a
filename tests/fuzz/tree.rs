//! Formulas as trees of the test's own: written as LaTeX, evaluated and differentiated without onshell.

use super::draw::Draw;

/// The letters that occur.
pub const LETTERS: [&str; 3] = ["x", "y", "z"];

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    Number(i64),
    Letter(usize),
    Sum(Vec<Tree>),
    Product(Vec<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, u32),
    Call(&'static str, Box<Tree>),
    Root(Box<Tree>),
    Norm(Box<Tree>),
}

use Tree::{Call, Letter, Norm, Number, Power, Product, Quotient, Root, Sum};

impl Tree {
    /// The formula as LaTeX, with a parenthesis around every sum inside of something else.
    pub fn latex(&self) -> String {
        let inner = |tree: &Tree| match tree {
            Letter(_) => tree.latex(),
            Number(n) if *n >= 0 => tree.latex(),
            _ => format!("\\left({}\\right)", tree.latex()),
        };
        match self {
            Number(n) => n.to_string(),
            Letter(n) => LETTERS[*n].to_owned(),
            Sum(terms) => terms
                .iter()
                .enumerate()
                .map(|(at, term)| match term {
                    Number(n) if *n < 0 && at > 0 => format!(" - {}", -n),
                    Sum(_) => format!(" + {}", inner(term)),
                    _ => format!("{}{}", if at > 0 { " + " } else { "" }, term.latex()),
                })
                .collect::<String>()
                .trim_start_matches(" + ")
                .to_owned(),
            Product(factors) => factors.iter().map(inner).collect::<Vec<_>>().join(" \\cdot "),
            Quotient(a, b) => format!("\\frac{{{}}}{{{}}}", a.latex(), b.latex()),
            Power(base, n) => format!("{}^{{{n}}}", inner(base)),
            // With a number alone above it, e may be a letter.
            Call("exp", argument) if argument.has_letters() => format!("e^{{{}}}", argument.latex()),
            Call(name, argument) => format!("\\{name}\\left({}\\right)", argument.latex()),
            Root(argument) => format!("\\sqrt{{{}}}", argument.latex()),
            Norm(argument) => format!("\\left|{}\\right|", argument.latex()),
        }
    }

    fn has_letters(&self) -> bool {
        match self {
            Letter(_) => true,
            Number(_) => false,
            Sum(parts) | Product(parts) => parts.iter().any(Tree::has_letters),
            Quotient(a, b) => a.has_letters() || b.has_letters(),
            Power(inner, _) | Call(_, inner) | Root(inner) | Norm(inner) => inner.has_letters(),
        }
    }

    /// The value, and the size of the largest number on the way.
    pub fn value(&self, letters: &[(&str, f64)]) -> (f64, f64) {
        let of = |tree: &Tree| tree.value(letters);
        let (value, size) = match self {
            Number(n) => (*n as f64, 1.0),
            Letter(n) => (letters[*n].1, 1.0),
            Sum(terms) => terms.iter().map(of).fold((0.0, 0.0), |(a, s), (b, t)| (a + b, f64::max(s, t))),
            Product(factors) => factors.iter().map(of).fold((1.0, 1.0), |(a, s), (b, t)| (a * b, s * t.max(1.0))),
            Quotient(a, b) => {
                let ((a, s), (b, t)) = (of(a), of(b));
                (a / b, s.max(1.0) * t.max(1.0) * (1.0 + 1.0 / (b * b)))
            }
            Power(base, n) => {
                let (x, s) = of(base);
                (x.powi(*n as i32), s.max(1.0).powi(*n as i32))
            }
            Call(name, argument) => {
                let (x, s) = of(argument);
                let value = match *name {
                    "sin" => x.sin(),
                    "cos" => x.cos(),
                    "sinh" => x.sinh(),
                    "cosh" => x.cosh(),
                    "tanh" => x.tanh(),
                    "arctan" => x.atan(),
                    "ln" => x.ln(),
                    _ => x.exp(),
                };
                (value, s.max(1.0) * value.abs().max(1.0) * if *name == "ln" { 1.0 + 1.0 / x.abs() } else { 1.0 })
            }
            Root(argument) => {
                let (x, s) = of(argument);
                (x.sqrt(), s.max(1.0) * (1.0 + 1.0 / x.abs().sqrt()))
            }
            Norm(argument) => {
                let (x, s) = of(argument);
                (x.abs(), s)
            }
        };
        (value, size.max(value.abs()))
    }

    /// The derivative by the first letter.
    pub fn derivative(&self) -> Tree {
        let times = |a: Tree, b: Tree| match (&a, &b) {
            (Number(0), _) | (_, Number(0)) => Number(0),
            (Number(1), _) => b,
            (_, Number(1)) => a,
            _ => Product(vec![a, b]),
        };
        match self {
            Number(_) => Number(0),
            Letter(n) => Number(i64::from(*n == 0)),
            Sum(terms) => {
                let all: Vec<Tree> = terms.iter().map(Tree::derivative).filter(|term| *term != Number(0)).collect();
                if all.is_empty() { Number(0) } else { Sum(all) }
            }
            Product(factors) => {
                let each = (0..factors.len()).map(|at| {
                    let change = factors[at].derivative();
                    let mut others = factors.clone();
                    others.remove(at);
                    if others.is_empty() { change } else { times(change, Product(others)) }
                });
                let all: Vec<Tree> = each.filter(|term| *term != Number(0)).collect();
                if all.is_empty() { Number(0) } else { Sum(all) }
            }
            Quotient(a, b) => {
                let above = Sum(vec![
                    times(a.derivative(), (**b).clone()),
                    times(Number(-1), times((**a).clone(), b.derivative())),
                ]);
                Quotient(Box::new(above), Box::new(Power(b.clone(), 2)))
            }
            Power(base, n) => {
                let less = if *n == 2 { (**base).clone() } else { Power(base.clone(), n - 1) };
                times(Number(i64::from(*n)), times(less, base.derivative()))
            }
            Call(name, argument) => {
                let call = |name| Call(name, argument.clone());
                let square = |of: Tree| Power(Box::new(of), 2);
                let over = |below: Tree| Quotient(Box::new(Number(1)), Box::new(below));
                let outer = match *name {
                    "sin" => call("cos"),
                    "cos" => times(Number(-1), call("sin")),
                    "sinh" => call("cosh"),
                    "cosh" => call("sinh"),
                    "tanh" => over(square(call("cosh"))),
                    "arctan" => over(Sum(vec![Number(1), square((**argument).clone())])),
                    "ln" => over((**argument).clone()),
                    _ => self.clone(),
                };
                times(outer, argument.derivative())
            }
            Root(argument) => {
                Quotient(Box::new(argument.derivative()), Box::new(Product(vec![Number(2), Root(argument.clone())])))
            }
            Norm(argument) => {
                let sign = Quotient(Box::new((**argument).clone()), Box::new(self.clone()));
                times(sign, argument.derivative())
            }
        }
    }
}

/// A formula without roots, logarithms and quotients: it has a value everywhere, and is smooth.
pub fn smooth(draw: &mut Draw, depth: usize) -> Tree {
    let inner = |draw: &mut Draw| smooth(draw, depth - 1);
    match draw.below(if depth == 0 { 3 } else { 9 }) {
        0 => Number(draw.whole(1, 5)),
        1 | 2 => Letter(draw.below(LETTERS.len())),
        3 | 4 => Sum(vec![inner(draw), inner(draw)]),
        5 | 6 => Product(vec![inner(draw), inner(draw)]),
        7 => Power(Box::new(inner(draw)), draw.whole(2, 3) as u32),
        _ => {
            let name = draw.one(&["sin", "cos", "arctan", "tanh", "sin", "cos"]);
            Call(name, Box::new(inner(draw)))
        }
    }
}

/// A formula that is at least 1 everywhere.
pub fn positive(draw: &mut Draw, depth: usize) -> Tree {
    Sum(vec![Power(Box::new(smooth(draw, depth)), 2), Number(draw.whole(1, 3))])
}

/// Any formula that has a value wherever the letters are positive numbers of order one, or nearly so.
pub fn any(draw: &mut Draw, depth: usize) -> Tree {
    let inner = |draw: &mut Draw| any(draw, depth - 1);
    match draw.below(if depth == 0 { 3 } else { 14 }) {
        0 => Number(draw.whole(0, 12)),
        1 | 2 => Letter(draw.below(LETTERS.len())),
        3 | 4 => Sum((0..draw.whole(2, 3)).map(|_| inner(draw)).collect()),
        5 | 6 => Product((0..draw.whole(2, 3)).map(|_| inner(draw)).collect()),
        7 => Power(Box::new(inner(draw)), draw.whole(2, 4) as u32),
        8 => Quotient(Box::new(inner(draw)), Box::new(inner(draw))),
        9 => Root(Box::new(inner(draw))),
        10 => Norm(Box::new(inner(draw))),
        _ => {
            let name = draw.one(&["sin", "cos", "arctan", "tanh", "sinh", "cosh", "ln", "exp"]);
            Call(name, Box::new(inner(draw)))
        }
    }
}
