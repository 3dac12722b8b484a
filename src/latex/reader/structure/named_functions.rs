//! Functions with a name and no value here, `\max(a, b)`, `\mathrm{erf}(x)`; and the power of an operator with a parenthesis.

use std::ops::Range;

use crate::formula::tree::Expr;
use crate::source::Fault;

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::algebra::operator_word;
use super::super::items::{Joint, joint};
use super::super::slashes;
use super::super::state::{Read, Reader};
use super::{is_prose, printed};

impl Reader<'_> {
    /// `\det(A)^2`, `\max(a, b)^2`: the power is of the value, for nothing else is raised in print.
    ///
    /// `\sin(x)^2` and `\ln(x)^2` are rejected, since some authors mean the argument.
    pub(in super::super) fn raised_operator(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let head = &items[*cursor];
        let Some(Item { layout: Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }, span }) =
            items.get(*cursor + 1)
        else {
            return Ok(None);
        };
        let Some(word) = operator_name(head) else { return Ok(None) };
        if !matches!(nucleus.layout, Layout::Fence(Delimiter::Round | Delimiter::Square, _)) {
            return Ok(None);
        }
        if DOUBTFUL.contains(&word.as_str()) {
            let what = format!("\\{word}(x)^2 may be (\\{word}(x))^2 or \\{word}(x^2)");
            return Err(Fault::ambiguous(head.span.to(*span), what)
                .help(format!("write (\\{word}(x))^2 for the power of the function")));
        }
        if !WITH_VALUE.contains(&word.as_str()) && !FUNCTIONS.contains(&word.as_str()) {
            return Ok(None);
        }
        *cursor += 2;
        let whole = head.span.to(*span);
        let (value, _) = self.factor(&[head.clone(), (**nucleus).clone()], &mut 0)?;
        self.raised(value, sup, whole).map(Some)
    }

    /// `\max(a, b)`, `\mathrm{erf}(x)`, `\log x`: a named function of what follows.
    pub(in super::super) fn named_function(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let (nucleus, is_bare) = match &item.layout {
            Layout::Scripts { nucleus, primes: 0, .. } => (&**nucleus, false),
            _ => (item, true),
        };
        // `\mathop{\mathrm{minimize}}_u`
        let nucleus = match contents(nucleus) {
            [only] if matches!(nucleus.layout, Layout::Group(_)) => only,
            _ => nucleus,
        };
        let is_word = |item: &Item| matches!(item.layout, Layout::Letter(_) | Layout::Number(_) | Layout::Other('-'));
        let is_function = match &nucleus.layout {
            Layout::Command(name) => FUNCTIONS.contains(&name.trim_start_matches('\\')),
            Layout::Text(word) => {
                let next = items.get(*cursor + 1).map(|next| &next.layout);
                !is_bare && (FUNCTIONS.contains(&word.trim()) || TRACES.contains(&word.trim()))
                    || !is_prose(word) && matches!(next, Some(Layout::Fence(Delimiter::Round | Delimiter::Square, _)))
            }
            // `\mathbb{E}_\theta[f]`, `\mathbb{P}(A)`: a mean value, a probability.
            Layout::Style(style, inner) if style == "\\mathbb" => {
                let letter = printed(contents(inner));
                let has_argument = items.get(*cursor + 1).is_some_and(|next| {
                    matches!(next.layout, Layout::Fence(Delimiter::Round | Delimiter::Square | Delimiter::Curly, _))
                });
                // `\mathbb{E}_x \log f(x)`
                letter == "E" || ["P", "V"].contains(&letter.as_str()) && has_argument
            }
            Layout::Style(style, inner) if style == "\\mathrm" && contents(inner).iter().all(is_word) => {
                let word = printed(contents(inner));
                let has_argument =
                    matches!(items.get(*cursor + 1).map(|next| &next.layout), Some(Layout::Fence(Delimiter::Round, _)));
                // `\mathrm{Pr}\,f`: the Prandtl number, where no event stands in parentheses.
                FUNCTIONS.contains(&word.as_str()) && (word != "Pr" || has_argument)
                    || contents(inner).len() > 1 && has_argument && is_bare
                    || !is_bare && TRACES.contains(&word.as_str())
                    || MEANS.contains(&word.as_str()) && is_in_brackets(items.get(*cursor + 1))
            }
            _ => false,
        };
        // `\operatorname{sen}\theta`, `\text{sinh}\,x`
        let word = match &nucleus.layout {
            Layout::Text(word) => word.clone(),
            _ => operator_word(nucleus).unwrap_or_default(),
        };
        let is_upright = matches!(nucleus.layout, Layout::Text(_) | Layout::Style(..));
        let follows = items[*cursor + 1..].iter().any(|next| !matches!(next.layout, Layout::Space(_)));
        let known = OF_OTHERS.iter().find(|(name, _)| *name == word).map(|(_, known)| *known);
        if let Some(known) = known.filter(|_| is_upright && follows && !is_function) {
            let fault = Fault::unsupported(item.span, format!("the function {word} is not supported"));
            return Err(fault.help(format!("write \\{known} with its argument in parentheses")));
        }
        // `\operatorname{E}(a + b)`: a mean value, or a matrix before a factor.
        if let (true, "E", Some(next)) = (is_bare, word.as_str(), items.get(*cursor + 1))
            && matches!(&next.layout, Layout::Fence(Delimiter::Round, inside) if inside.len() > 1)
        {
            return Err(Fault::ambiguous(
                item.span.to(next.span),
                "E before a parenthesis may be a mean value or a factor",
            )
            .help("write \\mathbb{E}[x] for the mean value, and \\cdot for a product"));
        }
        if !is_function {
            return Ok(None);
        }
        *cursor += 1;
        let name = printed(std::slice::from_ref(item));
        if let Some(Item { layout: Layout::Fence(Delimiter::LeftOpen | Delimiter::RightOpen, _), span }) =
            items.get(*cursor)
        {
            return Err(Fault::ambiguous(*span, "this may be an interval or the arguments of the function before it")
                .help("for the arguments of a function, write two brackets of one kind, as in f(a, b)"));
        }
        if let Some(Item { layout: Layout::Fence(delimiter, inside), span }) = items.get(*cursor)
            && let Some((open, close)) = brackets(*delimiter)
        {
            *cursor += 1;
            let is_comma = |item: &Item| matches!(item.layout, Layout::Other(',' | ';'));
            let arguments = inside.split(is_comma).map(|part| self.sum(part, *span)).collect::<Read<Vec<_>>>()?;
            let holes = vec!["#"; arguments.len()].join(", ");
            return Ok(Some(self.template(&format!("{name}{open}{holes}{close}"), arguments, item.span.to(*span))));
        }
        // `\mathbb{E}[X]^2`: the power of the value.
        if is_in_brackets(items.get(*cursor))
            && let Some(Item { layout: Layout::Scripts { nucleus: fence, sub: None, sup: Some(sup), primes: 0 }, span }) =
                items.get(*cursor)
        {
            *cursor += 1;
            let Layout::Fence(_, inside) = &fence.layout else { return Ok(None) };
            let inner = self.sum(inside, *span)?;
            let whole = item.span.to(*span);
            let value = self.template(&format!("{name}[#]"), vec![inner], whole);
            return self.raised(value, sup, whole).map(Some);
        }
        // A mean value and a trace reach to the end of the term.
        let reaches_on = matches!(&nucleus.layout, Layout::Style(style, _) if style == "\\mathbb")
            || TRACES.contains(&word.as_str());
        // `\operatorname{Tr}_B |a\rangle\langle a|`
        let is_state = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::Ket, _));
        let rest = *cursor..items.len();
        let inner = match reaches_on {
            true if items[rest.clone()].iter().any(is_state) => {
                *cursor = items.len();
                Some(self.term(&items[rest])?)
            }
            true => self.on_the_rest(items, cursor)?,
            false => {
                let head = *cursor - 1;
                let inner = self.on_the_next(items, cursor)?;
                has_a_clear_argument(items, head..*cursor, &word)?;
                inner
            }
        };
        let Some(inner) = inner else {
            return Ok(Some(self.template(&name, Vec::new(), item.span)));
        };
        let span = item.span.to(inner.span);
        Ok(Some(self.template(&format!("{name}(#)"), vec![inner], span)))
    }
}

