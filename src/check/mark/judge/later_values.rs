//! Names to which a later line gives a false value: constants of integration, and quantities of the student's own.
//!
//! The model has the value of such a name before the line with it is reached. So where a line that solves the laws is false with that value,
//! and true of another one, it is right, and the value is wrong. Two lines that agree on a quantity of the student's own count for more
//! than a later value of it: `m_1 a = m_1 g - S` and `m_2 a = S - m_2 g` for more than `S = m_1 (g + a)`.

use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::Claim;
use crate::source::Span;

use crate::check::mark::given::{self, Implied};
use crate::check::mark::marked::{Line, Mark};
use crate::check::mark::names::moving;
use crate::check::mark::status::{Status, status};
use crate::check::model::claim::is_equality;
use crate::check::verdict::Verdict;

use super::Judge;

/// The most names of a line that are tried as constants of integration.
const MOST: usize = 4;

impl Judge<'_, '_> {
    /// Whether a line solves the laws, or is true but for a constant, whatever the names are to which later lines give values. These names are
    /// kept.
    pub(super) fn has_constants_of_integration(&mut self, display: usize, reading: &Reading) -> bool {
        let later: Vec<SymbolId> = self.quiet.readings[display + 1..]
            .iter()
            .flat_map(|reading| reading.introduced.iter().map(|new| new.symbol))
            .collect();
        let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        // A quantity that changes, as S in `S = m_1 (g - \ddot x)`, is no constant.
        let moving = moving(self.quiet.model);
        let is_constant = |id: &SymbolId| {
            let name = Expr::new(Node::Symbol { id: *id, indices: Vec::new(), dots: 0 }, Span::default());
            later.contains(id) && !self.quiet.model.depends_on(&name, &moving)
        };
        let mut names: Vec<SymbolId> = members.flat_map(Expr::symbols).map(|(id, _)| id).filter(is_constant).collect();
        names.sort_unstable();
        names.dedup();
        names.truncate(MOST);
        // The fewest names first: another one may only be an abbreviation, as \tau in `e^{-t/\tau}`.
        let mut sets: Vec<Vec<SymbolId>> = (1..1usize << names.len())
            .map(|set| (0..names.len()).filter(|at| set & 1 << at != 0).map(|at| names[at]).collect())
            .collect();
        sets.sort_by_key(Vec::len);
        let found = sets.into_iter().find(|set| {
            self.motion.is_general(self.quiet, (display, reading), set)
                || matches!(set.as_slice(), [one] if self.is_true_but_for(display, reading, *one))
        });
        let is_found = found.is_some();
        self.constants.extend(found.map(|set| (display - self.world.first, set)));
        is_found
    }

    /// Whether a line is an equality of which a constant is a term, and the laws keep the difference of its sides as it is.
    fn is_true_but_for(&self, display: usize, reading: &Reading, constant: SymbolId) -> bool {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let ([left, right], [(relation, place)]) = (statement.members.as_slice(), statement.relations.as_slice())
        else {
            return false;
        };
        let is_it = |term: &Expr| term.as_plain_symbol() == Some(constant);
        let has_it = |side: &Expr| match &side.node {
            Node::Sum(terms) => terms.iter().any(|term| is_it(&term.expr)),
            _ => is_it(side),
        };
        if !is_equality(*relation) || !(has_it(left) || has_it(right)) || is_it(left) || is_it(right) {
            return false;
        }
        let of_problem = self.world.problem.notes.equations.len();
        let off = given::expanded(self.quiet, of_problem, left.clone().minus(right.clone()));
        let rate = Expr::new(Node::TimeDerivative(1, Box::new(off)), left.span);
        let members = vec![rate, Expr::integer(0, left.span)];
        let stays = Statement { members, relations: vec![(Relation::Equal, *place)], ..statement.clone() };
        let stays = Reading { statements: vec![Ok(stays)], introduced: Vec::new() };
        matches!(status(self.quiet, display, &stays, &Claim::default()), Status::Holds(_))
    }

    /// What a line says of a quantity of the student's own to which a later line gives a value, where another line agrees with the line, and
    /// not with that value.
    pub(super) fn said_before_its_value(&self, at: usize, reading: &Reading) -> Option<Implied> {
        let first = self.world.first;
        let lines = 0..self.world.written.len();
        let own = |line: usize| &self.quiet.readings[first + line];
        let gives = |line: usize, id: SymbolId| own(line).introduced.iter().any(|new| new.symbol == id);
        let members = |reading: &Reading| -> Vec<(SymbolId, u8)> {
            let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
            members.flat_map(Expr::symbols).collect()
        };
        let holds =
            |line: usize, reading: &Reading| matches!(self.status_with(first + line, reading, &[]).0, Status::Holds(_));
        let is_later = |id: &SymbolId| self.details && lines.clone().any(|line| line > at && gives(line, *id));
        let names = members(reading).into_iter().map(|(id, _)| id).filter(is_later);
        names.into_iter().find_map(|id| {
            let said = Implied::of(self.quiet, id, reading)?;
            let agrees = |line: usize| {
                line != at
                    && !gives(line, id)
                    && members(own(line)).contains(&(id, 0))
                    && holds(line, &said.applied(own(line).clone()))
                    && !holds(line, own(line))
            };
            lines.clone().any(agrees).then_some(said)
        })
    }

    /// Whether a line gives a name a value with which an earlier line fails that holds for another value; the name is its only constant.
    /// The line is then wrong.
    pub(super) fn is_false_constant(&mut self, at: usize, reading: &Reading, line: &mut Line) -> bool {
        let gives = |id: SymbolId| reading.introduced.iter().any(|new| new.symbol == id);
        let found = self.constants.iter().find_map(|(before, set)| match set.as_slice() {
            [one] if gives(*one) => Some((*before, *one)),
            _ => None,
        });
        let Some((before, id)) = found else { return false };
        let name = self.world.in_own_letters(&self.quiet.model.name(id));
        (line.mark, line.verdict) = (Mark::Wrong, Some(Verdict::Refuted));
        line.because = format!("gives {name} a value with which {} is false", self.world.written[before].name).into();
        self.false_constants.push((before, at));
        true
    }
}
