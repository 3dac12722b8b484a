//! A program over a block of states: one step for all of them, then the next.
//!
//! The processor's widest vectors are detected at run time and used through `fearless_simd`, which contains the unsafe
//! code. A processor without them runs the same code on plain numbers. A step writes to a spare block and then swaps it
//! with its register, so a step may read and write one register.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, SimdMask, dispatch};

use super::program::{Action, Program};
use super::sincos::sin_cos_of_all;
use crate::scalar::Function;

/// How many states a block holds: enough to hide the cost of reading the program, few enough to stay in the cache.
pub const LANES: usize = 256;

/// One value for each state of a block.
pub type Block = [f64; LANES];

/// The memory of a running program: its registers, and a spare block.
pub struct Registers {
    level: Level,
    #[expect(clippy::vec_box, reason = "blocks are swapped by their pointers, not copied")]
    blocks: Vec<Box<Block>>,
    spare: Box<Block>,
    second_spare: Box<Block>,
}

impl Registers {
    /// Registers for `program`, to run with these vector instructions.
    pub fn new(program: &Program, level: Level) -> Self {
        let block = || Box::new([0.0; LANES]);
        let blocks = (0..program.registers).map(|_| block()).collect();
        Registers { level, blocks, spare: block(), second_spare: block() }
    }
}

/// The values of a place: one for each state of the block, or one for all states.
#[derive(Clone, Copy)]
pub enum Values<'a> {
    /// One for each state.
    Each(&'a Block),
    /// The same for all states.
    All(f64),
}

/// Everything that a step can read.
#[derive(Clone, Copy)]
struct Places<'a> {
    inputs: &'a [&'a Block],
    blocks: &'a [Box<Block>],
    uniform: &'a [f64],
}

impl<'a> Places<'a> {
    #[inline(always)]
    fn at(self, place: u32) -> Values<'a> {
        let place = place as usize;
        match place.checked_sub(self.inputs.len()) {
            None => Values::Each(self.inputs[place]),
            Some(register) => match register.checked_sub(self.blocks.len()) {
                None => Values::Each(&self.blocks[register]),
                Some(place) => Values::All(self.uniform[place]),
            },
        }
    }
}

impl Program {
    /// Runs for a block of states. `inputs` has a block for each input; uniform inputs are ignored. `uniform` is the
    /// result of [`Program::uniform`].
    pub fn run_block(&self, registers: &mut Registers, inputs: &[&Block], uniform: &[f64]) {
        dispatch!(registers.level, simd => run(simd, self, registers, inputs, uniform));
    }

    /// The n-th output of the last run, which had the same arguments.
    pub fn output_of_block<'a>(
        &self,
        n: usize,
        registers: &'a Registers,
        inputs: &'a [&'a Block],
        uniform: &'a [f64],
    ) -> Values<'a> {
        Places { inputs, blocks: &registers.blocks, uniform }.at(self.outputs[n])
    }
}

impl Values<'_> {
    /// Whether |a| > share·|b| for all states of a block. NaN fails the comparison.
    pub fn exceed(self, share: f64, other: Values, registers: &Registers) -> bool {
        dispatch!(registers.level, simd => exceed(simd, self, share, other))
    }
}

#[inline(always)]
fn exceed<S: Simd>(simd: S, a: Values, share: f64, b: Values) -> bool {
    let share = S::f64s::splat(simd, share);
    for vector in 0..LANES / S::f64s::LEN {
        let lane = vector * S::f64s::LEN;
        let (a, b) = (vector_of(simd, a, lane), vector_of(simd, b, lane));
        if !a.abs().simd_gt(b.abs() * share).all_true() {
            return false;
        }
    }
    true
}

/// The vector of the values from `lane` on.
#[inline(always)]
fn vector_of<S: Simd>(simd: S, values: Values, lane: usize) -> S::f64s {
    match values {
        Values::Each(block) => load(simd, block, lane),
        Values::All(value) => S::f64s::splat(simd, value),
    }
}

