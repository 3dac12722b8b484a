//! Neighbouring factors that a person reads otherwise where nothing is declared: `(f + g)(x)`, `h(t) * g(t)`, `x{2}`, `A \uparrow B`,
//! `\frac1T [Hz]`. They are refused.

use crate::formula::symbols::Name;
use crate::source::Fault;

use super::super::super::layout::{Delimiter, Item, Layout, contents, typed};
use super::super::super::names;
use super::super::items::{is_numeric_item, joint};
use super::super::state::{Read, Reader};
use super::super::structure::is_open_decimal;
use super::super::words::after_a_symbol;
use super::no_factors::{
    are_numbers, is_expectation, is_power_of_j, is_twice_pi, is_word, signed_in_braces, unclear_operator,
};

/// Arrows that show a direction or a change, and are no factors.
const ARROWS: [&str; 8] = [
    "\\uparrow",
    "\\downarrow",
    "\\updownarrow",
    "\\nearrow",
    "\\searrow",
    "\\nwarrow",
    "\\swarrow",
    "\\rightleftharpoons",
];

/// Units of several letters that nobody takes for a product.
const UNITS: [&str; 16] =
    ["eV", "keV", "MeV", "GeV", "TeV", "Hz", "kHz", "MHz", "GHz", "Pa", "kPa", "MPa", "mol", "rad", "dB", "rpm"];

