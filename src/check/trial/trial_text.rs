//! Whether another text would pass in the place of a display: the question of mutation testing and of repair.
//!
//! # How a text is judged in the place of a display
//!
//! It is read with the names of the document, and refuted by one of a few states that were drawn once, which takes
//! microseconds; what these do not refute gets the full check. The states are on shell where a claim that holds
//! only on shell would pass, so no text is refuted that the check would pass.

use crate::Result;
use crate::formula::{Expr, Index, Node, Relation, Statement, SymbolId};
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::{Claim, Holds};
use crate::scalar::TERMS;
use crate::source::Span;

use crate::check::certificate::claim::Certificate;
use crate::check::certificate::signs::is_never_zero;
use crate::check::certificate::{decide, formulas};
use crate::check::document::checker::Checker;
use crate::check::document::names::{is_plain, shown};
use crate::check::document::reread;
use crate::check::hypotheses::rule::Rule;
use crate::check::judge::difference;
use crate::check::kinds::small;
use crate::check::kinds::small::Shrinkage;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::{Context, Options};
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::outcome;
use crate::check::sample::setting::FEWEST;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::vacuity::restatement;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Part;

/// A text is refuted at one of so many states, before it is checked in full.
const STATES: usize = 6;

/// What is said of a text in the place of a display.
pub(crate) enum Answer {
    /// It reads as what stands there.
    Same,
    /// It cannot be read, its types or its units do not fit, or it says too little to be checked.
    Refused,
    /// It is false, by what the display defines.
    Refuted,
    /// It passes, with the findings on its parts.
    Passes(Reading, Vec<Part>),
}

/// A display, ready to have other texts tried in its place.
pub(crate) struct Trial<'d, 'a> {
    checker: &'d Checker<'a>,
    /// The same, with few states and without explanations.
    quick: Checker<'a>,
    /// The same without explanations.
    full: Checker<'a>,
    at: usize,
    claim: &'d Claim,
    /// How the display is read now.
    now: &'d Reading,
    topic: String,
    hypotheses: Vec<Hypothesis>,
    local: Vec<Rule>,
    /// States for each statement; none where what is claimed is more than an equation.
    screens: Vec<Option<Ensemble<'d>>>,
    /// Families of states for each statement of which something is claimed while some quantities are small.
    shrinking: Vec<Vec<Shrinkage<'d>>>,
    /// The one step of a chain that is looked at, by its statement and the member it leads to.
    step: Option<(usize, usize)>,
}

impl<'d, 'a> Trial<'d, 'a> {
    /// Of the `at`-th display, as it is read now.
    ///
    /// # Errors
    /// For a claim that does not fit the notes.
    pub fn new(checker: &'d Checker<'a>, at: usize, now: &'d Reading, claim: &'d Claim) -> Result<Self> {
        let topic = shown(&checker.notes.equations[at]);
        let (hypotheses, local) = (checker.hypotheses(claim)?, checker.local(claim)?);
        let with = |points: usize| {
            let options = Options { points: points.min(checker.options.points), explain: false, ..checker.options };
            Checker { options, units: checker.units.clone(), ..*checker }
        };
        let mut trial = Trial {
            checker,
            quick: with(FEWEST),
            full: with(checker.options.points),
            at,
            claim,
            now,
            topic,
            hypotheses,
            local,
            screens: Vec::new(),
            shrinking: Vec::new(),
            step: None,
        };
        if is_screened(claim) {
            let all = now.statements.iter().enumerate();
            trial.screens = all
                .map(|(n, statement)| {
                    let members = statement.as_ref().map_or(Vec::new(), |s| s.members.iter().collect());
                    trial.screen(n, &members)
                })
                .collect();
        }
        if !claim.small.is_empty() {
            trial.shrinking = (0..now.statements.len()).map(|n| trial.shrinking(n)).collect();
        }
        Ok(trial)
    }

    /// The same of one step of a chain, which `now` has been cut to: whatever text is tried is [`cut`] so.
    pub fn of_step(self, step: (usize, usize)) -> Self {
        Trial { step: Some(step), ..self }
    }

