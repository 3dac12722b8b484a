//! Functions that a claims file declares, `"functions": { "V": "of r" }`: any smooth function.
//!
//! Such a function is a polynomial whose coefficients are drawn anew for each state. Its value and its derivatives up to
//! the degree are then independent random numbers at each point, as those of any smooth function are. So an equation
//! that holds for all these polynomials, and has derivatives up to that order, holds for every smooth function. Over
//! the field the coefficients are free numbers, like any constants. An integral of the function is not of that kind: a rule
//! of Gauss or Simpson is exact for all these polynomials. So such integrals are refused, except of a derivative of the
//! function (the reader of integrals knows the coefficients by [`crate::formula::symbols::Entry::coefficient`]).

use crate::formula::symbols::Name;
use crate::formula::tree::{Expr, Node, Term, Variable};
use crate::formula::{Kind, Sign, SymbolId, text};
use crate::latex::names;
use crate::notes::claims::{Claims, Declaration, Range, Role, Spanned};
use crate::source::Span;
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::builder::Builder;
use crate::check::model::meaning::{Meaning, Variable as Drawn};

/// The degree of the polynomial, by the number of arguments. Equations of motion and their rates contain derivatives of
/// a potential up to the third order.
const DEGREES: [u32; 3] = [7, 4, 3];

impl Builder<'_> {
    /// Adds a function as a polynomial of its arguments with free coefficients.
    pub(crate) fn any_function(&mut self, declaration: &Declaration) -> Result<()> {
        let Range::Of(arguments) = &declaration.range.value else { return Ok(()) };
        let latex = &declaration.name;
        let degree = DEGREES.get(arguments.len() - 1).copied().ok_or_else(|| {
            Error::at(
                &self.claims.source,
                declaration.range.span,
                "a function of more than three names is not supported",
            )
            .help("declare the function of those that matter, and treat the others as constants")
        })?;
        let mut variables = Vec::new();
        for argument in arguments {
            let place = Spanned::new(argument.clone(), declaration.range.span);
            let name = self.name(&place)?;
            let (id, indices) = self.model.symbols.find(&name).ok_or_else(|| self.undeclared(&place))?;
            let entry = self.model.symbols.entry(id);
            if entry.kind != Kind::Scalar || !entry.arguments.is_empty() {
                return Err(Error::at(&self.claims.source, declaration.range.span, format!("{name} is not a number"))
                    .help("the arguments of a function are coordinates, constants, the time, or what varies with it"));
            }
            variables.push(Variable { id, indices, dots: 0 });
        }
        let name = self.name(latex)?;
        let mut terms = Vec::new();
        for powers in exponents(variables.len(), degree) {
            let mut own = name.clone();
            own.subscript.push("(".to_owned());
            own.subscript.extend(powers.iter().map(u32::to_string));
            own.subscript.push(")".to_owned());
            let coefficient = self.model.symbols.add(own, Kind::Scalar).ok_or_else(|| {
                self.error(latex, format!("{name} is declared twice")).help("remove one of the two declarations")
            })?;
            let entry = self.model.symbols.entry_mut(coefficient);
            (entry.hidden, entry.coefficient) = (true, true);
            self.model.mean(coefficient, Meaning::Constant(self.model.constants.len()));
            self.model.constants.push(Drawn::number(coefficient, Range::Any));
            terms.push((coefficient, powers));
        }
        let value = polynomial(&terms, &variables, &vec![0; variables.len()]);
        let id = self.add(latex, Kind::Scalar, Meaning::Defined(Box::new(value.clone())))?;
        self.model.symbols.mark_defined(id, &value, false);
        self.model.symbols.entry_mut(id).arguments.clone_from(&variables);
        self.derivatives_of(id, &name, (&terms, &variables));
        let of = arguments.iter().map(|argument| text::plain(argument)).collect::<Vec<_>>().join(", ");
        self.model.inferred.push(format!("{} is any smooth function of {of}", self.shown(id)));
        Ok(())
    }
}

/// Adds a function of a name that a display defines: V(r) beside r = √(x² + y²).
///
/// # Errors
/// While an argument is not known.
pub(crate) fn declare(claims: &Claims, declaration: &Declaration, model: &mut Model) -> Result<()> {
    let mut builder = Builder { claims, model: model.clone(), early: Vec::new() };
    builder.any_function(declaration)?;
    *model = builder.model;
    Ok(())
}

/// The functions that a model lacks, because an argument of theirs is defined by a display.
pub(crate) fn waiting<'a>(claims: &'a Claims, model: &Model) -> Vec<&'a Declaration> {
    let is_known = |declaration: &Declaration| {
        names::parse(&declaration.name.value).is_some_and(|(name, _)| model.symbols.find(&name).is_some())
    };
    let all = claims.declarations.iter();
    all.filter(|declaration| declaration.role == Role::Function && !is_known(declaration)).collect()
}

