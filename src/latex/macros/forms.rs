//! Macros of packages whose text depends on what follows: derivatives, quantities in delimiters, matrices, functions with
//! a power.
//!
//! | macro | reading |
//! | --- | --- |
//! | `\dv{f}{x}`, `\dv[2]{f}{x}`, `\dv{x}` | a derivative; the same for `\od`, `\deriv` and their kin |
//! | `\pdv{f}{x}`, `\pdv{f}{x}{y}`, `\pdv{f}{x,y}` | a partial derivative; the same for `\pd`, `\pdiff`, … |
//! | `\dd{x}`, `\dd[3]{r}`, `\diff x` | a differential; `\diff{f}{x}` is a derivative |
//! | `\qty(…)`, `\qty[…]`, `\qty{…}` | delimiters; `\qty{3}{kg}` is a number with a unit |
//! | `\eval{f}_a^b`, `\order{x^3}` | the bar of an evaluation, a remainder |
//! | `\mqty(…)`, `\mqty[…]` | a matrix |
//! | `\pmatrix{a & b \cr c & d}` | a matrix, as plain TeX writes it; the same for `\matrix` and `\cases` |
//! | `\eqalign{a &= b \cr c &= d}` | rows, as plain TeX writes them; the same for `\displaylines` |
//! | `\sin[2](x)` | a power of a function |
//! | `\braket{a|b}`, `\braket{a}{b}` | a product of states |
//! | `\ev{A}`, `\expval{A}{\psi}` | a mean value, and one in a state |
//! | `\num{1e3}`, `\ang{45}` | a number, and an angle in degrees |

use crate::code::Code;
use crate::source::{Fault, Span};

use super::super::lexer::{Space, Token, TokenKind, tokens};
use super::parameters::{argument, bracketed, enclosed, group, is_next, star};
use super::{siunitx, substitute};

const TOTAL: [&str; 8] = ["dv", "derivative", "od", "odv", "deriv", "der", "dn", "fdiff"];
const PARTIAL: [&str; 9] =
    ["pdv", "partialderivative", "pderivative", "pd", "pdiff", "pder", "pderiv", "partd", "diffp"];
const FUNCTIONS: [&str; 9] = ["sin", "cos", "tan", "sinh", "cosh", "tanh", "sec", "csc", "cot"];
const OTHERS: [&str; 24] = [
    "dd",
    "differential",
    "diff",
    "qty",
    "quantity",
    "eval",
    "evaluated",
    "order",
    "mqty",
    "num",
    "ang",
    "e",
    "div",
    "genfrac",
    "braket",
    "Braket",
    "ev",
    "expval",
    "expectationvalue",
    "matrix",
    "pmatrix",
    "cases",
    "eqalign",
    "displaylines",
];

/// Whether a command is one of these.
pub(super) fn knows(name: &str) -> bool {
    name.strip_prefix('\\').is_some_and(|name| {
        [&TOTAL[..], &PARTIAL[..], &FUNCTIONS[..], &OTHERS[..]].iter().any(|names| names.contains(&name))
    })
}

/// A space that ends the argument of a function.
pub(super) fn thin_space(span: Span) -> Token {
    Token { kind: TokenKind::Space(Space::Thin), span }
}

/// The text of one of these macros; `None` where the command has its usual meaning. Arguments are as in
/// [`super::packages::expansion`].
///
/// # Errors
/// For an argument that is missing or has no meaning.
pub(super) fn expansion(
    name: &str,
    span: Span,
    pending: &mut Vec<Token>,
    before: Option<&Token>,
) -> Result<Option<Vec<Token>>, Fault> {
    let Some(name) = name.strip_prefix('\\') else { return Ok(None) };
    let form = Form { name, span };
    Ok(match name {
        _ if TOTAL.contains(&name) => Some(form.derivative("\\mathrm{d}", pending)?),
        _ if PARTIAL.contains(&name) => Some(form.derivative("\\partial", pending)?),
        _ if FUNCTIONS.contains(&name) => form.function(pending),
        "braket" | "Braket" => Some(form.states(pending)?),
        "ev" | "expval" | "expectationvalue" => Some(form.mean(pending)?),
        "dd" | "differential" | "diff" => Some(form.differential(pending, before)?),
        "qty" | "quantity" => Some(form.quantity(pending)?),
        "eval" | "evaluated" => Some(form.with("\\left.#1\\right|", pending)?),
        "order" => Some(form.with("\\mathcal{O}\\left(#1\\right)", pending)?),
        "mqty" => Some(form.matrix(pending)?),
        "matrix" | "pmatrix" | "cases" => {
            let body = format!("\\begin{{{name}}}#1\\end{{{name}}}");
            group(pending).map(|rows| form.text(&body, &[rows]))
        }
        "eqalign" | "displaylines" => {
            let rows = form.needed(pending)?;
            Some(form.text("\\begin{aligned}#1\\end{aligned}", &[rows]))
        }
        "num" => Some(form.number(pending)?),
        "ang" => Some(form.with("{#1}^{\\circ}", pending)?),
        "e" if is_next(pending, &TokenKind::Super) => Some(form.text("\\mathrm{e}", &[])),
        "div" if starts_a_formula(before) => Some(form.text("\\nabla\\cdot", &[])),
        "genfrac" => {
            for _ in 0..4 {
                form.needed(pending)?;
            }
            Some(form.text("\\frac", &[]))
        }
        _ => None,
    })
}

