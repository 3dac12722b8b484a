//! Functions of one's own: `V(r)`, `V'(r)`, `f(x + a)`, where V is declared as a function or a display defines `V(r) = …`.
//!
//! Without a parenthesis, and with the arguments that it was defined with, the name is the value there. Other arguments
//! are put into its formula. A prime is the derivative by the only argument.

use crate::formula::derivative::{self, NoDerivative, Scope};
use crate::formula::symbols::{Name, SymbolId};
use crate::formula::tree::{Expr, Node, Variable};
use crate::source::{Fault, Span};

use super::super::layout::{Delimiter, Item, Layout};
use super::super::names::{self, Printed};
use super::state::{Read, Reader};

impl Reader<'_> {
    /// The function that a printed name is, and the order of the derivative that its primes ask for.
    pub(super) fn declared_function(&self, printed: &Printed<'_>) -> Option<(SymbolId, u8)> {
        let found = |name: &Name| {
            let (id, indices) = self.symbols.find(name)?;
            (indices.is_empty() && !self.symbols.entry(id).arguments.is_empty()).then_some(id)
        };
        if let Some(id) = found(&printed.name) {
            return Some((id, 0));
        }
        let known = self.symbols.find(&printed.name).is_some();
        let plain = Name { primes: 0, ..printed.name.clone() };
        (!known && printed.name.primes > 0).then(|| found(&plain)).flatten().map(|id| (id, printed.name.primes))
    }

    /// The value of a declared function; the cursor moves behind its arguments.
    pub(super) fn function_value(
        &mut self,
        (id, order): (SymbolId, u8),
        printed: &Printed<'_>,
        span: Span,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        let symbol = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: printed.dots }, span);
        let mut value = self.primed(symbol, id, order, span)?;
        let mut above = None;
        let fence = items.get(*cursor).and_then(|item| match &item.layout {
            Layout::Fence(Delimiter::Round, inside) => Some((inside, None)),
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => match &nucleus.layout {
                Layout::Fence(Delimiter::Round, inside) => Some((inside, Some(&**sup))),
                _ => None,
            },
            _ => None,
        });
        let mut whole = span;
        if let Some((inside, sup)) = fence {
            whole = span.to(items[*cursor].span);
            *cursor += 1;
            above = sup;
            value = self.at_arguments(value, id, inside, whole)?;
        }
        for sup in [printed.sup, above].into_iter().flatten() {
            value = self.raised(value, sup, whole)?;
        }
        Ok(value)
    }

    /// The derivative of this order by the only argument.
    fn primed(&self, value: Expr, id: SymbolId, order: u8, span: Span) -> Read<Expr> {
        if order == 0 {
            return Ok(value);
        }
        let entry = self.symbols.entry(id);
        let [by] = entry.arguments.as_slice() else {
            return Err(Fault::ambiguous(
                span,
                format!("a prime on {} may be a derivative by any of its arguments", entry.name),
            )
            .help("write a partial derivative, such as \\frac{\\partial f}{\\partial x}"));
        };
        let fixed = self.momenta(&value);
        let scope = Scope { symbols: self.symbols, fixed: &fixed };
        (0..order).try_fold(value, |value, _| derivative::partial(&value, by, scope, span)).map_err(|reason| {
            match reason {
                NoDerivative::Unknown(id) => {
                    let name = &self.symbols.entry(id).name;
                    Fault::unsupported(span, format!("nothing says how {name} depends on its argument")).help(format!(
                        "write the formula of {name} in a display or under \"define\" in the claims file"
                    ))
                }
                NoDerivative::Operation(what) => {
                    Fault::unsupported(span, format!("the derivative of {what} is not supported"))
                        .help("write its result, or leave the equation out with \"skip\" in a claims file")
                }
            }
        })
    }

    /// A function, or its derivative, at the arguments in a parenthesis.
    fn at_arguments(&mut self, value: Expr, id: SymbolId, inside: &[Item], span: Span) -> Read<Expr> {
        let arguments = self.symbols.entry(id).arguments.clone();
        let is_comma = |item: &Item| matches!(item.layout, Layout::Other(',' | ';'));
        let given: Vec<&[Item]> = inside.split(is_comma).collect();
        let name = self.symbols.entry(id).name.to_string();
        if given.len() != arguments.len() {
            return Err(Fault::new(
                span,
                format!("{name} has {} arguments here, and {} where it is defined", given.len(), arguments.len()),
            )
            .help("write the same arguments as in its definition"));
        }
        let mut changes = Vec::new();
        for (argument, items) in arguments.iter().zip(given) {
            let read = self.sum(items, span)?;
            let Variable { id, indices, dots } = argument.clone();
            if read.node != (Node::Symbol { id, indices, dots }) {
                changes.push((argument.clone(), read));
            }
        }
        if changes.is_empty() {
            return Ok(value);
        }
        let mut formula = match &value.node {
            Node::Symbol { id, dots: 0, .. } => match &self.symbols.entry(*id).definition {
                Some(formula) => formula.as_ref().clone(),
                None => return Err(unknown_formula(&name, span)),
            },
            Node::Symbol { .. } => {
                let what = format!("\\dot {name} may be d{name}/dt or the derivative of {name} by its argument");
                return Err(
                    Fault::ambiguous(span, what).help(format!("write \\frac{{d}}{{dt}} {name}(…) or {name}'(…)"))
                );
            }
            _ => value,
        };
        // Names that depend on the argument are replaced by their formulas: F(r) = −V'(r) at 1/u.
        let held = self.momenta(&Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, span));
        for _ in 0..MOST_DEFINITIONS {
            let indirect = |node: &Node| match node {
                Node::Symbol { id, dots: 0, .. } if !held.contains(id) && !is_changed(&changes, *id) => {
                    let entry = self.symbols.entry(*id);
                    entry.slots.is_empty().then_some(entry.definition.as_deref()?).filter(|inner| {
                        changes.iter().any(|(by, _)| inner.symbols().iter().any(|(id, _)| *id == by.id))
                    })
                }
                _ => None,
            };
            let before = formula.clone();
            formula.substitute(&|node| indirect(node).cloned());
            if formula == before {
                break;
            }
        }
        let depends = |other: &SymbolId| {
            if held.contains(other) || is_changed(&changes, *other) {
                return false;
            }
            let definition = self.symbols.entry(*other).definition.as_ref();
            definition.is_some_and(|formula| {
                changes.iter().any(|(by, _)| formula.symbols().iter().any(|(id, _)| *id == by.id))
            })
        };
        let indirect = formula.symbols().into_iter().map(|(id, _)| id).find(depends);
        if indirect.is_some() || changes.iter().any(|(by, _)| by.dots > 0) {
            return Err(unknown_formula(&name, span));
        }
        formula.move_to(span);
        formula.substitute(&|node| {
            let Node::Symbol { id, indices, dots: 0 } = node else { return None };
            let by = changes.iter().find(|(by, _)| by.id == *id && by.indices == *indices)?;
            Some(by.1.clone())
        });
        Ok(formula)
    }

    /// The names in a parenthesis, if all are known: the arguments of a function that is being defined.
    pub(in super::super) fn known_arguments(&mut self, item: &Item) -> Option<Vec<Variable>> {
        let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return None };
        let is_comma = |item: &Item| matches!(item.layout, Layout::Other(',' | ';'));
        let mut found = Vec::new();
        for argument in inside.split(is_comma) {
            let mut names = argument.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
            let (only, None) = (names.next()?, names.next()) else { return None };
            let printed = names::printed(only, self.branch).filter(|printed| printed.sup.is_none())?;
            let (id, indices) = self.symbols.find_or_assemble(&printed.name)?;
            // After a name that nothing defines yet, a constant in parentheses is a place as often as an argument.
            if !self.symbols.entry(id).varies {
                return None;
            }
            found.push(Variable { id, indices, dots: printed.dots });
        }
        Some(found)
    }
}

/// Names are defined by one another up to this depth where a function is taken at other arguments.
const MOST_DEFINITIONS: usize = 8;

/// Whether a symbol is an argument that has another value.
fn is_changed(changes: &[(Variable, Expr)], id: SymbolId) -> bool {
    changes.iter().any(|(by, _)| by.id == id)
}

fn unknown_formula(name: &str, span: Span) -> Fault {
    Fault::unsupported(span, format!("{name} with other arguments than in its definition is not supported here"))
        .help(format!("define {name} by one formula of its arguments, without other names that depend on them"))
}
