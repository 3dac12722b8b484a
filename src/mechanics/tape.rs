//! A straight-line program: what a traced function computes, without what its outputs do not need.
//!
//! A tape runs over any number, one state at a time ([`Tape::evaluate`]), and over `f64` in blocks of states
//! ([`Tape::evaluate_block`]): one operation for [`LANES`] states, then the next, in plain loops over fixed arrays
//! that the compiler turns into vector instructions.

use num_dual::DualNum;

use crate::scalar::{Function, Graph, Node, Number, Symbol};

/// How many states a block holds: enough to hide the cost of reading the program, few enough to stay in the cache.
pub const LANES: usize = 32;

/// One value for each state of a block.
pub type Block = [f64; LANES];

/// One operation; operands are earlier registers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // each is the operation it is named after
pub enum Op {
    Constant(f64),
    Add(u32, u32),
    Sub(u32, u32),
    Mul(u32, u32),
    /// A register times a constant.
    Scale(u32, f64),
    /// A register plus a constant.
    Offset(u32, f64),
    Neg(u32),
    Recip(u32),
    Powi(u32, i32),
    Powf(u32, f64),
    Apply(Function, u32),
    /// Sine into this register, cosine into the next.
    SinCos(u32),
    /// The second half of [`Op::SinCos`].
    CosOfSinCos,
    Atan2(u32, u32),
}

/// A straight-line program from `inputs` numbers to some outputs. Register `i < inputs` is the i-th input; every
/// operation writes the next register.
#[derive(Clone, Debug)]
pub struct Tape {
    inputs: usize,
    ops: Vec<Op>,
    outputs: Vec<u32>,
}

impl Tape {
    /// The program that computes `outputs` in `graph`; what they do not need is left out.
    pub fn new(graph: &Graph, inputs: usize, outputs: &[Symbol]) -> Self {
        let nodes = graph.nodes();
        let mut live = vec![false; nodes.len()];
        for output in outputs {
            live[output.place() as usize] = true;
        }
        // operands stand before what uses them: one sweep down marks what is needed, one sweep up writes it
        for place in (0..nodes.len()).rev() {
            if live[place] {
                nodes[place].operands().for_each(|operand| live[operand as usize] = true);
            }
        }
        let mut writer = Writer { graph, live: &live, inputs, ops: Vec::new(), register: vec![None; nodes.len()] };
        for place in (0..nodes.len()).filter(|&place| live[place]) {
            writer.write(place as u32);
        }
        let outputs = outputs.iter().map(|output| writer.of(output.place())).collect();
        Tape { inputs, ops: writer.ops, outputs }
    }

    /// The operations in order; the first writes register number `inputs`.
    pub fn ops(&self) -> &[Op] {
        &self.ops
    }

    /// How many outputs it has.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Whether any output depends on an input.
    pub fn reads(&self, input: usize) -> bool {
        let reads = |operand: u32| operand as usize == input;
        self.outputs.iter().any(|&output| reads(output))
            || self.ops.iter().any(|op| match *op {
                Op::Constant(_) | Op::CosOfSinCos => false,
                Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Atan2(a, b) => reads(a) || reads(b),
                Op::Scale(a, _) | Op::Offset(a, _) | Op::Neg(a) | Op::Recip(a) | Op::Powi(a, _) => reads(a),
                Op::Powf(a, _) | Op::Apply(_, a) | Op::SinCos(a) => reads(a),
            })
    }

    /// The outputs for `inputs`, over any number. An input that is not given counts as NaN.
    pub fn evaluate<D: Number>(&self, inputs: &[D]) -> Vec<D> {
        let mut x: Vec<D> = Vec::with_capacity(self.inputs + self.ops.len());
        x.extend(inputs.iter().take(self.inputs));
        x.resize(self.inputs, D::from(f64::NAN));
        for op in &self.ops {
            let value = match *op {
                Op::Constant(c) => D::from(c),
                Op::Add(a, b) => x[a as usize] + x[b as usize],
                Op::Sub(a, b) => x[a as usize] - x[b as usize],
                Op::Mul(a, b) => x[a as usize] * x[b as usize],
                Op::Scale(a, c) => x[a as usize] * c,
                Op::Offset(a, c) => x[a as usize] + c,
                Op::Neg(a) => -x[a as usize],
                Op::Recip(a) => x[a as usize].recip(),
                Op::Powi(a, n) => x[a as usize].powi(n),
                Op::Powf(a, n) => x[a as usize].powf(n),
                Op::Apply(function, a) => function.of(x[a as usize]),
                Op::SinCos(a) => {
                    let (sine, cosine) = x[a as usize].sin_cos();
                    x.push(sine);
                    cosine
                }
                Op::CosOfSinCos => continue,
                Op::Atan2(a, b) => x[a as usize].atan2(x[b as usize]),
            };
            x.push(value);
        }
        self.outputs.iter().map(|&output| x[output as usize]).collect()
    }