impl Reader<'_> {
    /// Rejects the factor at a place beside the one before it.
    pub(in super::super) fn is_a_clear_factor(&self, items: &[Item], at: usize) -> Read<()> {
        let item = &items[at];
        if is_convolution(items, at) {
            return Err(Fault::ambiguous(
                item.span,
                "* between two functions of one variable may be a product or a convolution",
            )
            .help("for a product write \\cdot"));
        }
        if is_word_with_power(item) {
            return Err(Fault::ambiguous(item.span, "this power may be that of the word or of its last letter")
                .help("write a product of letters without \\text, m v^2, and the power of a word as (\\text{…})^2"));
        }
        if matches!(&item.layout, Layout::Command(name) if ARROWS.contains(&name.as_str())) {
            return Err(Fault::unsupported(
                item.span,
                format!("the arrow {} is not supported as a symbol of its own", typed(&items[at..=at])),
            )
            .help(
                "write the arrow as a subscript, as in n_\\uparrow, or leave it out; write a reaction as an equation",
            ));
        }
        if is_power_of_j(item) {
            return Err(Fault::ambiguous(item.span, "j may be √−1 or a symbol")
                .help("write i for √−1, or declare j as \"imaginary unit\" in a claims file; for a symbol, use another letter"));
        }
        let Some(before) = items[..at].iter().rev().find(|item| !matches!(item.layout, Layout::Space(_))) else {
            return Ok(());
        };
        if !self.is_abstract() && is_open_decimal(before, item) {
            return Err(Fault::unsupported(
                before.span.to(item.span),
                "a number whose decimals go on has no exact value",
            )
            .help("write the number without the dots, after ≈"));
        }
        if !self.is_abstract() && is_expectation(before) && joint(item).is_none() {
            return Err(Fault::unsupported(before.span, "a mean value without parentheses is not supported")
                .help("write \\mathbb{E}[x]"));
        }
        if is_twice_pi(&items[..at]) && item.layout == Layout::Letter('e') {
            return Err(Fault::ambiguous(item.span, "e after 2π may be Euler’s number, 2.718…, or a symbol")
                .help("write \\exp(1) for the number, and another letter for a symbol"));
        }
        let touches = !matches!(items[at - 1].layout, Layout::Space(_));
        let braced = match &item.layout {
            Layout::Command(name) if name == "\\underbrace" || name == "\\overbrace" => items.get(at + 1),
            _ => Some(item),
        };
        let signed = || braced.and_then(|braced| signed_in_braces(before, braced));
        if let Some(fault) = unclear_operator(before, item).or_else(signed) {
            return Err(fault);
        }
        let goes_on = matches!(items.get(at + 1).map(|next| &next.layout), Some(Layout::Fence(..)));
        if !goes_on && is_word(item) && !is_figure(before) && joint(before).is_none() {
            return Err(Fault::unsupported(item.span, "words beside a formula are not supported")
                .help("put them after \\quad, or write \\cdot before a quantity whose name is a word"));
        }
        let span = before.span.to(item.span);
        if touches && is_hatted_capital(before) && may_be_an_argument(item) {
            return Err(Fault::ambiguous(
                span,
                "the parenthesis after this operator may hold its argument or a factor",
            )
            .help("for a product, put a thin space \\, before the parenthesis"));
        }
        if touches && is_functional(before) && has_comma_in_brackets(item) {
            return Err(Fault::unsupported(span, "a functional of several functions is not supported")
                .help("write it with its name alone"));
        }
        if touches && is_covariant(before) && names::printed(item, None).is_some() {
            return Err(Fault::ambiguous(span, "D before a letter may be a covariant derivative or a factor")
                .help("for a product, put a thin space \\, between the letters"));
        }
        let is_applied =
            items.get(at + 1).is_some_and(|next| matches!(next.layout, Layout::Fence(Delimiter::Square, _)));
        let is_capital = letter(item).is_some_and(|c| c.is_ascii_uppercase());
        if is_second_variation(before) && self.is_name(item) && (is_applied || is_capital) {
            return Err(Fault::ambiguous(span, "δ² before a letter may be the second variation or a factor")
                .help("for a product, write \\cdot"));
        }
        let is_operator = |item: &Item| {
            matches!(&item.layout, Layout::Fence(Delimiter::Square, inside)
                if matches!(inside.as_slice(), [only] if has_hat(only)))
        };
        if touches && is_operator(before) && is_operator(item) {
            return Err(Fault::ambiguous(span, "a name in brackets after brackets may be an argument or a factor")
                .help("write one of the two in parentheses"));
        }
        if touches && is_step_in_brackets(before) && is_step_in_brackets(item) {
            return Err(Fault::unsupported(span, "two numbers of steps in brackets are not supported")
                .help("write them as a subscript, x_{jk}"));
        }
        // `\int \mathcal{D}x\, e^{iS}`
        let is_measure = |item: &Item| {
            names::printed(item, None)
                .is_some_and(|found| ["\\mathcal{D}", "\\mathscr{D}"].contains(&found.name.base.as_str()))
        };
        if touches && self.symbols.inferred.differentials && is_measure(before) && self.is_name(item) {
            return Err(Fault::unsupported(span, "an integral over paths is not supported")
                .help("write its result in a display without the integral"));
        }
        if touches && is_operation(before) && self.is_lone_letter(item) {
            return Err(Fault::ambiguous(
                span,
                "a letter in parentheses after parentheses may be the argument of a function or a factor",
            )
            .help("for a product, remove the parentheses around the letter"));
        }
        let is_pi = before.layout == Layout::Command("\\pi".to_owned());
        if touches && is_pi && (self.is_lone_letter(item) || has_bar(item)) {
            return Err(Fault::ambiguous(span, "π may be a function here, such as a density, or the number")
                .help("for the number, remove the parentheses or write \\cdot"));
        }
        if touches && self.is_name(before) && is_number_in_braces(item) {
            return Err(Fault::ambiguous(span, "a number after a symbol may be a subscript, a power or a factor")
                .help(after_a_symbol(item)));
        }
        if items[at + 1..].iter().all(|next| matches!(next.layout, Layout::Space(_)))
            && let Some(unit) = unit_in_brackets(item)
        {
            return Err(Fault::ambiguous(item.span, format!("[{unit}] may be a unit or a product"))
                .help(format!("write \\text{{{unit}}} for the unit, or parentheses for a product")));
        }
        if touches && is_mean(before) && (self.is_lone_letter(item) || is_lone_number(item)) {
            return Err(Fault::ambiguous(
                span,
                "a parenthesis after a mean value may hold the place where it is taken, or a factor",
            )
            .help("for a product, remove the parentheses around the letter"));
        }
        if touches && self.is_no_plain_factor(before) && (self.is_lone_letter(item) || self.is_list_of_names(item)) {
            return Err(Fault::ambiguous(
                span,
                "the parenthesis after this formula may hold the place where it is taken, or a factor",
            )
            .help("for a product, write \\cdot"));
        }
        if let Some(variable) = variable_of_derivative(before).filter(|_| touches)
            && is_place_of(item, &variable)
        {
            return Err(Fault::ambiguous(
                span,
                "the parenthesis after this derivative may be the place where it is taken, or a factor",
            )
            .help("for a product, write \\cdot; for a place, put a bar after the derivative, |_{x = a}"));
        }
        if is_filter(items, at) {
            return Err(
                Fault::ambiguous(item.span, "* may be a product or a convolution").help("for a product write \\cdot")
            );
        }
        let ends =
            items[at + 1..].iter().all(|next| matches!(next.layout, Layout::Space(_) | Layout::Other('.' | ',')));
        let is_factor = is_nonzero_number(before) || are_numbers(before);
        if ends && is_equation_number(item) && !is_factor && joint(before).is_none() {
            return Err(Fault::ambiguous(
                item.span,
                "a number in parentheses at the end may be that of the equation, or a factor",
            )
            .help("number the equation with \\tag, and write a factor before what it multiplies"));
        }
        if !matches!(before.layout, Layout::Number(_)) {
            return Ok(());
        }
        let run: String = items[at..].iter().map_while(letter).collect();
        if UNITS.contains(&run.as_str()) {
            return Err(Fault::ambiguous(item.span, format!("{run} may be a unit or a product"))
                .help(format!("write \\text{{{run}}} for the unit, or \\cdot between the factors")));
        }
        Ok(())
    }

    /// Whether an item is a formula that may be a function as a whole: a quotient, a root, bars, a mark over several letters.
    fn is_no_plain_factor(&self, item: &Item) -> bool {
        let is_number = |item: &Item| super::super::items::is_numeric_item(item);
        match &item.layout {
            Layout::Fraction(..) | Layout::Root(..) => !is_number(item),
            // `2(b)(\omega)`: both are put in.
            Layout::Fence(..) => !self.is_lone_letter(item) && !is_lone_number(item),
            Layout::Accent(..) => names::printed(item, self.branch).is_none(),
            Layout::Scripts { nucleus, .. } => {
                names::printed(item, self.branch).is_none() && self.is_no_plain_factor(nucleus)
            }
            _ => false,
        }
    }

    /// Whether names with commas between them stand in a parenthesis: `(\theta, \phi)`.
    fn is_list_of_names(&self, item: &Item) -> bool {
        let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
        let is_comma = |item: &Item| matches!(item.layout, Layout::Other(','));
        let is_part = |item: &Item| is_comma(item) || matches!(item.layout, Layout::Space(_)) || self.is_name(item);
        inside.iter().any(is_comma) && inside.iter().all(is_part)
    }

    fn is_name(&self, item: &Item) -> bool {
        names::printed(item, self.branch).is_some_and(|found| found.sup.is_none())
    }

    /// Whether one letter stands in parentheses: `(x)`.
    fn is_lone_letter(&self, item: &Item) -> bool {
        let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
        matches!(inside.as_slice(), [only]
            if names::printed(only, self.branch).is_some_and(|found| found.sup.is_none() && found.name.primes == 0))
    }
}

