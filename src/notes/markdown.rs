//! Displays in Markdown: `$$…$$`, math fences, bare `\[…\]` and bare environments.
//!
//! pulldown-cmark finds code, fences and block quotes. The displays themselves are found by a separate scan,
//! because they contain blank lines, `_` and `*`, which have another meaning in CommonMark.
//!
//! # Why there is an own scan beside pulldown-cmark
//!
//! pulldown-cmark knows where code, comments and quotes are. But CommonMark allows no blank line in `$$…$$` and
//! reads `_` and `*` in it as emphasis, and real notes are full of both. So pulldown-cmark says where not to look,
//! and the scan finds the displays with exact bytes.

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};

use super::tex_scanner::{self, Delimiter, RawDisplay, ScannedText};
use crate::source::{Fault, Span};

/// The structure of the file by CommonMark.
#[derive(Default)]
struct Structure {
    /// Code, and math fences, in order.
    blocks: Vec<Block>,
    /// Where the fenced ones start.
    fences: Vec<usize>,
    /// Starts and ends of block quotes.
    quotes: Vec<(usize, usize)>,
}

struct Block {
    span: Span,
    kind: BlockKind,
}

enum BlockKind {
    Code,
    /// The range between the fences.
    Math(Span),
}

/// Finds the displays of a Markdown file.
pub(super) fn scan(text: &str) -> Result<ScannedText, Fault> {
    let structure = structure(text);
    let mut found = ScannedText::default();
    displays(text, &structure, &mut found)?;
    found.markers = markers(text, structure.quotes, &found.raws);
    Ok(found)
}

fn structure(text: &str) -> Structure {
    let mut structure = Structure::default();
    // The span of the fence we are in, whether it is a math fence, and what is inside.
    let mut fence: Option<(Span, bool, Option<Span>)> = None;
    for (event, range) in Parser::new(text).into_offset_iter() {
        let span = Span::from(range);
        match event {
            Event::Code(_) => structure.blocks.push(Block { span, kind: BlockKind::Code }),
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                let word = info.split_whitespace().next();
                fence = Some((span, matches!(word, Some("math" | "{math}")), None));
            }
            Event::Text(_) => {
                if let Some((_, _, inside)) = &mut fence {
                    *inside = Some(inside.map_or(span, |inside| inside.to(span)));
                }
            }
            Event::End(TagEnd::CodeBlock) => {
                if let Some((span, math, inside)) = fence.take() {
                    let kind = match inside {
                        Some(inside) if math => BlockKind::Math(inside),
                        _ => BlockKind::Code,
                    };
                    structure.fences.push(span.start);
                    structure.blocks.push(Block { span, kind });
                }
            }
            Event::Start(Tag::BlockQuote(_)) => structure.quotes.push((span.start, span.end)),
            _ => {}
        }
    }
    structure
}

/// The number of bytes of the settings before a document, between lines `---` (YAML) or `+++` (TOML).
pub(crate) fn front_matter(text: &str) -> usize {
    let begin = text.len() - text.trim_start_matches('\u{feff}').len();
    let mut lines = text[begin..].split_inclusive('\n');
    let Some(fence) = lines.next().filter(|line| matches!(line.trim_end(), "---" | "+++")) else { return 0 };
    let mut end = begin + fence.len();
    for (at, line) in lines.enumerate() {
        end += line.len();
        // A rule is also written as `---`, so the first line must be a setting.
        if at == 0 && !line.contains([':', '=', '#']) {
            return 0;
        }
        if line.trim_end() == fence.trim_end() || line.trim_end() == "..." {
            return end;
        }
    }
    0
}

