//! Sums, the terms of a sum, and single factors.

use crate::code::Code;
use crate::formula::tree::{Expr, Node, Sign, Term};
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout, contents, typed};
use super::super::names;
use super::functions::written_out;
use super::items::{
    Joint, extent, function_head, is_any_integral, is_big_product, is_big_sum, is_integral, is_limit, is_numeric_item,
    joint, log_base,
};
use super::state::{Read, Reader};
use super::undeclared::follows_a_sum;
use super::words::{are_no_words, is_power_in_a_program, run_of_letters};

impl Reader<'_> {
    /// A sum of terms with signs; all of `items`. `end` is the place of a fault if there are no items.
    pub fn sum(&mut self, items: &[Item], end: Span) -> Read<Expr> {
        let whole = extent(items).unwrap_or(end);
        are_no_words(items, self.symbols)?;
        if self.symbols.open || self.symbols.guessed {
            is_no_italic_unit(items)?;
            is_no_spelled_unit(items)?;
        }
        if self.symbols.open {
            is_no_computer_notation(items)?;
            is_no_error_of_measurement(items)?;
            is_no_range(items)?;
        }
        if self.is_abstract()
            && let Some(found) = self.infix(items, whole)?
        {
            return Ok(found);
        }
        if self.is_abstract()
            && let Some(found) = self.unit_of(items)?
        {
            return Ok(found);
        }
        if self.is_abstract()
            && let Some(found) = self.extremum(items, whole)?
        {
            return Ok(found);
        }
        if self.symbols.open {
            self.is_no_lost_index(items)?;
        }
        let mut terms: Vec<Term> = Vec::new();
        let mut at = 0;
        let mut pending: Option<(Sign, Span)> = None;
        while at < items.len() {
            if let Some(sign) = self.sign(&items[at])? {
                if let Some((before, first)) = pending {
                    // `a + -b` with a space; `+-` is ± as often.
                    if (before, sign) == (Sign::Plus, Sign::Minus)
                        && first.end < items[at].span.start
                        && !terms.is_empty()
                    {
                        pending = Some((sign, items[at].span));
                        at += 1;
                        continue;
                    }
                    return Err(Fault::new(first.to(items[at].span), "two signs stand side by side")
                        .help("write one sign, or put the signed term in parentheses"));
                }
                pending = Some((sign, items[at].span));
                at += 1;
                continue;
            }
            let length = self.term_length(&items[at..])?;
            let slice = &items[at..at + length];
            at += length;
            if slice.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
                continue;
            }
            if pending.is_none() && !terms.is_empty() {
                return Err(Fault::new(slice[0].span, "a + or − is missing before this term").help("write the sign"));
            }
            let (sign, sign_span) = pending.take().map_or((Sign::Plus, None), |(sign, span)| (sign, Some(span)));
            terms.push(Term { sign, sign_span, expr: self.term(slice)? });
        }
        if let Some((_, span)) = pending {
            let sign = items.iter().filter(|item| item.span == span).cloned().collect::<Vec<_>>();
            let sign = typed(&sign);
            return Err(Fault::new(span, format!("a term is missing after this {sign}"))
                .help(format!("write the term, or remove the {sign}")));
        }
        if terms.len() > 1
            && let Some(dots) = dots_after_a_factor(items)
        {
            let what = "these dots may stand for further factors or for further terms";
            return Err(Fault::ambiguous(dots, what).help("write + \\dots for terms that are left out"));
        }
        match terms.len() {
            0 => Err(Fault::new(whole, "a formula is missing here").help("write a formula at this place")),
            1 if terms[0].sign == Sign::Plus => Ok(terms.remove(0).expr),
            _ => Ok(Expr::new(Node::Sum(terms), whole)),
        }
    }

    fn sign(&self, item: &Item) -> Read<Option<Sign>> {
        Ok(match &item.layout {
            Layout::Other('+') => Some(Sign::Plus),
            Layout::Other('-') => Some(Sign::Minus),
            Layout::Command(name) if name == "\\pm" || name == "\\mp" => {
                let upper = self.branch.ok_or_else(|| {
                    Fault::unsupported(item.span, "± stands for two formulas, and only one is allowed here")
                        .help("write + or −")
                })?;
                Some(if name == "\\pm" { upper } else { upper.flipped() })
            }
            _ => None,
        })
    }

    /// The number of items of the term that starts here: up to a sign that follows no operator.
    fn term_length(&self, items: &[Item]) -> Read<usize> {
        if let Some(integral) = self.integral_length(items).or_else(|| self.definite_length(items)) {
            return Ok(integral.max(integral + self.term_length(items.get(integral..).unwrap_or_default())?));
        }
        self.is_no_open_integrand(items)?;
        let mut after_operator = false;
        for (at, item) in items.iter().enumerate() {
            // `\sum_x -p \log p`: the sign is that of what is summed.
            if self.symbols.infers() && follows_a_sum(items, at) {
                continue;
            }
            if self.sign(item)?.is_some() {
                if after_operator {
                    return Err(Fault::new(item.span, "a sign directly follows the sign of a product or quotient")
                        .help("put the signed factor in parentheses"));
                }
                return Ok(at);
            }
            if !matches!(item.layout, Layout::Space(_)) {
                after_operator = joint(item).is_some();
            }
        }
        Ok(items.len())
    }

    /// One factor. The flag is false for a function whose argument has no parentheses.
    pub(super) fn factor(&mut self, items: &[Item], cursor: &mut usize) -> Read<(Expr, bool)> {
        const DEEPEST: usize = 256;
        if self.depth >= DEEPEST {
            let message = format!("functions are nested more than {DEEPEST} levels deep");
            return Err(Fault::new(items[*cursor].span, message)
                .code(Code::TooLarge)
                .help("split the formula into several equations"));
        }
        self.depth += 1;
        let found = self.factor_inside(items, cursor);
        self.depth -= 1;
        found
    }

    fn factor_inside(&mut self, items: &[Item], cursor: &mut usize) -> Read<(Expr, bool)> {
        let item = &items[*cursor];
        if let Some(found) = self.raised_operator(items, cursor)? {
            return Ok((found, true));
        }
        if self.is_abstract()
            && let Some(found) = self.abstract_factor(items, cursor)?
        {
            return Ok((found, true));
        }
        if self.symbols.infers() && (is_big_sum(item) || is_big_product(item) || is_limit(item)) {
            let rest = &items[*cursor + 1..];
            *cursor = items.len();
            return Ok((self.unevaluated(item, rest)?, true));
        }
        if self.symbols.infers() && is_any_integral(item) {
            *cursor += 1;
            return Ok((self.unevaluated_integral(item, items, cursor)?, true));
        }
        if self.symbols.infers()
            && let Some(field) = self.nabla(items, cursor)?
        {
            return Ok((field, true));
        }
        // For its structure alone, \log_{10} is shown with its base.
        let is_shown = self.symbols.infers() && log_base(item).is_some();
        if let Some((function, power)) = function_head(item)?.filter(|_| !is_shown) {
            *cursor += 1;
            let (call, enclosed) = self.call(function, power, item.span, items, cursor)?;
            return Ok((written_out(item, call), enclosed));
        }
        if let Some(found) = self.algebra(items, cursor)? {
            return Ok((found, true));
        }
        if is_big_sum(item) || is_big_product(item) {
            let rest = &items[*cursor + 1..];
            if let Some(counted) = self.counted(item, rest)? {
                *cursor = items.len();
                return Ok((counted, true));
            }
        }
        if is_big_sum(item) {
            let rest = &items[*cursor + 1..];
            *cursor = items.len();
            return Ok((self.big_sum(item, rest)?, true));
        }
        if is_integral(item) {
            *cursor += 1;
            if let Some(value) = self.definite_integral(item, items, cursor)? {
                return Ok((value, true));
            }
            return Ok((self.integral(item, items, cursor)?, true));
        }
        if is_limit(item) {
            let rest = &items[*cursor + 1..];
            *cursor = items.len();
            return Ok((self.shrinking(item, rest)?, true));
        }
        if let Some(order) = self.derivative_slash(items, *cursor) {
            let span = item.span.to(items[*cursor + 4].span);
            let inner = self.item(&items[*cursor + 1])?;
            *cursor += 5;
            self.is_no_value("\\frac{df}{dt}", span, items.get(*cursor).unwrap_or(item))?;
            return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), span), true));
        }
        if let Layout::Fraction(numerator, denominator) = &item.layout
            && let Some((order, rest)) = self.derivative(numerator, denominator)?
        {
            *cursor += 1;
            if !rest.is_empty() {
                self.is_no_value("\\frac{df}{dt}", item.span, items.get(*cursor).unwrap_or(item))?;
                let inner = self.sum(rest, item.span)?;
                return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), item.span), true));
            }
            let inner = self.operand(items, cursor, item.span)?;
            let span = item.span.to(inner.span);
            return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), span), true));
        }
        if let Layout::Fraction(numerator, denominator) = &item.layout
            && let Some(operator) = self.operator(numerator, denominator, item.span)?
        {
            *cursor += 1;
            return Ok((self.apply(&operator, items, cursor)?, true));
        }
        if let Some(operator) = self.operator_on_one_line(items, cursor)? {
            return Ok((self.apply(&operator, items, cursor)?, true));
        }
        if let Some(derivative) = self.subscripted(items, cursor)? {
            return Ok((derivative, true));
        }
        if let Some(compound) = self.compound(items, cursor)? {
            return Ok((compound, true));
        }
        *cursor += 1;
        if let Some(printed) = names::printed(item, self.branch) {
            return Ok((self.symbol(item.span, printed, items, cursor)?, true));
        }
        Ok((self.item(item)?, true))
    }
}