    /// Registers for [`evaluate_block`](Tape::evaluate_block); the inputs come first.
    pub fn registers(&self) -> Vec<Block> {
        vec![[0.0; LANES]; self.inputs + self.ops.len()]
    }

    /// Runs the program for a block of states, whose inputs stand in the first of `registers`.
    pub fn evaluate_block(&self, registers: &mut [Block]) {
        for (op, to) in self.ops.iter().zip(self.inputs..) {
            let (x, rest) = registers.split_at_mut(to);
            let Some((out, rest)) = rest.split_first_mut() else { return };
            match *op {
                Op::Constant(c) => *out = [c; LANES],
                Op::Add(a, b) => two(&x[a as usize], &x[b as usize], out, |a, b| a + b),
                Op::Sub(a, b) => two(&x[a as usize], &x[b as usize], out, |a, b| a - b),
                Op::Mul(a, b) => two(&x[a as usize], &x[b as usize], out, |a, b| a * b),
                Op::Scale(a, c) => one(&x[a as usize], out, |a| a * c),
                Op::Offset(a, c) => one(&x[a as usize], out, |a| a + c),
                Op::Neg(a) => one(&x[a as usize], out, |a| -a),
                Op::Recip(a) => one(&x[a as usize], out, |a| 1.0 / a),
                Op::Powi(a, n) => one(&x[a as usize], out, |a| a.powi(n)),
                Op::Powf(a, n) => one(&x[a as usize], out, |a| a.powf(n)),
                Op::Apply(function, a) => one(&x[a as usize], out, |a| function.of(a)),
                Op::SinCos(a) => {
                    let Some(cosines) = rest.first_mut() else { return };
                    for ((sine, cosine), a) in out.iter_mut().zip(cosines).zip(&x[a as usize]) {
                        (*sine, *cosine) = a.sin_cos();
                    }
                }
                Op::CosOfSinCos => {}
                Op::Atan2(a, b) => two(&x[a as usize], &x[b as usize], out, f64::atan2),
            }
        }
    }

    /// The register that holds the n-th output.
    pub fn output_register(&self, n: usize) -> usize {
        self.outputs[n] as usize
    }
}

#[inline(always)]
fn one(a: &Block, out: &mut Block, f: impl Fn(f64) -> f64) {
    for lane in 0..LANES {
        out[lane] = f(a[lane]);
    }
}

#[inline(always)]
fn two(a: &Block, b: &Block, out: &mut Block, f: impl Fn(f64, f64) -> f64) {
    for lane in 0..LANES {
        out[lane] = f(a[lane], b[lane]);
    }
}

/// Writes nodes as operations, operands first.
struct Writer<'a> {
    graph: &'a Graph,
    live: &'a [bool],
    inputs: usize,
    ops: Vec<Op>,
    register: Vec<Option<u32>>,
}