/// Whether nothing stands before that could be divided: `= \div \vec E`, where ÷ has no meaning.
fn starts_a_formula(before: Option<&Token>) -> bool {
    before.is_none_or(|token| {
        matches!(
            &token.kind,
            TokenKind::Open | TokenKind::Align | TokenKind::Row | TokenKind::Other('=' | '+' | '-' | '(' | '[')
        )
    })
}

struct Form<'a> {
    name: &'a str,
    span: Span,
}

impl Form<'_> {
    fn text(&self, body: &str, values: &[Vec<Token>]) -> Vec<Token> {
        substitute(&tokens(body), values, self.span)
    }

    fn needed(&self, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        argument(pending).ok_or_else(|| {
            Fault::new(self.span, format!("an argument of \\{} is missing", self.name))
                .code(Code::UnknownCommand)
                .help("write each argument in braces, and close them")
        })
    }

    /// One argument in braces, in parentheses or in brackets, put into a text.
    fn with(&self, body: &str, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        star(pending);
        let value = match round(pending).or_else(|| bracketed(pending)) {
            Some(value) => value,
            None => self.needed(pending)?,
        };
        Ok(self.text(body, &[value]))
    }

    /// `\dv[n]{f}{x}`, `\dv{x}`, `\pdv{f}{x}{y}`, with `d` for the sign of the derivative.
    fn derivative(&self, d: &str, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        star(pending);
        let order = bracketed(pending);
        let first = self.needed(pending)?;
        let Some(second) = group(pending).or_else(|| self.single(&first, pending)) else {
            return Ok(match order {
                None => self.text(&format!("\\frac{{{d}}}{{{d} #1}}"), &[first]),
                Some(order) => self.text(&format!("\\frac{{{d}^{{#2}}}}{{{d} {{#1}}^{{#2}}}}"), &[first, order]),
            });
        };
        let third = if d == "\\partial" && order.is_none() { group(pending) } else { None };
        let by: Vec<Vec<Token>> = match &third {
            Some(third) => vec![second, third.clone()],
            None => split_at_commas(&second),
        };
        Ok(match (by.as_slice(), order) {
            ([by], None) => self.text(&format!("\\frac{{{d} #1}}{{{d} #2}}"), &[first, by.clone()]),
            ([by], Some(order)) => {
                let body = format!("\\frac{{{d}^{{#3}} #1}}{{{d} {{#2}}^{{#3}}}}");
                self.text(&body, &[first, by.clone(), order])
            }
            (several, order) => {
                let count = order.is_none().then(|| several.len().to_string());
                let mut below = Vec::new();
                for by in several {
                    below.extend(self.text(&format!("{d} #1"), std::slice::from_ref(by)));
                }
                let order = match (order, count) {
                    (None, Some(count)) => self.text(&count, &[]),
                    (order, _) => order.unwrap_or_default(),
                };
                self.text(&format!("\\frac{{{d}^{{#3}} #1}}{{#2}}"), &[first, below, order])
            }
        })
    }

    /// The second argument of `\pd fx`, where the first is a single token too.
    fn single(&self, first: &[Token], pending: &mut Vec<Token>) -> Option<Vec<Token>> {
        let is_letter = |token: &Token| matches!(token.kind, TokenKind::Letter(_));
        let short = ["pd", "od", "pdiff"].contains(&self.name);
        let both = matches!(first, [only] if is_letter(only)) && pending.last().is_some_and(is_letter);
        (short && both).then(|| pending.pop().map(|token| vec![token])).flatten()
    }

    /// `\dd{x}`, `\dd[3]{r}`, `\dd x`; `\diff{f}{x}` is a derivative.
    fn differential(&self, pending: &mut Vec<Token>, before: Option<&Token>) -> Result<Vec<Token>, Fault> {
        if self.name == "diff" && two_groups(pending) {
            return self.derivative("\\mathrm{d}", pending);
        }
        let power = bracketed(pending);
        let mut found = Vec::new();
        let starts = before.is_none_or(|token| matches!(token.kind, TokenKind::Open));
        if !starts {
            found.push(thin_space(self.span));
        }
        found.extend(match power {
            Some(power) => self.text("\\mathrm{d}^{#1}", &[power]),
            None => self.text("\\mathrm{d}", &[]),
        });
        if let Some(inner) = group(pending) {
            let single =
                inner.len() == 1 || matches!(inner.first().map(|first| &first.kind), Some(TokenKind::Command(_)));
            match single {
                true => found.extend(inner),
                false => found.extend(self.text("{#1}", &[inner])),
            }
        }
        Ok(found)
    }

    fn quantity(&self, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        if two_groups(pending) {
            return siunitx::quantity("\\qty", self.span, pending);
        }
        let bar = TokenKind::Other('|');
        let found = if let Some(inner) = round(pending) {
            ("\\left(#1\\right)", inner)
        } else if let Some(inner) = bracketed(pending) {
            ("\\left[#1\\right]", inner)
        } else if let Some(inner) = enclosed(pending, &bar, &bar) {
            ("\\left|#1\\right|", inner)
        } else {
            ("\\left\\{#1\\right\\}", self.needed(pending)?)
        };
        Ok(self.text(found.0, &[found.1]))
    }

    fn matrix(&self, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        let bar = TokenKind::Other('|');
        let (environment, inner) = if let Some(inner) = round(pending) {
            ("pmatrix", inner)
        } else if let Some(inner) = bracketed(pending) {
            ("bmatrix", inner)
        } else if let Some(inner) = enclosed(pending, &bar, &bar) {
            ("vmatrix", inner)
        } else {
            ("matrix", self.needed(pending)?)
        };
        Ok(self.text(&format!("\\begin{{{environment}}}#1\\end{{{environment}}}"), &[inner]))
    }

    /// `\sin[2](x)`.
    fn function(&self, pending: &mut Vec<Token>) -> Option<Vec<Token>> {
        let [.., round, close, digit, open] = pending.as_slice() else { return None };
        let is_power = open.kind == TokenKind::Other('[')
            && matches!(digit.kind, TokenKind::Digit('1'..='9'))
            && close.kind == TokenKind::Other(']')
            && round.kind == TokenKind::Other('(');
        let digit = digit.clone();
        is_power.then(|| {
            pending.truncate(pending.len() - 3);
            // The command itself must not be taken for a macro again: it stands before a power now.
            let mut found = vec![Token { kind: TokenKind::Command(format!("\\{}", self.name)), span: self.span }];
            found.extend(self.text("^{#1}", &[vec![digit]]));
            found
        })
    }

    /// `\braket{a|b}` of the package braket, `\braket{a}{b}` of physics. One state alone is a mean value in the first and
    /// a product with itself in the second.
    fn states(&self, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        star(pending);
        let first = self.needed(pending)?;
        let is_bar = |token: &Token| match &token.kind {
            TokenKind::Other('|') => true,
            TokenKind::Command(name) => ["\\vert", "\\mid", "\\middle"].contains(&name.as_str()),
            _ => false,
        };
        if first.iter().any(is_bar) {
            return Ok(self.text("\\langle #1\\rangle", &[first]));
        }
        match group(pending) {
            Some(second) => Ok(self.text("\\langle #1|#2\\rangle", &[first, second])),
            None => Err(Fault::ambiguous(
                self.span,
                format!("\\{} with one state may be a mean value or a product of the state with itself", self.name),
            )
            .help("write \\langle a \\rangle or \\langle a | a \\rangle")),
        }
    }

    /// `\ev{A}`, `\ev{A}{\psi}`.
    fn mean(&self, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        star(pending);
        let inner = self.needed(pending)?;
        Ok(match group(pending) {
            Some(state) => self.text("\\langle #2|#1|#2\\rangle", &[inner, state]),
            None => self.text("\\langle #1\\rangle", &[inner]),
        })
    }

    /// `\num{1.5e3}`.
    fn number(&self, pending: &mut Vec<Token>) -> Result<Vec<Token>, Fault> {
        let inner = self.needed(pending)?;
        siunitx::number(&inner, self.span)
    }
}

