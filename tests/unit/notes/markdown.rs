//! Displays in Markdown.

use super::*;

#[test]
fn within_a_paragraph() {
    assert_eq!(texts(&md("so $$a = b$$ and \\[c = d\\] and $x$ hold")), ["a = b", "c = d"]);
}

#[test]
fn not_in_code() {
    let text =
        "`$$a$$` and\n\n```\n$$b$$\n```\n\n~~~tex\n\\[c\\]\n~~~\n\n<!-- $$d$$ -->\n\nat \\$$5 and \\$\\$\n\n$$e$$\n";
    assert_eq!(texts(&md(text)), ["e"]);
    assert_eq!(texts(&md("``` math\na % c\n= b\n```\n(1)\n")), ["a = b"]);
    assert_eq!(numbers(&md("``` math\na\n= b\n```\n(1)\n")), ["1"]);
}

#[test]
fn inline_is_no_display() {
    assert_eq!(texts(&md("$a$$b$ and \\(c\\) and $5 or $6; $$d$$")), ["d"]);
}

#[test]
fn environments() {
    let text = "\\begin{equation}\na = b\n\\end{equation}\n\n\\begin{tabular}x\\end{tabular}\n\n$$\\begin{aligned}c\\\\d\\end{aligned}$$";
    assert_eq!(texts(&md(text)), ["a = b", "\\begin{aligned}c\\\\d\\end{aligned}"]);
    let text = "$$\n\\begin{align}\na &= b \\tag{1}\\\\\nc &= d \\tag{2}\n\\end{align}\n$$\n\n$$e$$";
    assert_eq!(numbers(&md(text)), ["1", "2", ""]);
}

#[test]
fn blank_lines_and_braces_do_not_matter() {
    assert_eq!(texts(&md("$$\na {\n\n= b\n$$\n")), ["a { = b"]);
}

#[test]
fn never_closed() {
    for (text, at) in [
        ("a\n\n$$x = 1\n", "$$"),
        ("$$a$$ $$x", "$$"),
        ("\\[\nx\n", "\\["),
        ("<!-- x", "<!--"),
        ("\\begin{align}x\\end{aligned}", "\\begin{align}"),
        ("$$a\n\n```\n$$\n```\n", "$$"),
    ] {
        let error = parse(text, Kind::Markdown).unwrap_err();
        assert_eq!(pointed(&error), at, "{text:?}");
        assert!(error.advice().is_some());
    }
    // A mere bracket.
    assert_eq!(md("see \\[1, and so on").len(), 0);
}

#[test]
fn block_quotes() {
    let text = "> $$\n> a\n> = b\n> $$\n>\n> (1.2)\n\n> > $$c\n> > \\le d$$\n";
    let found = md(text);
    assert_eq!((numbers(&found), texts(&found)), (vec!["1.2", ""], vec!["a = b".to_owned(), "c \\le d".to_owned()]));
    // Outside of a quote it is a relation.
    assert_eq!(texts(&md("$$\na\n> b\n$$\n")), ["a > b"]);
    assert_eq!(texts(&md("> $$\n> a\n> > b\n> $$\n")), ["a > b"]);
}

#[test]
fn crlf() {
    let found = md("x\r\n\r\n$$\r\na = b\r\n\\tag{1.1}\r\n$$\r\n\r\n$$c$$\r\n (1.2)\r\n");
    assert_eq!((numbers(&found), found[1].line), (vec!["1.1", "1.2"], 8));
}

#[test]
fn names() {
    let found = md("<!-- onshell: veff -->\n\n$$a$$\n\n<!-- another -->\n$$b \\label{eq:b}$$\n");
    let labels = |i: usize| found[i].labels.iter().map(|label| label.id.as_str()).collect::<Vec<_>>();
    assert_eq!((labels(0), labels(1)), (vec!["#veff"], vec!["eq:b"]));
    for text in ["$$a$$\n<!-- onshell: veff -->\n", "<!-- onshell: two words -->\n$$a$$", "<!-- onshell: -->\n$$a$$"] {
        assert!(parse(text, Kind::Markdown).is_err(), "{text}");
    }
}

#[test]
fn macros() {
    let text = "$\\newcommand{\\PD}[2]{\\frac{\\partial #2}{\\partial #1}}$\n\n$$\\def\\eps{\\epsilon} a = \\eps$$\n\n\
                $$\\DeclareMathOperator{\\tr}{tr}$$\n\n`\\newcommand{\\no}{x}`\n";
    let notes = parse(text, Kind::Markdown).unwrap();
    let macros: Vec<_> = notes.macros.iter().map(|m| (m.name.as_str(), m.arguments, m.body.as_str())).collect();
    assert_eq!(
        macros,
        [
            ("\\PD", 2, "\\frac{\\partial #2}{\\partial #1}"),
            ("\\eps", 0, "\\epsilon"),
            ("\\tr", 0, "\\operatorname{tr}"),
        ]
    );
    assert_eq!(texts(&notes.equations), ["a = \\eps"]);
}

#[test]
fn quotes() {
    let text = "> When $p_\\phi  =\n> p_\\psi$, it\n> blows up.\n\nIt blows up. It blows up.\n";
    let notes = parse(text, Kind::Markdown).unwrap();
    let found = notes.find_quote("When p_\\phi = p_\\psi, it blows up.");
    assert_eq!(found.len(), 1);
    assert!(text[found[0].range()].starts_with("When") && text[found[0].range()].ends_with("up."));
    assert_eq!(notes.find_quote("It blows up.").len(), 2);
    assert_eq!(notes.find_quote("it explodes").len(), 0);
    assert_eq!(notes.find_quote(" $ ").len(), 0);
}
