//! A program over one state at a time, without allocation. Inputs, temporary registers and uniform values are entries of
//! one list.
//!
//! A step takes little more than a nanosecond, so bounds checks and copies would show. If 256 places are enough, a place
//! is one byte and the length of the list is a constant. The requested outputs are contiguous.

use std::ops::{IndexMut, Range};

use super::program::{Action, Program, Step};

/// The number of places that a byte can address.
const NARROW: usize = 1 << u8::BITS;

/// A program with its list, for fixed uniform inputs.
pub struct Single {
    machine: Machine,
    /// The indices of the outputs.
    outputs: Vec<usize>,
    /// The range of the outputs that are contiguous.
    first: Range<usize>,
}

enum Machine {
    Narrow { steps: Vec<Step<u8>>, list: Box<[f64; NARROW]> },
    Wide { steps: Vec<Step>, list: Vec<f64> },
}

impl Single {
    /// The program for these uniform inputs. The first `together` outputs are contiguous.
    pub fn new(program: &Program, inputs: &[f64], together: usize) -> Self {
        let mut steps = program.steps.clone();
        let mut list = vec![f64::NAN; program.inputs + program.registers];
        let mut outputs = program.outputs.clone();
        let own = program.inputs as u32..list.len() as u32;
        list.extend(program.uniform(inputs));
        list.push(1.0);
        let one = list.len() as u32 - 1;
        // an output that is also an input, a uniform value or another output is copied
        for i in 0..together {
            if !own.contains(&outputs[i]) || outputs[..i].contains(&outputs[i]) {
                steps.push(Step { action: Action::Mul(outputs[i], one), to: list.len() as u32 });
                outputs[i] = list.len() as u32;
                list.push(f64::NAN);
            }
        }
        // the order: inputs, contiguous outputs, all other places
        let mut order: Vec<u32> = (0..program.inputs as u32).chain(outputs[..together].iter().copied()).collect();
        let others: Vec<u32> = (program.inputs as u32..list.len() as u32).filter(|p| !order.contains(p)).collect();
        order.extend(others);
        let mut place = vec![0; order.len()];
        order.iter().zip(0..).for_each(|(&old, new)| place[old as usize] = new);
        let list: Vec<f64> = order.iter().map(|&old| list[old as usize]).collect();
        let of = |old: u32| place[old as usize];
        Single {
            outputs: outputs.iter().map(|&output| of(output) as usize).collect(),
            first: program.inputs..program.inputs + together,
            machine: Machine::new(&steps, list, of),
        }
    }

    /// Runs for a time, the coordinates and as many velocities, which are the first inputs.
    pub fn run(&mut self, time: f64, q: &[f64], v: &[f64]) {
        match &mut self.machine {
            Machine::Narrow { steps, list } => {
                enter(&mut **list, time, q, v);
                run(steps, &mut **list);
            }
            Machine::Wide { steps, list } => {
                enter(&mut **list, time, q, v);
                run(steps, &mut **list);
            }
        }
    }

    /// The contiguous outputs of the last run.
    pub fn first_outputs(&self) -> &[f64] {
        match &self.machine {
            Machine::Narrow { list, .. } => &list[self.first.clone()],
            Machine::Wide { list, .. } => &list[self.first.clone()],
        }
    }

    /// The n-th output of the last run.
    pub fn output(&self, n: usize) -> f64 {
        let place = self.outputs[n];
        match &self.machine {
            Machine::Narrow { list, .. } => list[place % NARROW],
            Machine::Wide { list, .. } => list[place],
        }
    }
}

impl Machine {
    fn new(steps: &[Step], list: Vec<f64>, place: impl Fn(u32) -> u32) -> Self {
        if list.len() > NARROW {
            let moved = |step: &Step| Step { action: step.action.map(&place), to: place(step.to) };
            return Machine::Wide { steps: steps.iter().map(moved).collect(), list };
        }
        let byte = |old: u32| place(old) as u8;
        let moved = |step: &Step| Step { action: step.action.map(byte), to: byte(step.to) };
        let mut narrow = Box::new([f64::NAN; NARROW]);
        narrow[..list.len()].copy_from_slice(&list);
        Machine::Narrow { steps: steps.iter().map(moved).collect(), list: narrow }
    }
}

