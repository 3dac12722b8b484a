//! Lines that fail only since a letter has another meaning in the problem, or none that decides: they are left open. What they
//! say of other things is judged all the same.

use crate::Result;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::Lost;
use crate::source::Span;

use crate::check::mark::given::Implied;
use crate::check::mark::marked::Mark;
use crate::check::mark::names::moving;
use crate::check::mark::slip;
use crate::check::mark::status::{Status, composed};
use crate::check::mark::written::single_letters;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::verdict::Verdict;

use super::Judge;

impl Judge<'_, '_> {
    /// Whether a name is one that only the hand-in has.
    pub(super) fn is_own(&self, id: SymbolId) -> bool {
        let symbols = &self.quiet.model.symbols;
        self.world.declared.contains(&symbols.entry(id).name)
    }

    /// Whether a line says of a letter only that it is the rate for which it was taken, `v = \dot x`, and no line before it uses the
    /// letter.
    pub(super) fn names_a_rate(&self, reading: &Reading) -> bool {
        let model = self.quiet.model;
        let is_it = |name: &Expr, value: &Expr| {
            let Some(id) = name.as_plain_symbol() else { return false };
            let is_definition = matches!(model.meaning(id), Some(Meaning::Defined(formula)) if **formula == *value);
            let first = self.world.first;
            let mut before = self.quiet.readings[first..first + self.lines.len()].iter();
            let is_first = !before.any(|reading| {
                let mut members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
                members.any(|member| member.symbols().iter().any(|(used, _)| *used == id))
            });
            is_definition && is_first && self.world.stands_for_a_rate(&model.symbols.entry(id).name)
        };
        let is_no_more = |statement: &Statement| match statement.members.as_slice() {
            [first, second] => is_it(first, second) || is_it(second, first),
            _ => false,
        };
        !reading.statements.is_empty() && reading.statements.iter().flatten().all(is_no_more)
    }

    /// What a line says that quantities of the student's own are, with the first of them, if it says no more; `None`, if it does.
    pub(super) fn given_by(&self, display: usize, reading: &Reading, implied: Implied) -> Option<Vec<Implied>> {
        let is_short = reading.statements.iter().flatten().all(|statement| statement.members.len() == 2);
        let rest = implied.applied(reading.clone());
        if is_short || matches!(self.status(display, &rest).0, Status::Holds(_)) {
            return Some(vec![implied]);
        }
        // In a chain each link may say what another quantity is: `n C_V \dot T = -p \dot V = -\frac{n R T}{V} \dot V`.
        let mut all = vec![implied];
        for statement in reading.statements.iter().flatten() {
            for (pair, relation) in statement.members.windows(2).zip(&statement.relations) {
                let link = Statement { members: pair.to_vec(), relations: vec![*relation], ..statement.clone() };
                let link = all.iter().fold(alone_of(link), |link, known| known.applied(link));
                let is_trivial = link.statements.iter().flatten().any(|link| link.members[0] == link.members[1]);
                if is_trivial || matches!(self.status(display, &link).0, Status::Holds(_)) {
                    continue;
                }
                let next = Implied::by(self.quiet, (&self.world.declared, &self.open), &link)?;
                if all.iter().any(|known| known.symbol() == next.symbol()) {
                    return None;
                }
                all.push(next);
            }
        }
        Some(all)
    }

    /// Whether a line that does not hold may be true, since it has quantities of the student's own of which no line says what
    /// they are: then only a symbol in the place of another one shows that it is false.
    pub(super) fn leaves_open(&self, at: usize, reading: &Reading) -> Result<bool> {
        let is_mistyped = |edit: &slip::Corrected| edit.slip.lost == Lost::Symbol;
        let is_open = !self.unknown(reading).is_empty() && !self.has_a_numbered_value(reading);
        Ok(is_open && !self.slips.found(self.run, self.checker, self.world, at)?.0.as_ref().is_some_and(is_mistyped))
    }

    /// Whether the first member of a chain is not the last one, whatever stands between them.
    pub(super) fn ends_are_false(&self, display: usize, reading: &Reading) -> bool {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        if statement.members.len() < 3 {
            return false;
        }
        let Some(ends) = composed(reading, reading) else { return false };
        self.unknown(&ends).is_empty() && matches!(self.status(display, &ends).0, Status::False(_))
    }

    /// The quantities of the student's own in a line of which no line says what they are.
    pub(super) fn unknown(&self, reading: &Reading) -> Vec<String> {
        let name = |id: &SymbolId| self.world.in_own_letters(&self.quiet.model.name(*id));
        self.unknown_symbols(reading).iter().map(name).collect()
    }

