//! A tape optimised for `f64`.
//!
//! *Uniform* values depend only on inputs that are the same for all states, and are computed once. The other operations
//! become *steps*. A step may fuse a product with the sum that uses it, or two products, or a reciprocal with the product
//! that uses it. A register is reused when its value is no longer needed, so that the registers of many states fit into
//! the cache. Results differ from those of the tape by rounding.
//!
//! # Why there is a program beside the tape
//!
//! A tape runs over any kind of number. For many states over `f64` speed matters: terms that depend on parameters only
//! are computed once, products and sums are fused, and registers are reused, so that 256 states stay in the cache. A
//! `Program` is made from the tape when it is first needed. `fearless_simd` detects the vector instructions at run time
//! and contains the unsafe code. The mass matrix is inverted with diagonal pivots, uniform pivots first, and the rest is
//! simplified after each of them: the top takes 11 steps, and elimination row by row took 26. A pivot is compared with
//! its diagonal entry, because a small difference of two large numbers has lost digits. A pivot that is a product, such
//! as λ₁ sin²θ, loses no digits, and only must not vanish.

use std::collections::HashMap;

use super::{Op, Tape};
use crate::scalar::Function;

/// The operation of a step. Operands are places, counted through inputs, temporary registers, uniform values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Action<P = u32> {
    /// a + b
    Add(P, P),
    /// a − b
    Sub(P, P),
    /// a b
    Mul(P, P),
    /// a b c; a varies
    Product(P, P, P),
    /// a / b
    Div(P, P),
    /// a b + c; a varies
    MulAdd(P, P, P),
    /// a b − c; a varies
    MulSub(P, P, P),
    /// c − a b; a varies
    SubMul(P, P, P),
    /// −a b − c; a varies
    NegMulSub(P, P, P),
    /// a b c + d; a varies
    ProductAdd(P, P, P, P),
    /// a b c − d; a varies
    ProductSub(P, P, P, P),
    /// d − a b c; a varies
    SubProduct(P, P, P, P),
    Neg(P),
    Powi(P, i32),
    Powf(P, P),
    Apply(Function, P),
    /// Sine of the first to the step's register, cosine to the second.
    SinCos(P, P),
    Atan2(P, P),
}

impl<P: Copy> Action<P> {
    /// The same operation with other places for the operands and for the cosine.
    pub fn map<Q>(self, place: impl Fn(P) -> Q) -> Action<Q> {
        match self {
            Action::Add(a, b) => Action::Add(place(a), place(b)),
            Action::Sub(a, b) => Action::Sub(place(a), place(b)),
            Action::Mul(a, b) => Action::Mul(place(a), place(b)),
            Action::Product(a, b, c) => Action::Product(place(a), place(b), place(c)),
            Action::Div(a, b) => Action::Div(place(a), place(b)),
            Action::MulAdd(a, b, c) => Action::MulAdd(place(a), place(b), place(c)),
            Action::MulSub(a, b, c) => Action::MulSub(place(a), place(b), place(c)),
            Action::SubMul(a, b, c) => Action::SubMul(place(a), place(b), place(c)),
            Action::NegMulSub(a, b, c) => Action::NegMulSub(place(a), place(b), place(c)),
            Action::ProductAdd(a, b, c, d) => Action::ProductAdd(place(a), place(b), place(c), place(d)),
            Action::ProductSub(a, b, c, d) => Action::ProductSub(place(a), place(b), place(c), place(d)),
            Action::SubProduct(a, b, c, d) => Action::SubProduct(place(a), place(b), place(c), place(d)),
            Action::Neg(a) => Action::Neg(place(a)),
            Action::Powi(a, n) => Action::Powi(place(a), n),
            Action::Powf(a, n) => Action::Powf(place(a), place(n)),
            Action::Apply(function, a) => Action::Apply(function, place(a)),
            Action::SinCos(a, cosine) => Action::SinCos(place(a), place(cosine)),
            Action::Atan2(a, b) => Action::Atan2(place(a), place(b)),
        }
    }

