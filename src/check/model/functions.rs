//! Functions that a claims file declares, `"functions": { "V": "of r" }`: any smooth function.
//!
//! Such a function is a polynomial whose coefficients are drawn anew for each state. Its values and derivatives are then
//! independent random numbers, as those of any smooth function are, as long as there are no more of them than coefficients. So an
//! equation that holds for all these polynomials holds for every smooth function, if it has no more values of them:
//! [`crate::check::model::independent_values`] counts them, and no claim with more passes. Over
//! the field the coefficients are free numbers, like any constants. An integral of the function is not of that kind: a rule
//! of Gauss or Simpson is exact for all these polynomials. So such integrals are refused, except of a derivative of the
//! function (the reader of integrals knows the coefficients by [`crate::formula::symbols::Entry::coefficient`]).

use std::sync::Arc;

use crate::formula::calculus::any_function;
use crate::formula::symbols::{AnyFunction, Name};
use crate::formula::tree::{Expr, Node, Variable};
use crate::formula::{Kind, SymbolId, text};
use crate::latex::names;
use crate::notes::claims::{Claims, Declaration, Range, Role, Spanned};
use crate::source::Span;
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::builder::Builder;
use crate::check::model::meaning::{Meaning, Variable as Drawn};

/// The degree of the polynomial, by the number of arguments. Equations of motion and their rates contain derivatives of
/// a potential up to the third order. No derivative is of the order of the degree, since that is the same at all places.
const DEGREES: [u32; 3] = [8, 5, 4];

/// Adds a function whose arguments became known after the declarations; returns whether they all are.
///
/// # Errors
/// For an argument that is not a number, at its place.
pub(crate) fn declare_later(claims: &Claims, declaration: &Declaration, model: &mut Model) -> Result<bool> {
    let builder = Builder { claims, model: model.clone(), early: Vec::new() };
    if !builder.has_its_arguments(declaration)? {
        return Ok(false);
    }
    let mut builder = builder;
    builder.any_function(declaration)?;
    *model = builder.model;
    Ok(true)
}

/// The error that the arguments of a function are not known.
///
/// # Errors
/// For the first argument that is not known, at its place.
pub(crate) fn require(claims: &Claims, declaration: &Declaration, model: &Model) -> Result<()> {
    Builder { claims, model: model.clone(), early: Vec::new() }.any_function(declaration)
}

/// The declarations of functions whose arguments are not declared.
pub(crate) fn later<'c>(claims: &'c Claims, model: &Model) -> Vec<&'c Declaration> {
    let is_known = |declaration: &Declaration| {
        names::parse(&declaration.name.value).is_some_and(|(name, _)| model.symbols.find(&name).is_some())
    };
    let functions = claims.declarations.iter().filter(|declaration| declaration.role == Role::Function);
    functions.filter(|declaration| !is_known(declaration)).collect()
}

impl Builder<'_> {
    /// Whether all arguments of a function are known.
    pub(crate) fn has_its_arguments(&self, declaration: &Declaration) -> Result<bool> {
        let Range::Of(arguments) = &declaration.range.value else { return Ok(true) };
        for argument in arguments {
            let name = self.name(&Spanned::new(argument.clone(), declaration.range.span))?;
            if self.model.symbols.find(&name).is_none() {
                return Ok(false);
            }
        }
        Ok(true)
    }

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
            .help("declare it as a function of at most three names; the other names may be constants")
        })?;
        let mut variables = Vec::new();
        for argument in arguments {
            let place = Spanned::new(argument.clone(), declaration.range.span);
            let name = self.name(&place)?;
            let (id, indices) = self.model.symbols.find(&name).ok_or_else(|| self.undeclared(&place))?;
            let entry = self.model.symbols.entry(id);
            if entry.kind != Kind::Scalar || !entry.arguments.is_empty() {
                return Err(Error::at(
                    &self.claims.source,
                    declaration.range.span,
                    format!("the argument {name} is not a number"),
                )
                .help("the arguments of a function are coordinates, constants, the time, or what varies with it"));
            }
            variables.push(Variable { id, indices, dots: 0 });
        }
        let name = self.name(latex)?;
        let function = polynomial(&mut self.model, &name, variables.len(), degree).ok_or_else(|| {
            self.error(latex, format!("{name} is declared twice")).help("remove one of the two declarations")
        })?;
        let own: Vec<Expr> = variables.iter().map(own).collect();
        let value = any_function::at(&function, &vec![0; variables.len()], &own, Span::default());
        let id = self.add(latex, Kind::Scalar, Meaning::Defined(Box::new(value.clone())))?;
        self.model.symbols.mark_defined(id, &value, false);
        self.model.symbols.entry_mut(id).arguments.clone_from(&variables);
        self.derivatives_of(id, &name, (&function, &variables, &own));
        let of = arguments.iter().map(|argument| text::plain(argument)).collect::<Vec<_>>().join(", ");
        self.model.inferred.push(format!("{} is any smooth function of {of}", self.shown(id)));
        Ok(())
    }
}

