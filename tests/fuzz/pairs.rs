//! Pairs of formulas that are equal, or unequal, by the way they are made.

use super::draw::Draw;
use super::tree::Tree::{Call, Letter, Norm, Number, Power, Product, Quotient, Root, Sum};
use super::tree::{LETTERS, Tree, positive, smooth};

fn boxed(tree: &Tree) -> Box<Tree> {
    Box::new(tree.clone())
}

fn call(name: &'static str, of: &Tree) -> Tree {
    Call(name, boxed(of))
}

fn minus(of: Tree) -> Tree {
    Product(vec![Number(-1), of])
}

fn square(of: &Tree) -> Tree {
    Power(boxed(of), 2)
}

/// The two sides of an identity that holds wherever both have a value.
fn identity(draw: &mut Draw) -> (Tree, Tree) {
    let (a, b) = (smooth(draw, 1), smooth(draw, 1));
    let (p, q) = (positive(draw, 1), positive(draw, 1));
    let n = |n| Number(n);
    let over = |a: &Tree, b: &Tree| Quotient(boxed(a), boxed(b));
    let sum = || Sum(vec![a.clone(), b.clone()]);
    let times = |a: &Tree, b: &Tree| Product(vec![a.clone(), b.clone()]);
    match draw.below(26) {
        0 => (Sum(vec![square(&call("sin", &a)), square(&call("cos", &a))]), n(1)),
        1 => (
            call("sin", &sum()),
            Sum(vec![times(&call("sin", &a), &call("cos", &b)), times(&call("cos", &a), &call("sin", &b))]),
        ),
        2 => (
            call("cos", &sum()),
            Sum(vec![times(&call("cos", &a), &call("cos", &b)), minus(times(&call("sin", &a), &call("sin", &b)))]),
        ),
        3 => (call("cos", &times(&n(2), &a)), Sum(vec![n(1), Product(vec![n(-2), square(&call("sin", &a))])])),
        4 => (square(&sum()), Sum(vec![square(&a), Product(vec![n(2), a.clone(), b.clone()]), square(&b)])),
        5 => (Sum(vec![square(&a), minus(square(&b))]), times(&sum(), &Sum(vec![a.clone(), minus(b.clone())]))),
        6 => (call("exp", &sum()), times(&call("exp", &a), &call("exp", &b))),
        7 => (call("ln", &times(&p, &q)), Sum(vec![call("ln", &p), call("ln", &q)])),
        8 => (call("ln", &over(&p, &q)), Sum(vec![call("ln", &p), minus(call("ln", &q))])),
        9 => (Root(Box::new(square(&a))), Norm(boxed(&a))),
        10 => (Root(Box::new(times(&p, &q))), times(&Root(boxed(&p)), &Root(boxed(&q)))),
        11 => (square(&Root(boxed(&p))), p),
        12 => (over(&times(&a, &p), &p), a),
        13 => (Sum(vec![over(&a, &p), over(&b, &q)]), over(&Sum(vec![times(&a, &q), times(&b, &p)]), &times(&p, &q))),
        14 => (call("tanh", &a), over(&call("sinh", &a), &call("cosh", &a))),
        15 => (Sum(vec![square(&call("cosh", &a)), minus(square(&call("sinh", &a)))]), n(1)),
        16 => (call("exp", &call("ln", &p)), p),
        17 => (call("ln", &call("exp", &a)), a),
        18 => (Root(Box::new(square(&p))), p),
        19 => (Norm(Box::new(times(&a, &b))), times(&Norm(boxed(&a)), &Norm(boxed(&b)))),
        20 => (square(&Norm(boxed(&a))), square(&a)),
        21 => (call("sin", &call("arctan", &a)), over(&a, &Root(Box::new(Sum(vec![n(1), square(&a)]))))),
        22 => (
            call("sin", &times(&n(3), &a)),
            Sum(vec![times(&n(3), &call("sin", &a)), Product(vec![n(-4), Power(Box::new(call("sin", &a)), 3)])]),
        ),
        23 => (
            Power(Box::new(sum()), 3),
            Sum(vec![
                Power(boxed(&a), 3),
                Product(vec![n(3), square(&a), b.clone()]),
                Product(vec![n(3), a.clone(), square(&b)]),
                Power(boxed(&b), 3),
            ]),
        ),
        24 => (over(&n(1), &Sum(vec![Root(boxed(&p)), n(1)])), {
            over(&Sum(vec![Root(boxed(&p)), n(-1)]), &Sum(vec![p.clone(), n(-1)]))
        }),
        _ => (Root(Box::new(Power(boxed(&p), 4))), square(&p)),
    }
}

