//! A typeset formula to its one meaning.
//!
//! # The rules
//!
//! *Products.* Letters side by side are factors, `MgR` is three; a declared name is always one symbol, with its accents
//! and its subscript. A parenthesis after a symbol is a factor too, `\lambda_1(…)`, unless it holds a lone name:
//! `f(x)` could be a call, and is refused.
//!
//! *Functions.* `\sin(…)` and `\sin{…}` take what is enclosed. Otherwise the argument is what follows at once; it ends at a
//! typeset space, another function, a dotted symbol, a sign, a relation. Of several symbols (`\cos\theta p_\psi`,
//! `\cos\omega t`) the argument is as far as the first one declared to be an angle; where none is, only a
//! frequency times the time is read (`\omega t`), and all else refused.
//!
//! *Refused, since people read them in two ways:* `a/bc`, `a/b/c`, `\cos\theta/2`, `\sin\theta^2`, `\sin^{-1}x`,
//! `\log x`, `e^2`, a differential `dx` outside of `\frac{d}{dt}`.
//!
//! *One meaning by convention:* `-x^2` is −(x²); `\dot x^2` is (ẋ)²; `\Delta x` is one symbol; `\frac{d}{dt}` acts on
//! the parenthesis, or on the one factor, after it; `\vec v^2` is **v**·**v**; e with a symbolic exponent is exp.

use crate::formula::shape::{self, Shape};
use crate::formula::symbols::{Kind, Name, SymbolId, Symbols};
use crate::formula::tree::{Expr, Function, Index, Node, Sign, Term};
use crate::source::{Fault, Span};

use super::layout::{Delimiter, Item, Layout, layout};
use super::lexer::{Space, tokens};
use super::macros::Macros;
use super::names::{self, Printed};

/// Reads one formula, without relations, and checks its type.
pub fn read_formula(text: &str, symbols: &mut Symbols, macros: &Macros) -> Result<Expr, Fault> {
    let mut items = typeset_items(text, macros)?;
    while items.last().is_some_and(|item| matches!(item.layout, Layout::Space(_) | Layout::Other('.' | ',' | ';'))) {
        items.pop();
    }
    let mut reader = Reader { symbols, branch: None };
    let expr = reader.sum(&items, Span::at(text.len()))?;
    shape::bind(expr, symbols).map(|(expr, _)| expr)
}

/// The text as typeset items, macros expanded.
pub(super) fn typeset_items(text: &str, macros: &Macros) -> Result<Vec<Item>, Fault> {
    const LONGEST: usize = 1 << 18;
    if text.len() > LONGEST {
        return Err(Fault::new(Span::new(0, LONGEST), format!("a formula of more than {LONGEST} bytes"))
            .help("split it into several equations"));
    }
    Ok(layout(&macros.expand(tokens(text))?, text.len()))
}

/// Gives items a meaning, with the symbols of a document.
pub(super) struct Reader<'a> {
    pub symbols: &'a mut Symbols,
    /// The sign that `\pm` stands for.
    pub branch: Option<Sign>,
}

/// How factors are joined to those before them.
#[derive(Clone, Copy, PartialEq)]
enum Joint {
    Beside,
    CDot,
    Times,
    Slash,
}

type Read<T> = Result<T, Fault>;

