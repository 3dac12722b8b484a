//! A formula as readable Unicode text, with every product, argument and power explicit.
//!
//! The author reads it to see whether the formula was understood: `λ_1·θ̈ = λ_1·φ̇²·sin(θ)·cos(θ) − …`.

pub use super::glyphs::{plain, with_dots};
use super::ids::SymbolId;
use super::operators::Operator;
use super::symbols::Symbols;
use super::tree::{Branch, Condition, Excluded, Expr, Index, Node, Sign, Statement, Term};

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
        let conditions = Writer { symbols }.conditions(&statement.conditions);
        // `\text{in } \Omega` is shown with its own word.
        let has_word = ["in ", "on ", "as ", "at ", "for ", "if ", "when ", "whenever ", "provided "]
            .iter()
            .any(|word| conditions.starts_with(word));
        text.push_str(&format!("{}{conditions}", if has_word { " " } else { " for " }));
    }
    text
}

/// A formula as text.
pub fn formula(expr: &Expr, symbols: &Symbols) -> String {
    Writer { symbols }.write(expr, 0)
}

/// Ends the name of an operator, which so differs from that of a quantity; it is not shown.
pub const APPLICATION: char = '\u{2061}';

/// Whether an operator stands between its arguments, as ⊗ does.
pub(crate) fn is_infix(id: SymbolId, symbols: &Symbols) -> bool {
    let entry = symbols.entry(id);
    let name = entry.name.base.trim_end_matches(APPLICATION);
    entry.operator == Some(Operator::Template) && name.starts_with('#') && name.ends_with('#')
}

/// The first of the characters that stand for arguments while a template is written: those of private use.
const HOLES: u32 = 0xE000;

struct Writer<'a> {
    symbols: &'a Symbols,
}

/// The binding strength of a node: 1 for sums, 2 for products, 3 for powers, 4 for anything else.
fn binding(node: &Node, symbols: &Symbols) -> u8 {
    match node {
        Node::Symbol { id, .. } if symbols.entry(*id).squared || symbols.entry(*id).name.base.contains('/') => 3,
        Node::Symbol { id, .. } if symbols.entry(*id).name.base.starts_with("\\frac{") => 3,
        Node::Apply(id, _) if is_infix(*id, symbols) => 1,
        Node::Apply(id, _) if symbols.entry(*id).name.base.starts_with("\\frac{") => 2,
        Node::Sum(_) => 1,
        Node::Product(_) | Node::Quotient(..) | Node::Cross(..) | Node::Dot(..) => 2,
        Node::SumOver { .. } | Node::Integral(..) | Node::Shrinking(..) | Node::Definite(_) => 2,
        Node::Power(..) | Node::Transpose(_) | Node::Inverse(_) | Node::TimeDerivative(..) => 3,
        _ => 4,
    }
}

