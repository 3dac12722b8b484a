//! The state of a reader, and the faults that all its parts report.

use crate::code::Code;
use crate::formula::IndexId;
use crate::formula::shape::{self, Shape};
use crate::formula::symbols::Symbols;
use crate::formula::tree::{Expr, Node, Sign};
use crate::formula::units::Unit;
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout};

/// The result of reading a part of a formula.
pub(super) type Read<T> = Result<T, Fault>;

/// The reader of layout items, with the symbols of a document.
pub(in super::super) struct Reader<'a> {
    pub symbols: &'a mut Symbols,
    /// The sign that `\pm` stands for, if it is allowed.
    pub branch: Option<Sign>,
    /// The indices of the sums that are being read, outermost first.
    pub(super) summed: Vec<IndexId>,
    /// The undeclared letters that the sums being read bind.
    pub(super) bound: Vec<String>,
    /// How many factors that are being read stand in one another: `\sin\sin\sin x` has four.
    pub(super) depth: usize,
}

impl<'a> Reader<'a> {
    /// A reader of formulas; `branch` is the sign that `\pm` stands for.
    pub fn new(symbols: &'a mut Symbols, branch: Option<Sign>) -> Self {
        Reader { symbols, branch, summed: Vec::new(), bound: Vec::new(), depth: 0 }
    }
}

impl Reader<'_> {
    /// The shape of a formula inside the sums that are being read.
    pub(super) fn shape_of(&self, expr: &Expr) -> Read<Shape> {
        let within = |body: Expr, index: &IndexId| {
            let span = body.span;
            Expr::new(Node::over(*index, body), span)
        };
        match self.summed.as_slice() {
            [] => shape::shape_of(expr, self.symbols),
            summed => shape::shape_of(&summed.iter().fold(expr.clone(), within), self.symbols),
        }
    }
}