impl Builder<'_> {
    /// Whether an argument of a function is not declared, so that a display may define it.
    pub(crate) fn waits_for_a_display(&self, declaration: &Declaration) -> bool {
        let Range::Of(arguments) = &declaration.range.value else { return false };
        let is_known = |argument: &String| match names::parse(argument) {
            Some((name, 0)) => self.model.symbols.find(&name).is_some(),
            _ => true,
        };
        !arguments.iter().all(is_known)
    }

    /// Adds the derivatives of a function as symbols: `V'`, `V''`, … of one argument, `\frac{\partial V}{\partial x}`, …
    /// of several. The last ones have none of their own.
    fn derivatives_of(&mut self, function: SymbolId, name: &Name, (terms, variables): (&[Monomial], &[Variable])) {
        let most = if variables.len() == 1 { 4 } else { 2 };
        let mut known: Vec<(Vec<u32>, SymbolId)> = vec![(vec![0; variables.len()], function)];
        let mut at = 0;
        while let Some((orders, id)) = known.get(at).cloned() {
            at += 1;
            if orders.iter().sum::<u32>() == most {
                continue;
            }
            let mut derivatives = Vec::new();
            for argument in 0..variables.len() {
                let mut orders = orders.clone();
                orders[argument] += 1;
                if let Some((_, id)) = known.iter().find(|(other, _)| *other == orders) {
                    derivatives.push(*id);
                    continue;
                }
                let Some(id) = self.model.symbols.add(self.derivative_name(name, variables, &orders), Kind::Scalar)
                else {
                    return;
                };
                let formula = polynomial(terms, variables, &orders);
                self.model.symbols.mark_defined(id, &formula, false);
                self.model.symbols.entry_mut(id).arguments = variables.to_vec();
                self.model.mean(id, Meaning::Defined(Box::new(formula)));
                known.push((orders, id));
                derivatives.push(id);
            }
            self.model.symbols.entry_mut(id).derivatives = derivatives;
        }
    }

    fn derivative_name(&self, name: &Name, variables: &[Variable], orders: &[u32]) -> Name {
        let total: u32 = orders.iter().sum();
        if variables.len() == 1 {
            return Name { primes: name.primes + total as u8, ..name.clone() };
        }
        let power = |order: u32| if order > 1 { format!("^{order}") } else { String::new() };
        let below: String = variables
            .iter()
            .zip(orders)
            .filter(|(_, order)| **order > 0)
            .map(|(variable, order)| format!("\\partial {}{}", self.model.name(variable.id), power(*order)))
            .collect();
        Name::plain(format!("\\frac{{\\partial{} {name}}}{{{below}}}", power(total)))
    }
}

/// A coefficient, and the exponent of each argument.
type Monomial = (SymbolId, Vec<u32>);

/// The derivative of these orders of the polynomial Σ c x^a y^b / (a! b!).
fn polynomial(terms: &[Monomial], variables: &[Variable], orders: &[u32]) -> Expr {
    let kept = terms.iter().filter_map(|(coefficient, powers)| {
        let left: Option<Vec<u32>> =
            powers.iter().zip(orders).map(|(power, order)| power.checked_sub(*order)).collect();
        Some(Term { sign: Sign::Plus, sign_span: None, expr: monomial(*coefficient, variables, &left?) })
    });
    Expr::new(Node::Sum(kept.collect()), Span::default())
}

/// All exponents of so many variables with a sum up to `degree`.
fn exponents(variables: usize, degree: u32) -> Vec<Vec<u32>> {
    match variables {
        0 => vec![Vec::new()],
        _ => (0..=degree)
            .flat_map(|first| {
                exponents(variables - 1, degree - first).into_iter().map(move |rest| [vec![first], rest].concat())
            })
            .collect(),
    }
}

/// `c x^a y^b / (a! b!)`, so that the terms are of like size.
fn monomial(coefficient: SymbolId, variables: &[Variable], powers: &[u32]) -> Expr {
    let node = |node: Node| Expr::new(node, Span::default());
    let number = |value: u32| Expr::integer(value, Span::default());
    let mut factors = vec![node(Node::Symbol { id: coefficient, indices: Vec::new(), dots: 0 })];
    let mut below = 1;
    for (variable, power) in variables.iter().zip(powers) {
        let Variable { id, indices, dots } = variable.clone();
        let base = node(Node::Symbol { id, indices, dots });
        match power {
            0 => {}
            1 => factors.push(base),
            _ => factors.push(node(Node::Power(Box::new(base), Box::new(number(*power))))),
        }
        below *= (1..=*power).product::<u32>();
    }
    let above = match factors.len() {
        1 => factors.swap_remove(0),
        _ => node(Node::Product(factors)),
    };
    match below {
        1 => above,
        _ => node(Node::Quotient(Box::new(above), Box::new(number(below)))),
    }
}
