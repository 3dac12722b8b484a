//! Tracing: a function that runs over [`Symbol`]s records its operations as an expression graph.
//!
//! The graph is *hash-consed*: equal expressions are one node. While it grows, constants are folded and the identities
//! that hold without assumptions are used (x·0, x·1, x+0, x−x, −(−x), order of commuting operands). A quotient is
//! written as a product with a reciprocal, so that differentiating it costs no quotient rule.
//!
//! A graph has no values, so code that branches on a value cannot be traced. [`Graph::record`] returns an error then.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::fmt;

use num_dual::DualNum;

use super::arithmetic::{dual_number, power_by_squaring};
use super::{Arithmetic, Function};
use crate::{Error, Result};

/// One operation of a [`Graph`]; operands are places of earlier nodes. Constants are kept as their bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A constant, as the bits of an `f64`.
    Constant(u64),
    /// The n-th input.
    Input(u32),
    /// Sum.
    Add(u32, u32),
    /// Difference.
    Sub(u32, u32),
    /// Product.
    Mul(u32, u32),
    /// Opposite.
    Neg(u32),
    /// Reciprocal.
    Recip(u32),
    /// Integer power (small ones are written out as products).
    Powi(u32, i32),
    /// Real power; the exponent as the bits of an `f64`.
    Powf(u32, u64),
    /// An elementary function.
    Apply(Function, u32),
    /// The angle of the point (second, first).
    Atan2(u32, u32),
}

impl Node {
    /// The nodes it is computed from.
    pub fn operands(self) -> impl Iterator<Item = u32> {
        let (a, b) = match self {
            Node::Constant(_) | Node::Input(_) => (None, None),
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Atan2(a, b) => (Some(a), Some(b)),
            Node::Neg(a) | Node::Recip(a) | Node::Powi(a, _) | Node::Powf(a, _) | Node::Apply(_, a) => (Some(a), None),
        };
        a.into_iter().chain(b)
    }
}

/// Everything that was computed during a recording, each expression once, operands before what uses them.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    places: HashMap<Node, u32>,
    fault: Option<&'static str>,
}

/// A node of the graph that is being recorded on this thread. `Copy`, and a full number.
///
/// Outside [`Graph::record`] symbols go to a scratch graph of the thread, of which nothing is ever read.
#[derive(Clone, Copy, Debug)]
pub struct Symbol(u32);

thread_local! {
    static RECORDING: RefCell<Graph> = RefCell::default();
}

impl Graph {
    /// Runs `f` over symbols, writing down what they go through.
    ///
    /// # Errors
    /// When `f` branched on the value of a symbol (a comparison, a sign, an absolute value).
    pub fn record<R>(f: impl FnOnce() -> R) -> Result<(Graph, R)> {
        /// Puts the interrupted recording back, also when `f` panics.
        struct Interrupted(Graph);
        impl Drop for Interrupted {
            fn drop(&mut self) {
                RECORDING.with_borrow_mut(|graph| std::mem::swap(graph, &mut self.0));
            }
        }
        let mut interrupted = Interrupted(RECORDING.take());
        let result = f();
        let graph = RECORDING.replace(std::mem::take(&mut interrupted.0));
        std::mem::forget(interrupted);
        match graph.fault {
            None => Ok((graph, result)),
            Some(fault) => Err(Error::new(format!("the function cannot be traced, because it {fault} a symbolic value")).help(
                "write it without branches on coordinates, velocities, parameters or time: no if, abs, min, max or signum",
            )),
        }
    }

    /// The nodes, operands first.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The place of a node, if it was recorded.
    pub fn find(&self, node: Node) -> Option<u32> {
        self.places.get(&node).copied()
    }

    fn value(&self, symbol: u32) -> Option<f64> {
        match self.nodes.get(symbol as usize) {
            Some(Node::Constant(bits)) => Some(f64::from_bits(*bits)),
            _ => None,
        }
    }

    fn negation(&self, symbol: u32) -> Option<u32> {
        match self.nodes.get(symbol as usize) {
            Some(Node::Neg(inner)) => Some(*inner),
            _ => None,
        }
    }

    fn place(&mut self, node: Node) -> u32 {
        let next = self.nodes.len() as u32;
        let place = *self.places.entry(node).or_insert(next);
        if place == next {
            self.nodes.push(node);
        }
        place
    }

    fn constant(&mut self, value: f64) -> u32 {
        // one zero: the sign of a zero means nothing in an identity
        self.place(Node::Constant(if value == 0.0 { 0 } else { value.to_bits() }))
    }

    fn negate(&mut self, a: u32) -> u32 {
        if let Some(x) = self.value(a) {
            return self.constant(-x);
        }
        match self.nodes.get(a as usize) {
            Some(&Node::Neg(inner)) => inner,
            Some(&Node::Sub(x, y)) => self.place(Node::Sub(y, x)),
            _ => self.place(Node::Neg(a)),
        }
    }

