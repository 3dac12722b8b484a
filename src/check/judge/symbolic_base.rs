//! The numbers of a state as symbols with names, so that a formula can be recorded from its evaluation.

use nalgebra::DMatrix;

use crate::derive::{Class, Letter};
use crate::formula::{Expr, Index, Kind, Node, SymbolId};
use crate::mechanics::{LinearSolver, solve_with};
use crate::notes::claims::Range;
use crate::scalar::Symbol;

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Mode;
use crate::check::state::numbers::{Base, Layout, Slot, slots};

/// A symbol with indices and dots, as a formula.
pub(crate) fn symbol(id: SymbolId, indices: Vec<Index>, dots: u8) -> Expr {
    Expr::new(Node::Symbol { id, indices, dots }, crate::source::Span::default())
}

/// The numbers of a base as symbolic inputs, with their names.
pub(crate) struct SymbolicBase {
    /// The names of the inputs.
    pub(crate) letters: Vec<Letter>,
    /// The value at each place of the base.
    places: Vec<Place>,
}

/// The value at a place of a base.
enum Place {
    /// An input. Inputs without a name come after all that have one, and a formula that depends on them is not shown.
    Input(usize),
    /// A fixed number: the number of members of a family.
    Fixed(f64),
}

/// The number of the first input without a name.
const NAMELESS: usize = 1 << 20;

impl SymbolicBase {
    /// The inputs of a base of this mode; integers have their values in `base`.
    pub(crate) fn new(model: &Model, mode: Mode, base: &[f64]) -> Self {
        let (mut letters, mut places) = (Vec::new(), Vec::new());
        let (mut last, mut number) = (None, 0);
        for (at, slot) in slots(model, mode).iter().enumerate() {
            // The numbers of one symbol follow one another, each with its derivatives.
            number = if slot.symbol == last { number + usize::from(slot.order == 0) } else { 0 };
            last = slot.symbol;
            places.push(match (&slot.range, letter(model, at, slot, number)) {
                (Range::Integer { .. }, _) => Place::Fixed(base.get(at).copied().unwrap_or(f64::NAN)),
                (_, Some(letter)) => {
                    letters.push(letter);
                    Place::Input(letters.len() - 1)
                }
                (_, None) => Place::Input(NAMELESS + at),
            });
        }
        SymbolicBase { letters, places }
    }

    /// The base, made of inputs.
    pub(crate) fn base(&self) -> Vec<Symbol> {
        let number = |place: &Place| match place {
            Place::Input(n) => Symbol::input(*n),
            Place::Fixed(value) => Symbol::from(*value),
        };
        self.places.iter().map(number).collect()
    }
}

/// The name of a number of a base: the n-th of its symbol.
fn letter(model: &Model, at: usize, slot: &Slot, n: usize) -> Option<Letter> {
    let Some(id) = slot.symbol else {
        let is_time = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Time));
        let time = model.symbols.iter().map(|(id, _)| id).find(|id| at == 0 && is_time(id))?;
        return Some(Letter { expr: symbol(time, Vec::new(), 0), class: Class::Time });
    };
    let class = match (model.meaning(id)?, slot.order) {
        (Meaning::Constant(_), _) => Class::Parameter,
        (Meaning::Coordinate(_) | Meaning::Varying(_), 0) => Class::Coordinate,
        (Meaning::Coordinate(_) | Meaning::Varying(_), 1) => Class::Velocity,
        (Meaning::Coordinate(_) | Meaning::Varying(_), _) => Class::Acceleration,
        _ => return None,
    };
    let is_vector = model.symbols.entry(id).kind == Kind::Vector;
    let (mut member, axis) = if is_vector { (n / 3, n % 3) } else { (n, 0) };
    let mut indices = Vec::new();
    for extent in model.symbols.extents(id).iter().rev() {
        indices.insert(0, Index::Fixed((member % usize::from(*extent)) as u8 + 1));
        member /= usize::from(*extent);
    }
    let mut expr = symbol(id, indices, slot.order as u8);
    if is_vector {
        let span = expr.span;
        expr = Expr::new(Node::Component(Box::new(expr), Index::Fixed(axis as u8 + 1)), span);
    }
    Some(Letter { expr, class })
}

/// Replaces the velocities of some coordinates in a base by those that belong to these momenta: p = M q̇ + b. This is
/// wrong where L is not quadratic in the velocities; the result is then not shown, since its value is compared before.
pub(crate) fn velocities_from_momenta(
    model: &Model,
    mode: Mode,
    base: &mut [Symbol],
    coordinates: &[usize],
    momenta: &[Symbol],
) -> Option<()> {
    let (Some(system), false) = (&model.system, coordinates.is_empty()) else { return Some(()) };
    let sorted = Base::of(&Layout::of(model, mode), base);
    let part = |order: usize| sorted.coordinates().map(|jet| jet.get(order).copied()).collect::<Option<Vec<_>>>();
    let (q, mut v) = (part(0)?, part(1)?);
    let parameters: Vec<Symbol> = model.parameters.iter().map(|place| sorted.constant(*place)[0]).collect();
    coordinates.iter().for_each(|i| v[*i] = Symbol::from(0.0));
    let at_rest = system.quantities(sorted.time, &q, &v, &parameters).momenta;
    let mass = system.mass_matrix(sorted.time, &q, &v, &parameters);
    let block = DMatrix::from_fn(coordinates.len(), coordinates.len(), |i, j| mass[(coordinates[i], coordinates[j])]);
    let right = coordinates.iter().zip(momenta).map(|(i, p)| *p - at_rest[*i]).collect();
    let velocities = solve_with(LinearSolver::CramersRule, "mass matrix", block, right).ok()?;
    let slots = slots(model, mode);
    for (i, velocity) in coordinates.iter().zip(velocities) {
        let of = Some(model.coordinates[*i].symbol);
        let place = slots.iter().position(|slot| slot.symbol == of && slot.order == 1)?;
        base[place] = velocity;
    }
    Some(())
}