/// The fault for a command that has no meaning where it stands. `has_claims` says whether a claims file declares the symbols,
/// so that it can leave the equation out.
pub(super) fn unknown_command(name: &str, span: Span, has_claims: bool) -> Fault {
    let not_supported =
        |what: &str| Fault::unsupported(span, format!("{what} is not supported")).help(otherwise(has_claims));
    match name {
        "\\log" => {
            Fault::ambiguous(span, "\\log x may be the natural logarithm, \\ln x, or the decimal one, \\ln x/\\ln 10")
                .help("write \\ln x, or \\frac{\\ln x}{\\ln 10}")
        }
        "\\pm" | "\\mp" => Fault::new(span, "± can stand only where + or − can stand").help("write a term after the sign"),
        "\\partial" | "\\nabla" | "\\prod" | "\\iint" | "\\iiint" | "\\oint" | "\\oiint" => not_supported(name),
        "\\forall" | "\\exists" | "\\subset" | "\\subseteq" | "\\supset" | "\\cap" | "\\emptyset" => {
            not_supported(name)
        }
        "\\in" | "\\notin" | "\\ni" => {
            Fault::unsupported(span, format!("{name} is not supported")).help(match has_claims {
                true => "declare the range of the symbol in the claims file, and leave this out with \"skip\"",
                false => "declare the range of the symbol in a claims file",
            })
        }
        _ if is_arrow(name) => {
            Fault::unsupported(span, "an arrow between two formulas is not supported").help(match has_claims {
                true => "write an equation, or leave this out with \"skip\" in the claims file",
                false => "write an equation",
            })
        }
        _ if is_relation(name) => Fault::unsupported(span, format!("{name} is not supported here"))
            .help("write a relation outside of all braces, parentheses and commands"),
        "\\angle" | "\\measuredangle" => Fault::unsupported(span, "an angle between three points is not supported")
            .help("give the angle a letter, such as \\theta"),
        "\\bmod" | "\\pmod" | "\\mod" => Fault::unsupported(span, "the remainder of a division is not supported here")
            .help("write a = b + k n, with a whole number k"),
        "\\times" | "\\cdot" => Fault::unsupported(span, format!("{name} cannot have a subscript or superscript"))
            .help("remove it, or write the product as a function of its two factors"),
        "\\AsciiMath" => Fault::unsupported(span, "this is AsciiMath, which is not read").help(
            "write LaTeX, with [latexmath] before the block, or with the line “:stem: latexmath” at the top of the document",
        ),
        "\\TypstNotUnderstood" | "\\TypstEscape" | "\\TypstSign" => {
            Fault::unsupported(span, "this Typst notation is not supported")
                .help("correct the formula, or write it in another way")
        }
        "\\TypstUnclosed" => Fault::new(span, "a parenthesis or a quotation mark of this formula is never closed")
            .help("add what closes it"),
        "\\TypstText" => Fault::unsupported(span, "words inside of a formula are not supported here")
            .help("write words outside of the formula"),
        _ if name.starts_with("\\Typst") => {
            let word = name.trim_start_matches("\\Typst");
            Fault::new(span, format!("“{word}” is not a symbol or function of Typst that is supported"))
                .code(Code::UnknownCommand)
                .help("write a name of several letters in quotation marks, as a subscript: x_\"name\"")
        }
        "\\over" => Fault::unsupported(span, "\\over needs braces around its fraction, and can stand in them only once")
            .help("write {a \\over b}, or \\frac{a}{b}"),
        "\\[" => Fault::new(span, "\\[ opens a display inside of another one")
            .help("close the display before it with \\]"),
        _ if WITHOUT_VALUE.contains(&name) => {
            Fault::unsupported(span, format!("{name} cannot be evaluated here")).help(match has_claims {
                true => "write the formula without it, or leave the equation out with \"skip\" in the claims file",
                false => "write the formula without it",
            })
        }
        "\\sim" => Fault::unsupported(span, "∼ is not supported").help("write = or \\approx"),
        "\\underbrace" | "\\overbrace" => {
            Fault::unsupported(span, "a formula as the label of a brace is not supported")
                .help("write the label in \\text{…}, or remove the brace")
        }
        "\\overset" | "\\underset" | "\\stackrel" => Fault::new(span, format!("{name} is not supported here"))
            .code(Code::UnknownCommand)
            .help("write only the symbol or the relation; a mark above a symbol can be \\dot, \\ddot, \\vec, \\hat, \\tilde or \\bar"),
        "\\cup" => Fault::unsupported(span, "\\cup joins families of symbols, and is supported under \"where\" only")
            .help("say under \"where\" what the name of the family means in this equation"),
        _ => {
            Fault::new(span, format!("the command {name} is unknown")).code(Code::UnknownCommand).help(match has_claims
            {
                true => {
                    "correct it or leave it out; if it is your own macro, define it under \"macros\" in the claims \
                     file"
                }
                false => {
                    "correct it or leave it out; if it is your own macro, define it with \\newcommand, or under \
                     \"macros\" in a claims file"
                }
            })
        }
    }
}

/// Functions and operators that are read for their structure only.
const WITHOUT_VALUE: [&str; 14] = [
    "\\binom", "\\dbinom", "\\tbinom", "\\max", "\\min", "\\sup", "\\inf", "\\arg", "\\gcd", "\\deg", "\\limsup",
    "\\liminf", "\\lceil", "\\lfloor",
];

/// The advice on a notation that has no other name.
fn otherwise(has_claims: bool) -> &'static str {
    match has_claims {
        true => "write the formula without it, or leave the equation out with \"skip\" in the claims file",
        false => "write the formula without it",
    }
}

/// The advice to leave an equation out.
fn left_out(has_claims: bool) -> &'static str {
    match has_claims {
        true => "leave the equation out with \"skip\" in the claims file",
        false => "write the product out, as in 4 \\cdot 3 \\cdot 2",
    }
}

