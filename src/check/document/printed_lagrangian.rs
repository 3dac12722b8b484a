//! The system of a Lagrangian that the notes print: `"means": { "L": "Lagrangian" }` without a `"system"`.
//!
//! The display that defines L is evaluated once over symbols, as a Lagrangian in Rust is, through all names that other
//! displays define. The result is traced like any other system, so everything that follows from a Lagrangian in Rust
//! follows from this one. The display itself is what is taken for granted.

use std::sync::Arc;

use crate::formula::tree::Variable;
use crate::formula::{Expr, Relation, SymbolId, Value, derivative, text};
use crate::latex::{Reading, name_search, read_formula};
use crate::mechanics::{Applied, LinearSolver, System};
use crate::notes::Notes;
use crate::notes::claims::{Claims, Spanned};
use crate::scalar::Symbol;
use crate::source::Fault;
use crate::suggest::in_json;
use crate::{Error, Result};

use crate::check::document::unreadable::faults;
use crate::check::document::{motion_by_laws, normal_frequencies};
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::claims_error::formula_error;
use crate::check::model::functions;
use crate::check::model::meaning::Meaning;
use crate::check::model::order::derivatives;
use crate::check::model::sampling::Mode;
use crate::check::state::numbers::{Layout, Slot, slots};
use crate::check::state::sampled_state::SampledState;

/// Gives a model the system of the Lagrangian that the notes print, if the claims file says that they print one.
///
/// # Errors
/// At the name in the claims file, where no display defines it, or where its formula is not a Lagrangian.
pub(crate) fn make((claims, notes): (&Claims, &Notes), readings: &[Reading], model: &mut Model) -> Result<()> {
    let Some(printed) = model.printed_lagrangian.clone() else { return no_forces(claims) };
    let error = |message: String| Error::at(&claims.source, printed.place, message);
    let shown = text::plain(&printed.lagrangian.to_string());
    let found = model.symbols.find(&printed.lagrangian).map(|(id, _)| id);
    let Some((symbol, Some(Meaning::Defined(_)))) = found.map(|id| (id, model.meaning(id))) else {
        let latex = printed.lagrangian.to_string();
        let begins = |at: &usize| notes.equations[*at].text.trim_start().starts_with(&latex);
        let fault = |at: usize| faults(&readings[at]).next().map(|fault| (at, fault.clone()));
        if let Some((at, fault)) = (0..readings.len()).filter(begins).find_map(fault) {
            let fault = fault.shifted(notes.equations[at].body.start);
            let message = format!("the Lagrangian {shown} could not be read: {}", fault.message);
            // What moves in a Lagrangian is a coordinate of it.
            let help = fault.help.as_ref().map(|help| help.replace("\"varies with time\"", "\"coordinates\""));
            return Err(Error::fault(&notes.source, Fault { message, help, ..fault }));
        }
        return Err(error(format!("no display that can be read defines {shown}, the Lagrangian")).help(format!(
            "write a display {shown} = …, with all its symbols declared; or name a system under \"system\""
        )));
    };
    if model.coordinates.is_empty() {
        return Err(error(format!("{shown} has no coordinates"))
            .help("declare them under \"coordinates\", as in \"coordinates\": { \"\\\\theta\": \"angle\" }"));
    }
    let (name, meaning) = (|id: SymbolId| text::plain(&model.name(id)), |id: SymbolId| model.meaning(id));
    let feeds = leaves(model, symbol);
    if let Some(free) = feeds.iter().find(|id| matches!(meaning(**id), Some(Meaning::Varying(_)))) {
        let (free, latex) = (name(*free), model.name(*free));
        return Err(error(format!("{shown} contains {free}, and nothing says how {free} varies with time")).help(
            format!(
                "declare {free} under \"coordinates\", or write \"functions\": {{ {}: \"of t\" }}",
                in_json(&latex)
            ),
        ));
    }
    if let Some(other) = feeds.iter().find(|id| matches!(meaning(**id), Some(Meaning::System(_)))) {
        return Err(error(format!("{shown} contains {}, which is itself derived from {shown}", name(*other)))
            .help("write the Lagrangian in coordinates and velocities"));
    }
    let formula = Expr::new(crate::formula::Node::Symbol { id: symbol, indices: Vec::new(), dots: 0 }, printed.place);
    applied_forces(claims, model)?;
    forces_of_the_time(claims, model)?;
    if derivatives(&formula, model) > 1 {
        return match motion_by_laws::of_the_lagrangian(model, symbol) {
            true => Ok(()),
            false => Err(error(format!("no motion follows from {shown}, which contains accelerations"))
                .help("subtract a total time derivative, so that only velocities are left")),
        };
    }
    trace(model, symbol).map_err(|refused| {
        let help = refused.advice().map(str::to_owned);
        let error = error(format!("no motion follows from {shown}: {}", refused.message()));
        match help {
            Some(help) => error.help(help),
            None => error,
        }
    })?;
    if motion_by_laws::is_singular(model) && motion_by_laws::of_the_lagrangian(model, symbol) {
        return Ok(());
    }
    let coordinates: Vec<String> = model.coordinates.iter().map(|c| text::plain(&model.name(c.symbol))).collect();
    model.inferred.push(format!(
        "the system is the Lagrangian {shown} that the notes define, in the coordinates {}",
        coordinates.join(", ")
    ));
    let multipliers = model.system.as_ref().map_or(Vec::new(), |system| system.multipliers().to_vec());
    for at in multipliers {
        let name = coordinates[at].clone();
        if model.printed_lagrangian.as_ref().is_some_and(|printed| printed.constraints.iter().any(|(k, _)| *k == at)) {
            continue;
        }
        model.inferred.push(format!(
            "{name} is a Lagrange multiplier: with f = ∂{shown}/∂{name}, all motions obey the constraint f = 0, and \
             its force is {name} ∂f/∂q"
        ));
    }
    Ok(())
}