impl Reader<'_> {
    /// Terms with their signs; all of `items`. `end` is where a fault of absence is put.
    pub fn sum(&mut self, items: &[Item], end: Span) -> Read<Expr> {
        let whole = extent(items).unwrap_or(end);
        let mut terms: Vec<Term> = Vec::new();
        let mut at = 0;
        let mut pending: Option<(Sign, Span)> = None;
        while at < items.len() {
            if let Some(sign) = self.sign(&items[at])? {
                if let Some((_, first)) = pending {
                    return Err(Fault::new(first.to(items[at].span), "two signs in a row"));
                }
                pending = Some((sign, items[at].span));
                at += 1;
                continue;
            }
            let length = self.term_length(&items[at..])?;
            let slice = &items[at..at + length];
            at += length;
            if slice.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
                continue;
            }
            if pending.is_none() && !terms.is_empty() {
                return Err(Fault::new(slice[0].span, "a sign is missing before this"));
            }
            let (sign, sign_span) = pending.take().map_or((Sign::Plus, None), |(sign, span)| (sign, Some(span)));
            terms.push(Term { sign, sign_span, expr: self.term(slice)? });
        }
        if let Some((_, span)) = pending {
            return Err(Fault::new(span, "nothing follows this sign"));
        }
        match terms.len() {
            0 => Err(Fault::new(whole, "a formula is missing here")),
            1 if terms[0].sign == Sign::Plus => Ok(terms.remove(0).expr),
            _ => Ok(Expr::new(Node::Sum(terms), whole)),
        }
    }

    fn sign(&self, item: &Item) -> Read<Option<Sign>> {
        Ok(match &item.layout {
            Layout::Other('+') => Some(Sign::Plus),
            Layout::Other('-') => Some(Sign::Minus),
            Layout::Command(name) if name == "\\pm" || name == "\\mp" => {
                let upper = self.branch.ok_or_else(|| {
                    Fault::new(item.span, "± stands for two formulas, and only one is asked for")
                        .help("write the branch that you mean")
                })?;
                Some(if name == "\\pm" { upper } else { upper.flipped() })
            }
            _ => None,
        })
    }

    /// How many items belong to the term that starts here: up to a sign that does not follow an operator.
    fn term_length(&self, items: &[Item]) -> Read<usize> {
        let mut after_operator = false;
        for (at, item) in items.iter().enumerate() {
            if self.sign(item)?.is_some() {
                if after_operator {
                    return Err(
                        Fault::new(item.span, "a sign after an operator").help("put the signed factor in parentheses")
                    );
                }
                return Ok(at);
            }
            if !matches!(item.layout, Layout::Space(_)) {
                after_operator = joint(item).is_some();
            }
        }
        Ok(items.len())
    }

    /// Factors and what joins them; all of `items`.
    fn term(&mut self, items: &[Item]) -> Read<Expr> {
        let whole = extent(items).unwrap_or_default();
        // Factors between one `\cdot` or `\times` and the next stand side by side.
        let mut runs: Vec<(Joint, Vec<Expr>)> = vec![(Joint::Beside, Vec::new())];
        let mut next = Joint::Beside;
        let mut operator: Option<Span> = None;
        let mut after_slash: Option<Span> = None;
        // The span of the last factor if it is a function whose argument nothing encloses.
        let mut open_function: Option<Span> = None;
        let mut cursor = 0;
        while cursor < items.len() {
            let item = &items[cursor];
            if matches!(item.layout, Layout::Space(_)) {
                cursor += 1;
                continue;
            }
            if let Some(found) = joint(item) {
                let empty = runs.last().is_none_or(|(_, run)| run.is_empty());
                if operator.is_some() || empty {
                    return Err(Fault::new(item.span, "a factor is missing before this operator"));
                }
                if found == Joint::Slash {
                    if let Some(function) = open_function {
                        return Err(Fault::new(
                            function.to(item.span),
                            "does this divide the function or its argument?",
                        )
                        .help("put the argument in parentheses, or use \\frac"));
                    }
                    if after_slash.is_some() {
                        return Err(two_ways(item.span, "a/b/c"));
                    }
                }
                next = found;
                operator = Some(item.span);
                cursor += 1;
                continue;
            }
            if let (Joint::Beside, Some(slash)) = (next, after_slash) {
                return Err(two_ways(slash.to(item.span), "a/bc").help("write \\frac{a}{bc} or \\frac{a}{b}c"));
            }
            let start = cursor;
            let (factor, enclosed) = self.factor(items, &mut cursor)?;
            if matches!(item.layout, Layout::Group(_)) && matches!(factor.node, Node::Sum(_)) && items.len() > 1 {
                return Err(two_ways(factor.span, "a sum in braces, which do not print").help("use parentheses"));
            }
            if next == Joint::Beside && !runs.last().is_none_or(|(_, run)| run.is_empty()) {
                self.run_together(items, start)?;
            }
            open_function = (!enclosed).then_some(factor.span);
            let run = match runs.last_mut() {
                Some((_, run)) if matches!(next, Joint::Beside | Joint::Slash) => run,
                _ => {
                    runs.push((next, Vec::new()));
                    &mut runs.last_mut().expect("pushed just now").1
                }
            };
            if next == Joint::Slash {
                let numerator = beside(std::mem::take(run));
                let span = numerator.span.to(factor.span);
                run.push(Expr::new(Node::Quotient(Box::new(numerator), Box::new(factor)), span));
                after_slash = Some(items[start].span);
            } else {
                run.push(factor);
                after_slash = None;
            }
            next = Joint::Beside;
            operator = None;
        }
        if let Some(span) = operator {
            return Err(Fault::new(span, "nothing follows this operator"));
        }
        self.join(runs, whole)
    }

    /// Refuses factors side by side that print as something else: `2 3`, `2\frac12`, `|a|b|c|`.
    fn run_together(&self, items: &[Item], at: usize) -> Read<()> {
        let before = items[..at].iter().rev().find(|item| !matches!(item.layout, Layout::Space(_)));
        let Some(before) = before else { return Ok(()) };
        let item = &items[at];
        let span = before.span.to(item.span);
        if matches!(before.layout, Layout::Number(_)) && (is_numeric_item(item) || is_number(item)) {
            return Err(two_ways(span, "a number beside a number").help("write \\cdot between them"));
        }
        let is_bar = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::PlainBar, _));
        if is_bar(item) && !is_bar(before) && items[..at].iter().any(is_bar) {
            return Err(two_ways(span, "which of these bars belong together").help("use \\left| and \\right|"));
        }
        Ok(())
    }

    /// Joins runs of factors by `\times` (first) and `\cdot`; of numbers both are plain products.
    fn join(&self, runs: Vec<(Joint, Vec<Expr>)>, whole: Span) -> Read<Expr> {
        if runs.len() == 1 {
            let mut expr = beside(runs.into_iter().flat_map(|(_, run)| run).collect());
            expr.span = whole;
            return Ok(expr);
        }
        let factors: Vec<Expr> = runs.iter().flat_map(|(_, run)| run.iter().cloned()).collect();
        let mut parts: Vec<(Joint, Expr, bool)> = Vec::new();
        for (joint, run) in runs {
            let expr = beside(run);
            let is_vector = shape::shape_of(&expr, self.symbols)? == Shape::Vector;
            parts.push((joint, expr, is_vector));
        }
        if parts.iter().filter(|(_, _, is_vector)| *is_vector).count() < 2 {
            return Ok(Expr::new(Node::Product(factors), whole));
        }
        for (joint, make) in [(Joint::Times, Node::Cross as fn(_, _) -> _), (Joint::CDot, Node::Dot as fn(_, _) -> _)] {
            let mut folded: Vec<(Joint, Expr, bool)> = Vec::new();
            let mut previous_was_cross = false;
            for (found, expr, is_vector) in parts {
                match folded.last_mut() {
                    Some(last) if found == joint && last.2 && is_vector => {
                        if previous_was_cross {
                            return Err(two_ways(last.1.span.to(expr.span), "a × b × c").help("put parentheses"));
                        }
                        let span = last.1.span.to(expr.span);
                        let left = std::mem::replace(&mut last.1, Expr::integer(0, span));
                        last.1 = Expr::new(make(Box::new(left), Box::new(expr)), span);
                        last.2 = joint == Joint::Times;
                        previous_was_cross = joint == Joint::Times;
                    }
                    _ => {
                        folded.push((found, expr, is_vector));
                        previous_was_cross = false;
                    }
                }
            }
            parts = folded;
        }
        let mut expr = beside(parts.into_iter().map(|(_, expr, _)| expr).collect());
        expr.span = whole;
        Ok(expr)
    }

    /// One factor; the flag is false when it is a function whose argument nothing encloses.
    fn factor(&mut self, items: &[Item], cursor: &mut usize) -> Read<(Expr, bool)> {
        let item = &items[*cursor];
        if let Some((function, power)) = function_head(item)? {
            *cursor += 1;
            return self.call(function, power, item.span, items, cursor);
        }
        if is_big_sum(item) {
            let rest = &items[*cursor + 1..];
            *cursor = items.len();
            return Ok((self.big_sum(item, rest)?, true));
        }
        if let Some(order) = self.derivative_slash(items, *cursor) {
            let span = item.span.to(items[*cursor + 4].span);
            let inner = self.item(&items[*cursor + 1])?;
            *cursor += 5;
            return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), span), true));
        }
        if let Layout::Fraction(numerator, denominator) = &item.layout
            && let Some((order, rest)) = self.derivative(numerator, denominator)?
        {
            *cursor += 1;
            if !rest.is_empty() {
                let inner = self.sum(rest, item.span)?;
                return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), item.span), true));
            }
            let inner = self.operand(items, cursor, item.span)?;
            let span = item.span.to(inner.span);
            return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), span), true));
        }
        if let Some(compound) = self.compound(items, cursor)? {
            return Ok((compound, true));
        }
        *cursor += 1;
        if let Some(printed) = names::printed(item, self.branch) {
            return Ok((self.symbol(item.span, printed, items, cursor)?, true));
        }
        Ok((self.item(item)?, true))
    }

    /// A single item as a formula.
    fn item(&mut self, item: &Item) -> Read<Expr> {
        let span = item.span;
        if let Some(printed) = names::printed(item, self.branch) {
            return self.symbol(span, printed, &[], &mut 0);
        }
        match &item.layout {
            Layout::Fault(fault) => Err(fault.clone()),
            Layout::Number(digits) => {
                if digits.parse::<f64>().is_ok_and(f64::is_finite) {
                    Ok(Expr::new(Node::Number(digits.clone()), span))
                } else {
                    Err(Fault::new(span, "this number is too large to compute with"))
                }
            }
            Layout::Group(items) => self.sum(items, span),
            Layout::Fence(delimiter, items) => self.fence(*delimiter, items, span),
            Layout::Fraction(numerator, denominator) => {
                if starts_differential(numerator) || starts_differential(denominator) {
                    return Err(Fault::new(span, "a derivative by something other than the time is not read"));
                }
                let (a, b) = (self.item(numerator)?, self.item(denominator)?);
                Ok(Expr::new(Node::Quotient(Box::new(a), Box::new(b)), span))
            }
            Layout::Root(index, radicand) => {
                let degree = match index.as_deref().map(|index| whole_number(index).ok_or(index.span)) {
                    None => 2,
                    Some(Ok(degree)) if degree >= 2 => degree,
                    Some(Ok(_)) => return Err(Fault::new(span, "the index of a root is a whole number from 2 up")),
                    Some(Err(span)) => return Err(Fault::new(span, "the index of a root is a whole number from 2 up")),
                };
                Ok(Expr::new(Node::Root(degree, Box::new(self.item(radicand)?)), span))
            }
            Layout::Accent(command, inner) if matches!(command.as_str(), "\\dot" | "\\ddot" | "\\dddot") => {
                let order = command.matches('d').count() as u8;
                Ok(Expr::new(Node::TimeDerivative(order, Box::new(self.item(inner)?)), span))
            }
            Layout::Environment(name, rows) => self.matrix(name, rows, span),
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => {
                let base = self.item(nucleus)?;
                if matches!(nucleus.layout, Layout::Group(_)) && matches!(base.node, Node::Sum(_) | Node::Product(_)) {
                    return Err(two_ways(span, "a power of braces, which do not print").help("use parentheses"));
                }
                self.raised(base, sup, span)
            }
            Layout::Scripts { nucleus, sub, .. } => match (&nucleus.layout, sub) {
                (Layout::Fault(fault), _) => Err(fault.clone()),
                (Layout::Command(name), _) => Err(unknown_command(name, nucleus.span)),
                (_, Some(sub)) => Err(Fault::new(sub.span, "a subscript on something that is not a symbol")),
                _ => Err(Fault::new(span, "a prime on something that is not a symbol")),
            },
            Layout::Command(name) => Err(unknown_command(name, span)),
            Layout::Style(name, _) | Layout::Accent(name, _) => {
                Err(Fault::new(span, format!("{name} of this has no meaning here")))
            }
            Layout::Text(word) => Err(Fault::new(span, format!("the words “{word}” have no meaning here"))),
            Layout::Other(c) => Err(Fault::new(span, format!("“{c}” is not understood here"))),
            Layout::Letter(_) | Layout::Space(_) | Layout::Row | Layout::Align => {
                Err(Fault::new(span, "this is not understood here"))
            }
        }
    }

    fn fence(&mut self, delimiter: Delimiter, items: &[Item], span: Span) -> Read<Expr> {
        if let [Item { layout: Layout::Environment(name, rows), .. }] = items
            && matches!(delimiter, Delimiter::Round | Delimiter::Square)
        {
            return self.matrix(name, rows, span);
        }
        match delimiter {
            Delimiter::Round | Delimiter::Square | Delimiter::Curly => {
                let mut inner = self.sum(items, span)?;
                inner.span = span;
                Ok(inner)
            }
            Delimiter::Bar | Delimiter::PlainBar | Delimiter::DoubleBar => {
                Ok(Expr::new(Node::Norm(Box::new(self.sum(items, span)?)), span))
            }
            Delimiter::Angle => Err(Fault::new(span, "angle brackets have no meaning here")),
        }
    }

    fn matrix(&mut self, name: &str, rows: &[Vec<Vec<Item>>], span: Span) -> Read<Expr> {
        match name {
            "pmatrix" | "bmatrix" | "matrix" | "array" | "smallmatrix" => {
                let rows: Read<Vec<Vec<Expr>>> =
                    rows.iter().map(|row| row.iter().map(|cell| self.sum(cell, span)).collect()).collect();
                let rows = rows?;
                match rows.iter().find(|row| row.len() != rows[0].len()) {
                    Some(_) => Err(Fault::new(span, "the rows of this matrix are not equally long")),
                    None => Ok(Expr::new(Node::Matrix(rows), span)),
                }
            }
            _ => Err(Fault::new(span, format!("the environment {name} is not read here"))),
        }
    }

    /// A base with something above the line: a power, a transpose, an inverse.
    fn raised(&mut self, base: Expr, sup: &Item, span: Span) -> Read<Expr> {
        let shape = shape::shape_of(&base, self.symbols)?;
        let boxed = Box::new(base);
        if let Shape::Matrix(..) = shape {
            if is_transpose(sup) {
                return Ok(Expr::new(Node::Transpose(boxed), span));
            }
            if is_minus_one(sup) {
                return Ok(Expr::new(Node::Inverse(boxed), span));
            }
        }
        if matches!(&sup.layout, Layout::Command(name) if matches!(name.as_str(), "\\dagger" | "\\circ" | "\\ast"))
            || matches!(sup.layout, Layout::Other('*'))
            || matches!(contents(sup), [Item { layout: Layout::Fence(Delimiter::Round, _), .. }])
        {
            return Err(Fault::new(sup.span, "this superscript is not read"));
        }
        if shape == Shape::Vector && whole_number(sup) == Some(2) {
            return Ok(Expr::new(Node::Dot(boxed.clone(), boxed), span));
        }
        let exponent = self.item(sup)?;
        Ok(Expr::new(Node::Power(boxed, Box::new(exponent)), span))
    }

    /// A printed name as a symbol of the table, with what its superscript and a following parenthesis make of it.
    fn symbol(&mut self, span: Span, printed: Printed<'_>, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let name = &printed.name;
        if name.base == "e" || name.base == "\\mathrm{e}" {
            let declared = self.symbols.find(name).is_some();
            if let (false, true, Some(sup), 0) = (declared, name.subscript.is_empty(), printed.sup, printed.dots) {
                if name.base == "e" && whole_number(sup).is_some() {
                    return Err(two_ways(span, "e with a plain number above it")
                        .help("write \\exp(2) for the exponential, or declare e"));
                }
                let exponent = self.item(sup)?;
                let euler = Expr::new(Node::Euler, span);
                return Ok(Expr::new(Node::Power(Box::new(euler), Box::new(exponent)), span));
            }
            if !declared && name.subscript.is_empty() {
                return Err(two_ways(span, "e alone").help("write \\exp(1) for the number, or declare e"));
            }
        }
        if let Some(special) = self.special(&printed, span)? {
            return match printed.sup {
                Some(sup) => self.raised(special, sup, span),
                None => Ok(special),
            };
        }
        let dots = printed.dots;
        if let Some((id, indices)) = self.symbols.find(name) {
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
            return self.applied(Node::Symbol { id, indices, dots }, printed.sup, span, items, cursor);
        }
        if name.subscript.is_empty()
            && name.primes == 0
            && let Some(id) = self.symbols.find_whole(&name.base)
        {
            return self.applied(Node::Symbol { id, indices: Vec::new(), dots }, printed.sup, span, items, cursor);
        }
        if self.symbols.open {
            return self.undeclared(printed, span, items, cursor);
        }
        let fault = Fault::new(span, format!("{name} is not declared"));
        Err(match self.symbols.nearest(name) {
            Some(near) => fault.help(format!("did you mean {near}? Else declare {name} in the claims file")),
            None => fault.help(format!("declare {name} in the claims file")),
        })
    }

    /// In a formula without a file, an unknown letter is a real number.
    fn undeclared(&mut self, printed: Printed<'_>, span: Span, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let name = &printed.name;
        let next = items.get(*cursor).filter(|item| names::printed(item, self.branch).is_some());
        if name.base == "d" && name.subscript.is_empty() && next.is_some() {
            return Err(two_ways(span, "d before a symbol").help("only \\frac{d}{dt} is read as a derivative"));
        }
        let fence = items.get(*cursor).is_some_and(|item| matches!(item.layout, Layout::Fence(Delimiter::Round, _)));
        let is_function_name = ["f", "F", "h", "G", "V", "W", "J", "Y", "\\Gamma", "\\Phi"]
            .contains(&name.base.as_str())
            || name.base.starts_with("\\mathrm{") && name.base.len() > "\\mathrm{x}".len();
        if fence && is_function_name {
            return Err(two_ways(span, &format!("{name}(…), a call or a product"))
                .help("for a product put a thin space \\, before the parenthesis"));
        }
        if name.base.contains("\\vec") || name.base.contains("\\mathbf") || name.base.contains("\\hat") {
            return Err(Fault::new(span, format!("{name} looks like a vector, and nothing says what it is"))
                .help("vectors and matrices need a claims file that declares them"));
        }
        let Some(id) = self.symbols.add(name.clone(), Kind::Scalar) else {
            return Err(Fault::new(span, format!("{name} cannot be told from another symbol")));
        };
        let node = Node::Symbol { id, indices: Vec::new(), dots: printed.dots };
        self.applied(node, printed.sup, span, items, cursor)
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

    /// A symbol with its power; a parenthesis after it is a factor of its own, unless that could be a call.
    fn applied(
        &mut self,
        node: Node,
        sup: Option<&Item>,
        span: Span,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        if let Some(Item { layout: Layout::Fence(Delimiter::Round, inside), span: fence }) = items.get(*cursor)
            && let Node::Symbol { id, .. } = &node
        {
            let plain = |item: &&Item| !matches!(item.layout, Layout::Space(_));
            let inside: Vec<&Item> = inside.iter().filter(plain).collect();
            let lone = inside.iter().all(|item| {
                names::printed(item, self.branch).is_some_and(|p| p.sup.is_none())
                    || matches!(item.layout, Layout::Other(','))
            }) && (inside.len() == 1 || inside.iter().any(|item| matches!(item.layout, Layout::Other(','))));
            if self.is_time_in_parentheses(&items[*cursor]) && self.symbols.entry(*id).varies {
                *cursor += 1;
            } else if lone {
                let name = self.symbols.entry(*id).name.to_string();
                return Err(two_ways(span.to(*fence), &format!("{name}(…), a call or a product"))
                    .help("for a product leave the parentheses out"));
            }
        }
        let expr = Expr::new(node, span);
        match sup {
            Some(sup) => self.raised(expr, sup, span),
            None => Ok(expr),
        }
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
            return Err(Fault::new(span, format!("{} wants its angle in parentheses", self.symbols.entry(id).name)));
        };
        *cursor += 1;
        let angle = self.sum(inside, *fence)?;
        let applied = Expr::new(Node::Apply(id, vec![angle]), span.to(*fence));
        match sup {
            Some(sup) => self.raised(applied, sup, span.to(*fence)),
            None => Ok(applied),
        }
    }

    /// `\Delta x` as one symbol, unless Δ itself is declared.
    fn compound(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let (Some(first), Some(second)) = (items.get(*cursor), items.get(*cursor + 1)) else {
            return Ok(None);
        };
        let is_difference = matches!(&first.layout, Layout::Command(name) if name == "\\Delta" || name == "\\delta");
        let Some(mut printed) = names::printed(second, self.branch).filter(|_| is_difference) else {
            return Ok(None);
        };
        let Layout::Command(command) = &first.layout else {
            return Ok(None);
        };
        if self.symbols.find(&Name::plain(command)).is_some() {
            return Ok(None);
        }
        if command == "\\delta" && self.symbols.open {
            return Err(two_ways(first.span.to(second.span), "\\delta before a symbol"));
        }
        printed.name.base = format!("{command} {}", printed.name.base);
        *cursor += 2;
        self.symbol(first.span.to(second.span), printed, items, cursor).map(Some)
    }

    /// A function with its argument.
    fn call(
        &mut self,
        function: Function,
        power: Option<&Item>,
        head: Span,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<(Expr, bool)> {
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(Space::Thin))) {
            *cursor += 1;
        }
        let Some(first) = items.get(*cursor) else {
            return Err(Fault::new(head, format!("\\{} wants an argument", function.name())));
        };
        let (argument, enclosed) = match &first.layout {
            Layout::Fence(..) | Layout::Group(_) => {
                *cursor += 1;
                (self.item(first)?, true)
            }
            Layout::Scripts { nucleus, .. } if matches!(nucleus.layout, Layout::Fence(..) | Layout::Group(_)) => {
                return Err(two_ways(head.to(first.span), "a power after the argument of a function")
                    .help(format!("write \\{}^2(…) for the power of the function", function.name())));
            }
            _ => (self.run_on(function, head, items, cursor)?, false),
        };
        let span = head.to(argument.span);
        let call = Expr::new(Node::Call(function, Box::new(argument)), span);
        match power {
            Some(power) => {
                let exponent = self.item(power)?;
                Ok((Expr::new(Node::Power(Box::new(call), Box::new(exponent)), span), enclosed))
            }
            None => Ok((call, enclosed)),
        }
    }

    /// The argument of a function that nothing encloses: as many of the following items as can only be meant.
    fn run_on(&mut self, function: Function, head: Span, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let start = *cursor;
        let mut numbers = 0;
        let mut symbols: Vec<(usize, bool, Name)> = Vec::new();
        // A fraction or a root is an argument by itself, unless a factor stands beside it.
        let mut whole_item = false;
        let mut at = start;
        while let Some(item) = items.get(at) {
            let is_number = match &item.layout {
                Layout::Number(_) => true,
                Layout::Fraction(a, b) => {
                    symbols.is_empty() && numbers == 0 && (at == start || is_numeric(a) && is_numeric(b))
                }
                Layout::Root(..) => at == start,
                Layout::Command(name) => name == "\\pi" && self.symbols.find(&Name::plain("\\pi")).is_none(),
                _ => false,
            };
            if is_number {
                if !symbols.is_empty() {
                    break;
                }
                numbers += 1;
                at += 1;
                if matches!(item.layout, Layout::Fraction(..) | Layout::Root(..)) && !is_numeric_item(item) {
                    whole_item = true;
                    break;
                }
                continue;
            }
            let Some(printed) = names::printed(item, self.branch) else { break };
            if printed.dots > 0 && at > start {
                break;
            }
            if printed.sup.is_some() {
                if at == start
                    || !symbols.is_empty() && !symbols.iter().any(|(_, angle, _)| *angle)
                    || numbers > 0 && symbols.is_empty()
                {
                    return Err(two_ways(head.to(item.span), "a power at the end of an argument")
                        .help(format!("write \\{}(…) with the power inside, or \\{0}^2", function.name())));
                }
                break;
            }
            let angle = printed.dots == 0
                && self.symbols.find(&printed.name).is_some_and(|(id, _)| self.symbols.entry(id).angle);
            let varies = self.symbols.find(&printed.name).is_some_and(|(id, _)| self.symbols.entry(id).varies);
            symbols.push((at, angle, printed.name));
            at += 1;
            if varies && items.get(at).is_some_and(|item| self.is_time_in_parentheses(item)) {
                at += 1;
            }
            if printed.dots > 0 || angle {
                break;
            }
        }
        let end = at;
        if end == start {
            let what = items.get(start).map_or(head, |item| item.span);
            if let Some(Item { layout: Layout::Fault(fault), .. }) = items.get(start) {
                return Err(fault.clone());
            }
            return Err(Fault::new(what, format!("the argument of \\{} is missing", function.name())));
        }
        let sure = match symbols.as_slice() {
            [] => true,
            [.., (_, true, _)] => true,
            [_] => true,
            [(_, _, first), (_, _, second)] => {
                let is_frequency = matches!(first.base.as_str(), "\\omega" | "\\Omega" | "\\nu");
                is_frequency && Some(second) == self.symbols.time.as_ref()
            }
            _ => false,
        };
        let sure = sure && !(whole_item && self.goes_on(items, end)) && !self.time_follows(items, end, &symbols);
        let last_is_angle = symbols.last().is_some_and(|(_, angle, _)| *angle);
        let fence_follows =
            matches!(items.get(end).map(|item| &item.layout), Some(Layout::Fence(..)) | Some(Layout::Scripts { .. }))
                && items.get(end).is_some_and(|item| names::printed(item, self.branch).is_none())
                && function_head(&items[end])?.is_none();
        if !sure || fence_follows && !last_is_angle {
            let span = head.to(items[end.min(items.len() - 1)].span);
            let shown = function.name();
            return Err(two_ways(span, &format!("where the argument of \\{shown} ends"))
                .help(format!("enclose it, \\{shown}(…), or end it with a thin space \\,")));
        }
        *cursor = end;
        self.term(&items[start..end])
    }

    /// Whether a symbol without a dot, or a number, stands beside what was read.
    fn goes_on(&self, items: &[Item], at: usize) -> bool {
        items.get(at).is_some_and(|item| {
            is_number(item)
                || matches!(item.layout, Layout::Fraction(..) | Layout::Root(..))
                || names::printed(item, self.branch).is_some_and(|printed| printed.dots == 0)
        })
    }

    /// Whether `\,t` follows an argument that is not an angle yet: `\cos\omega\,t`.
    fn time_follows(&self, items: &[Item], at: usize, symbols: &[(usize, bool, Name)]) -> bool {
        let space = items.get(at).is_some_and(|item| matches!(item.layout, Layout::Space(Space::Thin)));
        let time = items.get(at + 1).and_then(|item| names::printed(item, self.branch)).map(|printed| printed.name);
        space && time.is_some() && time == self.symbols.time && !symbols.iter().any(|(_, angle, _)| *angle)
    }

    /// `(t)` after something that varies is only a way of writing it.
    fn is_time_in_parentheses(&self, item: &Item) -> bool {
        let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
        let [only] = inside.as_slice() else { return false };
        let printed = names::printed(only, None).filter(|printed| printed.dots == 0 && printed.sup.is_none());
        printed.map(|printed| printed.name) == self.symbols.time
    }

    /// What `\frac{d}{dt}` acts on.
    fn operand(&mut self, items: &[Item], cursor: &mut usize, operator: Span) -> Read<Expr> {
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(Space::Thin))) {
            *cursor += 1;
        }
        let missing = || Fault::new(operator, "nothing follows this derivative");
        let first = items.get(*cursor).ok_or_else(missing)?;
        if matches!(first.layout, Layout::Fence(..)) {
            *cursor += 1;
            return self.item(first);
        }
        let rest = &items[*cursor..];
        let one = rest.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).count() == 1;
        if !one {
            return Err(two_ways(operator.to(first.span), "how far this derivative reaches").help("put parentheses"));
        }
        *cursor = items.len();
        self.sum(rest, operator)
    }

    /// `\frac{d^n …}{dt^n}`: the order and what stands beside the upper d.
    fn derivative<'i>(&self, numerator: &'i Item, denominator: &Item) -> Read<Option<(u8, &'i [Item])>> {
        let upper = contents(numerator);
        let lower = contents(denominator);
        let (Some(order), [d, time]) = (upper.first().and_then(differential), lower) else {
            return Ok(None);
        };
        let Some(time) = names::printed(time, None).filter(|_| differential(d) == Some(1)) else {
            return Ok(None);
        };
        let below = match time.sup {
            None => Some(1),
            Some(sup) => whole_number(sup),
        };
        if Some(&time.name) != self.symbols.time.as_ref() {
            return Ok(None);
        }
        let span = numerator.span.to(denominator.span);
        if self.symbols.find(&Name::plain("d")).is_some() {
            return Err(two_ways(span, "d, which is declared as a symbol").help("write \\mathrm{d} for the derivative"));
        }
        if below != Some(order) {
            return Err(Fault::new(span, "the orders above and below in this derivative differ"));
        }
        match u8::try_from(order) {
            Ok(order @ 1..=5) => Ok(Some((order, &upper[1..]))),
            _ => Err(Fault::new(span, "derivatives are read up to the fifth")),
        }
    }

    /// `d\theta/dt` typed on one line: d, θ, slash, d, t.
    fn derivative_slash(&self, items: &[Item], at: usize) -> Option<u8> {
        let [d, inner, slash, below, time, ..] = items.get(at..)? else { return None };
        let is_time = names::printed(time, None).is_some_and(|p| Some(&p.name) == self.symbols.time.as_ref());
        let fits = differential(d) == Some(1)
            && names::printed(inner, self.branch).is_some()
            && joint(slash) == Some(Joint::Slash)
            && differential(below) == Some(1)
            && is_time
            && self.symbols.find(&Name::plain("d")).is_none();
        fits.then_some(1)
    }

    /// `\sum_{a=1}^{3} …` or `\sum_a …` over declared indices.
    fn big_sum(&mut self, sigma: &Item, rest: &[Item]) -> Read<Expr> {
        let span = extent(rest).map_or(sigma.span, |rest| sigma.span.to(rest));
        let want = || Fault::new(sigma.span, "a sum wants a declared index below, \\sum_{a=1}^{3}");
        let Layout::Scripts { sub: Some(sub), sup, .. } = &sigma.layout else {
            return Err(want());
        };
        let below = contents(sub);
        let (letters, lower) = match below.iter().position(|item| item.layout == Layout::Other('=')) {
            Some(at) => (&below[..at], below.get(at + 1)),
            None => (below, None),
        };
        let mut indices = Vec::new();
        for item in letters.iter().filter(|item| !matches!(item.layout, Layout::Other(',') | Layout::Space(_))) {
            let name = names::printed(item, None).ok_or_else(want)?.name;
            indices.push(self.symbols.index(&name.to_string()).ok_or_else(want)?);
        }
        if indices.is_empty() || lower.is_some_and(|item| whole_number(item) != Some(1)) {
            return Err(want());
        }
        if let Some(upper) = sup {
            for index in &indices {
                let declared = self.symbols.indices[index.0].upper;
                if whole_number(upper) != Some(declared.into()) {
                    return Err(Fault::new(upper.span, format!("this index is declared to run to {declared}")));
                }
            }
        }
        if rest.is_empty() {
            return Err(Fault::new(sigma.span, "nothing follows this sum"));
        }
        let mut body = self.term(rest)?;
        for index in indices.into_iter().rev() {
            body = Expr::new(Node::SumOver { index, implied: false, body: Box::new(body) }, span);
        }
        Ok(body)
    }
}