fn is_figure(item: &Item) -> bool {
    is_nonzero_number(item) || matches!(item.layout, Layout::Number(_) | Layout::Unit(_) | Layout::Text(_))
}

/// Whether an item is a mean value, `\langle x \rangle`, or the square of an absolute value, `|\psi|^2`.
fn is_mean(item: &Item) -> bool {
    match &item.layout {
        Layout::Fence(Delimiter::Angle, _) | Layout::Value(_) => true,
        Layout::Scripts { nucleus, sup, .. } => {
            let is_bar = matches!(nucleus.layout, Layout::Fence(Delimiter::Bar | Delimiter::PlainBar, _));
            is_mean(nucleus) || is_bar && sup.as_deref().and_then(super::super::items::whole_number) == Some(2)
        }
        _ => false,
    }
}

fn is_lone_number(item: &Item) -> bool {
    matches!(&item.layout, Layout::Fence(Delimiter::Round, inside)
        if matches!(inside.as_slice(), [Item { layout: Layout::Number(_), .. }]))
}

/// The letter by which a fraction differentiates: x of `\frac{\partial V}{\partial x}`.
fn variable_of_derivative(item: &Item) -> Option<Name> {
    let Layout::Fraction(above, below) = &item.layout else { return None };
    let is_d = |item: &Item| {
        item.layout == Layout::Letter('d') || matches!(&item.layout, Layout::Command(name) if name == "\\partial")
    };
    let starts = contents(above).first().is_some_and(is_d);
    match contents(below) {
        [d, variable] if starts && is_d(d) => names::printed(variable, None).map(|found| found.name),
        _ => None,
    }
}

