//! Numbers that a student computed: right to the digits that are printed, under the conditions that the student stated.

use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::{Reading, names};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::judge::difference;
use crate::check::model::claim::{Hypothesis, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;

use super::given::solved_for;

/// The states in which a rounded number is tried, and the fewest that decide.
const STATES: usize = 8;
const FEWEST: usize = 3;

/// The relative distance of two numbers that are equal.
const EQUAL: f64 = 1e-9;

/// How often formulas are looked through for those that have numbers.
const DEEPEST: usize = 8;

/// What the lines before a line say that symbols are: numbers by conditions, and formulas by true lines.
#[derive(Clone, Debug, Default)]
pub(super) struct Known {
    values: Vec<((SymbolId, u8), Expr)>,
    /// What conditions between constants say that one of them is: V_1 by `\frac{V_1}{V_2} = 10`.
    relations: Vec<((SymbolId, u8), Expr)>,
    /// What they are if nothing else says it: numbers that the problem gives or prints.
    last: Vec<((SymbolId, u8), Expr)>,
    /// The symbols for which a true line gives a number: that is rounded.
    computed: Vec<(SymbolId, u8)>,
    is_any_number: bool,
}

impl Known {
    /// Adds what a reading says that a symbol is, as a condition (a number) or as a true line (any formula).
    pub fn add(&mut self, reading: &Reading, is_condition: bool) {
        for statement in reading.statements.iter().flatten() {
            // The second member is the formula, and what follows may be rounded.
            let [first, last, ..] = statement.members.as_slice() else { continue };
            let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
            let Some((rate, last)) = alone(first, last).filter(|_| is_equal) else { continue };
            let symbols = last.symbols();
            if symbols.iter().any(|(other, _)| *other == rate.0) || is_condition && !symbols.is_empty() {
                continue;
            }
            self.is_any_number |= is_condition;
            if !is_condition && symbols.is_empty() {
                self.computed.push(rate);
            }
            // A condition counts for more than a formula, and the last one for most.
            let at = if is_condition { 0 } else { self.values.len() };
            self.values.insert(at, (rate, last));
        }
    }

    /// Adds a formula for a symbol, which counts for less than those before it.
    pub fn add_formula(&mut self, id: SymbolId, value: Expr) {
        self.values.push(((id, 0), value));
    }

    /// Adds a number for a symbol, for where no formula gives one.
    pub fn add_at_last(&mut self, id: SymbolId, value: Expr) {
        self.last.push(((id, 0), value));
    }

    /// The same with numbers counted only where no formula gives one.
    pub fn with_numbers_last(mut self) -> Known {
        let (numbers, values) = self.values.into_iter().partition(|(_, value)| value.symbols().is_empty());
        (self.values, self.last) = (values, numbers);
        self
    }

    /// Whether any condition gave a number.
    pub fn has_numbers(&self) -> bool {
        self.is_any_number
    }

    /// Whether the numbers that are known give a formula its value.
    pub fn determines(&self, checker: &Checker<'_>, formula: &Expr) -> bool {
        inserted(formula, &self.numbers(checker)).symbols().is_empty()
    }

    /// Adds a condition between constants.
    pub fn add_relation(&mut self, checker: &Checker<'_>, reading: &Reading) {
        let [Ok(statement)] = reading.statements.as_slice() else { return };
        let [first, second] = statement.members.as_slice() else { return };
        let difference = first.clone().minus(second.clone());
        let is_new = |rate: &(SymbolId, u8)| self.relations.iter().all(|(known, _)| known != rate);
        let mut found = difference.symbols().into_iter().filter(is_new);
        if let Some(relation) = found.find_map(|rate| Some((rate, solved_for(checker, &difference, rate)?))) {
            self.is_any_number = true;
            self.relations.push(relation);
        }
    }

    /// The symbols that have numbers by themselves, or by formulas of symbols that have, and what the relations say.
    fn numbers(&self, checker: &Checker<'_>) -> Vec<((SymbolId, u8), Expr)> {
        let mut closed: Vec<((SymbolId, u8), Expr)> = Vec::new();
        let mut with_last = false;
        for _ in 0..2 * DEEPEST {
            let known = closed.len();
            let last = self.last.iter().filter(|_| with_last);
            for (id, value) in self.values.iter().chain(last) {
                if closed.iter().any(|(known, _)| known == id) {
                    continue;
                }
                let value = inserted(&inserted(value, &closed), &self.relations);
                let is_number = match value.symbols().is_empty() {
                    true => true,
                    false => !self.relations.is_empty() && number(checker, &value).is_some(),
                };
                if is_number {
                    closed.push((*id, value));
                }
            }
            if closed.len() == known {
                if with_last {
                    break;
                }
                with_last = true;
            }
        }
        closed.extend(
            self.relations
                .iter()
                .filter(|(id, _)| closed.iter().all(|(known, _)| known != id))
                .cloned()
                .collect::<Vec<_>>(),
        );
        closed
    }

    /// Whether each equality of a reading of `text` holds with the numbers that are known, where a number of at least two
    /// digits stands for all that are rounded to it; `holds` decides those that have other quantities.
    pub fn fits(&self, checker: &Checker<'_>, text: &str, reading: &Reading, holds: impl Fn(&Reading) -> bool) -> bool {
        let is_computed = self.is_any_number || is_arithmetic(reading);
        if !is_computed || reading.statements.is_empty() {
            return false;
        }
        // A student may go on with numbers as they were rounded.
        let rounded = Known { values: self.values.iter().rev().cloned().collect(), ..self.clone() };
        let exact = self.exact();
        let ways = [self, &rounded].into_iter().chain(&exact).flat_map(|known| {
            let own = known.numbers(checker);
            let with = |name: &'static str, values: &'static [&'static str]| {
                values.iter().filter_map(|value| known.with_usual(checker, &own, (name, value))).collect::<Vec<_>>()
            };
            let usual: Vec<_> = with("g", &GRAVITY).into_iter().chain(with("G", &GRAVITATION)).collect();
            std::iter::once(own).chain(usual)
        });
        ways.into_iter().any(|closed| fits_with(checker, (text, reading), &closed, &holds))
    }

    /// The same without the numbers that true lines print for what a formula gives: a student may go on with the exact values, which a
    /// calculator keeps. `None`, if there are none.
    fn exact(&self) -> Option<Known> {
        let has_formula = |rate: &(SymbolId, u8)| {
            self.values.iter().any(|(known, value)| known == rate && !value.symbols().is_empty())
        };
        let is_rounded = |(rate, value): &((SymbolId, u8), Expr)| {
            value.symbols().is_empty() && self.computed.contains(rate) && has_formula(rate)
        };
        let any = self.values.iter().any(is_rounded);
        let values = || self.values.iter().filter(|known| !is_rounded(known)).cloned().collect();
        any.then(|| Known { values: values(), ..self.clone() })
    }

    /// The quantities of which a value is missing, for a reading that gives a formula a number where other quantities have numbers,
    /// or that prints a measured number (`is_measured`).
    pub fn missing(&self, checker: &Checker<'_>, reading: &Reading, is_measured: bool) -> Vec<SymbolId> {
        let closed = self.numbers(checker);
        let closed = self.with_usual(checker, &closed, ("g", GRAVITY[0])).unwrap_or(closed);
        let gives_a_number = |pair: &&[Expr]| pair[1].symbols().is_empty() && !pair[1].is_null();
        let pairs = reading.statements.iter().flatten().flat_map(|statement| statement.members.windows(2));
        let open = pairs.filter(gives_a_number).map(|pair| inserted(&pair[0], &closed));
        let open = open.filter(|formula| number(checker, formula).is_none());
        let mut found: Vec<SymbolId> = open.flat_map(|formula| formula.symbols()).map(|(id, _)| id).collect();
        found.sort_unstable();
        found.dedup();
        if self.is_any_number || is_measured { found } else { Vec::new() }
    }

    /// The same with what further readings say, which counts for more than any formula; the last of them for most.
    pub fn supposing<'r>(&self, readings: impl Iterator<Item = &'r Reading>) -> Known {
        let mut known = Known::default();
        readings.for_each(|reading| known.add(reading, false));
        known.values.reverse();
        let (relations, computed) = (self.relations.clone(), self.computed.clone());
        let all = Known { relations, computed, is_any_number: self.is_any_number, ..known };
        all.or_of_others(self)
    }

    /// The same with formulas for symbols of which nothing is known here.
    pub fn or_of_others(&self, other: &Known) -> Known {
        let is_new = |(id, _): &&((SymbolId, u8), Expr)| self.values.iter().all(|(known, _)| known != id);
        let values = self.values.iter().chain(other.values.iter().filter(is_new)).cloned().collect();
        let last = self.last.iter().chain(other.last.iter().filter(is_new)).cloned().collect();
        Known { values, last, ..self.clone() }
    }

    /// Without values that are numbers, as they were printed.
    pub fn formulas(mut self) -> Known {
        self.values.retain(|(_, value)| !value.symbols().is_empty());
        self.last.clear();
        self
    }

    /// The same with what is known otherwise, which counts for less.
    pub fn or(&self, other: &Known) -> Known {
        Known {
            values: self.values.iter().chain(&other.values).cloned().collect(),
            relations: self.relations.iter().chain(&other.relations).cloned().collect(),
            last: self.last.iter().chain(&other.last).cloned().collect(),
            computed: self.computed.iter().chain(&other.computed).copied().collect(),
            is_any_number: self.is_any_number || other.is_any_number,
        }
    }

    /// The numbers with the usual value of a constant, as standard gravity is for g, if the problem has one that has no value.
    fn with_usual(
        &self,
        checker: &Checker<'_>,
        closed: &[((SymbolId, u8), Expr)],
        (name, value): (&str, &str),
    ) -> Option<Vec<((SymbolId, u8), Expr)>> {
        let (id, _) = checker.model.symbols.find(&names::parse(name)?.0)?;
        let is_constant = matches!(checker.model.meaning(id), Some(Meaning::Constant(_)));
        (is_constant && closed.iter().all(|(rate, _)| *rate != (id, 0))).then(|| {
            let mut known = self.clone();
            known.values.insert(0, ((id, 0), Expr::new(Node::Number(value.to_owned()), Span::default())));
            known.numbers(checker)
        })
    }
}

