//! Motions that laws determine: Hamilton's equations of a Hamiltonian that the notes print, and the Euler–Lagrange equations of
//! a Lagrangian that does not give all accelerations.
//!
//! Such a Lagrangian is singular, linear in the velocities, or contains accelerations. Its equations are formed as formulas
//! and hold like laws: each is solved for the highest derivative in it, and what has none restricts the states. The
//! coordinates are then free functions of the time, and momenta and the energy are defined by formulas.

use crate::formula::derivative::{self, Scope};
use crate::formula::tree::{Sign, Term, Variable};
use crate::formula::{Expr, Node, Relation, SymbolId, text};
use crate::notes::claims::Claims;
use crate::source::Span;
use crate::suggest::in_json;
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Law, Link};
use crate::check::model::meaning::{Meaning, Quantity};
use crate::check::model::order::derivatives;
use crate::check::model::sampling::{Mode, Spread};
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::setting::Setting;

/// The number of states at which a mass matrix is tried.
const STATES: usize = 24;

/// Lets Hamilton's equations move the coordinates and momenta, if the notes print the Hamiltonian.
///
/// # Errors
/// At the name in the claims file, where no display defines it, or where its formula is no Hamiltonian.
pub(crate) fn of_the_hamiltonian(claims: &Claims, model: &mut Model) -> Result<()> {
    let Some(printed) = model.printed_hamiltonian.clone() else { return Ok(()) };
    let error = |message: String| Error::at(&claims.source, printed.place, message);
    let shown = text::plain(&printed.hamiltonian.to_string());
    let Some(symbol) = hamiltonian(model) else {
        return Err(error(format!("no display that can be read defines {shown}, the Hamiltonian"))
            .help(format!("write a display {shown} = …, in coordinates and momenta, with all its symbols declared")));
    };
    if model.symbols.canonical.is_empty() {
        return Err(error(format!("{shown} has no coordinates"))
            .help("declare them under \"coordinates\", as in \"coordinates\": { \"q\": \"any\" }"));
    }
    if let Some((q, _)) = model.symbols.canonical.iter().find(|(_, momenta)| momenta.is_empty()) {
        let q = model.name(*q);
        return Err(error(format!("the momentum of {} has no name", text::plain(&q)))
            .help(format!("say which name it has: \"means\": {{ \"p\": {} }}", in_json(&format!("momentum of {q}")))));
    }
    if derivatives(&itself(symbol), model) > 0 {
        return Err(
            error(format!("{shown} contains velocities")).help("write the Hamiltonian in coordinates and momenta")
        );
    }
    let law = hamilton(model, symbol).ok_or_else(|| {
        error(format!("the derivatives of {shown} cannot be written as formulas"))
            .help(format!("write {shown} with sums, products, powers and elementary functions"))
    })?;
    model.laws.push(law);
    let names: Vec<String> = model.symbols.canonical.iter().map(|(q, _)| text::plain(&model.name(*q))).collect();
    model.inferred.push(format!(
        "the coordinates {} move by Hamilton's equations of {shown}, which the notes define",
        names.join(", ")
    ));
    Ok(())
}

/// Whether the traced Lagrangian gives no accelerations at any state that is tried.
pub(crate) fn is_singular(model: &Model) -> bool {
    let setting = Setting {
        hypotheses: &[],
        local: &[],
        mode: Mode { on_shell: true, order: 2 },
        spread: Spread::Declared,
        effort: usize::MAX,
    };
    Ensemble::named(model, &setting, STATES, 1, "regular").is_err()
}

/// Lets the Euler–Lagrange equations move the coordinates as laws; returns whether they do. They do not if a coordinate does not
/// occur in the Lagrangian, or if there are constraints beside it.
pub(crate) fn of_the_lagrangian(model: &mut Model, symbol: SymbolId) -> bool {
    let has_constraints = model.printed_lagrangian.as_ref().is_some_and(|printed| !printed.constraints.is_empty());
    let occurs = |id: SymbolId| model.depends_on(&itself(symbol), &[id]);
    if has_constraints || !model.coordinates.iter().all(|coordinate| occurs(coordinate.symbol)) {
        return false;
    }
    let mut changed = model.clone();
    (changed.system, changed.constraints) = (None, Vec::new());
    let coordinates: Vec<SymbolId> = changed.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    changed.let_coordinates_vary();
    if !define_quantities(&mut changed, symbol, &coordinates) {
        return false;
    }
    let Some(law) = euler_lagrange(&changed, symbol) else { return false };
    // λ(r − a) = 0 holds with λ = 0 or with r = a, and a state that solves it is always at one of the two.
    if law.hypotheses.iter().any(|equation| may_have_branches(&changed, equation)) {
        return false;
    }
    changed.laws.push(law);
    let shown = text::plain(&changed.name(symbol));
    changed.inferred.push(format!(
        "the Lagrangian {shown} does not determine all accelerations, so its equations of motion are used as laws"
    ));
    *model = changed;
    true
}