/// Copies numbers one by one. Two calls of `copy_from_slice` are slower, because vector loads wait for the single stores
/// before them.
#[inline(always)]
fn enter<L: IndexMut<usize, Output = f64> + ?Sized>(list: &mut L, time: f64, q: &[f64], v: &[f64]) {
    list[0] = time;
    for i in 0..q.len() {
        list[1 + i] = q[i];
        list[1 + q.len() + i] = v[i];
    }
}

#[inline(always)]
fn run<P: Copy + Into<u32>, L: IndexMut<usize, Output = f64> + ?Sized>(steps: &[Step<P>], x: &mut L) {
    for step in steps {
        let at = |place: P| x[place.into() as usize];
        let value = match step.action {
            Action::Add(a, b) => at(a) + at(b),
            Action::Sub(a, b) => at(a) - at(b),
            Action::Mul(a, b) => at(a) * at(b),
            Action::Product(a, b, c) => at(a) * at(b) * at(c),
            Action::Div(a, b) => at(a) / at(b),
            Action::MulAdd(a, b, c) => at(a) * at(b) + at(c),
            Action::MulSub(a, b, c) => at(a) * at(b) - at(c),
            Action::SubMul(a, b, c) => at(c) - at(a) * at(b),
            Action::NegMulSub(a, b, c) => -(at(a) * at(b)) - at(c),
            Action::ProductAdd(a, b, c, d) => at(a) * at(b) * at(c) + at(d),
            Action::ProductSub(a, b, c, d) => at(a) * at(b) * at(c) - at(d),
            Action::SubProduct(a, b, c, d) => at(d) - at(a) * at(b) * at(c),
            Action::Neg(a) => -at(a),
            Action::Powi(a, n) => at(a).powi(n),
            Action::Powf(a, n) => at(a).powf(at(n)),
            Action::Apply(function, a) => function.of(at(a)),
            Action::SinCos(a, to) => {
                let (sine, cosine) = at(a).sin_cos();
                x[to.into() as usize] = cosine;
                sine
            }
            Action::Atan2(a, b) => at(a).atan2(at(b)),
        };
        x[step.to.into() as usize] = value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::tape::Tape;
    use crate::scalar::{DualNum, Graph, Symbol};

    /// Σₖ xᵏ/(k + p), the input x, the uniform 2 p, and the sum once more.
    fn program(terms: i32) -> Program {
        let (graph, outputs) = Graph::record(|| {
            let [x, p] = [1, 3].map(Symbol::input);
            let sum = (0..terms).rev().fold(Symbol::from(0.0), |sum, k| sum * x + (p + f64::from(k)).recip());
            [sum, x, p * 2.0, sum]
        })
        .unwrap();
        Program::new(&Tape::new(&graph, 4, &outputs), |input| input == 3)
    }

    #[test]
    fn outputs_stand_together_whatever_they_are() {
        let (x, p) = (0.3_f64, 1.7);
        for (terms, is_narrow) in [(20, true), (NARROW as i32, false)] {
            let mut single = Single::new(&program(terms), &[f64::NAN, f64::NAN, f64::NAN, p], 4);
            assert_eq!(matches!(single.machine, Machine::Narrow { .. }), is_narrow);
            single.run(0.0, &[x], &[0.0]);
            let sum: f64 = (0..terms).map(|k| x.powi(k) / (f64::from(k) + p)).sum();
            let [first, input, uniform, again] = single.first_outputs() else { panic!("four outputs") };
            assert!((first - sum).abs() < 1e-15 && first == again);
            assert_eq!((*input, *uniform), (x, 2.0 * p));
            assert_eq!([0, 1, 2, 3].map(|n| single.output(n)), [*first, *input, *uniform, *again]);
            // must-fail case: another state gives another sum
            single.run(0.0, &[x + 0.1], &[0.0]);
            assert!((single.output(0) - sum).abs() > 1e-2);
        }
    }
}
