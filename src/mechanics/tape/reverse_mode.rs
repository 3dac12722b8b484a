//! Reverse mode: the gradient of a tape's output in one backward pass. The cost is a small multiple of the cost of the
//! output, for any number of inputs.

use num_dual::{Dual, DualNum};
use num_traits::One;

use super::{Op, Tape};
use crate::scalar::{Number, Symbol};

/// The value of the tape's first output at `inputs`, and its derivative with respect to each input.
///
/// It runs over [`Symbol`] only: there a vanishing derivative is the constant 0, and costs nothing later.
pub fn gradient(tape: &Tape, inputs: &[Symbol]) -> (Symbol, Vec<Symbol>) {
    let x = tape.registers(inputs);
    let mut adjoint = vec![Symbol::from(0.0); x.len()];
    let output = tape.output_registers()[0] as usize;
    adjoint[output] = Symbol::one();
    for (&op, to) in tape.ops().iter().zip(inputs.len()..x.len()).rev() {
        let bar = adjoint[to];
        let mut add = |a: u32, term: Symbol| adjoint[a as usize] += term;
        match op {
            Op::Constant(_) | Op::CosOfSinCos => {}
            Op::Add(a, b) => {
                add(a, bar);
                add(b, bar);
            }
            Op::Sub(a, b) => {
                add(a, bar);
                add(b, -bar);
            }
            Op::Mul(a, b) => {
                add(a, bar * x[b as usize]);
                add(b, bar * x[a as usize]);
            }
            Op::Scale(a, c) => add(a, bar * c),
            Op::Offset(a, _) => add(a, bar),
            Op::Neg(a) => add(a, -bar),
            Op::SinCos(a) => {
                let (sine, cosine, of_cosine) = (x[to], x[to + 1], adjoint[to + 1]);
                adjoint[a as usize] += bar * cosine - of_cosine * sine;
            }
            Op::Recip(a) => add(a, bar * slope(x[a as usize], |x| x.recip())),
            Op::Powi(a, n) => add(a, bar * slope(x[a as usize], |x| x.powi(n))),
            Op::Powf(a, n) => add(a, bar * slope(x[a as usize], |x| x.powf(n))),
            Op::Apply(function, a) => add(a, bar * slope(x[a as usize], |x| function.of(x))),
            Op::Atan2(a, b) => {
                let (y, x) = (x[a as usize], x[b as usize]);
                add(a, bar * slope(y, |y| y.atan2(Dual::from_re(x))));
                add(b, bar * slope(x, |x| Dual::from_re(y).atan2(x)));
            }
        }
    }
    (x[output], adjoint[..inputs.len()].to_vec())
}

/// The derivative of an elementary function, with the conventions of num-dual.
fn slope<D: Number>(x: D, f: impl Fn(Dual<D>) -> Dual<D>) -> D {
    f(Dual::new(x, D::one())).eps
}