/// Rejects `\log p/q` and `\log x^2`, as `\ln p/q` and `\ln x^2` are rejected. `reached` is the function and its argument.
fn has_a_clear_argument(items: &[Item], reached: Range<usize>, word: &str) -> Read<()> {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let head = &items[reached.start];
    let Some(argument) = items[reached.start + 1..reached.end].iter().find(|item| !is_space(item)) else {
        return Ok(());
    };
    if let Layout::Scripts { nucleus, sup: Some(_), .. } = &argument.layout
        && DOUBTFUL.contains(&word)
        && names::printed(nucleus, None).is_some_and(|printed| printed.name.base != "e")
    {
        let what = format!("\\{word} x^2 may be (\\{word} x)^2 or \\{word}(x^2)");
        let advice = format!("write (\\{word} x)^2 for the power of the function, or \\{word}(x^2)");
        return Err(Fault::ambiguous(head.span.to(argument.span), what).help(advice));
    }
    let Some(slash) = items[reached.end..].iter().position(|item| !is_space(item)).map(|at| reached.end + at) else {
        return Ok(());
    };
    // `\log x/\log 2` is a quotient of two logarithms.
    let below = items[slash + 1..].iter().find(|item| !is_space(item));
    let is_of_two =
        below.is_some_and(|below| printed(std::slice::from_ref(below)) == printed(std::slice::from_ref(head)));
    match joint(&items[slash]) == Some(Joint::Slash) && !matches!(argument.layout, Layout::Fence(..)) && !is_of_two {
        true => Err(slashes::after_a_function(items, head.span, slash)),
        false => Ok(()),
    }
}