/// Whether a parenthesis holds one of several terms with a variable, `(2x)`, `(x_0 + h)`; `x - x_0` is a factor.
fn is_place_of(item: &Item, variable: &Name) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    let is_it = |item: &Item| {
        names::printed(item, None)
            .is_some_and(|found| found.name.base == variable.base && found.sup.is_none() && found.dots == 0)
    };
    let has_difference = inside.iter().any(|item| matches!(item.layout, Layout::Other('-' | ',')));
    inside.len() > 1 && !has_difference && inside.iter().any(is_it)
}

/// Whether a `*` stands between a kernel and one other name, which are the whole side: `G * u`.
fn is_filter(items: &[Item], at: usize) -> bool {
    if items[at].layout != Layout::Other('*') {
        return false;
    }
    let only = |items: &[Item]| -> Option<usize> {
        let mut solid = (0..items.len()).filter(|place| !matches!(items[*place].layout, Layout::Space(_)));
        solid.next().filter(|_| solid.next().is_none())
    };
    let is_kernel = |item: &Item| matches!(letter(item), Some('G' | 'K'));
    let is_name = |item: &Item| names::printed(item, None).is_some_and(|found| found.sup.is_none());
    let (Some(before), Some(after)) = (only(&items[..at]), only(&items[at + 1..])) else { return false };
    is_kernel(&items[before]) && is_name(&items[at + 1 + after])
}

/// `(5.12)`
fn is_equation_number(item: &Item) -> bool {
    matches!(&item.layout, Layout::Fence(Delimiter::Round, inside)
        if matches!(inside.as_slice(), [Item { layout: Layout::Number(digits), .. }] if digits.contains('.')))
}

fn is_nonzero_number(item: &Item) -> bool {
    match &item.layout {
        Layout::Number(digits) => digits != "0",
        Layout::Fraction(..) | Layout::Unit(_) => is_numeric_item(item) || matches!(item.layout, Layout::Unit(_)),
        Layout::Scripts { nucleus, .. } => is_nonzero_number(nucleus),
        _ => is_lone_number(item),
    }
}

fn has_hat(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| found.name.base.starts_with("\\hat{") && found.sup.is_none())
}

/// Whether an item is a capital with a hat, an operator: `\hat R_z`.
fn is_hatted_capital(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| {
        let base = found.name.base.strip_prefix("\\hat{").or(found.name.base.strip_prefix("\\widehat{"));
        found.sup.is_none() && base.is_some_and(|base| base.starts_with(|c: char| c.is_ascii_uppercase()))
    })
}