impl Writer<'_> {
    /// The register of a node that has been written.
    fn of(&mut self, place: u32) -> u32 {
        match self.register[place as usize] {
            Some(register) => register,
            // constants are written when an operation needs one that cannot hold it itself
            None => {
                let Node::Constant(bits) = self.graph.nodes()[place as usize] else { return 0 };
                let register = self.push(Op::Constant(f64::from_bits(bits)));
                self.register[place as usize] = Some(register);
                register
            }
        }
    }

    fn push(&mut self, op: Op) -> u32 {
        self.ops.push(op);
        (self.inputs + self.ops.len() - 1) as u32
    }

    fn constant(&self, place: u32) -> Option<f64> {
        match self.graph.nodes()[place as usize] {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    fn write(&mut self, place: u32) {
        if self.register[place as usize].is_some() {
            return; // the other half of a sine and cosine
        }
        let op = match self.graph.nodes()[place as usize] {
            Node::Constant(_) => return,
            Node::Input(n) => {
                self.register[place as usize] = Some(n);
                return;
            }
            Node::Add(a, b) => match (self.constant(a), self.constant(b)) {
                (Some(c), _) => Op::Offset(self.of(b), c),
                (_, Some(c)) => Op::Offset(self.of(a), c),
                _ => Op::Add(self.of(a), self.of(b)),
            },
            Node::Sub(a, b) => match self.constant(b) {
                Some(c) => Op::Offset(self.of(a), -c),
                None => Op::Sub(self.of(a), self.of(b)),
            },
            Node::Mul(a, b) => match (self.constant(a), self.constant(b)) {
                (Some(c), _) => Op::Scale(self.of(b), c),
                (_, Some(c)) => Op::Scale(self.of(a), c),
                _ => Op::Mul(self.of(a), self.of(b)),
            },
            Node::Neg(a) => Op::Neg(self.of(a)),
            Node::Recip(a) => Op::Recip(self.of(a)),
            Node::Powi(a, n) => Op::Powi(self.of(a), n),
            Node::Powf(a, n) => Op::Powf(self.of(a), f64::from_bits(n)),
            Node::Atan2(a, b) => Op::Atan2(self.of(a), self.of(b)),
            Node::Apply(function @ (Function::Sin | Function::Cos), a) => match self.partner(function, a) {
                Some(partner) => {
                    let angle = self.of(a);
                    let sine = self.push(Op::SinCos(angle));
                    let cosine = self.push(Op::CosOfSinCos);
                    let (own, other) = if function == Function::Sin { (sine, cosine) } else { (cosine, sine) };
                    self.register[place as usize] = Some(own);
                    self.register[partner] = Some(other);
                    return;
                }
                None => Op::Apply(function, self.of(a)),
            },
            Node::Apply(function, a) => Op::Apply(function, self.of(a)),
        };
        self.register[place as usize] = Some(self.push(op));
    }

    /// The live cosine that goes with a sine, or the sine that goes with a cosine.
    fn partner(&self, function: Function, angle: u32) -> Option<usize> {
        let other = if function == Function::Sin { Function::Cos } else { Function::Sin };
        let place = self.graph.find(Node::Apply(other, angle))? as usize;
        self.live[place].then_some(place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual64;

    fn tape() -> Tape {
        let (graph, outputs) = Graph::record(|| {
            let (x, y) = (Symbol::input(0), Symbol::input(1));
            let _unused = x.exp() * y.ln();
            [x.sin() * y + 2.0, x.cos() / y, (-x).powi(20) - y.powf(0.3), Symbol::from(3.0), x.atan2(y), y]
        })
        .unwrap();
        Tape::new(&graph, 2, &outputs)
    }

    #[test]
    fn a_tape_computes_what_was_traced_and_nothing_else() {
        let (x, y) = (0.7_f64, 1.3_f64);
        let expected = [x.sin() * y + 2.0, x.cos() / y, x.powi(20) - y.powf(0.3), 3.0, x.atan2(y), y];
        let values = tape().evaluate(&[x, y]);
        for (value, expected) in values.iter().zip(expected) {
            approx::assert_relative_eq!(*value, expected, max_relative = 1e-14);
        }
        let unused = |op: &Op| matches!(op, Op::Apply(Function::Exp | Function::Ln, _));
        assert!(!tape().ops().iter().any(unused));
        assert_eq!(tape().ops().iter().filter(|op| matches!(op, Op::SinCos(_))).count(), 1);
    }

    #[test]
    fn a_tape_runs_over_dual_numbers_and_in_blocks() {
        let tape = tape();
        let slope = tape.evaluate(&[Dual64::new(0.7, 1.0), Dual64::from(1.3)])[0].eps;
        approx::assert_relative_eq!(slope, 0.7_f64.cos() * 1.3, max_relative = 1e-14);
        let mut registers = tape.registers();
        registers[0] = std::array::from_fn(|lane| 0.1 * lane as f64);
        registers[1] = std::array::from_fn(|lane| 1.0 + lane as f64);
        tape.evaluate_block(&mut registers);
        for (lane, (&x, &y)) in registers[0].iter().zip(&registers[1]).enumerate() {
            for (n, value) in tape.evaluate(&[x, y]).into_iter().enumerate() {
                assert_eq!(registers[tape.output_register(n)][lane], value);
            }
        }
    }

    #[test]
    fn it_knows_what_it_reads() {
        let (graph, sum) = Graph::record(|| Symbol::input(0) + Symbol::input(2)).unwrap();
        let tape = Tape::new(&graph, 3, &[sum]);
        assert_eq!([0, 1, 2].map(|input| tape.reads(input)), [true, false, true]);
    }
}
