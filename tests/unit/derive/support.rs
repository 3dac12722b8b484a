//! Systems, states, and the value of what was typeset.

use onshell::derive::{Derivation, Quantity};
use onshell::formula::{Assignment, Expr, SymbolId, Value, evaluate};
use onshell::latex::{Macros, names, read_formula};
use onshell::mechanics::{Lagrangian, State, System};
use onshell::scalar::{Number, Series};
use onshell::systems::Registry;

/// A bead on the wire z = x²: the mass depends on the place, as a sum.
struct Bead;

impl Lagrangian<1, 2> for Bead {
    fn name(&self) -> &str {
        "bead"
    }
    fn coordinates(&self) -> [&str; 1] {
        ["x"]
    }
    fn parameters(&self) -> [&str; 2] {
        ["m", "g"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 2>) -> D {
        let ([x], [v], [m, g]) = (at.q, at.v, at.parameters);
        m * (v * v + (x * v * 2.0).powi(2)) * 0.5 - m * g * x * x
    }
}

/// A charge in a plane, a uniform magnetic field across it: L is linear in the velocities beside being quadratic.
struct Charge;

impl Lagrangian<2, 3> for Charge {
    fn name(&self) -> &str {
        "charge"
    }
    fn coordinates(&self) -> [&str; 2] {
        ["x", "y"]
    }
    fn parameters(&self) -> [&str; 3] {
        ["m", "q", "B"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 2, 3>) -> D {
        let ([x, y], [u, v], [m, q, b]) = (at.q, at.v, at.parameters);
        m * (u * u + v * v) * 0.5 + q * b * (x * v - y * u) * 0.5
    }
}

/// A mass on a rod whose support is shaken: functions of the time, a tangent, a root and a logarithm.
struct Shaken;

impl Lagrangian<1, 3> for Shaken {
    fn name(&self) -> &str {
        "shaken"
    }
    fn coordinates(&self) -> [&str; 1] {
        ["\\theta"]
    }
    fn parameters(&self) -> [&str; 3] {
        ["m", "l", "\\omega"]
    }
    fn lagrangian<D: Number>(&self, at: &State<D, 1, 3>) -> D {
        let ([theta], [v], [m, l, omega]) = (at.q, at.v, at.parameters);
        let support = (omega * at.time).cos();
        m * l * l * v * v * 0.5 + m * l * support * theta.sin() * v + m * l * (theta * 0.5).tan()
            - m * (l * l + theta * theta).sqrt()
            + m * (l + theta * theta).ln() * 0.1
    }
}

/// The systems of the crate, and some more.
pub fn registry() -> Registry {
    let mut registry = Registry::standard();
    registry.add(Bead).add(Charge).add(Shaken).add(onshell::systems::Pendulum::<3>::new());
    registry
}

/// A system and what is derived of it.
pub struct Subject {
    pub system: System,
    pub derivation: Derivation,
}

/// Every system.
pub fn subjects() -> Vec<Subject> {
    let registry = registry();
    registry.names().map(|name| subject_of(&registry, name)).collect()
}

/// One system.
pub fn subject(name: &str) -> Subject {
    subject_of(&registry(), name)
}

fn subject_of(registry: &Registry, name: &str) -> Subject {
    let system = registry.get(name).expect("it is registered").trace().expect("it can be traced");
    let derivation = Derivation::new(&system).unwrap_or_else(|error| panic!("{name}: {error}"));
    Subject { system, derivation }
}

/// A state, with accelerations that no motion has.
pub struct Numbers {
    pub time: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub parameters: Vec<f64>,
    pub a: Vec<f64>,
}

/// The n-th state: velocities below all velocities of light, everything else of order one.
pub fn numbers(system: &System, n: usize) -> Numbers {
    let mut step = 17.0 * n as f64;
    let mut next = |low: f64, high: f64| {
        step += 1.0;
        low + (high - low) * (step * 0.618_033_988_749_895 + (step * step * 0.414_213_562).sin()).rem_euclid(1.0)
    };
    let count = system.coordinates().len();
    Numbers {
        time: next(0.1, 0.9),
        q: (0..count).map(|_| next(0.3, 1.3)).collect(),
        v: (0..count).map(|_| next(-0.7, 0.7)).collect(),
        parameters: system.parameters().iter().map(|_| next(0.8, 2.0)).collect(),
        a: (0..count).map(|_| next(-1.0, 1.0)).collect(),
    }
}

impl Subject {
    /// The equations for a quantity as LaTeX; `None` where there is none to typeset.
    pub fn latex(&self, quantity: Quantity) -> Option<Vec<String>> {
        let equations = self.derivation.equations(quantity).ok()?;
        Some(equations.iter().map(|equation| self.derivation.latex(equation)).collect())
    }