/// Factors side by side as one formula.
fn beside(mut factors: Vec<Expr>) -> Expr {
    if factors.len() == 1 {
        return factors.remove(0);
    }
    let span = match (factors.first(), factors.last()) {
        (Some(first), Some(last)) => first.span.to(last.span),
        _ => Span::default(),
    };
    Expr::new(Node::Product(factors), span)
}

fn two_ways(span: Span, what: &str) -> Fault {
    Fault::new(span, format!("people read this in two ways: {what}"))
}

fn unknown_command(name: &str, span: Span) -> Fault {
    match name {
        "\\log" => two_ways(span, "\\log").help("write \\ln, or \\ln x / \\ln 10"),
        "\\pm" | "\\mp" => Fault::new(span, "± stands where no sign can"),
        "\\partial" | "\\nabla" => Fault::new(span, format!("{name} is not read yet")),
        "\\int" | "\\prod" | "\\lim" => Fault::new(span, format!("{name} is not read yet")),
        _ => Fault::new(span, format!("the command {name} is not known"))
            .help("if it is a macro of yours, define it under \"macros\" in the claims file"),
    }
}

/// The bytes from the first item to the last.
pub(super) fn extent(items: &[Item]) -> Option<Span> {
    Some(items.first()?.span.to(items.last()?.span))
}

