//! Random formulas: of numbers alone, and of vectors, matrices and indices too.

use onshell::formula::tree::{Excluded, Index, IndexId, Sign};
use onshell::formula::{Expr, Function, Kind, Node, SymbolId, Symbols, Term};
use onshell::latex::names;
use onshell::source::Span;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

/// Numbers; the first are in both tables.
pub const SCALARS: [&str; 10] =
    ["x", "m", "M", r"\theta", r"\lambda_1", "p_\\psi", r"\omega_0", "x'", r"T_{\mathrm{rot}}", r"\Omega_{+}"];

/// Those that are known to be angles.
const ANGLES: [&str; 2] = ["x", r"\theta"];

/// A table of names; a closed one has indices, vectors and matrices as well.
pub fn table(open: bool) -> Symbols {
    let mut symbols = if open { Symbols::open() } else { Symbols::new() };
    if !open {
        for letter in ["a", "b", "c"] {
            symbols.add_index(letter, 3);
        }
        for letter in ["i", "j"] {
            symbols.add_label(letter, 4, None);
        }
    }
    let mut add = |latex: &str, kind: Kind| {
        let (name, _) = names::parse(latex).expect("it is a name");
        let id = symbols.add(name, kind).expect("it is new");
        symbols.entry_mut(id).varies = true;
        symbols.entry_mut(id).angle = ANGLES.contains(&latex);
    };
    SCALARS.iter().for_each(|name| add(name, Kind::Scalar));
    if !open {
        add(r"\vec{r}", Kind::Vector);
        add(r"\vec{v}", Kind::Vector);
        add(r"\hat{e}_a", Kind::Vector);
        add(r"\omega_a", Kind::Scalar);
        add(r"R_{ab}", Kind::Scalar);
        add(r"\mathbf{R}", Kind::Matrix(3, 3));
        add(r"\mathbf{S}_z", Kind::Rotation);
        add(r"m_i", Kind::Scalar);
        add(r"\vec{r}_i", Kind::Vector);
        add(r"V", Kind::Scalar);
        add(r"\omega_{eff}", Kind::Scalar);
        let place = names::parse(r"\vec r").map(|(name, _)| name);
        let continuum = symbols.entry_mut(CONTINUUM);
        (continuum.argument, continuum.measure) = (place, Some(3));
        symbols.entry_mut(SQUARE).squared = true;
    }
    symbols
}

const VEC_R: SymbolId = SymbolId(10);
const VEC_V: SymbolId = SymbolId(11);
const AXES: SymbolId = SymbolId(12);
const OMEGA: SymbolId = SymbolId(13);
const ENTRIES: SymbolId = SymbolId(14);
const MATRIX: SymbolId = SymbolId(15);
const ROTATION: SymbolId = SymbolId(16);
const MASSES: SymbolId = SymbolId(17);
const PLACES: SymbolId = SymbolId(18);
const CONTINUUM: SymbolId = SymbolId(19);
const SQUARE: SymbolId = SymbolId(20);
const I: IndexId = IndexId(3);
const J: IndexId = IndexId(4);

fn node(node: Node) -> Expr {
    Expr::new(node, Span::default())
}

fn symbol(id: SymbolId, indices: &[Index], dots: u8) -> Expr {
    node(Node::Symbol { id, indices: indices.to_vec(), dots })
}

fn product(factors: Vec<Expr>) -> Expr {
    node(Node::Product(factors))
}

fn boxed(expr: Expr) -> Box<Expr> {
    Box::new(expr)
}

/// Terms with signs; a lone term is negative, or it would be no sum.
fn sum(terms: Vec<(bool, Expr)>) -> Expr {
    let lone = terms.len() == 1;
    let term = |(minus, expr): (bool, Expr)| Term {
        sign: if minus || lone { Sign::Minus } else { Sign::Plus },
        sign_span: None,
        expr,
    };
    node(Node::Sum(terms.into_iter().map(term).collect()))
}

fn number() -> impl Strategy<Value = Expr> {
    select(vec!["0", "1", "2", "12", "0.5", "3.25"]).prop_map(|digits| node(Node::Number(digits.to_owned())))
}

fn letter() -> impl Strategy<Value = Expr> {
    (0..SCALARS.len(), 0..4u8).prop_map(|(at, dots)| symbol(SymbolId(at), &[], dots))
}