    /// The right side of a quantity's n-th equation, read from LaTeX.
    pub fn right(&self, quantity: Quantity, n: usize) -> Expr {
        let latex = self.latex(quantity).expect("it can be derived");
        self.read(latex[n].split_once(" = ").expect("an equation").1)
    }

    pub fn read(&self, latex: &str) -> Expr {
        let mut symbols = self.derivation.symbols().clone();
        let known = symbols.len();
        let read = read_formula(latex, &mut symbols, &Macros::default());
        assert_eq!(symbols.len(), known, "{latex} introduces a name");
        read.unwrap_or_else(|fault| panic!("{latex} is refused: {}", fault.message))
    }

    /// Both sides of an equation in LaTeX, at a state.
    pub fn sides(&self, latex: &str, at: &Numbers) -> [f64; 2] {
        let (left, right) = latex.split_once(" = ").expect("an equation");
        [self.value(left, at), self.value(right, at)]
    }

    fn id(&self, latex: &str) -> SymbolId {
        let (name, _) = names::parse(latex).expect("a name");
        self.derivation.symbols().find(&name).expect("a name of the system").0
    }

    /// The value of LaTeX, momenta and what is defined here being what the system says.
    pub fn value(&self, latex: &str, at: &Numbers) -> f64 {
        let quantities = self.system.quantities(at.time, &at.q, &at.v, &at.parameters);
        let mass = self.system.mass_matrix(at.time, &at.q, &at.v, &at.parameters);
        let mut known: Assignment<'_, f64> = Assignment::new(self.derivation.symbols());
        known.set(self.id("t"), 0, at.time);
        for (i, name) in self.system.coordinates().iter().enumerate() {
            let (coordinate, momentum) = (self.id(name), self.id(&format!("p_{{{name}}}")));
            [at.q[i], at.v[i], at.a[i]].iter().zip(0..).for_each(|(value, order)| known.set(coordinate, order, *value));
            known.set(momentum, 0, quantities.momenta[i]);
            known.set(momentum, 1, quantities.forces[i]);
            for (j, other) in self.system.coordinates().iter().enumerate().skip(i) {
                known.set(self.id(&format!("M_{{{name} {other}}}")), 0, mass[(i, j)]);
            }
        }
        for (name, value) in self.system.parameters().iter().zip(&at.parameters) {
            known.set(self.id(name), 0, *value);
        }
        known.set(self.id("L"), 0, quantities.lagrangian);
        known.set(self.id("E"), 0, quantities.energy);
        known.set(self.id("H"), 0, quantities.energy);
        let value: Value<Series<f64>> = evaluate(&self.read(latex), &known, &[]).expect("all is known");
        match value {
            Value::Scalar(value) => value.value(),
            other => panic!("{latex} is no number: {other:?}"),
        }
    }
}

/// Whether two numbers agree to 10⁻⁹ of a scale.
pub fn agree(a: f64, b: f64, scale: f64) -> bool {
    (a - b).abs() <= 1e-9 * scale
}