    fn add(&mut self, a: u32, b: u32) -> u32 {
        match (self.value(a), self.value(b), self.negation(a), self.negation(b)) {
            (Some(x), Some(y), ..) => self.constant(x + y),
            (Some(0.0), ..) => b,
            (_, Some(0.0), ..) => a,
            (.., Some(inner)) => self.subtract(a, inner),
            (_, _, Some(inner), _) => self.subtract(b, inner),
            _ if a == b => {
                let two = self.constant(2.0);
                self.multiply(two, a)
            }
            _ => self.place(Node::Add(a.min(b), a.max(b))),
        }
    }

    fn subtract(&mut self, a: u32, b: u32) -> u32 {
        match (self.value(a), self.value(b), self.negation(a), self.negation(b)) {
            _ if a == b => self.constant(0.0),
            (Some(x), Some(y), ..) => self.constant(x - y),
            (Some(0.0), ..) => self.negate(b),
            (_, Some(0.0), ..) => a,
            (.., Some(inner)) => self.add(a, inner),
            (_, _, Some(inner), _) => {
                let sum = self.add(inner, b);
                self.negate(sum)
            }
            _ => self.place(Node::Sub(a, b)),
        }
    }

    fn multiply(&mut self, a: u32, b: u32) -> u32 {
        match (self.value(a), self.value(b), self.negation(a), self.negation(b)) {
            (Some(x), Some(y), ..) => self.constant(x * y),
            (Some(_), None, ..) => self.multiply(b, a),
            (_, Some(0.0), ..) => self.constant(0.0),
            (_, Some(1.0), ..) => a,
            (_, Some(-1.0), ..) => self.negate(a),
            (_, Some(y), Some(inner), _) => {
                let opposite = self.constant(-y);
                self.multiply(inner, opposite)
            }
            (_, Some(y), ..) => match self.nodes.get(a as usize) {
                Some(&Node::Mul(x, inner)) if self.value(x).is_some() => {
                    let factor = self.constant(self.value(x).unwrap_or(1.0) * y);
                    self.multiply(inner, factor)
                }
                _ => self.place(Node::Mul(b, a)),
            },
            (_, _, Some(inner), _) => {
                let product = self.multiply(inner, b);
                self.negate(product)
            }
            (.., Some(inner)) => {
                let product = self.multiply(a, inner);
                self.negate(product)
            }
            _ if self.nodes.get(a as usize) == Some(&Node::Recip(b)) => self.constant(1.0),
            _ if self.nodes.get(b as usize) == Some(&Node::Recip(a)) => self.constant(1.0),
            _ => self.place(Node::Mul(a.min(b), a.max(b))),
        }
    }

    fn reciprocal(&mut self, a: u32) -> u32 {
        if let Some(x) = self.value(a) {
            let folded = 1.0 / x;
            // a third is not a number of the machine: left as it is, x/3 stays x/3
            if x.abs() == 1.0 || (x.to_bits() << 12 == 0 && folded.is_normal()) {
                return self.constant(folded);
            }
            return self.place(Node::Recip(a));
        }
        match self.nodes.get(a as usize) {
            Some(&Node::Recip(inner)) => inner,
            Some(&Node::Neg(inner)) => {
                let recip = self.reciprocal(inner);
                self.negate(recip)
            }
            _ => self.place(Node::Recip(a)),
        }
    }

    fn apply(&mut self, function: Function, a: u32) -> u32 {
        if let Some(x) = self.value(a) {
            return self.constant(function.of(x));
        }
        match (function, self.negation(a)) {
            (Function::Cos | Function::Cosh, Some(inner)) => self.apply(function, inner),
            (Function::Sin | Function::Sinh | Function::Tan | Function::Tanh, Some(inner)) => {
                let value = self.apply(function, inner);
                self.negate(value)
            }
            _ => self.place(Node::Apply(function, a)),
        }
    }

    fn branched(&mut self, how: &'static str) {
        self.fault.get_or_insert(how);
    }
}

impl Symbol {
    /// The n-th input of the function that is being recorded.
    pub fn input(n: usize) -> Self {
        Symbol(RECORDING.with_borrow_mut(|graph| graph.place(Node::Input(n as u32))))
    }

    /// The symbol's value if it is a constant.
    pub fn as_constant(self) -> Option<f64> {
        RECORDING.with_borrow(|graph| graph.value(self.0))
    }

    /// Its place in the recorded graph.
    pub fn place(self) -> u32 {
        self.0
    }

    /// What the symbol is computed from.
    pub(crate) fn node(self) -> Node {
        RECORDING.with_borrow(|graph| graph.nodes.get(self.0 as usize).copied()).unwrap_or(Node::Constant(0))
    }

    pub(crate) fn at(place: u32) -> Self {
        Symbol(place)
    }

    fn build(f: impl FnOnce(&mut Graph) -> u32) -> Self {
        Symbol(RECORDING.with_borrow_mut(f))
    }
}

impl Arithmetic for Symbol {
    type Inner = f64;

