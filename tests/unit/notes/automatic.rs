//! The numbers that LaTeX prints by itself, and displays in environments of the author's own.

use super::*;

/// The automatic numbers of each display of a TeX document.
fn numbers(text: &str) -> Vec<Vec<String>> {
    parse(text, Kind::Tex).equations.iter().map(|display| display.automatic.clone()).collect()
}

fn parse(text: &str, kind: Kind) -> Notes {
    Notes::parse(Arc::new(Source::new("n.tex", text)), kind).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn displays_are_numbered_as_latex_numbers_them() {
    // Compared by hand with what pdflatex prints.
    for (text, wanted) in [
        (
            r"\begin{equation}a\end{equation} \[b\] \begin{equation*}c\end{equation*} \begin{equation}d\end{equation}",
            &["1", "", "", "2"][..],
        ),
        (r"\begin{align}a&=b\\c&=d\nonumber\\e&=f\end{align}\begin{gather}g\\h\notag\end{gather}", &["1,2", "3"]),
        (r"\begin{align}a&=b\label{x}\\c&=d\\&=e\\f&=g\label{y}\\h&=k\\l&=m\end{align}", &["1", "2,3,4", "5,6"]),
        (
            r"\begin{equation}a\tag{A}\end{equation}\begin{multline}a\\+b\end{multline}\begin{align*}a\\b\end{align*}",
            &["", "1", ""],
        ),
        (
            r"\begin{equation}\begin{split}a&=b\\&=c\end{split}\end{equation}\begin{eqnarray}a&=&b\\c&=&d\end{eqnarray}",
            &["1", "2,3"],
        ),
        (
            r"\begin{equation}a\end{equation}\begin{subequations}\begin{align}b\\c\end{align}\end{subequations}\begin{equation}d\end{equation}",
            &["1", "2a,2b", "3"],
        ),
        (
            r"\numberwithin{equation}{section}\section{A}\begin{equation}a\end{equation}\section*{B}\begin{equation}b\end{equation}\section{C}\begin{equation}c\end{equation}\appendix\section{D}\begin{equation}d\end{equation}",
            &["1.1", "1.2", "2.1", "A.1"],
        ),
        (
            r"\documentclass[11pt]{book}\chapter{A}\begin{equation}a\end{equation}\section{S}\begin{equation}b\end{equation}\chapter{B}\begin{equation}c\end{equation}",
            &["1.1", "1.2", "2.1"],
        ),
        (
            r"\setcounter{equation}{6}\begin{equation}a\end{equation}\addtocounter{equation}{-1}\begin{equation}b\end{equation}",
            &["7", "7"],
        ),
        (r"\renewcommand{\theequation}{S\arabic{equation}}\begin{equation}a\end{equation}", &["S1"]),
        (
            r"\renewcommand{\theequation}{\thesection.\alph{equation}}\section{A}\begin{equation}a\end{equation}\section{B}\begin{equation}a\end{equation}",
            &["1.a", "2.a"],
        ),
        // What the number depends on is not known.
        (r"\renewcommand{\theequation}{\mystyle}\begin{equation}a\end{equation}", &[""]),
        (r"\setcounter{equation}{\value{page}}\begin{equation}a\end{equation}", &[""]),
        ("% \\section{no}\n\\begin{verbatim}\\begin{equation}\\end{verbatim}\\begin{equation}a\\end{equation}", &["1"]),
    ] {
        let found: Vec<String> = numbers(text).iter().map(|numbers| numbers.join(",")).collect();
        assert_eq!(found, wanted, "{text}");
    }
}

#[test]
fn an_automatic_number_is_found_where_no_display_carries_it_and_is_no_id() {
    let text = "\\documentclass{article}\n\\begin{equation}a\\end{equation}\n\\begin{equation}b\\tag{1}\\end{equation}\n\
                \\begin{equation}c\\end{equation}\nFrom eq. (2) and eq. (7).";
    let notes = parse(text, Kind::Tex);
    assert_eq!((notes.find("1"), notes.find("2"), notes.find("3")), (vec![1], vec![2], vec![]));
    assert_eq!(notes.equations[2].id(), None);
    let dangling: Vec<&str> = notes.dangling_references().map(|reference| reference.number.as_str()).collect();
    assert_eq!(dangling, ["7"]);
    // A part of a document does not know the numbers of the whole.
    let part = parse(&text.replace("\\documentclass{article}", "").replace("\\tag{1}", ""), Kind::Tex);
    assert_eq!(part.dangling_references().count(), 0);
    // Markdown has no counter.
    assert_eq!(parse("\\begin{equation}a\\end{equation}", Kind::Markdown).find("1"), Vec::<usize>::new());
}

#[test]
fn displays_in_environments_of_the_authors_own_are_found() {
    let text = r"\newcommand{\be}{\begin{equation}}\newcommand{\ee}{\end{equation}}
\def\bea{\begin{eqnarray}}\def\eea{\end{eqnarray}}
\newcommand{\eqn}[1]{\begin{equation}#1\end{equation}}
\newenvironment{eq}{\begin{equation}}{\end{equation}}
\be a = b \ee
\bea c &=& d \label{x} \\ e &=& f \label{y} \eea
\eqn{g = {h} % a comment
}
\begin{eq} k = l \end{eq}
\begin{IEEEeqnarray}{rCl} m &=& n \\ o &=& p\end{IEEEeqnarray}
\begin{empheq}[box=\fbox]{align} q &= r\end{empheq}
\begin{numcases}{f=} 1 \\ 2 \end{numcases}
\be s = t \end{equation}";
    let notes = parse(text, Kind::Tex);
    let texts: Vec<&str> = notes.equations.iter().map(|display| display.text.trim()).collect();
    let wanted = [
        "a = b",
        "c &=& d",
        "e &=& f",
        "g = {h}",
        "k = l",
        "m &=& n \\\\ o &=& p",
        "q &= r",
        "\\begin{numcases}{f=} 1 \\\\ 2 \\end{numcases}",
        "s = t",
    ];
    assert_eq!(texts, wanted);
    let automatic: Vec<String> = notes.equations.iter().map(|display| display.automatic.join(",")).collect();
    assert_eq!(automatic[..6], ["1", "2", "3", "4", "5", "6,7"].map(str::to_owned));
    let open = Notes::parse(Arc::new(Source::new("n.tex", text.replace("s = t \\end{equation}", "s = t"))), Kind::Tex);
    assert!(open.is_err());
}

#[test]
fn rows_behind_numbered_rows_are_displays_on_their_own_lines() {
    let notes = parse(
        "\\begin{align}\na &= b \\tag{1} \\\\\nc &= d \\tag{2} \\\\\ne &= f \\\\\ng &= h\n\\end{align}",
        Kind::Tex,
    );
    let found: Vec<(usize, &str)> = notes.equations.iter().map(|display| (display.line, display.text.trim())).collect();
    assert_eq!(found, [(2, "a &= b"), (3, "c &= d"), (4, "e &= f \\\\\ng &= h")]);
}