/// The parts between the commas that stand in no parenthesis and no group: `x,y`, `\dot\phi(t, x)`.
fn split_at_commas(tokens: &[Token]) -> Vec<Vec<Token>> {
    let mut depth = 0_i32;
    let mut parts = vec![Vec::new()];
    for token in tokens {
        match token.kind {
            TokenKind::Open | TokenKind::Other('(' | '[') => depth += 1,
            TokenKind::Close | TokenKind::Other(')' | ']') => depth -= 1,
            TokenKind::Other(',') if depth == 0 => {
                parts.push(Vec::new());
                continue;
            }
            _ => {}
        }
        if let Some(part) = parts.last_mut() {
            part.push(token.clone());
        }
    }
    parts
}

/// Takes `(…)` if it is next, without the parentheses.
fn round(pending: &mut Vec<Token>) -> Option<Vec<Token>> {
    enclosed(pending, &TokenKind::Other('('), &TokenKind::Other(')'))
}

/// Whether two groups in braces are next.
fn two_groups(pending: &[Token]) -> bool {
    let mut depth = 0_i32;
    let end = pending.iter().rev().position(|token| {
        depth += i32::from(token.kind == TokenKind::Open) - i32::from(token.kind == TokenKind::Close);
        depth <= 0
    });
    let second = end.and_then(|end| pending.len().checked_sub(end + 2)).and_then(|at| pending.get(at));
    is_next(pending, &TokenKind::Open) && second.is_some_and(|token| token.kind == TokenKind::Open)
}