#[inline(always)]
fn run<S: Simd>(simd: S, program: &Program, registers: &mut Registers, inputs: &[&Block], uniform: &[f64]) {
    let Registers { blocks, spare, second_spare, .. } = registers;
    for step in &program.steps {
        let places = Places { inputs, blocks, uniform };
        let at = |place: u32| places.at(place);
        let out = &mut **spare;
        match step.action {
            Action::Add(a, b) => two(simd, at(a), at(b), out, |a, b| a + b),
            Action::Sub(a, b) => two(simd, at(a), at(b), out, |a, b| a - b),
            Action::Mul(a, b) => two(simd, at(a), at(b), out, |a, b| a * b),
            Action::Div(a, b) => two(simd, at(a), at(b), out, |a, b| a / b),
            Action::Product(a, b, c) => three(simd, [at(a), at(b), at(c)], out, |a, b, c| a * b * c),
            Action::MulAdd(a, b, c) => three(simd, [at(a), at(b), at(c)], out, |a, b, c| a.mul_add(b, c)),
            Action::MulSub(a, b, c) => three(simd, [at(a), at(b), at(c)], out, |a, b, c| a.mul_sub(b, c)),
            Action::SubMul(a, b, c) => three(simd, [at(a), at(b), at(c)], out, |a, b, c| (-a).mul_add(b, c)),
            Action::NegMulSub(a, b, c) => three(simd, [at(a), at(b), at(c)], out, |a, b, c| (-a).mul_sub(b, c)),
            Action::ProductAdd(a, b, c, d) => {
                four(simd, [at(a), at(b), at(c), at(d)], out, |a, b, c, d| (a * b).mul_add(c, d));
            }
            Action::ProductSub(a, b, c, d) => {
                four(simd, [at(a), at(b), at(c), at(d)], out, |a, b, c, d| (a * b).mul_sub(c, d));
            }
            Action::SubProduct(a, b, c, d) => {
                four(simd, [at(a), at(b), at(c), at(d)], out, |a, b, c, d| (-a * b).mul_add(c, d));
            }
            Action::Neg(a) => one(simd, at(a), out, |a| -a),
            Action::Apply(Function::Sqrt, a) => one(simd, at(a), out, |a| a.sqrt()),
            Action::Powi(a, n) => one_by_one(at(a), at(a), out, |a, _| a.powi(n)),
            Action::Powf(a, n) => one_by_one(at(a), at(n), out, f64::powf),
            Action::Apply(function, a) => one_by_one(at(a), at(a), out, |a, _| function.of(a)),
            Action::Atan2(a, b) => one_by_one(at(a), at(b), out, f64::atan2),
            Action::SinCos(a, cosine) => {
                if let Values::Each(angles) = at(a) {
                    sin_cos_of_all(simd, angles, out, &mut **second_spare);
                }
                std::mem::swap(&mut blocks[cosine as usize - inputs.len()], second_spare);
            }
        }
        std::mem::swap(&mut blocks[step.to as usize - inputs.len()], spare);
    }
}

/// The vector of a block from `lane` on.
#[inline(always)]
fn load<S: Simd>(simd: S, block: &Block, lane: usize) -> S::f64s {
    S::f64s::from_slice(simd, &block[lane..lane + S::f64s::LEN])
}

/// Fills a block, a vector at a time.
#[inline(always)]
fn fill<S: Simd>(out: &mut Block, value: impl Fn(usize) -> S::f64s) {
    for vector in 0..LANES / S::f64s::LEN {
        let lane = vector * S::f64s::LEN;
        value(lane).store_slice(&mut out[lane..lane + S::f64s::LEN]);
    }
}

/// Applies f(lane, a, b) to all lanes, with one loop for each kind of operands.
#[inline(always)]
fn of_two<S: Simd>(simd: S, a: Values, b: Values, out: &mut Block, f: impl Fn(usize, S::f64s, S::f64s) -> S::f64s) {
    let all = |value: f64| S::f64s::splat(simd, value);
    match (a, b) {
        (Values::Each(a), Values::Each(b)) => fill::<S>(out, |i| f(i, load(simd, a, i), load(simd, b, i))),
        (Values::Each(a), Values::All(b)) => {
            let b = all(b);
            fill::<S>(out, |i| f(i, load(simd, a, i), b));
        }
        (Values::All(a), Values::Each(b)) => {
            let a = all(a);
            fill::<S>(out, |i| f(i, a, load(simd, b, i)));
        }
        (Values::All(a), Values::All(b)) => {
            let (a, b) = (all(a), all(b));
            fill::<S>(out, |i| f(i, a, b));
        }
    }
}

#[inline(always)]
fn one<S: Simd>(simd: S, a: Values, out: &mut Block, f: impl Fn(S::f64s) -> S::f64s) {
    match a {
        Values::Each(a) => fill::<S>(out, |i| f(load(simd, a, i))),
        Values::All(a) => fill::<S>(out, |_| f(S::f64s::splat(simd, a))),
    }
}

#[inline(always)]
fn two<S: Simd>(simd: S, a: Values, b: Values, out: &mut Block, f: impl Fn(S::f64s, S::f64s) -> S::f64s) {
    of_two(simd, a, b, out, |_, a, b| f(a, b));
}

