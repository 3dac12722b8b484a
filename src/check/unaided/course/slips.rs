//! The slip that separates a display from what follows.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::model::meaning::Meaning;
use crate::check::repair::suggest::Search;
use crate::check::unaided::contradictions;
use crate::check::unaided::course::{Course, FEWEST_RESTATED};
use crate::check::unaided::dimensions;
use crate::check::unaided::gate::{self, Basis};
use crate::check::unaided::premises::{Premise, Said, named};
use crate::check::unaided::prose::{self, Announced, Words};
use crate::check::unaided::solutions;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Node, SymbolId};
use crate::latex::DefinedSymbol;
use crate::latex::layout::prints_derivative;
use crate::latex::slips::{Edit, Slip};
use crate::notes::claims::Claim;
use crate::source::Span;

/// The relative difference of two numbers that are equal.
const EQUAL: f64 = 1e-9;

/// The inequalities in print.
const INEQUALITIES: [&str; 12] =
    ["<", ">", "≤", "≥", "\\lt", "\\gt", "\\le", "\\ge", "\\leq", "\\geq", "\\leqslant", "\\geqslant"];

impl Course<'_, '_> {
    /// Whether both sides of a display, or of an equality of a chain, are made of the same names, and of so many that no condition
    /// in the words could make two different formulas of them equal by chance.
    fn relates_the_same(&self, at: usize) -> bool {
        let model = self.checker.model;
        let leaves = |member: &Expr| {
            let mut all = gate::leaves(member, model);
            all.sort_unstable_by_key(|id| id.0);
            all.dedup();
            all
        };
        let is_free = |id: &SymbolId| {
            matches!(
                model.meaning(*id),
                Some(Meaning::Constant(_) | Meaning::Varying(_) | Meaning::Coordinate(_) | Meaning::Time)
            )
        };
        let statements = &self.checker.readings[at].statements;
        let mut read = statements.iter().flatten();
        !statements.is_empty()
            && statements.iter().all(Result::is_ok)
            && read.all(|statement| {
                let skipped =
                    usize::from(statement.members.len() > 2 && statement.members[0].as_plain_symbol().is_some());
                let all: Vec<_> = statement.members[skipped..].iter().map(leaves).collect();
                all.len() > 1
                    && all.windows(2).all(|pair| pair[0] == pair[1])
                    && all.iter().all(|leaves| leaves.len() >= FEWEST_RESTATED && leaves.iter().all(is_free))
            })
    }

    /// Whether a display equates a name with a formula to a derivative, which has a value: `E = -dV/dr` after formulas for E and V.
    fn equates_a_derivative(&self, at: usize) -> bool {
        let (model, display, reading) =
            (self.checker.model, &self.checker.notes.equations[at], &self.checker.readings[at]);
        reading.statements.iter().flatten().any(|statement| {
            let [name, value] = statement.members.as_slice() else { return false };
            let Some(id) = name.as_plain_symbol() else { return false };
            let is_known = matches!(model.meaning(id), Some(Meaning::Defined(_)))
                && !reading.introduced.iter().any(|new| new.symbol == id);
            is_known && display.text.get(value.span.range()).is_some_and(|text| prints_derivative(text, &model.macros))
        })
    }

    /// The place of the name on the left side, if another display gives it a formula.
    fn name_given_again(&self, at: usize) -> Option<Span> {
        let reading = &self.checker.readings[at];
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let first = statement.members.first()?;
        let id = first.as_plain_symbol()?;
        let is_defined = matches!(self.checker.model.meaning(id), Some(Meaning::Defined(_)));
        let is_introduced_here = reading.introduced.iter().any(|new| new.symbol == id);
        (is_defined && !is_introduced_here).then(|| first.span.shifted(self.checker.notes.equations[at].body.start))
    }