    fn constant(value: f64) -> Self {
        Symbol::build(|graph| graph.constant(value))
    }
    fn uncertain(_error: f64) -> Option<Self> {
        None
    }
    fn real(self) -> f64 {
        RECORDING.with_borrow_mut(|graph| {
            graph.value(self.0).unwrap_or_else(|| {
                graph.branched("asks for the real value of");
                f64::NAN
            })
        })
    }
    fn known_value(self) -> Option<f64> {
        self.as_constant()
    }
    fn plus(self, other: Self) -> Self {
        Symbol::build(|graph| graph.add(self.0, other.0))
    }
    fn minus(self, other: Self) -> Self {
        Symbol::build(|graph| graph.subtract(self.0, other.0))
    }
    fn times(self, other: Self) -> Self {
        Symbol::build(|graph| graph.multiply(self.0, other.0))
    }
    fn over(self, other: Self) -> Self {
        Symbol::build(|graph| {
            let reciprocal = graph.reciprocal(other.0);
            graph.multiply(self.0, reciprocal)
        })
    }
    fn negated(self) -> Self {
        Symbol::build(|graph| graph.negate(self.0))
    }
    fn power(self, n: i32) -> Self {
        match (self.as_constant(), n) {
            (Some(x), _) => Symbol::constant(x.powi(n)),
            (None, -16..=16) => power_by_squaring(self, n),
            (None, _) => Symbol::build(|graph| graph.place(Node::Powi(self.0, n))),
        }
    }
    fn real_power(self, n: f64) -> Self {
        match self.as_constant() {
            Some(x) => Symbol::constant(x.powf(n)),
            None if n.fract() == 0.0 && n.abs() <= 16.0 => self.power(n as i32),
            None if n == 0.5 => self.sqrt(),
            None => Symbol::build(|graph| graph.place(Node::Powf(self.0, n.to_bits()))),
        }
    }
    fn apply(self, function: Function) -> Self {
        Symbol::build(|graph| graph.apply(function, self.0))
    }
    fn angle_from(self, x: Self) -> Self {
        Symbol::build(|graph| match (graph.value(self.0), graph.value(x.0)) {
            (Some(y), Some(x)) => graph.constant(y.atan2(x)),
            _ => graph.place(Node::Atan2(self.0, x.0)),
        })
    }
    fn order(self, other: Self) -> Option<Ordering> {
        RECORDING.with_borrow_mut(|graph| match (graph.value(self.0), graph.value(other.0)) {
            (Some(a), Some(b)) => a.partial_cmp(&b),
            _ if self.0 == other.0 => Some(Ordering::Equal),
            _ => {
                graph.branched("compares");
                None
            }
        })
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.as_constant() {
            Some(value) => write!(f, "{value}"),
            None => write!(f, "#{}", self.0),
        }
    }
}

dual_number!(Symbol);

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::{DualStruct, HyperDual};
    use num_traits::Signed;

    #[test]
    fn identities_without_assumptions_fold() {
        let (_, ()) = Graph::record(|| {
            let (x, y) = (Symbol::input(0), Symbol::input(1));
            let constant = |s: Symbol| s.as_constant();
            assert_eq!(constant(x * 0.0), Some(0.0));
            assert_eq!(constant(x - x), Some(0.0));
            assert_eq!((x * 1.0).place(), x.place());
            assert_eq!((x + 0.0).place(), x.place());
            assert_eq!((-(-x)).place(), x.place());
            assert_eq!((x * y).place(), (y * x).place());
            assert_eq!((x + y).place(), (y + x).place());
            assert_eq!(x.sin().place(), x.sin().place());
            assert_eq!(((-x) * y).place(), (-(x * y)).place());
            // must-fail cases: nothing else is taken for equal
            assert_ne!((x - y).place(), (y - x).place());
            assert_ne!((x / y).place(), (y / x).place());
            assert_eq!(constant(x * y), None);
        })
        .unwrap();
    }

    #[test]
    fn a_branch_is_a_clear_error() {
        for fault in [
            Graph::record(|| Symbol::input(0).abs()).err(),
            Graph::record(|| Symbol::input(0) > Symbol::input(1)).err(),
            Graph::record(|| Symbol::input(0).re()).err(),
            Graph::record(|| HyperDual::from_re(Symbol::input(0)).is_positive()).err(),
        ] {
            assert!(fault.unwrap().message().contains("cannot be traced"));
        }
        // must-fail case: a branch on a constant is none
        assert!(Graph::record(|| Symbol::from(2.0).abs()).is_ok());
    }

    #[test]
    fn hyper_dual_numbers_run_over_symbols() {
        let (graph, mixed) = Graph::record(|| {
            let x = HyperDual::from_re(Symbol::input(0)).derivative1().derivative2();
            [x.powi(3).eps1eps2, x.powf(1.5).eps1eps2, (x.sin() / x).eps1eps2, x.sqrt().eps1eps2].map(Symbol::place)
        })
        .unwrap();
        assert!(mixed.iter().all(|&place| (place as usize) < graph.nodes().len()));
    }
}
