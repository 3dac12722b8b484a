//! The trial of a text in place of a display: whether it would pass.
//!
//! A text is read with the names of the document and checked by the claim of the display. Most wrong texts fail at the first
//! state. So a few states are sampled once for all texts, and a text that fails at one of them is refuted. Any other text
//! gets the full check, with mutants and certificate. The few states only refute.
//!
//! # How a text is judged in the place of a display
//!
//! It is read with the names of the document, and refuted by one of a few states that were drawn once, which takes
//! microseconds; what these do not refute gets the full check. The states are on shell where a claim that holds
//! only on shell would pass, so no text is refuted that the check would pass.

use crate::Result;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::{Claim, Conserved, Holds};
use crate::scalar::TERMS;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::document::normal_frequencies;
use crate::check::document::reread;
use crate::check::hypotheses::rule::Rule;
use crate::check::judge::difference;
use crate::check::kinds::limit;
use crate::check::kinds::printed_solution::Solution;
use crate::check::kinds::series::{self, Read};
use crate::check::kinds::small;
use crate::check::kinds::small::ShrinkingFamily;
use crate::check::kinds::solution;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Variable;
use crate::check::model::sampling::{Mode, Spread};
use crate::check::sample::context::{Context, Options};
use crate::check::sample::ensemble::Ensemble;
use crate::check::sample::setting::FEWEST;
use crate::check::state::residual;
use crate::check::state::residual::Point;
use crate::check::trial::failed_display::cut_to_step;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Part;

/// The number of states that screen a text before its full check.
pub(super) const STATES: usize = 6;

/// The number of ways to a limit that screen a text, and the distance of a ratio from 1 that refutes it.
const LIMITS: usize = 2;
const APART: f64 = 0.1;

/// The outcome of a trial.
pub(crate) enum Answer {
    /// It reads as the original does.
    Same,
    /// It cannot be read, its types or its units do not fit, or it says too little to be checked.
    Refused,
    /// It is false.
    Refuted,
    /// It passes, with the findings on its parts.
    Passes(Reading, Vec<Part>),
}

/// A display with the states that screen other texts in its place.
pub(crate) struct Trial<'d, 'a> {
    pub(super) checker: &'d Checker<'a>,
    /// The same checker, with few states and without explanations.
    quick: Checker<'a>,
    /// The same checker, without explanations.
    full: Checker<'a>,
    at: usize,
    claim: &'d Claim,
    /// The reading of the original text.
    pub(super) now: &'d Reading,
    pub(super) topic: String,
    pub(super) hypotheses: Vec<Hypothesis>,
    local: Vec<Rule>,
    /// The screening states of each statement; `None`, where the statement need not hold at each state.
    screens: Vec<Option<Ensemble<'d>>>,
    /// The screening families of each statement with ≈, along which the small quantities shrink.
    shrinking: Vec<Vec<Vec<ShrinkingFamily<'d>>>>,
    /// Whether the equations need hold to first order in a small motion only.
    is_linear: bool,
    /// The only step of a chain to check, as the statement and the member that the step leads to.
    step: Option<(usize, usize)>,
}

