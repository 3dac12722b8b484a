//! A straight-line program: the operations of a traced function that its outputs need, in order.
//!
//! A tape runs over any kind of number ([`Tape::evaluate`]). Its constants are those of the traced function, with no
//! further rounding. Optimisations for `f64` change a copy only, the [`program`].
//!
//! Offers [`Tape`] and its operations. Knows numbers and the graphs of `scalar`.

use crate::scalar::{Function, Graph, Number, Symbol, each};

pub(super) mod blocks;
pub(super) mod program;
pub(super) mod reverse_mode;
mod sincos;
pub(super) mod single;
mod writer;

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

impl Op {
    /// The registers that the operation reads.
    pub fn operands(self) -> impl Iterator<Item = u32> {
        let (a, b) = match self {
            Op::Constant(_) | Op::CosOfSinCos => (None, None),
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Atan2(a, b) => (Some(a), Some(b)),
            Op::Scale(a, _) | Op::Offset(a, _) | Op::Neg(a) | Op::Recip(a) | Op::Powi(a, _) => (Some(a), None),
            Op::Powf(a, _) | Op::Apply(_, a) | Op::SinCos(a) => (Some(a), None),
        };
        a.into_iter().chain(b)
    }

    /// The same operation on other registers.
    pub fn with_operands(self, place: impl Fn(u32) -> u32) -> Op {
        match self {
            Op::Constant(_) | Op::CosOfSinCos => self,
            Op::Add(a, b) => Op::Add(place(a), place(b)),
            Op::Sub(a, b) => Op::Sub(place(a), place(b)),
            Op::Mul(a, b) => Op::Mul(place(a), place(b)),
            Op::Atan2(a, b) => Op::Atan2(place(a), place(b)),
            Op::Scale(a, c) => Op::Scale(place(a), c),
            Op::Offset(a, c) => Op::Offset(place(a), c),
            Op::Neg(a) => Op::Neg(place(a)),
            Op::Recip(a) => Op::Recip(place(a)),
            Op::Powi(a, n) => Op::Powi(place(a), n),
            Op::Powf(a, n) => Op::Powf(place(a), n),
            Op::Apply(function, a) => Op::Apply(function, place(a)),
            Op::SinCos(a) => Op::SinCos(place(a)),
        }
    }
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
    /// The program that computes `outputs` in `graph`, without operations that they do not need.
    pub fn new(graph: &Graph, inputs: usize, outputs: &[Symbol]) -> Self {
        let (ops, outputs) = writer::write(graph, inputs, outputs);
        Tape { inputs, ops, outputs }
    }

    /// The operations in order; the first writes register number `inputs`.
    pub fn ops(&self) -> &[Op] {
        &self.ops
    }

    /// The number of outputs.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// The register of each output.
    pub fn output_registers(&self) -> &[u32] {
        &self.outputs
    }

    /// Whether any output depends on an input.
    pub fn reads(&self, input: usize) -> bool {
        let reads = |operand: u32| operand as usize == input;
        self.outputs.iter().any(|&output| reads(output)) || self.ops.iter().any(|op| op.operands().any(reads))
    }

    /// The same program for its first outputs alone.
    pub fn truncated(&self, outputs: usize) -> Tape {
        let outputs = &self.outputs[..outputs.min(self.outputs.len())];
        let mut live = vec![false; self.inputs + self.ops.len()];
        outputs.iter().for_each(|&output| live[output as usize] = true);
        for (op, to) in self.ops.iter().zip(self.inputs..live.len()).rev() {
            if matches!(op, Op::SinCos(_)) {
                // one operation with two results
                live[to] |= live[to + 1];
                live[to + 1] = live[to];
            }
            if live[to] {
                op.operands().for_each(|operand| live[operand as usize] = true);
            }
        }
        let mut place: Vec<u32> = (0..live.len() as u32).collect();
        let mut ops = Vec::new();
        for (&op, from) in self.ops.iter().zip(self.inputs..).filter(|&(_, from)| live[from]) {
            place[from] = (self.inputs + ops.len()) as u32;
            ops.push(op.with_operands(|operand| place[operand as usize]));
        }
        let outputs = outputs.iter().map(|&output| place[output as usize]).collect();
        Tape { inputs: self.inputs, ops, outputs }
    }

    /// The outputs for `inputs`, over any number. An input that is not given counts as NaN.
    pub fn evaluate<D: Number>(&self, inputs: &[D]) -> Vec<D> {
        let x = self.registers(inputs);
        each(&self.outputs, &|&output| x[output as usize])
    }

    /// All registers for `inputs`: the inputs, then the result of each operation.
    pub fn registers<D: Number>(&self, inputs: &[D]) -> Vec<D> {
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
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::{Dual64, DualNum};

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
    fn a_tape_runs_over_dual_numbers() {
        let tape = tape();
        let slope = tape.evaluate(&[Dual64::new(0.7, 1.0), Dual64::from(1.3)])[0].eps;
        approx::assert_relative_eq!(slope, 0.7_f64.cos() * 1.3, max_relative = 1e-14);
    }

    #[test]
    fn it_knows_what_it_reads() {
        let (graph, sum) = Graph::record(|| Symbol::input(0) + Symbol::input(2)).unwrap();
        let tape = Tape::new(&graph, 3, &[sum]);
        assert_eq!([0, 1, 2].map(|input| tape.reads(input)), [true, false, true]);
    }
}
