//! The accelerations of a system as Rust source, for programs that do not link this crate.
//!
//! The traced tape is written down operation by operation. A value that is used once is written inline, unless the line
//! gets long; what is used more often has a name. The order of the operations is that of the tape, so the function
//! rounds as the tape does, but for quotients: a/b is written where the tape has a·(1/b).

use std::fmt::Write;

use super::traced_system::System;
use crate::mechanics::tape::{Op, Tape};
use crate::scalar::Function;

/// An expression that is longer than this gets a name of its own.
const LONG: usize = 72;

impl System {
    /// The accelerations as the source of one Rust function without loops and without dependencies:
    /// `pub fn accelerations(time: f64, q: &[f64; N], v: &[f64; N], parameters: &[f64; P]) -> [f64; N]`.
    ///
    /// Its documentation lists the entries of the slices. An argument that the motion does not depend on has a name
    /// with an underscore. The mass matrix is inverted without exchanging rows: where that fails, as where it is
    /// singular, the function gives what is not finite or badly rounded, and [`System::accelerations`] an answer or an
    /// error.
    ///
    /// ```
    /// use onshell::mechanics::System;
    /// use onshell::systems::Pendulum;
    ///
    /// let source = System::new(&Pendulum::<1>::new())?.rust_source();
    /// assert!(source.contains("pub fn accelerations("));
    /// # Ok::<(), onshell::Error>(())
    /// ```
    pub fn rust_source(&self) -> String {
        let (n, parameters) = (self.coordinates().len(), self.parameters().len());
        let tape = self.traced.accelerations.truncated(n);
        let read =
            |inputs: std::ops::Range<usize>| if inputs.into_iter().any(|input| tape.reads(input)) { "" } else { "_" };
        let (q, v) = (1..1 + n, 1 + n..1 + 2 * n);
        let signature = format!(
            "pub fn accelerations(\n    {}time: f64,\n    {}q: &[f64; {n}],\n    {}v: &[f64; {n}],\n    \
             {}parameters: &[f64; {parameters}],\n) -> [f64; {n}] {{\n",
            read(0..1),
            read(q.clone()),
            read(v.clone()),
            read(v.end..v.end + parameters),
        );
        let input = |place: usize| match place {
            0 => "time".to_owned(),
            place if q.contains(&place) => format!("q[{}]", place - q.start),
            place if v.contains(&place) => format!("v[{}]", place - v.start),
            place => format!("parameters[{}]", place - v.end),
        };
        let inputs = (0..v.end + parameters).map(input).collect();
        self.documentation() + &signature + &Emitter::new(&tape, inputs).body(&tape)
    }

    fn documentation(&self) -> String {
        let list = |names: &[String]| {
            let entry = |(i, name)| format!("///   {i}: `{name}`\n");
            names.iter().enumerate().map(entry).collect::<String>()
        };
        format!(
            "/// The accelerations of `{}`, derived from its Lagrangian.\n///\n\
             /// - `q`, the coordinates; `v`, their velocities; the result, their accelerations:\n{}\
             /// - `parameters`:\n{}///\n\
             /// Where the mass matrix is singular the result is not finite.\n",
            self.name(),
            list(self.coordinates()),
            list(self.parameters()),
        )
    }
}

/// The precedence of an expression, lowest first.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Sign,
    Whole,
}

/// A register as an expression.
#[derive(Clone)]
struct Term {
    text: String,
    binding: Binding,
    /// For a reciprocal that has no name: what it is the reciprocal of.
    reciprocal_of: Option<String>,
}

impl Term {
    fn new(binding: Binding, text: String) -> Self {
        Term { text, binding, reciprocal_of: None }
    }

    /// In parentheses, unless its precedence is at least `binding`.
    fn within(&self, binding: Binding) -> String {
        if self.binding >= binding { self.text.clone() } else { format!("({})", self.text) }
    }
}

struct Emitter {
    terms: Vec<Term>,
    /// How often each register is read.
    uses: Vec<usize>,
    lines: String,
}

impl Emitter {
    fn new(tape: &Tape, inputs: Vec<String>) -> Self {
        let mut uses = vec![0; inputs.len() + tape.ops().len()];
        let read = tape.ops().iter().flat_map(|op| op.operands()).chain(tape.output_registers().iter().copied());
        read.for_each(|register| uses[register as usize] += 1);
        let terms = inputs.into_iter().map(|text| Term::new(Binding::Whole, text)).collect();
        Emitter { terms, uses, lines: String::new() }
    }

