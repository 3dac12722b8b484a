//! The pages of `onshell report`: every equation of the report has its place, its MathML and its verdict in words; a page
//! loads nothing and runs nothing; text of the author cannot become markup.

use serde_json::Value;

use crate::support::Desk;

/// The pages that a command writes into `pages`, with their names.
fn pages(desk: &Desk, names: &[&str]) -> Vec<(String, String)> {
    names.iter().map(|name| ((*name).to_owned(), desk.read(&format!("pages/{name}")))).collect()
}

/// The opening tags of a page that are never closed, or closed in another order. HTML5 and MathML elements without
/// content are left out.
fn unbalanced(page: &str) -> Vec<String> {
    const VOID: [&str; 9] = ["meta", "link", "br", "hr", "img", "input", "!DOCTYPE", "mspace", "wbr"];
    let (mut open, mut wrong): (Vec<String>, Vec<String>) = (Vec::new(), Vec::new());
    let mut rest = page;
    while let Some(at) = rest.find('<') {
        rest = &rest[at + 1..];
        let Some(end) = rest.find('>') else { return vec!["a tag without an end".to_owned()] };
        let tag = &rest[..end];
        rest = &rest[end + 1..];
        let name = tag.trim_start_matches('/').split([' ', '/']).next().unwrap_or_default().to_owned();
        if tag.starts_with('/') {
            match open.pop() {
                Some(before) if before == name => {}
                before => wrong.push(format!("</{name}> after {before:?}")),
            }
        } else if !tag.ends_with('/') && !VOID.contains(&name.as_str()) {
            open.push(name.clone());
        }
        if name == "style" && !tag.starts_with('/') {
            rest = rest.split_once("</style>").map_or("", |(_, rest)| rest);
            open.pop();
        }
    }
    wrong.extend(open);
    wrong
}

#[test]
fn tags_that_are_not_closed_are_found() {
    assert_eq!(unbalanced("<p>a <b>c</b></p><br>"), Vec::<String>::new());
    assert!(!unbalanced("<p>a <b>c</p></b>").is_empty());
    assert!(!unbalanced("<p>").is_empty());
}

/// Whether every equation of a document is on the first page, typeset, and every erratum beside them.
fn is_in_the_gallery(index: &str, document: &Value) -> bool {
    let equations = document["equations"].as_array().expect("a list");
    equations.iter().all(|equation| {
        let places = index.matches(&format!("#eq-{}\"", equation["id"].as_str().expect("an id"))).count();
        places == if equation["verdict"] == "refuted" { 2 } else { 1 }
    })
}

#[test]
fn every_equation_of_the_derivations_is_on_its_page_with_its_verdict() {
    let desk = Desk::with_the_derivations("report-derivations");
    let run = desk.onshell(&["report", "derivations", "--out", "pages"]);
    assert_eq!((run.code, run.out.trim()), (0, "pages/index.html"), "{}", run.err);
    let report = desk.onshell(&["check", "derivations", "--format", "json"]);
    let report: Value = serde_json::from_str(&report.out).expect("JSON");
    let index = desk.read("pages/index.html");
    for document in report["documents"].as_array().expect("a list") {
        let path = document["path"].as_str().expect("a path");
        let name = path.trim_start_matches("derivations/").replace(".md", ".html");
        assert!(index.contains(&format!("href=\"{name}\"")), "{name}");
        assert!(is_in_the_gallery(&index, document), "{name}");
        let page = desk.read(&format!("pages/{name}"));
        assert!(page.len() < 1_000_000 && !page.contains("<script") && !page.contains("src="), "{name}");
        assert_eq!(unbalanced(&page), Vec::<String>::new(), "{name}");
        assert!(!page.contains("class=\"untypeset\""), "{name}");
        for equation in document["equations"].as_array().expect("a list") {
            let id = equation["id"].as_str().expect("an id");
            let place = page.find(&format!("id=\"eq-{id}\"")).unwrap_or_else(|| panic!("{id} is not in {name}"));
            let section = page[place..].split("</section>").next().unwrap_or_default();
            assert!(section.contains("<math"), "{id}");
            assert!(section.contains(equation["verdict"].as_str().expect("a word")), "{id}");
        }
        for link in page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            let known = ["index.html", "style.css", "#main"].contains(&link);
            let is_page = link.ends_with(".html") && desk.path(&format!("pages/{link}")).exists();
            assert!(known || is_page || page.contains(&format!("id=\"{}\"", link.trim_start_matches('#'))), "{link}");
        }
    }
    for (name, words) in [
        (
            "06-spinning-top.html",
            ["Steady precession: two rates", "The axis of the top", "All 31 lines", "printed and derived"],
        ),
        ("04-stability.html", ["energy ellipsoid", "unstable", "The derivation, step by step", "onshell-plot"]),
    ] {
        let page = desk.read(&format!("pages/{name}"));
        words.iter().for_each(|words| assert!(page.contains(words), "no {words} in {name}"));
    }
    for link in index.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        if let Some((page, anchor)) = link.split_once('#').filter(|(page, _)| !page.is_empty()) {
            assert!(desk.read(&format!("pages/{page}")).contains(&format!("id=\"{anchor}\"")), "{link}");
        }
    }
}