    fn operands(self) -> impl Iterator<Item = P> {
        let (a, others) = match self {
            Action::Add(a, b)
            | Action::Sub(a, b)
            | Action::Mul(a, b)
            | Action::Div(a, b)
            | Action::Powf(a, b)
            | Action::Atan2(a, b) => (a, [Some(b), None, None]),
            Action::Product(a, b, c)
            | Action::MulAdd(a, b, c)
            | Action::MulSub(a, b, c)
            | Action::SubMul(a, b, c)
            | Action::NegMulSub(a, b, c) => (a, [Some(b), Some(c), None]),
            Action::ProductAdd(a, b, c, d) | Action::ProductSub(a, b, c, d) | Action::SubProduct(a, b, c, d) => {
                (a, [Some(b), Some(c), Some(d)])
            }
            Action::Neg(a) | Action::Powi(a, _) | Action::Apply(_, a) | Action::SinCos(a, _) => (a, [None; 3]),
        };
        std::iter::once(a).chain(others.into_iter().flatten())
    }
}

/// One step: its operation, and the register of its result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step<P = u32> {
    pub action: Action<P>,
    pub to: P,
}

/// A tape ready to run.
#[derive(Clone, Debug)]
pub struct Program {
    pub(super) inputs: usize,
    /// The number of temporary registers.
    pub(super) registers: usize,
    /// The tape that computes the uniform values from the inputs.
    uniform: Tape,
    pub(super) steps: Vec<Step>,
    /// The register of each output.
    pub(super) outputs: Vec<u32>,
}

impl Program {
    /// The program of a tape. `uniform(input)` says whether an input is the same for all states.
    pub fn new(tape: &Tape, uniform: impl Fn(usize) -> bool) -> Self {
        let mut writer = Writer::new(tape, uniform);
        for (&op, to) in tape.ops.iter().zip(tape.inputs as u32..) {
            if !writer.is_uniform[to as usize] {
                writer.write(op, to);
            }
        }
        writer.finish()
    }

    /// The uniform values. Inputs that are not uniform are ignored.
    pub fn uniform(&self, inputs: &[f64]) -> Vec<f64> {
        self.uniform.evaluate(inputs)
    }

    /// Whether the n-th output is the same for all states.
    pub fn is_uniform(&self, n: usize) -> bool {
        self.outputs[n] as usize >= self.inputs + self.registers
    }

    /// The number of steps for each state.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }
}

/// The place of the first uniform value while the number of temporary registers is still unknown.
const UNIFORM: u32 = 1 << 31;

struct Writer<'a> {
    tape: &'a Tape,
    is_uniform: Vec<bool>,
    /// For each register of the tape, the number of varying operations that read it.
    uses: Vec<u32>,
    /// The steps on the registers of the tape. Each register is written once.
    steps: Vec<Step>,
    /// The step that wrote a register.
    written: HashMap<u32, usize>,
    /// The operations of the tape of uniform values: those of the original tape, then added ones.
    uniform: Vec<Op>,
    /// The register in the tape of uniform values of each register of the tape.
    kept: HashMap<u32, u32>,
    constants: HashMap<u64, u32>,
    /// The uniform values that are used: registers of that tape.
    uniform_outputs: Vec<u32>,
}

impl<'a> Writer<'a> {
    fn new(tape: &'a Tape, uniform: impl Fn(usize) -> bool) -> Self {
        let mut is_uniform: Vec<bool> = (0..tape.inputs).map(uniform).collect();
        for (op, to) in tape.ops.iter().zip(tape.inputs..) {
            let same = match op {
                Op::CosOfSinCos => is_uniform[to - 1],
                op => op.operands().all(|operand| is_uniform[operand as usize]),
            };
            is_uniform.push(same);
        }
        let mut uses = vec![0; is_uniform.len()];
        let varying = tape.ops.iter().zip(tape.inputs..).filter(|&(_, to)| !is_uniform[to]);
        let read = varying.flat_map(|(op, _)| op.operands()).chain(tape.outputs.iter().copied());
        read.for_each(|register| uses[register as usize] += 1);
        let mut kept: HashMap<u32, u32> = (0..tape.inputs as u32).map(|input| (input, input)).collect();
        let mut ops = Vec::new();
        for (op, to) in tape.ops.iter().zip(tape.inputs..).filter(|&(_, to)| is_uniform[to]) {
            kept.insert(to as u32, (tape.inputs + ops.len()) as u32);
            ops.push(op.with_operands(|operand| kept[&operand]));
        }
        Writer {
            tape,
            is_uniform,
            uses,
            steps: Vec::new(),
            written: HashMap::new(),
            uniform: ops,
            kept,
            constants: HashMap::new(),
            uniform_outputs: Vec::new(),
        }
    }