/// What two scalars and more make, over any scalars.
fn scalars(leaf: BoxedStrategy<Expr>) -> BoxedStrategy<Expr> {
    let deeper = |inner: BoxedStrategy<Expr>| {
        let functions: Vec<Function> = Function::ALL.iter().map(|(function, _)| *function).collect();
        let two = (inner.clone(), inner.clone());
        prop_oneof![
            3 => vec((any::<bool>(), inner.clone()), 1..4).prop_map(sum),
            3 => vec(inner.clone(), 2..4).prop_map(product),
            2 => two.clone().prop_map(|(a, b)| node(Node::Quotient(boxed(a), boxed(b)))),
            2 => two.prop_map(|(a, b)| node(Node::Power(boxed(a), boxed(b)))),
            1 => inner.clone().prop_filter("e with a number above is refused", |a| !a.symbols().is_empty())
                .prop_map(|a| node(Node::Power(boxed(node(Node::Euler)), boxed(a)))),
            1 => (2..5u32, inner.clone()).prop_map(|(n, a)| node(Node::Root(n, boxed(a)))),
            2 => (select(functions), inner.clone()).prop_map(|(f, a)| node(Node::Call(f, boxed(a)))),
            1 => (1..4u8, inner.clone()).prop_map(|(n, a)| node(Node::TimeDerivative(n, boxed(a)))),
            1 => inner.prop_map(|a| node(Node::Norm(boxed(a)))),
        ]
        .boxed()
    };
    leaf.prop_recursive(4, 24, 3, deeper).boxed()
}

/// Formulas of numbers alone.
pub fn open() -> impl Strategy<Value = Expr> {
    scalars(prop_oneof![2 => number(), 4 => letter(), 1 => Just(node(Node::Pi))].boxed())
}

fn fixed() -> impl Strategy<Value = Index> {
    (1..=3u8).prop_map(Index::Fixed)
}

fn index(at: usize) -> Index {
    Index::Letter(IndexId(at))
}

/// Numbers that indices make: components, and sums over repeated letters.
fn contracted() -> impl Strategy<Value = Expr> {
    let (a, b, c) = (index(0), index(1), index(2));
    prop_oneof![
        (fixed(), 0..2u8).prop_map(|(i, dots)| symbol(OMEGA, &[i], dots)),
        particles(symbol(MASSES, &[Index::Letter(I)], 0)),
        Just(symbol(SQUARE, &[], 0)),
        (fixed(), fixed(), 0..2u8).prop_map(|(i, j, dots)| symbol(ENTRIES, &[i, j], dots)),
        (fixed(), fixed(), any::<bool>()).prop_map(|(i, j, inverse)| entry(inverse, i, j)),
        Just(symbol(ENTRIES, &[a, a], 0)),
        Just(product(vec![symbol(OMEGA, &[a], 0), symbol(OMEGA, &[a], 1)])),
        (0..2u8).prop_map(move |dots| product(vec![
            symbol(OMEGA, &[a], 0),
            symbol(ENTRIES, &[a, b], dots),
            symbol(OMEGA, &[b], 0)
        ])),
        any::<bool>().prop_map(move |inverse| product(vec![symbol(ENTRIES, &[a, b], 1), entry(inverse, b, a)])),
        Just(product(vec![node(Node::Epsilon([a, b, c])), symbol(ENTRIES, &[a, b], 0), symbol(OMEGA, &[c], 0)])),
        fixed().prop_map(move |i| product(vec![node(Node::Epsilon([a, i, b])), symbol(ENTRIES, &[a, b], 0)])),
        Just(product(vec![node(Node::Delta([a, b])), symbol(ENTRIES, &[b, a], 0)])),
        any::<bool>().prop_map(move |sums| {
            let terms = vec![(false, symbol(OMEGA, &[a], 0)), (true, symbol(OMEGA, &[a], 1))];
            let body = if sums { sum(terms) } else { product(terms.into_iter().map(|(_, term)| term).collect()) };
            node(Node::SumOver {
                index: IndexId(0),
                implied: false,
                except: Vec::new(),
                within: None,
                body: boxed(body),
            })
        }),
    ]
}

/// `R_{ij}^{-1}` or `R_{ij}^{T}`.
fn entry(inverse: bool, i: Index, j: Index) -> Expr {
    let whole = boxed(symbol(ENTRIES, &[], 0));
    let changed = if inverse { Node::Inverse(whole) } else { Node::Transpose(whole) };
    node(Node::Entry(boxed(node(changed)), i, j))
}

/// Over all i, or all but j or a number, or those within a continuum.
fn particles(body: Expr) -> impl Strategy<Value = Expr> {
    let except = prop_oneof![
        2 => Just(vec![]),
        1 => (1..=4u8).prop_map(|value| vec![Excluded::Value(Index::Fixed(value))]),
        1 => Just(vec![Excluded::Value(Index::Letter(J))]),
        1 => Just(vec![Excluded::From(Index::Letter(J))]),
        1 => Just(vec![Excluded::UpTo(Index::Letter(J)), Excluded::Value(Index::Fixed(2))]),
        1 => Just(vec![Excluded::UpTo(Index::Fixed(1)), Excluded::Last(1)]),
    ];
    let within = prop_oneof![Just(None), Just(Some(CONTINUUM))];
    (except, within, any::<bool>()).prop_map(move |(except, within, sums)| {
        let terms = vec![(false, body.clone()), (true, body.clone())];
        let body = Box::new(if sums { sum(terms) } else { body.clone() });
        let over_j = except.iter().any(|left_out| matches!(left_out.index(), Some(Index::Letter(_))));
        let inner = node(Node::SumOver { index: I, implied: false, except, within, body });
        if over_j { node(Node::over(J, inner)) } else { inner }
    })
}