/// Rejects forces and a dissipation function where the notes print no Lagrangian.
fn no_forces(claims: &Claims) -> Result<()> {
    let force = claims.forces.first().map(|(name, _)| ("forces", name.span));
    let force = force.or_else(|| claims.constraints.first().map(|(name, _)| ("constraints", name.span)));
    match force.or(claims.dissipation.as_ref().map(|function| ("dissipation", function.span))) {
        None => Ok(()),
        Some((key, span)) => {
            let message = format!("\"{key}\" needs a Lagrangian that the notes print");
            Err(Error::at(&claims.source, span, message)
                .help("print it in a display, and write \"means\": { \"L\": \"Lagrangian\" } without a \"system\""))
        }
    }
}

/// Reads the forces and the dissipation function of the claims file.
///
/// # Errors
/// For a name that is no coordinate, and a formula that cannot be read or contains accelerations.
fn applied_forces(claims: &Claims, model: &mut Model) -> Result<()> {
    let read = |latex: &Spanned<String>| {
        let formula = read_formula(&latex.value, &mut model.symbols.clone(), &model.macros)
            .map_err(|fault| formula_error(claims, latex, fault))?;
        match derivatives(&formula, model) > 1 {
            true => {
                Err(Error::at(&claims.source, latex.span, "a force contains accelerations, which is not supported")
                    .help("write it with coordinates, velocities and the time"))
            }
            false => Ok(formula),
        }
    };
    let place = |name: &Spanned<String>| {
        let is_it = |symbol: SymbolId| name_search::same(&model.name(symbol), &name.value);
        model.coordinates.iter().position(|coordinate| is_it(coordinate.symbol)).ok_or_else(|| {
            Error::at(&claims.source, name.span, format!("{} is not a coordinate", name.value))
                .help("each force has the name of its coordinate: \"forces\": { \"x\": \"-b \\\\dot x\" }")
        })
    };
    let constraint = |(name, formula): &(Spanned<String>, Spanned<String>)| {
        let at = place(name).map_err(|error| {
            error.help("each constraint has the name of its multiplier, which is declared under \"coordinates\"")
        })?;
        Ok((at, read(formula)?))
    };
    let constraints: Vec<(usize, Expr)> = claims.constraints.iter().map(constraint).collect::<Result<_>>()?;
    let dissipation = claims.dissipation.as_ref().map(read).transpose()?;
    let forces = claims.forces.iter().map(|(name, force)| Ok((place(name)?, read(force)?))).collect::<Result<_>>()?;
    if let Some(printed) = &mut model.printed_lagrangian {
        (printed.dissipation, printed.forces, printed.constraints) = (dissipation, forces, constraints);
    }
    Ok(())
}