/// Whether one term without an operator stands in a parenthesis, and no lone name: `(-\omega t)`, `(2\alpha)`, `(\pi/2)`.
fn may_be_an_argument(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-' | ','));
    let is_marked = |item: &Item| {
        matches!(item.layout, Layout::Accent(..) | Layout::Style(..) | Layout::Fence(..))
            || matches!(&item.layout, Layout::Scripts { nucleus, .. }
                if matches!(nucleus.layout, Layout::Accent(..) | Layout::Style(..)))
            || names::printed(item, None).is_some_and(|found| found.name.base.starts_with(char::is_uppercase))
    };
    inside.len() > 1 && !inside.iter().skip(1).any(is_sign) && !inside.iter().any(is_marked)
}

/// Whether a small letter or a number stands alone in square brackets: `t[j][k]`.
fn is_step_in_brackets(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Square, inside) = &item.layout else { return false };
    match inside.as_slice() {
        [only] => letter(only).is_some_and(|c| c.is_ascii_lowercase()) || matches!(only.layout, Layout::Number(_)),
        _ => false,
    }
}

/// Whether an item is a D with one index, as of a covariant derivative: `D_\mu`, `D_t`.
fn is_covariant(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| {
        let is_index = |index: &str| ["\\mu", "\\nu", "\\tau", "\\lambda", "\\alpha", "t"].contains(&index);
        found.sup.is_none()
            && ["D", "\\mathcal{D}"].contains(&found.name.base.as_str())
            && matches!(found.name.subscript.as_slice(), [index] if is_index(index))
    })
}

/// Whether an item is δ with the power 2.
fn is_second_variation(item: &Item) -> bool {
    matches!(&item.layout, Layout::Scripts { nucleus, sub: None, sup: Some(sup), .. }
        if nucleus.layout == Layout::Command("\\delta".to_owned()) && super::super::items::whole_number(sup) == Some(2))
}

/// Whether a letter usually stands for a functional: `F[n, T]`.
fn is_functional(item: &Item) -> bool {
    let is_letter = |base: &str| ["f", "F", "S", "J", "G", "W", "I", "L", "H", "Z", "\\Gamma"].contains(&base);
    names::printed(item, None).is_some_and(|found| found.sup.is_none() && is_letter(&found.name.base))
}

fn has_comma_in_brackets(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Square, inside) = &item.layout else { return false };
    inside.iter().any(|item| item.layout == Layout::Other(','))
}

/// The fault of a derivative before a product whose second factor it may not reach: `\frac{d}{dt} r \wedge p`,
/// `\nabla \cdot \vec a \times \vec b`.
pub(in super::super) fn unclear_reach(items: &[Item]) -> Option<Fault> {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_command =
        |item: &Item, names: &[&str]| matches!(&item.layout, Layout::Command(name) if names.contains(&name.as_str()));
    let (first, rest) = solid.split_first()?;
    // `\nabla f(x)_1`
    if let [name, value, ..] = rest
        && is_command(first, &["\\nabla"])
        && names::printed(name, None).is_some()
        && let Layout::Scripts { nucleus, sub: Some(_), .. } = &value.layout
        && matches!(nucleus.layout, Layout::Fence(Delimiter::Round, _))
    {
        return Some(
            Fault::ambiguous(value.span, "the subscript may belong to the gradient or to the function")
                .help("write the component of the gradient as (\\nabla f)_1"),
        );
    }
    let sign = match rest.first() {
        Some(dot) if is_command(first, &["\\nabla"]) && is_command(dot, &["\\cdot"]) => {
            rest.iter().skip(1).find(|item| is_command(item, &["\\times", "\\wedge", "\\otimes"]))
        }
        _ if is_operator(first) => rest.iter().find(|item| is_command(item, &["\\wedge", "\\otimes"])),
        _ => None,
    }?;
    Some(
        Fault::ambiguous(sign.span, "the derivative may be that of the first factor or that of the product")
            .help("put the factors that it differentiates in parentheses"),
    )
}

/// Whether an item is a derivative without what it acts on: `\frac{d}{dt}`.
fn is_operator(item: &Item) -> bool {
    let Layout::Fraction(above, below) = &item.layout else { return false };
    let is_d = |item: &Item| {
        item.layout == Layout::Letter('d') || matches!(&item.layout, Layout::Command(name) if name == "\\partial")
    };
    matches!(contents(above), [only] if is_d(only)) && contents(below).first().is_some_and(is_d)
}

