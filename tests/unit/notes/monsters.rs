//! Input made to break a reader: deep, long, repetitive.

use super::*;

fn found(text: &str, kind: Kind) -> Result<Notes> {
    Notes::parse(Arc::new(Source::new("notes", text)), kind)
}

fn quick<T>(f: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let value = f();
    // Far above what is needed, far below what a quadratic scan takes.
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    value
}

#[test]
fn nested_braces() {
    let text = format!("$${}x{}$$\n(1.1)\n", "{".repeat(100_000), "}".repeat(100_000));
    assert_eq!(quick(|| md(&text)).len(), 1);
    assert_eq!(quick(|| md(&format!("$${}$$", "{".repeat(100_000)))).len(), 1);
    assert_eq!(quick(|| tex(&format!("\\begin{{align}}{}\\end{{align}}", "\\begin{x}".repeat(100_000)))).len(), 1);
}

#[test]
fn nested_json() {
    let text = with(&format!("\"equations\": {}{}", "[".repeat(100_000), "]".repeat(100_000)));
    assert!(quick(|| refused(&text)).0.contains("nested more than 64 levels deep"));
    assert!(quick(|| refused(&"[".repeat(100_000))).0.contains("ends in the middle of a value"));
}

#[test]
fn ten_megabytes() {
    let text = format!("$$a = {}b \\tag{{1}}$$", "x_1 + ".repeat(1_700_000));
    assert_eq!(quick(|| md(&text))[0].text.len() + 4, text.len());
    assert_eq!(numbers(&quick(|| tex(&text))), ["1"]);
}

#[test]
fn many_of_everything() {
    for piece in [
        "\\[",
        "$",
        "$a",
        "`",
        "`$",
        "> ",
        "\\tag{",
        "\\newcommand{\\a}{",
        "$$a$$",
        "$$a$$\n\n",
        "<!--a-->",
        "\\(",
        "- ",
        "$$a$$ $b$ ",
        "\\begin{",
        "$$a$$ (",
        "$$a$$ (1) ",
        "$$a$$ , $b$ ",
        "$$(1)$$",
        "<!-- onshell: a --> $$a$$",
        "$\n",
        "\\[ ",
        "\\verb|",
        "%",
        "[",
        "*_",
        "$$=$$\n",
    ] {
        for kind in [Kind::Markdown, Kind::Tex] {
            let text = piece.repeat(300_000 / piece.len());
            let _ = quick(|| found(&text, kind));
            let _ = quick(|| found(&format!("$$ {} $$", text.replace("$$", "")), kind));
        }
    }
}

#[test]
fn any_bytes_are_survived() {
    // Every cut of a document that has everything in it.
    let text = "> a é\n> $$\\newcommand{\\é}[1]{#1} x % é\n> = 1 (2.1)$$\n, $é$ (2.2)\n\\begin{align}é\\\\[é\n\\tag{é}\\\\&=\\tag{1}\\end{align}\
                \n```math\né\n```\n<!-- onshell: é -->\\verb|é| $$(1)$$ \\[é\\]\\é$$\\é$$\n\n$$= \\left(é\\right)$$\n\n(3.1)";
    for kind in [Kind::Markdown, Kind::Tex] {
        for start in (0..text.len()).filter(|&i| text.is_char_boundary(i)) {
            for end in (start..=text.len()).filter(|&i| text.is_char_boundary(i)) {
                let _ = parse(&text[start..end], kind);
            }
        }
    }
    let text = with(
        "\"equations\": {\"6.7 row 2, `\\\\é` .. #a\": {\"expect\": \"refuted\"}}, \"constants\": {\"\\u00e9, b\": \"(\\\\pi, 1]\"}",
    );
    for end in (0..text.len()).filter(|&i| text.is_char_boundary(i)) {
        assert!(claims(&text[..end]).is_err());
        let _ = claims(&text[end..]);
    }
}
