//! When two formulas are nearly equal, in notes that do not say it to a program: A ≈ B holds if A/B tends to 1 as one symbol
//! becomes small or large and the others stay.
//!
//! The words before a display choose the symbol where they name one: "for small x", "at high temperature", `\omega \ll
//! \omega_0`. Else each symbol is tried. What holds in no limit is left open, for a ≈ may rest on numbers or be rough. It is
//! called wrong only if one likely slip lies between it and what holds, in a limit that the words name or in which A/B tends to a
//! simple number.

use crate::Result;
use crate::code::Code;
use crate::formula::symbols::{Kind, Name};
use crate::formula::units::in_si::has_units;
use crate::formula::{Expr, Node, Relation, SymbolId, text};
use crate::notes::claims::{Claim, Range, Spanned};
use crate::source::Span;

use crate::check::kinds::limit::{self, Towards};
use crate::check::kinds::series;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::free_symbols::drawn;
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::{Context, Options};
use crate::check::unaided::calculus::integrals;
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::{prose, remarks};
use crate::check::verdict::report::Equation;

/// The most symbols of two formulas that are compared in limits.
const MOST: usize = 8;

/// The number of states that show a ratio.
const STATES: usize = 4;

/// The distance of a ratio from a number that it tends to.
const NEAR: f64 = 0.02;

/// The largest numerator and denominator of a simple number.
const SIMPLE: u32 = 16;

/// The most limits in which a slip is sought.
const SOUGHT: usize = 2;

/// The most limits that are tested in full.
const TESTED: usize = 4;

/// Words that say that a relation is rough.
const ROUGH: [&str; 14] = [
    "intermediate",
    "moderate",
    "between",
    "not too",
    " but ",
    "rough",
    "order of magnitude",
    "estimate",
    "crude",
    "about",
    "guess",
    "typical",
    "numerical",
    "empiric",
];

/// Words for what is small or large, with the letters that stand for it and whether it becomes large.
const SAID: [(&str, &[&str], bool); 16] = [
    ("high temperature", &["T", "\\theta", "\\tau"], true),
    ("high-temperature", &["T", "\\theta", "\\tau"], true),
    ("low temperature", &["T", "\\theta", "\\tau"], false),
    ("low-temperature", &["T", "\\theta", "\\tau"], false),
    ("high frequenc", &["\\omega", "\\nu", "f"], true),
    ("low frequenc", &["\\omega", "\\nu", "f"], false),
    ("low-frequency", &["\\omega", "\\nu", "f"], false),
    ("high-frequency", &["\\omega", "\\nu", "f"], true),
    ("long time", &["t"], true),
    ("late time", &["t"], true),
    ("short time", &["t"], false),
    ("early time", &["t"], false),
    ("large distance", &["r", "R", "d", "x", "z"], true),
    ("far from", &["r", "R", "d", "x", "z"], true),
    ("low speed", &["v", "u", "\\beta"], false),
    ("small angle", &["\\theta", "\\phi", "\\varphi", "\\alpha"], false),
];

/// A limit in which two formulas may be nearly equal.
struct Condition {
    claim: Claim,
    /// The limit in words.
    says: String,
    variable: SymbolId,
    towards: Towards,
    /// Whether the sides are compared to the order of the last term, and not as a ratio.
    is_ordered: bool,
}

impl Course<'_, '_> {
    /// Whether a derivative in a display was read as 0.
    pub(super) fn lost_derivative(&self, at: usize) -> bool {
        let checker = self.checker;
        gate::lost_derivative(&checker.readings[at], &checker.notes.equations[at], &checker.model.macros)
    }