impl<'d, 'a> Trial<'d, 'a> {
    /// A trial for the `at`-th display, whose original reading is `now`.
    ///
    /// # Errors
    /// For a claim that does not fit the notes.
    pub fn new(checker: &'d Checker<'a>, at: usize, now: &'d Reading, claim: &'d Claim) -> Result<Self> {
        let topic = shown(&checker.notes.equations[at]);
        let (mut hypotheses, local) = (checker.hypotheses(claim)?, checker.local(claim)?);
        let members = now.statements.iter().flatten().flat_map(|statement| &statement.members);
        hypotheses.extend(normal_frequencies::exist(members, checker.model));
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
            is_linear: false,
            step: None,
        };
        let small = checker.small_motion_of(claim, checker.notes.equations[at].body);
        trial.is_linear = small.is_some();
        if let Some(ways) = small {
            trial.shrinking = (0..now.statements.len()).map(|n| trial.shrinking_motion(n, &ways)).collect();
            return Ok(trial);
        }
        if claim.holds_at_states() {
            let all = now.statements.iter().enumerate();
            trial.screens = all
                .map(|(n, statement)| {
                    let members = statement.as_ref().map_or(Vec::new(), |s| s.members.iter().collect());
                    trial.screen(n, &members)
                })
                .collect();
        }
        let leaves_out = |member: &Expr| series::has_rest(member);
        if !claim.small.is_empty()
            || now.statements.iter().flatten().flat_map(|statement| &statement.members).any(leaves_out)
        {
            trial.shrinking = (0..now.statements.len()).map(|n| trial.shrinking(n)).collect();
        }
        Ok(trial)
    }

    /// The same trial for one step of a chain, which `now` is cut to; each text is cut to it as well.
    pub fn for_step(self, step: (usize, usize)) -> Self {
        Trial { step: Some(step), ..self }
    }

    /// The screening states of a statement; on shell, unless the claim must hold always.
    fn screen(&self, statement: usize, members: &[&Expr]) -> Option<Ensemble<'d>> {
        let topic = format!("{} trial {statement}", self.topic);
        let always = self.claim.holds.as_ref().is_some_and(|holds| holds.value == Holds::Always);
        let context = self.context(&topic);
        let mode = context.mode(!always && self.checker.model.has_motion(), members);
        let all = self.checker.options.points;
        let drawn = |order: usize, points: usize| {
            let mode = Mode { order, ..mode };
            let drawn = context.ensemble_of(self.checker.model, mode, points, "trial");
            drawn.ok().filter(|ensemble| !ensemble.states.is_empty())
        };
        // A text may need one derivative more than the original. Where no state has so many, fewer refute most texts too.
        let found = drawn((mode.order + 1).clamp(3, TERMS - 1), STATES.min(all));
        found.or_else(|| drawn(mode.order, STATES.min(all))).or_else(|| drawn(mode.order, all))
    }

    /// The screening families of a statement that claims something for small quantities.
    fn shrinking(&self, statement: usize) -> Vec<Vec<ShrinkingFamily<'d>>> {
        let (checker, topic) = (self.checker, format!("{} trial {statement}", self.topic));
        let context = self.context(&topic);
        let is_approximate = |relation: Relation| relation == Relation::Approximately;
        let links: Vec<Link> = links(checker, (self.now, statement), self.claim, is_approximate).collect();
        let series = links.iter().find_map(|link| match self.read(link) {
            Read::Series(series) => Some(series.small_names()),
            _ => None,
        });
        let links: Vec<Link> = links.iter().filter_map(|link| Some(self.to_order(link)?.0)).collect();
        let sides: Vec<&Expr> = links.iter().flat_map(|link| [&link.lhs, &link.rhs]).collect();
        let on_shell = self.claim.holds.as_ref().map(|holds| holds.value == Holds::OnShell);
        let mut mode = context.mode(on_shell.unwrap_or(checker.model.has_motion()), &sides);
        // A text may need one derivative more than the original.
        mode.order = (mode.order + 1).min(TERMS - 1);
        let small: Result<Vec<Expr>> = self.claim.small.iter().map(|latex| checker.formula(latex)).collect();
        let small = small.map(|small| if small.is_empty() { series.unwrap_or_default() } else { small });
        let families = small.and_then(|small| {
            let with_rates = small::with_rates(&small, checker.model);
            let ways: Vec<Vec<Expr>> = std::iter::once(small).chain(with_rates).collect();
            small::screen(checker.model, mode, &ways, &context)
        });
        families.ok().filter(|_| !links.is_empty()).unwrap_or_default()
    }

    /// The screening families of a statement about a small motion.
    fn shrinking_motion(&self, statement: usize, ways: &[Vec<Expr>]) -> Vec<Vec<ShrinkingFamily<'d>>> {
        let topic = format!("{} trial {statement}", self.topic);
        let context = self.context(&topic);
        let links: Vec<Link> = links(self.checker, (self.now, statement), self.claim, is_equality).collect();
        let sides: Vec<&Expr> = links.iter().flat_map(|link| [&link.lhs, &link.rhs]).collect();
        let mut mode = context.mode(true, &sides);
        // A text may need one derivative more than the original.
        mode.order = (mode.order + 1).min(TERMS - 1);
        let families = small::screen(self.checker.model, mode, ways, &context);
        families.ok().filter(|_| !links.is_empty()).unwrap_or_default()
    }

    /// The outcome of a text in place of the display. A reading for which `says_something` is false is refused before its
    /// full check.
    ///
    /// # Errors
    /// As for a check of the display itself.
    pub fn judge_where(&self, text: &str, says_something: impl Fn(&Reading) -> bool) -> Result<Answer> {
        let mut reading = reread::read_in_place(self.checker, &self.checker.model.macros, self.at, text, self.claim);
        if let Some(step) = self.step {
            cut_to_step(&mut reading, step);
        }
        if reading.statements.iter().any(std::result::Result::is_err) {
            return Ok(Answer::Refused);
        }
        if reread::reads_alike(&reading, self.now) {
            return Ok(Answer::Same);
        }
        if self.fails_screen(&reading) {
            return Ok(Answer::Refuted);
        }
        let offset = self.checker.notes.equations[self.at].body.start;
        let is_wrong = |part: &Part| matches!(part.finding.verdict, Verdict::Refuted | Verdict::Domain);
        let is_refuted = || self.judged(&self.quick, &reading, offset).is_ok_and(|parts| parts.iter().any(is_wrong));
        let dots = self.motions(&reading);
        // A solution is no correction of a rate, and neither is what is no solution any more.
        let printed = self.motions(self.now);
        if dots != printed && printed.iter().any(|dots| *dots > 0) || dots.len() < printed.len() {
            return Ok(Answer::Refused);
        }
        if !dots.is_empty() && (self.misses_the_motion(&reading) || is_refuted()) {
            return Ok(Answer::Refuted);
        }
        if !says_something(&reading) || reread::missing_from_print(self.checker, &reading, self.now).is_some() {
            return Ok(Answer::Refused);
        }
        let is_along = self.checker.model.has_motion() && self.is_along_the_motion(&reading);
        if (!self.claim.is_plain() || self.is_linear || is_along) && is_refuted() {
            return Ok(Answer::Refuted);
        }
        let Ok(parts) = self.judged(&self.full, &reading, offset) else { return Ok(Answer::Refused) };
        Ok(match parts.iter().all(|part| part.finding.verdict.passes()) {
            true => Answer::Passes(reading, parts),
            false if parts.iter().any(is_wrong) => Answer::Refuted,
            false => Answer::Refused,
        })
    }

    /// Whether premises leave no state at which a text could be refuted, so that each text would need the full check.
    pub fn has_no_screen(&self) -> bool {
        !self.hypotheses.is_empty() && !self.screens.is_empty() && self.screens.iter().all(Option::is_none)
    }

    /// Whether the original passes the screening states.
    pub fn passes_screen(&self) -> bool {
        !self.fails_screen(self.now)
    }

    /// The findings of a checker on a reading. The other statements of the reading test the names that it introduces, and are
    /// the solutions for the other coordinates.
    fn judged(&self, checker: &Checker<'a>, reading: &Reading, offset: usize) -> Result<Vec<Part>> {
        if reading.statements.len() < 2 {
            return checker.parts((self.at, offset), reading, self.claim, &self.topic);
        }
        let mut readings = checker.readings.to_vec();
        readings[self.at] = reading.clone();
        let checker = Checker { readings: &readings, units: checker.units.clone(), ..*checker };
        checker.parts((self.at, offset), reading, self.claim, &self.topic)
    }

    /// The number of dots of each solution of the motion, or rate of one, that a reading prints. No screening state tests these.
    fn motions(&self, reading: &Reading) -> Vec<u8> {
        self.solutions(reading).iter().map(|found| found.dots).collect()
    }

    /// Whether a reading may hold along a printed solution only, which no screening state shows.
    fn is_along_the_motion(&self, reading: &Reading) -> bool {
        let is_one = |statement: &Statement| {
            let pairs = statement.members.windows(2).zip(&statement.relations);
            let mut links =
                pairs.filter_map(|(pair, (relation, _))| self.checker.link(&pair[0], *relation, &pair[1]).ok());
            links.any(|link| self.checker.is_along_the_motion(&link))
        };
        reading.statements.iter().flatten().any(is_one)
    }

    fn solutions(&self, reading: &Reading) -> Vec<Solution> {
        let printed = |statement: &Statement| {
            let (relation, _) = statement.relations.first()?;
            let link = self.checker.link(&statement.members[0], *relation, &statement.members[1]).ok()?;
            self.checker.solution(&link, 0, self.claim)
        };
        reading.statements.iter().flatten().filter_map(printed).collect()
    }

    /// Whether a reading that prints a solution for each coordinate misses the equations of motion at a few states.
    fn misses_the_motion(&self, reading: &Reading) -> bool {
        let all = self.solutions(reading);
        let given = |q: &Variable| all.iter().any(|known| known.coordinate == q.symbol && known.dots == 0);
        if !self.checker.model.coordinates.iter().all(given)
            || !self.hypotheses.is_empty()
            || self.claim.is_near_by_prose()
        {
            return false;
        }
        let topic = format!("{} trial solutions", self.topic);
        let context = &self.context(&topic).quick();
        all.iter().any(|own| {
            let others: Vec<Solution> =
                all.iter().filter(|known| known.coordinate != own.coordinate).cloned().collect();
            solution::is_on_shell(own, &others, context).is_ok_and(|exact| exact == Some(false))
                && solution::in_first_order(own, &others, context).is_ok_and(|linear| linear.is_none())
        })
    }

    /// Whether a reading contains a rate that is zero at all screening states and that the original does not contain. Such a
    /// factor or term makes an equation true without saying anything.
    pub fn has_vanishing_rate(&self, reading: &Reading) -> bool {
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

    pub(super) fn context<'c>(&'c self, topic: &'c str) -> Context<'c> {
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

    /// Whether the sides of a statement with ≈ are far from each other on the way to the limit of the claim.
    fn misses_limit(&self, reading: &Reading, n: usize) -> bool {
        let Some(Ok((variable, towards))) = self.claim.limit.as_ref().map(|limit| self.checker.limit(limit)) else {
            return false;
        };
        let topic = format!("{} trial {n}", self.topic);
        let context = self.context(&topic);
        // On shell the sides may be nearer.
        let is_approximate = |relation: Relation| relation == Relation::Approximately;
        !self.checker.model.has_motion()
            && links(self.checker, (reading, n), self.claim, is_approximate).any(|link| {
                let found = limit::ratios(&link, variable, towards, (&context, LIMITS)).unwrap_or_default();
                found.into_iter().flatten().any(|ratio| (ratio - 1.0).abs() > APART)
            })
    }

    fn read(&self, link: &Link) -> Read {
        let topic = format!("{} trial expansion", self.topic);
        let expanded = self.checker.expanded_solution(link, &self.context(&topic).quick()).ok().flatten();
        series::of(
            expanded.as_ref().unwrap_or(link),
            self.claim.small.is_empty() && self.claim.limit.is_none(),
            self.checker.model,
        )
    }

    /// A link that holds to an order when something is small.
    fn to_order(&self, link: &Link) -> Option<(Link, u32)> {
        let claimed = self.claim.order.as_ref().map_or(1, |order| order.value);
        match self.read(link) {
            Read::Series(series) => Some((series.link, series.order)),
            Read::Plain if !self.claim.small.is_empty() => Some((link.clone(), claimed)),
            Read::Cut(link) if !self.claim.small.is_empty() => Some((link, claimed)),
            _ => None,
        }
    }

    /// Whether a screening state or a screening family refutes a reading.
    fn fails_screen(&self, reading: &Reading) -> bool {
        let is_approximate = |relation: Relation| relation == Relation::Approximately;
        let misses_order = |(n, ways): (usize, &Vec<Vec<ShrinkingFamily<'_>>>)| {
            let is_wanted = |relation: Relation| is_approximate(relation) || self.is_linear && is_equality(relation);
            links(self.checker, (reading, n), self.claim, is_wanted)
                .filter_map(|link| if self.is_linear { Some((link, 1)) } else { self.to_order(&link) })
                .any(|(link, order)| small::misses_order(&link, order, ways))
        };
        if self.claim.limit.is_some() && (0..reading.statements.len()).any(|n| self.misses_limit(reading, n)) {
            return true;
        }
        if reading.statements.len() == self.shrinking.len() && self.shrinking.iter().enumerate().any(misses_order) {
            return true;
        }
        let deduction = self.checker.options.deduction;
        (0..reading.statements.len()).any(|n| {
            self.screen_of(reading, n).is_some_and(|s| {
                tested_links(self.checker, (reading, n), self.claim).any(|link| refuted(&link, s, deduction))
            })
        }) || self.changes_a_constant(reading)
    }

    /// The screening states of a statement of a reading.
    fn screen_of(&self, reading: &Reading, n: usize) -> Option<&Ensemble<'d>> {
        // A text with ± in place of a sign has two statements for one.
        match self.screens.as_slice() {
            [only] => only.as_ref(),
            all if all.len() == reading.statements.len() => all[n].as_ref(),
            _ => None,
        }
    }

    /// Whether a formula that a reading says is constant changes along the motion at a screening state. Hypotheses about an instant hold
    /// at all times in such a claim, so with hypotheses these states say nothing.
    pub fn changes_a_constant(&self, reading: &Reading) -> bool {
        if !self.checker.model.has_motion() || !self.hypotheses.is_empty() || !self.local.is_empty() {
            return false;
        }
        let own: Vec<SymbolId> = reading.introduced.iter().chain(&self.now.introduced).map(|new| new.symbol).collect();
        let is_claimed = matches!(self.claim.conserved.as_ref().map(|it| &it.value), Some(Conserved::This));
        (0..reading.statements.len()).any(|n| {
            let Ok(statement) = &reading.statements[n] else { return false };
            let constant = (is_claimed || statement.constant.is_some()).then(|| statement.members.last()).flatten();
            // A name that the text defines has another formula in the model.
            let Some(constant) = constant.filter(|member| !self.checker.model.depends_on(member, &own)) else {
                return false;
            };
            let rate = Expr::new(Node::TimeDerivative(1, Box::new(constant.clone())), constant.span);
            let link = self.checker.link(&rate, Relation::Equal, &Expr::integer(0, constant.span));
            let fails = |screen: &Ensemble<'_>| link.as_ref().is_ok_and(|link| refuted(link, screen, true));
            self.screen_of(reading, n).filter(|screen| screen.mode.on_shell).is_some_and(fails)
        })
    }
}

