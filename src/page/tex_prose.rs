//! The prose of a TeX document as HTML: headings, paragraphs, lists, emphasis, quotes. What has no counterpart leaves its
//! words behind. A part may begin or end inside of a list, because displays interrupt it.

use maud::{Markup, html};

use super::prose::inline;
use crate::notes::MacroDefinition;

/// What a paragraph of the source is.
enum Block {
    Heading(u8, String),
    Paragraph(String),
    Item(String),
}

/// A part of the text between two displays.
pub(super) fn prose(text: &str, macros: &[MacroDefinition]) -> Markup {
    let body = text.split_once("\\begin{document}").map_or(text, |(_, body)| body);
    let body = body.split("\\end{document}").next().unwrap_or_default();
    let blocks = blocks(body);
    let mut shown: Vec<Markup> = Vec::new();
    let mut at = 0;
    while let Some(block) = blocks.get(at) {
        match block {
            Block::Heading(1, title) => shown.push(html! { h2 { (styled(title, macros)) } }),
            Block::Heading(_, title) => shown.push(html! { h3 { (styled(title, macros)) } }),
            Block::Paragraph(text) => shown.push(html! { p { (styled(text, macros)) } }),
            Block::Item(_) => {
                let items = blocks[at..].iter().map_while(|block| match block {
                    Block::Item(text) => Some(styled(text, macros)),
                    _ => None,
                });
                let items: Vec<Markup> = items.collect();
                at += items.len() - 1;
                shown.push(html! { ul { @for item in items { li { (item) } } } });
            }
        }
        at += 1;
    }
    html! { @for block in shown { (block) } }
}

/// The text without comments, in blocks.
fn blocks(text: &str) -> Vec<Block> {
    const HEADINGS: [(&str, u8); 6] = [
        ("\\chapter", 1),
        ("\\section", 1),
        ("\\subsection", 2),
        ("\\subsubsection", 2),
        ("\\paragraph", 2),
        ("\\part", 1),
    ];
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = String::new();
    let mut is_item = false;
    let mut close = |open: &mut String, is_item: &mut bool, heading: Option<Block>| {
        let text = std::mem::take(open).trim().to_owned();
        if text.chars().any(char::is_alphanumeric) || text.contains('$') {
            blocks.push(if *is_item { Block::Item(text) } else { Block::Paragraph(text) });
        }
        *is_item = false;
        blocks.extend(heading);
    };
    for line in text.lines() {
        let line = uncommented(line).trim();
        let heading = HEADINGS.iter().find_map(|(command, level)| {
            let rest = line.strip_prefix(command)?.trim_start_matches('*').strip_prefix('{')?;
            let end = closing(rest)?;
            Some((Block::Heading(*level, rest[..end].to_owned()), &rest[end + 1..]))
        });
        let is_preamble = [
            "\\documentclass",
            "\\usepackage",
            "\\newcommand",
            "\\renewcommand",
            "\\def",
            "\\title{",
            "\\author{",
            "\\date{",
        ];
        if let Some((heading, rest)) = heading {
            close(&mut open, &mut is_item, Some(heading));
            open.push_str(rest);
        } else if line.is_empty() || line.starts_with("\\begin{") || line.starts_with("\\end{") {
            close(&mut open, &mut is_item, None);
        } else if let Some(rest) = line.strip_prefix("\\item") {
            close(&mut open, &mut is_item, None);
            is_item = true;
            open.push_str(rest.trim_start());
        } else if !is_preamble.iter().any(|command| line.starts_with(command)) {
            open.push(' ');
            open.push_str(line);
        }
    }
    close(&mut open, &mut is_item, None);
    blocks
}

/// A line without its comment.
fn uncommented(line: &str) -> &str {
    let mut before = ' ';
    for (at, c) in line.char_indices() {
        if c == '%' && before != '\\' {
            return &line[..at];
        }
        before = c;
    }
    line
}

/// The place of the brace that closes a group whose opening brace is before the text.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => return Some(at),
            '}' => depth -= 1,
            _ => {}
        }
    }
    None
}

/// Commands with their argument, and what becomes of it.
const STYLES: [(&str, &str); 6] = [
    ("\\emph{", "em"),
    ("\\textit{", "em"),
    ("\\textbf{", "strong"),
    ("\\texttt{", "code"),
    ("\\underline{", "em"),
    ("\\text{", ""),
];

