//! Derivatives by a symbol: `\frac{\partial L}{\partial \dot q}`, `\frac{\partial}{\partial x}(…)`, `\partial_x f`, and
//! `\frac{df}{dx}` where f depends on nothing else.
//!
//! The derivative is formed at once, from the formulas that define the names. So what is read has no ∂ in it. A name
//! that a system determines, such as L beside a `system`, has its derivatives as symbols of their own, which the
//! model adds under the name that is printed here. Without any declarations, the derivative of a lone letter is such a
//! symbol too.

use crate::formula::derivative::{self, NoDerivative, Scope};
use crate::formula::symbols::{self, Kind, Name, SymbolId};
use crate::formula::tree::{Expr, Node, Sign, Term, Variable};
use crate::source::{Fault, Missing, Span};

use super::super::layout::{Item, Layout, contents};
use super::super::lexer::Space;
use super::super::names;
use super::derivatives::{different_orders, may_depend, of_too_high_order, without_mark, without_order};
use super::items::{Joint, differential, has_sign_second, is_usual_index, joint, whole_number};
use super::state::{Read, Reader};

/// Whether a derivative is written with ∂, or with d.
#[derive(Clone, Copy, PartialEq)]
enum Mark {
    Partial,
    Total,
}

/// A fraction that is a derivative: its mark, its order, what stands in the numerator, and the variables.
pub(super) struct Operator<'i> {
    mark: Mark,
    pub(super) operand: &'i [Item],
    pub(super) by: Vec<(&'i Item, Variable)>,
    span: Span,
}

impl Operator<'_> {
    /// Whether its operand follows it.
    pub(super) fn needs_an_operand(&self) -> bool {
        self.operand.is_empty()
    }
}

