//! A formula as readable Unicode text, with every product, argument and power explicit.
//!
//! The author reads it to see whether the formula was understood: `λ_1·θ̈ = λ_1·φ̇²·sin(θ)·cos(θ) − …`.

use super::symbols::Symbols;
use super::tree::{Branch, Condition, Excluded, Expr, Index, Node, Sign, Statement};

/// A statement as text.
pub fn statement(statement: &Statement, symbols: &Symbols) -> String {
    let mut text = String::new();
    for (at, member) in statement.members.iter().enumerate() {
        if at > 0 {
            text.push_str(&format!(" {} ", statement.relations[at - 1].0.glyph()));
        }
        text.push_str(&formula(member, symbols));
    }
    if statement.constant.is_some() {
        text.push_str(" is constant");
    }
    if !statement.conditions.is_empty() {
        text.push_str(&format!(" for {}", Writer { symbols }.conditions(&statement.conditions)));
    }
    text
}

/// A formula as text.
pub fn formula(expr: &Expr, symbols: &Symbols) -> String {
    Writer { symbols }.write(expr, 0)
}

/// Ends the name of an operator, which so differs from that of a quantity; it is not shown.
pub const APPLICATION: char = '\u{2061}';

struct Writer<'a> {
    symbols: &'a Symbols,
}

/// The binding strength of a node: 1 for sums, 2 for products, 3 for powers, 4 for anything else.
fn binding(node: &Node, symbols: &Symbols) -> u8 {
    match node {
        Node::Symbol { id, .. } if symbols.entry(*id).squared => 3,
        Node::Sum(_) => 1,
        Node::Product(_) | Node::Quotient(..) | Node::Cross(..) | Node::Dot(..) => 2,
        Node::SumOver { .. } | Node::Integral(..) | Node::Shrinking(..) => 2,
        Node::Power(..) | Node::Transpose(_) | Node::Inverse(_) => 3,
        _ => 4,
    }
}