/// A text with emphasis and formulas.
fn styled(text: &str, macros: &[MacroDefinition]) -> Markup {
    let first = STYLES.iter().filter_map(|(command, tag)| Some((outside(text, command)?, *command, *tag))).min();
    if let Some((at, command, tag)) = first {
        let rest = &text[at + command.len()..];
        if let Some(end) = closing(rest) {
            let inner = styled(&rest[..end], macros);
            let inner = match tag {
                "em" => html! { em { (inner) } },
                "strong" => html! { strong { (inner) } },
                "code" => html! { code { (inner) } },
                _ => inner,
            };
            return html! { (styled(&text[..at], macros)) (inner) (styled(&rest[end + 1..], macros)) };
        }
    }
    inline(&plain(text), macros)
}

/// The first place of a command outside of formulas.
fn outside(text: &str, command: &str) -> Option<usize> {
    let found = text.match_indices(command).map(|(at, _)| at);
    found.into_iter().find(|at| text[..*at].matches('$').count().is_multiple_of(2))
}

/// The words of a text: signs for the commands that print them; formulas stay between dollar signs.
fn plain(text: &str) -> String {
    let text = text.replace("\\(", "$").replace("\\)", "$");
    let parts: Vec<&str> = text.split('$').collect();
    let mut out = String::new();
    for (at, part) in parts.iter().enumerate() {
        if at > 0 {
            out.push('$');
        }
        if at % 2 == 1 {
            out.push_str(part);
            continue;
        }
        let signs = [
            ("``", "“"),
            ("''", "”"),
            ("---", "—"),
            ("--", "–"),
            ("\\%", "%"),
            ("\\&", "&"),
            ("\\_", "_"),
            ("\\#", "#"),
            ("~", "\u{a0}"),
            ("\\,", "\u{2009}"),
            ("\\\\", " "),
            ("\\ ", " "),
            ("\\ldots", "…"),
            ("\\dots", "…"),
        ];
        let mut words = (*part).to_owned();
        signs.iter().for_each(|(from, to)| words = words.replace(from, to));
        out.push_str(&without_commands(&words));
    }
    out
}

/// A text without commands: labels go with their argument, references keep it, other commands leave their argument.
fn without_commands(text: &str) -> String {
    let (mut out, mut rest) = (String::new(), text);
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        let after = &rest[at + 1..];
        let name = after.len() - after.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
        let (command, tail) = after.split_at(name.max(after.chars().next().map_or(0, char::len_utf8)).min(after.len()));
        rest = match (command, tail.strip_prefix('{').and_then(|inner| Some((inner, closing(inner)?)))) {
            ("label" | "vspace" | "hspace" | "bibliography" | "includegraphics", Some((inner, end))) => {
                &inner[end + 1..]
            }
            ("ref" | "eqref" | "cite", Some((inner, end))) => {
                out.push_str(&format!("({})", &inner[..end]));
                &inner[end + 1..]
            }
            _ => tail.strip_prefix(' ').unwrap_or(tail),
        };
    }
    out.push_str(rest);
    out.replace(['{', '}'], "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_lists_and_emphasis_of_tex_are_those_of_the_page() {
        let text = "\\section{A \\emph{first} part} % no\nWords, ``quoted'' and \\textbf{strong} with $x_1$.\n\n\\begin{itemize}\n\\item one\n\\item two~b\n\\end{itemize}\nSee~\\eqref{eq:a}. 5\\% off\n";
        let shown = prose(text, &[]).into_string();
        for part in [
            "<h2>A <em>first</em> part</h2>",
            "“quoted”",
            "<strong>strong</strong>",
            "<math",
            "<ul><li>one</li><li>two\u{a0}b</li></ul>",
            "(eq:a)",
            "5% off",
        ] {
            assert!(shown.contains(part), "no {part} in {shown}");
        }
        assert!(!shown.contains("\\") && !shown.contains("% no"), "{shown}");
    }

    #[test]
    fn markup_and_broken_groups_stay_text() {
        let shown = prose("<b>x</b> \\emph{open \\textbf{ \\ \n\n\\", &[]).into_string();
        assert!(shown.contains("&lt;b&gt;x") && !shown.contains("<b>"), "{shown}");
    }
}