/// What g is where no line says it, as it is usually rounded.
const GRAVITY: [&str; 3] = ["9.81", "9.8", "10"];

/// What G is where no line says it, as tables round it. Another number may be meant: a line that needs it is never wrong.
const GRAVITATION: [&str; 3] = ["0.00000000006674", "0.0000000000667", "0.000000000066743"];

/// The symbol that a side is, or of which it is a square or a function, and the formula for it.
fn alone(side: &Expr, other: &Expr) -> Option<((SymbolId, u8), Expr)> {
    let by = |inner: &Expr, node: Node| Some(((inner.as_plain_symbol()?, 0), Expr::new(node, other.span)));
    match &side.node {
        Node::Symbol { id, indices, dots } => indices.is_empty().then(|| ((*id, *dots), other.clone())),
        Node::Power(base, power) if power.as_digits() == Some("2") => by(base, Node::Root(2, Box::new(other.clone()))),
        Node::Call(function, inner) => by(inner, Node::Call(function.inverse()?, Box::new(other.clone()))),
        _ => None,
    }
}

/// Whether the equalities of a reading hold with numbers.
fn fits_with(
    checker: &Checker<'_>,
    (text, reading): (&str, &Reading),
    closed: &[((SymbolId, u8), Expr)],
    holds: &impl Fn(&Reading) -> bool,
) -> bool {
    let mut any = false;
    let all = reading.statements.iter().all(|statement| {
        let Ok(statement) = statement else { return false };
        // A chain that ends with a number is right to the digits of that number.
        let last = statement.members.last().filter(|last| last.symbols().is_empty());
        let digits = last.and_then(|last| half_a_digit(text.get(last.span.range())?)).unwrap_or(0.0);
        let is_end = |side: &Expr| last.is_some_and(|last| side.span == last.span);
        statement.members.windows(2).zip(&statement.relations).all(|(pair, relation)| {
            if !is_equality(relation.0) && relation.0 != Relation::Approximately {
                return false;
            }
            let members = pair.to_vec();
            let alone = Statement { members, relations: vec![*relation], ..statement.clone() };
            let alone = || Reading { statements: vec![Ok(alone.clone())], introduced: Vec::new() };
            let sides = [inserted(&pair[0], closed), inserted(&pair[1], closed)];
            let values = [number(checker, &sides[0]), number(checker, &sides[1])];
            let [Some(value), Some(printed)] = values else { return holds(&alone()) };
            // Two formulas that are 0 agree whatever they say.
            if value == 0.0 && printed == 0.0 && !pair[1].is_null() && !pair[0].is_null() {
                return false;
            }
            any = true;
            let off = text.get(pair[1].span.range()).and_then(half_a_digit).unwrap_or(0.0);
            let by_parts: f64 = pair.iter().map(|side| spread(checker, side, closed)).sum();
            let distance = (value - printed).abs();
            let is_formula = !pair[1].symbols().is_empty() && !is_end(&pair[1]);
            distance <= (off + by_parts).max(EQUAL * printed.abs())
                // Values that were put in are rounded; or the formulas agree, and the values are those of a false line.
                || is_formula && (distance <= digits || holds(&alone()))
        })
    });
    any && all
}

