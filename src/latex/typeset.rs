//! The writer of formulas as LaTeX that is read back as the same formula.
//!
//! The text is unambiguous first, and short second. The argument of a function is in parentheses unless it is one
//! angle. A thin space separates factors, and a product within a product keeps its parentheses.

use crate::formula::symbols::{Operator, SymbolId, Symbols};
use crate::formula::text::{APPLICATION, is_infix};
use crate::formula::tree::{Branch, ComplexPart, Condition, Excluded, Expr, Index, IndexId, Node, Sign, Term};

use super::names::{self, unaccented};

/// Typesets a formula.
pub fn typeset(expr: &Expr, symbols: &Symbols) -> String {
    Typesetter { symbols }.bare(expr)
}

struct Typesetter<'a> {
    symbols: &'a Symbols,
}

impl Typesetter<'_> {
    /// As a factor of a product, or the base of a power where `raised`.
    fn factor(&self, expr: &Expr, raised: bool) -> String {
        let text = self.bare(expr);
        let enclose = match &expr.node {
            Node::Sum(_)
            | Node::Product(_)
            | Node::Cross(..)
            | Node::Dot(..)
            | Node::SumOver { .. }
            | Node::Integral(..)
            | Node::Definite(_)
            | Node::Shrinking(..) => true,
            Node::TimeDerivative(..) | Node::Quotient(..) | Node::Power(..) | Node::Call(..) => raised,
            Node::Transpose(_) | Node::Inverse(_) | Node::Entry(..) | Node::Root(..) | Node::Matrix(_) => raised,
            Node::Component(..) => raised,
            Node::Symbol { id, .. } => raised && self.symbols.entry(*id).squared,
            Node::Apply(id, _) => is_infix(*id, self.symbols),
            _ => false,
        };
        if enclose { format!("\\left({text}\\right)") } else { text }
    }

    /// A row of `cases`.
    fn branch(&self, branch: &Branch) -> String {
        let value = self.bare(&branch.value);
        let condition = |condition: &Condition| {
            let mut text = String::new();
            for (at, member) in condition.members.iter().enumerate() {
                if at > 0 {
                    text.push_str(condition.relations[at - 1].command());
                }
                text.push_str(&self.bare(member));
            }
            text
        };
        match branch.conditions.as_slice() {
            [] => format!("{value} & \\text{{otherwise}}"),
            all => format!("{value} & {}", all.iter().map(condition).collect::<Vec<_>>().join(" \\text{ and } ")),
        }
    }

    /// A template with its arguments in the place of each #.
    fn template(&self, template: &str, arguments: &[Expr]) -> String {
        let template = template.trim_end_matches(APPLICATION);
        let mut text = String::new();
        for (at, piece) in template.split('#').enumerate() {
            if let Some(argument) = at.checked_sub(1).and_then(|at| arguments.get(at)) {
                let is_open = at == 1 && template.starts_with('#') || at == arguments.len() && template.ends_with('#');
                text.push_str(&if is_open { self.factor(argument, true) } else { self.bare(argument) });
            }
            text.push_str(piece);
        }
        text
    }

    fn bare(&self, expr: &Expr) -> String {
        match &expr.node {
            Node::Number(text) => text.clone(),
            Node::Pi => "\\pi".into(),
            Node::Euler => "e".into(),
            Node::Unit(unit) => format!("\\,\\text{{{}}}", unit.symbol()),
            Node::Symbol { id, indices, dots } => self.symbol(*id, indices, *dots),
            Node::Sum(terms) => self.sum(terms),
            Node::Product(factors) => self.product(factors),
            Node::Quotient(a, b) => format!("\\frac{{{}}}{{{}}}", self.bare(a), self.bare(b)),
            Node::Power(base, exponent) => match &base.node {
                Node::Call(function, argument) if exponent.as_digits().is_some() => {
                    format!("\\{}^{{{}}}{}", function.name(), self.bare(exponent), self.argument(argument))
                }
                _ => format!("{}^{{{}}}", self.factor(base, true), self.bare(exponent)),
            },
            Node::Root(2, a) => format!("\\sqrt{{{}}}", self.bare(a)),
            Node::Root(n, a) => format!("\\sqrt[{n}]{{{}}}", self.bare(a)),
            Node::Call(function, a) => format!("\\{}{}", function.name(), self.argument(a)),
            Node::Apply(id, given) if self.symbols.entry(*id).operator == Some(Operator::Template) => {
                self.template(&self.symbols.entry(*id).name.base, given)
            }
            Node::Apply(id, arguments) => self.applied(*id, arguments),
            Node::TimeDerivative(1, a) => format!("\\frac{{d}}{{dt}}\\left({}\\right)", self.bare(a)),
            Node::TimeDerivative(n, a) => format!("\\frac{{d^{n}}}{{dt^{n}}}\\left({}\\right)", self.bare(a)),
            Node::Norm(a) => format!("\\left|{}\\right|", self.bare(a)),
            Node::Cross(a, b) => format!("{} \\times {}", self.factor(a, false), self.factor(b, false)),
            Node::Dot(a, b) => format!("{} \\cdot {}", self.factor(a, false), self.factor(b, false)),
            Node::Matrix(rows) => {
                let rows: Vec<String> = rows
                    .iter()
                    .map(|row| row.iter().map(|entry| self.bare(entry)).collect::<Vec<_>>().join(" & "))
                    .collect();
                format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", rows.join(" \\\\ "))
            }
            Node::Transpose(a) => format!("{}^{{T}}", self.factor(a, true)),
            Node::Inverse(a) => format!("{}^{{-1}}", self.factor(a, true)),
            Node::Identity => "\\mathbb{1}".into(),
            Node::Imaginary => "\\mathrm{i}".into(),
            Node::OfMatrix(function, a) => format!("{}\\left({}\\right)", function.command(), self.bare(a)),
            Node::Complex(ComplexPart::Conjugate, a) => format!("\\overline{{{}}}", self.bare(a)),
            Node::Complex(part, a) => format!("\\operatorname{{{}}}\\left({}\\right)", part.name(), self.bare(a)),
            Node::Commutator(a, b) => format!("\\left[{}, {}\\right]", self.bare(a), self.bare(b)),
            Node::Cases(branches) => {
                let rows: Vec<String> = branches.iter().map(|branch| self.branch(branch)).collect();
                format!("\\begin{{cases}} {} \\end{{cases}}", rows.join(" \\\\ "))
            }
            Node::Entry(a, i, j) => self.entry(a, &[*i, *j]),
            Node::Epsilon(indices) => format!("\\epsilon_{{{}}}", self.indices(indices)),
            Node::Delta(indices) => format!("\\delta_{{{}}}", self.indices(indices)),
            Node::SumOver { body, implied: true, .. } => self.bare(body),
            Node::SumOver { index, except, within, body, .. } => self.sum_over(*index, except, *within, body),
            Node::Integral(region, a) => {
                let entry = self.symbols.entry(*region);
                let letter = entry.argument.as_ref().map(|argument| unaccented(argument).to_string());
                let power = entry.measure.filter(|measure| *measure != 1).map(|measure| format!("^{measure}"));
                let (letter, power) = (letter.unwrap_or_default(), power.unwrap_or_default());
                format!("\\int_{{{}}} {} \\, d{power} {letter}", entry.name, self.body(a))
            }
            Node::Shrinking(region, a) => {
                format!("\\lim_{{{} \\to 0}} {}", self.region(*region), self.body(a))
            }
            Node::Component(a, index) => format!("\\left({}\\right)_{{{}}}", self.bare(a), self.index(*index)),
            Node::Rest(_) => "\\dots".into(),
            Node::Letter(name) => name.clone(),
            Node::Definite(of) => {
                let end = |end: &Option<Expr>, none: &str| end.as_ref().map_or(none.to_owned(), |end| self.bare(end));
                let (lower, upper) = (end(&of.lower, "-\\infty"), end(&of.upper, "\\infty"));
                let letter = &of.letter;
                format!("\\int_{{{lower}}}^{{{upper}}} {} \\, d{letter}", self.body(&of.integrand))
            }
        }
    }

    fn sum(&self, terms: &[Term]) -> String {
        let mut text = String::new();
        for (at, term) in terms.iter().enumerate() {
            text.push_str(match (term.sign, at) {
                (Sign::Plus, 0) => "",
                (Sign::Minus, 0) => "-",
                (Sign::Plus, _) => " + ",
                (Sign::Minus, _) => " - ",
            });
            let inner = self.bare(&term.expr);
            match &term.expr.node {
                Node::Sum(_) => text.push_str(&format!("\\left({inner}\\right)")),
                _ => text.push_str(&inner),
            }
        }
        text
    }

    fn product(&self, factors: &[Expr]) -> String {
        let mut text = String::new();
        for (at, factor) in factors.iter().enumerate() {
            let piece = self.factor(factor, false);
            if at > 0 {
                // A number must not run on into the one before, nor a name into a command or a call.
                let run_on = matches!(factors[at - 1].node, Node::Number(_))
                    && matches!(factor.node, Node::Quotient(..) | Node::Root(..));
                let digits = piece.starts_with(|c: char| c.is_ascii_digit());
                text.push_str(if digits || run_on { " \\cdot " } else { " \\, " });
            }
            text.push_str(&piece);
        }
        text
    }

    /// A function or an operator with its arguments.
    fn applied(&self, id: SymbolId, arguments: &[Expr]) -> String {
        let arguments: Vec<String> = arguments.iter().map(|a| self.bare(a)).collect();
        let entry = self.symbols.entry(id);
        let name = entry.name.to_string().replace(APPLICATION, "");
        match arguments.as_slice() {
            [] => name,
            [inner] if name.starts_with('|') => format!("\\left.{inner}\\right{name}"),
            _ => format!("{name}\\left({}\\right)", arguments.join(", ")),
        }
    }

    /// An entry of a matrix; that of a transpose or an inverse as the notes write it, `R^T_{ab}`.
    fn entry(&self, matrix: &Expr, indices: &[Index]) -> String {
        if let Node::Transpose(inner) | Node::Inverse(inner) = &matrix.node
            && let Node::Symbol { id, dots, indices: none } = &inner.node
            && none.is_empty()
            && self.symbols.entry(*id).slots.len() == 2
        {
            let above = if matches!(matrix.node, Node::Transpose(_)) { "T" } else { "-1" };
            return format!("{}^{{{above}}}", self.symbol(*id, indices, *dots));
        }
        format!("\\left({}\\right)_{{{}}}", self.bare(matrix), self.indices(indices))
    }

    /// A sum over an index, with what is left out of it below the Σ or above.
    fn sum_over(&self, index: IndexId, except: &[Excluded], within: Option<SymbolId>, body: &Expr) -> String {
        let letter = &self.symbols.indices[index.0].letter;
        let mut clauses = String::new();
        let mut upper = String::new();
        for left_out in except {
            let separator = if clauses.is_empty() && within.is_none() { String::new() } else { format!(", {letter}") };
            let clause = match left_out {
                Excluded::Value(other) => format!("\\neq {}", self.index(*other)),
                Excluded::From(other) => format!("< {}", self.index(*other)),
                Excluded::UpTo(Index::Fixed(value)) => format!("= {}", value + 1),
                Excluded::UpTo(other) => format!("> {}", self.index(*other)),
                Excluded::Last(less) => {
                    let entry = &self.symbols.indices[index.0];
                    let count = entry.count.map(|count| self.symbols.entry(count).name.to_string());
                    upper = format!("^{{{} - {less}}}", count.unwrap_or_else(|| entry.upper.to_string()));
                    continue;
                }
            };
            clauses += &format!("{separator} {clause}");
        }
        let except = clauses;
        let within = within.map_or_else(String::new, |region| format!(" \\in {}", self.region(region)));
        format!("\\sum_{{{letter}{within}{except}}}{upper} {}", self.body(body))
    }

    /// The argument of a function: in parentheses, unless it is a symbol declared as an angle.
    fn argument(&self, argument: &Expr) -> String {
        let text = self.bare(argument);
        let entry = argument.as_plain_symbol().map(|id| self.symbols.entry(id));
        match entry.filter(|entry| entry.angle && entry.slots.is_empty() && !entry.squared && entry.name.primes == 0) {
            Some(_) if text.starts_with('\\') => text,
            Some(_) => format!(" {text}"),
            None => format!("\\left({text}\\right)"),
        }
    }

    /// The operand of an operator that acts to the end of the term.
    fn body(&self, body: &Expr) -> String {
        match &body.node {
            Node::Sum(_) => format!("\\left({}\\right)", self.bare(body)),
            _ => self.bare(body),
        }
    }

    /// A continuum, with its argument.
    fn region(&self, id: crate::formula::SymbolId) -> String {
        let entry = self.symbols.entry(id);
        match &entry.argument {
            Some(argument) => format!("{}({argument})", entry.name),
            None => entry.name.to_string(),
        }
    }

    fn symbol(&self, id: crate::formula::SymbolId, indices: &[Index], dots: u8) -> String {
        let entry = self.symbols.entry(id);
        let mut name = entry.name.clone();
        if indices.is_empty() && !entry.slots.is_empty() {
            name.subscript.clear();
        }
        for ((at, _), index) in entry.slots.iter().zip(indices) {
            name.subscript[*at] = self.index(*index);
        }
        if entry.squared {
            let square = format!("{name}^{{2}}");
            let derivative = || format!("\\frac{{d^{dots}}}{{dt^{dots}}}\\left({square}\\right)");
            return if dots == 0 { square } else { derivative() };
        }
        match names::with_dots(&name, dots) {
            Some(name) => name.to_string(),
            None => format!("\\frac{{d^{dots}}}{{dt^{dots}}}\\left({name}\\right)"),
        }
    }

    fn indices(&self, indices: &[Index]) -> String {
        indices.iter().map(|index| self.index(*index)).collect()
    }

    fn index(&self, index: Index) -> String {
        match index {
            Index::Letter(id) => self.symbols.indices[id.0].letter.clone(),
            Index::Fixed(value) => value.to_string(),
        }
    }
}