    /// A few states for a statement: on shell, where what holds on shell only would pass.
    fn screen(&self, statement: usize, members: &[&Expr]) -> Option<Ensemble<'d>> {
        let topic = format!("{} trial {statement}", self.topic);
        let always = self.claim.holds.as_ref().is_some_and(|holds| holds.value == Holds::Always);
        let context = self.context(&topic);
        let mut mode = context.mode(!always && self.checker.model.has_motion(), members);
        // A slip may need one derivative more.
        mode.order = (mode.order + 1).clamp(3, TERMS - 1);
        let drawn = context.ensemble_of(self.checker.model, mode, STATES.min(self.checker.options.points), "trial");
        drawn.ok().filter(|ensemble| !ensemble.states.is_empty())
    }

    /// Families of states for what a statement says while some quantities are small.
    fn shrinking(&self, statement: usize) -> Vec<Shrinkage<'d>> {
        let (checker, topic) = (self.checker, format!("{} trial {statement}", self.topic));
        let context = self.context(&topic);
        let is_approximate = |relation: Relation| relation == Relation::Approximately;
        let links: Vec<Link> = links(checker, (self.now, statement), self.claim, is_approximate).collect();
        let sides: Vec<&Expr> = links.iter().flat_map(|link| [&link.lhs, &link.rhs]).collect();
        let on_shell = self.claim.holds.as_ref().map(|holds| holds.value == Holds::OnShell);
        let mut mode = context.mode(on_shell.unwrap_or(checker.model.has_motion()), &sides);
        // A slip may need one derivative more.
        mode.order = (mode.order + 1).min(TERMS - 1);
        let small: Result<Vec<Expr>> = self.claim.small.iter().map(|latex| checker.formula(latex)).collect();
        let families = small.and_then(|small| small::screen(checker.model, mode, &small, &context));
        families.ok().filter(|_| !links.is_empty()).unwrap_or_default()
    }

    /// What is said of a text in the place of the display.
    ///
    /// # Errors
    /// As for a check of the display itself.
    pub fn of(&self, text: &str) -> Result<Answer> {
        self.of_one(text, |_| true)
    }

    /// The same; a reading that says nothing of interest is refused before it is checked in full.
    ///
    /// # Errors
    /// As there.
    pub fn of_one(&self, text: &str, says_something: impl Fn(&Reading) -> bool) -> Result<Answer> {
        let mut reading = reread::read(self.checker, &self.checker.model.macros, self.at, text, self.claim);
        if let Some(step) = self.step {
            cut(&mut reading, step);
        }
        if reading.statements.iter().any(std::result::Result::is_err) {
            return Ok(Answer::Refused);
        }
        if reread::reads_alike(&reading, self.now) {
            return Ok(Answer::Same);
        }
        if self.fails(&reading) {
            return Ok(Answer::Refuted);
        }
        if !says_something(&reading) || reread::lost(self.checker, &reading, self.now).is_some() {
            return Ok(Answer::Refused);
        }
        let offset = self.checker.notes.equations[self.at].body.start;
        let is_wrong = |part: &Part| matches!(part.finding.verdict, Verdict::Refuted | Verdict::Domain);
        let judged = |checker: &Checker<'_>| checker.parts((self.at, offset), &reading, self.claim, &self.topic);
        if !is_plain(self.claim) && judged(&self.quick).is_ok_and(|parts| parts.iter().any(is_wrong)) {
            return Ok(Answer::Refuted);
        }
        let Ok(parts) = self.judged(&reading, offset) else { return Ok(Answer::Refused) };
        Ok(match parts.iter().all(|part| part.finding.verdict.passes()) {
            true => Answer::Passes(reading, parts),
            false if parts.iter().any(is_wrong) => Answer::Refuted,
            false => Answer::Refused,
        })
    }

    /// Whether what stands there holds at the few states.
    pub fn stands(&self) -> bool {
        !self.fails(self.now)
    }

    /// The findings on a reading, in full. What it introduces is held to what the rest of it says.
    fn judged(&self, reading: &Reading, offset: usize) -> Result<Vec<Part>> {
        let judged = |checker: &Checker<'_>| checker.parts((self.at, offset), reading, self.claim, &self.topic);
        if reading.introduced.is_empty() || reading.statements.len() < 2 {
            return judged(&self.full);
        }
        let mut readings = self.full.readings.to_vec();
        readings[self.at] = reading.clone();
        judged(&Checker { readings: &readings, units: self.full.units.clone(), ..self.full })
    }

    /// Whether a reading is proved over a field to say what the display says, member for member, or to follow from it.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    pub fn is_as_true(&self, reading: &Reading) -> Result<bool> {
        let original = &self.now.statements;
        if original.len() != reading.statements.len() {
            return Ok(false);
        }
        for statements in original.iter().zip(&reading.statements) {
            let (Ok(was), Ok(is)) = statements else { return Ok(false) };
            if was.members.len() != is.members.len()
                || !was.relations.iter().map(|r| r.0).eq(is.relations.iter().map(|r| r.0))
            {
                return Ok(false);
            }
            let link =
                |s: &Statement, at: usize| self.checker.link(&s.members[at], s.relations[at].0, &s.members[at + 1]);
            let alike = |at| matches!((link(was, at), link(is, at)), (Ok(a), Ok(b)) if restatement::same_but_for_letters(&a, &b));
            if (0..was.relations.len()).all(alike) {
                continue;
            }
            let mut same = true;
            for (a, b) in was.members.iter().zip(&is.members).filter(|(a, b)| a != b) {
                same = same && self.is_same(a, b)?;
            }
            let model = self.checker.model;
            let never_zero = |factor: &Expr| is_never_zero(model, factor);
            let follows = |at: usize| {
                // A multiple of what is no equality says something else.
                let relation = was.relations[at].0;
                let equal = is_equality(relation) || relation == Relation::Approximately;
                let null = equal && was.members[at + 1].is_null() && is.members[at + 1].is_null();
                null && formulas::vanishes_with(&is.members[at], &was.members[at], model, &never_zero)
            };
            let kept = |at: usize| is.members[at..=at + 1] == was.members[at..=at + 1];
            if !same && !(0..was.relations.len()).all(|at| kept(at) || follows(at)) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether two formulas are proved to be one: whatever their symbols mean, or as they are meant, or where the
    /// hypotheses of the claim hold.
    fn is_same(&self, a: &Expr, b: &Expr) -> Result<bool> {
        let model = self.checker.model;
        if formulas::same(a, b, model) || formulas::same(&self.opened(a), &self.opened(b), model) {
            return Ok(true);
        }
        // What is of another type is another thing.
        match self.checker.link(a, Relation::Equal, b) {
            Ok(link) => Ok(self.implied(&[], &link)? || self.implied(&self.hypotheses, &link)?),
            Err(_) => Ok(false),
        }
    }

    /// A formula with what is defined written out, and with the right sides of hypotheses that hold throughout in the
    /// places of their left sides.
    fn opened(&self, expr: &Expr) -> Expr {
        let by_hypothesis = |expr: &Expr| {
            let known = |c: &&Hypothesis| c.throughout && is_equality(c.relation) && c.lhs == *expr;
            self.hypotheses.iter().find(known).map(|hypothesis| hypothesis.rhs.clone())
        };
        if let Some(other) = by_hypothesis(expr) {
            return other;
        }
        let model = self.checker.model;
        if let Node::Symbol { id, indices, dots } = &expr.node
            && let Some(Meaning::Defined(formula)) = model.meaning(*id)
            && model
                .symbols
                .entry(*id)
                .slots
                .iter()
                .map(|(_, letter)| Index::Letter(*letter))
                .eq(indices.iter().copied())
        {
            let formula = self.opened(formula);
            return match dots {
                0 => formula,
                dots => Expr::new(Node::TimeDerivative(*dots, Box::new(formula)), expr.span),
            };
        }
        let mut opened = expr.clone();
        opened.children_mut().into_iter().for_each(|child| *child = self.opened(child));
        opened
    }

    /// Whether a link is an identity where some hypotheses hold.
    fn implied(&self, hypotheses: &[Hypothesis], link: &Link) -> Result<bool> {
        let context = Context { hypotheses: hypotheses, ..self.context(&self.topic) };
        let mode = context.mode(false, &[&link.lhs, &link.rhs]);
        let ensemble = context.ensemble(mode, false, STATES)?;
        if ensemble.states.is_empty() {
            return Ok(false);
        }
        let holds = outcome::run(link, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_none());
        Ok(holds && matches!(decide::certify(link, &context, &ensemble), Certificate::Identity(_)))
    }

    /// Whether a reading has the rate of something that stands still in a place where what is displayed has none: such a
    /// product, or a term of a sum, is zero, and says nothing.
    pub fn stands_still(&self, reading: &Reading) -> bool {
        let mut rates: Vec<&Expr> = Vec::new();
        for member in reading.statements.iter().flatten().flat_map(|statement| &statement.members) {
            member.walk(&mut |part| {
                let inner =
                    part.children().into_iter().filter(|inner| matches!(inner.node, Node::Symbol { dots: 1.., .. }));
                if !matches!(&part.node, Node::Sum(terms) if terms.len() < 2) {
                    rates.extend(inner);
                }
            });
        }
        let mut printed: Vec<(SymbolId, u8)> = Vec::new();
        self.now
            .statements
            .iter()
            .flatten()
            .flat_map(|s| &s.members)
            .for_each(|member| printed.extend(member.symbols()));
        rates.retain(|rate| rate.symbols().iter().any(|symbol| !printed.contains(symbol)));
        let screens = || self.screens.iter().flatten().flat_map(|screen| &screen.states);
        let is_zero = |rate: &Expr, state| difference::value(rate, state).is_some_and(residual::vanishes);
        rates.into_iter().any(|rate| screens().next().is_some() && screens().all(|state| is_zero(rate, state)))
    }

    fn context<'c>(&'c self, topic: &'c str) -> Context<'c> {
        Context {
            model: self.checker.model,
            options: self.checker.options,
            hypotheses: &self.hypotheses,
            on_shell: None,
            topic,
            span: Span::default(),
            spread: Spread::Declared,
            local: &self.local,
        }
    }

    /// Whether one of the few states refutes a reading, or one of the few families.
    fn fails(&self, reading: &Reading) -> bool {
        let order = self.claim.order.as_ref().map_or(1, |order| order.value);
        let is_approximate = |relation: Relation| relation == Relation::Approximately;
        let is_missed = |(n, families): (usize, &Vec<Shrinkage<'_>>)| {
            links(self.checker, (reading, n), self.claim, is_approximate)
                .any(|link| small::is_missed(&link, order, families))
        };
        if reading.statements.len() == self.shrinking.len() && self.shrinking.iter().enumerate().any(is_missed) {
            return true;
        }
        // With a ± for a sign one statement has become two.
        let screen = |n: usize| match self.screens.as_slice() {
            [only] => only.as_ref(),
            all if all.len() == reading.statements.len() => all[n].as_ref(),
            _ => None,
        };
        (0..reading.statements.len()).any(|n| {
            screen(n).is_some_and(|s| tested(self.checker, (reading, n), self.claim).any(|link| refuted(&link, s)))
        })
    }
}