/// Whether all members of a reading are numbers.
fn is_arithmetic(reading: &Reading) -> bool {
    let mut members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
    members.all(|member| member.symbols().is_empty())
}

/// How far a product or a sum of numbers may be off since some of them are rounded, as 0.866 is in `3.0 - 0.20 \cdot 0.866`. The data
/// of the problem, and g, are not.
fn spread(checker: &Checker<'_>, formula: &Expr, closed: &[((SymbolId, u8), Expr)]) -> f64 {
    if matches!(formula.node, Node::Number(_)) || !formula.symbols().is_empty() {
        return 0.0;
    }
    let mut rounded: Vec<String> = Vec::new();
    formula.walk(&mut |part| {
        if let Node::Number(digits) = &part.node
            && digits.contains('.')
            && !rounded.contains(digits)
        {
            rounded.push(digits.clone());
        }
        // A term of a sum is a result of its own, and may be rounded to a whole number.
        if let Node::Sum(terms) = &part.node
            && terms.len() > 1
        {
            let whole = terms.iter().filter_map(|term| printed_number(&term.expr)).map(str::to_owned);
            let new: Vec<String> = whole.filter(|digits| !rounded.contains(digits)).collect();
            rounded.extend(new);
        }
    });
    let gravity = GRAVITY.iter().filter_map(|digits| digits.parse::<f64>().ok());
    let data =
        closed.iter().filter(|(_, value)| value.symbols().is_empty()).filter_map(|(_, value)| number(checker, value));
    let exact: Vec<f64> = gravity.chain(data).collect();
    let whole = number(checker, formula);
    let offs = rounded.iter().filter_map(|digits| {
        let (value, half) = (digits.parse::<f64>().ok()?, half_a_digit(digits)?);
        if exact.iter().any(|known| (known - value).abs() <= EQUAL * value.abs()) {
            return None;
        }
        let mut moved = formula.clone();
        moved.substitute(&|node| match node {
            Node::Number(found) if found == digits => {
                Some(Expr::new(Node::Number(format!("{}", value + half)), formula.span))
            }
            _ => None,
        });
        Some((number(checker, &moved)? - whole?).abs())
    });
    offs.sum()
}

