//! A printed name as a symbol of the symbol table, with its superscript and a following parenthesis.
//!
//! Offers `symbol`, a method of the reader. Knows `applications`, the names and the state of the reader.

mod compound;
mod euler;

pub(super) use euler::is_a_number as e_is_a_number;

use crate::formula::symbols::{Kind, Name, SymbolId};
use crate::formula::text;
use crate::formula::tree::{Expr, Index, Node};
use crate::formula::units::Unit;
use crate::source::{Fault, Span};
use crate::suggest;

use super::super::arguments::distribution;
use super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::names::{self, Printed};
use super::items::{is_minus_one, is_transpose, whole_number};
use super::state::{Read, Reader};

impl Reader<'_> {
    /// A printed name as a symbol of the symbol table, with its superscript and a following parenthesis.
    pub(super) fn symbol(
        &mut self,
        span: Span,
        printed: Printed<'_>,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        let mut printed = self.decorated(printed, span)?;
        if self.symbols.open
            && let Some(name) = distribution(&printed, items.get(*cursor))
        {
            printed = Printed { name, dots: 0, sup: None };
        }
        let name = &printed.name;
        if let Some(value) = self.inferred_function(span, &printed, items, cursor)? {
            return Ok(value);
        }
        if let Some(power) = self.eulers_number(&printed, span, items.get(*cursor))? {
            return Ok(power);
        }
        // `[x_i, p_j] = i\delta_{ij}`
        let is_i = name.base == "i" && name.subscript.is_empty() && !self.bound.contains(&name.base);
        let is_unclear = || self.symbols.open && self.symbols.inferred.i_is_index && !self.is_imaginary_unit(name);
        let is_factor = || items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).nth(1).is_some();
        if is_i && is_unclear() && is_factor() {
            return Err(Fault::ambiguous(span, "i may be √−1, or the index i that other formulas have")
                .help("write \\mathrm{i} for √−1, and another letter for the index"));
        }
        if printed.dots == 0 && self.is_imaginary_unit(name) {
            let unit = Expr::new(Node::Imaginary, span);
            return match printed.sup {
                Some(sup) => self.raised(unit, sup, span),
                None => Ok(unit),
            };
        }
        if let Some(special) = self.special(&printed, span)? {
            return match printed.sup {
                Some(sup) => self.raised(special, sup, span),
                None => Ok(special),
            };
        }
        let dots = printed.dots;
        if let Some(function) = self.declared_function(&printed) {
            return self.function_value(function, &printed, span, items, cursor);
        }
        if let Some((id, indices)) = self.symbols.find_or_assemble(name) {
            if self.symbols.entry(id).squared {
                return self.introduced_by_square(id, indices, printed, span, items, cursor);
            }
            if self.symbols.entry(id).kind == Kind::Rotation {
                return self.rotation(id, printed.sup, span, items, cursor);
            }
            if indices.len() == 2
                && let Some(sup) = printed.sup
                && (is_transpose(sup) || is_minus_one(sup))
            {
                let whole = Box::new(Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, span));
                let node = if is_transpose(sup) { Node::Transpose(whole) } else { Node::Inverse(whole) };
                return Ok(Expr::new(Node::Entry(Box::new(Expr::new(node, span)), indices[0], indices[1]), span));
            }
            let symbol = Expr::new(Node::Symbol { id, indices, dots }, span);
            return self.applied(symbol, id, printed.sup, items, cursor);
        }
        if let Some((meaning, id)) = self.derived(name, span)? {
            self.note_derived(name, &meaning);
            return self.applied(differentiated(meaning, dots), id, printed.sup, items, cursor);
        }
        if name.subscript.is_empty()
            && name.primes == 0
            && let Some(id) = self.symbols.find_whole(&name.base)
        {
            let whole = Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, span);
            return self.applied(whole, id, printed.sup, items, cursor);
        }
        let other = self.conjugate_by_a_bar(name, dots, span);
        if let Some(found) = other.or_else(|| self.of_declared_matrix(name, span).filter(|_| dots == 0)) {
            return match printed.sup {
                Some(sup) => self.raised(found, sup, span),
                None => Ok(found),
            };
        }
        if self.symbols.open {
            return self.undeclared(printed, span, items, cursor);
        }
        if items.get(*cursor).is_some_and(|next| next.layout == Layout::Other('!')) {
            return Err(Fault::unsupported(span, "a factorial is not supported")
                .help("leave the equation out with \"skip\" in the claims file"));
        }
        let add = match items.get(*cursor).and_then(arguments).filter(|_| dots == 0) {
            Some(arguments) => suggest::function(&name.to_string(), &arguments),
            None => suggest::declaration(&name.to_string(), dots),
        };
        let unprimed = Name { primes: 0, ..name.clone() };
        if let (1..=2, Some((id, _))) = (name.primes, self.symbols.find(&unprimed))
            && self.symbols.entry(id).varies
        {
            let dot = if name.primes == 1 { "\\dot" } else { "\\ddot" };
            return Err(Fault::undeclared(span, name).help(format!(
                "for the time derivative of {unprimed}, write {dot}{{{unprimed}}}; for another symbol, {add}"
            )));
        }
        if let Some(vector) = self.vector_of_component(name) {
            return Err(Fault::undeclared(span, name).help(format!(
                "for a component of {vector}, add {}: \"along \\\\hat e_a\" with your axes under \"components\" in the \
                 claims file; for another symbol, {add}",
                suggest::in_json(&vector.to_string())
            )));
        }
        Err(Fault::undeclared(span, name).help(match self.symbols.nearest(name) {
            Some(near) => format!("did you mean {near}? If not, {add}"),
            None => add,
        }))
    }

    /// The declared vector of which a name with a number or an axis below it may be a component: `\vec\omega` of `\omega_3`.
    fn vector_of_component(&self, name: &Name) -> Option<Name> {
        let [label] = name.subscript.as_slice() else { return None };
        let mut vectors = ["\\vec", "\\mathbf", "\\boldsymbol", "\\bm"].into_iter().map(|arrow| {
            let text = format!("{arrow}{{{}}}", name.base);
            names::parse(&text).map(|(vector, _)| vector)
        });
        let is_label = ["1", "2", "3", "x", "y", "z"].contains(&label.as_str());
        vectors.find_map(|vector| vector.filter(|vector| is_label && self.symbols.find(vector).is_some()))
    }

    /// A name with dots that is declared with its dots, as `\dot{\vec v}` for the rate in turning axes, is that
    /// symbol.
    fn decorated<'i>(&self, printed: Printed<'i>, span: Span) -> Read<Printed<'i>> {
        let declared = |dots: u8| {
            let name = names::with_dots(&printed.name, dots)?;
            self.symbols.find(&name).map(|_| name)
        };
        match printed.dots {
            dots @ 1..=2 => match declared(dots) {
                Some(name) => Ok(Printed { name, dots: 0, sup: printed.sup }),
                None if dots == 2 && declared(1).is_some() => {
                    let once = declared(1).map_or_else(String::new, |name| name.to_string());
                    Err(Fault::ambiguous(
                        span,
                        format!("two dots may be a second derivative or the derivative of {once}, which is declared"),
                    )
                    .help(format!("write \\frac{{d}}{{dt}} {once}, or declare it with two dots too")))
                }
                None => Ok(printed),
            },
            _ => Ok(printed),
        }
    }

    /// A symbol that is defined by its square; without the square it is the root.
    fn introduced_by_square(
        &mut self,
        id: SymbolId,
        indices: Vec<Index>,
        printed: Printed<'_>,
        span: Span,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        let square = Expr::new(Node::Symbol { id, indices, dots: 0 }, span);
        if printed.dots == 0 && printed.sup.and_then(whole_number) == Some(2) {
            return self.applied(square, id, None, items, cursor);
        }
        let root = Expr::new(Node::Root(2, Box::new(square)), span);
        self.applied(differentiated(root, printed.dots), id, printed.sup, items, cursor)
    }

    /// Whether a printed name already has a meaning.
    pub(in super::super) fn is_known(&mut self, printed: &Printed<'_>, span: Span) -> bool {
        let name = &printed.name;
        self.symbols.find_or_assemble(name).is_some()
            || self.declared_function(printed).is_some()
            || self.special(printed, span).is_ok_and(|special| special.is_some())
            || !matches!(self.derived(name, span), Ok(None))
            || name.subscript.is_empty() && self.symbols.find_whole(&name.base).is_some()
    }

    /// An unknown letter in a formula without a claims file, which is a real number.
    fn undeclared(&mut self, printed: Printed<'_>, span: Span, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let name = &printed.name;
        let next = items.get(*cursor).filter(|item| names::printed(item, self.branch).is_some());
        let is_bound = self.bound.contains(&name.to_string());
        // `d^\dagger` is an operator.
        let is_bare = printed.sup.is_none_or(|sup| !matches!(contents(sup), [Item { layout: Layout::Command(_), .. }]));
        let is_d = matches!(name.base.as_str(), "d" | "\\mathrm{d}") && !self.symbols.inferred.has_factor_d;
        // `\mathrm{d}\langle E\rangle`
        if let Some(Item { layout: Layout::Fence(Delimiter::Angle, _), .. }) = items.get(*cursor)
            && is_d
            && name.subscript.is_empty()
            && printed.sup.is_none()
            && self.is_abstract()
        {
            let mean = self.item(&items[*cursor])?;
            *cursor += 1;
            let whole = span.to(mean.span);
            return Ok(self.template("d#", vec![mean], whole));
        }
        if is_d && name.subscript.is_empty() && next.is_some() && is_bare {
            return Err(Fault::ambiguous(span, "d x may be a differential or the product of d and x")
                .help("write \\frac{d}{dt} for a derivative, or use another letter for the factor"));
        }
        let factor = items
            .get(*cursor)
            .filter(|item| matches!(item.layout, Layout::Fence(..)) || names::printed(item, self.branch).is_some());
        if ["\\Sigma", "\\Pi"].contains(&name.base.as_str()) && name.primes == 0 && factor.is_some() {
            return Err(Fault::ambiguous(span, format!("{name} may be a sum, a product or a symbol"))
                .help("write \\sum_i or \\prod_i for the operation, and put a thin space \\, after a symbol"));
        }
        // No index multiplies a root.
        let is_before_root = items.get(*cursor).is_some_and(|next| matches!(next.layout, Layout::Root(..)));
        if !is_bound
            && (!self.is_abstract_index(name) || is_before_root)
            && name.subscript.is_empty()
            && ["i", "\\imath", "\\mathrm{i}"].contains(&name.base.as_str())
            && !(name.base == "i" && self.symbols.inferred.i_varies)
        {
            return Err(Fault::ambiguous(span, "i may be √−1 or a symbol").help(
                "for √−1 write \\mathrm{i}, or declare i as \"imaginary unit\" in a claims file; for a symbol, use another letter",
            ));
        }
        if name.base == "j" && name.subscript.is_empty() && items.get(*cursor).is_some_and(mentions_a_frequency) {
            return Err(Fault::ambiguous(span, "j before a frequency or an impedance may be √−1 or a symbol")
                .help("write i for √−1, or declare j as \"imaginary unit\" in a claims file"));
        }
        let is_acting = self.symbols.inferred.acting.contains(name);
        if self.is_abstract() && (name.base.starts_with("\\mathrm{") || is_acting) {
            let symbol = self.valueless(name.clone(), printed.dots, span)?;
            // `\langle\psi|A(t)|\psi\rangle`
            if let (true, None, Some(Item { layout: Layout::Fence(Delimiter::Round, inside), span: fence })) =
                (is_acting, printed.sup, items.get(*cursor))
                && matches!(inside.as_slice(), [only] if names::printed(only, None).is_some_and(|found| found.sup.is_none()))
            {
                *cursor += 1;
                let argument = self.sum(inside, *fence)?;
                return Ok(self.template("#(#)", vec![symbol, argument], span.to(*fence)));
            }
            return match printed.sup {
                Some(sup) => self.raised(symbol, sup, span),
                None => Ok(symbol),
            };
        }
        if name.base.starts_with("\\mathrm{") {
            let word = name.base.trim_start_matches("\\mathrm{").trim_end_matches('}');
            let what = match Unit::named(word) {
                Some(_) => format!("{word} may be a unit or a symbol"),
                None => format!("{word} is no unit, and may be a word or a symbol"),
            };
            return Err(Fault::ambiguous(span, what).help(
                "write a unit directly after its number; for a symbol, use a letter with a subscript, or declare the name in a claims file",
            ));
        }
        let twin = |primes: u8| Name { primes, ..name.clone() };
        let is_other = self.markup_of_a_vector(name)
            || self.symbols.inferred.letters.contains(&Name { primes: 0, ..name.clone() });
        let other =
            [0, 1].map(twin).into_iter().find(|twin| twin.primes != name.primes && self.symbols.find(twin).is_some());
        let is_vectorial = ["\\mathbf{", "\\vec{", "\\hat{"].iter().any(|mark| name.base.contains(mark));
        let has_matrices = self.symbols.inferred.has_transposes || self.symbols.inferred.has_tensors;
        let is_named = self.is_abstract() && (is_vectorial || has_matrices);
        // `d^3x'` is the measure of another place.
        let is_measure = name.base.starts_with("d^{");
        if !is_named && !is_measure && (name.primes > 1 || other.is_some() && !is_other) {
            let primed = text::plain(&Name { primes: 1, ..name.clone() }.to_string());
            return Err(Fault::ambiguous(
                span,
                format!("{primed} may be a derivative of {}, or another quantity", text::plain(&twin(0).to_string())),
            )
            .help(
                "write \\dot x or \\frac{dx}{dt} for a derivative by the time; for another symbol use \\tilde x or x_1",
            ));
        }
        // A hat on another letter marks an operator as often as a direction.
        let has_hat = name.base.starts_with("\\hat{");
        let is_operator = has_hat && self.symbols.inferred.has_operators;
        let is_vector = self.markup_of_a_vector(name)
            && !is_operator
            && (!has_hat
                || is_unit_vector(&name.base)
                || name.base.contains("\\vec{")
                || name.base.contains("\\mathbf{"));
        let has_markup = ["\\vec", "\\mathbf", "\\hat", "\\underline"].iter().any(|mark| name.base.contains(mark));
        // `\hat A(\theta + \epsilon)`: neither a name nor an operator alone stands in the parenthesis.
        if let Some(Item { layout: Layout::Fence(Delimiter::Round, inside), span: fence }) = items.get(*cursor)
            && has_hat
            && printed.sup.is_none()
            && self.is_abstract()
            && !is_vector
            && is_argument_of_an_operator(inside)
        {
            return Err(Fault::ambiguous(span.to(*fence), format!("{name}(…) may be a function or a product"))
                .help("for a product, put a thin space \\, before the parenthesis"));
        }
        if !is_vector && has_markup && self.is_abstract() {
            let symbol = self.valueless(name.clone(), printed.dots, span)?;
            // `\hat U(-t)`: where the name stands first it is read as where it stands again.
            return match (printed.sup, symbol.as_plain_symbol()) {
                (Some(sup), _) => self.raised(symbol, sup, span),
                (None, Some(id)) if has_hat => self.applied(symbol, id, None, items, cursor),
                (None, _) => Ok(symbol),
            };
        }
        if !is_vector && has_markup {
            return Err(match has_hat {
                true => Fault::ambiguous(span, format!("{name} may be an operator, a unit vector or a number")).help(
                    "operators are not supported; write a vector by its components, or declare it in a claims file",
                ),
                false => Fault::unsupported(span, format!("{name} is a vector, and its components are not known"))
                    .help("write its components, or declare the vector in a claims file"),
            });
        }
        // Wave functions are complex where anything is.
        let is_wave = self.symbols.imaginary_here && ["\\psi", "\\Psi"].contains(&name.base.as_str());
        let kind = match is_vector {
            true => Kind::Vector,
            false if is_wave => Kind::Complex,
            false => Kind::Scalar,
        };
        let Some(id) = self.symbols.add(name.clone(), kind) else {
            return Err(Fault::new(span, format!("{name} is already the name of another symbol"))
                .help("use another name for one of the two"));
        };
        // The letter of a sum is no quantity.
        self.symbols.entry_mut(id).hidden = is_bound;
        let symbol = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: printed.dots }, span);
        self.applied(symbol, id, printed.sup, items, cursor)
    }

    /// Whether a letter is an index in a display that is read for its structure.
    fn is_abstract_index(&self, name: &Name) -> bool {
        self.is_abstract() && self.symbols.inferred.index_letters.contains(&name.base)
    }

    /// Whether the markup of a name makes it a vector: an arrow, bold type, a hat over a small letter.
    fn markup_of_a_vector(&self, name: &Name) -> bool {
        let inferred = &self.symbols.inferred;
        let is_bold = name.base.contains("\\vec{") || name.base.contains("\\mathbf{");
        let small = name
            .base
            .strip_prefix("\\hat{")
            .is_some_and(|inner| inner.trim_start_matches('\\').starts_with(|c: char| c.is_lowercase()));
        inferred.active && !inferred.matrices.contains(&name.base) && (is_bold || small)
    }

    /// π, ε_abc and δ_ab, unless they are declared.
    fn special(&self, printed: &Printed<'_>, span: Span) -> Read<Option<Expr>> {
        let name = &printed.name;
        if printed.dots > 0 || name.primes > 0 || self.symbols.find(name).is_some() {
            return Ok(None);
        }
        let indices = |tokens: &[String]| -> Option<Vec<Index>> {
            let index = |token: &String| match self.symbols.index(token) {
                Some(id) => Some(Index::Letter(id)),
                None => token.parse().ok().filter(|n| (1..=3).contains(n)).map(Index::Fixed),
            };
            let found: Option<Vec<Index>> = tokens.iter().map(index).collect();
            found.filter(|found| found.iter().any(|index| matches!(index, Index::Letter(_))))
        };
        let node = match (name.base.as_str(), name.subscript.len()) {
            ("\\pi", 0) => Some(Node::Pi),
            ("\\epsilon" | "\\varepsilon", 3) => {
                indices(&name.subscript).and_then(|found| found.try_into().ok()).map(Node::Epsilon)
            }
            ("\\delta", 2) => indices(&name.subscript).and_then(|found| found.try_into().ok()).map(Node::Delta),
            _ => None,
        };
        Ok(node.map(|node| Expr::new(node, span)))
    }

    fn rotation(
        &mut self,
        id: SymbolId,
        sup: Option<&Item>,
        span: Span,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        let (item, above) = match items.get(*cursor) {
            // `\mathbf{R}_z(\psi)^T`: what stands above the parenthesis is meant for all of it.
            Some(Item { layout: Layout::Scripts { nucleus, sub: None, sup: Some(above), primes: 0 }, .. }) => {
                (Some(nucleus.as_ref()), Some(above.as_ref()))
            }
            item => (item, None),
        };
        let sup = sup.or(above);
        let Some(Item { layout: Layout::Fence(Delimiter::Round, inside), span: fence }) = item else {
            return Err(Fault::new(
                span,
                format!(
                    "{0} is a rotation, and needs its angle in parentheses, as in {0}(\\theta)",
                    self.symbols.entry(id).name
                ),
            ));
        };
        *cursor += 1;
        let angle = self.sum(inside, *fence)?;
        let applied = Expr::new(Node::Apply(id, vec![angle]), span.to(*fence));
        match sup {
            Some(sup) => self.raised(applied, sup, span.to(*fence)),
            None => Ok(applied),
        }
    }
}