    /// The finding that a display is wrong, if a likely slip separates it from what follows.
    pub(in crate::check::unaided) fn slip(
        &self,
        at: usize,
        claim: &Claim,
        set: &[&Premise],
        words: &Words,
    ) -> Result<Option<Equation>> {
        let (checker, display) = (self.checker, &self.checker.notes.equations[at]);
        let (basis, search) = match set {
            [] => (Basis::Definitions, Search::Thorough),
            _ if claim.solves.is_some() => (Basis::Solution, Search::Likely),
            [_] => (Basis::Premise, Search::Likely),
            _ => (Basis::Premises, Search::Likely),
        };
        // What the words claim of a name is no definition.
        let is_frequency = |new: &DefinedSymbol| gate::is_frequency(new.symbol, checker.model);
        let is_claimed = claim.conserved.is_some()
            || claim.equilibrium.is_some()
            || claim.secular_for.is_some()
            || checker.readings[at].introduced.iter().any(is_frequency);
        let is_evaluated = self.scope.evaluated.contains(&at) || self.equates_a_derivative(at);
        let solves = set.is_empty()
            && (is_claimed
                || is_evaluated
                || solutions::is_printed(checker, at, claim)
                || words.connected && self.restates(at));
        let is_identity = self.relates_the_same(at);
        let is_another_case = (words.other_case && !self.is_by_itself(at) || self.is_about_another(at)) && !is_identity;
        let says_enough = is_claimed || is_identity || words.only_nearness && self.approximates(at);
        let is_supposed = words.announced.is_supposed() && !says_enough;
        let is_tried = (solves || gate::may_be_a_slip(&checker.readings[at], checker.model, basis, words))
            && !is_another_case
            && !(is_supposed && (words.announced == Announced::Assumption || basis != Basis::Definitions));
        let is_general = !is_another_case && words.announced != Announced::Assumption;
        let may_be_a_factor = set.is_empty() && (is_general || !self.uses_definitions(at));
        if !is_tried && !may_be_a_factor || self.stands_beside_another_value(at) && !self.is_by_itself(at) {
            return Ok(None);
        }
        let quick = self.equation(&self.quick, at, claim)?;
        if quick.finding.verdict != Verdict::Refuted {
            return Ok(None);
        }
        if may_be_a_factor && let Some(wrong) = self.off_by_a_factor(at, claim, &quick)? {
            return Ok(Some(wrong));
        }
        if !is_tried {
            return Ok(None);
        }
        if !set.is_empty() && is_degenerate(&quick) {
            return Ok(None);
        }
        let open = if set.is_empty() { Vec::new() } else { self.left_open_by_a_case(at) };
        let printed = gate::symbols_of(&display.text, checker.model);
        let is_open = |id: &SymbolId| open.contains(id) && !printed.contains(id);
        if set.iter().flat_map(|premise| &premise.symbols).any(is_open)
            && !set.iter().any(|premise| self.sets_a_value(premise.at))
        {
            return Ok(None);
        }
        let mut repairs = checker.own_repairs(at, &quick, claim, search)?;
        let is_solution = solves || basis == Basis::Solution;
        let origin = self.scope.origin_of(at, checker.notes.equations.len());
        let (model, before) = (checker.model, &self.seen);
        let around = gate::Around { model, before, origin, basis, words, solves: is_solution };
        repairs.retain(|repair| gate::is_likely(repair, display, &around) && !self.brings_doubt(at, repair));
        // Of another thing a law holds with another number.
        if !set.is_empty() && prose::brings_another_thing(checker.notes, origin) {
            let is_of_a_number = |repair: &Repair| {
                matches!(repair.slip, Slip::Number | Slip::Fraction) || contradictions::is_number(checker, repair)
            };
            repairs.retain(|repair| !is_of_a_number(repair));
        }
        if is_supposed {
            repairs.retain(may_be_under_a_condition);
        }
        // The name of a quantity that has a formula already is no slip: `\lambda = 2a`, and later `\lambda = 2a\sin\theta`.
        if let Some(name) = self.name_given_again(at) {
            repairs.retain(|repair| !name.contains(repair.span));
        }
        // In a special case one name may stand for another one.
        if set.iter().any(|premise| self.sets_a_value(premise.at)) {
            repairs.retain(|repair| !matches!(repair.slip, Slip::Symbol | Slip::Index | Slip::Name));
        }
        if !open.is_empty() {
            let brings_one =
                |repair: &Repair| gate::symbols_of(&self.corrected(at, repair), checker.model).iter().any(is_open);
            repairs.retain(|repair| !brings_one(repair));
        }
        // An inequality holds in a range that the notes need not print; only its direction can be seen to be wrong.
        if quick.finding.code == Code::InequalityFails {
            let turned = |repair: &Repair| INEQUALITIES.contains(&checker.source.slice(repair.span).trim());
            repairs.retain(turned);
        }
        if set.iter().any(|premise| matches!(premise.said, Said::States(_))) {
            repairs.retain(|repair| !adds_a_state(repair, checker));
        }
        // A slip in the formula that the display gives a name comes before edits of where the name stands.
        if solves && (repairs.is_empty() || !checker.readings[at].introduced.is_empty()) {
            let mut own = checker.repairs_of_own_definition(self.run, at)?;
            own.retain(|repair| gate::is_likely(repair, display, &around));
            repairs.retain(|repair| !own.contains(repair));
            repairs.splice(0..0, own);
        }
        if checker.readings[at].introduced.iter().any(is_frequency) {
            repairs.retain(|repair| !only_negates(repair, checker));
        }
        // Relations that are taken for granted may have another solution, with which the display holds as it is printed.
        if self.leave_a_root_open(at, set) {
            repairs.retain(|repair| repair.verdict == Verdict::Certified);
        }
        // No author means an equation whose terms have different dimensions.
        repairs.retain(|repair| !dimensions::are_spoilt(checker, at, repair) && !self.spoils_its_chain(at, repair));
        let is_concluded = || open.is_empty() && is_general && self.is_concluded(at, set, words);
        let found = match repairs.is_empty() {
            false => Some(Equation { repairs, ..self.equation(checker, at, claim)? }),
            true if is_concluded() => self.concluded_off_by_a_factor(at, claim)?,
            true => None,
        };
        let Some(mut found) = found else { return Ok(None) };
        if !set.is_empty() {
            found.finding.message = match basis {
                Basis::Solution => format!("this does not solve {}", named(set)),
                _ => match found.finding.message.strip_prefix("this does not follow from ") {
                    Some(others) => format!("this does not follow from {}, together with {others}", named(set)),
                    None => format!("this does not follow from {}: {}", named(set), found.finding.message),
                },
            };
        }
        Ok(Some(found))
    }
}

