//! From a graph to a tape: nodes become operations in the order in which they were recorded.
//!
//! Constants are held by the operation that needs them where it can, and a sine and a cosine of one angle become one
//! operation.

use super::Op;
use crate::scalar::{Function, Graph, Node, Symbol};

/// Writes nodes as operations, operands first.
struct Writer<'a> {
    graph: &'a Graph,
    live: Vec<bool>,
    inputs: usize,
    ops: Vec<Op>,
    register: Vec<Option<u32>>,
}

/// The operations that compute `outputs` in `graph`, without what they do not need, and the outputs' registers.
pub(super) fn write(graph: &Graph, inputs: usize, outputs: &[Symbol]) -> (Vec<Op>, Vec<u32>) {
    let nodes = graph.nodes();
    let mut live = vec![false; nodes.len()];
    for output in outputs {
        live[output.place() as usize] = true;
    }
    // operands precede their uses: one sweep down marks what is needed, one sweep up writes it
    for place in (0..nodes.len()).rev() {
        if live[place] {
            nodes[place].operands().for_each(|operand| live[operand as usize] = true);
        }
    }
    let mut writer = Writer { graph, live, inputs, ops: Vec::new(), register: vec![None; nodes.len()] };
    for place in 0..nodes.len() {
        if writer.live[place] {
            writer.write(place as u32);
        }
    }
    let outputs = outputs.iter().map(|output| writer.of(output.place())).collect();
    (writer.ops, outputs)
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