#[test]
fn a_wrong_equation_is_shown_with_its_correction_and_the_exit_code_is_that_of_check() {
    let desk = Desk::new("report-wrong");
    desk.write("notes.md", "# A title\n\nFor $a > 0$ it is said:\n\n$$ (a+b)^2 = a^2 + b^2 $$\n");
    let run = desk.onshell(&["report", "notes.md", "--out", "pages"]);
    assert_eq!(run.code, 1, "{}", run.err);
    let page = desk.read("pages/notes.html");
    for words in [
        "<h1>A title</h1>",
        "id=\"eq-L5\"",
        "refuted",
        "A counterexample",
        "With this edit",
        "<mark>",
        "class=\"correction\"",
    ] {
        assert!(page.contains(words), "no {words} in {page}");
    }
    let single = desk.onshell(&["report", "notes.md", "--out", "one", "--single"]);
    assert_eq!(single.code, 1);
    let whole = desk.read("one/index.html");
    assert!(whole.contains("<style>") && whole.contains("eq-L5") && !whole.contains("style.css"));
}

#[test]
fn text_of_the_author_is_no_markup() {
    let desk = Desk::new("report-hostile");
    let hostile = "<script>alert(1)</script>\n\n& < > \" <img src=x onerror=y>\n\n[a](javascript:b) ![c](http://d)\n\n";
    desk.write("bad & name.md", format!("{hostile}$$ a < b \\text{{<b>x</b>}} $$\n\n$$ \\foo{{< \\tag{{<i>}} $$\n"));
    desk.write("bad name.tex", format!("{hostile}\\[ a = a \\]\n"));
    let run = desk.onshell(&["report", "bad & name.md", "bad name.tex", "--out", "pages"]);
    assert!(run.code <= 2, "{}", run.err);
    for (name, page) in pages(&desk, &["index.html", "bad---name.html", "bad-name.html"]) {
        assert_eq!(unbalanced(&page), Vec::<String>::new(), "{name}: {page}");
        for forbidden in ["<script", "<img", "<b>x", "<i>", "href=\"javascript", "src=\"http"] {
            assert!(!page.contains(forbidden), "{forbidden} in {name}");
        }
    }
}

