//! Functions such as `\sin`, and the end of an argument without parentheses.

mod letters;
mod periods;
mod written_out;

use crate::formula::symbols::Name;
use crate::formula::text;
use crate::formula::tree::{Expr, Function, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Delimiter, Item, Layout};
use super::super::lexer::Space;
use super::super::names::{self, Printed};
use super::algebra::operator_word;
use super::items::{Joint, differential, function_head, is_number, is_numeric, is_numeric_item, joint};
use super::state::{Read, Reader};
use super::structure::is_function_letter;
use letters::{
    is_counted, is_direction, is_letter_of_an_angle, is_no_frequency, is_pi, is_usual_angle, is_whole_argument,
    is_whole_number,
};
pub(super) use written_out::written_out;

/// The items that could be the argument of a function.
struct Run {
    /// One past the last of them.
    end: usize,
    /// The count of numbers before the symbols.
    numbers: usize,
    /// The symbols among them, and whether each is an angle.
    symbols: Vec<(bool, Name)>,
    /// Whether it is a single fraction or root.
    stands_alone: bool,
    /// Whether it ends with a rate.
    is_rate: bool,
    /// Whether the function is hyperbolic, so that its argument contains no angle.
    is_hyperbolic: bool,
    /// Whether π stands behind a whole number, `n\pi`.
    has_turns: bool,
}

impl Run {
    fn has_angle(&self) -> bool {
        self.symbols.iter().any(|(is_angle, _)| *is_angle)
    }
}