impl Builder<'_> {
    /// Adds the derivatives of a function as symbols: `V'`, `V''`, … of one argument, `\frac{\partial V}{\partial x}`, …
    /// of several. The last ones have none of their own.
    fn derivatives_of(
        &mut self,
        id: SymbolId,
        name: &Name,
        (function, variables, own): (&AnyFunction, &[Variable], &[Expr]),
    ) {
        let most = if variables.len() == 1 { 4 } else { 2 };
        let mut known: Vec<(Vec<u32>, SymbolId)> = vec![(vec![0; variables.len()], id)];
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
                let formula = any_function::at(function, &orders, own, Span::default());
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

/// Makes a number that varies freely a function of the time with free coefficients, so that its rates are known beside those of the
/// coordinates. Returns whether that is possible: not for a vector, a family, and a number with a range that the function may leave.
pub(crate) fn of_the_time(model: &mut Model, id: SymbolId) -> bool {
    let Some(Meaning::Varying(at)) = model.meaning(id) else { return false };
    let at = *at;
    let drawn = &model.varying[at];
    if drawn.numbers != 1 || !matches!(drawn.range, Range::Any | Range::Angle) {
        return false;
    }
    let time = model.symbols.time.as_ref().and_then(|time| model.symbols.find(time)).map(|(id, _)| id);
    let Some(time) = time.filter(|id| matches!(model.meaning(*id), Some(Meaning::Time))) else { return false };
    let name = model.symbols.entry(id).name.clone();
    let Some(function) = polynomial(model, &name, 1, DEGREES[0]) else { return false };
    let value = any_function::at(
        &function,
        &[0],
        &[own(&Variable { id: time, indices: Vec::new(), dots: 0 })],
        Span::default(),
    );
    model.symbols.mark_defined(id, &value, false);
    model.mean(id, Meaning::Defined(Box::new(value)));
    model.varying.remove(at);
    for later in at..model.varying.len() {
        let symbol = model.varying[later].symbol;
        model.mean(symbol, Meaning::Varying(later));
    }
    model.inferred.push(format!(
        "{} is any smooth function of the time, since a force contains it",
        text::plain(&model.name(id))
    ));
    true
}

/// A polynomial of so many variables with free coefficients, which are new constants; `None` if it has these already.
fn polynomial(model: &mut Model, name: &Name, variables: usize, degree: u32) -> Option<Arc<AnyFunction>> {
    let mut terms = Vec::new();
    for powers in exponents(variables, degree) {
        let mut named = name.clone();
        named.subscript.push("(".to_owned());
        named.subscript.extend(powers.iter().map(u32::to_string));
        named.subscript.push(")".to_owned());
        let coefficient = model.symbols.add(named, Kind::Scalar)?;
        model.symbols.entry_mut(coefficient).hidden = true;
        model.mean(coefficient, Meaning::Constant(model.constants.len()));
        model.constants.push(Drawn::number(coefficient, Range::Any));
        terms.push((coefficient, powers));
    }
    let function = Arc::new(AnyFunction { name: name.clone(), terms, degree });
    for (coefficient, _) in &function.terms {
        model.symbols.entry_mut(*coefficient).coefficient = Some(function.clone());
    }
    Some(function)
}

/// An argument as a formula.
fn own(variable: &Variable) -> Expr {
    let Variable { id, indices, dots } = variable.clone();
    Expr::new(Node::Symbol { id, indices, dots }, Span::default())
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