#[test]
fn documents_of_the_same_name_have_pages_of_their_own_and_lost_pages_are_an_error() {
    let desk = Desk::new("report-names");
    for folder in ["a", "b"] {
        desk.write(&format!("{folder}/notes.md"), "$$ (a+b)^2 = a^2 + 2ab + b^2 $$\n");
    }
    desk.write("a/index.md", "$$ c = c + 0 $$\n");
    assert_eq!(desk.onshell(&["report", "a", "b", "--out", "pages"]).code, 0);
    let names = ["notes.html", "notes-2.html", "index-2.html"];
    assert!(pages(&desk, &names).iter().all(|(_, page)| page.contains("<math")));
    desk.write("taken", "a file, and no folder");
    let run = desk.onshell(&["report", "a", "--out", "taken"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("cannot write"), "{}", run.err);
}

#[test]
fn a_wrong_equation_of_motion_stands_beside_the_derived_one_term_by_term_and_as_curves() {
    let desk = Desk::new("report-beside");
    let notes = |sign: &str| {
        format!(
            "# A bead\n\nThe Lagrangian is\n\n$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\Omega^2 \\sin^2\\theta) + m g R \\cos\\theta \\tag{{1}} $$\n\n\
             $$ m R^2 \\ddot\\theta = m R^2 \\Omega^2 \\sin\\theta\\cos\\theta {sign} m g R \\sin\\theta \\tag{{2}} $$\n"
        )
    };
    desk.write("bead.md", notes("+"));
    assert_eq!(desk.onshell(&["report", "bead.md", "--out", "pages"]).code, 1);
    let page = desk.read("pages/bead.html");
    for words in
        ["printed with the other sign", "✓ the same", "Both sides against", "Turning points of the bead", "All 8 lines"]
    {
        assert!(page.contains(words), "no {words}");
    }
    assert_eq!(unbalanced(&page), Vec::<String>::new());
    // the twin: a right equation has its terms lined up, and no curves that part
    desk.write("bead.md", notes("-"));
    assert_eq!(desk.onshell(&["report", "bead.md", "--out", "pages"]).code, 0);
    let page = desk.read("pages/bead.html");
    assert!(
        page.contains("✓ the same")
            && !page.contains("printed with the other sign")
            && !page.contains("Both sides against")
    );
    let single = desk.onshell(&["report", "bead.md", "--out", "one", "--single"]);
    assert_eq!(single.code, 0);
    let whole = desk.read("one/index.html");
    assert!(whole.contains("onshell-plot") && whole.contains("#derivation.bead") && !whole.contains("style.css"));
}

#[test]
fn a_tex_document_without_claims_has_its_headings_lists_and_emphasis() {
    let desk = Desk::new("report-tex");
    desk.write(
        "notes.tex",
        "\\documentclass{article}\n\\begin{document}\n\\section{Squares}\nIt is \\emph{well known} that\n\\begin{itemize}\n\\item $a > 0$\n\\end{itemize}\n\
         \\begin{equation} (a+b)^2 = a^2 + 2ab + b^2 \\label{eq:s} \\end{equation}\nSee \\eqref{eq:s}.\n\\end{document}\n",
    );
    assert_eq!(desk.onshell(&["report", "notes.tex", "--out", "pages"]).code, 0);
    let page = desk.read("pages/notes.html");
    for words in ["<h2>Squares</h2>", "<em>well known</em>", "<li>", "<math", "(eq:s)"] {
        assert!(page.contains(words), "no {words} in {page}");
    }
    assert!(!page.contains("documentclass") && !page.contains("\\item"));
}

#[test]
fn headings_of_each_format_are_headings_and_what_only_programs_read_is_not_shown() {
    let desk = Desk::new("headings");
    let of = [
        (
            "a.adoc",
            "= Springs\n:stem: latexmath\n\n[[law]]\n== The law\n\nA = B here.\n\n[stem]\n++++\nF = k x\n++++\n",
        ),
        (
            "b.rst",
            ".. _top:\n\n=======\nSprings\n=======\n\nThe law\n-------\n\nA = B here.\n\n.. math::\n\n   F = k x\n",
        ),
        ("c.typ", "#set page(\n  width: 3cm,\n)\n= Springs\n== The law\n\nA = B here.\n\n$ F = k x $\n"),
        ("d.org", "* Springs\n** The law\n\nA = B here.\n\n\\[ F = k x \\]\n"),
        ("e.qmd", "---\ntitle: \"Springs\"\nstem: x\n---\n\n## The law\n\nA = B here.\n\n$$F = k x$$ {#eq-law}\n"),
    ];
    for (name, text) in of {
        desk.write(name, text);
        desk.onshell(&["report", name, "--out", "pages"]);
        let page = desk.read(&format!("pages/{}.html", &name[..1]));
        assert!(page.contains("<h1>Springs</h1>"), "{name}: {page}");
        assert!(page.contains("<h2>The law</h2>"), "{name}: {page}");
        assert!(page.contains("A = B here."), "{name}: {page}");
        let unwanted = ["stem:", "#set", "width:", "_top", "[law]", "{#eq", "----", "===", "title:"];
        assert_eq!(unwanted.into_iter().find(|word| page.contains(word)), None, "{name}: {page}");
    }
}

#[test]
fn what_is_not_read_has_no_mark_of_success() {
    let desk = Desk::new("no-success");
    desk.write("n.md", "$$ x + = 2 $$\n\n$$ y = z $$\n");
    desk.onshell(&["report", "n.md", "--out", "pages"]);
    let page = desk.read("pages/n.html");
    assert!(page.contains("? </span>unreadable"), "{page}");
    assert!(!page.contains("✓ </span>unreadable"), "{page}");
}

#[test]
fn each_statement_of_a_display_has_its_verdict_on_the_page() {
    let desk = Desk::new("report-statements");
    let notes = "# Gas\n\nThe gas:\n\n$$ p V = N k T \\implies p = \\frac{N k V}{T} \\tag{4} $$\n\nSquares:\n\n\
                 \\begin{align*}\n(a + b)^2 &= a^2 + 2 a b + b^2 \\\\\n(a - b)^2 &= a^2 + 2 a b + b^2\n\\end{align*}\n";
    desk.write("notes.md", notes);
    let run = desk.onshell(&["report", "notes.md", "--out", "out"]);
    assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    let page = desk.read("out/notes.html");
    assert!(unbalanced(&page).is_empty());
    for id in ["L5", "4", "L10", "L11"] {
        assert_eq!(page.matches(&format!("aria-label=\"Equation ({id})\"")).count(), 1, "{id}");
    }
    assert_eq!(page.matches("class=\"equation refuted").count(), 2);
}