impl Course<'_, '_> {
    /// Whether a premise has two powers of a name that the display does not contain: of the roots for this name one was tested.
    fn leave_a_root_open(&self, at: usize, set: &[&Premise]) -> bool {
        let members = |at: usize| {
            let statements = self.checker.readings[at].statements.iter().flatten();
            statements.flat_map(|statement| &statement.members)
        };
        let own: Vec<SymbolId> = members(at).flat_map(Expr::symbols).map(|(id, _)| id).collect();
        set.iter().any(|premise| {
            let mut powers: Vec<(SymbolId, String)> = Vec::new();
            let mut all: Vec<SymbolId> = Vec::new();
            for member in members(premise.at) {
                member.walk(&mut |part| match &part.node {
                    Node::Power(base, exponent) => {
                        powers.extend(base.as_plain_symbol().map(|id| (id, format!("{:?}", exponent.node))));
                    }
                    Node::Symbol { id, .. } => all.push(*id),
                    _ => {}
                });
            }
            all.iter().filter(|id| !own.contains(id)).any(|id| {
                let mut found: Vec<&String> =
                    powers.iter().filter(|(of, _)| of == id).map(|(_, power)| power).collect();
                let is_plain = all.iter().filter(|other| *other == id).count() > found.len();
                found.sort_unstable();
                found.dedup();
                found.len() + usize::from(is_plain) > 1
            })
        })
    }

