//! LaTeX as MathML. What cannot be typeset is shown as its source.

use std::ops::Range;

use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

use super::math_marks::{self, Mark};
use super::mathml::tidied;
use crate::notes::MacroDefinition;

/// A display.
pub(super) fn block(latex: &str, macros: &[MacroDefinition]) -> Markup {
    typeset(&rows(latex), macros, DisplayMode::Block)
}

/// A display with marks on parts of it, or `None` if a part cannot be marked: it begins in one group and ends in another.
pub(super) fn marked(latex: &str, macros: &[MacroDefinition], parts: &[(Range<usize>, Mark)]) -> Option<Markup> {
    let marked = math_marks::put_in(latex, parts)?;
    mathml(&rows(&marked), macros, DisplayMode::Block).map(PreEscaped)
}

/// A formula in a line.
pub(super) fn inline(latex: &str, macros: &[MacroDefinition]) -> Markup {
    typeset(latex, macros, DisplayMode::Inline)
}

/// A display of several rows in an environment for them.
fn rows(latex: &str) -> String {
    let body = latex.trim().trim_end_matches("\\\\").trim_end();
    let has_rows = body.contains('&') || body.contains("\\\\");
    match has_rows && !body.starts_with("\\begin") {
        true => format!("\\begin{{aligned}} {body} \\end{{aligned}}"),
        false => body.to_owned(),
    }
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
    Some(math_marks::as_classes(&tidied(&mathml)))
}

/// Commands that the typesetter does not have, by those that it has.
fn familiar(latex: &str) -> String {
    latex
        .replace("\\bm{", "\\boldsymbol{")
        .replace("\\bm ", "\\boldsymbol ")
        .replace("\\lvert", "|")
        .replace("\\rvert", "|")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wrong_part_is_marked_where_it_is_typeset() {
        let latex = r"a = b - \frac{1}{2} c^2";
        let at = latex.find(r"\frac{1}{2}").unwrap_or_default();
        let shown = marked(latex, &[], &[(at..at + 11, Mark::Fault)]).map(maud::PreEscaped::into_string);
        let shown = shown.unwrap_or_default();
        assert!(shown.contains("<mrow class=\"fault\"><mfrac>"), "{shown}");
        assert_eq!(shown.matches("fault").count(), 1);
    }

    #[test]
    fn colours_of_the_author_are_left_out() {
        let shown = block(r"a = {\color{red} b}", &[]).into_string();
        assert!(!shown.contains("style=") && shown.contains("<mi>b</mi>"), "{shown}");
    }
}