impl Reader<'_> {
    /// The derivative that a fraction is, unless it is one by the time; `None` for a fraction of formulas.
    pub(super) fn operator<'i>(
        &mut self,
        numerator: &'i Item,
        denominator: &'i Item,
        span: Span,
    ) -> Read<Option<Operator<'i>>> {
        self.operator_of((contents(numerator), contents(denominator)), span)
    }

    /// `\partial L/\partial q` typed on one line; the cursor moves behind it.
    pub(super) fn operator_on_one_line<'i>(
        &mut self,
        items: &'i [Item],
        cursor: &mut usize,
    ) -> Read<Option<Operator<'i>>> {
        let Some((upper, lower)) = on_one_line(&items[*cursor..]) else { return Ok(None) };
        let span = upper[0].span.to(lower[lower.len() - 1].span);
        *cursor += upper.len() + 1 + lower.len();
        self.operator_of((upper, lower), span)
    }

    fn operator_of<'i>(&mut self, (upper, lower): (&'i [Item], &'i [Item]), span: Span) -> Read<Option<Operator<'i>>> {
        let Some((mark, order)) = upper.first().and_then(mark) else { return Ok(None) };
        let Some((below, _)) = lower.first().and_then(self::mark) else { return Ok(None) };
        let is_letter = [upper, lower].into_iter().any(has_sign_second);
        if is_letter || below != mark || mark == Mark::Total && self.symbols.find(&Name::plain("d")).is_some() {
            return Ok(None);
        }
        let by = self.variables(lower, mark, span)?;
        let of_all: u32 = by.iter().map(|(_, times)| *times).sum();
        if of_all != order {
            return Err(different_orders(span, "\\frac{\\partial^2 f}{\\partial x^2}"));
        }
        if order > 4 {
            return Err(of_too_high_order("partial derivatives above the fourth order", span));
        }
        let by = by.into_iter().flat_map(|((item, by), times)| vec![(item, by); times as usize]).collect();
        Ok(Some(Operator { mark, operand: &upper[1..], by, span }))
    }

    /// The variables in a denominator, each with its order: `\partial x\,\partial y`, `\partial x^2`.
    fn variables<'i>(
        &mut self,
        lower: &'i [Item],
        wanted: Mark,
        whole: Span,
    ) -> Read<Vec<((&'i Item, Variable), u32)>> {
        let mut found = Vec::new();
        let mut items = lower.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        while let Some(first) = items.next() {
            let variable = items.next().filter(|_| mark(first) == Some((wanted, 1)));
            let variable = variable.ok_or_else(|| without_mark(whole))?;
            let by = self.variable(variable)?;
            let power = names::printed(variable, self.branch).and_then(|printed| printed.sup);
            let times = match power {
                None => 1,
                Some(power) => whole_number(power).ok_or_else(|| without_order(power.span))?,
            };
            found.push(((variable, by), times));
        }
        Ok(found)
    }

    /// The symbol by which a derivative is taken, with its dots.
    fn variable(&mut self, item: &Item) -> Read<Variable> {
        let Some(printed) = names::printed(item, self.branch) else {
            return Err(Fault::unsupported(item.span, "a derivative must be by a symbol, or by a symbol with a dot")
                .help("define a name for this formula, and differentiate by the name"));
        };
        if let Some((id, indices)) = self.symbols.find_or_assemble(&printed.name) {
            let entry = self.symbols.entry(id);
            if entry.kind != Kind::Scalar || entry.squared {
                return Err(Fault::unsupported(item.span, "a derivative by a vector or a matrix is not supported")
                    .help("write a derivative by each component"));
            }
            return Ok(Variable { id, indices, dots: printed.dots });
        }
        if self.symbols.open && ["\\vec{", "\\mathbf{"].iter().any(|mark| printed.name.base.contains(mark)) {
            return Err(Fault::unsupported(item.span, "a derivative by a vector or a matrix is not supported")
                .help("write a derivative by each component"));
        }
        if self.symbols.open
            && let Some(id) = self.symbols.add(printed.name.clone(), Kind::Scalar)
        {
            return Ok(Variable { id, indices: Vec::new(), dots: printed.dots });
        }
        Err(Fault::undeclared(item.span, &printed.name))
    }

    /// The formula of a derivative; `items` from `cursor` on follow it.
    pub(super) fn apply(&mut self, operator: &Operator<'_>, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let (operand, span) = match operator.needs_an_operand() {
            true => {
                let operand = self.operand_of_partial(operator.span, items, cursor)?;
                (operand.clone(), operator.span.to(operand.span))
            }
            false => {
                if let Some(next) = items.get(*cursor) {
                    self.is_no_value("\\frac{\\partial f}{\\partial x}", operator.span, next)?;
                }
                (self.differentiated_name(operator.operand, operator.span)?, operator.span)
            }
        };
        self.derived_by(&operator.by, operator.mark, operand, span)
    }

    /// `\partial_x f`, at the ∂.
    pub(super) fn subscripted(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let Layout::Scripts { nucleus, sub: Some(sub), sup: None, primes: 0 } = &item.layout else { return Ok(None) };
        if mark(nucleus) != Some((Mark::Partial, 1)) {
            return Ok(None);
        }
        if self.symbols.infers() && is_usual_index(sub) {
            return Err(Fault::unsupported(item.span, "∂ with an index is not supported here").help(
                "write \\frac{\\partial}{\\partial x}, or leave the equation out with \"skip\" in the claims file",
            ));
        }
        let by = (&**sub, self.variable(sub)?);
        *cursor += 1;
        let operand = self.operand_of_partial(item.span, items, cursor)?;
        let span = item.span.to(operand.span);
        self.derived_by(&[by], Mark::Partial, operand, span).map(Some)
    }

    /// What stands in the numerator: one formula, or a name with the names that it depends on, `L(q, \dot q, t)`.
    fn differentiated_name(&mut self, items: &[Item], whole: Span) -> Read<Expr> {
        let significant: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        if let [name, arguments] = significant.as_slice()
            && names::printed(name, self.branch).is_some()
            && super::applications::are_names(arguments, self.branch)
        {
            return self.item(name);
        }
        self.sum(items, whole)
    }

    /// The operand of `\frac{\partial}{\partial x}`: a parenthesis, or one factor that ends the term.
    fn operand_of_partial(&mut self, operator: Span, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(Space::Thin))) {
            *cursor += 1;
        }
        let rest = items.get(*cursor..).unwrap_or_default();
        let Some(first) = rest.first() else {
            return Err(Fault::unsupported(operator, "a derivative that acts on nothing is not supported")
                .help("write the function that is differentiated"));
        };
        if matches!(first.layout, Layout::Fence(..)) {
            *cursor += 1;
            return self.item(first);
        }
        let significant = rest.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).count();
        if significant > 1
            && let Some(factor) = self.only_factor(rest)
        {
            *cursor = items.len();
            return Ok(factor);
        }
        if significant > 1 || joint(first) == Some(Joint::Slash) {
            return Err(Fault::ambiguous(
                operator.to(first.span),
                "\\frac{\\partial}{\\partial x} f g may be \\frac{\\partial}{\\partial x}(f) g or \
                 \\frac{\\partial}{\\partial x}(f g)",
            )
            .help("put what is differentiated in parentheses"));
        }
        *cursor = items.len();
        self.sum(rest, operator)
    }

    /// One factor of several items, if it is all there is: `\ln Z`, `\sin(\sin x)`, `f(x)`.
    ///
    /// Each derivative in a chain reads the rest of it, so a long chain is not tried.
    pub(super) fn only_factor(&mut self, items: &[Item]) -> Option<Expr> {
        const MOST: usize = 16;
        let may_be_a_derivative = |item: &&Item| match &item.layout {
            Layout::Fraction(..) => true,
            Layout::Scripts { nucleus, .. } => mark(nucleus).is_some(),
            _ => mark(item).is_some(),
        };
        if items.iter().filter(may_be_a_derivative).count() > MOST {
            return None;
        }
        let mut end = 0;
        let (factor, _) = self.factor(items, &mut end).ok()?;
        items[end..].iter().all(|item| matches!(item.layout, Layout::Space(_))).then_some(factor)
    }

    fn derived_by(&mut self, by: &[(&Item, Variable)], mark: Mark, operand: Expr, span: Span) -> Read<Expr> {
        // Beside ∂ a derivative with d is by all that changes: it is no other name for ∂f/∂x.
        let is_total = mark == Mark::Total && self.symbols.infers() && self.symbols.inferred.has_partials;
        if !is_total && let Some(symbol) = self.named_derivative(&operand, by, span) {
            return Ok(symbol);
        }
        let mut formula = operand;
        // The variable that stands last acts first.
        for (item, by) in by.iter().rev() {
            let next = self.derivative_by(&formula, (item, by), mark, span);
            formula = match next {
                Err(_) if self.symbols.infers() => self.unformed(by, mark, formula, span),
                next => next?,
            };
        }
        formula.span = span;
        // As a sum of one term it differs from its own text, because to carry out a derivative is a step.
        Ok(Expr::new(Node::Sum(vec![Term { sign: Sign::Plus, sign_span: None, expr: formula }]), span))
    }

    /// A derivative that is not formed, since nothing says what the letters depend on.
    fn unformed(&mut self, by: &Variable, mark: Mark, formula: Expr, span: Span) -> Expr {
        let name = &self.symbols.entry(by.id).name;
        let below = names::with_dots(name, by.dots).unwrap_or_else(|| name.clone());
        let d = if mark == Mark::Partial { "\\partial " } else { "d" };
        self.operate(&format!("{d}/{d}{below}"), symbols::Operator::Same, vec![formula], span)
    }

    /// The symbol for the derivative of a name that no formula defines.
    fn named_derivative(&mut self, operand: &Expr, by: &[(&Item, Variable)], span: Span) -> Option<Expr> {
        let id = operand.as_plain_symbol()?;
        let entry = self.symbols.entry(id);
        let (above, kind) = (entry.name.to_string(), entry.kind);
        let is_open = self.symbols.open && entry.definition.is_none();
        let is_itself = by.iter().any(|(_, by)| by.id == id);
        let name = match by {
            [(_, variable)] => {
                let below = names::with_dots(&self.symbols.entry(variable.id).name, variable.dots)?;
                derivative_name(&above, &below.to_string())
            }
            _ if !is_open || !self.symbols.infers() => return None,
            several => {
                let below: Option<Vec<String>> = several
                    .iter()
                    .map(|(_, by)| Some(names::with_dots(&self.symbols.entry(by.id).name, by.dots)?.to_string()))
                    .collect();
                let runs = below?;
                let runs = runs.chunk_by(|a, b| a == b).map(|run| match run.len() {
                    1 => format!("\\partial {}", run[0]),
                    times => format!("\\partial {}^{times}", run[0]),
                });
                let below = runs.collect::<Vec<_>>().join(" ");
                Name::plain(format!("\\partial^{}{above}/{below}", several.len()))
            }
        };
        let symbol = |id: SymbolId| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, span);
        match self.symbols.find(&name) {
            Some((id, _)) => Some(symbol(id)),
            None if is_open && !is_itself => self.symbols.add(name, kind).map(symbol),
            None => None,
        }
    }

    fn derivative_by(&self, formula: &Expr, (item, by): (&Item, &Variable), mark: Mark, span: Span) -> Read<Expr> {
        let refused = |reason: NoDerivative| self.refused(&reason, span);
        let fixed = self.momenta(formula);
        let scope = Scope { symbols: self.symbols, fixed: &fixed };
        // What stands in the formula of the name by which is differentiated is no variable beside it.
        let itself = [fixed.as_slice(), &[by.id]].concat();
        let others = derivative::variables(formula, Scope { fixed: &itself, ..scope }).map_err(refused)?;
        if let Some(own) = &self.symbols.entry(by.id).definition
            && !fixed.contains(&by.id)
            && let Ok(own) = derivative::variables(own, scope)
            && let Some(beside) = others.iter().find(|other| *other != by && own.contains(other))
        {
            let name = |id: SymbolId| self.symbols.entry(id).name.to_string();
            let (by, beside) = (name(by.id), name(beside.id));
            return Err(Fault::ambiguous(
                span,
                format!(
                    "the formula of {by} contains {beside}, which may stay fixed in this derivative or change with {by}"
                ),
            )
            .help(format!("write the differentiated formula with only one of the two, {beside} or {by}")));
        }
        let is_momentum = |other: &&Variable| fixed.contains(&other.id) && self.symbols.entry(other.id).is_momentum();
        // The momentum of a cyclic coordinate stands beside the velocities of the others in a Routhian.
        let coordinate = |momentum: &Variable| {
            let pair = self.symbols.canonical.iter().find(|(_, names)| names.contains(&momentum.id));
            pair.map(|(q, _)| *q)
        };
        let is_its_rate = |momentum: &Variable, velocity: &Variable| {
            if let Some(q) = coordinate(momentum) {
                return q == velocity.id;
            }
            let (momentum, velocity) = (&self.symbols.entry(momentum.id), &self.symbols.entry(velocity.id));
            let of = momentum.name.subscript.concat();
            of.is_empty() || !momentum.is_momentum() || of == velocity.name.to_string()
        };
        let velocity = others.iter().find(|other| {
            let held = || others.iter().filter(is_momentum);
            other.dots > 0 && !fixed.contains(&other.id) && held().any(|momentum| is_its_rate(momentum, other))
        });
        if let (Some(velocity), Some(momentum)) = (velocity, others.iter().find(|other| is_momentum(other))) {
            let name = |id: SymbolId| self.symbols.entry(id).name.to_string();
            let (p, q) = (name(momentum.id), name(velocity.id));
            return Err(Fault::ambiguous(
                span,
                format!("the derivative may keep the momentum {p} fixed, or the time derivative of {q}"),
            )
            .help("write the formula in coordinates and velocities, or in coordinates and momenta"));
        }
        let is_by = |other: &Variable| other == by;
        let is_composed = |other: &Variable| self.symbols.open && self.symbols.entry(other.id).is_composed();
        if others.iter().any(is_composed) || self.symbols.infers() && !others.iter().all(is_by) {
            let letter = others.iter().find(|other| is_composed(other) || !is_by(other)).unwrap_or(by);
            return Err(may_depend(&self.symbols.entry(letter.id).name.to_string(), item.span));
        }
        if let Some(unread) = self.symbols.unread_in(formula).filter(|id| *id != by.id) {
            return Err(self.refused(&NoDerivative::Unknown(unread), span));
        }
        // The momentum of another coordinate stays fixed in dV/dr, as in an effective potential.
        let stays = |other: &Variable| {
            if let Some(q) = coordinate(other) {
                return fixed.contains(&other.id) && q != by.id;
            }
            let (subscript, variable) =
                (&self.symbols.entry(other.id).name.subscript, self.symbols.entry(by.id).name.to_string());
            let is_of_it =
                subscript.concat() == variable || subscript.is_empty() && self.symbols.entry(other.id).is_momentum();
            fixed.contains(&other.id) && !is_of_it
        };
        if mark == Mark::Total && self.runs_along_the_motion(formula, by, &others) {
            let rate_of = |expr: &Expr| derivative::rate(expr, scope, span).map_err(refused);
            let Variable { id, ref indices, dots } = *by;
            let by = Expr::new(Node::Symbol { id, indices: indices.clone(), dots }, span);
            let quotient = Node::Quotient(Box::new(rate_of(formula)?), Box::new(rate_of(&by)?));
            return Ok(Expr::new(quotient, span));
        }
        match mark {
            Mark::Total if others.iter().any(|other| !is_by(other) && !stays(other)) => Err(Fault::ambiguous(
                span,
                "this derivative with d may be partial or total, because the formula contains more than one variable",
            )
            .help("write \\partial for the partial derivative")),
            // A free function of which nothing says what it depends on.
            _ if others.len() == 1 && formula.as_plain_symbol() == Some(others[0].id) && !is_by(&others[0]) => {
                Err(self.refused(&NoDerivative::Unknown(others[0].id), span))
            }
            _ if self.symbols.open && !others.iter().any(is_by) && !others.is_empty() => {
                Err(may_depend(&self.symbols.entry(others[0].id).name.to_string(), item.span))
            }
            _ => derivative::partial(formula, by, scope, span).map_err(refused),
        }
    }

    /// The fault of a formula that has no derivative.
    pub(super) fn refused(&self, reason: &NoDerivative, span: Span) -> Fault {
        match reason {
            NoDerivative::Unknown(id) => {
                let name = self.symbols.entry(*id).name.to_string();
                let message = format!("no formula says how {name} depends on the variable of this derivative");
                let mut fault = Fault::unsupported(span, message)
                    .help(format!("write the formula of {name} in a display or under \"define\" in the claims file"));
                fault.missing = Some(Missing::Name(name));
                fault
            }
            NoDerivative::Operation(what) => {
                Fault::unsupported(span, format!("the derivative of {what} is not supported"))
                    .help("write its result, or leave the equation out with \"skip\" in a claims file")
            }
        }
    }

    /// Whether df/dq is the ratio of the rates of f and of the coordinate q, as for an orbit: d²u/dφ² of u = 1/r.
    ///
    /// A function of q, or of a declared argument, has a derivative of its own, and of L or U the partial one may be meant.
    fn runs_along_the_motion(&self, formula: &Expr, by: &Variable, others: &[Variable]) -> bool {
        let may_be_partial = |id: SymbolId| {
            let entry = self.symbols.entry(id);
            let is_energy =
                ["L", "\\mathcal{L}", "T", "K", "U", "V", "W", "E", "H"].contains(&entry.name.base.as_str());
            is_energy || !entry.arguments.is_empty() || entry.is_momentum() || entry.conserved
        };
        let is_followed = |id: SymbolId| {
            let entry = self.symbols.entry(id);
            entry.definition.is_some() || !entry.derived
        };
        let varies = self.symbols.entry(by.id).varies && self.symbols.entry(by.id).definition.is_none();
        let is_the_time = self.symbols.time.as_ref() == Some(&self.symbols.entry(by.id).name);
        !self.symbols.open
            && varies
            && !is_the_time
            && by.dots == 0
            && !others.is_empty()
            && others.iter().all(|other| other.id != by.id || other.dots > 0)
            && formula.symbols().iter().all(|(id, _)| is_followed(*id) && !may_be_partial(*id))
    }

    /// The momenta and conserved quantities in a formula: they are variables of their own, whatever formula defines them.
    ///
    /// So are the names in a function V(r) that contain more than its arguments, such as ℓ = mr²φ̇: V depends on r alone.
    pub(super) fn momenta(&self, formula: &Expr) -> Vec<SymbolId> {
        let own = formula.as_plain_symbol().map(|id| self.symbols.entry(id));
        let defined = own.and_then(|entry| Some((entry.definition.as_deref()?.clone(), entry.arguments.clone())));
        let (mut found, mut waiting) = (Vec::new(), vec![defined.unwrap_or_else(|| (formula.clone(), Vec::new()))]);
        let mut seen = Vec::new();
        while let Some((next, arguments)) = waiting.pop() {
            for (id, _) in next.symbols() {
                let entry = self.symbols.entry(id);
                let inner = if entry.arguments.is_empty() { arguments.clone() } else { entry.arguments.clone() };
                match &entry.definition {
                    _ if seen.contains(&id) => {}
                    _ if entry.is_momentum() || entry.conserved => found.push(id),
                    Some(definition) if self.exceeds(id, definition, &arguments) => found.push(id),
                    Some(definition) => waiting.push((definition.as_ref().clone(), inner)),
                    None => {}
                }
                seen.push(id);
            }
        }
        found
    }

    /// Whether a name in a function contains rates that are no arguments of the function.
    fn exceeds(&self, id: SymbolId, definition: &Expr, arguments: &[Variable]) -> bool {
        let is_argument = |other: &Variable| arguments.contains(other);
        let scope = Scope { symbols: self.symbols, fixed: &[] };
        !arguments.is_empty()
            && !arguments.iter().any(|argument| argument.id == id)
            && derivative::variables(definition, scope)
                .is_ok_and(|found| found.iter().any(|other| other.dots > 0 && !is_argument(other)))
    }
}