    /// The operand for a register of the tape.
    fn place(&mut self, register: u32) -> u32 {
        if self.is_uniform[register as usize] { self.uniform_place(self.kept[&register]) } else { register }
    }

    /// The operand for a register of the tape of uniform values.
    fn uniform_place(&mut self, register: u32) -> u32 {
        let known = self.uniform_outputs.iter().position(|&output| output == register);
        let place = known.unwrap_or_else(|| {
            self.uniform_outputs.push(register);
            self.uniform_outputs.len() - 1
        });
        UNIFORM + place as u32
    }

    fn also(&mut self, op: Op) -> u32 {
        self.uniform.push(op);
        (self.tape.inputs + self.uniform.len() - 1) as u32
    }

    fn constant(&mut self, c: f64) -> u32 {
        let register = match self.constants.get(&c.to_bits()) {
            Some(&register) => register,
            None => {
                let register = self.also(Op::Constant(c));
                self.constants.insert(c.to_bits(), register);
                register
            }
        };
        self.uniform_place(register)
    }

    fn write(&mut self, op: Op, to: u32) {
        let action = match op {
            Op::Add(a, b) => self.sum(a, b),
            Op::Sub(a, b) => self.difference(a, b),
            Op::Mul(a, b) => self.product(a, b),
            Op::Scale(a, c) => Action::Mul(a, self.constant(c)),
            Op::Offset(a, c) => {
                let c = self.constant(c);
                match self.fused(a) {
                    Some((x, y)) => Action::MulAdd(x, y, c),
                    None => Action::Add(a, c),
                }
            }
            Op::Neg(a) => self.negation(a),
            Op::Recip(a) => Action::Div(self.constant(1.0), a),
            Op::Powi(a, n) => Action::Powi(a, n),
            Op::Powf(a, n) => Action::Powf(a, self.constant(n)),
            Op::Apply(function, a) => Action::Apply(function, a),
            Op::SinCos(a) => Action::SinCos(a, to + 1),
            Op::Atan2(a, b) => Action::Atan2(self.place(a), self.place(b)),
            Op::Constant(_) | Op::CosOfSinCos => return, // a constant is uniform; a cosine is written with its sine
        };
        self.written.insert(to, self.steps.len());
        self.steps.push(Step { action, to });
    }

    /// The last step that wrote a register, if no later step reads it.
    fn only_for_this(&self, register: u32) -> Option<Action> {
        let step = self.written.get(&register).filter(|_| self.uses[register as usize] == 1)?;
        Some(self.steps[*step].action)
    }

    /// The factors of a product that no other step reads, a varying factor first. Its own step becomes void.
    fn fused(&mut self, register: u32) -> Option<(u32, u32)> {
        let Action::Mul(a, b) = self.only_for_this(register)? else { return None };
        self.written.remove(&register);
        Some((a, b))
    }

    fn sum(&mut self, a: u32, b: u32) -> Action {
        if let Some((x, y)) = self.fused(b) {
            return Action::MulAdd(x, y, self.place(a));
        }
        if let Some((x, y)) = self.fused(a) {
            return Action::MulAdd(x, y, self.place(b));
        }
        let (a, b) = if self.is_uniform[a as usize] { (b, a) } else { (a, b) };
        Action::Add(a, self.place(b))
    }

    fn difference(&mut self, a: u32, b: u32) -> Action {
        if let Some((x, y)) = self.fused(b) {
            return Action::SubMul(x, y, self.place(a));
        }
        if let Some((x, y)) = self.fused(a) {
            return Action::MulSub(x, y, self.place(b));
        }
        Action::Sub(self.place(a), self.place(b))
    }

    /// Moves a sign into the step that computed the number, if no other step reads the number.
    fn negation(&mut self, a: u32) -> Action {
        let action = match self.only_for_this(a) {
            Some(Action::Sub(x, y)) => Action::Sub(y, x),
            Some(Action::MulAdd(x, y, c)) => Action::NegMulSub(x, y, c),
            Some(Action::MulSub(x, y, c)) => Action::SubMul(x, y, c),
            Some(Action::SubMul(x, y, c)) => Action::MulSub(x, y, c),
            Some(Action::Mul(x, y)) if y >= UNIFORM => {
                let negated = self.also(Op::Neg(self.uniform_outputs[(y - UNIFORM) as usize]));
                Action::Mul(x, self.uniform_place(negated))
            }
            _ => return Action::Neg(a),
        };
        self.written.remove(&a);
        action
    }