/// Makes names that vary freely functions of the time where a force, the dissipation function or a constraint contains them:
/// the motion follows from all that it depends on, with its rates.
///
/// # Errors
/// For a name that is no single number, or has a range.
fn forces_of_the_time(claims: &Claims, model: &mut Model) -> Result<()> {
    let Some(printed) = &model.printed_lagrangian else { return Ok(()) };
    let formulas = printed.forces.iter().chain(&printed.constraints).map(|(_, formula)| formula);
    let roots: Vec<SymbolId> =
        formulas.chain(&printed.dissipation).flat_map(Expr::symbols).map(|(root, _)| root).collect();
    let place = printed.place;
    for free in roots.into_iter().flat_map(|root| leaves(model, root)).collect::<Vec<_>>() {
        if !matches!(model.meaning(free), Some(Meaning::Varying(_))) || functions::of_the_time(model, free) {
            continue;
        }
        let shown = text::plain(&model.name(free));
        let message = format!(
            "a force contains {shown}, which varies with time and has a range or several components; this is not \
             supported"
        );
        return Err(Error::at(&claims.source, place, message).help(format!(
            "declare {shown} as \"any\", or as a function \"of t\", and put its range under \"assume\""
        )));
    }
    Ok(())
}

/// Traces the Lagrangian again, with the definitions as they are now. Nothing happens where the notes print none.
///
/// # Errors
/// When its formula is no number made of coordinates, velocities, constants and the time.
pub(crate) fn retrace(model: &mut Model) -> Result<()> {
    if motion_by_laws::again(model)? {
        return Ok(());
    }
    let Some(printed) = &model.printed_lagrangian else { return Ok(()) };
    match model.symbols.find(&printed.lagrangian) {
        Some((symbol, _)) => trace(model, symbol),
        None => Ok(()),
    }
}

/// Whether the Lagrangian that the notes print is this symbol, or is defined by it.
pub(crate) fn is_part(model: &Model, symbol: SymbolId) -> bool {
    let printed = model.printed_lagrangian.as_ref().and_then(|printed| model.symbols.find(&printed.lagrangian));
    let printed = printed.map(|(lagrangian, _)| lagrangian).or_else(|| motion_by_laws::hamiltonian(model));
    printed.is_some_and(|printed| printed == symbol || chain(model, printed).contains(&symbol))
        || is_force(model, symbol)
}

/// Whether the dissipation function or a force beside the Lagrangian is this symbol, or is defined by it.
pub(crate) fn is_force(model: &Model, symbol: SymbolId) -> bool {
    let Some(printed) = &model.printed_lagrangian else { return false };
    let formulas = printed.dissipation.iter().chain(printed.forces.iter().map(|(_, force)| force));
    let mut roots = formulas.flat_map(Expr::symbols);
    roots.any(|(root, _)| root == symbol || chain(model, root).contains(&symbol))
}