/// Where dots stand directly after a factor at the end: `a_1 x + a_2 x^2 \dots`.
fn dots_after_a_factor(items: &[Item]) -> Option<Span> {
    let mut last = items.iter().rev().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let dots = last.next().filter(|item| matches!(&item.layout, Layout::Command(name) if name == "\\dots"))?;
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other(_)) || joint(item).is_some();
    last.next().filter(|before| !is_sign(before)).map(|_| dots.span)
}

/// Rejects ± between numbers with decimals, 9.81 ± 0.02: a value with its error, and no two values.
fn is_no_error_of_measurement(items: &[Item]) -> Read<()> {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let has_decimals = |item: &Item| matches!(&item.layout, Layout::Number(digits) if digits.contains('.'));
    let is_sign = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\pm");
    let found = solid.windows(3).find(|three| has_decimals(three[0]) && is_sign(three[1]) && has_decimals(three[2]));
    match found {
        Some(three) => Err(Fault::ambiguous(
            three[0].span.to(three[2].span),
            "± between two numbers may mean the uncertainty of a value, or two values",
        )
        .help("write the value without its uncertainty, or write an equation for each value")),
        None => Ok(()),
    }
}

/// Rejects `8.62e-5`: a power of ten as in a program, or a difference.
fn is_no_computer_notation(items: &[Item]) -> Read<()> {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_number = |item: &Item| matches!(item.layout, Layout::Number(_));
    let is_e = |item: &Item| matches!(item.layout, Layout::Letter('e' | 'E'));
    let is_sign = |item: &Item| match &item.layout {
        Layout::Other('+' | '-') => true,
        Layout::Text(word) => ["-", "+", "−"].contains(&word.as_str()),
        _ => false,
    };
    // `8.62\text{e-5}`
    let is_power = |item: &Item| matches!(&item.layout, Layout::Text(word) if is_power_in_a_program(word));
    let found = solid
        .windows(4)
        .find(|four| is_number(four[0]) && is_e(four[1]) && is_sign(four[2]) && is_number(four[3]))
        .or_else(|| solid.windows(2).find(|two| is_number(two[0]) && is_power(two[1])));
    match found {
        Some(found) => Err(Fault::ambiguous(
            found[0].span.to(found[found.len() - 1].span),
            "e after a number may begin a power of ten, or be a quantity",
        )
        .help("write 8 \\times 10^{-5} for the power of ten, or -5 + 8e for the difference")),
        None => Ok(()),
    }
}