    fn product(&mut self, a: u32, b: u32) -> Action {
        for (factor, reciprocal) in [(a, b), (b, a)] {
            if let Some(Action::Div(one, divisor)) = self.only_for_this(reciprocal)
                && self.is_one(one)
                && factor != reciprocal
            {
                self.written.remove(&reciprocal);
                return Action::Div(self.place(factor), divisor);
            }
        }
        let (a, b) = if self.is_uniform[a as usize] { (b, a) } else { (a, b) };
        Action::Mul(a, self.place(b))
    }

    fn is_one(&self, place: u32) -> bool {
        let register = place.checked_sub(UNIFORM).map(|place| self.uniform_outputs[place as usize]);
        register.is_some() && register == self.constants.get(&1_f64.to_bits()).copied()
    }

    /// Fuses a product with another product, or with a product and a sum, if nothing else reads it.
    fn join_products(&mut self) {
        for i in 0..self.steps.len() {
            let Step { action, to } = self.steps[i];
            let (Action::Mul(a, b) | Action::MulAdd(a, b, _) | Action::MulSub(a, b, _) | Action::SubMul(a, b, _)) =
                action
            else {
                continue;
            };
            if self.written.get(&to) != Some(&i) {
                continue;
            }
            let joined = self.fused(a).map(|product| (product, b)).or_else(|| Some((self.fused(b)?, a)));
            let Some(((x, y), z)) = joined else { continue };
            self.steps[i].action = match action {
                Action::MulAdd(.., c) => Action::ProductAdd(x, y, z, c),
                Action::MulSub(.., c) => Action::ProductSub(x, y, z, c),
                Action::SubMul(.., c) => Action::SubProduct(x, y, z, c),
                _ => Action::Product(x, y, z),
            };
        }
    }

    /// Removes void steps, and assigns a free register to each result.
    fn finish(mut self) -> Program {
        self.join_products();
        let outputs: Vec<u32> = self.tape.outputs.clone().into_iter().map(|output| self.place(output)).collect();
        let steps: Vec<Step> = (self.steps.iter().enumerate())
            .filter(|(i, step)| self.written.get(&step.to) == Some(i))
            .map(|(_, &step)| step)
            .collect();
        let inputs = self.tape.inputs as u32;
        let mut last_read: HashMap<u32, usize> = HashMap::new();
        for (i, step) in steps.iter().enumerate() {
            last_read.extend(step.action.operands().map(|operand| (operand, i)));
        }
        last_read.extend(outputs.iter().map(|&output| (output, usize::MAX)));
        let mut register: HashMap<u32, u32> = HashMap::new();
        let (mut free, mut count) = (Vec::new(), 0);
        let mut packed = Vec::with_capacity(steps.len());
        for (i, step) in steps.iter().enumerate() {
            let mut action = step.action.map(|place| register.get(&place).copied().unwrap_or(place));
            for operand in step.action.operands().filter(|operand| last_read[operand] == i) {
                free.extend(register.remove(&operand));
            }
            let mut give = |result: u32| {
                let given = free.pop().unwrap_or_else(|| {
                    count += 1;
                    inputs + count - 1
                });
                register.insert(result, given);
                given
            };
            let to = give(step.to);
            if let Action::SinCos(_, cosine) = &mut action {
                *cosine = give(*cosine);
            }
            packed.push(Step { action, to });
        }
        let last = inputs + count;
        let settle = |place: u32| if place >= UNIFORM { place - UNIFORM + last } else { place };
        for step in &mut packed {
            step.action = step.action.map(settle);
        }
        let outputs = outputs.iter().map(|output| settle(register.get(output).copied().unwrap_or(*output))).collect();
        let uniform = Tape { inputs: self.tape.inputs, ops: self.uniform, outputs: self.uniform_outputs };
        Program { inputs: inputs as usize, registers: count as usize, uniform, steps: packed, outputs }
    }
}