    /// The same as symbols.
    pub(super) fn unknown_symbols(&self, reading: &Reading) -> Vec<SymbolId> {
        let model = self.quiet.model;
        let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let is_used = |id: SymbolId| members().any(|member| member.symbols().iter().any(|(used, _)| *used == id));
        let own = self.world.declared.iter().filter_map(|name| Some(model.symbols.find(name)?.0));
        let free = own.filter(|id| {
            matches!(model.meaning(*id), Some(Meaning::Constant(_) | Meaning::Varying(_))) && is_used(*id)
        });
        free.collect()
    }

    /// Whether one likely edit makes a line true.
    pub(super) fn is_slip(&self, at: usize) -> Result<bool> {
        Ok(self.slips.found(self.run, self.checker, self.world, at)?.0.is_some())
    }

    /// Whether a statement is an equality between constants of the problem, as a special case is.
    pub(super) fn relates_constants(&self, statement: &Statement) -> bool {
        let is_constant = |(id, dots): &(SymbolId, u8)| {
            *dots == 0 && matches!(self.quiet.model.meaning(*id), Some(Meaning::Constant(_))) && !self.is_own(*id)
        };
        let symbols: Vec<(SymbolId, u8)> = statement.members.iter().flat_map(Expr::symbols).collect();
        let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        is_equal && statement.members.len() == 2 && !symbols.is_empty() && symbols.iter().all(is_constant)
    }

    /// Whether a statement gives a product or a quotient of constants a number, `\frac{V_1}{V_2} = 10`, which neither the problem
    /// nor the numbers of the student decide.
    pub(super) fn is_ratio_of_data(&self, statement: &Statement) -> bool {
        let [first, second] = statement.members.as_slice() else { return false };
        let of_problem = &self.quiet.readings[..self.world.problem.notes.equations.len()];
        let printed = of_problem.iter().flat_map(|reading| reading.statements.iter().flatten());
        let model = self.quiet.model;
        let is_place = |id: SymbolId| {
            let name = &model.symbols.entry(id).name;
            self.world.problem.special.places().iter().any(|(_, place)| place == name)
        };
        let is_number = second.symbols().is_empty() && first.symbols().len() > 1;
        is_number
            && self.relates_constants(statement)
            && is_monomial(first)
            && !self.known.determines(self.quiet, first)
            && !self.world.problem.contexts.iter().any(|claim| !claim.assume.is_empty())
            && !first.symbols().iter().any(|(id, _)| is_place(*id))
            && !printed.flat_map(|known| &known.members).any(|known| known == first)
    }

    /// Whether the line before a line stands in the same row, and gives a quantity a number.
    pub(super) fn stands_beside_a_value(&self, at: usize) -> bool {
        let (Some(before), Some(written)) = (at.checked_sub(1), self.world.written.get(at)) else { return false };
        let is_value = |statement: &Statement| {
            statement.members.len() == 2 && statement.members.iter().any(|member| member.symbols().is_empty())
        };
        let own = &self.quiet.readings[self.world.first + before];
        self.world.written[before].line == written.line
            && self.world.written[before].inline == written.inline
            && self.lines[before].mark == Mark::Given
            && self.lines[before].verdict == Some(Verdict::Assumed)
            && own.statements.iter().flatten().all(is_value)
    }

    /// Why a false line may be true with another meaning of its letters; `None`, if it says something false beside that.
    pub(super) fn another_meaning(&self, display: usize, reading: &Reading) -> Option<String> {
        let mut why = None;
        // Each link alone: what it says of quantities that are known must hold.
        for statement in reading.statements.iter().flatten() {
            for (pair, relation) in statement.members.windows(2).zip(&statement.relations) {
                let found = self.open_link(pair).or_else(|| self.after_a_break(pair));
                if found.is_some() {
                    why = found;
                    continue;
                }
                let alone = Statement { members: pair.to_vec(), relations: vec![*relation], ..statement.clone() };
                if let Status::False(_) = self.status(display, &alone_of(alone.clone())).0 {
                    why = Some(self.holds_somewhere(display, alone)?);
                }
            }
        }
        why
    }