fn trace(model: &mut Model, symbol: SymbolId) -> Result<()> {
    let coordinates: Vec<String> = model.coordinates.iter().map(|c| model.name(c.symbol)).collect();
    let places: Vec<usize> = (0..model.constants.len()).filter(|at| model.constants[*at].numbers == 1).collect();
    let parameters: Vec<String> = places.iter().map(|at| model.name(model.constants[*at].symbol)).collect();
    let name = model.printed_lagrangian.as_ref().map_or_else(String::new, |printed| printed.system.clone());
    let potential = model.printed_lagrangian.as_ref().and_then(|printed| printed.potential.as_ref());
    let potential = potential.and_then(|name| model.symbols.find(name)).map(|(id, _)| id);
    let node = |id: SymbolId| {
        let node = crate::formula::Node::Symbol { id, indices: Vec::new(), dots: 0 };
        Expr::new(node, crate::source::Span::default())
    };
    let applied =
        model.printed_lagrangian.clone().map(|printed| (printed.dissipation, printed.forces, printed.constraints));
    let (dissipation, forces, beside) = applied.unwrap_or_default();
    let has_potential = potential.is_some();
    let mut formulas: Vec<Expr> = std::iter::once(symbol).chain(potential).map(node).collect();
    let first_force = formulas.len();
    formulas.extend(forces.iter().map(|(_, force)| force.clone()).chain(dissipation.clone()));
    let first_constraint = formulas.len();
    // ḟ = 0 has the same forces as f = 0, since ∂ḟ/∂q̇ = ∂f/∂q.
    formulas.extend(beside.iter().map(|(_, constraint)| match derivatives(constraint, model) {
        0 => Expr::new(crate::formula::Node::TimeDerivative(1, Box::new(constraint.clone())), constraint.span),
        _ => constraint.clone(),
    }));
    let mut bare = model.clone();
    bare.system = None;
    let mut readable = true;
    let system = System::of_lagrangian(&name, coordinates, parameters, |time, q, v, parameters| {
        let values = symbolic(&bare, time, (q, v), (&places, parameters), &formulas);
        readable = values.is_some();
        let values = values.unwrap_or_else(|| vec![Symbol::from(f64::NAN); formulas.len()]);
        let mut applied = Applied::default();
        if !forces.is_empty() {
            applied.forces = vec![Symbol::from(0.0); q.len()];
            for ((coordinate, _), value) in forces.iter().zip(&values[first_force..]) {
                applied.forces[*coordinate] += *value;
            }
        }
        applied.dissipation = dissipation.as_ref().and_then(|_| values.get(first_constraint - 1).copied());
        let multipliers = beside.iter().map(|(multiplier, _)| *multiplier);
        applied.constraints = multipliers.zip(values[first_constraint..].iter().copied()).collect();
        (values[0], has_potential.then(|| values[1]), applied)
    })?;
    if !readable {
        return Err(Error::new(
            "the Lagrangian, a force or a constraint is not a number made of coordinates, velocities, constants and \
             the time",
        )
        .help("use only declared coordinates, their dots, constants and the time in these formulas"));
    }
    model.constraints = constraints(model, symbol, system.multipliers())?;
    normal_frequencies::define(model)?;
    (model.system, model.parameters) = (Some(Arc::new(system)), places);
    Ok(())
}

/// The constraints f = ∂L/∂λ = 0 of the multipliers, and ḟ = 0.
///
/// # Errors
/// Where the Lagrangian has no derivative by a multiplier as a formula.
fn constraints(model: &Model, lagrangian: SymbolId, multipliers: &[usize]) -> Result<Vec<Hypothesis>> {
    let mut all = Vec::new();
    let place = crate::source::Span::default();
    let formula = Expr::new(crate::formula::Node::Symbol { id: lagrangian, indices: Vec::new(), dots: 0 }, place);
    let beside = model.printed_lagrangian.as_ref().map_or(&[][..], |printed| &printed.constraints);
    for at in multipliers {
        if let Some((_, constraint)) = beside.iter().find(|(multiplier, _)| multiplier == at) {
            all.extend(conditions(constraint, derivatives(constraint, model) == 0));
            continue;
        }
        let by = Variable { id: model.coordinates[*at].symbol, indices: Vec::new(), dots: 0 };
        let scope = derivative::Scope { symbols: &model.symbols, fixed: &[] };
        let constraint = derivative::partial(&formula, &by, scope, place).map_err(|_| {
            let name = text::plain(&model.name(by.id));
            Error::new(format!("the constraint that {name} multiplies cannot be written as a formula"))
                .help("write the constraint with sums, products, powers and elementary functions")
        })?;
        all.extend(conditions(&constraint, true));
    }
    Ok(all)
}

