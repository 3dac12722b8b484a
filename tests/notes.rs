//! Documents and claims files: what is found in them and where, and what is refused. Beside what must be read stands
//! its near twin that must not.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use onshell::notes::claims::{Count, Expected, Holds, Property, Range, Role, Solved, Test, Turning};
use onshell::notes::json::{self, Value};
use onshell::notes::{Claims, Display, Kind, Notes, claims_beside};
use onshell::source::Source;
use onshell::{Error, Result};

fn parse(text: &str, kind: Kind) -> Result<Notes> {
    let notes = Notes::parse(Arc::new(Source::new("notes", text)), kind)?;
    for display in &notes.equations {
        assert_eq!(display.text.len(), display.body.end - display.body.start, "text and body: {display:?}");
        assert!(display.span.contains(display.body), "body within span: {display:?}");
        assert!(display.parts.iter().all(|part| display.body.contains(*part)));
        let line = text[..display.span.start].matches('\n').count() + 1;
        assert_eq!(display.line, line);
        // Every byte that was not overwritten is the file's own.
        let own = text[display.body.range()].bytes();
        let kept = own.zip(display.text.bytes()).filter(|(a, b)| a != b).all(|(_, b)| b" \\,".contains(&b));
        assert!(kept, "{display:?}");
        if let Some(number) = &display.number {
            assert!(text[number.span.range()].contains(&number.id));
        }
    }
    Ok(notes)
}

fn md(text: &str) -> Vec<Display> {
    parse(text, Kind::Markdown).unwrap().equations
}

fn tex(text: &str) -> Vec<Display> {
    parse(text, Kind::Tex).unwrap().equations
}

fn number(display: &Display) -> &str {
    display.number.as_ref().map_or("", |number| &number.id)
}

fn numbers(displays: &[Display]) -> Vec<&str> {
    displays.iter().map(number).collect()
}