/// The links of a statement that hold by themselves, whatever more is claimed of it: not those that define something, and
/// not those that are claimed of a limit or of what is dropped.
pub(crate) fn tested<'r>(
    checker: &'r Checker<'_>,
    (reading, n): (&'r Reading, usize),
    claim: &'r Claim,
) -> impl Iterator<Item = Link> + 'r {
    links(checker, (reading, n), claim, is_tested)
}

/// The links of a statement with a relation that is wanted, but for those that define something, and those that are
/// claimed of a limit or of what is dropped.
fn links<'r>(
    checker: &'r Checker<'_>,
    (reading, n): (&'r Reading, usize),
    claim: &'r Claim,
    wanted: impl Fn(Relation) -> bool + 'r,
) -> impl Iterator<Item = Link> + 'r {
    let introduced: Vec<&DefinedSymbol> = reading.introduced.iter().filter(|new| new.statement == n).collect();
    let defines = move |at: usize| introduced.iter().any(|new| new.member == at + 1 || at == 0 && new.member == 0);
    reading.statements[n].iter().flat_map(move |statement| {
        let count = statement.relations.len();
        let solves = |at: usize| at == 0 && checker.is_unknown_of(&statement.members[0], claim).unwrap_or(true);
        let drops = |at: usize| at + 1 == count && claim.dropping.is_some();
        let link =
            |at: usize| checker.link(&statement.members[at], statement.relations[at].0, &statement.members[at + 1]);
        let checked = (0..count).filter(|at| wanted(statement.relations[*at].0) && !defines(*at));
        checked.filter(|at| !solves(*at) && !drops(*at)).filter_map(|at| link(at).ok()).collect::<Vec<_>>()
    })
}

/// Leaves of a chain the step to a member: this and the one before it.
pub(crate) fn cut(reading: &mut Reading, (at, member): (usize, usize)) {
    if let Some(Ok(statement)) = reading.statements.get_mut(at)
        && (1..statement.members.len()).contains(&member)
    {
        statement.members = statement.members[member - 1..=member].to_vec();
        statement.relations = vec![statement.relations[member - 1]];
        statement.constant = None;
        reading.introduced.retain(|introduced| introduced.statement != at);
    }
}

fn is_tested(relation: Relation) -> bool {
    is_equality(relation)
        || matches!(relation, Relation::Less | Relation::Greater | Relation::LessEqual | Relation::GreaterEqual)
}

fn refuted(link: &Link, screen: &Ensemble<'_>) -> bool {
    screen.states.iter().any(|state| matches!(residual::test(link, state), Ok(Point::Fails(_) | Point::OneSided(_))))
}

/// Whether the equalities and inequalities of a claim's equation have to hold by themselves.
fn is_screened(claim: &Claim) -> bool {
    claim.exactly_when.is_empty() && claim.continuum_limit_of.is_none() && claim.skip.is_none()
}
