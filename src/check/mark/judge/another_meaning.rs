//! Lines that fail only since a letter has another meaning in the problem, or none that decides: they are left open. What they
//! say of other things is judged all the same.

use crate::formula::{Expr, Node, Statement, SymbolId};
use crate::latex::Reading;

use crate::check::document::checker::Checker;
use crate::check::mark::motion::Motion;
use crate::check::mark::status::Status;
use crate::check::model::meaning::Meaning;

use super::Judge;

/// A reading in which each rate of a name has dots: `\frac{dQ}{dt}` is `\dot Q`.
pub(super) fn with_dots(mut reading: Reading) -> Reading {
    fn dotted(formula: &mut Expr) {
        formula.children_mut().into_iter().for_each(dotted);
        if let Node::TimeDerivative(order, inner) = &formula.node
            && let Node::Symbol { id, indices, dots } = &inner.node
        {
            formula.node = Node::Symbol { id: *id, indices: indices.clone(), dots: dots.saturating_add(*order) };
        }
    }
    reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members).for_each(dotted);
    reading
}

/// What moves in the problem, and neither a system nor a law nor the printed motion determines.
pub(super) fn free_of(checker: &Checker<'_>, motion: &Motion) -> Vec<SymbolId> {
    let model = checker.model;
    let laws = || model.laws.iter().flat_map(|law| &law.hypotheses).flat_map(|law| [&law.lhs, &law.rhs]);
    let is_free = |id: &SymbolId| {
        matches!(model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)))
            && model.system.is_none()
            && !motion.prints(*id)
            && !laws().any(|side| model.depends_on(side, &[*id]))
    };
    model.symbols.iter().map(|(id, _)| id).filter(is_free).collect()
}

impl Judge<'_, '_> {
    /// Why a false line may be true with another meaning of its letters; `None`, if it says something false beside that.
    pub(super) fn another_meaning(&self, display: usize, reading: &Reading) -> Option<String> {
        let model = self.quiet.model;
        let own = |id: SymbolId| {
            self.world.declared.iter().any(|name| model.symbols.find(name).is_some_and(|(found, _)| found == id))
        };
        let moving: Vec<SymbolId> = model
            .symbols
            .iter()
            .map(|(id, _)| id)
            .filter(|id| {
                matches!(
                    model.meaning(*id),
                    Some(Meaning::Coordinate(_) | Meaning::Varying(_) | Meaning::Time | Meaning::System(_))
                )
            })
            .collect();
        let is_fixed = |id: SymbolId| {
            matches!(model.meaning(id), Some(Meaning::Constant(_) | Meaning::Defined(_)))
                && !model.depends_on(&symbol(id), &moving)
                && !own(id)
        };
        // Each link alone: what it says of quantities that are known must hold.
        let mut why = None;
        for statement in reading.statements.iter().flatten() {
            for (pair, relation) in statement.members.windows(2).zip(&statement.relations) {
                let symbols = || pair.iter().flat_map(Expr::symbols);
                let is_open = pair.iter().any(|side| model.depends_on(side, &self.open));
                let changing = symbols().find(|(id, dots)| *dots > 0 && is_fixed(*id));
                if let Some((id, _)) = changing {
                    why = Some(format!("{} is constant in the problem, and changes here", self.shown(id)));
                    continue;
                }
                if is_open {
                    let names = self.open.iter().filter(|id| pair.iter().any(|side| model.depends_on(side, &[**id])));
                    let names: Vec<String> = names.map(|id| self.shown(*id)).collect();
                    why = Some(format!("nothing in the problem says how {} moves", names.join(", ")));
                    continue;
                }
                let alone =
                    Statement { members: pair.to_vec(), relations: vec![*relation], ..statement.clone() };
                let alone = Reading { statements: vec![Ok(alone)], introduced: Vec::new() };
                if let Status::False(_) = self.status(display, &alone).0 {
                    return None;
                }
            }
        }
        why
    }

    fn shown(&self, id: SymbolId) -> String {
        self.world.in_own_letters(&self.quiet.model.name(id))
    }
}

fn symbol(id: SymbolId) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, crate::source::Span::default())
}