fn joint(item: &Item) -> Option<Joint> {
    match &item.layout {
        Layout::Other('/') => Some(Joint::Slash),
        Layout::Other('*' | '·' | '⋅') => Some(Joint::CDot),
        Layout::Other('×') => Some(Joint::Times),
        Layout::Command(name) => match name.as_str() {
            "\\cdot" => Some(Joint::CDot),
            "\\times" => Some(Joint::Times),
            _ => None,
        },
        _ => None,
    }
}

/// The items inside a group, or the item itself.
fn contents(item: &Item) -> &[Item] {
    match &item.layout {
        Layout::Group(items) => items,
        _ => std::slice::from_ref(item),
    }
}

/// A function's command with the power on it.
fn function_head(item: &Item) -> Read<Option<(Function, Option<&Item>)>> {
    let named = |item: &Item| match &item.layout {
        Layout::Command(name) => name.strip_prefix('\\').and_then(Function::named),
        Layout::Style(style, inner) if style == "\\mathrm" => {
            let word: String =
                contents(inner).iter().map(|item| if let Layout::Letter(c) = item.layout { c } else { ' ' }).collect();
            Function::named(&word)
        }
        _ => None,
    };
    if let Some(function) = named(item) {
        return Ok(Some((function, None)));
    }
    let Layout::Scripts { nucleus, sub, sup, primes } = &item.layout else {
        return Ok(None);
    };
    let Some(function) = named(nucleus) else {
        return Ok(None);
    };
    if sub.is_some() || *primes > 0 {
        return Err(Fault::new(item.span, "a subscript or prime on a function is not read"));
    }
    match sup.as_deref() {
        Some(sup) if contents(sup).first().is_some_and(|item| item.layout == Layout::Other('-')) => {
            Err(two_ways(item.span, "a negative power of a function").help("write \\arcsin or \\frac{1}{\\sin x}"))
        }
        sup => Ok(Some((function, sup))),
    }
}