/// An identity within a formula.
fn within(draw: &mut Draw, (a, b): (Tree, Tree)) -> (Tree, Tree) {
    let other = smooth(draw, 1);
    let both = |f: &dyn Fn(Tree) -> Tree| (f(a.clone()), f(b.clone()));
    match draw.below(7) {
        0 => both(&|side| Sum(vec![side, other.clone()])),
        1 => both(&|side| Product(vec![other.clone(), side])),
        2 => (Sum(vec![a.clone(), other.clone()]), Sum(vec![other, b.clone()])),
        3 => both(&|side| Quotient(Box::new(side), Box::new(Sum(vec![square(&other), Number(1)])))),
        4 => both(&|side| call("sin", &side)),
        _ => (a, b),
    }
}

/// A pair that is equal wherever both formulas have a value.
pub fn equal(draw: &mut Draw) -> (String, String) {
    match draw.below(12) {
        0 | 1 => derivative(draw),
        2 => complex(draw),
        3 => matrices(draw),
        _ => {
            let pair = identity(draw);
            let (a, b) = within(draw, pair);
            (a.latex(), b.latex())
        }
    }
}

fn in_one_letter(tree: &Tree) -> Tree {
    let all = |trees: &[Tree]| trees.iter().map(in_one_letter).collect();
    let one = |tree: &Tree| Box::new(in_one_letter(tree));
    match tree {
        Letter(_) => Letter(0),
        Number(_) => tree.clone(),
        Sum(terms) => Sum(all(terms)),
        Product(factors) => Product(all(factors)),
        Quotient(a, b) => Quotient(one(a), one(b)),
        Power(base, n) => Power(one(base), *n),
        Call(name, argument) => Call(name, one(argument)),
        Root(argument) => Root(one(argument)),
        Norm(argument) => Norm(one(argument)),
    }
}

fn derivative(draw: &mut Draw) -> (String, String) {
    let formula = match draw.below(4) {
        0 => Quotient(Box::new(smooth(draw, 1)), Box::new(positive(draw, 1))),
        1 => Root(Box::new(positive(draw, 1))),
        2 => call("ln", &positive(draw, 1)),
        _ => smooth(draw, 2),
    };
    let formula = Product(vec![in_one_letter(&formula), Letter(0)]);
    (format!("\\frac{{d}}{{dx}}\\left({}\\right)", formula.latex()), formula.derivative().latex())
}

fn complex(draw: &mut Draw) -> (String, String) {
    let (a, b) = (smooth(draw, 1).latex(), smooth(draw, 1).latex());
    match draw.below(4) {
        0 => (format!("e^{{i\\left({a}\\right)}}"), format!("\\cos\\left({a}\\right) + i\\sin\\left({a}\\right)")),
        1 => {
            (format!("e^{{i\\left({a}\\right)}} e^{{i\\left({b}\\right)}}"), format!("e^{{i\\left({a} + {b}\\right)}}"))
        }
        2 => (
            format!("\\left({a} + i\\left({b}\\right)\\right)\\left({a} - i\\left({b}\\right)\\right)"),
            format!("\\left({a}\\right)^2 + \\left({b}\\right)^2"),
        ),
        _ => (
            format!("\\frac{{e^{{i\\left({a}\\right)}} + e^{{-i\\left({a}\\right)}}}}{{2}}"),
            format!("\\cos\\left({a}\\right)"),
        ),
    }
}

fn matrices(draw: &mut Draw) -> (String, String) {
    let mut matrix = || -> Vec<String> { (0..4).map(|_| smooth(draw, 1).latex()).collect() };
    let (a, b) = (matrix(), matrix());
    let written =
        |m: &[String]| format!("\\begin{{pmatrix}} {} & {} \\\\ {} & {} \\end{{pmatrix}}", m[0], m[1], m[2], m[3]);
    let entry = |i: usize, j: usize| {
        format!(
            "\\left({}\\right)\\left({}\\right) + \\left({}\\right)\\left({}\\right)",
            a[2 * i],
            b[j],
            a[2 * i + 1],
            b[2 + j]
        )
    };
    let product = [entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1)];
    (format!("{} {}", written(&a), written(&b)), written(&product))
}