/// An integral over a continuum, or the limit as it shrinks.
fn of_continuum(body: Expr, integral: bool) -> Expr {
    node(if integral { Node::Integral(CONTINUUM, boxed(body)) } else { Node::Shrinking(CONTINUUM, boxed(body)) })
}

fn vectors(scalar: BoxedStrategy<Expr>) -> BoxedStrategy<Expr> {
    let leaf = prop_oneof![
        (select(vec![VEC_R, VEC_V]), 0..3u8).prop_map(|(id, dots)| symbol(id, &[], dots)),
        (fixed(), 0..2u8).prop_map(|(i, dots)| symbol(AXES, &[i], dots)),
        Just(symbol(OMEGA, &[], 0)),
        Just(product(vec![symbol(OMEGA, &[index(0)], 0), symbol(AXES, &[index(0)], 0)])),
        particles(product(vec![symbol(MASSES, &[Index::Letter(I)], 0), symbol(PLACES, &[Index::Letter(I)], 1)])),
        vec(scalar.clone(), 3).prop_map(|entries| node(Node::Matrix(entries.into_iter().map(|x| vec![x]).collect()))),
    ];
    leaf.prop_recursive(3, 12, 3, move |inner| {
        prop_oneof![
            vec((any::<bool>(), inner.clone()), 1..3).prop_map(sum),
            (scalar.clone(), inner.clone()).prop_map(|(x, v)| product(vec![x, v])),
            (inner.clone(), scalar.clone()).prop_map(|(v, x)| node(Node::Quotient(boxed(v), boxed(x)))),
            (inner.clone(), inner.clone()).prop_map(|(v, w)| node(Node::Cross(boxed(v), boxed(w)))),
            inner.clone().prop_map(|v| node(Node::TimeDerivative(1, boxed(v)))),
            (inner.clone(), any::<bool>()).prop_map(|(v, integral)| of_continuum(v, integral)),
            inner.prop_map(|v| product(vec![symbol(MATRIX, &[], 0), v])),
        ]
    })
    .boxed()
}

fn matrices(scalar: BoxedStrategy<Expr>) -> BoxedStrategy<Expr> {
    let leaf = prop_oneof![
        (0..2u8).prop_map(|dots| symbol(MATRIX, &[], dots)),
        Just(symbol(ENTRIES, &[], 0)),
        scalar.clone().prop_map(|angle| node(Node::Apply(ROTATION, vec![angle]))),
        vec(vec(scalar.clone(), 3), 3).prop_map(|rows| node(Node::Matrix(rows))),
    ];
    leaf.prop_recursive(3, 12, 3, move |inner| {
        prop_oneof![
            vec((any::<bool>(), inner.clone()), 1..3).prop_map(sum),
            vec(inner.clone(), 2..4).prop_map(product),
            (scalar.clone(), inner.clone()).prop_map(|(x, m)| product(vec![x, m])),
            inner.clone().prop_map(|m| node(Node::Transpose(boxed(m)))),
            inner.prop_map(|m| node(Node::Inverse(boxed(m)))),
        ]
    })
    .boxed()
}

/// Formulas of everything: a number, a vector or a matrix.
pub fn closed() -> impl Strategy<Value = Expr> {
    let small = prop_oneof![2 => number(), 4 => letter(), 3 => contracted()].boxed();
    let vector = vectors(small.clone());
    let of_vectors = prop_oneof![
        (vector.clone(), vector.clone()).prop_map(|(v, w)| node(Node::Dot(boxed(v), boxed(w)))),
        vector.clone().prop_map(|v| node(Node::Norm(boxed(v)))),
        (vector.clone(), fixed()).prop_map(|(v, i)| node(Node::Component(boxed(v), i))),
        (matrices(small.clone()), fixed(), fixed()).prop_map(|(m, i, j)| node(Node::Entry(boxed(m), i, j))),
    ];
    let of_vectors = (of_vectors, 0..4u8).prop_map(|(x, way)| if way < 2 { of_continuum(x, way == 0) } else { x });
    let scalar = scalars(prop_oneof![3 => small.clone(), 1 => of_vectors].boxed());
    prop_oneof![scalar, vector, matrices(small)]
}
