//! The operators of a formula tree: elementary functions, functions of matrices, parts of complex numbers, relations.

/// The functions of a square matrix whose value is a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixFunction {
    /// `\\det A`
    Determinant,
    /// `\\operatorname{tr} A`
    Trace,
}

impl MatrixFunction {
    /// The usual name.
    pub fn name(self) -> &'static str {
        match self {
            MatrixFunction::Determinant => "det",
            MatrixFunction::Trace => "tr",
        }
    }

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            MatrixFunction::Determinant => "determinant",
            MatrixFunction::Trace => "trace",
        }
    }

    /// The LaTeX that prints it.
    pub fn command(self) -> &'static str {
        match self {
            MatrixFunction::Determinant => "\\det",
            MatrixFunction::Trace => "\\operatorname{tr}",
        }
    }
}

/// The real number or the complex number that is taken of a complex one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ComplexPart {
    /// `z^*`, `\bar z` of a complex z
    Conjugate,
    /// `\operatorname{Re} z`
    Real,
    /// `\operatorname{Im} z`
    Imaginary,
}

impl ComplexPart {
    /// The usual name.
    pub fn name(self) -> &'static str {
        match self {
            ComplexPart::Conjugate => "conj",
            ComplexPart::Real => "Re",
            ComplexPart::Imaginary => "Im",
        }
    }
}

/// The relation between two members of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each is the relation of its name")]
pub enum Relation {
    Equal,
    /// `\equiv`, `:=`: a definition, unless the symbol is known.
    Identical,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    NotEqual,
    /// `\approx`, `\simeq`.
    Approximately,
    Proportional,
}

impl Relation {
    /// Every relation, as one character.
    const ALL: &[(Relation, &str)] = &[
        (Relation::Equal, "="),
        (Relation::Identical, "≡"),
        (Relation::Less, "<"),
        (Relation::LessEqual, "≤"),
        (Relation::Greater, ">"),
        (Relation::GreaterEqual, "≥"),
        (Relation::NotEqual, "≠"),
        (Relation::Approximately, "≈"),
        (Relation::Proportional, "∝"),
    ];

    /// The relation as LaTeX, with a space after it.
    pub fn command(self) -> &'static str {
        match self {
            Relation::Equal => " = ",
            Relation::Identical => " \\equiv ",
            Relation::Less => " < ",
            Relation::LessEqual => " \\le ",
            Relation::Greater => " > ",
            Relation::GreaterEqual => " \\ge ",
            Relation::NotEqual => " \\neq ",
            Relation::Approximately => " \\approx ",
            Relation::Proportional => " \\propto ",
        }
    }

    /// The relation as one character.
    pub fn glyph(self) -> &'static str {
        Self::ALL.iter().find(|(relation, _)| *relation == self).map_or("", |(_, glyph)| *glyph)
    }
}

/// The elementary functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each is the function of its name")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Cot,
    Sec,
    Csc,
    Arcsin,
    Arccos,
    Arctan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
}

impl Function {
    /// Every function, with the LaTeX command that names it.
    pub const ALL: [(Function, &'static str); 14] = [
        (Function::Sin, "sin"),
        (Function::Cos, "cos"),
        (Function::Tan, "tan"),
        (Function::Cot, "cot"),
        (Function::Sec, "sec"),
        (Function::Csc, "csc"),
        (Function::Arcsin, "arcsin"),
        (Function::Arccos, "arccos"),
        (Function::Arctan, "arctan"),
        (Function::Sinh, "sinh"),
        (Function::Cosh, "cosh"),
        (Function::Tanh, "tanh"),
        (Function::Exp, "exp"),
        (Function::Ln, "ln"),
    ];

    /// The inverse function, where it has a name here.
    pub fn inverse(self) -> Option<Function> {
        match self {
            Function::Sin => Some(Function::Arcsin),
            Function::Cos => Some(Function::Arccos),
            Function::Tan => Some(Function::Arctan),
            _ => None,
        }
    }

    /// The function that a command (without its backslash) names.
    pub fn named(command: &str) -> Option<Function> {
        Self::ALL.iter().find(|(_, name)| *name == command).map(|(function, _)| *function)
    }

    /// The usual name, which is also the LaTeX command without its backslash.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(function, _)| *function == self).map_or("", |(_, name)| *name)
    }
}

/// What an operator or a function that has no formula makes of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// A function: its value has the kind of the name.
    Function,
    /// The value has the shape of the argument: a sum, an integral, a curl.
    Same,
    /// The value is a vector: a gradient.
    ToVector,
    /// The value is a number: a divergence.
    ToNumber,
    /// The name is LaTeX with a # for each argument, and what it prints has no value: `\\langle # | # \\rangle`.
    Template,
}