/// The links of a statement that must hold at each state: not those that define a name, print a solution, hold in a limit, or drop
/// terms.
pub(crate) fn tested_links<'r>(
    checker: &'r Checker<'_>,
    (reading, n): (&'r Reading, usize),
    claim: &'r Claim,
) -> impl Iterator<Item = Link> + 'r {
    links(checker, (reading, n), claim, is_tested)
}

/// The links of a statement with a wanted relation, except those that define a name, are solutions, or drop terms.
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
        let is_solution = |at: usize, link: &Link| {
            at == 0 && (checker.is_mode(link) || checker.is_frequency(link))
                || checker.solution(link, at, claim).is_some()
                || checker.model.has_motion() && checker.is_along_the_motion(link)
        };
        let checked = (0..count).filter(|at| wanted(statement.relations[*at].0) && !defines(*at));
        let checked = checked.filter(|at| !solves(*at) && !drops(*at));
        let checked = checked.filter_map(|at| link(at).ok().filter(|link| !is_solution(at, link)));
        checked.collect::<Vec<_>>()
    })
}

fn is_tested(relation: Relation) -> bool {
    is_equality(relation)
        || matches!(relation, Relation::Less | Relation::Greater | Relation::LessEqual | Relation::GreaterEqual)
}

fn refuted(link: &Link, screen: &Ensemble<'_>, deduction: bool) -> bool {
    screen.states.iter().any(|state| match residual::test(link, state) {
        Ok(Point::Fails(_)) => true,
        Ok(Point::OneSided(_)) => !deduction,
        _ => false,
    })
}