/// Rejects `9.8 m/s^2`, `1000 kg/m^3`: letters of units after a number are no quantities as a rule.
fn is_no_spelled_unit(items: &[Item]) -> Read<()> {
    const UNITS: [&str; 46] = [
        "atm", "bar", "mV", "kV", "kN", "mW", "MW", "kWh", "nF", "pF", "mH", "mT", "ns", "dB", "m", "s", "kg", "K",
        "N", "J", "W", "V", "A", "C", "T", "Pa", "Hz", "nm", "cm", "mm", "km", "eV", "keV", "MeV", "GeV", "kPa", "MPa",
        "kJ", "kW", "ms", "mol", "rad", "GHz", "MHz", "kHz", "mA",
    ];
    /// What is hardly ever a product after a small number either.
    const SURE: [&str; 9] = ["kg", "Hz", "Pa", "eV", "mol", "mm", "kWh", "atm", "bar"];
    /// What is a unit below another one: `20 km/h`.
    const BELOW: [&str; 3] = ["h", "L", "min"];
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let Some(start) = items.iter().position(|item| !is_space(item)) else { return Ok(()) };
    let Layout::Number(digits) = &items[start].layout else { return Ok(()) };
    // `1.1 \times 10^7`
    let is_power = |item: &Item| matches!(&item.layout, Layout::Scripts { nucleus, .. } if matches!(nucleus.layout, Layout::Number(_)));
    let figures = items[start..].iter().take_while(|item| {
        is_space(item) || matches!(item.layout, Layout::Number(_)) || is_power(item) || joint(item).is_some()
    });
    let mut at = start + figures.count();
    // `300 \cdot K` is a product.
    if items[start..at].iter().rfind(|item| !is_space(item)).is_some_and(|last| joint(last).is_some()) {
        return Ok(());
    }
    // `3\times10^8 m/s`: a power of ten stands before a unit more often than before a letter.
    let has_power = items[start..at].iter().any(is_power);
    let is_large = digits.contains('.') || digits.len() > 1 || has_power;
    // `26 \Omega`, `4\,\Omega`, `10 k\Omega`: a resistance, or a frequency that a small number is a factor of.
    let prefix = usize::from(matches!(items.get(at).map(|item| &item.layout), Some(Layout::Letter('k' | 'M' | 'm'))));
    let is_apart = at > 0 && is_space(&items[at - 1]);
    if let Some(omega) = items.get(at + prefix)
        && omega.layout == Layout::Command("\\Omega".to_owned())
        && (is_large || is_apart)
        && items[at + prefix + 1..].iter().all(is_space)
    {
        return Err(Fault::ambiguous(omega.span, "Ω after a number may be the unit ohm or a quantity")
            .help("write \\text{Ω} for the unit, and \\cdot before a quantity"));
    }
    let mut found: Option<(String, Span)> = None;
    let mut is_sure = is_large;
    // Whether a unit may stand here: `0.5 C V^2` is a product.
    let mut goes_on = true;
    while at < items.len() {
        match run_of_letters(items, at) {
            Some((word, span, length))
                if UNITS.contains(&word.as_str()) || found.is_some() && goes_on && BELOW.contains(&word.as_str()) =>
            {
                let has_index = matches!(&items[at + length - 1].layout, Layout::Scripts { sub, primes, .. } if sub.is_some() || *primes > 0);
                let is_product = found.as_ref().is_some_and(|(first, _)| ["kg", "N", "J"].contains(&first.as_str()))
                    && ["m", "s", "K"].contains(&word.as_str())
                    || found.is_some() && has_negative_power(&items[at + length - 1]);
                if has_index || !(goes_on || is_product) {
                    return Ok(());
                }
                goes_on = false;
                is_sure |= SURE.contains(&word.as_str());
                found.get_or_insert((word, span));
                at += length;
            }
            None if is_space(&items[at]) => at += 1,
            None if joint(&items[at]) == Some(Joint::Slash) => (goes_on, at) = (true, at + 1),
            // `6.6\times10^{-34} J\cdot s`
            None if joint(&items[at]) == Some(Joint::CDot) && found.is_some() => at += 1,
            // `9.8\frac{m}{s^2}`, `9\times10^9\frac{N m^2}{C^2}`
            None if is_large && found.is_none() => {
                let Layout::Fraction(above, below) = &items[at].layout else { return Ok(()) };
                let (Some(above), Some(below)) = (words(above), words(below)) else { return Ok(()) };
                let [(unit, span), ..] = above.as_slice() else { return Ok(()) };
                let (unit, span) = (unit.clone(), *span);
                let are_units = above.iter().all(|(word, _)| UNITS.contains(&word.as_str()))
                    && below.iter().all(|(word, _)| UNITS.contains(&word.as_str()) || BELOW.contains(&word.as_str()));
                let is_one = above.len() == 1 && below.len() == 1;
                if !are_units || !(is_one || has_power || ["kg", "N", "J"].contains(&unit.as_str())) {
                    return Ok(());
                }
                goes_on = false;
                found = Some((unit, span));
                at += 1;
            }
            _ => return Ok(()),
        }
    }
    match found {
        Some((word, span)) if is_sure => Err(Fault::ambiguous(span, format!("{word} may be a unit or a quantity"))
            .help(format!("write \\mathrm{{{word}}} for the unit, and \\cdot before a quantity"))),
        _ => Ok(()),
    }
}