#[cfg(test)]
mod tests {
    use super::super::Macros;
    use super::*;

    fn kinds(text: &str) -> Vec<TokenKind> {
        let found = Macros::default().expand(tokens(text)).unwrap();
        found.into_iter().map(|token| token.kind).filter(|kind| *kind != TokenKind::Space(Space::Thin)).collect()
    }

    #[test]
    fn short_forms_are_read_as_what_they_print() {
        for (short, long) in [
            ("\\dv{f}{x}", "\\frac{\\mathrm{d} f}{\\mathrm{d} x}"),
            ("\\dv[2]{f}{x}", "\\frac{\\mathrm{d}^{2} f}{\\mathrm{d} {x}^{2}}"),
            ("\\dv{x}(f)", "\\frac{\\mathrm{d}}{\\mathrm{d} x}(f)"),
            ("\\pdv{L}{\\dot q}", "\\frac{\\partial L}{\\partial \\dot q}"),
            ("\\pdv{f}{x}{y}", "\\frac{\\partial^{2} f}{\\partial x\\partial y}"),
            ("\\pdv{f}{x,y}", "\\frac{\\partial^{2} f}{\\partial x\\partial y}"),
            ("\\pd fx", "\\frac{\\partial f}{\\partial x}"),
            ("\\diff{f}{x}", "\\frac{\\mathrm{d} f}{\\mathrm{d} x}"),
            ("f \\dd{x}", "f \\mathrm{d}x"),
            ("f \\dd[3]{r}", "f \\mathrm{d}^{3}r"),
            ("\\qty(a + b)^2", "\\left(a + b\\right)^2"),
            ("\\qty[a(b) + c]", "\\left[a(b) + c\\right]"),
            ("\\mqty(a & b \\\\ c & d)", "\\begin{pmatrix}a & b \\\\ c & d\\end{pmatrix}"),
            ("\\sin[2](x)", "\\sin^{2}(x)"),
            ("\\num{1.5e3}", "1.5\\cdot 10^{3}"),
            ("\\ket{\\psi}", "|\\psi\\rangle"),
            ("\\braket{a|b}", "\\langle a|b\\rangle"),
            ("\\braket{a}{b}", "\\langle a|b\\rangle"),
            ("\\ev{A}{b}", "\\langle b|A|b\\rangle"),
            ("\\mel{a}{B}{c}", "\\langle a|B|c\\rangle"),
            ("\\pdv{f}{u(t, x)}", "\\frac{\\partial f}{\\partial u(t, x)}"),
            ("\\order{h^3}", "\\mathcal{O}\\left(h^3\\right)"),
            ("= \\div \\vec E", "= \\nabla\\cdot \\vec E"),
            ("\\vb{a} \\vdot \\vu{n}", "\\mathbf{a} \\cdot \\hat{n}"),
        ] {
            assert_eq!(kinds(short), kinds(long), "{short}");
        }
        // must-fail cases: a sign of division, a unit, an argument that is missing, what has its usual meaning
        assert_eq!(
            kinds("a \\div b"),
            vec![TokenKind::Letter('a'), TokenKind::Command("\\div".into()), TokenKind::Letter('b')]
        );
        assert_ne!(kinds("\\pdv{f}{x}{y}"), kinds("\\pdv{f}{y}{x}"));
        assert_eq!(kinds("\\sin[2x]").len(), 5);
        for broken in ["\\qty{3}{celsius", "\\SI{3}{\\celsius}", "\\braket{a}", "\\dv", "\\pdv{", "\\vb"] {
            assert!(Macros::default().expand(tokens(broken)).is_err(), "{broken}");
        }
    }
}