/// Applies f(lane, a, b, c) to all lanes.
#[inline(always)]
fn of_three<S: Simd>(
    simd: S,
    [a, b, c]: [Values; 3],
    out: &mut Block,
    f: impl Fn(usize, S::f64s, S::f64s, S::f64s) -> S::f64s,
) {
    match c {
        Values::Each(c) => of_two(simd, a, b, out, |i, a, b| f(i, a, b, load(simd, c, i))),
        Values::All(c) => {
            let c = S::f64s::splat(simd, c);
            of_two(simd, a, b, out, |i, a, b| f(i, a, b, c));
        }
    }
}

#[inline(always)]
fn three<S: Simd>(simd: S, abc: [Values; 3], out: &mut Block, f: impl Fn(S::f64s, S::f64s, S::f64s) -> S::f64s) {
    of_three(simd, abc, out, |_, a, b, c| f(a, b, c));
}

#[inline(always)]
fn four<S: Simd>(
    simd: S,
    [a, b, c, d]: [Values; 4],
    out: &mut Block,
    f: impl Fn(S::f64s, S::f64s, S::f64s, S::f64s) -> S::f64s,
) {
    match d {
        Values::Each(d) => of_three(simd, [a, b, c], out, |i, a, b, c| f(a, b, c, load(simd, d, i))),
        Values::All(d) => {
            let d = S::f64s::splat(simd, d);
            of_three(simd, [a, b, c], out, |_, a, b, c| f(a, b, c, d));
        }
    }
}

/// The operations that have no vector instructions.
fn one_by_one(a: Values, b: Values, out: &mut Block, f: impl Fn(f64, f64) -> f64) {
    let at = |values: Values, lane: usize| match values {
        Values::Each(block) => block[lane],
        Values::All(value) => value,
    };
    for (lane, out) in out.iter_mut().enumerate() {
        *out = f(at(a, lane), at(b, lane));
    }
}

#[cfg(test)]
pub(in crate::mechanics) mod tests {
    use super::*;
    use crate::mechanics::tape::Tape;
    use crate::mechanics::tape::single::Single;
    use crate::scalar::{DualNum, Graph, Symbol};