/// Whether an equation may be met in more than one way: it has no derivative and is not linear in the coordinates, or it is a
/// product of several factors that vary.
fn may_have_branches(model: &Model, equation: &Hypothesis) -> bool {
    let coordinates: Vec<SymbolId> = model.symbols.canonical.iter().map(|(q, _)| *q).collect();
    let varies = |expr: &Expr| model.depends_on(expr, &coordinates);
    let is_product = |expr: &Expr| match &expr.node {
        Node::Product(factors) => factors.iter().filter(|factor| varies(factor)).count() > 1,
        _ => false,
    };
    let is_one_product = match &equation.lhs.node {
        Node::Sum(terms) => matches!(terms.as_slice(), [only] if is_product(&only.expr)),
        _ => is_product(&equation.lhs),
    };
    if derivatives(&equation.lhs, model) > 0 || derivatives(&equation.rhs, model) > 0 {
        return is_one_product;
    }
    let scope = Scope { symbols: &model.symbols, fixed: &coordinates };
    let by = |expr: &Expr, id: SymbolId| {
        let by = Variable { id, indices: Vec::new(), dots: 0 };
        derivative::partial(expr, &by, scope, Span::default()).ok()
    };
    let is_linear = coordinates.iter().all(|a| {
        let first = by(&equation.lhs, *a);
        coordinates.iter().all(|b| first.as_ref().and_then(|first| by(first, *b)).is_some_and(|both| both.is_zero()))
    });
    !is_linear
}

/// Forms the laws again, with the definitions as they are now; returns whether there are any.
pub(crate) fn again(model: &mut Model) -> Result<bool> {
    if !model.laws.iter().any(|law| law.derived) {
        return Ok(false);
    }
    let law = match (hamiltonian(model), lagrangian(model)) {
        (Some(symbol), _) => hamilton(model, symbol),
        (None, Some(symbol)) => {
            let coordinates: Vec<SymbolId> = model.symbols.canonical.iter().map(|(q, _)| *q).collect();
            define_quantities(model, symbol, &coordinates).then(|| euler_lagrange(model, symbol)).flatten()
        }
        (None, None) => None,
    };
    let law = law.ok_or_else(|| Error::new("the equations of motion cannot be formed"))?;
    model.laws.retain(|law| !law.derived);
    model.laws.push(law);
    Ok(true)
}

/// The symbol of the Hamiltonian that the notes print.
pub(crate) fn hamiltonian(model: &Model) -> Option<SymbolId> {
    let (id, _) = model.symbols.find(&model.printed_hamiltonian.as_ref()?.hamiltonian)?;
    matches!(model.meaning(id), Some(Meaning::Defined(_))).then_some(id)
}

fn lagrangian(model: &Model) -> Option<SymbolId> {
    model.symbols.find(&model.printed_lagrangian.as_ref()?.lagrangian).map(|(id, _)| id)
}

fn itself(id: SymbolId) -> Expr {
    rate_of(id, 0)
}

fn rate_of(id: SymbolId, dots: u8) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, Span::default())
}

/// q̇ = ∂H/∂p and ṗ = −∂H/∂q.
fn hamilton(model: &Model, symbol: SymbolId) -> Option<Law> {
    let pairs: Vec<(SymbolId, SymbolId)> =
        model.symbols.canonical.iter().filter_map(|(q, momenta)| Some((*q, *momenta.first()?))).collect();
    let fixed: Vec<SymbolId> = pairs.iter().flat_map(|(q, p)| [*q, *p]).collect();
    let scope = Scope { symbols: &model.symbols, fixed: &fixed };
    let by = |id: SymbolId| {
        let by = Variable { id, indices: Vec::new(), dots: 0 };
        derivative::partial(&itself(symbol), &by, scope, Span::default()).ok()
    };
    let mut hypotheses = Vec::new();
    for (q, p) in pairs {
        hypotheses.push(equation(rate_of(q, 1), by(p)?));
        hypotheses.push(equation(rate_of(p, 1), by(q)?.negated()));
    }
    Some(Law {
        name: "Hamilton's equations".to_owned(),
        printed: Vec::new(),
        hypotheses,
        units_off: false,
        derived: true,
    })
}