impl Reader<'_> {
    /// A function with its argument.
    pub(super) fn call(
        &mut self,
        function: Function,
        power: Option<&Item>,
        head: Span,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<(Expr, bool)> {
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(Space::Thin))) {
            *cursor += 1;
        }
        let Some(first) = items.get(*cursor) else {
            let name = function.name();
            return Err(
                Fault::new(head, format!("\\{name} needs an argument")).help(format!("write one, as in \\{name} x"))
            );
        };
        let (argument, enclosed) = match &first.layout {
            Layout::Fence(..) | Layout::Group(_) => {
                *cursor += 1;
                let is_exponent = function == Function::Exp;
                (if is_exponent { self.exponent_of_e(first)? } else { self.item(first)? }, true)
            }
            // `\ln \langle x \rangle_0`: nobody takes a logarithm in a state, so the place below belongs to the mean value.
            Layout::Scripts { nucleus, sup: None, primes: 0, .. }
                if matches!(nucleus.layout, Layout::Fence(Delimiter::Angle, _)) =>
            {
                *cursor += 1;
                (self.item(first)?, true)
            }
            Layout::Scripts { nucleus, .. } if matches!(nucleus.layout, Layout::Fence(..) | Layout::Group(_)) => {
                let name = function.name();
                return Err(Fault::ambiguous(
                    head.to(first.span),
                    format!("\\{name}(x)^2 may be (\\{name}(x))^2 or \\{name}(x^2)"),
                )
                .help(format!("write \\{}^2(…), or put the power inside of the parentheses", function.name())));
            }
            _ => (self.run_on(function, head, items, cursor)?, false),
        };
        let span = head.to(argument.span);
        let call = Expr::new(Node::Call(function, Box::new(argument)), span);
        match power {
            Some(power) => {
                let exponent = self.item(power)?;
                Ok((Expr::new(Node::Power(Box::new(call), Box::new(exponent)), span), enclosed))
            }
            None => Ok((call, enclosed)),
        }
    }

    /// The argument of a function without parentheses: the following items that can only belong to it.
    fn run_on(&mut self, function: Function, head: Span, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let start = *cursor;
        // `\ln\det A`, `\ln\mathrm{Tr}\,e^{-\beta H}`: the argument is what the inner operator acts on, and the operator.
        if items
            .get(start)
            .and_then(operator_word)
            .is_some_and(|word| ["det", "tr", "Tr", "trace"].contains(&word.as_str()))
        {
            let (argument, _) = self.factor(items, cursor)?;
            return Ok(argument);
        }
        if let Some(argument) = self.inner_call(function, items, cursor)? {
            return Ok(argument);
        }
        let run = self.gather(function, head, items, start)?;
        if run.end == start {
            return Err(match items.get(start) {
                Some(Item { layout: Layout::Fault(fault), .. }) => fault.clone(),
                item => {
                    let what = format!("the argument of \\{} is missing", function.name());
                    Fault::new(item.map_or(head, |item| item.span), what).help("write the argument after the function")
                }
            });
        }
        let logarithm = function == Function::Ln && run.numbers > 0 && !run.symbols.is_empty();
        if logarithm || !self.is_settled(&run, items, start)? {
            let span = head.to(items[run.end.min(items.len() - 1)].span);
            let shown = function.name();
            let help = match !run.has_angle() && self.time_follows(items, run.end) || self.rate_goes_on(&run, items) {
                true => format!("put the argument in parentheses, \\{shown}(…)"),
                false => format!("put the argument in parentheses, \\{shown}(…), or end it with a thin space \\,"),
            };
            return Err(Fault::ambiguous(span, self.readings(function, &items[start..], run.end - start)).help(help));
        }
        *cursor = run.end + periods::length(&items[start..run.end], &items[run.end..]).unwrap_or(0);
        self.term(&items[start..*cursor])
    }

    /// `\ln\cosh x`: the argument is the value of another function. `\ln\sin x\cos x` may end in two places.
    fn inner_call(&mut self, function: Function, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let Some(Ok(Some((inner, _)))) = items.get(*cursor).map(function_head) else { return Ok(None) };
        let (argument, _) = self.factor(items, cursor)?;
        let ends = |item: &Item| matches!(item.layout, Layout::Space(_)) || joint(item).is_some();
        match items.get(*cursor) {
            Some(next) if !ends(next) => {
                let (outer, inner) = (function.name(), inner.name());
                let what = format!("the argument of \\{outer} may end with that of \\{inner}, or later");
                Err(Fault::ambiguous(argument.span.to(next.span), what)
                    .help(format!("put the argument in parentheses, \\{outer}(…)")))
            }
            _ => Ok(Some(argument)),
        }
    }

    /// What an argument that may end after `end` items, or with one item more or less, can mean.
    fn readings(&mut self, function: Function, items: &[Item], end: usize) -> String {
        let name = function.name();
        let is_factor = |item: &Item| is_number(item) || names::printed(item, self.branch).is_some();
        let long = if items.get(end).is_some_and(is_factor) { end + 1 } else { end };
        // What is read for a message adds no symbols.
        let known = self.symbols.clone();
        let mut said = |items: &[Item]| self.term(items).ok().map(|read| text::formula(&read, self.symbols));
        let parts = items[..long]
            .split_last()
            .map(|(last, short)| (said(short), said(std::slice::from_ref(last)), said(&items[..long])));
        *self.symbols = known;
        match parts {
            Some((Some(short), Some(last), Some(long))) if !short.is_empty() => {
                format!("the argument of \\{name} may end in two places: {name}({short})·{last} or {name}({long})")
            }
            _ => format!("\\{name} x y may be {name}(x)·y or {name}(x·y)"),
        }
    }

    /// Numbers, then symbols up to the first angle or dotted symbol; or a single fraction or root.
    fn gather(&self, function: Function, head: Span, items: &[Item], start: usize) -> Read<Run> {
        let is_hyperbolic = matches!(function, Function::Sinh | Function::Cosh | Function::Tanh);
        let mut run = Run {
            end: start,
            numbers: 0,
            symbols: Vec::new(),
            stands_alone: false,
            is_rate: false,
            is_hyperbolic,
            has_turns: false,
        };
        while let Some(item) = items.get(run.end) {
            if self.is_leading_number(item, run.end == start) {
                // `\sin n\pi x`: a whole number of half turns.
                if is_pi(item) && !run.has_turns && matches!(run.symbols.as_slice(), [(_, n)] if is_whole_number(n)) {
                    (run.has_turns, run.end) = (true, run.end + 1);
                    continue;
                }
                if !run.symbols.is_empty() {
                    break;
                }
                run.numbers += 1;
                run.end += 1;
                if matches!(item.layout, Layout::Fraction(..) | Layout::Root(..)) && !is_numeric_item(item) {
                    run.stands_alone = true;
                    if let Some(end) = self.time_after_a_root(items, run.end - 1) {
                        (run.stands_alone, run.end) = (false, end);
                        run.symbols.push((true, Name::plain("t")));
                    }
                    break;
                }
                continue;
            }
            let Some(mut printed) = names::printed(item, self.branch) else { break };
            // `\sin\theta\,\mathrm d\phi`: no argument ends with a differential.
            if !run.symbols.is_empty() && self.starts_a_differential(items, run.end) {
                break;
            }
            // `\cos\theta\,\mathbf{e}_x`: no argument has a vector as its last factor.
            let has_dot = items.get(run.end + 1).and_then(joint).is_some();
            if !run.symbols.is_empty() && is_direction(&printed.name) && !has_dot {
                break;
            }
            // `\cos\Delta\theta`: Δ and its letter are one symbol.
            if let Some(difference) = self.difference(item, items.get(run.end + 1)) {
                printed = difference;
                run.end += 1;
            }
            if printed.dots > 0 && run.end > start {
                break;
            }
            // `\sin\theta e^{i\phi}`: the exponential is a factor.
            if printed.sup.is_some() && printed.name.base == "e" && !run.symbols.is_empty() && self.symbols.open {
                break;
            }
            if printed.sup.is_some() {
                // After an angle the argument is over; before that, the power could be of the symbol or the function.
                if run.end == start || run.symbols.is_empty() && run.numbers > 0 || !run.has_angle() {
                    let name = function.name();
                    return Err(Fault::ambiguous(
                        head.to(item.span),
                        format!("\\{name} x^2 may be (\\{name} x)^2 or \\{name}(x^2)"),
                    )
                    .help(format!("write \\{}^2(x) for the power of the function, or \\{0}(x^2)", function.name())));
                }
                break;
            }
            // `\sin\delta_l P_l(\cos\theta)`: a function with its argument is a factor.
            if !run.symbols.is_empty()
                && self.symbols.open
                && let Some(Item { layout: Layout::Fence(Delimiter::Round, inside), .. }) = items.get(run.end + 1)
                && !printed.name.subscript.is_empty()
                && is_function_letter(&printed.name, inside)
            {
                break;
            }
            let entry = self.symbols.find(&printed.name).map(|(id, _)| self.symbols.entry(id));
            let (angle, varies) = entry.map_or((false, false), |entry| (entry.angle, entry.varies));
            // `v_0\cos\theta\,t`: without declarations a usual angle before a thin space ends the argument.
            let is_usual = self.symbols.open
                && is_letter_of_an_angle(&printed.name)
                && matches!(items.get(run.end + 1), Some(Item { layout: Layout::Space(_), .. }));
            let is_angle = (angle || is_usual) && printed.dots == 0;
            run.symbols.push((is_angle, printed.name));
            run.is_rate = printed.dots > 0;
            run.end += 1;
            if varies && items.get(run.end).is_some_and(|item| self.is_time_in_parentheses(item)) {
                run.end += 1;
            }
            if self.is_value_of_a_function(&run, items, start) {
                run.end += 1;
                break;
            }
            if printed.dots > 0 || is_angle {
                break;
            }
        }
        // `\ln N!`: nobody means the factorial of a logarithm.
        while !run.symbols.is_empty() && items.get(run.end).is_some_and(|item| item.layout == Layout::Other('!')) {
            run.end += 1;
            run.stands_alone = true;
        }
        // `\sin\tfrac12(\pi - \chi)`: a number before a parenthesis is a factor of what is in it.
        let is_circular = matches!(function, Function::Sin | Function::Cos | Function::Tan);
        let is_sum = |item: &Item| match &item.layout {
            Layout::Fence(Delimiter::Round | Delimiter::Square, inside) => {
                inside.iter().skip(1).any(|item| matches!(item.layout, Layout::Other('+' | '-')))
            }
            _ => false,
        };
        let is_factor =
            items.get(run.end).is_some_and(|next| is_sum(next) && !is_whole_argument(&items[start..run.end], next));
        if is_circular && run.numbers > 0 && run.symbols.is_empty() && is_factor {
            run.end += 1;
            run.stands_alone = true;
        }
        Ok(run)
    }

    /// Whether all there is of an argument is a function of letters with its parenthesis, and the term ends behind it or a sign
    /// or a space stands there: `\ln p(x)`.
    fn is_value_of_a_function(&self, run: &Run, items: &[Item], start: usize) -> bool {
        let [(_, name)] = run.symbols.as_slice() else { return false };
        let is_call = matches!(items.get(run.end).map(|item| &item.layout), Some(Layout::Fence(Delimiter::Round, _)));
        let ends = |item: &Item| {
            matches!(item.layout, Layout::Space(_) | Layout::Other('+' | '-')) || joint(item) == Some(Joint::CDot)
        };
        self.symbols.open
            && is_call
            && run.end == start + 1
            && self.is_inferred_function(name)
            && items.get(run.end + 1).is_none_or(ends)
    }

    /// Whether a differential begins here: an upright d before a name, or an italic one where d is no factor.
    fn starts_a_differential(&self, items: &[Item], at: usize) -> bool {
        let is_d = |item: &Item| {
            let is_upright = matches!(item.layout, Layout::Style(..));
            differential(item) == Some(1)
                && (is_upright || self.symbols.infers() && !self.symbols.inferred.has_factor_d)
        };
        let is_named = |item: &Item| names::printed(item, self.branch).is_some();
        items.get(at).is_some_and(is_d) && items.get(at + 1).is_some_and(is_named)
    }

    /// The symbol that Δ and the letter after it are, where Δ is no quantity of its own.
    fn difference<'i>(&self, mark: &Item, next: Option<&'i Item>) -> Option<Printed<'i>> {
        let is_difference = mark.layout == Layout::Command("\\Delta".to_owned());
        let is_alone =
            self.symbols.inferred.has_difference_alone || self.symbols.find(&Name::plain("\\Delta")).is_some();
        let mut printed = names::printed(next.filter(|_| is_difference && !is_alone)?, self.branch)?;
        printed.name.base = format!("\\Delta {}", printed.name.base);
        Some(printed)
    }

    fn is_leading_number(&self, item: &Item, is_first: bool) -> bool {
        match &item.layout {
            Layout::Number(_) => true,
            Layout::Fraction(a, b) => is_first || is_numeric(a) && is_numeric(b),
            Layout::Root(..) => is_first,
            Layout::Command(name) => name == "\\pi" && self.symbols.find(&Name::plain("\\pi")).is_none(),
            _ => false,
        }
    }

    /// Whether this run of items is the only possible argument.
    fn is_settled(&self, run: &Run, items: &[Item], start: usize) -> Read<bool> {
        let sure = match run.symbols.as_slice() {
            [] | [_] | [.., (true, _)] => true,
            // Whatever stands before the time is a factor of it, cos vt, sin nωt; but an angle may end the argument.
            [.., (_, last)] if Some(last) == self.symbols.time.as_ref() => {
                let is_angle = matches!(run.symbols.as_slice(), [(_, first), _] if is_no_frequency(first));
                !(is_angle && (self.symbols.open || self.symbols.guessed))
            }
            [(_, first), (_, second)] => {
                let base = first.base.as_str();
                // A rate times the time, and a wave number times a place.
                let bare = base.split_once('{').map_or(base, |(accent, inner)| match accent {
                    "\\bar" | "\\tilde" => inner.trim_end_matches('}'),
                    _ => base,
                });
                let is_rate =
                    ["\\omega", "\\Omega", "\\nu", "\\gamma", "\\lambda", "\\beta", "\\delta"].contains(&bare);
                let is_place = ["x", "y", "z", "r"].contains(&second.base.as_str()) && second.subscript.is_empty();
                // So is any letter before an instant in a hyperbolic function: cosh αt_1.
                // So is a declared constant that is no letter of an angle, before a coordinate: tan βx.
                let is_number = |name: &Name| {
                    let entry = self.symbols.find(name).map(|(id, _)| self.symbols.entry(id));
                    !self.symbols.open && entry.is_some_and(|entry| !entry.varies && entry.definition.is_none())
                };
                let moves = || self.symbols.find(second).is_some_and(|(id, _)| self.symbols.entry(id).varies);
                let scales = || is_place && is_number(first) && !is_usual_angle(first) && moves();
                (is_rate || run.is_hyperbolic) && self.is_instant(second)
                    || is_whole_number(first) && is_counted(second)
                    || ["k", "q", "\\kappa"].contains(&base) && is_place
                    || scales()
                    || run.is_hyperbolic && Self::ends_the_term(items, run.end)
            }
            _ => run.is_hyperbolic && Self::ends_the_term(items, run.end),
        };
        let next = items.get(run.end);
        let parenthesis = match next.map(|item| &item.layout) {
            Some(Layout::Fence(..)) => true,
            Some(Layout::Scripts { .. }) => next.is_some_and(|item| names::printed(item, self.branch).is_none()),
            _ => false,
        };
        // `\sin 2 \cdot \theta`, `\sin\omega\cdot t`: the dot may stand inside of the argument.
        let is_bare_number = run.symbols.is_empty() && !run.stands_alone && !is_numeric_item(&items[start]);
        let dot_follows = next.is_some_and(|item| matches!(joint(item), Some(Joint::CDot | Joint::Times)));
        // `v\cos\theta\cdot t`: an angle that is no frequency has no time as a factor.
        let ends_with_an_angle = matches!(run.symbols.as_slice(), [(_, only)] if is_no_frequency(only));
        let before_time = !run.has_angle() && !ends_with_an_angle && self.is_time(items.get(run.end + 1));
        let multiplied = dot_follows && (is_bare_number || before_time);
        let number_follows = !run.symbols.is_empty()
            && !run.has_angle()
            && next.is_some_and(|item| is_number(item) || self.is_leading_number(item, false));
        let could_go_on = multiplied
            || number_follows
            || parenthesis
                && !run.has_angle()
                && !self.ends_before(run, &items[run.end])
                && function_head(&items[run.end])?.is_none()
            || run.stands_alone && self.goes_on(items, run.end)
            || !run.has_angle() && self.time_follows(items, run.end)
            || self.rate_goes_on(run, items);
        Ok(sure && !could_go_on)
    }

    /// Whether a parenthesis after one angle is a factor, `\cos\theta(1 + \cos\theta)`, and no argument of the angle.
    fn ends_before(&self, run: &Run, next: &Item) -> bool {
        let [(_, name)] = run.symbols.as_slice() else { return false };
        let is_usual =
            ["\\theta", "\\phi", "\\varphi", "\\vartheta", "\\alpha", "\\beta"].contains(&name.base.as_str());
        let fence = if let Layout::Scripts { nucleus, .. } = &next.layout { nucleus } else { next };
        let Layout::Fence(delimiter, inside) = &fence.layout else { return false };
        let has_function = inside.iter().any(|item| matches!(function_head(item), Ok(Some(_))));
        let starts_with_number = inside.first().is_some_and(|item| matches!(item.layout, Layout::Number(_)));
        let is_sum = inside.iter().skip(1).any(|item| matches!(item.layout, Layout::Other('+' | '-')));
        let is_factor = *delimiter == Delimiter::Square || is_sum && starts_with_number && has_function;
        self.symbols.open && is_usual && !self.is_inferred_function(name) && is_factor
    }

    /// Whether a symbol follows a dotted symbol, as in `\cos\dot\phi t`.
    fn rate_goes_on(&self, run: &Run, items: &[Item]) -> bool {
        let next = items.get(run.end).and_then(|item| names::printed(item, self.branch));
        run.is_rate && next.is_some_and(|printed| printed.dots == 0)
    }

    /// Whether a symbol without a dot, or a number, follows.
    fn goes_on(&self, items: &[Item], at: usize) -> bool {
        items.get(at).is_some_and(|item| {
            is_number(item)
                || matches!(item.layout, Layout::Fraction(..) | Layout::Root(..))
                || names::printed(item, self.branch).is_some_and(|printed| printed.dots == 0)
        })
    }

    /// Whether `\,t` follows, as in `\cos\omega\,t`.
    fn time_follows(&self, items: &[Item], at: usize) -> bool {
        let space = items.get(at).is_some_and(|item| matches!(item.layout, Layout::Space(Space::Thin)));
        space && self.is_time(items.get(at + 1))
    }

    /// Whether a name is the time, or with a subscript an instant: `\omega t_1`.
    fn is_instant(&self, name: &Name) -> bool {
        self.symbols
            .time
            .as_ref()
            .is_some_and(|time| Name { subscript: time.subscript.clone(), ..name.clone() } == *time)
    }

    /// Whether the term ends here: a hyperbolic function has no angle after which a factor could stand.
    fn ends_the_term(items: &[Item], at: usize) -> bool {
        items.iter().skip(at).all(|item| matches!(item.layout, Layout::Space(Space::Thin)))
    }

    /// Whether an item is the time.
    fn is_time(&self, item: Option<&Item>) -> bool {
        let name = item.and_then(|item| names::printed(item, self.branch)).map(|printed| printed.name);
        name.is_some() && name == self.symbols.time
    }

    /// Whether an item is the time in parentheses, `(t)`, which may follow a symbol that varies.
    pub(super) fn is_time_in_parentheses(&self, item: &Item) -> bool {
        let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
        let [only] = inside.as_slice() else { return false };
        let printed = names::printed(only, None).filter(|printed| printed.dots == 0 && printed.sup.is_none());
        printed.map(|printed| printed.name) == self.symbols.time
    }
}