    fn body(mut self, tape: &Tape) -> String {
        for &op in tape.ops() {
            self.write(op);
        }
        let outputs: Vec<&str> =
            tape.output_registers().iter().map(|&a| self.terms[a as usize].text.as_str()).collect();
        format!("{}    [{}]\n}}\n", self.lines, outputs.join(", "))
    }

    fn at(&self, register: u32) -> &Term {
        &self.terms[register as usize]
    }

    fn write(&mut self, op: Op) {
        use Binding::{Product, Sign, Sum, Whole};
        let term = match op {
            Op::Constant(c) => constant(c),
            Op::Add(a, b) => Term::new(Sum, format!("{} + {}", self.at(a).text, self.at(b).within(Product))),
            Op::Sub(a, b) => Term::new(Sum, format!("{} - {}", self.at(a).text, self.at(b).within(Product))),
            Op::Mul(a, b) => self.product(self.at(a), self.at(b)),
            Op::Scale(a, c) => self.product(&constant(c), self.at(a)),
            Op::Offset(a, c) if c < 0.0 => Term::new(Sum, format!("{} - {}", self.at(a).text, constant(-c).text)),
            Op::Offset(a, c) => Term::new(Sum, format!("{} + {}", self.at(a).text, constant(c).text)),
            Op::Neg(a) => Term::new(Sign, format!("-{}", self.at(a).within(Whole))),
            Op::Recip(a) => {
                let divisor = self.at(a).within(Sign);
                Term { reciprocal_of: Some(divisor.clone()), ..Term::new(Product, format!("1.0 / {divisor}")) }
            }
            Op::Powi(a, n) => Term::new(Whole, format!("{}.powi({n})", self.at(a).within(Whole))),
            Op::Powf(a, n) => Term::new(Whole, format!("{}.powf({})", self.at(a).within(Whole), constant(n).text)),
            Op::Apply(function, a) => Term::new(Whole, format!("{}.{}()", self.at(a).within(Whole), method(function))),
            Op::Atan2(a, b) => Term::new(Whole, format!("{}.atan2({})", self.at(a).within(Whole), self.at(b).text)),
            Op::SinCos(a) => {
                let (angle, place) = (self.at(a).within(Whole), self.terms.len());
                let (sine, cosine) = (format!("sin{place}"), format!("cos{place}"));
                let _ = writeln!(self.lines, "    let ({sine}, {cosine}) = {angle}.sin_cos();");
                self.terms.extend([sine, cosine].map(|name| Term::new(Whole, name)));
                return;
            }
            Op::CosOfSinCos => return, // came with its sine
        };
        let place = self.terms.len();
        // a constant is as short as a name
        let stays = matches!(op, Op::Constant(_)) || (self.uses[place] == 1 && term.text.len() <= LONG);
        self.terms.push(if stays {
            term
        } else {
            let _ = writeln!(self.lines, "    let x{place} = {};", term.text);
            Term::new(Whole, format!("x{place}"))
        });
    }

    fn product(&self, a: &Term, b: &Term) -> Term {
        let text = match (&a.reciprocal_of, &b.reciprocal_of) {
            (_, Some(divisor)) => format!("{} / {divisor}", a.within(Binding::Product)),
            (Some(divisor), _) => format!("{} / {divisor}", b.within(Binding::Product)),
            _ => format!("{} * {}", a.within(Binding::Product), b.within(Binding::Sign)),
        };
        Term::new(Binding::Product, text)
    }
}

/// A number of the machine, digit by digit.
fn constant(c: f64) -> Term {
    let text = match c {
        c if c.is_nan() => "f64::NAN".to_owned(),
        c if c.is_infinite() => format!("{}f64::INFINITY", if c < 0.0 { "-" } else { "" }),
        c => format!("{c:?}"),
    };
    Term::new(if text.starts_with('-') { Binding::Sign } else { Binding::Whole }, text)
}

fn method(function: Function) -> &'static str {
    match function {
        Function::Sqrt => "sqrt",
        Function::Cbrt => "cbrt",
        Function::Exp => "exp",
        Function::ExpM1 => "exp_m1",
        Function::Ln => "ln",
        Function::Ln1p => "ln_1p",
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "asin",
        Function::Acos => "acos",
        Function::Atan => "atan",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
        Function::Asinh => "asinh",
        Function::Acosh => "acosh",
        Function::Atanh => "atanh",
    }
}