/// The brackets around the arguments of a function; those of `\mathbb{E}[x]` are shown as they are.
fn brackets(delimiter: Delimiter) -> Option<(&'static str, &'static str)> {
    match delimiter {
        Delimiter::Round => Some(("(", ")")),
        Delimiter::Square => Some(("[", "]")),
        Delimiter::Curly => Some(("\\{", "\\}")),
        _ => None,
    }
}

/// Operators with a value before a parenthesis, whose power stands behind it.
const WITH_VALUE: [&str; 8] = ["det", "tr", "Tr", "trace", "Re", "Im", "real", "imag"];

/// Whether a factor is enclosed in square brackets, with a power perhaps.
fn is_in_brackets(item: Option<&Item>) -> bool {
    item.is_some_and(|item| {
        let fence = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { item };
        matches!(fence.layout, Layout::Fence(Delimiter::Square, _))
    })
}

/// Traces, which act on the rest of their term where they have an index.
const TRACES: [&str; 2] = ["Tr", "tr"];

/// Upright letters that are a mean value or a probability before square brackets.
const MEANS: [&str; 3] = ["E", "P", "V"];

/// Functions of which some authors raise the argument so.
const DOUBTFUL: [&str; 2] = ["log", "lg"];

/// The word that an operator is, with an index perhaps.
fn operator_name(head: &Item) -> Option<String> {
    let base = if let Layout::Scripts { nucleus, primes: 0, .. } = &head.layout { nucleus } else { head };
    match &base.layout {
        Layout::Text(word) => Some(word.clone()).filter(|word| !is_prose(word)),
        _ => operator_word(base),
    }
}

/// Whether an item may be the name of a function, `\max` or `\mathrm{erf}`.
pub(super) fn is_named(item: &Item) -> bool {
    match &item.layout {
        Layout::Scripts { nucleus, .. } => is_named(nucleus),
        Layout::Command(name) => FUNCTIONS.contains(&name.trim_start_matches('\\')),
        Layout::Style(style, _) => style == "\\mathrm",
        _ => false,
    }
}

/// Names of functions in other languages, and in a text, with the command that is known.
const OF_OTHERS: [(&str, &str); 11] = [
    ("sen", "sin"),
    ("tg", "tan"),
    ("ctg", "cot"),
    ("arctg", "arctan"),
    ("arcsen", "arcsin"),
    ("sh", "sinh"),
    ("ch", "cosh"),
    ("th", "tanh"),
    ("cth", "coth"),
    ("sinh", "sinh"),
    ("cosh", "cosh"),
];

/// Functions that have a command or an upright name, and no value here.
const FUNCTIONS: [&str; 44] = [
    "arginf", "argsup", "log", "lg", "max", "min", "minimum", "maximum", "minimize", "maximize", "sup", "inf", "arg",
    "argmax", "argmin", "sgn", "sign", "dim", "ker", "rank", "span", "erf", "erfc", "sinc", "gcd", "Pr", "hom", "Res",
    "Var", "Cov", "ad", "Ad", "div", "grad", "rot", "curl", "diag", "arctanh", "arcsinh", "arccosh", "sech", "csch",
    "coth", "cosech",
];