    /// The vector instructions of this machine, and the code without any.
    pub fn levels() -> Vec<Level> {
        let mut levels = vec![Level::fallback(), Level::baseline(), Level::new()];
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            let best = Level::new();
            levels.extend(best.as_sse4_2().map(|sse4_2| sse4_2.level()));
            levels.extend(best.as_avx2().map(|avx2| avx2.level()));
            levels.extend(best.as_avx512().map(|avx512| avx512.level()));
        }
        levels
    }

    /// Every operation on x, y and the uniform p, with every kind of operands, and every pair that is fused.
    fn tape() -> Tape {
        let (graph, outputs) = Graph::record(|| {
            let [x, y, p] = [0, 1, 2].map(Symbol::input);
            let (sine, cosine) = x.sin_cos();
            let products =
                [x * y + p, x * y - p, p - x * y, x * p + y, x * p - y, y - x * p, x * y + sine, x * 3.0 + 2.0];
            let quotients = [x / y, p / y, x / p, (x * y).recip() * cosine, y.recip()];
            // A product that only one operation uses is fused with that operation.
            let own = |k: i32| x * (y + f64::from(k) / 16.0);
            let fused = [own(1) + p, own(2) - p, p - own(3), -(own(4) + p), own(5) * y.exp()];
            let of_four = [own(6) * x.cos() + p, own(7) * x.cos() - p, p - own(8) * x.cos()];
            let of_three = [x * y * y.exp(), x.exp() * (y * p), (x + y) * (x.exp() * x.cos()), x * p * y.ln()];
            let others = [x - p, p - x, x + p, -(x + y), (x + y).sqrt(), y.powf(0.3), x.powi(20), y.exp(), x.atan2(y)];
            let negations = [-(x - y), -(x * y + p), -(x * y - p), -(p - x * y), -(x * p), -(p - x), -(x * y)];
            let uniform = [p * p + 1.0, x, p, Symbol::from(2.5), x.atan2(p), (x * p) * (y * p), sine * cosine];
            [&products[..], &quotients, &of_three, &fused, &of_four, &others, &negations, &uniform].concat()
        })
        .unwrap();
        Tape::new(&graph, 3, &outputs)
    }

    fn inputs() -> [Box<Block>; 3] {
        let column = |from: f64, step: f64| Box::new(std::array::from_fn(|lane| from + step * lane as f64));
        [column(0.1, 0.013), column(1.0, 0.02), column(0.7, 0.0)]
    }

    /// All outputs of all lanes.
    fn in_blocks(program: &Program, level: Level) -> Vec<[f64; LANES]> {
        let inputs = inputs();
        let inputs = inputs.each_ref().map(Box::as_ref);
        let uniform = program.uniform(&inputs.map(|block| block[0]));
        let mut registers = Registers::new(program, level);
        program.run_block(&mut registers, &inputs, &uniform);
        let output = |n| match program.output_of_block(n, &registers, &inputs, &uniform) {
            Values::Each(block) => *block,
            Values::All(value) => [value; LANES],
        };
        (0..program.outputs.len()).map(output).collect()
    }

    fn one_after_another(program: &Program) -> Vec<[f64; LANES]> {
        let inputs = inputs();
        let mut single = Single::new(program, &inputs.each_ref().map(|block| block[0]), program.outputs.len());
        let mut outputs = vec![[0.0; LANES]; program.outputs.len()];
        for lane in 0..LANES {
            single.run(inputs[0][lane], &[inputs[1][lane]], &[inputs[2][lane]]);
            for (n, output) in outputs.iter_mut().enumerate() {
                output[lane] = single.first_outputs()[n];
                assert_eq!(output[lane].to_bits(), single.output(n).to_bits());
            }
        }
        outputs
    }

    /// The tape itself, a lane at a time.
    fn plain(tape: &Tape) -> Vec<[f64; LANES]> {
        let inputs = inputs();
        let mut outputs = vec![[0.0; LANES]; tape.outputs()];
        for lane in 0..LANES {
            let values = tape.evaluate(&inputs.each_ref().map(|block| block[lane]));
            outputs.iter_mut().zip(values).for_each(|(output, value)| output[lane] = value);
        }
        outputs
    }

    fn agree(a: &[[f64; LANES]], b: &[[f64; LANES]]) -> bool {
        a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() <= 1e-14 * (1.0 + b.abs()))
    }

    #[test]
    fn a_program_computes_what_its_tape_does() {
        let tape = tape();
        let expected = plain(&tape);
        for uniform in [false, true] {
            let program = Program::new(&tape, |input| uniform && input == 2);
            assert!(agree(&one_after_another(&program), &expected));
            for level in levels() {
                let mut outputs = in_blocks(&program, level);
                assert!(agree(&outputs, &expected), "{level:?}");
                // must-fail case: one lane too far
                outputs[0].rotate_left(1);
                assert!(!agree(&outputs, &expected));
            }
        }
    }

    #[test]
    fn every_step_is_seen() {
        let tape = tape();
        let expected = plain(&tape);
        let program = Program::new(&tape, |input| input == 2);
        let kinds: std::collections::HashSet<_> =
            program.steps.iter().map(|step| std::mem::discriminant(&step.action)).collect();
        assert_eq!(kinds.len(), 18, "the tape is to have each kind of action");
        for step in 0..program.steps.len() {
            let mut changed = program.clone();
            let action = &mut changed.steps[step].action;
            *action = match *action {
                Action::Add(a, b) => Action::Sub(a, b),
                Action::Sub(a, b) => Action::Sub(b, a),
                Action::Mul(a, b) => Action::Div(a, b),
                Action::Product(a, b, c) => Action::MulAdd(a, b, c),
                Action::Div(a, b) => Action::Mul(a, b),
                Action::MulAdd(a, b, c) => Action::MulSub(a, b, c),
                Action::MulSub(a, b, c) => Action::SubMul(a, b, c),
                Action::SubMul(a, b, c) => Action::NegMulSub(a, b, c),
                Action::NegMulSub(a, b, c) => Action::MulAdd(a, b, c),
                Action::ProductAdd(a, b, c, d) => Action::ProductSub(a, b, c, d),
                Action::ProductSub(a, b, c, d) => Action::SubProduct(a, b, c, d),
                Action::SubProduct(a, b, c, d) => Action::ProductAdd(a, b, c, d),
                Action::Neg(a) => Action::Add(a, a),
                Action::Powi(a, n) => Action::Powi(a, n + 1),
                Action::Powf(a, n) => Action::Powf(n, a),
                Action::Apply(_, a) => Action::Apply(Function::Tan, a),
                Action::SinCos(a, _) => Action::Neg(a),
                Action::Atan2(a, b) => Action::Atan2(b, a),
            };
            for level in levels() {
                assert!(!agree(&in_blocks(&changed, level), &expected), "{:?}", program.steps[step]);
            }
            assert!(!agree(&one_after_another(&changed), &expected), "{:?}", program.steps[step]);
        }
    }

    #[test]
    fn steps_are_fewer_than_operations_and_registers_are_used_again() {
        let program = Program::new(&tape(), |input| input == 2);
        let (sum_of_products, length) = Graph::record(|| {
            let [x, y] = [0, 1].map(Symbol::input);
            let sum = (0..20).fold(x, |sum, _| sum * y + x);
            (sum, 20)
        })
        .map(|(graph, (sum, length))| (Program::new(&Tape::new(&graph, 2, &[sum]), |_| false), length))
        .unwrap();
        assert!(program.steps() < tape().ops().len());
        assert_eq!((sum_of_products.steps(), sum_of_products.registers), (length, 1));
    }
}