/// A number 10⁻ᵏ as it is printed.
fn tiny(draw: &mut Draw) -> String {
    let k = draw.whole(6, 40) as usize;
    match draw.below(3) {
        0 => format!("10^{{-{k}}}"),
        1 => format!("0.{}1", "0".repeat(k - 1)),
        _ => format!("\\frac{{1}}{{1{}}}", "0".repeat(k)),
    }
}

/// The number 1 + 10⁻ᵏ as it is printed.
fn nearly_one(draw: &mut Draw) -> String {
    let k = draw.whole(6, 40) as usize;
    format!("1.{}1", "0".repeat(k - 1))
}

/// A pair that differs where both formulas have a value.
pub fn unequal(draw: &mut Draw) -> (String, String) {
    let (a, b) = (draw.whole(-9, 9), draw.whole(1, 9));
    let letter = draw.one(&LETTERS);
    let shift = |letter: &str, a: i64| if a < 0 { format!("{letter} + {}", -a) } else { format!("{letter} - {a}") };
    match draw.below(15) {
        // A term of 10⁻ᵏ, which is 0 nowhere.
        0 | 1 => {
            let pair = identity(draw);
            let (left, right) = within(draw, pair);
            let term = positive(draw, 0);
            (left.latex(), format!("{} + {} \\left({}\\right)", right.latex(), tiny(draw), term.latex()))
        }
        // A factor of 1 + 10⁻ᵏ on what is 0 nowhere.
        2 | 3 => {
            let p = positive(draw, 2).latex();
            (p.clone(), format!("{} \\left({p}\\right)", nearly_one(draw)))
        }
        // The same inside of a function that takes no value twice.
        4 => {
            let p = positive(draw, 1).latex();
            let name = draw.one(&["\\arctan", "\\sinh", "\\ln", "\\tanh"]);
            (
                format!("{name}\\left({p}\\right)"),
                format!("{name}\\left({} \\left({p}\\right)\\right)", nearly_one(draw)),
            )
        }
        // A branch between two roots, or beyond one.
        5 => {
            let width = draw.one(&["1", "0.1", "0.001", "0.00001", "0.0000001"]);
            let (one, other) = (shift(letter, a), format!("{} - {width}", shift(letter, a)));
            let inside = format!("\\left({one}\\right)\\left({other}\\right)");
            (format!("\\left|{inside}\\right|"), inside)
        }
        6 => {
            let inside = shift(letter, a * draw.one(&[1, 1000, 1_000_000]));
            (format!("\\sqrt{{\\left({inside}\\right)^2}}"), inside)
        }
        7 => {
            let close = draw.one(&["0.9", "0.999", "0.99999", "0.9999999"]);
            let inside = format!("{close} - \\sin\\left({b} {letter}\\right)");
            (format!("\\left|{inside}\\right|"), inside)
        }
        8 => {
            let inside = format!("x^2 + y^2 - {}", draw.one(&["0.0001", "0.000001", "1", "1000000"]));
            (format!("\\sqrt{{\\left({inside}\\right)^2}}"), inside)
        }
        // Equal at some whole numbers only.
        9 => {
            let roots: Vec<String> =
                (0..draw.whole(3, 6)).map(|k| format!("\\left({letter} - {}\\right)", a + k)).collect();
            (format!("{letter}^2 + {}", roots.join("")), format!("{letter}^2"))
        }
        // A sign.
        10 => {
            let p = positive(draw, 2).latex();
            (p.clone(), format!("-\\left({p}\\right)"))
        }
        // An exponent.
        11 => (
            format!("\\left({letter}^2 + {b}\\right)^{{{b}}}"),
            format!("\\left({letter}^2 + {b}\\right)^{{{}}}", b + 1),
        ),
        12 => (format!("\\sqrt{{{letter}^{{{}}}}}", 4 * b + 2), format!("{letter}^{{{}}}", 2 * b + 1)),
        // A derivative with a coefficient off.
        13 => {
            let (left, right) = derivative(draw);
            (left, format!("{right} + {} \\left(x^2 + 1\\right)", tiny(draw)))
        }
        // An entry of a matrix off.
        _ => {
            let (left, right) = matrices(draw);
            (left, right.replacen(" & ", &format!(" + {} & ", tiny(draw)), 1))
        }
    }
}