/// The digits of a formula that is a number, or a number with its unit: `382 \cdot 1000`.
fn printed_number(formula: &Expr) -> Option<&str> {
    let is_power_of_ten = |factor: &Expr| match &factor.node {
        Node::Number(digits) => digits.trim_start_matches('1').chars().all(|c| c == '0') && digits.starts_with('1'),
        Node::Power(base, _) => matches!(base.as_digits(), Some("10" | "60")),
        _ => false,
    };
    match &formula.node {
        Node::Number(digits) => Some(digits),
        Node::Product(factors) => {
            let (first, unit) = factors.split_first()?;
            unit.iter().all(is_power_of_ten).then(|| first.as_digits()).flatten()
        }
        _ => None,
    }
}

/// Whether a formula is a rounded decimal times letters: `0.382 \frac km`. The letters have no other numbers beside them but small
/// powers.
pub(super) fn is_decimal_multiple(formula: &Expr) -> bool {
    let is_rounded = |factor: &Expr| matches!(&factor.node, Node::Number(digits) if digits.contains('.') && half_a_digit(digits).is_some());
    let above = match &formula.node {
        Node::Quotient(above, _) => above,
        _ => formula,
    };
    let Node::Product(factors) = &above.node else { return false };
    factors.iter().filter(|factor| is_rounded(factor)).count() == 1
        && factors.iter().filter(|factor| factor.symbols().is_empty()).count() == 1
}

/// Whether the two sides of a link with ≈ agree to the digits that are printed on its right side, in states that obey
/// hypotheses: `t_h = R C \ln 2 \approx 0.69 \, R C`. `text` is that side; `None`, if it has no number of two digits or more.
pub(super) fn agrees(checker: &Checker<'_>, text: &str, pair: &[Expr], hypotheses: &[Hypothesis]) -> Option<bool> {
    let starts = text.char_indices().filter(|(at, c)| {
        c.is_ascii_digit() && !text[..*at].ends_with(|before: char| before.is_ascii_digit() || ".^_{".contains(before))
    });
    let off = starts
        .filter_map(|(at, _)| {
            let length = text[at..].find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len() - at);
            let number = text[at..at + length].trim_end_matches('.');
            let value = number.parse::<f64>().ok().filter(|value| *value > 0.0)?;
            number.contains('.').then_some(half_a_digit(number)? / value)
        })
        .reduce(f64::max)?;
    let context = Context {
        model: checker.model,
        options: checker.options,
        hypotheses,
        on_shell: None,
        topic: "a rounded number",
        span: Span::default(),
        spread: Spread::Declared,
        local: &[],
    };
    let mode = context.mode(checker.model.has_motion(), &[&pair[0], &pair[1]]);
    let ensemble = context.ensemble(mode, false, STATES).ok()?;
    let near = ensemble.states.iter().filter_map(|state| {
        let (a, b) = (difference::value(&pair[0], state)?.value, difference::value(&pair[1], state)?.value);
        Some((a - b).abs() <= off * b.abs())
    });
    let near: Vec<bool> = near.collect();
    (near.len() >= FEWEST).then(|| near.into_iter().all(|is_near| is_near))
}