fn displays(text: &str, structure: &Structure, found: &mut ScannedText) -> Result<(), Fault> {
    let bytes = text.as_bytes();
    let mut blocks = structure.blocks.iter().peekable();
    // Once no `\]` follows, none follows later: without this, many unclosed `\[` would be quadratic.
    let mut brackets_close = true;
    let mut doubled_close = true;
    let mut i = front_matter(text);
    found.blank.extend((i > 0).then(|| Span::new(0, i)));
    while i < bytes.len() {
        while blocks.next_if(|block| block.span.start < i).is_some() {}
        if let Some(block) = blocks.next_if(|block| block.span.start == i) {
            match block.kind {
                BlockKind::Math(body) => {
                    let body = found.options(text, body);
                    display(
                        text,
                        RawDisplay { span: block.span, body, delimiter: Delimiter::Whole, is_numbered: false },
                        found,
                    )?
                }
                _ => found.blank.push(block.span),
            }
            i = block.span.end.max(i + 1);
            continue;
        }
        i = match bytes[i] {
            b'$' if bytes[i..].starts_with(b"$$") => {
                // A fenced block ends a display that was never closed.
                let fence = structure.fences.partition_point(|&start| start < i);
                let limit = structure.fences.get(fence).copied().unwrap_or(text.len());
                let Some(close) = tex_scanner::find_unescaped(&text[..limit], i + 2, b"$$") else {
                    return Err(unclosed(text, i, found));
                };
                pair(text, i, close, found)?
            }
            b'$' => found.inline(bytes, i, true),
            b'<' if bytes[i..].starts_with(b"<!--") => {
                let Some(close) = tex_scanner::find(text, i + 4, "-->") else {
                    return Err(Fault::notes(Span::new(i, i + 4), "this comment is never closed")
                        .help("add `-->`; without it the rest of the file is a comment"));
                };
                found.names.extend(tex_scanner::name_in(text, Span::new(i + 4, close))?);
                found.blank.push(Span::new(i, close + 3));
                close + 3
            }
            b':' if bytes[i..].starts_with(b":::") && starts_line(bytes, i) => colons(text, i, found)?,
            // mdBook writes `\\[`, because `\[` is a mere bracket in Markdown.
            b'\\' if bytes[i..].starts_with(b"\\\\[") => {
                match doubled_close.then(|| tex_scanner::find(text, i + 3, "\\\\]")).flatten() {
                    Some(close) => {
                        let (span, body) = (Span::new(i, close + 3), Span::new(i + 3, close));
                        display(
                            text,
                            RawDisplay { span, body, delimiter: Delimiter::Whole, is_numbered: false },
                            found,
                        )?;
                        span.end
                    }
                    None => {
                        doubled_close = false;
                        i + 2
                    }
                }
            }
            b'\\' if bytes[i..].starts_with(b"\\[") => {
                match brackets_close.then(|| tex_scanner::find_unescaped(text, i + 2, b"\\]")).flatten() {
                    // The bracket that closes may be that of a later display.
                    Some(close) if starts_line(bytes, i) && opens_again(&text[i + 2..close]) => {
                        if is_equation(text, i) || alone(bytes, i) {
                            return Err(unclosed_bracket(i));
                        }
                        i + 2
                    }
                    Some(close) => pair(text, i, close, found)?,
                    None if starts_line(bytes, i) && is_equation(text, i) => return Err(unclosed_bracket(i)),
                    // In Markdown, `\[` is also how a mere bracket is written.
                    None if alone(bytes, i) => {
                        return Err(unclosed_bracket(i));
                    }
                    None => {
                        brackets_close = false;
                        i + 2
                    }
                }
            }
            b'\\' => {
                match tex_scanner::begin(text, i).and_then(|(n, end)| Some((n, end, tex_scanner::environment(n)?))) {
                    Some((name, inside, delimiter)) => {
                        tex_scanner::environment_display(text, i, inside, name, delimiter, found)?
                    }
                    None => i + 2,
                }
            }
            _ => i + 1,
        };
    }
    Ok(())
}

/// Records the display between two-byte delimiters at `open` and `close`. Returns the position after it.
fn pair(text: &str, open: usize, close: usize, found: &mut ScannedText) -> Result<usize, Fault> {
    let (span, body) = (Span::new(open, close + 2), Span::new(open + 2, close));
    display(text, RawDisplay { span, body, delimiter: Delimiter::Pair, is_numbered: false }, found)?;
    Ok(span.end)
}

/// Records a display, and the TeX comments in it.
fn display(text: &str, raw: RawDisplay, found: &mut ScannedText) -> Result<(), Fault> {
    // The renderers look for the closing delimiter first, so that it ends a comment, too.
    let text = &text[..raw.body.end];
    let mut i = raw.body.start;
    while i < text.len() {
        match text.as_bytes()[i] {
            b'\\' => i += 2,
            b'%' => i = found.comment(text, i)?,
            _ => i += 1,
        }
    }
    found.raws.push(raw);
    Ok(())
}

/// The block of MyST between colons that opens at `at`: a display, if its name is `math`. Returns where to read on.
fn colons(text: &str, at: usize, found: &mut ScannedText) -> Result<usize, Fault> {
    let bytes = text.as_bytes();
    let colons = bytes[at..].iter().take_while(|&&b| b == b':').count();
    let end = tex_scanner::line_end(bytes, at);
    let info = text[at + colons..end].trim();
    if !info.starts_with("{math}") {
        return Ok(end);
    }
    let closing = format!("\n{}", ":".repeat(colons));
    let Some(close) = tex_scanner::find(text, end, &closing) else {
        return Err(Fault::notes(Span::new(at, end), "this `{math}` is never closed")
            .help(format!("add a line `{}` after the equation", ":".repeat(colons))));
    };
    let span = Span::new(at, close + closing.len());
    let body = found.options(text, Span::new(end, close));
    display(text, RawDisplay { span, body, delimiter: Delimiter::Whole, is_numbered: false }, found)?;
    Ok(span.end)
}