/// Whether a formula is a quotient of units, as in `9.8·m/s^2`.
fn is_quotient_of_units(expr: &Expr) -> bool {
    let is_unit = |side: &Expr| match &side.node {
        Node::Product(factors) => factors.iter().all(|factor| matches!(factor.node, Node::Unit(_) | Node::Power(..))),
        Node::Power(base, _) => matches!(base.node, Node::Unit(_)),
        node => matches!(node, Node::Unit(_)),
    };
    matches!(&expr.node, Node::Quotient(above, below) if is_unit(above) && is_unit(below))
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
            Node::Unit(unit) => unit.symbol(),
            Node::Symbol { id, indices, dots } => self.symbol(*id, indices, *dots),
            Node::Sum(terms) => self.sum(terms),
            Node::Product(factors) => self.product(factors),
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
            Node::Apply(id, given) => self.applied(*id, given),
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
            Node::Rest(_) => "…".into(),
            Node::Letter(name) => plain(name),
            Node::Definite(of) => {
                let end =
                    |end: &Option<Expr>, none: &str| end.as_ref().map_or(none.to_owned(), |end| self.write(end, 3));
                let letter = plain(&of.letter);
                let (lower, upper) = (end(&of.lower, "−∞"), end(&of.upper, "∞"));
                format!("∫_{lower}^{upper} {} d{letter}", self.write(&of.integrand, 1))
            }
        }
    }

    fn symbol(&self, id: SymbolId, indices: &[Index], dots: u8) -> String {
        let entry = self.symbols.entry(id);
        let mut name = entry.name.clone();
        if indices.is_empty() && !entry.slots.is_empty() {
            name.subscript.clear();
        } else {
            for ((at, _), index) in entry.slots.iter().zip(indices) {
                name.subscript[*at] = self.index(*index);
            }
        }
        with_dots(&name.to_string(), dots) + if entry.squared { "^2" } else { "" }
    }

    fn sum(&self, terms: &[Term]) -> String {
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

    fn product(&self, factors: &[Expr]) -> String {
        let mut text = String::new();
        for (at, factor) in factors.iter().enumerate() {
            // `45°`
            let is_sign = matches!(&factor.node, Node::Unit(unit) if unit.is_sign());
            if at > 0 && !is_sign {
                text.push('·');
            }
            let ends_with_units = at + 1 == factors.len() && is_quotient_of_units(factor);
            text.push_str(&self.write(factor, if ends_with_units { 1 } else { 2 }));
        }
        text
    }

    /// A function or an operator with its arguments.
    fn applied(&self, id: SymbolId, given: &[Expr]) -> String {
        let arguments: Vec<String> = given.iter().map(|a| self.bare(a)).collect();
        let entry = self.symbols.entry(id);
        let name = plain(&entry.name.to_string().replace(APPLICATION, ""));
        match (arguments.as_slice(), entry.operator) {
            (_, Some(Operator::Template)) => self.template(&entry.name.base, given),
            ([], Some(_)) => name,
            ([inner], Some(_)) if name.starts_with('|') => format!("({inner}){name}"),
            _ => format!("{name}({})", arguments.join(", ")),
        }
    }

    /// A template with its arguments in the place of each #.
    fn template(&self, template: &str, arguments: &[Expr]) -> String {
        let template = template.trim_end_matches(APPLICATION);
        let is_fraction = template.contains("\\frac{");
        let is_open =
            |at: usize| at == 0 && template.starts_with('#') || at + 1 == arguments.len() && template.ends_with('#');
        // A character that no text has stands for each argument until the rest is written.
        let hole = |at: usize| char::from_u32(HOLES + at as u32).unwrap_or(' ');
        let mut text = String::new();
        for (at, piece) in template.split('#').enumerate() {
            text.extend(at.checked_sub(1).map(hole));
            text.push_str(piece);
        }
        // A mark above a product prints as a word, as a combining mark would stand above its last letter only.
        for (at, argument) in arguments.iter().enumerate() {
            for (mark, word) in [("bar", "overline"), ("hat", "hat"), ("tilde", "tilde"), ("vec", "vec")] {
                let marked = format!("\\{mark}{{{}}}", hole(at));
                if text.contains(&marked) && !matches!(argument.node, Node::Symbol { .. } | Node::Number(_)) {
                    text = text.replacen(&marked, &format!("{word}({})", hole(at)), 1);
                }
            }
        }
        let mut text = plain(&text);
        for (at, argument) in arguments.iter().enumerate() {
            let is_enclosed = template.split('#').nth(at).is_some_and(|before| before.ends_with('('));
            let is_raised = at == 0 && template.starts_with('#') && !template.ends_with('#');
            // Statements of which one holds.
            let is_whole = ["\\text{ ", " \\lor ", " \\vee "].iter().any(|word| template.contains(word));
            let outer = match (is_raised, is_fraction && !is_enclosed || is_open(at)) {
                _ if is_whole => 0,
                (true, _) => 3,
                (false, true) => 2,
                (false, false) => 0,
            };
            let written = self.write(argument, outer);
            text = text.replacen(hole(at), &written, 1);
        }
        text
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