    /// Why a line may be about an energy whose letter is a constant of the problem, as T for a period: it says what moves for it.
    pub(super) fn energy_for_a_constant(&self, reading: &Reading) -> Option<String> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let id = statement.members.first()?.as_plain_symbol()?;
        let name = &self.quiet.model.symbols.entry(id).name;
        let is_energy = ["T", "U", "V", "W", "E", "K"].contains(&name.base.as_str());
        let is_rate = |(id, dots): &(SymbolId, u8)| *dots > 0 || self.quiet.model.is_coordinate(*id);
        let is_fixed = match self.quiet.model.meaning(id) {
            Some(Meaning::Defined(formula)) => !self.is_own(id) && !formula.symbols().iter().any(is_rate),
            Some(Meaning::Constant(_)) => !self.is_own(id),
            _ => false,
        };
        let mut squares = false;
        for member in &statement.members[1..] {
            member.walk(&mut |part| {
                let Node::Power(base, power) = &part.node else { return };
                let is_rate = |(id, dots): &(SymbolId, u8)| *dots == 1 && self.quiet.model.is_coordinate(*id);
                squares |= power.as_digits() == Some("2") && base.symbols().iter().any(is_rate);
            });
        }
        (is_energy && is_fixed && squares).then(|| {
            format!("seems to use {} for an energy, but this letter is something else in the problem", self.shown(id))
        })
    }

    /// A reading in which t is the time that runs, also where it was taken for an instant.
    pub(super) fn with_running_time(&self, reading: &Reading) -> Reading {
        let symbols = &self.quiet.model.symbols;
        let time =
            symbols.iter().map(|(id, _)| id).find(|id| matches!(self.quiet.model.meaning(*id), Some(Meaning::Time)));
        let mut reading = reading.clone();
        let Some(time) = time else { return reading };
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            member.rename(&|id| if single_letters::is_instant(&symbols.entry(id).name) { time } else { id });
        }
        reading
    }

    /// Why a link says nothing of what the problem determines.
    fn open_link(&self, pair: &[Expr]) -> Option<String> {
        let model = self.quiet.model;
        let moving = moving(model);
        let is_fixed = |id: SymbolId| {
            matches!(model.meaning(id), Some(Meaning::Constant(_) | Meaning::Defined(_)))
                && !model.depends_on(&symbol(id), &moving)
                && !self.is_own(id)
        };
        let symbols = || pair.iter().flat_map(Expr::symbols);
        let is_instant = |id: SymbolId| single_letters::is_instant(&model.symbols.entry(id).name);
        if symbols().any(|(id, _)| is_instant(id)) {
            return Some("may be about another instant t than the problem".to_owned());
        }
        if let Some((id, _)) = symbols().find(|(id, dots)| *dots > 0 && is_fixed(*id)) {
            return Some(format!("needs {} to vary with time, and it is constant in the problem", self.shown(id)));
        }
        let open = self.open.iter().filter(|id| pair.iter().any(|side| model.depends_on(side, &[**id])));
        let names: Vec<String> = open.map(|id| self.shown(*id)).collect();
        (!names.is_empty())
            .then(|| format!("needs to know how {} moves, and the problem does not say it", names.join(", ")))
    }

    /// Why a link is not judged after a condition that the problem does not meet: what moves may then move in another way.
    fn after_a_break(&self, pair: &[Expr]) -> Option<String> {
        let (_, name) = self.breaks.last()?;
        let names =
            moving(self.quiet.model).into_iter().chain(self.breaks.iter().map(|(id, _)| *id)).collect::<Vec<_>>();
        let is_about = pair.iter().any(|side| self.quiet.model.depends_on(side, &names));
        is_about.then(|| format!("may follow from {name}, a condition that the problem does not have"))
    }

    /// Why an inequality between quantities of the problem is not false: it holds for some values of them.
    fn holds_somewhere(&self, display: usize, statement: Statement) -> Option<String> {
        let [(relation, place)] = statement.relations.as_slice() else { return None };
        let opposite = match relation {
            Relation::Less | Relation::LessEqual => Relation::Greater,
            Relation::Greater | Relation::GreaterEqual => Relation::Less,
            _ => return None,
        };
        let relations = vec![(opposite, *place)];
        let other = alone_of(Statement { relations, ..statement });
        let fails = matches!(self.status(display, &other).0, Status::False(_));
        fails.then(|| {
            "holds for some values of the quantities, and the problem does not say which values they have".to_owned()
        })
    }

    fn shown(&self, id: SymbolId) -> String {
        self.world.in_own_letters(&self.quiet.model.name(id))
    }
}

/// Whether a formula is made of symbols and numbers by products, quotients and powers.
fn is_monomial(formula: &Expr) -> bool {
    match &formula.node {
        Node::Symbol { .. } | Node::Number(_) => true,
        Node::Product(_) | Node::Quotient(..) => formula.children().into_iter().all(is_monomial),
        Node::Power(base, power) => is_monomial(base) && matches!(power.node, Node::Number(_)),
        _ => false,
    }
}

fn alone_of(statement: Statement) -> Reading {
    Reading { statements: vec![Ok(statement)], introduced: Vec::new() }
}

fn symbol(id: SymbolId) -> Expr {
    Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default())
}
