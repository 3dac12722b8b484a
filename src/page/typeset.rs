//! LaTeX as MathML. What cannot be typeset is shown as its source.

use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

use crate::notes::MacroDefinition;

/// A display.
pub(super) fn block(latex: &str, macros: &[MacroDefinition]) -> Markup {
    let body = latex.trim().trim_end_matches("\\\\").trim_end();
    let has_rows = body.contains('&') || body.contains("\\\\");
    let body = match has_rows && !body.starts_with("\\begin") {
        true => format!("\\begin{{aligned}} {body} \\end{{aligned}}"),
        false => body.to_owned(),
    };
    typeset(&body, macros, DisplayMode::Block)
}

/// A formula in a line.
pub(super) fn inline(latex: &str, macros: &[MacroDefinition]) -> Markup {
    typeset(latex, macros, DisplayMode::Inline)
}

fn typeset(latex: &str, macros: &[MacroDefinition], display_mode: DisplayMode) -> Markup {
    match mathml(latex, macros, display_mode) {
        Some(mathml) => PreEscaped(mathml),
        None => html! { code class="untypeset" { (latex) } },
    }
}

fn mathml(latex: &str, macros: &[MacroDefinition], display_mode: DisplayMode) -> Option<String> {
    let mut text = String::new();
    for definition in macros.iter().filter(|definition| latex.contains(&definition.name)) {
        let arguments: String = (1..=definition.arguments).map(|at| format!("#{at}")).collect();
        text.push_str(&format!("\\def{}{arguments}{{{}}}", definition.name, definition.body));
    }
    text.push_str(&familiar(latex));
    let storage = Storage::new();
    if Parser::new(&text, &storage).any(|event| event.is_err()) {
        return None;
    }
    let storage = Storage::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut mathml = String::new();
    push_mathml(&mut mathml, Parser::new(&text, &storage), config).ok()?;
    Some(escaped(&mathml))
}

/// The typesetter writes an operator such as < as it is; in HTML it is the start of a tag.
fn escaped(mathml: &str) -> String {
    mathml.replace("><</", ">&lt;</").replace(">></", ">&gt;</").replace(">&</", ">&amp;</")
}

/// Commands that the typesetter does not have, by those that it has.
fn familiar(latex: &str) -> String {
    latex
        .replace("\\bm{", "\\boldsymbol{")
        .replace("\\bm ", "\\boldsymbol ")
        .replace("\\lvert", "|")
        .replace("\\rvert", "|")
}
