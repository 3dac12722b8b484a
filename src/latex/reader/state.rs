//! The state of a reader, and the faults that all its parts report.

use crate::code::Code;
use crate::formula::IndexId;
use crate::formula::shape::{self, Shape};
use crate::formula::symbols::Symbols;
use crate::formula::tree::{Expr, Node, Sign};
use crate::source::{Fault, Span};

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
    let not_supported = |what: &str| {
        let fault = Fault::unsupported(span, format!("{what} is not supported"));
        match has_claims {
            true => fault.help("leave the equation out with \"skip\" in the claims file"),
            false => fault,
        }
    };
    match name {
        "\\log" => {
            Fault::ambiguous(span, "\\log x may be the natural logarithm, \\ln x, or the decimal one, \\ln x/\\ln 10")
                .help("write \\ln x, or \\frac{\\ln x}{\\ln 10}")
        }
        "\\pm" | "\\mp" => Fault::new(span, "± must stand where + or − can stand"),
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
        "\\underbrace" | "\\overbrace" => {
            Fault::unsupported(span, "a formula as the label of a brace is not supported")
                .help("write the label in \\text{…}, or remove the brace")
        }
        "\\cup" => Fault::unsupported(span, "\\cup joins families of symbols, and is supported under \"where\" only")
            .help("say under \"where\" what the name of the family means in this equation"),
        _ => {
            Fault::new(span, format!("the command {name} is unknown")).code(Code::UnknownCommand).help(match has_claims
            {
                true => "if it is your own macro, define it under \"macros\" in the claims file",
                false => "if it is your own macro, define it with \\newcommand, or under \"macros\" in a claims file",
            })
        }
    }
}

/// Whether a command prints an arrow.
fn is_arrow(name: &str) -> bool {
    let plain = name.trim_start_matches('\\').to_ascii_lowercase();
    plain.ends_with("arrow") || plain.ends_with("mapsto") || plain.contains("harpoon")
}