/// Whether a sum of names without marks of operators is all that stands in a parenthesis: `(\theta + \epsilon)`, `(t - t_0)`.
fn is_argument_of_an_operator(inside: &[Item]) -> bool {
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
    let has_mark = |item: &Item| {
        names::printed(item, None).is_some_and(|found| {
            let base = &found.name.base;
            ["\\hat{", "\\mathbf{", "\\vec{", "\\mathcal{"].iter().any(|mark| base.contains(mark))
                || base.starts_with(char::is_uppercase)
        })
    };
    let has_state = inside.iter().any(|item| matches!(item.layout, Layout::Fence(Delimiter::Ket, _)));
    let begins_with_a_name = inside.first().is_some_and(|first| names::printed(first, None).is_some());
    begins_with_a_name && !has_state && inside.iter().skip(1).any(is_sign) && !inside.iter().any(has_mark)
}

/// The names in a parenthesis that holds nothing else, `(x, t)`: what stands before it is a function of them.
fn arguments(next: &Item) -> Option<Vec<String>> {
    let Layout::Fence(Delimiter::Round, inside) = &next.layout else { return None };
    let given = inside.split(|item| item.layout == Layout::Other(','));
    let name = |items: &[Item]| {
        let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let (only, None) = (solid.next()?, solid.next()) else { return None };
        let found = names::printed(only, None)?;
        (found.dots == 0 && found.sup.is_none()).then(|| found.name.to_string())
    };
    given.map(name).collect()
}

/// The `dots`-th time derivative.
fn differentiated(expr: Expr, dots: u8) -> Expr {
    let span = expr.span;
    if dots == 0 { expr } else { Expr::new(Node::TimeDerivative(dots, Box::new(expr)), span) }
}

/// Whether a name with a hat is one of the usual unit vectors: `\hat x`, `\hat r`, `\hat\theta`, `\hat e_x`, `\hat n`.
fn is_unit_vector(base: &str) -> bool {
    let letter = base.strip_prefix("\\hat{").and_then(|base| base.strip_suffix('}'));
    letter.is_some_and(|letter| {
        [
            "e", "n", "r", "i", "j", "k", "x", "y", "z", "s", "\\theta", "\\phi", "\\varphi", "\\rho", "\\imath",
            "\\jmath",
        ]
        .contains(&letter)
    })
}

/// Whether an item is an angular frequency, or a parenthesis with one in it.
fn mentions_a_frequency(item: &Item) -> bool {
    match &item.layout {
        Layout::Fence(_, inside) => inside.iter().any(mentions_a_frequency),
        _ => names::printed(item, None)
            .is_some_and(|printed| ["\\omega", "Z", "X"].contains(&printed.name.base.as_str())),
    }
}