/// The runs of letters that are all of a numerator or denominator.
fn words(part: &Item) -> Option<Vec<(String, Span)>> {
    let (items, mut at, mut words) = (contents(part), 0, Vec::new());
    while at < items.len() {
        if matches!(items[at].layout, Layout::Space(_)) || joint(&items[at]) == Some(Joint::CDot) {
            at += 1;
            continue;
        }
        let (word, span, length) = run_of_letters(items, at)?;
        words.push((word, span));
        at += length;
    }
    Some(words)
}

/// Whether a factor has a negative power: `s^{-2}`.
fn has_negative_power(item: &Item) -> bool {
    matches!(&item.layout, Layout::Scripts { sub: None, sup: Some(sup), .. }
        if matches!(contents(sup).first(), Some(Item { layout: Layout::Other('-'), .. })))
}

/// Rejects `1.1 \times 10^7\,m^{-1}`: after a number and a space the letter is that of a unit more often than a quantity.
fn is_no_italic_unit(items: &[Item]) -> Read<()> {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let Some((last, numbers)) = solid.split_last() else { return Ok(()) };
    let Layout::Scripts { nucleus, primes: 0, .. } = &last.layout else { return Ok(()) };
    let Layout::Letter(letter) = nucleus.layout else { return Ok(()) };
    let is_unit = "mskKJNCVATWg".contains(letter);
    let is_negative = has_negative_power(last);
    let is_power = |item: &Item| matches!(&item.layout, Layout::Scripts { nucleus, .. } if matches!(nucleus.layout, Layout::Number(_)));
    let is_number = |item: &Item| {
        is_numeric_item(item) || is_power(item) || matches!(item.layout, Layout::Number(_)) || joint(item).is_some()
    };
    let has_number = numbers.iter().any(|item| matches!(item.layout, Layout::Number(_)));
    let is_apart = items.iter().rev().nth(1).is_some_and(|item| matches!(item.layout, Layout::Space(_)));
    match is_unit && is_negative && is_apart && has_number && numbers.iter().all(|item| is_number(item)) {
        true => Err(Fault::ambiguous(last.span, format!("{letter} may be a unit or a quantity"))
            .help(format!("write \\mathrm{{{letter}}} for the unit, and \\cdot before a quantity"))),
        false => Ok(()),
    }
}