impl Writer<'_> {
    fn write(&self, expr: &Expr, outer: u8) -> String {
        let text = self.bare(expr);
        let binding = binding(&expr.node, self.symbols);
        if binding <= outer && !(outer == 1 && binding == 2) { format!("({text})") } else { text }
    }

    fn bare(&self, expr: &Expr) -> String {
        match &expr.node {
            Node::Number(text) => text.clone(),
            Node::Pi => "π".into(),
            Node::Euler => "e".into(),
            Node::Symbol { id, indices, dots } => {
                let entry = self.symbols.entry(*id);
                let mut name = entry.name.clone();
                if indices.is_empty() && !entry.slots.is_empty() {
                    name.subscript.clear();
                } else {
                    for ((at, _), index) in entry.slots.iter().zip(indices) {
                        name.subscript[*at] = self.index(*index);
                    }
                }
                with_dots(&name.to_string(), *dots) + if entry.squared { "^2" } else { "" }
            }
            Node::Sum(terms) => {
                let mut text = String::new();
                for (at, term) in terms.iter().enumerate() {
                    text.push_str(match (term.sign, at) {
                        (Sign::Plus, 0) => "",
                        (Sign::Minus, 0) => "−",
                        (Sign::Plus, _) => " + ",
                        (Sign::Minus, _) => " − ",
                    });
                    text.push_str(&self.write(&term.expr, 1));
                }
                text
            }
            Node::Product(factors) => {
                let factors: Vec<String> = factors.iter().map(|factor| self.write(factor, 2)).collect();
                factors.join("·")
            }
            Node::Quotient(a, b) => format!("{}/{}", self.write(a, 2), self.write(b, 2)),
            Node::Power(base, exponent) => {
                let base = self.write(base, 3);
                match &exponent.node {
                    Node::Number(text) => format!("{base}^{text}"),
                    _ => format!("{base}^({})", self.bare(exponent)),
                }
            }
            Node::Root(2, a) => format!("√({})", self.bare(a)),
            Node::Root(n, a) => format!("root[{n}]({})", self.bare(a)),
            Node::Call(function, a) => format!("{}({})", function.name(), self.bare(a)),
            Node::Apply(id, arguments) => {
                let arguments: Vec<String> = arguments.iter().map(|a| self.bare(a)).collect();
                let entry = self.symbols.entry(*id);
                let name = plain(&entry.name.to_string().replace(APPLICATION, ""));
                match (arguments.as_slice(), entry.operator) {
                    ([], Some(_)) => name,
                    ([inner], Some(_)) if name.starts_with('|') => format!("({inner}){name}"),
                    _ => format!("{name}({})", arguments.join(", ")),
                }
            }
            Node::TimeDerivative(1, a) => format!("d/dt({})", self.bare(a)),
            Node::TimeDerivative(n, a) => format!("d^{n}/dt^{n}({})", self.bare(a)),
            Node::Norm(a) => format!("|{}|", self.bare(a)),
            Node::Cross(a, b) => format!("{} × {}", self.write(a, 2), self.write(b, 2)),
            Node::Dot(a, b) => format!("{} • {}", self.write(a, 2), self.write(b, 2)),
            Node::Matrix(rows) => {
                let rows: Vec<String> = rows
                    .iter()
                    .map(|row| row.iter().map(|entry| self.bare(entry)).collect::<Vec<_>>().join(", "))
                    .collect();
                format!("[{}]", rows.join("; "))
            }
            Node::Transpose(a) => format!("{}ᵀ", self.write(a, 3)),
            Node::Inverse(a) => format!("{}⁻¹", self.write(a, 3)),
            Node::Identity => "𝟙".into(),
            Node::Imaginary => "i".into(),
            Node::OfMatrix(function, a) => format!("{}({})", function.name(), self.bare(a)),
            Node::Complex(part, a) => format!("{}({})", part.name(), self.bare(a)),
            Node::Commutator(a, b) => format!("[{}, {}]", self.bare(a), self.bare(b)),
            Node::Cases(branches) => {
                let branch = |branch: &Branch| match branch.conditions.as_slice() {
                    [] => format!("{} otherwise", self.bare(&branch.value)),
                    conditions => format!("{} if {}", self.bare(&branch.value), self.conditions(conditions)),
                };
                format!("{{{}}}", branches.iter().map(branch).collect::<Vec<_>>().join("; "))
            }
            Node::Entry(a, i, j) => format!("({})_{}{}", self.bare(a), self.index(*i), self.index(*j)),
            Node::Epsilon([a, b, c]) => format!("ε_{}{}{}", self.index(*a), self.index(*b), self.index(*c)),
            Node::Delta([a, b]) => format!("δ_{}{}", self.index(*a), self.index(*b)),
            Node::SumOver { index, except, within, body, .. } => {
                let letter = &self.symbols.indices[index.0].letter;
                let except: Vec<String> = except.iter().map(|left_out| self.left_out(*left_out)).collect();
                let except = except.concat();
                let within = within
                    .map_or_else(String::new, |id| format!("∈{}", plain(&self.symbols.entry(id).name.to_string())));
                format!("Σ_{letter}{except}{within} {}", self.write(body, 1))
            }
            Node::Integral(region, a) => {
                format!("∫_{} {}", plain(&self.symbols.entry(*region).name.to_string()), self.write(a, 1))
            }
            Node::Shrinking(region, a) => {
                format!("lim_{{{} → 0}} {}", plain(&self.symbols.entry(*region).name.to_string()), self.write(a, 1))
            }
            Node::Component(a, index) => format!("({})_{}", self.bare(a), self.index(*index)),
        }
    }

    /// Conditions that must all hold.
    fn conditions(&self, conditions: &[Condition]) -> String {
        let one = |condition: &Condition| {
            let mut text = String::new();
            for (at, member) in condition.members.iter().enumerate() {
                if at > 0 {
                    text.push_str(&format!(" {} ", condition.relations[at - 1].glyph()));
                }
                text.push_str(&self.write(member, 0));
            }
            text
        };
        conditions.iter().map(one).collect::<Vec<_>>().join(" and ")
    }

    fn left_out(&self, left_out: Excluded) -> String {
        match left_out {
            Excluded::Value(index) => format!("≠{}", self.index(index)),
            Excluded::From(index) => format!("<{}", self.index(index)),
            Excluded::UpTo(index) => format!(">{}", self.index(index)),
            Excluded::Last(count) => format!("…−{count}"),
        }
    }

    fn index(&self, index: Index) -> String {
        match index {
            Index::Letter(id) => self.symbols.indices[id.0].letter.clone(),
            Index::Fixed(value) => value.to_string(),
        }
    }
}

#[cfg(feature = "notes")]
/// A number with so many significant digits. What is not finite is said in words.
pub fn number(value: f64, digits: usize) -> String {
    let magnitude = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    if value.is_nan() {
        "no value".to_owned()
    } else if value.is_infinite() {
        (if value > 0.0 { "+∞" } else { "−∞" }).to_owned()
    } else if value == 0.0 {
        "0".to_owned()
    } else if (-4.0..digits as f64).contains(&magnitude) {
        let decimals = (digits as f64 - 1.0 - magnitude).max(0.0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.*e}", digits - 1)
    }
}

/// A LaTeX name as Unicode: Greek letters as letters, accents as combining marks.
pub fn plain(latex: &str) -> String {
    if let Some((above, below)) = derivative(latex) {
        return format!("∂{}/∂{}", plain(above), plain(below));
    }
    let mut text = String::new();
    let mut rest = latex;
    while let Some(at) = rest.find('\\') {
        text.push_str(&rest[..at]);
        let command = &rest[at + 1..];
        let length = command.bytes().take_while(u8::is_ascii_alphabetic).count();
        let name = &command[..length];
        rest = &command[length..];
        if let Some(mark) = mark(name)
            && let Some(inner) = rest.strip_prefix('{')
            && let Some(close) = matching(inner)
        {
            text.push_str(&plain(&inner[..close]));
            text.push_str(mark);
            rest = &inner[close + 1..];
            continue;
        }
        match letter(name) {
            Some(letter) => {
                text.push(letter);
                rest = rest.strip_prefix(' ').unwrap_or(rest);
            }
            None => match name {
                "neq" => text.push('≠'),
                "times" => text.push('×'),
                "rightarrow" => text.push('→'),
                "in" => text.push('∈'),
                "lim" => text.push_str("lim"),
                _ => {
                    text.push('\\');
                    text.push_str(name);
                }
            },
        }
    }
    text.push_str(rest);
    subscripts(&text)
}