fn squeezed(display: &Display) -> String {
    display.text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn texts(displays: &[Display]) -> Vec<String> {
    displays.iter().map(squeezed).collect()
}

fn claims(text: &str) -> Result<Claims> {
    Claims::parse(Arc::new(Source::new("claims.json", text)), Path::new("dir/claims.json"))
}

/// The text that an error points at.
fn pointed(error: &Error) -> &str {
    let (source, span) = error.place().expect("a place");
    source.slice(span)
}

/// What is said of a claims file that is wrong, with the advice; and what it points at.
fn refused(text: &str) -> (String, String) {
    let error = claims(text).expect_err(text);
    assert!(error.place().is_some(), "{error}");
    (error.to_string(), pointed(&error).to_owned())
}

/// A claims file with `rest` in it.
fn with(rest: &str) -> String {
    format!("{{ \"notes\": \"top.md\", {rest} }}")
}

mod numbers {
    use super::*;

    #[test]
    fn by_tag() {
        for text in
            [r"$$a = b \tag{6.73}$$", r"$$a = b \tag{(6.73)}$$", r"$$a = b \tag*{(6.73)}$$", r"$$a = b \eqno(6.73)$$"]
        {
            let found = md(text);
            assert_eq!((numbers(&found), texts(&found)), (vec!["6.73"], vec!["a = b".to_owned()]), "{text}");
        }
    }

    #[test]
    fn a_tag_in_a_comment_is_none() {
        assert_eq!(numbers(&md("$$a = b % \\tag{6.73}\n$$")), [""]);
        assert_eq!(numbers(&tex("$$a = b % \\tag{6.73}\n$$")), [""]);
        assert_eq!(texts(&md("$$a = 5\\% \\tag{6.73}$$")), ["a = 5\\%"]);
    }

    #[test]
    fn two_tags_in_one_display_are_refused() {
        let error = parse(r"$$a = b \tag{1} c = d \tag{2}$$", Kind::Markdown).unwrap_err();
        assert_eq!(pointed(&error), r"\tag{2}");
    }

    #[test]
    fn on_a_line_of_its_own() {
        for text in [
            "$$a = b$$\n (2.1)\n",
            "$$a = b$$\n(2.1)",
            "$$a = b$$\n\n(2.1)  \n",
            "$$a = b$$ (2.1)\n",
            "$$a = b$$\r\n (2.1)\r\n",
        ] {
            let found = md(text);
            assert_eq!((numbers(&found), texts(&found)), (vec!["2.1"], vec!["a = b".to_owned()]), "{text:?}");
        }
    }

    #[test]
    fn a_reference_is_no_number() {
        for text in
            ["$$a = b$$\n(2.1) shows that", "$$a = b$$\nby (2.1)\n", "$$a = b$$\n(see 2.1)\n", "$$a = b$$\n(x)\n"]
        {
            assert_eq!(numbers(&md(text)), [""], "{text:?}");
        }
    }

    #[test]
    fn in_a_display_of_its_own() {
        let found = md("$$a = b$$\n\n$$(2.2)$$\n\n$$c = d$$\n");
        assert_eq!((numbers(&found), texts(&found)), (vec!["2.2", ""], vec!["a = b".to_owned(), "c = d".to_owned()]));
        // Without an equation before it, it is still in the list.
        assert_eq!(numbers(&md("prose\n\n$$(2.2)$$\n")), ["2.2"]);
        assert_eq!(numbers(&md("$$a \\tag{1}$$\n\n$$(2.2)$$\n")), ["1", "2.2"]);
    }

    #[test]
    fn at_the_end_inside() {
        let found = md("$$m = 0 (2.8)$$\n\n$$I = m(r)^2 (2.44)$$\n\n$$a = b\\quad(2.9)$$");
        assert_eq!(numbers(&found), ["2.8", "2.44", "2.9"]);
        assert_eq!(texts(&found), ["m = 0", "I = m(r)^2", "a = b\\quad"]);
    }

    #[test]
    fn a_factor_is_no_number() {
        assert_eq!(numbers(&md("$$a = f(2.8)$$\n\n$$b = c (3)$$\n\n$$b = c (x.y)$$")), ["", "", ""]);
        // No other equation is of chapter 9: this is a product.
        let found = md("$$a = b \\tag{2.1}$$\n\n$$w = 2 (9.81)$$");
        assert_eq!(numbers(&found), ["2.1", ""]);
        assert_eq!(squeezed(&found[1]), "w = 2 (9.81)");
    }

    #[test]
    fn after_an_inline_tail() {
        let found = md("$$r = x$$\n , $M = \\int \\lambda$ (2.7)\n\nwhere");
        assert_eq!((numbers(&found), texts(&found)), (vec!["2.7"], vec!["r = x , M = \\int \\lambda".to_owned()]));
        let found = md("$$r_1 = x$$\n , $r_2 = y$, $r_3 = z$ $r_4 = w$ (3.52)\n");
        assert_eq!(texts(&found), ["r_1 = x , r_2 = y , r_3 = z ,r_4 = w"]);
        assert_eq!(numbers(&md("$$r = x$$ ,\n(2.7)\n")), ["2.7"]);
    }

    #[test]
    fn a_tail_without_a_number_is_prose() {
        let found = md("$$r = x$$\n , $M = 1$ as in (2.7)\n");
        assert_eq!((numbers(&found), texts(&found)), (vec![""], vec!["r = x".to_owned()]));
        assert_eq!(numbers(&md("$$r = x$$\n\n , $M = 1$\n\n (2.7)\n")), [""]);
    }

    #[test]
    fn neighbours_share_the_number_printed_after_them() {
        let found = md("$$a = b$$\n\n$$c = d$$\n\n$$e = f$$\n\n$$(4.59)$$\n");
        assert_eq!((numbers(&found), texts(&found)), (vec!["4.59"], vec!["a = b\\\\ c = d\\\\ e = f".to_owned()]));
        assert_eq!(found[0].parts.len(), 3);
        let found = md("$$a = b$$\n\n$$c = d$$\n(6.72)\n");
        assert_eq!((numbers(&found), found[0].parts.len()), (vec!["6.72"], 2));
    }

    #[test]
    fn prose_between_parts_them() {
        let found = md("$$a = b$$\n\nand\n\n$$c = d$$\n(6.72)\n");
        assert_eq!(numbers(&found), ["", "6.72"]);
        // A number inside belongs to its own display.
        assert_eq!(numbers(&md("$$a = b$$\n\n$$c = d \\tag{6.72}$$\n")), ["", "6.72"]);
        assert_eq!(numbers(&md("$$a = b$$\n<!-- x -->\n$$c = d$$\n(6.72)\n")), ["", "6.72"]);
        assert_eq!(numbers(&md("$$a = b$$\n`code`\n$$c = d$$\n(6.72)\n")), ["", "6.72"]);
    }

    #[test]
    fn a_relation_continues() {
        let found = md("$$N = x$$\n\n$$= y$$\n\n$$\\equiv z \\tag{2.31}$$\n\n$$\\Rightarrow w$$");
        assert_eq!(numbers(&found), ["2.31", ""]);
        assert_eq!(squeezed(&found[0]), "N = x\\\\ = y\\\\ \\equiv z");
        assert_eq!(numbers(&md("$$N = x$$\n\n$$\\equality y \\tag{2.31}$$")), ["", "2.31"]);
    }

    #[test]
    fn all_78() {
        // The forms of the notes, in their proportions, with their chapters.
        let mut text = String::new();
        let mut expected = Vec::new();
        for (chapter, range) in [(2, 1..33), (3, 33..57), (4, 57..63), (5, 63..71), (6, 71..79)] {
            for n in range {
                let id = format!("{chapter}.{n}");
                text.push_str("Prose with $x$ and (2.14), at $5.\n\n");
                text.push_str(&match n {
                    2 | 59 => format!("$$a$$\n\n$$b$$\n\n$$({id})$$\n"),
                    8 | 44 => format!("$$\\frac{{a}}{{b}} = 0 ({id})$$\n"),
                    7 | 52 => format!("$$a = b$$\n , $c = d$ ({id})\n"),
                    31 | 63 => format!("$$a$$\n\n$$= b$$\n\n$$\\equiv c$$\n({id})\n"),
                    _ if n % 3 == 0 => format!("$$a_{{{n}}} = b \\tag{{{id}}}$$\n"),
                    _ if n % 3 == 1 => format!("$$a_{{{n}}} = b$$\n ({id})\n"),
                    _ => format!("$$a_{{{n}}} = b$$\n({id})\n"),
                });
                text.push('\n');
                expected.push(id);
            }
        }
        let found = md(&text);
        assert_eq!(numbers(&found), expected);
        assert_eq!(found.len(), 78);
    }
}

mod markdown {
    use super::*;

    #[test]
    fn within_a_paragraph() {
        assert_eq!(texts(&md("so $$a = b$$ and \\[c = d\\] and $x$ hold")), ["a = b", "c = d"]);
    }

    #[test]
    fn not_in_code() {
        let text = "`$$a$$` and\n\n```\n$$b$$\n```\n\n~~~tex\n\\[c\\]\n~~~\n\n<!-- $$d$$ -->\n\nat \\$$5 and \\$\\$\n\n$$e$$\n";
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
        assert_eq!(
            (numbers(&found), texts(&found)),
            (vec!["1.2", ""], vec!["a = b".to_owned(), "c \\le d".to_owned()])
        );
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
        for text in
            ["$$a$$\n<!-- onshell: veff -->\n", "<!-- onshell: two words -->\n$$a$$", "<!-- onshell: -->\n$$a$$"]
        {
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
}

mod in_tex {
    use super::*;

    #[test]
    fn displays() {
        let text = "\\newcommand{\\be}{\\begin{equation}}\n\\begin{document}\n$x$ \\$ $$a$$ % $$no$$\n\\[b\\]\\\\[2pt]\n\
                    \\begin{equation*}c\\end{equation*}\n\\begin{verbatim}$$no$$\\end{verbatim} \\verb|$$no|\n\
                    \\begin{alignat}{2}d\\end{alignat}\n\\begin{math}no\\end{math}\\begin{multline}e\\end{multline}\n\
                    \\begin{displaymath}f\\end{displaymath}\n\\end{document}\n$$no$$";
        assert_eq!(texts(&tex(text)), ["a", "b", "c", "d", "e", "f"]);
    }

    #[test]
    fn never_closed() {
        for text in ["$$a", "\\[a", "\\begin{equation}a", "\\begin{verbatim}a", "\\begin{align}a % \\end{align}"] {
            let error = parse(text, Kind::Tex).unwrap_err();
            assert!(text.starts_with(pointed(&error)), "{text}");
        }
    }

    #[test]
    fn comments_and_labels_are_overwritten() {
        let found =
            tex("% onshell: veff\n\\begin{equation}\n a % é a comment\n = b \\label{eq:x}\\nonumber\n\\end{equation}");
        assert_eq!(texts(&found), ["a = b"]);
        let ids: Vec<_> = found[0].labels.iter().map(|label| label.id.as_str()).collect();
        assert_eq!(ids, ["eq:x", "#veff"]);
        // Inside of the display it names it, too.
        assert_eq!(tex("$$ % onshell: in\na$$")[0].labels[0].id, "#in");
    }

    #[test]
    fn rows_are_parted_at_their_numbers() {
        let text = "\\begin{align}\n a &= b \\\\\n &= c \\label{x} \\\\[2pt]\n &= d \\nonumber \\\\\n\
                    e &= \\begin{pmatrix}1\\\\2\\end{pmatrix} {f\\\\g} \\tag{7} \\\\* h &= i\n\\end{align}";
        let found = tex(text);
        assert_eq!(
            texts(&found),
            ["a &= b \\\\ &= c \\\\[2pt] &= d", "e &= \\begin{pmatrix}1\\\\2\\end{pmatrix} {f\\\\g}", "h &= i"]
        );
        assert_eq!(numbers(&found), ["", "7", ""]);
        assert_eq!(found[0].labels[0].id, "x");
    }

    #[test]
    fn one_number_holds_all_rows() {
        let found = tex("\\begin{align}a &= b \\\\ c &= d \\label{x}\\end{align}");
        assert_eq!(texts(&found), ["a &= b \\\\ c &= d"]);
        assert_eq!(tex("\\begin{align}a % \\\\ \\label{no}\n = b\\label{x}\\\\ c\\label{y}\\end{align}").len(), 2);
    }
}

mod files {
    use super::*;

    fn file(name: &str, bytes: &[u8]) -> std::path::PathBuf {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let path = folder.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }

    #[test]
    fn readable() {
        let path = file("good.md", "\u{feff}$$a = \\bar{é} \\tag{1}$$".as_bytes());
        assert_eq!(numbers(&Notes::read(&path, "good.md").unwrap().equations), ["1"]);
    }

    #[test]
    fn unreadable() {
        let read = |name: &str, bytes: &[u8]| Notes::read(&file(name, bytes), name).unwrap_err().to_string();
        assert!(read("utf8.md", b"one\ntwo \xff").contains("byte 8 (0xff, line 2)"));
        assert!(read("empty.md", b"").contains("empty"));
        assert!(read("blank.md", b"\xef\xbb\xbf \n").contains("empty"));
        assert!(read("notes.pdf", b"x").contains("not a kind of notes"));
        let missing = Notes::read(Path::new("/nowhere/x.md"), "x.md").unwrap_err().to_string();
        assert!(missing.contains("cannot read x.md"));
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
        assert!(Claims::read(folder, "tmp").unwrap_err().to_string().contains("folder"));
        assert!(Claims::read(&file("utf8.json", b"{\xff}"), "u").unwrap_err().to_string().contains("byte 1"));
    }

    #[test]
    fn beside() {
        assert_eq!(claims_beside(Path::new("a/top.md")), Path::new("a/top.json"));
        assert_eq!(claims(&with("\"equations\": {}")).unwrap().notes_path(), Path::new("dir/top.md"));
    }
}

mod monsters {
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
        assert!(quick(|| refused(&text)).0.contains("nest deeper than 64"));
        assert!(quick(|| refused(&"[".repeat(100_000))).0.contains("cut off"));
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
}

mod json_places {
    use super::*;

    #[test]
    fn values_and_their_places() {
        let text = "\u{feff}{ \"a\": [1e400, \"\\\\theta\", null, true], \"é\\\\\": {} }";
        let json = json::read(text).unwrap();
        let Value::Object(entries) = &json.value else { panic!() };
        assert_eq!(&text[entries[0].0.span.range()], "\"a\"");
        assert_eq!((entries[1].0.value.as_str(), &text[entries[1].0.span.range()]), ("é\\", "\"é\\\\\""));
        let Value::Array(items) = &entries[0].1.value else { panic!() };
        assert_eq!(items[0].value, Value::Number("1e400".into()));
        assert_eq!(
            (&items[1].value, &text[items[1].span.range()]),
            (&Value::String("\\theta".into()), "\"\\\\theta\"")
        );
    }

    #[test]
    fn control_characters() {
        for (written, word) in [
            ("\\theta", "a tab"),
            ("\\nu", "a line break"),
            ("\\beta", "a backspace"),
            ("\\frac", "a form feed"),
            ("\\rho", "a carriage return"),
            ("\\phi", "no such escape"),
            ("\\,", "no such escape"),
            ("\\upsilon", "no such escape"),
        ] {
            let (error, at) = refused(&with(&format!("\"assume\": \"1 + {written} = 0\"")));
            assert!(error.contains(word) && error.contains(&format!("write \"\\{written}\"")), "{error}");
            assert_eq!(at, written);
        }
        assert!(refused(&with("\"assume\": \"\\u0007\"")).0.contains("control character"));
        assert!(refused(&with("\"assume\": \"\\ud800\"")).0.contains("not JSON"));
        assert!(refused(&with("\"assume\": \"a\nb\"")).0.contains("within a string"));
        let assume = claims(&with("\"assume\": \"\\\\theta = \\u0061\"")).unwrap().assume;
        assert_eq!(assume[0].value, "\\theta = a");
    }

    #[test]
    fn duplicate_keys_at_any_level() {
        for text in [
            "{ \"notes\": \"a\",\n\"notes\": \"b\" }".to_owned(),
            with("\"equations\": { \"6.1\": {},\n\"6.1\": {} }"),
            with("\"equations\": { \"6.1\": { \"where\": { \"a\": \"1\",\n\"\\u0061\": \"2\" } } }"),
        ] {
            let (error, _) = refused(&text);
            assert!(error.contains("given twice; first in line 1") && error.contains(":2:"), "{error}");
        }
    }

    #[test]
    fn broken() {
        for (text, word) in [
            ("", "empty"),
            (" \n", "empty"),
            ("{\"notes\": \"a\"", "cut off"),
            ("{\"notes\": \"a", "cut off"),
            ("{", "cut off"),
            ("{} x", "stands after the end"),
            ("{\"a\": 1,}", "comma"),
            ("{\"a\" 1}", "not JSON"),
            ("{'a': 1}", "not JSON"),
            ("nul", "cut off"),
            ("{\"a\": NaN}", "not JSON"),
        ] {
            assert!(refused(text).0.contains(word), "{text}: {}", refused(text).0);
        }
        assert!(
            refused("{\n  \"a\": 1,\n  \"b\" 2\n}").0.starts_with("claims.json:3:7"),
            "{}",
            refused("{\n  \"a\": 1,\n  \"b\" 2\n}").0
        );
    }

    #[test]
    fn a_place_within_a_string() {
        let text = r#"x "a \\phi \u00e9 b""#;
        let token = onshell::source::Span::new(2, text.len());
        // In the string: `a \phi é b`.
        for (part, shown) in [(2..6, r"\\phi"), (7..9, r"\u00e9"), (10..11, "b"), (0..1, "a")] {
            assert_eq!(&text[json::place_in_string(text, token, part.into()).range()], shown);
        }
    }
}

mod claims_files {
    use super::*;

    const TOP: &str = r##"{ "notes": "heavy-top.md", "system": { "name": "heavy_top", "read": { "l": "R" } },
  "independent variable": "t",
  "coordinates": { "\\theta": "(0, \\pi)", "\\phi, \\psi": "angle" },
  "varies with time": { "u": "any" },
  "constants": { "M, g, R, \\lambda_1": "> 0", "n": "integer 2..5", "q": "< 0" },
  "functions": { "V(r, t)": "any" }, "indices": { "i, j": "1..n", "a": "1..3" },
  "rotations": { "\\mathbf R_z(\\alpha)": "of the axes" }, "components": { "\\vec r": "x, y" },
  "means": { "L": "Lagrangian", "T, U": "kinetic energy" },
  "define": { "\\Omega": "\\dot\\phi" }, "macros": { "\\PD": "x" },
  "conditions": { "steady": "\\dot\\theta = 0", "two": ["a", "b"] }, "assume": ["x"],
  "equations": {
    "6.74": { "throughout": "steady", "holds": "on shell", "from": "6.73, 6.72 row 2 part 1 .. #veff" },
    "6.75": { "solves": "6.74", "for": "\\Omega" },
    "6.76": { "limit": "\\omega_3 \\to \\infty", "conserved": true, "up to a constant": true },
    "6.77": { "generates": "the motion", "solves": "equations of motion", "for": ["x", "y"] },
    "6.78": { "also equals": "H", "assume": ["a", "b"], "dropping": "c", "times": "2", "divided by": "3", "where": { "m": "1" } },
    "every `\\dot{z} = 2c`": { "erratum": { "for": "a", "read": "b", "times": 2 } },
    "eqn:x": { "expect": "refuted", "because": "of it", "equation of motion of": "\\theta", "defines": "x" },
    "(6.79)": { "skip": "no claim", "conserved": "E" } },
  "sentences": [
    { "quote": "a" }, { "quote": "b", "claim": "x > 0", "in": "6.78", "name": "bee" }, { "quote": "c", "not always": "x" }, { "quote": "d", "conserved": "E" },
    { "quote": "e", "of": "U", "minima": 1, "against": "\\theta", "expect": "refuted", "because": "x" },
    { "quote": "f", "of": "U", "tends to": { "x \\to 0": "1" } }, { "quote": "g", "of": "6.74", "solutions": 2, "for": "x" },
    { "quote": "h", "of": "U", "independent of": ["x"] }, { "quote": "i", "of": "U", "sign": "changes" } ] }"##;

    #[test]
    fn everything() {
        let claims = claims(TOP).unwrap();
        let text = &claims.source.text;
        assert_eq!(claims.system.as_ref().unwrap().read[0].1.value, "R");
        let names: Vec<_> =
            claims.declarations.iter().map(|d| (d.role, d.name.value.as_str(), &text[d.name.span.range()])).collect();
        assert_eq!(
            names[..3],
            [
                (Role::Coordinate, "\\theta", "\\\\theta"),
                (Role::Coordinate, "\\phi", "\\\\phi"),
                (Role::Coordinate, "\\psi", "\\\\psi")
            ]
        );
        assert!(names.contains(&(Role::Constant, "g", "g")) && names.contains(&(Role::Function, "V(r, t)", "V(r, t)")));
        assert_eq!(claims.means.len(), 3);
        assert_eq!(claims.rotations[0].1.value, Turning::Axes);
        assert_eq!(claims.conditions[1].1.len(), 2);
        let claim = |i: usize| &claims.equations[i].1;
        assert_eq!(claim(0).holds.as_ref().unwrap().value, Holds::OnShell);
        assert_eq!(claim(0).from[0].items.len(), 2);
        assert!(matches!(claim(1).solves.as_ref().unwrap().of, Solved::Equation(_)));
        assert!(matches!(claim(3).solves.as_ref().unwrap().of, Solved::EquationsOfMotion(_)));
        assert_eq!(claim(5).errata[0].times, 2);
        assert_eq!(claim(6).expect.as_ref().unwrap().verdict.value, Expected::Refuted);
        let tests: Vec<_> = claims.sentences.iter().map(|s| &s.test).collect();
        assert!(matches!(tests[0], Test::Quoted) && matches!(tests[1], Test::Claim(_)));
        assert!(matches!(tests[3], Test::Conserved(_)) && claims.sentences[3].claim.conserved.is_none());
        assert!(matches!(tests[4], Test::Of(_, Property::Minima(n)) if n.value == 1));
        assert!(matches!(tests[6], Test::Solutions { count, .. } if count.value == 2));
    }

    #[test]
    fn ranges() {
        let range = |text: &str| {
            claims(&with(&format!("\"constants\": {{ \"x\": \"{text}\" }}")))
                .map(|c| c.declarations[0].range.value.clone())
        };
        let pi = std::f64::consts::PI;
        let interval = |low, high, low_open, high_open| Range::Interval { low, high, low_open, high_open };
        for (text, expected) in [
            ("> 0", Range::Positive),
            (">0", Range::Positive),
            ("< 0", Range::Negative),
            ("any", Range::Any),
            ("angle", Range::Angle),
            ("(0, \\\\pi)", interval(0.0, pi, true, true)),
            ("[0.2, 2.9]", interval(0.2, 2.9, false, false)),
            ("(-\\\\pi/2, \\\\frac{3\\\\pi}{2}]", interval(-pi / 2.0, 3.0 * pi / 2.0, true, false)),
            ("[-1e-3, 2\\\\,\\\\pi)", interval(-1e-3, 2.0 * pi, false, true)),
            ("[0, \\\\frac\\\\pi2]", interval(0.0, pi / 2.0, false, false)),
            ("[0, \\\\frac{1}{10}\\\\pi]", interval(0.0, pi / 10.0, false, false)),
            ("integer 2..5", Range::Integer { low: 2, high: Count::Number(5) }),
        ] {
            assert_eq!(range(text).unwrap(), expected, "{text}");
        }
        for text in [
            "(1, 0)",
            "[1, 1]",
            "[0, 1e400]",
            "[NaN, 1]",
            "[0, inf]",
            "[0, nan]",
            "positive",
            "agnle",
            "(0, 1",
            "(0)",
            "(0, 1, 2)",
            "1..3",
            "integer 5..2",
            "integer 1..n",
            "integer 2..1e400",
            "[0, 1/0]",
            "[0, \\\\pi\\\\pi]",
            "(",
            "[]",
            "[,]",
            "[\\\\frac, 1]",
            "0",
        ] {
            let error = range(text).unwrap_err();
            assert!(error.advice().is_some(), "{text}");
            assert!(pointed(&error).contains(text), "{text}");
        }
        assert!(range("(1, 0)").unwrap_err().to_string().contains("upside down"));
        assert!(range("agnle").unwrap_err().to_string().contains("did you mean \"angle\""));
        let indices = |text: &str| {
            claims(&with(&format!("\"indices\": {{ \"i\": \"{text}\" }}")))
                .map(|c| c.declarations[0].range.value.clone())
        };
        assert_eq!(indices("1..n").unwrap(), Range::Integer { low: 1, high: Count::Symbol("n".into()) });
        assert!(indices("3..1").is_err() && indices("any").is_err() && indices("1..").is_err());
    }

    #[test]
    fn a_symbol_declared_twice() {
        for (rest, second) in [
            ("\"constants\": { \"M\": \"> 0\", \"g, M\": \"> 0\" }", "M"),
            ("\"coordinates\": { \"p_{\\\\psi}\": \"any\" }, \"constants\": { \"p_ \\\\psi\": \"any\" }", "p_ \\\\psi"),
            ("\"functions\": { \"V(r)\": \"any\" }, \"constants\": { \"V\": \"> 0\" }", "V(r)"),
            ("\"constants\": { \"T\": \"> 0\" }, \"means\": { \"T\": \"kinetic energy\" }", "T"),
        ] {
            let (error, at) = refused(&with(rest));
            assert!(error.contains("declared twice; first at 1:"), "{error}");
            assert_eq!(at, second);
        }
        assert!(
            claims(&with("\"constants\": { \"M, m, F_{(a)}, F_{(b)}\": \"> 0\", \"\\\\bar M\": \"> 0\" }")).is_ok()
        );
        assert!(refused(&with("\"constants\": { \"M,, m\": \"> 0\" }")).0.contains("missing"));
    }

    #[test]
    fn keys() {
        let (error, at) = refused(&with("\"constnats\": {}"));
        assert!(error.contains("did you mean \"constants\"?"), "{error}");
        assert_eq!(at, "\"constnats\"");
        assert!(
            refused(&with("\"equations\": { \"6.1\": { \"asume\": \"x\" } }")).0.contains("did you mean \"assume\"?")
        );
        assert!(
            refused(&with("\"sentences\": [{ \"quote\": \"x\", \"signs\": \"y\" }]"))
                .0
                .contains("did you mean \"sign\"?")
        );
        for rest in [
            "\"laws\": {}",
            "\"covers\": \"6\"",
            "\"unsure\": {}",
            "\"equations\": { \"6.1\": { \"small\": \"x\" } }",
            "\"units\": {}",
            "\"varies with time\": { \"x\": \"fixed direction\" }",
            "\"sentences\": [{ \"quote\": \"x\", \"minimum of\": \"y\" }]",
        ] {
            assert!(refused(&with(rest)).0.contains("not supported yet"), "{rest}");
        }
        assert!(refused("{ \"equations\": {} }").0.contains("needs \"notes\""));
        assert!(refused("[]").0.contains("is an object, not a list"));
    }

    #[test]
    fn types() {
        for (rest, word) in [
            ("\"assume\": 1", "a string or a list of strings, not a number"),
            ("\"system\": []", "a name or an object"),
            ("\"constants\": { \"M\": 1 }", "a string, not a number"),
            ("\"equations\": []", "an object, not a list"),
            ("\"equations\": { \"6.1\": true }", "an object, not true or false"),
            ("\"sentences\": {}", "a list, not an object"),
            ("\"equations\": { \"6.1\": { \"conserved\": 1 } }", "true or LaTeX"),
            ("\"equations\": { \"6.1\": { \"conserved\": false } }", "only be true"),
            ("\"equations\": { \"6.1\": { \"up to a constant\": \"c\" } }", "is true, not a string"),
            ("\"equations\": { \"6.1\": { \"assume\": [] } }", "empty list"),
            ("\"equations\": { \"6.1\": { \"skip\": \"\" } }", "empty"),
            ("\"sentences\": [{ \"quote\": \"x\", \"of\": \"U\", \"minima\": 1.5 }]", "whole number"),
            ("\"sentences\": [{ \"quote\": \"x\", \"of\": \"U\", \"minima\": 1e400 }]", "whole number"),
        ] {
            assert!(refused(&with(rest)).0.contains(word), "{}", refused(&with(rest)).0);
        }
    }

    #[test]
    fn keys_that_need_each_other() {
        let equation = |claim: &str| refused(&with(&format!("\"equations\": {{ \"6.1\": {{ {claim} }} }}"))).0;
        assert!(equation("\"solves\": \"6.2\"").contains("needs \"for\""));
        assert!(equation("\"for\": \"x\"").contains("needs \"solves\""));
        assert!(equation("\"expect\": \"refuted\"").contains("needs \"because\""));
        assert!(equation("\"because\": \"x\"").contains("needs \"expect\""));
        assert!(equation("\"expect\": \"verified\", \"because\": \"x\"").contains("is a pass"));
        assert!(equation("\"expect\": \"refutd\", \"because\": \"x\"").contains("did you mean \"refuted\"?"));
        assert!(equation("\"holds\": \"on-shell\"").contains("did you mean \"on shell\"?"));
        assert!(equation("\"erratum\": { \"for\": \"x\" }").contains("needs \"read\""));
        assert!(equation("\"erratum\": { \"for\": \"x\", \"read\": \"y\", \"times\": 0 }").contains("at least 1"));
        assert!(equation("\"limit\": \"x = 0\"").contains("no limit"));
        let sentence = |rest: &str| refused(&with(&format!("\"sentences\": [{{ {rest} }}]"))).0;
        assert!(sentence("\"claim\": \"x\"").contains("needs \"quote\""));
        assert!(sentence("\"quote\": \"q\", \"claim\": \"x\", \"not always\": \"x\"").contains("one test"));
        assert!(sentence("\"quote\": \"q\", \"minima\": 1").contains("needs \"of\""));
        assert!(sentence("\"quote\": \"q\", \"of\": \"U\"").contains("does not say"));
        assert!(
            sentence("\"quote\": \"q\", \"of\": \"U\", \"minima\": 1, \"sign\": \"positive\"").contains("one test")
        );
        assert!(sentence("\"quote\": \"q\", \"of\": \"6.1\", \"solutions\": 1").contains("needs \"for\""));
        assert!(sentence("\"quote\": \"q\", \"of\": \"U\", \"sign\": \"up\"").contains("cannot be"));
    }
}

mod addresses {
    use super::*;

    const NOTES: &str = "$$a = \\dot{z}\\,(2c) \\tag{6.72}$$\n\nx\n\n$$b = \\dot z \\tag{6.73}$$\n\nx\n\n$$c = 1 \\tag{6.78} \\label{eq:c}$$\n\n\
                         <!-- onshell: veff -->\n$$d = e$$\n\nx\n\n$$f \\tag{6.78b}$$\n\nx\n\n$$g$$\n\nx\n\n$$h \\label{dup}$$\n\nx\n\n$$i \\label{dup}$$\n";

    fn resolve(address: &str) -> Result<Vec<usize>> {
        let notes = parse(NOTES, Kind::Markdown)?;
        let address = serde_json::to_string(address).unwrap();
        let claims = claims(&with(&format!("\"equations\": {{ {address}: {{}} }}")))?;
        claims.equations[0].0.resolve(&notes, &claims.source)
    }

    #[test]
    fn found() {
        for (address, expected) in [
            ("6.72", vec![0]),
            ("(6.72)", vec![0]),
            ("eq:c", vec![2]),
            ("#veff", vec![3]),
            ("6.73 .. #veff", vec![1, 2, 3]),
            ("6.72..6.73", vec![0, 1]),
            ("6.78, 6.72", vec![2, 0]),
            ("`\\dot z (2 c)`", vec![0]),
            ("every `\\dot{z}`", vec![0, 1]),
            ("every `g`", vec![5]),
            ("6.72 row 2 part 1 step 3", vec![0]),
            ("`d = e` step 1", vec![3]),
            ("6.78b", vec![4]),
        ] {
            assert_eq!(resolve(address).unwrap(), expected, "{address}");
        }
    }

    #[test]
    fn rows_parts_and_steps() {
        let claims = claims(&with("\"equations\": { \"6.72 row 2 step 3\": {}, \"6.1, 6.2\": {} }")).unwrap();
        let point = claims.equations[0].0.single().unwrap();
        assert_eq!((point.row, point.part, point.step), (Some(2), None, Some(3)));
        assert!(claims.equations[1].0.single().is_none());
    }

    #[test]
    fn not_found() {
        for (address, word) in [
            ("6.79", "no equation (6.79) in notes (did you mean 6.78?)"),
            ("eq:d", "did you mean eq:c?"),
            ("#vef", "did you mean #veff?"),
            ("`\\dot y`", "no display in notes contains"),
            ("`\\dot z`", "2 displays match"),
            ("dup", "2 displays match"),
            ("6.73 .. 6.72", "ends before it begins"),
            ("every `\\dot z` .. 6.78", "one equation"),
        ] {
            let error = resolve(address).unwrap_err();
            assert!(error.to_string().contains(word), "{error}");
            assert!(error.place().is_some());
        }
    }

    #[test]
    fn malformed() {
        for address in [
            "",
            " ",
            "6.72 row",
            "6.72 row x",
            "6.72 row 0",
            "6.72 step 1 row 2",
            "`a",
            "``",
            "every",
            "every 6.72",
            "#",
            "6.1,",
            "6.1 .. 6.2 .. 6.3",
            "two words",
        ] {
            assert!(resolve(address).is_err(), "{address:?}");
        }
    }
}