/// Rejects `15\%-25\%` and `5-10\,\text{m/s}`: a range of values, and no difference.
fn is_no_range(items: &[Item]) -> Read<()> {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let Some(sign) = solid.iter().position(|item| matches!(item.layout, Layout::Other('-' | '–'))) else {
        return Ok(());
    };
    let (from, to) = (&solid[..sign], &solid[sign + 1..]);
    let is_unit = |item: &Item| matches!(item.layout, Layout::Unit(_));
    let value = |side: &[&Item]| match side {
        [number, rest @ ..] if rest.iter().all(|item| is_unit(item)) => match &number.layout {
            Layout::Number(digits) => digits.parse::<f64>().ok().map(|value| (value, !rest.is_empty())),
            Layout::Group(inside) if inside.len() == 2 && is_unit(&inside[1]) => match &inside[0].layout {
                Layout::Number(digits) => digits.parse::<f64>().ok().map(|value| (value, true)),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    };
    let is_percent =
        |side: &[&Item]| side.last().is_some_and(|item| typed(std::slice::from_ref(*item)).ends_with("\\%"));
    match (value(from), value(to)) {
        // `1 - 20\%` and `2\,\text{s} - 3\,\text{s}` are differences.
        (Some((first, has_unit)), Some((second, true))) if first < second && has_unit == is_percent(to) => {
            let span = from[0].span.to(to[to.len() - 1].span);
            Err(Fault::ambiguous(span, "− between two values may mean a range of values, or a difference")
                .help("write one value"))
        }
        _ => Ok(()),
    }
}