/// A formula with numbers in the place of symbols.
fn inserted(formula: &Expr, numbers: &[((SymbolId, u8), Expr)]) -> Expr {
    let mut formula = formula.clone();
    formula.substitute(&|node| match node {
        Node::Symbol { id, dots, .. } => {
            numbers.iter().find(|(known, _)| *known == (*id, *dots)).map(|(_, value)| value.clone())
        }
        _ => None,
    });
    formula
}

/// The value of a formula that has the same one whatever its symbols are: without symbols, or where they cancel.
fn number(checker: &Checker<'_>, formula: &Expr) -> Option<f64> {
    let states = if formula.symbols().is_empty() { 1 } else { FEWEST };
    let context = Context {
        model: checker.model,
        options: checker.options,
        hypotheses: &[],
        on_shell: Some(false),
        topic: "a number",
        span: Span::default(),
        spread: Spread::Declared,
        local: &[],
    };
    let ensemble = context.ensemble(context.mode(false, &[formula]), false, states).ok()?;
    let values = ensemble.states.iter().map(|state| Some(difference::value(formula, state)?.value));
    let values: Vec<f64> = values.collect::<Option<_>>()?;
    let first = *values.first().filter(|_| values.len() >= states)?;
    values.iter().all(|value| (value - first).abs() <= EQUAL * first.abs()).then_some(first)
}

/// Half a unit of the last digit of a printed number, if it has two digits or more: 0.05 for `57.7`, 50 for `1.2 \cdot 10^3`,
/// half a degree for `\frac{47 \pi}{180}`. Further factors are those of its unit.
fn half_a_digit(text: &str) -> Option<f64> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let text = text.trim_start_matches(['-', '+']).replace("\\times", "\\cdot");
    let degrees = text.strip_prefix("\\frac{").and_then(|rest| rest.strip_suffix("\\pi}{180}"));
    let mut factors = degrees.unwrap_or(&text).split("\\cdot");
    let digits = factors.next()?;
    let mut scale = if degrees.is_some() { std::f64::consts::PI / 180.0 } else { 1.0 };
    for factor in factors {
        let (base, power) = factor.split_once('^').unwrap_or((factor, "1"));
        let power = power.trim_matches(['{', '}']).parse::<i32>().ok()?;
        scale *= base.parse::<f64>().ok()?.powi(power.clamp(-300, 300));
    }
    let significant = digits.trim_start_matches(['0', '.']).chars().filter(char::is_ascii_digit).count();
    let is_number = digits.chars().all(|c| c.is_ascii_digit() || c == '.') && digits.matches('.').count() <= 1;
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    // Zeros at the end of a whole number are no digits: 2740 may be 2738, where two digits are left.
    let zeros = if digits.contains('.') { 0 } else { digits.len() - digits.trim_end_matches('0').len() };
    let zeros = if significant > zeros + 1 { zeros } else { 0 };
    let power = i32::try_from(zeros).unwrap_or(0) - i32::try_from(decimals).unwrap_or(0);
    (is_number && significant > 1).then(|| 0.5 * scale * 10f64.powi(power) * (1.0 + EQUAL))
}

#[cfg(test)]
mod tests {
    use super::half_a_digit;

    #[test]
    fn the_last_digit_says_how_far_a_number_may_be_off() {
        let near = |text: &str, value: f64| half_a_digit(text).is_some_and(|off| (off - value).abs() < 1e-6 * value);
        assert!(near("57.7", 0.05) && near("- 0.289", 0.0005) && near("24", 0.5));
        assert!(near(r"1.2 \cdot 10^{3}", 50.0) && near(r"938 \cdot 1.6 \cdot 10^{-13}", 8e-14));
        assert!(near(r"\frac{47 \pi}{180}", std::f64::consts::PI / 360.0));
        assert!(near("2740", 5.0) && near("442000", 500.0) && near("27.40", 0.005) && near("300", 0.5));
        // The twins: one digit is exact, and a formula is no number.
        assert!(half_a_digit("2").is_none() && half_a_digit("0.5").is_none() && half_a_digit("2 g").is_none());
        assert!(half_a_digit(r"47 \cdot g").is_none());
    }
}