/// f = 0 and, for a constraint without velocities, ḟ = 0.
fn conditions(constraint: &Expr, is_holonomic: bool) -> impl Iterator<Item = Hypothesis> {
    let place = constraint.span;
    let rate = Expr::new(crate::formula::Node::TimeDerivative(1, Box::new(constraint.clone())), place);
    let vanishing = [constraint.clone(), rate].into_iter().take(if is_holonomic { 2 } else { 1 });
    vanishing.map(move |lhs| {
        let rhs = Expr::integer(0, place);
        Hypothesis::of(Link { lhs, relation: Relation::Equal, rhs, free: Vec::new() }, false)
    })
}

/// Symbols that define a symbol, through other definitions too, down to those that no formula defines.
fn chain(model: &Model, symbol: SymbolId) -> Vec<SymbolId> {
    let (mut found, mut at) = (vec![symbol], 0);
    while let Some(next) = found.get(at).copied() {
        at += 1;
        if let Some(Meaning::Defined(formula)) = model.meaning(next) {
            for (id, _) in formula.symbols() {
                if !found.contains(&id) {
                    found.push(id);
                }
            }
        }
    }
    found
}

/// The symbols that a symbol consists of, which no formula defines.
fn leaves(model: &Model, symbol: SymbolId) -> Vec<SymbolId> {
    let is_leaf = |id: &SymbolId| !matches!(model.meaning(*id), Some(Meaning::Defined(_)));
    chain(model, symbol).into_iter().filter(is_leaf).collect()
}

/// Formulas as symbolic values; `None`, if one of them is not a number made of time, coordinates, velocities and
/// constants. `places` are those of the parameters among the constants of the model.
pub(crate) fn symbolic(
    model: &Model,
    time: Symbol,
    (q, v): (&[Symbol], &[Symbol]),
    (places, parameters): (&[usize], &[Symbol]),
    formulas: &[Expr],
) -> Option<Vec<Symbol>> {
    let state = symbolic_state(model, time, (q, v), (places, parameters))?;
    let value = |formula: &Expr| match state.now(formula, &[]) {
        Ok(Value::Scalar(value)) => Some(value),
        _ => None,
    };
    formulas.iter().map(value).collect()
}

/// The state whose coordinates, velocities and constants are symbols; all else that is sampled is no number there.
pub(crate) fn symbolic_state<'m>(
    model: &'m Model,
    time: Symbol,
    (q, v): (&[Symbol], &[Symbol]),
    (places, parameters): (&[usize], &[Symbol]),
) -> Option<SampledState<'m, Symbol>> {
    let mode = Mode { on_shell: false, order: 1 };
    let number = |(at, slot): (usize, &Slot)| {
        let coordinate = model.coordinates.iter().position(|c| Some(c.symbol) == slot.symbol);
        let constant = places.iter().position(|place| Some(model.constants[*place].symbol) == slot.symbol);
        match (coordinate, constant, slot.order) {
            (Some(i), _, 0) => q[i],
            (Some(i), _, 1) => v[i],
            (_, Some(i), 0) => parameters[i],
            _ if at == 0 => time,
            // A Lagrangian contains nothing else that is sampled.
            _ => Symbol::from(f64::NAN),
        }
    };
    let base: Vec<Symbol> = slots(model, mode).iter().enumerate().map(number).collect();
    let layout = Arc::new(Layout::of(model, mode));
    SampledState::by(LinearSolver::CramersRule, 2, model, mode, (&layout, &base), &Arc::from([])).ok()
}
