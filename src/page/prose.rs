//! The prose of Markdown notes as HTML, with inline formulas. Raw HTML in notes is shown as text.

use maud::{Markup, PreEscaped, html};
use pulldown_cmark::{Event, Options, Parser};

use super::typeset;
use crate::notes::MacroDefinition;

/// A part of Markdown between two displays.
pub(super) fn markdown(text: &str, macros: &[MacroDefinition]) -> Markup {
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

/// Links to pages of the web stay; others, and pictures, are named by their address: a page loads nothing, and leads
/// nowhere that its reader does not see.
fn safe<'a>(events: impl Iterator<Item = Event<'a>>) -> impl Iterator<Item = Event<'a>> {
    use pulldown_cmark::{Tag, TagEnd};
    let mut open: Vec<Option<String>> = Vec::new();
    events.map(move |event| match &event {
        Event::Start(Tag::Link { dest_url, .. }) => {
            let is_web = dest_url.starts_with("https://") || dest_url.starts_with("http://");
            open.push((!is_web).then(String::new));
            if is_web { event } else { Event::Text("".into()) }
        }
        Event::Start(Tag::Image { dest_url, .. }) => {
            open.push(Some(format!(" ({dest_url})]")));
            Event::Text("[picture: ".into())
        }
        Event::End(TagEnd::Link | TagEnd::Image) => match open.pop().flatten() {
            Some(words) => Event::Text(words.into()),
            None => event,
        },
        _ => event,
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