/// Whether only spaces precede in the line of `at`.
fn starts_line(bytes: &[u8], at: usize) -> bool {
    bytes[..at].iter().rev().take_while(|&&b| b != b'\n').all(|&b| matches!(b, b' ' | b'\t' | b'>'))
}

/// Whether the two bytes at `at` are alone on their line.
fn alone(bytes: &[u8], at: usize) -> bool {
    let mut before = bytes[..at].iter().rev().take_while(|&&b| b != b'\n');
    before.all(|&b| matches!(b, b' ' | b'\t' | b'>')) && tex_scanner::ends_line(bytes, at + 2)
}

/// Whether `\[` stands at the beginning of a line of the text.
fn opens_again(text: &str) -> bool {
    text.lines().skip(1).any(|line| line.trim_start().starts_with("\\["))
}

/// Whether the rest of a line after `\[` is an equation, and no remark in brackets.
fn is_equation(text: &str, at: usize) -> bool {
    let line = &text[at + 2..tex_scanner::line_end(text.as_bytes(), at)];
    line.contains('=') && !line.contains(']')
}

fn unclosed_bracket(at: usize) -> Fault {
    Fault::notes(Span::new(at, at + 2), "this `\\[` is never closed").help("add `\\]` after the equation")
}

fn unclosed(text: &str, at: usize, found: &ScannedText) -> Fault {
    // From a `$$` that is missing on, every `$$` opens what it should close, and a display holds the prose between two equations.
    let has_blank_line = |raw: &&RawDisplay| {
        text[raw.span.range()].lines().skip(1).any(|line| line.trim_matches([' ', '\t', '>']).is_empty())
    };
    let dollars = |raw: &&RawDisplay| text[raw.span.range()].starts_with("$$");
    if let Some(first) = found.raws.iter().filter(dollars).find(has_blank_line) {
        let line = text[..first.span.start].matches('\n').count() + 1;
        let start = first.span.start;
        return Fault::notes(Span::new(start, start + 2), "a `$$` is missing").help(format!(
            "this display, which begins in line {line}, is the first with a blank line in it; close it with `$$` where its \
             equation ends, or look for a missing `$$` before it"
        ));
    }
    let help = match found.raws.last() {
        Some(last) => {
            let line = text[..last.span.start].matches('\n').count() + 1;
            format!("add `$$` after the equation, or close an earlier display; the one before begins in line {line}")
        }
        None => "add `$$` after the equation, or write a dollar sign in prose as `\\$`".to_owned(),
    };
    Fault::notes(Span::new(at, at + 2), "this `$$` is never closed").help(help)
}

/// The `>` at line starts inside block quotes.
///
/// A line of a display that begins outside of a quote keeps its `>`: there it is a relation.
fn markers(text: &str, quotes: Vec<(usize, usize)>, raws: &[RawDisplay]) -> Vec<Span> {
    let mut found = Vec::new();
    let mut starts: Vec<usize> = quotes.iter().map(|q| q.0).collect();
    let mut ends: Vec<usize> = quotes.iter().map(|q| q.1).collect();
    starts.sort_unstable();
    ends.sort_unstable();
    let (mut opened, mut closed) = (0, 0);
    let mut displays = raws.iter().peekable();
    // The display that reaches into this line, as its end and its depth.
    let mut within: Option<(usize, usize)> = None;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let end = at + line.len();
        while starts.get(opened).is_some_and(|&start| start < end) {
            opened += 1;
        }
        while ends.get(closed).is_some_and(|&end| end <= at) {
            closed += 1;
        }
        let depth = opened.saturating_sub(closed);
        if within.is_some_and(|(end, _)| end <= at) {
            within = None;
        }
        strip(line, at, within.map_or(depth, |(_, limit)| limit.min(depth)), &mut found);
        while let Some(raw) = displays.next_if(|raw| raw.span.start < end) {
            if raw.span.end > end {
                within = Some((raw.span.end, depth));
            }
        }
        at = end;
    }
    found
}

/// Up to `depth` markers at the start of a line.
fn strip(line: &str, at: usize, depth: usize, found: &mut Vec<Span>) {
    let mut rest = line;
    for _ in 0..depth {
        rest = rest.trim_start_matches([' ', '\t']);
        let Some(after) = rest.strip_prefix('>') else { return };
        let here = at + line.len() - rest.len();
        found.push(Span::new(here, here + 1));
        rest = after;
    }
}