/// The name of the symbol that stands for a derivative.
pub fn derivative_name(above: &str, below: &str) -> Name {
    Name::plain(format!("\\frac{{\\partial {above}}}{{\\partial {below}}}"))
}

/// Whether an item is ∂ or d, with its order.
fn mark(item: &Item) -> Option<(Mark, u32)> {
    let is_partial = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\partial");
    match &item.layout {
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } if is_partial(nucleus) => {
            Some((Mark::Partial, whole_number(sup)?))
        }
        _ if is_partial(item) => Some((Mark::Partial, 1)),
        _ => differential(item).map(|order| (Mark::Total, order)),
    }
}

/// The items before and after the slash of `\partial L/\partial q` typed on one line.
fn on_one_line(items: &[Item]) -> Option<(&[Item], &[Item])> {
    // Only the items that it would consist of are looked at, since a term may be long.
    let slash = items.get(2).filter(|item| joint(item) == Some(Joint::Slash));
    let (above, below) = (items.get(..2)?, items.get(3..5).filter(|_| slash.is_some())?);
    let is_partial = |item: &Item| mark(item).is_some_and(|(mark, _)| mark == Mark::Partial);
    let is_name = |item: &Item| names::printed(item, None).is_some();
    let fits = matches!((above, below), ([first, name], [d, by])
        if is_partial(first) && is_name(name) && is_partial(d) && is_name(by));
    fits.then_some((above, below))
}