/// What stands above and below in the name of a derivative, `\frac{\partial L}{\partial \dot q}`.
fn derivative(latex: &str) -> Option<(&str, &str)> {
    let above = latex.strip_prefix("\\frac{\\partial ")?;
    let close = matching(above)?;
    let below = above[close + 1..].strip_prefix("{\\partial ")?.strip_suffix('}')?;
    Some((&above[..close], below)).filter(|(above, below)| !above.contains("\\partial") && !below.contains("\\partial"))
}

/// A name in which a subscript has a number as its own subscript: `p_{θ_{1}}` becomes p_θ₁.
fn subscripts(name: &str) -> String {
    let Some((head, rest)) = name.split_once("_{") else { return name.to_owned() };
    let Some(close) = matching(rest) else { return name.to_owned() };
    let (inner, after) = (&rest[..close], subscripts(&rest[close + 1..]));
    let lowered = inner.split_once('_').and_then(|(letter, number)| {
        let number = number.strip_prefix('{').and_then(|number| number.strip_suffix('}')).unwrap_or(number);
        let digits: Option<String> = number.chars().map(|c| char::from_u32(u32::from('₀') + c.to_digit(10)?)).collect();
        Some(format!("{letter}{}", digits.filter(|digits| !digits.is_empty())?))
    });
    match lowered {
        Some(lowered) => format!("{head}_{lowered}{after}"),
        None => format!("{head}_{{{inner}}}{after}"),
    }
}

fn matching(inner: &str) -> Option<usize> {
    let mut depth = 0;
    inner.char_indices().find_map(|(at, c)| match c {
        '{' => {
            depth += 1;
            None
        }
        '}' if depth == 0 => Some(at),
        '}' => {
            depth -= 1;
            None
        }
        _ => None,
    })
}

fn mark(command: &str) -> Option<&'static str> {
    Some(match command {
        "dot" => "\u{307}",
        "ddot" => "\u{308}",
        "vec" => "\u{20d7}",
        "hat" => "\u{302}",
        "bar" => "\u{304}",
        "tilde" => "\u{303}",
        "mathbf" | "mathrm" | "mathbb" | "mathcal" => "",
        _ => return None,
    })
}

fn letter(command: &str) -> Option<char> {
    const LETTERS: [(&str, char); 50] = [
        ("sum", 'Σ'),
        ("prod", 'Π'),
        ("int", '∫'),
        ("oint", '∮'),
        ("iint", '∬'),
        ("nabla", '∇'),
        ("partial", '∂'),
        ("dots", '…'),
        ("cdot", '·'),
        ("alpha", 'α'),
        ("beta", 'β'),
        ("gamma", 'γ'),
        ("delta", 'δ'),
        ("epsilon", 'ϵ'),
        ("varepsilon", 'ε'),
        ("zeta", 'ζ'),
        ("eta", 'η'),
        ("theta", 'θ'),
        ("vartheta", 'ϑ'),
        ("iota", 'ι'),
        ("kappa", 'κ'),
        ("lambda", 'λ'),
        ("mu", 'μ'),
        ("nu", 'ν'),
        ("xi", 'ξ'),
        ("pi", 'π'),
        ("rho", 'ρ'),
        ("sigma", 'σ'),
        ("tau", 'τ'),
        ("upsilon", 'υ'),
        ("phi", 'φ'),
        ("varphi", 'ϕ'),
        ("chi", 'χ'),
        ("psi", 'ψ'),
        ("omega", 'ω'),
        ("Gamma", 'Γ'),
        ("Delta", 'Δ'),
        ("Theta", 'Θ'),
        ("Lambda", 'Λ'),
        ("Xi", 'Ξ'),
        ("Pi", 'Π'),
        ("Sigma", 'Σ'),
        ("Upsilon", 'Υ'),
        ("Phi", 'Φ'),
        ("Psi", 'Ψ'),
        ("Omega", 'Ω'),
        ("ell", 'ℓ'),
        ("hbar", 'ħ'),
        ("infty", '∞'),
        ("perp", '⊥'),
    ];
    LETTERS.iter().find(|(name, _)| *name == command).map(|(_, letter)| *letter)
}

/// A name with its overdots, as a combining mark over the letter.
pub fn with_dots(latex: &str, dots: u8) -> String {
    let name = plain(latex);
    let mark = match dots {
        0 => return name,
        1 => '\u{307}',
        2 => '\u{308}',
        3 => '\u{20db}',
        _ => '\u{20dc}',
    };
    let at = name.find('_').unwrap_or(name.len());
    format!("{}{mark}{}", &name[..at], &name[at..])
}