/// Whether names stand in a parenthesis with a sign or side by side: `(f + g)`, `(Tf)`.
fn is_operation(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    let mut solid = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let is_named = |item: &Item| names::printed(item, None).is_some() || matches!(item.layout, Layout::Accent(..));
    let is_sign = |name: &str| ["\\circ", "\\dots", "\\cdots", "\\ast"].contains(&name);
    let is_part = |item: &Item| {
        is_named(item)
            || matches!(item.layout, Layout::Other('+' | '-' | '*' | '∘'))
            || matches!(&item.layout, Layout::Command(name) if is_sign(name))
    };
    inside.len() > 1 && inside.first().is_some_and(is_named) && solid.all(is_part)
}

fn is_number_in_braces(item: &Item) -> bool {
    matches!(&item.layout, Layout::Group(inside)
        if matches!(inside.as_slice(), [Item { layout: Layout::Number(_), .. }]))
}

/// Whether a bar divides what stands in parentheses: `(a|s)`.
fn has_bar(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    inside.iter().any(|item| item.layout == Layout::Other('|'))
}

fn letter(item: &Item) -> Option<char> {
    match item.layout {
        Layout::Letter(c) => Some(c),
        _ => None,
    }
}

/// The unit in square brackets: `[Hz]`, `[m/s]`.
fn unit_in_brackets(item: &Item) -> Option<String> {
    const SIMPLE: [&str; 12] = ["m", "s", "kg", "N", "J", "W", "K", "V", "A", "T", "cm", "mm"];
    let Layout::Fence(Delimiter::Square, inside) = &item.layout else { return None };
    let unit: String = inside
        .iter()
        .map(|item| letter(item).or((item.layout == Layout::Other('/')).then_some('/')))
        .collect::<Option<_>>()?;
    let is_unit = |part: &str| UNITS.contains(&part) || SIMPLE.contains(&part);
    (unit.len() > 1 && unit.split('/').all(is_unit)).then_some(unit)
}

/// Whether a `*` stands between two functions of one variable: `h(t) * x(t)`.
fn is_convolution(items: &[Item], at: usize) -> bool {
    let lone = |item: Option<&Item>| match item.map(|item| &item.layout) {
        Some(Layout::Fence(Delimiter::Round, inside)) => match inside.as_slice() {
            [only] => letter(only),
            _ => None,
        },
        _ => None,
    };
    let is_space = |item: &&Item| matches!(item.layout, Layout::Space(_));
    if items[at].layout != Layout::Other('*') {
        return false;
    }
    let before = lone(items[..at].iter().rev().find(|item| !is_space(item)));
    before.is_some() && before == lone(items[at + 1..].iter().filter(|item| !is_space(item)).nth(1))
}

/// Whether a word of a few upright letters has a power, `{\text{mv}}^2`: of the word, or of its last letter.
fn is_word_with_power(item: &Item) -> bool {
    let Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } = &item.layout else { return false };
    let inner = match contents(nucleus) {
        [only] => only,
        _ => return false,
    };
    let word = match &inner.layout {
        Layout::Text(word) => word.clone(),
        Layout::Style(style, inner) if style == "\\mathrm" => contents(inner).iter().filter_map(letter).collect(),
        _ => return false,
    };
    const FUNCTIONS: [&str; 12] = ["sin", "cos", "tan", "cot", "sec", "exp", "log", "ln", "tr", "Tr", "det", "sgn"];
    let is_short = (2..=3).contains(&word.len()) && word.chars().all(|c| c.is_ascii_alphabetic());
    is_short
        && !FUNCTIONS.contains(&word.as_str())
        && !UNITS.contains(&word.as_str())
        && !super::super::super::layout::is_number_of_a_flow(&word)
        && matches!(contents(sup), [Item { layout: Layout::Number(_), .. }])
}
