//! `onshell read`: how a formula is understood.

use std::sync::Arc;

use serde_json::json;

use crate::Error;
use crate::check::define_macros;
use crate::formula::operators::Operator;
use crate::formula::symbols::Kind;
use crate::formula::{Expr, Node, Statement, Symbols, text};
use crate::latex::{Macros, read_display};
use crate::notes::{MacroDefinition, definitions};
use crate::report::{self, wrap};
use crate::source::{Source, Span};

use super::outcome::{Format, Outcome, Screen, shown};

/// Prints how a formula or an equation is understood
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell read '\\frac12 m v^2'")]
pub struct Arguments {
    /// The formula, in LaTeX; definitions of macros may stand before it
    #[arg(allow_hyphen_values = true)]
    formula: String,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments, screen: Screen) -> Outcome {
    let mut symbols = Symbols::for_reading();
    let mut macros = Macros::default();
    let definitions = definitions(&arguments.formula);
    define_macros(&definitions, &mut macros);
    let formula = without_comments(&without(&definitions, &arguments.formula));
    let reading = read_display(&formula, &mut symbols, &macros);
    let source = Arc::new(Source::new("formula", arguments.formula.as_str()));
    let (mut statements, mut errors): (Vec<String>, _) = (Vec::new(), Vec::new());
    let mut before: Option<Statement> = None;
    let mut without_value: Vec<String> = Vec::new();
    for statement in reading.statements {
        match statement {
            Ok(statement) => {
                let text = text::statement(&statement, &symbols);
                statement.members.iter().for_each(|member| collect_abstract(member, &symbols, &mut without_value));
                match (&before, statements.last_mut()) {
                    (Some(before), Some(last)) if statement.is_alternative_to(before) => {
                        last.push_str(&format!(" or {text}"));
                    }
                    _ => statements.push(text),
                }
                before = Some(statement);
            }
            Err(fault) => errors.push(Error::fault(&source, fault)),
        }
    }
    let assumed: Vec<String> = match errors.is_empty() {
        true => {
            let mut names = named(&symbols, &|kind| kind == Kind::Scalar);
            // The dx of an integral is no quantity of its own.
            let is_differential = |name: &str| {
                let rest = name.strip_prefix('d').unwrap_or_default();
                !rest.is_empty() && !rest.starts_with(['_', '\'', '^'])
            };
            names.retain(|name| !(formula.contains("int") && is_differential(name)));
            names
        }
        false => Vec::new(),
    };
    let mut inferred = symbols.inferred.said.clone();
    let complex = named(&symbols, &|kind| kind == Kind::Complex);
    let matrices = named(&symbols, &|kind| matches!(kind, Kind::Matrix(..)));
    let vectors = named(&symbols, &|kind| kind == Kind::Vector);
    let abstract_names = named(&symbols, &|kind| kind == Kind::Abstract);
    for (what, names) in [
        ("vectors or matrices, because of their markup", vectors),
        ("matrices, because of their use", matrices),
        ("complex numbers", complex),
        ("names that have no value here", abstract_names),
    ] {
        if !names.is_empty() {
            inferred.push(format!("{what}: {}", names.join(", ")));
        }
    }
    if symbols.is_abstract() {
        let which = match without_value.as_slice() {
            [] => String::new(),
            few if few.len() <= MOST_PARTS => format!(": {}", few.join(", ")),
            many => format!(": {} and {} more", many[..MOST_PARTS].join(", "), many.len() - MOST_PARTS),
        };
        inferred
            .push(format!("only the structure of the formula was read, because parts of it have no value here{which}"));
    }
    if !errors.is_empty() {
        inferred.clear();
    }
    let output = match arguments.format {
        Format::Text => {
            let mut lines: Vec<String> = statements.iter().map(|line| wrap("", line, 4, screen.out.width)).collect();
            if !assumed.is_empty() {
                lines.push(wrap("  assumed to be real numbers: ", &assumed.join(", "), 4, screen.out.width));
            }
            lines.extend(inferred.iter().map(|line| wrap("  inferred: ", line, 4, screen.out.width)));
            lines.iter().map(|line| format!("{line}\n")).collect()
        }
        Format::Json => {
            let mut output = json!({
                "schema": 1,
                "statements": statements,
                "assumed": assumed,
                "errors": errors.iter().map(report::json::error).collect::<Vec<_>>(),
            });
            if !inferred.is_empty() {
                output["inferred"] = json!(inferred);
            }
            format!("{output:#}\n")
        }
    };
    Outcome { output, messages: shown(&errors, screen), code: if errors.is_empty() { 0 } else { 2 } }
}

/// The most parts without a value that are named.
const MOST_PARTS: usize = 4;

/// Adds the outermost parts of a formula that have no value, as they are read.
fn collect_abstract(expr: &Expr, symbols: &Symbols, into: &mut Vec<String>) {
    let mut inner: Vec<Span> = Vec::new();
    expr.walk(&mut |part| {
        let is_abstract = match &part.node {
            Node::Apply(id, _) => {
                let entry = symbols.entry(*id);
                entry.operator == Some(Operator::Template) || entry.kind == Kind::Abstract
            }
            Node::Rest(_) => true,
            _ => false,
        };
        if is_abstract && !inner.iter().any(|whole| whole.contains(part.span)) {
            inner.push(part.span);
            let text = text::formula(part, symbols);
            if !into.contains(&text) {
                into.push(text);
            }
        }
    });
}

/// The quantities of one kind, without those that are no quantities: operators, letters of sums.
fn named(symbols: &Symbols, of: &dyn Fn(Kind) -> bool) -> Vec<String> {
    let quantities = symbols.iter().filter(|(_, entry)| of(entry.kind) && entry.operator.is_none() && !entry.hidden);
    quantities.map(|(_, entry)| text::plain(&entry.name.to_string())).collect()
}

/// The text with spaces in the place of its definitions, so that every byte keeps its position.
fn without(definitions: &[MacroDefinition], text: &str) -> String {
    let mut text = text.to_owned();
    for definition in definitions {
        text.replace_range(definition.span.range(), &" ".repeat(definition.span.range().len()));
    }
    text
}

/// The text with spaces in the place of its comments, each from a % to the end of its line, so that every byte keeps its position.
fn without_comments(text: &str) -> String {
    let mut kept = String::with_capacity(text.len());
    let (mut in_comment, mut escaped) = (false, false);
    for c in text.chars() {
        in_comment = (in_comment || c == '%' && !escaped) && c != '\n';
        escaped = c == '\\' && !escaped;
        match in_comment {
            true => kept.extend(std::iter::repeat_n(' ', c.len_utf8())),
            false => kept.push(c),
        }
    }
    kept
}