    /// Whether the sides of a display are nearly equal, and no more.
    pub(super) fn approximates(&self, at: usize) -> bool {
        let relations =
            self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.relations);
        relations.into_iter().all(|(relation, _)| *relation == Relation::Approximately)
    }

    /// Whether nothing says how an integrand of a display depends on the letter of its integral.
    pub(super) fn hides_a_letter(&self, at: usize) -> bool {
        self.hides_a_letter_in(&self.checker.notes.equations[at].text)
    }

    /// The same of a text. What the formula of a name contains, the name depends on.
    pub(super) fn hides_a_letter_in(&self, text: &str) -> bool {
        let model = self.checker.model;
        let depends = |name: &Name, letter: &Name| {
            let Some((id, _)) = model.symbols.find(name) else { return false };
            let Some(Meaning::Defined(formula)) = model.meaning(id) else { return false };
            gate::names(formula, model).into_iter().any(|inner| model.symbols.entry(inner).name == *letter)
        };
        integrals::hides_its_letter(text, &model.macros, &depends)
    }

    /// The finding on a display with ≈ for which nothing says when it holds, if it holds in a limit, or is a slip away from that.
    pub(super) fn nearly(&self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        if found.finding.code != Code::NeedsLimitOrSmall {
            return Ok(None);
        }
        let Some(link) = self.only_approximation(at) else { return Ok(None) };
        let origin = self.scope.origin_of(at, self.checker.notes.equations.len());
        let mut sentence = prose::sentence(self.checker.notes, origin);
        let notes = self.checker.notes;
        if let Some(remark) = remarks::remark(&notes.equations[at], &notes.source) {
            sentence += &format!(" ${remark}$");
        }
        let Some((mut conditions, are_named)) = self.conditions(&link, &sentence) else { return Ok(None) };
        // v ≪ c is that v is small. That c is large as well compares the first terms only.
        if are_named && conditions.iter().any(|condition| condition.is_ordered) {
            conditions.retain(|condition| condition.is_ordered);
        }
        let mut ratios = Vec::new();
        for condition in &conditions {
            ratios.push(self.ratio(&link, condition)?);
        }
        let tends_to_one = |ratio: &Option<f64>| ratio.is_some_and(|ratio| (ratio - 1.0).abs() < NEAR);
        let holding = conditions.iter().zip(&ratios).filter(|(_, ratio)| tends_to_one(ratio));
        for (condition, _) in holding.take(TESTED) {
            if let Some(mut passes) = self.passes(at, &condition.claim)? {
                let orders = if condition.is_ordered { "to the order of the last term" } else { "to leading order" };
                passes.finding.message = format!("the sides agree {orders} as {}", condition.says);
                return Ok(Some(gate::as_it_counts(passes)));
            }
        }
        let words = prose::before(self.checker.notes, origin);
        let lower = sentence.to_lowercase();
        let has_symbols = |side: &Expr| !side.symbols().is_empty();
        // Where the first terms agree and a later one does not, that one may be wrong.
        let is_later = |(condition, ratio): (&Condition, &Option<f64>)| condition.is_ordered && tends_to_one(ratio);
        let later: Vec<bool> = conditions.iter().zip(&ratios).map(is_later).collect();
        // ε ≪ kT ≪ Δ is no limit, and near a resonance formulas agree that differ far from it.
        let is_between = sentence.matches("\\ll").count() + sentence.matches("\\gg").count() > 1;
        let has_named_order = are_named && later.contains(&true);
        if is_between || !has_named_order && self.meet_somewhere(&link)? {
            return Ok(None);
        }
        if ROUGH.iter().any(|word| lower.contains(word)) || !has_symbols(&link.lhs) || !has_symbols(&link.rhs) {
            return Ok(None);
        }
        if later.contains(&true) {
            let mut later = later.into_iter();
            conditions.retain(|_| later.next() == Some(true));
        } else if !are_named {
            // What lacks a symbol may hold where this has a value of its own, such as m/2 for equal masses.
            let symbols = |side: &Expr| {
                let mut all = drawn(&[side], self.checker.model);
                all.sort_unstable_by_key(|id| id.0);
                all
            };
            if symbols(&link.lhs) != symbols(&link.rhs) {
                return Ok(None);
            }
            // The limits in which the ratio is a simple number. If it is one number in all of these, a factor may be wrong.
            let simple: Vec<Option<f64>> = ratios.iter().map(|ratio| ratio.filter(|ratio| is_simple(*ratio))).collect();
            let mut values = ratios.iter().flatten();
            let Some(first) = values.next().copied() else { return Ok(None) };
            if values.any(|value| (value / first - 1.0).abs() > NEAR) {
                return Ok(None);
            }
            let mut simple = simple.into_iter();
            conditions.retain(|_| simple.next().flatten().is_some());
        }
        for condition in conditions.iter().take(SOUGHT) {
            if let Some(mut wrong) = self.slip(at, &condition.claim, &[], &words)? {
                // To an order, both sides may tend to the same number: the finding says at which order they differ.
                if !condition.is_ordered {
                    wrong.finding.message =
                        format!("the ratio of the two sides does not tend to 1 as {}", condition.says);
                }
                return Ok(Some(wrong));
            }
        }
        Ok(None)
    }

    /// The two sides of the only ≈ of a display, if it has no other relation, or only equalities before it: `d = A ≈ B`.
    fn only_approximation(&self, at: usize) -> Option<Link> {
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return None };
        let ([before @ .., lhs, rhs], [equal @ .., (Relation::Approximately, _)]) =
            (statement.members.as_slice(), statement.relations.as_slice())
        else {
            return None;
        };
        // The name that the chain gives a formula, and other forms of this.
        let is_named = before.first().is_none_or(|member| member.as_plain_symbol().is_some());
        if !is_named || !equal.iter().all(|(relation, _)| is_equality(*relation)) {
            return None;
        }
        let mut has_decimals = false;
        for side in [lhs, rhs] {
            side.walk(&mut |part| has_decimals |= matches!(&part.node, Node::Number(digits) if digits.contains('.')));
        }
        if has_decimals || has_units(lhs) || has_units(rhs) || !statement.conditions.is_empty() {
            return None;
        }
        self.checker.link(lhs, Relation::Approximately, rhs).ok()
    }

    /// The limits in which two formulas of the same symbols may be nearly equal, and whether words name them.
    fn conditions(&self, link: &Link, sentence: &str) -> Option<(Vec<Condition>, bool)> {
        let model = self.checker.model;
        let time = model.symbols.find(&Name::plain("t")).map(|(id, _)| id);
        let time = time.filter(|id| matches!(model.meaning(*id), Some(Meaning::Time)));
        let symbols_of = |side: &Expr| {
            let time = time.filter(|_| model.contains_time(side));
            drawn(&[side], model).into_iter().chain(time).collect::<Vec<_>>()
        };
        let (left, right) = (symbols_of(&link.lhs), symbols_of(&link.rhs));
        let contains = |a: &[SymbolId], b: &[SymbolId]| b.iter().all(|id| a.contains(id));
        if !contains(&left, &right) && !contains(&right, &left) {
            return None;
        }
        let mut symbols = if left.len() >= right.len() { left } else { right };
        let is_number = |id: &SymbolId| {
            let entry = model.symbols.entry(*id);
            let is_drawn =
                matches!(model.meaning(*id), Some(Meaning::Constant(_) | Meaning::Varying(_) | Meaning::Time));
            entry.slots.is_empty() && entry.kind == Kind::Scalar && is_drawn && entry.coefficient.is_none()
        };
        if symbols.is_empty() || symbols.len() > MOST || !symbols.iter().all(is_number) {
            return None;
        }
        symbols.sort_unstable_by_key(|id| id.0);
        let named = named(sentence, &symbols, |id| model.name(id));
        let are_named = !named.is_empty();
        let all = || symbols.iter().flat_map(|id| [(*id, true), (*id, false)]).collect();
        let chosen: Vec<(SymbolId, bool)> = if are_named { named } else { all() };
        let positive = symbols.iter().filter(|id| model.range(**id) == Range::Any).map(|id| model.name(*id));
        let assume: Vec<Spanned<String>> =
            positive.map(|name| Spanned::new(format!("{name} > 0"), Span::default())).collect();
        let condition = |(id, is_large): (SymbolId, bool)| {
            let name = model.name(id);
            let sides = [&link.lhs, &link.rhs];
            let order = sides.iter().filter_map(|side| series::order_of_sum(side, id, model)).max();
            let order = order.filter(|_| !is_large);
            let end = if is_large { "\\infty" } else { "0" };
            let mut claim = Claim { assume: assume.clone(), ..Claim::default() };
            match order {
                Some(order) => {
                    claim.small = vec![Spanned::new(name.clone(), Span::default())];
                    claim.order = Some(Spanned::new(order, Span::default()));
                }
                None => claim.limit = Some(Spanned::new(format!("{name} \\to {end}"), Span::default())),
            }
            let says = format!("{} → {}", text::plain(&name), if is_large { "∞" } else { "0" });
            let towards = if is_large { Towards::Infinity } else { Towards::Number(0.0) };
            Condition { claim, says, variable: id, towards, is_ordered: order.is_some() }
        };
        Some((chosen.into_iter().map(condition).collect(), are_named))
    }

    /// Whether the sides are nearly equal where a symbol is nearly another one, 1, or a fraction of a turn.
    fn meet_somewhere(&self, link: &Link) -> Result<bool> {
        let model = self.checker.model;
        let symbols = drawn(&[&link.lhs, &link.rhs], model);
        let span = link.lhs.span;
        let of = |id: SymbolId| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, span);
        let pi = || Expr::new(Node::Pi, span);
        let half = Expr::new(Node::Quotient(Box::new(pi()), Box::new(Expr::integer(2, span))), span);
        let numbers = [Expr::integer(1, span), half, pi()];
        let positive = symbols.iter().filter(|id| model.range(**id) == Range::Any).map(|id| model.name(*id));
        let assume = positive.map(|name| Spanned::new(format!("{name} > 0"), Span::default())).collect();
        let hypotheses = self.quick.hypotheses(&Claim { assume, ..Claim::default() })?;
        let context = self.context(&hypotheses);
        for id in &symbols {
            let others = symbols.iter().filter(|other| *other != id).map(|other| of(*other));
            for place in others.chain(numbers.iter().cloned()) {
                if limit::meet_at(link, *id, &place, (&context, 2))? {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }

    pub(super) fn context<'s>(&'s self, hypotheses: &'s [Hypothesis]) -> Context<'s> {
        Context {
            model: self.checker.model,
            options: Options { points: STATES, ..self.quick.options },
            hypotheses,
            on_shell: Some(false),
            topic: "ratio",
            span: Span::default(),
            spread: Spread::Declared,
            local: &[],
        }
    }

    /// The number that the ratio of the sides tends to, the same at all states.
    fn ratio(&self, link: &Link, condition: &Condition) -> Result<Option<f64>> {
        let checker = &self.quick;
        let hypotheses = checker.hypotheses(&Claim { limit: None, ..condition.claim.clone() })?;
        let context = self.context(&hypotheses);
        let found = limit::ratios(link, condition.variable, condition.towards, (&context, STATES))?;
        let Some(ratios) = found.into_iter().collect::<Option<Vec<f64>>>() else { return Ok(None) };
        let Some(first) = ratios.first().copied().filter(|_| ratios.len() > 1) else { return Ok(None) };
        let is_same = |ratio: &f64| (ratio / first - 1.0).abs() < NEAR;
        Ok(ratios.iter().all(is_same).then_some(first))
    }
}

/// Whether a number is a simple fraction, or one times a power of π, and not 1.
fn is_simple(ratio: f64) -> bool {
    let fractions = |value: f64| {
        (1..=SIMPLE).any(|below| {
            let above = value * f64::from(below);
            (above - above.round()).abs() < NEAR * 0.1 * above.abs()
                && (1.0..=f64::from(SIMPLE)).contains(&above.round())
        })
    };
    let pi = std::f64::consts::PI;
    let is_one = (ratio - 1.0).abs() < NEAR;
    !is_one && [1.0, pi, 1.0 / pi, pi * pi, 1.0 / (pi * pi)].iter().any(|power| fractions((ratio / power).abs()))
}

/// The symbols that a sentence says to be small or large, each with whether it is large.
fn named(sentence: &str, symbols: &[SymbolId], name: impl Fn(SymbolId) -> String) -> Vec<(SymbolId, bool)> {
    let lower = sentence.to_lowercase().split_whitespace().collect::<Vec<_>>().join(" ");
    let mut found: Vec<(SymbolId, bool)> = Vec::new();
    let mut note = |id: SymbolId, is_large: bool| {
        if !found.iter().any(|(known, _)| *known == id) {
            found.push((id, is_large));
        }
    };
    let bare = |text: &str| text.chars().filter(|c| !c.is_whitespace() && !"{}".contains(*c)).collect::<String>();
    let pieces: Vec<&str> = sentence.split('$').collect();
    for (before, formula) in pieces.iter().zip(pieces.iter().skip(1)).step_by(2) {
        for (sign, left_is_large) in [("\\ll", false), ("\\gg", true)] {
            let Some((left, right)) = formula.split_once(sign) else { continue };
            let has = |side: &str, id: SymbolId| has_name(&bare(side), &bare(&name(id)));
            for (side, other, is_large) in [(left, right, left_is_large), (right, left, !left_is_large)] {
                for id in symbols.iter().filter(|id| has(side, **id) && !has(other, **id)) {
                    note(*id, is_large);
                }
            }
        }
        if let Some((left, right)) = formula.split_once("\\to").or_else(|| formula.split_once("\\rightarrow")) {
            for id in symbols.iter().filter(|id| bare(left) == bare(&name(**id))) {
                match bare(right.trim_start_matches("arrow")).as_str() {
                    "0" => note(*id, false),
                    "\\infty" => note(*id, true),
                    _ => {}
                }
            }
        }
        let words = before.to_lowercase();
        let last = words.rsplit([',', '.', ';']).next().unwrap_or_default();
        for id in symbols.iter().filter(|id| bare(formula) == bare(&name(**id))) {
            let says = |words: &[&str]| words.iter().any(|word| last.contains(word));
            match (says(&["small", "low ", "weak", "tiny"]), says(&["large", "high ", "strong", "great"])) {
                (true, false) => note(*id, false),
                (false, true) => note(*id, true),
                _ => {}
            }
        }
    }
    for (words, letters, is_large) in SAID {
        if lower.contains(words)
            && let Some(id) = letters.iter().find_map(|letter| symbols.iter().find(|id| name(**id) == *letter))
        {
            note(*id, is_large);
        }
    }
    found
}

/// Whether a formula contains a name, and not only as a part of another one.
fn has_name(formula: &str, name: &str) -> bool {
    formula.match_indices(name).any(|(at, _)| {
        let (before, after) = (&formula[..at], &formula[at + name.len()..]);
        let in_command = before.rfind('\\').is_some_and(|start| before[start + 1..].chars().all(char::is_alphabetic));
        let goes_on = name.starts_with('\\') && after.starts_with(char::is_alphabetic);
        !in_command && !goes_on && !after.starts_with('_')
    })
}
