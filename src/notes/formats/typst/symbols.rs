//! The names of Typst's symbols and functions, with their LaTeX.

/// Symbols that have the same name in LaTeX.
const ALIKE: &[&str] = &[
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi",
    "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega", "partial", "nabla", "times", "approx", "equiv", "sum", "hbar",
    "ell", "in", "forall", "exists", "perp", "parallel", "dagger", "star", "quad", "sin", "cos", "tan", "cot", "sec",
    "csc", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "coth", "exp", "log", "ln", "lg", "lim", "max", "min",
    "sup", "inf", "det", "ker", "dim", "gcd", "deg", "div", "dots", "cdot",
];

/// Symbols with another name.
const OTHERS: &[(&str, &str)] = &[
    ("diff", "\\partial"),
    ("dot", "\\cdot"),
    ("dot.op", "\\cdot"),
    ("dot.c", "\\cdot"),
    ("cross", "\\times"),
    ("plus.minus", "\\pm"),
    ("minus.plus", "\\mp"),
    ("prop", "\\propto"),
    ("infinity", "\\infty"),
    ("oo", "\\infty"),
    ("product", "\\prod"),
    ("integral", "\\int"),
    ("integral.double", "\\iint"),
    ("integral.triple", "\\iiint"),
    ("integral.cont", "\\oint"),
    ("planck.reduce", "\\hbar"),
    ("arrow.r", "\\to"),
    ("arrow.r.double", "\\Rightarrow"),
    ("dots.h", "\\dots"),
    ("dots.c", "\\dots"),
    ("dots.h.c", "\\dots"),
    ("epsilon.alt", "\\varepsilon"),
    ("phi.alt", "\\varphi"),
    ("theta.alt", "\\vartheta"),
    ("rho.alt", "\\varrho"),
    ("thin", "\\,"),
    ("med", "\\:"),
    ("thick", "\\;"),
    ("space", "\\ "),
    ("wide", "\\qquad"),
    ("lt.eq", "\\le"),
    ("gt.eq", "\\ge"),
    ("lt.double", "\\ll"),
    ("gt.double", "\\gg"),
    ("eq.not", "\\ne"),
    ("eq.triple", "\\equiv"),
    ("tilde.eq", "\\simeq"),
    ("tilde.op", "\\sim"),
    ("RR", "\\mathbb{R}"),
    ("NN", "\\mathbb{N}"),
    ("ZZ", "\\mathbb{Z}"),
    ("CC", "\\mathbb{C}"),
    ("dif", "\\mathrm{d}"),
    ("tr", "\\operatorname{tr}"),
    ("prime", "\\prime"),
    ("square", "\\square"),
];

/// Marks of several characters, the longest first.
pub(super) const MARKS: &[(&str, &str)] = &[
    ("...", "\\dots "),
    ("->", "\\to "),
    ("=>", "\\Rightarrow "),
    ("<=", "\\le "),
    (">=", "\\ge "),
    ("!=", "\\ne "),
    ("<<", "\\ll "),
    (">>", "\\gg "),
    (":=", ":= "),
];

/// Functions of one argument, with the command that takes it.
const COMMANDS: &[(&str, &str)] = &[
    ("sqrt", "\\sqrt"),
    ("dot", "\\dot"),
    ("dot.double", "\\ddot"),
    ("dot.triple", "\\dddot"),
    ("hat", "\\hat"),
    ("tilde", "\\tilde"),
    ("macron", "\\bar"),
    ("overline", "\\overline"),
    ("arrow", "\\vec"),
    ("bold", "\\mathbf"),
    ("upright", "\\mathrm"),
    ("cal", "\\mathcal"),
    ("bb", "\\mathbb"),
    ("frak", "\\mathfrak"),
    ("vb", "\\mathbf"),
    ("va", "\\vec"),
    ("vu", "\\hat"),
    ("op", "\\operatorname"),
    ("abs", "\\abs"),
    ("norm", "\\norm"),
];

/// The LaTeX of a symbol.
pub(super) fn symbol(name: &str) -> Option<String> {
    if ALIKE.contains(&name) {
        return Some(format!("\\{name}"));
    }
    OTHERS.iter().find(|(own, _)| *own == name).map(|(_, latex)| (*latex).to_owned())
}

/// The command for a function of one argument.
pub(super) fn command(name: &str) -> Option<&'static str> {
    COMMANDS.iter().find(|(own, _)| *own == name).map(|(_, latex)| *latex)
}

/// Whether a name in front of parentheses is a function of mathematics, which keeps them.
pub(super) fn keeps_parentheses(name: &str) -> bool {
    symbol(name).is_some() && command(name).is_none()
}
