//! The prose of notes as HTML: Markdown with inline formulas; TeX as paragraphs. Raw HTML in notes is shown as text.

use maud::{Markup, PreEscaped, html};
use pulldown_cmark::{Event, Options, Parser};

use super::typeset;
use crate::notes::{Kind, MacroDefinition};

/// A part of the text between two displays.
pub(super) fn prose(text: &str, kind: Kind, macros: &[MacroDefinition]) -> Markup {
    match kind {
        Kind::Markdown => markdown(text, macros),
        _ => {
            let is_text = |line: &&str| !line.trim_start().starts_with(['%', '\\']);
            let plain: String = text.lines().filter(is_text).map(|line| format!("{line}\n")).collect();
            let paragraphs: Vec<&str> = plain.split("\n\n").map(str::trim).filter(|part| !part.is_empty()).collect();
            html! { @for paragraph in paragraphs { p { (inline(paragraph, macros)) } } }
        }
    }
}

fn markdown(text: &str, macros: &[MacroDefinition]) -> Markup {
    let options = Options::ENABLE_TABLES | Options::ENABLE_MATH;
    let events = Parser::new_ext(text, options).filter_map(|event| match event {
        Event::InlineMath(latex) => Some(Event::InlineHtml(in_line(&latex, macros).into_string().into())),
        Event::DisplayMath(latex) => Some(Event::InlineHtml(typeset::block(&latex, macros).into_string().into())),
        // A comment is for onshell; any other HTML is text.
        Event::Html(raw) | Event::InlineHtml(raw) if raw.trim_start().starts_with("<!--") => None,
        Event::Html(raw) | Event::InlineHtml(raw) => Some(Event::Text(raw)),
        other => Some(other),
    });
    let mut out = String::new();
    pulldown_cmark::html::push_html(&mut out, safe(events));
    // The corner of a table has no words: it heads nothing.
    let out = out.replace("<th></th>", "<td></td>");
    let box_of_table = "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"Table\"><table>";
    PreEscaped(out.replace("<table>", box_of_table).replace("</table>", "</table></div>"))
}

/// Links and pictures without their addresses: a page loads nothing and leads nowhere that the author did not check.
fn safe<'a>(events: impl Iterator<Item = Event<'a>>) -> impl Iterator<Item = Event<'a>> {
    use pulldown_cmark::{Tag, TagEnd};
    events.filter(|event| {
        !matches!(event, Event::Start(Tag::Link { .. } | Tag::Image { .. }) | Event::End(TagEnd::Link | TagEnd::Image))
    })
}

/// A line of text with formulas between dollar signs.
pub(super) fn inline(text: &str, macros: &[MacroDefinition]) -> Markup {
    let parts: Vec<&str> = text.split('$').collect();
    let is_paired = parts.len() % 2 == 1;
    html! {
        @for (at, part) in parts.iter().enumerate() {
            @if at % 2 == 1 && is_paired { (in_line(part, macros)) } @else { (part) }
        }
    }
}

/// The longest LaTeX of a formula that needs no box of its own on a phone.
const SHORT: usize = 34;

/// A formula in a line. A long one scrolls in a box of its own, because browsers do not break formulas.
fn in_line(latex: &str, macros: &[MacroDefinition]) -> Markup {
    let formula = typeset::inline(latex, macros);
    match latex.len() > SHORT {
        true => html! { span class="part" tabindex="0" role="group" aria-label="Formula" { (formula) } },
        false => formula,
    }
}