    /// The text of a display with a correction.
    pub(super) fn corrected(&self, at: usize, repair: &Repair) -> String {
        let display = &self.checker.notes.equations[at];
        let span = Span::new(repair.span.start - display.body.start, repair.span.end - display.body.start);
        Edit { span, replacement: repair.replacement.clone(), slip: repair.slip }.applied(&display.text)
    }

    /// Whether a correction puts a name into a display that it does not contain.
    pub(super) fn adds_a_name(&self, at: usize, repair: &Repair) -> bool {
        let (model, display) = (self.checker.model, &self.checker.notes.equations[at]);
        let printed = gate::symbols_of(&display.text, model);
        gate::symbols_of(&self.corrected(at, repair), model).iter().any(|id| !printed.contains(id))
    }

    /// Whether a correction puts a name into a display whose formula may be wrong, or was read as 0.
    fn brings_doubt(&self, at: usize, repair: &Repair) -> bool {
        let (model, display) = (self.checker.model, &self.checker.notes.equations[at]);
        let printed = gate::symbols_of(&display.text, model);
        let new = gate::symbols_of(&self.corrected(at, repair), model).into_iter().filter(|id| !printed.contains(id));
        let node = |id: SymbolId| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
        new.flat_map(|id| gate::names(&node(id), model)).any(|id| self.doubtful.contains(&id))
    }

    /// Whether the words say that a display is about another thing than a definition that it uses: a sphere, and not a disc.
    fn is_about_another(&self, at: usize) -> bool {
        let checker = self.checker;
        let origin = self.scope.origin_of(at, checker.notes.equations.len());
        let Some(object) = prose::object(checker.notes, origin) else { return false };
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let used: Vec<SymbolId> = members.flat_map(|member| gate::names(member, checker.model)).collect();
        let defines = |place: &usize| checker.readings[*place].introduced.iter().any(|new| used.contains(&new.symbol));
        let other = |place: usize| prose::object(checker.notes, place).is_some_and(|other| other != object);
        (0..origin).filter(defines).any(other)
    }
}

/// Whether two symbols of the counterexample are equal: the premises hold only in a special case, of which the display does not
/// speak.
fn is_degenerate(found: &Equation) -> bool {
    let parts = found.parts.iter().filter_map(|part| part.finding.counterexample.as_ref());
    parts.chain(&found.finding.counterexample).any(|counterexample| {
        let values: Vec<f64> = counterexample.state.iter().map(|(_, value)| *value).collect();
        let is_equal = |a: f64, b: f64| a != 0.0 && (a - b).abs() <= EQUAL * a.abs();
        values.iter().enumerate().any(|(at, a)| values[..at].iter().any(|b| is_equal(*a, *b)))
    })
}

/// Whether a correction is one of a condition. There a term may be missing, or have another sign, on purpose.
fn may_be_under_a_condition(repair: &Repair) -> bool {
    matches!(repair.slip, Slip::Number | Slip::Exponent | Slip::Fraction | Slip::Function)
}

/// Whether a correction changes only the index of a state: authors write one quantity with and without it.
fn adds_a_state(repair: &Repair, checker: &Checker<'_>) -> bool {
    let base = |text: &str| text.split('_').next().unwrap_or_default().trim().to_owned();
    let printed = checker.source.slice(repair.span);
    let before = checker.source.text[..repair.span.start].trim_end();
    let is_added = printed.trim().is_empty() && repair.replacement.trim_start().starts_with('_');
    base(printed) == base(&repair.replacement) || is_added || before.ends_with('_')
}

/// Whether a correction changes only a sign to a minus. With another sign a frequency is that about another place, such as the
/// lowest one.
fn only_negates(repair: &Repair, checker: &Checker<'_>) -> bool {
    let unsigned = |text: &str| text.replace(['-', ' '], "").replace("\\left", "").replace("\\right", "");
    let printed = checker.source.slice(repair.span);
    repair.replacement.contains('-')
        && !printed.contains(['+', '-'])
        && unsigned(&repair.replacement).replace(['(', ')'], "") == unsigned(printed).replace(['(', ')'], "")
}
