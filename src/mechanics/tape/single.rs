//! A program over one state at a time, without allocation: inputs, temporary registers and uniform values stand in one
//! list, and every step reads and writes there.

use super::program::{Action, Program};

impl Program {
    /// The list that [`run`](Program::run) works on, for these uniform inputs.
    pub fn list(&self, inputs: &[f64]) -> Vec<f64> {
        let mut list = vec![f64::NAN; self.inputs + self.registers];
        list.extend(self.uniform(inputs));
        list
    }

    /// Runs for the state whose inputs stand first in the list; the outputs are then at [`output`](Program::output).
    pub fn run(&self, x: &mut [f64]) {
        for step in &self.steps {
            let at = |place: u32| x[place as usize];
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
                Action::Powf(a, n) => at(a).powf(n),
                Action::Apply(function, a) => function.of(at(a)),
                Action::SinCos(a, to) => {
                    let (sine, cosine) = at(a).sin_cos();
                    x[to as usize] = cosine;
                    sine
                }
                Action::Atan2(a, b) => at(a).atan2(at(b)),
            };
            x[step.to as usize] = value;
        }
    }

    /// Whether what stands at a place of the list is the same for all states.
    pub fn is_uniform(&self, place: usize) -> bool {
        place >= self.inputs + self.registers
    }

    /// Where the n-th output stands.
    pub fn output(&self, n: usize) -> usize {
        self.outputs[n] as usize
    }
}