/// ∂L/∂q − d/dt ∂L/∂q̇ + d²/dt² ∂L/∂q̈ = 0, with the forces beside the Lagrangian.
fn euler_lagrange(model: &Model, symbol: SymbolId) -> Option<Law> {
    let highest = derivatives(&itself(symbol), model) as u8;
    let mut hypotheses = Vec::new();
    for (place, (q, _)) in model.symbols.canonical.iter().enumerate() {
        let mut terms = Vec::new();
        for dots in (0..=highest).rev() {
            let partial = partial(model, symbol, *q, dots)?;
            let sign = if dots % 2 == 0 { Sign::Minus } else { Sign::Plus };
            let expr = match dots {
                0 => partial,
                _ => Expr::new(Node::TimeDerivative(dots, Box::new(partial)), Span::default()),
            };
            if !matches!(&expr.node, Node::TimeDerivative(_, inner) if inner.is_zero()) && !expr.is_zero() {
                terms.push(Term { sign, sign_span: None, expr });
            }
        }
        if !terms.is_empty() {
            hypotheses.push(equation(Expr::new(Node::Sum(terms), Span::default()), force(model, place, *q)?));
        }
    }
    let name = "the Euler–Lagrange equations".to_owned();
    Some(Law { name, printed: Vec::new(), hypotheses, units_off: false, derived: true })
}

/// The force on a coordinate that the Lagrangian does not contain.
fn force(model: &Model, place: usize, q: SymbolId) -> Option<Expr> {
    let printed = model.printed_lagrangian.as_ref()?;
    let mut terms = Vec::new();
    for (_, force) in printed.forces.iter().filter(|(at, _)| *at == place) {
        terms.push(Term { sign: Sign::Plus, sign_span: None, expr: force.clone() });
    }
    if let Some(dissipation) = &printed.dissipation {
        let by = Variable { id: q, indices: Vec::new(), dots: 1 };
        let scope = Scope { symbols: &model.symbols, fixed: &[] };
        let expr = derivative::partial(dissipation, &by, scope, Span::default()).ok()?;
        terms.push(Term { sign: Sign::Minus, sign_span: None, expr });
    }
    Some(match terms.is_empty() {
        true => Expr::integer(0, Span::default()),
        false => Expr::new(Node::Sum(terms), Span::default()),
    })
}

/// Defines the momenta, the forces ∂L/∂q and the energy by formulas; returns whether that is possible.
fn define_quantities(model: &mut Model, symbol: SymbolId, coordinates: &[SymbolId]) -> bool {
    let derived: Vec<(SymbolId, Quantity)> = (0..model.symbols.len())
        .map(SymbolId)
        .filter_map(|id| match model.meaning(id) {
            Some(Meaning::System(quantity)) => Some((id, *quantity)),
            _ => None,
        })
        .collect();
    let partials: Option<Vec<(Expr, Expr)>> =
        coordinates.iter().map(|q| Some((partial(model, symbol, *q, 0)?, partial(model, symbol, *q, 1)?))).collect();
    let Some(partials) = partials else { return false };
    for (id, quantity) in derived {
        let formula = match quantity {
            Quantity::Momentum(at) => partials[at].1.clone(),
            Quantity::Force(at) => partials[at].0.clone(),
            Quantity::Energy => {
                let term = |(q, (_, momentum)): (&SymbolId, &(Expr, Expr))| {
                    let expr = Expr::new(Node::Product(vec![momentum.clone(), rate_of(*q, 1)]), Span::default());
                    Term { sign: Sign::Plus, sign_span: None, expr }
                };
                let mut terms: Vec<Term> = coordinates.iter().zip(&partials).map(term).collect();
                terms.push(Term { sign: Sign::Minus, sign_span: None, expr: itself(symbol) });
                Expr::new(Node::Sum(terms), Span::default())
            }
            _ => continue,
        };
        let before = model.symbols.entry(id).definition.clone();
        // As a sum of one term it differs from a formula that a display prints, which is then checked.
        let term = Term { sign: Sign::Plus, sign_span: None, expr: formula };
        model.define(id, Expr::new(Node::Sum(vec![term]), Span::default()));
        // A printed H keeps the formula in momenta by which it is differentiated.
        model.symbols.entry_mut(id).definition = before;
    }
    true
}

fn partial(model: &Model, symbol: SymbolId, q: SymbolId, dots: u8) -> Option<Expr> {
    let by = Variable { id: q, indices: Vec::new(), dots };
    let scope = Scope { symbols: &model.symbols, fixed: &[] };
    derivative::partial(&itself(symbol), &by, scope, Span::default()).ok()
}

fn equation(lhs: Expr, rhs: Expr) -> Hypothesis {
    Hypothesis::of(Link { lhs, relation: Relation::Equal, rhs, free: Vec::new() }, true)
}
