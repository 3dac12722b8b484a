//! Lines about the coordinate at a place of rest that has a name, chains that end with a condition, and conditions for an extremum.

use crate::formula::{Expr, Statement, SymbolId};
use crate::latex::{Reading, names};

use crate::check::mark::given;
use crate::check::mark::marked::{Because, Line, Mark};
use crate::check::mark::status::Status;
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::verdict::Verdict;

use super::Judge;
use super::extrema::with_value;

impl Judge<'_, '_> {
    /// Whether a line after words of rest says of the coordinate what holds at the place of rest, `\cos\theta = g/(R\omega^2)` for
    /// θ_0; it is then about that place.
    pub(super) fn is_at_rest(&mut self, at: usize, reading: &Reading, line: &mut Line) -> bool {
        let Some((there, because)) = self.at_rest(at, reading) else { return false };
        (line.mark, line.verdict, line.because) = (Mark::Right, Some(Verdict::Verified), because);
        self.premises[self.world.first + at] = there;
        true
    }

    fn at_rest(&self, at: usize, reading: &Reading) -> Option<(Reading, Because)> {
        let model = self.quiet.model;
        let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let used: Vec<(SymbolId, u8)> = members().flat_map(Expr::symbols).collect();
        let moves = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
        if !self.details || !self.world.written[at].is_at_rest {
            return None;
        }
        self.world.problem.special.places().iter().find_map(|(of, place)| {
            let (id, there) = (model.symbols.find(of)?.0, model.symbols.find(place)?.0);
            let is_about_it = used.contains(&(id, 0))
                && used.iter().all(|(other, dots)| *dots == 0 && (*other == id || !moves(*other) && *other != there));
            if !is_about_it {
                return None;
            }
            let new = with_value(reading, id, there);
            let holds = matches!(self.status(self.world.first + at, &new).0, Status::Holds(_));
            holds.then(|| (new, Because::AtValue(of.clone(), place.clone())))
        })
    }

    /// Whether a chain is true up to its last member, a 0 that says at which instant: `y = h - \frac12 g t^2 = 0`.
    pub(super) fn ends_in_a_condition(&self, at: usize, reading: &Reading) -> bool {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let [first, .., last] = statement.members.as_slice() else { return false };
        let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        let length = statement.members.len();
        if length < 3 || !is_equal || !last.is_null() || self.world.written[at].continues.is_some() {
            return false;
        }
        let part = |members: Vec<Expr>| {
            let relations = statement.relations[..members.len() - 1].to_vec();
            Statement { members, relations, ..statement.clone() }
        };
        let condition = part(vec![first.clone(), last.clone()]);
        let rest = part(statement.members[..length - 1].to_vec());
        let rest = Reading { statements: vec![Ok(rest)], introduced: Vec::new() };
        let is_open = given::is_special_state(self.quiet, &condition, &self.wanted) || self.is_slope_by_a_constant(at);
        is_open && matches!(self.status(self.world.first + at, &rest).0, Status::Holds(_))
    }

    /// Whether a line says that a slope by a constant vanishes, `\frac{dR}{d\alpha} = 0`: the condition for an extremum.
    pub(super) fn is_condition_of_an_extremum(&self, at: usize, reading: &Reading) -> bool {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let vanishes = matches!(statement.members.as_slice(), [_, last] if last.is_null());
        vanishes
            && statement.relations.iter().all(|(relation, _)| is_equality(*relation))
            && self.is_slope_by_a_constant(at)
    }

    /// Whether a line begins with a slope by a constant.
    fn is_slope_by_a_constant(&self, at: usize) -> bool {
        let text = &self.world.display(at).text;
        let by = text.trim_start().split_once("frac{\\partial").filter(|(before, _)| ["\\", "\\d"].contains(before));
        let by = by.and_then(|(_, rest)| rest.split_once("}{\\partial")?.1.split('}').next());
        let name = by.and_then(|by| names::parse(by.trim()));
        let id = name.and_then(|(name, _)| self.quiet.model.symbols.find(&name));
        id.is_some_and(|(id, _)| matches!(self.quiet.model.meaning(id), Some(Meaning::Constant(_))))
    }
}