/// A sign of Unicode as LaTeX.
fn in_latex(c: char) -> Option<&'static str> {
    Some(match c {
        '²' => "^2 in place of it",
        '³' => "^3 in place of it",
        '¹' => "^1 in place of it",
        '⁴' => "^4 in place of it",
        '½' => "\\frac12",
        '¼' => "\\frac14",
        '¾' => "\\frac34",
        '⅓' => "\\frac13",
        '√' => "\\sqrt{x}, with braces around all that is under the root",
        'µ' | 'μ' => "\\mu",
        '\\' => "a command after the backslash, or remove it",
        _ => return None,
    })
}

/// Whether a command compares two formulas.
fn is_relation(name: &str) -> bool {
    ["\\leq", "\\geq", "\\neq", "\\equiv", "\\approx", "\\propto", "\\simeq", "\\ll", "\\gg"].contains(&name)
}

/// Whether a command prints an arrow.
fn is_arrow(name: &str) -> bool {
    let plain = name.trim_start_matches('\\').to_ascii_lowercase();
    plain.ends_with("arrow") || plain.ends_with("mapsto") || plain.contains("harpoon")
}

/// The fault of an item that is no formula by itself.
pub(super) fn unread(item: &Item, has_claims: bool) -> Fault {
    let span = item.span;
    match &item.layout {
        Layout::Scripts { nucleus, sub, .. } => match (&nucleus.layout, sub) {
            (Layout::Fault(fault), _) => fault.clone(),
            (Layout::Command(name), _) => unknown_command(name, nucleus.span, has_claims),
            (_, Some(sub)) => {
                Fault::unsupported(sub.span, "only a symbol, a vector or a 3×3 matrix can have a subscript")
                    .help("remove the subscript, or give the formula a name of its own")
            }
            _ => Fault::unsupported(span, "only a symbol can have a prime")
                .help("remove the prime, or give the formula a name of its own"),
        },
        Layout::Command(name) => unknown_command(name, span, has_claims),
        Layout::Style(name, _) | Layout::Accent(name, _) => {
            Fault::unsupported(span, format!("{name} can mark only one name"))
                .help(format!("write it before each name, as in {name}{{F}} = m {name}{{a}}"))
        }
        Layout::Text(word) if ["or", "oder", "ou"].contains(&word.as_str()) => {
            Fault::unsupported(span, format!("“{word}” between formulas is not supported"))
                .help("write each case as an equation of its own")
        }
        Layout::Text(word) if Unit::named(word).is_some() => {
            Fault::unsupported(span, "a unit after a letter or a formula is not supported").help(match has_claims {
                true => "remove the unit, or say under \"units\" in the claims file which unit the symbol has",
                false => "remove the unit, or write it after a number",
            })
        }
        Layout::Text(word) => {
            let message = format!("“{word}” is no unit, and words inside of a formula are not supported here");
            Fault::unsupported(span, message).help(
                "write words outside of the formula, and a quantity as a letter with a subscript, such as E_{kin}",
            )
        }
        Layout::Space(_) => Fault::unsupported(span, "a superscript or subscript cannot stand after a space")
            .help("remove the space, as in 25^\\circ"),
        Layout::Other(',') => Fault::unsupported(span, "a comma is not supported here")
            .help("write an equation for each value; write numbers as 1000 and 1.5"),
        Layout::Other('.' | '…') => Fault::unsupported(span, "a point or … between formulas is not supported")
            .help("write \\cdot for a product, and all terms in place of an ellipsis"),
        Layout::Other('!') => Fault::unsupported(span, "a factorial is not supported").help(left_out(has_claims)),
        Layout::Other(c) => {
            let fault = Fault::unsupported(span, format!("“{c}” is not supported here"));
            match in_latex(*c) {
                Some(latex) => fault.help(format!("write {latex}")),
                None if matches!(c, '=' | '<' | '>') => {
                    fault.help("write a relation outside of all braces, parentheses and commands")
                }
                None if *c == ':' => fault.help("write labels and words outside of the formula"),
                None => fault.help(otherwise(has_claims)),
            }
        }
        _ => Fault::unsupported(span, "this notation is not supported here").help(otherwise(has_claims)),
    }
}