fn is_big_sum(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\sum",
        Layout::Scripts { nucleus, .. } => matches!(&nucleus.layout, Layout::Command(name) if name == "\\sum"),
        _ => false,
    }
}

/// The order of a differential d, `d^2`, `\mathrm{d}`.
fn differential(item: &Item) -> Option<u32> {
    let is_d = |item: &Item| {
        item.layout == Layout::Letter('d')
            || matches!(&item.layout, Layout::Style(style, inner) if style == "\\mathrm"
                && matches!(contents(inner), [Item { layout: Layout::Letter('d'), .. }]))
    };
    match &item.layout {
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } if is_d(nucleus) => whole_number(sup),
        _ if is_d(item) => Some(1),
        _ => None,
    }
}

/// Whether a numerator or denominator begins with a d and goes on: `dx`, `\partial L`.
fn starts_differential(item: &Item) -> bool {
    match contents(item) {
        [first, second, ..] => {
            let partial = matches!(&first.layout, Layout::Command(name) if name == "\\partial");
            partial || differential(first).is_some() && names::printed(second, None).is_some()
        }
        _ => false,
    }
}

fn whole_number(item: &Item) -> Option<u32> {
    match contents(item) {
        [Item { layout: Layout::Number(digits), .. }] => digits.parse().ok(),
        _ => None,
    }
}

fn is_minus_one(item: &Item) -> bool {
    matches!(contents(item), [Item { layout: Layout::Other('-'), .. }, one] if whole_number(one) == Some(1))
}

fn is_transpose(item: &Item) -> bool {
    match contents(item) {
        [Item { layout: Layout::Letter('T'), .. }] => true,
        [Item { layout: Layout::Command(name), .. }] => name == "\\top",
        [Item { layout: Layout::Style(_, inner), .. }] => is_transpose(inner),
        _ => false,
    }
}

fn is_numeric(item: &Item) -> bool {
    contents(item).iter().all(|item| match &item.layout {
        Layout::Number(_) => true,
        Layout::Command(name) => name == "\\pi",
        _ => false,
    })
}

fn is_number(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(_) => true,
        Layout::Scripts { nucleus, .. } => is_number(nucleus),
        _ => false,
    }
}

fn is_numeric_item(item: &Item) -> bool {
    match &item.layout {
        Layout::Fraction(a, b) => is_numeric(a) && is_numeric(b),
        Layout::Root(_, a) => is_numeric(a),
        _ => false,
    }
}
